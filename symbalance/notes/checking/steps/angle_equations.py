"""Equations for an angle that are solved right behind: tan A = n = 4, that is at A = 76°.

An angle that had a value before, A = 0 at the dead centre, is asked for anew there: the equation is a
condition, whatever stands above, and the value behind it is its solution or refuted. What a letter is at
such an angle may have a formula of its own, v = w r sqrt(1 + 1/n²), beside the series that it has in
general: that one is only as near as its ≈, and the angle only as near as it is printed.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Sum,
    names,
)
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.letters_in_waves import WAVES
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute, with_every
from symbalance.notes.checking.page.solutions import chains_below
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.open_cases import lines_of_cases, without_cases
from symbalance.notes.checking.verdicts import CONDITION, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

NEAR = 0.02
"""Relative difference that a series cut off, and an angle printed in whole degrees, may explain."""
LONGEST = 80
"""Characters between an equation and its result."""
DEGREE = Fraction(1, 60)
"""About a degree, as near as an angle in whole degrees is to what it is printed for."""
HALF_DEGREE = Fraction(1, 112)
"""What an angle in whole degrees may be off by, and a little more."""
_RESULT = re.compile(
    r"(?<![A-Za-z])(?:that\s+is|i\.\s?e\.|so|hence|thus|therefore|gives?|giving|or|about|das\s+ist|d\.\s?h\.|also"
    r"|das\s+heißt|somit|ergibt|daraus|d'où|donc|soit|c'est[\s-]à[\s-]dire|ainsi|cioè|ossia|ovvero|quindi|dunque|perciò|da\s+cui"
    r"|es\s+decir|o\s+sea|por\s+(?:lo\s+)?tanto|entonces|de\s+donde|isto\s+é|ou\s+seja|portanto|dus|dat\s+is)(?![A-Za-z])|[⇒⟹→]|\\(?:Rightarrow|implies|Longrightarrow|to)(?![A-Za-z])"
    r"|よって|すなわち|つまり|ゆえに"
)

_LISTED = re.compile(
    r"(?:[\s$,;)\]}]|\\[,;: ]|\\q?quad(?![a-z]))*(?:(?:and|und|et|y|e)(?![A-Za-z]))?[\s$(\[]*",
    re.IGNORECASE,
)
"""Between an equation that was worked out, cos θ = λ/2 = 0.125, and its angle: a comma, or "and"."""


def lines_of_angles(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> tuple[frozenset[int], frozenset[str]]:
    """Return the lines above that put in the angles a relation turns with, and these letters."""
    values = {name: definition.node for name, definition in knowledge.definitions.items()}
    sides = (chain.sides[k].node, chain.sides[k + 1].node)
    own = {n for node in sides for n in names_behind(node, values)} & state.turned
    return lines_of_cases(state.definitions, chain.lines[0], frozenset(own)), frozenset(own)


def as_equation_for_angle(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a relation is an equation for an angle whose value stands right behind."""
    name = _letter_asked_for(chain, k)
    if not name or name in knowledge.meaning.values:
        return None
    following = _value_behind(state, chain, name)
    if following is None:
        return None
    value, line = following.sides[1].node, chain.lines[0]
    results = (side.node for side in chain.sides[1:] if not names(side.node))
    condition = Premise(chain.sides[0].node, next(results, chain.sides[1].node), line)
    cases = lines_of_cases(state.definitions, line + 1, frozenset({name}))
    with without_cases(state.definitions, cases, frozenset({name})):
        free = state.knowledge(line)
        is_solution = _solves_nearly(condition, name, value, free)
        is_printed = (
            solves_as_printed(condition, name, value, free)
            if decimals(value)
            else _solves_nearly(condition, name, value, free, HALF_DEGREE)
        )
    text, start = f"{condition.text} of line {line}", following.sides[0].span[0]
    if not is_solution:
        state.wrong_angles[start] = Decision(REFUTED, f"does not satisfy {text}")
    elif name in knowledge.definitions and is_printed is not None:
        near = Decision(UNDECIDED, f"near a solution of {text}, but none to the digits printed")
        state.solved_angles[start] = Decision(CONDITION, f"solves {text}") if is_printed else near
    return Decision(CONDITION, f"solved for {plain_text(Name(name))} behind it")


def as_angle_solved(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that an angle's value solves the equation right before it, whatever it was further up."""
    head, start = chain.sides[0].node, chain.sides[0].span[0]
    decision = None if k else state.solved_angles.get(start)
    if decision is not None and decision.status == CONDITION and isinstance(head, Name):
        state.definitions.define(head.name, chain.sides[1].node, chain)
    return decision


def unless_solved_for_wave(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what is no identity may be an equation for a sine that is its result behind it.

    4 λ cos θ + 1 = 0 gives cos θ = -1/(4λ). With that put in it is to be true.
    """
    following = next(chains_below(state.sections, chain), None)
    is_open = verdict.verdict == REFUTED and not k and len(chain.relations) == 1
    if not is_open or following is None or not following.relations:
        return verdict
    wave, value = following.sides[0].node, following.sides[1].node
    between = state.document.text[chain.end : following.start]
    is_result = _RESULT.search(SENTENCE_END.split(between)[-1]) is not None and len(between) < LONGEST
    own = chain.sides[0].node, chain.sides[1].node
    is_wave = isinstance(wave, Call) and wave.function in WAVES and isinstance(wave.argument, Name)
    if not is_wave or not is_result or wave in own or names(wave) & names(value):
        return verdict
    sides = [Side((with_every(node, wave, value),), (0, 0)) for node in own]
    if any(names(side.node) & names(wave) for side in sides):
        return verdict  # of another wave as well
    if decide(sides[0], sides[1], "=", state.knowledge(chain.lines[0])).status == REFUTED:
        text = Premise(*own, chain.lines[0]).text
        wrong = Decision(REFUTED, f"does not satisfy {text} of line {chain.lines[0]}")
        state.wrong_angles[following.start] = wrong
    reason = f"solved for {plain_text(wave)} behind it"
    return describe(state.document, chain, k, Decision(CONDITION, reason))


def _solves_nearly(
    condition: Premise, name: str, value: Formula, knowledge: Knowledge, near: Fraction = DEGREE
) -> bool:
    """Tell whether an equation has a solution near an angle, to a degree, or nothing is known of it."""
    known = {n: d.node for n, d in knowledge.definitions.items() if n != name}
    meaning = replace(knowledge.meaning, values={**knowledge.meaning.values, **known})
    gap, signs = Sum((condition.left, Negative(condition.right))), set[bool]()
    for step in (-near, near):
        moved = substitute(gap, name, Sum((value, rational_node(step))))
        if letters_behind(moved, meaning.values) or not (points := sample_trees([moved], meaning, 1)):
            return True
        signs.add(bool(points[0][1][0].real > 0))
    return len(signs) == 2


def _letter_asked_for(chain: Chain, k: int) -> str:
    """Return A of tan A = n, of sin 2A = 1/3: the letter of an angle, which stands nowhere else."""
    left = chain.sides[0].node
    if k or chain.relations[0].sign != "=" or not isinstance(left, Call) or left.function not in WAVES:
        return ""
    argument: Formula = left.argument
    if isinstance(argument, Product) and len(argument.factors) == 2:
        first, second = argument.factors
        argument = second if isinstance(first, Number) else argument
    if not isinstance(argument, Name) or any(argument.name in names(s.node) for s in chain.sides[1:]):
        return ""
    return argument.name


def _value_behind(state: JudgingState, chain: Chain, name: str) -> Chain | None:
    """Return the chain that gives an angle its value right behind an equation, said to be its result."""
    following = next(chains_below(state.sections, chain), None)
    if following is None or following.relations[0].sign not in "=≈":
        return None
    head, end = following.sides[0].node, chain.end
    between = state.document.text[end : following.sides[0].span[0]]
    own_sentence = SENTENCE_END.split(between)[-1]
    is_result = _RESULT.search(own_sentence) is not None and not re.search(r"\n\s*\n", between)
    line, ends_in_number = chain.lines[0], not names(chain.sides[-1].node)
    is_free = not any(name in p.names for p in state.definitions.premises_at(line))
    if is_free and ends_in_number and names(chain.sides[1].node):
        is_result = is_result or _LISTED.fullmatch(between) is not None
    is_value = isinstance(head, Name) and head.name == name and not names(following.sides[1].node)
    return following if is_value and is_result and len(between) < LONGEST else None


def at_rough_angle(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on another formula of a letter at an angle where it is known nearly only.

    v ≈ w r (sin A + …), and at A = 76° it is v = w r sqrt(1 + 1/n²): they agree as nearly as the series
    is true and the angle printed, which neither proves nor refutes the formula.
    """
    head = chain.sides[0].node
    definition = knowledge.definitions.get(head.name) if isinstance(head, Name) and not k else None
    if definition is None or not definition.is_rough or not names(definition.node):
        return decision
    cases, _ = lines_of_angles(state, chain, k, knowledge)
    if not cases:
        return decision
    first, second = (number_of(side.node, knowledge) for side in chain.sides[:2])
    if first is None or second is None or abs(first - second) > NEAR * max(abs(first), abs(second)):
        return decision
    line = definition.line
    reason = f"agrees with line {line} as nearly as that is true at the angle of line {max(cases)}"
    return Decision(UNDECIDED, reason)
