"""Evidence: what is refused, and how.

Whatever is given to the core - wrong types, numbers beyond bounds, torn or mutated engine files -
either works or raises `SymbalanceError`, whose text is one line that names the place. Nothing else
escapes.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import hypothesis.strategies as st
import pytest
import sympy
from hypothesis import given, settings

import symbalance as sb
from symbalance.codegen import to_function
from symbalance.document.result import to_json, to_latex, to_text
from symbalance.document.symbols import symbol
from symbalance.engine.builders import boxer, from_cylinders, from_firing_order, inline, radial, vee, w
from symbalance.engine.crank_train import CrankTrain
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.engine.engine_file import parse_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import angle, degrees
from symbalance.forces.free_forces import balance
from symbalance.forces.inline_sums import dirichlet_quotient, inline_couple, inline_sum, spacing
from symbalance.kinematics.derivation import derive
from symbalance.kinematics.slider_crank import harmonics
from symbalance.kinematics.truncation import left_out
from symbalance.text.numbers import exact

X = sympy.Symbol("x")
PLACE = "some/engine.toml"


def assert_refused(make: Callable[[], Any], *names: str) -> None:
    with pytest.raises(SymbalanceError) as caught:
        make()
    assert_one_line(caught.value)
    for name in names:
        assert name in str(caught.value)


def assert_one_line(error: SymbalanceError) -> None:
    text = str(error)
    assert len(text.splitlines()) == 1, repr(text)
    assert len(text) < 600, len(text)
    assert ": " in text


# Numbers and angles -------------------------------------------------------------------------------


NO_NUMBERS = [
    None,
    True,
    "",
    " ",
    "nan",
    "inf",
    "1/0",
    "0/0",
    "1/2/3",
    "--1",
    "1_000",
    "0x10",
    "٣",
    "1,5",
    "1e999",
    "12 deg",
    "5" + " " * 300 + "junk",
    b"12",
    [],
    {},
    (1,),
    1j,
    float("nan"),
    float("inf"),
    1e300,
    object(),
    sympy.I,
    sympy.zoo,
    sympy.nan,
    sympy.oo,
    sympy.true,
    "1e99",
    "1e-99",
    10**40,
    10**5000,
]


@pytest.mark.parametrize("value", NO_NUMBERS, ids=lambda v: str(type(v).__name__))
def test_what_is_no_number_is_refused(value: object) -> None:
    assert_refused(lambda: exact(value, "throw"), "throw = ")
    assert_refused(lambda: degrees(value, "throw"), "throw = ")
    assert_refused(lambda: Cylinder(1, throw=value), "throw = ")
    assert_refused(lambda: Cylinder(1, station=value), "station = ")


NO_ANGLES = [
    X**2,
    sympy.I * X,
    sympy.sqrt(2),
    1.5 * X,
    X * sympy.pi,
    X + 30,
    sympy.E,
    sympy.cos(sympy.pi / 7) * X,
    sympy.Eq(X, 1),
    X < 1,
    sympy.Matrix([X]),
    sympy.Poly(X),
    sympy.Interval(0, X),
    sympy.Function("f")(X),
    17.33333333,
    "1/10007",
]


@pytest.mark.parametrize("value", NO_ANGLES, ids=str)
def test_what_is_no_angle_is_refused(value: object) -> None:
    assert_refused(lambda: angle(value, "bank"), "bank = ")


@pytest.mark.parametrize("value", [10**9 + 1, -1e10, 10**5000, "1e20", 400.12345], ids=brief)
def test_a_bank_is_taken_modulo_a_turn_but_bounded(value: object) -> None:
    assert_refused(lambda: Cylinder(1, bank=value), "bank = ")


@pytest.mark.parametrize("value", [0, -1, 1001, "1", 1.0, True, None, 10**5000], ids=brief)
def test_a_cylinder_has_a_number(value: object) -> None:
    assert_refused(lambda: Cylinder(value), "number = ")  # type: ignore[arg-type]


def test_angles_too_fine_together_are_refused_not_computed() -> None:
    fine = Engine([Cylinder(1), Cylinder(2, throw="1/9973"), Cylinder(3, throw="1/9967")])
    assert_refused(lambda: balance(fine), "of a turn")
    many = Engine(Cylinder(i, throw=Fraction(1, 10_000 - i)) for i in range(1, 400))
    assert_refused(lambda: balance(many), "of a turn")
    with_symbol = Engine([*fine.cylinders, Cylinder(4, bank=X)])
    assert_refused(lambda: balance(with_symbol), "of a turn")


# Layouts and builders -----------------------------------------------------------------------------


TWIN = [Cylinder(1), Cylinder(2)]

REFUSED: dict[str, Callable[[], Any]] = {
    "no cylinder": lambda: Engine([]),
    "no list": lambda: Engine(None),  # type: ignore[arg-type]
    "numbers for cylinders": lambda: Engine([1]),  # type: ignore[list-item]
    "text for cylinders": lambda: Engine("abc"),  # type: ignore[arg-type]
    "twice the same number": lambda: Engine([Cylinder(1), Cylinder(1)]),
    "too many": lambda: radial(1001),
    "three strokes": lambda: Engine(TWIN, strokes=3),
    "strokes as text": lambda: Engine(TWIN, strokes="4"),  # type: ignore[arg-type]
    "a list of strokes": lambda: Engine(TWIN, strokes=[4]),  # type: ignore[arg-type]
    "too short a rod": lambda: from_cylinders(TWIN, ratio=1),
    "no ratio": lambda: from_cylinders(TWIN, ratio="long"),
    "too short a rod, by its sizes": lambda: from_cylinders(
        TWIN, crank_train=CrankTrain(stroke=Fraction(10), rod=Fraction(1))
    ),
    "a number for an order": lambda: inline(5),  # type: ignore[arg-type]
    "an empty order": lambda: inline([]),
    "an empty text": lambda: inline(""),
    "an order with gaps": lambda: inline("1--2"),
    "an order that repeats": lambda: inline("1-2-1"),
    "an order without cylinder 1": lambda: inline("2-3"),
    "negative cylinders": lambda: inline([1, -2]),
    "order and throws": lambda: inline("1-2", throws=[0, 180]),
    "neither order nor throws": inline,
    "no throws": lambda: inline(throws=[]),
    "a number for throws": lambda: inline(throws=5),  # type: ignore[arg-type]
    "no pins": lambda: vee(60, pins=[]),
    "a pin that is no angle": lambda: inline(throws=[0, None]),
    "too few intervals": lambda: inline("1-2", firing_intervals=[720]),
    "intervals of another cycle": lambda: inline("1-2", firing_intervals=[180, 180]),
    "negative intervals": lambda: inline("1-2", firing_intervals=[-90, 810]),
    "a number for intervals": lambda: inline("1-2", firing_intervals=5),
    "a bank angle past 180": lambda: vee(200, "1-2"),
    "a negative bank angle": lambda: vee(-60, "1-2"),
    "a number for staggers": lambda: vee(60, "1-2", stagger=5),  # type: ignore[arg-type]
    "three staggers": lambda: boxer("1-2", stagger=[0, 0, 0]),
    "flat lists of cylinders": lambda: vee(60, "1-2", cylinders=[1, 2]),  # type: ignore[list-item]
    "a number for cylinders": lambda: vee(60, "1-2", cylinders=5),  # type: ignore[arg-type]
    "cylinders missed by the order": lambda: vee(60, "1-2", cylinders=[[1], [2, 3]]),
    "no bank": lambda: from_firing_order("1-2", banks=[], cylinders=[]),
    "a number for banks": lambda: from_firing_order("1-2", banks=5),  # type: ignore[arg-type]
    "banks without cylinders": lambda: from_firing_order("1-2", banks=[0, 90]),
    "no banks at all": lambda: w(None, "1-2", cylinders=[[1, 2]]),  # type: ignore[arg-type]
    "half a radial": lambda: radial(2.5),  # type: ignore[arg-type]
    "the balance of a name": lambda: balance("v8"),  # type: ignore[arg-type]
    "order 0": lambda: balance(inline("1-2"), 0),
    "order 1001": lambda: balance(inline("1-2"), 1001),
    "half an order": lambda: balance(inline("1-2"), 1.5),  # type: ignore[arg-type]
    "ratio 0": lambda: balance(inline("1-2"), ratio=0),
    "too small a power": lambda: balance(inline("1-2"), power=0),
    "no power": lambda: balance(inline("1-2"), power="3"),  # type: ignore[arg-type]
    "a plane beyond bounds": lambda: balance(inline("1-2"), reference="here"),
    "an unknown quantity": lambda: harmonics("jerk", 4),
    "harmonics of no order": lambda: harmonics("force", 0),
    "a bound of no order": lambda: left_out(0, Fraction(4)),
    "no name": lambda: Engine(TWIN, name=""),
    "a name of spaces": lambda: Engine(TWIN, name="  "),
    "neither order nor pins": lambda: vee(90),
    "pins that are text": lambda: vee(90, pins="0-90"),
    "pins and lists of pins": lambda: vee(90, pins=[0, [90]]),
    "pins of one bank": lambda: vee(90, pins=[[0, 90]]),
    "a pin too many": lambda: inline("1-2", throws=[0, 90, 180]),
    "one distance for all": lambda: inline("1-2-3", pitch=108),
    "a distance too few": lambda: inline("1-2-3", pitch=[1]),
    "an unknown unit of stations": lambda: inline("1-2", station_unit="inch"),
    "a list for a unit of stations": lambda: inline("1-2", station_unit=["mm"]),
    "stations of mm without a pitch": lambda: inline("1-2", stations=[0, -90], station_unit="mm"),
    "an order and symbolic axes": lambda: vee(X, "1-2", pins=[0]),
    "an empty bank": lambda: vee(60, "1-2", cylinders=[[1, 2], []]),
    "fine intervals": lambda: inline("1-2", firing_intervals=["17.3333333", "702.6666667"]),
    "a fine firing angle": lambda: Cylinder(1, fires=17.3333333),
    "firing where the throw does not allow it": lambda: Engine(
        [Cylinder(1, fires=0), Cylinder(2, throw=180, fires=90)]
    ),
    "a number for a crank train": lambda: from_cylinders(TWIN, crank_train=3),  # type: ignore[arg-type]
    "the text of a number": lambda: to_text(3),  # type: ignore[arg-type]
    "the document of a number": lambda: to_json(3),  # type: ignore[arg-type]
    "the LaTeX of a number": lambda: to_latex(3),
    "the function of a number": lambda: to_function(3),  # type: ignore[arg-type]
    "a number for outputs": lambda: to_function(
        balance(inline("1-2"), ratio=4),
        outputs=5,  # type: ignore[arg-type]
    ),
    "a list for a convention": lambda: derive(convention=[1]),  # type: ignore[arg-type]
    "a list for a quantity": lambda: derive([1]),  # type: ignore[arg-type]
    "an unknown symbol": lambda: symbol("zz"),
    "a list for a symbol": lambda: symbol((1,)),  # type: ignore[arg-type]
    "fewer cylinders than none": lambda: inline_sum(-2, 1),
    "no cylinders in a couple": lambda: inline_couple(0, 1),
    "no cylinders in a sum": lambda: inline_sum(0, 1),
    "half a cylinder": lambda: inline_sum(sympy.Rational(1, 2), 1),
    "text for a count": lambda: dirichlet_quotient("abc", 1, sympy.pi),  # type: ignore[arg-type]
    "text for an order": lambda: inline_sum(4, "__import__('os')"),  # type: ignore[arg-type]
    "text for a spacing": lambda: dirichlet_quotient(4, 1, "h"),  # type: ignore[arg-type]
    "an endless order": lambda: inline_couple(4, sympy.oo),
    "an imaginary order": lambda: inline_couple(4, sympy.I),
    "no interval between no cylinders": lambda: spacing(0),
}


@pytest.mark.parametrize("name", REFUSED)
def test_engines_that_cannot_be(name: str) -> None:
    assert_refused(REFUSED[name])


def test_text_taken_for_a_number_is_quoted() -> None:
    assert_refused(lambda: Engine(TWIN, strokes="4"), "strokes = '4'")  # type: ignore[arg-type]
    assert_refused(lambda: Cylinder("1"), "number = '1'")  # type: ignore[arg-type]


@pytest.mark.parametrize("start", [0, 30, "360/7"])
def test_firing_angles_that_agree_are_taken(start: object) -> None:
    """Throws are angles at theta = 0, wherever cylinder 1 fires; `fires` keeps the half-turn."""
    first = exact(start, "start")
    for half in (0, 360):
        layout = Engine([Cylinder(1, first, fires=0), Cylinder(2, first - 90, 60, fires=150 + half)])
        assert layout.firing_order() == [1, 2]
    for rotated in (vee(X, "1-3-2-4"), radial(5), boxer("1-4-3-2")):
        assert Engine(rotated.cylinders).firing_order() == rotated.firing_order()


def test_names_with_line_breaks_do_not_break_the_line() -> None:
    assert_refused(lambda: vee("1\n2", "1-2"))
    assert_refused(lambda: exact("a\r\nb\u2028c\x85d\x0be", "throw"))


# Engine files -------------------------------------------------------------------------------------


LAYOUT_FILE = """\
name = "example"
[crank_train]
stroke = 73.3
rod = 147.15
pitch = 108.0
reciprocating_mass = 0.673
[layout]
strokes = 4
banks = [-30, 30]
cylinders = [[1, 3, 5], [2, 4, 6]]
firing_order = [1, 2, 3, 4, 5, 6]
firing_intervals = [120, 120, 120, 120, 120, 120]
stagger = [0, "1/4"]
"""
CYLINDER_FILE = """\
strokes = 2
[crank_train]
ratio = "7/2"
[[cylinder]]
number = 1
throw = "360/7"
station = "5/2"
fires = 0
[[cylinder]]
number = 2
throw = 13.5
bank = -45
"""
LISTS_FILE = """\
[crank_train]
pitch = 100
[layout]
banks = [45, -45]
cylinders = [[1, 3, 5], [2, 4, 6]]
firing_order = [1, 6, 5, 4, 3, 2]
pins = [45, -75, 165]
splay = [0, 30]
stagger = [10, -10]
stations = [0, -100, "-225.5"]
station_unit = "mm"
"""
FILES = (LAYOUT_FILE, CYLINDER_FILE, LISTS_FILE)


@pytest.mark.parametrize("text", FILES)
def test_the_files_that_are_mutated_below_are_sound(text: str) -> None:
    assert balance(parse_engine(text, PLACE)).orders


VALUES = [
    "[]",
    "{}",
    "[[]]",
    "[1]",
    '""',
    '"a\\nb"',
    '"a\\u2028b"',
    '"\\u001b[31m"',
    "true",
    "nan",
    "-inf",
    "1e999",
    "1979-05-27",
    "07:32:00",
    "-1",
    "0",
    "1.5",
    "99999999999999999999",
    "0x10",
    '"1/0"',
    '"360/7"',
    "[[1], 2]",
    "{a = 1}",
    '"""\n[layout]\n"""',
    "''",
    "1e-30",
    "[[1, 2], [3]]",
    "[nan]",
    "[true]",
    '["x"]',
    "[{}]",
]
KEYS = [
    "name",
    "strokes",
    "stroke",
    "rod",
    "ratio",
    "offset",
    "banks",
    "cylinders",
    "firing_order",
    "stagger",
    "stations",
    "pitch",
    "station_unit",
    "pins",
    "splay",
    "firing_intervals",
    "number",
    "throw",
    "bank",
    "station",
    "fires",
    "master",
    "crank_train",
    "layout",
    "cylinder",
    '"a\\nb"',
    '"a\\u2028b"',
    '"a\\rb"',
    "layout.x",
    "crank_train.rod",
    "x" * 900,
    '""',
]
PIECES = [
    "[",
    "]",
    "=",
    '"',
    "'",
    "#",
    ",",
    "\n",
    "\r",
    "\x00",
    "\u2028",
    "{",
    "}",
    ".",
    "\\",
    "\t",
    "9" * 5000,
]


@st.composite
def mutated(draw: st.DrawFn) -> str:
    """Return a sound file with a few of its lines changed, swapped, doubled, torn or lost."""
    lines = draw(st.sampled_from(FILES)).splitlines()
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(lines) - 1)) if lines else 0
        line = lines[at] if lines else ""
        kind = draw(st.sampled_from(["value", "key", "new", "lose", "swap", "double", "insert", "tear"]))
        match kind:
            case "value":
                lines[at : at + 1] = [f"{line.split('=')[0]}= {draw(st.sampled_from(VALUES))}"]
            case "key":
                lines[at : at + 1] = [f"{draw(st.sampled_from(KEYS))} = {line.partition('=')[2] or 1}"]
            case "new":
                lines[at:at] = [f"{draw(st.sampled_from(KEYS))} = {draw(st.sampled_from(VALUES))}"]
            case "lose":
                lines[at : at + 1] = []
            case "swap":
                lines[at : at + 1] = []
                lines.insert(draw(st.integers(0, len(lines))), line)
            case "double":
                lines[at:at] = [line]
            case "insert":
                column = draw(st.integers(0, len(line)))
                piece = draw(st.one_of(st.sampled_from(PIECES), st.text(max_size=3)))
                lines[at : at + 1] = [line[:column] + piece + line[column:]]
            case "tear":
                lines[at : at + 1] = [line[: draw(st.integers(0, len(line)))]]
    return "\n".join(lines)


def read(text: str) -> None:
    refused = None
    try:
        layout = parse_engine(text, PLACE)
    except SymbalanceError as error:
        refused = error
    else:
        assert layout.cylinders
    if refused is not None:
        assert_one_line(refused)
        assert str(refused).startswith(PLACE)


@pytest.mark.slow
@settings(deadline=None, max_examples=600, derandomize=True, database=None)
@given(mutated())
def test_mutated_engine_files_are_read_or_refused(text: str) -> None:
    read(text)


@pytest.mark.slow
@settings(deadline=None, max_examples=200, derandomize=True, database=None)
@given(st.one_of(st.text(max_size=60), st.text(alphabet="[]{}=\"'.,#\\\n 1ae-", max_size=40)))
def test_any_text_is_read_or_refused(text: str) -> None:
    read(text)


@settings(deadline=None, max_examples=150, derandomize=True, database=None)
@given(
    st.sampled_from(KEYS),
    st.sampled_from(VALUES),
    st.sampled_from(["", "layout", "crank_train", "cylinder"]),
)
def test_any_value_of_any_key_is_read_or_refused(key: str, value: str, section: str) -> None:
    for text in FILES:
        heads = {"": None, "cylinder": "[[cylinder]]"}.get(section, f"[{section}]")
        kept = [line for line in text.splitlines() if not line.startswith(f"{key} =")]
        at = 0 if heads is None else kept.index(heads) + 1 if heads in kept else len(kept)
        read("\n".join([*kept[:at], f"{key} = {value}", *kept[at:]]))


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    "text",
    [
        "a" * 900_000,
        "[" * 100_000,
        "a = " + "[" * 5000,
        "a = " + "{b = " * 3000,
        ".".join(["a"] * 5000) + " = 1",
        "x = " + "9" * 100_000,
        "[layout]\nfiring_order = [" + ", ".join(map(str, range(1, 3000))) + "]",
        "[[cylinder]]\nnumber = 1\nthrow = 0\n" * 1500,
        "cylinder = []",
        "layout = 1",
        "[[layout]]\nfiring_order = [1]",
        "cylinder = [1, 2]",
        "crank_train = []\n[layout]\nfiring_order = [1]",
        "",
    ],
    ids=lambda text: text[:12].replace("\n", " "),
)
def test_files_beyond_bounds_are_refused(text: str) -> None:
    assert_refused(lambda: parse_engine(text, PLACE), PLACE)


LINES = [
    (LAYOUT_FILE.replace("rod = 147.15", "rod = 10"), 4),
    (LAYOUT_FILE.replace("stroke = 73.3", "stroke = -1"), 3),
    (LAYOUT_FILE.replace("strokes = 4", "strokes = 3"), 8),
    (LAYOUT_FILE.replace("[-30, 30]", "[-30, 1e10]"), 9),
    (LAYOUT_FILE.replace("5, 6]\n", "5, 5]\n"), 11),
    (LAYOUT_FILE.replace("stagger", "staggers"), 13),
    (CYLINDER_FILE.replace("13.5", '"x"'), 11),
    (CYLINDER_FILE.replace("-45", "-4500000000"), 12),
    (CYLINDER_FILE.replace("fires = 0", "fires = 720"), 8),
    ("# \u2028 in a comment\n" + CYLINDER_FILE.replace("13.5", '"x"'), 12),
]


@pytest.mark.parametrize(("text", "line"), LINES, ids=lambda v: v if isinstance(v, int) else "")
def test_a_refusal_names_the_line(text: str, line: int) -> None:
    assert_refused(lambda: parse_engine(text, PLACE), f"{PLACE}:{line}:")


@pytest.mark.parametrize("name", ["two\nlines", "bell\a", "x" * 100])
def test_names_that_would_break_a_table_are_refused(name: str) -> None:
    with pytest.raises(SymbalanceError, match="one line"):
        Engine([Cylinder(1)], name=name)


ROTOR = sb.crankshaft.rotor.shaft([sb.crankshaft.rotor.Tube(1.0, 0.05)], bearings=(0.0, 1.0))
SPRINGS = [sb.crankshaft.rotor.Support(1e8)] * 2


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: sb.kinematics.dead_centres(sb.load("inline-4")), "mechanism = .*must be a SliderCrank"),
        (lambda: sb.kinematics.force_harmonics(None, 4), "mechanism = None: must be a SliderCrank"),
        (lambda: sb.torque.firing_pin_passings(None), "engine = None: must be an Engine"),
        (lambda: sb.engine.engine_text(None), "engine = None: must be an Engine"),
        (lambda: sb.torque.flywheel_inertia(None, 1, 2), "energy = None: must be a number"),
        (lambda: sb.crankshaft.rotor.whirl(ROTOR, SPRINGS, "fast"), "speed = fast: must be a number"),
        (lambda: sb.crankshaft.rotor.critical_speeds(ROTOR, SPRINGS, "x"), "most = x: must be a number"),
        (
            lambda: sb.crankshaft.rotor.unbalance_response(ROTOR, SPRINGS, [100], [1.0]),
            "unbalances = .*must map places to amounts",
        ),
    ],
)
def test_what_public_functions_cannot_take_is_refused_at_their_door(call, words):
    with pytest.raises(sb.SymbalanceError, match=words):
        call()
