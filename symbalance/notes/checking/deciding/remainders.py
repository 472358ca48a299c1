"""Decisions on sides with O( ): whether what is left out is of the order written.

cos x = 1 - x²/2 + O(x⁴) claims that all terms below x⁴ stand there. O(g) is put as g times a letter of
its own; below the first power of x that this letter comes with, both sides must agree.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    Dots,
    Formula,
    Name,
    Product,
    children,
    parts_of_kind,
    walk,
    with_children,
)
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.series import Expansion
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.order_agreement import (
    HIGHEST_ORDER,
    SmallLetter,
    proved_through,
    truncated_sum,
    witness_of,
)

REMAINDER = "O( )"
"""The letter that O(g) is g times of begins so: no written letter has such a name."""
FACTOR = 6
"""Powers that may stand before a bracket with O( ) in it: x³(1 + O(x²)) is of order 5."""


def has_remainder(node: Formula) -> bool:
    """Tell whether O( ) stands in a formula."""
    return any(part.order is not None for part in parts_of_kind(node, Dots))


def is_remainder(node: Formula) -> bool:
    """Tell whether a side is O( ) alone: it states no value."""
    return isinstance(node, Dots) and node.order is not None


def decide_remainder(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision:
    """Decide left = right + O(g): proved if they differ by nothing below g, refuted if they do."""
    if has_remainder(left) and not has_remainder(right) and sign == "=":
        return Decision(UNDECIDED, "O( ) on the left only: write it on the right")
    orders = [part.order for side in (left, right) for part in walk(side) if isinstance(part, Dots)]
    if None in orders:
        return Decision(UNDECIDED, "dots beside O( ): write one of them")
    first, second = _with_letter(left, "left"), _with_letter(right, "right")
    best = Decision(UNDECIDED, "nothing to compare")
    for level in knowledge.levels(first, second):
        try:
            best = _at_level(first, second, [order for order in orders if order], knowledge, level)
        except (NoFormError, TooLargeError) as problem:
            best = Decision(UNDECIDED, f"no power series for O( ): {problem}", level=level)
        if best.is_proved:
            return best
    return best


def _with_letter(node: Formula, side: str) -> Formula:
    """Return a side with O(g) as g times a letter, one for each side: what is left out never cancels."""
    if isinstance(node, Dots) and node.order is not None:
        return Product((node.order, Name(f"{REMAINDER} {side}")))
    parts = children(node)
    return with_children(node, tuple(_with_letter(part, side) for part in parts)) if parts else node


def _at_level(
    left: Formula, right: Formula, orders: list[Formula], knowledge: Knowledge, level: Level
) -> Decision:
    evaluator = knowledge.evaluator(level)
    letter, sign, highest = _small_letter([evaluator.form(order) for order in orders], knowledge)
    if highest > HIGHEST_ORDER:
        raise NoFormError("an order beyond those compared")
    first, second = evaluator.form(left), evaluator.form(right)
    difference = first.minus(second)
    for reach in (highest, highest + FACTOR):
        series = Expansion(difference.domain, letter, sign, reach).of(difference).cut(reach)
        with_remainder = [k for k, form in sorted(series.terms.items()) if _holds_remainder(form)]
        if with_remainder:
            break
    if not with_remainder or series.through < with_remainder[0]:
        raise NoFormError("its own order is not reached")
    kept = SmallLetter(letter, sign, with_remainder[0] - 1)
    below = series.cut(kept.order)
    if not below.terms:
        return proved_through(max(kept.order, 0), kept.text, level, first, second)
    left_form, right_form = (
        truncated_sum(Expansion(form.domain, letter, sign, kept.order).of(form).cut(kept.order), kept)
        for form in (first, second)
    )
    return Decision(
        REFUTED,
        order=kept.text,
        level=level,
        left=left_form,
        right=right_form,
        witness=witness_of(left_form, right_form),
        through=max(kept.order, 0),
    )


def _small_letter(orders: list[Form], knowledge: Knowledge) -> tuple[str, int, int]:
    """Return the letter that O( ) is about, 1 or -1 where it is small or large, and its highest power."""
    powers: list[dict[str, Fraction]] = []
    for form in orders:
        if not form.is_polynomial or len(form.numerator) != 1:
            raise NoFormError("an order that is no single power")
        (monomial,) = form.numerator
        powers.append(
            {form.domain.generators[g].content: Fraction(e) for g, e in monomial if _is_symbol(form, g)}
        )
    usual = knowledge.crank.small[0] if knowledge.crank and knowledge.crank.small else ""
    candidates = set.intersection(*map(set, powers))
    groups = ({usual} & candidates, candidates & knowledge.small, candidates)
    letter = next((min(group) for group in groups if len(group) == 1), None)
    if letter is None:
        raise NoFormError("an order in more than one letter, none of them said to be small")
    exponents = [Fraction(power[letter]) for power in powers]
    if any(e.denominator != 1 or not e for e in exponents) or len({e > 0 for e in exponents}) > 1:
        raise NoFormError("an order that is no whole power")
    return letter, 1 if exponents[0] > 0 else -1, max(abs(int(e)) for e in exponents)


def _holds_remainder(form: Form) -> bool:
    return any(letter.startswith(REMAINDER) for letter in values.letters(form))


def _is_symbol(form: Form, number: int) -> bool:
    return form.domain.generators[number].kind == "symbol"
