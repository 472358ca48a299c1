"""Evidence about the planting itself: what counts as a fault, how faults are drawn and reported."""

from __future__ import annotations

import os
from pathlib import Path
from random import Random

import pytest

from tests.faults.planting.baseline import Baseline
from tests.faults.planting.planting import Outcome, by_nearness, report
from tests.faults.planting.single_faults import Fault, choose, faults_of, is_another_program
from tests.faults.planting.trees import Tree

SOURCE = '''"""A sentence with - and + in it."""


def pick(values, limit):
    """Return a - b."""
    total = -values[0] * 2 + max(values[1:3])
    if total < limit and values:
        raise ValueError(f"{total} < {limit}: {1 + 1}")
    for value in range(limit):
        if value == 3:
            break
    return total if limit else pick(limit, values)
'''


@pytest.mark.parametrize(
    ("kind", "after"),
    [
        ("sign", "total = values[0] * 2 + max(values[1:3])"),
        ("plus and minus", "total = -values[0] * 2 - max(values[1:3])"),
        ("times and over", "total = -values[0] / 2 + max(values[1:3])"),
        ("index", "total = -values[1] * 2 + max(values[1:3])"),
        ("index", "total = -values[0] * 2 + max(values[1:3 + 1])"),
        ("constant", "total = -values[0] * 3 + max(values[1:3])"),
        ("dropped term", "total = (-values[0] * 2)"),
        ("dropped factor", "total = (-values[0]) + max(values[1:3])"),
        ("twin", "total = -values[0] * 2 + min(values[1:3])"),
        ("comparison", "if total <= limit and values:"),
        ("and and or", "if total < limit or values:"),
        ("condition negated", "if not (total < limit and values):"),
        ("bound", "for value in range(limit + 1):"),
        ("comparison", "if value != 3:"),
        ("break and continue", "continue"),
        ("another branch", "return pick(limit, values) if limit else total"),
        ("exchanged arguments", "return total if limit else pick(values, limit)"),
    ],
)
def test_kinds(kind: str, after: str) -> None:
    """Each kind of fault is there, as the line that it makes of another."""
    lines = {(fault.kind, fault.after.strip()) for fault in faults_of("m.py", SOURCE)}
    assert (kind, after) in lines


def test_one_line_and_no_words() -> None:
    """A fault changes one line, and never a message or a docstring."""
    for fault in faults_of("m.py", SOURCE):
        old, new = SOURCE.splitlines(), fault.planted_in(SOURCE).splitlines()
        assert [n for n, (a, b) in enumerate(zip(old, new, strict=True), 1) if a != b] == [fault.line]
        assert fault.line not in (1, 5, 8)


def test_choice_is_even_and_repeats() -> None:
    """The same seed draws the same faults; modules take turns, and no line is drawn twice."""
    sources = {f"{name}.py": SOURCE for name in "abc"}
    faults = [fault for path, text in sources.items() for fault in faults_of(path, text)]
    one, two = (choose(faults, 9, Random(7), sources.__getitem__) for _ in range(2))
    assert one == two
    assert [sum(fault.path == path for fault in one) for path in sources] == [3, 3, 3]
    assert len({(fault.path, fault.line) for fault in one}) == 9
    assert len({fault.kind for fault in one}) >= 8
    assert one != choose(faults, 9, Random(8), sources.__getitem__)


def test_no_other_program() -> None:
    """An edit that leaves the same program, or none, is no fault."""
    fault = Fault("m.py", 1, "sign", "a = 1", "a = (1)", 1, ("<module>", 0))
    assert not is_another_program(fault, "a = 1\n")
    broken = Fault("m.py", 1, "sign", "a = 1", "a = = 1", 1, ("<module>", 0))
    assert not is_another_program(broken, "a = 1\n")


def test_changed_file_is_restored(tmp_path: Path) -> None:
    """Each planting has a time of its own, lest a compiled module stand for another; then all is back."""
    file = tmp_path / "m.py"
    file.write_text("a = 1\n", encoding="utf-8")
    os.utime(file, (1_000_000, 1_000_000))
    tree = Tree.__new__(Tree)
    tree.folder, tree.stamp = tmp_path, 0
    times = []
    for _ in range(2):
        with tree.changed("m.py", "a = 2\n"):
            assert file.read_text(encoding="utf-8") == "a = 2\n"
            times.append(int(file.stat().st_mtime))
    assert len({*times, 1_000_000}) == 3
    assert file.read_text(encoding="utf-8") == "a = 1\n"
    assert file.stat().st_mtime == 1_000_000


def test_results_that_run_a_line() -> None:
    """What runs a line is asked first; what only loads the module, where few run it."""
    lines = {"a": {"m.py": [3]}, "b": {"m.py": [4]}, "c": {"other.py": [3]}}
    baseline = Baseline({}, {}, {"a": 2.0, "b": 1.0, "c": 0.5}, lines, {})
    assert baseline.results_at("symbalance/m.py", 3, 3, at_import=False) == ["a", "b"]
    assert baseline.results_at("symbalance/m.py", 5, 5, at_import=False) == []


def test_report_counts_what_changes() -> None:
    """What changes no result does not count, and what lives is shown with its line."""
    fault = Fault("symbalance/m.py", 7, "sign", "    return -a", "    return a", 7, ("f", 6))
    outcomes = [
        Outcome(fault, "", "", "", 1.0),
        Outcome(fault, "example/balance", "tests/x.py::test_a", "", 1.0),
        Outcome(fault, "example/balance", "", "", 1.0),
    ]
    text = report({"exact": outcomes})
    assert text.splitlines()[1].split() == ["exact", "3", "2", "1", "50", "%"]
    assert "symbalance/m.py:7 (sign)" in text
    assert "- return -a" in text


def test_files_that_name_the_module_come_first() -> None:
    """The time limit may end what is slow: what is about the module is not what it leaves out."""
    fault = Fault("symbalance/crankshaft/solid/meshing.py", 1, "sign", "a", "b", 1, ("f", 1))
    files = [
        "symbalance/crankshaft",
        "tests/public/test_crankshaft_command.py",
        "tests/laws/test_rotors.py",
        "tests/independent/test_drawn_solids.py",
    ]
    order = by_nearness(files, fault, {"tests/laws/test_rotors.py"})
    assert order == [files[0], files[3], files[2], files[1]]
