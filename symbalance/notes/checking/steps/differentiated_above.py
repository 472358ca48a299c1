"""Formulas that words call the derivative of what stands above: "Differentiate: v = r ω sin θ".

The letters say nothing of each other. By the words the formula is the derivative, once or twice, of the
last formula above that turns with the same angle; what turns steadily has ω before it for each time. A
sign before the whole is a direction. One term that differs is refuted, where all others are as they
should be.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import product

from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Name,
    Number,
    Power,
    Product,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.harmonics import Components, HarmonicKey, components, key_node
from symbalance.notes.algebra.zero import is_zero
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_DERIVED = re.compile(
    r"differentiat|(?<!no )\bderivative|\bderiv(?:e|ing) (?:it|this|once|twice|again)|ableit|abgeleitet"
    r"|differenzier|\bdériv|\bderivando|\bderivata\b|\bderivada\b|微分",
    re.IGNORECASE,
)
_OTHERWISE = re.compile(
    r"integrat|integrier|intégr|積分|partial|partiell|\bz[eé]ro\b|\bnull\b|extrem"
    r"|maxim|minim|最大",
    re.IGNORECASE,
)
"""Words by which a derivative is no motion's: where one is set to zero, or what is integrated."""
MOST_LINES, MOST_LETTERS = 40, 8
"""Between a formula and its derivative, and in it."""
_TWICE = 2


def judge_derivative_of_above(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a formula that words call a derivative; None where they leave it open."""
    head, sign = chain.sides[0].node, chain.relations[0].sign
    if k or not isinstance(head, Name) or sign not in "=≈":
        return None
    words = state.sections.sentence_leading_to(chain)
    if _DERIVED.search(words) is None or _OTHERWISE.search(words) is not None:
        return None
    rate = without_dots(chain.sides[1].node)[0]
    angle = _angle_of(rate)
    if not angle:
        return None
    wrong: Decision | None = None
    for above, whole in _formulas_above(state, chain, head, angle):
        for outcome in _compared(whole, rate, angle):
            if outcome.is_proved:
                return outcome
            reason = f"not the derivative of line {above.lines[0]}: {outcome.reason}"
            wrong = wrong or replace(outcome, reason=reason)
    return wrong


def _formulas_above(
    state: JudgingState, chain: Chain, head: Name, angle: str
) -> Iterator[tuple[Chain, Formula]]:
    """Yield the formulas that the last letter above has which turns with an angle."""
    of_letter = ""
    above = (c for c in reversed(state.document.chains) if c.end <= chain.start and c.relations)
    for other in above:
        if chain.lines[0] - other.lines[0] > MOST_LINES:
            return
        own = other.sides[0].node
        turning = [side.node for side in other.sides[1:] if _angle_of(side.node) == angle]
        is_wrong = any(side.span[0] in state.refuted for side in other.sides)
        if not isinstance(own, Name) or own == head or not turning or is_wrong:
            continue
        if of_letter and own.name != of_letter:
            return
        of_letter = own.name
        yield from ((other, without_dots(node)[0]) for node in turning)


def _compared(whole: Formula, rate: Formula, angle: str) -> Iterator[Decision]:
    """Yield whether a formula is another one's derivative once or twice, or which term of it is not.

    One letter that it has may be the speed, be it new or before the other formula as well.
    """
    new = names(rate) - names(whole)
    speeds = new or {"", *names(rate) - {angle}}
    if len(new) > 1 or len(speeds) > MOST_LETTERS:
        return
    for times, speed in product((1, _TWICE), sorted(speeds)):
        derived: Formula = Derivative(whole, Name(angle), times)
        if speed:
            derived = Product((Power(Name(speed), Number(Fraction(times))), derived))
        outcome = _by_harmonics(derived, rate)
        if outcome is not None:
            constant = (f"{plain_letter(speed)} is constant",) if speed else ()
            yield Decision(REFUTED, outcome) if outcome else Decision(PROVED, assumptions=constant)


def _by_harmonics(derived: Formula, rate: Formula) -> str | None:
    """Return "" where two formulas are one up to a sign, else what differs; None for several terms."""
    evaluator = Knowledge().evaluator(Level({}))
    try:
        first, second = evaluator.form(derived), evaluator.form(rate)
        if not first.is_polynomial or not second.is_polynomial:
            return None
        domain = first.domain
        exact, own = components(domain, first.numerator), components(domain, second.numerator)
        for sign in (1, -1):
            apart = [key for key in {**exact, **own} if not _is_same(domain, exact, own, key, sign)]
            if not apart:
                return ""
            angles = {key.angle for key in apart}
            shared = len({**exact, **own}) - len(apart)
            is_in_both = all(any(k.angle in angles for k in side) for side in (exact, own))
            if len(angles) == 1 and shared and is_in_both:  # a term that is left out is a small one
                wave = key_node(domain, replace(apart[0], letters=()))
                return f"its term in {formula_text(wave, plain=True)}" if wave else "its constant"
    except (NoFormError, TooLargeError):
        return None
    return None


def _is_same(domain: Domain, exact: Components, own: Components, key: HarmonicKey, sign: int) -> bool:
    if key not in exact or key not in own:
        return False
    other = own[key] if sign > 0 else poly.minus({}, own[key])
    return is_zero(domain, poly.minus(exact[key], other)) is True


def _angle_of(node: Formula) -> str:
    """Return the one letter that all sines and cosines of a formula are of, "" without one."""
    waves = [part for part in walk(node) if isinstance(part, Call) and part.function in ("sin", "cos")]
    own = {name for wave in waves for name in names(wave.argument)}
    return own.pop() if len(own) == 1 else ""
