"""Products and comparisons of the numbers spectra hold, whichever of the three kinds they are."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp

from symbalance.errors import SymbalanceError
from symbalance.exact.angles import Angle
from symbalance.exact.decimal_phasor import DIGITS, DecimalPhasor
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.exact.spectrum import Component, Number, SymbolicPhasor
from symbalance.text.numbers import Real

FINEST = 10_000
"""The largest denominator of a ratio that is looked for."""


def product(left: Number, right: Number) -> Number:
    """Return the product of two numbers.

    >>> product(Phasor.root(Fraction(1, 8)), Phasor.root(Fraction(-1, 8))).rational()
    Fraction(1, 1)
    """
    if isinstance(left, DecimalPhasor) or isinstance(right, DecimalPhasor):
        with mp.workdps(DIGITS):
            return DecimalPhasor(decimal(left) * decimal(right))
    if isinstance(left, Phasor) and isinstance(right, Phasor):
        return left.times(right)
    total = SymbolicPhasor({})
    for one, p in _parts(left).items():
        for other, q in _parts(right).items():
            symbols = (Angle(Fraction(0), one) + Angle(Fraction(0), other)).symbols
            total = total + SymbolicPhasor.of({symbols: p.times(q)})
    return total


def _parts(number: Phasor | SymbolicPhasor) -> dict:
    return dict(number.parts) if isinstance(number, SymbolicPhasor) else {(): number}


def summed(numbers: list[Number]) -> Number:
    """Return the sum of numbers; of none it is 0."""
    total: Number = ZERO
    for number in numbers:
        total = added(total, number)
    return total


def norm(number: Number) -> Number:
    """Return a number times its conjugate."""
    return product(number, number.conjugate())


def real_part(number: Number) -> Number:
    """Return the real part, as a number with no other."""
    return added(number, number.conjugate()).scaled(Fraction(1, 2))


def imaginary_part(number: Number) -> Number:
    """Return the imaginary part, as a real number."""
    return real_part(number.turned(Fraction(-1, 4)))


def size_of(number: Number) -> Real:
    """Return the absolute value of a number without symbols, in decimals."""
    with mp.workdps(DIGITS):
        return abs(decimal(number))


def station_of(force: Number, couple: Number) -> Fraction | None:
    """Return the arm z with couple = z force, if it is a fraction: a weight there does for both.

    The nearest fraction is tried and proved; what cannot be proved is None.

    >>> up = Phasor.root(Fraction(0))
    >>> station_of(up.scaled(2), up.scaled(3)), station_of(up, up.turned(Fraction(1, 4)))
    (Fraction(3, 2), None)
    """
    if force.is_zero():
        return None
    if couple.is_zero():
        return Fraction(0)
    if isinstance(force, SymbolicPhasor) or isinstance(couple, SymbolicPhasor):
        return None
    with mp.workdps(DIGITS):
        ratio = decimal(couple) / decimal(force)
        near = Fraction(int(mp.nint(ratio.real * 10**15)), 10**15).limit_denominator(FINEST)
    return near if added(couple, -force.scaled(near)).is_zero() else None


def quotient(above: Number, below: Number):
    """Return the quotient of two real numbers as a SymPy expression, a rational if it is one.

    >>> quotient(Phasor.of(1, {0: 3}), Phasor.of(1, {0: 6}))
    1/2
    """
    import sympy

    found = station_of(below, above)
    if found is not None:
        return sympy.Rational(found.numerator, found.denominator)
    return Component(above).cos / Component(below).cos


LEAST = 25
"""A sum of decimals this many digits below its parts is 0: files hold 30 digits."""


def added(left: Number, right: Number) -> Number:
    """Return the sum of two numbers of any kinds; decimals that cancel to their rounding are 0."""
    if isinstance(left, DecimalPhasor) or isinstance(right, DecimalPhasor):
        pair = [n.value if isinstance(n, DecimalPhasor) else decimal(n) for n in (left, right)]
        with mp.workdps(DIGITS):
            total = pair[0] + pair[1]
            gone = abs(total) <= mp.mpf(10) ** -LEAST * (abs(pair[0]) + abs(pair[1]))
            return DecimalPhasor(mp.mpc(0) if gone else total)
    if isinstance(left, SymbolicPhasor) or isinstance(right, SymbolicPhasor):
        both = [n if isinstance(n, SymbolicPhasor) else SymbolicPhasor.of({(): n}) for n in (left, right)]
        return both[0] + both[1]
    return left + right


def decimal(number: Number) -> Real:
    """Return a number of an exact field, or of decimals, as a complex one of `DIGITS` digits."""
    from symbalance.exact.radicals import evaluated

    if isinstance(number, DecimalPhasor):
        return number.value
    if isinstance(number, SymbolicPhasor) and set(number.parts) <= {()}:
        number = number.parts.get((), ZERO)  # the symbols have gone
    if isinstance(number, SymbolicPhasor):
        rule, remedy = "holds symbols, and has no decimal value", "give the angles in numbers"
        raise SymbalanceError("an angle", rule, remedy)
    with mp.workdps(DIGITS + 5):
        return mp.mpc(evaluated(number.real(), DIGITS), evaluated(number.imaginary(), DIGITS))
