"""Unbalances, forces and grades of balance with their units: powers of ten and the 60 of minutes."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED

WRONG_WORDS = (REFUTED, CONTRADICTION)
ROTOR = "The rotor of 8 kg has its centre of mass 25 µm off the axis and turns at 6000 rpm. "
GRADE = "Ein Rotor von 5 kg läuft mit 3000 1/min in der Gütestufe G 2,5. "
FORCE = "An unbalance $U$ in g mm turns at $n$ in 1/min. The centrifugal force in N is $F = FORMULA$.\n"
ECCENTRICITY = "Die Gütestufe $G$ steht in mm/s, die Drehzahl $n$ in 1/min. "
ECCENTRICITY += "Die zulässige Exzentrizität in µm ist $e_z = FORMULA$.\n"
FIRST = (
    (f"{ROTOR}Its unbalance is $U = 8000 \\cdot 0.025 = 200$ g mm.\n", True),
    (f"{ROTOR}Its unbalance is $U = 8000 \\cdot 0.25 = 2000$ g mm.\n", False),
    (f"{ROTOR}The centrifugal force is $F = 8\\cdot 25\\cdot 10^{{-6}}\\cdot 628^2 = 78.9$ N.\n", True),
    (f"{ROTOR}The centrifugal force is $F = 8\\cdot 25\\cdot 10^{{-6}}\\cdot 6000^2 = 7200$ N.\n", False),
    (f"{GRADE}Die zulässige Exzentrizität ist $e_z = 2500/314 = 7{{,}}96$ µm.\n", True),
    (f"{GRADE}Die zulässige Exzentrizität ist $e_z = 2500/3000 = 0{{,}}83$ µm.\n", False),
    (
        f"{GRADE}Die zulässige Restunwucht je Ebene ist $U = 5\\cdot 7{{,}}96/2 = 19{{,}}9$ g mm.\n",
        True,
    ),
    (FORCE.replace("FORMULA", "10^{-6} U (\\pi n/30)^2"), True),
    (FORCE.replace("FORMULA", "10^{-6} U (2\\pi n)^2"), False),
    (ECCENTRICITY.replace("FORMULA", "\\frac{G \\cdot 60000}{2\\pi n}"), True),
    (ECCENTRICITY.replace("FORMULA", "\\frac{G \\cdot 1000}{2\\pi n}"), False),
    (FORCE.replace("FORMULA", "10^{-3} U (\\pi n/30)^2"), False),
)


def first_word(page):
    verdicts = check(page, {}).verdicts
    return min(verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(("page", "is_right"), FIRST)
def test_a_value_is_judged_by_the_units_of_its_sizes(page, is_right):
    assert (first_word(page) in WRONG_WORDS) is not is_right


def test_an_arithmetic_slip_is_not_the_formula_s_fault():
    page = (
        f"{ROTOR}Its unbalance is $U = 8000\\ \\mathrm{{g}} \\cdot 0.025\\ \\mathrm{{mm}} = 2000$ g mm.\n"
    )
    assert first_word(page) not in WRONG_WORDS


def test_declared_units_say_it_too():
    symbols = {"F": "force [N]", "U": "unbalance [g mm]", "\\omega": "angular velocity [rad/s]"}
    page = "The centrifugal force in newtons is $F = FORMULA$.\n"
    right = check(page.replace("FORMULA", "10^{-6} U \\omega^2"), symbols).verdicts[0].verdict
    wrong = check(page.replace("FORMULA", "10^{-3} U \\omega^2"), symbols).verdicts[0].verdict
    assert right not in WRONG_WORDS
    assert wrong in WRONG_WORDS
