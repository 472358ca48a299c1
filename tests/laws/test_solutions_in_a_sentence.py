"""A balance is no claim where its sentence goes on to what solves it: cos(2γ - σ) = 0, σ = 2γ - 90°."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

CASES = [
    ("That needs\ncos γ cos(γ-σ) - sin γ sin(γ-σ) = 0, that is cos(2γ-σ) = 0, σ = 2γ - 90°.", True),
    ("Das verlangt sin(γ-σ) = 0, d. h. σ = γ.", True),
    ("Il faut cos(2γ-σ) = 0, c'est-à-dire σ = 2γ - 90°.", True),
    ("That needs cos(2γ-σ) = 0, σ = 2γ - 60°.", False),
    ("That needs cos(2γ-σ) = 0. The angle is chosen freely.", False),
    ("Das verlangt sin(γ-σ) = 0, d. h. σ = 2γ.", False),
]


@pytest.mark.parametrize(("line", "is_right"), CASES)
def test_a_balance_is_solved_in_its_sentence(tmp_path, line, is_right):
    path = tmp_path / "page.txt"
    path.write_text(f"Two pins on one shaft.\n\n{line}\n", encoding="utf-8")
    path.with_suffix(".symbols.toml").write_text(
        '[symbols]\n"γ" = "half of the bank angle"\n"σ" = "half of the angle between two pins"\n',
        encoding="utf-8",
    )
    words = [v.verdict for v in check(path, fixes=False).verdicts]
    assert ("refuted" not in words) == is_right


WAVES = [
    (r"$$4\lambda\cos\theta + 1 = 0$$ gives $$\cos\theta = -\frac{1}{4\lambda}$$", True),
    (r"$$4\lambda\cos\theta + 1 = 0$$ gives $$\cos\theta = \frac{1}{4\lambda}$$", False),
    (
        r"Aus $2\lambda\cos^2\theta + \cos\theta - \lambda = 0$ folgt, "
        r"also $$\cos\theta = \frac{-1 + \sqrt{1 + 8\lambda^2}}{4\lambda}$$",
        True,
    ),
    (
        r"Aus $2\lambda\cos^2\theta + \cos\theta - \lambda = 0$ folgt, "
        r"also $$\cos\theta = \frac{1 + \sqrt{1 + 8\lambda^2}}{4\lambda}$$",
        False,
    ),
    (r"$$\cos 2\theta = 2\cos^2\theta$$ so $$\cos\theta = 1$$", False),
]


@pytest.mark.parametrize(("line", "is_right"), WAVES)
def test_an_equation_for_a_sine_is_judged_by_what_is_put_in(tmp_path, line, is_right):
    path = tmp_path / "page.md"
    path.write_text(line + "\n", encoding="utf-8")
    path.with_suffix(".symbols.toml").write_text(
        '[symbols]\n"theta" = "crank angle"\n"lambda" = "crank ratio r/l"\n', encoding="utf-8"
    )
    words = [v.verdict for v in check(path, fixes=False).verdicts]
    assert ("refuted" not in words) == is_right
