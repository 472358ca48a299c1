r"""Sets that letters run over: beside a formula, k \in \mathbb{Z}, no part of it; below a sum one.

Below a sum or a product a set of successive whole numbers is put as its bounds, any other stays.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_OPERATOR = r"(?:sum|prod|int|oint|max|min|lim|sup|inf|bigcup|bigcap|left|limits|frac|mathrm|text)"
_LETTER = (
    rf"(?:\\(?!{_OPERATOR}(?![A-Za-z]))[a-z]{{2,10}}(?![A-Za-z])|(?<![\w\\])[^\W\d_](?![^\W\d_]))"
    r"(?:_(?:\{\w{1,3}\}|\w{1,3}))?"
)
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

_LIST_FIRST = re.compile(rf"(?:{_LETTER}\s*,\s*){{1,3}}")
_SEPARATED = re.compile(r"(?:[$,;:.(]|\\q?quad|\\[,;: ]|[A-Za-z]{2})$")
"""What stands before a list of letters: a mark, a gap or a word."""
LONGEST = 40
"""Characters before a set in which the subscript begins that it stands in."""
_BELOW = re.compile(r"_\s*\{[^{}$\n]*$")
_OF_SUM = re.compile(r"\\(?:sum|prod)(?:\s*\\limits)?\s*_\s*\{\s*$")
_BOUNDED = re.compile(
    rf"(?P<letter>{_LETTER})\s*(?:\\in(?![A-Za-z])|∈)\s*\\\{{\s*(?P<listed>[^{{}}$\n=]{{1,60}})\s*\\\}}"
)
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
        if not _BELOW.search(text, max(match.start() - LONGEST, 0), match.start()):
            rewriter.replace(_begin(text, match), match.end(), " ")
        elif (bounds := _bounds(text, match)) is not None:
            rewriter.replace(match.start(), match.end() + 1, *bounds)
    return rewriter.finish()


def _begin(text: str, match: re.Match[str]) -> int:
    r"""Return where the letters of a set begin: of a_k, k \in S behind a sum that is k alone."""
    listed = _LIST_FIRST.match(match[0])
    before = text[max(match.start() - 10, 0) : match.start()].rstrip()
    if listed is None or not before or _SEPARATED.search(before):
        return match.start()
    return match.start() + listed.end()


def _bounds(text: str, match: re.Match[str]) -> tuple[str | tuple[int, int], ...] | None:
    r"""Return `k=1}^{3}` for `k \in \{1,2,3\}}` below a sum or a product, None for any other set."""
    below = _BOUNDED.fullmatch(match[0])
    ends = _ends(below["listed"]) if below is not None else None
    is_whole = text.startswith("}", match.end()) and _OF_SUM.search(text, 0, match.start())
    if below is None or ends is None or not is_whole:
        return None
    start, (first, last) = match.start(), ends
    return (
        (start + below.start("letter"), start + below.end("letter")),
        f"={first}}}^{{{last}}}",
    )


def _ends(listed: str) -> tuple[str, str] | None:
    r"""Return where whole numbers that follow one another begin and end, None for other lists.

    >>> _ends("1,2,3"), _ends(r"0, \dots, N-1"), _ends("1, 3, 5")
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
