"""Letters before numbers in brackets that are values at them: F(2600) = F(5200)/2 is no identity.

F(2600) may be 2600 times F. With two numbers behind one letter in a relation it is the value at each, and
of that nothing follows from the brackets alone.
"""

from __future__ import annotations

from symbalance.document.formula import Apply, Evaluation, Formula, parts_of_kind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_VALUE = re.compile(
    r"(?P<letter>(?:\\[a-z]+\s*\{?\s*)?\\?[A-Za-z]+\}?(?:_\{[^{}]{1,12}\}|_\w{1,8})?)\s*(?:\\left\s*)?"
    r"\(\s*(?P<number>[0-9][0-9.,]*)\s*(?:\\right\s*)?\)"
)
"""A letter and a number in brackets behind it."""
_FUNCTIONS = re.compile(r"\\?(?:sin|cos|tan|cot|ln|log|exp|sqrt|arc[a-z]+|lg|min|max|cdot|times|left)")


def unless_at_two_numbers(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; open where one letter stands before two numbers in brackets, as if multiplied."""
    if verdict.verdict not in (*PROVED_WORDS, REFUTED):
        return verdict
    typed = state.document.text[chain.sides[k].span[0] : chain.sides[k + 1].span[1]]
    numbers: dict[str, set[str]] = {}
    for match in _VALUE.finditer(typed):
        letter = re.sub(r"[\s{}\\]", "", match["letter"])
        if not _FUNCTIONS.fullmatch(match["letter"]) and state.definitions.values.get(letter) is None:
            numbers.setdefault(letter, set()).add(match["number"])
    letter = next((each for each, values in numbers.items() if len(values) > 1), "")
    if not letter or any(_has_own_function(side.node) for side in chain.sides[k : k + 2]):
        return verdict
    reason = f"{letter}( ) at two numbers: a function, of which nothing is known here"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _has_own_function(node: Formula) -> bool:
    """Tell whether a formula has a function of the page's own, f(2) of f(x) = x², written out."""
    applied = any(part.function != "at" for part in parts_of_kind(node, Apply))
    return applied or any(True for _ in parts_of_kind(node, Evaluation))
