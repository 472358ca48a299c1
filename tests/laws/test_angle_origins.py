"""θ = 0 at top dead centre says where the angle counts from: no relation in θ rests on it."""

import pytest

from tests.checked_pages import last_in, verdicts_in

ORIGINS = [
    "With $\\theta = 0$ at TDC and $\\lambda = r/l$,",
    "The piston is at TDC for $\\theta = 0$, and $\\lambda = r/l$;",
    "The angle counts from TDC ($\\theta = 0$ there), $\\lambda = r/l$;",
    "Es ist $\\theta = 0$ im OT und $\\lambda = r/l$;",
    "上死点で $\\theta = 0$ とし,$\\lambda = r/l$ とする。",
]
MOTION = "$x = r(1-\\cos\\theta) + \\frac{\\lambda r}{2}\\sin^2\\theta$."


@pytest.mark.parametrize("origin", ORIGINS)
def test_a_rate_is_judged_at_every_angle(origin):
    page = f"{origin} {MOTION} Then $\\dot x = r\\omega(\\sin\\theta + {{}}\\sin 2\\theta)$."
    assert last_in(page.replace("{}", "\\frac{\\lambda}{2}")) in ("conditional", "holds")
    assert last_in(page.replace("{}", "\\lambda")) == "refuted"


def test_a_rate_is_judged_at_every_angle_behind_a_number_of_it():
    page = (
        "For $\\theta = 180^\\circ$ the piston stands below. With $x = r(1-\\cos\\theta)$ "
        "we have $\\dot x = r\\omega {}$."
    )
    assert last_in(page.replace("{}", "\\sin\\theta")) in ("conditional", "holds")
    assert last_in(page.replace("{}", "\\sin 2\\theta")) == "refuted"


def test_the_rod_angle_is_judged_at_every_angle():
    page = (
        "The rod of $\\lambda = r/l < 1$ has the angle $\\phi$ to the cylinder axis, $|\\phi| < \\pi/2$. "
    )
    page += "We put $\\theta = 0$ in the dead centre. $\\sin\\phi = \\lambda\\sin\\theta$, so "
    right = last_in(page + "$\\cos\\phi = \\sqrt{1-\\lambda^2\\sin^2\\theta}$.")
    assert right in ("conditional", "holds")
    assert last_in(page + "$\\cos\\phi = \\sqrt{1+\\lambda^2\\sin^2\\theta}$.") == "refuted"


def test_a_value_at_the_dead_centre_still_holds():
    page = "At TDC $\\theta = 0$, and "
    page += "$a = r\\omega^2(\\cos\\theta+\\lambda\\cos 2\\theta) = r\\omega^2({})$."
    assert verdicts_in(page.replace("{}", "1+\\lambda"))[-1] == "conditional"
    assert verdicts_in(page.replace("{}", "1-\\lambda"))[-1] == "refuted"
