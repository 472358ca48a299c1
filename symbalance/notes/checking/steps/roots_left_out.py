"""Roots that an equation has beside the one a page goes on with: x (x - 1) = 0, so x = 1 (if x ≠ 0).

Who divides by a letter, or writes down one root of two, has said something that the equation alone does
not say. The root holds, and the other one is named as what is left out, where neither words, nor a range
or the letter's meaning, nor another value of it nearby says why.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.implications import solution_lost
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.only_solutions import another_root, equation_of
from symbalance.notes.checking.verdicts import CONDITIONAL, HOLDS, HOLDS_TO_ORDER, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_FAR = 400
"""Characters on either side within which another value of the letter is another root of it."""
_CHOSEN = re.compile(
    r"(?<![^\W\d_])(?:other|one\s+of|a\s+(?:root|solution|zero)|is\s+an?\s|roots|solutions|first|second|larger|smaller|positive|negative"
    r"|physical\w*|trivial|non-?zero|reject\w*|discard\w*|satisf\w+|checks?|test\w*|try|put\w*|for\s+example|e\.g\."
    r"|anderen?|eine\s+(?:Lösung|Wurzel|Nullstelle)|Lösungen|Nullstellen|Wurzeln|erste|zweite|größere|kleinere|physikalisch\w*"
    r"|erfüllt|Probe|zum\s+Beispiel|z\.\s?B\.|autres?|une\s+(?:solution|racine)|solutions|racines|première|seconde|deuxième"
    r"|vérifie|par\s+exemple|altr[aoe]|una\s+(?:soluzione|radice)|soluzioni|radici|prima|seconda|soddisfa|otr[ao]s?"
    r"|soluciones|raíces|primera|segunda|cumple)(?![^\W\d_])|例えば|一つ|正の|負の|他の|物理的|満た",
    re.IGNORECASE,
)
"""Words that call a value one of several, choose it, or only put it in."""


def with_root_left_out(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; of a number that an equation gives, that it is so if it is not its other root."""
    head = chain.sides[0].node
    is_one = not k and len(chain.relations) == 1 and isinstance(head, Name)
    if not is_one or verdict.verdict not in (HOLDS, HOLDS_TO_ORDER) or names(chain.sides[1].node):
        return verdict
    if not isinstance(head, Name) or not re.match(r"(?:satisfies|by) line", verdict.reason):
        return verdict
    equation = equation_of(state, chain)
    if equation is None or not verdict.reason.endswith(f"line {equation.lines[0]}"):
        return verdict
    left_out = _root_left_out(state, chain, equation, head.name)
    return replace(verdict, verdict=CONDITIONAL, assumption=left_out, order="") if left_out else verdict


def _root_left_out(state: JudgingState, chain: Chain, equation: Chain, name: str) -> str:
    """Return that a letter is not another root of an equation, "" where there is none or words choose."""
    knowledge = state.knowledge(chain.lines[0])
    sides = equation.sides[0].node, equation.sides[1].node
    if any(name in letters_in_waves(side) for side in sides) or _is_chosen(state, chain, equation, name):
        return ""
    is_bound = name in knowledge.meaning.positive or any(
        name in names(r.left) | names(r.right) for r in knowledge.ranges
    )
    value = chain.sides[1].node
    point = None if is_bound else solution_lost(sides, (Name(name), value), knowledge)
    if point is None:
        found = another_root(name, sides, value, knowledge)
        return found.replace(" ≈ ", " ≠ ") if found else ""
    own, other = (number_of(each, knowledge) for each in (value, point[name]))
    if own is not None and other is not None and own > 0 > other:
        return f"{plain_text(Name(name))} ≥ 0"
    return f"{plain_text(Name(name))} ≠ {plain_text(point[name])}"


def _is_chosen(state: JudgingState, chain: Chain, equation: Chain, name: str) -> bool:
    """Tell whether words call a value one of several, or another value of the letter stands nearby."""
    text = state.document.text
    behind = text[chain.end : chain.end + _FAR].partition("\n\n")[0].partition(". ")[0]
    if _CHOSEN.search(text, min(equation.end, chain.start), chain.start) or _CHOSEN.search(behind):
        return True
    own = Name(name)
    stem = name.partition("_")[0]
    near = state.sections.chains_between(max(chain.start - _FAR, equation.end), chain.end + _FAR)
    return any(
        other.start != chain.start
        and isinstance(head := other.sides[0].node, Name)
        and (head == own or head.name.partition("_")[0] == stem)
        for other in near
    )
