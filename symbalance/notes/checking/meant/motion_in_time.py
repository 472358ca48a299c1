"""Angles that a page lets run with the time, θ = ω t, and letters whose rate it names, φ̇ = ω.

Both say how a letter changes, and neither takes the letter's place: θ = ω t gives the time as θ/ω, so
that what is said of θ stays in θ, and φ̇ = ω puts the plain letter where a dot stood, never the other way.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Span,
    Sum,
    names,
    walk,
    with_parts_changed,
)
from symbalance.notes.algebra.evaluation import SymbolValue, derivative_name
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.declared.engines import Engines
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import letters_by_role
from symbalance.notes.checking.declared.symbols import meaning_of
from symbalance.notes.checking.units.dimensions import Dimensions, unit_of, written_unit
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

HIGHEST = 2
"""Times that a rate is a letter with a rate of its own."""
_ZERO = Number(Fraction(0))


@dataclass(frozen=True, slots=True)
class Motion:
    """How a letter changes with the time, from a line on: its rate, and the time where that follows."""

    name: str
    rate: Formula
    time: str
    line: int
    time_value: Formula | None = None
    """What the time is by it: (θ - θ_0)/ω."""
    law: Formula | None = None
    """What the line sets the letter equal to: ω t + θ_0."""
    is_assumed: bool = False
    """Whether no line states it, and what rests on it is to name it."""


@dataclass(frozen=True, slots=True)
class Differentiated:
    """A letter that a page differentiates: by which variable, from which line on, and how often."""

    name: str
    variable: str
    line: int
    order: int
    lines: frozenset[int]


@dataclass(frozen=True, slots=True)
class Motions:
    """The motions of a page, the places that state them, and the letters it differentiates."""

    motions: tuple[Motion, ...] = ()
    places: frozenset[tuple[Span, Span]] = frozenset()
    differentiated: tuple[Differentiated, ...] = ()

    def at(self, line: int) -> list[Motion]:
        """Return the motions that are stated up to a line."""
        return [motion for motion in self.motions if motion.line <= line]

    def letters(self, line: int) -> frozenset[str]:
        """Return the letters by which angles run with the time: ω and φ_0 of θ = ω t + φ_0."""
        return frozenset(name for m in self.at(line) if m.law is not None for name in names(m.law))

    def turning(self, line: int) -> frozenset[str]:
        """Return the letters that run with the time at a line: angles, free in what is claimed."""
        return frozenset(motion.name for motion in self.at(line) if motion.law is not None)


def motions_in_time(
    page: ReadNotes, declarations: Declarations, engines: Engines | None = None
) -> Motions:
    """Return the motions a page states of letters that the meanings of its letters leave open."""
    time = time_letter(page, declarations)
    if time is None or not page.chains:
        return Motions()
    roles = letters_by_role(declarations.symbols)
    meaning = meaning_of(declarations.symbols, engines=engines)[0]
    own_angles = roles.get("crank angle", [])
    is_time_known = time in meaning.values and bool(own_angles)
    has_speed = "angular speed" in roles or "engine speed rpm" in roles
    turning = {
        *own_angles,
        *(n for c in page.chains for side in c.sides for n in letters_in_waves(side.node)),
    }
    differentiated = tuple(_differentiated(page))
    by_angles = {each.name for each in differentiated if each.variable != time}
    given = _with_formulas(page) | meaning.values.keys()
    dimensions = Dimensions(declarations.symbols, {})
    motions: dict[str, Motion] = {}
    places: set[tuple[Span, Span]] = set()
    for chain in page.chains:
        for left, right in _pairs(chain):
            motion = _stated_rate(left.node, right.node, time, chain)
            motion = motion or _law(left.node, right.node, time, chain)
            if motion is None or motion.name in meaning.values or motion.name in motions:
                continue
            has_phase = isinstance(motion.law, Sum)
            if motion.name in own_angles and has_speed and not has_phase:
                continue
            if motion.law is not None:  # a second angle, φ = 2 ω t, is a formula: φ = 2θ
                is_second = any(m.law is not None for m in motions.values())
                if motion.name not in turning or is_second or (is_time_known and not has_phase):
                    continue
            elif motion.name in given | by_angles or dimensions.mismatch(left.node, right.node, ("", "")):
                continue
            motions[motion.name] = motion
            places.add((left.span, right.span))
    return Motions(tuple(motions.values()), frozenset(places), differentiated)


def with_rates_of_rates(
    page: ReadNotes, declarations: Declarations, engines: Engines | None = None
) -> tuple[ReadNotes, Motions]:
    """Return a page without the dotted letters that others stand for, and its motions: φ̇ = ω, ω̇ = α."""
    motions = motions_in_time(page, declarations, engines)
    page = with_plain_rates(page, motions)
    for _ in range(HIGHEST):
        further = motions_in_time(page, declarations, engines)
        known = {motion.name for motion in motions.motions}
        new = tuple(m for m in further.motions if m.name not in known and m.law is None)
        motions = Motions(
            (*motions.motions, *new),
            motions.places | (further.places if new else frozenset()),
            further.differentiated,
        )
        if not new:
            break
        page = with_plain_rates(page, replace(motions, motions=new))
    return page, motions


def with_plain_rates(page: ReadNotes, motions: Motions) -> ReadNotes:
    """Return a page with the plain letter wherever it has a dotted one that a line sets equal to it."""
    rates = {m.name: m for m in motions.motions if m.law is None}
    if not rates:
        return page

    def plain(node: Formula) -> Formula:
        if isinstance(node, Derivative) and isinstance(node.expression, Name):
            motion = rates.get(node.expression.name)
            if motion is None or node.variable.name != motion.time:
                return node
            rate = replace(motion.rate, span=node.span)
            return rate if node.order == 1 else replace(node, expression=rate, order=node.order - 1)
        return with_parts_changed(node, plain)

    def changed(chain: Chain) -> Chain:
        sides = tuple(replace(s, readings=tuple(map(plain, s.readings))) for s in chain.sides)
        return replace(chain, sides=sides)

    return replace(page, chains=tuple(map(changed, page.chains)))


def with_motions(
    meaning: SymbolValue,
    motions: Motions,
    line: int,
    defined: Collection[str],
    declared: Collection[str],
) -> SymbolValue:
    """Return what letters stand for, with the motions that the lines above state.

    A letter that is `defined` changes as its formula does; an angle that is not `declared` and has a
    second derivative does not turn steadily.
    """
    here, known = motions.at(line), {*meaning.values, *defined}
    written = [d for d in motions.differentiated if d.line <= line and d.name not in known]
    if not here and not written:
        return meaning
    values, rates = dict(meaning.values), {name: dict(rate) for name, rate in meaning.rates.items()}
    for motion in here:
        rates.setdefault(motion.time, {})[motion.name] = motion.rate
        if motion.time_value is not None:
            values[motion.time] = motion.time_value
    steady = {motion.name for motion in here}
    for each in written:
        if each.order > 1 and each.name not in {*declared, *steady}:
            rates.get(each.variable, {}).pop(each.name, None)
        _add_rates(rates, each)
    for each in written:
        _add_chain_rule(rates, each, written, line)
    moved = {name for rate in rates.values() for name in rate}
    return replace(meaning, values=values, rates=rates, constant=meaning.constant - moved)


def _add_rates(rates: dict[str, dict[str, Formula]], each: Differentiated) -> None:
    """Add that a letter's rate is a letter of its own, dE/dt, and so are the higher ones."""
    own = rates.setdefault(each.variable, {})
    if each.name in own:
        return
    name = each.name
    for order in range(1, each.order + 2):
        rate = derivative_name(Derivative(Name(each.name), Name(each.variable), order))
        own[name] = Name(rate)
        name = rate


def _add_chain_rule(
    rates: dict[str, dict[str, Formula]], each: Differentiated, written: list[Differentiated], line: int
) -> None:
    """Add dx/dt = (dx/dθ) (dθ/dt) on a line that has both rates of x."""
    for other in written:
        is_pair = other.name == each.name and other.variable != each.variable
        turn = rates.get(other.variable, {}).get(each.variable)
        if is_pair and line in each.lines & other.lines and turn is not None:
            slope = derivative_name(Derivative(Name(each.name), Name(each.variable)))
            rates[other.variable][each.name] = Product((Name(slope), turn))


def _pairs(chain: Chain) -> Iterator[tuple[Side, Side]]:
    for k, relation in enumerate(chain.relations):
        if relation.sign == "=":
            yield chain.sides[k], chain.sides[k + 1]


def _stated_rate(left: Formula, right: Formula, time: str, chain: Chain) -> Motion | None:
    """Return the motion that φ̇ = ω or ω = φ̇ states, None for other relations."""
    for rate, letter in ((left, right), (right, left)):
        if not isinstance(rate, Derivative) or not isinstance(letter, Name) or rate.order != 1:
            continue
        inner = rate.expression
        if (
            isinstance(inner, Name)
            and rate.variable.name == time
            and letter.name not in (inner.name, time)
        ):
            return Motion(inner.name, letter, time, chain.lines[0])
    return None


def _law(left: Formula, right: Formula, time: str, chain: Chain) -> Motion | None:
    """Return the motion that θ = ω t + θ_0 states, None for other relations."""
    if not isinstance(left, Name) or left.name in names(right) or time not in names(right):
        return None
    terms = right.terms if isinstance(right, Sum) else (right,)
    moving = [term for term in terms if time in names(term)]
    others = [term for term in terms if time not in names(term)]
    rate = _rate(moving[0], time) if len(moving) == 1 else None
    if rate is None or not names(rate) or not all(map(_is_still, others)):
        return None
    elapsed: Formula = left if not others else Sum((left, *map(Negative, others)))
    return Motion(left.name, rate, time, chain.lines[0], Quotient(elapsed, rate), right)


def _rate(term: Formula, time: str) -> Formula | None:
    """Return ω of ω t, None for what is no such product."""
    if not isinstance(term, Product):
        return None
    rest = [factor for factor in term.factors if factor != Name(time)]
    if (
        len(rest) != len(term.factors) - 1
        or not all(map(_is_still, rest))
        or time in names(term) - {time}
    ):
        return None
    if any(time in names(factor) for factor in rest):
        return None
    return rest[0] if len(rest) == 1 else Product(tuple(rest))


def _is_still(node: Formula) -> bool:
    """Tell whether a formula is of letters and numbers, their products and quotients."""
    return all(
        isinstance(part, Name | Number | Constant | Product | Quotient | Negative) for part in walk(node)
    )


def _with_formulas(page: ReadNotes) -> set[str]:
    """Return the letters to which a page gives formulas: their rates are those of it, and may be wrong.

    With x = A cos ω t, v = ẋ has one too.
    """
    given, rates = set[str](), list[tuple[str, str]]()
    for chain in page.chains:
        for one, other in _pairs(chain):
            for head, value in ((one.node, other.node), (other.node, one.node)):
                if not isinstance(head, Name) or not names(value) or head == value:
                    continue
                if isinstance(value, Derivative) and isinstance(value.expression, Name):
                    rates.append((head.name, value.expression.name))
                else:
                    given.add(head.name)
    for _ in rates:
        given |= {name for name, inner in rates if inner in given}
    return given


def _differentiated(page: ReadNotes) -> Iterator[Differentiated]:
    """Yield the letters that a page differentiates; φ̈ = 0 says that there is nothing to it."""
    places: dict[tuple[str, str], list[tuple[int, int]]] = {}
    for chain in page.chains:
        if any(side.node == _ZERO for side in chain.sides) and any(
            isinstance(side.node, Derivative) for side in chain.sides
        ):
            continue
        for side in chain.sides:
            for part in walk(side.node):
                if isinstance(part, Derivative) and isinstance(part.expression, Name):
                    key = part.expression.name, part.variable.name
                    if key[0] != key[1]:
                        places.setdefault(key, []).append((chain.lines[0], part.order))
    for (name, variable), own in places.items():
        lines, order = frozenset(line for line, _ in own), max(n for _, n in own)
        yield Differentiated(name, variable, min(lines), order, lines)


def has_another_value(name: str, page: ReadNotes) -> bool:
    """Tell whether a page gives a letter what is no time: t = 5 mm, a thickness."""
    for chain in page.chains:
        if not any(isinstance(side.node, Name) and side.node.name == name for side in chain.sides):
            continue
        for side in chain.sides:
            unit = written_unit(page.source(side.span))[1]
            is_time = bool(unit) and unit_of(unit) == unit_of("s")
            if not (isinstance(side.node, Name) and side.node.name == name) and not is_time:
                return True
    return False


def has_another_rate(name: str, rate: Formula, page: ReadNotes, time: str) -> bool:
    """Tell whether a page makes more of a letter than an angle that runs with a constant rate."""
    moving = {each.name for each in _differentiated(page) if each.variable == time}
    return bool(moving & {name, *names(rate)}) or name in _with_formulas(page)


def time_letter(page: ReadNotes, declarations: Declarations) -> str | None:
    """Return the letter of time: the one declared, or t where the page has it for nothing else."""
    declared = letters_by_role(declarations.symbols).get("time")
    if declared:
        return declared[0]
    return None if "t" in declarations.symbols or has_another_value("t", page) else "t"
