"""Correction of the wrong terms in a sum, from the difference between its two sides."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import Formula, Negative, Number, Product, Quotient, Sum
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import Domain, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import Components, HarmonicKey, components, polynomial_node
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import replace_part

Changes = tuple[tuple[Formula, Formula], ...]
MOST_TERMS = 80
"""Of a side; each part of the difference is compared with each of them."""


@dataclass
class Leaf:
    """A term of a side, with what multiplies it, what it contributes, and what is still missing."""

    node: Formula
    multiplier: Form
    components_by_key: Components
    missing: Polynomial = field(default_factory=dict)
    own: Form | None = None


def correct_terms(
    node: Formula, decision: Decision, knowledge: Knowledge
) -> tuple[Formula, Changes] | None:
    """Return the side with its wrong terms corrected, and the pairs (old, new), or None."""
    left, right, level = decision.left, decision.right, decision.level
    if left is None or right is None or level is None:
        return None
    difference = left.minus(right)
    if not difference.is_polynomial or len(difference.numerator) > 200:
        return None
    evaluator = knowledge.evaluator(level)
    evaluator.domain = left.domain
    leaves = list(_leaves(node, Form.number(left.domain, 1), evaluator))
    if not 0 < len(leaves) <= MOST_TERMS:
        return None
    usual = knowledge.crank.small if knowledge.crank else None
    extra = _assign_difference(difference, leaves, left.domain.symbol(usual[0]) if usual else None)
    return _rebuild(node, leaves, extra, left)


def _leaves(node: Formula, multiplier: Form, evaluator: FormEvaluator) -> list[Leaf]:
    """Return the terms of a side: sums are entered, also inside a product, a quotient or a sign."""
    if isinstance(node, Sum):
        terms = [t for t in node.terms if not isinstance(t, formula.Dots)]
        return [leaf for t in terms for leaf in _leaves(t, multiplier, evaluator)]
    inner, outside = _one_sum(node)
    if inner is not None and outside is not None:
        return _leaves(inner, multiplier.times(evaluator.form(outside)), evaluator)
    own = evaluator.form(node)
    form = own.times(multiplier)
    if not form.is_polynomial:
        raise NoFormError("a term that is a quotient")
    return [Leaf(node, multiplier, components(form.domain, form.numerator), own=own)]


def _one_sum(node: Formula) -> tuple[Formula | None, Formula | None]:
    """Return (the sum within a term, what multiplies it) if the term holds one sum as a factor."""
    unity = Number(Fraction(1))
    if isinstance(node, Negative) and _holds_sum(node.operand):
        return node.operand, Negative(unity)
    if isinstance(node, Quotient) and _holds_sum(node.numerator):
        return node.numerator, Quotient(unity, node.denominator)
    if isinstance(node, Product):
        sums = [f for f in node.factors if _holds_sum(f)]
        if len(sums) == 1:
            rest = tuple(f for f in node.factors if f is not sums[0])
            return sums[0], rest[0] if len(rest) == 1 else Product(rest)
    return None, None


def _holds_sum(node: Formula) -> bool:
    return isinstance(node, Sum) or _one_sum(node)[0] is not None


def _assign_difference(difference: Form, leaves: list[Leaf], small: int | None) -> Polynomial:
    """Give each part of the difference to the term it belongs to; return what belongs to none."""
    domain = difference.domain
    extra: Polynomial = {}
    for key, number in components(domain, difference.numerator).items():
        part = _as_polynomial(difference, key, number)
        leaf = max(leaves, key=lambda leaf: _likeness(key, leaf, small))
        if _likeness(key, leaf, small) > 0:
            leaf.missing = poly.plus(leaf.missing, part)
        else:
            extra = poly.plus(extra, part)
    return extra


def _likeness(key: HarmonicKey, leaf: Leaf, small: int | None) -> float:
    """Return how well a harmonic fits a term: same angle and letters best, 0 where nothing fits.

    The numbers only rank: all the same (8), sine for cosine (6), the same angle with some letters shared
    (3 to 6.5, more with the same power of the small letter), only the letters the same (2).
    """
    best = 0.0
    for term in leaf.components_by_key:
        same_function, same_angle = term.function == key.function, term.angle == key.angle
        same_letters = term.letters == key.letters
        shared, either = {*term.letters} & {*key.letters}, {*term.letters} | {*key.letters}
        overlap = len(shared) / (1 + len(either))
        if same_function and same_angle and same_letters:
            best = max(best, 8.0)
        elif same_angle and same_letters:
            best = max(best, 6.0)
        elif same_angle and overlap > 0:
            own_powers, powers = dict(term.letters), dict(key.letters)
            same_power = small is not None and own_powers.get(small, 0) == powers.get(small, 0)
            best = max(best, 3.0 + overlap + same_function + 1.5 * same_power)
        elif same_letters and key.letters and key.angle and term.angle:
            best = max(best, 2.0)
    # A term of many harmonics is one that anything would fit.
    return best / (1 + 0.05 * (len(leaf.components_by_key) - 1))


def _as_polynomial(form: Form, key: HarmonicKey, number: Polynomial) -> Polynomial:
    """Return number times harmonic as a polynomial again."""
    domain = form.domain
    letters: Polynomial = {key.letters: Fraction(1)}
    if key.function == "1":
        return poly.times(domain, number, letters)
    back = tuple((g, -e) for g, e in key.angle)
    half = Fraction(1, 2)
    if key.function == "cos":
        wave: Polynomial = {key.angle: half, back: half}
    else:  # sin x = -i/2 e^(ix) + i/2 e^(-ix)
        unit: Polynomial = {((0, Fraction(1, 4)),): half}
        wave = poly.plus(
            poly.times(domain, unit, {key.angle: Fraction(-1)}),
            poly.times(domain, unit, {back: Fraction(1)}),
        )
    return poly.times(domain, poly.times(domain, number, letters), wave)


def _rebuild(
    node: Formula, leaves: list[Leaf], extra: Polynomial, left: Form
) -> tuple[Formula, Changes] | None:
    """Return the side with each wrong term put right, and at its end what belongs to no term."""
    changes: list[tuple[Formula, Formula]] = []
    for leaf in leaves:
        if leaf.missing:
            old = Form.of(left.domain, _sum_of_components(leaf, left))
            right_value = old.plus(Form.of(left.domain, leaf.missing)).over(leaf.multiplier)
            if not right_value.is_polynomial:
                right_value = _in_proportion(leaf, old, left)
            if right_value is None:
                return None
            changes.append((leaf.node, polynomial_node(left.domain, right_value.numerator)))
    result = node
    for old_node, new_node in changes:
        result = replace_part(result, old_node, new_node)
    result = _without_zeros(result)
    if extra:
        extra_node = polynomial_node(left.domain, extra)
        terms = result.terms if isinstance(result, Sum) else (result,)
        terms = () if terms == (Number(Fraction(0)),) else terms
        extra_terms = extra_node.terms if isinstance(extra_node, Sum) else (extra_node,)
        all_terms = (*terms, *extra_terms)
        if not all_terms:
            return None
        result = Sum(all_terms, span=node.span) if len(all_terms) > 1 else all_terms[0]
        changes.append((Number(Fraction(0)), extra_node))
    return (result, tuple(changes)) if changes else None


def _ratio(old: Polynomial, new: Polynomial) -> Fraction | None:
    """Return new/old where that is a rational number."""
    first = next(iter(old), None)
    if first is None or first not in new:
        return None
    ratio = new[first] / old[first]
    return None if poly.minus(new, poly.scale(old, ratio)) else ratio


def slip_kinds(changes: Changes) -> str:
    """Return in words what kinds of slip a set of changed terms is.

    >>> from symbalance.document.formula import Name
    >>> slip_kinds(((Name("s"), Negative(Name("s"))), (Number(Fraction(0)), Name("r"))))
    'sign; term missing'
    """
    return "; ".join(dict.fromkeys(slip_kind(old, new) for old, new in changes))


def slip_kind(old: Formula, new: Formula) -> str:
    """Return what kind of slip one changed term is."""
    zero = Number(Fraction(0))
    if zero in (old, new):
        return "term missing" if old == zero else "term too many"
    evaluator = FormEvaluator(Domain())
    try:
        ratio = _ratio(evaluator.form(old).numerator, evaluator.form(new).numerator)
    except (NoFormError, TooLargeError):
        ratio = None
    if ratio is not None:
        return "sign" if ratio == -1 else f"factor {ratio}"
    waves = [{c.function for c in formula.walk(n) if isinstance(c, formula.Call)} for n in (old, new)]
    if waves in ([{"sin"}, {"cos"}], [{"cos"}, {"sin"}]):
        return "sin for cos" if "sin" in waves[1] else "cos for sin"
    return "term"


def _without_zeros(node: Formula) -> Formula:
    """Return a formula whose sums have no terms 0."""
    parts = tuple(_without_zeros(part) for part in formula.children(node))
    if isinstance(node, Sum):
        terms = tuple(p for p in parts if p != Number(Fraction(0)))
        return terms[0] if len(terms) == 1 else Sum(terms or parts[:1], span=node.span)
    same = all(a is b for a, b in zip(parts, formula.children(node), strict=True))
    return node if same else formula.with_children(node, parts)


def _in_proportion(leaf: Leaf, old: Form, left: Form) -> Form | None:
    """Return the term's right value where that is a rational multiple of what stands there."""
    ratio = _ratio(old.numerator, leaf.missing)
    return None if ratio is None or leaf.own is None else leaf.own.scaled(1 + ratio)


def _sum_of_components(leaf: Leaf, left: Form) -> Polynomial:
    total: Polynomial = {}
    for key, number in leaf.components_by_key.items():
        total = poly.plus(total, _as_polynomial(left, key, number))
    return total
