"""A number in radians by the second holds in no turns, and one in turns in no radians."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
WRONG = (
    "n = 3000 rpm, ω = 2πn/60 = 314 rad/s. The camshaft turns with ω_c = ω/2 = 157 rpm.",
    "n = 6000 U/min, $\\omega = 2\\pi n/60 = 628$ rad/s. Nocken: $\\omega_N = \\omega/2 = 314$ U/min.",
    "n = 3000 rpm. f = n/60 = 50 rad/s.",
    "$n = 1500\\,\\mathrm{min^{-1}}$. $f = \\frac{n}{60} = 25\\,\\mathrm{rad/s}$.",
    "n = 4800 rpm. The order 2 has f_2 = 2n/60 = 160 rad/s.",
    "n = 3000 rpm. ω = 2πn/60, so ω = 314 Hz.",
    "n = 3000 giri/min; $\\omega = \\pi n/30 = 314{,}2$ giri/min.",
    "回転数 n = 3000 rpm。角速度 ω = 2πn/60 = 314.2 Hz。",
    "c = 50 N/mm, m = 20 kg. The spring has ω_0 = √(c/m) = 50 Hz.",
    "k = 9 kN/m und m = 10 kg. Damit wird $\\omega_0 = \\sqrt{\\frac{k}{m}} = 30\\,\\text{Hz}$.",
    "Raideur k = 9 kN/m, masse m = 10 kg. La pulsation propre vaut ω = √(k/m) = 30 Hz.",
    "Ω = 200 rad/s, Ω_2 = 2Ω = 400 Hz.",
)
RIGHT = (
    "n = 3000 rpm, ω = 2πn/60 = 314 rad/s. The camshaft turns with ω_c = ω/2 = 157 rad/s.",
    "n = 3000 rpm, ω = 2πn/60 = 314 rad/s. The camshaft turns with ω_c = ω/2 = 1500 rpm.",
    "n = 6000 U/min, $\\omega = 2\\pi n/60 = 628$ rad/s. Nocken: $\\omega_N = \\omega/2 = 3000$ U/min.",
    "n = 3000 rpm. The camshaft turns with n_c = n/2 = 1500 rpm.",
    "n = 3000 rpm. f = n/60 = 50 Hz.",
    "n = 3000 rpm. f = n/60 = 50 s⁻¹.",
    "$n = 1500\\,\\mathrm{min^{-1}}$. $f = \\frac{n}{60} = 25\\,\\mathrm{Hz}$.",
    "n = 3000 giri/min; $\\omega = \\pi n/30 = 314{,}2$ rad/s.",
    "回転数 n = 3000 rpm。角速度 ω = 2πn/60 = 314.2 rad/s。",
    "c = 50 N/mm, m = 20 kg. The spring has ω_0 = √(c/m) = 50 rad/s.",
    "c = 50 N/mm, m = 20 kg. The spring has ω_0 = √(c/m) = 50 1/s.",
    "c = 50 N/mm, m = 20 kg. The spring has ω_0 = √(c/m) = 477 rpm.",
    "c = 50 N/mm, m = 20 kg. The spring has f_0 = √(c/m)/(2π) = 7.96 Hz.",
    "Raideur k = 9 kN/m, masse m = 10 kg. La pulsation propre vaut ω = √(k/m) = 30 rad/s.",
    "ω = 314 rad/s, n = ω/(2π) = 50 Hz = 3000 rpm.",
    "The speed ω = 3000 rpm. The camshaft has ω_c = ω/2 = 1500 rpm.",
    "v = 10 m/s, r = 0.1 m: n = v/(2πr) = 15.9 Hz.",
)


def _verdicts(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    return [each.verdict for each in check(page, fixes=False).verdicts]


@pytest.mark.parametrize("text", WRONG)
def test_a_wrong_unit_of_turning_is_refuted(tmp_path, text):
    assert _verdicts(tmp_path, text)[-1] == "refuted"


@pytest.mark.parametrize("text", RIGHT)
def test_a_right_unit_of_turning_holds(tmp_path, text):
    verdicts = _verdicts(tmp_path, text)
    assert verdicts[-1] in PROVED
    assert "refuted" not in verdicts
