"""A rod's mass at one of its ends, by the words that say from which end the distance counts."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, REFUTED

ENGLISH = (
    "The connecting rod of mass $m$ and length $l$ has its centre of gravity at $c$ from the big end."
)
FRENCH = "La bielle, de masse $m$ et d'entraxe $l$, a son centre de gravité à la distance $c$ de"
FRENCH += " la tête de bielle."
JAPANESE = "質量 $m$、長さ $l$ の連接棒の重心は大端から距離 $c$ にある。"
DECLARED = {
    "m": "Masse des Pleuels [kg]",
    "l": "Länge des Pleuels [m]",
    "c": "Abstand des Schwerpunkts vom großen Auge [m]",
    "m_a": "oszillierender Anteil der Pleuelmasse [kg]",
}
RIGHT = ("m c/l", "m \\frac{c}{l}", "m \\left(1 - \\frac{l-c}{l}\\right)")
WRONG = ("m \\frac{l-c}{l}", "m \\frac{l}{c}", "m \\frac{c}{l-c}", "m \\left(1-\\frac{c}{l}\\right)")
PAGES = (
    f"{ENGLISH} The mass allotted to the small end is $m_a = FORMULA$.\n",
    f"{FRENCH} La masse rapportée au pied de bielle est $m_a = FORMULA$.\n",
    f"{JAPANESE}小端に置く質量は $m_a = FORMULA$ である。\n",
)


def last_word(page, symbols=None):
    return max(check(page, symbols or {}).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("share", RIGHT)
def test_the_small_end_takes_the_distance_from_the_big_one(page, share):
    assert last_word(page.replace("FORMULA", share)) in PROVED_WORDS


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("share", WRONG)
def test_any_other_share_is_wrong(page, share):
    assert last_word(page.replace("FORMULA", share)) in (REFUTED, CONTRADICTION)


@pytest.mark.parametrize("share", [*RIGHT, *WRONG])
def test_a_declared_distance_says_its_end_too(share):
    page = f"Dem Kolbenbolzen rechnet man zu: $m_a = {share}$.\n"
    expected = PROVED_WORDS if share in RIGHT else (REFUTED, CONTRADICTION)
    assert last_word(page, DECLARED) in expected


@pytest.mark.parametrize(
    ("formula", "is_right"),
    [
        ("m_p + m_c \\left(1-\\frac{h}{l}\\right)", True),
        ("m_p + m_c \\frac{l-h}{l}", True),
        ("m_p + m_c \\frac{h}{l}", False),
        ("m_p - m_c \\left(1-\\frac{h}{l}\\right)", False),
    ],
)
def test_the_reciprocating_mass_has_the_small_end_of_its_rod(formula, is_right):
    symbols = {
        "m_p": "mass of the piston [kg]",
        "m_c": "mass of the connecting rod [kg]",
        "h": "distance of the centre of gravity of the rod from the small end [m]",
        "l": "rod length [m]",
    }
    verdict = last_word(f"The reciprocating mass is $m_r = {formula}$.\n", symbols)
    assert verdict in (PROVED_WORDS if is_right else (REFUTED, CONTRADICTION))


@pytest.mark.parametrize(
    ("formula", "is_right"), [("m a b", True), ("m (a+b)^2", False), ("m (a^2+b^2)", False)]
)
def test_two_masses_in_place_of_a_rod_have_another_inertia(formula, is_right):
    page = (
        "A connecting rod of mass $m$ is split in two; its ends are at the distances $a$ and $b$ from the"
        f" centre of gravity. The two-mass model has the moment of inertia $J = {formula}$ about it.\n"
    )
    assert last_word(page) in (PROVED_WORDS if is_right else (REFUTED, CONTRADICTION))


def test_numbers_put_in_are_judged_by_the_end_too():
    opening = (
        "A connecting rod of 1.5 kg is 180 mm long; its centre of gravity is 60 mm from the big end. "
    )
    line = "The part counted as reciprocating is $m = 1.5\\cdot\\frac{NUMBER}{180}$ kg.\n"
    assert last_word(opening + line.replace("NUMBER", "60")) not in (REFUTED, CONTRADICTION)
    assert last_word(opening + line.replace("NUMBER", "120")) == REFUTED
