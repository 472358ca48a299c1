"""Notation: formulas as data, series straight from integers, and the two writers of them."""

from symbalance.notation.series import CONVENTIONS, convention_named, series_latex, series_text
from symbalance.notation.writers import LatexWriter, TextWriter, Writer

__all__ = [
    "CONVENTIONS",
    "LatexWriter",
    "TextWriter",
    "Writer",
    "convention_named",
    "series_latex",
    "series_text",
]
