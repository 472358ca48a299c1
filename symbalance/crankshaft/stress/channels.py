"""Named stresses and twists of a crank, each linear in the rotor's displacements.

    pin k bending           axial stress at pin k's middle, at its line nearest the crank's axis
    pin k sideways          the same at the line that leads, a quarter turn on
    pin k torsion           shear stress at its surface there
    web k pin fillet bending, torsion           peak stresses of the fillet between web k and its pin
    web k journal fillet bending, torsion       of the fillet between web k and its journal
    twist k                 the turn of bearing k + 1 beyond bearing k's, degrees; the last: the
                            flywheel's beyond the last bearing's

Stresses in Pa. Bending is + where it opens the throw (a load on the pin towards the crank's axis):
tension at the pin's inner line and in the pin's fillet; torsion + where the front drives the rear.
The nominal stresses are those of M53 (see `concentration`): M6/(B W^2) and Q/(B W) at the web's middle,
torsion of the pin and of the journal beside the web.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.crank import Crank, Journal, Part, Pin, Web
from symbalance.crankshaft.rotor.matrices import Member, Rotor
from symbalance.crankshaft.stress.concentration import fillet_factors, round_modulus

DEGREE = np.pi / 180


@dataclass(frozen=True)
class Channel:
    """A quantity of a crank: `name`, `unit` (Pa or degrees), `row` (n,) over the displacements.

    `outside` says what lies outside the range of the formulas it rests on; `factor` is what the nominal
    stress was multiplied by.
    """

    name: str
    unit: str
    row: Array
    factor: float = 1.0
    outside: tuple[str, ...] = ()


def stress_matrix(rows: Sequence[Channel]) -> Array:
    """Return Psi: the channels' rows, (c, n); Psi Phi are the stress modes of the modes Phi."""
    return np.array([channel.row for channel in rows])


def channels(crank: Crank, rotor: Rotor) -> list[Channel]:
    """Return the channels of a crank that became a rotor with `members`."""
    rows: list[Channel] = []
    for number, place in enumerate(_places(crank, Pin), 1):
        rows += _pin_channels(crank, rotor, number, place)
    for number, place in enumerate(_places(crank, Web), 1):
        rows += _web_channels(crank, rotor, number, place)
    return [*rows, *_twists(rotor)]


def _places(crank: Crank, kind: type) -> list[int]:
    return [i for i, part in enumerate(crank.parts) if isinstance(part, kind)]


def _axis(part: Part) -> tuple[Array, float, float]:
    """Return a round part's axis as its unit direction (3,), radius and half diameter."""
    angle = part.angle if isinstance(part, Pin) else 0.0
    radius = part.radius if isinstance(part, Pin) else 0.0
    half = part.diameter / 2 if isinstance(part, Pin | Journal) else 0.0
    return np.array([np.cos(angle), np.sin(angle), 0.0]), radius, half


def _section(rotor: Rotor, part: Part, place: int, front: bool | None) -> Array:
    """Return the loads (6, n) about a round part's axis, at its middle or its front or rear end."""
    out, radius, _ = _axis(part)
    members = members_of(rotor, place)
    if front is None:
        member = members[(len(members) - 1) // 2]
        height = rotor.points[member.rear if len(members) > 1 else member.front][2]
    else:
        member = members[0 if front else -1]
        height = rotor.points[member.front if front else member.rear][2]
    return section_loads(rotor, member, radius * out + np.array([0.0, 0.0, height]))


def _pin_channels(crank: Crank, rotor: Rotor, number: int, place: int) -> Iterator[Channel]:
    pin = crank.parts[place]
    assert isinstance(pin, Pin)
    loads = _section(rotor, pin, place, None)
    out, _, _ = _axis(pin)
    modulus = round_modulus(pin.diameter, pin.bore)
    area = np.pi / 4 * (pin.diameter**2 - pin.bore**2)
    # Axial stress at rho from the axis: (M_v rho_u - M_u rho_v)/I + N/A, M and N = -F_w as transmitted.
    across = np.array([-out[1], out[0], 0.0])
    tension = -loads[2] / area
    inner = -(across @ loads[3:]) / modulus
    leading = -(out @ loads[3:]) / modulus
    yield Channel(f"pin {number} bending", "Pa", inner + tension)
    yield Channel(f"pin {number} sideways", "Pa", leading + tension)
    yield Channel(f"pin {number} torsion", "Pa", loads[5] / (2 * modulus))


def _web_channels(crank: Crank, rotor: Rotor, number: int, place: int) -> Iterator[Channel]:
    """Yield a web's fillets; a flying web between two pins has no published factors and yields none."""
    web, before, after = crank.parts[place], crank.parts[place - 1], crank.parts[place + 1]
    assert isinstance(web, Web)
    if isinstance(before, Pin) == isinstance(after, Pin):
        return
    pin_behind = isinstance(after, Pin)
    pin, journal = (after, before) if pin_behind else (before, after)
    pin_place, journal_place = (place + 1, place - 1) if pin_behind else (place - 1, place + 1)
    assert isinstance(pin, Pin)
    assert isinstance(journal, Journal)
    factors, out = fillet_factors(journal, web, pin), _axis(pin)[0]
    opening, pressing = _web_nominal(rotor, web, pin, place, out, pin_behind)
    rear = not pin_behind
    pin_twist = _section(rotor, pin, pin_place, not rear)[5] / (2 * round_modulus(pin.diameter, pin.bore))
    journal_twist = _section(rotor, journal, journal_place, rear)[5]
    journal_twist = journal_twist / (2 * round_modulus(journal.diameter, journal.bore))
    rows = (
        ("pin fillet bending", opening * factors.pin_bending, factors.pin_bending),
        ("pin fillet torsion", pin_twist * factors.pin_torsion, factors.pin_torsion),
        (
            "journal fillet bending",
            pressing * factors.journal_pressure - opening * factors.journal_bending,
            factors.journal_bending,
        ),
        ("journal fillet torsion", journal_twist * factors.journal_torsion, factors.journal_torsion),
    )
    for name, row, factor in rows:
        yield Channel(f"web {number} {name}", "Pa", row, factor, factors.outside)


def _web_nominal(
    rotor: Rotor, web: Web, pin: Pin, place: int, out: Array, pin_behind: bool
) -> tuple[Array, Array]:
    """Return the nominal stresses at a web's middle: of bending that opens the throw, of radial tension.

    The section transmits F to what lies behind: with the pin behind, an outward F there pulls the web.
    """
    members = members_of(rotor, place)
    ends = rotor.points[members[0].front], rotor.points[members[-1].rear]
    middle = out * pin.radius / 2 + np.array([0.0, 0.0, (ends[0][2] + ends[1][2]) / 2])
    loads = section_loads(rotor, members[len(members) // 2], middle)
    across = np.array([-out[1], out[0], 0.0])
    opening = -(across @ loads[3:]) * 6 / (web.width * web.thickness**2)
    sign = -1.0 if pin_behind else 1.0
    return opening, sign * (out @ loads[:3]) / (web.width * web.thickness)


def _twists(rotor: Rotor) -> Iterator[Channel]:
    """Yield the twist from each bearing to the next, and from the last to the flywheel."""
    nodes = [*rotor.journals, *([] if rotor.flywheel is None else [rotor.flywheel])]
    for number, (front, rear) in enumerate(pairwise(nodes), 1):
        row = np.zeros(rotor.size)
        row[DOF * rear + 5], row[DOF * front + 5] = 1 / DEGREE, -1 / DEGREE
        yield Channel(f"twist {number}", "degrees", row)


def section_loads(rotor: Rotor, member: Member, point: Array) -> Array:
    """Return (6, n): the load of the part in front of a section on the part behind it, per displacement.

    Forces F and moments M about `point` (3,), all in U, V, W: the loads at the member's front end,
    stiffness times displacements, carried to the point, M = M_front + (front - point) x F. The member's
    own inertia between is left out; a body attached to a web counts with the end that carries it.

    A member stretched along W transmits F_w = -N: the part in front pulls forward.
    """
    loads = rotor.passing(member)
    arm = rotor.points[member.front] - np.asarray(point, dtype=float)
    loads[3:] += np.cross(arm, loads[:3], axisb=0, axisc=0)
    return loads


def members_of(rotor: Rotor, index: int) -> list[Member]:
    """Return the members of a part of the crank's chain, front to rear."""
    own = [m for m in rotor.members if m.index == index]
    return sorted(own, key=lambda m: rotor.points[m.front][2] + rotor.points[m.rear][2])
