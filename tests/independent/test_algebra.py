"""Evidence: normal forms against mpmath, which evaluates the same trees without symbalance.

Random formulas and their values; derivatives against numerical ones; equality laws, each of which stops
being one when any of its numbers is changed a little; assumptions.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import hypothesis.strategies as st
import pytest
from hypothesis import HealthCheck, assume, given, settings
from mpmath import mp

from symbalance.document.formula import Derivative, Formula, Name, Number, children, with_children
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.polynomials import quotient
from symbalance.notes.algebra.tree_values import TreeValues
from tests import formulas
from tests.formulas import MEANING, POINT, at_point, close, forms, points, tree, trees

settings.register_profile("algebra", deadline=None, max_examples=150, derandomize=True, database=None)
settings.load_profile("algebra")
SLOW = [HealthCheck.too_slow, HealthCheck.filter_too_much]


class DisagreementError(AssertionError):
    """The algebra and mpmath say different things."""


def formed(*nodes: Formula | str) -> list[Form]:
    """Return forms, dropping a hypothesis example that divides by zero or passes the limits."""
    try:
        return forms(*nodes)
    except (NoFormError, TooLargeError):
        assume(False)
        raise


def expected_at(node: Formula | str, point: formulas.Point) -> Any:
    try:
        expected = at_point(node, point)
    except ZeroDivisionError:
        assume(False)
        raise
    assume(abs(expected) < 10**9)
    return expected


def assert_value(node: Formula | str, form: Form, point: formulas.Point) -> None:
    expected = at_point(node, point)
    found = values.value(form, point)
    if not close(found, expected):
        raise DisagreementError(f"{node}: {found}, not {expected}")


# Values -------------------------------------------------------------------------------------------


@pytest.mark.slow
@settings(suppress_health_check=SLOW, max_examples=400)
@given(trees)
def test_a_form_has_the_value_of_its_formula(node: Formula) -> None:
    (form,) = formed(node)
    for point in points(2):
        expected_at(node, point)
        assert_value(node, form, point)


@pytest.mark.slow
@settings(suppress_health_check=SLOW)
@given(trees, st.sampled_from(["theta", "x", "rho", "a"]), st.integers(1, 2))
def test_a_derivative_has_the_slope_of_its_formula(node: Formula, name: str, order: int) -> None:
    slope = Derivative(node, Name(name), order)
    expected_at(node, POINT)
    expected_at(slope, POINT)
    (form,) = formed(slope)
    assert_value(slope, form, POINT)


@pytest.mark.slow
@settings(suppress_health_check=SLOW)
@given(trees)
def test_values_straight_from_trees(node: Formula) -> None:
    expected = expected_at(node, POINT)
    assert close(TreeValues(MEANING, POINT).value(node), expected)


VALUES = [
    "cos(asin(sin(theta)/lambda))",
    "sin(2*acos(x/2) + theta)",
    "cos(3*atan(sin(theta)/2))",
    "tan(asin(rho*sin(theta)))",
    "cos(theta/2)**3*sin(theta/2)",
    "cos(atan(x)/2)",
    "sin(asin(rho*sin(theta))/2)",
    "1/(a + sqrt(b))",
    "1/(sqrt(a) + sqrt(b) + sqrt(a*b))",
    "1/(sqrt(a + b) + sqrt(a + c))",
    "x/(1 + 1/(1 + 1/(1 + x)))",
    "(a + 1/b)**-3",
    "sqrt(lambda**2 - sin(theta)**2)**-3",
    "sqrt(sqrt(a + 1) + sqrt(b + 2))",
    "sqrt(2 + sqrt(3))",
    "(a*b)**(3/2)",
    "(a**3)**(1/3)",
    "a**(2/3)*a**(1/3)",
    "exp(-x/(1 + a))",
    "cos(x/(1 + a)) + sin(theta/(2 - x))",
    "exp(i*theta)*exp(-i*theta/2)",
    "(cos(theta) + i*sin(theta))**5",
    "exp(i*theta)**n",
    "(-1)**n*cos(n*pi)",
    "i**n",
    "a**x*a**y",
    "ln(a + b) - ln(a)",
    "sinh(x) + cosh(y) - tanh(x)",
    "cot(theta)*csc(theta) - sec(phi)",
    "sum(k**2*cos(k*theta), k, 1, 6)",
    "sum(sum(k, k, 1, n), n, 1, 4)",
    "sum(1/(2*k + 1), k, 0, 9)",
    "diff(sin(theta)**3, theta, 2)",
    "diff(asin(sin(theta)/lambda), theta, 2)",
    "diff(acos(rho*x) - atan(x/rho), x, 1)",
    "diff(sqrt(lambda**2 - sin(theta)**2), theta, 2)",
    "diff(cos(sqrt(1 + x**2)), x, 1)",
    "diff(cos(atan(x)/2), x, 2)",
    "diff(exp(sqrt(a + x)), x, 1)",
    "diff(cos(x/(1 + x)), x, 1)",
    "diff(exp(-x/(1 + a*x)), x, 2)",
    "diff(ln(1 + x**2)*sqrt(1 + x**2), x, 2)",
    "diff((1 + x)/(1 - x**2/3), x, 2)",
    "diff(a**x, x, 1)",
    "diff((1 + sqrt(1 + x**2))**(1/2), x, 1)",
    "sqrt(x*y*y*x)",
    "sqrt(-4)*sqrt(-9)",
    "abs(a - 1 + 1)",
]


@pytest.mark.parametrize("text", VALUES)
def test_chosen_values(text: str) -> None:
    (form,) = forms(text)
    for point in points(3):
        assert_value(text, form, {**point, "y": abs(point["y"])})


def test_derivatives_by_time_use_the_rates_of_the_letters() -> None:
    meaning = SymbolValue(rates={"t": {"theta": Name("omega")}})
    evaluator = FormEvaluator(Domain(), meaning)
    slope = Derivative(tree("sin(theta)**2*sqrt(4 - cos(theta)**2)"), Name("t"), 2)
    form = evaluator.form(slope)
    point = {"theta": Fraction(5, 7), "omega": Fraction(31, 10)}
    with mp.workdps(60):
        speed, start = formulas.number(point["omega"]), formulas.number(point["theta"])
        expected = mp.diff(
            lambda t: mp.sin(start + speed * t) ** 2 * mp.sqrt(4 - mp.cos(start + speed * t) ** 2), 0, 2
        )
    assert close(values.value(form, point), expected)


# Laws ---------------------------------------------------------------------------------------------

LAWS = [
    *[(f"cos({n}*theta) + i*sin({n}*theta)", f"(cos(theta) + i*sin(theta))**{n}") for n in range(2, 13)],
    *[
        (f"cos({j}*theta)*cos({k}*theta)", f"(cos({j + k}*theta) + cos({j - k}*theta))/2")
        for j, k in ((1, 2), (3, 5), (12, 7), (4, 4))
    ],
    *[
        (f"sin({j}*theta)*cos({k}*theta)", f"(sin({j + k}*theta) + sin({j - k}*theta))/2")
        for j, k in ((1, 2), (3, 5), (12, 7), (4, 4))
    ],
    ("sin(theta)**2", "(1 - cos(2*theta))/2"),
    ("sin(theta)**4", "3/8 - cos(2*theta)/2 + cos(4*theta)/8"),
    ("cos(theta)**6", "(10 + 15*cos(2*theta) + 6*cos(4*theta) + cos(6*theta))/32"),
    ("cos(theta) + cos(phi)", "2*cos((theta + phi)/2)*cos((theta - phi)/2)"),
    ("tan(2*theta)", "2*tan(theta)/(1 - tan(theta)**2)"),
    ("tan(theta/2)", "sin(theta)/(1 + cos(theta))"),
    ("tan(theta + phi)", "(tan(theta) + tan(phi))/(1 - tan(theta)*tan(phi))"),
    ("sec(theta)**2", "1 + tan(theta)**2"),
    ("csc(theta)**2 - cot(theta)**2", "1"),
    ("cos(x/(1 + a))**2 + sin(x/(1 + a))**2", "1"),
    ("cosh(x)**2 - sinh(x)**2", "1"),
    ("tanh(2*x)", "2*tanh(x)/(1 + tanh(x)**2)"),
    ("exp(i*theta)", "cos(theta) + i*sin(theta)"),
    ("exp(i*theta)**n", "cos(n*theta) + i*sin(n*theta)"),
    ("cos(n*pi)**2", "1"),
    ("exp(2*pi*i*n)", "1"),
    ("(-1)**n*(-1)**n", "1"),
    ("(-1)**n", "cos(n*pi)"),
    ("cos(theta + 2*pi*n)", "cos(theta)"),
    ("sin(n*pi/2)**2", "(1 - (-1)**n)/2"),
    ("sqrt(3)", "2*cos(pi/6)"),
    ("sqrt(3)", "tan(pi/3)"),
    ("sqrt(5)", "4*cos(pi/5) - 1"),
    ("sqrt(2)", "2*sin(pi/4)"),
    ("cos(pi/5) - cos(2*pi/5)", "1/2"),
    ("sqrt(5 + 2*sqrt(5))", "sqrt(5 + 2*sqrt(5))*1"),
    ("8*cos(pi/7)*cos(2*pi/7)*cos(4*pi/7)", "-1"),
    ("sqrt(7)", "2*(sin(2*pi/7) + sin(4*pi/7) + sin(8*pi/7))"),
    ("sqrt(12) + sqrt(27)", "5*sqrt(3)"),
    ("1/(sqrt(3) - sqrt(2))", "sqrt(3) + sqrt(2)"),
    ("sqrt(6)/sqrt(2)", "sqrt(3)"),
    ("sqrt(a**2*b)", "a*sqrt(b)"),
    ("sqrt(a)/a", "1/sqrt(a)"),
    ("sqrt(4*lambda**2 - 4*sin(theta)**2)", "2*lambda*sqrt(1 - sin(theta)**2/lambda**2)"),
    ("sqrt(lambda**2 - sin(theta)**2)/lambda", "sqrt(1 - (sin(theta)/lambda)**2)"),
    ("1/(a - sqrt(a**2 - b))", "(a + sqrt(a**2 - b))/b"),
    ("cos(asin(x))", "sqrt(1 - x**2)"),
    ("tan(atan(x))", "x"),
    ("sin(2*acos(x))", "2*x*sqrt(1 - x**2)"),
    ("cos(2*atan(x))", "(1 - x**2)/(1 + x**2)"),
    ("(1 + x)**5/(1 + x)**3", "1 + 2*x + x**2"),
    ("1/x - 1/(1 + x)", "1/(x*(1 + x))"),
    ("diff(sin(theta)*cos(theta), theta, 1)", "cos(2*theta)"),
    ("diff(sqrt(1 - x**2), x, 1)", "-x/sqrt(1 - x**2)"),
    ("diff(asin(x), x, 1)", "1/sqrt(1 - x**2)"),
    ("sum(cos(k*theta), k, 1, 4)*sin(theta/2)", "(sin(9*theta/2) - sin(theta/2))/2"),
    ("sum(cos(theta + 2*pi*k/7), k, 0, 6)", "0"),
    ("sum(k**3, k, 1, 12)", "sum(k, k, 1, 12)**2"),
]


@pytest.mark.parametrize(("left", "right"), LAWS)
def test_laws_are_proved(left: str, right: str) -> None:
    first, second = forms(left, right)
    assert first.equals(second) is True
    assert not first.domain.assumptions


def changed(node: Formula, by: Fraction) -> list[Formula]:
    """Return the formula once for each of its numbers, that number changed."""
    if isinstance(node, Number):
        return [Number(node.value + by)]
    parts = children(node)
    return [
        with_children(node, (*parts[:i], new, *parts[i + 1 :]))
        for i, part in enumerate(parts)
        for new in changed(part, by)
    ]


def apart_at(left: Formula, right: Formula, point: formulas.Point) -> Any:
    with mp.workdps(60):
        return at_point(left, point) - at_point(right, point)


def assert_soundly_compared(left: Formula, right: Formula) -> None:
    """Assert what `equals` says, and the value of the difference, against 60 digits at five points."""
    first, second = forms(left, right)
    difference = first.minus(second)
    apart = [apart_at(left, right, point) for point in points(5)]
    same = all(abs(d) < mp.mpf(10) ** -50 for d in apart)
    answer = difference.is_zero()
    if answer is not same:
        raise DisagreementError(f"{left} = {right}: {answer}, but apart by {apart[0]}")
    if not same:
        found = [values.value(difference, point) for point in points(5)]
        assert all(close(f, d, 18) for f, d in zip(found, apart, strict=True))
        assert any(abs(f) > 10**-15 for f in found)


@pytest.mark.spread(10)
@pytest.mark.parametrize(("left", "right"), [law for law in LAWS if "sum" not in law[0]])
def test_a_law_with_one_number_changed_is_refuted(left: str, right: str) -> None:
    """Changed exponents, denominators and angles too; those left without a form are passed over."""
    for side in ("left", "right"):
        for by in (Fraction(1), Fraction(1, 1000)):
            for node in changed(tree(left if side == "left" else right), by):
                if _has_form(node):
                    other = tree(right if side == "left" else left)
                    assert_soundly_compared(node, other)


def _has_form(node: Formula) -> bool:
    """Pass over roots of sums and complex powers, on whose branch mpmath and hand notation differ."""
    try:
        (form,) = forms(node)
        return close(values.value(form, POINT), at_point(node, POINT))
    except (NoFormError, TooLargeError, ZeroDivisionError):
        return False


@pytest.mark.slow
@settings(suppress_health_check=SLOW)
@given(trees, trees, trees)
def test_the_laws_of_a_field(a: Formula, b: Formula, c: Formula) -> None:
    one, two, three = formed(a, b, c)
    try:
        assert one.plus(two).equals(two.plus(one)) is not False
        assert one.times(two.plus(three)).equals(one.times(two).plus(one.times(three))) is True
        assert one.minus(one).is_zero() is True
        if two.is_zero() is False:
            assert one.over(two).times(two).equals(one) is True
    except TooLargeError:
        assume(False)


@pytest.mark.slow
@settings(suppress_health_check=SLOW)
@given(trees, st.data())
def test_one_coefficient_changed_is_seen(node: Formula, data: st.DataObject) -> None:
    """Never True where 60 digits say otherwise."""
    numbers = changed(node, Fraction(1, 1000))
    assume(numbers)
    other = data.draw(st.sampled_from(numbers))
    first, second = formed(node, other)
    try:
        answer = first.equals(second)
    except TooLargeError:
        assume(False)
        raise
    expected_at(node, POINT)
    expected_at(other, POINT)
    apart = [apart_at(node, other, point) for point in points(5)]
    if any(abs(d) > mp.mpf(10) ** -40 for d in apart):
        assert answer is False
        assert close(values.value(first.minus(second), POINT), apart[0], 18)


# Common denominators ------------------------------------------------------------------------------


@pytest.mark.slow
@settings(suppress_health_check=SLOW)
@given(trees, trees)
def test_division_undoes_multiplication(a: Formula, b: Formula) -> None:
    one, two = formed(a, b)
    assume(one.is_polynomial and two.is_polynomial)
    try:
        product = one.times(two)
        found = quotient(one.domain, product.numerator, two.numerator)
    except TooLargeError:
        assume(False)
        raise
    kinds = {one.domain.generators[g].kind for monomial in two.numerator for g, _ in monomial}
    if two.numerator and not kinds & {"turn", "prime", "radical"}:
        assert found == one.numerator
    else:
        assert found in (None, one.numerator)


def test_division_finds_a_factor_and_refuses_what_is_none() -> None:
    product, factor, other = forms("(1 + x)**3*(a - sin(theta))", "(1 + x)**2", "(2 + x)**2")
    found = quotient(product.domain, product.numerator, factor.numerator)
    assert found is not None
    assert Form.of(product.domain, found).times(factor).equals(product) is True
    assert quotient(product.domain, product.numerator, other.numerator) is None
    assert quotient(product.domain, factor.numerator, product.numerator) is None
    assert quotient(product.domain, product.numerator, {}) is None


# Assumptions --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "noted"),
    [
        ("sqrt(x**2)", ["x ≥ 0"]),
        ("sqrt(x**2*a)", ["x ≥ 0"]),
        ("abs(x)", ["x ≥ 0"]),
        ("sqrt(x*y)", ["x ≥ 0", "y ≥ 0"]),
        ("sqrt(x*y + 1)", []),
        ("sqrt(x**2 + y**2)", []),
        ("sqrt(x**2*y**2 + x**4*a)", ["x ≥ 0"]),
        ("sqrt(1 + 1/x**2)", ["x ≥ 0"]),
        ("sqrt(x**4)", []),
        ("sqrt(x)", []),
        ("sqrt(a**2*b + c)", []),
        ("exp(i*theta)**x", ["x ∈ ℤ"]),
        ("exp(i*theta)**n", []),
        ("exp(a)**x", []),
    ],
)
def test_what_is_assumed_is_noted(text: str, noted: list[str]) -> None:
    (form,) = forms(text)
    assert sorted(form.domain.assumptions) == noted


def test_letters_of_unknown_sign_are_positive_where_that_was_assumed() -> None:
    (form,) = forms("sqrt(x**2)*y")
    drawn = [values.random_point(["x", "y"], form.domain, seed) for seed in range(40)]
    assert all(point["x"] > 0 for point in drawn)
    assert any(point["y"] < 0 for point in drawn)


@pytest.mark.parametrize("text", ["cos(2*pi*sqrt(n))", "cos(2*pi*x)", "cos(2*pi/n)", "cos(pi*n/2)**2"])
def test_only_whole_multiples_of_a_turn_are_none(text: str) -> None:
    one, other = forms(text, "1")
    assert one.equals(other) is False


def test_a_root_of_a_quotient_asks_for_the_sign_of_what_is_below() -> None:
    """√(a/b) = √(ab)/b for positive b only."""
    (form,) = forms("sqrt((x - 2)/(x - 1))")
    assert "denominators under roots > 0" in form.domain.assumptions
    assert close(values.value(form, {"x": Fraction(3)}), mp.sqrt(mp.mpf(1) / 2), 14)
    with pytest.raises(NoFormError):
        values.value(form, {"x": Fraction(1, 2)})
    for text in ("sqrt(1/(1 + a))", "sqrt(x/(-1 - x**2))", "sqrt(1 + tan(theta)**2)"):
        assert not forms(text)[0].domain.assumptions


def test_a_radical_is_not_its_negative_and_a_square_root_not_the_letter() -> None:
    for left, right in (
        ("sqrt(1 + a)", "-sqrt(1 + a)"),
        ("sqrt(a + b)", "sqrt(a) + sqrt(b)"),
        ("sqrt(1 - sin(theta)**2)", "cos(theta)"),
        ("asin(x) + acos(x)", "pi/3"),
    ):
        first, second = forms(left, right)
        assert first.equals(second) is False
