"""Relations that say several things at once: both signs of ±, Kronecker's delta, cases.

A relation with ± is two relations, the upper signs together and the lower ones; with δ_mn it is one for
m = n and one for m ≠ n; with cases one for each. It is proved if all of them are, refuted if one is.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import (
    Apply,
    Cases,
    Evaluation,
    Formula,
    Name,
    Negative,
    Number,
    PlusMinus,
    Product,
    Sum,
    with_parts_changed,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.special_values import ANY_WHOLE
from symbalance.notes.algebra.tree_values import TreeValues, sample_trees
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    digits,
    printed_decimal,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import replace_part, substitute, with_every
from symbalance.notes.checking.words.plain_formulas import plain_text

MOST_BRANCHES = 16


@dataclass(frozen=True, slots=True)
class Branch:
    """One of the relations: its two sides, what it is, and whether a witness is one of the branch."""

    left: Formula
    right: Formula
    knowledge: Knowledge
    title: str
    is_exact: bool = True
    condition: str = ""
    regions: tuple[tuple[str, Formula, str], ...] = ()
    """Letters bound by < or >, what each is put as, and the letter, positive, that this is put in."""


Decide = Callable[[Formula, Formula, Knowledge], Decision]


def has_branches(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a relation says several things at once."""
    return next(_parts(left, right), None) is not None or any(
        next(_parts(knowledge.definitions[name].node), None) is not None
        for name in formula.names(left) | formula.names(right)
        if name in knowledge.definitions
    )


def _parts(*nodes: Formula) -> Iterator[Formula]:
    for node in nodes:
        for part in formula.parts_of_kind(node, PlusMinus, Cases, Apply):
            is_delta = isinstance(part, Apply) and part.function == "kronecker"
            if isinstance(part, PlusMinus | Cases) or (is_delta and formula.names(part)):
                yield part


def decide_branches(left: Formula, right: Formula, knowledge: Knowledge, decide: Decide) -> Decision:
    """Decide a relation by its branches, each by `decide`."""
    # x = ±1 and y = ±2 do not say which signs belong together: neither xy = 2 nor xy = −2 follows.
    used = (formula.names(left) | formula.names(right)) & set(_signed_definitions(knowledge))
    if len(used) > 1:
        reason = f"{' and '.join(sorted(used))} have signs of their own: say which belong together"
        return Decision(UNDECIDED, reason)
    try:
        branches = _split(left, right, knowledge)
    except NoFormError as problem:
        return Decision(UNDECIDED, str(problem))
    decisions = [(branch, decide(branch.left, branch.right, branch.knowledge)) for branch in branches]
    decisions = [(branch, _in_its_region(branch, decision)) for branch, decision in decisions]
    either = _one_of_two(left, right, decisions, decide)
    if either is not None:
        return either
    assumptions: dict[str, None] = {}
    for branch, decision in decisions:
        if decision.status == REFUTED and branch.is_exact:
            return _in_own_letters(branch, decision)
    for branch, decision in decisions:
        if not decision.is_proved:
            reason = decision.reason or "not proved where the condition holds"
            return Decision(UNDECIDED, f"{branch.title}: {reason}", level=decision.level)
        own = [text for text in decision.assumptions if text != branch.condition]
        assumptions |= dict.fromkeys(own)
    orders = [decision.order for _, decision in decisions if decision.order]
    last = decisions[-1][1]
    return Decision(
        PROVED, order=orders[0] if orders else "", assumptions=tuple(assumptions), level=last.level
    )


def _in_its_region(branch: Branch, decision: Decision) -> Decision:
    """Return a proof that needs more than its case's condition as what it is within the condition.

    |x| = x for x > -1 rests on -1 + s ≥ 0 with s > 0: false where that is, true if it always is.
    """
    inner = {letter for _, _, letter in branch.regions}
    open_texts = [text for text in decision.assumptions if any(letter in text for letter in inner)]
    if not decision.is_proved or not open_texts:
        return decision
    meaning = branch.knowledge.meaning
    wide = {letter: BEYOND for letter in inner if letter not in meaning.integer}
    meaning = replace(meaning, ranges={**meaning.ranges, **wide})
    sides = [branch.left, branch.right]
    places = [value for _, value, _ in branch.regions]
    for point, row in sample_trees([*sides, *places], meaning, count=POINTS, tries=2 * POINTS):
        left, right, *reached = row
        allowed = all(
            name not in meaning.positive or number.real > 0
            for (name, _, _), number in zip(branch.regions, reached, strict=True)
        )
        if allowed and abs(left - right) > 1e-12 * max(1, abs(left), abs(right)):
            witness = {n: printed_decimal(v) for n, v in point.items()}
            witness |= {"left": digits(left), "right": digits(right)}
            return Decision(REFUTED, level=decision.level, witness=witness)
    implied = {
        f"{formula_text(side, plain=True)} ≥ 0" for side in sides if _is_never_negative(side, branch)
    }
    if all(text in implied for text in open_texts):
        kept = tuple(text for text in decision.assumptions if text not in open_texts)
        return replace(decision, assumptions=kept)
    return replace(decision, status=UNDECIDED, reason="not proved wherever the condition holds")


def _is_never_negative(node: Formula, branch: Branch) -> bool:
    """Tell whether a formula is a sum of products of positive letters with positive numbers."""
    try:
        form = branch.knowledge.evaluator(next(branch.knowledge.levels(node))).form(node)
    except (NoFormError, TooLargeError):
        return False
    generators = form.domain.generators
    return form.is_polynomial and all(
        coefficient > 0 and all(generators[g].positive for g, _ in monomial)
        for monomial, coefficient in form.numerator.items()
    )


def _in_own_letters(branch: Branch, decision: Decision) -> Decision:
    """Return a refutation with its case named and its witness in the page's letters."""
    witness = dict(decision.witness)
    for name, value, letter in reversed(branch.regions):
        if letter in witness:
            known = {n: Fraction(v) for n, v in witness.items() if n not in ("left", "right")}
            try:
                number = TreeValues(branch.knowledge.meaning, known).value(value).real
            except (NoFormError, KeyError, ValueError, ZeroDivisionError):
                continue
            del witness[letter]
            witness = {name: digits(number, 6)} | witness
    reason = f"{branch.title}: {decision.reason}".rstrip(": ")
    return replace(decision, reason=reason, witness=witness)


BEYOND = (1, 700)
"""How far beyond a case's limit points are tried, in hundredths: near it, and past a turn."""
POINTS = 40


def _one_of_two(
    left: Formula, right: Formula, decisions: list[tuple[Branch, Decision]], decide: Decide
) -> Decision | None:
    """Decide cos α = ±√(1 - sin²α), where one of the two signs holds: (l - r_1)(l - r_2) is 0.

    Where ± stands on both sides, or one sign holds whatever the letters, it is no such relation.
    """
    sides = [any(isinstance(part, PlusMinus) for part in formula.walk(side)) for side in (left, right)]
    if len(decisions) != 2 or all(sides) or not any(sides):
        return None
    if all(d.is_proved for _, d in decisions) or any(
        d.is_proved and not d.assumptions for _, d in decisions
    ):
        return None
    gaps = [Sum((branch.left, Negative(branch.right))) for branch, _ in decisions]
    decision = decide(Product(tuple(gaps)), formula.number(0), decisions[0][0].knowledge)
    return replace(decision, reason="with one of the two signs") if decision.is_proved else None


def _split(left: Formula, right: Formula, knowledge: Knowledge) -> list[Branch]:
    waiting, result = [Branch(left, right, knowledge, "")], []
    while waiting:
        branch = waiting.pop(0)
        if len(waiting) + len(result) > MOST_BRANCHES:
            raise NoFormError("more cases at once than are tried")
        branch = _with_cases_of_letters(branch)
        parts = list(_parts(branch.left, branch.right))
        signed = [part for part in parts if isinstance(part, PlusMinus)]
        if (signed or _signed_definitions(branch.knowledge)) and (signed or _uses_signs(branch)):
            waiting += [_with_sign(branch, sign) for sign in (1, -1)]
            continue
        if not parts:
            result.append(branch)
        elif isinstance(parts[0], Cases):
            waiting += _of_cases(branch, parts[0])
        else:
            waiting += _of_delta(branch, parts[0])
    return result


def _with_cases_of_letters(branch: Branch) -> Branch:
    """Put cases in for the letters that are defined by them."""
    left, right = (_with_places(side, branch.knowledge) for side in (branch.left, branch.right))
    for name in sorted(formula.names(left) | formula.names(right)):
        definition = branch.knowledge.definitions.get(name)
        if definition is not None and any(not isinstance(p, PlusMinus) for p in _parts(definition.node)):
            left, right = (substitute(side, name, definition.node) for side in (left, right))
    return replace(branch, left=left, right=right)


def _signed_definitions(knowledge: Knowledge) -> list[str]:
    return [
        name
        for name, definition in knowledge.definitions.items()
        if any(isinstance(part, PlusMinus) for part in formula.walk(definition.node))
    ]


def _uses_signs(branch: Branch) -> bool:
    names = formula.names(branch.left) | formula.names(branch.right)
    return bool(names & set(_signed_definitions(branch.knowledge)))


def with_sign(node: Formula, sign: int) -> Formula:
    """Return a formula with its upper signs, or with the lower ones (`sign` -1).

    >>> with_sign(PlusMinus(Name("x"), -1), 1) == Negative(Name("x"))
    True
    """
    if isinstance(node, PlusMinus):
        inside = with_sign(node.operand, sign)
        return inside if node.upper == sign else Negative(inside, span=node.span)
    return formula.with_parts_changed(node, lambda part: with_sign(part, sign))


def _with_sign(branch: Branch, sign: int) -> Branch:
    definitions = {
        name: replace(definition, node=with_sign(definition.node, sign))
        for name, definition in branch.knowledge.definitions.items()
    }
    left, right = (with_sign(side, sign) for side in (branch.left, branch.right))
    title = _joined(branch.title, "with the upper signs" if sign > 0 else "with the lower signs")
    knowledge = replace(branch.knowledge, definitions=definitions)
    return replace(branch, left=left, right=right, knowledge=knowledge, title=title)


def _joined(title: str, more: str) -> str:
    return f"{title}, {more}" if title else more


def _of_delta(branch: Branch, delta: Formula) -> list[Branch]:
    assert isinstance(delta, Apply)
    first, second = delta.arguments
    letter, value = (first, second) if isinstance(first, Name) else (second, first)
    if not isinstance(letter, Name) or letter.name in formula.names(value):
        raise NoFormError("Kronecker's delta of indices that are no letters")
    one, nothing = Number(formula.number(1).value), Number(formula.number(0).value)
    texts = [formula_text(part, plain=True) for part in (first, second)]
    equal = [
        substitute(with_every(side, delta, one), letter.name, value)
        for side in (branch.left, branch.right)
    ]
    unequal = [with_every(side, delta, nothing) for side in (branch.left, branch.right)]
    return [
        replace(branch, left=equal[0], right=equal[1], title=_joined(branch.title, " = ".join(texts))),
        replace(
            branch, left=unequal[0], right=unequal[1], title=_joined(branch.title, " ≠ ".join(texts))
        ),
    ]


def _with_places(node: Formula, knowledge: Knowledge) -> Formula:
    """Return a formula with what holds at a number for what is given by cases: f(-2), f being |x|."""
    if isinstance(node, Apply) and node.function == "at":
        head, place = node.arguments
    elif isinstance(node, Evaluation) and node.lower is None:
        head, place = node.expression, node.upper
    else:
        return with_parts_changed(node, lambda part: _with_places(part, knowledge))
    definition = knowledge.definitions.get(head.name) if isinstance(head, Name) else None
    cases = head if definition is None else definition.node
    letters = formula.names(cases)
    if not isinstance(cases, Cases) or formula.names(place) or len(letters) != 1:
        return node
    (letter,) = letters
    if (number := _number(place, knowledge)) is None:
        raise NoFormError("which case holds there is open")
    return substitute(_case_at(cases, letter, number, knowledge), letter, place)


def _case_at(cases: Cases, letter: str, number: float, knowledge: Knowledge) -> Formula:
    """Return the value of the first case whose condition a number satisfies."""
    for value, condition in zip(cases.values, cases.conditions, strict=True):
        if condition is None:
            return value
        left, sign, right = condition
        sizes = [number if side == Name(letter) else _number(side, knowledge) for side in (left, right)]
        if None in sizes or sign not in _COMPARED:
            break
        if _COMPARED[sign](*sizes):
            return value
    raise NoFormError("which case holds there is open")


_COMPARED: dict[str, Callable[..., bool]] = {
    "<": operator.lt, ">": operator.gt, "≤": operator.le, "≥": operator.ge,
    "=": operator.eq, "≠": operator.ne,
}  # fmt: skip


def _number(node: Formula, knowledge: Knowledge) -> float | None:
    """Return the real number that a formula without letters is, None for another."""
    if formula.names(node):
        return None
    rows = [row for _, row in sample_trees([node], knowledge.meaning, count=1)]
    return float(rows[0][0].real) if rows else None


def _of_cases(branch: Branch, cases: Cases) -> list[Branch]:
    """Return a branch for each case: an equation puts its letter in, y < b puts in b - s with s > 0."""
    result = []
    only_equations = True
    for value, condition in zip(cases.values, cases.conditions, strict=True):
        left, right = (replace_part(side, cases, value) for side in (branch.left, branch.right))
        if condition is None:
            exact = branch.is_exact and only_equations
            title = _joined(branch.title, "otherwise")
            otherwise = replace(branch, left=left, right=right, title=title, is_exact=exact)
            result.append(replace(otherwise, condition=_not_divided(cases)))
            continue
        letter, sign, limit = condition
        text = f"{formula_text(letter, plain=True)} {sign} {formula_text(limit, plain=True)}"
        case = replace(branch, left=left, right=right, title=_joined(branch.title, f"for {text}"))
        only_equations = only_equations and sign in ("=", "≠")
        is_open = not isinstance(letter, Name) or letter.name in formula.names(limit)
        if sign == "≠":
            result.append(replace(case, condition=text))
        elif (pair := _divided(condition)) is not None:
            result.append(_of_multiples(case, branch.title, *pair))
        elif is_open or not isinstance(letter, Name) or sign not in "=<>≤≥":
            result.append(replace(case, is_exact=False))
        else:
            result.append(_under_condition(case, letter, sign, limit))
    return result


def _of_multiples(case: Branch, title: str, divided: Name, divisor: Formula, rest: Formula) -> Branch:
    """Return a branch on which one whole number is a multiple of another, or leaves a rest."""
    meaning = case.knowledge.meaning
    meaning = replace(meaning, integer=meaning.integer | {ANY_WHOLE})
    case = replace(case, knowledge=replace(case.knowledge, meaning=meaning))
    multiple: Formula = Product((Name(ANY_WHOLE), divisor))
    text = f"where {plain_text(divided)} is a multiple of {plain_text(divisor)}"
    if rest != formula.number(0):
        multiple = Sum((multiple, rest))
        text = f"where {plain_text(divided)} leaves {plain_text(rest)}, divided by {plain_text(divisor)}"
    put_in = _under_condition(case, divided, "=", multiple)
    return replace(put_in, title=_joined(title, text))


def _divided(condition: tuple[Formula, str, Formula]) -> tuple[Name, Formula, Formula] | None:
    """Return p, N and the rest that p divided by N leaves by a condition, None for other conditions."""
    left, sign, right = condition
    if sign != "=" or not isinstance(left, Apply) or left.function != "mod":
        return None
    divided, divisor = left.arguments
    is_rest = right == formula.number(0) or (
        isinstance(right, Number)
        and isinstance(divisor, Number)
        and right.value.denominator == 1
        and 0 <= right.value < divisor.value
    )
    return (divided, divisor, right) if isinstance(divided, Name) and is_rest else None


def _not_divided(cases: Cases) -> str:
    """Return what "otherwise" says behind the one case that N divides p, "" behind others."""
    conditions = [condition for condition in cases.conditions if condition is not None]
    pair = _divided(conditions[0]) if len(conditions) == 1 else None
    if pair is None or pair[2] != formula.number(0):
        return ""
    return f"{plain_text(pair[0])} is no multiple of {plain_text(pair[1])}"


def _under_condition(case: Branch, letter: Name, sign: str, limit: Formula) -> Branch:
    """Return a branch with what its condition makes of a letter put in."""
    value, knowledge = limit, case.knowledge
    if sign != "=":
        beyond = Name(f"s_{letter.name}")
        value = Sum((limit, beyond if sign in ">≥" else Negative(beyond)))
        meaning = knowledge.meaning
        whole = meaning.integer | ({beyond.name} if letter.name in meaning.integer else set())
        meaning = replace(meaning, positive=meaning.positive | {beyond.name}, integer=whole)
        knowledge = replace(knowledge, meaning=meaning)
    left, right = (substitute(side, letter.name, value) for side in (case.left, case.right))
    regions = (*case.regions, (letter.name, value, f"s_{letter.name}")) if sign != "=" else case.regions
    return replace(case, left=left, right=right, knowledge=knowledge, regions=regions)
