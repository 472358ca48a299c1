"""Competitors in `symbalance bench accuracy`: per-cylinder NumPy, lambdify, Numba and heyoka.

NumPy per cylinder: exact kinematics, a vectorised line a step, one cylinder after the other. It is
written with care: squares by multiplication, no power function. The others start from the surviving
harmonics, cancelled and exact, as doubles: `sympy.lambdify` (NumPy), a Numba loop that calls math.cos for
each, and heyoka's compiled function, with a vectorised cosine for each harmonic or with one cosine and
one sine, raised by complex multiplication: the strongest we know. One thread each.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
import sympy

from symbalance.bench.evaluated_outputs import Candidate, EvaluatedOutput, Floats, Harmonic
from symbalance.bench.true_values import weights

PER_CYLINDER, LAMBDIFY, HEYOKA = "NumPy per cylinder", "lambdify", "heyoka"
NUMBA_COS, HEYOKA_POWERS = "Numba math.cos", "heyoka powers"
ALTERNATIVES = (PER_CYLINDER, LAMBDIFY, NUMBA_COS, HEYOKA, HEYOKA_POWERS)
NEEDS = {NUMBA_COS: "numba", HEYOKA: "heyoka", HEYOKA_POWERS: "heyoka"}


def present() -> tuple[str, ...]:
    """Return the alternatives that can run here."""
    return tuple(name for name in ALTERNATIVES if name not in NEEDS or find_spec(NEEDS[name]))


def lacking() -> tuple[str, ...]:
    """Return one line on each alternative that cannot run here."""
    missing = [(name, NEEDS[name]) for name in ALTERNATIVES if name not in present()]
    return tuple(f"{name}: {part} is not installed (pip install {part})" for name, part in missing)


def alternative(case: EvaluatedOutput, name: str) -> Candidate:
    """Return an alternative for a case, compiled."""
    if name == PER_CYLINDER:
        return Candidate(name, per_cylinder(case))
    build = {
        LAMBDIFY: from_lambdify,
        NUMBA_COS: from_numba,
        HEYOKA: from_heyoka,
        HEYOKA_POWERS: powers_from_heyoka,
    }[name]
    return Candidate(name, build(case.harmonics)).warmed()


def per_cylinder(case: EvaluatedOutput) -> Any:
    """Return the plain sum over the cylinders, every order at once.

    An inertia force is cos p + (lambda^2 cos 2p + sin^4 p)/(lambda^2 - sin^2 p)^(3/2), in m r omega^2.
    """
    square = float(case.rod_ratio) ** 2
    rows = [(float(w), 2 * np.pi * float(turns)) for w, turns in weights(case.preset_engine, case.output)]

    def function(theta: Floats, _: Floats | None = None) -> Floats:
        total = np.zeros_like(theta)
        for weight, lead in rows:
            p = theta + lead
            sine, cosine = np.sin(p), np.cos(p)
            s2 = sine * sine
            d = square - s2
            total += weight * (cosine + (square * (1 - 2 * s2) + s2 * s2) / (d * np.sqrt(d)))
        return total

    return function


def from_lambdify(harmonics: Sequence[Harmonic]) -> Any:
    """Return SymPy's function of the cancelled sum, its coefficients floats."""
    theta = sympy.Symbol("theta", real=True)
    terms = [sympy.Float(h.amplitude) * sympy.cos(int(h.order) * theta - h.phase) for h in harmonics]
    function = sympy.lambdify(theta, sympy.Add(*terms), "numpy")
    return lambda theta, out: function(theta)


def from_numba(harmonics: Sequence[Harmonic]) -> Any:
    """Return a compiled loop over the angles, and in it one over the harmonics."""
    table = np.array([(h.order, h.amplitude, h.phase) for h in harmonics]).reshape(-1, 3).T.copy()
    loop = _loop()

    def function(theta: Floats, out: Floats) -> Floats:
        loop(theta, table[0], table[1], table[2], out)
        return out

    return function


@cache
def _loop() -> Any:
    def loop(theta, orders, amplitudes, phases, out):
        for i in range(theta.size):
            total = 0.0
            for k in range(orders.size):
                total += amplitudes[k] * math.cos(orders[k] * theta[i] - phases[k])
            out[i] = total

    return import_module("numba").njit(loop)


def from_heyoka(harmonics: Sequence[Harmonic]) -> Any:
    """Return heyoka's compiled function, one vectorised cosine for each harmonic."""
    heyoka = import_module("heyoka")
    theta = heyoka.make_vars("theta")
    terms = [
        h.amplitude * heyoka.cos(h.order * theta - h.phase if h.phase else h.order * theta)
        for h in harmonics
    ]
    return _heyoka_function(theta, terms)


def powers_from_heyoka(harmonics: Sequence[Harmonic]) -> Any:
    """Return heyoka's compiled function of one cosine and one sine, raised by complex multiplication."""
    heyoka = import_module("heyoka")
    theta = heyoka.make_vars("theta")
    circles = {1: (heyoka.cos(theta), heyoka.sin(theta))}

    def circle(n: int) -> tuple[Any, Any]:
        if n not in circles:  # by halves: as few roundings, and as shallow a formula, as there can be
            (a, b), (c, d) = circle(n // 2), circle(n - n // 2)
            circles[n] = a * c - b * d, b * c + a * d
        return circles[n]

    terms = []
    for h in harmonics:
        cosine, sine = circle(int(h.order))
        terms.append(h.amplitude * math.cos(h.phase) * cosine)
        if h.phase:
            terms.append(h.amplitude * math.sin(h.phase) * sine)
    return _heyoka_function(theta, terms)


def _heyoka_function(theta: Any, terms: list[Any]) -> Any:
    heyoka = import_module("heyoka")
    heyoka.set_nthreads(1)
    compiled = heyoka.cfunc([heyoka.sum(terms)], vars=[theta])

    def function(theta: Floats, out: Floats) -> Floats:
        compiled(theta.reshape(1, -1), outputs=out.reshape(1, -1))
        return out

    return function
