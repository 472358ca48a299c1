"""A counterweight is m r/r_b: its own radius stands below, and that of the crank pin above."""

import pytest

import symbalance as sb

DECLARED = {
    "en": ("mass of the counterweight [kg]", "radius of the counterweight [m]", "crank radius [m]"),
    "de": ("Masse des Gegengewichts [kg]", "Radius des Gegengewichts [m]", "Kurbelradius [m]"),
    "ja": ("釣り合いおもりの質量 [kg]", "釣り合いおもりの半径 [m]", "クランク半径 [m]"),
}
SAID = {
    "en": "The mass of the counterweight is ",
    "de": "Die Masse des Gegengewichts ist ",
    "ja": "釣り合いおもりの質量は",
}
PLACED = "A counterweight $m_b$ at the radius $r_b$ balances a mass $m$ at the radius $r$. It is\n\n"
PROVED = ("holds", "conditional", "definition")


def _last(page, symbols=None):
    data = sb.check(page, {"symbols": symbols} if symbols else {}).data()
    return data["links"][-1]["verdict"]


@pytest.mark.parametrize("language", DECLARED)
@pytest.mark.parametrize("arm", ["r_b", "b"])
def test_declared_radii_have_their_places(language, arm):
    mass, own, crank = DECLARED[language]
    symbols = {"m_b": mass, arm: own, "r": crank, "m": "mass [kg]"}
    formula = r"$$m_b = \frac{m ABOVE}{BELOW}$$"
    right = formula.replace("ABOVE", "r").replace("BELOW", arm)
    wrong = formula.replace("ABOVE", arm).replace("BELOW", "r")
    assert _last(f"{SAID[language]}\n\n{right}\n", symbols) in PROVED
    assert _last(f"{SAID[language]}\n\n{wrong}\n", symbols) == "refuted"


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [(r"\frac{m r}{r_b}", "conditional"), (r"\frac{m r_b}{r}", "refuted"), (r"m r_b r", "refuted")],
)
def test_the_radius_with_the_index_of_the_weight_is_its_own(formula, verdict):
    assert _last(f"{PLACED}the counterweight\n\n$$m_b = {formula}$$\n") == verdict


@pytest.mark.parametrize(
    ("formula", "is_right"), [(r"\frac{m r}{r_b}", True), (r"\frac{m r_b}{r}", False)]
)
def test_what_follows_from_a_balance_is_solved_rightly(formula, is_right):
    mass, own, crank = DECLARED["ja"]
    symbols = {"m_b": mass, "r_b": own, "r": crank, "m": "往復質量 [kg]"}
    page = (
        "釣り合うためには\n\n$$m_b r_b\\omega^2 = m r\\omega^2, \\qquad m_b r_b = m r$$\n\n"
        f"でなければならない。よって,おもりの質量は\n\n$$m_b = {formula}$$\n"
    )
    assert (_last(page, symbols) in PROVED) is is_right
    assert (_last(page, symbols) == "refuted") is not is_right
