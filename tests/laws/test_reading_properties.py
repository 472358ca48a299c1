"""Properties of the reader: every tree reads back as written, and no text whatever breaks it."""

from __future__ import annotations

import cmath
from contextlib import suppress
from fractions import Fraction

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from symbalance.document.formula import (
    FUNCTIONS,
    Call,
    Constant,
    Derivative,
    Dots,
    Evaluation,
    Extremum,
    Formula,
    IndexedProduct,
    Integral,
    Limit,
    Name,
    Negative,
    Number,
    PlusMinus,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
    children,
    walk,
)
from symbalance.document.latex_writer import formula_latex
from symbalance.document.text_writer import formula_text
from symbalance.notes.reading import ReadingError, canonical_name, read_document, read_expression

NAMES = [
    "x", "y", "s", "d", "r", "n", "F", "N", "theta", "lambda", "phi", "varphi", "m_1", "m_rec", "omega_n",
    "Lh", "M1", "q4", "x'", "bar_x", "hat_F_1", "Delta_x", "F_theta", "Omega", "m_1,2", "t",
]  # fmt: skip
_FUNCTIONS = sorted(FUNCTIONS)

decimals = st.builds(
    lambda digits, place: Number(digits * Fraction(10) ** -place, Fraction(10) ** -place),
    st.integers(0, 9999),
    st.integers(-3, 4).filter(bool),
)
numbers = st.one_of(
    st.integers(0, 40).map(lambda n: Number(Fraction(n))),
    st.integers(-9, -1).map(lambda n: Number(Fraction(n))),
    st.fractions(-5, 5, max_denominator=9).map(Number),
    decimals,
)
letters = st.sampled_from(NAMES).map(Name)
leaves = st.one_of(numbers, letters, letters, st.sampled_from(["pi", "infinity", "i", "e"]).map(Constant))


def _larger(parts: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    several = st.lists(parts, min_size=2, max_size=4).map(tuple)
    terms = st.lists(st.one_of(parts, parts, st.just(Dots())), min_size=2, max_size=4).map(tuple)
    index = st.sampled_from(["k", "x"]).map(Name)
    return st.one_of(
        terms.map(Sum),
        several.map(Product),
        st.builds(Quotient, parts, parts),
        st.builds(Power, parts, parts),
        parts.map(Negative),
        st.builds(Call, st.sampled_from(_FUNCTIONS), parts),
        st.builds(Derivative, parts, letters, st.integers(1, 3)),
        parts.map(Summation),
        st.builds(Summation, parts, index),
        st.builds(Summation, parts, index, parts, parts),
    )


trees = st.recursive(leaves, _larger, max_leaves=14)


plain_letters = st.sampled_from(["y", "s", "r", "theta", "phi", "m_1"]).map(Name)
bound_letters = st.sampled_from(["x", "theta", "phi"]).map(Name)


def _with_bounds(parts: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    several = st.lists(parts, min_size=2, max_size=3).map(tuple)
    return st.one_of(
        several.map(Sum),
        several.map(Product),
        st.builds(Quotient, parts, parts),
        # A bar over one letter is a letter of its own, the conjugate where that is declared.
        st.builds(Call, st.sampled_from(["sin", "sqrt", "exp", "conj", "re", "lg"]), parts).filter(
            lambda call: call.function != "conj" or not isinstance(call.argument, Name)
        ),
        st.builds(IndexedProduct, parts, st.just(Name("k")), parts, parts),
        st.builds(Integral, parts, bound_letters, parts, parts),
        st.builds(Integral, parts, bound_letters, closed=st.booleans()),
        st.builds(Evaluation, parts, bound_letters, parts, st.one_of(st.none(), parts)),
        st.builds(Limit, parts, bound_letters, parts),
        st.builds(Extremum, st.sampled_from(["max", "min"]), parts, bound_letters),
        st.builds(
            lambda a, b, sign: Sum((a, PlusMinus(b, sign))), parts, parts, st.sampled_from([1, -1])
        ),
    )


bounded_trees = st.recursive(
    st.one_of(st.integers(0, 40).map(lambda n: Number(Fraction(n))), plain_letters, plain_letters),
    _with_bounds,
    max_leaves=8,
)


def value(node: Formula) -> complex:
    """Return a number that two trees share if they say the same: unreal functions, real arithmetic."""
    match node:
        case Number(value=number):
            return complex(float(number))
        case Name(name=name) | Constant(name=name):
            return _letter(name)
        case Sum(terms=terms):
            return sum((value(term) for term in terms), 0j)
        case Product(factors=factors):
            total = 1 + 0j
            for factor in factors:
                total = total * value(factor)
            return total
        case Negative(operand=operand):
            return -value(operand)
        case Quotient():
            return _over(value(node.numerator), value(node.denominator))
        case Power(base=base, exponent=exponent):
            return _mixed("power", value(base), value(exponent))
        case Call(function=function, argument=argument):
            return _call(function, argument)
        case Derivative():
            return _mixed(f"d{node.order}", value(node.expression), value(node.variable))
        case PlusMinus():
            return _mixed(f"pm{node.upper}", value(node.operand), 0.3)
        case IndexedProduct() | Integral() | Evaluation() | Limit() | Extremum():
            body, *rest = (value(part) for part in children(node))
            places = sum((0.7**k * part for k, part in enumerate(rest)), 0j)
            return _mixed(type(node).__name__, body, places)
        case Summation():
            parts = [value(part) for part in (node.index, node.lower, node.upper) if part is not None]
            return _mixed(f"sum{len(parts)}", value(node.body), sum(parts, 0j))
        case _:
            return 0.617 + 0j


def _call(function: str, argument: Formula) -> complex:
    if function == "exp" and argument == Number(Fraction(1)):
        return _letter("e")
    if function == "sqrt" and argument in (Number(Fraction(-1)), Negative(Number(Fraction(1)))):
        return _letter("i")
    return _mixed(function, value(argument), 0.3)


def _over(top: complex, bottom: complex) -> complex:
    return top / (bottom if abs(bottom) > 1e-12 else 0.37)


def _letter(name: str) -> complex:
    seed = sum((place + 1) * ord(sign) for place, sign in enumerate(name))
    return complex(0.4 + (seed * 0.6180339887) % 1.0)


def _mixed(kind: str, first: complex, second: complex) -> complex:
    seed = _letter(kind).real
    return cmath.sin(seed + _tame(first) * 0.71) + 0.13 * seed * cmath.cos(1.7 * _tame(second)) + seed


def _tame(number: complex) -> complex:
    return number if abs(number) < 1e3 else number / abs(number)


UNHURRIED = settings(max_examples=200, deadline=None, suppress_health_check=list(HealthCheck))
KNOWN = frozenset(NAMES)

_PIECES = r"""
\frac { } ( ) [ ] \left \right | ^ _ \sqrt \sum \cos sin = + - * / \cdot … \cdots x θ \theta 1 2.5 1e5
e i \dot \bar d dx/dt \frac{d}{dt} \mathrm{ \text{ $ $$ \[ \] \begin{align} \end{align} & \\ , ; \quad
(1) \tag{1} ° 度 √ ² ⁻¹ ₁ ' ½ ! % ∫ ± < > ≤ → \over \displaystyle あ 。 word \foo ẋ ＝ # ``` \( \)
\, \mathrm{mm} \text{kN} [mm] rpm \unit{ \therefore ∴ \underbrace{ }_{ O( O \left( \bigr) \vec x( (t)
\prime \circ \infty pi M1 Δ m_{1 x_ \begin{cases} \begin{aligned} ٣ \{ \} ~ := --> = = x x s 3
"""
junk = st.lists(
    st.sampled_from([*_PIECES.split(), " ", " ", "\n", "\r\n", "\x00", "\ud800"]), max_size=40
).map("".join)


@pytest.mark.slow
@UNHURRIED
@given(bounded_trees)
def test_integrals_limits_and_values_at_a_place_read_back(tree: Formula) -> None:
    for text in (formula_text(tree, plain=True), formula_latex(tree)):
        back = read_expression(text, [*NAMES, "k"])[0]
        assert abs(value(back) - value(tree)) <= 1e-6 * (1 + abs(value(tree))), text


@pytest.mark.slow
@UNHURRIED
@given(trees)
def test_a_rendered_tree_reads_back_with_the_same_value(tree: Formula) -> None:
    for text in (formula_text(tree, plain=True), formula_latex(tree)):
        back = read_expression(text, [*NAMES, "k"])[0]
        assert abs(value(back) - value(tree)) <= 1e-6 * (1 + abs(value(tree))), text


@pytest.mark.slow
@UNHURRIED
@given(st.one_of(junk, st.text(max_size=60)), st.sampled_from([".tex", ".md", ".txt", ""]))
def test_any_text_is_read_or_refused(text: str, suffix: str) -> None:
    document = read_document(text, f"notes{suffix}", lambda line: KNOWN)
    lines = text.split("\n")
    for chain in document.chains:
        assert len(chain.sides) == len(chain.relations) + 1
        for side in chain.sides:
            assert 0 <= side.span[0] < side.span[1] <= len(text)
            assert 1 <= len(side.readings) <= 8
            assert all(
                _within(node.span, side.span) for reading in side.readings for node in walk(reading)
            )
    for refusal in document.unreadable:
        assert 1 <= refusal.line <= len(lines)
        assert 1 <= refusal.column <= len(lines[refusal.line - 1]) + 1
        assert refusal.what


@UNHURRIED
@given(st.one_of(junk, st.text(max_size=40)))
def test_any_expression_or_name_is_read_or_refused(text: str) -> None:
    for node in _readings(text):
        assert formula_text(node, plain=True)
        assert formula_latex(node)


def _readings(text: str) -> tuple[Formula, ...]:
    with suppress(ReadingError):
        canonical_name(text)
    try:
        return read_expression(text, KNOWN, offset=7)
    except ReadingError as refusal:
        inside = 7 <= refusal.offset <= 7 + len(text)
        return () if inside else pytest.fail(f"{refusal} for {text!r}")


def _within(inner: tuple[int, int], outer: tuple[int, int]) -> bool:
    return outer[0] <= inner[0] <= inner[1] <= outer[1]
