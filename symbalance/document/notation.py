r"""Letters and series in print: LaTeX and Unicode text, straight from integers.

A series in powers of 1/lambda is written in one of three conventions:

==========  ======================  =============================
convention  letter                  in terms of the rod ratio l/r
==========  ======================  =============================
l/r         lambda, in its inverse  itself
r/l         rho, in its powers      its inverse
l/s         lambda, in its inverse  half of it: the stroke is 2 r
==========  ======================  =============================
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from symbalance.document.formula import Monomial
from symbalance.document.symbols import MEANINGS
from symbalance.errors import SymbalanceError, shown


class Convention(NamedTuple):
    """How rho = r/l is written: rho^p = letter^(direction p) / scale^p."""

    letter: str
    direction: int
    scale: int


CONVENTIONS = {
    "l/r": Convention("lam", -1, 1),
    "r/l": Convention("rho", 1, 1),
    "l/s": Convention("lam", -1, 2),
}

TEXT_NAMES = {
    **{"theta": "θ", "lam": "λ", "rho": "ρ", "omega": "ω", "phi": "φ", "pi": "π", "kappa": "κ"},
    **{"dots": "…", "dtheta": "dθ", "Delta phi": "Δφ"},
    **{f"Delta {letter}": f"Δ{letter}" for letter in "xvaF"},
}
LATEX_NAMES = {
    **{name: rf"\{name}" for name in ("phi", "pi", "kappa")},
    **{name: meaning.latex for name, meaning in MEANINGS.items()},
    **{"dots": r"\cdots", "dtheta": r"d\theta", "Delta phi": r"\Delta \phi", "rad": r"\mathrm{rad}"},
    **{f"Delta {letter}": rf"\Delta {letter}" for letter in "xvaF"},
}
_RAISED = str.maketrans("0123456789+−()kmnij", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ᵏᵐⁿⁱʲ", " ")
_LOWERED = str.maketrans("0123456789+−()kmnij", "₀₁₂₃₄₅₆₇₈₉₊₋₍₎ₖₘₙᵢⱼ", " ")


def convention_named(name: str) -> Convention:
    """Return a convention, or refuse a name that is none.

    >>> convention_named("l/s").scale
    2
    """
    if not isinstance(name, str) or name not in CONVENTIONS:
        rule = f"must be one of {', '.join(CONVENTIONS)}"
        raise SymbalanceError(f"convention = {shown(name)}", rule, "l/r is the default")
    return CONVENTIONS[name]


def signed(terms: Iterable[tuple[int, str]], minus: str) -> str:
    """Return printed terms joined by their signs.

    >>> signed([(-1, "a"), (1, "b")], "-")
    '-a + b'
    """
    (sign, first), *rest = terms
    head = first if sign > 0 else minus + first
    return head + "".join(f" {'+' if s > 0 else minus} {term}" for s, term in rest)


def monomial_text(term: Monomial, of: str = "") -> str:
    """Return one term as text; `of` is a printed factor that joins the numerator.

    >>> from fractions import Fraction
    >>> monomial_text(Monomial(Fraction(3, 8), "lam", -3), "sin⁴θ")
    '3 sin⁴θ/(8λ³)'
    """
    over, under = str(term.coefficient.numerator), str(term.coefficient.denominator)
    letter = TEXT_NAMES.get(term.letter, term.letter) + (
        raised(str(abs(term.exponent))) if abs(term.exponent) > 1 else ""
    )
    if term.exponent > 0:
        over = letter if over == "1" else over + letter
    elif term.exponent < 0:
        under = letter if under == "1" else f"({under}{letter})"
    if of:
        over = of if over == "1" else f"{over} {of}"
    return over if under == "1" else f"{over}/{under}"


def monomial_latex(term: Monomial, of: str = "") -> str:
    r"""Return one term as LaTeX; `of` is a printed factor that joins the numerator.

    >>> from fractions import Fraction
    >>> print(monomial_latex(Monomial(Fraction(3, 8), "rho", 3)))
    \frac{3 \rho^{3}}{8}
    """
    name = LATEX_NAMES.get(term.letter, term.letter)
    return _latex_fraction(*term.coefficient.as_integer_ratio(), name, term.exponent, of)


def _latex_fraction(above: int, below: int, name: str, exponent: int, of: str = "") -> str:
    """Return above/below x name^exponent x of, from plain integers: tables spend their time here."""
    over, under = str(above), str(below)
    size = abs(exponent)
    letter = name if size == 1 else f"{name}^{{{size}}}"
    if exponent > 0:
        over = letter if above == 1 else f"{over} {letter}"
    elif exponent < 0:
        under = letter if below == 1 else f"{under} {letter}"
    if of:
        over = of if over == "1" else f"{over} {of}"
    return over if under == "1" else f"\\frac{{{over}}}{{{under}}}"


def raised(printed: str) -> str:
    """Return text as a superscript.

    >>> raised("2m − 1")
    '²ᵐ⁻¹'
    """
    return printed.translate(_RAISED)


def lowered(printed: str) -> str:
    """Return text as a subscript.

    >>> lowered("2k")
    '₂ₖ'
    """
    return printed.translate(_LOWERED)
