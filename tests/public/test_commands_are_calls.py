"""Every command prints what the call of its name returns, option by option; a power is kept through."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from math import comb
from pathlib import Path
from typing import Any

import pytest
import sympy

import symbalance as sb
from symbalance.cli import run
from symbalance.cli.crankshaft import _speeds as speeds_of
from symbalance.codegen import plan_for
from symbalance.codegen.targets import files
from symbalance.engine.engine_writing import engine_text
from symbalance.torque import ideal_cycle, torque_report
from tests.targets import Case

SIZED = """
name = "sized"
[crank_train]
stroke = 80
rod = 150
pitch = 95
reciprocating_mass = 0.55
[layout]
banks = [-45, 45]
cylinders = [[1, 3], [2, 4]]
firing_order = [1, 3, 4, 2]
[[counterweight]]
throw = 1
overbalance = 0.5
"""
PARTS = "name,piston,rod_reciprocating,rod_rotating\n" + "".join(
    f"p{k},{piston},{rod},{big}\n"
    for k, (piston, rod, big) in enumerate(
        [("0.500", "0.151", "0.402"), ("0.507", "0.149", "0.399"), ("0.503", "0.152", "0.405"),
         ("0.499", "0.147", "0.401")], 1
    )
)  # fmt: skip

Call = Callable[[Path], Any]


@cache
def sized(folder: Path) -> sb.Engine:
    return sb.load(folder / "sized.toml")


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    place = tmp_path_factory.mktemp("calls")
    (place / "sized.toml").write_text(SIZED, encoding="utf-8")
    (place / "parts.csv").write_text(PARTS, encoding="utf-8")
    return place


def worst(**tolerances: Any) -> Call:
    more = {k: tolerances.pop(k) for k in ("rpm", "of", "order", "ratio") if k in tolerances}
    order, ratio = more.pop("order", 4), more.pop("ratio", None)

    def call(folder: Path) -> Any:
        engine = sized(folder) if ratio is None else sized(folder).with_ratio(ratio)
        return sb.worst_cases(engine, sb.design.Tolerances(**tolerances), order, **more)

    return call


def assigned(ratio: object = None, paired: bool = False, **options: Any) -> Call:
    def call(folder: Path) -> Any:
        engine = sized(folder) if ratio is None else sized(folder).with_ratio(ratio)
        return sb.design.assign_parts(
            engine, sb.design.read_parts(folder / "parts.csv", paired=paired), **options
        )

    return call


def torque(order: int = 6, compression: Any = None, heat: Any = 18, **sizes: Any) -> Call:
    def call(folder: Path) -> Any:
        engine, running = sized(folder), None
        if compression is not None:
            gas = ideal_cycle(compression, heat=heat, strokes=4)
            running = sb.running_torque(engine, gas, order=order, **sizes)
        report = torque_report(engine, order, running=running)
        return report.at(rpm=sizes["rpm"]) if "rpm" in sizes else report

    return call


def designed(*remove: int, **limits: Any) -> Call:
    return lambda folder: sb.design_balance(sized(folder), remove or (1, 2), **limits)


OTTO = ("--compression", "9.5", "--bore", "78")
CALLS: list[tuple[str, Call]] = [
    ("balance", lambda f: sb.balance(sized(f), 12)),
    ("balance --order 3", lambda f: sb.balance(sized(f), 3)),
    ("balance --ratio 3.25 --order 4", lambda f: sb.balance(sized(f), 4, ratio="3.25")),
    ("balance --power 7 --order 4", lambda f: sb.balance(sized(f), 4, power=7)),
    ("torque", torque()),
    ("torque --order 2", torque(2)),
    ("torque --compression 9.5 --bore 78 --rpm 2500", torque(compression="9.5", bore="78", rpm="2500")),
    (
        "torque --compression 9.5 --bore 78 --rpm 2500 --heat 12 --delta 0.01 --order 3",
        torque(3, "9.5", "12", bore="78", rpm="2500", delta=Fraction(1, 100)),
    ),
    ("design", designed()),
    ("design --remove 2", designed(2)),
    ("design --shafts 1", designed(shafts=1)),
    ("design --no-counter-rotation", designed(counter_rotation=False)),
    ("design --no-counterweights", designed(counterweights=False)),
    ("design --stations=1,-1", designed(stations=["1", "-1"])),
    ("design --stations=1,0,-1 --spread even", designed(stations=["1", "0", "-1"], spread="even")),
    ("design --per-throw", designed(per_throw=True)),
    ("design --shafts 1 --vertical 3", designed(shafts=1, vertical="3")),
    ("design --shafts 1 --lateral 3", designed(shafts=1, lateral="3")),
    ("design --shafts 1 --length 2", designed(shafts=1, length="2")),
    ("design --most 4", designed(most="4")),
    ("design --ratio 3.5", designed(ratio="3.5")),
    *(
        (f"tolerances --{name} {value}", worst(**{name: value}))
        for name, value in {
            "mass": "0.004", "throw": "0.2", "bank": "0.1", "station": "0.5", "stroke": "0.1",
            "rod": "0.2", "offset": "0.3", "rotating": "2%",
        }.items()
    ),
    ("tolerances --mass 1% --of lateral,forward", worst(mass="1%", of=["lateral", "forward"])),
    ("tolerances --mass 1% --rpm 3000 --order 2", worst(mass="1%", rpm="3000", order=2)),
    ("tolerances --mass 1% --ratio 3.5", worst(mass="1%", ratio="3.5")),
    ("sensitivities", lambda f: sb.sensitivities(sized(f), 4)),
    ("sensitivities --order 2", lambda f: sb.sensitivities(sized(f), 2)),
    ("sensitivities --ratio 3.5", lambda f: sb.sensitivities(sized(f).with_ratio("3.5"), 4)),
    (
        "sensitivities --parameters mass,rod",
        lambda f: sb.sensitivities(sized(f), 4, parameters=["mass", "rod"]),
    ),
    ("assign --parts parts.csv", assigned()),
    ("assign --parts parts.csv --paired", assigned(paired=True)),
    ("assign --parts parts.csv --orders 1,2", assigned(orders=[1, 2])),
    ("assign --parts parts.csv --rpm 4000", assigned(rpm="4000")),
    ("assign --parts parts.csv --lever 60", assigned(lever="60")),
    ("assign --parts parts.csv --whole", assigned(whole=True)),
    ("assign --parts parts.csv --ratio 3.5 --orders 2", assigned("3.5", orders=[2])),
    *(
        (f"derive --quantity {quantity} --convention {convention} --order 3",
         lambda f, q=quantity, c=convention: sb.derive(q, 3, c))
        for quantity, convention in (("force", "r/l"), ("velocity", "l/r"), ("rod-angle", "l/s"))
    ),
    ("derive", lambda f: sb.derive("force", 6, "l/r")),
    ("engines", lambda f: sb.presets()),
]  # fmt: skip
FAST = (
    "balance --order 3",
    "balance --ratio 3.25 --order 4",
    "balance --power 7 --order 4",
    "torque --order 2",
    "design --remove 2",
    "tolerances --mass 1% --rpm 3000 --order 2",
    "sensitivities --order 2",
    "assign --parts parts.csv --paired",
    "derive --quantity velocity --convention l/r --order 3",
    "engines",
)


def argument_list(line: str, folder: Path) -> list[str]:
    command, *rest = line.split()
    named = [str(folder / word) if word == "parts.csv" else word for word in rest]
    engine = [] if command in ("derive", "engines") else [str(folder / "sized.toml")]
    return [command, *engine, *named]


@pytest.mark.spread(*FAST)
@pytest.mark.parametrize(("line", "call"), CALLS, ids=[line for line, _ in CALLS])
def test_a_command_is_the_call_with_these_arguments(line, call, folder, capsys):
    assert run([*argument_list(line, folder), "--format", "json"]) == 0
    assert capsys.readouterr().out == sb.to_json(call(folder)) + "\n"


@pytest.mark.slow
def test_options_make_a_difference(folder):
    """Or the law above would not see one that is passed over."""
    by_command: dict[str, list[str]] = {}
    for line, call in CALLS:
        by_command.setdefault(line.split()[0], []).append(sb.to_json(call(folder)))
    for command, results in by_command.items():
        assert len(set(results)) == len(results), command


@pytest.mark.parametrize(
    ("form", "ending", "write"),
    [
        ("text", ".txt", sb.to_text),
        ("latex", ".tex", sb.to_latex),
        ("html", ".htm", lambda result: sb.to_html(result, standalone=True)),
        ("markdown", ".md", sb.to_markdown),
        ("json", ".json", lambda result: sb.to_json(result) + "\n"),
    ],
)
def test_a_medium_is_asked_for_by_format_or_by_the_files_ending(form, ending, write, folder, capsys):
    expected = write(sb.balance(sized(folder), 2)).rstrip("\n")
    line = argument_list("balance --order 2", folder)
    assert run([*line, "--format", form]) == 0
    assert capsys.readouterr().out.rstrip("\n") == expected
    for name, more in ((f"out{ending}", []), (f"OUT{ending.upper()}", []), ("plain", ["--format", form])):
        assert run([*line, *more, "-o", str(folder / name)]) == 0
        assert (folder / name).read_text(encoding="utf-8").rstrip("\n") == expected
        assert capsys.readouterr().out == ""
    assert run([*line, "--format", form, "-o", "-"]) == 0
    assert capsys.readouterr().out.rstrip("\n") == expected
    refused = run([*line, "--format", form, "--standalone"])
    assert refused == (0 if form == "latex" else 2)
    out = capsys.readouterr()
    assert (r"\begin{document}" in out.out) == (form == "latex")
    assert out.err.count("\n") == (form != "latex")


@pytest.mark.parametrize(
    ("line", "outputs", "order", "tolerance"),
    [
        ("emit --target c", ("force.vertical",), None, 0.0),
        ("emit --target javascript --order 4", ("force.vertical",), 4, None),
        ("emit --target octave --tolerance 1e-3", ("force.vertical",), None, 1e-3),
        (
            "emit --target numpy --outputs couple.lateral,piston.velocity",
            ("couple.lateral", "piston.velocity"),
            None,
            0.0,
        ),
        ("emit --target numpy --ratio 3.5 --uniform-grid", ("force.vertical",), None, 0.0),
    ],
)
def test_what_is_emitted_is_the_plan_of_these_outputs(line, outputs, order, tolerance, folder):
    target = line.split()[2]
    path = folder / f"motion{ {'c': '.c', 'javascript': '.mjs', 'octave': '.m'}.get(target, '.py') }"
    assert run([*argument_list(line, folder), "-o", str(path)]) == 0
    engine = sized(folder).with_ratio("3.5") if "--ratio" in line else sized(folder)
    result = sb.balance(engine, order or 1)
    plan = plan_for(result, None, list(outputs), target, tolerance, order or 1)
    texts = files(plan, target, engine.name, "motion", grid="--uniform-grid" in line)
    for ending, text in texts.items():
        assert path.with_suffix(ending).read_text(encoding="utf-8") == text
    assert len(texts) == (2 if target == "c" else 1)


def test_the_cases_of_the_targets_are_asked_for_as_here():
    assert Case("x", "inline-4", ("force.vertical",), order=3).options("c")[:4] == [
        "emit", "inline-4", "--target", "c",
    ]  # fmt: skip


def test_what_a_design_writes_beside_itself(folder, capsys):
    path, design = folder / "balanced.toml", sb.design_balance(sized(folder), (1, 2))
    assert (
        run([*argument_list("design", folder), "--write", str(path), "-o", str(folder / "d.json")]) == 0
    )
    assert path.read_text(encoding="utf-8") == engine_text(design.balanced)
    assert (folder / "d.json").read_text(encoding="utf-8") == sb.to_json(design) + "\n"
    again, built = (sb.balance(engine, 4).data() for engine in (sb.load(path), design.balanced))
    assert again["orders"] == built["orders"]
    assert run([*argument_list("design", folder), "--write", str(folder / "balanced.txt")]) == 2
    assert "must end in .toml" in capsys.readouterr().err


# Powers of 1/lambda, by the binomial series of the rod's length


def coefficient(n: int, power: int) -> sympy.Expr:
    """Return A_n of cos p + sqrt(lam^2 - sin^2 p) through 1/lam^power: n^2 times its cosine, n even.

    sqrt(lam^2 - s^2) = sum of binomial(1/2, k) (-1)^k s^(2k) lam^(1-2k), and s^(2k) holds cos n p
    2 (-1)^(n/2) binomial(2k, k - n/2)/4^k times.
    """
    total = sympy.Integer(0)
    for k in range(n // 2, (power + 1) // 2 + 1):
        share = Fraction(2 * (-1) ** (n // 2) * comb(2 * k, k - n // 2), 4**k)
        term = sympy.binomial(sympy.Rational(1, 2), k) * (-1) ** k
        total += n**2 * term * sympy.Rational(share.numerator, share.denominator) / LAM ** (2 * k - 1)
    return total


LAM = sympy.Symbol("lam")


@pytest.mark.spread(5)
@pytest.mark.parametrize("power", range(3, 13))
def test_a_power_is_the_highest_that_is_kept(power, folder, capsys):
    import json

    order = min(6, power + 1)
    line = ["balance", "inline-4", "--order", str(order), "--power", str(power), "--format", "json"]
    assert run(line) == 0
    rows = json.loads(capsys.readouterr().out)["orders"]
    assert [int(row["order"]) for row in rows] == list(range(2, order + 1, 2))
    for row in rows:
        series = sympy.sympify(row["coefficient"]["series"])
        assert sympy.expand(series - coefficient(int(row["order"]), power)) == 0
        assert row["coefficient"]["through"] == power


@pytest.mark.parametrize(("order", "least"), [(2, 1), (4, 3), (6, 5), (8, 7)])
def test_the_least_power_is_that_of_the_highest_orders_first_term(order, least, capsys):
    line = ["balance", "inline-4", "--order", str(order), "--power"]
    assert run([*line, str(least)]) == 0
    capsys.readouterr()
    assert run([*line, str(least - 1)]) == 2
    assert f"is {least}" in capsys.readouterr().err


# Options of numbers and of speeds


@pytest.mark.parametrize(
    ("text", "speeds"),
    [
        ("2200", [2200]),
        ("1000,2200", [1000, 2200]),
        ("1000:4000:500", [1000, 1500, 2000, 2500, 3000, 3500, 4000]),
        ("1000:1900:400", [1000, 1400, 1800]),
        ("1500:1500:100", [1500]),
        ("999999,0.5", [999999, 0.5]),
    ],
)
def test_speeds_from_to_by_steps(text, speeds):
    assert speeds_of(text) == pytest.approx(speeds)


@pytest.mark.parametrize(
    "text",
    [
        "0",
        "-1",
        "1e6",
        "1000:2000",
        "2000:1000:100",
        "1000,2000:100",
        "1:2:3:4",
        "a",
        "1000:2000:0",
        "nan",
    ],
)
def test_speeds_that_are_none(text):
    with pytest.raises(sb.SymbalanceError, match="--rpm"):
        speeds_of(text)


@pytest.mark.parametrize(("key", "value"), [("stroke", 80), ("rod", 160)])
def test_a_ratio_beside_a_stroke_or_a_rod_alone_is_refused(key, value, tmp_path, capsys):
    """Which of them is meant is not known: each alone contradicts the ratio as both do."""
    path = tmp_path / "engine.toml"
    path.write_text(f"[crank_train]\nratio = 4\n{key} = {value}\n[layout]\nfiring_order = [1, 2]\n")
    assert run(["balance", str(path)]) == 2
    assert "is 2*rod/stroke already" in capsys.readouterr().err


def test_a_stroke_or_rod_of_a_cylinders_own_ends_the_shared_ratio():
    """λ = 2 rod/stroke of what is given, and not the ratio given for others."""
    shared = sb.engine.CrankTrain(stroke=Fraction(80), rod=Fraction(160))
    rows = [sb.Cylinder(1, 0, 0), sb.Cylinder(2, 90, 0, stroke=100), sb.Cylinder(3, 180, 0, rod=120)]
    engine = sb.engine.from_cylinders(rows, crank_train=shared)
    assert [c.ratio for c in engine.cylinders] == [4, Fraction(16, 5), 3]
    given = sb.engine.CrankTrain(given_ratio=Fraction(7, 2))
    assert given.overridden(sb.engine.CrankTrain(stroke=Fraction(80), rod=Fraction(160))).ratio == 4
    assert given.overridden(sb.engine.CrankTrain(offset=Fraction(3))).ratio == Fraction(7, 2)
    assert given.overridden(sb.engine.CrankTrain(stroke=Fraction(80))).ratio is None


def test_a_refusal_says_a_letter_as_it_was_typed(capsys):
    assert run(["balance", "inline-4", "--ratio", "λ"]) == 2
    assert "λ" in capsys.readouterr().err
