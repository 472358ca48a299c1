r"""A letter has one unit from line to line: 1800 N is no 1.8·10³ kg, and 632 rad/s no 632 Hz."""

import pytest

from symbalance.checking import check

PROVED = {"holds", "conditional", "holds_to_order"}
NUMBERS = ["1800", "1.8\\cdot 10^3", "1{,}8\\cdot 10^{3}", "1.8·10³", "1.8e3", "18\\times 10^{2}"]


@pytest.mark.parametrize("first", NUMBERS)
@pytest.mark.parametrize("second", NUMBERS)
def test_a_number_with_a_power_of_ten_keeps_its_unit(first, second):
    page = f"The force is $F = {first}$ N.\n\nHence $F = {second}$ UNIT."
    assert check(page.replace("UNIT", "kg")).verdicts[-1].verdict == "refuted"
    assert check(page.replace("UNIT", "N")).verdicts[-1].verdict in PROVED


@pytest.mark.parametrize("number", ["0.02", "2\\cdot 10^{-2}", "2·10⁻²", "2.0\\times10^{-2}"])
def test_so_does_a_small_one(number):
    page = f"The path is $x = 0.02$ m.\n\nHence $x = {number}$ UNIT."
    assert check(page.replace("UNIT", "N")).verdicts[-1].verdict == "refuted"
    assert check(page.replace("UNIT", "m")).verdicts[-1].verdict in PROVED


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("$\\omega_0 = 632$ rad/s", "$\\omega_0 = 632$ Hz"),
        ("$\\omega_0 = 632$ Hz", "$\\omega_0 = 632$ rad/s"),
        ("$n = 3000$ rpm", "$n = 50$ rad/s"),
        ("$f = 50$ Hz", "$f = 50$ rad/s"),
        ("$\\omega_0 = 632$ rad/s", "$f = \\omega_0 = 632$ Hz"),
        ("$\\omega_0 = 200$ rad/s", "$f = \\frac{\\omega_0}{2} = 100$ Hz"),
    ],
)
def test_turns_are_no_radians(first, second):
    verdict = check(f"{first}.\n\nHence {second}.").verdicts[-1]
    assert (verdict.verdict, "2π" in verdict.reason) == ("refuted", True)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("$\\omega = 314$ rad/s", "$\\omega = 314$ s$^{-1}$"),
        ("$n = 3000$ rpm", "$n = 50$ Hz"),
        ("$n = 3000$ rpm", "$n = 50$ 1/s"),
        ("$\\omega_0 = 632$ rad/s", "$f = \\omega_0/2\\pi = 100.6$ Hz"),
        ("$n = 3000$ rpm", "$\\omega = 2\\pi n = 314.2$ rad/s"),
        ("$\\omega_0 = 632$ rad/s", "$T = 2\\pi/\\omega_0 = 9.94$ ms"),
    ],
)
def test_what_is_converted_holds(first, second):
    assert check(f"{first}.\n\nHence {second}.").verdicts[-1].verdict in PROVED


@pytest.mark.parametrize("unit", ["N", "s$^{-2}$", "rad/s"])
def test_a_sum_of_powers_of_ten_has_no_unit_of_its_own(unit):
    page = f"$1.545\\times10^6 + 2.963\\times10^5 = 1.841\\times10^6$ {unit}"
    assert check(page).verdicts[-1].verdict in PROVED
