"""A sign, a range or a kind that a sentence states in words goes before what a proof would assume."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
ACCUSED = ("refuted", "contradiction")
SUM = r"$\sum_{k=0}^{n-1}\cos(\theta + \frac{4\pi k}{n}) = 0$"


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page + "\n", fixes=False).data()["links"]]


@pytest.mark.parametrize(
    "page",
    [
        r"With $\theta$ in the second quadrant, $\cos\theta = \sqrt{1-\sin^2\theta}$.",
        r"For θ between 90° and 270°: $\sqrt{\cos^2\theta} = \cos\theta$.",
        r"Liegt $\varphi$ im dritten Quadranten, so ist $\sin\varphi = \sqrt{1-\cos^2\varphi}$.",
        r"Für negatives $x$ gilt $\sqrt{x^2} = x$.",
        r"For every real number $x$ we have $\sqrt{x^4} = x^2$ and $\sqrt{(x-1)^2} = x - 1$.",
        f"For $n \\geq 3$ cranks: {SUM}.\n\nFor $n \\geq 2$ cranks: {SUM}.",
        "In the second quadrant, cos θ = √(1 − sin² θ).",
        r"Im zweiten Quadranten ist $\cos\psi = \sqrt{1-\sin^2\psi}$.",
        r"Dans le deuxième quadrant, $\cos\varphi = \sqrt{1-\sin^2\varphi}$.",
        r"Nel terzo quadrante $\sin\varphi = \sqrt{1-\cos^2\varphi}$.",
        r"En el segundo cuadrante $\cos\varphi = \sqrt{1-\sin^2\varphi}$.",
        r"第二象限では $\cos\varphi = \sqrt{1-\sin^2\varphi}$。",
        r"For obtuse angles, $\sqrt{\cos^2\alpha} = \cos\alpha$.",
        r"Für stumpfe Winkel ist $\sqrt{\cos^2\beta} = \cos\beta$.",
        r"x is negative. $\sqrt{x^2} = x$.",
        r"$u$ ist negativ. Dann ist $\sqrt{u^2} = u$.",
        r"Let $x ∈ (−1, 0)$. $|x| = x$",
        r"For $t \in [-3, -1]$: $\sqrt{t^2} = t$.",
        r"Let $\theta \in (\pi/2, \pi)$. Then $|\cos\theta| = \cos\theta$.",
    ],
)
def test_what_fails_there_is_refuted(page):
    assert words_of(page)[-1] == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"For negative $a$ and $b$ we have $\sqrt{ab} = \sqrt a\sqrt b$.",
        r"For a complex number $z$ we have $|z|^2 = z^2$.",
        r"Für Vektoren $a$ und $b$ gilt $|a+b| = |a|+|b|$.",
        r"The sum $\sum_{k=0}^{n-1} e^{4\pi i k/n} = 0$ vanishes for any number $n$ of cylinders.",
        r"For every $n$: $\sum_{k=0}^{n-1} e^{i\frac{4\pi k}{n}} = 0$.",
        "If $a=b$, then $a^2=b^2$.\nConversely, if $a^2=b^2$, then $a = b$.",
    ],
)
def test_what_is_proved_otherwise_only_is_not_confirmed(page):
    assert words_of(page)[-1] not in PROVED


@pytest.mark.parametrize(
    "page",
    [
        r"With $\theta$ in the second quadrant, $\cos\theta = -\sqrt{1-\sin^2\theta}$.",
        r"For θ between 90° and 270°: $\sqrt{\cos^2\theta} = -\cos\theta$.",
        r"If $a$ and $b$ are negative, $\sqrt{ab} = \sqrt{-a}\sqrt{-b}$.",
        r"Für negatives $x$ gilt $\sqrt{x^2} = -x$.",
        r"For non-negative $x$ we have $\sqrt{x^2} = x$.",
        r"For positive or negative $x$ we have $\sqrt{x^4} = x^2$.",
        f"For $n \\geq 3$ cranks: {SUM}.",
        f"For every $n > 2$: {SUM}.",
        "In the second quadrant, cos θ = −√(1 − sin² θ).",
        "In the first quadrant, cos θ = √(1 − sin² θ).",
        r"Im dritten Quadranten ist $\sin\psi = -\sqrt{1-\cos^2\psi}$.",
        r"第二象限では $\cos\varphi = -\sqrt{1-\sin^2\varphi}$。",
        r"For obtuse angles, $\sqrt{\cos^2\alpha} = -\cos\alpha$.",
        r"For acute angles, $\sqrt{\cos^2\alpha} = \cos\alpha$.",
        r"For angles that are not obtuse, $\sqrt{\cos^2\beta} = \cos\beta$.",
        r"For acute or obtuse angles, $\sqrt{\sin^2\beta} = \sin\beta$.",
        r"x is negative. $\sqrt{x^2} = -x$.",
        r"$u$ is negative. For positive $u$ we have $|u| = u$.",
        r"Let $x ∈ (−1, 0)$. $|x| = -x$",
        r"For $t \in [0, 1]$: $\sqrt{t^2} = t$.",
        r"Let $\theta \in (0, \frac{\pi}{2})$. Then $|\cos\theta| = \cos\theta$.",
    ],
)
def test_what_is_true_there_is_confirmed(page):
    assert words_of(page)[-1] in PROVED


@pytest.mark.parametrize(
    "page",
    [
        "Case 1: $x > 0$. Then $|x| = x$.\n\nCase 2: $x < 0$. Then $|x| = -x$.",
        "## The right side\n\nLet $x > 0$. Then $|x| = x$.\n\n## The left side\n\n"
        "Let $x < 0$. Then $|x| = -x$.",
        r"Below resonance, $\omega<\omega_0$, the phase is $0$; above it, $\omega>\omega_0$, it is"
        r" $\pi$.",
        "Fall a: $k > 0$. Dann ist $|k| = k$. Fall b: $k < 0$. Dann ist $|k| = -k$.",
    ],
)
def test_the_range_of_the_next_case_takes_the_place_of_the_first(page):
    assert not {*ACCUSED} & {*words_of(page)}


@pytest.mark.parametrize(
    "page",
    ["Let $x > 0$. Therefore $x < 0$.", "It is $x > 3$ and $x < 2$.", "Let $x > 0$. Then $|x| = -x$."],
)
def test_ranges_of_one_case_still_contradict(page):
    assert words_of(page)[-1] in ACCUSED
