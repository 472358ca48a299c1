"""`symbalance tolerances`: the worst that an engine within its tolerances can shake."""

from __future__ import annotations

import argparse

from symbalance.cli.output import show, whole_number
from symbalance.errors import SymbalanceError

TOLERANCES = ("mass", "throw", "bank", "station", "stroke", "rod", "offset", "rotating")


def run(options: argparse.Namespace) -> int:
    """Load the engine, bound every order, show the result."""
    order = whole_number(options.order, "order")
    tolerances = {
        name: getattr(options, name) for name in TOLERANCES if getattr(options, name) is not None
    }
    if not tolerances:
        names = ", ".join(f"--{name}" for name in TOLERANCES)
        raise SymbalanceError("symbalance tolerances", "is given no tolerance", f"give some of {names}")

    from symbalance.design.variations import Tolerances, worst_cases
    from symbalance.engine.catalogue import load

    engine = load(options.engine)
    if options.ratio is not None:
        engine = engine.with_ratio(options.ratio)
    of = [name.strip() for name in options.of.split(",")]
    show(worst_cases(engine, Tolerances(**tolerances), order, of=of, rpm=options.rpm), options)
    return 0
