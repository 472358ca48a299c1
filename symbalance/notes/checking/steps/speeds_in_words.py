"""Angular speeds put in for another engine speed that the words name: at 6000 rpm, ω r = 628.3·0.045.

The letter has the value of the page's usual speed; the number that is put in for it is 2π times the speed
per minute in the words before, and that is what ω is there. No other number is excused. A number that is
put in may be of a speed in the sentences before, a result only of one in its own.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import pi

from symbalance.document.formula import Constant, Formula, Name, Number, Product, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import paired, without_unit
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.meant.engine_speeds import speeds_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.own_units import is_angular_speed
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_FAR = 240
"""Characters before numbers put in, in which the speed stands that they are of: some three lines."""


def at_speed_in_words(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof of a refuted relation at the engine speed that its words name, or None."""
    left, right = chain.sides[k], chain.sides[k + 1]
    if names(right.node) or not names(left.node):
        return None
    pairs = paired(left.node, without_unit(right.node)) or ()
    words = state.sections.sentence_leading_to(chain)
    if pairs:
        words = state.document.text[max(0, chain.start - _FAR) : chain.start]
    for speed in sorted(speeds_of(words)):
        exact = Product((Constant("pi"), Number(Fraction(speed, 30))))
        put_in = [(part, number) for part, number in pairs if _is_rounded(number, pi * speed / 30)]
        if not pairs:  # a result: of any speed behind it
            values = {name: d.node for name, d in knowledge.definitions.items()}
            letters = {*names_behind(left.node, values)}
            put_in = [(Name(name), exact) for name in sorted(letters)]
        for letter, number in put_in:
            is_speed = isinstance(letter, Name) and is_angular_speed(letter.name, knowledge.meanings)
            if not is_speed or not isinstance(letter, Name) or letter.name not in knowledge.definitions:
                continue
            own = replace(
                knowledge.definitions[letter.name], node=number, numeric=True, rounded=None, assumption=""
            )
            known = knowledge.with_definition(letter.name, own)
            there = decide(left, right, chain.relations[k].sign, known)
            if there.is_proved:
                value = f"{plain_text(letter)} = {plain_text(number)}"
                text = f"{value} at the {speed} revolutions per minute named"
                return replace(there, assumptions=(*there.assumptions, text))
    return None


def _is_rounded(number: Formula, exact: float) -> bool:
    """Tell whether a number is another one to its last digit."""
    if not isinstance(number, Number):
        return False
    place = number.last_place if number.last_place is not None else Fraction(1)
    return abs(float(number.value) - exact) <= float(place) * 0.501
