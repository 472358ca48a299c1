"""A number put in for ω may be of a speed that the paragraph names; any other number is a slip."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PAGE = """At N = 3000 rpm the angular speed is $\\omega = \\pi N/30 = 314.2$ rad/s.

The maker claims $P = 85$ kW at 5500 rpm. The mean torque for it is
$$ C = \\frac{{P}}{{\\omega}} = \\frac{{85\\,000}}{{{speed}}} = {result}\\ \\text{{N m}} . $$
"""


@pytest.mark.parametrize(
    ("speed", "result", "is_right"),
    [("576.0", "147.6", True), ("567.0", "149.9", False), ("476.0", "178.6", False)],
)
def test_a_speed_of_the_paragraph_is_put_in(tmp_path, speed, result, is_right):
    page = tmp_path / "page.md"
    page.write_text(PAGE.format(speed=speed, result=result), encoding="utf-8")
    words = [verdict.verdict for verdict in check(page, fixes=False).verdicts]
    assert ("refuted" in words) is not is_right
