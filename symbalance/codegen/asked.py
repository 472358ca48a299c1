"""From a balance to waves: the outputs asked for, their surviving orders, what is left out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol

from symbalance.codegen.waves import (
    ACCELERATION,
    COUPLE,
    FORCE,
    LENGTH,
    SPEED,
    Closed,
    Term,
    Wave,
)
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, shown
from symbalance.exact.spectrum import COMPONENTS, Spectrum
from symbalance.forces.force_sums import left_out_above
from symbalance.forces.free_forces import Balance, balance
from symbalance.kinematics.slider_crank import HIGHEST_ORDER, acceleration_values, checked_ratio
from symbalance.kinematics.truncation import left_out
from symbalance.text.numbers import listed
from symbalance.text.reals import DIGITS, Real, cospi, fsum, ldexp, sinpi
from symbalance.torque.body_groups import has_common_torque

PISTON = ("displacement", "velocity", "acceleration")
OUTPUTS = (
    *(f"{kind}.{name}" for kind in ("force", "couple") for name in COMPONENTS),
    *(f"piston.{name}" for name in PISTON),
)
MEANINGS = {
    "force": "free force, {0}",
    "couple": "free couple about the reference plane, {0}",
    "piston.displacement": "piston of cylinder {1}, from top dead centre towards the crank",
    "piston.velocity": "velocity of cylinder {1}'s piston, towards the crank",
    "piston.acceleration": "acceleration of cylinder {1}'s piston, towards the crank",
}
UNITS = {
    "force": FORCE,
    "couple": COUPLE,
    "piston.displacement": LENGTH,
    "piston.velocity": SPEED,
    "piston.acceleration": ACCELERATION,
}
FIRST_TRY = 48
"""Orders looked at first for a tolerance; enough for any engine's rod ratio."""
NOTHING = Fraction(1, 10 ** (DIGITS - 5))
"""Weights smaller than this are rounding of weights that cancel."""


class _Rated(Protocol):
    """What has a layout and perhaps a rod ratio."""

    @property
    def layout(self) -> Engine: ...
    @property
    def ratio(self) -> Fraction | None: ...


def checked_outputs(outputs: Sequence[str] | str, known: Sequence[str] = OUTPUTS) -> list[str]:
    """Return the names of outputs, each once, or refuse an unknown one."""
    names = [outputs] if isinstance(outputs, str) else listed(outputs, "outputs", '("force.vertical",)')
    for name in names:
        if name not in known:
            raise SymbalanceError(f"output {shown(name)!r}", "is unknown", f"known: {', '.join(known)}")
    if not names:
        raise SymbalanceError("outputs = ()", "names no output", f"known: {', '.join(known)}")
    return list(dict.fromkeys(names))


def known_ratio(result: _Rated, ratio: object) -> Fraction:
    """Return the rod ratio to use, or refuse if neither the call nor the engine gives one."""
    apart = result.kinematics if isinstance(result, Balance) else has_common_torque(result.layout)
    if not apart:
        return _first_ratio(result, ratio)
    number = result.ratio if ratio is None else checked_ratio(ratio)
    if number is None:
        raise SymbalanceError(
            f"engine {result.layout.name!r}",
            "has no rod ratio",
            "pass ratio=..., lambda = l/r, often 3 to 4.5",
        )
    if result.layout.has_symbols:
        raise SymbalanceError(
            "a layout with symbols", "has no numeric function", "build the layout with numbers"
        )
    return number


def _first_ratio(result: _Rated, ratio: object) -> Fraction:
    """Return the first cylinder's ratio: unlike cylinders have their own, and keep them."""
    if ratio is not None:
        rule = "cannot be set for cylinders that are not alike"
        raise SymbalanceError(f"ratio = {shown(ratio)}", rule, "give each its stroke and rod")
    return result.layout.first.ratio or Fraction(1)


def truncated(result: Balance, names: Iterable[str], ratio: Fraction) -> tuple[Wave, ...]:
    """Return the outputs' harmonics up to the balance's order, exact in lambda.

    Orders too small to show in a double, together 2^-57 of the largest, are dropped.
    """
    return tuple(_Asked(result, name, ratio).truncated() for name in names)


def within(result: Balance, names: Iterable[str], ratio: Fraction, tolerance: float) -> tuple[Wave, ...]:
    """Return the outputs with the fewest orders whose proven bound is within `tolerance`.

    The unit of `tolerance` is the output's with every keyword 1: m r omega^2, times a for couples. 0 asks
    for everything that can show in a double: the bound then is 2^-57 of the largest harmonic.
    """
    return tuple(_Asked(result, name, ratio).within(tolerance) for name in names)


@dataclass(frozen=True)
class _Asked:
    """One output of a balance, at a rod ratio."""

    result: Balance
    name: str
    ratio: Fraction

    @property
    def kind(self) -> str:
        return self.name.partition(".")[0]

    @property
    def part(self) -> str:
        return self.name.partition(".")[2]

    def wave(self, **fields: Any) -> Wave:
        """Return a wave of this output."""
        meaning = MEANINGS.get(self.name) or MEANINGS[self.kind]
        first = self.result.layout.first.number
        unit = UNITS.get(self.name) or UNITS[self.kind]
        return Wave(self.name, unit, meaning.format(self.part, first), **fields)

    def truncated(self) -> Wave:
        if self.part in ("displacement", "velocity") and self.result.kinematics:
            return self.wave(left_out=0.0, closed=self.closed())
        return self.wave(terms=shown_terms(self.terms(self.result.highest)), through=self.result.highest)

    def within(self, tolerance: float) -> Wave:
        if self.part in ("displacement", "velocity"):
            return self.truncated()
        order = min(FIRST_TRY + self.fastest(), HIGHEST_ORDER)
        while True:
            terms, beyond = self.terms(order), self.beyond(order)
            sizes = [t.size for t in terms]
            wanted, bound = tolerance or ldexp(max(sizes, default=Real(0)), -57), fsum(sizes) + beyond
            for kept in range(len(sizes) + 1):
                bound = fsum(sizes[kept:]) + beyond
                if bound <= wanted or not sizes:
                    through = int(terms[kept - 1].order) if kept else 0
                    closed = self.closed() if kept else None
                    bound = upward(bound) if sizes or self.result.kinematics is None else 0.0
                    return self.wave(terms=terms[:kept], through=through, left_out=bound, closed=closed)
            if order == HIGHEST_ORDER:
                return self._beyond(tolerance, bound)
            order = min(4 * order, HIGHEST_ORDER)

    def _beyond(self, tolerance: float, bound: Real) -> Wave:
        """Return the closed form, which needs no order; refuse where there is none."""
        closed = self.closed()
        if closed is not None:
            return self.wave(left_out=0.0, closed=closed)
        what = f"tolerance = {tolerance:g}" if tolerance else "every order that shows in a double"
        at = f" at lambda = {float(self.ratio):g}" if self.result.kinematics else ""
        rule = f"needs orders above {HIGHEST_ORDER} of {self.name}{at}"
        remedy = f"{HIGHEST_ORDER} orders leave out up to {float(bound):.2g}: ask for that"
        raise SymbalanceError(what, rule, remedy)

    def terms(self, order: int) -> tuple[Term, ...]:
        """Return the harmonics that survive, to an order."""
        if self.result.kinematics is None:
            return self._unlike_terms(order)
        values = acceleration_values(order, self.ratio, DIGITS)
        if self.kind == "piston":
            turns = self.result.layout.first.delay.turns
            return tuple(_turned(n, a, turns) for n, a in values.items())
        spectrum = self._balanced(order)
        parts = ((n, spectrum.component(n, self.part)) for n in spectrum.orders() if n <= order)
        harmonics = ((n, c.decimal(DIGITS)) for n, c in parts if not c.is_zero())
        return tuple(Term(Fraction(n), values[n] * cos, values[n] * sin) for n, (cos, sin) in harmonics)

    def _unlike_terms(self, order: int) -> tuple[Term, ...]:
        """Return the harmonics of unlike cylinders, whose components hold the kinematics too."""
        if self.kind == "piston":
            rule = "is there for centred cylinders that are all alike"
            raise SymbalanceError(f"output {self.name!r}", rule, "ask for forces and couples")
        spectrum = self._balanced(order)
        parts = ((n, spectrum.component(n, self.part)) for n in spectrum.orders() if n <= order)
        harmonics = ((n, c.decimal(DIGITS)) for n, c in parts if not c.is_zero())
        return tuple(Term(Fraction(n), cos, sin) for n, (cos, sin) in harmonics)

    def _balanced(self, order: int) -> Spectrum:
        result = self.result
        if order > result.highest:
            result = balance(result.layout, order, reference=result.reference)
        return result.force if self.kind == "force" else result.couple

    def fastest(self) -> int:
        """Return the highest order of a balance shaft, which a cylinder's closed form does not hold."""
        shafts = () if self.kind == "piston" else self.result.layout.balancers.shafts
        return max((abs(s.speed) for s in shafts), default=0)

    def beyond(self, order: int) -> Real:
        """Return a proved bound on what all orders above `order` add to the output."""
        weights = self._weights()
        if self.result.kinematics:
            return fsum(abs(w) for w in weights) * left_out(order, self.ratio)
        layout = self.result.layout
        parts = [
            weight * self._onto(cylinder)
            for weight, cylinder in zip(weights, layout.cylinders, strict=True)
        ]
        return left_out_above(layout, order, parts)

    def _onto(self, cylinder: Cylinder) -> Real | Fraction:
        """Return how much of a cylinder's force the output can hold at most."""
        if self.part not in ("vertical", "lateral"):
            return Fraction(1, 2)
        return (cospi if self.part == "vertical" else sinpi)(2 * cylinder.bank.turns)

    def closed(self) -> Closed | None:
        """Return the closed form of every order at once; the forward and backward parts have none."""
        cylinders = self.result.layout.cylinders
        if self.kind == "piston":
            kind = "secondary" if self.part == "acceleration" else self.part
            turns = self.result.layout.first.delay.turns
            first = self.terms(1) if kind == "secondary" else ()
            return Closed(kind, self.ratio, ((Real(1), turns),), first)
        alone = self.result.kinematics and self.fastest() <= 1
        if self.part not in ("vertical", "lateral") or not alone:
            return None
        merged: dict[Fraction, Real] = {}
        for weight, cylinder in zip(self._weights(), cylinders, strict=True):
            turns = cylinder.delay.turns % Fraction(1, 2)
            merged[turns] = merged.get(turns, Real(0)) + weight * self._onto(cylinder)
        places = tuple((w, turns) for turns, w in sorted(merged.items()) if abs(w) > NOTHING)
        return Closed("secondary", self.ratio, places, self.terms(1)) if places else None

    def _weights(self) -> list[Real]:
        layout = self.result.layout
        if self.kind == "piston":
            return [Real(1)]
        if self.kind == "force":
            return [Real(1)] * len(layout.cylinders)
        return [Real(arm) for arm in layout.arms(self.result.reference)]


def shown_terms(terms: tuple[Term, ...]) -> tuple[Term, ...]:
    """Return the harmonics without the last ones that cannot show in a double: 2^-57 of the largest."""
    sizes = [t.size for t in terms]
    least = ldexp(max(sizes, default=Real(0)), -57)
    kept = next(i for i in range(len(terms) + 1) if fsum(sizes[i:]) <= least)
    return terms[:kept]


def _turned(n: int, coefficient: Real, turns: Fraction) -> Term:
    """Return coefficient * cos n (theta + 2 pi turns)."""
    turned = 2 * n * turns
    return Term(Fraction(n), coefficient * cospi(turned), -coefficient * sinpi(turned))


def upward(bound: Real) -> float:
    """Return a bound as a double that is not below it."""
    return float(bound) * (1 + 2.0**-50)
