"""Evidence: the glossary is complete and agrees with the symbols; names and help texts keep to it."""

from __future__ import annotations

import argparse
import re

import pytest

from symbalance.cli.parser import build_parser
from symbalance.document.symbols import MEANINGS
from tests import ROOT

PAGE = ROOT / "docs" / "glossary.md"
COLUMNS = ["term", "meaning", "symbol", "unit", "German", "Japanese"]
ROWS = [
    [cell.strip() for cell in line.strip().strip("|").split(" | ")]
    for line in PAGE.read_text(encoding="utf-8").splitlines()
    if line.startswith("|") and not line.startswith("|---")
]
TERMS = ROWS[1:]
NONE = "–"

NOT_IN_NAMES = {
    *(
        "found",
        "told",
        "hung",
        "made",
        "seen",
        "ours",
        "theirs",
        "asked",
        "aims",
        "ways",
        "shares",
        "arms",
    ),
    *("resultants", "tops", "trains", "unlike", "hanging", "boxes", "sectors", "extremes", "weighed"),
    *("arranging", "entries", "numeric", "waves", "crests", "wide", "kernels", "ahead", "against"),
    *("wording", "cleared", "gathering", "spin", "holding", "setting", "marching", "closing", "shells"),
    *("meanings", "claims", "mending", "sieving"),
}
"""Words of an earlier vocabulary: the field has others, or they say nothing by themselves."""
NOT_IN_HELP = (
    *("found", "told", "hung", "made", "seen", "ours", "theirs"),
    *("orders to end", "end given orders", "end exactly", "least is left", "dead centres apart by"),
)


def public_names() -> set[str]:
    stubs = sorted((ROOT / "symbalance").rglob("*.pyi"))
    return {name for stub in stubs for name in re.findall(r" as (\w+)$", stub.read_text(), re.MULTILINE)}


def parsers() -> dict[str, argparse.ArgumentParser]:
    """Return the parser of every command, by its words."""
    top = build_parser()
    commands = next(a for a in top._actions if isinstance(a, argparse._SubParsersAction))
    return {"symbalance": top, **commands.choices}


def test_every_term_has_every_column_and_an_own_name() -> None:
    assert ROWS[0] == COLUMNS
    assert all(len(row) == len(COLUMNS) and all(row) for row in TERMS)
    assert all(NONE not in (row[0], row[1], row[4], row[5]) for row in TERMS)
    names = [row[0].casefold() for row in TERMS]
    assert names == sorted(set(names))
    assert len(names) > 60


def test_meanings_are_one_sentence_each() -> None:
    for term, meaning, *_ in TERMS:
        assert re.fullmatch(r"[A-Z][^.]*\.", meaning), term


def test_japanese_is_written_in_japanese_and_german_is_not() -> None:
    for *_, german, japanese in TERMS:
        assert re.search(r"[\u3040-\u30ff\u4e00-\u9fff]", japanese), japanese
        assert re.fullmatch(r"[A-Za-zÄÖÜäöüß -]+", german), german


@pytest.mark.parametrize("name", MEANINGS)
def test_symbols_of_the_formulas_are_there_with_their_units(name: str) -> None:
    symbol = f"${MEANINGS[name].latex}$"
    rows = [row for row in TERMS if row[2] == symbol]
    assert [row[3] for row in rows] == [MEANINGS[name].unit], symbol


def test_no_symbol_stands_for_two_things() -> None:
    symbols = [row[2] for row in TERMS if row[2] != NONE]
    assert len(symbols) == len(set(symbols))


def test_public_names_keep_to_the_glossary() -> None:
    names = public_names()
    assert len(names) > 30
    parts = {name: set(re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower().split("_")) for name in names}
    assert {name: words & NOT_IN_NAMES for name, words in parts.items() if words & NOT_IN_NAMES} == {}


@pytest.mark.parametrize("command", parsers())
def test_help_texts_keep_to_the_glossary(command: str) -> None:
    text = " ".join(parsers()[command].format_help().split())
    assert [words for words in NOT_IN_HELP if re.search(rf"\b{words}\b", text)] == []
