"""Slips put into true lines, one at a time: the correction undoes them, where it says and as it says.

Each row is a true line, the same with one slip, and what the slip is called. Three judges: the corrected
side has the value of the true one (mpmath's, on the tree), the text with the correction typed into it is
a line that holds, and the slip has its name.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from mpmath import mp

from symbalance.checking import check
from symbalance.document.formula import Number
from symbalance.document.latex_writer import formula_latex
from symbalance.notes.checking.verdicts import Verdict
from tests import formulas
from tests.known_truth.test_single_lines import LETTERS

POINT = {
    name: Fraction(place * place + 7 * place + 5, 19 + place)
    for place, name in enumerate(["theta", "phi", "r", "l", "omega", "m", "lambda", "x", "n", "beta"])
}
HOLDS = {"holds", "conditional"}

ROWS = r"""
\cos2\theta = 1-2\sin^2\theta | 1-2\cos^2\theta | sin for cos
\cos2\theta = 1-2\sin^2\theta | 1+2\sin^2\theta | sign
\cos2\theta = 1-2\sin^2\theta | -1-2\sin^2\theta | sign
\cos2\theta = 1-2\sin^2\theta | 1-2\sin^4\theta | exponent
\cos2\theta = 1-2\sin^2\theta | 1-2\sin\theta | exponent
\cos2\theta = 1-2\sin^2\theta | 1-2\sin^2 3\theta | order
\cos2\theta = 1-2\sin^2\theta | 1-2r\sin^2\theta | letter too many
\cos2\theta = 1-2\sin^2\theta | 1-5\sin^2\theta | number misprinted (2 for 5)
\cos2\theta = 1-2\sin^2\theta | 3-2\sin^2\theta | number misprinted (1 for 3)
\cos2\theta = 1-2\sin^2\theta | 1-\frac{1}{2}\sin^2\theta | number misprinted (4 for 1)
\cos2\theta = 1-2\sin^2\theta | 1-2\sin^2\theta+r | term too many
\cos2\theta = \cos^2\theta-\sin^2\theta | \cos^2\theta-\sin^2\theta+\sin\theta | term too many
\cos2\theta = 2\cos^2\theta-1 | r\cos^2\theta-1 | 2 for r
\sin3\theta = 3\sin\theta-4\sin^3\theta | 3\sin\theta-4\sin^2\theta | exponent
\cos\theta+\sin\theta = \sqrt2\cos(\theta-\frac{\pi}{4}) | 2\cos(\theta-\frac{\pi}{4}) | root missing
\sin3\theta = 3\sin\theta-4\sin^3\theta | 3\cos\theta-4\cos^3\theta | sine and cosine exchanged
\sin3\theta = 3\sin\theta-4\sin^3\theta | 3\sin2\theta-4\sin^3\theta | order
r\sin3\theta = 3r\sin\theta-4r\sin^3\theta | 3\sin\theta-4r\sin^3\theta | r missing
r\sin3\theta = 3r\sin\theta-4r\sin^3\theta | 3r\sin\theta-4\sin^3\theta | r missing
r\sin3\theta = 3r\sin\theta-4r\sin^3\theta | 3r\sin\theta-4r^2\sin^3\theta | exponent
r^2\sin3\theta = 3r^2\sin\theta-4r^2\sin^3\theta | 3r^2\sin\theta-4\sin^3\theta | r² missing
l\sin3\theta = 3l\sin\theta-4l\sin^3\theta | 3l\sin\theta-4r\sin^3\theta | l for r
\cos(\theta+\frac{\pi}{2})+\sin\theta=2\cos(\theta+\frac{\pi}{2})+2\sin\theta | 2\cos(\theta-\frac{\pi}{2})+2\sin\theta | sign
\cos(3\theta-\frac{3\pi}{5}) = \cos3(\theta-\frac{\pi}{5}) | \cos3(\theta-\frac{2\pi}{5}) | phase
\cos3(\theta-\frac{\pi}{5}) = \cos(3\theta-\frac{3\pi}{5}) | \cos(3\theta-\frac{\pi}{5}) | phase not multiplied (times the order 3)
\cos3(\theta-\frac{\pi}{5}) = \cos(3\theta-\frac{3\pi}{5}) | \cos(3\theta-\frac{6\pi}{5}) | phase
\cos2(\theta+\phi) = \cos(2\theta+2\phi) | \cos(2\theta+\phi) | phase not multiplied (times the order 2)
\cos2(\theta-\phi) = \cos(2\theta-2\phi) | \cos(2\theta-\phi) | phase not multiplied (times the order 2)
\cos2(\theta+\phi) = \cos(2\theta+2\phi) | \cos(2\theta+4\phi) | order
\sin5\theta = \cos(5\theta-\frac{\pi}{2}) | \cos(4\theta-\frac{\pi}{2}) | order
\sin5\theta = \cos(5\theta-\frac{\pi}{2}) | \cos(5\theta-\pi) | phase not multiplied (times 1/2)
\cos4\theta = \sin(4\theta+\frac{\pi}{2}) | \sin(\theta+\frac{\pi}{2}) | order
1+\tan^2\theta = \frac{1}{\cos^2\theta} | \frac{1}{\sin^2\theta} | cos for sin
\frac{\sin\theta}{\cos\theta} = \tan\theta | \cos\theta | tan for cos
r = \sqrt{r^2} | \sqrt{r} | exponent
\frac{d}{d\theta}\sin\theta = \cos\theta | -\cos\theta | sign
-r\omega\sin\theta = \frac{d}{dt}(r\cos\theta) | \frac{d}{d\theta}(r\cos\theta) | variable of differentiation
-r\omega^2\cos\theta = \frac{d^2}{dt^2}(r\cos\theta) | \frac{d}{dt}(r\cos\theta) | order of differentiation
r\omega\cos\theta = \frac{d}{dt}(r\sin\theta) | \frac{d^2}{dt^2}(r\sin\theta) | order of differentiation
2\pi r = 2\pi r | 2r | π missing
r^2\theta = r^2\theta | r^3\theta | exponent
r^2\theta+l^2 = r^2\theta+l^2 | r^{-2}\theta+l^2 | sign
(r+l)^3 = r^3+3r^2l+3rl^2+l^3 | r^3+3r^2l+3r^2l^2+l^3 | exponent
(r+l)^3 = r^3+3r^2l+3rl^2+l^3 | r^3+3r^2l+2rl^2+l^3 | number misprinted (3 for 2)
""".strip().splitlines()  # noqa: E501


def refuted(line: str) -> Verdict:
    (verdict,) = [v for v in check(f"$${line}$$", LETTERS).verdicts if v.verdict == "refuted"]
    return verdict


def typed_in(line: str, verdict: Verdict) -> str:
    """Return the line with the correction typed where and for what the report says."""
    assert verdict.fix is not None
    for fault in sorted(verdict.fix.faults, key=lambda fault: -fault.column):
        start = fault.column - 1 - len("$$")
        assert line[start : start + len(fault.source)] == fault.source
        assert fault.node is not None
        piece = formula_latex(fault.node)
        if not isinstance(fault.node, Number) or line[start - 1].isdigit():
            piece = f"({piece})"
        sign = "+" if fault.source.startswith("-") else ""
        line = f"{line[:start]}{sign}{piece}{line[start + len(fault.source) :]}"
    return line


@pytest.mark.spread(5)
@pytest.mark.parametrize("row", ROWS)
def test_the_correction_undoes_the_slip(row: str) -> None:
    line, wrong, kind = row.split(" | ")
    left, _, _ = line.partition("=")
    (true,) = check(f"$${line}$$", LETTERS).verdicts
    assert true.verdict in HOLDS
    slipped = f"{left}={wrong}"
    verdict = refuted(slipped)
    fix = verdict.fix
    assert fix is not None
    assert fix.kind == kind
    if "\\frac{d" not in line:  # mpmath knows no θ(t)
        with mp.workdps(30):
            expected = formulas.at_point(true.node, POINT, 30)
            assert formulas.close(formulas.at_point(fix.node, POINT, 30), expected, 20)
    corrected = typed_in(slipped, verdict)
    assert {v.verdict for v in check(f"$${corrected}$$", LETTERS).verdicts} <= HOLDS, corrected


RESULTS = r"""
1+1 = 0 | 2
1-1 = 2 | 0
\int_0^\pi \sin\theta\,d\theta = 0 | 2
\sin 120^\circ = \frac12 | sqrt(3)/2
2\cos^2 30^\circ = \sqrt3 | 3/2
\cos 2(\theta+45^\circ) = \cos 2\theta | -sin 2θ
100\pi = 341 | 314.2
\frac{60\cdot 179.5}{4} = 2962 | 2692.5
\sin\theta\cos\theta + \sin\theta\cos\theta = \sin\theta | sin 2θ
\cos\theta+\sin\theta = \sqrt2\cos(\theta+45^\circ) | sqrt(2) cos(θ - 45°)
3\sin\theta-4\sin^3\theta+1-1 = 4\sin^3\theta-3\sin\theta | 3 sin θ - 4 sin^3 θ
\cos\theta+\frac{r}{l}\cos2\theta = \cos\theta+\frac{r}{2l}\cos2\theta | cos θ + r/l cos 2θ
""".strip().split("\n")


@pytest.mark.spread(4)
@pytest.mark.parametrize("row", RESULTS)
def test_a_result_is_corrected_as_a_teacher_would_write_it(row: str) -> None:
    """The right side, not what it was worked out from; short, with no factor 1 and no inner product."""
    line, correction = row.split(" | ")
    fix = refuted(line).fix
    assert fix is not None
    assert (fix.of_left, fix.text.replace("1 - 1 + ", "")) == (False, correction)
