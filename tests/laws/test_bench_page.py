"""The bench of pages counts what a page weighs, and says which targets are missed."""

from __future__ import annotations

import gzip

import symbalance as sb
from symbalance.bench.page import PageMeasurement, PageReport, measure


def test_sizes_are_those_of_the_page() -> None:
    data = sb.page(sb.load("inline-3")).html.encode()
    measured = measure("inline-3")
    assert measured.size == len(data)
    assert measured.zipped == len(gzip.compress(data, mtime=0))
    assert measured.seconds > 0


def test_what_misses_a_target_is_named() -> None:
    pages = [PageMeasurement("good", 150_000, 50_000, 1.5), PageMeasurement("large", 150_001, 1, 0.1)]
    pages += [PageMeasurement("packed", 1, 50_001, 0.1), PageMeasurement("slow", 1, 1, 1.51)]
    report = PageReport(tuple(pages))
    assert [each.name for each in report.missed_targets()] == ["large", "packed", "slow"]
    assert report.text().count("missed") == 3
