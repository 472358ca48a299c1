"""Evidence: numbers that are zero, and what passes the limits.

Random sums of roots and cosines against 60 digits; every root of a prime against the number whose
square it is; and formulas made to be too large, too deep or without a value.
"""

from __future__ import annotations

from fractions import Fraction

import hypothesis.strategies as st
import pytest
from hypothesis import given, settings
from mpmath import mp

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Quotient,
    Sum,
    Summation,
)
from symbalance.exact.phasor import Phasor
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import cosine
from symbalance.notes.algebra.roots import root
from symbalance.notes.algebra.zero import root_of_prime
from tests.effort import effort
from tests.formulas import MEANING, POINT, at_point, close, forms, tree

PRIMES = [p for p in range(2, 200) if all(p % d for d in range(2, p))]
MOST = 40_000_000
"""Calls and returns that take a few seconds at the most."""
"""Seconds: what is too large is said to be so, not worked on."""

terms = st.lists(
    st.tuples(
        st.fractions(-3, 3, max_denominator=4),
        st.sampled_from([1, 2, 3, 5, 6, 7, 10, 15]),
        st.fractions(0, 2, max_denominator=12),
    ),
    min_size=1,
    max_size=5,
)


def formed(domain: Domain, parts: list[tuple[Fraction, int, Fraction]]) -> Form:
    """Return the sum of c √d cos(q π)."""
    total = Form.number(domain, 0)
    for coefficient, square, half_turns in parts:
        wave = cosine(Form.constant(domain, "pi").scaled(half_turns))
        total = total.plus(wave.times(root(Form.number(domain, square))).scaled(coefficient))
    return total


def number_of(parts: list[tuple[Fraction, int, Fraction]]) -> mp.mpf:
    with mp.workdps(80):
        return mp.fsum(
            mp.mpf(c.numerator)
            / c.denominator
            * mp.sqrt(d)
            * mp.cospi(mp.mpf(q.numerator) / q.denominator)
            for c, d, q in parts
        )


@pytest.mark.slow
@settings(deadline=None, max_examples=200)
@given(terms)
def test_a_number_is_zero_exactly_where_sixty_digits_are(parts: list) -> None:
    number = formed(Domain(), parts)
    assert number.is_zero() is bool(abs(number_of(parts)) < mp.mpf(10) ** -60)
    assert close(values.value(number, {}), number_of(parts))


@pytest.mark.parametrize("prime", PRIMES)
def test_a_gauss_sum_is_the_positive_root_of_its_prime(prime: int) -> None:
    found = root_of_prime(prime)
    assert found.times(found) == Phasor(1, {0: prime})
    with mp.workdps(40):
        total = mp.fsum(c * mp.expjpi(mp.mpf(2 * k) / found.modulus) for k, c in found.terms.items())
        assert close(total, mp.sqrt(prime))


@pytest.mark.parametrize("order", [3, 5, 7, 9, 12, 15])
def test_all_directions_of_a_star_add_up_to_nothing(order: int) -> None:
    for text in (f"cos(theta + 2*pi*k/{order})", f"sin(2*pi*k/{order} - theta)"):
        (total,) = forms(Summation(tree(text), Name("k"), tree("1"), tree(f"{order}")))
        assert total.is_zero() is True
        (short,) = forms(Summation(tree(text), Name("k"), tree("2"), tree(f"{order}")))
        assert short.is_zero() is False


def test_roots_of_different_numbers_are_independent_however_large() -> None:
    for text in (
        "sqrt(101)*sqrt(103)*sqrt(107) + sqrt(2)*sqrt(109)*sqrt(113) - 1",
        "sqrt(2)*sqrt(3)*sqrt(5)*sqrt(7)*sqrt(11)*sqrt(13)*sqrt(17) - sqrt(510510) + sqrt(19)",
    ):
        assert forms(text)[0].is_zero() is False
    assert forms("sqrt(101)*sqrt(103) - sqrt(10403)")[0].is_zero() is True


def test_what_cannot_be_decided_is_left_open_and_at_once() -> None:
    def tried() -> None:
        (number,) = forms("sqrt(101)*sqrt(103)*sqrt(107)*(cos(pi/5) - cos(2*pi/5) - 1/2)")
        assert number.is_zero() is None

    assert effort(tried) < MOST


# Limits -------------------------------------------------------------------------------------------


def chain(depth: int, kind: str) -> Formula:
    node: Formula = Name("x")
    one = Number(Fraction(1))
    for _ in range(depth):
        node = {
            "negative": Negative,
            "root": lambda inner: Call("sqrt", Sum((one, inner))),
            "fraction": lambda inner: Quotient(one, Sum((one, inner))),
            "square": lambda inner: Power(Sum((one, inner)), Number(Fraction(2))),
            "sine": lambda inner: Call("sin", inner),
            "tower": lambda inner: Power(Number(Fraction(9)), inner),
        }[kind](node)
    return node


TOO_LARGE = [
    "x**1000000000",
    "2**1000000000",
    "(1 + x)**401",
    "(a + b + c + x + y)**60",
    "(cos(theta) + sin(phi) + a)**200",
    "(sqrt(1 + a) + sqrt(1 + b) + sqrt(1 + c))**90",
    "((((1 + x)**20 + y)**20 + a)**20 + b)**20",
    "diff(((1 + x)**20 + sin(x))**20, x, 4)",
    "sqrt(1000000000000000003*7)",
]


@pytest.mark.spread(1)
@pytest.mark.parametrize("text", TOO_LARGE)
def test_what_is_too_large_is_said_to_be_at_once(text: str) -> None:
    def tried() -> None:
        with pytest.raises(TooLargeError):
            forms(text)

    assert effort(tried) < MOST


@pytest.mark.spread(6)
@pytest.mark.parametrize("kind", ["negative", "root", "fraction", "square", "sine", "tower"])
@pytest.mark.parametrize("depth", [3, 12, 60, 140, 400, 20_000])
def test_depth_never_hangs(kind: str, depth: int) -> None:
    deep = chain(depth, kind)

    def tried() -> None:
        try:
            FormEvaluator(Domain(), MEANING).form(deep)
        except (TooLargeError, NoFormError):
            assert depth > 3 or kind in ("sine", "tower")

    assert effort(tried) < MOST


NO_FORM = [
    "1/0",
    "x/(a - a)",
    "0/0",
    "(x - x)/(y - y)",
    "(a - a)**(-2)",
    "1/(sin(theta)**2 + cos(theta)**2 - 1)",
    "1/(sqrt(3) - 2*cos(pi/6))",
    "1/(sqrt(a**2*b) - a*sqrt(b))",
    "tan(pi/2)",
    "sec(pi/2)",
    "cot(0)",
    "1/(1 - cos(2*pi*n))",
    "exp((1 + i)*theta*i)*exp(cos(pi/5) + i*sin(pi/5))",
    "(1 + a)**(1/3)",
    "sum(k, k, 1, x)",
    "sum(k, k, 1/2, 3)",
    "sum(k, k, 1, 100000)",
    "sum(1/k, k, 0, 3)",
]


@pytest.mark.parametrize("text", NO_FORM)
def test_what_has_no_value_or_no_rule_has_no_form(text: str) -> None:
    with pytest.raises(NoFormError):
        forms(text)


def test_infinity_dots_and_circles_of_definitions() -> None:
    with pytest.raises(NoFormError):
        forms(Constant("infinity"))
    circle = {"x": tree("y + 1"), "y": tree("x - 1")}
    evaluator = FormEvaluator(Domain(), SymbolValue(circle))
    assert evaluator.form(Name("x")).equals(Form.letter(evaluator.domain, "x")) is True
    inside = {"x": tree("sum(k*x, k, 1, 3)")}
    evaluator = FormEvaluator(Domain(), SymbolValue(inside))
    assert evaluator.form(Name("x")).equals(Form.letter(evaluator.domain, "x").scaled(6)) is True
    long = {f"q{i}": Name(f"q{i + 1}") for i in range(1000)}
    with pytest.raises((NoFormError, TooLargeError)):
        FormEvaluator(Domain(), SymbolValue(long)).form(Name("q0"))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sqrt(-4)", "2*i"),
        ("sqrt(-a**2)**2", "-a**2"),
        ("sqrt(-1 - a)**2", "-1 - a"),
        ("sqrt(0)", "0"),
        ("sqrt(x - x)", "0"),
        ("1/(1 + sqrt(2) + sqrt(3))", "(2 + sqrt(2) - sqrt(6))/4"),
        ("(sqrt(1 + a) - sqrt(1 + b))*(sqrt(1 + a) + sqrt(1 + b))", "a - b"),
        ("1/(sqrt(1 + a) - sqrt(1 + b))", "(sqrt(1 + a) + sqrt(1 + b))/(a - b)"),
        ("1/sqrt(1 + a)**3", "sqrt(1 + a)/(1 + a)**2"),
        ("sqrt(a + 2*sqrt(a*b) + b)**2", "(sqrt(a) + sqrt(b))**2"),
        ("sqrt(1/a)", "1/sqrt(a)"),
        ("sqrt(1/(1 + a))", "sqrt(1 + a)/(1 + a)"),
        ("sqrt(8/27)", "2*sqrt(6)/9"),
    ],
)
def test_roots_in_awkward_places(text: str, expected: str) -> None:
    first, second = forms(text, expected)
    assert first.equals(second) is True


@pytest.mark.parametrize(
    "text", ["sqrt(-1 - a)", "1/(a - 17/10)", "ln(-a)", "asin(a + b)", "sqrt(rho - a)"]
)
def test_a_point_without_a_real_value_is_refused_or_complex(text: str) -> None:
    (form,) = forms(text)
    with pytest.raises(NoFormError):
        values.value(form, POINT)


def test_values_are_never_asked_of_the_callers_precision() -> None:
    (form,) = forms("sqrt(2)*a + sin(theta)")
    with mp.workdps(5):
        found = values.value(form, POINT)
    assert close(found, at_point("sqrt(2)*a + sin(theta)", POINT), 35)
