"""Decisions whether two sides agree through an order of a small letter, as ≈ or "..." states.

The small letter is the rod ratio where it occurs (ρ small, λ large), else a letter in which the line is
a polynomial. The order a line keeps is the highest power of it there; both sides must agree through it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import Call, Formula, Name, Number, Quotient, names
from symbalance.document.letters import plain_letter, raised
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import Monomial, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import components
from symbalance.notes.algebra.series import Expansion, FormSeries
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.algebra.zero import is_zero
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
    digits,
    printed_decimal,
    refuted_by_formulas,
    without_dots,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.numbers_put_in import agrees_to_its_digits
from symbalance.notes.checking.deciding.rounding import ROUGHLY, agrees_as_printed, decimals

HIGHEST_ORDER = 40
"""Through which two sides are compared; a series beyond it is left undecided."""
NOT_SMALL = 0.95
"""From this on no letter is small."""
RELATIVE_ERROR = "relative error"
"""Before the measure of how closely two numbers agree."""
HIGHEST_NAMED = 26
"""An order beyond it says only that all powers written agree."""
NO_LETTER = "no letter in which one side is a cut-off series"
ADDED = "agrees through the order of one side only; nothing gives the terms that the other adds"
IS_SMALL, IS_LARGE = " is small", " is large"
LARGEST_PART = 16
"""The parts that a whole is divided into where a fraction stands for a decimal: 0.374 ≈ 3/8."""
ROUGH = Fraction(1, 20)
"""Relative error that ≈ between two numbers without decimals may have, if they have no two digits."""


@dataclass(frozen=True, slots=True)
class SmallLetter:
    """A letter to expand in: `sign` -1 where it is large, and the order a line keeps of it."""

    letter: str
    sign: int
    order: int

    @property
    def text(self) -> str:
        """The order kept, as a power of the letter."""
        if not self.order:
            return "leading term"
        if self.order > HIGHEST_NAMED:
            return "all powers written"
        return formula_text(Name(self.letter), plain=True) + raised(
            str(self.sign * self.order).replace("-", "−")
        )


def decide_agreement(
    left: Formula,
    right: Formula,
    knowledge: Knowledge,
    *,
    through: int | None = None,
    loose: bool = False,
    by_series_alone: bool = False,
) -> Decision:
    """Decide whether two sides agree through the order the right one keeps.

    `through` overrides that order. `loose` leaves out harmonics above the highest that the right side
    has: what dots after the last harmonic stand for.
    """
    left, left_is_cut = without_dots(left)
    right, right_is_cut = without_dots(right)
    exact = Decision(UNDECIDED) if by_series_alone else decide_equality(left, right, knowledge)
    if exact.is_proved and through is None:
        return exact
    if through is None and _begin_alike(left, right, knowledge):
        return Decision(PROVED, order="leading term")
    best, levels = exact, list(knowledge.levels(left, right))
    clear: Decision | None = None
    is_loose = loose or right_is_cut or left_is_cut
    for level in levels:
        decision = _at_level(left, right, knowledge, level, through, is_loose)
        if decision.is_proved:
            is_series = _is_of_one_letter(left, right) and decision.order.startswith(RELATIVE_ERROR)
            return best if is_series and best.status == REFUTED and not is_loose else decision
        best = decision
        if clear is None and _is_clear(decision, knowledge):
            clear = decision
    if not decimals(left) and not decimals(right):
        best = refuted_by_formulas(
            best, levels, lambda level: _at_level(left, right, knowledge, level, through, is_loose)
        )
    if exact.status == REFUTED and (best.reason == NO_LETTER or _are_numbers_apart(exact)):
        best = replace(exact, reason="")
    return clear if clear is not None and best.status == REFUTED and not is_loose else best


def _is_of_one_letter(left: Formula, right: Formula) -> bool:
    """Tell whether both sides are of the same one letter: then a series is meant, and no number.

    √(1 - D²) is about 1 - D²/2; that D = 0.05 puts it near 1 - D too proves nothing.
    """
    return len(names(left) | names(right)) == 1 and names(left) == names(right)


def _are_numbers_apart(refutation: Decision) -> bool:
    """Tell whether two numbers without a normal form, as cube roots, differ by more than ≈ forgives."""
    witness = refutation.witness or {}
    if refutation.left is not None or witness.keys() != {"left", "right"}:
        return False
    try:
        left, right = (abs(float(witness[side])) for side in ("left", "right"))
    except ValueError:  # a complex number
        return False
    return abs(left - right) > ROUGHLY * max(left, right)


_LIKE_THEIR_ARGUMENT = ("sin", "tan", "asin", "atan", "sinh", "tanh")
"""Functions whose value for a small argument is that argument."""


def _begin_alike(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether two functions of a letter called small are both nearly it: tan β ≈ sin β."""
    are_calls = isinstance(left, Call) and isinstance(right, Call) and left.argument == right.argument
    if not are_calls or not isinstance(left, Call) or not isinstance(right, Call):
        return False
    is_small = isinstance(left.argument, Name) and left.argument.name in knowledge.small
    return is_small and {left.function, right.function} <= {*_LIKE_THEIR_ARGUMENT}


def _is_clear(decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether a refutation is by the powers of the small letter, and all letters stand on the right.

    That is what a reader can follow: r²/l beside λ, and x beside what it is, say less.
    """
    if decision.status != REFUTED or decision.left is None or decision.right is None:
        return False
    letter, usual = decision.expanded_in, knowledge.crank.small if knowledge.crank else None
    is_small = letter in knowledge.small or (usual is not None and letter == usual[0])
    own = {*values.letters(decision.left)}  # none where the other side hides its powers: 0 beside F q
    return is_small and bool(own) and own <= {*values.letters(decision.right)}


def _at_level(
    left: Formula, right: Formula, knowledge: Knowledge, level: Level, through: int | None, loose: bool
) -> Decision:
    """Decide with what one level knows, in the first small letter that proves it."""
    evaluator = knowledge.evaluator(level)
    try:
        first, second = evaluator.form(left), evaluator.form(right)
        if not values.letters(first) and not values.letters(second):
            return _as_numbers(left, right, evaluator, (first, second), level, knowledge.printed)
    except (NoFormError, TooLargeError) as problem:
        return Decision(UNDECIDED, f"no normal form: {problem}", level=level)
    best = Decision(
        UNDECIDED,
        NO_LETTER,
        level=level,
        left=first,
        right=second,
    )
    for small in _candidates(first, second, knowledge, through):
        try:
            is_first = best.status != REFUTED  # a witness is sought once: the first refutation is kept
            decision = agreement_through(first, second, small, level, loose, with_witness=is_first)
        except (NoFormError, TooLargeError) as problem:
            decision = Decision(UNDECIDED, f"no power series in {small.letter}: {problem}", level=level)
        if decision.is_proved and through is None and _adds_terms(first, second, small):
            decision = Decision(UNDECIDED, ADDED, level=level, left=first, right=second)
        if decision.is_proved:
            is_series = loose or through is not None  # with dots, or an order that is named
            return decision if is_series else _with_its_assumption(decision, small, knowledge)
        best = decision if best.status != REFUTED else best
    return best


def _with_its_assumption(decision: Decision, small: SmallLetter, knowledge: Knowledge) -> Decision:
    """Return an agreement with what it rests on: that a letter is small, where nobody has said so."""
    usual = knowledge.crank.small[0] if knowledge.crank and knowledge.crank.small else None
    is_known = small.letter == usual or small.letter in knowledge.small
    known = "" if small.letter == usual or small.sign < 0 else known_not_small(small.letter, knowledge)
    if is_known and not known:
        return decision
    if known:
        return Decision(UNDECIDED, f"it takes {plain_letter(small.letter)} for small: {known}")
    text = formula_text(Name(small.letter), plain=True) + (IS_SMALL if small.sign > 0 else IS_LARGE)
    return replace(decision, assumptions=(*decision.assumptions, text))


def known_not_small(letter: str, knowledge: Knowledge) -> str:
    """Return what the page says of a letter by which it is not small, η = 5 or η > 1; "" for nothing."""
    definition = knowledge.definitions.get(letter)
    if definition is not None and definition.numeric:
        points = sample_trees([definition.node], SymbolValue(), 1)
        if points and abs(points[0][1][0]) >= NOT_SMALL:
            return f"{plain_letter(letter)} = {formula_text(definition.node, plain=True)}"
    for stated in knowledge.ranges:
        first, last = (stated.left, stated.right) if stated.sign in ">≥≫" else (stated.right, stated.left)
        is_above = stated.sign in ">≥≫<≤≪" and first == Name(letter) and isinstance(last, Number)
        if is_above and isinstance(last, Number) and last.value >= 1:
            return stated.text
    return ""


def _as_numbers(
    left: Formula,
    right: Formula,
    evaluator: FormEvaluator,
    forms: tuple[Form, Form],
    level: Level,
    printed: Collection[float],
) -> Decision:
    """Compare two numbers: to the digits printed where there are any, else saying how closely."""
    first, second = forms
    points = values.sample([first, second])
    if not points:
        return Decision(UNDECIDED, "no value", level=level)
    left_value, right_value = points[0][1]
    relative_error = abs(left_value - right_value) / max(
        abs(left_value), abs(right_value), values.context().mpf(10) ** -300
    )
    if decimals(left) or decimals(right):
        fits = agrees_as_printed(
            left, right, evaluator.form, level.values, generous=True, printed=printed
        )
        order = "the digits printed"
        if not fits and _is_nearest_part(right, left_value):
            fits, order = True, f"{RELATIVE_ERROR} {digits(relative_error, 2)}"
    else:
        fits = relative_error <= float(ROUGH) and agrees_to_its_digits(
            left, right, (left_value, right_value)
        )
        order = f"{RELATIVE_ERROR} {digits(relative_error, 2)}"
    if fits:
        return Decision(
            PROVED, order=order, assumptions=level.assumptions, level=level, left=first, right=second
        )
    witness = {"left": digits(left_value), "right": digits(right_value)}
    return Decision(REFUTED, level=level, left=first, right=second, witness=witness)


def _is_nearest_part(side: Formula, value: Any) -> bool:
    """Tell whether a side is the simple fraction that a number is nearest to: 0.0317 ≈ 1/32.

    The other way round it is a result, and has to be rounded: 1/3 is not 0.34.
    """
    if not isinstance(side, Quotient) or not value.real:
        return False
    above, below = side.numerator, side.denominator
    if not isinstance(above, Number) or not isinstance(below, Number):
        return False
    if any(part.last_place is not None or part.value.denominator != 1 for part in (above, below)):
        return False
    if above.value == 1:
        return round(1 / float(value.real)) == below.value and below.value > 1
    is_simple = 1 <= above.value < below.value <= LARGEST_PART
    return is_simple and abs(float(value.real * below.value / above.value) - 1) <= ROUGHLY


def _candidates(
    first: Form, second: Form, knowledge: Knowledge, through: int | None
) -> Iterator[SmallLetter]:
    """Yield the letters in which a side may be cut off, the one that is called small first.

    The first refutation is the one that is shown: by the powers of λ, not by those of the r before all.
    """
    letters = values.letters(first) + values.letters(second)
    usual = knowledge.crank.small if knowledge.crank else None
    if usual is not None and usual[0] in letters:
        order = _order_kept(first, second, *usual)
        if order is not None or through is not None:
            yield SmallLetter(*usual, order if through is None else through)  # type: ignore[arg-type]
    for letter in sorted(dict.fromkeys(letters), key=lambda letter: letter not in knowledge.small):
        for sign in (1, -1):
            order = _order_kept(first, second, letter, sign)
            if order and (usual is None or letter != usual[0]):
                yield SmallLetter(letter, sign, order)


def _adds_terms(first: Form, second: Form, small: SmallLetter) -> bool:
    """Tell whether the right side goes on in the small letter where the left one ends as it is.

    A polynomial on the left is exact: sin θ is not roughly sin θ + λ cos θ, whatever is small.
    """
    kept, written = (degree(form, small.letter, small.sign) for form in (first, second))
    return kept is not None and written is not None and kept < written


def _order_kept(first: Form, second: Form, letter: str, sign: int) -> int | None:
    """Return the order kept: the degree of the side that is a polynomial in the letter."""
    degrees = [degree(form, letter, sign) for form in (first, second) if form.numerator]
    whole_degrees = [d for d in degrees if d is not None]
    return min(whole_degrees) if whole_degrees and min(whole_degrees) <= HIGHEST_ORDER else None


def degree(form: Form, letter: str, sign: int) -> int | None:
    """Return the highest power of letter^sign in a form that is a polynomial in it, else None."""
    if not form.is_polynomial:
        return None
    number = form.domain.symbol(letter)
    series = Expansion(form.domain, letter, sign, 0)
    exponents = [Fraction(0)]
    for monomial in form.numerator:
        for generator, exponent in monomial:
            if generator == number:
                exponents.append(Fraction(exponent * sign))
            elif series.depends(generator):
                return None
    top = max(exponents)
    return int(top) if top.denominator == 1 else None


def power_written(node: Formula, letter: str, agreement: Decision, knowledge: Knowledge) -> int | None:
    """Return the highest power of a small letter in a formula; None where it is no polynomial in it.

    Of one that is called large it is that of its inverse. A formula without a normal form raises.
    """
    is_inverse = "⁻" in agreement.order or f"{plain_letter(letter)}{IS_LARGE}" in agreement.assumptions
    level = agreement.level or list(knowledge.levels(node, node))[-1]
    return degree(knowledge.evaluator(level).form(node), letter, -1 if is_inverse else 1)


def proved_through(
    power: int, order: str, level: Level, left: Form, right: Form, letter: str = ""
) -> Decision:
    """Return that two sides agree through a power of the small letter, to an order in words."""
    return Decision(
        PROVED,
        order=order,
        assumptions=level.assumptions,
        level=level,
        left=left,
        right=right,
        through=power,
        expanded_in=letter,
    )


def agreement_through(
    first: Form, second: Form, small: SmallLetter, level: Level, loose: bool, *, with_witness: bool
) -> Decision:
    """Decide by the series of both sides in one letter, through the order that is kept of it."""
    expansion = Expansion(first.domain, small.letter, small.sign, small.order)
    exact = expansion.of(first)
    left = exact.cut(small.order)
    right = expansion.of(second).cut(small.order)
    if min(left.through, right.through) < small.order:
        raise NoFormError("the series does not reach that order")
    if not left.terms and not right.terms:
        raise NoFormError("nothing of either side is kept")
    difference = left.plus(right.scaled(Form.number(first.domain, -1)))
    if not difference.terms:
        return proved_through(small.order, small.text, level, first, second, small.letter)
    left_form, right_form = truncated_sum(left, small), truncated_sum(right, small)
    if loose and _only_higher(left_form, right_form):
        order = f"{small.text}, harmonics to {_highest(right_form)}"
        return proved_through(small.order, order, level, left_form, right_form, small.letter)
    if _leading_terms_agree(left_form, right_form, small):
        order = "the leading term of each harmonic"
        return proved_through(small.order, order, level, left_form, right_form, small.letter)
    order = f"{small.text}"
    if not with_witness:
        return Decision(REFUTED, order=order, level=level, through=small.order)
    witness = witness_of(left_form, right_form)
    further = tuple(truncated_sum(exact.cut(small.order + n), small) for n in (1, 2))
    return Decision(
        REFUTED,
        order=order,
        level=level,
        left=left_form,
        right=right_form,
        witness=witness,
        through=small.order,
        expanded_in=small.letter,
        further=further,
    )


def witness_of(left: Form, right: Form) -> dict[str, str]:
    """Return a point's letters and the values of two forms there; nothing where none is real."""
    points = values.sample([left, right])
    if not points:
        return {}
    point, pair = points[0]
    witness = {n: printed_decimal(v) for n, v in point.items()}
    return witness | {"left": digits(pair[0]), "right": digits(pair[1])}


def truncated_sum(series: FormSeries, small: SmallLetter) -> Form:
    """Return a series as a form again, cut off at its order."""
    number = series.domain.symbol(small.letter)
    total = Form.number(series.domain, 0)
    for k, form in series.terms.items():
        power: Polynomial = {((number, k * small.sign),): Fraction(1)} if k else {(): Fraction(1)}
        total = total.plus(form.times(Form.of(series.domain, power)))
    return total


def _leading_terms_agree(left: Form, right: Form, small: SmallLetter) -> bool:
    """Tell whether the right side has one term of each harmonic, the first that the left one has of it.

    cos θ + ρ cos 2θ - ρ³/4 cos 4θ is written so, although ρ³ belongs to cos 2θ as well. No harmonic below
    the highest may be missing.
    """
    if not left.is_polynomial or not right.is_polynomial:
        return False
    exact, claimed = _by_harmonic(left, small), _by_harmonic(right, small)
    if len(claimed) < 2 or any(len(powers) > 1 for powers in claimed.values()):
        return False
    top = max(harmonic[1] for harmonic in claimed)
    if any(harmonic not in claimed for harmonic in exact if harmonic[1] <= top):
        return False
    for harmonic, powers in claimed.items():
        ((power, number),) = powers.items()
        own = exact.get(harmonic, {})
        if not own or min(own) != power:
            return False
        if is_zero(left.domain, poly.minus(own[power], number)) is not True:
            return False
    return True


def _by_harmonic(
    form: Form, small: SmallLetter
) -> dict[tuple[str, Fraction, Monomial, Monomial], dict[Fraction, Polynomial]]:
    """Return a form's coefficients by harmonic (function, order, angle, other letters) and power."""
    number = form.domain.symbol(small.letter)
    parts: dict[tuple[str, Fraction, Monomial, Monomial], dict[Fraction, Polynomial]] = {}
    for key, value in components(form.domain, form.numerator).items():
        rest = tuple(entry for entry in key.letters if entry[0] != number)
        power = Fraction(dict(key.letters).get(number, 0)) * small.sign
        order = max((Fraction(abs(e)) for _, e in key.angle), default=Fraction(0))
        parts.setdefault((key.function, order, key.angle, rest), {})[power] = value
    return parts


def _only_higher(left: Form, right: Form) -> bool:
    """Tell whether two polynomials differ only in harmonics above the highest of the right one."""
    difference = left.minus(right)
    if not difference.is_polynomial or not right.is_polynomial:
        return False
    top = _highest(right)
    if not top:
        return False
    keys = components(left.domain, difference.numerator)
    return all(max((abs(e) for _, e in key.angle), default=0) > top for key in keys)


def _highest(form: Form) -> Fraction:
    keys = components(form.domain, form.numerator) if form.is_polynomial else {}
    return max((Fraction(abs(e)) for key in keys for _, e in key.angle), default=Fraction(0))
