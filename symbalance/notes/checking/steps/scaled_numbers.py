"""Numbers for another speed: inertia forces grow as its square, F' = F (90/60)² and never F · 90/60.

A page has a number at one speed, and one at another speed from it by a ratio. Where the quantity's own
formula, or words of the sentence, say by which power of the speed it grows, the ratio has to stand in
that power; and a speed at which a force comes to a limit goes with the root of the forces' ratio.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    names,
)
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.powers_of_letters import PowersOfLetter
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OPEN = (DEFINITION, PREMISE, CONDITION, UNDECIDED)
_NUMBER = r"(?<![\w.,^_])(?P<number>[0-9]{1,9}(?:(?:[ ,.~]|\\,)[0-9]{1,9}){0,2})(?![0-9])"
_GAP = r"(?:[ ~$}]|\\[,;: ]|\\(?:mathrm|text|textrm|mbox|unit|si|rm)\s*\{?|[{(]){0,6}"
_SPEED_UNIT = (
    r"(?:rpm|r\.?p\.?m\.|rev(?:olutions|s)?\.?\s*(?:/|per|a)\s*min|r/min|U/min|Upm|1/min|min\s*\^?\{?-1|min⁻¹"
    r"|giri|tr/min|tours|obr|ot/min|ot\.|varv|omw|mph|miles?\s+(?:per|an)\s+hour|m\.?p\.?h|km/h|knots"
    r"|回転|毎分)"
)
_FORCE_UNIT = r"(?P<unit>k|M)?N(?![A-Za-z·\s]?\s?m(?![a-z]))(?![A-Za-z/])"
SPEED = re.compile(_NUMBER + _GAP + _SPEED_UNIT, re.IGNORECASE)
_FORCE = re.compile(_NUMBER + _GAP + _FORCE_UNIT)
SQUARE = re.compile(
    r"(?:scales?|grows?|rises?|increases?|goes|varies|proportional)[^.;\n]{0,30}?"
    r"(?:square\s+of\s+(?:the\s+)?(?:speed|revol|angular)|(?:n|N|w|ω|\\omega|\\Omega)\}?\s*(?:\^\s*\{?2|²))"
    r"|(?:as|with|by)\s+the\s+square\s+of\s+(?:the\s+)?(?:speed|revolutions|angular)"
    r"|Quadrat\s+der\s+(?:Drehzahl|Winkelgeschwindigkeit|Geschwindigkeit)|quadratisch\s+mit\s+der\s+Drehzahl"
    r"|carré\s+de\s+la\s+vitesse|cuadrado\s+de\s+la\s+velocidad|quadrato\s+della\s+velocità"
    r"|(?:∝|\\propto|~)\s*(?:n|N|w|ω|\\omega|\\Omega)\}?\s*(?:\^\s*\{?2|²)|(?:回転数|速度)の2乗",
    re.IGNORECASE,
)
_SPEED_WORDS = (
    r"(?:revolutions|rev/|rpm|r\.p\.m|speed|Drehzahl|giri|tours|obrot|otáč|varvtal|toerental|回転)"
)
_SURE = ("omega", "Omega", "w")
_TURNS = ("n", "N")
_STOPS = re.compile(r"[.;!?]\s|[。；]|\n\s*\n|\n\s*[-*•]")
_WITH_UNIT = 2
REACH = 200
"""Characters before a relation in which its sentence is looked at."""


def unless_scaled_wrongly(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number from another speed's is refuted where their ratio has a wrong power."""
    right = chain.sides[k + 1]
    head = chain.sides[0].node
    if k or verdict.verdict not in _OPEN or not isinstance(head, Name) or len(right.readings) != 1:
        return verdict
    change = _wrong_ratio(state, chain, head)
    if change is None:
        return verdict
    reason, part, corrected = change
    repair = Repair("exponent", replace_part(right.node, part, corrected), ((part, corrected),), 1.0)
    state.definitions.forget(head.name, chain.lines[0])
    fix = fix_of(repair, state.document, right) if state.corrects else None
    return replace(describe(state.document, chain, k, Decision(REFUTED, reason)), fix=fix)


def _wrong_ratio(state: JudgingState, chain: Chain, head: Name) -> tuple[str, Formula, Formula] | None:
    """Return what is wrong with a ratio of speeds or forces as typed, the ratio and what it should be."""
    text, factors = state.document.text, list(_factors(chain.sides[1].node))
    ratios = [(part, own) for part in factors if (own := _ratio(part)) is not None]
    if len(ratios) != 1:
        return None
    part, (first, second, power) = ratios[0]
    rest = [each for each in factors if each is not part]
    if len(rest) != 1 or first == second:
        return None
    quotient = Quotient(rational_node(first), rational_node(second))
    speeds, forces = _numbers(text, SPEED), _numbers(text, _FORCE)
    (base,) = rest
    if {first, second} <= speeds and not {first, second} & forces:
        expected = _power_of_speed(state, chain, head, base)
        if expected == 2 and power == 1:
            reason = "it grows as the square of the speed, and the ratio stands in the first power"
            return reason, part, Power(quotient, rational_node(Fraction(2)))
    is_speed = isinstance(base, Number) and base.value in speeds
    of_square = {value for value in (first, second) if _is_of_square(state, value)}
    is_limit = {first, second} & forces and {first, second} <= forces | of_square
    if is_speed and is_limit and of_square and not {first, second} & speeds and power == 1:
        reason = "the force grows as the square of the speed, so the speed as the root of the force"
        return reason, part, Call("sqrt", quotient)
    return None


def _factors(node: Formula) -> Iterator[Formula]:
    """Yield the factors of a product, without the factor of a unit that no digit stands for."""
    parts = node.factors if isinstance(node, Product) else (node,)
    for part in parts:
        if isinstance(part, Product):
            yield from _factors(part)
        elif not (isinstance(part, Number) and part.span == (0, 0)):
            yield part


def _ratio(node: Formula) -> tuple[Fraction, Fraction, Fraction] | None:
    """Return the numbers and the power of a ratio of two numbers, (90/60)²; None for other formulas."""
    match node:
        case Quotient(numerator=Number(value=first), denominator=Number(value=second)) if second:
            return first, second, Fraction(1)
        case Power(base=base, exponent=Number(value=power)) if (inner := _ratio(base)) is not None:
            return inner[0], inner[1], inner[2] * power
    return None


def _numbers(text: str, pattern: re.Pattern[str]) -> set[Fraction]:
    """Return the numbers that stand before a unit, in it and without its prefix."""
    values = set[Fraction]()
    for match in pattern.finditer(text):
        if (value := _value(match)) is None:
            continue
        values.add(value)
        if match.groupdict().get("unit") in ("k", "M"):
            values.add(value * (1000 if match["unit"] == "k" else 10**6))
    return values


def _value(match: re.Match[str]) -> Fraction | None:
    digits = re.sub(r"[ ~]|\\,", "", match["number"]).replace(",", ".").strip(".")
    return Fraction(digits) if digits and digits.count(".") <= 1 else None


def speed_of(match: re.Match[str]) -> float:
    """Return the speed that a text names, 0 for what cannot be read."""
    return float(_value(match) or 0)


def _leading(node: Formula) -> Fraction | None:
    """Return the number that a side consists of, without its unit and the wave it is the amplitude of."""
    if isinstance(node, Product):
        rest = [part for part in node.factors if not isinstance(part, Call)]
        unit = rest[1] if len(rest) == _WITH_UNIT else None
        is_unit = len(rest) == 1 or (isinstance(unit, Number) and unit.last_place is None)
        node = rest[0] if rest and is_unit and not any(map(names, rest)) else node
    return node.value if isinstance(node, Number) else None


def _power_of_speed(state: JudgingState, chain: Chain, head: Name, base: Formula) -> Fraction | None:
    """Return by which power of the speed a quantity grows, by words or its formula; or None."""
    text = state.document.text
    sentence = _STOPS.split(text[max(0, chain.start - REACH) : chain.start])[-1]
    if SQUARE.search(sentence):
        return Fraction(2)
    owners = [each for each in (base, head) if isinstance(each, Name)]
    degrees = {_powers(state).of_letter(owner.name, chain.start) for owner in owners}
    degrees -= {None}
    return degrees.pop() if len(degrees) == 1 else None


def _is_of_square(state: JudgingState, value: Fraction) -> bool:
    """Tell whether a printed force came out of a formula that has the square of the speed."""
    formula = state.results.of_formulas.get(value) or state.results.of_formulas.get(value / 1000)
    chains = [
        c
        for c in state.document.chains
        if any(_leading(side.node) in (value, value * 1000) for side in c.sides[1:])
    ]
    nodes = [node for c in chains for side in c.sides if names(node := side.node)]
    nodes += [] if formula is None else [formula]
    return any(_powers(state).of(node) == 2 for node in nodes) or any(
        _has_squared_speed(state, c) for c in chains
    )


def _has_squared_speed(state: JudgingState, chain: Chain) -> bool:
    """Tell whether an arithmetic has the number of an angular speed squared: 0.45·0.04·502.7²."""
    letters = {*_SURE} & state.results.numbers.keys()
    speeds = {_leading(value) for n in letters for value in state.results.numbers[n][1]}
    return any(_squares(side.node, speeds) for side in chain.sides)


def _squares(node: Formula, speeds: set[Fraction | None]) -> bool:
    factors = node.factors if isinstance(node, Product) else (node,)
    return any(
        isinstance(part, Power)
        and isinstance(part.base, Number)
        and part.base.value in speeds
        and part.exponent == Number(Fraction(2))
        for part in factors
    )


def is_speed(state: JudgingState, name: str) -> bool:
    """Tell whether a letter is the speed of the page: ω, or an n that counts turns by its words."""
    return name in _SURE or (name in _TURNS and _counts_turns(state, name))


def _powers(state: JudgingState) -> PowersOfLetter:
    return PowersOfLetter(state.sections, lambda name: is_speed(state, name))


def _counts_turns(state: JudgingState, name: str) -> bool:
    """Tell whether a page says that n or N is a speed, by its unit or words beside it."""
    letter = rf"(?<![A-Za-z\\]){name}(?![A-Za-z])"
    pattern = rf"{letter}[^.\n]{{0,30}}?{_SPEED_WORDS}|{_SPEED_WORDS}[^.\n=]{{0,30}}?{letter}"
    return re.search(pattern, state.document.text, re.IGNORECASE) is not None
