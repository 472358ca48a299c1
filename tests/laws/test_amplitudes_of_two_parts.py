r"""A cosine and a sine of one angle in one: the amplitude is √(a² + b²), tan ψ = b/a of c cos(θ - ψ)."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_in

WRONG = [
    r"The first harmonic is $p\cos\theta + q\sin\theta$. Its amplitude is $c = p + q$.",
    r"The first harmonic is $p\cos\theta + q\sin\theta$. Its amplitude is $c = p^2 + q^2$.",
    r"The torque is $T = A_n\cos n\theta + B_n\sin n\theta$. Its amplitude is $C = \sqrt{A_n^2-B_n^2}$.",
    r"Die Welle ist $a_k \cos(k\varphi) + b_k\,\sin(k\varphi)$. Die Amplitude ist $c_k = a_k + b_k$.",
    r"La force est $a\cos\omega t + b\sin\omega t$. Son amplitude est $c = a^2 + b^2$.",
    r"La forza è $a\cos\theta + b\sin\theta$. La sua ampiezza è $c = a + b$.",
    r"La fuerza es $a\cos\theta - b\sin\theta$. Su amplitud es $c = a - b$.",
    r"調和成分は $a\cos\theta + b\sin\theta$ である。振幅は $c = a + b$ である。",
    r"The wave $a\cos\theta + b\sin\theta$ is $c\cos(\theta - \psi)$. Here $\tan\psi = \frac{a}{b}$.",
    r"The wave $a\cos\theta + b\sin\theta$ is $c\sin(\theta + \psi)$. Here $\tan\psi = \frac{b}{a}$.",
    r"The wave $a\cos\theta + b\sin\theta$ is $c\cos(\theta + \psi)$. Here $\tan\psi = \frac{b}{a}$.",
    r"The wave $a\cos\theta + b\sin\theta$ is $c\cos(\theta - \psi)$. Here $c = a + b$.",
]
RIGHT = [
    r"The first harmonic is $p\cos\theta + q\sin\theta$. Its amplitude is $c = \sqrt{p^2 + q^2}$.",
    r"The torque is $T = A_n\cos n\theta + B_n\sin n\theta$. Its amplitude is $C = \sqrt{A_n^2+B_n^2}$.",
    r"La fuerza es $a\cos\theta - b\sin\theta$. Su amplitud es $c = \sqrt{a^2 + b^2}$.",
    r"The wave $a\cos\theta + b\sin\theta$ is $c\cos(\theta - \psi)$. Here $\tan\psi = \frac{b}{a}$.",
    r"The wave $a\cos\theta + b\sin\theta$ is $c\sin(\theta + \psi)$. Here $\tan\psi = \frac{a}{b}$.",
    r"The wave $a\cos\theta + b\sin\theta$ is $c\cos(\theta + \psi)$. Here $\tan\psi = -\frac{b}{a}$.",
    r"The wave is $a\cos\theta + b\sin\theta$. The square of its amplitude is $C = a^2 + b^2$.",
    r"The wave is $a\cos\theta + b\sin\theta$. Its peak-to-peak amplitude is $C = 2\sqrt{a^2 + b^2}$.",
    r"The wave is $a\cos\theta + b\sin\theta$. At most it reaches an amplitude of $C = a + b$.",
    r"The wave is $a\cos\theta + b\sin\theta$. Its mean of both is $m = \frac{a + b}{2}$.",
    r"The waves $a\cos\theta + b\cos\theta$ are in phase. Their amplitude is $c = a + b$.",
    r"The wave is $a\cos\theta + b\sin 2\theta$. Its amplitude is below $c = a + b$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_another_amplitude_or_phase_is_refuted(page):
    assert last_in(page) == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_the_right_one_and_another_size_are_not_accused(page):
    assert last_in(page) not in ("refuted", "contradiction")
