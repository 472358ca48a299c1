"""`symbalance torque`: the torque on an engine's crank and frame, its inertia part exact."""

from __future__ import annotations

import argparse
from typing import Any

from symbalance.cli.options import add_engine, add_output, add_running, command
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

    from symbalance.engine.catalogue import load
    from symbalance.torque import torque_report
    from symbalance.torque.flywheel import checked_delta

    engine = load(options.engine)
    engine = engine if options.ratio is None else engine.with_ratio(options.ratio)
    printed: dict[str, Any] = {"order": order}
    if options.delta is not None:
        printed["delta"] = checked_delta(options.delta, "--delta")
    running = running_engine(options, engine, **printed)
    if options.delta is not None and running is None:
        raise SymbalanceError("--delta", *FOR_RUNNING)
    show(torque_report(engine, order, running=running), options)
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
    sizes = _sizes(options, engine.first, whole)
    rpm = "1" if options.rpm is None else options.rpm
    return running_torque(engine, gas, bore=options.bore, rpm=rpm, **sizes, **printed)


def _is_running(options: argparse.Namespace, engine: Any, whole: bool) -> bool:
    """Tell whether a pressure is given, or refuse what makes no sense with it or without."""
    if options.pressure is None and options.compression is None:
        for name in ("bore", "rpm", "heat", "stroke", "mass"):
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


def _sizes(options: argparse.Namespace, first: Any, whole: bool) -> dict[str, object]:
    """Return stroke and mass as far as they are said, or needed and known to do no harm."""
    sizes: dict[str, object] = {}
    for option, name, harmless in (("stroke", "stroke", 1), ("mass", "reciprocating_mass", 0)):
        words, known = getattr(options, option), getattr(first, name)
        if words is not None:
            sizes[name] = words
        elif known is None and not whole:
            sizes[name] = harmless
        elif known is None:
            remedy = f"give --{option}, or {name} in an engine file"
            raise SymbalanceError(name, "is needed, and the engine does not give it", remedy)
    return sizes
