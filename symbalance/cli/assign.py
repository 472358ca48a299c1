"""`symbalance assign`: assigns weighed parts to cylinders so that the engine shakes least."""

from __future__ import annotations

import argparse

from symbalance.cli.options import add_engine, add_operating_point, add_output, command, engine_of
from symbalance.cli.output import show, whole_number


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands, "assign", run, "Which weighed part goes to which cylinder, with the least residual."
    )
    add_engine(parser)
    parser.add_argument(
        "--parts",
        metavar="FILE",
        required=True,
        help="CSV with a header: name, piston, rod_reciprocating, rod_rotating; kg",
    )
    parser.add_argument("--paired", action="store_true", help="keep a row's piston and rod together")
    parser.add_argument("--orders", metavar="LIST", default="1", help="orders that count; default: 1")
    add_operating_point(parser, "N")
    parser.add_argument(
        "--lever",
        metavar="MM",
        help="a couple counts as the force at this lever; default: root mean square of the stations",
    )
    parser.add_argument(
        "--whole", action="store_true", help="count whole masses, not what they differ from their mean by"
    )
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Load engine and parts, show the best arrangement; return 1 where it is not proved best."""
    orders = [whole_number(part, "orders") for part in options.orders.split(",")]

    from symbalance.design.variations import assign_parts, read_parts

    engine = engine_of(options)
    parts = read_parts(options.parts, paired=options.paired)
    places = assign_parts(
        engine, parts, orders=orders, rpm=options.rpm, lever=options.lever, whole=options.whole
    )
    show(places, options)
    return 0 if places.proved else 1
