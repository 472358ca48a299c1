"""Evidence: what a search counts and measures, against brute force over engines, cylinder by cylinder.

An engine is a list of cylinders: bank, station, pin, and how far its crank pin is turned on. Every way to
turn the pins is tried, every way to fire, and every quantity is worked out from the throws alone: forces
from the two columns of an ellipse, bending from the reactions of a beam, torsion from the firings.
Nothing
is shared with the search: no rays, no order of pins, no integers of a ring, no group of symmetries.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import accumulate, product
from typing import Any

import numpy as np
import pytest

import symbalance as sb
from symbalance.search import search_cranks

Crank = tuple[Fraction, ...]
"""The throw of each cylinder, degrees, when cylinder 1 is at its top dead centre."""
EVERY = 100_000
NEAR = 1e-9


@dataclass(frozen=True)
class Place:
    """A cylinder: bank in degrees, station, the number of its pin, and the pin's offset there."""

    bank: Fraction
    station: Fraction
    pin: int
    offset: Fraction = Fraction(0)


@dataclass(frozen=True)
class Case:
    """A question as the search takes it, and the same engine written out."""

    question: dict[str, Any]
    places: tuple[Place, ...]

    @property
    def cycle(self) -> int:
        return 180 * self.question.get("strokes", 4)

    def patterns(self) -> list[list[Fraction]]:
        """Moments of a cycle at which some cylinder fires, cylinder 1 at 0; one list for each start."""
        count = len(self.places)
        gaps = self.question.get("intervals", "even")
        if gaps == "even":
            gaps = [Fraction(self.cycle, count)]
        gaps = list(gaps) * (count // len(gaps))
        starts = {tuple(accumulate([Fraction(0), *gaps[i:], *gaps[:i]][:-1])) for i in range(count)}
        return [list(one) for one in sorted(starts)]

    def cranks(self) -> set[Crank]:
        """Every crank, by trying all angles of all pins."""
        pins = 1 + max(place.pin for place in self.places)
        firsts = [next(p for p in self.places if p.pin == pin) for pin in range(pins)]
        start = self.places[0].bank - self.places[0].offset
        any_interval = self.question.get("intervals") == "any"
        step = self.question.get("grid")
        moments = [] if any_interval else [[t % 360 for t in one] for one in self.patterns()]
        angles = []
        for first in firsts:
            if any_interval:
                some = {start + Fraction(k * step) for k in range(360 // step)}
            else:
                some = {(first.bank - first.offset - t) % 360 for one in moments for t in one}
            if step is not None:
                some = {a for a in some if (a - start) % step == 0}
            angles.append(sorted(some))
        wanted = {tuple(sorted(one)) for one in moments}
        cranks = set()
        for rest in product(*angles[1:]):
            pin_angles = (start, *rest)
            throws = tuple((pin_angles[p.pin] + p.offset) % 360 for p in self.places)
            centres = tuple(
                sorted((p.bank - throw) % 360 for p, throw in zip(self.places, throws, strict=True))
            )
            if any_interval or centres in wanted:
                cranks.add(throws)
        return cranks

    def firings(self, crank: Crank) -> Iterator[tuple[Fraction, ...]]:
        """Yield when each cylinder fires, degrees of a cycle, in every way that gives the moments."""
        centres = [(p.bank - throw) % 360 for p, throw in zip(self.places, crank, strict=True)]
        wanted = {tuple(one) for one in self.patterns()}
        for turns in product(range(self.cycle // 360), repeat=len(centres) - 1):
            moments = tuple(c + 360 * k for c, k in zip(centres, (0, *turns), strict=True))
            if tuple(sorted(moments)) in wanted:
                yield moments

    def images(self, crank: Crank, rear: bool) -> Iterator[Crank]:
        """Yield the mirror images, and with `rear` the views from there, wherever the banks allow."""
        seats = {(p.bank % 360, p.station): n for n, p in enumerate(self.places)}
        banks = {p.bank % 360 for p in self.places}
        axes = {a + b for a in banks for b in banks}
        motions = [(-1, about) for about in axes] + [(1, a - b) for a in banks for b in banks]
        for turn, about in motions:
            for along in (1, -1) if rear else (1,):
                throws: dict[int, Fraction] = {}
                for place, throw in zip(self.places, crank, strict=True):
                    target = seats.get(((about + turn * place.bank) % 360, along * place.station))
                    if target is not None:
                        throws[target] = (about + turn * throw) % 360
                if len(throws) == len(self.places):
                    shift = self.places[0].bank - throws[0]
                    yield tuple((throws[n] + shift) % 360 for n in range(len(throws)))

    def counts(self, cranks: set[Crank]) -> tuple[int, int, int]:
        """Cranks, stars and classes."""
        return len(cranks), self._orbits(cranks, False), self._orbits(cranks, True)

    def _orbits(self, cranks: set[Crank], rear: bool) -> int:
        remaining, count = set(cranks), 0
        while remaining:
            count += 1
            pending = [remaining.pop()]
            while pending:
                for image in self.images(pending.pop(), rear):
                    if image in remaining:
                        remaining.remove(image)
                        pending.append(image)
        return count

    # Quantities

    def shaking(self, crank: Crank, order: int, couple: bool, forward: float = 1.0) -> float:
        """The largest value over a turn of the force or couple of an order.

        Half of each cylinder's force turns with the crank, half against it; `forward` is how much of
        the first half remains. The sum is an ellipse, cosine and sine columns, whose long half-axis is
        its largest singular value.
        """
        ellipse = np.zeros((2, 2))
        for place, throw in zip(self.places, crank, strict=True):
            bank, phase = np.radians(float(place.bank)), order * np.radians(float(throw - place.bank))
            lever = float(place.station) if couple else 1.0
            for turn, share in ((1, forward), (-1, 1.0)):
                # Half a unit at the bank plus or minus the phase order * theta + phase.
                at = bank + turn * phase
                ellipse += (
                    0.5
                    * share
                    * lever
                    * np.array([[np.cos(at), -turn * np.sin(at)], [np.sin(at), turn * np.cos(at)]])
                )
        return float(np.linalg.norm(ellipse, 2))

    def bending(self, crank: Crank) -> float:
        """The largest bending moment between two end supports, sections a hundredth of a pitch apart."""
        loads = [
            (float(p.station), np.exp(1j * np.radians(float(t))))
            for p, t in zip(self.places, crank, strict=True)
        ]
        rear, front = min(z for z, _ in loads) - 0.5, max(z for z, _ in loads) + 0.5
        reaction = -sum(f * (front - z) for z, f in loads) / (front - rear)  # at the rear support
        sections = np.union1d(np.linspace(rear, front, 201), [z for z, _ in loads])
        moments = [reaction * (x - rear) + sum(f * (x - z) for z, f in loads if z <= x) for x in sections]
        return float(max(abs(np.array(moments))))

    def bearing(self, crank: Crank) -> float:
        """The largest of the loads of all main bearings, half of each throw to either side."""
        rows: dict[Fraction, complex] = {}
        for place, throw in zip(self.places, crank, strict=True):
            rows[place.station] = rows.get(place.station, 0) + np.exp(1j * np.radians(float(throw)))
        throws = [rows[z] for z in sorted(rows)]
        padded = np.array([0, *throws, 0])
        return float(max(abs(padded[1:] + padded[:-1])) / 2)


def places(
    count: int,
    banks: tuple[int, ...] = (0,),
    *,
    pins: str = "shared",
    offset: int = 0,
    stations: tuple[Fraction, ...] = (),
    apart: Fraction = Fraction(0),
) -> tuple[Place, ...]:
    """Cylinders row by row, one of each bank; `apart`: between the two of a row."""
    rows = count // len(banks)
    along = stations or tuple(Fraction(rows - 1, 2) - row for row in range(rows))
    mean = sum(along) / len(along)
    return tuple(
        Place(
            Fraction(bank),
            along[row] - mean + apart * (Fraction(1, 2) - b),
            row * len(banks) + b if pins == "split" else row,
            Fraction(offset if b else 0),
        )
        for row in range(rows)
        for b, bank in enumerate(banks)
    )


UNEQUAL = (Fraction(2), Fraction(1), Fraction(0), Fraction(-3, 2), Fraction(-3))
WIDE = (Fraction(3), Fraction(2), Fraction(1, 2), Fraction(-1, 2), Fraction(-2), Fraction(-3))
CASES = {
    "in-line five on unequal stations": Case(
        {"cylinders": 5, "stations": UNEQUAL}, places(5, stations=UNEQUAL)
    ),
    "two-stroke six on unequal stations": Case(
        {"cylinders": 6, "strokes": 2, "stations": WIDE}, places(6, stations=WIDE)
    ),
    "in-line six": Case({"cylinders": 6}, places(6)),
    "vee eight": Case({"cylinders": 8, "banks": [-45, 45]}, places(8, (-45, 45))),
    "vee six on offset pins": Case(
        {"cylinders": 6, "banks": [-30, 30], "pins": "offset"},
        places(6, (-30, 30), offset=-60),
    ),
    "vee six of 90 on offset pins": Case(
        {"cylinders": 6, "banks": [-45, 45], "pins": "offset:-30"},
        places(6, (-45, 45), offset=-30),
    ),
    "vee four on split pins": Case(
        {"cylinders": 4, "banks": [-30, 30], "pins": "split"},
        places(4, (-30, 30), pins="split"),
    ),
    "boxer four": Case(
        {"cylinders": 4, "banks": [-90, 90], "pins": "split"},
        places(4, (-90, 90), pins="split", apart=Fraction(1, 2)),
    ),
    "boxer six": Case(
        {"cylinders": 6, "banks": [-90, 90], "pins": "split"},
        places(6, (-90, 90), pins="split", apart=Fraction(1, 2)),
    ),
    "radial of two rows": Case(
        {"cylinders": 10, "banks": [0, 72, 144, 216, 288]}, places(10, (0, 72, 144, 216, 288))
    ),
    "radial two-stroke of four rows": Case(
        {"cylinders": 12, "banks": [0, 120, 240], "strokes": 2}, places(12, (0, 120, 240))
    ),
    "w twelve": Case({"cylinders": 12, "banks": [-60, 0, 60]}, places(12, (-60, 0, 60))),
    "vee six that fires unevenly": Case(
        {"cylinders": 6, "banks": [-45, 45], "intervals": [150, 90]}, places(6, (-45, 45))
    ),
    "in-line four that fires unevenly": Case(
        {"cylinders": 4, "intervals": [180, 270, 180, 90]}, places(4)
    ),
    "two-stroke four whose intervals have no mirror image": Case(
        {"cylinders": 4, "strokes": 2, "intervals": [80, 100, 60, 120]}, places(4)
    ),
    "grid of 90": Case({"cylinders": 5, "intervals": "any", "grid": 90}, places(5)),
    "grid of 10": Case({"cylinders": 3, "intervals": "any", "grid": 10}, places(3)),
    "even firing on a grid of 90": Case({"cylinders": 8, "grid": 90}, places(8)),
    "even firing on a grid of 60": Case({"cylinders": 6, "strokes": 2, "grid": 60}, places(6)),
    "split pins on a grid that the banks are not on": Case(
        {"cylinders": 4, "banks": [-30, 30], "pins": "split", "intervals": "any", "grid": 90},
        places(4, (-30, 30), pins="split"),
    ),
    "w six on a grid": Case(
        {"cylinders": 6, "banks": [-40, 0, 40], "intervals": "any", "grid": 90},
        places(6, (-40, 0, 40)),
    ),
}
SLOW = {"w twelve", "boxer six", "vee eight", "radial of two rows", "in-line six", "grid of 10"}
SLOW |= {
    "even firing on a grid of 90",
    "even firing on a grid of 60",
    "two-stroke six on unequal stations",
    "radial two-stroke of four rows",
}
NAMED = [pytest.param(name, marks=pytest.mark.slow if name in SLOW else ()) for name in CASES]


def three(counts: Any) -> tuple[int, int, int]:
    return counts.cranks, counts.stars, counts.classes


@pytest.mark.parametrize("name", NAMED)
def test_cranks_stars_and_classes_are_counted(name: str) -> None:
    case = CASES[name]
    cranks = case.cranks()
    result = search_cranks(**case.question, compiled=False)
    assert cranks
    assert three(result.searched) == three(result.found) == case.counts(cranks)


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_the_compiled_walk_is_the_same_walk(name: str) -> None:
    """Counts, front, stars and every branch cut, of each question that brute force judges here."""
    case = CASES[name]
    cranks = case.cranks()
    asked: list[dict[str, Any]] = [
        {"minimize": ["couple.1", "bending"]},
        {"minimize": ["force.2", "couple.2"], "limit": ["bearing<=3/4"]},
        {"require": ["couple.1=0"]},
    ]
    for more in asked:
        compiled, plain = (
            search_cranks(**case.question, **more, compiled=one).data() for one in (True, False)
        )
        assert compiled == plain
    free = search_cranks(**case.question, compiled=True)
    assert three(free.searched) == three(free.found) == case.counts(cranks)


@pytest.mark.parametrize("name", NAMED)
def test_every_quantity_is_that_of_the_throws(name: str) -> None:
    """Of each class that a search lists: forces, couples, bending and bearing load, from its throws."""
    case = CASES[name]
    names = ("force.1", "force.2", "couple.1", "couple.2", "couple.3", "bending", "bearing")
    asked = {"limit": [f"{one}<=1000" for one in names], "listed": EVERY}
    result = search_cranks(**case.question, **asked, compiled=False)
    assert len(result.items) == result.found.classes
    for star in result.items:
        crank = tuple(throw % 360 for throw in star.throws)
        for one in names:
            kind, _, order = one.partition(".")
            if order:
                expected = case.shaking(crank, int(order), kind == "couple")
            else:
                expected = {"bending": case.bending, "bearing": case.bearing}[kind](crank)
            assert float(star.values[one].near) == pytest.approx(expected, abs=NEAR), (one, crank)


@pytest.mark.parametrize("name", NAMED)
@pytest.mark.parametrize("kind", ["bending", "bearing"])
def test_the_least_is_the_least_of_all(name: str, kind: str) -> None:
    """The best of all cranks, and how many attain it; then how many meet a limit just above it."""
    case = CASES[name]
    sizes = {crank: getattr(case, kind)(crank) for crank in case.cranks()}
    least = min(sizes.values())
    result = search_cranks(**case.question, minimize=[kind], compiled=False)
    best = {crank for crank, size in sizes.items() if size < least + NEAR}
    assert float(result[0].values[kind].near) == pytest.approx(least, abs=NEAR)
    assert three(result.points[0].counts) == case.counts(best)
    limit = Fraction(sorted(sizes.values())[len(sizes) // 2]).limit_denominator(100) + Fraction(1, 997)
    some = search_cranks(**case.question, limit=[f"{kind}<={limit}"], compiled=False)
    assert three(some.found) == case.counts({crank for crank, size in sizes.items() if size <= limit})


EVEN = [
    param
    for param in NAMED
    if CASES[str(param.values[0])].question.get("intervals") != "any"
    and len(CASES[str(param.values[0])].places) < 9
]


@pytest.mark.parametrize("name", EVEN)
def test_torsion_and_neighbours_of_every_firing_order(name: str) -> None:
    """Firing orders by trying both turns for each cylinder; half orders too, with mode shapes given."""
    case = CASES[name]
    count, banks = len(case.places), len(case.question.get("banks", [0]))
    modes = [
        [Fraction(10 - 3 * n, 10) for n in range(count)],
        [Fraction((n * n) % 7 - 3, 4) for n in range(count)],
    ]
    orders = ("1", "2", "3") if case.cycle == 360 else ("1/2", "1", "5/2", "3")
    best: dict[str, float] = {}
    total = 0
    for crank in case.cranks():
        for moments in case.firings(crank):
            total += 1
            at = np.radians(np.array([float(t) for t in moments]))
            sequence = [int(n) for n in np.argsort(at)]
            follow = zip(sequence, [*sequence[1:], sequence[0]], strict=True)
            sizes = {"adjacent": float(sum(abs(a - b) == banks for a, b in follow))}
            for order in orders:
                for k, mode in enumerate(modes, 1):
                    turned = np.exp(1j * float(Fraction(order)) * at)
                    size = abs(np.array([float(a) for a in mode]) @ turned)
                    sizes[f"torsion.{float(Fraction(order)):g}:{k}"] = float(size)
            for one, size in sizes.items():
                best[one] = min(best.get(one, size), size)
    for one, least in best.items():
        result = search_cranks(**case.question, minimize=[one], modes=modes, compiled=False)
        assert float(result[0].values[one].near) == pytest.approx(least, abs=NEAR), one
    everything = search_cranks(**case.question, compiled=False)
    # Each star stands for itself and its mirror image, which fire in as many ways.
    per_star = total / everything.searched.cranks
    assert everything.firings == per_star * everything.searched.stars


def test_many_cylinders_at_any_intervals_are_searched_where_no_firing_order_matters() -> None:
    """Fourteen on a flat crank: each of thirteen throws is up or down, and fires in either turn."""
    ups = np.array(list(product((1, -1), repeat=13)))
    cranks = np.concatenate([np.ones((len(ups), 1)), ups], axis=1)
    levers = np.arange(6.5, -7, -1)
    balanced = (cranks.sum(1) == 0) & (cranks @ levers == 0)
    result = search_cranks(
        14, intervals="any", grid=180, require=["force.1=0", "couple.1=0"], compiled=False
    )
    assert result.searched.cranks == 2**13
    assert result.found.cranks == int(balanced.sum())
    assert result.firings == result.found.stars * 2**13


def test_counterweights_and_shafts_leave_what_they_leave() -> None:
    """After counterweights half of order 1 remains, that which turns backward; after shafts nothing."""
    for name in ("in-line five on unequal stations", "vee four on split pins", "boxer four"):
        case = CASES[name]
        names = ("force.1", "couple.1", "couple.2")
        asked: dict[str, Any] = {"limit": [f"{one}<=1000" for one in names], "listed": EVERY}
        asked |= {"compiled": False, **case.question}
        for star in search_cranks(after="counterweights", **asked).items:
            for one in names:
                kind, _, order = one.partition(".")
                kept = 0.0 if order == "1" else 1.0
                size = case.shaking(star.throws, int(order), kind == "couple", kept)
                assert float(star.values[one].near) == pytest.approx(size, abs=NEAR)
        for star in search_cranks(after=("balance-shafts", 1), **asked).items:
            assert star.values["force.1"].is_zero()
            assert star.values["couple.1"].is_zero()
            size = case.shaking(star.throws, 2, True)
            assert float(star.values["couple.2"].near) == pytest.approx(size, abs=NEAR)


@pytest.mark.parametrize(("name", "least"), [("in-line five", 8), ("boxer four", 1)])
def test_counterweights_leave_what_a_design_with_them_leaves(name: str, least: int) -> None:
    """The couple of every class after counterweights, against the design of its engine."""
    question = {"in-line five": {"cylinders": 5}, "boxer four": CASES["boxer four"].question}[name]
    asked: dict[str, Any] = {"limit": ["couple.1<=1000"], "listed": EVERY, "compiled": False}
    stars = search_cranks(after="counterweights", **asked, **question).items
    assert len(stars) >= least
    for star in stars:
        design = sb.design_balance(star.engine, [1], shafts=0)
        remaining = design.remains.couple.terms
        size = sum(float(remaining[n].size(30)) for n in (1, -1) if n in remaining)
        assert float(star.values["couple.1"].near) == pytest.approx(size, abs=NEAR)
        whole = sb.design_balance(star.engine, [1])
        assert not {1, -1} & set(whole.remains.couple.terms)
    for star in search_cranks(after=("balance-shafts", 1), **asked, **question).items:
        assert star.values["couple.1"].is_zero()
