"""What is said of engine A is judged by its numbers, wherever engine B's stand; no other's prove it."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

SYMBOLS = (
    '[symbols]\n"r" = "crank radius"\n"l" = "rod length"\n"lambda" = "crank ratio r/l"\n"s" = "stroke"\n'
)
TWO = "## Engine A\n\n$r = 40$ mm, $l = 140$ mm.\n\n## Engine B\n\n$r = 50$ mm, $l = 150$ mm.\n\n"
PAGES = [
    "Motor A has $r = 40$ mm, motor B has $r = 50$ mm. For motor A $$s = 2r = {}\\,\\mathrm{{mm}}$$",
    TWO + "## Engine A again\n\n$$\\lambda = r/l = {}$$",
    TWO + "## Comparison\n\nFor engine A $$\\lambda = r/l = {}$$",
    TWO + "## Comparison\n\nFor engine B $$\\lambda = r/l = {}$$",
    TWO + "## Vergleich\n\nUnlike engine A, engine B has $$\\lambda = r/l = {}$$",
]
RIGHT = ["80", "0.286", "0.286", "0.333", "0.333"]
WRONG = ["100", "0.333", "0.333", "0.286", "0.286"]
PROVED = ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize(("page", "number"), [*zip(PAGES, RIGHT, strict=True)])
def test_the_own_numbers_prove_it(tmp_path, page, number):
    assert last_verdict(tmp_path, page.format(number), SYMBOLS) in PROVED


@pytest.mark.parametrize(("page", "number"), [*zip(PAGES, WRONG, strict=True)])
def test_those_of_the_other_do_not(tmp_path, page, number):
    assert last_verdict(tmp_path, page.format(number), SYMBOLS) in (
        "refuted",
        "undecided",
        "contradiction",
    )
