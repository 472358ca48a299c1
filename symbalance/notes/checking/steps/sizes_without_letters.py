"""Results of formulas for whose letters the page has sizes in words: a bore of 86 mm, and V = π D² s/4.

No line gives D and s a number, so what V comes to could pass as given. Where the words of the page give
the size that a letter usually is, and one number of it, the formula is computed with that. The number is
right to its digits, or wrong if one slip lies between; where the formula is known by its name, swept
volume or mean piston speed, its letters are those sizes, and any other number is wrong. So it is with two
letters of which a line above gives the product: m r = 20.7 kg mm, and then U = m r a.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from math import isclose

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.cases import FIXES, GIVE_IT, NUMBERS_PUT_IN
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.slips_in_numbers import is_mistyped, is_slip
from symbalance.notes.checking.declared.symbol_roles import BY_MINUTE, role_of
from symbalance.notes.checking.meant.engine_speeds import speed_restated, speeds_of
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.own_units import is_angular_speed
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.sections import LONGEST_SENTENCE
from symbalance.notes.checking.words.sizes_of_page import SizeOfPage, is_called, sizes_of_page
from symbalance.notes.reading.equations import Chain

LETTERS = {
    "bore": ("D", "d", "B", "b"),
    "stroke": ("s", "S", "H", "h", "L"),
    "crank radius": ("r", "R"),
    "rod length": ("l", "L"),
    "cylinder pitch": ("a", "b", "z"),
    "piston mass": ("m", "m_p", "m_K"),
    "reciprocating mass": ("m", "m_o", "m_osc", "m_rec", "m_a"),
    "mass": ("m", "M"),
}
"""The letters that stand for a size on most pages."""
_TURNS = ("n", "N")
_BY_THE_MINUTE = {Number(Fraction(60)), Number(Fraction(30))}
"""What a formula divides by whose speed is a number of revolutions per minute."""
_ROUGHLY = 0.02
"""By how much a result may be rounded, beyond its digits."""
_TWO = Fraction(1), Fraction(3)
"""Numbers for the letters left open: what a formula comes to by a product alone is the same with both."""
_OPEN = (NUMBERS_PUT_IN, FIXES)


def with_sizes_in_words(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a result that passes as given is judged by the sizes in the page's words."""
    left, right = chain.sides[k], chain.sides[k + 1]
    if not k and isinstance(left.node, Name) and verdict.verdict in (DEFINITION, PREMISE):
        verdict = _unless_mistyped_speed(state, chain, verdict)
    is_open = (verdict.verdict == PREMISE and verdict.reason.startswith(_OPEN)) or (
        verdict.verdict == UNDECIDED and verdict.reason.endswith(GIVE_IT)
    )
    if not is_open or not is_lone_number(right.node) or not names(left.node):
        return verdict
    there = _by_sizes(state, chain, k)
    if there is None:
        return verdict
    state.definitions.forget_moment(right.node)
    return describe(state.document, chain, k, there)


def _by_sizes(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return the decision on a result by sizes in words and products; None where it is open."""
    left, right, line = chain.sides[k], chain.sides[k + 1], chain.lines[0]
    knowledge = state.knowledge(line)
    free = _free(left.node, knowledge)
    given = dict(_sizes(state, chain, left.node, free, knowledge))
    products = _by_products(state, chain, free - given.keys())
    if not given and not products:
        return None
    texts = [text for _, text in (*given.values(), *products.values())]
    sizes = {name: node for name, (node, _) in (*given.items(), *products.items())}
    open_letters = free - sizes.keys()
    known, other = (
        _with_values(line, {**dict.fromkeys(open_letters, Number(one)), **sizes}, knowledge)
        for one in _TWO
    )
    typed, exact = number_of(right.node, known), number_of(left.node, known)
    again = number_of(left.node, other)
    if not typed or not exact or not again or not isclose(float(exact), float(again), rel_tol=1e-9):
        return None
    there = decide(left, right, "≈", known)
    if there.is_proved:
        return replace(there, assumptions=tuple(dict.fromkeys((*there.assumptions, *texts))))
    is_here = all(state.sections.same_section(size.line, line) for size in _here(state, chain).values())
    is_named = is_here and len(given) > 1 and k > 0 and left.span[0] in state.proved
    number, size = abs(float(typed)), abs(float(exact))
    is_wrong = is_slip(number, size, right.node) or is_mistyped(number, size, right.node)
    is_wrong = is_wrong or ((is_named or not given) and abs(number / size - 1) > _ROUGHLY)
    reason = f"with {' and '.join(texts)} it is {float(exact):.4g} in SI units"
    return Decision(REFUTED, reason) if there.status == REFUTED and is_wrong else None


def _unless_mistyped_speed(state: JudgingState, chain: Chain, verdict: Verdict) -> Verdict:
    """Return a verdict; ω = 268 1/s is refuted where the sentence or page has 6000 rpm only.

    Any other number is where it says the speed again: 3000 rpm, that is ω = 300 1/s.
    """
    head, right, line = chain.sides[0].node, chain.sides[1].node, chain.lines[0]
    if not isinstance(head, Name) or not is_lone_number(right):
        return verdict
    knowledge = state.knowledge(line)
    speed = _speed(state, chain, head.name, knowledge)
    if speed is None or not is_angular_speed(head.name, knowledge.meanings):
        return verdict
    typed, exact = number_of(right, knowledge), number_of(speed[0], knowledge)
    if not typed or not exact:
        return verdict
    number, size = abs(float(typed)), float(exact)
    before = state.document.text[max(0, chain.start - LONGEST_SENTENCE) : chain.start]
    is_restated = speed_restated(before) is not None
    is_wrong = is_mistyped(number, size, right) or (is_restated and abs(number / size - 1) > _ROUGHLY)
    if not is_wrong:
        return verdict
    state.definitions.forget(head.name, line)
    reason = f"{speed[1]} it is {float(exact):.4g} 1/s"
    return describe(state.document, chain, 0, Decision(REFUTED, reason))


def _sizes(
    state: JudgingState, chain: Chain, node: Formula, free: set[str], knowledge: Knowledge
) -> Iterator[tuple[str, tuple[Formula, str]]]:
    """Yield for a formula's letters without a value the size that each is by the page's words."""
    here = _here(state, chain)
    for name in sorted(free):
        meaning = knowledge.meanings.get(name, "")
        usual = [role for role in here if name in LETTERS[role] and not meaning]
        roles = usual or [r for r in here if role_of(meaning) == r or is_called(r, meaning)]
        stroke = here.get("stroke")
        if roles:
            size = here[roles[0]]
            yield name, (size.number, f"{plain_text(Name(name))} the {roles[0]} (“{size.text}”)")
        elif name in LETTERS["crank radius"] and stroke is not None:
            half = Number(stroke.number.value / 2)
            yield name, (half, f"{plain_text(Name(name))} half the stroke (“{stroke.text}”)")
        elif (speed := _speed(state, chain, name, knowledge)) is not None:
            is_counted = name in _TURNS and not _BY_THE_MINUTE.isdisjoint(walk(node))
            is_counted = is_counted and role_of(meaning) != BY_MINUTE
            yield name, (Product((speed[0], Number(Fraction(60)))) if is_counted else speed[0], speed[1])


def _here(state: JudgingState, chain: Chain) -> dict[str, SizeOfPage]:
    """Return the sizes in the page's words that are of the engine which a relation is of."""
    sections, start = state.sections, state.sections.paragraph_start(chain.lines[0])
    found = sizes_of_page(state.document.text)
    return {
        role: size
        for role, size in found.items()
        if sections.paragraph_start(size.line) == start
        or not sections.is_of_another_engine(chain, size.line)
    }


def _by_products(state: JudgingState, chain: Chain, free: set[str]) -> dict[str, tuple[Formula, str]]:
    """Return letters by the products that have a number above: m by m r = 20.7 kg mm, whatever r is."""
    found: dict[str, tuple[Formula, str]] = {}
    for above in reversed(state.sections.in_order):
        product, last = above.sides[0].node, above.sides[-1]
        if (
            above.start >= chain.start
            or not isinstance(product, Product)
            or not is_lone_number(last.node)
        ):
            continue
        letters = [
            f.name for f in product.factors if isinstance(f, Name) and f.name in free - found.keys()
        ]
        is_here = state.sections.same_section(above.lines[0], chain.lines[0])
        if not letters or not is_here or last.span[0] in state.refuted:
            continue
        rest = [factor for factor in product.factors if factor != Name(letters[0])]
        if len(rest) == len(product.factors) - 1:
            text = f"{plain_text(product)} of line {above.lines[0]}"
            found[letters[0]] = Quotient(last.node, Product(tuple(rest))), text
    return found


def _with_values(line: int, values: dict[str, Formula], knowledge: Knowledge) -> Knowledge:
    for name, node in sorted(values.items()):
        knowledge = knowledge.with_definition(name, Definition(node, line, True))
    return knowledge


def _free(node: Formula, knowledge: Knowledge) -> set[str]:
    """Return the letters behind a formula that no line gives a number or a formula."""
    values = {**knowledge.meaning.values, **{n: d.node for n, d in knowledge.definitions.items()}}
    return {*names_behind(node, values)} - values.keys()


def _speed(
    state: JudgingState, chain: Chain, name: str, knowledge: Knowledge
) -> tuple[Formula, str] | None:
    """Return the one speed that the sentence of a relation names, or else the whole page."""
    words = state.sections.sentence_leading_to(chain)
    speeds = speeds_of(words) or speeds_of(state.document.text)
    is_turns, is_angular = name in _TURNS, is_angular_speed(name, knowledge.meanings)
    if len(speeds) != 1 or not (is_turns or is_angular):
        return None
    (speed,) = speeds
    text = f"{plain_text(Name(name))} by the {speed} revolutions per minute named"
    if is_angular:
        return Product((Constant("pi"), Number(Fraction(speed, 30)))), text
    is_by_minute = role_of(knowledge.meanings.get(name, "")) == BY_MINUTE
    return Number(Fraction(speed, 1 if is_by_minute else 60)), text
