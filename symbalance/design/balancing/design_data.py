"""A design as plain values for JSON and data frames; exact numbers as strings for SymPy."""

from __future__ import annotations

from typing import Any

from symbalance.design.balancing.design_facts import (
    design_weights,
    device_name,
    residual_ellipses,
    sentence,
    throw_counterweights,
)
from symbalance.design.balancing.design_limits import Limits
from symbalance.design.balancing.designs import Claim, Design
from symbalance.design.balancing.devices import Device
from symbalance.design.balancing.rotating_balance import polar, vector_data
from symbalance.design.balancing.web_segments import SegmentRing
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.spectrum import Component
from symbalance.forces.balance_data import VALUE_DIGITS, balance_data, component_values
from symbalance.text.numbers import decimal_text
from symbalance.text.reals import atan2, pi


def design_data(design: Design) -> dict[str, Any]:
    """Return what `to_json` writes of a design, as plain Python values.

    A vector's `cos` and `sin` are its parts straight up and to the right at theta = 0; `share` is in
    units of A_n m r/n^2 (m r/n^2 where cylinders are unlike), `unbalance` in kg mm or null.
    """
    return {
        "engine": design.engine.name,
        "remove": [str(n) for n in design.remove],
        "limits": _limits(design.limits),
        "complete": design.is_complete,
        "summary": sentence(design),
        "least_shafts": design.least_shafts,
        **({"ring": _ring(design.ring)} if design.ring else {}),
        "devices": [_device(design, device) for device in design.devices],
        "certificate": [_claim(claim) for claim in design.claims],
        "left": [
            {"order": str(curve.order), "kind": curve.of, **curve.axes_data()}
            for curve in residual_ellipses(design)
        ],
        "remains": balance_data(design.remains),
    }


def _limits(limits: Limits) -> dict[str, Any]:
    """Return what a design was allowed, and how it weighs what is left."""
    weighting = limits.weighting
    return {
        "shafts": limits.shafts,
        "counter_rotation": limits.counter_rotation,
        "counterweights": limits.counterweights,
        "stations": None if limits.stations is None else [str(s) for s in limits.stations],
        "spread": limits.spread,
        "vertical": str(weighting.vertical),
        "lateral": str(weighting.lateral),
        "length": str(weighting.length),
        "most": None if limits.most is None else str(limits.most),
        "per_throw": limits.per_throw,
    }


def _device(design: Design, device: Device) -> dict[str, Any]:
    return {
        "speed": device.speed,
        "kind": "counterweights" if device.on_crank else "shaft",
        "per_throw": not device.weights,
        "force": vector_data(device.force),
        "couple": vector_data(device.couple),
        "weights": [
            {
                "station": str(station),
                "share": vector_data(share),
                "unbalance": _unbalance(design, device, share),
                "direction": _degrees(design.direction(device, share)),
                **_segment(design, device, share),
            }
            for station, share in device.weights
        ],
    }


def _degrees(pointing: Amplitude) -> str | None:
    """Return where a weight points, in degrees from straight up to the right; None with symbols."""
    if pointing.has_symbols:
        return None
    near = pointing.evaluated()
    return decimal_text(atan2(near.imag, near.real) * 180 / pi(), VALUE_DIGITS)


def _ring(ring: SegmentRing) -> dict[str, str]:
    sizes = {"inner": ring.inner, "outer": ring.outer, "thickness": ring.thickness}
    return {name: str(size) for name, size in {**sizes, "density": ring.density}.items()}


def _segment(design: Design, device: Device, share: Amplitude) -> dict[str, Any]:
    size = design.unbalance(device, share)
    if design.ring is None or size is None:
        return {}
    cut = design.ring.segment(size)
    if cut is None:
        needed = decimal_text(design.ring.thickness_for(size), VALUE_DIGITS)
        return {"segment": {"angle": None, "mass": None, "thickness_needed": needed}}
    parts = {"angle": cut.angle, "mass": cut.mass}
    return {"segment": {name: decimal_text(part, VALUE_DIGITS) for name, part in parts.items()}}


def _unbalance(design: Design, device: Device, share: Amplitude) -> str | None:
    size = design.unbalance(device, share)
    return None if size is None else decimal_text(size, VALUE_DIGITS)


def _claim(claim: Claim) -> dict[str, Any]:
    return {
        "order": f"{claim.signed:+d}",
        "kind": claim.kind,
        "verdict": claim.verdict,
        "left": dict(component_values(claim.component)),
    }


def design_records(design: Design) -> list[dict[str, Any]]:
    """Return a row for each weight that is built in.

    Keys: speed (times the crank's), on (crank or shaft), station (pitches), share and direction_deg
    (floats, None with symbols in them; the share is below 0 where its A_n is, and the weight points in
    the direction), exact_up and exact_right (the share's parts), unbalance_kg_mm (None where sizes do not
    say); with a ring to cut from, segment_deg and segment_kg (None where half of it is too small). A
    counterweight on a throw has throw and overbalance instead: it balances the throw's rotating mass and
    that part of its reciprocating mass.
    """
    cut = ("segment_deg", "segment_kg") if design.ring else ()
    none = dict.fromkeys((*design.record_keys, *cut))
    rows = []
    for weight in design_weights(design):
        part = Component(weight.vector)
        share, degrees = polar(weight.pointing)
        signed = -share if share is not None and weight.is_opposite else share
        segment = weight.segment
        angle, mass = (None, None) if segment is None else (float(segment.angle), float(segment.mass))
        exact = {"exact_up": part.form("cos").spelling, "exact_right": part.form("sin").spelling}
        size = None if weight.unbalance is None else float(weight.unbalance)
        place = {
            "speed": weight.device.speed,
            "on": device_name(weight.device),
            "station": float(weight.station),
        }
        rows.append(
            {**none, **place, "share": signed, "direction_deg": degrees, **exact, "unbalance_kg_mm": size}
            | ({"segment_deg": angle, "segment_kg": mass} if design.ring else {})
        )
    for counterweight in throw_counterweights(design):
        overbalance = float(counterweight.overbalance or 0)
        on = {"speed": 1, "on": "crank", "throw": counterweight.throw, "overbalance": overbalance}
        rows.append({**none, **on})
    return rows
