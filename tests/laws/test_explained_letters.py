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
