"""Sums of waves of one order are one wave: what they are said to be is decided without any premise."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

ABOVE = (
    r"The pistons of a twin, $P = m r\omega^2$, with $k x = P$, $x + y = m r$ and $x y = r^2$."
    "\n\n{}\n\nThe cylinders fire one after the other.\n"
)
SUMS = [
    (r"$F = P(\cos\varphi - \sin\varphi) = \sqrt2 P\cos(\varphi{}45°)$", "+", "-"),
    (r"$F = P\cos\varphi + P\cos(\varphi - 90°) = \sqrt2 P\cos(\varphi{}45°)$", "-", "+"),
    (r"$M = \frac{a}{2}\lambda P(\cos 2\varphi - \cos 2(\varphi - ANG°)) = 0$", "360", "270"),
    (r"$M_2 = a\lambda P(\cos 2\varphi + \cos(2\varphi - ANG°)) = 0$", "540", "360"),
    (
        r"$N = \frac{P\cos\varphi - P\cos(\varphi + 120°)}{2} = ANGP\cos(\varphi - 30°)$",
        r"\frac{\sqrt3}{2}",
        r"\sqrt3 ",
    ),
    (r"$S = P(\cos 4\varphi ANG \cos 4\varphi + \cos 4\varphi - \cos 4\varphi) = 0$", "-", "+"),
]
LOOKED_FOR = [
    r"The force vanishes where $F = P(\cos\varphi - \sin\varphi) = 0$.",
    r"Its maximum follows from $G = P(\cos\varphi - \sin\varphi) = 0$.",
    r"$F = P(\cos\varphi - \sin\varphi) = 0$ gives $\tan\varphi = 1$, $\varphi = 45°$.",
]


def _words(line: str) -> list[str]:
    return [verdict.verdict for verdict in check(ABOVE.replace("{}", line)).verdicts]


@pytest.mark.parametrize(("line", "right", "wrong"), SUMS)
def test_a_sum_of_waves_is_that_wave_and_no_other(line, right, wrong):
    line = line.replace("{}", "ANG")
    assert _words(line.replace("ANG", right))[-1] == "holds"
    assert _words(line.replace("ANG", wrong))[-1] == "refuted"


@pytest.mark.parametrize("line", LOOKED_FOR)
def test_an_angle_that_is_looked_for_is_none_of_every_angle(line):
    assert not {"refuted", "contradiction"} & {*_words(line)}


TWINS = """Forces of two parallel twins, m and r as usual, a the crank angle.

2) THE 360

  F1 = 2*m*r*w^2*cos a

3) {}

The right piston sits at a - 270.

  F1 = m*r*w^2*(cos a - sin a)
"""


@pytest.mark.parametrize("heading", ["THE 270", "A 270 CRANK", "TWIN WITH A 270° CRANK"])
def test_a_numbered_line_in_capitals_opens_another_twin(heading):
    verdicts = check(TWINS.format(heading)).verdicts
    assert "refuted" not in {verdict.verdict for verdict in verdicts}
    same = check(TWINS.format(heading.replace("270", "360"))).verdicts
    assert same[-1].verdict != "definition"
