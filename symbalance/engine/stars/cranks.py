"""The cranks an in-line engine may have: which cylinder stands on which ray of an even star.

An evenly firing in-line engine of N cylinders has its pins on M evenly spaced rays: M = N, one cylinder
a ray; M = N/2, two cylinders a ray, in a four-stroke of even N. Two such stars differ in nothing that
matters if one is the other turned, mirrored (the other sense of rotation) or seen from the rear. These
make a group of 4M elements; its orbits are the classes. Every orbit meets the stars with cylinder 1 on
ray 0 in 1, 2 or 4 of them, and those are what is counted.

Rays are counted as they pass: a cylinder on ray s reaches top dead centre s/M of a turn after cylinder
1, its throw is -s/M. Cylinder j at station ((N-1)/2 - j), j = 0..N-1: the couple of order n has the
amplitude

    |sum of ((N-1)/2 - j) zeta^(n s_j)|,   zeta = e^(2 pi i/M),   unit F_n a.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from math import factorial, floor
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import SequenceResult
from symbalance.engine.builders import inline
from symbalance.engine.cylinders import MOST_CYLINDERS
from symbalance.engine.engine import Engine, checked_strokes
from symbalance.engine.stars.firings import Firing, firing_orders
from symbalance.errors import SymbalanceError
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import Component
from symbalance.text.numbers import checked_whole
from symbalance.text.reals import cospi, ldexp

if TYPE_CHECKING:
    import sympy

    from symbalance.document.nodes import Document

MOST_STARS = 50_000
"""More stars are not enumerated: nine cylinders on nine rays are 40320, ten in pairs 22680."""

Star = tuple[int, ...]
"""The ray of each cylinder, front to rear; the first stands on ray 0."""


@dataclass(frozen=True)
class StarClass:
    """A crank of evenly spaced rays, and the `stars` that are the same but for turning and mirroring.

    `rays` holds the ray of each cylinder, front to rear, out of `directions`: the first star of the
    class in the order of tuples. `stars` counts those of the class with cylinder 1 on ray 0.

    >>> flat = crank_stars(4)[0]
    >>> flat.rays, [int(throw) for throw in flat.throws], flat.stars
    ((0, 1, 1, 0), [0, 180, 180, 0], 1)
    >>> [firing.as_text() for firing in flat.firings]
    ['1-2-4-3', '1-3-4-2']
    """

    rays: Star
    directions: int
    stars: int
    strokes: int

    @property
    def throws(self) -> tuple[Fraction, ...]:
        """The throws, front to rear, in degrees."""
        return tuple(Fraction(-360 * ray, self.directions) % 360 for ray in self.rays)

    @cached_property
    def engine(self) -> Engine:
        """The in-line engine on this crank."""
        return inline(throws=self.throws, strokes=self.strokes)

    @cached_property
    def firings(self) -> tuple[Firing, ...]:
        """The even firing orders: one for odd N and two-strokes, 2^(N/2 - 1) for pairs."""
        return tuple(firing_orders(self.engine))

    @cached_property
    def first_couple(self) -> sympy.Expr:
        """The exact amplitude of the first-order couple, unit F_1 a."""
        return self._couple(1).amplitude

    @cached_property
    def second_couple(self) -> sympy.Expr:
        """The exact amplitude of the second-order couple, unit F_2 a."""
        return self._couple(2).amplitude

    def _couple(self, order: int) -> Component:
        terms: dict[int, Fraction] = {}
        for place, ray in enumerate(self.rays):
            ray_of_order = -order * ray % self.directions
            station = Fraction(len(self.rays) - 1, 2) - place
            terms[ray_of_order] = terms.get(ray_of_order, Fraction(0)) + station
        return Component(Phasor.of(self.directions, terms))


@dataclass(frozen=True, repr=False, eq=False)
class CrankStars(SequenceResult[StarClass]):
    """All cranks of an evenly firing in-line engine of so many `cylinders`, smoothest first."""

    cylinders: int
    strokes: int
    items: tuple[StarClass, ...]
    kind: ClassVar[str] = "crank-stars"

    def summary(self) -> str:
        """Return how many cranks there are, in one line."""
        return f"Cranks of an evenly firing in-line {self.cylinders}, {self.strokes}-stroke: {len(self)}"

    def document(self) -> Document:
        """Return a table of the cranks, with couples and firing orders."""
        from symbalance.engine.stars.stars_document import crank_stars_document

        return crank_stars_document(self)

    def data(self) -> dict[str, Any]:
        """Return every crank; angles in degrees, couples exact in F_n a."""
        return {
            "cylinders": self.cylinders,
            "strokes": self.strokes,
            "cranks": [_data(star) for star in self],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each crank."""
        return [
            {
                "throws_degrees": " ".join(map(str, star.throws)),
                "first_couple": float(star.first_couple),
                "second_couple": float(star.second_couple),
                "stars": star.stars,
                "firing_orders": " ".join(firing.as_text() for firing in star.firings),
            }
            for star in self
        ]


def _data(star: StarClass) -> dict[str, Any]:
    return {
        "throws": [str(throw) for throw in star.throws],
        "rays": list(star.rays),
        "directions": star.directions,
        "stars": star.stars,
        "first_couple": str(star.first_couple),
        "second_couple": str(star.second_couple),
        "firing_orders": [list(firing.order) for firing in star.firings],
    }


def crank_stars(count: int, strokes: int = 4) -> CrankStars:
    """Return all cranks of an evenly firing in-line engine, up to turning and mirroring, smoothest first.

    Sorted by first-order couple, then second (both exact). Odd counts and two-strokes have one cylinder
    on each of N rays, four-strokes with an even count two on each of N/2.
    Refused: more than `MOST_STARS` stars (in four-strokes N = 11, in two-strokes N = 10).

    >>> fives = crank_stars(5)
    >>> len(fives), sum(c.stars for c in fives)
    (8, 24)
    >>> fives[0].first_couple, fives[0].second_couple, fives[0].firings[0].as_text()
    (sqrt(25/2 - 11*sqrt(5)/2), sqrt(11*sqrt(5)/2 + 25/2), '1-2-4-5-3')
    """
    checked_strokes(strokes)
    count = checked_whole(count, "count", 1, MOST_CYLINDERS, "cylinders in a row")
    each = 2 if strokes == 4 and count % 2 == 0 else 1
    rays = count // each
    _check_size(count, each)
    classes = []
    for star in _stars([each] * rays, count):
        orbit = _orbit(star, rays)
        if star == min(orbit):
            classes.append(StarClass(star, rays, len(orbit), strokes))
    return CrankStars(count, strokes, tuple(sorted(classes, key=_smoothness)))


def _check_size(count: int, each: int) -> None:
    if count > 20 or factorial(count) // each ** (count // each) * each // count > MOST_STARS:
        raise SymbalanceError(
            f"count = {count}",
            f"makes more than {MOST_STARS} stars",
            "ask for up to 9 cylinders, or 10 of a four-stroke",
        )


def _stars(free: list[int], count: int, star: Star = (0,)) -> Iterator[Star]:
    """Yield the stars that begin like `star`, in the order of tuples; `free` are the places left."""
    if len(star) == 1:
        free = [free[0] - 1, *free[1:]]
    if len(star) == count:
        yield star
        return
    for ray, places in enumerate(free):
        if places:
            yield from _stars([*free[:ray], places - 1, *free[ray + 1 :]], count, (*star, ray))


def _orbit(star: Star, rays: int) -> set[Star]:
    """Return this star turned, mirrored and seen from behind, each with cylinder 1 on ray 0."""
    behind = tuple((ray - star[-1]) % rays for ray in reversed(star))
    return {mirrored for view in (star, behind) for mirrored in (view, tuple(-r % rays for r in view))}


def _correlation(star: Star, rays: int) -> tuple[int, ...]:
    """Return R_k, the sum over rays d of W_d W_(d+k), with W_d twice the stations on ray d."""
    weights = [0] * rays
    for place, ray in enumerate(star):
        weights[ray] += len(star) - 1 - 2 * place
    return tuple(sum(w * weights[(d + k) % rays] for d, w in enumerate(weights)) for k in range(rays))


def _square(correlation: tuple[int, ...], order: int) -> Phasor:
    """Return four times the square of the couple's amplitude: the sum of R_k zeta^(n k)."""
    terms: dict[int, int] = {}
    for k, value in enumerate(correlation):
        place = order * k % len(correlation)
        terms[place] = terms.get(place, 0) + value
    return Phasor.of(len(correlation), terms)


def _smoothness(star_class: StarClass) -> tuple[int, int, Star]:
    correlation = _correlation(star_class.rays, star_class.directions)
    return _size(correlation, 1), _size(correlation, 2), star_class.rays


def _size(correlation: tuple[int, ...], order: int) -> int:
    """Return what sorts squares of amplitudes exactly: four times the square, in units of 2^-128.

    Equal numbers have the same normal form, so the same integer. Different ones: up to ten cylinders
    their difference is an algebraic integer of degree at most 3, below 10^4 in every conjugate; its
    norm is a whole number, so it is at least 10^-8, far above the rounding.
    """
    cosines = _cosines(len(correlation))
    return sum(int(c) * cosines[k] for k, c in _square(correlation, order).normal.items())


@cache
def _cosines(rays: int) -> tuple[int, ...]:
    """Return cos(2 pi k/M) in units of 2^-128."""
    cosines = (cospi(Fraction(2 * k, rays), 50) for k in range(rays))
    return tuple(floor(ldexp(cosine, 128)) for cosine in cosines)
