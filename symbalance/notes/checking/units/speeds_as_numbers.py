"""Revolutions per minute put in where radians per second belong: F = m r n² = 0.5·0.04·300² = 1800 N.

A letter with a speed in min⁻¹ may count revolutions per minute, where its formula converts: 2πn/60. In a
formula that does not, whose result has a unit in seconds, it is a quantity; and the number of revolutions
per minute that a page names is no angular speed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from math import pi

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import paired
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.checking.units.formulas_between_numbers import converts
from symbalance.notes.checking.units.own_units import divides_by_minute, is_angular_speed, is_per_minute
from symbalance.notes.reading.equations import Chain, ReadNotes


def put_in_for_angular_speed(
    chain: Chain, k: int, knowledge: Knowledge, speeds: frozenset[int]
) -> Decision | None:
    """Return the refutation of m r ω² = 0.5·0.04·300² on a page with 300 rpm, where ω has no value."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if names(right) or not names(left) or isinstance(right, Number):
        return None
    for part, number in paired(left, right) or ():
        is_speed = isinstance(part, Name) and is_angular_speed(part.name, knowledge.meanings)
        if not is_speed or not isinstance(part, Name) or part.name in knowledge.definitions:
            continue
        if isinstance(number, Number) and number.value in speeds:
            text = formula_text(part, plain=True)
            angular = f"{float(number.value) * pi / 30:.4g}"
            reason = f"{number.value} is the speed per minute: {text} is {angular} rad/s"
            return Decision(REFUTED, reason, witness={"left": angular, "right": str(number.value)})
    return None


def wrong_as_quantity(chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge) -> Decision | None:
    """Return the refutation of a result that no reading of a speed per minute as a quantity gives."""
    right = chain.sides[k + 1]
    left = next((side for side in reversed(chain.sides[: k + 1]) if names(side.node)), None)
    result = quantity_of(right, document)
    if left is None or isinstance(left.node, Name) or result is None or _counts_minutes(result.unit):
        return None
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {*names_behind(left.node, values)}
    if any(
        _converts(node)
        for node in (left.node, *(values[n] for n in behind if n in values and names(values[n])))
    ):
        return None
    speeds = [name for name in sorted(behind & values.keys()) if _is_per_minute(values[name], document)]
    decisions = [
        decide(left, right, chain.relations[k].sign, known) for known in _as_quantities(speeds, knowledge)
    ]
    if not decisions or any(decision.status != REFUTED for decision in decisions):
        return None
    if any(decision.left is not None and letters(decision.left) for decision in decisions):
        return None  # a letter without a number may be anything
    text = formula_text(Name(speeds[0]), plain=True)
    return replace(decisions[0], reason=f"{text} is in revolutions per minute, and nothing converts it")


def without_minutes(chain: Chain, k: int, document: ReadNotes) -> Chain | None:
    """Return a chain with a speed in revolutions per minute as the number typed; None for other sides."""
    right = chain.sides[k + 1]
    node = right.node
    if not isinstance(node, Product) or len(node.factors) != 2:
        return None
    number, unit = node.factors
    is_speed = isinstance(number, Number) and not names(unit) and number.span is not None
    if not is_speed or not is_per_minute(document.text, number.span[1]):
        return None
    bare = replace(right, readings=(number,))
    return replace(chain, sides=(*chain.sides[: k + 1], bare, *chain.sides[k + 2 :]))


def _converts(node: Formula) -> bool:
    return divides_by_minute(node) or converts(node)


def _counts_minutes(unit: str) -> bool:
    return "min" in unit or unit in ("rpm", "h", "km/h", "mph")


def _is_per_minute(node: Formula, document: ReadNotes) -> bool:
    return isinstance(node, Number) and is_per_minute(document.text, node.span[1])


def _as_quantities(speeds: list[str], knowledge: Knowledge) -> Iterator[Knowledge]:
    """Yield what is known with the speeds in revolutions per second, and in radians per second."""
    turn = Quotient(Constant("pi"), Number(Fraction(30)))
    for factor in (Number(Fraction(1, 60)), turn) if speeds else ():
        definitions: dict[str, Definition] = dict(knowledge.definitions)
        for name in speeds:
            node = definitions[name].node
            definitions[name] = replace(definitions[name], node=Product((node, factor), span=node.span))
        yield replace(knowledge, definitions=definitions)
