"""Values that sentences give to letters: the mass $m$ is 0.5 kg, a radius r of 45 mm, r beträgt 45 mm.

Only of a letter that no relation of the page gives or works out, and to which the sentences give one
value: what a page computes is a result, and two values are two cases. Of a maximum or a mean nothing is
taken, since the letter is not always that, nor of what is said of a case.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from symbalance.document.formula import Name, Span, names
from symbalance.notes.checking.page.words_of_values import (
    COUNTED,
    GIVEN,
    GIVEN_BEFORE,
    SAID,
    SETTING,
    as_unit,
    unit_behind,
)
from symbalance.notes.reading.equations import ReadNotes
from symbalance.notes.reading.spellings.numerals import unit_spelled
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_GOES_ON = re.compile(
    r"\s*(?:[-+−±·*×/^=<>≈≤≥]|\\(?:cdot|times|pm)|(?:less|more|greater|larger|smaller|higher|lower|longer"
    r"|shorter|times|too|above|below|behind|before|after|ahead|apart|to|bis|mehr|weniger|größer|kleiner|höher"
    r"|länger|kürzer|plus|moins|más|più|per|by)(?![A-Za-z])|[より]"
    r"|(?:or|oder|ou|o)\s\$?(?:[0-9]|more|less|even|mehr|weniger|plus|moins))"
)
_OF_A_CASE = re.compile(
    r"(?:\bmax|\bmin|\bpeak|\bmean\b|\baverage|amplitude|\blargest|\bsmallest|\bgreatest|\bmittler|höchst|größt"
    r"|kleinst|moyen|medi[oa]|\bif\b|\bwhen\b|\bwhere\b|\bfor\b|\bwenn\b|\bfalls\b|\bfür\b|\bsi\b|\bpour\b"
    r"|\binstead|\bwere\b|\bwould\b|\bsuppose|change|difference|error|ratio(?![\s,]*$)|multiple|fraction|\bhalf\b|\btwice"
    r"|\bnot\b|nicht|平均|最大|最小|とき|なら)",
    re.IGNORECASE,
)
_OF_OTHERS = re.compile(
    r"\bmax|\bmin\b|\bminim|\bpeak|\bmean\b|\baverage|amplitude|\blargest|\bsmallest|\bgreatest|\bmittler|höchst|größt|kleinst"
    r"|moyen|medi[oa]\b|\binstead|\bwere\b|\bwould\b|\bnot\b|nicht|unlike|although|whereas|während|平均|最大|最小|ではな",
    re.IGNORECASE,
)
"""Words of a value that is not the letter's own where it stands."""
_CLAUSE = re.compile(r"(?:[.!?;。；]\s|\n\s*\n|。)")
_LONGEST_CLAUSE = 120
_KANA = "\u3041"
"""From here on a sign is one of Japanese words, and no letter of a formula."""
_FEW_SIDES = 3
"""Of a formula in a sentence, 2R = 2·40 = 80 mm; a longer chain is a derivation."""
_AREAS = frozenset({"mm²", "cm²", "m²", "mm^2", "cm^2", "m^2", "mm2", "cm2", "m2"})
_AWAY = re.compile(
    r"\s*(?:from|away|off|apart|vom|von|entfernt|d[ae]l?(?:la)?|du|des?|à|above|below|left|right|over|über|unter|de)(?![^\W\d_])"
)
"""Behind a length, where it is that from one place to another."""
_SIZES = frozenset({"mm", "cm", "m", "in", "ft", "kg", "g", "lb"})
"""Units of numbers that may stand beside their letter without a verb."""


@dataclass(frozen=True, slots=True)
class GivenInProse:
    """A letter and the value that a sentence gives it, with their places in the page."""

    letter: str
    letter_span: Span
    value: str
    value_span: Span


def values_in_prose(
    page: ReadNotes, letter_of: Callable[[GivenInProse], str | None]
) -> Iterator[GivenInProse]:
    """Yield the values that sentences give; `letter_of` names the letter, None for what is no letter."""
    if not page.chains:
        return  # nothing is computed from them
    own = {side.node.name for chain in page.chains for side in chain.sides if isinstance(side.node, Name)}
    given: dict[str, list[GivenInProse]] = {}
    for found in (*_given(page.text), *_given_before(page.text), *_of_formulas(page)):
        name = letter_of(found)
        if name is not None:
            given.setdefault(name, []).append(found)
    for name, values in given.items():
        if name not in own and len({value.value for value in values}) == 1:
            yield values[0]


def _of_formulas(page: ReadNotes) -> Iterator[GivenInProse]:
    """Yield the values that formulas come to of which a sentence says that a letter is that."""
    for chain in page.chains:
        first, last = chain.sides[0], chain.sides[-1]
        if isinstance(first.node, Name) or names(last.node) or len(chain.sides) > _FEW_SIDES:
            continue
        start = max(chain.start - _LONGEST_CLAUSE, 0)
        match = SAID.search(page.text, start, chain.start)
        if match is None or _OF_A_CASE.search(_CLAUSE.split(page.text[start : match.start()])[-1]):
            continue
        letter, place = _letter_in(match)
        value = " ".join(SETTING.sub(" ", page.source(last.span).replace("{,}", ",")).split())
        yield GivenInProse(letter, place, value, last.span)


def values_said(text: str, first: int, last: int) -> Iterator[GivenInProse]:
    """Yield the values that a stretch of a text gives, also for a case: for a ring where μ is 0.25."""
    yield from _given(text, first, last, _OF_OTHERS)


def _given(
    text: str, first: int = 0, last: int | None = None, unless: re.Pattern[str] = _OF_A_CASE
) -> Iterator[GivenInProse]:
    for match in GIVEN.finditer(text, first, len(text) if last is None else last):
        clause = _CLAUSE.split(text[max(match.start() - _LONGEST_CLAUSE, 0) : match.start()])[-1]
        unit, end = _unit_behind(text, match)
        if match["beside"] and unit not in _SIZES:  # r 45 mm, and no r 2
            continue
        if match["comma"] and (unit not in _SIZES | _AREAS or _AWAY.match(match["behind"][end:])):
            continue  # a section S, 160 mm², and no point P, 30 mm from the pin
        if not unit and (_is_factor(text, *match.span("number")) or COUNTED.match(match["behind"])):
            continue
        if unless.search(clause) or _GOES_ON.match(match["behind"][end:]):
            continue
        letter, place = _letter_in(match)
        value = _quantity(match["number"], unit)
        value_span = match.start("number"), match.start("behind") + end
        yield GivenInProse(letter, place, value, value_span)


def _unit_behind(text: str, match: re.Match[str]) -> tuple[str, int]:
    """Return the unit behind a number, as a sign or in words, and how many characters it takes."""
    unit, end = unit_behind(match["behind"])
    if unit:
        return unit, end
    unit, last = unit_spelled(text, match.end("number"))
    return (unit, last - match.start("behind")) if unit and scale_of(unit) is not None else ("", 0)


def _given_before(text: str) -> Iterator[GivenInProse]:
    """Yield the values that stand before the letter that has them: 80 mm, which we call s."""
    for match in GIVEN_BEFORE.finditer(text):
        clause = _CLAUSE.split(text[max(match.start() - _LONGEST_CLAUSE, 0) : match.start()])[-1]
        unit = as_unit(match["unit"])
        is_read = unit == "" or scale_of(unit) is not None
        if not is_read or _OF_A_CASE.search(clause.rstrip()):
            continue
        group = "dollars" if match["dollars"] else "plain"
        span = match.start("number"), match.end("unit")
        yield GivenInProse(match[group], match.span(group), _quantity(match["number"], unit), span)


def _quantity(number: str, unit: str) -> str:
    """Return a number as typed, without the spaces between its thousands, and its unit."""
    digits = re.sub(r"(?<=[0-9])[ \u202f\u2009](?=[0-9])", "", number)
    return f"{digits} {unit}".strip().replace("{,}", ",")


def _letter_in(match: re.Match[str]) -> tuple[str, Span]:
    """Return the letter that a pattern with `_LETTER` has found, and its place."""
    group = next(n for n in ("dollars", "bracket", "plain", "after_sign", "apart") if match[n])
    return match[group], match.span(group)


def _is_factor(text: str, first: int, last: int) -> bool:
    """Tell whether a number without a unit goes on in a formula: the 2 of $2R = 80$ mm, or of 2R."""
    is_within = text[first - 1 : first] == "$" and text[last : last + 1] != "$"
    behind = text[last : last + 1]
    return is_within or (behind.isalpha() and behind < _KANA) or behind == "\\"
