r"""Weighed parts to cylinders, so that the engine shakes least.

A piston or rod of reciprocating mass p and rotating mass q in cylinder j adds to order n

    c_{+-n} = p r_j omega^2 f_{+-n}(j)/2 e^(i (bank_j +- n (throw_j - bank_j))),   and to c_1  q r_j omega^2 e^(i throw_j).

Orders do not interfere in the mean over a turn, so the criterion is the square root of

    sum over the orders asked for of  |c_n|^2 + |c_-n|^2  (force)  +  the same of the couple, over L^2:

the root mean square of the planar force and of the couple taken as a force at the lever L (default: the
root mean square of the stations from the reference plane). By default parts count with what they differ from
the mean of their set: the crank's counterweights and shafts are made for that mean. Which part goes
where is then a sum of vectors to be made short (`symbalance.variations.placements`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi, sqrt

from symbalance.errors import SymbalanceError, shown
from symbalance.layout import Layout
from symbalance.rational import checked_whole, exact, listed
from symbalance.variations.placements import Order, Table, Vector, arranged, norm, total
from symbalance.variations.shares import Share, checked_layout, first_sizes, shares
from symbalance.variations.symmetry import Generators, representatives
from symbalance.variations.weighed import PartSet, checked_sets

MOST_CYLINDERS = 48
FASTEST = 100_000
GRAIN = 1e-10


@dataclass(frozen=True)
class Shaking:
    """What one arrangement leaves of one order: largest moduli over a turn, and root mean squares."""

    order: int
    force: float
    couple: float
    mean_force: float
    mean_couple: float


@dataclass(frozen=True)
class Assignment:
    """Which part goes to which cylinder; numbers are in N and N m, or in `units`.

    `places` maps a cylinder's number to its parts' names, by kind. `criterion` is the root mean square
    force left, couples at the lever `lever` counted in; `listed` the same with the parts in the order they
    are listed in, `random` its root mean square over all arrangements, `bound` what none passes below;
    `proved`: there is no better one. `left` tells the orders apart, `left_listed` those of the listed order.
    """

    layout: Layout
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
    layout: Layout,
    parts: object,
    *,
    orders: object = (1,),
    rpm: object = None,
    lever: object = None,
    whole: bool = False,
) -> Assignment:
    """Return the arrangement of weighed parts that leaves least.

    `parts` are the pistons' masses in kg, or sets from `read_parts`; `orders` those that count; `lever`, in
    mm, is what a couple is divided by; with `rpm` and the engine's stroke (and pitch) results are in N and
    N m. `whole` counts the whole masses, not only what they differ by.

    >>> from symbalance.builders import inline
    >>> best = assign_parts(inline("1-3-4-2", ratio=4), [0.452, 0.448, 0.451, 0.449])
    >>> {number: names["piston"] for number, names in best.places.items()}, best.proved
    ({1: 'piston 1', 2: 'piston 3', 3: 'piston 4', 4: 'piston 2'}, True)
    """
    checked_layout(layout)
    count = len(layout.cylinders)
    if count > MOST_CYLINDERS:
        rule = f"must be at most {MOST_CYLINDERS}"
        raise SymbalanceError(f"{count} cylinders", rule, "assign the parts of one engine")
    sets = checked_sets(parts, count)
    asked = _checked_orders(orders)
    rows = shares(layout, max(asked))
    units = _units(layout, rpm, lever, rows[1])
    generators = _generators(layout, [rows[n] for n in asked if n in rows], units)
    problem = _Problem.of(sets, generators, whole)
    placed = problem.solved()
    return problem.told(layout, sets, placed.orders, placed.bound, placed.proved, asked, units, not whole)


def _checked_orders(orders: object) -> list[int]:
    asked = listed(orders, "orders", "[1, 2]")
    if not asked:
        raise SymbalanceError("orders = []", "is empty", "order 1 is usual")
    return sorted({checked_whole(n, "order", 1, 1000, "1 and 2 are usual") for n in asked})


@dataclass(frozen=True)
class _Units:
    """r omega^2 of cylinder 1 and the pitch, in the units of the result, and the lever in pitches."""

    force: float
    arm: float
    lever: float
    names: tuple[str, str]


def _units(layout: Layout, rpm: object, lever: object, own: Sequence[Share]) -> _Units:
    _, radius = first_sizes(layout)
    pitch = layout.crank_train.pitch
    force, arm, names = 1.0, 1.0, ("kg · r ω²", "kg · r ω² a")
    if rpm is not None:
        speed = exact(rpm, "rpm")
        if not 0 < speed <= FASTEST:
            raise SymbalanceError(f"rpm = {shown(rpm)}", f"must lie in (0, {FASTEST}]", "turns a minute")
        if radius is None:
            raise SymbalanceError("rpm", "needs the engine's stroke", "give stroke in [crank_train]")
        force, names = float(radius) / 1000 * (float(speed) * pi / 30) ** 2, ("N", "N a")
    if pitch is not None and rpm is not None:
        arm, names = float(pitch) / 1000, (names[0], "N m")
    spread = sqrt(sum(float(s.arm) ** 2 for s in own) / len(own)) or 1.0
    if lever is not None:
        given = exact(lever, "lever")
        if given <= 0 or pitch is None:
            rule = "must be positive" if given <= 0 else "needs the engine's pitch"
            raise SymbalanceError(f"lever = {shown(lever)}", rule, "mm; give pitch in [crank_train]")
        spread = float(given / pitch)
    return _Units(force, arm, spread, names)


def _generators(layout: Layout, orders: Sequence[Sequence[Share]], units: _Units) -> Generators:
    """Return, for each cylinder, what 1 kg of reciprocating and of rotating mass adds: real vectors."""
    found = []
    own_radius = [layout.train_of(c).stroke for c in layout.cylinders]
    for place, cylinder in enumerate(layout.cylinders):
        stroke, first = own_radius[place], own_radius[0]
        radius = units.force * (float(stroke / first) if stroke and first else 1.0)
        sliding: list[float] = []
        turning: list[float] = []
        for own in orders:
            share = own[place]
            f = complex(share.value) * radius / 2
            axis, lead = (2 * pi * float(x % 1) for x in (share.axis, share.lead))
            pair = (f * _turn(axis + lead), f.conjugate() * _turn(axis - lead))
            pin = radius * _turn(2 * pi * float(cylinder.throw.turns)) if share.order == 1 else 0j
            sliding += _real(pair, float(share.arm), units.lever)
            turning += _real((pin, 0j), float(share.arm), units.lever)
        found.append((tuple(sliding), tuple(turning)))
    return found


def _turn(angle: float) -> complex:
    from cmath import rect

    return rect(1, angle)


def _real(pair: tuple[complex, complex], arm: float, lever: float) -> list[float]:
    ahead, against = pair
    force = [ahead.real, ahead.imag, against.real, against.imag]
    return force + [x * arm / lever for x in force]


@dataclass(frozen=True)
class _Problem:
    """Vectors by part and place, about a constant; `heavy` orders each set, the part that differs most first."""

    start: Vector
    tables: tuple[Table, ...]
    generators: Generators

    @staticmethod
    def of(sets: Sequence[PartSet], generators: Generators, whole: bool) -> _Problem:
        start = tuple(0.0 for _ in generators[0][0])
        tables = []
        for one in sets:
            count = len(one.parts)
            means = [sum((p.reciprocating for p in one.parts), Fraction(0)) / count,
                     sum((p.rotating for p in one.parts), Fraction(0)) / count]
            if whole:
                for sliding, turning in generators:
                    mean = zip(sliding, turning, start, strict=True)
                    start = tuple(x * float(means[0]) + y * float(means[1]) + z for x, y, z in mean)
            tables.append([
                [_mixed(float(p.reciprocating - means[0]), float(p.rotating - means[1]), *pair)
                 for pair in generators]
                for p in one.parts
            ])
        return _Problem(start, tuple(tables), generators)

    def solved(self):
        """Return the best arrangement, on a basis of what the vectors span."""
        from symbalance.variations.bases import spanned

        start, tables, rest = spanned(self.start, self.tables)
        ranks = [_by_size(table) for table in tables]
        sorted_tables = [[table[p] for p in rank] for table, rank in zip(tables, ranks, strict=True)]
        fixed = representatives(self.start, self.generators)
        found = arranged(start, sorted_tables, fixed)
        orders = tuple(tuple(rank[p] for p in order) for rank, order in zip(ranks, found.orders, strict=True))
        return type(found)(orders, sqrt(found.length**2 + rest**2), sqrt(found.bound**2 + rest**2), found.proved)

    def told(self, layout, sets, orders: Sequence[Order], bound: float, proved: bool, asked, units: _Units, beyond: bool) -> Assignment:
        plain = [tuple(range(len(one.parts))) for one in sets]
        best, first = total(self.start, self.tables, orders), total(self.start, self.tables, plain)
        if norm(first) <= norm(best) * (1 + GRAIN):
            orders, best = plain, first  # no better than as listed: leave them there
        places = {
            c.number: {one.kind: one.parts[order[j]].name for one, order in zip(sets, orders, strict=True)}
            for j, c in enumerate(layout.cylinders)
        }
        criterion = norm(best)
        return Assignment(
            layout, places, criterion, norm(first), _expected(self.start, self.tables), min(bound, criterion),
            proved, _shaking(best, asked, units), _shaking(first, asked, units), units.lever, units.names, beyond,
        )  # fmt: skip


def _mixed(sliding_mass: float, turning_mass: float, sliding: Vector, turning: Vector) -> Vector:
    return tuple(sliding_mass * x + turning_mass * y for x, y in zip(sliding, turning, strict=True))


def _by_size(table: Table) -> list[int]:
    return sorted(range(len(table)), key=lambda p: -max(norm(v) for v in table[p]))


def _shaking(vector: Vector, asked: Sequence[int], units: _Units) -> tuple[Shaking, ...]:
    found = []
    for i, n in enumerate(asked):
        part = vector[8 * i : 8 * i + 8]
        if not part:
            continue
        couple = units.lever * units.arm
        moduli = [sqrt(part[k] ** 2 + part[k + 1] ** 2) for k in (0, 2, 4, 6)]
        means = [sqrt(moduli[k] ** 2 + moduli[k + 1] ** 2) for k in (0, 2)]
        found.append(Shaking(n, moduli[0] + moduli[1], (moduli[2] + moduli[3]) * couple, means[0], means[1] * couple))
    return tuple(found)


def _expected(start: Vector, tables: Sequence[Table]) -> float:
    """Return the root mean square length over all arrangements, each as likely.

    The variance of one set's sum is that of its table, freed of the means of rows and columns, summed and
    over N - 1 (Hoeffding, Annals of Mathematical Statistics 22 (1951), from memory).
    """
    mean, variance = start, 0.0
    for table in tables:
        count = len(table)
        for i in range(len(start)):
            entries = [[v[i] for v in row] for row in table]
            rows = [sum(row) / count for row in entries]
            columns = [sum(row[j] for row in entries) / count for j in range(count)]
            middle = sum(rows) / count
            mean = tuple(x + middle * count if k == i else x for k, x in enumerate(mean))
            if count > 1:
                variance += sum(
                    (entries[p][j] - rows[p] - columns[j] + middle) ** 2 for p in range(count) for j in range(count)
                ) / (count - 1)
    return sqrt(norm(mean) ** 2 + variance)
