"""The reader of hand derivations: notes of any common kind to equations as formula trees.

In: a text and the letters declared at each line. Out: a `Document` of chains a = b = c, each side with
every reading it may have, and what could not be read, with its place and a remedy. No text is ever
executed as code.

    markup        what file formats and LaTeX packages put for a formula, in plain LaTeX
    letters       letters however they are written: λ, lambda, Fmax, F2x, the l that a scan shows as 1
    spellings     numbers, lists, ranges and words of arithmetic in the signs the parser knows
    sources       a file as people keep it, in one form, by these three
    passages      where on a page mathematics stands, and where it ends
    formulas      one formula's text to tokens, and these to every tree it may mean
    document      a whole text to its chains
    accounting    every relation sign is read, unreadable, or no mathematics
    equations, failures    what comes out, and why something may not be read
    signs, units, rewriting    what a sign stands for; units; where each character stood
"""

from symbalance.notes.reading.document import Motions, read_document, read_equation, read_expression
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.letters.letter_names import canonical_name

__all__ = [
    "Motions",
    "ReadingError",
    "UndeclaredError",
    "canonical_name",
    "read_document",
    "read_equation",
    "read_expression",
]
