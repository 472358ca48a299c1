"""Angles and conjugates of phasors: arg M = arctan(b/a), Re z = (z + z̄)/2."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import DEFINITION, HOLDS, HOLDS_TO_ORDER, REFUTED, UNDECIDED

PHASOR = (
    r"The phasor with $\zeta = e^{-2\pi i/5}$ is $M = 2+\zeta^2-\zeta^4-2\zeta = 0.2639 + 0.3633 i$."
    "\n\n"
)
TRUE = (HOLDS, HOLDS_TO_ORDER)


def last_verdict(page: str) -> str:
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(
    "formula",
    [
        r"\arg M = \arctan(0.3633/0.2639)",
        r"\arg M \approx 54^\circ",
        r"\operatorname{Arg} M = 0.9425",
        r"\mathrm{Arg}(M) = 0.9425",
        r"\angle M = 54^\circ",
        r"\arg(-M) = 234^\circ",
        r"\arg(-M) = -126^\circ",
        r"\arg(\zeta^2) = -144^\circ",
        r"\arg(3+4i) = 53.13^\circ",
        r"\arg(-1) = \pi",
        r"\overline{M} = 0.2639 - 0.3633 i",
        r"M\overline{M} = |M|^2",
        r"\operatorname{Re}(M e^{i\theta}) = \tfrac12 M e^{i\theta} + \tfrac12\overline{M} e^{-i\theta}",
    ],
)
def test_angles_and_conjugates_of_a_known_number_hold(formula):
    assert last_verdict(f"{PHASOR}$${formula}$$") in TRUE


@pytest.mark.parametrize(
    "formula",
    [
        r"\arg M = \arctan(0.2639/0.3633)",
        r"\arg M \approx 36^\circ",
        r"\angle M = 36^\circ",
        r"\arg(-M) = 54^\circ",
        r"\arg\zeta = 72^\circ",
        r"M\overline{M} = 2|M|^2",
        r"\operatorname{Re}(M e^{i\theta}) = \tfrac12 M e^{i\theta} - \tfrac12\overline{M} e^{-i\theta}",
    ],
)
def test_wrong_angles_and_conjugates_are_refuted(formula):
    assert last_verdict(f"{PHASOR}$${formula}$$") == REFUTED


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\operatorname{Re} z = \frac{z+\bar z}{2}", HOLDS),
        (r"\operatorname{Re} z = \frac{z-\bar z}{2}", REFUTED),
        (r"\Im z = \frac{z-\bar z}{2i}", HOLDS),
        (r"\Re(z) = \frac12(z + z^*)", HOLDS),
        (r"\Re(z) = \frac12(z - z^*)", REFUTED),
        (r"\Re(Z e^{i\theta}) = \frac12(Z e^{i\theta} + \overline{Z} e^{-i\theta})", HOLDS),
        (r"\Re(Z e^{i\theta}) = \frac12(Z e^{i\theta} - \overline{Z} e^{-i\theta})", REFUTED),
        (r"\Re(A e^{i\theta}) = A\cos\theta", HOLDS),
        (r"\bar x = \frac{a+b}{2}", DEFINITION),
        (r"\arg(a + i b) = \arctan(b/a)", UNDECIDED),
        (r"\arg z = 30^\circ", UNDECIDED),
    ],
)
def test_letters_are_complex_where_a_bar_stands_beside_their_real_part(formula, verdict):
    assert last_verdict(f"$${formula}$$") == verdict


def test_the_sign_of_an_angle_is_read_before_plain_letters_too():
    page = "The phasor is M = 3 + 4i.\n\n"
    for formula, verdicts in (
        ("arg M = 53.13°", TRUE),
        ("∠M = 53.13°", TRUE),
        ("arg(M) = 36.87°", (REFUTED,)),
    ):
        checked = sb.check(page + formula + "\n", {})
        assert checked.verdicts[-1].verdict in verdicts
