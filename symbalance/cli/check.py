"""`symbalance check`: a person's derivation, judged equation by equation."""

from __future__ import annotations

import argparse
from pathlib import Path

from symbalance.cli.options import add_output, add_trust, command
from symbalance.cli.outcomes import DONE, FAILED, FAULT, say_fault
from symbalance.cli.output import show, write
from symbalance.errors import SymbalanceError


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "check", run, "A hand derivation, judged equation by equation.")
    parser.add_argument(
        "notes", metavar="NOTES", help="a .tex, .md or .txt file, left as it is; - is standard input"
    )
    parser.add_argument(
        "--symbols",
        metavar="FILE",
        help="what the letters mean, and what lines claim; default: NOTES.symbols.toml beside it",
    )
    parser.add_argument(
        "--lenient",
        action="store_true",
        help="exit 0 although something could not be read; still 1 where nothing could",
    )
    parser.add_argument(
        "--declare", action="store_true", help="print a symbols file to fill in, with the letters missing"
    )
    add_trust(parser, "the symbols file")
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Check the document and write the report; 1 if it is not to be relied on, 3 after a fault of ours.

    Not to be relied on: no relation was seen, or one is refuted, undecided or unreadable.
    """
    from symbalance.checking import check
    from symbalance.text.files import file_name

    if options.declare:
        from symbalance.notes.checking import sidecar_draft

        for name in ("format", "standalone", "lenient"):
            if getattr(options, name):
                raise SymbalanceError(f"--{name}", "plays no part in --declare", "leave it out")
        write(sidecar_draft(Path(options.notes), options.symbols), options.output, "source")
        return DONE
    checked = check(Path(options.notes), options.symbols, trust_paths=options.trust_paths)
    show(checked, options)
    for verdict in checked.faults:
        place = f"line {verdict.line} of {file_name(options.notes)}"
        say_fault(f"{place}: {verdict.fault}", verdict.traceback)
    if checked.faults:
        return FAULT
    return FAILED if checked.fails(lenient=options.lenient) else DONE
