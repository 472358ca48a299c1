"""Two-sided series of a vector in the plane of the cylinders: parts turning with and against the crank.

The vector is written vertical + i lateral = sum of c_n e^(i n theta), n of both signs. The part +n
turns with the crank and -n against it. Turning the vector by an angle, or delaying the crank by one,
multiplies c_n by one number, so a whole engine is a sum of turned and delayed copies of one cylinder.

From c_n and c_-n follow the real components, C cos n theta + S sin n theta each, held here as the one
number C + iS (its modulus is the amplitude, its argument the phase):

    vertical  conj(c_n) + c_-n            forward   conj(c_n)
    lateral   i (conj(c_n) - c_-n)        backward  c_-n

A number is an `Amplitude` of one of three kinds: exact, with symbols for some angles, or in decimals.

With c_n = c + i C and c_-n = g + i G, and a = n theta, the vertical part is V and the lateral H:

Formulas:
    (c + i C) e^(i a) + (g + i G) e^(-i a) = V + i H
    with V = (c + g) cos a + (G - C) sin a; H = (C + G) cos a + (c - g) sin a;
    c, C, g, G numbers; a an angle
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from symbalance.exact.amplitude import QUARTER, Amplitude
from symbalance.exact.angles import Angle
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.exact_forms import Direction, ExactForm, FromSymPy, RootOfSquares
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.exact.radicals import ZERO_FORM, exact_form, multiple_of_pi, square_root_form
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.text.reals import Complex, Real, atan2, expj, pi

if TYPE_CHECKING:
    import sympy

    from symbalance.document.formula import Formula

COMPONENTS = ("vertical", "lateral", "forward", "backward")
SHOWN = 30
"""Digits of a number that has no exact form."""
MOST_IN_A_SQUARE = 60
"""An amplitude whose square has more terms is written as the root of C^2 + S^2."""
MOST_WRITTEN = 100
"""A number of more terms is written exactly for programs alone: nobody reads a page of cosines."""


@dataclass(frozen=True, eq=False)
class Component:
    """One order of one component: C cos n theta + S sin n theta = amplitude cos(n theta - phase).

    `number` is C + iS. `form` gives each of the four exactly, to be printed; the properties are the same
    as SymPy expressions, computed on first use. With the amplitude R and the phase d:

    Formulas:
        C cos n theta + S sin n theta = R cos(n theta - d)
        C^2 + S^2 = R^2
        with C = R cos d; S = R sin d; R positive; d an angle; n a whole number

    >>> c = Component(Phasor.root(Fraction(1, 3)).scaled(2))
    >>> c.cos, c.sin, c.amplitude, c.phase
    (-1, sqrt(3), 2, 2*pi/3)
    """

    number: Amplitude

    def __getstate__(self) -> dict[str, Amplitude]:
        """Leave out the expressions: SymPy evaluates on unpickling what stands here unevaluated."""
        return {"number": self.number}

    def is_zero(self) -> bool:
        """Tell whether the component is exactly zero."""
        return self.number.is_zero()

    @cached_property
    def is_long(self) -> bool:
        """Whether it is exact, and a sum of more terms than documents write (`MOST_WRITTEN`)."""
        number = self.number
        if not isinstance(number, Phasor) or len(number.terms) <= MOST_WRITTEN:
            return False
        return len(number.normal) > MOST_WRITTEN

    def as_formula(self) -> Formula:
        """Return C cos n theta + S sin n theta as a formula."""
        from symbalance.document.formula import Name, cos, sin

        angle = Name("n") * Name("theta")
        return self.form("cos").as_formula() * cos(angle) + self.form("sin").as_formula() * sin(angle)

    def form(self, name: str) -> ExactForm:
        """Return cos, sin, amplitude or phase as an exact form, of a plain number without SymPy."""
        if name not in self._forms:
            self._forms[name] = _FORMS[name](self)
        return self._forms[name]

    @cached_property
    def _forms(self) -> dict[str, ExactForm]:
        return {}

    @property
    def cos(self) -> sympy.Expr:
        """The coefficient of cos n theta."""
        return self.form("cos").expression()

    @property
    def sin(self) -> sympy.Expr:
        """The coefficient of sin n theta."""
        return self.form("sin").expression()

    @property
    def amplitude(self) -> sympy.Expr:
        """The amplitude, zero or positive; with symbols in it and a fixed phase, so at small angles."""
        return self.form("amplitude").expression()

    @property
    def phase(self) -> sympy.Expr:
        """The phase in (-pi, pi], a fraction of pi or else an unevaluated atan2."""
        return self.form("phase").expression()

    @property
    def phase_in_turns(self) -> Fraction | None:
        """The phase in turns where it is an exact fraction of one, None where it is not."""
        number = self.number
        if isinstance(number, DecimalPhasor):
            return _axis(number)
        if isinstance(number, SymbolicPhasor):
            if self.is_zero():
                return Fraction(0)
            if self.form("sin").is_zero():
                return Fraction(1, 2) if _is_below_zero(number) else Fraction(0)
            if self.form("cos").is_zero():
                return -QUARTER if _is_below_zero(number.rotated(-QUARTER)) else QUARTER
            return None
        return None if self._aligned is None else self._aligned[0]

    @cached_property
    def _aligned(self) -> tuple[Fraction, Phasor] | None:
        """The phase in turns and the amplitude, where the phase is a fraction of a turn."""
        if not isinstance(self.number, Phasor):
            return None
        return turns_and_size(self.number)

    def decimal(self, digits: int = 30) -> tuple[Real, Real]:
        """Return the two coefficients to `digits` significant digits each; symbols are refused."""
        if digits not in self._decimals:
            value = self.number.evaluated(digits)
            self._decimals[digits] = value.real, value.imag
        return self._decimals[digits]

    @cached_property
    def _decimals(self) -> dict[int, tuple[Real, Real]]:
        """What `decimal` has worked out: a table asks several times, until its columns fit."""
        return {}


def _cos(component: Component) -> ExactForm:
    return _real_form(component.number)


def _sin(component: Component) -> ExactForm:
    return _real_form(component.number.rotated(-QUARTER))


def _amplitude(component: Component) -> ExactForm:
    number = component.number
    if isinstance(number, SymbolicPhasor):
        return _symbolic_amplitude(component)
    if isinstance(number, DecimalPhasor):
        return _float(number.size())
    if component._aligned is not None:
        return exact_form(component._aligned[1])
    if component.is_long:
        # Its square takes the square of its terms, and is as good as always longer still.
        return RootOfSquares(component.form("cos"), component.form("sin"))
    square = number.times(number.conjugate())
    if len(square.terms) > MOST_IN_A_SQUARE:
        import sympy

        # SymPy would ask both squares whether they are infinite, and take seconds to know.
        return FromSymPy(sympy.Pow(component.cos**2 + component.sin**2, sympy.S.Half, evaluate=False))
    return square_root_form(square)


def _phase(component: Component) -> ExactForm:
    turns = component.phase_in_turns
    if turns is not None:
        return multiple_of_pi(2 * turns)
    if isinstance(component.number, DecimalPhasor):
        value = component.number.evaluated()
        return _float(atan2(value.imag, value.real))
    return Direction(component.form("cos"), component.form("sin"))


_FORMS: dict[str, Callable[[Component], ExactForm]] = {
    "cos": _cos,
    "sin": _sin,
    "amplitude": _amplitude,
    "phase": _phase,
}


def _real_form(number: Amplitude) -> ExactForm:
    """Return the real part as an exact form."""
    if isinstance(number, Phasor):
        return exact_form(number.real())
    if isinstance(number, DecimalPhasor):
        return _float(number.evaluated().real)
    import sympy

    assert isinstance(number, SymbolicPhasor)
    terms = []
    for symbols, phasor in number.parts.items():
        angle = Angle(Fraction(0), symbols).expression()
        terms.append(exact_form(phasor.real()).expression() * sympy.cos(angle))
        terms.append(-exact_form(phasor.imaginary()).expression() * sympy.sin(angle))
    return FromSymPy(sympy.Add(*terms))


def _float(value: Real) -> ExactForm:
    """Return a number of 40 digits as SymPy writes it, to `SHOWN`; 0 stays a plain 0."""
    if not value:
        return ZERO_FORM
    import sympy

    return FromSymPy(sympy.Float(value, SHOWN))


def _axis(number: DecimalPhasor) -> Fraction | None:
    """Return the direction in turns of a number in decimals that lies on an axis."""
    value = number.evaluated()
    cos, sin = value.real, value.imag
    if not sin:
        return Fraction(0) if cos >= 0 else Fraction(1, 2)
    if not cos:
        return QUARTER if sin > 0 else -QUARTER
    return None


def _symbolic_amplitude(component: Component) -> ExactForm:
    """Return ±C where S is 0, ±S where C is 0, above zero at small angles; else the root of C^2 + S^2."""
    import sympy

    if component.is_zero():
        return ZERO_FORM
    turns = component.phase_in_turns
    if turns is not None:
        return _real_form(component.number.rotated(-turns))
    return FromSymPy(sympy.sqrt(_real_form(component.number.norm()).expression()))


SMALL = Fraction(1, 10_000)
"""Radians of every angle that is a letter, where the sign of an amplitude is chosen."""


def _is_below_zero(number: SymbolicPhasor) -> bool:
    """Tell whether the real part is below zero where all angles that are letters are small.

    There a bank angle is: sin α is an amplitude, and −sin α one with the phase turned by half a turn.
    """
    value = sum(
        (
            phasor.evaluated() * expj(Real(sum(factor for _, factor in symbols) * SMALL))
            for symbols, phasor in number.parts.items()
        ),
        Complex(0),
    )
    return value.real < 0


def turns_and_size(number: Phasor) -> tuple[Fraction, Phasor] | None:
    """Return (turns, amplitude) if the number is a positive real times a root of unity.

    The argument then is a multiple of 1/(4m) turns: the nearest one is tried, and proved or not.
    """
    if number.is_zero():
        return Fraction(0), ZERO
    steps = 4 * number.modulus
    value = number.evaluated(15)
    argument = atan2(value.imag, value.real) / (2 * pi(20))
    turns = Fraction(round(argument * steps), steps)
    amplitude = number.rotated(-turns)
    if not amplitude.imaginary().is_zero():
        return None
    return (turns + 1 if turns <= Fraction(-1, 2) else turns), amplitude.real()


@dataclass(frozen=True)
class Spectrum:
    """The orders of a vector in the plane: `terms` maps +n and -n to c_n; vanishing orders are absent."""

    terms: Mapping[int, Amplitude] = field(hash=False)
    _components: dict[tuple[object, object, str], Component] = field(
        default_factory=dict, init=False, compare=False, repr=False
    )

    @staticmethod
    def of(terms: Mapping[int, Amplitude]) -> Spectrum:
        """Return the spectrum of the terms that are not zero."""
        return Spectrum({n: c for n, c in terms.items() if not c.is_zero()})

    def orders(self) -> list[int]:
        """Return the orders n > 0 present with either sign."""
        return sorted({abs(n) for n in self.terms})

    def rotated(self, turns: Fraction) -> Spectrum:
        """Return the vector turned by so many turns, in the sense of rotation."""
        return Spectrum({n: c.rotated(turns) for n, c in self.terms.items()})

    def delayed(self, turns: Fraction) -> Spectrum:
        """Return the vector delayed by so many turns of the crank.

        Formulas:
            e^(i n (theta - d)) = e^(-i n d) e^(i n theta)
            with n a whole number; d an angle
        """
        return Spectrum({n: c.rotated(-n * turns) for n, c in self.terms.items()})

    def scaled(self, factor: int | Fraction) -> Spectrum:
        """Return the vector times a rational."""
        return Spectrum.of({n: c.scaled(factor) for n, c in self.terms.items()})

    def __add__(self, other: Spectrum) -> Spectrum:
        total = dict(self.terms)
        for n, number in other.terms.items():
            if n not in total:
                total[n] = number
                continue
            both = total.pop(n) + number
            if not both.is_zero():  # one alone was not
                total[n] = both
        return Spectrum(total)

    def component(self, order: int, name: str) -> Component:
        """Return the vertical, lateral, forward or backward component of an order.

        Orders whose numbers are written alike (n and n + m often are) share their components, and the
        work in them.
        """
        forward, backward = self.terms.get(order, ZERO), self.terms.get(-order, ZERO)
        key = (forward.spelling, backward.spelling, name)
        component = self._components.get(key)
        if component is None:  # of two threads that come here at once, both get the one that is kept
            component = self._components.setdefault(key, _component(forward, backward, name))
        return component


def _component(forward: Amplitude, backward: Amplitude, name: str) -> Component:
    forward = forward.conjugate()
    match name:
        case "vertical":
            return Component(forward + backward)
        case "lateral":
            return Component((forward - backward).rotated(QUARTER))
        case "forward":
            return Component(forward)
        case "backward":
            return Component(backward)
    raise KeyError(name)
