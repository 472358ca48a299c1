"""Scales of diagrams: 1 mm = 50 N m says how long a torque is drawn, and is no equation of sizes.

One unit of length on paper stands for a quantity of another kind. What it stands for is the page's
choice, where it speaks of a scale or of a drawing; without such a word, 1 m = 1 s is false. Two lengths,
as in 1 cm = 10 mm, are a conversion and are judged.
"""

from __future__ import annotations

from symbalance.document.formula import names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import unit_of, written_unit
from symbalance.notes.checking.verdicts import PREMISE, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ONE_LENGTH = re.compile(r"\s*(?:\\SI\{)?1(?:[.,]0)?\s*(?:\\,|~|\}?\{)?\s*[\\A-Za-z]")
_DRAWN = re.compile(
    r"(?<![^\W\d_])(?:scales?|diagrams?|drawn|drawing|plotted|plots?|polygons?|ordinates?|abscissae?|axis|paper"
    r"|\w*ma(?:ß|ss)st[aä]be?\w*|\w*diagramm\w*|gezeichnet|aufgetragen|Papier"
    r"|échelles?|diagrammes?|tracés?|dessin\w*|escalas?|scala)(?![^\W\d_])|尺度|縮尺|目盛|線図|図",
    re.IGNORECASE,
)
_BEHIND = 40
"""Characters behind a relation in which a scale or a drawing may be named: "represents", "to scale"."""
_CIRCLE = re.compile(r"\s*\^\s*\{?\s*\\circ\s*\}?")
_SPACES = re.compile(r"\\[,;:! ]|~")


def unless_scale(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a premise for one unit of length that stands for another kind of quantity."""
    if k or verdict.verdict != REFUTED or len(chain.relations) != 1 or chain.relations[0].sign == "≠":
        return verdict
    sides = chain.sides
    sources = [_CIRCLE.sub("°", state.document.source(side.span)) for side in sides]
    if any(names(side.node) for side in sides) or not _ONE_LENGTH.match(sources[0]):
        return verdict
    units = [unit_of(written_unit(_SPACES.sub(" ", source))[1]) for source in sources]
    if units[0] != unit_of("m") or units[1] is None or units[1] == units[0]:
        return verdict
    text = state.document.text
    words = state.sections.sentence_before(chain) + text[chain.end : chain.end + _BEHIND]
    if not _DRAWN.search(words):
        return verdict
    return describe(state.document, chain, k, Decision(PREMISE, "the scale of a diagram"))
