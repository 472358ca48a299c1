"""Real and complex numbers of many digits, each of which carries its own precision.

There is no working precision to set, so that neither a caller's settings nor another thread can change
a result. The rule for how many digits a result has:

    of two numbers it has the precision of the more precise one;
    ints, Fractions, floats and numbers of mpmath are exact operands: they have no say;
    a function's value has the precision of its argument, or of the `digits` it is given.

Every operation rounds once, to nearest. Values are mpmath's own (`libmp`) and show themselves as such
(`_mpf_`, `_mpc_`), so that mpmath, SymPy and NumPy take them for theirs.
"""

from __future__ import annotations

import numbers
import threading
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from operator import index
from typing import Any, Self, overload

import mpmath.libmp
from mpmath.ctx_mp import MPContext

libmp: Any = mpmath.libmp  # which has no types

DIGITS = 40
"""Significant digits a number carries unless it is given others."""
CONSTANT_BITS = 8192
"""pi and log 2 are computed to so many bits, 2400 digits, at once and before any thread asks for them:
while libmp extends its store of a constant, another thread that reads it can get a wrong value."""
TURN_GUARD = 16
"""Bits to which a fraction of a turn is held beyond those of its sine."""

Exact = int | Fraction | float
"""What stands beside a number as an exact operand."""
_Raw = tuple[int, int, int, int]

_ZERO: _Raw = libmp.fzero
_new, _nearest = object.__new__, "n"
_add, _subtract, _multiply, _divide = libmp.mpf_add, libmp.mpf_sub, libmp.mpf_mul, libmp.mpf_div

libmp.pi_fixed(CONSTANT_BITS)
libmp.ln2_fixed(CONSTANT_BITS)


def bits_of(digits: int) -> int:
    """Return the bits that hold so many significant digits.

    >>> bits_of(15), bits_of(40)
    (53, 136)
    """
    return int(libmp.dps_to_prec(digits))


def digits_of(bits: int) -> int:
    """Return the significant digits that need so many bits, or a few more.

    >>> bits_of(digits_of(500)) >= 500
    True
    """
    return int(libmp.prec_to_dps(bits)) + 2


class Real:
    """A real number of a given number of digits, rounded once: Real(Fraction(1, 3), 30).

    `value` is an int, a Fraction, a float, text such as "0.1", or a number of mpmath, SymPy or NumPy;
    without `digits` a Real stays as it is, and others get `DIGITS`. `bits` is the precision carried.

    >>> Real(1, 20) / 3
    Real('0.33333333333333333333', 20)
    >>> Real(1, 5) / 3 + Real(1, 10)  # the more precise number says how many digits there are
    Real('1.333333492', 10)
    >>> Real("0.5") == Fraction(1, 2), float(Real(2).__rpow__(2)), round(Real("2.5"))
    (True, 4.0, 2)
    """

    __slots__ = ("_mpf_", "bits")
    _mpf_: _Raw
    bits: int

    def __new__(cls, value: Any = 0, digits: int | None = None) -> Self:  # noqa: D102
        if type(value) is cls and digits is None:
            return value
        bits = bits_of(DIGITS if digits is None else digits)
        if isinstance(value, str):
            return _real(libmp.from_str(value, bits, _nearest), bits)  # type: ignore[return-value]
        raw = _raw(value)
        if raw is None:
            pair = _quotient(value)
            if pair is None:
                raise TypeError(f"{value!r} is no real number")
            return _real(_divide(*pair, bits, _nearest), bits)  # type: ignore[return-value]
        return _real(libmp.mpf_pos(raw, bits, _nearest), bits)  # type: ignore[return-value]

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{name}: a number does not change")

    def __reduce__(self) -> tuple[Any, ...]:
        sign, mantissa, exponent, size = self._mpf_
        return _unpickled_real, (sign, int(mantissa), exponent, size, self.bits)

    def __copy__(self) -> Real:
        return self

    def __deepcopy__(self, memo: object) -> Real:
        return self

    @property
    def digits(self) -> int:
        """The significant decimal digits that the precision holds."""
        return int(libmp.prec_to_dps(self.bits))

    def rounded(self, digits: int) -> Real:
        """Return the number rounded to so many digits, or, if they are more, held to them."""
        bits = bits_of(digits)
        return _real(libmp.mpf_pos(self._mpf_, bits, _nearest), bits)

    def __repr__(self) -> str:
        return f"Real({str(self)!r}, {self.digits})"

    def __str__(self) -> str:
        return nstr(self, self.digits)

    def __hash__(self) -> int:
        return int(libmp.mpf_hash(self._mpf_))

    def __bool__(self) -> bool:
        return self._mpf_ != _ZERO

    def __float__(self) -> float:
        return float(libmp.to_float(self._mpf_, rnd=_nearest))

    def __complex__(self) -> complex:
        return complex(float(self))

    def __int__(self) -> int:
        return int(libmp.to_int(self._mpf_))

    __trunc__ = __int__

    def __floor__(self) -> int:
        return int(libmp.to_int(self._mpf_, "f"))

    def __ceil__(self) -> int:
        return int(libmp.to_int(self._mpf_, "c"))

    def __round__(self, places: int | None = None) -> Any:
        return int(libmp.to_int(self._mpf_, "n")) if places is None else round(float(self), places)

    def _sympy_(self) -> Any:
        import sympy

        return sympy.Float(self._mpf_, precision=self.bits)

    @property
    def real(self) -> Real:
        """The number itself."""
        return self

    @property
    def imag(self) -> Real:
        """0."""
        return _real(_ZERO, self.bits)

    def conjugate(self) -> Real:
        """Return the number itself."""
        return self

    def __pos__(self) -> Real:
        return self

    def __neg__(self) -> Real:
        return _real(libmp.mpf_neg(self._mpf_), self.bits)

    def __abs__(self) -> Real:
        return _real(libmp.mpf_abs(self._mpf_), self.bits)

    def __add__(self, other: Exact | Real) -> Real:
        if type(other) is Real:
            bits = self.bits if self.bits >= other.bits else other.bits
            return _real(_add(self._mpf_, other._mpf_, bits, _nearest), bits)
        if (raw := _raw(other)) is not None:
            return _real(_add(self._mpf_, raw, self.bits, _nearest), self.bits)
        if (pair := _quotient(other)) is not None:
            above = _add(_multiply(self._mpf_, pair[1]), pair[0])
            return _real(_divide(above, pair[1], self.bits, _nearest), self.bits)
        return _in_plane(self, other, "__add__")

    __radd__ = __add__

    def __sub__(self, other: Exact | Real) -> Real:
        if type(other) is Real:
            bits = self.bits if self.bits >= other.bits else other.bits
            return _real(_subtract(self._mpf_, other._mpf_, bits, _nearest), bits)
        if (raw := _raw(other)) is not None:
            return _real(_subtract(self._mpf_, raw, self.bits, _nearest), self.bits)
        if (pair := _quotient(other)) is not None:
            above = _subtract(_multiply(self._mpf_, pair[1]), pair[0])
            return _real(_divide(above, pair[1], self.bits, _nearest), self.bits)
        return _in_plane(self, other, "__sub__")

    def __rsub__(self, other: Exact) -> Real:
        return (-self).__add__(other)

    def __mul__(self, other: Exact | Real) -> Real:
        if type(other) is Real:
            bits = self.bits if self.bits >= other.bits else other.bits
            return _real(_multiply(self._mpf_, other._mpf_, bits, _nearest), bits)
        if (raw := _raw(other)) is not None:
            return _real(_multiply(self._mpf_, raw, self.bits, _nearest), self.bits)
        if (pair := _quotient(other)) is not None:
            above = _multiply(self._mpf_, pair[0])
            return _real(_divide(above, pair[1], self.bits, _nearest), self.bits)
        return _in_plane(self, other, "__mul__")

    __rmul__ = __mul__

    def __truediv__(self, other: Exact | Real) -> Real:
        if type(other) is Real:
            bits = self.bits if self.bits >= other.bits else other.bits
            return _real(_divide(self._mpf_, other._mpf_, bits, _nearest), bits)
        if (raw := _raw(other)) is not None:
            return _real(_divide(self._mpf_, raw, self.bits, _nearest), self.bits)
        if (pair := _quotient(other)) is not None:
            above = _multiply(self._mpf_, pair[1])
            return _real(_divide(above, pair[0], self.bits, _nearest), self.bits)
        return _in_plane(self, other, "__truediv__")

    def __rtruediv__(self, other: Exact) -> Real:
        if (raw := _raw(other)) is not None:
            return _real(_divide(raw, self._mpf_, self.bits, _nearest), self.bits)
        if (pair := _quotient(other)) is not None:
            below = _multiply(self._mpf_, pair[1])
            return _real(_divide(pair[0], below, self.bits, _nearest), self.bits)
        return _in_plane(self, other, "__rtruediv__")

    def __mod__(self, other: Exact | Real) -> Real:
        by = other if type(other) is Real else Real(other, self.digits)
        bits = max(self.bits, by.bits)
        return _real(libmp.mpf_mod(self._mpf_, by._mpf_, bits, _nearest), bits)

    def __pow__(self, other: Exact | Real) -> Real:
        """Return a power; ValueError where a negative number has no real one."""
        if type(other) is int:
            return _real(libmp.mpf_pow_int(self._mpf_, other, self.bits, _nearest), self.bits)
        if type(other) is Fraction and other.denominator == 1:
            return self.__pow__(other.numerator)
        if not isinstance(other, Exact | Real):
            return NotImplemented
        by = other if type(other) is Real else Real(other, self.digits + 5)
        bits = max(self.bits, by.bits) if type(other) is Real else self.bits
        return _real(libmp.mpf_pow(self._mpf_, by._mpf_, bits, _nearest), bits)

    def __rpow__(self, other: Exact) -> Real:
        return Real(other, self.digits).__pow__(self)

    def __eq__(self, other: object) -> bool:
        if type(other) is Real:
            return self._mpf_ == other._mpf_
        sign = _compared(self._mpf_, other)
        return NotImplemented if sign is None else sign == 0

    def __lt__(self, other: Exact | Real) -> bool:
        sign = _compared(self._mpf_, other)
        return NotImplemented if sign is None else sign < 0

    def __le__(self, other: Exact | Real) -> bool:
        sign = _compared(self._mpf_, other)
        return NotImplemented if sign is None else sign <= 0

    def __gt__(self, other: Exact | Real) -> bool:
        sign = _compared(self._mpf_, other)
        return NotImplemented if sign is None else sign > 0

    def __ge__(self, other: Exact | Real) -> bool:
        sign = _compared(self._mpf_, other)
        return NotImplemented if sign is None else sign >= 0


class Complex:
    """A complex number of given precision, from real and imaginary parts or another complex number.

    Without `digits` it has those of the more precise part that carries any, or else `DIGITS`.

    >>> z = Complex(1, Real(2, 20))
    >>> z * z, abs(Complex(3, 4, 20)), z.conjugate()
    (Complex('(-3.0 + 4.0j)', 20), Real('5.0', 20), Complex('(1.0 - 2.0j)', 20))
    """

    __slots__ = ("_mpc_", "bits")
    _mpc_: tuple[_Raw, _Raw]
    bits: int

    def __new__(cls, real: Any = 0, imag: Any = 0, digits: int | None = None) -> Self:  # noqa: D102
        if type(real) is cls and digits is None:
            return real
        if isinstance(real, complex) or hasattr(real, "_mpc_"):
            digits = real.digits if digits is None and isinstance(real, Complex) else digits
            real, imag = real.real, real.imag
        if digits is None:
            carried = [x.bits for x in (real, imag) if type(x) is Real]
            bits = max(carried, default=bits_of(DIGITS))
            digits = int(libmp.prec_to_dps(bits))
        else:
            bits = bits_of(digits)
        parts = (x if type(x) is Real else Real(x, digits) for x in (real, imag))
        raw = tuple(libmp.mpf_pos(x._mpf_, bits, _nearest) for x in parts)
        return _complex(raw, bits)  # type: ignore[return-value, arg-type]

    def __setattr__(self, name: str, value: Any) -> None:
        if name != "_mpc_" or hasattr(self, "bits"):
            raise AttributeError(f"{name}: a number does not change")
        # A number of mpmath times one of these fills in a new one of these: with all digits it has.
        _set_mpc(self, value)
        _set_complex_bits(self, max(bits_of(DIGITS), *(part[3] for part in value)))

    def __reduce__(self) -> tuple[Any, ...]:
        return Complex._unpickled, (self.real, self.imag)

    @staticmethod
    def _unpickled(real: Real, imag: Real) -> Complex:
        return _complex((real._mpf_, imag._mpf_), real.bits)

    def __copy__(self) -> Complex:
        return self

    def __deepcopy__(self, memo: object) -> Complex:
        return self

    @property
    def digits(self) -> int:
        """The significant decimal digits that the precision holds."""
        return int(libmp.prec_to_dps(self.bits))

    def rounded(self, digits: int) -> Complex:
        """Return the number with parts rounded to so many digits, or, if they are more, held to them."""
        bits = bits_of(digits)
        return _complex(libmp.mpc_pos(self._mpc_, bits, _nearest), bits)

    def __repr__(self) -> str:
        return f"Complex({str(self)!r}, {self.digits})"

    def __str__(self) -> str:
        return nstr(self, self.digits)

    def __hash__(self) -> int:
        return int(libmp.mpc_hash(self._mpc_))

    def __bool__(self) -> bool:
        return self._mpc_ != (_ZERO, _ZERO)

    def __complex__(self) -> complex:
        return complex(float(self.real), float(self.imag))

    def _sympy_(self) -> Any:
        import sympy

        return sympy.Add(self.real._sympy_(), sympy.I * self.imag._sympy_())

    @property
    def real(self) -> Real:
        """The real part."""
        return _real(self._mpc_[0], self.bits)

    @property
    def imag(self) -> Real:
        """The imaginary part."""
        return _real(self._mpc_[1], self.bits)

    def conjugate(self) -> Complex:
        """Return the complex conjugate."""
        return _complex((self._mpc_[0], libmp.mpf_neg(self._mpc_[1])), self.bits)

    def __pos__(self) -> Complex:
        return self

    def __neg__(self) -> Complex:
        return _complex(libmp.mpc_neg(self._mpc_), self.bits)

    def __abs__(self) -> Real:
        return _real(libmp.mpc_abs(self._mpc_, self.bits, _nearest), self.bits)

    def __add__(self, other: Operand) -> Complex:
        by = _as_complex(other, self.bits)
        if by is None:
            return NotImplemented
        bits = self.bits if self.bits >= by.bits else by.bits
        return _complex(libmp.mpc_add(self._mpc_, by._mpc_, bits, _nearest), bits)

    __radd__ = __add__

    def __sub__(self, other: Operand) -> Complex:
        by = _as_complex(other, self.bits)
        if by is None:
            return NotImplemented
        bits = self.bits if self.bits >= by.bits else by.bits
        return _complex(libmp.mpc_sub(self._mpc_, by._mpc_, bits, _nearest), bits)

    def __rsub__(self, other: Operand) -> Complex:
        return (-self).__add__(other)

    def __mul__(self, other: Operand) -> Complex:
        if isinstance(other, Complex):
            bits = self.bits if self.bits >= other.bits else other.bits
            return _complex(libmp.mpc_mul(self._mpc_, other._mpc_, bits, _nearest), bits)
        if isinstance(other, int):
            return _complex(libmp.mpc_mul_int(self._mpc_, other, self.bits, _nearest), self.bits)
        if isinstance(other, complex) or hasattr(other, "_mpc_"):
            return self * _exact_complex(other)
        return _scaled(self, other, Real.__mul__)

    __rmul__ = __mul__

    def __truediv__(self, other: Operand) -> Complex:
        if isinstance(other, Complex):
            bits = self.bits if self.bits >= other.bits else other.bits
            return _complex(libmp.mpc_div(self._mpc_, other._mpc_, bits, _nearest), bits)
        if isinstance(other, complex) or hasattr(other, "_mpc_"):
            return self / _exact_complex(other)
        return _scaled(self, other, Real.__truediv__)

    def __rtruediv__(self, other: Operand) -> Complex:
        by = _as_complex(other, self.bits)
        if by is None:
            return NotImplemented
        bits = max(self.bits, by.bits)
        return _complex(libmp.mpc_div(by._mpc_, self._mpc_, bits, _nearest), bits)

    def __pow__(self, other: int) -> Complex:
        if type(other) is not int:
            return NotImplemented
        return _complex(libmp.mpc_pow_int(self._mpc_, other, self.bits, _nearest), self.bits)

    def __eq__(self, other: object) -> bool:
        if type(other) is Complex:
            return self._mpc_ == other._mpc_
        if isinstance(other, complex) or hasattr(other, "_mpc_"):
            return self.real == other.real and self.imag == other.imag  # type: ignore[union-attr]
        real = self.real.__eq__(other)
        return real if real is NotImplemented else real and self._mpc_[1] == _ZERO


Operand = Exact | Real | complex | Complex

numbers.Real.register(Real)
numbers.Complex.register(Complex)

_set_mpf, _set_bits = Real._mpf_.__set__, Real.bits.__set__  # type: ignore[attr-defined]
_set_mpc, _set_complex_bits = Complex._mpc_.__set__, Complex.bits.__set__  # type: ignore[attr-defined]


def _real(raw: _Raw, bits: int) -> Real:
    """Return a number of a value that is rounded already."""
    number = _new(Real)
    _set_mpf(number, raw)
    _set_bits(number, bits)
    return number


def _complex(raw: tuple[_Raw, _Raw], bits: int) -> Complex:
    number = _new(Complex)
    _set_mpc(number, raw)
    _set_complex_bits(number, bits)
    return number


def _unpickled_real(sign: int, mantissa: int, exponent: int, size: int, bits: int) -> Real:
    return _real((sign, libmp.MPZ(mantissa), exponent, size), bits)


def _raw(value: Any) -> _Raw | None:
    """Return the exact value of an operand that is a whole number times a power of 2, else None."""
    if isinstance(value, int):
        return libmp.from_int(value)
    if isinstance(value, float):
        return libmp.from_float(value)
    if isinstance(value, Fraction):
        return libmp.from_int(value.numerator) if value.denominator == 1 else None
    if hasattr(value, "_mpf_"):
        return value._mpf_
    return libmp.from_int(index(value)) if isinstance(value, numbers.Integral) else None


def _quotient(value: Any) -> tuple[_Raw, _Raw] | None:
    """Return the numerator and the denominator of a rational operand, else None."""
    if type(value) is Fraction or isinstance(value, numbers.Rational):
        return libmp.from_int(int(value.numerator)), libmp.from_int(int(value.denominator))
    above, below = getattr(value, "p", None), getattr(value, "q", None)
    if isinstance(above, int) and isinstance(below, int):  # a SymPy rational
        return libmp.from_int(above), libmp.from_int(below)
    return None


def _in_plane(number: Real, other: Any, operation: str) -> Any:
    """Return what a number and a Python complex give: a complex number."""
    if isinstance(other, complex):
        return getattr(_complex((number._mpf_, _ZERO), number.bits), operation)(other)
    return NotImplemented


def _as_complex(value: Any, bits: int) -> Complex | None:
    """Return an operand as a complex number, exact ones with no say in the precision."""
    if isinstance(value, Complex):
        return value
    if isinstance(value, Real):
        return _complex((value._mpf_, _ZERO), value.bits)
    if isinstance(value, complex) or hasattr(value, "_mpc_"):
        return _exact_complex(value)
    raw, pair = _raw(value), _quotient(value)
    if raw is None and pair is not None:  # held well beyond the other number's last digit
        raw = _divide(*pair, 2 * bits, _nearest)
    return None if raw is None else _complex((raw, _ZERO), 0)


def _exact_complex(value: Any) -> Complex:
    """Return a complex number of Python or mpmath as an operand with no say in the precision."""
    if isinstance(value, complex):
        return _complex((libmp.from_float(value.real), libmp.from_float(value.imag)), 0)
    return _complex(value._mpc_, 0)


def _scaled(number: Complex, other: Any, operation: Callable[[Real, Any], Real]) -> Complex:
    """Return a complex number times, or over, a real operand."""
    real = operation(number.real, other)
    if real is NotImplemented:
        return NotImplemented
    return _complex((real._mpf_, operation(number.imag, other)._mpf_), real.bits)


def _compared(raw: _Raw, other: Any) -> int | None:
    """Return the sign of a number less another, exactly; None where they do not compare."""
    if type(other) is Real:
        return int(libmp.mpf_cmp(raw, other._mpf_))
    if (exact := _raw(other)) is not None:
        return int(libmp.mpf_cmp(raw, exact))
    if (pair := _quotient(other)) is not None:
        return int(libmp.mpf_cmp(_multiply(raw, pair[1]), pair[0]))
    return None


def _argument(x: Any, digits: int | None) -> tuple[_Raw, int]:
    """Return a function's argument and the precision of its value."""
    if type(x) is Real:
        return x._mpf_, x.bits if digits is None else bits_of(digits)
    number = Real(x, digits)
    return number._mpf_, number.bits


def _function(of_real: Callable[..., _Raw], x: Any, digits: int | None) -> Real:
    raw, bits = _argument(x, digits)
    return _real(of_real(raw, bits, _nearest), bits)


def sqrt(x: Exact | Real, digits: int | None = None) -> Real:
    """Return the square root; of a negative number ValueError.

    >>> sqrt(2, 20)
    Real('1.4142135623730950488', 20)
    """
    return _function(libmp.mpf_sqrt, x, digits)


def exp(x: Exact | Real, digits: int | None = None) -> Real:
    """Return e^x."""
    return _function(libmp.mpf_exp, x, digits)


def log(x: Exact | Real, digits: int | None = None) -> Real:
    """Return the natural logarithm; of a negative number ValueError."""
    return _function(libmp.mpf_log, x, digits)


def sin(x: Exact | Real, digits: int | None = None) -> Real:
    """Return the sine of an angle in radians."""
    return _function(libmp.mpf_sin, x, digits)


def cos(x: Exact | Real, digits: int | None = None) -> Real:
    """Return the cosine of an angle in radians."""
    return _function(libmp.mpf_cos, x, digits)


def tan(x: Exact | Real, digits: int | None = None) -> Real:
    """Return the tangent of an angle in radians."""
    return _function(libmp.mpf_tan, x, digits)


def asin(x: Exact | Real, digits: int | None = None) -> Real:
    """Return the angle in radians within a quarter turn of 0 that has a sine; beyond 1 ValueError."""
    return _function(libmp.mpf_asin, x, digits)


def atan2(y: Real, x: Real) -> Real:
    """Return the angle of the point (x, y) in radians, in (-pi, pi]."""
    bits = max(y.bits, x.bits)
    return _real(libmp.mpf_atan2(y._mpf_, x._mpf_, bits, _nearest), bits)


def hypot(x: Real, y: Real) -> Real:
    """Return sqrt(x^2 + y^2)."""
    bits = max(x.bits, y.bits)
    return _real(libmp.mpf_hypot(x._mpf_, y._mpf_, bits, _nearest), bits)


def expj(x: Exact | Real, digits: int | None = None) -> Complex:
    """Return e^(ix) for an angle in radians."""
    raw, bits = _argument(x, digits)
    return _complex(libmp.mpf_cos_sin(raw, bits, _nearest), bits)


def expjpi(x: Exact | Real, digits: int | None = None) -> Complex:
    """Return e^(i pi x); a fraction is taken exactly.

    >>> expjpi(Fraction(1, 2), 15), expjpi(Fraction(10**40 + 1, 3), 15)
    (Complex('(0.0 + 1.0j)', 15), Complex('(0.5 - 0.866025403784439j)', 15))
    """
    raw, bits = _half_turns(x, digits)
    return _complex(libmp.mpf_cos_sin_pi(raw, bits, _nearest), bits)


def cospi(x: Exact | Real, digits: int | None = None) -> Real:
    """Return cos(pi x); a fraction is taken exactly."""
    raw, bits = _half_turns(x, digits)
    return _real(libmp.mpf_cos_pi(raw, bits, _nearest), bits)


def sinpi(x: Exact | Real, digits: int | None = None) -> Real:
    """Return sin(pi x); a fraction is taken exactly."""
    raw, bits = _half_turns(x, digits)
    return _real(libmp.mpf_sin_pi(raw, bits, _nearest), bits)


def _half_turns(x: Any, digits: int | None) -> tuple[_Raw, int]:
    if type(x) is Fraction or type(x) is int:
        bits = bits_of(DIGITS if digits is None else digits)
        return libmp.from_rational(
            x.numerator % (2 * x.denominator), x.denominator, bits + TURN_GUARD, _nearest
        ), bits
    return _argument(x, digits)


def pi(digits: int = DIGITS) -> Real:
    """Return pi.

    >>> pi(20)
    Real('3.1415926535897932385', 20)
    """
    bits = bits_of(digits)
    return _real(libmp.mpf_pi(bits, _nearest), bits)


def fsum(values: Iterable[Exact | Real], digits: int | None = None) -> Real:
    """Return a sum, rounded once, to the precision of its most precise term, or to `digits`.

    >>> fsum([Real(1), Real(10) ** 50, -Real(10) ** 50])
    Real('1.0', 40)
    """
    terms = [x if type(x) is Real else Real(x, digits) for x in values]
    bits = max((x.bits for x in terms), default=bits_of(DIGITS)) if digits is None else bits_of(digits)
    return _real(libmp.mpf_sum([x._mpf_ for x in terms], bits, _nearest), bits)


def csum(values: Iterable[Complex]) -> Complex:
    """Return a sum, each part rounded once, to the precision of the most precise term."""
    terms = list(values)
    bits = max((z.bits for z in terms), default=bits_of(DIGITS))
    parts = (libmp.mpf_sum([z._mpc_[i] for z in terms], bits, _nearest) for i in (0, 1))
    return _complex(tuple(parts), bits)  # type: ignore[arg-type]


def fdot(reals: Iterable[Real], numbers: Iterable[Complex]) -> Complex:
    """Return the sum of products of real and complex numbers, rounded once."""
    pairs = list(zip(reals, numbers, strict=False))
    bits = max((max(x.bits, z.bits) for x, z in pairs), default=bits_of(DIGITS))
    parts = (
        libmp.mpf_sum([_multiply(x._mpf_, z._mpc_[i]) for x, z in pairs], bits, _nearest) for i in (0, 1)
    )
    return _complex(tuple(parts), bits)  # type: ignore[arg-type]


@overload
def nint(x: Real) -> Real: ...
@overload
def nint(x: Fraction) -> int: ...
def nint(x: Real | Fraction) -> Real | int:
    """Return the nearest whole number, of two the even one."""
    if type(x) is Real:
        return _real(libmp.mpf_nint(x._mpf_, x.bits, _nearest), x.bits)
    return round(x)  # type: ignore[return-value]


def ldexp(x: Exact | Real, power: int) -> Real:
    """Return x 2^power, exactly."""
    number = x if type(x) is Real else Real(x)
    return _real(libmp.mpf_shift(number._mpf_, power), number.bits)


def fixed(x: Real, bits: int) -> int:
    """Return x in units of 2^-bits, as a whole number cut towards 0."""
    return int(libmp.to_int(libmp.mpf_shift(x._mpf_, bits)))


def nstr(value: Any, digits: int = 6, **layout: Any) -> str:
    """Return a number of any kind here, or of mpmath, to so many significant digits.

    `layout` is mpmath's: min_fixed, max_fixed, strip_zeros, show_zero_exponent.

    >>> nstr(Real(1) / 3, 5), nstr(Complex(1, -2), 5)
    ('0.33333', '(1.0 - 2.0j)')
    """
    if hasattr(value, "_mpc_"):
        return f"({libmp.mpc_to_str(value._mpc_, digits, **layout)})"
    number = value if hasattr(value, "_mpf_") else Real(value)
    return str(libmp.to_str(number._mpf_, digits, **layout))


_own = threading.local()
"""Of each thread the mpmath contexts that nobody else holds."""


def own_context(digits: int) -> Any:
    """Return this thread's own mpmath context of so many digits, for functions that only mpmath has.

    Its numbers stay in the thread, and in the function that asks for them.
    """
    contexts = _own.__dict__.setdefault("contexts", {})
    if digits not in contexts:
        contexts[digits] = MPContext()
        contexts[digits].dps = digits
    return contexts[digits]


def _by_mpmath(name: str, bits: int, *arguments: Any) -> Any:
    """Return what one of mpmath's larger functions says, computed in this thread's own context."""
    if not hasattr(_own, "larger"):
        _own.larger = MPContext()
    context = _own.larger
    before, context.prec = context.prec, bits
    try:
        return _converted(getattr(context, name)(*arguments), bits)
    finally:
        context.prec = before


def _converted(value: Any, bits: int) -> Any:
    if hasattr(value, "_mpf_"):
        return _real(libmp.mpf_pos(value._mpf_, bits, _nearest), bits)
    if hasattr(value, "_mpc_"):
        return _complex(libmp.mpc_pos(value._mpc_, bits, _nearest), bits)
    return [_converted(x, bits) for x in value]


def hyp2f1(a: Exact, b: Exact, c: Exact, z: Real) -> Real:
    """Return Gauss's hypergeometric function for parameters that a double holds."""
    return _by_mpmath("hyp2f1", z.bits, float(a), float(b), float(c), z)


def ellipe(parameter: Real) -> Real:
    """Return the complete elliptic integral of the second kind E(m)."""
    return _by_mpmath("ellipe", parameter.bits, parameter)


def solve(rows: Sequence[Sequence[Real]], right: Sequence[Real]) -> list[Real]:
    """Return the solution of a square system of linear equations."""
    bits = max(x.bits for x in right)
    return _by_mpmath("lu_solve", bits, [list(row) for row in rows], list(right))
