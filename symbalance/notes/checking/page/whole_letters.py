r"""Letters that a page says are whole numbers: k ∈ ℤ, for every integer k, k = 0, 1, 2 and so on.

Such a sentence is a declaration of the page's own, to the end of its section, of a letter that nobody has
declared. cos(2πk) = 1 holds by it, and cos(πk) = 1 does not.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symbalance.document.formula import Name, Number, names
from symbalance.notes.checking.declared.sidecar import Declarations, Scope
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading import ReadingError, canonical_name
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

_SINGLE = r"(?<![A-Za-z\\])[A-Za-z](?:_\{?[A-Za-z0-9]\}?)?(?![A-Za-z0-9])"
_LIST = rf"(?P<letters>{_SINGLE}(?:\$?\s*,\s*(?:\\,)?\$?{_SINGLE})*)"
_WHOLE = r"(?:\\mathbb\s*\{?\s*[ZN]\s*\}?|\\(?:ZZ?|NN?|Z|N)(?![A-Za-z])|[ℤℕ])"
_NUMBERS = (
    r"(?:(?:positive|negative|non-?negative|arbitrary|any|natürliche[nrs]?|positive[nrs]?)\s+)?"
    r"(?:whole\s+numbers?|integers?|natural\s+numbers?|ganze[nrs]?\s+Zahl(?:en)?|natürliche[nrs]?\s+Zahl(?:en)?"
    r"|ganzzahlig(?:e[nrs]?)?|entiers?)"
)
_DOTS = r"(?:\\(?:l|c)?dots(?![A-Za-z])|…|⋯|\.{2,3}|・・・)"
_STATED = (
    re.compile(rf"{_LIST}\s*(?:\\in(?![A-Za-z])|∈)\s*{_WHOLE}"),
    re.compile(rf"{_NUMBERS}\s+\$?{_LIST}\$?(?=[\s.,;:)]|$)", re.IGNORECASE),
    re.compile(
        rf"{_LIST}\$?\s*,?\s*(?:(?:is|are|be|as|being|ist|sind|sei|seien|als|an?|eine?|beliebige?)\s+){{0,3}}{_NUMBERS}(?![A-Za-z])",
        re.IGNORECASE,
    ),
    re.compile(
        rf"{_LIST}\$?\s+(?:(?:is|are|ist|sind)\s+)?(?:(?:not|no|nicht|k?ein)\s+)?(?:an?\s+|ein\s+|even\s+|odd\s+)?"
        r"(?:(?:integer\s+)?multiples?\s+of|divisible\s+by|Vielfache[sn]?\s+von|durch\s+\S{1,6}\s+teilbar"
        r"|(?:even|odd|gerade|ungerade)(?=[\s.,;:)]|$))"
    ),
    re.compile(rf"(?<![a-z])(?:even|odd|gerade[sn]?|ungerade[sn]?)\s+\$?{_LIST}\$?(?=[\s.,;:)]|$)"),
    re.compile(
        rf"{_LIST}\$?\s*(?:は|を|が)?\s*(?:任意の)?(?:整数|自然数)|(?:整数|自然数)\s*\$?(?P<behind>{_SINGLE})"
    ),
    re.compile(
        rf"(?P<letters>{_SINGLE})\s*=\s*(?:[-−]?[0-9]+\s*,\s*(?:\\[,;: ])?\s*){{1,6}}{_DOTS}"
        rf"(?!\s*,\s*[0-9]*\.)"
    ),
    re.compile(
        rf"(?P<letters>{_SINGLE})\s*=\s*(?:{_DOTS}|\\pm|±)\s*,?\s*[-−]?[0-9]+\s*,\s*(?:[±]|\\pm)?\s*[0-9]+\s*,[^.;\n]{{0,20}}?{_DOTS}"
    ),
)
_IMAGINARY = re.compile(
    r"(?:e\s*\^|\\exp|exp\s*\()\s*[{(]?[^}\n]{0,12}?(?<![A-Za-z\\])([ij])(?![A-Za-z])"
)


def with_whole_letters(page: ReadNotes, declarations: Declarations) -> Declarations:
    """Return declarations with a scope for each letter that the page says is a whole number."""
    used = {name for chain in page.chains for side in chain.sides for name in names(side.node)}
    sections, scopes = Sections(page), list[Scope]()
    for name, line in _stated(page.text):
        last = sections.section_end(line)
        first = line
        while first > 1 and sections.same_section(first - 1, line):
            first -= 1
        is_declared = name in declarations.symbols_at(line)
        if (
            name not in used
            or is_declared
            or any(scope.holds(line) and name in scope.symbols for scope in scopes)
        ):
            continue
        if not _is_broken(page, name, first, last):
            scopes.append(Scope(first, last, {name: "integer"}, by_page=True))
    return replace(declarations, scopes=(*declarations.scopes, *scopes)) if scopes else declarations


def _stated(text: str) -> Iterator[tuple[str, int]]:
    imaginary = {"e", *(match[1] for match in _IMAGINARY.finditer(text))}
    for pattern in _STATED:
        for match in pattern.finditer(text):
            groups = match.groupdict()
            written = groups.get("letters") or groups.get("behind") or ""
            for letter in re.findall(_SINGLE, written):
                try:
                    name = canonical_name(letter)
                except ReadingError:
                    continue
                if name not in imaginary:
                    yield name, text.count("\n", 0, match.start()) + 1


def _is_broken(page: ReadNotes, name: str, first: int, last: int) -> bool:
    """Tell whether some lines give the letter a number that is not whole: it is another letter there."""
    for chain in page.chains:
        if not first <= chain.lines[0] <= last or chain.sides[0].node != Name(name):
            continue
        for side in chain.sides[1:]:
            if not names(side.node) and not (
                isinstance(side.node, Number) and side.node.value.denominator == 1
            ):
                return True
    return False
