"""`symbalance page`: an engine in motion as one HTML file that opens from disk."""

from __future__ import annotations

import argparse
from typing import Any

from symbalance.cli.options import add_engine, add_running, command, engine_of
from symbalance.cli.output import whole_number, write
from symbalance.errors import SymbalanceError


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "page", run, "An engine in motion: one HTML file with everything in it.")
    add_engine(parser, order="12")
    add_running(parser, pitch=True)
    parser.add_argument("--delta", metavar="δ", help="a flywheel's speed fluctuation; default: 0.02")
    parser.add_argument("--lang", choices=("en", "ja"), default="en", help="its language; default: en")
    parser.add_argument("-o", "--output", metavar="FILE", help="default: NAME.html; - is the terminal")


def run(options: argparse.Namespace) -> int:
    """Make the page and write it; with a pressure it shows gas torque and the whole torque too."""
    output = options.output
    if output not in (None, "-") and not output.lower().endswith((".html", ".htm")):
        raise SymbalanceError(f"-o {output}", "must end in .html", "as -o engine.html")
    from symbalance.cli.torque import FOR_RUNNING, running_engine
    from symbalance.forces.free_forces import balance
    from symbalance.pages.moving_page import file_name, page
    from symbalance.torque.flywheel import checked_delta

    engine = engine_of(options)
    result = balance(engine, whole_number(options.order, "order"))
    delta = None if options.delta is None else checked_delta(options.delta, "--delta")
    printed: dict[str, Any] = {} if delta is None else {"delta": delta}
    running = running_engine(options, engine, **printed)
    if options.delta is not None and running is None:
        raise SymbalanceError("--delta", *FOR_RUNNING)
    made = page(result, rpm=options.rpm, lang=options.lang, running=running)
    write(made.html, output or f"{file_name(engine.name)}.html", "source")
    return 0
