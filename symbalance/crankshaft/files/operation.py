"""Reading of [running] in an engine file: bore, speeds, gas pressure, rods, strength, measured curve."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import pi
from pathlib import Path

from symbalance.crankshaft.files.crank_keys import MOST_RPM
from symbalance.engine.crank_train import ROD
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.kinematics.mechanisms import RodSplit
from symbalance.text.named_paths import NamingFolder
from symbalance.text.sections import Section
from symbalance.torque import IdealCycle, PressureTrace, ideal_cycle, read_pressure

MILLI = 1e-3
IDEAL = ("heat", "peak_pressure", "intake")


@dataclass(frozen=True)
class Strength:
    """Strength of the material, Pa: tensile strength, endurance limit at zero mean, and the S-N line.

    Amplitudes above the endurance limit last `cycles` (endurance/amplitude)^slope. The defaults are
    estimates for a forged and hardened steel crank; a real assessment needs measured ones.
    """

    tensile: float = 900e6
    endurance: float = 400e6
    slope: float = 8.0
    cycles: float = 2e6


@dataclass(frozen=True)
class Overlay:
    """A measured curve for comparison: file, stress channel, speed in rpm (None: every one)."""

    path: Path
    channel: str
    rpm: float | None


@dataclass(frozen=True)
class Operation:
    """Operating conditions in SI units but `rpm`; `excess` is the rods' J_x in kg m^2, `damping` modal.

    `trace` counts from a piston's own firing top dead centre; of an `ideal` cycle it is cylinder 1's.
    """

    bore: float
    rpm: tuple[float, ...]
    trace: PressureTrace
    ambient: float
    big_end_mass: float
    excess: float
    damping: float
    strength: Strength
    overlay: Overlay | None
    ideal: IdealCycle | None = None

    @property
    def area(self) -> float:
        """The piston's area in m^2."""
        return pi * self.bore**2 / 4


def read_operation(section: Section, engine: Engine, folder: NamingFolder) -> Operation:
    """Return what [running] says: bore in mm, speeds in rpm, pressures in bar absolute, kg, kg mm^2."""
    rod, ideal = _rod(section, engine), _ideal(section, engine)
    big_end_mass = _big_end_mass(section, rod)
    _check_rods(section, engine, rod, big_end_mass)
    return Operation(
        bore=section.number("bore"),
        rpm=_speeds(section),
        trace=_trace(section, engine, folder) if ideal is None else _first(section, ideal, engine),
        ambient=section.number("ambient"),
        big_end_mass=big_end_mass,
        excess=0.0 if rod is None else float(rod.excess) * MILLI**2,
        damping=section.number("damping"),
        strength=_strength(section.section("strength")),
        overlay=_overlay(section, folder),
        ideal=ideal,
    )


def _speeds(section: Section) -> tuple[float, ...]:
    value = section.value("rpm")
    speeds = [float(v) for v in (value if isinstance(value, list) else [value])]
    return section.guarded(lambda: sorted_speeds(speeds), "rpm")


def speed_text(rpm: float) -> str:
    """Return a speed in rpm as a report or a file name says it: no two speeds alike.

    >>> speed_text(2200.0), speed_text(2200.001), speed_text(0.1)
    ('2200', '2200.001', '0.1')
    """
    return repr(float(rpm)).removesuffix(".0")


def sorted_speeds(speeds: list[float]) -> tuple[float, ...]:
    """Return speeds in rising order; refuse none at all, one not positive, and repeated ones."""
    if not speeds:
        raise SymbalanceError("rpm = []", "names no speed", "write rpm = 2200, or a list")
    for speed in speeds:
        if not 0 < speed <= MOST_RPM:
            rule = f"must lie in (0, {MOST_RPM}] rpm"
            raise SymbalanceError(
                f"rpm = {speed_text(speed)}", rule, "a crank at rest has no running stress"
            )
    speeds_up = tuple(sorted(speeds))
    for before, after in pairwise(speeds_up):
        if before == after:
            raise SymbalanceError(f"rpm = {speed_text(after)}", "is named twice", "name each speed once")
    return speeds_up


def _trace(section: Section, engine: Engine, folder: NamingFolder) -> PressureTrace:
    name = section.value("pressure")
    return section.guarded(lambda: read_pressure(folder.file(name), strokes=engine.strokes), "pressure")


def _ideal(section: Section, engine: Engine) -> IdealCycle | None:
    """Return the ideal cycle, None where a pressure trace is given."""
    if "pressure" in section:
        return None
    options = {key: section.value(key) for key in IDEAL if key in section}
    compression = section.value("compression")
    return section.guarded(
        lambda: ideal_cycle(compression, strokes=engine.strokes, **options), "compression"
    )


def _first(section: Section, ideal: IdealCycle, engine: Engine) -> PressureTrace:
    return section.guarded(lambda: ideal.trace(engine.first.known_mechanism), "compression")


def _rod(section: Section, engine: Engine) -> RodSplit | None:
    keys = [key for key in ROD if key in section]
    if not keys:  # [crank_train] may give the rod for the other commands: the same keys, the same rod
        return engine.first.rod_split
    length = engine.first.sizes.rod
    if length is None:
        raise section.refusal(keys[0], "needs the rod's length", "add rod = ..., in mm, in [crank_train]")
    mass, centre, inertia = (section.value(key) for key in ROD)
    rod = section.guarded(lambda: RodSplit(mass, length, centre, inertia), "rod_centre")
    share = engine.first.reciprocating_mass
    if share is not None and rod.reciprocating > share:
        rule = f"puts {float(rod.reciprocating):.6g} kg at the piston, above reciprocating_mass"
        raise section.refusal(
            "rod_mass", rule, "reciprocating_mass holds piston, pin and the rod's share"
        )
    return rod


def _big_end_mass(section: Section, rod: RodSplit | None) -> float:
    if rod is not None and "big_end_mass" not in section:
        return float(rod.rotating)
    if "big_end_mass" not in section:
        remedy = "kg a rod, its rotating share with the bearing shells; 0 leaves it out"
        raise section.missing("big_end_mass", remedy)
    return section.number("big_end_mass")


def _check_rods(section: Section, engine: Engine, rod: RodSplit | None, big_end_mass: float) -> None:
    """Refuse one rod's masses and inertia for all where rods differ, or hang on link pins."""
    key = next((k for k in ("rod_mass", "big_end_mass") if k in section), "")
    what, place = f"{key} = {section.table[key]}" if key else "rod_mass", section.place(key)
    if engine.link_pins and (big_end_mass or (rod is not None and rod.excess)):
        rule = f"of cylinder {engine.link_pins[0]} would sit on its link pin, and is put on the crank pin"
        remedy = "give big_end_mass = 0 and no rod_mass: what a link pin's mass adds is not computed"
        raise SymbalanceError(what, rule, remedy, place)
    rods = {tuple(getattr(c.sizes, key) for key in ("rod", *ROD)) for c in engine.cylinders}
    if rod is not None and len(rods) > 1:
        rule = "is one rod's, and the engine's rods are not alike"
        raise SymbalanceError(what, rule, "give big_end_mass, and no rod_mass", place)


def _strength(table: Section) -> Strength:
    strength = Strength(*(table.number(key) for key in ("tensile", "endurance", "slope", "cycles")))
    if strength.endurance >= strength.tensile:
        rule = f"must lie below the tensile strength, {strength.tensile / 1e6:.6g} MPa"
        raise table.refusal("endurance", rule, "both in MPa")
    return strength


def _overlay(section: Section, folder: NamingFolder) -> Overlay | None:
    if "overlay" not in section:
        return None
    table = section.section("overlay")
    speed = table.number("rpm") if "rpm" in table else None
    name = table.value("file")
    path = table.guarded(lambda: folder.file(name), "file")
    return Overlay(path, table.value("channel"), speed)
