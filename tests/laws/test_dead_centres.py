"""Values at the dead centres that words name: b₁ and b₂ of b, ẍ in OT and in UT."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, DEFINITION, PROVED_WORDS, REFUTED, UNDECIDED

ACCELERATION = r"""Es bezeichne r den Kurbelhalbmesser, l die Länge der Schubstange, λ = r : l das
Stangenverhältnis und α den Kurbelwinkel.

Die Beschleunigung des Kolbens ist b ≈ r ω² (cos α + λ cos 2α).

%s
"""
MATHS = r"$b \approx r \omega^2(\cos\alpha + \lambda\cos 2\alpha)$"
DISPLACEMENT = r"""Kurbelradius $r$, Pleuellänge $l$, $\lambda = r/l$, Kurbelwinkel
$\varphi=\omega t$ ab OT.

Der Kolbenweg ist
$$x = r(1-\cos\varphi) + l(1-\cos\beta)$$

mit $l\sin\beta = r\sin\varphi$, und damit $x \approx r(1-\cos\varphi+\frac\lambda2\sin^2\varphi)$.

%s
"""


def last_verdict(page: str):
    checked = check(page, {})
    assert not checked.faults
    return checked.verdicts[-1]


@pytest.mark.parametrize(
    "line",
    [
        "In den Totlagen wird b₁ = r ω² (1 + λ).",
        "In den Totlagen wird b₁ = r ω² (1 + λ) und b₂ = − r ω² (1 − λ).",
        "In den Totlagen wird b₁ = − r ω² (1 − λ) und b₂ = r ω² (1 + λ).",
    ],
)
def test_an_indexed_letter_holds_as_the_value_at_a_dead_centre(line):
    verdict = last_verdict(ACCELERATION % line)
    assert verdict.verdict == CONDITIONAL
    assert "by the words before" in verdict.assumption


@pytest.mark.parametrize(
    ("line", "word"),
    [
        ("Es wird $b_{OT} = r \\omega^2 (1 + \\lambda)$.", CONDITIONAL),
        ("Es wird $b_{bdc} = - r \\omega^2 (1 - \\lambda)$.", CONDITIONAL),
        ("Es wird $b_{bdc} = - r \\omega^2 (1 + \\lambda)$.", REFUTED),
        ("Es wird $b_{OT} = r \\omega^2 (1 + \\lambda^2)$.", REFUTED),
        ("Es wird $b_{UT} = r \\omega^2 (1 - \\lambda)$.", DEFINITION),  # its size
        ("Es wird $b_{OT} = 1800$.", DEFINITION),
        ("Es wird $b_{OT} = k r \\omega^2$.", DEFINITION),
    ],
)
def test_an_index_that_names_the_dead_centre_says_which_value_it_is(line, word):
    page = ACCELERATION.replace("b ≈ r ω² (cos α + λ cos 2α)", MATHS) % line
    assert last_verdict(page).verdict == word


def test_the_value_of_one_dead_centre_with_the_other_sign_is_refuted_at_the_other():
    page = ACCELERATION % "In den Totlagen wird b₁ = r ω² (1 + λ) und b₂ = − r ω² (1 + λ)."
    assert last_verdict(page).verdict == REFUTED


@pytest.mark.parametrize(
    "line",
    [
        "In den Totlagen wird b₁ = r ω² und b₂ = λ r ω².",  # the orders
        "In den Totlagen wird b₁ = r ω² (1 + λ) und b₂ = r ω² (1 − λ).",  # the sizes
        "Danach wird b₁ = r ω² (1 + λ) und b₂ = − r ω² (1 + λ).",
        "In den Totlagen wird b₂ = − r ω² (1 + λ).",  # alone: the other direction may be meant
    ],
)
def test_what_may_be_another_thing_stays_a_definition(line):
    assert last_verdict(ACCELERATION % line).verdict == DEFINITION


@pytest.mark.parametrize(
    "line",
    [
        r"in OT: $\ddot x = r\omega^2(1+\lambda)$",
        r"in OT: $\ddot x = r\omega^2(1+\lambda)$, in UT: $\ddot x = -r\omega^2(1-\lambda)$",
        r"in UT: $x = 2r$",
    ],
)
def test_a_motion_whose_letters_words_explain_holds_there(line):
    assert last_verdict(DISPLACEMENT % line).verdict in PROVED_WORDS


@pytest.mark.parametrize(
    "line",
    [
        r"in OT: $\ddot x = r\omega^2(1-\lambda)$",
        r"in UT: $\ddot x = r\omega^2(1-\lambda)$",
        r"in UT: $\ddot x = -r\omega^2(1+\lambda)$",
        r"in UT: $x = 2r + l$",
        r"größte Kolbengeschwindigkeit: $\dot x_{max} = r\omega(1+\lambda)$",
        r"Die Geschwindigkeit des Kolbens ist $v \approx r\omega(\sin\varphi+\lambda\sin 2\varphi)$",
    ],
)
def test_a_wrong_value_is_refuted(line):
    assert last_verdict(DISPLACEMENT % line).verdict == REFUTED


def test_a_value_without_its_place_is_left_open():
    assert last_verdict(DISPLACEMENT % r"$\ddot x = r\omega^2(1+\lambda)$").verdict == UNDECIDED


def test_the_rod_turns_with_the_crank_where_only_its_formula_says_so():
    page = DISPLACEMENT % r"$\ddot x = r\omega^2\cos\varphi$"
    assert last_verdict(page).verdict != "holds"
