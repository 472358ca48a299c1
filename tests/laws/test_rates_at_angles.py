"""A rate in numbers at an angle is that of its formula there, and not of a piston at rest."""

from pathlib import Path

import pytest

from tests.checked_pages import last_verdict

SYMBOLS = """[symbols]
'\\theta' = "crank angle from top dead centre [rad]"
x = "piston displacement from top dead centre [m]"
r = "crank radius [mm]"
'\\lambda' = "ratio of crank radius to rod length"
'\\omega' = "angular velocity of the crank [rad/s]"
"""
DATA = "With $r = 50$ mm, $\\lambda = 0.25$ and $\\omega = 314.2$ rad/s at $\\theta = 60^\\circ$"
RATES = {
    "velocity": (
        "$$\\dot x = r\\omega(\\sin\\theta + \\frac{\\lambda}{2}\\sin 2\\theta)$$",
        "$$\\dot x = 15.71\\,(0.8660 + {}\\times 0.8660)$$",
        ("0.125", "0.25"),
    ),
    "acceleration": (
        "$$\\ddot x = r\\omega^2(\\cos\\theta + \\lambda\\cos 2\\theta)$$",
        "$$\\ddot x = 4936\\,(0.5 - {}\\times 0.5)$$",
        ("0.25", "0.125"),
    ),
}


@pytest.mark.parametrize("rate", RATES.values(), ids=RATES)
def test_a_rate_in_numbers_at_an_angle(tmp_path: Path, rate: tuple[str, str, tuple[str, str]]):
    formula, numbers, (right, wrong) = rate
    page = f"{DATA}\n\n{formula}\n\n{numbers}"
    assert last_verdict(tmp_path, page.replace("{}", right), SYMBOLS) in ("conditional", "holds_to_order")
    assert last_verdict(tmp_path, page.replace("{}", wrong), SYMBOLS) == "refuted"
