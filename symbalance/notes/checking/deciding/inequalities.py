"""Decisions on <, >, ≤, ≥ and ≠: proved, refuted, or the statement of where a letter lies."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import Any

from symbalance.document.formula import Formula, Name, Negative, Number, Sum, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import Domain, Monomial, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.roots import is_never_negative
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    digits,
    printed_decimal,
)
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, Level, StatedRange
from symbalance.notes.checking.deciding.satisfiability import TRIES, Survey, sign_at, survey
from symbalance.notes.checking.verdicts import CONTRADICTION, RANGE
from symbalance.notes.reading.equations import Chain

SATISFIED_BY = {"<": (-1,), ">": (1,), "≤": (-1, 0), "≥": (0, 1), "≠": (-1, 1)}
"""The signs of left - right with which an inequality is true."""
FEWEST = 12
"""Points that satisfy earlier ranges, before one is said to contradict them."""
_MIRRORED = {"<": ">", ">": "<", "≤": "≥", "≥": "≤", "≠": "≠"}


def decide_inequality(chain: Chain, k: int, knowledge: Knowledge) -> Decision:
    """Decide an inequality; what some values satisfy and others not states a range.

    In a < x < b the two bounds are compared as well: 1/3 < x < 1/5 holds for no x.
    """
    left, right, sign = chain.sides[k].node, chain.sides[k + 1].node, chain.relations[k].sign
    decision = compare(left, right, sign, knowledge)
    if decision is not None:
        if not _differs_by_branch(left, right, sign, decision, knowledge):
            return decision
        return Decision(RANGE, "says which solution is meant")
    if not names(left) and not names(right):
        return Decision(UNDECIDED, "two numbers that could not be compared")
    proof = _by_form(left, right, sign, knowledge)
    if proof is not None:
        return proof
    signs = {r.sign for r in chain.relations}
    if k == 1 and len(chain.sides) == 3 and (signs <= {"<", "≤"} or signs <= {">", "≥"}):
        strict = sign if sign in "<>" else chain.relations[0].sign
        outer = compare(chain.sides[0].node, chain.sides[2].node, strict, knowledge)
        if outer is not None and not outer.is_proved:
            return Decision(REFUTED, "the range is empty", witness=outer.witness)
    stated = StatedRange(left, sign, right, chain.lines[0])
    contradiction = _contradiction(stated, knowledge)
    return contradiction or _by_survey(stated, knowledge)


def _differs_by_branch(
    left: Formula, right: Formula, sign: str, decision: Decision, knowledge: Knowledge
) -> bool:
    """Tell whether an inequality is true on one branch and false on another: u² = 4, u > 1."""
    for name, definition in knowledge.branches_behind(left, right).items():
        for value, _ in definition.alternatives:
            other = replace(definition, node=value, alternatives=())
            there = compare(left, right, sign, knowledge.with_definition(name, other))
            if there is None or there.status != decision.status:
                return True
    return False


def possible_branches(name: str, definition: Definition, knowledge: Knowledge) -> Definition:
    """Return a letter's definition without the branches on which a range stated of it is true nowhere."""
    branches = [(definition.node, definition.branch), *definition.alternatives]
    possible = [pair for pair in branches if _is_possible(name, pair[0], knowledge)]
    if not possible or len(possible) == len(branches):
        return definition
    (node, condition), *others = possible
    return replace(definition, node=node, branch=condition if others else "", alternatives=tuple(others))


def _is_possible(name: str, value: Formula, knowledge: Knowledge) -> bool:
    values = {n: d.node for n, d in knowledge.definitions.items()}
    meaning = replace(knowledge.meaning, values={**values, **knowledge.meaning.values, name: value})
    for stated in knowledge.ranges:
        if name not in names(stated.left) | names(stated.right):
            continue
        signs = survey(stated.left, stated.right, meaning, roots=False)
        if signs.tried and not any(s in SATISFIED_BY[stated.sign] for s in signs.counts):
            return False
    return True


def compare(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision | None:
    """Decide an inequality between two numbers; None where a letter stands in one."""
    for level in knowledge.levels(left, right):
        evaluator = knowledge.evaluator(level)
        try:
            first, second = evaluator.form(left), evaluator.form(right)
        except (NoFormError, TooLargeError):
            continue
        if values.letters(first) or values.letters(second):
            continue
        same = first.equals(second)
        points = values.sample([first, second])
        if not points:
            return None
        if sign != "≠" and not all(_is_real(value) for value in points[0][1]):
            return Decision(
                UNDECIDED, "one side is not a real number", level=level, left=first, right=second
            )
        gap = points[0][1][0].real - points[0][1][1].real
        holds = (0 if same else 1 if gap > 0 else -1) in SATISFIED_BY[sign]
        witness = {"left": digits(points[0][1][0]), "right": digits(points[0][1][1])}
        if holds:
            return Decision(PROVED, assumptions=level.assumptions, level=level, left=first, right=second)
        return Decision(REFUTED, level=level, left=first, right=second, witness=witness)
    return None


def _is_real(value: Any) -> bool:
    return abs(value.imag) <= abs(value) * values.context().mpf(10) ** -20


def _by_form(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision | None:
    """Decide by the normal form of the difference, where all its terms have one sign."""
    for level in knowledge.levels(left, right):
        evaluator = knowledge.evaluator(level)
        try:
            difference = evaluator.form(Sum((right, Negative(left))))
        except (NoFormError, TooLargeError):
            continue
        if difference.is_zero() and sign in "<>≠":
            reason = "both sides are the same"
            return Decision(REFUTED, reason, level=level, witness=_same_witness(left, right, knowledge))
        if sign != "≠" and _has_sign(difference, sign):
            assumptions = (*level.assumptions, *evaluator.domain.assumptions)
            return Decision(PROVED, assumptions=assumptions, level=level)
    return None


def _same_witness(left: Formula, right: Formula, knowledge: Knowledge) -> Mapping[str, str]:
    level = list(knowledge.levels(left, right))[-1]
    points = survey(left, right, replace(knowledge.meaning, values=level.values), roots=False).examples
    return witness_of(*next(iter(points.values()))) if points else {}


def _has_sign(difference: Form, sign: str) -> bool:
    """Tell whether right - left has the sign an inequality asks for, wherever it is defined."""
    if not difference.is_polynomial:
        return False
    above = difference.numerator
    if sign in ">≥":
        above = {monomial: -coefficient for monomial, coefficient in above.items()}
    if not is_never_negative(difference.domain, above):
        return False
    return sign in "≤≥" or _has_positive_term(difference.domain, above)


def _has_positive_term(domain: Domain, polynomial: Polynomial) -> bool:
    """Tell whether a term is never zero, beside which no wave stands."""
    if any(domain.generators[g].kind == "exponential" for m in polynomial for g, _ in m):
        return False

    def is_never_zero(monomial: Monomial) -> bool:
        generators = [domain.generators[g] for g, _ in monomial]
        return all(generator.positive and generator.kind != "radical" for generator in generators)

    return any(c > 0 and is_never_zero(m) for m, c in polynomial.items())


def _by_survey(stated: StatedRange, knowledge: Knowledge) -> Decision:
    """Refute what is true at no point tried; else it states a range."""
    if lone_letter(stated) is not None:
        return Decision(RANGE)
    level = list(knowledge.levels(stated.left, stated.right))[-1]
    meaning = replace(knowledge.meaning, values=level.values)
    others = [r for r in knowledge.ranges if _shares_letters(r, stated)]
    if (other := next((r for r in others if _leaves_equality(r, stated)), None)) is not None:
        return Decision(RANGE, f"both sides are equal, with {other.text} of line {other.line}")
    if others:
        among = _within(stated, others, meaning)
        if among.tried >= FEWEST and not any(s in SATISFIED_BY[stated.sign] for s in among.counts):
            reason = " and ".join(f"{r.text} of line {r.line}" for r in others[:2])
            reason = f"{_tried(among, 'true at none')} that satisfy {reason}"
            return Decision(CONTRADICTION, reason, witness=_failing(among, stated))
    signs = survey(stated.left, stated.right, meaning, roots=False)
    if not signs.tried:
        return Decision(UNDECIDED, "no point where both sides are real", level=level)
    true = [s for s in signs.counts if s in SATISFIED_BY[stated.sign]]
    # nearly everywhere one side is complex: ζ^q is 1 where it is real
    is_complex = stated.sign == "≠" and signs.tried < TRIES // FEWEST * 2
    if not true and not is_complex:
        witness = _failing(signs, stated)
        return Decision(REFUTED, _tried(signs, "true at none"), level=level, witness=witness)
    is_always = len(true) == len(signs.counts)
    return Decision(RANGE, _tried(signs, "true at all") + ", not proved" if is_always else "")


def _leaves_equality(earlier: StatedRange, stated: StatedRange) -> bool:
    """Tell whether two ranges leave only that both sides are equal: x ≤ y and y ≤ x."""
    if stated.sign not in "≤≥" or earlier.sign not in "≤≥":
        return False
    is_same = (earlier.left, earlier.right) == (stated.left, stated.right)
    is_mirrored = (earlier.left, earlier.right) == (stated.right, stated.left)
    return (is_same and earlier.sign != stated.sign) or (is_mirrored and earlier.sign == stated.sign)


def _shares_letters(earlier: StatedRange, stated: StatedRange) -> bool:
    own = names(stated.left) | names(stated.right)
    return not own.isdisjoint(names(earlier.left) | names(earlier.right))


def _within(stated: StatedRange, others: list[StatedRange], meaning: SymbolValue) -> Survey:
    """Return the signs of an inequality where others are satisfied."""

    def satisfies(point: Mapping[str, Fraction]) -> bool:
        return all(sign_at(r.left, r.right, meaning, dict(point)) in SATISFIED_BY[r.sign] for r in others)

    nodes = [node for r in others for node in (r.left, r.right)]
    return survey(stated.left, stated.right, meaning, roots=False, where=satisfies, also=nodes)


def _tried(signs: Survey, words: str) -> str:
    return f"{words} of {signs.tried} points tried"


def _failing(signs: Survey, stated: StatedRange) -> Mapping[str, str]:
    sign = next(s for s in signs.examples if s not in SATISFIED_BY[stated.sign])
    return witness_of(*signs.examples[sign])


def witness_of(point: Mapping[str, Fraction], left: Any, right: Any) -> dict[str, str]:
    """Return a point and the values of both sides there, as texts."""
    coordinates = {name: printed_decimal(value) for name, value in point.items()}
    return coordinates | {"left": digits(left), "right": digits(right)}


def lone_letter(stated: StatedRange) -> tuple[str, str, Formula] | None:
    """Return (letter, sign, bound) of an inequality between a letter and a number, else None."""
    if isinstance(stated.left, Name) and not names(stated.right):
        return stated.left.name, stated.sign, stated.right
    if isinstance(stated.right, Name) and not names(stated.left):
        return stated.right.name, _MIRRORED[stated.sign], stated.left
    return None


def _contradiction(stated: StatedRange, knowledge: Knowledge) -> Decision | None:
    """Return the contradiction between a letter's range and its declaration or earlier ranges."""
    own = lone_letter(stated)
    if own is None or own[1] == "≠":
        return None
    name, sign, bound = own
    if name in knowledge.meaning.positive and sign in "<≤":
        above = compare(bound, Number(Fraction(0)), ">", knowledge)
        if above is not None and not above.is_proved:
            return Decision(REFUTED, "the letter is declared to be positive", witness=above.witness)
    compared: set[tuple[str, Formula]] = set()
    for earlier in knowledge.ranges:
        other = lone_letter(earlier)
        if other is None or other[0] != name or other[1] == "≠" or (other[1] in "<≤") == (sign in "<≤"):
            continue
        if other[1:] in compared:  # a page may state one range a thousand times
            continue
        compared.add(other[1:])
        low, high = (bound, other[2]) if sign in ">≥" else (other[2], bound)
        touching = "≤" if sign in "≤≥" and other[1] in "≤≥" else "<"
        fits = compare(low, high, touching, knowledge)
        if fits is not None and not fits.is_proved:
            letter = formula_text(Name(name), plain=True)
            reason = f"no value of {letter} satisfies it and {earlier.text} of line {earlier.line}"
            return Decision(CONTRADICTION, reason, witness=fits.witness)
    return None


def sample_ranges(ranges: Iterable[StatedRange]) -> dict[str, tuple[int, int]]:
    """Return where letters may be drawn at random so that they satisfy their ranges, in hundredths.

    >>> low = StatedRange(Name("x"), ">", Number(Fraction(3)), 1)
    >>> sample_ranges([low])
    {'x': (301, 601)}
    """
    bounds: dict[str, list[Fraction | None]] = {}
    for stated in ranges:
        own = lone_letter(stated)
        number = None if own is None else _rational_bound(own[2])
        if own is None or number is None or own[1] == "≠":
            continue
        pair = bounds.setdefault(own[0], [None, None])
        at, pick = (0, max) if own[1] in ">≥" else (1, min)
        before = pair[at]
        pair[at] = number if before is None else pick(number, before)
    drawn: dict[str, tuple[int, int]] = {}
    for name, (low, high) in bounds.items():
        width = max(abs(low or high or 0), Fraction(1))
        first = low if low is not None else (high or Fraction(0)) - width
        last = high if high is not None else first + width
        span = (int(first * 100) + 1, int(last * 100) - 1)
        if high is None:
            span = (span[0], span[0] + int(width * 100))
        if span[0] <= span[1]:
            drawn[name] = span
    return drawn


@lru_cache(1000)
def _rational_bound(node: Formula) -> Fraction | None:
    """Return a bound as a number to three decimals."""
    evaluator = Knowledge().evaluator(Level({}))
    try:
        points = values.sample([evaluator.form(node)], 1)
    except (NoFormError, TooLargeError):
        return None
    if not points or not _is_real(points[0][1][0]) or abs(points[0][1][0]) > 10**6:
        return None
    return Fraction(round(float(points[0][1][0].real) * 1000), 1000)
