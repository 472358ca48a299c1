"""The result of a search: three counts, the front with its stars, and what was cut by which bound."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import SequenceResult
from symbalance.engine.engine import Engine
from symbalance.search.counting import Counts
from symbalance.search.magnitudes import DIGITS, Magnitude
from symbalance.search.objectives import After, Condition
from symbalance.search.problem import SearchProblem
from symbalance.search.subtrees import Tally
from symbalance.text.numbers import decimal_text

if TYPE_CHECKING:
    from symbalance.document.nodes import Document
    from symbalance.document.shapes import Drawing


@dataclass(frozen=True, eq=False)
class SearchStar:
    """A crank with a firing order, the first of its class, and what was asked of it.

    `rays` holds the ray of each pin, `firing_order` is empty where cylinders may fire at any moments and
    nothing depends on it; `firings` counts the firing orders of the star that attain the same.
    """

    problem: SearchProblem
    rays: tuple[int, ...]
    firing_order: tuple[int, ...]
    fires: Mapping[int, Fraction]
    firings: int
    values: Mapping[str, Magnitude]

    @property
    def throws(self) -> tuple[Fraction, ...]:
        """The throws in degrees, by cylinder number, cylinder 1 at its top dead centre."""
        throws = self.problem.throws(self.rays)
        return tuple(throws[number] * 360 for number in sorted(throws))

    @cached_property
    def engine(self) -> Engine:
        """The engine: its free forces are those of the star."""
        order = "-".join(map(str, self.firing_order or self.rays))
        return self.problem.engine(self.rays, dict(self.fires), f"search-{order}")

    def as_text(self) -> str:
        """Return the firing order as it is written: 1-3-4-2."""
        return "-".join(map(str, self.firing_order))


@dataclass(frozen=True, eq=False)
class SearchPoint:
    """A point of the front: how many attain its values, and the first of them."""

    counts: Counts
    stars: tuple[SearchStar, ...]


@dataclass(frozen=True, repr=False, eq=False)
class CrankSearch(SequenceResult[SearchStar]):
    """What a search over all cranks comes to; its items are the stars that are named, best first."""

    problem: SearchProblem
    conditions: tuple[Condition, ...]
    minimized: tuple[str, ...]
    after: After
    modes: tuple[tuple[Fraction, ...], ...]
    searched: Counts
    found: Counts
    firings: int
    """Firing orders of the stars that meet every condition."""
    quantities: tuple[str, ...]
    points: tuple[SearchPoint, ...]
    tally: Tally
    bounds: tuple[str, ...]
    """The quantities whose bounds may cut, in the order of the tally."""
    parts: int
    front_matters: bool
    """Whether a view from the rear counts as another crank, as given mode shapes have it."""
    links: Mapping[str, str] = field(default_factory=dict)
    """Where the files of some stars' engines are, by the engine's name: what points of a picture open."""
    kind: ClassVar[str] = "search"
    record_keys: ClassVar[tuple[str, ...]] = ("firing_order", "throws_degrees")

    @cached_property
    def items(self) -> tuple[SearchStar, ...]:  # type: ignore[override]
        """The stars, point by point."""
        return tuple(star for point in self.points for star in point.stars)

    def summary(self) -> str:
        """Return the question and how many stars answer it, in one line."""
        searched = f"{self.searched.stars:,} stars"
        if not self.found.stars:
            return f"Search of {self.problem.words()}: none of {searched}, proved"
        front = ""
        if self.minimized:
            front = f"; front of {len(self.points)} point{'s' if len(self.points) > 1 else ''}"
        return f"Search of {self.problem.words()}: {self.found.stars:,} of {searched}{front}"

    def document(self) -> Document:
        """Return the counts, the front as a table and a picture, and what was cut."""
        from symbalance.search.search_document import search_document

        return search_document(self)

    def drawing(self) -> Drawing | None:
        """Return the front as a picture, one quantity against another; None for fewer than two points."""
        from symbalance.search.search_document import front_drawing

        return front_drawing(self)

    def data(self) -> dict[str, Any]:
        """Return the counts, the points with their stars, and what was cut."""
        return {
            "question": {
                "cylinders": self.problem.cylinders,
                "strokes": self.problem.strokes,
                "banks": list(map(str, self.problem.banks)),
                "pins": self.problem.pins,
                "pin_offset": str(self.problem.pin_offset),
                "intervals": self._intervals(),
                "grid": None if self.problem.grid is None else str(self.problem.grid),
                "stations": list(map(str, self.problem.stations)),
                "require": [c.words() for c in self.conditions if c.exactly],
                "limit": [c.words() for c in self.conditions if not c.exactly],
                "minimize": list(self.minimized),
                "after": self.after.words() or None,
                "modes": [list(map(str, mode)) for mode in self.modes],
            },
            "searched": self.searched.stars,
            "found": self.found.stars,
            "classes": self.found.classes,
            "counts": {"searched": self.searched.data(), "found": self.found.data()},
            "firing_orders": self.firings,
            "rear_is_the_same": not self.front_matters,
            "points": [{**point.counts.data(), "listed": len(point.stars)} for point in self.points],
            "stars": [
                {
                    "point": place,
                    "firing_order": list(star.firing_order),
                    "firing_orders": star.firings,
                    "throws": list(map(str, star.throws)),
                    **_by_kind(star.values),
                }
                for place, point in enumerate(self.points, 1)
                for star in point.stars
            ],
            "walk": {
                "parts": self.parts,
                "nodes": self.tally.nodes,
                "complete_classes": self.tally.leaves,
                "cut": dict(zip(self.bounds, self.tally.cuts, strict=True)),
            },
        }

    def _intervals(self) -> Any:
        if self.problem.is_any:
            return "any"
        return "even" if self.problem.intervals is None else list(map(str, self.problem.intervals))

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each star that is named."""
        kinds = [name.partition(".")[0] for name in self.quantities]
        names = sorted(self.quantities, key=lambda name: kinds.index(name.partition(".")[0]))
        return [
            {
                "point": place,
                "firing_order": star.as_text(),
                "throws_degrees": " ".join(map(str, star.throws)),
                **{name: float(star.values[name].near) for name in names if name in star.values},
            }
            for place, point in enumerate(self.points, 1)
            for star in point.stars
        ]


def _by_kind(values: Mapping[str, Magnitude]) -> dict[str, dict[str, dict[str, str]]]:
    """Return exact values and decimals by kind and order: couple → 1 → exact, decimal."""
    grouped: dict[str, dict[str, dict[str, str]]] = {}
    for name, value in values.items():
        kind, _, order = name.partition(".")
        near = "0" if value.is_zero() else decimal_text(value.near, DIGITS)
        grouped.setdefault(kind, {})[order or "value"] = {"exact": value.spelling, "decimal": near}
    return grouped
