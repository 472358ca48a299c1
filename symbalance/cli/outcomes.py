"""Exit codes of commands, and the one line on stderr that says why a command failed."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from pathlib import Path

from symbalance.errors import JobFaultError, SymbalanceError, fault_of, printable

DONE = 0
FAILED = 1
"""A check or a bound failed, or a result is not to be relied on."""
REFUSED = 2
"""Bad input, a missing part, or a file that cannot be written."""
FAULT = 3
"""A fault of symbalance."""
INTERRUPTED = 130
"""As a shell counts what Ctrl-C ends."""

TRACEBACK = "SYMBALANCE_TRACEBACK"
_HOME = Path(__file__).parent.parent


def say(line: str) -> None:
    """Print one line on stderr; where that is closed or full, the exit code has to speak alone."""
    clean = printable(line)
    with suppress(OSError, ValueError, AttributeError):
        encoding = sys.stderr.encoding or "ascii"
        print(clean.encode(encoding, "backslashreplace").decode(encoding), file=sys.stderr, flush=True)


def say_fault(what: str, traceback: str) -> None:
    """Print the line for a fault of symbalance, and before it the traceback where that is wanted."""
    remedy = f"({TRACEBACK}=1 shows the traceback)"
    if os.environ.get(TRACEBACK):
        with suppress(OSError, ValueError, AttributeError):
            sys.stderr.write(traceback)
        remedy = "and with the traceback above"
    say(
        f"symbalance: a fault of symbalance, not of the input: {what}; "
        f"please report it with the command and its input {remedy}"
    )


def ended(problem: BaseException) -> int:
    """Say why a command could not be run to its end, and return its exit code."""
    if isinstance(problem, SymbalanceError):
        say(f"symbalance: {problem}")
        return REFUSED
    if isinstance(problem, MemoryError):
        say("symbalance: memory: is not enough for this; ask for fewer orders, or give a smaller input")
        return REFUSED
    if isinstance(problem, OSError) and not _is_own(problem):
        where = problem.filename or "a file, a pipe or a process"
        say(f"symbalance: {where}: cannot be used ({problem.strerror or problem}); see to it, run again")
        return REFUSED
    if isinstance(problem, JobFaultError):
        say_fault(problem.fault, problem.traceback)
        return FAULT
    from traceback import format_exception

    say_fault(fault_of(problem), "".join(format_exception(problem)))
    return FAULT


def _is_own(problem: OSError) -> bool:
    """Tell whether a file of the package itself is missing, which no user can see to."""
    return isinstance(problem.filename, str) and _HOME in Path(problem.filename).parents
