r"""The letter d of a page that calls a diameter or a distance so, told from the sign of a differential.

In `\pi d n` and `d l` a d before a letter may begin a differential. On a page that speaks of a
diameter, or of a distance $d$, and has no calculus, it is that length.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_D = r"(?:\$|\\\(|`|\*){0,2}[ ]{0,2}(?<![A-Za-z0-9\\_^{}.'’])d(?![A-Za-z0-9_^{'’])"
_MEANT = re.compile(
    r"(?:distance|Abstand|距離|間隔)(?:\s+of\s+(?:the\s+|a\s+)?[a-z]{3,12})?\s{0,3}(?:は|を|が|,)?\s{0,3}(?:is\s+)?"
    + _D
    + r"|diameter|\bbore\b|[Dd]urchmesser|[直内外線]径"
)
_CALCULUS = re.compile(
    r"\\int|∫|\\frac\s*\{\s*(?:\\mathrm\s*)?\{?\s*d|\\mathrm\s*\{?\s*d|\\dot|\\partial|derivative|differenti|Ableitung|微分|積分"
    r"|(?<![A-Za-z\\])d\s?(?:t|x|y|\\theta|\\varphi|\\phi|\\alpha|\\omega|[θφϕαωA])(?![A-Za-z])"
    r"|(?<![A-Za-z\\])d[A-Za-z]\s*/\s*d[A-Za-z]"
)


def means_diameter(text: str) -> bool:
    r"""Tell whether a page calls a diameter or a distance d, and has no differentials.

    >>> means_diameter("of diameter $d$"), means_diameter(r"diameter $d$, $\int r\,dr$")
    (True, False)
    """
    return _MEANT.search(text) is not None and _CALCULUS.search(text) is None
