"""Hostile documents: a clear verdict or a clear refusal, in little time, and never a traceback."""

import os
import subprocess
import sys
import time
import tomllib

import pytest

from symbalance.checking import check
from symbalance.errors import SymbalanceError
from tests import TESTS

HOSTILE = TESTS / "hand" / "hostile"
EXPECTED = tomllib.loads((HOSTILE / "expect.toml").read_text(encoding="utf-8"))["file"]
LETTERS = {"theta": "crank angle", "x": "any", "y": "any", "z": "any", "w": "any"}
MOST_SECONDS = 75
"""Of processor time for thousands of relations: more than it takes, and far less than its square."""
RIGHT = r"$$\sin^2\theta+\cos^2\theta=1$$"


@pytest.mark.spread(2)
@pytest.mark.parametrize("expected", EXPECTED, ids=lambda e: e["name"])
def test_each_file_ends_as_expected(expected, tmp_path):
    path = HOSTILE / expected["name"]
    environment = {**os.environ, "PYTHONPATH": str(HOSTILE.parents[2])}
    command = [sys.executable, "-m", "symbalance", "check", str(path)]
    done = subprocess.run(
        command, capture_output=True, cwd=tmp_path, env=environment, timeout=60, check=False
    )
    assert done.returncode in expected["exit"]
    assert b"Traceback" not in done.stderr
    assert done.stderr.count(b"\n") <= 1
    assert not list(tmp_path.iterdir())
    for absent in expected.get("absent", ()):
        assert absent.encode() not in done.stdout + done.stderr
    if done.returncode != 2 and "lines" in expected:
        found = check(path).data()["links"]
        for line in expected["lines"]:
            verdicts = {e["verdict"] for e in found if e["line"] == line["line"]}
            assert verdicts & set(line["verdicts"]) or line.get("none_ok"), line
            assert not verdicts & set(line.get("never", ())), line


LARGE = {
    "opening brackets": "\\displaystyle " + "(" * 200_000,
    "nested brackets": "\\displaystyle " + "(" * 20_000 + "x" + ")" * 20_000 + " = x",
    "nested fractions": "$$" + r"\frac{1}{1+" * 5_000 + "x" + "}" * 5_000 + " = 1$$",
    "nested roots": "$$" + r"\sqrt{" * 3_000 + "x" + "}" * 3_000 + " = 1$$",
    "braces": "$$" + "{" * 50_000 + "$$",
    "dollars": "$" * 200_000,
    "relations": "$$" + "=" * 50_000 + "$$",
    "a long sum": "$$" + "+".join(["x"] * 30_000) + " = x$$",
    "a huge integer": "$$" + "7" * 20_000 + " = 7$$",
    "a huge exponent": "$$9^{9^{9^9}} = x$$",
    "a huge power of a sum": r"$$(x+y+z+w)^{399} = 1$$",
    "deep superscripts": "$$x" + "^{x" * 2_000 + "}" * 2_000 + " = 1$$",
    "many lines": "x = x + \n" * 4_000,
    "backslashes": "\\" * 100_000,
    "a macro of itself": r"\def\a{\a\a}$\a = x$",
    "macros of macros": r"\def\a{\b\b}\def\b{\a\a}$\a = x$",
    "a macro that grows": r"\def\a#1{\a{#1#1}}$\a{x} = x$",
    "many macros": r"\def\z{x}" * 20_000 + r"$\z=\z$" * 1_000,
    "cancelled": "$" + r"\cancel{" * 5_000 + "x" + "}" * 5_000 + "=x$",
    "quantities": r"\SI{1}{" * 20_000,
    "dashes": "$a — b " * 20_000,
    "words and signs": "foo = bar " * 30_000,
    "smaller than": "<a " * 50_000,
    "tags": "<math>" * 20_000,
    "fences": "```\n" * 30_000,
    "minus signs": "$$" + "-" * 20_000 + "x = x$$",
    "lines of relations": "x = y\n" * 5_000,
    "quoted relations": "> x = y\n" * 5_000,
    "ranges": "0 ≤ x ≤ 1, " * 1_000,
    "blank lines": "\n" * 100_000,
    "a long word": "a" * 100_000,
    "pieces between dollars": "$x$ theta=1 " * 5_000,
    "rows of dashes": ("| " + "-" * 20_000 + "!\n") * 3,
    "one number of all digits": "1" * 100_000 + "!",
}


@pytest.mark.slow
@pytest.mark.parametrize("name", LARGE)
def test_large_input_is_judged_or_refused_and_the_line_after_it_is_read(name):
    start = time.process_time()
    try:
        found = check(f"{LARGE[name]}\n\n{RIGHT}\n", LETTERS)
    except SymbalanceError:
        return
    verdicts = [v.verdict for v in found.verdicts]
    assert "holds" in verdicts[-1:] or "unreadable" in verdicts or not verdicts
    assert time.process_time() - start < MOST_SECONDS


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("{", "is no JSON"),
        ("[]", "is no notebook"),
        ("[" * 100_000, "is"),
        ('{"cells": [3]}', "is no cell of a notebook"),
        ('{"cells": [{"cell_type": "markdown", "source": {"a": 1}}]}', "is no cell of a notebook"),
    ],
)
def test_a_broken_notebook_is_refused_in_one_line(text, rule, tmp_path):
    path = tmp_path / "notes.ipynb"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(SymbalanceError, match=rule) as refusal:
        check(path, LETTERS)
    assert "\n" not in str(refusal.value)


def test_what_a_notebook_computes_is_not_read_and_never_run(tmp_path):
    path = tmp_path / "notes.ipynb"
    cells = """{"cells": [
      {"cell_type": "code", "source": ["x = 1\\n", "open('made', 'w')"], "outputs": [{"text": "x = 5"}]},
      {"cell_type": "markdown", "source": "then\\n$\\\\sin^2\\\\theta+\\\\cos^2\\\\theta=1$"}]}"""
    path.write_text(cells, encoding="utf-8")
    (verdict,) = check(path, LETTERS).verdicts
    assert (verdict.verdict, verdict.cell) == ("holds", (2, 2))
    assert list(tmp_path.iterdir()) == [path]
