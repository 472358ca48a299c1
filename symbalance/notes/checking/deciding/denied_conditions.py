"""Conditions that a page denies: |a - b| = a - b holds if a - b ≥ 0, and the page says that a < b.

What is proved on a condition is refuted where no point within the ranges that the page states makes it
true, and where it is said of all values though it fails at some.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import Formula, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.algebra.values import context
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, digits, printed_decimal
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, sample_ranges
from symbalance.notes.checking.deciding.knowledge import Knowledge, StatedRange
from symbalance.notes.checking.deciding.satisfiability import sign_at
from symbalance.notes.reading.equations import Side

TRIES = 60
"""Points drawn at random, of which those within the ranges count."""
FEWEST = 6
"""Points within the ranges at which a relation fails before it is said to fail there."""
WIDEST = (-400, 400)
"""Where letters are drawn of all of whose values something is said, in hundredths."""
NEAR_ZERO = 20
"""Digits to which two sides agree that are equal."""


def decide_within_ranges(
    left: Side, right: Side, decision: Decision, knowledge: Knowledge, general: Collection[str] = ()
) -> Decision:
    """Return the refutation of what holds on a condition that the page denies; else the decision.

    `general` are the letters of all of whose values it is said.
    """
    if not decision.is_proved or not any(_is_of_sign(text) for text in decision.assumptions):
        return decision
    own = names(left.node) | names(right.node)
    stated = [r for r in knowledge.ranges if names(r.left) | names(r.right) <= own]
    stated = [r for r in stated if r.sign in SATISFIED_BY and names(r.left) | names(r.right)]
    condition = next(text for text in decision.assumptions if _is_of_sign(text))
    points = list(_points(left.node, right.node, stated, knowledge, own.intersection(general)))
    failing = [(point, pair) for point, pair in points if not _is_close(*pair)]
    if stated and len(failing) == len(points) >= FEWEST:
        texts = " and ".join(dict.fromkeys(f"{r.text} of line {r.line}" for r in stated))
        return _refuted(decision, failing[0], f"not for {texts}: it holds if {condition}")
    if own & {*general} and failing:
        return _refuted(decision, failing[0], f"said of all values, but it holds if {condition}")
    return decision


def _refuted(decision: Decision, failing: tuple[Mapping[str, Fraction], Any], reason: str) -> Decision:
    point, (first, second) = failing
    witness = {name: printed_decimal(value) for name, value in point.items()}
    witness |= {"left": digits(first), "right": digits(second)}
    return replace(decision, status=REFUTED, assumptions=(), reason=reason, witness=witness)


def _is_of_sign(text: str) -> bool:
    """Tell whether an assumption says that something is not negative, or not positive."""
    return text.endswith((" ≥ 0", " ≤ 0"))


def _points(
    left: Formula,
    right: Formula,
    stated: list[StatedRange],
    knowledge: Knowledge,
    general: frozenset[str],
) -> Iterator[tuple[Mapping[str, Fraction], tuple[Any, Any]]]:
    """Yield points within the ranges, with the values of both sides."""
    level = list(knowledge.levels(left, right))[-1]
    values = {name: value for name, value in level.values.items() if name not in general}
    spans = dict.fromkeys(general, WIDEST) | sample_ranges(stated)
    meaning = replace(knowledge.meaning, values=values)
    meaning = replace(
        meaning, ranges={**meaning.ranges, **spans}, positive=meaning.positive - {*spans} - general
    )
    try:
        samples = sample_trees([left, right], meaning, TRIES, tries=TRIES)
        for point, (first, second) in samples:
            signs = (sign_at(r.left, r.right, meaning, dict(point)) for r in stated)
            if all(sign in SATISFIED_BY[r.sign] for sign, r in zip(signs, stated, strict=True)):
                yield point, (first, second)
    except (NoFormError, TooLargeError):
        return


def _is_close(first: Any, second: Any) -> bool:
    scale = max(abs(first), abs(second), 1)
    return bool(abs(first - second) <= scale * context().mpf(10) ** -NEAR_ZERO)
