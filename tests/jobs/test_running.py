"""Jobs whose workers are killed, refused or at fault: nothing lost, nothing counted twice."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pytest

from symbalance.errors import JobFaultError, SymbalanceError
from symbalance.jobs import Job, LogProgress, Progress, Store, key_of, note, process_pool, run_jobs
from tests import ROOT
from tests.effort import effort
from tests.jobs.work import jobs, marks, square

SQUARES = [n * n for n in range(12)]
AFTER_GMSH = """
import os
from threading import Thread
from symbalance.crankshaft.solid.meshing import gmsh_session

def meshes():
    with gmsh_session():
        pass

if {threaded}:
    meshing = Thread(target=meshes)
    meshing.start()
    meshing.join()
else:
    meshes()
reading, writing = os.pipe()
os.close(reading)
try:
    os.write(writing, b"x")
except BrokenPipeError:
    print("told")
"""


def values(outcomes) -> list[int]:
    return [outcome.result(job.name) for job, outcome in outcomes]


def test_one_worker_is_this_process_and_starts_no_other(tmp_path):
    def here(_: object) -> int:
        return os.getpid()

    assert values(run_jobs(here, [Job("a", 1), Job("b", 2)])) == [os.getpid()] * 2


def test_outcomes_come_in_the_order_of_the_jobs():
    """Of threads the first ends last; still it is the first that comes."""

    def wait(seconds: float) -> float:
        time.sleep(seconds)
        return seconds

    listed = [Job(str(s), s) for s in (0.1, 0.05, 0.0)]
    with ThreadPoolExecutor(3) as pool:
        assert values(run_jobs(wait, listed, executor=pool)) == [0.1, 0.05, 0.0]


def test_a_refusal_and_a_fault_belong_to_their_jobs(tmp_path):
    listed = jobs(tmp_path, 5, 0, {1: "refused", 3: "fault"})
    outcomes = [outcome for _, outcome in run_jobs(square, listed)]
    assert [outcome.is_done for outcome in outcomes] == [True, False, True, False, True]
    assert str(outcomes[1].problem) == "number 1: number = 1: is refused; take another"
    assert outcomes[3].fault.startswith("ZeroDivisionError")
    assert "ZeroDivisionError" in outcomes[3].traceback
    with pytest.raises(SymbalanceError, match="number 1"):
        outcomes[1].result()
    with pytest.raises(JobFaultError, match="number 3: ZeroDivisionError"):
        outcomes[3].result("number 3")


def test_a_refusal_or_a_fault_is_not_kept(tmp_path):
    listed = jobs(tmp_path, 3, 0, {1: "refused", 2: "fault"})
    for _ in range(2):
        list(run_jobs(square, listed, store=Store(tmp_path / "store")))
    assert [len(marks(tmp_path, "begun", n)) for n in range(3)] == [1, 2, 2]


def test_what_a_store_has_is_not_done_again(tmp_path):
    store, progress = Store(tmp_path / "store"), Progress()
    assert values(run_jobs(square, jobs(tmp_path, 3, 0), store=store)) == SQUARES[:3]
    assert values(run_jobs(square, jobs(tmp_path, 5, 0), store=store, progress=progress)) == SQUARES[:5]
    assert len(marks(tmp_path, "begun")) == 5
    assert (progress.total, progress.saved, progress.computed) == (5, 3, 2)


def test_a_changed_key_is_done_again(tmp_path):
    store = Store(tmp_path / "store")
    for content in ("a", "b"):
        job = Job("one", (str(tmp_path), 1, 0, ""), key_of(content), "one")
        assert values(run_jobs(square, [job], store=store)) == [1]
    assert len(marks(tmp_path, "begun")) == 2
    assert [path.name for path in store.folder.iterdir()] == ["one.result"]


def test_a_note_is_said_at_once_here_and_nowhere_outside_a_job(capsys, tmp_path):
    note("outside")
    list(run_jobs(square, jobs(tmp_path, 2, 0), progress=LogProgress()))
    assert capsys.readouterr().err.splitlines() == [
        "squared 0",
        "1 of 2 done, about 5 s left",
        "squared 1",
        "2 of 2 done",
    ]


def test_running_here_costs_little_beside_the_work():
    """Calls a job, more or less: the room is no reason to write the loop by hand."""
    few, many = ([Job(str(n), n) for n in range(count)] for count in (10, 110))
    cost = effort(lambda: list(run_jobs(abs, many))) - effort(lambda: list(run_jobs(abs, few)))
    assert cost / 100 < 60


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"workers": 0}, "workers = 0"),
        ({"workers": 1.5}, "workers = 1.5"),
        ({"attempts": 0}, "attempts = 0"),
        ({"executor": 3}, "executor of type int: is no executor"),
    ],
)
def test_what_is_no_way_of_running_is_refused_before_anything_runs(options, said):
    with pytest.raises(SymbalanceError, match=said):
        run_jobs(abs, [Job("a", 1)], **options)


def test_an_executor_of_the_caller_that_breaks_is_not_waited_for(tmp_path):
    store = Store(tmp_path / "store")
    with pytest.raises(SymbalanceError, match=r"has lost a worker.* are finished; they are kept in"):
        list(run_jobs(square, jobs(tmp_path, 2, 0), executor=_Broken(), store=store))


class _Broken(ThreadPoolExecutor):
    def submit(self, *_, **__):
        from concurrent.futures.process import BrokenProcessPool

        raise BrokenProcessPool("as after a kill")


# With processes, each a second or two to start


@pytest.mark.slow
def test_processes_give_what_one_gives(tmp_path):
    assert values(run_jobs(square, jobs(tmp_path, 12, 0.01), workers=3)) == SQUARES
    pids = {path.name.rsplit("-", 1)[1] for path in marks(tmp_path, "ended")}
    assert str(os.getpid()) not in pids
    assert len(marks(tmp_path, "begun")) == len(marks(tmp_path, "ended")) == 12


@pytest.mark.slow
def test_a_worker_killed_midway_costs_nothing(tmp_path):
    listed = jobs(tmp_path, 8, 0.1, {3: "dies once"})
    store, progress = Store(tmp_path / "store"), Progress()
    assert values(run_jobs(square, listed, workers=2, store=store, progress=progress)) == SQUARES[:8]
    assert [len(marks(tmp_path, "ended", n)) >= 1 for n in range(8)] == [True] * 8
    assert len(marks(tmp_path, "begun", 3)) == 2
    assert (progress.computed, len(list(store.folder.iterdir()))) == (8, 8)
    # Only what ran beside the killed one may have been done twice.
    assert sum(len(marks(tmp_path, "ended", n)) for n in range(8)) <= 9


@pytest.mark.slow
def test_a_job_that_always_kills_its_worker_is_named_and_the_rest_is_finished(tmp_path):
    listed = jobs(tmp_path, 7, 0.1, {2: "dies", 5: "refused"})
    outcomes = [outcome for _, outcome in run_jobs(square, listed, workers=2)]
    assert [o.value for o in outcomes] == [0, 1, None, 9, 16, None, 36]
    assert str(outcomes[2].problem).startswith("number 2: the job: its process was killed 3 times")
    assert len(marks(tmp_path, "begun", 2)) == 3
    assert str(outcomes[5].problem).startswith("number 5: number = 5")


@pytest.mark.slow
def test_several_deadly_jobs_take_nobody_with_them(tmp_path):
    listed = jobs(tmp_path, 6, 0.05, {0: "dies", 1: "dies"})
    outcomes = [outcome for _, outcome in run_jobs(square, listed, workers=3, attempts=2)]
    assert [o.value for o in outcomes] == [None, None, 4, 9, 16, 25]
    # One that was handed over when the other's end broke the pool may not have begun that time.
    assert all(1 <= len(marks(tmp_path, "begun", n)) <= 2 for n in (0, 1))


@pytest.mark.slow
def test_no_worker_outlives_a_parent_that_is_killed(tmp_path):
    """A pool's workers wait at a pipe whose other end they hold themselves: nobody would tell them."""
    parent = _parent(tmp_path, 40, 0.5)
    _until(lambda: len(marks(tmp_path, "begun")) >= 2)
    pids = {int(path.name.rsplit("-", 1)[1]) for path in marks(tmp_path, "begun")}
    parent.kill()
    parent.communicate()
    _until(lambda: not any(_is_alive(pid) for pid in pids))


@pytest.mark.slow
def test_no_worker_outlives_an_iteration_that_is_broken_off(tmp_path):
    outcomes = run_jobs(square, jobs(tmp_path, 20, 0.2), workers=2)
    next(outcomes)
    outcomes.close()
    pids = {int(path.name.rsplit("-", 1)[1]) for path in marks(tmp_path, "begun")}
    _until(lambda: not any(_is_alive(pid) for pid in pids))
    assert len(marks(tmp_path, "begun")) < 20


@pytest.mark.slow
def test_a_pool_of_the_callers_stays_open(tmp_path):
    with process_pool(2) as pool:
        assert values(run_jobs(square, jobs(tmp_path, 3, 0), executor=pool)) == SQUARES[:3]
        assert pool.submit(abs, -3).result() == 3


@pytest.mark.slow
def test_a_pool_of_the_callers_that_loses_a_worker_is_said_to(tmp_path):
    listed = jobs(tmp_path, 4, 0.1, {1: "dies"})
    with (
        ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool,
        pytest.raises(SymbalanceError, match="has lost a worker, and takes no more jobs"),
    ):
        list(run_jobs(square, listed, executor=pool))


SCRIPT = """
import sys
from pathlib import Path
from symbalance.jobs import Store, run_jobs
from tests.jobs.work import jobs, square

if __name__ == "__main__":
    folder, count, seconds = Path(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
    store = Store(folder / "store")
    outcomes = run_jobs(square, jobs(folder, count, seconds), workers=2, store=store)
    print(*(outcome.result() for _, outcome in outcomes), flush=True)
"""


def _parent(folder: Path, count: int, seconds: float) -> subprocess.Popen[str]:
    script = folder / "script.py"
    script.write_text(SCRIPT, encoding="utf-8")
    command = [sys.executable, str(script), str(folder), str(count), str(seconds)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment, cwd=folder)


def _until(is_so, seconds: float = 30) -> None:
    end = time.monotonic() + seconds
    while not is_so():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def _is_alive(pid: int) -> bool:
    try:
        state = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(") ")[2][0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state != "Z"


@pytest.mark.rare
def test_twenty_kills_of_the_parent_lose_nothing_that_was_finished(tmp_path):
    """Killed at moments spread over its run, begun again, until a run is let end."""
    count, kept = 60, 0
    for kill in range(20):
        parent = _parent(tmp_path, count, 0.1)
        before = len(marks(tmp_path, "begun"))
        _until(lambda before=before: len(marks(tmp_path, "begun")) > before)
        time.sleep(0.013 * kill)
        parent.kill()
        parent.communicate()
        stored = len([*(tmp_path / "store").glob("*.result")])
        assert stored >= kept
        kept = stored
    assert 5 < kept < count
    last = _parent(tmp_path, count, 0.1)
    assert last.communicate(timeout=120)[0].split() == [str(n * n) for n in range(count)]
    assert len([*(tmp_path / "store").glob("*.result")]) == count
    # What was put into the store was never begun again: at a kill only what ran then was lost.
    assert len(marks(tmp_path, "begun")) <= count + 20 * 4


@pytest.mark.slow
def test_two_runs_on_one_store_do_each_other_no_harm(tmp_path):
    pair = [_parent(tmp_path, 30, 0.05) for _ in range(2)]
    expected = [str(n * n) for n in range(30)]
    for parent in pair:
        assert parent.communicate(timeout=120)[0].split() == expected
    store = Store(tmp_path / "store")
    assert all(store.load(job.key).payload is not None for job in jobs(tmp_path, 30))


@pytest.mark.slow
@pytest.mark.skipif(importlib.util.find_spec("gmsh") is None, reason="gmsh is optional")
@pytest.mark.parametrize("threaded", [False, True])
def test_a_broken_pipe_is_an_exception_after_meshing_too(threaded):
    """The mesher makes SIGPIPE deadly; then a killed worker took the process of its pool with it."""
    done = subprocess.run(
        [sys.executable, "-c", AFTER_GMSH.format(threaded=threaded)],
        cwd=ROOT, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (0, "told\n"), done.stderr
