"""Sizes that are chosen in the place of what was found: d = 2.48 in, say 2½ in.

A shaft has to be at least so thick, and is made in the next standard size. The words stand before
the size ("adopt", "gewählt wird", "on prendra") or behind it ("would be adopted", を採用する).
"Take" and "say" tell what is given too: behind them a size is chosen only if it is a rounder number
nearby.
"""

from __future__ import annotations

from symbalance.document.formula import Name, Number, names
from symbalance.notes.checking.deciding.numbers_put_in import significant_digits
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import Quantity, quantity_of
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_REACH = 60
"""Characters around a size in which its words stand."""
_NEAR = 0.25
"""How far a rounder number may be from the one that was found, as a part of it."""
_GAP = r"[\s$`\\(\[,:;]{0,6}"
_CHOOSES = re.compile(
    r"(?:(?<![^\W\d_])(?:"
    r"(?:partial|compromise|practical|usual|common|alternative|teilweise|übliche?|praktische?)"
    r"(?:\s+(?:solution|choice|value|design|arrangement|Lösung|Wahl|Wert)){0,2}(?:\s+is|\s+ist)?"
    r"|(?:next|nearest|standard|preferred|nominal|stock|commercial)"
    r"(?:\s+(?:larger|bigger|higher|smaller|standard|preferred|nominal|stock|available|commercial|whole)){0,2}"
    r"\s+(?:size|diameter|bore|value|dimension|number|thickness|width|length)(?:\s+(?:is|of|up))?"
    r"|(?:we\s+)?(?:adopt|choose|chose|select|selected|chosen)(?:ing|s)?"
    r"|(?:we\s+)?round(?:ed|ing)?(?:\s+(?:it|this))?\s+(?:up|off|down)(?:\s+to)?"
    r"|(?:gewählt|ausgeführt|aufgerundet|abgerundet)(?:\s+(?:wird|ist|auf|zu|mit))?"
    r"|(?:wir\s+wählen|man\s+wählt|wählen\s+wir|wählt\s+man)(?:\s+(?:also|daher))?"
    r"|nächst\w*\s+(?:genormte\w*\s+|größere\w*\s+)?(?:Norm\w*|Durchmesser|Größe|Wert|Maß)(?:\s+ist)?"
    r"|on\s+(?:choisit|choisira|adopte|adoptera|retient|retiendra|arrondit\s+à)(?:\s+donc)?"
    r"|(?:valeur|dimension|taille|diamètre)\s+normalisée?(?:\s+est)?"
    r"|(?:si\s+(?:sceglie|adotta)|scegliamo|adottiamo)(?:\s+quindi)?|arrotondat[oa]\s+a"
    r"|(?:se\s+(?:elige|escoge|adopta)|elegimos|escogemos|adoptamos|redondead[oa]\s+a)"
    r"|(?:escolhe-se|adota-se|adotamos|escolhemos))|規格(?:寸法)?(?:の|は|で))"
    rf"{_GAP}$",
    re.IGNORECASE,
)
"""Words right before a size that is chosen."""
_TAKES = re.compile(
    r"(?<![^\W\d_])(?:say|take|taking|use|using|made?|make\s+it|or|nehmen\s+wir|wir\s+nehmen|man\s+nimmt"
    r"|sagen\s+wir|on\s+prend(?:ra)?(?:\s+donc)?|prenons|disons|si\s+prende|prendiamo|diciamo"
    rf"|se\s+toma(?:rá)?|tomamos|tomemos|digamos|toma-se){_GAP}$",
    re.IGNORECASE,
)
"""Words right before a size that is chosen, or given."""
_CHOSEN = re.compile(
    r"[\s$`\\)\],;]{0,6}(?:(?:would|will|can|could|should|may|is|was|are|were)\s+){0,2}(?:then\s+|therefore\s+)?(?:be\s+)?"
    r"(?:adopted|chosen|selected|(?:is|was|be)\s+(?:used|taken))(?![^\W\d_])"
    r"|[\s$`\\)\],;]{0,6}(?:wird\s+|ist\s+|wurde\s+)?(?:daher\s+|also\s+)?(?:gewählt|ausgeführt)(?![^\W\d_])"
    r"|[\s$`\\)\],;]{0,6}(?:est|sera|a\s+été)\s+(?:donc\s+)?(?:choisie?|adoptée?|retenue?)(?![^\W\d_])"
    r"|[\s$`\\)\],;]{0,6}(?:è|viene|sarà)\s+(?:quindi\s+)?(?:scelt[oa]|adottat[oa])(?![^\W\d_])"
    r"|[\s$`\\)\],;]{0,6}(?:es|fue|será)\s+(?:el\s+)?(?:elegid[oa]|adoptad[oa]|escogid[oa])(?![^\W\d_])"
    r"|[\s$]{0,3}(?:を採用|を選|に丸め|に決め|に切り上げ)",
    re.IGNORECASE,
)
"""Words right behind a size that is chosen."""
_TAKEN = re.compile(r"[\s$]{0,3}(?:とする|とした|とします|にする)")


def leave_choice(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget what the lines above give a letter, where words say that another value is chosen."""
    head, text = chain.sides[0].node, state.document.text
    if k or not isinstance(head, Name):
        return False
    before, behind = (
        text[max(chain.start - _REACH, 0) : chain.start],
        text[chain.end : chain.end + _REACH],
    )
    behind = behind[_unit_length(behind) :]
    is_number = not names(chain.sides[1].node)  # a formula is chosen by the words before it: h = 0.7 b
    is_chosen = _CHOOSES.search(before) is not None or (is_number and _CHOSEN.match(behind) is not None)
    is_taken = is_number and (_TAKES.search(before) is not None or _TAKEN.match(behind) is not None)
    if not is_chosen and not (is_taken and _is_rounder(state, chain, head)):
        return False
    lines = {e.definition.line for e in state.definitions.values.get(head.name, ())}
    lines |= {p.line for p in state.definitions.premises if p.left == head}
    known = [state.definitions.forget_line(head.name, line) for line in sorted(lines)]
    return _leave_conditions(state, head.name) or any(known)


def _leave_conditions(state: JudgingState, name: str) -> bool:
    """Forget the equations of one letter alone, d³ = 15.28; tell if there were any."""
    definitions = state.definitions
    state.given_numbers.end(frozenset({name}), 0)
    kept = [p for p in definitions.premises if p.names != {name}]
    is_known = len(kept) < len(definitions.premises)
    definitions.premises = kept
    return is_known


def _is_rounder(state: JudgingState, chain: Chain, head: Name) -> bool:
    """Tell whether a number has fewer digits than the nearest one above of its letter, and is near it."""
    own = quantity_of(chain.sides[1], state.document)
    above = state.sections.chains_above(head, chain.start)
    numbers = [s for c in above for s in c.sides[1:] if not names(s.node)]
    found = quantity_of(numbers[-1], state.document) if numbers else None
    if own is None or found is None or not found.value or not own.value:
        return False
    ratio = float(own.value * own.scale / (found.value * found.scale))
    return abs(ratio - 1) < _NEAR and _digits(own) < _digits(found)


def _digits(quantity: Quantity) -> int:
    place = 2 * quantity.half if quantity.half and quantity.half < 1 else None
    number = Number(quantity.value, place)
    return significant_digits(number) if number.value.denominator == 1 or place else 2


def _unit_length(behind: str) -> int:
    """Return how many characters of a text's beginning close the formula and give its unit."""
    match = re.match(r"\$?\s?(?:in|ins|inches|ft|mm|cm|m|kg|N)?\.?\$?(?=[\s,;.をにと])", behind)
    return match.end() if match else 0
