"""Proportions: F ∝ ω² says that F over ω² is the same whatever ω is, all else staying as it is.

Both sides are followed to the letters that formulas above give them; numbers of these letters are left
out, since what is claimed is claimed of every speed. A page may go on from ω to n: F ∝ ω² ∝ n².
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from math import pi

from symbalance.document.formula import Constant, Formula, Name, Number, Power, Product, Quotient, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.own_units import ANGULAR_LETTERS
from symbalance.notes.checking.verdicts import PREMISE
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.formulas.result_units import value_of

SIGN = "∝"
STATED = "said to be proportional, which no formula above shows"
SAY_HOW = "say how they are tied"
_TIMES, _MARK = "times_of_it", "what_it_grows_to"
"""The letter by which another one is multiplied, and one that stands for a head until both are put in."""
_AS_PRINTED = 0.002
"""What the numbers of ω and n, as printed, may be off by."""
_MOST_STEPS = 12
"""Letters put in one after the other: a formula that needs more is that of a circle."""
_POWERS = tuple(Fraction(n, 2) for n in (0, 2, -2, 4, -4, 6, -6, 8, -8, 1, -1, 3, -3))
"""Powers that are tried to say how it grows: the fourth of a shaft's diameter is the highest in use."""


def decide_proportional(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision:
    """Return the decision on a relation ∝: proved, refuted with the right power, or a premise.

    One that a formula of the page shows is open where another line ties the same letters otherwise:
    C = (ω_1 - ω_2)/ω_m beside J = E/(C ω_m²), where the difference is not the same for every ω_m.
    """
    decision = _decide(chain, k, knowledge)
    head, right = chain.sides[k].node, chain.sides[k + 1].node
    if decision.status == REFUTED:
        decision = _without_solved(chain, k, knowledge) or decision
    if decision.reason.endswith(SAY_HOW):
        decision = _by_other_form(state, chain, k, knowledge) or decision
    if decision.reason.endswith(SAY_HOW):
        decision = _by_turns(chain, k, knowledge) or decision
    if not decision.is_proved or not isinstance(head, Name):
        return decision
    bare = of_any_size(chain.letters | {head.name}, knowledge)
    for name in sorted(names(right) - knowledge.angles):
        line = _tied_otherwise(state, chain, (head, right), name, bare, knowledge)
        if line is not None:
            reason = f"line {line} has {plain_text(head)} grow otherwise with {plain_letter(name)}"
            return Decision(UNDECIDED, reason)
    return decision


def _without_solved(chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof of a proportion without what equations above were solved for; None without one.

    T/θ = G J/L fixes no T of τ = 16 T/(π d³): the torque stays as it is where d grows.
    """
    free = {n: d for n, d in knowledge.definitions.items() if not d.solved}
    if len(free) == len(knowledge.definitions):
        return None
    decision = _decide(chain, k, replace(knowledge, definitions=free, solved={}, solved_from=()))
    return decision if decision.is_proved else None


def _by_other_form(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision by another form that a line above has for the letter, k = T/θ = G J/L.

    None where no form decides it. The last side in which the letters of the claim stand is taken.
    """
    head = chain.sides[k].node
    known = knowledge.definitions.get(head.name) if isinstance(head, Name) else None
    if known is None or not isinstance(head, Name):
        return None
    above = state.sections.chains_above(head, chain.start)
    sides = (s for c in reversed(above) for s in reversed(c.sides[1:]) if not _is_proportion(c))
    for side in sides:
        if side.span[0] in state.refuted or not names(side.node) or side.node == known.node:
            continue
        other = knowledge.with_definition(head.name, replace(known, node=side.node, numeric=False))
        decision = _decide(chain, k, other)
        if decision.status in (PROVED, REFUTED):
            return decision
    return None


def _by_turns(chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision with 2π n for an angular speed whose number is that of n turns, or None.

    n = 12,000 rpm and ω = 2π·12,000/60 = 1257 rad/s are tied by their numbers.
    """
    for name in sorted(names(chain.sides[k + 1].node)):
        for other, known in knowledge.definitions.items():
            if other.partition("_")[0] in ANGULAR_LETTERS and _are_turns(name, known, knowledge):
                node = Product((Number(Fraction(2)), Constant("pi"), Name(name)))
                tied = knowledge.with_definition(other, replace(known, node=node, numeric=False))
                decision = _decide(chain, k, tied)
                if decision.status in (PROVED, REFUTED):
                    text = f"{plain_letter(other)} goes with {plain_letter(name)}"
                    return replace(decision, assumptions=(*decision.assumptions, text))
    return None


def _are_turns(name: str, known: Definition, knowledge: Knowledge) -> bool:
    """Tell whether the number of an angular speed is that of the turns that a letter counts."""
    turns = knowledge.definitions.get(name)
    if turns is None or not (turns.numeric and known.numeric):
        return False
    first, second = value_of(known.node), value_of(turns.node)
    if not first or not second:
        return False
    return any(abs(first / second / each - 1) < _AS_PRINTED for each in (1, 2 * pi, pi / 30))


def _is_proportion(chain: Chain) -> bool:
    return any(relation.sign == SIGN for relation in chain.relations)


def _tied_otherwise(
    state: JudgingState,
    chain: Chain,
    claim: tuple[Name, Formula],
    name: str,
    bare: Knowledge,
    knowledge: Knowledge,
) -> int | None:
    """Return a line above whose two sides grow apart as a letter and what is claimed of it grow.

    What has a formula in that letter grows with it: J of τ = T d/(2J) with d⁴.
    """
    head, right = claim
    growing = _formulas_in(name, knowledge)
    scaled = Product((Name(_TIMES), Name(name)))
    grown = Product((head, Quotient(substitute(right, name, scaled), right)))
    for above in state.document.chains:
        if above.start >= chain.start or _is_proportion(above) or not {head.name, name} <= above.letters:
            continue
        for first, second in _with_formulas(above, head.name, name, growing):
            known = replace(bare, letters=bare.letters | names(first) | names(second))
            before, after = (
                Product((a, b)) for a, b in _crosswise(first, second, head.name, grown, name)
            )
            if decide(lone_side(before), lone_side(after), "=", known).status == REFUTED:
                return above.lines[0]
    return None


def _with_formulas(
    above: Chain, head: str, name: str, growing: Mapping[str, Formula]
) -> Iterator[tuple[Formula, Formula]]:
    """Yield the sides of a line that tie two letters, with what rests on the second one written out."""
    for pair in pairwise(side.node for side in above.sides):
        if not {head, name} <= names(pair[0]) | names(pair[1]):
            continue
        own = {n: f for n, f in growing.items() if n != head and Name(n) not in pair}
        try:
            yield written_out(pair[0], own), written_out(pair[1], own)
        except NoFormError:  # a rate by such a letter
            yield pair


def _formulas_in(name: str, knowledge: Knowledge) -> dict[str, Formula]:
    """Return the formulas of letters that rest on a letter."""
    every = ((n, d) for n, d in knowledge.formulas.items() if n != name and not d.solved)
    formulas = {n: d.node for n, d in every if names(d.node)}
    return {n: node for n, node in formulas.items() if name in names_behind(node, formulas)}


def decide_by_equation(
    equation: tuple[Formula, Formula], head: Name, right: Formula, knowledge: Knowledge
) -> Decision | None:
    """Return whether a letter grows as claimed where all but two letters of an equation stay as they are.

    None where the claim is in several letters, or the equation ties them by no power.
    """
    if len(names(right)) != 1:
        return None
    (name,) = names(right)
    bare = of_any_size(names(equation[0]) | names(equation[1]) | {head.name}, knowledge)
    scaled = Product((Name(_TIMES), Name(name)))
    for claimed in (right, *(_power(name, exponent) for exponent in _POWERS)):
        grown = Product((head, Quotient(substitute(claimed, name, scaled), claimed)))
        before, after = (Product(pair) for pair in _crosswise(*equation, head.name, grown, name))
        if decide(lone_side(before), lone_side(after), "=", bare).is_proved:
            if claimed is right:
                return Decision(PROVED)
            return Decision(REFUTED, f"{plain_text(head)} grows as {plain_text(claimed)}")
    return None


def _crosswise(
    first: Formula, second: Formula, head: str, grown: Formula, name: str
) -> tuple[tuple[Formula, Formula], tuple[Formula, Formula]]:
    """Return the products of each side as it is with the other one as it grows."""
    scaled = Product((Name(_TIMES), Name(name)))
    marked = Name(_MARK)

    def larger(node: Formula) -> Formula:
        """Put the letter's multiple in, and only then what the head comes to."""
        return substitute(substitute(substitute(node, head, marked), name, scaled), _MARK, grown)

    return (larger(first), second), (first, larger(second))


def _decide(chain: Chain, k: int, knowledge: Knowledge) -> Decision:
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if not names(right):
        return Decision(UNDECIDED, "proportional to a number: say to which letter")
    try:
        pairs = [*_pairs(left, right, knowledge)]
        for first, second in pairs:
            shared = sorted(names(second) & names(first) - knowledge.angles)
            if shared:
                return _decide_powers(first, second, shared, knowledge)
    except NoFormError as problem:
        return Decision(UNDECIDED, f"no normal form: {problem}")
    first, second = pairs[-1]
    if isinstance(first, Name):
        return Decision(PREMISE, STATED)
    letters = " and ".join(map(plain_letter, sorted(names(second))))
    return Decision(UNDECIDED, f"{letters} does not stand in {plain_text(first)}: {SAY_HOW}")


def _pairs(left: Formula, right: Formula, knowledge: Knowledge) -> Iterator[tuple[Formula, Formula]]:
    """Yield both sides with formulas put in: those of the left one's letters first, then all."""
    formulas = {
        name: definition.node
        for name, definition in knowledge.formulas.items()
        if names(definition.node) and name not in knowledge.angles
    }
    own = {name: node for name, node in formulas.items() if name not in names(right)}
    yield written_out(left, own), right
    yield written_out(left, formulas), written_out(right, formulas)


def written_out(node: Formula, formulas: Mapping[str, Formula]) -> Formula:
    """Return a formula with those of its letters put in, and of theirs."""
    for _ in range(_MOST_STEPS):
        name = next((n for n in sorted(names(node)) if n in formulas), None)
        if name is None:
            return node
        node = substitute(node, name, formulas[name])
    return node


def _decide_powers(left: Formula, right: Formula, letters: list[str], knowledge: Knowledge) -> Decision:
    """Return the decision by how each side grows with each letter that stands in both."""
    bare = of_any_size(names(left) | names(right), knowledge)
    for name in letters:
        if not _grows_as(left, right, name, bare).is_proved:
            return _not_so(left, right, name, bare)
    return Decision(PROVED)


def _not_so(left: Formula, right: Formula, name: str, bare: Knowledge) -> Decision:
    """Return why a proportion fails in a letter: with the power that is right, if one is."""
    powers = (_power(name, exponent) for exponent in _POWERS)
    grown = next((power for power in powers if _grows_as(left, power, name, bare).is_proved), None)
    if grown is not None:
        return Decision(REFUTED, f"the left side grows as {plain_text(grown)}")
    if _grows_as(left, right, name, bare).status != REFUTED:
        return Decision(UNDECIDED, f"how the left side grows with {plain_letter(name)} is not decided")
    return Decision(REFUTED, f"the left side does not grow as a power of {plain_letter(name)}")


def of_any_size(letters: frozenset[str], knowledge: Knowledge) -> Knowledge:
    """Return what is known where letters are sizes without a value: neither numbers nor formulas."""
    sizes = {*letters, _TIMES} - knowledge.angles
    meaning = replace(knowledge.meaning, positive=knowledge.meaning.positive | sizes, values={})
    return Knowledge(meaning=meaning, letters=knowledge.letters | letters | {_TIMES}, corrects=False)


def _grows_as(left: Formula, right: Formula, name: str, knowledge: Knowledge) -> Decision:
    """Return whether both sides grow alike when a letter is multiplied by another one."""
    scaled = Product((Name(_TIMES), Name(name)))
    crosswise = (
        Product((substitute(left, name, scaled), right)),
        Product((left, substitute(right, name, scaled))),
    )
    return decide(lone_side(crosswise[0]), lone_side(crosswise[1]), "=", knowledge)


def _power(name: str, exponent: Fraction) -> Formula:
    return Name(name) if exponent == 1 else Power(Name(name), Number(exponent))
