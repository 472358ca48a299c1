"""Roots of unity with a name, ζ = e^{-2πi/5}: what a page says of them in any of its sections."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import HOLDS, HOLDS_TO_ORDER, REFUTED, UNDECIDED

FIVE = [
    r"With $\zeta = e^{-2\pi i/5}$",
    r"Let $\zeta = e^{-2\pi i/5}$.",
    r"Mit $\zeta = e^{-i 72^\circ}$ gilt",
]
THROWS = FIVE[0] + r" the throws add to nothing, $1+\zeta+\zeta^2+\zeta^3+\zeta^4 = 0$."
OF_FIVE = [
    (r"\zeta^5 = 1", HOLDS),
    (r"\zeta^8 = \zeta^3", HOLDS),
    (r"\zeta^8 = \zeta^2", REFUTED),
    (r"1+\zeta+\zeta^2 = 0", REFUTED),
    (r"\frac{1-\zeta^5}{1-\zeta} = 0", HOLDS),
    (r"2+\zeta^2-\zeta^4-2\zeta = 0.2639 + 0.3633 i", HOLDS_TO_ORDER),
    (r"2+\zeta^2-\zeta^4-2\zeta = 0.2639 - 0.3633 i", REFUTED),
    (
        r"2+\zeta^2-\zeta^4-2\zeta = (2 - 0.809 - 0.309 - 0.618) + i(-0.588 - 0.951 + 1.902)",
        HOLDS_TO_ORDER,
    ),
    (r"2+\zeta^2-\zeta^4-2\zeta = (2 - 0.809 - 0.309 - 0.618) + i(-0.588 + 0.951 + 1.902)", REFUTED),
]


def last_verdict(page: str) -> str:
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize("introduction", FIVE)
def test_a_root_of_unity_keeps_its_value_beyond_its_section(introduction):
    for formula, verdict in OF_FIVE:
        assert last_verdict(f"## Throws\n\n{introduction}\n\n## Couples\n\n$${formula}$$") == verdict


def test_another_section_may_give_the_letter_another_root():
    page = f"## Five\n\n{THROWS}\n\n## Three\n\nWith $\\zeta = e^{{2\\pi i/3}}$:\n\n"
    assert last_verdict(rf"{page}$$1+\zeta+\zeta^2 = 0$$") == HOLDS
    assert last_verdict(rf"{page}$$\zeta^5 = 1$$") == REFUTED


@pytest.mark.parametrize("words", ["## The three-cylinder engine\n\n", "For three cylinders "])
def test_words_that_name_another_engine_leave_it_open(words):
    assert last_verdict(f"## Five\n\n{THROWS}\n\n{words}$1+\\zeta+\\zeta^2 = 0$") == UNDECIDED
