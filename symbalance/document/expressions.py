"""Exact numbers in print: SymPy expressions of our few kinds, as Unicode text or LaTeX.

A sum over a common denominator is printed as one fraction, and products as handbooks write them:
6√3, √((25 − 11√5)/2), 3 cos(π/7). Phases and orders stay as they are: SymPy's own printers would
turn a cosine into a sine, or a short fraction into an ambiguous one.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Protocol

import sympy
from sympy.printing.pretty.pretty_symbology import pretty_symbol

from symbalance.document.symbols import latex_names
from symbalance.text.numbers import short_text


class _Style(Protocol):
    minus: str

    def fraction(self, top: str, bottom: int, wrap: bool) -> str: ...
    def root(self, inside: str, simple: bool) -> str: ...
    def function(self, name: str, arguments: list[str]) -> str: ...
    def times(self, factor: str, rest: str) -> str: ...
    def bracket(self, inside: str) -> str: ...
    def other(self, expression: sympy.Basic) -> str: ...


class _Text:
    minus = "−"

    def fraction(self, top: str, bottom: int, wrap: bool) -> str:
        return f"({top})/{bottom}" if wrap else f"{top}/{bottom}"

    def root(self, inside: str, simple: bool) -> str:
        return f"√{inside}" if simple else f"√({inside})"

    def function(self, name: str, arguments: list[str]) -> str:
        return f"{name}({', '.join(arguments)})"

    def times(self, factor: str, rest: str) -> str:
        return f"{factor} {rest}" if rest[:1].isalpha() and rest[:1] != "π" else f"{factor}{rest}"

    def bracket(self, inside: str) -> str:
        return f"({inside})"

    def other(self, expression: sympy.Basic) -> str:
        if isinstance(expression, sympy.Symbol):
            return str(pretty_symbol(expression.name))
        if isinstance(expression, sympy.Pow) and expression.exp == 2:
            return f"{expression.base}²"
        return "π" if expression is sympy.pi else str(expression)


class _Latex:
    minus = "-"

    def fraction(self, top: str, bottom: int, wrap: bool) -> str:
        return rf"\frac{{{top}}}{{{bottom}}}"

    def root(self, inside: str, simple: bool) -> str:
        return rf"\sqrt{{{inside}}}"

    def function(self, name: str, arguments: list[str]) -> str:
        shown = r"\operatorname{atan2}" if name == "atan2" else rf"\{name}"
        inside = ", ".join(arguments)
        if inside.startswith(r"\frac") and len(arguments) == 1:
            return rf"{shown}\t{inside[1:]}"  # cos of a fraction of pi needs no bracket
        tall = r"\frac" in inside
        return rf"{shown}\left({inside}\right)" if tall else f"{shown}({inside})"

    def times(self, factor: str, rest: str) -> str:
        return f"{factor} {rest}"

    def bracket(self, inside: str) -> str:
        return rf"\left({inside}\right)"

    def other(self, expression: sympy.Basic) -> str:
        return sympy.latex(expression, symbol_names=latex_names())


def text(expression: sympy.Basic) -> str:
    """Return an exact number as Unicode text.

    >>> text(sympy.sqrt(sympy.Rational(25, 2) - 11 * sympy.sqrt(5) / 2)), text(-3 * sympy.pi / 10)
    ('√((25 − 11√5)/2)', '−3π/10')
    """
    return _printed(expression, _Text())


def ratio_latex(ratio: Fraction) -> str:
    """Return a rod ratio in math mode, cut off to decimals where the fraction is long."""
    printed = short_text(ratio, r"\ldots")
    return printed if "." in printed else latex(sympy.Rational(ratio.numerator, ratio.denominator))


def latex(expression: sympy.Basic) -> str:
    r"""Return an exact number as LaTeX.

    >>> print(latex(6 * sympy.sqrt(3)), latex(sympy.cos(2 * sympy.pi / 7) / 2))
    6 \sqrt{3} \frac{\cos\tfrac{2 \pi}{7}}{2}
    """
    return _printed(expression, _Latex())


def spread_latex(expression: sympy.Expr) -> str:
    r"""Return a sum as LaTeX with a denominator for each term, so that it can be broken over lines.

    >>> print(spread_latex(sympy.Rational(1, 2) - sympy.cos(2 * sympy.pi / 7) / 2))
    \frac{1}{2} - \frac{\cos\tfrac{2 \pi}{7}}{2}
    """
    terms = sympy.Add.make_args(expression)
    return _joined([_signed(term, _Latex()) for term in sorted(terms, key=_rank)])


def _printed(expression: Any, style: _Style) -> str:
    sign, body = _signed(expression, style)
    return sign + body


def _signed(expression: Any, style: _Style) -> tuple[str, str]:
    """Return a sign (empty or a minus) and the rest."""
    if expression.is_Add:
        return "", _sum(expression, style)
    factor, rest = expression.as_coeff_Mul(rational=True)
    sign = style.minus if factor < 0 else ""
    factor = abs(factor)
    if rest is sympy.S.One:
        top = str(factor.p)
    else:
        body = _product(rest, style)
        top = body if factor.p == 1 else style.times(str(factor.p), body)
    return sign, top if factor.q == 1 else style.fraction(top, factor.q, wrap=False)


def _sum(expression: Any, style: _Style) -> str:
    common = sympy.ilcm(1, *(t.as_coeff_Mul(rational=True)[0].q for t in expression.args))
    terms = sorted((common * t for t in expression.args), key=_rank)
    printed = _joined([_signed(term, style) for term in terms])
    return printed if common == 1 else style.fraction(printed, int(common), wrap=True)


def _joined(terms: list[tuple[str, str]]) -> str:
    """Return signed terms as a sum."""
    (sign, body), *others = terms
    return sign + body + "".join(f" {sign or '+'} {body}" for sign, body in others)


def _rank(term: Any) -> tuple[bool, bool, str]:
    """Rationals first, and where there is none a positive term first."""
    factor, rest = term.as_coeff_Mul(rational=True)
    return (rest is not sympy.S.One, bool(factor < 0), str(rest))


def _product(expression: Any, style: _Style) -> str:
    factors = sympy.Mul.make_args(expression)
    printed = [
        style.bracket(_sum(f, style)) if f.is_Add and len(factors) > 1 else _factor(f, style)
        for f in factors
    ]
    return " ".join(printed)


def _factor(expression: Any, style: _Style) -> str:
    if expression.is_Add:
        return _sum(expression, style)
    if expression.is_Pow and expression.exp == sympy.S.Half:
        base = expression.base
        return style.root(_printed(base, style), bool(base.is_Integer or base.is_Symbol))
    if isinstance(expression, sympy.cos | sympy.sin | sympy.atan2):
        arguments = [_printed(a, style) for a in expression.args]
        return style.function(type(expression).__name__, arguments)
    return style.other(expression)
