"""Ellipses as plain values for JSON and data frames: exact numbers as strings that SymPy reads."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from symbalance.design.balancing.ellipses import Ellipse
from symbalance.exact.spectrum import Component
from symbalance.forces.balance_data import VALUE_DIGITS, component_values, unit
from symbalance.forces.rows import plane_key
from symbalance.text.numbers import decimal_text
from symbalance.text.reals import pi


def ellipse_data(ellipse: Ellipse) -> dict[str, Any]:
    """Return what `to_json` writes of an ellipse, as plain Python values.

    `cos` and `sin` of its parts are those straight up and to the right at theta = 0; `decimal` is the
    long and the short semi-axis and the direction in radians, None with symbols in them.
    """
    return {
        "engine": ellipse.balance.layout.name,
        "reference_plane": plane_key(ellipse.balance.reference),
        "unit": unit(ellipse.balance, ellipse.of),
        "order": str(ellipse.order),
        "of": ellipse.of,
        **axes(ellipse),
        "sense": None if ellipse.has_symbols else ellipse.sense,
        "decimal": None
        if ellipse.has_symbols
        else [decimal_text(x, VALUE_DIGITS) for x in (*ellipse.decimal_axes, ellipse.decimal_direction)],
        "forward": dict(component_values(Component(ellipse.forward))),
        "backward": dict(component_values(Component(ellipse.backward))),
    }


def axes(ellipse: Ellipse) -> dict[str, Any]:
    """Return what an ellipse is, exactly: its shape, semi-axes and direction in radians."""
    return {
        "shape": ellipse.shape,
        "major": str(ellipse.major),
        "minor": str(ellipse.minor),
        "direction": str(ellipse.direction),
    }


def ellipse_records(ellipses: Sequence[Ellipse]) -> list[dict[str, Any]]:
    """Return a row for each ellipse.

    Keys: order, of (force or couple), drawn, major, minor and direction_deg (floats, None with symbols in
    them), exact_major, exact_minor, unit.
    """
    return [
        {
            "order": ellipse.order,
            "of": ellipse.of,
            "drawn": ellipse.drawn,
            **_decimals(ellipse),
            "exact_major": str(ellipse.major),
            "exact_minor": str(ellipse.minor),
            "unit": unit(ellipse.balance, ellipse.of),
        }
        for ellipse in ellipses
    ]


def _decimals(ellipse: Ellipse) -> dict[str, float | None]:
    if ellipse.has_symbols:
        return {"major": None, "minor": None, "direction_deg": None}
    major, minor = map(float, ellipse.decimal_axes)
    tilt = float(ellipse.decimal_direction * 180 / pi())
    return {"major": major, "minor": minor, "direction_deg": tilt}
