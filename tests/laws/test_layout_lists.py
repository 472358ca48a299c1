"""Law: an engine by lists of stations, pins and distances is the engine by one table a cylinder.

The tables are written here, cylinder by cylinder, from a walk of the lists that shares nothing with the
reader: a place is what its list says, less the mean of all.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import pytest
from hypothesis import given, settings

import symbalance as sb
from symbalance.crankshaft.crank import Pin
from symbalance.engine.catalogue import preset_text
from symbalance.engine.engine_file import parse_engine
from symbalance.engine.engine_writing import engine_text
from tests import ROOT
from tests.cranks import engine as crank_engine
from tests.cranks import sheet

few = settings(deadline=None, max_examples=20, derandomize=True, database=None)
quarters = st.integers(-40, 40).map(lambda n: Fraction(n, 4))
steps = st.integers(1, 24).map(lambda n: Fraction(n, 8))
degrees = st.integers(-360, 360).map(lambda n: Fraction(n, 2))


def text(number: Fraction) -> str:
    return f'"{number}"'


def listed(values: Any) -> str:
    if isinstance(values, list):
        return f"[{', '.join(map(listed, values))}]"
    return str(values) if isinstance(values, int) else text(values)


def by_lists(train: Mapping[str, Any], layout: Mapping[str, Any]) -> sb.Engine:
    rows = [f"{key} = {value if key == 'ratio' else listed(value)}" for key, value in train.items()]
    lists = [
        f"{key} = {json.dumps(value) if isinstance(value, str) else listed(value)}"
        for key, value in layout.items()
    ]
    return parse_engine("\n".join(["[crank_train]", *rows, "[layout]", *lists]), "lists.toml", "one")


def by_tables(train: Mapping[str, Any], rows: list[dict[str, Any]]) -> sb.Engine:
    """Return the engine of tables with number, throw, bank, station (from any zero) and perhaps fires."""
    mean = sum((row["station"] for row in rows), Fraction(0)) / len(rows)
    lines = ["[crank_train]"]
    lines += [f"{key} = {value if key == 'ratio' else text(value)}" for key, value in train.items()]
    for row in rows:
        lines += ["[[cylinder]]", f"number = {row['number']}"]
        lines += [
            f"{key} = {text(value - mean if key == 'station' else value)}"
            for key, value in row.items()
            if key != "number"
        ]
    return parse_engine("\n".join(lines), "tables.toml", "one")


@st.composite
def drawings(draw: st.DrawFn) -> tuple[list[Fraction], list[list[int]]]:
    """Return the axes of one to three banks and their cylinders' numbers, front to rear."""
    banks = draw(st.lists(st.integers(-90, 90).map(Fraction), min_size=1, max_size=3, unique=True))
    counts = [draw(st.integers(1, 4)) for _ in banks]
    numbers = iter(draw(st.permutations(range(1, sum(counts) + 1))))
    return banks, [[next(numbers) for _ in range(count)] for count in counts]


@few
@given(drawings(), st.data())
def test_pins_and_stations_of_each_bank(
    drawing: tuple[list[Fraction], list[list[int]]], data: st.DataObject
) -> None:
    banks, cylinders = drawing
    pins = [[data.draw(degrees) for _ in bank] for bank in cylinders]
    stations = []
    for bank in cylinders:
        place, places = data.draw(quarters), []
        for _ in bank:
            places.append(place)
            place -= data.draw(steps)
        stations.append(places)
    train = {"ratio": 4}
    lists = {"banks": banks, "cylinders": cylinders, "pins": pins, "stations": stations}
    rows = [
        {"number": n, "throw": pin, "bank": axis, "station": place}
        for axis, bank, throws, places in zip(banks, cylinders, pins, stations, strict=True)
        for n, pin, place in zip(bank, throws, places, strict=True)
    ]
    assert by_lists(train, lists) == by_tables(train, rows)


@few
@given(drawings(), st.data())
def test_what_all_banks_share(
    drawing: tuple[list[Fraction], list[list[int]]], data: st.DataObject
) -> None:
    """One list of pins and one of distances, banks shifted and pins turned as a whole; in mm and not."""
    banks, cylinders = drawing
    most = max(map(len, cylinders))
    pins = [data.draw(degrees) for _ in range(most)]
    apart = [data.draw(steps) + 1 for _ in range(most - 1)]
    stagger, splay = ([data.draw(each) for _ in banks] for each in (quarters, degrees))
    pitch = data.draw(st.integers(40, 400).map(lambda n: Fraction(n, 4)))
    rows = [
        {"number": n, "throw": pins[i] + turned, "bank": axis, "station": shift - sum(apart[:i])}
        for axis, bank, shift, turned in zip(banks, cylinders, stagger, splay, strict=True)
        for i, n in enumerate(bank)
    ]
    shared = {"banks": banks, "cylinders": cylinders, "pins": pins, "splay": splay}
    train = {"pitch": pitch}
    other = by_tables(train, rows)
    assert by_lists(train, {**shared, "pitch": apart, "stagger": stagger}) == other
    in_mm = {"station_unit": "mm", "stagger": [s * pitch for s in stagger]}
    assert by_lists(train, {**shared, **in_mm, "pitch": [s * pitch for s in apart]}) == other
    stations = [-sum(apart[:i], Fraction(0)) * pitch for i in range(most)]
    assert by_lists(train, {**shared, **in_mm, "stations": stations}) == other


def test_stagger_alone_in_mm_leaves_the_cylinders_a_pitch_apart() -> None:
    train = {"stroke": 80, "rod": 130, "pitch": 100, "reciprocating_mass": "1/2"}
    shared = {"banks": [-45, 45], "cylinders": [[1, 3], [2, 4]], "pins": [0, 180]}
    in_mm = by_lists(train, {**shared, "stagger": [10, -10], "station_unit": "mm"})
    assert in_mm == by_lists(train, {**shared, "stagger": ["1/10", "-1/10"]})
    assert by_lists(train, {**shared, "stagger": [0, 0], "station_unit": "mm"}) == by_lists(train, shared)


def cylinders_of(engine: sb.Engine) -> list[sb.Cylinder]:
    return sorted(engine.cylinders, key=lambda c: c.number)


@pytest.mark.parametrize(
    "name", ["v6-90-splayed", "v8-90", "inline-4-cross", "harley-m8", "bmw-r1200", "vw-vr6", "vw-w8"]
)
def test_a_firing_order_s_engine_by_the_pins_it_has(name: str) -> None:
    """Listed pins, with the same firing order, give the cylinders, firing angles and all."""
    engine = sb.load(name)
    banks = engine.grouped(lambda c: c.bank)
    order, cycle = engine.firing_order(), 180 * engine.strokes
    assert order is not None
    fired = {c.number: c.fires for c in engine.cylinders}
    intervals = [
        (fired[b] - fired[a]) % cycle for a, b in zip(order, [*order[1:], *order[:1]], strict=True)
    ]
    by_pins = sb.engine.from_pins(
        [[c.throw.in_degrees() for c in bank] for bank in banks.values()],
        banks=[bank.in_degrees() for bank in banks],
        cylinders=[[c.number for c in bank] for bank in banks.values()],
        stations=[[c.station for c in bank] for bank in banks.values()],
        offset=[bank[0].offset for bank in banks.values()],
        firing_order=order,
        firing_intervals=intervals,
        strokes=engine.strokes,
        name=engine.name,
        crank_train=sb.engine.CrankTrain(
            stroke=engine.first.sizes.stroke,
            rod=engine.first.sizes.rod,
            given_ratio=engine.first.sizes.given_ratio,
        ),
    )
    assert [c.throw for c in cylinders_of(by_pins)] == [c.throw for c in cylinders_of(engine)]
    assert [c.fires for c in cylinders_of(by_pins)] == [c.fires for c in cylinders_of(engine)]
    one, other = sb.balance(by_pins), sb.balance(engine)
    assert [o.force for o in one.orders] == [o.force for o in other.orders]
    assert [o.couple for o in one.orders] == [o.couple for o in other.orders]
    if not any(c.offset for c in engine.cylinders) and name != "harley-m8":
        alone = sb.engine.from_pins(
            [[c.throw.in_degrees() for c in bank] for bank in banks.values()],
            banks=[bank.in_degrees() for bank in banks],
            cylinders=[[c.number for c in bank] for bank in banks.values()],
            firing_order=order,
        )
        assert {c.number: c.fires for c in alone.cylinders} == fired


@pytest.mark.parametrize("name", ["honda-rc211v", "innio-v16"])
def test_presets_by_lists_are_those_written_cylinder_by_cylinder(name: str) -> None:
    """Each cylinder's table as the preset held it before it was written by lists."""
    source = (ROOT / "tests" / "record" / "engines" / f"{name}-by-cylinder.toml").read_text(
        encoding="utf-8"
    )
    tables = parse_engine(source, f"{name}.toml", name)
    lists = sb.load(name)
    assert "[[cylinder]]" in source
    assert "[[cylinder]]" not in preset_text(name)
    assert cylinders_of(lists) == cylinders_of(tables)
    one, other = sb.balance(lists), sb.balance(tables)
    assert [o.force for o in one.orders] == [o.force for o in other.orders]
    assert [o.couple for o in one.orders] == [o.couple for o in other.orders]


def test_an_engine_by_lists_is_written_and_read_back_as_itself() -> None:
    layout = 'firing_order = [1, 5, 3, 6, 2, 4]\npitch = [91, 91, 104.5, 91, 91]\nstation_unit = "mm"\n'
    six = parse_engine(f"[layout]\n{layout}", "six.toml", "six")
    assert six.pitch == 91
    assert [c.station * 91 for c in six.cylinders[:3]] == [
        Fraction("234.25"),
        Fraction("143.25"),
        Fraction("52.25"),
    ]
    assert parse_engine(engine_text(six), "written.toml") == six


def test_builders_take_what_files_take() -> None:
    six = sb.inline("1-5-3-6-2-4", pitch=[91, 91, "104.5", 91, 91], station_unit="mm", name="six")
    layout = 'firing_order = [1, 5, 3, 6, 2, 4]\npitch = [91, 91, 104.5, 91, 91]\nstation_unit = "mm"\n'
    assert parse_engine(f"[layout]\n{layout}", "six.toml", "six") == six
    turned = sb.vee(90, "1-6-5-4-3-2", pins=[45, -75, 165], splay=30, cylinders=[[2, 4, 6], [1, 3, 5]])
    lists = sb.vee(
        90, "1-6-5-4-3-2", pins=[[45, -75, 165], [75, -45, -165]], cylinders=[[2, 4, 6], [1, 3, 5]]
    )
    assert turned == lists


FOUR = '[layout]\nfiring_order = [1, 3, 4, 2]\nstation_unit = "mm"\n'
PLACES_OF_FOUR = ["pitch = [110, 130, 110]\n", "stations = [300, 190, 60, -50]\n"]


@pytest.mark.parametrize("places", PLACES_OF_FOUR)
def test_a_crankshaft_stands_where_the_lists_say(places: str, tmp_path: Path) -> None:
    """Pins of 32, webs of 24 and journals of 30 mm are 110 apart; a middle journal of 50 makes 130."""
    text = sheet(FOUR + places, length="length = [30, 30, 50, 30, 30]").replace(
        "rod = 192", "rod = 192\npitch = 110"
    )
    running = crank_engine(tmp_path, text)
    middles = [
        (start + end) / 2 for part, start, end in running.crank.stations() if isinstance(part, Pin)
    ]
    apart = [b - a for a, b in pairwise(middles)]
    assert apart == pytest.approx([0.110, 0.130, 0.110])
    stations = [float(c.station * running.engine.pitch) / 1000 for c in running.engine.cylinders]
    assert [a - b for a, b in pairwise(stations)] == pytest.approx(apart)


@pytest.mark.parametrize("places", PLACES_OF_FOUR)
def test_a_crankshaft_that_contradicts_the_lists_is_refused(places: str, tmp_path: Path) -> None:
    text = sheet(FOUR + places).replace("rod = 192", "rod = 192\npitch = 110")
    with pytest.raises(sb.SymbalanceError, match="pins 2 and 3 lie 110 mm apart: must lie 130 mm apart"):
        crank_engine(tmp_path, text)
