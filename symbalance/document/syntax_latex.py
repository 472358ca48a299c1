"""A tree as LaTeX that reads back as the same formula."""

from __future__ import annotations

from symbalance.document.letters import CIRCULAR, GREEK_SIGN
from symbalance.document.syntax import (
    Call,
    Constant,
    Derivative,
    Dots,
    Name,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Summation,
)
from symbalance.document.syntax_printing import (
    ATOM,
    POWER,
    QUOTIENT,
    Renderer,
    is_simple_angle,
    is_whole,
    strength,
)
from symbalance.document.syntax_printing import PRODUCT as PRODUCT_STRENGTH

_WORD = {"asin": "\\arcsin", "acos": "\\arccos", "atan": "\\arctan"}
_CONSTANT = {"pi": "\\pi", "infinity": "\\infty", "e": "\\exp\\left(1\\right)", "i": "\\sqrt{-1}"}
_ACCENTS = ("bar", "hat", "vec", "tilde")


def render_latex(node: Node) -> str:
    r"""Return a formula as LaTeX.

    >>> render_latex(Quotient(Call("sin", Name("theta")), Name("m_rec")))
    '\\frac{\\sin \\theta}{m_{\\mathrm{rec}}}'
    """
    return _Latex().of(node)


class _Latex(Renderer):
    dots_sign = "\\cdots"

    def bracketed(self, text: str) -> str:
        return f"\\left({text}\\right)"

    def binding(self, node: Node) -> int:
        """A fraction with a bar needs brackets only as a base."""
        found = strength(node)
        while isinstance(node, Product) and len(node.factors) == 1:
            node = node.factors[0]
        return POWER if found == QUOTIENT and isinstance(node, Quotient | Number) else found

    def fraction(self, top: int, bottom: int) -> str:
        return f"\\frac{{{top}}}{{{bottom}}}"

    def name(self, node: Name, _: bool) -> str:
        return latex_letter(node.name)

    def constant(self, node: Constant, _: bool) -> str:
        if node.name == "i" and self.exponentials:
            return "i"
        return _CONSTANT.get(node.name, node.name)

    def dots(self, _node: Dots, _: bool) -> str:
        return self.dots_sign

    def product(self, node: Product, closed: bool) -> str:
        factors = node.factors
        if len(factors) < 2:
            return self.of(factors[0], 0, closed) if factors else "1"
        text = self.of(factors[0], POWER, closed=True)
        for place, factor in enumerate(factors[1:], 1):
            piece = self.of(factor, POWER, closed or place < len(factors) - 1)
            text += f"{self._between(factors[place - 1], piece)}{piece}"
        return text

    def _between(self, before: Node, piece: str) -> str:
        mixed = isinstance(before, Number) and piece.startswith("\\frac")
        return " \\cdot " if piece[:1].isdecimal() or mixed or before == Name("d") else " "

    def quotient(self, node: Quotient, _: bool) -> str:
        return f"\\frac{{{self.of(node.numerator)}}}{{{self.of(node.denominator)}}}"

    def power(self, node: Power, closed: bool) -> str:
        base, exponent = node.base, node.exponent
        if isinstance(base, Call) and base.function in CIRCULAR and is_whole(exponent):
            head = f"\\{base.function}^{{{self.of(exponent)}}}"
            return head + self._argument(base.argument, closed)
        return f"{self.of(base, ATOM, closed=True)}^{{{self.of(exponent)}}}"

    def call(self, node: Call, closed: bool) -> str:
        if node.function == "exp":
            return f"\\exp\\left({self.exponential(node)}\\right)"
        if node.function == "sqrt":
            return f"\\sqrt{{{self.of(node.argument)}}}"
        if node.function == "abs":
            return f"\\left|{self.of(node.argument)}\\right|"
        if node.function in CIRCULAR:
            return f"\\{node.function}{self._argument(node.argument, closed)}"
        word = _WORD.get(node.function, f"\\{node.function}")
        return word + self.bracketed(self.of(node.argument))

    def _argument(self, node: Node, closed: bool) -> str:
        simple = not closed and is_simple_angle(node)
        return f" {self.of(node)}" if simple else self.bracketed(self.of(node))

    def derivative(self, node: Derivative, _: bool) -> str:
        order = f"^{{{node.order}}}" if node.order > 1 else ""
        below = f"\\mathrm{{d}}{latex_letter(node.variable.name)}{order}"
        if isinstance(node.expression, Name):
            above = f"\\mathrm{{d}}{order}{latex_letter(node.expression.name)}"
            return f"\\frac{{{above}}}{{{below}}}"
        return f"\\frac{{\\mathrm{{d}}{order}}}{{{below}}}{self.bracketed(self.of(node.expression))}"

    def summation(self, node: Summation, closed: bool) -> str:
        bounds = ""
        if node.index is not None:
            lower = f"={self.of(node.lower)}" if node.lower is not None else ""
            bounds = f"_{{{latex_letter(node.index.name)}{lower}}}"
            bounds += f"^{{{self.of(node.upper)}}}" if node.upper is not None else ""
        return f"\\sum{bounds} {self.of(node.body, PRODUCT_STRENGTH, closed)}"


def latex_letter(name: str) -> str:
    r"""Return a letter as LaTeX.

    >>> latex_letter("m_1"), latex_letter("Lh"), latex_letter("bar_x'")
    ('m_{1}', '\\mathit{Lh}', "\\bar{x}'")
    """
    bare = name.rstrip("'")
    primes = name[len(bare) :]
    base, _, subscript = bare.partition("_")
    if base in _ACCENTS and subscript:
        inner, _, script = subscript.partition("_")
        return f"\\{base}{{{_base(inner)}}}" + (f"_{{{_script(script)}}}" if script else "") + primes
    return _base(base) + (f"_{{{_script(subscript)}}}" if subscript else "") + primes


def _base(base: str) -> str:
    if base in GREEK_SIGN:
        return f"\\{base}"
    return base if len(base) == 1 else f"\\mathit{{{base}}}"


def _script(subscript: str) -> str:
    if subscript in GREEK_SIGN:
        return f"\\{subscript}"
    return f"\\mathrm{{{subscript}}}" if len(subscript) > 1 and subscript.isalpha() else subscript
