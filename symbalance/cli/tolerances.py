"""`symbalance tolerances`: the worst an engine within its tolerances can shake."""

from __future__ import annotations

import argparse

from symbalance.cli.output import whole_number, write
from symbalance.errors import SymbalanceError

TOLERANCES = ("mass", "throw", "bank", "station", "stroke", "rod", "offset", "rotating")


def run(options: argparse.Namespace) -> int:
    """Load the engine, bound every order, write the table in the format asked for."""
    order = whole_number(options.order, "order")
    given = {name: getattr(options, name) for name in TOLERANCES if getattr(options, name) is not None}
    if not given:
        names = ", ".join(f"--{name}" for name in TOLERANCES)
        raise SymbalanceError("symbalance tolerances", "is given no tolerance", f"give some of {names}")

    from symbalance.design.variations import Tolerances, worst_cases
    from symbalance.design.variations.tolerance_table import (
        tolerances_json,
        tolerances_latex,
        tolerances_text,
    )
    from symbalance.engine.catalogue import load

    layout = load(options.engine)
    if options.ratio is not None:
        layout = layout.with_ratio(options.ratio)
    tolerances = Tolerances(**given)
    modes = [name.strip() for name in options.of.split(",")]
    found = worst_cases(layout, tolerances, order, of=modes)
    printers = {"text": tolerances_text, "json": tolerances_json, "latex": tolerances_latex}
    printed = printers[options.format](layout, tolerances, found, options.rpm)
    write(printed, options.output, options.format)
    return 0
