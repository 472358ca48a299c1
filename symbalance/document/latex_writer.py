r"""Formulas as LaTeX for amsmath, displayed or within a sentence, that reads back as the same formula.

>>> from symbalance.document.formula import Name, cos
>>> print(formula_latex(Name("r") * (1 - cos(Name("theta")))))
r \left(1 - \cos \theta\right)
"""

from __future__ import annotations

import re

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
    Number,
    Power,
    Product,
    Quotient,
    Subscript,
    Sum,
    Summation,
    Upright,
    walk,
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
    strength,
)
from symbalance.document.formula_printing import PRODUCT as PRODUCT_STRENGTH
from symbalance.document.latex_characters import escaped
from symbalance.document.letters import CIRCULAR, latex_letter


def formula_latex(formula: Formula | Equation, inline: bool = False) -> str:
    r"""Return a formula or an equation as LaTeX for math mode.

    `inline` is for a line of a paragraph: fractions with a slash.

    >>> from symbalance.document.formula import Name
    >>> ratio = Call("sin", Name("theta")) / Name("m_rec")
    >>> print(formula_latex(ratio), formula_latex(ratio, inline=True))
    \frac{\sin \theta}{m_{\mathrm{rec}}} \sin \theta/m_{\mathrm{rec}}
    """
    writer = InlineLatexWriter() if inline else LatexWriter()
    return writer.equation(formula) if isinstance(formula, Equation) else writer.write(formula)


class LatexWriter(FormulaWriter):
    """LaTeX for amsmath; widths in digits, on the wide side."""

    dots_sign = "\\cdots"
    plus_minus = {1: r"\pm ", -1: r"\mp "}  # noqa: RUF012 - a table
    relations = {  # noqa: RUF012 - a table
        "≈": r"\approx", "≤": r"\leq", "≥": r"\geq", "≠": r"\neq", "≪": r"\ll", "≫": r"\gg",
        "∝": r"\propto",
    }  # fmt: skip

    def __init__(self) -> None:
        super().__init__()
        self._widths: dict[str, float] = {}

    def width(self, printed: str) -> float:
        """Return how many digits wide something printed is, on the wide side: `latex_width`."""
        width = self._widths.get(printed)
        if width is None:
            width = self._widths[printed] = latex_width(printed)
        return width

    def fences(self, value: Sum, printed: str) -> tuple[str, str]:
        r"""Return brackets of fixed size, which may stand on different lines as \left, \right may not."""
        size = (r"\biggl", r"\biggr") if _is_tall(printed) else ("", "")
        left, right = ("[", "]") if holds_a_sum(value) else ("(", ")")
        return size[0] + left, size[1] + right

    def bracketed(self, printed: str) -> str:
        """Return something printed in brackets that grow with it."""
        return f"\\left({printed}\\right)"

    def factor(self, value: Formula, closed: bool = False, last: bool = False) -> str:
        """Return a factor of a product, in brackets where it needs them."""
        if isinstance(value, Sum) and len(value.terms) > 1:
            left, right = ("[", "]") if holds_a_sum(value) else ("(", ")")
            return rf"\left{left}{self.write(value)}\right{right}"
        least = POWER
        if isinstance(value, Decimal):
            least = PRODUCT_STRENGTH
        elif last and not closed and isinstance(value, OPERATORS):
            least = SIGN
        elif last and not closed and isinstance(value, Derivative) and isinstance(value.expression, Name):
            least = QUOTIENT
        return self.write(value, least, closed)

    def between(self, before: Formula, piece: str, after: Formula) -> str:
        """Return a dot before digits, a thin space where letters would run together, else none."""
        word_before = isinstance(before, Upright) and not isinstance(
            after, Call
        )  # \cos has its own space
        if isinstance(before, Decimal) or isinstance(after, Upright) or word_before:
            return r" \, "
        digits = piece[:1].isdecimal() and not isinstance(before, Sum)
        mixed = isinstance(before, Number) and piece.startswith("\\frac")
        if digits or mixed or before == Name("d"):
            return " \\cdot "
        apart = piece.startswith("\\frac") or (isinstance(after, Apply) and after.function == "hyp2f1")
        return r" \, " if apart else " "

    def binding(self, node: Formula) -> int:
        """Return how tightly a formula binds; a fraction with a bar needs brackets only as a base."""
        power = strength(node)
        while isinstance(node, Product) and len(node.factors) == 1:
            node = node.factors[0]
        return POWER if power == QUOTIENT and isinstance(node, Quotient | Number) else power

    def fraction(self, top: int, bottom: int) -> str:
        """Return a fraction of two numbers."""
        return f"\\frac{{{top}}}{{{bottom}}}"

    def decimal(self, node: Decimal, _: bool) -> str:
        """Write a decimal with its power of ten."""
        mantissa, *exponent = node.text.split("e")
        return mantissa + (rf"\cdot 10^{{{int(exponent[0])}}}" if exponent else "")

    def name(self, node: Name, _: bool) -> str:
        """Write a letter."""
        return latex_letter(node.name)

    def constant(self, node: Constant, _: bool) -> str:
        """Write pi, e, i or infinity; only within exp the letter i is the imaginary unit."""
        if node.name == "i" and self.exponentials:
            return "i"
        return _CONSTANTS.get(node.name, node.name)

    def upright(self, node: Upright, _: bool) -> str:
        """Write words; degrees without dollars of their own, which Markdown would end the formula at."""
        if node.text.endswith("°") and node.text[:-1].lstrip("−-").replace(".", "").isdecimal():
            return f"{node.text[:-1].replace('−', '-')}^{{\\circ}}"
        upright = node.text.isascii() and node.text.isalpha()
        return rf"\mathrm{{{node.text}}}" if upright else rf"\text{{{escaped(node.text)}}}"

    def dots(self, node: Dots, _: bool) -> str:
        """Write dots, or the order O(λ³) of what is left out."""
        return self.dots_sign if node.order is None else f"O{self.bracketed(self.write(node.order))}"

    def product(self, node: Product, closed: bool) -> str:
        """Write a b c."""
        factors, last = node.factors, len(node.factors) - 1
        if last < 1:
            return self.write(factors[0], 0, closed) if factors else "1"
        printed = self.factor(factors[0], closed=True)
        for place, factor in enumerate(factors[1:], 1):
            piece = self.factor(factor, closed or place < last, place == last)
            printed += self.between(factors[place - 1], piece, factor) + piece
        return printed

    def quotient(self, node: Quotient, _: bool) -> str:
        """Write a fraction with a bar."""
        return f"\\frac{{{self.write(node.numerator)}}}{{{self.write(node.denominator)}}}"

    def power(self, node: Power, closed: bool) -> str:
        """Write a to the power of b."""
        base, exponent = node.base, node.exponent
        if isinstance(base, Call) and base.function in CIRCULAR and _is_positive(exponent):
            head = f"\\{base.function}^{{{self.write(exponent)}}}"
            return head + self._argument(base.argument, closed)
        return f"{self.write(base, ATOM, closed=True)}^{{{self.write(exponent)}}}"

    def call(self, node: Call, closed: bool) -> str:
        """Write sin x, a root, an absolute value, exp(x)."""
        if node.function == "exp":
            return f"\\exp\\left({self.exponential(node)}\\right)"
        inside = self.write(node.argument) if node.function in ("sqrt", "abs") else ""
        if node.function == "sqrt":
            return f"\\sqrt{{{inside}}}"
        if node.function == "abs":
            left, right = ("\\left", "\\right") if _is_tall(inside) else ("", "")
            return f"{left}\\lvert {inside} {right}\\rvert"
        if node.function == "conj":
            return f"\\overline{{{self.write(node.argument)}}}"
        word = _FUNCTIONS.get(node.function, f"\\{node.function}")
        return word + self._argument(node.argument, closed)

    def _argument(self, node: Formula, closed: bool) -> str:
        if not closed:
            if _is_bare_argument(node):
                return f" {self.write(node)}"
            if isinstance(node, Quotient) and not any(isinstance(part, Call) for part in walk(node)):
                printed = self.write(node)
                return f"\\t{printed[1:]}" if printed.startswith("\\frac") else self.bracketed(printed)
        return self.bracketed(self.write(node))

    def apply(self, node: Apply, _: bool) -> str:
        """Write a binomial coefficient, 2F1, atan2(y, x)."""
        arguments = [self._small(argument) for argument in node.arguments]
        if node.function == "binomial":
            return rf"\binom{{{arguments[0]}}}{{{arguments[1]}}}"
        special = self.applied(node)
        if special is not None:
            return special
        left, right = (r"\left(", r"\right)") if any(map(_is_tall, arguments)) else ("(", ")")
        if node.function == "hyp2f1":
            a, b, c, z = arguments
            return rf"{{}}_{{2}}F_{{1}}{left}{a}, {b}; {c}; {z}{right}"
        return rf"\operatorname{{{escaped(node.function)}}}{left}{', '.join(arguments)}{right}"

    def applied(self, node: Apply) -> str | None:
        """Write n!, J_0(z), δ_(m,n), x(π), M^t; None for a function with its name in front."""
        first, last = node.arguments[0], node.arguments[-1]
        printed: str | None = None
        match node.function:
            case "factorial":
                printed = self.write(first, ATOM, closed=True) + "!"
            case "besselj":
                printed = f"J_{{{self.write(first)}}}{self.bracketed(self.write(last))}"
            case "kronecker":
                printed = rf"\delta_{{{self.write(first)},{self.write(last)}}}"
            case "at":
                printed = f"{self.write(first, ATOM)}{self.bracketed(self.write(last))}"
            case "transpose":
                printed = self.write(first, ATOM, closed=True) + r"^{\top}"
            case "det" | "max" | "min":
                inside = ", ".join(map(self.write, node.arguments))
                printed = f"\\{node.function}{self.bracketed(inside)}"
        return printed

    def _small(self, argument: Formula) -> str:
        r"""Write an argument among others: a half is small in it."""
        return self.write(argument).replace(r"\frac{1}{2}", r"\tfrac{1}{2}")

    def subscript(self, node: Subscript, _: bool) -> str:
        """Write a letter with an index; one that has an index of its own goes into braces."""
        base = self.write(node.base, ATOM)
        if "_" in base:
            base = f"{{{base}}}"
        return f"{base}_{{{self.write(node.index)}}}"

    def derivative(self, node: Derivative, _: bool) -> str:
        """Write dx/dθ, or d/dθ(expression)."""
        order = f"^{{{node.order}}}" if node.order > 1 else ""
        below = f"\\mathrm{{d}}{latex_letter(node.variable.name)}{order}"
        if isinstance(node.expression, Name):
            return self._bar(f"\\mathrm{{d}}{order}{latex_letter(node.expression.name)}", below)
        return self._bar(f"\\mathrm{{d}}{order}", below) + self.bracketed(self.write(node.expression))

    def _bar(self, above: str, below: str) -> str:
        return f"\\frac{{{above}}}{{{below}}}"

    def summation(self, node: Summation, closed: bool) -> str:
        """Write a sum sign with its bounds."""
        bounds = ""
        if node.index is not None:
            lower = f"={self.write(node.lower)}" if node.lower is not None else ""
            bounds = f"_{{{latex_letter(node.index.name)}{lower}}}"
            bounds += f"^{{{self.write(node.upper)}}}" if node.upper is not None else ""
        return f"\\sum{bounds} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def _bounds(self, lower: Formula | None, upper: Formula | None, index: str = "") -> str:
        below = "" if lower is None else f"_{{{index}{self.write(lower)}}}"
        return below + ("" if upper is None else f"^{{{self.write(upper)}}}")

    def indexedproduct(self, node: IndexedProduct, closed: bool) -> str:
        """Write a product sign with its bounds."""
        bounds = self._bounds(node.lower, node.upper, f"{latex_letter(node.index.name)}=")
        return f"\\prod{bounds} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def integral(self, node: Integral, _: bool) -> str:
        """Write an integral with its bounds."""
        sign = r"\oint" if node.closed else r"\int"
        body = self.write(node.body, PRODUCT_STRENGTH, closed=True)
        bounds = self._bounds(node.lower, node.upper)
        return rf"{sign}{bounds} {body} \, \mathrm{{d}}{latex_letter(node.variable.name)}"

    def evaluation(self, node: Evaluation, _: bool) -> str:
        """Write a value behind a bar, an increase in square brackets."""
        letter, inside = latex_letter(node.variable.name), self.write(node.expression)
        if node.lower is None:
            return rf"\left.{inside}\right|_{{{letter}={self.write(node.upper)}}}"
        return rf"\left[{inside}\right]" + self._bounds(node.lower, node.upper, f"{letter}=")

    def limit(self, node: Limit, closed: bool) -> str:
        """Write a limit."""
        side = {1: "^{+}", -1: "^{-}"}.get(node.side, "")
        point = self.write(node.point, ATOM) if side else self.write(node.point)
        under = rf"_{{{latex_letter(node.variable.name)} \to {point}{side}}}"
        return rf"\lim{under} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def extremum(self, node: Extremum, closed: bool) -> str:
        """Write a largest or smallest value."""
        under = f"_{{{latex_letter(node.variable.name)}}}" if node.variable.name else ""
        return f"\\{node.function}{under} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def cases(self, node: Cases, _: bool) -> str:
        """Write values behind a brace, each with its condition."""
        rows = []
        for value, condition in zip(node.values, node.conditions, strict=True):
            when = r"\text{else}"
            if condition is not None:
                left, sign, right = condition
                when = f"{self.write(left)} {self.relation(sign)} {self.write(right)}"
            rows.append(f"{self.write(value)} & {when}")
        lines = r" \\ ".join(rows)
        return rf"\begin{{cases}} {lines} \end{{cases}}"

    def matrix(self, node: Matrix, _: bool) -> str:
        """Write a matrix in round brackets."""
        rows = r" \\ ".join(" & ".join(map(self.write, row)) for row in node.rows)
        return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}"


class InlineLatexWriter(LatexWriter):
    r"""LaTeX within a sentence: fractions with a slash.

    >>> from symbalance.document.formula import number
    >>> InlineLatexWriter().write(Name("l") / (number(2) * Name("r")))
    'l/(2 r)'
    """

    def bracketed(self, printed: str) -> str:
        """Return something printed in brackets; nothing is tall within a sentence."""
        return f"({printed})"

    def binding(self, node: Formula) -> int:
        """Return how tightly a formula binds."""
        return strength(node)

    def fraction(self, top: int, bottom: int) -> str:
        """Return a fraction of two numbers."""
        return f"{top}/{bottom}"

    def factor(self, value: Formula, closed: bool = False, last: bool = False) -> str:
        """Return a factor, sums and slashed fractions in brackets."""
        if last and isinstance(value, Quotient):
            return self.write(value)
        return super().factor(value, closed, last)

    def quotient(self, node: Quotient, _: bool) -> str:
        """Write a/b."""
        above = self.write(node.numerator, PRODUCT_STRENGTH)
        return f"{above}/{self.write(node.denominator, POWER)}"

    def _bar(self, above: str, below: str) -> str:
        return f"{above}/{below}"


_CONSTANTS = {"pi": "\\pi", "infinity": "\\infty", "e": "\\exp\\left(1\\right)", "i": "\\sqrt{-1}"}
_FUNCTIONS = {"asin": "\\arcsin", "acos": "\\arccos", "atan": "\\arctan", "re": "\\Re", "im": "\\Im"}
_TALL = (
    r"\int",
    r"\oint",
    r"\prod",
    r"\lim",
    r"\frac",
    r"\binom",
    r"\sum",
    r"\sqrt",
    r"\tfrac",
    r"\begin",
)


def _is_tall(printed: str) -> bool:
    return any(mark in printed for mark in _TALL)


def _is_positive(exponent: Formula) -> bool:
    r"""Tell whether an exponent may stand right after a function: \sin^{-1} is the inverse."""
    if isinstance(exponent, Product):
        return is_whole(exponent.factors[0]) and all(isinstance(f, Name) for f in exponent.factors[1:])
    if isinstance(exponent, Sum):
        return _is_positive(exponent.terms[0]) and all(map(is_whole, exponent.terms[1:]))
    return is_whole(exponent) or isinstance(exponent, Name)


def _is_bare_argument(node: Formula) -> bool:
    """Tell whether a function needs no brackets around a formula: θ, 2θ, 2kθ."""
    if isinstance(node, Product):
        first, *rest = node.factors
        return bool(rest) and is_whole(first) and all(isinstance(factor, Name) for factor in rest)
    return isinstance(node, Name)


# How wide ---------------------------------------------------------------------------------------


def latex_width(printed: str) -> float:
    r"""Return about how many digits wide a formula is printed, up to a fourteenth too few.

    A fraction is as wide as its wider part; a sign takes a digit and the space around it, a bracket that
    grows half a digit more than a plain one.

    >>> latex_width(r"6 \sqrt{3}"), latex_width(r"\frac{1}{2} - \cos\tfrac{2 \pi}{7}")
    (4.0, 8.5)
    """
    flat = _FUNCTION.sub(r"\1", _SILENT.sub("", printed.replace(r"\sqrt", "xx")))
    flat = _LETTER.sub("x", flat)
    while (simpler := _INNERMOST.sub(_wider, flat)) != flat:
        flat = simpler
    tall = printed.count(r"\left") + printed.count(r"\right") + printed.count(r"\bigg")
    return len(flat.replace(" ", "")) + 1.5 * len(_SIGN.findall(flat)) + 0.5 * tall


_SILENT = re.compile(
    r"\\(left|right|biggl|biggr|operatorname|text|mathrm|lvert|rvert|[ ,])|[\^_](?=\{)|&"
)
_FUNCTION = re.compile(r"\\(cos|sin|arcsin)")
_LETTER = re.compile(r"\\(?!t?frac)[a-zA-Z]+")
_SIGN = re.compile(r"[-+=≈]")
_INNERMOST = re.compile(r"\\t?frac\{([^{}]*)\}\{([^{}]*)\}|(?<!frac)(?<!\})\{([^{}]*)\}")


def _wider(match: re.Match[str]) -> str:
    """Return the wider part of a fraction, or what a pair of braces holds."""
    return match[3] if match[1] is None else max(match[1], match[2], key=len)
