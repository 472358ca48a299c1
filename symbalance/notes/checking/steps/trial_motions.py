"""What a page says of amplitudes and natural frequencies, by its equations of motion and trial motions.

A later problem often leaves the trial out: with φ₁ = A₁ cos ω t above, the third disc of the next one
moves by A₃ cos ω t. A letter that is set equal to others makes a case of its own in its section.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    names,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.motions.chains_of_discs import chain_of_discs, is_ratio_of_mode
from symbalance.notes.checking.motions.equations_of_motion import EquationOfMotion, is_combination
from symbalance.notes.checking.motions.special_systems import equalities_in
from symbalance.notes.checking.motions.trial_solutions import (
    FreeVibration,
    Trial,
    decide_by_trial,
    free_vibration,
    trial_of,
)
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, PREMISE, UNDECIDED
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SUM_OF_ALL = re.compile(
    r"\b(?:add(?:ing|ed|ition)?|sum(?:ming|med)?|addier\w*|addition|summe|summier\w*|addition\w*|sommand\w*"
    r"|sumand\w*|sommon\w*|optell\w*|adder\w*|dodaj\w*|sečten\w*)\b|足し|加え|和を|сложи\w*",
    re.IGNORECASE,
)
_ANY_DISC = ("i", "j", "k", "n", "nu", "r")
_ZERO = Number(Fraction(0))
_DISCS = re.compile(
    r"torsion|\bdis[ck]s?\b|rotor|shaft|drehschwing|scheibe|schwungmasse|welle|ねじり|円板|disque|arbre|disco|albero",
    re.IGNORECASE,
)
_HELD = re.compile(
    r"\b(?:fixed|clamped|grounded|built[- ]in|held|eingespannt|encastr\w*|"
    r"branch\w*|gear\w*|getriebe\w*)\b|固定|歯車",
    re.IGNORECASE,
)
"""Words for a chain that is not free at its ends, or no chain."""
_NEAR_WORDS = 1500
IN_STEP = "what moves does so in step, in a natural mode"
_OF_FREE = re.compile(
    r"free\s+(?:vibration|oscillation|motion)|natural|\bmodes?\b|eigen|freie\w*\s+schwing|in step"
    r"|固有|自由振動|libre|libera",
    re.IGNORECASE,
)
"""Words for the motion in which all letters move in step."""
_INDEX = re.compile(r"[A-Za-z0-9]+$")


def decide_trial_motion(
    state: JudgingState, chain: Chain, k: int, equations: Sequence[EquationOfMotion], knowledge: Knowledge
) -> Decision | None:
    """Return the decision on amplitudes and frequencies of a motion that is put into equations above."""
    if _is_special_case(state, chain, knowledge):
        return Decision(PREMISE, "a special case of the equations of motion")
    line = chain.lines[0]
    if (by_chain := _decide_by_chain_of_discs(state, chain, k, knowledge)) is not None:
        return by_chain
    if not equations and not state.trials:
        return None
    above = [
        each
        for each in state.document.chains
        if each.start < chain.start and state.sections.same_section(each.lines[0], line)
    ]
    decision = _decide_by_system(state, chain, k, equations, above, knowledge)
    if (
        decision is None
        and state.trials
        and _is_root_elsewhere(chain, k, above, state.trials[-1].frequency)
    ):
        return Decision(CONDITION, "a natural frequency of another system's special case")
    return decision


def _decide_ratio_in_numbers(
    chain: Chain, k: int, vibration: FreeVibration, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a ratio of two amplitudes as a number, A_2/A_1 = 0.267; None for others."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    number = right.operand if isinstance(right, Negative) else right
    if not isinstance(left, Quotient) or not isinstance(number, Number) or number.last_place is None:
        return None
    above, below = left.numerator, left.denominator
    if not isinstance(above, Name) or not isinstance(below, Name):
        return None
    pair = above.name, below.name
    if not {*pair} <= {*vibration.amplitudes} or above == below:
        return None
    value = Number(-number.value if number is not right else number.value, number.last_place)
    is_mode = is_ratio_of_mode(pair, value, vibration, knowledge)
    if is_mode is None:
        return None
    if is_mode:
        return Decision(PROVED, "the ratio in a natural mode", order="the digits printed")
    return Decision(
        UNDECIDED, "it is the ratio in no natural mode: another case is meant, or it is wrong"
    )


def _decide_by_chain_of_discs(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision by discs in a row whose equations of motion only words mention; else None.

    The trial motion of any disc stands above: φ_i = A_i cos ωt.
    """
    text, line = state.document.text, chain.lines[0]
    if not _speaks_of_discs(text):
        return None
    for above in reversed(state.document.chains):
        head = above.sides[0].node
        stem, _, index = head.name.rpartition("_") if isinstance(head, Name) else ("", "", "")
        if index not in _ANY_DISC or not stem or not above.relations or above.start >= chain.start:
            continue
        if not state.sections.same_section(above.lines[0], line):
            continue
        moving = EquationOfMotion({(f"{stem}_{index}", 2): Name("J")}, _ZERO, line, "")
        trial = trial_of(above, 0, [moving])
        if trial is None or not trial.amplitude.endswith(f"_{index}"):
            continue
        where = text[: chain.start].rpartition("\n#")[2]
        if _HELD.search(where[-_NEAR_WORDS:]):
            return None
        amplitude = trial.amplitude[: -len(index)]
        vibration = chain_of_discs(state.letters, amplitude, trial.frequency, trial.wave, above.lines[0])
        ratio = None if vibration is None else _decide_ratio_in_numbers(chain, k, vibration, knowledge)
        decision = None if vibration is None else ratio or decide_by_trial(chain, k, vibration, ())
        if vibration is None or decision is None:
            return None
        count = len(vibration.trials)
        row = f"the system is {count} discs in a row with {count - 1} shafts between them"
        if decision.is_proved:
            return replace(decision, reason="", assumptions=(*decision.assumptions, row))
        return replace(decision, reason=f"if {row}: {decision.reason}")
    return None


@lru_cache(maxsize=4)
def _speaks_of_discs(text: str) -> bool:
    """Tell whether a page speaks of discs on a shaft, which is asked at each of its relations."""
    return _DISCS.search(text) is not None


def _decide_by_system(
    state: JudgingState,
    chain: Chain,
    k: int,
    equations: Sequence[EquationOfMotion],
    above: Sequence[Chain],
    knowledge: Knowledge,
) -> Decision | None:
    """Return the decision by the free vibration whose equations stand above; None where none does."""
    if not equations:
        return None
    if (trial := trial_of(chain, k, equations)) is not None:
        state.trials.append(trial)
        return None
    line = chain.lines[0]
    trials = [each for each in state.trials if state.sections.same_section(each.line, line)]
    is_stated = equations[-1].moving <= {trial.moving for trial in trials}
    vibration = free_vibration(equations, trials) if is_stated else None
    vibration = vibration or free_vibration(equations, _by_analogy(equations, state.trials, knowledge))
    if vibration is None:
        return None
    equal = equalities_in(above, vibration.letters)
    in_step = _in_amplitudes(chain, vibration)
    decision = decide_by_trial(in_step, k, vibration, equal)
    if in_step is not chain and decision is not None:
        is_free = _OF_FREE.search(state.sections.sentence_leading_to(chain)) is not None
        return replace(decision, assumptions=(*decision.assumptions, IN_STEP)) if is_free else None
    if decision is not None and decision.is_proved and not k:
        _define_frequency(state, chain, vibration.frequency.name)
    return decision


def _in_amplitudes(chain: Chain, vibration: FreeVibration) -> Chain:
    """Return a chain in letters that move, J_1 φ_1 + J_2 φ_2 = 0, with amplitudes in their places.

    In a natural mode all of them move in step, so that what is said of the one is so of the other.
    """
    moving = {trial.moving: Name(trial.amplitude) for trial in vibration.trials}
    own = {name for side in chain.sides for name in names(side.node)}
    if not own & moving.keys() or own & {*vibration.amplitudes}:
        return chain

    def renamed(node: Formula) -> Formula:
        for name, amplitude in moving.items():
            node = substitute(node, name, amplitude)
        return node

    try:
        return replace(chain, sides=tuple(side.changed(renamed) for side in chain.sides))
    except NoFormError:  # a derivative
        return chain


def without_trials(state: JudgingState, knowledge: Knowledge) -> Knowledge:
    """Return what is known without the trial motions: their letters move in the equations to come."""
    lines = {trial.moving: trial.line for trial in state.trials}
    others = {name: each for name, each in knowledge.definitions.items() if lines.get(name) != each.line}
    return (
        replace(knowledge, definitions=others) if len(others) < len(knowledge.definitions) else knowledge
    )


def decide_sum_of_equations(
    state: JudgingState, chain: Chain, equation: EquationOfMotion, above: Sequence[EquationOfMotion]
) -> Decision | None:
    """Return whether an equation of motion is a sum or difference of some above; None for a new one."""
    here = [each for each in above if state.sections.same_section(each.line, chain.lines[0])]
    lines = is_combination(equation, here)
    if lines:
        return Decision(PROVED, f"by lines {', '.join(map(str, lines[:-1]))} and {lines[-1]}")
    moving = frozenset[str]().union(*(each.moving for each in here))
    if len(here) > 1 and equation.moving <= moving and _says_sum(state, chain):
        return Decision(REFUTED, f"no sum of the equations of lines {here[0].line} to {here[-1].line}")
    return None


def _says_sum(state: JudgingState, chain: Chain) -> bool:
    return _SUM_OF_ALL.search(state.sections.sentence_leading_to(chain)) is not None


def _by_analogy(
    equations: Sequence[EquationOfMotion], trials: Sequence[Trial], knowledge: Knowledge
) -> list[Trial]:
    """Return trial motions of all letters that move, like those that the page has elsewhere.

    Without any the letter ω is that of the frequency, where nothing is known of it; the amplitudes have
    no letters then.
    """
    moving = sorted(frozenset[str]().union(*(each.moving for each in equations)))
    line = equations[-1].line
    if not trials:
        frequency = "omega"
        if knowledge.knows(frequency):
            return []
        wave: Formula = Call("cos", Product((Name(frequency), Name("t"))))
        return [Trial(name, f"amplitude of {name}", frequency, wave, line) for name in moving]
    own = {trial.moving: trial for trial in trials}
    last = trials[-1]
    return [Trial(name, _amplitude(name, own, last), last.frequency, last.wave, line) for name in moving]


def _amplitude(name: str, own: dict[str, Trial], last: Trial) -> str:
    """Return the letter of an amplitude: A_3 of φ_3 where A_1 is that of φ_1."""
    if name in own:
        return own[name].amplitude
    base, _, index = name.rpartition("_") if "_" in name else (name[:1], "", name[1:])
    other = last.moving.rpartition("_")[2] if "_" in last.moving else last.moving[1:]
    match = _INDEX.search(last.amplitude)
    if index and other and last.moving.startswith(base) and match and last.amplitude.endswith(other):
        return last.amplitude[: len(last.amplitude) - len(other)] + index
    return f"amplitude of {name}"


def _define_frequency(state: JudgingState, chain: Chain, general: str) -> None:
    """Let what follows put numbers into a formula of one natural frequency: ω₁² = k/J.

    The letter of the trial motions itself stands for any of them.
    """
    head, value = chain.sides[0].node, chain.sides[1].node
    if isinstance(head, Name) and head.name != general:
        state.definitions.define(head.name, value, chain)
    elif isinstance(head, Power) and isinstance(head.base, Name) and head.base.name != general:
        state.definitions.define(head.base.name, Call("sqrt", value), chain)


def _is_root_elsewhere(chain: Chain, k: int, above: Sequence[Chain], general: str) -> bool:
    """Tell whether p² is written in the letters of a special case of more discs: I₁ = I₂ = I₃ = I."""
    head, value = chain.sides[0].node, chain.sides[1].node
    base = head.base if isinstance(head, Power) else head
    if k or base != Name(general):
        return False
    ends = {
        each.sides[-1].node.name
        for each in above
        if len(each.sides) > 2
        and all(isinstance(side.node, Name) for side in each.sides)
        and isinstance(each.sides[-1].node, Name)
    }
    return bool(names(value) & ends)


def _is_special_case(state: JudgingState, chain: Chain, knowledge: Knowledge) -> bool:
    """Tell whether a chain sets letters of equations of motion equal to each other: J₁ = J₂ = J."""
    if not state.equations_of_motion or len(chain.sides) < 3:
        return False
    sides = [side.node for side in chain.sides]
    if any(relation.sign != "=" for relation in chain.relations):
        return False
    own = {side.name for side in sides if isinstance(side, Name)}
    last = sides[-1]
    is_named_anew = isinstance(last, Name) and not knowledge.knows(last.name)
    if len(own) < len(sides) or (not is_named_anew and any(_has_number(name, knowledge) for name in own)):
        return False
    return any(own & equation.letters for equation in state.equations_of_motion)


def _has_number(name: str, knowledge: Knowledge) -> bool:
    definition = knowledge.definitions.get(name)
    return definition is not None and definition.numeric
