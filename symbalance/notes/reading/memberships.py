r"""Sets that letters run over beside a formula, `k \in \mathbb{Z}`, `\forall\theta`: no part of it."""

from __future__ import annotations

import re

from symbalance.notes.reading.rewriting import Rewriter, Rewritten

_LETTER = r"(?:\\[a-z]{2,10}(?![A-Za-z])|(?<![\w\\])[^\W\d_](?![^\W\d_]))(?:_\{?\w{1,3}\}?)?"
_LETTERS = rf"{_LETTER}(?:\s*,\s*{_LETTER}){{0,3}}"
_NUMBERS = (
    r"(?:\\mathbb\s*(?:\{\s*[NZRQC]\s*\}|[NZRQC])|\\(?:NN?|ZZ?|RR?|QQ?|CC)(?![A-Za-z])|[ℕℤℝℚℂ])"
    r"(?:\s*[_^]\s*(?:\{[^{}]{1,12}\}|[0-9+*]))*[₀⁺]?"
)
_INTERVAL = r"(?:\\left\s*)?[\[\](][^\[\]()$\n=]{1,30}[,;][^\[\]()$\n=]{1,30}(?:\\right\s*)?[\])\[]"
_LISTED = r"\\\{[^{}$\n=]{1,60}\\\}"
_SET = rf"(?:{_NUMBERS}|{_INTERVAL}|{_LISTED})"
_MEMBER = rf"{_LETTERS}\s*(?:\\in(?![A-Za-z])|∈)\s*{_SET}"
_EVERY = r"(?:\\forall(?![A-Za-z])|∀)\s*"
_BESIDE = re.compile(
    rf"\(\s*(?:{_EVERY})?{_MEMBER}\s*\)|(?:{_EVERY})?{_MEMBER}(?:\s*:(?!=))?|{_EVERY}{_LETTERS}(?:\s*:(?!=))?"
)


def with_memberships(text: str) -> Rewritten | None:
    r"""Return a text without what says over which set a letter runs, None where nothing does.

    >>> with_memberships(r"$\theta = k\pi,\ k \in \mathbb{Z}$").text
    '$\\theta = k\\pi,\\  $'
    """
    if not re.search(r"\\in(?![A-Za-z])|∈|∀|\\forall", text):
        return None
    rewriter = Rewriter(text)
    for match in _BESIDE.finditer(text):
        rewriter.replace(*match.span(), " ")
    return rewriter.finish()
