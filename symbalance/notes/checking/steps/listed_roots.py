r"""Roots that only words or braces list: x² - 5x + 6 = 0, so x = 2 or 4; "the roots are 2 and 4".

No relation says x = 4 there. Each number has to solve the equation before the list; where one does not,
the relation that the list begins with is wrong, or, where it has none, what the equation is said to give.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.named_roots import ROOTS
from symbalance.notes.checking.verdicts import CONTRADICTION, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_FARTHEST = 90
"""Characters between an equation and the list of its roots."""
_NUMBER = r"[-−–+]?\s?[0-9]+(?:\.[0-9]+)?(?:/[0-9]+)?"
_GAP = r"(?:\s|\$|\\[,; ])*"
_OR = (
    rf"{_GAP}(?:,(?![0-9])|(?<![^\W\d_])(?:or|oder|ou|o|u|and|und|et|e|y)(?![^\W\d_])|または|と|、){_GAP}"
)
_ENDS = r"(?![0-9]|\.[0-9]|\s*(?:[=A-Za-z^°%]|\\[A-Za-z]))"
"""Behind a number that is no part of a formula."""
_LIST = rf"(?P<first>{_NUMBER})(?P<rest>(?:{_OR}(?:{_OR})?{_NUMBER}{_ENDS}){{1,5}})"
_HEAD = r"(?<![\w\\}])(?P<letter>\\?[^\W\d_]+)"
_OF_LETTER = re.compile(rf"{_HEAD}\s*(?:=\s*|(?:\\in(?![A-Za-z])|∈)\s*\\?\{{\s*){_LIST}")
_OF_WORDS = re.compile(
    rf"(?:(?<![^\W\d_])(?:are|is\s+true\s+for|sind|lauten|sont|sono|son)(?![^\W\d_])|は)[\s$:]*{_LIST}(?P<letter>)"
)
"""Roots that words name, without the letter of the unknown."""
_APART = re.compile(
    r"[.;!?]\s+\S|[。；]|(?<![^\W\d_])(?:not|no|never|wrong\w*|between|if|when|unless|nicht|kein\w*|falls|wenn|pas|non|si)"
    r"(?![^\W\d_])|ない",
    re.IGNORECASE,
)
"""What parts an equation from a list that is not of its roots."""


def unless_wrong_in_list(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what stands as one of the listed roots of an equation solves it, or is wrong."""
    if k or verdict.verdict in (REFUTED, CONTRADICTION):
        return verdict
    text = state.document.text
    own = _listed_behind(text, chain)
    if own is not None and not any(
        own[0] <= other.start < own[1] or other.start <= own[0] < other.end
        for other in state.document.chains
        if other is not chain and other.relations
    ):
        wrong = _wrong_root(chain, own[2])
        if wrong:
            return describe(state.document, chain, k, Decision(REFUTED, f"{wrong} does not satisfy it"))
    above = state.sections.chain_before(chain.start)
    listed = None if above is None else _listed_behind(text, above)
    if above is None or listed is None or not listed[0] <= chain.start < listed[1]:
        return verdict
    wrong = _wrong_root(above, listed[2])
    reason = f"{wrong} does not satisfy line {above.lines[0]}"
    return describe(state.document, chain, k, Decision(REFUTED, reason)) if wrong else verdict


def _listed_behind(text: str, equation: Chain) -> tuple[int, int, list[str]] | None:
    """Return where a list of an equation's roots stands behind it, and its numbers; else None."""
    name = _unknown(equation)
    if not name:
        return None
    end = equation.end
    window = text[end : end + _FARTHEST + 60]
    for pattern in (_OF_LETTER, _OF_WORDS):
        match = pattern.search(window)
        if match is None or match.start() > _FARTHEST or _APART.search(window[: match.start()]):
            continue
        if "=" in window[: match.start()] or match["letter"].lstrip("\\") not in (name, ""):
            continue
        before = text[max(0, equation.start - _FARTHEST) : equation.start]
        if pattern is _OF_WORDS and not ROOTS.search(f"{before} {window[: match.start()]}"):
            continue
        numbers = [match["first"], *re.findall(_NUMBER, match["rest"])]
        return end + match.start(), end + match.end(), numbers
    return None


def _unknown(equation: Chain) -> str:
    """Return the one letter of an equation between numbers and it, "" where it is none to be solved."""
    if len(equation.relations) != 1 or equation.relations[0].sign != "=":
        return ""
    left, right = (side.node for side in equation.sides)
    own = names(left) | names(right)
    is_given = isinstance(left, Name) or isinstance(right, Name)
    return next(iter(own)) if len(own) == 1 and not is_given else ""


def _wrong_root(equation: Chain, numbers: list[str]) -> str:
    """Return the first of some numbers that is no root of an equation, with its letter; "" for none."""
    name = _unknown(equation)
    condition = Premise(equation.sides[0].node, equation.sides[1].node, equation.lines[0])
    for typed in numbers:
        exact, rough = (_number(typed, is_rough=each) for each in (False, True))
        is_root = solves_as_printed(condition, name, exact, Knowledge())
        if is_root is False and solves_as_printed(condition, name, rough, Knowledge()) is False:
            return f"{plain_letter(name)} = {typed.strip()}"
    return ""


def _number(typed: str, *, is_rough: bool) -> Formula:
    """Return a typed number with the last of its digits; a whole one may be rounded where it is rough."""
    digits = re.sub(r"[\s+]", "", typed).replace("−", "-").replace("–", "-")
    value = Fraction(digits.lstrip("-"))
    decimals = len(digits.partition(".")[2]) if "." in digits else 0
    place = Fraction(1, 10**decimals) if decimals or (is_rough and "/" not in digits) else None
    number = Number(value, place)
    return Negative(number) if digits.startswith("-") else number
