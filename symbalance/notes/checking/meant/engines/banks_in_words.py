"""What words say of two cylinders' force: the order, the direction, and the angle between the banks.

"The angle between the cylinders is 2α, θ counts from the vertical bisector: the horizontal component of
the primary force is" leaves one formula, 2 m r ω² sin² α sin θ.
"""

from __future__ import annotations

from dataclasses import dataclass

from symbalance.text import lazy_patterns as re

ALONG, ACROSS = "cos", "sin"
"""The directions, by the function of the crank angle that the force along each of them has."""
_BISECTOR = (
    r"(?:bisect(?:or|ing\s+line)|winkelhalbierende\w*|symmetrie(?:achse|linie|ebene)|(?:axis|line|plane)\s+of\s+symmetry"
    r"|symmetry\s+(?:axis|line|plane)|bissectrice|bisectriz|bisettrice|bissetriz|二等分線|対称軸)"
)
_UPRIGHT = re.compile(
    rf"{_BISECTOR}[^.;=\n]{{0,16}}?\b(?:vertical\w*|senkrecht\w*|lotrecht\w*|vertikal\w*)"
    rf"|\b(?:vertical\w*|senkrechte\w*|lotrechte\w*|vertikale\w*)\s+{_BISECTOR}"
    rf"|{_BISECTOR}[^。\n]{{0,6}}(?:鉛直|垂直)|(?:鉛直|垂直)(?:な)?{_BISECTOR}",
    re.IGNORECASE,
)
_VERTICAL = re.compile(
    r"\b(?:vertical|senkrecht|lotrecht|vertikal)\w*|鉛直(?:な)?|垂直(?:な)?", re.IGNORECASE
)
_FROM_VERTICAL = re.compile(
    r"\b(?:to|from|against|gegen|zu[rm]?|von)\s+(?:the\s+|die\s+|der\s+)?(?:vertical|senkrechten?|lotrechten?|vertikalen?)\b",
    re.IGNORECASE,
)
"""From where an angle is counted: ± γ/2 to the vertical is no vertical force."""
_NORMAL = (
    r"(?:perpendicular(?:e|mente)?|normal[e]?|at\s+right\s+angles|transverse(?:ly)?|across|senkrecht|quer|rechtwinklig"
    r"|perpendiculaire(?:ment)?|orthogonal\w*|ortogonal\w*)"
)
_TO = (
    r"\s+(?:to\s+|zu[mr]?\s+|[àa]\s*(?:l\w*['’\s])?|al(?:la|l['’])?\s+)?"
    r"(?:the\s+|de[rmns]\s+|la\s+|die\s+)?"
)
_ACROSS = re.compile(
    rf"{_NORMAL}{_TO}(?:\w+\s+)?{_BISECTOR}|{_BISECTOR}に(?:直角|垂直)|\bhori[sz]ont\w+|\borizzontal\w+|waag(?:e)?recht\w*"
    r"|水平",
    re.IGNORECASE,
)
_ALONG = re.compile(
    rf"(?:along|parallel\s+to|in\s+the\s+direction\s+of|in\s+richtung|längs|entlang|in|auf|lungo|secondo|suivant|selon"
    rf"|dans|según|sobre|parallel\w*\s+(?:zu[mr]?|[àa]|alla?))\s+(?:the\s+|de[rmns]\s+|la\s+|die\s+|l['’]axe\s+de\s+la\s+)?"
    rf"(?:\w+\s+)?{_BISECTOR}|{_BISECTOR}(?:の)?方向|\bvertical\w*|\bvertikal\w*|\blotrecht\w*|鉛直",
    re.IGNORECASE,
)
_BETWEEN = (
    r"(?:angle\s+(?:between|of)\s+the\s+(?:two\s+)?(?:cylinders?|banks?|cylinder\s+(?:axes|lines|cent\w+\s+lines)|lines\s+of\s+stroke|V)"
    r"(?:\s+axes)?|(?:bank|vee|V|included|cylinder|fork)[\s-]?angle|angle\s+between\s+cylinders?"
    r"|(?:bank|gabel|V-?|zylinder)-?winkel|winkel\s+zwischen\s+den\s+(?:\w+)"
    r"|angle\s+(?:entre\s+(?:les\s+)?(?:axes\s+des\s+)?cylindres|du\s+V)|ángulo\s+(?:entre\s+(?:los\s+)?(?:cilindros|bancadas)|de\s+la\s+V)"
    r"|angolo\s+(?:fra|tra|compreso\s+tra)\s+(?:i|gli|le|gli\s+assi\s+dei)\s+(?:cilindri|assi|bancate)|バンク角|挟み角|シリンダ間の角度?)"
)
_OPENING = re.compile(
    rf"{_BETWEEN}[^.;=\n。]{{0,24}}?(?:\$|\\\(|\s|^|=)\s?(?P<half>2)?\s?(?P<letter>\\[A-Za-z]+|[A-Za-zα-ω])(?![A-Za-z])",
    re.IGNORECASE,
)
_SIZE = re.compile(
    r"\bamplitude|magnitude|\bmaximum|\bmaximal|largest|greatest|\bpeak|semi-?(?:major|minor)?[\s-]?ax[ie]s|halbachse|höchstwert"
    r"|\bbetrag|scheitelwert|größ(?:te|e)|ampiezza|\bmodulo|semiasse|amplitud\b|módulo|semieje|demi-?\s?(?:grand|petit)?\s?-?axe"
    r"|intensité|大きさ|振幅|最大値|半径|半軸",
    re.IGNORECASE,
)
_GREEK = {"α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "φ": "phi", "ψ": "psi", "θ": "theta"}


@dataclass(frozen=True, slots=True)
class AngleBetweenBanks:
    """The angle between two banks: a letter and how many halves of the angle it is, or degrees."""

    letter: str
    half: float
    """The share of the letter that is half the angle between the banks."""


def direction_in(words: str) -> str:
    """Return the one direction that words name, ALONG or ACROSS the line between the banks, or "".

    >>> direction_in("the horizontal component, the bisector being vertical")
    'sin'
    """
    bare = _FROM_VERTICAL.sub(" ", _UPRIGHT.sub(lambda m: re.sub(_VERTICAL, "", m[0]), words))
    across = _ACROSS.search(bare) is not None
    along = _ALONG.search(_ACROSS.sub(" ", bare)) is not None
    return "" if along == across else ACROSS if across else ALONG


def is_a_size(words: str) -> bool:
    """Tell whether words speak of an amplitude, or of a half axis of what a force describes."""
    return _SIZE.search(words) is not None


def names_an_angle(text: str) -> bool:
    """Tell whether words speak of an angle between cylinders."""
    return _OPENING.search(text) is not None


def angle_in(text: str, letters: frozenset[str]) -> AngleBetweenBanks | None:
    """Return the letter that words call the angle between the banks, or half of it; None for several.

    >>> angle_in("the angle between the cylinder axes being $2\\\\alpha$", frozenset({"alpha"}))
    AngleBetweenBanks(letter='alpha', half=1.0)
    """
    found: set[AngleBetweenBanks] = set()
    for match in _OPENING.finditer(text):
        letter = _GREEK.get(match["letter"], match["letter"].removeprefix("\\"))
        if letter in letters:
            found.add(AngleBetweenBanks(letter, 1.0 if match["half"] else 0.5))
    return found.pop() if len(found) == 1 else None
