r"""The least set of counterweights and balance shafts that balances given orders of force and couple.

What turns at s times the crank's speed (s of either sign) has a force and a couple in e^(i s theta)
alone, and the powers e^(i s theta) are linearly independent. So every signed order whose force or couple
is not zero needs something that turns at its own speed: a counterweight on the crank at +1, else a shaft
of its own. One shaft is enough for each: two weights in two planes have any force and any couple
(`symbalance.design.balancing.planes`). The least number of shafts that balances given orders therefore is
the number of their signed orders, +1 apart, that are not zero; and one weight on it is enough exactly
where the couple is the force times an arm. Where limits forbid that, an order that keeps one of its
parts gets the best of the other (`order_selection`).

What a design claims is proved by `symbalance.forces.free_forces.balance` of the engine with the design
built in.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Unpack

from symbalance.design.balancing.design_limits import Limits, checked_limits, checked_orders
from symbalance.design.balancing.devices import Device, devices_for, rotating_counterweights
from symbalance.design.balancing.order_selection import parts_of
from symbalance.design.balancing.web_segments import STEEL, Segment, SegmentRing, checked_ring
from symbalance.document.result import Result
from symbalance.engine.engine import Engine, checked_engine
from symbalance.engine.rotating_masses import share_sign, unit_of_share
from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Component
from symbalance.forces.free_forces import Balance, balance
from symbalance.forces.operating_point import Sizes, sized
from symbalance.text.reals import Real

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

LISTED_ORDERS = 12
"""What remains is listed to this order at least."""


@dataclass(frozen=True)
class Claim:
    """What a design does to one part of one order: its `signed` order, force or couple, before, after."""

    signed: int
    kind: str
    before: Amplitude
    after: Amplitude

    @property
    def is_zero(self) -> bool:
        """Whether it is proved to be zero now."""
        return self.after.is_zero()

    @property
    def verdict(self) -> str:
        """Absent (there was none), removed, reduced or changed, unchanged, or added."""
        if self.before.is_zero():
            return "absent" if self.is_zero else "added"
        if self.is_zero:
            return "removed"
        return "unchanged" if (self.before - self.after).is_zero() else "reduced"

    @property
    def component(self) -> Component:
        """What is left, as the vertical component of the part that turns."""
        return Component(self.after.conjugate() if self.signed > 0 else self.after)


def certificate(before: Balance, after: Balance, orders: Sequence[int]) -> list[Claim]:
    """Return a claim for force and couple of every signed order of `orders`, absent ones included.

    The designer's own sums are not used: both balances add up cylinders, counterweights and shafts anew,
    and a number is zero where its normal form is (decimals: where the parts cancel to their rounding).

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.forces.free_forces import balance
    >>> four = balance(load("inline-4"), 2)
    >>> [c.verdict for c in certificate(four, four, [1, 2])][:5]
    ['absent', 'absent', 'absent', 'absent', 'unchanged']
    """
    claims = []
    for n in orders:
        for kind in ("force", "couple"):
            old, new = (b.force.terms if kind == "force" else b.couple.terms for b in (before, after))
            claims += [Claim(s, kind, old.get(s, ZERO), new.get(s, ZERO)) for s in (n, -n)]
    return claims


@dataclass(frozen=True, repr=False)
class Design(Result):
    """A balancing proposal: the `engine`, the `balanced` engine with the `devices`, the remaining orders.

    >>> from symbalance.engine.catalogue import load
    >>> four = design_balance(load("inline-4"), remove=[1, 2])
    >>> [(d.speed, str(d.weights[0][0]), d.weights[0][1].rational()) for d in four.devices]
    [(2, '0', Fraction(-2, 1)), (-2, '0', Fraction(-2, 1))]
    >>> four.is_complete, [o.order for o in four.remains.orders]
    (True, [4, 6, 8, 10, 12])
    """

    engine: Engine
    balanced: Engine
    remove: tuple[int, ...]
    devices: tuple[Device, ...]
    limits: Limits
    before: Balance
    remains: Balance
    ring: SegmentRing | None = None
    """What its weights are cut from, None where that is not said."""
    full: bool = True
    """Whether its document has all that is left and was before, or the answer alone."""

    kind: ClassVar[str] = "design"
    record_keys: ClassVar[tuple[str, ...]] = (
        *("speed", "on", "throw", "station", "share", "direction_deg", "exact_up", "exact_right"),
        *("unbalance_kg_mm", "overbalance"),
    )

    def summary(self) -> str:
        """Return what the design achieves and what it takes, in one line."""
        from symbalance.design.balancing.design_facts import sentence

        return f"Design for {self.engine.name}: {sentence(self)}"

    def document(self) -> Document:
        """Return the weights proposed, their certificate and what remains, then how to read them."""
        from symbalance.design.balancing.design_document import design_document

        return design_document(self)

    def data(self) -> dict[str, Any]:
        """Return the devices, the certificate and what remains, exact numbers as strings."""
        from symbalance.design.balancing.design_data import design_data

        return design_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each weight that is built in."""
        from symbalance.design.balancing.design_data import design_records

        return design_records(self)

    def cut_from(
        self, outer: object, thickness: object, inner: object = 0, density: object = STEEL
    ) -> Design:
        """Return the design with its weights as segments of a ring: radii and thickness in mm, kg/m^3.

        Refused where a weight's kg mm are not known. One of more than half the ring has no segment, and
        the document says which it is, and what thickness would do.

        >>> from symbalance.engine.catalogue import load
        >>> design = design_balance(load("vq30de"), [1]).cut_from(60, 20, inner=20)
        >>> [round(float(segment.angle), 1) for segment in design.segments]
        [91.6, 91.6]
        """
        cut = replace(self, ring=checked_ring(outer, thickness, inner, density))
        _ = cut.segments  # refuses what has no kg mm
        return cut

    @property
    def segments(self) -> list[Segment | None]:
        """The segments of its weights, device by device; empty where no ring is given.

        None stands for a weight that is more than half of the ring.
        """
        if self.ring is None:
            return []
        segments: list[Segment | None] = []
        for device in self.devices:
            for _, vector in device.weights:
                size = self.unbalance(device, vector)
                if size is None:
                    what, rule = f"engine {self.engine.name!r}", "has no kg mm: its sizes are not known"
                    raise SymbalanceError(what, rule, "give stroke, rod and reciprocating_mass")
                segments.append(self.ring.segment(size))
        return segments

    def at(self, *, rpm: object, **sizes: Unpack[Sizes]) -> Design:
        """Return the same design with what remains in N and N m at a speed.

        `stroke`, `rod`, `pitch`, `bore` (mm) and `mass` (kg, of one cylinder's reciprocating parts) are
        sizes that the engine lacks; with them the engine is designed for anew, within the same limits.

        >>> from symbalance.engine.catalogue import load
        >>> four = design_balance(load("inline-4"), [2]).at(rpm=6000, stroke=80, mass="0.5")
        >>> [round(four.unbalance(d, vector), 2) for d in four.devices for _, vector in d.weights]
        [2.54, 2.54]
        """
        if sizes:
            again = _designed(sized(self.engine, sizes), self.remove, self.limits)
            return replace(again, ring=self.ring, full=self.full).at(rpm=rpm)
        return replace(self, before=self.before.at(rpm=rpm), remains=self.remains.at(rpm=rpm))

    @property
    def shafts(self) -> list[Device]:
        """The balance shafts of it."""
        return [d for d in self.devices if not d.on_crank]

    @property
    def least_shafts(self) -> int:
        """How many shafts balance all orders to remove: one for each not zero, the crank's +1 apart."""
        signed = parts_of(self.before, self.remove)
        return len(signed) - (1 in signed and self.limits.counterweights)

    @property
    def claims(self) -> list[Claim]:
        """What becomes of every order to remove: of force and couple, with and against the crank."""
        return certificate(self.before, self.remains, self.remove)

    @property
    def is_complete(self) -> bool:
        """Whether every order to remove is proved to be zero, force and couple."""
        return all(claim.is_zero for claim in self.claims)

    def unbalance(self, device: Device, vector: Amplitude) -> Real | None:
        """Return a weight's mass times radius in kg mm, None where the engine's sizes do not say."""
        unit = self.balanced.unit_unbalance
        needs_ratio = abs(device.speed) > 1 and self.balanced.has_common_harmonics
        if unit is None or (needs_ratio and self.balanced.ratio is None) or self.balanced.has_symbols:
            return None
        return abs(vector.size() * unit_of_share(self.balanced, device.speed)) * unit / device.speed**2

    def direction(self, device: Device, vector: Amplitude) -> Amplitude:
        """Return a vector that points where a weight does: a share of A_4, below 0, the other way."""
        return vector.scaled(Fraction(share_sign(self.balanced, device.speed)))


def design_balance(
    engine: Engine,
    remove: Sequence[int] = (1, 2),
    *,
    shafts: int | None = None,
    counter_rotation: bool = True,
    counterweights: bool = True,
    stations: Sequence[object] | None = None,
    spread: str = "ends",
    vertical: object = 1,
    lateral: object = 1,
    length: object = 1,
    most: object = None,
    per_throw: bool = False,
    ratio: object = None,
) -> Design:
    """Return the design with the least counterweights and shafts that balance, or else reduce, orders.

    `shafts` is the most there may be (default: as many as it takes), `counter_rotation` whether they may
    turn against the crank, `counterweights` whether the crank may carry some; `stations` are the places
    for weights (default: one place where that does, else the outermost cylinders), `spread` "even" puts
    weights in all of them; `per_throw` balances half the reciprocating mass on each throw instead. What
    cannot be balanced is made least: mean squares, `vertical` and `lateral` weighted, couples over
    `length` (pitches). `most` bounds each weight, in kg mm; `ratio` overrides lambda.
    """
    engine, orders = checked_engine(engine, ratio), checked_orders(remove)
    limits = checked_limits(
        shafts=shafts,
        counter_rotation=counter_rotation,
        counterweights=counterweights,
        stations=stations,
        spread=spread,
        vertical=vertical,
        lateral=lateral,
        length=length,
        most=most,
        per_throw=per_throw,
    )
    return _designed(engine, orders, limits)


def _designed(engine: Engine, orders: tuple[int, ...], limits: Limits) -> Design:
    """Return the design of an engine within limits that are checked."""
    highest = max(LISTED_ORDERS, orders[-1])
    before = balance(engine, highest)
    devices = tuple(devices_for(before, orders, limits))
    balanced = engine.balanced_by(
        *rotating_counterweights(engine, devices), *(p for d in devices for p in d.parts)
    )
    return Design(engine, balanced, orders, devices, limits, before, balance(balanced, highest))
