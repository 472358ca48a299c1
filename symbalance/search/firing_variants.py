"""The firing orders of stars, many at once, and what depends on them: torsion, neighbours, evenness.

All stars of one pattern have their top dead centres at the same moments; sorted by them, the cylinders of
every star share the moments of a cycle out in the same ways, two for each moment at which two stand.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import lcm

import numpy as np

from symbalance.errors import SymbalanceError
from symbalance.search.integer_ring import Array, IntegerRing
from symbalance.search.objectives import Objective
from symbalance.search.problem import Pattern, SearchProblem

MOST_VARIANTS = 4096
"""Firing orders of one star: 13 cylinders of a four-stroke that may fire at any interval."""


@dataclass(frozen=True)
class FiringVariants:
    """The ways in which the cylinders of a star that fills a pattern may fire."""

    problem: SearchProblem
    pattern: Pattern

    @cached_property
    def ticks(self) -> int:
        """Moments of a turn that firings are told apart by."""
        return lcm(self.problem.ticks, *(lag.denominator for pin in self.problem.lags for lag in pin))

    @cached_property
    def _by_cylinder(self) -> tuple[Array, Array]:
        """The pin of each cylinder, by its number, and how many ticks after the pin's ray it stands."""
        places = {
            seat.number: (p, int(lag * self.ticks))
            for p, (pin, lags) in enumerate(zip(self.problem.seats, self.problem.lags, strict=True))
            for seat, lag in zip(pin, lags, strict=True)
        }
        ordered = [places[number] for number in sorted(places)]
        return np.array([p for p, _ in ordered]), np.array([lag for _, lag in ordered])

    def dead_centres(self, stars: Array) -> Array:
        """Return the tick at which each cylinder reaches top dead centre after cylinder 1."""
        pins, lags = self._by_cylinder
        return (stars[:, pins] * (self.ticks // self.problem.rays) + lags) % self.ticks

    def moments(self, stars: Array) -> Array:
        """Return [star, variant, cylinder]: the tick of the cycle at which each fires, the first at 0."""
        centres = self.dead_centres(stars)
        if self.problem.is_any:
            return centres[:, None, :] + self._free_turns[None]
        order = np.argsort(centres, axis=1, kind="stable")
        slots = self._slots
        moments = np.empty((len(stars), len(slots), centres.shape[1]), np.int64)
        np.put_along_axis(moments, np.repeat(order[:, None, :], len(slots), 1), slots[None], 2)
        return moments

    @property
    def count(self) -> int:
        """How many firing orders a star has."""
        return len(self._free_turns if self.problem.is_any else self._slots)

    @cached_property
    def _free_turns(self) -> Array:
        """Every choice of the turn in which each cylinder fires, cylinder 1 in the first."""
        others = self.problem.cylinders - 1
        if self.problem.cycle**others > MOST_VARIANTS:
            rule = f"has more than {MOST_VARIANTS} firing orders for each star"
            remedy = "take fewer cylinders, or ask for nothing that depends on the firing order"
            raise SymbalanceError(self.problem.words(), rule, remedy)
        turns = [(0, *rest) for rest in product(range(self.problem.cycle), repeat=others)]
        return np.array(turns, np.int64) * self.ticks

    @cached_property
    def _slots(self) -> Array:
        """For cylinders sorted by their dead centres: the moments they take, in every way."""
        scale = self.ticks // self.problem.ticks
        rows: dict[tuple[int, ...], None] = {}
        for firings in self.pattern.firings:
            groups: dict[int, list[int]] = {}
            for moment in firings:
                groups.setdefault(moment * scale % self.ticks, []).append(moment * scale)
            choices = []
            for tick in sorted(groups):
                slots = sorted(groups[tick])
                if len(slots) > 2:
                    raise AssertionError("three firings at one dead centre within a cycle")
                # Cylinder 1 comes first in its group, and fires at 0.
                choices.append([slots] if len(slots) == 1 or tick == 0 else [slots, slots[::-1]])
            for choice in product(*choices):
                rows[tuple(moment for slots in choice for moment in slots)] = None
        return np.array(list(rows), np.int64)

    def order_of(self, moments: Array) -> tuple[int, ...]:
        """Return the firing order of the moments of one star, as cylinder numbers."""
        return tuple(int(n) + 1 for n in np.argsort(moments, kind="stable"))

    def fires(self, moments: Array) -> dict[int, Fraction]:
        """Return when each cylinder fires, in turns after cylinder 1."""
        return {n: Fraction(int(moment), self.ticks) for n, moment in enumerate(moments, 1)}

    # What depends on the firing order

    def adjacent(self, moments: Array) -> Array:
        """Return how often two neighbours of a bank fire one after the other, along the last axis."""
        order = np.argsort(moments, axis=-1, kind="stable")
        step = abs(np.roll(order, -1, axis=-1) - order)
        if moments.shape[-1] == 1:
            return np.zeros(moments.shape[:-1], np.int64)
        return (step == len(self.problem.banks)).sum(-1)

    def unevenness(self, moments: Array) -> Array:
        """Return the longest interval less the shortest, in ticks, along the last axis."""
        ordered = np.sort(moments, axis=-1)
        cycle = self.problem.cycle * self.ticks
        gaps = np.diff(ordered, axis=-1, append=ordered[..., :1] + cycle)
        return gaps.max(-1) - gaps.min(-1)

    def torsion(self, objective: Objective) -> TorsionTable:
        """Return the table of a torsional order that depends on the firing order."""
        ((form,),) = objective.groups
        cycle = self.problem.cycle * self.ticks
        turns = [objective.order * Fraction(moment, self.ticks) % 1 for moment in range(cycle)]
        ring = IntegerRing(lcm(*(turn.denominator for turn in turns)))
        weights = [form.weights[n][0] for n in range(1, self.problem.cylinders + 1)]
        unit = Fraction(1, lcm(*(weight.denominator for weight in weights)))
        table = np.array(
            [[ring.vector({turn: int(weight / unit)}) for turn in turns] for weight in weights], np.int64
        )
        return TorsionTable(ring, unit, table)


@dataclass(frozen=True)
class TorsionTable:
    """What each cylinder adds to a torsional sum at each moment, in integers of a `unit`."""

    ring: IntegerRing
    unit: Fraction
    table: Array

    def squares(self, moments: Array) -> tuple[Array, Array]:
        """Return the squares of the sums of moments [..., cylinder] as vectors, and the sums' sizes."""
        total = np.zeros((*moments.shape[:-1], self.ring.degree), np.int64)
        for n in range(moments.shape[-1]):
            total += self.table[n][moments[..., n]]
        return self.ring.squares(total), abs(total @ self.ring.cosines) * float(self.unit)
