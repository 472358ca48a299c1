"""Interface to knowledge of engines: the protocols that a caller of the checker implements.

Of itself the checker knows no engine. A caller hands in `Engines`, and the rest of the room sees no more
of an engine than these protocols: it could be a library of its own, for derivations of another field.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Protocol

from symbalance.document.formula import Equation
from symbalance.errors import SymbalanceError


class Turns(Protocol):
    """An angle in turns."""

    @property
    def turns(self) -> Fraction:
        """The angle over 360 degrees."""
        ...


class KnownCylinder(Protocol):
    """One cylinder: its number, the angle of its axis, how far its pin leads the axis, its place."""

    @property
    def number(self) -> int:
        """Its number."""
        ...

    @property
    def bank(self) -> Turns:
        """The angle of its axis."""
        ...

    @property
    def delay(self) -> Turns:
        """Its own crank angle at theta = 0."""
        ...

    @property
    def station(self) -> Fraction:
        """Its place along the crank, in pitches, positive towards the front."""
        ...


class KnownEngine(Protocol):
    """An engine: its cylinders, its rod ratio if known, the plane its couples are taken about."""

    @property
    def cylinders(self) -> Sequence[KnownCylinder]:
        """The cylinders."""
        ...

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio l/r."""
        ...

    @property
    def mean_station(self) -> Fraction:
        """The mean of all stations."""
        ...


class Engines(Protocol):
    """Knowledge of engines: by name, and of one cylinder's harmonics."""

    def engine(self, name: str, folder: Path) -> KnownEngine:
        """Return an engine by its name, or by its file in `folder`; refuse an unknown one."""
        ...

    def coefficient_terms(self, order: int, power: int) -> Mapping[int, Fraction]:
        """Return A_order of a piston's acceleration as power of r/l -> coefficient; empty if it is 0."""
        ...

    def mentions(self, text: str) -> Sequence[tuple[int, str]]:
        """Return the engines that a text speaks of by name or arrangement, each with where it does."""
        ...

    def coefficient_value(self, order: int, ratio: Fraction) -> Fraction:
        """Return A_order at a rod ratio l/r, to 30 digits; 0 if it is 0 whatever the ratio."""
        ...

    def equation(self, name: str) -> Equation:
        """Return a known equation between columns, in letters of its own; refuse an unknown one."""
        ...


class NoEngines:
    """No knowledge of engines: refuses every question."""

    def engine(self, name: str, folder: Path) -> KnownEngine:
        """Refuse."""
        raise self._refusal(f"engine = {name}")

    def coefficient_terms(self, order: int, power: int) -> Mapping[int, Fraction]:
        """Refuse."""
        raise self._refusal(f"A_{order}")

    def mentions(self, text: str) -> Sequence[tuple[int, str]]:
        """Return none."""
        return ()

    def coefficient_value(self, order: int, ratio: Fraction) -> Fraction:
        """Refuse."""
        raise self._refusal(f"A_{order}")

    def equation(self, name: str) -> Equation:
        """Refuse."""
        raise self._refusal(f"quantity = {name}")

    @staticmethod
    def _refusal(what: str) -> SymbalanceError:
        rule, remedy = "needs what is known of engines, and none was handed in", "use symbalance.check"
        return SymbalanceError(what, rule, remedy)


@dataclass(frozen=True)
class Sources:
    """Where a document's engines are looked up: what knows them, and the folder their files are in."""

    engines: Engines = field(default_factory=NoEngines)
    folder: Path = Path()
