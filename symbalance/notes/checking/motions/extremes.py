"""Largest and smallest values of a motion by their letters: a_max = r ω² (1 + λ), â, x_max, a_UT.

At a dead centre the value is exact, and that no other angle has a larger one is looked at on a grid. Of
others the claim is compared with the largest value by numbers: it is refuted where it is far off, and
holds within the error that is named.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import Constant, Derivative, Formula, Name, Negative, Number, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.letters_behind import letters_behind
from symbalance.notes.algebra.tree_values import NO_VALUE, DerivativeForms, TreeValues
from symbalance.notes.algebra.values import Point, context, random_point
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision, digits
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide_at_value
from symbalance.notes.checking.words.case_words import opens_case
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

_PLACES = {"OT": 0, "TDC": 0, "top": 0, "UT": 1, "BDC": 1, "bot": 1, "bottom": 1}
"""Subscripts that name a dead centre: the crank angle there in half turns."""
GRID = 120
"""Angles of one turn: a value between two of them is off by 1e-3 of the amplitude at most."""
NEAR, FAR = 0.005, 0.08
"""Relative errors: below the first ≈ is right, above the second no approximation is meant."""
POINTS = 3
_LONG_RODS = Fraction(10), Fraction(20)
"""Rods by which the order of an error is told, in cranks."""
_LEAST, _HALF = 0.02, (1.7, 2.4)
"""An error of the first order with the shorter of them, at least, and how much larger it is there."""
NOTHING: Mapping[str, Fraction] = {}
BY_NUMBERS = "relative error"
_LINK = re.compile(r"[\s$,:)}\]°]*(?:(?!(?:and|und|et|while|or)\b)[^\W\d_]+\s+){0,4}[\s$({\[\\]*")
_AT = re.compile(r"[\s$,)}\]]*(?:\(|[^\W\d_]+\s+){1,3}[\s$({\[\\]*")
_CLAUSE_END = re.compile(r"[\s$)}\]°]*(?:[.;。]|\n\s*\n|\Z)")
"""Between an extreme and the angle before or behind it, and behind that angle."""


def motion_of(name: str, knowledge: Knowledge) -> tuple[Formula, str] | None:
    """Return the motion whose extreme a letter is, and which: ẍ and "max" of ddot_x_max; else None."""
    stem, _, which = name.rpartition("_")
    if name.startswith("hat_"):
        stem, which = name[len("hat_") :], "max"
    if which not in (*_PLACES, "max", "min") or knowledge.crank is None or not theta_name(knowledge):
        return None
    order = next((n for mark, n in (("ddot_", 2), ("dot_", 1)) if stem.startswith(mark)), 0)
    base = stem.rpartition("dot_")[2].removeprefix("d") if order else stem
    if base not in knowledge.moving or base not in knowledge.meaning.values:
        return None
    motion: Formula = Name(base)
    return (Derivative(motion, Name(knowledge.crank.time), order) if order else motion), which


def decide_extreme(left: Side, right: Side, sign: str, knowledge: Knowledge) -> Decision | None:
    """Decide what a line says of the extreme of a motion; None where it says nothing of one.

    A number alone is data. An angle in the value makes it another thing's.
    """
    name = left.node.name if isinstance(left.node, Name) else ""
    described = motion_of(name, knowledge) if name and not knowledge.knows(name) else None
    own = names(right.node)
    if described is None or not own or own & (knowledge.angles | knowledge.moving):
        return None
    motion, which = described
    values = list(knowledge.levels(motion, right.node))[-1].values
    speed = knowledge.crank.omega if knowledge.crank else motion
    behind = {n for node in (motion, speed) for n in letters_behind(node, values)}
    if not {*letters_behind(right.node, values)} <= behind:
        return None  # F_max = p A: what else is in it nothing says
    if which in _PLACES:
        return _at_place(motion, right, sign, _PLACES[which], knowledge)
    for place in (0, 1):
        at_centre = at_dead_centre(motion, right, sign, place, knowledge)
        if at_centre.is_proved:
            return _if_extreme(at_centre, motion, right.node, which, place, knowledge)
    return _by_numbers(motion, right.node, which, knowledge)


def decide_place(extreme: Decision, chain: Chain, document: ReadNotes, knowledge: Knowledge) -> Decision:
    """Return the decision on a proved extreme as that at the angle its clause names: at θ = π it is not.

    An extreme between the dead centres is near an angle, not at it: of that nothing is said.
    """
    named = _place_named(chain, document, theta_name(knowledge))
    head, right = chain.sides[0].node, chain.sides[1]
    described = motion_of(head.name, knowledge) if isinstance(head, Name) else None
    if (
        not extreme.is_proved
        or extreme.order.startswith(BY_NUMBERS)
        or named is None
        or described is None
    ):
        return extreme
    motion = Side((described[0],), chain.sides[0].span)
    there = decide_at_value(
        motion, right, chain.relations[0].sign, knowledge, theta_name(knowledge), named
    )
    if there.status != REFUTED:
        return extreme
    return replace(there, reason=f"not the value at θ = {formula_text(named, plain=True)}")


def _place_named(chain: Chain, document: ReadNotes, theta: str) -> Formula | None:
    """Return the crank angle that stands right before a relation (at θ = π, …) or ends its clause."""
    start, end = chain.sides[0].span[0], chain.sides[-1].span[1]
    before: Formula | None = None
    for other in document.chains:
        if len(other.sides) != 2 or other.sides[0].node != Name(theta) or names(other.sides[1].node):
            continue
        first, last = other.sides[0].span[0], other.sides[1].span[1]
        text = document.text
        if last <= start and opens_case(text, first, last) and _LINK.fullmatch(text, last, start):
            before = other.sides[1].node
        if end <= first and _AT.fullmatch(text, end, first) and _CLAUSE_END.match(text, last):
            return other.sides[1].node
    return before


def at_dead_centre(motion: Formula, right: Side, sign: str, place: int, knowledge: Knowledge) -> Decision:
    """Return the decision on the motion's value at top dead centre, or at bottom dead centre."""
    angle: Formula = Constant("pi") if place else Number(Fraction(0))
    return decide_at_value(
        Side((motion,), right.span), right, sign, knowledge, theta_name(knowledge), angle
    )


def theta_name(knowledge: Knowledge) -> str:
    """Return the crank angle's letter, "" where none is declared."""
    theta = knowledge.crank.theta if knowledge.crank else None
    return theta.name if isinstance(theta, Name) else ""


def _at_place(motion: Formula, right: Side, sign: str, place: int, knowledge: Knowledge) -> Decision:
    """Return the decision on a value at a dead centre that the letter names; sizes have no sign."""
    decision = at_dead_centre(motion, right, sign, place, knowledge)
    negative = Side((Negative(right.node),), right.span)
    if decision.status == REFUTED and at_dead_centre(motion, negative, sign, place, knowledge).is_proved:
        return replace(decision, status=UNDECIDED, reason="true of its size, not of its sign")
    return decision


def _if_extreme(
    at_centre: Decision, motion: Formula, claim: Formula, which: str, place: int, knowledge: Knowledge
) -> Decision:
    """Return the decision on a value at a dead centre that is to be the extreme of a turn.

    r ω² (1 - λ) is the smallest acceleration for a long rod only: of others it is the one at π.
    """
    where = f"θ = {'π' if place else '0'}"
    if _is_extreme(motion, claim, which, knowledge):
        return replace(at_centre, reason=at_centre.reason or f"at {where}")
    by_numbers = _by_numbers(motion, claim, which, knowledge)
    if by_numbers.status == REFUTED or which != "min" or not place:
        return by_numbers
    return replace(at_centre, assumptions=(*at_centre.assumptions, f"it is at {where}"))


def values_over_turn(
    motion: Formula, claim: Formula, knowledge: Knowledge, fixed: Mapping[str, Fraction] = NOTHING
) -> list[tuple[Point, list[Any], Any]]:
    """Return points of the letters, with the motion's values over a turn and the claim's there.

    The letters `fixed` have these values at every point.
    """
    level = list(knowledge.levels(motion, claim))[-1]
    meaning = replace(knowledge.meaning, values=level.values)
    theta = theta_name(knowledge)
    open_letters = {n for node in (motion, claim) for n in letters_behind(node, level.values)} - {theta}
    rows: list[tuple[Point, list[Any], Any]] = []
    derivatives: DerivativeForms = {}  # the same forms at every point
    for seed in range(POINTS if open_letters else 1):
        point = random_point(sorted(open_letters), meaning.domain(), seed)
        point |= {name: value for name, value in fixed.items() if name in point}
        try:
            turn = [
                TreeValues(meaning, {**point, theta: Fraction(44, 7) * k / GRID}, derivatives)
                .value(motion)
                .real
                for k in range(GRID)
            ]
            rows.append((point, turn, TreeValues(meaning, point).value(claim).real))
        except NO_VALUE:
            continue
    return rows


def _is_extreme(motion: Formula, claim: Formula, which: str, knowledge: Knowledge) -> bool:
    """Tell whether no angle of the grid has a larger value than the claimed one, or a smaller one."""
    sign = -1 if which == "min" else 1
    tiny = context().mpf(10) ** -12
    rows = values_over_turn(motion, claim, knowledge)
    return bool(rows) and all(
        max(sign * value for value in turn) <= sign * claimed + tiny * abs(claimed)
        for _, turn, claimed in rows
    )


def _by_numbers(motion: Formula, claim: Formula, which: str, knowledge: Knowledge) -> Decision:
    """Return the decision on an extreme between the dead centres."""
    errors: list[Any] = []
    rows = values_over_turn(motion, claim, knowledge)
    for _, turn, claimed in rows:
        largest, smallest = max(turn), min(turn)
        size = max(abs(largest), abs(smallest))
        possible = (largest, size) if which == "max" else (smallest,)
        errors.append(min(abs(claimed - value) for value in possible) / size)
    if not errors:
        return Decision(UNDECIDED, "the extreme of what has no values here")
    if which == "min" and all(claimed > 0 > min(turn) for _, turn, claimed in rows):
        return Decision(UNDECIDED, "the smallest value is negative: say whether its size is meant")
    worst = digits(context().mpf(max(errors)), 2)
    if max(errors) <= NEAR:
        return Decision(
            PROVED, f"within {worst} of the extreme, by numbers", order=f"{BY_NUMBERS} {worst}"
        )
    point, turn, claimed = rows[errors.index(min(errors))]
    extreme = max(turn) if which == "max" else min(turn)
    if min(errors) > FAR:
        witness = {n: f"{float(v):.6g}" for n, v in point.items()}
        witness |= {"left": digits(context().mpf(extreme), 6), "right": digits(context().mpf(claimed), 6)}
        return Decision(REFUTED, "not the largest value of a turn", witness=witness)
    if which == "max" and (letter := _differs_at_first_order(motion, claim, knowledge)):
        witness = {n: f"{float(v):.6g}" for n, v in point.items()}
        witness |= {"left": digits(context().mpf(extreme), 6), "right": digits(context().mpf(claimed), 6)}
        reason = f"differs from the largest value at the first order of {plain_text(Name(letter))}"
        return Decision(REFUTED, reason, witness=witness)
    return Decision(UNDECIDED, f"off by up to {worst} of the extreme: say ≈, and in which letter")


def _differs_at_first_order(motion: Formula, claim: Formula, knowledge: Knowledge) -> str:
    """Return the small letter by which a claim is off in proportion, v_max = r ω (1 + λ/2); "" for none.

    Where the rod is twice as long the error is half as large; of a term that is left out or wrong at the
    second order it is a quarter.
    """
    if knowledge.crank is None or knowledge.crank.small is None:
        return ""
    name, sign = knowledge.crank.small
    errors: list[list[Any]] = []
    for size in _LONG_RODS:
        fixed = {name: size if sign < 0 else 1 / size}
        rows = values_over_turn(motion, claim, knowledge, fixed)
        if not rows or any(name not in point for point, _, _ in rows):
            return ""
        errors.append([abs(claimed - max(turn)) / max(map(abs, turn)) for _, turn, claimed in rows])
    if len(errors[0]) != len(errors[1]):
        return ""
    pairs = zip(*errors, strict=True)
    is_first = all(first > _LEAST and _HALF[0] < first / second < _HALF[1] for first, second in pairs)
    return name if is_first else ""
