"""P = T n/9549 and T = 9550 P/n are one formula, its constant rounded; T = 955 P/n is another."""

from pathlib import Path

import pytest

from tests.checked_pages import last_verdict

SYMBOLS = """[symbols]
P = "power [kW]"
T = "torque [N m]"
n = "speed [rpm]"
"""


@pytest.mark.parametrize("again", ["T = 9550 P/n", "P = 2\\pi T n/60000", "n = 9549.3 P/T"])
def test_the_same_formula_with_its_constant_rounded_holds(tmp_path: Path, again: str):
    page = f"The power is $P = \\frac{{T n}}{{9549}}$. In other words ${again}$."
    assert last_verdict(tmp_path, page, SYMBOLS) in ("holds_to_order", "conditional", "holds")


@pytest.mark.parametrize("wrong", ["T = 955 P/n", "T = 9549 n/P", "P = 2\\pi T n/6000", "P = T n/9459"])
def test_another_constant_does_not(tmp_path: Path, wrong: str):
    page = f"The power is $P = \\frac{{T n}}{{9549}}$. In other words ${wrong}$."
    assert last_verdict(tmp_path, page, SYMBOLS) == "refuted"


@pytest.mark.parametrize("rule", ["T n/5252", "9549 T/n", "T n/955"])
def test_declared_units_tell_a_wrong_constant(tmp_path: Path, rule: str):
    assert last_verdict(tmp_path, f"The rule is $P = {rule}$.", SYMBOLS) == "refuted"


@pytest.mark.parametrize("rule", ["T n/9549", "T n/9550", "2\\pi T n/60000"])
def test_declared_units_allow_the_right_one(tmp_path: Path, rule: str):
    assert last_verdict(tmp_path, f"The rule is $P = {rule}$.", SYMBOLS) != "refuted"
