"""LaTeX formulas too wide for a table or a line, broken between the terms of a sum."""

from __future__ import annotations

from collections.abc import Sequence

import sympy

from symbalance.document.expressions import latex, spread_latex
from symbalance.document.latex_writer import latex_width
from symbalance.forces.rows import Row

LONGEST_CELL = 34
"""A cell whose LaTeX is longer than this prints its decimal, and its exact form below the table."""
WIDEST_LINE = 78
"""How many digits wide a line may be: A4 with margins of 22 mm holds 85 of them at 11 pt."""
INDENT = 5
"""What the indent of a continued line takes of that."""


def exact_forms(found: Sequence[Row]) -> list[str]:
    """Return the exact forms too long for a table, each once, with all the orders it belongs to."""
    places: dict[tuple[str, str], list[str]] = {}
    for row in found:
        for name, value in zip(("C", "S", r"\text{amplitude}"), row.exact(), strict=False):
            if len(latex(value)) > LONGEST_CELL:
                what, formula = _breakable(name, value)
                places.setdefault((formula, rf"\text{{{row.name}}}\ {what}"), []).append(str(row.order))
    if not places:
        return []
    lines = [
        broken(rf"&n = {', '.join(orders)},\ {what}", formula)
        for (formula, what), orders in places.items()
    ]
    return ["Exactly:", r"\begin{align*}", " \\\\\n".join(lines), r"\end{align*}"]


def _breakable(name: str, value: sympy.Expr) -> tuple[str, str]:
    """Return name and formula of a number; one too wide for a line without the root or bar over it."""
    formula = latex(value)
    if latex_width(formula) <= WIDEST_LINE - INDENT or value.has(sympy.Symbol):
        return name, formula
    if isinstance(value, sympy.Add):
        return name, spread_latex(value)
    return f"{name}^2", spread_latex(sympy.expand(value**2))


def broken(lead: str, formula: str) -> str:
    """Return `lead = formula` over the lines of an align, broken between the terms of the formula."""
    lines, room = [rf"{lead} = "], WIDEST_LINE - latex_width(lead) - latex_width(" = ")
    for term in _terms(formula):
        if latex_width(term) > room and lines[-1].strip():
            lines.append("")
            room = WIDEST_LINE - INDENT
        lines[-1] += term
        room -= latex_width(term)
    return " \\\\ &\\qquad ".join(line.rstrip() for line in lines)


def _terms(formula: str) -> list[str]:
    """Return the terms of a sum, each with its sign before it."""
    terms, depth, start = [], 0, 0
    for i, character in enumerate(formula):
        depth += (character in "{(") - (character in "})")
        if depth == 0 and i and formula[i : i + 3] in (" + ", " - "):
            terms.append(formula[start:i])
            start = i
    return [*terms, formula[start:]]
