"""The standard quotient of a quantity in words upside down is refuted, unless its letters are others."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

WRONG = [
    r"The stress is $\sigma = A/F$.",
    r"Die Zugspannung ist $\sigma = A/F$.",
    r"The stress is $\sigma = A/F$, $F = 12$ kN, $A = 300$ mm².",
    r"The torque is $M = P\omega$.",
    r"Das Drehmoment ist $M = \frac{\omega}{P}$.",
    r"The torque is $T = F/r$.",
    r"The stiffness is $c = x/F$.",
    r"Die Federsteifigkeit ist $c = \frac{s}{F}$.",
    r"The density is $\rho = V/m$.",
    r"Die Dichte ist $\rho = V/m$.",
    r"The pressure is $p = A/F$.",
    r"The period is $T = \frac{\omega}{2\pi}$.",
    r"The angular speed is $\omega = r/v$.",
]
RIGHT = [
    r"The stress is $\sigma = F/A$.",
    r"The torque is $M = P/\omega$.",
    r"The torque is $M = F r$.",
    r"The stiffness is $c = F/x$.",
    r"The density is $\rho = m/V$.",
    r"The period is $T = 2\pi/\omega$.",
    r"The compliance is $c = x/F$.",
    r"The reciprocal stiffness is $c = x/F$.",
    r"The specific volume is $v = V/m$.",
    r"The torque is $M = P\omega$, where $P$ is the angular momentum per radian.",
    r"The torque is proportional to $M = P\omega$.",
    r"With the reaction $A$ and the cross section $F$ the stress is $\sigma = A/F$.",
    r"Die Spannung ist $\sigma = A/F$ mit der Auflagerkraft $A$ und der Fläche $F$.",
    r"The stress is $\sigma = A/F$ with $F = 300$ mm² and $A = 12$ kN.",
    r"The stress is $\sigma = A/F$ with \(F = 300\,\mathrm{mm^2}\) and $A = 12$ kN.",
]


def _verdicts(page: str) -> list[str]:
    return [link["verdict"] for link in check(page + "\n").data()["links"]]


@pytest.mark.parametrize("page", WRONG)
def test_the_quotient_upside_down_is_refuted(page: str):
    assert _verdicts(page)[0] == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_what_may_be_right_is_not_accused(page: str):
    assert "refuted" not in _verdicts(page)
