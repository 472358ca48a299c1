"""Several engines side by side: what each leaves free, how it fires, what would balance it.

A line is what a handbook has of an engine: the largest value over a turn of every order of its free force
and couple, the degrees between firings, and what balances the first and the second order. A part of
order n that turns with the crank (+n) or against it (-n) needs something that turns at its own speed: a
counterweight at +1, a balance shaft at any other (`symbalance.design.balancing.designs` has the proof).

The end of the vector of one order runs round an ellipse. Its parts turn with and against the crank; twice
in a turn of theirs they point the same way, so its largest value is

    |forward| + |backward|,

which is the amplitude itself of a vector that only turns, or only swings up and down.

Values are geometry, in units of each order's own F_n = A_n m r omega^2, or in per cent of the first
order of one piston, m r omega^2 of cylinder 1, which takes a rod ratio. Cylinders that differ have no A_n
in common: with one such engine in the table all of it is in per cent.

At a speed (`EngineComparison.at`) every value is in N and N m too, each engine's with its own sizes, and
so is the largest of all orders together over a turn, which is no sum: orders are not largest at once.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar, Unpack

from symbalance.design.balancing.order_selection import parts_of
from symbalance.document.result import SequenceResult
from symbalance.engine.engine import Engine, checked_engine
from symbalance.engine.engine_document import firing_intervals
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.spectrum import COMPONENTS, Component
from symbalance.forces.balance_data import KEYS, largest_data, resultant_data
from symbalance.forces.free_forces import Balance, Resultant, balance
from symbalance.forces.operating_point import SIZES, UNITS, OperatingPoint, Sizes, check_size_names
from symbalance.forces.turn_maximum import TurnMaximum
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.numbers import as_list, decimal_text
from symbalance.text.reals import Real

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

MOST_ENGINES = 200
"""Lines of one table."""
BALANCED_ORDERS = (1, 2)
"""The orders that are balanced in practice: those `design` takes where it is told no others."""
KINDS = ("force", "couple")
DIRECTIONS = ("vertical", "lateral")
DIGITS = 20

Place = tuple[str, int]
"""Force or couple, and the order: what a column is about."""

T = TypeVar("T")


@dataclass(frozen=True)
class ComparedEngine:
    """A line of a comparison: an engine's balance, how it fires, what balances its first two orders."""

    balance: Balance

    @property
    def engine(self) -> Engine:
        """The engine the line is about."""
        return self.balance.engine

    @cached_property
    def firing_intervals(self) -> tuple[Fraction, ...] | None:
        """The degrees of the crank after each firing, None where no firing order is known."""
        if self.engine.firing_order() is None:
            return None
        return tuple(firing_intervals(self.engine))

    @cached_property
    def speeds(self) -> tuple[int, ...]:
        """What must turn to balance orders 1 and 2: speeds over the crank's, +1 a counterweight."""
        return tuple(parts_of(self._low, BALANCED_ORDERS))

    @property
    def counterweights(self) -> bool:
        """Whether counterweights on the crank serve a part of the first order."""
        return 1 in self.speeds

    @property
    def shafts(self) -> tuple[int, ...]:
        """The speeds of the balance shafts it takes, negative against the crank."""
        return tuple(speed for speed in self.speeds if speed != 1)

    @cached_property
    def _low(self) -> Balance:
        highest = BALANCED_ORDERS[-1]
        return self.balance if self.balance.highest >= highest else balance(self.engine, highest)

    def resultant(self, place: Place) -> Resultant:
        """Return one order of the force or the couple, with its components."""
        kind, order = place
        return Resultant(self.balance.force if kind == "force" else self.balance.couple, order)

    def motion(self, place: Place) -> str:
        """Return how the vector of an order moves.

        "none", "vertical", "lateral", "forward" or "backward" where it turns with or against the crank at
        one size, else "ellipse".
        """
        vector = self.resultant(place)
        if vector.is_zero():
            return "none"
        zero = {name for name in COMPONENTS if vector.component(name).is_zero()}
        only = (("lateral", "vertical"), ("vertical", "lateral"), ("backward", "forward"))
        other = (*only, ("forward", "backward"))
        return next((name for missing, name in other if missing in zero), "ellipse")

    def largest(self, place: Place) -> tuple[Component, ...]:
        """Return the components whose amplitudes add up to an order's largest value over a turn."""
        motion, vector = self.motion(place), self.resultant(place)
        if motion == "none":
            return ()
        return (vector.forward, vector.backward) if motion == "ellipse" else (vector.component(motion),)

    def size(self, place: Place) -> Real | None:
        """Return an order's largest value in decimals, in its own unit; None with symbols in it."""
        parts = self.largest(place)
        if any(part.number.has_symbols for part in parts):
            return None
        return sum((part.number.size(DIGITS + 10) for part in parts), Real(0))

    def factor(self, order: int) -> Real | None:
        """Return A_n in decimals, 1 where components hold the kinematics; None without a rod ratio."""
        return Real(1) if self.balance.kinematics is None else self.balance.values.get(order)

    def percent(self, place: Place) -> Real | None:
        """Return an order's largest value in per cent of m r omega^2 (a); None if it is not known."""
        size, factor = self.size(place), self.factor(place[1])
        if size is not None and not size:
            return size
        return None if size is None or factor is None else 100 * size * abs(factor)

    @property
    def operating_point(self) -> OperatingPoint | None:
        """The engine's speed and sizes, None where values in N and N m are not asked for."""
        return self.balance.operating_point

    def newtons(self, place: Place) -> Real | None:
        """Return an order's largest value in N, a couple's in N m; None with symbols in it."""
        percent = self.percent(place)
        if not percent:
            return percent
        return percent / 100 * self.balance.unit_value(place[0])

    def all_orders(self, kind: str) -> TurnMaximum | None:
        """Return the largest of all orders together over a turn, in N or N m; None with symbols in it."""
        if self.engine.has_symbols:
            return None
        # Where no pitch is known no order of the couple is free: the operating point sees to that.
        return self.balance.turn_maxima.get(kind, TurnMaximum(0.0, 0.0, 0.0))


@dataclass(frozen=True, repr=False, eq=False)
class EngineComparison(SequenceResult[ComparedEngine]):
    """Several engines to one `order`, a line each; `percent` of one piston's first order, or in F_n.

    With `phases` the document has every order as a cosine too, as handbooks print it.

    >>> from symbalance.engine.catalogue import load
    >>> table = compare([load("inline-3"), load("inline-4"), load("v12-60")], 6)
    >>> [line.speeds for line in table]
    [(1, -1, 2, -2), (2, -2), ()]
    >>> float(table[1].size(("force", 2))), table[1].motion(("force", 2))
    (4.0, 'vertical')
    """

    items: tuple[ComparedEngine, ...]
    order: int
    percent: bool = False
    phases: bool = False
    kind: ClassVar[str] = "comparison"
    record_keys: ClassVar[tuple[str, ...]] = (
        *("engine", "of", "order", "motion", "largest", "percent", "unit"),
    )

    def summary(self) -> str:
        """Return what is compared, in one line."""
        names = ", ".join(line.engine.name for line in self.items[:6])
        more = f" and {len(self) - 6} more" if len(self) > 6 else ""
        return f"Comparison to order {self.order} of {names}{more}"

    def at(self, *, rpm: object, **sizes: Unpack[Sizes]) -> EngineComparison:
        """Return the same comparison with values in N and N m too, at a speed.

        `stroke`, `rod`, `pitch`, `bore` (mm) and `mass` (kg, of one cylinder's reciprocating parts) are
        for those engines that lack them.

        >>> from symbalance.engine.catalogue import load
        >>> table = compare([load("inline-4"), load("vq30de")], 2)
        >>> four, six = table.at(rpm=6000, stroke=80, mass="0.5")
        >>> round(four.newtons(("force", 2))), round(six.newtons(("couple", 1)))
        (8023, 1577)
        """
        return replace(self, items=tuple(_at(line, rpm, sizes) for line in self))

    @property
    def rpm(self) -> Fraction | None:
        """The speed that values in N and N m are for; None where they are not asked for."""
        point = self.items[0].operating_point
        return None if point is None else point.rpm

    @cached_property
    def places(self) -> tuple[Place, ...]:
        """The columns: the orders of force and couple that some engine leaves free."""
        present = {
            (kind, n) for line in self for kind in KINDS for n in getattr(line.balance, kind).orders()
        }
        return tuple(sorted(present, key=lambda place: (KINDS.index(place[0]), place[1])))

    def document(self) -> Document:
        """Return the table, a line an engine, then how it is read."""
        from symbalance.design.comparison_document import comparison_document

        return comparison_document(self)

    def data(self) -> dict[str, Any]:
        """Return every engine's orders, exact numbers as strings that SymPy reads."""
        return {
            "order": self.order,
            "unit": "percent" if self.percent else "F_n",
            "engines": [self._line(line) for line in self],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each engine and each order of force and couple that some engine has."""
        return [
            {
                "engine": line.engine.name,
                "of": place[0],
                "order": place[1],
                "motion": line.motion(place),
                "largest": _float(line.size(place)),
                "percent": _float(line.percent(place)),
                "unit": "m r omega^2" if line.balance.kinematics is None else "A_n m r omega^2",
            }
            | self._value_record(line, place)
            for line in self
            for place in self.places
        ] + [self._whole_record(line, kind) for line in self for kind in KINDS if self.rpm is not None]

    def _value_record(self, line: ComparedEngine, place: Place) -> dict[str, Any]:
        """Return the rest of a row, at a speed alone."""
        if self.rpm is None:
            return {}
        value, unit = _float(line.newtons(place)), UNITS[place[0]]
        return {"rpm": float(self.rpm), "value": value, "value_unit": unit}

    def _whole_record(self, line: ComparedEngine, kind: str) -> dict[str, Any]:
        """Return the row of all orders together."""
        assert self.rpm is not None
        top = line.all_orders(kind)
        return {
            **dict.fromkeys(self.record_keys),
            **{"engine": line.engine.name, "of": kind, "motion": "all orders together"},
            **{"rpm": float(self.rpm), "value": top and top.value, "value_unit": UNITS[kind]},
        }

    def _line(self, line: ComparedEngine) -> dict[str, Any]:
        gaps, engine = line.firing_intervals, line.engine
        return {
            "engine": engine.name,
            "strokes": engine.strokes,
            "cylinders": len(engine.cylinders),
            "ratio": None if line.balance.ratio is None else str(line.balance.ratio),
            "unlike": line.balance.kinematics is None,
            "firing_intervals": None if gaps is None else list(map(str, gaps)),
            **({} if line.operating_point is None else {"operating_point": line.operating_point.data()}),
            "orders": list(self._orders(line)),
            **({} if self.rpm is None or engine.has_symbols else {"largest": largest_data(line.balance)}),
            "balanced_by": {"counterweights": line.counterweights, "shafts": list(line.shafts)},
        }

    def _orders(self, line: ComparedEngine) -> Iterator[dict[str, Any]]:
        for place in self.places:
            motion = line.motion(place)
            if motion == "none":
                continue
            size, percent, vector = line.size(place), line.percent(place), line.resultant(place)
            yield {
                "of": place[0],
                "order": str(place[1]),
                "motion": motion,
                "largest": " + ".join(part.form("amplitude").spelling for part in line.largest(place)),
                "decimal": None if size is None else decimal_text(size, DIGITS),
                "percent": None if percent is None else decimal_text(percent, DIGITS),
                **self._newtons(line, place),
                **resultant_data(vector, line.balance, place[0], DIRECTIONS),
            }

    def _newtons(self, line: ComparedEngine, place: Place) -> dict[str, str | None]:
        """Return an order's largest value in N or N m, at a speed alone."""
        if self.rpm is None:
            return {}
        value = line.newtons(place)
        return {KEYS[place[0]]: None if value is None else decimal_text(value, DIGITS)}


def _at(line: ComparedEngine, rpm: object, sizes: Mapping[str, object]) -> ComparedEngine:
    """Return a line at a speed; what an engine lacks is refused with its name."""
    lacking = lacking_sizes(line.engine, sizes)
    try:
        return ComparedEngine(line.balance.at(rpm=rpm, **lacking))  # type: ignore[arg-type]
    except SymbalanceError as problem:
        raise problem.within(line.engine.name) from None


def lacking_sizes(engine: Engine, sizes: Mapping[str, T]) -> dict[str, T]:
    """Return those sizes that an engine does not have: its own count before what is said for several.

    >>> from symbalance.engine.catalogue import load
    >>> [lacking_sizes(load(name), {"mass": 1, "pitch": 90}) for name in ("vq30de", "inline-4")]
    [{}, {'mass': 1, 'pitch': 90}]
    """
    of_engine = {"pitch": engine.pitch, "bore": engine.bore}
    check_size_names(sizes)
    return {
        name: value
        for name, value in sizes.items()
        if (of_engine[name] if name in of_engine else getattr(engine.first.sizes, SIZES[name])) is None
    }


def _float(number: Real | None) -> float | None:
    return None if number is None else float(number)


def compare(
    engines: Sequence[Engine],
    order: int = 12,
    *,
    ratio: object = None,
    percent: bool = False,
    phases: bool = False,
) -> EngineComparison:
    """Return several engines side by side: free forces and couples, firing intervals, what balances them.

    Values are the largest over a turn, in F_n = A_n m r omega^2 (couples F_n a), or with `percent` in per
    cent of one piston's first order; so they are too where an engine's cylinders are unlike. `ratio`
    overrides the engines' rod ratio lambda = l/r; `phases` has every order as a cosine too.

    >>> from symbalance.engine.catalogue import load
    >>> print(compare([load("v8-90"), load("v8-90-flat")], 4))
    Comparison to order 4 of v8-90, v8-90-flat
    """
    checked_order(order)
    several = as_list(engines, "engines", '[load("v8-90"), load("v12-60")]')
    if not 1 <= len(several) <= MOST_ENGINES:
        rule = f"must be 1 to {MOST_ENGINES} engines"
        raise SymbalanceError(f"engines = {brief(several)}", rule, "name those to compare")
    lines = tuple(ComparedEngine(balance(checked_engine(each, ratio), order)) for each in several)
    unlike = any(line.balance.kinematics is None for line in lines)
    return EngineComparison(lines, order, bool(percent) or unlike, bool(phases))
