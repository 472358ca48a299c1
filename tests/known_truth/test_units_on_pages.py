"""Numbers and units of several hands: every relation of a page is judged as its truth allows.

`units_on_pages.txt` holds pages as an English student, a German protocol, an imperial workshop and a
Japanese memo write them. Behind a line `@@` stand the truths of its relations: R right, W wrong, X open
(numbers put in without units, a line that rests on a wrong one).
"""

import re

import pytest

from symbalance.checking import check
from symbalance.notes.checking.verdicts import FAILING, REFUTED, UNDECIDED
from tests import TESTS

PAGES = [
    page
    for page in re.split(
        r"^=+\n", (TESTS / "known_truth" / "units_on_pages.txt").read_text("utf-8"), flags=re.MULTILINE
    )
    if page.strip()
]
_TRUTHS = re.compile(r"\s*@@\s*([RWX]+)\s*$")


@pytest.mark.parametrize("page", PAGES, ids=[page.strip().split("\n")[0][:40] for page in PAGES])
def test_units_are_read_where_they_are_meant(page):
    text, _, symbols = page.partition("[symbols]")
    truths = {n: m[1] for n, line in enumerate(text.split("\n"), 1) if (m := _TRUTHS.search(line))}
    lines = [_TRUTHS.sub("", line) for line in text.split("\n")]
    sidecar = f"[symbols]{symbols}" if symbols else None
    entries = check("\n".join(lines), sidecar).data()["links"]
    wrong = []
    for line, truth in truths.items():
        verdicts = [e["verdict"] for e in entries if e["line"] == line and "continues" not in e]
        accused = {"W": {REFUTED}, "R": set(), "X": {*FAILING, UNDECIDED}}
        is_so = len(verdicts) == len(truth) and all(
            (verdict in accused[one])
            if one == "W"
            else (verdict not in FAILING or verdict in accused[one])
            for verdict, one in zip(verdicts, truth, strict=True)
        )
        if not is_so:
            wrong.append((lines[line - 1], truth, verdicts))
    assert wrong == []
