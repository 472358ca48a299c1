"""Relations solved for one of several letters of a side: n of i n = 60 f, ω_p of ω_p/Ω = √(R/l).

A side that is a product or a quotient gives each of its letters a value. What words name is one of
them, or the ratio of two of one kind, Θ_max/Θ_st.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
)
from symbalance.notes.checking.meant.letter_roles import index_of, stem_of

RATIO = "∕"
"""What stands for the letter of a ratio of two letters of one kind, c/c_c."""
_SECTIONS, _EDGES = frozenset("IJ"), frozenset({"v", "c", "y", "e", "r"})
"""Letters of second moments of area, and of the distance of the outermost fibre."""
_ONE = Number(Fraction(1))
_MOST_FACTORS = 5
"""Factors of a side that is solved for one of them."""


@dataclass(frozen=True, slots=True)
class Solved:
    """A relation solved for a letter: what stands on its left then, on its right, and what was moved."""

    name: str
    left: Formula
    right: Formula
    moved: Formula
    """What the letter is multiplied by where it stood."""
    is_below: bool = False
    """Whether the letter stood below the line: its inverse is multiplied by what was moved."""

    def as_written(self, right: Formula) -> Formula:
        """Return what stands on the right of the relation as it is written, for another right side."""
        return simple_product(self.moved, _ONE / right if self.is_below else right)


def solved_sides(left: Formula, right: Formula) -> Iterator[Solved]:
    """Yield a relation solved for each letter that is a factor of its left side and stands nowhere else.

    >>> [s.name for s in solved_sides(Name("i") * Name("n"), 60 * Name("f"))]
    ['i', 'n']
    >>> [s.name for s in solved_sides(Name("omega") / Name("Omega"), Name("x"))]
    ['omega']
    """
    if (wave := _tangent_of(left, right)) is not None:
        yield wave
        return
    parts = factors_of(left)
    if parts is None or not 2 <= len(parts) <= _MOST_FACTORS:
        return
    if (ratio := _ratio_of(parts, left, right)) is not None:
        yield ratio
    if (moment := _moment_of(parts, right)) is not None:
        yield moment
    has_above = any(isinstance(base, Name) and exponent > 0 for base, exponent in parts)
    kinds = [_kind(base.name) for base, exponent in parts if isinstance(base, Name) and exponent > 0]
    for k, (base, exponent) in enumerate(parts):
        if has_above and (exponent < 0 or (isinstance(base, Name) and kinds.count(_kind(base.name)) > 1)):
            continue  # of ω/Ω the words name the one above, and of l_1 l_2 either
        rest = [*parts[:k], *parts[k + 1 :]]
        others = names(right).union(*(names(other) for other, _ in rest))
        if not isinstance(base, Name) or base.name in others or exponent not in (1, -1, 2):
            continue
        moved, is_below = product_of(rest), exponent == -1
        claim = simple_product(moved, _ONE / right) if is_below else simple_product(right, _ONE / moved)
        yield Solved(
            base.name, base if is_below else product_of([(base, exponent)]), claim, moved, is_below
        )


def _moment_of(parts: list[tuple[Formula, Fraction]], right: Formula) -> Solved | None:
    """Return a relation for the moment of a mass of its own: m_A r_A of 2 m_A r_A (2 ω)² = λ m r ω²."""
    own = [base for base, exponent in parts if isinstance(base, Name) and exponent == 1]
    pairs = [
        (mass, arm)
        for mass in own
        for arm in own
        if mass.name[0] in "mM"
        and arm.name[0] in "rRe"
        and index_of(mass.name) == index_of(arm.name) != ""
    ]
    if len(pairs) != 1 or {n.name for n in pairs[0]} & names(right):
        return None
    rest = [part for part in parts if part[0] not in pairs[0]]
    if not rest:
        return None  # as it stands
    moved = product_of(rest)
    product = Product(pairs[0])
    name = " ".join(each.name for each in pairs[0])
    return Solved(name, product, simple_product(right, _ONE / moved), moved)


def otherwise_solved(left: Formula, right: Formula) -> Iterator[Solved]:
    """Yield what a left side is the value of: the modulus I/v, and N of a sum that is 1/N or N.

    >>> [s.name for s in otherwise_solved(Name("I") / Name("v"), Name("x"))]
    ['W']
    >>> [s.name for s in otherwise_solved(Name("a") + Name("b"), 1 / Name("N"))]
    ['N']
    """
    match left:
        case Quotient(numerator=Name(name=section), denominator=Name(name=edge)):
            is_modulus = stem_of(section) in _SECTIONS and stem_of(edge) in _EDGES
            if is_modulus and not {section, edge, "W"} & names(right):
                yield Solved("W", Name("W"), right, _ONE)
    match right:
        case Name(name=name) if isinstance(left, Sum) and name not in names(left):
            yield Solved(name, right, left, _ONE)
        case Quotient(numerator=Number(value=1), denominator=Name(name=name)):
            if isinstance(left, Sum) and name not in names(left):
                yield Solved(name, Name(name), _ONE / left, _ONE, is_below=True)


def _kind(letter: str) -> str:
    return stem_of(letter).casefold()


def _ratio_of(parts: list[tuple[Formula, Fraction]], left: Formula, right: Formula) -> Solved | None:
    """Return a relation for the ratio of two letters of one kind: c/c_c, Θ_max/Θ_st squared."""
    if len(parts) != 2 or not all(isinstance(base, Name) for base, _ in parts):
        return None
    (one, above), (other, below) = parts
    above, below, one, other = (above, below, one, other) if above > 0 else (below, above, other, one)
    stems = {stem_of(base.name) for base in (one, other) if isinstance(base, Name)}
    is_ratio = above == -below and above in (1, 2) and len(stems) == 1
    if not is_ratio or names(left) & names(right):
        return None
    index = index_of(one.name) if isinstance(one, Name) else ""
    letter = Name(f"{RATIO}_{index}" if index else RATIO)
    return Solved(letter.name, letter if above == 1 else letter**above, right, _ONE)


def _tangent_of(left: Formula, right: Formula) -> Solved | None:
    """Return (1 - r²) sin φ = 2 ζ r cos φ as a relation of tan φ; None for others."""
    one, other = factors_of(left), factors_of(right)
    if one is None or other is None:
        return None
    for base, exponent in one:
        if isinstance(base, Call) and base.function in ("sin", "cos") and exponent == 1:
            partner = Call("cos" if base.function == "sin" else "sin", base.argument)
            if (partner, Fraction(1)) in other and isinstance(base.argument, Name):
                here = product_of([part for part in one if part != (base, exponent)])
                there = product_of([part for part in other if part != (partner, Fraction(1))])
                above, below = (there, here) if base.function == "sin" else (here, there)
                if base.argument.name in names(above) | names(below):
                    return None
                tangent = Call("tan", base.argument)
                return Solved(base.argument.name, tangent, above / below, here * partner,
                              is_below=base.function == "cos")  # fmt: skip
    return None


def factors_of(node: Formula) -> list[tuple[Formula, Fraction]] | None:
    """Return the factors of a product with their exponents, each base once; None where it has a sign.

    >>> c, k = Name("c"), Name("k")
    >>> factors_of((c / k) ** Fraction(2)) == [(c, Fraction(2)), (k, Fraction(-2))]
    True
    """
    found: dict[Formula, Fraction] = {}
    for base, exponent in _factors(node, Fraction(1)):
        if isinstance(base, Negative):
            return None
        found[base] = found.get(base, Fraction(0)) + exponent
    return [(base, exponent) for base, exponent in found.items() if exponent and base != _ONE]


def _factors(node: Formula, exponent: Fraction) -> Iterator[tuple[Formula, Fraction]]:
    match node:
        case Product(factors=factors):
            for factor in factors:
                yield from _factors(factor, exponent)
        case Quotient(numerator=above, denominator=below):
            yield from _factors(above, exponent)
            yield from _factors(below, -exponent)
        case Power(base=base, exponent=Number(value=value)):
            yield from _factors(base, exponent * value)
        case _:
            yield node, exponent


def product_of(parts: list[tuple[Formula, Fraction]]) -> Formula:
    """Return the product of factors with their exponents, those with negative ones below a line."""
    above = [_power(base, exponent) for base, exponent in parts if exponent > 0]
    below = [_power(base, -exponent) for base, exponent in parts if exponent < 0]
    top = _product(above)
    return Quotient(top, _product(below)) if below else top


def simple_product(*nodes: Formula) -> Formula:
    """Return a product with equal factors put together, numbers first: (2 π)·√x/(2 π) is √x."""
    number, found = Fraction(1), dict[Formula, Fraction]()
    for node in nodes:
        for base, exponent in _factors(node, Fraction(1)):
            if isinstance(base, Number) and exponent.denominator == 1 and base.value:
                number *= base.value ** int(exponent)
            else:
                found[base] = found.get(base, Fraction(0)) + exponent
    parts = [(base, exponent) for base, exponent in found.items() if exponent]
    parts.sort(key=lambda part: not isinstance(part[0], Constant))
    above, below = (Number(Fraction(n)) for n in (number.numerator, number.denominator))
    numbers = [(above, Fraction(1)), (below, Fraction(-1))]
    return product_of([*(part for part in numbers if part[0] != _ONE), *parts])


def _power(base: Formula, exponent: Fraction) -> Formula:
    if exponent == Fraction(1, 2):
        return Call("sqrt", base)
    return base if exponent == 1 else base**exponent


def _product(factors: list[Formula]) -> Formula:
    if not factors:
        return _ONE
    return factors[0] if len(factors) == 1 else Product(tuple(factors))
