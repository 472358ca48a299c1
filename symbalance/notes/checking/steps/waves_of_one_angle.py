"""A sine, cosine or tangent drawn from another one of the same angle: sin θ = 0.6, so cos θ = 0.8.

Of a crank angle each is a condition, true at some angles. Where one is said to follow from the other
there is but one size that it can have; which sign, the quadrant says.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Quotient,
    Sum,
    names,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, Verdict
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_FUNCTIONS = ("sin", "cos", "tan")
_FARTHEST = 160
"""Characters between the two."""
_FOLLOWS = re.compile(r"(?<![A-Za-z])(?:folgt|ergibt|liefert|follows?|gives?|yields?|donne)(?![A-Za-z])")
_APART = re.compile(
    r"[.!?](?:\s|$)|[。]|\n\s*\n|±|\\pm|(?<![A-Za-z])(?:or|either|oder|entweder|bzw|ou|soit|o|while|whereas|but|at|where|when"
    r"|during|bei|wo|wenn)(?![A-Za-z])|または",
    re.IGNORECASE,
)
"""What ends a conclusion, or tells of more than one angle."""


def unless_of_one_angle(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; cos θ = 0.9 is refuted where it is said to follow from sin θ = 0.6."""
    given = _wave_given(chain, k)
    if given is None or verdict.verdict != CONDITION:
        return verdict
    function, angle, _ = given
    text = state.document.text
    last = state.sections.chain_before(chain.start)
    before = None if last is None else _wave_given(last, len(last.relations) - 1)
    if last is None or before is None or before[0] == function or before[1] != angle:
        return verdict
    between = text[last.end : chain.start]
    is_drawn = state.sections.is_consequence(chain) or _FOLLOWS.search(between)
    has_both = any(sign in text[chain.start : chain.end] for sign in ("±", "\\pm"))
    is_apart = _APART.search(between) or _APART.match(text, chain.end) or len(between) > _FARTHEST
    if not is_drawn or has_both or is_apart:
        return verdict
    size = _size(before[0], before[2], function)
    known = Knowledge(SymbolValue())
    decisions = [
        decide(Side((node,), chain.sides[k].span), chain.sides[k + 1], "≈", known)
        for node in (size, Negative(size))
    ]
    if any(decision.status != REFUTED for decision in decisions):
        return verdict
    reason = f"not of the angle whose {before[0]} is given in line {last.lines[0]}"
    return describe(state.document, chain, k, Decision(REFUTED, reason, witness=decisions[0].witness))


def _wave_given(chain: Chain, k: int) -> tuple[str, str, Formula] | None:
    """Return the function, the angle and the value of sin θ = 0.6; None for another relation."""
    node, value = chain.sides[k].node, chain.sides[k + 1].node
    if not isinstance(node, Call) or not isinstance(node.argument, Name):
        return None
    if node.function not in _FUNCTIONS or chain.relations[k].sign not in "=≈" or names(value):
        return None
    return node.function, node.argument.name, value


def _size(function: str, value: Formula, wanted: str) -> Formula:
    """Return the size that another function has of the angle of which one has a value."""
    one = Number(Fraction(1))
    square = Power(value, Number(Fraction(2)))
    rest = Call("sqrt", Sum((one, square if function == "tan" else Negative(square))))
    if function == "tan":
        return Quotient(value if wanted == "sin" else one, rest)
    if wanted != "tan":
        return rest
    return Quotient(value, rest) if function == "sin" else Quotient(rest, value)
