"""`symbalance emit` as a user meets it: what it writes, what it refuses, nothing half-written."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import symbalance as sb
from symbalance.cli import run


def emitted(capsys, *arguments: str) -> str:
    """Run emit to stdout, and return what it prints."""
    code = run(["emit", *arguments])
    out, err = capsys.readouterr()
    assert (code, err) == (0, "")
    return out


def refused(capsys, *arguments: str) -> str:
    """Run emit, which must refuse, and return its one line."""
    assert run(["emit", *arguments]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    return err


def test_a_written_module_runs_alone_and_is_the_function_in_memory(tmp_path):
    """In an interpreter that can import neither symbalance nor SymPy."""
    path = tmp_path / "v8.py"
    outputs = "couple.vertical,couple.lateral"
    assert (
        run(["emit", "v8-90", "--target", "numpy", "--outputs", outputs, "--order", "4", "-o", str(path)])
        == 0
    )
    program = (
        "import sys; sys.modules['sympy'] = sys.modules['symbalance'] = sys.modules['mpmath'] = None\n"
        "import pickle, v8; assert pickle.loads(pickle.dumps(v8.evaluate)) is v8.evaluate\n"
        "v8.self_test(); print(v8.evaluate(0.5, mass=2.0, pitch=0.1)['couple.lateral'].hex())"
    )
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", program],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    made = sb.to_function(sb.balance(sb.load("v8-90"), 4), outputs=outputs.split(","))
    assert done.stdout.strip() == made(0.5, mass=2.0, pitch=0.1)["couple.lateral"].hex()


def test_only_what_was_asked_is_there(capsys):
    text = emitted(capsys, "v12-60", "--target", "numpy")
    assert "force.vertical" in text
    assert "couple." not in text
    assert "on_grid" not in text
    assert "orders 6, 12, 18, 24" in text
    assert "def on_grid" in emitted(capsys, "v12-60", "--target", "numpy", "--uniform-grid")


def test_a_tolerance_leaves_orders_out_and_says_by_how_much(capsys):
    text = emitted(capsys, "inline-4", "--target", "numba", "--tolerance", "1e-3")
    assert "orders 2, 4;" in text
    assert "the orders left out sum to at most 0.00" in " ".join(text.split())
    every = emitted(capsys, "inline-4", "--target", "numba")
    assert "orders 2, 4, 6, 8, 10, 12, 14, 16, 18" in every


def test_a_ratio_overrides_the_engines(capsys):
    assert "lambda = l/r = 3.5;" in emitted(capsys, "inline-4", "--target", "numpy", "--ratio", "7/2")


def test_c_writes_its_header_beside_it(tmp_path):
    path = tmp_path / "six.c"
    assert run(["emit", "inline-6", "--target", "c", "-o", str(path)]) == 0
    assert sorted(p.name for p in tmp_path.iterdir()) == ["six.c", "six.h"]
    assert '#include "six.h"' in path.read_text(encoding="utf-8")


def test_two_files_appear_together_or_not_at_all(tmp_path, capsys):
    (tmp_path / "six.h").mkdir()
    path = tmp_path / "six.c"
    assert "cannot be written (it is a directory)" in refused(
        capsys, "inline-6", "--target", "c", "-o", str(path)
    )
    assert [p.name for p in tmp_path.iterdir()] == ["six.h"]


def test_an_engines_name_cannot_end_a_comment(tmp_path, capsys):
    path = tmp_path / "bad.toml"
    path.write_text(
        'name = \'x */ """ + evil()\'\n[crank_train]\nratio = 4\n[layout]\nfiring_order = [1, 2]\n',
        encoding="utf-8",
    )
    text = emitted(capsys, str(path), "--target", "numpy", "--outputs", "piston.displacement")
    assert '""" +' not in text
    assert "*/" not in text
    namespace: dict = {"__name__": "made"}
    exec(text, namespace)
    assert namespace["evaluate"](np.pi) == 2.0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("v12-60", "--target", "numpy", "-o", "x.c"), "must end in .py"),
        (("v12-60", "--target", "c", "-o", "x"), "must end in .c"),
        (("v12-60", "--target", "c"), "writes two files"),
        (("v12-60", "--target", "numpy", "--outputs", "force.up"), "output 'force.up': is unknown"),
        (("v12-60", "--target", "numpy", "--outputs", ""), "is unknown"),
        (("v12-60", "--target", "numpy", "--tolerance", "0"), "must be a positive number"),
        (("v12-60", "--target", "numpy", "--tolerance", "nan"), "must be a positive number"),
        (("v12-60", "--target", "numpy", "--tolerance", "small"), "must be a positive number"),
        (("v12-60", "--target", "numpy", "--order", "0"), "whole number from 1 to 1000"),
        (("v12-60", "--target", "numpy", "--order", "six"), "must be a whole number"),
        (("v12-60", "--target", "numpy", "--order", "6", "--tolerance", "1"), "not allowed with"),
        (("v12-60", "--target", "numpy", "--ratio", "1"), "longer than the crank"),
        (("no-such", "--target", "numpy"), "no-such"),
        (("v12-60",), "--target"),
        (("v12-60", "--target", "numpy", "-o", "no/such/folder/x.py"), "cannot be written"),
    ],
)
def test_refusals(arguments, words, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert words in refused(capsys, *arguments)
    assert not list(tmp_path.iterdir())


def test_an_engine_without_a_ratio_says_how_to_give_one(tmp_path, capsys):
    path = Path(tmp_path / "twin.toml")
    path.write_text("[layout]\nfiring_order = [1, 2]\n", encoding="utf-8")
    assert "has no rod ratio" in refused(capsys, str(path), "--target", "numpy")
    assert "evaluate" in emitted(capsys, str(path), "--target", "numpy", "--ratio", "4")
