"""Exponentials, logarithms, circular and hyperbolic functions, and inverses, of normal forms.

cos x and sin x are (e^(ix) ± e^(-ix))/2: an argument is split into monomials, each with its own
generator e^(i m), and multiples of pi become turns. e^(i asin v) = √(1-v²) + i v, and the like.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.notes.algebra.conjugation import PARTS
from symbalance.notes.algebra.domain import HALF, ONE, QUARTER, TURN, Domain, Monomial, NoFormError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.roots import root, unit

INVERSES = ("asin", "acos", "atan")
MEAN = "mean"
"""The mean of a form over one turn of `TURNING` (see `means`), a generator like a function."""
TURNING = "turning angle"
"""The letter that a mean binds: no written letter has a blank in its name."""


def exponential(argument: Form) -> Form:
    """Return e^argument: real parts become growth, imaginary ones turns and angles."""
    domain = argument.domain
    if not argument.is_polynomial:
        below = opaque("over", Form.of(domain, argument.denominator))
        argument = Form.of(domain, argument.numerator).times(below)
    result = Form.number(domain, 1)
    for monomial, coefficient in argument.numerator.items():
        result = result.times(_exponential_of_term(domain, monomial, coefficient))
    return result


def _exponential_of_term(domain: Domain, monomial: Monomial, coefficient: Fraction) -> Form:
    turns = dict(monomial).get(TURN, 0)
    rest = tuple((g, e) for g, e in monomial if g != TURN)
    if turns == 0:
        if rest == ONE:
            return Form.of(domain, {((domain.constant("e"), coefficient),): Fraction(1)})
        return Form.of(domain, {((domain.growth(rest), coefficient),): Fraction(1)})
    if turns != QUARTER:
        raise NoFormError("a power of e that is neither real nor imaginary")
    return _phase(domain, rest, coefficient)


def _phase(domain: Domain, monomial: Monomial, coefficient: Fraction) -> Form:
    """Return e^(i coefficient monomial)."""
    if monomial == ((domain.constant("pi"), 1),):
        factor, turn = domain.times(((TURN, coefficient * HALF),), ((TURN, Fraction(0)),))
        return Form.of(domain, {turn: Fraction(factor)})
    inverse = _inverse_function(domain, monomial)
    if inverse is not None and coefficient.denominator == 1:
        return _phase_of_inverse(*inverse, int(coefficient))
    generator = domain.exponential(monomial)
    factor, phase = domain.raised(((generator, 1),), coefficient)
    return Form.of(domain, {phase: Fraction(factor)})


def exponent_of(form: Form) -> Form | None:
    """Return x where a form is e^x, one product of exponentials and turns; None where it is not."""
    if not form.is_polynomial or len(form.numerator) != 1:
        return None
    domain = form.domain
    ((monomial, coefficient),) = form.numerator.items()
    total = Form.number(domain, 0)
    if coefficient != 1:
        return None
    for number, exponent in monomial:
        generator = domain.generators[number]
        if generator.kind == "turn":
            inner = Form.constant(domain, "pi").scaled(2).times(unit(domain))
        elif generator.kind in ("exponential", "growth"):
            inner = Form.of(domain, {generator.content: Fraction(1)})
            inner = inner.times(unit(domain)) if generator.kind == "exponential" else inner
        else:
            return None
        total = total.plus(inner.scaled(exponent))
    return total


def assume_whole(exponent: Form, base: Form) -> None:
    """Note that the letters of an exponent are whole: (e^(ix))^n = e^(inx) needs it."""
    domain = base.domain
    turning = {"turn", "exponential"} & {domain.generators[g].kind for m in base.numerator for g, _ in m}
    for monomial in exponent.numerator if turning else ():
        for number, _ in monomial:
            generator = domain.generators[number]
            if generator.kind == "symbol" and generator.content not in domain.integer:
                domain.assumptions[f"{generator.content} ∈ ℤ"] = None


def _inverse_function(domain: Domain, monomial: Monomial) -> tuple[str, Form] | None:
    if len(monomial) != 1 or monomial[0][1] != 1:
        return None
    generator = domain.generators[monomial[0][0]]
    if generator.kind == "opaque" and generator.content[0] in INVERSES:
        return generator.content
    return None


def _phase_of_inverse(function: str, value: Form, multiple: int) -> Form:
    """Return e^(i multiple f(value)) for f = asin, acos or atan, from cosine and sine of f(value)."""
    one = Form.number(value.domain, 1)
    if function == "atan":
        cosine = one.over(root(one.plus(value.times(value))))
        sine = value.times(cosine)
    else:
        complement = root(one.minus(value.times(value)))
        cosine, sine = (complement, value) if function == "asin" else (value, complement)
    sign = 1 if multiple >= 0 else -1
    return cosine.plus(unit(value.domain).times(sine).scaled(sign)).raised(abs(multiple))


def cosine(argument: Form) -> Form:
    """Return cos x = (e^(ix) + e^(-ix))/2."""
    forward, backward = _both_exponentials(argument)
    return forward.plus(backward).scaled(HALF)


def sine(argument: Form) -> Form:
    """Return sin x = (e^(ix) - e^(-ix))/(2i)."""
    forward, backward = _both_exponentials(argument)
    return forward.minus(backward).times(unit(argument.domain)).scaled(-HALF)


def _both_exponentials(argument: Form) -> tuple[Form, Form]:
    rotation = unit(argument.domain).times(argument)
    return exponential(rotation), exponential(rotation.scaled(-1))


def opaque(function: str, argument: Form) -> Form:
    """Return a function that has no rule here, as a generator; equal arguments share one.

    So do opposite ones of what is odd or even: arcsin(-x) = -arcsin x, J_0(-x) = J_0(x).
    """
    domain = argument.domain
    parity = _PARITY.get(function)
    opposite = argument.scaled(-1) if parity else argument
    for number in domain.opaque:
        name, content = domain.generators[number].content
        if name == function and content.equals(argument):
            return Form.of(domain, {((number, 1),): Fraction(1)})
        if parity and name == function and content.equals(opposite):
            return Form.of(domain, {((number, 1),): Fraction(parity)})
    number = domain.opaque_function((function, argument))
    return Form.of(domain, {((number, 1),): Fraction(1)})


_PARITY = {"asin": -1, "atan": -1, "besselj0": 1, "besselj1": -1}

# By the names that formulas give them


def apply(function: str, argument: Form) -> Form:
    """Return a function of a form; what has no rule raises NoFormError.

    >>> from symbalance.notes.algebra.domain import Domain
    >>> third = Form.constant(Domain(), "pi").scaled(Fraction(1, 3))
    >>> apply("cos", third).rational()
    """
    if function in _CIRCULAR:
        return _CIRCULAR[function](argument)
    if function in PARTS:
        return PARTS[function](argument)
    if function in ("asin", "acos", "atan", "factorial", "besselj0", "besselj1"):
        return opaque(function, argument)
    raise NoFormError(f"the function {function}")


def logarithm(base: Form) -> Form:
    """Return ln base; ln e is 1."""
    if base.equals(Form.constant(base.domain, "e")):
        return Form.number(base.domain, 1)
    if base.rational() == 1:
        return Form.number(base.domain, 0)
    power = _power_of_a_number(base)
    if power is not None:
        return opaque("ln", Form.number(base.domain, power[0])).scaled(power[1])
    return opaque("ln", base)


def _power_of_a_number(base: Form) -> tuple[int, int] | None:
    """Return (b, n) where a whole number is b^n with the largest n > 1: ln 100 is 2 ln 10."""
    value = base.rational()
    if value is None or value <= 0 or (value.numerator != 1 and value.denominator != 1):
        return None
    size, sign = (value.numerator, 1) if value.denominator == 1 else (value.denominator, -1)
    if size > LARGEST_POWER:
        return None
    for exponent in range(size.bit_length() - 1, 0, -1):
        root_ = round(size ** (1 / exponent))
        if root_ > 1 and root_**exponent == size and (exponent > 1 or sign < 0):
            return root_, sign * exponent
    return None


LARGEST_POWER = 10**15
"""Of a whole number that is looked at as a power: its root in floats is exact enough below."""


def _over(first: Callable[[Form], Form], second: Callable[[Form], Form]) -> Callable[[Form], Form]:
    return lambda x: first(x).over(second(x))


def _unity(argument: Form) -> Form:
    return Form.number(argument.domain, 1)


def _growing(sign: int) -> Callable[[Form], Form]:
    def function(x: Form) -> Form:
        back = exponential(x.scaled(-1)).scaled(sign)
        return exponential(x).plus(back).scaled(Fraction(1, 2))

    return function


_CIRCULAR: dict[str, Callable[[Form], Form]] = {
    "sin": sine,
    "cos": cosine,
    "tan": _over(sine, cosine),
    "cot": _over(cosine, sine),
    "sec": _over(_unity, cosine),
    "csc": _over(_unity, sine),
    "sinh": _growing(-1),
    "cosh": _growing(1),
    "tanh": _over(_growing(-1), _growing(1)),
    "exp": exponential,
    "ln": logarithm,
    "log": logarithm,
    "lg": lambda x: logarithm(x).over(logarithm(Form.number(x.domain, 10))),
    "sqrt": root,
}
