"""`symbalance assign`: which weighed part goes to which cylinder."""

from __future__ import annotations

import argparse

from symbalance.cli.output import show, whole_number


def run(options: argparse.Namespace) -> int:
    """Load the engine and the parts, find the best arrangement, show it."""
    orders = [whole_number(part, "orders") for part in options.orders.split(",")]

    from symbalance.design.variations import assign_parts, read_parts
    from symbalance.engine.catalogue import load

    engine = load(options.engine)
    if options.ratio is not None:
        engine = engine.with_ratio(options.ratio)
    parts = read_parts(options.parts, paired=options.paired)
    places = assign_parts(
        engine, parts, orders=orders, rpm=options.rpm, lever=options.lever, whole=options.whole
    )
    show(places, options)
    return 0
