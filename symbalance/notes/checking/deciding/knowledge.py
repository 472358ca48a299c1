"""Facts that a derivation's step may use: meanings of letters, earlier definitions, assumptions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from symbalance.document.formula import Formula, Name, Quotient, Summation, names, parts_of_kind
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.checking.declared.geometry import Geometry
from symbalance.notes.checking.words.crank_angles_listed import CrankAngles


@dataclass(frozen=True, slots=True)
class Definition:
    """A letter's value by the document, and the line that says so."""

    node: Formula
    line: int
    numeric: bool = False
    assumption: str = ""
    """The premise as it is written, on which what uses it is conditional; "" for a definition."""
    alternatives: tuple[tuple[Formula, str], ...] = ()
    """The values on other branches, each with the condition under which the letter lies there."""
    solved: bool = False
    """Whether an equation was solved for the letter, which is a premise beside it."""
    branch: str = ""
    """The condition under which `node` is the value, where there are alternatives."""
    is_rod_angle: bool = False
    """Whether it is the angle of a connecting rod: then `node` is meant, and not the alternatives."""
    is_rough: bool = False
    """Whether its line says it with dots or ≈."""
    is_coefficient: bool = False
    """Whether it is a coefficient of a series: a line that gives it a value then claims something."""
    formula: Formula | None = None
    """What an earlier line has for a letter to which this one gives a number: U = m r/2, then 0.016."""
    rounded: Formula | None = None
    """The value as its line prints it, v = 2π·100 = 628.3: what follows may be computed from either."""


@dataclass(frozen=True, slots=True)
class StatedRange:
    """An inequality that a line states of letters."""

    left: Formula
    sign: str
    right: Formula
    line: int
    last_line: int | None = None
    """Where it ends, None where it reaches on: one in brackets is of the formula before it alone."""
    is_only_if: bool = False
    """Whether it is what something else takes ("only where s > 1"): it contradicts no value later."""

    @property
    def text(self) -> str:
        """The inequality as it is written."""
        sides = (formula_text(node, plain=True) for node in (self.left, self.right))
        return f" {self.sign} ".join(sides)


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
    is_of_formulas: bool = False
    """Whether the numbers of an example are left out, which make a witness and a correction unclear."""


@dataclass(frozen=True)
class Knowledge:
    """Everything a step may use at its line."""

    meaning: SymbolValue = field(default_factory=SymbolValue)
    crank: Geometry | None = None
    definitions: Mapping[str, Definition] = field(default_factory=dict)
    assumptions: tuple[Assumption, ...] = ()
    letters: frozenset[str] = frozenset()
    """Letters of which it is settled what they are: those that words only explain are in `meanings`."""
    moving: frozenset[str] = frozenset()
    """Letters whose meaning is a motion or a force: left alone where a step holds without."""
    angles: frozenset[str] = frozenset()
    meanings: Mapping[str, str] = field(default_factory=dict)
    """What the letters are declared to be, in words."""
    universal: frozenset[str] = frozenset()
    """Letters that stay free although a line gives them a number: crank angle, rod angle, time."""
    corrects: bool = True
    """Whether a refuted side is searched for the change that makes it true."""
    solved: Mapping[str, Formula] = field(default_factory=dict)
    """What letters equal by premises solved together, and the premises' texts."""
    solved_from: tuple[str, ...] = ()
    ranges: tuple[StatedRange, ...] = ()
    printed: frozenset[float] = frozenset()
    """The numbers that the page prints as results: put in elsewhere they are rounded."""
    stated: frozenset[float] = frozenset()
    """Those of them that no line computes: where they nearly cancel they are exact."""
    counted: frozenset[int] = frozenset()
    """Where numbers end that the page's words count things with, 4 cylinders: they are exact."""
    crank_angles: CrankAngles | None = None
    """The angles of the cylinders that the page lists: what a sum without an index goes over."""
    own_ranges_from: int = 0
    """The first line whose ranges are said of the relation in hand: "for N ≥ 2" above a display."""
    has_sums: bool = True
    """Whether a sum or an integral stands on the page: letters in it may be whole numbers."""
    orders: frozenset[str] = frozenset()
    """Letters that are orders of harmonics somewhere on the page, and may be whole numbers."""
    small: frozenset[str] = frozenset()
    """Letters that are said to be small; where ≈ rests on another, that is an assumption."""

    @property
    def declared(self) -> frozenset[str]:
        """The letters that are declared, by a known meaning or by words that explain them."""
        return self.letters | self.meanings.keys()

    def levels(self, *nodes: Formula) -> Iterator[Level]:
        """Yield what may be used, least first: nothing, meanings and definitions, then assumptions."""
        yield Level({})
        number = any(not names(node) for node in nodes)
        usable = {
            name: d
            for name, d in self.definitions.items()
            if not (d.numeric and name in self.universal and not number)
        }
        defined_values = {name: d.node for name, d in usable.items() if not d.assumption}
        values = {**defined_values, **self.meaning.values}
        if number:  # a numeric example: the numbers of the letters in which the geometry is written
            values |= {name: d.node for name, d in usable.items() if d.numeric and not d.assumption}
        light = {name: node for name, node in values.items() if name not in self.moving}
        if not number:
            yield from self._formula_levels(nodes, usable)
        if defined_values and len(light) < len(values):
            yield Level(light)
        if values:
            yield Level(values)
        premises = self._premises_behind(nodes, usable, number)
        texts = tuple(dict.fromkeys(d.assumption for d in premises.values()))
        if premises:
            values = {**values, **{name: d.node for name, d in premises.items()}}
            yield Level(values, texts)
        if self.solved:
            apart = {name: node for name, node in values.items() if not self._is_solved(name)}
            values, texts = {**apart, **self.solved}, (*texts, *self.solved_from)
            yield Level(values, texts)
        for assumption in self.assumptions:
            yield Level({**values, assumption.name: assumption.node}, (*texts, assumption.text))
        if len(self.assumptions) > 1:
            all_values = {assumption.name: assumption.node for assumption in self.assumptions}
            yield Level({**values, **all_values}, (*texts, *(a.text for a in self.assumptions)))

    @cached_property
    def formulas(self) -> dict[str, Definition]:
        """What letters stand for without the numbers of an example: U = m r/2, and not U = 0.016.

        A letter that has a number stands for its formula, unless that comes back to the letter itself.
        """
        formulas = {
            name: replace(d, node=node, numeric=False, formula=None) if d.numeric else d
            for name, d in self.definitions.items()
            if (node := d.formula if d.numeric else d.node) is not None
        }
        values = {**{name: d.node for name, d in formulas.items()}, **self.meaning.values}
        return {
            name: d
            for name, d in formulas.items()
            if not self.definitions[name].numeric or name not in names_behind(d.node, values)
        }

    def _formula_levels(
        self, nodes: tuple[Formula, ...], usable: Mapping[str, Definition]
    ) -> Iterator[Level]:
        """Yield the letters by their formulas, numbers left out: rounded sizes refute no formula.

        First with a ratio as the letter that is free: of λ = r/l the length is r/λ, so that what is
        approximately true for a small λ is judged in it.
        """
        everything = {**{name: d.node for name, d in usable.items()}, **self.meaning.values}
        behind = {name for node in nodes for name in names_behind(node, everything)}
        formulas = {n: d.node for n, d in self.formulas.items() if n in usable and not d.assumption}
        formulas |= self.meaning.values
        own = {name for node in nodes for name in names(node)}
        ratios = {
            name: node
            for name, node in formulas.items()
            if name in own - self.meaning.rates.keys()  # not of the time, θ/ω
            and isinstance(node, Quotient)
            and _is_of_letters(node)
        }
        for name, ratio in ratios.items():
            (length,) = names(ratio.denominator)
            if length not in formulas:
                others = {n: node for n, node in formulas.items() if n != name}
                by_ratio = length_by_ratio(name, ratio)
                yield Level({**others, length: by_ratio}, is_of_formulas=True)
        if any(usable[name].numeric for name in behind & usable.keys()):
            yield Level(formulas, is_of_formulas=True)

    def _premises_behind(
        self, nodes: tuple[Formula, ...], usable: Mapping[str, Definition], number: bool
    ) -> dict[str, Definition]:
        """Return the letters behind formulas whose values are premises."""
        everything = {**{name: d.node for name, d in usable.items()}, **self.meaning.values}
        behind = {name for node in nodes for name in names_behind(node, everything)}
        if stems := _summed_over(nodes):
            behind |= {name for name in usable if _stem(name) in stems}
        return {
            name: d
            for name, d in usable.items()
            if d.assumption
            and name in behind
            and (name not in self.meaning.values or (number and d.numeric))
        }

    def _is_solved(self, name: str) -> bool:
        return name in self.definitions and self.definitions[name].solved

    def branches_behind(self, *nodes: Formula) -> dict[str, Definition]:
        """Return the letters behind formulas whose values have other branches."""
        values = {**{name: d.node for name, d in self.definitions.items()}, **self.meaning.values}
        if not any(d.alternatives for d in self.definitions.values()):
            return {}
        behind = {name for node in nodes for name in names_behind(node, values)}
        return {n: d for n, d in self.definitions.items() if d.alternatives and n in behind}

    def with_definition(self, name: str, definition: Definition) -> Knowledge:
        """Return what is known if a letter is defined otherwise."""
        return replace(self, definitions={**self.definitions, name: definition})

    def evaluator(self, level: Level) -> FormEvaluator:
        """Return an evaluator in a fresh domain for a level."""
        meaning = replace(
            self.meaning, values=level.values, known=self._known_values, written=self._written_formulas
        )
        return FormEvaluator(meaning.domain(), meaning)

    @cached_property
    def _known_values(self) -> dict[str, Formula]:
        """What letters equal by lines or by their meanings."""
        return {**{name: d.node for name, d in self.definitions.items()}, **self.meaning.values}

    @cached_property
    def _written_formulas(self) -> dict[str, Formula]:
        """Of these, what lines and meanings say exactly, and not what was solved for or assumed."""
        unsaid = {n for n, d in self.definitions.items() if d.solved or d.assumption or d.is_rough}
        return {name: node for name, node in self._known_values.items() if name not in unsaid}

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


def length_by_ratio(name: str, ratio: Quotient) -> Quotient:
    """Return the length below the stroke of a ratio by the ratio's letter: of λ = r/l the rod r/λ."""
    return Quotient(ratio.numerator, Name(name))


def _is_of_letters(ratio: Quotient) -> bool:
    """Tell whether a quotient is one letter over another."""
    return isinstance(ratio.numerator, Name) and isinstance(ratio.denominator, Name)


def _stem(name: str) -> str:
    """Return what stands before the number of a letter, "" for one without: δ_ of δ_1."""
    stem = name.rstrip("0123456789")
    return "" if stem == name else stem


def _summed_over(nodes: tuple[Formula, ...]) -> set[str]:
    """Return the stems of the letters that sums go over: δ_ of the sum of cos δ_i, for δ_1 and δ_2."""
    return {
        own[: -len(part.index.name)]
        for node in nodes
        for part in parts_of_kind(node, Summation)
        if part.index is not None
        for own in indexed_letters(part.body, part.index.name)
    } - {""}
