"""Whether a formula is one of the slider-crank's, through the powers of the rod ratio that it has.

Formulas are compared by their values at a few points. A polynomial in the ratio agrees with an exact
formula if it differs by a higher power than it has itself: cos θ + λ cos 2θ, but not cos θ alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from itertools import pairwise
from math import isclose, isfinite, log2

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Quotient,
    Sum,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.checking.meant.catalogue.kinematics import Motion
from symbalance.notes.checking.meant.formula_slips import value_at
from symbalance.notes.checking.repair.edits import edits, parents_of

Point = Mapping[str, Fraction]
"""Numbers of r, lam, w, theta and e."""
F = Fraction
POINTS: tuple[Point, ...] = tuple(
    {"r": r, "lam": lam, "w": w, "theta": theta, "e": e}
    for r, lam, w, theta, e in (
        (F(7, 5), F(11, 40), F(13, 6), F(8, 11), F(1, 9)),
        (F(5, 8), F(9, 43), F(17, 9), F(19, 9), F(1, 17)),
        (F(9, 7), F(12, 35), F(11, 14), F(31, 7), F(1, 8)),
        (F(3, 4), F(7, 19), F(23, 8), F(6, 17), F(1, 21)),
    )
)
SAME = 1e-9
SHORT, HALF = F(1, 20), F(1, 40)
"""Ratios of crank and rod between which the order of a difference shows."""
HIGHEST = 7
"""Power of the ratio that a series may have."""
_TERM_FACTORS = (F(2), F(1, 2), F(4), F(1, 4), F(3), F(1, 3), F(8), F(1, 8), F(-2), F(-1, 2), F(-1, 4))

_INVERSE = ("asin", "acos", "atan")

Values = Callable[[Formula, Point], float]
"""The value of a claim in the letters of its page, at a point of the roles."""


def same_values(first: Formula, second: Formula, claimed: Values, sign: int = 1) -> bool:
    """Tell whether a target, with a sign, has the values of a claim at every point."""
    pairs = [(sign * value_at(first, point), claimed(second, point)) for point in POINTS]
    return all(
        isfinite(a) and isfinite(b) and isclose(a, b, rel_tol=SAME, abs_tol=1e-12) for a, b in pairs
    )


def order_of_claim(claim: Formula, claimed: Values) -> int | None:
    """Return the highest power of the ratio in a claim that is a polynomial in it, else None."""
    for start in POINTS[:1]:
        row = [
            claimed(claim, {**start, "lam": F(k, 30)}) * k / 30 for k in range(1, HIGHEST + 5)
        ]  # times the ratio: a rod length has its inverse
        if not all(map(isfinite, row)):
            return None
        size = max(map(abs, row)) or 1.0
        for degree in range(HIGHEST + 2):
            row = [b - a for a, b in pairwise(row)]
            if all(abs(each) < SAME * size * 1e-2 for each in row):
                return degree - 1
    return None


def agrees_through(target: Formula, claim: Formula, claimed: Values, sign: int) -> int | None:
    """Return the power of the ratio through which a polynomial is the series of a target, else None."""
    far = {**POINTS[0], "lam": HALF}
    size = abs(value_at(target, far))
    gap = abs(sign * value_at(target, far) - claimed(claim, far))
    if not gap <= 9 * float(HALF) ** 2 * max(size, 1.0):
        return None  # most formulas differ at once
    highest = order_of_claim(claim, claimed)
    if highest is None or highest < 1:
        return None
    for point in POINTS:
        gaps = [
            abs(sign * value_at(target, at) - claimed(claim, at))
            for at in ({**point, "lam": SHORT}, {**point, "lam": HALF})
        ]
        scale = abs(value_at(target, {**point, "lam": SHORT})) or 1.0
        if not all(map(isfinite, gaps)):
            return None
        if gaps[1] <= 1e-13 * scale:
            continue
        if log2(gaps[0] / gaps[1]) < highest + 0.6:
            return None
    return highest


def agreement(
    motion: Motion, claim: Formula, claimed: Values, signs: tuple[int, ...]
) -> tuple[Formula, int, str] | None:
    """Return the formula that a claim agrees with, the sign, and how: "", "rough" or the power."""
    for sign in signs:
        for target in motion.exact:
            if same_values(target, claim, claimed, sign):
                return target, sign, ""
    for sign in signs:
        for target in motion.rough:
            if same_values(target, claim, claimed, sign):
                return target, sign, "rough"
        for target in motion.exact:
            if (power := agrees_through(target, claim, claimed, sign)) is not None:
                return target, sign, str(power)
    return None


def slips(claim: Formula) -> Iterator[tuple[str, Formula]]:
    """Yield a claim with one thing in it changed, with the kind of change."""
    parents = parents_of(claim)
    for edit in edits(claim, sorted(names(claim)), ()):
        yield edit.kind, edit.applied(parents)
    yield from _by_factors(claim)
    for letter in sorted(names(claim)):
        yield "sign", _with_negative_squares(claim, letter)


def _with_negative_squares(node: Formula, letter: str) -> Formula:
    """Return a formula with each square of a letter made negative: l² - e² of l² + e²."""
    if isinstance(node, Power) and node.base == Name(letter):
        return Negative(node) if node.exponent == Number(F(2)) else node
    parts = children(node)
    return with_children(node, tuple(_with_negative_squares(p, letter) for p in parts)) if parts else node


def _by_factors(node: Formula, *, is_exponent: bool = False) -> Iterator[tuple[str, Formula]]:
    """Yield a formula with a term multiplied, a root set or left out, or a number doubled."""
    if isinstance(node, Sum):
        for k, term in enumerate(node.terms):
            for factor in _TERM_FACTORS:
                changed = Number(factor) * term
                yield f"factor {factor}", Sum((*node.terms[:k], changed, *node.terms[k + 1 :]))
    if isinstance(node, Number) and node.value and not is_exponent:
        yield from ((f"factor {f}", Number(node.value * f)) for f in (F(2), F(1, 2), F(3, 4), F(4, 3)))
    if isinstance(node, Call) and node.function in _INVERSE:
        yield from (
            (f"{f} for {node.function}", Call(f, node.argument)) for f in _INVERSE if f != node.function
        )
    if isinstance(node, Call) and node.function == "sqrt":
        yield "root", node.argument
        yield "root", Power(node, Number(F(3)))
    if (
        isinstance(node, Quotient)
        and isinstance(node.numerator, Name)
        and isinstance(node.denominator, Name)
    ):
        yield "fraction inverted", Quotient(node.denominator, node.numerator)
    if isinstance(node, Quotient) and any(isinstance(p, Sum) for p in walk(node.denominator)):
        yield "root", Quotient(node.numerator, Call("sqrt", node.denominator))
    if isinstance(node, Power) and isinstance(node.exponent, Number):
        yield from (
            ("exponent", Power(node.base, Number(F(n)))) for n in (1, 2, 3, 4) if n != node.exponent.value
        )
    parts = children(node)
    for k, part in enumerate(parts):
        inner = is_exponent or (isinstance(node, Power) and k == 1)
        for kind, changed in _by_factors(part, is_exponent=inner):
            yield kind, with_children(node, (*parts[:k], changed, *parts[k + 1 :]))


def factor_between(claim: Formula, changed: Formula, claimed: Values) -> float | None:
    """Return the number that a change multiplies the whole by, None where it does something else."""
    ratios = []
    for point in POINTS:
        below = claimed(claim, point)
        ratios.append(claimed(changed, point) / below if below else float("nan"))
    return ratios[0] if all(isclose(each, ratios[0], rel_tol=SAME) for each in ratios) else None
