"""`symbalance sensitivities`: how an engine's orders change with each size of each cylinder."""

from __future__ import annotations

import argparse

from symbalance.cli.output import show, whole_number


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
