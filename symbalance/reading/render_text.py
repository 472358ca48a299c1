"""A tree as one line of plain text that reads back as the same formula."""

from __future__ import annotations

from symbalance.reading.letters import CIRCULAR, GREEK_SIGN
from symbalance.reading.printing import (
    ATOM,
    POWER,
    PRODUCT,
    QUOTIENT,
    SIGN,
    is_whole,
    merged,
    numeral,
    strength,
)
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

_WORD = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}
_CONSTANT = {"pi": "π", "infinity": "∞", "e": "exp(1)", "i": "sqrt(-1)"}


def render(node: Node) -> str:
    """Return a formula as one line of text.

    >>> from fractions import Fraction
    >>> angle = Product((Number(Fraction(6)), Name("theta")))
    >>> render(Product((Quotient(Number(Fraction(9)), Name("lambda")), Call("cos", angle))))
    '9/λ cos 6θ'
    """
    return _Text().of(node)


class _Text:
    def of(self, node: Node, least: int = 0, closed: bool = False) -> str:
        """Return the text, in brackets if it binds less than `least`; `closed` closes function arguments."""
        text = self._plain(node, closed)
        return f"({text})" if strength(node) < least else text

    def _plain(self, node: Node, closed: bool) -> str:
        match node:
            case Number():
                return self._number(node)
            case Name(name=name):
                return letter(name)
            case Constant(name=name):
                return _CONSTANT.get(name, name)
            case Sum(terms=terms):
                return self._sum(terms)
            case Product(factors=factors):
                return self._product(factors, closed)
            case Quotient():
                top = self.of(node.numerator, PRODUCT, closed=True)
                return f"{top}/{self._below(node.denominator)}"
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
                return "…"
            case _:
                raise TypeError(f"{type(node).__name__} cannot be written")

    def _number(self, node: Number) -> str:
        digits = numeral(node)
        if not digits:
            top, bottom = merged(node)
            digits = f"{top}/{bottom}" if bottom != 1 else str(top)
        return f"-{digits}" if node.value < 0 else digits

    def _sum(self, terms: tuple[Node, ...]) -> str:
        if not terms:
            return "0"
        text = self.of(terms[0], SIGN if len(terms) > 1 and not isinstance(terms[0], Dots) else 0)
        for term in terms[1:]:
            if isinstance(term, Dots):
                text += " + …"
            elif isinstance(term, Negative) and not isinstance(term.operand, Dots):
                text += f" - {self.of(term.operand, PRODUCT)}"
            else:
                text += f" + {self.of(term, PRODUCT if not isinstance(term, Summation) else SIGN)}"
        return text

    def _product(self, factors: tuple[Node, ...], closed: bool) -> str:
        text = "1" if not factors else ""
        for place, factor in enumerate(factors):
            last = place == len(factors) - 1
            least = QUOTIENT if place == 0 and len(factors) > 1 else POWER
            piece = self.of(factor, least if len(factors) > 1 else 0, closed or not last)
            text = f"{text}{self._between(text, factors, place, piece)}{piece}" if place else piece
        return text

    def _between(self, text: str, factors: tuple[Node, ...], place: int, piece: str) -> str:
        before, after = factors[place - 1], factors[place]
        if piece[:1].isdecimal() or before == Name("d"):
            return "*"
        simple = isinstance(after, Name) and len(letter(after.name)) == 1 and after.name not in ("e", "E")
        if is_whole(before) and simple:
            return ""
        return " "

    def _below(self, node: Node) -> str:
        if isinstance(node, Quotient | Derivative | Number) and strength(node) < ATOM:
            return f"({self.of(node)})"
        return self.of(node, POWER, closed=True)

    def _power(self, node: Power, closed: bool) -> str:
        base = node.base
        exponent = node.exponent
        if isinstance(base, Call) and base.function in CIRCULAR and is_whole(exponent):
            return f"{base.function}^{self.of(exponent)}{self._argument(base.argument, closed)}"
        bottom = self.of(base, ATOM, closed=True)
        simple = is_whole(exponent) or (isinstance(exponent, Name) and len(letter(exponent.name)) == 1)
        top = self.of(exponent) if simple else f"({self.of(exponent)})"
        return f"{bottom}^{top}"

    def _call(self, node: Call, closed: bool) -> str:
        word = _WORD.get(node.function, node.function)
        if node.function not in CIRCULAR:
            return f"{word}({self._within_exponential(node)})"
        return word + self._argument(node.argument, closed)

    def _within_exponential(self, node: Call) -> str:
        text = self.of(node.argument)
        return text

    def _argument(self, node: Node, closed: bool) -> str:
        if not closed and (isinstance(node, Name) or _is_multiple(node)):
            return f" {self.of(node)}"
        return f"({self.of(node)})"

    def _derivative(self, node: Derivative) -> str:
        order = f"^{node.order}" if node.order > 1 else ""
        variable = letter(node.variable.name)
        if isinstance(node.expression, Name) and len(node.expression.name.split("_")[0]) == 1:
            return f"d{order}{letter(node.expression.name)}/d{variable}{order}"
        return f"d{order}/d{variable}{order}({self.of(node.expression)})"

    def _summation(self, node: Summation) -> str:
        bounds = ""
        if node.index is not None:
            lower = f"={self.of(node.lower)}" if node.lower is not None else ""
            bounds = f"_{{{letter(node.index.name)}{lower}}}"
            bounds += f"^{{{self.of(node.upper)}}}" if node.upper is not None else ""
        return f"Σ{bounds} {self.of(node.body, PRODUCT)}"


def _is_multiple(node: Node) -> bool:
    """Tell whether a node is a number times a letter, as 2θ."""
    if not isinstance(node, Product) or len(node.factors) != 2:
        return False
    return is_whole(node.factors[0]) and isinstance(node.factors[1], Name)


def letter(name: str) -> str:
    """Return a letter as plain text.

    >>> letter("theta"), letter("m_rec"), letter("omega_1'")
    ('θ', 'm_rec', "ω_1'")
    """
    bare = name.rstrip("'")
    base, _, subscript = bare.partition("_")
    primes = name[len(bare) :]
    if not subscript:
        return GREEK_SIGN.get(base, base) + primes
    script = subscript if subscript.isascii() and subscript.isalnum() else f"{{{subscript}}}"
    return f"{GREEK_SIGN.get(base, base)}_{script}{primes}"
