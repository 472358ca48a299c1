r"""The letter e of a page that means a length or an angle by it, told from the number e.

On a page with `e = 8` mm, `e/l` or "offset $e$" a lone e is that letter, and only the base of a power is
the number: \mathrm{e}^{ix}, e^{-x}. On every other page e alone stays undeclared, as it may be either.
"""

from __future__ import annotations

from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.letters.letter_names import matching_brace
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_E = r"(?<![A-Za-z0-9\\_^{}.'’])e(?![A-Za-z_'’])"
_LENGTH = r"(?:mm|cm|dm|m|inch|in|ft|\\milli|\\centi|\\metre|\\meter|\\m)(?![A-Za-z])"
_GAP = r"(?:\\[,;: ]|[~ $])*"
_VALUE = (
    rf"{_E}{_GAP}&?(?:=|:=|≈|\\coloneqq|\\approx){_GAP}(?:\\(?:SI|qty)\s*\{{)?[-−]?[0-9]+(?:(?:[.,]"
    rf"|\{{,\}})[0-9]+)?"
    rf"(?:\}}\s*\{{|{_GAP})(?:\\(?:mathrm|text|mbox|textrm)\s*\{{\s*)?(?:\\[,;: ])*{_LENGTH}"
)
"""A value in a unit of length: e = 8 mm."""
_BY_LENGTH = rf"{_E}{_GAP}/{_GAP}[lrLR](?![A-Za-z])|\\[dt]?frac\s*\{{\s*e\s*\}}\s*\{{\s*[lrLR]\s*\}}"
"""A ratio of lengths: e/l."""
_NAMED = (
    r"(?:[Oo]ffset|Versatz|Schr[äa]nkung|Desachsierung|eccentricity|Exzentrizität|オフセット|偏心量?"
    r"|[Dd]istance|[Ss]pacing|[Pp]itch|[Rr]adius|Radien|[Ll]ever\s+arm|[Aa]bstand|[Hh]ebelarm"
    rf"|[Hh]albmesser|距離|間隔|半径|entraxe|interasse)\s*(?:of\s*|を\s?)?\$?{_E}"
)
"""Behind the words for a length: the offset e."""
_EXPLAINED = (
    rf"{_E}\s*\$?\s*(?:(?:is|being|denotes|ist|als|der|the|as)\s+){{1,2}}"
    r"(?:offset|distance|spacing|pitch|abstand|versatz|zylinderabstand)"
    r"|(?:\bby|\bum|amount|Maß|量)\s+\$\s?e\s?\$"
    r"|\$\s?e\s?\$\s+(?:away|off|apart|from|aus der|außerhalb|neben|à côté|fuera|fuori)\b"
)
"""Before the words that explain it, or behind "by": where e is the offset, moved by $e$, $e$ away."""
_ARM = rf"(?<![A-Za-z\\])[mM](?:_(?:[A-Za-z0-9]|\{{\w{{1,4}}\}}))?{_GAP}{_E}(?!\s*\^)"
"""The arm of a mass: m_r e."""
_ANGLE = (
    r"(?<![A-Za-z])(?:sin|cos|tan)(?:\s?(?:\^\s?\{?2\}?|²))?\s*\(?\s*e(?![A-Za-z0-9_'’]|\s*\^)"
    r"|(?<![A-Za-z])[Ll]et\s+\$?e\$?\s+be\s+the\s"
)
"""An angle: sin e, and "let e be the obliquity"."""
_MEANT = re.compile("|".join((_VALUE, _BY_LENGTH, _NAMED, _EXPLAINED, _ARM, _ANGLE)))
_WITH_MASS = re.compile(
    r"(?<![A-Za-z\\])[mMBU]_\{?(?P<index>[A-Za-z0-9]{1,4})\}?\s?(?:\\[,;:]\s?)?e_(?:\{(?P=index)\}"
    r"|(?P=index)(?![A-Za-z]))"
)
_THICKNESS = re.compile(
    r"(?:[Dd]istance|[Tt]hickness|[Dd]iameter|[Ss]pacing|Dicke|Breite|Abstand|Durchmesser|厚さ|距離"
    r"|直径)\s?(?:of\s|を)?\$?d(?![A-Za-z_])"
)
_UPRIGHT = re.compile(
    r"(?:\\(?:mathrm|text|textrm|operatorname)\s*(?:\{\s*e\s*\}|\s+e(?![A-Za-z]))|\{\s*\\rm\s+e\s*\}"
    r"|\{\s*\\mathrm\s*e\s*\})"
    r"\s*(?P<power>\^\s*)?"
)
_ITALIC = re.compile(r"(?<![A-Za-z0-9\\_{.])e\s*(?P<power>\^\s*)")
_LETTERED = re.compile(r"[^\W\d_]|[-−]")
_EXPONENT = re.compile(r"\\[A-Za-z]+|[A-Za-z0-9\u03b1-\u03c9]")


def means_letter(text: str) -> bool:
    """Tell whether a page means a length or an angle by the letter e.

    >>> means_letter("mit $e = 8$ mm"), means_letter("$e = 2.718$"), means_letter("1 e/min")
    (True, False, False)
    >>> means_letter("L sin e = r sin a"), means_letter(r"\\sin e^{-x}")
    (True, False)
    """
    return _MEANT.search(text) is not None


def lengths_named(text: str) -> frozenset[str]:
    """Return the letters d and e_b that a page means as lengths: Dicke d, the moment m_b e_b.

    >>> sorted(lengths_named(r"Dicke $d$ and the moment $m_b e_b$")), lengths_named("e_x and dx")
    (['d', 'e_b'], frozenset())
    """
    own = {f"e_{match['index']}" for match in _WITH_MASS.finditer(text)}
    return frozenset(own | ({"d"} if _THICKNESS.search(text) else set()))


def with_number_e(text: str) -> Rewritten | None:
    r"""Return a text with the powers of the number e as \exp, None where there are none.

    >>> with_number_e(r"\mathrm{e}^{ix} and e^{-x}, but e^2").text
    '\\exp{ix} and \\exp{-x}, but e^2'
    """
    rewriter, changed = Rewriter(text), False
    matches = sorted([*_UPRIGHT.finditer(text), *_ITALIC.finditer(text)], key=re.Match.start)
    for match in matches:
        if match.start() < rewriter.place:
            continue
        is_upright = match.re.pattern == _UPRIGHT.pattern
        before = text[: match.start()].rstrip()[-1:]
        if before == "_" or (text[match.start()] != "{" and before == "{" and not match["power"]):
            continue  # a subscript, ω_{\mathrm e}
        span = _exponent(text, match.end()) if match["power"] else None
        if span is None:
            if is_upright and not match["power"] and before != ",":
                rewriter.replace(*match.span(), r"\exp{1}")
                changed = True
            continue
        inside, end = span
        if is_upright or _LETTERED.search(text[slice(*inside)]):
            rewriter.replace(match.start(), end, r"\exp{", inside, "}")
            changed = True
    return rewriter.finish() if changed else None


def _exponent(text: str, place: int) -> tuple[tuple[int, int], int] | None:
    """Return what stands in an exponent that begins at a place, and where it ends."""
    closers = {"{": "}", "(": ")"}
    if (sign := text[place : place + 1]) not in closers:
        single = _EXPONENT.match(text, place)
        return (single.span(), single.end()) if single else None
    if sign == "{":
        try:
            end = matching_brace(text, place, len(text))
        except ReadingError:
            return None
        return (place + 1, end - 1), end
    depth = 0
    for at in range(place, min(len(text), place + 400)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return (place + 1, at), at + 1
    return None
