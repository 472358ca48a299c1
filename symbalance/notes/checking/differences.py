"""Where two sides differ, coefficient by coefficient: of which term, what is claimed, what is exact."""

from __future__ import annotations

from symbalance.document.formula import Number, walk
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import Domain, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import components, ordered, place_node, polynomial_node
from symbalance.notes.algebra.numbers import number_node
from symbalance.notes.algebra.values import Valuation
from symbalance.notes.algebra.zero import is_zero
from symbalance.notes.checking.deciding.steps import Answer, digits
from symbalance.notes.checking.verdicts import Difference

MOST = 12
LONGEST = 600


def exact_text(answer: Answer) -> str:
    """Return the left side of an answer as a sum of harmonics, if it is short enough to be read."""
    return form_text(answer.left)


def form_text(form: Form | None) -> str:
    """Return a form as text; empty if it is a quotient or too long to be read."""
    if form is None or len(form.numerator) > 60:
        return ""
    try:
        above = polynomial_node(form.domain, form.numerator)
        if form.is_polynomial:
            printed = formula_text(above, plain=True)
        else:
            below = polynomial_node(form.domain, form.denominator)
            printed = f"({formula_text(above, plain=True)})/({formula_text(below, plain=True)})"
    except (NoFormError, TooLargeError):
        return ""
    return printed if len(printed) <= LONGEST else ""


def differences(answer: Answer) -> tuple[Difference, ...]:
    """Return the coefficients in which the claimed (right) side differs from the exact (left) one."""
    left, right = answer.left, answer.right
    if left is None or right is None or not (left.is_polynomial and right.is_polynomial):
        return ()
    if max(len(left.numerator), len(right.numerator)) > 400:
        return ()
    if left.rational() is not None and right.rational() is not None:
        return ()  # two numbers: the witness says it
    domain = left.domain
    exact, claimed = components(domain, left.numerator), components(domain, right.numerator)
    found: list[Difference] = []
    for place in ordered({**exact, **claimed}):
        one, other = exact.get(place, {}), claimed.get(place, {})
        if is_zero(domain, poly.minus(one, other)) is not True:
            node = place_node(domain, place)
            term = "constant" if node is None else formula_text(node, plain=True)
            found.append(Difference(term, number_text(domain, other), number_text(domain, one)))
    return tuple(found[:MOST])


def number_text(domain: Domain, number: Polynomial) -> str:
    """Return a number as text: exact where it is short, else with 12 digits."""
    node = number_node(domain, number)
    long = any(
        isinstance(part, Number) and max(part.value.numerator, part.value.denominator) > 10**9
        for part in walk(node)
    )
    if long or not poly.is_rational(number):
        printed = formula_text(node, plain=True)
        if long or len(printed) > 40:
            return digits(Valuation(domain, {}).polynomial(number))
        return printed
    return formula_text(node, plain=True)
