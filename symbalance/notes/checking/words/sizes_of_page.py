"""Sizes of its engine that a page gives in words and without a letter: a bore of 86 mm, at 6000 rpm.

Only of a size that the page gives one number: two are of two engines, and a letter has neither.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from symbalance.document.formula import Number
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_NUMBER = r"(?P<{}>[0-9]{{1,5}}(?:[.,][0-9]{{1,4}})?)"
_GAP = (
    r"(?:[\s~$*{}]|\\(?:SI|qty|unit|U)(?=\{)|-(?=m)|\\[,;: ]"
    r"|\\(?:mathrm|text|textrm|mbox|rm)\s*\{|<[^<>]{1,20}>|&nbsp;){0,12}"
)
_UNIT = r"(?P<unit>mm|cm|m|in(?:ch(?:es)?|\.)?|kg|g)(?![A-Za-z0-9^²/·])"
_IS = (
    r"(?:[\s~:,$]|\((?=[0-9])|of|is|are|was|has|measures|the|engine|von|mit|ist|beträgt|misst|de|est|vaut|di|è|es|vale|"
    r"por|met|is|van|med|på|z|wynosi|je|na|は|が|の|を){1,6}?"
)
_NOUNS = {
    "bore": r"(?<!-)(?<!the )bores?|(?:zylinder)?bohrung(?:sdurchmesser)?|cylinder diameter"
    r"|ボア|シリンダ(?:ー)?(?:内)?径",
    "stroke": r"(?:piston )?strokes?(?! (?:engine|cycle))|(?:kolben)?hub|ストローク|行程",
    "crank radius": r"crank (?:radius|throw)|crank of radius|radius of the crank|throw|kurbelradius"
    r"|クランク半径",
    "rod length": r"(?:connecting[- ]rod|con-?rod|rod) length|pleuellänge|コンロッド長さ?|連桿長さ?",
    "cylinder pitch": r"(?:cylinder|bore) (?:pitch|spacing)|pitch of the cylinders"
    r"|distance (?:between|of) (?:neighbou?ring |adjacent |the )?(?:cylinders?|bores?)"
    r"(?: ax[ei]s| cent(?:re|er)s)?"
    r"|zylinderabstand|気筒間隔|シリンダ(?:ー)?(?:間隔|ピッチ)",
    "piston mass": r"pistons?|piston mass(?:es)?|kolben(?:masse)?|ピストン(?:の?質量)?",
    "reciprocating mass": r"(?:reciprocating|oscillating) mass(?: per cylinder)?"
    r"|oszillierende[nr]? masse|往復(?:部)?質量",
    "mass": r"mass(?:es?)?|masa|質量",
}
_LETTER_BOUND = r"(?<![^\W\d_\u3040-\u9fff])(?:{})(?![^\W\d_\u3040-\u9fff])"
_BEHIND = {  # the number behind its noun, and the noun behind its number
    role: (
        re.compile(
            _LETTER_BOUND.format(noun) + _IS + _GAP + _NUMBER.format("number") + _GAP + _UNIT,
            re.IGNORECASE,
        ),
        re.compile(
            r"(?<![\w.,])" + _NUMBER.format("number") + _GAP + _UNIT + rf"[\s-]{{1,2}}(?:{noun})"
            r"(?![^\W\d_])",
            re.IGNORECASE,
        ),
    )
    for role, noun in _NOUNS.items()
}
_APART = re.compile(
    r"cylinders?\b[^.;:\n0-9]{0,40}?" + _NUMBER.format("number") + _GAP + _UNIT + _GAP + r"apart",
    re.IGNORECASE,
)
_PAIR = re.compile(
    r"(?:bore|bohrung)\s*(?:and|und|x|×|by|/|\\times)\s*(?:stroke|hub)"
    + _IS + _GAP + _NUMBER.format("number")
    + _GAP + r"(?:mm)?\s*(?:x|×|by|/|\\times|and|und|mal)\s*" + _GAP + _NUMBER.format("second") + _GAP
    + _UNIT,
    re.IGNORECASE,
)  # fmt: skip
_OTHERWISE = re.compile(
    r"(?:instead|would|were|older|other|another|larger|smaller|second|statt|ander\w+|wäre|früher\w*|autre|altr\w)\b"
    r"[^.;\n]{0,40}$",
    re.IGNORECASE,
)
_NEAR = 60
"""Characters before a size in which words say that it is of another engine, or only supposed."""


@dataclass(frozen=True, slots=True)
class SizeOfPage:
    """A size that the words of a page give: what it is, its number in SI units, the words, their line."""

    role: str
    number: Number
    text: str
    line: int


def is_called(role: str, meaning: str) -> bool:
    """Tell whether the meaning of a letter is a size, by its words.

    >>> is_called("cylinder pitch", "distance between cylinder axes"), is_called("bore", "offset")
    (True, False)
    """
    return re.fullmatch(rf"(?:the )?(?:{_NOUNS[role]})", meaning.strip(), re.IGNORECASE) is not None


@lru_cache(maxsize=64)
def sizes_of_page(text: str) -> dict[str, SizeOfPage]:
    """Return the sizes that the words of a page give, each with its one number.

    >>> [*sizes_of_page("A bore of 86 mm and an 82 mm stroke.")]
    ['bore', 'stroke']
    >>> sizes_of_page("One engine has a stroke of 82 mm, the other a stroke of 90 mm.")
    {}
    """
    english = glossary_of(text).english(text)
    found: dict[str, dict[Fraction, SizeOfPage]] = {}
    for role, patterns in {**_BEHIND, "apart": (_APART,), "pair": (_PAIR,)}.items():
        for match in (m for pattern in patterns for m in pattern.finditer(english)):
            groups = {"number": {"apart": "cylinder pitch", "pair": "bore"}.get(role, role)}
            groups |= {"second": "stroke"} if role == "pair" else {}
            for group, own in groups.items():
                size = _size(own, match, group)
                if size is not None:
                    is_other = _OTHERWISE.search(english, max(0, match.start() - _NEAR), match.start())
                    value = Fraction(-1) if is_other else size.number.value
                    found.setdefault(own, {})[value] = size
    sizes = {role: next(iter(sizes.values())) for role, sizes in found.items() if len(sizes) == 1}
    return {role: size for role, size in sizes.items() if Fraction(-1) not in found[role]}


def _size(role: str, match: re.Match[str], group: str) -> SizeOfPage | None:
    scale = scale_of(match["unit"].rstrip("."))
    if scale is None or ("mass" in role) != (match["unit"].lower() in ("kg", "g")):
        return None
    digits = match[group].replace(",", ".")
    place = Fraction(1, 10 ** len(digits.partition(".")[2]))
    number = Number(Fraction(digits) * scale[0], place * scale[0])
    words = " ".join(re.sub(r"[$\\{}]|<[^<>]*>", " ", match[0]).split())
    return SizeOfPage(role, number, words, match.string.count("\n", 0, match.start()) + 1)
