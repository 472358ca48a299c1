"""Groups of values side by side, each a case: θ = 0, x = 0; θ = 180°, x = 2r.

Semicolons part the groups, and each gives the same letters values, in the same order.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from symbalance.document.formula import Name
from symbalance.notes.reading.equations import Chain

_PARTED = re.compile(r"[;；]")


def is_in_next_group(text: str, chains: Sequence[Chain], chain: Chain) -> bool:
    """Tell whether a relation stands in a group of values behind another group of the same letters."""
    row = sorted(
        (other for other in chains if other.lines[0] == chain.lines[0]), key=lambda c: c.sides[0].span[0]
    )
    groups: list[list[Chain]] = [row[:1]]
    for before, after in pairwise(row):
        between = text[before.sides[-1].span[1] : after.sides[0].span[0]]
        if _PARTED.search(between):
            groups.append([])
        groups[-1].append(after)
    number = next((n for n, group in enumerate(groups) if any(c is chain for c in group)), 0)
    heads = [_heads(group) for group in groups]
    return number > 0 and len(heads[number]) > 1 and heads[number] in heads[:number]


def _heads(group: Sequence[Chain]) -> tuple[str, ...]:
    """Return the letters that a group gives values, () where a relation is of another kind."""
    names = [c.sides[0].node.name for c in group if isinstance(c.sides[0].node, Name)]
    return tuple(names) if len(names) == len(group) else ()
