r"""Conditions of cases with formulas in their words: \text{for $n$ even} is \text{for }n\text{ even}."""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten, Span
from symbalance.text import lazy_patterns as re

_CASES = re.compile(
    r"\\begin\s?\{d?cases\*?\}(?P<inside>(?:(?!\\(?:begin|end)\s?\{d?cases).){1,2000}?)\\end\s?\{d?cases",
    re.DOTALL,
)
_WORDS = re.compile(
    r"\\(?P<font>text|textrm|mbox|mathrm)\s?\{(?P<inside>[^{}$\n]{0,40}\$[^{}\n]{1,80})\}"
)


def with_conditions_apart(text: str) -> Rewritten | None:
    r"""Return a text with such words and formulas apart, None where there are none.

    >>> with_conditions_apart(r"\begin{cases} 1 & \text{for $n$ even} \\ 0 \end{cases}").text
    '\\begin{cases} 1 & \\text{for }n\\text{ even} \\\\ 0 \\end{cases}'
    """
    if "cases" not in text:
        return None
    rewriter, changed = Rewriter(text), False
    for cases in _CASES.finditer(text):
        for match in _WORDS.finditer(text, *cases.span("inside")):
            dollars = [match.start("inside") + n for n, sign in enumerate(match["inside"]) if sign == "$"]
            if len(dollars) % 2:
                continue
            edges = [match.start("inside") - 1, *dollars, match.end("inside")]
            texts: list[str | Span] = []
            for number in range(len(edges) - 1):
                part = edges[number] + 1, edges[number + 1]
                if part[0] < part[1]:
                    texts += [part] if number % 2 else [f"\\{match['font']}{{", part, "}"]
            rewriter.replace(*match.span(), *texts)
            changed = True
    return rewriter.finish() if changed else None
