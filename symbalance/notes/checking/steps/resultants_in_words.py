r"""Resultants of perpendicular components that are summed as if they were in line: F = F_x + F_y.

Words call the letter a resultant, and its two terms perpendicular, or their subscripts are those
of two axes. Its square is the sum of theirs. As vectors they may well be added.
"""

from __future__ import annotations

from symbalance.document.formula import Formula, Name, Sum
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_RESULTANT = re.compile(
    r"(?<![^\W\d_])(?:resultant|resulting|magnitude|resultierende[nrsm]?|resultante|betrag|résultante|module|norme|risultante|modulo"
    r"|resultante|módulo)(?![^\W\d_])|合力|大きさ",
    re.IGNORECASE,
)
_PERPENDICULAR = re.compile(
    r"(?<![^\W\d_])(?:(?:perpendicular|orthogonal|rectangular)\s+(?:components?|forces?|velocit\w+|accelerations?|parts)"
    r"|(?:(?:are|stand|act|is)\s+)(?:mutually\s+)?(?:perpendicular|orthogonal)(?!\s+(?:to|on)\s+(?!(?:each|one)\s))"
    r"|(?:perpendicular|orthogonal)\s+to\s+(?:each\s+other|one\s+another)|at\s+right\s+angles(?!\s+to\s+(?!(?:each|one)\s))"
    r"|(?:rechtwinklige|senkrechte|orthogonale)n?\s+(?:komponenten|kräfte|anteile)|(?:senkrecht|rechtwinklig)\s+(?:zueinander|aufeinander)"
    r"|(?:zueinander|aufeinander)\s+(?:senkrecht|rechtwinklig)\w*|(?:composantes|forces)\s+(?:perpendiculaires|orthogonales)"
    r"|perpendiculaires\s+(?:entre\s+elles|l'une\s+à\s+l'autre)|(?:componenti|forze)\s+(?:perpendicolari|ortogonali)|perpendicolari\s+tra\s+loro"
    r"|(?:componentes|fuerzas)\s+(?:perpendiculares|ortogonales)|perpendiculares\s+entre\s+sí)(?![^\W\d_])|直交する|直角をなす|直角な",
    re.IGNORECASE,
)
"""Components that are perpendicular to each other, and not all of them to something else."""
_VECTOR = re.compile(
    r"\\(?:vec|mathbf|boldsymbol|bm|overrightarrow)(?![A-Za-z])|(?<![^\W\d_])(?:vector\w*|vektor\w*|geometri\w+|vectoriel\w*|vettor\w*)"
    r"|ベクトル",
    re.IGNORECASE,
)
_AXES = ({"x", "y"}, {"h", "v"}, {"x", "z"}, {"y", "z"}, {"H", "V"})
"""Subscripts of two components that are perpendicular by their names."""
_REACH = 240


def unless_perpendicular(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where a resultant is the plain sum of two perpendicular components."""
    if k or verdict.verdict not in (DEFINITION, PREMISE, UNDECIDED) or chain.relations[0].sign != "=":
        return verdict
    terms = _two_letters(chain.sides[1].node)
    if terms is None or not isinstance(chain.sides[0].node, Name):
        return verdict
    sentence = state.sections.sentence_before(chain)[-_REACH:]
    if _RESULTANT.search(sentence) is None or _VECTOR.search(sentence):
        return verdict
    if _VECTOR.search(state.document.source(chain.sides[1].span)):
        return verdict
    words = state.document.text[max(0, chain.start - _REACH) : chain.start]
    words = re.split(r"\n\s*\n", words)[-1]
    subscripts = {name.partition("_")[2] for name in terms}
    if _PERPENDICULAR.search(words) is None and subscripts not in _AXES:
        return verdict
    squares = " + ".join(f"{plain_letter(name)}^2" for name in terms)
    reason = f"of perpendicular components it is sqrt({squares})"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _two_letters(node: Formula) -> tuple[str, str] | None:
    """Return the two letters of which a formula is the plain sum; None for others."""
    if not isinstance(node, Sum) or len(node.terms) != 2:
        return None
    first, second = node.terms
    if not isinstance(first, Name) or not isinstance(second, Name):
        return None
    return first.name, second.name
