"""A formula of a given number in letters without one says what these are."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

SYMBOLS = """[symbols]
"f" = "frequency [Hz]"
"ω" = "angular frequency [rad/s]"
"d" = "diameter [mm]"
"r" = "radius [mm]"
"s" = "stroke [mm]"
"""


@pytest.mark.parametrize(
    "page",
    [
        r"The peak lies at $f = 25\,\mathrm{Hz}$. Conversely, $f = \frac{\omega}{2\pi}$.",
        r"The disc has $d = 60\,\mathrm{mm}$. Its radius comes from $d = 2 r$.",
    ],
)
def test_it_is_at_odds_with_nothing(tmp_path, page):
    assert "refuted" not in verdicts_of(tmp_path, page, SYMBOLS)


def test_a_letter_with_a_number_is(tmp_path):
    page = r"The disc has $d = 60\,\mathrm{mm}$ and $r = 20\,\mathrm{mm}$. So $d = 2 r$."
    assert verdicts_of(tmp_path, page, SYMBOLS)[-1] in ("refuted", "contradiction")
