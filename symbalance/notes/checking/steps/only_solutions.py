"""Solutions that words call the only one, and that are not: x² = 4, and "x = 2 is the only solution"."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise

from symbalance.document.formula import Call, Formula, Name, Negative, Sum, names, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.tree_values import TreeValues
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.implications import solution_lost
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, PROVED_WORDS, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SOLUTION = (
    r"(?:(?:real|possible|reelle|mögliche|réelle|possible|reale|posible)\s+)?"
    r"(?:solution|root|zero|lösung|nullstelle|wurzel|racine|soluzione|radice|solución|raíz)(?![^\W\d_])"
)
_ONLY = r"(?:only|sole|unique|single|einzige|eindeutige|seule|unique|unica|sola|única)"
_BEHIND = re.compile(
    rf"[\s$)\]]*(?:is|are|ist|est|è|es)\s+(?:the|an?|die|eine|la|l['’])\s*{_ONLY}\s+{_SOLUTION}"
    r"|[\s$)\]]*(?:が|は)(?:唯一|ただ一つ)の解",
    re.IGNORECASE,
)
_BEFORE = re.compile(
    rf"(?:the|its|die|la|l['’])\s*{_ONLY}\s+{_SOLUTION}[^.;!?$=]{{0,20}}[\s$(\\]*$|唯一の解は[\s$]*$",
    re.IGNORECASE,
)
_REACH = 80
_STEPS, _FAR, _ASIDE, _HALVINGS = 8, 80, Fraction(3, 7), 40
"""Steps in the root given, steps to either side, where the first one lies, and halvings of one."""


def unless_not_the_only(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where words call a solution the only one, and another one turns up."""
    head, text = chain.sides[0].node, state.document.text
    if k or not isinstance(head, Name) or names(chain.sides[1].node) or len(chain.relations) != 1:
        return verdict
    if verdict.verdict not in (*PROVED_WORDS, CONDITION):
        return verdict
    before = text[max(0, chain.start - _REACH) : chain.start]
    if _BEHIND.match(text, chain.end) is None and _BEFORE.search(before) is None:
        return verdict
    equation, knowledge = _equation_before(state, chain), state.knowledge(chain.lines[0])
    if equation is None or any(isinstance(part, Call) for s in equation.sides for part in walk(s.node)):
        return verdict  # of an angle it may be the only one of half a turn
    first = equation.sides[0].node, equation.sides[1].node
    point = solution_lost(first, (head, chain.sides[1].node), knowledge)
    shown = ", ".join(
        f"{plain_text(Name(n))} = {plain_text(value)}" for n, value in (point or {}).items()
    )
    shown = shown or _another_root(head.name, first, chain.sides[1].node, knowledge)
    if not shown:
        return verdict
    reason = f"not the only one: {shown} satisfies line {equation.lines[0]} too"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _another_root(
    name: str, equation: tuple[Formula, Formula], value: Formula, knowledge: Knowledge
) -> str:
    """Return another root of an equation near the one given, found by its sign; "" for none.

    Where ranges or its meaning say where the letter lies, those may be why it is the only one.
    """
    number = number_of(value, knowledge)
    is_bound = name in knowledge.meaning.positive or any(
        name in names(r.left) | names(r.right) for r in knowledge.ranges
    )
    if number is None or is_bound or (names(equation[0]) | names(equation[1])) != {name}:
        return ""
    own = Fraction(str(float(number)))
    difference = Sum((equation[0], Negative(equation[1])))

    def at(place: Fraction) -> float:
        return float(TreeValues(knowledge.meaning, {name: place}).value(difference).real)

    step = abs(own) / _STEPS or Fraction(1, _STEPS)
    places = [own + step * (k + _ASIDE) for k in range(-_FAR, _FAR)]
    for low, high in pairwise(places):
        if not low <= own <= high and (root := _root_between(at, low, high)) is not None:
            return f"{plain_text(Name(name))} ≈ {root:.6g}"
    return ""


def _root_between(at: Callable[[Fraction], float], low: Fraction, high: Fraction) -> float | None:
    """Return where a function of one letter changes its sign between two places, None for a pole."""
    try:
        first, second = at(low), at(high)
        size, middle, between = min(abs(first), abs(second)), low, first
        if first * second >= 0:
            return None
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            between = at(middle)
            low, high = (middle, high) if between * first > 0 else (low, middle)
    except (NoFormError, ArithmeticError):
        return None
    return float(middle) if abs(between) < size / 1000 else None


def _equation_before(state: JudgingState, chain: Chain) -> Chain | None:
    """Return the last equation for a letter in its section that gives it no value, None for none."""
    head, line = chain.sides[0].node, chain.lines[0]
    for other in reversed(state.document.chains):
        is_before = other.end <= chain.start and state.sections.same_section(other.lines[0], line)
        is_equation = len(other.relations) == 1 and other.relations[0].sign == "="
        if is_before and is_equation and other.letters == chain.letters and other.sides[0].node != head:
            return other
    return None
