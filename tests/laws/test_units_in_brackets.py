"""Formulas with the unit behind each letter are read, and their constant has to convert these units."""

import pytest

from tests.checked_pages import verdicts_in

QUANTITIES = {
    "P": r"Power is torque times angular speed, $P = T\omega$.",
    "c": "The piston goes two strokes a turn, $c = 2 s n$.",
}


@pytest.mark.parametrize(
    ("formula", "constant", "wrong"),
    [
        ("P[kW] = T[Nm] × n[rpm] / CONSTANT", "9549", ("5252", "955", "60000")),
        (r"$P[kW] = T[Nm]\cdot n[1/min]/CONSTANT$", "9550", ("5252",)),
        (
            r"$P\,[\mathrm{kW}] = \frac{T\,[\mathrm{Nm}]\cdot n\,[\mathrm{min^{-1}}]}{CONSTANT}$",
            "9549",
            ("716",),
        ),
        (r"$c[m/s] = s[mm] n[rpm]/CONSTANT$", "30000", ("60000", "30", "3000")),
    ],
)
def test_the_constant_converts_the_units(formula, constant, wrong):
    lead = QUANTITIES[formula.lstrip("$")[0]]
    assert verdicts_in(f"{lead} So\n{formula.replace('CONSTANT', constant)}.")[-1] == "conditional"
    for other in wrong:
        assert verdicts_in(f"{lead} So\n{formula.replace('CONSTANT', other)}.")[-1] == "refuted"


def test_the_power_is_known_by_its_name_too():
    page = "The power is P[kW] = T[Nm] × n[rpm] / {0}."
    assert verdicts_in(page.format(9549))[-1] == "conditional"
    assert verdicts_in(page.format(9000))[-1] not in ("holds", "conditional")


def test_an_index_in_brackets_is_no_unit():
    assert verdicts_in("$y[n] = a x[n]$")[-1] != "unreadable"
