"""Numbers without a unit above, and with one below, are no slip of the unit; another prefix is."""

import pytest

from symbalance.notes.checking import check

STRESS = "With sigma_max = 92.3 and sigma_min = -20:\n\nsigma_m = (sigma_max + sigma_min)/2 = 36.15\n\n"
ENERGY = "Die Energie ist E = 5027 - 503 = 4524.\n\n"


def last_word(page: str, **symbols: str) -> str:
    checked = check(page + "\n", symbols)
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(
    "page",
    [
        STRESS + "Goodman line with sigma_m = 36.15 MPa.",
        STRESS.replace("20:", "20 (MPa):") + "Goodman line with sigma_m = 36.15 MPa.",
        ENERGY + "Aus der Energie E = 4524 kJ folgt das Rad.",
        "The force is $F = 22.32$ here.\n\nWith $F = 22.32$ kN the pin holds.",
    ],
)
def test_the_first_line_with_a_unit_says_what_the_numbers_are_in(page):
    assert last_word(page) == "holds"


@pytest.mark.parametrize(
    "page",
    [
        STRESS.replace("20:", "20 (kPa):") + "Goodman line with sigma_m = 36.15 MPa.",
        "All stresses in kPa. " + STRESS + "Goodman line with sigma_m = 36.15 MPa.",
        STRESS + "Goodman line with sigma_m = 36.25 MPa.",
        ENERGY.replace("4524.", "4524 J.") + "Aus der Energie E = 4524 kJ folgt das Rad.",
        "The force is $F = 22.32$ N here.\n\nWith $F = 22.32$ kN the pin holds.",
        "With $m = 2.5$ kg and $a = 30.5$ m/s² it is $F = m a = 76.25$.\n\nIt is $F = 76.25$ kN.",
    ],
)
def test_a_number_given_in_a_unit_above_or_another_number_does_not_hold(page):
    assert last_word(page) not in ("holds", "conditional", "holds_to_order")


def test_a_letter_declared_in_a_unit_has_it_above():
    page = "The force is $F = 22.32$ here.\n\nWith $F = 22.32$ kN the pin holds."
    assert last_word(page, F="piston force in N") == "refuted"
