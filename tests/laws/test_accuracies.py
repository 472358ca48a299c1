"""Words that name an order which is not that of the next formula: "up to 2nd order", "with F_0 = …"."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import REFUTED

PAGES = (
    "# Balancing a single-cylinder engine\n\nThe inertia force {} has a size of $F_0 = m r\\omega^2$\n",
    "# Ausgleich des Einzylindermotors\n\nDie Massenkraft {} hat die Größe $F = m r\\omega^2$\n",
)
ACCURACIES = (
    "(up to 2nd order)",
    "up to and including the second order",
    "accurate to second order",
    "bis zur 2. Ordnung",
    "bis zur zweiten Ordnung",
    "jusqu'au deuxième ordre",
    "hasta el segundo orden",
    "fino al secondo ordine",
)
ORDERS = (
    (PAGES[0], "of second order"),
    (PAGES[0], "of the 2nd order"),
    (PAGES[1], "2. Ordnung"),
    (PAGES[1], "zweiter Ordnung"),
)


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("words", ACCURACIES)
def test_how_far_a_series_is_taken_names_no_order(page, words):
    assert REFUTED not in [v.verdict for v in check(page.replace("{}", words), {}).verdicts]


@pytest.mark.parametrize(("page", "words"), ORDERS)
def test_an_order_that_is_named_is_judged(page, words):
    assert REFUTED in [v.verdict for v in check(page.replace("{}", words), {}).verdicts]


@pytest.mark.parametrize(
    "page",
    [
        "# One cylinder\n\nThe inertia force of second order is with $F = m r\\omega^2$ λ times it.\n",
        "# Einzylindermotor\n\nDie Massenkraft 2. Ordnung ist mit $F = m r\\omega^2$ das λ-fache.\n",
    ],
)
def test_a_letter_that_helps_to_write_an_order_is_not_that_order(page):
    assert REFUTED not in [v.verdict for v in check(page, {}).verdicts]
