"""`symbalance sensitivities`: how an engine's orders change with each size of each cylinder."""

from __future__ import annotations

import argparse

from symbalance.cli.output import whole_number, write


def run(options: argparse.Namespace) -> int:
    """Load the engine, differentiate, write the table in the format asked for."""
    order = whole_number(options.order, "order")

    from symbalance.design.variations import sensitivities
    from symbalance.design.variations.sensitivity_table import (
        sensitivities_json,
        sensitivities_latex,
        sensitivities_text,
    )
    from symbalance.engine.catalogue import load

    layout = load(options.engine)
    if options.ratio is not None:
        layout = layout.with_ratio(options.ratio)
    asked = None
    if options.parameters is not None:
        asked = [name.strip() for name in options.parameters.split(",")]
    found = sensitivities(layout, order, parameters=asked)
    printers = {"text": sensitivities_text, "json": sensitivities_json, "latex": sensitivities_latex}
    write(printers[options.format](layout, found, order), options.output, options.format)
    return 0
