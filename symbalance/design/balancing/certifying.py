"""What a design has done to each order: proved on the engine with the design built in.

The designer's own sums are not asked: `symbalance.forces.free_forces.balance` adds up cylinders,
counterweights and shafts anew, and a number is zero where its normal form is (decimals: where the parts
cancel to their rounding).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symbalance.exact.amplitude import Amplitude
from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Component, Spectrum
from symbalance.forces.free_forces import Balance


@dataclass(frozen=True)
class Claim:
    """One part of one order: `signed` order, of "force" or "couple", before and after."""

    signed: int
    kind: str
    before: Amplitude
    after: Amplitude

    @property
    def is_zero(self) -> bool:
        """Whether it is proved to be zero now."""
        return self.after.is_zero()

    @property
    def verdict(self) -> str:
        """Absent (there was none), removed, reduced or changed, unchanged, or added."""
        if self.before.is_zero():
            return "absent" if self.is_zero else "added"
        if self.is_zero:
            return "removed"
        return "unchanged" if _same(self.before, self.after) else "reduced"

    @property
    def component(self) -> Component:
        """What is left, as the vertical component of the part that turns."""
        return Component(self.after.conjugate() if self.signed > 0 else self.after)


def _same(before: Amplitude, after: Amplitude) -> bool:
    return (before - after).is_zero()


def claims(before: Balance, after: Balance, orders: Sequence[int]) -> list[Claim]:
    """Return a claim for force and couple of every signed order of `orders`, absent ones included.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.forces.free_forces import balance
    >>> four = balance(load("inline-4"), 2)
    >>> [c.verdict for c in claims(four, four, [1, 2])][:5]
    ['absent', 'absent', 'absent', 'absent', 'unchanged']
    """
    found = []
    for n in orders:
        for kind in ("force", "couple"):
            was, now = (_terms(b, kind) for b in (before, after))
            found += [Claim(s, kind, was.get(s, ZERO), now.get(s, ZERO)) for s in (n, -n)]
    return found


def _terms(balance: Balance, kind: str):
    vector: Spectrum = balance.force if kind == "force" else balance.couple
    return vector.terms
