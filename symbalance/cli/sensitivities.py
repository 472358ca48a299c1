"""`symbalance sensitivities`: how an engine's orders change with each size of each cylinder."""

from __future__ import annotations

import argparse

from symbalance.cli.options import add_engine, add_output, command
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
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Load the engine, differentiate, show the result."""
    order = whole_number(options.order, "order")

    from symbalance.design.variations import sensitivities
    from symbalance.engine.catalogue import load

    engine = load(options.engine)
    if options.ratio is not None:
        engine = engine.with_ratio(options.ratio)
    listing = options.parameters
    parameters = None if listing is None else [name.strip() for name in listing.split(",")]
    show(sensitivities(engine, order, parameters=parameters), options)
    return 0
