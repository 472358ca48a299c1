"""Groups of values side by side, each a case: θ = 0, x = 0; θ = 180°, x = 2r.

Semicolons part the groups, and each gives the same letters values, in the same order.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from symbalance.document.formula import Name
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_PARTED = re.compile(r"[;；]")


def in_next_groups(text: str, chains: Sequence[Chain]) -> Iterator[Chain]:
    """Yield those relations of a line that stand in a group behind another group of the same letters."""
    row = sorted(chains, key=lambda c: c.sides[0].span[0])
    groups: list[list[Chain]] = [row[:1]]
    for before, after in pairwise(row):
        between = text[before.sides[-1].span[1] : after.sides[0].span[0]]
        if _PARTED.search(between):
            groups.append([])
        groups[-1].append(after)
    earlier: set[tuple[str, ...]] = set()
    for group in groups:
        heads = _heads(group)
        if len(heads) > 1 and heads in earlier:
            yield from group
        earlier.add(heads)


def _heads(group: Sequence[Chain]) -> tuple[str, ...]:
    """Return the letters that a group gives values, () where a relation is of another kind."""
    names = [c.sides[0].node.name for c in group if isinstance(c.sides[0].node, Name)]
    return tuple(names) if len(names) == len(group) else ()
