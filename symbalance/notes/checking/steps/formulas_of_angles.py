"""The formula above whose largest value a line gives: M(φ) = A (cos φ + λ cos 2φ), M_max = A (1 + λ).

The letter itself may have no value by then: it was written as a function of its angle, or the formula is
that of a sum, F_1 + F_2 = A cos(θ + 45°), whose greatest value the next sentence gives. What counts is
one angle that stands in cosines and sines alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symbalance.document.formula import Apply, Call, Formula, Name, Product, children, names, walk
from symbalance.notes.checking.deciding.equality import without_dots
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.motions.named_extremes import base_of_extreme
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

NEXT = 240
"""Characters between a formula and the words of its greatest value."""
_WAVES = ("cos", "sin")
_ANGLES = frozenset({"theta", "phi", "varphi", "alpha", "vartheta"})
_ITS_LARGEST = re.compile(
    r"(?:\b(?:its|their|this|the)\s+(?:greatest|largest|maximum|peak|highest)\s+(?:value|size|magnitude)"
    r"|\b(?:ihr|sein|der|dessen|deren)e?n?\s+(?:größter?n?|höchster?n?|maximaler?n?)\s+(?:wert|betrag)"
    r"|\bsa\s+(?:plus\s+grande\s+)?valeur\s+maximale|\bsu\s+valor\s+m[aá]ximo"
    r"|\b(?:il\s+suo\s+)?valore\s+massimo|その(?:最大値|最大の(?:値|大きさ)))",
    re.IGNORECASE,
)
"""Words for the largest value of what the formula right before them gives."""


def with_formula_above(state: JudgingState, chain: Chain, knowledge: Knowledge) -> Knowledge | None:
    """Return what is known with the formula of which a line gives the largest value; None for none."""
    head = chain.sides[0].node
    base = base_of_extreme(head.name) if isinstance(head, Name) else ""
    if not base or not isinstance(head, Name) or knowledge.crank is None or base in knowledge.letters:
        return None
    above = [c for c in state.document.chains if c.relations and c.end <= chain.start]
    own = [c for c in above if _is_of(base, c.sides[0].node, knowledge)]
    own = [c for c in own if state.sections.same_section(c.lines[0], chain.lines[0])]
    source = own[-1] if own else _source_next(state, chain, above, base)
    if source is None or state.sections.is_of_another_engine(chain, source.lines[0]):
        return None
    formulas = [without_dots(side.node)[0] for side in source.sides[1:]]
    waves = [node for node in formulas if _angle_alone(node)]
    if not waves or len(formulas) > len(waves) + 1:
        return None
    angle = _angle_alone(waves[-1])
    definitions = {name: each for name, each in knowledge.definitions.items() if name != angle}
    definitions[base] = Definition(waves[-1], source.lines[0])
    crank = replace(knowledge.crank, theta=Name(angle))
    return replace(knowledge, definitions=definitions, crank=crank)


def _source_next(state: JudgingState, chain: Chain, above: list[Chain], base: str) -> Chain | None:
    """Return the formula right before the words for its greatest value, if it is of the same letter."""
    last = next((c for c in reversed(above) if not c.letters <= _ANGLES), None)  # greatest at θ = 45°
    if last is None or chain.start - last.end > NEXT:
        return None
    words = state.document.text[last.end : chain.start]
    stems = {name.partition("_")[0].rstrip("0123456789") for name in names(last.sides[0].node)}
    return last if _ITS_LARGEST.search(words) and stems == {base.partition("_")[0]} else None


def _is_of(base: str, head: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula's left side is a letter, or the letter as a function of an angle."""
    if isinstance(head, Apply | Product):
        parts = [part for part in walk(head) if isinstance(part, Name)]
        is_of_angle = len(parts) == 2 and parts[1].name in {*knowledge.angles, *_ANGLES}
        return is_of_angle and parts[0].name == base
    return head == Name(base)


def _angle_alone(node: Formula) -> str:
    """Return the one letter of a formula's waves that stands nowhere else in it; "" for none.

    >>> x = Name("x")
    >>> _angle_alone(Name("a") * Call("cos", x) + Call("sin", 2 * x)), _angle_alone(x * Call("cos", x))
    ('x', '')
    """
    waves = [part for part in walk(node) if isinstance(part, Call) and part.function in _WAVES]
    angles = {name for wave in waves for name in names(wave.argument)}
    if len(angles) != 1:
        return ""
    (angle,) = angles
    return "" if angle in {*_letters_outside(node)} else angle


def _letters_outside(node: Formula) -> Iterator[str]:
    """Yield the letters of a formula that stand in no cosine or sine."""
    if isinstance(node, Name):
        yield node.name
    elif not isinstance(node, Call) or node.function not in _WAVES:
        for part in children(node):
            yield from _letters_outside(part)
