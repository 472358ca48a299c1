r"""Products of undeclared letters that are set as vectors or matrices: \vec r \times \vec F.

They are read as numbers, whose products commute; what holds of numbers, or fails, says nothing of them.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Apply, Formula, Matrix, Name, Number, names, walk
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.matrix_relations import decide_matrices, is_of_matrices
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, UNDECIDED
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_FONTS = r"\\(?:vec|mathbf|boldsymbol|bm|overrightarrow|mathbfit|vb|va|underline)(?![A-Za-z])\s*"
_INDEX = r"(?:\s*_\s*(?:\{[^{}]{1,12}\}|[A-Za-z0-9]))?"
_MOVING = r"\\dot\s*\{?\s*\\vec[^{}]{1,10}\}?"
_VECTOR = rf"(?:{_FONTS}(?:\{{[^{{}}]{{1,12}}\}}|[A-Za-z]|\\[A-Za-z]+)|{_MOVING}){_INDEX}"
_CROSS = re.compile(
    rf"{_VECTOR}[\s)\]}}]{{0,4}}(?:\\times(?![A-Za-z])|×)[\s(\[{{−-]{{0,4}}(?:\\left)?[\s(]*{_VECTOR}"
)
_BOLD = r"\\(?:mathbf|boldsymbol|bm)(?![A-Za-z])\s*(?:\{\s*[A-Z]\s*\}|[A-Z](?![A-Za-z]))"
_OF_BOLD = re.compile(
    rf"{_BOLD}{_INDEX}\s*(?:\\cdot(?![A-Za-z])\s*)?{_BOLD}|\\mathbf\s*\{{\s*[A-Z]{{2,4}}\s*\}}"
    rf"|\([^()=]{{0,60}}{_BOLD}[^()=]{{0,60}}\)\s*\^\s*\{{?[2-9]"
)
CROSS = "a product × of vectors, which is not that of numbers"
VANISHES = "a determinant that is to vanish"
BOLD = "a product of letters that are set as matrices: declare what they are"


def decide_products_of_vectors(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return that a relation with a product of vectors is not judged; None where there is none."""
    left, right = chain.sides[k], chain.sides[k + 1]
    is_zero = right.node == Number(Fraction(0))
    if k and is_zero and names(left.node) and _is_determinant_of_entries(chain.sides[0].node, knowledge):
        return Decision(CONDITION, VANISHES)  # det(…) = (k - m ω²)² - c² = 0
    if is_zero and _is_determinant_of_entries(left.node, knowledge):
        if decide_matrices(left.node, right.node, "=", knowledge).is_proved:
            return None
        return Decision(CONDITION, VANISHES)
    if _is_open_determinant(left.node, knowledge):
        is_of_letter = isinstance(left.node, Apply) and isinstance(left.node.arguments[0], Name)
        if is_zero or (is_of_letter and not names(right.node)):
            return Decision(CONDITION, VANISHES if is_zero else "the value of a determinant")
    sources = [document.source(side.span) for side in (left, right)]
    is_cross = any(_CROSS.search(source) for source in sources)
    of_matrices = is_of_matrices(left.node, right.node, knowledge)
    if not is_cross and (of_matrices or not any(_OF_BOLD.search(source) for source in sources)):
        return None
    is_new = k == 0 and isinstance(left.node, Name) and left.node.name not in knowledge.definitions
    return Decision(DEFINITION if is_new else UNDECIDED, CROSS if is_cross else BOLD)


def _is_determinant_of_entries(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula is the determinant of a matrix in whose entries a letter has no number."""
    if not isinstance(node, Apply) or node.function != "det":
        return False
    definitions = knowledge.definitions
    open_letters = {n for n in names(node) if n not in definitions or not definitions[n].numeric}
    return isinstance(node.arguments[0], Matrix) and bool(open_letters)


def _is_open_determinant(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula is the determinant of letters without values."""
    if not isinstance(node, Apply) or node.function != "det" or not names(node):
        return False
    if not names(node).isdisjoint(knowledge.meaning.kinds.identities):
        return False
    parts = walk(node.arguments[0])
    values = (knowledge.definitions[n].node for n in names(node) if n in knowledge.definitions)
    return not any(isinstance(part, Matrix) for part in (*parts, *values))
