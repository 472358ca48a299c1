"""What is said of all whole numbers, and fails for one of them: ∫ cos mθ cos nθ dθ = 0 but for m = n."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.letters import plain_letter
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITIONAL, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.letters.letter_names import canonical_name
from symbalance.text import lazy_patterns as re

_LETTER = r"(?:\\[a-z]+|[A-Za-z])(?:_\w)?"
_LETTERS = rf"[\s$]*(?P<letters>{_LETTER}(?:[\s$]*(?:,|and|und|et|e|y)[\s$]*{_LETTER}(?![\w]))*)(?![\w])"
_INTEGERS = (
    r"(?:integers?|whole\s+numbers?|ganze[nrms]?\s+Zahl(?:en)?|ganzzahlige[nrms]?|entiers?"
    r"|interi|enteros?)"
)
_FOR_ALL = re.compile(
    r"(?<![^\W\d_])(?:for|für|pour|per|para)\s+"
    r"(?:all|every|each|any|alle|jedes?|jede[nr]?|tou[st]|ogni|tutti\s+gli|todos?(?:\s+los)?)\s+"
    rf"{_INTEGERS}{_LETTERS}",
    re.IGNORECASE,
)
_FROM_ZERO = re.compile(
    rf"(?<![^\W\d_])(?:for|für|pour|per|para)[\s$]+(?P<letters>{_LETTER})[\s$]*="
    r"[\s$]*0\s*,\s*1\s*,\s*2\s*,",
    re.IGNORECASE,
)
_ALL_ALIKE = re.compile(
    r"(?:すべての|全ての|任意の)整数[\s$]*(?P<letters>[A-Za-z](?:[\s$,、]*[A-Za-z])*)"
)
_BUT = re.compile(
    r"≠|\\neq?(?![a-z])|!=|(?<![^\W\d_])(?:different|distinct|unequal|unless|except|other than|not?|but"
    r"|apart|keine?|aucun|nessun"
    r"|verschieden\w*|ungleich\w*|außer|nicht|ohne|sauf|excepté|distincts?|différents?|tranne|diversi|salvo)"
    r"(?![^\W\d_])|異なる|除|ただし",
    re.IGNORECASE,
)
"""Words that take some of the numbers out."""
_SENTENCE = re.compile(r"[^.;。\n]{0,160}")
_NOT_ZERO = re.compile(r"(\w+) ≠ 0")
_UNEQUAL = re.compile(r"(\w+) - (\w+) ≠ 0")
_NO_MULTIPLE = re.compile(r"(\w+) is no multiple of \w+")


def unless_said_for_all(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where what holds but for some whole numbers is said of all of them."""
    if verdict.verdict != CONDITIONAL or not re.search("≠ 0| is no multiple", verdict.assumption):
        return verdict
    behind = _SENTENCE.match(state.document.text, chain.end)
    words = state.sections.sentence_before(chain) + " = " + (behind[0] if behind else "")
    letters = _letters_of_all(words)
    if not letters or _BUT.search(words):
        return verdict
    failing = next(filter(None, (_failing(each, letters) for each in verdict.assumption.split(", "))), "")
    if not failing:
        return verdict
    reason = f"it is said of all whole numbers, and fails for {failing}"
    return replace(verdict, verdict=REFUTED, reason=reason, assumption="", order="")


def _letters_of_all(words: str) -> frozenset[str]:
    """Return the letters of all of whose whole values, nought among them, a sentence speaks."""
    match = next(filter(None, (p.search(words) for p in (_FOR_ALL, _FROM_ZERO, _ALL_ALIKE))), None)
    if match is None:
        return frozenset()
    letters = re.findall(_LETTER, match["letters"])
    return frozenset(plain_letter(canonical_name(each.lstrip("\\"))) for each in letters)


def _failing(condition: str, letters: frozenset[str]) -> str:
    """Return for which of all whole numbers a condition is not met; "" for none that is sure."""
    if (match := _NOT_ZERO.fullmatch(condition)) and match[1] in letters:
        return f"{match[1]} = 0"
    if (match := _UNEQUAL.fullmatch(condition)) and {match[1], match[2]} <= letters:
        return f"{match[1]} = {match[2]}"
    if (match := _NO_MULTIPLE.fullmatch(condition)) and match[1] in letters:
        return f"{match[1]} = 0"
    return ""
