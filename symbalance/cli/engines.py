"""`symbalance engines`: the presets."""

from __future__ import annotations

import argparse

from symbalance.cli.options import add_output, command
from symbalance.cli.output import show, write
from symbalance.errors import SymbalanceError


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "engines", run, "The preset engines, with their sources.")
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--show", metavar="NAME", help="print a preset's engine file, to start your own from"
    )
    what.add_argument(
        "--schema", action="store_true", help="print the JSON Schema of engine files, for editors"
    )
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """List the presets, or print one's engine file, or the schema of all engine files."""
    from symbalance.engine.catalogue import preset_text, presets

    if options.show is None and not options.schema:
        show(presets(), options)
        return 0
    for name in ("format", "standalone"):
        if getattr(options, name):
            other = "--schema" if options.schema else "--show"
            raise SymbalanceError(f"--{name}", f"plays no part in {other}", "leave it out")
    if options.show is not None:
        write(preset_text(options.show), options.output, "source")
        return 0
    from symbalance.engine.engine_file import schema_text

    write(schema_text(), options.output, "json")
    return 0
