"""`symbalance tolerances`: the largest forces and couples of an engine within its tolerances."""

from __future__ import annotations

import argparse

from symbalance.cli.options import add_engine, add_output, command, engine_of
from symbalance.cli.output import show, whole_number
from symbalance.errors import SymbalanceError

SIZES = (
    ("mass", "KG", "reciprocating mass, kg or percent (0.5%%)"),
    ("throw", "DEGREES", "crank pin angle"),
    ("bank", "DEGREES", "angle of a cylinder's axis"),
    ("station", "MM", "place along the crank, mm or percent of the pitch"),
    ("stroke", "MM", "stroke"),
    ("rod", "MM", "rod length"),
    ("offset", "MM", "offset of the axis from the crank"),
    ("rotating", "KG", "rotating mass, kg or percent of the reciprocating mass"),
)
"""The sizes that may have a tolerance: option, unit, meaning."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "tolerances", run, "The worst an engine within its tolerances can shake.")
    add_engine(parser, "4")
    for name, unit, about in SIZES:
        parser.add_argument(f"--{name}", metavar=unit, help=f"plus or minus, of every cylinder: {about}")
    parser.add_argument(
        "--of",
        metavar="NAMES",
        default="largest",
        help="with commas: largest (over a turn), vertical, lateral, forward, backward; default: largest",
    )
    parser.add_argument("--rpm", metavar="N", help="speed, for results in N and N m")
    parser.add_argument(
        "--sizes",
        metavar="NAME=VALUE,…",
        help="sizes the engine gives none of, mm and kg: mass=0.5,stroke=86,rod=143,pitch=98",
    )
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Load the engine, bound every order, show the result."""
    order = whole_number(options.order, "order")
    tolerances = {
        name: getattr(options, name) for name, *_ in SIZES if getattr(options, name) is not None
    }
    if not tolerances:
        names = ", ".join(f"--{name}" for name, *_ in SIZES)
        raise SymbalanceError("symbalance tolerances", "is given no tolerance", f"give some of {names}")

    from symbalance.design.variations import Tolerances, worst_cases

    engine = engine_of(options, _sizes(options.sizes))
    first = engine.first
    if options.rpm is not None and (first.radius is None or not first.reciprocating_mass):
        lacks = {"stroke=86": first.radius is None, "mass=0.5": not first.reciprocating_mass}
        names = ",".join(name for name, is_missing in lacks.items() if is_missing)
        rule = "needs the engine's stroke and reciprocating_mass for newtons"
        remedy = f"add what is missing to [crank_train], or append your own figures like --sizes {names}"
        raise SymbalanceError(f"--rpm {options.rpm}", rule, remedy)
    of = [name.strip() for name in options.of.split(",")]
    show(worst_cases(engine, Tolerances(**tolerances), order, of=of, rpm=options.rpm), options)
    return 0


def _sizes(text: str | None) -> dict[str, str]:
    """Return the sizes that an option lists, or refuse what is none."""
    from symbalance.forces.operating_point import SIZES

    known = [name for name in SIZES if name != "bore"]  # which plays no part here
    pairs = [part.split("=") for part in (text or "").split(",") if part.strip()]
    sizes: dict[str, str] = {}
    for pair in pairs:
        name = pair[0].strip()
        if len(pair) != 2 or name not in known or name in sizes:
            remedy = "write mass=0.5,stroke=86,rod=143,pitch=98, each once"
            raise SymbalanceError(f"--sizes {text}", f"must name some of {', '.join(known)}", remedy)
        sizes[name] = pair[1].strip()
    return sizes
