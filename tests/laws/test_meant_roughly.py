"""What words call rough is compared as behind ≈; a wrong sign or factor in it is refuted all the same."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

LEAD = "λ is the crank ratio, θ the crank angle.\n\n"
WORDS = [
    "{} = {}, nearly.",
    "Neglecting higher powers, {} = {}.",
    "To a first approximation {} = {}.",
    "Näherungsweise ist {} = {}.",
    "近似的に {} = {} となる。",
    "In the two-term formula {} = {}.",
    "Avec deux termes {} = {}.",
]
SIDES = [("√(1 - λ² sin² θ)", "1 - ½ λ² sin² θ", "1 + ½ λ² sin² θ"), ("1/(1 - λ)", "1 + λ", "1 - λ")]


@pytest.mark.parametrize("words", WORDS)
@pytest.mark.parametrize(("left", "right", "wrong"), SIDES)
def test_a_series_called_rough_holds_and_a_wrong_one_does_not(tmp_path, words, left, right, wrong):
    def verdict(side):
        page = tmp_path / "page.md"
        page.write_text(LEAD + words.format(left, side) + "\n", encoding="utf-8")
        return check(page, fixes=False).verdicts[-1].verdict

    assert verdict(right) in ("conditional", "holds_to_order")
    assert verdict(wrong) in ("refuted", "undecided")


def test_what_follows_from_a_rough_relation_is_rough_too(tmp_path):
    page = tmp_path / "page.txt"
    text = (
        "R is the crank radius, L the length of the rod, n = L/R.\n\n    sin B = (sin A)/n\n\n"
        "    x = R (1 - cos A) + L (1 - cos B)\n\nIt is accurate enough to put\n\n"
        "    cos B = 1 - (sin A)²/(2 n²), nearly,\n\nwhence\n\n    x = R (1 - cos A + {})\n"
    )
    words = []
    for last in ("(sin A)²/(2 n)", "(sin A)²/n"):
        page.write_text(text.replace("{}", last), encoding="utf-8")
        words.append(check(page, fixes=False).verdicts[-1].verdict)
    assert words[0] == "conditional"
    assert words[1] in ("refuted", "undecided")


MOTION = (
    "With $q = r/L$ the displacement of the piston at the crank angle $\\theta$ is\n"
    "$$s = r(1-\\cos\\theta) + L(1-\\cos\\phi),\\qquad \\cos\\phi = \\sqrt{1-q^2\\sin^2\\theta}.$$\n\n"
)
AT_PLACE = [
    ("At $\\theta = 90^\\circ$ it is $s = r(1+q/2)$ in the two-term formula.", "conditional"),
    ("At $\\theta = 90^\\circ$ it is $s = r(1+q/3)$ in the two-term formula.", "refuted"),
    ("At $\\theta = 90^\\circ$ it is $s = r(1-q/2)$, approximately.", "refuted"),
    ("At $\\theta = 90^\\circ$ it is $s = r(1+q/2)$ exactly.", "refuted"),
]


@pytest.mark.parametrize(("words", "verdict"), AT_PLACE)
def test_a_value_at_an_angle_may_be_rough_too(words, verdict):
    assert check(MOTION + words + "\n", fixes=False).verdicts[-1].verdict == verdict
