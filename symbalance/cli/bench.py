"""The command `symbalance bench`: runs a topic of `symbalance.bench` and writes its report."""

from __future__ import annotations

import argparse
import os
from importlib import import_module

from symbalance.cli.budget import ENDLESS
from symbalance.cli.options import command
from symbalance.cli.output import write, write_all
from symbalance.errors import SymbalanceError


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    summary = "Measurements on this machine, against named alternatives."
    parser = command(commands, "bench", run, summary, ENDLESS)
    parser.add_argument(
        "topic",
        choices=("derive", "check", "accuracy", "stability", "crankshaft", "search", "page"),
        help="what to measure",
    )
    parser.add_argument(
        "--quick", action="store_true", help="fewer repeats, and no alternative over 10 s"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="NAME",
        help="accuracy, crankshaft: also write points to NAME.csv, pictures to NAME.png and NAME.pdf; "
        "other topics: write the table to the file NAME",
    )


def run(options: argparse.Namespace) -> int:
    """Measure a topic; progress goes to stderr, the table to stdout; 1 if a stated target is missed.

    A topic that has points and pictures beside its table names the files that go with it.
    """
    topic = import_module(f"symbalance.bench.{options.topic}")
    output = None if options.output == "-" else options.output
    has_pictures = output is not None and hasattr(topic, "check_files")
    if output is not None:
        _check_folder(output)
    if has_pictures:
        topic.check_files()
    report = topic.report(quick=options.quick)
    write(report.text(), None if has_pictures else output)
    if has_pictures:
        write_all({f"{output}{ending}": content for ending, content in report.files().items()})
    return 1 if report.missed_targets() else 0


def _check_folder(output: str) -> None:
    """Refuse a place that cannot be written to before the long run, not after it."""
    folder = os.path.dirname(os.path.realpath(output))
    if not (os.path.isdir(folder) and os.access(folder, os.W_OK)):
        raise SymbalanceError(
            f"--output {output}", "cannot be written", "name a file in a folder you may write to"
        )
