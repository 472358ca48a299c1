"""Letters that swing in one section are not what stands still, or moves otherwise, in another one."""

import pytest

from tests.checked_pages import verdicts_in

SHAFT = r"""## 1. The shaft as a spring

A shaft twisted by a torque $T$ turns through $\theta = TL/(GJ)$. Its torsional stiffness is

$$ k = \frac{T}{\theta} = \frac{GJ}{L}, \qquad J = \frac{\pi d^4}{32}. $$

## 2. Shafts in series

If two lengths carry the same torque, their twists add:

$$ \theta = \theta_1+\theta_2 = \frac{T}{k_1}+\frac{T}{k_2}. $$

## 3. Two discs on a free shaft

Engine flywheel $I_1$ and propeller $I_2$, nothing held. The equations of motion are

$$
\begin{aligned}
I_1\ddot\theta_1 + k(\theta_1-\theta_2) &= 0,\\
I_2\ddot\theta_2 - k(\theta_1-\theta_2) &= 0.
\end{aligned}
$$

"""


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (
            r"The frequency equation is $\omega^2\left[I_1 I_2\,\omega^2 - k(I_1+I_2)\right] = 0$.",
            r"The frequency equation is $\omega^2\left[I_1 I_2\,\omega^2 - k(I_1-I_2)\right] = 0$.",
        ),
        (
            r"The natural frequency is $\omega_n = \sqrt{\frac{k(I_1+I_2)}{I_1I_2}}$.",
            r"The natural frequency is $\omega_n = \sqrt{\frac{k I_1I_2}{I_1+I_2}}$.",
        ),
        (
            r"Adding them, $I_1\ddot\theta_1 + I_2\ddot\theta_2 = 0$.",
            r"Adding them, $I_1\ddot\theta_1 - I_2\ddot\theta_2 = 0$.",
        ),
    ],
)
def test_two_discs_below_two_shafts_in_series(right, wrong):
    proved = verdicts_in(SHAFT + right)
    assert proved[-1] in ("holds", "conditional")
    assert "refuted" not in proved
    assert verdicts_in(SHAFT + wrong)[-1] not in ("holds", "conditional", "definition", "premise")


def test_the_inertia_of_a_disc_is_data():
    page = (
        SHAFT + r"Take $I_1 = 1.8$ kg m² and $I_2 = 4.5$ kg m². Then $I_1I_2/(I_1+I_2) = NUMBER$ kg m²."
    )
    assert verdicts_in(page.replace("NUMBER", "1.286"))[-3:-1] == ["premise", "definition"]
    assert verdicts_in(page.replace("NUMBER", "1.286"))[-1] in ("holds_to_order", "conditional")
    assert verdicts_in(page.replace("NUMBER", "1.386"))[-1] == "refuted"


PISTON = r"""## 2. ピストン

上死点からの変位を $x$、クランク角を $\theta$ とすると $x = r(1-\cos\theta)$。

## 4. 一自由度系

運動方程式は $m\ddot{x}+kx = 0$。解を $x = A\cos\omega_n t$ とおくと CLAIM。
"""


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [(r"$k-m\omega_n^2 = 0$", "holds"), (r"$\omega_n = \sqrt{k/m}$", "holds")],
)
def test_an_oscillator_below_the_piston_has_its_own_x(claim, verdict):
    verdicts = verdicts_in(PISTON.replace("CLAIM", claim))
    assert verdicts[1:] == ["condition", "definition", verdict]


def test_the_acceleration_of_the_piston_keeps_its_x():
    page = r"""## 1. Displacement

$$x = r\cos\theta$$

$$\varphi = \arcsin(\lambda\sin\theta)$$

## 2. Acceleration

The rates are $CLAIM$.
"""
    for right, wrong in (
        (
            r"\ddot x = -r\dot\theta^2\cos\theta - r\ddot\theta\sin\theta",
            r"\ddot x = -r\dot\theta^2\cos\theta + r\ddot\theta\sin\theta",
        ),
        (
            r"\dot\varphi = \lambda\dot\theta\cos\theta/\cos\varphi",
            r"\dot\varphi = \lambda\dot\theta\sin\theta/\cos\varphi",
        ),
    ):
        assert verdicts_in(page.replace("CLAIM", right))[-1] in ("holds", "conditional")
        assert verdicts_in(page.replace("CLAIM", wrong))[-1] == "refuted"


def test_a_gear_ties_two_angles_in_every_section():
    page = r"""## 1. Gear

The wheels turn by $\theta_1 = i\theta_2$.

## 2. Rates

So $\dot\theta_1 = CLAIM$.
"""
    assert verdicts_in(page.replace("CLAIM", r"i\dot\theta_2"))[-1] in ("holds", "conditional")
    assert verdicts_in(page.replace("CLAIM", r"\dot\theta_2/i"))[-1] == "refuted"
