"""The complex conjugate of a normal form, with real and imaginary parts and the absolute value.

Letters are real; a complex letter is the sum of two. Turns and phases change sign, i is a quarter turn.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.notes.algebra.domain import HALF, NoFormError, Polynomial
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.roots import root, unit


def conjugate(form: Form) -> Form:
    """Return the complex conjugate.

    >>> from symbalance.notes.algebra.domain import Domain
    >>> i = unit(Domain())
    >>> conjugate(i).equals(i.scaled(-1))
    True
    """
    above, below = _polynomial(form, form.numerator), _polynomial(form, form.denominator)
    return above if form.is_polynomial else above.over(below)


def _polynomial(form: Form, polynomial: Polynomial) -> Form:
    domain = form.domain
    image: dict[tuple[tuple[int, int | Fraction], ...], Fraction] = {}
    for monomial, coefficient in polynomial.items():
        exponents: dict[int, int | Fraction] = {}
        for number, exponent in monomial:
            kind = domain.generators[number].kind
            _refuse_complex_content(form, number)
            exponents[number] = -exponent if kind in ("turn", "exponential") else exponent
        factor, mirrored = domain.raised(tuple(exponents.items()), 1)
        image[mirrored] = image.get(mirrored, Fraction(0)) + coefficient * factor
    return Form.of(domain, {m: c for m, c in image.items() if c})


def _refuse_complex_content(form: Form, number: int) -> None:
    """Refuse a function or an exponential of what is not real."""
    domain, generator = form.domain, form.domain.generators[number]
    if generator.kind == "opaque":
        argument = generator.content[1]
        if not conjugate(argument).equals(argument):
            raise NoFormError("the conjugate of a function of a complex number")
    elif generator.kind in ("exponential", "growth"):
        content = Form.of(domain, {generator.content: Fraction(1)})
        if not conjugate(content).equals(content):
            raise NoFormError("the conjugate of a power of a complex number")
    elif generator.kind == "radical":
        content = Form.of(domain, generator.content)
        if not conjugate(content).equals(content):
            raise NoFormError("the conjugate of the root of a complex number")


def real_part(form: Form) -> Form:
    """Return (z + z̄)/2."""
    return form.plus(conjugate(form)).scaled(HALF)


def imaginary_part(form: Form) -> Form:
    """Return (z - z̄)/(2i)."""
    return form.minus(conjugate(form)).times(unit(form.domain)).scaled(-HALF)


def absolute_value(form: Form) -> Form:
    """Return √(z z̄), of a real form √(x²)."""
    try:
        mirrored = conjugate(form)
    except NoFormError:
        return root(form.times(form))
    return root(form.times(form if mirrored.equals(form) else mirrored))


PARTS: dict[str, Callable[[Form], Form]] = {
    "conj": conjugate,
    "re": real_part,
    "im": imaginary_part,
    "abs": absolute_value,
}
"""The functions of a complex number, by the names that formulas give them."""
