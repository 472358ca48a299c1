"""A root and the end of a tolerance are what the formula with ± above gives with one of its signs."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

BY_FORMULA = r"$x_{1,2} = -\frac p2 \pm\sqrt{\frac{p^2}{4}-q}$ with $p = -5$, $q = 6$: "
WRONG = [
    r"$x_{1,2} = 2 \pm \sqrt{4-3}$, $x_1 = 4$, $x_2 = 0$.",
    BY_FORMULA + "$x_1 = -3$, $x_2 = -2$.",
    r"$m = 2 \pm 0.1$ kg, $m_{max} = 2.2$ kg.",
    r"$m = 2 \pm 0.1$ kg, $m_{min} = 1.8$ kg.",
    r"$m = 2 \pm 0.1$ kg, so $m \le 2.0$ kg.",
    r"$d = 20 \pm 0.1$ mm, $d_{max} = 20.2$ mm.",
    r"$d = (20 \pm 0.1)$ mm, $d_{max} = 20.3$ mm.",
]
RIGHT = [
    r"$x_{1,2} = 2 \pm \sqrt{4-3}$, $x_1 = 3$, $x_2 = 1$.",
    BY_FORMULA + "$x_1 = 3$, $x_2 = 2$.",
    r"$m = 2 \pm 0.1$ kg, $m_{max} = 2.1$ kg, $m_{min} = 1.9$ kg.",
    r"$m = 2 \pm 0.1$ kg, so $m \le 2.1$ kg and $m \ge 1.9$ kg.",
    r"$d = 20 \pm 0.1$ mm, $d_{max} = 20.1$ mm, $d_{min} = 19.9$ mm.",
    r"$d = (20 \pm 0.1)$ mm, $d_{max} = 20.1$ mm.",
    r"$x_{1,2} = \pm 3$; $x_1 = 3$, $x_2 = -3$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_what_neither_sign_gives_is_refuted(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_what_one_gives_is_not(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}
