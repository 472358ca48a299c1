"""A crank that turns twice as fast has no force twice as large: F_2 = m r/(4n) (2ω)² cos 2θ."""

import pytest

import symbalance as sb

FORCE = "The force is\n\n$$F_S = m r\\omega^2\\,\\frac{\\cos 2\\theta}{n}.$$\n\n"
WORDS = [
    "Think of an imaginary crank which turns twice as fast as the real one:",
    "Man denkt sich eine Kurbel, die doppelt so schnell läuft wie die wirkliche:",
    "This is the force of a crank at double the speed:",
    "クランクの2倍の回転数で回る仮想クランクを考えると",
]


def _last(page):
    return sb.check(page, {}).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("words", WORDS)
@pytest.mark.parametrize(("divisor", "verdict"), [("4n", "holds"), ("2n", "refuted"), ("n", "refuted")])
def test_the_force_of_a_crank_at_twice_the_speed_is_the_one_above(words, divisor, verdict):
    formula = f"$$F_S = m\\,\\frac{{r}}{{{divisor}}}\\,(2\\omega)^2\\cos 2\\theta$$"
    assert _last(f"{FORCE}{words}\n\n{formula}\n") == verdict


def test_two_pistons_have_twice_the_force_of_one():
    force = "The force is $F = m r\\omega^2\\cos\\theta$.\n\n"
    several = "Both pistons go up together, and it is $F = 2 m r\\omega^2\\cos\\theta$.\n"
    assert _last(force + several) not in ("refuted", "contradiction")
