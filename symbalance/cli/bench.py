"""`symbalance bench`: measurements on this machine."""

from __future__ import annotations

import argparse
from importlib import import_module

from symbalance.cli.output import write


def run(options: argparse.Namespace) -> int:
    """Measure a topic; progress goes to stderr, the table to stdout."""
    bench = import_module(f"symbalance.bench.{options.topic}")
    write(bench.report(quick=options.quick), None)
    return 0
