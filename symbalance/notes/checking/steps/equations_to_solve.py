"""Whether an equation is to be solved: by the words before it, or by a value right below it."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Name,
    Number,
    Power,
    Product,
    names,
    walk,
)
from symbalance.notes.algebra.evaluation import is_derivative_name
from symbalance.notes.checking.deciding.equality import decide_equality
from symbalance.notes.checking.declared.symbol_roles import letters_by_role
from symbalance.notes.checking.page.solutions import chains_below
from symbalance.notes.checking.steps.derivatives_set_to_zero import slope_set_to_zero
from symbalance.notes.checking.steps.judging_state import ANGLES, JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

MOST_REARRANGED = 8
"""Equations over which one leads to a value of its letter."""
_WHERE = re.compile(
    r"(?:(?<![^\W\d_])(?:where|when|whenever|if|solve|solving|setting|wo|wenn|falls|löse|où|quand|lorsque|si|dove|quando|se"
    r"|donde|cuando)(?![^\W\d_])|とき|場合)[^\w]*$",
    re.IGNORECASE,
)
"""Right before an equation that holds somewhere only."""


def is_to_be_solved(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether an equation is to be solved: by a formula's slope, words, or a value below it."""
    if k + 1 < len(chain.relations) and slope_set_to_zero(chain, state.knowledge(chain.lines[0])):
        return False  # dS/dk = 2k = 0: what the derivative is, before it is set to zero
    if _is_worked_out(state, chain, k):
        return False
    return _is_where_derivative_vanishes(state, chain, k) or _is_solved_by_words(state, chain, k)


def _is_worked_out(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether a formula is differentiated, the other side being of its letters: d/dx √(1 - x²) = …

    Such a relation says what the derivative is, for every x, whatever nouns stand before it; it is an
    equation where words right before it say so, or where x gets a value right behind.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if not isinstance(left, Derivative) or isinstance(left.expression, Name):
        return False
    own = names(left.expression)
    if left.variable.name not in own & names(right) or not names(right) <= own:
        return False
    following = _next(state, chain)
    is_found = following is not None and following.sides[0].node == left.variable
    return not is_found and _WHERE.search(state.sections.sentence_leading_to(chain)) is None


def _is_solved_by_words(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether an equation is to be solved: by the words before it, or by a value right below.

    cos θ + λ cos 2θ = 0 may be a claim; behind "where", or with θ = 76° next, it is none. Numbers may
    follow what the equation says: where cos θ = −1/(4λ) = −0.833.
    """
    if len(chain.relations) != 1 and (k or any(names(side.node) for side in chain.sides[2:])):
        return False
    own = names(chain.sides[k].node) | names(chain.sides[k + 1].node)
    if _is_solved_next(state, chain, own):
        return True
    if angles := names(chain.sides[k].node) & names(chain.sides[k + 1].node) & _angles(state, chain):
        # sin 2θ = 2 sin θ claims that they are the same
        return _is_solved_for_angle(state, chain, k, angles)
    if state.sections.is_condition(chain):
        return True
    following = _next(state, chain)
    if following is None or _turns_to_angle(state, chain, following):
        return following is not None
    is_claimed = chain.relations[k].sign == "≈" and following.relations[0].sign not in "=≈"
    # 1/(1-x) ≈ 1 + x for x ≪ 1 is claimed there
    is_apart = state.sections.paragraph_start(following.lines[0]) > chain.lines[-1]
    is_of_both = bool(names(chain.sides[k].node) & names(chain.sides[k + 1].node))
    # another paragraph tries a value of its own
    return _is_rearranged_to_value(state, chain, own) or (
        not is_claimed
        and not (chain.inline and is_of_both and is_apart)
        and len(own) == 1
        and isinstance(following.sides[0].node, Name)
        and following.sides[0].node.name in own
        and not names(following.sides[1].node)
    )


def _is_solved_for_angle(state: JudgingState, chain: Chain, k: int, angles: Collection[str]) -> bool:
    """Tell whether words or its shape make an equation in one angle one of some angles, solved behind.

    Where A sin 2θ = B cos 2θ ⇒ tan 2θ = B/A: what follows has the angle on its left side alone.
    """
    following = _next(state, chain)
    if following is None or not state.sections.is_consequence(following):
        return False
    left, right = following.sides[0].node, following.sides[1].node
    is_of_angle = isinstance(left, Name | Call | Product | Power) and names(left) & frozenset(angles)
    if not is_of_angle or names(right) & frozenset(angles) or state.sections.is_said_always(chain):
        return False
    waves = [list(_waves(side.node)) for side in chain.sides[k : k + 2]]
    is_of_two_waves = all(len(own) == 1 for own in waves) and (
        waves[0][0].argument == waves[1][0].argument and waves[0][0].function != waves[1][0].function
    )
    return is_of_two_waves or state.sections.is_condition(chain)


def _is_where_derivative_vanishes(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether a side that is set to 0 is, but for a factor, the derivative of a formula above by θ.

    -sin θ - cos θ = 0 below F = K (cos θ - sin θ): it is largest there, and the sides are not the same.
    """
    left, right, line = chain.sides[k].node, chain.sides[k + 1].node, chain.lines[0]
    if right != Number(Fraction(0)) or k + 1 < len(chain.relations):
        return False
    knowledge = state.knowledge(line)
    turning = {name for call in _waves(left) for name in names(call.argument)}
    if len(turning) != 1:
        return False
    (name,) = turning
    head = chain.sides[0].node
    if k and isinstance(head, Name) and not is_derivative_name(head.name) and "'" not in head.name:
        return False  # F_h = K sin θ = 0 beside F_v = K cos θ is another force, and no slope
    if any(isinstance(s.node, Derivative) and s.node.variable == Name(name) for s in chain.sides[:k]):
        return True
    angle = Name(name)
    for definition in knowledge.definitions.values():
        if definition.line > line or not any(name in names(c.argument) for c in _waves(definition.node)):
            continue
        slope = Derivative(definition.node, angle, 1)
        sides = (
            Product((left, Derivative(definition.node, angle, 2))),
            Product((Derivative(left, angle, 1), slope)),
        )
        is_constant = decide_equality(slope, Number(Fraction(0)), knowledge).is_proved
        if not is_constant and decide_equality(*sides, knowledge).is_proved:
            return True
    return False


def _waves(node: Formula) -> Iterator[Call]:
    """Yield the sines and cosines of a formula."""
    for part in walk(node):
        if isinstance(part, Call) and part.function in ("sin", "cos"):
            yield part


def _is_solved_next(state: JudgingState, chain: Chain, own: frozenset[str]) -> bool:
    """Tell whether an equation is solved for a letter by what follows: 8U = 4m λ ⇒ U = m λ/2."""
    following = _next(state, chain)
    if following is None or not state.sections.is_consequence(following):
        return False
    head = following.sides[0].node
    both = names(chain.sides[0].node) & names(chain.sides[1].node)
    if not isinstance(head, Name) or head.name not in own - both:
        return False
    is_open = not state.knowledge(chain.lines[0]).has_meaning(head.name)
    return is_open and names(following.sides[1].node) <= own - {head.name}


def _is_rearranged_to_value(state: JudgingState, chain: Chain, own: frozenset[str]) -> bool:
    """Tell whether an equation of one letter leads over others to a value: √(x+1) = x-1 ⇒ … ⇒ x = 3.

    Each follows from the one before by an arrow or by words, and has no other letter.
    """
    if len(own) != 1 or state.knowledge(chain.lines[0]).has_meaning(*own):
        return False
    for n, following in enumerate(chains_below(state.sections, chain)):
        is_next = state.sections.is_consequence(following) and following.relations[0].sign == "="
        if n >= MOST_REARRANGED or not is_next or following.letters != own:
            return False
        if isinstance(following.sides[0].node, Name) and not names(following.sides[1].node):
            return True
    return False


def _turns_to_angle(state: JudgingState, chain: Chain, following: Chain) -> bool:
    """Tell whether a motion that has some value gives the crank angle next: x = r, so θ = π/2."""
    head, angle = chain.sides[0].node, following.sides[0].node
    moving = state.knowledge(chain.lines[0]).moving
    return (
        isinstance(head, Name)
        and head.name in moving
        and isinstance(angle, Name)
        and angle.name in _angles(state, chain)
        and not names(following.sides[1].node)
        and state.sections.is_consequence(following)
    )


def _next(state: JudgingState, chain: Chain) -> Chain | None:
    """Return the chain that follows in the text, if it stands near."""
    return next(chains_below(state.sections, chain), None)


def _angles(state: JudgingState, chain: Chain) -> set[str]:
    letters = letters_by_role(state.declarations.symbols_at(chain.lines[0]))
    return {name for meaning in ANGLES for name in letters.get(meaning, ())}
