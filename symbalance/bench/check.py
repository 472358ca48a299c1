"""`symbalance bench check`: what judging a hand derivation costs, how often it is right, what it catches.

Measured on a page of our own (`page.md`: 116 relations, a dozen of them wrong), beside
`sympy.simplify(lhs - rhs)` on the same relations (`simplifying` says how that is kept fair), and on
faults planted by program in the page put right.
"""

from __future__ import annotations

import platform
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.resources import as_file
from statistics import median
from time import perf_counter

import sympy

from symbalance.bench.check_page import PAGE, Page, blocks, context, masked, page, place_of
from symbalance.bench.planting import DEFINITION, LOWERED, NO_FAULT, STEP, UNREAD, Fault, Planter, tally
from symbalance.bench.simplifying import LIMIT, UNDECIDED, Outcome, links, simplified
from symbalance.bench.timing import Measurement, Report, best, progress
from symbalance.notes.checking.verdicts import REFUTED, Checked

WHOLE_PROCESS = 5.0
FASTER = 4
POSITIVE = ("holds", "holds_to_order", "conditional", "definition")
EVERY_WITH_SIMPLIFY, EACH = 4, 30
EACH_QUICKLY = 6
MOST_SHOWN = 20


@dataclass(frozen=True)
class CheckReport:
    """Times and rightness, as for every topic, and the table of planted faults below them."""

    timed: Report
    faults: Sequence[Fault]
    notes: Sequence[str]

    def text(self) -> str:
        """Return the report as it is printed."""
        return f"{self.timed.text()}\n{fault_table(self.faults, self.notes)}\n"

    def missed(self) -> list[Measurement]:
        """Return what did not reach the target stated for it."""
        return self.timed.missed()


def report(quick: bool = False) -> CheckReport:
    """Return all measurements; `quick` asks SymPy for every fourth relation, and plants fewer faults."""
    here = page()
    parts = [
        ("A page of hand mathematics", [whole_process(3 if quick else 5), *in_process(here)]),
        ("The same relations by SymPy", against_simplify(here, EVERY_WITH_SIMPLIFY if quick else 1)),
    ]
    progress("planted faults")
    planter = Planter(here)
    faults = list(planter.planted(EACH_QUICKLY if quick else EACH))
    head = f"Python {platform.python_version()}, SymPy {sympy.__version__}, {platform.machine()}"
    return CheckReport(Report(head, parts), faults, notes_on(planter))


def notes_on(planter: Planter) -> list[str]:
    """Return what else is to be said: the page's known errors, and alarms where there are none."""
    refuted, fixed = planter.known_errors()
    return [
        f"known errors of the page: {len(planter.page.errors)}, refuted {refuted}, fixed rightly {fixed}",
        f"false alarms on the page put right: {len(planter.false_alarms)}",
    ]


def whole_process(runs: int = 5) -> Measurement:
    """Measure `symbalance check page.md` from outside (median); it answers 1, for the page has errors."""
    progress("whole processes")
    with as_file(PAGE) as path:
        command = [sys.executable, "-m", "symbalance", "check", str(path)]
        taken = median(_timed(command) for _ in range(runs))
    limit = f"under {WHOLE_PROCESS:g} s"
    return Measurement(
        "symbalance check page.md, whole process", taken, wanted=limit, met=taken < WHOLE_PROCESS
    )


def _timed(command: Sequence[str]) -> float:
    start = perf_counter()
    done = subprocess.run(command, check=False, stdout=subprocess.DEVNULL)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}")
    return perf_counter() - start


def in_process(here: Page) -> list[Measurement]:
    """Measure reading, judging and diagnosing the page, and count what is judged rightly."""
    progress("judging the page")
    taken = best(lambda: here.check(here.text), budget=1)
    checked = here.check(here.text)
    count = len(checked.verdicts)
    false, total = wrongly_judged(here, checked), len(truth(here))
    name = f"a verdict, of {count} (reading and diagnosis included)"
    rightly = f"the page, {total - len(false)} of {total} relations judged rightly"
    return [
        Measurement(name, taken / count),
        Measurement(rightly, taken, wanted="all of them" + _listed(false), met=not false),
    ]


def truth(here: Page) -> dict[tuple[int, int], bool]:
    """Return for every relation of the page, by line and number on it, whether it is right."""
    wrong = {(error.line, error.link) for error in here.errors}
    places = [
        place_of(chain, k) for chain in here.read(here.text).chains for k in range(len(chain.relations))
    ]
    return {place: place not in wrong for place in places}


def wrongly_judged(here: Page, checked: Checked) -> list[tuple[int, int]]:
    """Return the relations whose verdict is not the truth."""
    said = {(v.line, v.link): v.verdict for v in checked.verdicts}
    return [
        place
        for place, right in truth(here).items()
        if not (said.get(place) in POSITIVE if right else said.get(place) == REFUTED)
    ]


def _listed(places: Sequence[tuple[int, int]]) -> str:
    return "".join(f"\n    not line {line}, relation {link}" for line, link in places)


def against_simplify(here: Page, every: int) -> list[Measurement]:
    """Measure the relations beside SymPy's simplify, ours as a page that holds nothing else."""
    chosen = links(here)[::every]
    progress(f"simplify on {len(chosen)} relations")
    outcomes = list(simplified(chosen))
    lines = {link.line for link in chosen}
    document = here.read(here.text)
    every_block = blocks(here, document)
    kept = context([b for b in every_block if lines & set(b.lines)], every_block)
    text, kept_lines = masked(here.text, kept), {line for b in kept for line in b.lines}
    ours = best(lambda: here.check(text, kept_lines), budget=1)
    false = set(wrongly_judged(here, here.check(here.text)))
    right = sum((link.line, link.link) not in false for link in chosen)
    total = sum(outcome.seconds for outcome in outcomes)
    return [
        Measurement(
            f"{len(chosen)} relations, {right} decided rightly",
            ours,
            f"sympy simplify(lhs - rhs): {_summary(outcomes)}",
            total,
            f"at least {FASTER} times, and no fewer decided rightly",
            total / ours >= FASTER and right >= sum(o.is_right for o in outcomes),
        )
    ]


def _summary(outcomes: Sequence[Outcome]) -> str:
    count = Counter(o.said if o.is_right or o.said == UNDECIDED else "wrong" for o in outcomes)
    late = sum(o.seconds >= LIMIT for o in outcomes)
    parts = [f"{sum(o.is_right for o in outcomes)} rightly", f"{count[UNDECIDED]} undecided"]
    parts += [f"{late} after {LIMIT:g} s"] if late else []
    return ", ".join(parts + ([f"{count['wrong']} wrongly"] if count["wrong"] else []))


def fault_table(faults: Sequence[Fault], notes: Sequence[str]) -> str:
    """Return what was planted and what the checker made of it, kind by kind, and what it missed."""
    title = "Faults planted in the page put right, one at a time"
    columns = ("planted", "caught", "fixed", "rightly", "other side")
    rows = tally(faults)
    steps = sum((row for kind, row in rows.items() if kind != DEFINITION), Counter[str]())
    lines = [title, "─" * len(title), f"{'':<24}" + "".join(f"{c:>11}" for c in columns)]
    for kind, row in {**rows, "all but definitions": steps}.items():
        name = "in a definition" if kind == DEFINITION else kind
        lines.append(f"{name:<24}" + "".join(f"{row[c]:>11}" for c in columns))
    drawn = Counter(fault.where for fault in faults)
    lines += [
        "rightly: the fix has the value the side had; other side: it changes the other to fit the fault",
        "in a definition: contradicted only where a later line says otherwise",
        f"drawn, but no faults: {drawn[NO_FAULT]} of the same value, {drawn[LOWERED]} true to a lower"
        f" order, {drawn[UNREAD]} no formula any more",
        *notes,
    ]
    missed = [fault for fault in faults if fault.where == STEP and not fault.caught]
    lines += [f"missed: {len(missed)}", *map(_shown, missed[:MOST_SHOWN])]
    return "\n".join(lines)


def _shown(fault: Fault) -> str:
    said = ", ".join(fault.verdicts)
    return f"  line {fault.line}, {fault.kind} ({said}): {fault.before} → {fault.after}"
