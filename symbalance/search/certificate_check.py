"""Checks a certificate of `symbalance search`, alone: `python certificate_check.py FILE`.

Nothing of the library is used, only integers and fractions. The tree is walked by the certificate's
letters. That no branch is missing is seen from the moments that are free; that a branch may end is
computed anew: a limit that is passed, in integers of 2^-BITS with their errors on the safe side; zero
and equality modulo the cyclotomic polynomial; an image under a symmetry, after it was checked that the
symmetry changes no sum. Of stars that are images of one another the first never ends by "i": so the
stars named are those that meet every condition, one of each class, and if there are none, none does.
"""

from __future__ import annotations

import json
import sys
from fractions import Fraction
from functools import cache
from math import isqrt, lcm
from pathlib import Path
from typing import Any

BITS = 120
ONE = 1 << BITS
ERROR = 1 << 20
"""What a sum of sines may be off by, in units of 2^-BITS: each term is off by less than 2^6."""


class WrongError(Exception):
    """The certificate does not prove what it says."""


@cache
def pi() -> int:
    """Return pi by Machin's formula."""

    def arctangent(x: int) -> int:
        total = term = (ONE << 20) // x
        n, sign = 3, -1
        while term:
            term //= x * x
            total += sign * (term // n)
            n, sign = n + 2, -sign
        return total

    return (16 * arctangent(5) - 4 * arctangent(239)) >> 20


@cache
def unit(turns: Fraction) -> tuple[int, int]:
    """Return cos and sin of an angle in turns, in units of 2^-BITS, off by less than 2^6."""
    quarter, rest = divmod(turns % 1, Fraction(1, 4))
    x = 2 * pi() * rest.numerator // rest.denominator
    cosine, sine, power, n = 0, 0, ONE, 0
    while power:
        sign = -1 if n % 4 > 1 else 1
        if n % 2:
            sine += sign * power
        else:
            cosine += sign * power
        n += 1
        power = power * x // (n * ONE)
    for _ in range(int(quarter)):
        cosine, sine = -sine, cosine
    return cosine, sine


@cache
def cyclotomic(m: int) -> tuple[int, ...]:
    """Return Phi_m, constant first."""
    polynomial = [-1, *[0] * (m - 1), 1]
    for d in range(1, m):
        if m % d == 0:
            polynomial = divided(polynomial, cyclotomic(d))[0]
    return tuple(polynomial)


def divided(above: list[Any], below: tuple[int, ...]) -> tuple[list[Any], list[Any]]:
    """Return quotient and rest of a division by a monic polynomial."""
    rest, quotient = list(above), []
    for place in range(len(above) - len(below), -1, -1):
        factor = rest[place + len(below) - 1]
        quotient.insert(0, factor)
        for i, c in enumerate(below):
            rest[place + i] -= factor * c
    return quotient, rest


Terms = list[tuple[Fraction, Fraction]]


def is_zero(terms: Terms) -> bool:
    """Tell whether a sum of weights times e^(2 pi i turns) is zero."""
    m = lcm(*(turns.denominator for _, turns in terms)) if terms else 1
    polynomial = [Fraction(0)] * max(m, len(cyclotomic(m)))
    for weight, turns in terms:
        polynomial[int(turns % 1 * m)] += weight
    return not any(divided(polynomial, cyclotomic(m))[1])


def size(terms: Terms) -> tuple[Fraction, Fraction]:
    """Return bounds of the size of a sum, from below and above."""
    x = sum((w * unit(t)[0] for w, t in terms), Fraction(0))
    y = sum((w * unit(t)[1] for w, t in terms), Fraction(0))
    middle = isqrt(int(x) ** 2 + int(y) ** 2)
    error = ERROR * (1 + int(sum(abs(w) for w, _ in terms)))
    return Fraction(max(0, middle - error), ONE), Fraction(middle + error, ONE)


def product(first: Terms, second: Terms) -> Terms:
    """Return the terms of a product."""
    return [(v * w, t + u) for v, t in first for w, u in second]


def square(terms: Terms) -> Terms:
    """Return the terms of the square of a sum's size."""
    return product(terms, [(w, -t) for w, t in terms])


def equals(sums: list[Terms], limit: Fraction) -> bool:
    """Tell whether one size, or two together, are a limit above zero, for certain.

    With the squares a and b of two, sqrt(a) + sqrt(b) = q where (q^2 + a - b)^2 = 4 q^2 a, but for the
    signs of the roots: wrong ones would make a size less than twice what its bounds leave open.
    """
    if limit == 0:
        return False
    live = [terms for terms in sums if not is_zero(terms)]
    q = (limit * limit, Fraction(0))
    if len(live) == 1:
        return is_zero([*square(live[0]), (-q[0], q[1])])
    first, second = (square(terms) for terms in live)
    left = [q, *first, *((-w, t) for w, t in second)]
    if not is_zero([*product(left, left), *((-4 * q[0] * w, t) for w, t in first)]):
        return False
    bounds = [size(terms) for terms in live]
    low, high = sum(b[0] for b in bounds), sum(b[1] for b in bounds)
    return low <= limit <= high and all(b[0] > 2 * (high - low) for b in bounds)


class Check:
    """One certificate."""

    def __init__(self, data: dict[str, Any]) -> None:
        if data.get("certificate") != "symbalance search 1":
            raise WrongError("is no certificate of symbalance search")
        self.rays, self.order, self.takes = data["rays"], data["order"], data["takes"]
        self.pins, self.symmetries = len(self.order), data["symmetries"]
        self.conditions = [
            (
                c["exactly"],
                Fraction(c["limit"]),
                [[read(form) for form in group] for group in c["groups"]],
            )
            for c in data["conditions"]
        ]
        if sorted(self.order) != list(range(self.pins)):
            raise WrongError("places some pin twice")
        capacities = [tuple(walk["capacity"]) for walk in data["walks"]]
        for source, sign, shift in self.symmetries:
            self.check_symmetry(source, sign, shift)
            self.check_moments(source, sign, shift, capacities)
        self.found = 0
        for walk in data["walks"]:
            self.letters, self.capacity = iter(walk["letters"]), list(walk["capacity"])
            self.named: list[list[int]] = []
            self.node([])
            if next(self.letters, None) is not None:
                raise WrongError("goes on after its end")
            if self.named != walk["found"]:
                raise WrongError("names other stars than those that meet the conditions")
            self.found += len(self.named)

    def check_symmetry(self, source: list[int], sign: int, shift: list[int]) -> None:
        """Refuse a map of stars that changes some size, or which moments are taken."""
        if sign not in (1, -1) or sorted(source) != list(range(self.pins)):
            raise WrongError("has a map that is none of stars")
        for _, _, groups in self.conditions:
            for group in groups:
                if not any(
                    len(other) == len(group)
                    and all(
                        any(self.corresponds(f, g, source, sign, shift) for g in other) for f in group
                    )
                    for other in groups
                ):
                    raise WrongError("has a symmetry that changes a sum")

    def check_moments(
        self, source: list[int], sign: int, shift: list[int], capacities: list[tuple[int, ...]]
    ) -> None:
        """Refuse a map by which a star of the walks would become one of none: all moments turn as one."""
        ticks = len(capacities[0])
        first, last = self.order[0], source[self.order[0]]
        for start in range(self.rays) if last != first else [0]:
            pairs = [
                (self.takes[p][s], self.takes[q][(sign * (s - start) + shift[q]) % self.rays])
                for q, p in enumerate(source)
                for s in range(self.rays)
                if p != first or s == 0  # where cylinder 1 stands
                if p != last or s == start
            ]
            if any(before[0] >= 0 > after[0] for before, after in pairs):
                if self.takes[last][start][0] >= 0:
                    raise WrongError("has a symmetry that leads off the grid")
                continue
            turns = [
                c
                for c in range(ticks)
                if all(
                    sorted((sign * t + c) % ticks for t in before) == sorted(after)
                    for before, after in pairs
                    if before[0] >= 0
                )
            ]
            taken = (*self.takes[first][0], *(() if last == first else self.takes[last][start]))
            wanted = [c for c in capacities if all(c[t] >= taken.count(t) for t in taken)]
            if not turns or not all(
                tuple(one[sign * (t - turns[0]) % ticks] for t in range(ticks)) in capacities
                for one in wanted
            ):
                raise WrongError("has a symmetry that leads to moments of no walk")

    def corresponds(self, form: Any, other: Any, source: list[int], sign: int, shift: list[int]) -> bool:
        """Tell whether a form of every image has the size of another form of the star."""
        for turn in (1, -1):
            for mirror in (1, -1):
                if all(
                    self.turned(form, other, source, sign, shift, start, turn, mirror)
                    for start in range(self.rays)
                ):
                    return True
        return False

    def turned(
        self, form: Any, other: Any, source: list[int], sign: int, shift: list[int], start: int,
        turn: int, mirror: int,
    ) -> bool:  # fmt: skip
        """Tell whether all terms are those of the other form, turned by one angle."""
        by: Fraction | None = None
        for q, p in enumerate(source):
            for s in range(self.rays):
                image = (sign * (s - start) + shift[q]) % self.rays
                mine = sorted((w, t % 1) for w, t in form[q][image] if w)
                its = [(turn * w, mirror * t) for w, t in other[p][s] if w]
                if len(mine) != len(its):
                    return False
                if mine and by is None:
                    options = [(mine[0][1] - t) % 1 for w, t in its if w == mine[0][0]]
                    by = next(
                        (a for a in options if sorted((w, (t + a) % 1) for w, t in its) == mine), None
                    )
                if mine and (by is None or sorted((w, (t + by) % 1) for w, t in its) != mine):
                    return False
        return True

    def node(self, star: list[int]) -> None:  # noqa: PLR0912 - a letter each
        """Check a node by its letter, and what follows."""
        letter = next(self.letters, "")
        if letter == "x" and len(star) < self.pins:
            pin = self.order[len(star)]
            for ray in range(self.rays):
                ticks = self.takes[pin][ray]
                if ticks[0] < 0 or any(self.capacity[t] < ticks.count(t) for t in ticks):
                    continue
                for t in ticks:
                    self.capacity[t] -= 1
                self.node([*star, ray])
                for t in ticks:
                    self.capacity[t] += 1
        elif letter == "i":
            if not any(self.comes_before(star, *one) for one in self.symmetries):
                raise WrongError(f"says that an image comes before {star}, and none does")
        elif letter in ("c", "f"):
            if not any(self.fails(star, *condition) for condition in self.conditions):
                raise WrongError(f"cuts {star}, and no limit is passed for certain")
        elif letter == "s" and len(star) == self.pins:
            if not all(self.holds(star, *condition) for condition in self.conditions):
                raise WrongError(f"names {star}, which does not meet a condition for certain")
            rays = [0] * self.pins
            for pin, ray in zip(self.order, star, strict=True):
                rays[pin] = ray
            self.named.append(rays)
        else:
            raise WrongError(f"has no reason at {star}")

    def comes_before(self, star: list[int], source: list[int], sign: int, shift: list[int]) -> bool:
        """Tell whether the image of all stars that begin so comes before them."""
        placed = dict(zip(self.order, star, strict=False))
        for pin, ray in placed.items():
            if source[0] not in placed or source[pin] not in placed:
                return False
            image = (sign * (placed[source[pin]] - placed[source[0]]) + shift[pin]) % self.rays
            if image != ray:
                return image < ray
        return False

    def terms(self, star: list[int], form: Any) -> Terms:
        """Return the terms of a sum that the pins of a star add."""
        return [term for pin, ray in zip(self.order, star, strict=False) for term in form[pin][ray]]

    def fails(self, star: list[int], exactly: bool, limit: Fraction, groups: Any) -> bool:
        """Tell whether a limit is passed for certain, whatever the pins that are not placed do."""
        for group in groups:
            least = Fraction(0)
            for form in group:
                rest = sum(
                    max(sum(abs(w) for w, _ in terms) for terms in form[pin])
                    for pin in self.order[len(star) :]
                )
                least += max(Fraction(0), size(self.terms(star, form))[0] - rest)
            if least > limit:
                return True
        if len(star) < self.pins or not (exactly or limit == 0):
            return False
        if limit == 0:
            return not all(is_zero(self.terms(star, form)) for group in groups for form in group)
        most = max(sum(size(self.terms(star, form))[1] for form in group) for group in groups)
        return most < limit

    def holds(self, star: list[int], exactly: bool, limit: Fraction, groups: Any) -> bool:
        """Tell whether a complete star meets a condition for certain."""
        equal = limit == 0
        for group in groups:
            sums = [self.terms(star, form) for form in group]
            if all(map(is_zero, sums)):
                continue
            if equals(sums, limit):
                equal = True
                continue
            if limit == 0 or sum(size(terms)[1] for terms in sums) > limit:
                return False
        return equal or not exactly


def read(form: Any) -> Any:
    """Return a form with its numbers as fractions."""
    return [[[(Fraction(w), Fraction(t)) for w, t in terms] for terms in pin] for pin in form]


def main(arguments: list[str]) -> int:
    """Check a file; 0 if it proves what it says, 1 if not, 2 if it cannot be read."""
    if len(arguments) != 1:
        print("usage: certificate_check.py FILE", file=sys.stderr)
        return 2
    try:
        data = json.loads(Path(arguments[0]).read_text(encoding="utf-8"))
        checked = Check(data)
    except WrongError as problem:
        print(f"{arguments[0]}: {problem}", file=sys.stderr)
        return 1
    except (OSError, ValueError, KeyError, TypeError, IndexError, AttributeError) as problem:
        print(
            f"{arguments[0]}: cannot be read as a certificate ({type(problem).__name__})", file=sys.stderr
        )
        return 2
    conditions = ", ".join(
        f"{c['name']} {'=' if c['exactly'] else '<='} {c['limit']}" for c in data["conditions"]
    )
    count = "none" if not checked.found else f"{checked.found} classes"
    print(f"{data['question']}: {count} with {conditions}: verified")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
