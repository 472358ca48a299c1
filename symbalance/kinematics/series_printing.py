"""Series in powers of 1/lambda as formulas, text and LaTeX, in the three conventions of books."""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.document.formula import Dots, Formula, Name, Sum, monomial, number, signed
from symbalance.document.letters import latex_letter
from symbalance.document.text_writer import formula_text
from symbalance.kinematics.conventions import convention_named
from symbalance.kinematics.slider_crank import Series


def monomials(series: Series, convention: str = "l/r") -> Iterator[tuple[int, Formula]]:
    """Yield a series' terms with their signs, lowest power first.

    >>> from fractions import Fraction
    >>> from symbalance.document.formula import Name
    >>> list(monomials(Series({1: Fraction(-1, 4)}, 1), "l/s")) == [(-1, 1 / (8 * Name("lam")))]
    True
    """
    letter, direction, scale = convention_named(convention)
    base = Name(letter)
    for power, coefficient in sorted(series.terms.items()):
        size = abs(coefficient) if scale == 1 else abs(coefficient) / scale**power
        yield (1 if coefficient > 0 else -1), monomial(size, base, direction * power)


def series_formula(series: Series, convention: str = "l/r", *, ellipsis: bool = False) -> Formula:
    """Return a series as a formula; `ellipsis` marks that an incomplete one goes on.

    The dots have the sign of the last term.
    """
    terms = list(monomials(series, convention))
    if ellipsis and not series.complete:
        terms.append((terms[-1][0] if terms else 1, Dots()))
    printed = [signed(sign, term) for sign, term in terms] or [number(0)]
    return printed[0] if len(printed) == 1 else Sum(tuple(printed))


def series_text(series: Series, convention: str = "l/r", *, ellipsis: bool = False) -> str:
    """Return a series as Unicode text; `ellipsis` marks that an incomplete one goes on.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> series_text(acceleration_series(6, through=7))
    '9/(128λ⁵) + 45/(512λ⁷)'
    >>> series_text(acceleration_series(4, through=5), "r/l", ellipsis=True)
    '−ρ³/4 − 3ρ⁵/16 − …'
    """
    return formula_text(series_formula(series, convention, ellipsis=ellipsis))


def series_latex(series: Series, convention: str = "l/r", *, ellipsis: bool = False) -> str:
    r"""Return a series as LaTeX; `ellipsis` marks that an incomplete one goes on.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> print(series_latex(acceleration_series(6, through=7)))
    \frac{9}{128 \lambda^{5}} + \frac{45}{512 \lambda^{7}}
    >>> print(series_latex(acceleration_series(2, through=1), "l/s", ellipsis=True))
    \frac{1}{2 \lambda} + \cdots
    """
    letter, direction, scale = convention_named(convention)
    base, printed, minus = latex_letter(letter), "", False
    for power, coefficient in sorted(series.terms.items()):
        above, below = (coefficient if scale == 1 else coefficient / scale**power).as_integer_ratio()
        minus = above < 0
        term = _fraction(abs(above), below, base, direction * power)
        printed += (f" {'-' if minus else '+'} " if printed else "-" * minus) + term
    if ellipsis and not series.complete:
        printed += (f" {'-' if minus else '+'} " if printed else "") + r"\cdots"
    return printed or "0"


def _fraction(above: int, below: int, base: str, exponent: int) -> str:
    """Return above/below times base^exponent, from plain integers: tables spend their time here."""
    size = abs(exponent)
    power = base if size == 1 else f"{base}^{{{size}}}"
    over, under = str(above), str(below)
    if exponent > 0:
        over = power if above == 1 else f"{over} {power}"
    elif exponent < 0:
        under = power if below == 1 else f"{under} {power}"
    return over if under == "1" else f"\\frac{{{over}}}{{{under}}}"
