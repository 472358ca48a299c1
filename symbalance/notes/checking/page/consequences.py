"""What a page says to follow from the relation just before it, or to be equivalent to it, judged as that.

Only where nothing but "hence" or an arrow stands between: else words may bring in what it takes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import (
    Apply,
    Call,
    Constant,
    Derivative,
    Evaluation,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision, decide_equality
from symbalance.notes.checking.deciding.implications import point_text, range_that_fails, solution_lost
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Knowledge, StatedRange
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, RANGE
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_ANGLE = re.compile(
    r"[\s$]*(?P<degrees>[0-9]{1,3}(?:\.[0-9]{1,4})?)\s?(?:°|\^\s?\\circ(?![A-Za-z])|\^\s?\{\s?\\circ\s?\})"
)
_GIVES = re.compile(
    r"[\s$,]*(?:(?:which|this|that|it|das|daraus|ce\s+qui|il)\s+)?(?:gives?|yields?|follows(?:\s+that)?|means(?:\s+that)?|implies|we\s+get"
    r"|ergibt|folgt|liefert|heißt|donne|vient|dà|da|segue|significa)[\s$,]*",
    re.IGNORECASE,
)
"""Words alone between a range and what it comes to."""


def decide_consequence(
    document: ReadNotes,
    sections: Sections,
    chain: Chain,
    decision: Decision,
    knowledge: Knowledge,
    k: int = 0,
) -> Decision:
    """Return the decision on a relation as what follows from the one before, where it is not: x > 5.

    Else the decision as it is.
    """
    follows = sections.is_consequence(chain) and sections.follows_at_once(chain)
    follows = follows or _is_given_by_range(sections, chain)
    is_converse = sections.is_converse(chain)
    # a rate follows from how a quantity is defined, not from one of its values
    is_rate = any(isinstance(part, Derivative) for side in chain.sides for part in walk(side.node))
    before = sections.chain_before(chain.start) if (follows or is_converse) and not is_rate else None
    if before is None or not (_is_one_statement(before) and _is_one_statement(chain)):
        return decision
    sign, first = chain.relations[k].sign, before.relations[0].sign
    is_lone = len(before.relations) == len(chain.relations) == 1
    judged = decision
    if is_converse:
        judged = _converse(before, chain, decision, knowledge) if is_lone else decision
    elif sign in SATISFIED_BY and first in SATISFIED_BY and decision.status == RANGE:
        judged = _range_after_range(sections, before, chain, decision, knowledge, k)
    elif is_lone and sign == "=" and first in SATISFIED_BY and decision.status in (DEFINITION, CONDITION):
        judged = _equation_after_range(before, chain, decision, knowledge)
    elif is_lone and sign == "=" == first and decision.status != REFUTED:
        judged = _equation_after_equation(sections, before, chain, decision, knowledge)
    return judged


def _is_given_by_range(sections: Sections, chain: Chain) -> bool:
    """Tell whether a range stands right behind one that is said to give it: 3 - 2x < 7 gives x > -2."""
    before = sections.chain_before(chain.start)
    if before is None or not before.letters >= chain.letters or len(chain.letters) != 1:
        return False
    is_range = all(r.sign in SATISFIED_BY for c in (before, chain) for r in c.relations)
    return is_range and _GIVES.fullmatch(sections.document.text, before.end, chain.start) is not None


def _is_one_statement(chain: Chain) -> bool:
    """Tell whether a chain is one relation, or a range: 0.25 ≤ λ ≤ 0.3."""
    return len(chain.relations) == 1 or all(r.sign in SATISFIED_BY for r in chain.relations)


def _converse(before: Chain, chain: Chain, decision: Decision, knowledge: Knowledge) -> Decision:
    """Refute x = 1 ⇐ x² = 1, by what satisfies the second relation and not the first."""
    own, earlier = _stated(chain), _stated(before)
    if own.sign in SATISFIED_BY and earlier.sign in SATISFIED_BY:
        given = [r for r in knowledge.ranges if not _same(r, earlier) and not _same(r, own)]
        witness = range_that_fails(earlier, [*given, own], knowledge)
        return decision if witness is None else Decision(REFUTED, _not_from_it(earlier), witness=witness)
    if own.sign != "=" or earlier.sign != "=":
        return decision
    stated = names(own.left) | names(own.right) | names(earlier.left) | names(earlier.right)
    lines = {before.lines[0], chain.lines[0]}
    others = {n: d for n, d in knowledge.definitions.items() if n not in stated or d.line not in lines}
    free = replace(knowledge, definitions=others)
    point = solution_lost((own.left, own.right), (earlier.left, earlier.right), free)
    if point is None:
        return decision
    return Decision(REFUTED, f"{point_text(point)} satisfies it, but not {earlier.text}")


def _not_from_it(earlier: StatedRange) -> str:
    return f"{earlier.text} does not follow from it"


def _stated(chain: Chain, k: int = 0) -> StatedRange:
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    return StatedRange(left, chain.relations[k].sign, right, chain.lines[0])


def _as_rounded(stated: StatedRange) -> StatedRange:
    """Return a range with its printed decimals half a place wider: 1/λ ≤ 3.8 where it is up to 3.846."""
    sign = stated.sign
    widening = {"<": (-1, 1), "≤": (-1, 1), ">": (1, -1), "≥": (1, -1)}.get(sign, (0, 0))
    left, right = (
        replace(node, value=node.value + way * node.last_place / 2)
        if isinstance(node, Number) and node.last_place is not None
        else node
        for node, way in zip((stated.left, stated.right), widening, strict=True)
    )
    return replace(stated, left=left, right=right)


def _range_after_range(
    sections: Sections,
    before: Chain,
    chain: Chain,
    decision: Decision,
    knowledge: Knowledge,
    k: int = 0,
) -> Decision:
    own, earlier = _stated(chain, k), _stated(before)
    own = own if len(chain.relations) == 1 else _as_rounded(own)
    given = [r for r in knowledge.ranges if r.line <= chain.lines[0] and not _same(r, _stated(chain, k))]
    witness = _fails_by_formula(own, earlier, knowledge) if len(chain.relations) == 1 else None
    stated = [_stated(before, n) for n in range(len(before.relations))]
    is_stated = all(any(_same(r, each) for r in given) for each in stated)
    if not is_stated and witness is None:
        return decision
    text = ", ".join(each.text for each in stated)
    by_formula, witness = witness, witness or range_that_fails(own, given, knowledge)
    positive = "" if by_formula or not witness else _letters_that_are_positive(own, given, knowledge)
    if positive:
        return Decision(UNDECIDED, f"follows from {text} only if {positive}: say so")
    if witness is not None:
        return Decision(REFUTED, f"does not follow from {text}", witness=witness)
    if sections.is_equivalence(chain) and len(stated) == 1:
        others = [r for r in given if not _same(r, earlier)]
        every = [own, *(_stated(chain, n) for n in range(len(chain.relations)) if n != k)]
        witness = range_that_fails(earlier, [*others, *every], knowledge)  # |x| < 2 ⇔ -2 < x < 2
        if witness is not None:
            return Decision(REFUTED, _not_from_it(earlier), witness=witness)
    return decision


def _letters_that_are_positive(own: StatedRange, given: list[StatedRange], knowledge: Knowledge) -> str:
    """Return what nobody has said of letters and would prove a range: λ > 0 for λ² ≤ 0.09."""
    letters = sorted((names(own.left) | names(own.right)) - knowledge.meanings.keys() - knowledge.angles)
    above_zero = [StatedRange(Name(n), ">", Number(Fraction(0)), 0) for n in letters]
    if not letters or range_that_fails(own, [*given, *above_zero], knowledge) is not None:
        return ""
    below = StatedRange(Name(letters[0]), "<", Number(Fraction(0)), 0)
    if len(letters) == 1 and range_that_fails(below, [*given, *above_zero], knowledge) is None:
        return ""  # of -4y ≥ 8 no positive y is left, of which anything would be true
    return ", ".join(each.text for each in above_zero)


def _fails_by_formula(own: StatedRange, earlier: StatedRange, knowledge: Knowledge) -> Any:
    """Return a point at which ΔJ < 0 and not k² < a b, where the page has ΔJ = m (k² − a b); or None.

    Letters stand for their formulas, not for the numbers of an example, and sizes are positive.
    """
    head = earlier.left
    if not isinstance(head, Name) or names(earlier.right) or head.name not in knowledge.formulas:
        return None
    formulas = {name: d.node for name, d in knowledge.formulas.items()}
    behind = {*names_behind(head, formulas)}
    stated = names(own.left) | names(own.right)
    if not stated <= behind or head.name in stated or (behind | stated) & knowledge.angles:
        return None
    definitions = {n: d for n, d in knowledge.formulas.items() if n in behind}
    meaning = replace(knowledge.meaning, positive=knowledge.meaning.positive | (behind - {head.name}))
    zero = Number(Fraction(0))
    sizes = [StatedRange(Name(n), ">", zero, 0) for n in sorted(behind - {head.name})]
    known = replace(knowledge, definitions=definitions, meaning=meaning)
    return range_that_fails(own, [earlier, *sizes], known)


def _same(one: StatedRange, other: StatedRange) -> bool:
    return (one.left, one.sign, one.right) == (other.left, other.sign, other.right)


def _equation_after_range(
    before: Chain, chain: Chain, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Refute x ≥ 1, therefore x = 1, unless the ranges leave one value: for 1 ≤ x and x ≤ 1."""
    left, right = chain.sides[0].node, chain.sides[1].node
    own, earlier = names(left) | names(right), _stated(before)
    if own != names(earlier.left) | names(earlier.right) or len(own) != 1:
        return decision
    (name,) = own
    others = {n: d for n, d in knowledge.definitions.items() if n != name}
    free = replace(knowledge, definitions=others)
    given = [r for r in knowledge.ranges if names(r.left) | names(r.right) == own]
    witness = range_that_fails(StatedRange(left, "≤", right, 0), given, free)
    witness = witness or range_that_fails(StatedRange(left, "≥", right, 0), given, free)
    if witness is None:
        return decision
    return Decision(REFUTED, f"does not follow from {earlier.text}", witness=witness)


def _equation_after_equation(
    sections: Sections, before: Chain, chain: Chain, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Refute an equivalence one of whose sides has more solutions; doubt x y = 0 ⇒ x = 0."""
    first = before.sides[0].node, before.sides[1].node
    second = chain.sides[0].node, chain.sides[1].node
    lines = {before.lines[0], chain.lines[0]}
    given = names(first[0]) | names(first[1])
    others = {n: d for n, d in knowledge.definitions.items() if n not in given or d.line not in lines}
    knowledge = replace(knowledge, definitions=others)
    is_value = any(_is_at_place(part) for node in second for part in walk(node))
    lost = None if is_value else solution_lost(first, second, knowledge)  # f(x) = x², then f(-2) = 4
    if sections.is_equivalence(chain):
        return _equivalence(first, second, lost, decision, knowledge)
    if lost is not None and decision.is_proved and (other := _ANGLE.match(sections.behind_or(chain))):
        return _with_other_angle(Fraction(other["degrees"]), first, second, decision, knowledge)
    if lost is not None and decision.is_proved:
        is_one = sections.is_one_of_several(chain)  # x = 2 or x = 0
        return decision if is_one else _where_nothing_vanishes(lost, first, second, decision, knowledge)
    own = given | names(second[0]) | names(second[1])
    is_bare = all(isinstance(node, Name) for node in second) and own.isdisjoint(knowledge.meanings)
    if lost is None or decision.status != PREMISE or (_differs_in_sign(lost, second) and not is_bare):
        # Of a length the positive root is meant; of bare a and b, of which nothing is said, neither.
        return decision
    is_free = bool(names(second[1])) or second[1] == Number(Fraction(0))
    is_one = bool(own & knowledge.angles) or sections.is_one_of_several(chain)
    if not is_free or is_one:
        return decision
    return replace(decision, status=UNDECIDED, reason=_too(lost, first))


def _is_at_place(part: Formula) -> bool:
    """Tell whether a part is a value at a place: f(-2), f at x = -2."""
    return isinstance(part, Evaluation) or (isinstance(part, Apply) and part.function == "at")


def _with_other_angle(
    degrees: Fraction,
    first: tuple[Formula, Formula],
    second: tuple[Formula, Formula],
    decision: Decision,
    knowledge: Knowledge,
) -> Decision:
    """Refute the second of two angles said to solve an equation: tan θ = -1, θ = 135° or 225°."""
    head, angle = second[0], Product((Number(degrees / 180), Constant("pi")))
    if not isinstance(head, Name):
        return decision
    try:
        left, right = (substitute(node, head.name, angle) for node in first)
    except NoFormError:
        return decision
    if degrees.denominator == 1 and decide_equality(left, right, knowledge).status == REFUTED:
        return Decision(
            REFUTED, f"{plain_letter(head.name)} = {degrees}° does not satisfy {_text(first)}"
        )
    return decision


def _equivalence(
    first: tuple[Formula, Formula],
    second: tuple[Formula, Formula],
    lost: Mapping[str, Formula] | None,
    decision: Decision,
    knowledge: Knowledge,
) -> Decision:
    """Refute an equivalence by a solution of one of the two equations alone.

    A further angle is no reason: cos² = sin² has several, and the text says between which it lies.
    """
    gained = None if lost is not None else solution_lost(second, first, knowledge)
    if lost is None and gained is None:
        return decision
    point = lost or gained or {}
    parts = [part for node in (*first, *second) for part in walk(node)]
    angles = {n for part in parts if isinstance(part, Call) for n in names(part.argument)}
    if lost is not None:
        reason = _too(lost, first)
    else:
        reason = f"{point_text(point)} satisfies it, but not {_text(first)}"
    if angles and point.keys() <= angles:
        return Decision(UNDECIDED, f"{reason}: say where the angle lies")
    return Decision(REFUTED, reason)


def _too(point: Mapping[str, Formula], equation: tuple[Formula, Formula]) -> str:
    return f"{point_text(point)} satisfies {_text(equation)} too"


def _text(equation: tuple[Formula, Formula]) -> str:
    return " = ".join(formula_text(node, plain=True) for node in equation)


def _where_nothing_vanishes(
    lost: Mapping[str, Formula],
    first: tuple[Formula, Formula],
    second: tuple[Formula, Formula],
    decision: Decision,
    knowledge: Knowledge,
) -> Decision:
    """Return a proof that has divided by a letter as what it is: x y = x c gives y = c if x ≠ 0."""
    if _differs_in_sign(lost, second):
        condition = f"{formula_text(second[0], plain=True)} ≥ 0"
        return replace(decision, assumptions=(*decision.assumptions, condition))
    zeros = [n for n, value in lost.items() if value == Number(Fraction(0)) and second[0] != Name(n)]
    for chosen in [*([name] for name in zeros), zeros] if zeros else []:
        meaning = replace(knowledge.meaning, positive=knowledge.meaning.positive | {*chosen})
        if solution_lost(first, second, replace(knowledge, meaning=meaning)) is None:
            conditions = tuple(f"{formula_text(Name(n), plain=True)} ≠ 0" for n in chosen)
            return replace(decision, assumptions=(*decision.assumptions, *conditions))
    return Decision(UNDECIDED, _too(lost, first))


def _differs_in_sign(lost: Mapping[str, Formula], second: tuple[Formula, Formula]) -> bool:
    """Tell whether a solution that an equation leaves out is minus the one that it gives: x = -y."""
    value = second[1]
    for name, own in lost.items():
        try:
            value = substitute(value, name, own)
        except NoFormError:
            return False
    head = second[0]
    if not isinstance(head, Name) or head.name not in lost:
        return False
    return decide_equality(lost[head.name], Negative(value), Knowledge()).is_proved
