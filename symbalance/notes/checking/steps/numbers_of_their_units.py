"""Formulas between the numbers of units that words give: ω = 2πn/60 with n in rpm, P = T n/9549 in kW.

Two letters for one speed in two units differ by a constant, and 60 n/(2π) has it upside down. A product
of letters in stated units is the law of the page, P = T ω, with what turns their units into one another.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import product

from symbalance.document.formula import Derivative, Formula, Name, Product, names, walk
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.deciding.values_at_points import solved_at, value_at
from symbalance.notes.checking.steps.angular_speeds_by_turns import is_of_another_shaft
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import NONE, unit_of
from symbalance.notes.checking.units.own_units import ANGULAR_LETTERS, is_divided_by_minute
from symbalance.notes.checking.units.units_of_letters import (
    LetterUnit,
    declared_units,
    text_around,
    unit_behind,
    unit_of_sentence,
    units_in_words,
)
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, PROVED_WORDS, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_JUDGED = (DEFINITION, PREMISE, UNDECIDED, *PROVED_WORDS)
_NUMERICAL = re.compile(
    r"numerical(?:\s+|-)(?:\w+\s+)?(?:relation|equation|formula|value|one)|numerical\s+(?:relation|equation)|(?<![^\W\d_])(?:insert|put(?:ting)?\s+in|plug(?:ged|ging)?\s+in|substitut)\w*[^.]{0,60}\s+in\s"
    r"|Zahlenwertgleichung|zugeschnittene\w*\s+Größengleichung|(?:setzt|eingesetzt|einsetzt|einsetzen)|formule\s+numérique|équation\s+aux\s+valeurs\s+numériques|formula\s+numerica"
    r"|equazione\s+fra\s+valori\s+numerici|fórmula\s+numérica|数値(?:式|方程式)",
    re.IGNORECASE,
)
"""Words that make an equation one between numbers."""
_OF_MORE = re.compile(
    r"fir(?:ing|es?\b)|ignit|combustion|torsional|vibration|cylinder|stroke|blade|tooth|teeth|beat|Zünd|Takt|Zylinder|Zähne|Schwing|allumage|temps|cylindre|dents|accension|tempi|cilindr"
    r"|denti|encendido|tiempos|dientes|点火|気筒|歯",
    re.IGNORECASE,
)
"""Words of frequencies that a shaft gives several times, or half a time, in a turn."""
_CONVERTING = re.compile(
    r"(?<![^\W\d_])(?:conver(?:sions?|ts?|ted|ting)|Umrechnung|umgerechnet|rechnet[^.;]{0,40}um|converti(?:r|t|e)|conversione|conversión"
    r"|convertito|convierte)(?![^\W\d_])|換算|変換",
    re.IGNORECASE,
)
"""Words by which a formula turns the number of one unit into that of another."""
_POWER, _TORQUE, _RATE = (unit_of(unit) or NONE for unit in ("W", "N m", "1/s"))
_REACH = 900
"""Characters before a formula in which words give its letters their units."""
_ROUNDED = 0.004
"""Parts by which a printed constant, 9550 for 9549.3, may be rounded."""
_POWERS = product((-2, -1, 0, 1, 2), (-2, -1, 0, 1, 2))
_SLIPS = tuple(60.0**a * math.tau**b for a, b in _POWERS if a or b)
_HALVES = (2.0, 0.5)
"""Slips of π for 2π, where two units are turned into one another."""
_ORDERS = re.compile(
    r"\borders?\b|ordnung|ordre|ordine|orden\b|harmoni|twice|double|doppelt|次", re.IGNORECASE
)
"""Words of what turns twice as fast."""
_POINTS = (1.0, 1.7, 2.3)


def has_several_in_a_turn(words: str) -> bool:
    """Tell whether words name what a shaft does several times in a turn, or once in two."""
    return _OF_MORE.search(words) is not None


def unless_of_other_units(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted for a formula that the units of its letters do not allow."""
    head, right = chain.sides[0].node, chain.sides[1].node
    own = names(right)
    is_formula = not k and own and isinstance(head, Name) and chain.relations[0].sign in "=≈"
    if not is_formula or verdict.verdict not in _JUDGED or not isinstance(head, Name) or head.name in own:
        return verdict
    if any(isinstance(part, Derivative) for part in walk(right)):
        return verdict
    units = _units(state, chain, head.name, own)
    reason = _of_one_speed(state, chain, head.name, right, units)
    reason = reason or _of_two_clocks(state, chain, right, units)
    reason = reason or _of_a_law(state, chain, head.name, right, units)
    if not reason:
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _units(state: JudgingState, chain: Chain, head: str, own: frozenset[str]) -> Mapping[str, LetterUnit]:
    """Return the units of a relation's letters: by the words of its paragraph, or as declared."""
    letters = own | {head}
    units = declared_units(state.declarations.symbols_at(chain.lines[0]), letters)
    text, sections = state.document.text, state.sections
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    first = max(min(first, chain.start), chain.start - _REACH)
    units |= units_in_words(text_around(text, first, chain.start, chain.end), letters)
    asked = unit_behind(text, chain.end) or unit_of_sentence(sections.sentence_leading_to(chain))
    known = units.get(head)
    if asked is not None and (known is None or known.unit.dimension == asked.unit.dimension):
        units[head] = asked
    return units


def _of_one_speed(
    state: JudgingState, chain: Chain, head: str, right: Formula, units: Mapping[str, LetterUnit]
) -> str:
    """Return why a multiple of one speed is not that speed in another unit; "" where it may be."""
    own = sorted(names(right))
    both = [units.get(name) for name in (head, *own)]
    first, second = both[0], both[1] if len(both) > 1 else None
    if (
        len(own) != 1
        or first is None
        or second is None
        or not (first.unit.is_rate and second.unit.is_rate)
    ):
        return ""
    sentence = state.sections.sentence_leading_to(chain)
    indices = {name.partition("_")[2] for name in (head, own[0])} - {""}
    if is_of_another_shaft(sentence) or _OF_MORE.search(sentence) or len(indices) > 1:
        return ""
    factor = _constant(right, own[0])
    if not factor:
        return ""
    right_factor = second.unit.scale / first.unit.scale
    allowed = [right_factor]
    is_conversion = not (first.is_worded or second.is_worded) and _CONVERTING.search(sentence) is not None
    if not (is_conversion or (second.is_worded and first.is_worded) or second.is_number):
        allowed.append(_between_quantities(head, own[0]))
    if any(math.isclose(factor, each, rel_tol=_ROUNDED) for each in allowed):
        return ""
    is_indexed = indices or _ORDERS.search(sentence)
    is_angular = any(name.partition("_")[0] in ANGULAR_LETTERS for name in (head, own[0]))
    is_converted = first.unit.scale != second.unit.scale and is_angular and not is_indexed
    slips = (*_SLIPS, *_HALVES) if is_converted else _SLIPS
    if not any(math.isclose(factor / right_factor, slip, rel_tol=_ROUNDED) for slip in slips):
        return ""
    shown = f"{plain_letter(own[0])} in {second.unit.text} and {plain_letter(head)} in {first.unit.text}"
    return f"with {shown} the factor is {right_factor:.4g}"


def _between_quantities(head: str, other: str) -> float:
    """Return the factor between two speeds as quantities: 2π of an angular one and one in turns."""
    angular = [name.partition("_")[0] in ANGULAR_LETTERS for name in (head, other)]
    return {(True, False): math.tau, (False, True): 1 / math.tau}.get((angular[0], angular[1]), 1.0)


def _constant(formula: Formula, name: str) -> float | None:
    """Return the constant that a letter is multiplied by; None for another formula."""
    values = [value_at(formula, {name: at}) for at in _POINTS]
    ratios = [None if v is None else v / at for v, at in zip(values, _POINTS, strict=True)]
    first = ratios[0]
    if first is None or any(r is None or not math.isclose(r, first, rel_tol=1e-9) for r in ratios):
        return None
    return first


def _of_two_clocks(
    state: JudgingState, chain: Chain, right: Formula, units: Mapping[str, LetterUnit]
) -> str:
    """Return why a formula counts by the minute what the page counts by the second, or the reverse."""
    head = units.get(chain.sides[0].node.name) if isinstance(chain.sides[0].node, Name) else None
    rates = [n for n in sorted(names(right)) if (unit := units.get(n)) is not None and unit.unit.is_rate]
    if len(rates) != 1 or head is None or head.unit.is_rate or len(names(right)) == 1:
        return ""
    unit, by_minute = units[rates[0]], is_divided_by_minute(right)
    others = [u for n, u in units.items() if n != rates[0]]
    is_si = len(others) == len(names(right)) and all(u.unit.scale == 1 for u in others)
    letter = plain_letter(rates[0])
    if by_minute and is_si and math.isclose(unit.unit.scale, math.tau):
        return f"{letter} counts revolutions by the second, and nothing is divided by 60"
    is_numbered = any(
        not names(side.node) for c in state.sections.chains_of(Name(rates[0])) for side in c.sides[1:]
    )
    is_minute = math.isclose(unit.unit.scale, math.pi / 30)
    is_bare = unit.is_number and is_minute and not by_minute and not is_numbered
    if is_bare and is_si and head.unit.dimension[2] and _has_few_constants(right, names(right)):
        return f"{letter} counts revolutions by the minute, and {head.unit.text} is by the second"
    return ""


def _has_few_constants(right: Formula, own: frozenset[str]) -> bool:
    """Tell whether the constant of a formula is a small one that turns no unit into another."""
    at_one = value_at(right, dict.fromkeys(own, 1.0))
    return at_one is not None and 1 / 16 <= abs(at_one) <= 16


def _of_a_law(
    state: JudgingState, chain: Chain, head: str, right: Formula, units: Mapping[str, LetterUnit]
) -> str:
    """Return why a formula between numbers is not the page's law with its units; "" where it may be."""
    own = sorted(names(right))
    if not {head, *own} <= units.keys():
        return ""
    if not _is_between_numbers(state, chain, units) and not _converts_power(head, right, units):
        return ""
    law = _law_above(state, chain, head, own, units)
    if law is None:
        return ""
    found = []
    for point in (1.0, 1.3, 0.8):
        values = {name: point + 0.37 * place for place, name in enumerate(own)}
        quantities = {name: value * units[name].unit.scale for name, value in values.items()}
        exact, claimed = solved_at(law, head, quantities), value_at(right, values)
        if exact is None or not claimed:
            return ""
        found.append(exact / units[head].unit.scale / claimed)
    if all(math.isclose(ratio, 1, rel_tol=_ROUNDED) for ratio in found):
        return ""
    shown = ", ".join(f"{plain_letter(name)} in {units[name].unit.text}" for name in (head, *own))
    return f"not the law above between the numbers of {shown}"


def _is_between_numbers(state: JudgingState, chain: Chain, units: Mapping[str, LetterUnit]) -> bool:
    """Tell whether words make a relation one between numbers: they name their units, or say so."""
    sections, text = state.sections, state.document.text
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    first = max(min(first, chain.start), chain.start - _REACH)
    said = _NUMERICAL.search(text[first : chain.start]) is not None
    worded = [unit.is_worded for name, unit in units.items()]
    return said and any(worded)


def _converts_power(head: str, right: Formula, units: Mapping[str, LetterUnit]) -> bool:
    """Tell whether a formula of power, torque and speed has a constant of units: 60, 9549 or the like."""
    letters = {head, *names(right)}
    if {units[name].unit.dimension for name in letters} != {_POWER, _TORQUE, _RATE} or len(letters) != 3:
        return False
    at_one = value_at(right, dict.fromkeys(names(right), 1.0))
    plain = (1.0, math.tau, 1 / math.tau)
    return at_one is not None and not any(math.isclose(at_one, each, rel_tol=1e-6) for each in plain)


_Law = tuple[Formula, Formula]


def _law_above(
    state: JudgingState, chain: Chain, head: str, own: list[str], units: Mapping[str, LetterUnit]
) -> _Law | None:
    """Return an equation of the paragraph between a relation's letters, a speed being ω there."""
    line, letters = chain.lines[0], {head, *own}
    rates = [name for name in letters if units[name].unit.is_rate]
    first = state.sections.start_of_line(state.sections.paragraph_start(line))
    for above in reversed(state.sections.chains_between(min(first, chain.start), chain.start)):
        if len(above.relations) != 1 or above.relations[0].sign != "=":
            continue
        left, right = (side.node for side in above.sides)
        there = names(left) | names(right)
        angular = [name for name in there - letters if name.partition("_")[0] in ANGULAR_LETTERS]
        if len(rates) == 1 and len(angular) == 1 and rates[0] not in there:
            left, right = (substitute(node, angular[0], Name(rates[0])) for node in (left, right))
            there = names(left) | names(right)
        elif rates and rates[0].partition("_")[0] not in ANGULAR_LETTERS:
            continue  # of n as a quantity: revolutions, or radians
        if there == letters:
            return left, right
    kinds = {units[name].unit.dimension: name for name in letters}
    if len(letters) == 3 and kinds.keys() == {_POWER, _TORQUE, _RATE}:
        return Name(kinds[_POWER]), Product((Name(kinds[_TORQUE]), Name(kinds[_RATE])))
    return None
