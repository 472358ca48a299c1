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
from itertools import combinations

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
        self.size, self.prime, self.steps = size, prime, 0
        self.guards = sum(1 << (WIDTH * n + WIDTH - 1) for n in range(size))
        self.basis: list[Row] = []
        self.leads: list[int] = []
        self.lead_powers: list[Powers] = []
        self.pairs: list[tuple[int, int, int, int]] = []
        self.pair_count = 0

    def reach_constant(self, rows: Sequence[Sequence[tuple[Powers, Fraction]]]) -> bool:
        """Tell whether 1 comes out; what takes too many steps raises TooLargeError."""
        for row in rows:
            rest = self._reduced({self._packed(p): self._number(c) for p, c in row})
            if rest:
                if 0 in rest and len(rest) == 1:
                    return True
                self._take_in(rest)
        for i, k in combinations(range(len(self.basis)), 2):
            self._pair(i, k)
        while self.pairs:
            _, _, i, k = heapq.heappop(self.pairs)
            first, second = self.lead_powers[i], self.lead_powers[k]
            if not any(a and b for a, b in zip(first, second, strict=True)):
                continue  # no variable in common: it reduces to zero
            rest = self._reduced(self._difference(i, k))
            if not rest:
                continue
            if 0 in rest and len(rest) == 1:
                return True
            self._take_in(rest)
            last = len(self.basis) - 1
            for n in range(last):
                self._pair(n, last)
        return False

    def _number(self, coefficient: Fraction) -> int | Fraction:
        if self.prime is None:
            return coefficient
        return coefficient.numerator * pow(coefficient.denominator, -1, self.prime) % self.prime

    def _packed(self, powers: Sequence[int]) -> int:
        if sum(powers) > LARGEST_DEGREE:
            raise TooLargeError("an elimination of too high a degree")
        low = high = total = 0
        for n, power in enumerate(powers):
            total += power
            low |= power << (WIDTH * n)
            high |= total << (WIDTH * n)
        return high << (WIDTH * self.size) | low

    def _powers(self, packed: int) -> Powers:
        return tuple((packed >> (WIDTH * n)) & (2**WIDTH - 1) for n in range(self.size))

    def _take_in(self, row: Row) -> None:
        """Add a polynomial to the basis, its leading coefficient 1."""
        lead = max(row)
        if self.prime is None:
            self.basis.append({p: Fraction(c) / row[lead] for p, c in row.items()})
        else:
            inverse = pow(int(row[lead]), -1, self.prime)
            self.basis.append({p: c * inverse % self.prime for p, c in row.items()})
        self.leads.append(lead)
        self.lead_powers.append(self._powers(lead))

    def _common(self, i: int, k: int) -> Powers:
        return tuple(map(max, self.lead_powers[i], self.lead_powers[k]))

    def _pair(self, i: int, k: int) -> None:
        """Note two polynomials; those whose leading terms have the lowest common multiple come first."""
        self.pair_count += 1
        heapq.heappush(self.pairs, (sum(self._common(i, k)), self.pair_count, i, k))

    def _difference(self, i: int, k: int) -> Row:
        common, total = self._packed(self._common(i, k)), Row()
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
        exponents = (1 << (WIDTH * self.size)) - 1
        low_leads = [lead & exponents for lead in self.leads]
        while rest:
            lead = max(rest)
            guarded = (lead & exponents) | guards
            by = next((n for n, own in enumerate(low_leads) if (guarded - own) & guards == guards), None)
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
