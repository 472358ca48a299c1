"""Sizes that an inequality asks for: 16 T/(π d³) ≤ 50 MPa with T = 100 N m, so d ≥ 21.7 mm.

The bound that is written down is put into the inequality above. Where that fails there, however the bound
was rounded, the size is too small or too large; one that is safer than need be is nobody's fault.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import RANGE, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SIGNS = {"<": -1, "≤": -1, ">": 1, "≥": 1}
_LED = re.compile(
    r"(?<![^\W\d_])(?:so|hence|thus|therefore|then|gives?|needs?|requires?|must|we\s+(?:get|need|have)|follows|with|solving"
    r"|also|somit|daher|folgt|ergibt|muss|erforderlich|nötig|mit|donc|d['’]où|soit|faut|avec|quindi|dunque|serve|con|luego|resulta)"
    r"(?![^\W\d_])|よって|したがって|より|必要|[:⇒⟹]|\\(?:Rightarrow|implies)(?![A-Za-z])",
    re.IGNORECASE,
)
"""What leads from an inequality to the size that it asks for."""
_REACH, _MOST = 400, 8
"""Characters between the two, and chains that are looked through."""
_ROUNDED = Fraction(1, 50)
"""Part by which a bound may be off that was rounded for the workshop."""


def unless_size_fails(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a bound of a letter is refuted where the inequality it comes from fails there."""
    head, bound = chain.sides[0].node, chain.sides[1].node
    is_bound = (
        verdict.verdict == RANGE and len(chain.relations) == 1 and chain.relations[0].sign in _SIGNS
    )
    if k or not is_bound or not isinstance(head, Name) or names(bound):
        return verdict
    if state.sections.opens_case(chain):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    size = number_of(bound, knowledge)
    if not size:
        return verdict
    for left, sign, right, line in _inequalities(state, chain, head.name):
        ends = [
            _excess(left, right, head.name, Fraction(str(float(size))) * (1 + e), knowledge)
            for e in (_ROUNDED, -_ROUNDED)
        ]
        if None in ends:
            continue
        is_failing = all(each is not None and each * _SIGNS[sign] < 0 for each in ends)
        if is_failing:
            at = f"{plain_letter(head.name)} = {state.document.source(chain.sides[1].span)}"
            reason = f"{plain_text(left)} {sign} … of line {line} fails at {at.replace('$', '')}"
            return describe(state.document, chain, k, Decision(REFUTED, reason))
        return verdict
    return verdict


def _inequalities(
    state: JudgingState, chain: Chain, name: str
) -> Iterator[tuple[Formula, str, Formula, int]]:
    """Yield the inequalities above that a letter stands in, the nearest first, with both their sides."""
    above: Chain | None = chain
    text = state.document.text
    for _ in range(_MOST):
        above = state.sections.chain_before(above.start)
        if above is None or chain.start - above.end > _REACH:
            return
        if not state.sections.same_section(above.lines[0], chain.lines[0]):
            return
        if not above.relations:
            continue
        sign = above.relations[-1].sign
        left, right = (side.node for side in above.sides[-2:])
        is_formula = sign in _SIGNS and name in names(left) | names(right) and not isinstance(left, Name)
        if is_formula and _LED.search(text, above.end, chain.start):
            yield left, sign, right, above.lines[0]


def _excess(
    left: Formula, right: Formula, name: str, size: Fraction, knowledge: Knowledge
) -> float | None:
    """Return by how much the left side is larger at a letter's size, None where a letter is open."""
    others = {n: d for n, d in knowledge.definitions.items() if n != name}
    known = Knowledge(
        meaning=knowledge.meaning, definitions={**others, name: Definition(Number(size), 0, numeric=True)}
    )
    try:
        values = [number_of(substitute(node, name, Number(size)), known) for node in (left, right)]
    except NoFormError:
        return None
    first, second = values
    return None if first is None or second is None else float(first) - float(second)
