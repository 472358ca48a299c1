"""A torque times a bare number of revolutions over 5252 or 9549 is a power in hp or kW, no other is."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

RIGHT = [
    "In old money 398 lb-ft × 6000 / 5252 = 455 hp.",
    "That is 540 N m × 6000 / 9549 = 339 kW.",
    "That is P = 540 N m × 6000 / 9549 = 339 kW.",
]
WRONG = [
    "In old money 398 lb-ft × 6000 / 5252 = 545 hp.",
    "In old money 398 N m × 6000 / 5252 = 455 hp.",
    "That is 540 lb-ft × 6000 / 9549 = 339 kW.",
    "That is 540 N m × 628.3 / 9549 = 35.5 kW.",
]


def _words(tmp_path, line):
    page = tmp_path / "page.txt"
    page.write_text(f"{line}\n", encoding="utf-8")
    return [verdict.verdict for verdict in check(page, fixes=False).verdicts]


@pytest.mark.parametrize("line", RIGHT)
def test_a_power_by_its_constant_holds(tmp_path, line):
    assert _words(tmp_path, line)[-1] == "conditional"


@pytest.mark.parametrize("line", WRONG)
def test_one_in_other_units_is_refuted(tmp_path, line):
    assert _words(tmp_path, line)[-1] == "refuted"
