"""Sums of waves over cylinders that nobody lists: an identity of them holds, and one slip does not."""

from __future__ import annotations

import pytest

from tests.checked_pages import in_displays, last_verdict

HEAD = r"V_k = F A_k \sum_j \cos k(\varphi - \alpha_j)\, e^{i\alpha_j}"
PRODUCT = r"P = \sum_j \sin(\varphi+\alpha_j)\cos(\psi+2\alpha_j)"
SPLIT = (
    r"V_k = \tfrac12 F A_k\left[ e^{ik\varphi}\sum_j e^{i(%s)\alpha_j}"
    r" + %s\sum_j e^{i(1+k)\alpha_j}\right]"
)
RIGHT = [
    (HEAD, SPLIT % ("1-k", r"e^{-ik\varphi}")),
    (
        PRODUCT,
        r"P = \tfrac12\sum_j\left[\sin(\varphi+\psi+3\alpha_j) + \sin(\varphi-\psi-\alpha_j)\right]",
    ),
    (
        r"P = \sum_j \sin\alpha_j \sin\alpha_j",
        r"P = \tfrac12 \sum_j (1 - \cos 2\alpha_j)",
    ),
]
WRONG = [
    (HEAD, SPLIT % ("k-1", r"e^{-ik\varphi}")),
    (HEAD, SPLIT % ("1-k", r"e^{ik\varphi}")),
    (
        PRODUCT,
        r"P = \tfrac12\sum_j\left[\sin(\varphi+\psi+3\alpha_j) - \sin(\varphi-\psi-\alpha_j)\right]",
    ),
    (
        r"P = \sum_j \sin\alpha_j \sin\alpha_j",
        r"P = \tfrac12 \sum_j (1 + \cos 2\alpha_j)",
    ),
]


@pytest.mark.parametrize("lines", RIGHT)
def test_an_identity_of_sums_holds(tmp_path, lines):
    assert last_verdict(tmp_path, in_displays(lines)) == "holds"


@pytest.mark.parametrize("lines", WRONG)
def test_one_slip_in_it_is_refuted(tmp_path, lines):
    assert last_verdict(tmp_path, in_displays(lines)) == "refuted"
