"""Torques as plain values for JSON and tables; exact numbers as strings for SymPy."""

from __future__ import annotations

from math import hypot
from typing import Any

from symbalance.forces.balance_data import component_values
from symbalance.text.numbers import decimal_text
from symbalance.torque.inertia_balance import TorqueBalance
from symbalance.torque.roll import TorqueReport
from symbalance.torque.star_diagrams import FiringStars

DIGITS = 20


def torque_data(report: TorqueReport) -> dict[str, Any]:
    """Return what `to_json` writes of a report, as plain Python values."""
    engine = report.engine
    return {
        "engine": engine.name,
        "strokes": engine.strokes,
        "ratio": None if engine.ratio is None else str(engine.ratio),
        "highest_order": report.inertia.highest,
        "unit": report.inertia.unit,
        **_operating(report.inertia),
        "inertia": _orders(report.inertia),
        "rod": None if not report.excess else _rods(report),
        "frame": {
            "opposite": report.is_opposite,
            "beside": _orders(report.beside),
            "total": None if report.frame is None else _orders(report.frame),
        },
        "running": None if report.running is None else report.running.data(),
    }


def orders_data(balance: TorqueBalance) -> dict[str, Any]:
    """Return what `to_json` writes of one torque, as plain Python values."""
    return {
        "engine": balance.engine.name,
        "strokes": balance.engine.strokes,
        "ratio": None if balance.ratio is None else str(balance.ratio),
        "highest_order": balance.highest,
        "quantity": balance.quantity,
        "unit": balance.unit,
        **_operating(balance),
        "orders": _orders(balance),
    }


def stars_data(stars: FiringStars) -> dict[str, Any]:
    """Return what `to_json` writes of firing stars: angles in turns, and the vectors' sums."""
    return {
        "engine": stars.engine.name,
        "strokes": stars.engine.strokes,
        "highest_order": stars.highest,
        "stars": [
            {
                "order": str(star.order),
                "closed": star.is_closed(),
                "vectors": [{"cylinder": n, "turns": str(turns)} for n, turns in star.vectors],
                "sum": dict(component_values(star.resultant)),
            }
            for star in stars
        ],
    }


def torque_records(report: TorqueReport) -> list[dict[str, Any]]:
    """Return the rows of every part, and of the running engine's torque, which has no exact numbers."""
    rows = [row for balance in report.parts() for row in orders_records(balance)]
    none: dict[str, Any] = {"exact_cos": None, "exact_sin": None, "coefficient": None}
    for row in report.running.records() if report.running else ():
        unit = row.pop("unit")
        rows.append({**row, **none, "unit": unit})
    return rows


def orders_records(balance: TorqueBalance) -> list[dict[str, Any]]:
    """Return a row for each order of one torque.

    Keys: order, of (which torque), cos, sin, amplitude (floats, None with symbols in them), exact_cos,
    exact_sin, coefficient (that of one cylinder, None where it is not apart or no ratio is known), unit;
    at an operating point the amplitude as `value`, in `value_unit`, `value_cos` and `value_sin` with all
    signs, and `rpm`.
    """
    records = []
    for order in balance.orders:
        part, value = order.torque, balance.values.get(order.order)
        cos, sin = (None, None) if part.number.has_symbols else map(float, part.decimal())
        unit = (
            balance.unit
            if balance.kinematics is None
            else f"{balance.kinematics.letter}_n {balance.unit}"
        )
        records.append(
            {
                "order": float(order.order),
                "of": balance.quantity,
                "cos": cos,
                "sin": sin,
                "amplitude": None if cos is None or sin is None else hypot(cos, sin),
                "exact_cos": part.form("cos").spelling,
                "exact_sin": part.form("sin").spelling,
                "coefficient": None if value is None else float(value),
                "unit": unit,
                **_value(balance, order.order),
            }
        )
    return records


def _value(balance: TorqueBalance, order: int) -> dict[str, Any]:
    """Return an order's amplitude and parts in N m at the operating point; None with symbols in it."""
    if balance.operating_point is None:
        return {}
    parts = None if balance.engine.has_symbols else [float(x) for x in balance.in_newton_metres(order)]
    return {
        "value": None if parts is None else hypot(*parts),
        "value_unit": "N m",
        "value_cos": None if parts is None else parts[0],
        "value_sin": None if parts is None else parts[1],
        "rpm": float(balance.operating_point.rpm),
    }


def _rods(report: TorqueReport) -> dict[str, Any]:
    crank, frame = _orders(report.rod), _orders(report.rocking)
    return {"unit": report.rod.unit, "excess": str(report.excess), "crank": crank, "frame": frame}


def _orders(balance: TorqueBalance) -> list[dict[str, Any]]:
    return [_order(balance, n) for n in balance.components]


def _order(balance: TorqueBalance, n: int) -> dict[str, Any]:
    order, value = balance[n], balance.values.get(n)
    series, coefficient = order.coefficient, None
    if series is not None:
        decimal_value = None if value is None else decimal_text(value, DIGITS)
        coefficient = {"series": str(series.in_lam()), "through": series.through, "value": decimal_value}
    torque = dict(component_values(order.torque))
    if balance.operating_point is not None and torque["decimal"] is not None:
        torque["newton_metres"] = [decimal_text(x, DIGITS) for x in balance.in_newton_metres(n)]
    return {"order": str(n), "coefficient": coefficient, "torque": torque}


def _operating(balance: TorqueBalance) -> dict[str, Any]:
    """Return the operating point, where there is one."""
    point = balance.operating_point
    return {} if point is None else {"operating_point": point.data()}
