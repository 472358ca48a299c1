"""Reading of [crankshaft] in an engine file: builds the crank from the cylinders' stations.

A bay is what lies between two journals. The cylinders of one station share a bay: one pin where they
share a throw, several pins with a flying web between where they do not (split pins). `web_only_after`
joins the bay of a pin to the next by a flying web, without a journal between.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import groupby, pairwise
from math import pi

from symbalance.crankshaft.crank import Crank, Journal, Part, Pin, Web, WebCounterweight
from symbalance.crankshaft.geometry_checks import check_geometry
from symbalance.crankshaft.rotor.parts import Disc, Material
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.text.sections import Section

MILLI = 1e-3
ROUND = ("diameter", "length", "bore", "fillet")
WEB = ("thickness", "width", "tip", "heel")
PITCH_TOLERANCE = 1e-3
"""How far the sum of a throw's lengths may differ from the pitch, of the pitch."""

PinCylinders = tuple[Cylinder, ...]


def read_crank(section: Section, engine: Engine) -> Crank:
    """Return the crank of [crankshaft] for an engine; lengths in mm, moduli in GPa, kg, kg mm^2."""
    bays = _join_bays(_bays(engine), section)
    pins = _read_pins(section, bays, engine)
    webs = _read_webs(section, bays, pins)
    journals = _read_journals(section, len(bays) + 1)
    crank = Crank(
        _chain(journals, webs, pins, bays),
        _material(section),
        _disc(section, "pulley"),
        _disc(section, "flywheel"),
    )
    section.guarded(lambda: check_geometry(crank))
    _check_pitch(section, crank, engine, [pin for bay in bays for pin in bay])
    return crank


def _bays(engine: Engine) -> list[list[PinCylinders]]:
    """Return the bays front to rear, each its pins, each the cylinders that share it."""
    if engine.has_symbols:
        raise SymbalanceError(engine.name, "has angles with symbols", "a crankshaft needs numbers")
    from_front = sorted(engine.cylinders, key=lambda c: -c.station)
    bays = []
    for _, here in groupby(from_front, lambda c: c.station):
        pins: dict[Fraction, list[Cylinder]] = {}
        for cylinder in here:
            pins.setdefault(cylinder.throw.turns % 1, []).append(cylinder)
        bays.append([tuple(pin) for pin in pins.values()])
    return _merge_vee_pins(bays)


def _merge_vee_pins(bays: list[list[PinCylinders]]) -> list[list[PinCylinders]]:
    """Return the bays with neighbouring pins of one throw and different banks, less than half a pitch
    apart, merged: the rods of a vee side by side.
    """
    merged_bays = bays[:1]
    for bay in bays[1:]:
        before, after = merged_bays[-1][-1], bay[0]
        near = before[-1].station - after[0].station < Fraction(1, 2)
        if near and len(bay) == len(merged_bays[-1]) == 1 and _one_pin(before, after):
            merged_bays[-1] = [before + after]
        elif near:
            merged_bays[-1] = merged_bays[-1] + bay
        else:
            merged_bays.append(bay)
    return merged_bays


def _one_pin(before: PinCylinders, after: PinCylinders) -> bool:
    alike = (before[0].throw.turns - after[0].throw.turns) % 1 == 0
    return alike and not {c.bank for c in before} & {c.bank for c in after}


def _join_bays(bays: list[list[PinCylinders]], section: Section) -> list[list[PinCylinders]]:
    """Return the bays with those that `web_only_after` names joined to the next."""
    count = sum(map(len, bays))
    webs_only = set(section.places("web_only_after", max(count - 1, 1)))
    bays_joined: list[list[PinCylinders]] = []
    place = 0
    for bay in bays:
        if bays_joined and place in webs_only:
            bays_joined[-1] = bays_joined[-1] + bay
        else:
            bays_joined.append(list(bay))
        place += len(bay)
    return bays_joined


def _read_pins(section: Section, bays: list[list[PinCylinders]], engine: Engine) -> list[Pin]:
    table = section.section("pin")
    groups = [pin for bay in bays for pin in bay]
    sizes = [table.numbers(key, len(groups)) for key in ROUND]
    pins = []
    for group, diameter, length, bore, fillet in zip(groups, *sizes, strict=True):
        radius = _crank_radius(section, group)
        angle = 2 * pi * float(group[0].throw.turns % 1)
        numbers = tuple(c.number for c in group)
        pins.append(Pin(diameter, length, radius, angle, numbers, bore, fillet))
    return pins


def _crank_radius(section: Section, group: PinCylinders) -> float:
    """Return the crank radius in m that a pin's cylinders agree on; a link rod's is its master's."""
    strokes = {c.stroke for c in group}
    stroke = strokes.pop()
    if stroke is None:
        what = f"cylinder {group[0].number}"
        raise SymbalanceError(
            what, "has no stroke", "give stroke in mm, in [crank_train]", section.place()
        )
    if strokes:
        numbers = ", ".join(str(c.number) for c in group)
        what = f"cylinders {numbers}"
        raise SymbalanceError(
            what, "share a pin and not a stroke", "give them one stroke", section.place()
        )
    return float(stroke) / 2 * MILLI


def _read_journals(section: Section, count: int) -> list[Journal]:
    table = section.section("journal")
    sizes = [table.numbers(key, count) for key in ROUND]
    bare = section.places("no_bearing", count)
    rows = enumerate(zip(*sizes, strict=True), 1)
    return [Journal(d, long, b, f, bearing=i not in bare) for i, (d, long, b, f) in rows]


def _read_webs(section: Section, bays: list[list[PinCylinders]], pins: list[Pin]) -> list[Web]:
    """Return the webs front to rear: each bay has one more than pins, its inner ones flying."""
    table = section.section("web")
    flying = [0 < i < len(bay) for bay in bays for i in range(len(bay) + 1)]
    sizes = [table.numbers(key, len(flying)) for key in WEB]
    if any(flying) and not isinstance(table.table["thickness"], list):
        if "flying_web" not in section:
            raise _missing_flying_web(section, bays)
        thin = section.number("flying_web")
        sizes[0] = [thin if f else t for f, t in zip(flying, sizes[0], strict=True)]
    weights = _read_counterweights(section, bays, pins, len(flying))
    rows = zip(*sizes, strict=True)
    return [Web(*row[:4], counterweight=weights.get(i)) for i, row in enumerate(rows, 1)]


def _missing_flying_web(section: Section, bays: Sequence[Sequence[PinCylinders]]) -> SymbalanceError:
    """Return the refusal that says which pins need a flying web between them, and why."""
    one, other = next(bay for bay in bays if len(bay) > 1)[:2]
    throws = [f"{float(pin[0].throw.turns * 360):.6g}" for pin in (one, other)]
    numbers = f"{one[0].number} and {other[0].number}"
    why = f"cylinders {numbers} lie between the same journals on throws of {' and '.join(throws)} degrees"
    remedy = f"{why}: add flying_web = ... (mm), or correct the banks or the firing order"
    return section.missing("flying_web", remedy)


def _read_counterweights(
    section: Section, bays: list[list[PinCylinders]], pins: list[Pin], count: int
) -> dict[int, WebCounterweight]:
    """Return each web's counterweight; its angle counts from opposite the web's pin."""
    next_pins = iter(pins)
    beside = []  # the pin behind each web, of a bay's last web the pin before it
    for bay in bays:
        own = [next(next_pins) for _ in bay]
        beside += [*own, own[-1]]
    weights: dict[int, WebCounterweight] = {}
    for row in section.sections("counterweight"):
        for web in row.places("webs", count):
            if web in weights:
                raise row.refusal("webs", f"gives web {web} a second counterweight", "name each web once")
            weights[web] = _counterweight(row, beside[web - 1].angle)
    return weights


def _counterweight(row: Section, pin: float) -> WebCounterweight:
    return WebCounterweight(
        row.number("mass"),
        row.number("radius"),
        pin + pi + row.number("angle"),
        row.number("inertia"),
        row.number("outer"),
        row.number("half_angle"),
    )


def _material(section: Section) -> Material:
    return Material(*(section.number(key) for key in ("young", "poisson", "density")))


def _disc(section: Section, key: str) -> Disc | None:
    if key not in section:
        return None
    table = section.section(key)
    polar = table.number("polar")
    return Disc(
        table.number("mass"),
        polar,
        table.number("diametral") if "diametral" in table else polar / 2,
        table.number("distance"),
        table.number("diameter"),
    )


def _chain(
    journals: Sequence[Journal],
    webs: Sequence[Web],
    pins: Sequence[Pin],
    bays: Sequence[Sequence[PinCylinders]],
) -> tuple[Part, ...]:
    next_web, next_pin = iter(webs), iter(pins)
    parts: list[Part] = [journals[0]]
    for bay, journal in zip(bays, journals[1:], strict=True):
        parts.append(next(next_web))
        for _ in bay:
            parts += [next(next_pin), next(next_web)]
        parts.append(journal)
    return tuple(parts)


def _check_pitch(section: Section, crank: Crank, engine: Engine, groups: Sequence[PinCylinders]) -> None:
    """Refuse a chain whose pins do not stand where the cylinders do."""
    pitch = engine.pitch
    if pitch is None:
        return
    middles = [
        (start + end) / 2 / MILLI for part, start, end in crank.stations() if isinstance(part, Pin)
    ]
    places = [-float(sum(c.station for c in g) / len(g) * pitch) for g in groups]
    for i, ((m0, m1), (p0, p1)) in enumerate(zip(pairwise(middles), pairwise(places), strict=True), 1):
        same_bay = abs(p1 - p0) < float(pitch) / 2  # pins of one bay: rods side by side
        if not same_bay and abs((m1 - m0) - (p1 - p0)) > PITCH_TOLERANCE * float(pitch):
            what = f"pins {i} and {i + 1} lie {m1 - m0:.6g} mm apart"
            rule = f"must lie {p1 - p0:.6g} mm apart, as their cylinders do"
            remedy = "half pins, webs and journal between them: correct a length, or pitch or stations"
            raise SymbalanceError(what, rule, remedy, section.place())
