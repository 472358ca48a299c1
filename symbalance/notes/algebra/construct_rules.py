"""Forms of constructs with bounds and places: integrals, limits, values at a place, extrema, products.

A letter that a construct binds is free within it, whatever it stands for outside. What stands there for a
letter that is not known to be constant may change with the bound one: where the letter's value, known or
not yet used, holds the bound letter, there is no form; where nothing is known of it, that it does not
change is an assumption of the result.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from symbalance.document import formula
from symbalance.document.letters import is_greek, plain_letter
from symbalance.notes.algebra import combinatorics, integrals
from symbalance.notes.algebra.bessel import bessel_of
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import MEAN, TURNING
from symbalance.notes.algebra.means import mean
from symbalance.notes.algebra.polynomials import MOST_WORK
from symbalance.notes.algebra.roots import root
from symbalance.notes.algebra.series import Expansion
from symbalance.notes.algebra.substitution_in_forms import Dependence, depends, substitute_letter
from symbalance.notes.algebra.sums import closed_sum, indexed_letters
from symbalance.notes.algebra.values import Valuation, letters

if TYPE_CHECKING:
    from symbalance.notes.algebra.evaluation import FormEvaluator

LONGEST_PRODUCT = 400
_CONSTANT = "does not depend on"
_ONE_TURN = "∮ goes over one turn"


def may_fail(assumption: str, moving: Collection[str]) -> bool:
    """Tell whether an assumption is on what the document leaves open: nothing is refuted by it.

    Other letters may change with time or an angle, `moving`; they do not with a ratio that tends to 0.
    """
    if assumption.startswith("hat_"):
        return False  # a hat marks an amplitude, which no angle changes
    changes = {f"{_CONSTANT} {plain_letter(name)}" for name in moving}
    return assumption == _ONE_TURN or any(assumption.endswith(f" {text}") for text in changes)


# Bound letters ------------------------------------------------------------------------------------


def bound_form(evaluator: FormEvaluator, body: formula.Formula, variable: str) -> Form:
    """Return the form of a body within which a letter is free, after a look at the other letters."""
    form = evaluator.freeing(variable).form(body)
    refuse_what_may_change(evaluator, form, variable)
    return form


def refuse_what_may_change(evaluator: FormEvaluator, form: Form, variable: str) -> None:
    """Refuse letters that change with a bound letter; assume of unknown ones that they do not."""
    domain, meaning = form.domain, evaluator.meaning
    angles = {angle for rates in meaning.rates.values() for angle in rates}
    is_explicit = depends(form, domain.symbol(variable))
    for name in letters(form):
        if name == variable or name in meaning.constant or name in meaning.integer:
            continue
        if _changes_with(evaluator, name, variable):
            raise NoFormError(f"{plain_letter(name)} changes with {plain_letter(variable)}")
        if name in meaning.known or name in angles:
            continue
        if not is_explicit or (name.startswith("d") and "/" in name):
            what = f"{plain_letter(name)} may change with {plain_letter(variable)}"
            raise NoFormError(f"{what}, and nothing says how")
        text = f"{plain_letter(name)} {_CONSTANT} {plain_letter(variable)}"
        domain.assumptions[text] = None


def assume_constant(form: Form, names: Collection[str], variable: str) -> None:
    """Note that a derivative rests on letters that nobody declared not changing with its variable."""
    for name in sorted(names):
        form.domain.assumptions[f"{plain_letter(name)} {_CONSTANT} {plain_letter(variable)}"] = None


def _changes_with(evaluator: FormEvaluator, name: str, variable: str) -> bool:
    """Tell whether a letter's value, used at this level or not, holds the bound letter."""
    meaning = evaluator.meaning
    times = [time for time, rates in meaning.rates.items() if variable in rates]
    waiting, seen = [name], {name}
    while waiting:
        letter = waiting.pop()
        if letter == variable or letter in times or letter in meaning.rates.get(variable, {}):
            return True
        node = meaning.known.get(letter)
        for inner in sorted(formula.names(node) - seen) if node is not None else ():
            seen.add(inner)
            waiting.append(inner)
    return False


def turning_letter(evaluator: FormEvaluator, form: Form, what: str) -> str:
    """Return the letter that a construct binds without naming it: the angle, or the only one there is."""
    candidates = letters(form)
    angles = {name for rates in evaluator.meaning.rates.values() for name in rates}
    turned = _letters_within_angles(form)
    for group in (
        [name for name in candidates if name in angles],
        [name for name in candidates if name in turned],
        [name for name in candidates if is_greek(name) and name not in evaluator.meaning.constant],
        candidates,
    ):
        if len(group) == 1:
            return group[0]
    raise NoFormError(f"{what} that does not say in which letter it is taken")


def _letters_within_angles(form: Form) -> set[str]:
    """Return the letters that a sine or a cosine is taken of: φ in cos φ + λ cos 2φ, and not λ."""
    generators = form.domain.generators
    places = {place for part in (form.numerator, form.denominator) for m in part for place, _ in m}
    waves = [generators[place].content for place in places if generators[place].kind == "exponential"]
    inner = [generators[place] for wave in waves for place, _ in wave]
    return {generator.content for generator in inner if generator.kind == "symbol"}


# Integrals ----------------------------------------------------------------------------------------


def _integral(evaluator: FormEvaluator, node: formula.Integral) -> Form:
    if node.closed and node.lower is None:
        return _over_a_cycle(evaluator, node)
    if node.lower is None or node.upper is None:
        raise NoFormError("an integral without bounds, which is known up to a constant")
    name = node.variable.name
    inner = node.body
    if isinstance(inner, formula.Derivative) and inner.variable.name == name:
        whole = inner.expression
        if inner.order > 1:
            whole = formula.Derivative(inner.expression, inner.variable, inner.order - 1)
        upper = value_at(evaluator, whole, name, node.upper)
        return upper.minus(value_at(evaluator, whole, name, node.lower))
    form = bound_form(evaluator, inner, name)
    letter = evaluator.domain.symbol(name)
    lower, upper = evaluator.form(node.lower), evaluator.form(node.upper)
    _refuse_a_pole(form, letter, name)
    result = integrals.definite(form, letter, lower, upper)
    _refuse_assumptions_on(evaluator, name)
    return result


def _refuse_a_pole(form: Form, letter: int, name: str) -> None:
    """Refuse 1/x^2 between bounds: whether 0 lies between them is not looked into."""
    for monomial in form.numerator:
        if dict(monomial).get(letter, 0) < 0:
            raise NoFormError(f"an integral over a pole, where {name} may be 0")


def _over_a_cycle(evaluator: FormEvaluator, node: formula.Integral) -> Form:
    """Return the integral over one turn of an angle, from 0 to 2π."""
    name = node.variable.name
    form = bound_form(evaluator, node.body, name)
    domain = evaluator.domain
    letter = domain.symbol(name)
    pi = Form.constant(domain, "pi")
    if is_greek(name):
        _refuse_assumptions_on(evaluator, name)
        result = integrals.definite(form, letter, Form.number(domain, 0), pi.scaled(2))
        if not result.is_zero():
            domain.assumptions[_ONE_TURN] = None
        return result
    whole = integrals.antiderivative(form, letter)
    if any(dict(m).get(letter, 0) == -1 for m in form.numerator):
        raise NoFormError("an integral around a pole")
    if not depends(whole, letter):
        raise NoFormError("an integral around what is not said")
    return Form.number(domain, 0)


def _refuse_assumptions_on(evaluator: FormEvaluator, name: str) -> None:
    if any(text.startswith(f"{name} ") for text in evaluator.domain.assumptions):
        raise NoFormError(f"a root whose sign changes with {plain_letter(name)}")


# Values at a place --------------------------------------------------------------------------------


def value_at(
    evaluator: FormEvaluator, expression: formula.Formula, name: str, place: formula.Formula
) -> Form:
    """Return a formula's form with a letter replaced by its value at a place."""
    form = evaluator.freeing(name).form(expression)
    refuse_what_may_change(evaluator, form, name)
    if any(text.startswith(f"{name} ") for text in evaluator.domain.assumptions):
        return evaluator.replacing(name, place).form(expression)
    return substitute_letter(form, evaluator.domain.symbol(name), evaluator.form(place))


def _evaluation(evaluator: FormEvaluator, node: formula.Evaluation) -> Form:
    name = node.variable.name
    if not name:
        name = turning_letter(evaluator, evaluator.form(node.expression), "a bar")
    upper = value_at(evaluator, node.expression, name, node.upper)
    if node.lower is None:
        return upper
    return upper.minus(value_at(evaluator, node.expression, name, node.lower))


def _at(evaluator: FormEvaluator, letter: formula.Formula, place: formula.Formula) -> Form:
    """Return x(π), ẍ(0): what a letter, known as a function of an angle, or its derivative is there."""
    form, meaning = evaluator.form(letter), evaluator.meaning
    name = letter.name if isinstance(letter, formula.Name) else ""
    if name and form.equals(Form.letter(form.domain, name)):
        raise NoFormError(f"{plain_letter(name)}( ), a function of which nothing is known here")
    angles = {angle for rates in meaning.rates.values() for angle in rates}
    moving = [name for name in letters(form) if name in angles]
    still = angles | meaning.constant
    unused = [n for n in letters(form) if n not in still and (n in meaning.known or "/d" in n)]
    if unused:  # with ẍ a letter of its own, as any level may leave it, its value there is not 0
        raise NoFormError(f"{plain_letter(unused[0])} at a place, its value not put in")
    if not moving and letters(form) and all(n in meaning.constant for n in letters(form)):
        return form
    if not moving and _is_plain_number(place):
        raise NoFormError("a value at a place, and the page does not say of which letter")
    name = moving[0] if len(moving) == 1 else turning_letter(evaluator, form, "a value at a place")
    return value_at(evaluator, letter, name, _as_angle(evaluator, name, place))


def _is_plain_number(place: formula.Formula) -> bool:
    """Tell whether a place is a number that is no angle as people write it: 3000, and not 0 or π/2."""
    return isinstance(place, formula.Number) and abs(place.value) > _LARGEST_ANGLE


_LARGEST_ANGLE = 7
"""A place beyond it, a little over 2π, is no angle in radians."""


def _as_angle(evaluator: FormEvaluator, name: str, place: formula.Formula) -> formula.Formula:
    """Return a place in time as the angle reached: x(ωt) is x at θ, and so is x(t)."""
    for time, rates in evaluator.meaning.rates.items():
        if name not in rates or time not in formula.names(place):
            continue
        rate = rates[name]
        angle = _with_letter(place, time, formula.Quotient(formula.Name(name), rate))
        for candidate in (angle, formula.Product((rate, angle))):
            if not set(letters(evaluator.form(candidate))) & formula.names(rate):
                return candidate
        raise NoFormError("a place that is neither an angle nor a time")
    return place


def _with_letter(node: formula.Formula, name: str, by: formula.Formula) -> formula.Formula:
    """Return a formula with a letter replaced by a formula."""
    if isinstance(node, formula.Name):
        return by if node.name == name else node
    return formula.with_children(
        node, tuple(_with_letter(part, name, by) for part in formula.children(node))
    )


# Limits -------------------------------------------------------------------------------------------


def _limit(evaluator: FormEvaluator, node: formula.Limit) -> Form:
    """Return the limit by the power series about the point: its term of order 0."""
    domain, name = evaluator.domain, node.variable.name
    form, letter = bound_form(evaluator, node.body, name), domain.symbol(name)
    variable = Form.of(domain, {((letter, 1),): Fraction(1)})
    at_infinity = node.point in (formula.INFINITY, formula.Negative(formula.INFINITY))
    side = node.side
    if node.point == formula.Negative(formula.INFINITY):
        form, side = substitute_letter(form, letter, variable.scaled(-1)), -1
    if not at_infinity:
        point = evaluator.form(node.point)
        if depends(point, letter):
            raise NoFormError("a limit at a point that moves")
        form = substitute_letter(form, letter, variable.plus(point))
        is_upper = side == 1 and point.is_zero() is True
    else:
        is_upper = node.point == formula.INFINITY
    for text in [text for text in domain.assumptions if text.startswith(f"{name} ")]:
        if not is_upper:
            raise NoFormError("a limit whose value depends on the side")
        del domain.assumptions[text]
    series = Expansion(domain, name, -1 if at_infinity else 1, 0).of(form).cut(0)
    if series.start < 0 or series.through < 0:
        raise NoFormError("a limit that is not finite, or not reached by its series")
    return series.terms.get(0, Form.number(domain, 0))


# Extrema ------------------------------------------------------------------------------------------


def _extremum(evaluator: FormEvaluator, node: formula.Extremum) -> Form:
    """Return the largest or smallest value of one harmonic: c ± √(C² + S²)."""
    body = node.body
    of_size = isinstance(body, formula.Call) and body.function == "abs" and node.function == "max"
    if of_size and isinstance(body, formula.Call):
        body = body.argument
    name = node.variable.name or turning_letter(evaluator, evaluator.form(body), "an extremum")
    form = bound_form(evaluator, body, name)
    domain, dependence = form.domain, Dependence(form.domain, evaluator.domain.symbol(name))
    if dependence.of_polynomial(form.denominator):
        raise NoFormError("the extremum of a quotient")
    parts: dict[tuple[Any, ...], dict[Any, Fraction]] = {}
    for monomial, coefficient in form.numerator.items():
        moving = tuple((g, e) for g, e in monomial if dependence.of(g))
        free = tuple((g, e) for g, e in monomial if not dependence.of(g))
        parts.setdefault(moving, {})[free] = coefficient
    if not of_size and (exact := _of_two_cosines(parts, node.function)) is not None:
        return Form.number(domain, exact).over(Form.of(domain, form.denominator))
    constant = Form.of(domain, parts.pop((), {}))
    waves = list(parts)
    kinds = {domain.generators[g].kind for wave in waves for g, _ in wave}
    single = len(waves) == 2 and waves[0] == tuple((g, -e) for g, e in waves[1])
    if kinds != {"exponential"} or not single or (of_size and constant.is_zero() is not True):
        raise NoFormError("the extremum of what is no single harmonic")
    forward, backward = (Form.of(domain, parts[wave]) for wave in waves)
    amplitude = root(forward.times(backward).scaled(4))
    return constant.plus(amplitude.scaled(1 if node.function == "max" else -1)).over(
        Form.of(domain, form.denominator)
    )


def _of_two_cosines(parts: dict[tuple[Any, ...], dict[Any, Fraction]], function: str) -> Fraction | None:
    """Return the extremum of c + a cos θ + b cos 2θ in numbers, None of anything else.

    In u = cos θ it is b(2u² - 1) + a u + c: largest at u = ±1 or where 4 b u + a is 0.
    """
    waves = sorted((m for m in parts if m), key=lambda m: m[0][1])
    exponents = [m[0][1] for m in waves]
    unit = max(exponents, default=0) / 2
    if exponents != [-2 * unit, -unit, unit, 2 * unit] or len({g for m in waves for g, _ in m}) != 1:
        return None
    if any(set(part) != {()} for part in parts.values()):
        return None
    twice, once, once_too, twice_too = (parts[m][()] for m in waves)
    if twice != twice_too or once != once_too:
        return None
    a, b, c = 2 * once, 2 * twice, parts.get((), {(): Fraction(0)})[()]
    places = [Fraction(1), Fraction(-1), *([-a / (4 * b)] if abs(a) <= abs(4 * b) else [])]
    return (max if function == "max" else min)(b * (2 * u * u - 1) + a * u + c for u in places)


def _largest(evaluator: FormEvaluator, function: str, nodes: tuple[formula.Formula, ...]) -> Form:
    """Return the largest or smallest of several numbers; of two letters it has a root."""
    forms = [evaluator.form(node) for node in nodes]
    sign = 1 if function == "max" else -1
    if not any(letters(form) for form in forms):
        sizes = [Valuation(form.domain, {}).of(form) for form in forms]
        if any(size.imag for size in sizes):
            raise NoFormError(f"the {function} of what is not real")
        return max(zip(sizes, forms, strict=True), key=lambda pair: sign * pair[0].real)[1]
    total = forms[0]
    for form in forms[1:]:
        gap = total.minus(form)
        total = total.plus(form).plus(root(gap.times(gap)).scaled(sign)).scaled(Fraction(1, 2))
    return total


# Product signs, sums with a letter as their bound, several signs -----------------------------------


def _indexed_product(evaluator: FormEvaluator, node: formula.IndexedProduct) -> Form:
    lower, upper = (evaluator.form(bound).rational() for bound in (node.lower, node.upper))
    if lower is None or upper is None:
        return _product_in_letters(evaluator, node)
    if not lower.denominator == upper.denominator == 1:
        raise NoFormError("a product sign without bounds in whole numbers")
    if upper - lower > LONGEST_PRODUCT:
        raise NoFormError("a product of very many factors")
    domain = evaluator.domain
    domain.work += 100 * max(int(upper - lower), 0)
    if domain.work > MOST_WORK:
        raise TooLargeError("products of very many factors")
    total = Form.number(domain, 1)
    for value in range(int(lower), int(upper) + 1):
        inner = evaluator.replacing(node.index.name, formula.Number(Fraction(value)))
        total = total.times(inner.form(node.body))
    return total


def _product_in_letters(evaluator: FormEvaluator, node: formula.IndexedProduct) -> Form:
    """Return a product of k + c from one whole bound to another: a quotient of factorials."""
    lower, upper = evaluator.form(node.lower), evaluator.form(node.upper)
    if not all(_is_whole(evaluator, form) for form in (lower, upper)):
        raise NoFormError("a product whose bounds are not known to be whole numbers")
    index = Form.letter(evaluator.domain, node.index.name)
    shift = evaluator.freeing(node.index.name).form(node.body).minus(index).rational()
    if shift is None or shift.denominator != 1:
        raise NoFormError("a product of such factors with a letter as its bound")
    by = Form.number(evaluator.domain, shift)
    first = lower.minus(Form.number(evaluator.domain, 1)).plus(by)
    return combinatorics.factorial_of(upper.plus(by)).over(combinatorics.factorial_of(first))


def _is_whole(evaluator: FormEvaluator, form: Form) -> bool:
    """Tell whether a form is a sum of whole multiples of products of letters that are whole numbers."""
    whole = form.is_polynomial and all(c.denominator == 1 for c in form.numerator.values())
    return whole and all(name in evaluator.meaning.integer for name in letters(form))


def summed_in_letters(evaluator: FormEvaluator, node: formula.Summation) -> Form:
    """Return a sum whose bounds hold letters, all of them whole numbers, in closed form."""
    assert node.index is not None
    assert node.lower is not None
    assert node.upper is not None
    lower, upper = evaluator.form(node.lower), evaluator.form(node.upper)
    if not all(_is_whole(evaluator, form) for form in (lower, upper)):
        raise NoFormError("a sum whose bounds are not known to be whole numbers")
    index = node.index.name
    if any(name not in evaluator.meaning.values for name in indexed_letters(node.body, index)):
        raise NoFormError(f"a sum of letters that carry its index {plain_letter(index)}")
    form = evaluator.counting(index).freeing(index).form(node.body)
    if any(name != index and _changes_with(evaluator, name, index) for name in letters(form)):
        raise NoFormError(f"a sum of letters that change with {plain_letter(index)}")
    return closed_sum(form, evaluator.domain.symbol(node.index.name), lower, upper)


def _plus_minus(evaluator: FormEvaluator, node: formula.PlusMinus) -> Form:
    raise NoFormError("both signs at once")


def _cases(evaluator: FormEvaluator, node: formula.Cases) -> Form:
    """Return the value whose condition holds, where all conditions before it are decided."""
    for value, condition in zip(node.values, node.conditions, strict=True):
        if condition is None or _holds(evaluator, condition):
            return evaluator.form(value)
    raise NoFormError("cases of which none holds")


def _holds(evaluator: FormEvaluator, condition: tuple[formula.Formula, str, formula.Formula]) -> bool:
    left, sign, right = evaluator.form(condition[0]), condition[1], evaluator.form(condition[2])
    difference = left.minus(right)
    if sign in ("=", "≠") and (same := difference.is_zero()) is not None and not letters(difference):
        return same is (sign == "=")
    size = difference.rational()
    if size is None:
        raise NoFormError("cases whose condition is open")
    return {"<": size < 0, ">": size > 0, "≤": size <= 0, "≥": size >= 0}.get(sign, False)


def _apply(evaluator: FormEvaluator, node: formula.Apply) -> Form:
    arguments = node.arguments
    if node.function == "at":
        return _at(evaluator, *arguments)
    if node.function in ("max", "min"):
        return _largest(evaluator, node.function, arguments)
    if node.function not in _APPLIED:
        raise NoFormError(f"the function {node.function}")
    return _APPLIED[node.function](*map(evaluator.form, arguments))


_APPLIED: dict[str, Callable[..., Form]] = {
    "factorial": combinatorics.factorial_of,
    "binomial": combinatorics.binomial_of,
    "kronecker": combinatorics.kronecker_of,
    "besselj": bessel_of,
    MEAN: lambda form: mean(form, form.domain.symbol(TURNING)),
}

RULES: dict[type, Callable[[Any, Any], Form]] = {
    formula.Integral: _integral,
    formula.Evaluation: _evaluation,
    formula.Limit: _limit,
    formula.Extremum: _extremum,
    formula.IndexedProduct: _indexed_product,
    formula.PlusMinus: _plus_minus,
    formula.Cases: _cases,
    formula.Apply: _apply,
}
"""A function for each construct, of an evaluator and the construct's node."""
