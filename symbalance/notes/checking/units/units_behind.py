"""Units that letters are counted in on one side, said in words behind it: ω = 2πn = πn/30 (n in 1/min).

Such a side is a formula between numbers: each of those letters stands in it divided by its unit. That is
the page's own condition, and named in the verdict.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Product, Quotient, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.units.own_units import is_angular_speed
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.spellings.numerals import unit_in_words
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_OPENED = re.compile(
    r"(?:[\s$\\,;~]|\\q?quad(?![a-z])|\\text\s*\{)*"
    r"(?:\(|,?\s*(?:with|where|when|if|mit|wobei|für|wenn|avec|où)\s)[\s$~]*(?:\\text\s*\{\s*)?"
)
_UNIT = r"(?P<unit>[A-Za-z1µ](?:[A-Za-zµ0-9/²³⁻¹^·.\\ -]|\{[-−]?[0-9]\}){0,30}?)"
_COUNTED = re.compile(
    rf"[\s$~]*(?P<letter>\\?[^\W\d_][A-Za-z0-9_{{}}]*)[\s$~]*(?:\\text\s*\{{)?[\s~]*"
    rf"(?:(?:is|ist|are|being|counted|measured|given|taken)\s+)*(?:in\s+|\[)[\s$~]*(?:\\(?:mathrm|text|unit|si)\s*\{{)?{_UNIT}"
    r"(?=[\s~$}\]]*(?:[,;)]|\.(?:\s|$)|\s(?:and|und|et)\s|$))"
)
_NEXT = re.compile(r"[\s~$}\]]*(?:[,;]|\s(?:and|und|et)\s)")
_LONGEST = 120
"""Characters behind a side in which the letters and their units are looked for."""


def letters_counted(text: str, letters: Mapping[str, str]) -> dict[str, tuple[str, Fraction]]:
    """Return the letters that a text begins by giving units, each with that and what it multiplies by.

    `letters` are those that may be meant, by the name as it is written. A speed in revolutions per minute
    counts turns, not radians.

    >>> letters_counted(" (n in 1/min)", {"n": "n"})
    {'n': ('1/min', Fraction(1, 60))}
    >>> letters_counted(", with P in kW and s in mm.", {"P": "P", "s": "s"})
    {'P': ('kW', Fraction(1000, 1)), 's': ('mm', Fraction(1, 1000))}
    """
    opened = _OPENED.match(text)
    counted: dict[str, tuple[str, Fraction]] = {}
    place = opened.end() if opened else len(text)
    while match := _COUNTED.match(text, place):
        name = letters.get(match["letter"].lstrip("\\").replace("{", "").replace("}", ""))
        unit = match["unit"].strip()
        scale = scale_of(unit) or scale_of(unit_in_words(unit) or "?")
        if name is not None and scale is not None:
            counted[name] = unit, scale[0] / 2 if scale[1] else scale[0]
        following = _NEXT.match(text, match.end())
        place = following.end() if following else len(text)
    return counted


def decide_as_counted(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the decision with the letters of a side counted as the words right behind it say."""
    left, right = chain.sides[k], chain.sides[k + 1]
    head = chain.sides[0].node
    own = names(left.node) | names(right.node) | names(head)
    text = document.text[right.span[1] : right.span[1] + _LONGEST].partition("\n\n")[0]
    counted = letters_counted(text, {name: name for name in own} | {plain_letter(n): n for n in own})
    scales = {
        name: scale
        for name, (_, scale) in counted.items()
        if scale != 1 and not is_angular_speed(name, knowledge.meanings)
    }
    if not scales:
        return None
    texts = tuple(f"{plain_letter(name)} is counted in {counted[name][0]} there" for name in scales)
    only_left = {n: scale for n, scale in scales.items() if n not in names(right.node)}
    there, value = None, _as_counted(right, scales)
    if k and isinstance(head, Name) and head.name in scales:
        size = Number(scales[head.name])  # P = M ω = M ω/1000 (P in kW): what stands there is in kW
        value = replace(value, readings=tuple(Product((node, size)) for node in value.readings))
    for of_left in dict.fromkeys((tuple(only_left.items()), tuple(scales.items()))):
        there = decide(_as_counted(left, dict(of_left)), value, chain.relations[k].sign, knowledge)
        if there.is_proved:
            return replace(there, assumptions=(*there.assumptions, *texts))
    return there


def _as_counted(side: Side, scales: Mapping[str, Fraction]) -> Side:
    return side.changed(lambda node: _divided(node, scales))


def _divided(node: Formula, scales: Mapping[str, Fraction]) -> Formula:
    """Return a formula with each letter divided by its unit."""
    for name in sorted(names(node) & scales.keys()):
        try:
            node = substitute(node, name, Quotient(Name(name), Number(scales[name])))
        except NoFormError:
            continue  # a derivative by the letter: it stays one
    return node
