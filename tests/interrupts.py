"""Programs that hear of Ctrl-C, also where the tests run behind an & that has children ignore it."""

from __future__ import annotations

import sys

_HEARS = """import os, signal, sys
signal.signal(signal.SIGINT, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])"""


def that_hears_ctrl_c(*arguments: str) -> list[str]:
    """Return the command line of Python with these arguments that hears of an interrupt.

    Python is started twice, the second in the place of the first: what is ignored is inherited, and the
    way of `subprocess` to change it, `preexec_fn`, forks, which a library with threads warns of.
    """
    return [sys.executable, "-I", "-S", "-c", _HEARS, sys.executable, *arguments]
