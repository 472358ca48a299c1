"""What words name has its formula: another one behind them is refuted, and the right one never is."""

from __future__ import annotations

import tomllib

import pytest

from symbalance.checking import check
from tests import TESTS

TABLES = tomllib.loads((TESTS / "laws" / "meant_by_words.toml").read_text(encoding="utf-8"))


def lines(kind: str) -> list[object]:
    return [
        pytest.param(page, id=f"{name}-{number}")
        for name, table in TABLES.items()
        for number, page in enumerate(table[kind], 1)
    ]


def verdicts(page: str) -> set[str]:
    found = {link["verdict"] for link in check(page + "\n").data()["links"]}
    assert "unreadable" not in found
    return found


@pytest.mark.parametrize("page", lines("wrong"))
def test_what_the_words_do_not_mean_is_refuted(page):
    assert "refuted" in verdicts(page)


@pytest.mark.parametrize("page", lines("right"))
def test_what_the_words_mean_is_not_accused(page):
    assert "refuted" not in verdicts(page)


def test_each_cause_has_wrong_and_right_lines():
    for table in TABLES.values():
        assert len(table["wrong"]) >= 3
        assert len(table["right"]) >= 2
