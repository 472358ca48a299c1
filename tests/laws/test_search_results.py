"""What holds of every search: its picture shows each point at its values, its decimals are exact."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
import sympy

from symbalance.document.shapes import Circle
from symbalance.search import search_cranks
from symbalance.search.search_document import HEIGHT, WIDTH, front_drawing

QUESTIONS: dict[str, dict[str, Any]] = {
    "five": {"cylinders": 5, "minimize": ["couple.1", "couple.2"]},
    "vee": {"cylinders": 8, "banks": [-45, 45], "minimize": ["couple.1", "bending"]},
    "uneven": {
        "cylinders": 4,
        "intervals": "any",
        "grid": 90,
        "minimize": ["evenness", "couple.1", "adjacent"],
    },
}


@pytest.mark.parametrize("name", QUESTIONS)
def test_points_of_a_picture_lie_in_it_at_their_values(name: str) -> None:
    result = search_cranks(**QUESTIONS[name], compiled=False)
    drawing = front_drawing(result)
    assert drawing is not None
    places = [shape.centre for shape in drawing.shapes if isinstance(shape, Circle)]
    assert len(places) == len(result.points) > 1
    for axis, (size, quantity) in enumerate(zip((WIDTH, HEIGHT), result.minimized, strict=False)):
        values = [float(point.stars[0].values[quantity].near) for point in result.points]
        along = [place[axis] for place in places]
        assert min(along) >= 0
        assert 0.8 * size < max(along) < size
        scale = max(along) / max(values)
        assert along == pytest.approx([scale * value for value in values], abs=1e-9)


def magnitudes(value: Any) -> Iterator[dict[str, str]]:
    """Give every exact number of a result's JSON, with its decimal."""
    if isinstance(value, dict):
        if {"exact", "decimal"} <= set(value):
            yield value
        value = list(value.values())
    if isinstance(value, list | tuple):
        for each in value:
            yield from magnitudes(each)


@pytest.mark.parametrize("name", QUESTIONS)
def test_decimals_are_those_of_the_exact_numbers_to_twenty_digits(name: str) -> None:
    found = list(magnitudes(search_cranks(**QUESTIONS[name], compiled=False).data()))
    irrational = 0
    for number in found:
        value, decimal = sympy.sympify(number["exact"]), number["decimal"]
        assert abs(sympy.N(value, 40) - sympy.Float(decimal, 40)) <= abs(value) * sympy.Float("5e-20", 40)
        if not value.is_rational:
            irrational += 1
            assert 19 <= len(decimal.replace(".", "").lstrip("0")) <= 20, decimal
    assert irrational > 2 or name == "uneven"
