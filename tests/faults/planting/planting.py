"""Chooses faults, plants each in a copy of the tree, runs what is near, and says what was caught."""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

from .baseline import Baseline, measure
from .nearest_tests import nearest_files
from .single_faults import Fault, choose, faults_of
from .trees import ROOT, Crew, Tree, grown_trees

RESULTS_BUDGET = 15.0
"""Processor seconds of results that run the line, after which a fault is said to change none."""
PATIENCE = 6
"""Seconds of the clock for each of the processor: other work may hold the machine."""
MOST_RESULTS = 40
FIRST_FILES = 8
"""Files of the fast tests that are run first: collecting more would take longer than running them."""


@dataclass(frozen=True)
class Outcome:
    """What became of one fault."""

    fault: Fault
    changes: str
    """The first result that differs, or nothing."""
    caught: str
    """The first test that fails, or how the run ended; nothing if the fault lives."""
    note: str
    seconds: float


@dataclass(frozen=True)
class Settings:
    """How faults are planted."""

    seed: int = 1
    count: int = 10
    jobs: int = 2
    limit: float = 180.0
    """Processor seconds of tests for one fault."""


def plant(
    rooms: Sequence[str], settings: Settings, say: Callable[[str], None]
) -> dict[str, list[Outcome]]:
    """Plant faults in rooms and return what became of each."""
    with (
        tempfile.TemporaryDirectory(prefix="symbalance-planting-") as folder,
        grown_trees(Path(folder).resolve(), settings.jobs) as trees,
    ):
        crew = Crew(trees)
        baseline = measure(rooms, crew, say)
        clean: dict[str, bool] = {}
        jobs = {}
        for room in rooms:
            for number, fault in enumerate(chosen_faults(room, baseline, settings)):
                jobs[room, number] = _planted(room, fault, baseline, settings, clean, say)
        done = crew.run_all(jobs)
    return {room: [outcome for (home, _), outcome in done.items() if home == room] for room in rooms}


def modules_of(room: str) -> list[str]:
    """Return the modules of a room, relative to the checkout."""
    place = ROOT / "symbalance" / room
    paths = sorted(place.rglob("*.py")) if place.is_dir() else [place.with_suffix(".py")]
    return [path.relative_to(ROOT).as_posix() for path in paths]


def chosen_faults(room: str, baseline: Baseline, settings: Settings) -> list[Fault]:
    """Return so many faults of a room in lines that some result runs."""
    possible = [
        fault
        for path in modules_of(room)
        for fault in faults_of(path, _source(path))
        if baseline.results_at(path, fault.line, fault.statement, at_import=False)
    ]
    return choose(possible, settings.count, Random(f"{settings.seed} {room}"), _source)


def _source(path: str) -> str:
    return (ROOT / path).read_text(encoding="utf-8")


def _planted(
    room: str,
    fault: Fault,
    baseline: Baseline,
    settings: Settings,
    clean: dict[str, bool],
    say: Callable[[str], None],
) -> Callable[[Tree], Outcome]:
    def job(tree: Tree) -> Outcome:
        start = time.monotonic()
        with tree.changed(fault.path, fault.planted_in(_source(fault.path))):
            changes = change_of(tree, fault, baseline)
        if changes in baseline.digests and not _is_steady(tree, changes, baseline, clean):
            changes = ""
        caught, note = ("", "") if not changes else catch(tree, room, fault, baseline, settings, clean)
        outcome = Outcome(fault, changes, caught, note, time.monotonic() - start)
        say(line_of(outcome))
        return outcome

    return job


def change_of(tree: Tree, fault: Fault, baseline: Baseline) -> str:
    """Return the first recorded result that the fault in the tree changes, or nothing."""
    at_import = fault.home[0] == "<module>"
    near = baseline.results_at(fault.path, fault.line, fault.statement, at_import)
    chosen: list[str] = []
    # The cheapest ones, and the others spread evenly over what is left.
    few, rest = near[: MOST_RESULTS // 2], near[MOST_RESULTS // 2 :]
    chosen = few + rest[:: max(1, len(rest) // (MOST_RESULTS // 2))]
    answer = tree.do(
        "results",
        RESULTS_BUDGET * PATIENCE,
        results={name: baseline.commands[name] for name in chosen},
        expected=baseline.digests,
        budget=RESULTS_BUDGET,
    )
    if "value" in answer:
        return answer["value"]["differs"] or ""
    return f"{answer['last'] or 'a result'} does not come to an end"


def catch(
    tree: Tree, room: str, fault: Fault, baseline: Baseline, settings: Settings, clean: dict[str, bool]
) -> tuple[str, str]:
    """Return the first test that fails with the fault and passes without, and what has to be noted."""
    seconds = {name: test.get("seconds", 1.0) for name, test in baseline.tests.items()}
    unsound = [name for name, test in baseline.tests.items() if test.get("outcome")]
    module = fault.path.removeprefix("symbalance/")
    calling = [
        name
        for name, test in baseline.tests.items()
        if name not in unsound and _calls(test.get("functions", ()), module, fault.home)
    ]
    # Those that call least else say most about this; files of them until collecting would cost too much.
    calling.sort(key=lambda name: seconds[name] + len(baseline.tests[name]["functions"]) / 400)
    files: list[str] = []
    for name in calling:
        file = name.split("::")[0]
        if file not in files and len(files) < FIRST_FILES:
            files.append(file)
    first = [name for name in calling if name.split("::")[0] in files]
    spent = 0.0
    source = fault.planted_in(_source(fault.path))
    ran: set[str] = set()
    omitted = 0
    others = [name for name in calling if name.split("::")[0] not in files]
    stages = [
        (files, first),
        (sorted({name.split("::")[0] for name in others}), others),
        (by_nearness(nearest_files(room), fault, {name.split("::")[0] for name in calling}), []),
    ]
    for stage_files, names in stages:
        if not stage_files:
            continue
        budget = settings.limit - spent
        if budget <= 0:
            return "", "the time limit left tests out"
        without = {*unsound, *ran}
        for _ in range(5):
            with tree.changed(fault.path, source):
                answer = tree.do(
                    "tests",
                    (budget + 60) * PATIENCE,
                    files=stage_files,
                    tests=names,
                    without=sorted(without),
                    seconds=seconds,
                    budget=budget,
                )
            if "value" not in answer:
                return f"{answer['last'] or 'the run'} ({_ending(answer['ended'])})", ""
            value = answer["value"]
            spent += value["busy"]
            ran |= set(value["ran"])
            if not value["failed"]:
                omitted += value["omitted"]
                break
            if _passes_alone(tree, value["failed"], clean):
                return value["failed"], ""
            without.add(value["failed"])  # it fails without the fault too, so it says nothing about it
            without |= ran
    return "", f"the time limit left {omitted} tests out" if omitted else ""


def by_nearness(files: Sequence[str], fault: Fault, calling: Collection[str]) -> list[str]:
    """Return files of tests, first those that name the fault's module or have fast tests calling it.

    What is slow is run in this order, and the time limit may end it. Doctests are fast and stay first;
    what only prints a result has its golden files next.
    """
    module = fault.path.removesuffix(".py").replace("/", ".")
    is_printed = fault.path.endswith(("_document.py", "_data.py", "_table.py"))

    def rank(file: str) -> int:
        if not file.startswith("tests/"):
            return 0
        golden = is_printed and file.startswith("tests/documents/")
        return 1 if golden or module in _source(file) else 2 if file in calling else 3

    return sorted(files, key=rank)


def _is_steady(tree: Tree, name: str, baseline: Baseline, clean: dict[str, bool]) -> bool:
    """Return whether a result is the same again without the fault; one that is not is asked no more."""
    if name not in clean:
        answer = tree.do(
            "results", 600, results={name: baseline.commands[name]}, expected=baseline.digests
        )
        clean[name] = "value" in answer and not answer["value"]["differs"]
        if not clean[name]:
            baseline.lines.pop(name, None)
    return clean[name]


def _ending(ended: str) -> str:
    return "does not come to an end" if ended == "limit" else f"the process ends: {ended}"


def _calls(functions: Sequence[Sequence[Any]], module: str, home: tuple[str, int]) -> bool:
    if home[0] == "<module>":
        return any(path == module for path, _, _ in functions)
    return [module, home[0], home[1]] in functions


def _passes_alone(tree: Tree, name: str, clean: dict[str, bool]) -> bool:
    """Return whether a test passes without the fault."""
    if "::" not in name:
        return True  # a file that could not be imported
    if name not in clean:
        answer = tree.do("tests", 900, files=[name.split("::", maxsplit=1)[0]], tests=[name], budget=600)
        clean[name] = "value" in answer and not answer["value"]["failed"]
    return clean[name]


def line_of(outcome: Outcome) -> str:
    """Return what became of a fault, in a few lines."""
    fault = outcome.fault
    if not outcome.changes:
        verdict = "no result changes"
    elif outcome.caught:
        verdict = f"caught by {outcome.caught}"
    else:
        verdict = f"LIVES; changes {outcome.changes}" + (f"; {outcome.note}" if outcome.note else "")
    return (
        f"{fault.path}:{fault.line} ({fault.kind}), {outcome.seconds:.0f} s: {verdict}\n"
        f"  - {fault.before.strip()}\n  + {fault.after.strip()}"
    )


def report(outcomes: dict[str, list[Outcome]]) -> str:
    """Return a table of what was planted, changes a result and was caught, and the faults that live."""
    lines = [f"{'room':<12}{'planted':>9}{'changing':>10}{'caught':>8}{'share':>8}"]
    totals = [0, 0, 0]
    for room, each in outcomes.items():
        changing = [outcome for outcome in each if outcome.changes]
        numbers = [len(each), len(changing), sum(bool(outcome.caught) for outcome in changing)]
        totals = [a + b for a, b in zip(totals, numbers, strict=True)]
        lines.append(_row(room, numbers))
    if len(outcomes) > 1:
        lines.append(_row("all", totals))
    living = [o for each in outcomes.values() for o in each if o.changes and not o.caught]
    if living:
        lines += ["", "not caught:", *(line_of(outcome) for outcome in living)]
    return "\n".join(lines)


def _row(name: str, numbers: Sequence[int]) -> str:
    planted, changing, caught = numbers
    share = f"{100 * caught / changing:.0f} %" if changing else "–"
    return f"{name:<12}{planted:>9}{changing:>10}{caught:>8}{share:>8}"


def say_at_once(text: str) -> None:
    """Write a line to standard error."""
    print(text, file=sys.stderr, flush=True)
