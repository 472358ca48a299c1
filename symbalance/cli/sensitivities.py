"""`symbalance sensitivities`: how an engine's orders change with each size of each cylinder."""

from __future__ import annotations

import argparse

from symbalance.cli.options import (
    add_engine,
    add_operating_point,
    add_output,
    check_speed_for_sizes,
    command,
    engine_of,
)
from symbalance.cli.output import show, whole_number


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands,
        "sensitivities",
        run,
        "How each order changes with each size of each cylinder, worst first.",
    )
    add_engine(parser, "4")
    parser.add_argument(
        "--parameters",
        metavar="NAMES",
        help="with commas, some of mass, throw, bank, station, stroke, rod, offset, rotating",
    )
    add_operating_point(parser, "N")
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Load the engine, differentiate, show the result."""
    order = whole_number(options.order, "order")

    from symbalance.design.variations import sensitivities

    check_speed_for_sizes(options)
    engine = engine_of(options)
    listing = options.parameters
    parameters = None if listing is None else [name.strip() for name in listing.split(",")]
    show(sensitivities(engine, order, parameters=parameters, rpm=options.rpm), options)
    return 0
