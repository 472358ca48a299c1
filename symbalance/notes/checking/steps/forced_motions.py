r"""Motions and amplitudes below an equation of motion with a periodic force: m ẍ + k x = F cos Ωt.

x = F cos Ωt/(k - m Ω²)         put into the equation, it satisfies it or is wrong
x = X cos Ωt                    a trial, with an amplitude to be found
X = F/(k - m Ω²)                the one that satisfies it
(k - m Ω²) X = F                the same before it is solved
X = F/√((k - m Ω²)² + d² Ω²)    with damping, where the trial has a phase
tan ε = d Ω/(k - m Ω²)          the phase of X cos(Ωt - ε)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
    parts_of_kind,
)
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import letters_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.substitution import substitute, with_every
from symbalance.notes.checking.motions.equations_of_motion import EquationOfMotion
from symbalance.notes.checking.motions.trial_solutions import Trial, trial_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.roots_of_conditions import is_said_apart
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ZERO, _ONE, _TWO = (Number(Fraction(n)) for n in (0, 1, 2))
_TIME = Name("t")
_WAVES = ("sin", "cos")
_FARTHEST = 500
"""Characters between an equation of motion and what it leads to."""
_OF_FORCE = re.compile(r"p|P|part|partic\w*|st|stat|S|s|f|F|e|erzw|E|inh")
"""Subscripts of the part of a motion that the force makes."""
_OTHER_MOTION = re.compile(
    r"(?<![^\W\d_])(?:resonan\w*|free|homogen\w*|complementary|transient|initial\w*|natural|undamped|frei\w*|anfangs\w*"
    r"|ungedämpft\w*|libre\w*|liber\w*|omogene\w*|transitoire|initiale\w*|sans|quasi\w*|static\w*|statisch\w*"
    r"|residual|rest|error|fehler|try|tried|guess\w*|ansatz|versuch\w*)(?![^\W\d_])|共振|自由|斉次|仮定",
    re.IGNORECASE,
)
"""Words of a motion that is not the one which the whole equation has."""


@dataclass(frozen=True, slots=True)
class _Force:
    """A force of one wave on one side of an equation of motion, and what stands for the other side."""

    amplitude: Formula
    wave: Call
    frequency: str
    in_phase: Formula
    """k - m Ω²: the factor of the amplitude."""
    damping: Formula
    """d Ω: the factor of the amplitude a quarter of a turn ahead."""


def unless_no_forced_motion(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a motion or amplitude below an equation with a force has to satisfy that."""
    if verdict.verdict in (REFUTED, CONTRADICTION, *PROVED_WORDS) or chain.relations[k].sign != "=":
        return verdict
    found = _equation_above(state, chain)
    if k or found is None:
        return verdict
    equation, leading = found
    if is_said_apart(leading) or _OTHER_MOTION.search(leading):
        trials = _OTHER_MOTION.sub(" ", leading) if _trial(state, chain, equation) else ""
        if not trials or is_said_apart(trials):
            return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    definitions = {**knowledge.definitions, **_natural_frequencies(state, chain, equation)}
    knowledge = replace(knowledge, definitions=definitions)
    decision = _as_motion(chain, equation, knowledge)
    decision = decision or _as_amplitude(state, chain, equation, knowledge)
    if decision is None:
        return verdict
    if decision.status == REFUTED and isinstance(head := chain.sides[0].node, Name):
        state.definitions.forget(head.name, chain.lines[0])
    return describe(state.document, chain, k, decision)


def _equation_above(state: JudgingState, chain: Chain) -> tuple[EquationOfMotion, str] | None:
    """Return the one equation with a force above a relation in its section, and the words between."""
    here = [e for e in state.equations_of_motion if state.sections.same_section(e.line, chain.lines[0])]
    if not here or len(here[-1].moving) != 1 or _TIME.name not in names(here[-1].rest):
        return None
    equation, text = here[-1], state.document.text
    of_line = [c for c in state.document.chains if equation.line in c.lines and c.end <= chain.start]
    places = [c for c in of_line if any(True for s in c.sides for _ in parts_of_kind(s.node, Derivative))]
    if not places or chain.start - places[0].end > _FARTHEST:
        return None
    inner = [c for c in state.document.chains if places[0].end <= c.start and c.end <= chain.start]
    words, place = "", places[0].end
    for each in sorted(inner, key=lambda c: c.start):
        words, place = f"{words} {text[place : each.start]}", max(place, each.end)
    return equation, f"{words} {text[place : chain.start]}"


def _natural_frequencies(
    state: JudgingState, chain: Chain, equation: EquationOfMotion
) -> dict[str, Definition]:
    """Return the letters whose square the section has as that of the natural frequency: ω_0² = k/m."""
    (moving,) = equation.moving
    stiffness, mass = (equation.factors.get((moving, order)) for order in (0, 2))
    if stiffness is None or mass is None:
        return {}
    own = equation.letters | names(equation.rest)
    found: dict[str, Definition] = {}
    for other in state.document.chains:
        head = other.sides[0].node
        if not isinstance(head, Power) or not isinstance(head.base, Name) or not other.relations:
            continue
        if head.exponent != _TWO or head.base.name in own:
            continue
        value = other.sides[1].node
        pair = Product((mass, value)), stiffness
        is_near = state.sections.same_section(other.lines[0], chain.lines[0])
        if is_near and names(value) <= own and decide_equality(*pair, Knowledge()).is_proved:
            found[head.base.name] = Definition(Call("sqrt", value), other.lines[0])
    return found


def _as_motion(chain: Chain, equation: EquationOfMotion, knowledge: Knowledge) -> Decision | None:
    """Return whether a motion in the equation's letters satisfies it; None for others.

    Letters that the equation lacks may stand where they cancel, as those of the free vibration do.
    """
    head, value = chain.sides[0].node, chain.sides[1].node
    (moving,) = equation.moving
    if not isinstance(head, Name) or not _is_of_force(head.name, moving) or moving in names(value):
        return None
    if not _turned(value):
        return None
    definitions = {**knowledge.definitions, moving: Definition(value, chain.lines[0])}
    decision = decide_equality(_left_side(equation), _ZERO, replace(knowledge, definitions=definitions))
    where = f"{equation.text} of line {equation.line}"
    if decision.is_proved:
        return Decision(PROVED, f"solves {where}", assumptions=decision.assumptions)
    if decision.status != REFUTED:
        return None
    free = {n for form in (decision.left, decision.right) if form is not None for n in letters(form)}
    own = equation.letters | names(equation.rest) | {_TIME.name}
    return replace(decision, reason=f"does not satisfy {where}") if free <= own else None


def _is_of_force(name: str, moving: str) -> bool:
    """Tell whether a letter is the one that moves, or its part that the force makes: x_p of x."""
    stem, _, index = name.rpartition("_")
    return name == moving or (stem == moving and _OF_FORCE.fullmatch(index) is not None)


def _turned(node: Formula) -> set[Call]:
    """Return the sines and cosines of the time in a formula."""
    calls = parts_of_kind(node, Call)
    return {c for c in calls if c.function in _WAVES and _TIME.name in names(c.argument)}


def _left_side(equation: EquationOfMotion) -> Formula:
    terms = (
        Product((factor, Derivative(Name(name), _TIME, order) if order else Name(name)))
        for (name, order), factor in equation.factors.items()
    )
    return Sum((*terms, equation.rest))


def _trials(
    state: JudgingState, chain: Chain, equation: EquationOfMotion
) -> Iterator[tuple[Chain, Trial]]:
    """Yield the trial motions of an equation between it and a relation: x = X cos Ωt, x_p = X cos Ωt."""
    (moving,) = equation.moving
    for other in state.document.chains:
        head = other.sides[0].node
        if not equation.line <= other.lines[0] or other.end > chain.start or not other.relations:
            continue
        if isinstance(head, Name) and _is_of_force(head.name, moving):
            sides = (replace(other.sides[0], readings=(Name(moving),)), *other.sides[1:])
            trial = trial_of(replace(other, sides=sides), 0, [equation])
            if trial is not None:
                yield other, trial


def _trial(state: JudgingState, chain: Chain, equation: EquationOfMotion) -> Trial | None:
    """Return the last trial motion above a relation whose amplitude stands in it, None for none."""
    own = {n for side in chain.sides[:2] for n in names(side.node)}
    found = [t for _, t in _trials(state, chain, equation) if {t.amplitude, *_phases(t.wave)} & own]
    return found[-1] if found else None


def _phases(wave: Formula) -> list[str]:
    """Return the letter of a wave's phase: ε of cos(Ωt - ε)."""
    argument = wave.argument if isinstance(wave, Call) else _ZERO
    terms = argument.terms if isinstance(argument, Sum) else ()
    return [n for term in terms if _TIME.name not in names(term) for n in sorted(names(term))]


def _as_amplitude(
    state: JudgingState, chain: Chain, equation: EquationOfMotion, knowledge: Knowledge
) -> Decision | None:
    """Return whether what a relation says of a trial's amplitude or phase satisfies the equation."""
    trial, force = _trial(state, chain, equation), _force(equation)
    if trial is None or force is None or trial.frequency != force.frequency:
        return None
    left, right = chain.sides[0].node, chain.sides[1].node
    formulas = {n: d for n, d in knowledge.definitions.items() if not d.numeric and not d.solved}
    hidden = {trial.amplitude, *_phases(trial.wave), *equation.moving}
    formulas = {n: d for n, d in formulas.items() if n not in hidden}
    known = replace(knowledge, definitions=formulas)
    own = equation.letters | names(equation.rest)
    used = {
        n
        for node in (left, right)
        for n in letters_behind(node, {n: d.node for n, d in formulas.items()})
    }
    try:
        pair = _sides_to_compare(left, right, trial, force)
        if pair is None or not used <= own | {trial.amplitude, *_phases(trial.wave)} - {_TIME.name}:
            return None
        decision = decide_equality(*pair, known)
    except (NoFormError, TooLargeError):
        return None
    where = f"{equation.text} of line {equation.line} with the motion of line {trial.line}"
    if decision.is_proved:
        return Decision(PROVED, f"by {where}", assumptions=decision.assumptions)
    return replace(decision, reason=f"does not satisfy {where}") if decision.status == REFUTED else None


def _sides_to_compare(
    left: Formula, right: Formula, trial: Trial, force: _Force
) -> tuple[Formula, Formula] | None:
    """Return two formulas that are equal if a relation is true of a trial's amplitude or its phase."""
    (phase,) = _phases(trial.wave) or ("",)
    if phase and isinstance(left, Call) and left.function == "tan" and left.argument == Name(phase):
        if not isinstance(trial.wave, Call) or trial.wave.function != force.wave.function:
            return None
        lag = trial.wave.argument
        is_lag = isinstance(lag, Sum) and Negative(Name(phase)) in lag.terms
        damping = force.damping if is_lag else Negative(force.damping)
        return Product((right, force.in_phase)), damping
    amplitude = Name(trial.amplitude)
    is_in_phase = (
        not phase and isinstance(trial.wave, Call) and trial.wave.function == force.wave.function
    )
    has_damping = not decide_equality(force.damping, _ZERO, Knowledge()).is_proved
    if is_in_phase and has_damping:
        return None
    is_alone = left == amplitude and amplitude.name not in names(right)
    has_root = any(c.function in ("abs", "sqrt") for c in parts_of_kind(right, Call))
    if is_alone and (phase or has_root):
        whole = Sum((Power(force.in_phase, _TWO), Power(force.damping, _TWO)))
        return Product((Power(right, _TWO), whole)), Power(force.amplitude, _TWO)
    if not is_in_phase:
        return None
    value = Quotient(force.amplitude, force.in_phase)
    return substitute(left, amplitude.name, value), substitute(right, amplitude.name, value)


def _force(equation: EquationOfMotion) -> _Force | None:
    """Return the force of an equation of motion if it is one wave of the time, F cos Ωt; else None."""
    waves = _turned(equation.rest)
    if len(waves) != 1:
        return None
    (wave,) = waves
    turning = [n for n in names(wave.argument) if n != _TIME.name]
    if len(turning) != 1 or wave.argument not in (
        Product((Name(turning[0]), _TIME)),
        Product((_TIME, Name(turning[0]))),
    ):
        return None
    beside = with_every(equation.rest, wave, _ZERO)
    if not decide_equality(beside, _ZERO, Knowledge()).is_proved:
        return None
    square = Negative(Power(Name(turning[0]), _TWO))
    even: list[Formula] = [_ZERO]
    odd: list[Formula] = [_ZERO]
    for (_, order), factor in equation.factors.items():
        if order == 1:
            odd.append(Product((factor, Name(turning[0]))))
        else:
            even.append(Product((factor, square)) if order else factor)
    amplitude = Negative(with_every(equation.rest, wave, _ONE))
    return _Force(amplitude, wave, turning[0], Sum(tuple(even)), Sum(tuple(odd)))
