"""Every preset engine against what books say of it: orders, amplitudes, pins and firing intervals.

The rows stand in `textbook.toml`, whose head explains the fields and the units. To add an engine,
add its file to the catalogue and a `[[row]]` there:

1. Take the orders and amplitudes from a book, or derive them by hand, never from this program; name
   the authority in `source`, or write "by hand:" and the derivation in one line.
2. Where it differs from a preset that has a row in sizes alone, list it there under `like` instead.
3. List all surviving orders up to 12 and give each its amplitudes: vertical and lateral, or forward
   and backward, as exact expressions. `printed` holds a figure as the book rounds it.
4. Where a document is wrong, add it to `disputed` with the reason; the test then proves it differs.

Amplitudes are compared by proof: both are real and not negative, and the difference of their
squares is an algebraic number whose minimal polynomial is x. Of angles such as 75.5 degrees that
number is of degree 192, and no proof ends: `by_digits` in a row leaves them at 30 digits.
"""

from __future__ import annotations

import tomllib
from decimal import Decimal
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import sympy

from symbalance.engine.catalogue import load, preset_names, presets
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.forces.free_forces import Balance, Resultant, balance

Row = dict[str, Any]
HIGHEST = 12
CLEARLY = Decimal("1e-3")
COMPONENTS = ("vertical", "lateral", "forward", "backward")
FULL_STATEMENTS = ({"vertical", "lateral"}, {"forward", "backward"}, set(COMPONENTS))
X = sympy.Symbol("x")

_TEXT = (Path(__file__).parent / "textbook.toml").read_text(encoding="utf-8")
ROWS: list[Row] = tomllib.loads(_TEXT)["row"]
every_row = pytest.mark.parametrize("row", ROWS, ids=[row["engine"] for row in ROWS])
KINDS = ("force", "couple")
PUBLISHED = ("innio-v16",)
"""Engines whose maker publishes their forces: tests/independent/test_published_v16.py holds those."""


def entries(row: Row, kind: str) -> list[Row]:
    return row.get(kind, [])


@cache
def left_in(engine: str) -> Balance:
    return balance(load(engine), order=HIGHEST)


def resultant(engine: str, kind: str, order: int) -> Resultant:
    return getattr(left_in(engine)[order], kind)


def proved_zero(number: sympy.Expr) -> bool:
    number = sympy.expand(number)
    return number == 0 or sympy.minimal_polynomial(number, X) == X


def proved_equal(found: sympy.Expr, stated: sympy.Expr, *, by_digits: bool = False) -> bool:
    """Whether two amplitudes are equal, by proof and, apart from it, to 30 digits; or by digits alone."""
    assert found.is_nonnegative, f"{found} is no amplitude"
    assert stated.is_nonnegative, f"{stated} is no amplitude"
    close = abs(sympy.N(found, 40) - sympy.N(stated, 40)) < Decimal("1e-30")
    return bool(close) and (by_digits or proved_zero(found**2 - stated**2))


def by_number(layout: Engine) -> list[Cylinder]:
    return sorted(layout.cylinders, key=lambda cylinder: cylinder.number)


def firing_intervals(layout: Engine) -> list[Fraction]:
    order = layout.firing_order()
    assert order is not None
    fires = {c.number: c.fires for c in layout.cylinders}
    first = order.index(1)
    angles = [fires[n] for n in order[first:] + order[:first]]
    cycle = Fraction(180 * layout.strokes)
    return [b - a for a, b in zip(angles, [*angles[1:], cycle], strict=True)]


def test_every_preset_has_a_row_and_every_row_a_preset() -> None:
    """Engines with unlike cylinders have theirs in `unlike.toml` (`test_real_engines`)."""
    alike = [name for name in preset_names() if load(name).has_common_harmonics]
    named = [name for row in ROWS for name in (row["engine"], *row.get("like", ()))]
    assert sorted([*named, *PUBLISHED]) == sorted(alike)


def test_every_preset_says_what_it_is_and_where_it_comes_from() -> None:
    for preset in presets():
        assert load(preset.name).name == preset.name
        assert preset.description
        assert preset.source


@pytest.mark.parametrize(
    ("name", "engine"), [(name, row["engine"]) for row in ROWS for name in row.get("like", ())]
)
def test_an_engine_like_another_stands_and_turns_as_that_does(name: str, engine: str) -> None:
    """Then its forces and couples are the other's, and its firing intervals too."""
    places = [
        [(c.number, c.bank, c.throw, c.station) for c in by_number(load(each))] for each in (name, engine)
    ]
    assert places[0] == places[1]
    assert firing_intervals(load(name)) == firing_intervals(load(engine))
    assert load(name).strokes == load(engine).strokes


@every_row
def test_row_is_complete(row: Row) -> None:
    assert row["source"]
    for kind in KINDS:
        stated = [n for entry in entries(row, kind) for n in entry["orders"]]
        assert sorted(stated) == row[f"{kind}_orders"]
        for entry in entries(row, kind):
            assert set(entry) & set(COMPONENTS) in FULL_STATEMENTS


@every_row
def test_pins(row: Row) -> None:
    pins = [c.throw.in_degrees() for c in by_number(load(row["engine"]))]
    assert [(pin - pins[0]) % 360 for pin in pins] == [Fraction(pin) for pin in row["pins"]]


@every_row
def test_firing_intervals(row: Row) -> None:
    stated = [Fraction(step) for step in row["firing_intervals"]]
    assert firing_intervals(load(row["engine"])) == stated


@every_row
def test_surviving_orders(row: Row) -> None:
    left = left_in(row["engine"])
    assert [o.order for o in left.orders if not o.force.is_zero()] == row["force_orders"]
    assert [o.order for o in left.orders if not o.couple.is_zero()] == row["couple_orders"]


@pytest.mark.spread(12)
@every_row
def test_amplitudes(row: Row) -> None:
    for kind in KINDS:
        for entry in entries(row, kind):
            for n in entry["orders"]:
                check_amplitudes(resultant(row["engine"], kind, n), entry, by_digits="by_digits" in row)


def check_amplitudes(found: Resultant, entry: Row, *, by_digits: bool) -> None:
    for name in COMPONENTS:
        if name in entry:
            amplitude, stated = found.component(name).amplitude, sympy.sympify(entry[name])
            assert proved_equal(amplitude, stated, by_digits=by_digits), (
                found.order,
                name,
                amplitude,
                stated,
            )
    if "phase" in entry:
        assert found.vertical.phase == sympy.sympify(entry["phase"])


@every_row
def test_figures_as_printed(row: Row) -> None:
    for kind in KINDS:
        for entry in entries(row, kind):
            for name, printed in entry.get("printed", {}).items():
                found = resultant(row["engine"], kind, entry["orders"][0]).component(name)
                exact = Decimal(str(sympy.N(found.amplitude, 20)))
                assert exact.quantize(Decimal(printed)) == Decimal(printed)


@every_row
def test_disputed_claims_are_refuted(row: Row) -> None:
    for claim in row.get("disputed", []):
        found = resultant(row["engine"], claim["of"], claim["order"])
        exact = found.component(claim["component"]).amplitude
        assert claim["reason"]
        assert claim["source"]
        assert abs(sympy.N(exact - sympy.sympify(claim["claimed"]), 30)) > CLEARLY
