"""Free force and couple of an engine as exact sums over its cylinders and rotating masses.

A mass that moves with a cylinder's mechanism pushes with h_n e^(inp) for every n of either sign
(`symbalance.kinematics.bodies`), p = theta + throw - bank, in the cylinder's frame.
In the engine's plane, vertical + i lateral, in units of m r omega^2 of cylinder 1, with s = m r of the
mass over that and w a weight (1 for the force, the lever arm for the couple),

    c_n = sum over groups of h_n sum over the group's cylinders of w s e^(i (bank + n (throw - bank))).

The inner sum is geometry, a number of a cyclotomic field: where it vanishes the order is gone, exactly.
Where there is one group of centred cylinders (or several that differ in m r alone, and an angle is a
letter), h_n = A_n/2 for both signs stands apart: components are the
geometry itself, whatever lambda is, and angles may hold symbols. Else c_n is a number of 40 digits.

A cylinder's force along its axis is half a vector that turns with the crank and half one that turns
against it; b is the bank angle and d the delay throw - bank:

Formulas:
    cos n (theta + d) e^(i b) = (1/2) (e^(i (b + n d)) e^(i n theta) + e^(i (b - n d)) e^(-i n theta))
    with n a whole number; b, d angles
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import lcm

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import SymbolPart
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.phasor import ZERO, Phasor, amplitude_sum
from symbalance.exact.spectrum import Spectrum
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.kinematics.bodies import RECIPROCATING, ROTATING, Body
from symbalance.kinematics.slider_crank import surviving
from symbalance.text.reals import Complex, Real, fsum

HALF = Fraction(1, 2)
MASSES = (RECIPROCATING, ROTATING)


@dataclass(frozen=True)
class MovingMass:
    """One body of each cylinder of a group, and its m r over the unit's by cylinder."""

    body: Body
    cylinders: tuple[Cylinder, ...]
    shares: tuple[Fraction, ...]


def moving_masses(engine: Engine, measures: Sequence[str] = MASSES) -> list[MovingMass]:
    """Return the bodies that push: pistons, then what sits on link pins.

    A mass on the crank pin turns steadily and is a rotating mass; one on a link pin is that and, here,
    what the link pin adds to the crank pin's circle.
    """
    _check_numbers(engine)
    places = {c.number: i for i, c in enumerate(engine.cylinders)}
    masses = []
    for measure in measures:
        if measure == ROTATING and not engine.has_link_pin_masses:
            continue  # what it counts in, a reciprocating mass, need not be given
        for group in engine.groups:
            for body in group.bodies:
                if body.measure == measure:
                    sizes = engine.sizes if measure == RECIPROCATING else engine.rotating_sizes
                    shares = tuple(sizes[places[c.number]] for c in group.cylinders)
                    masses += [MovingMass(body, group.cylinders, shares)] if any(shares) else []
    return masses


def _check_numbers(engine: Engine) -> None:
    if engine.has_symbols:
        rule = "has angles with letters, and cylinders whose rods or offsets differ"
        remedy = "give the angles in numbers, or take symbolic_order (formulas), an order at a time"
        raise SymbalanceError(f"engine {engine.name!r}", rule, remedy)


def planar_vectors(
    engine: Engine, order: int, reference: Fraction | None = None
) -> tuple[Spectrum, Spectrum]:
    """Return the free force, and the couple about a station (default: the mean), to an order.

    In units of each order's A_n m r omega^2 where the engine `counts_in_orders`, else of m r omega^2.
    """
    plane = engine.mean_station if reference is None else reference
    weights = _weights(engine, plane)
    if engine.counts_in_orders:
        orders = [n for n in range(1, order + 1) if surviving(n)]
        shares = engine.sizes  # all 1, but where an angle is a letter
        pushed = [
            geometry(engine, orders, [w * s for w, s in zip(of_each, shares, strict=True)])
            for of_each in weights
        ]
    else:
        pushed = _spectra_of(moving_masses(engine), engine, order, weights)
    return _with_rotating_masses(engine, order, plane, pushed)


def turning_vectors(
    engine: Engine, order: int, reference: Fraction | None = None
) -> tuple[Spectrum, Spectrum]:
    """Return what rotating masses and masses on link pins add to `planar_vectors`, in the same units."""
    plane = engine.mean_station if reference is None else reference
    # Where nothing is on a link pin angles may hold symbols, which moving masses may not.
    masses = moving_masses(engine, [ROTATING]) if engine.has_link_pin_masses else []
    pushed = _spectra_of(masses, engine, order, _weights(engine, plane))
    return _with_rotating_masses(engine, order, plane, pushed)


def _weights(engine: Engine, plane: Fraction) -> tuple[list[Fraction], list[Fraction]]:
    """Return every cylinder's weight in the force, 1, and in the couple about `plane`, its lever arm."""
    return [Fraction(1)] * len(engine.cylinders), engine.lever_arms(plane)


def _with_rotating_masses(
    engine: Engine, order: int, plane: Fraction, pushed: Sequence[Spectrum]
) -> tuple[Spectrum, Spectrum]:
    """Return a force, and a couple about `plane`, with what rotating masses add to them."""
    force, couple = pushed
    return rotor_spectrum(engine, order, None) + force, rotor_spectrum(engine, order, plane) + couple


def rotor_spectrum(engine: Engine, highest: int, plane: Fraction | None) -> Spectrum:
    """Return what turns adds to the force, or to the couple about `plane`, up to an order.

    >>> from symbalance.engine.balance_masses import Counterweight
    >>> from symbalance.engine.builders import inline
    >>> single = inline("1").balanced_by(Counterweight(throw=1, overbalance="1/2"))
    >>> rotor_spectrum(single, 12, None).component(1, "vertical").cos
    -1/2
    """
    parts: dict[int, list[Amplitude]] = {}
    for rotor in engine.rotating_masses:
        if abs(rotor.speed) <= highest:
            arm = Fraction(1) if plane is None else rotor.station - plane
            part = rotor.vector.scaled(arm)
            if not engine.counts_in_orders:  # weights that a file gives in 30 digits may cancel so far
                part = DecimalPhasor.holding(part)
            parts.setdefault(rotor.speed, []).append(part)
    return Spectrum.of({speed: amplitude_sum(of_speed) for speed, of_speed in parts.items()})


def _spectra_of(
    masses: Iterable[MovingMass], engine: Engine, order: int, weights: Sequence[Sequence[Fraction]]
) -> list[Spectrum]:
    """Return, for each list of the cylinders' weights, the sum of weight times every mass's force."""
    by_number = [
        {c.number: w for c, w in zip(engine.cylinders, of_each, strict=True)} for of_each in weights
    ]
    totals: list[dict[int, DecimalPhasor]] = [{} for _ in weights]
    for mass in masses:
        forces = mass.body.force(order)
        waves: dict[tuple[Fraction, ...], dict[int, Complex]] = {}  # of weights in the same proportion
        for total, weight in zip(totals, by_number, strict=True):
            factors = [weight[c.number] * s for c, s in zip(mass.cylinders, mass.shares, strict=True)]
            scale = next((factor for factor in factors if factor), None)
            if scale is None:
                continue
            proportion = tuple(factor / scale for factor in factors)
            if proportion not in waves:
                sums = _exact_sums(mass.cylinders, engine.modulus, range(1, order + 1), proportion)
                waves[proportion] = {
                    n: phasor.evaluated() * forces[n] for n, phasor in sums.items() if n in forces
                }
            for n, wave in waves[proportion].items():
                part = DecimalPhasor(wave * scale)
                total[n] = total[n] + part if n in total else part
    return [Spectrum.of({n: total[n] for n in sorted(total)}) for total in totals]


def left_out_above(engine: Engine, order: int, weights: Sequence[Real]) -> Real:
    """Return a proved bound on the sum of |weight| times every cylinder's harmonics above `order`.

    In units of m r omega^2 of cylinder 1: the sum of |w_j| s_j times each moving mass's tail.
    """
    weight = {c.number: abs(w) for c, w in zip(engine.cylinders, weights, strict=True)}
    total = Real(0)
    for mass in moving_masses(engine):
        reach = fsum(weight[c.number] * s for c, s in zip(mass.cylinders, mass.shares, strict=True))
        total += mass.body.tail(order) * reach
    return total


def geometry(engine: Engine, orders: Sequence[int], weights: Sequence[Fraction]) -> Spectrum:
    """Return the sum over cylinders of weight times cos n p of each, for each of `orders`.

    Half of it turns with the crank and half against it: c_n and c_-n hold half of every weight.

    >>> from symbalance.engine.builders import inline
    >>> geometry(inline("1-2-3-4-5-6-7"), range(1, 15), [Fraction(1)] * 7).orders()
    [7, 14]
    """
    modulus = engine.modulus  # refuses angles too fine together, beside symbols too
    halves = [weight * HALF for weight in weights]
    if not engine.has_symbols:
        return Spectrum(_exact_sums(engine.cylinders, modulus, orders, halves))
    return _with_symbols(engine.cylinders, orders, halves)


def _exact_sums(
    cylinders: Sequence[Cylinder], modulus: int, orders: Iterable[int], weights: Sequence[Fraction]
) -> dict[int, Phasor]:
    """Return the sums of w e^(i (bank + n (throw - bank))) that do not vanish, for n of both signs."""
    denominator = lcm(*(w.denominator for w in weights))
    rows = [
        (_units(c.bank.turns, modulus), _units(c.delay.turns, modulus), int(w * denominator))
        for c, w in zip(cylinders, weights, strict=True)
        if w
    ]
    by_residue: dict[int, Phasor] = {}  # a sum depends on its order modulo m only
    terms: dict[int, Phasor] = {}
    for n in orders:
        for signed in (n, -n):
            residue = signed % modulus
            if residue not in by_residue:
                total = Phasor.of(modulus, _exponent_sums(rows, residue, modulus))
                by_residue[residue] = ZERO if total.is_zero() else total.scaled(Fraction(1, denominator))
            if by_residue[residue] is not ZERO:
                terms[signed] = by_residue[residue]
    return terms


def _units(turns: Fraction, modulus: int) -> int:
    return turns.numerator * (modulus // turns.denominator)


def _exponent_sums(rows: Iterable[tuple[int, int, int]], n: int, modulus: int) -> dict[int, int]:
    total: dict[int, int] = {}
    for bank, delay, weight in rows:
        exponent = (bank + n * delay) % modulus
        total[exponent] = total.get(exponent, 0) + weight
    return total


def _with_symbols(
    cylinders: Sequence[Cylinder], orders: Sequence[int], weights: Sequence[Fraction]
) -> Spectrum:
    terms: dict[int, Amplitude] = {}
    for n in orders:
        for signed in (n, -n):
            total = SymbolicPhasor({})
            for cylinder, weight in zip(cylinders, weights, strict=True):
                rotated = cylinder.bank + cylinder.delay.scaled(signed)
                part: SymbolPart = rotated.symbols
                phasor = Phasor.root(rotated.turns).scaled(weight)
                total = total + SymbolicPhasor.of({part: phasor})
            terms[signed] = total
    return Spectrum.of(terms)
