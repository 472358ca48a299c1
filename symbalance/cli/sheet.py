"""`symbalance sheet`: the handbook sheet of an engine, one A4 page as PDF, LaTeX or SVG."""

from __future__ import annotations

import argparse

from symbalance.cli.options import command
from symbalance.cli.output import whole_number, write
from symbalance.errors import SymbalanceError

ENDINGS = (".pdf", ".tex", ".svg")


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "sheet", run, "Engines on one A4 page each: drawings, orders, sizes.")
    parser.add_argument(
        "engines", metavar="ENGINE", nargs="+", help="preset, file, or - for standard input"
    )
    parser.add_argument("--order", metavar="N", default="12", help="highest order; default: 12")
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
    if ending == ".svg" and len(options.engines) > 1:
        rule = f"is one page, and {len(options.engines)} engines have one each"
        raise SymbalanceError(f"-o {output}", rule, "write .pdf or .tex, or one engine at a time")
    order = whole_number(options.order, "order")

    from symbalance.engine.catalogue import load
    from symbalance.forces.free_forces import balance
    from symbalance.pages.sheet import sheet

    drawings = [sheet(balance(load(name), order)) for name in options.engines]
    if ending == ".svg":
        from symbalance.document.svg_writer import drawing_svg

        write(drawing_svg(drawings[0], standalone=True), options.output, "source")
        return 0
    from symbalance.pages.sheet_files import sheets_latex, sheets_pdf

    if ending == ".pdf":
        write(sheets_pdf(drawings), options.output)
    else:
        write(sheets_latex(drawings), options.output, "latex")
    return 0
