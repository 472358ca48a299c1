"""The speed of an angle that is a part or a multiple of another one."""

import pytest

import symbalance as sb

PAGES = [
    (
        "$\\varphi = \\theta/2$: $\\frac{d\\varphi}{dt} = SPEED$, $\\omega = \\dot\\theta$.\n",
        "\\omega",
        "\\omega/2",
    ),
    (
        "The cam angle is $\\varphi = \\theta/2$ where $\\theta$ is the crank angle and $\\omega$ the "
        "angular speed of the crank. Then $\\dot\\varphi = SPEED$.\n",
        "\\omega",
        "\\omega/2",
    ),
    (
        "The crank is at θ = ωt, the cam at φ = θ/2. Then $\\dot\\varphi = SPEED$.\n",
        "\\omega",
        "\\omega/2",
    ),
    (
        "$\\dot\\varphi = SPEED$ because $\\varphi = \\theta/2$ and $\\theta = \\omega t$.\n",
        "\\omega",
        "\\omega/2",
    ),
    (
        "Die Nockenwelle steht bei $\\varphi = \\theta/2$. Dann ist $\\dot\\varphi = SPEED$, denn "
        "$\\omega = \\dot\\theta$.\n",
        "2\\omega",
        "\\omega/2",
    ),
    (
        "Soit $\\psi = 2\\theta$ ; $\\dot\\psi = SPEED$ avec $\\dot\\theta = \\omega$.\n",
        "\\omega",
        "2\\omega",
    ),
]
OTHERS = [
    "$\\varphi = \\theta/2$. The gas force depends on $\\dot\\varphi = \\omega_c$.\n",
    "$\\varphi = \\theta/2$, $\\theta$ being the crank angle. A shaft has $\\dot\\varphi = \\Omega$.\n",
]


def _verdicts(page):
    return [link["verdict"] for link in sb.check(page, {}).data()["links"]]


@pytest.mark.parametrize(("page", "wrong", "right"), PAGES)
def test_the_speed_of_a_part_of_an_angle(page, wrong, right):
    assert "refuted" in _verdicts(page.replace("SPEED", wrong))
    assert not {"refuted", "undecided"} & {*_verdicts(page.replace("SPEED", right))}


@pytest.mark.parametrize("page", OTHERS)
def test_a_speed_with_a_letter_of_its_own(page):
    assert "refuted" not in _verdicts(page)
