"""Sweep of an engine's sizes: forces, couples and torque on a full grid of values.

A quantity is named order by order: `force.2` is the largest value over a turn of the order-2 free force
in m r omega^2, `couple.1` that of the free couple in m r omega^2 a about the stations' mean, `torque.2`
the amplitude of the inertia torque in m r^2 omega^2. With `.vertical` or `.lateral` behind it, a force's
or a couple's amplitude along that axis. m and r are those of cylinder 1 at the point, a is its pitch.
At a speed every value is in N or N m instead, with the sizes of the point.

A planar vector c_n e^(i n theta) + c_-n e^(-i n theta) runs over an ellipse: its largest value is
|c_n| + |c_-n|, where both parts point the same way: with z of size Z and direction a, w of W and b,

    |z e^(i p) + w e^(-i p)|^2 = Z^2 + W^2 + 2 Z W cos(2 p + a - b).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from symbalance.document.result import SequenceResult
from symbalance.engine.engine import Engine, checked_engine
from symbalance.engine.variants import VARIABLES, varied_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.spectrum import Spectrum
from symbalance.forces.free_forces import Balance, balance
from symbalance.forces.operating_point import UNITS as NEWTON_UNITS
from symbalance.forces.operating_point import checked_rpm, operating_point
from symbalance.jobs.digests import digest
from symbalance.jobs.progress import Progress
from symbalance.jobs.running import Job, run_jobs
from symbalance.jobs.store import Store, key_of
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.numbers import as_list, decimal_text, exact, short_text
from symbalance.text.reals import Real, hypot
from symbalance.torque.inertia_balance import TorqueBalance, inertia_torque

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

DIGITS = 20
"""Of a value."""
MOST_POINTS = 100_000
UNITS = {"force": "m r ω²", "couple": "m r ω² a", "torque": "m r² ω²"}
AT_SPEED = {**NEWTON_UNITS, "torque": NEWTON_UNITS["couple"]}
_QUANTITY = re.compile(r"(force|couple)\.(\d{1,4})(?:\.(vertical|lateral))?|(torque)\.(\d{1,4})")


class Quantity(NamedTuple):
    """One number of an engine: what, of which order, and along which axis ("" is the whole)."""

    what: str
    order: int
    component: str = ""

    @property
    def name(self) -> str:
        """The name, as it is written."""
        return f"{self.what}.{self.order}" + (f".{self.component}" if self.component else "")


@dataclass(frozen=True)
class SweepPoint:
    """A point of the grid: the values that were set, and the quantities there, to 20 digits.

    `problem` says why there is no such engine; then every quantity is None.
    """

    settings: tuple[Fraction, ...]
    values: tuple[Real | None, ...]
    problem: str = ""


@dataclass(frozen=True, repr=False, eq=False)
class Sweep(SequenceResult[SweepPoint]):
    """Forces, couples and torque of an engine on a full grid of some of its sizes, the last fastest."""

    engine: Engine
    variables: tuple[str, ...]
    quantities: tuple[str, ...]
    items: tuple[SweepPoint, ...]
    rpm: Fraction | None = None
    """The speed that values in N and N m are for; None where they are in m r ω²."""
    kind: ClassVar[str] = "sweep"

    def summary(self) -> str:
        """Return what was varied, in one line."""
        points = f"{len(self.items)} points" if len(self.items) > 1 else "1 point"
        points += "" if self.rpm is None else f" at {short_text(self.rpm)} rpm"
        refused = f", {len(self.refused)} of them refused" if self.refused else ""
        return f"Sweep of {self.engine.name} over {', '.join(self.variables)}: {points}{refused}"

    def unit(self, quantity: str) -> str:
        """Return the unit of a quantity's values."""
        return (UNITS if self.rpm is None else AT_SPEED)[quantity.split(".", maxsplit=1)[0]]

    @property
    def refused(self) -> tuple[SweepPoint, ...]:
        """The points at which there is no such engine."""
        return tuple(point for point in self.items if point.problem)

    def document(self) -> Document:
        """Return a table with a row for each point of the grid."""
        from symbalance.design.variations.size_sweep_document import sweep_document

        return sweep_document(self)

    def data(self) -> dict[str, Any]:
        """Return every point: settings as exact fractions, values to 20 digits."""
        return {
            "engine": self.engine.name,
            **({} if self.rpm is None else {"rpm": str(self.rpm)}),
            "variables": [{"name": name, "unit": VARIABLES[name]} for name in self.variables],
            "quantities": [{"name": q, "unit": self.unit(q)} for q in self.quantities],
            "points": [
                {
                    "settings": list(map(str, point.settings)),
                    "values": [None if v is None else decimal_text(v, DIGITS) for v in point.values],
                    "problem": point.problem or None,
                }
                for point in self.items
            ],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each point: its settings, its quantities by name, at a speed its rpm."""
        return [
            {
                **dict(zip(self.variables, map(float, point.settings), strict=True)),
                **{
                    name: None if value is None else float(value)
                    for name, value in zip(self.quantities, point.values, strict=True)
                },
                **({} if self.rpm is None else {"rpm": float(self.rpm)}),
                "problem": point.problem,
            }
            for point in self.items
        ]


def sweep(
    engine: Engine,
    vary: Mapping[str, Iterable[object]],
    quantities: Iterable[str],
    *,
    rpm: object = None,
    workers: int = 1,
    executor: Executor | None = None,
    store: Store | str | Path | None = None,
    progress: Progress | None = None,
) -> Sweep:
    """Return forces, couples and torque of an engine on the full grid of the values to vary.

    `vary` maps some of ratio, bank (the angle between a vee's banks), offset, stroke, rod, pitch,
    reciprocating_mass and rotating_mass to their values; the last varies fastest. `quantities` are names
    such as force.2, couple.1.vertical or torque.2, as the head of this module says; with `rpm` they are
    in N and N m, for which the engine, or what varies, has stroke, mass and for couples pitch. Points are
    jobs: `workers` processes share them, or those behind an `executor`, with the same result; what a
    `store` (a folder) has of them is not computed again. A point at which there is no such engine says
    why, and stops no other.

    >>> from symbalance.engine.catalogue import load
    >>> opened = sweep(load("v2-90"), {"bank": [60, 90]}, ["force.1", "force.2"])
    >>> [round(row["force.1"], 6) for row in opened.records()]
    [1.5, 1.0]
    """
    checked_engine(engine)
    named = [read_quantity(name) for name in as_list(quantities, "quantities", '["force.1", "torque.2"]')]
    if not named:
        raise SymbalanceError("quantities = []", "must hold one at least", 'as in ["force.1"]')
    grid = _grid(vary)
    if isinstance(store, str | Path):
        store = Store(Path(store))
    speed = None if rpm is None else checked_rpm(rpm)
    of = "" if store is None else digest(engine)  # once: it costs more than a point
    jobs = [_job(engine, [*grid], settings, named, of, speed) for settings in product(*grid.values())]
    means = {"executor": executor, "workers": workers, "store": store, "progress": progress}
    points, failed = [], []
    for job, outcome in run_jobs(_point, jobs, **means):
        if outcome.problem is None:
            outcome.result(job.name)
        else:
            failed.append(outcome.problem)
        points.append(_sweep_point(job, outcome.value, outcome.problem, len(named)))
    if len(failed) == len(points):  # of nothing there is no table
        raise failed[0]
    return Sweep(engine, tuple(grid), tuple(q.name for q in named), tuple(points), speed)


def read_quantity(name: str) -> Quantity:
    """Return what a quantity's name means.

    >>> read_quantity("couple.1.vertical")
    Quantity(what='couple', order=1, component='vertical')
    """
    match = _QUANTITY.fullmatch(name) if isinstance(name, str) else None
    if match is None:
        rule = "is none: force, couple or torque, and an order"
        raise SymbalanceError(
            f"quantity = {brief(name)}", rule, "as force.2, couple.1.vertical, torque.2"
        )
    what, order, component, torque, torque_order = match.groups()
    return Quantity(what or torque, checked_order(int(order or torque_order)), component or "")


def _grid(vary: Mapping[str, Iterable[object]]) -> dict[str, list[Fraction]]:
    """Return the values of each variable, exactly; refused where there are none, too many, or twice."""
    if not isinstance(vary, Mapping) or not vary:
        remedy = 'as in {"ratio": [3, 4], "bank": [60, 90]}'
        raise SymbalanceError(f"vary = {brief(vary)}", "must map sizes to their values", remedy)
    grid: dict[str, list[Fraction]] = {}
    points = 1
    for name, values in vary.items():
        if name not in VARIABLES:
            remedy = f"one of {', '.join(VARIABLES)}"
            raise SymbalanceError(f"vary {brief(name)}", "is no size of an engine", remedy)
        grid[name] = [exact(value, name) for value in as_list(values, name, "[3, 3.5, 4]")]
        points *= len(grid[name])
        if not grid[name]:
            raise SymbalanceError(f"{name} = []", "must hold a value", "leave it out")
        if len({*grid[name]}) < len(grid[name]):
            twice = next(v for v in grid[name] if grid[name].count(v) > 1)
            raise SymbalanceError(f"{name} = {brief(twice)}", "is named twice", "name each value once")
    if points > MOST_POINTS:
        rule = f"are more than {MOST_POINTS}"
        raise SymbalanceError(f"{points} points", rule, "take larger steps, or vary less at once")
    return grid


def _job(
    engine: Engine,
    names: Sequence[str],
    settings: tuple[Fraction, ...],
    named: list[Quantity],
    of: str,
    speed: Fraction | None,
) -> Job:
    """Return the job of a point; `of` is a digest of the engine, "" where nothing is kept."""
    name = ", ".join(f"{k} = {short_text(v)}" for k, v in zip(names, settings, strict=True))
    at = () if speed is None else (speed,)  # without one a point's key is what it always was
    key = key_of("sweep", of, [*names], settings, [q.name for q in named], *at) if of else ""
    return Job(name, (engine, dict(zip(names, settings, strict=True)), named, speed), key)


def _point(value: tuple[Engine, Mapping[str, Fraction], list[Quantity], Fraction | None]) -> list[str]:
    """Return the quantities at a point, as decimals: what a store can hold."""
    engine, settings, quantities, speed = value
    varied = varied_engine(engine, settings)
    pushing = [q.order for q in quantities if q.what != "torque"]
    turning = [q.order for q in quantities if q.what == "torque"]
    free = balance(varied, max(pushing)) if pushing else None
    torque = inertia_torque(varied, max(turning)) if turning else None
    values = [_of_torque(torque, q) if q.what == "torque" else _of_balance(free, q) for q in quantities]
    if speed is not None:
        needs_pitch = any(q.what == "couple" and v for q, v in zip(quantities, values, strict=True))
        point = operating_point(varied, speed, needs_pitch=needs_pitch)
        units = {"force": point.force, "couple": point.couple, "torque": point.torque}
        # Without a pitch every couple is 0: so it is in N m.
        values = [v * (units[q.what] or 0) for q, v in zip(quantities, values, strict=True)]
    return [decimal_text(value, DIGITS) for value in values]


def _of_balance(free: Balance | None, quantity: Quantity) -> Real:
    """Return a quantity of a balance: its geometry times A_n, or with the kinematics in it."""
    assert free is not None
    spectrum = free.force if quantity.what == "force" else free.couple
    size = _size(spectrum, quantity)
    if not size or free.kinematics is None:
        return size
    if free.ratio is None:
        rule = "has no rod ratio, which a force's numbers need"
        raise SymbalanceError(free.engine.name, rule, "vary ratio, or give the engine one")
    return size * abs(free.values[quantity.order])


def _size(spectrum: Spectrum, quantity: Quantity) -> Real:
    order = quantity.order
    if quantity.component:
        return hypot(*spectrum.component(order, quantity.component).decimal(DIGITS + 10))
    parts = [spectrum.terms[n].size(DIGITS + 10) for n in (order, -order) if n in spectrum.terms]
    return sum(parts, Real(0, DIGITS + 10))


def _of_torque(torque: TorqueBalance | None, quantity: Quantity) -> Real:
    assert torque is not None
    if quantity.order not in torque.components:
        return Real(0)
    terms = {order: hypot(c, s) for order, c, s in torque.terms(digits=DIGITS + 10)}
    return terms[Fraction(quantity.order)]


def _sweep_point(
    job: Job, values: list[str] | None, problem: SymbalanceError | None, count: int
) -> SweepPoint:
    settings = tuple(job.value[1].values())
    if values is None:
        return SweepPoint(settings, (None,) * count, str(problem))
    return SweepPoint(settings, tuple(Real(value, DIGITS) for value in values))
