"""A search as arrays: what a pin on a ray adds to every sum, in integers and in floats, and the bounds.

Integers decide what is zero and what is equal. Floats decide only where they are certain: a sum of at
most 24 cylinders, each term rounded once, is off by less than `SLACK` times the sum of its weights (24
additions of numbers below that sum, 2^-53 of it each, are 3 10^-15 of it), so a value that differs from
a limit by more than `SLACK` does so for certain, and one that does not goes to the exact core.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import lcm

import numpy as np

from symbalance.errors import SymbalanceError
from symbalance.search.integer_ring import Array, IntegerRing
from symbalance.search.objectives import Condition, Form, Objective
from symbalance.search.problem import SearchProblem, Symmetry

SLACK = 1e-10
"""Of the sum of a form's weights: nearer than that no float decides."""
FREE, AT_MOST, EXACTLY = 0, 1, 2
"""What is asked of an objective."""
LARGEST_DEGREE = 400
"""Integers of one number."""


@dataclass(frozen=True)
class Tables:
    """The arrays that a walk over stars reads; pins and rays as in the problem."""

    ring: IntegerRing
    pins: int
    rays: int
    ticks: int
    order: Array
    """The pins in the order in which they are placed."""
    takes: Array
    """[pin, ray, cylinder]: ticks, -1 where a pin may not stand."""
    floats: Array
    """[form, pin, ray]: what a pin adds to a sum, complex."""
    integers: Array
    """[form, pin, ray, :]: the same in units of `unit[form]`."""
    units: tuple[Fraction, ...]
    rest: Array
    """[form, depth]: the sum of the weights of the pins that are placed from that depth on."""
    reach: Array
    """[group, depth]: the square of a sum beyond which its limit is passed, whatever the rest."""
    slack: Array
    """[form]: how far a float may be off, at the most."""
    groups: Array
    """[group, 2]: the forms whose sizes add up, -1 for none."""
    owners: Array
    """[group]: which objective it is of."""
    asked: Array
    """[objective]: FREE, AT_MOST or EXACTLY."""
    limits: Array
    """[objective]: the limit, as a float."""
    minimized: Array
    """The objectives that are to be small; of the star alone."""
    sources: Array
    """[symmetry, pin]."""
    signs: Array
    shifts: Array
    mirror: Array
    """[symmetry]: whether it is a mirror image alone."""

    @property
    def forms(self) -> int:
        """How many sums there are."""
        return len(self.units)


def build_tables(
    problem: SearchProblem,
    objectives: tuple[Objective, ...],
    conditions: tuple[Condition, ...],
    minimized: tuple[int, ...],
    symmetries: tuple[Symmetry, ...],
) -> Tables:
    """Return the arrays of a problem and the objectives of its stars; `minimized` are places of them."""
    kept = symmetries
    forms = [form for o in objectives for group in o.groups for form in group]
    ring = IntegerRing(_modulus(problem, forms))
    if ring.modulus > 100_000 or ring.degree > LARGEST_DEGREE:
        rule = f"has angles in {ring.modulus}ths of a turn, which are too many to add up exactly"
        raise SymbalanceError(problem.words(), rule, "take angles of fewer digits")
    pins, rays = problem.pin_count, problem.rays
    floats = np.zeros((len(forms), pins, rays), np.complex128)
    integers = np.zeros((len(forms), pins, rays, ring.degree), np.int64)
    units, sizes = [], np.zeros((len(forms), pins))
    for f, form in enumerate(forms):
        unit = Fraction(1, lcm(*(weight.denominator for weight, _, _ in form.weights.values())))
        units.append(unit)
        for p, pin in enumerate(problem.seats):
            weights = (form.weights[s.number][0] for s in pin if s.number in form.weights)
            sizes[f, p] = float(sum(map(abs, weights)))
        for p, s, terms in _contributions(problem, form, unit):
            integers[f, p, s] = ring.vector(terms)
    if forms:
        scale = np.array([float(unit) for unit in units])
        floats[:] = (integers @ ring.cosines) * scale[:, None, None]
    groups, owners = _grouped(objectives)
    order = np.array(problem.order, np.int64)
    rest = np.zeros((len(forms), pins + 1))
    for depth in range(pins - 1, -1, -1):
        rest[:, depth] = rest[:, depth + 1] + sizes[:, order[depth]]
    takes = np.array(problem.takes, np.int64)
    takes[~np.array(problem.allowed)] = -1
    asked, limits = np.zeros(len(objectives), np.int64), np.zeros(len(objectives))
    for condition in conditions:
        place = next((i for i, o in enumerate(objectives) if o.name == condition.name), None)
        if place is not None:
            asked[place] = EXACTLY if condition.exactly else AT_MOST
            limits[place] = float(condition.limit)
    slack = SLACK * np.maximum(1.0, sizes.sum(1))
    firsts = groups[:, 0] if len(groups) else np.zeros(0, np.int64)
    reach = ((limits[owners] + slack[firsts])[:, None] + rest[firsts]) ** 2
    return Tables(
        ring,
        pins,
        rays,
        problem.ticks,
        order,
        takes,
        floats,
        integers,
        tuple(units),
        rest,
        reach,
        slack,
        groups,
        owners,
        asked,
        limits,
        np.array(minimized, np.int64),
        np.array([one.source for one in kept], np.int64).reshape(len(kept), pins),
        np.array([one.sign for one in kept], np.int64),
        np.array([one.shift for one in kept], np.int64).reshape(len(kept), pins),
        np.array([one.along == 1 for one in kept], np.bool_),
    )


def preserved_symmetries(problem: SearchProblem, objectives: Iterable[Objective]) -> tuple[Symmetry, ...]:
    """Return the symmetries that change none of the objectives: mode shapes know front from rear."""
    torsion = [o for o in objectives if o.kind == "torsion"]
    forms = [form for o in torsion for group in o.groups for form in group]

    def weights(form: Form, pin: int) -> list[Fraction]:
        return sorted(form.weights[seat.number][0] for seat in problem.seats[pin])

    return tuple(
        one
        for one in problem.symmetries
        if all(weights(f, q) == weights(f, p) for f in forms for q, p in enumerate(one.source))
    )


def _modulus(problem: SearchProblem, forms: list[Form]) -> int:
    modulus = 1
    throws = [problem.throws([s] * problem.pin_count) for s in range(problem.rays)]
    for form in forms:
        for number, (_, fixed, turn) in form.weights.items():
            for by_ray in throws:
                modulus = lcm(modulus, (fixed + turn * by_ray[number]).denominator)
                if modulus > 100_000:
                    return modulus
    return modulus


def _contributions(
    problem: SearchProblem, form: Form, unit: Fraction
) -> Iterator[tuple[int, int, dict[Fraction, int]]]:
    """Yield for each pin and ray the integers that stand at each angle, in turns."""
    for s in range(problem.rays):
        throws = problem.throws([s] * problem.pin_count)
        for p, pin in enumerate(problem.seats):
            terms: dict[Fraction, int] = {}
            for seat in (one for one in pin if one.number in form.weights):
                weight, fixed, turn = form.weights[seat.number]
                angle = (fixed + turn * throws[seat.number]) % 1
                terms[angle] = terms.get(angle, 0) + int(weight / unit)
            yield p, s, terms


def _grouped(objectives: tuple[Objective, ...]) -> tuple[Array, Array]:
    groups, owners, place = [], [], 0
    for number, objective in enumerate(objectives):
        for group in objective.groups:
            groups.append([place, place + 1 if len(group) > 1 else -1])
            owners.append(number)
            place += len(group)
    return np.array(groups, np.int64).reshape(len(groups), 2), np.array(owners, np.int64)
