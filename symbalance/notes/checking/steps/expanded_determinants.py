r"""The polynomial that a vanishing determinant comes to: (k - mω²)² - c² = 0 below |…| = 0.

Right below the determinant, and in its letters, it is the same equation but for a factor without the
unknown, or it is wrong. One of another degree may have lost roots on purpose, and stays what it is.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Apply, Formula, Matrix, Name, Number, Product, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.motions.equations_of_motion import MOST, determinant
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.roots_of_conditions import is_said_apart
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ZERO = Number(Fraction(0))
_NEAR = 120
"""Characters between a determinant and its polynomial."""
_UNKNOWN = re.compile(r"(?:omega|Omega|lambda|Lambda|mu|nu|p|s|x|z)(?:_.*)?")
"""Letters that a characteristic equation is in."""


def unless_another_polynomial(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a polynomial set to zero right below a determinant is what that comes to."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_open = verdict.verdict not in (REFUTED, CONTRADICTION, *PROVED_WORDS)
    if k or not is_open or chain.relations[0].sign != "=" or right != _ZERO or _determinant(left):
        return verdict
    above = state.sections.chain_before(chain.start)
    if above is None or not above.relations or above.sides[-1].node != _ZERO:
        return verdict
    expanded = _determinant(above.sides[0].node)
    leading = state.document.text[above.end : chain.start]
    if (
        expanded is None
        or names(left) != names(expanded)
        or len(leading) > _NEAR
        or is_said_apart(leading)
    ):
        return verdict
    decision = _compared(left, expanded, above.lines[0])
    return verdict if decision is None else describe(state.document, chain, k, decision)


def _determinant(node: Formula) -> Formula | None:
    """Return a formula that is the determinant of entries, written out; None for any other."""
    if not isinstance(node, Apply) or node.function != "det":
        return None
    matrix = node.arguments[0]
    if not isinstance(matrix, Matrix) or not len(matrix.rows) == len(matrix.rows[0]) <= MOST:
        return None
    return determinant(matrix.rows)


def _compared(left: Formula, expanded: Formula, line: int) -> Decision | None:
    """Return whether two formulas are zero at the same values of an unknown; None where that is open."""
    for name in sorted(names(left)):
        if _is_constant_ratio(left, expanded, name) is True:
            return Decision(PROVED, f"by line {line}")
    unknowns = [name for name in sorted(names(left)) if _UNKNOWN.fullmatch(name)]
    if len(unknowns) != 1 or _degree(left, unknowns[0]) != _degree(expanded, unknowns[0]):
        return None
    if _is_constant_ratio(left, expanded, unknowns[0]) is None:
        return None
    return Decision(REFUTED, f"is not zero where the determinant of line {line} is")


def _is_constant_ratio(left: Formula, expanded: Formula, name: str) -> bool | None:
    """Tell whether the ratio of two formulas is the same for every value of a letter; None where open."""
    other = Name(name + "'")
    try:
        first = Product((left, substitute(expanded, name, other)))
        second = Product((substitute(left, name, other), expanded))
        decision = decide(lone_side(first), lone_side(second), "=", Knowledge())
    except (NoFormError, TooLargeError):
        return None
    return True if decision.is_proved else False if decision.status == REFUTED else None


def _degree(node: Formula, name: str) -> Fraction | int | None:
    """Return the power to which a letter stands in a polynomial, None where it is none."""
    try:
        form = Knowledge().evaluator(Level({})).form(node)
    except (NoFormError, TooLargeError):
        return None
    own = form.domain.symbol(name)
    return max((e for monomial in form.numerator for g, e in monomial if g == own), default=0)
