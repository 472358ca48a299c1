"""A product that vanishes has a factor that does: an arrow to one of them needs the others not to."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def arrow_of(page: str) -> dict:
    links = check(page + "\n", fixes=False).data()["links"]
    return next(link for link in links if link["sign"] in ("⇒", "⇔"))


@pytest.mark.parametrize(
    "page",
    [
        "ab = 0 ⇒ a = 0",
        "xy = 0 ⇒ x = 0",
        r"$pq = 0 \Rightarrow r = 0$",
        "uv = 0 ⇔ u = 0",
    ],
)
def test_a_word_read_as_one_letter_proves_nothing_of_its_factors(page):
    assert arrow_of(page)["verdict"] not in PROVED


@pytest.mark.parametrize(
    ("page", "assumption"),
    [
        ("a b = 0 ⇒ a = 0", "b ≠ 0"),
        (r"$x y = 0 \Rightarrow y = 0$", "x ≠ 0"),
        (r"$F v = 0 \Rightarrow F = 0$ (v ≠ 0)", "v ≠ 0"),
    ],
)
def test_a_factor_vanishes_where_the_others_do_not(page, assumption):
    link = arrow_of(page)
    assert (link["verdict"], link["assumption"]) == ("conditional", assumption)


@pytest.mark.parametrize(
    "page",
    [r"$x^2 = 0 \Rightarrow x = 0$", r"$3 x = 0 \Rightarrow x = 0$", r"$x = 0 \Rightarrow x y = 0$"],
)
def test_what_follows_of_a_product_that_vanishes_is_confirmed(page):
    assert arrow_of(page)["verdict"] in PROVED


def test_one_factor_or_the_other_is_no_error():
    links = check("ab = 0 ⇒ a = 0 or b = 0\n", fixes=False).data()["links"]
    assert {link["verdict"] for link in links} == {"definition"}
