"""Numbers put in with factors of conversion: what converts what is open, what it comes to is not."""

import pytest

from symbalance.checking import check

MASSES = "$m = 500$ g, $r = 40$ mm, $\\omega = 300$ 1/s:\n\n$F = 500\\cdot 40\\cdot 300^2 = {}"
GAS = "$p = 60$ bar, $A = 50$ cm²:\n\n$F = {}"
SPEED = "$s = 80$ mm, $n = 3000$ rpm:\n\n$v_m = {}"
POWER = "$M = 200$ Nm, $n = 3000$ 1/min:\n\n$P = {}"
TORQUE = "$P = 60$ kW, $n = 3000$ 1/min:\n\n$M = {}"


@pytest.mark.parametrize(
    ("page", "claim"),
    [
        (MASSES, "1.8\\cdot10^9$ N"),
        (MASSES, "1.8\\times 10^{9}$ N"),
        (MASSES, "1{,}8\\cdot 10^9$ N"),
        (MASSES, "1.8·10⁹$ N"),
        (GAS, "60\\cdot 10^5\\cdot 50 = 300$ MN"),
        (GAS, "60\\cdot 10^5\\cdot 50\\cdot 10^{-4} = 30$ MN"),
        (SPEED, "2\\cdot 80\\cdot 3000/60 = 8000$ m/s"),
        (SPEED, "2\\cdot 0.08\\cdot 3000/60 = 8$ km/s"),
        (POWER, "200\\cdot 3000/9550 = 62.8$ W"),
        (POWER, "200\\cdot 3000/9.55 = 62.8$ W"),
        (TORQUE, "9550\\cdot 60/3000 = 191$ kN m"),
    ],
)
def test_a_result_in_another_unit_does_not_hold(page, claim):
    assert check(page.format(claim)).verdicts[-1].verdict == "refuted"


@pytest.mark.parametrize(
    ("page", "claim"),
    [
        (GAS, "60\\cdot 10^5\\cdot 50\\cdot 10^{-4} = 30$ kN"),
        (GAS, "60\\cdot 50\\cdot 10 = 30000$ N"),
        (GAS, "6\\cdot 50\\cdot 10^2 = 30$ kN"),
        (SPEED, "2\\cdot 80\\cdot 3000/60 = 8000$ mm/s"),
        (SPEED, "2\\cdot 80\\cdot 3000/60000 = 8$ m/s"),
        (SPEED, "80\\cdot 3000/30000 = 8$ m/s"),
        (POWER, "200\\cdot 3000/9550 = 62.8$ kW"),
        (TORQUE, "9550\\cdot 60/3000 = 191$ N m"),
        ("$c = 50$ N/mm, ten springs:\n\n$k = {}", "10\\cdot 50 = 500$ N/mm"),
        ("$V = 2$ l, $p = 10$ bar:\n\n$W = {}", "2\\cdot 10\\cdot 100 = 2000$ J"),
    ],
)
def test_a_result_in_its_unit_is_not_accused(page, claim):
    assert check(page.format(claim)).verdicts[-1].verdict != "refuted"
