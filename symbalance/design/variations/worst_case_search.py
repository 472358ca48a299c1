r"""Worst cases of an engine within its tolerances: the largest force and couple by order, with bounds.

Cylinder j pushes along its axis with weight w_j: seen in the direction u, order n is

    sum of w_j cos(u - bank_j - k_j) cos(n theta + n (delay_j + t_j - k_j)),   w_j = m_j r_j f_n(j) [s_j],

t_j and k_j the errors of throw and bank. Mass, station, stroke, rod and offset enter w_j alone, each as
a factor that runs through an interval of its own (r A_n(r/l, e/l) grows with r and |e| and falls with l,
for all its terms have one sign), so w_j fills an interval exactly. Angles are bounded by taking the
direction cosine and the phase n (t_j - k_j) for independent. Every cylinder then is an `AnnularSector`:

- the amplitude of one component is `largest_sum` of them,
- the largest modulus of the planar vector over a turn is `farthest_point` over all directions u.

Counterweights, shafts and rotating masses add what they were made to
(`as_built`). Both give a bound that is proved (but for the rounding of floats,
for which it is raised by `ROUNDING`). The attained value is that of an engine that exists: errors
within their tolerances, improved in turns, put into the formula above. For tolerances of mass, station,
stroke and rod on centred cylinders the two meet. Each order has its own worst engine, and so have force
and couple.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import cos, hypot, pi, remainder
from typing import TYPE_CHECKING, Any, ClassVar, overload

from symbalance.design.variations.annular_sectors import (
    TIE,
    AnnularSector,
    Maximum,
    farthest_point,
    largest_sum,
)
from symbalance.design.variations.as_built import NOTHING, AsBuilt, as_built_parts
from symbalance.design.variations.contributions import checked_numeric_engine
from symbalance.design.variations.derivatives import sensitivities
from symbalance.design.variations.legend import as_decimal
from symbalance.design.variations.objectives import (
    MODES,
    Errors,
    Objective,
    best_response,
    component_amplitude,
    engine_sums,
    error_tuple,
    objective_of,
)
from symbalance.design.variations.sensitivity import Sensitivity
from symbalance.design.variations.speeds import Scale, speed_scale
from symbalance.design.variations.tolerance_intervals import ToleranceBox, tolerance_boxes
from symbalance.design.variations.tolerances import UNITS, RelativeTolerances, Tolerances
from symbalance.document.result import Result
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.phasor import ZERO
from symbalance.forces.free_forces import Balance, balance
from symbalance.forces.operating_point import checked_rpm
from symbalance.forces.rows import plane_key
from symbalance.kinematics.slider_crank import acceleration_value
from symbalance.text.numbers import as_list, exact

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

QUANTITIES = ("force", "couple")
ROUNDING = 1e-9
"""Part by which a bound is raised, for the rounding of the floats it was summed in."""
MOST_SEARCHED = 100
"""Cylinders up to which the largest modulus is searched for in all directions, whatever the orders."""
MOST_DIRECTED = 1500
"""Of more, cylinders times searches at most: each takes some 7 ms a cylinder."""
ONE_DIRECTION = ("vertical", "lateral", "forward", "backward")
"""What is looked at along one direction alone."""
IMPROVEMENTS = 6
"""Rounds of best responses at most; each ends where no cylinder's errors add anything."""


@dataclass(frozen=True)
class WorstCase:
    """The largest value of one order of the force or couple, in the units of its `WorstCases`.

    `quantity` is "force" or "couple", with "rotating" before it where the rotating masses' own errors
    alone are meant. `of` is "largest" (the largest modulus over a turn) or a component, whose amplitude
    it then is.
    `nominal` is that of the engine without errors, `attained` that of an engine within the tolerances,
    `bound` what no such engine passes, `statistical` the root of the sum of squares of the first-order
    effects (three times their rms, if tolerances are three standard deviations of independent errors).
    `errors` are those of the engine that attains it: by the cylinder's number, the factor by which its
    m r f_n is off, the error of its station in pitches, those of its throw and bank in degrees.
    """

    order: int
    quantity: str
    of: str
    nominal: float
    attained: float
    bound: float
    statistical: float
    errors: dict[int, tuple[float, float, float, float]]


@dataclass(frozen=True, repr=False)
class WorstCases(Result, Sequence[WorstCase]):
    """The largest force and couple within tolerances, of every order that can occur, to `order`.

    Forces are in m r omega^2 of cylinder 1 and couples in m r omega^2 a, or with `rpm` in N and N m (in
    N a, a the pitch, where the engine gives none). `reference` is the station couples are taken about,
    None for the mean of all stations.
    """

    engine: Engine
    tolerances: Tolerances
    order: int
    reference: Fraction | None
    rpm: Fraction | None
    cases: tuple[WorstCase, ...]

    kind: ClassVar[str] = "worst-cases"

    @overload
    def __getitem__(self, index: int) -> WorstCase: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[WorstCase, ...]: ...
    def __getitem__(self, index: int | slice) -> WorstCase | tuple[WorstCase, ...]:
        return self.cases[index]

    def __len__(self) -> int:
        return len(self.cases)

    def __iter__(self) -> Iterator[WorstCase]:
        return iter(self.cases)

    @property
    def scale(self) -> Scale:
        """What m r omega^2 and m r omega^2 a of cylinder 1 are in the units of the cases."""
        return speed_scale(self.engine, self.rpm)

    def unit(self, case: WorstCase) -> str:
        """Return the unit of one of the cases: that of a force or that of a couple."""
        return self.scale.units[case.quantity.endswith("couple")]

    def summary(self) -> str:
        """Return the largest force and couple that are proved, in one line."""
        worst = [
            max((w for w in self if w.quantity == quantity), key=lambda w: w.bound, default=None)
            for quantity in QUANTITIES
        ]
        listing = ", ".join(
            f"{w.quantity} ≤ {w.bound:.6g} {self.unit(w)} (order {w.order})" for w in worst if w
        )
        return f"Worst cases of {self.engine.name} to order {self.order}: {listing or 'none'}"

    def document(self) -> Document:
        """Return the worst of force and couple by order, then how it is meant."""
        from symbalance.design.variations.worst_cases_document import worst_cases_document

        return worst_cases_document(self)

    def data(self) -> dict[str, Any]:
        """Return the tolerances and every worst case, with the errors of the engine that reaches it."""
        tolerances = {name: getattr(self.tolerances, name) for name in UNITS}
        force, couple = self.scale.units
        return {
            "engine": self.engine.name,
            "ratio": None if self.engine.ratio is None else str(self.engine.ratio),
            "highest": str(self.order),
            "reference_plane": plane_key(self.reference),
            "tolerances": {name: str(value) for name, value in tolerances.items() if value},
            "tolerance_units": {name: UNITS[name] for name, value in tolerances.items() if value},
            "units": {"force": force, "couple": couple},
            "rpm": None if self.rpm is None else as_decimal(self.rpm),
            "worst_cases": [
                {
                    "order": str(worst.order),
                    **_numbers(worst),
                    "errors": {
                        str(number): {"weight": w, "station": s, "throw": t, "bank": b}
                        for number, (w, s, t, b) in worst.errors.items()
                    },
                }
                for worst in self
            ],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each worst case: what it is of, four floats, and their unit."""
        return [{"order": w.order, **_numbers(w), "unit": self.unit(w)} for w in self]


def _numbers(worst: WorstCase) -> dict[str, str | float]:
    names = ("quantity", "of", "nominal", "attained", "bound", "statistical")
    return {name: getattr(worst, name) for name in names}


def worst_cases(
    engine: Engine,
    tolerances: Tolerances,
    order: int = 4,
    *,
    of: object = ("largest",),
    reference: object = None,
    rpm: object = None,
) -> WorstCases:
    """Return the largest force and couple within tolerances, of every order that can occur, to `order`.

    Orders whose A_n is below what a double holds (some 10^-308) are left out.
    `of` lists some of "largest", "vertical", "lateral", "forward" and "backward"; `reference` is the
    station couples are taken about (default: the stations' mean). With `rpm`, the engine's stroke and
    reciprocating mass results are in N, and with its pitch in N m.

    >>> from symbalance.engine.builders import inline
    >>> cases = worst_cases(inline("1-3-4-2", ratio=4), Tolerances(mass="1%"), 1)
    >>> [(w.quantity, w.nominal, round(w.attained, 9), round(w.bound, 6)) for w in cases]
    [('force', 0.0, 0.04, 0.04), ('couple', 0.0, 0.04, 0.04)]
    >>> cases
    Worst cases of engine to order 1: force ≤ 0.04 m r ω² (order 1), couple ≤ 0.04 m r ω² a (order 1)
    """
    checked_numeric_engine(engine)
    modes = tuple(as_list(of, "of", '["largest"]'))
    unknown = [mode for mode in modes if mode not in MODES]
    if unknown:
        rule = "is not known"
        raise SymbalanceError(f"of = {brief(unknown[0])}", rule, f"choose from {', '.join(MODES)}")
    if not isinstance(tolerances, Tolerances):
        rule, remedy = "must be Tolerances", 'write Tolerances(mass="1%")'
        raise SymbalanceError(f"tolerances = {brief(tolerances)}", rule, remedy)
    plane = None if reference is None else exact(reference, "reference")
    speed = None if rpm is None else checked_rpm(rpm)
    scale = speed_scale(engine, speed)
    cases = _worst_cases(engine, tolerances.relative(engine), order, modes, plane)
    return WorstCases(
        engine, tolerances, order, plane, speed, tuple(_scaled(case, scale) for case in cases)
    )


def _scaled(case: WorstCase, scale: Scale) -> WorstCase:
    by = scale.couple if case.quantity.endswith("couple") else scale.force
    return replace(
        case,
        nominal=case.nominal * by,
        attained=case.attained * by,
        bound=case.bound * by,
        statistical=case.statistical * by,
    )


def _worst_cases(
    engine: Engine,
    relative: RelativeTolerances,
    order: int,
    modes: Sequence[str],
    reference: Fraction | None,
) -> list[WorstCase]:
    """Return worst cases in m r omega^2 of cylinder 1 (times a)."""
    names = relative.parameters
    errors = sensitivities(engine, order, parameters=names, reference=reference) if names else []
    ideal = balance(engine, order, reference=reference)
    cases, by_order = [], tolerance_boxes(engine, relative, order, reference)
    as_built = as_built_parts(engine, order, reference)
    _check_search(engine, by_order, as_built, modes if names else ())
    errors_of: dict[int, list[Sensitivity]] = {}
    for error in errors:
        errors_of.setdefault(error.order, []).append(error)
    for n in sorted({*by_order, *as_built}):
        rows = by_order.get(n, [])
        for quantity in QUANTITIES:
            pair, fixed = _ideal(ideal, n, quantity), as_built.get(n, NOTHING)[quantity]
            for mode in modes:
                if not names:
                    cases.append(_unchanged(n, quantity, mode, component_amplitude(*pair, mode)))
                    continue
                single = _statistical(errors_of.get(n, []), relative.steps, quantity, mode)
                cases.append(
                    _worst(n, quantity, mode, rows, fixed, component_amplitude(*pair, mode), single)
                )
    return cases + (_rotating_cases(engine, relative, order, reference) if relative.rotating else [])


def _check_search(
    engine: Engine,
    by_order: Mapping[int, Sequence[ToleranceBox]],
    as_built: Mapping[int, Mapping[str, AsBuilt]],
    modes: Sequence[str],
) -> None:
    """Refuse many cylinders whose largest modulus is to be searched for in all directions."""
    count = len(engine.cylinders)
    searched = [
        n
        for n in {*by_order, *as_built}
        for quantity in QUANTITIES
        for mode in modes
        if mode not in ONE_DIRECTION
        and _has_many_directions(by_order.get(n, []), as_built.get(n, NOTHING)[quantity])
    ]
    if count > MOST_SEARCHED and count * len(searched) > MOST_DIRECTED:
        what = f"{count} cylinders and {len(searched)} searches over all directions"
        rule = f"are {count * len(searched)} together, and must be at most {MOST_DIRECTED}"
        remedy = (
            "ask for --of vertical,lateral or forward,backward, which need no search, or lower orders"
        )
        raise SymbalanceError(what, rule, remedy)


def _has_many_directions(rows: Sequence[ToleranceBox], as_built: AsBuilt) -> bool:
    """Tell whether forces may point elsewhere than along the one axis of all cylinders."""
    axis = rows[0].axis if rows else 0.0
    return bool(as_built) or any(box.bank or abs(remainder(box.axis - axis, pi)) > 1e-12 for box in rows)


def _rotating_cases(
    engine: Engine, relative: RelativeTolerances, order: int, reference: object
) -> list[WorstCase]:
    """Return what the rotating masses' own errors add up to: those on crank pins in order 1, forward."""
    errors = sensitivities(engine, order, parameters=["rotating"], reference=reference)
    step, cases = float(relative.rotating), []
    for n in sorted({e.order for e in errors}):
        rows = [e for e in errors if e.order == n]
        for quantity in QUANTITIES:
            parts = [_Error(e.cylinder, *(step * z for z in e.pair(quantity))) for e in rows]
            cases.append(_worst_rotating(n, f"rotating {quantity}", parts, step))
    return cases


@dataclass(frozen=True)
class _Error:
    """What one rotating mass adds to c_n and c_-n where it is heavier by its tolerance."""

    number: int
    forward: complex
    backward: complex

    def across(self, direction: float) -> complex:
        """Return what it adds to the component in a direction, as C + iS would turn."""
        forward = self.forward * cmath.rect(1, -direction)
        return forward + self.backward.conjugate() * cmath.rect(1, direction)


def _worst_rotating(n: int, quantity: str, parts: Sequence[_Error], step: float) -> WorstCase:
    """Return the worst of masses that are each off by plus or minus its tolerance."""

    def across(direction: float) -> Maximum:
        numbers = [part.across(direction) for part in parts]
        return largest_sum([AnnularSector(-abs(z), abs(z), cmath.phase(z)) for z in numbers])

    turns = not any(part.backward for part in parts)  # in a circle: every direction is the same
    far = None if turns else farthest_point(lambda u: across(u).value)
    direction = far.angle if far else 0.0
    value, angle = across(direction)
    signs = {p.number: _sign(1.0, cmath.phase(p.across(direction)) - angle) for p in parts}
    forward = sum(signs[p.number] * p.forward for p in parts)
    backward = sum(signs[p.number] * p.backward for p in parts)
    attained = abs(forward) + abs(backward)
    most = max((far.bound if far else value) * (1 + ROUNDING), attained)
    single = hypot(*(abs(p.forward) + abs(p.backward) for p in parts))
    errors = {number: (1 + sign * step, 0.0, 0.0, 0.0) for number, sign in signs.items()}
    mode = "forward" if turns else "largest"
    return WorstCase(n, quantity, mode, 0.0, attained, most, single, errors)


def _sign(weight: float, away: float) -> int:
    return 1 if weight * cos(away) >= 0 else -1


def _ideal(ideal: Balance, n: int, quantity: str) -> tuple[complex, complex]:
    """Return c_n and c_-n of the engine without errors: what cancels there is exactly 0."""
    spectrum = ideal.force if quantity == "force" else ideal.couple
    factor = 1.0
    if ideal.kinematics and n > 1:
        assert ideal.ratio is not None
        factor = float(acceleration_value(n, ideal.ratio))
    forward, backward = (spectrum.terms.get(signed, ZERO) for signed in (n, -n))
    return complex(forward.evaluated()) * factor, complex(backward.evaluated()) * factor


def _statistical(
    errors: Sequence[Sensitivity], steps: dict[str, float], quantity: str, mode: str
) -> float:
    squares = 0.0
    for change in errors:
        if change.parameter == "rotating":
            continue
        effect = component_amplitude(*change.pair(quantity), mode) * steps[change.parameter]
        squares += effect**2
    return squares**0.5


def _unchanged(n: int, quantity: str, mode: str, nominal: float) -> WorstCase:
    """Return the worst of an engine without tolerances: itself."""
    return WorstCase(n, quantity, mode, nominal, nominal, nominal, 0.0, {})


def _worst(
    n: int,
    quantity: str,
    mode: str,
    rows: Sequence[ToleranceBox],
    as_built: AsBuilt,
    nominal: float,
    statistical: float,
) -> WorstCase:
    bound, objective = _bound(rows, as_built, quantity, mode)
    worst = [Errors(box.nominal, box.level, 0.0, 0.0) for box in rows]
    best = nominal
    least = TIE * sum(abs(box.nominal) * max(1.0, abs(box.level)) for box in rows)
    least += TIE * (abs(as_built.forward) + abs(as_built.backward))
    for _ in range(IMPROVEMENTS):
        responses = [best_response(box, quantity, objective) for box in rows]
        forward, backward = engine_sums(rows, quantity, responses)
        sums = forward + as_built.forward, backward + as_built.backward
        value = component_amplitude(*sums, mode)
        if value <= max(best, least):
            break
        best, worst, objective = value, responses, objective_of(*sums, mode)
    errors = {box.number: error_tuple(box, one) for box, one in zip(rows, worst, strict=True)}
    most = max(bound * (1 + ROUNDING), best)
    return WorstCase(n, quantity, mode, nominal, best, most, statistical, errors)


def _bound(
    rows: Sequence[ToleranceBox], as_built: AsBuilt, quantity: str, mode: str
) -> tuple[float, Objective]:
    """Return the proved bound, and the objective to reach it with."""

    def rotating(sign: int) -> Maximum:
        sectors = [s for box in rows for s in box.rotating_sectors(quantity, sign)]
        return largest_sum(sectors + as_built.rotating_sectors(sign))

    def across(direction: float) -> Maximum:
        sectors = [s for box in rows for s in box.component_sectors(quantity, direction)]
        return largest_sum(sectors + as_built.component_sectors(direction))

    if mode in ("forward", "backward"):
        value, angle = rotating(1 if mode == "forward" else -1)
        objective = cmath.rect(1, -angle)
        return value, ((objective, 0j) if mode == "forward" else (0j, objective))
    direction, bound = {"vertical": 0.0, "lateral": pi / 2}.get(mode), None
    if direction is None:
        direction = rows[0].axis if rows else 0.0
        if _has_many_directions(rows, as_built):
            far = farthest_point(lambda u: across(u).value)
            # A circle has no farthest direction to halve towards: there both turning parts bound it.
            direction = far.angle
            bound = min(far.bound, rotating(1).value + rotating(-1).value)
    value, angle = across(direction)
    objective = cmath.rect(1, -direction - angle), cmath.rect(1, angle - direction)
    return (value if bound is None else bound), objective
