"""A bare g has the unit of gravity: √(g/δ) is no speed, whether a number or words behind it say so."""

import pytest

import symbalance as sb

PAGES = [
    (
        "The sag is $\\delta = 2$ mm. With $g = 9.81$ it is $\\sqrt{g/\\delta} = 70.0$ UNIT.\n",
        "m/s",
        "rad/s",
    ),
    ("Static sag δ = 2 mm, so $\\sqrt{g/\\delta} = 70\\ \\mathrm{UNIT}$.\n", "m/s", "s^{-1}"),
    ("δ = 2 mm, so $\\omega_0 = \\sqrt{g/\\delta} = \\sqrt{9.81/0.002} = 70$ UNIT.\n", "m/s", "rad/s"),
    (
        "Die Durchsenkung ist $\\delta = 2$ mm, die Erdbeschleunigung $g$:"
        " $\\sqrt{g/\\delta} = 70$ UNIT.\n",
        "m/s",
        "1/s",
    ),
    (
        "La flèche est $\\delta = 2$ mm, la pesanteur $g$: $\\sqrt{g/\\delta} = 70$ UNIT.\n",
        "m/s",
        "rad/s",
    ),
    (
        "重力加速度を $g$、たわみを $\\delta = 2$ mm とすると $\\sqrt{g/\\delta} = 70$ UNIT となる。\n",
        "m/s",
        "1/s",
    ),
    ("A ball falls from $h = 2$ m, so $v = \\sqrt{2gh} = 6.26$ UNIT.\n", "m", "m/s"),
    ("A pendulum of $l = 0.5$ m has the period $2\\pi\\sqrt{l/g} = 1.42$ UNIT.\n", "m", "s"),
    (
        "The deflection under gravity is $\\delta=2$ mm and $\\omega_n = \\sqrt{g/\\delta}$ in UNIT.\n",
        "m/s",
        "rad/s",
    ),
    ("m = 2 kg, k = 800 N/m, and the frequency is $\\omega = \\sqrt{k/m}$ in UNIT.\n", "m/s", "rad/s"),
]
OTHERS = [
    "The gear ratio is g = 3 and the length l = 0.5 m, so $\\sqrt{g l} = 1.22$ (in roots of metres).\n",
    "Let M = 5 N m and n = 3000 rpm. The power is $P = M n/9550$ in kW.\n",
    "n = 3000 rpm, and $\\omega = 2\\pi n/60$ in rad/s.\n",
]


def _verdicts(page):
    return [link["verdict"] for link in sb.check(page, {}).data()["links"]]


@pytest.mark.parametrize(("page", "wrong", "right"), PAGES)
def test_a_root_with_gravity_is_in_its_unit(page, wrong, right):
    assert "refuted" in _verdicts(page.replace("UNIT", wrong))
    assert "refuted" not in _verdicts(page.replace("UNIT", right))


@pytest.mark.parametrize("page", OTHERS)
def test_another_g_and_formulas_between_numbers_are_not_accused(page):
    assert "refuted" not in _verdicts(page)
