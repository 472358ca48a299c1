"""Formulas read as harmonics of one angle whose coefficients are numbers times powers of a ratio.

m r² ω² (λ/4 sin φ - ½ sin 2φ) is the factor m r² ω², the angle φ, and of sin φ the coefficient ¼ at λ¹,
of sin 2φ -½ at λ⁰. The ratio may be a letter, λ or its inverse n, or r/l of two letters.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from symbalance.document.formula import Call, Formula, Name, Number, Power, Product, Quotient, walk
from symbalance.notes.algebra.domain import Domain, Monomial, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.harmonics import angle_node, components
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.meant.pistons.crank_series import Harmonic, Series

RATIOS = frozenset({"lambda", "rho", "epsilon", "varepsilon", "n", "kappa", "mu", "q", "nu", "k"})
"""Letters of r/l or l/r on most pages."""
RADII, RODS = frozenset({"r", "R"}), frozenset({"l", "L", "ell"})
_TURNING = ("sin", "cos")
MOST_TERMS = 24
_Letters = Mapping[str, Fraction]


class Ratio(NamedTuple):
    """What stands for r/l: a letter, or the crank radius over the rod; l/r where it is inverse."""

    letter: str
    below: str = ""
    is_inverse: bool = False

    @property
    def node(self) -> Formula:
        """The ratio as it is written, of which the formula has powers."""
        return Quotient(Name(self.letter), Name(self.below)) if self.below else Name(self.letter)


@dataclass(frozen=True)
class Profile:
    """A formula as harmonics: what stands before them, the angle, the ratio, and the coefficients."""

    factor: _Letters
    """The powers of the other letters."""
    angle: Formula
    ratio: Ratio
    series: Series

    def node(self, function: str, order: int, power: int, coefficient: Fraction) -> Formula:
        """Return one term, without the factor before all of them: 3 λ/4 sin 3φ."""
        exponent = -power if self.ratio.is_inverse else power
        parts: list[Formula] = []
        if abs(coefficient) != 1 or (not exponent and not order):
            parts.append(rational_node(abs(coefficient)))
        if exponent > 0:
            raised = Number(Fraction(exponent))
            parts.append(self.ratio.node if exponent == 1 else Power(self.ratio.node, raised))
        node: Formula | None = Product(tuple(parts)) if len(parts) > 1 else parts[0] if parts else None
        if exponent < 0:
            below = (
                self.ratio.node if exponent == -1 else Power(self.ratio.node, Number(Fraction(-exponent)))
            )
            node = Quotient(node or Number(Fraction(1)), below)
        waves = self._waves(function, order)
        if waves:
            node = Product((node, *waves)) if node is not None else _product(waves)
        node = node if node is not None else Number(Fraction(1))
        return -node if coefficient < 0 else node

    def _waves(self, function: str, order: int) -> list[Formula]:
        if function == "1":  # powers of the sine
            sine = Call("sin", self.angle)
            return [Power(sine, Number(Fraction(order))) if order > 1 else sine] if order else []
        multiple = self.angle if order == 1 else Product((Number(Fraction(order)), self.angle))
        return [Call(function, multiple)] if order else []


def _product(parts: list[Formula]) -> Formula:
    return parts[0] if len(parts) == 1 else Product(tuple(parts))


def has_waves(node: Formula, least: int = 1) -> bool:
    """Tell whether a formula has sines or cosines, cheaply."""
    waves = (part for part in walk(node) if isinstance(part, Call) and part.function in _TURNING)
    return sum(1 for _ in waves) >= least


def has_powers_of_sine(node: Formula) -> bool:
    """Tell whether a square or another power of a sine is written in a formula."""
    return any(
        isinstance(part, Power) and isinstance(part.base, Call) and part.base.function == "sin"
        for part in walk(node)
    )


def profiles(node: Formula) -> Iterator[Profile]:
    """Yield a formula's readings as harmonics of one angle, one for each ratio that it may be in."""
    try:
        form = FormEvaluator(Domain(), SymbolValue()).form(node)
        if len(form.denominator) != 1 or form.domain.radicals or form.domain.opaque:
            return
        numbers = components(form.domain, form.numerator)
    except (NoFormError, TooLargeError):
        return
    domain = form.domain
    ((below, divisor),) = form.denominator.items()
    divided = _exponents(domain, below)
    rows: list[tuple[Harmonic, dict[str, Fraction], Fraction]] = []
    angles: set[int] = set()
    for key, number in numbers.items():
        own = _exponents(domain, key.letters)
        is_plain = own is not None and divided is not None and list(number) == [()]
        if not is_plain or own is None or divided is None or len(key.angle) > 1 or len(rows) > MOST_TERMS:
            return
        order = Fraction(0)
        if key.angle:
            ((generator, order),) = key.angle
            angles.add(generator)
            order = Fraction(order)
        if order.denominator != 1:
            return
        letters = {n: own.get(n, Fraction(0)) - divided.get(n, Fraction(0)) for n in {*own, *divided}}
        value = Fraction(number[()]) / Fraction(divisor)
        rows.append((Harmonic(key.function if order else "cos", int(order)), letters, value))
    if len(angles) != 1:
        return
    (generator,) = angles
    angle = angle_node(domain, ((generator, 1),))
    every = {n for _, letters, _ in rows for n in letters}
    for ratio in _ratios(every):
        profile = _in_ratio(rows, angle, ratio)
        if profile is not None:
            yield profile


def harmonics_of(node: Formula) -> frozenset[Harmonic]:
    """Return the harmonics of one angle that a formula has, whatever stands before them; none else."""
    try:
        form = FormEvaluator(Domain(), SymbolValue()).form(node)
        if len(form.denominator) != 1 or form.domain.radicals or form.domain.opaque:
            return frozenset()
        keys = list(components(form.domain, form.numerator))
    except (NoFormError, TooLargeError):
        return frozenset()
    angles = {key.angle[0][0] for key in keys if key.angle}
    orders = [key.angle[0][1] for key in keys if key.angle]
    is_of_one = len(angles) == 1 and all(len(key.angle) <= 1 for key in keys)
    if not is_of_one or any(Fraction(order).denominator != 1 for order in orders):
        return frozenset()
    return frozenset(Harmonic(key.function, int(key.angle[0][1])) for key in keys if key.angle)


def _exponents(domain: Domain, monomial: Monomial) -> dict[str, Fraction] | None:
    """Return the powers of a monomial's letters; None where it has anything else."""
    if any(domain.generators[g].kind != "symbol" for g, _ in monomial):
        return None
    return {str(domain.generators[g].content): Fraction(e) for g, e in monomial}


def _ratios(letters: set[str]) -> Iterator[Ratio]:
    """Yield what may stand for the ratio of crank and rod among letters."""
    for name in sorted(letters):
        if name.partition("_")[0] in RATIOS:
            yield Ratio(name)
            yield Ratio(name, is_inverse=True)
    radii = sorted(n for n in letters if n.partition("_")[0] in RADII)
    rods = sorted(n for n in letters if n.partition("_")[0] in RODS)
    if len(radii) == len(rods) == 1:
        yield Ratio(radii[0], rods[0])


def _in_ratio(
    rows: list[tuple[Harmonic, dict[str, Fraction], Fraction]], angle: Formula, ratio: Ratio
) -> Profile | None:
    """Return a formula's harmonics by powers of a ratio; None where they have other letters in common.

    A constant with other letters is left out: a length from elsewhere may be added to a motion.
    """
    turning = [row for row in rows if row[0].order]
    split = [_split(letters, ratio) for _, letters, _ in turning]
    first = split[0] if split else None
    if first is None or any(each is None or each[0] != first[0] for each in split):
        return None
    series: dict[Harmonic, dict[int, Fraction]] = defaultdict(dict)
    for harmonic, letters, value in rows:
        own = _split(letters, ratio)
        if own is None or own[0] != first[0]:
            continue
        series[harmonic][own[1]] = value
    return Profile(dict(first[0]), angle, ratio, dict(series))


def _split(
    letters: Mapping[str, Fraction], ratio: Ratio
) -> tuple[tuple[tuple[str, Fraction], ...], int] | None:
    """Return the other letters' powers and the ratio's power; None where that is no whole number."""
    rest = {n: e for n, e in letters.items() if n not in (ratio.letter, ratio.below)}
    power = letters.get(ratio.letter, Fraction(0))
    if ratio.below:  # r^a l^b is r^(a+b) (r/l)^-b
        power = -letters.get(ratio.below, Fraction(0))
        rest[ratio.letter] = letters.get(ratio.letter, Fraction(0)) - power
    if power.denominator != 1:
        return None
    own = tuple(sorted((n, e) for n, e in rest.items() if e))
    return own, int(-power if ratio.is_inverse else power)
