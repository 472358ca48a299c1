r"""What a letter is at one moment is no constant: its mean, its work and its derivative are others."""

import pytest

from symbalance.checking import check

PROVED = {"holds", "conditional", "holds_to_order"}
MOMENTS = [
    "At $\\theta = 90°$ the torque is $M = 400$ N m.",
    "At 90° the torque is $M = 400$ N m.",
    "The torque is $M = 400$ N m at 30°.",
    "At top dead centre the torque is $M = 400$ N m.",
    "The peak torque is $M = 400$ N m.",
    "Bei 60° nach OT ist das Drehmoment $M = 400$ Nm.",
    "Das größte Drehmoment ist $M = 400$ Nm.",
    "À $\\theta = 90°$ le couple vaut $M = 400$ N m.",
    "La coppia massima è $M = 400$ Nm.",
]
CLAIMS = [
    "The mean torque is $\\frac{1}{2\\pi}\\int_0^{2\\pi} M\\,d\\theta = 400$ N m.",
    "$W = \\int_0^{2\\pi} M\\,d\\theta = 2513$ J",
    "$\\frac{dM}{d\\theta} = 0$",
]


@pytest.mark.parametrize("moment", MOMENTS)
@pytest.mark.parametrize("claim", CLAIMS)
def test_what_is_had_at_one_moment_is_not_had_all_the_time(moment, claim):
    assert check(f"{moment}\n\n{claim}").verdicts[-1].verdict not in PROVED


@pytest.mark.parametrize("claim", CLAIMS)
@pytest.mark.parametrize(
    "always", ["The torque is $M = 400$ N m.", "Das Drehmoment ist konstant, $M = 400$ Nm."]
)
def test_what_is_constant_is(always, claim):
    assert check(f"{always}\n\n{claim}").verdicts[-1].verdict in PROVED


@pytest.mark.parametrize(
    ("given", "claim"),
    [
        ("At $t = 0$ the speed is $\\omega = 100$ rad/s.", "$\\int_0^{2} \\omega\\,dt = 200$"),
        ("The peak speed is $v = 15$ m/s.", "$s = \\int_0^{0.01} v\\,dt = 0.15$ m"),
        ("At 60° after TDC the piston has gone $x = 20$ mm.", "$\\frac{dx}{d\\theta} = 0$"),
    ],
)
def test_so_it_is_with_paths_and_speeds(given, claim):
    assert check(f"{given}\n\n{claim}").verdicts[-1].verdict not in PROVED
