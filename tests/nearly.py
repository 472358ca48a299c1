"""Golden files of numbers that are no machine's alone: words and places exactly, numbers nearly.

The last digits of eigenvalues are the machine's. So these files are compared piece by piece: each word,
sign and rule must be the same, each number within one in a hundred or two of its last digit.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path

from symbalance.crankshaft.reports.summary import Summary
from symbalance.document.result import Result
from tests import TESTS
from tests.results import example

GOLDEN = TESTS / "golden"
PIECE = re.compile(
    r"""(?P<number>(?<![\w.])[−-]?\d+(?:\.\d+)?(?:e[−+-]?\d+)?)|(?P<rule>─+)|[][(){}:,"]|[^][(){}:,"\s]+"""
)
SHARE = 0.01
NOTHING = 1e-9


def steady(name: str) -> Result:
    """Return an example, less what is another at each run: the seconds it took."""
    result = example(name)
    if isinstance(result, Summary):
        outcomes = tuple(replace(outcome, seconds=0.25) for outcome in result.outcomes)
        result = replace(result, outcomes=outcomes)
    return result


def pieces(text: str) -> Iterator[tuple[str, str]]:
    """Yield the numbers and all else of a text; how wide a column is, its numbers decide."""
    for match in PIECE.finditer(text):
        kind = match.lastgroup or "word"
        yield kind, "─" if kind == "rule" else match[0]


def nearly_the_same(old: tuple[str, str], new: tuple[str, str]) -> bool:
    """Tell whether two pieces agree; of a number, to a hundredth of it or two of its last digit."""
    if old[0] != new[0] or old[0] != "number":
        return old == new
    before, after = (float(text.replace("−", "-")) for _, text in (old, new))
    digits, _, exponent = old[1].partition("e")
    last = 10.0 ** (int(exponent.replace("−", "-") or 0) - len(digits.partition(".")[2]))
    # A digit of 17 that stands for nothing is not read as one.
    return abs(after - before) <= max(SHARE * abs(before), 2 * last if len(digits) < 12 else NOTHING)


def compare(path: Path, text: str) -> None:
    """Assert that a text is nearly what a golden file holds."""
    assert path.exists(), f"{path.name}: no golden file yet: pytest --update, and read it"
    before = list(pieces(path.read_text(encoding="utf-8")))
    for place, (old, new) in enumerate(zip_longest(before, pieces(text), fillvalue=("end", ""))):
        if not nearly_the_same(old, new):
            around = " ".join(piece for _, piece in before[max(0, place - 12) : place])
            raise AssertionError(f"{path.name}: after “{around}”: {old[1]!r} is now {new[1]!r}")
