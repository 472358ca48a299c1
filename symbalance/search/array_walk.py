"""The same walk in NumPy, where Numba is not installed: many stars grow by one pin at a time.

Blocks of unfinished stars lie on a stack, the longest on top, so that memory stays within a block for
each pin. What is cut and what is counted is the same as in `star_walk`, node by node.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from symbalance.search.integer_ring import Array
from symbalance.search.star_walk import CLASSES, CRANKS, FIRST_CUT, LEAVES, NODES, STARS
from symbalance.search.tables import EXACTLY, FREE, Tables

BLOCK = 4096
"""Stars that grow at once."""


@dataclass
class _Block:
    """Unfinished stars of one length: rays, what is free, sums, and how far symmetries tie."""

    depth: int
    stars: Array
    capacity: Array
    partial: Array

    def __len__(self) -> int:
        return len(self.stars)

    def rows(self, which: Array | slice) -> _Block:
        """Return some of the stars."""
        return _Block(self.depth, self.stars[which], self.capacity[which], self.partial[which])


def walk_arrays(
    tables: Tables,
    capacity: Array,
    front: Callable[[], tuple[Array, int, bool]],
    counters: Array,
) -> Iterator[tuple[Array, Array]]:
    """Yield the rays of stars for the caller to judge, and their weights, as `star_walk` says of both."""
    pins, forms = tables.pins, tables.forms
    pending = [
        _Block(
            0,
            np.zeros((1, pins), np.int64),
            capacity[None, :].astype(np.int16),
            np.zeros((1, forms), np.complex128),
        )
    ]
    while pending:
        block = pending.pop()
        if len(block) > BLOCK:
            pending.append(block.rows(slice(BLOCK, None)))
            block = block.rows(slice(0, BLOCK))
        grown = _grown(tables, block, counters)
        if not len(grown):
            continue
        if grown.depth < pins:
            pending.append(grown)
            continue
        counters[LEAVES] += len(grown)
        stars, weights = _judged(tables, grown, front, counters)
        if len(stars):
            yield stars, weights


def _grown(tables: Tables, block: _Block, counters: Array) -> _Block:
    """Return a block with one pin more, without the branches that end there."""
    pin = tables.order[block.depth]
    parts = []
    for ray in range(tables.rays):
        ticks = tables.takes[pin, ray]
        if ticks[0] < 0:
            continue
        less = np.bincount(ticks, minlength=tables.ticks).astype(np.int16)
        rest = block.capacity - less
        fits = (rest >= 0).all(1)
        if fits.any():
            stars = block.stars[fits].copy()
            stars[:, pin] = ray
            sums = block.partial[fits] + tables.floats[:, pin, ray]
            parts.append(_Block(block.depth + 1, stars, rest[fits], sums))
    if not parts:
        return block.rows(slice(0, 0))
    grown = _Block(
        block.depth + 1,
        np.concatenate([part.stars for part in parts]),
        np.concatenate([part.capacity for part in parts]),
        np.concatenate([part.partial for part in parts]),
    )
    counters[NODES] += len(grown)
    keep = np.ones(len(grown), bool)
    depth = grown.depth
    for group, owner in zip(tables.groups, tables.owners, strict=True):
        if tables.asked[owner] == FREE:
            continue
        least, doubt = np.zeros(len(grown)), 0.0
        for form in group[group >= 0]:
            least += np.maximum(0.0, abs(grown.partial[:, form]) - tables.rest[form, depth])
            doubt += tables.slack[form]
        cut = keep & (least > tables.limits[owner] + doubt)
        counters[FIRST_CUT + owner] += cut.sum()
        keep &= ~cut
    grown = grown.rows(keep)
    return grown.rows(_first_of_class(tables, grown)[0])


def _first_of_class(tables: Tables, block: _Block) -> tuple[Array, Array]:
    """Return which stars no image comes before, as far as they have grown, and which images tie."""
    placed = set(tables.order[: block.depth].tolist())
    first = np.ones(len(block), bool)
    ties = np.zeros((len(tables.signs), len(block)), bool)
    for g, (source, sign, shift) in enumerate(
        zip(tables.sources, tables.signs, tables.shifts, strict=True)
    ):
        undecided = np.ones(len(block), bool)
        if source[0] not in placed:
            continue
        complete = True
        for q in tables.order[: block.depth]:
            if source[q] not in placed:
                complete = False
                break
            start = block.stars[:, source[0]]
            image = (sign * (block.stars[:, source[q]] - start) + shift[q]) % tables.rays
            first &= ~(undecided & (image < block.stars[:, q]))
            undecided &= image == block.stars[:, q]
        ties[g] = undecided & complete
    return first, ties


def _judged(
    tables: Tables, block: _Block, front: Callable[[], tuple[Array, int, bool]], counters: Array
) -> tuple[Array, Array]:
    """Return the complete stars that are not known to fail or to be worse than the front."""
    values, met, doubtful = _values(tables, block)
    block, values, doubtful = block.rows(met), values[met], doubtful[met]
    _, ties = _first_of_class(tables, block)
    same = 1 + ties.sum(0)
    cranks = (1 + len(tables.signs)) // same
    mirrors = 1 + int(tables.mirror.sum())
    stars = cranks * (1 + ties[tables.mirror].sum(0)) // mirrors
    points, size, count_only = front()
    known = np.full(len(block), count_only) & ~doubtful
    if not count_only and size:
        for point in points[:size]:
            margin = point[-1]
            less, lower = np.ones(len(block), bool), np.zeros(len(block), bool)
            for best, o in zip(point[:-1], tables.minimized, strict=True):
                below = best < values[:, o] - margin
                lower |= below
                less &= below | (best == 0.0)
            known |= less & lower & ~doubtful
    counters[CRANKS] += cranks[known].sum()
    counters[STARS] += stars[known].sum()
    counters[CLASSES] += known.sum()
    other = ~known
    weights = np.stack([cranks[other], stars[other], doubtful[other].astype(np.int64)], axis=1)
    return block.stars[other], weights


def _values(tables: Tables, block: _Block) -> tuple[Array, Array, Array]:
    """Return the values, which stars may meet the conditions, and of which that is in doubt."""
    count = len(block)
    sizes = abs(block.partial)
    near = sizes <= tables.slack
    zero = np.zeros(near.shape, bool)
    for form in range(tables.forms):
        rows = np.flatnonzero(near[:, form])
        if len(rows):
            chosen = tables.integers[form][np.arange(tables.pins)[None, :], block.stars[rows]]
            zero[rows, form] = (chosen.sum(1) == 0).all(1)
    values = np.zeros((count, len(tables.asked)))
    met, doubtful = np.ones(count, bool), np.zeros(count, bool)
    for group, o in zip(tables.groups, tables.owners, strict=True):
        forms = group[group >= 0]
        doubt = float(tables.slack[forms].sum())
        all_zero = zero[:, forms].all(1)
        value = np.where(zero[:, forms], 0.0, sizes[:, forms]).sum(1)
        value[(value <= 0.0) & ~all_zero] = doubt  # not zero, whatever the float says
        values[:, o] = np.maximum(values[:, o], value)
        limit = tables.limits[o]
        if tables.asked[o] == FREE:
            continue
        if limit == 0.0:
            met &= all_zero
        else:
            met &= value <= limit + doubt
            doubtful |= value > limit - doubt
    for o in range(len(tables.asked)):
        if tables.asked[o] == EXACTLY and tables.limits[o] > 0.0:
            doubtful |= True
    return values, met, doubtful
