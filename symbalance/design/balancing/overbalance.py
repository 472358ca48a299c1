r"""Overbalance: counterweights that balance the rotating masses and a part k of the reciprocating ones.

The definition is that of a founding document (the first): at 100 % the counterweight balances rotating
and reciprocating inertia when the piston is at top dead centre. A cylinder's first order is half a vector
that turns with the crank, along its pin, and half one that turns against it; so with k on every throw

    forward = f - k g,  f = sum of w_j s_j e^(i throw_j)/2,  g = sum of w_j s_j e^(i throw_j),

(w_j = 1 for the force and the arm for the couple, s_j the cylinder's m r over the first's), and backward
= b whatever k is. k = 1/2 leaves of an engine with centred cylinders the circle b, in force and couple.
With F_v^2 and F_l^2 (squares of the vertical and lateral amplitude) weighted by v and l,

    k = Re(f conj g)/|g|^2 + (v - l)/(v + l) Re(g b)/|g|^2                     makes the sum least.

The largest of v F_v and l F_l (v, l now weigh amplitudes) is least for the same formula where g b and
f conj g are real, as in all engines symmetric about the vertical plane: on that line F_v + F_l = 2|b|.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy

from symbalance.engine.balance_masses import Counterweight, directed
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.arithmetic import quotient, total
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.exact.spectrum import Component
from symbalance.forces.free_forces import balance
from symbalance.text.numbers import exact
from symbalance.text.reals import Real, sqrt

OBJECTIVES = ("squares", "largest")


def overbalanced(engine: Engine, share: object = Fraction(1, 2)) -> Engine:
    """Return the engine with every throw's rotating mass and `share` of its reciprocating mass balanced.

    >>> from symbalance.engine.catalogue import load
    >>> balance(overbalanced(load("v2-90")), 1).orders  # a 90 degree vee: complete
    ()
    """
    part = exact(share, "overbalance")
    added = (Counterweight(throw=c.number, overbalance=part) for c in checked_engine(engine).cylinders)
    return engine.balanced_by(*added)


@dataclass(frozen=True)
class FirstOrderParts:
    """The first order of a force or couple as a function of overbalance: f - k g forward, b backward."""

    forward: Amplitude
    per_share: Amplitude
    backward: Amplitude


def first_order(engine: Engine, kind: str = "force") -> FirstOrderParts:
    """Return f, g and b of an engine without counterweights.

    >>> from symbalance.engine.builders import inline
    >>> parts = first_order(inline("1"))
    >>> [p.rational() for p in (parts.forward, parts.per_share, parts.backward)]
    [Fraction(1, 2), Fraction(1, 1), Fraction(1, 2)]
    """
    if kind not in ("force", "couple"):
        raise SymbalanceError(f"kind = {brief(kind)}", "must be force or couple", "ask for one of them")
    result = balance(engine, 1)
    terms = (result.force if kind == "force" else result.couple).terms
    weights = [Fraction(1)] * len(engine.cylinders) if kind == "force" else engine.lever_arms()
    rows = zip(engine.cylinders, weights, engine.sizes, strict=True)
    pins = [directed(Phasor.of(1, {0: weight * size}), c.throw) for c, weight, size in rows]
    return FirstOrderParts(terms.get(1, ZERO), total(pins), terms.get(-1, ZERO))


def best_overbalance(
    engine: Engine,
    *,
    vertical: object = 1,
    lateral: object = 1,
    objective: str = "squares",
    kind: str = "force",
) -> sympy.Expr:
    """Return the overbalance k, alike on every throw, with the least residual of order 1, exactly.

    k is the part of the reciprocating mass that counterweights balance beside all of the rotating mass.


    `vertical` and `lateral` weigh the squares of the amplitudes (objective "squares") or the amplitudes,
    of which the larger is made least ("largest"). Refused where no k makes a difference.

    >>> from symbalance.engine.builders import inline, vee
    >>> best_overbalance(inline("1")), best_overbalance(inline("1"), vertical=3)
    (1/2, 3/4)
    >>> twin = vee(sympy.Symbol("alpha"), pins=[0])
    >>> best_overbalance(twin, lateral=0)  # no vertical amplitude left
    cos(alpha)/2 + 1/2
    """
    if objective not in OBJECTIVES:
        raise SymbalanceError(
            f"objective = {brief(objective)}",
            f"must be one of {', '.join(OBJECTIVES)}",
            "squares is usual",
        )
    tilt = _tilt(vertical, lateral)
    parts = first_order(engine, kind)
    square = parts.per_share.norm()
    if square.is_zero():
        rule = f"leaves the {kind} unchanged: counterweights on its throws cancel"
        raise SymbalanceError("overbalance", rule, "design counterweights by station: design_balance")
    along = parts.forward.times(parts.per_share.conjugate())
    across = parts.per_share.times(parts.backward)
    if objective == "largest" and not (along.imaginary().is_zero() and across.imaginary().is_zero()):
        return _least_largest(parts, exact(vertical, "vertical"), exact(lateral, "lateral"))
    return quotient(along.real() + across.real().scaled(tilt), square)


def _tilt(vertical: object, lateral: object) -> Fraction:
    up, side = exact(vertical, "vertical"), exact(lateral, "lateral")
    if min(up, side) < 0 or up + side == 0:
        what = f"vertical = {brief(vertical)}, lateral = {brief(lateral)}"
        raise SymbalanceError(
            what, "must be weights, not negative, one of them above 0", "1 and 1 are even"
        )
    return (up - side) / (up + side)


def best_forward(backward: Amplitude, vertical: object = 1, lateral: object = 1) -> Amplitude:
    """Return the forward part that makes the residual least, given an unbalanced backward part.

    -(v - l)/(v + l) conj(backward): 0, a circle, where both directions weigh the same; and likewise
    the backward part beside a forward one. It is best for squares, v and l weighing them, and for the
    larger amplitude, v and l weighing amplitudes.

    >>> best_forward(Phasor.of(1, {0: 1}), 1, 0).rational()  # a force straight to the side
    Fraction(-1, 1)
    """
    if not isinstance(backward, Amplitude):
        what, rule = f"backward = {brief(backward)}", "must be a part of an order, a Phasor"
        raise SymbalanceError(what, rule, "give first_order(engine).backward")
    return backward.conjugate().scaled(-_tilt(vertical, lateral))


def _least_largest(parts: FirstOrderParts, vertical: Fraction, lateral: Fraction) -> sympy.Expr:
    """Return the k where the larger weighted amplitude is least, of parts that lie askew.

    Each squared amplitude is a parabola in k; the least of the larger is at the bottom of one or where
    both meet. Every candidate is a SymPy number; decimals choose.
    """
    curves = [_parabola(parts, sign, w * w) for w, sign in ((vertical, 1), (lateral, -1))]
    decimals = [[x.evaluated().real for x in curve] for curve in curves]
    directions = [i for i, w in enumerate((vertical, lateral)) if w]
    candidates = [(decimals[i][1] / decimals[i][0], i) for i in directions]
    gap = [one - other for one, other in zip(*decimals, strict=True)]
    candidates += [(k, sign) for k, sign in _crossings(gap, vertical == lateral)]
    worth = [max(a * k * k - 2 * b * k + c for a, b, c in decimals) for k, _ in candidates]
    best = min(range(len(candidates)), key=worth.__getitem__)
    exactly = [[Component(x).cos for x in curve] for curve in curves]
    if best < len(directions):
        a, b, _ = exactly[directions[best]]
        return b / a
    a, b, c = (one - other for one, other in zip(*exactly, strict=True))
    return (
        c / (2 * b) if vertical == lateral else (b + candidates[best][1] * sympy.sqrt(b * b - a * c)) / a
    )


def _crossings(gap: Sequence[Real], level: bool) -> list[tuple[Real, int]]:
    """Return where a k^2 - 2 b k + c is 0, with the sign of the root; `level`: where a is 0."""
    a, b, c = gap
    if level:
        return [(c / (2 * b), 0)] if b else []
    square = b * b - a * c
    return [((b + sign * sqrt(square)) / a, sign) for sign in (1, -1)] if square >= 0 else []


def _parabola(parts: FirstOrderParts, sign: int, weight: Fraction) -> list[Amplitude]:
    """Return a, b and c of weight |conj(f - k g) + sign b|^2 = a k^2 - 2 b k + c."""
    constant = parts.forward.conjugate() + parts.backward.scaled(sign)
    slope = parts.per_share.conjugate()
    cross = constant.times(slope.conjugate()).real()
    return [number.scaled(weight) for number in (slope.norm(), cross, constant.norm())]


def amplitudes(parts: FirstOrderParts, share: Fraction) -> tuple[Real, Real]:
    """Return the vertical and the lateral amplitude left at an overbalance, in decimals.

    >>> from symbalance.engine.builders import inline
    >>> [str(x) for x in amplitudes(first_order(inline("1")), Fraction(1, 2))]
    ['0.5', '0.5']
    """
    residual = (parts.forward - parts.per_share.scaled(share)).conjugate()
    vertical, lateral = ((residual + parts.backward.scaled(s)).size(30) for s in (1, -1))
    return vertical, lateral
