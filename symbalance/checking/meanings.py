"""The meanings the checker knows: what a letter with one of them is, in terms of the others.

A letter declared with a known meaning (what follows a comma is a remark) takes part in the geometry of
the slider-crank: r = s/2, l = λ r, sin β = sin θ/λ, x(θ). One letter of each kind is the base the others
are written in, so a document in s and λ = l/s is judged, and corrected, in s and λ.

    x = r (1 - cos θ) + l (1 - √(1 - (r/l)² sin² θ))     from top dead centre
    v = dx/dt,  a = d²x/dt²,  dθ/dt = ω,  F = m a        F away from the crank
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from symbalance.algebra.evaluation import Meaning
from symbalance.algebra.numbers import rational_node
from symbalance.reading import syntax
from symbalance.reading.syntax import (
    Call,
    Constant,
    Derivative,
    Name,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.slider_crank import acceleration_series, surviving

_FROM_TOP = "displacement from top dead centre"
_FROM_PIN = "piston position"
_FROM_MIDDLE = "piston position from mid-stroke"

ALIASES = {
    "displacement from tdc": _FROM_TOP,
    "piston displacement from top dead centre": _FROM_TOP,
    "piston displacement from tdc": _FROM_TOP,
    "displacement from top dead center": _FROM_TOP,
    "connecting rod length": "rod length",
    "crank speed": "angular speed",
    "angular velocity": "angular speed",
    "rod ratio (l/r)": "rod ratio l/r",
    "rod ratio (l/s)": "rod ratio l/s",
    "crank ratio (r/l)": "crank ratio r/l",
}

KNOWN = (
    "crank angle",
    "rod angle",
    "crank radius",
    "stroke",
    "rod length",
    "rod ratio l/r",
    "rod ratio l/s",
    "crank ratio r/l",
    "angular speed",
    "engine speed rpm",
    "time",
    "reciprocating mass",
    _FROM_TOP,
    _FROM_PIN,
    _FROM_MIDDLE,
    "piston velocity",
    "piston acceleration",
    "inertia force",
    "cylinder pitch",
    "integer",
    "positive",
    "variable",
)

MOVING = (_FROM_TOP, _FROM_PIN, _FROM_MIDDLE, "piston velocity", "piston acceleration", "inertia force")
_POSITIVE = {
    *("crank radius", "stroke", "rod length", "rod ratio l/r", "rod ratio l/s", "crank ratio r/l"),
    *("angular speed", "engine speed rpm", "reciprocating mass", "cylinder pitch", "positive"),
}
_HARMONIC = re.compile(r"A_\d{1,3}$")
SAME_POWER = 31
"""The power of r/l through which every declared A_n is taken: one for all, so that sums of them compare."""
RANGES = {
    "crank angle": (10, 620),
    "rod ratio l/r": (300, 500),
    "rod ratio l/s": (150, 250),
    "crank ratio r/l": (15, 40),
    "rod length": (300, 500),
    "crank radius": (60, 100),
    "stroke": (120, 200),
}
"""Where letters are tried, in hundredths: such that a rod is longer than its crank."""
UNITS = (
    "m",
    "mm",
    "kg",
    "g",
    "s",
    "rpm",
    "rad/s",
    "N",
    "m/s",
    "m/s^2",
    "m/s²",
    "kg m",
    "N m",
    "bar",
    "Pa",
)


def plain_meaning(text: str) -> str:
    """Return the known meaning a declaration states, or its text.

    >>> plain_meaning("Crank radius, half the stroke")
    'crank radius'
    """
    head = text.split(",", maxsplit=1)[0].strip()
    lowered = " ".join(head.lower().split())
    lowered = ALIASES.get(lowered, lowered)
    return lowered if lowered in KNOWN else head


def two() -> Number:
    """Return 2."""
    return Number(Fraction(2))


def square(node: Node) -> Power:
    """Return node²."""
    return Power(node, two())


def one_minus(node: Node) -> Sum:
    """Return 1 - node."""
    return Sum((Number(Fraction(1)), syntax.Negative(node)))


@dataclass(frozen=True)
class Geometry:
    """The letters of a slider-crank, each as a formula in the document's own letters."""

    theta: Node
    radius: Node
    length: Node
    omega: Node
    mass: Node
    time: str
    pitch: Node | None
    small: tuple[str, int] | None
    """The letter the document expands in: ("lambda", -1) where it is large, ("rho", 1) where small."""

    @property
    def ratio(self) -> Node:
        """r/l."""
        return Quotient(self.radius, self.length)

    @property
    def root(self) -> Node:
        """√(1 - (r/l)² sin² θ)."""
        return Call("sqrt", one_minus(Product((square(self.ratio), square(Call("sin", self.theta))))))

    @property
    def displacement(self) -> Node:
        """x from top dead centre, towards the crank."""
        crank = Product((self.radius, one_minus(Call("cos", self.theta))))
        return Sum((crank, Product((self.length, one_minus(self.root)))))

    @property
    def position(self) -> Node:
        """The height of the piston pin above the crank's centre."""
        return Sum((Product((self.radius, Call("cos", self.theta))), Product((self.length, self.root))))

    @property
    def velocity(self) -> Node:
        """dx/dt = r ω (sin θ + (r/l) sin θ cos θ/√), √ being `root`."""
        sine, cosine = Call("sin", self.theta), Call("cos", self.theta)
        second = Quotient(Product((self.ratio, sine, cosine)), self.root)
        return Product((self.radius, self.omega, Sum((sine, second))))

    @property
    def acceleration(self) -> Node:
        """d²x/dt² = r ω² (cos θ + (r/l) cos 2θ/√ + (r/l)³ sin² θ cos² θ/√³), √ being `root`."""
        sine, cosine = Call("sin", self.theta), Call("cos", self.theta)
        three, root = Number(Fraction(3)), self.root
        second = Quotient(Product((self.ratio, Call("cos", Product((two(), self.theta))))), root)
        third = Product((Power(self.ratio, three), square(sine), square(cosine)))
        bracket = Sum((cosine, second, Quotient(third, Power(root, three))))
        return Product((self.radius, square(self.omega), bracket))

    @property
    def force(self) -> Node:
        """m d²x/dt²: the inertia force, away from the crank."""
        return Product((self.mass, self.acceleration))


def by_meaning(symbols: Mapping[str, str]) -> dict[str, list[str]]:
    """Return the letters of each meaning."""
    found: dict[str, list[str]] = {}
    for name, text in symbols.items():
        found.setdefault(plain_meaning(text), []).append(name)
    return found


def geometry(symbols: Mapping[str, str], convention: str = "") -> Geometry:
    """Return the slider-crank in the letters of a document; `convention` says what its λ or ρ means."""
    letters = by_meaning(symbols)

    def first(*meanings: str) -> Node | None:
        return next((Name(letters[m][0]) for m in meanings if m in letters), None)

    radius = first("crank radius")
    stroke = first("stroke")
    if radius is None or (stroke is not None and first("rod ratio l/s") is not None):
        radius = Quotient(stroke, two()) if stroke is not None else radius or Name("r")
    length, small = _length(letters, radius, convention)
    speed = first("engine speed rpm")
    by_rpm = (
        Quotient(Product((Constant("pi"), speed)), Number(Fraction(30))) if speed is not None else None
    )
    return Geometry(
        theta=first("crank angle") or Name("theta"),
        radius=radius,
        length=length,
        omega=first("angular speed") or by_rpm or Name("omega"),
        mass=first("reciprocating mass") or Name("m"),
        time=letters.get("time", ["t"])[0],
        pitch=first("cylinder pitch"),
        small=small,
    )


def _length(
    letters: dict[str, list[str]], radius: Node, convention: str
) -> tuple[Node, tuple[str, int] | None]:
    """Return l in the document's letters, and the letter that is small or large."""
    stated = {"l/r": "rod ratio l/r", "l/s": "rod ratio l/s", "r/l": "crank ratio r/l"}
    if convention and not any(m in letters for m in stated.values()):
        name = "rho" if convention == "r/l" else "lambda"
        return _length_from(stated[convention], name, radius)
    for meaning in stated.values():
        if meaning in letters and (not convention or stated[convention] == meaning):
            return _length_from(meaning, letters[meaning][0], radius)
    if convention:
        names = [n for m in stated.values() for n in letters.get(m, [])]
        return _length_from(stated[convention], names[0], radius)
    name = letters.get("rod length", ["l"])[0]
    return Name(name), (name, -1)


def _length_from(meaning: str, name: str, radius: Node) -> tuple[Node, tuple[str, int]]:
    if meaning == "crank ratio r/l":
        return Quotient(radius, Name(name)), (name, 1)
    if meaning == "rod ratio l/s":
        return Product((Name(name), Product((two(), radius)))), (name, -1)
    return Product((Name(name), radius)), (name, -1)


def meaning_of(symbols: Mapping[str, str], convention: str = "") -> tuple[Meaning, Geometry]:
    """Return what the declared letters stand for, and the slider-crank in them.

    >>> found, crank = meaning_of({"s": "stroke", "l": "rod length", "lambda": "rod ratio l/s"})
    >>> sorted(found.values), crank.small
    (['l'], ('lambda', -1))
    """
    crank, letters = geometry(symbols, convention), by_meaning(symbols)
    stands_for: dict[str, Node] = {
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
        _FROM_TOP: crank.displacement,
        _FROM_PIN: crank.position,
        _FROM_MIDDLE: Sum((crank.position, syntax.Negative(crank.length))),
        "piston velocity": crank.velocity,
        "piston acceleration": crank.acceleration,
        "inertia force": crank.force,
    }
    base = {n for part in (crank.radius, crank.length, crank.omega) for n in syntax.names(part)}
    values: dict[str, Node] = {
        n: _harmonic(m, crank) for m in letters if _HARMONIC.match(m) for n in letters[m]
    }
    for meaning, node in stands_for.items():
        for name in letters.get(meaning, []):
            if name not in base:
                values[name] = node
    for name in [n for m in MOVING for n in letters.get(m, ())]:
        for order in (1, 2):
            primed = name + "'" * order
            if primed not in symbols and isinstance(crank.theta, Name):
                values[primed] = Derivative(Name(name), crank.theta, order)
    rates: dict[str, Mapping[str, Node]] = {}
    if isinstance(crank.theta, Name):
        rates[crank.time] = {crank.theta.name: crank.omega}
    positive = {n for m in _POSITIVE for n in letters.get(m, [])} | {"r", "l", "omega", "m"} & _loose(
        crank
    )
    positive |= {n for n, text in symbols.items() if plain_meaning(text) in UNITS}
    integer = frozenset(letters.get("integer", ()))
    ranges = {name: size for m, size in RANGES.items() for name in letters.get(m, ())}
    return Meaning(values, rates, frozenset(positive), integer, ranges), crank


def _harmonic(meaning: str, crank: Geometry) -> Node:
    """Return A_n of the acceleration as a series in r/l, far beyond what anybody writes."""
    order = int(meaning[2:])
    return series_node(order, far_power(order), crank.ratio)


def far_power(order: int) -> int:
    """Return the power of r/l through which A_n is taken where nobody says."""
    return max(SAME_POWER, order + 7)


def series_node(order: int, power: int, ratio: Node) -> Node:
    """Return A_order through a power of r/l."""
    if not surviving(order):
        return Number(Fraction(0))
    terms = [_term(c, p, ratio) for p, c in sorted(acceleration_series(order, power).terms.items())]
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _term(coefficient: Fraction, power: int, ratio: Node) -> Node:
    if power == 0:
        return rational_node(coefficient)
    return Product((rational_node(coefficient), Power(ratio, Number(Fraction(power)))))


def _loose(crank: Geometry) -> set[str]:
    nodes = (crank.radius, crank.length, crank.omega, crank.mass)
    return {name for node in nodes for name in syntax.names(node)}
