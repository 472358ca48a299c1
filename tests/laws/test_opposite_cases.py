"""A root or a size is judged by its own case: otherwise, case 2 (x < 0), whatever the sign."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def verdict_at(tmp_path, page, place):
    path = tmp_path / "page.md"
    path.write_text(page)
    return check(path, fixes=False).verdicts[place].verdict


@pytest.mark.parametrize(
    "page",
    [
        "**Case 1** (x > 0): |x| = x. **Case 2** (x < 0): |x| = x.",
        "If x > 0 then |x| = x, otherwise |x| = x.",
        "If u > 0 then √(u²) = u, else √(u²) = u.",
        "Für x > 0 ist |x| = x, sonst ist |x| = x.",
        "Si x > 0, |x| = x, sinon |x| = x.",
        "|x| = x regardless of the sign of x.",
        "√(y²) = y holds for negative y too.",
        "|x| = x unabhängig vom Vorzeichen von x.",
        "|cos θ| = cos θ on the whole circle.",
        "|cos θ| = cos θ in the second quadrant.",
        "√(1−sin²θ) = cos θ also beyond 90°.",
        "√(1−sin²θ) = cos θ at 120°.",
    ],
)
def test_the_first_case_does_not_prove_the_second(tmp_path, page):
    assert verdict_at(tmp_path, page, -1) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "x and y are negative with x² = 4 and y² = 9. Then x + y = 5.",
        "x und y sind negativ mit x² = 4 und y² = 9. Dann ist x + y = 5.",
    ],
)
def test_words_deny_a_sign(tmp_path, page):
    assert verdict_at(tmp_path, page, -1) == "undecided"


def test_a_range_of_all_values_behind_is_no_condition(tmp_path):
    assert verdict_at(tmp_path, "d/dx |x| = 1 for all x ≠ 0.", 0) == "undecided"


@pytest.mark.parametrize(
    "page",
    [
        "**Case 1** (x > 0): |x| = x. **Case 2** (x < 0): |x| = −x.",
        "If x > 0 then |x| = x, otherwise |x| = −x.",
        "Für x > 0 ist |x| = x, sonst ist |x| = −x.",
        "Si x > 0, |x| = x, sinon |x| = −x.",
        "|cos θ| = −cos θ in the second quadrant.",
        "√(1−sin²θ) = −cos θ at 120°.",
        "|x| = x for x > 0.",
    ],
)
def test_the_opposite_case_holds(tmp_path, page):
    places = -2 if page.endswith("x > 0.") else -1
    assert verdict_at(tmp_path, page, places) in PROVED
