"""What a result says to one order it says to every higher one: truncation leaves out, changes nothing."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.document.result import Result

OWN = Path(__file__).parents[1] / "record" / "engines"
ENGINES = [
    "v10-72",
    "vw-vr6",
    "link-rod-twin",
    "lanchester-four",
    "rod-inertia-twin",
    "two-stroke-odd-twin",
]
HIGHEST = 6
RESULTS: dict[str, Callable[[sb.Engine, int], Result]] = {
    "balance": sb.balance,
    "inertia": sb.inertia_torque,
    "torque": sb.torque.torque_report,
    "stars": sb.torque.firing_stars,
    "gas": lambda engine, order: sb.torque.gas_torque(
        engine, sb.torque.ideal_cycle(9, heat=15, strokes=engine.strokes), order=order
    ),
    "sensitivities": sb.sensitivities,
}
KEYS = ("order", "of", "component", "parameter", "cylinder")


@cache
def rows(kind: str, name: str, order: int) -> dict[tuple[object, ...], dict[str, object]]:
    """Return the records of a result by what they are of."""
    file = OWN / f"{name}.toml"
    engine = sb.load(file if file.exists() else name)
    if engine.first.ratio is None:
        engine = engine.with_ratio(4)
    records = RESULTS[kind](engine, order).records()
    return {tuple(row.get(key) for key in KEYS): row for row in records}


@pytest.mark.spread("v10-72")
@pytest.mark.parametrize("kind", RESULTS)
@pytest.mark.parametrize("name", ENGINES)
def test_orders_are_left_out_and_nothing_else(name: str, kind: str) -> None:
    """To order N stand the rows of orders to N, order N among them, with the values they have beyond."""
    whole = rows(kind, name, HIGHEST)
    assert whole
    for order in range(1, HIGHEST):
        part = rows(kind, name, order)
        assert set(part) == {key for key in whole if float(key[0]) <= order}  # type: ignore[arg-type]
        for key, row in part.items():
            for name_of, value in row.items():
                if isinstance(value, float):
                    assert value == pytest.approx(whole[key][name_of], rel=1e-12, abs=1e-12)
                else:
                    assert str(value)[:18] == str(whole[key][name_of])[:18]


@pytest.mark.parametrize(("name", "highest"), [("v12-60", 6), ("v12-60", 12), ("inline-4", 4)])
def test_an_order_needs_the_power_of_its_leading_term(name: str, highest: int) -> None:
    """A_n begins with lambda^-(n-1): kept to that power it has one term, to a lower one it is refused."""
    engine = sb.load(name)
    assert sb.balance(engine, highest, power=highest - 1).orders[-1].order == highest
    with pytest.raises(sb.SymbalanceError, match=f"order {highest}"):
        sb.balance(engine, highest, power=highest - 2)


@pytest.mark.parametrize("strokes", [2, 4])
def test_cylinders_fire_in_the_order_of_their_angles_in_a_cycle(strokes: int) -> None:
    """A cylinder that fires just before the cycle ends is the last of it, wherever it is listed."""
    cycle = 180 * strokes
    at = [0, cycle - 1, cycle // 2, 7]
    cylinders = [sb.Cylinder(n, throw=-fires % 360, fires=fires) for n, fires in enumerate(at, 1)]
    engine = sb.engine.from_cylinders(cylinders, strokes=strokes)
    assert engine.firing_order() == [1, 4, 3, 2]
