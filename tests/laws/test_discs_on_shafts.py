"""Discs on shafts: the twist of two, their free motion in step, and more in a row that words mention."""

from __future__ import annotations

import numpy as np
import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import CONDITIONAL, HOLDS, REFUTED, UNDECIDED

TWO = r"""With the angles $\varphi_1$ and $\varphi_2$ the equations of free motion are

$$J_1\ddot\varphi_1 + k(\varphi_1 - \varphi_2) = 0$$

$$J_2\ddot\varphi_2 - k(\varphi_1 - \varphi_2) = 0$$

"""
THREE = r"""# Three discs of a torsional system

The discs have $J_1 = 2.4$ kg m², $J_2 = 18$ kg m² and $J_3 = 6.5$ kg m², the shafts
$k_1 = 0.75\cdot 10^6$ N m and $k_2 = 1.2\cdot 10^6$ N m. Putting $\varphi_i = A_i\cos\omega t$ into the
three equations, the determinant gives, besides $\omega = 0$,

"""
TWIST = r"With the twist $\psi = \varphi_1 - \varphi_2$ we have "
BACK = r"Mit $\psi = \varphi_2 - \varphi_1$ wird "
_HOLD = (HOLDS, CONDITIONAL)


def last_verdict(page: str):
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


@pytest.mark.parametrize(
    ("line", "verdicts"),
    [
        (TWIST + r"$$\ddot\psi + k\left(\frac1{J_1}+\frac1{J_2}\right)\psi = 0$$", _HOLD),
        (TWIST + r"$$\ddot\psi + k\left(\frac1{J_1}-\frac1{J_2}\right)\psi = 0$$", (REFUTED,)),
        (TWIST + r"$$\ddot\psi + \frac{k(J_1+J_2)}{J_1J_2}\psi = 0$$", _HOLD),
        (BACK + r"$$\frac{J_1J_2}{J_1+J_2}\ddot\psi + k\psi = 0$$", _HOLD),
        (BACK + r"$$\frac{J_1J_2}{J_1+J_2}\ddot\psi + 2k\psi = 0$$", (REFUTED,)),
        (r"In the free vibration $J_1\varphi_1 + J_2\varphi_2 = 0$.", _HOLD),
        (r"In the free vibration $\varphi_2/\varphi_1 = -J_1/J_2$.", _HOLD),
        (r"In the free vibration $J_1\varphi_1 - J_2\varphi_2 = 0$.", (REFUTED,)),
        (r"In der freien Schwingung ist $\varphi_1/\varphi_2 = -J_1/J_2$.", (REFUTED,)),
    ],
)
def test_what_is_said_of_two_discs_follows_from_their_equations(line, verdicts):
    assert last_verdict(TWO + line).verdict in verdicts


def test_a_case_is_not_accused():
    held = r"If disc 2 is held, with $\psi = \varphi_1 - \varphi_2$ we have $$J_1\ddot\psi + k\psi = 0$$"
    assert last_verdict(TWO + held).verdict != REFUTED
    assert last_verdict(TWO + r"At rest $\varphi_1 = \varphi_2$.").verdict not in (HOLDS, REFUTED)


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (
            r"J_1J_2J_3\omega^4 - [k_1(J_1+J_2)J_3 + k_2(J_2+J_3)J_1]\omega^2 + k_1k_2(J_1+J_2+J_3) = 0",
            CONDITIONAL,
        ),
        (
            r"J_1J_2J_3\omega^4 + [k_1(J_1+J_2)J_3 + k_2(J_2+J_3)J_1]\omega^2 + k_1k_2(J_1+J_2+J_3) = 0",
            REFUTED,
        ),
        (r"A_2 = \left(1 - \frac{J_1\omega^2}{k_1}\right)A_1", CONDITIONAL),
        (r"A_2 = \left(1 + \frac{J_1\omega^2}{k_1}\right)A_1", REFUTED),
        (r"A_3 = A_2 - \frac{\omega^2}{k_2}(J_1A_1 + J_2A_2)", CONDITIONAL),
        (r"A_3 = A_2 + \frac{\omega^2}{k_2}(J_1A_1 + J_2A_2)", REFUTED),
        (r"A_2/A_1 = 0.267", CONDITIONAL),
        (r"A_2/A_1 = -0.204", CONDITIONAL),
        (r"A_2/A_1 = 0.52", UNDECIDED),
    ],
)
def test_discs_in_a_row_have_the_equations_that_only_words_mention(formula, verdict):
    found = last_verdict(f"{THREE}$${formula}$$")
    assert found.verdict == verdict
    assert "3 discs in a row" in found.assumption + found.reason


def test_a_row_that_is_held_at_an_end_is_another():
    page = THREE.replace("the shafts", "the last one is fixed, the shafts")
    wrong = r"A_2 = \left(1 + \frac{J_1\omega^2}{k_1}\right)A_1"
    assert last_verdict(f"{page}$${wrong}$$").verdict != REFUTED


def test_no_mode_is_missed_behind_a_stiff_engine():
    """A light disc on a stiff shaft before three heavy ones: two modes lie close together, far below."""
    inertias, shafts = np.array([0.01, 2.0, 4.0, 3.0]), [2e6, 1e3, 2e3]
    springs = sum(
        k * np.outer(twist, twist) for k, twist in zip(shafts, np.diff(np.eye(4), axis=0), strict=True)
    )
    roots = np.sqrt(inertias)
    modes = np.linalg.eigh(springs / np.outer(roots, roots))[1] / roots[:, None]
    page = r"# Torsional vibration of four discs" + "\n\n"
    page += ", ".join(f"$J_{n} = {float(size)!r}$ kg m²" for n, size in enumerate(inertias, 1)) + ", "
    page += ", ".join(f"$k_{n} = {size:.0f}$ N m" for n, size in enumerate(shafts, 1))
    page += ".\n\n" + r"With $\varphi_i = A_i\cos\omega t$ the four equations give" + "\n\n"
    for mode in modes.T[1:3]:
        ratio = mode[3] / mode[0]
        assert last_verdict(f"{page}$$A_4/A_1 = {ratio:.3f}$$").verdict == CONDITIONAL
        assert last_verdict(f"{page}$$A_4/A_1 = {1.1 * ratio:.3f}$$").verdict == UNDECIDED
