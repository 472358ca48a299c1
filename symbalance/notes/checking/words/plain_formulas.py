"""Helpers for formulas that nobody wrote: as plain text, and as the side of a relation."""

from __future__ import annotations

from symbalance.document.formula import Formula
from symbalance.document.text_writer import formula_text
from symbalance.notes.reading.equations import Side


def plain_text(node: Formula) -> str:
    """Return a formula as plain text."""
    return formula_text(node, plain=True)


def lone_side(node: Formula) -> Side:
    """Return a formula as a side that stands nowhere in a text."""
    return Side((node,), (0, 0))
