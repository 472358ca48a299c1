r"""A decimal that recurs is a fraction."""

import pytest

from symbalance.checking import check


@pytest.mark.parametrize(
    ("decimal", "right", "wrong"),
    [
        ("0.8\\overline{3}", "5/6", "24/10"),
        ("0.1\\overline{6}", "1/6", "6/10"),
        ("0.\\overline{3}", "\\frac13", "\\frac{3}{10}"),
        ("2{,}\\overline{6}", "8/3", "26/10"),
        ("1.\\bar{27}", "14/11", "1.37"),
    ],
)
def test_a_decimal_that_recurs_is_a_fraction(decimal, right, wrong):
    assert check(f"${decimal} = {right}$").verdicts[-1].verdict == "holds"
    assert check(f"${decimal} = {wrong}$").verdicts[-1].verdict == "refuted"
