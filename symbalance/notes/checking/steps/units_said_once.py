"""Units that a page gives once for all its numbers: "All lengths are in mm", and then r = 50.

The numbers behind such words stand without their units. What is computed from them with another unit,
5000 N m for 100 N times 50, is neither proved nor refuted by the bare numbers.
"""

from __future__ import annotations

from symbalance.document.formula import Formula, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.meant.letter_units import LetterUnits
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import Dimensions, written_unit
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.spellings.numerals import unit_in_words
from symbalance.text import lazy_patterns as re

_THINGS = (
    r"(?:lengths?|dimensions?|sizes?|distances?|radii|radius|data|masses|mass|forces|values|quantities|numbers|areas"
    r"|units|längen|maße|abmessungen|massen|kräfte|werte|radien|angaben|größen|longueurs|cotes|masses|forces|valeurs"
    r"|lunghezze|masse|forze|quote|longitudes|masas|fuerzas|medidas|長さ|寸法|質量|単位)"
)
_SAID_ONCE = re.compile(
    rf"(?<![^\W\d_]){_THINGS}(?:\s+(?:are|is|sind|ist|sont|sono|son|all|alle|given|measured|angegeben|gegeben|exprimées|here|hier))*"
    r"(?:\s+(?:in|en)\s+|はすべて|は|の単位は)\s?(?P<unit>[A-Za-zµ][^\s.,;:()]{0,14})",
    re.IGNORECASE,
)
_JUDGED = (*PROVED_WORDS, REFUTED, CONTRADICTION)


def unless_units_said_once(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; undecided for a quantity from numbers whose units the page gives in words."""
    left, right = chain.sides[k].node, chain.sides[k + 1]
    if verdict.verdict not in _JUDGED or names(right.node) or not names(left):
        return verdict
    unit = written_unit(state.document.source(right.span))[1]
    bare = _bare_letters(state, chain, left) if unit else ()
    words = _words_before(state, chain, bare) if bare else None
    if words is None or _are_pure_numbers(state, chain, k, frozenset(bare)):
        return verdict
    shown = " and ".join(map(plain_letter, bare))
    reason = f"no unit stands behind the value of {shown}, but in words (“{words}”): write it there"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _bare_letters(state: JudgingState, chain: Chain, node: Formula) -> tuple[str, ...]:
    """Return the letters behind a formula whose numbers are typed without a unit."""
    known = state.knowledge(chain.lines[0]).definitions
    values = {name: definition.node for name, definition in known.items()}
    behind = {*names(node), *names_behind(node, values)} & values.keys()
    return tuple(sorted(name for name in behind if _is_bare(state, values[name])))


def _are_pure_numbers(state: JudgingState, chain: Chain, k: int, bare: frozenset[str]) -> bool:
    """Tell whether a result has its unit if bare numbers have none: a ratio, a count."""
    known = state.knowledge(chain.lines[0]).definitions
    values = {name: d.node for name, d in known.items() if name not in bare}
    symbols = state.definitions.declarations.symbols_at(chain.lines[0])
    dimensions = Dimensions(symbols, values, state.document.text, plain=bare)
    first, second = chain.sides[k], chain.sides[k + 1]
    sources = (state.document.source(first.span), state.document.source(second.span))
    return dimensions.mismatch(first.node, second.node, sources) is None


def _is_bare(state: JudgingState, node: Formula) -> bool:
    """Tell whether a letter's value is a number typed without a unit, and no ratio or count by words."""
    has_number, unit = written_unit(state.document.source(node.span))
    return not names(node) and has_number and not unit


def _words_before(state: JudgingState, chain: Chain, bare: tuple[str, ...]) -> str | None:
    """Return the words above a relation that give all numbers, or one of these letters, their unit."""
    text = state.document.text
    for match in _SAID_ONCE.finditer(text, 0, chain.start):
        if unit_in_words(match["unit"]):
            return " ".join(match[0].split())
    own = {*bare, *map(plain_letter, bare)}
    units = (unit for sign, unit in LetterUnits(state.document).every if sign in own)
    return next((f"in {unit.text}" for unit in units if unit.place < chain.start), None)
