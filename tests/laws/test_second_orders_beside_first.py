"""A second order is λ times the first at twice the angle, and the whole force has both, in any letters.

The page may have a letter for m r ω², words in any language, or none. What is of several cylinders, of
counterweights, of the piston's way, or counted from elsewhere is not accused.
"""

from __future__ import annotations

import pytest

from symbalance.checking import check

MARKED = "Mit $F_0 = m_o r\\omega^2$, $\\lambda = r/l$ gilt $F_I = F_0\\cos\\varphi$ und $@$.\n"
LISTED = "With U = m·r·ω² and λ = r/l:\n\n- 1st order: F₁ = U·cos φ\n- 2nd order: @\n"
SOLVED = "Avec $K = m r\\omega^2$ et $\\lambda = r/l$ : $F_1 = K\\cos\\alpha$, $@$.\n"
WEIGHTS = f"{LISTED}\nThe counterweight has half of it.\n"
WHOLE = "Für $\\lambda = r/l$ und $F_0 = m_o r\\omega^2$ ist die oszillierende Massenkraft $@$.\n"
OLD = (
    "With ω = 2πn/60 the force for a rod of infinite length is\n\n   F₁ = W₁ω²r/g\n\n"
    "For the actual rod of length l we have, nearly,\n\n   @\n\n"
    "θ being the angle from the top dead centre.\n"
)
LET = "$\\lambda = r/l$, $K = m r\\omega^2$:"


def last_word(page: str, formula: str) -> str:
    return check(page.replace("{LET}", LET).replace("@", formula), {}).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (MARKED, "F_{II} = \\lambda F_0\\cos 2\\varphi", "F_{II} = \\lambda F_0\\cos\\varphi"),
        (MARKED, "F_{II} = F_0\\lambda\\cos 2\\varphi", "F_{II} = \\lambda F_0\\sin 2\\varphi"),
        (MARKED, "F_{II} = \\frac{r}{l}F_0\\cos 2\\varphi", "F_{II} = F_0\\cos 2\\varphi"),
        (
            MARKED,
            "F_{II} = \\lambda F_0\\cos(2\\varphi)",
            "F_{II} = \\frac{\\lambda}{2}F_0\\cos 2\\varphi",
        ),
        (LISTED, "F₂ = U·λ·cos 2φ", "F₂ = 2·U·λ·cos φ"),
        (LISTED, "F₂ = λ·U·cos 2φ", "F₂ = 2·U·λ·cos 2φ"),
        (WEIGHTS, "F₂ = U·λ·cos 2φ", "F₂ = 2·U·λ·cos φ"),
        (SOLVED, "F_2 = \\lambda K\\cos 2\\alpha", "F_2 = \\lambda^2 K\\cos 2\\alpha"),
        (SOLVED, "F_2 = \\frac{r}{l} K\\cos 2\\alpha", "F_2 = \\frac{l}{r} K\\cos 2\\alpha"),
        (
            WHOLE,
            "F_o = F_0(\\cos\\varphi + \\lambda\\cos 2\\varphi)",
            "F_o = F_0(\\cos\\varphi + \\lambda\\sin 2\\varphi)",
        ),
        (
            WHOLE,
            "F_o = -F_0(\\cos\\varphi + \\lambda\\cos 2\\varphi)",
            "F_o = F_0(\\cos\\varphi + \\frac{1}{\\lambda}\\cos 2\\varphi)",
        ),
        (OLD, "F ≈ F₁ { cos θ + (r/l) cos 2θ }", "F ≈ F₁ { cos θ + (r/l) sin 2θ }"),
        (OLD, "F ≈ F₁ { cos θ + (r/l) cos 2θ }", "F ≈ F₁ { cos θ - (r/l) cos 2θ }"),
        (OLD, "F ≈ F₁ { cos θ + (r/l) cos 2θ }", "F ≈ F₁ { cos θ + (l/r) cos 2θ }"),
    ],
)
def test_one_slip_in_a_second_order_is_refuted(page, right, wrong):
    assert last_word(page, right) not in ("refuted", "contradiction")
    assert last_word(page, wrong) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"$F_1 = K\cos\theta$, $K = m r\omega^2$, $K_2 = \lambda m r\omega^2$, $F_2 = K_2\cos 2\theta$.",
        r"Let {LET} $s_1 = -r\cos\theta$ and $s_2 = -\frac{\lambda}{4}r\cos 2\theta$.",
        r"Let $n = l/r$, $F_1 = m r\omega^2\cos\theta$, $F_2 = \frac{m r\omega^2}{n}\cos 2\theta$.",
        r"Inline four, {LET} $F_1 = K\cos\theta$, $F_2 = 4\lambda K\cos 2\theta$.",
        r"Two sounds, $F_1 = A\cos\theta$ and $F_2 = A\cos 2\theta$.",
        r"With half of it balanced, {LET} $F = K(\frac12\cos\theta + \lambda\cos 2\theta)$.",
        r"For the stroke $s$ let $\lambda = s/l$, $K = m r\omega^2$: "
        r"$F = K(\cos\theta + \frac{\lambda}{2}\cos 2\theta)$.",
        r"From bottom dead centre, {LET} $F = K(\cos\theta - \lambda\cos 2\theta)$.",
        r"With {LET} the rod's middle has $F = K(\cos\theta + \frac{\lambda}{2}\cos 2\theta)$.",
        r"In the V-twin, {LET} $F_x = K(\cos\theta + \lambda\sin 2\theta)$.",
    ],
)
def test_what_may_be_right_is_not_accused(page):
    assert last_word(page + "\n", "") not in ("refuted", "contradiction")
