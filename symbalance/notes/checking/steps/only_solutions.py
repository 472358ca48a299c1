"""Solutions that words call the only one, and that are not: x² = 4, and "x = 2 is the only solution"."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from math import degrees, radians

from symbalance.document.formula import Formula, Name, Negative, Sum, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.algebra.tree_values import TreeValues
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.implications import solution_lost
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONDITION,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    Verdict,
)
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_REAL = r"(?:(?:real|possible|reelle|mögliche|réelle|reale|posible)\s+)?"
_THING = (
    r"(?:solution|root|zero|value|angle|lösung|nullstelle|wurzel|winkel|wert|racine|valeur"
    r"|soluzione|radice|valore|solución|raíz|valor)"
)
_SOLUTION = rf"{_REAL}{_THING}(?![^\W\d_])"
_ONLY = (
    r"(?:only|sole|unique|single|einzige[nrs]?|eindeutige[nrs]?|seule?|unique|unica|unico|sola"
    r"|solo|única|único)"
)
_BEHIND = re.compile(
    rf"[\s$)\]]*(?:(?:is|are|ist|est|è|es)\s+|,\s*)(?:the|an?|die|der|das|eine?|la|le|l['’]|el|il)\s*{_ONLY}\s+{_SOLUTION}"
    r"|[\s$)\]]*(?:,\s*)?(?:only|and\s+(?:no\s+other|nothing\s+else)|alone|und\s+(?:kein\w*\s+ander|sonst)\w*|allein|seulement|uniquement"
    r"|et\s+aucune?\s+autre|solamente|solo|soltanto|e\s+nessun\w*\s+altr\w)(?=[^\W\d_]*(?:\s+(?:value|solution|root|wert|lösung|valeur|valore|valor)\w*)?[\s]*(?:[.;,。]|$))"
    r"|[\s$)\]]*(?:が|は)(?:唯一|ただ一つ)の解|[\s$)\]]*(?:だけ|のみ)(?:である|だ|です|。)",
    re.IGNORECASE,
)
_JUST_ONE = (
    r"(?:(?:exactly|only|just|precisely)\s+one|a\s+(?:single|unique)|genau\s+eine?n?|nur\s+eine?n?|eine\s+einzige|exactement\s+une?|une\s+seule"
    r"|esattamente\s+un[ao]?|una\s+sola|exactamente\s+una?)"
)
_BEFORE = re.compile(
    rf"(?:(?:the|its|die|der|den|das|la|le|l['’]|el|il|al?s|pour|come|como)\s*{_ONLY}\s+{_SOLUTION}|(?:only|nur|solo)\s+(?:the|die|la)\s+{_SOLUTION}"
    rf"|{_JUST_ONE}\s+(?:{_SOLUTION}|\$?[a-z]\$?\s+(?:with|mit|avec|con)(?![^\W\d_])))[^.;!?]{{0,60}}[\s$(\\,:]*$|唯一の解は[\s$]*$",
    re.IGNORECASE,
)
_NOT_ONLY = re.compile(
    r"(?<![^\W\d_])(?:not|no|nicht|keine?|pas|non|never|if|wenn|falls|si|unless|between|zwischen|in\s+the\s+interval|auf\s+dem\s+intervall)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words that deny that it is the only one, or say where it is."""
_TURN = re.compile(
    r"(?<![^\W\d_])(?:between|from|zwischen|von|entre|de|tra|da)\s+\$?(?P<low>[0-9]{1,3})\$?\s*°?\$?\s+(?:and|to|und|bis|et|à|e|a|y)\s+"
    r"\$?(?P<high>[0-9]{1,3})\s*(?:°|\^\{?\\circ)",
    re.IGNORECASE,
)
"""A range of angles in words: between 0 and 360°."""
_COUNT = re.compile(
    r"(?<![^\W\d_])(?:has|have|hat|haben|a|ont|ha|tiene)\s+(?:exactly\s+|genau\s+|exactement\s+)?(?:the\s+|die\s+|les\s+)?(?P<count>two|zwei|deux|due|dos)\s+"
    r"(?:real\s+|distinct\s+|different\s+|reelle\s+|verschiedene\s+)?(?:solutions?|roots?|zeros?|lösungen|nullstellen|wurzeln|racines|soluzioni|radici|soluciones|raíces)",
    re.IGNORECASE,
)
_DOUBLE = re.compile(
    r"(?<![^\W\d_])(?:the\s+|a\s+|die\s+|eine\s+|la\s+|une\s+|una\s+)?(?:double|twofold|repeated|doppelte|zweifache|doppia|doble)\s+(?:root|zero|solution|nullstelle|lösung|wurzel|racine|radice|soluzione|raíz)"
    r"|(?:racine|radice|raíz)\s+(?:double|doppia|doble)[^.;!?=]{0,20}[\s$(]*$|重解",
    re.IGNORECASE,
)
_REACH = 110
_OF_BEHIND = re.compile(
    r"[^.;!?$=]{0,60}(?<![^\W\d_])(?:of|to|von|der\s+gleichung|de|di)[\s$({\[]*", re.IGNORECASE
)
"""Words that lead from a solution to its equation: x = 2 is the only solution of x² = 4."""
_PIECES, _APART = 240, 1e-6
"""Pieces of a range in which roots are looked for, and by how much two roots differ at least."""
_STEPS, _FAR, _ASIDE, _HALVINGS = 8, 80, Fraction(3, 7), 40
"""Steps in the root given, steps to either side, where the first one lies, and halvings of one."""


def unless_not_the_only(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where words call a solution the only one, and another one turns up.

    So is a root that words call a double one where the equation changes its sign, and the last of two
    where a third one turns up.
    """
    head = chain.sides[0].node
    if k or not isinstance(head, Name) or names(chain.sides[1].node) or len(chain.relations) != 1:
        return verdict
    if verdict.verdict not in (*PROVED_WORDS, CONDITION, PREMISE, DEFINITION):
        return verdict
    said = _said_of_it(state, chain)
    equation = equation_of(state, chain) if said else None
    if equation is None:
        return verdict
    reason = _why_not(state, chain, equation, said, head.name)
    return describe(state.document, chain, k, Decision(REFUTED, reason)) if reason else verdict


def _said_of_it(state: JudgingState, chain: Chain) -> str:
    """Return what words say of a solution: that it is the only one, a double one, or one of two."""
    text = state.document.text
    start = chain.start - min(_REACH, len(state.sections.sentence_before(chain)))
    before = text[start : chain.start]
    if _DOUBLE.search(before) is not None and _NOT_ONLY.search(before) is None:
        return "double"
    only = _BEFORE.search(before)
    is_before = only is not None and _NOT_ONLY.search(only[0]) is None
    if _BEHIND.match(text, chain.end) is not None or is_before:
        return "only"
    return "two" if _COUNT.search(before) is not None else ""


def _why_not(state: JudgingState, chain: Chain, equation: Chain, said: str, name: str) -> str:
    """Return why a solution is not what words say of it, "" where nothing speaks against it."""
    knowledge = state.knowledge(chain.lines[0])
    sides = equation.sides[0].node, equation.sides[1].node
    value, line = chain.sides[1].node, equation.lines[0]
    if any(name in letters_in_waves(side) for side in sides):
        return _another_angle(state, chain, equation, name) if said == "only" else ""
    if said == "double":
        return (
            "no double root: the equation changes its sign there"
            if _changes_sign(name, sides, value, knowledge)
            else ""
        )
    if said == "two":
        return _third_root(state, chain, equation, name)
    point = solution_lost(sides, (Name(name), value), knowledge)
    shown = ", ".join(f"{plain_text(Name(n))} = {plain_text(v)}" for n, v in (point or {}).items())
    shown = shown or another_root(name, sides, value, knowledge)
    return f"not the only one: {shown} satisfies line {line} too" if shown else ""


def _another_angle(state: JudgingState, chain: Chain, equation: Chain, name: str) -> str:
    """Return that another angle of a range said in the sentence solves an equation, "" for none."""
    line = chain.lines[0]
    knowledge = state.knowledge(line)
    value = number_of(chain.sides[1].node, knowledge)
    ends = _ends_said(state, chain, name, knowledge)
    if value is None or ends is None:
        return ""
    sides = equation.sides[0].node, equation.sides[1].node
    for root in _roots_between(name, sides, ends, knowledge):
        if abs(root - float(value)) > _APART:
            shown = f"{plain_text(Name(name))} ≈ {degrees(root):.4g}°"
            return f"not the only one: {shown} satisfies line {equation.lines[0]} too"
    return ""


def _ends_said(
    state: JudgingState, chain: Chain, name: str, knowledge: Knowledge
) -> tuple[float, float] | None:
    """Return the range in which an angle is looked for, by words or relations of the sentence."""
    sentence = state.sections.sentence_before(chain)
    behind = state.document.text[chain.end : chain.end + _REACH]
    match = _TURN.search(sentence) or _TURN.search(behind.partition(".")[0])
    if match is not None:
        return radians(int(match["low"])), radians(int(match["high"]))
    low = high = None
    for stated in knowledge.ranges:
        is_left = stated.left == Name(name)
        if not is_left and stated.right != Name(name):
            continue
        bound = number_of(stated.right if is_left else stated.left, knowledge)
        is_less = (stated.sign in "<≤") == is_left
        if bound is not None and is_less:
            high = float(bound)
        elif bound is not None:
            low = float(bound)
    return None if low is None or high is None else (low, high)


def _roots_between(
    name: str, equation: tuple[Formula, Formula], ends: tuple[float, float], knowledge: Knowledge
) -> list[float]:
    """Return where the sides of an equation of one letter cross within a range, its ends among it."""
    if (names(equation[0]) | names(equation[1])) != {name}:
        return []
    at = _difference(name, equation, knowledge)
    width = (ends[1] - ends[0]) / _PIECES
    places = [Fraction(ends[0] - width / 2 + n * width * 1.0000137) for n in range(_PIECES + 2)]
    found = (_root_between(at, low, high) for low, high in pairwise(places))
    return [r for r in found if r is not None and ends[0] - _APART <= r <= ends[1] + _APART]


def _difference(
    name: str, equation: tuple[Formula, Formula], knowledge: Knowledge
) -> Callable[[Fraction], float]:
    """Return a function of one letter's value: by how much the sides of an equation differ there."""
    difference = Sum((equation[0], Negative(equation[1])))

    def at(place: Fraction) -> float:
        return float(TreeValues(knowledge.meaning, {name: place}).value(difference).real)

    return at


def _changes_sign(
    name: str, equation: tuple[Formula, Formula], value: Formula, knowledge: Knowledge
) -> bool:
    """Tell whether an equation of one letter changes its sign where it has a root."""
    number = number_of(value, knowledge)
    if number is None or (names(equation[0]) | names(equation[1])) != {name}:
        return False
    at, own = _difference(name, equation, knowledge), Fraction(str(float(number)))
    near = Fraction(1, 10**4) * max(abs(own), 1)
    try:
        return at(own - near) * at(own + near) < 0
    except (NoFormError, ArithmeticError):
        return False


def _third_root(state: JudgingState, chain: Chain, equation: Chain, name: str) -> str:
    """Return that an equation has a third root beside two that the page names; "" where none turns up."""
    text, knowledge = state.document.text, state.knowledge(chain.lines[0])
    given = [c for c in state.sections.chains_of(Name(name)) if c.start >= equation.end]
    values = [number_of(c.sides[1].node, knowledge) for c in given if not names(c.sides[1].node)]
    own = [float(v) for v in values if v is not None][:2]
    if len(own) < 2 or chain is not given[1] or "." in text[given[0].end : chain.start]:
        return ""
    sides = equation.sides[0].node, equation.sides[1].node
    reach = 10 * max(1.0, *map(abs, own))
    for root in _roots_between(name, sides, (-reach, reach), knowledge):
        if all(abs(root - each) > _APART * max(1.0, abs(each)) for each in own):
            shown = f"{plain_text(Name(name))} ≈ {root:.6g}"
            return f"not the only two: {shown} satisfies line {equation.lines[0]} too"
    return ""


def another_root(
    name: str, equation: tuple[Formula, Formula], value: Formula, knowledge: Knowledge
) -> str:
    """Return another root of an equation near the one given, found by its sign; "" for none.

    Where ranges or its meaning say where the letter lies, those may be why it is the only one.
    """
    number = number_of(value, knowledge)
    is_bound = name in knowledge.meaning.positive or any(
        name in names(r.left) | names(r.right) for r in knowledge.ranges
    )
    if number is None or is_bound or (names(equation[0]) | names(equation[1])) != {name}:
        return ""
    own = Fraction(str(float(number)))
    at = _difference(name, equation, knowledge)
    step = abs(own) / _STEPS or Fraction(1, _STEPS)
    places = [own + step * (k + _ASIDE) for k in range(-_FAR, _FAR)]
    for low, high in pairwise(places):
        if not low <= own <= high and (root := _root_between(at, low, high)) is not None:
            return f"{plain_text(Name(name))} ≈ {root:.6g}"
    return ""


def _root_between(at: Callable[[Fraction], float], low: Fraction, high: Fraction) -> float | None:
    """Return where a function of one letter changes its sign between two places, None for a pole."""
    try:
        first, second = at(low), at(high)
        size, middle, between = min(abs(first), abs(second)), low, first
        if first * second >= 0:
            return None
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            between = at(middle)
            low, high = (middle, high) if between * first > 0 else (low, middle)
    except (NoFormError, ArithmeticError):
        return None
    return float(middle) if abs(between) < size / 1000 else None


def equation_of(state: JudgingState, chain: Chain) -> Chain | None:
    """Return the equation that a letter's value solves: the last before it, or one right behind it."""
    head, line = chain.sides[0].node, chain.lines[0]
    behind = _OF_BEHIND.match(state.document.text, chain.end)
    if behind is not None:
        near = state.sections.chains_between(behind.end(), behind.end() + _REACH)[:1]
        if near and near[0].start <= behind.end() + 1 and _is_equation(near[0], chain):
            return near[0]
    for other in reversed(state.document.chains):
        is_before = other.end <= chain.start and state.sections.same_section(other.lines[0], line)
        if is_before and _is_equation(other, chain) and other.sides[0].node != head:
            return other
    return None


def _is_equation(other: Chain, chain: Chain) -> bool:
    """Tell whether a relation is an equation of the one letter that another gives its value."""
    is_one = len(other.relations) == 1 and other.relations[0].sign == "="
    return is_one and other.letters == chain.letters
