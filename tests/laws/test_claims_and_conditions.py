"""Claims of a given angle, of all values or of data are judged; equations to be solved are not."""

import pytest

from symbalance.checking import check

RIGHT = (
    r"""Let $\theta = 60°$. Then

$\cos\theta = 0.5$""",
    r"""For $\theta = 60°$ and $r = 40$ mm:

$r\cos\theta = 20$ mm""",
    r"""Für $\theta=60°$ und $\lambda=0.25$:

$\cos\theta+\lambda\cos2\theta = 0.375$""",
    r"""The force vanishes where $\cos\theta + 0.25\cos 2\theta = 0$.""",
    r"""At $\theta = 60°$ the force is 3 kN.
It vanishes where $\cos\theta + 0.25\cos 2\theta = 0$, that is at $\theta = 77.0°$.""",
    r"""Take $\theta = 60°$ first. The velocity is largest when $\cos\theta = 0.234$.""",
    r"""The identity $\sin^2 x+\cos^2 x=1$ is well known.""",
    r"""$y = x^2+1$

So $y > 0$.""",
    r"""$y = 3\cos x+4\sin x$

$y \le 5$ for all $x$.""",
    r"""The equation $\ddot x + \omega^2 x = 0$ has the solution

$x = A\cos \omega t$""",
    r"""The roots of $x^2-5x+6=0$ are $x_1=2$ and $x_2=3$.""",
    r"""In series: $c = \frac{c_1c_2}{c_1+c_2}$.

In parallel: $c = c_1+c_2$.""",
    r"""Engine A: $r = 40$ mm. Engine B: $r = 60$ mm.

Engine A: $2r = 80$ mm.""",
    r"""$v_1 = 10.0$ m/s, $v_2 = 9.8$ m/s

$v_1 - v_2 = 0.2$ m/s""",
    r"""$d_a = 50.0$ mm, $d_i = 49.8$ mm

$I = \frac{\pi}{64}(d_a^4-d_i^4) = 4879$ mm⁴""",
    r"""$F_1 = 12.5/3 = 4.17$ N and $F_2 = 12.4/3 = 4.13$ N, so $F_1 - F_2 = 0.04$ N.""",
    r"""$F_1 = 12.5/3 = 4.17$ N and $F_2 = 12.4/3 = 4.13$ N, so $F_1 - F_2 = 0.033$ N.""",
    r"""$n = 3000$ rpm, $\omega = 314$ rad/s, $m = 0.5$ kg, $r = 40$ mm.

$F = m r\omega^2 = 1974$ N""",
    r"""$\lambda = 0.286$, $F = 10185$ N.

$\lambda F = 2910$ N""",
)
WRONG = (
    r"""Let $\theta = 60°$. Then

$\cos\theta = 0.6$""",
    r"""For $\theta = 60°$ and $r = 40$ mm:

$r\cos\theta = 30$ mm""",
    r"""Für $\theta=60°$ und $\lambda=0.25$:

$\cos\theta+\lambda\cos2\theta = 0.5$""",
    r"""For $n=4$:

$\sin(\pi/n) = 0.5$""",
    r"""The identity $\sin^2 x+2\cos^2 x=1$ is well known.""",
    r"""Thus $\sin^2\theta+\cos^2 2\theta=1$ for all $\theta$.""",
    r"""$y = x^2+1$

So $y < 0$.""",
    r"""$y = 3\cos x+4\sin x$

$y \le 4.9$ for all $x$.""",
    r"""$v_1 = 10.0$ m/s, $v_2 = 9.8$ m/s

$v_1 - v_2 = 0.3$ m/s""",
    r"""$d_a = 50.0$ mm, $d_i = 49.8$ mm

$I = \frac{\pi}{64}(d_a^4-d_i^4) = 5900$ mm⁴""",
)


def _verdicts(page):
    return [link["verdict"] for link in check(page).data()["links"]]


@pytest.mark.parametrize("page", RIGHT)
def test_nothing_right_is_accused(page):
    assert not {"refuted", "contradiction", "unreadable"} & set(_verdicts(page))


@pytest.mark.parametrize("page", WRONG)
def test_what_is_wrong_is_refuted(page):
    assert "refuted" in _verdicts(page)
