"""Slips inside cos and sin: a phase not multiplied by the order, another order, another multiple of π."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from symbalance.document.formula import Call, Constant, Formula, Name, Negative, Number, Product, Sum
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import Evaluator
from symbalance.notes.algebra.numbers import rational_node
from symbalance.notes.checking.repair.change import Edit


def phases(part: Formula) -> Iterator[Edit]:
    """A phase inside cos(nθ - φ) that was not multiplied by n, or was."""
    if not (
        isinstance(part, Call) and isinstance(part.argument, Sum) and part.function in ("sin", "cos")
    ):
        return
    multiple = _multiple(part.argument.terms[0])
    for term in part.argument.terms[1:]:
        for factor in dict.fromkeys(
            [
                multiple,
                1 / multiple if multiple else None,
                Fraction(2),
                Fraction(1, 2),
                Fraction(3),
                Fraction(4),
            ]
        ):
            if factor and factor != 1:
                times = f"times the order {multiple}" if factor == multiple else f"times {factor}"
                yield Edit(
                    f"phase not multiplied ({times})",
                    1.0 if factor == multiple else 1.15,
                    term,
                    _times(factor, term),
                )


def _multiple(term: Formula) -> Fraction | None:
    factors = term.factors if isinstance(term, Product) else (term,)
    found = [f.value for f in factors if isinstance(f, Number)]
    return found[0] if found else None


def _times(factor: Fraction, term: Formula) -> Formula:
    """Return factor times a phase, as one fraction of π where it is one.

    >>> from symbalance.document.text_writer import formula_text
    >>> from symbalance.document.formula import Quotient
    >>> third = Quotient(rational_node(Fraction(1)), rational_node(Fraction(3)))
    >>> formula_text(_times(Fraction(6), Product((third, Constant("pi")))), plain=True)
    '2 π'
    """
    evaluator = Evaluator(Domain())
    try:
        of_pi = evaluator.form(term).over(evaluator.form(Constant("pi"))).rational()
    except (NoFormError, TooLargeError):
        of_pi = None
    if of_pi:
        phase = Product((rational_node(abs(of_pi * factor)), Constant("pi")))
        return Negative(phase) if of_pi * factor < 0 else phase
    if isinstance(term, Negative):
        return Negative(_times(factor, term.operand))
    return Product((rational_node(factor), term))


def multiples(part: Formula, role: str) -> Iterator[Edit]:
    """The order inside cos nθ: another whole number."""
    kind = "phase" if role == "phase" else "order"
    if role in ("argument", "angle term", "phase"):
        if isinstance(part, Number) and part.value.denominator == 1 and part.last_place is None:
            for value in range(1, 13):
                if value != part.value:
                    yield Edit(
                        kind,
                        1.1 + abs(value - float(part.value)) / 100,
                        part,
                        rational_node(Fraction(value)),
                    )
        elif isinstance(part, Name):
            for value in (2, 3, 4, 6):
                yield Edit(
                    "order", 1.15 + value / 100, part, Product((rational_node(Fraction(value)), part))
                )
        elif isinstance(part, Constant) and part.name == "pi":
            for factor in (Fraction(2), Fraction(1, 2)):
                yield Edit("phase", 1.3, part, Product((rational_node(factor), part)))
