"""The numbers a page moves by: cylinders as lengths and angles, weights as harmonics, scales."""

from __future__ import annotations

import re
from fractions import Fraction
from math import pi
from typing import TYPE_CHECKING, Any

from symbalance.drawing.crank_star import star_resultant
from symbalance.drawing.positions import Machine
from symbalance.drawing.section import section_scale
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.engine.engine_writing import engine_text
from symbalance.forces.force_sums import rotor_spectrum, turning_vectors
from symbalance.forces.free_forces import Balance
from symbalance.kinematics.mechanisms import LinkRod, SliderCrank

if TYPE_CHECKING:
    from symbalance.torque.running import RunningTorque

WIDEST_VEE = 180
MOST_DIRECTIONS = 4
"""Beyond, one star for each direction of an axis says less than what turns with and against the crank."""
HALF_ORDERS = tuple(Fraction(k, 2) for k in (1, 3, 5, 7, 9))
DELTA = 0.02
"""A flywheel's speed fluctuation, where none is given."""


def engine_data(balance: Balance, running: RunningTorque | None = None) -> dict[str, Any]:
    """Return what the page's script computes from; lengths in crank radii, angles in radians."""
    engine = balance.engine
    machine = Machine(engine)
    radius = machine.radius(engine.first)
    surviving = [*balance.force.orders(), *balance.couple.orders()]
    order = min(surviving, default=1)
    least = [min(of.orders()) for of in (balance.force, balance.couple) if of.orders()]
    orders = sorted({1, 2, *least, *(n for n in surviving if n <= 8)})
    between = _between(engine)
    plane = engine.mean_station if balance.reference is None else balance.reference
    unit_mass, unit_radius = engine.first.reciprocating_mass, engine.first.radius
    return {
        "name": engine.name,
        "strokes": engine.strokes,
        "cylinders": _cylinders(engine),
        "plane": float(plane),
        "turning": _turning(balance),
        "hasWeights": bool(engine.balancers.counterweights or engine.balancers.shafts),
        "hasRods": bool(unit_mass and unit_radius and any(c.excess for c in engine.cylinders)),
        "stars": _stars(balance, orders, _half_orders(engine)),
        "comparesTorque": not (engine.has_link_pin_masses or any(c.excess for c in engine.cylinders)),
        "lambda": None if _ratio(engine) is None else float(engine.ratio or 0),
        "bankBetween": None if between is None else between[0],
        "bankMiddle": None if between is None else between[1],
        "bankText": None if between is None else between[2],
        "order": order,
        "orders": orders,
        "halfOrders": [float(n) for n in _half_orders(engine)],
        "barOrders": sorted({1, 2, *surviving}),
        "present": {"force": list(balance.force.orders()), "couple": list(balance.couple.orders())},
        "bore": machine.bore / radius,
        "pitch": machine.pitch / radius,
        "throws": _throws(engine),
        "scales": {"section": section_scale(machine) * radius},
        "radius": None if unit_radius is None else float(unit_radius) / 1000,
        "sizes": _sizes(engine),
        "rpm": 0 if balance.operating_point is None else float(balance.operating_point.rpm),
        "delta": DELTA if running is None else running.delta,
        "gas": None if running is None else gas_data(running),
        # What turns with a pin would turn with an edited one, and a link rod is hung on another's.
        "editable": not any(c.link for c in engine.cylinders) and not engine.rotating_masses,
        "file": _file(engine),
    }


def _half_orders(engine: Engine) -> tuple[Fraction, ...]:
    """Return the half orders of the torque that a star is drawn of: those of a four-stroke that fires."""
    fires = engine.strokes == 4 and all(c.fires is not None for c in engine.cylinders)
    return HALF_ORDERS if fires and len(engine.cylinders) > 1 else ()


def _file(engine: Engine) -> dict[str, Any]:
    """Return the engine's file in parts: what stands before its cylinders, each of them, what follows."""
    head, *rows = engine_text(engine).split("[[cylinder]]\n")
    rows[-1], *tail = re.split(r"\n(?=\[\[(?:counterweight|balance_shaft)\]\])", rows[-1], maxsplit=1)
    return {"head": head, "rows": rows, "tail": "".join(tail)}


def gas_data(running: RunningTorque) -> dict[str, Any]:
    """Return what gas torque is computed from: bar above ambient over the cycle, a trace a kind."""
    traces: list[dict[str, Any]] = []
    places: dict[int, int] = {}
    of: dict[int, int] = {}
    for cylinder, own in zip(running.engine.cylinders, running.cylinders, strict=True):
        tangential = own.tangential
        if id(tangential) not in places:
            places[id(tangential)] = len(traces)
            trace = tangential.trace
            # Counted from the piston's own top dead centre, as the page's firing angles are.
            points = [*zip(trace.degrees, trace.bar, strict=True), (float(trace.cycle), trace.closed[-1])]
            if trace.degrees[0] > 0:
                points.insert(0, (0.0, trace.at(0.0)))
            kept = _thinned([(a, p - tangential.ambient) for a, p in points])
            angles, bar = [round(a, 4) for a, _ in kept], [float(f"{p:.6g}") for _, p in kept]
            traces.append({"degrees": angles, "bar": bar})
        of[cylinder.number] = places[id(tangential)]
    return {"area": running.area, "traces": traces, "of": of}


def _thinned(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return of a line's points those without which it would go astray by `STRAY` of its range."""
    allowed = STRAY * (max(p for _, p in points) - min(p for _, p in points))
    kept = {0, len(points) - 1}
    parts = [(0, len(points) - 1)]
    while parts:
        low, high = parts.pop()
        (a, p), (b, q) = points[low], points[high]
        off = [
            (abs(y - (p if b == a else p + (x - a) * (q - p) / (b - a))), k)
            for k, (x, y) in enumerate(points[low + 1 : high], low + 1)
        ]
        most, place = max(off, default=(0.0, low))
        # Of a jump both sides stay.
        if most > allowed:
            kept.add(place)
            parts += [(low, place), (place, high)]
    return [points[k] for k in sorted(kept)]


STRAY = 2e-5
"""Of the pressure's range: a hundredth of what is seen in a drawing, in a tenth of the room."""


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
            "station": float(cylinder.station),
            "fires": None if cylinder.fires is None else float(cylinder.fires),
            "radius": float(radius),
            "length": float(mechanism.length),
            "offset": float(mechanism.offset),
            "mass": float(size),
        }
        mass, crank = engine.first.reciprocating_mass, engine.first.radius
        if cylinder.excess and mass and crank:
            row["excess"] = float(cylinder.excess / (mass * crank**2))
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


def _stars(balance: Balance, orders: list[int], halves: tuple[Fraction, ...]) -> dict[str, Any]:
    """Return which crank stars are proved to close, and whether they are of turning parts or of banks."""
    engine = balance.engine
    banks = list(engine.grouped(lambda c: c.bank).values())
    turning = len(banks) > MOST_DIRECTIONS or any(c.link for c in engine.cylinders)
    closed: dict[str, list[bool]] = {}
    for n in orders:
        if not turning:
            closed[str(n)] = [
                _alike(group) and star_resultant(group, Fraction(n)).is_zero() for group in banks
            ]
        elif not engine.rotating_masses and not engine.has_link_pin_masses:
            terms = balance.force.terms
            closed[str(n)] = [n not in terms, -n not in terms]
    for half in halves:
        closed[f"{half.numerator}/2"] = [star_resultant(engine.cylinders, half).is_zero()]
    return {"turning": turning, "unlike": not _alike(engine.cylinders), "closed": closed}


def _alike(cylinders: tuple[Cylinder, ...]) -> bool:
    """Tell whether cylinders move alike, so that a star's arrows are as long as each other."""
    kinds = {(c.mechanism, c.reciprocating_mass, c.radius) for c in cylinders}
    return len(kinds) == 1


def _ratio(engine: Engine) -> object:
    """Return the one rod ratio that a slider may change: of plain slider-cranks that all have it."""
    plain = all(isinstance(c.known_mechanism, SliderCrank) and c.link is None for c in engine.cylinders)
    # What is in kg mm, or a shaft's share of A_n, would change with it.
    return engine.ratio if plain and not engine.balancers.shafts else None


def _between(engine: Engine) -> tuple[float, float, str] | None:
    """Return a vee's angle, the direction of its middle and the angle as an exact text, or None."""
    banks = sorted({c.bank.in_degrees() for c in engine.cylinders})
    if len(banks) != 2 or any(c.link or c.offset for c in engine.cylinders):
        return None
    if engine.balancers.counterweights or engine.balancers.shafts:
        return None
    low, high = banks
    if high - low > WIDEST_VEE:
        return None
    return float(high - low), float(high + low) * pi / 360, str(high - low)


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
