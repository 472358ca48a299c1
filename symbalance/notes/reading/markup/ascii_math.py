r"""AsciiMath within the delimiters of LaTeX, stem:[1/2 J omega^2]: its words become commands.

Only formulas without a backslash: an AsciiDoc page may set LaTeX in its stems as well.
"""

from __future__ import annotations

from symbalance.document.letters import GREEK_SIGN
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_FORMULA = re.compile(r"\\\((?P<inline>[^\\$]{1,2000}?)\\\)|\\\[(?P<display>[^\\$]{1,4000}?)\\\]")
_SIGNS = {
    "xx": "\\times ", "oo": "\\infty ", "pm": "\\pm ", "approx": "\\approx ", "sum": "\\sum",
    "prod": "\\prod", "int": "\\int ", "oint": "\\oint ", "dot": "\\dot ",
    "ddot": "\\ddot ", "bar": "\\bar ",
}  # fmt: skip
_NAMES = "|".join(sorted((*GREEK_SIGN, *_SIGNS), key=len, reverse=True))
_WORD = re.compile(
    rf"(?P<end>\))|(?<![A-Za-z\\])(?P<word>{_NAMES})(?![A-Za-z])"
    r"|(?P<script>(?<=[_^])\()|(?P<unequal>!=)|(?P<implies>=>)|(?P<below><=)|(?P<above>>=)|(?P<near>~~)|(?P<times>\*\*?)"
)
_MARKS = {
    "unequal": " \\ne ",
    "implies": " \\Rightarrow ",
    "below": " \\le ",
    "above": " \\ge ",
    "near": " \\approx ",
    "times": " \\cdot ",
}


def with_ascii_math(text: str) -> Rewritten | None:
    r"""Return a text with the words of AsciiMath as commands, None where there are none.

    >>> with_ascii_math(r"\(E = 1/2 J omega^2\)").text
    '\\(E = 1/2 J \\omega^2\\)'
    >>> with_ascii_math(r"\(sum_(k=1)^(n+1) k\)").text
    '\\(\\sum_{k=1}^{n+1} k\\)'
    """
    rewriter, changed = Rewriter(text), False
    for formula in _FORMULA.finditer(text):
        closing = _closing_of_scripts(text, *formula.span())
        for match in _WORD.finditer(text, formula.start() + 2, formula.end() - 2):
            if match["end"]:
                if match.start() in closing:
                    rewriter.replace(*match.span(), "}")
                continue
            if match["script"]:
                written = "{" if match.start() in closing.values() else "("
            elif match["word"]:
                written = _SIGNS.get(match["word"], f"\\{match['word']}")
            else:
                written = _MARKS[match.lastgroup or ""]
            rewriter.replace(*match.span(), written)
            changed = True
    return rewriter.finish() if changed else None


def _closing_of_scripts(text: str, start: int, end: int) -> dict[int, int]:
    """Return where the brackets of scripts close, x^(n+1), and where each of them opens."""
    waiting: list[int] = []
    result: dict[int, int] = {}
    for place in range(start + 2, end - 2):
        if text[place] == "(":
            waiting.append(place)
        elif text[place] == ")" and waiting:
            opener = waiting.pop()
            if text[opener - 1] in "_^":
                result[place] = opener
    return result
