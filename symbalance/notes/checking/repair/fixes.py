"""Search for the smallest change that makes a refuted line true, with a proof and its place in the text.

First single changes of what is written (`edits`), filtered in floats and proved exactly, cheapest first;
then integers solved for; then a common factor; then every wrong term by its exact value. A change that is
not proved is not reported.
"""

from __future__ import annotations

import math
from cmath import isfinite
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice
from traceback import format_exception

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document import formula
from symbalance.document.formula import Formula, Name, Negative, Number, Power, Product, Quotient, names
from symbalance.document.text_writer import formula_text
from symbalance.errors import SymbalanceError, fault_of
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.algebra.number_formulas import rational_node, rational_of
from symbalance.notes.checking.deciding.descriptions import printed_value
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute, without_stacked_fractions
from symbalance.notes.checking.premises.constraints import letter_counts
from symbalance.notes.checking.repair.edits import Edit, edits, parents_of, parts
from symbalance.notes.checking.repair.numeric_filter import (
    Case,
    NoValueError,
    NumericFilter,
    Values,
    filter_of,
    fits,
    letters_of,
)
from symbalance.notes.checking.repair.slip_words import slip_words
from symbalance.notes.checking.repair.term_repair import correct_terms, slip_kind, slip_kinds
from symbalance.notes.checking.repair.tidying import tidied
from symbalance.notes.checking.verdicts import REFUTED, Fault, Fix, Verdict
from symbalance.notes.checking.words.written_degrees import in_degrees
from symbalance.notes.checking.words.written_numbers import corrected
from symbalance.notes.reading.equations import ReadNotes, Side
from symbalance.text import lazy_patterns as re

OTHER_SIDE = 0.2
"""How much cheaper a change of the left side must be: the slip is usually on the right."""
MOST_OTHER = 2.0
"""What costs this much rewrites a side (a factor, several terms): of the left side it is not proposed."""
MOST_PROOFS = 8
"""Changes that fit in floats and are tried by proof, cheapest first: a proof may cost a second."""
LONGEST_DENOMINATOR = 10_000
"""Of an exact value that is put for a side of numbers alone."""
OF_A_NUMBER = 1.3
"""What that costs: more than another whole number, less than a fraction in a number's place."""
OF_A_SHORT_VALUE = 1.2
SHORT_VALUE = 14
"""What the exact value costs, put for a whole side, and how many parts it may have: less than a change of
two things, and a result is what a teacher corrects, not what it was worked out from."""
ROUNDED = Fraction(1, 10**9)
"""Relative: a whole number is the value itself, but for the rounding of π."""
SHORT_DENOMINATOR = 100
"""Of a fraction that is put for a whole number."""
PUT_IN = 0.06
"""What a change of a number costs more that the page gives a letter: it is seldom typed wrong again."""
NOT_REDUCED = 0.15
"""What 2/(2λ) costs more than 1/λ, where either is right."""
LONGEST_NUMBER = 10**7
"""From here on a number in a correction is no slip: 1558361602735921/20000."""
LARGEST = 10**7
"""Of a whole number put for a printed one."""
SEARCH = Budget(5)
"""What a search may take: a refuted line stays refuted without it."""
SHARE = 0.8
"""At most, of what is left of the relation's budget: the verdict must not be lost with the search."""


def add_fix(
    verdict: Verdict,
    document: ReadNotes,
    side: Side,
    decision: Decision,
    knowledge: Knowledge,
    proves: Callable[[Formula], bool],
    left: Side | None = None,
    proves_left: Callable[[Formula], bool] | None = None,
) -> Verdict:
    """Return a refuted verdict with the change that makes its line true, if one is found.

    `left` is the side before, None of a piece that is bound to a quantity; `proves_left` tells whether a
    changed left side is proved, where that may hold the slip just as well.
    """
    if verdict.verdict != REFUTED or decision.left is None or not knowledge.corrects:
        return verdict
    try:
        return run_within(
            SEARCH,
            lambda: _with_fix(verdict, document, side, decision, knowledge, proves, left, proves_left),
            SHARE,
        )
    except OverBudgetError as problem:
        note = f"no correction was found within {problem.spent}"
        return replace(verdict, notes=(*verdict.notes, note))
    except SymbalanceError:
        raise  # a declaration that cannot be used
    except Exception as problem:  # refuted all the same: only its correction is lost
        fault = fault_of(problem)
        note = f"no correction was found, by a fault of symbalance: {fault}; please report it"
        notes = (*verdict.notes, note)
        return replace(verdict, notes=notes, fault=fault, traceback="".join(format_exception(problem)))


def _with_fix(
    verdict: Verdict,
    document: ReadNotes,
    side: Side,
    decision: Decision,
    knowledge: Knowledge,
    proves: Callable[[Formula], bool],
    left: Side | None,
    proves_left: Callable[[Formula], bool] | None,
) -> Verdict:
    """Return the verdict with the cheapest fix of the right side, or a clearly cheaper left one."""
    case = Case(side.node, decision, knowledge, proves)
    number = _printed(case, document, side, left)
    if number is not None:
        return replace(verdict, fix=fix_of(number, document, side))
    repair = diagnose(case)
    if repair is None or repair.cost > OF_A_SHORT_VALUE:
        known = None if left is None or isinstance(left.node, Name) else left.node
        short = _short_value(case, verdict.exact_node, known)
        if short is not None and repair is not None and repair.kind == "factor":
            repair = replace(repair, cost=short.cost)  # says more of the slip
        else:
            repair = short or repair
    where, title = side, ""
    is_result = not names(side.node)  # what was calculated: never what it was calculated from
    if (
        left is not None
        and proves_left is not None
        and not is_result
        and (repair is None or repair.cost > 1.0 + OTHER_SIDE)
    ):
        exchange = replace(decision, left=decision.right, right=decision.left)
        rival = diagnose(Case(left.node, exchange, knowledge, proves_left))
        if (
            rival is not None
            and rival.cost < MOST_OTHER
            and rival.changes[0][0] is not left.node
            and (repair is None or rival.cost + OTHER_SIDE < repair.cost)
        ):
            repair, where, title = rival, left, "left side: "
    if repair is None:
        return verdict
    repair = _tidy(repair, where.node)
    is_rewritten = repair.cost >= MOST_OTHER
    if left is not None and is_rewritten and where is side and repair.node == left.node:
        return verdict  # the left side once more corrects nothing
    return replace(verdict, fix=fix_of(repair, document, where, title))


def _printed(case: Case, document: ReadNotes, side: Side, left: Side | None) -> Repair | None:
    """Return what a printed number should be, in its own unit, with as many digits as prove the line.

    Of whole numbers an exact one: 7·8 = 54 is mended by 56, and 2 cos 30° = 2 by √3.
    """
    printed = printed_value(case.decision, document, side, left)
    if printed is None:
        return None
    claim, value, is_sum = printed
    is_exact = claim.place is None and claim.power is None
    exact = case.decision.left.rational() if is_exact and case.decision.left is not None else None
    if is_exact and not claim.unit and (exact is None or exact.denominator <= SHORT_DENOMINATOR):
        return None
    for words, number in corrected(claim, value):
        if is_sum or case.proves(number.node):
            kind = words
            is_whole = abs(Fraction(number.factor) * number.mantissa - value) < abs(value) * ROUNDED
            if is_exact and number.place is None and kind == "value" and is_whole:
                shown = (abs(each.mantissa) for each in (number, claim))
                kind = "number misprinted ({} for {})".format(*shown)
            return Repair(kind, number.written, ((case.node, number.written),), 1.0)
    return None


def _tidy(repair: Repair, before: Formula) -> Repair:
    """Return a repair as a person would write it, with degrees for their factor π/180."""
    own = {id(part) for part in formula.walk(before)}

    def written(node: Formula) -> Formula:
        return in_degrees(tidied(node, own))

    changes = tuple((old, written(new)) for old, new in repair.changes)
    return replace(repair, node=written(repair.node), changes=changes)


def _short_value(case: Case, exact: Formula | None, left: Formula | None) -> Repair | None:
    """Return the exact value for the whole side, where that is one short term and is proved.

    Not where the left side is as short: sin 2θ = sin 2θ would be no correction of sin 2θ = sin θ cos θ.
    """
    if exact is None or isinstance(exact, formula.Sum) or not _is_short(exact):
        return None
    is_restated = left is None or (names(left) and _size(left) <= _size(exact) + 1)
    if names(case.node) and is_restated:
        return None
    node = _as_decimal(case) or exact
    if not case.proves(node):
        node = exact
        if not case.proves(node):
            return None
    return _rounded(Repair("value", node, ((case.node, node),), OF_A_SHORT_VALUE), case)


def _is_short(node: Formula) -> bool:
    return next(islice(formula.walk(node), SHORT_VALUE, None), None) is None


def _size(node: Formula) -> int:
    return sum(1 for _ in formula.walk(node))


def _as_decimal(case: Case) -> Formula | None:
    """Return the exact value of a side that is a whole number as a decimal, where it is none.

    A digit more than the author wrote, but for one: 100π = 341 is mended by 314.2.
    """
    printed = case.node.operand if isinstance(case.node, Negative) else case.node
    if not isinstance(printed, Number) or case.decision.left is None:
        return None
    points = values.sample([case.decision.left])
    if not points or points[0][0] or not values.context().isfinite(points[0][1][0]):
        return None
    value = points[0][1][0]
    exact = Fraction(str(value.real))
    if value.imag or not exact or exact.denominator == 1:
        return None
    digits_written = len(str(abs(int(printed.value)))) + 1
    place = Fraction(10) ** (_exponent(exact) + 1 - max(digits_written, 3))
    return _decimal(exact, min(place, Fraction(1, 10)))


def is_proved_as_far(decision: Decision, refutation: Decision) -> bool:
    """Tell whether a changed line is proved, and as much as it was to say: through no lower an order."""
    if not decision.is_proved:
        return False
    if refutation.through is None:
        return decision.through is None
    return decision.through is None or decision.through >= refutation.through


def fix_of(repair: Repair, document: ReadNotes, side: Side, title: str = "") -> Fix:
    """Return what the report says of a repair."""
    several = len(repair.changes) > 1
    faults = tuple(
        _fault(old, new, document, side, slip_kind(old, new) if several else repair.kind)
        for old, new in repair.changes
    )
    text = title + formula_text(repair.node, plain=True)
    words = slip_words(repair.kind, side.node, repair.changes)
    return Fix(repair.kind, text, repair.node, faults, of_left=bool(title), words=words)


def _fault(old: Formula, new: Formula, document: ReadNotes, side: Side, kind_of: str) -> Fault:
    span = old.span if old.span != (0, 0) else (side.span[1], side.span[1])
    source = document.shown(old, span)
    return Fault(
        document.line_of(span[0]),
        document.column_of(span[0]),
        source,
        formula_text(new, plain=True),
        kind_of,
        new,
        is_first=not any(
            old is term
            for part in formula.walk(side.node)
            if isinstance(part, formula.Sum)
            for term in part.terms[1:]
        ),
    )


# The change itself


@dataclass(frozen=True, slots=True)
class Repair:
    """A changed formula that is proved right: kind, the parts replaced and what replaces them."""

    kind: str
    node: Formula
    changes: tuple[tuple[Formula, Formula], ...]
    cost: float


def diagnose(case: Case) -> Repair | None:
    """Return the cheapest change that is proved, or None."""
    rounding = _round_exact_value(case)
    if rounding is not None:
        return rounding
    repair, number = _change(case), _exact_number(case)
    if number is not None and (repair is None or repair.cost > number.cost):
        repair = number if case.proves(number.node) else repair
    return _rounded(repair, case) if repair is not None else None


def _change(case: Case) -> Repair | None:
    """Return the cheapest change of what is written that is proved, or None."""
    target_and_filter = filter_of(case)
    if target_and_filter is not None:
        targets, numeric = target_and_filter
        for edit in _edits_that_fit(case, numeric, targets):
            parents = parents_of(case.node)
            node = edit.applied(parents)
            if case.proves(node):
                return Repair(edit.kind, node, (_as_written(edit, parents),), edit.cost)
    return _by_factor(case) or _by_terms(case)


def _as_written(edit: Edit, parents: dict[int, Formula]) -> tuple[Formula, Formula]:
    """Return the part replaced and its replacement, with a power written in it: sin²θ holds no sin θ."""
    outer = parents.get(id(edit.old))
    start, end = edit.old.span
    if isinstance(outer, Power) and outer.exponent is edit.old and outer.span != (0, 0):
        return outer, replace(outer, exponent=edit.new)
    if isinstance(outer, Power) and outer.base is edit.old and start < outer.exponent.span[0] < end:
        return replace(outer, span=edit.old.span), replace(outer, base=edit.new)
    return edit.old, edit.new


def _round_exact_value(case: Case) -> Repair | None:
    """Return the exact value rounded as the side is, where that is one decimal number."""
    printed = case.node.operand if isinstance(case.node, Negative) else case.node
    place = printed.last_place if isinstance(printed, Number) else None
    points = values.sample([case.decision.left]) if place and case.decision.left is not None else []
    if not place or not points or points[0][0]:
        return None
    if not values.context().isfinite(points[0][1][0]):
        return None  # ln 0
    exact = Fraction(str(points[0][1][0].real))
    while exact and abs(exact) < 10 * place:  # at least two digits
        place /= 10
    number = _decimal(exact, place)
    return Repair("value", number, ((case.node, number),), 1.0) if case.proves(number) else None


def _decimal(value: Fraction, place: Fraction) -> Formula:
    """Return a value rounded to a place, as a decimal with its sign before it."""
    number = Number(round(abs(value) / place) * place, place)
    return Negative(number) if value < 0 and number.value else number


def _exact_number(case: Case) -> Repair | None:
    """Return the exact value for a side without letters, where that is a short number."""
    left = case.decision.left
    value = None if left is None or names(case.node) else left.rational()
    if value is None or value.denominator > LONGEST_DENOMINATOR or abs(value) > LARGEST:
        return None
    new = rational_node(value)
    return Repair("value", new, ((case.node, new),), OF_A_NUMBER)


def _rounded(repair: Repair, case: Case) -> Repair:
    """Return a repair with decimals where the side is written in decimals, if it is proved so too."""
    printed = [n for n in formula.walk(case.node) if isinstance(n, Number) and n.last_place]
    if not printed:
        return repair
    significant = max(_digits(number) for number in printed)
    own = {id(part) for part in formula.walk(case.node)}

    def in_decimals(node: Formula) -> Formula:
        whole = rational_of(node)
        if whole is not None and id(node) not in own and whole.denominator > 12:
            place = Fraction(10) ** (_exponent(whole) + 1 - significant)
            return _decimal(whole, place)
        pieces = formula.children(node)
        if id(node) in own or not pieces:
            return node
        return formula.with_children(node, tuple(map(in_decimals, pieces)))

    changes = tuple((old, in_decimals(new)) for old, new in repair.changes)
    if all(new is before for (_, new), (_, before) in zip(changes, repair.changes, strict=True)):
        return repair
    node = in_decimals(repair.node)
    if not case.proves(node):
        return repair
    kind = _LONG_FACTOR.sub("value", repair.kind)
    return replace(repair, kind=kind, node=node, changes=changes)


_LONG_FACTOR = re.compile(r"factor -?[0-9]+/[0-9]{3,}")
"""Two decimals in the ratio of their digits, which is no slip that anybody makes."""


def _exponent(value: Fraction) -> int:
    """Return the power of ten of a number's first digit, of one that no float holds too."""
    if not value:
        return 0
    return math.floor(math.log10(abs(value.numerator)) - math.log10(value.denominator))


def _digits(number: Number) -> int:
    """Return the significant digits that a decimal is printed with, at least two."""
    return max(2, _exponent(number.value) - _exponent(number.last_place or Fraction(1)) + 1)


def _edits_that_fit(case: Case, numeric: NumericFilter, targets: list[Values]) -> list[Edit]:
    """Return the changes whose values fit, cheapest first."""
    parents = parents_of(case.node)
    passing: list[Edit] = list(_integers(case, numeric, targets, parents))
    is_nothing = not any(targets[0])
    variables = (
        [case.knowledge.crank.time, *names(case.knowledge.crank.theta)] if case.knowledge.crank else []
    )
    for edit in edits(case.node, letters_of(case), variables):
        if isinstance(edit.new, formula.Derivative):
            passing.append(edit)
            continue
        if is_nothing and (edit.kind.endswith("missing") or names(edit.new) - names(edit.old)):
            continue  # of a side that should be 0, a letter that is 0 is no correction
        if fits(edit.applied(parents), numeric, targets):
            passing.append(edit)
    passing += _conventions(case, numeric, targets)
    return sorted(passing, key=lambda e: e.cost)[:MOST_PROOFS]


def _integers(
    case: Case, numeric: NumericFilter, targets: list[Values], parents: dict[int, Formula]
) -> Iterator[Edit]:
    """Yield the whole numbers and fractions that, put for a printed number, give the right values.

    The side is taken as a + b y, or a + b/y, in that number y; two trial values give a and b.
    """
    for part, role in parts(case.node):
        if (
            not isinstance(part, Number)
            or part.value == 0
            or role in ("exponent", "argument", "angle term", "phase")
        ):
            continue
        try:
            value_now = numeric.values(case.node)
            value_doubled = numeric.values(
                Edit("", 0, part, rational_node(part.value * 2)).applied(parents)
            )
        except NoValueError:
            continue
        for value, inverse in _solutions(value_now[0], value_doubled[0], targets[0][0], part.value):
            is_turned = value < 0 and abs(value) != abs(part.value)
            if is_turned and (part.last_place or value.denominator != 1):
                continue  # two slips in one number
            if value != part.value and abs(value) <= LARGEST:
                new = rational_node(Fraction(value))
                if fits(Edit("", 0, part, new).applied(parents), numeric, targets):
                    simple = value.denominator == 1
                    swap = f"{value} for {part.value}"
                    kind = f"number misprinted ({swap})" if abs(value) != abs(part.value) else "sign"
                    penalty = 0.6 if value.denominator > 12 or abs(value) > 20 * abs(part.value) else 0
                    cost = (1.1 if simple else 1.4) + (0.05 if inverse else 0) + penalty
                    if names(case.node) and _could_be_reduced(part, value, parents):
                        cost += NOT_REDUCED  # of numbers put in, 100/150 stands as they are
                    cost += PUT_IN if not names(case.node) and _is_datum(part, case) else 0
                    if part.last_place:
                        new, kind = _decimal(Fraction(value), part.last_place), "value"
                    elif inverse and not simple:
                        continue  # a fraction below a bar is no slip of the pen
                    yield Edit(kind, cost, part, new)


def _is_datum(part: Number, case: Case) -> bool:
    """Tell whether a number is one that the page gives a letter: the 150 of l = 150 mm."""
    nodes = [d.node for d in case.knowledge.definitions.values() if not names(d.node)]
    first = (next((n for n in formula.walk(node) if isinstance(n, Number)), None) for node in nodes)
    sizes = (1, Fraction(1000), Fraction(1, 1000))
    return any(n is not None and abs(n.value) * size == abs(part.value) for n in first for size in sizes)


def _could_be_reduced(part: Formula, value: Fraction, parents: dict[int, Formula]) -> bool:
    """Tell whether a whole number put above a bar has a divisor that stands below it, as in 2/(2λ)."""
    inner, outer = part, parents.get(id(part))
    while isinstance(outer, Product):
        inner, outer = outer, parents.get(id(outer))
    if not isinstance(outer, Quotient) or inner is not outer.numerator or value.denominator != 1:
        return False
    below = outer.denominator.factors if isinstance(outer.denominator, Product) else (outer.denominator,)
    numbers = [n.value for n in below if isinstance(n, Number) and n.value.denominator == 1]
    return any(math.gcd(int(value), int(number)) > 1 for number in numbers)


def _solutions(
    value_now: complex, value_doubled: complex, target: complex, value: Fraction
) -> Iterator[tuple[Fraction, bool]]:
    """Yield the numbers for which a + b y, or a + b/y (True), gives the target: simple ones only."""
    for inverse in (False, True):
        step = value_doubled - value_now if not inverse else -2 * (value_doubled - value_now)
        if abs(step) < 1e-14 * max(abs(value_now), 1e-30):
            continue
        ratio = 1 + (target - value_now) / step
        if not isfinite(ratio):
            continue
        if abs(ratio.imag) > 1e-7 * max(1, abs(ratio.real)) or abs(ratio) < 1e-9:
            continue
        exact = float(value) * ratio.real if not inverse else float(value) / ratio.real
        if not math.isfinite(exact):
            continue  # the number itself, or what it would be, is beyond a double
        if round(exact) and abs(exact - round(exact)) < 1e-6:
            yield Fraction(round(exact)), inverse
            continue
        guess = Fraction(ratio.real).limit_denominator(10_000)
        if guess.denominator > 64 or abs(guess.numerator) > 64:
            continue
        if guess and abs(float(guess) - ratio.real) < 1e-7 * max(1, abs(ratio.real)):
            result = value * guess if not inverse else value / guess
            yield result, inverse


def _conventions(case: Case, numeric: NumericFilter, targets: list[Values]) -> Iterator[Edit]:
    """Yield the side with λ doubled or halved throughout: l/r put for l/s, or the reverse."""
    small = case.knowledge.crank.small if case.knowledge.crank else None
    if small is None or small[0] not in names(case.node):
        return
    letter = Name(small[0])
    for title, new in (
        ("rod ratio inverted (l/r for r/l)", Quotient(rational_node(Fraction(1)), letter)),
        (
            "rod ratio of the other convention (l/r, not l/s)",
            Product((rational_node(Fraction(2)), letter)),
        ),
        (
            "rod ratio of the other convention (l/s, not l/r)",
            Quotient(letter, rational_node(Fraction(2))),
        ),
    ):
        try:
            node = without_stacked_fractions(substitute(case.node, small[0], new))
        except NoFormError:  # a derivative by it
            continue
        if fits(node, numeric, targets):
            once = letter_counts(case.node)[small[0]] == 1 and "inverted" not in title
            yield Edit(title, 1.3 if once else 0.95, case.node, node)


def _by_factor(case: Case) -> Repair | None:
    """Return the side times a factor of one term, where exact/claimed is one."""
    left, right = case.decision.left, case.decision.right
    if left is None or right is None or not (left.is_polynomial and right.is_polynomial):
        return None
    if max(len(left.numerator), len(right.numerator)) > 60:
        return None
    try:
        ratio = left.over(right)
        if not ratio.is_polynomial or len(ratio.numerator) != 1 or right.is_zero() is not False:
            return None
        (coefficient,) = ratio.numerator.values()
        if not (_is_simple(coefficient.numerator) and _is_simple(coefficient.denominator)):
            return None
        factor = polynomial_node(ratio.domain, ratio.numerator)
    except (NoFormError, TooLargeError):
        return None
    node = _times(factor, case.node)
    return Repair("factor", node, ((case.node, node),), 2.0) if case.proves(node) else None


def _times(factor: Formula, node: Formula) -> Formula:
    """Return a factor times a side: 1/2 below its bar where it has one, -i x as x/i."""
    below: Formula | None = None
    if formula_text(factor, plain=True) in ("-i", "-sqrt(-1)"):
        below = formula.Constant("i")
    elif isinstance(factor, Quotient) and factor.numerator == Number(Fraction(1)):
        below = factor.denominator if isinstance(node, Quotient) else None
    if below is None:
        return Product((factor, node))
    if not isinstance(node, Quotient):
        return Quotient(node, below)
    own = node.denominator
    factors = own.factors if isinstance(own, Product) else (own,)
    last = isinstance(below, formula.Constant)
    return Quotient(node.numerator, Product((*factors, below) if last else (below, *factors)))


def _is_simple(number: int) -> bool:
    """Tell whether a whole number is small, or a power of two: what a slip may have put in."""
    number = abs(number)
    return number <= 64 or (number & (number - 1) == 0 and number < 2**24)


def _by_terms(case: Case) -> Repair | None:
    """Return the side with each wrong term replaced by its exact value."""
    try:
        pair = correct_terms(case.node, case.decision, case.knowledge)
    except (NoFormError, TooLargeError):
        return None
    if pair is None:
        return None
    node, changes = pair
    if not _is_writable(case.node, changes) or not case.proves(node):
        return None
    return Repair(slip_kinds(changes), node, changes, 2.0 + len(changes))


def _is_writable(node: Formula, changes: tuple[tuple[Formula, Formula], ...]) -> bool:
    """Tell whether changed terms are what somebody would write: wrong terms put right, or one exchanged.

    Where no term stays it is another formula, not a correction; nor is a number of seven digits one.
    """
    for _, new in changes:
        numbers = (n for n in formula.walk(new) if isinstance(n, Number) and n.last_place is None)
        if any(max(abs(n.value.numerator), n.value.denominator) >= LONGEST_NUMBER for n in numbers):
            return False
    kinds = {slip_kind(old, new) for old, new in changes}
    if len(changes) == 1 or len(kinds) == 1:
        return True
    replaced = {id(part) for old, _ in changes for part in formula.walk(old)}
    stays = any(isinstance(p, formula.Call | Name) and id(p) not in replaced for p in formula.walk(node))
    return stays and (len(changes) == 2 or not kinds & {"term missing", "term too many"})
