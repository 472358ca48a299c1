"""Budgets: work of any kind ends soon after its time or memory is spent; what is around it goes on."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from contextlib import suppress
from itertools import count
from types import SimpleNamespace

import pytest

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.checking import check
from symbalance.cli import run
from symbalance.errors import SymbalanceError
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking import documents
from tests.effort import effort
from tests.formulas import forms

LONG = 30.0
"""Seconds within which everything here has to have ended; a loaded machine takes its time."""
RIGHT = "$$\\sin^2 x + \\cos^2 x = 1$$"


def endless() -> None:
    for _ in count():
        pass


def endless_but_deaf() -> None:
    """Work that takes any error for one of its own."""
    while True:
        try:
            endless()
        except Exception:
            continue


def hungry() -> None:
    kept = []
    while True:
        kept.append(bytearray(10**6))


@pytest.mark.parametrize("work", [endless, endless_but_deaf])
def test_time_is_limited(work):
    start = time.monotonic()
    with pytest.raises(OverBudgetError) as caught:
        run_within(Budget(0.05), work)
    assert caught.value.spent == "0.05 s"
    assert time.monotonic() - start < LONG


@pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="no other system tells what a thread computed"
)
def test_what_else_a_machine_has_to_do_takes_nothing_from_a_budget():
    assert run_within(Budget(0.1), lambda: time.sleep(0.3)) is None
    with pytest.raises(OverBudgetError):
        run_within(Budget(0.05), lambda: time.sleep(LONG / 20))  # waits WAITING times as long and more


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="no other system tells the memory taken")
def test_memory_is_limited():
    with pytest.raises(OverBudgetError) as caught:
        run_within(Budget(LONG, 50), hungry)
    assert caught.value.spent == "50 MB"


def test_what_is_in_time_is_returned_and_its_own_errors_pass():
    assert run_within(Budget(LONG), lambda: 42) == 42
    with pytest.raises(ZeroDivisionError):
        run_within(Budget(LONG), lambda: 1 / 0)


def test_the_inner_budget_ends_and_the_outer_goes_on():
    def outer() -> str:
        with pytest.raises(OverBudgetError):
            run_within(Budget(0.05), endless)
        return "went on"

    assert run_within(Budget(LONG), outer) == "went on"


def test_the_outer_budget_ends_the_inner_work_too():
    with pytest.raises(OverBudgetError) as caught:
        run_within(Budget(0.05), lambda: run_within(Budget(LONG), endless))
    assert caught.value.spent == "0.05 s"


def test_nothing_is_raised_after_the_work():
    """Work that ends just at its deadline, in three threads: a value or the error, then peace."""
    ends: list[str] = []

    def work(until: float) -> None:
        while time.monotonic() < until:
            pass

    def many() -> None:
        try:
            for _ in range(15):
                with suppress(OverBudgetError):
                    run_within(Budget(0.02), lambda: work(time.monotonic() + 0.02))
                sum(range(1000))
            ends.append("peace")
        except BaseException as problem:
            ends.append(repr(problem))

    threads = [threading.Thread(target=many) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(LONG)
    assert ends == ["peace"] * 3


@pytest.mark.slow
def test_a_profiled_program_goes_on_after_a_budget():
    """CPython 3.11 falls into an endless loop where an exception on its way is taken back."""
    program = (
        "import cProfile\nfrom symbalance.budgets import *\nfrom itertools import count\n"
        "cProfile.Profile().enable()\n"
        "try: run_within(Budget(0.1), lambda: [None for _ in count()])\n"
        "except OverBudgetError: print(sum(range(10)))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, timeout=LONG, text=True, check=False
    )
    assert done.stdout == "45\n", done.stderr


def test_a_relation_over_its_budget_is_undecided_and_the_others_are_judged(monkeypatch):
    from symbalance.notes.checking.judging import judge as judging

    original = judging.Judge.link

    def slow(self, chain, *rest):
        if chain.lines[0] == 1:
            endless()
        return original(self, chain, *rest)

    monkeypatch.setattr(judging.Judge, "link", slow)
    checked = check(f"{RIGHT}\n\n{RIGHT}\n", {"x": "angle"}, budget=Budget(6))
    assert [v.verdict for v in checked.verdicts] == ["undecided", "holds"]
    assert "within its budget of 0.1 s" in checked.verdicts[0].reason
    assert checked.failed
    assert not checked.faults


def test_a_refuted_relation_stays_so_though_its_correction_is_not_found_in_time(monkeypatch):
    from symbalance.notes.checking.repair import fixes

    monkeypatch.setattr(fixes, "_with_fix", lambda *_: endless())
    checked = check("$$\\cos 2x = 1 + 2\\sin^2 x$$", {"x": "angle"}, budget=Budget(12))
    assert [v.verdict for v in checked.verdicts] == ["refuted"]
    assert "no correction was found within" in checked.verdicts[0].notes[-1]


def test_a_share_ends_before_the_budget_around_it():
    def around() -> str:
        with pytest.raises(OverBudgetError):
            run_within(Budget(LONG), endless, share=0.5)
        return "time left"

    assert run_within(Budget(0.4), around) == "time left"


def test_when_the_documents_budget_is_spent_the_rest_is_undecided(monkeypatch):
    """It is spent between reading and judging, by a clock of the test's own: reading takes a moment."""
    clock = count(0, 10**6)
    monkeypatch.setattr(documents, "time", SimpleNamespace(thread_time=lambda: next(clock)))
    checked = check(f"{RIGHT}\n\n" * 5, {"x": "angle"}, budget=Budget(LONG))
    assert [v.verdict for v in checked.verdicts] == ["undecided"] * 5
    assert "spent before" in checked.verdicts[0].reason


def test_a_line_that_rests_on_one_not_judged_is_not_refuted(monkeypatch):
    """y is (x + 1)^2 by a line that was not judged: what follows must not be called wrong."""
    from symbalance.notes.checking.judging import one_relation

    original = one_relation.define_letter

    def slow(definitions, chain, k, knowledge):
        if chain.lines[0] == 1:
            endless()
        return original(definitions, chain, k, knowledge)

    monkeypatch.setattr(one_relation, "define_letter", slow)
    text = "$$y = (x+1)^2$$\n\n$$y + 1 = x^2 + 2x + 2$$\n"
    checked = check(text, {"x": "any", "y": "any"}, budget=Budget(6))
    assert [v.verdict for v in checked.verdicts] == ["undecided", "undecided"]
    assert "may rest on line 1, which was not judged" in checked.verdicts[1].reason


@pytest.mark.parametrize(
    "text",
    [
        "",
        "0",
        "-1",
        "1,2",
        "2GB,3GB",
        "1e9",
        "inf",
        "nan",
        "10 m",
        "1d",
        "4gb",
        "9" * 400,
        "1MB",
        "\u0663s",
    ],
)
def test_a_budget_that_is_none_is_refused(text, capsys):
    assert run(["balance", "inline-4", f"--budget={text}"]) == 2
    error = capsys.readouterr().err
    assert "--budget" in error
    assert error.count("\n") == 1


def test_a_command_over_its_budget_is_refused_in_one_line(capsys):
    assert run(["balance", "r-985"]) == 0  # what it imports is there: the time is the work's
    capsys.readouterr()
    assert run(["balance", "r-985", "--order", "1000", "--budget", "0.01s"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "takes more than its budget of 0.01 s" in captured.err
    assert captured.err.count("\n") == 1


def test_a_series_through_a_thousand_million_is_refused():
    sidecar = {
        "symbols": {"θ": "crank angle", "λ": "rod ratio l/r"},
        "bind": [{"line": 1, "quantity": "displacement", "through": 10**9}],
    }
    with pytest.raises(SymbalanceError, match="through = 1000000000"):
        check("$$ 1 - \\cos θ + \\dots $$", sidecar)


def test_nested_functions_cost_what_they_are():
    """cos(cos(…x)) 20 deep holds the same argument a million times over."""
    shallow, deep = (forms("cos(" * depth + "x" + ")" * depth)[0] for depth in (10, 20))
    assert letters(shallow) == letters(deep) == ["x"]
    assert effort(lambda: letters(deep)) < 4 * effort(lambda: letters(shallow))
