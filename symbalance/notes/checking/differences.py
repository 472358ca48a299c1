"""Where two sides differ, coefficient by coefficient: of which term, what is claimed, what is exact."""

from __future__ import annotations

from symbalance.document.formula import Decimal, Formula, Number, Quotient, Upright, walk
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import Domain, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.harmonics import components, ordered, place_node, polynomial_node
from symbalance.notes.algebra.numbers import number_node
from symbalance.notes.algebra.values import Valuation
from symbalance.notes.algebra.zero import is_zero
from symbalance.notes.checking.deciding.steps import Answer, digits
from symbalance.notes.checking.verdicts import Difference

MOST = 12
LONGEST = 600


def exact_value(answer: Answer) -> tuple[str, Formula | None]:
    """Return the left side of an answer as a sum of harmonics, as text and as a formula.

    ("", None) if it has no normal form or is too long to be read.
    """
    form = answer.left
    if form is None or len(form.numerator) > 60:
        return "", None
    try:
        above = polynomial_node(form.domain, form.numerator)
        printed, node = formula_text(above, plain=True), above
        if not form.is_polynomial:
            below = polynomial_node(form.domain, form.denominator)
            printed, node = f"({printed})/({formula_text(below, plain=True)})", Quotient(above, below)
    except (NoFormError, TooLargeError):
        return "", None
    return (printed, node) if len(printed) <= LONGEST else ("", None)


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
            (claimed_text, claimed_node), (exact_text, exact_node) = (
                shown_number(domain, number) for number in (other, one)
            )
            found.append(Difference(term, claimed_text, exact_text, node, claimed_node, exact_node))
    return tuple(found[:MOST])


def shown_number(domain: Domain, number: Polynomial) -> tuple[str, Formula]:
    """Return a number as text and as a formula: exact where it is short, else with 12 digits."""
    node = number_node(domain, number)
    long = any(
        isinstance(part, Number) and max(part.value.numerator, part.value.denominator) > 10**9
        for part in walk(node)
    )
    printed = formula_text(node, plain=True)
    if long or (len(printed) > 40 and not poly.is_rational(number)):
        printed = digits(Valuation(domain, {}).polynomial(number))
        return printed, rounded_number(printed)
    return printed, node


def rounded_number(printed: str) -> Formula:
    """Return a number printed in decimals as a formula; a complex one stays as it is printed.

    >>> rounded_number("0.25").text, type(rounded_number("(1.0 + 2.0j)")).__name__
    ('0.25', 'Upright')
    """
    try:
        float(printed)
    except ValueError:
        return Upright(printed)
    return Decimal(printed)
