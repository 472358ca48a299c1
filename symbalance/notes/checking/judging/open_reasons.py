"""Reasons why a relation that does not come out is undecided: what it may rest on is not known."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Derivative, Formula, Name, Quotient, Summation, names, walk
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.harmonics import components
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.declared.role_phrases import PHRASES, RATIO
from symbalance.notes.checking.declared.symbol_roles import KNOWN, role_of
from symbalance.notes.checking.page.solutions import (
    is_said_to_solve,
    solution_behind_arrow,
    solution_behind_words,
    solution_in_sentence,
)
from symbalance.notes.checking.premises import constraints
from symbalance.notes.checking.premises.small_by_value import refuted_in_small_letter
from symbalance.notes.checking.premises.solved_premises import solve_without_scope
from symbalance.notes.checking.premises.system import lines_of
from symbalance.notes.checking.premises.witness_angles import holds_at_angles
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.solved_balances import as_balance
from symbalance.notes.checking.steps.solved_below import as_solution, as_solved, as_solved_in_words
from symbalance.notes.checking.verdicts import DECLARE_IT, UNDECIDED
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_OPEN_RATIOS = frozenset(words.casefold() for words in PHRASES[RATIO])
"""Declarations that leave open which ratio of crank and rod is meant."""
UNKNOWN_SMALL = "nobody has said which letter is small: declare what they mean"


def unless_solved_in_sentence(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on a refuted relation: a condition if its sentence goes on to its solution."""
    following = None if k else solution_in_sentence(state.sections, chain, knowledge)
    is_sure = following is not None and is_said_to_solve(state.sections, following, chain)
    solved = as_solved_in_words(state, chain, following, knowledge, is_sure=is_sure)
    if solved is not None and is_sure and following is not None:
        state.balances.add(following.sides[0].span[0])
    return solved or decision


def unless_open(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on a refuted relation: undecided if it may rest on what is not known."""
    left, right, line = chain.sides[k].node, chain.sides[k + 1].node, chain.lines[0]
    behind = None if k else solution_behind_arrow(state.sections, chain, knowledge)
    solved = as_solved(state, chain, behind, knowledge) or as_solution(state, chain, k)
    solved = solved or as_balance(state, chain, k, knowledge)
    if solved is None and not k:
        in_words = solution_behind_words(state.sections, chain, knowledge)
        solved = as_solved_in_words(state, chain, in_words, knowledge)
    if solved is not None:
        return solved
    if (as_rod_angle := state.meant.rod_angle(chain, k, knowledge)) is not None:
        _fix_rod_angle(state, chain, k, as_rod_angle, knowledge)
        return as_rod_angle
    letters_here = names(left) | names(right)
    free = set(state.document.free_letters) - set(state.declarations.symbols_at(line))
    reason = ""
    unknown = [name for name in state.not_judged if name in letters_here]
    condition = state.definitions.condition_behind(decision, line)
    if unknown:
        reason = f"may rest on line {state.not_judged[unknown[0]]}, which was not judged"
    elif condition is not None:
        reason = f"may rest on line {condition}, which sets two quantities equal; give it in a scope"
    elif (
        chain.relations[k].sign == "≈"
        and free & letters_here
        and len(letters_here) > 1
        and not letters_here & knowledge.small
    ):
        refutation = refuted_in_small_letter(chain, k, knowledge)
        letter = _one_sided_letter(state, decision, chain, k, knowledge) if refutation else ""
        if refutation is not None and not letter:
            return refutation
        reason = f"{letter} stands on one side only: {DECLARE_IT}" if letter else UNKNOWN_SMALL
    elif letter := _one_sided_letter(state, decision, chain, k, knowledge):
        reason = f"{letter} stands on one side only: {DECLARE_IT}"
    elif chain.relations[k].sign == "=":
        reason = _missing_meaning(state, left, right, line, knowledge)
    is_value = k == 0 and isinstance(left, Name) and not names(right)
    if not reason and is_value and state.sections.is_supposed(chain):
        reason = "said of what would be in a case that stands in words"
    reason = reason or _ended_premise(state, chain, k, knowledge)
    reason = reason or _count_without_meaning(state, chain, k, decision, knowledge)
    return replace(decision, status=UNDECIDED, reason=reason) if reason else decision


def _fix_rod_angle(
    state: JudgingState, chain: Chain, k: int, as_rod_angle: Decision, knowledge: Knowledge
) -> None:
    """Define the rod's angle by the relation that fixes it: it turns with the crank, in what is derived.

    Without it, ẍ of x = r (1 - cos θ) + l (1 - cos β) would be r ω² cos θ, as if β stood still.
    """
    in_use = state.definitions.letters_before(chain.lines[0])
    for name in sorted(names(chain.sides[k].node) | names(chain.sides[k + 1].node)):
        if not as_rod_angle.assumptions[0].startswith(f"{plain_letter(name)} is "):
            continue
        used = state.definitions.first_lines
        constraint = constraints.constraint_of(chain, k, in_use - {name}, used, knowledge)
        if constraint is not None and constraint.name == name:
            state.definitions.fix(constraint, chain)


def _summed_letters(left: Formula, right: Formula, decision: Decision, knowledge: Knowledge) -> set[str]:
    """Return the letters that a sum is of, whatever they mean: Σ cos(θ + δ_k) = 2 cos θ.

    Where it is said to be 0 or another number, no meaning of a letter in it could make it so.
    """
    sums = [part for node in (left, right) for part in walk(node) if isinstance(part, Summation)]
    if not sums:
        return set()
    values = {name: d.node for name, d in knowledge.definitions.items()}
    bodies = {name for each in sums for name in names_behind(each.body, values)}
    bodies |= {name.rpartition("_")[0] for name in bodies} - {""}  # θ of θ_i, one for each cylinder
    if names(right):
        return bodies & names(right)
    form = decision.left
    products = set() if form is None else {key.letters for key in components(form.domain, form.numerator)}
    return bodies if len(products) <= 1 else set()  # in m r ω² λ nothing cancels, in F + G it may


def _differentiated_by(left: Formula, right: Formula) -> set[str]:
    """Return the letter of dS/dk = 2(1 - k) + 2k by which is differentiated: no meaning of it counts."""
    slopes = [node for node in (left, right) if isinstance(node, Derivative)]
    return {each.variable.name for each in slopes} & names(left) & names(right)


def _one_sided_letter(
    state: JudgingState, decision: Decision, chain: Chain, k: int, knowledge: Knowledge
) -> str:
    """Return a letter whose meaning may make a refuted relation true, as it stands on one side only.

    x = r (1 - cos u) is wrong of any u but of the crank angle, which u may be; dx/dt = v is of any x
    but the one whose speed v is. Of a series the letter may stand in what is cut off, as φ does in
    √(1 - λ² sin²φ) ≈ 1 - λ/2 sin²φ: it is written on both sides.
    """
    line, left, right = chain.lines[0], chain.sides[k].node, chain.sides[k + 1].node
    if decision.of_matrices:
        return ""
    if decision.left is None or decision.right is None:
        return _one_sided_by_value(state, left, right, line, knowledge)
    both = names(left) & names(right) if decision.expanded_in else set[str]()
    both |= _summed_letters(left, right, decision, knowledge)
    both |= _differentiated_by(left, right)
    if decision.left.is_zero() or decision.right.is_zero():  # they cancel in one side, whatever they are
        nodes = {n: d.node for n, d in knowledge.definitions.items()}
        shared = names(left) & names(right)
        both |= {name for own in shared for name in (own, *names_behind(Name(own), nodes))}
    free = set(state.document.free_letters) - set(state.declarations.symbols_at(line))
    free -= state.motions.letters(line)
    unlike = set(letters(decision.left)) ^ set(letters(decision.right))
    if decision.expanded_in and chain.relations[k].sign == "=":
        unlike |= _ends_behind(left, knowledge) ^ _ends_behind(right, knowledge)  # whatever is cut off
    if open_ratios := unlike & _open_ratios(state, line):
        return f"{plain_text(Name(min(open_ratios)))}, of which nobody says whether it is r/l or l/r,"
    for name in sorted(unlike):
        is_open = name in free and name not in {
            *state.general,
            *knowledge.universal,
            *decision.left.domain.integer,
        }
        is_open = is_open or _stands_nowhere(state, name, line, knowledge)
        is_open = is_open and name not in both and not knowledge.knows(name)
        if is_open and not _differs_whatever(name, decision, knowledge):
            return f"{plain_text(Name(name))} is not declared and"
        if "/d" in name:  # the derivative of what no line defines
            return name
    return ""


def _open_ratios(state: JudgingState, line: int) -> set[str]:
    """Return the letters that are declared to be a ratio of crank and rod, and not which one."""
    symbols = state.declarations.symbols_at(line)
    return {name for name, text in symbols.items() if text.casefold() in _OPEN_RATIOS}


def _one_sided_by_value(
    state: JudgingState, left: Formula, right: Formula, line: int, knowledge: Knowledge
) -> str:
    """Return such a letter of sides that were compared by values alone: they have other roots."""
    free = set(state.document.free_letters) - set(state.declarations.symbols_at(line))
    for name in sorted(_ends_behind(left, knowledge) ^ _ends_behind(right, knowledge)):
        if (
            name in free
            and name not in {*state.general, *knowledge.universal}
            and not knowledge.knows(name)
        ):
            return f"{plain_text(Name(name))} is not declared and"
    return ""


def _ends_behind(node: Formula, knowledge: Knowledge) -> set[str]:
    """Return the letters without a value that a formula has when its own have theirs."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    return {name for name in names_behind(node, values) if name not in values}


def _stands_nowhere(state: JudgingState, name: str, line: int, knowledge: Knowledge) -> bool:
    """Tell whether only a rule for any index brings a letter in: the A_5 of B_5, after B_n = n² A_n."""
    stem, _, index = name.rpartition("_")
    is_member = bool(stem) and index.isdigit() and name not in state.letters
    return is_member and name not in state.declarations.symbols_at(line) and not knowledge.measures(name)


def _differs_whatever(name: str, decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether sides differ whatever length a letter is that a ratio brings in: the l of λ = r/l.

    A ratio of two lengths stands still. Where some wave of the difference has one power of it alone,
    nothing that it may be takes that wave away.
    """
    ratios = [d.node for d in knowledge.definitions.values() if isinstance(d.node, Quotient)]
    is_size = any(
        isinstance(node.numerator, Name)
        and isinstance(node.denominator, Name)
        and name in (node.numerator.name, node.denominator.name)
        for node in ratios
    )
    if not is_size or decision.left is None or decision.right is None:
        return False
    try:
        gap = decision.left.minus(decision.right)
    except (NoFormError, TooLargeError):
        return False
    domain = gap.domain
    if domain.opaque or domain.radicals:
        return False
    letter = domain.symbol(name)
    waves: dict[object, set[object]] = {}
    for key in components(domain, gap.numerator):
        waves.setdefault((key.function, key.angle), set()).add(dict(key.letters).get(letter, 0))
    return len(waves) > 1 and any(len(powers) == 1 for powers in waves.values())


def _missing_meaning(
    state: JudgingState, left: Formula, right: Formula, line: int, knowledge: Knowledge
) -> str:
    """Return for which size of the geometry a letter without a meaning makes a relation true.

    A letter declared by other words than the known ones is just a letter, and sin β = k sin θ would
    be refuted although k is r/l by its author's words.
    """
    declared = state.declarations.symbols_at(line)
    for name in sorted(names(left) | names(right)):
        if role_of(declared.get(name, KNOWN[0])) in KNOWN or knowledge.knows(name):
            continue
        if knowledge.meaning.values.keys().isdisjoint(names(left) | names(right)):
            continue
        size = constraints.size_of(left, right, name, knowledge)
        if size is not None:
            letter, text = (plain_text(node) for node in (Name(name), size))
            return f"true if {letter} = {text}: declare what {letter} means"
    return ""


def _ended_premise(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> str:
    """Return which premise of a section above would make a relation true, "" for none."""
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    solved = solve_without_scope(state.definitions, [left.node, right.node], chain.lines[0], knowledge)
    if solved is None:
        return ""
    at_places = {p.left.name for p in solved.premises if isinstance(p.left, Name) and not names(p.right)}
    if sign == "=" and at_places & names(left.node) & names(right.node):
        return ""  # of every angle, as it is written: at one of them both sides are numbers
    by_all = decide(left, right, sign, solved.knowledge)
    is_true = by_all.is_proved or (bool(solved.leftover) and holds_at_angles(left, right, sign, solved))
    if not is_true:
        return ""
    texts = " and ".join(p.text for p in solved.premises)
    where = lines_of(solved.premises)
    return f"true if {texts}, by {where}, which holds to the end of its section; say so again"


def _count_without_meaning(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> str:
    """Return a letter that a page explains in words and gives a number below: N turns per minute."""
    if decision.left is None or decision.right is None:
        return ""
    below = {
        c.sides[0].node.name
        for c in state.document.chains
        if isinstance(c.sides[0].node, Name)
        and c.lines[0] > chain.lines[0]
        and len(c.sides) > 1
        and not names(c.sides[1].node)
    }
    declared = state.declarations.symbols_at(chain.lines[0])
    bound = _differentiated_by(chain.sides[k].node, chain.sides[k + 1].node)
    for name in sorted(set(letters(decision.left)) ^ set(letters(decision.right))):
        if name in state.general | knowledge.universal | bound:
            continue
        if name in below and name not in declared and not knowledge.knows(name):
            text = plain_text(Name(name))
            return f"{text} stands on one side only: {DECLARE_IT}"
    return ""
