"""Values said again in another unit: with v = 10 m/s we get v = 36 km/h; in SI units m = 0.5 kg.

The words make the second number the first one converted, and no new case: another size is a slip.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import Quantity, quantity_of
from symbalance.notes.checking.units.dimensions import unit_of
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_BECOMES = re.compile(
    r"[\s$,()]*(?:(?:wird|ist|sind|gilt|entspricht|ergibt\s+sich|erhält\s+man|folgt|haben\s+wir|also|das\s+heißt|d\.\s?h\.|bzw\.|we\s+(?:have|get|find)"
    r"|one\s+(?:has|gets)|it\s+(?:is|becomes)|this\s+(?:is|gives)|which\s+is|that\s+is|i\.\s?e\.|gives?|becomes|is|on\s+a|cela\s+donne|on\s+obtient|soit|donc"
    r"|si\s+ha|si\s+ottiene|cioè|ossia|diventa|se\s+tiene|tenemos|es\s+decir|o\s+sea|すなわち|つまり|は)[\s$,:(]*){1,3}",
    re.IGNORECASE,
)
"""All that stands between a value and the same one in another unit."""
_IN_UNITS = re.compile(
    r"(?<![^\W\d_])(?:in\s+(?:the\s+)?(?:SI|base|basic|coherent|metric|proper)(?:[-\s]units?)?|converted|in\s+(?:SI|Basis|Grund)-?\s?Einheiten|umgerechnet"
    r"|en\s+unités\s+(?:SI|de\s+base)|converti[es]?|in\s+unità\s+(?:SI|di\s+base)|convertit[oai]|en\s+unidades\s+(?:SI|básicas)|convertid[oa]s?)"
    r"(?![^\W\d_])[^.;:!?]{0,40}$|(?:SI単位|換算)[^。、]{0,20}$",
    re.IGNORECASE,
)
"""Words before a value that is said again in other units."""
_OTHER = re.compile(
    r"(?<![^\W\d_])(?:other|another|new|second|anderen?|anderes|neuen?|zweiten?|autre|nouvelle?|altr[ao]|nuov[ao]|otr[ao]|nuev[ao])(?![^\W\d_])|別の|他の",
    re.IGNORECASE,
)
_NUMBER = re.compile(r"\s*[-−+]?[0-9](?:[0-9.]|\{,\}|,(?=[0-9])|\\,(?=[0-9]))*")
_POWER = re.compile(
    r"^\s*(?:\\(?:cdot|times)|[·×⋅])\s*10(?:\s*\^\s*(?:\{\s*[-−+]?[0-9]{1,2}\s*\}|[-−+]?[0-9]{1,2})|[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,2})"
)
"""The number that a value begins with, and the power of ten behind it."""
_REACH = 120
_SAME = 1e-9
FEWEST_DIGITS = 2
"""Of two values that are the same one: 4 mm and 4 cm may be two."""


def unless_converted_wrongly(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where words say a value again in another unit, and it is another size."""
    head, last = chain.sides[0].node, chain.sides[-1]
    is_open = verdict.verdict in (PREMISE, UNDECIDED, DEFINITION)
    if k or not is_open or not isinstance(head, Name) or len(chain.relations) != 1 or names(last.node):
        return verdict
    moved = _value_with_its_point_moved(state, chain, head)
    if moved is not None:
        state.definitions.forget(head.name, chain.lines[0])
        typed = state.document.source(moved.sides[-1].span)
        reason = f"the digits of line {moved.lines[0]}, {typed}, and another size"
        return describe(state.document, chain, k, Decision(REFUTED, reason))
    now = quantity_of(last, state.document)
    before = _value_before(state, chain, head) if now is not None else None
    earlier = None if before is None else quantity_of(before.sides[-1], state.document)
    if now is None or before is None or earlier is None or now.unit == earlier.unit:
        return verdict
    if unit_of(now.unit) is None or unit_of(now.unit) != unit_of(earlier.unit):
        return verdict
    if not _differ(now, earlier):
        return verdict
    value = float(earlier.value * earlier.scale / now.scale)
    state.definitions.forget(head.name, chain.lines[0])
    reason = f"{plain_text(head)} of line {before.lines[0]} is {value:.6g} {now.unit}"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _value_before(state: JudgingState, chain: Chain, head: Name) -> Chain | None:
    """Return the relation above whose value words say again with a chain, None where none do."""
    text, above = state.document.text, state.sections.last_above(head, chain.start)
    if above is None or not state.sections.same_section(above.lines[0], chain.lines[0]):
        return None
    if names(above.sides[-1].node):
        return None
    behind = text[above.end : chain.start]
    is_next = state.sections.chain_before(chain.start) is above
    if is_next and _BECOMES.fullmatch(_without_unit(behind)):
        return above
    words = text[max(above.end, chain.start - _REACH) : chain.start]
    sentence = re.split(r"[.;!?]\s|。|\n\s*\n", words)[-1]
    is_said = _IN_UNITS.search(sentence.rstrip(" $\\({")) is not None
    return above if is_said and not _OTHER.search(sentence) else None


def _value_with_its_point_moved(state: JudgingState, chain: Chain, head: Name) -> Chain | None:
    """Return the value above that has the digits of a chain's, 43 mm and 43·10⁻² m, in another size.

    The units are not the same, and the sizes a power of ten apart: no case is chosen so.
    """
    above = state.sections.last_above(head, chain.start)
    if (
        above is None
        or names(above.sides[-1].node)
        or _OTHER.search(state.sections.sentence_before(chain))
    ):
        return None
    first, second = (state.document.source(each.sides[-1].span) for each in (above, chain))
    numbers = [_NUMBER.match(typed) for typed in (first, second)]
    sizes = [number_of(each.sides[-1].node, Knowledge()) for each in (above, chain)]
    if None in numbers or None in sizes or not all(sizes):
        return None
    digits = {re.sub("[^0-9]", "", m[0]).strip("0") for m in numbers if m is not None}
    units = {
        _POWER.sub("", typed[m.end() :]).strip(" ~$.,;")
        for typed, m in zip((first, second), numbers, strict=True)
        if m
    }
    ratio = Fraction(str(float(sizes[1]))) / Fraction(str(float(sizes[0])))
    shifted = f"{abs(float(ratio)):e}"
    is_moved = shifted.startswith("1.000000e") and not shifted.endswith("e+00")
    return (
        above
        if is_moved and len(digits) == 1 and len(digits.pop()) >= FEWEST_DIGITS and len(units) == 2
        else None
    )


def _without_unit(behind: str) -> str:
    """Return what stands behind a value without the dollar that ends it."""
    return behind.lstrip("$ ")


def _differ(now: Quantity, earlier: Quantity) -> bool:
    """Tell whether two values are of different sizes, each off by half of its last place."""
    gap = abs(now.value * now.scale - earlier.value * earlier.scale)
    return float(gap) > float(now.half * now.scale + earlier.half * earlier.scale) * (1 + _SAME)
