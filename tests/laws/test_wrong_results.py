"""Right lines that go on with a result which is refuted where it stands are not accused once more."""

import pytest

from symbalance.notes.checking import check

SYMBOLS = {
    "λ": "crank radius over rod length",
    "φ": "crank angle",
    "m": "reciprocating mass",
    "r": "crank radius",
}
ROOT = r"With $\lambda = 0.3$ we have $\cos\varphi = \frac{-1+\sqrt{1+8\lambda^2}}{4\lambda} = 0.2956$"
SHAFTS = (
    "$m = 0.42$ kg, $r = 43$ mm, $\\lambda = 0.294$. Each of the two shafts of the Lanchester balancer of"
    " the inline four turns at twice the speed of the crank and carries\n\n$$m_b r_b = \\lambda m r$$\n\n"
)


def last_verdict(page: str) -> tuple[str, str]:
    checked = check(page + "\n", SYMBOLS)
    verdict = max(checked.verdicts, key=lambda v: (v.line, v.span))
    return verdict.verdict, verdict.assumption


@pytest.mark.parametrize(
    "page",
    [
        ROOT + r", so $\varphi \approx 72.8°$.",
        ROOT.replace("$\\cos", "\n\n$$\\cos").replace("0.2956$", "0.2956$$")
        + "\n\nso $\\varphi = 72.8°$.",
        r"With $\lambda = 0.3$ we have $\tan\varphi = 1/\lambda = 3.53$, hence $\varphi = 74.2°$.",
    ],
)
def test_what_follows_from_a_wrong_result_names_it(page):
    word, assumption = last_verdict(page)
    assert (word, "which is refuted" in assumption) == ("conditional", True)


@pytest.mark.parametrize(
    "page",
    [
        ROOT + r", so $\varphi \approx 71.8°$.",
        r"With $\lambda = 0.3$ we have $\tan\varphi = 1/\lambda = 3.53$, hence $\varphi = 76.2°$.",
    ],
)
def test_what_neither_the_wrong_result_nor_the_right_one_gives_does_not_hold(page):
    word, _ = last_verdict(page)
    assert word not in ("holds", "conditional", "holds_to_order")


@pytest.mark.parametrize(("radius", "refuted"), [("0.043", 1), ("0.034", 2)])
def test_numbers_put_into_a_wrong_formula_are_wrong_only_if_they_are_others(radius, refuted):
    numbers = f"In numbers $m_b r_b = 0.294\\cdot 0.42\\cdot {radius} = 5.31\\cdot 10^{{-3}}$ kg m."
    page = SHAFTS + numbers + " With $r_b = 15$ mm we need $m_b = 5.31/15 = 0.354$ kg.\n"
    words = [verdict.verdict for verdict in check(page).verdicts]
    assert words.count("refuted") == refuted  # of other numbers their result is
