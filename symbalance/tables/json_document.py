"""A balance as JSON, for other programs: every number exact, as a string that SymPy reads."""

from __future__ import annotations

import json
from functools import lru_cache
from typing import Any

import sympy

from symbalance.cylinders import Cylinder
from symbalance.mechanisms import LinkRod
from symbalance.rational import decimal_text
from symbalance.resultants import Balance, Order, Resultant, checked_balance
from symbalance.spectrum import COMPONENTS, Component, SymbolicPhasor
from symbalance.unlike import mechanism_of

DIGITS = 30
VALUE_DIGITS = 20


def to_json(balance: Balance) -> str:
    """Return a balance as a JSON document; `json.loads` of it is made of strings, lists and dicts."""
    return json.dumps(document(balance), indent=1, ensure_ascii=False)


def document(balance: Balance) -> dict[str, Any]:
    """Return what `to_json` writes, as plain Python values."""
    checked_balance(balance)
    plane = "mean of stations" if balance.reference is None else f"station {balance.reference}"
    return {
        "engine": balance.layout.name,
        "strokes": balance.layout.strokes,
        "ratio": None if balance.ratio is None else str(balance.ratio),
        "reference_plane": plane,
        "cylinders": [_cylinder(c) | _own(balance, c) for c in balance.layout.cylinders],
        "orders": [_order(order, balance) for order in balance.orders],
    }


def _cylinder(cylinder: Cylinder) -> dict[str, Any]:
    return {
        "number": cylinder.number,
        "throw": cylinder.throw.as_text(),
        "bank": cylinder.bank.as_text(),
        "station": str(cylinder.station),
        "fires": None if cylinder.fires is None else str(cylinder.fires),
    }


def _own(balance: Balance, cylinder: Cylinder) -> dict[str, Any]:
    """Return what a cylinder has of its own where they are unlike: lengths over its crank radius."""
    if balance.is_uniform:
        return {}
    mechanism = mechanism_of(balance.layout, cylinder)
    found: dict[str, Any] = {"ratio": str(mechanism.length), "offset": str(mechanism.offset)}
    if isinstance(mechanism, LinkRod) and cylinder.link:
        angle = str(mechanism.link_angle * 360)
        radius = str(mechanism.link_radius)
        found["link"] = {"master": cylinder.link.master, "angle": angle, "radius": radius}
    return found


def _order(order: Order, balance: Balance) -> dict[str, Any]:
    return {
        "order": str(order.order),
        "coefficient": _coefficient(order, balance),
        "force": _resultant(order.force),
        "couple": _resultant(order.couple),
    }


def _coefficient(order: Order, balance: Balance) -> dict[str, Any] | None:
    """Return A_n, or None where cylinders are unlike: components then hold the kinematics too."""
    if order.coefficient is None:
        return None
    value = balance.values.get(order.order)
    return {
        "series": str(order.coefficient.in_lam()),
        "through": order.coefficient.through,
        "value": None if value is None else decimal_text(value, VALUE_DIGITS),
    }


def _resultant(resultant: Resultant) -> dict[str, Any]:
    return {name: dict(_component(resultant.component(name))) for name in COMPONENTS}


@lru_cache(maxsize=4096)
def _component(component: Component) -> dict[str, Any]:
    """Return a component's values, none of which can be changed: documents share them."""
    symbolic = isinstance(component.number, SymbolicPhasor) and not component.is_zero()
    cos, sin, phase = str(component.cos), str(component.sin), component.phase
    return {
        "cos": cos,
        "sin": sin,
        "amplitude": str(component.amplitude),
        # An atan2 is that of the two above, which need not be printed again.
        "phase": str(phase) if not phase.has(sympy.atan2) else f"atan2({sin}, {cos})",
        "decimal": None if symbolic else _decimal(component),
    }


def _decimal(component: Component) -> tuple[str, ...]:
    return tuple(decimal_text(x, DIGITS) for x in component.decimal(DIGITS))
