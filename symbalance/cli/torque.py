"""`symbalance torque`: the torque on an engine's crank and frame, its inertia part exact."""

from __future__ import annotations

import argparse
from typing import Any

from symbalance.cli.output import whole_number, write
from symbalance.errors import SymbalanceError


def run(options: argparse.Namespace) -> int:
    """Load the engine, sum its inertia torque, and with a pressure run it."""
    order = whole_number(options.order, "order")

    from symbalance.catalogue import load
    from symbalance.tables.torque_latex import torque_latex
    from symbalance.tables.torque_table import running_text, torque_json, torque_text
    from symbalance.torque import torque_report

    report = torque_report(load(options.engine), order, ratio=options.ratio)
    running = running_engine(options, report.layout)
    delta = _number(options.delta, "delta")
    if options.format == "json":
        write(torque_json(report, running, delta, order) + "\n", options.output)
    elif options.format == "latex":
        write(torque_latex(report, running, delta, order, standalone=True), options.output)
    else:
        parts = [torque_text(report), *([running_text(running, delta, order)] if running else [])]
        write("\n".join(parts), options.output)
    return 0


def running_engine(options: argparse.Namespace, layout: Any, whole: bool = True) -> Any:
    """Return the running engine's torque, None where no pressure is given.

    Without `whole` only its gas is asked for, over the crank radius: sizes that are not known do no harm.
    """
    from symbalance.torque import crank_torque, ideal_cycle, read_pressure

    if options.pressure is None and options.compression is None:
        for name in ("bore", "rpm"):
            if getattr(options, name) is not None:
                remedy = "add --pressure FILE or --compression ε"
                raise SymbalanceError(f"--{name}", "is for a running engine", remedy)
        return None
    for name, what in (("bore", "the cylinder's bore in mm"), ("rpm", "the crank's speed")):
        if getattr(options, name) is None and (whole or name == "bore"):
            raise SymbalanceError(f"--{name}", "is missing", f"a pressure needs {what}")
    if options.pressure is not None:
        gas = read_pressure(options.pressure, strokes=layout.strokes)
    else:
        gas = ideal_cycle(options.compression, heat=options.heat, strokes=layout.strokes)
    first = layout.train_of(layout.first)
    sizes = {"stroke": 1, "reciprocating_mass": 0}
    unknown = {} if whole else {k: v for k, v in sizes.items() if getattr(first, k) is None}
    return crank_torque(layout, gas, bore=options.bore, rpm=options.rpm or "1", **unknown)


def _number(text: str, name: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 1:
        rule = "must lie between 0 and 1"
        raise SymbalanceError(f"--{name} = {text}", rule, "(highest - lowest)/mean speed, often 0.02")
    return value
