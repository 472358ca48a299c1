r"""Weighed parts to cylinders, so that the engine shakes least.

A piston or rod of reciprocating mass p and rotating mass q in cylinder j adds to order n

    c_{+-n} = p r_j omega^2 f_{+-n}(j)/2 e^(i (bank_j +- n (throw_j - bank_j))),
    c_1     = q r_j omega^2 e^(i throw_j)      of the rotating mass, in order 1 alone:

on a link pin it has both signs of all orders (`symbalance.design.variations.shares.rotating_pair`).

Orders do not interfere in the mean over a turn, so the criterion is the square root of

    sum over the orders asked for of  |c_n|^2 + |c_-n|^2  (force)  +  the same of the couple, over L^2:

the root mean square of the planar force and of the couple taken as a force at the lever L (default:
the root mean square of the stations from the reference plane). By default parts count with what they
differ by from the mean of their set: the crank's counterweights and shafts are made for that mean. Which
part goes where is then a sum of vectors to be made short (`symbalance.design.variations.placements`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symbalance.design.variations.bounds import norm, total
from symbalance.design.variations.measures import (
    Shaking,
    Units,
    generators,
    made_vector,
    shaking_of,
    units_of,
)
from symbalance.design.variations.placements import Placement
from symbalance.design.variations.problems import Problem, expected
from symbalance.design.variations.shares import checked_layout, shares
from symbalance.design.variations.weighed import PartSet, checked_sets
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.text.numbers import checked_whole, listed

MOST_CYLINDERS = 48
GRAIN = 1e-10


@dataclass(frozen=True)
class Assignment:
    """Which part goes to which cylinder; numbers are in N and N m, or in `units`.

    `places` maps a cylinder's number to its parts' names, by kind. `criterion` is the root mean square
    force left, couples at the lever `lever` counted in; `listed` the same with the parts in the order
    they are listed in, `random` its root mean square over all arrangements, `bound` what none passes
    below; `proved`: there is no better one. `left` tells the orders apart, `left_listed` the same of the
    listed order.
    """

    layout: Engine
    places: dict[int, dict[str, str]]
    criterion: float
    listed: float
    random: float
    bound: float
    proved: bool
    left: tuple[Shaking, ...]
    left_listed: tuple[Shaking, ...]
    lever: float
    units: tuple[str, str]
    beyond: bool


def assign_parts(
    layout: Engine,
    parts: object,
    *,
    orders: object = (1,),
    rpm: object = None,
    lever: object = None,
    whole: bool = False,
) -> Assignment:
    """Return the arrangement of weighed parts that leaves least.

    `parts` are the pistons' masses in kg, or sets from `read_parts`; `orders` those that count; `lever`,
    in mm, is what a couple is divided by; with `rpm` and the engine's stroke (and pitch) results are in N
    and N m. `whole` counts the whole masses, not only what they differ by, and the counterweights, shafts
    and rotating masses of the engine, the parts' own rotating masses then by what they differ by.

    >>> from symbalance.engine.builders import inline
    >>> best = assign_parts(inline("1-3-4-2", ratio=4), [0.452, 0.448, 0.451, 0.449])
    >>> {number: names["piston"] for number, names in best.places.items()}, best.proved
    ({1: 'piston 4', 2: 'piston 2', 3: 'piston 1', 4: 'piston 3'}, True)
    """
    checked_layout(layout)
    count = len(layout.cylinders)
    if count > MOST_CYLINDERS:
        rule = f"must be at most {MOST_CYLINDERS}"
        raise SymbalanceError(f"{count} cylinders", rule, "assign the parts of one engine")
    sets = checked_sets(parts, count)
    asked = _checked_orders(orders)
    rows = shares(layout, max(asked))
    units = units_of(layout, rpm, lever, rows[1])
    there = [n for n in asked if n in rows]
    vectors = generators(layout, [rows[n] for n in there], units)
    made = made_vector(layout, there, units) if whole else None
    problem = Problem.of(sets, vectors, whole, made)
    return _told(layout, sets, problem, problem.solved(), there, units, not whole)


def _checked_orders(orders: object) -> list[int]:
    asked = listed(orders, "orders", "[1, 2]")
    if not asked:
        raise SymbalanceError("orders = []", "is empty", "order 1 is usual")
    return sorted({checked_whole(n, "order", 1, 1000, "1 and 2 are usual") for n in asked})


def _told(
    layout: Engine,
    sets: Sequence[PartSet],
    problem: Problem,
    placed: Placement,
    asked: Sequence[int],
    units: Units,
    beyond: bool,
) -> Assignment:
    """Return the arrangement found; the listed one where nothing is better."""
    listed_orders = tuple(tuple(range(len(one.parts))) for one in sets)
    best, first = (total(problem.start, problem.tables, o) for o in (placed.orders, listed_orders))
    as_listed = norm(first) <= norm(best) * (1 + GRAIN)
    orders, best = (listed_orders, first) if as_listed else (placed.orders, best)
    chosen = list(zip(sets, orders, strict=True))
    places = {
        c.number: {one.kind: one.parts[order[j]].name for one, order in chosen}
        for j, c in sorted(enumerate(layout.cylinders), key=lambda pair: pair[1].number)
    }
    return Assignment(
        layout,
        places,
        norm(best),
        norm(first),
        expected(problem.start, problem.tables),
        min(placed.bound, norm(best)),
        placed.proved,
        shaking_of(best, asked, units),
        shaking_of(first, asked, units),
        units.lever,
        units.names,
        beyond,
    )
