"""Numbers put in whose unit the words right before the line say: (all in mm) s = 50 + 195.3 = 245.3.

The numbers then are in that unit, and so is what they come to, be it printed behind them or not.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, Number, Product, names
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.formulas.result_units import without_unit_of_result
from symbalance.notes.reading.spellings.numerals import unit_in_words
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

BY_WORDS = "its numbers are in {}, by the words"
_LONGEST = 160
"""Characters before a line in which the words are looked for."""
_MARKUP = re.compile(
    r"(?:[\s$&:：,.,、>]|\\\[|\\\(|\\begin\{[a-z]+\*?\}|\[stem\]|\+{4}|stem:\[|```\w*|<math[^<>]{0,40}>)+\Z"
)
"""What opens a display behind the words that lead to it."""
_BEFORE_UNIT = r"[\s$~]*(?:\\(?:mathrm|text|unit|si)\s*\{)?"
_SIGN = r"[A-Za-zµ]{1,12}(?:/[A-Za-z]+[²³]?)?(?![A-Za-z])"
_SAID = re.compile(
    rf"(?:(?<![^\W\d_])(?:in|en)\s{_BEFORE_UNIT}(?P<unit>{_SIGN})"  # all in mm, tout en mm, alles in mm
    rf"|(?:すべて|全て|単位は){_BEFORE_UNIT}(?P<counted>{_SIGN})"
    rf"|(?P<japanese>(?<![A-Za-z]){_SIGN})(?=[}}$]*(?:単位)?で))"
    r"[}$]*(?:単位)?で?\s*[)）\]]?\s*(?:gerechnet|calculé|(?:代入|計算)[^\s。]{0,8})?\s*\Z",
    re.IGNORECASE,
)
"""A unit at the end of words: "Plugging in (all in mm):", "With all lengths in mm:"."""


def decide_in_unit_for_all(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on numbers put in for letters in the unit of the words, None for others."""
    left, right = chain.sides[k], chain.sides[k + 1]
    if names(right.node) or not names(left.node) or (k and not isinstance(chain.sides[0].node, Name)):
        return None
    said, in_unit = _in_unit_said(chain, right, document)
    if in_unit is right:
        return None
    there = decide(left, in_unit, chain.relations[k].sign, knowledge)
    return replace(there, assumptions=(*there.assumptions, BY_WORDS.format(said)))


def result_in_unit_for_all(chain: Chain, k: int, document: ReadNotes, assumptions: str) -> Formula:
    """Return the right side of a relation in the unit that words give the numbers, as it was judged.

    `assumptions` are those of the relations of the chain: without that of the unit a side stays as it is.
    """
    right = chain.sides[k + 1]
    said, in_unit = _in_unit_said(chain, right, document)
    return in_unit.node if said and BY_WORDS.format(said) in assumptions else right.node


def _in_unit_said(chain: Chain, side: Side, document: ReadNotes) -> tuple[str, Side]:
    """Return the unit that words before a chain say, and a side in it; the side itself if it has one."""
    has_unit = without_unit_of_result(side) is not side.node or quantity_of(side, document) is not None
    said = "" if has_unit or names(side.node) else _unit_before(document.text, chain.start)
    scale = scale_of(said) if said else None
    if scale is None or scale[1] or scale[0] == 1:
        return "", side
    in_unit = tuple(Product((node, Number(scale[0])), span=node.span) for node in side.readings)
    return said, replace(side, readings=in_unit)


def _unit_before(text: str, place: int) -> str:
    """Return the unit that the words right before a place end with, "" for none.

    >>> _unit_before("Plugging in (all in mm): $$", 27), _unit_before("as in mm. Then $", 16)
    ('mm', '')
    """
    words = _MARKUP.sub("", text[max(0, place - _LONGEST) : place])
    said = _SAID.search(words)
    return unit_in_words(said["unit"] or said["counted"] or said["japanese"]) if said else ""
