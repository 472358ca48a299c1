"""The speed at which an order has its frequency is a datum, and the frequency behind it is judged."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PAGES = (
    ("The second order at n = 3000 rpm has the frequency f_2 = {} Hz.", "100", "50"),
    ("Die zweite Ordnung bei n = 3000 U/min hat die Frequenz f_2 = {} Hz.", "100", "200"),
    ("The second order at the speed N = 4500 rpm has the frequency f = {} Hz.", "150", "75"),
)


def _verdicts(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    return [each.verdict for each in check(page, fixes=False).verdicts]


@pytest.mark.parametrize(("text", "right", "wrong"), PAGES)
def test_the_speed_is_no_frequency_of_the_order(tmp_path, text, right, wrong):
    speed, frequency = _verdicts(tmp_path, text.format(right))
    assert speed in ("definition", "premise")
    assert frequency == "conditional"
    speed, frequency = _verdicts(tmp_path, text.format(wrong))
    assert speed in ("definition", "premise")
    assert frequency == "refuted"


def test_a_broken_order_at_a_speed_is_not_accused(tmp_path):
    text = "The order 2.5 of an engine at n = 3000 rpm has the frequency f = 2.5·50 = 125 Hz."
    assert "refuted" not in _verdicts(tmp_path, text)


def test_a_frequency_that_is_the_speed_is_still_refuted(tmp_path):
    text = "At 3000 rpm the second order has the frequency f_2 = 3000 rpm."
    assert _verdicts(tmp_path, text)[-1] == "refuted"
