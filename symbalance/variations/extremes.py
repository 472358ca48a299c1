r"""How badly an engine within its tolerances can shake: for each order, the worst that errors can add up to.

Cylinder j pushes along its axis with weight w_j: seen in the direction u, order n is

    sum of w_j cos(u - bank_j - k_j) cos(n theta + n (delay_j + t_j - k_j)),   w_j = m_j r_j f_n(j) [s_j],

t_j and k_j the errors of throw and bank. Mass, station, stroke, rod and offset enter w_j alone, each as a
factor that runs through an interval of its own (r A_n(r/l, e/l) grows with r and |e| and falls with l, for all
its terms have one sign), so w_j fills an interval exactly. Angles are bounded by taking the direction
cosine and the phase n (t_j - k_j) for independent. Then every cylinder is a `Sector`, and

- the amplitude of one component is `largest_sum` of them,
- the largest modulus of the planar vector over a turn is `farthest` over all directions u.

Both give a bound that is proved (but for the rounding of floats, for which it is raised by `ROUNDING`).
The attained value is that of an engine that exists: errors within their tolerances, improved in turns,
put into the formula above. For tolerances of mass, station, stroke and rod on centred cylinders the two
meet. Each order has its own worst engine, and so have force and couple.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from math import degrees, pi, remainder
from typing import NamedTuple

from symbalance.errors import SymbalanceError, shown
from symbalance.layout import Layout
from symbalance.phasor import ZERO
from symbalance.rational import listed
from symbalance.resultants import Balance, balance
from symbalance.slider_crank import acceleration_value
from symbalance.variations.boxes import Box, boxes
from symbalance.variations.derivatives import Sensitivity, evaluated_number, sensitivities
from symbalance.variations.sectors import TIED, Largest, farthest, largest_sum
from symbalance.variations.tolerances import Tolerances

MODES = ("largest", "vertical", "lateral", "forward", "backward")
QUANTITIES = ("force", "couple")
ROUNDING = 1e-9
IMPROVEMENTS = 6


@dataclass(frozen=True)
class WorstCase:
    """The worst of one order of the force or the couple, in m r omega^2 of cylinder 1 (times a).

    `of` is "largest" (the largest modulus over a turn) or a component, whose amplitude it then is.
    `nominal` is that of the engine without errors, `attained` that of an engine within the tolerances,
    `bound` what no such engine passes, `statistical` the root of the sum of squares of the first-order
    effects (three times their rms, if tolerances are three standard deviations of independent errors).
    `errors` are those of the engine that attains: by the cylinder's number, the factor by which its m r
    f_n is off, the error of its station in pitches, those of its throw and bank in degrees.
    """

    order: int
    quantity: str
    of: str
    nominal: float
    attained: float
    bound: float
    statistical: float
    errors: dict[int, tuple[float, float, float, float]]


def worst_cases(
    layout: Layout,
    tolerances: Tolerances,
    order: int = 4,
    *,
    of: object = ("largest",),
    reference: object = None,
) -> list[WorstCase]:
    """Return the worst that tolerances allow, for every order to `order` that they let exist.

    `of` lists some of "largest", "vertical", "lateral", "forward" and "backward".

    >>> from symbalance.builders import inline
    >>> found = worst_cases(inline("1-3-4-2", ratio=4), Tolerances(mass="1%"), 1)
    >>> [(w.quantity, w.nominal, round(w.attained, 9), round(w.bound, 6)) for w in found]
    [('force', 0.0, 0.04, 0.04), ('couple', 0.0, 0.04, 0.04)]
    """
    modes = tuple(listed(of, "of", '["largest"]'))
    unknown = [mode for mode in modes if mode not in MODES]
    if unknown:
        rule = "is not known"
        raise SymbalanceError(f"of = {shown(unknown[0])}", rule, f"choose from {', '.join(MODES)}")
    if not isinstance(tolerances, Tolerances):
        rule, remedy = "must be Tolerances", 'write Tolerances(mass="1%")'
        raise SymbalanceError(f"tolerances = {shown(tolerances)}", rule, remedy)
    own = tolerances.relative(layout)
    names = own.parameters
    errors = sensitivities(layout, order, parameters=names, reference=reference) if names else []
    ideal = balance(layout, order, reference=reference)
    found = []
    for n, rows in boxes(layout, own, order, reference).items():
        for quantity in QUANTITIES:
            pair = _ideal(ideal, n, quantity)
            for mode in modes:
                if not names:
                    found.append(_unchanged(n, quantity, mode, _seen(*pair, mode)))
                    continue
                single = _statistical([s for s in errors if s.order == n], own.steps, quantity, mode)
                found.append(_worst(n, quantity, mode, rows, _seen(*pair, mode), single))
    return found


def _ideal(ideal: Balance, n: int, quantity: str) -> tuple[complex, complex]:
    """Return c_n and c_-n of the engine without errors: what cancels there is exactly 0."""
    spectrum = ideal.force if quantity == "force" else ideal.couple
    factor = 1.0
    if ideal.is_uniform and n > 1:
        assert ideal.ratio is not None
        factor = float(acceleration_value(n, ideal.ratio))
    ahead, against = (spectrum.terms.get(signed, ZERO) for signed in (n, -n))
    return complex(evaluated_number(ahead)) * factor, complex(evaluated_number(against)) * factor


def _statistical(
    errors: Sequence[Sensitivity], steps: dict[str, float], quantity: str, mode: str
) -> float:
    squares = 0.0
    for one in errors:
        if one.parameter == "rotating":
            continue
        weight = one.weight(quantity) * steps[one.parameter]
        squares += (_seen(*one.values, mode) * weight) ** 2
    return squares**0.5


def _seen(ahead: complex, against: complex, mode: str) -> float:
    """Return what one looks at of c_n and c_-n: a component's amplitude, or the largest modulus."""
    match mode:
        case "vertical":
            return abs(ahead.conjugate() + against)
        case "lateral":
            return abs(ahead.conjugate() - against)
        case "forward":
            return abs(ahead)
        case "backward":
            return abs(against)
    return abs(ahead) + abs(against)


Aim = tuple[complex, complex]
"""What c_n and c_-n are multiplied by in the real number that is to be made large."""


def _aim(ahead: complex, against: complex, mode: str) -> Aim:
    """Return the aim that these numbers themselves reach best."""
    match mode:
        case "vertical" | "lateral":
            sign = 1 if mode == "vertical" else -1
            seen = _unit((ahead.conjugate() + sign * against).conjugate())
            return seen.conjugate(), sign * seen
        case "forward":
            return _unit(ahead.conjugate()), 0j
        case "backward":
            return 0j, _unit(against.conjugate())
    return _unit(ahead.conjugate()), _unit(against.conjugate())


def _unit(number: complex) -> complex:
    return number / abs(number) if number else 0j


class _Errors(NamedTuple):
    """One cylinder's errors: its weight without arm, its arm, its throw's and bank's errors in radians."""

    weight: complex
    arm: float
    turn: float
    tilt: float


def _unchanged(n: int, quantity: str, mode: str, nominal: float) -> WorstCase:
    """Return the worst of an engine without tolerances: itself."""
    return WorstCase(n, quantity, mode, nominal, nominal, nominal, 0.0, {})


def _worst(
    n: int, quantity: str, mode: str, rows: Sequence[Box], nominal: float, statistical: float
) -> WorstCase:
    bound, aim = _bounded(rows, quantity, mode)
    chosen = [_Errors(box.nominal, box.level, 0.0, 0.0) for box in rows]
    best = nominal
    least = TIED * sum(abs(box.nominal) * max(1.0, abs(box.level)) for box in rows)
    for _ in range(IMPROVEMENTS):
        tried = [_answer(box, quantity, aim) for box in rows]
        sums = _sums(rows, quantity, tried)
        value = _seen(*sums, mode)
        if value <= max(best, least):
            break
        best, chosen, aim = value, tried, _aim(*sums, mode)
    errors = {box.number: _told(box, one) for box, one in zip(rows, chosen, strict=True)}
    most = max(bound * (1 + ROUNDING), best)
    return WorstCase(n, quantity, mode, nominal, best, most, statistical, errors)


def _told(box: Box, one: _Errors) -> tuple[float, float, float, float]:
    return (
        abs(one.weight) / abs(box.nominal) if box.nominal else 0.0,
        one.arm - box.level,
        degrees(one.turn),
        degrees(one.tilt),
    )


def _sums(rows: Sequence[Box], quantity: str, chosen: Sequence[_Errors]) -> tuple[complex, complex]:
    pairs = [box.pair(quantity, *one) for box, one in zip(rows, chosen, strict=True)]
    return sum(a for a, _ in pairs), sum(b for _, b in pairs)


def _answer(box: Box, quantity: str, aim: Aim) -> _Errors:
    """Return the errors of one cylinder that serve an aim best, of those looked at."""
    arms = box.arm if quantity == "couple" else (box.level,)
    found = []
    for weight, arm, tilt in product(box.corners, arms, {0.0, box.bank, -box.bank}):
        for turn in _turns(box, quantity, weight, arm, tilt, aim):
            ahead, against = box.pair(quantity, weight, arm, turn, tilt)
            found.append(((aim[0] * ahead + aim[1] * against).real, _Errors(weight, arm, turn, tilt)))
    return max(found, key=lambda pair: pair[0])[1]


def _turns(box: Box, quantity: str, weight: complex, arm: float, tilt: float, aim: Aim) -> set[float]:
    """Return errors of the throw to look at: both ends, none, and where the phase is the best there is."""
    if not box.throw:
        return {0.0}
    ahead, against = box.pair(quantity, weight, arm, 0.0, tilt)
    reached = aim[0] * ahead + (aim[1] * against).conjugate()
    best = -cmath.phase(reached) / box.order if reached else 0.0
    return {0.0, box.throw, -box.throw, max(-box.throw, min(box.throw, best))}


def _bounded(rows: Sequence[Box], quantity: str, mode: str) -> tuple[float, Aim]:
    """Return the proved bound, and the aim to reach it with."""
    if mode in ("forward", "backward"):
        sign = 1 if mode == "forward" else -1
        value, angle = largest_sum([s for box in rows for s in box.turning(quantity, sign)])
        aim = cmath.rect(1, -angle)
        return value, ((aim, 0j) if sign > 0 else (0j, aim))

    def seen(direction: float) -> Largest:
        return largest_sum([s for box in rows for s in box.seen_from(quantity, direction)])

    direction, bound = {"vertical": 0.0, "lateral": pi / 2}.get(mode), None
    if direction is None:
        direction, bound = rows[0].axis, None
        if any(box.bank or abs(remainder(box.axis - direction, pi)) > 1e-12 for box in rows):
            found = farthest(lambda u: seen(u).value)
            direction, bound = found.angle, found.bound
    value, angle = seen(direction)
    aim = cmath.rect(1, -direction - angle), cmath.rect(1, angle - direction)
    return (value if bound is None else bound), aim
