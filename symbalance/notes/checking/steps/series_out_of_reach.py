"""Series where they do not hold, by a number of their letter: Σ q^k with q = 2, sin θ ≈ θ at θ = 80°.

Powers are compared one by one, which asks nothing of the letter. With a number that a page has given it,
the terms of a sum without end have to fall; of one with dots it is enough that the closed form
has a pole or a branch (a root, a logarithm, a quotient) and that the number is no part of one. What words
call small is not if its number is about one or more.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from symbalance.document.formula import (
    Apply,
    Call,
    Dots,
    Formula,
    Name,
    Number,
    Power,
    Quotient,
    Summation,
    names,
    parts_of_kind,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.sums import at_index
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.infinite_series import is_infinite
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.order_agreement import known_not_small
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PROVED_WORDS, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹"
_OF_ORDER = re.compile(rf"[^\W\d]\w*[{_RAISED}]+")
"""The order to which a series in one letter holds: λ³."""
_ENTIRE = ("sin", "cos", "exp", "sinh", "cosh")
"""Functions whose series have a sum everywhere."""
_FAR_OUT = (30, 31, 32, 33, 34)
"""Terms that are compared with each other: they grow where there is no sum."""


def unless_series_out_of_reach(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a proved series is left open where its letter's number is out of its reach."""
    sides = chain.sides[k].node, chain.sides[k + 1].node
    is_cut = chain.relations[k].sign == "≈" and _OF_ORDER.fullmatch(verdict.order) is not None
    if verdict.verdict not in PROVED_WORDS or not (is_cut or any(map(_is_series, sides))):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    for name in sorted(names(sides[0]) | names(sides[1])):
        known = known_not_small(name, knowledge)
        is_said_small = is_cut and verdict.order.rstrip(_RAISED) == plain_letter(name)
        if known and is_said_small and name in knowledge.small:
            return describe(state.document, chain, k, _takes_for_small(name, known))
        if known and any(_has_no_sum(side, name, knowledge) for side in sides):
            return describe(
                state.document, chain, k, Decision(UNDECIDED, f"a series without a sum for {known}")
            )
        has_dots = any(_is_cut(side) and not _stands_below(side, name) for side in sides)
        if known and has_dots and not all(_is_entire(side, name) for side in sides):
            return describe(state.document, chain, k, _takes_for_small(name, known))
    return verdict


def _takes_for_small(name: str, known: str) -> Decision:
    return Decision(UNDECIDED, f"it takes {plain_letter(name)} for small: {known}")


def _is_cut(node: Formula) -> bool:
    return any(isinstance(part, Dots) for part in walk(node))


def _stands_below(node: Formula, name: str) -> bool:
    """Tell whether a letter stands in denominators alone: the series is one of 1/λ, where λ is large."""
    below = [part.denominator for part in walk(node) if isinstance(part, Quotient)]
    inner = {id(part) for each in below for part in walk(each)}
    own = [part for part in walk(node) if isinstance(part, Name) and part.name == name]
    return all(id(part) in inner for part in own)


def _is_series(node: Formula) -> bool:
    """Tell whether a sum without end stands in a formula, or dots do."""
    return any(isinstance(part, Dots) or is_infinite(part) for part in walk(node))


def _has_no_sum(node: Formula, name: str, knowledge: Knowledge) -> bool:
    """Tell whether the terms of a sum without end grow at the number that a letter has."""
    definition = knowledge.definitions.get(name)
    sums = [part for part in parts_of_kind(node, Summation) if is_infinite(part)]
    if definition is None or not definition.numeric:
        return False
    for each in sums:
        if each.index is None or name not in names(each.body):
            continue
        try:
            terms = [
                substitute(
                    substitute(
                        at_index(each.body, each.index.name, n), each.index.name, Number(Fraction(n))
                    ),
                    name,
                    definition.node,
                )
                for n in _FAR_OUT
            ]
        except NoFormError:
            continue
        points = sample_trees(terms, knowledge.meaning, 1)
        sizes = [abs(size) for size in points[0][1]] if points else []
        if sizes and all(second > first for first, second in pairwise(filter(None, sizes))):
            return True
    return False


def _is_entire(node: Formula, name: str) -> bool:
    """Tell whether a letter stands in no root, logarithm or denominator of a formula."""
    for part in walk(node):
        if isinstance(part, Quotient) and name in names(part.denominator):
            return False
        if isinstance(part, Call) and part.function not in _ENTIRE and name in names(part.argument):
            return False
        if isinstance(part, Power) and name in names(part.base) and not _is_natural(part.exponent):
            return False
        if isinstance(part, Apply) and any(name in names(each) for each in part.arguments):
            return False
    return True


def _is_natural(exponent: Formula) -> bool:
    return isinstance(exponent, Number) and exponent.value.denominator == 1 and exponent.value >= 0
