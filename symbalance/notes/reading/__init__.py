"""The reader: a person's derivation, as written, to equations whose formulas are trees."""

from symbalance.notes.reading.document import read_document, read_equation, read_expression
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.letter_names import canonical_name

__all__ = [
    "ReadingError",
    "UndeclaredError",
    "canonical_name",
    "read_document",
    "read_equation",
    "read_expression",
]
