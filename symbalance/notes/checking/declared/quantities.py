"""Formulas of quantities a line may be declared to be: piston motion, forces and couples of engines.

One cylinder: displacement, position, velocity, acceleration, force. An engine: force and couple of an
order, of the whole engine, of one bank or of one cylinder. The sum over cylinders of
weight cos n(θ + delay), with weight 1 (force), station (couple), times the cosine or sine of the bank, is
written out and left to the algebra: it is exact, and short enough.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Equation,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    children,
    with_children,
)
from symbalance.errors import SymbalanceError
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.declared.engines import Engines, KnownCylinder, KnownEngine, Sources
from symbalance.notes.checking.declared.geometry import Geometry
from symbalance.notes.checking.declared.sidecar import Binding
from symbalance.notes.checking.declared.symbols import far_power, series_node

UNITS = ("", "F", "F_n")

ONE_CYLINDER: dict[str, Callable[[Geometry], Formula]] = {
    "displacement": lambda crank: crank.displacement,
    "position": lambda crank: crank.position,
    "velocity": lambda crank: crank.velocity,
    "acceleration": lambda crank: crank.acceleration,
    "force": lambda crank: crank.force,
}
_COMPONENTS = ("force.vertical", "force.lateral", "couple.vertical", "couple.lateral")
OF_AN_ENGINE = (
    "force",
    "couple",
    *_COMPONENTS,
    *(f"{c}.{f}" for c in _COMPONENTS for f in ("cos", "sin")),
)
EQUATIONS = ("crank-node",)
"""Equations between columns that a whole relation may be bound to."""
QUANTITIES = (*EQUATIONS, *ONE_CYLINDER, *OF_AN_ENGINE[1:], "coefficient", "harmonic", "value")


def quantity(binding: Binding, crank: Geometry, sources: Sources, in_numbers: bool) -> Formula:
    """Return what a bound line claims to be; `in_numbers` puts in the engine's own rod ratio."""
    if binding.quantity not in QUANTITIES:
        raise _refusal(binding, "quantity", binding.quantity, "known are " + ", ".join(QUANTITIES))
    if binding.unit not in UNITS:
        raise _refusal(binding, "unit", binding.unit, 'write "F" (m r ω² = 1) or "F_n" (A_n m r ω² = 1)')
    if binding.quantity == "value":
        if not binding.scale:
            raise _refusal(binding, "scale", "", 'add what the line should be: scale = "L sin α"')
        return Number(Fraction(1))
    if binding.engine == "" and binding.quantity in ONE_CYLINDER and binding.order is None:
        return ONE_CYLINDER[binding.quantity](crank)
    if binding.order is None:
        raise _refusal(binding, "order", None, "add order = 2")
    engine = _engine(binding, sources) if binding.engine else None
    coefficient = _coefficient(binding, crank, engine, in_numbers, sources.engines)
    if binding.quantity == "coefficient":
        return coefficient
    if engine is None:
        raise _refusal(binding, "engine", "", 'add engine = "v12-60"')
    parts: list[Formula] = [geometry(binding, engine, crank.theta)]
    if binding.unit != "F_n":
        parts.append(coefficient)
    if binding.unit == "":
        parts += [crank.mass, crank.radius, Power(crank.omega, Number(Fraction(2)))]
        parts += (
            [crank.pitch] if binding.quantity.startswith("couple") and crank.pitch is not None else []
        )
    return Product(tuple(parts))


def equation_of(binding: Binding, sources: Sources, symbols: Mapping[str, str]) -> Equation:
    """Return the equation a relation is bound to, in the document's letters: M = "m of crank-node"."""
    known = sources.engines.equation(binding.quantity)
    suffix = f" of {binding.quantity}"
    letters = {
        text.removesuffix(suffix).strip(): name for name, text in symbols.items() if text.endswith(suffix)
    }

    def renamed(node: Formula) -> Formula:
        if isinstance(node, Name):
            return Name(letters.get(node.name, node.name))
        parts = children(node)
        return with_children(node, tuple(map(renamed, parts))) if parts else node

    return Equation(renamed(known.left), tuple((sign, renamed(side)) for sign, side in known.links))


def _refusal(binding: Binding, key: str, value: object, remedy: str) -> SymbalanceError:
    return SymbalanceError(f"{key} = {value}", "is not usable here", remedy, f"{binding.place}: bind")


def _engine(binding: Binding, sources: Sources) -> KnownEngine:
    try:
        return sources.engines.engine(binding.engine, sources.folder)
    except SymbalanceError as problem:
        raise problem.within(f"{binding.place}: bind") from None


def _coefficient(
    binding: Binding, crank: Geometry, engine: KnownEngine | None, in_numbers: bool, engines: Engines
) -> Formula:
    """Return A_n as a series in the document's letter, or its value for the engine's rod ratio."""
    order = binding.order or 1
    if not engines.coefficient_terms(order, order):
        return Number(Fraction(0))  # no ratio and no power makes an order that no slider-crank has
    if in_numbers:
        if engine is None or engine.ratio is None:
            raise _refusal(binding, "engine", binding.engine, "name an engine with a rod ratio")
        return Number(engines.coefficient_value(order, engine.ratio))
    power = binding.power if binding.power is not None else far_power(order)
    return series_node(engines.coefficient_terms(order, power), crank.ratio)


def geometry(binding: Binding, engine: KnownEngine, theta: Formula) -> Formula:
    """Return the sum over the bound cylinders of weight cos n(θ + delay)."""
    kind, component, function = (*binding.quantity.split("."), "", "")[:3]
    cylinders = [c for c in engine.cylinders if _is_meant(binding, c, engine)]
    if not cylinders:
        raise _refusal(binding, "cylinder", binding.cylinder, "name a cylinder or bank the engine has")
    if not component and binding.cylinder is None and len({c.bank for c in cylinders}) > 1:
        raise _refusal(binding, "quantity", binding.quantity, f"write {kind}.vertical or {kind}.lateral")
    order, plane = Number(Fraction(binding.order or 1)), engine.mean_station
    wave = Product((order, theta))
    if function:  # the coefficient of cos nθ or sin nθ alone
        wave = Number(Fraction(0)) if function == "cos" else Quotient(Constant("pi"), Number(Fraction(2)))
    terms: list[Formula] = []
    for cylinder in cylinders:
        weight = cylinder.station - plane if kind == "couple" else Fraction(1)
        terms.append(_of_cylinder(cylinder, binding.order or 1, weight, component, wave))
    return Sum(tuple(terms))


def _is_meant(binding: Binding, cylinder: KnownCylinder, engine: KnownEngine) -> bool:
    if binding.cylinder is not None:
        return cylinder.number == binding.cylinder
    if binding.bank is not None:
        banks = list(dict.fromkeys(c.bank for c in engine.cylinders))
        return 1 <= binding.bank <= len(banks) and cylinder.bank == banks[binding.bank - 1]
    return True


def _of_cylinder(
    cylinder: KnownCylinder, order: int, weight: Fraction, component: str, wave: Formula
) -> Formula:
    wave_of_cylinder = Call("cos", Sum((wave, _angle(cylinder.delay.turns * order))))
    parts: list[Formula] = [rational_node(weight), wave_of_cylinder]
    if component:
        function = "cos" if component == "vertical" else "sin"
        parts.append(Call(function, _angle(cylinder.bank.turns)))
    return Product(tuple(parts))


def _angle(turns: Fraction) -> Formula:
    angle = Product((rational_node(abs(turns) * 2), Constant("pi")))
    return Negative(angle) if turns < 0 else angle
