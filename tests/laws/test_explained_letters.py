"""To explain a letter in words costs no verdict: what a bare page gets, the declared one gets too."""

import pytest

from symbalance.checking import check

FRENCH = """Moteur monocylindre, avec λ = r/L. L'effort d'inertie selon l'axe du cylindre est

    F ≈ m_alt·r·ω²·(cos θ + λ·cos 2θ)

- premier ordre : F_1 = m_alt·r·ω²
- second ordre : F_2 = m_alt·r·ω²·λ²
"""
GERMAN = r"""# Kolbenbewegung

Mit dem Kurbelradius $r$, der Pleuellänge $l$ und $\lambda = r/l$ ist der Weg ab OT

$$s \approx r\left(1-\cos\varphi + \frac{\lambda}{2}\cos^2\varphi\right)$$
"""
PAGES = (
    (
        FRENCH,
        {
            "r": "rayon de manivelle",
            "L": "entraxe de la bielle",
            "λ": "rayon de manivelle sur longueur de bielle, r/L",
            "θ": "angle de manivelle depuis le point mort haut",
            "ω": "vitesse angulaire du vilebrequin",
            "m_alt": "masse alternative totale",
            "F": "force d'inertie alternative",
            "F_1": "amplitude du premier ordre",
            "F_2": "amplitude du second ordre",
        },
    ),
    (
        GERMAN,
        {
            "r": "crank radius",
            "l": "rod length",
            "λ": "crank radius over rod length",
            "s": "piston travel from top dead centre",
        },
    ),
)


def _verdicts(text, symbols):
    checked = check(text, symbols) if symbols else check(text)
    return [link["verdict"] for link in checked.data()["links"]]


@pytest.mark.parametrize(("text", "symbols"), PAGES, ids=["french", "german"])
def test_an_error_found_without_declarations_is_found_with_them(text, symbols):
    bare, declared = _verdicts(text, {}), _verdicts(text, symbols)
    assert bare.count("refuted") == 1
    assert [v == "refuted" for v in declared] == [v == "refuted" for v in bare]


def test_a_force_explained_in_words_is_confirmed():
    assert _verdicts(*PAGES[0])[-3:] == ["conditional", "conditional", "refuted"]


def test_the_size_of_its_own_words_counts_not_that_of_the_sentence():
    text = r"The force $F$ has the lever $a$, hence $T = F a$."
    assert "refuted" not in _verdicts(text, {"F": "force", "a": "lever", "T": "torque of F on the crank"})


RATIO = r"""# Piston motion

Let $u$ be the crank angle and $x$ the displacement from top dead centre.

$$x \approx r\left(1-\cos u + \frac{q}{4}(1-\cos 2u)\right)$$

$$\ddot x \approx r\omega^2(\cos u + q\cos 2u)$$

$$\ddot x \approx r\omega^2(\cos u + 2q\cos 2u)$$
"""


@pytest.mark.parametrize("ratio", ["r/l", "r / l", "R/L", "ratio r/l"])
def test_a_ratio_declared_by_its_letters_is_no_unit(ratio):
    motion = {"x": "displacement from top dead centre", "ω": "angular speed", "r": "crank radius"}
    verdicts = _verdicts(RATIO, {"u": "crank angle", "q": ratio, **motion})
    assert verdicts == ["holds_to_order", "holds_to_order", "refuted"]


SERIES = r"""The piston acceleration is, with $\lambda = r/l$ and the crank angle $\varphi$,

$a = r \omega^2 (\cos\varphi + A_2\cos 2\varphi + A_4\cos 4\varphi + A_6 \cos 6\varphi + \dots)$

with the coefficients $A_2 = \lambda + \frac{\lambda^3}{4} + \dots$ and

$A_4 = -\frac{\lambda^3}{4} + \dots$
"""


def test_the_sign_of_a_coefficient_is_that_of_its_term_in_the_series_of_the_page():
    turned = SERIES.replace(r"+ A_4", r"- A_4")
    assert _verdicts(SERIES, {})[-1] == "conditional"
    assert _verdicts(turned, {})[-1] not in ("conditional", "holds")
    assert _verdicts(turned.replace(r"-\frac", r"\frac"), {})[-1] == "conditional"
    assert _verdicts(SERIES.replace(r"-\frac", r"\frac"), {})[-1] not in ("conditional", "holds")
