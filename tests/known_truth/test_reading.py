"""Single formulas: what each way of writing says, which readings it has, and what is refused."""

from __future__ import annotations

from fractions import Fraction

import pytest

from symbalance.document.formula import (
    Call,
    Derivative,
    Dots,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
    walk,
)
from symbalance.document.latex_writer import formula_latex
from symbalance.document.text_writer import formula_text
from symbalance.notes.reading import (
    ReadingError,
    UndeclaredError,
    canonical_name,
    read_equation,
    read_expression,
)

LETTERS_TEXT = """
theta lambda phi alpha omega rho s l x y n N h L R Lh rw m m_1 m_rec r F M a b c v q4 k t
x' bar_x X Delta_x
"""
LETTERS = LETTERS_TEXT.split()

SAID = [
    # fractions, roots, brackets
    (r"\dfrac12", "1/2"),
    (r"\frac x2", "x/2"),
    (r"\tfrac{1}{2} x^2", "1/2 x^2"),
    (r"{a\over b} c", "a/b c"),
    (r"\sqrt x y", "sqrt(x) y"),
    (r"\sqrt 3 x", "sqrt(3) x"),
    (r"\sqrt[3]{x}", "x^(1/3)"),
    (r"\sqrt(1-X) s", "sqrt(1 - X) s"),
    (r"\left(a+b\right)^2", "(a + b)^2"),
    (r"\bigl[a+b\bigr] \{a-b\}", "(a + b) (a - b)"),
    (r"|x-1| y", "abs(x - 1) y"),
    (r"\left|x\right|^2", "abs(x)^2"),
    ("√3 x", "sqrt(3) x"),
    ("√(1-X)", "sqrt(1 - X)"),
    ("4sqrt(2) F", "4 sqrt(2) F"),
    ("½ m v²", "1/2 m v^2"),
    ("2½ m + 4 ½", "5/2 m + 9/2"),
    # products and slashes
    (r"a \cdot b \times c", "a b c"),
    ("a*b×c·x", "a b c x"),
    ("a b/c x", "a b/c x"),
    ("a/b/c", "a/b/c"),
    ("a ÷ b c", "a/(b c)"),
    ("a×b/c", "a (b/c)"),
    ("1/λ cos 2θ", "1/λ cos 2θ"),
    ("1/2 λ", "1/2 λ"),
    (r"3 \cos 2\theta / 4", "3 cos(2θ)/4"),
    ("FL", "F L"),
    ("rwLh", "rw Lh"),
    ("a−b–c", "a - b - c"),
    ("2*-x", "2 (-x)"),
    # functions and their arguments
    (r"\sin 2\theta\cos\theta", "sin(2θ) cos θ"),
    (r"\cos n(\theta+h)", "cos(n (θ + h))"),
    (r"\cos (\frac{1}{6}\pi )6 \cos 6 \theta", "cos(1/6 π)*6 cos 6θ"),
    (r"\cos \frac{12θ - π/3}{2}", "cos((12θ - π/3)/2)"),
    (r"\sin ^4 \theta", "sin^4 θ"),
    (r"\sin ^2 (x) y", "sin^2(x) y"),
    (r"\sin^{-1}x", "arcsin(x)"),
    (r"\arccos x + \operatorname{sin} y + \mathrm{cos}\theta", "arccos(x) + sin y + cos θ"),
    ("cos(x)^2", "cos^2 x"),
    (r"\sin \theta \cdot a", "sin(θ) a"),
    (r"\ln \sin x", "ln(sin x)"),
    ("rcosθ", "r cos θ"),
    ("sin2θ", "sin 2θ"),
    ("acosθ", "a cos θ"),
    (r"e^{x} y", "exp(x) y"),
    (r"e^{i\theta}", "exp(i θ)"),
    ("exp(-x)", "exp(-x)"),
    # powers, scripts, letters
    ("x² y⁻¹", "x^2 y^(-1)"),
    ("x^10", "x^10"),
    ("x^n y", "x^n y"),
    ("x**2", "x^2"),
    ("m₁² m_{1}", "m_1^2 m_1"),
    (r"m_{\mathrm{rec}} m_rec m_{\text{rec}}", "m_rec m_rec m_rec"),
    ("x'^2 x′", "x'^2 x'"),
    (r"\mathbf{F} \mathit{Lh} \boldsymbol{\omega}", "F Lh ω"),
    (r"\bar x \bar{x}", "bar_x bar_x"),
    (r"\Delta x", "Delta_x".replace("Delta", "Δ")),
    ("ｘ＋２", "x + 2"),
    # numbers
    ("4.02", "4.02"),
    ("1.8e-4", "0.00018"),
    (r"2.4×10^{-4}", "2.4*10^(-4)"),
    ("4{,}02", "4.02"),
    (r"1\,024 x", "1024x"),
    ("1{,}024", "1024"),
    (r"30^\circ", "30 (π/180)"),
    ("30°+30度", "30 (π/180) + 30 (π/180)"),
    # signs, dots
    ("a + - b", "a - b"),
    ("a + + b", "a + b"),
    ("a - - b", "a - (-b)"),
    (r"1+x+\cdots", "1 + x + …"),
    (r"1+x-\ldots", "1 + x + …"),
    (r"(a+b \cdot \cdot \cdot)", "a + b + …"),
    (r"a+ \cdot\cdot\cdot \cos n", "a + … + cos n"),
    ("1+2+…+n", "1 + 2 + … + n"),
    # sums and derivatives
    (r"\sum x \times y", "Σ x y"),
    (r"\sum_{k=0}^{N-1}\cos(\theta+kh)+1", "Σ_{k=0}^{N - 1} cos(θ + k h) + 1"),
    ("Σ_{k=1}^n k", "Σ_{k=1}^{n} k"),
    (r"\frac{dx}{dt}", "dx/dt"),
    (r"\frac{\mathrm d^2 x}{\mathrm d t^2}", "d^2x/dt^2"),
    (r"\frac{\partial x}{\partial \theta}", "dx/dθ"),
    (r"\frac{d}{d\theta}(x^2) y", "d/dθ(x^2) y"),
    ("d^2x/dt^2", "d^2x/dt^2"),
    (r"\dot x \ddot{\theta} ẋ ẍ", "dx/dt (d^2θ/dt^2) (dx/dt) (d^2x/dt^2)"),
    (r"\dot{m}_1", "d/dt(m_1)"),
    (r"\displaystyle a\quad b~c\,x", "a b c x"),
]


@pytest.mark.parametrize(("source", "said"), SAID)
def test_what_a_formula_says(source: str, said: str) -> None:
    assert formula_text(read_expression(source, LETTERS)[0], plain=True) == said


@pytest.mark.parametrize(("source", "said"), SAID)
def test_the_latex_of_a_formula_says_the_same(source: str, said: str) -> None:
    latex = formula_latex(read_expression(source, LETTERS)[0])
    assert formula_text(read_expression(latex, LETTERS)[0], plain=True) == said


READINGS = [
    ("1/2λ", ["1/(2λ)", "1/2 λ"]),
    ("cos θ/2", ["cos(θ)/2", "cos(θ/2)"]),
    ("cos θ / 2", ["cos(θ)/2"]),
    (r"\sin N \frac{nh}{2}", ["sin(N (n h/2))", "sin(N) (n h/2)"]),
    (r"\sin\theta\frac{r}{l}", ["sin(θ) (r/l)", "sin(θ (r/l))"]),
    (r"\sin\theta(1+\cos\theta)", ["sin(θ) (1 + cos θ)", "sin(θ (1 + cos θ))"]),
    ("1/2(a+b)", ["1/2 (a + b)", "1/(2 (a + b))"]),
    ("a/bc", ["a/b c", "a/(b c)"]),
    ("1/λ", ["1/λ"]),
    ("ρ^3/16", ["ρ^3/16"]),
    (r"\frac{1}{2\lambda}\cos 2\theta", ["1/(2λ) cos 2θ"]),
]


@pytest.mark.parametrize(("source", "said"), READINGS)
def test_readings_where_usage_differs(source: str, said: list[str]) -> None:
    assert [formula_text(node, plain=True) for node in read_expression(source, LETTERS)] == said


def test_readings_are_few_and_different() -> None:
    readings = read_expression("+".join(["1/2λ"] * 40), LETTERS)
    assert len(readings) == 8
    assert len({formula_text(node, plain=True) for node in readings}) == 8


def test_a_declared_d_makes_a_quotient_the_second_reading() -> None:
    said = [formula_text(node, plain=True) for node in read_expression(r"\frac{dx}{dt}", [*LETTERS, "d"])]
    assert said == ["dx/dt", "d*x/(d*t)"]


REFUSED = [
    ("", 0, "an empty formula"),
    (r"a + \foo", 4, r"unknown command \foo"),
    ("a ( b", 2, "bracket ( is never closed"),
    ("a ) b", 2, "bracket ) was never opened"),
    ("(a]", 2, "bracket ( is closed by ]"),
    ("a+", 1, "nothing stands after +"),
    ("a/", 1, "nothing stands after the slash"),
    ("()", 0, "empty brackets"),
    ("2 3", 2, "two numbers side by side"),
    ("x^{2}^{3}", 5, "two exponents on one base"),
    ("n!!", 2, "a double factorial is not read"),
    ("x%", 1, "percentages are not read"),
    (r"\int x", 0, "an integral without its differential"),
    (r"\int_0 x\,dx", 0, "an integral with one bound only"),
    (r"\iint x", 0, "integrals over areas are not read"),
    (r"\left. x \right|", 0, "a bar without its place"),
    (r"\lim x", 0, "a limit without its point"),
    (r"\prod x", 0, "a product sign without index and bounds"),
    (r"\sup x", 0, "sup and inf are not read"),
    (r"x \to a", 2, "arrows are not read"),
    (r"\log_{2} x", 4, "a logarithm's base is not read"),
    (r"\cot^{-1} x", 11, "the inverse of cot is not read"),
    ("x^{10^1½}", 7, "1½, a mixed number or a product"),
    ("2 ½ m", 2, "2½, a mixed number or a product"),
    ("a, b", 1, ", within a formula"),
    (r"\begin{cases} a \end{cases}", 0, "cases without conditions"),
    (r"\begin{cases} x = a \\ y = b \end{cases}", 0, "a system of equations in one brace"),
    (r"\begin{pmatrix} a & b \\ c \end{pmatrix}", 0, "a matrix whose rows differ in length"),
    (r"\begin{tabular} a \end{tabular}", 0, "an environment that is not read"),
    ("_1", 0, "a subscript without its letter"),
    (r"\sin", 4, "a function without an argument"),
    ("1" * 401, 0, "a number of more than 400 digits"),
    ("(" * 70 + "x" + ")" * 70, 61, "more than 60 levels of brackets"),
    ("x" * 20_001, 0, "an equation of more than 20000 characters"),
    ("a = b", 0, "an equation where an expression belongs"),
]


@pytest.mark.parametrize(("source", "offset", "what"), REFUSED)
def test_what_is_refused_and_where(source: str, offset: int, what: str) -> None:
    with pytest.raises(ReadingError) as refusal:
        read_expression(source, LETTERS, 0)
    assert (refusal.value.offset, refusal.value.what) == (offset, what)


@pytest.mark.parametrize(
    ("source", "letter", "key"),
    [
        ("a w", "w", "w"),
        (r"\mu x", "mu", "mu"),
        ("m_2", "m_2", "m_2"),
        ("M2", "M2", "M2"),
        ("y''", "y''", "\"y''\""),
        (r"\hat x", "hat_x", "hat_x"),
        ("ζ", "zeta", "zeta"),
        ("e", "e", "e"),
        ("d x", "d", "d"),
    ],
)
def test_every_letter_must_be_declared(source: str, letter: str, key: str) -> None:
    with pytest.raises(UndeclaredError) as refusal:
        read_expression(source, LETTERS)
    assert refusal.value.letter == letter
    assert refusal.value.what == f"letter {letter} is not declared"
    assert refusal.value.remedy == f'declare it: {key} = "its meaning" in the [symbols] of the sidecar'


def test_the_tree_of_a_formula() -> None:
    (tree,) = read_expression(r"-\frac{4s}{1024 \lambda^3} \cos 2\theta+\cdots", LETTERS)
    two, three, four, many = (Number(Fraction(n)) for n in (2, 3, 4, 1024))
    top = Product((four, Name("s")))
    bottom = Product((many, Power(Name("lambda"), three)))
    term = Product((Quotient(top, bottom), Call("cos", Product((two, Name("theta"))))))
    assert tree == Sum((Negative(term), Dots()))


def test_a_number_keeps_its_last_place() -> None:
    assert read_expression("4.02", ())[0] == Number(Fraction(201, 50), Fraction(1, 100))
    assert read_expression("1.8e-4", ())[0] == Number(Fraction(9, 50000), Fraction(1, 100000))
    assert read_expression("7", ())[0] == Number(Fraction(7))


def test_a_sum_binds_its_index_and_a_dot_is_a_derivative_by_time() -> None:
    (tree,) = read_expression(r"\sum_{j=1}^{3} j x", ["x"])
    body = Product((Name("j"), Name("x")))
    assert tree == Summation(body, Name("j"), Number(Fraction(1)), Number(Fraction(3)))
    assert read_expression(r"\ddot x", ["x"])[0] == Derivative(Name("x"), Name("t"), 2)


def test_spans_are_the_source_of_every_part() -> None:
    source = r"  2(a+b) - \frac{x}{y}\cos 2\theta"
    (tree,) = read_expression(source, LETTERS, offset=100)
    spans = {source[node.span[0] - 100 : node.span[1] - 100] for node in walk(tree)}
    assert {
        r"2(a+b)",
        "(a+b)",
        r"- \frac{x}{y}\cos 2\theta",
        r"\frac{x}{y}",
        r"\cos 2\theta",
        r"2\theta",
    } <= spans


def test_an_offset_counts_in_refusals_too() -> None:
    with pytest.raises(ReadingError) as refusal:
        read_expression("a + w", LETTERS, offset=50)
    assert refusal.value.offset == 54


def test_an_equation_with_its_own_letter() -> None:
    chain = read_equation(r"Z_1 = 4\pi/N ≒ x", ["N", "x"])
    assert [formula_text(side.node, plain=True) for side in chain.sides] == ["Z_1", "4 π/N", "x"]
    assert [relation.sign for relation in chain.relations] == ["=", "≈"]


@pytest.mark.parametrize(
    ("written", "name"),
    [
        (r"\theta", "theta"),
        ("θ", "theta"),
        ("theta", "theta"),
        ("λ", "lambda"),
        ("m_{1}", "m_1"),
        ("m_1", "m_1"),
        ("m₁", "m_1"),
        (r"m_{\mathrm{rec}}", "m_rec"),
        ("m_rec", "m_rec"),
        ("x'", "x'"),
        ("x″", "x''"),
        (r"x^{\prime}", "x'"),
        (r"\varphi", "varphi"),
        ("ϕ", "varphi"),
        ("φ", "phi"),
        ("Lh", "Lh"),
        ("q4", "q4"),
        (r"\bar{x}_1", "bar_x_1"),
        (r"\mathbf{F}", "F"),
        (r"\Delta x", "Delta_x"),
        (r"$\omega_n$", "omega_n"),
        (r"F_\theta", "F_theta"),
    ],
)
def test_canonical_names(written: str, name: str) -> None:
    assert canonical_name(written) == name
    assert canonical_name(name) == name


@pytest.mark.parametrize("junk", ["", "1", "a b", r"\foo", "x+", "m_", "é", "{", "_1", "x" * 10 + "é"])
def test_junk_is_no_name(junk: str) -> None:
    with pytest.raises(ReadingError):
        canonical_name(junk)
