"""Temperatures in °C are divided as kelvins, and their differences are the same in both."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
TWO = "T_1 = 20 °C, T_2 = 40 °C. "
HOT = "T_1 = 600 °C and T_2 = 20 °C. "
IN_TEX = "$T_1 = 600\\,^\\circ\\mathrm{C}$, $T_2 = 20\\,^\\circ\\mathrm{C}$. "
BY_TEXT = "$T_1 = 600\\,°\\text{C}$, $T_2 = 20\\,°\\text{C}$. "
OUTSIDE = "$T_1 = 600$ °C, $T_2 = 20$ °C. "
GAS = "m = 1 kg, R = 287 J/kg/K, V = 1 m³, T = 20 °C. p = m R T/V = "
HEAT = "m = 2 kg, c = 4.2 kJ/kg/K. "
WRONG = (
    HOT + "η = 1 − T_2/T_1 = 0.967.",
    "η = 1 − T_2/T_1 with T_1 = 600 °C and T_2 = 20 °C: η = 0.967.",
    IN_TEX + "$\\eta = 1 - \\frac{T_2}{T_1} = 0.967$.",
    BY_TEXT + "$\\eta = 1 - \\frac{T_2}{T_1} = 0{,}967$.",
    OUTSIDE + "$\\eta = 1 - \\frac{T_2}{T_1} = 0{,}967$.",
    TWO + "T_2/T_1 = 2.",
    TWO + "T_2/T_1 = 40 °C/20 °C = 2.",
    "p_1 = 1 bar, T_1 = 20 °C, T_2 = 40 °C. p_2 = p_1 T_2/T_1 = 2 bar.",
    "Die Temperaturen sind T_1 = 20 °C und T_2 = 200 °C. Es ist T_2/T_1 = 10.",
    "Les températures sont T_1 = 20 °C et T_2 = 200 °C. V_1 = 1 m³. V_2 = V_1 T_2/T_1 = 10 m³.",
    "温度は T_1 = 20 °C、T_2 = 40 °C である。比は T_2/T_1 = 2 となる。",
    "Le temperature sono T_a = 20 °C, T_b = 60 °C. T_b/T_a = 3.",
    "T_1 = 300 K, T_2 = 20 °C. T_2 − T_1 = −280 K.",
    TWO + "T_2 - T_1 = 20.1 K.",
    TWO + "T_2 - T_1 = 293 K.",
    TWO + "T_m = (T_1 + T_2)/2 = 31 °C.",
    HEAT + "Q = m c (80 °C − 20 °C) = 672 kJ.",
)
OPEN = (
    GAS + "5740 Pa.",
    "T_1 = 20 °C and V_2 = 2 V_1, so T_2 = T_1 V_2/V_1 = 40 °C.",
    "T = 20 °C. c = 331.5 + 0.6 T = 343.5.",
)
RIGHT = (
    HOT + "η = 1 − T_2/T_1 = 0.664.",
    HOT + "η = 1 − T_2/T_1 = 1 − 293/873 = 0.664.",
    "η = 1 − T_2/T_1 with T_1 = 600 °C and T_2 = 20 °C: η = 0.664.",
    IN_TEX + "$\\eta = 1 - \\frac{T_2}{T_1} = 0.664$.",
    BY_TEXT + "$\\eta = 1 - \\frac{T_2}{T_1} = 0{,}664$.",
    OUTSIDE + "$\\eta = 1 - \\frac{T_2}{T_1} = 0{,}664$.",
    TWO + "T_2/T_1 = 1.068.",
    "T_1 = 20 °C = 293 K, T_2 = 40 °C = 313 K. T_2/T_1 = 1.068.",
    "p_1 = 1 bar, T_1 = 20 °C, T_2 = 40 °C. p_2 = p_1 T_2/T_1 = 1.07 bar.",
    "温度は T_1 = 20 °C、T_2 = 40 °C である。比は T_2/T_1 = 1.068 となる。",
    "Le temperature sono T_a = 20 °C, T_b = 60 °C. T_b/T_a = 1.136.",
    "T_1 = 300 K, T_2 = 20 °C. T_1 − T_2 = 7 K.",
    "T_1 = 300 K, T_2 = 20 °C. T_1 − T_2 = 6.85 K.",
    TWO + "T_2 - T_1 = 20 K.",
    TWO + "T_2 - T_1 = 20 °C.",
    TWO + "ΔT = T_2 − T_1 = 20 °C.",
    TWO + "T_m = (T_1 + T_2)/2 = 30 °C.",
    HEAT + "Q = m c (80 °C − 20 °C) = 504 kJ.",
    HEAT + "T_1 = 20 °C, T_2 = 80 °C. Q = m c (T_2 − T_1) = 504 kJ.",
    GAS + "84.1 kPa.",
    "T = 20 °C, T_K = T + 273 = 293 K.",
    "T_1 = 20 °C, κ = 1.4, ε = 10. T_2 = T_1 ε^(κ−1) = 463 °C.",
    "ΔT = 60 °C, α = 12·10⁻⁶ 1/K, L = 1 m: ΔL = α L ΔT = 0.72 mm.",
)


def _verdicts(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    return [each.verdict for each in check(page, fixes=False).verdicts]


@pytest.mark.parametrize("text", WRONG)
def test_a_wrong_result_of_temperatures_is_refuted(tmp_path, text):
    assert _verdicts(tmp_path, text)[-1] == "refuted"


@pytest.mark.parametrize("text", OPEN)
def test_what_is_right_in_degrees_alone_is_open(tmp_path, text):
    assert _verdicts(tmp_path, text)[-1] == "undecided"


@pytest.mark.parametrize("text", RIGHT)
def test_a_right_result_of_temperatures_holds(tmp_path, text):
    verdicts = _verdicts(tmp_path, text)
    assert verdicts[-1] in PROVED
    assert "refuted" not in verdicts


def test_degrees_of_arc_before_a_letter_are_no_temperature(tmp_path):
    verdicts = _verdicts(tmp_path, "C = 3, x = 90° C. sin 90° = 1. x = 3π/2.")
    assert verdicts[-1] in PROVED
