"""The command line: runs a command and returns its exit code.

Results go to stdout, progress to stderr, a refusal is one line on stderr, and a closed pipe ends
silently. Nothing here imports SymPy: a command imports what it needs when it runs.
"""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.cli.outcomes import DONE, INTERRUPTED, ended
from symbalance.cli.output import finish
from symbalance.cli.parser import build_parser


def run(arguments: Sequence[str]) -> int:
    """Run one command line and return its exit code."""
    try:
        try:
            options = build_parser(arguments).parse_args(arguments)
            options.command_line = ("symbalance", *arguments)
            code = options.run(options)
        except SystemExit:  # --help and --version
            code = DONE
        finish()
        return code
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception as problem:
        return ended(problem)
