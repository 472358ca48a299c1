"""The walk over stars pin by pin, with bounds: a loop that Numba compiles, and that runs without it.

A star grows by one pin at a time, in the tables' order, lexicographically. A branch ends where a
moment is taken already; where some sum with a limit can no longer come below it, whatever the rest
(branch and bound); or where an image of the star under a symmetry comes before it, so that of every
class the first star alone is walked to its end. Nothing is kept but the path to the present star: the
caller takes the stars from a buffer and calls again, and the memory is the same for any number.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

FINISHED, BUFFER_FULL, PAUSED = 0, 1, 2
NODES, LEAVES, CRANKS, STARS, CLASSES, FIRST_CUT = 0, 1, 2, 3, 4, 5
"""Places among the counters; from the last on, one for each objective: the branches that it cut."""


def walk_stars(  # noqa: PLR0912, PLR0915 - one loop, as Numba compiles it best
    rays: int,
    order: Any,
    takes: Any,
    plain: bool,
    allowed: Any,
    floats: Any,
    integers: Any,
    rest: Any,
    reach: Any,
    slack: Any,
    groups: Any,
    owners: Any,
    asked: Any,
    limits: Any,
    minimized: Any,
    front: Any,
    front_size: int,
    count_only: bool,
    sources: Any,
    signs: Any,
    shifts: Any,
    mirror: Any,
    base: int,
    state: Any,
    capacity: Any,
    star: Any,
    placed: Any,
    current: Any,
    candidates: Any,
    partial: Any,
    tied: Any,
    values: Any,
    sizes: Any,
    is_zero: Any,
    buffer: Any,
    weights: Any,
    counters: Any,
    most_nodes: int,
) -> int:
    """Go on with a walk until it ends, the buffer is full, or so many nodes are passed.

    `reach` holds, for a group of one sum, the square beyond which nothing brings it back, by depth.
    `state` holds the depth and the rows in the buffer. Stars that meet every condition for certain and
    are worse, for certain, than some point of the front are counted and no more; of the others the
    buffer gets the rays, and `weights` the cranks and stars of the class and whether a condition is in
    doubt.
    """
    pins, forms = len(order), floats.shape[0]
    symmetries, objectives, cylinders = len(signs), len(asked), takes.shape[2]
    depth, rows = state[0], state[1]
    until = counters[NODES] + most_nodes
    worst = state[2]
    free = 0  # the ticks that can be taken, as bits
    for t in range(len(capacity)):
        if capacity[t] > 0:
            free |= 1 << t
    while depth >= base:
        pin = order[depth]
        ray = current[depth]
        if ray >= 0:  # take the pin off the ray where it stands
            for c in range(cylinders):
                tick = takes[pin, ray, c]
                capacity[tick] += 1
                free |= 1 << tick
            placed[pin] = 0
        else:
            if plain:
                mask = free & allowed[pin]
            else:
                mask = 0
                for s in range(rays):
                    if takes[pin, s, 0] < 0:
                        continue
                    fits = True
                    for c in range(cylinders):
                        capacity[takes[pin, s, c]] -= 1
                    for c in range(cylinders):
                        if capacity[takes[pin, s, c]] < 0:
                            fits = False
                    for c in range(cylinders):
                        capacity[takes[pin, s, c]] += 1
                    if fits:
                        mask |= 1 << s
            candidates[depth] = mask
        ray += 1
        mask = candidates[depth] >> ray
        if mask == 0:
            current[depth] = -1
            depth -= 1
            continue
        while mask & 1 == 0:
            mask >>= 1
            ray += 1
        if counters[NODES] >= until:
            # The pin is off its ray, and the next call tries this one: as if none had been tried.
            if current[depth] >= 0:
                for c in range(cylinders):
                    capacity[takes[pin, current[depth], c]] -= 1
                placed[pin] = 1
            state[0], state[1], state[2] = depth, rows, worst
            return PAUSED
        current[depth] = ray
        for c in range(cylinders):
            tick = takes[pin, ray, c]
            capacity[tick] -= 1
            if capacity[tick] == 0:
                free &= ~(1 << tick)
        star[pin], placed[pin] = ray, 1
        counters[NODES] += 1

        for f in range(forms):
            partial[depth + 1, f] = partial[depth, f] + floats[f, pin, ray]
        cut = False
        for k in range(len(owners)):
            o = owners[k]
            if asked[o] != 0:
                number = partial[depth + 1, groups[k, 0]]
                square = number.real * number.real + number.imag * number.imag
                f = groups[k, 1]
                if f < 0:
                    cut = square > reach[k, depth + 1]
                else:
                    least = math.sqrt(square) - rest[groups[k, 0], depth + 1]
                    number = partial[depth + 1, f]
                    square = number.real * number.real + number.imag * number.imag
                    other = math.sqrt(square) - rest[f, depth + 1]
                    doubt = slack[groups[k, 0]] + slack[f]
                    cut = max(least, 0.0) + max(other, 0.0) > limits[o] + doubt
                if cut:
                    counters[FIRST_CUT + o] += 1
                    break
        if cut:
            continue

        # An image that comes before the star: its class is walked elsewhere.
        first_of_class = True
        for g in range(symmetries):
            c = tied[depth, g]
            if c >= 0 and placed[sources[g, 0]]:
                start = star[sources[g, 0]]
                while c <= depth:
                    q = order[c]
                    source = sources[g, q]
                    if not placed[source]:
                        break
                    image = (signs[g] * (star[source] - start) + shifts[g, q]) % rays
                    if image < star[q]:
                        first_of_class = False
                        break
                    if image > star[q]:
                        c = -1
                        break
                    c += 1
            tied[depth + 1, g] = c
            if not first_of_class:
                break
        if not first_of_class:
            continue

        if depth < pins - 1:
            depth += 1
            current[depth] = -1
            continue

        counters[LEAVES] += 1
        # A complete star: which of its sums are zero is decided in integers.
        for f in range(forms):
            is_zero[f] = False
            number = partial[pins, f]
            sizes[f] = math.sqrt(number.real * number.real + number.imag * number.imag)
            if sizes[f] <= slack[f]:
                is_zero[f] = True
                for i in range(integers.shape[3]):
                    total = 0
                    for p in range(pins):
                        total += integers[f, p, star[p], i]
                    if total != 0:
                        is_zero[f] = False
                        break
        doubtful, met = False, True
        for o in range(objectives):
            values[o] = 0.0
        for k in range(len(owners)):
            o = owners[k]
            f = groups[k, 0]
            value = 0.0 if is_zero[f] else sizes[f]
            zero, doubt = is_zero[f], slack[f]
            f = groups[k, 1]
            if f >= 0:
                value += 0.0 if is_zero[f] else sizes[f]
                zero, doubt = zero and is_zero[f], doubt + slack[f]
            if not zero and value <= 0.0:
                value = doubt  # not zero, whatever the float says
            values[o] = max(values[o], value)
            if asked[o] != 0:
                if limits[o] == 0.0:
                    if not zero:
                        met = False
                        break
                elif value > limits[o] + doubt:
                    met = False
                    break
                elif value > limits[o] - doubt:
                    doubtful = True
        if met:
            for o in range(objectives):
                if asked[o] == 2 and limits[o] > 0.0:
                    doubtful = True
        if not met:
            continue
        same, mirrored, mirrors = 1, 1, 1
        for g in range(symmetries):
            tie = tied[pins, g] == pins
            if tie:
                same += 1
            if mirror[g]:
                mirrors += 1
                if tie:
                    mirrored += 1
        cranks = (1 + symmetries) // same
        stars = cranks * mirrored // mirrors
        if not doubtful:
            known = count_only
            if not known and front_size > 0:
                # The point that beat the last star is asked first.
                for i in range(front_size + 1):
                    point = worst if i == 0 else i - 1
                    if point >= front_size:
                        continue
                    less, lower = True, False
                    for j in range(len(minimized)):
                        best, value = front[point, j], values[minimized[j]]
                        margin = front[point, len(minimized)]
                        if best < value - margin:
                            lower = True
                        elif best != 0.0:
                            less = False
                            break
                    if less and lower:
                        known, worst = True, point
                        break
            if known:
                counters[CRANKS] += cranks
                counters[STARS] += stars
                counters[CLASSES] += 1
                continue
        for p in range(pins):
            buffer[rows, p] = star[p]
        weights[rows, 0], weights[rows, 1], weights[rows, 2] = cranks, stars, 1 if doubtful else 0
        rows += 1
        if rows == len(buffer):
            state[0], state[1], state[2] = depth, rows, worst
            return BUFFER_FULL
    state[0], state[1], state[2] = depth, rows, worst
    return FINISHED


@cache
def compiled_walk() -> Callable[..., int] | None:
    """Return the walk compiled by Numba, None where Numba is not installed."""
    try:
        from numba import njit
    except ImportError:
        return None
    try:
        return njit(cache=True)(walk_stars)
    except RuntimeError:  # no folder in which Numba may keep what it compiled
        return njit(walk_stars)
