"""`symbalance bench check`: speed and correctness of the derivation checker, and faults it catches.

Measured on a page of hand mathematics (`page.md`: 116 relations, a dozen of them wrong), beside SymPy's
`simplify` and `equals` on the same relations (`sympy_decisions` says how that is fair), on single lines
of other people's pages beside other programs (`other_checkers`), and on faults planted by program in the
corrected page. The processor time of a whole process, start included, is measured on two more pages:
`workshop_page.md`, an engineer's notes of 106 relations with numbers put in with their units, and an
empty one.
"""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.resources import as_file
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

import sympy

from symbalance.bench.check_page import (
    PAGE,
    WORKSHOP_PAGE,
    Page,
    bench_page,
    blocks,
    context,
    place_of,
    with_blocks_alone,
)
from symbalance.bench.other_checkers import Comparison, compare_checkers
from symbalance.bench.planted_faults import (
    DEFINITION,
    LOWERED,
    NO_FAULT,
    STEP,
    UNREAD,
    Fault,
    Planter,
    tally,
)
from symbalance.bench.sympy_decisions import (
    EQUALS,
    LIMIT,
    SIMPLIFY,
    UNDECIDED,
    Outcome,
    decide_links,
    links,
)
from symbalance.bench.timing import Measurement, Report, best, progress
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED, STATED, Checked

CPU_WITHOUT, CPU_WITH, CPU_OF_EMPTY = 1.5, 3.0, 0.5
FASTER = {SIMPLIFY: 4, EQUALS: 2}
"""Targets: seconds of processor time for 90 relations, start included, without and with the search for
fixes (the pages have more and are held to the same), and for an empty page; how many times as long
SymPy takes, at least, by its way."""
POSITIVE = (*PROVED_WORDS, *STATED)
EACH, EACH_QUICKLY, EVERY_QUICKLY = 30, 6, 4
"""Faults of each kind; quickly fewer, and only every fourth relation for SymPy."""
MOST_LISTED = 20


@dataclass(frozen=True)
class CheckReport:
    """Times and rightness, as for every topic, and the table of planted faults below them."""

    times: Report
    comparison: Comparison
    faults: Sequence[Fault]
    notes: Sequence[str]

    def text(self) -> str:
        """Return the report as it is printed."""
        parts = (self.times.text(), self.comparison.text(), "", fault_table(self.faults, self.notes))
        return "\n".join(parts) + "\n"

    def missed_targets(self) -> list[Measurement]:
        """Return the measurements that miss their target."""
        return self.times.missed_targets()


def report(quick: bool = False) -> CheckReport:
    """Return all measurements; `quick` gives SymPy every fourth relation, and plants fewer faults."""
    page = bench_page()
    parts = [
        ("A page of hand mathematics", [*whole_process(3 if quick else 5), *in_process(page)]),
        ("The same relations by SymPy", beside_sympy(page, EVERY_QUICKLY if quick else 1)),
    ]
    progress("single lines, by several programs")
    comparison = compare_checkers(EVERY_QUICKLY if quick else 1)
    progress("planted faults")
    planter = Planter(page)
    faults = list(planter.plant(EACH_QUICKLY if quick else EACH))
    head = f"Python {platform.python_version()}, SymPy {sympy.__version__}, {platform.machine()}"
    return CheckReport(Report(head, parts), comparison, faults, notes_on(planter))


def notes_on(planter: Planter) -> list[str]:
    """Return notes below the table: on the page's known errors, and on alarms where there are none."""
    refutations, fixes = planter.known_errors()
    return [
        f"known errors of the page: {len(planter.page.errors)}, refuted {refutations}, "
        f"fixed rightly {fixes}",
        f"false alarms on the corrected page: {len(planter.false_alarms)}",
    ]


def whole_process(runs: int = 5) -> list[Measurement]:
    """Measure the processor time of `symbalance check` on whole pages (median of several runs)."""
    progress("whole processes")
    with as_file(PAGE) as page, as_file(WORKSHOP_PAGE) as notes, TemporaryDirectory() as folder:
        empty = Path(folder) / "empty.md"
        empty.write_text("", encoding="utf-8")
        return [
            *(_whole_process(path, *limit, runs) for path in (page, notes) for limit in LIMITS),
            _whole_process(empty, [], CPU_OF_EMPTY, runs),
        ]


LIMITS: tuple[tuple[list[str], float], ...] = ((["--no-fixes"], CPU_WITHOUT), ([], CPU_WITH))


def _whole_process(path: Path, options: list[str], most: float, runs: int) -> Measurement:
    command = [sys.executable, "-m", "symbalance", "check", str(path), *options]
    seconds = median(_process(command) for _ in range(runs))
    name = " ".join(["symbalance check", path.name, *options, "(CPU of the process)"])
    return Measurement(name, seconds, target=f"under {most:g} s", is_met=seconds < most)


def _process(command: Sequence[str]) -> float:
    """Return the processor time of a command, in user and system mode; other processes do not count."""
    before = os.times()
    done = subprocess.run(command, check=False, stdout=subprocess.DEVNULL)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}")
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def in_process(page: Page) -> list[Measurement]:
    """Measure reading, judging and diagnosing the page, and count what is judged rightly."""
    progress("judging the page")
    seconds = best(lambda: page.check(page.text), budget=1)
    judgement = page.check(page.text)
    count = len(judgement.verdicts)
    false, total = misjudgements(page, judgement), len(truth(page))
    name = f"a verdict, of {count} (reading and diagnosis included)"
    rightly = f"the page, {total - len(false)} of {total} relations judged rightly"
    return [
        Measurement(name, seconds / count),
        Measurement(rightly, seconds, target="all of them" + _list(false), is_met=not false),
    ]


def truth(page: Page) -> dict[tuple[int, int], bool]:
    """Return for every relation of the page, by line and number on it, whether it is right."""
    wrong = {(error.line, error.link) for error in page.errors}
    places = [
        place_of(chain, k) for chain in page.read(page.text).chains for k in range(len(chain.relations))
    ]
    return {place: place not in wrong for place in places}


def misjudgements(page: Page, judgement: Checked) -> list[tuple[int, int]]:
    """Return the relations whose verdict is not the truth."""
    verdicts = {(v.line, v.link): v.verdict for v in judgement.verdicts}
    return [
        place
        for place, right in truth(page).items()
        if not (verdicts.get(place) in POSITIVE if right else verdicts.get(place) == REFUTED)
    ]


def _list(places: Sequence[tuple[int, int]]) -> str:
    return "".join(f"\n    not line {line}, relation {link}" for line, link in places)


def beside_sympy(page: Page, every: int) -> list[Measurement]:
    """Measure the relations beside SymPy's ways, the checker on a page that holds nothing else."""
    relations = links(page)[::every]
    lines = {link.line for link in relations}
    every_block = blocks(page, page.read(page.text))
    paragraphs = context([b for b in every_block if lines & set(b.lines)], every_block)
    text, their_lines = with_blocks_alone(page.text, paragraphs), {n for b in paragraphs for n in b.lines}
    seconds = best(lambda: page.check(text, their_lines), budget=1)
    false = set(misjudgements(page, page.check(page.text)))
    right = sum((link.line, link.link) not in false for link in relations)
    rows = []
    for way, times in FASTER.items():
        progress(f"{way} on {len(relations)} relations")
        outcomes = list(decide_links(relations, way))
        other = sum(outcome.seconds for outcome in outcomes)
        rows.append(
            Measurement(
                f"{len(relations)} relations, {right} decided rightly",
                seconds,
                f"sympy {way}: {_summary(outcomes)}",
                other,
                f"at least {times} times as long, with no more decided rightly",
                other >= times * seconds and right >= sum(o.is_right for o in outcomes),
            )
        )
    return rows


def _summary(outcomes: Sequence[Outcome]) -> str:
    count = Counter(o.answer if o.is_right or o.answer == UNDECIDED else "wrong" for o in outcomes)
    late = sum(o.seconds >= LIMIT for o in outcomes)
    parts = [f"{sum(o.is_right for o in outcomes)} rightly", f"{count[UNDECIDED]} undecided"]
    parts += [f"{late} after {LIMIT:g} s"] if late else []
    return ", ".join(parts + ([f"{count['wrong']} wrongly"] if count["wrong"] else []))


def fault_table(faults: Sequence[Fault], notes: Sequence[str]) -> str:
    """Return the faults planted, caught and fixed, kind by kind, and those that were missed."""
    title = "Faults planted in the corrected page, one at a time"
    columns = ("planted", "caught", "fixed", "rightly", "other side")
    rows = tally(faults)
    steps = sum((row for kind, row in rows.items() if kind != DEFINITION), Counter[str]())
    lines = [title, "─" * len(title), f"{'':<24}" + "".join(f"{c:>11}" for c in columns)]
    for kind, row in {**rows, "all but definitions": steps}.items():
        name = "in a definition" if kind == DEFINITION else kind
        lines.append(f"{name:<24}" + "".join(f"{row[c]:>11}" for c in columns))
    kinds = Counter(fault.where for fault in faults)
    lines += [
        "rightly: the fix has the value the side had; other side: it changes the other to fit the fault",
        "in a definition: contradicted only where a later line says otherwise",
        f"drawn, but no faults: {kinds[NO_FAULT]} of the same value, {kinds[LOWERED]} true to a lower"
        f" order, {kinds[UNREAD]} no formula any more",
        *notes,
    ]
    misses = [fault for fault in faults if fault.where == STEP and not fault.is_caught]
    lines += [f"missed: {len(misses)}", *map(_line, misses[:MOST_LISTED])]
    return "\n".join(lines)


def _line(fault: Fault) -> str:
    verdicts = ", ".join(fault.verdicts)
    return f"  line {fault.line}, {fault.kind} ({verdicts}): {fault.before} → {fault.after}"
