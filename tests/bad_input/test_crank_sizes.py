"""The sizes of a crank at their ends: the last that is drawn, and the first that is refused."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import pytest

import symbalance as sb
from symbalance.crankshaft.crank import Crank, Disc, Journal, Pin, Web, WebCounterweight
from symbalance.crankshaft.geometry_checks import check_geometry

LITTLE = 1e-5
JOURNAL, PIN = Journal(0.06, 0.03, fillet=0.004), Pin(0.05, 0.032, 0.035, 0.4, (1,), fillet=0.003)
WEB = Web(0.02, 0.09, 0.04, 0.045)


def throw(journal: Journal = JOURNAL, web: Web = WEB, pin: Pin = PIN, **ends: Disc) -> Crank:
    return Crank((journal, web, pin, web, journal), **ends)


def held(**sizes: float) -> Crank:
    weight = WebCounterweight(1.0, 0.05, 0.4 + pi)
    return throw(web=replace(WEB, counterweight=replace(weight, **sizes)))


ENDS: dict[str, tuple[Callable[[float], Crank], float, int]] = {
    # what is refused: the crank of a size, its last good value, and whether more or less is too much
    "bore = 50": (lambda x: throw(pin=replace(PIN, bore=x)), 0.05 - LITTLE / 2, 1),
    "fillet": (lambda x: throw(pin=replace(PIN, fillet=x, length=0.01)), 0.005 - LITTLE / 2, 1),
    "width": (lambda x: throw(web=replace(WEB, width=x)), 2 * (0.03 + 0.004), -1),
    "heel": (lambda x: throw(web=replace(WEB, heel=x)), 0.03 + 0.004, -1),
    "tip": (lambda x: throw(web=replace(WEB, tip=x)), 0.025 + 0.003, -1),
    "must cover the pin": (
        lambda x: throw(
            replace(JOURNAL, diameter=0.02), replace(WEB, heel=x, width=0.2, tip=0.1),
            replace(PIN, diameter=0.12),
        ),
        0.06 + 0.003 - 0.035, -1,
    ),
    "must cover the journal": (
        lambda x: throw(replace(JOURNAL, diameter=0.13), replace(WEB, tip=x, width=0.2, heel=0.1)),
        0.065 + 0.004 - 0.035, -1,
    ),
    "thickness": (lambda x: throw(web=replace(WEB, thickness=x)), 0.004 + LITTLE / 2, -1),
    "half_angle": (lambda x: held(outer=0.09, half_angle=x), pi, 1),
    "counterweight radius": (lambda x: held(outer=0.09, half_angle=1.0, radius=x), 0.09, 1),
    "polar": (lambda x: throw(flywheel=Disc(10.0, x, 0.2)), 0.4, 1),
}  # fmt: skip


@pytest.mark.parametrize("name", ENDS)
def test_the_last_size_that_can_be_and_the_first_that_cannot(name):
    crank_of, last, sign = ENDS[name]
    check_geometry(crank_of(last))
    check_geometry(crank_of(last - sign * 10 * LITTLE))
    with pytest.raises(sb.SymbalanceError, match=name.split(" = ")[0]):
        check_geometry(crank_of(last + sign * LITTLE))


@pytest.mark.parametrize("field", ["mass", "polar", "diametral"])
@pytest.mark.parametrize("end", ["pulley", "flywheel"])
def test_a_disc_without_mass_or_inertia_is_refused(field, end):
    disc = replace(Disc(10.0, 0.2, 0.2), **{field: 0.0})
    with pytest.raises(sb.SymbalanceError, match=f"^{end}: {field} = 0"):
        check_geometry(throw(**{end: disc}))


def test_pins_side_by_side_must_meet():
    first, second = replace(PIN, radius=0.04), replace(PIN, radius=0.04, cylinders=(2,))

    def pair(angle: float) -> Crank:
        return Crank((JOURNAL, WEB, first, replace(second, angle=0.4 + angle), WEB, JOURNAL))

    # apart by 2 r sin(half the angle), and less than the diameter of 50 mm: 77.4 degrees
    check_geometry(pair(77.3 * pi / 180))
    with pytest.raises(sb.SymbalanceError, match="distance between their axes = 50"):
        check_geometry(pair(77.4 * pi / 180))


def test_a_refusal_names_the_part_by_its_place():
    crank = Crank((JOURNAL, WEB, replace(PIN, bore=0.06), WEB, JOURNAL))
    with pytest.raises(sb.SymbalanceError, match=r"^part 3, pin: bore = 60 mm"):
        check_geometry(crank)
    crank = Crank((JOURNAL, WEB, PIN, replace(WEB, heel=0.01), JOURNAL))
    with pytest.raises(
        sb.SymbalanceError, match=r"^part 4, web: heel = 10 mm: must cover the journal.*34 mm"
    ):
        check_geometry(crank)
