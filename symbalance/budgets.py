"""Budgets of time and memory, within which a piece of work ends whatever it computes.

    run_within(Budget(seconds=10), work)

returns what `work()` returns, or raises `OverBudgetError` soon after ten seconds of computing, those
that the thread itself computes where the system tells them: what comes out does not depend on what else
a machine has to do. A thread that mostly waits is ended after WAITING times as long. A watching thread
raises an exception in the thread that works; so any Python code can be ended, in any thread, without
being written for it. What runs in one call of C (a power of huge integers) is ended when that returns.

Budgets nest: the innermost that is spent ends, the work around it goes on.
"""

from __future__ import annotations

import math
import os
import threading
import time
from collections.abc import Callable
from typing import NamedTuple, TypeVar

from symbalance.errors import SymbalanceError

Value = TypeVar("Value")
MEGABYTE = 2**20
TICK = 0.02
"""Seconds between two looks at the clock and the memory; Python allocates some 50 MB in that time."""
WAITING = 10
"""Times that work may take longer by the clock on the wall than it computes."""
IDLE = 5.0
"""Seconds without work after which the watching thread ends."""
AGAIN = 0.5
"""Seconds after which work that goes on is told again to end: code in C may drop an exception."""


class Budget(NamedTuple):
    """What a piece of work may take: `seconds` of time, `megabytes` of memory; None is without end.

    The memory is what the process takes more than at the start. Where the system does not tell it, which
    Linux alone does here, it is not limited.

    >>> str(Budget(90)), str(Budget(0.5, 2000)), str(Budget())
    ('90 s', '0.5 s and 2000 MB', 'no limit')
    """

    seconds: float | None = None
    megabytes: float | None = None

    def __str__(self) -> str:
        parts = []
        if self.seconds is not None:
            parts.append(f"{self.seconds:g} s")
        if self.megabytes is not None:
            parts.append(f"{self.megabytes:g} MB")
        return " and ".join(parts) or "no limit"


class OverBudgetError(SymbalanceError):
    """A piece of work that would have taken more than its budget; `spent` says which: "2 s"."""

    def __init__(self, spent: str) -> None:
        self.spent = spent
        super().__init__("the work", f"took more than its budget of {spent}", "give it more: --budget")


class _Stop(BaseException):
    """Ends the work in its thread; no `except Exception` on the way takes it for an error of its own."""


class _Watched:
    """A piece of work under way: its thread, its limits, and what of its budget is spent."""

    def __init__(self, budget: Budget) -> None:
        self.thread = threading.get_ident()
        self.budget = budget
        self._computed = _clock_of(self.thread)
        self._start = self._computed(), time.monotonic()
        limit = budget.megabytes
        self.most_bytes = None if limit is None else (process_memory() or 0) + limit * MEGABYTE
        self.spent = ""
        self.stopped_at = 0.0
        self.is_stopping = False
        self.has_left = False

    @property
    def seconds_left(self) -> float | None:
        """What is left of its seconds; None where they have no end."""
        if self.budget.seconds is None:
            return None
        begin, begin_by_wall = self._start
        by_wall = (time.monotonic() - begin_by_wall) / WAITING
        return self.budget.seconds - max(self._computed() - begin, by_wall)

    def check(self, now: float) -> None:
        """Tell the work to end if its budget is spent; called by the watching thread."""
        left = None if self.spent or self.has_left else self.seconds_left
        if left is not None and left <= 0:
            self.spent = f"{self.budget.seconds:.3g} s"
        if not self.spent and self.most_bytes is not None and (process_memory() or 0) > self.most_bytes:
            self.spent = f"{self.budget.megabytes:g} MB"
        if self.spent and now - self.stopped_at > AGAIN:
            self.stopped_at = now
            self.is_stopping = True
            if not self.has_left:
                _raise_in(self.thread, _Stop)
            self.is_stopping = False

    def leave(self) -> None:
        """End the watching; an exception that is already on its way is raised here, not later.

        Neither side holds a lock: an exception raised from outside can come between taking a lock and
        the block that gives it back. Each side says what it does before it looks at the other. Taking
        the exception back, as Python's C interface allows, leaves CPython 3.11's interpreter looking for
        one at every step from then on, and in an endless loop under a profiler.
        """
        self.has_left = True
        while self.is_stopping:
            time.sleep(0)
        for _ in range(2):  # the end of a round is where Python raises what waits
            pass


class _Watch:
    """The watching thread and all work under way; one a process, started when there is work."""

    def __init__(self) -> None:
        self.under_way: list[_Watched] = []
        self.thread: threading.Thread | None = None

    def enter(self, work: _Watched) -> None:
        """Watch a piece of work from now on."""
        self.under_way.append(work)
        if self.thread is None:
            import ctypes  # noqa: F401  # here, while there is memory for it; not for every --help

            # A thread whose work is already watched never comes here, so nothing interrupts the start.
            self.thread = threading.Thread(target=self._run, name="symbalance budgets", daemon=True)
            self.thread.start()

    def seconds_left(self) -> float | None:
        """Return what is left of the budgets around this thread's work; None where they have no end."""
        own = threading.get_ident()
        own_work = [w for w in list(self.under_way) if w.thread == own and not w.has_left]
        return min((left for w in own_work if (left := w.seconds_left) is not None), default=None)

    def _run(self) -> None:
        last_work = time.monotonic()
        while self.thread is threading.current_thread():
            time.sleep(TICK)
            now = time.monotonic()
            for work in [work for work in self.under_way if work.has_left]:
                self.under_way.remove(work)
            for work in list(self.under_way):
                work.check(now)
                last_work = now
            if now - last_work > IDLE:
                self.thread = None
                if self.under_way:  # came while this was on its way out
                    self.enter(self.under_way.pop())


_watch = _Watch()


def _renew() -> None:
    """Forget the watching thread in a forked process, which has none."""
    global _watch  # noqa: PLW0603
    _watch = _Watch()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew)


def run_within(budget: Budget, work: Callable[[], Value], share: float | None = None) -> Value:
    """Return what `work()` returns, or raise OverBudgetError soon after its budget is spent.

    With a `share` it ends after that part of what is left of the budget around it, whose rest is for the
    work around it; its own seconds count where there is none around. So who gives a page more time gives
    its searches more, and what they find does not depend on what else the machine has to do.

    >>> run_within(Budget(60), lambda: 6 * 7)
    42
    >>> run_within(Budget(0.01), lambda: [None for _ in iter(int, 1)])
    Traceback (most recent call last):
    symbalance.budgets.OverBudgetError: the work: took more than its budget of 0.01 s; ...
    """
    left = None if share is None else _watch.seconds_left()
    if share is not None and left is not None:
        budget = budget._replace(seconds=max(share * left, 0.001))
    if budget.seconds is None and budget.megabytes is None:
        return work()
    watched = _Watched(budget)
    try:
        try:
            _watch.enter(watched)
            return work()
        finally:
            watched.leave()
    except _Stop:
        watched.leave()  # it may have come before the line above was through
        if not watched.spent:  # meant for the work around this
            raise
    raise OverBudgetError(watched.spent)


def _clock_of(thread: int) -> Callable[[], float]:
    """Return what tells the seconds that a thread has computed; the clock on the wall if nothing does."""
    try:
        clock = time.pthread_getcpuclockid(thread)
    except (AttributeError, OSError):  # Windows, macOS
        return time.monotonic

    def computed() -> float:
        try:
            return time.clock_gettime(clock)
        except OSError:  # the thread has ended
            return math.inf

    return computed


def _raise_in(thread: int, exception: type[BaseException]) -> None:
    """Raise an exception in a thread at its next step."""
    import ctypes

    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(exception))


def process_memory(*, reserved: bool = False) -> int | None:
    """Return the memory this process takes, or has `reserved`, in bytes; None where nobody tells."""
    try:
        with open("/proc/self/statm", "rb") as stream:
            return int(stream.read().split()[0 if reserved else 1]) * _PAGE
    except (OSError, ValueError, IndexError):  # no Linux: `Budget` says that memory has no limit there
        return None


_PAGE = os.sysconf("SC_PAGE_SIZE") if hasattr(os, "sysconf") else 4096
