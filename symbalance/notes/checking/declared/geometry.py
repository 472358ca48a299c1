"""The slider-crank's motion as formulas in a document's own letters.

One letter of each kind is the base that the others are written in: a document in s and λ = l/s is
judged, and corrected, in s and λ.

    x = r (1 - cos θ) + l (1 - √(1 - (r/l)² sin² θ))     from top dead centre
    v = dx/dt,  a = d²x/dt²,  dθ/dt = ω,  F = m a        F away from the crank
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.notes.checking.declared.symbol_roles import letters_by_role
from symbalance.text import lazy_patterns as re


def two() -> Number:
    """Return 2."""
    return Number(Fraction(2))


def square(node: Formula) -> Power:
    """Return node²."""
    return Power(node, two())


def one_minus(node: Formula) -> Sum:
    """Return 1 - node."""
    return Sum((Number(Fraction(1)), formula.Negative(node)))


@dataclass(frozen=True)
class Geometry:
    """The letters of a slider-crank, each as a formula in the document's own letters."""

    theta: Formula
    radius: Formula
    length: Formula
    omega: Formula
    mass: Formula
    time: str
    pitch: Formula | None
    small: tuple[str, int] | None
    """The letter the document expands in: ("lambda", -1) where it is large, ("rho", 1) where small."""

    @property
    def ratio(self) -> Formula:
        """r/l."""
        return Quotient(self.radius, self.length)

    @property
    def root(self) -> Formula:
        """√(1 - (r/l)² sin² θ)."""
        return Call("sqrt", one_minus(Product((square(self.ratio), square(Call("sin", self.theta))))))

    @property
    def displacement(self) -> Formula:
        """x from top dead centre, towards the crank."""
        crank = Product((self.radius, one_minus(Call("cos", self.theta))))
        return Sum((crank, Product((self.length, one_minus(self.root)))))

    @property
    def position(self) -> Formula:
        """The height of the piston pin above the crank's centre."""
        return Sum((Product((self.radius, Call("cos", self.theta))), Product((self.length, self.root))))

    @property
    def velocity(self) -> Formula:
        """dx/dt = r ω (sin θ + (r/l) sin θ cos θ/√), √ being `root`."""
        sine, cosine = Call("sin", self.theta), Call("cos", self.theta)
        second = Quotient(Product((self.ratio, sine, cosine)), self.root)
        return Product((self.radius, self.omega, Sum((sine, second))))

    @property
    def acceleration(self) -> Formula:
        """d²x/dt² = r ω² (cos θ + (r/l) cos 2θ/√ + (r/l)³ sin² θ cos² θ/√³), √ being `root`."""
        sine, cosine = Call("sin", self.theta), Call("cos", self.theta)
        three, root = Number(Fraction(3)), self.root
        second = Quotient(Product((self.ratio, Call("cos", Product((two(), self.theta))))), root)
        third = Product((Power(self.ratio, three), square(sine), square(cosine)))
        bracket = Sum((cosine, second, Quotient(third, Power(root, three))))
        return Product((self.radius, square(self.omega), bracket))

    @property
    def force(self) -> Formula:
        """m d²x/dt²: the inertia force, away from the crank."""
        return Product((self.mass, self.acceleration))


_FROM_TOP = re.compile(
    r"(?<![^\W\d_])(?:o\.?t\.?|tdc|top dead|oberen totpunkt|pmh|pms|point mort haut|punto morto superiore"
    r"|punto muerto superior)(?![^\W\d_])|上死点",
    re.IGNORECASE,
)


def _angle_of_cylinder(letters: Sequence[str], symbols: Mapping[str, str]) -> Name | None:
    """Return the crank angle that a piston's motion is a formula of: the one counted from its own top.

    Of an engine with banks another one may be counted from the line between these.
    """
    own = [name for name in letters if _FROM_TOP.search(symbols[name])] if len(letters) > 1 else ()
    return next((Name(name) for name in (*own, *letters)), None)


def geometry(symbols: Mapping[str, str], convention: str = "") -> Geometry:
    """Return the slider-crank in the letters of a document; `convention` says what its λ or ρ means."""
    letters = letters_by_role(symbols)

    def first(*meanings: str) -> Formula | None:
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
        theta=_angle_of_cylinder(letters.get("crank angle", ()), symbols) or Name("theta"),
        radius=radius,
        length=length,
        omega=first("angular speed") or by_rpm or Name("omega"),
        mass=first("reciprocating mass") or Name("m"),
        time=letters.get("time", ["t"])[0],
        pitch=first("cylinder pitch"),
        small=small,
    )


def _length(
    letters: dict[str, list[str]], radius: Formula, convention: str
) -> tuple[Formula, tuple[str, int] | None]:
    """Return l in the document's letters, and the letter that is small or large."""
    ratio_meanings = {"l/r": "rod ratio l/r", "l/s": "rod ratio l/s", "r/l": "crank ratio r/l"}
    if convention and not any(m in letters for m in ratio_meanings.values()):
        name = "rho" if convention == "r/l" else "lambda"
        return _length_from(ratio_meanings[convention], name, radius)
    for meaning in ratio_meanings.values():
        if meaning in letters and (not convention or ratio_meanings[convention] == meaning):
            return _length_from(meaning, letters[meaning][0], radius)
    if convention:
        names = [n for m in ratio_meanings.values() for n in letters.get(m, [])]
        return _length_from(ratio_meanings[convention], names[0], radius)
    name = letters.get("rod length", ["l"])[0]
    return Name(name), (name, -1)


def _length_from(meaning: str, name: str, radius: Formula) -> tuple[Formula, tuple[str, int]]:
    if meaning == "crank ratio r/l":
        return Quotient(radius, Name(name)), (name, 1)
    if meaning == "rod ratio l/s":
        return Product((Name(name), Product((two(), radius)))), (name, -1)
    return Product((Name(name), radius)), (name, -1)
