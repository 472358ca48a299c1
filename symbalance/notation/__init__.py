"""Notation: formulas as data, series straight from integers, and the two writers of them."""

from symbalance.notation.latex_writer import InlineLatexWriter, LatexWriter
from symbalance.notation.series import CONVENTIONS, convention_named, series_latex, series_text
from symbalance.notation.text_writer import TextWriter
from symbalance.notation.writer import Writer

__all__ = [
    "CONVENTIONS",
    "InlineLatexWriter",
    "LatexWriter",
    "TextWriter",
    "Writer",
    "convention_named",
    "series_latex",
    "series_text",
]
