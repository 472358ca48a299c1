"""A capital letter that is set equal to a product of matrices is one; a product of numbers makes none."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def last(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("lead", ["Matrices A, B:", "Matrizen $A$ und $B$:", "For matrices $A$ and $B$:"])
def test_a_product_of_matrices_is_a_matrix(lead):
    assert last(f"{lead} $C = A B$, so $C A^{{-1}} = B$.") == "refuted"
    assert last(f"{lead} $C = A B$, so $A^{{-1}} C = B$.") in PROVED


@pytest.mark.parametrize("lead", ["The angle is", "Matrices A, B. The angle is"])
def test_a_product_of_numbers_is_none(lead):
    assert last(f"{lead} $T = 3 \\cdot 4.1$, and $T \\approx 12.3$.") in PROVED
    assert last(f"{lead} $T = 3 \\cdot 4.1$, and $T < 10$.") in ("refuted", "contradiction")
