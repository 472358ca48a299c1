"""Numbers without a unit beside quantities are read in the unit that goes with them, if that is right."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

RIGHT = [
    "$B = 2.5$ kN. Then $A = 10 - B = 7.5$ kN.",
    "$B = 2.5$ kN. Then $A = 10 - B = 10 - 2.5 = 7.5$ kN.",
    "$B = 2500$ N. Then $A = 10 - B = 7.5$ kN.",
    "$B = 2.5$ kN. $A + B = 10$. Hence $A = 7.5$ kN.",
    "$B = 2.5$ kN. $A = 10 - B = 7.5$ kN. $M = A \\cdot 2$ m $= 15$ kN m.",
    "$B = 2.5$ kN, $l = 4$ m. $A = \\frac{10 \\cdot 2 - B \\cdot 1}{l} = 4.375$ kN.",
    "$F = 3x$. At $x = 2$ mm $F = 6$ N.",
    "$x = 3 + 2t$. At $t = 5$ s, $x = 13$ m.",
    "$r = 40$ mm. $s = 2r + 5 = 85$ mm.",
    "$p_{me} = 10$ bar, $V_H = 2$ l, $n = 3000$ rpm: "
    "$P = \\frac{p_{me}V_H n}{1200} = \\frac{10\\cdot2\\cdot3000}{1200} = 50$ kW.",
    "$v_m = 2 s n = 2\\cdot 0.09\\cdot 50 = 9$ m/s. "
    "$v_m = \\frac{s n}{30} = \\frac{0.09\\cdot 3000}{30} = 9$ m/s.",
    "$s = 0.09$ m, $n = 50$ 1/s. $v_m = 2 s n = 9$ m/s. "
    "$v_m = \\frac{s n}{30} = \\frac{0.09\\cdot 3000}{30} = 9$ m/s.",
    "$x_0 = 50$, $x_1 = x_0 + 20\\,\\% = 60$",
    "$m = 50$ kg, $M = m - 10\\% = 45$ kg",
]
WRONG = [
    "$B = 2.5$ kN. Then $A = 10 - B = 8.5$ kN.",
    "$B = 2.5$ kN. $A + B = 10$. Hence $A = 8.5$ kN.",
    "$F = 3x$. At $x = 2$ mm $F = 7$ N.",
    "$r = 40$ mm. $s = 2r + 5 = 95$ mm.",
    "$p = 10$ bar, $V = 2$ l, $n = 3000$ rpm: $P = \\frac{p V n}{600} = 50$ kW.",
    "$v_m = 2 s n = 2\\cdot 0.09\\cdot 50 = 9$ m/s. $v_m = \\frac{s n}{60}$.",
    "$m = 2$ kg, $v = 3$ m/s. $E = m v/2 = 3$ J.",
    "$x = 5$ mm, $l = 2$ m. $y = 1 + x/l = 3.5$.",
    "$m = 500$ g, $a = 2$ m/s². $F = m a = 1000$ N.",
    "$x_0 = 50$, $x_1 = x_0 + 20\\,\\% = 70$",
]


@pytest.mark.parametrize("page", RIGHT)
def test_what_is_right_by_the_numbers_is_not_refuted(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


@pytest.mark.parametrize("page", WRONG)
def test_what_is_wrong_by_them_is(tmp_path, page):
    assert {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}
