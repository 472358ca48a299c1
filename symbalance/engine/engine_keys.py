"""The keys of an engine file: kind, unit, range, default and meaning of each, table by table.

The reader (`engine_file`), the reference in docs/engine-files.md and the JSON Schema for editors are
made from these tables. [crankshaft], [bearings] and [running] are described where they are read:
`symbalance.crankshaft.files.crank_keys`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import pi
from typing import Any

from symbalance.engine.builders import FIRING_AT
from symbalance.engine.cylinders import LONGEST_STATION, MOST_CYLINDERS
from symbalance.engine.dead_centres import COARSEST, FINEST_STEP
from symbalance.engine.engine import LONGEST_NAME
from symbalance.engine.station_lists import PITCHES as IN_PITCHES
from symbalance.engine.station_lists import STATION_UNITS
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import LARGEST_DENOMINATOR, degrees
from symbalance.exact.cosine_sums import PATTERN, read_cosines
from symbalance.kinematics.slider_crank import HIGHEST_ORDER
from symbalance.text.key_tables import Excludes, FileUnit, Key, Needs, OneOf, Some, TableKeys
from symbalance.text.kinds import (
    ANY,
    NOT_NEGATIVE,
    POSITIVE,
    Choice,
    ExactNumber,
    ListOf,
    ListOrLists,
    Schema,
    Text,
    Whole,
)
from symbalance.text.numbers import LARGEST_QUOTIENT, exact

MM, KG, KG_MM2, DEGREES = (
    FileUnit("mm", 1e-3),
    FileUnit("kg"),
    FileUnit("kg mm²", 1e-6),
    FileUnit("degrees", pi / 180),
)
PITCHES, KG_MM = FileUnit("pitches"), FileUnit("kg mm", 1e-3)
SIZES = "sizes are in mm and kg"


@dataclass(frozen=True)
class ExactDegrees(ExactNumber):
    """An angle in degrees, whose denominator is bounded: everything exact is in a field of that order."""

    def parse(self, value: object, name: str) -> Fraction:
        """Return the degrees that are written."""
        number = exact(value, name)
        if number.denominator > LARGEST_DENOMINATOR:
            return degrees(value, name).in_degrees()  # refuses it
        return number


@dataclass(frozen=True)
class ExactSize(ExactNumber):
    """A number, or a text that says one of an exact field as a sum of cosines: "1/2 cos 36 - 1/8"."""

    words = "number, or a sum of cosines"

    def read(self, value: object, name: str, remedy: str) -> Any:
        """Return the fraction, or the number of an exact field."""
        if isinstance(value, str) and "cos" in value:
            return read_cosines(value, name)
        return super().read(value, name, remedy)

    def schema(self) -> Schema:
        """Return the schema: a number, a text of one, or a sum of cosines."""
        schema = super().schema()
        # A sum without a cosine is a number, whose own pattern knows that nothing is divided by 0.
        return {**schema, "pattern": f"{schema['pattern']}|^(?=.*cos){PATTERN.removeprefix('^')}"}


@dataclass(frozen=True)
class SizeOrParts(ExactSize):
    """A size, or a list of two: along a direction, and a quarter turn after it."""

    words = "number or sum of cosines, or a list of two"

    def read(self, value: object, name: str, remedy: str) -> Any:
        """Return the size, or the two parts."""
        if not isinstance(value, list):
            return super().read(value, name, remedy)
        if len(value) != 2:
            rule = "must hold two parts: along its direction, and a quarter turn after it"
            raise SymbalanceError(f"{name} = {brief(value)}", rule, 'write it like ["1/2", "-1/3"]')
        each = (super(SizeOrParts, self).read(v, f"{name}[{i}]", remedy) for i, v in enumerate(value, 1))
        return tuple(each)

    def schema(self) -> Schema:
        """Return the schema: a size, or two of them."""
        each = super().schema()
        return {"anyOf": [each, {"type": "array", "items": each, "minItems": 2, "maxItems": 2}]}


class OnePitch(ExactNumber):
    """The pitch a, one number: several, as a drawing lists them, belong to the layout."""

    def parse(self, value: object, name: str) -> Fraction:
        """Return the number, or refuse a list with the place it belongs to."""
        if isinstance(value, list):
            rule, remedy = "must be one number", 'list distances in [layout], with station_unit = "mm"'
            raise SymbalanceError(f"{name} of {len(value)} values", rule, remedy)
        return super().parse(value, name)


ANGLE, SIZE = ExactDegrees(), SizeOrParts(finest=LARGEST_QUOTIENT)

ROD_KEYS = (
    Key("rod_mass", NOT_NEGATIVE, "The rod's own mass", KG, remedy=SIZES),
    Key("rod_centre", NOT_NEGATIVE, "Its centre of gravity, from the big end", MM, remedy=SIZES),
    Key("rod_inertia", NOT_NEGATIVE, "Its moment of inertia about the centre of gravity", KG_MM2),
)
_OFFSET = (
    "How far the cylinder's axis passes the crank, "
    "towards the side the pin moves to after top dead centre"
)
STROKE = Key("stroke", POSITIVE, "Twice the crank radius", MM, remedy=SIZES)
ROD_LENGTH = Key("rod", POSITIVE, "The rod's length between centres", MM, remedy=SIZES)
MASSES = (
    Key(
        "reciprocating_mass",
        NOT_NEGATIVE,
        "Of each cylinder: piston, rings, pin and the small end's share of the rod",
        KG,
        remedy=SIZES,
    ),
    Key(
        "rotating_mass",
        NOT_NEGATIVE,
        "Of each cylinder, at the crank radius: the big end's share and the throw's own unbalance",
        KG,
        remedy=SIZES,
    ),
)
OFFSET = Key("offset", ANY, _OFFSET, MM, otherwise="0")

CRANK_TRAIN = TableKeys(
    "crank_train",
    (
        Key("bore", POSITIVE, "Of every cylinder; for the gas torque", MM, remedy=SIZES),
        STROKE,
        ROD_LENGTH,
        Key(
            "pitch",
            OnePitch(0, open_low=True),
            "a, between neighbouring cylinders of a bank; unequal ones are listed in `[layout]`",
            MM,
            remedy=SIZES,
        ),
        *MASSES,
        Key(
            "ratio",
            ExactNumber(
                1,
                open_low=True,
                finest=LARGEST_QUOTIENT,
                rule_text="the rod must be longer than the crank, lambda = l/r > 1",
            ),
            "The rod ratio λ = l/r, where stroke and rod are not given",
            remedy="engines have 3 to 4.5; r/l is the inverse",
        ),
        OFFSET,
        *ROD_KEYS,
    ),
    (
        Excludes(
            "ratio", ("stroke", "rod"), "is 2*rod/stroke already", "give either ratio, or stroke and rod"
        ),
    ),
    "The sizes all cylinders share. The three keys of the rod's own inertia are given together; the two "
    "masses at its ends are counted in `reciprocating_mass` and `rotating_mass`.",
)

_STROKES = Key(
    "strokes",
    Choice((2, 4)),
    "Strokes of a cycle",
    default=4,
    remedy="a number, without quotes",
)
_CYLINDER_NUMBER = Whole(1, MOST_CYLINDERS)

_ONCE = "leave one of them out"
LAYOUT = TableKeys(
    "layout",
    (
        _STROKES,
        Key(
            "banks",
            ListOf(ANGLE, '[-30, "61/2"]', least=1),
            "Each bank's angle from vertical, clockwise seen from the front, modulo 360",
            DEGREES,
            otherwise="[0]",
        ),
        Key(
            "cylinders",
            ListOf(ListOf(_CYLINDER_NUMBER, "[1, 3, 5]", least=1), "[[1, 3, 5], [2, 4, 6]]", least=1),
            "The cylinders' numbers in each bank, front to rear",
            otherwise="the one bank's, in order",
            remedy="count from the front",
        ),
        Key(
            "firing_order",
            ListOf(_CYLINDER_NUMBER, "[1, 3, 4, 2]", least=1),
            "The cylinders' numbers as they fire",
            otherwise="left open, with `pins`",
            remedy="write it like [1, 3, 4, 2]",
        ),
        Key(
            "firing_intervals",
            ListOf(ExactDegrees(0), '[90, "61/2"]'),
            "From each firing to the next",
            DEGREES,
            otherwise="even",
            remedy="use degrees after each firing",
        ),
        Key(
            "stagger",
            ListOf(ANY, '["1/4", "-1/4"]'),
            "Each bank's shift, + towards the front",
            PITCHES,
            otherwise="0",
        ),
        Key(
            "stations",
            ListOrLists(ANY, "[0, -1, -2.25]", "[[0, -1, -2.25], [-0.2, -1.2, -2.45]]"),
            "Places along the crank, front to rear, + towards the front, from any zero: one list for all "
            "banks, or one a bank",
            PITCHES,
            otherwise="one pitch apart",
        ),
        Key(
            "pitch",
            ListOf(POSITIVE, '[1, 1, "5/4", 1, 1]'),
            "Or unequal distances from each cylinder of a bank to the next, front to rear",
            PITCHES,
            otherwise="1",
            remedy="from each cylinder to the next",
        ),
        Key(
            "station_unit",
            Choice(STATION_UNITS),
            "Of `stations`, `pitch` and `stagger`; in mm the pitch a, in which couples count, is that of "
            "`[crank_train]`, or else the first of `pitch`",
            default=IN_PITCHES,
            remedy="of stations, pitch and stagger",
        ),
        Key(
            "pins",
            ListOrLists(ANGLE, "[0, 240, 120]", "[[0, 240, 120], [30, 270, 150]]"),
            "The crank pins' angles at θ = 0, front to rear: one list of pins that all banks share, or, "
            "where every cylinder has its own, one a bank",
            DEGREES,
            otherwise="as the firing order needs",
        ),
        Key(
            "splay",
            ListOf(ANGLE, "[0, 30]"),
            "How far each bank's pins are turned on from those listed",
            DEGREES,
            otherwise="0",
        ),
        Key(
            "offset",
            ListOf(ANY, "[-12.5, 12.5]"),
            f"Of each bank. {_OFFSET}",
            MM,
            otherwise="that of `[crank_train]`",
        ),
        Key(
            "firing_at",
            Choice(FIRING_AT),
            "What follows one another at the firing intervals, where an offset moves the dead centres",
            default="pins",
            remedy="they differ where cylinders are offset",
        ),
        Key(
            "pin_step",
            ExactNumber(0, COARSEST, open_low=True, finest=FINEST_STEP),
            "To what the pins are turned with `firing_at`",
            DEGREES,
            default="1/100",
            remedy='write it like "1/2" or 0.01',
        ),
    ),
    (
        Some(
            ("firing_order", "pins"),
            "write it like firing_order = [1, 3, 4, 2], or list the crank's pins",
        ),
        Needs(
            "firing_intervals",
            "firing_order",
            "add firing_order = [1, 3, 4, 2]",
            "follow a firing order",
        ),
        Excludes("pitch", ("stations",), "says with stations where the cylinders stand twice", _ONCE),
        Needs("splay", "pins", "list them with pins = [...]", "turns the pins that are listed"),
        Excludes("firing_at", ("pins",), "turns the pins, which are listed", _ONCE),
        Excludes("pin_step", ("pins",), "turns the pins, which are listed", _ONCE),
    ),
    "Banks, and a firing order or the crank's pins. Without `pins` cylinder 1 is at its firing top dead "
    "centre at θ = 0. With both, each cylinder fires when its pin has brought it to the top, evenly "
    "where the pins allow it.",
)

_LINK = "belongs to a link rod"
_MASTER = "add master = the number of the master rod's cylinder"
CYLINDER = TableKeys(
    "cylinder",
    (
        Key(
            "number",
            _CYLINDER_NUMBER,
            "The cylinder's own number",
            required=True,
            remedy="count from the front",
        ),
        Key("throw", ANGLE, "Its crank pin's angle at θ = 0", DEGREES, required=True),
        Key("bank", ANGLE, "Its axis' angle from vertical", DEGREES, otherwise="0"),
        Key(
            "station",
            ExactNumber(-LONGEST_STATION, LONGEST_STATION),
            "Its place along the crank, + towards the front",
            PITCHES,
            otherwise="0",
            remedy="give cylinder pitches, not millimetres",
        ),
        Key(
            "fires",
            ExactDegrees(0, 720, open_high=True),
            "Its firing angle after cylinder 1's firing top dead centre",
            DEGREES,
            remedy="degrees after cylinder 1's firing",
        ),
        Key("bore", POSITIVE, "As of `[crank_train]`: the same for every cylinder", MM, remedy=SIZES),
        STROKE,
        ROD_LENGTH,
        *MASSES,
        OFFSET,
        *ROD_KEYS,
        Key(
            "master",
            _CYLINDER_NUMBER,
            "Of a link rod: the number of the cylinder whose rod it is attached to",
            remedy="name the master's cylinder",
        ),
        Key("link_angle", ANGLE, "The link pin's direction from the master rod", DEGREES, otherwise="0"),
        Key(
            "link_radius",
            NOT_NEGATIVE,
            "The link pin's distance from the crank pin",
            MM,
            otherwise="0",
            remedy=SIZES,
        ),
    ),
    (Needs("link_angle", "master", _MASTER, _LINK), Needs("link_radius", "master", _MASTER, _LINK)),
    "One cylinder each. Its own sizes override those of `[crank_train]`.",
)

_SHARE = (
    "A multiple of Aₙ m r/n², n the speed over the crank's; exact where it is no fraction, as "
    '`"1/2 cos 36 - 1/8"`, in degrees, or as two parts, `["1/2", "-1/3"]`: along its direction, and a '
    "quarter turn after it"
)
_WEIGHED = ("unbalance", "share")
_SIZE = "takes either unbalance or share", "kg mm, or a multiple of A_n m r/n^2"
_STATION = Key("station", ANY, "The place along the crank, + towards the front", PITCHES, otherwise="0")
_UNBALANCE = Key("unbalance", SIZE, "Mass times radius, one size or two parts as of `share`", KG_MM)
_SHARE_KEY = Key("share", SIZE, _SHARE)
_PLACE = Whole(1, 2 * MOST_CYLINDERS)

COUNTERWEIGHT = TableKeys(
    "counterweight",
    (
        Key("throw", _PLACE, "The cylinder whose throw it is on", remedy="count from 1"),
        Key(
            "web",
            _PLACE,
            "Or the web it is on, from the front: two to a pin, a quarter pitch from it",
            remedy="count from 1",
        ),
        Key(
            "angle",
            ANGLE,
            "Its direction at θ = 0; on a throw or a web, from opposite the pin",
            DEGREES,
            otherwise="0",
        ),
        Key("station", ANY, "Its place along the crank", PITCHES, otherwise="the throw's or the web's"),
        _UNBALANCE,
        _SHARE_KEY,
        Key(
            "overbalance",
            ANY,
            "With a throw: all of its rotating mass and so much of its reciprocating mass",
        ),
    ),
    (
        OneOf(
            (("unbalance",), ("share",), ("overbalance",)),
            "takes one of unbalance, share and overbalance",
            "give one of them",
        ),
        Excludes("web", ("throw",), "stands on a throw's web", "leave out throw"),
        Needs("overbalance", "throw", "add throw = its number", "is of the masses of one cylinder"),
    ),
    "A weight on the crank. Rotating masses count from the first such table on.",
)

WEIGHT = TableKeys(
    "balance_shaft.weights",
    (
        _STATION,
        _UNBALANCE,
        _SHARE_KEY,
        Key("phase", ANGLE, "Its direction on the shaft", DEGREES, otherwise="0"),
    ),
    (OneOf((("unbalance",), ("share",)), *_SIZE),),
    "One weight of a shaft that has several.",
)

_ONE_WAY = "takes either weights, or station and unbalance or share"
BALANCE_SHAFT = TableKeys(
    "balance_shaft",
    (
        Key(
            "speed",
            Whole(-HIGHEST_ORDER, HIGHEST_ORDER, but=0),
            "Its speed over the crank's; - turns against the crank",
            required=True,
            remedy="times the crank's; - turns against it",
            add="add speed = 2 or -2, - turns against the crank",
        ),
        Key("phase", ANGLE, "Its direction at θ = 0", DEGREES, otherwise="0"),
        _STATION,
        _UNBALANCE,
        _SHARE_KEY,
        Key(
            "x",
            ANY,
            "Its axis' distance to the right of the crank, seen from the front",
            MM,
            otherwise="0",
        ),
        Key("y", ANY, "How far its axis is above the crank", MM, otherwise="0"),
        Key(
            "weights",
            WEIGHT,
            "Several weights on one shaft",
            remedy="[{ station = 1, share = 2, phase = 180 }]",
            listed=True,
            inline=True,
            least=1,
        ),
    ),
    (
        Excludes("weights", ("station", *_WEIGHED), _ONE_WAY, "describe its weights one way"),
        OneOf((("weights",), ("unbalance",), ("share",)), _ONE_WAY, "describe its weights one way"),
    ),
    "A shaft beside the crank, with one weight or several.",
)

ESTIMATED = (
    *("bore", "stroke", "rod", "pitch", "ratio", "offset"),
    *("reciprocating_mass", "rotating_mass", "rod_mass", "rod_centre", "rod_inertia"),
    *("banks", "cylinders", "firing_order", "firing_intervals", "stagger"),
    *("stations", "pins", "splay"),
    *("master", "link_angle", "link_radius"),
)
"""What may be marked as an estimate: keys of [crank_train], [layout] and [[cylinder]]."""
ESTIMATES = TableKeys(
    "estimates",
    tuple(Key(key, Text(), f"Why `{key}` is an estimate, and of what") for key in ESTIMATED),
    meaning="The figures nobody looked up, each with its reason; `symbalance engines --full` lists them.",
)

_OPAQUE = TableKeys("", (), others=Text())
"""A table that is known and not read here."""

ENGINE_FILE = TableKeys(
    "",
    (
        Key(
            "name",
            Text(LONGEST_NAME),
            "The engine's name, which heads the tables",
            otherwise="the file's",
            remedy="it heads the tables",
        ),
        Key("description", Text(), "What it is"),
        Key("source", Text(), "Where its figures come from"),
        Key("estimates", ESTIMATES, "Which of its figures are estimates, and why"),
        _STROKES,
        Key("crank_train", CRANK_TRAIN, "The sizes all cylinders share"),
        Key("layout", LAYOUT, "Banks, and a firing order or crank pins"),
        Key("cylinder", CYLINDER, "Or: each cylinder by itself", listed=True, least=1),
        Key("counterweight", COUNTERWEIGHT, "Weights on the crank", listed=True),
        Key("balance_shaft", BALANCE_SHAFT, "Shafts that turn beside the crank", listed=True),
        Key("crankshaft", _OPAQUE, "The crankshaft's sizes, for `symbalance crankshaft`"),
        Key("bearings", _OPAQUE, "Its main bearings, for `symbalance crankshaft`"),
        Key("running", _OPAQUE, "How it runs, for `symbalance crankshaft`"),
    ),
    (
        OneOf(
            (("layout",), ("cylinder",)),
            "must hold either a [layout] table or [[cylinder]] tables",
            "describe the engine one way",
        ),
        Excludes("strokes", ("layout",), "belongs into [layout] here", "move it"),
    ),
    "Texts that are printed with the tables, and the tables that follow.",
)
