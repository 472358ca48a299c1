"""`symbalance formulas`: one order with letters for what cylinders differ in, or of N cylinders."""

from __future__ import annotations

import argparse

from symbalance.cli.options import ENGINE, add_bank, add_output, bank_angle, command
from symbalance.cli.output import show, whole_number
from symbalance.errors import SymbalanceError

LETTERS = ("masses", "stations", "radii", "rods", "offsets")
"""What may stand as a letter, one for each cylinder."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands,
        "formulas",
        run,
        "Forces and couples with letters in them: masses, lengths, N cylinders.",
    )
    parser.add_argument(
        "engine", metavar="ENGINE", nargs="?", help=f"{ENGINE}; without: N cylinders in a row"
    )
    parser.add_argument(
        "--order",
        metavar="N",
        default="1",
        help="of ENGINE: its order; of N cylinders: the highest; default: 1",
    )
    for name in LETTERS:
        parser.add_argument(f"--{name}", metavar="X", help=f"a letter for the {name}: X_1, X_2, …")
    add_bank(parser)
    parser.add_argument("--through", metavar="P", help="highest power of r/l and e/l that is kept")
    parser.add_argument("--strokes", metavar="2|4", help="of N cylinders; default: 4")
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Show one order of an engine in letters, or the orders of N cylinders in a row."""
    order = whole_number(options.order, "order")
    through = None if options.through is None else whole_number(options.through, "through")
    if options.engine is None:
        for name in (*LETTERS, "bank", "through"):
            if getattr(options, name) is not None:
                raise SymbalanceError(f"--{name}", "is for one engine", "name a preset or a file")

        from symbalance.forces.row_formulas import tabulate_row

        strokes = 4 if options.strokes is None else whole_number(options.strokes, "strokes")
        show(tabulate_row(order, strokes), options)
        return 0
    if options.strokes is not None:
        raise SymbalanceError(
            "--strokes", "is for N cylinders, and an engine has its own", "leave it out"
        )

    from symbalance.design.variations import symbolic_order
    from symbalance.engine.builders import with_bank_angle
    from symbalance.engine.catalogue import load

    engine = load(options.engine)
    if options.bank is not None:
        engine = with_bank_angle(engine, bank_angle(options.bank))
    letters = {name: getattr(options, name) for name in LETTERS}
    show(symbolic_order(engine, order, through=through, **letters), options)
    return 0
