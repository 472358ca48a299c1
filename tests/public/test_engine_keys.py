"""Evidence: the table of keys, the reader, the JSON Schema and docs/engine-files.md say the same.

Files that hold every key are sound for the reader and for the schema (of another library); with one value
spoilt, one key misspelt or one left out, both refuse them, and the reader names the line that it was
written on.
"""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Callable, Iterator
from datetime import date
from decimal import Decimal
from fractions import Fraction
from pathlib import Path as File
from typing import Any

import hypothesis.strategies as st
import jsonschema
import pytest
from hypothesis import given, settings

from symbalance.cli import run
from symbalance.crankshaft.files import read_running_engine
from symbalance.crankshaft.files.crank_keys import FILE_KEYS, reference_of_keys, schema_of_engine_files
from symbalance.crankshaft.files.operation import Strength
from symbalance.engine.catalogue import preset_names, preset_text
from symbalance.engine.engine_file import SCHEMA, parse_engine, schema_text
from symbalance.errors import SymbalanceError
from symbalance.text.key_tables import Key, TableKeys
from symbalance.text.kinds import (
    Choice,
    ExactNumber,
    ListOf,
    ListOrLists,
    MeasuredNumber,
    OneOrList,
    Text,
    Whole,
)
from tests import ROOT
from tests.toml_writing import Path, text_of, written

PAGE = ROOT / "docs" / "engine-files.md"
SHIPPED = ROOT / "symbalance" / "engine" / SCHEMA
MARKS = re.compile(r"(<!-- keys: made .*? -->\n)(.*?)(<!-- keys: end -->\n)", re.DOTALL)
VALIDATOR = jsonschema.Draft202012Validator(json.loads(schema_of_engine_files()))


# --- what is made from the table of keys ---


@pytest.mark.slow
def test_the_shipped_schema_is_made_from_the_keys(request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update"):
        SHIPPED.write_text(schema_of_engine_files(), encoding="utf-8")
    assert schema_text() == schema_of_engine_files()
    jsonschema.Draft202012Validator.check_schema(json.loads(schema_text()))


def test_the_page_lists_the_keys_as_they_are(request: pytest.FixtureRequest) -> None:
    text = PAGE.read_text(encoding="utf-8")
    renewed = MARKS.sub(lambda m: f"{m[1]}\n{reference_of_keys()}\n{m[3]}", text)
    if request.config.getoption("--update"):
        PAGE.write_text(renewed, encoding="utf-8")
    assert PAGE.read_text(encoding="utf-8") == renewed
    assert len(MARKS.findall(renewed)) == 1


def test_the_command_prints_the_schema(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["engines", "--schema"]) == 0
    assert json.loads(capsys.readouterr().out) == json.loads(schema_text())


def test_only_keywords_that_mean_the_same_in_every_draft_since_6_are_used() -> None:
    """Editors check by drafts of their own; an older one passes over a keyword it does not know."""
    known = {"$schema", "$id", "title", "description", "default", "type", "enum", "const", "pattern"}
    known |= {"properties", "additionalProperties", "required", "items", "minItems", "maxItems"}
    known |= {"minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum", "maxLength"}
    known |= {"allOf", "anyOf", "oneOf", "not"}

    def keywords(schema: Any) -> Iterator[str]:
        if isinstance(schema, dict):
            yield from schema
            for keyword, inner in schema.items():
                each = inner.values() if keyword == "properties" else [inner]
                for one in each:
                    yield from keywords(one)
        elif isinstance(schema, list):
            for one in schema:
                yield from keywords(one)

    used = set(keywords(json.loads(schema_text())))
    assert used - known == set()


# --- files that are sound ---

EXAMPLES = [
    *(preset_text(name) for name in preset_names()),
    *(p.read_text(encoding="utf-8") for p in sorted((ROOT / "derivations").rglob("*.toml"))),
    *(p.read_text(encoding="utf-8") for p in sorted((ROOT / "tests" / "record").rglob("*.toml"))),
    *re.findall(r"```toml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL),
]
ENGINES = [text for text in EXAMPLES if "[layout]" in text or "[[cylinder]]" in text]


def test_there_are_examples() -> None:
    assert len(ENGINES) > len(preset_names()) + 25


@pytest.mark.parametrize("text", ENGINES, ids=lambda text: text.split("\n", 1)[0][:40])
def test_every_engine_file_we_ship_or_show_is_valid(text: str) -> None:
    VALIDATOR.validate(tomllib.loads(text))
    assert parse_engine(text, "shown.toml").cylinders


SIZED = """\
name = "six"
description = "of this test"
source = "invented"
[estimates]
bore = "assumed"
stroke = "assumed"
rod = "assumed"
pitch = "assumed"
ratio = "assumed"
offset = "assumed"
reciprocating_mass = "assumed"
rotating_mass = "assumed"
rod_mass = "assumed"
rod_centre = "assumed"
rod_inertia = "assumed"
banks = "assumed"
cylinders = "assumed"
firing_order = "assumed"
firing_intervals = "assumed"
stagger = "assumed"
stations = "assumed"
pins = "assumed"
splay = "assumed"
master = "assumed"
link_angle = "assumed"
link_radius = "assumed"
[crank_train]
bore = 81
stroke = 90
rod = 164
pitch = 65
reciprocating_mass = 0.6
rotating_mass = 0.5
offset = 0
rod_mass = 0.6
rod_centre = 50
rod_inertia = 4000
[layout]
strokes = 4
banks = [-7.5, "15/2"]
cylinders = [[1, 3, 5], [2, 4, 6]]
firing_order = [1, 5, 3, 6, 2, 4]
firing_intervals = [120, 120, 120, 120, 120, 120]
stagger = ["1/4", "-1/4"]
offset = [-12.5, 12.5]
firing_at = "dead centres"
pin_step = "1/2"
[[counterweight]]
throw = 1
overbalance = "1/2"
[[counterweight]]
web = 3
angle = 10
station = 1
unbalance = 20
[[counterweight]]
angle = 180
share = "1/4"
[[balance_shaft]]
speed = -1
phase = 30
x = 60
y = -5.5
weights = [{ station = 1, share = "1/2", phase = 180 }, { station = -1, unbalance = 3 }]
[[balance_shaft]]
speed = 2
station = "1/2"
unbalance = 3
[[balance_shaft]]
speed = 1
share = 1
"""
RADIAL = """\
strokes = 4
[crank_train]
ratio = 4
[[cylinder]]
number = 1
throw = "360/7"
bank = 0
station = "5/2"
fires = 0
bore = 120
stroke = 130
rod = 240
reciprocating_mass = 2
rotating_mass = 1
offset = 2
rod_mass = 1.2
rod_centre = 60
rod_inertia = 9000
[[cylinder]]
number = 2
throw = "360/7"
bank = 72
bore = 120
master = 1
link_angle = 72
link_radius = 54
rod = 186
reciprocating_mass = 2
rotating_mass = 0
"""
LISTS = """\
[crank_train]
pitch = 108
[layout]
banks = [45, -45]
cylinders = [[1, 3, 5], [2, 4, 6]]
firing_order = [1, 6, 5, 4, 3, 2]
pins = [45, -75, "330/2"]
splay = [0, 30]
stations = [[0, -108, "-226.5"], [-20, -128, "-246.5"]]
station_unit = "mm"
"""
DISTANCES = """\
[layout]
firing_order = [1, 3, 2]
pitch = [1, "5/4"]
"""
CRANK = """\
[crank_train]
stroke = 120
rod = 192
reciprocating_mass = 1.5
[layout]
firing_order = [1, 2]
[crankshaft]
young = 206
poisson = 0.29
density = 7850
flying_web = 12
web_only_after = [1]
no_bearing = []
[crankshaft.journal]
diameter = 65
length = [30, 30]
bore = 0
fillet = 4
[crankshaft.pin]
diameter = 55
length = 32
bore = 0
fillet = 4
[crankshaft.web]
thickness = 24
width = 100
tip = 38
heel = 44
[[crankshaft.counterweight]]
webs = [1]
mass = 1.1
radius = 58
angle = -5
inertia = 1100
outer = 80
half_angle = 60
[crankshaft.pulley]
mass = 3.2
polar = 14000
diametral = 8000
distance = 20
diameter = 60
[crankshaft.flywheel]
mass = 32
polar = 560000
diametral = 285000
distance = 20
diameter = 80
[bearings]
clearance = 0.035
length = 25
viscosity = 0.012
housing_vertical = 1e9
housing_lateral = [5e8, 5e8]
housing_damping = 1e4
table = "film.csv"
thrust = 2
thrust_stiffness = 2e8
[running]
bore = 92
rpm = [1000, 2200]
ambient = 1.01325
damping = 0.02
"""
STRENGTH = """\
[running.strength]
tensile = 900
endurance = 400
slope = 8
cycles = 2e6
[running.overlay]
file = "gauge.csv"
channel = "pin 1 bending"
rpm = 2200
"""
IDEAL = "compression = 17\nheat = 18\npeak_pressure = 110\nintake = 1.5\nbig_end_mass = 1.1\n"
TRACE = 'pressure = "trace.csv"\nrod_mass = 1.6\nrod_centre = 60\nrod_inertia = 11000\n'
SOUND = {
    "sized": SIZED,
    "radial": RADIAL,
    "lists": LISTS,
    "distances": DISTANCES,
    "ideal": CRANK + IDEAL + STRENGTH,
    "trace": CRANK + TRACE + STRENGTH,
}
RUNNING = ("ideal", "trace")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> File:
    folder = tmp_path_factory.mktemp("engines")
    (folder / "trace.csv").write_text("".join(f"{a},1.5\n" for a in range(0, 720, 10)))
    return folder


def read(folder: File, name: str, text: str) -> None:
    """Read a file as the command that is for it does."""
    path = folder / "engine.toml"
    path.write_text(text, encoding="utf-8")
    if name in RUNNING:
        read_running_engine(path)
    else:
        parse_engine(text, str(path))


def refusal(folder: File, name: str, text: str) -> str:
    with pytest.raises(SymbalanceError) as caught:
        read(folder, name, text)
    return str(caught.value)


def tables(text: str) -> dict[str, Any]:
    return tomllib.loads(text, parse_float=Decimal)


def holds(text: str) -> bool:
    """Tell whether the schema takes a text."""
    return VALIDATOR.is_valid(tomllib.loads(text))


def walk(table: Any, keys: TableKeys, path: Path = ()) -> Iterator[tuple[Path, Key]]:
    """Yield the path and the description of every key of a table and of those within it."""
    for name, value in table.items():
        key = keys.by_name[name]
        yield (*path, name), key
        if isinstance(key.kind, TableKeys):
            rows = value if key.listed else [value]
            for i, row in enumerate(rows):
                yield from walk(row, key.kind, (*path, name, i) if key.listed else (*path, name))


PLACES = [
    (name, path, key)
    for name, text in SOUND.items()
    for path, key in walk(tables(text), FILE_KEYS)
    if name != "trace" or (path[0] == "running" and f"{path[-1]} =" in TRACE)  # more is in "ideal"
]
IDS = [f"{name}-{'.'.join(map(str, path))}" for name, path, _ in PLACES]
each_key = pytest.mark.parametrize(("name", "path", "key"), PLACES, ids=IDS)


@pytest.mark.parametrize("name", SOUND)
def test_the_files_that_are_spoilt_below_are_sound(name: str, folder: File) -> None:
    text, _ = written(tables(SOUND[name]))
    assert holds(text), list(VALIDATOR.iter_errors(tomllib.loads(text)))
    read(folder, name, text)


def test_the_files_that_are_spoilt_below_hold_every_key() -> None:
    def names(keys: TableKeys) -> set[tuple[str, str]]:
        within = [names(key.kind) for key in keys.keys if isinstance(key.kind, TableKeys)]
        return {(keys.name, key.name) for key in keys.keys}.union(*within)

    def given(table: Any, keys: TableKeys) -> set[tuple[str, str]]:
        names_given = {(keys.name, name) for name in table}
        for name, value in table.items():
            kind = keys.by_name[name].kind
            if isinstance(kind, TableKeys):
                rows = value if isinstance(value, list) else [value]
                names_given = names_given.union(*(given(row, kind) for row in rows))
        return names_given

    assert set().union(*(given(tables(t), FILE_KEYS) for t in SOUND.values())) == names(FILE_KEYS)


# --- files that are spoilt ---


def wrong_types(key: Key) -> list[Any]:
    """Return values of another type than a key's."""
    if isinstance(key.kind, TableKeys):
        return [3, "x", [3], True]
    day = date(1979, 5, 27)
    match key.kind:
        case ExactNumber():
            return ["x", "", "1/0", "1,5", True, day, [[1]], {"inline": True, "a": 1}]
        case OneOrList():
            return ["x", True, day, ["x"], [[1]], [True]]
        case Whole():
            return ["x", "1", Decimal("1.5"), True, day, [1]]
        case Text():
            return [3, True, day, ["x"]]
        case Choice():
            return ["zz", 3, True, day, [4]]
        case ListOrLists():
            inner = [[value] for value in wrong_types(Key("", key.kind.kind, "")) if value != [[1]]]
            return [3, "x", True, {"inline": True, "a": 1}, [[]], [0, [1]], *inner, *([v] for v in inner)]
        case ListOf():
            inner = [[value] for value in wrong_types(Key("", key.kind.kind, ""))]
            return [3, "x", True, {"inline": True, "a": 1}, *(v for v in inner if v != [[1]])]
        case _:
            raise AssertionError(key.kind)


def out_of_range(kind: Any) -> list[Any]:
    """Return values of a kind's type just outside its range."""
    match kind:
        case ExactNumber():
            low = [] if kind.low is None else [kind.low] if kind.open_low else [kind.low - 1]
            low += [] if kind.low is None else [kind.low - Fraction(1, 2)]
            high = [] if kind.high is None else [kind.high] if kind.open_high else [kind.high + 1]
            bounds = [Decimal(float(n)) for n in low + high]
            bounds += [] if isinstance(kind, MeasuredNumber) else [10**9 + 1]
            bounds += ["-1/2"] if kind.low is not None and kind.low >= 0 else []
            return bounds + (["0", ".0/7"] if kind.open_low else [])
        case Whole():
            return [kind.low - 1, kind.high + 1, *([] if kind.but is None else [kind.but])]
        case OneOrList():
            inner = out_of_range(kind.kind)
            return [*inner, *([value] for value in inner)]
        case ListOrLists():
            inner = [[value] for value in out_of_range(kind.kind)]
            return [[], *inner, *([value] for value in inner)]
        case ListOf():
            short = [] if kind.least == 0 else [[]]
            return short + [[value] for value in out_of_range(kind.kind)]
        case Text():
            return [] if kind.longest is None else ["", " ", "a\nb", "x" * (kind.longest + 1)]
    return []


def with_value(name: str, path: Path, value: Any) -> tuple[str, int]:
    """Return a sound file's text with one value put in, and the line it was written on."""
    table = tables(SOUND[name])
    inner: Any = table
    for step in path[:-1]:
        inner = inner[step]
    inner[path[-1]] = value
    text, lines = written(table)
    return text, line_of(lines, path)


def line_of(lines: dict[Path, int], path: Path) -> int:
    """Return the line of a path; what stands in braces stands on the line of the list it is in."""
    while path not in lines:
        path = path[:-1]
    return lines[path]


@pytest.mark.spread(2)
@each_key
@pytest.mark.parametrize(
    "values",
    [wrong_types, lambda key: out_of_range(key.kind)],
    ids=["of another type", "out of range"],
)
def test_a_wrong_value_is_refused_on_its_line(
    values: Callable[[Key], list[Any]], name: str, path: Path, key: Key, folder: File
) -> None:
    for value in values(key):
        text, line = with_value(name, path, value)
        assert f"engine.toml:{line}: " in refusal(folder, name, text), text_of(value)
        assert not holds(text), text_of(value)


@pytest.mark.spread(15)
@each_key
def test_a_misspelt_key_is_refused_on_its_line_with_the_key_it_is_near(
    name: str, path: Path, key: Key, folder: File
) -> None:
    table = tables(SOUND[name])
    inner: Any = table
    for step in path[:-1]:
        inner = inner[step]
    misspelt = f"{key.name}x"
    renamed = {misspelt if k == key.name else k: v for k, v in inner.items()}
    inner.clear()
    inner.update(renamed)
    text, lines = written(table)
    line = line_of(lines, (*path[:-1], misspelt))
    said = refusal(folder, name, text)
    assert f"engine.toml:{line}: " in said
    assert "is an unknown key; did you mean " in said
    assert not holds(text)


REQUIRED = [place for place in PLACES if place[2].required]


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    ("name", "path", "key"), REQUIRED, ids=[f"{n}-{'.'.join(map(str, p))}" for n, p, _ in REQUIRED]
)
def test_a_missing_key_is_refused_at_the_head_of_its_table(
    name: str, path: Path, key: Key, folder: File
) -> None:
    table = tables(SOUND[name])
    inner: Any = table
    for step in path[:-1]:
        inner = inner[step]
    del inner[path[-1]]
    text, lines = written(table)
    said = refusal(folder, name, text)
    assert f"engine.toml:{line_of(lines, path[:-1])}: " in said
    assert f"needs {key.name}" in said
    assert not holds(text)


TOGETHER = [
    ("sized", ("cylinder",), [{"number": 1, "throw": 0}]),
    ("sized", ("strokes",), 4),
    ("sized", ("crank_train", "ratio"), 4),
    ("sized", ("counterweight", 0, "share"), 1),
    ("sized", ("counterweight", 0, "web"), 1),
    ("sized", ("counterweight", 1, "overbalance"), 1),
    ("sized", ("balance_shaft", 0, "share"), 1),
    ("sized", ("balance_shaft", 0, "station"), 1),
    ("sized", ("balance_shaft", 1, "share"), 1),
    ("sized", ("balance_shaft", 0, "weights"), [{"inline": True, "station": 1}]),
    ("lists", ("layout", "pitch"), [108, 118.5]),
    ("lists", ("layout", "firing_at"), "pins"),
    ("lists", ("layout", "pin_step"), 1),
    ("distances", ("layout", "splay"), [0]),
    ("distances", ("layout", "stations"), [0, -1, -2]),
    ("radial", ("cylinder", 0, "link_angle"), 10),
    ("radial", ("cylinder", 0, "link_radius"), 10),
    ("ideal", ("running", "pressure"), "trace.csv"),
    ("ideal", ("running", "rod_mass"), 1),
    ("trace", ("running", "heat"), 18),
    ("trace", ("running", "peak_pressure"), 90),
    ("trace", ("running", "intake"), 1),
    ("trace", ("running", "compression"), 17),
    ("trace", ("running", "big_end_mass"), 1),
]


@pytest.mark.spread(2)
@pytest.mark.parametrize(("name", "path", "value"), TOGETHER, ids=str)
def test_keys_that_contradict_each_other_are_refused_by_both(
    name: str, path: Path, value: Any, folder: File
) -> None:
    text, _ = with_value(name, path, value)
    assert "engine.toml" in refusal(folder, name, text)
    assert not holds(text)


ALONE = [
    ("sized", ("layout",)),
    ("lists", ("layout", "pins")),
    ("distances", ("layout", "firing_order")),
    ("sized", ("counterweight", 0, "throw")),
    ("sized", ("counterweight", 1, "unbalance")),
    ("sized", ("balance_shaft", 1, "unbalance")),
    ("radial", ("cylinder", 1, "master")),
    ("ideal", ("running", "compression")),
    ("ideal", ("bearings", "housing_vertical")),
    ("ideal", ("bearings", "housing_lateral")),
    ("trace", ("running", "pressure")),
    ("trace", ("running", "rod_centre")),
]


@pytest.mark.parametrize(("name", "path"), ALONE, ids=str)
def test_keys_that_need_another_are_refused_by_both(name: str, path: Path, folder: File) -> None:
    table = tables(SOUND[name])
    inner: Any = table
    for step in path[:-1]:
        inner = inner[step]
    del inner[path[-1]]
    text, _ = written(table)
    assert "engine.toml" in refusal(folder, name, text)
    assert not holds(text)


def test_heat_or_a_peak_pressure_and_viscosity_or_a_table(folder: File) -> None:
    for table, keys in (("running", ("heat", "peak_pressure")), ("bearings", ("viscosity", "table"))):
        bare = tables(SOUND["ideal"])
        for key in keys:
            less = tables(SOUND["ideal"])
            del less[table][key], bare[table][key]
            assert holds(written(less)[0])
        assert "needs " + keys[0] in refusal(folder, "ideal", written(bare)[0])
        assert not holds(written(bare)[0])


# --- the schema is never stricter than the reader ---

KINDS = {repr(k.kind): k.kind for _, _, k in PLACES if not isinstance(k.kind, TableKeys)}
scalars = (
    st.integers(-(10**10), 10**10)
    | st.integers(-3, 3)
    | st.decimals(-2000, 2000, places=2)
    | st.booleans()
    | st.sampled_from(["", "x", "pins", "1/2", "-1/2", "3/0", "0", " 7 ", "+.5e1", "1e999", "2.5/1.5"])
    | st.text(max_size=4)
    | st.just(date(1979, 5, 27))
)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS, ids=lambda text: text[:60])
@settings(max_examples=60, deadline=None)
@given(
    value=scalars | st.lists(scalars, max_size=3) | st.lists(st.lists(scalars, max_size=2), max_size=2)
)
def test_what_the_reader_takes_the_schema_takes_too(kind: str, value: Any) -> None:
    """And what only the reader refuses is text, whose size no schema sees, or a matter of fine angles."""
    plain = json.loads(json.dumps(value, default=lambda v: float(v) if isinstance(v, Decimal) else {}))
    fits = jsonschema.Draft202012Validator(KINDS[kind].schema()).is_valid(plain)
    try:
        KINDS[kind].read(value, "key", "")
    except SymbalanceError:
        flat = value if isinstance(value, list) else [value]
        flat = [v for row in flat for v in (row if isinstance(row, list) else [row])]
        assert not fits or any(isinstance(v, str | Decimal) for v in flat)
    else:
        assert fits


def test_the_strength_that_is_not_given_is_the_usual_one(folder: File) -> None:
    path = folder / "engine.toml"
    path.write_text(CRANK + IDEAL, encoding="utf-8")
    assert read_running_engine(path).operation.strength == Strength()


def test_defaults_are_those_of_the_builders() -> None:
    """The reader leaves a key that is not given to the builder: both must mean the same."""
    text = "[layout]\nfiring_order = [1, 3, 4, 2]\n"
    layout = FILE_KEYS.by_name["layout"].kind
    assert isinstance(layout, TableKeys)
    given: Callable[[Key], str] = lambda key: f"{key.name} = {text_of(key.default)}\n"  # noqa: E731
    defaults = "".join(given(key) for key in layout.keys if key.default is not None)
    assert defaults.count("\n") == 4
    assert parse_engine(text + defaults, "a.toml") == parse_engine(text, "a.toml")
