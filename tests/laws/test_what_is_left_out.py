"""A root that words leave out, besides ω = 0, is no value for the lines below."""

import pytest

from symbalance.notes.checking import check

SHAPE = (
    "\n\n$$A_2 = \\left(1 - \\frac{J\\omega^2}{k}\\right)A_1$$\n\nFor the mode it is $A_2/A_1 = 0.267$.\n"
)
OPENING = "The disc has $J = 2.4$ and $k = 750000$. "


def words(page: str) -> list[str]:
    return [verdict.verdict for verdict in check(page).verdicts]


@pytest.mark.parametrize(
    "left_out",
    [
        "The determinant gives, besides $\\omega = 0$, two roots.",
        "The determinant gives,\nbesides the trivial root $\\omega = 0$, two more.",
        "Apart from the rigid body mode $\\omega = 0$ there are two.",
        "Neben der Lösung $\\omega = 0$ bleiben zwei.",
        "En dehors de $\\omega = 0$ il y en a deux.",
        "À part la racine $\\omega = 0$ il y en a deux.",
        "Aparte de $\\omega = 0$ hay dos.",
        "$\\omega = 0$ 以外に二つある。",
    ],
)
def test_a_root_left_out_makes_no_line_below_wrong(left_out):
    assert not {"refuted", "contradiction"} & {*words(OPENING + left_out + SHAPE)}


def test_nor_in_the_delimiters_of_asciidoc(tmp_path):
    page = tmp_path / "memo.adoc"
    shape = SHAPE.replace("$$A", "[stem]\n++++\nA").replace("A_1$$", "A_1\n++++")
    text = ":stem: latexmath\n\n" + OPENING + "It gives, besides stem:[\\omega = 0], two roots." + shape
    page.write_text(text.replace("$A_2/A_1 = 0.267$", "stem:[A_2/A_1 = 0.267]"), encoding="utf-8")
    assert "refuted" not in [verdict.verdict for verdict in check(page).verdicts]


def test_a_value_that_is_given_counts_below():
    assert words(OPENING + "At rest it is $\\omega = 0$." + SHAPE)[-1] == "refuted"


@pytest.mark.parametrize(("sign", "word"), [("+", "undecided"), ("-", "condition")])
def test_a_number_that_only_a_formula_above_forbids_is_open(sign, word):
    page = OPENING + SHAPE.replace("1 -", f"1 {sign}")
    assert words(page)[-1] == word
