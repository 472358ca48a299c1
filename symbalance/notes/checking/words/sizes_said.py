"""Sizes that the words right before a formula give without a letter: with a mass of 8 kg, at 6000 rpm.

Or a multiple of what was: at half the speed. They open a case of their own, as "with m = 8 kg" would.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.text import lazy_patterns as re

_BEFORE = (
    r"(?<![^\W\d_])(?:with|at|for|mit|bei|für|avec|à|pour|con|a|para|per|voor|bij|met|med|vid)\s+"
    r"(?:(?:an?|the|only|eine[rmn]?|einem|der|dem|une?|la|le|un[ao]?|nur)\s+)?"
)
_NOUN = r"(?:[^\W\d_][\w-]+\s+){1,2}?(?:of|von|de|di|van)\s+(?:only\s+|nur\s+)?"
_GAP = r"(?:[\s~$]|\\[,;: ]|\\(?:mathrm|text|textrm|mbox)\s*\{)*"
_UNIT = r"(?P<unit>\^?\s?\{?\\circ\}?|°|度|[A-Za-zµ][A-Za-z0-9/·²³⁻¹^]{0,9}|1/min|/min)"
_SIZE = re.compile(
    rf"(?:{_BEFORE}(?P<noun>{_NOUN})?|(?:質量|半径|回転数|直径|速度|長さ)[がを]?)\$?(?P<number>[0-9]+(?:[.,][0-9]+)?){_GAP}-?{_UNIT}\}}?\$?",
    re.IGNORECASE,
)
_ANGLE = re.compile(r"\^?\s?\{?\\circ\}?|°|degrees?|deg|grad|degrés|grados|gradi|度", re.IGNORECASE)
_TIMES = {"half": Fraction(1, 2), "twice": Fraction(2), "double": Fraction(2), "triple": Fraction(3),
          "three times": Fraction(3), "halbe": Fraction(1, 2), "halber": Fraction(1, 2),
          "halben": Fraction(1, 2), "doppelte": Fraction(2), "doppelter": Fraction(2),
          "doppelten": Fraction(2), "moitié de": Fraction(1, 2), "mitad de": Fraction(1, 2),
          "metà": Fraction(1, 2), "doble": Fraction(2), "doppia": Fraction(2)}  # fmt: skip
_MULTIPLE = re.compile(
    rf"{_BEFORE}(?P<times>{'|'.join(sorted(_TIMES, key=len, reverse=True))})\s+"
    r"(?:(?:of|the|its|this|that|der|die|das|la|le|los|il)\s+){0,2}(?P<noun>[^\W\d_]{3,}(?:\s(?:speed|mass|radius))?)",
    re.IGNORECASE,
)
_RESTS = re.compile(r"[0-9=]")
_LONGEST = 60
"""Characters from a size to the formula that is said of it."""


@dataclass(frozen=True, slots=True)
class SizeSaid:
    """A size in words: its number and unit; or how many times a thing is taken, with its noun."""

    text: str
    number: Fraction
    unit: str = ""
    noun: str = ""
    is_named: bool = False
    """Whether a noun stands before it, that may be of anything: a tolerance of 2 mm."""

    @property
    def is_angle(self) -> bool:
        """Whether it is a number of degrees."""
        return self.unit == "°"


_ANY = re.compile(
    rf"(?<![\w.,=≈^+*/×·−-])(?<![=≈] )(?P<number>[0-9]+(?:[.,][0-9]+)?){_GAP}{_UNIT}(?![\w=])"
)


def sizes_in_words(words: str) -> list[SizeSaid]:
    """Return all sizes that words give, the last first: the pressure has fallen to 14 bar.

    >>> [size.text for size in sizes_in_words("at 6000 rpm it falls to 14 bar; where l = 3 m")]
    ['14 bar', '6000 rpm']
    """
    found = [*_ANY.finditer(words)]
    return [
        SizeSaid(
            match[0].strip(" $"),
            Fraction(match["number"].replace(",", ".")),
            "°" if _ANGLE.fullmatch(match["unit"].strip()) else match["unit"],
        )
        for match in reversed(found)
    ]


def size_said(words: str, text: str = "") -> SizeSaid | None:
    """Return the size that a formula's words give last; `text` is the page, by whose language they are.

    >>> size_said("With a mass of 8 kg: ").text, size_said("At half the speed it is ").number
    ('mass of 8 kg', Fraction(1, 2))
    >>> size_said("With m = 8 kg it is ") is None
    True
    """
    for match in reversed([*_SIZE.finditer(words)]):
        if len(words) - match.end() > _LONGEST or _RESTS.search(words, match.end()):
            return None
        unit = "°" if _ANGLE.fullmatch(match["unit"].strip()) else match["unit"]
        number = Fraction(match["number"].replace(",", "."))
        shown = re.sub(_BEFORE, "", match[0], count=1, flags=re.IGNORECASE).strip(" $")
        return SizeSaid(shown, number, unit, is_named=bool(match["noun"]))
    for match in reversed([*_MULTIPLE.finditer(words)]):
        if len(words) - match.end() > _LONGEST or _RESTS.search(words, match.end()):
            return None
        noun = glossary_of(text).english(match["noun"]).lower()
        return SizeSaid(match[0], _TIMES[match["times"].lower()], noun=noun)
    return None
