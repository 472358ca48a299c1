"""Formulas for the tests of the algebra: trees from short texts, random trees, values by mpmath alone.

`tree` reads Python's own syntax, so nothing of `symbalance.notes.reading` but its nodes is involved;
`value` is a textbook recursion over the tree with mpmath's functions, derivatives being numerical.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import hypothesis.strategies as st
from mpmath import mp

from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Dots,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
)
from symbalance.notes.algebra.domain import Domain
from symbalance.notes.algebra.evaluation import FormEvaluator, Meaning
from symbalance.notes.algebra.forms import Form

POSITIVE = frozenset("a b c lambda rho".split())  # noqa: SIM905
INTEGER = frozenset("n k".split())  # noqa: SIM905
MEANING = Meaning(positive=POSITIVE, integer=INTEGER)
Point = Mapping[str, Fraction]

POINT: dict[str, Fraction] = {
    "a": Fraction(17, 10),
    "b": Fraction(3, 5),
    "c": Fraction(29, 10),
    "lambda": Fraction(41, 10),
    "rho": Fraction(27, 100),
    "x": Fraction(7, 13),
    "y": Fraction(-5, 7),
    "theta": Fraction(83, 70),
    "phi": Fraction(-37, 90),
    "beta": Fraction(31, 100),
    "n": Fraction(3),
}


def points(count: int) -> list[dict[str, Fraction]]:
    """Return points near POINT, n a different whole number in each."""
    return [
        {
            name: Fraction(2 + i) if name == "n" else number * (1 + Fraction(i * (7 + place), 211))
            for place, (name, number) in enumerate(POINT.items())
        }
        for i in range(count)
    ]


# Trees from texts ---------------------------------------------------------------------------------


def tree(text: str) -> Formula:
    """Return the tree of a Python expression; `diff(f, x, n)` and `sum(f, k, 1, 4)` are known too."""
    return _read(ast.parse(text.replace("lambda", "lambda_"), mode="eval").body)


def _read(node: ast.expr) -> Formula:
    match node:
        case ast.Constant(value=int(number)):
            return Number(Fraction(number))
        case ast.Name(id=name):
            return Constant(name) if name in ("pi", "e", "i") else Name(name.rstrip("_"))
        case ast.UnaryOp(operand=operand):
            return Negative(_read(operand))
        case ast.BinOp(left=left, op=op, right=right):
            return _joined(op, _read(left), _read(right))
        case ast.Call(func=ast.Name(id="diff"), args=[body, by, ast.Constant(value=int(order))]):
            variable = _read(by)
            assert isinstance(variable, Name)
            return Derivative(_read(body), variable, order)
        case ast.Call(func=ast.Name(id="sum"), args=[body, by, lower, upper]):
            index = _read(by)
            assert isinstance(index, Name)
            return Summation(_read(body), index, _read(lower), _read(upper))
        case ast.Call(func=ast.Name(id=function), args=[argument]):
            return Call(function, _read(argument))
    raise ValueError(ast.dump(node))


def _joined(op: ast.operator, left: Formula, right: Formula) -> Formula:
    match op:
        case ast.Add():
            return Sum((left, right))
        case ast.Sub():
            return Sum((left, Negative(right)))
        case ast.Mult():
            return Product((left, right))
        case ast.Div():
            return Quotient(left, right)
        case _:
            return Power(left, right)


def forms(*trees: Formula | str) -> list[Form]:
    """Return the forms of trees, or of their texts, in one fresh domain."""
    evaluator = FormEvaluator(Domain(POSITIVE, INTEGER), MEANING)
    return [evaluator.form(tree(t) if isinstance(t, str) else t) for t in trees]


# Values -------------------------------------------------------------------------------------------


def number(exact: Fraction) -> Any:
    return mp.mpf(exact.numerator) / exact.denominator


def value(node: Formula, at: Mapping[str, Any]) -> Any:
    """Return the value at a point of mpmath numbers, principal values throughout."""
    match node:
        case Number(value=exact):
            return number(exact)
        case Name(name=name):
            return at[name]
        case Constant(name=name):
            return mp.mpc(0, 1) if name == "i" else +getattr(mp, name)
        case Sum(terms=terms):
            return mp.fsum(value(t, at) for t in terms if not isinstance(t, Dots))
        case Product(factors=factors):
            return mp.fprod(value(f, at) for f in factors)
        case Quotient(numerator=above, denominator=below):
            return value(above, at) / value(below, at)
        case Power(base=base, exponent=exponent):
            return value(base, at) ** value(exponent, at)
        case Negative(operand=operand):
            return -value(operand, at)
        case Call(function="abs", argument=argument):
            return abs(value(argument, at))
        case Call(function=function, argument=argument):
            return getattr(mp, function)(value(argument, at))
        case Derivative(expression=inner, variable=variable, order=order):
            return mp.diff(lambda x: value(inner, {**at, variable.name: x}), at[variable.name], order)
        case Summation(body=body, index=index, lower=lower, upper=upper):
            assert index is not None
            assert lower is not None
            assert upper is not None
            places = range(int(value(lower, at)), int(value(upper, at)) + 1)
            return mp.fsum(value(body, {**at, index.name: mp.mpf(k)}) for k in places)
    raise ValueError(node)


def at_point(node: Formula | str, point: Point, digits: int = 60) -> Any:
    """Return the value of a tree, or of its text, at a point of fractions."""
    with mp.workdps(digits + 20):
        exact = {name: number(q) for name, q in point.items()}
        return value(tree(node) if isinstance(node, str) else node, exact)


def close(found: Any, expected: Any, digits: int = 22) -> bool:
    """Tell whether two values agree, the larger of 1 and their size being the measure."""
    with mp.workdps(80):
        size = max(1, abs(expected))
        return bool(abs(mp.mpmathify(found) - expected) < size * mp.mpf(10) ** -digits)


# Random trees -------------------------------------------------------------------------------------


def _call(function: str, argument: Formula) -> Formula:
    return Call(function, argument)


def _number(n: int, d: int = 1) -> Formula:
    if n < 0:
        return Negative(_number(-n, d))
    return Number(Fraction(n)) if d == 1 else Quotient(Number(Fraction(n)), Number(Fraction(d)))


def _times(factor: Formula, of: Formula) -> Formula:
    return Product((factor, of))


rationals = st.builds(_number, st.integers(-6, 6).filter(bool), st.sampled_from([1, 1, 2, 3, 4]))
surds = st.sampled_from([2, 3, 5, 6, 7, 12]).map(lambda d: Call("sqrt", _number(d)))
lengths = st.sampled_from(sorted(POSITIVE)).map(Name)
letters = st.sampled_from([*sorted(POSITIVE), "x", "y"]).map(Name)
halves = st.builds(_number, st.integers(-5, 5).filter(bool), st.sampled_from([1, 1, 2]))
turns = st.builds(
    lambda n, d: _times(_number(n, d), Constant("pi")),
    st.integers(-11, 11),
    st.sampled_from([2, 3, 4, 5, 6]),
)
plain_angles = st.one_of(
    st.sampled_from(["theta", "phi"]).map(Name),
    st.builds(lambda c, name: _times(c, Name(name)), halves, st.sampled_from(["theta", "phi"])),
    turns,
)
waves = st.builds(_call, st.sampled_from(["sin", "cos"]), plain_angles)
fractions_of_one = st.builds(
    lambda above, below: Quotient(above, Sum((_number(2), below))),
    waves,
    st.sampled_from([*"abc"]).map(Name),
)
leaning = st.builds(_call, st.sampled_from(["asin", "acos", "atan"]), fractions_of_one)
leaning_angles = st.one_of(leaning, st.builds(_times, st.sampled_from([2, 3, -1]).map(_number), leaning))
angles = st.one_of(
    plain_angles,
    st.builds(lambda a, b: Sum((a, b)), plain_angles, plain_angles),
    st.builds(lambda a, b: Sum((a, Negative(b))), plain_angles, leaning_angles),
)
circular = st.builds(_call, st.sampled_from(["sin", "cos", "cos", "tan", "sec"]), angles)
decays = st.builds(lambda f, x: Call(f, Negative(x)), st.sampled_from(["exp", "sinh", "cosh"]), letters)
leaves = st.one_of(rationals, surds, letters, letters, waves, circular, decays)


def _square_and(part: Formula, positive: Formula) -> Formula:
    """A radicand that is positive whatever the part: part² + positive."""
    return Sum((Power(part, _number(2)), positive))


def _larger(parts: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    several = st.lists(parts, min_size=2, max_size=3).map(tuple)
    powers = st.integers(-3, 4).map(_number)
    index = st.sampled_from([1, 2, 3]).map(_number)
    return st.one_of(
        several.map(Sum),
        several.map(Product),
        st.builds(Quotient, parts, parts),
        st.builds(Power, parts, powers),
        parts.map(Negative),
        st.builds(lambda p, a: Call("sqrt", _square_and(p, a)), parts, lengths),
        st.builds(lambda a, b: Call("sqrt", _times(Power(a, _number(2)), b)), lengths, lengths),
        st.builds(
            lambda p, c, k: Summation(_times(c, Power(p, Name("k"))), Name("k"), _number(0), k),
            parts,
            rationals,
            index,
        ),
        st.builds(
            lambda p, c: Summation(
                _times(p, Call("cos", _times(Name("k"), c))), Name("k"), _number(1), _number(3)
            ),
            parts,
            plain_angles,
        ),
    )


trees = st.recursive(leaves, _larger, max_leaves=6)
"""Random formulas, real at every point where a, b, c, λ and ρ are positive."""
