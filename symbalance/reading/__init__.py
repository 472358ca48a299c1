"""The reader: a person's derivation, as written, to equations whose formulas are trees."""

from symbalance.reading.document import read_document, read_equation, read_expression
from symbalance.reading.failures import ReadingError, UndeclaredError
from symbalance.reading.naming import canonical_name
from symbalance.reading.render_latex import render_latex
from symbalance.reading.render_text import render

__all__ = [
    "ReadingError",
    "UndeclaredError",
    "canonical_name",
    "read_document",
    "read_equation",
    "read_expression",
    "render",
    "render_latex",
]
