"""Progress and its estimate, by a clock that the test turns."""

from __future__ import annotations

import io

from symbalance.jobs import LogProgress, Progress
from symbalance.jobs.progress import BarProgress, duration


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


def test_there_is_no_estimate_before_a_job_is_computed_and_saved_ones_do_not_count():
    clock = Clock()
    progress = Progress(clock)
    progress.start([1.0] * 10, [1.0] * 4)
    assert progress.seconds_left() is None
    assert progress.line() == "4 of 10 done (4 from before)"
    clock.now = 60.0
    progress.advance()
    # One in a minute, five to go: not five jobs of ten in a minute.
    assert progress.seconds_left() == 300.0
    assert progress.line() == "5 of 10 done (4 from before), about 5 min left"


def test_weights_count_in_the_estimate():
    clock = Clock()
    progress = Progress(clock)
    progress.start([1.0, 3.0, 6.0, 2.0], [2.0])
    clock.now = 10.0
    progress.advance(1.0)
    assert progress.seconds_left() == 90.0
    clock.now = 40.0
    progress.advance(3.0)
    assert progress.seconds_left() == 60.0


def test_a_log_has_the_first_the_last_and_few_between():
    clock, stream = Clock(), io.StringIO()
    progress = LogProgress(stream, clock)
    progress.start([1.0] * 100)
    for _ in range(100):
        clock.now += 0.5
        progress.advance()
    progress.close()
    progress.close()
    lines = stream.getvalue().splitlines()
    assert lines[0] == "1 of 100 done, about 50 s left"
    assert lines[-1] == "100 of 100 done"
    assert len(lines) == 11


def test_a_single_job_needs_no_count_and_a_line_is_one_line():
    stream = io.StringIO()
    progress = LogProgress(stream, Clock())
    progress.start([1.0])
    progress.advance()
    progress.say("two\nlines\x1b[31m")
    progress.close()
    assert stream.getvalue() == "two lines\\x1b[31m\n"


def test_a_bar_says_the_same_words():
    from tqdm import tqdm

    clock, stream = Clock(), io.StringIO()
    progress = BarProgress(tqdm, stream, clock)
    progress.start([1.0] * 4, [1.0])
    clock.now = 60.0
    progress.advance()
    progress.say("a line above")
    progress.close()
    drawn = stream.getvalue()
    assert "2 of 4 done (1 from before), about 2 min left" in drawn
    assert "50%" in drawn
    assert "a line above" in drawn


def test_times_are_rounded_as_one_says_them():
    assert [duration(s) for s in (0, 57.4, 57.5, 89 * 60, 91 * 60)] == [
        "5 s",
        "55 s",
        "1 min",
        "89 min",
        "1.5 h",
    ]
