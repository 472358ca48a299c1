"""The resultant of perpendicular components is no plain sum of them, unless they are vectors."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

WRONG = [
    "The components $F_x$ and $F_y$ are perpendicular. The resultant is $F = F_x + F_y$.",
    "The resultant of the perpendicular components is $F = F_x + F_y$.",
    "The forces $F_1$ and $F_2$ act at right angles. Their resultant is $F = F_1 + F_2$.",
    "Die rechtwinkligen Komponenten haben die Resultierende $F = F_1 + F_2$.",
    "Les composantes perpendiculaires ont pour résultante $F = F_x + F_y$.",
    "直交する成分の合力は $F = F_x + F_y$ である。",
]
RIGHT = [
    r"The resultant of the perpendicular components is $F = \sqrt{F_x^2 + F_y^2}$.",
    "The resultant of the forces perpendicular to the beam is $F = F_1 + F_2$.",
    "The resultant of $F_1$ and $F_2$ in line is $F = F_1 + F_2$.",
    r"The resultant vector is $\vec F = \vec F_x + \vec F_y$.",
    r"The resultant is $\mathbf{F} = \mathbf{F}_x + \mathbf{F}_y$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_a_plain_sum_is_refuted(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_other_sums_are_not(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] != "refuted"
