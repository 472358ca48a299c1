"""Evidence: a search's counts, fronts and values against brute force written out here, in other numbers.

Brute force: every arrangement by itertools, sums of complex floats, mirror images and views from the rear
as sets. It shares nothing with the walk: no bounds, no symmetry, no integers, no order of pins.
"""

from __future__ import annotations

import cmath
import json
import math
import subprocess
import sys
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import permutations, product
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.errors import SymbalanceError
from symbalance.search import search_certificate, search_cranks
from symbalance.search.magnitudes import Magnitude, compare
from symbalance.search.star_walk import compiled_walk
from tests import ROOT
from tests.effort import effort

Star = tuple[int, ...]
NEAR = 1e-9
COMPILED = [False, pytest.param(True, marks=pytest.mark.slow)]
"""Numba takes seconds to load."""


def cranks(count: int, strokes: int) -> set[Star]:
    """Every star of an in-line engine with cylinder 1 on ray 0, by permutation of the firings."""
    rays = count if strokes == 2 or count % 2 else count // 2
    return {(0, *(place % rays for place in rest)) for rest in permutations(range(1, count))}


def rays_of(count: int, strokes: int) -> int:
    return count if strokes == 2 or count % 2 else count // 2


def mirrored(star: Star, rays: int) -> Star:
    return tuple(-s % rays for s in star)


def from_the_rear(star: Star, rays: int) -> Star:
    return tuple((star[-1] - s) % rays for s in reversed(star))


def orbits(stars: Iterable[Star], images) -> int:
    """How many sets of stars that are images of one another there are."""
    left, count = set(stars), 0
    while left:
        count += 1
        pending = [left.pop()]
        while pending:
            for image in images(pending.pop()):
                if image in left:
                    left.remove(image)
                    pending.append(image)
    return count


def couple(star: Star, rays: int, order: int) -> float:
    middle = (len(star) - 1) / 2
    turn = 2j * math.pi * order / rays
    return abs(sum((middle - j) * cmath.exp(turn * s) for j, s in enumerate(star)))


def counts(stars: set[Star], rays: int) -> tuple[int, int, int]:
    return (
        len(stars),
        orbits(stars, lambda s: [mirrored(s, rays)]),
        orbits(stars, lambda s: [mirrored(s, rays), from_the_rear(s, rays)]),
    )


def three(result) -> tuple[int, int, int]:
    return result.cranks, result.stars, result.classes


@pytest.mark.spread(12)
@pytest.mark.parametrize("compiled", COMPILED)
@pytest.mark.parametrize(("count", "strokes"), [(n, s) for n in range(1, 8) for s in (2, 4)])
def test_counts_are_those_of_brute_force(count: int, strokes: int, compiled: bool) -> None:
    stars, rays = cranks(count, strokes), rays_of(count, strokes)
    result = search_cranks(count, strokes=strokes, compiled=compiled)
    assert three(result.searched) == three(result.found) == counts(stars, rays)
    for order, limit in ((1, Fraction(1)), (2, Fraction(3, 2))):
        met = {s for s in stars if couple(s, rays, order) <= limit + Fraction(1, 10**9)}
        some = search_cranks(
            count, strokes=strokes, limit=[f"couple.{order}<={limit}"], compiled=compiled
        )
        assert three(some.found) == counts(met, rays)
        zero = {s for s in stars if couple(s, rays, order) < NEAR}
        none = search_cranks(count, strokes=strokes, require=[f"couple.{order}=0"], compiled=compiled)
        assert three(none.found) == counts(zero, rays)


@pytest.mark.slow
@pytest.mark.parametrize(("count", "strokes"), [(8, 2), (8, 4), (9, 2), (9, 4)])
def test_counts_of_eight_and_nine(count: int, strokes: int) -> None:
    stars, rays = cranks(count, strokes), rays_of(count, strokes)
    result = search_cranks(count, strokes=strokes, limit=["couple.1<=2", "couple.2<=3"])
    met = {s for s in stars if couple(s, rays, 1) <= 2 + NEAR and couple(s, rays, 2) <= 3 + NEAR}
    assert three(result.searched) == counts(stars, rays)
    assert three(result.found) == counts(met, rays)


def front_of(values: set[tuple[float, ...]]) -> list[tuple[float, ...]]:
    """The values that no others beat, rounded so that equal ones are one."""

    def beats(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
        return a != b and all(x <= y for x, y in zip(a, b, strict=True))

    return sorted(v for v in values if not any(beats(other, v) for other in values))


@pytest.mark.parametrize("compiled", COMPILED)
@pytest.mark.parametrize(
    ("count", "strokes", "orders"), [(5, 4, (1, 2)), (6, 2, (1, 2, 3)), (7, 2, (1, 2))]
)
def test_the_front_is_that_of_brute_force(
    count: int, strokes: int, orders: tuple[int, ...], compiled: bool
) -> None:
    rays = rays_of(count, strokes)
    by_values: dict[tuple[float, ...], set[Star]] = {}
    for star in cranks(count, strokes):
        values = tuple(round(couple(star, rays, n), 8) + 0.0 for n in orders)
        by_values.setdefault(values, set()).add(star)
    names = [f"couple.{n}" for n in orders]
    result = search_cranks(count, strokes=strokes, minimize=names, compiled=compiled)
    expected = front_of(set(by_values))
    points = [tuple(float(p.stars[0].values[n].near) for n in names) for p in result.points]
    assert [tuple(round(x, 8) + 0.0 for x in p) for p in points] == expected
    for point, values in zip(result.points, expected, strict=True):
        assert three(point.counts) == counts(by_values[values], rays)


def test_couples_are_those_of_the_engine_built() -> None:
    """The exact values of the search against `balance` of the engine that it hands over."""
    questions = (
        {"cylinders": 6, "strokes": 2},
        {"cylinders": 8, "banks": [-45, 45]},
        {"cylinders": 6, "banks": [-30, 30], "pins": "offset"},
        {"cylinders": 4, "banks": [-90, 90], "pins": "split"},
        {"cylinders": 6, "banks": [-40, 0, 40], "intervals": "any", "grid": 90},
    )
    for question in questions:
        names = ["couple.1", "couple.2", "force.1", "force.2"]
        result = search_cranks(**question, minimize=names)
        for star in result.items[:3]:
            free = sb.balance(star.engine, 2)
            for order in (1, 2):
                for kind, spectrum in (("force", free.force), ("couple", free.couple)):
                    parts = [spectrum.terms[n].size(30) for n in (order, -order) if n in spectrum.terms]
                    near = float(sum(parts, 0 * star.values["couple.1"].near))
                    assert float(star.values[f"{kind}.{order}"].near) == pytest.approx(near, abs=1e-12)


def test_firing_orders_of_the_stars_are_those_their_cranks_allow() -> None:
    result = search_cranks(6, minimize=["couple.1"])
    for star in result:
        orders = sb.engine.firing_orders(star.engine)
        assert star.firing_order in [firing.order for firing in orders]
        assert star.firings == len(orders)
    assert result.firings == 15 * 4


def test_vees_of_two_and_four_pairs() -> None:
    """Pins on rays such that the pairs' top dead centres, a bank angle apart, come evenly."""
    for count, bank, strokes in ((4, 90, 2), (4, 180, 4), (8, 90, 4), (8, 45, 2), (8, 180, 4)):
        pins, rays = count // 2, rays_of(count, strokes)
        lag = bank * rays // 360
        each = count // rays
        stars = set()
        for rest in product(range(rays), repeat=pins - 1):
            star = (0, *rest)
            moments = [*star, *((s + lag) % rays for s in star)]
            if all(moments.count(m) == each for m in range(rays)):
                stars.add(star)
        result = search_cranks(count, strokes=strokes, banks=[-Fraction(bank, 2), Fraction(bank, 2)])
        assert three(result.searched) == three(result.found) == counts(stars, rays), (count, bank)


def test_the_inline_five_and_twelve() -> None:
    five = search_cranks(5, minimize=["couple.1"])
    assert three(five.searched) == (24, 12, 8)
    assert [s.firing_order for s in five] == [(1, 2, 4, 5, 3)]
    assert five[0].values["couple.1"].spelling == "sqrt(25/2 - 11*sqrt(5)/2)"


@pytest.mark.slow
def test_an_inline_twelve_has_19_958_400_stars() -> None:
    twelve = search_cranks(12, strokes=2, require=["couple.1=0", "couple.2=0"])
    assert twelve.searched.stars == 19_958_400
    assert 0 < twelve.found.stars < 100
    for star in twelve:
        orders = sb.balance(star.engine, 2).orders
        assert not orders, star.firing_order


def test_none_of_them_is_an_answer() -> None:
    result = search_cranks(5, require=["couple.1=0"])
    assert result.found.stars == 0
    assert not result.points
    assert "none of 12 stars, proved" in result.summary()
    assert "None of 12 stars meets this: proved." in sb.to_text(result)


def brute_firings(count: int) -> Iterator[tuple[int, ...]]:
    for rest in permutations(range(2, count + 1)):
        yield (1, *rest)


def test_firing_objectives_against_every_firing_order() -> None:
    """Neighbours in succession and half orders of torsion, over all firing orders of a six."""
    mode = [Fraction(k, 10) for k in (10, 9, 7, 4, 1, -2)]
    best: set[tuple[float, float]] = set()
    for order in brute_firings(6):
        neighbours = sum(abs(a - b) == 1 for a, b in zip(order, (*order[1:], order[0]), strict=True))
        at = {number: 2 * math.pi * 2 * k / 6 for k, number in enumerate(order)}
        size = abs(sum(float(mode[n - 1]) * cmath.exp(1.5j * at[n]) for n in at))
        best.add((float(neighbours), round(size, 8)))
    result = search_cranks(6, minimize=["adjacent", "torsion.1.5"], modes=[mode])
    points = [
        tuple(float(p.stars[0].values[n].near) for n in ("adjacent", "torsion.1.5"))
        for p in result.points
    ]
    assert [(a, round(b, 8)) for a, b in points] == front_of(best)  # type: ignore[comparison-overlap]


def test_evenness_of_a_crank_on_a_grid() -> None:
    """A vee of 90 degrees on three shared pins: no order is even, and the best are 90-150 or better."""
    result = search_cranks(6, banks=[-45, 45], intervals="any", grid=120, minimize=["evenness"])
    engine = result[0].engine
    gaps = sb.engine.firing_orders(engine, even_only=False)
    least = min(max(f.intervals) - min(f.intervals) for f in gaps)
    assert float(result[0].values["evenness"].near) == float(least)


def test_magnitudes_are_compared_exactly() -> None:
    from symbalance.exact.phasor import Phasor

    def root(n: int) -> Phasor:
        return Phasor.of(1, {0: n})

    # sqrt 2 + sqrt 8 = sqrt 18; (sqrt 3 + sqrt 12)^2 = 27; 1 + sqrt 9 = sqrt 16
    for a, b, c in ((2, 8, 18), (3, 12, 27), (1, 9, 16)):
        assert compare(Magnitude(root(a), root(b)), Magnitude(root(c))) == 0
        assert compare(Magnitude(root(a), root(b)), Magnitude(root(c + 1))) == -1
    near = Fraction(2**70 + 1, 2**70)
    assert compare(Magnitude(root(2)), Magnitude(root(2).scaled(near))) == -1


def test_bounds_spare_the_walk() -> None:
    free = effort(lambda: search_cranks(7, strokes=2, compiled=False))
    cut = effort(lambda: search_cranks(7, strokes=2, require=["couple.1=0"], compiled=False))
    assert cut < free
    bound = search_cranks(8, strokes=2, require=["couple.1=0"], compiled=False)
    every = search_cranks(8, strokes=2, compiled=False)
    assert bound.tally.nodes < every.tally.nodes / 3
    assert sum(bound.tally.cuts) > 0


@pytest.mark.slow
def test_both_walks_pass_the_same_nodes() -> None:
    if compiled_walk() is None:
        pytest.skip("Numba is not installed")
    for question in (
        {"cylinders": 8, "strokes": 2, "limit": ["couple.1<=1"]},
        {"cylinders": 8, "banks": [-45, 45], "pins": "split", "limit": ["couple.1<=1"]},
        {"cylinders": 9, "minimize": ["couple.1", "bending"], "limit": ["couple.2<=2"]},
    ):
        fast, plain = (search_cranks(**question, compiled=c) for c in (True, False))
        assert fast.data() == plain.data()


@pytest.mark.parametrize(
    ("question", "line"),
    [
        ({"cylinders": 5, "require": ["couple.1"]}, "must have the form NAME=VALUE"),
        ({"cylinders": 5, "require": ["weight.1=0"]}, "is none of force.N"),
        ({"cylinders": 5, "limit": ["couple.1<=-1"]}, "no size is negative"),
        ({"cylinders": 5, "minimize": ["couple"]}, "needs an order|is none of"),
        ({"cylinders": 5, "strokes": 2, "minimize": ["torsion.1.5"]}, "half orders"),
        ({"cylinders": 5, "banks": [-45, 45]}, "multiple of the 2 banks"),
        ({"cylinders": 6, "banks": [-45, 45]}, "cannot fire so on shared pins"),
        ({"cylinders": 5, "intervals": "any"}, "needs a grid"),
        ({"cylinders": 5, "intervals": "100,200"}, "must be 5 degrees above 0"),
        ({"cylinders": 25}, "from 1 to 24"),
        ({"cylinders": 5, "grid": 7}, "must divide 360"),
        ({"cylinders": 5, "modes": [[1, 2]]}, "must have 5"),
        ({"cylinders": 5, "after": "glue"}, "counterweights, or balance-shafts"),
        ({"cylinders": 5, "stations": [1, 2, 3]}, "must be 5 places"),
        ({"cylinders": 24, "strokes": 2}, "some [0-9,]+ years of one core, and nothing asked can cut"),
        ({"cylinders": 20, "strokes": 2, "minimize": ["adjacent"]}, "take fewer cylinders, or --limit"),
    ],
)
def test_a_bad_question_is_refused_in_one_line(question, line) -> None:
    with pytest.raises(SymbalanceError, match=line) as refusal:
        search_cranks(**question)
    assert "\n" not in str(refusal.value)


def checked(path: Path) -> subprocess.CompletedProcess[str]:
    """Run the checker alone: no library is there for it to import."""
    script = ROOT / "symbalance" / "search" / "certificate_check.py"
    command = [sys.executable, "-I", "-S", str(script), str(path)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@pytest.mark.slow
@pytest.mark.parametrize(
    "question",
    [
        {"cylinders": 7, "strokes": 2, "require": ["couple.1=0"]},
        {"cylinders": 8, "banks": [-45, 45], "pins": "split", "limit": ["couple.1<=1", "couple.2<=4"]},
        {"cylinders": 6, "require": ["couple.1=0"], "limit": ["bending<=3/2"]},
        {"cylinders": 8, "banks": [-45, 45], "require": ["couple.1=2"]},
        {"cylinders": 6, "banks": [-45, 45], "intervals": "150,90", "limit": ["couple.1<=9"]},
        {"cylinders": 5, "intervals": "any", "grid": 90, "require": ["couple.1=0", "force.1=0"]},
        {"cylinders": 9, "grid": 40, "limit": ["couple.1<=1/2"]},
    ],
)
def test_a_certificate_is_verified_and_a_wrong_one_is_not(tmp_path, question) -> None:
    text = search_certificate(**question)
    path = tmp_path / "proof.json"
    path.write_text(text, encoding="utf-8")
    outcome = checked(path)
    result = search_cranks(**question)
    count = f"{result.found.classes} classes" if result.found.classes else "none"
    assert outcome.returncode == 0, outcome.stderr
    assert f": {count} with " in outcome.stdout
    data = json.loads(text)
    letters = data["walks"][0]["letters"]
    wrong = {letter: letters.find(letter) for letter in "xcifs" if letter in letters[1:]}
    for letter, place in wrong.items():
        for other in "cifs":
            if other != letter and {letter, other} != {"c", "f"}:
                if (letter in "cf" and other == "i") or (letter == "i" and other in "cf"):
                    continue  # both reasons may hold
                data["walks"][0]["letters"] = letters[:place] + other + letters[place + 1 :]
                path.write_text(json.dumps(data), encoding="utf-8")
                assert checked(path).returncode == 1, (letter, other)
    data["walks"][0]["letters"] = letters
    data["symmetries"] = [[list(range(len(data["order"]))), 1, [0, *[1] * (len(data["order"]) - 1)]]]
    path.write_text(json.dumps(data), encoding="utf-8")
    assert checked(path).returncode == 1


MARINE = {
    "man-5s50mc-c": "again",
    "man-6s50mc-c": "again",
    "man-7s50mc-c": "again",
    "man-8s50mc-c": "bettered",
    "man-9s50mc-c": "bettered",
    "wartsila-10rta96c": "bettered",
    "wartsila-11rta96c": "again",
    "wartsila-12rta96c": "again",
}
"""Whether the couples of the firing order that the maker publishes are on the front, or beaten by it."""


@pytest.mark.slow
@pytest.mark.parametrize("name", MARINE)
def test_published_firing_orders_of_marine_engines_are_on_the_front_or_bettered(name: str) -> None:
    engine = sb.load(name)
    couple = sb.balance(engine, 2).couple
    own = [sum(float(couple.terms[k].size(30)) for k in (n, -n) if k in couple.terms) for n in (1, 2)]
    result = search_cranks(len(engine.cylinders), strokes=2, minimize=["couple.1", "couple.2"])
    points = [[float(p.stars[0].values[f"couple.{n}"].near) for n in (1, 2)] for p in result.points]
    again = any(point == pytest.approx(own, abs=1e-9) for point in points)
    better = any(all(x <= y + NEAR for x, y in zip(point, own, strict=True)) for point in points)
    assert better
    assert again == (MARINE[name] == "again")
