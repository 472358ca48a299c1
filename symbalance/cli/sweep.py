"""`symbalance sweep`: forces, couples and torque of an engine on a grid of its sizes."""

from __future__ import annotations

import argparse
from fractions import Fraction
from pathlib import Path

from symbalance.cli.budget import ENDLESS
from symbalance.cli.long_work import long_work
from symbalance.cli.options import (
    ENGINE,
    add_jobs,
    add_operating_point,
    add_output,
    check_speed_for_sizes,
    command,
    engine_of,
    sizes_of,
)
from symbalance.cli.outcomes import DONE, FAILED
from symbalance.cli.output import medium, show
from symbalance.errors import SymbalanceError, brief

MOST_VALUES = 10_000


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    summary = "Forces, couples and torque of an engine on a grid of its sizes."
    parser = command(commands, "sweep", run, summary, ENDLESS)
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    parser.add_argument(
        "--vary",
        metavar="SIZE=VALUES",
        action="append",
        required=True,
        help="ratio=3:5:0.5 (from:to:step) or bank=60,75,90; several make a grid; of ratio, bank "
        "(between a vee's banks), offset, stroke, rod, pitch, reciprocating_mass, rotating_mass",
    )
    parser.add_argument(
        "--quantities",
        metavar="NAMES",
        required=True,
        help="with commas: force.N, couple.N and torque.N of order N, largest over a turn; "
        "force.N.vertical or .lateral along an axis",
    )
    parser.add_argument(
        "--keep", metavar="FOLDER", help="points are kept there, and not computed again after a break"
    )
    add_operating_point(parser, "N")
    add_jobs(parser, "points")
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Compute the grid and show it; 1 where some of its points are refused."""
    medium(options)
    vary: dict[str, list[Fraction]] = {}
    for text in options.vary:
        name, values = read_values(text)
        if name in vary:
            raise SymbalanceError(f"--vary {brief(text)}", f"names {name} again", "give each size once")
        vary[name] = values

    from symbalance.design.variations.size_sweep import sweep
    from symbalance.forces.operating_point import SIZES
    from symbalance.jobs.store import Store

    store = None if options.keep is None else Store(Path(options.keep), "--keep")
    quantities = [name.strip() for name in options.quantities.split(",")]
    check_speed_for_sizes(options)
    if options.rpm is not None and ":" in options.rpm:
        rule = "is several speeds, and a sweep is at one: all grows with its square"
        raise SymbalanceError(f"--rpm {options.rpm}", rule, "give one speed")
    for name, value in sizes_of(options).items():
        if SIZES[name] in vary:
            rule = f"is varied: --vary {SIZES[name]} gives it at every point"
            raise SymbalanceError(f"--{name} {value}", rule, "leave it out")
    engine = engine_of(options)
    with long_work(options, store and store.folder) as means:
        result = sweep(engine, vary, quantities, rpm=options.rpm, store=store, **means)
    show(result, options)
    return FAILED if result.refused else DONE


def read_values(text: str) -> tuple[str, list[Fraction]]:
    """Return the size that --vary names, and its values.

    >>> read_values("ratio=3:4:0.5")
    ('ratio', [Fraction(3, 1), Fraction(7, 2), Fraction(4, 1)])
    """
    from symbalance.text.numbers import evenly_spaced, exact

    name, equals, values = text.partition("=")
    what, remedy = f"--vary {brief(text)}", "write it like ratio=3:5:0.5 or bank=60,75,90"
    if not equals or not name.strip() or not values.strip():
        raise SymbalanceError(what, "must be a size and its values", remedy)
    name = name.strip()
    if ":" not in values:
        return name, [exact(value.strip(), name) for value in values.split(",")]
    ends = values.split(":")
    if len(ends) != 3:
        raise SymbalanceError(what, "must be from:to:step", remedy)
    first, last, step = (exact(end.strip(), name) for end in ends)
    if step <= 0 or first > last:
        raise SymbalanceError(what, "must rise by a positive step", remedy)
    limit = {"most": MOST_VALUES, "what": what, "things": "values", "remedy": "take a larger step"}
    return name, evenly_spaced(first, last, step, **limit)
