r"""Sensitivities of master and link rods: how their forces change with angles and lengths of either.

With the pin r e^(i (theta + throw)), each cylinder's own w as in `symbalance.kinematics.mechanisms` and
s = sin phi,

    y = Re w + sqrt(l^2 - (Im w - e)^2),    dy = Re dw - tan phi (Im dw - de) + dl/cos phi,
    dphi = (Im dw - de - s dl)/(l cos phi).

A turn of the pin (throw) has dw = i w, one of the own axis dw = -i w, a longer radius dw = w/r. A link
pin is moved by its master, W = pin + L e^(i (bank + psi - phi)) with dW = dpin + i (W - pin)(dbank
- dphi), of bank, phi and dphi of the master. Then c_n changes by n^2 times the Fourier coefficient of dy,
times m and e^(i bank), and by i c_n where the axis itself turns. All of that is summed over the cylinders
that a size moves: of a master's, its own and those attached to it. The pin is the master's, and so is
its throw.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import ceil, cosh, log, sqrt

from symbalance.design.variations.contributions import Contribution
from symbalance.design.variations.sensitivity import Sensitivity
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.exact.decimal_phasor import LEAST, DecimalPhasor
from symbalance.kinematics.mechanisms import LinkRod, Mechanism
from symbalance.kinematics.mechanisms.fourier import MOST_POINTS, means
from symbalance.text.reals import DIGITS, Complex, Real, digits_of, exp, expjpi, fixed
from symbalance.text.reals import sqrt as root

MOVING = ("throw", "bank", "stroke", "rod", "offset")
"""Sizes that may move other cylinders than their own."""
GUARD = 12
"""Digits computed beyond those promised."""
Pair = tuple[Complex, Complex]


def attached_cylinders(engine: Engine) -> dict[int, list[Cylinder]]:
    """Return the cylinders attached to each master, by its number."""
    coefficients: dict[int, list[Cylinder]] = {}
    for cylinder in engine.cylinders:
        if cylinder.link:
            coefficients.setdefault(cylinder.link.master, []).append(cylinder)
    return coefficients


@dataclass(frozen=True)
class _Rod:
    """One rod at one crank angle, lengths over its crank radius: w, tan phi, sin phi, 1/cos phi, l."""

    place: Complex
    tangent: Real
    sine: Real
    secant: Real
    length: Fraction

    def height(self, cylinders: Complex, length: int, aside: int) -> Real:
        """Return dy for dw, dl and de."""
        return cylinders.real - self.tangent * (cylinders.imag - aside) + length * self.secant

    def turn(self, cylinders: Complex, length: int, aside: int) -> Real:
        """Return dphi for dw, dl and de."""
        return (cylinders.imag - aside - self.sine * length) * self.secant / self.length


def _rod(place: Complex, mechanism: Mechanism) -> _Rod:
    sine = (place.imag - mechanism.offset) / mechanism.length
    secant = 1 / root((1 - sine) * (1 + sine))
    return _Rod(place, sine * secant, sine, secant, mechanism.length)


def _change(name: str, rod: _Rod, pin: Complex) -> tuple[Complex, int, int]:
    """Return dw, dl and de of a rod whose own size grows by one; `pin` is the crank's part of w."""
    cylinders = {"throw": 1j * pin, "bank": -1j * rod.place, "stroke": pin}.get(name, Complex(0))
    return cylinders, int(name == "rod"), int(name == "offset")


def _link_pin_change(name: str, link: LinkRod, pin: Complex, of_master: Complex) -> Complex:
    """Return dw of a link pin where a size of its master grows by one."""
    axis = expjpi(2 * link.bank_difference, pin.digits)
    master = _rod(pin * axis, link.master)
    turn = master.turn(*_change(name, master, pin * axis))
    cylinders = {"throw": 1j * pin, "stroke": pin}.get(name, Complex(0))
    return cylinders + 1j * of_master * ((name == "bank") - turn)


@lru_cache(maxsize=4)
def _positions(mechanism: Mechanism, points: int, digits: int) -> list[tuple[Complex, Complex, _Rod]]:
    """Return pin, link pin's arm and rod at evenly spread angles: derivatives by all sizes share them."""
    positions = []
    for i in range(points):
        pin = expjpi(Fraction(2 * i, points), digits)
        arm = Complex(0)
        if isinstance(mechanism, LinkRod):
            axis = expjpi(2 * mechanism.bank_difference, digits)
            sine = _rod(pin * axis, mechanism.master).sine
            cosine = root((1 - sine) * (1 + sine))
            swing = expjpi(2 * mechanism.pin_direction, digits) * Complex(cosine, -sine)
            arm = mechanism.link_radius * swing
        positions.append((pin, arm, _rod(pin + arm, mechanism)))
    return positions


def _samples(mechanism: Mechanism, name: str, own: bool, points: int, digits: int) -> Iterator[Real]:
    """Yield dy over the radius at evenly spread angles, for a size of its own or of its master's."""
    for pin, arm, rod in _positions(mechanism, points, digits):
        if own:
            yield rod.height(*_change(name, rod, pin))
        else:
            assert isinstance(mechanism, LinkRod)
            yield rod.height(_link_pin_change(name, mechanism, pin, arm), 0, 0)


def _grid(mechanism: Mechanism, order: int) -> tuple[int, int]:
    """Return how many points, a power of 2, and how many bits give `order` to `DIGITS` of its own.

    The bounds of `linkages` grow at least by (C' - C)/l as C = cosh a does: in half the strip |sin phi|
    of both rods stays by that below 1, tan and sec below M, and dy below (3 + 2 L)(1 + M)^3 e^a.
    """
    half, arm, length = mechanism.strip / 2, 0.0, float(mechanism.length)
    if isinstance(mechanism, LinkRod):
        arm, length = float(mechanism.link_radius), max(length, float(mechanism.master.length))
    below = max((cosh(2 * half) - cosh(half)) / length, 1e-12)
    bound = log((3 + 2 * arm) * (1 + 1 / sqrt(below)) ** 3) + half
    nepers = (DIGITS + GUARD) * log(10) + mechanism.strip * order + bound
    needed = order + nepers / half if half else float("inf")
    if needed > MOST_POINTS:
        what = f"length = {float(mechanism.length):.12g}"
        rule = "lets the rod lie across so nearly that its derivatives are not computed"
        raise SymbalanceError(what, rule, "lengthen the rod, or ask for fewer orders")
    return 1 << ceil(needed).bit_length(), ceil(nepers / log(2)) + 48


@lru_cache(maxsize=4096)
def _coefficients(mechanism: Mechanism, name: str, own: bool, order: int) -> tuple[Complex, ...]:
    """Return the Fourier coefficients of dy, n = 0..order; cylinders that are alike share them."""
    points, bits = _grid(mechanism, order)
    samples = _samples(mechanism, name, own, points, digits_of(bits))
    coefficients = means([fixed(x, bits) for x in samples], bits)[: order + 1]
    # `_grid` keeps errors below 10^-(DIGITS + GUARD) e^(-strip order): what is no more is rounding.
    least = exp(-mechanism.strip * order) / 10 ** (DIGITS + GUARD // 2)
    return tuple(x if abs(x) > least else Complex(0) for x in coefficients)


def articulated_sensitivities(
    engine: Engine, own: dict[int, list[Contribution]], order: int, names: Sequence[str]
) -> Iterator[Sensitivity]:
    """Yield the derivatives of masters and link rods by the sizes of `MOVING` among `names`.

    `own` holds every cylinder's contributions, order by order. A link rod has no throw and no stroke of
    its own.
    """
    attached = attached_cylinders(engine)
    places = {cylinder.number: place for place, cylinder in enumerate(engine.cylinders)}
    for cylinder in engine.cylinders:
        if cylinder.link is None and cylinder.number not in attached:
            continue
        moved = [(places[c.number], c) for c in (cylinder, *attached.get(cylinder.number, []))]
        for name in names:
            if name in MOVING and not (cylinder.link and name in ("throw", "stroke")):
                yield from _of_size(engine, own, order, name, moved)


def _of_size(
    engine: Engine,
    own: dict[int, list[Contribution]],
    order: int,
    name: str,
    moved: Sequence[tuple[int, Cylinder]],
) -> Iterator[Sensitivity]:
    """Yield one derivative's orders: the sums over the cylinders that the first one's size moves.

    Each is given with its place in the engine.
    """
    places, cylinders = zip(*moved, strict=True)
    first, per = cylinders[0], [_lengths(engine, c, name) for c in cylinders]
    changes = [_coefficients(c.known_mechanism, name, c is first, order) for c in cylinders]
    for n in range(1, order + 1):
        total, arms, size = [Complex(0)] * 2, [Complex(0)] * 2, Real(0)
        for place, cylinder, lengths, coefficients in zip(places, cylinders, per, changes, strict=True):
            contribution = own[min(own)][place]
            pair = _pair(cylinder, contribution, n, coefficients[n] * lengths)
            if name == "bank" and cylinder is first:
                pair = _with_axis_turn(pair, own.get(n), place)
            total = [t + x for t, x in zip(total, pair, strict=True)]
            arms = [t + x * contribution.arm for t, x in zip(arms, pair, strict=True)]
            size += sum(map(abs, pair)) * (1 + abs(contribution.arm))
        force, couple = (_decimals(parts, size) for parts in (total, arms))
        if any(not x.is_zero() for x in (*force, *couple)):
            yield Sensitivity(name, first.number, n, force, Real(1), Fraction(0), couple)


def _lengths(engine: Engine, cylinder: Cylinder, name: str) -> Fraction:
    """Return what turns dy over its own radius into its share's unit, for one unit of the size."""
    own, radius = cylinder.radius, engine.first.radius
    if name in ("throw", "bank") or not own or not radius:
        return Fraction(1)
    return radius / own


def _pair(cylinder: Cylinder, contribution: Contribution, n: int, change: Complex) -> Pair:
    """Return c_n and c_-n of a height's coefficient: the share's size holds mass and radius."""
    axis, delay = (
        expjpi(2 * turns, DIGITS + GUARD) for turns in (cylinder.bank.turns, n * cylinder.delay.turns)
    )
    value = n * n * change * contribution.size * delay
    return value * axis, value.conjugate() * axis


def _with_axis_turn(pair: Pair, rows: Sequence[Contribution] | None, place: int) -> Pair:
    """Return a pair, with i c_n added: the force turns with its axis."""
    if rows is None:
        return pair
    contribution = rows[place]
    value = contribution.value * contribution.size / 2
    forward = value * expjpi(2 * (contribution.axis + contribution.lead), DIGITS + GUARD)
    backward = value.conjugate() * expjpi(2 * (contribution.axis - contribution.lead), DIGITS + GUARD)
    return pair[0] + 1j * forward, pair[1] + 1j * backward


def _decimals(parts: Sequence[Complex], size: Real) -> tuple[DecimalPhasor, DecimalPhasor]:
    """Return sums as numbers, 0 where they are nothing beside the sum of their parts' sizes."""
    forward, backward = (Complex(0) if abs(x) <= LEAST * size else x.rounded(DIGITS) for x in parts)
    return DecimalPhasor(forward), DecimalPhasor(backward)
