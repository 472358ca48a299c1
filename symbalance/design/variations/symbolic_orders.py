r"""One order of the free force and couple as a formula, with symbols for what cylinders differ in.

Cylinder j pushes along its axis with m_j r_j omega^2 (A_n(j) cos n p_j + B_n(j) sin n p_j), p_j = theta +
throw - bank, so with s_j its station from the reference plane and f_n = A_n - i B_n

    c_n  = 1/2 sum of w_j f_n(j)  e^(i (bank_j + n (throw_j - bank_j))),
    c_-n = 1/2 sum of w_j f_n*(j) e^(i (bank_j - n (throw_j - bank_j))),     w_j = m_j r_j or m_j r_j s_j.

These are linear in the masses and bilinear in mass and station. A_n and B_n are one factor A_n where no
cylinder has a radius, rod or offset of its own; else they are the series in rho = r/l and delta = e/l of
`symbalance.kinematics.mechanisms.offset_series`, kept to a stated power, and the sums are polynomials
in m_j, s_j, r_j, e_j and 1/l_j.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import SymbolPart
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import COMPONENTS
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.exact.symbolic_polynomials import (
    Polynomial,
    SymbolComponent,
    SymbolSum,
    add,
    multiply,
    polynomial,
    raise_to_power,
)
from symbalance.forces.rows import plane_key
from symbalance.kinematics.coefficients import force_power
from symbalance.kinematics.mechanisms import offset_series
from symbalance.kinematics.slider_crank import Series, acceleration_series, checked_order
from symbalance.text.numbers import as_list, checked_whole, exact

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

HALF, QUARTER = Fraction(1, 2), Fraction(1, 4)
LONGEST_PREFIX = 20
"""Characters of a letter that cylinders' symbols begin with."""
LISTED = 8
"""So many symbols are named in one line."""
UNIT: Polynomial = {(): Fraction(1)}


@dataclass(frozen=True, eq=False)
class SymbolResultant:
    """One order of a force or couple as a formula in symbols: c_n, c_-n as `positive`, `negative`."""

    positive: SymbolSum
    negative: SymbolSum

    def is_zero(self) -> bool:
        """Tell whether the order vanishes for all values of the symbols: a proof either way."""
        return self.positive.is_zero() and self.negative.is_zero()

    @cached_property
    def vertical(self) -> SymbolComponent:
        """The part along the vertical."""
        return SymbolComponent(self.positive.conjugate() + self.negative)

    @cached_property
    def lateral(self) -> SymbolComponent:
        """The part towards the right, seen from the front."""
        return SymbolComponent((self.positive.conjugate() + -self.negative).rotated(QUARTER))

    @cached_property
    def forward(self) -> SymbolComponent:
        """The part that turns with the crank, by its vertical component."""
        return SymbolComponent(self.positive.conjugate())

    @cached_property
    def backward(self) -> SymbolComponent:
        """The part that turns against the crank, by its vertical component."""
        return SymbolComponent(self.negative)

    def component(self, name: str) -> SymbolComponent:
        """Return a component by name: vertical, lateral, forward or backward."""
        return getattr(self, name)


@dataclass(frozen=True, eq=False, repr=False)
class SymbolicOrder(Result):
    """One order of the free force and couple as formulas in symbols.

    Force and couple are in units of omega^2 times those of masses and radii (m and r where none are
    given), couples times that of stations (the pitch a where none are given). With a `coefficient` A_n
    that is a factor beside them; without, they hold the kinematics, exact through the total power
    `through` of r/l and e/l. `reference` is what couples are taken about, None for the mean of all
    stations.
    """

    engine: Engine
    order: int
    coefficient: Series | None
    through: int | None
    force: SymbolResultant
    couple: SymbolResultant
    reference: Any = None
    sizes: tuple[str, ...] = ()
    """Which of masses, stations, radii, rods and offsets were given."""
    all_symbols: tuple[Any, ...] = ()
    """All symbols that were given, also those that no sum of this order has."""
    values: tuple[tuple[Any, Fraction], ...] = ()
    """Symbols with the numbers put in for them (`at`)."""
    derivative_by: tuple[Any, ...] = ()
    """The symbols it is the derivative by (`differentiated`)."""

    kind: ClassVar[str] = "symbolic-order"

    def summary(self) -> str:
        """Return what the formulas are of and which symbols are left in them, in one line."""
        symbols = self.symbols()
        remaining = [str(symbol) for symbol in self.all_symbols if symbol in symbols]
        more = f" and {len(remaining) - LISTED} more" if len(remaining) > LISTED else ""
        by = "".join(f", derivative by {symbol}" for symbol in self.derivative_by)
        name = self.engine.name
        listing = f"{', '.join(remaining[:LISTED]) or 'none'}{more}"
        return (
            f"Order {self.order} of the free force and couple of {name}{by}; symbols left in: {listing}"
        )

    def document(self) -> Document:
        """Return the formulas of force and couple, then what their letters mean."""
        from symbalance.design.variations.symbolic_order_document import symbolic_order_document

        return symbolic_order_document(self)

    def data(self) -> dict[str, Any]:
        """Return every component as a formula that SymPy reads."""
        series = self.coefficient
        return {
            "engine": self.engine.name,
            "order": str(self.order),
            "coefficient": None
            if series is None
            else {"series": str(series.in_lam()), "through": series.through},
            "through": self.through,
            "reference_plane": plane_key(self.reference),
            "sizes": list(self.sizes),
            "symbols": list(map(str, self.all_symbols)),
            "values": {str(symbol): str(value) for symbol, value in self.values},
            "derivative_by": list(map(str, self.derivative_by)),
            **{name: _components(getattr(self, name)) for name in ("force", "couple")},
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each component of force and couple, formulas as text that SymPy reads."""
        return [
            {"order": self.order, "of": name, "component": component, **parts}
            for name in ("force", "couple")
            for component, parts in _components(getattr(self, name)).items()
        ]

    def at(self, values: Mapping[Any, object]) -> SymbolicOrder:
        """Return the order with numbers put in for some of its symbols, by symbol or by name."""
        if not isinstance(values, Mapping):
            rule = "must map symbols to numbers"
            raise SymbalanceError(f"values = {brief(values)}", rule, "write it like {m1: 0.6}")
        by_name = {str(s): s for s in self.all_symbols}
        unknown = [key for key in values if str(key) not in by_name]
        if unknown:
            remedy = f"they are {', '.join(sorted(by_name)) or 'none'}; angles stay symbols"
            raise SymbalanceError(f"symbol {brief(unknown[0])}", "was not given", remedy)
        numbers = {by_name[str(key)]: exact(value, str(key)) for key, value in values.items()}
        values = dict(self.values) | numbers
        return replace(self._map(lambda part: part.at(numbers)), values=tuple(values.items()))

    def symbols(self) -> set[Any]:
        """Return the symbols that stand for masses, stations and lengths."""
        parts = (self.force.positive, self.force.negative, self.couple.positive, self.couple.negative)
        return {symbol for part in parts for monomial in part.terms for symbol, _ in monomial}

    def differentiated(self, symbol: Any) -> SymbolicOrder:
        """Return the derivative by one of the symbols that stand for masses, stations or lengths."""
        derivative = self._map(lambda part: part.differentiated(symbol))
        return replace(derivative, derivative_by=(*self.derivative_by, symbol))

    def _map(self, change: Any) -> SymbolicOrder:
        force, couple = (
            SymbolResultant(change(r.positive), change(r.negative)) for r in (self.force, self.couple)
        )
        return replace(self, force=force, couple=couple)


def _components(resultant: SymbolResultant) -> dict[str, dict[str, str]]:
    parts = ((name, resultant.component(name)) for name in COMPONENTS)
    return {name: {"cos": str(part.cos), "sin": str(part.sin)} for name, part in parts}


def symbolic_order(
    engine: Engine,
    order: int,
    *,
    masses: object = None,
    stations: object = None,
    radii: object = None,
    rods: object = None,
    offsets: object = None,
    reference: object = None,
    through: int | None = None,
) -> SymbolicOrder:
    """Return one order of the free force and couple, with symbols for what its cylinders differ in.

    Each of `masses`, `stations`, `radii`, `rods` and `offsets` is a letter ("m" gives m_1, m_2, ... by
    the cylinders' numbers), a list with one entry a cylinder (a number, or a SymPy polynomial), or None:
    masses are then the engine's over cylinder 1's, or 1, radii 1, stations the engine's in pitches. Give
    radii, rods and offsets in one unit of length; any of them brings the kinematics into the sums,
    `through` being the highest total power of r/l and e/l kept (default: three terms). `reference` is
    the station couples are taken about (default: the mean of the stations, symbols too).

    >>> from symbalance.engine.builders import inline
    >>> one = symbolic_order(inline("1-3-4-2"), 1, masses="m")
    >>> one.force.vertical.cos
    m_1 - m_2 - m_3 + m_4
    >>> one.at({"m_1": 1, "m_2": 1, "m_3": 1, "m_4": 1}).force.is_zero()
    True
    """
    n = checked_order(order)
    checked_engine(engine)
    mass = cylinder_symbols(engine, masses, "masses") or _mass_shares(engine)
    radius = cylinder_symbols(engine, radii, "radii") or [UNIT] * len(engine.cylinders)
    weights = [multiply(m, r) for m, r in zip(mass, radius, strict=True)]
    _check_link_pins(engine)
    kinematics, power = None, None
    if any(x is not None for x in (radii, rods, offsets)):
        power = checked_whole(n + 3 if through is None else through, "through", 0, 400, "5 is usual")
        kinematics = _kinematics(engine, n, radius, rods, offsets, power)
    if kinematics is None:
        _check_alike(engine)
    arms = _arms(engine, stations, reference)
    force = _resultant(engine.cylinders, n, weights, kinematics)
    couple = _resultant(
        engine.cylinders, n, [multiply(w, a) for w, a in zip(weights, arms, strict=True)], kinematics
    )
    alike = None if kinematics else acceleration_series(n, force_power(n))
    sizes = {"masses": masses, "stations": stations, "radii": radii, "rods": rods, "offsets": offsets}
    all_symbols = dict.fromkeys(
        x for key, v in sizes.items() for x in symbols_in(cylinder_symbols(engine, v, key))
    )
    return SymbolicOrder(
        engine,
        n,
        alike,
        power,
        force,
        couple,
        reference,
        tuple(key for key, value in sizes.items() if value is not None),
        tuple(all_symbols),
    )


def _mass_shares(engine: Engine) -> list[Polynomial]:
    """Return every cylinder's reciprocating mass over that of the first; 1 where none are given."""
    shares = [size / radius for size, radius in zip(engine.sizes, engine.radii, strict=True)]
    return [{(): share} if share else {} for share in shares]


def _check_link_pins(engine: Engine) -> None:
    """Refuse link rods: the series of a rod on the pin are not theirs. A forked rod's are."""
    if engine.link_pins:
        rule = f"hangs cylinder {engine.link_pins[0]} on a link rod, which has no such series"
        remedy = "take balance, or sensitivities, with numbers"
        raise SymbalanceError(f"engine {engine.name!r}", rule, remedy)


def _check_alike(engine: Engine) -> None:
    """Refuse cylinders that one A_n and one radius do not fit, where no lengths are given."""
    lengths = {(c.sizes.given_ratio, c.sizes.rod, c.stroke) for c in engine.cylinders}
    if len(lengths) > 1 or any(c.offset for c in engine.cylinders):
        rule = "has cylinders whose kinematics are not alike"
        remedy = "give radii, rods and offsets, as numbers or as letters"
        raise SymbalanceError(f"engine {engine.name!r}", rule, remedy)


def _arms(engine: Engine, stations: object, reference: object) -> list[Polynomial]:
    """Return every cylinder's station from the reference plane."""
    places = cylinder_symbols(engine, stations, "stations")
    if places is None:
        places = [{(): c.station} if c.station else {} for c in engine.cylinders]
    if reference is not None:
        plane = polynomial(reference, "reference")
    else:
        plane = {}
        for one in places:
            plane = add(plane, one)
        plane = multiply(plane, {(): Fraction(1, len(places))})
    return [add(one, multiply(plane, {(): Fraction(-1)})) for one in places]


Kinematics = tuple[Polynomial, Polynomial]
"""A_n and B_n of one cylinder."""


def _kinematics(
    engine: Engine, n: int, radius: Sequence[Polynomial], rods: object, offsets: object, through: int
) -> list[Kinematics]:
    """Return every cylinder's A_n and B_n as polynomials in r/l and e/l."""
    rod, offset = cylinder_symbols(engine, rods, "rods"), cylinder_symbols(engine, offsets, "offsets")
    if rod is None:
        raise SymbalanceError("rods", "are not given", "give the rods' lengths, or a letter for them")
    offset = offset or [{}] * len(rod)
    series = offset_series(n, through)
    if not (series.cos.terms or series.sin.terms):
        rule = f"keeps no term of order {n}"
        raise SymbalanceError(f"through = {through}", rule, f"{max(n - 1, 1)} is the least")
    kinematics = []
    for r, l_, e in zip(radius, rod, offset, strict=True):
        inverse = raise_to_power(l_, -1, "rods")
        rho, delta = multiply(r, inverse), multiply(e, inverse)
        parts = (_at(part.terms, rho, delta) for part in series)
        kinematics.append(tuple(parts))
    return kinematics


def _at(terms: Mapping[tuple[int, int], Fraction], rho: Polynomial, delta: Polynomial) -> Polynomial:
    total: Polynomial = {}
    for (i, j), c in terms.items():
        power = multiply(raise_to_power(rho, i, "radii"), raise_to_power(delta, j, "offsets"))
        total = add(total, multiply(power, {(): c}))
    return total


def _resultant(
    cylinders: Sequence[Cylinder],
    n: int,
    weights: Sequence[Polynomial],
    kinematics: list[Kinematics] | None,
) -> SymbolResultant:
    both = []
    for signed in (n, -n):
        total = SymbolSum({})
        for place, (cylinder, weight) in enumerate(zip(cylinders, weights, strict=True)):
            angle = cylinder.bank + cylinder.delay.scaled(signed)
            part: SymbolPart = angle.symbols
            number = SymbolicPhasor({part: Phasor.root(angle.turns).scaled(HALF)})
            if kinematics is None:
                total = total + SymbolSum.of(weight, number)
                continue
            cos, sin = kinematics[place]
            total = total + SymbolSum.of(multiply(weight, cos), number)
            quarter = -QUARTER if signed > 0 else QUARTER  # f_n = A_n - i B_n, f_-n its conjugate
            total = total + SymbolSum.of(multiply(weight, sin), number.rotated(quarter))
        both.append(total)
    return SymbolResultant(*both)


def cylinder_symbols(engine: Engine, values: object, name: str) -> list[Polynomial] | None:
    """Return one polynomial a cylinder from a letter or a list of them, None where there is neither."""
    if values is None:
        return None
    count = len(engine.cylinders)
    if isinstance(values, str):
        import sympy

        if not values.isidentifier() or len(values) > LONGEST_PREFIX:
            raise SymbalanceError(f"{name} = {brief(values)}", "must be a letter or a list", 'write "m"')
        return [
            {((sympy.Symbol(f"{values}_{c.number}", real=True), 1),): Fraction(1)}
            for c in engine.cylinders
        ]
    numbers = as_list(values, name, "[m1, m2, 0.6]")
    if len(numbers) != count:
        what = f"{name} holds {len(numbers)} values"
        raise SymbalanceError(what, f"the engine has {count} cylinders", "give one for each")
    return [polynomial(value, f"{name}[{i}]") for i, value in enumerate(numbers)]


def symbols_in(values: Sequence[Polynomial] | None) -> list[Any]:
    """Return the symbols of some polynomials, each once, in their order."""
    return list(
        dict.fromkeys(symbol for one in values or () for monomial in one for symbol, _ in monomial)
    )
