"""A layout's torque as text or JSON: inertia orders, exact; with a pressure, the running engine's."""

from __future__ import annotations

import json
from math import pi
from typing import Any

from symbalance.notation import series_text
from symbalance.rational import decimal_text
from symbalance.tables.expressions import text
from symbalance.tables.facts import Row, shown
from symbalance.tables.text_table import grid
from symbalance.torque import CrankTorque, TorqueBalance

RPM = 60 / (2 * pi)
DIGITS = 20
NO_MEAN = 1e-9
"""A mean torque below this part of the largest is rounding."""


def torque_text(balance: TorqueBalance) -> str:
    """Return the inertia torque's orders: geometry, then the coefficients t_n of one cylinder."""
    head = [
        f"{balance.layout.name}: inertia torque on the crank, + in the sense of rotation",
        "the frame gets the opposite; gas torque comes on top (--pressure or --compression)",
        "C cos nθ + S sin nθ = amplitude · cos(nθ − phase), unit Tₙ = tₙ m r² ω²",
    ]
    if not balance.orders:
        return "\n".join([*head, "", f"none, to order {balance.highest}"]) + "\n"
    rows = [Row(o.order, "torque", o.torque) for o in balance.orders]
    table = [["order", "cos nθ", "sin nθ", "amplitude", "phase"], *map(_cells, rows)]
    at = "" if balance.ratio is None else f" at λ = {balance.ratio}"
    series = [["order", "tₙ in powers of 1/λ", f"tₙ{at}"]]
    for order in balance.orders:
        value = balance.values.get(order.order)
        written = "" if value is None else shown(value).replace("-", "−")
        series.append([str(order.order), series_text(order.coefficient, ellipsis=True), written])
    return "\n".join([*head, "", *grid(table), "", "Coefficients of one cylinder", *grid(series)]) + "\n"


def _cells(row: Row) -> list[str]:
    return [str(row.order), *(text(e) for e in row.exact())]


def running_text(torque: CrankTorque, delta: float, order: int) -> str:
    """Return what the running engine's torque does: mean, swing, flywheel, orders in N m."""
    swing = torque.fluctuation
    lines = [
        f"Running at {torque.omega * RPM:.6g} rpm, with gas and inertia",
        f"  mean torque          {torque.mean:.6g} N m (indicated; power {torque.power / 1000:.6g} kW)",
        f"  highest, lowest      {swing.largest:.6g}, {swing.least:.6g} N m",
        f"  energy fluctuation   {swing.energy:.6g} J{_shares(torque)}",
        f"  flywheel             {torque.flywheel(delta):.6g} kg m² for a speed fluctuation of {delta:g}",
        "",
        "Orders of the whole torque, N m",
    ]
    table = [["order", "cos nθ", "sin nθ", "amplitude"]]
    for n, cos, sin in torque.terms(order):
        size = (float(cos) ** 2 + float(sin) ** 2) ** 0.5
        table.append([str(n), *(f"{float(x):.6g}".replace("-", "−") for x in (cos, sin, size))])
    return "\n".join([*lines, *grid(table)]) + "\n"


def _shares(torque: CrankTorque) -> str:
    """Return the coefficients of fluctuation, of which there are none without a mean torque."""
    swing = torque.fluctuation
    if torque.mean <= NO_MEAN * swing.largest:
        return "; no mean torque to compare with"
    of_work = f", {swing.of_energy:.4g} of a cycle's work"
    return f"{of_work}; the torque swings by {swing.of_torque:.4g} times its mean"


def torque_json(balance: TorqueBalance, running: CrankTorque | None, delta: float, order: int) -> str:
    """Return the same as a JSON document."""
    document: dict[str, Any] = {
        "engine": balance.layout.name,
        "ratio": None if balance.ratio is None else str(balance.ratio),
        "inertia": [_order(balance, n) for n in balance.components],
        "running": None if running is None else _running(running, delta, order),
    }
    return json.dumps(document, indent=1, ensure_ascii=False)


def _order(balance: TorqueBalance, n: int) -> dict[str, Any]:
    found, value = balance[n], balance.values.get(n)
    part = found.torque
    return {
        "order": str(n),
        "coefficient": {
            "series": str(found.coefficient.in_lam()),
            "through": found.coefficient.through,
            "value": None if value is None else decimal_text(value, DIGITS),
        },
        "torque": {
            "cos": str(part.cos),
            "sin": str(part.sin),
            "amplitude": str(part.amplitude),
            "phase": str(part.phase),
        },
    }


def _running(torque: CrankTorque, delta: float, order: int) -> dict[str, Any]:
    swing = torque.fluctuation
    return {
        "rpm": torque.omega * RPM,
        "mean": torque.mean,
        "power": torque.power,
        "highest": swing.largest,
        "lowest": swing.least,
        "energy": swing.energy,
        "delta": delta,
        "flywheel": torque.flywheel(delta),
        "orders": [
            {"order": str(n), "cos": float(cos), "sin": float(sin)} for n, cos, sin in torque.terms(order)
        ],
    }
