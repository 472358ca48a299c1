"""`symbalance engines`: the presets."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from symbalance.cli.options import add_output, command
from symbalance.cli.output import show, whole_number, write
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.engine.catalogue import Presets

SELECTING = ("cylinders", "strokes", "kind", "having", "sort", "full")


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "engines", run, "The preset engines, with their sizes and sources.")
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--show", metavar="NAME", help="print a preset's engine file, to start your own from"
    )
    what.add_argument(
        "--schema", action="store_true", help="print the JSON Schema of engine files, for editors"
    )
    parser.add_argument("--cylinders", metavar="N", help="only those of so many cylinders")
    parser.add_argument("--strokes", metavar="N", help="only those of 2 or of 4 strokes")
    parser.add_argument("--kind", metavar="WORD", help="only in-line, vee, boxer, W or radial ones")
    parser.add_argument(
        "--with",
        dest="having",
        metavar="WHAT",
        action="append",
        help="only those with all sizes, with masses or with estimates; may be repeated",
    )
    parser.add_argument(
        "--sort",
        metavar="KEY",
        help="by cylinders, bore, stroke, rod, pitch or a mass; default: name",
    )
    parser.add_argument(
        "--full", action="store_true", help="add what each is, its sources and its estimates"
    )
    add_output(parser, full=False)


def run(options: argparse.Namespace) -> int:
    """List the presets, or print one's engine file, or the schema of all engine files."""
    from symbalance.engine.catalogue import preset_text, presets

    if options.show is None and not options.schema:
        show(_selected(presets(), options), options)
        return 0
    for name in ("format", "standalone", "label", *SELECTING):
        if getattr(options, name):
            other = "--schema" if options.schema else "--show"
            option = "with" if name == "having" else name
            raise SymbalanceError(f"--{option}", f"plays no part in {other}", "leave it out")
    if options.show is not None:
        write(preset_text(options.show), options.output, "source")
        return 0
    from symbalance.engine.engine_file import schema_text

    write(schema_text(), options.output, "json")
    return 0


def _selected(presets: Presets, options: argparse.Namespace) -> Presets:
    count = None if options.cylinders is None else whole_number(options.cylinders, "cylinders")
    return presets.selected(
        cylinders=count,
        strokes=options.strokes,
        kind=options.kind,
        having=options.having or (),
        sort=options.sort,
        in_full=options.full,
    )
