"""The reader of hand derivations: notes of any common kind to equations as formula trees.

In: a text and the letters declared at each line. Out: a `Document` of chains a = b = c, each side with
every reading it may have, and what could not be read, with its place and a remedy. No text is ever
executed as code.

    sources, rewriting              a file as people keep it, in one form; where each character stood
    macros, siunitx, mathml         what authors and packages abbreviate, other people's formulas
    physics_macros                  commands of the package physics and its like
    row_vectors                     rows of values in brackets
    extremes_apart, scanned_letters β max and |M|_max; the letter l that is a 1 in a scan
    words_behind_numbers            what a number is said to be a multiple of
    multiples_in_words              twice R, half of 88, das 1,17-fache, rの1.172倍 in signs
    continued_lines                 lines that begin with = and go on with the one above
    notebooks, numerals             cells as text; decimal commas, units in words, a scanner's letters
    ranges, joined_dollars          letters that run through values; formulas that dollars cut
    signs, units, letter_names      what signs and commands stand for; units; one name for each letter
    page_marks, function_names      what formats mark around formulas; other languages' names
    and_so_on, division_colons      + etc. for dots; 478 : 4 as a quotient
    units_behind_waves              1.97 cos φ kN: the unit of a whole side
    greek_words, short_greek        lambda = r/l and cos(2*th) in plain text
    letter_d                        the diameter d, told from a differential
    letter_e                        the offset e, told from the number
    letter_i                        the order i, told from the imaginary unit
    lexer, parser                   one formula's text to tokens, and these to trees
    prose, segmentation             where in a text mathematics stands
    document, result_units          a whole text to its chains; units that stand at a result only
    unit_places                     a unit typed once, behind the last number of a side
    accounting                      every relation sign is read, unreadable, or no mathematics
    equations, failures             what comes out, and why something may not be read
"""

from symbalance.notes.reading.document import Motions, read_document, read_equation, read_expression
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.letter_names import canonical_name

__all__ = [
    "Motions",
    "ReadingError",
    "UndeclaredError",
    "canonical_name",
    "read_document",
    "read_equation",
    "read_expression",
]
