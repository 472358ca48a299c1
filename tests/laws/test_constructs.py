"""Integrals, limits, closed sums, complex parts and matrices against routes that share no code with them.

Integrals by mpmath's quadrature, sums term by term, complex numbers by Python's own, matrices by NumPy.
"""

from __future__ import annotations

from fractions import Fraction
from math import comb, factorial
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from mpmath import mp

from symbalance.checking import check
from symbalance.document.formula import (
    PI,
    Apply,
    Call,
    Constant,
    Derivative,
    Evaluation,
    Extremum,
    Formula,
    Integral,
    Limit,
    Matrix,
    Name,
    Summation,
    cos,
    formula,
    number,
    sin,
)
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.matrices import Literal, MatrixEvaluator, Words
from symbalance.notes.algebra.matrix_letters import Kinds
from symbalance.notes.reading import read_expression

UNHURRIED = settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck))
X, N, K, A = Name("x"), Name("N"), Name("k"), Name("a")
MEANING = SymbolValue(integer=frozenset("Nkmn"), constant=frozenset("abc"), complex=frozenset("zw"))
POINT = {"a": Fraction(7, 5), "b": Fraction(-3, 4), "x": Fraction(9, 7), "N": Fraction(6)}

rationals = st.fractions(-3, 3, max_denominator=6)


def form(node: Formula) -> Form:
    return FormEvaluator(MEANING.domain(), MEANING).form(node)


def same(one: Formula, other: Formula) -> bool | None:
    """Tell whether two formulas have equal forms, in one domain."""
    evaluator = FormEvaluator(MEANING.domain(), MEANING)
    return evaluator.form(one).equals(evaluator.form(other))


def value(node: Formula) -> Any:
    return values.value(form(node), POINT)


def agrees(one: Any, other: Any) -> bool:
    return bool(abs(mp.mpc(one) - mp.mpc(other)) < mp.mpf(10) ** -18 * (1 + abs(mp.mpc(other))))


def exact(fraction: Fraction) -> Any:
    return mp.mpf(fraction.numerator) / fraction.denominator


# Integrals ----------------------------------------------------------------------------------------

terms = st.tuples(rationals, st.integers(0, 3), st.integers(0, 4), st.booleans())


@pytest.mark.slow
@UNHURRIED
@given(st.lists(terms, min_size=1, max_size=3), rationals, rationals)
def test_integrals_of_powers_times_waves_are_those_of_quadrature(
    parts: list[tuple[Fraction, int, int, bool]], lower: Fraction, upper: Fraction
) -> None:
    body: Formula = number(0)
    for factor, power, order, is_sine in parts:
        wave = sin(order * X) if is_sine else cos(order * X)
        body = body + number(factor) * X**power * wave

    def integrand(x: Any) -> Any:
        return mp.fsum(
            exact(c) * x**p * (mp.sin(n * x) if is_sine else mp.cos(n * x)) for c, p, n, is_sine in parts
        )

    with mp.workdps(30):
        expected = mp.quad(integrand, [exact(lower), exact(upper)])
        assert agrees(value(Integral(body, X, number(lower), number(upper))), expected)


@pytest.mark.slow
@UNHURRIED
@given(st.integers(0, 5), st.integers(0, 5), st.booleans(), st.booleans())
def test_waves_are_orthogonal_over_a_turn(m: int, n: int, sine: bool, other_sine: bool) -> None:
    one, two = (sin(m * X) if sine else cos(m * X)), (sin(n * X) if other_sine else cos(n * X))
    vanishes = sine != other_sine or m != n or (sine and m == 0)
    expected: Formula = number(0) if vanishes else number(1 if m else 2) * PI
    assert same(Integral(one * two, X, number(0), 2 * PI), expected)


def test_the_integral_of_a_derivative_is_the_increase() -> None:
    y = Name("theta")
    whole = sin(y) ** 3 + y * cos(2 * y)
    increase = Integral(Derivative(whole, y), y, number(0), A)
    assert same(increase, Evaluation(whole, y, A, number(0)))
    assert same(increase, sin(A) ** 3 + A * cos(2 * A))


@pytest.mark.parametrize(
    "body", [Name("p"), Name("p") + number(1), Call("sqrt", 1 + sin(X)), 1 / (2 + cos(X)), 1 / X**2]
)
def test_what_has_no_proved_integral_has_none(body: Formula) -> None:
    with pytest.raises(NoFormError):
        form(Integral(body, X, number(-1), number(1)))


def test_an_unknown_letter_within_an_integral_is_an_assumption() -> None:
    result = form(Integral(Name("p") * cos(X), X, number(0), number(1)))
    assert "p does not depend on x" in result.domain.assumptions


def test_time_and_angle_turn_together() -> None:
    """The integral over time of cos θ, θ = ωt, is not t cos θ."""
    moving = SymbolValue(rates={"t": {"theta": Name("a")}}, constant=frozenset("a"))
    node = Integral(cos(Name("theta")), Name("t"), number(0), number(2))
    evaluator = FormEvaluator(moving.domain(), moving)
    with mp.workdps(30):
        expected = mp.sin(2 * exact(POINT["a"])) / exact(POINT["a"])
        assert agrees(values.value(evaluator.form(node), POINT), expected)


# Limits and extrema -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("body", "point"),
    [
        (sin(3 * X) / X, number(0)),
        ((1 - cos(X)) / X**2, number(0)),
        ((X**2 - 1) / (X - 1), number(1)),
        ((Call("sqrt", 1 + X) - 1) / X, number(0)),
    ],
)
def test_limits_are_what_values_nearby_tend_to(body: Formula, point: Formula) -> None:
    at = exact(form(point).rational() or Fraction(0))
    with mp.workdps(60):
        near = values.value(form(body), {"x": Fraction(int(at)) + Fraction(1, 10**9)})
        assert abs(values.value(form(Limit(body, X, point)), {}) - near) < 1e-7


@pytest.mark.parametrize("body", [1 / X, Call("abs", X) / X, sin(1 / X)])
def test_limits_that_are_none_have_no_form(body: Formula) -> None:
    with pytest.raises(NoFormError):
        form(Limit(body, X, number(0)))


@pytest.mark.slow
@UNHURRIED
@given(rationals, rationals, rationals)
def test_extrema_of_two_cosines_are_those_of_a_fine_grid(c: Fraction, a: Fraction, b: Fraction) -> None:
    if not a or not b:
        return
    theta = Name("theta")
    body = number(c) + number(a) * cos(theta) + number(b) * cos(2 * theta)
    grid = np.linspace(0, 2 * np.pi, 20001)
    heights = float(c) + float(a) * np.cos(grid) + float(b) * np.cos(2 * grid)
    for function, size in (("max", heights.max()), ("min", heights.min())):
        assert abs(float(form(Extremum(function, body, theta)).rational() or 0) - size) < 1e-6


# Sums, factorials, binomials ----------------------------------------------------------------------


@UNHURRIED
@given(st.integers(0, 5), st.integers(-2, 2), st.integers(3, 9))
def test_sums_of_powers_are_those_of_their_terms(power: int, first: int, last: int) -> None:
    closed = form(Summation(K**power, K, number(first), N))
    at = values.value(closed, {"N": Fraction(last)})
    assert agrees(at, sum(k**power for k in range(first, last + 1)))


@UNHURRIED
@given(st.integers(1, 4), st.integers(2, 7))
def test_sums_of_waves_are_those_of_their_terms(order: int, count: int) -> None:
    closed = form(Summation(cos(A + order * K * X), K, number(0), N - 1))
    with mp.workdps(30):
        a, x = exact(POINT["a"]), exact(POINT["x"])
        expected = mp.fsum(mp.cos(a + order * k * x) for k in range(count))
        assert agrees(values.value(closed, {**POINT, "N": Fraction(count)}), expected)


def test_a_bound_that_may_be_no_whole_number_is_refused() -> None:
    with pytest.raises(NoFormError):
        form(Summation(K, K, number(1), Name("y")))


@UNHURRIED
@given(st.integers(0, 12), st.integers(0, 12), st.integers(-3, 3))
def test_factorials_and_binomials_are_those_of_python(n: int, k: int, shift: int) -> None:
    assert form(Apply("binomial", (number(n), number(k)))).rational() == comb(n, k)
    assert form(Apply("factorial", (number(n),))).rational() == factorial(n)
    shifted = form(Apply("factorial", (N + shift,)))
    if n + shift >= 0:
        at = values.value(shifted, {"N": Fraction(n + 4)})
        assert agrees(at, factorial(n + 4 + shift))


@pytest.mark.parametrize(
    "node", [Apply("factorial", (number(10**6),)), Integral(X**500, X, number(0), A)]
)
def test_large_numbers_are_refused_at_once(node: Formula) -> None:
    with pytest.raises(TooLargeError):
        form(node * node)


@pytest.mark.slow
@UNHURRIED
@given(st.integers(-6, 6), st.fractions(1, 4, max_denominator=5))
def test_bessel_functions_are_those_of_mpmath(order: int, place: Fraction) -> None:
    node = Apply("besselj", (formula(order), A))
    with mp.workdps(30):
        expected = mp.besselj(order, exact(place))
        assert agrees(values.value(form(node), {"a": place}), expected)
        slope = form(Evaluation(Derivative(Apply("besselj", (formula(order), X)), X), X, A))
        expected = (mp.besselj(order - 1, exact(place)) - mp.besselj(order + 1, exact(place))) / 2
        assert agrees(values.value(slope, {"a": place}), expected)


# Complex numbers ----------------------------------------------------------------------------------

whole = st.integers(-4, 4)
complexes = st.tuples(whole, whole)
I = Constant("i")  # noqa: E741 - the imaginary unit


@UNHURRIED
@given(complexes, complexes)
def test_complex_parts_are_those_of_python(one: tuple[int, int], two: tuple[int, int]) -> None:
    (a, b), (c, d) = one, two
    left, right = number(a) + number(b) * I, number(c) + number(d) * I
    expected = complex(a, b) * complex(c, d) + complex(a, b).conjugate()
    node = left * right + Call("conj", left)
    assert abs(complex(value(Call("re", node))) - expected.real) < 1e-12
    assert abs(complex(value(Call("im", node))) - expected.imag) < 1e-12
    assert abs(complex(value(Call("abs", node))) - abs(expected)) < 1e-12


def test_a_letter_of_which_nothing_is_said_has_no_conjugate() -> None:
    with pytest.raises(NoFormError):
        form(Call("conj", Name("y")))
    assert same(Call("conj", Name("z")), Name("z")) is False


# Matrices -----------------------------------------------------------------------------------------

KINDS = Kinds(frozenset("ABK"), frozenset("uv"), frozenset("K"), frozenset("E"))
squares = st.integers(1, 4).flatmap(
    lambda n: st.lists(st.lists(st.integers(-5, 5), min_size=n, max_size=n), min_size=n, max_size=n)
)


def matrix_value(node: Formula) -> Any:
    return MatrixEvaluator(FormEvaluator(MEANING.domain(), MEANING), KINDS).value(node)


def literal(rows: list[list[int]]) -> Matrix:
    return Matrix(tuple(tuple(map(number, row)) for row in rows))


def numbers(result: Any) -> np.ndarray:
    assert isinstance(result, Literal)
    return np.array([[float(entry.rational() or 0) for entry in row] for row in result.rows])


@pytest.mark.slow
@UNHURRIED
@given(squares)
def test_literal_matrices_are_those_of_numpy(rows: list[list[int]]) -> None:
    node, array = literal(rows), np.array(rows, dtype=float)
    determinant = matrix_value(Apply("det", (node,)))
    assert isinstance(determinant, Form)
    assert abs(float(determinant.rational() or 0) - np.linalg.det(array)) < 1e-6
    if len(rows) > 1:
        product = numbers(matrix_value(node * Apply("transpose", (node,))))
        assert np.allclose(product, array @ array.T)
    if abs(np.linalg.det(array)) > 0.5:
        assert np.allclose(numbers(matrix_value(node ** number(-1))), np.linalg.inv(array))
    else:
        with pytest.raises(NoFormError):
            matrix_value(node ** number(-1))


LETTERS = "A^T B^{-1} K A B^T K^{-1} (AB)^T (BA)^{-1} (A+B) (A-K)^T".split()  # noqa: SIM905


@pytest.mark.slow
@UNHURRIED
@given(st.lists(st.sampled_from(LETTERS), min_size=1, max_size=4), st.randoms(use_true_random=False))
def test_words_of_letters_are_products_of_numpy(parts: list[str], chance: Any) -> None:
    random = np.random.default_rng(chance.randint(0, 2**32 - 1))
    arrays = {name: random.normal(size=(3, 3)) for name in "AB"}
    symmetric = random.normal(size=(3, 3))
    arrays["K"] = symmetric + symmetric.T
    text = " ".join(parts)
    result = matrix_value(read_expression(text, {"A", "B", "K"})[0])
    assert isinstance(result, Words)
    expected = np.eye(3)
    a, b, k = (arrays[name] for name in "ABK")
    inverse = np.linalg.inv
    known = {
        "A^T": a.T, "B^{-1}": inverse(b), "K": k, "A": a, "B^T": b.T, "K^{-1}": inverse(k),
        "(AB)^T": (a @ b).T, "(BA)^{-1}": inverse(b @ a), "(A+B)": a + b, "(A-K)^T": (a - k).T,
    }  # fmt: skip
    for part in parts:
        expected = expected @ known[part]
    total = np.zeros((3, 3))
    for word, scalar in result.terms.items():
        part_value = np.eye(3)
        for factor in word:
            array = arrays[factor.name]
            array = inverse(array) if factor.is_inverted else array
            part_value = part_value @ (array.T if factor.is_transposed else array)
        total = total + float(scalar.rational() or 0) * part_value
    assert np.allclose(total, expected, rtol=1e-6, atol=1e-6 * abs(expected).max())


@pytest.mark.parametrize("text", [r"\sin(A)", "A + 1", "e^{A}", "|A|", "2^A", r"\frac{1}{A}"])
def test_functions_of_matrices_are_not_those_of_numbers(text: str) -> None:
    with pytest.raises(NoFormError):
        matrix_value(read_expression(text, {"A"})[0])


# Whole relations ----------------------------------------------------------------------------------


def verdict(text: str, **symbols: str) -> str:
    return check(f"$${text}$$", symbols).verdicts[0].verdict


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"3 = \pm 3", "refuted"),
        (r"\sqrt{a^2+1} = \pm\sqrt{1+a^2}", "refuted"),
        (r"(a \mp b)(a \pm b) = a^2 - b^2", "holds"),
        (r"(a \pm b)(a \pm b) = a^2 - b^2", "refuted"),
        (r"a \pm b = b \pm a", "refuted"),
    ],
)
def test_both_signs_are_judged_together(text: str, expected: str) -> None:
    assert verdict(text, a="constant", b="constant") == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"\int_0^{2\pi} M\,d\theta = 2\pi M", "undecided"),
        (r"\int_0^{2\pi} M\cos\theta\,d\theta = \pi M", "undecided"),
        (r"\oint \sin^2\theta\,d\theta = 2\pi", "undecided"),
        (r"M^* = M", "definition"),
    ],
)
def test_nothing_is_refuted_for_what_a_page_leaves_open(text: str, expected: str) -> None:
    assert verdict(text, M="torque", θ="crank angle") == expected


@pytest.mark.slow
def test_a_series_cut_off_after_a_harmonic_agrees_with_a_quotient_that_divides() -> None:
    """The rate of the rod's angle comes as a quotient by i(e^(iθ) - e^(-iθ)), which divides it."""
    page = (
        "$$\\frac{d\\phi}{d\\theta} = (\\rho + \\frac{\\rho^3}{8})\\cos\\theta + \\cdots$$\n\n"
        "$$\\frac{d\\phi}{d\\theta} = (\\rho + \\frac{\\rho^3}{4})\\cos\\theta + \\cdots$$"
    )
    symbols = {"θ": "crank angle", "φ": "rod angle", "ρ": "crank ratio r/l"}
    right, wrong = check(page, symbols).verdicts
    assert (right.verdict, right.order) == ("holds_to_order", "ρ³, harmonics to 1")
    assert wrong.verdict == "refuted"
