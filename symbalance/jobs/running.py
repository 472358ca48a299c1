"""Running of many independent jobs: in this process, in several, or on any executor; restartable.

`run_jobs` yields the outcome of every job in the order of the jobs, however they were split. What a store
has of them is not done again; what is finished is put there at once. A worker that is killed costs
nothing but time: the jobs it may have been at are done again. A job that kills its worker every time is
its own outcome, in one line, and so is one whose input is refused, or that meets a fault of ours: the
others are finished.
"""

from __future__ import annotations

import sys
from collections import Counter, deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from contextvars import ContextVar
from dataclasses import dataclass, replace
from functools import partial
from traceback import format_exception
from typing import Any

from symbalance.errors import JobFaultError, PicklableError, SymbalanceError, fault_of
from symbalance.jobs.digests import program_digest
from symbalance.jobs.pools import MOST_WORKERS, end_pool, killed_worker, lost_executor, process_pool
from symbalance.jobs.progress import Progress
from symbalance.jobs.store import JSON, Codec, DamagedError, Store
from symbalance.text.numbers import checked_whole

ATTEMPTS = 3
"""How often a job is begun whose worker is killed; the last time it runs alone, to be sure of it."""
PULSE = 1.0
"""Seconds between two looks at an executor: where waiting cannot be interrupted, Ctrl-C waits for it."""
Work = Callable[[Any], Any]
_listener: ContextVar[Callable[[str], None] | None] = ContextVar("listener", default=None)


@dataclass(frozen=True)
class Job:
    """A piece of work: what a person calls it, the value that the work is done on, and its key.

    `value` is picklable. The `key` is a digest of all that the outcome depends on (`store.key_of`);
    without one nothing is kept. `changed` says, when the job is done, what of that is another by now:
    then the outcome is not kept, for nobody knows of which it is. `slot` is the name of its file in a
    store, the key if empty; `weight` what the job is expected to cost, in any unit.
    """

    name: str
    value: Any
    key: str = ""
    slot: str = ""
    weight: float = 1.0
    changed: Callable[[], str] = lambda: ""


@dataclass(frozen=True)
class JobOutcome:
    """What became of a job: its `value`, or a `problem` with its input, or a `fault` of ours."""

    value: Any = None
    problem: SymbalanceError | None = None
    fault: str = ""
    traceback: str = ""
    saved: bool = False
    """Whether it was read back from a store."""
    notes: tuple[str, ...] = ()
    """What the job said while it ran in a worker (see `note`); elsewhere it has been said already."""

    @property
    def is_done(self) -> bool:
        """Whether the work gave a value."""
        return self.problem is None and not self.fault

    def result(self, place: str = "") -> Any:
        """Return the value, or raise what kept the job from one."""
        if self.problem is not None:
            raise self.problem
        if self.fault:
            raise JobFaultError(f"{place}: {self.fault}" if place else self.fault, self.traceback)
        return self.value


def note(line: str) -> None:
    """Say a line from within a job: at once in the caller's process, from a worker at its end."""
    listener = _listener.get()
    if listener is not None:
        listener(line)


def run_jobs(
    work: Work,
    jobs: Sequence[Job],
    *,
    executor: Executor | None = None,
    workers: int = 1,
    store: Store | None = None,
    codec: Codec[Any] = JSON,
    progress: Progress | None = None,
    attempts: int = ATTEMPTS,
) -> Iterator[tuple[Job, JobOutcome]]:
    """Yield every job with its outcome, in the order of the jobs, each as soon as those before it are.

    `work` is a picklable function of a job's value. One worker and no `executor`: all runs in this
    process, without any pool. Several `workers` are processes of a pool that is made here, and made anew
    where one of them is killed; an `executor` is the caller's, and stays open. `codec` turns outcomes
    into bytes for the `store`; only values are kept, never a refusal or a fault.

    >>> [outcome.value for _, outcome in run_jobs(abs, [Job("a", -1), Job("b", 2)])]
    [1, 2]
    """
    count = checked_whole(workers, "workers", 1, MOST_WORKERS, "as many as the machine has cores")
    checked_whole(attempts, "attempts", 1, 100, f"{ATTEMPTS} is the default")
    if executor is not None and not isinstance(executor, Executor):
        what = f"executor of type {type(executor).__name__}"
        raise SymbalanceError(what, "is no executor", "give one of concurrent.futures, or workers=2")
    return _ordered(work, list(jobs), executor, count, store, codec, progress or Progress(), attempts)


def _ordered(
    work: Work,
    jobs: list[Job],
    executor: Executor | None,
    workers: int,
    store: Store | None,
    codec: Codec[Any],
    progress: Progress,
    attempts: int,
) -> Iterator[tuple[Job, JobOutcome]]:
    """Yield outcomes in the order of the jobs from those that come in any order."""
    outcomes = {i: o for i, job in enumerate(jobs) if (o := _saved(job, store, codec, progress))}
    progress.start([job.weight for job in jobs], [jobs[place].weight for place in outcomes])
    places = [place for place in range(len(jobs)) if place not in outcomes]
    progress.side_by_side = workers
    if executor is None and workers > 1 and len(places) > 1:
        pool: _Workers = _Pool(min(workers, len(places)))
    elif executor is not None:
        pool = _Given(executor)
    else:
        pool = _Here()
    following = 0
    try:
        while following in outcomes:
            yield jobs[following], outcomes.pop(following)
            following += 1
        for place, outcome in pool.outcomes(work, jobs, places, progress, attempts):
            job = jobs[place]
            for line in outcome.notes:
                progress.say(line)
            if store is not None and job.key and outcome.is_done and codec.keeps(outcome.value):
                changed = job.changed()
                if changed:
                    progress.say(f"{job.name}: {changed}: not kept")
                else:
                    store.save(job.key, codec.encode(outcome.value), job.slot)
            progress.advance(job.weight)
            outcomes[place] = outcome
            while following in outcomes:
                yield jobs[following], outcomes.pop(following)
                following += 1
    except _NobodyLeftError as problem:
        raise _lost(progress, store, problem) from None
    finally:
        pool.end()
        progress.close()


def _saved(job: Job, store: Store | None, codec: Codec[Any], progress: Progress) -> JobOutcome | None:
    """Return what a store has of a job, None where it has nothing that is valid."""
    if store is None or not job.key:
        return None
    saved = store.load(job.key, job.slot)
    reason = saved.reason
    if saved.payload is not None:
        try:
            value = codec.decode(saved.payload)
            reason = codec.disagreement(job.value, value)
            if not reason:
                return JobOutcome(value, saved=True)
        except DamagedError as problem:
            reason = str(problem)
        except Exception as problem:  # bytes of another kind raise anything
            reason = type(problem).__name__
        reason = f"does not read ({reason})"
    if reason:
        progress.say(f"{store.path(job.slot or job.key)}: {reason}: computed anew")
    return None


def _lost(progress: Progress, store: Store | None, problem: _NobodyLeftError) -> SymbalanceError:
    count = f"{progress.finished} of {progress.total} are finished"
    if store is not None:
        remedy = f"they are kept in {store.folder}: run the same again to go on"
    else:
        remedy = "nothing is kept without a store; name an output folder, or use fewer workers"
    return SymbalanceError(problem.who, f"{problem.why}; {count}", remedy)


class _NobodyLeftError(PicklableError):
    """There is nobody any more to do the work."""

    def __init__(self, who: str = "", why: str = "") -> None:
        super().__init__(who, why)
        self.who, self.why = who, why


# What happens where a job runs


def _do(work: Work, value: Any, program: str = "") -> JobOutcome:
    """Return the outcome of one job, in the process where it is done; only Ctrl-C gets through.

    `program` is the digest that this process must have: a worker that came later may be another's.
    """
    if program and program_digest() != program:
        rule = "has another version of symbalance"
        return JobOutcome(problem=SymbalanceError("the worker", rule, "install the same everywhere"))
    notes: list[str] = []
    token = _listener.set(notes.append)
    try:
        return replace(_outcome(work, value), notes=tuple(notes))
    finally:
        _listener.reset(token)


def _outcome(work: Work, value: Any) -> JobOutcome:
    try:
        return JobOutcome(work(value))
    except Exception as problem:
        return _failed(problem)


def _failed(problem: BaseException) -> JobOutcome:
    """Return the outcome of a job that an exception ended."""
    if isinstance(problem, SymbalanceError):
        return JobOutcome(problem=problem)
    if isinstance(problem, MemoryError):
        remedy = "ask for less, or take fewer workers at once"
        return JobOutcome(problem=SymbalanceError("memory", "is not enough for this", remedy))
    return JobOutcome(fault=fault_of(problem), traceback="".join(format_exception(problem)))


# Where jobs run


class _Workers:
    """Those who do the jobs."""

    def outcomes(
        self, work: Work, jobs: list[Job], places: list[int], progress: Progress, attempts: int
    ) -> Iterator[tuple[int, JobOutcome]]:
        """Yield the outcomes of the jobs at `places`, each with its place, in any order."""
        raise NotImplementedError

    def end(self) -> None:
        """End what was begun here."""


class _Here(_Workers):
    """This process: no pool, so that a plain run is as it would be without this room."""

    def outcomes(
        self, work: Work, jobs: list[Job], places: list[int], progress: Progress, attempts: int
    ) -> Iterator[tuple[int, JobOutcome]]:
        for place in places:
            token = _listener.set(progress.say)
            try:
                outcome = _outcome(work, jobs[place].value)
            finally:
                _listener.reset(token)
            yield place, _named(jobs[place], outcome)


class _Concurrent(_Workers):
    """Workers behind an executor; a killed one is noticed, and its jobs are done again."""

    window = sys.maxsize
    """The jobs handed over at once: of our own pool as many as run, so that a break says which."""
    program = ""

    def __init__(self) -> None:
        self._running: dict[Future[Any], int] = {}

    def submit(self, work: Work, value: Any) -> Future[Any]:
        """Hand a job over."""
        raise NotImplementedError

    def renew(self) -> None:
        """Take a new executor after a break, or raise `_NobodyLeftError`."""
        raise NotImplementedError

    def outcomes(
        self, work: Work, jobs: list[Job], places: list[int], progress: Progress, attempts: int
    ) -> Iterator[tuple[int, JobOutcome]]:
        begun: Counter[int] = Counter()
        together, alone = deque(places), deque[int]()
        if attempts == 1:
            together, alone = alone, together
        while together or alone or self._running:
            lost: list[int] = []
            while together and len(self._running) < self.window:
                self._hand_over(work, jobs, together.popleft(), lost)
            if alone and not self._running and not together:
                self._hand_over(work, jobs, alone.popleft(), lost)
            done, _ = wait(self._running, PULSE, FIRST_COMPLETED)
            if lost or any(_is_broken(future) for future in done):
                # All that were handed over have ended, or will at once.
                done, _ = wait(self._running, 10 * PULSE)
                lost += [self._running.pop(future) for future in [*self._running] if future not in done]
            for future in done:
                place = self._running.pop(future)
                if _is_broken(future):
                    lost.append(place)
                else:
                    yield place, _named(jobs[place], self._outcome_of(future, attempts))
            for place in sorted(lost):
                begun[place] += 1
                if begun[place] >= attempts:
                    yield place, _named(jobs[place], _deadly(attempts))
                else:
                    (together if begun[place] < attempts - 1 else alone).append(place)
            if lost:
                self.renew()

    def _hand_over(self, work: Work, jobs: list[Job], place: int, lost: list[int]) -> None:
        try:
            future = self.submit(partial(_do, work, program=self.program), jobs[place].value)
        except BrokenExecutor:
            lost.append(place)
        else:
            self._running[future] = place

    def _outcome_of(self, future: Future[Any], attempts: int) -> JobOutcome:
        try:
            return future.result()
        except KeyboardInterrupt:
            raise
        except BaseException as problem:  # a future's cancellation is no Exception
            if lost_executor(problem):
                raise _NobodyLeftError("the executor", "is lost") from None
            # Dask has begun the job on other workers itself before it gives up.
            return _deadly(attempts) if killed_worker(problem) else _failed(problem)


class _Pool(_Concurrent):
    """A pool of processes of our own, made anew where one of them is killed."""

    def __init__(self, workers: int) -> None:
        super().__init__()
        self.window = workers
        self._executor = process_pool(workers)

    def submit(self, work: Work, value: Any) -> Future[Any]:
        return self._executor.submit(work, value)

    def renew(self) -> None:
        self.end()
        self._executor = process_pool(self.window)

    def end(self) -> None:
        end_pool(self._executor)


class _Given(_Concurrent):
    """The caller's executor, which stays open, and which nobody here can make anew."""

    def __init__(self, executor: Executor) -> None:
        super().__init__()
        self._executor = executor
        self.program = program_digest()

    def submit(self, work: Work, value: Any) -> Future[Any]:
        try:
            return self._executor.submit(work, value)
        except BrokenExecutor:
            raise
        except Exception as problem:
            if lost_executor(problem):
                raise _NobodyLeftError("the executor", "is lost") from None
            raise

    def renew(self) -> None:
        raise _NobodyLeftError("the executor", "has lost a worker, and takes no more jobs")

    def end(self) -> None:
        for future in self._running:
            future.cancel()


def _is_broken(future: Future[Any]) -> bool:
    """Tell whether a future ended because the whole pool did."""
    return not future.cancelled() and isinstance(future.exception(), BrokenExecutor)


def _deadly(attempts: int) -> JobOutcome:
    times = "once" if attempts == 1 else f"{attempts} times"
    rule = f"its process was killed {times}"
    return JobOutcome(problem=SymbalanceError("the job", rule, "see whether memory is enough for it"))


def _named(job: Job, outcome: JobOutcome) -> JobOutcome:
    """Return an outcome whose refusal says of which job it is."""
    if outcome.problem is None:
        return outcome
    return replace(outcome, problem=outcome.problem.within(job.name))
