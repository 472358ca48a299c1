"""Letters that two lines give different formulas: by a slip, or as the page uses them anew.

Pages call every engine's force F, and each bolt's diameter d. Where a letter alone is given another
value than a line of another section has for it, the line is wrong only if one small change makes it that
value again; anything else may be another engine's, and is said to be at odds with the line above, not to
be wrong.
"""

from __future__ import annotations

import math
import re
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Call, Name, Number, names, walk
from symbalance.notes.checking.deciding.descriptions import describe, printed_value
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.page.solutions import WAVES
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.relation_fixes import add_fix_of_relation
from symbalance.notes.checking.verdicts import REFUTED, UNDECIDED, Fix, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side

_NO_SLIP = ("value", "miscalculated", "term", "phase")
"""Kinds of corrections that put something else in the place of what is written."""
FAR, NEAR = 25, 2
"""Lines within a section: a letter further up may be another one's, sooner where one of them vanishes."""
_EXAMPLE = re.compile(
    r"[\s*_>#-]{0,6}(?:Example|Exercise|Problem|Case|Variant|Beispiel|Aufgabe|Fall|Variante|例題?|問題?|演習)\s?"
    r"(?:[0-9]{1,2}|[A-H])(?![A-Za-z0-9])",
    re.IGNORECASE,
)
"""The label that opens an example of its own within a section."""
MOST_APART = 20
"""How many times larger or smaller a number may be that somebody worked out wrongly."""
SAME_DIGITS = 0.005
"""Of a power of ten: digits that agree to a per cent."""


def unless_used_anew(
    state: JudgingState,
    chain: Chain,
    k: int,
    verdict: Verdict,
    against: Side,
    decision: Decision,
    knowledge: Knowledge,
) -> Verdict:
    """Return a refuted verdict, or that its letter may be used anew: another section has it otherwise."""
    head, line = chain.sides[0].node, chain.lines[0]
    if k or chain.relations[0].sign != "=" or not isinstance(head, Name):
        return verdict
    if verdict.verdict != REFUTED or decision.reason:
        return verdict
    earlier = knowledge.definitions.get(head.name)
    if earlier is None or head.name in knowledge.meaning.values or earlier.line >= line:
        return verdict
    apart = NEAR if _is_nothing(chain, decision) else FAR
    is_near = state.sections.same_section(earlier.line, line) and line - earlier.line <= apart
    is_near = is_near and not _is_other_example(state, earlier.line, line)
    if is_near or _is_value(state, chain, decision, knowledge):
        return verdict
    searched = verdict
    if not knowledge.corrects:
        searched = add_fix_of_relation(
            state, verdict, chain, k, against, decision, replace(knowledge, corrects=True)
        )
    if searched.fix is not None and _is_slip(searched.fix):
        return verdict
    reason = (
        f"not the {plain_text(head)} of line {earlier.line}, and no single slip lies between:"
        " used anew, or wrong"
    )
    return describe(state.document, chain, k, replace(decision, status=UNDECIDED, reason=reason))


def _is_other_example(state: JudgingState, first: int, line: int) -> bool:
    """Tell whether a line opens another labelled example between two lines: Example 2, Beispiel B."""
    lines = state.document.text.split("\n")[first:line]
    return any(_EXAMPLE.match(text) for text in lines)


def _is_nothing(chain: Chain, decision: Decision) -> bool:
    """Tell whether one of two values of a letter is 0: F_2 = 0 of one engine, 4 λ m r ω² of the next."""
    is_zero = isinstance(chain.sides[1].node, Number) and not chain.sides[1].node.value
    return is_zero or (decision.left is not None and decision.left.is_zero() is True)


def _is_value(state: JudgingState, chain: Chain, decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether a line gives the value of a formula above: at an angle, or as one printed number.

    A number of quite another size is no result of that formula: such a letter is another one's.
    """
    left, right = chain.sides[:2]
    earlier = knowledge.definitions[left.node.name] if isinstance(left.node, Name) else None
    formula = earlier and (earlier.formula if earlier.numeric else earlier.node)
    if formula is None:
        return False
    waves = [part for part in walk(formula) if isinstance(part, Call) and part.function in WAVES]
    turning = {name for wave in waves for name in names(wave.argument)}
    if turning and not turning & names(right.node):
        return True
    printed = printed_value(decision, state.document, right, left)
    if printed is None:
        return False
    claim, value, _ = printed
    size = abs(Fraction(claim.factor) * claim.mantissa)
    if not size or not value:
        return False
    powers = math.log10(float(abs(value) / size))
    is_shifted = abs(powers - round(powers)) < SAME_DIGITS  # 71.1 kN for 7.1057 kN
    return is_shifted or abs(powers) < math.log10(MOST_APART)


def _is_slip(fix: Fix) -> bool:
    """Tell whether a correction undoes one small slip: a sign, a factor, an exponent, digits."""
    return not any(kind.strip().startswith(_NO_SLIP) for kind in fix.kind.split(";"))
