r"""Rows of values in brackets, z = (1, i, −i, −1), put as a matrix of one row.

Only right of an equals sign, and where the bracket is the whole side: f = (a, b) of two letters may be
anything, three entries or numbers are a row. Behind (0, 540, 180)^\circ each entry is in degrees.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_SIGN = r"(?:\\[^()\[\]\n]|[^(),;=<>≤≥≈$\n\\])"
_ENTRY = rf"{_SIGN}+(?:\((?:\\[^()\[\]\n]|[^(),;=$\n\\])*\){_SIGN}*)*"
_GAP = r"(?:,\s|,(?=\D)|;)(?:\s|\\[,;:! ])*"
_WHOLE = r"[-−]?[0-9]{1,9}(?:\.[0-9]{1,9})?"
_TIGHT = rf"\s*{_WHOLE}(?:,{_WHOLE}){{1,60}}\s*"
"""(1,2) and (0,0,2): whole numbers or ones with a point, where no comma can be a decimal sign in all."""
_IN_DEGREES = r"(?P<degrees>\s*(?:\^\s*(?:\{\s*\\circ\s*\}|\\circ(?![A-Za-z]))|°|\\degree(?![A-Za-z])))?"
_OPEN = r"(?:\\left\s*|\\[bB]igg?l?\s*)?(?P<open>[(\[])"
_ROW = re.compile(
    rf"(?P<head>(?<![<>!:=])=\s*&?\s*){_OPEN}(?P<entries>{_TIGHT}(?=\\|[\])])|\s*{_ENTRY}(?:{_GAP}{_ENTRY})+)"
    rf"(?:\\right\s*|\\[bB]igg?r?\s*)?(?P<close>[)\]]){_IN_DEGREES}"
    r"(?P<turned>\s*\^\s*(?:\{?\s*(?:\\(?:top|mathsf|mathrm|rm|intercal)\s*\{?\s*)?T?\s*\}{0,2})|[ᵀ⊤])?"
    r"(?=\s*(?:[.,;、。](?!\d)|\$|\\\)|\\\]|\\\\|\\q?quad|\\end|\\text|\\,|\\;|\n|$|=|[^\W\d_]{2}))"
)
_NUMBER = re.compile(
    r"\s*[-+−±]?\s*(?:(?:[0-9]+(?:\.[0-9]+)?|\\[td]?frac\s*\{[^{}]*\}\s*\{[^{}]*\}|\\sqrt\s*\{?\w+\}?|√\s*\w+)\s*"
    r"(?:/\s*[0-9]+)?\s*(?:°|\^\{?\\circ\}?|\\degree)?\s*)?(?:[ija-z]|\\pi|π)?\s*"
)
_VALUE = re.compile(r"[-−]?[0-9]+(?:\.[0-9]+)?")
_SPACE_BEFORE, _SPACE_BEHIND = (re.compile(r"(?:\s|\\[,;:! ])+"), re.compile(r"(?:\s|\\[,;:! ])+$"))
_LANGUAGE = re.compile(r"[^\W\d_]{3,}(?![^\W\d_])")


def with_row_vectors(text: str) -> Rewritten | None:
    r"""Return a text with such rows as matrices, None where there are none.

    >>> with_row_vectors("$z = (1, i, -i, -1)$").text
    '$z = \\begin{pmatrix}1 & i & -i & -1\\end{pmatrix}$'
    >>> with_row_vectors(r"$\alpha = (0,540)^\circ$").text
    '$\\alpha = \\begin{pmatrix}0^{\\circ} & 540^{\\circ}\\end{pmatrix}$'
    """
    rewriter, changed = Rewriter(text), False
    for match in _ROW.finditer(text):
        spans = _entries(text, *match.span("entries"))
        if not _is_row(text, spans, match["open"] + match["close"], in_degrees=bool(match["degrees"])):
            continue
        pieces: list[str | tuple[int, int]] = ["\\begin{pmatrix}"]
        for number, span in enumerate(spans):
            pieces += [" & "] if number else []
            pieces += [span, "^{\\circ}"] if match["degrees"] else [span]
        pieces.append("\\end{pmatrix}")
        end = match.end("degrees") if match["degrees"] else match.end("close")
        rewriter.replace(match.end("head"), end, *pieces)
        changed = True
    return rewriter.finish() if changed else None


def _entries(text: str, start: int, end: int) -> list[tuple[int, int]]:
    """Return the spans of the entries, without the space around them."""
    spans: list[tuple[int, int]] = []
    depth, first = 0, start
    for place in range(start, end + 1):
        sign = text[place] if place < end else ","
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(sign, 0)
        if sign in ",;" and not depth and not text.endswith("\\", first, place):
            inside = text[first:place]
            space = _SPACE_BEFORE.match(inside)
            lead = space.end() if space else 0
            inside = _SPACE_BEHIND.sub("", inside)
            spans.append((first + lead, first + max(len(inside), lead)))
            first = place + 1
    return spans


def _is_row(text: str, spans: list[tuple[int, int]], brackets: str, *, in_degrees: bool) -> bool:
    """Tell a row of values from an interval, arguments or a remark; degrees are of numbers alone."""
    entries = [text[a:b] for a, b in spans]
    if in_degrees and not all(_VALUE.fullmatch(entry) for entry in entries):
        return False
    if not all(entries) or any(_LANGUAGE.search(re.sub(r"\\[A-Za-z]+", "", entry)) for entry in entries):
        return False
    if brackets in ("(]", "[)") or any("…" in e or "dots" in e or "..." in e for e in entries):
        return False
    are_numbers = all(_NUMBER.fullmatch(entry) for entry in entries)
    return are_numbers if len(entries) == 2 or brackets == "[]" else True
