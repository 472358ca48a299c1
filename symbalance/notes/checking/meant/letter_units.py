"""Standard formulas between the numbers of stated units: P = p V n/1200, with p in bar and n in min⁻¹.

Where the words around a formula give each of its letters a unit, it is one between their numbers: the
standard formula with what turns these units into one another. Where they give one only to a speed of
rotation, revolutions per minute, the rest is taken to be in units that go together.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, cached_property

from symbalance.document.formula import Formula, Name, Number, Product, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.catalogue import Quantity
from symbalance.notes.checking.meant.catalogue.roles import rotation, turn_rate
from symbalance.notes.checking.meant.formula_slips import agrees, factor_of
from symbalance.notes.checking.units.dimensions import unit_of
from symbalance.notes.checking.units.own_units import ANGULAR_LETTERS, PER_MINUTE
from symbalance.notes.checking.units.stated_units import (
    LETTER_SIGN,
    LISTED,
    SAID,
    UNIT_SIGNS,
    StatedUnit,
    stated_unit,
)
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_RATES = (rotation.name, turn_rate.name)
_MINUTE = Fraction(1, 60)
_A_SECOND = unit_of("Hz")
_BEFORE, _BEHIND, _HEAD = 420, 320, 60
"""Characters before a formula and behind it in which words give units to its letters, and to its own."""
_ARTICLE = r"(?:the|its|der|die|das|den|la|le|el|il|lo|l['’])"
_WORDED = re.compile(
    rf"{LETTER_SIGN}\s+(?:(?:is|be|being|ist|sei|est|è|es)\s+)?{_ARTICLE}\s?"
    r"(?:[^\W\d_][\w'’-]*\s){1,7}?\(?(?:in|en)\s+"
    rf"(?:the\s+unit\s+)?(?={UNIT_SIGNS})",
    re.IGNORECASE,
)
"""N is the speed of the crankshaft in rpm; V la cylindrée totale en litres."""
_BRACKETED = re.compile(
    rf"{LETTER_SIGN}(?:\s|\\[,;: ])*\[\s*"
    r"(?P<unit>(?:\\(?:mathrm|text|unit|si)\s*\{)?[A-Za-z1µ°][A-Za-z0-9µ/²³⁴⁻¹^·.°{} -]{0,20})\]"
)
"""P\\,[\\mathrm{kW}], n [min^{-1}]: the unit behind a letter in square brackets, as TeX has it."""
_FONT = re.compile(r"\\(?:mathrm|text|unit|si)\s*\{|[{}]")
_OF_HEAD = re.compile(
    rf"(?:\b(?:in|en)\s+|\[|\()(?={UNIT_SIGNS})[^$=\n,;:]{{1,30}}?"
    r"(?:\s+(?:is|are|then|therefore|equals|becomes|est|vaut|alors|donc|ist|sind|beträgt|dann|wird|lautet"
    r"|ergibt|sich|zu|è|vale|es|will|be)\b)*[\s,:)\]はをが]*$",
    re.IGNORECASE,
)
"""Right before a formula: the power in kW is, die Leistung (in kW) beträgt."""
_OF_SUBJECT = re.compile(
    rf"[^\W\d_]{{4,}}\)?\s+(?:\(|\[)?(?:in|en)\s+(?={UNIT_SIGNS})[^$=\n,;:]{{1,20}}?[)\]]?\s+"
    r"(?:is|are|ist|beträgt|wird|lautet|est|vaut|è|vale|es)\b",
    re.IGNORECASE,
)
"""What a sentence is of: the piston speed in m/s is, with the stroke s in mm, …"""
_LETTER_BEFORE = re.compile(r"(?:\$|(?<![^\W_])[^\W\d_](?:_\w{1,4})?)\s*,?\s*\(?$")
_BY_MINUTE = re.compile(PER_MINUTE, re.IGNORECASE)
_BY_SECOND = re.compile(
    r"(?:rev(?:olution)?s?|turns|umdrehungen|tours|giri|vueltas|revoluciones|r|U|tr)\s?(?:/|per|pro|par|por|al)\s?"
    r"s(?:ec(?:ond)?|ekunde|econde|egundo|econdo)?\b",
    re.IGNORECASE,
)
_POWER_IN_DOLLARS = re.compile(r"(?<=[A-Za-z])\$\s*\^\s*\{?\s*[-−]\s*1\s*\}?\s*\$")
"""min$^{-1}$, whose power alone is set as a formula."""


@dataclass
class LetterUnits:
    """The units that words of one page give its letters."""

    document: ReadNotes
    _near: dict[tuple[str, int], StatedUnit | None] = field(default_factory=dict)

    @cached_property
    def text(self) -> str:
        """The text of the page, with units in one piece."""
        return _POWER_IN_DOLLARS.sub(lambda m: "⁻¹".ljust(len(m[0])), self.document.text)

    @cached_property
    def every(self) -> list[tuple[str, StatedUnit]]:
        """All letters, as the page writes them, with their units."""
        found: list[tuple[str, StatedUnit]] = []
        for pattern in (SAID, LISTED, _WORDED):
            for match in pattern.finditer(self.text):
                start = match.start("letter")
                unit = unit_written(match["unit"], start)
                if unit is not None:
                    found.append((match["letter"].lstrip("\\").replace("{", "").replace("}", ""), unit))
        for match in _BRACKETED.finditer(self.text):
            unit = unit_in_brackets(match["unit"], match.start("letter"))
            if unit is not None:
                found.append((match["letter"].lstrip("\\").replace("{", "").replace("}", ""), unit))
        return found

    def of(self, name: str, chain: Chain) -> StatedUnit | None:
        """Return the unit of a letter by the words near a relation; None for none, or for two."""
        key = name, chain.start
        if key not in self._near:
            signs = {name, plain_letter(name)}
            first, last = chain.start - _BEFORE, chain.end + _BEHIND
            near = [u for sign, u in self.every if sign in signs and first <= u.place <= last]
            near = [u for u in near if not self._is_apart(u.place, chain)]
            scales = {unit.scale for unit in near}
            self._near[key] = near[0] if len(scales) == 1 else None
        return self._near[key]

    def of_head(self, name: str, chain: Chain) -> StatedUnit | None:
        """Return the unit of the letter that a relation is of, which may stand right before it."""
        own = self.of(name, chain)
        if own is not None:
            return own
        before = self.text[max(0, chain.start - _HEAD) : chain.start].rstrip(" \t\n$\\[({&")
        match = next(iter(_OF_HEAD.finditer(before)), None)
        if match is not None and not _LETTER_BEFORE.search(before[: match.start()]):
            return unit_written(
                match["unit"], chain.start
            )  # and of the speed n in rpm it is not what is behind
        sentence = SENTENCE_END.split(self.text[max(0, chain.start - _BEFORE) : chain.start])[-1]
        subject = next(iter(_OF_SUBJECT.finditer(sentence)), None)
        return None if subject is None else unit_written(subject["unit"], chain.start)

    def _is_apart(self, place: int, chain: Chain) -> bool:
        """Tell whether a paragraph with other words stands between a place and a relation."""
        low, high = sorted((place, chain.start))
        return self.text[low:high].count("\n\n") > 1


@dataclass(frozen=True, slots=True)
class Numbers:
    """The units of one formula's letters: by what each number has to be multiplied."""

    scales: Mapping[str, Fraction]
    """Of its letters, those that words give a unit."""
    head: Fraction
    is_whole: bool
    """Whether all its letters have one."""
    rates: frozenset[str]
    """Those that are speeds of rotation, in revolutions."""
    has_rate: bool
    """Whether there is one, or it is the formula of one."""

    @property
    def is_mixed(self) -> bool:
        """Whether revolutions per minute stand with millimetres or the like, and not all is known."""
        others = [s for n, s in self.scales.items() if n not in self.rates]
        return self.has_rate and not self.is_whole and any(scale != 1 for scale in others)

    def converted(self, target: Formula) -> Formula:
        """Return a formula between quantities as one between their numbers."""
        scales = self.scales if self.is_whole else {n: s for n, s in self.scales.items() if s == _MINUTE}
        head = self.head if self.is_whole or self.head == _MINUTE else Fraction(1)
        changed = target
        for name, scale in scales.items():
            if scale != 1:
                changed = substitute(changed, name, Product((Number(scale), Name(name))))
        factor = factor_of(target, changed)
        if factor is None:
            return changed if head == 1 else changed / Number(head)
        return target if factor == head else Product((Number(factor / head), target))


def numbers_of(
    units: LetterUnits, chain: Chain, name: str, own: Collection[str], without: Collection[str]
) -> Numbers | None:
    """Return the units of a formula's letters; None where words give none that matters.

    `without` are letters that may be numbers without a unit: of cylinders, of a ratio, of an angle.
    """
    stated = {n: unit for n in sorted(own) if (unit := units.of(n, chain)) is not None}
    head = units.of_head(name, chain)
    rates = [n for n, unit in stated.items() if _is_rate(n, unit)]
    is_of_rate = head is not None and _is_rate(name, head)
    if not stated or (not rates and not is_of_rate and all(u.scale == 1 for u in stated.values())):
        return None
    missing = set(own) - stated.keys() - set(without)
    is_whole = head is not None and not missing
    scales = {n: unit.scale for n, unit in stated.items()}
    scale = Fraction(1) if head is None else head.scale
    return Numbers(scales, scale, is_whole, frozenset(rates), bool(rates) or is_of_rate)


def between_quantities(quantity: Quantity, formulas: tuple[Formula, ...]) -> tuple[Formula, ...]:
    """Return formulas without those that count revolutions per minute: 2 s n without s n/30."""
    return tuple(node for node in formulas if node not in _by_minute(quantity.name, quantity.formulas))


@cache
def _by_minute(name: str, formulas: tuple[Formula, ...]) -> frozenset[Formula]:
    """Return the formulas of a quantity that have the 60 of minutes which others of it do without."""
    return frozenset(
        node
        for node in formulas
        if any(
            names(other) == names(node) and any(agrees(node, each) for each in _in_minutes(other))
            for other in formulas
        )
    )


def _in_minutes(formula: Formula) -> Iterator[Formula]:
    """Yield a formula with revolutions per minute for its speed, or as one of such a speed."""
    rates = [rate for rate in _RATES if rate in names(formula)]
    if not rates:
        yield Number(Fraction(60)) * formula
    for rate in rates:
        yield substitute(formula, rate, Product((Number(_MINUTE), Name(rate))))


def _is_rate(name: str, unit: StatedUnit) -> bool:
    is_angular = name.partition("_")[0] in ANGULAR_LETTERS
    return unit.dimension == _A_SECOND and not is_angular and unit.scale in (1, _MINUTE)


def unit_in_brackets(text: str, place: int) -> StatedUnit | None:
    """Return the unit that a text in square brackets is, its TeX fonts and braces left out.

    >>> unit_in_brackets(r"\\mathrm{min^{-1}}", 0).scale
    Fraction(1, 60)
    """
    return unit_written(_FONT.sub("", text).strip(), place)


def unit_written(text: str, place: int) -> StatedUnit | None:
    """Return the unit that a text begins with."""
    dimension = _A_SECOND
    for pattern, scale in ((_BY_MINUTE, _MINUTE), (_BY_SECOND, Fraction(1))):
        match = pattern.match(text)
        if match is not None and dimension is not None:
            return StatedUnit(match[0], dimension, scale, place)
    return stated_unit(text, place)
