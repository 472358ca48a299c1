"""`symbalance overbalance`: what shares of the reciprocating mass, balanced on every throw, leave."""

from __future__ import annotations

import argparse
from fractions import Fraction

from symbalance.cli.options import (
    ENGINE,
    add_operating_point,
    add_output,
    check_speed_for_sizes,
    command,
    engine_of,
)
from symbalance.cli.output import show
from symbalance.errors import SymbalanceError


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands,
        "overbalance",
        run,
        "What counterweights of 0 to 100 per cent overbalance leave of order 1.",
    )
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    parser.add_argument(
        "--percent",
        metavar="A:B:STEP",
        default="0:100:10",
        help="from A to B by STEP, or a list with commas; default: 0:100:10",
    )
    add_operating_point(parser, "N", rod=False)  # which the first order does not depend on
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Tabulate what each share leaves, and the best."""
    from symbalance.design.balancing.overbalance_table import MOST_SHARES, tabulate_overbalance
    from symbalance.text.numbers import exact

    what = f"--percent {options.percent}"
    if ":" not in options.percent:
        percents = [exact(part.strip(), "percent") for part in options.percent.split(",")]
    else:
        parts = [exact(part.strip(), "percent") for part in options.percent.split(":")]
        if len(parts) != 3 or parts[2] <= 0 or parts[1] < parts[0]:
            raise SymbalanceError(what, "must be A:B:STEP, A to B upwards", "write it like 0:100:10")
        first, last, step = parts
        count = (last - first) // step + 1
        if count > MOST_SHARES:
            raise SymbalanceError(what, f"makes more than {MOST_SHARES} lines", "take a larger step")
        percents = [first + k * step for k in range(int(count))]
    shares: list[Fraction] = [percent / 100 for percent in percents]
    check_speed_for_sizes(options, ("mass", "pitch"))
    table = tabulate_overbalance(engine_of(options), shares)
    show(table if options.rpm is None else table.at(rpm=options.rpm), options)
    return 0
