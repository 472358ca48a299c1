"""An approximation whose region stands behind it is claimed there, and is no equation to be solved."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

WRONG = [
    r"$\frac{1}{1-x} \approx 1 - x$ for $x \ll 1$.",
    r"$\sqrt{1+x} \approx 1 + x$ für $|x| \ll 1$.",
    r"$\sin x \approx 2x$ for $x < 0.1$.",
    r"$\cos\beta \approx 1 - \beta^2$ if $\beta \ll 1$.",
    r"$e^x \approx 1 - x$ pour $x \ll 1$.",
    r"$(1+x)^3 \approx x^2$ for $x \gg 1$.",
]
RIGHT = [
    r"$\frac{1}{1-x} \approx 1 + x$ for $x \ll 1$.",
    r"$\sqrt{1+x} \approx 1 + x/2$ für $x \ll 1$.",
    r"$\sin x \approx x$ for $x < 0.1$.",
    r"$(1+x)^3 \approx x^3$ for $x \gg 1$.",
    r"$\frac{x}{1+x} \approx 1$ wenn $x \gg 1$.",
    r"$\frac{x}{1+x} \approx x$ for $x \ll 1$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_wrong_approximations_are_refuted(tmp_path, page):
    assert verdicts_of(tmp_path, page)[0] == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_right_ones_hold(tmp_path, page):
    assert verdicts_of(tmp_path, page)[0] in ("holds", "holds_to_order", "conditional")
