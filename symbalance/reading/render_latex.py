"""A tree as LaTeX that reads back as the same formula."""

from __future__ import annotations

from symbalance.reading.letters import CIRCULAR, GREEK_SIGN
from symbalance.reading.printing import ATOM, POWER, PRODUCT, SIGN, is_whole, merged, numeral, strength
from symbalance.reading.syntax import (
    Call,
    Constant,
    Derivative,
    Dots,
    Name,
    Negative,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
)

_WORD = {"asin": "\\arcsin", "acos": "\\arccos", "atan": "\\arctan"}
_CONSTANT = {"pi": "\\pi", "infinity": "\\infty", "e": "\\exp\\left(1\\right)", "i": "\\sqrt{-1}"}
_ACCENTS = ("bar", "hat", "vec", "tilde")


def render_latex(node: Node) -> str:
    r"""Return a formula as LaTeX.

    >>> render_latex(Quotient(Call("sin", Name("theta")), Name("m_rec")))
    '\\frac{\\sin \\theta}{m_{\\mathrm{rec}}}'
    """
    return _Latex().of(node)


class _Latex:
    def of(self, node: Node, least: int = 0, closed: bool = False) -> str:
        """Return the LaTeX, in brackets if it binds less than `least`; `closed` closes function arguments."""
        text = self._plain(node, closed)
        return f"\\left({text}\\right)" if self._strength(node) < least else text

    def _strength(self, node: Node) -> int:
        fraction = isinstance(node, Quotient | Number) and strength(node) == strength(_HALF)
        if isinstance(node, Product | Sum) and strength(node) == strength(_HALF):
            fraction = True
        return POWER if fraction else strength(node)

    def _plain(self, node: Node, closed: bool) -> str:
        match node:
            case Number():
                return self._number(node)
            case Name(name=name):
                return latex_letter(name)
            case Constant(name=name):
                return _CONSTANT.get(name, name)
            case Sum(terms=terms):
                return self._sum(terms)
            case Product(factors=factors):
                return self._product(factors, closed)
            case Quotient():
                return f"\\frac{{{self.of(node.numerator)}}}{{{self.of(node.denominator)}}}"
            case Power():
                return self._power(node, closed)
            case Negative(operand=operand):
                return f"-{self.of(operand, PRODUCT, closed)}"
            case Call():
                return self._call(node, closed)
            case _:
                return self._rare(node)

    def _rare(self, node: Node) -> str:
        match node:
            case Derivative():
                return self._derivative(node)
            case Summation():
                return self._summation(node)
            case Dots():
                return "\\cdots"
            case _:
                raise TypeError(f"{type(node).__name__} cannot be written")

    def _number(self, node: Number) -> str:
        digits = numeral(node)
        if not digits:
            top, bottom = merged(node)
            digits = f"\\frac{{{top}}}{{{bottom}}}" if bottom != 1 else str(top)
        return f"-{digits}" if node.value < 0 else digits

    def _sum(self, terms: tuple[Node, ...]) -> str:
        if not terms:
            return "0"
        text = self.of(terms[0], SIGN if len(terms) > 1 and not isinstance(terms[0], Dots) else 0)
        for term in terms[1:]:
            if isinstance(term, Dots):
                text += " + \\cdots"
            elif isinstance(term, Negative) and not isinstance(term.operand, Dots):
                text += f" - {self.of(term.operand, PRODUCT)}"
            else:
                text += f" + {self.of(term, PRODUCT if not isinstance(term, Summation) else SIGN)}"
        return text

    def _product(self, factors: tuple[Node, ...], closed: bool) -> str:
        text = "1" if not factors else ""
        for place, factor in enumerate(factors):
            last = place == len(factors) - 1
            piece = self.of(factor, POWER if len(factors) > 1 else 0, closed or not last)
            if place:
                times = (
                    piece[:1].isdecimal()
                    or factors[place - 1] == Name("d")
                    or (piece.startswith("\\frac") and isinstance(factors[place - 1], Number))
                )
                text += f" \\cdot {piece}" if times else f" {piece}"
            else:
                text = piece
        return text

    def _power(self, node: Power, closed: bool) -> str:
        base, exponent = node.base, node.exponent
        if isinstance(base, Call) and base.function in CIRCULAR and is_whole(exponent):
            head = f"\\{base.function}" if base.function in CIRCULAR else base.function
            return f"{head}^{{{self.of(exponent)}}}{self._argument(base.argument, closed)}"
        return f"{self.of(base, ATOM, closed=True)}^{{{self.of(exponent)}}}"

    def _call(self, node: Call, closed: bool) -> str:
        if node.function == "sqrt":
            return f"\\sqrt{{{self.of(node.argument)}}}"
        if node.function == "abs":
            return f"\\left|{self.of(node.argument)}\\right|"
        word = _WORD.get(node.function, f"\\{node.function}")
        if node.function in CIRCULAR:
            return word + self._argument(node.argument, closed)
        return f"{word}\\left({self.of(node.argument)}\\right)"

    def _argument(self, node: Node, closed: bool) -> str:
        if not closed and (isinstance(node, Name) or _is_multiple(node)):
            return f" {self.of(node)}"
        return f"\\left({self.of(node)}\\right)"

    def _derivative(self, node: Derivative) -> str:
        order = f"^{{{node.order}}}" if node.order > 1 else ""
        below = f"\\mathrm{{d}}{latex_letter(node.variable.name)}{order}"
        if isinstance(node.expression, Name):
            above = f"\\mathrm{{d}}{order} {latex_letter(node.expression.name)}"
            return f"\\frac{{{above}}}{{{below}}}"
        return f"\\frac{{\\mathrm{{d}}{order}}}{{{below}}}\\left({self.of(node.expression)}\\right)"

    def _summation(self, node: Summation) -> str:
        bounds = ""
        if node.index is not None:
            lower = f"={self.of(node.lower)}" if node.lower is not None else ""
            bounds = f"_{{{latex_letter(node.index.name)}{lower}}}"
            bounds += f"^{{{self.of(node.upper)}}}" if node.upper is not None else ""
        return f"\\sum{bounds} {self.of(node.body, PRODUCT)}"


_HALF = Quotient(Name("a"), Name("b"))


def _is_multiple(node: Node) -> bool:
    """Tell whether a node is a number times a letter, as 2θ."""
    if not isinstance(node, Product) or len(node.factors) != 2:
        return False
    return is_whole(node.factors[0]) and isinstance(node.factors[1], Name)


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
