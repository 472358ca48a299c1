"""Values of a quantity at the place that its sentence names: at φ = 90° the path is s = r (1 + λ/2).

The page has the quantity's formula for every angle. A value said of one place is compared with it there:
where one term has the wrong sign or is twice or half of what the formula gives, the value is wrong.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Sum,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, digits
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide_at_value
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.steps.dead_centres import CENTRES
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

NEAR = 60
"""Characters between an angle's value and what is said of that place."""
NEAR_LINES = 4
"""Lines above a value within which its formula is that of the case in hand."""
SAME = 2e-3
"""Part of its largest term that a value of rounded numbers may be off by."""
_OPEN = (DEFINITION, PREMISE, CONDITION, UNDECIDED)
_LEAVES = re.compile(r"[.;!?]\s|[。；]|\n\s*\n")
_DIRECTION = re.compile(
    r"\b(?:down|up|in|out)wards?\b|\bin\s+size\b|magnitude|absolute|opposite|towards?\b|\bsize\b|Betrag"
    r"|nach\s+(?:unten|oben|innen|außen)|gerichtet|hacia|vers\s+le|verso\b|modul[oe]|valeur\s+absolue"
    r"|\bnum[eé]ri(?:cally|quement|camente)|\bin\s+amount\b|zahlenmäßig"
    r"|向き|大きさ|絶対値",
    re.IGNORECASE,
)
"""Words beside a value that say its direction apart: its sign may be left out."""
BESIDE = 80
"""Characters behind a value in which such words may stand."""
_FACTORS = (Fraction(-1), Fraction(2), Fraction(1, 2))
"""What a term may be times the right one."""


def unless_wrong_at_place(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a value that is no step is refuted by its own formula at the place named."""
    head, right = chain.sides[0].node, chain.sides[1]
    if k or verdict.verdict not in _OPEN or not isinstance(head, Name):
        return verdict
    if chain.relations[0].sign not in "=≈" or len(right.readings) != 1 or isinstance(right.node, Name):
        return verdict
    motion = _formula_above(state, chain, head)
    place = None if motion is None else _place(state, chain, motion)
    if motion is None or place is None or place[0] in names(right.node):
        return verdict
    theta, angle = place
    knowledge = state.knowledge(chain.lines[0])
    others = {n: d for n, d in knowledge.definitions.items() if n not in (theta, head.name)}
    known = replace(knowledge, definitions=_with_printed(others, motion, state))
    repair = _slip(motion, right, theta, angle, known, is_signed=_is_signed(state, chain, head))
    if repair is None and not _is_none_near(state, chain, motion, theta, angle, known):
        return verdict
    shown = f"{plain_text(Name(theta))} = {plain_text(angle)}"
    reason = f"not what line {_line_of(state, chain, motion)} gives at {shown}"
    refuted = Decision(REFUTED, reason, witness=_witness(motion, right.node, theta, angle, known))
    state.definitions.forget(head.name, chain.lines[0])
    fix = fix_of(repair, state.document, right) if state.corrects and repair is not None else None
    return replace(describe(state.document, chain, k, refuted), fix=fix)


def _with_printed(
    definitions: Mapping[str, Definition], motion: Formula, state: JudgingState
) -> dict[str, Definition]:
    """Return definitions with the numbers that the page has printed for letters: λ = r/l = 0.281."""
    numbers = {n: state.results.numbers[n] for n in names(motion) if n in state.results.numbers}
    printed = {n: Definition(values[0], line, True) for n, (line, values) in numbers.items()}
    return {**definitions, **{n: d for n, d in printed.items() if not _is_number(definitions.get(n))}}


def _is_number(definition: Definition | None) -> bool:
    return definition is not None and definition.numeric


def _is_none_near(
    state: JudgingState, chain: Chain, motion: Formula, theta: str, angle: Formula, knowledge: Knowledge
) -> bool:
    """Tell whether a value in all letters of the formula right above is not its value, of either sign."""
    right = chain.sides[1]
    is_near = _line_of(state, chain, motion) >= chain.lines[0] - NEAR_LINES
    own = names(right.node)
    if not is_near or not own or own != names(motion) - {theta} or chain.relations[0].sign != "=":
        return False
    values = (right.node, Negative(right.node))
    decided = [_by_letters(motion, node, right, theta, angle, knowledge) for node in values]
    return decided == [False, False]


def _sides_of(state: JudgingState, chain: Chain, head: Name) -> Iterator[tuple[Chain, Formula]]:
    """Yield the sides that relations above give a letter in the same section, the nearest first."""
    for other in reversed(state.sections.chains_above(head, chain.start)):
        if state.sections.same_section(other.lines[0], chain.lines[0]):
            yield from ((other, side.node) for side in reversed(other.sides[1:]))


def _formula_above(state: JudgingState, chain: Chain, head: Name) -> Formula | None:
    """Return the nearest formula that a letter has above for every angle."""
    return next((node for _, node in _sides_of(state, chain, head) if _turning(node)), None)


def _line_of(state: JudgingState, chain: Chain, motion: Formula) -> int:
    head = chain.sides[0].node
    assert isinstance(head, Name)
    return next(c.lines[0] for c, node in _sides_of(state, chain, head) if node is motion)


def _turning(node: Formula) -> set[str]:
    waves = [p for p in walk(node) if isinstance(p, Call) and p.function in ("sin", "cos")]
    return {name for wave in waves for name in names(wave.argument)}


def _place(state: JudgingState, chain: Chain, motion: Formula) -> tuple[str, Formula] | None:
    """Return the one angle that turns in a formula, and its value where a relation is said to hold."""
    turning = _turning(motion)
    if len(turning) != 1:
        return None
    (theta,) = turning
    text, line = state.document.text, chain.lines[0]
    before = [c for c in state.document.chains if c.end <= chain.start and c.lines[-1] >= line - 1]
    last = max(before, key=lambda c: c.end, default=None)
    if last is not None and last.sides[0].node == Name(theta) and len(last.sides) == 2:
        between, value = text[last.end : chain.start], last.sides[1].node
        is_here = len(between) <= NEAR and not _LEAVES.search(between)
        return (theta, value) if is_here and not names(value) else None
    if state.crank_motions.counts_from_elsewhere:
        return None
    centre = state.sections.dead_centre(chain)
    return None if centre is None else (theta, CENTRES[bool(centre)])


def _is_signed(state: JudgingState, chain: Chain, head: Name) -> bool:
    """Tell whether the page has written a value of a letter at another place with its minus sign."""
    return not says_direction(state, chain) and any(
        isinstance(node, Negative) and not _turning(node) for _, node in _sides_of(state, chain, head)
    )


def says_direction(state: JudgingState, chain: Chain) -> bool:
    """Tell whether words beside a value say its direction apart: numerically F = …, acting downwards."""
    behind = state.document.text[chain.end : chain.end + BESIDE]
    return _DIRECTION.search(f"{state.sections.sentence_before(chain)} {behind}") is not None


def _slip(
    motion: Formula, right: Side, theta: str, angle: Formula, knowledge: Knowledge, *, is_signed: bool
) -> Repair | None:
    """Return the one change that makes a value what a formula gives at a place, if it needs one."""
    agrees = _by_numbers if not names(right.node) else _by_letters
    if agrees(motion, right.node, right, theta, angle, knowledge) is not False:
        return None
    whole = [("sign", Negative(right.node), (right.node, Negative(right.node)))] if is_signed else []
    for kind, node, change in (*_changes(right.node), *whole):
        if agrees(motion, node, right, theta, angle, knowledge):
            return Repair(kind, node, (change,), 1.0)
    return None


def _by_letters(
    motion: Formula, node: Formula, right: Side, theta: str, angle: Formula, knowledge: Knowledge
) -> bool | None:
    """Tell whether a formula has a value at an angle; None where that is open."""
    claim = Side((node,), right.span)
    there = decide_at_value(Side((motion,), right.span), claim, "=", knowledge, theta, angle)
    return True if there.is_proved else False if there.status == REFUTED else None


def _by_numbers(
    motion: Formula, node: Formula, right: Side, theta: str, angle: Formula, knowledge: Knowledge
) -> bool | None:
    """Tell the same of a formula whose letters have numbers, and an arithmetic with rounded ones."""
    exact = _number_there(motion, theta, angle, knowledge)
    claimed = number_of(node, knowledge)
    if exact is None or claimed is None:
        return None
    parts = node.terms if isinstance(node, Sum) else (node,)
    sizes = [abs(size) for part in parts if (size := number_of(part, knowledge)) is not None]
    return bool(abs(exact - claimed) <= SAME * max(sizes, default=0))


def _number_there(motion: Formula, theta: str, angle: Formula, knowledge: Knowledge) -> Any:
    try:
        return number_of(substitute(motion, theta, angle), knowledge)
    except NoFormError:
        return None


def _changes(node: Formula) -> Iterator[tuple[str, Formula, tuple[Formula, Formula]]]:
    """Yield a value with one term of one of its sums changed, with the kind of change and the term."""
    if isinstance(node, Sum):
        for place, term in enumerate(node.terms):
            for factor in _FACTORS:
                changed: Formula = Negative(term) if factor == -1 else Product((Number(factor), term))
                if factor == -1 and isinstance(term, Negative):
                    changed = term.operand
                terms = (*node.terms[:place], changed, *node.terms[place + 1 :])
                yield "sign" if factor == -1 else f"factor {factor}", Sum(terms), (term, changed)
    parts = children(node)
    for place, part in enumerate(parts):
        for kind, changed, change in _changes(part):
            yield kind, with_children(node, (*parts[:place], changed, *parts[place + 1 :])), change


def _witness(
    motion: Formula, value: Formula, theta: str, angle: Formula, knowledge: Knowledge
) -> dict[str, str]:
    exact, claimed = _number_there(motion, theta, angle, knowledge), number_of(value, knowledge)
    return {} if exact is None or claimed is None else {"left": digits(exact), "right": digits(claimed)}
