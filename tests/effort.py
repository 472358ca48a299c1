"""Work counted in calls and returns, Python's and C's: the same on a busy machine as on an idle one."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any


def effort(work: Callable[[], Any]) -> int:
    """Return how many calls and returns `work` takes, and let through what it raises.

    >>> effort(lambda: sum(map(abs, range(100)))) > 2
    True
    """
    events, before = 0, sys.getprofile()

    def seen(*_: object) -> None:
        nonlocal events
        events += 1

    sys.setprofile(seen)
    try:
        work()
    finally:
        sys.setprofile(before)
    return events
