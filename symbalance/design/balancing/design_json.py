"""A design as JSON, for other programs: every number exact, as a string that SymPy reads."""

from __future__ import annotations

import json
from typing import Any

from symbalance.design.balancing import Design, Device
from symbalance.design.balancing.certifying import Claim
from symbalance.design.balancing.design_facts import left_ellipses, summary
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.spectrum import Component
from symbalance.forces.balance_json import VALUE_DIGITS, component_values, document
from symbalance.text.numbers import decimal_text


def design_json(design: Design) -> str:
    """Return a design as a JSON document."""
    return json.dumps(design_document(design), indent=1, ensure_ascii=False)


def design_document(design: Design) -> dict[str, Any]:
    """Return what `design_json` writes, as plain Python values.

    A vector's `cos` and `sin` are its parts straight up and to the right at theta = 0; `share` is in
    units of A_n m r/n^2 (m r/n^2 where cylinders are unlike), `unbalance` in kg mm or null.
    """
    return {
        "engine": design.layout.name,
        "remove": [str(n) for n in design.remove],
        "complete": design.is_complete,
        "summary": summary(design),
        "least_shafts": design.least_shafts,
        "devices": [_device(design, device) for device in design.devices],
        "certificate": [_claim(claim) for claim in design.claims],
        "left": [
            {
                "order": str(left.order),
                "kind": kind,
                "shape": left.shape,
                "major": str(left.major),
                "minor": str(left.minor),
                "direction": str(left.direction),
            }
            for kind, left in left_ellipses(design)
        ],
        "remains": document(design.remains),
    }


def _device(design: Design, device: Device) -> dict[str, Any]:
    return {
        "speed": device.speed,
        "kind": "counterweights" if device.on_crank else "shaft",
        "per_throw": not device.weights,
        "force": _vector(device.force),
        "couple": _vector(device.couple),
        "weights": [
            {
                "station": str(station),
                "share": _vector(vector),
                "unbalance": _unbalance(design, device, vector),
            }
            for station, vector in device.weights
        ],
    }


def _unbalance(design: Design, device: Device, vector: Amplitude) -> str | None:
    size = design.unbalance(device, vector)
    return None if size is None else decimal_text(size, VALUE_DIGITS)


def _vector(number: Amplitude) -> dict[str, Any]:
    return dict(component_values(Component(number)))


def _claim(claim: Claim) -> dict[str, Any]:
    return {
        "order": f"{claim.signed:+d}",
        "kind": claim.kind,
        "verdict": claim.verdict,
        "left": dict(component_values(claim.component)),
    }
