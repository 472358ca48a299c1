"""Errors of coefficients and functions at extreme rod ratios, ρ = r/l towards 0 and towards 1."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import numpy as np

from symbalance.bench.bounded_cases import ULP, WRONG, BoundedCase, Part, attempt, worst, worst_point
from symbalance.bench.hard_angles import hard, quarters
from symbalance.bench.output_requests import OutputRequest
from symbalance.bench.timing import progress
from symbalance.bench.true_values import Points, mp, true_coefficients
from symbalance.engine.catalogue import load
from symbalance.errors import SymbalanceError
from symbalance.kinematics.slider_crank import acceleration_floats

COEFFICIENT = 0.51
"""The bound that `acceleration_floats` states, in ulp."""
SUBNORMAL = 2.0**-1022
TOWARDS_0 = (Fraction(10**3), Fraction(10**8), Fraction(10**12))
TOWARDS_1 = (Fraction(21, 20), Fraction(1001, 1000), 1 + Fraction(1, 10**6), 1 + Fraction(1, 10**9))
SERIES_TERMS, SAMPLES = 60, 4096
ENGINES = ("inline-1", "inline-4", "v12-60", "radial-7")
QUICK = ((Fraction(10**3), 12), (Fraction(1001, 1000), 100), (1 + Fraction(1, 10**6), 12))
ORDERS = (12, 24, 100, 1000)
LARGEST = Fraction(10**9)
"""The largest rod ratio a function takes."""
COEFFICIENT_INTRODUCTION = """\
Every A_n to order 1000 that is no subnormal number, from `acceleration_floats`. naive: the power series
in ρ to 60 terms, the recurrence upward in doubles, an FFT of 4096 samples of the textbook formula; inf
where one fails."""
FUNCTION_INTRODUCTION = """\
In u of the amplitude; the bound is what the function itself states (`rounding`, and `left_out` where
there is a tolerance). The row is the worst of the vertical forces of inline-1, inline-4, v12-60 and
radial-7, with angles within some widths of the peaks that ρ → 1 brings. naive: cos(nθ), nθ rounded; the
sum over the cylinders."""


def coefficient_part(quick: bool) -> Part:
    """Return the cases of the coefficients."""
    order = 200 if quick else 1000
    ratios = [*TOWARDS_0, Fraction(7, 2), *TOWARDS_1]
    return Part(
        "Coefficients, ρ → 0 and ρ → 1",
        COEFFICIENT_INTRODUCTION,
        [coefficient_case(r, order) for r in ratios],
    )


def coefficient_case(ratio: Fraction, order: int) -> BoundedCase:
    """Return how far off the coefficients are at a rod ratio, at the worst order."""
    name = f"A_2 ... A_{order} at {near_one(ratio)}"
    progress(name)
    true = {n: a for n, a in true_coefficients(order, ratio).items() if n > 1 and abs(a) >= SUBNORMAL}

    def make() -> BoundedCase:
        off = off_by(acceleration_floats(order, ratio), true)
        naive = {way: off_by(function(ratio, order), true) for way, function in NAIVE.items()}
        return worst_point(name, np.array(list(true)), off, COEFFICIENT, ULP, naive, "order ")

    return attempt(name, COEFFICIENT, ULP, make)


def off_by(values: Mapping[int, float], true: Mapping[int, Any]) -> Any:
    """Return by how many of its ulp each coefficient is off."""
    with mp.workdps(60):
        return np.array(
            [
                float(abs(values[n] - a) / np.spacing(abs(float(a))))
                if np.isfinite(values[n])
                else np.inf
                for n, a in true.items()
            ]
        )


def near_one(ratio: Fraction) -> str:
    """Return a rod ratio as text that tells it from 1.

    >>> near_one(1 + Fraction(1, 10**9)), near_one(Fraction(1000))
    ('λ = 1 + 1e-09', 'λ = 1000')
    """
    return f"λ = 1 + {float(ratio - 1):g}" if ratio < 1.5 else f"λ = {float(ratio):g}"


def by_series(ratio: Fraction, order: int) -> dict[int, float]:
    """Return A_n from its power series, each term from the one before, in doubles."""
    rho, values = 1 / float(ratio), {}
    with np.errstate(all="ignore"):
        for k in range(1, order // 2 + 1):
            term = np.float64((-1.0) ** (k + 1) * 4 * k * k) * _start(k) * np.float64(rho) ** (2 * k - 1)
            total = np.float64(0)
            for m in range(k, k + SERIES_TERMS):
                total += term
                term *= rho * rho * (4 * m * m - 1) / (4 * ((m + 1) ** 2 - k * k))
            values[2 * k] = float(total)
    return values


def _start(k: int) -> float:
    """Return 4 Catalan(k - 1)/16^k."""
    value = 0.25
    for m in range(1, k):
        value *= (4 * m - 2) / (m + 1) / 16
    return value


def by_recurrence(ratio: Fraction, order: int) -> dict[int, float]:
    """Return A_n from the three-term recurrence run upward, in doubles."""
    rho = 1 / float(ratio)
    q = (rho / (1 + np.sqrt((1 - rho) * (1 + rho)))) ** 2
    first = true_coefficients(4, ratio)
    values = {2: float(first[2]), 4: float(first[4])}
    below, here = values[2], values[4] / 4
    with np.errstate(all="ignore"):
        for k in range(2, order // 2):
            above = np.float64(-((1 + q * q) * k * here + q * (k - 1.5) * below)) / (q * (k + 1.5))
            below, here = here, float(above)
            values[2 * k + 2] = (k + 1) ** 2 * here
    return values


def by_fft(ratio: Fraction, order: int) -> dict[int, float]:
    """Return A_n from samples of the acceleration as textbooks write it."""
    lam, angle = float(ratio), 2 * np.pi * np.arange(SAMPLES) / SAMPLES
    c, s = np.cos(angle), np.sin(angle)
    root = np.sqrt(lam * lam - s * s)
    spectrum = np.fft.rfft(c + (c * c - s * s) / root + (s * c) ** 2 / root**3).real * 2 / SAMPLES
    return {n: float(spectrum[n]) for n in range(2, order + 1, 2)}


NAIVE: Mapping[str, Callable[[Fraction, int], dict[int, float]]] = {
    "series": by_series,
    "upward": by_recurrence,
    "FFT": by_fft,
}


def function_part(quick: bool) -> Part:
    """Return the cases of the functions: by rod ratio and orders, the worst of the engines."""
    groups: dict[str, list[BoundedCase]] = {}
    for request in requests(quick):
        orders = f"orders to {request.order}" if request.tolerance is None else "all orders"
        cases = request.stated_cases(points_for(request, quick), f"{request.engine.name}: ")
        groups.setdefault(f"{near_one(request.ratio)}, {orders}", []).extend(cases)
    cases = [worst(rows, name) for name, rows in groups.items()]
    return Part("Functions, ρ → 0 and ρ → 1", FUNCTION_INTRODUCTION, [*cases, refusal()])


def requests(quick: bool) -> list[OutputRequest]:
    """Return the vertical force of some engines at many rod ratios, to several orders and all."""
    if quick:
        some = [OutputRequest(load("inline-4"), "force.vertical", r, n) for r, n in QUICK]
        return [*some, OutputRequest(load("inline-1"), "force.vertical", QUICK[1][0], 12, 0.0)]
    ratios = [*TOWARDS_0[:2], LARGEST, *TOWARDS_1]
    return [
        OutputRequest(load(engine), "force.vertical", ratio, order, tolerance)
        for ratio in ratios
        for engine in ENGINES
        for order, tolerance in [(12, 0.0), *((n, None) for n in ORDERS)]
        if engine != "radial-7" or order <= 100
    ]


def points_for(request: OutputRequest, quick: bool) -> Points:
    """Return hard angles and, near rho = 1, angles within some widths of the peaks."""
    count = (30 if quick else 400) if request.order == 1000 or quick else 1500
    width = float(request.ratio * request.ratio - 1) ** 0.5
    leads = sorted({c.delay.turns % Fraction(1, 2) for c in request.engine.cylinders})
    peaks = [
        quarters(min(spread * width, 1.0), count // (12 * len(leads)) + 1, float(turns))
        for spread in (0.3, 3.0)
        for turns in leads
    ]
    return Points(np.concatenate([hard(count), *peaks]))


def refusal() -> BoundedCase:
    """Return whether a function refuses a rod ratio beyond the largest, as its documentation says."""
    name = f"λ = 1e12 is refused, above {float(LARGEST):g}"
    request = OutputRequest(load("inline-4"), "force.vertical", TOWARDS_0[2])

    def make() -> BoundedCase:
        try:
            request.evaluator  # noqa: B018
        except SymbalanceError as error:
            return BoundedCase(name, str(error)[:36], 0.0, 0.0, WRONG)
        return BoundedCase(name, "accepted", 1.0, 0.0, WRONG)

    return attempt(name, 0.0, WRONG, make)
