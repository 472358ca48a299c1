r"""Sets that letters run over beside a formula, `k \in \mathbb{Z}`, `\forall\theta`: no part of it.

The index of a sum is a part of it: `\sum_{k\in\{1,2,3\}}` runs from 1 to 3.
"""

from __future__ import annotations

import re

from symbalance.notes.reading.rewriting import Rewriter, Rewritten

_LETTER = r"(?:\\[a-z]{2,10}(?![A-Za-z])|(?<![\w\\])[^\W\d_](?![^\W\d_]))(?:_(?:\{\w{1,3}\}|\w{1,3}))?"
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

_OPEN_INDEX = re.compile(r"_\s*\{(?:\\substack\s*\{)?[^{}=]*$")
_NEAREST = 40
"""Characters before a membership in which the index that holds it opens."""
_INDEX = re.compile(
    rf"_\s*\{{\s*(?P<letter>{_LETTER})\s*(?:\\in(?![A-Za-z])|∈)\s*\\\{{(?P<listed>[^{{}}$\n=]{{1,60}})\\\}}\s*\}}(?!\s*\^)"
)
"""The index of a sum over a list, \\sum_{k\\in\\{1,2,3\\}}."""
_DOTS = re.compile(r"\\[lc]?dots|\.\.\.|…|⋯")
_WHOLE = re.compile(r"-?[0-9]{1,4}")


def with_memberships(text: str) -> Rewritten | None:
    r"""Return a text without what says over which set a letter runs, None where nothing does.

    >>> with_memberships(r"$\theta = k\pi,\ k \in \mathbb{Z}$").text
    '$\\theta = k\\pi,\\  $'
    """
    if not re.search(r"\\in(?![A-Za-z])|∈|∀|\\forall", text):
        return None
    rewriter = Rewriter(text)
    for match in _BESIDE.finditer(text):
        if _OPEN_INDEX.search(text, max(match.start() - _NEAREST, 0), match.start()) is None:
            rewriter.replace(*match.span(), " ")
    for match in _INDEX.finditer(text):
        if (bounds := _bounds(match["listed"])) is not None:
            first, last = bounds
            rewriter.replace(*match.span(), f"_{{{match['letter']}={first}}}^{{{last}}}")
    return rewriter.finish()


def _bounds(listed: str) -> tuple[str, str] | None:
    r"""Return where whole numbers that follow one another begin and end, None for other lists.

    >>> _bounds("1,2,3"), _bounds(r"0, \dots, N-1"), _bounds("1, 3, 5")
    (('1', '3'), ('0', 'N-1'), None)
    """
    entries = [entry.strip() for entry in listed.split(",")]
    is_open = len(entries) > 2 and _DOTS.fullmatch(entries[-2]) is not None
    shown = entries[:-2] if is_open else entries
    if not all(_WHOLE.fullmatch(entry) for entry in shown):
        return None
    numbers = [int(entry) for entry in shown]
    if numbers != list(range(numbers[0], numbers[0] + len(numbers))):
        return None
    return (shown[0], entries[-1]) if entries[-1] else None
