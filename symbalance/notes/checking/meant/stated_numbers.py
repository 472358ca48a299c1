"""Numbers that the words of a page give for a share or a count: half of the mass, seven cylinders.

A standard formula with that share or count then has the number in it: (1 - c) m r ω² is m r ω²/2.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from symbalance.document.formula import (
    Formula,
    Name,
    Negative,
    Number,
    Sum,
    children,
    names,
    with_children,
)
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.text import lazy_patterns as re

_COUNTS = {
    "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8, "nine": 9, "eleven": 11,
    "zwei": 2, "drei": 3, "vier": 4, "fünf": 5, "sechs": 6, "sieben": 7, "acht": 8, "neun": 9,
    "trois": 3, "quatre": 4, "cinq": 5, "sept": 7, "neuf": 9, "tres": 3, "cinco": 5, "siete": 7,
    "nueve": 9, "三": 3, "五": 5, "七": 7, "九": 9,
}  # fmt: skip
_SHARES = {
    "half": "1/2", "one half": "1/2", "hälfte": "1/2", "moitié": "1/2", "mitad": "1/2", "半分": "1/2",
    "two thirds": "2/3", "two-thirds": "2/3", "zwei drittel": "2/3", "three quarters": "3/4",
    "three-quarters": "3/4", "one third": "1/3", "one-third": "1/3",
}  # fmt: skip
_CYLINDERS = re.compile(
    rf"(?<![A-Za-z0-9])(?P<count>{'|'.join(_COUNTS)}|[2-9]|1[0-8])[\s-]?"
    r"(?:equal\s)?(?:cylinders?(?![A-Za-z])|zylinder|cylindres|cilindros|気筒)",
    re.IGNORECASE,
)
_WHOLE = (
    r"(?:reciprocating|oscillating|oszillierenden|hin-\s?und\s?hergehenden|alternative|alternativa)\s"
    r"|(?:masses?|masa|masse)\s(?:alternatives?|alternativas?)|往復"
)
_PER_CENT = r"(?P<percent>[1-9][0-9])\s?\\?(?:%|per\s?cent|Prozent)"
_PART = rf"(?P<share>{'|'.join(_SHARES)}|(?P<above>[1-9])/(?P<below>[2-9])|{_PER_CENT})"
_SHARE = re.compile(
    rf"(?<![A-Za-z0-9./]){_PART}\s(?:of\s|der\s|des\s|de\s|d')?(?:(?:the|la|las|whole|its)\s){{0,2}}"
    rf"(?:{_WHOLE})|往復(?:部分の?)?質量の\s?(?P<behind>半分|[1-9][0-9]\s?%|1/2|2/3)",
    re.IGNORECASE,
)
_FACTOR = re.compile(
    r"(?:balance|balancing|overbalance)\s+factor\s+(?:of\s+|is\s+|=\s*)?(?P<number>0[.,][0-9]{1,3}"
    r"|[1-9][0-9](?=\s?\\?%))"
    r"|(?:Ausgleichsgrad|つり合い率|釣合い率)\s*(?:von\s+|は|=\s*)?(?P<more>0[.,][0-9]{1,3})",
    re.IGNORECASE,
)
_BALANCED = re.compile(
    r"balanc|counter-?weight|gegengewicht|ausgleich|ausgeglichen|équilibr|contrepoids|equilibra"
    r"|contrapeso"
    r"|釣り?合|つり[あ合]|carried\s+by\s+the\s+(?:fly-?wheels?|webs?|crank)|web\s+already\s+carries",
    re.IGNORECASE,
)
_NOT_BALANCED = re.compile(r"unbalanc|remain|\bleft\b|\brest|\bnot\b|\bnicht\b|残", re.IGNORECASE)


@dataclass
class StatedNumbers:
    """The numbers that the words of one page give for roles of standard formulas."""

    text: str

    @cached_property
    def numbers(self) -> dict[str, Fraction]:
        """The role's number, of those roles for which the page states one and no other."""
        every = {"cylinders": set(self._cylinders()), "share": set(self._shares())}
        return {role: next(iter(each)) for role, each in every.items() if len(each) == 1}

    def _cylinders(self) -> Iterator[Fraction]:
        for match in _CYLINDERS.finditer(self.text):
            text = match["count"].casefold()
            yield Fraction(_COUNTS.get(text) or int(text))

    def _shares(self) -> Iterator[Fraction]:
        for sentence in SENTENCE_END.split(self.text):
            if (factor := _FACTOR.search(sentence)) is not None:
                number = Fraction((factor["number"] or factor["more"]).replace(",", "."))
                yield number if number < 1 else number / 100
                continue
            match = _SHARE.search(sentence)
            if match is None or not _BALANCED.search(sentence) or _NOT_BALANCED.search(sentence):
                continue
            text = (match["share"] or match["behind"] or "").casefold()
            digits = re.match(r"([1-9][0-9])\s?\\?(?:%|p)", text)
            yield Fraction(int(digits[1]), 100) if digits else Fraction(_SHARES.get(text, text))

    def with_numbers(self, formulas: tuple[Formula, ...], roles: frozenset[str]) -> tuple[Formula, ...]:
        """Return formulas, and behind them those that a stated number in place of a role makes."""
        every = list(formulas)
        for role in sorted(roles & self.numbers.keys()):
            number = Number(self.numbers[role])
            every += [_folded(substitute(node, role, number)) for node in every if role in names(node)]
        return tuple(every)


def _folded(node: Formula) -> Formula:
    """Return a formula with each sum of numbers alone made one number."""
    if isinstance(node, Sum):
        values = [_value(term) for term in node.terms]
        numbers = [value for value in values if value is not None]
        if len(numbers) == len(values):
            return Number(sum(numbers, Fraction(0)))
    if isinstance(node, Name):
        return node
    parts = children(node)
    return with_children(node, tuple(map(_folded, parts))) if parts else node


def _value(node: Formula) -> Fraction | None:
    if isinstance(node, Negative):
        below = _value(node.operand)
        return None if below is None else -below
    return node.value if isinstance(node, Number) else None
