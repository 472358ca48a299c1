"""`symbalance bounds`: what leaving out harmonics costs, order by order."""

from __future__ import annotations

import argparse

from symbalance.cli.options import add_output, command
from symbalance.cli.output import show, whole_number


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "bounds", run, "Proved bounds on what a truncated series leaves out.")
    parser.add_argument(
        "--quantity",
        metavar="QUANTITY",
        default="force",
        help="displacement, velocity, acceleration, force or rod-angle; default: force",
    )
    parser.add_argument("--order", metavar="N", default="12", help="highest order; default: 12")
    parser.add_argument("--ratio", metavar="λ", default="4", help="rod ratio l/r; default: 4")
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Write the proved bounds of a quantity."""
    order = whole_number(options.order, "order")

    from symbalance.kinematics.truncation_table import truncation_bounds

    show(truncation_bounds(options.quantity, options.ratio, order), options)
    return 0
