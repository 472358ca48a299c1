r"""Assignment of weighed parts to cylinders so that the engine shakes least.

A piston or rod of reciprocating mass p and rotating mass q in cylinder j adds to order n

    c_{+-n} = p r_j omega^2 f_{+-n}(j)/2 e^(i (bank_j +- n (throw_j - bank_j))),
    c_1     = q r_j omega^2 e^(i throw_j)      of the rotating mass, in order 1 alone:

on a link pin it has both signs of all orders (`contributions.rotating_pair`).

Orders do not interfere in the mean over a turn, so the criterion is the square root of

    sum over the orders asked for of  |c_n|^2 + |c_-n|^2  (force)  +  the same of the couple, over L^2:

the root mean square of the planar force and of the couple taken as a force at the lever L (default:
the root mean square of the stations from the reference plane). By default parts count with what they
differ by from the mean of their set: the crank's counterweights and shafts are made for that mean. Which
part goes where is then a sum of vectors to be made short (`arrangement_search`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.design.variations.arrangement_search import Arrangement
from symbalance.design.variations.assignment_bounds import Vector, arrangement_sum, norm
from symbalance.design.variations.assignment_objective import AssignmentProblem, expected_length
from symbalance.design.variations.contributions import checked_numeric_engine, contributions
from symbalance.design.variations.legend import as_decimal
from symbalance.design.variations.part_sets import PartSet, checked_sets
from symbalance.design.variations.shaking import (
    Shaking,
    as_built_vector,
    generators,
    shaking_of,
    units_of,
)
from symbalance.document.result import Result
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.forces.operating_point import checked_rpm
from symbalance.text.numbers import as_list, checked_whole

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

MOST_CYLINDERS = 48
"""More are no engine's; it bounds the time that the search takes."""
GRAIN = 1e-10
"""Arrangements whose lengths agree to this part are equal: the listed order is then kept."""


@dataclass(frozen=True, repr=False)
class Assignment(Result):
    """Weighed parts assigned to cylinders; forces and couples in N and N m, or in `units`.

    `places` maps a cylinder's number to its parts' names, by kind. `criterion` is the root mean square
    force left, couples at the lever `lever` counted in; `as_listed` the same with the parts in the
    order they are listed in, `at_random` its root mean square over all arrangements, `bound` what none
    passes below; `proved`: there is no better one. `residual` is what each order leaves,
    `residual_as_listed` the same of the listed order. `orders` are those that count, at `rpm` turns a
    minute; `whole` says that whole masses count, not only what they differ by.
    """

    engine: Engine
    orders: tuple[int, ...]
    rpm: Fraction | None
    places: dict[int, dict[str, str]]
    criterion: float
    as_listed: float
    at_random: float
    bound: float
    proved: bool
    residual: tuple[Shaking, ...]
    residual_as_listed: tuple[Shaking, ...]
    lever: float
    units: tuple[str, str]
    whole: bool

    kind: ClassVar[str] = "assignment"

    def summary(self) -> str:
        """Return what is left, and of the listed order, in one line."""
        proof = "no arrangement leaves less" if self.proved else f"at least {self.bound:.6g} is left"
        return (
            f"Assignment of parts to {self.engine.name}: {self.criterion:.6g} {self.units[0]} left, "
            f"{self.as_listed:.6g} as listed; {proof}"
        )

    def document(self) -> Document:
        """Return which part goes where, what that leaves, then how it is counted."""
        from symbalance.design.variations.assignment_document import assignment_document

        return assignment_document(self)

    def data(self) -> dict[str, Any]:
        """Return the places, the criterion with what it is compared to, and what each order leaves."""
        return {
            "engine": self.engine.name,
            "orders": list(map(str, self.orders)),
            "rpm": None if self.rpm is None else as_decimal(self.rpm),
            "units": {"force": self.units[0], "couple": self.units[1]},
            "places": {str(number): names for number, names in self.places.items()},
            "criterion": self.criterion,
            "as_listed": self.as_listed,
            "at_random": self.at_random,
            "bound": self.bound,
            "proved": self.proved,
            "lever": self.lever,
            "counted": "whole masses" if self.whole else "differences from the mean",
            "left": [_shaking(one) for one in self.residual],
            "left_as_listed": [_shaking(one) for one in self.residual_as_listed],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each cylinder: its number, and the name of its part of each kind."""
        return [{"cylinder": number, **names} for number, names in self.places.items()]


def _shaking(one: Shaking) -> dict[str, Any]:
    return {
        "order": str(one.order),
        "force": one.force,
        "couple": one.couple,
        "rms_force": one.mean_force,
        "rms_couple": one.mean_couple,
    }


def assign_parts(
    engine: Engine,
    parts: object,
    *,
    orders: object = (1,),
    rpm: object = None,
    lever: object = None,
    whole: bool = False,
) -> Assignment:
    """Return the assignment of weighed parts to cylinders with the least residual force and couple.

    `parts` are the pistons' masses in kg, or sets from `read_parts`; `orders` those that count; `lever`,
    in mm, is what a couple is divided by; with `rpm` and the engine's stroke (and pitch) results are in N
    and N m. `whole` counts the whole masses, not only what they differ by, and the counterweights, shafts
    and rotating masses of the engine, the parts' own rotating masses then by what they differ by.

    >>> from symbalance.engine.builders import inline
    >>> best = assign_parts(inline("1-3-4-2", ratio=4), [0.452, 0.448, 0.451, 0.449])
    >>> {number: names["piston"] for number, names in best.places.items()}, best.proved
    ({1: 'piston 4', 2: 'piston 2', 3: 'piston 1', 4: 'piston 3'}, True)
    """
    checked_numeric_engine(engine)
    count = len(engine.cylinders)
    if count > MOST_CYLINDERS:
        rule = f"must be at most {MOST_CYLINDERS}"
        raise SymbalanceError(f"{count} cylinders", rule, "assign the parts of one engine")
    sets = checked_sets(parts, engine)
    numbers = _checked_orders(orders)
    rows = contributions(engine, max(numbers))
    speed = None if rpm is None else checked_rpm(rpm)
    units = units_of(engine, speed, lever, rows[1])
    there = [n for n in numbers if n in rows]
    vectors = generators(engine, [rows[n] for n in there], units)
    as_built = as_built_vector(engine, there, units) if whole else None
    problem = AssignmentProblem.of(sets, vectors, whole, as_built)
    places, best, first, search = _compare(engine, sets, problem)
    return Assignment(
        engine,
        tuple(numbers),
        speed,
        places,
        norm(best),
        norm(first),
        expected_length(problem.start, problem.tables),
        min(search.bound, norm(best)),
        search.proved,
        shaking_of(best, there, units),
        shaking_of(first, there, units),
        units.lever,
        units.names,
        whole,
    )


def _checked_orders(orders: object) -> list[int]:
    numbers = as_list(orders, "orders", "[1, 2]")
    if not numbers:
        raise SymbalanceError("orders = []", "is empty", "order 1 is usual")
    return sorted({checked_whole(n, "order", 1, 1000, "1 and 2 are usual") for n in numbers})


def _compare(
    engine: Engine, sets: Sequence[PartSet], problem: AssignmentProblem
) -> tuple[dict[int, dict[str, str]], Vector, Vector, Arrangement]:
    """Return the best places, what they leave, what the listed order leaves, and the search's bound.

    Where nothing is better than the listed order, that is the best.
    """
    search = problem.solution()
    listed_orders = tuple(tuple(range(len(one.parts))) for one in sets)
    best, first = (
        arrangement_sum(problem.start, problem.tables, o) for o in (search.orders, listed_orders)
    )
    as_listed = norm(first) <= norm(best) * (1 + GRAIN)
    orders, best = (listed_orders, first) if as_listed else (search.orders, best)
    sets_in_order = list(zip(sets, orders, strict=True))
    places = {
        c.number: {one.kind: one.parts[order[j]].name for one, order in sets_in_order}
        for j, c in sorted(enumerate(engine.cylinders), key=lambda pair: pair[1].number)
    }
    return places, best, first, search
