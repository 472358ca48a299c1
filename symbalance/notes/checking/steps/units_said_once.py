"""Units that a page gives once for all its numbers: "All lengths are in mm", and then r = 50.

The numbers behind such words stand without their units. What is computed from them with another unit,
5000 N m for 100 N times 50, is neither proved nor refuted by the bare numbers.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import product

from symbalance.document.formula import Formula, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import Dimensions, written_unit
from symbalance.notes.checking.units.own_units import is_per_minute_number
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
_FURTHER = re.compile(
    r"(?:\s*,\s*(?:[^\W\d_]+\s+in\s+)?|\s+(?:and|und|et|e|y)\s+(?:[^\W\d_]+\s+in\s+)?)[A-Za-zµ]{1,4}(?![^\W\d_])"
)
"""A second unit behind the first: lengths in mm, forces in N; data in mm and N."""
_UNIT_WORD = re.compile(r"[A-Za-zµ]{1,4}(?![^\W\d_])$")
_MOST = 4
"""Letters without a unit that are tried with those of the words."""
_JUDGED = (*PROVED_WORDS, REFUTED, CONTRADICTION)


def unless_units_said_once(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; undecided for a quantity from numbers whose units the page gives in words."""
    left, right = chain.sides[k].node, chain.sides[k + 1]
    if verdict.verdict not in _JUDGED or names(right.node) or not names(left):
        return verdict
    unit = written_unit(state.document.source(right.span))[1]
    bare = _bare_letters(state, chain, left) if unit else ()
    words, units = _words_before(state, chain, bare) if 0 < len(bare) <= _MOST else ("", ())
    if not units or not _want_units(state, chain, k, bare, units):
        return verdict
    shown = " and ".join(map(plain_letter, bare))
    reason = f"no unit stands behind the value of {shown}, but in words (“{words}”): write it there"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _want_units(
    state: JudgingState, chain: Chain, k: int, bare: tuple[str, ...], units: tuple[str, ...]
) -> bool:
    """Tell whether a result has its unit if bare numbers have those of the words, and not without."""
    return not _fits(state, chain, k, dict.fromkeys(bare, "")) and any(
        _fits(state, chain, k, dict(zip(bare, given, strict=True)))
        for given in product(("", *units), repeat=len(bare))
    )


def _bare_letters(state: JudgingState, chain: Chain, node: Formula) -> tuple[str, ...]:
    """Return the letters behind a formula whose numbers are typed without a unit."""
    known = state.knowledge(chain.lines[0]).definitions
    values = {name: definition.node for name, definition in known.items()}
    behind = {*names(node), *names_behind(node, values)} & values.keys()
    return tuple(sorted(name for name in behind if _is_bare(state, values[name])))


def _fits(state: JudgingState, chain: Chain, k: int, given: dict[str, str]) -> bool:
    """Tell whether a result has its unit where bare letters have these units, "" for pure numbers."""
    known = state.knowledge(chain.lines[0]).definitions
    values = {name: d.node for name, d in known.items() if name not in given}
    symbols = {**state.definitions.declarations.symbols_at(chain.lines[0])}
    symbols |= {name: f"size, {unit}" for name, unit in given.items() if unit}
    plain = frozenset(name for name, unit in given.items() if not unit)
    dimensions = Dimensions(symbols, values, state.document.text, plain=plain)
    first, second = chain.sides[k], chain.sides[k + 1]
    sources = (state.document.source(first.span), state.document.source(second.span))
    return dimensions.mismatch(first.node, second.node, sources) is None


def _is_bare(state: JudgingState, node: Formula) -> bool:
    """Tell whether a letter's value is a number typed without a unit, and no ratio or count by words."""
    has_number, unit = written_unit(state.document.source(node.span))
    is_rate = is_per_minute_number(node, state.document.text)  # 3,000 rev/min
    return not names(node) and has_number and not unit and not is_rate


def _words_before(
    state: JudgingState, chain: Chain, bare: tuple[str, ...]
) -> tuple[str, tuple[str, ...]]:
    """Return the words above a relation that give numbers, or these letters, units, and the units."""
    for end, words, units in _units_said(state.document.text):
        if end <= chain.start:
            return words, units
    own = {*bare, *map(plain_letter, bare)}
    said = (unit for sign, unit in state.named.units.every if sign in own)
    near = next((unit for unit in said if unit.place < chain.start), None)
    return (f"in {near.text}", (near.text,)) if near is not None else ("", ())


@lru_cache(maxsize=8)
def _units_said(text: str) -> tuple[tuple[int, str, tuple[str, ...]], ...]:
    """Return where words end that give all numbers of a text their units, the words, and the units."""
    found: list[tuple[int, str, tuple[str, ...]]] = []
    for match in _SAID_ONCE.finditer(text):
        further = _FURTHER.match(text, match.end())
        words = [match["unit"], *(_UNIT_WORD.findall(further[0]) if further else ())]
        if units := tuple(filter(None, map(unit_in_words, words))):
            found.append((match.end(), " ".join(match[0].split()), units))
    return tuple(found)
