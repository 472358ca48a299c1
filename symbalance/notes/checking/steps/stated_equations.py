"""Equations that are no steps: those that fix a letter, and those that state a case or a condition."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Product, Sum, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.cases import NUMBERS_PUT_IN, decide_case, decide_with_ratio
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.numbers_put_in import paired, without_unit
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals, exact_exponents
from symbalance.notes.checking.page.solutions import NEAR
from symbalance.notes.checking.premises import constraints
from symbalance.notes.checking.premises.constraints import Constraint
from symbalance.notes.checking.premises.premise_decisions import decide_by_premises
from symbalance.notes.checking.steps.derived_equations import decide_derived
from symbalance.notes.checking.steps.equations_to_solve import is_to_be_solved
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.rod_branches import is_rod_angle
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    DEFINITION,
    PREMISE,
    STATED,
    UNDECIDED,
)
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side


def fix_letter(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a relation that is no step but fixes a letter; None for others."""
    in_use, used = state.definitions.letters_before(chain.lines[0]), state.definitions.first_lines
    in_use -= _explained_letter(state, chain, k)
    in_use -= _letters_found_below(state, chain, k, knowledge)
    if _names_its_terms(state, chain, k, knowledge):
        state.definitions.note_premise(chain, k)
        return Decision(PREMISE, "names the terms")
    constraint = constraints.constraint_of(chain, k, in_use, used, knowledge)
    if constraint is None or _is_rough_for(state, constraint.name, chain, k):
        return None
    is_balance = chain.sides[k + 1].node == Number(Fraction(0))  # A cos θ + B sin θ = 0 fixes A and B
    is_claim = constraint.name in state.general or is_balance or not names(constraint.node)
    if state.general and is_claim:
        return None  # sin β = λ sin θ for all θ fixes β, and tan x = 1 for all x nothing
    return _fix(state, constraint, chain, k, knowledge)


def _is_rough_for(state: JudgingState, name: str, chain: Chain, k: int) -> bool:
    """Tell whether a relation with rounded numbers would fix a letter that has its number below it.

    W v²/(g r) = 0.00034 W N² r says nothing of g, with g = 32.2 in the next paragraph.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if not (names(left) and names(right) and (_has_rounded(left) or _has_rounded(right))):
        return False
    below = (c for c in state.document.chains if c.sides[0].span[0] > chain.sides[0].span[0])
    heads = (c for c in below if isinstance(c.sides[0].node, Name) and c.sides[0].node.name == name)
    return any(not names(c.sides[1].node) for c in heads if c.relations)


def _has_rounded(node: Formula) -> bool:
    """Tell whether a formula has a rounded number; the exponent 1.4 of a gas law is meant as printed."""
    exact = exact_exponents(node)
    return any(id(number) not in exact for number in decimals(node))


def _names_its_terms(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether a value is said to be a sum of new letters: F = m r ω² cos θ + … = F_1 + F_2."""
    total = chain.sides[k + 1].node
    if not k or chain.relations[k].sign != "=" or not isinstance(total, Sum):
        return False
    terms = [term.name for term in total.terms if isinstance(term, Name)]
    own = frozenset(terms)
    if not len(own) == len(terms) == len(total.terms) or own & state.definitions.letters_in_use:
        return False
    earlier = frozenset[str]().union(*(names(side.node) for side in chain.sides[: k + 1]))
    return own.isdisjoint(earlier) and not any(knowledge.has_meaning(n) for n in own)


def _explained_letter(state: JudgingState, chain: Chain, k: int) -> frozenset[str]:
    """Return the letter that a relation says what it is right behind its first use.

    x = r (1 - cos θ) + l (1 - cos β), in which sin β = λ sin θ: β alone stands left, and nowhere else
    but in the formula before.
    """
    own = names(chain.sides[k].node)
    before = [c for c in state.document.chains if c.sides[0].span[0] < chain.sides[0].span[0]]
    if k or len(own) != 1 or not before:
        return frozenset()
    *earlier, last = sorted(before, key=lambda c: c.sides[0].span[0])
    is_first_use = not any(own <= c.letters for c in earlier)
    is_near = own <= last.letters and chain.lines[0] <= last.lines[-1] + NEAR
    return own if is_first_use and is_near and not _is_declared(state, own, chain) else frozenset()


def _letters_found_below(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> frozenset[str]:
    """Return the letters that a relation is to be solved for, though they stand in lines above.

    8 m_A r_A ω² = 4 λ m r ω², so that m_A = λ m r/(2 r_A): of m_A nothing was said before, it stands on
    one side alone, and a line of the section below begins with it.
    """
    if k or chain.relations[0].sign != "=":
        return frozenset()
    line, sections = chain.lines[0], state.sections
    below = {
        other.sides[0].node.name
        for other in state.document.chains
        if isinstance(other.sides[0].node, Name) and line < other.lines[0] <= sections.section_end(line)
    }
    left, right = (names(chain.sides[n].node) for n in (0, 1))
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = [{*names_behind(chain.sides[n].node, values)} for n in (0, 1)]
    premises = state.definitions.premises_at(line)
    in_premises = {name for premise in premises for name in premise.names}
    return frozenset(
        name
        for name in below & ((left - behind[1]) | (right - behind[0])) - in_premises - knowledge.angles
        if not knowledge.has_meaning(name) and not _is_declared(state, frozenset({name}), chain)
    )


def _is_declared(state: JudgingState, letters_here: frozenset[str], chain: Chain) -> bool:
    return bool(letters_here & state.declarations.symbols_at(chain.lines[0]).keys())


def _fix(
    state: JudgingState, constraint: Constraint, chain: Chain, k: int, knowledge: Knowledge
) -> Decision:
    """Return the decision on a relation that fixes a letter, after defining it."""
    by_premises = decide_by_premises(state.definitions, state.definitions.premise_of(chain, k), knowledge)
    if by_premises is not None and by_premises.status == CONTRADICTION:
        return by_premises
    if constraint.is_circular:
        return _fix_beside_others(state, constraint, (chain, k), by_premises, knowledge)
    at_number = _fixed_at_number(constraint, knowledge)
    if at_number is not None:
        return at_number
    is_rods = bool(constraint.alternatives) and is_rod_angle(state, constraint, chain, knowledge)
    state.definitions.fix(constraint, chain, is_rod_angle=is_rods)
    state.definitions.note_premise(chain, k, constraint.name)
    if not names(chain.sides[k + 1].node) and len(names(chain.sides[k].node)) == 1:
        return Decision(CONDITION)
    as_rod_angle = state.meant.rod_angle(chain, k, knowledge)
    return as_rod_angle or Decision(DEFINITION, f"read as what fixes {constraint.name}")


def _fix_beside_others(
    state: JudgingState,
    constraint: Constraint,
    link: tuple[Chain, int],
    by_premises: Decision | None,
    knowledge: Knowledge,
) -> Decision:
    """Return the decision on a relation that fixes a letter only together with an equation before."""
    chain, k = link
    as_step = decide(chain.sides[k], chain.sides[k + 1], "=", knowledge)
    sides = [form for form in (as_step.left, as_step.right) if form is not None]
    if as_step.status == REFUTED and sides and all(constraint.name not in letters(f) for f in sides):
        return as_step  # the letter cancels: nothing is fixed
    is_following = by_premises is not None and by_premises.is_proved
    derived = decide_derived(state, chain, k, as_step, knowledge, is_following=is_following)
    if derived is not None:
        return derived
    state.definitions.note_premise(chain, k)
    return Decision(DEFINITION, f"read as what fixes {constraint.name}, with an equation before")


def _fixed_at_number(constraint: Constraint, knowledge: Knowledge) -> Decision | None:
    """Return that a relation makes a new letter 0 or 1 by what the other letters are, else None.

    l sin β = r sin θ - e is of another engine than the centred one that is declared, for which e is 0;
    k² = ½ (a² + b²) below k² = ½ a² is of another body. With that put in, every error in e would hold.
    """
    if not names(constraint.node):
        return None
    letter, meanings = plain_text(Name(constraint.name)), knowledge.meaning.values
    formulas = {n: d.node for n, d in knowledge.definitions.items() if not d.numeric and not d.assumption}
    if (number := _number_at(Level(meanings), constraint, knowledge)) is not None:
        reason = f"by what its letters are declared to be, true only for {letter} = {number}"
        return Decision(UNDECIDED, reason)
    if (number := _number_at(Level({**formulas, **meanings}), constraint, knowledge)) is not None:
        return Decision(
            PREMISE, f"of another case: with the lines above true only for {letter} = {number}"
        )
    return None


def _number_at(level: Level, constraint: Constraint, knowledge: Knowledge) -> int | None:
    """Return the 0 or 1 that the value of a letter comes down to, None for any other."""
    try:
        form = knowledge.evaluator(level).form(constraint.node)
        return next((n for n in (0, 1) if form.equals(Form.number(form.domain, n))), None)
    except (NoFormError, TooLargeError):
        return None


def unless_stated(
    state: JudgingState, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on a refuted relation that may be a premise, a condition or a case."""
    is_solved = is_to_be_solved(state, chain, k)
    typed = state.results.with_formulas(chain.sides[k + 1])
    if typed is not None:
        there = decide(chain.sides[k], typed, chain.relations[k].sign, knowledge)
        if there.is_proved:
            return there
    if (
        not is_solved
        and (by_results := state.results.decide(chain, k, knowledge, state.definitions.given_anew))
        is not None
    ):
        head = chain.sides[k].node
        if isinstance(head, Name) and by_results.is_proved:
            state.definitions.define(head.name, chain.sides[k + 1].node, chain)
        return by_results
    whole = _with_quantity_whole(state, chain, k)
    case = decide_case(whole, k, decision, knowledge, is_solved=is_solved)
    if case is not None and case.status in STATED and chain.relations[k].sign == "=":
        case = _note_statement(state, chain, k, case, knowledge)
    if case is not None and case.status != REFUTED:
        return case
    with_ratio = decide_with_ratio(against.node, chain.sides[k + 1].node, knowledge)
    return with_ratio or case or decision


def _with_quantity_whole(state: JudgingState, chain: Chain, k: int) -> Chain:
    """Return a chain with a number and its unit as one number: 1600 cm³ puts nothing in for z and V_h."""
    right = chain.sides[k + 1]
    node = right.node
    quantity = quantity_of(right, state.document) if isinstance(node, Product) else None
    if quantity is None or not isinstance(node, Product):
        return chain
    number = node.factors[0]
    if not isinstance(number, Number):
        return chain
    scale = quantity.value * quantity.scale / number.value if number.value else quantity.scale
    place = None if number.last_place is None else number.last_place * scale
    whole = replace(right, readings=(Number(number.value * scale, place, span=node.span),))
    return replace(chain, sides=(*chain.sides[: k + 1], whole, *chain.sides[k + 2 :]))


def _note_statement(
    state: JudgingState, chain: Chain, k: int, case: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on a relation that is taken as given, after noting it."""
    if case.reason.startswith(NUMBERS_PUT_IN) and (numbers := _numbers_of_letters(chain, k, knowledge)):
        for name, number in numbers.items():
            state.definitions.define(name, number, chain)
        return case
    if case.reason.startswith(NUMBERS_PUT_IN) and _is_in_other_units(chain, k, knowledge):
        return case
    by_premises = decide_by_premises(state.definitions, state.definitions.premise_of(chain, k), knowledge)
    if by_premises is not None and by_premises.status != PREMISE:
        return by_premises
    state.definitions.note_premise(chain, k, angles=knowledge.angles)
    return case


def _numbers_of_letters(chain: Chain, k: int, knowledge: Knowledge) -> dict[str, Formula]:
    """Return the letters without values that an arithmetic gives numbers: M of M ω = 23.5·151.8.

    None where no other letter has the number put in for it, or where the arithmetic was read in the unit
    of its result, m r = 0.74·38 = 28 kg mm: the units are not sure then.
    """
    right = chain.sides[k + 1].node
    if without_unit(right) is not right:
        return {}
    numbers: dict[str, Formula] = {}
    is_sure = False
    for part, number in paired(chain.sides[k].node, right) or ():
        if decide_equality(part, number, knowledge).is_proved or _is_printed(part, number, knowledge):
            is_sure = True
        elif isinstance(part, Name) and not _has_value(part.name, knowledge):
            numbers[part.name] = number
        else:
            return {}
    return numbers if is_sure else {}


def _is_in_other_units(chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether a number put in is a letter's value in a unit left out, 75 for n = 4500 min⁻¹.

    The numbers beside it are then no values of their letters.
    """
    pairs = paired(chain.sides[k].node, chain.sides[k + 1].node) or ()
    decisions = (decide_equality(part, number, knowledge) for part, number in pairs)
    return any(d.status == REFUTED and d.left is not None and not letters(d.left) for d in decisions)


def _is_printed(part: Formula, number: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a number is what a letter's own line prints for it: a = r ω²(1 + λ) = 29403."""
    definition = knowledge.definitions.get(part.name) if isinstance(part, Name) else None
    rounded = None if definition is None else definition.rounded
    return rounded is not None and decide_equality(rounded, number, knowledge).is_proved


def _has_value(name: str, knowledge: Knowledge) -> bool:
    return (
        name in knowledge.definitions or name in knowledge.meaning.values or name in knowledge.universal
    )
