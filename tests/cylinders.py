"""Cylinders built anew from the sizes of others, with some of them changed."""

from __future__ import annotations

from typing import Any

import symbalance as sb
from symbalance.engine.crank_train import CYLINDER_SIZES


def cylinder_with(cylinder: sb.Cylinder, **changes: Any) -> sb.Cylinder:
    """Return a cylinder with the place, link and sizes of another, but for `changes` (sizes, `fires`).

    A firing angle and a rod ratio without lengths are not carried over.
    """
    sizes = {key: getattr(cylinder.sizes, key) for key in CYLINDER_SIZES}
    given = {key: value for key, value in (sizes | changes).items() if value is not None}
    place = cylinder.throw.in_degrees(), cylinder.bank.in_degrees(), cylinder.station
    return sb.Cylinder(cylinder.number, *place, link=cylinder.link, **given)
