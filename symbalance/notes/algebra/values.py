"""Numerical values of normal forms at random exact points: witnesses that two formulas differ."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

from symbalance.notes.algebra.domain import Domain, Monomial, NoFormError, Polynomial
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import MEAN, TURNING
from symbalance.text.reals import own_context

DIGITS = 40
"""Of every value. Half of them decide: what differs beyond 20 digits differs, less is rounding."""
MEAN_POINTS = (17, 34, 68, 136, 272, 544)
"""Over one turn: an odd number first, at which no symmetry hides a harmonic."""
QUARTER_POINTS = (5, 10, 20, 40, 80, 160)
"""Over a quarter of a turn, for what is the same in all four."""
FEWEST_STEPS, SLOW = 3, 8
"""Doublings looked at, and by how much a smooth function's error falls at least with each of them."""
MEANS_TRIED = 4
"""Points at which a mean is not reached before it is given up: with a kink it is so at all of them."""
Point = dict[str, Fraction]

_RANGES = {"lambda": (300, 500), "rho": (15, 40), "theta": (10, 620), "phi": (10, 150), "beta": (5, 40)}


class MeanNotReachedError(NoFormError):
    """The numbers of a mean over a turn do not settle: its integrand has a kink, there or everywhere."""


def context() -> Any:
    """Return this thread's own mpmath context: the precision of others does not count, nor changes."""
    return own_context(DIGITS)


@lru_cache(maxsize=64)
def power_of_ten(mp: Any, exponent: int) -> Any:
    """Return 10^exponent in a context: the tolerances of comparisons, which are needed at every point."""
    return mp.mpf(10) ** exponent


def letters(form: Form) -> list[str]:
    """Return the letters a form depends on, those inside roots, angles and functions included."""
    walk = _Letters()
    walk.visit(form)
    return list(walk.names)


class _Letters:
    """A walk over generators that enters each once: nested functions hold the same one many times."""

    def __init__(self) -> None:
        self.names: dict[str, None] = {}
        self._entered: set[tuple[int, int]] = set()

    def visit(self, form: Form) -> None:
        """Collect the letters of a form."""
        self.collect(form.domain, form.numerator)
        self.collect(form.domain, form.denominator)

    def collect(self, domain: Domain, polynomial: Polynomial) -> None:
        """Collect the letters of a polynomial over a domain."""
        for number in sorted({g for monomial in polynomial for g, _ in monomial}):
            if (id(domain), number) in self._entered:
                continue
            self._entered.add((id(domain), number))
            generator = domain.generators[number]
            if generator.kind == "symbol":
                if generator.content != TURNING:  # bound by its mean
                    self.names[generator.content] = None
            elif generator.kind in ("exponential", "growth"):
                self.collect(domain, {generator.content: Fraction(1)})
            elif generator.kind == "radical":
                self.collect(domain, generator.content)
            elif generator.kind == "opaque":
                self.visit(generator.content[1])


def random_point(names: list[str], domain: Domain, seed: int) -> Point:
    """Return a point with two decimals a letter; whole numbers where the letter is one."""
    chance = random.Random(f"{seed}")
    point: Point = {}
    for name in sorted(names):
        if name in domain.integer:
            point[name] = Fraction(chance.randint(2, 7))
            continue
        low, high = domain.ranges.get(name) or _RANGES.get(name, (50, 300))
        value = Fraction(chance.randint(low, high), 100)
        is_open = name not in domain.positive and name not in _RANGES and name not in domain.ranges
        may_be_negative = is_open and chance.random() < 0.3
        is_positive = f"{name} ≥ 0" in domain.assumptions
        point[name] = -value if may_be_negative and not is_positive else value
    return point


def value(form: Form, point: Mapping[str, Fraction]) -> Any:
    """Return the form at a point as an mpmath complex number; a pole raises NoFormError."""
    return Valuation(form.domain, point).of(form)


class Valuation:
    """The values of forms at one point, each generator evaluated once."""

    def __init__(self, domain: Domain, point: Mapping[str, Fraction]) -> None:
        self.domain, self.point, self.mp = domain, point, context()
        self._powers: dict[tuple[int, int | Fraction], Any] = {}
        self._values: dict[int, Any] = {}
        self._check_count = 0

    def of(self, form: Form) -> Any:
        """Return the value of a form."""
        self._check_assumptions()
        below = self.polynomial(form.denominator)
        if abs(below) < power_of_ten(self.mp, -DIGITS // 2):
            raise NoFormError("a division by nearly zero at this point")
        return self.polynomial(form.numerator) / below

    def _check_assumptions(self) -> None:
        polynomials = self.domain.positive_polynomials[self._check_count :]
        self._check_count += len(polynomials)
        for polynomial in polynomials:
            walk = _Letters()
            walk.collect(self.domain, polynomial)
            if walk.names.keys() <= self.point.keys() and self.polynomial(polynomial).real < 0:
                raise NoFormError("a denominator under a root is negative at this point")

    def polynomial(self, polynomial: Polynomial) -> Any:
        """Return the value of a polynomial."""
        total = self.mp.zero
        for monomial, coefficient in polynomial.items():
            size = self.mp.mpf(coefficient.numerator)
            if coefficient.denominator != 1:
                size = size / coefficient.denominator
            total += size * self.monomial(monomial) if monomial else size
        return total

    def monomial(self, monomial: Monomial) -> Any:
        """Return the value of a monomial."""
        result = None
        for number, exponent in monomial:
            power = self._power(number, exponent)
            result = power if result is None else result * power
        return self.mp.one if result is None else result

    def _power(self, number: int, exponent: int | Fraction) -> Any:
        key = (number, exponent)
        if key not in self._powers:
            self._powers[key] = self._find_power(number, exponent)
        return self._powers[key]

    def _find_power(self, number: int, exponent: int | Fraction) -> Any:
        mp, generator = self.mp, self.domain.generators[number]
        power = mp.mpf(exponent.numerator) / exponent.denominator
        if generator.kind == "turn":
            return mp.expjpi(2 * power)
        if generator.kind in ("exponential", "growth"):
            inner = self.monomial(generator.content) * power
            if generator.kind == "growth":
                return mp.exp(inner)
            if exponent < 0 and type(inner) is mp.mpf and (number, -exponent) in self._powers:
                return self._powers[number, -exponent].conjugate()
            return mp.exp(1j * inner)
        base = self._base(number)
        return base ** int(exponent) if power == int(power) else base**power

    def _base(self, number: int) -> Any:
        if number not in self._values:
            self._values[number] = self._find_base(number)
        return self._values[number]

    def _find_base(self, number: int) -> Any:
        """Return the value of a letter, prime, root or function; out of its range, raise NoFormError."""
        mp, generator = self.mp, self.domain.generators[number]
        if generator.kind == "symbol":
            if generator.content not in self.point:  # the angle of a mean, outside of it
                raise NoFormError(f"{generator.content}, which has no value")
            exact = self.point[generator.content]
            return mp.mpf(exact.numerator) / exact.denominator
        if generator.kind == "constant":
            return +getattr(mp, generator.content)
        if generator.kind == "prime":
            return mp.mpf(generator.content)
        if generator.kind == "radical":
            square = self.polynomial(generator.content)
            if square.real < 0 or abs(square.imag) > mp.mpf(10) ** (-DIGITS // 2):
                raise NoFormError("the root of a negative number at this point")
            return mp.sqrt(square.real)
        function, argument = generator.content
        if function == MEAN:
            return self._mean(argument)
        return self._function(function, self.of(argument))

    def _mean(self, argument: Form) -> Any:
        """Return the mean of a form over a turn: of a smooth one, that of equally spaced points.

        Its error falls as a geometric series does: where twice as many points bring nothing new, there
        is none.
        """
        turn, total, before = _Turn(self), self.mp.mpf(0), None

        def at(angle: Any) -> Any:
            return _AtAngle(turn, angle).of(argument)

        if self._is_even_about_quarters(at):
            return self._mean_by_quarter(at)
        steps = _Steps(self.mp)
        for count in MEAN_POINTS:
            step = 2 * self.mp.pi / count
            for place in range(count) if before is None else range(1, count, 2):
                total += at(step * place)
            now = total / count
            if before is not None and self._is_settled(now, before):
                return now
            if before is not None and steps.are_slow(abs(now - before)):
                break
            before = now
        raise MeanNotReachedError("a mean over a turn that is not reached at this point")

    def _is_even_about_quarters(self, at: Callable[[Any], Any]) -> bool:
        """Tell by an angle of no meaning whether f(x) = f(-x) = f(π - x): then a quarter says all."""
        one = self.mp.one
        first = at(one)
        return self._is_settled(at(-one), first) and self._is_settled(at(self.mp.pi - one), first)

    def _mean_by_quarter(self, at: Callable[[Any], Any]) -> Any:
        """Return the mean over a turn of what is the same in each quarter of it, to and fro."""
        ends, inside, before = (at(self.mp.zero) + at(self.mp.pi / 2)) / 2, self.mp.zero, None
        steps = _Steps(self.mp)
        for count in QUARTER_POINTS:
            step = self.mp.pi / 2 / count
            for place in range(1, count) if before is None else range(1, count, 2):
                inside += at(step * place)
            now = (ends + inside) / count
            if before is not None and self._is_settled(now, before):
                return now
            if before is not None and steps.are_slow(abs(now - before)):
                break
            before = now
        raise MeanNotReachedError("a mean over a turn that is not reached at this point")

    def _is_settled(self, now: Any, before: Any) -> bool:
        return bool(abs(now - before) <= self.mp.mpf(10) ** -30 * (1 + abs(now)))

    def _function(self, function: str, argument: Any) -> Any:
        if function == "sum":
            raise NoFormError("a sum without bounds")
        if function == "over":
            return 1 / argument
        if function.startswith("besselj"):
            return self.mp.besselj(int(function[-1]), argument)
        result = getattr(self.mp, {"ln": "log"}.get(function, function))(argument)
        if abs(result.imag) > power_of_ten(self.mp, -DIGITS // 2):
            raise NoFormError("a function outside its range at this point")
        return result


class _Steps:
    """How fast a mean over a turn comes near its value: what has a kink will never be reached.

    With twice the points the error of a smooth function is squared, that of one with a kink a quarter.
    """

    def __init__(self, mp: Any) -> None:
        self.sizes: list[Any] = []
        self.small = mp.mpf(10) ** -9

    def are_slow(self, size: Any) -> bool:
        """Tell, after one step more, whether the last two fell by less than a smooth function's do."""
        self.sizes.append(size)
        if len(self.sizes) < FEWEST_STEPS or size < self.small:
            return False
        first, second, third = self.sizes[-FEWEST_STEPS:]
        return bool(second * SLOW > first and third * SLOW > second)


class _Turn:
    """What stays while the angle turns, evaluated once for all its places."""

    def __init__(self, still: Valuation) -> None:
        self.still, self.domain = still, still.domain
        self.turning = self.domain.symbol(TURNING)
        self._moves: dict[int, bool] = {}
        self._grouped: dict[int, tuple[Polynomial, list[tuple[Monomial, Any]]]] = {}
        self.assumed: list[Polynomial] = []
        for polynomial in self.domain.positive_polynomials:
            walk = _Letters()
            walk.collect(self.domain, polynomial)
            if walk.names.keys() <= still.point.keys():
                self.assumed.append(polynomial)

    def grouped(self, polynomial: Polynomial) -> list[tuple[Monomial, Any]]:
        """Return a polynomial's moving monomials with the values of what each is multiplied by."""
        if id(polynomial) not in self._grouped:
            groups: dict[Monomial, Any] = {}
            for monomial, coefficient in polynomial.items():
                moving = tuple((g, e) for g, e in monomial if self.moves(g))
                steady = tuple((g, e) for g, e in monomial if not self.moves(g))
                value = self.still.polynomial({steady: coefficient})
                groups[moving] = groups[moving] + value if moving in groups else value
            self._grouped[id(polynomial)] = polynomial, list(groups.items())
        return self._grouped[id(polynomial)][1]

    def moves(self, number: int) -> bool:
        """Tell whether a generator's value changes with the angle; a mean's own angle is bound."""
        if number not in self._moves:
            generator = self.domain.generators[number]
            inside: list[Monomial] = []
            if generator.kind in ("exponential", "growth"):
                inside = [generator.content]
            elif generator.kind == "radical":
                inside = [*generator.content]
            elif generator.kind == "opaque" and generator.content[0] != MEAN:
                inside = [*generator.content[1].numerator, *generator.content[1].denominator]
            self._moves[number] = number == self.turning or any(
                self.moves(g) for monomial in inside for g, _ in monomial
            )
        return self._moves[number]


class _AtAngle(Valuation):
    """The values of forms at one place of the turn."""

    def __init__(self, turn: _Turn, angle: Any) -> None:
        super().__init__(turn.domain, turn.still.point)
        self._turn = turn
        self._values[turn.turning] = angle

    def _check_assumptions(self) -> None:
        for polynomial in self._turn.assumed:
            if self.polynomial(polynomial).real < 0:
                raise NoFormError("a denominator under a root is negative at this point")

    def polynomial(self, polynomial: Polynomial) -> Any:
        """Return the value of a polynomial."""
        total = self.mp.mpc(0)
        for moving, steady in self._turn.grouped(polynomial):
            total += steady * self.monomial(moving)
        return total

    def _power(self, number: int, exponent: int | Fraction) -> Any:
        if not self._turn.moves(number):
            return self._turn.still._power(number, exponent)
        return super()._power(number, exponent)


def sample(
    forms: list[Form], count: int = 3, tries: int = 24, others: Iterable[str] = ()
) -> list[tuple[Point, list[Any]]]:
    """Return up to three points where all forms are defined and real, with their values.

    A point has a value too for each of the `others`, letters that stand in none of the forms.
    """
    names = sorted({name for form in forms for name in letters(form)}.union(others))
    samples = []
    not_reached = 0
    for seed in range(tries):
        point = random_point(names, forms[0].domain, seed)
        valuation = Valuation(forms[0].domain, point)
        try:
            samples.append((point, [valuation.of(form) for form in forms]))
        except MeanNotReachedError:
            not_reached += 1
            if not samples and not_reached == MEANS_TRIED:
                break
        except (NoFormError, KeyError, ZeroDivisionError, ValueError, TypeError, OverflowError):
            continue
        if len(samples) == count:
            break
    return samples
