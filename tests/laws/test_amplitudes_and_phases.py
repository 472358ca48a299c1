"""A component's cosine, sine, amplitude and phase say one thing, in every result that says all four."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import pytest
import sympy

import symbalance as sb
from symbalance.exact.spectrum import COMPONENTS
from tests.results import EXAMPLES, example

QUICK = [name for name in EXAMPLES if name not in ("crankshaft", "assignment-of-many", "check")]


def parts(value: Any) -> Iterator[dict[str, Any]]:
    """Give every object of a JSON value that has a cosine and a sine."""
    if isinstance(value, dict):
        if {"cos", "sin"} <= set(value):
            yield value
        value = list(value.values())
    if isinstance(value, list | tuple):
        for each in value:
            yield from parts(each)


def number(value: Any) -> float | None:
    """Return a number of a result's JSON as a float, or None where it has symbols or is not said."""
    if value is None or isinstance(value, int | float):
        return value
    form = sympy.sympify(value)
    return None if form.free_symbols else float(form)


@pytest.mark.spread("balance", "torque-unlike", "ellipse")
@pytest.mark.parametrize("name", QUICK)
def test_amplitude_and_phase_are_of_the_cosine_and_the_sine(name: str) -> None:
    """C cos x + S sin x = A cos(x - phase): C = A cos(phase), S = A sin(phase), A >= 0."""
    result = example(name)
    for part in [*parts(result.data()), *parts(result.records())]:
        cos, sin = number(part["cos"]), number(part["sin"])
        if cos is None or sin is None:
            continue
        size = math.hypot(cos, sin)
        if "amplitude" in part:
            assert number(part["amplitude"]) == pytest.approx(size, rel=1e-12)
        if size and part.get("phase") is not None:
            phase = number(part["phase"])
            assert phase is not None
            assert -math.pi < phase <= math.pi * (1 + 1e-12)
            assert size * math.cos(phase) == pytest.approx(cos, abs=1e-12 * size)
            assert size * math.sin(phase) == pytest.approx(sin, abs=1e-12 * size)
        for key, decimal in zip(("cos", "sin"), part.get("decimal") or (), strict=False):
            exact = number(part[key])
            assert exact is None or float(decimal) == pytest.approx(exact, rel=1e-10, abs=1e-15)
        if part.get("exact_cos") is not None:  # a gas torque has no exact form
            assert number(part["exact_cos"]) == pytest.approx(cos, rel=1e-10, abs=1e-12)
            assert number(part["exact_sin"]) == pytest.approx(sin, rel=1e-10, abs=1e-12)


@pytest.mark.parametrize("name", ["boxer-4", "v2-90", "inline-5", "radial-5", "napier-lion"])
def test_the_records_of_a_balance_are_its_components_that_are_not_zero(name: str) -> None:
    balance = sb.balance(sb.load(name), 6)
    known = {
        (order.order, of, component)
        for order in balance.orders
        for of, resultant in (("force", order.force), ("couple", order.couple))
        for component in COMPONENTS
        if resultant.component(component).amplitude != 0
    }
    assert {(row["order"], row["of"], row["component"]) for row in balance.records()} == known
