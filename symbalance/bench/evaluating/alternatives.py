"""The alternatives, by name: what a user writes without symbalance, or with its cancelled sum alone.

per-cylinder NumPy: exact kinematics, a vectorised line a step, one cylinder after the other. It is
written with care: squares by multiplication, no power function. The others get the surviving harmonics,
cancelled and exact, as doubles: `sympy.lambdify` (NumPy), a Numba loop that calls math.cos, and heyoka's
compiled function, one thread each.
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

from symbalance.bench.evaluating.candidates import Candidate, Floats
from symbalance.bench.evaluating.cases import Case, Harmonic

PER_CYLINDER, LAMBDIFY, NUMBA_COS, HEYOKA = "NumPy per cylinder", "lambdify", "Numba math.cos", "heyoka"
ALTERNATIVES = (PER_CYLINDER, LAMBDIFY, NUMBA_COS, HEYOKA)
NEEDS = {NUMBA_COS: "numba", HEYOKA: "heyoka"}


def present() -> tuple[str, ...]:
    """Return the alternatives that can run here."""
    return tuple(name for name in ALTERNATIVES if name not in NEEDS or find_spec(NEEDS[name]))


def lacking() -> tuple[str, ...]:
    """Return one line on each alternative that cannot run here."""
    missing = [(name, NEEDS[name]) for name in ALTERNATIVES if name not in present()]
    return tuple(f"{name}: {part} is not installed (pip install {part})" for name, part in missing)


def alternative(case: Case, name: str) -> Candidate:
    """Return an alternative for a case, compiled."""
    if name == PER_CYLINDER:
        return Candidate(name, per_cylinder(case))
    make = {LAMBDIFY: lambdified, NUMBA_COS: in_numba, HEYOKA: in_heyoka}[name]
    return Candidate(name, make(case.harmonics)).warmed()


def per_cylinder(case: Case) -> Any:
    """Return the plain sum over the cylinders, every order at once.

    An inertia force is cos p + (lambda^2 cos 2p + sin^4 p)/(lambda^2 - sin^2 p)^(3/2), in m r omega^2.
    """
    square = float(case.known_ratio) ** 2
    rows = [(float(weight), float(lead)) for weight, lead in cylinders(case, np.cos, np.sin, np.pi)]

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


def cylinders(case: Case, cos: Any, sin: Any, pi: Any) -> list[tuple[Any, Any]]:
    """Return each cylinder's weight in the output, and by how much its crank leads, in radians."""
    kind, part = case.output.split(".")
    onto = {"vertical": cos, "lateral": sin}[part]
    plane = case.balance.reference
    plane = case.layout.mean_station if plane is None else plane
    found = []
    for cylinder in case.layout.cylinders:
        arm = cylinder.station - plane if kind == "couple" else cylinder.station**0
        bank, lead = cylinder.bank.turns, cylinder.throw.turns - cylinder.bank.turns
        weight = onto(2 * pi * bank.numerator / bank.denominator) * arm.numerator / arm.denominator
        found.append((weight, 2 * pi * lead.numerator / lead.denominator))
    return found


def lambdified(harmonics: Sequence[Harmonic]) -> Any:
    """Return SymPy's function of the cancelled sum, its coefficients floats."""
    theta = sympy.Symbol("theta", real=True)
    terms = [sympy.Float(h.amplitude) * sympy.cos(int(h.order) * theta - h.phase) for h in harmonics]
    function = sympy.lambdify(theta, sympy.Add(*terms), "numpy")
    return lambda theta, out: function(theta)


def in_numba(harmonics: Sequence[Harmonic]) -> Any:
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


def in_heyoka(harmonics: Sequence[Harmonic]) -> Any:
    """Return heyoka's compiled function, which has vector cosines."""
    heyoka = import_module("heyoka")
    heyoka.set_nthreads(1)
    theta = heyoka.make_vars("theta")
    terms = [
        h.amplitude * heyoka.cos(h.order * theta - h.phase if h.phase else h.order * theta)
        for h in harmonics
    ]
    compiled = heyoka.cfunc([heyoka.sum(terms)], vars=[theta])

    def function(theta: Floats, out: Floats) -> Floats:
        compiled(theta.reshape(1, -1), outputs=out.reshape(1, -1))
        return out

    return function
