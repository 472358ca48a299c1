"""Where a formula is said to be smallest or largest: F = A (1 - 2B + 4B²/1.3) is smallest at B = 0.325.

The value that words give a letter there is no premise: the formula right above has to turn at it. Of an
angle nothing is said here, nor of whole numbers, which may be the ends of what a letter can be.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OPEN = (DEFINITION, PREMISE, CONDITION)
_SUBJECT = (
    r"(?:it|this|that|which|and|where|\$[^$\n]{1,20}\$|[sd]ie(?:ser?)?|er|es|das|diese[rs]?|elle|il"
    r"|ce(?:ci|la)?)"
)
_IS = r"(?:is|has|becomes|reaches|takes|ist|wird|hat|est|devient|atteint)"
_EXTREME = (
    r"(?:(?:its|the|a|an|am|ihr|sein|ein|le|la|son|sa|plus)\s+){0,2}(?:smallest|least|minimal|minimum|lowest|largest|greatest"
    r"|maximal|maximum|highest|kleinsten|größten|petite?|grande?|minimale?|maximale?)"
)
_AT = r"(?:\s+value)?\s+(?:at|for|when|if|with|bei|für|wenn|pour|à|quand)"
_PLACE = re.compile(
    rf"(?<![^\W\d_])(?:{_SUBJECT}|(?:the|die|der|das|la|le)\s+(?P<thing>[^\W\d_][\w -]{{2,40}}?))"
    rf"\s+{_IS}\s+{_EXTREME}{_AT}[\s$\\({{\[`]*$",
    re.IGNORECASE,
)
_PLACE_GERMAN = re.compile(
    rf"(?<![^\W\d_]){_SUBJECT}\s+(?:ist|wird)\s+(?:bei|für)[\s$\\({{\[`]*$", re.IGNORECASE
)
_BEHIND = re.compile(r"[\s$)\]}`]*(?:am\s+)?(?:kleinsten|größten|minimal|maximal)", re.IGNORECASE)
"""Words right before a relation, or around it, by which what was just said is extremal there."""
_FARTHEST = 200
"""Characters between a formula and where it is extremal."""
_POINTS = 3
_STEP = Fraction(1, 1000)
"""Part of a value without decimals by which the formula is looked at beside it."""


def unless_no_extreme(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number is refuted at which the formula above goes on rising or falling."""
    head, right = chain.sides[0].node, chain.sides[1].node
    if k or verdict.verdict not in _OPEN or len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return verdict
    if not isinstance(head, Name) or not isinstance(right, Number) or right.value.denominator == 1:
        return verdict
    above = _formula_right_above(state, chain, head.name)
    if above is None or not _is_place_of_extreme(state, chain, above):
        return verdict
    if not _goes_on(state, chain, above.sides[-1].node, head.name, right):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    reason = f"the formula of line {above.lines[0]} goes on rising or falling there"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _is_place_of_extreme(state: JudgingState, chain: Chain, above: Chain) -> bool:
    """Tell whether words say of what stands before that it is smallest or largest at a relation.

    "The force" is what stands before if the formula's own sentence has that word.
    """
    text = state.document.text
    before = text[max(0, chain.start - _FARTHEST // 2) : chain.start]
    is_german = _PLACE_GERMAN.search(before) is not None and _BEHIND.match(text, chain.end) is not None
    place = _PLACE.search(before)
    thing = place["thing"] if place else None
    is_named = thing is None or thing.lower() in state.sections.sentence_leading_to(above).lower()
    return is_german or (place is not None and is_named)


def _formula_right_above(state: JudgingState, chain: Chain, name: str) -> Chain | None:
    """Return the last relation before, if it gives another letter a formula in a letter."""
    before = [c for c in state.document.chains if c.end <= chain.start and not _is_datum(c)]
    heads, last = set[Formula](), None
    for last in sorted(before, key=lambda c: -c.end):
        heads.add(last.sides[0].node)
        if name in last.letters or len(heads) > 1:
            break
    if len(heads) != 1:
        return None
    if last is None or chain.start - last.end > _FARTHEST or not isinstance(last.sides[0].node, Name):
        return None
    if last.sides[0].node.name == name or any(relation.sign != "=" for relation in last.relations):
        return None
    formula = last.sides[-1].node
    is_of_size = name in names(formula) and name not in state.knowledge(chain.lines[0]).angles
    return last if is_of_size else None


def _is_datum(chain: Chain) -> bool:
    """Tell whether a chain only gives a letter a number."""
    return isinstance(chain.sides[0].node, Name) and not any(names(s.node) for s in chain.sides[1:])


def _goes_on(state: JudgingState, chain: Chain, formula: Formula, name: str, value: Number) -> bool:
    """Tell whether a formula is larger on one side of a letter's value and smaller on the other."""
    knowledge = state.knowledge(chain.lines[0])
    others = {n: d.node for n, d in knowledge.definitions.items() if n != name}
    if name in {n for other in names(formula) - {name} for n in names_behind(Name(other), others)}:
        return False
    step = value.last_place or abs(value.value) * _STEP
    try:
        nodes = [substitute(formula, name, Number(value.value + n * step)) for n in (-1, 0, 1)]
    except NoFormError:
        return False  # the value stays a premise, which nothing is said to prove
    sizes = knowledge.meaning.positive | names(formula)
    meaning = replace(knowledge.meaning, values={**knowledge.meaning.values, **others}, positive=sizes)
    points = sample_trees(nodes, meaning, _POINTS)
    rows = [tuple(each.real for each in values) for _, values in points]
    return bool(rows) and all((low - at) * (high - at) < 0 for low, at, high in rows)
