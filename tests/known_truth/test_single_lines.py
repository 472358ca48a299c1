"""Single lines of known truth: what is right may not be accused, what is wrong may not pass."""

import pytest

from symbalance.checking import check
from symbalance.notes.checking.verdicts import FAILING

LETTERS = {
    "theta": "crank angle", "phi": "rod angle", "r": "crank radius", "l": "rod length", "s": "stroke",
    "lambda": "rod ratio l/r", "omega": "angular speed", "n": "engine speed rpm", "t": "time",
    "m": "reciprocating mass", "x": "displacement from top dead centre", "v": "piston velocity",
    "a": "piston acceleration", "F": "inertia force", "F_1": "N", "A_2": "number",
}  # fmt: skip
ALARMS = set(FAILING)

RIGHT = r"""
\sqrt{3-2\sqrt2}=\sqrt2-1
r=\sqrt{r^2}
\cos\phi=\sqrt{1-\sin^2\phi}
\sin72^\circ\sin144^\circ=\frac{\sqrt5}4
2\cdot0.08\cdot60=9.6
0.5\times0.04\times377^2=2843
A_2=1/3.5+1/(4\cdot3.5^3)=0.2915
1/3.5=0.2857
\sqrt3\approx1.732
\sqrt3 r\cos\theta \approx 1.732 r\cos\theta
3.162\cos(\theta-18.43^\circ)=3\cos\theta+\sin\theta
\sqrt{10}\cos(\theta+63.4^\circ)=\sqrt2\cos\theta-2\sqrt2\sin\theta
v=r\omega(\sin\theta+0.5\frac1\lambda\sin2\theta)
\omega=\frac{\pi n}{30}
\theta=\omega t
r=\frac s2
\lambda=\frac lr
\dot\theta=\omega
\lambda=4
l=4r
r=0.04
\theta=\frac\pi2
F_1=m r\omega^2=0.5\cdot0.04\cdot628.3^2=7895
\lambda=l/r=0.14/0.04=3.5
\omega=2\pi n/60=2\pi\cdot6000/60=628.3
\cos\theta=0
2\theta=180^\circ
a\approx r\omega^2\cos\theta\approx r\omega^2(\cos\theta+\frac1{\lambda}\cos2\theta)
x''=r(\cos\theta+\frac1\lambda\cos2\theta)
a=v\frac{dv}{dx}
e^{i\theta}+e^{i(\theta+2\pi/3)}+e^{i(\theta+4\pi/3)}=0
\sqrt{1-\frac{\sin^2\theta}{\lambda^2}} = 1-\frac{\sin^2\theta}{2\lambda^2}-\cdots
\sin^6\theta=\frac{10-15\cos2\theta+6\cos4\theta-\cos6\theta}{32}
\sum_{k=0}^{6}\cos2(\theta+\frac{2\pi k}{7})=0
v=\frac{dx}{dt}=\omega\frac{dx}{d\theta}
"""

WRONG = r"""
\cos 120^\circ=\frac12
\sin 210^\circ=\frac12
\cos150^\circ=\frac{\sqrt3}2
\cos135^\circ=\frac1{\sqrt2}
-\frac12=\frac12
\sqrt{3-2\sqrt2}=1-\sqrt2
-r=\sqrt{r^2}
\sin72^\circ\sin216^\circ=\frac{\sqrt5}4
\cos\theta=\cos\theta+0.1
a=r\omega^2(\cos\theta+\frac1\lambda\cos2\theta)+0.1r
v=r\omega(\sin\theta+0.6\frac1\lambda\sin2\theta)
x=r(1-\cos\theta)+0.3\frac r\lambda(1-\cos2\theta)
\sin^2\theta=0.5-0.4\cos2\theta
2\cdot0.08\cdot60=9.3
0.5\times0.04\times377^2=2483
0.5\cdot15790=7985
0.25\cdot8=2.04
3.5\times2=7.1
A_2=1/3.5+1/(4\cdot3.5^3)=0.2951
1/3.5=0.2875
(\sqrt5-1)/4 \approx 0.3091
\omega=\frac{\pi n}{60}
\theta=2\omega t
\theta=\omega t^2
r=2s
\lambda=\frac rl
\lambda=\frac l{2r}
\dot\theta=2\omega
F_1=m r\omega^2=0.5\cdot0.04\cdot628.3^2=8795
\lambda=l/r=0.14/0.04=3.7
a\approx r\omega^2\cos\theta\approx r\omega^2(\cos\theta+\frac1{2\lambda}\cos2\theta)
x''=r(\cos\theta-\frac1\lambda\cos2\theta)
x'=r\cos\theta
v=\frac{dx}{d\theta}
\sin^2\theta+\cos^2\theta=2
\sum_{k=0}^{6}\cos7(\theta+\frac{2\pi k}{7})=0
"""


def lines(block: str) -> list[str]:
    return block.strip().splitlines()


@pytest.mark.parametrize("line", lines(RIGHT))
def test_a_right_line_is_not_accused(line):
    found = check(f"$${line}$$", LETTERS).verdicts
    assert found
    assert not [v for v in found if v.verdict in ALARMS]


@pytest.mark.spread(2)
@pytest.mark.parametrize("line", lines(WRONG))
def test_a_wrong_line_does_not_pass(line):
    assert [v for v in check(f"$${line}$$", LETTERS).verdicts if v.verdict == "refuted"]


PAGES = {
    "$$\\sqrt{1-q} = 1 - \\frac q2 - ...$$": ["holds_to_order"],
    "$$\\cos k=\\sin k, \\quad k=45^\\circ$$": ["holds", "definition"],
    "$$3\\cos\\theta-\\sin\\theta=\\sqrt{10}\\cos(\\theta+k), \\qquad \\tan k=\\frac13$$": [
        "conditional",  # |k| < π/2: with k + π the sum is the opposite
        "condition",
    ],
    "$$F_1 = 2 m\\cos k$$\n\nFor $k = 90^\\circ$: $F_1=1$": ["definition", "premise", "refuted"],
    "$$F_1 = 2 m\\cos k$$\n\nFor $k = 90^\\circ$: $F_1=0$": ["definition", "premise", "conditional"],
    "$s = 87\\ \\mathrm{mm}$, $r = s/2 = 43\\ \\mathrm{mm}$": ["definition", "holds", "refuted"],
    "$n=6000$, $\\omega = 2\\pi n/60 = 590$": ["definition", "holds", "refuted"],
    "$n=6000$, $\\omega = 2\\pi n/60 = 628.3$": ["definition", "holds", "holds_to_order"],
    "$$\\sin\\theta(1+2q\\cos\\theta)=0$$": ["condition"],
    "$$F_1 = 8 k q$$\n\n$$F_2 = 4 m r$$\n\nLet $F_1 = F_2$, so\n\n$$k q = \\frac{m r}2$$": [
        *("definition", "definition", "condition", "undecided"),
    ],
}


@pytest.mark.parametrize("page", PAGES)
def test_a_page_is_judged_as_a_whole(page):
    letters = LETTERS | {"k": "any", "q": "any", "F_1": "any", "F_2": "any"}
    assert [v.verdict for v in check(page, letters).verdicts] == PAGES[page]


FIXES = {
    r"x\approx r(1-\cos\theta)+\frac{r\lambda}{4}(1-\cos2\theta)": "rod ratio inverted (l/r for r/l)",
    r"6\cos(6\theta-\frac\pi3)=6\cos 6(\theta-\frac\pi3)": "phase not multiplied (times the order 6)",
    r"\sin2\theta=2\sin\theta\sin\theta": "cos for sin",
    r"\sin2\theta=-2\sin\theta\cos\theta": "sign",
    r"\cos2\theta=1-3\sin^2\theta": "number misprinted (2 for 3)",
    r"\cos2\theta=1-2\sin^3\theta": "exponent",
    r"r\sin2\theta=2\sin\theta\cos\theta": "r missing",
    r"v=\frac{dx}{d\theta}": "variable of differentiation",
}


@pytest.mark.spread(2)
@pytest.mark.parametrize("line", FIXES)
def test_the_slip_is_named(line):
    (found,) = [v for v in check(f"$${line}$$", LETTERS).verdicts if v.verdict == "refuted"]
    assert found.fix is not None
    assert found.fix.kind == FIXES[line]
