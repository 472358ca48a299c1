"""Forces, weights and firings of a crank drive: what is none of their formulas is wrong."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, REFUTED

WRONG_WORDS = (REFUTED, CONTRADICTION)
GAS = "The piston force is $F$, the rod makes the angle $\\phi$ with the cylinder "
GAS += "axis, the crank $\\theta$. "
SHARE = "A counterweight opposite to the crank of a single cylinder balances the fraction $c$ of the"
SHARE += " reciprocating mass $m$ on the crank radius $r$. "
WEIGHT = (
    "In a single-cylinder engine the counterweight balances the rotating mass $m_r$ and the fraction $c$"
)
WEIGHT += " of the reciprocating mass $m$. The crank radius is $r$. The counterweight needs "
SHAFTS = "Two counter-rotating balance shafts turning at twice the speed cancel the second order of a"
SHAFTS += (
    " four-cylinder in-line engine; $m$ is the reciprocating mass of a cylinder, $r$ the crank radius, "
)
SHAFTS += "$\\lambda = r/l$. Each shaft needs "
FOUR = "Un moteur à quatre temps possède $z$ cylindres. Le nombre de temps moteurs par "
FOUR += "tour de vilebrequin est "
EIGHT = "Ein Viertaktmotor hat acht Zylinder. Die Zahl der Arbeitstakte je Umdrehung ist "
PLANES = "The unbalance $m r$ lies between two correction planes A and B, at $a$ from "
PLANES += "plane A and $b$ from plane"
PLANES += " B. The correction in plane A is "
ROD_RATE = "The crank turns at $\\omega$, $n = l/r$ is the rod ratio. The angular velocity "
ROD_RATE += "of the connecting rod is "
STAR = "In a radial engine $z$ cylinders act on one crank pin; $m$ is the reciprocating mass of one. The"
STAR += " primary forces combine to "
LEFT = (
    (
        GAS + "The side force is ",
        "N = F\\tan\\phi",
        ("N = F\\cot\\phi", "N = F\\cos\\phi", "N = 2F\\tan\\phi"),
    ),
    (
        GAS + "The force in the connecting rod is ",
        "S = F/\\cos\\phi",
        ("S = F\\cos\\phi", "S = F/\\sin\\phi"),
    ),
    (
        GAS + "The tangential force is ",
        "T = F\\frac{\\sin(\\theta+\\phi)}{\\cos\\phi}",
        ("T = F\\sin(\\theta+\\phi)\\cos\\phi", "T = F\\frac{\\cos\\phi}{\\sin(\\theta+\\phi)}"),
    ),
    (
        GAS + "The radial force, positive towards the crankshaft centre, is ",
        "R = F\\frac{\\cos(\\theta+\\phi)}{\\cos\\phi}",
        ("R = -F\\frac{\\cos(\\theta+\\phi)}{\\cos\\phi}",),
    ),
    (
        ROD_RATE,
        "\\omega_r = \\frac{\\omega\\cos\\theta}{\\sqrt{n^2-\\sin^2\\theta}}",
        ("\\omega_r = \\frac{n\\omega\\cos\\theta}{\\sqrt{n^2-\\sin^2\\theta}}",),
    ),
    (
        SHARE + "Perpendicular to the cylinder the force has the amplitude ",
        "F_y = c m r \\omega^2",
        ("F_y = (1-c) m r \\omega^2", "F_y = m r \\omega^2/c"),
    ),
    (WEIGHT, "m_b r_b = (m_r + c m) r", ("m_b r = (m_r + c m) r_b", "m_b r_b = (m_r + 2 c m) r")),
    (
        SHAFTS,
        "m_s r_s = \\lambda m r/2",
        ("m_s r_s = \\lambda m r", "2 m_s r_s \\omega^2 = 4\\lambda m r\\omega^2"),
    ),
    (FOUR, "k = z/2", ("k = z", "k = 2z", "k = z/4")),
    (EIGHT, "N = \\frac{8}{2}", ("N = 8", "N = 2\\cdot 8", "N = \\frac{8}{4}")),
    (
        PLANES,
        "m_A r_A = m r \\frac{b}{a+b}",
        ("m_A r_A = m r \\frac{a}{a+b}", "m_A r_A = m r \\frac{b}{a}"),
    ),
    (
        STAR,
        "F_1 = \\frac{z}{2} m r\\omega^2",
        ("F_1 = z m r\\omega^2", "F_1 = \\frac{z}{4} m r\\omega^2"),
    ),
)


def last_word(page):
    return max(check(page, {}).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(("opening", "right"), [(opening, right) for opening, right, _ in LEFT])
def test_the_standard_formula_is_not_refuted(opening, right):
    assert last_word(f"{opening}${right}$.\n") not in WRONG_WORDS


@pytest.mark.parametrize(
    ("opening", "wrong"), [(opening, each) for opening, _, wrong in LEFT for each in wrong]
)
def test_any_other_formula_of_its_letters_is_wrong(opening, wrong):
    assert last_word(f"{opening}${wrong}$.\n") in WRONG_WORDS


@pytest.mark.parametrize(
    "formula", ["F_2 = \\lambda m r\\omega^2\\cos 2\\theta", "F_2 = 2\\lambda m r\\omega^2\\cos 2\\theta"]
)
def test_one_cylinder_s_order_is_not_that_of_four(formula):
    page = (
        "In an in-line four the cranks stand at 0°, 180°, 180°, 0°. Every piston has the oscillating mass"
        f" $m$, and $\\lambda = r/l$. The secondary forces add up to ${formula}$.\n"
    )
    assert last_word(page) not in PROVED_WORDS


def test_a_ratio_declared_in_words_says_which_way_it_is():
    symbols = {"n": "ratio of connecting rod length to crank radius [-]", "F": "piston force [N]"}
    page = "The turning moment is $T = F r\\left(\\sin\\theta + \\frac{n\\sin 2\\theta}{2}\\right)$.\n"
    assert check(page, symbols).verdicts[-1].verdict not in PROVED_WORDS
