"""A search in parts: the same answer in any split, with a killed worker, after a break; nothing twice."""

from __future__ import annotations

import os
import signal
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from symbalance.jobs import Job, Progress, Store, process_pool, run_jobs
from symbalance.search import cranks_search, search_cranks, subtrees

QUESTION: dict[str, Any] = {
    "cylinders": 8,
    "strokes": 2,
    "minimize": ["couple.1", "couple.2"],
    "limit": ["couple.3<=9"],
    "compiled": False,
}


@pytest.fixture
def in_parts(monkeypatch) -> None:
    """Cut small questions too."""
    monkeypatch.setattr(subtrees, "SMALL", 10)


def whole() -> dict[str, Any]:
    return without_parts(search_cranks(**QUESTION))


def without_parts(result) -> dict[str, Any]:
    data = result.data()
    # Each part begins with the nodes of its first pins.
    del data["walk"]
    return data


def test_parts_make_the_whole(monkeypatch) -> None:
    expected = whole()
    monkeypatch.setattr(subtrees, "SMALL", 10)
    for most in (8, 100, 2000):
        monkeypatch.setattr(subtrees, "MOST_PARTS", most)
        result = search_cranks(**QUESTION)
        assert result.parts > 1
        assert without_parts(result) == expected


def die_once(value: Any) -> Any:
    """Search a part, but kill the worker at the third one, once."""
    folder, part = value
    mark = Path(folder) / "killed"
    if part.prefix[-1] == 3 and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return subtrees.search_part(part)


@pytest.mark.slow
def test_two_processes_of_which_one_is_killed(tmp_path, monkeypatch, in_parts) -> None:
    expected = search_cranks(**QUESTION)

    def with_a_death(work: Any, jobs: list[Job], **means: Any) -> Any:
        assert work is subtrees.search_part
        marked = [Job(job.name, (str(tmp_path), job.value)) for job in jobs]
        outcomes = run_jobs(die_once, marked, workers=2)
        for job, (_, outcome) in zip(jobs, outcomes, strict=True):
            yield job, outcome

    monkeypatch.setattr(cranks_search, "run_jobs", with_a_death)
    result = search_cranks(**QUESTION)
    assert (tmp_path / "killed").exists()
    assert result.data() == expected.data()


@pytest.mark.slow
def test_a_pool_and_threads_give_the_same(in_parts) -> None:
    expected = search_cranks(**QUESTION).data()
    with process_pool(2) as pool:
        assert search_cranks(**QUESTION, executor=pool).data() == expected
    with ThreadPoolExecutor(1) as threads:
        assert search_cranks(**QUESTION, executor=threads).data() == expected


@pytest.mark.slow
def test_after_a_break_only_the_rest_is_searched(tmp_path, monkeypatch, in_parts) -> None:
    expected = search_cranks(**QUESTION).data()
    finished: list[subtrees.SearchPart] = []

    def interrupted(part: subtrees.SearchPart) -> Any:
        if len(finished) == 9:
            raise KeyboardInterrupt
        finished.append(part)
        return subtrees.search_part(part)

    with monkeypatch.context() as patched:
        patched.setattr(cranks_search, "search_part", interrupted)
        with pytest.raises(KeyboardInterrupt):
            search_cranks(**QUESTION, store=Store(tmp_path))
    progress = Progress()
    again = search_cranks(**QUESTION, store=tmp_path, progress=progress)
    assert again.data() == expected
    assert progress.saved == 9
    assert progress.computed == again.parts - 9
    other = Progress()
    search_cranks(**{**QUESTION, "limit": ["couple.3<=8"]}, store=tmp_path, progress=other)
    assert other.saved == 0
