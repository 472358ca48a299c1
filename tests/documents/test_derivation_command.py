"""The printed derivation: every equation in it is evaluated against the exact kinematics, in mpmath.

Nothing is parsed: the formulas are data, and `value` below evaluates them with numbers that come from
the geometry alone (the coefficients by the trapezoidal rule), so a wrong sign or factor in any line
fails.
"""

from __future__ import annotations

import re
import subprocess
import sys
from fractions import Fraction
from functools import cache

import pytest
from mpmath import mp

from symbalance.document import formula as f
from symbalance.document.latex_writer import formula_latex
from symbalance.document.nodes import Paragraph
from symbalance.document.result import to_latex, to_text
from symbalance.errors import SymbalanceError
from symbalance.kinematics.conventions import CONVENTIONS
from symbalance.kinematics.derivation import Derivation, derive
from symbalance.kinematics.derivation.remainder_step import printed_error
from symbalance.kinematics.series_printing import series_formula, series_latex, series_text
from symbalance.kinematics.slider_crank import QUANTITIES, acceleration_series, harmonics
from tests.effort import effort

ORDERS = (1, 2, 3, 6, 7, 12)
RATIO, THETA, POINTS = Fraction(30), mp.mpf("0.7"), 256
UNITS = {"displacement": 0, "velocity": 1, "acceleration": 2, "force": 2}
LETTERS = {"x": "displacement", "v": "velocity", "a": "acceleration", "F": "force", "phi": "rod-angle"}
COEFFICIENTS = {"B": "displacement", "V": "velocity", "A": "acceleration", "R": "rod-angle"}
R, OMEGA, MASS = mp.mpf("1.25"), mp.mpf("1.5"), mp.mpf("1.75")


def exact(quantity: str, theta: mp.mpf, lam: mp.mpf) -> mp.mpf:
    """Return a quantity in its unit, from the geometry and its derivatives in closed form."""
    s, c = mp.sin(theta), mp.cos(theta)
    root = mp.sqrt(lam * lam - s * s)
    if quantity == "rod-angle":
        return mp.asin(s / lam)
    if quantity == "displacement":
        return 1 + lam - c - root
    if quantity == "velocity":
        return s + s * c / root
    return c + (c * c - s * s) / root + (s * c) ** 2 / root**3


@cache
def fourier(quantity: str, n: int, ratio: Fraction) -> mp.mpf:
    """Return the coefficient of cos n theta (sin, for velocity and angle), by the trapezoidal rule."""
    with mp.workdps(40):
        wave = mp.sin if quantity in ("velocity", "rod-angle") else mp.cos
        total = mp.mpf(0)
        for i, sample in enumerate(samples(quantity, ratio)):
            total += sample * wave(2 * mp.pi * (n * i % POINTS) / POINTS)
        return total * (1 if n == 0 else 2) / POINTS


@cache
def samples(quantity: str, ratio: Fraction) -> list[mp.mpf]:
    lam = mp.mpf(ratio.numerator) / ratio.denominator
    return [exact(quantity, 2 * mp.pi * i / POINTS, lam) for i in range(POINTS)]


def unit(quantity: str) -> mp.mpf:
    if quantity == "rod-angle":
        return mp.mpf(1)
    return R * OMEGA ** UNITS[quantity] * (MASS if quantity == "force" else 1)


def scene(d: Derivation) -> dict[str, mp.mpf]:
    """Return a number for every letter of a derivation."""
    lam = mp.mpf(RATIO.numerator)
    kappa = mp.sqrt(1 - 1 / lam**2)
    known = {letter: exact(q, THETA, lam) * unit(q) for letter, q in LETTERS.items()}
    sine = mp.sin(THETA) / lam
    letters = {"r": R, "s": 2 * R, "l": lam * R, "m": MASS, "omega": OMEGA, "theta": THETA}
    letters |= {"rho": 1 / lam, "kappa": kappa, "q": (1 - kappa) / (1 + kappa)}
    letters |= {"lam": lam / 2 if d.convention == "l/s" else lam}
    letters |= {"X": sine if d.quantity == "rod-angle" else sine**2, "k": mp.mpf(2), "i": mp.mpf(1)}
    letters |= {"j": mp.mpf(3), "dt": mp.mpf(1), "dtheta": OMEGA, "dx": known["v"], "dv": known["a"]}
    kept = mp.fsum(fourier(d.quantity, n, RATIO) * wave(d)(n * THETA) for n in range(d.order + 1))
    error = (exact(d.quantity, THETA, lam) - kept) * unit(d.quantity)
    return known | letters | {f"Delta {letter}": error for letter in LETTERS}


def wave(d: Derivation):
    return mp.sin if d.harmonics.function == "sin" else mp.cos


def value(formula: f.Formula, at: dict[str, mp.mpf]) -> mp.mpf:
    """Return what a formula amounts to."""
    match formula:
        case f.Name(name):
            return at[name]
        case f.Number(number):
            return mp.mpf(number.numerator) / number.denominator
        case f.Constant("pi"):
            return +mp.pi
        case f.Dots():
            return mp.mpf(0)
        case f.Negative(operand):
            return -value(operand, at)
        case f.Derivative(f.Name(above), f.Name(below)):
            return at[f"d{above}"] / at[f"d{below}"]
        case f.Sum(terms):
            return mp.fsum(value(term, at) for term in terms)
        case f.Product(factors):
            return mp.fprod(value(factor, at) for factor in factors)
        case f.Quotient(over, under):
            return value(over, at) / value(under, at)
        case f.Power(base, exponent):
            return value(base, at) ** value(exponent, at)
        case f.Call("abs", inside):
            return abs(value(inside, at))
        case f.Call(function, argument):
            return getattr(mp, function)(value(argument, at))
        case f.Apply(function, arguments):
            return getattr(mp, function)(*(value(part, at) for part in arguments))
        case f.Subscript(f.Name(letter), index):
            return coefficient(letter, int(value(index, at)))
        case f.Summation(body, f.Name() as index, f.Formula() as first, f.Formula() as last):
            start = int(value(first, at))
            stop = start + 30 if last == f.INFINITY else int(value(last, at))
            return mp.fsum(value(body, at | {index.name: mp.mpf(i)}) for i in range(start, stop + 1))
    raise AssertionError(formula)


def coefficient(letter: str, n: int) -> mp.mpf:
    """Return what A_n, B_n, V_n, R_n or c_0 stands for, by the trapezoidal rule."""
    if letter in COEFFICIENTS:
        return (-1 if letter == "B" and n else 1) * fourier(COEFFICIENTS[letter], n, RATIO)
    return 1 - (fourier("displacement", 0, RATIO) - 1) / RATIO.numerator


def equations(d: Derivation) -> list[f.Equation]:
    parts = [part for step in d.steps for part in step.parts]
    said = [piece for part in parts if isinstance(part, Paragraph) for piece in part.words]
    return [
        *(part for part in parts if isinstance(part, f.Equation)),
        *(piece for piece in said if isinstance(piece, f.Equation) and not at_a_value(piece)),
    ]


def at_a_value(equation: f.Equation) -> bool:
    """Tell whether an equation in a sentence picks a value, as in "at theta = 0": no claim."""
    right = equation.links[-1][1]
    quarter = 1 / f.number(4)
    chosen = isinstance(right, f.Number) and equation.links[-1][0] == "="
    return chosen or right == quarter or equation.left == f.Name("theta")


def last_power(d: Derivation) -> int:
    """Return the highest odd power of 1/lambda that is kept; -1 where none is."""
    return d.power - 1 + d.power % 2


def has_dots(formula: f.Formula) -> bool:
    return f.Dots() in f.children(formula) or f.Negative(f.Dots()) in f.children(formula)


@pytest.mark.spread(2)
@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_every_equation_holds(quantity: str, convention: str, order: int) -> None:
    d = derive(quantity, order, convention)
    with mp.workdps(40):
        at, truncated = scene(d), 0
        for equation in equations(d):
            left = value(equation.left, at)
            name = equation.left.name if isinstance(equation.left, f.Name) else "x"
            for relation, right in equation.links:
                number = value(right, at)
                if relation == "≤":
                    assert left <= number
                    left = number
                    continue
                slack = mp.mpf(10) ** -32
                if relation == "≈":
                    truncated += 1
                    slack = (
                        mp.mpf("1.1")
                        * unit(LETTERS[name])
                        / mp.mpf(RATIO.numerator) ** (last_power(d) + 2)
                    )
                elif has_dots(right):
                    slack = mp.mpf(RATIO.numerator) ** -11
                assert abs(left - number) <= slack, (equation, relation, right)
        assert truncated >= (1 if order < 3 else 2)


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_the_harmonics_are_those_of_the_exact_motion(quantity: str, order: int) -> None:
    d = derive(quantity, order)
    with mp.workdps(40):
        for n in range(order + 1):
            series = d.harmonics.constant if n == 0 else d.harmonics.terms.get(n)
            printed = series.at(RATIO) if series else Fraction(0)
            slack = mp.mpf(RATIO.numerator) ** -(last_power(d) + 2) + mp.mpf(10) ** -35
            found = fourier(quantity, n, RATIO)
            assert abs(found - mp.mpf(printed.numerator) / printed.denominator) <= slack


@pytest.mark.slow
@pytest.mark.parametrize("order", [*ORDERS, 50])
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_the_conventions_agree(quantity: str, order: int) -> None:
    with mp.workdps(40):
        rows = []
        for convention in CONVENTIONS:
            d = derive(quantity, order, convention)
            found = [e.links[-1][1] for e in equations(d) if any(r == "≈" for r, _ in e.links)]
            rows.append([value(right, scene(d)) for right in found])
        for row in rows[1:]:
            assert all(abs(a - b) < mp.mpf(10) ** -32 for a, b in zip(rows[0], row, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize("convention", CONVENTIONS)
def test_a_long_derivation_lists_the_leading_terms_of_every_coefficient(
    quantity: str, convention: str
) -> None:
    d = derive(quantity, 60, convention)
    lines = {e.left: e.links[-1][1] for e in equations(d) if isinstance(e.left, f.Subscript)}
    letter = {"rod-angle": "R", "displacement": "B", "velocity": "V"}.get(quantity, "A")
    with mp.workdps(40):
        for n, series in d.harmonics.terms.items():
            if n == 1 and quantity != "rod-angle":
                continue
            number = value(lines[f.Subscript(f.Name(letter), f.number(n))], scene(d))
            expected = series.at(RATIO) * (-1 if letter == "B" else 1)
            assert 1 <= len(series.terms) <= 2
            expected = mp.mpf(expected.numerator) / expected.denominator
            assert abs(number / expected - 1) < mp.mpf(10) ** -30


@pytest.mark.spread(2)
@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_the_printed_error_is_a_bound_and_is_reached(quantity: str, order: int) -> None:
    found, lam = harmonics(quantity, order), Fraction(4)
    wave = mp.sin if found.function == "sin" else mp.cos
    rows = {n: series.at(lam) for n, series in found.terms.items()} | {0: found.constant.at(lam)}
    worst = mp.mpf(0)
    for i in range(361):
        theta = mp.pi * i / 180
        terms = [mp.mpf(c.numerator) / c.denominator * wave(n * theta) for n, c in rows.items() if n]
        rest = mp.mpf(rows[0].numerator) / rows[0].denominator
        worst = max(worst, abs(exact(quantity, theta, mp.mpf(4)) - rest - mp.fsum(terms)))
    bound = printed_error(order, found)
    assert worst <= bound
    assert worst > bound * mp.mpf("0.999" if quantity != "velocity" else "0.2")


@pytest.mark.spread(2)
@pytest.mark.parametrize("order", [*range(1, 14), 39, 40, 41, 42, 300, 1000])
@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_text_stays_within_80_columns(quantity: str, convention: str, order: int) -> None:
    text = to_text(derive(quantity, order, convention))
    assert max(map(len, text.splitlines())) <= 80
    assert all(line == line.rstrip() for line in text.splitlines())
    letter, *under = convention
    assert {"l/r": "λ = l/r", "r/l": "ρ = r/l", "l/s": "λ = l/s"}[letter + "".join(under)] in text


@pytest.mark.slow
def test_order_1000_takes_no_time() -> None:
    def printed() -> None:
        to_text(derive("force", 1000))
        to_latex(derive("rod-angle", 1000, "l/s"))

    assert effort(printed) < 10_000_000


CASES = {
    "force-6": ("force", 6, "l/r"),
    "displacement-7": ("displacement", 7, "l/s"),
    "angle-5": ("rod-angle", 5, "r/l"),
}


@pytest.mark.parametrize("name", CASES)
def test_golden(name: str, golden) -> None:
    d = derive(*CASES[name])
    golden(f"derive-{name}.txt", to_text(d))
    golden(f"derive-{name}.tex", to_latex(d))


@pytest.mark.slow
@pytest.mark.parametrize("order", [1, 2, 6, 13, 40, 41, 1000])
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_latex_compiles_within_the_margins(quantity: str, order: int, compile_latex) -> None:
    convention = list(CONVENTIONS)[order % 3]
    source = to_latex(derive(quantity, order, convention), standalone=True)
    assert compile_latex(source).exists()


def test_a_letter_names_one_thing() -> None:
    """X is what the root is expanded in; the mean displacement is B_0."""
    for order in (6, 60):
        d = derive("displacement", order)
        assert all(e.left != f.Subscript(f.Name("X"), f.number(0)) for e in equations(d))
        assert "X₀" not in to_text(d)
        assert "B₀" in to_text(d)


def test_a_fraction_before_a_function_stands_in_brackets() -> None:
    assert "(1/λ) sin θ" in to_text(derive("rod-angle", 1))
    for quantity in QUANTITIES:
        assert not re.search(r"·(cos|sin)|/\S*[^)\s] (cos|sin)", to_text(derive(quantity, 3, "l/s")))


@pytest.mark.parametrize(("quantity", "order"), [("force", 41), ("displacement", 41), ("rod-angle", 42)])
def test_what_lies_above_is_said_only_where_something_does(quantity: str, order: int) -> None:
    above = "Above order 40" in " ".join(to_text(derive(quantity, order)).split())
    assert above == (max(derive(quantity, order).harmonics.terms) > 40)


def test_a_power_is_kept_or_refused() -> None:
    assert derive("force", 2, power=5).harmonics.terms[2].terms == acceleration_series(2, 5).terms
    assert derive("force", 300, power=299).harmonics.terms[300].terms
    for arguments in (("force", 6, "l/r", 4), ("rod-angle", 6, "l/r", 4), ("force", 6, "l/r", -1)):
        with pytest.raises(SymbalanceError, match="power"):
            derive(*arguments)
    for arguments in (("jerk", 6), ("force", 0), ("force", 6, "s/l")):
        with pytest.raises(SymbalanceError):
            derive(*arguments)


@pytest.mark.slow
def test_deriving_does_without_sympy() -> None:
    code = (
        "import sys; from symbalance import derive, to_text\n"
        "to_text(derive()); print('sympy' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"


@pytest.mark.slow
def test_a_series_is_printed_with_much_less_work_than_sympy_takes() -> None:
    import sympy

    series = acceleration_series(2, 199)
    expression = series.in_lam()
    assert len(series.terms) == 100
    assert effort(lambda: sympy.latex(expression)) > 50 * effort(lambda: series_latex(series))


@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("ellipsis", [False, True])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 6])
def test_a_series_prints_as_its_formula_does(n: int, ellipsis: bool, convention: str) -> None:
    series = acceleration_series(n, 9)
    printed = series_latex(series, convention, ellipsis=ellipsis)
    assert printed == formula_latex(series_formula(series, convention, ellipsis=ellipsis))


def test_series_with_and_without_dots() -> None:
    six = acceleration_series(4, 5)
    assert series_latex(six, "l/s") == r"-\frac{1}{32 \lambda^{3}} - \frac{3}{512 \lambda^{5}}"
    assert series_text(six, "l/s", ellipsis=True) == "−1/(32λ³) − 3/(512λ⁵) − …"
    assert series_text(acceleration_series(1, 5), ellipsis=True) == "1"
    assert series_text(acceleration_series(3, 5), ellipsis=True) == "0"
