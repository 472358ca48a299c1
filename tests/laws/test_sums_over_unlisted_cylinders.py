"""Sums of waves over cylinders that nobody lists: an identity of them holds, and one slip does not."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

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


def _last(tmp_path, lines):
    page = tmp_path / "page.md"
    page.write_text("\n\n".join(f"$${line}$$" for line in lines) + "\n", encoding="utf-8")
    return check(page).verdicts[-1].verdict


@pytest.mark.parametrize("lines", RIGHT)
def test_an_identity_of_sums_holds(tmp_path, lines):
    assert _last(tmp_path, lines) == "holds"


@pytest.mark.parametrize("lines", WRONG)
def test_one_slip_in_it_is_refuted(tmp_path, lines):
    assert _last(tmp_path, lines) == "refuted"
