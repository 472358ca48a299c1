"""The reader of hand derivations: LaTeX, Markdown or plain text to equations as formula trees.

In: a text and the letters declared at each line. Out: a `Document` of chains a = b = c, each side with
every reading it may have, and what could not be read, with its place and a remedy. No text is ever
executed as code.

    signs, units, letter_names      what signs and commands stand for; units; one name for each letter
    lexer, parser                   one formula's text to tokens, and these to trees
    prose, segmentation             where in a text mathematics stands
    document                        a whole text to its chains
    equations, failures             what comes out, and why something may not be read
"""

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
