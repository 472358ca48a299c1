"""One formula in every medium: what each says, against the tree itself, SymPy and the reader."""

from __future__ import annotations

import re
from collections import Counter
from fractions import Fraction
from xml.etree import ElementTree

import hypothesis.strategies as st
import pytest
import sympy
from hypothesis import HealthCheck, given, settings
from mpmath import mp

from symbalance.document import formula as f
from symbalance.document.expressions import formula_of
from symbalance.document.latex_writer import LatexWriter, formula_latex, latex_width
from symbalance.document.letters import letter_parts, lowered, raised
from symbalance.document.line_breaking import break_equation, break_link, break_sum, expand_radicals
from symbalance.document.mathml_writer import formula_mathml
from symbalance.document.nodes import Paragraph
from symbalance.document.symbols import symbol
from symbalance.document.sympy_writer import formula_sympy
from symbalance.document.text_writer import TextWriter, formula_text
from symbalance.errors import SymbalanceError
from symbalance.kinematics.derivation import derive
from symbalance.kinematics.slider_crank import QUANTITIES
from symbalance.notes.reading import read_expression

UNHURRIED = settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))

NAMES = ["x", "theta", "lam", "m_1", "m_rec", "bar_x", "x'", "Delta x", "omega_2'", "Lh"]
whole = st.integers(-12, 40).map(f.number)
numbers = st.one_of(whole, st.fractions(-5, 5, max_denominator=9).map(f.number))
letters = st.sampled_from(NAMES).map(f.Name)
decimals = st.sampled_from(["2.5", "7.4379e-5", "-1.5e12", "0.25"]).map(f.Decimal)
constants = st.sampled_from(["pi", "e", "i", "infinity"]).map(f.Constant)
leaves = st.one_of(numbers, letters, letters, decimals, constants, st.just(f.Upright("a < b & c")))


def _larger(parts: st.SearchStrategy[f.Formula]) -> st.SearchStrategy[f.Formula]:
    several = st.lists(parts, min_size=2, max_size=3).map(tuple)
    four = st.tuples(parts, parts, parts, parts)
    return st.one_of(
        st.lists(st.one_of(parts, st.just(f.Dots())), min_size=2, max_size=3).map(tuple).map(f.Sum),
        several.map(f.Product),
        st.builds(f.Quotient, parts, parts),
        st.builds(f.Power, parts, parts),
        parts.map(f.Negative),
        st.builds(f.Call, st.sampled_from(sorted(f.FUNCTIONS)), parts),
        st.builds(f.Apply, st.just("atan2"), st.tuples(parts, parts)),
        st.builds(f.Apply, st.just("binomial"), st.tuples(parts, parts)),
        st.builds(f.Apply, st.just("hyp2f1"), four),
        st.builds(f.Subscript, letters, parts),
        st.builds(f.Derivative, parts, letters, st.integers(1, 3)),
        st.builds(f.Summation, parts),
        st.builds(f.Summation, parts, letters, parts, parts),
        st.builds(f.IndexedProduct, parts, letters, parts, parts),
        st.builds(f.Integral, parts, letters, parts, parts, st.booleans()),
        st.builds(f.Integral, parts, letters),
        st.builds(f.Evaluation, parts, letters, parts, st.one_of(st.none(), parts)),
        st.builds(f.Limit, parts, letters, parts, st.sampled_from([-1, 0, 1])),
        st.builds(f.Extremum, st.sampled_from(["max", "min"]), parts, letters),
        st.builds(f.PlusMinus, parts, st.sampled_from([1, -1])),
        st.builds(lambda a, b, c, d: f.Cases((a, b), ((c, "<", d), None)), parts, parts, parts, parts),
        st.builds(f.Apply, st.sampled_from(["factorial", "transpose", "det"]), st.tuples(parts)),
        st.builds(
            f.Apply, st.sampled_from(["at", "besselj", "kronecker", "max"]), st.tuples(parts, parts)
        ),
        st.builds(f.Matrix, st.tuples(st.tuples(parts, parts), st.tuples(parts, parts))),
    )


formulas = st.recursive(leaves, _larger, max_leaves=10)


# The tree -----------------------------------------------------------------------------------------


@pytest.mark.slow
@UNHURRIED
@given(formulas)
def test_a_formula_is_what_its_children_make_it(formula: f.Formula) -> None:
    assert f.with_children(formula, f.children(formula)) == formula
    renamed = tuple(f.Name("z") for _ in f.children(formula))
    if not isinstance(formula, f.Derivative | f.Summation | f.Subscript):
        assert f.children(f.with_children(formula, renamed)) == renamed


def test_where_a_formula_stands_does_not_count() -> None:
    assert f.Name("x", span=(3, 4)) == f.Name("x")
    assert len({f.Name("x", span=(3, 4)), f.Name("x")}) == 1


def test_operators_keep_what_is_written() -> None:
    x, y = f.Name("x"), f.Name("y")
    assert 1 + x - y == f.Sum((f.number(1), x, f.Negative(y)))
    assert 2 * x * y == f.Product((f.number(2), x, y))
    assert x - (x + y) == f.Sum((x, f.Negative(f.Sum((x, y)))))
    assert (x / 2) ** 3 == f.Power(f.Quotient(x, f.number(2)), f.number(3))
    assert f.monomial(Fraction(1), x, 0) == f.number(1)


# MathML -------------------------------------------------------------------------------------------

_FUNCTION_WORDS = {*f.FUNCTIONS, "arcsin", "arccos", "arctan", "atan2", "F", "d", "Re", "Im"}
_FUNCTION_WORDS |= {"lim", "max", "min", "det", "J", "δ"}
CORE = {
    *("math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "mfrac", "msqrt", "msub", "msup", "msubsup"),
    "munder",
    *("munderover", "mover", "mtable", "mtr", "mtd", "mmultiscripts", "mprescripts"),
}
ARGUMENTS = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "munder": 2, "munderover": 3, "mover": 2}


def _said(formula: f.Formula) -> Counter[str]:
    """Return the letters and the digits of a formula, taken from its tree."""
    found: Counter[str] = Counter()
    for part in f.walk(formula):
        match part:
            case f.Name(name):
                for word in name.split():
                    _, base, script, _ = letter_parts(word)
                    found.update([base, script] if script else [base])
            case f.Number(value):
                found.update(map(str, abs(value).as_integer_ratio()))
                found.subtract(["1"] if value.denominator == 1 else [])
            case f.Decimal(printed):
                mantissa, _, exponent = printed.partition("e")
                found.update([mantissa.lstrip("-")])
                found.update(["10", str(abs(int(exponent)))] if exponent else [])
            case f.Constant(name):
                found.update([{"pi": "π", "infinity": "∞"}.get(name, name)])
            case f.Apply("hyp2f1", _):
                found.update(["1", "2"])
            case f.Derivative(order=order) if order > 1:
                found.update([str(order)] * 2)
    return +found


@pytest.mark.slow
@UNHURRIED
@given(formulas)
def test_mathml_is_well_formed_and_says_all_the_letters_and_digits(formula: f.Formula) -> None:
    root = ElementTree.fromstring(formula_mathml(formula))
    shown = Counter(part.text for part in root.iter() if part.tag in ("mi", "mn"))
    assert {part.tag for part in root.iter()} <= CORE
    assert all(len(part) == ARGUMENTS[part.tag] for part in root.iter() if part.tag in ARGUMENTS)
    rest = shown - _said(formula)
    assert not _said(formula) - shown
    assert set(rest) <= _FUNCTION_WORDS


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_mathml_of_a_whole_derivation(quantity: str) -> None:
    parts = [part for step in derive(quantity, 12).steps for part in step.parts]
    pieces = [piece for part in parts if isinstance(part, Paragraph) for piece in part.words]
    equations = [part for part in [*parts, *pieces] if isinstance(part, f.Equation)]
    assert len(equations) > 10
    for equation in equations:
        root = ElementTree.fromstring(formula_mathml(equation, display=True))
        assert root.get("display") == "block"
        sides = [equation.left, *(right for _, right in equation.links)]
        shown = Counter(part.text for part in root.iter() if part.tag in ("mi", "mn"))
        assert not sum((_said(side) for side in sides), Counter()) - shown


@pytest.mark.parametrize(
    ("formula", "inside"),
    [
        (f.Name("x") - f.Name("x"), "<mrow><mi>x</mi><mo>−</mo><mi>x</mi></mrow>"),
        (f.Upright("a < b"), "<mtext>a &lt; b</mtext>"),
        (
            f.cos(2 * f.Name("theta")),
            '<mrow><mi>cos</mi><mo>\u2061</mo><mspace width="0.2em"></mspace>'
            "<mrow><mn>2</mn><mo>\u2062</mo><mi>θ</mi></mrow></mrow>",
        ),
        (
            2 * (f.Name("x") + 1),
            "<mrow><mn>2</mn><mo>\u2062</mo>"
            "<mrow><mo>(</mo><mrow><mi>x</mi><mo>+</mo><mn>1</mn></mrow><mo>)</mo></mrow></mrow>",
        ),
    ],
)
def test_mathml_by_example(formula: f.Formula, inside: str) -> None:
    assert formula_mathml(formula) == f"<math>{inside}</math>"


# SymPy --------------------------------------------------------------------------------------------

LAM, PSI = symbol("lam"), sympy.Symbol("psi")
PRINTED = [
    (6 * sympy.sqrt(3), "6√3", r"6 \sqrt{3}"),
    (-3 * sympy.pi / 10, "−3π/10", r"-\frac{3 \pi}{10}"),
    (sympy.sqrt(sympy.Rational(25, 2) - 11 * sympy.sqrt(5) / 2), "√((25 − 11√5)/2)",
     r"\sqrt{\frac{25 - 11 \sqrt{5}}{2}}"),
    (3 * sympy.cos(sympy.pi / 7), "3 cos(π/7)", r"3 \cos\tfrac{\pi}{7}"),
    (sympy.sqrt(2) * sympy.sin(2 * sympy.pi / 7) / 2, "√2 sin(2π/7)/2", None),
    (sympy.Rational(1, 2) + sympy.sqrt(5) / 2, "(1 + √5)/2", r"\frac{1 + \sqrt{5}}{2}"),
    (sympy.sqrt(5) / 4 - sympy.Rational(1, 4), "(−1 + √5)/4", r"\frac{-1 + \sqrt{5}}{4}"),
    (sympy.sqrt(3) - sympy.sqrt(2), "√3 − √2", r"\sqrt{3} - \sqrt{2}"),
    (sympy.atan2(sympy.sqrt(3), -1 + sympy.sqrt(2), evaluate=False), "atan2(√3, −1 + √2)", None),
    (LAM**-2 * 3, "3/λ²", r"\frac{3}{\lambda^{2}}"),
    (2 * sympy.cos(2 * PSI), "2 cos 2ψ", r"2 \cos 2 \psi"),
    (sympy.cos(PSI / 2), "cos(ψ/2)", r"\cos\tfrac{\psi}{2}"),
    (sympy.Integer(0), "0", "0"),
]  # fmt: skip


@pytest.mark.parametrize(("expression", "printed", "in_latex"), PRINTED)
def test_expressions_print_as_handbooks_do(
    expression: sympy.Expr, printed: str, in_latex: str | None
) -> None:
    assert formula_text(formula_of(expression)) == printed
    assert in_latex is None or formula_latex(formula_of(expression)) == in_latex


@pytest.mark.parametrize("expression", [row[0] for row in PRINTED])
def test_expressions_come_back_from_their_formula(expression: sympy.Expr) -> None:
    assert sympy.expand(formula_sympy(formula_of(expression)) - expression) == 0
    assert formula_of(formula_sympy(formula_of(expression))) == formula_of(expression)


@pytest.mark.parametrize("expression", [row[0] for row in PRINTED if not row[0].has(sympy.atan2)])
def test_the_reader_reads_back_what_expressions_print(expression: sympy.Expr) -> None:
    names = ["lambda", "psi"]
    plain = formula_text(_renamed(formula_of(expression)), plain=True)
    for printed in (plain, formula_latex(formula_of(expression))):
        readings = [formula_sympy(each) for each in read_expression(printed, names)]
        known = {sympy.Symbol("lambda"): LAM}
        assert any(sympy.simplify(each.subs(known) - expression) == 0 for each in readings)


def _renamed(formula: f.Formula) -> f.Formula:
    """Return the formula with the reader's name for λ."""
    if isinstance(formula, f.Name):
        return f.Name("lambda") if formula.name == "lam" else formula
    return f.with_children(formula, tuple(map(_renamed, f.children(formula))))


def test_a_spread_sum_is_the_same_number() -> None:
    expression = sympy.Rational(1, 2) - sympy.sqrt(5) / 3 + sympy.cos(2 * sympy.pi / 7) / 6
    power, value = expand_radicals(formula_of(expression))
    assert (power, formula_text(value)) == (1, "1/2 + cos(2π/7)/6 − √5/3")
    assert sympy.expand(formula_sympy(value) - expression) == 0


@pytest.mark.parametrize("sign", [1, -1])
def test_a_spread_root_is_the_square_of_the_same_number(sign: int) -> None:
    inside = sympy.Rational(25, 2) - 11 * sympy.sqrt(5) / 2 + sympy.cos(2 * sympy.pi / 7)
    expression = sign * 3 * sympy.sqrt(inside) / 4
    power, value = expand_radicals(formula_of(expression))
    assert power == 2
    assert sympy.expand(formula_sympy(value) - sympy.expand(expression**2)) == 0


def test_derivations_have_their_value_in_sympy() -> None:
    x, k, j = f.Name("x"), f.Name("k"), f.Name("j")
    series = f.total(j, 0, 3, f.binomial(2 * j, j) * x ** (2 * j) / f.number(4) ** j)
    with mp.workdps(30):
        expected = mp.fsum(mp.binomial(2 * i, i) * mp.mpf("0.3") ** (2 * i) / 4**i for i in range(4))
        found = formula_sympy(series).doit().subs(sympy.Symbol("x"), sympy.Rational(3, 10))
        assert abs(mp.mpf(found.p) / found.q - expected) < mp.mpf(10) ** -25
    assert formula_sympy(f.alternating(k)) == (-1) ** sympy.Symbol("k")
    assert formula_sympy(f.Derivative(x, f.Name("t"))) != 0
    assert formula_sympy(f.equal(x, 3)) == sympy.Eq(sympy.Symbol("x"), 3)
    assert formula_sympy(f.Matrix(((x, f.number(1)),))) == sympy.Matrix([[sympy.Symbol("x"), 1]])


@pytest.mark.parametrize("formula", [1 + f.Dots(), f.Upright("rad"), f.Summation(f.Name("x"))])
def test_what_has_no_value_is_refused(formula: f.Formula) -> None:
    with pytest.raises(SymbalanceError):
        formula_sympy(formula)


def test_what_is_no_formula_is_refused() -> None:
    integral = sympy.Integral(sympy.Symbol("x"), sympy.Symbol("x"))
    with pytest.raises(SymbalanceError, match="no formula"):
        formula_of(integral)


# Text and LaTeX -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("formula", "printed", "plain", "in_latex"),
    [
        (f.Decimal("7.4379e-5"), "7.4379 × 10⁻⁵", "7.4379e-5", r"7.4379\cdot 10^{-5}"),
        (f.Upright("rad"), "rad", "rad", r"\mathrm{rad}"),
        (f.Upright("crank & rod"), "crank & rod", "crank & rod", r"\text{crank \& rod}"),
        (f.Subscript(f.Name("A"), 2 * f.Name("k")), "A₂ₖ", "A_{2k}", "A_{2 k}"),
        (f.Matrix(((f.Name("x"), f.number(0)),)), "[x, 0]", "[x, 0]",
         r"\begin{pmatrix} x & 0 \end{pmatrix}"),
        (f.sqrt(2 + f.sqrt(3)), "√(2 + √3)", "sqrt(2 + sqrt(3))", r"\sqrt{2 + \sqrt{3}}"),
        (f.absolute(f.Name("x")), "|x|", "abs(x)", r"\lvert x \rvert"),
        (f.Name("x") ** f.Name("theta"), "x^θ", "x^θ", r"x^{\theta}"),
        (f.number(Fraction(1, 2)), "½", "1/2", r"\frac{1}{2}"),
        (f.Apply("atan2", (f.number(1), f.Name("x"))), "atan2(1, x)", "atan2(1, x)",
         r"\operatorname{atan2}(1, x)"),
    ],
)  # fmt: skip
def test_a_formula_in_three_notations(
    formula: f.Formula, printed: str, plain: str, in_latex: str
) -> None:
    assert formula_text(formula) == printed
    assert formula_text(formula, plain=True) == plain
    assert formula_latex(formula) == in_latex


@UNHURRIED
@given(formulas)
def test_brackets_pair_and_latex_balances(formula: f.Formula) -> None:
    for inline in (False, True):
        printed = formula_latex(formula, inline=inline)
        assert printed.count("{") - printed.count(r"\{") == printed.count("}") - printed.count(r"\}")
        assert len(re.findall(r"\\left\b", printed)) == len(re.findall(r"\\right\b", printed))
    for plain in (False, True):
        printed = formula_text(formula, plain=plain)
        assert printed.count("(") == printed.count(")")


def test_scripts_that_unicode_lacks_keep_their_mark() -> None:
    assert raised("2y") == "^(2y)"
    assert lowered("k,y") == "_(k,y)"


# Line breaking ------------------------------------------------------------------------------------


def _long(count: int) -> f.Formula:
    x = f.Name("x")
    return f.Sum(tuple(f.signed((-1) ** k, f.number(10**k) * x**k) for k in range(1, count)))


@pytest.mark.parametrize("room", [20, 34, 79])
def test_broken_text_stays_in_its_room_and_says_the_same(room: int) -> None:
    inside = _long(12)
    formula = f.Name("m") * f.Name("r") * inside
    lines = break_link("=", formula, TextWriter(), room, 2)
    assert len(lines) > 1
    assert all(len(line.printed) + 2 * line.depth <= room for line in lines)
    joined = " ".join(line.printed for line in lines)
    assert joined.replace(" ", "") == f"= {formula_text(formula)}".replace(" ", "")


def test_broken_latex_stays_in_its_room() -> None:
    writer = LatexWriter()
    lines = break_sum(_long(12), writer, 30, 12, 5)
    assert latex_width(lines[0].printed) <= 12
    assert all(latex_width(line.printed) <= 25 for line in lines[1:])
    assert len(lines) > 3


def test_short_links_share_a_line() -> None:
    x, y = f.Name("x"), f.Name("y")
    lines = break_equation(f.equal(x, y, x, _long(9), y), TextWriter(), 30, 2)
    assert lines[0].printed == "= y = x"
    assert lines[-1].printed == "= y"
