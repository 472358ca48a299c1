"""Pages of people who never saw the checker: what it says of them is no worse than it was.

`hand/unseen/tally.toml` holds the counts of each page. A page may only become better; `--update` writes
the counts anew.
"""

import tomllib
from collections import Counter

import pytest

from tests.unseen_pages import KINDS, UNSEEN, judged, tally

TALLY = UNSEEN / "tally.toml"
TRUTHS = sorted(UNSEEN.rglob("*.truth.toml"))


def _counts(relations):
    return {kind: dict(sorted(counts.items())) for kind, counts in tally(relations).items() if counts}


@pytest.mark.slow
@pytest.mark.parametrize("truth", TRUTHS, ids=lambda p: p.name.split(".")[0])
def test_no_page_is_judged_worse_than_before(truth, request):
    name = f"{truth.parent.name}/{truth.name.split('.')[0]}"
    now = _counts(judged(truth))
    if request.config.getoption("--update"):
        _write(name, now)
    before = tomllib.loads(TALLY.read_text(encoding="utf-8"))[name]
    for kind in KINDS:
        was, own = Counter(before.get(kind, {})), Counter(now.get(kind, {}))
        assert own["silent"] <= was["silent"]
        if kind == "wrong":
            assert own["refuted"] >= was["refuted"]
            assert own["confirmed"] <= was["confirmed"]
        else:
            assert own["refuted"] <= was["refuted"], "a right relation is accused"
            assert own["confirmed"] + own["given"] >= was["confirmed"] + was["given"]


def _write(name, counts):
    known = tomllib.loads(TALLY.read_text(encoding="utf-8")) if TALLY.exists() else {}
    known[name] = counts
    lines = ["# of the relations of each kind, how many had which outcome: pytest --update writes it"]
    for page, kinds in sorted(known.items()):
        lines += ["", f'["{page}"]']
        for kind, outcomes in kinds.items():
            inner = ", ".join(f"{outcome} = {count}" for outcome, count in outcomes.items())
            lines.append(f"{kind} = {{ {inner} }}")
    TALLY.write_text("\n".join(lines) + "\n", encoding="utf-8")


def test_every_page_has_its_truth_and_its_tally():
    assert len(TRUTHS) >= 15
    known = tomllib.loads(TALLY.read_text(encoding="utf-8"))
    assert {f"{t.parent.name}/{t.name.split('.')[0]}" for t in TRUTHS} == set(known)
