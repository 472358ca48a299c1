"""Which cylinders an engine's symmetry exchanges: of each such class one need be tried.

A permutation of the cylinders that keeps all inner products between their vectors, and with the
constant, is an isometry of what they span: arrangements it turns into one another are equally long.
"""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.design.variations.bounds import Vector, dot

Generators = Sequence[tuple[Vector, Vector]]
"""What 1 kg of reciprocating and of rotating mass in each place adds."""
SAME = 1e-9
MOST_TRIES = 20_000


def representatives(start: Vector, generators: Generators) -> list[int]:
    """Return one place of each class.

    >>> one = [((1.0, 0.0), (0.0, 0.0)), ((0.0, 1.0), (0.0, 0.0)), ((-1.0, 0.0), (0.0, 0.0))]
    >>> representatives((0.0, 0.0), one)
    [0, 1]
    """
    count = len(generators)
    products = _products(start, generators)
    kept: list[int] = []
    for place in range(count):
        if not any(_extends(products, {other: place}) for other in kept):
            kept.append(place)
    return kept


Products = tuple[list[list[tuple[float, ...]]], float]


def _products(start: Vector, generators: Generators) -> Products:
    table = [
        [tuple(dot(x, y) for x in (*one, start) for y in (*other, start)) for other in generators]
        for one in generators
    ]
    return table, max((abs(x) for row in table for cell in row for x in cell), default=0.0) * SAME


def _extends(products: Products, images: dict[int, int], tries: list[int] | None = None) -> bool:
    """Tell whether a partial exchange of places extends to all of them; given up after `MOST_TRIES`."""
    table, grain = products
    tries = tries if tries is not None else [MOST_TRIES]
    tries[0] -= 1
    if tries[0] < 0 or not all(
        abs(x - y) <= grain
        for i, a in images.items()
        for j, b in images.items()
        for x, y in zip(table[i][j], table[a][b], strict=True)
    ):
        return False
    place = next((i for i in range(len(table)) if i not in images), None)
    if place is None:
        return True
    return any(
        _extends(products, {**images, place: image}, tries)
        for image in range(len(table))
        if image not in images.values()
    )
