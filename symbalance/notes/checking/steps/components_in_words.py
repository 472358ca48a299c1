r"""Components along and across a line, by the angle from it: along the line of stroke it is P cos θ.

The crank angle, and that of the rod, are counted from the line of stroke. So the component of a force
along that line has the cosine of such an angle, and the one across it the sine, wherever the angle is
declared as one from a dead centre, or as the rod's to the cylinder's axis.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Formula, Name, Product
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, Verdict
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_COMPONENT = (
    r"(?:components?|component\s+part|resolved\s+part|komponente|anteil|composante|componente|componenti|projection"
    r"|projektion)"
)
_LINE = (
    r"(?:line|axis)\s+of\s+(?:the\s+)?(?:stroke|cylinder|piston)|stroke\s+line|(?:cylinder|bore|piston)\s+axis"
    r"|zylinderachse|hubrichtung|kolbenachse|axe\s+du\s+cylindre|asse\s+del\s+cilindro|eje\s+del\s+cilindro"
)
_ALONG = re.compile(
    rf"(?<![^\W\d_]){_COMPONENT}(?![^\W\d_])[^.;:]{{0,40}}?(?<![^\W\d_])(?:along|in\s+the\s+direction\s+of|parallel\s+to|in\s+richtung"
    rf"|längs|entlang|parallel\s+zur|suivant|selon|lungo|según|a\s+lo\s+largo\s+de)\s+(?:the\s+|de[rms]\s+|l'|el\s+|la\s+)?(?:{_LINE})"
    r"|(?:シリンダ(?:の)?(?:軸|中心線)|行程)(?:の)?方向の(?:成分|分力)",
    re.IGNORECASE,
)
_ACROSS = re.compile(
    rf"(?<![^\W\d_]){_COMPONENT}(?![^\W\d_])[^.;:]{{0,40}}?(?<![^\W\d_])(?:across|perpendicular\s+to|normal\s+to|at\s+right\s+angles\s+to"
    rf"|senkrecht\s+(?:auf|zu)|quer\s+zu|perpendiculaire\s+à|perpendicolare\s+a\w*|perpendicular\s+a)\s*"
    rf"(?:the\s+|de[rms]\s+|r\s+|l'|el\s+|la\s+)?(?:{_LINE})"
    r"|(?:シリンダ(?:の)?(?:軸|中心線))に(?:垂直|直角)な(?:方向の)?(?:成分|分力)",
    re.IGNORECASE,
)
"""What a component is along, or across."""
_FROM_LINE = re.compile(
    r"(?P<crank>(?:crank\s+angle|kurbelwinkel|クランク角).{0,40}(?:dead|\bOT\b|\bUT\b|totpunkt|\bTDC\b)|上死点.{0,20}クランク角)"
    r"|(?:rod|pleuel|連接棒|連桿).{0,50}(?:axis|line|achse|centre|軸|中心|傾)|obliquity|schwenkwinkel|schräglage",
    re.IGNORECASE,
)
"""Meanings of an angle that is counted from the line of stroke: the crank's, or the rod's."""
_OF_CRANK = re.compile(
    r"centrifugal|fliehkraft|zentrifugalkraft|centrifuge|centrifuga|centrífuga|遠心力", re.IGNORECASE
)
_OF_ROD = re.compile(
    r"(?:force|thrust|load)\s+(?:in|of|along|on)\s+the\s+(?:connecting\s+)?rod|rod\s+(?:force|thrust|load)|pleuelkraft|stangenkraft"
    r"|bielle|biella|biela|連接棒",
    re.IGNORECASE,
)
"""Forces that act along the crank, and along the rod."""


def unless_another_component(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where a component by its words has the other wave of its angle."""
    if k or verdict.verdict not in (DEFINITION, PREMISE) or chain.relations[0].sign not in "=≈":
        return verdict
    force = _force_and_wave(chain.sides[1].node)
    if force is None or not isinstance(chain.sides[0].node, Name):
        return verdict
    letter, wave = force
    angle = wave.argument.name if isinstance(wave.argument, Name) else ""
    symbols = state.declarations.symbols_at(chain.lines[0])
    words = state.sections.sentence_leading_to(chain).replace("$", "")
    counted = _FROM_LINE.search(symbols.get(angle, ""))
    acting = _OF_CRANK if counted is not None and counted["crank"] else _OF_ROD
    if counted is None or acting.search(symbols.get(letter, words)) is None:
        return verdict
    english = f"{words} {glossary_of(state.document.text).english(words)}"
    along, across = (pattern.search(english) is not None for pattern in (_ALONG, _ACROSS))
    right = "cos" if along else "sin"
    if along == across or wave.function == right:
        return verdict
    meant = f"{plain_letter(letter)} {right} {plain_letter(angle)}"
    way = "along" if along else "across"
    reason = f"{way} the line that {plain_letter(angle)} is counted from it is {meant}"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _force_and_wave(node: Formula) -> tuple[str, Call] | None:
    """Return the letter and the wave of which a formula is the product, P sin θ; None for others."""
    if not isinstance(node, Product) or len(node.factors) != 2:
        return None
    letters = [factor for factor in node.factors if isinstance(factor, Name)]
    waves = [
        factor
        for factor in node.factors
        if isinstance(factor, Call) and factor.function in ("sin", "cos")
    ]
    return (letters[0].name, waves[0]) if len(letters) == len(waves) == 1 else None
