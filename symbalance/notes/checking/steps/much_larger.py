"""Relations ≫ and ≪: "the flywheel is large, J_2 ≫ J_1" says of letters where they lie.

Of numbers it is true where one is several times the other, wrong where it is not even larger, and else
a matter of opinion.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Power, Product, Quotient, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.inequalities import compare
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import RANGE
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain, Side

PLAIN = {"≫": ">", "≪": "<"}
"""The relation that each of them is at least."""
APART = 1e-3
"""Part of themselves by which two sides differ that are not the same where a letter is much larger."""
LARGE = 8
"""Powers of ten that one letter is times the other at the points tried."""
MUCH = 3
"""Times that one number has to be the other."""


def decide_much_larger(chain: Chain, k: int, knowledge: Knowledge) -> Decision:
    """Return the decision on a relation ≫ or ≪."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    plain = compare(left, right, PLAIN[chain.relations[k].sign], knowledge)
    if plain is None:
        return Decision(RANGE, "one is said to be much larger")
    if not plain.is_proved:
        return plain
    ratio = number_of(Quotient(left, right), knowledge)
    if ratio is None:  # λ² ≪ 1 of a crank ratio, which is below 1 and has no number here
        return Decision(RANGE, "one is said to be much larger")
    if abs(ratio) >= MUCH or MUCH * abs(ratio) <= 1:
        return Decision(PROVED, assumptions=plain.assumptions)
    return Decision(UNDECIDED, "larger, but not several times")


def decide_where_larger(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on ≈ by a letter that the sentence says to be much larger than another.

    After J_2 ≫ J_1 the smaller one is ε² times the larger, and both sides are compared for a small ε,
    where they may grow as 1/ε.
    """
    if chain.relations[k].sign != "≈" or decision.status not in (PROVED, REFUTED, UNDECIDED):
        return None
    stated = next((c for c in reversed(state.much_larger) if _is_near(state, c, chain)), None)
    sides = chain.sides[k : k + 2]
    values = {n: d.node for n, d in knowledge.definitions.items()}
    behind = {n for side in sides for n in names_behind(side.node, values)}
    letters_meant = None if stated is None else _letters(stated, behind, knowledge)
    if stated is None or letters_meant is None or not names(sides[1].node):
        return None
    small, large = letters_meant
    text = f"{formula_text(large, plain=True)} ≫ {formula_text(small, plain=True)}"
    others = {
        n: d
        for n, d in knowledge.definitions.items()
        if n != large.name and (n in behind or n in names(sides[0].node))
    }

    def where(size: Formula) -> Knowledge:
        """Return what is known with the small letter so many times the large one."""
        definition = Definition(Product((size, large)), stated.lines[0])
        known = replace(knowledge, definitions={**others, small.name: definition})
        return replace(known, small=frozenset({_RATIO}), letters=knowledge.letters | {_RATIO})

    are_apart = _part(sides, where(Number(Fraction(1, 10**LARGE))))
    if are_apart is None:
        return Decision(UNDECIDED, f"no point where {text} and both sides are real")
    if are_apart:
        return Decision(REFUTED, f"not so where {text}")
    letter = Name(_RATIO)
    for power in (0, 1, 2):
        factor = Power(letter, Number(Fraction(power)))
        scaled = [lone_side(Product((factor, side.node))) if power else side for side in sides]
        there = decide(scaled[0], scaled[1], "≈", where(Power(letter, Number(Fraction(2)))))
        if there.is_proved:
            return replace(there, assumptions=(text,), order=f"the leading term where {text}")
    return None


def _letters(stated: Chain, behind: set[str], knowledge: Knowledge) -> tuple[Name, Name] | None:
    """Return the smaller and the larger letter; None where one has a number, or stands in no side."""
    pair = [side.node for side in stated.sides[:2]]
    small, large = pair if stated.relations[0].sign == "≪" else pair[::-1]
    if not isinstance(small, Name) or not isinstance(large, Name):
        return None
    is_open = all(number_of(node, knowledge) is None for node in pair)
    return (small, large) if is_open and {small.name, large.name} <= behind else None


def _part(sides: Sequence[Side], knowledge: Knowledge) -> bool | None:
    """Tell whether two sides differ by more than a thousandth, whatever the sign; None without points."""
    left, right = (side.node for side in sides)
    level = list(knowledge.levels(left, right))[-1]
    own = {n for node in (left, right) for n in names_behind(node, level.values)}
    positive = knowledge.meaning.positive | (own - knowledge.angles)  # sizes, of which one is much larger
    meaning = replace(knowledge.meaning, values=level.values, positive=frozenset(positive))
    points = sample_trees([left, right], meaning)
    pairs = [(abs(pair[0]), abs(pair[1])) for _, pair in points]
    return all(abs(a - b) > APART * max(a, b) for a, b in pairs) if pairs else None


_RATIO = "epsilon_ratio"
"""The letter whose square is the smaller size over the larger."""


def _is_near(state: JudgingState, stated: Chain, chain: Chain) -> bool:
    """Tell whether a relation stands behind what is stated, in its paragraph or the next display."""
    line = stated.lines[0]
    return line <= chain.lines[0] <= state.sections.case_end(line)
