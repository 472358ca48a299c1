"""Roots that words tell from the others: the smaller one, the positive root, θ in the third quadrant.

An equation has them all, and the number that stands there solves it. It is wrong where it is not of the
kind that its own words name. So is a cosine whose sign the quadrant of its angle forbids.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from math import pi, sqrt

from symbalance.document.formula import Call, Formula, Name, Number, names, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.ranges_in_words import quarter_named
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, PROVED_WORDS, Verdict
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_THING = (
    r"(?:root|solution|zero|value|one|angle|sign|lösung|wurzel|nullstelle|winkel|wert|racine"
    r"|valeur|angle|radice|soluzione|valore|angolo|raíz|solución|valor|ángulo)s?"
)
_KINDS = {
    "positive": r"positive[nrs]?|positif|positiv[oa]|正の",
    "negative": r"negative[nrs]?|négati(?:f|ve)|negativ[oa]|負の",
    "smaller": (
        r"smaller|smallest|lesser|kleinere?[nrs]?|kleinste[nrs]?|(?:plus\s+)?petite?|minore|menor"
        r"|小さい(?:方|ほう)?の?"
    ),
    "larger": (
        r"larger|largest|greater|bigger|größere?[nrs]?|größte[nrs]?|(?:plus\s+)?grande?|maggiore|mayor"
        r"|大きい(?:方|ほう)?の?"
    ),
    "acute": r"acute|spitze[nrs]?|aigu[eë]?|acut[oa]|agud[oa]|鋭角の?",
    "obtuse": r"obtuse|stumpfe[nrs]?|obtuse?|ottus[oa]|obtus[oa]|鈍角の?",
}
_WORDS = "|".join(f"(?P<{kind}>{words})" for kind, words in _KINDS.items())
_BEFORE_THING = re.compile(
    r"(?<![^\W\d_-])(?P<article>(?:the|its|our|die|der|das|den|la|le|el|il)\s+)?"
    rf"(?:{_WORDS})(?P<thing>\s+(?:real\s+|reelle\s+)?(?:of\s+(?:the\s+)?two\s+)?{_THING}(?![^\W\d_])|(?<=の)(?:解|根))?(?P<rest>[^.;!?]*)",
    re.IGNORECASE,
)
_BEHIND_THING = re.compile(
    r"(?<![^\W\d_])(?:racine|solution|valeur|angle|radice|soluzione|angolo|raíz|solución|ángulo)\s+"
    rf"(?:{_WORDS.replace('(?P<', '(?P<b_')})(?P<b_rest>[^.;!?]*)",
    re.IGNORECASE,
)
_LEADS = re.compile(
    r"[\s$({\[,:]*(?:(?:is|are|gives?|being|has|we\s+(?:have|get|find|need|take|want)|so|hence|thus|then|therefore|of\s+(?:it|them|these|(?:the\s+)?(?:two\s+)?(?:roots|solutions|values))"
    r"|der\s+(?:beiden\s+)?(?:lösungen|wurzeln)|des\s+(?:deux\s+)?(?:racines|solutions)|delle\s+(?:due\s+)?(?:radici|soluzioni)"
    r"|de\s+las\s+(?:dos\s+)?(?:raíces|soluciones)|only|namely|i\.e\."
    r"|ist|lautet|hat|also|daher|somit|davon|est|donc|è|quindi|es|luego|は|が)[\s$({\[,:]*){0,3}\\?",
    re.IGNORECASE,
)
"""What may stand between the words of a kind and its number."""
_NOT = re.compile(
    r"(?<![^\W\d_])(?:not|no|never|reject\w*|discard\w*|drop\w*|ignor\w*|exclud\w*|except|than|unlike|instead|without|if|when|nicht|kein\w*|verwerf\w*|verworfen"
    r"|ausgeschlossen|scheide\w*|statt|ohne|wenn|falls|als|pas|ne|rejet\w*|écart\w*|sauf|sans|si|non|scart\w*|escludi\w*|senza|descart\w*|sin\s+la)(?![^\W\d_])|ない|捨て|除",
    re.IGNORECASE,
)
"""Words by which another root may be meant than the one that is named."""
_LEFT_OUT = re.compile(
    r"[\s$)]*(?:is|was|are|has\s+to\s+be|ist|wird|fällt|scheidet|est|è|es)\s+(?:left|dropped|discarded|rejected|excluded|not|no|impossible|verworfen|weg|aus|nicht"
    r"|kein|rejetée?|écartée?|exclue?|scartat[oa]|esclus[oa]|descartad[oa])(?![^\W\d_])",
    re.IGNORECASE,
)
"""Behind a root that does not count."""
_RESPECTIVELY = re.compile(
    r"(?<![^\W\d_])(?:respectively|resp\.|beziehungsweise|bzw\.|respectivement|rispettivamente|respectivamente)(?![^\W\d_])|それぞれ",
    re.IGNORECASE,
)
_PAIR = re.compile(
    rf"(?:{_WORDS.replace('(?P<', '(?P<a_')})\s+(?:{_THING}\s+)?"
    r"(?:and|und|et|e|y)\s+(?:an?\s+|the\s+|eine?\s+|une?\s+|una?\s+)?"
    rf"(?:{_WORDS.replace('(?P<', '(?P<b_')})",
    re.IGNORECASE,
)
_LETTER_IS = (
    r"(?<![A-Za-z\\])\$?\\?(?:{names})\$?\s+(?:is|being|must\s+be|ist|est|è|es)\s+"
    r"(?:(?:positive?|positi[fv]\w*)(?P<positive>)|(?:negative?|négati[fv]\w*|negativ\w*)(?P<negative>))"
    r"(?![^\W\d_])"
)
_ARE_POSITIVE = re.compile(
    r"(?<![^\W\d_])(?:(?:lengths?|distances?|masses|mass|radi(?:i|us)|sizes|diameters?|times?|areas?|stiffness(?:es)?|pressures?|volumes?)"
    r"\s+(?:is|are|must\s+be|has\s+to\s+be|have\s+to\s+be|can\s+only\s+be)\s+(?:always\s+)?positive"
    r"|(?:lengths?|distances?|mass(?:es)?|radi(?:i|us)|sizes?|diameters?|times?|areas?|volumes?)\s+(?:cannot|can\s+not|can\s+never|is\s+never|are\s+never|must\s+not)"
    r"\s+(?:be\s+)?negative"
    r"|(?:längen?|abstände?|massen?|radien|radius|zeiten|durchmesser|flächen?)\s+(?:(?:sind|ist|sein\s+muss|müssen|muss)\s+)?(?:immer\s+|stets\s+)?positiv(?![^\W\d_])"
    r"|(?:längen?|massen?|radien|zeiten)\s+(?:sind\s+nie|können\s+nicht|nicht)\s+negativ"
    r"|(?:longueurs?|masses?|rayons?|distances?)\s+(?:est|sont|doi(?:t|vent)\s+être)\s+(?:toujours\s+)?positi(?:f|ve)s?"
    r"|(?:lunghezz[ae]|mass[ae]|ragg[io]+|distanz[ae])\s+(?:è|sono|deve\s+essere|devono\s+essere)\s+(?:sempre\s+)?positiv[aeio]"
    r"|(?:longitud(?:es)?|masas?|radios?|distancias?)\s+(?:es|son|debe\s+ser|deben\s+ser)\s+(?:siempre\s+)?positiv[ao]s?)"
    r"|(?:長さ|距離|質量|半径|時間|面積)は(?:常に)?(?:正|負にならない|負ではない)",
    re.IGNORECASE,
)
"""Words by which a quantity that is asked for is positive: because lengths are positive."""
_NOT_LEFT = re.compile(
    r"(?<![^\W\d_])(?:not|no|reject\w*|discard\w*|drop\w*|ignor\w*|exclud\w*|except|if|scheide\w*|fällt|entfällt|nicht\s+(?!negativ)|kein\w*|verwerf\w*|verworfen|entfällt|statt|ohne"
    r"|wenn|falls|pas|rejet\w*|écart\w*|sauf|sans|si|scart\w*|escludi\w*|senza|descart\w*)(?![^\W\d_])|捨て|除",
    re.IGNORECASE,
)
"""Words by which the root behind may be the one that does not count."""
_DROPS = re.compile(
    r"[\s$)]*[^.;!?=]{0,30}(?<![^\W\d_])(?:out|away|not|cannot|no|aus|weg|nicht|kein\w*|drop\w*|reject\w*|discard\w*|exclude\w*|impossible|unmöglich"
    r"|meaningless|sinnlos|impossible|ne|pas|écart\w*|exclue?|scart\w*|esclus\w*|descart\w*|imposible)(?![^\W\d_])|[\s$]*[をは](?:捨|除|不適)",
    re.IGNORECASE,
)
"""Behind a root that may not count."""
_ANGLE_LIES = (
    r"(?:(?:is|lies|being|must\s+lie|ist|liegt|liegend|est|se\s+trouve|situé|è|compreso|está|comprendido)"
    r"\s+){0,2}"
)
_BETWEEN = (
    rf"(?:(?<![A-Za-z\\])\$?(?:{{names}})(?![A-Za-z])\$?|angle|winkel|ángulo|angolo)\s+{_ANGLE_LIES}"
    r"(?:between|zwischen|entre|tra|fra)\s+\$?(?P<low>-?[0-9]{1,3})\$?\s*(?:°|\^\{?\\circ\}?)?\$?\s+(?:and|und|et|e|y)\s+"
    r"\$?(?P<high>[0-9]{1,3})\s*(?:°|\^\{?\\circ)"
    r"|\$?(?<![A-Za-z\\])(?:{names})(?![A-Za-z])\$?\s*[がは]\s*\$?(?P<from>[0-9]{1,3})\s*(?:°|度|\^\{?\\circ\}?)\$?"
    r"\s*(?:と|から)\s*\$?(?P<to>[0-9]{1,3})\s*(?:°|度|\^\{?\\circ\}?)\$?\s*の間"
)
"""Where an angle lies by words: β between 90° and 180°. The letter is put in for the names."""
_SINE, _COSINE, _TANGENT = (1, 1, -1, -1), (1, -1, -1, 1), (1, -1, 1, -1)
_SIGNS = {"sin": _SINE, "cos": _COSINE, "tan": _TANGENT}
"""The signs of functions in the four quadrants."""
_REACH, _EPSILON = 140, 1e-9
_QUARTER = 90


def unless_of_another_kind(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a root is refuted that is not what the words before it call it."""
    if (
        k
        or len(chain.relations) != 1
        or names(chain.sides[1].node)
        or chain.relations[0].sign not in "=≈"
    ):
        return verdict
    if verdict.verdict not in (*PROVED_WORDS, CONDITION, PREMISE, DEFINITION):
        return verdict
    head = chain.sides[0].node
    if isinstance(head, Name):
        is_root = verdict.verdict in PROVED_WORDS or verdict.verdict in (PREMISE, DEFINITION)
        reason = _why_not(state, chain, head) if is_root else ""
        return describe(state.document, chain, k, Decision(REFUTED, reason)) if reason else verdict
    by_quarter = _by_quarter(state, chain, head) if isinstance(head, Call) else None
    return verdict if by_quarter is None else describe(state.document, chain, k, by_quarter)


def _why_not(state: JudgingState, chain: Chain, head: Name) -> str:
    """Return why a number is not the root that words name, "" where nothing speaks against it."""
    number = number_of(chain.sides[1].node, state.knowledge(chain.lines[0]))
    if number is None:
        return ""
    if _is_angle_asked_for(state, chain, head) and (
        why := _by_place_of_angle(state, chain, head, float(number))
    ):
        return why
    equation = _equation(state, chain, head)
    if equation is None:
        return ""
    value, kind = float(number), _kind_named(state, chain, head, equation)
    wrong = {
        "positive": value < 0,
        "negative": value > 0,
        "acute": not 0 < value < pi / 2,
        "obtuse": not pi / 2 < value < pi,
    }
    unknown = next(iter(equation.letters))
    is_angle = any(unknown in letters_in_waves(side.node) for side in equation.sides)
    if kind in wrong and (is_angle or kind in ("positive", "negative")):
        return f"it is not {kind}, as its words say" if wrong[kind] else ""
    if kind in ("smaller", "larger"):
        others = [*_other_roots(state, chain, equation, head)]
        worse = [
            v for v in others if (v < value - _EPSILON if kind == "smaller" else v > value + _EPSILON)
        ]
        return f"it is not the {kind} one: {worse[0]:.6g} is a root too" if worse else ""
    return ""


def _is_angle_asked_for(state: JudgingState, chain: Chain, head: Name) -> bool:
    """Tell whether an equation of a wave of a letter stands before its number, in its own sentence."""
    first = chain.start - len(_sentence(state, chain))
    above = state.sections.chains_between(first, chain.start)
    equation = _equation(state, chain, head)
    above = above if equation is None else [equation, *above]
    return any(head.name in letters_in_waves(side.node) for other in above for side in other.sides)


def _by_place_of_angle(state: JudgingState, chain: Chain, head: Name, value: float) -> str:
    """Return that an angle does not lie where its sentence says: in a quadrant, between two angles."""
    sentence = _sentence(state, chain)
    if why := _by_own_quarter(sentence, value):
        return why
    own = "|".join(map(re.escape, {plain_text(head), head.name, f"\\{head.name}"}))
    found = [*re.compile(_BETWEEN.replace("{names}", own), re.IGNORECASE).finditer(sentence)]
    if len(found) != 1 or _NOT.search(sentence):
        return ""
    low, high = (int(found[0][a] or found[0][b]) for a, b in (("low", "from"), ("high", "to")))
    degrees = value * 180 / pi
    if low - _EPSILON <= degrees <= high + _EPSILON:
        return ""
    return f"its words name an angle between {low}° and {high}°"


def _by_own_quarter(sentence: str, value: float) -> str:
    """Return that an angle does not lie in the quarter of a turn that its sentence names, or ""."""
    quarter = quarter_named(sentence[-_REACH:])
    if quarter is None or _NOT.search(sentence):
        return ""
    own = (value * 180 / pi) % 360
    if quarter + _EPSILON < own < quarter + _QUARTER - _EPSILON:
        return ""
    return f"its words name an angle between {quarter}° and {quarter + _QUARTER}°"


def _sentence(state: JudgingState, chain: Chain) -> str:
    """Return the words of a relation's sentence before it."""
    return state.sections.sentence_before(chain)


def _equation(state: JudgingState, chain: Chain, head: Name) -> Chain | None:
    """Return the last equation of one letter before a number that may be one of its roots, or None."""
    stem = head.name.partition("_")[0]
    found = state.sections.equation_before(chain.start, (head.name, stem))
    last = state.sections.chain_before(chain.start)
    if last is not None and len(last.relations) > 1 and last.letters <= {head.name, stem}:
        is_solved = {r.sign for r in last.relations} == {"="} and not names(last.sides[-1].node)
        if is_solved and len(last.letters) == 1:  # x² - x - 6 = (x - 3)(x + 2) = 0
            found = replace(last, sides=(last.sides[0], last.sides[-1]), relations=last.relations[:1])
    if found is None or not state.sections.same_section(found.lines[0], chain.lines[0]):
        return None
    return found


def _kind_named(state: JudgingState, chain: Chain, head: Name, equation: Chain) -> str:
    """Return the kind of root that the words right before a number name, "" for none."""
    text, before = state.document.text, state.sections.chain_before(chain.start)
    first = chain.start - len(_sentence(state, chain))
    if before is not None and before.end <= chain.start:
        first = max(first, before.end)
    if pair := _by_pair(state, chain, equation):
        return pair
    words = text[max(first, chain.start - _REACH) : chain.start]
    if _LEFT_OUT.match(text, chain.end):
        return ""
    found = [*_BEFORE_THING.finditer(words)]
    for match in reversed(found):
        is_of_root = match["article"] or match["thing"]
        if is_of_root and _NOT.search(words) is None and _LEADS.fullmatch(match["rest"]):
            return _kind_of(match, "")
    for match in reversed([*_BEHIND_THING.finditer(words)]):
        if _NOT.search(words) is None and _LEADS.fullmatch(match["b_rest"]):
            return _kind_of(match, "b_")
    sentence = _sentence(state, chain)
    written = re.compile(_LETTER_IS.replace("{names}", re.escape(plain_text(head))), re.IGNORECASE)
    near = max(chain.start - _REACH, 0 if before is None else before.end)
    is_counted = not (_NOT_LEFT.search(text, near, chain.start) or _DROPS.match(text, chain.end))
    is_positive = is_counted and _ARE_POSITIVE.search(text, near, chain.start) is not None
    said = None if _NOT.search(sentence) else written.search(sentence)
    if is_positive or said is None:
        return "positive" if is_positive else ""
    return "positive" if said["positive"] is not None else "negative"


def _kind_of(match: re.Match[str], prefix: str) -> str:
    return next((kind for kind in _KINDS if match[f"{prefix}{kind}"] is not None), "")


def _by_pair(state: JudgingState, chain: Chain, equation: Chain) -> str:
    """Return the kind of a root by its turn: a positive and a negative one, x = 2 and x = -4, resp."""
    text = state.document.text
    behind = re.split(r"(?<!resp)(?<!bzw)[.;!?](?=\s|$)|。", text[chain.end : chain.end + _REACH])[0]
    words = text[equation.end : chain.start]
    if _RESPECTIVELY.search(f"{words} {behind}") is None or (match := _PAIR.search(words)) is None:
        return ""
    row = [
        c for c in state.sections.chains_between(equation.end + match.end(), len(text)) if sets_number(c)
    ]
    if chain not in row[:2]:
        return ""
    return _kind_of(match, "ab"[row.index(chain)] + "_")


def _other_roots(state: JudgingState, chain: Chain, equation: Chain, head: Name) -> Iterator[float]:
    """Yield the other roots of an equation that the page names, and those of a quadratic one."""
    knowledge = state.knowledge(chain.lines[0])
    stem = head.name.partition("_")[0]
    for other in state.sections.chains_between(equation.end, chain.start):
        node = other.sides[0].node
        if sets_number(other) and isinstance(node, Name) and node.name.partition("_")[0] == stem:
            number = number_of(other.sides[1].node, knowledge)
            if number is not None and other.sides[1].span[0] not in state.refuted:
                yield float(number)
    yield from _roots_of_quadratic(state, equation)


def _roots_of_quadratic(state: JudgingState, equation: Chain) -> Iterator[float]:
    """Yield the real roots of a quadratic equation of one letter, by its values."""
    (name,) = equation.letters
    values: list[float] = []
    for n in range(_POINTS):
        number = Number(Fraction(n))
        sides = [_with(side.node, name, number) for side in equation.sides]
        numbers = [
            number_of(side, state.knowledge(equation.lines[0])) for side in sides if side is not None
        ]
        if len(numbers) != 2 or None in numbers:
            return
        values.append(float(numbers[0]) - float(numbers[1]))
    third = values[3] - 3 * values[2] + 3 * values[1] - values[0]
    fourth = values[4] - 4 * values[3] + 6 * values[2] - 4 * values[1] + values[0]
    a = (values[2] - 2 * values[1] + values[0]) / 2
    size = max(map(abs, values)) or 1
    if max(abs(third), abs(fourth)) > _EPSILON * size or abs(a) <= _EPSILON * size:
        return
    b, c = values[1] - values[0] - a, values[0]
    inner = b * b - 4 * a * c
    if inner > 0:
        yield from ((-b - sqrt(inner)) / (2 * a), (-b + sqrt(inner)) / (2 * a))


_POINTS = 5
"""Values that tell a quadratic from another formula: its third and fourth differences vanish."""


def _with(node: Formula, name: str, value: Formula) -> Formula | None:
    try:
        return substitute(node, name, value)
    except NoFormError:
        return None


def _by_quarter(state: JudgingState, chain: Chain, head: Call) -> Decision | None:
    """Return the decision on a wave's number by another wave of its angle and the quadrant in words."""
    line, knowledge = chain.lines[0], state.knowledge(chain.lines[0])
    sentence = _sentence(state, chain)
    number = number_of(chain.sides[1].node, knowledge)
    quarter = quarter_named(sentence)
    is_wave = head.function in _SIGNS and isinstance(head.argument, Name)
    if number is None or quarter is None or not is_wave or _NOT.search(sentence):
        return None
    signs = [_SIGNS[f][quarter // _QUARTER] for f in ("sin", "cos", "tan")]
    value, sign = float(number), _SIGNS[head.function][quarter // _QUARTER]
    place = f"the angle is between {quarter}° and {quarter + _QUARTER}°, by its words"
    if value * sign < 0:
        return Decision(REFUTED, f"of the wrong sign: {place}")
    first = chain.start - len(sentence)
    for other in state.sections.chains_between(first, chain.start):
        wave = other.sides[0].node
        is_alike = isinstance(wave, Call) and wave.argument == head.argument
        known = number_of(other.sides[-1].node, knowledge) if is_alike else None
        if not isinstance(wave, Call) or known is None or wave.function == head.function:
            continue
        ends = [
            _other_wave(wave.function, float(known) + side, head.function, signs)
            for half in [_last_place(other.sides[-1].node) / 2]
            for side in (0, -half, half)
        ]
        if None in ends:
            continue
        exact, *rounded = (float(end) for end in ends if end is not None)
        half = max(_last_place(chain.sides[1].node) / 2, _EPSILON)
        if abs(exact - value) <= half:
            return Decision(PROVED, f"by line {other.lines[0]}", assumptions=(place,))
        if not min(rounded) - half <= value <= max(rounded) + half:
            shown = f"{head.function} is {exact:.6g} by line {line}"
            return Decision(REFUTED, f"{shown}, where {place}")
    return None


def _other_wave(given: str, value: float, wanted: str, signs: list[int]) -> float | None:
    """Return a sine, cosine or tangent by another of the same angle, whose signs are known."""
    if given == "tan":
        cosine = signs[1] / sqrt(1 + value * value)
        sine = value * cosine
    elif abs(value) > 1:
        return None
    elif given == "sin":
        sine, cosine = value, signs[1] * sqrt(1 - value * value)
    else:
        cosine, sine = value, signs[0] * sqrt(1 - value * value)
    if wanted == "tan":
        return sine / cosine if cosine else None
    return sine if wanted == "sin" else cosine


def _last_place(node: Formula) -> float:
    """Return the place of the last digit that a number is printed with, 0 for an exact one."""
    places = [p.last_place for p in walk(node) if isinstance(p, Number) and p.last_place is not None]
    return float(max(places, default=Fraction(0)))
