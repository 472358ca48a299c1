"""Decisions on ≈ in several small letters at once: √(1 - (λ sin φ - δ)²) ≈ 1 - (λ sin φ - δ)²/2.

Each small letter is put as so many times one letter of order; both sides must agree through the highest
power of that letter that the written side has. In λ alone, δ being finite, they would differ.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, Quotient, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.substitution_in_forms import substitute_letter
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.order_agreement import (
    HIGHEST_ORDER,
    IS_SMALL,
    SmallLetter,
    agreement_through,
    degree,
)

ORDER = "order in all small letters"
"""The letter that small letters are multiples of."""


def decide_jointly(left: Formula, right: Formula, knowledge: Knowledge) -> Decision | None:
    """Return the proof that two sides agree in all small letters at once, None for no such proof."""
    small = sorted(n for n in names(right) if _is_small(n, knowledge))
    if len(small) < 2:
        return None
    for level in knowledge.levels(left, right):
        values = {name: node for name, node in level.values.items() if name not in small}
        try:
            decision = _at_level(left, right, small, knowledge, replace(level, values=values))
        except (NoFormError, TooLargeError):
            continue
        if decision is not None:
            return decision
    return None


def _is_small(name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter is called small, or is a ratio of two letters: λ = r/l."""
    definition = knowledge.definitions.get(name)
    usual = knowledge.crank.small if knowledge.crank else None
    is_ratio = definition is not None and isinstance(definition.node, Quotient)
    return name in knowledge.small or (usual is not None and usual == (name, 1)) or is_ratio


def _at_level(
    left: Formula, right: Formula, small: list[str], knowledge: Knowledge, level: Level
) -> Decision | None:
    evaluator = knowledge.evaluator(level)
    domain, scaled = evaluator.domain, list[Form]()
    for node in (left, right):
        form = evaluator.form(node)
        for name in small:
            letter = Form.letter(domain, name)
            form = substitute_letter(form, domain.symbol(name), letter.times(Form.letter(domain, ORDER)))
        scaled.append(form)
    order = degree(scaled[1], ORDER, 1)
    if not order or order > HIGHEST_ORDER:
        return None
    first, second = scaled
    through = SmallLetter(ORDER, 1, order)
    decision = agreement_through(first, second, through, level, loose=False, with_witness=False)
    if not decision.is_proved:
        return None
    texts = [formula_text(Name(name), plain=True) for name in small]
    assumed = [t + IS_SMALL for n, t in zip(small, texts, strict=True) if n not in knowledge.small]
    together = f"order {order} in {' and '.join(texts)} together"
    return replace(decision, order=together, assumptions=(*decision.assumptions, *assumed))
