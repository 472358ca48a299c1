"""`symbalance balance`: an engine's free forces and couples."""

from __future__ import annotations

import argparse

from symbalance.cli.output import show, whole_number


def run(options: argparse.Namespace) -> int:
    """Load the engine, balance it, show the result."""
    order = whole_number(options.order, "order")
    power = None if options.power is None else whole_number(options.power, "power")

    from symbalance.engine.catalogue import load
    from symbalance.forces.free_forces import balance

    show(balance(load(options.engine), order, ratio=options.ratio, power=power), options)
    return 0
