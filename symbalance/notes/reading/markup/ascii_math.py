r"""AsciiMath within the delimiters of LaTeX, stem:[1/2 J omega^2]: it becomes LaTeX, sign by sign.

Its grammar (asciimath.org): a simple expression is a sign, a bracket or a function with what it is taken
of; it may have scripts; a/b is a fraction of the two next to the stroke, and a//b is a stroke.

    1/2 m r      \frac{1}{2} m r          sqrt 3 a       \sqrt{3} a
    x^(n+1)      x^{n+1}                  hat F_2        \hat{F}_2
    180^@        180^\circ                7970 " N"      7970 \text{ N}

Only formulas without a backslash: an AsciiDoc page may set LaTeX in its stems as well.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from symbalance.document.letters import GREEK_SIGN
from symbalance.document.wordlists import words
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_IS_LATEX = re.compile(r"^:stem:[ \t]*(?:latexmath|latex|tex)[ \t]*$", re.MULTILINE)
_FORMULA = re.compile(r"\\\((?P<inline>[^\\$]{1,2000}?)\\\)|\\\[(?P<display>[^\\$]{1,4000}?)\\\]")
_OF_ONE = {name: name for name in words("sqrt hat bar vec dot ddot tilde cancel overline underline text")}
_OF_ONE |= {"ul": "underline", "widehat": "hat", "bb": "mathbf", "mbox": "text"}
_FENCES = {
    "abs": ("\\left|", "\\right|"),
    "floor": ("\\lfloor ", "\\rfloor "),
    "ceil": ("\\lceil ", "\\rceil "),
}
_OF_TWO = {"frac": "frac", "root": "sqrt", "stackrel": "overset", "overset": "overset"}
_WORDS = {name: f"\\{name}" for name in GREEK_SIGN}
_WORDS |= {
    name: f"\\{name}"
    for name in words(
        "sin cos tan cot sec csc arcsin arccos arctan sinh cosh tanh exp log ln det lim min max gcd"
        " sum prod int oint in quad qquad approx cdots ldots vdots nabla ne le ge pm mp"
    )
}
_WORDS |= {"xx": "\\times", "oo": "\\infty", "del": "\\partial", "grad": "\\nabla", "prop": "\\propto"}
_WORDS |= {"iff": "\\Leftrightarrow", "implies": "\\Rightarrow"}
_SIGNS = {
    "<=>": "\\Leftrightarrow", "...": "\\ldots", "//": "/", "**": "\\cdot", "*": "\\cdot", "-:": "\\div",
    "+-": "\\pm", "-+": "\\mp", "!=": "\\ne", "<=": "\\le", ">=": "\\ge", "=>": "\\Rightarrow",
    "->": "\\to", "~~": "\\approx", "~=": "\\cong", "-=": "\\equiv", "@": "\\circ",
}  # fmt: skip
_NAMES = "|".join(sorted((*_WORDS, *_OF_ONE, *_OF_TWO, *_FENCES), key=len, reverse=True))
_TOKEN = re.compile(
    rf"\s+|(?P<text>\"[^\"]*\")|(?P<number>[0-9]+(?:[.,][0-9]+)*)|(?<![A-Za-z])(?P<word>{_NAMES})(?![A-Za-z])"
    rf"|(?P<sign>{'|'.join(re.escape(sign) for sign in _SIGNS)})|(?P<other>.)",
    re.DOTALL,
)
_CLOSING = {"(": ")", "[": "]", "{": "}"}


def with_ascii_math(text: str) -> Rewritten | None:
    r"""Return a text with its AsciiMath as LaTeX, None where there is none.

    >>> with_ascii_math(r"\(E = 1/2 J omega^2\)").text
    '\\(E = \\frac{1}{2} J \\omega^2\\)'
    >>> with_ascii_math(r"\(sum_(k=1)^(n+1) k\)").text
    '\\(\\sum_{k=1}^{n+1} k\\)'
    >>> with_ascii_math(r"\((a+b)/(2c) = hat F_2 // sqrt(3)\)").text
    '\\(\\frac{a+b}{2c} = \\hat {F}_2 / \\sqrt{3}\\)'
    """
    if _IS_LATEX.search(text):
        return None
    rewriter, changed = Rewriter(text), False
    for formula in _FORMULA.finditer(text):
        edits = _Formula(text, formula.start() + 2, formula.end() - 2).edits()
        for start, end, written in edits:
            rewriter.replace(start, end, written)
        changed = changed or bool(edits)
    return rewriter.finish() if changed else None


@dataclass(frozen=True, slots=True)
class _Token:
    kind: str
    text: str
    start: int
    end: int


@dataclass
class _Formula:
    """One formula, read from left to right; what becomes of its signs is noted by their places."""

    text: str
    start: int
    end: int
    written: dict[tuple[int, int], str] = field(default_factory=dict)
    before: dict[int, str] = field(default_factory=dict)
    """What is put in before a place: where a fraction begins, a brace opens."""
    behind: dict[int, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.tokens = [
            _Token(match.lastgroup, match.group(), *match.span())
            for match in _TOKEN.finditer(self.text, self.start, self.end)
            if match.lastgroup is not None
        ]
        self.place = 0

    def edits(self) -> list[tuple[int, int, str]]:
        """Return the changes that make LaTeX of it: a stretch and what is put in its place, in order."""
        while self.place < len(self.tokens):
            self._expression()
        edits = [(place, 0, place, written) for place, written in self.behind.items()]
        edits += [(place, 1, place, written) for place, written in self.before.items()]
        edits += [
            (start, 2, end, self._apart(written, end)) for (start, end), written in self.written.items()
        ]
        return [(start, end, written) for start, _, end, written in sorted(edits)]

    def _apart(self, written: str, end: int) -> str:
        """Return a command with a blank behind it where a letter follows."""
        is_command = written.startswith("\\") and written[-1:].isalpha()
        return f"{written} " if is_command and self.text[end : end + 1].isalpha() else written

    def _next(self, *texts: str) -> _Token | None:
        token = self.tokens[self.place] if self.place < len(self.tokens) else None
        return token if token is not None and (not texts or token.text in texts) else None

    def _expression(self) -> None:
        """Read a simple expression with its scripts, and a fraction where a stroke follows."""
        first = self.place
        self._with_scripts()
        stroke = self._next("/")
        if stroke is None or stroke.kind != "other":
            return
        above = self.place - 1
        self.place += 1
        below = self.place
        if self._next() is None:
            return
        self._with_scripts()
        self._braced(first, above, "\\frac{")
        self.written[stroke.start, stroke.end] = ""
        self._braced(below, self.place - 1, "{")

    def _with_scripts(self) -> None:
        self._simple()
        while self._next("_", "^") is not None:
            self.place += 1
            if (script := self._next()) is None:
                return
            first = self.place
            self._simple()
            if script.text in _CLOSING or self.place - first > 1:
                self._braced(first, self.place - 1, "{")

    def _simple(self) -> None:
        """Read one sign, one bracket with what is in it, or a function with what it is taken of."""
        token = self.tokens[self.place]
        self.place += 1
        if token.kind == "text":
            self.written[token.start, token.end] = f"\\text{{{token.text[1:-1]}}}"
        elif token.kind == "sign":
            self.written[token.start, token.end] = _SIGNS[token.text]
        elif token.kind == "word":
            self._word(token)
        elif token.text in _CLOSING:
            while (inner := self._next()) is not None and inner.text != _CLOSING[token.text]:
                self._expression()
            self.place += inner is not None

    def _word(self, token: _Token) -> None:
        arguments = 2 if token.text in _OF_TWO else int(token.text in (*_OF_ONE, *_FENCES))
        if not arguments:
            self.written[token.start, token.end] = _WORDS[token.text]
            return
        is_root = token.text == "root"
        fence = _FENCES.get(token.text)
        name = "" if fence else f"\\{_OF_TWO.get(token.text) or _OF_ONE[token.text]}"
        self.written[token.start, token.end] = name
        for k in range(arguments):
            if self._next() is None:
                return
            first = self.place
            self._simple()
            opening, closing = fence or (("[", "]") if is_root and not k else ("{", "}"))
            self._braced(first, self.place - 1, opening, closing)

    def _braced(self, first: int, last: int, opening: str, closing: str = "}") -> None:
        """Put what stands between two tokens into braces, without the brackets that enclose it all."""
        begin, end = self.tokens[first], self.tokens[last]
        if _CLOSING.get(begin.text) == end.text and self._encloses(first, last):
            self.written[begin.start, begin.end] = opening
            self.written[end.start, end.end] = closing
            return
        self.before[begin.start] = opening + self.before.get(begin.start, "")
        self.behind[end.end] = self.behind.get(end.end, "") + closing

    def _encloses(self, first: int, last: int) -> bool:
        depth = 0
        for k, token in enumerate(self.tokens[first : last + 1], first):
            depth += (token.text in _CLOSING) - (token.text in _CLOSING.values())
            if not depth:
                return k == last
        return False
