"""Which branch of sin φ = (r/l) sin θ is meant: of a crank and its rod, the one with |φ| < π/2.

The equation alone leaves φ and π - φ. A rod that is longer than its crank never stands square to the
cylinder axis, so that a line which is true on the other branch alone is false. Of other letters the
equation decides nothing.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Product
from symbalance.notes.checking.deciding.equality import decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.declared.geometry import geometry
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.premises.constraints import Constraint
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_RATIOS = ("rod ratio l/r", "rod ratio l/s", "crank ratio r/l")

_ROD_ANGLE = re.compile(
    r"(?=.*(?:\brods?\b|\bconrod|pleuel|schubstange|コンロッド|連接棒|連桿))"
    r"(?=.*(?:\bangle|inclin|obliquity|winkel|neigung|角|傾き))",
    re.IGNORECASE | re.DOTALL,
)


def is_rod_angle(state: JudgingState, constraint: Constraint, chain: Chain, knowledge: Knowledge) -> bool:
    """Tell whether a relation fixes the rod's angle, of a crank whose sizes the page names.

    Its letter is not declared, or called the rod's angle in words of the author's own.
    """
    line, name = chain.lines[0], constraint.name
    declared, proposed = state.meant.words.sizes(line)
    if name in declared and not _ROD_ANGLE.search(declared[name]):
        return False
    symbols = {n: m for n, m in {**proposed, **declared}.items() if n != name}
    roles = {role_of(text) for text in symbols.values()}
    has_lengths = "rod length" in roles and bool(roles & {"crank radius", "stroke"})
    if "crank angle" not in roles or not (has_lengths or roles & {*_RATIOS}):
        return False
    crank = geometry(symbols)
    angle = Call("asin", Product((crank.ratio, Call("sin", crank.theta))))
    decision = decide_equality(constraint.node, angle, knowledge)
    return decision.is_proved and decision.through is None and not decision.assumptions
