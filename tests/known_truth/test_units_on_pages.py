"""Numbers and units of several hands: every relation of a page is judged as its truth allows.

`units_on_pages.txt` holds pages as an English student, a German protocol, an imperial workshop and a
Japanese memo write them. Behind a line `@@` stand the truths of its relations: R right, W wrong, X open
(numbers put in without units, a line that rests on a wrong one).
"""

import re
import tomllib

import pytest

from symbalance.checking import check
from symbalance.notes.checking.verdicts import CONTRADICTION, FAILING, REFUTED
from tests import TESTS

PAGES = [
    page
    for page in re.split(
        r"^=+\n", (TESTS / "known_truth" / "units_on_pages.txt").read_text("utf-8"), flags=re.MULTILINE
    )
    if page.strip()
]
_TRUTHS = re.compile(r"\s*@@\s*([RWX]+)\s*$")


def _is_so(verdict, truth):
    if truth == "W":
        return verdict in (REFUTED, CONTRADICTION)
    return truth == "X" or verdict not in FAILING


@pytest.mark.parametrize("page", PAGES, ids=[page.strip().split("\n")[0][:40] for page in PAGES])
def test_units_are_read_where_they_are_meant(page, tmp_path):
    text, _, symbols = page.partition("[symbols]")
    truths = {n: m[1] for n, line in enumerate(text.split("\n"), 1) if (m := _TRUTHS.search(line))}
    lines = [_TRUTHS.sub("", line) for line in text.split("\n")]
    path = tmp_path / "page.md"
    path.write_text("\n".join(lines), "utf-8")
    letters = tomllib.loads(symbols) if symbols else None
    entries = check(path, letters).data()["links"]
    wrong = []
    for line, truth in truths.items():
        verdicts = [e["verdict"] for e in entries if e["line"] == line and "continues" not in e]
        is_so = len(verdicts) == len(truth) and all(map(_is_so, verdicts, truth))
        if not is_so:
            wrong.append((lines[line - 1], truth, verdicts))
    assert wrong == []


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [
        ("6 ft. 3 in. = 6.25 ft.", "holds"),
        ("5 ft 6 in = 66 in", "holds"),
        ("4' 3\" = 51 in", "holds"),
        ("2 lb. 4 oz. = 2.25 lb.", "holds"),
        ("6 ft. 3 in. = 6.30 ft.", "refuted"),
        ("2 lb. 4 oz. = 2.4 lb.", "refuted"),
    ],
)
def test_a_quantity_in_two_units_is_their_sum(tmp_path, relation, verdict):
    page = tmp_path / "page.txt"
    text = f"The length is such that {relation}\n\nFor the force F = 2.5 lb.\n"
    page.write_text(text, encoding="utf-8")
    assert next(v.verdict for v in check(page).verdicts if v.line == 1) == verdict
