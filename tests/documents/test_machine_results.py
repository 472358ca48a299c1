"""Results of linear algebra and of time steps as they are read, and all results as programs get them.

Words, keys and places are compared exactly, numbers nearly. `pytest --update` rewrites the golden files,
and whoever does so reads the change.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from symbalance.document.result import to_csv, to_json, to_text
from tests.nearly import GOLDEN, compare, steady
from tests.results import EXAMPLES

NAMES = ["campbell", "critical-speeds", "torsional-chain", "unbalance-response", "whirl", "crankshaft"]
"""Not `natural-modes`: a round shaft bends as willingly in one direction as in any other."""
PROGRAMS = sorted(set(EXAMPLES) - {"natural-modes", "presets", "pressure-trace"})
"""Presets come and go."""
TOO_MUCH = {"whirl", "sensitivities", "sensitivities-at-speed", "design-unlike"}
"""JSON of shapes, whose phase each machine chooses, or of a hundred pages."""


@pytest.mark.spread("campbell", "critical-speeds", "torsional-chain", "unbalance-response", "whirl")
@pytest.mark.parametrize("name", NAMES)
def test_text(name: str, request: pytest.FixtureRequest) -> None:
    path, text = GOLDEN / f"machine-{name}.txt", to_text(steady(name), width=80)
    if request.config.getoption("--update"):
        path.write_text(text, encoding="utf-8")
    compare(path, text)


@pytest.mark.spread("critical-speeds", "balance", "document-table", "verdict", "sweep")
@pytest.mark.parametrize("name", PROGRAMS)
def test_data(name: str, request: pytest.FixtureRequest) -> None:
    """Each row and each key, in their order."""
    result = steady(name)
    forms = {"csv": to_csv(result).replace("\r\n", "\n")}
    if name not in TOO_MUCH:
        forms["json"] = to_json(result)
    for ending, text in forms.items():
        path = GOLDEN / f"data-{name}.{ending}"
        if request.config.getoption("--update"):
            path.write_text(text, encoding="utf-8")
        compare(path, text)


@pytest.mark.parametrize(
    ("old", "new", "same"),
    [
        ("mode 3  19.197 Hz", "mode 3   19.21 Hz", True),
        ("mode 3  19.197 Hz", "mode 3  19.6 Hz", False),
        ("−19.197", "19.197", False),
        ("mode 3  forward", "mode 3  backward", False),
        ("1  2  3", "1  2", False),
        ("1: 15.4, 0.5: 11.7", "1: 15.4, 1.5: 11.7", False),
        ("4.123e−4 −", "4.13e−4 −", True),
        ('"a": 4.1, "b": 1.2345678901234e-17', '"a": 4.1, "b": -3.1e-18', True),
        ('"a": 4.1, "b": 2', '"a": 4.1, "c": 2', False),
        ("x ─────", "x ───", True),
        ("axis U", "axis V", False),
        ('{"a": [1.2345678901234,2]}', '{"a": [1.2345678901235,2]}', True),
        ("a,1.2345678901234,b", "a,1.2445678901234,b", True),
        ("a,1.2345678901234,b", "a,1.2545678901234,b", False),
        ("a,1.2345678901234,b", "a,1.2345678901234,c", False),
    ],
)
def test_what_counts_as_the_same(tmp_path: Path, old: str, new: str, same: bool) -> None:
    path = tmp_path / "old.txt"
    path.write_text(old, encoding="utf-8")
    if same:
        return compare(path, new)
    with pytest.raises(AssertionError, match=r"old\.txt: after"):
        compare(path, new)
    return None
