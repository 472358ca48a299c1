"""λ² ≪ 1 of a crank ratio without a number is taken as given; a ratio of numbers decides by itself."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import PROVED_WORDS, RANGE, REFUTED

SYMBOLS = {"symbols": {r"\lambda": "crank ratio r/l"}}


@pytest.mark.parametrize(
    ("formula", "verdicts"),
    [
        (r"\lambda^2 \ll 1", (RANGE,)),
        (r"\lambda \ll 1", (RANGE,)),
        (r"0.04 \ll 1", PROVED_WORDS),
        (r"3 \ll 1", (REFUTED,)),
    ],
)
def test_much_smaller(formula, verdicts):
    (verdict,) = sb.check(f"Where ${formula}$ is meant.\n", SYMBOLS).verdicts
    assert verdict.verdict in verdicts
