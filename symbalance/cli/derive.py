"""`symbalance derive`: the harmonics of one slider-crank, step by step; a crankshaft node's equations."""

from __future__ import annotations

import argparse

from symbalance.cli.output import show, whole_number
from symbalance.errors import SymbalanceError


def run(options: argparse.Namespace) -> int:
    """Derive the quantity and write the derivation."""
    if options.quantity == "crank-node":
        for name in ("order", "convention"):
            if getattr(options, name) is not None:
                raise SymbalanceError(f"--{name}", "plays no part in crank-node", "leave it out")
        return _run_node(options)
    if options.rotation is not None:
        raise SymbalanceError("--rotation", "is for --quantity crank-node", "leave it out")
    order = whole_number("6" if options.order is None else options.order, "order")

    from symbalance.kinematics.derivation import derive

    show(derive(options.quantity, order, options.convention or "l/r"), options)
    return 0


def _run_node(options: argparse.Namespace) -> int:
    """Derive the equations of a node of the turning crankshaft; orders and ratios play no part."""
    from symbalance.crankshaft.equations import node_equations

    show(node_equations(options.rotation or "vector"), options)
    return 0
