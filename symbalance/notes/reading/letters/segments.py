r"""Distances of two points, AG or \overline{GB}: each is one length, and no product of A and G.

Whether two capital letters side by side are points, the page says: they stand nowhere as quantities of
their own, two such pairs share a point, and a pair is set equal to a length (a = AG) or words call its
letters points, a rod, a crank or a triangle. Each pair is then read as one letter, A_{G} for AG and GA.

Where words say that G lies between A and B, or is the centre of gravity of the rod AB, AB is AG + GB.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass

from symbalance.notes.reading.markup.marked_formulas import marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten, Span
from symbalance.text import lazy_patterns as re

_PAIR = re.compile(
    r"\\overline\s*\{\s*(?P<over>[A-Z])\s*(?P<lined>[A-Z])\s*\}"
    r"|(?<![A-Za-z0-9_^\\])(?<!_\{)(?<!\^\{)(?P<first>[A-Z])\s?(?P<second>[A-Z])(?![A-Za-z_^(']|\s[A-Z])"
    r"|(?<![A-Za-z0-9_^\\])(?<!_\{)(?<!\^\{)(?P<base>[A-Z])\s?(?P<squared>[A-Z])(?=\^\s?\{?\s?[0-9])"
)
_NO_LENGTH = re.compile(
    r"\\(?:vec|overrightarrow|mathrm|mathbf|mathbb|mathcal|text\w*|operatorname|boldsymbol|ref|label|tag|begin|end"
    r"|hat|tilde|bar|angle|sphericalangle|triangle|Delta)\s*\{?\s*$"
)
_TEXT = re.compile(r"\\(?:text\w*|mathrm|operatorname|label|ref|tag|begin|end)\s*\{[^{}]{0,60}\}")
_ANGLE = re.compile(
    r"(?:\\(?:angle|sphericalangle|triangle|Delta)|∠|△)\s*\{?\s*[A-Z]\s?[A-Z]\s?[A-Z]?\}?"
)
_SUBSCRIPT = re.compile(r"[_^]\s*(?:\{[^{}]{0,30}\}|[A-Za-z0-9])")
_ALONE = re.compile(r"(?<![A-Za-z\\])([A-Z])(?![A-Za-z])")
_OPERATOR = re.compile(
    r"[=<>+*/^≈·≤≥]|\\(?:frac|cdot|times|approx|sin|cos|tan|le|ge)(?![A-Za-z])|(?<=\w)\s?-"
)
_SIDE = r"(?:\\(?:,|;|quad|qquad|!)|[\s$&])*"
_LENGTH = r"(?:[a-z](?:_\{?\w\}?)?|\\ell)(?![A-Za-z_({^])"
_BEHIND = re.compile(rf"{_SIDE}=\s*{_LENGTH}")
_BEFORE = re.compile(rf"(?<![A-Za-z\\]){_LENGTH}\s*=\s*$")
_POINTS = (
    r"\b(?:points?|pins?|joints?|cent(?:re|er)s?(?:\s+of\s+(?:gravity|mass))?|centroid|cranks?|rods?|links?|lines?|segments?"
    r"|distances?|lengths?|triangles?|punkte?[sn]?|schwerpunkts?|strecken?|stange|kurbel|dreiecks?|pleuel\w*|abstand)\b"
    r"|点|重心|線分|三角形|クランク|連接棒"
)
_PUT = r"(?i:divides|between|\bon\b|along|\blies|teilt|zwischen|\bauf\b|liegt)"
_CENTROID = r"(?i:cent(?:re|er) of (?:gravity|mass)|centroid|schwerpunkt|重心)"
MOST_PAIRS = 400
"""A page has fewer; the limit keeps the search in proportion to the text."""


@dataclass(frozen=True, slots=True)
class _Pair:
    """Two points side by side in a formula, and where."""

    points: str
    """Both letters, in the order of the alphabet."""
    span: Span
    written: str
    """Both letters as they are written."""


def with_segments(text: str) -> tuple[Rewritten | None, tuple[str, ...]]:
    r"""Return a text with distances of two points as one letter each, None for none, and notes.

    >>> with_segments("Let $a = AG$ and $b = GB$: $a + b = l$")[0].text
    'Let $a = A_{G}$ and $b = G_{B}$: $a + b = l$'
    >>> with_segments("$PV = m R T$ and $PV = w$")[0] is None
    True
    """
    formulas = marked_formulas(text)
    pairs = [pair for span in formulas for pair in _pairs_in(text, span)]
    if not pairs or len(pairs) > MOST_PAIRS:
        return None, ()
    quantities = _quantities(text, formulas)
    pairs = [pair for pair in pairs if not quantities & {*pair.points}]
    if not pairs or not _are_points(text, formulas, {pair.points for pair in pairs}, pairs):
        return None, ()
    kinds = list(dict.fromkeys(pair.points for pair in pairs))
    first = {pair.points: pair.written for pair in reversed(pairs)}
    letters = {points: f"{written[0]}_{{{written[1]}}}" for points, written in first.items()}
    parted = _parted(text, kinds)
    read = {
        points: "(" + "+".join(letters[part] for part in parts) + ")" for points, parts in parted.items()
    }
    rewriter = Rewriter(text)
    for pair in sorted(pairs, key=lambda pair: pair.span):
        rewriter.replace(*pair.span, read.get(pair.points, letters[pair.points]))
    plain = {points: f"{written[0]}_{written[1]}" for points, written in first.items()}
    plain |= {points: " + ".join(plain[part] for part in parts) for points, parts in parted.items()}
    shown = ", ".join(f"{first[points]} as {plain[points]}" for points in kinds)
    return rewriter.finish(), (f"distances of two points, one length each: {shown}",)


def _parts(points: str, between: str) -> tuple[str, str]:
    """Return the two distances from a point between to the ends."""
    first, second = ("".join(sorted(end + between)) for end in points)
    return first, second


def _pairs_in(text: str, formula: Span) -> list[_Pair]:
    """Return the pairs of capital letters in a formula that may be distances."""
    pairs: list[_Pair] = []
    for match in _PAIR.finditer(text, *formula):
        letters = "".join(filter(None, match.groups()))
        before = text[max(formula[0], match.start() - 24) : match.start()]
        if letters[0] == letters[1] or _NO_LENGTH.search(before):
            continue
        pairs.append(_Pair("".join(sorted(letters)), match.span(), letters))
    return pairs


def _quantities(text: str, formulas: list[Span]) -> set[str]:
    """Return the capital letters that stand as quantities of their own in a formula."""
    quantities: set[str] = set()
    for start, end in formulas:
        bare = _TEXT.sub(" ", text[start:end])
        has_operator = _OPERATOR.search(bare) is not None
        indexed = {m[1] for m in re.finditer(r"(?<![A-Za-z\\])([A-Z])\s?_", bare)}
        bare = _SUBSCRIPT.sub(" ", _PAIR.sub(" ", _ANGLE.sub(" ", bare)))
        alone = {match[1] for match in _ALONE.finditer(bare)}
        quantities |= alone if has_operator else set()
        quantities |= indexed
    return quantities


def _are_points(text: str, formulas: list[Span], kinds: set[str], pairs: list[_Pair]) -> bool:
    """Tell whether pairs of letters are distances, by the lengths they are equal to or by words."""
    lengths = {pair.points for pair in pairs if _is_length(text, pair, formulas)}
    shared = {a for a in kinds for b in kinds if a != b and {*a} & {*b}}
    if any({*a} & {*b} for a in lengths for b in lengths if a != b):
        return True
    points = "".join(sorted({letter for kind in kinds for letter in kind}))
    named = re.compile(rf"(?i:{_POINTS})[\s$]{{0,3}}(?:\\overline\{{)?[{points}]{{1,3}}(?![A-Za-z])")
    return bool(lengths or shared) and named.search(text) is not None


def _is_length(text: str, pair: _Pair, formulas: list[Span]) -> bool:
    """Tell whether a pair stands alone on a side of an equation whose other side is one small letter."""
    start, end = pair.span
    place = bisect_right(formulas, (start, len(text))) - 1
    first, last = formulas[place]
    before = text[first:start].strip("$ \t\n&\\([,;")
    opens = not before or before[-1] in ",;" or before.endswith(("quad", "and"))
    if opens and _BEHIND.match(text, end):
        return True
    behind = text[end:last].lstrip(" \t\n")
    closes = not behind or behind[0] in "$,;.\\"
    return closes and _BEFORE.search(text[max(first, start - 24) : start]) is not None


def _parted(text: str, kinds: list[str]) -> dict[str, tuple[str, str]]:
    """Return the distances that a point between their ends parts in two, with these."""
    parted: dict[str, tuple[str, str]] = {}
    letters = sorted({letter for kind in kinds for letter in kind})
    for points in kinds:
        between = [
            _parts(points, point)
            for point in letters
            if point not in points
            and all(part in kinds for part in _parts(points, point))
            and _lies_between(text, point, points)
        ]
        if len(between) == 1 and not any(part in parted for part in between[0]):
            parted[points] = between[0]
    return parted


def _lies_between(text: str, point: str, ends: str) -> bool:
    """Tell whether words put a point between two others: G divides AB, G is the centroid of AB."""
    own = rf"(?<![A-Za-z]){point}(?![A-Za-z])"
    join = r"\W{0,6}(?:and|und|と)?\W{0,6}"
    both = rf"(?<![A-Za-z])(?:{ends[0]}{join}{ends[1]}|{ends[1]}{join}{ends[0]})(?![A-Za-z])"
    ways = (
        rf"{own}[^.=\n]{{0,40}}?{_PUT}[^.=\n]{{0,30}}?{both}",
        rf"{_CENTROID}[^.=\n]{{0,20}}?{own}[^.=\n]{{0,50}}?{both}",
        rf"{both}[^.=\n]{{0,60}}?(?:{_CENTROID}[^.=\n]{{0,12}}?{own}|{own}[^.=\n]{{0,12}}?{_CENTROID})",
    )
    return any(re.search(way, text) for way in ways)
