"""Relations that state a special case: numbers put in for letters, and conditions on an angle.

They are definitions, and no line is refuted for them.

F = m r ω² = 0.5·0.04·628² = 7888       the second = puts numbers in, the third is arithmetic
cos θ = 0,  2θ = 180°                   a condition
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Negative, Number, Product, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.algebra.series import Expansion
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import PROVED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.order_agreement import SmallLetter, truncated_sum
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.reading.equations import Chain

HIGHEST_ORDER = 8
"""Of the rod ratio's powers that a line with numbers may have been cut off at."""


def decide_numeric_case(
    chain: Chain, k: int, refutation: Decision, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a refuted relation that only puts numbers in, or states a condition."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if names(right) or not names(left) or refutation.left is None:
        return None
    free = set(letters(refutation.left))
    if not free:
        return None
    if free & knowledge.angles:
        alone = k == 0 and len(chain.relations) == 1
        simple = alone and (is_simple(left) or _is_product(left, right, knowledge))
        return Decision(DEFINITION, "a condition") if simple else None
    if right == Number(Fraction(0)):
        return None
    numeric_letters = {n for n, d in knowledge.definitions.items() if d.numeric}
    return None if names(left) <= numeric_letters else Decision(DEFINITION, "numbers put in")


def states_a_case(chain: Chain) -> bool:
    """Tell whether a chain gives one letter, or a function of it, a number: α = 45°, tan δ = 1/3.

    Such a chain is taken first of those on its line: a condition often stands behind what it holds for.
    """
    if len(chain.sides) != 2 or names(chain.sides[1].node):
        return False
    left = chain.sides[0].node
    return isinstance(left, Name) or (isinstance(left, Call) and isinstance(left.argument, Name))


def decide_with_ratio(left: Formula, right: Formula, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a ≈ r ω²(cos θ + ¼ cos 2θ) after λ = 4: cut off at an order, then put in.

    None unless the ratio has a number, does not stand on the right, and some order agrees.
    """
    small = knowledge.crank.small if knowledge.crank else None
    definition = knowledge.definitions.get(small[0]) if small else None
    if small is None or definition is None or not definition.numeric or small[0] in names(right):
        return None
    level = list(knowledge.levels(left, right))[-1]
    evaluator = knowledge.evaluator(level)
    try:
        exact = Expansion(evaluator.domain, *small, HIGHEST_ORDER).of(evaluator.form(left))
        for order in range(HIGHEST_ORDER + 1):
            cut_off = truncated_sum(exact.cut(order), SmallLetter(*small, order))
            node = substitute(
                polynomial_node(evaluator.domain, cut_off.numerator), small[0], definition.node
            )
            if decide_equality(node, right, knowledge).is_proved:
                name = SmallLetter(*small, order).text
                return Decision(
                    PROVED,
                    f"with {formula_text(Name(small[0]), plain=True)} of line {definition.line}",
                    order=name,
                )
    except (NoFormError, TooLargeError):
        return None
    return None


def _is_product(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether sin θ (1 + 2ρ cos θ) = 0 is stated: a product of functions of an angle is to be 0."""
    if right != Number(Fraction(0)) or not isinstance(left, Product):
        return False
    return sum(bool(names(factor) & knowledge.angles) for factor in left.factors) > 1


def is_simple(node: Formula) -> bool:
    """Tell whether a side is a function of an angle, or a multiple of a letter, as in a condition."""
    if isinstance(node, Negative):
        return is_simple(node.operand)
    if isinstance(node, Product):
        return (
            len(node.factors) == 2 and isinstance(node.factors[0], Number) and is_simple(node.factors[1])
        )
    if isinstance(node, Call):
        return node.function in ("sin", "cos", "tan") and is_simple(node.argument)
    return isinstance(node, Name)
