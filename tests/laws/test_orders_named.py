"""A relation with ≈ agrees through the order that its words name, or is refuted."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
ROOT = "$\\sqrt{1-\\lambda^2\\sin^2\\theta} \\approx "
TO_SECOND = "1 - \\frac{\\lambda^2}{2}\\sin^2\\theta$."
DISPLACEMENT = (
    "The piston displacement is $x = r(1-\\cos\\theta) + l(1 - \\sqrt{1 - \\lambda^2\\sin^2\\theta})$ "
    "with $\\lambda = r/l$. "
)
CUT = "$x \\approx r(1 - \\cos\\theta) + \\frac{r\\lambda}{2}\\sin^2\\theta$."
ROD = "The rod swings at β with sin β = λ sin θ. "
MOTION = "$a \\approx r\\omega^2(\\cos\\theta + \\lambda\\cos 2\\theta)$."
WRONG = (
    "Keeping terms up to λ^4, √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "To fourth order in x, cos x ≈ 1 − x²/2.",
    "With λ = r/l and terms up to λ³, the piston acceleration is " + MOTION,
    "λ = r/l. To third order in λ the piston displacement is " + CUT,
    "To second order in x: e^x ≈ 1 + x.",
    "To third order in x: sin x ≈ x.",
    "Up to fourth order √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "To second order in λ the root is √(1 − λ² sin²θ) ≈ 1.",
    "Neglecting λ³ and higher, √(1 − λ² sin²θ) ≈ 1.",
    "Neglecting terms of order x³, e^x ≈ 1 + x.",
    "Neglecting powers higher than λ², " + ROOT + "1$.",
    "Keeping terms up to $\\lambda^4$, " + ROOT + TO_SECOND,
    "With terms up to $x^2$: $e^x \\approx 1 + x$.",
    "Up to third order in ε, $\\frac{1}{1-\\varepsilon} \\approx 1 + \\varepsilon + \\varepsilon^2$.",
    "For small x, up to second order, ln(1+x) ≈ x.",
    "Bis zur zweiten Ordnung in x gilt e^x ≈ 1 + x.",
    "Entwickelt bis zur 2. Ordnung in $\\lambda$ ergibt sich " + ROOT + "1$.",
    "Unter Vernachlässigung von λ⁵ und höher gilt √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "À l'ordre 2 en x, e^x ≈ 1 + x.",
    "Au deuxième ordre en x : e^x ≈ 1 + x.",
    "En négligeant λ³ et au-delà, √(1 − λ² sin²θ) ≈ 1.",
    "Fino al secondo ordine in x, $e^x \\approx 1 + x$.",
    "Hasta el segundo orden en x, $e^x \\approx 1 + x$.",
    "xの2次までで e^x ≈ 1 + x である。",
    DISPLACEMENT + "To third order in λ, " + CUT,
    ROD + "To third order in λ, $\\beta \\approx \\lambda\\sin\\theta$.",
)
RIGHT = (
    "F = 9650 N. The weight takes half of it, up to the first order: $\\frac12 F \\approx 4825$ N.",
    "λ = 0.25. To first order in λ the factor is $1 + λ \\approx 1.25$.",
    "Keeping terms up to λ^2, √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "To second order in x, cos x ≈ 1 − x²/2.",
    "To first order in x, 1 − cos x ≈ x²/2.",
    "With λ = r/l and neglecting λ³ and higher, the piston acceleration is " + MOTION,
    "λ = r/l. To second order in λ the piston displacement is " + CUT,
    "Neglecting λ⁴, cos β ≈ 1 − λ²/2 sin²θ.",
    "To second order in x: e^x ≈ 1 + x + x²/2.",
    "To first order in x: e^x ≈ 1 + x.",
    "To second order in x: sin x ≈ x.",
    "To third order in x: sin x ≈ x − x³/6.",
    "Up to fourth order √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ − λ⁴/8 sin⁴θ.",
    "Up to third order √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "To first order in λ the root is √(1 − λ² sin²θ) ≈ 1.",
    "Neglecting λ³ and higher, √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "Neglecting terms of order x², e^x ≈ 1 + x.",
    "Neglecting powers higher than λ², " + ROOT + TO_SECOND,
    "Keeping terms up to $\\lambda^2$, " + ROOT + TO_SECOND,
    "With terms up to $x^2$: $e^x \\approx 1 + x + x^2/2$.",
    "For small x, up to second order, ln(1+x) ≈ x − x²/2.",
    "Bis zur ersten Ordnung in x gilt e^x ≈ 1 + x.",
    "Entwickelt bis zur 2. Ordnung in $\\lambda$ ergibt sich " + ROOT + TO_SECOND,
    "Unter Vernachlässigung von λ⁴ und höher gilt √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "À l'ordre 1 en x, e^x ≈ 1 + x.",
    "En négligeant λ³ et au-delà, √(1 − λ² sin²θ) ≈ 1 − λ²/2 sin²θ.",
    "Hasta el segundo orden en x, $e^x \\approx 1 + x + \\frac{x^2}{2}$.",
    "xの2次までで e^x ≈ 1 + x + x²/2 である。",
    "To lowest order in x: $1 - \\cos x \\approx \\frac{x^2}{2}$.",
    "The error is of third order in x: $\\sin x \\approx x$.",
    "Not to second order in x, but to first, $e^x \\approx 1 + x$.",
    DISPLACEMENT + "Neglecting $\\lambda^3$ and higher, " + CUT,
    ROD + "To second order in λ, $\\beta \\approx \\lambda\\sin\\theta$.",
    "Up to the second order "
    + ROOT
    + "1 - \\frac{\\lambda^2}{4} + \\frac{\\lambda^2}{4}\\cos 2\\theta$.",
    "Up to the second order, the piston acceleration is a ≈ r ω² (cos θ + λ cos 2θ).",
    "Bis zur 2. Ordnung ist die Kolbenbeschleunigung a ≈ r ω² (cos θ + λ cos 2θ).",
)


OPEN = ("Neglecting λ⁵, cos β ≈ 1 − λ²/2 sin²θ.",)


def _last(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    return check(page, fixes=False).verdicts[-1].verdict


@pytest.mark.parametrize("text", WRONG)
def test_a_cut_below_the_order_named_is_refuted(tmp_path, text):
    assert _last(tmp_path, text) == "refuted"


@pytest.mark.parametrize("text", RIGHT)
def test_a_cut_at_the_order_named_holds(tmp_path, text):
    assert _last(tmp_path, text) in PROVED


@pytest.mark.parametrize("text", OPEN)
def test_what_is_proved_through_a_lower_order_alone_is_open(tmp_path, text):
    assert _last(tmp_path, text) == "undecided"
