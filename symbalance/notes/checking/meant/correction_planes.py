"""Shares of two planes in what acts between them: the plane at the distance a takes U b/(a + b).

The words of a page say which letter is the distance from which plane or bearing. By the moments about the
other one, each takes the share of the other's distance; the slips are the shares exchanged, the quotient
of the two distances, and the share upside down.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from symbalance.document.formula import Formula, Name, Negative, Product, Quotient, Sum, names
from symbalance.notes.checking.meant.formula_slips import agrees
from symbalance.text import lazy_patterns as re

_TAGS = re.compile(r"[$`*]|\\[,;: ]|<[^>]*>")
_SIDES = (
    frozenset({"a", "1", "i", "l", "left", "linken", "links", "li", "左"}),
    frozenset({"b", "2", "ii", "r", "right", "rechten", "rechts", "re", "右"}),
)
"""What names the one plane and the other, as words or as subscripts."""
_PLACE = r"(?P<place>left|right|linken|rechten|II|I|A|B|1|2|L|R)(?![A-Za-z0-9])"
_LETTER = r"(?<![A-Za-z_\\])(?P<letter>[a-zA-Z])(?:_\{?(?P<index>[A-Za-z0-9]{1,3})\}?)?"
_WHICH = (
    r"(?:the\s+|der\s+|dem\s+)?(?:correction\s+|balancing\s+|ausgleichs)?(?:plane\s+|bearing\s+"
    r"|ebene\s+|lager\s+|plan\s+|piano\s+|plano\s+|palier\s+|cuscinetto\s+|cojinete\s+)?"
)
_FROM = (
    re.compile(rf"{_LETTER}\s+(?:from|von|du|dal|del|de)\s+{_WHICH}{_PLACE}", re.IGNORECASE),
    re.compile(
        rf"(?:from|von)\s+{_WHICH}{_PLACE}(?:\s+(?:plane|bearing|ebene))?\s+(?:is|be|ist"
        rf"|by)\s+{_LETTER}(?![A-Za-z])",
        re.IGNORECASE,
    ),
    re.compile(rf"面\s?{_PLACE}から\s?{_LETTER}(?![A-Za-z])"),
)
_BOTH = re.compile(
    r"(?:distances?|abst[aä]nde?n?)\s+(?:from|to|von)\s+(?:the\s+|der\s+)?(?:planes?\s+|bearings?\s+)?"
    r"(?:left|linken|A|1|I)\s+(?:and|und|bzw\.)\s+(?:the\s+|der\s+)?(?:right|rechten|B|2"
    r"|II)(?:\s+(?:planes?|bearings?|ebene))?"
    r"\s*(?::|are|is|sind|,)\s*(?P<first>[A-Za-z])\s+(?:and|und|bzw\.)\s+(?P<second>[A-Za-z])(?![A-Za-z])"
    r"|(?<![A-Za-z])(?P<one>[A-Za-z])\s+(?:and|und|bzw\.)\s+(?P<other>[A-Za-z])\s+(?:from"
    r"|von)\s+(?:the\s+|der\s+)?"
    r"(?:planes?\s+|bearings?\s+)?(?:left|linken|A|1|I)\s+(?:and|und|bzw\.)\s+(?:the\s+"
    r"|der\s+)?(?:right|rechten|B|2|II)(?![A-Za-z])",
    re.IGNORECASE,
)
_PLANES = re.compile(
    r"\bplanes?\b|ebenen?\b|bearings?\b|lagern?\b|面|軸受|\bplans\b|\bpiani\b|\bplanos\b|paliers|cuscinetti|cojinetes",
    re.IGNORECASE,
)
_PAIR = 2
_OUTSIDE = re.compile(r"overhung|overhang|outside|fliegend|außerhalb|外側|片持", re.IGNORECASE)


@dataclass
class CorrectionPlanes:
    """The distances of one page from two planes between which something acts."""

    text: str

    @cached_property
    def distances(self) -> tuple[str, str] | None:
        """The letters of the distances from the one plane and from the other; None where not both."""
        plain = _TAGS.sub("", self.text)
        if not _PLANES.search(plain) or _OUTSIDE.search(plain):
            return None
        own: tuple[set[str], set[str]] = (set(), set())
        for match in _BOTH.finditer(plain):
            for side, letter in enumerate(
                (match["first"] or match["one"], match["second"] or match["other"])
            ):
                own[side].add(letter)
        for pattern in _FROM:
            for match in pattern.finditer(plain):
                side = _side_of(match["place"])
                if side is not None:
                    index = f"_{match['index']}" if match["index"] else ""
                    own[side].add(match["letter"] + index)
        if len(own[0]) != 1 or len(own[1]) != 1 or own[0] == own[1]:
            return None
        return next(iter(own[0])), next(iter(own[1]))

    def shares(self, name: str, claim: Formula) -> tuple[Formula, Formula] | None:
        """Return the share of the plane that a letter's subscript names, and the other plane's.

        They are written in the letters of a claim; None where it is of anything else.
        """
        indices = {part.partition("_")[2] for part in name.split()}
        side = _side_of(indices.pop()) if len(indices) == 1 else None
        if side is None or self.distances is None or not names(claim) & {*self.distances}:
            return None
        far, near = Name(self.distances[1 - side]), Name(self.distances[side])
        others = sorted(names(claim) - {far.name, near.name})
        wholes: list[Formula] = [Name(whole) for whole in others]
        of_product = [n for n in others if n not in ("l", "L")]
        if len(of_product) == _PAIR and " " in name:  # m_A r_A is a share of m r
            wholes.append(Product(tuple(Name(n) for n in of_product)))
        for whole in wholes:
            for length in (Sum((near, far)), *(Name(n) for n in sorted(names(claim)) if n in ("l", "L"))):
                right = Quotient(Product((whole, far)), length)
                for wrong in _not_shares(whole, far, near, length):
                    if agrees(right, claim) or agrees(wrong, claim):
                        return right, wrong
        return None


def _not_shares(whole: Formula, far: Formula, near: Formula, length: Formula) -> tuple[Formula, ...]:
    """Return what is often written for the share U b/(a + b): the other plane's, U b/a, U (a + b)/b."""
    gaps = (Sum((near, Negative(far))), Sum((far, Negative(near))))
    return (
        Quotient(Product((whole, near)), length),
        Quotient(Product((whole, far)), near),
        Quotient(Product((whole, near)), far),
        *(Quotient(Product((whole, length)), each) for each in (far, near)),
        *(Quotient(Product((whole, far)), gap) for gap in gaps),
        *(Quotient(Product((whole, near)), gap) for gap in gaps),
    )


def _side_of(word: str) -> int | None:
    low = word.casefold()
    return next((k for k, own in enumerate(_SIDES) if low in own), None)
