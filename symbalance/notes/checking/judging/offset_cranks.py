"""Nothing is accused by the motion of a centred crank where a page declares an offset.

Where the cylinder's axis passes the crank at a distance e, sin β = (r sin θ - e)/l, the stroke is longer
than 2r, and the piston's motion has terms in e that the geometry of this checker does not know.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Name
from symbalance.notes.checking.declared.symbol_roles import HARMONIC, MOVING, role_of
from symbalance.notes.checking.judging.unknown_crank_angle import names_rested_on
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OFFSET = re.compile(
    r"(?:(?<![a-z])offset of (?:the )?(?:cylinder axis|cylinder(?!s)|crank|piston|bore|gudgeon|wrist)"
    r"|(?:crank|piston|pin|bore|cylinder axis) offset|eccentricity of the (?:cylinder|slider)"
    r"|desachsierung|schränkung|オフセット)",
    re.IGNORECASE,
)
_OF_A_CENTRED_CRANK = {*MOVING, "rod angle", "stroke"}


def unless_offset(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; one against a centred crank's motion is undecided where a page has an offset."""
    if verdict.verdict not in (REFUTED, CONTRADICTION):
        return verdict
    symbols = state.declarations.symbols_at(chain.lines[0])
    offset = next((name for name, text in symbols.items() if _OFFSET.search(text)), "")
    if not offset:
        return verdict
    given = state.knowledge(chain.lines[0]).definitions.keys()
    moved = {name for name, text in symbols.items() if _is_of_centred(text)} - given
    if moved.isdisjoint(name.rstrip("'") for name in names_rested_on(state, chain, k)):
        return verdict
    reason = (
        f"the cylinder is offset by {plain_text(Name(offset))}: only the motion of a centred one is known"
    )
    return replace(
        verdict, verdict=UNDECIDED, reason=reason, fix=None, witness={}, differences=(), decision=None
    )


def _is_of_centred(text: str) -> bool:
    role = role_of(text)
    return role in _OF_A_CENTRED_CRANK or HARMONIC.match(role) is not None
