"""`symbalance derive`: the harmonics of one slider-crank, step by step; a crankshaft node's equations."""

from __future__ import annotations

import argparse

from symbalance.cli.output import whole_number, write


def run(options: argparse.Namespace) -> int:
    """Derive the quantity and write the derivation."""
    if options.quantity == "crank-node":
        return _run_node(options)
    order = whole_number(options.order, "order")

    from symbalance.derivation import derivation_latex, derivation_text, derive

    result = derive(options.quantity, order, options.convention)
    printed = derivation_latex(result) if options.format == "latex" else derivation_text(result)
    write(printed.rstrip("\n") + "\n", options.output, options.format)
    return 0


def _run_node(options: argparse.Namespace) -> int:
    """Derive the equations of a node of the turning crankshaft; orders and ratios play no part."""
    from symbalance.crankshaft.equations import equations_text, node_equations
    from symbalance.tables.latex_document import to_latex

    found = node_equations(options.rotation)
    latex = options.format == "latex"
    printed = to_latex(found, standalone=True) if latex else equations_text(found)
    write(printed, options.output, options.format)
    return 0
