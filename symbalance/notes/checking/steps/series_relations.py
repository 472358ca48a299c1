"""Series with letters as coefficients, x = a_0 + a_1 cos θ + …, and what is said of those letters."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.meant.meant_extremes import decide_meant_extreme
from symbalance.notes.checking.meant.signs_in_series import coefficients_beside_first
from symbalance.notes.checking.motions.extreme_sizes import decide_largest_size
from symbalance.notes.checking.motions.extremes import decide_extreme, decide_place
from symbalance.notes.checking.motions.named_extremes import base_of_extreme, decide_named_extreme
from symbalance.notes.checking.motions.series_coefficients import (
    coefficient_values,
    decide_coefficient,
    exact_value,
    is_known_roughly,
)
from symbalance.notes.checking.steps.formulas_of_angles import with_formula_above
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.letters_below import with_letters_below
from symbalance.notes.checking.steps.relation_fixes import add_fix_of_relation
from symbalance.notes.checking.verdicts import PREMISE, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.case_words import numbers_of_several
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_OF_ALL = re.compile(
    r"(?<![A-Za-z])(?:all|total|whole|together|sum|per|each|mean|average|allowed|permissible|limit|zusammen|gesamt\w*"
    r"|alle[nr]?|Summe|je|zulässig\w*|mittler\w*)(?![A-Za-z])|合計|全体|許容|平均|各",
    re.IGNORECASE,
)
"""Words with which a largest value is of something else than the formula before it."""


def judge_series(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | None:
    """Return the verdict on a series with letters as its coefficients, or on what is said of one."""
    decision = _by_coefficients(state, chain, k, knowledge)
    if decision is None and not k and chain.relations[0].sign in "=≈":
        extreme = decide_extreme(chain.sides[0], chain.sides[1], chain.relations[0].sign, knowledge)
        name, value = chain.sides[0].node, without_dots(chain.sides[1].node)[0]
        size = decide_largest_size(chain.sides[0], chain.sides[1], chain.relations[0].sign, knowledge)
        if size is not None:
            return describe(state.document, chain, k, size)
        if extreme is not None:
            extreme = decide_place(extreme, chain, state.document, knowledge)
        else:
            extreme = decide_meant_extreme(state.meant, chain, state.document, knowledge)
            extreme = extreme or _extreme_of_formula(state, chain, knowledge)
        if extreme is not None and isinstance(name, Name):
            if extreme.status != REFUTED:  # what rests on a wrong one would confirm it
                state.definitions.define(name.name, value, chain)
            return describe(state.document, chain, k, extreme)
    if decision is None:
        return None
    verdict = describe(state.document, chain, k, decision)
    others = {n: d for n, d in knowledge.definitions.items() if not d.is_coefficient}
    left = Side((exact_value(decision),), chain.sides[k].span)
    return add_fix_of_relation(
        state, verdict, chain, k, left, decision, replace(knowledge, definitions=others)
    )


def _extreme_of_formula(state: JudgingState, chain: Chain, knowledge: Knowledge) -> Decision | None:
    """Decide the largest or least value of a letter with a formula of the same section and engine."""
    head = chain.sides[0].node
    definition = knowledge.definitions.get(base_of_extreme(head.name)) if isinstance(head, Name) else None
    words = state.sections.sentence_leading_to(chain)
    if numbers_of_several(words) or _OF_ALL.search(words):
        return None
    is_here = definition is not None and state.sections.same_section(definition.line, chain.lines[0])
    decision: Decision | None = None
    if definition is not None and is_here:
        if state.sections.is_of_another_engine(chain, definition.line):
            return None
        decision = decide_named_extreme(chain, knowledge)
    if decision is None and (known := with_formula_above(state, chain, knowledge)) is not None:
        decision = decide_named_extreme(chain, known)
    return decision


def _by_coefficients(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a series with letters as its coefficients, or on what is said of one.

    None for other relations.
    """
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    of_matrices = is_of_matrices(left.node, right.node, knowledge)
    if chain.relations[k].is_demanded or sign not in "=≈" or of_matrices:
        return None
    if k == 0 and isinstance(left.node, Name):
        definition = knowledge.definitions.get(left.node.name)
        if definition is not None and definition.is_coefficient:
            return decide_coefficient(left, right, sign, knowledge)
    in_use = state.definitions.letters_before(chain.lines[0])
    is_rough, on_page = sign == "≈", state.letters
    fixed = coefficient_values(
        left.node, right.node, knowledge, in_use, on_page=on_page, is_rough=is_rough
    )
    if fixed is None:
        return _another_series(state, chain, k, knowledge) or _open_series(state, chain, k, knowledge)
    texts = ", ".join(plain_text(Name(name)) for name in sorted(fixed))
    case = Decision(PREMISE, f"read as what fixes {texts}: the coefficients of the other side")
    refuted = Decision(REFUTED)
    by_lines_below = with_letters_below(state, chain, k, refuted, knowledge)
    state.definitions.fix_coefficients(fixed, chain)
    return by_lines_below if by_lines_below.is_proved else case


def _open_series(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return that a series names its coefficients, where its other side is known roughly or not at all.

    With a ≈ r ω² (cos θ + λ cos 2θ) above, a = r ω² (cos θ + A_2 cos 2θ + A_4 cos 4θ + …) is the better
    one, and no equation for its letters.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    for series, other in ((right, left), (left, right)):
        fresh = coefficients_beside_first(series) - names(other)
        is_known = any(n in knowledge.definitions or knowledge.has_meaning(n) for n in fresh)
        formulas = [n for n in names(other) if (d := knowledge.definitions.get(n)) and not d.numeric]
        is_other_open = not formulas and not isinstance(other, Name)
        if fresh and not is_known and (is_other_open or is_known_roughly(other, knowledge)):
            texts = ", ".join(plain_text(Name(name)) for name in sorted(fresh))
            return Decision(PREMISE, f"names its coefficients {texts}")
    return None


def _another_series(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a second series with the letters of an earlier one.

    In another section they are new ones.
    """
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    own = names(left.node) | names(right.node)
    earlier = {n: d for n, d in knowledge.definitions.items() if d.is_coefficient and n in own}
    if not earlier or decide(left, right, sign, knowledge).is_proved:
        return None
    others = {n: d for n, d in knowledge.definitions.items() if n not in earlier}
    without = replace(knowledge, definitions=others)
    fixed = coefficient_values(
        left.node, right.node, without, on_page=state.letters, is_rough=sign == "≈"
    )
    if fixed is None:
        return None
    line = max(d.line for d in earlier.values())
    texts = ", ".join(plain_text(Name(name)) for name in sorted(earlier))
    if state.sections.same_section(line, chain.lines[0]):
        return Decision(UNDECIDED, f"{texts} are the coefficients of line {line}, or new ones: say so")
    state.definitions.fix_coefficients(fixed, chain)
    return Decision(PREMISE, f"read as what fixes {texts} anew: the coefficients of the other side")
