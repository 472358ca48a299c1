"""A letter's further formula is judged by its own words: a disc and then a rim, a force and its parts."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, FAILING, REFUTED

DISC = (
    "The wheel that is needed has $J = 12.6$ kg m². As a solid disc of the mass $m = 200$ kg it has"
    " $J = \\frac12 m R^2$.\n\n"
)
SCHEIBE = (
    "# Trägheitsmoment des Schwungrads\n\nAls Scheibe gerechnet ist $J_S = \\frac12 m R^2$.\n\n"
    "Für einen Kranz mit den Radien $R_a$ und $R_i$, der Breite $b$ und der Dichte $\\rho$ gilt "
)
NET = (
    "In the engine the net force along the stroke is $F = p A - m r\\omega^2(\\cos\\theta"
    " + \\lambda\\cos 2\\theta)$. The rod thrust is $S = \\frac{F}{\\cos\\beta}$ and "
)
KOLBEN = (
    "Die Kolbenkraft im Motor ist $F = p A - m r\\omega^2(\\cos\\varphi + \\lambda\\cos 2\\varphi)$. "
)
LINES = [  # what stands above, a right line, a wrong one
    (DISC + "A rim of the outer radius $R_o$ and the inner radius $R_i$ has ",
     r"$J = \frac12 m (R_o^2 + R_i^2)$", r"$J = \frac12 m (R_o^2 - R_i^2)$"),
    (DISC + "リムの外半径 $R_o$、内半径 $R_i$ のとき ",
     r"$J = \frac12 m (R_o^2 + R_i^2)$", r"$J = \frac12 m (R_o^2 - R_i^2)$"),
    (SCHEIBE, r"$J_S = \frac12 m (R_a^2 + R_i^2)$", r"$J_S = \frac12 m (R_a^2 - R_i^2)$"),
    (NET + "the side force on the liner ", r"$N = F\tan\beta$", r"$N = F\sin\beta$"),
    (KOLBEN + "Davon gehen die Stangenkraft $F_S = F/\\cos\\beta$ und die Normalkraft auf die Wand aus: ",
     r"$F_N = F\tan\beta$", r"$F_N = F\sin\beta$"),
    (KOLBEN + "Die Normalkraft ist $F_N = F\\tan\\beta$ und die Stangenkraft ",
     r"$F_S = \frac{F}{\cos\beta}$", r"$F_S = F\cos\beta$"),
]  # fmt: skip
RIGHTLY = [
    NET + "the side force is $N = S\\sin\\beta$.",
    "The engine has $F = \\frac{P}{\\cos\\beta}$ in the rod, and the side force is $N = F\\sin\\beta$.",
    DISC + "A ring of the radius $R$ has $J = m R^2$.",
    SCHEIBE + "$J_S = \\frac{\\pi}{2}\\rho b (R_a^4 - R_i^4)$.",
]


@pytest.mark.parametrize(("above", "right", "wrong"), LINES)
def test_a_further_formula_is_judged_by_its_own_words(above, right, wrong):
    for line, expected in ((right, CONDITIONAL), (wrong, REFUTED)):
        checked = check(f"{above}{line}.\n", {})
        assert not checked.derivation.unreadable
        failing = [v for v in checked.verdicts if v.verdict in FAILING]
        last = max(checked.verdicts, key=lambda v: (v.line, v.span))
        assert last.verdict == expected
        assert failing == ([last] if expected == REFUTED else [])


@pytest.mark.parametrize("page", RIGHTLY)
def test_other_bodies_and_other_forces_are_not_accused(page):
    checked = check(page + "\n", {})
    assert not checked.derivation.unreadable
    assert not {v.verdict for v in checked.verdicts} & {*FAILING}
