"""A decimal that is nearly a simple fraction, units behind a power of ten, arrows set apart by macros."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check


def verdicts_of(tmp_path, text, suffix=".md"):
    page = tmp_path / f"page{suffix}"
    page.write_text(text, encoding="utf-8")
    return sorted(check(page).verdicts, key=lambda v: v.span)


@pytest.mark.parametrize(
    ("relation", "is_right"),
    [
        (r"0.0317 \approx 1/32", True),
        (r"0.251 \approx \frac14", True),
        (r"0.373 \approx 3/8", True),
        (r"0.0317 \approx 1/35", False),
        (r"0.43 \approx 3/8", False),
        (r"1/3 \approx 0.34", False),
        (r"0.251 = 1/4", False),
        (r"2/3 \approx 0.66", True),  # cut off
        (r"2/3 = 0.66", False),
        (r"2/3 \approx 0.65", False),
    ],
)
def test_a_decimal_is_nearly_the_part_that_it_is_nearest_to(tmp_path, relation, is_right):
    (verdict,) = verdicts_of(tmp_path, f"It is ${relation}$.\n")
    assert verdict.verdict == ("holds_to_order" if is_right else "refuted")


@pytest.mark.parametrize("gap", ["~", r"\,", " ", r"\ "])
@pytest.mark.parametrize(("power", "verdict"), [("10^4", "holds_to_order"), ("10^3", "refuted")])
def test_a_unit_behind_a_power_of_ten_is_one(tmp_path, gap, power, verdict):
    text = rf"It is $a = 0.0465\cdot 565.49^2 \approx 1.487\cdot {power}{gap}\mathrm{{m/s^2}}$."
    assert verdicts_of(tmp_path, text, ".tex")[-1].verdict == verdict


@pytest.mark.parametrize("gap", [r"\qquad", r"\fsp", r"\quad"])
def test_an_arrow_between_spaces_is_seen_whatever_they_are_called(tmp_path, gap):
    text = r"\newcommand{\fsp}{\qquad}" + "\n" + rf"\[ 2x = 6 {gap}\Rightarrow{gap} x = 4 \]" + "\n"
    verdicts = verdicts_of(tmp_path, text, ".tex")
    assert [v.sign for v in verdicts if v.sign] == ["⇒"]
