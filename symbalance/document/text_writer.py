"""Formulas as one line of text: Unicode for people, or plain text that the formula reader accepts.

>>> from symbalance.document.formula import Name, cos
>>> formula_text(Name("r") * (1 - cos(Name("theta"))))
'r (1 − cos θ)'
"""

from __future__ import annotations

from symbalance.document.formula import (
    INFINITY,
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
)
from symbalance.document.formula_printing import (
    ATOM,
    OPERATORS,
    POWER,
    QUOTIENT,
    SIGN,
    FormulaWriter,
    holds_a_sum,
    is_simple_angle,
    is_whole,
    strength,
)
from symbalance.document.formula_printing import PRODUCT as PRODUCT_STRENGTH
from symbalance.document.letters import CIRCULAR, lowered, plain_letter, raised, text_letter


def formula_text(formula: Formula | Equation, plain: bool = False) -> str:
    """Return a formula or an equation as one line of text.

    `plain` text reads back as the same formula; the other has superscripts, roots and a true minus.

    >>> from symbalance.document.formula import Name, cos, number
    >>> wave = number(9) / Name("lam") * cos(6 * Name("theta")) + Name("x") ** 2
    >>> formula_text(wave)
    '(9/λ) cos 6θ + x²'
    >>> formula_text(number(9) / Name("lambda") * cos(6 * Name("theta")) + Name("x") ** 2, plain=True)
    '9/λ cos 6θ + x^2'
    """
    writer = PlainWriter() if plain else TextWriter()
    return writer.equation(formula) if isinstance(formula, Equation) else writer.write(formula)


class TextWriter(FormulaWriter):
    """Unicode text; widths in columns."""

    minus = "−"
    names = staticmethod(text_letter)
    constants = {"pi": "π", "infinity": "∞"}  # noqa: RUF012 - a table
    functions = {"binomial": "C"}  # noqa: RUF012 - a table

    def width(self, printed: str) -> float:
        """Return the number of columns."""
        return len(printed)

    def fences(self, value: Sum, printed: str) -> tuple[str, str]:
        """Return round brackets, square ones around round ones."""
        return ("[", "]") if holds_a_sum(value) else ("(", ")")

    def factor(self, value: Formula, closed: bool = False, last: bool = False) -> str:
        """Return a factor of a product, in brackets where it needs them; fractions only at the end."""
        if isinstance(value, Sum) and len(value.terms) > 1:
            printed = self.write(value)
            return printed.join(self.fences(value, printed))
        least = POWER
        if isinstance(value, Decimal):
            least = PRODUCT_STRENGTH
        elif last and isinstance(value, OPERATORS):
            least = SIGN
        elif last and isinstance(value, Quotient | Derivative):
            least = QUOTIENT
        return self.write(value, least, closed)

    def between(self, before: Formula, piece: str, after: Formula) -> str:
        """Return a dot between digits, nothing between a number and a letter, else a space."""
        if not isinstance(before, Number):
            return " "
        if piece[:1].isdecimal():
            return "·"
        letter = isinstance(after, Name | Subscript | Constant) or (
            isinstance(after, Call) and after.function == "sqrt"
        )
        power = isinstance(after, Power) and not isinstance(after.base, Call)
        return "" if letter or power else " "

    def binding(self, node: Formula) -> int:
        """Return how tightly a formula binds; a half has a sign of its own."""
        if isinstance(node, Number) and node.value.denominator == 2 and node.value.numerator == 1:
            return ATOM
        return strength(node)

    def fraction(self, top: int, bottom: int) -> str:
        """Return a fraction of two numbers."""
        return "½" if (top, bottom) == (1, 2) else f"{top}/{bottom}"

    def _tight(self, value: Formula) -> str:
        return self.write(value).replace(" ", "")

    def decimal(self, node: Decimal, _: bool) -> str:
        """Write a decimal, its power of ten raised."""
        mantissa, _mark, exponent = node.text.replace("-", self.minus).partition("e")
        if not exponent:
            return mantissa
        return f"{mantissa} × 10{raised(self._whole(exponent))}"

    @staticmethod
    def _whole(exponent: str) -> str:
        """Return an exponent without a plus or leading zeros."""
        minus = exponent[:1] if exponent[:1] in "-−" else ""
        return minus + (exponent.lstrip("+-−0") or "0")

    def name(self, node: Name, _: bool) -> str:
        """Write a letter."""
        return self.names(node.name)

    def constant(self, node: Constant, _: bool) -> str:
        """Write pi, e, i or infinity."""
        return self.constants.get(node.name, node.name)

    def upright(self, node: Upright, _: bool) -> str:
        """Write words."""
        return node.text

    def dots(self, node: Dots, _: bool) -> str:
        """Write dots, or the order O(λ³) of what is left out."""
        return self.dots_sign if node.order is None else f"O({self.write(node.order)})"

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
        """Write a/b."""
        above = self.write(node.numerator, PRODUCT_STRENGTH)
        return f"{above}/{self.write(node.denominator, POWER, closed=True)}"

    def power(self, node: Power, closed: bool) -> str:
        """Write a to the power of b, raised where Unicode can."""
        base, above = node.base, raised(self._tight(node.exponent))
        if isinstance(base, Call) and base.function in CIRCULAR:
            return f"{base.function}{above}{self._argument(base.argument, closed, '')}"
        bracketed = isinstance(base, Call | Apply) and base.function != "abs"
        return (self.bracketed(self.write(base)) if bracketed else self.write(base, ATOM)) + above

    def call(self, node: Call, closed: bool) -> str:
        """Write sin x, √x, |x|, exp(x)."""
        argument = node.argument
        if node.function == "sqrt":
            bare = isinstance(argument, Name) or is_whole(argument)
            return f"√{self.write(argument)}" if bare else f"√({self.write(argument)})"
        if node.function == "abs":
            return f"|{self.write(argument)}|"
        if node.function == "exp":
            return f"exp({self.exponential(node)})"
        if node.function in WORDS:
            return f"{WORDS[node.function]}({self.write(argument)})"
        return node.function + self._argument(argument, closed, " ")

    def _argument(self, node: Formula, closed: bool, space: str) -> str:
        if not closed and _is_plain_product(node):
            return f"{space}{self._tight(node)}"
        return f"({self.write(node)})"

    def apply(self, node: Apply, _: bool) -> str:
        """Write C(n, k), ₂F₁(a, b; c; z), atan2(y, x)."""
        if node.function == "hyp2f1":
            a, b, c, z = map(self._tight, node.arguments)
            return f"₂F₁({a}, {b}; {c}; {z})"
        special = self.applied(node)
        if special is not None:
            return special
        write = self._tight if node.function == "binomial" else self.write
        return (
            f"{self.functions.get(node.function, node.function)}({', '.join(map(write, node.arguments))})"
        )

    def applied(self, node: Apply) -> str | None:
        """Write n!, J₀(z), δ_(m,n), x(π), Mᵗ; None for a function with its name in front."""
        first, last = node.arguments[0], node.arguments[-1]
        printed: str | None = None
        match node.function:
            case "factorial":
                printed = self.write(first, ATOM, closed=True) + "!"
            case "besselj":
                printed = f"J{lowered(self._tight(first))}({self.write(last)})"
            case "kronecker":
                printed = f"δ{lowered(f'{self._tight(first)},{self._tight(last)}')}"
            case "at":
                printed = f"{self.write(first, ATOM)}({self.write(last)})"
            case "transpose":
                printed = self.write(first, ATOM, closed=True) + "ᵗ"
        return printed

    def subscript(self, node: Subscript, _: bool) -> str:
        """Write A₂ₖ."""
        index = self._tight(node.index)
        return self.write(node.base, ATOM) + lowered(index)

    def derivative(self, node: Derivative, _: bool) -> str:
        """Write dx/dθ."""
        order = raised(str(node.order)) if node.order > 1 else ""
        below = f"d{self.write(node.variable)}{order}"
        if isinstance(node.expression, Name):
            return f"d{order}{self.write(node.expression)}/{below}"
        return f"d{order}/{below} {self.bracketed(self.write(node.expression))}"

    def summation(self, node: Summation, closed: bool) -> str:
        """Write Σ(k≥1) body, Σ(k=1…n) body."""
        span = ""
        if node.index is not None:
            index = self.write(node.index)
            lower = "" if node.lower is None else self._tight(node.lower)
            if node.upper is None:
                span = f"({index}={lower})" if lower else f"({index})"
            elif node.upper == INFINITY:
                span = f"({index}≥{lower})"
            else:
                span = f"({index}={lower}…{self._tight(node.upper)})"
        return f"Σ{span} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def indexedproduct(self, node: IndexedProduct, closed: bool) -> str:
        """Write Π(k=1…n) body."""
        span = f"({self.write(node.index)}={self._tight(node.lower)}…{self._tight(node.upper)})"
        return f"Π{span} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def integral(self, node: Integral, _: bool) -> str:
        """Write ∫(0…2π) body dθ."""
        span = ""
        if node.lower is not None and node.upper is not None:
            span = f"({self._tight(node.lower)}…{self._tight(node.upper)})"
        sign = "∮" if node.closed else "∫"
        body = self.write(node.body, PRODUCT_STRENGTH, closed=True)
        return f"{sign}{span} {body} d{self.write(node.variable)}"

    def evaluation(self, node: Evaluation, _: bool) -> str:
        """Write f|(x=b), or [f](x=a…b)."""
        letter, upper = self.write(node.variable), self._tight(node.upper)
        if node.lower is None:
            return f"{self.write(node.expression, ATOM, closed=True)}|({letter}={upper})"
        return f"[{self.write(node.expression)}]({letter}={self._tight(node.lower)}…{upper})"

    def limit(self, node: Limit, closed: bool) -> str:
        """Write lim(x→0) body."""
        point = self._tight(node.point) + {1: "⁺", -1: "⁻"}.get(node.side, "")
        body = self.write(node.body, PRODUCT_STRENGTH, closed)
        return f"lim({self.write(node.variable)}→{point}) {body}"

    def extremum(self, node: Extremum, closed: bool) -> str:
        """Write max(θ) body."""
        over = f"({self.write(node.variable)})" if node.variable.name else ""
        return f"{node.function}{over} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def cases(self, node: Cases, _: bool) -> str:
        """Write {a if x > 0; b else}."""
        parts = []
        for value, condition in zip(node.values, node.conditions, strict=True):
            when = "else"
            if condition is not None:
                left, sign, right = condition
                when = f"if {self.write(left)} {self.relation(sign)} {self.write(right)}"
            parts.append(f"{self.write(value)} {when}")
        return f"{{{'; '.join(parts)}}}"

    def matrix(self, node: Matrix, _: bool) -> str:
        """Write [a, b; c, d]."""
        return f"[{'; '.join(', '.join(map(self.write, row)) for row in node.rows)}]"


WORDS = {"re": "Re", "im": "Im", "conj": "conj", "lg": "lg"}
"""Functions whose name in print is another, always with brackets."""


def _is_plain_product(node: Formula) -> bool:
    """Tell whether a function's argument goes without brackets, as in cos 2kθ."""
    if isinstance(node, Product):
        return not any(_is_applied(factor) for factor in node.factors)
    return isinstance(node, Name)


def _is_applied(node: Formula) -> bool:
    return isinstance(node, Call | Apply) or (isinstance(node, Power) and _is_applied(node.base))


class PlainWriter(TextWriter):
    """Plain text that the reader of hand notes reads back as the same formula."""

    minus = "-"
    names = staticmethod(plain_letter)
    constants = {"pi": "π", "infinity": "∞", "e": "exp(1)", "i": "sqrt(-1)"}  # noqa: RUF012 - a table
    functions = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}  # noqa: RUF012 - a table

    def binding(self, node: Formula) -> int:
        """Return how tightly a formula binds."""
        return strength(node)

    def takes_minus(self, operand: Formula) -> bool:
        """Tell whether a minus may stand before an operand: dots carry no sign when read."""
        return not isinstance(operand, Dots)

    def least_subtracted(self, operand: Formula) -> int:
        """Return how tightly a subtracted term must bind to stand without brackets."""
        return PRODUCT_STRENGTH

    def fraction(self, top: int, bottom: int) -> str:
        """Return a fraction of two numbers."""
        return f"{top}/{bottom}"

    def decimal(self, node: Decimal, _: bool) -> str:
        """Write a decimal as it was given."""
        return node.text

    def constant(self, node: Constant, _: bool) -> str:
        """Write pi, e, i or infinity; only within exp the letter i is the imaginary unit."""
        return "i" if node.name == "i" and self.exponentials else super().constant(node, _)

    def product(self, node: Product, closed: bool) -> str:
        """Write a b c."""
        factors = node.factors
        if len(factors) < 2:
            return self.write(factors[0], 0, closed) if factors else "1"
        printed = self.write(factors[0], QUOTIENT, closed=True)
        for place, factor in enumerate(factors[1:], 1):
            piece = self.write(factor, POWER, closed or place < len(factors) - 1)
            printed += self.between(factors[place - 1], piece, factor) + piece
        return printed

    def between(self, before: Formula, piece: str, after: Formula) -> str:
        """Return a star before digits, nothing between a number and a letter, else a space."""
        if piece[:1].isdecimal() or before == Name("d"):
            return "*"
        simple = isinstance(after, Name) and len(self.names(after.name)) == 1
        simple = simple and after != Name("e") and after != Name("E")
        return "" if is_whole(before) and simple else " "

    def quotient(self, node: Quotient, _: bool) -> str:
        """Write a/b."""
        bottom = node.denominator
        fractional = isinstance(bottom, Number) and self.binding(bottom) < ATOM
        below = f"({self.write(bottom)})" if fractional else self.write(bottom, POWER, closed=True)
        return f"{self.write(node.numerator, PRODUCT_STRENGTH, closed=True)}/{below}"

    def power(self, node: Power, closed: bool) -> str:
        """Write a^b."""
        base, exponent = node.base, node.exponent
        if isinstance(base, Call) and base.function in CIRCULAR and is_whole(exponent):
            return f"{base.function}^{self.write(exponent)}{self._argument(base.argument, closed, ' ')}"
        simple = isinstance(exponent, Name) and len(self.names(exponent.name)) == 1
        above = self.write(exponent) if simple or is_whole(exponent) else f"({self.write(exponent)})"
        return f"{self.write(base, ATOM, closed=True)}^{above}"

    def call(self, node: Call, closed: bool) -> str:
        """Write sin x, sqrt(x), abs(x)."""
        word = self.functions.get(node.function, node.function)
        if node.function == "exp":
            return f"exp({self.exponential(node)})"
        if node.function not in CIRCULAR:
            return f"{WORDS.get(word, word)}({self.write(node.argument)})"
        return word + self._argument(node.argument, closed, " ")

    def _argument(self, node: Formula, closed: bool, space: str) -> str:
        simple = not closed and is_simple_angle(node)
        return f"{space}{self.write(node)}" if simple else f"({self.write(node)})"

    def apply(self, node: Apply, _: bool) -> str:
        """Write f(a, b), n!, x(π)."""
        if node.function == "factorial":
            return f"({self.write(node.arguments[0])})!"
        if node.function == "at":
            return f"{self.write(node.arguments[0], ATOM)}({self.write(node.arguments[1])})"
        return f"{node.function}({', '.join(map(self.write, node.arguments))})"

    def subscript(self, node: Subscript, _: bool) -> str:
        """Write A_{2k}."""
        index = self.write(node.index)
        bare = index.isdecimal() or len(index) == 1
        return f"{self.write(node.base, ATOM)}_{index if bare else f'{{{index}}}'}"

    def derivative(self, node: Derivative, _: bool) -> str:
        """Write dx/dθ, or d/dθ(expression)."""
        order = f"^{node.order}" if node.order > 1 else ""
        variable = self.names(node.variable.name)
        expression = node.expression
        if isinstance(expression, Name) and len(self.names(expression.name)) == 1:
            return f"d{order}{self.names(expression.name)}/d{variable}{order}"
        return f"d{order}/d{variable}{order}({self.write(expression)})"

    def summation(self, node: Summation, closed: bool) -> str:
        """Write Σ_{k=1}^{n} body."""
        bounds = ""
        if node.index is not None:
            lower = f"={self.write(node.lower)}" if node.lower is not None else ""
            bounds = f"_{{{self.names(node.index.name)}{lower}}}"
            bounds += f"^{{{self.write(node.upper)}}}" if node.upper is not None else ""
        return f"Σ{bounds} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def _bounds(self, lower: Formula | None, upper: Formula | None, index: str = "") -> str:
        below = "" if lower is None else f"_{{{index}{self.write(lower)}}}"
        return below + ("" if upper is None else f"^{{{self.write(upper)}}}")

    def indexedproduct(self, node: IndexedProduct, closed: bool) -> str:
        """Write ∏_{k=1}^{n} body."""
        bounds = self._bounds(node.lower, node.upper, f"{self.names(node.index.name)}=")
        return f"∏{bounds} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def integral(self, node: Integral, _: bool) -> str:
        """Write ∫_{a}^{b} (body) dx."""
        sign = "∮" if node.closed else "∫"
        bounds = self._bounds(node.lower, node.upper)
        return f"{sign}{bounds} ({self.write(node.body)}) d{self.names(node.variable.name)}"

    def evaluation(self, node: Evaluation, _: bool) -> str:
        """Write [body]_{x=a}^{b}."""
        letter, expression = self.names(node.variable.name), self.write(node.expression)
        if node.lower is None:
            return f"[{expression}]_{{{letter}={self.write(node.upper)}}}"
        return f"[{expression}]" + self._bounds(node.lower, node.upper, f"{letter}=")

    def limit(self, node: Limit, closed: bool) -> str:
        """Write lim_{x → 0} body."""
        side = {1: "^{+}", -1: "^{-}"}.get(node.side, "")
        point = self.write(node.point, ATOM) if side else self.write(node.point)
        under = f"_{{{self.names(node.variable.name)} → {point}{side}}}"
        return f"lim{under} {self.write(node.body, PRODUCT_STRENGTH, closed)}"

    def extremum(self, node: Extremum, closed: bool) -> str:
        """Write max_{θ} body."""
        under = f"_{{{self.names(node.variable.name)}}}" if node.variable.name else ""
        return f"{node.function}{under} {self.write(node.body, PRODUCT_STRENGTH, closed)}"
