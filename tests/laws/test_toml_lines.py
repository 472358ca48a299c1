"""Evidence: the line of a key is the one it was written on, however TOML lets it be written.

Documents are written key by key, and the writer notes each line; what no such writer writes is listed by
hand, with its lines counted.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from typing import Any

import hypothesis.strategies as st
import pytest
from hypothesis import given

from symbalance.text.toml_lines import lines_of
from tests.toml_writing import Path, written

names = st.sampled_from(["a", "b", "rod", "x.y", 'say "a"', "ü", "a-b", "#", "[c]", "="])
plain = st.sampled_from([1, "x", "[a]\n# b = 1\n", True, [1, [2, "]"], ["{", "}"]], "\\", '"""', "'"])
tables = st.recursive(
    st.dictionaries(names, plain, max_size=3),
    lambda inner: st.dictionaries(
        names, inner | st.lists(inner, min_size=1, max_size=3) | plain, max_size=3
    ),
    max_leaves=8,
)


def paths(value: Any, path: Path = ()) -> Iterator[Path]:
    if path:
        yield path
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from paths(inner, (*path, key))


@given(tables)
def test_the_line_of_a_key_is_the_one_it_was_written_on(table: dict[str, Any]) -> None:
    text, lines = written(table)
    read = tomllib.loads(text)
    lines_there = lines_of(text)
    assert {path: lines_there[path] for path in lines} == lines
    assert set(lines_there) == set(paths(read))


TEXT = '''\
# [layout]
title = """
[layout]
stroke = 1
"""            # a head in a text is none
crank_train.stroke = 73.3
crank_train . "rod" = 147
"crank_train".'pitch' = 108

[ layout ] # and a comment
banks = [
  -30,   # [cylinder]
  30,
]
when = 1979-05-27 07:32:00
firing_order = [1, 2]
point = 3.25e-1
[[cylinder]]
number = 1
   [cylinder.own]
   rod = 2
[["cylinder"]]
number = 2
weights = [ { share = 1, at = { station = 3 } },
  { share = 2 } ]
literal = '[a] = "'
long = \'\'\'
number = 3
\'\'\'
'''
LINES = {
    ("title",): 2,
    ("crank_train",): 6,
    ("crank_train", "stroke"): 6,
    ("crank_train", "rod"): 7,
    ("crank_train", "pitch"): 8,
    ("layout",): 10,
    ("layout", "banks"): 11,
    ("layout", "banks", 1): 13,
    ("layout", "when"): 15,
    ("layout", "firing_order"): 16,
    ("layout", "point"): 17,
    ("cylinder",): 18,
    ("cylinder", 0, "number"): 19,
    ("cylinder", 0, "own"): 20,
    ("cylinder", 0, "own", "rod"): 21,
    ("cylinder", 1): 22,
    ("cylinder", 1, "number"): 23,
    ("cylinder", 1, "weights", 0, "at", "station"): 24,
    ("cylinder", 1, "weights", 1, "share"): 25,
    ("cylinder", 1, "literal"): 26,
    ("cylinder", 1, "long"): 27,
}


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_what_toml_allows(end: str) -> None:
    text = TEXT.replace("\n", end)
    lines_there = lines_of(text)
    assert {path: lines_there[path] for path in LINES} == LINES
    assert set(lines_there) == set(paths(tomllib.loads(text)))


def test_lists_far_inside_each_other_are_walked_over() -> None:
    depth = 5000
    assert lines_of("a = " + "[" * depth + "1" + "]" * depth + "\nb = 2")["b",] == 2
