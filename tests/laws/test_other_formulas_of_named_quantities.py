"""A formula in the letters of a named quantity's standard one is wrong where it agrees with none."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED


def verdicts(page: str) -> list[str]:
    checked = check(page + "\n", {})
    assert not checked.faults
    return [verdict.verdict for verdict in checked.verdicts]


OSCILLATOR = "A mass $m$ hangs from a spring of stiffness $k$ beside a damper of constant $c$."
OTTO = "In the ideal Otto cycle with the compression ratio $r$ and the isentropic exponent $\\gamma$"
SQUEEZED = (
    "A gas is compressed adiabatically; its volume becomes $r$ times smaller. The end temperature is"
)
THREE = "Three equal discs of inertia $J$ sit on a shaft, two pieces of stiffness $k$ between them."
RIM = "A thin rim of mean diameter $D$ has the mass $m$. The moment of inertia is"
BRAKED = "The flywheel of inertia $J$ slows from $\\omega_1$ to $\\omega_2$. The energy given off is"
VOLUMES = "With the swept volume $V_h$ and the clearance volume $V_c$ the compression ratio is"
FOUR = "A four-stroke engine has $z$ cylinders and turns at $n$ revolutions per minute."
TWINS = [
    (f"{OSCILLATOR} The damping ratio is ", "\\zeta = \\frac{c}{2\\sqrt{k m}}",
     ["\\zeta = \\frac{c}{2 k m}", "\\zeta = \\frac{2\\sqrt{k m}}{c}"]),
    ("Der Schwinger hat das Dämpfungsmaß $D$. Der Gütefaktor ist ", "Q = \\frac{1}{2 D}",
     ["Q = 2 D", "Q = \\frac{1}{D}", "Q = \\frac{2}{D}"]),
    ("Le taux d'amortissement est $\\xi$. Le facteur de qualité vaut ", "Q = \\frac{1}{2\\xi}",
     ["Q = 2\\xi", "Q = \\frac{1}{\\xi}"]),
    ("減衰比を $\\zeta$ とする。Q値は", "Q = \\frac{1}{2\\zeta}", ["Q = \\frac{1}{\\zeta}",
    "Q = 2\\zeta"]),
    ("For a small damping ratio $\\zeta$ the logarithmic decrement is ", "\\delta = 2\\pi\\zeta",
     ["\\delta = \\pi\\zeta", "\\delta = \\frac{\\zeta}{2\\pi}", "\\delta = \\frac{2\\pi}{\\zeta}"]),
    (f"{THREE} In the second mode the middle one swings against the others with ",
     "\\omega_2^2 = \\frac{3 k}{J}",
     ["\\omega_2^2 = \\frac{2 k}{J}", "\\omega_2^2 = \\frac{9 k}{J}"]),
    (f"{OTTO} the thermal efficiency is ", "\\eta = 1 - \\frac{1}{r^{\\gamma - 1}}",
     ["\\eta = 1 - \\frac{1}{r^{\\gamma}}", "\\eta = 1 + \\frac{1}{r^{\\gamma - 1}}",
      "\\eta = \\frac{1}{r^{\\gamma - 1}}"]),
    (f"{SQUEEZED} ", "T_2 = T_1 r^{\\gamma - 1}", ["T_2 = T_1 r^{\\gamma}", "T_2 = T_1 r^{1 - \\gamma}"]),
    (f"{RIM} ", "J = \\frac{m D^2}{4}", ["J = \\frac{m D^2}{8}", "J = \\frac{m D^2}{2}"]),
    (f"{BRAKED} ", "E = \\frac{J}{2}(\\omega_1^2 - \\omega_2^2)",
     ["E = \\frac{J}{2}(\\omega_1 - \\omega_2)^2", "E = J(\\omega_1^2 - \\omega_2^2)",
      "E = \\frac{J}{2}(\\omega_2^2 - \\omega_1^2)"]),
    (f"At bottom dead centre both volumes are filled. {VOLUMES} ", "\\varepsilon = \\frac{V_h + "
        "V_c}{V_c}",
     ["\\varepsilon = \\frac{V_h}{V_c}", "\\varepsilon = \\frac{V_h - V_c}{V_c}"]),
    (f"{FOUR} Each of them fires once in two revolutions. The firing frequency is ",
     "f = \\frac{n z}{120}", ["f = \\frac{n z}{60}", "f = \\frac{n z}{30}", "f = \\frac{120 n}{z}"]),
    ("Der Motor hat $z$ Zylinder mit der Bohrung $d$ und dem Hub $s$. Der Gesamthubraum ist ",
     "V = \\frac{\\pi d^2}{4} s z", ["V = \\pi d^2 s z", "V = \\frac{\\pi d^2}{2} s z"]),
    ("Die Welle überträgt das Drehmoment $T$ bei der Winkelgeschwindigkeit $\\omega$. Die Leistung ist ",
     "P = T \\omega", ["P = \\frac{T \\omega}{2}", "P = \\frac{T}{\\omega}"]),
]  # fmt: skip


@pytest.mark.parametrize(("words", "right"), [(words, right) for words, right, _ in TWINS])
def test_the_standard_formula_holds(words, right):
    assert verdicts(f"{words}${right}$.")[-1] in PROVED_WORDS


@pytest.mark.parametrize(
    ("words", "wrong"), [(words, each) for words, _, wrong in TWINS for each in wrong]
)
def test_another_formula_of_its_letters_is_refuted(words, wrong):
    assert verdicts(f"{words}${wrong}$.")[-1] == REFUTED


@pytest.mark.parametrize(
    "page",
    [
        "In each mode half of the damping ratio counts. The quality factor is $Q = \\frac{1}{2\\zeta}$.",
        "The equivalent torque is $T_e = \\sqrt{M^2 + T^2}$ and the equivalent bending moment is"
        " $M_e = \\frac{M + T_e}{2}$.",
        "With the big end's share $m_B$ and the piston $m_p$ the reciprocating mass is $m = m_p + m_B$.",
        "At small damping $\\zeta$ the damped natural frequency is $\\omega_d = \\omega_0 (1 - "
        "\\zeta^2/2)$.",
        "A gas expands adiabatically after the compression. The temperature is $T_4 = T_3 r^{1 - "
        "\\gamma}$.",
        "The flywheel of inertia $J$ speeds up from $\\omega_1$ to $\\omega_2$. The energy stored is"
        " $E = \\frac{J}{2}(\\omega_2^2 - \\omega_1^2)$.",
    ],
)
def test_what_may_be_meant_is_left_alone(page):
    assert REFUTED not in verdicts(page)


NUMBERS = [
    ("The steel yields at $S_y = 300$ MPa and the equivalent stress is $\\sigma_v = 120$ MPa. The "
        "factor of"
     " safety against yielding is ", "n = \\frac{300}{120} = 2.5", ["n = \\frac{120}{300} = 0.4",
                                                               "n = 300 - 120 = 180"]),
    ("Ein Viertaktmotor mit $z = 6$ Zylindern dreht mit $n = 1500\\,\\mathrm{min^{-1}}$. Die "
        "Zündfrequenz ist ",
     "f = \\frac{1500}{60} \\cdot \\frac{6}{2} = 75\\,\\mathrm{Hz}",
     ["f = \\frac{1500}{60} \\cdot 6 = 150\\,\\mathrm{Hz}",
      "f = \\frac{1500}{60} \\cdot \\frac{2}{6} = 8.33\\,\\mathrm{Hz}"]),
    ("A flywheel of $J = 0.4\\,\\mathrm{kg\\,m^2}$ turns at $\\omega = 150\\,\\mathrm{rad/s}$. It "
        "stores ",
     "E = \\frac{1}{2} \\cdot 0.4 \\cdot 150^2 = 4500\\,\\mathrm{J}",
     ["E = 0.4 \\cdot 150^2 = 9000\\,\\mathrm{J}", "E = \\frac{1}{2} \\cdot 0.4 \\cdot 150 = "
         "30\\,\\mathrm{J}"]),
]  # fmt: skip


@pytest.mark.parametrize(("words", "right"), [(words, right) for words, right, _ in NUMBERS])
def test_the_numbers_put_in_are_not_refuted(words, right):
    assert REFUTED not in verdicts(f"{words}${right}$.")


@pytest.mark.parametrize(
    ("words", "wrong"), [(words, each) for words, _, wrong in NUMBERS for each in wrong]
)
def test_other_formulas_of_the_numbers_are_refuted(words, wrong):
    assert REFUTED in verdicts(f"{words}${wrong}$.")


SOLVED = (
    "The compression ratio is $\\varepsilon = \\frac{V_h + V_c}{V_c}$ with the swept volume $V_h$."
    " The clearance volume is "
)
MODULUS = "Un tube a le diamètre extérieur $D$ et intérieur $d$. Le module de flexion vaut "
LINE = (
    "By Soderberg's line with the endurance limit $S_e$, the yield strength $S_y$, the stress amplitude "
    "$\\sigma_a$ and"
    " the mean stress $\\sigma_m$, the factor of safety $N$ follows from "
)


@pytest.mark.parametrize(
    ("page", "wrong"),
    [
        (f"{SOLVED}$V_c = \\frac{{V_h}}{{\\varepsilon - 1}}$.", False),
        (f"{SOLVED}$V_c = \\frac{{V_h}}{{\\varepsilon + 1}}$.", True),
        (f"{MODULUS}$\\frac{{I}}{{v}} = \\frac{{\\pi (D^4 - d^4)}}{{32 D}}$.", False),
        (f"{MODULUS}$\\frac{{I}}{{v}} = \\frac{{\\pi (D^3 - d^3)}}{{32}}$.", True),
        (f"{LINE}$\\frac{{\\sigma_a}}{{S_e}} + \\frac{{\\sigma_m}}{{S_y}} = \\frac{{1}}{{N}}$.", False),
        (f"{LINE}$\\frac{{\\sigma_a}}{{S_y}} + \\frac{{\\sigma_m}}{{S_e}} = \\frac{{1}}{{N}}$.", True),
        (f"{LINE}$\\frac{{\\sigma_a}}{{S_e}} + \\frac{{\\sigma_m}}{{S_y}} = N$.", True),
    ],
)
def test_what_has_to_be_solved_is_judged_by_its_words_too(page, wrong):
    assert (REFUTED in verdicts(page)) is wrong
