"""Results whose numbers are in units that the arithmetic does not say: 109 hp · 0.7457 = 81.3 kW.

What is calculated with stands in metres, newtons and kilograms; an author may put in the number of inches
that a formula of his wants, convert a unit by a factor beside it, or weigh a force in lb. A relation that
is refuted as it stands is read so where the page shows that it is meant so, and holds if it comes out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Sum,
    children,
    names,
    walk,
    with_children,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.cases import UNITS_LEFT_OUT, in_units_left_out
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import without_unit
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals, significant
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.units.bare_lengths import decide_with_bare_lengths
from symbalance.notes.checking.units.conversions import (
    POUND,
    POUND_FORCE,
    TONS,
    Quantity,
    decide_conversion,
    is_power_of_ten,
    quantity_of,
)
from symbalance.notes.checking.units.dimensions import unit_of, written_unit
from symbalance.notes.checking.units.formulas_between_numbers import (
    decide_as_typed,
    decide_between_numbers,
    decide_in_one_unit,
    decide_numbers_put_in,
    may_convert,
    puts_in_as_typed,
    puts_in_numbers,
    with_printed_results,
)
from symbalance.notes.checking.units.own_units import (
    is_divided_by_minute,
    is_per_minute,
    is_per_minute_number,
)
from symbalance.notes.checking.units.printed_units import decide_by_printed_units
from symbalance.notes.checking.units.rounded_wholes import decide_rounded_wholes
from symbalance.notes.checking.units.units_above import proved_by_units_above
from symbalance.notes.checking.units.units_behind import decide_as_counted
from symbalance.notes.checking.units.units_for_all import decide_in_unit_for_all
from symbalance.notes.checking.units.units_of_lists import decide_in_unit_of_list
from symbalance.notes.checking.units.unrounded_numbers import decide_unrounded
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.formulas.result_units import without_unit_of_result
from symbalance.notes.reading.spellings.numerals import unit_in_words
from symbalance.notes.reading.units import Scale, scale_of
from symbalance.text import lazy_patterns as re

RPM = Fraction(1, 30), True
FEWEST_COUNTED, NEARLY_WHOLE = 10, Fraction(1, 100)
"""Of a whole result with a unit: the least of two digits, and what closing zeros may hide behind =."""
FEWEST_DIGITS = 3
"""That a factor of conversion, or a constant that a formula has for its units, is printed with."""
_TIE = Fraction(1, 10**9)
"""Half a unit of two digits is rounded up: half of 87 mm is no 43 mm."""
_PI, _NEAR_PI = Fraction(355, 113), Fraction(1, 500)
_SMALL = Fraction(1, 100)
_LETTER = re.compile(r"[A-Za-z]")
_RPM = re.compile(
    r"r\.?\s?p\.?\s?m|rev(?:olutions?|s)?\.?\s?(?:per|/)\s?m|(?:U|tr|Umdr)?/min|min\^?\{?[-⁻]",
    re.IGNORECASE,
)
_QUANTITY = re.compile(
    r"\s*[-−]?[0-9][0-9.,]*(?:[0-9]|(?<=[0-9]))\$?[ ~]?\$?(?P<unit>[A-Za-zµ].*)", re.DOTALL
)
_BY_MINUTE = re.compile(
    r"(?:per\s+|/\s*)min(?![A-Za-z])|(?:per|a)\s+minute|min\^?\{?[-⁻−]1?|je\s+Minute|pro\s+Minute"
)
_NO_LETTERS = re.compile(
    r"\\(?:cdot|times|[dt]?frac|pi|sqrt|left|right|div)(?![A-Za-z])|(?<![A-Za-z])[xX](?![A-Za-z])"
)
"""What is a command or the cross of a product, where a side has no letters."""
_SMALL_LENGTH = re.compile(r"(?<![A-Za-z])[cm]m(?![A-Za-z])")
_CLOSING_MARK = re.compile(r"</?[a-z]+>|&[a-z]+;|\\[)\]]")
"""What closes a formula between its number and the unit: </math>, \\)."""


def decide_in_units(
    chain: Chain, k: int, decision: Decision, document: ReadNotes, knowledge: Knowledge
) -> Decision:
    """Return the decision on a refuted relation in the units that its numbers are meant in."""
    in_two_units = decide_conversion(chain, k, document)
    if in_two_units is not None:
        return in_two_units if in_two_units.is_proved else decision
    if decision == decide_by_printed_units(chain, k, document, knowledge):
        return decision
    there = _as_meant(chain, k, decision, document, knowledge)
    in_feet = knowledge if there.is_proved else with_gravity_in_feet(knowledge)
    if in_feet is not knowledge:
        by_feet = decide(chain.sides[k], chain.sides[k + 1], chain.relations[k].sign, in_feet)
        by_feet = by_feet if by_feet.is_proved else _as_meant(chain, k, decision, document, in_feet)
        return by_feet if by_feet.is_proved else there
    return there


_GRAVITY_IN_FEET = {
    **dict.fromkeys(map(Fraction, ("32", "32.2", "32.17", "32.16", "32.174", "32.18")), "ft"),
    **dict.fromkeys(map(Fraction, ("386", "386.1", "386.4")), "inch"),
}
"""The numbers that g has on pages in feet or inches, and the length that it is counted in."""


def with_gravity_in_feet(knowledge: Knowledge) -> Knowledge:
    """Return what is known with the g = 32.2 of a page as feet per second squared, which it is."""
    gravity = knowledge.definitions.get("g")
    node = None if gravity is None else gravity.node
    length = _GRAVITY_IN_FEET.get(node.value) if isinstance(node, Number) else None
    scale = scale_of(length) if length else None
    if gravity is None or node is None or scale is None:
        return knowledge
    return knowledge.with_definition("g", replace(gravity, node=Product((node, Number(scale[0])))))


def _as_meant(
    chain: Chain, k: int, decision: Decision, document: ReadNotes, knowledge: Knowledge
) -> Decision:
    """Return the first proof in one of the ways in which units may be meant, else the decision."""
    for meant in (
        _put_in_bare, _term_by_term, _rounded_in_its_unit, _between_numbers, _in_unit_of_result,
        _converted, _of_weights, decide_as_counted, _with_numbers_of_units, _with_frequencies,
        _in_unit_behind, _in_unit_of_wrong_result, _by_the_minute, decide_unrounded,
        decide_rounded_wholes, proved_by_units_above, decide_with_bare_lengths, decide_in_unit_of_list,
        decide_in_unit_for_all, decide_in_one_unit,
    ):  # fmt: skip
        there = meant(chain, k, document, knowledge)
        if there is not None and (there.is_proved or meant in (_converted, _between_numbers)):
            return there
    return decision


def decide_after_units_left_out(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on the result of numbers without units, m R = 0.35·38 = 13.3 kg mm.

    It has to be that of the letters; where it is not, but is the arithmetic's, the units decide.
    Numbers divided by 60 where the letter counts by the minute are right by themselves.
    """
    if not k:
        return None
    outcome = _after_units_left_out(chain, k, document, knowledge)
    if outcome is None or outcome.status != REFUTED or not _turns_minutes(chain, k, document, knowledge):
        return outcome
    by_itself = decide(chain.sides[k], chain.sides[k + 1], chain.relations[k].sign, knowledge)
    return by_itself if by_itself.is_proved else outcome


def _turns_minutes(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> bool:
    """Tell whether numbers are divided by 60 or 30, and a letter they stand for counts by the minute."""
    if not is_divided_by_minute(chain.sides[k].node):
        return False
    given = (knowledge.definitions.get(name) for name in names(chain.sides[k - 1].node))
    return any(d is not None and is_per_minute_number(d.node, document.text) for d in given)


def _after_units_left_out(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    knowledge = with_printed_results(with_gravity_in_feet(knowledge), document)
    formula, put_in, right, sign = *chain.sides[k - 1 : k + 2], chain.relations[k].sign
    between_numbers = decide_between_numbers(formula, right, sign, document, knowledge)
    if between_numbers is not None:
        return between_numbers
    is_between_numbers = puts_in_numbers(formula, put_in, document, knowledge)
    if is_between_numbers or in_units_left_out(chain, k - 1, knowledge) is not None:
        return _result_by_letters(formula, put_in, right, sign, document, knowledge)
    return _refuted_in_its_unit(formula, put_in, right, sign, knowledge)


def _refuted_in_its_unit(
    formula: Side, put_in: Side, right: Side, sign: str, knowledge: Knowledge
) -> Decision | None:
    """Return the refutation of a result whose number is right, not its unit: 88.5 kJ for 88.5 J."""
    bare = _bare_side(put_in)
    if bare is None or not names(formula.node):
        return None
    by_letters = decide(formula, right, sign, knowledge)
    is_known = by_letters.left is None or not letters(by_letters.left)
    is_wrong = by_letters.status == REFUTED and is_known
    return by_letters if is_wrong and decide(formula, bare, "=", knowledge).is_proved else None


def _result_by_letters(
    formula: Side, put_in: Side, right: Side, sign: str, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a result by the letters of its formula, and by the arithmetic before it."""
    by_letters = decide(formula, right, sign, knowledge)
    for otherwise in (_as_force, _of_weights_in_lb, _by_frequencies) if not by_letters.is_proved else ():
        there = otherwise(formula, right, sign, document, knowledge)
        if there is not None and there.is_proved:
            return there
    if by_letters.is_proved or not written_unit(document.source(right.span))[1]:
        return by_letters if by_letters.is_proved else None
    quantity = quantity_of(right, document)
    if quantity is None or not may_convert(formula.node):
        return by_letters
    typed = Side((Number(quantity.value, 2 * quantity.half),), right.span)
    arithmetic = Side((without_unit(put_in.node),), put_in.span)
    is_open = decide(arithmetic, typed, sign, knowledge).is_proved
    return Decision(UNDECIDED, UNITS_LEFT_OUT) if is_open else by_letters


def _bare_side(side: Side) -> Side | None:
    """Return an arithmetic without the unit of the result behind it, in which it was read; else None."""
    arithmetic = without_unit_of_result(side)
    return None if arithmetic is side.node else Side((arithmetic,), side.span)


def _put_in_bare(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision on numbers put in for letters, whatever the unit of the result behind is."""
    left, bare = chain.sides[k], _bare_side(chain.sides[k + 1])
    if bare is None or not names(left.node):
        return None
    return decide(left, bare, chain.relations[k].sign, knowledge)


def _in_unit_of_wrong_result(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on numbers put in for letters in the unit of the result, miscalculated behind.

    In C = √2 d F/3 = √2·0.7·64.2/3 = 15.0 kN m the numbers are in kN and m, whatever they come to.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    result = quantity_of(chain.sides[k + 2], document) if k + 2 < len(chain.sides) else None
    is_arithmetic = not names(right.node) and not isinstance(right.node, Number)
    if result is None or result.scale == 1 or not names(left.node) or not is_arithmetic:
        return None
    put_in = Product((right.node, Number(result.scale)), span=right.node.span)
    return decide(left, Side((put_in,), right.span), chain.relations[k].sign, knowledge)


def _term_by_term(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the proof of 45·0.5 + 0.15·45·0.75 = 22.5 + 5.06, in which each term is rounded."""
    left, right = (_terms(_bare_sum(side.node)) for side in chain.sides[k : k + 2])
    if len(left) != len(right) or len(left) < 2 or names(chain.sides[k + 1].node):
        return None
    sign, span = chain.relations[k].sign, chain.sides[k].span
    decisions = [
        decide(Side((first,), span), Side((second,), span), sign, knowledge)
        for first, second in zip(left, right, strict=True)
    ]
    return decisions[0] if all(decision.is_proved for decision in decisions) else None


def _bare_sum(node: Formula) -> Formula:
    """Return a sum without the unit of the result behind it."""
    if isinstance(node, Product) and len(node.factors) == 2 and isinstance(node.factors[0], Sum):
        return node.factors[0] if isinstance(node.factors[1], Number) else node
    return node


def _terms(node: Formula) -> tuple[Formula, ...]:
    return node.terms if isinstance(node, Sum) else ()


def _rounded_in_its_unit(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on 5401 N · 45 mm = 243 Nm: a whole result with a unit is rounded to its units.

    It has two digits, and its closing zeros are open to a hundredth: 16 m/s for 15.7, 1500 N for 1494.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    quantity = quantity_of(right, document)
    is_computed = not isinstance(left.node, Name | Number)
    if quantity is None or names(right.node) or not is_computed or abs(quantity.value) < FEWEST_COUNTED:
        return None
    open_by = max(2 * NEARLY_WHOLE * abs(quantity.value), Fraction(1))
    place = min(2 * quantity.half, open_by) * quantity.scale
    value = quantity.value * quantity.scale
    if place == quantity.scale and abs(quantity.value) < FEWEST_COUNTED**2:
        value *= 1 - _TIE  # 43.5 is 44
    rounded = Side((Number(value, place),), right.span)
    if not names(left.node) and _is_wrong_by_letters(chain, k, rounded, knowledge):
        return None
    return decide(left, rounded, chain.relations[k].sign, knowledge)


def _with_frequencies(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision with the speeds that count revolutions per minute elsewhere as frequencies."""
    return _by_frequencies(
        chain.sides[k], chain.sides[k + 1], chain.relations[k].sign, document, knowledge
    )


def _by_frequencies(
    left: Side, right: Side, sign: str, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision with such speeds as frequencies, None where there are none.

    With n = 5000 min⁻¹ both v = 2 s n/60 and v = 2 s n are written: n is a number in one of them.
    """
    if is_divided_by_minute(left.node):
        return None  # πn/30 would be divided twice
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {n for side in (left, right) for n in names_behind(side.node, values)}
    definitions = dict(knowledge.definitions)
    for name in behind & definitions.keys():
        node = definitions[name].node
        if isinstance(node, Number) and is_per_minute(document.text, node.span[1]):
            per_second = Product((node, Number(Fraction(1, 60))), span=node.span)
            definitions[name] = replace(definitions[name], node=per_second)
    if definitions == dict(knowledge.definitions):
        return None
    # of p V n/2 as it is typed: a reading with n/60 would be divided twice
    left, right = (replace(side, readings=side.readings[:1]) for side in (left, right))
    return decide(left, right, sign, replace(knowledge, definitions=definitions))


def _between_numbers(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a formula whose constant converts units, or on numbers put into a result."""
    left, right = chain.sides[k], chain.sides[k + 1]
    above = knowledge.definitions.get(left.node.name) if isinstance(left.node, Name) else None
    if above is not None:  # P = M n/9550, and below M = 100 Nm, n = 3000 rpm: P = 31.4 kW
        node = above.node if above.formula is None else above.formula
        left = replace(left, readings=(node,)) if names(node) else left
    there = decide_between_numbers(left, right, chain.relations[k].sign, document, knowledge)
    there = there or decide_as_typed(left, right, document, knowledge)
    there = there or decide_numbers_put_in(left, right, document, knowledge)
    if there is None and k + 2 < len(chain.sides) and puts_in_as_typed(left, right, document, knowledge):
        # 2 s N/12 = 2·6.5·1800/12 = 1950 ft. per min.
        there = decide_between_numbers(
            left, chain.sides[k + 2], chain.relations[k + 1].sign, document, knowledge
        )
    printed = with_printed_results(knowledge, document)
    if there is not None or printed.definitions == knowledge.definitions:
        return there
    by_printed = decide(left, right, chain.relations[k].sign, printed)
    return by_printed if by_printed.is_proved else in_units_left_out(chain, k, printed)


def _in_unit_of_result(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on 80/2 = 40 mm: numbers without units, computed in that of the result.

    Of lengths in mm or cm, of rpm, and of units that are no power of ten, lb, psi or hp, in which nobody
    has a result who computed in newtons: 1800 kN for 1800 N is a slip that is made.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    if names(left.node) or names(right.node) or not isinstance(right.node, Product | Number):
        return None
    before = _NO_LETTERS.sub("", document.text[left.span[0] : left.span[1]])
    if _LETTER.search(before):
        return None
    bare = _number_of_odd_unit(right, document)
    if bare is not None and _is_wrong_by_letters(chain, k, right, knowledge):
        return None
    if bare is None and isinstance(right.node, Product):
        *rest, unit = right.node.factors
        written = document.text[unit.span[0] : unit.span[1]]
        plain = _CLOSING_MARK.sub("", written).strip(" ~,.\\$")
        spellings = (plain, re.sub(r"\.\s?", "", plain).lower(), written_unit(f"0 {written}")[1])
        is_usual = _SMALL_LENGTH.search(written) or any(scale_of(unit) == RPM for unit in spellings)
        if is_usual and rest:
            bare = rest[0] if len(rest) == 1 else Product(tuple(rest))
    if bare is None:
        return None
    sign = chain.relations[k].sign
    there = decide(left, Side((bare,), right.span), sign, knowledge)
    if not there.is_proved and isinstance(bare, Number) and _is_whole_of_two_digits(bare):
        rounded = Number(bare.value, Fraction(1))  # 350/6 = 58 rpm
        there = decide(left, Side((rounded,), right.span), sign, knowledge)
    return replace(there, assumptions=(*there.assumptions, "numbers in the unit of the result"))


def _is_whole_of_two_digits(number: Number) -> bool:
    return number.value.denominator == 1 and abs(number.value) >= FEWEST_COUNTED


def _by_the_minute(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision on 4 r N = 1200 ft per min, where N is a number of revolutions per minute."""
    return _per_minute(chain, k, k, document, knowledge)


def _per_minute(
    chain: Chain, k: int, left: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a rate per minute of a speed that counts revolutions per minute.

    Where ω = 2πN/60 makes N the number itself, 4 r N is a length, printed as so much per minute.
    """
    sides = chain.sides
    own = names(sides[left].node)
    counted = {
        other.sides[0].node.name
        for other in document.chains
        if isinstance(other.sides[0].node, Name)
        and any(
            isinstance(s.node, Number) and _RPM.search(document.source(s.span)) for s in other.sides[1:]
        )
    }
    if is_divided_by_minute(sides[left].node):
        return None  # πn/30 is by the second
    if not own & counted or not _BY_MINUTE.search(_with_behind(sides[k + 1], document)):
        return None
    by_minute = tuple(Product((Number(Fraction(60)), node)) for node in sides[k + 1].readings)
    right = replace(sides[k + 1], readings=by_minute)
    there = decide(sides[left], right, chain.relations[k].sign, knowledge)
    return there if there.is_proved else None


def _with_behind(side: Side, document: ReadNotes) -> str:
    """Return the text of a side with what stands right behind it, where a unit may end."""
    return document.text[side.span[0] : side.span[1] + 4]


def _in_unit_behind(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision on v = 0.1047 × 4 × 90 where the side behind has a unit, = 37.7 ft. per sec."""
    if k + 2 >= len(chain.sides) or names(chain.sides[k + 1].node):
        return None
    left, right = chain.sides[k], chain.sides[k + 1]
    behind = _QUANTITY.match(_with_behind(chain.sides[k + 2], document))
    scale = scale_of(unit_in_words(behind["unit"])) if behind else None
    bare = _NO_LETTERS.sub("", document.source(right.span))
    if scale is None or scale[1] or scale[0] == 1 or _LETTER.search(bare) or not names(left.node):
        return None
    in_unit = tuple(Product((node, Number(scale[0]))) for node in right.readings)
    there = decide(left, replace(right, readings=in_unit), chain.relations[k].sign, knowledge)
    return replace(there, assumptions=(*there.assumptions, "numbers in the unit of the result"))


def _number_of_odd_unit(side: Side, document: ReadNotes) -> Number | None:
    """Return the number of a result in lb, psi or hp, None for other sides."""
    quantity = quantity_of(side, document)
    if quantity is None or is_power_of_ten(quantity.scale):
        return None
    return Number(quantity.value, 2 * quantity.half)


def _is_wrong_by_letters(chain: Chain, k: int, right: Side, knowledge: Knowledge) -> bool:
    """Tell whether a side with letters before, all of which have values, is another number.

    A letter counts where a line above has its formula: M = 8250·0.042 = 347 kN m behind M = F c.
    """
    for side in reversed(chain.sides[:k]):
        head = knowledge.definitions.get(side.node.name) if isinstance(side.node, Name) else None
        has_formula = head is not None and bool(names(head.node))
        if names(side.node) and (has_formula or not isinstance(side.node, Name)):
            there = decide(side, right, "=", knowledge)
            return there.status == REFUTED and there.left is not None and not letters(there.left)
    return False


# Factors of conversion: 109 hp · 0.7457 = 81.3 kW


def _converted(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a quantity times what converts its unit to that of the result.

    The factor agrees with the two units to its last digit; then it is no second power, and the number is
    in the unit of the result. What does not come out so is wrong.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    target = _scale_written(document.source(right.span))
    if names(left.node) or names(right.node) or target is None or target[1]:
        return None
    units = [p for p in walk(left.node) if isinstance(p, Number) and _is_unit_in(p, document)]
    if len(units) > 1 or not _LETTER.search(_NO_LETTERS.sub("", document.source(left.span))):
        return None
    own = units[0].value if units else Fraction(1)
    ratio = own / target[0]
    own_unit = units[0] if units else None  # no factor beside it: 5 kN = 5 N converts nothing
    factors = ((f, power) for f, power in _factors(left.node) if f is not own_unit)
    factor = next((f for f, power in factors if _agrees(f, ratio**power)), None)
    if factor is None or ratio == 1:
        return None
    bare = _with_scale(left.node, units[0] if units else None, target[0])
    there = decide(Side((bare,), left.span), right, chain.relations[k].sign, knowledge)
    text = formula_text(factor, plain=True)
    return replace(there, assumptions=(*there.assumptions, f"{text} converts the unit"))


def _scale_written(source: str) -> Scale | None:
    number, unit = written_unit(source)
    return scale_of(unit) if number and unit else None


def _is_unit_in(node: Formula, document: ReadNotes) -> bool:
    """Tell whether a number is the factor of a unit: letters stand where it was read."""
    is_exact = isinstance(node, Number) and node.last_place is None
    return is_exact and _LETTER.match(document.source(node.span).lstrip("\\{~ ")) is not None


def _factors(node: Formula, power: int = 1) -> Iterator[tuple[Number, int]]:
    """Yield the numbers that are factors of an arithmetic, with 1 above a stroke, -1 below it."""
    if isinstance(node, Number):
        yield node, power
    elif isinstance(node, Product):
        for factor in node.factors:
            yield from _factors(factor, power)
    elif isinstance(node, Quotient):
        yield from _factors(node.numerator, power)
        yield from _factors(node.denominator, -power)


def _agrees(number: Number, ratio: Fraction) -> bool:
    """Tell whether a number as printed is a ratio of units; one of two digits has to be so exactly."""
    place = number.last_place
    if place is None or significant(number) < FEWEST_DIGITS:
        return number.value == ratio
    return abs(number.value - ratio) <= place / 2


def _with_scale(node: Formula, unit: Formula | None, scale: Fraction) -> Formula:
    """Return an arithmetic in another unit than the one that stands in it."""
    if unit is None:
        return Product((node, Number(scale)))
    return _replaced(node, unit, Number(scale))


def _replaced(node: Formula, old: Formula, new: Formula) -> Formula:
    if node is old:
        return new
    parts = children(node)
    return with_children(node, tuple(_replaced(part, old, new) for part in parts)) if parts else node


# Weights: a force in lb

_OF_FORCE = re.compile(r"lbf|^(?:psi|slug|hp|bhp|HP)$")
"""A unit that has the weight of a pound in it."""
_WEIGHT_BEHIND = re.compile(
    r"[0-9][\s~$]*(?:\\[,;: ]|\\(?:text|mathrm)\s?\{\s?)*(?:lbs?|tons?|oz)(?![A-Za-z/·])"
)


def _of_weights(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision on F = m a = 1345 lb or W r = 17.9 lb.-in., of weights that are forces."""
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    as_force = _as_force(left, right, sign, document, knowledge)
    if as_force is not None and as_force.is_proved:
        return as_force
    return _of_weights_in_lb(left, right, sign, document, knowledge)


def _of_weights_in_lb(
    left: Side, right: Side, sign: str, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a result in pounds of force by letters in lb, which are read as masses.

    Both sides are divided by g then: W r = 5.5 lb · 3.25 in = 17.9 lbf·in, p = P/A = 7128 lb/23.76 in².
    """
    quantity = quantity_of(right, document)
    if quantity is None or names(right.node) or not _OF_FORCE.search(quantity.unit):
        return None
    behind = names_behind(left.node, {name: d.node for name, d in knowledge.definitions.items()})
    values = [knowledge.definitions[name].node for name in behind if name in knowledge.definitions]
    if not any(_WEIGHT_BEHIND.search(document.source(n.span)) or _is_in_pounds(n) for n in values):
        return None
    scale = quantity.scale * POUND / POUND_FORCE
    by_weight = Number(quantity.value * scale, 2 * quantity.half * scale)
    there = decide(left, Side((by_weight,), right.span), sign, knowledge)
    return replace(there, assumptions=(*there.assumptions, "lb is a force"))


def _is_in_pounds(node: Formula) -> bool:
    """Tell whether a value is counted in pounds, as the 3 · 0.5 of W = 3 · 0.5 = 1.5 lb."""
    return any(part == Number(POUND) for part in walk(node))


def _as_force(
    left: Side, right: Side, sign: str, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a number of pounds as a force, None where none stand there."""
    if names(right.node):
        return None
    quantity = quantity_of(right, document)
    if quantity is not None and quantity.scale == TONS[0]:
        return _in_tons_of_force(left, right, sign, quantity, knowledge)
    pounds = [part for part in walk(right.node) if part == Number(POUND)]
    if not names(left.node):
        kind = unit_of(quantity.unit) if quantity else None
        of_force = [part for part in walk(left.node) if part == Number(POUND)]
        if kind is None or (kind[0], kind[2]) != (1, -2) or len(of_force) != 1:
            return None
        left = Side((_replaced(left.node, of_force[0], Number(POUND_FORCE)),), left.span)
        forced: Formula = right.node
    elif quantity is not None and quantity.scale == POUND:
        forced = Number(quantity.value * POUND_FORCE, 2 * quantity.half * POUND_FORCE)
    elif len(pounds) == 1:
        forced = _replaced(right.node, pounds[0], Number(POUND_FORCE))
    else:
        return None
    there = decide(left, Side((forced,), right.span), sign, knowledge)
    return replace(there, assumptions=(*there.assumptions, "lb is a force"))


def _in_tons_of_force(
    left: Side, right: Side, sign: str, quantity: Quantity, knowledge: Knowledge
) -> Decision:
    """Return the decision on a number of tons as the weight of one of the three."""
    there = Decision(UNDECIDED)
    for ton in TONS:
        scale = ton * POUND_FORCE / POUND
        forced = Number(quantity.value * scale, 2 * quantity.half * scale)
        there = decide(left, Side((forced,), right.span), sign, knowledge)
        if there.is_proved:
            text = f"a ton is the weight of {float(ton / POUND):.6g} lb"
            return replace(there, assumptions=(*there.assumptions, text))
    return there


# Formulas between numbers: N_c = 187.6/√y, y in inches


def _with_numbers_of_units(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision with a formula's letters as numbers of the units that the page names.

    "With y in inches N_c = 187.6/√y": such a formula has a constant for its units, and a letter in it
    counts inches. Both have to be there, the words before the line.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    before = document.text[: right.span[1]]
    units = dict(_units_in_words(before, knowledge, left.node, right.node))
    if not units:
        return None
    definitions = dict(knowledge.definitions)
    for name, definition in knowledge.definitions.items():
        if _is_of_numbers(definition.node):
            definitions[name] = replace(definition, node=_as_numbers(definition.node, units))
    sides = [
        replace(s, readings=tuple(_as_numbers(n, units) if _is_of_numbers(n) else n for n in s.readings))
        for s in (left, right)
    ]
    there = decide(
        sides[0], sides[1], chain.relations[k].sign, replace(knowledge, definitions=definitions)
    )
    texts = tuple(f"{formula_text(Name(n), plain=True)} in {unit}" for n, (unit, _) in units.items())
    if not there.is_proved:
        there = _by_its_constant(sides, chain.relations[k].sign, knowledge) or there
    return replace(there, assumptions=(*there.assumptions, *texts))


def _by_its_constant(sides: list[Side], sign: str, knowledge: Knowledge) -> Decision | None:
    """Return the proof that two formulas differ by no more than the constant of one is rounded.

    F = (W/g) ω² r = 0.00034 W N² r: of the letters on both sides nothing is left but a ratio.
    """
    left, right = sides
    constants = [n for n in decimals(right.node) if n.last_place is not None]
    own = names(left.node) & names(right.node)
    if len(constants) != 1 or not names(right.node) <= own:
        return None
    lettered = {n: d for n, d in knowledge.definitions.items() if n not in own}
    ratio = number_of(Quotient(left.node, right.node), replace(knowledge, definitions=lettered))
    (constant,) = constants
    if ratio is None or constant.last_place is None:
        return None
    exact = constant.value * Fraction(float(ratio))
    if 2 * abs(exact - constant.value) > constant.last_place:
        return None
    finer = Number(exact, constant.last_place / 10**9, span=constant.span)
    node = replace_part(right.node, constant, finer)
    there = decide(left, replace(right, readings=(node,)), sign, knowledge)
    return there if there.is_proved else None


def _units_in_words(
    text: str, knowledge: Knowledge, *nodes: Formula
) -> Iterator[tuple[str, tuple[str, Fraction]]]:
    """Yield the letters that a text says to be in a unit, with it: the deflection y in inches."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    for name in sorted({n for node in nodes for n in names_behind(node, values)}):
        if len(name) > 1:
            continue
        in_unit = rf"(?<![\w\\]){re.escape(name)}\$? in (?=[A-Za-z])"
        # the radius r ft.
        beside = rf"(?<=[A-Za-z]{{3}} )\$?{re.escape(name)}\$? (?=(?:ft|in)\.|[cm]m[\s,.;])"
        apposed = (
            rf"(?<![\w\\]){re.escape(name)}\$? (?:the|its|der|die|das) (?:[a-z]+ ){{1,6}}in (?=[A-Za-z])"
        )
        for match in re.finditer(f"{in_unit}|{beside}|{apposed}", text):
            unit = unit_in_words(text[match.end() : match.end() + 40])
            scale = scale_of(unit) if unit else None
            if scale is not None and not scale[1] and scale[0] != 1:
                yield name, (unit, scale[0])
                break


def _is_of_numbers(node: Formula) -> bool:
    """Tell whether a formula has letters and a constant for its units, a decimal of three digits.

    Of a small one two are enough, F = 0.00034 W N² r; 3.1416 is for no unit.
    """
    return bool(names(node)) and any(
        significant(number) >= FEWEST_DIGITS - (abs(number.value) < _SMALL)
        for number in decimals(node)
        if abs(number.value - _PI) > _NEAR_PI
    )


def _as_numbers(node: Formula, units: dict[str, tuple[str, Fraction]]) -> Formula:
    """Return a formula with each letter divided by its unit."""
    for name in sorted(names(node) & units.keys()):
        try:
            node = substitute(node, name, Quotient(Name(name), Number(units[name][1])))
        except NoFormError:
            continue  # a derivative by the letter: it stays one
    return node
