"""What half a balance leaves, a camshaft's speed, and a rod whose length is between its eyes."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from tests.checked_pages import last_in

HALF = [
    "The counterweight of a single takes up half of the reciprocating mass $m$, at the crank radius $r$. "
    "What remains along the cylinder is",
    "Das Gegengewicht eines Einzylinders gleicht die Hälfte der oszillierenden Masse $m$ am Kurbelradius "
    "$r$ aus. In Zylinderrichtung bleibt",
    "Le contrepoids équilibre la moitié de la masse alternative $m$ au rayon de manivelle $r$. "
    "Il reste suivant l'axe du cylindre",
    "Il contrappeso equilibra metà della massa alterna $m$ al raggio di manovella $r$. "
    "Lungo l'asse del cilindro rimane",
]


@pytest.mark.parametrize("words", HALF, ids=["en", "de", "fr", "it"])
def test_half_a_balance_leaves_half_the_force_along_the_cylinder(words: str) -> None:
    assert last_in(rf"{words} $F_x = \frac{{1}}{{2}} m r\omega^2\cos\theta$.") == "conditional"
    for wrong in (
        r"m r\omega^2\cos\theta",
        r"\frac{1}{2} m r\omega^2\sin\theta",
        r"\frac{1}{2} m r\omega\cos\theta",
    ):
        assert last_in(f"{words} $F_x = {wrong}$.") == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"A counterweight takes up half of the reciprocating mass $m$. The primary force along the "
        r"cylinder is $F = m r\omega^2\cos\theta$; half of it remains.",
        r"Without a counterweight $F = m r\omega^2\cos\theta$ remains along the cylinder.",
        r"The counterweight takes up half of the reciprocating mass. With the unbalanced mass $m$ what "
        r"remains along the cylinder is $F = m r\omega^2\cos\theta$.",
    ],
)
def test_the_whole_force_is_not_accused(page: str) -> None:
    assert last_in(page) != "refuted"


CAMS = [
    "In a four-stroke engine the camshaft speed is $n_c = {}$.",
    "Each valve opens once in every two revolutions. The speed of the camshaft is $n_c = {}$.",
    "Die Nockenwellendrehzahl eines Viertaktmotors ist $n_c = {}$.",
    "Dans un moteur à quatre temps, la vitesse de l'arbre à cames est $n_c = {}$.",
    "In un motore a quattro tempi la velocità dell'albero a camme è $n_c = {}$.",
    "En un motor de cuatro tiempos la velocidad del árbol de levas es $n_c = {}$.",
    "4サイクル機関ではカム軸の回転速度は $n_c = {}$ である。",
]


@pytest.mark.parametrize("page", CAMS)
def test_a_camshaft_turns_once_in_two_turns(page: str) -> None:
    assert last_in(page.format(r"\frac{n}{2}")) == "conditional"
    for wrong in ("2n", "n", r"\frac{n}{4}"):
        assert last_in(page.format(wrong)) == "refuted"


def test_another_camshaft_is_not_accused() -> None:
    assert last_in("In a two-stroke engine the camshaft speed is $n_c = n$.") != "refuted"
    page = "A cam with two lobes serves a four-stroke engine: the camshaft speed is $n_c = \\frac{n}{4}$."
    assert last_in(page) != "refuted"


def last_with(page: str, symbols: dict[str, str]) -> str:
    return max(check(page + "\n", symbols).verdicts, key=lambda v: (v.line, v.span)).verdict


EYES = [
    ("distance between the eyes [m]", "The rod is replaced by two masses. The mass at the small end is"),
    (
        "distance between its bearing centres [m]",
        "The rod is replaced by two masses. The mass at the small end is",
    ),
    ("Abstand zwischen den Augen [m]", "Zwei Massen ersetzen das Pleuel. Die Masse am kleinen Auge ist"),
    ("entraxe de la bielle [m]", "La bielle est remplacée par deux masses. La masse au pied est"),
    ("interasse della biella [m]", "La biella si sostituisce con due masse. La massa al piede è"),
    ("大端と小端の間の距離 [m]", "小端の質量は"),
]


@pytest.mark.parametrize(("length", "words"), EYES)
def test_a_rod_is_as_long_as_its_eyes_are_apart(length: str, words: str) -> None:
    symbols = {
        "m": "mass of the rod [kg]",
        "l": length,
        "a": "distance of the centre of gravity from the big end [m]",
    }
    assert last_with(f"{words} $m_1 = m\\frac{{a}}{{l}}$.", symbols) == "conditional"
    for wrong in (r"m\frac{l - a}{l}", r"m\frac{l}{a}", r"m\frac{a^2}{l^2}"):
        assert last_with(f"{words} $m_1 = {wrong}$.", symbols) == "refuted"


VEES = [
    "Two cylinders with the V-angle $\\gamma$ work on one crank pin, $\\theta$ counts from the "
    "axis of symmetry. {} the axis of symmetry acts",
    "Zwei Zylinder mit dem V-Winkel $\\gamma$ arbeiten auf einen Hubzapfen, $\\theta$ zählt ab der "
    "Symmetrieachse. {} Symmetrieachse wirkt",
    "Deux cylindres avec l'angle du V $\\gamma$ agissent sur le même maneton, $\\theta$ est compté "
    "depuis l'axe de symétrie. {} l'axe de symétrie agit",
    "Due cilindri con l'angolo del V $\\gamma$ agiscono sullo stesso perno di manovella, $\\theta$ "
    "si conta dall'asse di simmetria. {} l'asse di simmetria agisce",
]
WAYS = [("Along", "Across"), ("In der", "Quer zur"), ("Suivant", ""), ("Lungo", "")]


@pytest.mark.parametrize(("page", "ways"), [*zip(VEES, WAYS, strict=True)])
def test_a_vee_of_any_angle_along_and_across_its_middle(page: str, ways: tuple[str, str]) -> None:
    for words, one, other, wave in (
        (ways[0], r"\cos", r"\sin", r"\cos"),
        (ways[1], r"\sin", r"\cos", r"\sin"),
    ):
        if not words:
            continue
        formula = page.format(words) + r" $F = 2 m r\omega^2{}\frac{{\gamma}}{{2}}" + f"{wave}\\theta$."
        assert last_in(formula.format(one + "^2")) == "conditional"
        assert last_in(formula.format(one)) == "refuted"
        assert last_in(formula.format(other + "^2")) == "refuted"
        of_whole = formula.replace(r"\frac{{\gamma}}{{2}}", r"\gamma")
        assert last_in(of_whole.format(one + "^2")) != "conditional"


def test_the_mere_sum_of_two_forces_is_no_component() -> None:
    page = VEES[1].partition(" {}")[0] + " Die Summe der beiden Kräfte ist "
    page += r"$S = 2 m r\omega^2\cos\frac{\gamma}{2}\cos\theta$. In der Symmetrieachse wirkt "
    page += r"$F = 2 m r\omega^2\cos^2\frac{\gamma}{2}\cos\theta$."
    assert last_in(page.partition(" In der Symmetrieachse wirkt")[0]) != "refuted"
    assert last_in(page) == "conditional"
