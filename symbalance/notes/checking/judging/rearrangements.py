"""Whether one relation is another one rearranged: 2x = 6 and x = 3, v = r ω and ω = v/r.

Both are brought to the form polynomial = 0 (or > 0). They say the same where one polynomial is the other
times what is never zero: a number, or a product of letters, of each of which it is a condition that it is
not zero unless it is positive.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from fractions import Fraction

from symbalance.document.formula import Name, Negative, Sum
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import TURN, Domain, Monomial, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.zero import is_zero
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_TURNED = {">": "<", "<": ">", "≥": "≤", "≤": "≥"}
MOST_RELATIONS = 6
"""Of the chain on the left, from its end."""


def rearrangement(
    left: Chain, right: Chain, positive: Collection[str], *, is_both_ways: bool
) -> tuple[str, ...] | None:
    """Return the conditions under which a chain's first relation is one of another chain rearranged.

    None where that is not shown. With `is_both_ways` the other way too: both chains are of one relation.
    """
    if is_both_ways and len(left.relations) + len(right.relations) > 2:
        return None
    for k in range(len(left.relations) - 1, max(len(left.relations) - 1 - MOST_RELATIONS, -1), -1):
        try:
            conditions = _factor(left, k, right, frozenset(positive), is_both_ways)
        except (NoFormError, TooLargeError):
            continue  # a relation of matrices, of derivatives or of sums without end: not shown
        if conditions is not None:
            return conditions
    return None


def _factor(
    left: Chain, k: int, right: Chain, positive: frozenset[str], is_both_ways: bool
) -> tuple[str, ...] | None:
    turning = _turning(left.relations[k].sign, right.relations[0].sign)
    if turning is None:
        return None
    domain = Domain(positive)
    evaluator = FormEvaluator(domain)
    first = evaluator.form(Sum((left.sides[k].node, Negative(left.sides[k + 1].node))))
    second = evaluator.form(Sum((right.sides[0].node, Negative(right.sides[1].node))))
    if not (_has_letters(domain, first) and _has_letters(domain, second)):
        is_identity = not second.numerator and not (is_both_ways and first.numerator)
        return () if is_identity and turning == 0 else None
    if turning == 0 and len(first.numerator) == len(second.numerator) == 1:
        own, other = ({*_letters(domain, next(iter(form.numerator)))} for form in (first, second))
        if None not in own | other:
            return _of_vanishing(domain, own, other, positive, is_both_ways)
    factor, monomial = _ratio(domain, first.numerator, second.numerator)
    multiple = poly.times(domain, first.numerator, {monomial: factor})
    is_multiple = is_zero(domain, poly.minus(second.numerator, multiple)) is True
    if turning:
        is_plain = not (monomial or domain.assumptions) and first.is_polynomial and second.is_polynomial
        return () if is_multiple and is_plain and factor * turning > 0 else None
    letters = list(_letters(domain, monomial))
    if not is_multiple or None in letters or (is_both_ways and domain.assumptions):
        return None  # |x| = 3 and x = 3 are one relation for x ≥ 0 only
    unequal = [f"{plain_text(Name(name))} ≠ 0" for name in letters if name and name not in positive]
    return (*domain.assumptions, *unequal)


def _of_vanishing(
    domain: Domain,
    first: set[str | None],
    second: set[str | None],
    positive: frozenset[str],
    is_both_ways: bool,
) -> tuple[str, ...] | None:
    """Return on what conditions a product of letters vanishes because another one does: a b = 0, a = 0.

    One of the first product's letters is zero; of those that the second one lacks it is a condition that
    they are not, unless that leaves none.
    """
    if not (first & second) - positive:
        return None
    apart = first ^ second if is_both_ways else first - second
    unequal = [f"{plain_text(Name(n))} ≠ 0" for n in sorted(n for n in apart - positive if n)]
    return (*domain.assumptions, *unequal)


def _turning(first: str, second: str) -> int | None:
    """Return 0 for two equations, 1 or -1 for orders of one or opposite direction, else None."""
    if first == second:
        return {"=": 0}.get(first, 1 if first in _TURNED else None)
    return -1 if _TURNED.get(first) == second else None


def _has_letters(domain: Domain, form: Form) -> bool:
    """Tell whether a form is no number: an equation of numbers alone is true or false by itself."""
    kinds = {domain.generators[g].kind for monomial in form.numerator for g, _ in monomial if g != TURN}
    return bool(kinds - {"prime", "constant"})


def _ratio(domain: Domain, first: Polynomial, second: Polynomial) -> tuple[Fraction, Monomial]:
    """Return what the second polynomial is times the first, if it is the first times one term."""
    (low, own), (high, other) = _leading(first), _leading(second)
    size, inverse = domain.raised(low, -1)
    sign, monomial = domain.times(high, inverse)
    return Fraction(sign * size * other / own), monomial


def _leading(polynomial: Polynomial) -> tuple[Monomial, Fraction]:
    """Return the term that comes first in the order by letters, which a common factor leaves as it is."""
    places = {g for monomial in polynomial for g, _ in monomial}
    ordered = sorted(places)

    def rank(monomial: Monomial) -> tuple[Fraction, ...]:
        exponents = dict(monomial)
        return tuple(Fraction(exponents.get(g, 0)) for g in ordered)

    return max(polynomial.items(), key=lambda term: rank(term[0]))


def _letters(domain: Domain, monomial: Monomial) -> Iterator[str | None]:
    """Yield the letters of a product, None for a factor that is neither a letter nor a number."""
    for place, _ in monomial:
        generator = domain.generators[place]
        if generator.kind == "symbol":
            yield str(generator.content)
        elif generator.kind not in ("prime", "constant"):
            yield None
