"""Whether 1 is a combination of polynomials: then they vanish together nowhere (Buchberger 1965).

Decided over a finite field first: what is no combination there is none over the fractions, unless the
prime divides a number on the way. Most systems end there, with nothing proved, at a tenth of the work
that growing fractions take; only where 1 comes out is it derived again with exact numbers.

A monomial is one whole number that holds, in fields of `WIDTH` bits, the sums of its first n, n - 1, … 1
exponents and below them the exponents: its products are sums, its graded reverse lexicographic order that
of whole numbers, and it divides another where no field of the exponents borrows.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

from symbalance.notes.algebra.domain import TooLargeError

Powers = tuple[int, ...]
Dense = dict[Powers, Fraction]
"""A polynomial by the exponents of all variables."""
MOST_STEPS = 4000
"""Reductions of one polynomial by another: some tenths of a second."""
LARGEST_BITS = 2000
"""Of a coefficient on the way."""
MOST_KEPT = 256
"""Systems whose answer is kept for the next question."""
PRIME = 2**61 - 1
WIDTH = 16
LARGEST_DEGREE = 2 ** (WIDTH - 2)
"""A monomial and its product with another both stay within their fields."""
Row = dict[int, int | Fraction]


def has_constant(rows: Sequence[Dense]) -> bool:
    """Tell whether 1 is a combination of polynomials in the same variables.

    >>> one = Fraction(1)
    >>> has_constant([{(1,): one, (0,): -one}, {(2,): one, (0,): one}]), has_constant([{(2,): one}])
    (True, False)
    """
    answer = _decided(tuple(tuple(row.items()) for row in sorted(rows, key=len)))
    if answer is None:
        raise TooLargeError("an elimination of too many steps")
    return answer


@lru_cache(MOST_KEPT)
def _decided(rows: tuple[tuple[tuple[Powers, Fraction], ...], ...]) -> bool | None:
    """Return the answer for rows in their order; None where it takes too many steps.

    Kept: one system of premises is asked about for each line that rests on it.
    """
    size = max((len(powers) for row in rows for powers, _ in row), default=0)
    is_in_field = all(c.denominator % PRIME for row in rows for _, c in row)
    try:
        if is_in_field and not _Reductions(size, PRIME).reach_constant(rows):
            return False
        return _Reductions(size, None).reach_constant(rows)
    except TooLargeError:
        return None


class _Reductions:
    """Polynomials reduced by each other, over the fractions or over the field of a prime."""

    def __init__(self, size: int, prime: int | None) -> None:
        self.prime, self.steps = prime, 0
        self.width = WIDTH * size
        self.exponents = (1 << self.width) - 1
        self.ones = sum(1 << (WIDTH * n) for n in range(size))
        self.guards = self.ones << (WIDTH - 1)
        self.basis: list[Row] = []
        self.leads: list[int] = []
        """The leading monomials of the basis, whole, and by their exponents alone."""
        self.low_leads: list[int] = []
        self.needed: list[int] = []
        """Those of the basis whose leading term no other's divides: the rest have had their pairs."""
        self.pairs: list[tuple[int, int, int, int, int]] = []
        """Degree, number in order, exponents of the lowest common multiple, and the two polynomials."""
        self.pair_count = 0

    def reach_constant(self, rows: Sequence[Sequence[tuple[Powers, Fraction]]]) -> bool:
        """Tell whether 1 comes out; what takes too many steps raises TooLargeError."""
        for row in rows:
            rest = self._reduced({self._packed(p): self._number(c) for p, c in row})
            if rest and self._take_in(rest):
                return True
        while self.pairs:
            _, _, common, i, k = heapq.heappop(self.pairs)
            rest = self._reduced(self._difference(i, k, common))
            if rest and self._take_in(rest):
                return True
        return False

    def _number(self, coefficient: Fraction) -> int | Fraction:
        if self.prime is None:
            return coefficient
        return coefficient.numerator * pow(coefficient.denominator, -1, self.prime) % self.prime

    def _packed(self, powers: Sequence[int]) -> int:
        if sum(powers) > LARGEST_DEGREE:
            raise TooLargeError("an elimination of too high a degree")
        return self._with_sums(sum(power << (WIDTH * n) for n, power in enumerate(powers)))

    def _with_sums(self, low: int) -> int:
        """Return a monomial of these exponents, with the sums of its first ones above them."""
        return (low * self.ones & self.exponents) << self.width | low

    def _divides(self, low: int, other: int) -> bool:
        """Tell whether the monomial of some exponents divides that of others."""
        return (other | self.guards) - low & self.guards == self.guards

    def _common(self, low: int, other: int) -> int:
        """Return the exponents of the lowest common multiple: the larger one, field by field."""
        larger = (low | self.guards) - other & self.guards
        fields = larger - (larger >> (WIDTH - 1))
        return low & fields | other & ~fields

    def _take_in(self, row: Row) -> bool:
        """Add a polynomial to the basis, its leading coefficient 1; tell whether it is a constant."""
        lead = max(row)
        if not lead:
            return True
        if self.prime is None:
            self.basis.append({p: Fraction(c) / row[lead] for p, c in row.items()})
        else:
            inverse = pow(int(row[lead]), -1, self.prime)
            self.basis.append({p: c * inverse % self.prime for p, c in row.items()})
        self.leads.append(lead)
        self.low_leads.append(lead & self.exponents)
        self._pair_last()
        return False

    def _pair_last(self) -> None:
        """Note the pairs of the last polynomial that may bring something (Gebauer and Moeller 1988).

        A pair whose common multiple another pair's divides follows from that one and from a third,
        and two leading terms without a variable in common reduce to zero.
        """
        last = len(self.basis) - 1
        own = self.low_leads[last]
        guards, leads = self.guards, self.low_leads
        pairs = [
            pair
            for pair in self.pairs
            if (pair[2] | guards) - own & guards != guards  # the new one does not divide the multiple
            or self._common(leads[pair[3]], own) == pair[2]
            or self._common(leads[pair[4]], own) == pair[2]
        ]
        if len(pairs) < len(self.pairs):
            heapq.heapify(pairs)
            self.pairs = pairs
        # Of several with one multiple that without a common variable stands for all.
        by_multiple: dict[int, int] = {}
        for n in self.needed:
            common = self._common(self.low_leads[n], own)
            if common not in by_multiple or common == self.low_leads[n] + own:
                by_multiple[common] = n
        kept: list[int] = []
        for common in sorted(by_multiple, key=self._with_sums):
            if any(self._divides(other, common) for other in kept):
                continue
            kept.append(common)
            n = by_multiple[common]
            if common != self.low_leads[n] + own:
                self.pair_count += 1
                degree = self._with_sums(common) >> (2 * self.width - WIDTH)
                heapq.heappush(self.pairs, (degree, self.pair_count, common, n, last))
        self.needed = [n for n in self.needed if not self._divides(own, self.low_leads[n])]
        self.needed.append(last)

    def _difference(self, i: int, k: int, low: int) -> Row:
        common, total = self._with_sums(low), Row()
        self._add(total, self.basis[i], common - self.leads[i], 1)
        self._add(total, self.basis[k], common - self.leads[k], -1)
        return total

    def _add(self, total: Row, row: Row, shift: int, factor: int | Fraction) -> None:
        prime = self.prime
        for monomial, coefficient in row.items():
            key = monomial + shift
            value = total.get(key, 0) + factor * coefficient
            if prime is not None:
                value %= prime
            if value:
                total[key] = value
            else:
                total.pop(key, None)

    def _reduced(self, row: Row) -> Row:
        """Return what is left of a polynomial once every leading term of the basis is taken out."""
        rest, result, guards = {p: c for p, c in row.items() if c}, Row(), self.guards
        leads = [(self.low_leads[n], n) for n in self.needed]
        while rest:
            lead = max(rest)
            guarded = lead & self.exponents | guards
            by = next((n for low, n in leads if guarded - low & guards == guards), None)
            if by is None:
                result[lead] = rest.pop(lead)
                continue
            self.steps += 1
            if self.steps > MOST_STEPS:
                raise TooLargeError("an elimination of too many steps")
            if self.prime is None and rest[lead].numerator.bit_length() > LARGEST_BITS:
                raise TooLargeError("an elimination of too large numbers")
            self._add(rest, self.basis[by], lead - self.leads[by], -rest[lead])
        return result
