"""Values that a formula with ± has: x_{1,2} = 2 ± 1, x_1 = 3 and x_2 = 1; m = 2 ± 0.1 kg, m_max = 2.1 kg.

Each of the two roots is the formula with one of its signs. Of a tolerance the largest value is that with
plus, and the letter lies between the two.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, PlusMinus, Product, Sum, names, walk
from symbalance.notes.checking.deciding.branches import with_sign
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, RANGE, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_ROOT = re.compile(r"(?P<stem>.+)_(?P<number>[12])")
_END = re.compile(r"(?P<stem>.+)_(?P<end>max|min|o|u|upper|lower)")
_LARGEST = ("max", "o", "upper")
_UNIT_BEHIND = 16
"""Characters behind a tolerance in which its unit stands."""


def unless_neither_sign(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a root, or the end of a tolerance, is refuted that ± gives with neither sign."""
    head, right = chain.sides[0].node, chain.sides[k + 1]
    is_open = verdict.verdict in (DEFINITION, PREMISE, RANGE)
    if k or not is_open or not isinstance(head, Name) or names(right.node):
        return verdict
    sign = chain.relations[0].sign
    root = _ROOT.fullmatch(head.name)
    if root is not None and sign in "=≈":
        wrong = _why_no_root(state, chain, root["stem"])
    else:
        wrong = _why_outside(state, chain, head.name, sign)
    if not wrong:
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    return describe(state.document, chain, k, Decision(REFUTED, wrong))


def _why_no_root(state: JudgingState, chain: Chain, stem: str) -> str:
    """Return what a root is by the formula with ± above, where it is neither of the two; else ""."""
    right, sign, knowledge = chain.sides[1], chain.relations[0].sign, state.knowledge(chain.lines[0])
    for both in ("1,2", "12", "1/2", "1;2"):
        last = _last(state, chain, f"{stem}_{both}")
        if last is None:
            continue
        node = next(side.node for side in last.sides[1:] if _has_both_signs(side.node))
        roots = [with_sign(node, 1), with_sign(node, -1)]
        found = [decide(Side((root,), right.span), right, sign, knowledge) for root in roots]
        is_wrong = all(each.status == REFUTED for each in found)
        return f"it is {' or '.join(map(plain_text, roots))}" if is_wrong else ""
    return ""


def _why_outside(state: JudgingState, chain: Chain, name: str, sign: str) -> str:
    """Return between which values a letter lies by its tolerance, where another end is said; else ""."""
    end = _END.fullmatch(name)
    if sign in "=≈" and end is None:
        return ""
    last = _last(state, chain, end["stem"] if end is not None and sign in "=≈" else name)
    if last is None or (sign not in "=≈" and not state.sections.is_consequence(chain)):
        return ""
    middle, size = _tolerance(last.sides[1].node)
    said = quantity_of(chain.sides[1], state.document)
    behind = state.document.text[last.start : last.end + _UNIT_BEHIND]
    if size is None or middle is None or said is None:
        return ""
    if not re.search(rf"(?<![A-Za-z]){re.escape(said.unit)}(?![A-Za-z])", behind):
        return ""
    least, largest = middle - size, middle + size
    if sign in "=≈":
        exact = largest if end is not None and end["end"] in _LARGEST else least
        is_wrong = abs(said.value - exact) > said.half
    else:
        is_wrong = said.value < largest if sign in "<≤" else said.value > least
    shown = f"{float(least):g} to {float(largest):g} {said.unit}"
    return f"it lies from {shown}" if is_wrong else ""


def _last(state: JudgingState, chain: Chain, name: str) -> Chain | None:
    """Return the last relation above that gives a letter a formula with ±, None where there is none."""
    last = state.sections.last_above(Name(name), chain.start)
    if last is None or not state.sections.same_section(last.lines[0], chain.lines[0]):
        return None
    return last if any(_has_both_signs(side.node) for side in last.sides[1:]) else None


def _tolerance(node: Formula) -> tuple[Fraction | None, Fraction | None]:
    """Return the number in the middle of a tolerance and the number behind ±, without their units."""
    while isinstance(node, Product) and isinstance(node.factors[0], Sum):
        node = node.factors[0]
    if not isinstance(node, Sum) or len(node.terms) != 2 or not isinstance(node.terms[1], PlusMinus):
        return None, None
    return _number(node.terms[0]), _number(node.terms[1].operand)


def _number(node: Formula) -> Fraction | None:
    """Return the number that a quantity begins with."""
    first = node.factors[0] if isinstance(node, Product) else node
    return first.value if isinstance(first, Number) else None


def _has_both_signs(node: Formula) -> bool:
    return any(isinstance(part, PlusMinus) for part in walk(node))
