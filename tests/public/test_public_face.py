"""Laws of the public face: one definition per name, public types as arguments, a sentence a module."""

from __future__ import annotations

import ast
import inspect
import pickle
import re
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

import symbalance as sb
from symbalance.document.result import Result
from tests.results import EXAMPLES, example

PACKAGE = Path(sb.__file__).parent
MODULES = sorted(PACKAGE.rglob("*.py"))
STUB_LINE = re.compile(r"^from ([\w.]+) import (\w+) as (\w+)$", re.MULTILINE)


def public_names() -> Iterator[tuple[str, str, str]]:
    """Yield (room, name, module it is defined in) of each line of the stubs that is no room."""
    for stub in sorted(PACKAGE.rglob("__init__.pyi")):
        room = ".".join(stub.parent.relative_to(PACKAGE.parent).parts)
        for home, name, _ in STUB_LINE.findall(stub.read_text(encoding="utf-8")):
            if home != room:
                yield room, name, home


def test_a_public_name_is_one_thing_in_every_room():
    values = defaultdict(list)
    for _, name, home in public_names():
        value = getattr(import_module(home), name)
        if not any(value is other for other in values[name]):
            values[name].append(value)
    assert len(values) > 50
    assert {name: several for name, several in values.items() if len(several) > 1} == {}


@pytest.mark.slow
def test_no_other_class_of_the_package_has_the_name_of_a_public_one():
    values = {name: getattr(import_module(home), name) for _, name, home in public_names()}
    homes = {name: value.__module__ for name, value in values.items() if inspect.isclass(value)}
    library = [path for path in MODULES if "bench" not in path.parts]  # it has parts of its own
    for path in library:
        home = ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts).removesuffix(".__init__")
        for node in ast.parse(path.read_bytes()).body:
            if isinstance(node, ast.ClassDef) and node.name in homes:
                assert homes[node.name] == home, f"{node.name} is defined in {home} too"


def test_a_public_name_stays_itself_when_its_module_is_imported():
    """A module of the same name in the same room would take the function's place."""
    for room, name, _ in public_names():
        folder = PACKAGE.parent.joinpath(*room.split("."))
        why = f"{room}.{name}: the module of that name would take the place of what is public"
        assert not (folder / name).is_dir(), why
        assert not (folder / f"{name}.py").exists(), why


LONGEST_SENTENCE = 130


@pytest.mark.parametrize(
    "room", sorted(p.name for p in PACKAGE.iterdir() if p.is_dir() or p.suffix == ".py")
)
def test_every_module_opens_with_one_sentence(room):
    """The tour of the documentation is made of these: each must be whole on its line."""
    for path in MODULES:
        if path.relative_to(PACKAGE).parts[0] == room:
            text = ast.get_docstring(ast.parse(path.read_bytes()))
            assert text, f"{path} has no docstring"
            sentence = text.partition("\n\n")[0]
            assert sentence.endswith((".", "?")), f"{path}: {sentence}"
            assert "\n" not in sentence, f"{path}: {sentence}"
            assert 15 <= len(sentence) <= LONGEST_SENTENCE, f"{path}: {sentence}"


JOURNAL, PIN = sb.crankshaft.Journal(0.05, 0.03), sb.crankshaft.Pin(0.05, 0.03, 0.04, 0.0, (1,))
WEB = sb.crankshaft.Web(0.02, 0.1, 0.06, 0.06)
DISC = {"mass": 1.0, "polar": 0.1, "diametral": 0.1}
WEIGHT = sb.engine.Weight(unbalance=60)
ARGUMENTS: dict[type, dict[str, Any]] = {
    sb.BalanceShaft: {"speed": 2, "weights": [WEIGHT], "phase": 90, "x": 10, "y": 20},
    sb.engine.Balancers: {"counterweights": (sb.Counterweight(unbalance=9),), "shafts": ()},
    sb.crankshaft.Bearing: {"diameter": 0.1, "length": 0.03, "clearance": 1e-4, "viscosity": 0.1},
    sb.Counterweight: {"angle": 180, "station": "1/2", "unbalance": 100},
    sb.crankshaft.Crank: {
        "parts": (JOURNAL, WEB, PIN, WEB, JOURNAL),
        "material": sb.crankshaft.Material(),
        "pulley": sb.crankshaft.Disc(**DISC),
        "flywheel": sb.crankshaft.Disc(**DISC),
    },
    sb.engine.CrankTrain: {
        "stroke": 80,
        "rod": Fraction(140),
        "pitch": "100",
        "reciprocating_mass": "0.5",
    },
    sb.Cylinder: {
        "number": 2,
        "throw": 180,
        "bank": 30,
        "station": 1,
        "fires": 90,
        "link": sb.engine.Link(1),
    },
    sb.crankshaft.Disc: DISC,
    sb.Engine: {
        "cylinders": [sb.Cylinder(1)],
        "strokes": 2,
        "name": "one",
        "pitch": 90,
        "balancers": None,
    },
    sb.crankshaft.Journal: {
        "diameter": 0.05,
        "length": 0.03,
        "bore": 0.01,
        "fillet": 0.002,
        "bearing": True,
    },
    sb.engine.Link: {"master": 1, "angle": 40, "radius": 30},
    sb.crankshaft.Material: {"young": 2e11, "poisson": 0.3, "density": 7800.0},
    sb.crankshaft.Pin: {
        "diameter": 0.05,
        "length": 0.03,
        "radius": 0.04,
        "angle": 0.0,
        "cylinders": (1,),
    },
    sb.crankshaft.rotor.Support: {"stiffness": 1e6, "damping": 10.0, "tilt": 0.0},
    sb.design.Tolerances: {"mass": "1%", "throw": "0.1"},
    sb.crankshaft.rotor.Tube: {"length": 0.1, "diameter": 0.05, "bore": 0.01, "elements": 3},
    sb.crankshaft.Web: {"thickness": 0.02, "width": 0.1, "tip": 0.06, "heel": 0.06},
    sb.crankshaft.WebCounterweight: {"mass": 0.5, "radius": 0.05, "angle": 3.0, "inertia": 0.0},
    sb.engine.Weight: {"station": 1, "phase": 90, "share": 2},
}
"""What each class that users construct is made from, in part or in whole."""
WRONG = [object(), sb.SymbalanceError("no", "argument"), [object()], {}, "x y"]
"""Values that no argument takes: of other classes, of none, and text that is neither number nor unit."""
ANY_TEXT = {(sb.Engine, "name")}


@pytest.mark.parametrize("kind", ARGUMENTS, ids=lambda kind: kind.__name__)
def test_a_public_constructor_takes_public_types_and_refuses_others(kind):
    sound = ARGUMENTS[kind]
    assert isinstance(kind(**sound), kind)
    for name in sound:
        for wrong in WRONG:
            if (kind, name) in ANY_TEXT and isinstance(wrong, str):
                continue
            with pytest.raises(sb.SymbalanceError):
                raise AssertionError(f"{kind.__name__} takes {name} = {kind(**{**sound, name: wrong})!r}")


@pytest.mark.parametrize("kind", ARGUMENTS, ids=lambda kind: kind.__name__)
def test_another_public_value_in_an_argument_s_place_is_refused(kind):
    """Two classes of one name once let `Web` take a counterweight that its assembly could not."""
    others = [
        sb.crankshaft.rotor.Tube(0.1, 0.05),
        sb.Counterweight(unbalance=9),
        sb.crankshaft.Material(),
        sb.engine.Link(1),
        WEIGHT,
    ]
    for name, value in ARGUMENTS[kind].items():
        for other in others:
            if type(other) is not type(value):
                with pytest.raises(sb.SymbalanceError):
                    raise AssertionError(f"{kind.__name__}: {kind(**{**ARGUMENTS[kind], name: other})!r}")


def test_every_class_that_users_construct_is_among_them():
    """Results come from functions; what else is not here is made by its own functions or is an error."""
    by_functions = {
        *(
            "After",
            "Condition",
            "Counts",
            "Magnitude",
            "SearchPoint",
            "SearchProblem",
            "SearchStar",
            "Seat",
        ),
        "Amplitude",
        "Angle",
        "AttachedBody",
        "ChannelRange",
        "Claim",
        "BankAngle",
        "ComparedEngine",
        "Comparison",
        "Complex",
        "Component",
        "Device",
        "Durability",
        "Evaluator",
        "Film",
        "FilmState",
        "Fluctuation",
        "GasGroup",
        "GasOrder",
        "Housing",
        "Kinematics",
        "Limits",
        "LinkRod",
        "MainBearings",
        "Member",
        "OperatingPoint",
        "Operation",
        "SweepPoint",
        "Tally",
        *("Codec", "Job", "JobOutcome", "LogProgress", "Progress", "Store"),  # of a program's own values
        "Orbit",
        "Order",
        "Overbalance",
        "Overlay",
        "Drawing",
        "Page",
        "Sheet",
        "Part",
        "PartSet",
        "PeriodicSystem",
        "Phasor",
        "PlaceDurability",
        "Real",
        "Resultant",
        "RodSplit",
        "Rotor",
        "RowOrder",
        "RunConfiguration",
        "RunningCylinder",
        "RunningEngine",
        "Sensitivity",
        "Segment",
        "SegmentRing",
        "Series",
        "Shaking",
        "SliderCrank",
        "Spectrum",
        "SpeedFigures",
        "SpeedOutcome",
        "Star",
        "Strength",
        "SymbolResultant",
        "SymbolSum",
        "SymbolicPhasor",
        "TangentialPressure",
        "TorqueOrder",
        "Trajectory",
        "TurnMaximum",
        "WebCompliance",
        "Weighting",
        "WorstCase",
    }
    for _, name, home in public_names():
        value = getattr(import_module(home), name)
        if inspect.isclass(value) and not issubclass(value, Result | Exception):
            assert value in ARGUMENTS or name in by_functions, name


@pytest.mark.slow
def test_what_a_public_class_holds_is_public_too():
    """The classes of the package that the fields of public dataclasses name are public in some room."""
    names = {name for _, name, _ in public_names()}
    trees = (ast.parse(path.read_bytes()) for path in MODULES)
    classes = {node.name for tree in trees for node in tree.body if isinstance(node, ast.ClassDef)}
    hidden = set()
    for room, name, home in public_names():
        value = getattr(import_module(home), name)
        if inspect.isclass(value) and is_dataclass(value):
            for field in fields(value):
                held = set(re.findall(r"\b[A-Z]\w+", str(field.type)))
                hidden |= {f"{room}.{name}.{field.name}: {kind}" for kind in held & classes - names}
    assert not hidden


@pytest.mark.slow
@pytest.mark.parametrize("name", EXAMPLES)
def test_a_pickled_result_says_the_same(name):
    result = example(name)
    again = pickle.loads(pickle.dumps(result))
    assert type(again) is type(result)
    assert sb.to_text(again) == sb.to_text(result)
    assert sb.to_json(again) == sb.to_json(result)
