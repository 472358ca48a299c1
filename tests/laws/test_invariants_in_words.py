"""The letters of a second state follow from what words, or const, say to stay the same."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

PRESSURE = (
    r"The gas follows $p V^n = \mathrm{const}$ and is squeezed by $\varepsilon = V_1/V_2$. "
    r"At the end $p_2 = {}$."
)
DREHZAHL = r"Der Drehimpuls $J \omega$ bleibt konstant. Es ist $J_2 = J_1/q$. Danach ist $\omega_2 = {}$."
FRENCH = r"La quantité $T V^{k-1}$ reste constante, avec $a = V_1/V_2$. À la fin $T_2 = {}$."
ITALIAN = r"Il prodotto $p V^k$ rimane costante, con $a = V_1/V_2$. Alla fine $p_2 = {}$."
RIGHT = [
    PRESSURE.replace("{}", r"p_1 \varepsilon^n"),
    PRESSURE.replace("{}", r"p_1 \left(\frac{V_1}{V_2}\right)^n"),
    DREHZAHL.replace("{}", r"q \omega_1"),
    FRENCH.replace("{}", r"T_1 a^{k-1}"),
    ITALIAN.replace("{}", r"p_1 a^k"),
]
WRONG = [
    PRESSURE.replace("{}", r"p_1 \varepsilon^{n-1}"),
    PRESSURE.replace("{}", r"p_1 \left(\frac{V_2}{V_1}\right)^n"),
    DREHZAHL.replace("{}", r"\frac{\omega_1}{q}"),
    FRENCH.replace("{}", r"T_1 a^{1-k}"),
    ITALIAN.replace("{}", r"p_1 a^{-k}"),
]
OTHER = [
    (
        r"The gas follows $p V^n = \mathrm{const}$ with $\varepsilon = V_1/V_2$. "
        r"Then heat is added: $p_3 = \psi p_2$."
    ),
    r"The gas follows $p V^n = \mathrm{const}$. The pressure then doubles, $p_2 = 2 p_1$.",
]


@pytest.mark.parametrize("page", RIGHT)
def test_what_stays_the_same_proves_the_second_state(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] in ("conditional", "holds")


@pytest.mark.parametrize("page", WRONG)
def test_another_power_is_refuted(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] == "refuted"


@pytest.mark.parametrize("page", OTHER)
def test_another_process_is_left(tmp_path, page):
    assert "refuted" not in verdicts_of(tmp_path, page)
