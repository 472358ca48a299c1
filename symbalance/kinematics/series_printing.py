"""Series in powers of 1/lambda in print: text and LaTeX straight from integers, in three conventions."""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.document.formula import Monomial
from symbalance.document.notation import (
    LATEX_NAMES,
    _latex_fraction,
    convention_named,
    monomial_text,
    signed,
)
from symbalance.kinematics.slider_crank import Series


def monomials(series: Series, convention: str = "l/r") -> Iterator[tuple[int, Monomial]]:
    """Yield a series' terms with their signs, lowest power first.

    >>> from fractions import Fraction
    >>> list(monomials(Series({1: Fraction(-1, 4)}, 1), "l/s"))
    [(-1, Monomial(coefficient=Fraction(1, 8), letter='lam', exponent=-1, of=None))]
    """
    letter, direction, scale = convention_named(convention)
    for power, coefficient in sorted(series.terms.items()):
        size = abs(coefficient) if scale == 1 else abs(coefficient) / scale**power
        yield (1 if coefficient > 0 else -1), Monomial(size, letter, direction * power)


def series_text(series: Series, convention: str = "l/r", *, ellipsis: bool = False) -> str:
    """Return a series as Unicode text; `ellipsis` marks that an incomplete one goes on.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> series_text(acceleration_series(6, through=7))
    '9/(128λ⁵) + 45/(512λ⁷)'
    >>> series_text(acceleration_series(4, through=5), "r/l", ellipsis=True)
    '−ρ³/4 − 3ρ⁵/16 − …'
    """
    terms = [(sign, monomial_text(term)) for sign, term in monomials(series, convention)]
    return signed(_going_on(terms, series, "…", ellipsis), "−")


def series_latex(series: Series, convention: str = "l/r", *, ellipsis: bool = False) -> str:
    r"""Return a series as LaTeX; `ellipsis` marks that an incomplete one goes on.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> print(series_latex(acceleration_series(6, through=7)))
    \frac{9}{128 \lambda^{5}} + \frac{45}{512 \lambda^{7}}
    >>> print(series_latex(acceleration_series(2, through=1), "l/s", ellipsis=True))
    \frac{1}{2 \lambda} + \cdots
    """
    letter, direction, scale = convention_named(convention)
    name, terms = LATEX_NAMES[letter], []
    for power, coefficient in sorted(series.terms.items()):
        own = coefficient if scale == 1 else coefficient / scale**power
        over, under = own.as_integer_ratio()
        printed = _latex_fraction(abs(over), under, name, direction * power)
        terms.append((1 if over > 0 else -1, printed))
    return signed(_going_on(terms, series, r"\cdots", ellipsis), "-")


def _going_on(
    terms: list[tuple[int, str]], series: Series, dots: str, ellipsis: bool
) -> list[tuple[int, str]]:
    """Return the terms with dots after them, signed as the last term is, where they go on."""
    if ellipsis and not series.complete:
        return [*terms, (terms[-1][0] if terms else 1, dots)]
    return terms or [(1, "0")]
