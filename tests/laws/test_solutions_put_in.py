"""What words call a solution or a root satisfies the equation that they name, or is refuted."""

import pytest

from symbalance.notes.checking import check

FREE = "The equation $\\ddot x + ω^2 x = 0$ has the solution\n\n"
QUADRATIC = "$x^2-2x-8 = 0$\n\n"
HOLDS = ("holds", "holds_to_order", "conditional")


def last_word(page: str) -> str:
    checked = check(page + "\n", {})
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(
    "page",
    [
        FREE + r"$x = A\cos 2ωt$",
        FREE.strip() + r" $x(t) = A\cos 2ωt$.",
        FREE + r"$$x = A\cos(2ωt + ε)$$",
        "$\\dot x + 3x = 0$\n\nIts solution is $x = Ce^{3t}$",
        r"Die Lösung von $\ddot φ + \frac{c}{J} φ = 0$ lautet $φ = A\cos(\frac{c}{J}\,t)$.",
        "The roots of $x^2-5x+6=0$ are $x_1 = 2$ and $x_2 = 4$.",
        "Die Nullstellen von $λ^2 - 3λ + 2 = 0$ sind $λ_1 = 1$, $λ_2 = -2$.",
        r"The roots of $m s^2 + k = 0$ are $s_{1,2} = \pm i\sqrt{m/k}$.",
        QUADRATIC + r"$x_{1,2} = 1 \pm 2$",
        r"$x^2 - 2x - 1 = 0 \Rightarrow x_{1,2} = 1 \pm \sqrt{3}$",
        "$x^2 + p x + q = 0$\n\n" + r"$x_{1,2} = -\frac{p}{2} \pm \sqrt{\frac{p^2}{4} + q}$",
        r"$x^2 - 4x + 3 = 0$, so $x_{1,2} = 2 \pm 2$.",
    ],
)
def test_what_does_not_satisfy_its_equation_is_refuted(page):
    assert last_word(page) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        FREE + r"$x = A\cos ωt + B\sin ωt$",
        FREE + r"$$x = A\cos(ωt + ε)$$",
        "$\\dot x + 3x = 0$\n\nIts solution is $x = Ce^{-3t}$",
        "The roots of $x^2-5x+6=0$ are $x_1 = 2$ and $x_2 = 3$.",
        "Les racines de $x^2 - 4x + 3 = 0$ sont $x_1 = 1$ et $x_2 = 3$.",
        r"The roots of $m s^2 + k = 0$ are $s_{1,2} = \pm i\sqrt{k/m}$.",
        QUADRATIC + r"$x_{1,2} = 1 \pm 3$",
        "$x^2 - 2x - 1 = 0$\n\n" + r"$x_{1,2} = 1 \pm 1{,}41$",
        r"Aus $x^2 - 4x + 3 = 0$ folgt $x_{1/2} = 2 \pm 1$.",
        "$x^2 + p x + q = 0$\n\n" + r"$x_{1,2} = -\frac{p}{2} \pm \sqrt{\frac{p^2}{4} - q}$",
    ],
)
def test_what_satisfies_it_holds(page):
    assert last_word(page) in HOLDS


@pytest.mark.parametrize(
    "page",
    [
        r"The equation $\ddot x + ω_0^2 x = 0$ has the solution $x = A\cos(Ωt + ε)$.",
        "$m\\ddot x + b\\dot x + k x = 0$\n\nFor small damping the solution is "
        r"$x = A e^{-bt/(2m)}\cos(\sqrt{k/m}\,t)$.",
        "$m\\ddot x + k x = F\\cosΩt$\n\nThe steady-state solution is $x = X \\cosΩt$.",
        "$x^2 - 4 = 0$\n\nTwo cars have $x_1 = 3$ and $x_2 = 5$.",
        "$x^2 - 4 = 0$\n\nThe table lists them. " + r"$x_{1,2} = 5 \pm 1$ is the measured range.",
    ],
)
def test_what_may_be_another_motion_or_letter_is_not_accused(page):
    assert last_word(page) not in ("refuted", "contradiction", *HOLDS)


@pytest.mark.parametrize(
    ("page", "is_wrong"),
    [
        ("Integrating $a = 2t$ gives $v = 2t^2$.", True),
        (r"Integration von $a = A\cos ωt$ liefert $v = Aω\sin ωt + C$.", True),
        (r"Differentiating $x = r\cos ωt$ gives $v = -r\sin ωt$.", True),
        (r"Ableiten von $x = r\cos ωt$ nach der Zeit ergibt $v = rω\sin ωt$.", True),
        ("Integrating $a = 2t$ gives $v = t^2 + v_0$.", False),
        (r"Integration von $a = A\cos ωt$ liefert $v = \frac{A}{ω}\sin ωt + C$.", False),
        (r"Differentiating $x = r\cos ωt$, we get $v = -rω\sin ωt$.", False),
        (r"Differentiating $x = r\cos ωt$ with respect to $ω$ gives $q = -r t\sin ωt$.", False),
        (r"Differentiating $x = r\cosθ$ gives $v = -rω\sinθ$.", False),
        (r"$ω = 3$ 1/s. Differentiating $x = r\cos ωt$ gives $v = -3r\sin ωt$.", False),
    ],
)
def test_a_derivative_or_integral_that_words_name_is_worked_out(page, is_wrong):
    assert (last_word(page) == "refuted") is is_wrong
