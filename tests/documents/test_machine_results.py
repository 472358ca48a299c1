"""Results of linear algebra and of time steps as they are read: words and places exactly, numbers nearly.

The last digits of eigenvalues are the machine's. So these golden files are compared piece by piece: each
word, sign and rule must be the same, each number within one in a hundred or two of its last digit.
`pytest --update` rewrites them, and whoever does so reads the change.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path

import pytest

from symbalance.crankshaft.reports.summary import Summary
from symbalance.document.result import Result, to_json, to_text
from tests.results import example

GOLDEN = Path(__file__).parent.parent / "golden"
NAMES = ["campbell", "critical-speeds", "torsional-chain", "unbalance-response", "whirl", "crankshaft"]
"""Not `natural-modes`: a round shaft bends as willingly in one direction as in any other."""
AS_JSON = [name for name in NAMES if name not in ("whirl", "campbell")]
"""Of these two, less is printed than JSON holds: shapes, and the whirl of modes that do not whirl."""
PIECE = re.compile(
    r"(?P<number>(?<![\w.])[−-]?\d+(?:\.\d+)?(?:e[−+-]?\d+)?)|(?P<rule>─+)|\S+?(?=[\s:,]|$)|[:,]"
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
    before = list(pieces(path.read_text(encoding="utf-8")))
    for place, (old, new) in enumerate(zip_longest(before, pieces(text), fillvalue=("end", ""))):
        if not nearly_the_same(old, new):
            around = " ".join(piece for _, piece in before[max(0, place - 12) : place])
            raise AssertionError(f"{path.name}: after “{around}”: {old[1]!r} is now {new[1]!r}")


@pytest.mark.spread("campbell", "critical-speeds", "torsional-chain", "unbalance-response", "whirl")
@pytest.mark.parametrize("name", NAMES)
def test_text(name: str, request: pytest.FixtureRequest) -> None:
    path, text = GOLDEN / f"machine-{name}.txt", to_text(steady(name), width=80)
    if request.config.getoption("--update"):
        path.write_text(text, encoding="utf-8")
    compare(path, text)


@pytest.mark.spread("critical-speeds", "torsional-chain", "unbalance-response")
@pytest.mark.parametrize("name", AS_JSON)
def test_json(name: str, request: pytest.FixtureRequest) -> None:
    path, text = GOLDEN / f"machine-{name}.json", to_json(steady(name))
    if request.config.getoption("--update"):
        path.write_text(text, encoding="utf-8")
    compare(path, text)


@pytest.mark.parametrize(
    ("old", "new", "same"),
    [
        ("mode 3  19.197 Hz", "mode 3   19.21 Hz", True),
        ("mode 3  19.197 Hz", "mode 3  19.6 Hz", False),
        ("−19.197", "19.197", False),
        ("mode 3  forward", "mode 3  backward", False),
        ("1  2  3", "1  2", False),
        ("1: 15.4, 0.5: 11.7", "1: 15.4, 1.5: 11.7", False),
        ("4.123e−4 −", "4.13e−4 −", True),
        ('"a": 4.1, "b": 1.2345678901234e-17', '"a": 4.1, "b": -3.1e-18', True),
        ('"a": 4.1, "b": 2', '"a": 4.1, "c": 2', False),
        ("x ─────", "x ───", True),
        ("axis U", "axis V", False),
    ],
)
def test_what_counts_as_the_same(tmp_path: Path, old: str, new: str, same: bool) -> None:
    path = tmp_path / "old.txt"
    path.write_text(old, encoding="utf-8")
    if same:
        return compare(path, new)
    with pytest.raises(AssertionError, match=r"old\.txt: after"):
        compare(path, new)
    return None
