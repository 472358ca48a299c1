"""Lengths put in without their unit beside letters that have one: F/(80·90) in N/mm²."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PAGE = """# Bearing
The load is $F = 111.0$ kN.

Its pressure on a pin of 80 mm by 90 mm is $p = {formula} {sign} {value}$ {unit}.
"""


def last_verdict(tmp_path, **gaps):
    page = tmp_path / "page.md"
    page.write_text(PAGE.format(**gaps), encoding="utf-8")
    return max(check(page).verdicts, key=lambda v: v.span).verdict


@pytest.mark.parametrize(
    ("formula", "value", "unit", "is_right"),
    [
        (r"F/(80\cdot 90)", "15.4", "N/mm²", True),
        (r"F/(80\cdot 90)", "15.4", r"$\mathrm{N/mm^2}$", True),
        (r"\frac{F}{11\cdot 12.5}", "807", "N/cm²", True),
        (r"F/80^2", "17.3", "N/mm²", True),
        (r"F/(80\cdot 90)", "14.5", "N/mm²", False),
        (r"F/(80\cdot 90)", "154", "N/mm²", False),
        (r"F/(80\cdot 90)", "15.4", "kN/mm²", False),
        (r"F/80", "1388", "N/mm²", False),
        (r"F/(80\cdot 90)", "15.4", "N/cm²", False),
    ],
)
def test_bare_lengths_are_in_the_unit_of_the_result(tmp_path, formula, value, unit, is_right):
    verdict = last_verdict(tmp_path, formula=formula, sign=r"\approx", value=value, unit=unit)
    assert (verdict in ("holds", "holds_to_order")) == is_right
    assert is_right or verdict == "refuted"


@pytest.mark.parametrize(("unit", "is_right"), [("litri", True), ("litros", True), ("metri", False)])
def test_units_in_romance_words_are_read(tmp_path, unit, is_right):
    page = tmp_path / "pagina.md"
    page.write_text(
        "Con $a = 0,25$ e $V_1 = 2,762$ dm³ la cilindrata totale è $V = 9\\,V_1 = 24,86$ " + unit + ".\n",
        encoding="utf-8",
    )
    verdict = max(check(page).verdicts, key=lambda v: v.span).verdict
    assert (verdict == "holds_to_order") == is_right
    assert is_right or verdict == "refuted"
