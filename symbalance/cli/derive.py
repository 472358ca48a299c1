"""`symbalance derive`: the harmonics of one slider-crank, step by step."""

from __future__ import annotations

import argparse

from symbalance.cli.output import whole_number, write


def run(options: argparse.Namespace) -> int:
    """Derive the quantity and write the derivation."""
    order = whole_number(options.order, "order")

    from symbalance.derivation import derivation_latex, derivation_text, derive

    result = derive(options.quantity, order, options.convention)
    printed = derivation_latex(result) if options.format == "latex" else derivation_text(result)
    write(printed.rstrip("\n") + "\n", options.output)
    return 0
