"""Whether a page's indices are orders: F_2 beside cos 2θ, and not the force of the second cylinder.

The index of a letter is an order where the page's other formulas show it: the wave of the letter with
index n is that of nθ, or its power of the rod's ratio that of order n.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from symbalance.document.formula import Call, Formula, Name, Sum, names, walk
from symbalance.notes.checking.meant.products import NoProductError, product_of
from symbalance.notes.reading.equations import Chain

POWERS = {1: 0, 2: 1, 4: 3, 6: 5}
"""The power of r/l that the leading term of each order has."""
_ROMAN = {"I": 1, "II": 2, "IV": 4, "VI": 6}
_RATIOS = frozenset({"lambda", "lam", "rho", "epsilon", "varepsilon"})
_RODS = frozenset({"l", "L", "ell"})


def are_orders(chains: Sequence[Chain]) -> bool:
    """Tell whether the indices of forces and couples on a page are orders, by its formulas."""
    votes = [vote for chain in chains if (vote := _is_order(chain)) is not None]
    return 0 < 2 * votes.count(False) < votes.count(True) or (all(votes) and bool(votes))


def _is_order(chain: Chain) -> bool | None:
    """Tell whether the index of one formula's letter is an order; None where it shows nothing."""
    head = chain.sides[0].node
    index = index_of(head.name) if isinstance(head, Name) else 0
    if index not in POWERS or index == 1:
        return None
    value = chain.sides[1].node if len(chain.sides) > 1 else None
    if value is None:
        return None
    if multiples := wave_multiples(value):
        return multiples == {index}
    try:
        powers = product_of(value).powers
    except NoProductError:
        return None
    power = max((abs(p) for name, p in powers.items() if name in _RATIOS | _RODS), default=0)
    return True if power == POWERS[index] else None


def index_of(name: str) -> int:
    """Return the number that a letter has as index, 0 for none."""
    for part in re.split(r"[_,\s]+", name)[1:]:
        if part in _ROMAN or part.isdecimal():
            return _ROMAN.get(part) or int(part)
    match = re.fullmatch(r"[A-Za-z]+([1-9])", name)
    return int(match[1]) if match else 0


def wave_multiples(node: Formula) -> set[int]:
    """Return the multiples of the angle in the sines and cosines of a formula, 0 for another argument."""
    waves = [p for p in walk(node) if isinstance(p, Call) and p.function in ("cos", "sin")]
    return {wave_of(wave)[0] for wave in waves if names(wave.argument)}


def wave_of(wave: Call) -> tuple[int, str]:
    """Return n and θ of cos nθ, of cos nωt and of cos(nθ + δ), δ in degrees; 0 for another argument."""
    terms = wave.argument.terms if isinstance(wave.argument, Sum) else (wave.argument,)
    turning = [term for term in terms if names(term)]
    if len(turning) != 1:
        return 0, ""
    try:
        argument = product_of(turning[0])
    except NoProductError:
        return 0, ""
    number = abs(argument.number)
    letters = sorted(n for n, p in argument.powers.items() if p == 1)
    is_angle = len(letters) == 1 or (len(letters) == 2 and "t" in letters)
    if not is_angle or len(argument.powers) != len(letters) or not number.is_integer() or not number:
        return 0, ""
    return int(number), " ".join(letters)
