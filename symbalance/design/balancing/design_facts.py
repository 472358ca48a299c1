"""Weights, certificate and summary of a design, as its document and its data both state them."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.design.balancing.designs import Claim, Design
from symbalance.design.balancing.devices import Device
from symbalance.design.balancing.ellipses import Ellipse, ellipse
from symbalance.design.balancing.web_segments import Segment
from symbalance.engine.balance_masses import Counterweight
from symbalance.exact.amplitude import Amplitude
from symbalance.text.reals import Real


@dataclass(frozen=True)
class PlacedWeight:
    """One weight of a design: station, exact vector (a share), mass times radius in kg mm if known.

    `pointing` is a vector of its size that points where the weight does, and `segment` what it is cut as,
    None where no ring is given or half of it is too small.
    """

    device: Device
    station: Fraction
    vector: Amplitude
    unbalance: Real | None
    pointing: Amplitude
    segment: Segment | None = None

    @property
    def is_opposite(self) -> bool:
        """Whether its share is below 0 along where it points, as its A_n is: then U is above 0."""
        return not (self.pointing - self.vector).is_zero()


def design_weights(design: Design) -> list[PlacedWeight]:
    """Return every weight that stands at a station, device by device."""
    placed = [(device, *weight) for device in design.devices for weight in device.weights]
    segments: list[Segment | None] = design.segments or [None] * len(placed)
    return [
        PlacedWeight(
            device,
            station,
            vector,
            design.unbalance(device, vector),
            design.direction(device, vector),
            segment,
        )
        for (device, station, vector), segment in zip(placed, segments, strict=True)
    ]


def throw_counterweights(design: Design) -> list[Counterweight]:
    """Return the counterweights of a design that stand on throws: their rotating mass, or more."""
    old = len(design.engine.balancers.counterweights)
    new = design.balanced.balancers.counterweights[old:]
    return [c for c in new if c.overbalance is not None]


def device_name(device: Device) -> str:
    """Return what a device is called.

    >>> from symbalance.design.balancing import design_balance
    >>> from symbalance.engine.catalogue import load
    >>> [device_name(d) for d in design_balance(load("inline-1"), [1]).devices]
    ['crank', 'shaft']
    """
    return "crank" if device.on_crank else "shaft"


def by_order(design: Design) -> list[tuple[int, str, list[Claim]]]:
    """Return (order, "force" or "couple", the claims of +n and -n) in the order they are printed."""
    claims = design.claims
    return [(abs(c.signed), c.kind, claims[i : i + 2]) for i, c in enumerate(claims) if i % 2 == 0]


def residual_ellipses(design: Design) -> list[Ellipse]:
    """Return the ellipses of what a design leaves of the orders to remove."""
    every = [ellipse(design.remains, n, of) for n in design.remove for of in ("force", "couple")]
    return [each for each in every if each.shape != "nothing"]


def achievement(design: Design) -> str:
    """Return what becomes of the orders to remove.

    >>> from symbalance.design.balancing import design_balance
    >>> from symbalance.engine.catalogue import load
    >>> achievement(design_balance(load("v8-90"), [1, 2]))
    'orders 1, 2 are balanced exactly'
    """
    orders = _orders(design)
    if design.is_complete:
        if not design.devices:
            return f"{orders}: nothing to remove"
        return f"{orders} {'is' if len(design.remove) == 1 else 'are'} balanced exactly"
    return f"{orders} {_short_of(design)}"


def requirements(design: Design) -> str:
    """Return what a design takes for that, and whether less would do; empty where nothing is to remove.

    >>> from symbalance.design.balancing import design_balance
    >>> from symbalance.engine.catalogue import load
    >>> requirements(design_balance(load("v8-90"), [1, 2]))
    'with counterweights on the crank; no shaft is needed'
    """
    if not design.devices and design.is_complete:
        return ""
    shafts = len(design.shafts)
    parts = ["counterweights on the crank"] if any(d.on_crank for d in design.devices) else []
    parts += [f"{shafts} balance shaft{'s' if shafts > 1 else ''}"] if shafts else []
    equipment = f"with {' and '.join(parts) or 'nothing built in'}"
    if design.is_complete:
        return f"{equipment}; {'fewer shafts cannot do it' if shafts else 'no shaft is needed'}"
    count = f"{design.least_shafts} shaft{'' if design.least_shafts == 1 else 's'}"
    return f"{equipment}; it takes {count} to balance all exactly"


def sentence(design: Design) -> str:
    """Return in one sentence what the design achieves and what it takes.

    >>> from symbalance.design.balancing import design_balance
    >>> from symbalance.engine.catalogue import load
    >>> sentence(design_balance(load("v8-90"), [1, 2]))
    'Orders 1, 2 are balanced exactly, with counterweights on the crank; no shaft is needed.'
    """
    needs = requirements(design)
    if design.is_complete:
        words = f"{achievement(design)}, {needs}." if needs else f"{achievement(design)}."
    else:
        words = f"{_orders(design)}: {_short_of(design)} {needs}."
    return words[0].upper() + words[1:]


def _short_of(design: Design) -> str:
    """Return what becomes of orders that are not balanced."""
    return "reduced" if design.devices else "left unchanged"


def _orders(design: Design) -> str:
    """Return the orders to remove: "order 1", "orders 1, 2"."""
    return f"order{'' if len(design.remove) == 1 else 's'} {', '.join(map(str, design.remove))}"
