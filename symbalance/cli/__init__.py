"""The command line: 0 done, 1 a check or a bound failed, 2 bad input or a missing part.

Results go to stdout, progress to stderr, a refusal is one line on stderr, and a closed pipe ends
silently. Nothing here imports SymPy: a command imports what it needs when it runs.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from symbalance.cli.parser import build_parser
from symbalance.errors import SymbalanceError


def run(arguments: Sequence[str]) -> int:
    """Run one command line and return its exit code."""
    try:
        options = build_parser().parse_args(arguments)
        code = options.run(options)
        sys.stdout.flush()
        return code
    except SymbalanceError as problem:
        print(f"symbalance: {_printable(str(problem))}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        # The reader has gone: point stdout at nothing, or Python complains while it shuts down.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except KeyboardInterrupt:
        return 130


def _printable(line: str) -> str:
    """Return one line without control characters, in what stderr can encode."""
    clean = "".join(c if c.isprintable() else " " for c in line)
    encoding = sys.stderr.encoding or "ascii"
    return clean.encode(encoding, "backslashreplace").decode(encoding)
