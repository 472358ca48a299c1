"""Results in turns whose formula has radians, or the other way round: √(c/m) = 50 Hz, n/60 = 50 rad/s.

A turn is 2π radians, and both are counted by the second. So a number may be right in itself and stand
before a wrong unit. What a formula counts is known by its letters and by its factor of π: n in
revolutions per minute counts turns, 2πn/60 radians, and the root of a stiffness over a mass is in
radians. Behind s⁻¹ alone either may be meant.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import pi

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.units.dimensions import RADIANS, Dimensions, unit_of, written_unit
from symbalance.notes.checking.units.own_units import ANGULAR, ANGULAR_LETTERS, BY_THE_SECOND, PER_MINUTE
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

TURNS = "turns"
_NEAR = 0.02
"""By how much a formula's number and the typed one may differ by their rounding."""
_DEEPEST = 12
_IN_TURNS = re.compile(rf"(?:{BY_THE_SECOND}|{PER_MINUTE})")
_BEGINS_IN_TURNS = re.compile(rf"(?:{BY_THE_SECOND}|{PER_MINUTE})(?![A-Za-z])")
_WORDS_OF_UNIT = re.compile(rf"[\s$]{{0,3}}(?:{BY_THE_SECOND}|{PER_MINUTE})(?![A-Za-z])")
_IN_RADIANS = re.compile(r"rad\s?(?:/\s?s(?:ec)?|s\s?(?:\^?\s?[-−]1|⁻¹))")
_UNIT_BEHIND = re.compile(r"(?:\s|[~$]|\\[,;: ]|\\(?:mathrm|text|unit)\s*\{){0,5}(?P<unit>[^=\n]{1,24})")
_PER_MINUTE = re.compile(PER_MINUTE)
_KILO = {"k": 1e3, "M": 1e6}
_THOUSANDS = re.compile(r"(?<=[0-9])(?:\\,|[ \u2009\u202f])(?=[0-9]{3}(?![0-9]))")
_COMMA = re.compile(r"(?<=[0-9]),(?=[0-9])")
_NUMBER = re.compile(r"[\s$]*(?P<number>[0-9]+(?:\.[0-9]+)?)(?![0-9.])")
_OF_TURNS = re.compile(
    r"turns|revolution|rotation|rpm|Hz|min|Drehzahl|Umdrehung|(?<!angular )(?<!circular )frequency"
    r"|(?<!kreis)frequenz"
    r"|(?<!角)周波数|(?<!角)振動数|回転数|tours|giri",
    re.IGNORECASE,
)
"""Words of a meaning by which an ω is no angular speed."""


def refute_turns(
    chain: Chain,
    k: int,
    document: ReadNotes,
    dimensions_of: Callable[[], Dimensions],
    knowledge: Knowledge,
) -> Decision | None:
    """Refute ω/2 = 157 rpm and n/60 = 50 rad/s, whose numbers are right and whose units are not.

    None for every other relation. `dimensions_of` is asked only where a result has a unit of either kind.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1]
    typed = _typed(document.source(right.span)) or _typed(_with_unit_behind(right.span, document.text))
    if typed is None or names(right.node) or not names(left) or chain.relations[k].sign not in "=≈":
        return None
    number, unit = typed
    if not (of_right := _kind_of_unit(unit)):
        return None
    kinds = _Kinds(document, dimensions_of(), knowledge)
    of_left = kinds.of(left) or kinds.of_head(chain)
    if not of_left or of_left == of_right:
        return None
    value = number_of(left, knowledge)
    if not value or not number or abs(float(value) / number - 1) > _NEAR:
        return None
    is_minute = _PER_MINUTE.match(unit) is not None
    if of_right == RADIANS:
        reason = f"dimensions: a turn is 2π radians; {number:g} rad/s is {number / (2 * pi):.4g} turns/s"
        exact = 2 * pi * number
        return Decision(REFUTED, reason, witness={"left": f"{exact:.4g}", "right": f"{number:g}"})
    per_second = number * 2 * pi * (1 / 60 if is_minute else 1)
    in_turns = number / (2 * pi) * (60 if is_minute else 1)
    reason = f"dimensions: a turn is 2π radians; {number:g} {unit} is {per_second:.4g} rad/s"
    return Decision(REFUTED, reason, witness={"left": f"{in_turns:.4g}", "right": f"{number:g}"})


def _typed(source: str) -> tuple[float, str] | None:
    """Return the number and the unit of a side as it is typed, the number in whole units of its kind."""
    plain = _THOUSANDS.sub("", source)
    plain = _COMMA.sub(".", plain.replace("{,}", "."))
    match = _NUMBER.match(plain)
    has_number, unit = written_unit(plain)
    if match is None or not has_number or not unit:
        return None
    factor = _KILO.get(unit[0], 1.0) if unit[1:] == "Hz" else 1.0
    return float(match["number"]) * factor, unit


def _with_unit_behind(span: tuple[int, int], text: str) -> str:
    """Return a number with the unit behind it that is read as words there: 314,2 giri/min."""
    behind = _WORDS_OF_UNIT.match(text, span[1])
    return text[span[0] : span[1]] if behind is None else text[span[0] : behind.end()]


def _kind_of_unit(unit: str) -> str:
    """Return whether a unit counts turns or radians by the time, "" for any other.

    >>> _kind_of_unit("Hz"), _kind_of_unit("U/min"), _kind_of_unit("rad/s"), _kind_of_unit("1/s")
    ('turns', 'turns', 'rad/s', '')
    """
    if _IN_RADIANS.fullmatch(unit):
        return RADIANS
    return TURNS if _IN_TURNS.fullmatch(unit) or _PER_MINUTE.fullmatch(unit.rstrip("1")) else ""


class _Kinds:
    """What the formulas of a page count by the second, turns or radians."""

    def __init__(self, document: ReadNotes, dimensions: Dimensions, knowledge: Knowledge) -> None:
        self.document, self.dimensions, self.knowledge = document, dimensions, knowledge

    def of_head(self, chain: Chain) -> str:
        """Return the kind of a chain by the letter at its head: ω is in radians."""
        head = chain.sides[0].node
        return RADIANS if isinstance(head, Name) and self._is_angular(head.name) else ""

    def of(self, node: Formula, depth: int = 0) -> str:
        """Return what a formula counts, "" where that is open."""
        kind = ""
        match node:
            case _ if depth > _DEEPEST:
                pass
            case Name(name=name):
                kind = self._of_letter(name, depth + 1)
            case Sum(terms=terms):
                kinds = {self.of(term, depth + 1) for term in terms}
                kind = kinds.pop() if len(kinds) == 1 else ""
            case Product() | Quotient() | Negative():
                kind = self._of_product(node, depth + 1)
            case Call(function="sqrt", argument=argument):
                kind = self._of_root(argument)
            case Power(base=base, exponent=exponent) if exponent == Quotient(_ONE, _TWO):
                kind = self._of_root(base)
        return kind

    def _of_product(self, node: Formula, depth: int) -> str:
        """Return the kind of numbers times one factor that has a kind; a π turns turns into radians."""
        pis, counted = 0, []
        for factor, power in _factors(node):
            if isinstance(factor, Constant) and factor.name == "pi":
                pis += power
            elif not isinstance(factor, Number):
                counted.append((factor, power))
        if len(counted) != 1 or counted[0][1] != 1:
            return ""
        kind = self.of(counted[0][0], depth)
        if not pis or not kind:
            return kind
        is_turned = (kind, pis) in ((TURNS, 1), (RADIANS, -1))
        return {TURNS: RADIANS, RADIANS: TURNS}[kind] if is_turned else ""

    def _of_root(self, below: Formula) -> str:
        """Return the kind of the root of a stiffness over a mass: radians; of turns it is open."""
        own = [part.name for part in walk(below) if isinstance(part, Name)]
        has_pi = any(isinstance(part, Constant) for part in walk(below))
        is_counted = any(self._of_letter(name, 1) for name in own)
        is_open = has_pi or is_counted or not own
        return RADIANS if not is_open and self.dimensions.side(below, "") == unit_of("1/s^2") else ""

    def _of_letter(self, name: str, depth: int) -> str:
        definition = self.knowledge.definitions.get(name)
        by_unit, numbers = "", []
        if definition is not None:
            numbers = [n for n in walk(definition.node) if isinstance(n, Number) and n.span[1]]
        if definition is not None and not names(definition.node) and numbers:
            behind = _UNIT_BEHIND.match(self.document.text, numbers[0].span[1])
            by_unit = _kind_begun(behind["unit"]) if behind else ""
        if self._is_angular(name):
            # an ω that is printed in Hz may be a frequency, and one in rpm was turned into radians
            is_frequency = by_unit == TURNS and definition is not None and len(numbers) == 1
            return "" if is_frequency else RADIANS
        if by_unit or definition is None:
            return by_unit
        return self.of(definition.node, depth) if names(definition.node) else ""

    def _is_angular(self, name: str) -> bool:
        meaning = self.knowledge.meanings.get(name, "")
        if role_of(meaning) == ANGULAR:
            return True
        is_usual = name.partition("_")[0].rstrip("'") in ANGULAR_LETTERS
        return is_usual and _OF_TURNS.search(meaning) is None


_ONE, _TWO = (Number(Fraction(value)) for value in (1, 2))


def _kind_begun(text: str) -> str:
    """Return the kind of the unit that a text begins with."""
    if _IN_RADIANS.match(text):
        return RADIANS
    return TURNS if _BEGINS_IN_TURNS.match(text) else ""


def _factors(node: Formula, power: int = 1) -> list[tuple[Formula, int]]:
    """Return the factors of a product with 1 for those above the stroke and -1 for those below."""
    match node:
        case Product(factors=factors):
            return [each for factor in factors for each in _factors(factor, power)]
        case Quotient(numerator=above, denominator=below):
            return [*_factors(above, power), *_factors(below, -power)]
        case Negative(operand=operand):
            return _factors(operand, power)
    return [(node, power)]
