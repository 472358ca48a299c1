"""`symbalance bench`: measurements on this machine."""

from __future__ import annotations

import argparse
from importlib import import_module

from symbalance.cli.output import write


def run(options: argparse.Namespace) -> int:
    """Measure a topic; progress goes to stderr, the table to stdout; 1 if a stated target is missed."""
    report = import_module(f"symbalance.bench.{options.topic}").report(quick=options.quick)
    write(report.text(), None)
    return 1 if report.missed() else 0
