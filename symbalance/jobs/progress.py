"""Progress of long work: how much is done, how long the rest may take; a bar or lines now and then.

An estimate comes from the jobs computed now, never from those read back from a store, whose time is
nothing; before the first of them there is none.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, TextIO

from symbalance.errors import printable

SECONDS = 5.0
"""Between two lines of a log; the first and the last always stand."""
Clock = Callable[[], float]


class Progress:
    """What is done of some work; this one is silent, and counts for those that are not."""

    def __init__(self, clock: Clock = time.monotonic) -> None:
        self._clock = clock
        self._began = clock()
        self.total = self.saved = self.computed = 0
        self._weight = self._weight_computed = self._weight_saved = 0.0
        self._first: tuple[float, float] | None = None
        self.side_by_side = 1
        """How many jobs run at once: the first of each bears the start of its process."""

    @property
    def finished(self) -> int:
        """The jobs done, those from before among them."""
        return self.saved + self.computed

    def start(self, weights: Sequence[float], saved: Sequence[float] = ()) -> None:
        """Begin with jobs of these weights: what they are expected to cost, in any unit.

        Those of the weights `saved` are done: they were read back from a store.
        """
        self.total, self._weight = len(weights), sum(weights)
        self.saved, self.computed = len(saved), 0
        self._weight_computed, self._weight_saved, self._first = 0.0, sum(saved), None
        self._began = self._clock()
        if saved:
            self.show()

    def advance(self, weight: float = 1.0) -> None:
        """Count a job as done."""
        self.computed += 1
        self._weight_computed += weight
        if self._first is None and self.computed >= self.side_by_side > 1:
            self._first = self._clock(), self._weight_computed
        self.show()

    def seconds_left(self) -> float | None:
        """Return how long the rest may take, None before enough jobs have been computed.

        Several side by side are timed from when each worker has had its first job, which bears the start
        of its process, and once as many have followed.
        """
        since, before = self._first or (self._began, 0.0)
        computed = self._weight_computed - before
        if computed <= 0 or (self.side_by_side > 1 and self.computed < 2 * self.side_by_side):
            return None
        left = self._weight - self._weight_saved - self._weight_computed
        return max(left, 0.0) * (self._clock() - since) / computed

    def line(self) -> str:
        """Return the progress in words."""
        before = f" ({self.saved} from before)" if self.saved else ""
        left = self.seconds_left() if self.finished < self.total else None
        return f"{self.finished} of {self.total} done{before}" + (
            "" if left is None else f", about {duration(left)} left"
        )

    def show(self) -> None:
        """Show where the work stands, if it is time to."""

    def say(self, line: str) -> None:
        """Say something beside the progress."""

    def close(self) -> None:
        """Show the end."""


class LogProgress(Progress):
    """Progress in lines, for a log: the first, the last, and at most one every few seconds.

    Of a single job nothing is said: who waits for it knows that it is not done.
    """

    def __init__(self, stream: TextIO | None = None, clock: Clock = time.monotonic) -> None:
        super().__init__(clock)
        self._stream = stream
        self._said: float | None = None
        self._last = ""

    def show(self) -> None:
        """Print a line, if none was printed for a while."""
        now = self._clock()
        if self.total > 1 and (self._said is None or now - self._said >= SECONDS):
            self._print_line(now)

    def say(self, line: str) -> None:
        """Print a line of its own."""
        print(printable(line), file=self._stream or sys.stderr, flush=True)

    def close(self) -> None:
        """Print the last line, unless it is the one printed before."""
        if self.total > 1:
            self._print_line(self._clock())

    def _print_line(self, now: float) -> None:
        line = self.line()
        if line != self._last:
            self._said, self._last = now, line
            self.say(line)


class BarProgress(Progress):
    """Progress as a bar on a terminal, by tqdm; the estimate is ours, which counts no saved jobs."""

    def __init__(self, tqdm: Any, stream: TextIO | None = None, clock: Clock = time.monotonic) -> None:
        super().__init__(clock)
        self._tqdm, self._stream = tqdm, stream
        self._bar: Any = None

    def show(self) -> None:
        """Draw the bar anew."""
        if self.total <= 1:
            return
        if self._bar is None:
            form = "{percentage:3.0f}% |{bar}| {desc}"
            stream = self._stream or sys.stderr
            self._bar = self._tqdm(total=self.total, bar_format=form, file=stream, dynamic_ncols=True)
        self._bar.set_description_str(self.line(), refresh=False)
        self._bar.update(self.finished - self._bar.n)

    def say(self, line: str) -> None:
        """Print a line above the bar."""
        self._tqdm.write(printable(line), file=self._stream or sys.stderr)

    def close(self) -> None:
        """Leave the bar as it stands, and go to the next line."""
        if self._bar is not None:
            self._bar.refresh()
            self._bar.close()
            self._bar = None


def duration(seconds: float) -> str:
    """Return a time as one says it when it is not exact.

    >>> duration(3.2), duration(50), duration(250), duration(9000)
    ('5 s', '50 s', '4 min', '2.5 h')
    """
    if seconds < 57.5:
        return f"{max(5, 5 * round(seconds / 5))} s"
    if seconds < 90 * 60:
        return f"{round(seconds / 60)} min"
    return f"{seconds / 3600:.1f} h"


def terminal_progress() -> Progress:
    """Return the progress for stderr: a bar on a terminal where tqdm is installed, else lines."""
    try:
        on_terminal = sys.stderr.isatty()
    except (AttributeError, ValueError):
        on_terminal = False
    if on_terminal:
        try:
            from tqdm import tqdm
        except ImportError:  # a nicety: lines say the same
            return LogProgress()
        return BarProgress(tqdm)
    return LogProgress()
