"""Equality of two SymPy expressions, decided as the equations of hand derivations are."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import Call, Constant, Formula, Name, Number, Power, Product, Sum
from symbalance.document.text_writer import formula_text
from symbalance.errors import SymbalanceError, brief
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.repair.fixes import add_fix
from symbalance.notes.checking.steps.judging_state import read_assumption
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import Chain, ReadNotes, Relation, Side

_FUNCTIONS = {
    "sin": "sin", "cos": "cos", "tan": "tan", "cot": "cot", "sec": "sec", "csc": "csc",
    "asin": "asin", "acos": "acos", "atan": "atan", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh",
    "exp": "exp", "log": "ln", "Abs": "abs",
}  # fmt: skip


def check_equal(
    lhs: Any,
    rhs: Any,
    *,
    assuming: Iterable[str] = (),
    approximately: bool = False,
    through: int | None = None,
) -> Verdict:
    """Return the verdict on lhs = rhs, two SymPy expressions (or numbers).

    Decided by normal form, not by `simplify`; what has none is decided by numbers at random exact points:
    refuted with a witness, or undecided. SymPy's assumptions `positive` and `integer` on symbols count.
    `assuming` lists equalities such as "alpha = pi/6": a verdict that needs one is `conditional`.
    `approximately` compares through the order the right side keeps; `through` states that order.

        >>> import sympy as sp
        >>> x = sp.Symbol("x")
        >>> check_equal(sp.sin(x) ** 2, (1 - sp.cos(2 * x)) / 2).verdict
        'holds'
        >>> verdict = check_equal(sp.sin(x) ** 2, (1 + sp.cos(2 * x)) / 2)
        >>> verdict.verdict, verdict.fix.kind
        ('refuted', 'sign')

    Raises SymbalanceError for what is no SymPy expression, or holds a function not known here.
    """
    import sympy

    if isinstance(assuming, str):
        assuming = (assuming,)
    try:
        left, right = sympy.sympify(lhs, strict=True), sympy.sympify(rhs, strict=True)
    except (sympy.SympifyError, TypeError):
        raise SymbalanceError(
            f"check_equal({brief(lhs)}, {brief(rhs)})", "takes SymPy expressions", "use sympy.Symbol"
        ) from None
    symbols = {str(s): s for s in (left.free_symbols | right.free_symbols)}
    knowledge = _knowledge(symbols, assuming)
    if approximately:  # whoever asks so knows which letter is small
        knowledge = replace(knowledge, small=knowledge.declared)
    first, second = Side((node_of(left),), (0, 0)), Side((node_of(right),), (0, 0))
    sign = "≈" if approximately else "="
    decision = decide(first, second, sign, knowledge, through)
    text = f"{formula_text(first.node, plain=True)} {sign} {formula_text(second.node, plain=True)}"
    document = ReadNotes("expression", text, (), ())
    second = Side(second.readings, (len(text) - len(formula_text(second.node, plain=True)), len(text)))
    chain = Chain((first, second), (Relation(sign, 1),), (1,))
    verdict = describe(document, chain, 0, decision)
    verdict = add_fix(
        verdict,
        document,
        second,
        decision,
        knowledge,
        lambda node: decide(first, Side((node,), (0, 0)), sign, knowledge, through).is_proved,
    )
    # Nothing was read, so a correction has no line and column.
    fix = verdict.fix and replace(verdict.fix, faults=())
    return replace(verdict, source=text, fix=fix)


def _knowledge(symbols: Mapping[str, Any], assuming: Iterable[str]) -> Knowledge:
    positive = frozenset(name for name, s in symbols.items() if s.is_positive)
    integer = frozenset(name for name, s in symbols.items() if s.is_integer)
    letters = frozenset(symbols)
    assumptions = tuple(read_assumption(text, letters, "assuming") for text in assuming)
    return Knowledge(SymbolValue(positive=positive, integer=integer), None, {}, assumptions, letters)


def node_of(expression: Any) -> Formula:
    """Return a SymPy expression as a formula's tree."""
    for applies, convert in _RULES:
        if applies(expression):
            return convert(expression)
    name = _FUNCTIONS.get(type(expression).__name__)
    if name and len(expression.args) == 1:
        return Call(name, node_of(expression.args[0]))
    raise SymbalanceError(
        brief(expression),
        f"holds {type(expression).__name__}, which is not known here",
        "use sums, products, powers and circular functions",
    )


def _parts(expression: Any) -> tuple[Formula, ...]:
    return tuple(node_of(part) for part in expression.args)


_CONSTANTS = {"Pi": "pi", "Exp1": "e", "ImaginaryUnit": "i"}
_RULES: tuple[tuple[Callable[[Any], bool], Callable[[Any], Formula]], ...] = (
    (lambda x: x.is_Rational, lambda x: Number(Fraction(int(x.p), int(x.q)))),
    (lambda x: x.is_Float, lambda x: Number(Fraction(str(x)), Fraction(1, 10**15))),
    (lambda x: x.is_Symbol, lambda x: Name(str(x))),
    (lambda x: type(x).__name__ in _CONSTANTS, lambda x: Constant(_CONSTANTS[type(x).__name__])),
    (lambda x: x.is_Add, lambda x: Sum(_parts(x))),
    (lambda x: x.is_Mul, lambda x: Product(_parts(x))),
    (lambda x: x.is_Pow, lambda x: Power(*_parts(x))),
)
