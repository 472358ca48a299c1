"""Sums that a page gives for every order, S_n = Σ e^{-inφ_k}, and what it says of one: S_8 = 0."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import DEFINITION, HOLDS, REFUTED

TABLE = r"""We call $S_n = \sum_k e^{-i n\varphi_k}$ the force phasor.

| cylinder $k$ | 1 | 2 | 3 | 4 | 5 |
|---|---|---|---|---|---|
| lag $\varphi_k$ | 0° | 144° | 216° | 288° | 72° |
"""
LATEX_TABLE = r"""We call $S_n = \sum_k e^{-i n\varphi_k}$ the force phasor.

\begin{tabular}{lccccc}
cylinder $k$ & 1 & 2 & 3 & 4 & 5\\
lag $\varphi_k$ & $0^\circ$ & $144^\circ$ & $216^\circ$ & $288^\circ$ & $72^\circ$\\
\end{tabular}
"""
RULE = r"$\varphi_k = 144^\circ k$ and $S_n = \sum_{k=0}^{4} e^{i n\varphi_k}$"
ROOTS = r"With $\zeta = e^{2\pi i/5}$ let $S_n = \sum_{k=0}^{4} \zeta^{nk}$."
FIVE = r"A four-stroke five-cylinder engine fires every 144°."


def last_verdict(page: str) -> str:
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize("family", [TABLE, LATEX_TABLE, RULE, ROOTS, f"{RULE}\n\n{FIVE}"])
def test_a_member_is_judged_by_what_is_given_for_every_order(family):
    for formula, verdict in (
        ("S_8 = 0", HOLDS),
        ("S_2 = S_4 = S_6 = S_8 = 0", HOLDS),
        ("S_{10} = 5", HOLDS),
        ("S_{10} = 0", REFUTED),
        ("S_1 = 1", REFUTED),
    ):
        assert last_verdict(f"{family}\n\n$${formula}$$") == verdict


def test_another_engine_named_since_is_not_accused():
    assert last_verdict(f"{RULE}\n\nFor the three-cylinder engine\n\n$$S_{{10}} = 0$$") != REFUTED


@pytest.mark.parametrize("rule", [r"F_n = A\cos n\theta + B\sin n\theta", r"F_n = c_n\cos n\theta"])
def test_a_harmonic_is_no_sum_over_cylinders(rule):
    assert last_verdict(f"$${rule}$$\n\n$$F_1 = m r \\omega^2\\cos\\theta$$") == DEFINITION


def test_a_complex_member_is_printed_where_it_is_worked_out():
    page = f"{TABLE}\n\n$$S_1 - 2 = -2.000$$\n\n" + r"$M_n = \sum_k (3-k) e^{-i n\varphi_k}$, so "
    worked = (
        page
        + r"$$M_1 = 2 + e^{-288^\circ i} - e^{-576^\circ i} - 2e^{-144^\circ i/2} = 0.2639 + 0.3633 i$$"
    )
    assert last_verdict(worked + "\n\n" + r"$$\arg M_1 = \arctan(0.3633/0.2639)$$") == HOLDS
    assert last_verdict(worked + "\n\n" + r"$$\arg M_1 = \arctan(0.2639/0.3633)$$") == REFUTED
