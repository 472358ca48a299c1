"""Formulas between the numbers of quantities: F = 0.0000284 W R N² with lb, inches and rpm as typed.

Such a formula has a constant that converts units. Put in as quantities its letters give nonsense, as
numbers they give the number of the result. It is read so where that number is right to the digits
printed and the constant does convert: with all units the formula has a pure factor, 1, 2, π or g. The 12
of feet and inches, 2 s N/12, or the 3.6 of V/3.6 has to convert exactly: without it nothing is left over.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from itertools import product as combinations_of

from symbalance.document.formula import (
    Constant,
    Formula,
    Number,
    Product,
    Quotient,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.cases import UNITS_LEFT_OUT
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import without_unit
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import significant
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.units.conversions import POUND, POUND_FORCE, quantity_of
from symbalance.notes.checking.units.dimensions import (
    LARGEST_COUNTED,
    NONE,
    Dimension,
    Dimensions,
    Mismatch,
    unit_of,
    written_unit,
)
from symbalance.notes.checking.units.own_units import is_per_minute
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.formulas.result_units import value_of
from symbalance.notes.reading.spellings.numerals import sign_of_unit
from symbalance.notes.reading.units import GRAVITY, scale_of
from symbalance.text import lazy_patterns as re

BETWEEN_NUMBERS = "a formula between the numbers of quantities, whose constant converts their units"
_UNIT_NAMES = {"in": "inch", "in.": "inch"}
_OF_ONE_LETTER = {
    ("l", Fraction(1, 1000)): "dm^3",
    ("L", Fraction(1, 1000)): "dm^3",
    ("t", Fraction(1000)): "Mg",
}
"""Units of one letter that are letters elsewhere, where they were read as litres and tonnes."""
DOES_NOT_CONVERT = "its constant does not convert the units that the page gives its letters"
_G = float(GRAVITY)
_SLIPS = tuple(weight * 10.0**shift for shift in range(-6, 7) for weight in (1, _G, 1 / _G))
"""What a unit is off by that another prefix, or another unit of force, has: kW for W, N m for kp m."""
FEWEST_DIGITS = 3
"""That a constant shows which converts units; a small one as 0.00034 two."""
SMALL = Fraction(1, 100)
LEAST_WHOLE = 75
"""A whole constant that may convert: 75 kp m/s are 1 PS, 5252 and 33 000 stand in horsepower."""
SAME = 1e-9
LEAST_FAR, MOST_FAR = Fraction(1, 2), Fraction(5)
"""Between these a constant is a factor of safety or of overbalance, as 1.05; it converts no units."""
_PURE = tuple(
    simple * math.pi**power
    for simple, power in combinations_of((1, 2, 4, 8, 0.5, 0.25, 0.125), (-1, 0, 1, 2))
)
"""What a formula between quantities may have as its factor, beside a power of g."""
_FEW = {
    **{Fraction(12) * part: part for part in map(Fraction, ("1/4", "1/2", "1", "2", "4"))},
    Fraction("3.6"): Fraction(1),
}
"""Small numbers that convert, and what is left of each: r = s/24 is half of s in feet, s N/6 is 2 s N."""
_TURNS_BETWEEN = tuple(math.tau**power for power in (-1, 0, 1))
"""What is then between a formula and its result: turns for radians."""
_WEIGHTS = (0, -1, 1)
"""The powers of g that may stand between them: that of a pound or kilogram which is a weight."""
_ACCELERATION = unit_of("m/s^2") or NONE
_RADIANS_PER_SECOND = Number(Fraction(math.tau / 60))
"""What a revolution per minute is."""
_ROUGH = 0.002
"""What a pure factor may be off by, beside the digits of the constant and of the result: 32.2 for g."""
_DIGITS = re.compile(r"[0-9]{1,3}(?:,[0-9]{3})+(?![0-9])|[0-9]+(?:[.,][0-9]+)?")
_THOUSANDS = re.compile(r"[0-9]{1,3}(?:,[0-9]{3})+")
"""3,000, which the page may mean as three thousand or as three."""
_MOST_OF_A_TURN = 10
"""More than the 2π by which a speed in radians and one in turns differ, less than a thousand."""


@dataclass(frozen=True, slots=True)
class TypedNumber:
    """A letter's number as typed, and what it is in metres, kilograms and radians per second."""

    number: Number
    exact: Formula
    unit: str


def decide_between_numbers(
    left: Side, right: Side, sign: str, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the proof that a formula has a result as a number in its unit; None where it has none."""
    result = quantity_of(right, document)
    measured = {id(number) for number in numbers_with_units(left.node, document)}
    constants = [number for number in _converting(left.node) if id(number) not in measured]
    if not constants:
        constants = [
            part
            for part in walk(left.node)
            if isinstance(part, Number) and part.value in _FEW and id(part) not in measured
        ]
    own = names(left.node)
    typed = {name: typed_number(name, document, knowledge) for name in own}
    if result is None or not constants or not all(typed.values()):
        return None
    as_quantity = left.node
    as_number = left.node if own else _as_typed(left.node, document)
    if not own and as_number == left.node and not measured:
        return None  # an arithmetic without units is what it is
    try:
        for name, pair in typed.items():
            assert pair is not None
            as_number = substitute(as_number, name, pair.number)
            as_quantity = substitute(as_quantity, name, pair.exact)
    except NoFormError:  # a derivative by the letter: it has no value
        return None
    printed = Number(result.value, 2 * result.half)
    there = decide(Side((as_number,), left.span), Side((printed,), right.span), sign, knowledge)
    if not there.is_proved:
        return None
    weights = _weights_between(left.node, constants, typed, result.unit)
    pure_factors = [
        one * _G**weight
        for one, weight in combinations_of(
            _TURNS_BETWEEN if constants[0].value in _FEW else _PURE, weights
        )
    ]
    off = sum(_half(c) / abs(float(c.value)) for c in constants) + float(abs(result.half / result.value))
    scales = [result.scale, POUND_FORCE] if result.scale == POUND else [result.scale]
    for pure, scale in combinations_of(_without_constants(as_quantity, constants), scales):
        factor = abs(float(result.value * scale) / pure)
        if any(abs(factor / one - 1) <= off + _ROUGH for one in pure_factors):
            return replace(
                there, status=PROVED, assumptions=(*there.assumptions, BETWEEN_NUMBERS), reason=""
            )
    return None


def _weights_between(
    node: Formula, constants: list[Number], typed: dict[str, TypedNumber | None], unit: str
) -> tuple[int, ...]:
    """Return the powers of g between a formula and its result by their units; all where one is open."""
    difference = difference_of_units(node, constants, typed, unit)
    if difference is None:
        return _WEIGHTS
    return tuple(w for w in _WEIGHTS if difference == tuple(w * each for each in _ACCELERATION))


def difference_of_units(
    node: Formula, constants: list[Number], typed: Mapping[str, TypedNumber | None], unit: str
) -> Dimension | None:
    """Return the dimension of a result over that of its formula without constants, None if open."""
    units = {name: pair.unit or _count(pair) for name, pair in typed.items() if pair is not None}
    for constant in constants:
        node = replace_part(node, constant, Number(Fraction(1)))
    own = Dimensions({name: f"size, {text}" for name, text in units.items()}, {}).side(node, "")
    result = unit_of(unit)
    if own is None or result is None:
        return None
    return tuple(a - b for a, b in zip(result, own, strict=True))


def _count(pair: TypedNumber) -> str:
    """Return the unit of a whole number of cylinders or the like, "" of one whose unit is left out."""
    is_whole = pair.number.last_place is None and pair.number.value <= LARGEST_COUNTED
    return "1" if is_whole else ""


def _without_constants(node: Formula, constants: list[Number]) -> list[float]:
    """Return what an arithmetic of quantities is without its constants: of all, or of all but a speed.

    398 lb-ft · 6000/5252 has the speed as a bare number of revolutions per minute.
    """
    found: list[float] = []
    speeds = [c for c in constants if len(constants) > 1 and c.value.denominator == 1]
    for speed in (None, *speeds):
        rest = node
        for constant in constants:
            left_over: Formula = Number(_FEW.get(constant.value, Fraction(1)))
            if constant is speed:
                left_over = Product((constant, _RADIANS_PER_SECOND))
            rest = replace_part(rest, constant, left_over)
        value = value_of(rest)
        found += [value] if value else []
    return found


def decide_as_typed(
    left: Side, right: Side, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a result that a formula has by the numbers typed, and not by their units.

    9550 P/n is 191 N m for 60 kW and 3000 rpm, not for 60 MW, and never 191 W: a constant that converts
    units does so for those of the page. One of an empirical formula may have a unit of its own. None
    where the numbers typed do not give the result.
    """
    if not puts_in_numbers(left, right, document, knowledge):
        return None
    result = quantity_of(right, document)
    if result is None:
        return Decision(PROVED, UNITS_LEFT_OUT)
    typed = {name: typed_number(name, document, knowledge) for name in names(left.node)}
    constants = list(_converting(left.node))
    difference = difference_of_units(left.node, constants, typed, result.unit)
    if difference is None:
        return Decision(PROVED, assumptions=(BETWEEN_NUMBERS,))
    as_quantity = left.node
    for name, pair in typed.items():
        assert pair is not None
        as_quantity = substitute(as_quantity, name, pair.exact)
    ratios = [
        abs(float(result.value * result.scale) / pure)
        for pure in _without_constants(as_quantity, constants)
    ]
    slips = {ratio * slip / one for ratio in ratios for slip in _SLIPS for one in _PURE}
    is_slip = any(abs(each - 1) < _ROUGH for each in slips)
    is_same = any(difference == tuple(w * each for each in _ACCELERATION) for w in _WEIGHTS)
    if is_same:
        return Decision(REFUTED if is_slip else UNDECIDED, DOES_NOT_CONVERT)
    if any(abs(ratio / one - 1) < _ROUGH for ratio in ratios for one in _PURE):
        own = unit_of(result.unit) or NONE
        due = tuple(a - b for a, b in zip(own, difference, strict=True))
        return Decision(REFUTED, Mismatch("the left side is in", due, own).reason)
    return Decision(PROVED, assumptions=(BETWEEN_NUMBERS,))


def puts_in_numbers(left: Side, right: Side, document: ReadNotes, knowledge: Knowledge) -> bool:
    """Tell whether an arithmetic is such a formula with the letters' numbers put in: 120·3000/9550."""
    typed = {name: typed_number(name, document, knowledge) for name in names(left.node)}
    if not typed or names(right.node) or not any(_converting(left.node)) or not all(typed.values()):
        return False
    node = left.node
    try:
        for name, pair in typed.items():
            assert pair is not None
            node = substitute(node, name, pair.number)
    except NoFormError:
        return False
    first, second = value_of(node), value_of(without_unit(right.node))
    return first is not None and second is not None and math.isclose(first, second, rel_tol=SAME)


def decide_numbers_put_in(
    left: Side, right: Side, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the proof that an arithmetic has the numbers of a letter's formula: N = 28·60/6.5 in feet.

    It may be off by what the constants of the formulas are rounded by. None where nothing converts units.
    """
    if not names(left.node) or names(right.node) or isinstance(right.node, Number):
        return None
    nodes = _formulas_behind(left.node, knowledge)
    if not any(may_convert(node) for node in nodes):
        return None
    put_in = _as_typed(without_unit(right.node), document)
    if isinstance(put_in, Number) or (second := value_of(put_in)) is None:
        return None
    for chosen in _numbers_behind(nodes, document, knowledge):
        node = _with_numbers(left.node, chosen, knowledge)
        first = None if node is None else value_of(node)
        if first is not None and math.isclose(first, second, rel_tol=_OF_CONSTANTS):
            order = "" if math.isclose(first, second, rel_tol=SAME) else "the digits of its constants"
            return Decision(PROVED, order=order, assumptions=(BETWEEN_NUMBERS,))
    return None


def puts_in_as_typed(left: Side, right: Side, document: ReadNotes, knowledge: Knowledge) -> bool:
    """Tell whether an arithmetic has the numbers of a letter's formula as typed, one of them in inches.

    V = S N/6 is meant in feet per minute, S in inches: 6 may convert units, though 6 alone tells nothing.
    """
    value = value_of(_as_typed(without_unit(right.node), document))
    if not names(left.node) or names(right.node) or isinstance(right.node, Number) or value is None:
        return False
    nodes = _formulas_behind(left.node, knowledge)
    own = {name for node in nodes for name in names(node)}
    sources = (document.source(d.node.span) for n, d in knowledge.definitions.items() if n in own)
    if not any(_OTHER_UNIT.search(source) for source in sources):
        return False
    for chosen in _numbers_behind(nodes, document, knowledge):
        node = _with_numbers(left.node, chosen, knowledge)
        first = None if node is None else value_of(node)
        if first is not None and math.isclose(first, value, rel_tol=SAME):
            return True
    return False


def decide_in_one_unit(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the proof that an arithmetic has the numbers of letters that are all in one unit.

    With I_1 = 12 and I_2 = 60 lb. in. sec.², I_1 I_2/(I_1 + I_2) = 720/72, its unit left out.
    """
    left, right = chain.sides[k : k + 2]
    if not names(left.node) or names(right.node) or isinstance(right.node, Number):
        return None
    put_in = value_of(right.node)
    if put_in is None or any(numbers_with_units(right.node, document)):
        return None
    typed = {name: typed_number(name, document, knowledge) for name in names(left.node)}
    units = {each.unit for each in typed.values() if each is not None}
    if None in typed.values() or len(units) != 1 or not units.pop():
        return None
    numbers = {name: each.number for name, each in typed.items() if each is not None}
    node = _with_numbers(left.node, numbers, knowledge)
    first = None if node is None else value_of(node)
    if first is None or not math.isclose(first, put_in, rel_tol=SAME):
        return None
    return Decision(PROVED, UNITS_LEFT_OUT)


_OTHER_UNIT = re.compile(
    r"[0-9¼½¾][\s~$]*\\?(?:text\{\s?)?(?:in|ft|lbs?|inch(?:es)?|feet|foot|miles?|mph|km/h)\b"
)
"""A number in a unit that is no decimal one: formulas of such have factors of 12, 60, 3.6 and 5280."""
_OF_CONSTANTS = 0.002
"""What constants of three digits, 28.0 for 88/π, put a result off by."""
_DEEPEST = 12
"""Formulas that rest on formulas, one in the other."""
_MOST_CHOICES = 64
"""Ways to take the numbers of letters that have two, 8 tons = 17920 lb."""


def _formulas_behind(node: Formula, knowledge: Knowledge) -> list[Formula]:
    """Return a formula and the formulas of its letters, and of theirs."""
    nodes, reached = [node], set[str]()
    for each in nodes:
        for name in sorted(names(each) - reached):
            reached.add(name)
            definition = knowledge.definitions.get(name)
            if definition is not None and names(definition.node):
                nodes.append(definition.node)
    return nodes


def _numbers_behind(
    nodes: list[Formula], document: ReadNotes, knowledge: Knowledge
) -> Iterator[dict[str, Number]]:
    """Yield the numbers as typed of all letters with numbers in some formulas; some have two."""
    choices: dict[str, list[Number]] = {}
    for name in sorted({n for node in nodes for n in names(node)}):
        definition = knowledge.definitions.get(name)
        if definition is None or names(definition.node):
            continue
        for node in (definition.node, definition.rounded):
            if node is not None and (typed := _typed_node(node, document)) is not None:
                choices.setdefault(name, []).append(typed.number)
    if math.prod(len(own) for own in choices.values()) > _MOST_CHOICES:
        return
    for chosen in combinations_of(*choices.values()):
        yield dict(zip(choices, chosen, strict=True))


def _with_numbers(node: Formula, numbers: dict[str, Number], knowledge: Knowledge) -> Formula | None:
    """Return a formula with numbers for its letters, None where one has none."""
    for _ in range(_DEEPEST):
        own = sorted(names(node))
        if not own:
            return node
        for name in own:
            definition = knowledge.definitions.get(name)
            if name not in numbers and (definition is None or not names(definition.node)):
                return None
            value = numbers.get(name) or (definition.node if definition is not None else None)
            assert value is not None
            try:
                node = substitute(node, name, value)
            except NoFormError:  # a derivative by the letter: it has no value
                return None
    return None


def converts(node: Formula) -> bool:
    """Tell whether a formula has any constant that may convert units."""
    return any(_converting(node))


def may_convert(node: Formula) -> bool:
    """Tell whether a formula has a constant that may convert units, and is no factor near 1."""
    return any(not (LEAST_FAR < abs(number.value) < MOST_FAR) for number in _converting(node))


def with_printed_results(knowledge: Knowledge, document: ReadNotes) -> Knowledge:
    """Return what is known with the results of such formulas as printed: F = 1104 lb, a force."""
    definitions = dict(knowledge.definitions)
    for name, definition in knowledge.definitions.items():
        rounded = definition.rounded
        if rounded is None or not names(definition.node) or not any(_converting(definition.node)):
            continue
        result = quantity_of(Side((rounded,), rounded.span), document)
        if result is not None:
            scale = POUND_FORCE if result.scale == POUND else result.scale
            node = Number(result.value * scale, 2 * result.half * scale, span=rounded.span)
            definitions[name] = replace(definition, node=node, numeric=True, rounded=None)
    return replace(knowledge, definitions=definitions)


def _as_typed(node: Formula, document: ReadNotes) -> Formula:
    """Return an arithmetic with its units left out: 85 lb-ft · 4000 rpm/5252 as 85 · 4000/5252."""
    if isinstance(node, Product):
        numbers = [part for part in node.factors if not _is_unit(part, document)]
        factors = tuple(_as_typed(part, document) for part in numbers) or (Number(Fraction(1)),)
        return factors[0] if len(factors) == 1 else replace(node, factors=factors)
    parts = children(node)
    return with_children(node, tuple(_as_typed(part, document) for part in parts)) if parts else node


def numbers_with_units(node: Formula, document: ReadNotes) -> Iterator[Formula]:
    """Yield the numbers of a formula that have units behind them, and the units' own."""
    for part in walk(node):
        if isinstance(part, Product):
            for factor, unit in pairwise(part.factors):
                if _is_unit(unit, document):
                    yield from (factor, *walk(unit))
        if isinstance(part, Number) and document.source(part.span)[-1:].isalpha():
            yield part


def _is_unit(node: Formula, document: ReadNotes) -> bool:
    """Tell whether a factor was read from the letters of a unit."""
    is_factor = isinstance(node, Number | Quotient) and not names(node)
    return is_factor and document.source(node.span).lstrip(" ~\\{,")[:1].isalpha()


def _converting(node: Formula) -> Iterator[Number]:
    """Yield the numbers of a formula that may convert units."""
    for part in walk(node):
        if not isinstance(part, Number):
            continue
        if part.last_place is not None:
            is_small = abs(part.value) < SMALL and significant(part) == FEWEST_DIGITS - 1
            if significant(part) >= FEWEST_DIGITS or is_small:
                yield part
        elif part.value.denominator == 1 and abs(part.value) >= LEAST_WHOLE:
            yield part


def typed_number(name: str, document: ReadNotes, knowledge: Knowledge) -> TypedNumber | None:
    """Return the number that a letter was given on the page, None where it has none."""
    definition = knowledge.definitions.get(name)
    node = _number_node(definition) if definition is not None else None
    return None if node is None else _typed_node(node, document)


def _typed_node(node: Formula, document: ReadNotes) -> TypedNumber | None:
    """Return the number and unit that a formula consists of, None for an arithmetic."""
    is_lone = isinstance(node, Number) or (
        isinstance(node, Product) and len(node.factors) == 2 and isinstance(node.factors[0], Number)
    )
    if not is_lone and any(isinstance(part, Product | Quotient) for part in children(node)):
        return None
    source = document.source(node.span)
    digits, (has_number, words) = _DIGITS.search(source), written_unit(source)
    if isinstance(node, Product) and isinstance(node.factors[1], Number):
        words = _OF_ONE_LETTER.get((words, node.factors[1].value), words)
    is_speed = not words and is_per_minute(document.text, node.span[1])
    scale = scale_of(sign_of_unit(words)) if words else (Fraction(1, 30 if is_speed else 1), is_speed)
    if digits is None or not has_number or scale is None:
        return None
    unit = "rpm" if is_speed else _UNIT_NAMES.get(words, sign_of_unit(words))
    if _THOUSANDS.fullmatch(digits.group()):
        whole = _typed_number(digits.group().replace(",", ""), *scale, unit)
        first, second = value_of(whole.exact), value_of(node)
        if first and second and first / second < _MOST_OF_A_TURN:
            return whole
    return _typed_number(digits.group().replace(",", "."), *scale, unit)


def _typed_number(text: str, scale: Fraction, is_speed: bool, unit: str) -> TypedNumber:
    """Return a number in digits, with what it is by the scale of its unit."""
    number = Number(
        Fraction(text), Fraction(1, 10 ** len(text.partition(".")[2])) if "." in text else None
    )
    exact: Formula = Number(number.value * scale)
    if is_speed:
        per_minute = Quotient(Constant("pi"), rational_node(1 / scale))
        exact = Quotient(Number(number.value), Quotient(Number(Fraction(1)), per_minute))
    return TypedNumber(number, exact, unit)


def _number_node(definition: Definition) -> Formula | None:
    """Return what gives a letter its number: its value, or its result as printed."""
    if not names(definition.node):
        return definition.node
    return definition.rounded


def _half(number: Number) -> float:
    return 0.0 if number.last_place is None else float(number.last_place) / 2
