"""`symbalance firing`: firing orders a crank allows, cranks of even firing, bank angles, pin offsets."""

from __future__ import annotations

import argparse
from fractions import Fraction
from typing import TYPE_CHECKING

from symbalance.cli.options import ENGINE, add_output, command
from symbalance.cli.output import show, whole_number
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.document.result import Result

OF_ORDERS = ("uneven", "together", "within")
"""The options of firing orders alone."""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands, "firing", run, "Firing orders a crank allows; cranks, bank angles, pin offsets."
    )
    parser.add_argument("engine", metavar="ENGINE", nargs="?", help=f"its crank: {ENGINE}")
    parser.add_argument(
        "--throws",
        metavar="A,…",
        help="a crank of an in-line engine, degrees front to rear, as --throws 0,180,180,0",
    )
    parser.add_argument(
        "--cylinders", metavar="N", help="every crank on which so many in line fire evenly"
    )
    parser.add_argument(
        "--vee",
        metavar="β,…",
        nargs="?",
        const="",
        help="with --cylinders or --throws (of shared pins): the bank angles that fire evenly, and what "
        "pin offsets make others do so",
    )
    parser.add_argument("--strokes", metavar="2|4", help="without ENGINE: strokes of a cycle; default: 4")
    parser.add_argument("--uneven", action="store_true", help="firing orders with unequal intervals too")
    parser.add_argument("--together", action="store_true", help="cylinders may fire together")
    parser.add_argument(
        "--within", metavar="DEGREES", help="dead centres as near to an even moment count as even"
    )
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Find out what is asked about, and show it."""
    named = [name for name in ("engine", "throws", "cylinders") if getattr(options, name) is not None]
    if len(named) != 1:
        what = "symbalance firing" if not named else f"ENGINE, --{'and --'.join(named[1:])}"
        rule = "is given no crank" if not named else "are several cranks"
        raise SymbalanceError(what, rule, "give one: ENGINE, --throws 0,180,180,0 or --cylinders 6")
    if named == ["engine"]:
        for name in ("vee", "strokes"):
            if getattr(options, name) is not None:
                rule = "is for --throws or --cylinders, and an engine has its own"
                raise SymbalanceError(f"--{name}", rule, "leave it out")
    if options.vee is not None or options.cylinders is not None:
        for name in OF_ORDERS:
            if getattr(options, name) not in (None, False):
                rule = "is for the firing orders of one crank"
                raise SymbalanceError(f"--{name}", rule, "name an engine, or give --throws alone")
    show(_result(options), options)
    return 0


def _result(options: argparse.Namespace) -> Result:
    strokes = 4 if options.strokes is None else whole_number(options.strokes, "strokes")
    if options.vee is not None:
        from symbalance.engine.stars.bank_angle_table import bank_angles

        crank = (
            whole_number(options.cylinders, "cylinders")
            if options.throws is None
            else _degrees(options.throws, "throws")
        )
        return bank_angles(crank, _degrees(options.vee, "vee") if options.vee else (), strokes)
    if options.cylinders is not None:
        from symbalance.engine.stars import crank_stars

        return crank_stars(whole_number(options.cylinders, "cylinders"), strokes)

    from symbalance.engine.builders import inline
    from symbalance.engine.catalogue import load
    from symbalance.engine.stars import firing_orders

    engine = (
        load(options.engine)
        if options.throws is None
        else inline(throws=_degrees(options.throws, "throws"), strokes=strokes, name="these throws")
    )
    return firing_orders(
        engine,
        even_only=not options.uneven,
        simultaneous=options.together,
        within=0 if options.within is None else options.within,
    )


def _degrees(text: str, option: str) -> list[Fraction]:
    """Return the angles of an option, in degrees."""
    from symbalance.text.numbers import exact

    return [exact(part.strip(), f"--{option}") for part in text.split(",")]
