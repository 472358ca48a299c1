"""The keys of [crankshaft], [bearings] and [running]: kind, unit, range, default and meaning of each.

`FILE_KEYS` describes all of an engine file: the other tables are those of `engine.engine_keys`. A
reference in Markdown for people and a JSON Schema for editors come from it; docs/engine-files.md and the
package hold them as text, so that nothing is computed when they are read.
"""

from __future__ import annotations

import json
from fractions import Fraction

from symbalance.engine.crank_train import ROD
from symbalance.engine.engine_keys import DEGREES, ENGINE_FILE, KG, KG_MM2, MM, ROD_KEYS
from symbalance.text.key_tables import (
    Excludes,
    FileUnit,
    Key,
    Needs,
    OneOf,
    Some,
    TableKeys,
    Together,
    json_schema,
)
from symbalance.text.kinds import ListOf, MeasuredNumber, OneOrList, Text, Whole
from symbalance.torque.cylinder_gas import AMBIENT
from symbalance.torque.ideal_cycles import HIGHEST_COMPRESSION, MOST_HEAT
from symbalance.torque.pressure import MOST_BAR

GPA, MPA, BAR, RPM = FileUnit("GPa", 1e9), FileUnit("MPa", 1e6), FileUnit("bar"), FileUnit("rpm")
DENSITY, VISCOSITY = FileUnit("kg/m³"), FileUnit("Pa s")
STIFFNESS, DAMPING = FileUnit("N/m"), FileUnit("N s/m")
MOST_PLACES = 2000
"""Journals, pins or webs of the longest crank that a file can describe."""
MOST_RPM = 100_000
THRUST_STIFFNESS = 2e8
"""N/m of the thrust bearing where none is given: an estimate; it only holds the crank in place."""
REMEDY = "check the value, and its unit"

POSITIVE, NOT_NEGATIVE, ANY = MeasuredNumber(0, open_low=True), MeasuredNumber(0), MeasuredNumber()
NAME = Text(longest=4096)
EACH = OneOrList(POSITIVE)
PLACES = ListOf(Whole(1, MOST_PLACES), "[1, 3]")
FROM_FRONT = "counted from 1 at the front"
ABOUT = (
    'A number may be written as text, so that it is exact: "360/7". Lengths are in mm, masses in kg, '
    "angles in degrees, speeds in rpm, pressures in bar."
)


def _round(name: str, meaning: str) -> TableKeys:
    sizes = (
        Key("diameter", EACH, "One for all, or a list from the front", MM, required=True, remedy=REMEDY),
        Key("length", EACH, "Along the crank", MM, required=True, remedy=REMEDY),
        Key("bore", OneOrList(NOT_NEGATIVE), "Of a hole along its axis", MM, 0, remedy=REMEDY),
        Key("fillet", OneOrList(NOT_NEGATIVE), "The radius at the webs", MM, 0, remedy=REMEDY),
    )
    return TableKeys(f"crankshaft.{name}", sizes, meaning=meaning)


def _disc(name: str, meaning: str) -> TableKeys:
    sizes = (
        Key("mass", POSITIVE, "Its mass", KG, required=True, remedy=REMEDY),
        Key("polar", POSITIVE, "Moment of inertia about the crank", KG_MM2, required=True, remedy=REMEDY),
        Key(
            "diametral",
            POSITIVE,
            "Moment of inertia about a diameter",
            KG_MM2,
            otherwise="half of polar",
            remedy=REMEDY,
        ),
        Key("distance", NOT_NEGATIVE, "Of shaft from the last journal's end", MM, 0, remedy=REMEDY),
        Key("diameter", NOT_NEGATIVE, "Of that shaft", MM, 0, remedy=REMEDY),
    )
    return TableKeys(f"crankshaft.{name}", sizes, meaning=meaning)


WEB = TableKeys(
    "crankshaft.web",
    (
        Key("thickness", EACH, "Along the crank", MM, required=True, remedy=REMEDY),
        Key("width", EACH, "Across", MM, required=True, remedy=REMEDY),
        Key("tip", EACH, "How far it reaches beyond the pin's axis", MM, required=True, remedy=REMEDY),
        Key(
            "heel", EACH, "How far it reaches beyond the journal's axis", MM, required=True, remedy=REMEDY
        ),
    ),
    meaning="The webs: one number for all, or a list from the front.",
)
WEB_COUNTERWEIGHT = TableKeys(
    "crankshaft.counterweight",
    (
        Key(
            "webs",
            ListOf(Whole(1, MOST_PLACES), "[1, 2]", least=1),
            f"The webs it is on, {FROM_FRONT}",
            required=True,
            remedy="count from the front",
            add="add webs = [1, 2], counted from 1 at the front",
        ),
        Key("mass", POSITIVE, "Of each", KG, required=True, remedy=REMEDY),
        Key(
            "radius",
            POSITIVE,
            "Of its mass centre from the crank's axis",
            MM,
            required=True,
            remedy=REMEDY,
        ),
        Key("angle", ANY, "From opposite the web's pin", DEGREES, 0, remedy=REMEDY),
        Key("inertia", NOT_NEGATIVE, "About its mass centre, along the crank", KG_MM2, 0, remedy=REMEDY),
        Key("outer", NOT_NEGATIVE, "The outer radius of a sector, for solid webs", MM, 0, remedy=REMEDY),
        Key("half_angle", NOT_NEGATIVE, "Half the angle of a sector", DEGREES, 0, remedy=REMEDY),
    ),
    meaning="One table for each kind of counterweight.",
)
CRANKSHAFT = TableKeys(
    "crankshaft",
    (
        Key("young", POSITIVE, "Young's modulus", GPA, 206, remedy=REMEDY),
        Key(
            "poisson",
            MeasuredNumber(0, Fraction(1, 2), open_high=True),
            "Poisson's ratio",
            default=0.29,
            remedy="steel has 0.29",
        ),
        Key("density", POSITIVE, "The density", DENSITY, 7850, remedy=REMEDY),
        Key("journal", _round("journal", "The journals."), "The journals' sizes", required=True),
        Key("pin", _round("pin", "The crank pins."), "The pins' sizes", required=True),
        Key("web", WEB, "The webs' sizes", required=True),
        Key("flying_web", POSITIVE, "The thickness of a web between two pins", MM, remedy=REMEDY),
        Key(
            "web_only_after",
            PLACES,
            f"Pins that only a flying web parts from the next, {FROM_FRONT}",
            remedy="count from the front",
        ),
        Key(
            "no_bearing",
            PLACES,
            f"Journals without a bearing, {FROM_FRONT}",
            remedy="count from the front",
        ),
        Key("counterweight", WEB_COUNTERWEIGHT, "Counterweights on the webs", listed=True),
        Key("pulley", _disc("pulley", "What turns at the front end."), "At the front end"),
        Key("flywheel", _disc("flywheel", "What turns at the rear end."), "At the rear end"),
    ),
    meaning="The crankshaft's shape, for `symbalance crankshaft`.",
)

BEARINGS = TableKeys(
    "bearings",
    (
        Key("clearance", EACH, "Radial", MM, required=True, remedy="radial, in mm"),
        Key("length", EACH, "Of the shells", MM, otherwise="the journals'", remedy=REMEDY),
        Key(
            "viscosity",
            EACH,
            "Of the oil, at the film's temperature",
            VISCOSITY,
            0.01,
            "0.01, beside a table",
            remedy=REMEDY,
        ),
        Key(
            "housing_vertical",
            EACH,
            "Stiffness of the structure behind the film",
            STIFFNESS,
            otherwise="rigid",
            remedy=REMEDY,
        ),
        Key("housing_lateral", EACH, "The same across", STIFFNESS, otherwise="rigid", remedy=REMEDY),
        Key("housing_damping", OneOrList(NOT_NEGATIVE), "Of the structure", DAMPING, 0, remedy=REMEDY),
        Key(
            "table",
            NAME,
            "A CSV file of film coefficients, beside this one: degrees, then for each bearing kvv, kvl, "
            "klv, kll (N/m), cvv, cvl, clv, cll (N s/m); v is vertical, l lateral, the force's first",
            remedy="name a file",
        ),
        Key(
            "thrust",
            Whole(1, MOST_PLACES),
            "The bearing that holds the crank along its axis",
            otherwise="the last",
            remedy="count from the front",
        ),
        Key("thrust_stiffness", POSITIVE, "Of that bearing", STIFFNESS, THRUST_STIFFNESS, remedy=REMEDY),
    ),
    (
        Some(("viscosity", "table"), "add viscosity = ..., in Pa s"),
        Together(("housing_vertical", "housing_lateral"), "in N/m"),
        Needs("housing_damping", "housing_vertical", "add housing_vertical = ..., in N/m"),
    ),
    "The main bearings, for `symbalance crankshaft`: one number for all, or a list from the front.",
)

STRENGTH = TableKeys(
    "running.strength",
    (
        Key("tensile", POSITIVE, "Tensile strength", MPA, 900, remedy=REMEDY),
        Key("endurance", POSITIVE, "Endurance limit at zero mean stress", MPA, 400, remedy=REMEDY),
        Key("slope", POSITIVE, "Of the S-N line above the endurance limit", default=8, remedy=REMEDY),
        Key("cycles", POSITIVE, "That the endurance limit is borne", default=2_000_000, remedy=REMEDY),
    ),
    meaning="What the material bears. The defaults are estimates for a forged and hardened crank.",
)
OVERLAY = TableKeys(
    "running.overlay",
    (
        Key(
            "file",
            NAME,
            "A CSV file beside this one: degrees and MPa, a point a line",
            required=True,
            remedy="name a file",
            add='as in file = "measured.csv", channel = "pin 2 bending"',
        ),
        Key(
            "channel",
            NAME,
            "The channel of the report it was measured at",
            required=True,
            remedy="name a channel of report.txt",
            add='as in file = "measured.csv", channel = "pin 2 bending"',
        ),
        Key("rpm", POSITIVE, "The speed it belongs to", RPM, otherwise="every speed", remedy=REMEDY),
    ),
    meaning="A measured curve that is drawn beside the computed one.",
)
_SPEED = MeasuredNumber(0, MOST_RPM, open_low=True, rule_text="must be positive, and at most 100000")
RUNNING = TableKeys(
    "running",
    (
        Key("bore", POSITIVE, "The cylinders' bore", MM, required=True, remedy=REMEDY),
        Key(
            "rpm",
            OneOrList(_SPEED),
            "The speeds",
            RPM,
            required=True,
            remedy="a crank at rest has no running stress",
            add="add rpm = 2200, or a list of speeds",
        ),
        Key(
            "pressure",
            NAME,
            "A CSV file beside this one: degrees after firing top dead centre, bar absolute",
            remedy="name a file",
        ),
        Key(
            "compression",
            MeasuredNumber(1, HIGHEST_COMPRESSION, open_low=True),
            "Or the compression ratio of an ideal cycle",
            remedy="a volume ratio, 8 to 22",
        ),
        Key(
            "heat",
            MeasuredNumber(0, MOST_HEAT),
            "Of the ideal cycle, over the swept volume: 1 bar is 100 J per litre",
            BAR,
            remedy="Q/V_h in bar: 100 J per litre; 0 is a motored engine",
        ),
        Key(
            "peak_pressure",
            MeasuredNumber(0, MOST_BAR, open_low=True),
            "Of the ideal cycle, absolute",
            BAR,
            remedy="absolute, in bar",
        ),
        Key(
            "intake",
            MeasuredNumber(0, MOST_BAR, open_low=True),
            "Of the ideal cycle, absolute",
            BAR,
            otherwise="1",
            remedy="absolute, in bar",
        ),
        Key("ambient", NOT_NEGATIVE, "Behind the piston", BAR, float(AMBIENT), remedy=REMEDY),
        Key(
            "big_end_mass",
            NOT_NEGATIVE,
            "The big end's share of each rod, with its bearing shells",
            KG,
            otherwise="the rod's",
            remedy=REMEDY,
        ),
        *ROD_KEYS,
        Key(
            "damping",
            MeasuredNumber(0, 1, open_high=True),
            "Of the critical damping",
            default=0.01,
            remedy="of critical; 0.01 to 0.03 is usual",
        ),
        Key("strength", STRENGTH, "What the material bears"),
        Key("overlay", OVERLAY, "A measured curve"),
    ),
    (
        OneOf(
            (("pressure",), ("compression",)),
            "needs pressure or compression",
            'write pressure = "trace.csv" (degrees, bar), or compression and heat of an ideal cycle',
        ),
        *(
            Excludes(key, ("pressure",), "is for an ideal cycle", "drop it, or drop pressure")
            for key in ("heat", "peak_pressure", "intake")
        ),
        Some(
            ("heat", "peak_pressure", "pressure"),
            "add heat = 18 (p V at bottom dead centre), or peak_pressure",
        ),
        Together(ROD, "or give big_end_mass alone"),
        Excludes(
            "big_end_mass",
            ROD,
            "is rod_mass's big end already",
            "give one or the other",
        ),
    ),
    "How the engine runs, for `symbalance crankshaft`.",
)

FILE_KEYS = ENGINE_FILE.with_kinds({"crankshaft": CRANKSHAFT, "bearings": BEARINGS, "running": RUNNING})
"""The keys of a whole engine file."""


def schema_of_engine_files() -> str:
    """Return the JSON Schema (draft 2020-12) of an engine file.

    It says which keys there are, what their values are and which go together; what depends on several
    tables (a firing order and its cylinders, a rod and its stroke) is left to the reader.
    """
    schema = json_schema(FILE_KEYS, "urn:symbalance:engine-file", "symbalance engine file", ABOUT)
    return json.dumps(schema, indent=1, ensure_ascii=False) + "\n"


def reference_of_keys() -> str:
    """Return the reference of all keys of an engine file, in Markdown."""
    return "\n".join(FILE_KEYS.reference()).rstrip() + "\n"
