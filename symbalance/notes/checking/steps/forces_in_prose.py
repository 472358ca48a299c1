"""Forces that a sentence has as formulas alone, and what the next one makes of them.

Of "$A$ along and $B$ across the line of stroke" the resultant is √(A² + B²). Two shafts, "each with the
unbalance $m_s r_s$, turning at $2ω$", that "must cancel $4λ m r ω²$" have 2 m_s r_s (2ω)² = 4λ m r ω².
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Number, Power, Product, Sum, names, walk
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.deciding.values_at_points import solved_at, value_at
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.formulas_typed import formula_typed
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_JUDGED = (CONDITION, DEFINITION, PREMISE, UNDECIDED)
_ALONG = (
    r"(?:along|in\s+(?:line\s+with|the\s+direction\s+of)|parallel|horizontal\w*|vertical\w*|längs|in\s+Richtung|waagerecht\w*|senkrecht\w*|lotrecht\w*"
    r"|suivant|le\s+long|selon|lungo|orizzontal\w+|verticale?|a\s+lo\s+largo)"
)
_ACROSS = (
    r"(?:across|perpendicular\w*|at\s+right\s+angles|normal|transverse\w*|horizontal\w*|vertical\w*|quer|senkrecht\w*|rechtwinklig|waagerecht\w*|lotrecht\w*"
    r"|perpendiculaire\w*|transversal\w*|trasversal\w*|perpendicolar\w*|ortogonal\w*)"
)
_COMPONENTS = re.compile(
    rf"\$(?P<first>[^$=<>≈]{{3,80}})\$\s+(?P<one>{_ALONG})[^$.;=]{{0,60}}?(?:,|and|und|et|e|y|,\s*and)\s+(?:[^\W\d_]+\s+){{0,2}}\$(?P<second>[^$=<>≈]{{3,80}})\$\s+"
    rf"(?:[^\W\d_]+\s+){{0,2}}(?P<other>{_ACROSS})",
    re.IGNORECASE,
)
"""Two components in a sentence, each with its direction."""
_RESULTANT = re.compile(
    r"resultant|resultierende|résultante|risultante|resultante|total|gesamt|合力", re.IGNORECASE
)
_SHAFTS = re.compile(
    r"(?<![^\W\d_])(?:two|a\s+pair\s+of|zwei|deux|due|dos)(?![^\W\d_])[^.;]{0,60}?(?:shafts?|wellen|arbres|alberi|ejes|árboles)|(?:2|二|2つの)[^。]{0,20}軸",
    re.IGNORECASE,
)
_EACH = re.compile(
    r"(?<![^\W\d_])(?:each|je|jede[rsnm]?|chacun\w*|ciascun\w*|ognun\w*|cada)(?![^\W\d_])|それぞれ|各",
    re.IGNORECASE,
)
_UNBALANCE = re.compile(
    r"(?:unbalance|out-of-balance|mass\s+moment|Unwucht|balourd|squilibrio|sbilanciamento|desequilibrio|desbalance|不つ[りい]合い|不釣合い)\s+(?:of\s+|von\s+|de\s+|di\s+)?\$(?P<moment>[^$=<>≈]{2,40})\$",
    re.IGNORECASE,
)
_SPEED = re.compile(r"\$(?P<speed>[0-9]?\s*\\omega|\\Omega)\$")
_CANCELLED = re.compile(
    r"(?<![^\W\d_])(?:cancel|balance|counteract|compensate|neutrali[sz]e|annuler|équilibrer|compenser|annullare|equilibrare|compensare|anular|equilibrar|compensar)\s+(?:[^$.;=]{0,80}?)\$(?P<behind>[^$=<>≈]{3,80})\$"
    r"|\$(?P<before>[^$=<>≈]{3,80})\$\s*(?:zu\s+)?(?:tilgen|ausgleichen|auszugleichen|aufheben|kompensieren|を打ち消)",
    re.IGNORECASE,
)
"""The force that shafts are there to cancel."""
_OTHER = re.compile(
    r"(?<![^\W\d_])(?:only|half|part|partly|both\s+together|nur|halb\w*|teilweise|seulement|moitié|solo|metà|mitad|sólo)(?![^\W\d_])|半分|だけ",
    re.IGNORECASE,
)
_POINTS = (
    (0.31, 0.43, 1.7, 1.2, 0.9, 2.3, 1.4),
    (0.62, 0.23, 1.3, 2.1, 1.6, 0.8, 2.7),
    (0.17, 0.71, 2.2, 0.7, 1.1, 1.9, 0.6),
)
_LETTER = re.compile(r"(?<![A-Za-z])[A-Za-z](?:_[A-Za-z0-9])?(?![A-Za-z])|lambda|varepsilon|epsilon")
_NEAR = 700
_CLOSE, _ROUNDED = 1e-9, 0.01
_TWO = Number(Fraction(2))


def unless_against_forces(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; that on what a formula makes of the forces that stand alone in the prose."""
    left, right = chain.sides[0].node, chain.sides[1].node
    is_formula = not k and bool(names(left) and names(right)) and chain.relations[0].sign in "=≈"
    if not is_formula or verdict.verdict not in _JUDGED:
        return verdict
    text, sentence = _words(state, chain), state.sections.sentence_leading_to(chain)
    if _OTHER.search(sentence):
        return verdict
    outcomes = [*_as_resultant(chain, text, sentence)] or [*_as_cancelled(chain, text)]
    if len(outcomes) < len(_POINTS):
        return verdict
    if all(outcomes):
        said = Decision(PROVED, assumptions=("the forces are those of the sentence before",))
        return describe(state.document, chain, k, said)
    if any(outcomes):
        return verdict
    if isinstance(left, Name):
        state.definitions.forget(left.name, chain.lines[0])
    return describe(
        state.document, chain, k, Decision(REFUTED, "not what the forces in words above give")
    )


def _words(state: JudgingState, chain: Chain) -> str:
    """Return the paragraph of a relation before it."""
    sections = state.sections
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    return state.document.text[max(min(first, chain.start), chain.start - _NEAR) : chain.start]


def _as_resultant(chain: Chain, text: str, sentence: str) -> Iterator[bool]:
    """Yield at some points whether a formula is the resultant of two components in words."""
    found = [*_COMPONENTS.finditer(text)]
    head, right = chain.sides[0].node, chain.sides[1].node
    if len(found) != 1 or not isinstance(head, Name) or not _RESULTANT.search(sentence):
        return
    if found[0]["one"].lower() == found[0]["other"].lower():
        return
    parts = [formula_typed(found[0][name], chain.letters) for name in ("first", "second")]
    if parts[0] is None or parts[1] is None or head.name in names(right):
        return
    square = Sum(tuple(Power(part, _TWO) for part in parts if part is not None))
    letters = sorted(names(square) | names(right))
    for values in _values(letters):
        total, claimed = value_at(square, values), value_at(right, values)
        if total is None or claimed is None:
            return
        yield math.isclose(math.sqrt(total), claimed, rel_tol=_CLOSE)


def _as_cancelled(chain: Chain, text: str) -> Iterator[bool]:
    """Yield at some points whether an equation is what two shafts that cancel a force need."""
    moment, speed, force = (_only(pattern, text) for pattern in (_UNBALANCE, _SPEED, _CANCELLED))
    is_said = _SHAFTS.search(text) is not None and _EACH.search(text) is not None
    if not is_said or not moment or not speed or not force:
        return
    letters = (
        chain.letters | {*_LETTER.findall(force.replace("\\", " "))} | {"omega", "theta", "varphi", "phi"}
    )
    nodes = [formula_typed(typed, frozenset(letters)) for typed in (moment, speed, force)]
    if nodes[0] is None or nodes[1] is None or nodes[2] is None:
        return
    law = Product((_TWO, nodes[0], Power(nodes[1], _TWO))), _amplitude(nodes[2])
    sought = sorted(names(nodes[0]) & chain.letters)
    if not sought or not chain.letters <= names(law[0]) | names(law[1]):
        return
    others = sorted((names(law[0]) | names(law[1])) - {sought[0]})
    for values in _values(others):
        solved = solved_at(law, sought[0], values)
        if solved is None:
            return
        sides = [value_at(side.node, {**values, sought[0]: solved}) for side in chain.sides[:2]]
        if sides[0] is None or sides[1] is None:
            return
        yield math.isclose(sides[0], sides[1], rel_tol=_ROUNDED)


def _only(pattern: re.Pattern[str], text: str) -> str:
    """Return the one formula that a pattern finds in a text, "" for none or several."""
    found = {next(filter(None, match.groups())).strip() for match in pattern.finditer(text)}
    return found.pop() if len(found) == 1 else ""


def _amplitude(force: Formula) -> Formula:
    """Return a force at its largest: without the cosine of its angle."""
    for part in walk(force):
        if isinstance(part, Call) and part.function in ("cos", "sin"):
            return replace_part(force, part, Number(Fraction(1)))
    return force


def _values(letters: list[str]) -> Iterator[dict[str, float]]:
    for point in _POINTS:
        if len(letters) <= len(point):
            yield dict(zip(letters, point, strict=False))
