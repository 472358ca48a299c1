"""Sums over cylinders whose angles and places stand in a table or a list of the page: Σ z_k cos δ_k."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED

FIVE = (
    "The spacing is $a$.\n\n| cylinder $i$ | $z_i/a$ | $\\varphi_i$ |\n|---|---|---|\n"
    "| 1 | −2 | 0° |\n| 2 | −1 | 144° |\n| 3 | 0 | 216° |\n| 4 | +1 | 288° |\n| 5 | +2 | 72° |\n\n"
)
CROSS = (
    "Lage der Kröpfungen:\n\n| Kröpfung $k$ | 1 | 2 | 3 | 4 |\n|---|---|---|---|---|\n"
    "| $\\beta_k$ | 0° | 90° | 270° | 180° |\n| $2\\beta_k$ | 0° | 180° | 540° | 360° |\n"
    "| $z_k/b$ | −1,5 | −0,5 | +0,5 | +1,5 |\n\n"
)
SPOKEN = (
    "Kreuzwelle:\n\n| Kröpfung $k$ | $\\beta_k$ | $z_k$ |\n|---|---|---|\n"
    "| 1 | 0° | 1,5 a |\n| 2 | 90° | 0,5 a |\n| 3 | 270° | −0,5 a |\n| 4 | 180° | −1,5 a |\n\n"
)
MANETONS = (
    "L'entraxe est $p$.\n\n| maneton $j$ | 1 | 2 | 3 |\n|---|---|---|---|\n"
    "| $\\gamma_j$ | 0° | 240° | 120° |\n| $\\dfrac{z_j}{p}$ | 1 | 0 | −1 |\n\n"
)
PINS = (
    "気筒間隔を $c$ とする。\n\n| 気筒 $k$ | 1 | 2 | 3 |\n|---|---|---|---|\n"
    "| $\\delta_k$ | 0° | 120° | 240° |\n| $z_k/c$ | -1 | 0 | 1 |\n\n"
)
RULED = (
    "The cranks are at $\\alpha_1 = 0$, $\\alpha_2 = 240^\\circ$, $\\alpha_3 = 120^\\circ$, "
    "and $x_k = (2-k)\\,p$ are the places.\n\n"
)
FOUR_BELOW = (
    "Con $x_i = i\\,b$ y $\\beta_1 = 0$, $\\beta_2 = 90^\\circ$, $\\beta_3 = 180^\\circ$, "
    "$\\beta_4 = 270^\\circ$:\n\n"
)
THREE_THEN_FIVE = RULED.replace("x_k", "z_k").replace("alpha", "varphi").replace("p$", "a$") + FIVE
TWO_TABLES = MANETONS + "# V8\n\n" + SPOKEN


def last(page: str):
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


RIGHT = [
    (FIVE, r"\sum_i \frac{z_i}{a}\cos\varphi_i = -0.264"),
    (FIVE, r"\sum_i z_i\sin\varphi_i = 0.363\,a"),
    (FIVE, r"\sum_i z_i\cos 2\varphi_i = -4.736\,a"),
    (FIVE, r"\sum_i \tfrac{z_i}{a}\cos\varphi_i = -2+0.8090+0.3090+0.6180"),
    (CROSS, r"\sum\frac{z_k}{b}\cos\beta_k = -3"),
    (CROSS, r"\sum\frac{z_k}{b}\sin\beta_k = -1"),
    (CROSS, r"\sum (z_k/b)\cos 2\beta_k = 0"),
    (SPOKEN, r"\sum z_k\cos\beta_k = 3a"),
    (SPOKEN, r"\left(\sum z_k\cos\beta_k\right)^2 + \left(\sum z_k\sin\beta_k\right)^2 = 10a^2"),
    (MANETONS, r"\sum_j z_j\cos\gamma_j = \tfrac32 p"),
    (PINS, r"\sum_k z_k\sin\delta_k = -\frac{\sqrt3}{2}c"),
    (RULED, r"\sum_k x_k\cos\alpha_k = \tfrac32 p"),
    (RULED, r"\sum_k x_k\sin\alpha_k = -\tfrac{\sqrt3}{2}p"),
    (FOUR_BELOW, r"\sum_i x_i\cos\beta_i = -2b"),
    (THREE_THEN_FIVE, r"\sum_i z_i\cos 2\varphi_i = -4.736\,a"),
    (TWO_TABLES, r"\sum z_k\cos\beta_k = 3a"),
]
WRONG = [
    (FIVE, r"\sum_i \frac{z_i}{a}\cos\varphi_i = -0.364"),
    (FIVE, r"\sum_i z_i\sin\varphi_i = -0.363\,a"),
    (FIVE, r"\sum_i z_i\cos 2\varphi_i = 4.736\,a"),
    (CROSS, r"\sum\frac{z_k}{b}\cos\beta_k = -2"),
    (CROSS, r"\sum\frac{z_k}{b}\sin\beta_k = 1"),
    (SPOKEN, r"\sum z_k\cos\beta_k = 2a"),
    (SPOKEN, r"\left(\sum z_k\cos\beta_k\right)^2 + \left(\sum z_k\sin\beta_k\right)^2 = 8a^2"),
    (MANETONS, r"\sum_j z_j\cos\gamma_j = \tfrac12 p"),
    (PINS, r"\sum_k z_k\sin\delta_k = \frac{\sqrt3}{2}c"),
    (RULED, r"\sum_k x_k\cos\alpha_k = -\tfrac32 p"),
    (RULED, r"\sum_k x_k\sin\alpha_k = \tfrac{\sqrt3}{2}p"),
    (FOUR_BELOW, r"\sum_i x_i\cos\beta_i = 2b"),
    (THREE_THEN_FIVE, r"\sum_i z_i\cos 2\varphi_i = -1.5\,a"),
    (TWO_TABLES, r"\sum z_k\cos\beta_k = \tfrac32 a"),
]


@pytest.mark.parametrize(("page", "formula"), RIGHT)
def test_a_sum_over_a_table_is_computed(page, formula):
    assert last(f"{page}$${formula}$$").verdict in PROVED_WORDS


@pytest.mark.parametrize(("page", "formula"), WRONG)
def test_a_wrong_sum_over_a_table_is_refuted(page, formula):
    assert last(f"{page}$${formula}$$").verdict == REFUTED


def test_the_cosines_of_a_table_are_no_crank_angles():
    table = (
        "| throw | $\\psi$ | $\\cos\\psi$ | $\\sin\\psi$ |\n|---|---|---|---|\n"
        "| 1 | 0° | 1 | 0 |\n| 2 | 180° | -1 | 0 |\n\n"
    )
    found = last(f"{table}$$\\sum_i \\cos\\psi_i = \\cos 1^\\circ + 3$$")
    assert found.verdict not in PROVED_WORDS
    assert "0°, 1°" not in found.reason
