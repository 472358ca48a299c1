"""Formulas as MathML Core, which browsers typeset without any script.

>>> from symbalance.document.formula import Name, cos
>>> print(formula_mathml(Name("lam") ** 2))
<math><msup><mi>λ</mi><mn>2</mn></msup></math>
"""

from __future__ import annotations

import re
from html import escape

from symbalance.document.formula import (
    Apply,
    Call,
    Cases,
    Constant,
    Decimal,
    Derivative,
    Dots,
    Equation,
    Evaluation,
    Extremum,
    Formula,
    IndexedProduct,
    Integral,
    Limit,
    Matrix,
    Name,
    Negative,
    Number,
    PlusMinus,
    Power,
    Product,
    Quotient,
    Subscript,
    Sum,
    Summation,
    Upright,
)
from symbalance.document.formula_printing import (
    ATOM,
    OPERATORS,
    POWER,
    QUOTIENT,
    SIGN,
    FormulaWriter,
    holds_a_sum,
    is_whole,
)
from symbalance.document.formula_printing import PRODUCT as PRODUCT_STRENGTH
from symbalance.document.letters import CIRCULAR, letter_parts

APPLICATION = "\u2061"
"""The sign, never shown, between a function and its argument."""
_FUNCTION = re.compile("<mrow>(<msup>)?<mi>[a-z]{2,}<")
"""How a function begins: by a name of several letters."""
TIMES = "\u2062"
"""The sign, never shown, between two factors."""
_SPACE = '<mspace width="0.2em"></mspace>'
"""Beside upright words, which would run together with what stands next to them."""
_THIN = '<mspace width="0.17em"></mspace>'
_RAISED_END = re.compile(r"(?:^|,)(\([^()]*\))$")
_TYPED = re.compile(r"([0-9][0-9.,]*)(?: (\S.*))?")
"""Upright words that are a number as somebody typed it, with a decimal comma or a unit."""


def formula_mathml(formula: Formula | Equation, display: bool = False) -> str:
    """Return a formula or an equation as a `<math>` element; `display` gives it a line of its own.

    >>> from symbalance.document.formula import number
    >>> print(formula_mathml(Name("theta") / number(2), display=True))
    <math display="block"><mfrac><mi>θ</mi><mn>2</mn></mfrac></math>
    """
    writer = MathmlWriter()
    inside = writer.equation(formula) if isinstance(formula, Equation) else writer.write(formula)
    return f'<math display="block">{inside}</math>' if display else f"<math>{inside}</math>"


def _row(*parts: str) -> str:
    return f"<mrow>{''.join(parts)}</mrow>"


def _mi(letter: str) -> str:
    return f"<mi>{escape(letter)}</mi>"


def _mn(digits: str) -> str:
    return f"<mn>{escape(digits)}</mn>"


def _mo(sign: str) -> str:
    return f"<mo>{escape(sign)}</mo>"


class MathmlWriter(FormulaWriter):
    """MathML Core; every method returns one element."""

    minus = "−"

    def equation(self, value: Equation) -> str:
        """Return an equation, all its relations in one row."""
        links = (self._relation(sign) + self.write(right) for sign, right in value.links)
        return _row(self.write(value.left), *links)

    def _relation(self, sign: str) -> str:
        return _mo(self.relation(sign))

    def bracketed(self, printed: str) -> str:
        """Return an element in brackets."""
        return _row(_mo("("), printed, _mo(")"))

    def binding(self, node: Formula) -> int:
        """Return how tightly a formula binds; a fraction with a bar needs brackets only as a base."""
        power = super().binding(node)
        return POWER if power == QUOTIENT and isinstance(node, Quotient | Number) else power

    def fraction(self, top: int, bottom: int) -> str:
        """Return a fraction of two numbers."""
        return f"<mfrac>{_mn(str(top))}{_mn(str(bottom))}</mfrac>"

    def number(self, node: Number, _: bool) -> str:
        """Write a number."""
        if node.last_place is None and node.value.denominator == 1:
            digits = _mn(str(abs(node.value.numerator)))
        elif node.value < 0:
            return _row(_mo(self.minus), self.number(Number(-node.value, node.last_place), _))
        else:
            printed = super().number(node, _)
            return printed if printed.startswith("<") else self.decimal(Decimal(printed), _)
        return _row(_mo(self.minus), digits) if node.value < 0 else digits

    def decimal(self, node: Decimal, _: bool) -> str:
        """Write a decimal with its power of ten."""
        mantissa, _mark, exponent = node.text.partition("e")
        sign = _mo(self.minus) if mantissa.startswith("-") else ""
        digits = _mn(mantissa.lstrip("-"))
        if not exponent:
            return _row(sign, digits) if sign else digits
        power = _mn(str(abs(int(exponent))))
        power = _row(_mo(self.minus), power) if int(exponent) < 0 else power
        return _row(sign, digits, _mo("×"), f"<msup>{_mn('10')}{power}</msup>")

    def name(self, node: Name, _: bool) -> str:
        """Write a letter with its subscript and its primes."""
        return _letter(node.name)

    def constant(self, node: Constant, _: bool) -> str:
        """Write pi, e, i or infinity."""
        return _mn("∞") if node.name == "infinity" else _mi("π" if node.name == "pi" else node.name)

    def upright(self, node: Upright, _: bool) -> str:
        """Write words; a number as it was typed, 0,4 or 38,48 cm², as a number before them."""
        if number := _TYPED.fullmatch(node.text):
            unit = f"{_THIN}<mtext>{escape(number[2])}</mtext>" if number[2] else ""
            return _row(_mn(number[1]), unit) if unit else _mn(number[1])
        return f"<mtext>{escape(node.text)}</mtext>"

    def dots(self, node: Dots, _: bool) -> str:
        """Write dots, or the order O(λ³) of what is left out."""
        return _mo("⋯") if node.order is None else _row(_mi("O"), self.bracketed(self.write(node.order)))

    def negative(self, node: Negative, closed: bool) -> str:
        """Write -a."""
        return _row(_mo(self.minus), self.write(node.operand, PRODUCT_STRENGTH, closed))

    def plusminus(self, node: PlusMinus, closed: bool) -> str:
        """Write ±a."""
        return _row(_mo(self.plus_minus[node.upper]), self.write(node.operand, PRODUCT_STRENGTH, closed))

    def sum(self, node: Sum, closed: bool) -> str:
        """Write a + b - c."""
        parts = [
            (_mo(sign.strip()) if sign.strip() else "") + term
            for sign, term in self.signed_terms(node, closed)
        ]
        return _row(*parts) if len(parts) != 1 else parts[0]

    def product(self, node: Product, closed: bool) -> str:
        """Write a b c."""
        factors, last = node.factors, len(node.factors) - 1
        if last < 1:
            return self.write(factors[0], 0, closed) if factors else _mn("1")
        parts: list[str] = []
        for place, factor in enumerate(factors):
            piece = self._factor(factor, closed or place < last, place == last)
            parts += [*([self._between(factors[place - 1], piece)] if place else []), piece]
        return _row(*parts)

    def _factor(self, value: Formula, closed: bool, last: bool) -> str:
        if isinstance(value, Sum) and len(value.terms) > 1:
            left, right = "[]" if holds_a_sum(value) else "()"
            return _row(_mo(left), self.write(value), _mo(right))
        least = POWER
        if isinstance(value, Decimal):
            least = PRODUCT_STRENGTH
        elif last and not closed and isinstance(value, OPERATORS):
            least = SIGN
        elif isinstance(value, Derivative) and isinstance(value.expression, Name):
            least = QUOTIENT
        return self.write(value, least, closed)

    def _between(self, before: Formula, piece: str) -> str:
        digits = piece.startswith(("<mn>", "<msup><mn>", "<mfrac><mn>"))
        digits = digits or (piece.startswith("<mrow><mn>") and _THIN in piece)
        is_typed = isinstance(before, Upright) and _TYPED.fullmatch(before.text) is not None
        if digits and (is_typed or not isinstance(before, Upright)):
            return _mo("·")
        apart = (
            isinstance(before, Upright | Call) or piece.startswith("<mtext>") or _FUNCTION.match(piece)
        )
        return _mo(TIMES) + (_SPACE if apart else "")

    def quotient(self, node: Quotient, _: bool) -> str:
        """Write a fraction with a bar."""
        return f"<mfrac>{self.write(node.numerator)}{self.write(node.denominator)}</mfrac>"

    def power(self, node: Power, closed: bool) -> str:
        """Write a to the power of b."""
        base, above = node.base, self.write(node.exponent)
        if isinstance(base, Call) and base.function in CIRCULAR and is_whole(node.exponent):
            return _row(
                f"<msup>{_mi(base.function)}{above}</msup>", *self._applied(base.argument, closed)
            )
        bare = isinstance(base, Call) and base.function in ("abs", "sqrt")
        needs = isinstance(base, Call | Apply) and not bare
        below = self.bracketed(self.write(base)) if needs else self.write(base, ATOM)
        return f"<msup>{below}{above}</msup>"

    def call(self, node: Call, closed: bool) -> str:
        """Write sin x, a root, an absolute value."""
        if node.function == "sqrt":
            return f"<msqrt>{self.write(node.argument)}</msqrt>"
        if node.function == "abs":
            return _row(_mo("|"), self.write(node.argument), _mo("|"))
        if node.function == "conj":
            return f"<mover>{self.write(node.argument)}{_mo('¯')}</mover>"
        name = _WORDS.get(node.function, node.function)
        return _row(_mi(name), *self._applied(node.argument, closed or node.function not in CIRCULAR))

    def _applied(self, node: Formula, closed: bool) -> tuple[str, str]:
        bare = not closed and _is_bare_argument(node)
        inside = self.write(node)
        return _mo(APPLICATION), _SPACE + inside if bare else self.bracketed(inside)

    def apply(self, node: Apply, _: bool) -> str:
        """Write a binomial coefficient, 2F1, atan2(y, x)."""
        arguments = [self.write(argument) for argument in node.arguments]
        if node.function == "binomial":
            over = f'<mfrac linethickness="0">{arguments[0]}{arguments[1]}</mfrac>'
            return _row(_mo("("), over, _mo(")"))
        special = self.applied(node)
        if special is not None:
            return special
        head, between = _mi(node.function), [_mo(",")] * (len(arguments) - 1)
        if node.function == "hyp2f1":
            left = f"<mmultiscripts>{_mi('F')}{_mn('1')}<mrow></mrow><mprescripts></mprescripts>"
            head = f"{left}{_mn('2')}<mrow></mrow></mmultiscripts>"
            between = [_mo(","), _mo(";"), _mo(";")]
        inside = arguments[0] + "".join(
            mark + part for mark, part in zip(between, arguments[1:], strict=True)
        )
        return _row(head, _mo(APPLICATION), _mo("("), inside, _mo(")"))

    def applied(self, node: Apply) -> str | None:
        """Write n!, J_0(z), δ_(m,n), x(π), M^t; None for a function with its name in front."""
        first, last = node.arguments[0], node.arguments[-1]
        printed: str | None = None
        match node.function:
            case "factorial":
                printed = _row(self.write(first, ATOM, closed=True), _mo("!"))
            case "besselj":
                head = f"<msub>{_mi('J')}{self.write(first)}</msub>"
                printed = _row(head, _mo(APPLICATION), self.bracketed(self.write(last)))
            case "kronecker":
                printed = f"<msub>{_mi('δ')}{_row(self.write(first), _mo(','), self.write(last))}</msub>"
            case "at":
                printed = _row(self.write(first), _mo(APPLICATION), self.bracketed(self.write(last)))
            case "transpose":
                printed = f"<msup>{self.write(first, ATOM, closed=True)}{_mo('⊤')}</msup>"
        return printed

    def subscript(self, node: Subscript, _: bool) -> str:
        """Write a letter with an index."""
        return f"<msub>{self.write(node.base, ATOM)}{self.write(node.index)}</msub>"

    def derivative(self, node: Derivative, _: bool) -> str:
        """Write dx/dθ, or d/dθ(expression)."""
        d = '<mi mathvariant="normal">d</mi>'
        above = f"<msup>{d}{_mn(str(node.order))}</msup>" if node.order > 1 else d
        variable = self.write(node.variable)
        below = f"<msup>{variable}{_mn(str(node.order))}</msup>" if node.order > 1 else variable
        below = _row(d, below)
        if isinstance(node.expression, Name):
            return f"<mfrac>{_row(above, self.write(node.expression))}{below}</mfrac>"
        return _row(f"<mfrac>{above}{below}</mfrac>", self.bracketed(self.write(node.expression)))

    def summation(self, node: Summation, closed: bool) -> str:
        """Write a sum sign with its bounds."""
        sign = _mo("∑")
        if node.index is not None:
            below = self.write(node.index)
            if node.lower is not None:
                below = _row(below, _mo("="), self.write(node.lower))
            sign = f"<munder>{sign}{below}</munder>"
            if node.upper is not None:
                sign = f"<munderover>{_mo('∑')}{below}{self.write(node.upper)}</munderover>"
        return _row(sign, self.write(node.body, PRODUCT_STRENGTH, closed))

    def indexedproduct(self, node: IndexedProduct, closed: bool) -> str:
        """Write a product sign with its bounds."""
        below = _row(self.write(node.index), _mo("="), self.write(node.lower))
        sign = f"<munderover>{_mo('∏')}{below}{self.write(node.upper)}</munderover>"
        return _row(sign, self.write(node.body, PRODUCT_STRENGTH, closed))

    def integral(self, node: Integral, _: bool) -> str:
        """Write an integral with its bounds."""
        sign = _mo("∮" if node.closed else "∫")
        if node.lower is not None and node.upper is not None:
            sign = f"<msubsup>{sign}{self.write(node.lower)}{self.write(node.upper)}</msubsup>"
        d = '<mi mathvariant="normal">d</mi>'
        body = self.write(node.body, PRODUCT_STRENGTH, closed=True)
        return _row(sign, body, _SPACE, d, self.write(node.variable))

    def evaluation(self, node: Evaluation, _: bool) -> str:
        """Write a value behind a bar, an increase in square brackets."""
        inside, upper = self.write(node.expression), self.write(node.upper)
        if node.lower is None:
            where = _row(self.write(node.variable), _mo("="), upper)
            return _row(inside, f"<msub>{_mo('|')}{where}</msub>")
        where = _row(self.write(node.variable), _mo("="), self.write(node.lower))
        return f"<msubsup>{_row(_mo('['), inside, _mo(']'))}{where}{upper}</msubsup>"

    def limit(self, node: Limit, closed: bool) -> str:
        """Write a limit."""
        point = self.write(node.point)
        if node.side:
            point = f"<msup>{point}{_mo('+' if node.side > 0 else self.minus)}</msup>"
        below = _row(self.write(node.variable), _mo("→"), point)
        return _row(
            f"<munder>{_mi('lim')}{below}</munder>", self.write(node.body, PRODUCT_STRENGTH, closed)
        )

    def extremum(self, node: Extremum, closed: bool) -> str:
        """Write a largest or smallest value."""
        sign = _mi(node.function)
        if node.variable.name:
            sign = f"<munder>{sign}{self.write(node.variable)}</munder>"
        return _row(sign, self.write(node.body, PRODUCT_STRENGTH, closed))

    def cases(self, node: Cases, _: bool) -> str:
        """Write values behind a brace, each with its condition."""
        rows = []
        for value, condition in zip(node.values, node.conditions, strict=True):
            when = "<mtext>else</mtext>"
            if condition is not None:
                left, sign, right = condition
                when = _row(self.write(left), self._relation(sign), self.write(right))
            rows.append(f"<mtr><mtd>{self.write(value)}</mtd><mtd>{when}</mtd></mtr>")
        return _row(_mo("{"), f"<mtable>{''.join(rows)}</mtable>")

    def matrix(self, node: Matrix, _: bool) -> str:
        """Write a matrix in round brackets."""
        rows = (
            f"<mtr>{''.join(f'<mtd>{self.write(entry)}</mtd>' for entry in row)}</mtr>"
            for row in node.rows
        )
        return _row(_mo("("), f"<mtable>{''.join(rows)}</mtable>", _mo(")"))


_WORDS = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "re": "Re", "im": "Im"}
_ACCENTS = {
    "bar": "¯",
    "hat": "^",
    "vec": "→",
    "tilde": "~",
    "dot": "˙",
    "ddot": "¨",
    "dddot": "⃛",
    "underline": "_",
}


def _is_bare_argument(node: Formula) -> bool:
    """Tell whether a function needs no brackets around a formula: θ, 2kθ, a fraction with a bar."""
    if isinstance(node, Product):
        return all(isinstance(factor, Name) or is_whole(factor) for factor in node.factors)
    return isinstance(node, Name | Quotient)


def _letter(name: str) -> str:
    """Return a letter: one sign in italics, several and subscripts of several upright.

    What stands in round brackets at the end of a subscript is raised, as F_x^{(2)} is written.

    >>> print(_letter("m_rec"), _letter("Delta x"))
    <msub><mi>m</mi><mi>rec</mi></msub> <mrow><mi>Δ</mi><mi>x</mi></mrow>
    >>> print(_letter("F_x,(2)"))
    <msubsup><mi>F</mi><mi>x</mi><mi>(2)</mi></msubsup>
    """
    if " " in name:
        return _row(*map(_letter, name.split()))
    accent, base, script, primes = letter_parts(name)
    printed = _mi(base)
    if accent:
        element = "munder" if accent == "underline" else "mover"
        printed = f"<{element}>{printed}{_mo(_ACCENTS[accent])}</{element}>"
    raised = _RAISED_END.search(script)
    script = script[: raised.start()] if raised else script
    below = "" if not script else _mn(script) if script.isdecimal() else _mi(script)
    above = _mo("′" * len(primes)) if primes else ""
    if raised:
        above = _row(_mi(raised[1]), above) if above else _mi(raised[1])
    if below and above:
        return f"<msubsup>{printed}{below}{above}</msubsup>"
    if below:
        return f"<msub>{printed}{below}</msub>"
    return f"<msup>{printed}{above}</msup>" if above else printed
