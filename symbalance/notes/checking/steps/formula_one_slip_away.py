"""Numbers that a formula one slip from the one above comes to: σ_m = 27.2 where (σ_o - σ_u)/2 stands.

With (σ_o + σ_u)/2 the number is right to all its digits. Where nothing proves the formula of the page, it
may be the formula that is wrong, and the number is not accused. A number with its digits exchanged, or a
power of ten away, is a slip of the number, whatever formula fits it. So with a letter of the page in
another one's place, φ = T b/(E I_p) where the number was worked out with G: both are in GPa.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain as chain_of
from itertools import islice
from math import isclose, log10

from symbalance.document.formula import (
    PI,
    Constant,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    names,
    parts_of_kind,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.formula_slips import single_edits, with_one_part_changed
from symbalance.notes.checking.premises.carried_values import ONE_IS_WRONG
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.another_factor import formulas_only_stated
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import NONE, Dimensions
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.spellings.multiples_in_words import multiple_said_before

CLOSE = 5e-4
"""How near an arithmetic has to come to a formula that it was not written with."""
FEWEST_DIGITS = 3
"""Digits of a number, at least, that fits a formula by more than chance: one of sixty may fit two."""
FEWEST_OF_EXCHANGE = 2
"""Digits where one letter stands for another of its dimension: a page has few of them."""
REACH_OF_WORDS = 120
"""Characters before a letter in which words may compute its number: half of 811 N m."""
MOST_EDITS = 60
"""Edits of a formula that are tried: each is worked out in numbers, and a short formula has fewer."""
_DIGITS_COMPARED = 4
"""Digits of two numbers that are the same ones, exchanged."""


def number_of_a_formula_one_slip_away(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a number is that of a formula one slip from an unproved one above; None for others."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if k or not isinstance(left, Name) or names(right):
        return None
    typed, near = number_of(right, knowledge), _precision(right)
    near_letter = _precision(right, FEWEST_OF_EXCHANGE)
    if not typed or near_letter is None:
        return None
    for above in (*formulas_only_stated(state, chain, knowledge), *_refuted(state, left, knowledge)):
        exact = number_of(above.right, knowledge) if above.left == left else None
        if not exact or _is_slip_of_digits(float(typed), float(exact)):
            continue
        edits = () if near is None else _edits(above.right, of_number=is_lone_number(right))
        exchanged = _with_a_letter_exchanged(state, chain, above.right, knowledge)
        candidates = chain_of(
            ((edit, near) for edit in edits), ((edit, near_letter) for edit in exchanged)
        )
        for edit, precision in candidates:
            value = number_of(edit, knowledge)
            if value is not None and isclose(float(value), float(typed), rel_tol=precision or 0.0):
                shown = formula_text(edit, plain=True)
                if above.right.span[0] in state.refuted:
                    proved = "is refuted: the number may be right"
                else:
                    proved = f"nothing proves: {ONE_IS_WRONG}"
                reason = f"what {shown} comes to, one slip from line {above.line}, which {proved}"
                return Decision(UNDECIDED, reason)
    return None


def as_multiple_in_words(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a number is what the words before compute, half of 811 N m, and no formula; or None.

    The formula that it does not fit is proved by nothing.
    """
    head, right = chain.sides[0].node, chain.sides[k + 1].node
    if k or not isinstance(head, Name) or not is_lone_number(right):
        return None
    text = state.document.text
    in_words = multiple_said_before(text[max(0, chain.start - REACH_OF_WORDS) : chain.start])
    number = next(iter(parts_of_kind(right, Number)), None)
    above = next(formulas_only_stated(state, chain, knowledge), None)
    if in_words is None or number is None or above is None:
        return None
    if abs(in_words - float(number.value)) > float(number.last_place or 1) / 2 * (1 + 1e-9):
        return None
    reason = f"what the words before it come to, and not what line {above.line} does"
    return Decision(UNDECIDED, f"{reason}, which nothing proves: {ONE_IS_WRONG}")


def _refuted(state: JudgingState, letter: Name, knowledge: Knowledge) -> Iterator[Premise]:
    """Yield the formula of a letter that is refuted itself: its number may be right all the same."""
    definition = knowledge.definitions.get(letter.name)
    if definition is not None and names(definition.node) and definition.node.span[0] in state.refuted:
        yield Premise(letter, definition.node, definition.line)


def _with_a_letter_exchanged(
    state: JudgingState, chain: Chain, node: Formula, knowledge: Knowledge
) -> Iterator[Formula]:
    """Yield a formula with one of its letters exchanged for a number's of the page, of its dimension."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    symbols = state.declarations.symbols_at(chain.lines[0])
    dimensions = Dimensions(symbols, values, state.document.text)
    own = names(node) | {name for side in chain.sides for name in names(side.node)}
    others = [name for name, d in knowledge.definitions.items() if d.numeric and name not in own]
    for name in sorted(names(node) & values.keys()):
        dimension = dimensions.letter(name, 0)
        for other in others if dimension not in (None, NONE) else ():
            if dimensions.letter(other, 0) == dimension:
                yield substitute(node, name, Name(other))


def _edits(node: Formula, *, of_number: bool) -> Iterator[Formula]:
    """Yield the formulas that one slip makes of a formula, a fraction upside down among them.

    An arithmetic shows what it was put into: a missing exponent there is a slip of its own.
    """
    yield from islice(with_one_part_changed(node, _upside_down), MOST_EDITS)
    if of_number:
        yield from (edit for edit in islice(single_edits(node), MOST_EDITS) if _keeps_minutes(node, edit))


def _keeps_minutes(node: Formula, edit: Formula) -> bool:
    """Tell whether the 60 seconds of a minute stay: only π n/30, which is 2π n/60, has half of them."""
    return not _has_number(node, 60) or _has_number(edit, 60) or PI in parts_of_kind(node, Constant)


def _has_number(node: Formula, value: int) -> bool:
    return any(number.value == value for number in parts_of_kind(node, Number))


def _upside_down(node: Formula) -> Iterator[Formula]:
    """Yield a formula with a fraction turned over, all of it or all but one factor: k J₁ J₂/(J₁ + J₂)."""
    above, below = _fraction(node)
    if below is not None:
        yield Quotient(below, Product(above))
        for factor in above if len(above) > 1 else ():
            rest = tuple(part for part in above if part is not factor)
            yield Quotient(Product((factor, below)), Product(rest))


def _fraction(node: Formula) -> tuple[tuple[Formula, ...], Formula | None]:
    """Return the factors above a line and what stands below it; None for what is no fraction.

    a b c/d is the product of a, b and c/d to the reader of plain text.
    """
    factors = node.factors if isinstance(node, Product) else (node,)
    fractions = [part for part in factors if isinstance(part, Quotient)]
    if len(fractions) != 1:
        return (), None
    (fraction,) = fractions
    above = (
        fraction.numerator.factors if isinstance(fraction.numerator, Product) else (fraction.numerator,)
    )
    return (*(part for part in factors if part is not fraction), *above), fraction.denominator


def _precision(node: Formula, fewest: int = FEWEST_DIGITS) -> float | None:
    """Return how far a number may be off, as a part of it; None if it has few digits."""
    if not is_lone_number(node):
        return CLOSE
    number = next(iter(parts_of_kind(node, Number)), None)
    if number is None or not number.value:
        return None
    half = float(number.last_place or 1) / 2
    part = half / abs(float(number.value))
    return part if part <= 0.5 * 10.0 ** (1 - fewest) else None


def _is_slip_of_digits(typed: float, exact: float) -> bool:
    """Tell whether a number is the exact one with digits exchanged, its sign, or a power of ten away."""
    powers = log10(abs(typed / exact))
    digits = [
        sorted(f"{abs(number):.{_DIGITS_COMPARED - 1}e}".split("e")[0]) for number in (typed, exact)
    ]
    return isclose(powers, round(powers), abs_tol=1e-3) or digits[0] == digits[1]
