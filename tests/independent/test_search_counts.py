"""Cranks, stars and classes of in-line engines, counted by formulas of their own and by the walk.

By Burnside's lemma: of a group of symmetries there are as many classes as cranks that a symmetry leaves
as they are, on average. Pins are places 0 to N-1, each on one of M rays: of a two-stroke, or with an odd
number of cylinders, M = N and a ray has one pin; of a four-stroke with an even number M = N/2 and a ray
has two. Pin 0 is on ray 0. The symmetries are

    mirror image     s(i) -> -s(i)
    from the rear    s(i) -> s(N-1) - s(N-1-i)
    both             s(i) -> s(N-1-i) - s(N-1)

What each leaves as it is is counted by hand below, by choosing for the pairs of places i, N-1-i a pair
of rays: the library counts by dynamic programming over pins, which shares nothing with this.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import permutations
from math import factorial

import numpy as np
import pytest

from symbalance.search import search_cranks
from symbalance.search.counting import count_all
from symbalance.search.problem import search_problem


def one_pin_a_ray(count: int) -> tuple[int, int, int]:
    """N pins on N rays, N above 2: no crank is its mirror image, whose rays would be 0 and N/2 alone."""
    half = count // 2
    cranks = factorial(count - 1)
    if count % 2:
        # Both leaves none: its pairs are s and s + c with 2 c = 0. From the rear: pairs are x and c - x,
        # c not 0, since ray 0 is taken; the one ray that is its own partner has the middle place.
        rear, both = (count - 1) * factorial(half - 1) * 2 ** (half - 1), 0
    else:
        # Both: antipodes, the pair of places 0 and N-1 on 0 and N/2. From the rear: c odd, or two rays
        # would be their own partners and have no place.
        both = factorial(half - 1) * 2 ** (half - 1)
        rear = half * both
    return cranks, cranks // 2, (cranks + rear + both) // 4


def two_pins_a_ray(count: int) -> tuple[int, int, int]:
    """N pins on M = N/2 rays, M above 2, each with two."""
    rays = count // 2
    cranks = factorial(count - 1) // 2 ** (rays - 1)
    # Both: pairs of places on s and s + c, 2 c = 0. c = 0: each pair has a ray of its own, pair 0 ray 0.
    both = factorial(rays - 1)
    if rays % 2 == 0:  # c = M/2: each pair of antipodes twice, its ends either way round
        both += factorial(rays - 1) // 2 ** (rays // 2 - 1) * 2 ** (rays - 1)
    rear = 0
    for c in range(rays):  # pairs of places on x and c - x
        alone = sum((2 * x - c) % rays == 0 for x in range(rays))
        pairs = (rays - alone) // 2
        if c == 0:  # pair 0 fills ray 0; the other pairs of rays are taken twice, either way round
            rear += factorial(rays - 1) // 2**pairs * 4**pairs
        else:  # pair 0 is on 0 and c, which another pair of places takes too
            rear += factorial(rays - 1) // 2 ** (pairs - 1) * 2 ** (2 * pairs - 1)
    return cranks, cranks // 2, (cranks + both + rear) // 4


def by_hand(count: int, strokes: int) -> tuple[int, int, int]:
    has_two = strokes == 4 and count % 2 == 0
    return two_pins_a_ray(count) if has_two else one_pin_a_ray(count)


def test_the_formulas_are_those_of_known_engines() -> None:
    assert by_hand(5, 4) == (24, 12, 8)
    assert by_hand(12, 2)[1] == 19_958_400
    assert by_hand(6, 4) == (30, 15, 11)


@pytest.mark.parametrize("strokes", [2, 4])
@pytest.mark.parametrize("count", range(6, 21))
def test_what_is_said_to_be_searched(count: int, strokes: int) -> None:
    problem = search_problem(count, strokes=strokes)
    counts = count_all(problem, problem.symmetries)
    assert (counts.cranks, counts.stars, counts.classes) == by_hand(count, strokes)


WALKED = [
    (10, 4),
    (10, 2),
    (12, 4),
    (11, 4),
    (12, 2),
]


@pytest.mark.slow
@pytest.mark.parametrize(("count", "strokes"), WALKED)
def test_the_walk_passes_every_class_once(count: int, strokes: int) -> None:
    """Nothing cuts: the limit is above every couple, and is judged at each of the classes."""
    limit = Fraction(count * count)
    result = search_cranks(count, strokes=strokes, limit=[f"couple.1<={limit}"], compiled=True)
    found = result.found
    assert (found.cranks, found.stars, found.classes) == by_hand(count, strokes)
    assert result.tally.leaves >= found.classes


def every_crank(count: int, rays: int) -> Iterator[np.ndarray]:
    """Every crank with pin 0 on ray 0, a row each, in blocks; two-stroke, or an odd number of pins."""
    assert rays == count
    tail = np.array(list(permutations(range(8))), dtype=np.int8)
    for head in permutations(range(1, count), count - 9):
        rest = np.array([ray for ray in range(1, count) if ray not in head], dtype=np.int8)
        block = np.zeros((len(tail), count), dtype=np.int8)
        block[:, 1 : count - 8] = head
        block[:, count - 8 :] = rest[tail]
        yield block


def met_by(count: int, limits: dict[int, float]) -> tuple[int, int, int]:
    """Cranks, stars and classes whose couples of some orders are within limits, by trying every crank."""
    stations = (count - 1) / 2 - np.arange(count)
    cranks = rear = both = 0
    for block in every_crank(count, count):
        inside = np.ones(len(block), dtype=bool)
        for order, limit in limits.items():
            wave = np.exp(2j * np.pi * order * np.arange(count) / count)
            inside &= abs(wave[block] @ stations) <= limit + 1e-9
        met = block[inside].astype(int)
        cranks += len(met)
        turned = (met[:, -1:] - met[:, ::-1]) % count
        rear += int((turned == met).all(axis=1).sum())
        both += int(((-turned) % count == met).all(axis=1).sum())
    return cranks, cranks // 2, (cranks + rear + both) // 4


@pytest.mark.slow
@pytest.mark.parametrize(
    ("count", "limits"),
    [
        (10, {1: 0.3, 2: 2.0}),
        (10, {1: 0.0}),
        (11, {1: 0.25, 2: 1.0}),
        (12, {1: 0.0, 2: 0.0}),
    ],
)
def test_stars_within_limits_are_those_of_every_crank(count: int, limits: dict[int, float]) -> None:
    asked = {"limit": [f"couple.{order}<={limit}" for order, limit in limits.items()]}
    result = search_cranks(count, strokes=2, **asked, compiled=True)
    found = result.found
    assert (found.cranks, found.stars, found.classes) == met_by(count, limits)
    assert found.classes or not min(limits.values())
