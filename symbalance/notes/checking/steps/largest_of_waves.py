"""The largest value of a sine and a cosine of one angle: of 3 sin θ + 4 cos θ it is 5, and not 7.

They are not largest at the same angle, so that their amplitudes add as the sides of a right angle. What a
page says of T_max, where T = T_m + A sin 2θ - B cos 2θ stands above, is compared with T_m + √(A² + B²).
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Negative, Number, Power, Product, Sum, names
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.motions.named_extremes import base_of_largest
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain

_OPEN = (DEFINITION, PREMISE, CONDITION, UNDECIDED)
_WAVES = ("sin", "cos")
_PARTS = 2


def unless_plain_sum(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a largest value that adds the amplitudes of sine and cosine is refuted."""
    head, right = chain.sides[0].node, chain.sides[1]
    base = base_of_largest(head.name) if isinstance(head, Name) else ""
    if k or verdict.verdict not in _OPEN or not base or not isinstance(head, Name):
        return verdict
    above = state.sections.chains_above(Name(base), chain.start)
    near = [c for c in above if state.sections.same_section(c.lines[0], chain.lines[0])]
    formulas = [side.node for c in near for side in c.sides[1:] if _parts(side.node) is not None]
    parts = _parts(formulas[-1]) if formulas else None
    if parts is None:
        return verdict
    rest, (first, second) = parts
    squares = Sum((Power(first, rational_node(Fraction(2))), Power(second, rational_node(Fraction(2)))))
    exact = Sum((*rest, Call("sqrt", squares))) if rest else Call("sqrt", squares)
    plain = Sum((*rest, first, second))
    sign, knowledge = chain.relations[0].sign, state.knowledge(chain.lines[0])
    sizes = names(first) | names(second)
    meaning = replace(knowledge.meaning, positive=knowledge.meaning.positive | sizes)
    known = replace(knowledge, meaning=meaning)
    is_plain = decide(lone_side(plain), right, sign, known).is_proved
    if not is_plain or decide(lone_side(exact), right, sign, known).status != REFUTED:
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    reason = "a sine and a cosine of one angle are not largest together: their amplitudes add as squares"
    repair = Repair("root of the squares", exact, ((right.node, exact),), 1.0)
    fix = fix_of(repair, state.document, right) if state.corrects else None
    return replace(describe(state.document, chain, k, Decision(REFUTED, reason)), fix=fix)


def _parts(node: Formula) -> tuple[tuple[Formula, ...], tuple[Formula, Formula]] | None:
    """Return what stands still in a formula, and the amplitudes of its sine and its cosine."""
    if not isinstance(node, Sum):
        return None
    rest, waves = list[Formula](), list[tuple[Call, Formula]]()
    for term in node.terms:
        bare = term.operand if isinstance(term, Negative) else term
        factors = bare.factors if isinstance(bare, Product) else (bare,)
        own = [each for each in factors if isinstance(each, Call) and each.function in _WAVES]
        others = tuple(each for each in factors if each not in own)
        if not own:
            rest.append(term)
        elif len(own) == 1:
            size = Product(others) if len(others) > 1 else others[0] if others else Number(Fraction(1))
            waves.append((own[0], size))
        else:
            return None
    turning = {name for wave, _ in waves for name in names(wave.argument)}
    still = all(not names(each) & turning for each in (*rest, *(size for _, size in waves)))
    is_pair = len(waves) == _PARTS and waves[0][0].argument == waves[1][0].argument
    if not is_pair or not still or waves[0][0].function == waves[1][0].function:
        return None
    return tuple(rest), (waves[0][1], waves[1][1])
