"""LaTeX formulas too wide for a line, broken between the terms of a sum."""

from __future__ import annotations

import re

import sympy

from symbalance.tables.expressions import latex, spread_latex

WIDEST_LINE = 60
"""About how many characters a line of formulas holds."""


def breakable(name: str, value: sympy.Expr) -> tuple[str, str]:
    """Return name and formula of a number; one too wide for a line without the root or bar over it."""
    formula = latex(value)
    if _width(formula) <= WIDEST_LINE or value.has(sympy.Symbol):
        return name, formula
    if isinstance(value, sympy.Add):
        return name, spread_latex(value)
    return f"{name}^2", spread_latex(sympy.expand(value**2))


def broken(formula: str, limit: int = WIDEST_LINE) -> str:
    """Return a formula broken over the lines of an align, between the terms of its outermost sum."""
    lines, line = [], ""
    for term in _terms(formula):
        if line and _width(line) + _width(term) > limit:
            lines.append(line)
            line = ""
        line += term
    return r" \\ &\qquad ".join([*lines, line])


def _terms(formula: str) -> list[str]:
    """Return the terms of a sum, each with its sign before it."""
    terms, depth, start = [], 0, 0
    for i, character in enumerate(formula):
        depth += (character in "{(") - (character in "})")
        if depth == 0 and i and formula[i : i + 3] in (" + ", " - "):
            terms.append(formula[start:i])
            start = i
    return [*terms, formula[start:]]


def _width(formula: str) -> int:
    """Return about how many characters wide a formula is printed."""
    flat = re.sub(r"\\(sqrt|left|right|operatorname|text)|[\\^ ](?=\{)", "", formula)
    while (simpler := _INNERMOST.sub(_wider, flat)) != flat:
        flat = simpler
    return len(re.sub(r"\\(pi|theta|lambda|cdots)|\\,", "x", flat).replace(" ", ""))


_INNERMOST = re.compile(r"\\t?frac\{([^{}]*)\}\{([^{}]*)\}|\{([^{}]*)\}")


def _wider(found: re.Match[str]) -> str:
    """Return the wider part of a fraction, or what a pair of braces holds."""
    return found[3] if found[1] is None else max(found[1], found[2], key=len)
