"""A formula that words draw from the equation before it makes that equation true."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

LENS = r"For a thin lens $\frac{1}{f} = \frac{1}{a} + \frac{1}{b}$. "
WRONG = [
    LENS + r"Solving for the image distance gives $b = \frac{a f}{a + f}$.",
    LENS + r"Rearranged for the distance, it follows $b = \frac{a - f}{a f}$.",
    r"Es gilt $q = \frac{u + v}{v}$. Auflösen nach der Größe ergibt $v = \frac{u}{q + 1}$.",
    (
        r"On a $q = \frac{u + v}{v}$. "
        r"En résolvant par rapport à cette grandeur, on obtient $v = \frac{u}{q}$."
    ),
    r"Si ha $q = \frac{u + v}{v}$. Ricavando il volume si ottiene $v = \frac{u}{q}$.",
    r"Se tiene $q = \frac{u + v}{v}$. Despejando el volumen se obtiene $v = \frac{u}{q}$.",
    (
        r"We look for $\cos\beta + k\cos 2\beta = 0$. "
        r"Solving the quadratic gives $\cos\beta = \frac{1+\sqrt{1+8k^2}}{4k}$."
    ),
    (
        r"Here $A = \frac{\pi}{4}(D^2 - d^2)$ and $u = D/2$. "
        r"The ratio is therefore $\frac{A}{u} = \frac{\pi}{2}(D - d)$."
    ),
]
RIGHT = [
    LENS + r"Solving for the image distance gives $b = \frac{a f}{a - f}$.",
    LENS + r"If the object is far away, it follows $b = f$.",
    r"Es gilt $q = \frac{u + v}{v}$. Auflösen nach der Größe ergibt $v = \frac{u}{q - 1}$.",
    (
        r"On a $q = \frac{u + v}{v}$. "
        r"En résolvant par rapport à cette grandeur, on obtient $v = \frac{u}{q-1}$."
    ),
    r"Si ha $q = \frac{u + v}{v}$. Ricavando il volume si ottiene $v = \frac{u}{q-1}$.",
    r"Se tiene $q = \frac{u + v}{v}$. Despejando el volumen se obtiene $v = \frac{u}{q-1}$.",
    (
        r"We look for $\cos\beta + k\cos 2\beta = 0$. "
        r"Solving the quadratic gives $\cos\beta = \frac{-1+\sqrt{1+8k^2}}{4k}$."
    ),
    (
        r"Here $A = \frac{\pi}{4}(D^2 - d^2)$ and $u = D/2$. "
        r"The ratio is therefore $\frac{A}{u} = \frac{\pi (D^2 - d^2)}{2 D}$."
    ),
    (
        r"Here $A = \frac{\pi}{4}(D^2 - d^2)$ and $u = D/2$. "
        r"For the solid disc it is therefore $\frac{A}{u} = \frac{\pi D}{2}$."
    ),
    r"For a large factor $q = \frac{u + v}{v}$ we therefore have nearly $v = \frac{u}{q}$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_what_does_not_follow_is_refuted(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_solutions_and_other_cases_are_not(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] not in ("refuted", "contradiction")
