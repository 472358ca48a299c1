"""Units of English prints, lb.-in.-sec.² and ft./sec.², and those behind formulas at a dollar or tag."""

from __future__ import annotations

import pytest

from symbalance.checking import check as check_with_engines
from symbalance.notes.checking import check

CASES = [
    ("J1 = 12.5 lb.-in.-sec.² and J2 = 25 lb.-in.-sec.², so J1/J2 = 0.5.", "holds"),
    ("T = 2000 lb.-in. = 226 N·m.", "holds_to_order"),
    ("T = 2000 lb.-in. = 2260 N·m.", "refuted"),
    ("m = 0.02 lb.-sec.²/in. = 3.5 kg.", "holds_to_order"),
    ("m = 0.02 lb·s²/in = 3.5 kg.", "holds_to_order"),
    ("m = 0.02 lb-sec²/in = 35 kg.", "refuted"),
    ("k = 4.69 × 10⁶ lb.-in./rad = 530 kN·m/rad.", "holds_to_order"),
    ("k = 4.69 × 10⁶ lb.-in./rad = 53 kN·m/rad.", "refuted"),
    ("The twist is 0.5 deg. = 0.00873 rad here.", "holds_to_order"),
    ("The twist is 0.5 deg. = 0.0873 rad here.", "refuted"),
    ("v = 30 ft./sec. = 9.14 m/s.", "holds_to_order"),
    ("a = 32.2 ft./sec.² = 9.81 m/s².", "holds_to_order"),
    ("a = 32.2 ft./sec.² = 9.18 m/s².", "refuted"),
    ("J = 0.5 slug-ft² = 0.678 kg m².", "holds_to_order"),
    ("P = 4½ tons = 44.8 kN.", "holds_to_order"),
    ("n = 1500 r.p.m. = 157 rad/sec.", "holds_to_order"),
    ("n = 1500 rpm = 25 rev/s.", "holds"),
    ("n = 1500 rpm = 50 rev/s.", "refuted"),
    ("T = 469 × 87.3 = 40.9 × 10³ lb.-in.", "holds_to_order"),
    ("T = 469 × 87.3 = 49.9 × 10³ lb.-in.", "refuted"),
    (r"$F = 3.1$\,kN, $b = 0.75$~m, $M = F b = 2325$~N\,m.", "holds"),
    (r"$F = 3.1$\,kN, $b = 0.75$~m, $M = F b = 23.25$~kN\,m.", "refuted"),
    (r"$F = 28$\,N, $b = 0.08$ m, $M = F b = $ $2.24$~N\,m.", "definition"),
    (r"$J = 0.0125$~kg\,m$^2$ and $2J = 0.025$~kg\,m$^2$.", "holds"),
    (r"$J = 0.0125$~kg\,m$^2$ and $2J = 0.25$~kg\,m$^2$.", "refuted"),
    ("6 in-line cylinders, so n = 6.", "definition"),
    (r"$J = 2.4\,\mathrm{kg\,m^2}$, $J^2 = 5.76\,\mathrm{kg^2m^4}$.", "holds"),
    (r"$J = 2.4\,\mathrm{kg\,m^2}$, $J^2 = 5.67\,\mathrm{kg^2m^4}$.", "refuted"),
    (r"$J = 2.4\,\mathrm{kg\,m^2}$, $J^3 = 13.824\ \text{kg³m⁶}$.", "holds"),
    ("The speed is n = 6000 rpm: n/2 = 3000 per min.", "holds"),
    ("The speed is n = 6000 rpm: n/2 = 3000 per minute.", "holds"),
    ("Die Drehzahl ist n = 6000 1/min: n/2 = 3000 pro Minute.", "holds"),
    ("The speed is n = 6000 rpm: n/2 = 50 per second.", "holds"),
    ("The speed is n = 6000 rpm: n/2 = 3000 per second.", "refuted"),
    ("The speed is n = 6000 rpm: n/2 = 6000 per min.", "refuted"),
    (r"例:$r = 44.8$ mm、$l = 140$ mm($l/r = 3.125$)。", "holds"),
    (r"例:$r = 44.8$ mm、$l = 140$ mm($l/r = 3.215$)。", "refuted"),
]


@pytest.mark.parametrize("judge", [check, check_with_engines])
@pytest.mark.parametrize(("line", "word"), CASES)
def test_compound_units_count(tmp_path, line, word, judge):
    path = tmp_path / ("notes.md" if "$" in line else "notes.txt")
    path.write_text(f"{line}\n", encoding="utf-8")
    assert judge(path, fixes=False).verdicts[-1].verdict == word


@pytest.mark.parametrize(("last", "word"), [("0.267", "holds_to_order"), ("0.367", "refuted")])
def test_a_unit_behind_a_formula_ends_at_a_tag(tmp_path, last, word):
    path = tmp_path / "notes.html"
    rows = rf"<p>\(L = 150\) mm:</p><ul><li>\(r = 40\) mm</li></ul><p>\(r/L = {last}\)</p>"
    path.write_text(f"<html><body>\n{rows}\n</body></html>\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == word
