"""`symbalance torque`: the torque on an engine's crank and frame, its inertia part exact."""

from __future__ import annotations

import argparse
from typing import Any

from symbalance.cli.options import (
    add_engine,
    add_output,
    add_running,
    check_speed_for_sizes,
    command,
    engine_of,
)
from symbalance.cli.output import show, whole_number
from symbalance.errors import SymbalanceError

FOR_RUNNING = ("is for a running engine", "add --pressure FILE or --compression ε")
HEAT = "18"


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands, "torque", run, "The torque on an engine's crank and frame: inertia exactly, gas on top."
    )
    add_engine(parser, "6")
    add_running(parser)
    parser.add_argument("--delta", metavar="δ", help="speed fluctuation; default: 0.02")
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Load the engine, sum its inertia torque, and with a pressure run it."""
    order = whole_number(options.order, "order")

    from symbalance.torque import torque_report
    from symbalance.torque.flywheel import checked_delta

    check_speed_for_sizes(options, ("mass", "pitch"))  # the bore is a running engine's
    engine = engine_of(options)
    printed: dict[str, Any] = {"order": order}
    if options.delta is not None:
        printed["delta"] = checked_delta(options.delta, "--delta")
    running = running_engine(options, engine, **printed)
    if options.delta is not None and running is None:
        raise SymbalanceError("--delta", *FOR_RUNNING)
    report = torque_report(engine, order, running=running)
    show(report if options.rpm is None else report.at(rpm=options.rpm), options)
    return 0


def running_engine(options: argparse.Namespace, engine: Any, whole: bool = True, **printed: Any) -> Any:
    """Return the running engine's torque, None where no pressure is given.

    `printed` are the order and the speed fluctuation that it is printed for. Without `whole` only its gas
    is asked for, over the crank radius: sizes that are not known do no harm.
    """
    from symbalance.torque import ideal_cycle, read_pressure, running_torque

    if not _is_running(options, engine, whole):
        return None
    if options.pressure is not None:
        gas = read_pressure(options.pressure, strokes=engine.strokes)
    else:
        heat = HEAT if options.heat is None else options.heat
        gas = ideal_cycle(options.compression, heat=heat, strokes=engine.strokes)
    rpm = "1" if options.rpm is None else options.rpm
    return running_torque(
        engine, gas, bore=options.bore, rpm=rpm, **_harmless(engine.first, whole), **printed
    )


def _is_running(options: argparse.Namespace, engine: Any, whole: bool) -> bool:
    """Tell whether a pressure is given, or refuse what makes no sense with it or without."""
    if options.pressure is None and options.compression is None:
        for name in ("bore", "heat"):
            if getattr(options, name) is not None:
                raise SymbalanceError(f"--{name}", *FOR_RUNNING)
        return False
    if options.pressure is not None and options.heat is not None:
        raise SymbalanceError("--heat", "is the ideal cycle's", "leave it out, or give --compression")
    if options.bore is None and engine.bore is None:
        raise SymbalanceError("--bore", "is missing", "a pressure needs the cylinder's bore in mm")
    if options.rpm is None and whole:
        raise SymbalanceError("--rpm", "is missing", "a pressure needs the crank's speed")
    return True


def _harmless(first: Any, whole: bool) -> dict[str, object]:
    """Return stroke and mass that the engine lacks where they do no harm, or refuse for lack of them."""
    sizes: dict[str, object] = {}
    for option, name, harmless in (("stroke", "stroke", 1), ("mass", "reciprocating_mass", 0)):
        if getattr(first, name) is not None:
            continue
        if whole:
            remedy = f"give --{option}, or {name} in an engine file"
            raise SymbalanceError(name, "is needed, and the engine does not give it", remedy)
        sizes[name] = harmless
    return sizes
