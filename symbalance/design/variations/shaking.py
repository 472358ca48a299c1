"""Shaking force and couple of weighed masses: their units, and the vectors that 1 kg of each adds."""

from __future__ import annotations

from cmath import rect
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi, sqrt

from symbalance.design.variations.as_built import NOTHING, as_built_parts
from symbalance.design.variations.assignment_bounds import Generators, Vector
from symbalance.design.variations.contributions import Contribution, rotating_pair
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.forces.operating_point import MILLI, acceleration_at, needed
from symbalance.kinematics.mechanisms.moving_masses import link_pin_force
from symbalance.text.numbers import exact


@dataclass(frozen=True)
class Shaking:
    """Residual of one order for an assignment: largest force and couple over a turn, and their RMS."""

    order: int
    force: float
    couple: float
    mean_force: float
    mean_couple: float


@dataclass(frozen=True)
class Units:
    """r omega^2 of cylinder 1 and the pitch, in the units of the result, and the lever in pitches."""

    force: float
    arm: float
    lever: float
    names: tuple[str, str]


def units_of(
    engine: Engine, speed: Fraction | None, lever: object, rows: Sequence[Contribution]
) -> Units:
    """Return the units that the sizes given allow, and the lever that couples count at."""
    radius, pitch = engine.first.radius, engine.pitch
    force, arm, names = 1.0, 1.0, ("kg · r ω²", "kg · r ω² a")
    if speed is not None:
        if radius is None:
            raise needed(speed, ["stroke"])
        force, names = float(acceleration_at(speed, radius * MILLI)), ("N", "N a")
    if pitch is not None and speed is not None:
        arm, names = float(pitch) / 1000, (names[0], "N m")
    spread = sqrt(sum(float(s.arm) ** 2 for s in rows) / len(rows)) or 1.0
    if lever is not None:
        length = exact(lever, "lever")
        if length <= 0 or pitch is None:
            rule = "must be positive" if length <= 0 else "needs the engine's pitch"
            raise SymbalanceError(f"lever = {brief(lever)}", rule, "mm; give pitch in [crank_train]")
        spread = float(length / pitch)
    return Units(force, arm, spread, names)


def generators(engine: Engine, orders: Sequence[Sequence[Contribution]], units: Units) -> Generators:
    """Return, for each cylinder, what 1 kg of reciprocating and of rotating mass adds: real vectors."""
    vectors = []
    for place, (cylinder, own_radius) in enumerate(zip(engine.cylinders, engine.radii, strict=True)):
        radius = units.force * float(own_radius)
        pins = link_pin_force(cylinder.mechanism, max((each[place].order for each in orders), default=0))
        sliding: list[float] = []
        turning: list[float] = []
        for rows in orders:
            contribution = rows[place]
            f = complex(contribution.value) * radius / 2
            axis, lead = (2 * pi * float(x % 1) for x in (contribution.axis, contribution.lead))
            pair = (f * _turn(axis + lead), f.conjugate() * _turn(axis - lead))
            pin = radius * _turn(2 * pi * float(cylinder.throw.turns)) if contribution.order == 1 else 0j
            rotating = (pin, 0j)
            if pins:
                forward, backward = rotating_pair(cylinder, pins, contribution.order)
                rotating = radius * complex(forward), radius * complex(backward)
            sliding += _real(pair, float(contribution.arm), units.lever)
            turning += _real(rotating, float(contribution.arm), units.lever)
        vectors.append((tuple(sliding), tuple(turning)))
    return vectors


def as_built_vector(engine: Engine, orders: Sequence[int], units: Units) -> Vector | None:
    """Return what counterweights, shafts and rotating masses add, in the form of `generators`.

    None where the engine has no counterweights or shafts, and no masses on link pins.
    """
    by_order = as_built_parts(engine, max(orders))
    if not engine.balancers and not by_order:
        return None
    mass = engine.first.reciprocating_mass
    if not mass:
        rule = "are to be counted beside counterweights or shafts, which are in units of m r"
        remedy = "give reciprocating_mass, kg, in [crank_train]"
        raise SymbalanceError("whole masses", rule, remedy)
    scale = units.force * float(mass)
    vectors: list[float] = []
    for n in orders:
        by_quantity = by_order.get(n, NOTHING)
        for kind, over in (("force", 1.0), ("couple", units.lever)):
            pair = by_quantity[kind].forward * scale / over, by_quantity[kind].backward * scale / over
            vectors += [part for z in pair for part in (z.real, z.imag)]
    return tuple(vectors)


def _turn(angle: float) -> complex:
    return rect(1, angle)


def _real(pair: tuple[complex, complex], arm: float, lever: float) -> list[float]:
    forward, backward = pair
    force = [forward.real, forward.imag, backward.real, backward.imag]
    return force + [x * arm / lever for x in force]


def shaking_of(vector: Vector, orders: Sequence[int], units: Units) -> tuple[Shaking, ...]:
    """Return what a vector of `generators`' kind leaves, order by order."""
    vectors = []
    for i, n in enumerate(orders):
        part = vector[8 * i : 8 * i + 8]
        if not part:
            continue
        couple = units.lever * units.arm
        moduli = [sqrt(part[k] ** 2 + part[k + 1] ** 2) for k in (0, 2, 4, 6)]
        means = [sqrt(moduli[k] ** 2 + moduli[k + 1] ** 2) for k in (0, 2)]
        vectors.append(
            Shaking(
                n, moduli[0] + moduli[1], (moduli[2] + moduli[3]) * couple, means[0], means[1] * couple
            )
        )
    return tuple(vectors)
