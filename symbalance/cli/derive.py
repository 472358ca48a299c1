"""`symbalance derive`: derives a slider-crank's harmonics step by step, or a crank node's equations."""

from __future__ import annotations

import argparse

from symbalance.cli.options import add_output, command
from symbalance.cli.output import show, whole_number
from symbalance.errors import SymbalanceError

QUANTITIES = ("displacement", "velocity", "acceleration", "force", "rod-angle")
CONVENTIONS = ("l/r", "r/l", "l/s")
ROTATIONS = ("vector", "uvw", "uwv", "vuw", "vwu", "wuv", "wvu")


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "derive", run, "The harmonics of one slider-crank, derived as by hand.")
    parser.add_argument(
        "--quantity",
        choices=(*QUANTITIES, "crank-node"),
        default="force",
        help="default: force; crank-node: the equations of a node of the turning crankshaft",
    )
    parser.add_argument(
        "--rotation",
        choices=ROTATIONS,
        help="of crank-node: a rotation vector, or the order of Cardan angles; default: vector",
    )
    parser.add_argument("--order", metavar="N", help="highest order, 1 to 1000; default: 6")
    parser.add_argument(
        "--convention",
        choices=CONVENTIONS,
        help="what is expanded in: λ = l/r, ρ = r/l or λ = l/s (s the stroke); default: l/r",
    )
    add_output(parser)


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
