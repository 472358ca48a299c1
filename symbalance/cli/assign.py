"""`symbalance assign`: which weighed part goes to which cylinder."""

from __future__ import annotations

import argparse

from symbalance.cli.output import whole_number, write


def run(options: argparse.Namespace) -> int:
    """Load the engine and the parts, find the best arrangement, write it in the format asked for."""
    orders = [whole_number(part, "orders") for part in options.orders.split(",")]

    from symbalance.design.variations import assign_parts, read_parts
    from symbalance.design.variations.assignment_table import (
        assignment_json,
        assignment_latex,
        assignment_text,
    )
    from symbalance.engine.catalogue import load

    layout = load(options.engine)
    if options.ratio is not None:
        layout = layout.with_ratio(options.ratio)
    parts = read_parts(options.parts, paired=options.paired)
    found = assign_parts(
        layout, parts, orders=orders, rpm=options.rpm, lever=options.lever, whole=options.whole
    )
    printers = {"text": assignment_text, "json": assignment_json, "latex": assignment_latex}
    write(printers[options.format](found), options.output, options.format)
    return 0
