"""The cranks that an engine's name says give the forces and couples that positions in motion give."""

from __future__ import annotations

from math import cos, pi

import pytest

from symbalance.notes.checking.words.engines_in_words import EnginesInWords

STEPS = 1440
ENGINES = {
    "Twin with 180° crank": [(0, 0), (180, 1)],
    "360° twin": [(0, 0), (0, 1)],
    "270° twin": [(0, 0), (270, 1)],
    "Reihendreizylinder": [(0, 0), (120, 1), (240, 2)],
    "直列4気筒": [(0, 0), (180, 1), (180, 2), (0, 3)],
    "Crossplane four": [(0, 0), (90, 1), (270, 2), (180, 3)],
    "Inline five, firing order 1-2-4-5-3": [(0, 0), (576, 1), (144, 2), (432, 3), (288, 4)],
    "straight six": [(0, 0), (120, 1), (240, 2), (240, 3), (120, 4), (0, 5)],
    "straight eight": [(0, 0), (180, 1), (90, 2), (270, 3), (270, 4), (90, 5), (180, 6), (0, 7)],
}
"""Where each crank is and where along the shaft, read off drawings of these engines."""
OPPOSED = {
    # by the direction of each crank in space and that of its cylinder
    "Boxer twin": [(0, 0, 1), (180, 1, -1)],
    "flat four": [(0, 0, 1), (180, 1, -1), (180, 2, 1), (0, 3, -1)],
    "flat six": [(0, 0, 1), (180, 1, -1), (240, 2, 1), (60, 3, -1), (120, 4, 1), (300, 5, -1)],
}


def largest(parts, order):
    """Return the largest sum of weighted cosines of an order in one turn, step by step."""
    angles = (2 * pi * k / STEPS for k in range(STEPS))
    return max(sum(w * cos(order * (a + d * pi / 180)) for w, d in parts) for a in angles)


def star_of(name):
    engines = EnginesInWords(name)
    (star,) = engines.with_stars(engines.mentions[0], 0, len(name), "", "").stars[:1]
    return star


@pytest.mark.parametrize("name", ENGINES)
@pytest.mark.parametrize("order", [1, 2, 4, 6])
def test_in_line_the_sizes_are_the_largest_sums_of_a_turn(name, order):
    throws, star = ENGINES[name], star_of(name)
    middle = sum(place for _, place in throws) / len(throws)
    assert star.force(order) == pytest.approx(largest([(1, d) for d, _ in throws], order), abs=1e-3)
    couple = largest([(middle - place, d) for d, place in throws], order)
    assert star.couple(order) == pytest.approx(couple, abs=2e-3)


@pytest.mark.parametrize("name", OPPOSED)
@pytest.mark.parametrize("order", [1, 2])
def test_of_boxers_too_where_each_piston_moves_along_its_own_axis(name, order):
    star = star_of(name)
    own = [(side, direction if side > 0 else direction + 180) for direction, _, side in OPPOSED[name]]
    places = [place for _, place, _ in OPPOSED[name]]
    middle = sum(places) / len(places)
    assert star.force(order) == pytest.approx(largest(own, order), abs=1e-3)
    pairs = zip(own, places, strict=True)
    couple = largest([(side * (middle - place), d) for (side, d), place in pairs], order)
    assert star.couple(order) == pytest.approx(couple, abs=2e-3)


def test_engines_in_banks_and_parts_name_no_crank():
    for words in ("A V-twin here", "the four forces", "two cylinders", "a 90° V8", "the three pistons"):
        assert not EnginesInWords(words).mentions
