"""Motions of a slider-crank that words name: in the lower dead centre the acceleration is r ω² (1 - λ).

The words, the index of the letter, the row of a table or a heading say which motion it is and at which
place of the crank (`motion_words`). The letters of its formula are known by the page, or as is usual: the
one in a sine is the crank angle. Then it is compared with the catalogue's formulas:

    it agrees, exactly or through its power of r/l    conditional on what the letter is taken to be
    one change makes it agree                         refuted, with that change
    anything else                                     None: a definition, as before

A ratio λ of which nothing says whether it is r/l or l/r may be either, and both directions of a motion
are right.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import NamedTuple

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    PI,
    Call,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.letters_in_waves import WAVES, letters_in_waves
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide, decide_at_value
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import MOVING, role_of
from symbalance.notes.checking.meant.catalogue.kinematics import (
    ACCELERATION,
    AT_TOP_FROM_TOP,
    BOTTOM,
    FASTEST,
    JERK,
    LARGEST,
    LEAST,
    MOTIONS,
    OFFSET,
    PATH,
    RIGHT,
    ROD_ACCELERATION,
    ROD_SPEED,
    SHORTENING,
    SPEED,
    STROKE,
    TOP,
    TURNED,
    Motion,
)
from symbalance.notes.checking.meant.formula_slips import value_at
from symbalance.notes.checking.meant.letter_roles import renamed
from symbalance.notes.checking.meant.meant_words import NOBODY, MeantWords
from symbalance.notes.checking.meant.pistons.motion_letters import (
    MotionLetters,
    Reading,
    known_of,
    values_in,
    with_letter_e,
    with_roles,
)
from symbalance.notes.checking.meant.pistons.motion_numbers import MotionNumbers
from symbalance.notes.checking.meant.pistons.motion_slips import (
    POINTS,
    agreement,
    factor_between,
    slips,
)
from symbalance.notes.checking.meant.pistons.motion_words import OF_ENGINE
from symbalance.notes.checking.meant.pistons.named_motions import Head, NamedMotion, NamedMotions
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import DEFINITION, Verdict
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

SEARCH, SHARE = Budget(6), 0.7
"""What it may take alone, and its part of a budget around it: a definition stays one without."""
MOST_LETTERS = 5
_FROM_ELSEWHERE = re.compile(
    r"\b(?:from|von|vom|ab)\b[^.\n]{0,40}?(?:\bbottom|lower dead|\bBDC\b|vertical|horizontal"
    r"|perpendicular|unteren? totp|\bUT\b|senkrecht|waagrecht|vertikal|lotrecht)"
    r"|(?:下死点|水平|鉛直|垂直)[^。\n]{0,10}から",
    re.IGNORECASE,
)
_FUNCTIONS = frozenset({"sqrt", "sin", "cos", "tan", "asin", "acos", "atan"})
_ANGLES: Mapping[str, Formula] = {
    TOP: Number(Fraction(0)), BOTTOM: PI, RIGHT: Quotient(PI, Number(Fraction(2))),
}  # fmt: skip
_WHERE = {
    TOP: " at top dead centre", BOTTOM: " at bottom dead centre", RIGHT: " a quarter turn behind the top",
    LARGEST: ", its largest value", LEAST: ", its smallest value",
}  # fmt: skip
_PART = re.compile(
    r"\bhalf\b|\btwice|\bdouble|\beach\b|\bboth\b|\btwo\b|total|\bhalbe?\b|doppelt|zweifach|半|倍|両"
    r"|\bsum\b|amplitude|peak[- ]to[- ]peak|\brange\b|per\b|proportion",
    re.IGNORECASE,
)
"""Words that make a part or a multiple of a motion."""
_ROUGHLY = re.compile(
    r"approx|roughly|nearly|small|about|näherung|annähernd|etwa|klein|ungefähr|近似|ほぼ|小さ|environ|petit|aprox|peque"
    r"|appross|circa|piccol",
    re.IGNORECASE,
)
"""Words by which a formula is meant roughly, for small angles."""
_UNCERTAIN = re.compile(r"missing|too many|differentiation")
"""Changes after which another quantity may stand there."""


class _Claim(NamedTuple):
    """What a relation says of a letter, and what is known at it."""

    chain: Chain
    head: Head
    formula: Formula
    knowledge: Knowledge
    declared: str
    """What a symbols file says of the letter."""


@dataclass
class CrankMotions:
    """Judges the motions of one page."""

    document: ReadNotes
    sections: Sections
    words: MeantWords

    def __post_init__(self) -> None:
        self.named = NamedMotions(self.document, self.sections)
        self.letters = MotionLetters(self.document, self.words)
        self.numbers = MotionNumbers(self.document)

    @cached_property
    def is_of_crank(self) -> bool:
        """Tell whether the page is about a slider-crank at all."""
        return OF_ENGINE.search(self.named.page) is not None

    @cached_property
    def counts_from_elsewhere(self) -> bool:
        """Tell whether an angle may be counted from another place than the top dead centre."""
        return _FROM_ELSEWHERE.search(self.named.page) is not None

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a named motion its formula; None for others.

        A search that was given up leaves a definition that says so.
        """
        claim = self._claim(chain, k, knowledge)
        if claim is None:
            return None
        case, letters = claim, names(claim.formula)
        if case.formula == Number(Fraction(0)):
            return self._zero(case)
        if not letters:
            return self._number(case)
        is_of_itself = case.head.name in letters and not case.head.order  # β̇ may have cos β below
        if not _has_motion_form(case.formula) or is_of_itself:
            return None
        try:
            return run_within(SEARCH, lambda: self._judge(case), SHARE)
        except OverBudgetError as problem:
            reason = f"whether its words name a motion was not decided within {problem.spent}"
            return Decision(DEFINITION, reason)

    def again(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the proof of a relation that is false at any angle, at the place that its words name.

        An angle at which the piston is fastest, and what the inclined rod shortens, may be given roughly.
        """
        case = self._claim(chain, k, knowledge)
        if case is None or not _has_motion_form(case.formula):
            return None
        named = self.named.named(chain, case.head, case.formula)
        if named is None:
            return None
        if named.kind in (FASTEST, SHORTENING):
            agreeing = (self._agreeing(case, named, each) for each in self._readings(case))
            return next((decision for decision in agreeing if decision is not None), None)
        if len(named.places) != 1 or named.places[0] not in _ANGLES:
            return None
        behind = names_behind(chain.sides[0].node, {n: d.node for n, d in knowledge.definitions.items()})
        turned = {n for d in knowledge.definitions.values() for n in letters_in_waves(d.node)} & {*behind}
        if len(turned) != 1:
            return None
        (theta,) = turned
        others = {n: d for n, d in knowledge.definitions.items() if n != theta}
        known = replace(knowledge, definitions=others)
        side, angle = chain.sides[0], _ANGLES[named.places[0]]
        there = decide_at_value(side, chain.sides[1], chain.relations[0].sign, known, theta, angle)
        place = f"{plain_letter(case.head.name)} is meant{_WHERE[named.places[0]]}, by the words before"
        return replace(there, assumptions=(*there.assumptions, place)) if there.is_proved else None

    def _claim(self, chain: Chain, k: int, knowledge: Knowledge) -> _Claim | None:
        """Return what a relation says of a letter that nobody declared; None for another relation."""
        head = _head(chain.sides[k].node)
        if k or head is None or chain.relations[0].sign not in ("=", "≈") or not self.is_of_crank:
            return None
        declared = knowledge.meanings.get(head.name, "")
        is_motion = role_of(declared) in MOVING and bool(names(chain.sides[1].node))
        if head.name in knowledge.letters and not is_motion:
            return None
        formula = without_dots(chain.sides[1].node)[0]
        formula = with_letter_e(formula) if self.named.is_offset else formula
        return _Claim(chain, head, formula, knowledge, declared)

    def _readings(self, case: _Claim) -> list[Reading]:
        line = case.chain.lines[0]
        readings = self.letters.readings(
            case.formula, case.knowledge, line, is_offset=self.named.is_offset
        )
        return list(readings)

    def _judge(self, case: _Claim) -> Verdict | Decision | None:
        named = self.named.named(case.chain, case.head, case.formula, case.declared)
        if named is None:
            return None
        readings, head = self._readings(case), case.head
        if named.kind == STROKE:
            readings = [each for each in readings if "s" not in each.letters.values()]
        if self.named.is_offset:
            readings = [each for each in readings if "e" in each.letters.values()]
        self.named.spots.setdefault(head.name, named.places)
        motions = [self.table[named.kind, p] for p in named.places if (named.kind, p) in self.table]
        if not motions or not readings:
            return None
        self.named.kinds.setdefault((head.stem, head.order), named.kind)
        agreeing = (self._agreeing(case, named, reading) for reading in readings)
        decision = next((each for each in agreeing if each is not None), None)
        if decision is not None:
            return decision
        is_known = head.name in case.knowledge.definitions
        if not named.is_sure or is_known or self._agrees_elsewhere(case, named, readings):
            return None
        motions = [*(Motion(each.exact, each.rough[:1]) for each in motions), *motions]
        is_sole = len({each.is_inverse for each in readings}) == 1
        verdicts = (
            self._with_slip(case, named, motion, reading, is_sole=is_sole)
            for reading in readings
            for motion in motions
        )
        return next((verdict for verdict in verdicts if verdict is not None), None)

    @property
    def table(self) -> Mapping[tuple[str, str], Motion]:
        """The formulas of the page's crank drive, offset or not."""
        return OFFSET if self.named.is_offset else MOTIONS

    def _zero(self, case: _Claim) -> Decision | None:
        """Return the proof that a motion is zero at a place where it is."""
        named = self.named.named(case.chain, case.head, case.formula, case.declared)
        if named is None or self.named.is_offset:
            return None
        self.named.spots.setdefault(case.head.name, named.places)
        motions = [MOTIONS.get((named.kind, place)) for place in named.places]
        if not all(motion is not None and case.formula in motion.exact for motion in motions):
            return None
        return Decision(PROVED, assumptions=(_text(case.head, named, named.places[0]),))

    def _number(self, case: _Claim) -> Decision | None:
        """Return the decision on a number of a named motion, by the sizes that the page names."""
        head = case.head
        if head.function or head.order:
            return None
        named = self.named.named(case.chain, head, case.formula, case.declared)
        named = named if named is not None and named.is_sure else None
        if named is not None:
            self.named.kinds.setdefault((head.stem, 0), named.kind)
        kind, places = (named.kind, named.places) if named is not None else ("", ())
        return self.numbers.judge(case.chain, self.named.words_of(case.chain), kind, places, head.name)

    def _agreeing(self, case: _Claim, named: NamedMotion, reading: Reading) -> Decision | None:
        """Return the proof that a claim is a motion's formula, in either direction.

        An angle of the rod with dots has its own direction: β̈ = -λ ω² sin θ of sin β = λ sin θ.
        """
        counted = (case.head.stem, case.head.order)
        for place in named.places:
            signs = self._directions(named.kind, case, place)
            motion = self.table.get((named.kind, place))
            if (named.kind, place) == (PATH, TOP) and self.words.travels_from_top:
                motion = AT_TOP_FROM_TOP
            for turned in () if motion is None else self._counted(motion, named):
                agreeing = agreement(
                    _inside(turned, case.head.function), case.formula, values_in(reading), signs
                )
                if agreeing is None:
                    continue
                target, sign, how = agreeing
                if how.isdigit() and self._is_of_other_function(case, turned, reading):
                    return None
                node = reading.target(Negative(target) if sign < 0 else target)
                sides = case.chain.sides
                if not how and node is not None:
                    known = known_of(case.formula, reading, case.chain)
                    if decide(Side((node,), sides[0].span), sides[1], "=", known).status == REFUTED:
                        return None
                if place not in (LARGEST, LEAST):
                    self.named.directions.setdefault(counted, sign)
                texts = [_text(case.head, named, place), *_letters(reading)]
                texts += ["the rod is long"] if how == "rough" else []
                order = f"{_ratio_text(reading)}^{how}" if how.isdigit() else ""
                return Decision(PROVED, order=order, assumptions=tuple(texts))
        return None

    def _is_of_other_function(self, case: _Claim, motion: Motion, reading: Reading) -> bool:
        """Tell whether a claim is the exact sine of an angle, where the page has = and its tangent.

        tan β = λ sin φ holds to first order; but it is what sin β is, and no word calls it rough.
        """
        if not case.head.function or case.chain.relations[0].sign != "=":
            return False
        if _ROUGHLY.search(self.named.clause(case.chain)):
            return False
        values, exact = values_in(reading), Motion(motion.exact)
        found = (
            agreement(_inside(exact, function), case.formula, values, (1,))
            for function in WAVES - {case.head.function}
        )
        return any(each is not None and not each[2] for each in found)

    def _directions(self, kind: str, case: _Claim, place: str) -> tuple[int, ...]:
        """Return the directions in which a motion may be counted: as it was above, or either.

        The rod's angular acceleration is counted as its angular velocity is, and the acceleration a
        quarter turn behind the top has the sign that the page has written at the bottom.
        """
        first = self.named.directions.get((case.head.stem, case.head.order))
        if kind == ROD_ACCELERATION and not place and first is None:
            first = self._direction_of_rod(case)
        if kind == ACCELERATION and place == RIGHT and self._is_negative_at_bottom(case):
            return (-1,)
        return _signs(kind, case.head) if first is None else (first,)

    def _is_fixed_by_another(self, kind: str, case: _Claim, place: str) -> bool:
        """Tell whether another letter, or another place, fixes the direction in which a motion counts."""
        if (case.head.stem, case.head.order) in self.named.directions:
            return False
        directions = self._directions(kind, case, place)
        return len(directions) == 1 and directions != _signs(kind, case.head)

    def _direction_of_rod(self, case: _Claim) -> int | None:
        """Return the direction in which a line above counts the angular velocity ω_rod; or None."""
        for chain in self.document.chains:
            head = _head(chain.sides[0].node)
            if head is None or head.stem != "omega" or len(chain.sides) == 1:
                continue
            if chain.start < case.chain.start and (sign := self._sign_of(chain, case, (ROD_SPEED, ""))):
                return sign
        return None

    def _is_negative_at_bottom(self, case: _Claim) -> bool:
        """Tell whether a line above has the acceleration at the bottom with its minus sign."""
        above = self.sections.chains_of(Name(case.head.name))
        near = (c for c in above if c.start < case.chain.start and isinstance(c.sides[1].node, Negative))
        return any(self._sign_of(chain, case, (ACCELERATION, BOTTOM)) == -1 for chain in near)

    def _sign_of(self, chain: Chain, case: _Claim, motion: tuple[str, str]) -> int | None:
        """Return the sign with which a relation gives a motion's formula; None for another formula."""
        formula = without_dots(chain.sides[1].node)[0]
        if not _has_motion_form(formula):
            return None
        other = case._replace(chain=chain, formula=formula)
        for reading in self._readings(other):
            agreeing = agreement(self.table[motion], formula, values_in(reading), (1, -1))
            if agreeing is not None:
                return agreeing[1]
        return None

    def _counted(self, motion: Motion, named: NamedMotion) -> Iterator[Motion]:
        """Yield a motion, and with the crank angle counted from the bottom where the page may do so.

        Where it says that it does, the angle is counted from nowhere else.
        """
        may_turn = not named.places[0] and named.kind in TURNED
        if not (may_turn and self.words.has_angle_from_bottom):
            yield motion
        if may_turn and (self.counts_from_elsewhere or self.words.has_angle_from_bottom):
            turned = {"theta": Name("theta") + PI}
            shifted = (
                tuple(with_roles(n, turned) for n in nodes) for nodes in (motion.exact, motion.rough)
            )
            yield Motion(*shifted)

    def _agrees_elsewhere(self, case: _Claim, named: NamedMotion, readings: list[Reading]) -> bool:
        """Tell whether a claim is a formula of the motion at another place that no words exclude."""
        if named.places in ((TOP,), (BOTTOM,), (RIGHT,)) and not named.may_be_other:
            return False
        head = case.head
        if self._is_fixed_by_another(named.kind, case, named.places[0]):
            return False
        found = (
            (
                agreement(
                    _inside(motion, head.function), case.formula, values_in(reading), _signs(kind, head)
                ),
                motion,
                reading,
            )
            for reading in readings
            for (kind, place), motion in self.table.items()
            if kind == named.kind and (place or not named.places[0])
        )
        return any(
            each is not None
            and not (each[2].isdigit() and self._is_of_other_function(case, motion, reading))
            for each, motion, reading in found
        )

    def _with_slip(
        self, case: _Claim, named: NamedMotion, motion: Motion, reading: Reading, *, is_sole: bool
    ) -> Verdict | None:
        """Return that a claim is wrong by one change, with that change; None where that is open.

        `is_sole` tells whether the page leaves one reading of its ratio.
        """
        is_elsewhere = self.counts_from_elsewhere or self.words.has_angle_from_bottom
        if is_elsewhere and not named.places[0]:
            return None
        by_head = self._with_other_function(case, named, motion, reading)
        if by_head is not None:
            return by_head
        motion, side = _inside(motion, case.head.function), case.chain.sides[1]
        is_part = _PART.search(self.named.clause(case.chain)) is not None
        changes = (*slips(case.formula), *_wholes(case.formula, reading, is_sole, is_part))
        directions = self._directions(named.kind, case, named.places[0])
        is_fixed = self._is_fixed_by_another(named.kind, case, named.places[0])
        if named.kind not in TURNED:  # the cosine of an angle has its sign, whatever way things count
            is_fixed = True
        if is_fixed:  # by another letter, or by another place: the sign is no matter of taste
            changes = (*changes, ("sign", Negative(case.formula)))
        for sign, (kind, changed) in product(directions, changes):
            if names(changed) - names(case.formula) or changed == case.formula or _UNCERTAIN.search(kind):
                continue
            if agreement(motion, changed, values_in(reading), (sign,)) is None:
                continue
            factor = factor_between(case.formula, changed, values_in(reading))
            if factor is not None and ((factor < 0 and not is_fixed) or is_part):
                continue
            known = known_of(case.formula, reading, case.chain)
            if decide(Side((changed,), case.chain.sides[0].span), side, "=", known).status == PROVED:
                continue
            texts = [_text(case.head, named, named.places[0]), *_letters(reading)]
            decision = replace(_refuted(case.formula, changed, reading), reason="if " + "; ".join(texts))
            verdict = describe(self.document, case.chain, 0, decision)
            repair = Repair(kind, changed, ((side.node, changed),), 1.0)
            return replace(verdict, fix=fix_of(repair, self.document, side))
        return None

    def _with_other_function(
        self, case: _Claim, named: NamedMotion, motion: Motion, reading: Reading
    ) -> Verdict | None:
        """Return that a claim is the angle's sine where the page has its tangent, or the like."""
        values, side = values_in(reading), case.chain.sides[1]
        for function in sorted(WAVES - {case.head.function}) if case.head.function else ():
            exact = Motion(motion.exact)
            if agreement(_inside(exact, function), case.formula, values, (1,)) is None:
                continue
            angle = motion.exact[0]
            target = reading.target(Call(case.head.function, angle))
            if target is None:
                continue
            texts = [_text(case.head, named, named.places[0]), *_letters(reading)]
            decision = replace(_refuted(case.formula, target, reading), reason="if " + "; ".join(texts))
            verdict = describe(self.document, case.chain, 0, decision)
            repair = Repair(f"{case.head.function} for {function}", target, ((side.node, target),), 1.0)
            return replace(verdict, fix=fix_of(repair, self.document, side))
        return None


def _head(left: Formula) -> Head | None:
    """Return the function, the letter and the times it is differentiated of a left side: sin β, ẍ."""
    function, order = "", 0
    if isinstance(left, Call) and left.function in WAVES:
        function, left = left.function, left.argument
    if isinstance(left, Derivative) and left.variable == Name("t"):
        order, left = left.order, left.expression
    return Head(function, left.name, order) if isinstance(left, Name) else None


def _inside(motion: Motion, function: str) -> Motion:
    """Return a motion of whose angle the page gives a sine, a cosine or a tangent."""
    if not function:
        return motion
    return Motion(
        tuple(Call(function, node) for node in motion.exact),
        tuple(Call(function, node) for node in motion.rough),
    )


def _signs(kind: str, head: Head) -> tuple[int, ...]:
    """Return the directions in which a motion may be counted."""
    is_of_letter = head.order > 0 and kind in (ROD_SPEED, ROD_ACCELERATION)
    return (1, -1) if kind in TURNED and not head.function and not is_of_letter else (1,)


def _text(head: Head, named: NamedMotion, place: str) -> str:
    whose = "piston's " if named.kind in (PATH, SPEED, ACCELERATION, JERK) else ""
    what = f"{plain_letter(head.name)} is the {whose}{named.kind}{_WHERE.get(place, '')}"
    return f"{what} ({NOBODY}; taken from the words “{named.words}”)"


def _letters(reading: Reading) -> list[str]:
    ratios = [letter for letter, role in reading.letters.items() if role == "ratio"]
    return [f"{plain_letter(letter)} is {'l/r' if reading.is_inverse else 'r/l'}" for letter in ratios]


def _ratio_text(reading: Reading) -> str:
    return next((plain_letter(n) for n, role in reading.letters.items() if role == "ratio"), "(r/l)")


def _has_motion_form(formula: Formula) -> bool:
    """Tell whether a formula has few letters, no decimals, and no functions but of angles and roots."""
    if len(names(formula)) > MOST_LETTERS or decimals(formula):
        return False
    parts = list(walk(formula))
    calls = all(part.function in _FUNCTIONS for part in parts if isinstance(part, Call))
    return calls and not any(isinstance(part, Derivative) for part in parts)


def _wholes(
    claim: Formula, reading: Reading, is_sole: bool, is_part: bool
) -> Iterator[tuple[str, Formula]]:
    """Yield a claim with one thing changed wherever it stands, or as a whole."""
    of = {role: letter for letter, role in reading.letters.items()}
    if "ratio" in of and is_sole:
        inverse = Quotient(Number(Fraction(1)), Name(of["ratio"]))
        yield "rod ratio inverted", substitute(claim, of["ratio"], inverse)
    if {"r", "l"} <= {*of}:
        yield "lengths exchanged", renamed(claim, {of["r"]: of["l"], of["l"]: of["r"]})
    if not is_part:
        yield from ((f"factor {f}", Product((Number(f), claim))) for f in (Fraction(1, 2), Fraction(2)))


def _refuted(claim: Formula, changed: Formula, reading: Reading) -> Decision:
    """Return that two formulas differ, with their values at a point as witness."""
    point = reading.point(POINTS[0])
    shown = {plain_letter(letter): f"{float(value):.6g}" for letter, value in point.items()}
    left, right = value_at(changed, point), value_at(claim, point)
    return Decision(REFUTED, witness={**shown, "left": f"{left:.6g}", "right": f"{right:.6g}"})
