"""Closed forms of sums whose upper bound is a letter: powers of the index, and waves in it.

    Σ_{k=a}^{b} w^k = (w^(b+1) - w^a)/(w - 1),   w ≠ 1,     Σ k^p by Faulhaber's polynomials

hold what a sum over the cylinders of an in-line engine comes to: w = e^(ix), a cosine of kx + θ.
"""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from math import comb

from symbalance.document import formula
from symbalance.notes.algebra.domain import Domain, Monomial, NoFormError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.special_values import note_that_terms_differ
from symbalance.notes.algebra.substitution_in_forms import Dependence, substitute_letter, term_by_term

HIGHEST_POWER = 20
NO_EQUAL_TERMS = "no wave that is summed has all its terms equal"
"""What the closed form of a sum of waves rests on: three cylinders are special at the third order."""


def closed_sum(form: Form, index: int, lower: Form, upper: Form) -> Form:
    """Return the sum of a form over a letter, from one whole bound to another.

    >>> domain = Domain(integer={"N"})
    >>> k, one, last = Form.letter(domain, "k"), Form.number(domain, 1), Form.letter(domain, "N")
    >>> total = closed_sum(k, domain.symbol("k"), one, last)
    >>> total.equals(last.times(last.plus(one)).scaled(Fraction(1, 2)))
    True
    """
    domain = form.domain
    return term_by_term(
        form,
        index,
        lambda moving: _sum_of_term(domain, moving, index, lower, upper),
        "a sum of quotients with a letter as its bound",
    )


def _sum_of_term(domain: Domain, moving: Monomial, index: int, lower: Form, upper: Form) -> Form:
    power = dict(moving).get(index, 0)
    wave = tuple((g, e) for g, e in moving if g != index)
    one = Form.number(domain, 1)
    if not wave:
        if power.denominator != 1 or not 0 <= power <= HIGHEST_POWER:
            raise NoFormError("a sum of such powers with a letter as its bound")
        before = lower.minus(one)
        return _sum_of_powers(int(power), upper).minus(_sum_of_powers(int(power), before))
    if power:
        raise NoFormError("a sum of powers times waves with a letter as its bound")
    term = Form.of(domain, {wave: Fraction(1)})
    letter = Form.of(domain, {((index, 1),): Fraction(1)})
    following = substitute_letter(term, index, letter.plus(one))
    ratio = following.over(term)
    if Dependence(domain, index).of_polynomial(ratio.numerator):
        raise NoFormError("a sum of waves whose angle is not linear in the index")
    if ratio.equals(one):
        return term.times(upper.minus(lower).plus(one))
    note_that_terms_differ(ratio, NO_EQUAL_TERMS)
    end = substitute_letter(term, index, upper.plus(one))
    return end.minus(substitute_letter(term, index, lower)).over(ratio.minus(one))


def _sum_of_powers(power: int, upper: Form) -> Form:
    """Return 0^p + 1^p + … + n^p as a polynomial in n, from (n+1)^(p+1) = Σ of its differences."""
    one = Form.number(upper.domain, 1)
    following = upper.plus(one)
    sums: list[Form] = []
    for p in range(power + 1):
        total = following.raised(p + 1)
        for lower_power, earlier in enumerate(sums):
            total = total.minus(earlier.scaled(comb(p + 1, lower_power)))
        sums.append(total.scaled(Fraction(1, p + 1)))
    return sums[power]


def indexed_letters(body: formula.Formula, index: str) -> list[str]:
    """Return the letters that carry a sum's index: m_i in the sum of m_i over i is another one each time.

    >>> indexed_letters(formula.Product((formula.Name("a"), formula.Name("m_i"))), "i")
    ['m_i']
    """
    return sorted(name for name in formula.names(body) if multiple_of_index(name, index))


def multiple_of_index(name: str, index: str) -> int:
    """Return what times an index a letter's last subscript is: 1 of F_k, T_{i,k} and F^{(k)}, 2 of c_2k.

    0 where it is another one.

    >>> [multiple_of_index(name, "k") for name in ("F_k", "T_i,k", "T_ki", "F_(k)", "c_2k", "F_1")]
    [1, 1, 1, 1, 2, 0]
    """
    match = _subscript(name, index)
    return int(match[1] or 1) if match else 0


def _subscript(name: str, index: str) -> re.Match[str] | None:
    pattern = rf"(?:(?<=[_,(])|(?<=[_,(][i-nN]))(\d*){re.escape(index)}(?=[i-nN]?(?:,\w+)?\)?$)"
    return re.search(pattern, name)


def at_index(node: formula.Formula, index: str, value: int) -> formula.Formula:
    """Return a sum's body with the letters that carry its index as those of one value: m_i as m_2."""
    if isinstance(node, formula.Name):
        match = _subscript(node.name, index)
        if match is None:
            return node
        number = int(match[1] or 1) * value
        return replace(node, name=f"{node.name[: match.start()]}{number}{node.name[match.end() :]}")
    parts = formula.children(node)
    return formula.with_children(node, tuple(at_index(p, index, value) for p in parts)) if parts else node
