"""Relations of matrices that are no steps: they fix a matrix or its entries, or mean nothing."""

from __future__ import annotations

from symbalance.document.formula import Formula, Matrix, Name, Negative, Product, Sum, names
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.matrix_relations import matrix_constraint, meaningless
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, REFUTED
from symbalance.notes.reading.equations import Chain, Side


def no_relation_of_matrices(sign: str, left: Side, right: Side, knowledge: Knowledge) -> str:
    """Return why a relation cannot be one between matrices, "" where it may be."""
    if sign in SATISFIED_BY:
        return "matrices are compared for equality only"
    return meaningless(left.node, right.node, knowledge)


def fix_matrix(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a relation of matrices that fixes a letter, after defining it.

    It does not join the premises: those are solved as numbers are, whose products commute.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    pair = matrix_constraint(left, right, state.definitions.letters_in_use, knowledge)
    if pair is None:
        entries = _new_entries(left, right, knowledge)
        for letter, value in entries:
            state.definitions.define(letter, value, chain)
        return Decision(CONDITION, "entry by entry") if entries else None
    name, _ = pair
    if name in knowledge.meaning.kinds.identities:
        if _is_commutator(left) or _is_commutator(right):
            return Decision(REFUTED, "the trace of AB - BA is 0, that of the identity is not")
        return Decision(CONDITION, f"{name} is the identity: a condition on the others")
    state.definitions.define(*pair, chain)
    return Decision(DEFINITION, f"read as what fixes {name}")


def _new_entries(left: Formula, right: Formula, knowledge: Knowledge) -> list[tuple[str, Formula]]:
    """Return the letters without values that a vector of them gives values: (x, y) = (1, r cos θ)."""
    if not isinstance(left, Matrix) or not isinstance(right, Matrix) or names(left) & names(right):
        return []
    if [len(row) for row in left.rows] != [len(row) for row in right.rows]:
        return []
    first, second = (sum(m.rows, ()) for m in (left, right))
    own = [node.name for node in first if isinstance(node, Name) and not knowledge.has_meaning(node.name)]
    if not len(own) == len(first) == len(set(own)):
        return []
    return list(zip(own, second, strict=True))


def _is_commutator(node: Formula) -> bool:
    """Tell whether a formula is A B - B A."""
    if not isinstance(node, Sum) or len(node.terms) != 2 or not isinstance(node.terms[1], Negative):
        return False
    first, second = node.terms[0], node.terms[1].operand
    if not isinstance(first, Product) or not isinstance(second, Product):
        return False
    return len(first.factors) == 2 and first.factors == second.factors[::-1]
