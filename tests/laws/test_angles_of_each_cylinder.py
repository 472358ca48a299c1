"""The angle from a cylinder's own top dead centre is the piston's, beside one from the banks' middle."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.verdicts import CONDITIONAL, PROVED_WORDS, REFUTED

OF_BANKS = "Kurbelwinkel, gezählt von der Symmetrieebene der beiden Bänke"
REST = {
    r"\lambda": "Schubstangenverhältnis r/l", r"\omega": "Winkelgeschwindigkeit der Kurbelwelle [1/s]",
    "r": "Kurbelradius [mm]", "x": "Kolbenweg ab OT",
}  # fmt: skip
OWN = [
    "Kurbelwinkel ab OT des jeweiligen Zylinders",
    "crank angle from top dead centre of its cylinder",
    "crank angle from TDC of the respective cylinder",
]


def last(page: str, symbols):
    checked = sb.check(page + "\n", {"symbols": symbols})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


@pytest.mark.parametrize("words", OWN)
def test_it_is_the_crank_angle(words):
    assert role_of(words) == "crank angle"
    assert (
        role_of(words.replace("TDC", "BDC").replace("OT", "UT").replace("top", "bottom")) != "crank angle"
    )


@pytest.mark.parametrize("letter", [r"\alpha", r"\psi"])
@pytest.mark.parametrize("words", OWN)
def test_a_motion_is_a_formula_of_it(letter, words):
    symbols = {r"\varphi": OF_BANKS, letter: words, **REST}
    right = rf"$$\dot x \approx r\omega\left(\sin{letter}+\tfrac{{\lambda}}{{2}}\sin 2{letter}\right)$$"
    wrong = rf"$$\dot x \approx r\omega\left(\sin{letter}+\lambda\sin 2{letter}\right)$$"
    assert last(right, symbols).verdict in PROVED_WORDS
    assert last(wrong, symbols).verdict == REFUTED


OF_TIME = {
    "x": "piston position, measured from the crank axis",
    r"\omega": "angular velocity of the crank [rad/s]", "t": "time [s]",
    "r": "crank radius", "l": "rod length",
}  # fmt: skip
PHASES = (
    "The throws are at $\\phi_1 = 0$, $\\phi_2 = 120^\\circ$: $F_i = F\\cos(\\omega t - \\phi_i)$.\n\n"
)


@pytest.mark.parametrize(
    ("formula", "verdicts"),
    [
        (r"x \approx l - \frac{r^2}{4l} + r(\cos\omega t + \frac{r}{4l}\cos 2\omega t)", PROVED_WORDS),
        (r"x \approx l - \frac{r^2}{2l} + r(\cos\omega t + \frac{r}{4l}\cos 2\omega t)", (REFUTED,)),
        (r"\ddot x \approx -r\omega^2(\cos\omega t + \frac{r}{l}\cos 2\omega t)", PROVED_WORDS),
        (r"\ddot x \approx -r\omega^2(\cos\omega t + \frac{r}{2l}\cos 2\omega t)", (REFUTED,)),
    ],
)
def test_the_angle_is_that_of_time_beside_phases(formula, verdicts):
    assert last(f"{PHASES}$${formula}$$", OF_TIME).verdict in verdicts


PIN = {"m_r": "rotating mass", "m_o": "reciprocating mass of one cylinder"}


@pytest.mark.parametrize(
    ("page", "is_wrong"),
    [
        ("# V8\n\nThe bob weight is $m_B = m_r + \\tfrac12\\cdot 2m_o$.", False),
        ("# V-twin\n\nThe bob weight is $m_B = m_r + m_o$.", False),
        ("# V6-Motor\n\nDas Meistergewicht ist $m_B = m_r + \\tfrac12\\cdot 2m_o$.", False),
        ("# Single\n\nThe bob weight is $m_B = m_r + m_o$.", True),
        ("# Einzylinder\n\nDas Meistergewicht ist $m_B = m_r + m_o$.", True),
    ],
)
def test_a_pin_of_two_rods_has_the_whole_of_one(page, is_wrong):
    assert (last(page, PIN).verdict == REFUTED) == is_wrong


RATIO = {r"\kappa": "crank ratio r/l", "R": "crank radius [m]", "L": "rod length [m]"}
RATIOS = "The rod ratio is $\\kappa = R/L$, with $R = 45$ mm and $L = 150$ mm.\n\n"


@pytest.mark.parametrize(
    ("number", "is_right"), [("0.738", True), ("0.758", False), ("0.707", False), ("0.74", True)]
)
def test_a_ratio_with_a_number_is_put_in(number, is_right):
    found = last(
        f"{RATIOS}$$y_q \\approx R\\sqrt{{\\tfrac12(1+\\kappa^2)}} \\approx {number}\\,R$$", RATIO
    )
    assert (found.verdict in PROVED_WORDS) == is_right


@pytest.mark.parametrize("word", ["e", "y", "och", "and", "et"])
def test_a_list_of_cranks_ends_with_any_and(word):
    page = f"The cranks are at 0°, 180°, 180° {word} 0°.\n\n"
    assert last(page + r"$$\sum_i \cos 2\theta_i = 4\cos 2\theta$$", {}).verdict == CONDITIONAL
    assert last(page + r"$$\sum_i \cos 2\theta_i = 3\cos 2\theta$$", {}).verdict == REFUTED
