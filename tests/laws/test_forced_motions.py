"""What stands below an equation of motion with a force satisfies it, as a motion or as an amplitude."""

import pytest

import symbalance as sb

SWING = r"$\ddot y + \omega^2 y = \sin\Omega t$"
MASS = r"$m\ddot x + k x = F\cos\Omega t$"
DAMPED = r"$m\ddot x + c\dot x + kx = F\cos\Omega t$"
PAIRS = [
    (
        f"{SWING}\n\n$y = ANSWER$\n",
        r"\frac{\sin\Omega t}{\Omega^2-\omega^2}",
        r"\frac{\sin\Omega t}{\omega^2-\Omega^2}",
    ),
    (
        f"{SWING}. Hence $y = ANSWER$.\n",
        r"\frac{\cos\Omega t}{\omega^2-\Omega^2}",
        r"-\frac{\sin\Omega t}{\Omega^2-\omega^2}",
    ),
    (
        f"{SWING}\n\n$y = A\\cos\\omega t + B\\sin\\omega t + ANSWER$\n",
        r"\frac{\sin\Omega t}{\Omega^2-\omega^2}",
        r"\frac{\sin\Omega t}{\omega^2-\Omega^2}",
    ),
    (
        f"{MASS}\n\nThe response is $x = X\\cos\\Omega t$, $X = ANSWER$.\n",
        r"\frac{F}{m\Omega^2-k}",
        r"\frac{F}{k-m\Omega^2}",
    ),
    (
        f"{MASS}. Ansatz: $x = X\\cos\\Omega t$, also $ANSWER = F$.\n",
        r"(k+m\Omega^2) X",
        r"(k-m\Omega^2) X",
    ),
    (
        f"{MASS}\n\nPartikuläre Lösung: $x_p(t) = ANSWER\\cos\\Omega t$\n",
        r"\frac{F/m}{\Omega^2 - k/m}",
        r"\frac{F/m}{k/m - \Omega^2}",
    ),
    (
        f"{MASS} avec $\\omega_0^2 = k/m$. La réponse est $x = ANSWER\\cos\\Omega t$.\n",
        r"\frac{F}{k}\frac{1}{1 + \Omega^2/\omega_0^2}",
        r"\frac{F}{k}\frac{1}{1 - \Omega^2/\omega_0^2}",
    ),
    (
        f"{DAMPED}\n\nWith $x = X\\cos(\\Omega t - \\varepsilon)$ one gets $X = ANSWER$.\n",
        r"\frac{F}{\sqrt{(k-m\Omega^2)^2 + c^2\Omega}}",
        r"\frac{F}{\sqrt{(k-m\Omega^2)^2 + c^2\Omega^2}}",
    ),
    (
        f"{DAMPED}\n\n$x = X\\cos(\\Omega t - \\varepsilon)$ gives\n$\\tan\\varepsilon = ANSWER$.\n",
        r"\frac{k-m\Omega^2}{c\Omega}",
        r"\frac{c\Omega}{k-m\Omega^2}",
    ),
    (
        "運動方程式 $\\ddot x + \\omega_0^2 x = f\\cos\\Omega t$ より $x = ANSWER\\cos\\Omega t$\n",
        r"\frac{f}{\Omega^2-\omega_0^2}",
        r"\frac{f}{\omega_0^2-\Omega^2}",
    ),
    ("$\\ddot y + 4y = \\sin 3t$\n\n$y = ANSWER\\sin 3t$\n", r"\frac15", r"-\frac15"),
]
OTHERS = [
    f"{MASS}. The free vibration is $x_h = A\\cos\\omega t + B\\sin\\omega t$.\n",
    f"{MASS}. For low speeds the mass follows statically: $x = \\frac{{F}}{{k}}\\cos\\Omega t$.\n",
    f"{MASS}. Far above resonance, $x = -\\frac{{F}}{{m\\Omega^2}}\\cos\\Omega t$.\n",
    f"{MASS}. The driving point moves with $y = \\frac{{F}}{{k}}\\cos\\Omega t$.\n",
    f"{DAMPED}. Without damping the solution would be $x = \\frac{{F}}{{k-m\\Omega^2}}\\cos\\Omega t$.\n",
    "$\\ddot x + \\omega^2 x = f\\cos\\Omega t$. At resonance, $\\Omega = \\omega$, it is "
    "$x = \\frac{f}{2\\omega} t\\sin\\omega t$.\n",
]


def _verdicts(page):
    return [link["verdict"] for link in sb.check(page, {}).data()["links"]]


@pytest.mark.parametrize(("page", "wrong", "right"), PAIRS)
def test_an_answer_satisfies_the_equation_of_motion(page, wrong, right):
    assert "refuted" in _verdicts(page.replace("ANSWER", wrong))
    assert _verdicts(page.replace("ANSWER", right))[-1] in ("holds", "conditional")


@pytest.mark.parametrize("page", OTHERS)
def test_another_motion_beside_it_is_none_of_its_answers(page):
    assert "refuted" not in _verdicts(page)
