"""What the printed forms of a design have in common: its devices, its certificate, what it leaves."""

from __future__ import annotations

from dataclasses import dataclass

from symbalance.design.balancing import Design, Device
from symbalance.design.balancing.certifying import Claim
from symbalance.design.balancing.ellipses import Ellipse, ellipse
from symbalance.exact.amplitude import Amplitude
from symbalance.text.reals import Real

VERDICTS = {
    "absent": "none before",
    "removed": "proved 0",
    "reduced": "changed",
    "unchanged": "as it was",
    "added": "added",
}


@dataclass(frozen=True)
class PlacedWeight:
    """One weight of a design: station, exact vector (a share), mass times radius in kg mm if known."""

    device: Device
    station: str
    vector: Amplitude
    unbalance: Real | None


def weights(design: Design) -> list[PlacedWeight]:
    """Return every weight that stands at a station, device by device."""
    return [
        PlacedWeight(device, str(station), vector, design.unbalance(device, vector))
        for device in design.devices
        for station, vector in device.weights
    ]


def name(device: Device) -> str:
    """Return what a device is called.

    >>> from symbalance.design.balancing import design_balance
    >>> from symbalance.engine.catalogue import load
    >>> [name(d) for d in design_balance(load("inline-1"), [1]).devices]
    ['crank', 'shaft']
    """
    return "crank" if device.on_crank else "shaft"


def by_order(design: Design) -> list[tuple[int, str, list[Claim]]]:
    """Return (order, "force" or "couple", the claims of +n and -n) in the order they are printed."""
    claims = design.claims
    return [(abs(c.signed), c.kind, claims[i : i + 2]) for i, c in enumerate(claims) if i % 2 == 0]


def left_ellipses(design: Design) -> list[tuple[str, Ellipse]]:
    """Return the ellipses of what a design leaves of the orders to remove."""
    found = []
    for n in design.remove:
        for kind in ("force", "couple"):
            left = ellipse(design.remains, n, kind)
            if left.shape != "nothing":
                found.append((kind, left))
    return found


def summary(design: Design) -> str:
    """Return in one sentence what the design achieves and what it takes.

    >>> from symbalance.design.balancing import design_balance
    >>> from symbalance.engine.catalogue import load
    >>> summary(design_balance(load("v8-90"), [1, 2]))
    'Orders 1, 2 end exactly, with counterweights on the crank; no shaft is needed.'
    """
    orders = ", ".join(map(str, design.remove))
    noun = "Order" if len(design.remove) == 1 else "Orders"
    if not design.devices and design.is_complete:
        return f"{noun} {orders}: nothing to remove."
    with_weights = any(d.on_crank for d in design.devices)
    shafts = len(design.shafts)
    parts = ["counterweights on the crank"] if with_weights else []
    parts += [f"{shafts} balance shaft{'s' if shafts > 1 else ''}"] if shafts else []
    means = " and ".join(parts) or "nothing built in"
    verb = "ends" if len(design.remove) == 1 else "end"
    if design.is_complete:
        fewer = "; fewer shafts cannot do it" if shafts else "; no shaft is needed"
        return f"{noun} {orders} {verb} exactly, with {means}{fewer}."
    count = f"{design.least_shafts} shaft{'' if design.least_shafts == 1 else 's'}"
    return f"{noun} {orders}: reduced with {means}; it takes {count} to end all exactly."


def shape(left: Ellipse) -> str:
    """Return what an order draws, and in which sense: "circle, against the crank"."""
    if left.shape == "circle":
        return f"circle, {'with' if left.backward.is_zero() else 'against'} the crank"
    if left.shape == "ellipse" and not left.major.free_symbols:
        return f"ellipse, {'with' if left.sense > 0 else 'against'} the crank"
    return left.shape
