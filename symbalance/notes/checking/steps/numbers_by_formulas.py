"""Numbers that a formula of the page gives, be it another letter's: for an amplitude, an index, a speed.

    F_2 = 2 λ F_0 cos 2θ, amplitude F̂_2 = 3.83 kN      the factor before the wave
    n_i = 60 f/i, and n_4 = 1890 rpm                   the formula with 4 for i
    v_m = s n/30, at 6000 rpm v_m = 16.8 m/s           the formula at the speed that the sentence names

Nothing but the number is new there, so it is no case of its own. It is right to its digits, or wrong
where one slip lies between; any other number may be of something that the words say, and is left alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import pi

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.slips_in_numbers import is_slip
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.meant.engine_speeds import speeds_of
from symbalance.notes.checking.motions.named_extremes import base_of_largest
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.scaled_numbers import is_speed
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.engines_in_words import EnginesInWords
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OPEN = (DEFINITION, PREMISE, CONDITION, UNDECIDED)
_PART = re.compile(
    r"(?<![^\W\d_])(?:per|each|every|je|jede[rsnm]?|pro|chaque|par|cada|ogni|single|einzeln\w*|half|halbe\w*|peak|both|beide\w*"
    r"|reduce\w*|remain\w*|rest\w*|left|bleib\w*|instead|statt|balanc\w*|ausgleich\w*|équilibr\w*|together|total|all|zusammen"
    r"|insgesamt|alle[rn]?|ensemble|tous|tutt\w+|cylinders|pistons|zylindern?|kolben|cylindres|cilindr\w+)(?![^\W\d_])"
    r"|あたり|残|気筒|釣",
    re.IGNORECASE,
)
"""Words by which a number may be of a part, of several, or of something left."""
_RESTRICTED = re.compile(
    r"(?<![^\W\d_])(?:odd|even|(?:un)?gerade[nrsm]?|impairs?|pairs?|dispari|pari|impar(?:es)?|par(?:es)?|for\s+\$?\\?[a-z]\s*(?:[<>≥≤]"
    r"|\\g|\\l))(?![^\W\d_])|[偶奇]数|[≥>]\s*[1-9]|\\geq?\s*[1-9]",
    re.IGNORECASE,
)
"""Words beside an indexed formula that hold it for some numbers alone: for odd n."""
_MEASURED = re.compile(r"measur|gemessen|observ|mesur|misurat|medid|実測|測定", re.IGNORECASE)
_NOTHING = 1e-9
_COUNTERS = frozenset("ijknhpqν") | {"nu", "ell"}
"""Letters of an index that counts."""
REACH = 120
"""Characters beside a number in which such words are looked for, in its clause."""


def unless_a_formula_gives_it(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number that passes as given is judged by the formula that it comes from."""
    head, right = chain.sides[0].node, chain.sides[1]
    head = head.argument if isinstance(head, Call) and head.function == "abs" else head
    if k or verdict.verdict not in _OPEN or not isinstance(head, Name) or names(right.node):
        return verdict
    if chain.relations[0].sign not in "=≈" or not _is_number(right.node):
        return verdict
    wrong: Decision | None = None
    indexed = _at_the_index(state, chain, head)
    for node, knowledge, line in [*indexed, *_formulas(state, chain, head)]:
        exact, typed = number_of(node, knowledge), number_of(right.node, knowledge)
        if exact is None or typed is None or not (exact or indexed):
            continue
        size = Number(abs(Fraction(str(float(exact))))) if exact < 0 else node
        shown = f"{formula_text(node, plain=True)}, by line {line}"
        there = decide(lone_side(size), right, "≈", knowledge)
        if there.is_proved and not _divides_by_nothing(node, knowledge):
            decision = Decision(PROVED, shown, order="the digits printed")
            return describe(state.document, chain, k, decision)
        is_wrong = bool(indexed) and line == indexed[0][2] and _is_of_every_index(state, chain, line)
        is_wrong |= bool(exact) and is_slip(abs(float(typed)), abs(float(exact)), right.node)
        if there.status == REFUTED and is_wrong and not _divides_by_nothing(node, knowledge):
            wrong = wrong or Decision(REFUTED, f"{shown} it is {float(abs(exact)):.4g}")
    if wrong is None or _is_of_a_part(state, chain):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    return describe(state.document, chain, k, wrong)


def _divides_by_nothing(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula divides by what is nothing there: (1 - q^6)/(1 - q) where q is 1."""
    below = (part.denominator for part in walk(node) if isinstance(part, Quotient))
    sizes = (number_of(each, knowledge) for each in below if not isinstance(each, Number))
    return any(size is None or abs(float(size)) < _NOTHING for size in sizes)


def _is_number(node: Formula) -> bool:
    """Tell whether a side is one number with its unit, or a fraction of two whole ones."""
    if isinstance(node, Quotient):
        return isinstance(node.numerator, Number) and isinstance(node.denominator, Number)
    return is_lone_number(node)


def _is_of_a_part(state: JudgingState, chain: Chain) -> bool:
    """Tell whether the words between a number and the relations beside it say that it is of a part."""
    text, last = state.document.text, state.sections.end_before(chain.start) or 0
    before = SENTENCE_END.split(text[max(last, chain.start - REACH) : chain.start])[-1]
    behind = re.split(r"[.;:=。；]|\n\s*\n", text[chain.end : chain.end + REACH], maxsplit=1)[0]
    return _PART.search(f"{before} {behind}") is not None


def _formulas(state: JudgingState, chain: Chain, head: Name) -> Iterator[tuple[Formula, Knowledge, int]]:
    """Yield the formulas that give a letter's number, what is known of their letters, and their lines."""
    knowledge = state.knowledge(chain.lines[0])
    base = base_of_largest(head.name) or head.name
    if base != head.name or isinstance(chain.sides[0].node, Call):
        yield from _of_the_wave(state, chain, _of_the_engine(state, chain, base), knowledge)
    yield from _at_the_speed(state, chain, _of_the_engine(state, chain, head.name), knowledge)


def _is_of_every_index(state: JudgingState, chain: Chain, line: int) -> bool:
    """Tell whether no words restrict an indexed formula, and none say that a number was measured.

    The first of a series, a_0, is often another one than its formula gives.
    """
    head = chain.sides[0].node
    if not isinstance(head, Name) or head.name.endswith("_0"):
        return False
    lines = state.sections.lines
    around = " ".join(lines[max(0, line - 2) : line + 1])
    behind = state.document.text[chain.end : chain.end + REACH // 4]
    between = state.document.text[state.sections.start_of_line(line) : chain.start]
    is_near = state.sections.same_section(line, chain.lines[0]) and not EnginesInWords(between).mentions
    return is_near and not _RESTRICTED.search(around) and not _MEASURED.search(behind)


def _at_the_index(state: JudgingState, chain: Chain, head: Name) -> list[tuple[Formula, Knowledge, int]]:
    """Return the last formula above of a letter with an index, at a number: S_n = 2 + 2 cos nπ, S_4."""
    stem, _, index = head.name.rpartition("_")
    sections = state.sections
    above = (c for c in reversed(sections.in_order) if c.start < chain.start and c.relations)
    for c in above if index.isdigit() else ():
        letter = c.sides[0].node.name if isinstance(c.sides[0].node, Name) else ""
        counter = letter.removeprefix(f"{stem}_")
        is_indexed = letter != counter and counter in _COUNTERS and counter in names(c.sides[1].node)
        if is_indexed and not sections.is_of_another_engine(chain, c.lines[0]):
            knowledge, line = state.knowledge(chain.lines[0]), c.lines[0]
            return [(substitute(c.sides[1].node, counter, Number(Fraction(index))), knowledge, line)]
    return []


def _of_the_engine(state: JudgingState, chain: Chain, name: str) -> list[Chain]:
    """Return the relations of a letter above that are of the engine which a relation is of."""
    above = state.sections.chains_above(Name(name), chain.start)
    return [c for c in above if not state.sections.is_of_another_engine(chain, c.lines[0])]


def _of_the_wave(
    state: JudgingState, chain: Chain, own: list[Chain], knowledge: Knowledge
) -> Iterator[tuple[Formula, Knowledge, int]]:
    """Yield the factor before the last wave that a letter is above: its only one, or of the same section.

    Engines that follow each other on a page have forces of their own.
    """
    waves = [(c, _amplitude(c.sides[-1].node)) for c in own]
    if not waves or (amplitude := waves[-1][1]) is None:
        return
    last = waves[-1][0].lines[0]
    if len(waves) == 1 or state.sections.same_section(last, chain.lines[0]):
        yield amplitude, knowledge, last


def _amplitude(node: Formula) -> Formula | None:
    """Return the factor before the one wave of a product, None for other formulas."""
    calls = (part for part in walk(node) if isinstance(part, Call) and names(part.argument))
    waves = [call for call in calls if call.function in ("sin", "cos")]
    parts = [node]
    while parts:
        part = parts.pop()
        if len(waves) == 1 and part is waves[0]:
            return replace_part(node, part, Number(Fraction(1)))
        if isinstance(part, Product):
            parts += part.factors
        elif isinstance(part, Negative):
            parts.append(part.operand)
        elif isinstance(part, Quotient):
            parts.append(part.numerator)
    return None


def _at_the_speed(
    state: JudgingState, chain: Chain, own: list[Chain], knowledge: Knowledge
) -> Iterator[tuple[Formula, Knowledge, int]]:
    """Yield a letter's own formula at the one speed that the words before its number name."""
    words = state.sections.sentence_leading_to(chain)
    last = state.sections.end_before(chain.start) or 0
    speeds = speeds_of(words[max(0, len(words) - (chain.start - last)) :])
    formulas = [c for c in own if names(c.sides[1].node)]
    if len(speeds) != 1 or not formulas:
        return
    (speed,), node = speeds, formulas[-1].sides[1].node
    letters = {name for name in names(node) if is_speed(state, name)}
    if len(letters) != 1:
        return
    (letter,) = letters
    is_counted = letter in ("n", "N")
    for value in (Fraction(speed), Fraction(speed, 60)) if is_counted else (Fraction(pi) * speed / 30,):
        number = Definition(Number(value), chain.lines[0], True)
        yield node, knowledge.with_definition(letter, number), formulas[-1].lines[0]
