"""Decisions whether two formulas are equal: proved, refuted with a witness, or undecided."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Number
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.open_sums import goes_on_within
from symbalance.notes.algebra.tree_values import DEEPEST, sample_trees
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number, may_be_rounded
from symbalance.notes.checking.deciding.parts_apart import parts_apart
from symbalance.notes.checking.deciding.rounding import (
    agrees_as_printed,
    decimals,
    exact_exponents,
    whole_before_unit,
    with_decimals,
)
from symbalance.notes.checking.deciding.substitution import replace_part

NOISE = values.DIGITS - 5
"""Places behind the point at which a number is what computing leaves of 0: a sum of roots of unity."""
SMALLEST_WHOLE = 100
"""A whole number of three digits may be what a power that is no root comes to, rounded."""
PROVED, REFUTED, UNDECIDED = "proved", "refuted", "undecided"


@dataclass(frozen=True)
class Decision:
    """What is known of a step, and on what it rests."""

    status: str
    reason: str = ""
    order: str = ""
    assumptions: tuple[str, ...] = ()
    level: Level | None = None
    left: Form | None = None
    right: Form | None = None
    witness: Mapping[str, str] = field(default_factory=dict)
    through: int | None = None
    """The order through which two sides were compared, None for an exact comparison."""
    of_matrices: bool = False
    """Whether the sides are matrices, whose products do not commute."""
    expanded_in: str = ""
    """The letter in which both sides are cut off."""
    further: tuple[Form, ...] = ()
    """The exact side cut off one and two orders later: what a repaired side may come to."""
    at_odds: str = ""
    """Why what is refuted by other lines may speak of another case than they do; "" where it does not."""

    @property
    def is_proved(self) -> bool:
        """Tell whether the step is proved."""
        return self.status == PROVED


def decide_equality(left: Formula, right: Formula, knowledge: Knowledge) -> Decision:
    """Decide left = right exactly, with as little knowledge as it takes."""
    last = Decision(UNDECIDED, "nothing to compare")
    levels = list(knowledge.levels(left, right))
    for level in levels:
        if level is not levels[-1] and _differs_clearly(left, right, knowledge, level):
            continue
        last = _at_level(left, right, knowledge, level)
        if last.is_proved or (level is levels[0] and is_of_another_size(left, right, last)):
            return last
    if decimals(left) or decimals(right):
        return last
    return refuted_by_formulas(last, levels, lambda level: _at_level(left, right, knowledge, level))


def is_of_another_size(left: Formula, right: Formula, refutation: Decision) -> bool:
    """Tell whether two sides in letters differ by a printed factor alone: √3 F a = 1.723 F a.

    It is wrong whatever the letters are: that they are rounded explains nothing.
    """
    first, second = refutation.left, refutation.right
    if refutation.status != REFUTED or first is None or second is None:
        return False
    if not (decimals(left) or decimals(right)) or not (values.letters(first) and values.letters(second)):
        return False
    ratios = [pair[0] / pair[1] for _, pair in values.sample([first, second], 3) if pair[1]]
    return len(ratios) == 3 and all(_close(ratio, ratios[0]) for ratio in ratios[1:])


def refuted_by_formulas(
    last: Decision, levels: Sequence[Level], decide_at: Callable[[Level], Decision]
) -> Decision:
    """Return a refutation without the numbers of a page's example, if there is one: r λ, not 3 λ/20."""
    general = next((level for level in reversed(levels) if level.is_of_formulas), None)
    if last.status != REFUTED or general is None:
        return last
    decision = decide_at(general)
    return decision if decision.status == REFUTED else last


def _differs_clearly(left: Formula, right: Formula, knowledge: Knowledge, level: Level) -> bool:
    """Tell at one point, quickly, that two sides differ by more than any rounding: no proof is tried."""
    meaning = replace(knowledge.meaning, values=level.values)
    if any(not number.value for number in (*decimals(left), *decimals(right))):
        return False  # beside a printed 0.000 every value is far off, measured by the larger of the two
    points = sample_trees([left, right], meaning, 1)
    if not points:
        return False
    first, second = points[0][1]
    return abs(abs(first) - abs(second)) > 0.2 * max(abs(first), abs(second)) or (
        not decimals(left) and not decimals(right) and not _close(abs(first), abs(second))
    )


def _at_level(left: Formula, right: Formula, knowledge: Knowledge, level: Level) -> Decision:
    evaluator = knowledge.evaluator(level)
    try:
        first, second = evaluator.form(left), evaluator.form(right)
        if first.equals(second):
            assumptions = tuple(evaluator.domain.assumptions)
            return Decision(
                PROVED, assumptions=level.assumptions + assumptions, level=level, left=first, right=second
            )
        return _by_numbers(left, right, evaluator, (first, second), level, knowledge)
    except NoFormError as problem:
        reason = f"no normal form: {problem}"
    except TooLargeError as problem:
        reason = f"too large for a normal form: {problem}"
    return _by_trees(left, right, evaluator.meaning, level, reason, knowledge.printed)


def _by_trees(
    left: Formula,
    right: Formula,
    meaning: SymbolValue,
    level: Level,
    reason: str,
    printed: Collection[float],
) -> Decision:
    """Return what points in numbers say of two formulas that have no forms: refuted or undecided.

    Two numbers may differ by what the results among the numbers typed are rounded by.
    """
    points = sample_trees([left, right], meaning)
    is_number = bool(points) and not points[0][0]
    if is_number and (
        _agree_as_typed(left, right, meaning, points[0][1], printed)
        or _agree_in_part(left, right)
        or _agree_as_whole(left, right, meaning, points[0][1])
    ):
        return Decision(PROVED, order="the digits printed", assumptions=level.assumptions, level=level)
    for point, pair in points:
        if not _close(*pair):
            shown = "their values differ" if is_number else reason
            return Decision(REFUTED, shown, level=level, witness=witness_at(point, pair))
    if points and _is_repeated(left, right, meaning.values):
        return Decision(PROVED, assumptions=level.assumptions, level=level)
    if points:
        return Decision(UNDECIDED, f"equal at {len(points)} points tried; {reason}", level=level)
    return Decision(UNDECIDED, reason, level=level)


def _is_repeated(left: Formula, right: Formula, formulas: Mapping[str, Formula]) -> bool:
    """Tell whether a letter's formula is given once more as it was."""
    for _ in range(DEEPEST):
        if left == right:
            return True
        if not isinstance(left, formula.Name) or left.name not in formulas:
            return False
        left = formulas[left.name]
    return False


def _agree_as_typed(
    left: Formula, right: Formula, meaning: SymbolValue, pair: Sequence[Any], printed: Collection[float]
) -> bool:
    """Tell whether two numbers differ by no more than the rounding of the results they are typed with."""
    margin: Any = 0
    for side, value in zip((left, right), pair, strict=True):
        node = with_decimals(side, meaning.values)  # β = 17.5° too stands for all that is rounded to it
        exact = exact_exponents(node)
        for number in (each for each in decimals(node) if id(each) not in exact):
            may_round = is_lone_number(side) or may_be_rounded(number, printed)
            if number.last_place is None or not may_round:
                continue
            moved = replace_part(node, number, Number(number.value + number.last_place / 2))
            there = sample_trees([moved], meaning, 1)
            if not there:
                return False
            margin += abs(there[0][1][0] - value)
    if not margin and (decimals(left) or decimals(right)):
        return _close(*pair)  # 10^(-0.4) by the letters and by the numbers put in
    return bool(margin) and abs(pair[0] - pair[1]) <= margin


def _agree_as_whole(left: Formula, right: Formula, meaning: SymbolValue, pair: Sequence[Any]) -> bool:
    """Tell whether a whole number is what the other side rounds to: 754 K for 300 K · 10^0.4."""
    for side, other, value, exact in ((right, left, pair[1], pair[0]), (left, right, pair[0], pair[1])):
        whole = side if isinstance(side, Number) else whole_before_unit(side)
        if whole is None or whole.last_place is not None or whole.value.denominator != 1:
            continue
        if isinstance(other, Number) or abs(whole.value) < SMALLEST_WHOLE:
            continue
        moved = replace_part(side, whole, Number(whole.value + Fraction(1, 2)))
        there = sample_trees([moved], meaning, 1)
        if there and abs(exact - value) <= abs(there[0][1][0] - value):
            return True
    return False


def _agree_in_part(left: Formula, right: Formula) -> bool:
    """Tell whether two numbers of one build differ in a part alone that is rounded: √(4.2·3) = √12.6."""
    parts = parts_apart(left, right)
    if parts is None or not any(isinstance(part, formula.Number) for part in parts):
        return False
    try:
        return agrees_as_printed(*parts, FormEvaluator(Domain()).form)
    except (NoFormError, TooLargeError):
        return False


def _by_numbers(
    left: Formula,
    right: Formula,
    evaluator: FormEvaluator,
    forms: tuple[Form, Form],
    level: Level,
    knowledge: Knowledge,
) -> Decision:
    """Return what points in numbers say of two forms that are not identical."""
    first, second = forms
    points = values.sample([first, second], 1)
    if points and _close(*map(abs, points[0][1])):  # else one point refutes, up to a sign too
        points = values.sample([first, second])
    if not points:
        return Decision(
            UNDECIDED,
            "no point where both sides are real",
            assumptions=level.assumptions,
            level=level,
            left=first,
            right=second,
        )
    same = [_close(*pair) for _, pair in points]
    if all(same) and (assumptions := _same_square(left, right, first, second)) is not None:
        assumptions = _with_signs_of_roots(level, first, *assumptions)
        return Decision(PROVED, assumptions=assumptions, level=level, left=first, right=second)
    agrees = agrees_as_printed(
        left,
        right,
        evaluator.form,
        level.values,
        printed=knowledge.printed,
        stated=knowledge.stated,
        counted=knowledge.counted,
    )
    if agrees or _agree_in_part(left, right):
        order = "the digits printed"
        return Decision(
            PROVED, order=order, assumptions=level.assumptions, level=level, left=first, right=second
        )
    if all(same):
        return Decision(
            UNDECIDED, "equal at the points tried, not proved", level=level, left=first, right=second
        )
    assumption = _up_to_sign(left, right, first, second) if any(same) else ""
    if assumption:
        assumptions = _with_signs_of_roots(level, first, assumption)
        return Decision(PROVED, assumptions=assumptions, level=level, left=first, right=second)
    point, pair = points[same.index(False)]
    witness = witness_at(point, pair)
    return Decision(REFUTED, level=level, left=first, right=second, witness=witness)


def _close(left: Any, right: Any) -> bool:
    mp, scale = values.context(), max(abs(left), abs(right), 1e-300)
    if not mp.isfinite(scale):
        return False  # ln 0 is equal to nothing
    return abs(left - right) <= max(scale * values.power_of_ten(mp, -25), values.power_of_ten(mp, -NOISE))


def differ(left: Any, right: Any) -> bool:
    """Tell whether two mpmath numbers differ by more than their noise."""
    return not _close(left, right)


def witness_at(point: values.Point, pair: list[Any]) -> dict[str, str]:
    """Return a point and the values of both sides there, in print."""
    coordinates = {name: printed_decimal(value) for name, value in point.items()}
    return coordinates | {"left": digits(pair[0]), "right": digits(pair[1])}


def printed_decimal(value: Fraction) -> str:
    """Return a sample's coordinate as a short decimal."""
    return str(value.numerator) if value.denominator == 1 else f"{float(value):.6g}"


def digits(value: Any, count: int = 12) -> str:
    """Return an mpmath number with a few digits, its imaginary part only where there is one."""
    mp = values.context()
    if abs(value.imag) <= abs(value) * mp.mpf(10) ** -20:
        return mp.nstr(value.real, count)
    return mp.nstr(value, count)


def _same_square(left: Formula, right: Formula, first: Form, second: Form) -> tuple[str, ...] | None:
    """Return the assumptions under which two sides of equal squares are equal, as at the points tried.

    None if their squares are not proved equal. Two numbers need none, nor do two roots.
    """
    try:
        if not first.times(first).equals(second.times(second)):
            return None
    except (NoFormError, TooLargeError):
        return None
    numbers = not values.letters(first) and not values.letters(second)
    bare = [node for node in (left, right) if not _is_root(node)]
    if numbers or not bare:
        return ()
    is_turned = any(isinstance(n, formula.Negative) and _is_root(n.operand) for n in (left, right))
    other = next((n for n in bare if not isinstance(n, formula.Negative)), bare[0])
    return (f"{formula_text(other, plain=True)} {'≤' if is_turned else '≥'} 0",)


def _with_signs_of_roots(level: Level, form: Form, *assumptions: str) -> tuple[str, ...]:
    """Return what a comparison of squares rests on: |a| |b| in them is a b where neither is negative."""
    return tuple(dict.fromkeys((*level.assumptions, *form.domain.assumptions, *assumptions)))


def _is_root(node: Formula) -> bool:
    """Tell whether a formula is a square root or an absolute value, perhaps times a positive number."""
    if isinstance(node, formula.Product | formula.Quotient):
        parts = formula.children(node)
        roots = [part for part in parts if _is_root(part)]
        return bool(roots) and all(p in roots or isinstance(p, formula.Number) for p in parts)
    if isinstance(node, formula.Power):
        return _is_root(node.base)
    return isinstance(node, formula.Call) and node.function in ("sqrt", "abs")


def _up_to_sign(left: Formula, right: Formula, first: Form, second: Form) -> str:
    """Return the assumption under which a root equals the other side, or nothing."""
    for node, other in ((right, left), (left, right)):
        if _is_root(node) and first.times(first).equals(second.times(second)):
            return f"{formula_text(other, plain=True)} ≥ 0"
    return ""


def without_dots(node: Formula) -> tuple[Formula, bool]:
    """Return a formula without the dots at the end of its sums, and whether there were any."""
    if isinstance(node, formula.Sum) and not goes_on_within(node):
        terms = tuple(t for t in node.terms if not isinstance(t, formula.Dots))
        if not terms and node.terms:  # dots alone are no number: a sum of no terms would be 0
            return node.terms[0], True
        parts = [without_dots(t) for t in terms]
        is_cut = len(terms) < len(node.terms) or any(is_cut for _, is_cut in parts)
        return replace(node, terms=tuple(p for p, _ in parts)), is_cut
    pairs = [without_dots(part) for part in formula.children(node)]
    if not any(is_cut for _, is_cut in pairs):
        return node, False
    return formula.with_children(node, tuple(p for p, _ in pairs)), True
