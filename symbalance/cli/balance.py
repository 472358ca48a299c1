"""`symbalance balance`: an engine's free forces and couples."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from symbalance.cli.output import whole_number, write

if TYPE_CHECKING:
    from symbalance.forces.resultants import Balance


def run(options: argparse.Namespace) -> int:
    """Load the engine, balance it, write it in the format asked for."""
    order = whole_number(options.order, "order")
    power = None if options.power is None else whole_number(options.power, "power")

    from symbalance.engine.catalogue import load
    from symbalance.forces.resultants import balance

    result = balance(load(options.engine), order, ratio=options.ratio, power=power)
    write(_printed(result, options.format), options.output, options.format)
    return 0


def _printed(result: Balance, form: str) -> str:
    """Return the result in a format; only that format's printer is imported."""
    if form == "json":
        from symbalance.document.printing import to_json

        return to_json(result) + "\n"
    if form == "latex":
        from symbalance.document.printing import to_latex

        return to_latex(result, standalone=True)
    from symbalance.document.printing import to_text

    return to_text(result)
