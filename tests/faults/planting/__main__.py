"""`python -m tests.faults.planting [ROOM ...]`: the share of planted faults that tests catch."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import time
from collections.abc import Sequence

from .nearest_tests import NEAREST
from .planting import Settings, plant, report, say_at_once
from .trees import PlantingError

ALL = ("text", "document", "exact", "kinematics", "engine", "forces", "torque")
ALL += ("design", "codegen", "notes", "crankshaft", "search", "budgets", "jobs")
ALL += ("drawing", "pages", "cli")
"""The rooms that are planted when none is named: all but the bench and files of a few lines."""


def main(arguments: Sequence[str]) -> int:
    """Run the command; return 0 if all that changes a result is caught, 1 if not, 2 if nothing ran."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.faults.planting",
        description="Plant single-line faults in copies of the tree; count what the nearest tests catch.",
    )
    default = Settings()
    parser.add_argument("rooms", nargs="*", metavar="ROOM", help=f"default: {' '.join(ALL)}")
    parser.add_argument("--seed", type=int, default=default.seed, help="default: 1")
    parser.add_argument("--count", type=int, default=default.count, help="faults a room; default: 10")
    parser.add_argument(
        "--jobs", type=int, default=min(default.jobs, os.cpu_count() or 1), help="default: 2"
    )
    parser.add_argument(
        "--limit",
        type=float,
        default=default.limit,
        metavar="S",
        help="processor seconds of tests for a fault; default: 180",
    )
    options = parser.parse_args(arguments)
    unknown = sorted(set(options.rooms) - set(NEAREST))
    if unknown:
        parser.error(f"{unknown[0]}: is no room; the rooms are {', '.join(NEAREST)}")
    if options.count < 1 or options.jobs < 1:
        parser.error("--count and --jobs: give 1 or more")
    settings = Settings(options.seed, options.count, options.jobs, options.limit)
    start = time.monotonic()
    try:
        outcomes = plant(options.rooms or ALL, settings, say_at_once)
    except PlantingError as problem:
        print(f"planting: {problem}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130
    print(report(outcomes))
    print(f"seed {options.seed}, {(time.monotonic() - start) / 60:.1f} minutes")
    return 1 if any(o.changes and not o.caught for each in outcomes.values() for o in each) else 0


if __name__ == "__main__":
    # Whoever ends this ends its workers and temporary folders too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    sys.exit(main(sys.argv[1:]))
