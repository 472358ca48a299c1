"""Numbers that a page says were measured: "measured J_S = 0.0040 kg m²" is data beside any formula.

What a measurement gives beside a formula's value is no slip: often a page puts them side by side to show
the formula's error. From there on the letter has the measured number, and formulas for it are past.
"""

from __future__ import annotations

from symbalance.document.formula import Formula, names
from symbalance.notes.checking.deciding.equality import Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.verdicts import PREMISE
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

MEASURED = "measured"
"""What the reason of such a number begins with."""
_WORDS = (
    r"(?:measured|measuring|measurements?|weighed|weighing|experiments?|experimentally|data\s?sheet"
    r"|(?:from|in|by|on)\s+(?:an?\s+|the\s+)?(?:[a-z]+\s+)?tests?"
    r"|gemessen\w*|Messung|Messwert|gewogen\w*|Versuch|Prüfstand|Datenblatt|mesurée?s?|mesure)"
)
_BEFORE = re.compile(
    rf"(?:(?<![A-Za-z]){_WORDS}(?![A-Za-z])|測定|実測|計測|実験)[^=≈<>.;!?。]{{0,40}}$", re.IGNORECASE
)
_BEHIND = re.compile(
    rf"[\s$\\)]{{0,4}}(?:[^\s$=≈<>.;,()]{{1,8}}\s*){{0,3}}[,(（]\s*(?:as\s+|by\s+|from\s+|aus\s+|im\s+|am\s+)?(?:a\s+|the\s+|der\s+|dem\s+)?"
    rf"(?:{_WORDS}(?![A-Za-z])|測定|実測|計測|実験)",
    re.IGNORECASE,
)
_DENIED = re.compile(
    r"(?<![A-Za-z])(?:not|never|cannot|nicht|kein\w*|ohne|without|instead\s+of)(?![A-Za-z])",
    re.IGNORECASE,
)


def is_measured(definitions: Definitions, chain: Chain) -> bool:
    """Tell whether the words right before or behind a relation say that its number was measured."""
    before = definitions.sections.sentence_before(chain).rstrip(" $\\([\n")
    named = _BEFORE.search(before)
    if named is not None:
        return _DENIED.search(before) is None
    return _BEHIND.match(definitions.sections.document.text, chain.end) is not None


def define_measured(
    definitions: Definitions, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a measured number of a letter that formulas have another value for.

    None where nothing is measured, or where the number agrees with what the page has.
    """
    earlier = knowledge.definitions.get(name)
    if (
        k
        or names(value)
        or earlier is None
        or not names(earlier.node)
        or not is_measured(definitions, chain)
    ):
        return None
    if number_of(earlier.node, knowledge) is None:
        return None
    if decide(lone_side(earlier.node), lone_side(value), chain.relations[0].sign, knowledge).is_proved:
        return None
    definitions.lapse(name)
    definitions.define(name, without_dots(value)[0], chain)
    return Decision(PREMISE, f"{MEASURED}, beside what line {earlier.line} gives")
