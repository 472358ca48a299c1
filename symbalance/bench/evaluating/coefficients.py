"""The coefficients as doubles, beside mpmath's hypergeometric function: how long, and how far off."""

from __future__ import annotations

from fractions import Fraction
from math import ulp

from symbalance.bench.judge import Number, mp
from symbalance.bench.timing import Measurement, best
from symbalance.kinematics.slider_crank import acceleration_floats

HIGHEST = 40
FASTER, MOST_OFF = 50, 4.0
RATIOS = {
    "1/4": Fraction(4),
    "0.9": Fraction(10, 9),
    "1 - 1e-6": 1 / (1 - Fraction(1, 10**6)),
    "1 - 1e-9": 1 / (1 - Fraction(1, 10**9)),
}


def coefficients(budget: float = 0.5) -> list[Measurement]:
    """Measure all A_n to order 40 at some rod ratios, and their worst error in ulp."""
    return [_at(rho, ratio, budget) for rho, ratio in RATIOS.items()]


def _at(rho: str, ratio: Fraction, budget: float) -> Measurement:
    taken = best(lambda: acceleration_floats(HIGHEST, ratio), budget=0.1)
    theirs = best(lambda: by_mpmath(ratio, 15), budget=budget)
    off = worst(acceleration_floats(HIGHEST, ratio), ratio)
    return Measurement(
        f"A_2 to A_{HIGHEST} at rho = {rho}",
        taken,
        "mpmath hyp2f1, 15 digits",
        theirs,
        f"at least {FASTER} times, and within {MOST_OFF:g} ulp (here {off:.2f} ulp)",
        theirs / taken >= FASTER and off <= MOST_OFF,
    )


def worst(values: dict[int, float], ratio: Fraction) -> float:
    """Return how many ulp the values of A_2, A_4, ... are off, at most."""
    with mp.workdps(60):
        true = by_mpmath(ratio, 40)
        return max(float(abs(values[n] - a) / ulp(float(abs(a)))) for n, a in true.items())


def by_mpmath(ratio: Fraction, digits: int) -> dict[int, Number]:
    """Return A_2 to A_40 from the closed form as it is written, each by itself.

    A_2k = (4 k^2/rho)(1 + k') C(1/2, k) q^k 2F1(-1/2, k - 1/2; k + 1; q^2), with q = (rho/(1 + k'))^2.
    """
    with mp.workdps(digits):
        rho, half, found = mp.mpf(ratio.denominator) / ratio.numerator, mp.mpf(0.5), {}
        for k in range(1, HIGHEST // 2 + 1):
            root = mp.sqrt((1 - rho) * (1 + rho))
            q = (rho / (1 + root)) ** 2
            lead = 4 * k * k / rho * (1 + root) * mp.binomial(half, k) * q**k
            found[2 * k] = lead * mp.hyp2f1(-half, k - half, k + 1, q * q)
        return found
