"""Dead centres of an offset crank: θ_T = arcsin(e/(l + r)), and θ_B = 180° + arcsin(e/(l - r)).

There crank and rod lie on one line through the piston pin, which is e beside the crank's centre. It is
l + r long where they are stretched, and l - r where they are folded.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.meant.letter_roles import index_of
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.checking.words.places_in_words import dead_centre_named
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_OFFSET = re.compile(
    r"(?<!no )(?<!without )\boffset|d[eé]sax|(?<!un)(?<!nicht )geschränkt|schränkung|desas|dé[sp]ort"
    r"|オフセット|片寄り|excéntric\w*"
    r"|descentrad|disassat",
    re.IGNORECASE,
)
_DEAD = re.compile(
    r"dead[\s-](?:cent|point)|totpunkt|totlage|streck|\bstretched|\bfolded|points?\s+morts?|punt[oi]\s+mort[oi]"
    r"|puntos?\s+muertos?|死点",
    re.IGNORECASE,
)
_BOTTOM = re.compile(r"(?:b|B|BDC|UT|u|U|PMB|PMI|bot|bottom|unten|2|II)")
_TOP = re.compile(r"(?:t|T|TDC|OT|o|O|PMH|PMS|top|oben|1|I)")
_FOLDED = re.compile(r"\bfolded|decklage|\brepli|piegat|plegad", re.IGNORECASE)
_STRETCHED = re.compile(r"\bstretched|\bextended|strecklage|\btes[ei]\b|estirad", re.IGNORECASE)
_NEAR = 500
"""Characters before a formula in which words speak of an offset crank's dead centres."""
_CLAUSE = 80
_LETTERS = 3
"""The offset, the rod and the crank."""


class _Place(NamedTuple):
    """A dead centre as a formula has it: whether half a turn stands there, and the crank is taken off."""

    has_half_turn: bool
    is_difference: bool
    letters: tuple[str, str, str]


def decide_offset_dead_centre(
    chain: Chain, k: int, document: ReadNotes, meanings: Mapping[str, str]
) -> Decision | None:
    """Return the decision on the angle of an offset crank's dead centre; None for other formulas."""
    head = chain.sides[0].node
    place = None if k or not isinstance(head, Name) else _place(chain.sides[1].node)
    if place is None or not isinstance(head, Name):
        return None
    meaning = meanings.get(head.name, "")
    before = document.text[max(0, chain.start - _NEAR) : chain.start]
    near = glossary_of(document.text).english(f"{before} {meaning}")
    if not _OFFSET.search(document.text) or not _DEAD.search(near):
        return None
    is_bottom = _is_bottom(head.name, meaning, near[-_CLAUSE:] if not meaning else "")
    if is_bottom is None or is_bottom != place.has_half_turn:
        return None
    which = "bottom" if is_bottom else "top"
    said = f"declared as “{meaning}”" if meaning else f"{NOBODY}; its index or the words before say so"
    text = f"{plain_letter(head.name)} is the crank angle at the {which} dead centre ({said})"
    if place.is_difference == is_bottom:
        return Decision(PROVED, assumptions=(text,))
    offset, rod, crank = map(plain_letter, place.letters)
    sign, how = ("-", "folded") if is_bottom else ("+", "stretched")
    reason = f"if {text}: crank and rod are {how} there, so it is arcsin({offset}/({rod} {sign} {crank}))"
    return Decision(REFUTED, reason)


def _place(node: Formula) -> _Place | None:
    """Return what a formula 180° + arcsin(e/(l - r)) has of a dead centre, None for another one."""
    terms = node.terms if isinstance(node, Sum) else (node,)
    waves = [term for term in terms if isinstance(_bare(term), Call)]
    rest = [term for term in terms if term not in waves]
    if len(waves) != 1 or any(names(term) for term in rest) or len(rest) > 1:
        return None
    if rest and not any(part == Constant("pi") for part in walk(rest[0])):
        return None
    wave = _bare(waves[0])
    if not isinstance(wave, Call) or wave.function != "asin" or not isinstance(wave.argument, Quotient):
        return None
    above, below = wave.argument.numerator, wave.argument.denominator
    if not isinstance(above, Name) or not isinstance(below, Sum) or len(below.terms) != _LETTERS - 1:
        return None
    first, second = below.terms
    other = _bare(second)
    if (
        not isinstance(first, Name)
        or not isinstance(other, Name)
        or len({above, first, other}) < _LETTERS
    ):
        return None
    return _Place(bool(rest), isinstance(second, Negative), (above.name, first.name, other.name))


def _bare(node: Formula) -> Formula:
    return node.operand if isinstance(node, Negative) else node


def _is_bottom(name: str, meaning: str, clause: str) -> bool | None:
    """Tell whether a letter is of the bottom dead centre, None where nothing says which it is of."""
    index, words = index_of(name), f"{meaning} {clause}"
    named = dead_centre_named(words)
    if named is not None:
        return named
    if bool(_FOLDED.search(words)) != bool(_STRETCHED.search(words)):
        return _FOLDED.search(words) is not None
    if _BOTTOM.fullmatch(index):
        return True
    return False if _TOP.fullmatch(index) else None
