"""Several engines of `symbalance balance` in one table, a line each."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from symbalance.cli.options import check_speed_for_sizes, resized, sizes_of
from symbalance.cli.output import MEDIA, show
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.engine.engine import Engine

OWN = ("percent", "phases")
"""The options of a comparison alone."""


def add_comparison(parser: argparse.ArgumentParser) -> None:
    """Add the options of a comparison."""
    parser.add_argument(
        "--percent",
        action="store_true",
        help="several engines: in per cent of one piston's first order, not in each order's own unit",
    )
    parser.add_argument(
        "--phases", action="store_true", help="several engines: every order as a cosine too"
    )


def is_comparison(options: argparse.Namespace) -> bool:
    """Tell whether several engines go into one table: -o names no folder."""
    if len(options.engines) == 1:
        return False
    output = options.output
    if output in (None, "-"):
        return True
    endings = tuple(end for ends in MEDIA.values() for end in ends)
    return output.lower().endswith(endings) and not Path(output).is_dir()


def refuse_comparison_options(options: argparse.Namespace) -> None:
    """Refuse the options of a comparison where there is none."""
    for name in OWN:
        if getattr(options, name):
            remedy = "name several engines, without -o FOLDER"
            raise SymbalanceError(f"--{name}", "is for a table of several engines", remedy)


def refuse_bank(options: argparse.Namespace) -> None:
    """Refuse a bank angle for several engines."""
    if options.bank is not None:
        raise SymbalanceError("--bank", "is for one engine", "name one, or write the angle into a file")


def show_comparison(options: argparse.Namespace, order: int) -> None:
    """Load the engines and show them side by side."""
    refuse_bank(options)
    if options.power is not None:
        rule = "is of printed series, and a table of several engines has none"
        raise SymbalanceError("--power", rule, "leave it out, or add -o FOLDER/")
    if options.dask is not None or options.jobs != "1":
        name = "--jobs" if options.dask is None else "--dask"
        rule = "shares engines with files of their own, and this is one table"
        raise SymbalanceError(name, rule, "leave it out, or add -o FOLDER/")
    if options.rpm is not None and ":" in options.rpm:
        for name in OWN:
            if getattr(options, name):
                rule = "is for a table at one speed, and over several it is in newtons alone"
                raise SymbalanceError(f"--{name}", rule, "leave it out, or give one speed")
    engines = engines_of(options)
    from symbalance.design.comparison import compare

    own = {name: getattr(options, name) for name in OWN}
    table = compare(engines, order, **own)
    if options.rpm is None:
        show(table, options)
        return

    from symbalance.design.comparison_over_speeds import compare_over_speeds
    from symbalance.forces.operating_point import checked_speeds

    speeds = checked_speeds(options.rpm)
    first, *further = speeds
    show(compare_over_speeds(table, speeds) if further else table.at(rpm=first), options)


def engines_of(options: argparse.Namespace) -> list[Engine]:
    """Return the engines that a command names, each with the sizes of its options that it lacks."""
    check_speed_for_sizes(options)
    if "-" in options.engines and len(options.engines) > 1:
        raise SymbalanceError("ENGINE '-'", "is standard input, among several", "name a file")

    from symbalance.design.comparison import lacking_sizes
    from symbalance.engine.catalogue import load

    sizes = sizes_of(options)
    engines = []
    taken: set[str] = set()
    for name in options.engines:
        engine = load(name)
        lacking = lacking_sizes(engine, sizes)
        taken |= set(lacking)
        try:
            engines.append(resized(engine, options, lacking))
        except SymbalanceError as problem:
            raise problem.within(engine.name) from None
    unused = sorted(set(sizes) - taken)
    if unused:
        rule = "is given by every one of these engines already"
        raise SymbalanceError(
            f"--{unused[0]} {sizes[unused[0]]}", rule, "leave it out, or change the files"
        )
    return engines
