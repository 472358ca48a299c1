"""Formulas for letters declared by role, such as r = s/2, l = λ r and sin β = sin θ/λ."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.matrix_letters import kinds_of
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.declared.engines import Engines, NoEngines
from symbalance.notes.checking.declared.geometry import Geometry, geometry, two
from symbalance.notes.checking.declared.motion_directions import directed
from symbalance.notes.checking.declared.symbol_roles import (
    CONSTANT,
    CONSTANT_WORD,
    FORCE,
    FROM_MIDDLE,
    FROM_PIN,
    FROM_TOP,
    HARMONIC,
    MOVING,
    POSITIVE,
    RANGES,
    UNITS,
    conjugate_name,
    letters_by_role,
    role_of,
)
from symbalance.notes.reading import Motions

SAME_POWER = 31
"""The power of r/l through which every declared A_n is taken: one for all, so that sums compare."""


def meaning_of(
    symbols: Mapping[str, str], convention: str = "", engines: Engines | None = None
) -> tuple[SymbolValue, Geometry]:
    """Return what the declared letters stand for, and the slider-crank in them.

    `engines` knows the harmonics A_n; a letter that stands for one is refused without it.

    >>> meaning, crank = meaning_of({"s": "stroke", "l": "rod length", "lambda": "rod ratio l/s"})
    >>> sorted(meaning.values), crank.small
    (['l'], ('lambda', -1))
    """
    crank, letters = geometry(symbols, convention), letters_by_role(symbols)
    engines = NoEngines() if engines is None else engines
    stands_for: dict[str, Formula] = {
        "crank radius": crank.radius,
        "stroke": Product((two(), crank.radius)),
        "rod length": crank.length,
        "rod ratio l/r": Quotient(crank.length, crank.radius),
        "rod ratio l/s": Quotient(crank.length, Product((two(), crank.radius))),
        "crank ratio r/l": crank.ratio,
        "rod angle": Call("asin", Product((crank.ratio, Call("sin", crank.theta)))),
        "angular speed": crank.omega,
        "engine speed rpm": Quotient(Product((Number(Fraction(30)), crank.omega)), Constant("pi")),
        "time": Quotient(crank.theta, crank.omega),
        FROM_TOP: crank.displacement,
        FROM_PIN: crank.position,
        FROM_MIDDLE: Sum((crank.position, formula.Negative(crank.length))),
        "piston velocity": crank.velocity,
        "piston acceleration": crank.acceleration,
        FORCE: crank.force,
    }
    base = {n for part in (crank.radius, crank.length, crank.omega) for n in formula.names(part)}
    values: dict[str, Formula] = {
        n: _harmonic(m, crank, engines) for m in letters if HARMONIC.match(m) for n in letters[m]
    }
    for meaning, node in stands_for.items():
        for name in letters.get(meaning, []):
            if name not in base:
                values[name] = directed(symbols[name], node)
    for name in [n for m in MOVING if m != FORCE for n in letters.get(m, ())]:
        for order in (1, 2):
            derivative = name + "'" * order
            if derivative not in symbols and isinstance(crank.theta, Name):
                values[derivative] = Derivative(Name(name), crank.theta, order)
    for name in letters.get("complex", ()):
        if conjugate_name(name) not in symbols:
            values[conjugate_name(name)] = Call("conj", Name(name))
    rates: dict[str, Mapping[str, Formula]] = {}
    if isinstance(crank.theta, Name):
        rates[crank.time] = {crank.theta.name: crank.omega}
    positive = {n for m in POSITIVE for n in letters.get(m, [])} | {"r", "l", "omega", "m"} & _loose(
        crank
    )
    positive |= {n for n, text in symbols.items() if role_of(text) in UNITS}
    integer = frozenset(letters.get("integer", ()))
    ranges = {name: size for m, size in RANGES.items() for name in letters.get(m, ())}
    constant = {n for m in CONSTANT for n in letters.get(m, ())} | base
    constant |= {n for n, text in symbols.items() if CONSTANT_WORD.search(text.lower())}
    not_real = frozenset(letters.get("complex", ()))
    return SymbolValue(
        values,
        rates,
        frozenset(positive),
        integer,
        ranges,
        frozenset(constant - {crank.time}),
        not_real,
        kinds_of(symbols),
    ), crank


def motions_of(symbols: Mapping[str, str]) -> Motions:
    """Return the letters that move with the crank, with their derivatives, and the angles and times.

    >>> sorted(motions_of({"x": "piston position", "theta": "crank angle"}).letters)
    ['x', "x'", "x''"]
    """
    letters = letters_by_role(symbols)
    moving = [n for m in (*MOVING, "rod angle") for n in letters.get(m, ())]
    if not moving:
        return Motions()
    crank = geometry(symbols, "")
    arguments = {n for m in ("crank angle", "time") for n in letters.get(m, ())} | {crank.time}
    arguments |= formula.names(crank.theta) if isinstance(crank.theta, Name) else set()
    forces = {*letters.get(FORCE, ())}  # F' is another force, and no rate
    primed = {n + "'" * k for n in moving for k in range(1 if n in forces else 3)}
    return Motions(frozenset(primed), frozenset(arguments))


def _harmonic(meaning: str, crank: Geometry, engines: Engines) -> Formula:
    """Return A_n of the acceleration as a series in r/l, far beyond what anybody writes."""
    order = int(meaning[2:])
    return series_node(engines.coefficient_terms(order, far_power(order)), crank.ratio)


def far_power(order: int) -> int:
    """Return the power of r/l through which A_n is taken where no power is named."""
    return max(SAME_POWER, order + 7)


def series_node(coefficients: Mapping[int, Fraction], ratio: Formula) -> Formula:
    """Return a sum of coefficients times powers of r/l; of none it is 0."""
    if not coefficients:
        return Number(Fraction(0))
    terms = [_term(c, p, ratio) for p, c in sorted(coefficients.items())]
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _term(coefficient: Fraction, power: int, ratio: Formula) -> Formula:
    if power == 0:
        return rational_node(coefficient)
    return Product((rational_node(coefficient), Power(ratio, Number(Fraction(power)))))


def _loose(crank: Geometry) -> set[str]:
    nodes = (crank.radius, crank.length, crank.omega, crank.mass)
    return {name for node in nodes for name in formula.names(node)}
