r"""Units behind a cosine or a sine belong to the whole side: F = 1.97 cos φ + 0.59 cos 2φ kN is in kN.

Only a side that begins with a number, a result, is such; a letter of the page is no unit, and a side
with a unit inside keeps it where it stands.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_FORCE = r"(?:[kMmc]?(?:N|Pa|W|J|m|g)|lbf?|kp)"
_BEHIND = re.compile(
    r"(?<=[A-Za-z\u03b1-\u03c9})])(?P<close>\$?)(?:[ ~]|\\[,;: ]|\\quad(?![a-z])){1,3}"
    r"(?:\\(?:mathrm|text|textrm)\{(?P<set>[A-Za-z/²³·\\ ]{1,12})\}"
    rf"|(?P<plain>{_FORCE}(?:[·][mc]?m|[ ][mc]?m(?![A-Za-z])|m)?(?:/(?:s|mm|m|cm)[²³]?)?))"
    r"(?=\$?[.,;:]?(?:\s|$)|[\u3001\u3002])",
    re.MULTILINE,
)
_SIDE = re.compile(r"(?:[=≈]|\\approx(?![a-z]))(?P<side>(?:(?!\\approx)[^=≈<>$\n;]){1,200})$")
_RESULT = re.compile(r"[ ~]*[-−]?[ ]?\(?[ ]?[-−]?[0-9]")
_WAVE = re.compile(r"(?:sin|cos)(?![a-z])")
_UNIT_INSIDE = re.compile(
    rf"[0-9)][ ~]?(?:\\[,;: ])?(?:\\mathrm\{{)?{_FORCE}(?:m|/[a-z]{{1,2}}[²³]?)?(?![A-Za-z_])"
)
_BEFORE = 240
"""Characters of a line looked at before a unit."""


def with_units_of_waves(text: str, is_letter: Callable[[str, int], bool]) -> Rewritten | None:
    """Return a text with such units behind a bracket around the side, None where there are none.

    >>> with_units_of_waves("F = 1.97 cos φ + 0.59 cos 2φ kN.", lambda name, line: False).text
    'F =( 1.97 cos φ + 0.59 cos 2φ) kN.'
    """
    if _WAVE.search(text) is None:
        return None
    rewriter = Rewriter(text)
    of_page: dict[str, bool] = {}
    for match in _BEHIND.finditer(text):
        side = _SIDE.search(text[max(match.start() - _BEFORE, 0) : match.start()])
        unit = (match["set"] or match["plain"]).strip()
        if side is None or not _is_result(side["side"]) or scale_of(unit) is None:
            continue
        if unit not in of_page:
            of_page[unit] = _is_of_page(text, unit)
        if of_page[unit] or is_letter(unit, text.count("\n", 0, match.start()) + 1):
            continue
        start = match.start() - len(side["side"])
        if start < rewriter.place:
            continue
        shown = f"\\,\\mathrm{{{unit}}}" if match["close"] or match["set"] else f" {unit}"
        rewriter.replace(start, match.end(), "(", (start, match.start()), f"){shown}{match['close']}")
    return rewriter.finish() if rewriter.pieces else None


def _is_result(side: str) -> bool:
    """Tell whether a side begins with a number, holds a wave and no unit of its own."""
    is_wave = _RESULT.match(side) is not None and _WAVE.search(side) is not None
    is_whole = side.strip().endswith(")") and side.strip().startswith("(")
    return is_wave and not is_whole and _UNIT_INSIDE.search(side) is None


def _is_of_page(text: str, unit: str) -> bool:
    """Tell whether a page gives a letter that is written like a unit a value, or an index."""
    name = re.escape(unit)
    return re.search(rf"(?<![\w\\{{]){name}(?:_|[ ]?\$?[ ]?[=≈])", text) is not None
