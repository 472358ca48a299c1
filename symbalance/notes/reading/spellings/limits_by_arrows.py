r"""Limits written with an arrow: for $x \to 0$ we have $\sin x/x \to 1$, which is lim sin x/x = 1.

A formula with an arrow is a claim where its sentence says which letter goes where; so is, behind such
words, a letter that had another formula above: for $\lambda \to 0$ it becomes $a = r\omega^2\cos\theta$.
"""

from __future__ import annotations

from dataclasses import dataclass

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_FORMULA = re.compile(
    r"\$\$(?P<display>[^$]{1,400}?)\$\$|\$(?P<inline>[^$\n]{1,300}?(?:\n[^$\n]{1,200}?)?)\$"
    r"|\\\[(?P<set_off>(?:(?!\\[\[\]]).){1,400}?)\\\]|\\\((?P<round>(?:(?!\\[()]).){1,300}?)\\\)",
    re.DOTALL,
)
_ARROW = r"(?:\\(?:to|rightarrow|longrightarrow)(?![A-Za-z])|→|⟶|(?<=\s)->(?=\s))"
_LETTER = r"\\?[A-Za-z]+(?:_(?:\{[^{}]{1,12}\}|\w))?|[α-ωΑ-Ω](?:_(?:\{[^{}]{1,12}\}|\w))?"
_VALUE = r"[-+]?\s?(?:\\infty|∞|[0-9]+(?:\.[0-9]+)?(?:\^\\circ|°)?|\\pi(?:/[0-9])?|π(?:/[0-9])?)"
_GOES = re.compile(rf"\s*(?P<letter>{_LETTER})\s*(?P<arrow>{_ARROW})\s*(?P<value>{_VALUE})\s*[.,;]?\s*")
"""A formula that says where a letter goes, and nothing else."""
_SIDE = rf"(?:(?!{_ARROW}|[=<>≈≤≥&]|\\\\).)+"
_ONE_ARROW = re.compile(rf"(?P<left>{_SIDE})(?P<arrow>{_ARROW})(?P<right>{_SIDE})", re.DOTALL)
_APART = r"(?:\\q?quad|\\[,;: ]|[\s,;(]|\\text\s*\{[^{}]*\}|\\mathrm\{[^{}]*\})"
_BEHIND = re.compile(rf"(?P<claim>.+?){_APART}+\(?(?P<goes>{_GOES.pattern})\)?\s*", re.DOTALL)
"""A claim with the words of its limit in one formula: A \\to B \\quad (x \\to 0)."""
_EQUATION = re.compile(
    r"\s*(?P<left>(?P<letter>\\?[A-Za-z]+(?:_(?:\{[^{}]{1,12}\}|\w))?))\s*(?P<sign>=)[^=<>≈≤≥&]+",
    re.DOTALL,
)
_INTRODUCED = re.compile(
    r"(?<![^\W\d_])(?:for|as|when|if|with|in\s+the\s+limit(?:\s+of)?|für|bei|wenn|mit|im\s+grenzfall"
    r"|pour|quand|lorsque|si|per|quando|se|para|cuando)[\s:(]*$",
    re.IGNORECASE,
)
"""Before a letter that goes somewhere, for what follows."""
_SENTENCE = re.compile(r"[.;!?](?=\s)|。|\n\s*\n")


NEAR = 40
"""Characters before a letter that goes somewhere, in which words introduce it."""


@dataclass(frozen=True, slots=True)
class _Formula:
    start: int
    end: int
    text: str


@dataclass(frozen=True, slots=True)
class _Claim:
    """Where the left side of a claim begins and ends, its sign and itself end, and its own limit."""

    start: int
    end: int
    sign_end: int
    last: int
    own: re.Match[str] | None = None


def with_limits_by_arrows(text: str) -> Rewritten | None:
    r"""Return a text with such limits as \lim, None where there are none.

    >>> with_limits_by_arrows(r"For $x \to 0$ we have $\sin x/x \to 1$.").text
    'For $x \\to 0$ we have $\\lim_{x \\to 0} (\\sin x/x )= 1$.'
    >>> with_limits_by_arrows(r"$a = b \cos c$. For $c \to 0$ it is $a = b$.").text
    '$a = b \\cos c$. For $c \\to 0$ it is $\\lim_{c \\to 0} (a)= b$.'
    >>> with_limits_by_arrows(r"a map $f: A \to B$, and $x \to 0$") is None
    True
    """
    if re.search(_ARROW, text) is None:
        return None
    formulas = [
        _Formula(match.start(group), match.end(group), match[group])
        for match in _FORMULA.finditer(text)
        if (group := match.lastgroup) is not None
    ]
    goes = _where_letters_go(text, formulas)
    rewriter, found = Rewriter(text), False
    for formula in formulas:
        if formula in goes:
            continue
        claim = _claim_of(formula) or _equation_behind(text, formula, goes)
        limit = claim and (claim.own or _limit_of_sentence(text, formula, goes))
        if not claim or not limit:
            continue
        rewriter.replace(claim.start, claim.start, f"\\lim_{{{limit['letter']} \\to {limit['value']}}} (")
        rewriter.replace(claim.end, claim.end, ")")
        rewriter.replace(claim.end, claim.sign_end, "=")
        if claim.own:
            rewriter.replace(claim.last, formula.end, " ")
        found = True
    return rewriter.finish() if found else None


def _where_letters_go(text: str, formulas: list[_Formula]) -> dict[_Formula, re.Match[str]]:
    """Return the formulas that say, by the words before them, where a letter goes: for $x \\to 0$."""
    every = {f: match for f in formulas if (match := _GOES.fullmatch(f.text)) is not None}
    return {f: match for f, match in every.items() if _is_introduced(text, f)}


def _is_introduced(text: str, formula: _Formula) -> bool:
    words = text[max(0, formula.start - NEAR) : formula.start].rstrip("$ \\[")
    return words.endswith("(") or _INTRODUCED.search(words) is not None


def _claim_of(formula: _Formula) -> _Claim | None:
    """Return the claim that a formula with an arrow is, None for any other."""
    behind = _BEHIND.fullmatch(formula.text)
    body = formula.text if behind is None else behind["claim"]
    match = _ONE_ARROW.fullmatch(body)
    if match is None:
        return None
    own = None if behind is None else _GOES.fullmatch(behind["goes"])
    first = formula.start + len(body) - len(body.lstrip())
    start = formula.start
    ends = start + match.end("left"), start + match.end("arrow"), start + match.end()
    return _Claim(first, *ends, own)


def _equation_behind(text: str, formula: _Formula, goes: dict[_Formula, re.Match[str]]) -> _Claim | None:
    """Return a letter's equation behind words of a limit, if it had a formula above; None else."""
    match = _EQUATION.fullmatch(formula.text)
    if match is None:
        return None
    before = [f for f in goes if f.end < formula.start and not _parts(text, f.end, formula.start)]
    if not before:
        return None
    above = re.search(rf"(?<![\w\\]){re.escape(match['letter'])}\s*=", text[: before[-1].start])
    if above is None:
        return None
    start = formula.start
    first, end = start + match.start("left"), start + match.end("left")
    return _Claim(first, end, start + match.end("sign"), start + match.end())


def _limit_of_sentence(
    text: str, formula: _Formula, goes: dict[_Formula, re.Match[str]]
) -> re.Match[str] | None:
    """Return what says where a letter goes in a formula's sentence: the nearest before it, or behind."""
    before = [f for f in goes if f.end < formula.start and not _parts(text, f.end, formula.start)]
    behind = [f for f in goes if f.start > formula.end and not _parts(text, formula.end, f.start)]
    if before:
        return goes[before[-1]]
    return goes[behind[0]] if behind else None


def _parts(text: str, first: int, last: int) -> bool:
    """Tell whether a sentence ends between two formulas; a display goes on with it."""
    between = text[first:last].rstrip("$ \n\\([")
    return _SENTENCE.search(between + " ") is not None
