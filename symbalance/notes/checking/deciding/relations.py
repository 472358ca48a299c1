"""Decisions whether one relation = or ≈ holds, in any of the readings of its two sides."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product

from symbalance.document.formula import (
    Constant,
    Derivative,
    Dots,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Summation,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.construct_rules import may_fail
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.open_sums import NUMBERS_WITHOUT_END, has_open_numbers
from symbalance.notes.algebra.sums import NO_EQUAL_TERMS, indexed_letters
from symbalance.notes.checking.deciding.antiderivatives import decide_antiderivatives
from symbalance.notes.checking.deciding.branches import decide_branches, has_branches
from symbalance.notes.checking.deciding.common_factors import without_common_factor
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
    without_dots,
)
from symbalance.notes.checking.deciding.induction import decide_by_induction
from symbalance.notes.checking.deciding.infinite_series import decide_powers, states_powers
from symbalance.notes.checking.deciding.joint_orders import decide_jointly
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.matrix_relations import decide_matrices, is_of_matrices
from symbalance.notes.checking.deciding.numbers_put_in import is_put_in
from symbalance.notes.checking.deciding.order_agreement import (
    IS_LARGE,
    IS_SMALL,
    decide_agreement,
    degree,
    known_not_small,
)
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import put_in, replace_part, substitute
from symbalance.notes.checking.deciding.sums_as_letters import decide_sums_as_letters
from symbalance.notes.checking.deciding.sums_over_cylinders import decide_over_cylinders
from symbalance.notes.checking.deciding.whole_numbers import (
    behind,
    decide_with_whole_numbers,
    with_counts,
)
from symbalance.notes.reading.equations import Side

MOST_READINGS = 16
"""Pairs of readings that are tried: a decision may cost a second."""
MEANT_ROUGHLY = "= stands where ≈ is meant"
NO_VALUES_HERE = " has no values here: say what each is"
SMALLEST_ROUNDED = 100
"""A whole number of three digits may be a result, ω = 628; a shorter one is data."""
FEWEST_ROUGH = 10
"""Units of its last place that a number behind ≈ comes to, at least, to stand for what rounds to it."""
MOST_ROUNDED = 3
"""Results that are tried as printed one by one, the others with all their digits."""
MOST_COUNTED = 9
"""Numbers of terms, of cylinders, that are tried where a sum has a special value at one of them."""
DEEPEST = 12
"""Letters that stand for others, one in the other."""
MOST_BRANCHED = 3
"""Letters of one relation whose branches are gone through."""


def decide(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None = None
) -> Decision:
    """Decide a relation = or ≈ in the first pair of readings that proves it; else in the usual ones.

    sin β = ρ sin θ fixes β only on a branch. What is true on all branches is proved, what is true on one
    of them under the condition that β lies there.
    """
    decision = _decide_as_defined(left, right, sign, knowledge, through)
    if decision.status == REFUTED and not (names(left.node) and names(right.node)):
        printed = _as_printed(left, right, sign, knowledge, through)
        decision = printed or _within_intervals(left, right, sign, knowledge, through) or decision
    elif decision.status == REFUTED and not decision.of_matrices:
        decision = _in_letters(left, right, sign, knowledge, through) or decision
        if not decision.is_proved and sign == "≈":
            decision = _with_own_numbers(left, right, sign, knowledge, through) or decision
        bare = None if decision.is_proved or sign != "=" else without_common_factor(left, right)
        if bare is not None and (
            is_put_in(bare[1].node, bare[0].node) or is_put_in(bare[0].node, bare[1].node)
        ):
            put_in = decide(*bare, sign, knowledge, through)
            decision = put_in if put_in.is_proved else decision
    branches = knowledge.branches_behind(left.node, right.node)
    if not branches or (decision.level and branches.keys().isdisjoint(decision.level.values)):
        return decision
    conditions: list[str] = []
    for name, definition in list(branches.items())[:MOST_BRANCHED]:
        others: list[tuple[Decision, str]] = []
        for value, condition in definition.alternatives:
            there = _on_branch(knowledge, name, value)
            others.append((_decide_as_defined(left, right, sign, there, through), condition))
        if not decision.is_proved:
            proof = next((pair for pair in others if pair[0].is_proved), None)
            if proof is not None and definition.is_rod_angle:
                if decision.status == REFUTED and not decision.reason:
                    reason = f"true for {proof[1]} alone, where the rod's angle never is"
                    return replace(decision, reason=reason)
            elif proof is not None:
                return replace(proof[0], assumptions=(*proof[0].assumptions, proof[1]))
        elif not all(other.is_proved for other, _ in others):
            conditions.append(definition.branch)
    return replace(decision, assumptions=(*decision.assumptions, *conditions)) if conditions else decision


def _in_letters(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None
) -> Decision | None:
    """Return the proof of a relation between letters, whatever numbers the page gives them; or None.

    A letter with a formula above its number has the formula: U = m r λ/2 = 5.3e-3 rounds no line below.
    """
    numeric = {name: d for name, d in knowledge.definitions.items() if d.numeric}
    if numeric.keys().isdisjoint(_behind(left.node, right.node, knowledge)):
        return None
    formulas = {
        name: replace(d, node=d.formula, numeric=False, rounded=None)
        for name, d in numeric.items()
        if d.formula is not None
    }
    others = {name: d for name, d in knowledge.definitions.items() if not d.numeric}
    known = replace(knowledge, definitions={**others, **formulas})
    decision = _decide_as_defined(left, right, sign, known, through)
    for name in numeric if _rests_on_size(decision) else ():
        letter = formula_text(Name(name), plain=True)
        said = known_not_small(name, knowledge) if f"{letter}{IS_SMALL}" in decision.assumptions else ""
        if said:
            return Decision(UNDECIDED, f"it takes {letter} for small: {said}")
    return decision if decision.is_proved else None


def _with_own_numbers(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None
) -> Decision | None:
    """Return the proof of R √(1 + κ²) ≈ 1.04 R with the page's number of κ put in; None if it has none.

    What is small is no series there: a letter whose number is known stands on one side, and on the other
    a printed decimal in its place.
    """
    sides = (left.node, right.node)
    own = names(left.node) ^ names(right.node)
    numeric = {n: d.node for n, d in knowledge.definitions.items() if d.numeric and n in own}
    bare = next((node for node in sides if not names(node) & own), None)
    if not numeric or own - numeric.keys() or bare is None or not decimals(bare):
        return None
    first, second = (
        replace(side, readings=tuple(put_in(node, numeric) for node in side.readings))
        for side in (left, right)
    )
    decision = _decide_as_defined(first, second, sign, knowledge, through)
    texts = tuple(
        f"{formula_text(Name(n), plain=True)} = {formula_text(v, plain=True)}" for n, v in numeric.items()
    )
    return replace(decision, assumptions=(*decision.assumptions, *texts)) if decision.is_proved else None


def _behind(left: Formula, right: Formula, knowledge: Knowledge) -> set[str]:
    """Return the letters of two sides and of what they stand for."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    return {n for node in (left, right) for n in names_behind(node, values)}


def decide_solution(left: Side, right: Side, knowledge: Knowledge) -> Decision:
    """Decide whether an equation is satisfied with a solution put in: a root is no series cut off."""
    decision = decide(left, right, "=", knowledge)
    if decision.is_proved and decision.reason == MEANT_ROUGHLY:
        return decide_equality(left.node, right.node, knowledge)
    return decision


def decide_at_value(
    left: Side, right: Side, sign: str, knowledge: Knowledge, name: str, value: Formula
) -> Decision:
    """Decide a relation where one letter, an angle that stays free otherwise, has a value.

    A letter that stands for a motion is written out first: a(θ) = r ω²(cos θ + λ cos 2θ) at θ = 0.
    """
    try:
        first, second = (
            replace(
                side, readings=tuple(_at_value(node, knowledge, name, value) for node in side.readings)
            )
            for side in (left, right)
        )
    except (NoFormError, TooLargeError) as problem:
        return Decision(UNDECIDED, str(problem))
    return decide(first, second, sign, knowledge)


def _at_value(node: Formula, knowledge: Knowledge, name: str, value: Formula) -> Formula:
    """Return a formula with the letters that depend on another one written out, and that one's value."""
    return substitute(written_out(node, knowledge, name), name, value)


def written_out(node: Formula, knowledge: Knowledge, name: str) -> Formula:
    """Return a formula with the letters that depend on another one written out in it.

    What is differentiated is so first: at θ = 0 the speed is no derivative of a constant.
    """
    values = {**{n: d.node for n, d in knowledge.definitions.items()}, **knowledge.meaning.values}
    for _ in range(DEEPEST):
        if any(isinstance(part, Derivative) for part in walk(node)):
            level = list(knowledge.levels(node))[-1]
            form = knowledge.evaluator(level).form(node)
            above = polynomial_node(form.domain, form.numerator)
            node = Quotient(above, polynomial_node(form.domain, form.denominator))
        depends = [
            n for n in sorted(names(node)) if n in values and name in names_behind(values[n], values)
        ]
        if not depends:
            break
        for letter in depends:
            node = substitute(node, letter, values[letter])
    return node


def _as_printed(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None
) -> Decision | None:
    """Return the proof of a relation of numbers from results as their lines print them, v = … = 628.3.

    None if it needs none, or is not proved so: each may have gone on with all its digits.
    """
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {n for side in (left, right) for n in names_behind(side.node, values)}
    rounded = {n: _printed(knowledge.definitions[n]) for n in sorted(behind) if n in values}
    printed = {name: node for name, node in rounded.items() if node is not None}
    for chosen in [list(printed), *([name] for name in list(printed)[:MOST_ROUNDED])] if printed else []:
        known = knowledge
        for name in chosen:
            definition = replace(knowledge.definitions[name], node=printed[name], numeric=True)
            if Name(name) in (left.node, right.node):  # what x = 10/3 = 3.3 prints is no leave for 3.35
                definition = replace(definition, node=_without_rounding(printed[name]))
            known = known.with_definition(name, definition)
        decision = _decide_as_defined(left, right, sign, known, through)
        if decision.is_proved:
            return decision
    return None


def _within_intervals(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None
) -> Decision | None:
    """Return the proof of a relation of numbers by letters that are only roughly given: b ≈ 40 mm.

    Each is any number that is rounded to the one printed. Where the relation holds with all of them at
    one end or the other, or one side is too small at some ends and too large at others, some such
    numbers make it true. None for others.
    """
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {n for side in (left, right) for n in names_behind(side.node, values)}
    lone = {side.node.name for side in (left, right) if isinstance(side.node, Name)}
    ends = {name: _ends(knowledge.definitions[name]) for name in sorted(behind & values.keys() - lone)}
    rough = {name: both for name, both in ends.items() if both}
    differences: list[float] = []
    for chosen in product(*rough.values()) if 0 < len(rough) <= MOST_ROUNDED else ():
        known = knowledge
        for name, node in zip(rough, chosen, strict=True):
            known = known.with_definition(name, replace(knowledge.definitions[name], node=node))
        decision = _decide_as_defined(left, right, sign, known, through)
        if not decision.is_proved:
            difference = _difference(decision)
            if difference is None:
                return None
            differences.append(difference)
        if decision.is_proved or min(differences) < 0 < max(differences):
            shown = (f"{formula_text(Name(n), plain=True)} is rounded as printed" for n in rough)
            order = decision.order or "the digits printed"
            level = decision.level.assumptions if decision.level else ()
            assumptions = tuple(dict.fromkeys((*decision.assumptions, *level, *shown)))
            return replace(decision, status=PROVED, order=order, witness={}, assumptions=assumptions)
    return None


def _ends(definition: Definition) -> tuple[Formula, ...]:
    """Return the ends of what is rounded to the number that a letter has behind ≈; none for others.

    A single digit is no measure of how exactly it is meant: λ ≈ 0.3 is what a page goes on with.
    """
    whole = definition.node
    node, *unit = whole.factors if isinstance(whole, Product) else (whole,)
    if not definition.is_rough or names(whole) or not isinstance(node, Number):
        return ()
    place = node.last_place or Fraction(1)
    if abs(node.value) < FEWEST_ROUGH * place:
        return ()
    half = place / 2
    ends = (Number(node.value + side * half) for side in (-1, 1))
    return tuple(Product((end, *unit)) if unit else end for end in ends)


def _difference(decision: Decision) -> float | None:
    """Return by how much the left one of two refuted numbers is larger; None for others."""
    try:
        return float(decision.witness["left"]) - float(decision.witness["right"])
    except (KeyError, ValueError):
        return None


def _without_rounding(node: Formula) -> Formula:
    """Return a printed value as the number that it shows: 3.3, and not what is rounded to it."""
    for number in decimals(node):
        node = replace_part(node, number, Number(number.value))
    return node


def _printed(definition: Definition) -> Formula | None:
    """Return a letter's value as it is printed, if that is rounded: 628.3, or a whole number as 628.

    One that ends in 0 is taken as exact.
    """
    node = definition.node
    if definition.rounded is not None or not isinstance(node, Number):
        return definition.rounded
    is_whole = node.last_place is None and node.value.denominator == 1 and node.value >= SMALLEST_ROUNDED
    return Number(node.value, Fraction(1)) if is_whole and node.value % 10 else None


def _on_branch(knowledge: Knowledge, name: str, value: Formula) -> Knowledge:
    definition = replace(knowledge.definitions[name], node=value, alternatives=())
    return knowledge.with_definition(name, definition)


def _decide_as_defined(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None
) -> Decision:
    """Decide in the first pair of readings that proves it; else in the usual ones."""
    first: Decision | None = None
    pairs = list(product(left.readings, right.readings))[:MOST_READINGS]
    for left_node, right_node in pairs:
        decision = decide_reading(left_node, right_node, sign, knowledge, through)
        if decision.is_proved:
            return decision
        first = first or decision
    return first or Decision(UNDECIDED, "nothing to compare")


def decide_reading(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None = None
) -> Decision:
    """Decide left = right or left ≈ right; what is refuted under an open premise is not decided."""
    if not knowledge.has_sums:
        return _decide_under_premises(left, right, sign, knowledge, through)

    def decide_as_known(first: Formula, second: Formula, known: Knowledge) -> Decision:
        return _decide_under_premises(first, second, sign, known, through)

    def decide_written_out(first: Formula, second: Formula) -> Decision:
        known = with_counts(first, second, knowledge)
        return decide_with_whole_numbers(first, second, known, decide_as_known)

    decision = decide_over_cylinders(left, right, knowledge, decide_written_out)
    if decision.is_proved and _takes_complex_as_positive(decision, knowledge):
        decision = Decision(UNDECIDED, "a sum of complex numbers is of no sign")
    if decision.status != UNDECIDED:
        return decision
    return decide_sums_as_letters(left, right, knowledge, decide_as_known) or decision


def _takes_complex_as_positive(decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether a proof assumes the sign of a letter for a sum of complex numbers: Z_n ≥ 0."""
    return any(
        text.startswith((f"{plain_letter(name)} ≥", f"{plain_letter(name)} >"))
        for text in decision.assumptions
        for name, each in knowledge.definitions.items()
        if any(part == Constant("i") for part in walk(each.node))
    )


def _decide_under_premises(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None
) -> Decision:
    decision = _decide_reading(left, right, sign, knowledge, through)
    of_numbers = decision.status == REFUTED and not decision.of_matrices
    if of_numbers and (unknown := _terms_without_values(left, right, knowledge)):
        reason = formula_text(Name(unknown), plain=True) + NO_VALUES_HERE
        return replace(decision, status=UNDECIDED, reason=reason)
    if decision.status == REFUTED and decision.left is not None:
        free = knowledge.angles | {"t"}
        open_premises = [text for text in decision.left.domain.assumptions if may_fail(text, free)]
        domain = decision.left.domain
        unequal = [t for t in domain.assumptions if t == NO_EQUAL_TERMS or t in domain.special]
        if unequal and not _sums(left, right) and _sums(*behind(left, right, knowledge)):
            open_premises.append(unequal[0])
            at_number = _at_a_number(left, right, sign, knowledge, through)
            if at_number is not None:
                return at_number
        if open_premises:
            return replace(decision, status=UNDECIDED, reason=f"differs if {open_premises[0]}; say so")
    return decision


def _sums(*nodes: Formula) -> bool:
    """Tell whether a sum stands in formulas themselves: they are on any number of terms."""
    return any(isinstance(part, Summation) for node in nodes for part in walk(node))


def _at_a_number(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None
) -> Decision | None:
    """Return the proof of a relation for one number of summed terms: three cylinders are special."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {n for node in (left, right) for n in names_behind(node, values)}
    nodes = [left, right, *(values[n] for n in sorted(behind) if n in values)]
    ends = {
        name
        for node in nodes
        for part in walk(node)
        if isinstance(part, Summation) and part.upper is not None
        for name in names(part.upper)
    }
    for name in sorted(ends) if len(ends) == 1 else ():
        for count in range(2, MOST_COUNTED + 1):
            number = Definition(Number(Fraction(count)), 0)
            decision = _decide_reading(
                left, right, sign, knowledge.with_definition(name, number), through
            )
            if decision.is_proved:
                assumption = f"{formula_text(Name(name), plain=True)} = {count}"
                return replace(decision, assumptions=(*decision.assumptions, assumption))
    return None


def _terms_without_values(left: Formula, right: Formula, knowledge: Knowledge) -> str:
    """Return a letter that carries the index of a sum, δ_i, and has values only in words; "" for none."""
    own = names(left) | names(right)
    for part in (*walk(left), *walk(right)):
        if isinstance(part, Summation) and part.index is not None:
            for name in indexed_letters(part.body, part.index.name):
                own_values = knowledge.definitions.get(name)
                if own_values is not None and part.index.name in names(own_values.node):
                    continue  # α_k = 2πk/3 says what each is
                stem = name[: -len(part.index.name)]
                others = {*own, *knowledge.definitions} - {name}
                if not any(n.startswith(stem) and n[len(stem) :].isdecimal() for n in others):
                    return name
    return ""


def _decide_of_its_own(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None
) -> Decision | None:
    """Return the decision on matrices, integrals without bounds, or powers of a letter; else None."""
    if is_of_matrices(left, right, knowledge):
        return decide_matrices(left, right, sign, knowledge)

    def decide_derivatives(one: Formula, other: Formula, known: Knowledge) -> Decision:
        return _decide_reading(one, other, sign, known, through)

    by_derivatives = decide_antiderivatives(left, right, knowledge, decide_derivatives)
    if by_derivatives is not None or not states_powers(left, right):
        return by_derivatives
    return decide_powers(left, right, sign, knowledge)


def _decide_reading(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None
) -> Decision:
    of_its_own = _decide_of_its_own(left, right, sign, knowledge, through)
    if of_its_own is not None:
        return of_its_own
    if has_branches(left, right, knowledge):

        def decide_branch(one: Formula, other: Formula, known: Knowledge) -> Decision:
            return decide_reading(one, other, sign, known, through)

        return decide_branches(left, right, knowledge, decide_branch)
    by_steps = decide_by_induction(left, right, knowledge)
    if by_steps is not None:
        return by_steps if by_steps.is_proved else _by_closed_form(left, right, knowledge) or by_steps
    (bare_left, left_is_cut), (bare_right, right_is_cut) = without_dots(left), without_dots(right)
    if sign == "≈" or left_is_cut or right_is_cut or through is not None:
        decision = decide_agreement(
            left, right, knowledge, through=through, loose=left_is_cut or right_is_cut
        )
        is_of_open = has_open_numbers(left) or has_open_numbers(right)
        if decision.status == REFUTED and is_of_open:
            decision = Decision(UNDECIDED, NUMBERS_WITHOUT_END)
        is_plain = sign == "≈" and through is None and not (left_is_cut or right_is_cut)
        jointly = is_plain and not decision.is_proved and decide_jointly(left, right, knowledge)
        return jointly or decision
    return _by_series_where_cut(left, right, decide_equality(bare_left, bare_right, knowledge), knowledge)


def _by_series_where_cut(
    left: Formula, right: Formula, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on an = that is refuted, by series where ≈ may be meant."""
    if decision.status != REFUTED or not _is_cut_off(left, decision, knowledge):
        return decision
    by_series = decide_agreement(left, right, knowledge)
    if (
        by_series.is_proved
        and by_series.assumptions != decision.assumptions
        and _rests_on_size(by_series)
    ):
        return decision
    if by_series.is_proved and by_series.through is not None:
        return replace(by_series, reason=by_series.reason or MEANT_ROUGHLY)
    # two numbers behind = are the same to their digits: no share of them is left out as of a series
    is_of_numbers = by_series.through is None and not names(right)
    is_by_series = (by_series.is_proved and not is_of_numbers) or by_series.through
    return by_series if is_by_series else decision


def _rests_on_size(decision: Decision) -> bool:
    """Tell whether an agreement assumes that a letter is small, which = does not say."""
    return any(text.endswith((IS_SMALL, IS_LARGE)) for text in decision.assumptions)


def _by_closed_form(left: Formula, right: Formula, knowledge: Knowledge) -> Decision | None:
    """Decide by the closed form of sums whose bounds are whole numbers; None without one."""
    parts = [part for node in (left, right) for part in walk(node)]
    if any(isinstance(part, Dots) for part in parts):
        return None
    decision = decide_equality(left, right, knowledge)
    return None if decision.left is None else decision


def _is_cut_off(node: Formula, decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether = stands between an exact form and its series, cut off: then ≈ is meant.

    The exact form is one that is no polynomial in the ratio, or a letter of known meaning.
    """
    if (
        knowledge.crank is None
        or knowledge.crank.small is None
        or not decision.left
        or not decision.right
    ):
        return False
    letter, sign = knowledge.crank.small
    has_meaning = isinstance(node, Name) and node.name in knowledge.meaning.values
    exact = has_meaning or degree(decision.left, letter, sign) is None
    return exact and degree(decision.right, letter, sign) is not None
