"""Crank angles said by one angle, and sums over the cranks of the engine that a section is of."""

import pytest

from tests.checked_pages import last_in

FORCE = "The force of a cylinder is $F_1 = m r\\omega^2\\cos\\theta$.\n\n"


@pytest.mark.parametrize(
    ("heading", "right", "wrong"),
    [
        ("Two cylinders, cranks at $180^\\circ$", "0", "2m r\\omega^2\\cos\\theta"),
        ("Two cylinders, cranks at 0° and 180°", "0", "m r\\omega^2\\cos\\theta"),
        ("Three cylinders, cranks at 120°", "0", "m r\\omega^2\\cos\\theta"),
        ("Zwei Zylinder, Kurbeln um 180° versetzt", "0", "2m r\\omega^2\\cos\\theta"),
    ],
)
def test_forces_add_up_over_cranks_that_one_angle_says(heading, right, wrong):
    assert last_in(f"{FORCE}## {heading}\n\n$$\\sum F_1 = {right}$$") == "conditional"
    assert last_in(f"{FORCE}## {heading}\n\n$$\\sum F_1 = {wrong}$$") == "refuted"


def test_places_of_four_cylinders_are_none_of_six():
    page = (
        "## Four\n\n| k | 1 | 2 | 3 | 4 |\n|---|---|---|---|---|\n"
        "| $\\alpha_k$ | $0$ | $\\pi$ | $\\pi$ | $0$ |\n"
        "| $z_k$ | $3a$ | $a$ | $-a$ | $-3a$ |\n\n$$\\sum_k z_k\\cos\\alpha_k = 0$$\n\n"
        "## Six\n\nThe cranks $\\alpha_k$ stand at 0°, 120°, 240°, 240°, 120°, 0°. Then "
    )
    assert last_in(page + "$\\sum_k\\cos\\alpha_k = 0$.") == "conditional"
    assert last_in(page + "$\\sum_k\\cos 6\\alpha_k = 4$.") == "refuted"
    assert last_in(page + "$\\sum_k z_k\\cos\\alpha_k = a$.") == "undecided"
