"""`symbalance emit`: an engine as source code that runs without symbalance."""

from __future__ import annotations

import argparse
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

from symbalance.cli.options import ENGINE, add_running, command, engine_of
from symbalance.cli.output import whole_number, write, write_all
from symbalance.cli.torque import running_engine
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.codegen.plans import Plan
    from symbalance.engine.engine import Engine

TARGETS = ("numpy", "numba", "array-api", "c", "javascript", "octave")


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands, "emit", run, "An engine's forces and couples as source code that runs alone."
    )
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    parser.add_argument("--target", choices=TARGETS, required=True, help="the language or library")
    parser.add_argument(
        "--outputs",
        metavar="NAMES",
        default="force.vertical",
        help="with commas: force. or couple. with vertical, lateral, forward, backward; piston. with "
        "displacement, velocity or acceleration; torque. with inertia, rod or frame, and with a pressure "
        "gas or total; default: force.vertical",
    )
    orders = parser.add_mutually_exclusive_group()
    orders.add_argument("--order", metavar="N", help="highest order, 1 to 1000")
    orders.add_argument(
        "--tolerance",
        metavar="ε",
        help="the fewest orders whose proven bound is within ε, in m r ω² (couples m r ω² a); "
        "default: every order that shows in a double",
    )
    parser.add_argument("--ratio", metavar="λ", help="rod ratio l/r, overrides the engine's")
    add_running(parser, pitch=True)
    parser.add_argument(
        "--uniform-grid",
        action="store_true",
        help="add a function for evenly spaced angles, which computes one period only",
    )
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="the file to write; C writes FILE.c and FILE.h"
    )


def run(options: argparse.Namespace) -> int:
    """Load the engine, plan its outputs, write them in the target's language."""
    outputs = [name.strip() for name in options.outputs.split(",")]
    _check_use(options, outputs)
    order = None if options.order is None else whole_number(options.order, "order")
    tolerance = _tolerance(options.tolerance) if order is None else None

    from symbalance.codegen import plan_for
    from symbalance.codegen.targets import FILES, files, identifier
    from symbalance.forces.free_forces import balance

    path = _path(options.output, FILES[options.target], options.target)
    engine = engine_of(options)
    _check_sizes(options, engine, outputs)
    running = running_engine(options, engine, "torque.total" in outputs)
    highest = 1 if order is None else order
    result = balance(engine, highest) if running is None else running
    plan = plan_for(result, None, outputs, options.target, tolerance, highest)
    name = identifier(engine.name) if path is None else path.stem
    if options.rpm is not None:
        plan = _at_speed(plan, engine, options)
    texts = files(plan, options.target, engine.name, name, grid=options.uniform_grid)
    if path is None or len(texts) == 1:
        write(next(iter(texts.values())), None if path is None else str(path), "source")
    else:
        write_all({str(path.with_suffix(suffix)): text for suffix, text in texts.items()})
    return 0


def _check_use(options: argparse.Namespace, outputs: list[str]) -> None:
    """Refuse what no output asked for depends on, rather than pass over it."""
    if options.order is not None and all(name.startswith("piston.") for name in outputs):
        raise SymbalanceError("--order", "plays no part in piston outputs, always exact", "leave it out")
    gas = {"torque.gas", "torque.total"} & set(outputs)
    for name in ("pressure", "compression", "heat", "bore"):
        if getattr(options, name) is not None and not gas:
            rule = "is for the outputs torque.gas and torque.total"
            raise SymbalanceError(f"--{name}", rule, "add one to --outputs, or leave this out")
    if options.rpm is not None or "torque.total" in gas:
        return
    for name in ("stroke", "mass", "pitch"):
        # Stroke and rod are the rod ratio, and gas pushes at the crank radius.
        if getattr(options, name) is None or (name == "stroke" and (options.rod is not None or gas)):
            continue
        rule = "makes newtons at a speed only, and mass, radius, omega and pitch are 1 unless given"
        raise SymbalanceError(f"--{name}", rule, "add --rpm N, or leave this out")


def _check_sizes(options: argparse.Namespace, engine: Engine, outputs: list[str]) -> None:
    """Refuse forces at a speed without a rod ratio, naming all that is missing beside it."""
    kinds = {name.partition(".")[0] for name in outputs}
    if options.rpm is None or engine.first.ratio is not None or not kinds <= {"force", "couple"}:
        return
    from symbalance.forces.operating_point import operating_point

    operating_point(engine, options.rpm, needs_pitch="couple" in kinds, needs_ratio=True)


def _at_speed(plan: Plan, engine: Engine, options: argparse.Namespace) -> Plan:
    """Return a plan whose keywords are the engine's at a speed where none is given."""
    from dataclasses import replace

    from symbalance.codegen.keyword_defaults import defaults_at

    whole = any(output.harmonic_sum.name == "torque.total" for output in plan.outputs)
    used = plan.factors | ({"mass"} if whole else set())
    for name in ("mass", "pitch"):
        if getattr(options, name) is not None and name not in used:
            rule = "plays no part in the outputs asked for"
            raise SymbalanceError(
                f"--{name}", rule, "leave it out, or add an output that it does to --outputs"
            )
    return replace(plan, defaults=defaults_at(engine, options.rpm, plan.factors))


def _tolerance(text: str | None) -> float:
    """Return the tolerance, 0 where none is asked for."""
    if text is None:
        return 0.0
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not isfinite(value) or value <= 0:
        rule = "must be a positive number"
        raise SymbalanceError(f"--tolerance = {text}", rule, "write it like --tolerance 1e-6")
    return value


def _path(output: str | None, endings: tuple[str, ...], target: str) -> Path | None:
    """Return the file to write, None for stdout, or refuse a name that does not fit the target."""
    if output in (None, "-"):
        if target == "c":
            raise SymbalanceError("--target c", "writes two files", "name one: -o engine.c")
        return None
    path = Path(str(output))
    if path.suffix not in endings:
        rule = f"must end in {' or '.join(endings)} for --target {target}"
        raise SymbalanceError(f"--output {output}", rule, f"for instance -o engine{endings[0]}")
    return path
