"""Decisions where a page has said on which side of zero a letter lies: x < 0 gives |x| = -x.

A root is taken as of a positive letter. One that is below zero by a range, or by its number, is put in as
minus a positive one; what holds "if x ≥ 0" only is then refuted.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from symbalance.document.formula import Call, Formula, Name, Negative, Number, Power, names, walk
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.inequalities import lone_letter
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading.equations import Side


def decide_with_signs(
    left: Side, right: Side, sign: str, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision with the letters that stated ranges keep below zero taken as such."""
    below = {
        name: f"{stated.text} of line {stated.line}"
        for stated in knowledge.ranges
        for name in [_below_zero(stated)]
        if name
    }
    own = names(left.node) | names(right.node)
    values = {n: d.node for n, d in knowledge.definitions.items()}
    behind = {n for node in (left.node, right.node) for n in names_behind(node, values)} - own
    chosen = [name for name in sorted(below) if name in own and name not in behind]
    if not chosen or not _has_root(left.node, right.node):
        return _outside_its_number(decision, knowledge)

    def mirrored(node: Formula) -> Formula:
        for name in chosen:
            node = substitute(node, name, Negative(Name(name)))
        return node

    meaning = replace(
        knowledge.meaning,
        positive=knowledge.meaning.positive | {*chosen},
        ranges={n: span for n, span in knowledge.meaning.ranges.items() if n not in chosen},
    )
    apart = tuple(r for r in knowledge.ranges if names(r.left) | names(r.right) != {*chosen})
    try:
        there = decide(
            _mapped(left, mirrored),
            _mapped(right, mirrored),
            sign,
            replace(knowledge, meaning=meaning, ranges=apart),
        )
    except NoFormError:
        return _unless_denied(decision, below)
    texts = tuple(below[name] for name in chosen)
    if there.is_proved:
        return replace(there, assumptions=(*there.assumptions, *texts))
    if there.status == REFUTED:
        witness = {n: f"-{v}" if n in chosen else v for n, v in there.witness.items()}
        reason = there.reason or f"not for {' and '.join(texts)}"
        return replace(decision, status=REFUTED, assumptions=(), reason=reason, witness=witness)
    return there if not decision.is_proved else _unless_denied(decision, below)


def _unless_denied(decision: Decision, below: dict[str, str]) -> Decision:
    """Return the decision, open where it is proved for letters that are not negative, and these are."""
    denied = [name for name in sorted(below) if f"{name} ≥ 0" in decision.assumptions]
    if not decision.is_proved or not denied:
        return decision
    reason = f"it is proved if {denied[0]} ≥ 0, and {below[denied[0]]} says otherwise"
    return replace(decision, status=UNDECIDED, assumptions=(), reason=reason)


def _mapped(side: Side, change: Callable[[Formula], Formula]) -> Side:
    return side.changed(change)


def _below_zero(stated: Any) -> str:
    """Return the letter that a range keeps below zero, "" for none."""
    own = lone_letter(stated)
    if own is None or own[1] not in "<≤":
        return ""
    bound = own[2].operand if isinstance(own[2], Negative) else own[2]
    is_below = isinstance(bound, Number) and (bound is not own[2] or bound.value <= 0)
    return own[0] if is_below else ""


def _has_root(*nodes: Formula) -> bool:
    """Tell whether a sign counts in formulas: a root, an absolute value, a broken power."""
    return any(
        (isinstance(part, Call) and part.function in ("sqrt", "abs"))
        or (isinstance(part, Power) and not _is_whole(part.exponent))
        for node in nodes
        for part in walk(node)
    )


def _is_whole(node: Formula) -> bool:
    return isinstance(node, Number) and node.value.denominator == 1


def _outside_its_number(decision: Decision, knowledge: Knowledge) -> Decision:
    """Return the refutation of what holds if k ≥ 0 where a line before gives k = -1."""
    for text in decision.assumptions if decision.is_proved else ():
        name = text.removesuffix(" ≥ 0")
        definition = knowledge.definitions.get(name)
        if name == text or definition is None or not definition.numeric:
            continue
        if isinstance(definition.node, Negative) and isinstance(definition.node.operand, Number):
            value = formula_text(definition.node, plain=True)
            reason = f"not for {name} = {value} of line {definition.line}: it holds if {text}"
            return replace(decision, status=REFUTED, assumptions=(), reason=reason)
    return decision
