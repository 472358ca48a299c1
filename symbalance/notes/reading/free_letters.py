"""Letters that nobody declared, read as letters of their own where what they are cannot change the sense.

In `cos α − cos β = −2 sin((α + β)/2) sin((α − β)/2)` it does not matter what α means. It does for f(x),
which may be a function, for ẍ, which is 0 for a constant, for F_k under a sum over k, and for N behind a
number, which may be a unit: those stay undeclared, and are said to be.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from symbalance.document.formula import Derivative, Formula, Integral, Summation, names, walk
from symbalance.document.letters import ACCENTS, GREEK_SIGN
from symbalance.notes.reading.lexer import Token
from symbalance.notes.reading.units import scale_of

_MARKS = frozenset(ACCENTS.values()) | {"Delta", "delta"}
_NEVER = frozenset({"O", "e", "i", "j"})
"""Big O, or a nought misread, and the constants."""
_INDICES = frozenset({"i", "j", "k"})


def is_plain(name: str) -> bool:
    """Tell whether a canonical name is one letter, with subscript, accent or prime: no word.

    >>> [is_plain(name) for name in ("F", "m_rot", "bar_v", "gamma_1'", "Lh", "O")]
    [True, True, True, True, False, False]
    """
    parts = re.sub(r"'+$", "", name).split("_")
    while len(parts) > 1 and parts[0] in _MARKS:
        parts = parts[1:]
    base = parts[0]
    return (len(base) == 1 and base.isalpha() and base not in _NEVER) or base in GREEK_SIGN


def may_be_free(name: str, tokens: Sequence[Token], start: int, place: int) -> bool:
    """Tell whether an undeclared letter that begins at `start` is one by what stands around it.

    `place` is that of the token behind it.
    """
    if not is_plain(name):
        return False
    before = next((t for t in reversed(tokens[:place]) if t.end <= start), None)
    is_last = place >= len(tokens) or tokens[place].kind in ("sep", "close")
    if is_last and before is not None and before.kind in ("number", "vulgar") and scale_of(name):
        return False  # 3 N, but 2 m r
    if place + 2 < len(tokens) and tokens[place].kind == "open" and tokens[place + 2].kind == "close":
        inside = tokens[place + 1]
        is_call = tokens[place].value == "(" and tokens[place].start == tokens[place - 1].end
        if is_call and inside.kind in ("name", "number"):
            return False  # f(x), f(0)
    return not (name == "d" and place < len(tokens) and tokens[place].kind in ("name", "cmd"))


def unclear(node: Formula, free: Collection[str]) -> str | None:
    """Return a free letter that stands where its meaning counts, None if there is none.

    Under a derivative or integral it may vary; under a sum its subscript may count.
    """
    for part in walk(node):
        if isinstance(part, Derivative):
            inside = names(part.expression)
        elif isinstance(part, Integral):
            inside = names(part.body) - {part.variable.name}
        elif isinstance(part, Summation):
            inside = {name for name in names(part.body) if _is_indexed(name, part)}
        else:
            continue
        for name in sorted(inside):
            if name in free:
                return name
    return None


def _is_indexed(name: str, total: Summation) -> bool:
    subscripts = set(re.split(r"[_,]", name)[1:])
    if total.index is None:
        return bool(subscripts)
    return total.index.name in subscripts or not subscripts.isdisjoint(_INDICES)
