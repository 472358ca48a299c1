"""Typeset results: golden files that hold the source, and a compiler that accepts it."""

import re
import subprocess

import pytest
import sympy

import symbalance as sb
from symbalance.cli import run
from symbalance.document.formula import Decimal, Name, Upright, cos
from symbalance.document.latex_document import document_latex
from symbalance.document.latex_writer import formula_latex
from symbalance.document.mathml_writer import formula_mathml
from symbalance.document.nodes import Column, Document, Paragraph, Table
from symbalance.document.text_writer import formula_text
from symbalance.engine.catalogue import preset_text
from symbalance.kinematics.slider_crank import acceleration_series
from tests.different_presets import different_presets

SEVEN = sb.inline("1-3-5-7-6-4-2", name="seven_&_odd", ratio="7/2")
TWIN = sb.vee(sympy.Symbol("alpha"), pins=[0], name="twin", ratio=4)


@pytest.mark.parametrize(
    ("name", "layout", "order"),
    [
        ("balance-v12", sb.load("v12-60"), 12),
        ("balance-v6", sb.load("v6-60"), 6),
        ("balance-seven", SEVEN, 4),
        ("balance-twin", TWIN, 2),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_balance_is_as_it_was(golden, name, layout, order):
    result = sb.balance(layout, order=order)
    golden(f"{name}.tex", sb.to_latex(result))
    golden(f"{name}.txt", sb.to_text(result))


@pytest.mark.slow
@pytest.mark.parametrize("name", different_presets()[::4])  # all, by two engines: test_latex_documents
def test_presets_compile(compile_latex, name):
    compile_latex(sb.to_latex(sb.balance(sb.load(name)), standalone=True))


def w12(banks: list[float], order: str) -> sb.Engine:
    cylinders = [[1, 3, 5], [2, 4, 6], [7, 9, 11], [8, 10, 12]]
    return sb.w(banks, order, cylinders=cylinders, ratio=4)


EVEN = "1-7-5-11-3-9-6-12-2-8-4-10"
ODD = {"ratio": 4, "firing_intervals": [100, 170, 150, 140, 160]}
QUARTERS = ["0.25", "90.5", "181.75", "270.25", "45.5", "135.75", "225.25", "300.5"]


@pytest.mark.slow
@pytest.mark.parametrize(
    "layout",
    [
        w12([-43.5, -28.5, 28.5, 43.5], EVEN),
        sb.inline("1-2-4-5-3", **ODD),
        sb.inline("1-2-4-5-3", ratio=4, firing_intervals=["64.5", "211.5", "112.5", "151.5", 180]),
        sb.engine.from_firing_order(
            "1-6-5-10-2-7-3-8-4-9", banks=[-37.5, 37.5], cylinders=[[1, 2, 3, 4, 5], [6, 7, 8, 9, 10]]
        ),
        sb.inline(throws=QUARTERS, ratio=4),
    ],
    ids=["W12", "odd five", "odder five", "V10", "eight in quarter degrees"],
)
def test_exact_forms_stay_within_the_margins(compile_latex, layout):
    result = sb.balance(layout, order=24)
    compile_latex(sb.to_latex(result, standalone=True))
    assert max(map(len, sb.to_text(result).splitlines())) <= 79


@pytest.mark.slow
@pytest.mark.parametrize(
    ("layout", "arguments"),
    [
        (SEVEN, {"order": 60}),
        (SEVEN, {"order": 8, "power": 60}),
        (TWIN, {"order": 12}),
        (sb.load("v8-90"), {"order": 1000}),
        (sb.vee("45.25", pins=["17.333", "-360/7"], splay="1/3"), {"order": 6}),
        (sb.inline(throws=[0, 180], name="two ~ \\ $ # ^ { } ü 二"), {"order": 2}),
    ],
    ids=["order 60", "power 60", "symbols", "order 1000", "fine angles", "odd name"],
)
def test_long_and_odd_results_compile(compile_latex, layout, arguments):
    compile_latex(sb.to_latex(sb.balance(layout, **arguments), standalone=True))


def test_formulas_compile(compile_latex):
    five = sb.balance(sb.load("inline-5"), order=2)
    formulas = [
        sb.to_latex(five[1].couple.vertical),
        sb.to_latex(five[1].couple.vertical.amplitude),
        sb.to_latex(acceleration_series(6, 9)),
        sb.to_latex(sympy.atan2(-1, 3, evaluate=False)),
    ]
    assert formulas[1] == r"\sqrt{\frac{25 - 11 \sqrt{5}}{2}}"
    source = document_latex(Document("formulas", (Paragraph("here"),)), standalone=True)
    compile_latex(source.replace("here", "\n".join(rf"\[{formula}\]" for formula in formulas)))


def test_the_head_of_decimals_begins_where_its_column_does(compile_latex):
    """The head spans both halves of numbers parted at their points; measured on the page."""
    rows = (("a", Decimal("1.5"), Decimal("2.25")), ("b", Decimal("3.25"), Decimal("4.5")))
    columns = (Column("name"), Column("wide enough"), Column("too"))
    page = document_latex(Document("Heads", (Table("", columns, rows),)), standalone=True)
    pdf = compile_latex(page)
    boxes = subprocess.run(
        ["pdftotext", "-bbox", str(pdf), "-"], capture_output=True, text=True, check=True, timeout=60
    ).stdout
    left = {word: float(x) for x, word in re.findall(r'<word xMin="([\d.]+)".*?>(.*?)</word>', boxes)}
    assert left["wide"] == pytest.approx(left["3.25"], abs=2)
    assert left["too"] == pytest.approx(left["4.5"], abs=2)


def test_what_has_no_latex_says_so():
    with pytest.raises(sb.SymbalanceError, match="is no result that can be printed"):
        sb.to_latex(object())


def test_upright_words_stand_apart_from_what_is_beside_them():
    """`kg r` and `vertical C` would else be one word in LaTeX and MathML, where spaces do not count."""
    for product in (Upright("kg") * Name("r"), Name("r") * Upright("kg"), Upright("N") * Upright("m")):
        left, right = formula_text(product).split(" ")
        assert re.search(rf"{left}\}}? \\, (\\mathrm\{{)?{right}", formula_latex(product))
        assert re.search(
            rf"{left}</m\w+><mo>\u2062</mo><mspace [^>]+></mspace><m\w+>{right}", formula_mathml(product)
        )
    # A function's name has its own space in LaTeX.
    assert r"\," not in formula_latex(Upright("amplitude") * cos(Name("n")))


@pytest.mark.slow
@pytest.mark.parametrize("command", ["balance {}", "torque {}", "design {}", "tolerances {} --mass 1%%"])
def test_latex_loses_no_sign_of_an_engine_s_name(command, tmp_path, capsys, compile_latex):
    text = preset_text("inline-2")
    own = "".join(line for line in text.splitlines(True) if not line.startswith("name"))
    path = tmp_path / "own.toml"
    path.write_text('name = "λ−√度😀 µ½ é_"\n' + own, encoding="utf-8")
    assert (
        run([*command.replace("%%", "%").format(path).split(), "--format", "latex", "--standalone"]) == 0
    )
    printed = capsys.readouterr().out
    for sign in (r"\lambda", r"$\surd$", "度", "U+5EA6", "U+1F600", r"\mu", r"\frac12", "é"):
        assert sign in printed, sign
    assert "?" not in printed
    compile_latex(printed)
