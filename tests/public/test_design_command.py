"""`symbalance design`, the tables of an engine file it writes, and what they refuse."""

from __future__ import annotations

import cmath
import csv
import io
import json
import math
from fractions import Fraction
from itertools import product

import pytest
import sympy

import symbalance as sb
from symbalance.cli import run
from symbalance.engine.crank_train import CrankTrain
from tests.different_presets import different_presets
from tests.independent import test_unlike

SIZES = CrankTrain(
    stroke=Fraction(86),
    rod=Fraction(143),
    reciprocating_mass=Fraction(1, 2),
    rotating_mass=Fraction(3, 5),
)
FOUR = """
[crank_train]
stroke = 86.0
rod = 143.0
reciprocating_mass = 0.5

[layout]
firing_order = [1, 3, 4, 2]
"""


def output(capsys, *arguments: str) -> str:
    assert run(list(arguments)) == 0
    return capsys.readouterr().out


def refused(capsys, *arguments: str) -> str:
    assert run(list(arguments)) == 2
    said = capsys.readouterr()
    assert not said.out
    assert said.err.count("\n") == 1
    return said.err


# What it prints -------------------------------------------------------------------------------------


def test_text_names_the_weights_the_certificate_and_what_remains(capsys, golden):
    text = output(capsys, "design", "v8-90", "--full")
    assert text.startswith("v8-90: orders 1, 2 are balanced exactly\n")
    assert "With counterweights on the crank; no shaft is needed." in text
    assert "√10/3" in text
    assert "≈ −116.57°" in text
    assert "1  couple  proved 0" in text
    remains, before = text.partition("What remains")[2].split("Before: v8-90 unchanged")
    assert "4√2" in remains
    assert "√10" in before
    assert max(map(len, text.splitlines())) < 80


def test_the_answer_takes_a_dozen_lines_and_the_rest_is_asked_for(capsys):
    text = output(capsys, "design", "v8-90")
    full = output(capsys, "design", "v8-90", "--full")
    assert len([line for line in text.splitlines() if line.strip()]) <= 15 < len(full.splitlines()) / 3
    assert "√10/3" in text
    assert "free force of order 4, 8, 12; no free couple" in " ".join(text.split())
    data = json.loads(output(capsys, "design", "v8-90", "--format", "json"))
    assert data == json.loads(output(capsys, "design", "v8-90", "--format", "json", "--full"))


def test_an_answer_that_falls_short_shows_its_certificate(capsys):
    text = output(capsys, "design", "inline-4", "--shafts", "0")
    assert "2  force   unchanged       unchanged" in text


def test_segments_have_the_unbalance_they_are_cut_for():
    design = sb.design_balance(sb.load("vq30de"), [1, 2]).cut_from(60, 20, inner=20, density=7800)
    sizes = [design.unbalance(d, vector) for d in design.devices for _, vector in d.weights]
    assert len(design.segments) == len(sizes) == 4
    steps = 400
    for segment, size in zip(design.segments, sizes, strict=True):
        assert size is not None
        half = math.radians(float(segment.angle)) / 2
        moment = mass = 0.0  # a sum over small pieces of the sector, kg and kg mm
        for i in range(steps):
            radius = 20 + 40 * (i + 0.5) / steps
            piece = 7800e-9 * 20 * radius * (40 / steps)
            angles = [half * (2 * (j + 0.5) / steps - 1) for j in range(steps)]
            mass += piece * 2 * half
            moment += piece * radius * sum(map(math.cos, angles)) * 2 * half / steps
        assert math.isclose(moment, float(size), rel_tol=1e-4)
        assert math.isclose(mass, float(segment.mass), rel_tol=1e-4)
    rows = design.records()
    assert [row["segment_deg"] for row in rows] == [float(each.angle) for each in design.segments]
    assert [row["segment_kg"] for row in rows] == [float(each.mass) for each in design.segments]
    assert "segment_kg" not in sb.design_balance(sb.load("vq30de"), [1]).records()[0]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--segment", "20:60"], "write it like 20:60:18"),
        (["--segment", "60:20:18"], "leave no ring"),
        (["--segment", "0:0:18"], "outer = 0: must be positive"),
        (["--segment", "a:b:c"], "must be a number"),
        (["--density", "7000"], "add --segment"),
    ],
)
def test_segments_that_cannot_be_cut_are_refused(capsys, options, said):
    assert said in refused(capsys, "design", "vq30de", *options)


def test_a_weight_that_is_too_big_for_the_ring_is_named_and_the_rest_is_cut(capsys):
    """By hand: half a ring has 2/3 d t (R^3 - r^3); what is above needs so much more of thickness."""
    largest = 2 / 3 * 7850e-9 * 12 * (60**3 - 20**3)
    line = ("design", "vq30de", "--segment", "20:60:12", "--format")
    rows = list(csv.DictReader(io.StringIO(output(capsys, *line, "csv"))))
    too_big = [float(row["unbalance_kg_mm"]) > largest for row in rows]
    assert {True, False} == set(too_big)
    assert [row["segment_deg"] == "" for row in rows] == too_big
    weights = [w for d in json.loads(output(capsys, *line, "json"))["devices"] for w in d["weights"]]
    for weight, is_big in zip(weights, too_big, strict=True):
        assert ("thickness_needed" in weight["segment"]) == is_big
        if is_big:
            needed = float(weight["unbalance"]) / largest * 12
            assert math.isclose(float(weight["segment"]["thickness_needed"]), needed, rel_tol=1e-12)
    text = " ".join(output(capsys, *line, "text").split())
    numbers = ", ".join(str(n) for n, is_big in enumerate(too_big, 1) if is_big)
    assert f"of rows {numbers} are more than half of the ring has, 13.06 kg mm, and not cut" in text
    most = max(float(weight["unbalance"]) for weight in weights)
    assert f"take {most / largest * 12:.4g} mm of thickness" in text


def test_segments_need_sizes(capsys):
    assert "has no kg mm" in refused(capsys, "design", "inline-4", "--segment", "20:60:18")


def test_nothing_to_do_is_said(capsys):
    assert "orders 1, 2: nothing to remove\n" in output(capsys, "design", "v12-60")


@pytest.mark.slow
def test_limits_are_kept_and_the_rest_is_told(capsys, golden):
    text = output(capsys, "design", "inline-1", "--remove", "1", "--no-counter-rotation", "--full")
    assert text.startswith("inline-1: order 1 reduced\n")
    said = "With counterweights on the crank; it takes 1 shaft to balance all exactly."
    assert said in " ".join(text.split())
    assert "circle, against the crank" in text
    text = output(capsys, "design", "inline-4", "--shafts", "1", "--vertical", "3")
    assert "changed" in text
    text = output(capsys, "design", "v2-45", "--remove", "1", "--per-throw", "--shafts", "0")
    assert "every throw" in text


@pytest.mark.slow
def test_json_is_exact_and_agrees_with_python(capsys):
    found = json.loads(output(capsys, "design", "inline-5", "--format", "json"))
    design = sb.design_balance(sb.load("inline-5"))
    assert found["complete"] is True
    assert found["least_shafts"] == len([d for d in found["devices"] if d["kind"] == "shaft"]) == 3
    verdicts = {(c["order"], c["kind"]): c["verdict"] for c in found["certificate"]}
    assert verdicts["+1", "couple"] == verdicts["-2", "couple"] == "removed"
    assert verdicts["+1", "force"] == "absent"
    share = found["devices"][0]["weights"][0]["share"]
    exact = design.devices[0].weights[0][1]
    assert sympy.simplify(sympy.sympify(share["cos"]) - sb.exact.Component(exact).cos) == 0
    assert [o["order"] for o in found["remains"]["orders"]] == ["4", "6", "8", "10", "12"]


def test_limits_stand_in_the_legend_and_in_json():
    """A limit that was not given is not printed; in JSON all stand."""
    four = sb.inline("1-3-4-2", crank_train=SIZES)
    plain = sb.design_balance(four)
    assert "limits" not in sb.to_text(plain)
    assert plain.data()["limits"]["shafts"] is None
    given = {"shafts": 1, "counter_rotation": False, "spread": "even", "stations": ["1/2", "-1/2"]}
    limited = sb.design_balance(four, **given, vertical=3, length=2, most="25/2")
    legend = " ".join(sb.to_text(limited).partition("How to read it")[2].split())
    for said in (
        "at most 1 shaft;",
        "no shaft against the crank",
        "weights at stations 1/2, −1/2",
        "a weight at every station",
        "at most 25/2 kg mm a weight",
        "squares of the vertical weigh 3, of the lateral 1",
        "couples count over 2 pitches",
    ):
        assert said in legend
    assert "no counterweights on the crank" not in legend
    limits = limited.data()["limits"]
    assert (limits["most"], limits["stations"]) == ("25/2", ["1/2", "-1/2"])
    assert (limits["counter_rotation"], limits["counterweights"]) == (False, True)


def test_nothing_built_in_is_not_said_to_reduce():
    bare = sb.design_balance(sb.load("inline-1"), [1], shafts=0, counterweights=False)
    assert bare.devices == ()
    assert "order 1 left unchanged" in sb.to_text(bare)
    assert "reduced" not in sb.to_text(bare)
    assert bare.records() == []


def test_records_name_every_weight_once():
    """Their sizes are those of SymPy's own evaluation; a throw's counterweight has no share."""
    design = sb.design_balance(sb.load("inline-5"))
    rows = design.records()
    assert len(rows) == sum(len(device.weights) for device in design.devices) == 8
    for row in rows:
        up, right = (float(sympy.sympify(row[f"exact_{name}"])) for name in ("up", "right"))
        assert row["share"] == pytest.approx(abs(complex(up, right)), rel=1e-12)
        rotated = math.radians(row["direction_deg"])
        assert complex(up, right) == pytest.approx(row["share"] * cmath.exp(1j * rotated), rel=1e-9)
    throws = sb.design_balance(sb.load("v2-45"), [1], shafts=0, per_throw=True).records()
    assert [(row["throw"], row["overbalance"], row["share"]) for row in throws] == [
        (1, 0.5, None),
        (2, 0.5, None),
    ]


@pytest.mark.slow
def test_latex_holds_together(capsys):
    page = output(capsys, "design", "inline-3", "--format", "latex", "--standalone")
    for part in ("Proposed weights", "Certificate", "What remains", "Before: inline-3 unchanged"):
        assert part in page
    for name in ("minipage", "tabular", "document"):
        assert page.count(rf"\begin{{{name}}}") == page.count(rf"\end{{{name}}}")
    assert page.count("{") == page.count("}")
    symbolic = sb.design_balance(sb.vee(sympy.Symbol("alpha"), pins=[0]), [1], shafts=0)
    assert r"\cos" in sb.to_latex(symbolic)


@pytest.mark.slow
def test_a_picture_is_drawn(capsys, tmp_path):
    pytest.importorskip("matplotlib")
    path = tmp_path / "left.png"
    output(capsys, "design", "v2-45", "--remove", "1", "--shafts", "0", "--picture", str(path))
    assert path.read_bytes()[:4] == b"\x89PNG"
    assert "must end in .png" in refused(capsys, "design", "v2-45", "--picture", "a.gif")


# The balanced engine as a file ------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", different_presets()[::4])  # the designs of all: test_balancing
def test_the_balanced_engine_goes_through_every_command(name, capsys, tmp_path):
    path = tmp_path / "smooth.toml"
    output(capsys, "design", name, "--write", str(path))
    found = json.loads(output(capsys, "balance", str(path), "--format", "json"))
    assert not {"1", "2"} & {order["order"] for order in found["orders"]}
    design = sb.design_balance(sb.load(name))
    again = sb.balance(sb.load(path))
    if design.engine.has_common_harmonics:
        for kind in ("force", "couple"):
            was, now = getattr(design.remains, kind).terms, getattr(again, kind).terms
            assert was.keys() == now.keys()
            assert all((was[n] - now[n]).is_zero() for n in was)


def test_the_balanced_engine_in_latex_torque_and_code(capsys, tmp_path):
    path = tmp_path / "smooth.toml"
    output(capsys, "design", "inline-3", "--write", str(path))
    assert "shaft at" in output(capsys, "balance", str(path), "--format", "latex")
    plain, smooth = (output(capsys, "torque", engine) for engine in ("inline-3", str(path)))
    answers = [text.partition("How to read it")[0].partition("\n")[2] for text in (plain, smooth)]
    assert answers[0] == answers[1] != ""
    assert "def " in output(capsys, "emit", str(path), "--target", "numpy")


@pytest.mark.slow
@pytest.mark.parametrize("name", test_unlike.ENGINES)
def test_unlike_engines_come_back_from_a_file(name, tmp_path):
    design = sb.design_balance(test_unlike.ENGINES[name](), [1, 2, 3])
    path = tmp_path / "smooth.toml"
    path.write_text(sb.engine.engine_text(design.balanced), encoding="utf-8")
    again = sb.load(path)
    assert again.cylinders == design.balanced.cylinders
    left = sb.balance(again, 6)
    assert not {1, 2, 3} & {o.order for o in left.orders}


def test_every_key_comes_back(tmp_path):
    layout = sb.inline("1-3-4-2", crank_train=SIZES, name='quoted "four"').balanced_by(
        sb.Counterweight(throw=2, overbalance="2/3", angle="7.5"),
        sb.Counterweight(35, "3/2", unbalance="12.25"),
        sb.Counterweight(web=3, share="1/7"),
        sb.BalanceShaft(
            -2,
            [sb.engine.Weight(1, 20, share=2), sb.engine.Weight(-1, 5, unbalance=3)],
            phase=9,
            x=-4,
            y=60,
        ),
    )
    path = tmp_path / "again.toml"
    path.write_text(sb.engine.engine_text(layout), encoding="utf-8")
    again = sb.load(path)
    assert again.balancers == layout.balancers
    assert (again.name, again.pitch, again.cylinders) == (layout.name, layout.pitch, layout.cylinders)
    path.write_text(sb.engine.engine_text(layout.with_ratio(4)), encoding="utf-8")
    assert sb.load(path).ratio == 4


def test_the_rods_own_inertia_comes_back(tmp_path):
    rod = {"rod_mass": Fraction(3, 5), "rod_centre": Fraction(40), "rod_inertia": Fraction(2000)}
    train = CrankTrain(**{**vars(SIZES), **rod})
    path = tmp_path / "rods.toml"
    four = sb.inline("1-3-4-2", crank_train=train)
    path.write_text(sb.engine.engine_text(four), encoding="utf-8")
    again = sb.load(path)
    assert (again.pitch, again.cylinders) == (train.pitch, four.cylinders)
    assert again.first.rod_split == train.rod_split


OWN_SIZES: list[dict[str, int]] = [
    {},
    {"stroke": 80},
    {"rod": 150},
    {"stroke": 80, "rod": 150},
    {"stroke": 90, "rod": 180},
]
TRAINS = [
    CrankTrain(stroke=stroke, rod=rod, given_ratio=ratio)
    for stroke, rod, ratio in product((None, Fraction(80)), (None, Fraction(150)), (None, Fraction(4)))
]


@pytest.mark.spread(2)
@pytest.mark.parametrize("ratio", [None, 3])
@pytest.mark.parametrize("train", TRAINS, ids=range(len(TRAINS)))
def test_a_ratio_beside_strokes_and_rods_comes_back_or_is_refused(train, ratio, tmp_path):
    """Sizes of two cylinders, each with a stroke, a rod, both or none, beside shared ones."""
    path, written = tmp_path / "again.toml", 0
    for first, second in product(OWN_SIZES, repeat=2):
        rows = [sb.Cylinder(1, **first), sb.Cylinder(2, 180, **second)]
        try:
            layout = sb.engine.from_cylinders(rows, crank_train=train)
            layout = layout if ratio is None else layout.with_ratio(ratio)
            pushes = [(group.mechanism, group.size) for group in layout.groups]
        except sb.SymbalanceError:  # no engine: its forces would be refused
            continue
        ratio_alone = any(c.sizes.given_ratio and not c.stroke for c in layout.cylinders)
        if ratio_alone and any(c.sizes.rod for c in layout.cylinders):
            with pytest.raises(sb.SymbalanceError, match="cannot stand in an engine file beside"):
                sb.engine.engine_text(layout)
            continue
        path.write_text(sb.engine.engine_text(layout), encoding="utf-8")
        again = sb.load(path)
        assert [(group.mechanism, group.size) for group in again.groups] == pushes, (first, second)
        written += 1
    assert written


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--write", "a.toml", "-o", "a.toml"), "--write a.toml: is named by --output too"),
        (("--picture", "a.png", "-o", "a.png"), "--picture a.png: is named by --output too"),
        (("--per-throw", "--no-counterweights"), "per_throw without counterweights"),
    ],
)
def test_what_contradicts_itself_is_refused(options, said, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run(["design", "inline-3", *options]) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_the_file_that_cannot_be_written_is_the_one_named(tmp_path, capsys):
    for option, ending in (("--write", "toml"), ("-o", "txt")):
        path = str(tmp_path / "no" / f"a.{ending}")
        assert run(["design", "inline-3", option, path]) == 2
        assert f"symbalance: file {path}: cannot be written" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize("ending", ["txt", "tex", "html", "md", "json"])
def test_a_report_and_the_engine_are_both_written_or_neither(ending, tmp_path, capsys):
    engine, report = tmp_path / "smooth.toml", tmp_path / f"report.{ending}"
    assert run(["design", "inline-3", "--write", str(engine), "-o", str(tmp_path / "no" / "a.txt")]) == 2
    assert run(["design", "inline-3", "--write", str(tmp_path / "no" / "a.toml"), "-o", str(report)]) == 2
    assert not list(tmp_path.iterdir())
    output(capsys, "design", "inline-3", "--full", "--write", str(engine), "-o", str(report))
    assert sb.load(engine).balancers
    design = sb.design_balance(sb.load("inline-3"))
    whole = {
        "txt": sb.to_text(design),
        "tex": sb.to_latex(design),
        "html": sb.to_html(design, standalone=True),
        "md": sb.to_markdown(design),
        "json": sb.to_json(design) + "\n",
    }
    assert report.read_text(encoding="utf-8") == whole[ending]


def test_symbols_are_refused_by_a_file():
    with pytest.raises(sb.SymbalanceError, match="cannot stand in an engine file"):
        sb.engine.engine_text(sb.vee(sympy.Symbol("alpha"), pins=[0]))


def test_rotating_masses_are_said_to_be_balanced_or_count(capsys, tmp_path):
    path = tmp_path / "four.toml"
    path.write_text(FOUR.replace("= 0.5", "= 0.5\nrotating_mass = 0.6"), encoding="utf-8")
    assert "rotating masses are taken as balanced, throw by throw" in output(capsys, "balance", str(path))
    path.write_text(path.read_text(encoding="utf-8") + "[[counterweight]]\nthrow = 1\noverbalance = 0\n")
    text = output(capsys, "balance", str(path), "--order", "1")
    assert "taken as balanced" not in text
    assert "6/5" in text  # the rotating mass of the other three: two against one


# What is refused --------------------------------------------------------------------------------------


BAD = [
    ("[[counterweight]]\nthrow = 9\nshare = 1", "throw = 9: names no cylinder", 2),
    ("[[counterweight]]\nthrow = 1\nwebb = 2\nshare = 1", "counterweight.webb: is an unknown key", 3),
    ("[[counterweight]]\nthrow = 1\nweb = 2\nshare = 1", "web = 2: stands on a throw's web", 3),
    ("[[counterweight]]\nweb = 9\nshare = 1", "web = 9: is beyond the last", 2),
    ("[[counterweight]]\nweb = 0\nshare = 1", "web = 0: must be a whole number", 2),
    ("[[counterweight]]\nangle = 3", "takes one of unbalance, share and overbalance", 1),
    ("[[counterweight]]\nshare = 1\nunbalance = 2", "takes one of unbalance, share and overbalance", 1),
    ("[[counterweight]]\noverbalance = 0.5", "overbalance = 0.5: is of the masses of one cylinder", 2),
    ("[[counterweight]]\nangle = 'x'\nshare = 1", "angle = x: must be a number", 2),
    ("[[counterweight]]\nangle = 17.3333333\nshare = 1", "an angle's denominator must be at most", 2),
    ("[counterweight]\nshare = 1", "must be [[counterweight]] tables", 1),
    ("[[balance_shaft]]\nshare = 1", "[[balance_shaft]]: needs speed; add speed = 2", 1),
    ("[[balance_shaft]]\nspeed = 0\nshare = 1", "speed = 0: must not be 0", 2),
    ("[[balance_shaft]]\nspeed = 1.5\nshare = 1", "speed = 1.5: must be a whole number", 2),
    ("[[balance_shaft]]\nspeed = 2000\nshare = 1", "speed = 2000: must be a whole number", 2),
    ("[[balance_shaft]]\nspeed = 3\nshare = 1", "share: is a multiple of A_3, which is 0", 3),
    ("[[balance_shaft]]\nspeed = 2", "takes either weights, or station and unbalance or share", 1),
    ("[[balance_shaft]]\nspeed = 2\nshare = 1\nunbalance = 2", "station and unbalance or share", 1),
    ("[[balance_shaft]]\nspeed = 2\nweights = 3", "weights = 3: must be a list of tables", 3),
    ("[[balance_shaft]]\nspeed = 2\nweights = []", "weights = []: must not be empty", 3),
    ("[[balance_shaft]]\nspeed = 2\nweights = [{sahre = 1}]", "sahre: is an unknown key", 3),
    ("[[balance_shaft]]\nspeed = 2\nweights = [{share = 'a'}]", "share = a: must be a number", 3),
    ("[[balance_shaft]]\nspeed = 2\nshare = 1\nx = 'wide'", "x = wide: must be a number", 4),
]


@pytest.mark.spread(2)
@pytest.mark.parametrize(("added", "said", "line"), BAD, ids=[said for _, said, _ in BAD])
def test_a_bad_table_is_refused_where_it_stands(added, said, line, tmp_path, capsys):
    path = tmp_path / "bad.toml"
    path.write_text(FOUR + added + "\n", encoding="utf-8")
    error = refused(capsys, "balance", str(path))
    assert said in error
    assert f"bad.toml:{FOUR.count(chr(10)) + line}:" in error


@pytest.mark.parametrize(
    ("without", "said"),
    [("stroke = 86.0\n", "unbalance: counts in units of m r"), ("reciprocating_mass = 0.5\n", "m r")],
)
def test_kg_mm_need_the_sizes(without, said, tmp_path, capsys):
    text = FOUR.replace(without, "")
    text = text if "stroke" in text else text.replace("rod = 143.0", "ratio = 4")
    path = tmp_path / "bare.toml"
    path.write_text(text + "[[balance_shaft]]\nspeed = 2\nunbalance = 3\n", encoding="utf-8")
    assert said in refused(capsys, "balance", str(path))


OPTIONS = [
    (["--remove", "x"], "--remove = x"),
    (["--remove", "0"], "remove = 0"),
    (["--remove", "1001"], "remove = 1001"),
    (["--remove", ","], "--remove ="),
    (["--shafts", "-1"], "shafts = -1"),
    (["--stations", "a,b"], "stations = a"),
    (["--vertical", "0", "--lateral", "0"], "must be weights"),
    (["--vertical", "-1"], "must be weights"),
    (["--length", "0"], "length = 0"),
    (["--most", "-3"], "most = -3"),
    (["--most", "3"], "most = 3: is in kg mm"),
    (["--ratio", "0.5"], "ratio"),
    (["--write", "smooth"], "must end in .toml"),
]


@pytest.mark.spread(2)
@pytest.mark.parametrize(("options", "said"), OPTIONS, ids=[" ".join(o) for o, _ in OPTIONS])
def test_a_bad_option_is_refused_in_one_line(options, said, capsys):
    assert said in refused(capsys, "design", "inline-1", *options)


def test_bad_python_is_refused():
    four = sb.load("inline-4")
    for make, said in (
        (lambda: sb.design_balance("inline-4"), "must be an Engine"),
        (lambda: sb.design_balance(four, []), "names no order"),
        (lambda: sb.design_balance(four, [1.5]), "must be a whole number"),
        (lambda: sb.design_balance(four, spread="wide"), "must be one of"),
        (lambda: sb.design_balance(four, stations=[]), "leave no place"),
        (lambda: sb.engine.Balancers((3,)) and four.balanced_by(3), "must be at most"),
        (lambda: sb.Engine(four.cylinders, balancers=3), "must be Balancers"),
        (lambda: sb.BalanceShaft(2, [3]), "must be Weight values"),
        (lambda: sb.design.best_overbalance(four), "leaves the force unchanged"),
        (lambda: sb.design.best_overbalance(four, objective="all"), "must be one of"),
        (lambda: sb.design.best_overbalance(four, kind="torque"), "must be force or couple"),
        (lambda: sb.design.ellipse(sb.balance(four), 1, "torque"), "must be force or couple"),
        (lambda: sb.design.throw_unbalance([(-1, 3)]), "must not be negative"),
        (lambda: sb.design.throw_unbalance([3]), "must be a list"),
        (
            lambda: sb.design.rotating_unbalance(
                [sb.engine.Weight(share=1), sb.engine.Weight(unbalance=1)]
            ),
            "in one unit",
        ),
    ):
        with pytest.raises(sb.SymbalanceError, match=said):
            make()


def test_zero_masses():
    train = CrankTrain(stroke=Fraction(80), rod=Fraction(140), reciprocating_mass=Fraction(0))
    layout = sb.inline("1", crank_train=train)
    assert sb.design_balance(layout).is_complete
    with pytest.raises(sb.SymbalanceError, match="counts in units of m r"):
        sb.balance(layout.balanced_by(sb.Counterweight(0, unbalance=1)))


def test_a_design_of_decimals_is_written_and_still_cancels(tmp_path, capsys):
    """Thirty digits of a weight are as good as the weight: what they leave is no order."""
    source = tmp_path / "seven.toml"
    source.write_text(
        "[crank_train]\nstroke = 88\nrod = 150\nreciprocating_mass = 0.5\nrotating_mass = 0.2\n"
        "offset = -6\n[layout]\nstrokes = 2\nfiring_order = [1, 6, 3, 4, 5, 2, 7]\n"
        "[[counterweight]]\nweb = 3\nshare = 1\n",
        encoding="utf-8",
    )
    target = tmp_path / "designed.toml"
    assert run(["design", str(source), "--remove", "1", "--write", str(target)]) == 0
    capsys.readouterr()
    assert [o.order for o in sb.balance(sb.load(str(target)), 2).orders] == [2]
