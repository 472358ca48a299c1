"""Facts that a derivation's step may use: meanings of letters, earlier definitions, assumptions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from symbalance.document.formula import Formula, names
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.checking.geometry import Geometry


@dataclass(frozen=True, slots=True)
class Definition:
    """A letter's value by the document, and the line that says so."""

    node: Formula
    line: int
    numeric: bool = False


@dataclass(frozen=True, slots=True)
class Assumption:
    """An assumption of the sidecar, solved for a letter."""

    text: str
    name: str
    node: Formula


@dataclass(frozen=True, slots=True)
class Level:
    """One choice of what to use: the letters' values, and the assumptions that this rests on."""

    values: Mapping[str, Formula]
    assumptions: tuple[str, ...] = ()


@dataclass(frozen=True)
class Knowledge:
    """Everything a step may use at its line."""

    meaning: SymbolValue = field(default_factory=SymbolValue)
    crank: Geometry | None = None
    definitions: Mapping[str, Definition] = field(default_factory=dict)
    assumptions: tuple[Assumption, ...] = ()
    letters: frozenset[str] = frozenset()
    moving: frozenset[str] = frozenset()
    """Letters whose meaning is a motion or a force: left alone where a step holds without."""
    angles: frozenset[str] = frozenset()
    meanings: Mapping[str, str] = field(default_factory=dict)
    """What the letters are declared to be, in words."""
    universal: frozenset[str] = frozenset()
    """Letters that stay free although a line gives them a number: crank angle, rod angle, time."""

    def levels(self, *nodes: Formula) -> Iterator[Level]:
        """Yield what may be used, least first: nothing, meanings and definitions, then assumptions."""
        yield Level({})
        number = any(not names(node) for node in nodes)
        defined_values = {
            name: d.node
            for name, d in self.definitions.items()
            if not (d.numeric and name in self.universal and not number)
        }
        values = {**defined_values, **self.meaning.values}
        if number:  # a numeric example: the numbers of the letters in which the geometry is written
            values |= {name: d.node for name, d in self.definitions.items() if d.numeric}
        light = {name: node for name, node in values.items() if name not in self.moving}
        if defined_values and len(light) < len(values):
            yield Level(light)
        if values:
            yield Level(values)
        for assumption in self.assumptions:
            yield Level({**values, assumption.name: assumption.node}, (assumption.text,))
        if len(self.assumptions) > 1:
            all_values = {assumption.name: assumption.node for assumption in self.assumptions}
            yield Level({**values, **all_values}, tuple(a.text for a in self.assumptions))

    def evaluator(self, level: Level) -> FormEvaluator:
        """Return an evaluator in a fresh domain for a level."""
        known = {**{name: d.node for name, d in self.definitions.items()}, **self.meaning.values}
        meaning = replace(self.meaning, values=level.values, known=known)
        return FormEvaluator(meaning.domain(), meaning)

    def knows(self, name: str) -> bool:
        """Tell whether a letter has a value."""
        return name in self.meaning.values or name in self.definitions or self.assumes(name)

    def assumes(self, name: str) -> bool:
        """Tell whether an assumption gives a letter its value."""
        return any(assumption.name == name for assumption in self.assumptions)

    def has_meaning(self, name: str) -> bool:
        """Tell whether a letter has a value, or a meaning that relates it to others."""
        return self.knows(name) or self.measures(name) or name in self.universal

    def measures(self, name: str) -> bool:
        """Tell whether the geometry is written in this letter."""
        if self.crank is None:
            return False
        parts = (
            self.crank.theta,
            self.crank.radius,
            self.crank.length,
            self.crank.omega,
            self.crank.mass,
        )
        return any(name in names(part) for part in parts)
