"""Hand derivations of known truth: errors are found, nothing right is accused.

`hand/NAME.truth.toml`, worked out apart from the checker, says of every relation of a page what may be
said of it (the best first), and of planted errors what they are. A relation marked `hard` needs more than
the checker claims to do (two relations that fix two letters together); there it may be wrong.
"""

import tomllib
from pathlib import Path

import pytest

from symbalance.checking import check
from symbalance.notes.checking.verdicts import FAILING, PROVED_WORDS, STATED
from tests import TESTS

HAND = TESTS / "hand"
TRUTHS = sorted(HAND.glob("*.truth.toml"))
ALARMS = set(FAILING)


def judged(truth: Path) -> tuple[list[dict], dict[tuple[int, int], dict]]:
    table = tomllib.loads(truth.read_text(encoding="utf-8"))
    report = check(HAND / table["page"]).data()
    found = {(e["line"], e["link"]): e for e in report["links"] if "continues" not in e}
    return table["link"], found


@pytest.mark.spread(4)
@pytest.mark.parametrize("truth", TRUTHS, ids=lambda p: p.name.split(".")[0])
def test_every_relation_is_judged_as_its_truth_allows(truth):
    links, found = judged(truth)
    wrong = []
    for link in links:
        place = (link["line"], link["link"])
        entry = found.get(place)
        if entry is None:
            if not link.get("optional"):
                wrong.append((*place, "not found", link["expected"]))
        elif entry["verdict"] not in link["expected"] and not link.get("hard"):
            right = {*PROVED_WORDS, *STATED}
            if not (entry["verdict"] in right and set(link["expected"]) & right):
                wrong.append((*place, entry["verdict"], link["expected"]))
    assert not wrong


@pytest.mark.slow
def test_planted_errors_are_refuted_and_most_are_mended():
    planted = fixed = 0
    for truth in TRUTHS:
        links, found = judged(truth)
        for link in links:
            if "kind" in link:
                entry = found[link["line"], link["link"]]
                assert entry["verdict"] == "refuted", (truth.name, link["line"])
                assert entry["witness"], (truth.name, link["line"])
                planted += 1
                fixed += entry["fix"] is not None
    assert planted >= 50
    assert fixed >= 0.9 * planted


def test_there_are_right_pages_and_wrong_ones_in_every_format():
    tables = [tomllib.loads(p.read_text(encoding="utf-8")) for p in TRUTHS]
    assert len(tables) >= 24
    for suffix in (".md", ".tex", ".txt"):
        kinds = {t["clean"] for t in tables if t["page"].endswith(suffix)}
        assert kinds == {True, False}
