"""Evidence: power series for a small ρ or a large λ, against the functions themselves.

A series said to hold through order n must leave a remainder of order n + 1: at ε = 10^-8 and 10^-9, with
hundreds of digits, one wrong coefficient or one order claimed too many is larger by many powers of ten.
Where mpmath can differentiate at 0, its Taylor coefficients are compared too.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

from symbalance.document.formula import Formula
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.series import Expansion, FormSeries
from tests import formulas
from tests.formulas import POINT, forms, tree

DIGITS = 420
LARGE, SMALL = ("lambda", -1), ("rho", 1)


class RemainderError(AssertionError):
    """A series leaves more than it may."""


def series_of(text: str | Formula, letter: tuple[str, int], through: int) -> FormSeries:
    (form,) = forms(text)
    return Expansion(form.domain, *letter, through).of(form)


def coefficients(series: FormSeries) -> dict[int, Any]:
    """Return the values of the coefficients at POINT with DIGITS digits."""
    with values.context().workdps(DIGITS):
        return {k: values.value(form, POINT) for k, form in series.terms.items()}


def remainder(text: str | Formula, letter: tuple[str, int], series: FormSeries, small: Fraction) -> Any:
    """Return (f(ε) - the partial sum)/ε^(through + 1)."""
    name, sign = letter
    node = tree(text) if isinstance(text, str) else text
    exact = formulas.at_point(node, {**POINT, name: small if sign > 0 else 1 / small}, DIGITS)
    with mp.workdps(DIGITS):
        epsilon = formulas.number(small)
        partial = mp.fsum(mp.mpmathify(c) * epsilon**k for k, c in coefficients(series).items())
        return (exact - partial) / epsilon ** (series.through + 1)


def assert_good(text: str | Formula, letter: tuple[str, int], series: FormSeries) -> None:
    """Assert that the remainder is of the next order: it settles to the next coefficient."""
    first, second = (remainder(text, letter, series, Fraction(1, 10**n)) for n in (8, 9))
    if not abs(first - second) <= (1 + abs(first)) * mp.mpf(10) ** -3:
        raise RemainderError(f"{text}: {first} and {second} beyond order {series.through}")


FOR_LARGE_LAMBDA = [
    "sqrt(lambda**2 - sin(theta)**2)",
    "lambda*sqrt(1 - (sin(theta)/lambda)**2)",
    "1/sqrt(lambda**2 - sin(theta)**2)",
    "sqrt(lambda**2 - (sin(theta) + x)**2)**3/lambda**2",
    "sqrt(1 - sin(theta)/lambda + a/lambda**2)",
    "asin(sin(theta)/lambda)",
    "asin((sin(theta) - x)/lambda)*lambda**2",
    "atan(a/(lambda + b))",
    "cos(asin(sin(theta)/lambda))*sin(2*asin(sin(theta)/lambda))",
    "cos(asin(sin(theta)/lambda)/2)",
    "sin(theta + a/lambda)",
    "sin(a/(lambda - x))*cos(b/lambda + theta)",
    "exp(-a/lambda)*exp(i*theta/lambda)",
    "exp(x/(1 + lambda))",
    "ln(1 + a/lambda)",
    "1/(lambda - a)",
    "lambda**7/(lambda**2 + lambda*a + b)**3",
    "(1 + 1/lambda)**9/(1 - x/lambda)**4",
    "(sqrt(lambda**2 + a) - lambda)*(sqrt(lambda**2 + b) + lambda)",
    "(sqrt(lambda**2 + a) - lambda)**3*lambda**3",
    "1/(sqrt(lambda**2 + a) - lambda)",
    "cos(theta) + sqrt(lambda**2 - sin(theta)**2) - lambda",
    "diff(cos(theta) + sqrt(lambda**2 - sin(theta)**2), theta, 2)",
    "sqrt(3)*cos(theta)/lambda + cos(pi/7)/(1 + lambda)",
    "sum(cos(2*k*theta)/lambda**k, k, 0, 5)",
]
FOR_SMALL_RHO = [
    "sqrt(1 - rho**2*sin(theta)**2)",
    "sqrt(1 + rho)/sqrt(1 - rho)",
    "sqrt(a + rho)",
    "sqrt(rho**2*a + rho**3)",
    "asin(rho*sin(theta))",
    "atan(rho*x)/rho",
    "exp(rho*a)*cos(rho*b)",
    "cos(theta + rho*sin(theta))",
    "ln(1 + rho*x + rho**2)",
    "(sin(rho) - rho)/rho**3",
    "(1 - cos(rho))/(rho*sin(rho))",
    "tan(rho)",
    "tanh(rho*a)",
    "rho/(exp(rho) - 1)",
    "exp(rho)/(exp(rho) - 1 - rho)",
    "1/(rho**2*(1 + rho)**5)",
    "(cos(rho) - sqrt(1 - rho**2))*(sin(rho) - rho)/rho**5",
    "sqrt(1 + sqrt(1 + rho))",
    "cos(x/(1 + rho))",
    "sqrt(lambda**2 - (sin(theta) - rho)**2)",
]
CASES = [(text, LARGE) for text in FOR_LARGE_LAMBDA] + [(text, SMALL) for text in FOR_SMALL_RHO]


@pytest.mark.slow
@pytest.mark.parametrize("through", [1, 4, 12])
@pytest.mark.parametrize(("text", "letter"), CASES)
def test_the_remainder_is_of_the_next_order(text: str, letter: tuple[str, int], through: int) -> None:
    try:
        series = series_of(text, letter, through)
    except TooLargeError:
        pytest.skip("too large at this order")
    assert series.through >= through
    assert_good(text, letter, series)


ANALYTIC = [
    text for text in FOR_SMALL_RHO if "/rho" not in text and "/(" not in text and "rho**3" not in text
]


@pytest.mark.slow
@pytest.mark.parametrize("text", ANALYTIC)
def test_coefficients_are_those_of_taylor(text: str) -> None:
    node = tree(text)
    with mp.workdps(60):
        exact = {name: formulas.number(q) for name, q in POINT.items()}
        expected = mp.taylor(lambda r: formulas.value(node, {**exact, "rho": r}), 0, 12)
    found = coefficients(series_of(text, SMALL, 12))
    for k, coefficient in enumerate(expected):
        assert formulas.close(found.get(k, 0), coefficient, 15)


@pytest.mark.parametrize("order", [2, 5, 8, 12])
def test_the_root_of_the_crank_against_the_binomial_series(order: int) -> None:
    found = coefficients(series_of("sqrt(lambda**2 - sin(theta)**2)", LARGE, order))
    with mp.workdps(60):
        sine = mp.sin(formulas.number(POINT["theta"]))
        for k in range(order + 1):
            exact = (
                mp.binomial(mp.mpf(1) / 2, (k + 1) // 2) * (-(sine**2)) ** ((k + 1) // 2) if k % 2 else 0
            )
            assert formulas.close(found.get(k, 0), exact)
        assert formulas.close(found[-1], mp.mpf(1))


# Random series ------------------------------------------------------------------------------------

small_parts = st.sampled_from(
    ["1/lambda", "sin(theta)/lambda", "x/lambda**2", "a/(lambda + b)", "lambda - sqrt(lambda**2 - x**2)"]
).map(tree)
whole_parts = st.sampled_from(
    ["a", "lambda", "cos(theta)", "lambda**2 - b", "1/lambda", "1 - x/lambda"]
).map(tree)


def _larger(parts: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    pairs = st.tuples(parts, parts)
    return st.one_of(
        pairs.map(formulas.Sum),
        pairs.map(formulas.Product),
        st.builds(formulas.Quotient, parts, parts),
        st.builds(lambda p: formulas.Sum((p, formulas.Negative(tree("lambda")))), parts),
    )


def _of_small(part: Formula) -> st.SearchStrategy[Formula]:
    inside = formulas.Sum((Number_one, part))
    return st.sampled_from(
        [
            formulas.Call("sqrt", inside),
            formulas.Call("ln", inside),
            formulas.Call("exp", part),
            formulas.Call("asin", part),
            formulas.Call("atan", part),
            formulas.Call("cos", formulas.Sum((formulas.Name("theta"), part))),
            formulas.Quotient(part, inside),
        ]
    )


Number_one = formulas.Number(Fraction(1))
random_series = st.recursive(
    st.one_of(whole_parts, small_parts.flatmap(_of_small)), _larger, max_leaves=4
)


@pytest.mark.slow
@settings(
    deadline=None,
    max_examples=120,
    derandomize=True,
    database=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
@given(random_series, st.integers(0, 5))
def test_random_series_never_claim_too_much(node: Formula, through: int) -> None:
    try:
        series = series_of(node, LARGE, through)
    except (NoFormError, TooLargeError):
        assume(False)
        raise
    assert_good(node, LARGE, series)


# Truncation ---------------------------------------------------------------------------------------


def test_a_product_of_truncated_series_is_cut_where_the_first_unknown_term_falls() -> None:
    (one, a) = forms("1", "a")
    left = FormSeries(one.domain, {-2: one, 3: a}, 3)
    right = FormSeries(one.domain, {1: a, 2: one}, 6)
    assert left.times(right, 40).through == 4
    assert set(left.times(right, 40).terms) == {-1, 0, 4}
    assert left.times(right, 2).through == 2
    assert left.plus(right).through == 3
    nothing = FormSeries(one.domain, {}, 5)
    assert nothing.start == 6
    assert nothing.times(left, 40).through == 3
    assert left.shifted(-4).through == -1


@pytest.mark.parametrize(
    ("text", "letter"),
    [
        ("sqrt(rho)", SMALL),
        ("sqrt(lambda + a)", LARGE),
        ("sin(lambda)", LARGE),
        ("exp(lambda + 1/lambda)", LARGE),
        ("cos(1/rho)", SMALL),
        ("ln(rho)", SMALL),
        ("asin(1/2 + rho)", SMALL),
        ("rho**(1/3)", SMALL),
        ("sqrt(1 + rho)**(1/3)", SMALL),
    ],
)
def test_what_has_no_power_series_is_refused(text: str, letter: tuple[str, int]) -> None:
    with pytest.raises(NoFormError):
        series_of(text, letter, 4)
