"""`symbalance sheet`: the handbook sheet of an engine, or of several compared, as PDF, LaTeX or SVG."""

from __future__ import annotations

import argparse

from symbalance.cli.engine_comparison import engines_of
from symbalance.cli.options import add_operating_point, command
from symbalance.cli.output import whole_number, write
from symbalance.errors import SymbalanceError

ENDINGS = (".pdf", ".tex", ".svg")


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands,
        "sheet",
        run,
        "Engines on one A4 page each, or compared on one: drawings, orders, sizes.",
    )
    parser.add_argument(
        "engines", metavar="ENGINE", nargs="+", help="preset, file, or - for standard input"
    )
    parser.add_argument(
        "--compare", action="store_true", help="several engines: one sheet, side by side above one table"
    )
    parser.add_argument("--order", metavar="N", default="12", help="highest order; default: 12")
    parser.add_argument("--ratio", metavar="λ", help="rod ratio l/r, overrides the engines'")
    add_operating_point(parser, "N")
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help=f"{', '.join(ENDINGS)}; .pdf needs TeX; default: the LaTeX on the terminal",
    )


def run(options: argparse.Namespace) -> int:
    """Draw the sheets and write them in the form that the file's ending says."""
    output = options.output or "-"
    ending = ".tex" if output == "-" else "." + output.rpartition(".")[2].lower()
    if ending not in ENDINGS:
        raise SymbalanceError(f"-o {output}", f"must end in {', '.join(ENDINGS)}", "as -o engine.pdf")
    several = len(options.engines) > 1
    if options.compare and not several:
        raise SymbalanceError("--compare", "compares several engines", "name another, or leave it out")
    if ending == ".svg" and several and not options.compare:
        rule = f"is one page, and {len(options.engines)} engines have one each"
        raise SymbalanceError(f"-o {output}", rule, "write .pdf or .tex, or add --compare")
    order = whole_number(options.order, "order")
    engines = engines_of(options)

    from symbalance.pages.sheets import sheet

    if options.compare:
        from symbalance.design.comparison import compare

        table = compare(engines, order)
        sheets = sheet(table if options.rpm is None else table.at(rpm=options.rpm))
    else:
        from symbalance.forces.free_forces import balance

        results = [balance(engine, order) for engine in engines]
        speed = options.rpm
        sheets = sheet(*(each if speed is None else each.at(rpm=speed) for each in results))
    if ending == ".svg":
        if len(sheets.pages) > 1:
            rule = f"is one page, and this sheet has {len(sheets.pages)}"
            raise SymbalanceError(f"-o {output}", rule, "write .pdf or .tex, or a lower --order")
        write(sheets.svg(), options.output, "source")
    elif ending == ".pdf":
        write(sheets.pdf(), options.output)
    else:
        write(sheets.latex(), options.output, "latex")
    return 0
