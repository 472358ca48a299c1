"""What remains of forces and couples, where letters are declared or words stand a little further off."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, DEFINITION, REFUTED


def last(page: str, symbols: dict[str, str] | None = None) -> str:
    checked = check(page + "\n", symbols or {})
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


THREES = [
    (
        "Für den Dreizylinder (Kröpfungen unter $120^\\circ$) bleiben Kippmomente mit den Amplituden",
        {
            "b": "Zylinderabstand",
            "F_1": "Amplitude der Massenkraft erster Ordnung eines Zylinders",
            "F_2": "Amplitude der Massenkraft zweiter Ordnung eines Zylinders",
            "M_1": "Amplitude des Massenmoments erster Ordnung",
            "M_2": "Amplitude des Massenmoments zweiter Ordnung",
        },
    ),
    (
        "The inline three with cranks at $120^\\circ$ and the cylinder spacing $b$ has the couples",
        {
            "b": "cylinder spacing",
            "F_1": "first-order force amplitude of one cylinder",
            "F_2": "second-order force amplitude of one cylinder",
            "M_1": "couple of first order",
            "M_2": "couple of second order",
        },
    ),
]


@pytest.mark.parametrize(("words", "symbols"), THREES)
def test_both_couples_of_a_three_are_root_three_of_one_cylinders(words, symbols):
    page = f"Der Zylinderabstand $b$ beträgt 88 mm. {words}\n\n$$M_1 = \\sqrt3\\,b\\,F_1$$"
    page = f"{page}\n\n$$M_2 = FACTOR\\,b\\,F_2$$"
    page = page.replace("$$\n\n$$", " , \\qquad ")
    assert last(page.replace("FACTOR", "\\sqrt3"), symbols) == CONDITIONAL
    assert last(page.replace("FACTOR", "\\frac{\\sqrt3}{2}"), symbols) == REFUTED


ACROSS = [
    "A counterweight takes a fraction $k$ of $m$. What is left, along the cylinder ($X$) and across it"
    " ($Y$):",
    "Ein Gegengewicht gleicht den Anteil $k$ von $m$ aus. Es bleibt längs ($X$) und quer dazu ($Y$) ein"
    " Rest:",
]


@pytest.mark.parametrize("words", ACROSS)
@pytest.mark.parametrize("sign", ["", "-"])
def test_across_the_cylinder_the_counterweight_acts_with_its_share(words, sign):
    page = f"{words}\n\n$$X = (1-k)\\,m r\\omega^2\\cos\\theta$$\n\n"
    page = f"{page}$$Y = {sign}SHARE\\,m r\\omega^2\\sin\\theta$$"
    assert last(page.replace("SHARE", "k")) == CONDITIONAL
    assert last(page.replace("SHARE", "(1-k)")) == REFUTED


VEES = (
    "# V-twin on one pin\n\nThe bank angle is $\\gamma$, and $\\theta$ is counted from the bisector.\n\n"
)


@pytest.mark.parametrize(
    ("factor", "verdict"),
    [
        (r"\sin\frac{\gamma}{2}\sin\gamma", CONDITIONAL),
        (r"\sin^2\frac{\gamma}{2}", REFUTED),
        (r"\sin^2\gamma", REFUTED),
        (r"\sin\frac{\gamma}{2}\cos\gamma", REFUTED),
    ],
)
def test_the_second_order_across_a_vee_has_both_angles(factor, verdict):
    along = "$$X_2 = 2\\lambda m r\\omega^2\\cos\\frac{\\gamma}{2}\\cos\\gamma\\cos 2\\theta$$\n\n"
    across = f"$$Y_2 = 2\\lambda m r\\omega^2 {factor}\\sin 2\\theta$$"
    assert last(VEES + along + across) == verdict


BOXERS = [
    "# Boxer twin\n\nThe cylinders of the boxer twin are staggered by $a$. The first-order couple is"
    " $M_1 = a m r\\omega^2\\cos\\theta$ and the second-order couple is $M_2 = VALUE$.",
    "# Zweizylinder-Boxermotor\n\nDie Zylinder sind um $a$ versetzt. Das Moment 1. Ordnung ist"
    " $M_1 = a m r\\omega^2\\cos\\varphi$, das Moment 2. Ordnung ist $M_2 = VALUE$.",
]


@pytest.mark.parametrize("page", BOXERS)
def test_a_boxer_with_one_couple_has_the_other(page):
    angle = "\\theta" if "theta" in page else "\\varphi"
    right = f"a\\lambda m r\\omega^2\\cos 2{angle}"
    assert last(page.replace("VALUE", right)) == CONDITIONAL
    assert last(page.replace("VALUE", "0")) == REFUTED


def test_a_boxer_whose_stagger_is_neglected_has_none():
    assert (
        last("In the boxer twin the second-order couple is $M_2 = 0$ if the stagger is neglected.")
        == DEFINITION
    )


TWINS = [
    "The first order of both pistons of the 270° twin is"
    " $R = \\sqrt2 m r\\omega^2\\cos(\\theta - 45^\\circ)$."
    " Half of it is taken by the crank's weights; one balance shaft that counter-rotates takes the rest:",
    "Il primo ordine del bicilindrico a 270° è"
    " $R = \\sqrt2 m r\\omega^2\\cos(\\theta - 45^\\circ)$. La metà la"
    " tolgo con i contrappesi, il resto con un contralbero controrotante:",
]


@pytest.mark.parametrize("words", TWINS)
def test_one_backward_shaft_takes_half_of_a_twins_first_order(words):
    page = f"{words}\n\n$$m_c r_c = VALUE$$"
    assert last(page.replace("VALUE", "\\frac{\\sqrt2}{2} m r")) == CONDITIONAL
    assert last(page.replace("VALUE", "\\sqrt2 m r")) == REFUTED
