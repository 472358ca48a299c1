r"""The amplitude of a cosine and a sine of one angle: √(a² + b²) of a cos θ + b sin θ, and no a + b.

The paragraph has the sum of the two, and words call a letter its amplitude, or a cosine with that letter
before it stands there too. From such a cosine the tangent of its phase is known as well: b/a of
c cos(θ - ψ).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from symbalance.document.formula import Call, Formula, Name, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.values_at_points import value_at
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading import ReadingError, canonical_name
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_AMPLITUDE = re.compile(
    r"(?<![^\W\d_])(?:(?:its|the|resulting|common|whose|die|ihre|deren|resultierende|son|leur|l['’]|la\s+(?:sua|loro)|la|su)\s*)?"
    r"(?:amplitudes?|ampiezza|amplitud)(?![^\W\d_])|振幅",
    re.IGNORECASE,
)
_OTHERWISE = re.compile(
    r"(?<![^\W\d_])(?:peak[- ]to[- ]peak|double|twice|half|each|both|complex|squared?|square\s+of"
    r"|power|rms|effective|mean|normali[sz]ed|relative|bound|at\s+most"
    r"|doppelte?|halbe?|jede[rs]?|beide[rn]?|komplexe?|quadrat\w*|effektiv\w*|bezogen\w*|höchstens|carré|chaque|complexe|efficace|quadrato|ciascun\w*|complessa"
    r"|efficace|cuadrado|cada|compleja|eficaz)(?![^\W\d_])|二乗|複素|実効|それぞれ|全振幅",
    re.IGNORECASE,
)
"""Words of another size than the amplitude of the sum."""
_LETTER = r"\\?[A-Za-z]+(?:_(?:\{\w{1,4}\}|\w))?'?"
_ANGLE = r"\(?[0-9]?(?:\\?[A-Za-z]+(?:_\w)? ?){1,3}\)?"
_MARKS = re.compile(r"\\(?:[,;:! ]|(?:left|right|cdot|bigl?|bigr?)(?![A-Za-z]))|[~·]")
_GAP = re.compile(r"\s+(?![A-Za-z])|(?<![A-Za-z])\s+")
"""Spaces that part no letters."""
_SUM = re.compile(
    rf"(?<![\w\\}})^_-])(?P<first>{_LETTER}) ?\\(?P<one>cos"
    rf"|sin) ?(?P<angle>{_ANGLE})(?P<sign>[+-])(?P<second>{_LETTER})"
    rf"\\(?P<other>cos|sin) ?(?P=angle)(?![A-Za-z0-9+^-])"
)
"""The sum of a cosine and a sine, each with a letter before it, and nothing else."""
_ONE = re.compile(
    rf"(?<![\w\\}})^_])(?P<size>{_LETTER})\\(?P<function>cos|sin)\((?P<angle>{_ANGLE})(?P<sign>[+-])(?P<phase>{_LETTER})\)"
)
"""One cosine or sine with a phase."""
_SPACES = re.compile(r"\s+")
_NEAR = 500
_POINTS = ((1.3, 2.1), (0.7, 0.4), (3.2, 1.9))
_CLOSE = 1e-6


@dataclass(frozen=True, slots=True)
class _Parts:
    """The letters before a cosine and a sine of one angle, and the signs with which they stand."""

    cosine: str
    sine: str
    sine_sign: int
    angle: str


def unless_of_two_parts(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted for a wrong amplitude or phase of a cosine and a sine in one."""
    head, right = chain.sides[0].node, chain.sides[1].node
    is_open = verdict.verdict in (DEFINITION, PREMISE, UNDECIDED, CONDITION)
    is_phase = isinstance(head, Call) and head.function == "tan" and isinstance(head.argument, Name)
    if k or not is_open or not (isinstance(head, Name) or is_phase) or len(names(right)) != 2:
        return verdict
    if chain.relations[0].sign != "=":
        return verdict
    start = state.sections.start_of_line(state.sections.paragraph_start(chain.lines[0]))
    text = state.document.text[max(min(start, chain.start), chain.start - _NEAR) : chain.start]
    if "\\sin" not in text or "\\cos" not in text:
        return verdict
    plain = _SPACES.sub(" ", _GAP.sub("", _MARKS.sub(" ", text)))
    parts = _parts(plain, names(right))
    if parts is None:
        return verdict
    if isinstance(head, Name):
        sentence = state.sections.sentence_before(chain)
        reason = _wrong_amplitude(plain, parts, head.name, right, sentence)
    else:
        reason = _wrong_phase(plain, parts, head, right)
    return describe(state.document, chain, k, Decision(REFUTED, reason)) if reason else verdict


def _parts(text: str, own: frozenset[str]) -> _Parts | None:
    """Return the one sum of a text that has a formula's letters; None for none or several."""
    found: set[_Parts] = set()
    for match in _SUM.finditer(text):
        if match["one"] == match["other"]:
            continue
        first, second = _name(match["first"]), _name(match["second"])
        sign = -1 if match["sign"] == "-" else 1
        if match["one"] == "cos":
            found.add(_Parts(first, second, sign, match["angle"]))
        elif sign > 0:
            found.add(_Parts(second, first, 1, match["angle"]))
    (parts,) = found if len(found) == 1 else (None,)
    return parts if parts is not None and {parts.cosine, parts.sine} == own else None


def _name(sign: str) -> str:
    try:
        return canonical_name(sign.lstrip("\\").replace("{", "").replace("}", ""))
    except ReadingError:
        return ""


def _wrong_amplitude(text: str, parts: _Parts, name: str, right: Formula, sentence: str) -> str:
    """Return why a formula is no amplitude of two parts; "" where it is, or may be another size."""
    if _OTHERWISE.search(sentence):
        return ""
    is_named = _AMPLITUDE.search(sentence) is not None
    is_shown = any(_name(match["size"]) == name for match in _ONE.finditer(text))
    if not is_named and not is_shown:
        return ""
    values = [(value_at(right, _at(parts, *pair)), math.hypot(*pair)) for pair in _POINTS]
    real = [(abs(value), size) for value, size in values if value is not None]
    if not real or any(math.isclose(value, size, rel_tol=_CLOSE) for value, size in real):
        return ""
    letters = " + ".join(f"{plain_letter(letter)}^2" for letter in (parts.cosine, parts.sine))
    return f"the amplitude of a cosine and a sine of one angle is sqrt({letters})"


def _wrong_phase(text: str, parts: _Parts, head: Formula, right: Formula) -> str:
    """Return why a formula is not the tangent of the phase of two parts; "" where it may be."""
    phase = head.argument.name if isinstance(head, Call) and isinstance(head.argument, Name) else ""
    shown = [match for match in _ONE.finditer(text) if _name(match["phase"]) == phase]
    forms = {(match["function"], match["sign"]) for match in shown if match["angle"] == parts.angle}
    if len(forms) != 1 or not phase:
        return ""
    ((function, sign),) = forms
    for pair in _POINTS:
        value = value_at(right, _at(parts, *pair))
        ratio = parts.sine_sign * pair[1] / pair[0]
        tangent = ratio if function == "cos" else 1 / ratio
        tangent *= 1 if (function, sign) in (("cos", "-"), ("sin", "+")) else -1
        if value is None or math.isclose(value, tangent, rel_tol=_CLOSE):
            return ""
    one, other = (parts.sine, parts.cosine) if function == "cos" else (parts.cosine, parts.sine)
    return f"the tangent of this phase is {plain_letter(one)}/{plain_letter(other)} but for its sign"


def _at(parts: _Parts, cosine: float, sine: float) -> dict[str, float]:
    return {parts.cosine: cosine, parts.sine: sine}
