"""The numbers a page moves by: cylinders as lengths and angles, weights as harmonics, scales."""

from __future__ import annotations

from fractions import Fraction
from math import hypot, pi
from typing import Any

from symbalance.drawing.crank_star import star_resultant
from symbalance.drawing.firing_diagram import WIDTH
from symbalance.drawing.plan import plan_scale, throws_in_plan
from symbalance.drawing.positions import Machine
from symbalance.drawing.section import section_scale
from symbalance.engine.engine import Engine
from symbalance.forces.force_sums import rotor_spectrum, turning_vectors
from symbalance.forces.free_forces import Balance
from symbalance.kinematics.mechanisms import LinkRod, SliderCrank

OBLIQUE = 200.0
"""Pixels from the middle of the oblique view to its edge."""
WIDEST_VEE = 180


def engine_data(balance: Balance) -> dict[str, Any]:
    """Return what the page's script computes from; lengths in crank radii, angles in radians."""
    engine = balance.engine
    machine = Machine(engine)
    radius = machine.radius(engine.first)
    plan, _ = plan_scale(machine)
    length = float(max(c.station for c in engine.cylinders) - min(c.station for c in engine.cylinders))
    # However it is turned, nothing is farther from its middle than this.
    reach = hypot(machine.reach + 0.4 * machine.bore, machine.pitch * (length / 2 + 0.7))
    orders = sorted({1, 2, *(n for n in (*balance.force.orders(), *balance.couple.orders()) if n <= 8)})
    between = _between(engine)
    return {
        "name": engine.name,
        "strokes": engine.strokes,
        "cylinders": _cylinders(engine),
        "turning": _turning(balance),
        "hasWeights": bool(engine.balancers.counterweights or engine.balancers.shafts),
        "stars": _stars(engine, orders),
        "comparesTorque": not (engine.has_link_pin_masses or any(c.excess for c in engine.cylinders)),
        "lambda": None if _ratio(engine) is None else float(engine.ratio or 0),
        "bankBetween": None if between is None else between[0],
        "bankMiddle": None if between is None else between[1],
        "order": min([*balance.force.orders(), *balance.couple.orders()], default=1),
        "orders": orders,
        "bore": machine.bore / radius,
        "pitch": machine.pitch / radius,
        "drawsOblique": len(engine.cylinders) <= 32,
        "plan": [c.number for c in throws_in_plan(machine)],
        "throws": _throws(engine),
        "firingScale": WIDTH / (180 * engine.strokes),
        "scales": {
            "section": section_scale(machine) * radius,
            "plan": plan * radius,
            "oblique": OBLIQUE * radius / reach,
        },
        "sizes": _sizes(engine),
        "rpm": 0 if balance.operating_point is None else float(balance.operating_point.rpm),
    }


def _cylinders(engine: Engine) -> list[dict[str, Any]]:
    rows = []
    for cylinder, size, radius, arm in zip(
        engine.cylinders, engine.sizes, engine.radii, engine.lever_arms(), strict=True
    ):
        mechanism = cylinder.known_mechanism
        throw = cylinder.throw if cylinder.master is None else cylinder.master.throw
        row: dict[str, Any] = {
            "number": cylinder.number,
            "bank": 2 * pi * float(cylinder.bank.turns),
            "throw": 2 * pi * float(throw.turns),
            "arm": float(arm),
            "radius": float(radius),
            "length": float(mechanism.length),
            "offset": float(mechanism.offset),
            "mass": float(size),
        }
        if isinstance(mechanism, LinkRod):
            direction = 2 * pi * float(mechanism.pin_direction)
            assert cylinder.link is not None
            row["link"] = {
                "master": cylinder.link.master,
                "direction": direction,
                "radius": float(mechanism.link_radius),
            }
        rows.append(row)
    return rows


def _turning(balance: Balance) -> list[dict[str, Any]]:
    """Return weights, shafts and link pins as c e^(i n theta), m r omega^2 (couples: times a)."""
    terms = []
    engine = balance.engine
    plane = engine.mean_station if balance.reference is None else balance.reference
    vectors = turning_vectors(engine, balance.highest, balance.reference)
    for of, spectrum, about in zip(("force", "couple"), vectors, (None, plane), strict=True):
        # What a designer may change; masses on link pins stay.
        weights = rotor_spectrum(engine, balance.highest, about)
        for name, part in (("weights", weights), ("rest", spectrum + weights.scaled(-1))):
            for order, number in part.terms.items():
                c = complex(number.evaluated(20)) * float(balance.share(abs(order)))
                row = {"of": of, "order": order, "value": [c.real, c.imag]}
                terms.append(row | ({"weight": 1} if name == "weights" else {}))
    return terms


def _stars(engine: Engine, orders: list[int]) -> dict[str, Any]:
    """Return what the crank stars are drawn from: banks, arrows, and which stars are proved to close."""
    banks = list(engine.grouped(lambda c: c.bank).values())
    return {
        "banks": [2 * pi * float(group[0].bank.turns) for group in banks],
        "arrows": [[[c.number, float(c.delay.turns)] for c in group] for group in banks],
        "closed": {
            str(n): [star_resultant(group, Fraction(n)).is_zero() for group in banks] for n in orders
        },
    }


def _ratio(engine: Engine) -> object:
    """Return the one rod ratio that a slider may change: of plain slider-cranks that all have it."""
    plain = all(isinstance(c.known_mechanism, SliderCrank) and c.link is None for c in engine.cylinders)
    # What is in kg mm, or a shaft's share of A_n, would change with it.
    return engine.ratio if plain and not engine.balancers.shafts else None


def _between(engine: Engine) -> tuple[float, float] | None:
    """Return the angle between the two banks of a vee and the direction of its middle, or None."""
    banks = sorted({float(c.bank.turns) for c in engine.cylinders})
    if len(banks) != 2 or any(c.link or c.offset for c in engine.cylinders):
        return None
    if engine.balancers.counterweights or engine.balancers.shafts:
        return None
    low, high = banks
    return 360 * (high - low), pi * (high + low)


def _throws(engine: Engine) -> list[dict[str, Any]]:
    """Return the crank's throws as the cross-section has them: a cylinder of each, and its angle."""
    throws: dict[float, int] = {}
    for cylinder in sorted(engine.cylinders, key=lambda c: (-c.station, c.number)):
        own = cylinder.throw if cylinder.master is None else cylinder.master.throw
        throws.setdefault(2 * pi * float(own.turns), cylinder.number)
    return [{"cylinder": number, "angle": angle} for angle, number in throws.items()]


def _sizes(engine: Engine) -> dict[str, float | None] | None:
    """Return mass, crank radius and pitch in SI units, or None where a force has no newtons."""
    mass, radius = engine.first.reciprocating_mass, engine.first.radius
    if mass is None or radius is None:
        return None
    pitch = None if engine.pitch is None else float(engine.pitch) / 1000
    return {"mass": float(mass), "radius": float(radius) / 1000, "pitch": pitch}
