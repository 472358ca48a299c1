"""The requested outputs of a balance as harmonic sums, with a proved bound on the orders left out.

An output is a component of the free force or couple, or the motion of cylinder 1's piston. A request is
answered to a given order, or with the fewest orders whose proved bound is within a tolerance
(`fewest_within`, which the requests for torques use too).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Protocol

from symbalance.codegen.harmonic_sum import (
    ACCELERATION,
    COUPLE,
    FORCE,
    LENGTH,
    SPEED,
    ClosedForm,
    HarmonicSum,
    HarmonicTerm,
)
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.spectrum import COMPONENTS, Spectrum
from symbalance.forces.force_sums import left_out_above
from symbalance.forces.free_forces import Balance, balance
from symbalance.kinematics.slider_crank import HIGHEST_ORDER, acceleration_values, checked_ratio
from symbalance.kinematics.truncation import left_out
from symbalance.text.numbers import as_list
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
FIRST_ORDER = 48
"""The order to which a sum is tried first for a tolerance; enough for any engine's rod ratio."""
CANCELLED = Fraction(1, 10 ** (DIGITS - 5))
"""Weights smaller than this are rounding of weights that cancel."""
INVISIBLE = -57
"""Binary logarithm of what cannot show in a double beside 1: a sixteenth of a rounding, 2^-53."""


class _EngineResult(Protocol):
    """A result that has an engine and perhaps a rod ratio."""

    @property
    def engine(self) -> Engine: ...
    @property
    def ratio(self) -> Fraction | None: ...


def checked_outputs(outputs: Sequence[str] | str, known: Sequence[str] = OUTPUTS) -> list[str]:
    """Return the names of outputs, each once, or refuse an unknown one."""
    names = [outputs] if isinstance(outputs, str) else as_list(outputs, "outputs", '("force.vertical",)')
    for name in names:
        if name not in known:
            raise SymbalanceError(f"output {brief(name)!r}", "is unknown", f"known: {', '.join(known)}")
    if not names:
        raise SymbalanceError("outputs = ()", "names no output", f"known: {', '.join(known)}")
    return list(dict.fromkeys(names))


def rod_ratio(result: _EngineResult, ratio: object) -> Fraction:
    """Return the rod ratio to use, or refuse if neither the call nor the engine gives one."""
    common = result.kinematics if isinstance(result, Balance) else has_common_torque(result.engine)
    if not common:
        return _first_ratio(result, ratio)
    number = result.ratio if ratio is None else checked_ratio(ratio)
    if number is None:
        raise SymbalanceError(
            f"engine {result.engine.name!r}",
            "has no rod ratio",
            "add rod and stroke to [crank_train], or say --ratio 4 (ratio=4): l/r, often 3 to 4.5",
        )
    if result.engine.has_symbols:
        raise SymbalanceError(
            "an engine with symbols", "has no numeric function", "build the engine with numbers"
        )
    return number


def _first_ratio(result: _EngineResult, ratio: object) -> Fraction:
    """Return the first cylinder's ratio: unlike cylinders have their own, and keep them."""
    if ratio is not None:
        rule = "cannot be set for cylinders that are not alike"
        raise SymbalanceError(f"ratio = {brief(ratio)}", rule, "give each its stroke and rod")
    return result.engine.first.ratio or Fraction(1)


def sums_to_order(result: Balance, names: Iterable[str], ratio: Fraction) -> tuple[HarmonicSum, ...]:
    """Return the outputs' harmonics up to the balance's order, exact in lambda.

    Orders too small to show in a double, together 2^-57 of the largest, are dropped.
    """
    return tuple(_Request(result, name, ratio).to_order() for name in names)


def sums_within(
    result: Balance, names: Iterable[str], ratio: Fraction, tolerance: float
) -> tuple[HarmonicSum, ...]:
    """Return the outputs with the fewest orders whose proven bound is within `tolerance`.

    The unit of `tolerance` is the output's with every keyword 1: m r omega^2, times a for couples. 0 asks
    for everything that can show in a double: the bound then is 2^-57 of the largest harmonic.
    """
    longer: dict[int, Balance] = {}  # outputs that ask for the same orders share their balance
    return tuple(_Request(result, name, ratio, longer).within(tolerance) for name in names)


@dataclass(frozen=True)
class _Request:
    """One output of a balance, at a rod ratio."""

    result: Balance
    name: str
    ratio: Fraction
    longer: dict[int, Balance] = field(default_factory=dict, compare=False)

    @property
    def kind(self) -> str:
        return self.name.partition(".")[0]

    @property
    def part(self) -> str:
        return self.name.partition(".")[2]

    def harmonic_sum(self, **fields: Any) -> HarmonicSum:
        """Return a harmonic sum of this output."""
        meaning = MEANINGS.get(self.name) or MEANINGS[self.kind]
        first = self.result.engine.first.number
        unit = UNITS.get(self.name) or UNITS[self.kind]
        return HarmonicSum(self.name, unit, meaning.format(self.part, first), **fields)

    def to_order(self) -> HarmonicSum:
        """Return the harmonics up to the balance's order; displacement and velocity in closed form."""
        if self.part in ("displacement", "velocity") and self.result.kinematics:
            return self.harmonic_sum(left_out=0.0, closed_form=self.closed_form())
        terms = visible_terms(self.terms(self.result.highest))
        return self.harmonic_sum(terms=terms, through=self.result.highest)

    def within(self, tolerance: float) -> HarmonicSum:
        """Return the fewest harmonics within a tolerance, beside the closed form where there is one."""
        if self.part in ("displacement", "velocity"):
            return self.to_order()
        first = min(FIRST_ORDER + self.fastest_shaft(), HIGHEST_ORDER)
        terms, bound, empty = fewest_within(self.terms, self.beyond, tolerance, first)
        if terms is None:
            return self._by_closed_form(tolerance, bound)
        # Like cylinders whose orders all cancel leave nothing out, whatever each of them does.
        left_out = 0.0 if empty and self.result.kinematics is not None else double_above(bound)
        through = int(terms[-1].order) if terms else 0
        closed_form = self.closed_form() if terms else None
        return self.harmonic_sum(terms=terms, through=through, left_out=left_out, closed_form=closed_form)

    def _by_closed_form(self, tolerance: float, bound: Real) -> HarmonicSum:
        """Return the closed form, which needs no order; refuse where there is none."""
        closed_form = self.closed_form()
        if closed_form is not None:
            return self.harmonic_sum(left_out=0.0, closed_form=closed_form)
        what = f"tolerance = {tolerance:g}" if tolerance else "every order that shows in a double"
        at = f" at lambda = {float(self.ratio):g}" if self.result.kinematics else ""
        rule = f"needs orders above {HIGHEST_ORDER} of {self.name}{at}"
        remedy = f"{HIGHEST_ORDER} orders leave out up to {float(bound):.2g}: ask for that"
        raise SymbalanceError(what, rule, remedy)

    def terms(self, order: int) -> tuple[HarmonicTerm, ...]:
        """Return the harmonics that survive, to an order."""
        if self.result.kinematics is None:
            return self._nonuniform_terms(order)
        values = acceleration_values(order, self.ratio, DIGITS)
        if self.kind == "piston":
            turns = self.result.engine.first.delay.turns
            return tuple(_shifted_term(n, a, turns) for n, a in values.items())
        spectrum = self._spectrum(order)
        parts = ((n, spectrum.component(n, self.part)) for n in spectrum.orders() if n <= order)
        harmonics = ((n, c.decimal(DIGITS)) for n, c in parts if not c.is_zero())
        return tuple(
            HarmonicTerm(Fraction(n), values[n] * cos, values[n] * sin) for n, (cos, sin) in harmonics
        )

    def _nonuniform_terms(self, order: int) -> tuple[HarmonicTerm, ...]:
        """Return the harmonics of unlike cylinders, whose components hold the kinematics too."""
        if self.kind == "piston":
            rule = "is there for centred cylinders that are all alike"
            raise SymbalanceError(f"output {self.name!r}", rule, "ask for forces and couples")
        spectrum = self._spectrum(order)
        parts = ((n, spectrum.component(n, self.part)) for n in spectrum.orders() if n <= order)
        harmonics = ((n, c.decimal(DIGITS)) for n, c in parts if not c.is_zero())
        return tuple(HarmonicTerm(Fraction(n), cos, sin) for n, (cos, sin) in harmonics)

    def _spectrum(self, order: int) -> Spectrum:
        result = self.result
        if order > result.highest:
            if order not in self.longer:
                self.longer[order] = balance(result.engine, order, reference=result.reference)
            result = self.longer[order]
        return result.force if self.kind == "force" else result.couple

    def fastest_shaft(self) -> int:
        """Return the highest order of a balance shaft, which a cylinder's closed form does not hold."""
        shafts = () if self.kind == "piston" else self.result.engine.balancers.shafts
        return max((abs(s.speed) for s in shafts), default=0)

    def beyond(self, order: int) -> Real:
        """Return a proved bound on what all orders above `order` add to the output."""
        weights = self._weights()
        if self.result.kinematics:
            return fsum(abs(w) for w in weights) * left_out(order, self.ratio)
        engine = self.result.engine
        parts = [
            weight * self._projection(cylinder)
            for weight, cylinder in zip(weights, engine.cylinders, strict=True)
        ]
        return left_out_above(engine, order, parts)

    def _projection(self, cylinder: Cylinder) -> Real | Fraction:
        """Return how much of a cylinder's force the output can hold at most."""
        if self.part not in ("vertical", "lateral"):
            return Fraction(1, 2)
        return (cospi if self.part == "vertical" else sinpi)(2 * cylinder.bank.turns)

    def closed_form(self) -> ClosedForm | None:
        """Return the closed form of every order at once; the forward and backward parts have none."""
        cylinders = self.result.engine.cylinders
        if self.kind == "piston":
            kind = "secondary" if self.part == "acceleration" else self.part
            turns = self.result.engine.first.delay.turns
            first = self.terms(1) if kind == "secondary" else ()
            return ClosedForm(kind, self.ratio, ((Real(1), turns),), first)
        all_closed = self.result.kinematics and self.fastest_shaft() <= 1
        if self.part not in ("vertical", "lateral") or not all_closed:
            return None
        merged: dict[Fraction, Real] = {}
        for weight, cylinder in zip(self._weights(), cylinders, strict=True):
            turns = cylinder.delay.turns % Fraction(1, 2)
            merged[turns] = merged.get(turns, Real(0)) + weight * self._projection(cylinder)
        places = tuple((w, turns) for turns, w in sorted(merged.items()) if abs(w) > CANCELLED)
        return ClosedForm("secondary", self.ratio, places, self.terms(1)) if places else None

    def _weights(self) -> list[Real]:
        engine = self.result.engine
        if self.kind == "piston":
            return [Real(1)]
        if self.kind == "force":
            return [Real(1)] * len(engine.cylinders)
        return [Real(arm) for arm in engine.lever_arms(self.result.reference)]


def fewest_within(
    terms_to: Callable[[int], tuple[HarmonicTerm, ...]],
    beyond: Callable[[int], Real],
    tolerance: float,
    order: int,
    default_size: Real | None = None,
) -> tuple[tuple[HarmonicTerm, ...] | None, Real, bool]:
    """Return the fewest harmonics within a tolerance, their proved bound, and whether none survive.

    `terms_to` gives the harmonics to an order, `beyond` a bound on all above it; their sum over what is
    left away is the bound. Orders are first looked at to `order`, then to four times as many, and so on;
    the harmonics are None where `HIGHEST_ORDER` of them do not do. Tolerance 0 asks for 2^-57 of the
    largest harmonic, or of `default_size` where there are none; without that, no harmonics need no bound.
    """
    while True:
        terms = terms_to(order)
        sizes, rest = [t.size for t in terms], beyond(order)
        if not sizes and default_size is None:
            return (), Real(rest), True
        allowed = tolerance or ldexp(max(sizes) if sizes else Real(default_size or 0), INVISIBLE)
        bound = fsum(sizes) + rest
        for count in range(len(sizes) + 1):
            bound = fsum(sizes[count:]) + rest
            if bound <= allowed:
                return terms[:count], bound, not sizes
        if order == HIGHEST_ORDER:
            return None, bound, not sizes
        order = min(4 * order, HIGHEST_ORDER)


def visible_terms(terms: tuple[HarmonicTerm, ...]) -> tuple[HarmonicTerm, ...]:
    """Return the harmonics without the last ones that cannot show in a double: 2^-57 of the largest."""
    sizes = [t.size for t in terms]
    least = ldexp(max(sizes, default=Real(0)), INVISIBLE)
    count = next(i for i in range(len(terms) + 1) if fsum(sizes[i:]) <= least)
    return terms[:count]


def _shifted_term(n: int, coefficient: Real, turns: Fraction) -> HarmonicTerm:
    """Return coefficient * cos n (theta + 2 pi turns)."""
    phase = 2 * n * turns
    return HarmonicTerm(Fraction(n), coefficient * cospi(phase), -coefficient * sinpi(phase))


def double_above(bound: Real) -> float:
    """Return a bound as a double that is not below it."""
    return float(bound) * (1 + 2.0**-50)
