"""Units that stand in brackets or are said once, and numbers whose comma or point is no list."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def last(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    ("said", "right", "wrong"),
    [
        ("With r = 40 (mm) and ω = 300 (rad/s), v = rω = {}.", "12 m/s", "12000 m/s"),
        ("$r = 40$ (mm) and $\\omega = 300$ (rad/s). $v = r\\omega = {}$ m/s.", "12", "12000"),
        ("m = 450 (g) and a = 2 (m/s²), so F = m a = {}", "0.9 N", "900 N"),
        ("F = 12 kN（力）とする。よって $F/2 = {}$ kN である。", "6", "8"),
        ("Die Masse ist $m = 1,5$ kg und $a = 2$ m/s², also $F = m a = {}$ N.", "3,0", "3,5"),
        ("$r = 4,5$ cm, also der Hub $s = 2r = {}$ cm", "9,0", "8"),
        ("La masse est $m = 2,5$ kg, donc $2m = {}$ kg.", "5", "6"),
        ("The mass is $m = 1,200$ kg, so $m/2 = {}$ kg.", "600", "0.6"),
        ("Die Drehzahl ist $n = 3.000$ min⁻¹, also $\\omega = 2\\pi n/60 = {}$ rad/s.", "314", "0.314"),
    ],
)
def test_a_unit_in_brackets_and_a_comma_before_a_dollar_are_read(said, right, wrong):
    assert last(said.format(right)) in PROVED
    assert last(said.format(wrong)) == "refuted"


@pytest.mark.parametrize("result", ["5000", "5"])
@pytest.mark.parametrize(
    "said",
    [
        "Data in mm and N: F = 100, r = 50. The torque is M = F r = {} Nm.",
        "All lengths are in mm. r = 50, F = 100 N. M = F r = {} Nm.",
        "Alle Längen in mm: r = 50. Mit F = 100 N ist M = F r = {} Nm.",
        "The radius in millimetres is r = 50, and F = 100 N, M = F r = {} Nm.",
    ],
)
def test_what_is_computed_with_a_unit_from_bare_numbers_is_open_where_words_give_them_one(said, result):
    assert last(said.format(result)) == "undecided"


@pytest.mark.parametrize(
    "page",
    [
        "Alle Längen in mm: r = 40, l = 160. Dann ist $r + l = 200$.",
        "All lengths are in mm. r = 40 mm, z = 6. z r = 240 mm.",
    ],
)
def test_bare_numbers_among_themselves_and_counts_are_judged_as_before(page):
    assert last(page) in PROVED


def test_a_list_of_orders_stays_a_list():
    assert last("The orders $n = 1,3$ and $5$ vanish.") == "range"
