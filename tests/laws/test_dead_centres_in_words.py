"""The dead centre of a value may be named above it, right behind it, and its direction in words."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

FORCE = (
    "The crank angle θ is measured from the top dead centre, r is the crank radius, l the length of the"
    " rod,\nF the inertia force of the reciprocating parts.\n\nF ≈ F₁ ( cos θ + (r/l) cos 2θ )\n\n"
)
PISTON = (
    "Der Kurbelradius ist r, die Pleuellänge l, λ = r/l, und ω ist konstant. Die Beschleunigung ist\n\n"
    "a = -r ω² (cos φ + λ cos 2φ) mit dem Kurbelwinkel φ.\n\n"
)

LOCOMOTIVE = (
    "Der Winkel w der Kurbel zählt von der vorderen Totlage, r ist der Kurbelhalbmesser. In der Mitte"
    " des Hubes, w = 90 Grad,\nist es anders. Die Beschleunigung ist mit"
    " r = 0,33 m, l = 2,20 m und u^2 = 787,3\n\n"
    "    p = r u^2 (cos w + (r/l) cos 2w) ,\n\n"
)

CASES = [
    (LOCOMOTIVE + "in der vorderen Totlage p = 0,33 * 787,3 * 1,15.", "conditional"),
    (LOCOMOTIVE + "in der vorderen Totlage p = 0,33 * 787,3 * 0,85.", "refuted"),
    (LOCOMOTIVE + "in der hinteren Totlage p = -0,33 * 787,3 * 0,85.", "conditional"),
    (LOCOMOTIVE + "in der hinteren Totlage p = -0,33 * 787,3 * 1,15.", "refuted"),
    (FORCE + "At the top dead centre this becomes\n\n    F = F₁ (1 + r/l).", "conditional"),
    (FORCE + "At the top dead centre this becomes\n\n    F = F₁ (1 - r/l).", "refuted"),
    (FORCE + "and at the bottom, numerically, F = F₁ (1 - r/l).", "conditional"),
    (FORCE + "and at the bottom, numerically, F = F₁ (1 + r/l).", "refuted"),
    (FORCE + "At bottom dead centre\n\n    F = - F₁ (1 - r/l).", "conditional"),
    (FORCE + "At bottom dead centre\n\n    F = F₁ (1 + r/l).", "refuted"),
    (PISTON + "Es ist |a| = r ω² (1 + λ) im OT und |a| = r ω² (1 - λ) im\nUT.", "conditional"),
    (PISTON + "Es ist |a| = r ω² (1 + λ) im OT und |a| = r ω² (1 + λ) im\nUT.", "refuted"),
    (PISTON + "Im UT ist betragsmäßig a = r ω² (1 - λ).", "conditional"),
    (PISTON + "Im UT ist betragsmäßig a = r ω² (1 + λ).", "refuted"),
]


@pytest.mark.parametrize(("text", "word"), CASES)
def test_a_value_is_that_at_the_dead_centre_which_words_name(tmp_path, text, word):
    path = tmp_path / "page.txt"
    path.write_text(f"{text}\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == word
