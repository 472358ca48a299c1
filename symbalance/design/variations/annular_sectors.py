r"""The largest modulus of a sum of complex numbers that are each free within an annular sector.

A sector is {w e^(i x): low <= w <= high, |x - angle| <= half}; the weights may be negative. The largest
modulus of a sum over independent choices is the largest value of its support function

    H(phi) = sum of h_j(phi),     h_j(phi) = max over sector j of Re e^(-i phi) z,

for max |z| = max over z and phi of Re e^(-i phi) z, and the order of maxima is free. Each h_j is
piecewise: a corner's Re e^(-i phi) p, or the radius of an arc that phi looks along. So H is, between
breakpoints known beforehand, Re e^(-i phi) Z + const, whose maximum is closed: O(N) pieces of O(1) each,
exact but for the rounding of floats. With half = 0 the set is a zonotope, and these are its vertices.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from itertools import combinations
from math import acos, cos, hypot, pi, remainder, sin, tau
from typing import NamedTuple

TIE = 1e-12
"""Breakpoints this near, in radians, count as one: what that misses is `TIE` of the sum's size."""

CARRIED = 1e-10
"""Part of the sectors' size that rounding in a sum carried along never reaches: 10^5 steps of 1e-16."""
MOST_CANDIDATES = 256
"""Pieces summed anew at most: where sectors are spread evenly all pieces are equally high."""


class AnnularSector(NamedTuple):
    """An annular sector: weights from `low` to `high`, at angles within `half` of `angle`, radians."""

    low: float
    high: float
    angle: float
    half: float = 0.0


class Maximum(NamedTuple):
    """A maximum and the angle at which it is."""

    value: float
    angle: float


Element = tuple[complex, float]
"""What a support function is near a place: Re e^(-i phi) z + constant."""


def support(sector: AnnularSector, phi: float) -> float:
    """Return h(phi), the largest Re e^(-i phi) z in a sector.

    >>> support(AnnularSector(1, 2, 0.0), 0.0), support(AnnularSector(1, 2, 0.0), pi)
    (2.0, -1.0)
    """
    z, constant = _element(sector, phi)
    return (cmath.rect(1, -phi) * z).real + constant


def _element(sector: AnnularSector, phi: float) -> Element:
    best: Element = (0j, 0.0)
    most = -float("inf")
    away = remainder(phi - sector.angle, tau)
    for weight in (sector.low, sector.high):
        gap = away if weight >= 0 else remainder(away + pi, tau)
        if sector.half and abs(gap) <= sector.half and abs(weight) > most:
            best, most = (0j, abs(weight)), abs(weight)
        for side in (sector.half, -sector.half) if sector.half else (0.0,):
            value = weight * cos(away - side)
            if value > most:
                best, most = (weight * cmath.rect(1, sector.angle + side), 0.0), value
    return best


def _breakpoints(sector: AnnularSector) -> list[float]:
    """Return the angles, in [0, 2 pi), at which the active element may change."""
    sides = (sector.half, -sector.half) if sector.half else (0.0,)
    corners = [w * cmath.rect(1, sector.angle + s) for w in (sector.low, sector.high) for s in sides]
    angles = [sector.angle + s + half for s in sides for half in (0.0, pi) if sector.half]
    for p, q in combinations(corners, 2):
        if p != q:
            normal = cmath.phase(1j * (p - q))
            angles += [normal, normal + pi]
    radii = {abs(sector.low), abs(sector.high)} if sector.half else set()
    for p in corners:  # a corner of the larger arc gives way to the smaller one
        angles += [cmath.phase(p) + s * acos(r / abs(p)) for r in radii if r < abs(p) for s in (1, -1)]
    return [x % tau for x in angles]


def largest_sum(sectors: Sequence[AnnularSector]) -> Maximum:
    """Return the largest modulus of the sum, and the argument of the sum there.

    >>> largest_sum([AnnularSector(0.9, 1.1, 0.0), AnnularSector(0.9, 1.1, pi)]).value.__round__(12)
    0.2
    """
    events = sorted((x, j) for j, sector in enumerate(sectors) for x in _breakpoints(sector))
    if not events:  # single points
        z = sum(_element(sector, 0.0)[0] for sector in sectors)
        return Maximum(abs(z), cmath.phase(z))
    clusters = _clusters(events)
    starts = [x for x, _ in clusters]
    middle = (starts[-1] - tau + starts[0]) / 2
    first = [_element(sector, middle) for sector in sectors]
    ends = [*starts[1:], starts[0] + tau]
    changes = [
        [(j, _element(sectors[j], (start + end) / 2)) for j in changed]
        for (start, changed), end in zip(clusters, ends, strict=True)
    ]
    best = Maximum(0.0, 0.0)
    active, candidates = list(first), _candidates(sectors, first, changes, starts, ends)
    for i, (start, end) in enumerate(zip(starts, ends, strict=True)):
        for j, element in changes[i]:
            active[j] = element
        if i in candidates:
            best = max(best, _largest_on(*_sums(active), start, end))
    return best


def _candidates(
    sectors: Sequence[AnnularSector],
    first: Sequence[Element],
    changes: Sequence[Sequence[tuple[int, Element]]],
    starts: Sequence[float],
    ends: Sequence[float],
) -> set[int]:
    """Return the pieces that may hold the largest value, by sums carried along from piece to piece.

    A sum anew for each piece would cost the square of the sectors. What is carried along gathers
    rounding, far less than `CARRIED`, so that the pieces returned are to be summed anew. Of more than
    `MOST_CANDIDATES` those that lie highest are returned: they differ by rounding alone.
    """
    active, (z, constant), values = list(first), _sums(first), []
    for start, end, changed in zip(starts, ends, changes, strict=True):
        for j, element in changed:
            before, active[j] = active[j], element
            z, constant = z + (element[0] - before[0]), constant + (element[1] - before[1])
        values.append(_largest_on(z, constant, start, end).value)
    size = sum(max(abs(sector.low), abs(sector.high)) for sector in sectors)
    least = max(values) - CARRIED * size
    high = [i for i, value in enumerate(values) if value >= least]
    return set(sorted(high, key=lambda i: -values[i])[:MOST_CANDIDATES])


def _clusters(events: Sequence[tuple[float, int]]) -> list[tuple[float, list[int]]]:
    """Return the breakpoints with the sectors that change there; those `TIE` are one."""
    clusters: list[tuple[float, list[int]]] = []
    for x, j in events:
        if clusters and x - clusters[-1][0] <= TIE:
            clusters[-1][1].append(j)
        else:
            clusters.append((x, [j]))
    return clusters


def _sums(active: Sequence[Element]) -> Element:
    """Return the sum of the sectors' elements."""
    return sum(e[0] for e in active), sum(e[1] for e in active)


def _largest_on(z: complex, constant: float, start: float, end: float) -> Maximum:
    """Return the largest value on one piece, of which the sum of all sectors' elements is known."""
    at = cmath.phase(z) if z else start
    if (at - start) % tau <= end - start:
        return Maximum(abs(z) + constant, at)
    values = [(z * cmath.rect(1, -x)).real + constant for x in (start, end)]
    return Maximum(values[0], start) if values[0] >= values[1] else Maximum(values[1], end)


class BoundedMaximum(NamedTuple):
    """A maximum, between a value that is attained and one that is proved; `angle` is where."""

    attained: float
    bound: float
    angle: float


STEPS = 16
"""Intervals of half a turn to begin with: each below pi/2, as `_meeting` needs."""
MOST_HALVINGS = 400
"""Where they do not do, the bound is still proved, and looser than `gap`."""


def farthest_point(width: Callable[[float], float], gap: float = 1e-9) -> BoundedMaximum:
    r"""Return the largest modulus of a set symmetric about 0, from its support function `width`.

    If the farthest point's direction lies in [u, v], its modulus d obeys d cos(x - u) <= width(u) and d
    cos(v - x) <= width(v): d is at most the distance of the point where both lines meet (or the end
    nearer to it). That bound is second order in v - u; intervals are halved until it is within `gap`.

    >>> farthest_point(lambda u: abs(3 * cos(u)) + abs(4 * sin(u))).bound.__round__(6)
    5.0
    """
    grid = [pi * i / STEPS for i in range(STEPS + 1)]
    values = [width(u) for u in grid[:-1]]
    values.append(values[0])
    best = max(zip(values, grid, strict=True))
    intervals = [
        (_meeting(a, b, v - u), u, v, a, b)
        for u, v, a, b in zip(grid[:-1], grid[1:], values[:-1], values[1:], strict=True)
    ]
    for _ in range(MOST_HALVINGS):
        top = max(intervals)
        if top[0] <= best[0] * (1 + gap):
            break
        intervals.remove(top)
        _, u, v, a, b = top
        middle = (u + v) / 2
        value = width(middle)
        best = max(best, (value, middle))
        intervals += [
            (_meeting(a, value, middle - u), u, middle, a, value),
            (_meeting(value, b, v - middle), middle, v, value, b),
        ]
    return BoundedMaximum(best[0], max(best[0], max(intervals)[0]), best[1])


def _meeting(a: float, b: float, between: float) -> float:
    """Return a bound on d where d cos x <= a and d cos(between - x) <= b, 0 <= x <= between < pi/2."""
    if not (a or b):
        return 0.0
    if b * cos(between) > a:
        a, b = b, a
    if a * cos(between) > b:  # the second line cuts before it meets the first inside the cone
        return b / cos(between)
    return hypot(a, (b - a * cos(between)) / sin(between))
