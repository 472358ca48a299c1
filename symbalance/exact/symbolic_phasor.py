"""Exact amplitudes with symbols for some angles: numbers of a cyclotomic field times e^(i s).

Exponentials of independent symbols are linearly independent over the complex numbers, so that a sum is
zero for all values of its symbols exactly when no part is left: zero is decided by normal form here too.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import ClassVar

from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import Angle, SymbolPart
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.text.reals import DIGITS, Complex


@dataclass(frozen=True)
class SymbolicPhasor(Amplitude):
    """A sum of e^(i s) times a `Phasor`, over distinct symbolic angles s."""

    parts: Mapping[SymbolPart, Phasor] = field(hash=False)
    rank: ClassVar[int] = 1
    has_symbols: ClassVar[bool] = True

    @staticmethod
    def of(parts: Mapping[SymbolPart, Phasor]) -> SymbolicPhasor:
        """Return the sum with its zero parts dropped."""
        return SymbolicPhasor({s: p for s, p in parts.items() if not p.is_zero()})

    @classmethod
    def holding(cls, number: Phasor) -> SymbolicPhasor:
        """Return a number without symbols as one whose symbols are absent."""
        return cls.of({(): number})

    def is_zero(self) -> bool:
        """Tell whether the number is zero for all values of the symbols: a proof either way."""
        return not self.parts

    def plus(self, other: SymbolicPhasor) -> SymbolicPhasor:
        """Return the sum, symbol by symbol."""
        total = dict(self.parts)
        for symbols, phasor in other.parts.items():
            total[symbols] = total.get(symbols, ZERO) + phasor
        return SymbolicPhasor.of(total)

    def multiplied(self, other: SymbolicPhasor) -> SymbolicPhasor:
        """Return the product, every part with every other."""
        total = SymbolicPhasor({})
        for one, p in self.parts.items():
            for another, q in other.parts.items():
                symbols = (Angle(Fraction(0), one) + Angle(Fraction(0), another)).symbols
                total = total.plus(SymbolicPhasor.of({symbols: p.multiplied(q)}))
        return total

    def __neg__(self) -> SymbolicPhasor:
        return SymbolicPhasor({s: -p for s, p in self.parts.items()})

    def scaled(self, factor: int | Fraction) -> SymbolicPhasor:
        """Return the number times a rational."""
        return SymbolicPhasor.of({s: p.scaled(factor) for s, p in self.parts.items()})

    def rotated(self, turns: Fraction) -> SymbolicPhasor:
        """Return the number times e^(2 pi i turns)."""
        return SymbolicPhasor({s: p.rotated(turns) for s, p in self.parts.items()})

    def conjugate(self) -> SymbolicPhasor:
        """Return the complex conjugate, the symbols being real."""
        parts = {tuple((x, -f) for x, f in s): p.conjugate() for s, p in self.parts.items()}
        return SymbolicPhasor(parts)

    def evaluated(self, digits: int = DIGITS) -> Complex:
        """Return the number in decimals where its symbols have gone; else it is refused."""
        if set(self.parts) <= {()}:
            return self.parts.get((), ZERO).evaluated(digits)
        rule, remedy = "holds symbols, and has no decimal value", "give the angles in numbers"
        raise SymbalanceError("an angle", rule, remedy)

    @property
    def most(self) -> float:
        """The sum of its terms' sizes."""
        return sum(phasor.most for phasor in self.parts.values())

    @property
    def moduli(self) -> list[int]:
        """The order of each part's field."""
        return [phasor.modulus for phasor in self.parts.values()]

    @property
    def spelling(self) -> object:
        """The parts with the spelling of each."""
        return frozenset((symbols, phasor.spelling) for symbols, phasor in self.parts.items())
