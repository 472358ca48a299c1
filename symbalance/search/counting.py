"""How many cranks, stars and classes a question has, without walking over them.

A *crank* is a star with cylinder 1 on ray 0; a *star* is a crank and its mirror images, once; a *class*
is a star and what it is from the rear, once. The group G of symmetries acts on the cranks X, so that by
Burnside's lemma

    classes = sum over g in G of |X^g| / |G|,   stars = the same over the mirror images alone,

where X^g are the cranks that g leaves as they are. Both X and X^g are counted by dynamic programming
over the pins, or over the pins that g exchanges, and the moments that are still free.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cache
from math import factorial, prod

from symbalance.errors import SymbalanceError
from symbalance.search.problem import SearchProblem, Symmetry

MOST_STATES = 3_000_000
"""States of the counting, some hundred bytes each."""

Capacity = tuple[int, ...]


@dataclass(frozen=True)
class Counts:
    """Cranks, stars and classes."""

    cranks: int = 0
    stars: int = 0
    classes: int = 0

    def __add__(self, other: Counts) -> Counts:
        return Counts(self.cranks + other.cranks, self.stars + other.stars, self.classes + other.classes)

    def data(self) -> dict[str, int]:
        """Return the three numbers by name."""
        return {"cranks": self.cranks, "stars": self.stars, "classes": self.classes}


def count_all(problem: SearchProblem, symmetries: tuple[Symmetry, ...]) -> Counts:
    """Return how many cranks, stars and classes there are, under the symmetries that count.

    >>> from symbalance.search.problem import search_problem
    >>> five = search_problem(5)
    >>> count_all(five, five.symmetries)
    Counts(cranks=24, stars=12, classes=8)
    >>> twelve = search_problem(12, strokes=2)
    >>> count_all(twelve, twelve.symmetries).stars
    19958400
    """
    every = sum(_cranks(problem, pattern.capacity) for pattern in problem.patterns)
    fixed = [(one, sum(_fixed(problem, one, p.capacity) for p in problem.patterns)) for one in symmetries]
    mirrors = [count for one, count in fixed if one.along == 1]
    stars = (every + sum(mirrors)) // (1 + len(mirrors))
    classes = (every + sum(count for _, count in fixed)) // (1 + len(fixed))
    return Counts(every, stars, classes)


def _cranks(problem: SearchProblem, capacity: Capacity) -> int:
    """Return how many cranks fill a pattern."""
    free = _less(capacity, problem.takes[0][0]) if problem.allowed[0][0] else None
    if free is None:
        return 0
    if problem.is_any:
        return prod(sum(allowed) for allowed in problem.allowed[1:])
    if problem.ticks == problem.rays == sum(map(all, zip(*problem.allowed, strict=True))) and all(
        len(pin) == 1 for pin in problem.seats
    ):
        return factorial(sum(free)) // prod(factorial(places) for places in free)
    options = [
        [(s,) for s in range(problem.rays) if problem.allowed[p][s]] for p in range(1, problem.pin_count)
    ]
    takes = [[problem.takes[p][s[0]] for s in rays] for p, rays in enumerate(options, 1)]
    return _fillings(takes, free)


def _fixed(problem: SearchProblem, one: Symmetry, capacity: Capacity) -> int:
    """Return how many cranks that fill a pattern are what a symmetry makes of them."""
    total = 0
    for start in range(problem.rays):  # the ray of the pin that the symmetry brings to the front
        options = _fixed_options(problem, one, start)
        if options is not None:
            total += _fillings(options, capacity)
    return total


def _fixed_options(
    problem: SearchProblem, one: Symmetry, start: int
) -> list[list[tuple[int, ...]]] | None:
    """Return, for each orbit of pins, the ticks that its pins may take together; None if one has none."""
    options, assigned = [], set()
    for pin in range(problem.pin_count):
        if pin in assigned:
            continue
        # s_q = sign (s_source[q] - start) + shift_q: around the orbit, every ray follows from one.
        orbit = [pin]
        while one.source[orbit[-1]] != pin:
            orbit.append(one.source[orbit[-1]])
        assigned.update(orbit)
        choices = []
        for ray in range(problem.rays):
            rays = {pin: ray}
            for q in orbit:  # s_source = sign (s_q - shift_q) + start
                following = (one.sign * (rays[q] - one.shift[q]) + start) % problem.rays
                if rays.setdefault(one.source[q], following) != following:
                    break
            else:
                fits = all(problem.allowed[q][s] for q, s in rays.items())
                if fits and rays.get(0, 0) == 0 and rays.get(one.source[0], start) == start:
                    choices.append(tuple(t for q, s in rays.items() for t in problem.takes[q][s]))
        if not choices:
            return None
        options.append(choices)
    return options


def _fillings(options: list[list[tuple[int, ...]]], capacity: Capacity) -> int:
    """Return in how many ways each item takes one of its options and no moment is taken too often."""

    @cache
    def ways(item: int, free: Capacity) -> int:
        if item == len(options):
            return 1
        if ways.cache_info().currsize > MOST_STATES:
            rule = "has too many stars to be counted beforehand"
            raise SymbalanceError("this question", rule, "take fewer cylinders, or a coarser grid")
        alike = Counter(options[item])
        return sum(
            times * ways(item + 1, rest)
            for ticks, times in alike.items()
            if (rest := _less(free, ticks)) is not None
        )

    return ways(0, capacity)


def _less(capacity: Capacity, ticks: tuple[int, ...]) -> Capacity | None:
    """Return what is free after some moments are taken, None where they are not."""
    free = list(capacity)
    for tick in ticks:
        free[tick] -= 1
        if free[tick] < 0:
            return None
    return tuple(free)
