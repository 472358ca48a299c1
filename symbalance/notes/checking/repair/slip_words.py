"""Names of slips as a teacher writes them beside a line: "sign of the second term", "4, not 2"."""

from __future__ import annotations

from fractions import Fraction
from math import prod

from symbalance.document import formula
from symbalance.document.formula import Call, Formula, Negative, Number, Product, Quotient, Sum
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.text import lazy_patterns as re

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")
_MISPRINTED = re.compile(r"number misprinted \((\S+) for (\S+)\)")
_INSTEAD = re.compile(r"(\S+) for (\S+)")
_OF_A_TERM = ("sign", "exponent", "order", "phase")


def slip_words(kind: str, side: Formula, changes: tuple[tuple[Formula, Formula], ...]) -> str:
    """Return what kind of slip a change undoes, in words, with the term of the side that it stands in.

    >>> from symbalance.document.formula import Name
    >>> x, y = Name("x"), Negative(Name("y"))
    >>> slip_words("sign", Sum((x, y)), ((y, y.operand),)), slip_words("cos for sin", x, ((x, y),))
    ('sign of the second term', 'cos, not sin')
    """
    if match := _MISPRINTED.fullmatch(kind) or _INSTEAD.fullmatch(kind):
        return f"{match[1]}, not {match[2]}" if match[1] != "1" else f"{match[2]} is too much"
    (old, new), *others = changes
    if kind == "value" and not formula.names(side):
        return "miscalculated"
    if kind == "factor" and not others:
        factor = _factor(old, new)
        return f"factor {formula_text(factor, plain=True)} is missing" if factor else "a factor"
    return f"{kind}{_place(kind, old, side)}" if kind in _OF_A_TERM and not others else kind


def _place(kind: str, part: Formula, side: Formula) -> str:
    """Return where in a side a slip stands: in an argument, in the second term; "" where it is plain."""
    function = _function_around(part, side) if kind == "sign" else ""
    if function:
        return f" in the argument of {function}"
    term = _term_with(part, side)
    return "" if term is None else f" of the {_ORDINALS[term]} term"


def _function_around(part: Formula, side: Formula) -> str:
    """Return the function whose argument holds a part that is not all of it, "" for none."""
    return next(
        (
            call.function
            for call in formula.walk(side)
            if isinstance(call, Call)
            and call.argument is not part
            and any(each is part for each in formula.walk(call.argument))
        ),
        "",
    )


def _factor(old: Formula, new: Formula) -> Formula | None:
    """Return what a side is multiplied by, where that stands in front of it."""
    if isinstance(new, Product) and len(new.factors) == 2 and new.factors[1] is old:
        return new.factors[0]
    if isinstance(new, Product) and isinstance(old, Product) and new.factors[1:] == old.factors:
        return new.factors[0]
    before, after = _number_in(old), _number_in(new)
    return rational_node(after / before) if before and after and after != before else None


def _number_in(node: Formula) -> Fraction:
    """Return the number that stands in front of a formula: 1/2 in λ m r/(2 r_A)."""
    if isinstance(node, Number):
        return node.value
    if isinstance(node, Negative):
        return -_number_in(node.operand)
    if isinstance(node, Quotient):
        below = _number_in(node.denominator)
        return _number_in(node.numerator) / below if below else Fraction(0)
    return (
        prod(map(_number_in, node.factors), start=Fraction(1))
        if isinstance(node, Product)
        else Fraction(1)
    )


def _term_with(part: Formula, side: Formula) -> int | None:
    """Return which term of a side's sum holds a part; None where it has none, or a long one."""
    total = _sum_in(side)
    if total is None or len(total.terms) > len(_ORDINALS):
        return None
    for k, term in enumerate(total.terms):
        if any(each is part for each in formula.walk(term)):
            return k
    return None


def _sum_in(node: Formula) -> Sum | None:
    """Return the sum that a side is, alone, behind a sign, with a factor or above a bar."""
    if isinstance(node, Sum):
        return node
    if isinstance(node, Negative):
        return _sum_in(node.operand)
    if isinstance(node, Quotient):
        return _sum_in(node.numerator)
    if isinstance(node, Product):
        sums = [each for each in map(_sum_in, node.factors) if each is not None]
        return sums[0] if len(sums) == 1 else None
    return None
