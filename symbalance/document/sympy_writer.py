"""Formulas as SymPy expressions, for whoever wants to calculate with them."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

from symbalance.document.formula import (
    INFINITY,
    Apply,
    Call,
    Cases,
    Constant,
    Decimal,
    Derivative,
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
    Power,
    Product,
    Quotient,
    Subscript,
    Sum,
    Summation,
)
from symbalance.document.symbols import MEANINGS, symbol
from symbalance.document.text_writer import formula_text
from symbalance.errors import SymbalanceError


def formula_sympy(formula: Formula | Equation) -> Any:
    """Return a formula as a SymPy expression, an equation `left = right` as an `Eq`.

    Letters of `symbols` are those very symbols, others plain ones. SymPy orders and simplifies as it
    does; cosines and sines of parts of pi stay as they are. What has no value is refused: dots, words.

    >>> from symbalance.document.formula import Name, number, sqrt
    >>> formula_sympy((1 + sqrt(5)) / number(2) * Name("lam") ** 2)
    lam**2*(1/2 + sqrt(5)/2)
    """
    import sympy

    if isinstance(formula, Equation):
        if len(formula.links) != 1 or formula.links[0][0] != "=":
            raise SymbalanceError(
                formula_text(formula), "must be one equality", "give its sides one by one"
            )
        return sympy.Eq(formula_sympy(formula.left), formula_sympy(formula.links[0][1]), evaluate=False)
    writer = _writers().get(type(formula))
    if writer is None:
        what = formula_text(formula)
        raise SymbalanceError(what, "has no value in SymPy", "give a formula without dots and words")
    return writer(formula)


@cache
def _writers() -> dict[type[Formula], Callable[[Any], Any]]:
    """Return for each class of formula the function that writes it."""
    import sympy

    of = formula_sympy
    constants = {"pi": sympy.pi, "e": sympy.E, "i": sympy.I, "infinity": sympy.oo}

    def rational(value: Fraction) -> Any:
        return sympy.Rational(value.numerator, value.denominator)

    def name(node: Name) -> Any:
        return symbol(node.name) if node.name in MEANINGS else sympy.Symbol(node.name)

    def call(node: Call) -> Any:
        argument = of(node.argument)
        if node.function == "lg":
            return sympy.log(argument, 10)
        own_names = {"abs": "Abs", "ln": "log", "conj": "conjugate"}
        function = getattr(sympy, own_names.get(node.function, node.function))
        if node.function in ("sin", "cos") and argument.has(sympy.pi) and not argument.free_symbols:
            # SymPy multiplies some of these out into long radicals, and takes its time.
            return function(argument, evaluate=False)
        return function(argument)

    def apply(node: Apply) -> Any:
        arguments = [of(argument) for argument in node.arguments]
        if node.function == "hyp2f1":
            a, b, c, z = arguments
            return sympy.hyper((a, b), (c,), z)
        if node.function == "atan2":
            return sympy.atan2(*arguments, evaluate=False)
        known = {
            "binomial": sympy.binomial,
            "factorial": sympy.factorial,
            "besselj": sympy.besselj,
            "kronecker": sympy.KroneckerDelta,
            "max": sympy.Max,
            "min": sympy.Min,
            "transpose": sympy.transpose,
            "det": sympy.det,
        }
        return known.get(node.function, sympy.Function(node.function))(*arguments)

    def subscript(node: Subscript) -> Any:
        return sympy.Indexed(sympy.IndexedBase(of(node.base)), of(node.index))

    def derivative(node: Derivative) -> Any:
        variable = of(node.variable)
        inside = of(node.expression)
        if isinstance(node.expression, Name):  # the derivative of a letter by another is not zero
            inside = sympy.Function(node.expression.name)(variable)
        return sympy.Derivative(inside, (variable, node.order))

    def summation(node: Summation) -> Any:
        if node.index is None or node.lower is None or node.upper is None:
            raise SymbalanceError(
                formula_text(node), "has no bounds", "write where the sum begins and ends"
            )
        return sympy.Sum(of(node.body), (of(node.index), of(node.lower), of(node.upper)))

    def product_sign(node: IndexedProduct) -> Any:
        return sympy.Product(of(node.body), (of(node.index), of(node.lower), of(node.upper)))

    def integral(node: Integral) -> Any:
        if node.lower is None or node.upper is None:
            if node.closed:
                raise SymbalanceError(formula_text(node), "has no bounds", "write them: ∫ from 0 to 2π")
            return sympy.Integral(of(node.body), of(node.variable))
        return sympy.Integral(of(node.body), (of(node.variable), of(node.lower), of(node.upper)))

    def evaluation(node: Evaluation) -> Any:
        body, variable = of(node.expression), of(node.variable)
        upper = sympy.Subs(body, variable, of(node.upper))
        return upper if node.lower is None else upper - sympy.Subs(body, variable, of(node.lower))

    def limit(node: Limit) -> Any:
        side = {1: "+", -1: "-"}.get(node.side, "+-")
        if node.point == INFINITY:
            side = "-"
        return sympy.Limit(of(node.body), of(node.variable), of(node.point), side)

    def extremum(node: Extremum) -> Any:
        if not node.variable.name:
            raise SymbalanceError(formula_text(node), "names no variable", "write max over θ")
        function = sympy.Function(node.function)
        return function(of(node.body), of(node.variable))

    relations = {"=": sympy.Eq, "≠": sympy.Ne, "<": sympy.Lt, ">": sympy.Gt, "≤": sympy.Le, "≥": sympy.Ge}

    def cases(node: Cases) -> Any:
        pairs = []
        for value, condition in zip(node.values, node.conditions, strict=True):
            when: Any = True
            if condition is not None:
                when = relations[condition[1]](of(condition[0]), of(condition[2]))
            pairs.append((of(value), when))
        return sympy.Piecewise(*pairs)

    return {
        Number: lambda node: rational(node.value),
        Decimal: lambda node: sympy.Float(node.text),
        Name: name,
        Constant: lambda node: constants[node.name],
        Sum: lambda node: sympy.Add(*map(of, node.terms)),
        Product: lambda node: sympy.Mul(*map(of, node.factors)),
        Quotient: lambda node: of(node.numerator) / of(node.denominator),
        Power: lambda node: of(node.base) ** of(node.exponent),
        Negative: lambda node: -of(node.operand),
        Call: call,
        Apply: apply,
        Subscript: subscript,
        Derivative: derivative,
        Summation: summation,
        IndexedProduct: product_sign,
        Integral: integral,
        Evaluation: evaluation,
        Limit: limit,
        Extremum: extremum,
        Cases: cases,
        Matrix: lambda node: sympy.Matrix([[of(entry) for entry in row] for row in node.rows]),
    }
