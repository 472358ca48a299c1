"""`symbalance balance`: an engine's free forces and couples."""

from __future__ import annotations

import argparse

from symbalance.cli.options import (
    ENGINE,
    add_full,
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
        commands, "balance", run, "Free forces and couples of an engine, order by order, exactly."
    )
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    parser.add_argument(
        "--order", metavar="N", default="12", help="highest order, 1 to 1000; default: 12"
    )
    parser.add_argument(
        "--power",
        metavar="P",
        help="highest power of 1/λ in the printed series; default: two terms an order",
    )
    parser.add_argument(
        "--ratio", metavar="λ", help="rod ratio l/r, overrides the engine's: 4, 3.7 or 147.15/36.65"
    )
    add_operating_point(parser)
    add_full(parser)
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Load the engine, balance it, show the result."""
    order = whole_number(options.order, "order")
    power = None if options.power is None else whole_number(options.power, "power")

    from symbalance.forces.free_forces import balance

    check_speed_for_sizes(options)
    engine = engine_of(options)
    result = balance(engine, order, power=power)
    if options.rpm is None:
        show(result, options)
        return 0
    from symbalance.forces.operating_point import checked_speeds
    from symbalance.forces.speed_table import over_speeds

    speeds = checked_speeds(options.rpm)
    show(result.at(rpm=speeds[0]) if len(speeds) == 1 else over_speeds(result, speeds), options)
    return 0
