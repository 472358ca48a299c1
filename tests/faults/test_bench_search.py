"""The bench of the search: its counts are those of the search, and workers that differ are a fault."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from symbalance.bench import search as bench
from symbalance.search import search_cranks
from symbalance.search.tree_size import TreeSize

SIX = search_cranks(6, strokes=2, compiled=False)
SEVEN = search_cranks(7, strokes=2, compiled=False).tally.nodes


@pytest.mark.slow
def test_all_that_is_measured_is_there(monkeypatch) -> None:
    """Small engines stand for those of 11 to 15 cylinders, in half a second each."""
    asked: list[tuple[int, dict[str, Any]]] = []

    def timed(count: int, **question: Any) -> tuple[Any, float]:
        asked.append((count, question))
        return search_cranks(6 if count < 14 else count - 8, strokes=2, compiled=False), 0.5

    monkeypatch.setattr(bench, "_timed", timed)
    monkeypatch.setattr(bench, "search_cranks", lambda *_, **__: None)
    sizes = {
        15: TreeSize(9e7, 1e6, 20, 1),
        18: TreeSize(9e10, 1e9, 20, 1),
        20: TreeSize(9e12, 3e12, 20, 1),
    }
    monkeypatch.setattr(
        bench, "estimate_nodes", lambda spec, depth, samples: sizes[spec.problem.cylinders]
    )
    for quick, most in ((True, 11), (False, 12)):
        asked.clear()
        report = bench.report(quick)
        titles = [title for title, _ in report.parts]
        assert titles[0] == "One core"
        assert titles[-1].startswith("On paper")
        assert len(titles) == (2 if quick else 3)
        assert [count for count, _ in asked][:3] == [most, 14, 15]
        (stars, nodes), papers = report.parts[0][1], report.parts[-1][1]
        assert f"{SIX.searched.stars:,}" in stars.name
        assert not stars.is_met
        assert not nodes.is_met
        # At the 0.5 s that these nodes took, of a thousand cores.
        seconds = [size.nodes / SEVEN * 0.5 / 1000 for size in sizes.values()]
        assert [paper.seconds for paper in papers] == pytest.approx(seconds)
        assert "± 33 %" in papers[-1].name
        assert f"walked were {SEVEN:.3g}" in papers[0].name


def test_an_answer_that_depends_on_the_workers_is_a_fault(monkeypatch) -> None:
    wrong = replace(SIX, firings=SIX.firings + 1)
    monkeypatch.setattr(bench.os, "cpu_count", lambda: 2)
    monkeypatch.setattr(bench, "_timed", lambda *_, workers, **__: (SIX if workers < 2 else wrong, 0.5))
    with pytest.raises(AssertionError, match="depends on the workers"):
        bench._shared()


def test_throughput_is_said_for_as_many_workers_as_there_are_cores(monkeypatch) -> None:
    monkeypatch.setattr(bench.os, "cpu_count", lambda: 5)
    monkeypatch.setattr(bench, "_timed", lambda *_, workers, **__: (SIX, 8.0 / workers))
    rows = bench._shared()
    rates = [f"{SIX.tally.nodes / 8 * workers:,.0f} nodes a second" for workers in (1, 2, 4)]
    assert [row.name.partition(": ")[2] for row in rows] == rates
    assert [row.seconds for row in rows] == [8, 4, 2]
