"""The equation that stands nearest above a number of a letter: for the hollow shaft τ is another formula.

A page has τ = 16 M/(π d³), and further down for another thing τ = 16 M D/(π (D⁴ - d⁴)), or u b = c a in a
section of its own where u had a formula before. A number of the letter that follows is that of the
equation nearest above it, with the numbers given last.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Number, Power, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain, Side

FEWEST = 2
"""Letters with numbers that an equation has besides the one worked out, a formula of it all."""


def by_nearest_equation(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the proof that a refuted number of a letter is what the equation nearest above gives it.

    None where it is not, where that equation is refuted itself, or is the one that the letter has its
    value from.
    """
    head, value = chain.sides[0].node, chain.sides[k + 1].node
    if not isinstance(head, Name) or names(value) or any(names(s.node) for s in chain.sides[1 : k + 1]):
        return None
    equation = _nearest_equation(state, head, chain)
    known = knowledge.definitions.get(head.name)
    if equation is None or (known is not None and known.line >= equation.lines[0] and not known.numeric):
        return None
    others = (names(equation.sides[0].node) | names(equation.sides[1].node)) - {head.name}
    numbers = {name: _number_above(state, name, chain) for name in sorted(others)}
    given = {name: each for name, each in numbers.items() if each is not None}
    is_formula = equation.sides[0].node == head and given.keys() == numbers.keys()
    if len(given) < (1 if is_formula else FEWEST):
        return None
    rest = {name: each for name, each in knowledge.definitions.items() if name != head.name}
    freer = replace(knowledge, definitions={**rest, **given}, solved={}, solved_from=())
    left, right = (lone_side(substitute(side.node, head.name, value)) for side in equation.sides[:2])
    decision = decide(left, right, chain.relations[k].sign, freer)
    if not decision.is_proved:
        return None
    by_line = f"by line {equation.lines[0]}"
    return replace(decision, assumptions=(*decision.assumptions, by_line))


def by_number_before(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof of a refuted number by the one right before it: 1/S = … ≈ 0.446, so S ≈ 2.24.

    The line before has a number for a formula that fixes the letter, one of x² = 4 does not, and that
    number is not refuted.
    """
    head, value = chain.sides[0].node, chain.sides[k + 1].node
    if k or not isinstance(head, Name) or names(value):
        return None
    above = [c for c in state.sections.in_order if c.end <= chain.start and len(c.sides) > 1]
    last = max(above, key=lambda each: each.start, default=None)
    if last is None or last.lines[-1] != chain.lines[0]:
        return None
    if any(r.sign not in "=≈" for r in (last.relations[-1], chain.relations[0])):
        return None  # from -2x < 6 no x < -3 follows
    left, number = last.sides[0].node, last.sides[-1]
    is_of_it = not isinstance(left, Name) and head.name in names(left) and not names(number.node)
    if not is_of_it or not _has_one_solution(left, head) or number.span[0] in state.refuted:
        return None
    put_in = lone_side(substitute(left, head.name, value))
    decision = decide(put_in, number, chain.relations[k].sign, knowledge)
    if not decision.is_proved:
        return None
    shown = f"{plain_text(left)} = {plain_text(number.node)} before it"
    return replace(decision, assumptions=(*decision.assumptions, shown))


def _has_one_solution(node: Formula, letter: Name) -> bool:
    """Tell whether a formula has each of its values once: 1/S and 2 S, but no power and no sine of S."""
    parts = list(walk(node))
    return parts.count(letter) == 1 and not any(isinstance(p, Power | Call) for p in parts)


def by_nearest_formulas(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the proof of a relation by formulas that its letters have nearer above than their values.

    Below γ_L = γ_R - 60° a page goes on with γ_L = γ_R - 2β: what follows is meant for any β.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    values = {name: d.node for name, d in knowledge.definitions.items()}
    own = {*names(left.node), *names(right.node)}
    behind = sorted(own | {*names_behind(left.node, values), *names_behind(right.node, values)})
    nearer: dict[str, Definition] = {}
    for name in behind:
        formula = _formula_above(state, name, chain)
        known = knowledge.definitions.get(name)
        if formula is not None and known is not None and known.line < formula.line:
            nearer[name] = formula
    if not nearer or (isinstance(left.node, Name) and left.node.name in nearer):
        return None
    free = {n for d in nearer.values() for n in names(d.node)} - nearer.keys()
    rest = {n: d for n, d in knowledge.definitions.items() if n not in free or not d.numeric}
    freer = replace(knowledge, definitions={**rest, **nearer}, solved={}, solved_from=())
    decision = decide(left, right, chain.relations[k].sign, freer)
    if not decision.is_proved:
        return None
    lines = ", ".join(str(line) for line in sorted({d.line for d in nearer.values()}))
    return replace(decision, assumptions=(*decision.assumptions, f"by line {lines}"))


def by_square_above(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a size whose square a line above gives: |S|² = 24.80, then |S| = 4.98."""
    size, value = chain.sides[0].node, chain.sides[k + 1]
    if not isinstance(size, Call) or size.function != "abs" or names(value.node):
        return None
    two = Number(Fraction(2))
    above = [
        c
        for c in state.sections.in_order
        if c.end <= chain.start and state.sections.same_section(c.lines[0], chain.lines[0])
        if isinstance(c.sides[0].node, Power) and c.sides[0].node.base == size
        if c.sides[0].node.exponent == two and len(c.sides) > 1 and not names(c.sides[1].node)
    ]
    last = max(above, key=lambda each: each.start, default=None)
    if last is None or last.sides[1].span[0] in state.refuted:
        return None
    root = Side((Call("sqrt", last.sides[1].node),), chain.sides[0].span)
    decision = decide(root, value, chain.relations[k].sign, knowledge)
    if decision.status not in (PROVED, REFUTED):
        return None
    return replace(decision, assumptions=(*decision.assumptions, f"by line {last.lines[0]}"))


def _formula_above(state: JudgingState, name: str, chain: Chain) -> Definition | None:
    """Return the formula that a letter has last above a relation, in its section; None if refuted."""
    line = chain.lines[0]
    last = state.sections.last_above(Name(name), chain.start)
    if last is None or not state.sections.same_section(last.lines[0], line):
        return None
    right, is_equation = last.sides[1], len(last.relations) == 1 and last.relations[0].sign == "="
    if not is_equation or not names(right.node) or name in names(right.node):
        return None
    return None if right.span[0] in state.refuted else Definition(right.node, last.lines[0])


def _nearest_equation(state: JudgingState, head: Name, chain: Chain) -> Chain | None:
    """Return the last equation above a relation that has its letter among others; None if refuted."""
    line = chain.lines[0]
    for other in reversed(state.sections.in_order):
        if other.start >= chain.start or len(other.relations) != 1 or other.relations[0].sign not in "=≈":
            continue
        if not state.sections.same_section(other.lines[0], line):
            return None
        left, right = (side.node for side in other.sides)
        if not names(right) or not _is_asked_of(head, left) or head.name in names(right):
            continue
        return None if other.sides[1].span[0] in state.refuted else other
    return None


def _is_asked_of(head: Name, left: Formula) -> bool:
    """Tell whether an equation's left side is a letter, or a product in which it stands."""
    return left == head or (not isinstance(left, Name) and head.name in names(left))


def _number_above(state: JudgingState, name: str, chain: Chain) -> Definition | None:
    """Return the number that a letter is given last above a relation, in its section."""
    line = chain.lines[0]
    above = state.sections.chains_above(Name(name), chain.start)
    above = [c for c in above if state.sections.same_section(c.lines[0], line)]
    last = above[-1] if above else None
    if last is None or names(last.sides[-1].node) or last.relations[-1].sign not in "=≈":
        return None
    return Definition(last.sides[-1].node, last.lines[0], numeric=True)
