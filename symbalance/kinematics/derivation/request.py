"""The checked request for a derivation: quantity, order, convention; and the letters it uses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Equation,
    Formula,
    Name,
    Product,
    Quotient,
    equal,
    monomial,
    number,
    sin,
)
from symbalance.document.nodes import Inline, Paragraph
from symbalance.kinematics.conventions import CONVENTIONS

LONGEST_IN_FULL = 40
"""Beyond this order, or this power of sin theta, a derivation is shortened."""
SHORTENED = 2
"""How many terms of each coefficient a shortened derivation keeps."""

THETA, PHI, LAM, RHO, OMEGA = map(Name, ("theta", "phi", "lam", "rho", "omega"))
R, L, S, M, X = map(Name, "rlsmx")
KAPPA, Q, INDEX_I, J, K, N = map(Name, ("kappa", "q", "i", "j", "k", "n"))
HALF = number(Fraction(1, 2))


@dataclass(frozen=True)
class Step:
    """One step of a derivation: a title, then paragraphs and displayed equations."""

    title: str
    parts: tuple[Paragraph | Equation, ...]


def prose(*pieces: Inline) -> Paragraph:
    """Return a paragraph."""
    return Paragraph(pieces)


@dataclass(frozen=True)
class Letters:
    """The letters of a convention: its ratio, the crank radius and the rod's length in them."""

    ratio: Equation
    meaning: str
    radius: Formula
    rod: Formula
    rho: Formula
    sine: Formula
    """sin phi, in the crank angle"""


LETTERS = {
    "l/r": Letters(
        equal(LAM, L / R), "rod length over crank radius", R, LAM * R, 1 / LAM, sin(THETA) / LAM
    ),
    "r/l": Letters(equal(RHO, R / L), "crank radius over rod length", R, R / RHO, RHO, RHO * sin(THETA)),
    "l/s": Letters(
        equal(LAM, L / S),
        "rod length over stroke",
        S / number(2),
        LAM * S,
        1 / (2 * LAM),
        sin(THETA) / (2 * LAM),
    ),
}

UNITS = {"displacement": 0, "velocity": 1, "acceleration": 2, "force": 2}
"""The power of omega in a quantity."""


@dataclass(frozen=True)
class Request:
    """A checked question: a quantity to an order, with the power of 1/lambda to keep."""

    quantity: str
    order: int
    power: int
    convention: str

    @property
    def letters(self) -> Letters:
        """Return the letters of the convention."""
        return LETTERS[self.convention]

    @property
    def rod_angle(self) -> bool:
        """Tell whether the rod's angle is asked for: odd powers and sines."""
        return self.quantity == "rod-angle"

    @property
    def last(self) -> int:
        """Return the highest power of sin theta that is kept; 0 where none is."""
        return self.power - 1 + self.power % 2 if self.rod_angle else self.power + self.power % 2

    @property
    def last_order(self) -> int:
        """Return the highest harmonic there is, at most `order`."""
        return max(self.orders())

    @property
    def long(self) -> bool:
        """Tell whether to shorten."""
        return max(self.order, self.last) > LONGEST_IN_FULL

    def orders(self) -> list[int]:
        """Return the harmonics there are: odd ones of the rod's angle, else 1 and the even ones."""
        if self.rod_angle:
            return list(range(1, self.order + 1, 2))
        return [1, *range(2, self.order + 1, 2)]

    def sine_powers(self) -> Iterator[int]:
        """Yield the powers of sin theta that are kept."""
        yield from range(1 if self.rod_angle else 2, self.last + 1, 2)

    def rho_power(
        self, exponent: int, factor: Fraction = Fraction(1), of: Formula | None = None
    ) -> Formula:
        """Return factor rho^exponent in the letters of the convention, times `of`.

        >>> Request("force", 6, 5, "l/s").rho_power(3) == 1 / (8 * LAM**3)
        True
        """
        letter, direction, scale = CONVENTIONS[self.convention]
        return monomial(factor / scale**exponent, Name(letter), direction * exponent, of)

    def unit(self) -> Formula:
        """Return the unit of the quantity's coefficients: r, r omega, r omega^2 or m r omega^2."""
        return unit(self.quantity, self.letters.radius)


def unit(quantity: str, radius: Formula) -> Formula:
    """Return the unit of a piston quantity's coefficients.

    >>> unit("velocity", R) == R * OMEGA
    True
    """
    turns = UNITS[quantity]
    value = radius if turns == 0 else radius * (OMEGA if turns == 1 else OMEGA**2)
    return M * value if quantity == "force" else value


def harmonic(function: str, n: int) -> Call:
    """Return cos n theta or sin n theta.

    >>> harmonic("cos", 1) == Call("cos", THETA)
    True
    """
    return Call(function, THETA if n == 1 else n * THETA)


def general_term(
    request: Request, over: Sequence[Formula], under: Sequence[Formula], power: int
) -> Quotient:
    """Return over/under times rho^power in the letters of the convention, numbers as they are."""
    letter, direction, scale = CONVENTIONS[request.convention]
    base = Name(letter) if scale == 1 else scale * Name(letter)
    if direction > 0:
        return Quotient(Product((*over, base**power)), Product(tuple(under)))
    return Quotient(Product(tuple(over)) if len(over) > 1 else over[0], Product((*under, base**power)))
