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


CARRIED = {
    "a sum of masses": (
        "Piston, pin and rings: $m_P = 410 + 95 + 30 = 545$ g. With $m_1 = 0.160$ kg the whole is"
        "\n\n$m_P + m_1 = {}$ kg",
        "0.705",
        "0.715",
    ),
    "a round number": (
        "$m = 0,5$ kg, $r = 0,04$ m, $\\lambda = 0,25$: $F = m r \\cdot 400^2 = 3400$ N, also"
        "\n\n$\\lambda F = {}$ N",
        "850",
        "890",
    ),
    "a formula": (
        "Moment of inertia of the solid disc: $J = m R^2$\n\nKinetic energy of the disc\n\n"
        "$T = J w^2/2 = {}$",
        "m R^2 w^2/2",
        "m R^2 w^2/3",
    ),
    "a derivative": (
        "$x = r(1 - \\cos φ) + \\frac{{λ r}}{{4}}(1 - \\cos 2φ)$ is the displacement, φ = ωt.\n\n"
        "Differentiated: $\\dot x = r ω (\\sin φ + λ \\sin 2φ)$\n\n"
        "$\\ddot x = r ω^2 (\\cos φ + {} λ \\cos 2φ)$",
        "2",
        "3",
    ),
}


@pytest.mark.parametrize("kind", CARRIED)
@pytest.mark.parametrize("is_carried", [True, False])
def test_what_is_computed_from_a_refuted_line_is_no_second_error(kind, is_carried):
    page, carried, other = CARRIED[kind]
    word, assumption = last_verdict(page.format(carried if is_carried else other))
    assert (word, "which is refuted" in assumption) == (
        ("conditional", True) if is_carried else ("refuted", False)
    )


def test_a_wrong_formula_once_more_is_wrong_once_more():
    page = "Moment of inertia of the solid disc: $J = m R^2$\n\nOnce more, $J = m R^2$ for this disc.\n"
    words = [verdict.verdict for verdict in check(page, SYMBOLS).verdicts]
    assert words[0] == "refuted"
    assert words[1] not in ("holds", "conditional")


@pytest.mark.parametrize(("secondary", "refuted"), [("240", 1), ("280", 2)])
def test_a_number_from_a_wrong_one_of_its_row_is_no_second_error(secondary, refuted):
    page = (
        "With $\\lambda = 0.3$ the amplitudes are $F_1 = m r ω^2$ and $F_2 = \\lambda F_1$.\n\n"
        "| n in rpm | primary | secondary |\n|---|---|---|\n| 1000 | $F_1 = 400$ N | $F_2 = 120$ N |\n"
        f"| 2000 | $F_1 = 800$ N | $F_2 = {secondary}$ N |\n"
        "| 3000 | $F_1 = 3600$ N | $F_2 = 1080$ N |\n| 4000 | $F_1 = 6400$ N | $F_2 = 1920$ N |\n"
    )
    words = [verdict.verdict for verdict in check(page, {}).verdicts]
    assert words.count("refuted") == refuted


SECTOR = "R1 = 25 mm, R2 = 70 mm, g = 60°, m_e = 1.2 kg, r = 40 mm.\n\n"
CENTROID = "    r_G = (2/3) * (R2^3 - R1^3)/(R2^2 - R1^2) * sin(g)/(2 g)\n    r_G = 42.2 mm\n\n"


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        ("m_c = m_e * r/r_G = 1.137 kg", ("conditional",)),
        ("m_c = m_e * r/r_G = 1.317 kg", ("refuted", "undecided")),
    ],
)
def test_a_number_that_is_at_odds_with_its_formula_may_be_put_in(claim, words):
    checked = check(f"{SECTOR}{CENTROID}    {claim}\n", {})
    assert checked.verdicts[-1].verdict in words
