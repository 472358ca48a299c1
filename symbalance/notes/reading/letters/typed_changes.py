"""Changes typed with a d, dE for ΔE: on a page without calculus they are one letter each.

In `Cs = dE/(I*w^2)` a d before a letter would begin a differential. Where the page gives the whole a
number, dE = 0.25*293 = 73 ft lb, and divides by nothing of the kind, it is a finite change.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_GIVEN = re.compile(
    r"(?<![A-Za-z0-9\\_^{}'’])d(?P<letter>[A-Z])[ \t]*[=≈][ \t]*"
    r"[0-9][0-9.,]*(?:[ \t]*[*·×/][ \t]*[0-9][0-9.,]*)*(?=[ \t\n=≈,;]|\.\s|$)"
)
_CALCULUS = re.compile(
    r"∫|\\int|\bintegral|differenti|derivative|ableitung|dérivée|derivada|derivata|微分|積分"
    r"|/[ \t]?\(?[ \t]?d[A-Za-zα-ω](?![A-Za-z])",
    re.IGNORECASE,
)


def with_typed_changes(text: str) -> Rewritten | None:
    """Return a text with its changes as ΔE, None where there are none.

    >>> with_typed_changes("dE = 0.25*293 and C = dE/(I*w^2)").text
    'ΔE = 0.25*293 and C = ΔE/(I*w^2)'
    >>> with_typed_changes("dE = 3 and F = dE/dx") is None
    True
    """
    letters = {match["letter"] for match in _GIVEN.finditer(text)}
    if not letters or _CALCULUS.search(text):
        return None
    rewriter = Rewriter(text)
    for match in re.finditer(
        rf"(?<![A-Za-z0-9\\_^{{}}'’])d(?=[{''.join(sorted(letters))}](?![A-Za-z]))", text
    ):
        rewriter.replace(*match.span(), "Δ")
    return rewriter.finish()
