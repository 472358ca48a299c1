"""Jobs on a Dask cluster of three processes: killed workers, a lost scheduler, versions that differ."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from typing import Any

import pytest

from symbalance.cli import run
from symbalance.errors import MissingPartError, SymbalanceError
from symbalance.jobs import Progress, Store, dask_executor, pools, run_jobs
from symbalance.search import search_cranks
from tests import ROOT
from tests.jobs.work import jobs, marks, square

pytestmark = [
    pytest.mark.rare,
    # Dask's own: it opens loops and sockets that it leaves to the collector.
    pytest.mark.filterwarnings("ignore"),
]
CLUSTER = """
import sys
from distributed import LocalCluster

if __name__ == "__main__":
    options = {"n_workers": 3, "threads_per_worker": 1, "processes": True}
    with LocalCluster(**options, dashboard_address=None) as cluster:
        print(cluster.scheduler_address, flush=True)
        sys.stdin.read()
"""


class Cluster:
    """A cluster of three workers, its scheduler in a process of its own, which can be killed."""

    def __init__(self, folder) -> None:
        script = folder / "cluster.py"
        script.write_text(CLUSTER, encoding="utf-8")
        self.process = subprocess.Popen(
            [sys.executable, str(script)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
            cwd=folder,
        )
        assert self.process.stdout is not None
        self.address = self.process.stdout.readline().strip()

    def end(self) -> None:
        try:
            self.process.communicate(timeout=30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.communicate()


@pytest.fixture
def cluster(tmp_path_factory) -> Iterator[Cluster]:
    one = Cluster(tmp_path_factory.mktemp("cluster"))
    yield one
    one.end()


def test_a_cluster_gives_what_one_process_gives(cluster, tmp_path):
    with dask_executor(cluster.address) as executor:
        outcomes = list(run_jobs(square, jobs(tmp_path, 20, 0.05), executor=executor))
    assert [o.result() for _, o in outcomes] == [n * n for n in range(20)]
    assert len({path.name.rsplit("-", 1)[1] for path in marks(tmp_path, "ended")}) == 3


def test_a_worker_killed_midway_costs_nothing(cluster, tmp_path):
    store, progress = Store(tmp_path / "store"), Progress()
    with dask_executor(cluster.address) as executor:
        outcomes = run_jobs(
            square, jobs(tmp_path, 30, 0.2), executor=executor, store=store, progress=progress
        )
        next(outcomes)
        pid = int(marks(tmp_path, "begun")[0].name.rsplit("-", 1)[1])
        os.kill(pid, signal.SIGKILL)
        rest = [o.result() for _, o in outcomes]
    assert rest == [n * n for n in range(1, 30)]
    assert (progress.computed, len(list(store.folder.iterdir()))) == (30, 30)


def test_a_job_that_always_kills_its_worker_is_named(cluster, tmp_path):
    listed = jobs(tmp_path, 6, 0.1, {2: "dies"})
    with dask_executor(cluster.address) as executor:
        outcomes = [o for _, o in run_jobs(square, listed, executor=executor)]
    assert str(outcomes[2].problem).startswith("number 2: the job: its process was killed")
    assert [o.value for o in outcomes if o.is_done] == [0, 1, 9, 16, 25]


def test_a_lost_scheduler_is_said_in_one_line_and_in_bounded_time(cluster, tmp_path):
    store = Store(tmp_path / "store")
    with dask_executor(cluster.address) as executor:
        outcomes = run_jobs(square, jobs(tmp_path, 30, 0.5), executor=executor, store=store)
        next(outcomes)
        cluster.process.kill()
        began = time.monotonic()
        with pytest.raises(SymbalanceError, match=r"lost; \d+ of 30 are finished; they are kept in"):
            list(outcomes)
    assert time.monotonic() - began < 60
    again = [o for _, o in run_jobs(square, jobs(tmp_path, 30, 0), store=store)]
    assert again[0].saved
    assert [o.value for o in again] == [n * n for n in range(30)]


@pytest.mark.parametrize("differs", ["Python", "numpy", "symbalance"])
def test_versions_that_differ_are_refused(cluster, monkeypatch, differs):
    own = pools.own_versions()
    monkeypatch.setattr(pools, "own_versions", lambda: {**own, differs: "0.0.1"})
    said = rf"has other versions than this program: {differs} .* on the scheduler, here 0.0.1"
    with (
        pytest.raises(SymbalanceError, match=said),
        dask_executor(cluster.address),
    ):
        raise AssertionError("a cluster of another version was taken")


def test_nobody_at_the_address_is_refused_in_bounded_time():
    began = time.monotonic()
    with (
        pytest.raises(SymbalanceError, match="no Dask scheduler answers there"),
        dask_executor("tcp://127.0.0.1:9"),
    ):
        raise AssertionError
    assert time.monotonic() - began < 30


@pytest.mark.parametrize("address", ["", "nonsense", "nonsense://a:b", "tcp://127.0.0.1:port", "9"])
def test_what_is_no_address_is_refused_in_a_line(address, capsys, tmp_path):
    command = ["sweep", "v2-90", "--vary", "ratio=3,4", "--quantities", "force.2", "--dask", address]
    assert run(command) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "--dask" in line


def test_without_dask_the_command_that_installs_it_is_said(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with (
        pytest.raises(MissingPartError, match=r"pip install 'symbalance\[dask\]'"),
        dask_executor("tcp://127.0.0.1:9"),
    ):
        raise AssertionError


def test_no_thread_of_dask_is_left(cluster, tmp_path):
    before = threading.active_count()
    with dask_executor(cluster.address) as executor:
        list(run_jobs(square, jobs(tmp_path, 3, 0), executor=executor))
    end = time.monotonic() + 10
    while threading.active_count() > before + 4:
        assert time.monotonic() < end
        time.sleep(0.1)


class KillingProgress(Progress):
    """Kills a worker of the cluster after some jobs."""

    def __init__(self, pid: int, after: int) -> None:
        super().__init__()
        self.pid, self.after = pid, after

    def advance(self, weight: float = 1.0) -> None:
        super().advance(weight)
        if self.computed == self.after:
            os.kill(self.pid, signal.SIGKILL)


def test_a_search_on_a_cluster_one_of_whose_workers_is_killed(cluster):
    from distributed import Client

    question: dict[str, Any] = {"cylinders": 10, "strokes": 2, "minimize": ["couple.1", "couple.2"]}
    alone = search_cranks(**question)
    with Client(cluster.address, set_as_default=False) as client:
        pid = next(iter(client.run(os.getpid).values()))
    progress = KillingProgress(pid, 5)
    with dask_executor(cluster.address) as executor:
        shared = search_cranks(**question, executor=executor, progress=progress)
    assert progress.computed == alone.parts > 100
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)
    assert shared.data() == alone.data()
