r"""Minutes and seconds behind the degrees of an angle: 18^\\circ 26' and 26° 33′ 54″."""

from __future__ import annotations

from fractions import Fraction

from symbalance.text import lazy_patterns as re

_GAP = r"(?:[ \t\u00a0\u2009\u202f~]|\\[,;:! ]){0,4}"
_SIXTY = r"(?P<{}>[0-5]?[0-9](?:\.[0-9]{{1,4}})?)"
_ONE = r"(?:['′’](?!['′’])|\^\s?(?:\{\s?\\prime\s?\}|\\prime(?![A-Za-z])))"
_TWO = r"(?:''|′′|’’|[″\"”]|\^\s?\{\s?\\prime\s?\\prime\s?\})"
_MINUTES = re.compile(
    rf"{_GAP}{_SIXTY.format('minutes')}{_GAP}{_ONE}(?:{_GAP}{_SIXTY.format('seconds')}{_GAP}{_TWO})?(?![\w'′])"
)


def minutes_at(text: str, start: int, end: int) -> tuple[Fraction, Fraction, int] | None:
    """Return what minutes and seconds add in degrees, the size of their last digit, and where they end.

    >>> minutes_at("18° 26' 30''", 3, 12)
    (Fraction(53, 120), Fraction(1, 3600), 12)
    >>> minutes_at("18° 26", 3, 6) is None
    True
    """
    match = _MINUTES.match(text, start, end)
    if match is None or ("." in match["minutes"] and match["seconds"]):
        return None
    last, unit = (match["seconds"], 3600) if match["seconds"] else (match["minutes"], 60)
    size = Fraction(match["minutes"]) / 60 + Fraction(match["seconds"] or 0) / 3600
    return size, Fraction(1, unit * 10 ** len(last.partition(".")[2])), match.end()
