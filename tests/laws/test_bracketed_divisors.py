"""A unit with several parts below its stroke, J/(kg K), is read, and its size and dimension count."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
GAS = "m = 1 kg, {}, V = 1 m³, T = 300 K. p = m R T/V = "
WRITTEN = (
    "R = 287 J/(kg K)",
    "R = 287 J/(kg·K)",
    "R = 287 J/(kg*K)",
    "R = 0.287 kJ/(kg K)",
    "$R = 287\\,\\mathrm{J/(kg\\,K)}$",
    "$R = 287\\,\\mathrm{J/(kg \\cdot K)}$",
    "$R = 287\\,\\text{J/(kg K)}$",
    "$R = 287\\,\\frac{\\mathrm{J}}{\\mathrm{kg\\,K}}$",
)
PAIRS = (
    ("λ = 50 W/(m K), A = 2 m², d = 0.1 m, ΔT = 10 K. Q = λ A ΔT/d = {} kW.", "10", "1"),
    ("Die Fläche ist A = 2 m². α = 25 W/(m² K), ΔT = 10 K. Q = α A ΔT = {} W.", "500", "50"),
    ("L'amortisseur a d = 40 N/(m/s), v = 2 m/s. F = d v = {} N.", "80", "20"),
    ("b_e = 210 g/(kW h), P = 100 kW. B = b_e P = {} kg/h.", "21", "2.1"),
    ("比熱は c_p = 1005 J/(kg K)、c_v = 718 J/(kg K) である。κ = c_p/c_v = {}。", "1.40", "1.30"),
    ("R = 287 J/(kg K), T = 300 K; R T = {} kJ/kg.", "86.1", "86100"),
    ("n = 2 mol, R = 8.314 J/(mol K), T = 300 K. E = n R T = {} J.", "4988", "2494"),
)


def _verdicts(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    return [each.verdict for each in check(page, fixes=False).verdicts]


@pytest.mark.parametrize("written", WRITTEN)
@pytest.mark.parametrize(("result", "is_right"), [("86.1 kPa", True), ("861 kPa", False)])
def test_a_gas_constant_in_brackets_is_read(tmp_path, written, result, is_right):
    verdicts = _verdicts(tmp_path, GAS.format(written) + result + ".")
    assert "unreadable" not in verdicts
    assert verdicts[-1] in PROVED if is_right else verdicts[-1] == "refuted"


@pytest.mark.parametrize(("text", "right", "wrong"), PAIRS)
def test_other_units_in_brackets_are_read(tmp_path, text, right, wrong):
    assert _verdicts(tmp_path, text.format(right))[-1] in PROVED
    assert _verdicts(tmp_path, text.format(wrong))[-1] == "refuted"


@pytest.mark.parametrize(("result", "is_right"), [("84.1", True), ("57.4", False)])
def test_an_equation_with_the_constant_behind_it_is_read(tmp_path, result, is_right):
    text = "p V = m R T with m = 1 kg, R = 287 J/(kg K), V = 1 m³, T = 20 °C gives p = {} kPa."
    verdicts = _verdicts(tmp_path, text.format(result))
    assert "unreadable" not in verdicts
    assert (verdicts[-1] in PROVED) is is_right


@pytest.mark.parametrize(("result", "is_right"), [("7", True), ("6", False)])
def test_letters_with_values_are_no_unit(tmp_path, result, is_right):
    verdicts = _verdicts(tmp_path, f"$W = 14$, $m = 2$, $K = 3$. $x = 3 W/(m K) = {result}$.")
    assert verdicts[-1] in PROVED if is_right else verdicts[-1] == "refuted"
