"""Sides without a value where a page says that a relation holds: Σ xⁿ = 1/(1 - x) for x > 1.

Series are compared term by term, and fractions cancelled; neither asks whether there is a value at all.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Call, Constant, Formula, Name, Number, Summation, names, walk
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.letters_behind import letters_behind
from symbalance.notes.algebra.sums import at_index, indexed_letters
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.denied_conditions import WIDEST
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision, printed_decimal
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, sample_ranges
from symbalance.notes.checking.deciding.infinite_series import has_infinite_sum, is_infinite
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.satisfiability import sign_at
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading.equations import Side

TRIES = 24
"""Points drawn at random within the ranges that a page states."""
EARLY, LATE = 40, 80
"""Terms of a sum without end that are compared: a sum has a value only if they become small."""
_DOMAINS = {"ln": (0, None), "log": (0, None), "lg": (0, None), "asin": (-1, 1), "acos": (-1, 1)}
"""Between which numbers a function has a real value."""
SMALL = Fraction(1, 1000)
"""Below which a term is on its way to 0; what grows from one place to the other is not."""


def decide_where_values(
    left: Side,
    right: Side,
    decision: Decision,
    knowledge: Knowledge,
    general: Collection[str],
    places: Collection[tuple[str, Formula]],
) -> Decision:
    """Return the refutation of what is proved where a side has no value; else the decision.

    `general` are the letters of all of whose values it is said, `places` the values it is said for.
    """
    if not decision.is_proved:
        return decision
    nodes = (left.node, right.node)
    level = list(knowledge.levels(*nodes))[-1]
    values = {name: value for name, value in level.values.items() if name not in general}
    meaning = replace(knowledge.meaning, values=values)
    if (text := _without_real_value(nodes, meaning)) is not None:
        return replace(decision, status=UNDECIDED, assumptions=(), reason=f"{text} has no real value")
    for name, value in places:
        there = replace(meaning, values={**values, name: value})
        if names(left.node) | names(right.node) == {name} and _has_one_value(nodes, there):
            text = f"{formula_text(Name(name), plain=True)} = {formula_text(value, plain=True)}"
            return replace(decision, status=REFUTED, assumptions=(), reason=f"no value for {text}")
    return _where_it_converges(nodes, decision, knowledge, meaning, {*general})


def _without_real_value(nodes: tuple[Formula, Formula], meaning: SymbolValue) -> str | None:
    """Return a logarithm of a number below zero, an arc sine beyond one; None where none stands.

    Two that are written alike are no equal numbers. Beside the unit i they may be complex ones.
    """
    parts = [part for node in nodes for part in walk(node)]
    if any(isinstance(part, Constant) and part.name == "i" for part in parts):
        return None
    for part in parts:
        least, largest = (
            _DOMAINS.get(part.function, (None, None)) if isinstance(part, Call) else (None, None)
        )
        if least is None or not isinstance(part, Call) or letters_behind(part.argument, meaning.values):
            continue
        points = sample_trees([part.argument], meaning, 1, tries=1)
        number = points[0][1][0].real if points else None
        if number is not None and (number < least or (largest is not None and number > largest)):
            return formula_text(part, plain=True)
    return None


def _has_one_value(nodes: tuple[Formula, Formula], meaning: SymbolValue) -> bool:
    """Tell whether one of two sides has a value and the other has none."""
    have = [bool(sample_trees([node], meaning, 1, tries=1)) for node in nodes]
    return have[0] != have[1]


def _where_it_converges(
    nodes: tuple[Formula, Formula],
    decision: Decision,
    knowledge: Knowledge,
    meaning: SymbolValue,
    general: set[str],
) -> Decision:
    """Return the refutation of a sum without end whose terms do not become small in the ranges."""
    own = names(nodes[0]) | names(nodes[1])
    stated = [r for r in knowledge.ranges if r.sign in SATISFIED_BY]
    stated = [
        r for r in stated if names(r.left) | names(r.right) and names(r.left) | names(r.right) <= own
    ]
    if not has_infinite_sum(*nodes) or not (stated or own & general):
        return decision
    spans = dict.fromkeys(own & general, WIDEST) | sample_ranges(stated)
    drawn = replace(meaning, ranges={**meaning.ranges, **spans}, positive=meaning.positive - {*spans})
    growing: list[Mapping[str, Fraction]] = []
    count = 0
    for terms in _far_terms(nodes):
        for point, (early, late) in sample_trees(terms, drawn, TRIES, tries=TRIES):
            signs = (sign_at(r.left, r.right, drawn, dict(point)) for r in stated)
            if all(sign in SATISFIED_BY[r.sign] for sign, r in zip(signs, stated, strict=True)):
                count += 1
                if abs(late) > max(abs(early), float(SMALL)):
                    growing.append(point)
    is_denied = growing and (own & general or len(growing) == count)
    if not is_denied:
        return decision
    witness = {name: printed_decimal(value) for name, value in growing[0].items()}
    where = " and ".join(dict.fromkeys(r.text for r in stated)) or "all values"
    reason = f"the sum has no value for {where}: its terms do not become small"
    return replace(decision, status=REFUTED, assumptions=(), reason=reason, witness=witness)


def _far_terms(nodes: tuple[Formula, Formula]) -> Iterator[list[Formula]]:
    """Yield two far terms of each sum without end."""
    for part in (part for node in nodes for part in walk(node)):
        if isinstance(part, Summation) and is_infinite(part) and part.index is not None:
            index = part.index.name
            if not indexed_letters(part.body, index):
                try:
                    yield [
                        substitute(at_index(part.body, index, place), index, Number(Fraction(place)))
                        for place in (EARLY, LATE)
                    ]
                except NoFormError:  # the index of a derivative is no number
                    continue
