"""With = in the rod's angle, what is true to the first order alone is wrong: F_N = F_K sin β."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

LEAD = (
    "Let θ be the crank angle, β the rod angle, F_K the piston force and F_N the side force on the "
    "cylinder wall. With λ = r/l, sin β = λ sin θ.\n\n"
)


def verdict(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(LEAD + text + "\n", encoding="utf-8")
    return check(page, fixes=False).verdicts[-1].verdict


def test_the_side_force_goes_with_the_tangent(tmp_path):
    assert verdict(tmp_path, "F_N = F_K tan β.") in ("holds", "conditional")
    assert verdict(tmp_path, "F_N = F_K sin β.") == "refuted"


@pytest.mark.parametrize("said", ["Approximately F_2 = F_1 sin β.", "F_2 ≈ F_1 sin β."])
def test_what_is_called_rough_is_compared_roughly(tmp_path, said):
    assert verdict(tmp_path, "F_2 = F_1 tan β. " + said) == "conditional"
