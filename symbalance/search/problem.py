"""The question of a search: cylinders on pins, where they may stand, when they fire, what is the same.

Pins count from the front, pin 1 stands on ray 0. A star says on which of M evenly spaced rays each pin
stands; rays count as they pass, so the first cylinder of a pin on ray s reaches top dead centre s/M of a
turn after cylinder 1:

    throw of pin p = base_p - s_p/M,   base_p = bank of its first cylinder - bank of cylinder 1.

Evenly firing, h = strokes/(2 N) of a turn apart, the top dead centres are the multiples of h modulo a
turn, each of them as often as it comes up in a cycle. This is an exact cover: every pin takes the
moments of its cylinders, and all are taken.

Three symmetries change no force, no couple and no interval, up to the sense in which they count: the
mirror image (the other sense of rotation), the engine looked at from the rear, and both. Each maps pins
to pins, where the engine's banks and stations allow it, and rays to rays: s'_q = sign (s_p - s_0) + k_q.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import accumulate, pairwise
from math import lcm

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_strokes
from symbalance.engine.stars import pin_offsets
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import Angle
from symbalance.text.numbers import as_list, checked_whole, exact

MOST_CYLINDERS = 24
"""More are not searched: without conditions 24 in line have 3 10^23 stars."""
MOST_RAYS = 63
"""Rays, and moments of a turn: each is a bit of one machine word."""
PINS = ("shared", "split", "offset")
FREE = 100
"""Capacity of a moment where any number of cylinders may share it."""


@dataclass(frozen=True)
class Seat:
    """A cylinder's place on its pin: number, bank, station, and how far its crank pin is turned on.

    Angles in turns, stations in pitches towards the front.
    """

    number: int
    bank: Fraction
    station: Fraction
    offset: Fraction = Fraction(0)


@dataclass(frozen=True)
class Pattern:
    """Top dead centres to be taken: how many at each moment of a turn, and the firings in a cycle.

    `capacity` counts by ticks; `firings` holds, for each sequence of intervals that cylinder 1 may
    begin, the moments of a cycle in ticks. Both are empty where any moment will do.
    """

    capacity: tuple[int, ...]
    firings: tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class Symmetry:
    """A map of stars to stars: s'_q = sign (s_source[q] - s_source[0]) + shift_q, modulo the rays."""

    source: tuple[int, ...]
    sign: int
    shift: tuple[int, ...]
    along: int = 1
    """-1 where front and rear change places."""

    def image(self, star: Sequence[int], rays: int) -> tuple[int, ...]:
        """Return the star that a star becomes."""
        first = star[self.source[0]]
        pairs = zip(self.source, self.shift, strict=True)
        return tuple((self.sign * (star[p] - first) + k) % rays for p, k in pairs)


@dataclass(frozen=True)
class SearchProblem:
    """What is searched: so many cylinders on pins in banks, the moments they fire at, the pins' grid.

    Made by `search_problem`, which checks it. Angles in degrees, stations in pitches.
    """

    cylinders: int
    strokes: int = 4
    banks: tuple[Fraction, ...] = (Fraction(0),)
    pins: str = "shared"
    pin_offset: Fraction = Fraction(0)
    intervals: tuple[Fraction, ...] | None = None
    """Degrees between firings, None for even ones; empty where any will do."""
    grid: Fraction | None = None
    """Degrees of which all throws are multiples, pin 1 at 0; None for any."""
    stations: tuple[Fraction, ...] = ()
    seats: tuple[tuple[Seat, ...], ...] = field(default=(), repr=False)

    @property
    def is_any(self) -> bool:
        """Whether cylinders may fire at any moments."""
        return self.intervals == ()

    @property
    def cycle(self) -> int:
        """Turns of a working cycle."""
        return self.strokes // 2

    @property
    def pin_count(self) -> int:
        """The pins, or pairs of offset pins, that stand on one ray each."""
        return len(self.seats)

    @cached_property
    def rays(self) -> int:
        """How many evenly spaced rays there are."""
        if self.is_any:
            assert self.grid is not None
            return int(360 / self.grid)
        if self.intervals is None:
            return (Fraction(self.cycle, self.cylinders) % 1).denominator
        return lcm(*((gap / 360).denominator for gap in self.intervals))

    @cached_property
    def lags(self) -> tuple[tuple[Fraction, ...], ...]:
        """How long after its pin's first cylinder each one reaches top dead centre, in turns."""
        return tuple(
            tuple((s.bank - s.offset - (pin[0].bank - pin[0].offset)) % 1 for s in pin)
            for pin in self.seats
        )

    @cached_property
    def ticks(self) -> int:
        """Moments of a turn that are told apart: a multiple of the rays."""
        if self.is_any:
            return self.rays
        return lcm(self.rays, *(lag.denominator for pin in self.lags for lag in pin))

    def bases(self) -> list[Fraction]:
        """Return the throw of each pin on ray 0, in turns, pin 1's being 0."""
        first = self.seats[0][0]
        origin = first.bank - first.offset
        return [pin[0].bank - pin[0].offset - origin for pin in self.seats]

    @cached_property
    def allowed(self) -> tuple[tuple[bool, ...], ...]:
        """Which rays each pin may stand on: all, or those on the grid."""
        step = Fraction(0) if self.grid is None else self.grid / 360
        return tuple(
            tuple(not step or ((base - Fraction(s, self.rays)) / step).denominator == 1
                  for s in range(self.rays))
            for base in self.bases()
        )  # fmt: skip

    @cached_property
    def takes(self) -> tuple[tuple[tuple[int, ...], ...], ...]:
        """The ticks that each pin takes on each ray, one for each of its cylinders."""
        if self.is_any:
            return tuple(tuple((s,) for s in range(self.rays)) for _ in self.seats)
        step, ticks = self.ticks // self.rays, self.ticks
        return tuple(
            tuple(tuple((s * step + int(lag * ticks)) % ticks for lag in lags) for s in range(self.rays))
            for lags in self.lags
        )

    @cached_property
    def patterns(self) -> tuple[Pattern, ...]:
        """Every pattern of moments, cylinder 1 at 0: one where firing is even."""
        if self.is_any:
            return (Pattern((FREE,) * self.ticks, ()),)
        gaps = self.intervals or (Fraction(360 * self.cycle, self.cylinders),) * self.cylinders
        times = [Fraction(0), *accumulate(gaps[:-1])]
        cycle = 360 * self.cycle
        starts = dict.fromkeys(
            tuple(sorted(int((t - start) % cycle / 360 * self.ticks) for t in times)) for start in times
        )
        grouped: dict[tuple[int, ...], list[tuple[int, ...]]] = {}
        for moments in starts:
            counts = Counter(moment % self.ticks for moment in moments)
            grouped.setdefault(tuple(counts[t] for t in range(self.ticks)), []).append(moments)
        return tuple(Pattern(capacity, tuple(firings)) for capacity, firings in grouped.items())

    @cached_property
    def order(self) -> tuple[int, ...]:
        """The order in which pins are placed: from both ends inwards, the longest levers first."""
        last = self.pin_count - 1
        return tuple(p for i in range((last + 2) // 2) for p in dict.fromkeys((i, last - i)))

    @cached_property
    def symmetries(self) -> tuple[Symmetry, ...]:
        """The maps other than the identity that mirror images and views from the rear make of stars."""
        kinds = ((-1, 1), (-1, -1), (1, -1))
        makers = [one for turn, along in kinds for one in self._maps(turn, along)]
        return _closed(makers, self.pin_count, self.rays)

    @cached_property
    def mirrors(self) -> tuple[Symmetry, ...]:
        """Those of the maps that leave the front where it is."""
        return tuple(one for one in self.symmetries if one.along == 1)

    def _maps(self, turn: int, along: int) -> Iterator[Symmetry]:
        """Yield the maps that turn all angles by a sign, about some axis, and stations by another."""
        if turn < 0 and not self._reversible():
            return
        axes = [bank / 360 for bank in self.banks]
        for about in dict.fromkeys((axes[0] + axis) % 1 for axis in axes) if turn < 0 else [Fraction(0)]:
            one = self._symmetry(turn, along, about)
            if one is not None:
                yield one

    def _symmetry(self, turn: int, along: int, about: Fraction) -> Symmetry | None:
        seats = {_outline(pin): q for q, pin in enumerate(self.seats)}
        if len(seats) < self.pin_count:  # two cylinders at one place: which is which is not to be said
            return None
        source, added = [0] * self.pin_count, [Fraction(0)] * self.pin_count
        for p, pin in enumerate(self.seats):
            image = tuple(
                Seat(s.number, (about + turn * s.bank) % 1, along * s.station, turn * s.offset)
                for s in pin
            )
            target = seats.get(_outline(image))
            if target is None:
                return None
            source[target] = p
            # Where the image's pin stands: its cylinder in the place of the target's first.
            first = self.seats[target][0]
            partner = next(
                s for s in image if (s.bank - first.bank) % 1 == 0 and s.station == first.station
            )
            added[target] = partner.offset - first.offset
        bases = self.bases()
        raw = [turn * bases[p] + add for p, add in zip(source, added, strict=True)]
        shifts = [(bases[q] - raw[q] + raw[0]) * self.rays for q in range(self.pin_count)]
        if any(shift.denominator != 1 for shift in shifts):
            return None
        return Symmetry(tuple(source), turn, tuple(int(shift) % self.rays for shift in shifts), along)

    def _reversible(self) -> bool:
        """Tell whether the intervals are those of the engine that turns the other way."""
        if not self.intervals:
            return True
        gaps = list(self.intervals)
        backward = gaps[::-1]
        return any(backward[i:] + backward[:i] == gaps for i in range(len(gaps)))

    def throws(self, star: Sequence[int]) -> dict[int, Fraction]:
        """Return each cylinder's throw, in turns, at cylinder 1's top dead centre."""
        first = self.seats[0][0]
        bases = self.bases()
        return {
            seat.number: (
                first.bank - first.offset + bases[p] - Fraction(star[p], self.rays) + seat.offset
            ) % 1
            for p, pin in enumerate(self.seats)
            for seat in pin
        }  # fmt: skip

    def dead_centres(self, star: Sequence[int]) -> dict[int, Fraction]:
        """Return how long after cylinder 1 each one reaches top dead centre, in turns."""
        throws = self.throws(star)
        return {s.number: (s.bank - throws[s.number]) % 1 for pin in self.seats for s in pin}

    def engine(self, star: Sequence[int], fires: dict[int, Fraction], name: str = "") -> Engine:
        """Return the engine of a star whose cylinders fire at the given turns after cylinder 1."""
        throws = self.throws(star)
        return Engine(
            [
                Cylinder(
                    s.number,
                    Angle(throws[s.number]),
                    Angle(s.bank),
                    s.station,
                    fires[s.number] * 360 if s.number in fires else None,
                )
                for s in sorted((s for pin in self.seats for s in pin), key=lambda s: s.number)
            ],
            strokes=self.strokes,
            name=name or "search",
        )

    def words(self) -> str:
        """Return the question in a line.

        >>> search_problem(12, strokes=2).words()
        'two-stroke in-line 12, even firing'
        """
        strokes = {2: "two-stroke", 4: "four-stroke"}[self.strokes]
        if len(self.banks) == 1:
            shape = f"in-line {self.cylinders}"
        else:
            axes = ", ".join(f"{_degrees(bank)}°" for bank in self.banks)
            pins = (
                f"pins offset by {_degrees(self.pin_offset)}°" if self.pin_offset else f"{self.pins} pins"
            )
            shape = f"{self.cylinders} cylinders in banks at {axes} on {pins}"
        if self.is_any:
            firing = "any intervals"
        elif self.intervals is None:
            firing = "even firing"
        else:
            firing = f"intervals {', '.join(map(_degrees, self.intervals))}"
        grid = "" if self.grid is None else f", throws in steps of {_degrees(self.grid)}°"
        return f"{strokes} {shape}, {firing}{grid}"


def _closed(makers: list[Symmetry], pins: int, rays: int) -> tuple[Symmetry, ...]:
    """Return maps and all that follow from one another, without the identity."""
    identity = Symmetry(tuple(range(pins)), 1, (0,) * pins)
    group = {identity: None}
    pending = [identity]
    while pending:
        one = pending.pop()
        for maker in makers:
            product = _product(one, maker, rays)
            if product not in group:
                group[product] = None
                pending.append(product)
    del group[identity]
    return tuple(group)


def _product(second: Symmetry, first: Symmetry, rays: int) -> Symmetry:
    """Return the map that does one after the other."""
    source = tuple(first.source[p] for p in second.source)
    base = first.shift[second.source[0]]
    pairs = zip(second.source, second.shift, strict=True)
    shift = tuple((second.sign * (first.shift[p] - base) + k) % rays for p, k in pairs)
    return Symmetry(source, first.sign * second.sign, shift, first.along * second.along)


def _degrees(value: Fraction) -> str:
    return str(value).replace("-", "−")


def _outline(pin: Sequence[Seat]) -> tuple[tuple[Fraction, Fraction, Fraction], ...]:
    """Return what of a pin's shape matters, whichever of its cylinders is written first."""
    places = sorted((s.bank % 1, s.station, s.offset) for s in pin)
    return tuple((bank, station, offset - places[0][2]) for bank, station, offset in places)


def search_problem(
    cylinders: object,
    *,
    strokes: int = 4,
    banks: Sequence[object] = (0,),
    pins: str = "shared",
    intervals: object = "even",
    grid: object = None,
    stations: Sequence[object] | None = None,
) -> SearchProblem:
    """Return the question of a search, checked: what `search_cranks` takes.

    `banks` are degrees from vertical. Cylinders are numbered from the front, row by row, a row holding
    one of each bank. `pins`: "shared", one for each row; "split", one for each cylinder; "offset", two
    banks whose right pin is turned on by the least angle that fires evenly, or "offset:30" by so many
    degrees. `intervals`: "even", "any" (on a `grid`), or degrees between successive firings, which sum
    to the cycle. `grid`: degrees that all throws are multiples of, as 90. `stations`: one for each
    cylinder, in pitches towards the front; rows are a pitch apart by themselves.

    >>> search_problem(6, banks=[-30, 30], pins="offset").pin_offset
    Fraction(-60, 1)
    >>> search_problem(7).rays, search_problem(8).rays, search_problem(8, strokes=2).rays
    (7, 4, 8)
    """
    checked_strokes(strokes)
    count = checked_whole(cylinders, "cylinders", 1, MOST_CYLINDERS, "of one engine")
    axes = tuple(exact(bank, "banks", 3600) for bank in as_list(banks, "banks", "[-45, 45]"))
    if not axes or len({axis % 360 for axis in axes}) < len(axes):
        raise SymbalanceError(
            f"banks = {brief(list(map(str, axes)))}", "must be different angles", "degrees"
        )
    if count % len(axes):
        rule = f"must be a multiple of the {len(axes)} banks"
        raise SymbalanceError(f"cylinders = {count}", rule, "a row has one cylinder of each bank")
    kind, _, given = str(pins).partition(":")
    if kind not in PINS or (given and kind != "offset"):
        rule = f"must be one of {', '.join(PINS)}"
        raise SymbalanceError(f"pins = {brief(pins)}", rule, "or offset:30, in degrees")
    offset = _pin_offset(kind, given, axes, count, strokes)
    gaps = _intervals(intervals, count, strokes)
    step = _grid(grid)
    if gaps == () and step is None:
        raise SymbalanceError("intervals = any", "needs a grid of throws", "add --grid 90, or another")
    places = _stations(stations, count, len(axes))
    rows = [
        [
            Seat(n + 1, axis / 360, places[n], offset / 360 if b else Fraction(0))
            for b, axis in enumerate(axes)
            for n in (row * len(axes) + b,)
        ]
        for row in range(count // len(axes))
    ]  # fmt: skip
    seats = [[seat] for row in rows for seat in row] if kind == "split" else rows
    if kind == "split" and stations is None and len(axes) == 2 and (axes[1] - axes[0]) % 360 == 180:
        seats = _side_by_side(rows)  # a boxer, as the library builds it
    problem = SearchProblem(
        count, strokes, axes, kind, offset, gaps, step, places, tuple(tuple(pin) for pin in seats)
    )
    _check_fit(problem)
    return problem


def _side_by_side(rows: list[list[Seat]]) -> list[list[Seat]]:
    """Return a pin for each cylinder, those of a row evenly spread over its pitch, as in a boxer."""
    count = len(rows[0])
    spread = [Fraction(count - 1 - 2 * b, 2 * count) for b in range(count)]
    return [
        [Seat(s.number, s.bank, s.station + aside, s.offset)]
        for row in rows
        for s, aside in zip(row, spread, strict=True)
    ]


def _pin_offset(kind: str, given: str, axes: tuple[Fraction, ...], count: int, strokes: int) -> Fraction:
    if kind != "offset":
        return Fraction(0)
    if len(axes) != 2:
        raise SymbalanceError("pins = offset", "is for two banks", "take shared or split")
    if given:
        return exact(given, "pins = offset", 3600)
    between = (axes[1] - axes[0]) % 360
    if between > 180:
        return -pin_offsets(count, 360 - between, strokes)[0]
    return pin_offsets(count, between, strokes)[0]


def _intervals(intervals: object, count: int, strokes: int) -> tuple[Fraction, ...] | None:
    if intervals in (None, "even"):
        return None
    if intervals == "any":
        return ()
    parts = intervals.split(",") if isinstance(intervals, str) else as_list(intervals, "intervals")
    gaps = tuple(
        exact(part.strip() if isinstance(part, str) else part, "intervals", 3600) for part in parts
    )
    cycle = 180 * strokes
    if not gaps or count % len(gaps) or min(gaps) <= 0 or sum(gaps) * (count // len(gaps)) != cycle:
        rule = f"must be {count} degrees above 0, or a part of them that repeats, {cycle} in all"
        raise SymbalanceError(f"intervals = {brief(intervals)}", rule, "or even, or any")
    gaps *= count // len(gaps)
    return None if len(set(gaps)) == 1 else gaps


def _grid(grid: object) -> Fraction | None:
    if grid is None:
        return None
    step = exact(grid, "grid", 3600)
    if step <= 0 or (360 / step).denominator != 1 or 360 / step > MOST_RAYS:
        rule = f"must divide 360 degrees into at most {MOST_RAYS} parts"
        raise SymbalanceError(f"grid = {brief(grid)}", rule, "as 90 or 10")
    return step


def _stations(stations: Sequence[object] | None, count: int, banks: int) -> tuple[Fraction, ...]:
    rows = count // banks
    if stations is None:
        return tuple(Fraction(rows - 1, 2) - n // banks for n in range(count))
    places = [exact(one, "stations", 3600) for one in as_list(stations, "stations", "[1, 0, -1]")]
    if len(places) == rows:
        places = [place for place in places for _ in range(banks)]
    if len(places) != count:
        rule = f"must be {count} places, one for each cylinder, or {rows}, one for each row"
        raise SymbalanceError(f"stations of {len(places)} numbers", rule, "pitches towards the front")
    if any(front < rear for front, rear in pairwise(places[::banks])):
        raise SymbalanceError(
            "stations", "must run from the front to the rear", "pitches towards the front"
        )
    mean = sum(places, Fraction(0)) / count
    return tuple(place - mean for place in places)


def _check_fit(problem: SearchProblem) -> None:
    if problem.ticks > MOST_RAYS:
        rule = f"needs {problem.ticks} moments of a turn to be told apart, more than {MOST_RAYS}"
        raise SymbalanceError(problem.words(), rule, "take angles of fewer digits, or a coarser grid")
    if problem.is_any:
        return
    used = {t for pattern in problem.patterns for t, n in enumerate(pattern.capacity) if n}
    if not any(set(takes) <= used for takes in problem.takes[0]):
        remedy = "take --pins offset or split, or --intervals any with a --grid"
        raise SymbalanceError(problem.words(), "cannot fire so on shared pins", remedy)
