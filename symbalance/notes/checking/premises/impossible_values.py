"""Values that a letter cannot have: a division by zero, a negative length, an integer that is 1/2."""

from __future__ import annotations

from typing import Any

from symbalance.document.formula import Derivative, Formula, Matrix, Name, Number, Sum, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.values import context, letters, sample
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.inequalities import compare
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.verdicts import CONTRADICTION
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.text import lazy_patterns as re

WHOLE = 1e-15
"""Difference from an integer, or from 0, that is one of computing: numbers have more digits than that."""

_TWO_INDICES = re.compile(r"delta_\{?([A-Za-z0-9])([A-Za-z0-9])\}?$")


def refuse_value(name: str, value: Formula, knowledge: Knowledge) -> Decision | None:
    """Return why a first value is none: it has no value, or looks like a slip of the pen."""
    by_name = _refuse_by_name(name, value, knowledge)
    if by_name is not None:
        return by_name
    if isinstance(value, Sum):
        terms = [t for t in value.terms if names(t)]
        double = next((t for n, t in enumerate(terms) if isinstance(t, Name) and t in terms[:n]), None)
        if double is not None and double.name[-1:].isdecimal():
            letter = plain_text(double)
            reason = f"{letter} stands twice in the sum: another letter is meant, or 2 {letter}"
            return Decision(UNDECIDED, reason)
    if has_no_value(value, knowledge):
        return Decision(UNDECIDED, "the right side has no value")
    if name in ("e", "pi", "i") and name not in knowledge.letters and not names(value):
        return Decision(
            UNDECIDED, f"{plain_text(Name(name))} is a number of its own, unless it is declared"
        )
    return None


def _refuse_by_name(name: str, value: Formula, knowledge: Knowledge) -> Decision | None:
    """Return why a value does not suit how its letter is written: δ_nn = 0, S = Sᵀ, y' after y = x²."""
    text = plain_text(Name(name))
    indices = _TWO_INDICES.match(name)
    if indices and name not in knowledge.letters and isinstance(value, Number):
        if indices[1] == indices[2] and value.value == 0:
            return Decision(UNDECIDED, f"{text} is 1 if it is Kronecker's; if not, declare it")
        if indices[1] != indices[2] and value.value == 1:
            return Decision(
                UNDECIDED, f"{text} is 1 for equal indices only; if it is a letter, declare it"
            )
    if name in knowledge.meaning.kinds.symmetric and isinstance(value, Matrix):
        for i, row in enumerate(value.rows):
            for j, entry in enumerate(row[:i]):
                mirrored = value.rows[j][i] if i < len(value.rows[j]) else entry
                if decide(lone_side(entry), lone_side(mirrored), "=", knowledge).status == REFUTED:
                    reason = (
                        f"{text} is declared symmetric, entries ({i + 1}, {j + 1}) and mirrored differ"
                    )
                    return Decision(CONTRADICTION, reason)
    bare = name.rstrip("'")
    base = knowledge.definitions.get(bare)
    if bare != name and name not in knowledge.letters and base is not None and len(names(base.node)) == 1:
        (variable,) = names(base.node)
        given = knowledge.definitions.get(variable)
        if given is not None and not names(given.node) and not names(value):
            return None  # σ_W' beside σ_W = 0.45 R_m: of R_m = 900 MPa nothing is a derivative
        slope = Derivative(base.node, Name(variable), len(name) - len(bare))
        if decide(lone_side(slope), lone_side(value), "=", knowledge).status == REFUTED:
            reason = f"not the derivative of {bare} by {plain_text(Name(variable))}"
            return Decision(UNDECIDED, f"{reason}; if {text} is another letter, declare it")
    return None


def has_no_value(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula is a division by zero, infinite, or a number outside a function's range."""
    if is_of_matrices(node, node, knowledge):
        return False
    level = list(knowledge.levels(node))[-1]
    evaluator = knowledge.evaluator(level)
    try:
        form = evaluator.form(node)
    except NoFormError as problem:
        return str(problem) in ("a division by zero", "infinity")
    except TooLargeError:
        return False
    if letters(form):
        return False
    points = sample([form], 1)
    return not points or not context().isfinite(points[0][1][0])


def outside_meaning(
    name: str, value: Formula, knowledge: Knowledge, *, is_result: bool
) -> Decision | None:
    """Return the contradiction between a letter's value and its meaning: an integer that is 1/2.

    What is positive by its meaning may be taken as 0, a rod ratio of an endless rod; but 0 is no way to
    write a crank radius (`is_result`: the letter stands behind what gives it its value).
    """
    is_positive, is_whole = name in knowledge.meaning.positive, name in knowledge.meaning.integer
    number = number_of(value, knowledge) if is_positive or is_whole else None
    if number is None:
        return None
    text = "0" if abs(number) < WHOLE else context().nstr(number, 6)
    if is_whole and abs(number - context().nint(number)) > WHOLE:
        return Decision(CONTRADICTION, f"{plain_text(Name(name))} is declared an integer, not {text}")
    may_be_zero = not is_result and role_of(knowledge.meanings.get(name, "")) != "positive"
    if is_positive and (number < -WHOLE or (text == "0" and not may_be_zero)):
        return Decision(CONTRADICTION, f"{plain_text(Name(name))} is positive by its meaning, not {text}")
    return None


def number_of(value: Formula, knowledge: Knowledge) -> Any:
    """Return the real number that a formula comes down to by all that is known, None for none."""
    level = list(knowledge.levels(value))[-1]
    try:
        form = knowledge.evaluator(level).form(value)
    except (NoFormError, TooLargeError):
        return None
    if letters(form):
        return None
    points = sample([form], 1)
    if not points or not context().isfinite(points[0][1][0]):
        return None
    number = points[0][1][0]
    return number.real if abs(number.imag) < WHOLE else None


def outside_range(
    definitions: Definitions, name: str, value: Formula, line: int, knowledge: Knowledge
) -> Decision | None:
    """Return the contradiction between a letter's value and a range stated before."""
    with_value = knowledge.with_definition(name, Definition(value, line, not names(value)))
    for stated in definitions.ranges_at(line):
        if name in names(stated.left) | names(stated.right) and not stated.is_only_if:
            decision = compare(stated.left, stated.right, stated.sign, with_value)
            if decision is not None and decision.status == REFUTED:
                reason = f"contradicts {stated.text} of line {stated.line}"
                return Decision(CONTRADICTION, reason, witness=decision.witness)
    return None
