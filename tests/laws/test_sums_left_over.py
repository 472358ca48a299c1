"""A sum of rounded numbers is about zero to the digits printed, and is not where more is left over."""

import pytest

from symbalance.notes.checking import check

DATA = "With $J_1 = 2.4$, $J_2 = 18$, $J_3 = 6.5$, $a_2 = 0.267$ and $a_3 = {a}$: "
NODES = DATA + "$J_1 + J_2 a_2 + J_3 a_3 ≈ 0$."
PROVED = ("holds", "conditional", "holds_to_order")


def last_word(page: str) -> str:
    return check(page + "\n").verdicts[-1].verdict


@pytest.mark.parametrize(
    "page",
    [
        r"$2.4 + 18\cdot 0.267 - 6.5\cdot 1.11 \approx 0$",
        r"$1.73^2 - 3 \approx 0$",
        "$0,45·2,31 - 1,04 ≈ 0$",
        "$12.3 + 4.56 - 16.87 ≈ 0$ kN",
        NODES.replace("{a}", "-1.11"),
    ],
)
def test_what_rounding_leaves_is_about_zero(page):
    assert last_word(page) in PROVED


@pytest.mark.parametrize(
    "page",
    [
        r"$2.4 + 18\cdot 0.267 - 6.5\cdot 1.13 \approx 0$",  # more than their digits bring
        r"$2.4 + 18\cdot 0.267 + 6.5\cdot 1.11 \approx 0$",
        r"$0.3 - 0.25 \approx 0$",  # of short numbers
        r"$12.31 - 12.28 \approx 0$",
        r"$2.4 + 18\cdot 0.267 - 6.5\cdot 1.11 = 0$",
        r"$24 - 23 \approx 0$",
        NODES.replace("{a}", "-1.21"),
    ],
)
def test_what_more_is_left_is_not(page):
    assert last_word(page) not in PROVED
