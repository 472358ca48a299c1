"""What a symbols file says in the page's own language is as good as what it says in English."""

import pytest

import symbalance as sb

INERTIA_TORQUE = (
    r"$$C_i = \frac{m r^2\omega^2}{2}\left(\frac{\lambda}{2}\sin\theta - \sin 2\theta"
    r" SIGN \frac{3\lambda}{2}\sin 3\theta\right)$$"
)
DECLARED = [
    {
        "C_i": "couple d'inertie d'un cylindre",
        "m": "masse alternative d'un cylindre",
        "r": "rayon de manivelle",
        "λ": "rapport manivelle sur bielle",
        "ω": "vitesse angulaire du vilebrequin",
        "θ": "angle du vilebrequin depuis le PMH",
    },
    {
        "C_i": "coppia d'inerzia di un cilindro",
        "m": "massa alterna",
        "r": "raggio di manovella",
        "λ": "rapporto manovella/biella",
        "ω": "velocità angolare della manovella",
        "θ": "angolo di manovella dal punto morto superiore",
    },
]
PAGES = [
    (
        "Wskaźnik przekroju wału na skręcanie to\n\n$$W_0 = \\frac{\\pi d^3}{FACTOR}.$$\n",
        {"d": "średnica wału", "W_0": "wskaźnik przekroju na skręcanie"},
        ("16", "32"),
    ),
    (
        "La contrainte de cisaillement à la surface de l'arbre vaut\n\n"
        "$$\\tau = \\frac{FACTOR T}{\\pi d^3}$$\n",
        {"τ": "contrainte de cisaillement", "d": "diamètre de l'arbre", "T": "couple"},
        ("16", "32"),
    ),
    (
        "Il volano deve avere $J = \\frac{\\Delta E}{FACTOR\\delta\\omega^2}$.\n",
        {"J": "momento d'inerzia del volano", "δ": "grado di irregolarità"},
        ("", "2"),
    ),
]


def _last(page, symbols):
    return sb.check(page, symbols).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("symbols", DECLARED)
def test_a_sign_is_refuted_whatever_language_declares_the_letters(symbols):
    assert _last(INERTIA_TORQUE.replace("SIGN", "+"), symbols) == "refuted"
    assert _last(INERTIA_TORQUE.replace("SIGN", "-"), symbols) in ("conditional", "holds_to_order")


def test_a_meaning_is_quoted_as_it_was_typed():
    page = "Le masse rotanti della manovella danno la forza $F_c = m_r r\\omega^2$.\n"
    symbols = {"F_c": "forza centrifuga delle masse rotanti", "r": "raggio di manovella"}
    assumption = sb.check(page, symbols).data()["links"][-1]["assumption"]
    assert "declared as “forza centrifuga”" in assumption


@pytest.mark.parametrize(("page", "symbols", "factors"), PAGES)
def test_a_standard_formula_is_judged_whatever_language_declares_its_letters(page, symbols, factors):
    right, wrong = factors
    assert _last(page.replace("FACTOR", right), symbols) == "conditional"
    assert _last(page.replace("FACTOR", wrong), symbols) == "refuted"
