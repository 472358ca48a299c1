"""Numbers in the case that their own sentence gives in words: with a mass of 8 kg, at half the speed.

The size has no letter there, and the lines above give the letter of its kind another number. With that
other number nothing is confirmed here; what is true with the size of the sentence holds with it.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import isclose

from symbalance.document.formula import Constant, Formula, Name, Number, Product, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.another_case import whole_degrees
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import Dimension, Dimensions, unit_of
from symbalance.notes.checking.units.own_units import is_angular_speed, is_per_minute_number
from symbalance.notes.checking.units.sizes_by_words import unit_by_words
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED, Verdict
from symbalance.notes.checking.words.labels_of_cases import without_comparisons
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.sizes_said import SizeSaid, size_said, sizes_in_words
from symbalance.notes.reading.equations import Chain, Side
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

MOST_SIZES = 4
"""Sizes of a paragraph that are tried, the last ones."""
PER_MINUTE = (Fraction(1, 30), True)
"""What scale_of says of a revolution per minute."""
EXACT, ROUNDED = 1e-9, 0.01
"""By how much two numbers of one size differ: 3000 rpm are 314 1/s as a page rounds them."""
_SENTENCE_END = re.compile(r"(?<![0-9])[.!?]\s|(?<=[0-9])[.!?]\s+(?=[A-ZÄÖÜÉÀ])|。")
_SPEEDS = ("speed", "velocity", "revolutions", "vitesse", "velocità", "velocidad", "drehzahl")


def with_size_said(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict on a number; one that rests on another size than its sentence says is open."""
    if not is_lone_number(chain.sides[k + 1].node) or verdict.verdict not in (*PROVED_WORDS, REFUTED):
        return verdict
    first = state.sections.end_before(chain.start) or 0
    sentence = state.sections.sentence_before(chain)
    words = state.document.text[max(first, chain.start - len(sentence)) : chain.start]
    said = size_said(without_comparisons(words).rstrip(" $\\(["), state.document.text)
    left = next((side for side in reversed(chain.sides[: k + 1]) if names(side.node)), None)
    is_wrong = verdict.verdict == REFUTED
    by_paragraph = _by_sizes_of_paragraph(state, chain, k, left) if left and is_wrong else None
    if by_paragraph or said is None or left is None:
        return by_paragraph or verdict
    knowledge = state.knowledge(chain.lines[0])
    values = {name: d.node for name, d in knowledge.definitions.items()}
    others = letters_of_size(said, {*names_behind(left.node, values)}, state, knowledge)
    result = _letters_of_result(chain, left)
    for name, number in others.items():
        if name in result:
            continue
        there = decide(
            left, chain.sides[k + 1], chain.relations[k].sign, with_size(name, number, knowledge)
        )
        if there.is_proved:
            is_held = verdict.verdict in PROVED_WORDS
            return verdict if is_held else _held(state, chain, k, there, said, name, number)
    nearly = ROUNDED if scale_of(said.unit) == PER_MINUTE else EXACT
    is_again = any(_is_same(n, values[name], nearly, knowledge) for name, n in others.items())
    is_open = bool(others) and not is_again and (not said.is_named or _is_repeated(state, chain, k))
    if verdict.verdict == REFUTED or not is_open:
        return verdict
    shown = " and ".join(f"{name} of line {knowledge.definitions[name].line}" for name in others)
    reason = f"its sentence says “{said.text}”, and it holds with {shown} only"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _by_sizes_of_paragraph(state: JudgingState, chain: Chain, k: int, left: Side) -> Verdict | None:
    """Return the verdict on a number that comes out with a size its paragraph says before it, or None.

    At 60° the pressure has fallen to 14 bar; there the force is F = 7.8 kN. In a sentence before it may
    be another thing's: F = 200 N, the bolt breaks at 500 N.
    """
    start = state.sections.start_of_line(state.sections.paragraph_start(chain.lines[0]))
    words = state.document.text[start : chain.start]
    for other in reversed(state.document.chains):
        if start <= other.start and other.end <= chain.start:
            words = words[: other.start - start] + " = " + words[other.end - start :]
    knowledge = state.knowledge(chain.lines[0])
    behind = {*names_behind(left.node, {name: d.node for name, d in knowledge.definitions.items()})}
    behind -= _letters_of_result(chain, left)
    sign = chain.relations[k].sign
    own = sizes_in_words(_SENTENCE_END.split(words)[-1])
    for said in sizes_in_words(words)[:MOST_SIZES]:
        for name, number in letters_of_size(said, behind, state, knowledge).items():
            there = decide(left, chain.sides[k + 1], sign, with_size(name, number, knowledge))
            if there.is_proved and said in own:
                return _held(state, chain, k, there, said, name, number)
            if there.is_proved:
                reason = f"right if “{said.text}” is {plain_text(Name(name))}: say whose it is"
                return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    return None


def _letters_of_result(chain: Chain, left: Side) -> set[str]:
    """Return the letter whose value a chain works out: a size that would be it is what is to be shown."""
    heads = (side.node for side in (chain.sides[0], left))
    return {head.name for head in heads if isinstance(head, Name)}


def _held(
    state: JudgingState, chain: Chain, k: int, there: Decision, said: SizeSaid, name: str, number: Formula
) -> Verdict:
    """Return the verdict by a size in words, which goes on to be the letter's in its case."""
    state.definitions.define(name, number, chain, state.sections.case_end(chain.lines[0]))
    held = replace(there, assumptions=(*there.assumptions, f"“{said.text}” is {name}"))
    return describe(state.document, chain, k, held)


def with_size(name: str, number: Formula, knowledge: Knowledge) -> Knowledge:
    """Return what is known where a letter has another number; results printed for the old one go."""
    definitions = {
        n: replace(d, rounded=None, node=d.node if d.formula is None or not d.numeric else d.formula)
        for n, d in knowledge.definitions.items()
    }
    own = replace(knowledge.definitions[name], node=number, numeric=True, formula=None, assumption="")
    known = replace(knowledge, definitions=definitions)
    return known.with_definition(name, replace(own, rounded=None))


def _is_repeated(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether a line above has the same number of the same letter or formula."""
    above = state.sections.chains_above(chain.sides[0].node, chain.start)
    return any(chain.sides[k + 1].node in [side.node for side in c.sides[1:]] for c in above)


def letters_of_size(
    said: SizeSaid, behind: set[str], state: JudgingState, knowledge: Knowledge
) -> dict[str, Formula]:
    """Return the letters of the kind of a size that have a number above, with what the size says."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    dimensions = Dimensions(knowledge.meanings, values, state.document.text)
    found: dict[str, Formula] = {}
    for name in sorted(behind & values.keys()):
        definition = knowledge.definitions[name]
        if not definition.numeric or definition.formula is not None:
            continue
        is_angle = whole_degrees(definition.node) is not None
        size = None if is_angle else dimensions.letter(name, 0)
        if said.unit and is_per_minute_number(definition.node, state.document.text):
            if scale_of(said.unit) == PER_MINUTE:  # both as typed
                found[name] = Number(said.number)
            continue
        number = _number(said, name, is_angle, size, definition.node, knowledge)
        if number is not None:
            found[name] = number
    return found


def _number(
    said: SizeSaid,
    name: str,
    is_angle: bool,
    size: Dimension | None,
    value: Formula,
    knowledge: Knowledge,
) -> Formula | None:
    """Return the size that a letter has by words; None for a letter of another kind."""
    if said.noun:
        units = ("1/s", "m/s") if said.noun.split()[-1] in _SPEEDS else (unit_by_words(said.noun) or "",)
        kinds = [unit_of(unit) for unit in units if unit]
        return Product((Number(said.number), value)) if size is not None and size in kinds else None
    if said.is_angle:
        turn = Product((Number(said.number / 180), Constant("pi")))
        return turn if is_angle or name in knowledge.angles else None
    scale = scale_of(said.unit)
    if scale is None or size is None or size != unit_of(said.unit):
        return None
    if said.unit == "Hz" and is_angular_speed(name, knowledge.meanings):
        return None  # what shakes at 400 Hz turns at another speed
    factor, of_turns = scale
    if of_turns and is_angular_speed(name, knowledge.meanings):
        return Product((Number(said.number * factor), Constant("pi")))
    return Number(said.number * (factor / 2 if of_turns else factor))


def _is_same(first: Formula, second: Formula, nearly: float, knowledge: Knowledge) -> bool:
    sizes = [number_of(node, knowledge) for node in (first, second)]
    return None not in sizes and isclose(*map(float, sizes), rel_tol=nearly)
