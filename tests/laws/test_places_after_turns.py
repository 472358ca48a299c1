"""A value after a quarter or half a turn is one of the motion there, in every language of pages."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, REFUTED

SYMBOLS = {
    "r": "crank radius",
    "l": "connecting rod length",
    "x": "piston travel from top dead centre",
    "theta": "crank angle from top dead centre",
    "lambda": "rod ratio r/l",
}
MOTION = "$$x \\approx r(1-\\cos\\theta) + \\frac{\\lambda r}{4}(1-\\cos 2\\theta)$$\n\n"
QUARTERS = (
    "After a quarter turn the path is FORMULA.",
    "After a quarter of a revolution we have FORMULA.",
    "Nach einer Vierteldrehung ist FORMULA.",
    "Nach einer Viertelumdrehung liefert die Näherung FORMULA.",
    "Après un quart de tour, FORMULA.",
    "Dopo un quarto di giro la corsa vale FORMULA.",
    "Tras un cuarto de vuelta la carrera es FORMULA.",
    "クランクが1/4回転したとき FORMULA。",
    "4分の1回転では FORMULA。",
)
HALVES = (
    "After half a turn FORMULA.",
    "Nach einer halben Umdrehung ist FORMULA.",
    "Dopo mezzo giro la corsa vale FORMULA.",
    "Après un demi-tour, FORMULA.",
    "半回転すると FORMULA。",
)


def last(sentence: str, formula: str) -> str:
    checked = check(MOTION + sentence.replace("FORMULA", f"${formula}$") + "\n", SYMBOLS)
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize("sentence", QUARTERS)
def test_a_value_after_a_quarter_turn_is_the_motions_there(sentence):
    assert last(sentence, r"x \approx r(1+\lambda/2)") == CONDITIONAL


@pytest.mark.parametrize("wrong", [r"x \approx r(1+\lambda/4)", r"x \approx r(1-\lambda/2)", "x = 2r"])
@pytest.mark.parametrize("sentence", QUARTERS[::2])
def test_another_value_after_a_quarter_turn_is_refuted(sentence, wrong):
    assert last(sentence, wrong) == REFUTED


@pytest.mark.parametrize("sentence", HALVES)
def test_a_value_after_half_a_turn_is_the_motions_there(sentence):
    assert last(sentence, "x = 2r") == CONDITIONAL
    assert last(sentence, r"x = 2r(1+\lambda)") == REFUTED
