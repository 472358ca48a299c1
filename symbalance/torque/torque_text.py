"""A layout's torque as text or JSON: inertia orders, exact; with a pressure, the running engine's."""

from __future__ import annotations

import json
from math import pi
from typing import Any

from symbalance.document.decimals import shown
from symbalance.document.expressions import text
from symbalance.document.grid import grid
from symbalance.engine.kinds import kind_lines
from symbalance.forces.rows import Row
from symbalance.kinematics.series_printing import series_text
from symbalance.text.numbers import decimal_text, short_text
from symbalance.torque import CrankTorque, TorqueBalance, TorqueReport

RPM = 60 / (2 * pi)
DIGITS = 20
NO_MEAN = 1e-9
"""A mean torque below this part of the largest is rounding."""
SUBSCRIPT = {"t": "tₙ", "u": "uₙ", "k": "kₙ"}


def torque_text(report: TorqueReport) -> str:
    """Return the inertia torque's orders, geometry and coefficients of one cylinder, and the frame's."""
    layout = report.layout
    head = [
        f"{layout.name}: inertia torque on the crank, + in the sense of rotation",
        _frame_line(report),
        "gas torque comes on top (--pressure or --compression)",
        *([] if report.inertia.kinematics else kind_lines(layout)),
        f"C cos nθ + S sin nθ = amplitude · cos(nθ − phase), unit {_unit(report.inertia)}",
    ]
    parts = ["\n".join([*head, "", *_tables(report.inertia)])]
    for title, part in frame_parts(report):
        parts.append("\n".join([title + f", unit {_unit(part)}", *_tables(part)]))
    return "\n\n".join(parts) + "\n"


def frame_parts(report: TorqueReport) -> list[tuple[str, TorqueBalance]]:
    """Return the tables beside the inertia torque's, each with its title."""
    found = []
    if report.excess:
        size = f"Jₓ = {float(report.excess) / 1e6:.6g} kg m²".replace("-", "−")
        found.append((f"Rods' own inertia, {size}: torque on the crank", report.rod))
        found.append(("Rods' own inertia: couple on the frame", report.rocking))
    if report.beside.components:
        found.append(("Inertia forces beside the crank's axis: moment on the frame", report.beside))
    if report.frame is not None:
        whole = "all inertia and balance shafts" if report.shafts else "all inertia"
        found.append((f"Roll moment on the frame about the crank's axis, {whole}", report.frame))
    return found


def _frame_line(report: TorqueReport) -> str:
    if report.is_opposite:
        return "the frame gets the opposite"
    if report.frame is None:
        return "the frame gets the opposite, and moments of its own, whose sum needs more sizes"
    return "the frame gets the opposite, and the moments below; of gas torque the opposite alone"


def _unit(balance: TorqueBalance) -> str:
    unit = balance.unit.replace("omega^2", "ω²").replace("r^2", "r²").replace("J_x", "Jₓ")
    if balance.kinematics is None:
        return unit
    if balance.kinematics.letter == "t":
        return f"Tₙ = tₙ {unit}"
    return f"{SUBSCRIPT[balance.kinematics.letter]} {unit}"


def _tables(balance: TorqueBalance) -> list[str]:
    if not balance.components:
        return [f"none, to order {balance.highest}"]
    rows = [Row(n, "torque", c) for n, c in balance.components.items()]
    table = grid([["order", "cos nθ", "sin nθ", "amplitude", "phase"], *map(_cells, rows)])
    if balance.kinematics is None:
        return table
    letter = SUBSCRIPT[balance.kinematics.letter]
    at = "" if balance.ratio is None else f" at λ = {short_text(balance.ratio)}"
    series = [["order", f"{letter} in powers of 1/λ", f"{letter}{at}"]]
    for order in balance.orders:
        assert order.coefficient is not None
        value = balance.values.get(order.order)
        written = "" if value is None else shown(value).replace("-", "−")
        series.append([str(order.order), series_text(order.coefficient, ellipsis=True), written])
    return [*table, "", "Coefficients of one cylinder", *grid(series)]


def _cells(row: Row) -> list[str]:
    decimals = row.decimals() if row.is_decimal else None
    if decimals is not None:
        return [str(row.order), *(d.replace("-", "−") for d in decimals)]
    return [str(row.order), *(text(e) for e in row.exact())]


def running_text(torque: CrankTorque, delta: float, order: int) -> str:
    """Return what the running engine's torque does: mean, swing, flywheel, orders in N m."""
    lines = [
        running_head(torque),
        *(f"  {name:<20} {value}" for name, value in running_facts(torque, delta)),
    ]
    lines += ["", "Orders of the whole torque, N m"]
    table = [["order", "cos nθ", "sin nθ", "amplitude"]]
    for n, cos, sin in torque.terms(order):
        size = (float(cos) ** 2 + float(sin) ** 2) ** 0.5
        table.append([str(n), *(f"{float(x):.6g}".replace("-", "−") for x in (cos, sin, size))])
    return "\n".join([*lines, *grid(table)]) + "\n"


def running_head(torque: CrankTorque) -> str:
    """Return at what speed the engine runs."""
    return f"Running at {torque.omega * RPM:.6g} rpm, with gas and inertia"


def running_facts(torque: CrankTorque, delta: float) -> list[tuple[str, str]]:
    """Return the mean torque, its extremes, the energy fluctuation and the flywheel, in words."""
    swing = torque.fluctuation
    mean = f"{torque.mean:.6g} N m (indicated; power {torque.power / 1000:.6g} kW)"
    wheel = f"{torque.flywheel(delta):.6g} kg m² for a speed fluctuation of {delta:g}"
    return [
        ("mean torque", mean),
        ("highest, lowest", f"{swing.largest:.6g}, {swing.least:.6g} N m"),
        ("energy fluctuation", f"{swing.energy:.6g} J{_shares(torque)}"),
        ("flywheel", wheel),
    ]


def _shares(torque: CrankTorque) -> str:
    """Return the coefficients of fluctuation, of which there are none without a mean torque."""
    swing = torque.fluctuation
    if torque.mean <= NO_MEAN * swing.largest:
        return "; no mean torque to compare with"
    of_work = f", {swing.of_energy:.4g} of a cycle's work"
    return f"{of_work}; the torque swings by {swing.of_torque:.4g} times its mean"


def torque_json(report: TorqueReport, running: CrankTorque | None, delta: float, order: int) -> str:
    """Return the same as a JSON document."""
    layout = report.layout
    document: dict[str, Any] = {
        "engine": layout.name,
        "strokes": layout.strokes,
        "ratio": None if layout.ratio is None else str(layout.ratio),
        "unit": report.inertia.unit,
        "inertia": _orders(report.inertia),
        "rod": None if not report.excess else _rods(report),
        "frame": {
            "opposite": report.is_opposite,
            "beside": _orders(report.beside),
            "total": None if report.frame is None else _orders(report.frame),
        },
        "running": None if running is None else _running(running, delta, order),
    }
    return json.dumps(document, indent=1, ensure_ascii=False)


def _rods(report: TorqueReport) -> dict[str, Any]:
    crank, frame = _orders(report.rod), _orders(report.rocking)
    return {"unit": report.rod.unit, "excess": str(report.excess), "crank": crank, "frame": frame}


def _orders(balance: TorqueBalance) -> list[dict[str, Any]]:
    return [_order(balance, n) for n in balance.components]


def _order(balance: TorqueBalance, n: int) -> dict[str, Any]:
    found, value = balance[n], balance.values.get(n)
    part, series = found.torque, found.coefficient
    coefficient = None
    if series is not None:
        written = None if value is None else decimal_text(value, DIGITS)
        coefficient = {"series": str(series.in_lam()), "through": series.through, "value": written}
    return {
        "order": str(n),
        "coefficient": coefficient,
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
        "rpm": round(torque.omega * RPM, 9),
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
