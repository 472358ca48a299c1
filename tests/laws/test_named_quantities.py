"""A formula whose quantity words name is judged by the standard one; other shapes never are."""

from __future__ import annotations

import tomllib

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, DEFINITION, FAILING, PREMISE, REFUTED, Verdict
from tests import TESTS

LAWS = TESTS / "laws"
FILES = [LAWS / "named_quantities.toml", *sorted((LAWS / "fields").glob("*.toml"))]
TABLES = [tomllib.loads(file.read_text(encoding="utf-8")) for file in FILES]
LINES = {
    kind: [line for table in TABLES for line in table.get(kind, [])]
    for kind in ("right", "wrong", "wrong_without_fix", "open", "rightly")
}


def last_verdict(page: str, symbols: dict[str, str] | None = None) -> Verdict:
    checked = check(page + "\n", symbols or {})
    assert not checked.faults
    assert not checked.derivation.unreadable
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


@pytest.mark.parametrize("page", LINES["right"])
def test_the_standard_formula_holds_for_what_the_words_name(page):
    verdict = last_verdict(page)
    assert verdict.verdict == CONDITIONAL
    assert "nobody declared it; taken from the words" in verdict.assumption


@pytest.mark.parametrize(("page", "formula"), LINES["wrong"])
def test_one_slip_is_refuted_with_the_standard_formula(page, formula):
    verdict = last_verdict(page)
    assert verdict.verdict == REFUTED
    assert "nobody declared it; taken from the words" in verdict.reason
    assert verdict.fix is not None
    assert formula in ("", verdict.fix.text)


@pytest.mark.parametrize("page", LINES["wrong_without_fix"])
def test_a_formula_with_another_letter_than_the_standard_one_is_refuted_by_its_words(page):
    verdict = last_verdict(page)
    assert verdict.verdict == REFUTED
    assert "nobody declared it; taken from the words" in verdict.reason


@pytest.mark.parametrize("page", LINES["open"])
def test_another_shape_hypothesis_or_setup_stays_a_definition(page):
    assert last_verdict(page).verdict in (DEFINITION, PREMISE)


@pytest.mark.parametrize("page", LINES["rightly"])
def test_a_right_line_of_another_convention_is_not_accused(page):
    checked = check(page + "\n", {})
    assert not checked.derivation.unreadable
    assert not {verdict.verdict for verdict in checked.verdicts} & {*FAILING}


def test_there_are_lines_enough_of_each_kind():
    assert len(set(LINES["right"])) >= 150
    assert len({page for page, _ in LINES["wrong"]}) >= 150
    assert len(set(LINES["open"])) >= 100
    assert len(set(LINES["rightly"])) >= 90
