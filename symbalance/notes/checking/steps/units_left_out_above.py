"""Numbers whose unit the lines above leave out: σ = (92.3 - 20)/2 = 36.15, and σ = 36.15 MPa below.

The same digits with another prefix are a slip of the unit where one was given before. Where neither the
number nor what it is computed from has a unit, the line that gives one says what they are in, unless
words said otherwise: all stresses in kPa.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.cases import UNITS_LEFT_OUT
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.checking.units.dimensions import unit_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_COMMAND = re.compile(r"\\(?:[dt]?frac|cdot|times|left|right|approx|sqrt|quad|qquad|pi)(?![A-Za-z])")
_UNIT = re.compile(r"[^\W\d_]|[°%]")
_IN_WORDS = re.compile(r"(?:\b[Ii]n |[\[(])\$?(?P<unit>[A-Za-zµ/·²³^0-9]{1,12})(?![A-Za-z])")
"""A unit in words: all lengths in mm, stresses (MPa)."""
_UNIT_OF_LETTER = re.compile(r"(?:\bin |[\[(])(?P<unit>[A-Za-zµ/·²³^0-9]{1,12})[\])]?$")


def unless_unit_left_out(state: JudgingState, chain: Chain, verdict: Verdict) -> Verdict:
    """Return a verdict on digits given above with another prefix; they hold if none was given there."""
    head = chain.sides[0].node
    if (
        not isinstance(head, Name)
        or _has_unit_above(state, chain, head)
        or _is_against_words(state, chain)
    ):
        return verdict
    return describe(state.document, chain, 0, Decision(PROVED, UNITS_LEFT_OUT))


def _is_against_words(state: JudgingState, chain: Chain) -> bool:
    """Tell whether words above name another unit of the same kind than the one of a number."""
    quantity = quantity_of(chain.sides[1], state.document)
    if quantity is None:
        return True
    above = (match["unit"] for match in _IN_WORDS.finditer(state.document.text, 0, chain.start))
    kinds = [unit for unit in above if unit_of(unit) == unit_of(quantity.unit) is not None]
    return any(scale_of(unit) != scale_of(quantity.unit) for unit in kinds)


def _has_unit_above(state: JudgingState, chain: Chain, head: Name) -> bool:
    """Tell whether a letter, or one that its number rests on, has a unit above, or may have one."""
    symbols = state.declarations.symbols_at(chain.lines[0])
    wanted, seen = [head.name], set[str]()
    while wanted:
        name = wanted.pop()
        seen.add(name)
        above = state.sections.chains_above(Name(name), chain.start)
        stated = _UNIT_OF_LETTER.search(symbols.get(name, ""))
        if not above or (stated is not None and scale_of(stated["unit"]) is not None):
            return True
        for side in (side for each in above for side in each.sides[1:]):
            letters = names(side.node)
            wanted += [letter for letter in letters - seen if letter not in wanted]
            source = _COMMAND.sub(" ", state.document.source(side.span))
            if not letters and _UNIT.search(source):
                return True
    return False
