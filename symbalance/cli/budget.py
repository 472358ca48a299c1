"""The option --budget: the time and the memory that a command may take before it gives up."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from symbalance.budgets import MEGABYTE, Budget, OverBudgetError, process_memory, run_within
from symbalance.errors import SymbalanceError

USUAL = Budget(600, 4000)
"""Ten minutes and 4 GB: the largest engines that are taken need a tenth of that."""
ENDLESS = Budget()
"""For commands that run for hours, say how far they are and keep what is finished."""
_SECONDS = {"": 1, "s": 1, "m": 60, "h": 3600}
_MEGABYTES = {"MB": 1, "GB": 1000}
_PART = re.compile(r"([0-9]{1,9}(?:\.[0-9]{1,9})?)(s|m|h|MB|GB|)")
LEAST_MEMORY = 50
"""MB: a command's own modules take some twenty, and without room for them nothing could be said."""
SLACK = 2
"""How many times the budget of memory one allocation may reach before the system refuses it: the system
counts what is reserved too, which libraries do generously."""


def add_budget(parser: argparse.ArgumentParser, usual: Budget) -> None:
    """Add the option to a command's parser."""
    default = "none" if usual == ENDLESS else "10m,4GB"
    parser.add_argument(
        "--budget",
        metavar="B",
        default=default,
        help=f"time and memory it may take: 90s, 10m, 2h, 4GB, 10m,4GB or none; default: {default}",
    )


def read_budget(text: str) -> Budget:
    """Return the budget that an option asks for.

    >>> str(read_budget("10m,4GB")), str(read_budget("90")), str(read_budget("none"))
    ('600 s and 4000 MB', '90 s', 'no limit')
    """
    if text == "none":
        return ENDLESS
    values: dict[str, float] = {}
    for part in text.split(","):
        match = _PART.fullmatch(part.strip())
        unit = "" if match is None else match[2]
        name = "megabytes" if unit in _MEGABYTES else "seconds"
        if match is None or name in values or float(match[1]) == 0:
            remedy = "write it like --budget 90s, --budget 10m,4GB or --budget none"
            raise SymbalanceError(f"--budget {text}", "must be a time, a memory or both", remedy)
        values[name] = float(match[1]) * (_MEGABYTES | _SECONDS)[unit]
    if values.get("megabytes", LEAST_MEMORY) < LEAST_MEMORY:
        rule = f"gives less memory than the {LEAST_MEMORY} MB that a command needs to start"
        raise SymbalanceError(f"--budget {text}", rule, f"write --budget {LEAST_MEMORY}MB or more")
    return Budget(**values)


def run_with_budget(name: str, budget: Budget, work: Callable[[], int]) -> int:
    """Return a command's exit code, or refuse what takes more than its budget."""
    try:
        with _allocations_limited(budget.megabytes):
            return run_within(budget, work)
    except OverBudgetError as problem:
        rule = f"takes more than its budget of {problem.spent}"
        raise SymbalanceError(name, rule, "ask for less, or give it more with --budget") from None


@contextmanager
def _allocations_limited(megabytes: float | None) -> Iterator[None]:
    """Let the system refuse one allocation beyond the budget, which no thread could end in time."""
    try:
        import resource
    except ImportError:  # Windows has no such limit
        yield
        return
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    reserved = process_memory(reserved=True) or 0
    limit = None if megabytes is None else reserved + int(SLACK * megabytes * MEGABYTE)
    if limit is None or (soft != resource.RLIM_INFINITY and soft <= limit):
        yield
        return
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))
