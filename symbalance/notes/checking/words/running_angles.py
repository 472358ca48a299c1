r"""Angles that run: in the middle of the stroke, θ = 90°, is one place of the crank and not what θ is.

A letter that stood in a sine or cosine above takes every value there. The number that a sentence gives
it later is that of a moment and ends with its section, whatever words stand before it, and so does the
angle that an equation of constants has, cos θ = (√(1 + 8 λ²) - 1)/(4 λ). By another angle that runs it
is no moment: sin β = λ sin θ.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import cached_property

from symbalance.document.formula import Constant, Name, Number, walk
from symbalance.document.letters import is_greek
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.reading.equations import Chain

_RUNNING = frozenset({"theta", "vartheta", "phi", "varphi", "psi"})
"""Letters of crank and rod angles; another Greek letter runs where the page gives it several values."""


class RunningAngles:
    """The letters within waves of a page, each with the place where it first stands there."""

    def __init__(self, in_order: Sequence[Chain]) -> None:
        self._chains = in_order

    @property
    def letters(self) -> frozenset[str]:
        """The letters that stand within waves anywhere on the page."""
        return frozenset(self._first_waves)

    def is_at_place(self, chain: Chain) -> bool:
        """Tell whether a relation gives an angle that runs above it one of its values."""
        name = angle_placed(chain)
        return bool(name) and self._runs(name, chain.start)

    def is_of_a_moment(self, name: str, behind: Collection[str], place: int) -> bool:
        """Tell whether a letter that runs above a place gets one value there, by constants alone."""
        return self._runs(name, place) and not self._first_waves.keys() & set(behind) - {name}

    def _runs(self, name: str, place: int) -> bool:
        is_above = self._first_waves.get(name, place) < place
        return is_above and (name in _RUNNING or len(self._places.get(name, ())) > 1)

    @cached_property
    def _first_waves(self) -> dict[str, int]:
        first: dict[str, int] = {}
        for chain in self._chains:
            for name in {n for side in chain.sides for n in letters_in_waves(side.node)}:
                first.setdefault(name, chain.start)
        return first

    @cached_property
    def _places(self) -> dict[str, set[object]]:
        places: dict[str, set[object]] = {}
        for chain in self._chains:
            if name := angle_placed(chain):
                places.setdefault(name, set()).add(chain.sides[-1].node)
        return places


def angle_placed(chain: Chain) -> str:
    """Return the Greek letter that a relation puts at 0 or at so many degrees or π; "" for others."""
    letters = [s.node.name for s in chain.sides if isinstance(s.node, Name) and is_greek(s.node.name)]
    values = [part for side in chain.sides for part in walk(side.node)]
    is_angle = any(isinstance(part, Constant) and part.name == "pi" for part in values)
    is_zero = any(isinstance(side.node, Number) and not side.node.value for side in chain.sides)
    return letters[0] if letters and (is_angle or is_zero) else ""
