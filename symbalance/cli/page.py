"""`symbalance page`: an engine in motion as one HTML file that opens from disk."""

from __future__ import annotations

import argparse

from symbalance.cli.options import add_engine, add_operating_point, command, engine_of
from symbalance.cli.output import whole_number, write
from symbalance.errors import SymbalanceError


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "page", run, "An engine in motion: one HTML file with everything in it.")
    add_engine(parser, order="12")
    add_operating_point(parser, "N")
    parser.add_argument("--lang", choices=("en", "ja"), default="en", help="its language; default: en")
    parser.add_argument("-o", "--output", metavar="FILE", help="default: NAME.html; - is the terminal")


def run(options: argparse.Namespace) -> int:
    """Make the page and write it."""
    output = options.output
    if output not in (None, "-") and not output.lower().endswith((".html", ".htm")):
        raise SymbalanceError(f"-o {output}", "must end in .html", "as -o engine.html")
    from symbalance.forces.free_forces import balance
    from symbalance.pages.moving_page import file_name, page

    engine = engine_of(options)
    result = balance(engine, whole_number(options.order, "order"))
    made = page(result, rpm=options.rpm, lang=options.lang)
    write(made.html, output or f"{file_name(engine.name)}.html", "source")
    return 0
