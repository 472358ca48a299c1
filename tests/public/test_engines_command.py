"""Evidence: `symbalance engines` filters, sorts and lists presets as their files have them."""

from __future__ import annotations

import json
import re
import tomllib
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.engine.catalogue import preset_names, preset_text
from symbalance.engine.catalogue.preset_list import KINDS, LENGTHS, MASSES, UNITS, Preset, preset_from
from symbalance.engine.engine_file import parse_engine

LISTED = list(sb.presets())
BY_NAME = {preset.name: preset for preset in LISTED}
SIZED = 'name = "x"\ndescription = "d"\nsource = "s"\n[layout]\nfiring_order = [1, 3, 4, 2]\n'


def listed(capsys: pytest.CaptureFixture[str], *options: str) -> list[dict[str, Any]]:
    """Return the presets that a command line lists as JSON."""
    assert run(["engines", *options, "--format", "json"]) == 0
    return json.loads(capsys.readouterr().out)["presets"]


def preset_of(sizes: str, estimates: str = "") -> Preset:
    return preset_from("x", tomllib.loads(f"{SIZED}[crank_train]\n{sizes}\n[estimates]\n{estimates}\n"))


# --- what the list says of an engine is what the engine is ---


def test_cylinders_strokes_and_sizes_are_those_of_the_engines() -> None:
    for preset in LISTED:
        engine = sb.load(preset.name)
        assert (preset.cylinders, preset.strokes) == (len(engine.cylinders), engine.strokes)
        values = {**preset.lengths, **preset.masses}
        for key in (*LENGTHS, *MASSES):
            owner = engine if key in ("bore", "pitch") else engine.first.sizes
            own = getattr(owner, key)
            assert values.get(key) == own or (engine.first.link and key in ("rod", "stroke")), preset.name


@pytest.mark.parametrize(
    ("kind", "names"),
    [
        ("in-line", ("inline-1", "toyota-2jz", "man-9s50mc-c")),
        ("vee", ("v2-45", "vw-vr6", "ford-coyote", "innio-v16", "kharkiv-v2")),
        ("boxer", ("boxer-2", "porsche-9a1", "vw-1600")),
        ("W", ("napier-lion", "vw-w12", "bugatti-w16")),
        ("radial", ("radial-3", "r-1820", "r-1830")),
    ],
)
def test_kinds(kind: str, names: tuple[str, ...]) -> None:
    assert {BY_NAME[name].kind for name in names} == {kind}


def test_every_estimate_is_of_something_and_has_a_reason() -> None:
    """A reason is more than one word; what is taken as none need not stand in the file."""
    for preset in LISTED:
        for key, reason in preset.estimates.items():
            assert len(reason.split()) > 1 or reason == "assumed", (preset.name, key)
            assert key not in UNITS or key in {**preset.lengths, **preset.masses}, (preset.name, key)


def test_there_are_eighty_engines_and_more() -> None:
    assert len(LISTED) == len(preset_names()) >= 80
    assert sum(preset.sizes == "looked up" for preset in LISTED) >= 40
    assert sum(preset.weights == "looked up" for preset in LISTED) >= 10


@pytest.mark.parametrize(
    ("sizes", "estimates", "word"),
    [
        ("ratio = 4", "", "none"),
        ("stroke = 80\nrod = 140", "", "in part"),
        ("bore = 80\nstroke = 80\nrod = 140\npitch = 90", "", "looked up"),
        ("bore = 80\nstroke = 80\nrod = 140\npitch = 90", 'pitch = "a guess"', "estimated"),
        ("bore = 80\nstroke = 80\nrod = 140\npitch = 90", 'firing_order = "a guess"', "looked up"),
    ],
)
def test_how_well_sizes_are_known(sizes: str, estimates: str, word: str) -> None:
    assert preset_of(sizes, estimates).sizes == word


def test_a_single_cylinder_needs_no_pitch() -> None:
    sizes = {"bore": 80, "stroke": 80, "rod": 140}
    single = {"description": "d", "source": "s", "crank_train": sizes, "layout": {"firing_order": [1]}}
    assert preset_from("x", single).sizes == "looked up"
    assert preset_from("x", {**single, "layout": {"firing_order": [1, 2]}}).sizes == "in part"
    assert preset_from("x", {**single, "crank_train": {"bore": 80, "rod": 140}}).sizes == "in part"


@pytest.mark.parametrize(
    ("sizes", "estimates", "word"),
    [
        ("rotating_mass = 1", "", "none"),
        ("reciprocating_mass = 1", "", "looked up"),
        ("reciprocating_mass = 1", 'reciprocating_mass = "a guess"', "estimated"),
    ],
)
def test_how_well_masses_are_known(sizes: str, estimates: str, word: str) -> None:
    assert preset_of(sizes, estimates).weights == word


# --- filters and sorting, against the files ---


def test_filters_leave_what_they_say_and_all_of_it(capsys: pytest.CaptureFixture[str]) -> None:
    names = [row["name"] for row in listed(capsys, "--cylinders", "8", "--strokes", "4", "--kind", "vee")]
    assert names == [p.name for p in LISTED if (p.cylinders, p.strokes, p.kind) == (8, 4, "vee")]
    assert {"v8-90", "gm-ls3", "ford-voodoo"} <= set(names)


def test_the_two_strokes_are_those_that_say_so(capsys: pytest.CaptureFixture[str]) -> None:
    two = {name for name in preset_names() if "strokes = 2" in preset_text(name)}
    assert {row["name"] for row in listed(capsys, "--strokes", "2")} == two


def test_kinds_share_the_presets_out(capsys: pytest.CaptureFixture[str]) -> None:
    parts = [row["name"] for kind in KINDS for row in listed(capsys, "--kind", kind.upper())]
    assert sorted(parts) == sorted(preset_names())


def test_with_masses_and_sizes(capsys: pytest.CaptureFixture[str]) -> None:
    rows = listed(capsys, "--with", "masses", "--with", "sizes", "--sort", "bore")
    assert {row["name"] for row in rows} == {
        name
        for name in preset_names()
        if {"reciprocating_mass", *LENGTHS} - ({"pitch"} if BY_NAME[name].cylinders == 1 else set())
        <= set(tomllib.loads(preset_text(name)).get("crank_train", {}))
    }
    bores = [row["bore_mm"] for row in rows]
    assert bores == sorted(bores)
    assert len(bores) > 3


def test_what_lacks_the_key_comes_last(capsys: pytest.CaptureFixture[str]) -> None:
    bores = [row["bore_mm"] for row in listed(capsys, "--sort", "bore")]
    known = [bore for bore in bores if bore is not None]
    assert bores == sorted(known) + [None] * (len(bores) - len(known))
    assert known[-1] == 960


def test_a_row_is_what_the_file_says(capsys: pytest.CaptureFixture[str]) -> None:
    row = next(row for row in listed(capsys) if row["name"] == "ford-coyote")
    file = tomllib.loads(preset_text("ford-coyote"))
    assert [row[f"{key}_mm"] for key in LENGTHS] == [file["crank_train"][key] for key in LENGTHS]
    assert row["estimates"] == file["estimates"]
    assert (row["kind"], row["cylinders"], row["sizes"], row["masses"]) == (
        "vee",
        8,
        "looked up",
        "estimated",
    )


LENGTHS_OF_A_ROW = re.compile(r"(?:[\d.]+|–)")


def test_the_list_is_a_line_an_engine(capsys: pytest.CaptureFixture[str]) -> None:
    """At 100 columns; each line's numbers are the file's, rounded, a dash where it has none."""
    table = sb.to_text(sb.presets(), width=100).partition("─\n")[2].splitlines()
    assert [line.split()[0] for line in table] == list(preset_names())
    for line, preset in zip(table, LISTED, strict=True):
        values = [preset.lengths.get(key) for key in LENGTHS] + [preset.masses.get("reciprocating_mass")]
        places = (1, 1, 1, 1, 2)
        stated = [
            "–" if value is None else f"{float(value):.{digits}f}"
            for value, digits in zip(values, places, strict=True)
        ]
        before, sizes = line.removesuffix(preset.sizes), line.endswith(preset.sizes)
        assert sizes, line
        assert LENGTHS_OF_A_ROW.findall(before)[-5:] == stated, line
        assert preset.arrangement in line
    assert run(["engines"]) == 0
    assert max(map(len, capsys.readouterr().out.splitlines())) < 80


def test_the_list_counts_what_was_looked_up(capsys: pytest.CaptureFixture[str]) -> None:
    """From the rows of the whole list: at least 80 engines, of 40 all sizes, of 10 published masses."""
    rows = listed(capsys)
    sizes = sum(row["sizes"] == "looked up" for row in rows)
    masses = sum(row["masses"] == "looked up" for row in rows)
    assert len(rows) >= 80
    assert sizes >= 40
    assert masses >= 10
    assert run(["engines"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert f"{len(rows)} engines; sizes looked up of {sizes}, masses of {masses}. Bore" in text


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("inline-1", "single"),
        ("toyota-2jz", "in-line 6"),
        ("man-9s50mc-c", "2-stroke in-line 9"),
        ("vw-vr6-fsi", "V6 10.6°"),
        ("v6-120", "V6 120°"),
        ("vw-1600", "boxer 4"),
        ("bugatti-w16", "W16"),
        ("r-1830", "radial 14"),
    ],
)
def test_arrangements(name: str, words: str) -> None:
    assert BY_NAME[name].arrangement == words


def test_sources_and_estimates_come_in_full_only(capsys: pytest.CaptureFixture[str]) -> None:
    selection = ("engines", "--cylinders", "5", "--sort", "bore")
    assert run([*selection]) == 0
    short = capsys.readouterr().out
    assert run([*selection, "--full"]) == 0
    full = " ".join(capsys.readouterr().out.split())
    for preset in LISTED:
        if preset.cylinders == 5:
            words = [preset.description, preset.source, *preset.estimates.values()]
            assert all(" ".join(each.split()) in full for each in words), preset.name
            assert preset.source not in " ".join(short.split())


def test_a_selection_of_none_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["engines", "--cylinders", "7", "--strokes", "4", "--kind", "boxer"]) == 0
    assert "None is of this selection" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--kind", "flat"), "kind = flat: is not known; one of in-line, vee, boxer, W, radial"),
        (("--sort", "weight"), "sort = weight: is not known; one of name, cylinders, bore"),
        (("--with", "bores"), "with = bores: is not known; one of sizes, masses, estimates"),
        (("--strokes", "3"), "strokes = 3: is not known; one of 2, 4"),
        (("--cylinders", "0"), "cylinders = 0"),
        (("--cylinders", "many"), "--cylinders = many: must be a whole number"),
        (("--show", "v8-90", "--sort", "bore"), "--sort: plays no part in --show; leave it out"),
        (("--show", "v8-90", "--full"), "--full: plays no part in --show; leave it out"),
        (("--schema", "--with", "masses"), "--with: plays no part in --schema; leave it out"),
    ],
)
def test_refusals(options: tuple[str, ...], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["engines", *options]) == 2
    error = capsys.readouterr().err
    assert words in error
    assert error.count("\n") == 1


# --- an engine's bore ---


@pytest.mark.slow
def test_torque_takes_the_bore_of_the_engine_where_none_is_given(
    capsys: pytest.CaptureFixture[str],
) -> None:
    usual = ("torque", "ford-coyote", "--compression", "11", "--rpm", "6000", "--format", "json")
    assert run([*usual]) == 0
    own = json.loads(capsys.readouterr().out)
    assert run([*usual, "--bore", "92.2"]) == 0
    assert json.loads(capsys.readouterr().out) == own
    assert run([*usual, "--bore", "90"]) == 2
    assert "is given by the engine already" in capsys.readouterr().err


def test_a_bore_that_nobody_gives_is_asked_for(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["torque", "inline-4", "--compression", "11", "--rpm", "6000"]) == 2
    assert "--bore: is missing" in capsys.readouterr().err
    with pytest.raises(sb.SymbalanceError, match="bore: is needed, and the engine does not give it"):
        sb.running_torque(
            sb.load("inline-4"),
            sb.torque.ideal_cycle(10, heat=20),
            rpm=1,
            stroke=80,
            reciprocating_mass=1,
        )


def test_the_bore_survives_writing_and_balancing() -> None:
    engine = sb.load("ford-coyote")
    again = parse_engine(sb.engine.engine_text(engine), "x.toml")
    assert again.bore == engine.bore == engine.with_ratio(4).bore == engine.balanced_by().bore


def cylinders(*bores: str, train: str = "") -> str:
    rows = [f"[[cylinder]]\nnumber = {n}\nthrow = {180 * n}\n{bore}\n" for n, bore in enumerate(bores, 1)]
    return f"[crank_train]\nstroke = 80\nrod = 140\n{train}\n" + "\n".join(rows)


def test_cylinders_may_give_the_bore_which_is_one(tmp_path: Path) -> None:
    file = tmp_path / "twin.toml"
    both = ("bore = 81.5", "bore = 81.5")
    for text in (
        cylinders(*both),
        cylinders(*both, train="bore = 81.5"),
        cylinders("bore = 81.5", "", train="bore = 81.5"),
    ):
        file.write_text(text, encoding="utf-8")
        assert sb.load(file).bore == Fraction("81.5")
    file.write_text(cylinders("", ""), encoding="utf-8")
    assert sb.load(file).bore is None


@pytest.mark.parametrize(
    ("bores", "train", "said"),
    [
        (("bore = 81.5", "bore = 82"), "", "bore = 82: differs from 81.5 mm of another cylinder"),
        (("bore = 81.5", "bore = 81.5"), "bore = 90", ""),
        (("bore = 81.5", ""), "", "has no bore beside 81.5 mm of another cylinder"),
        (("", "bore = 82"), "", "has no bore beside"),
        (("bore = 81.5", ""), "bore = 80", "bore = 81.5: differs from"),
        (("bore = 0", "bore = 0"), "", "bore = 0: must"),
    ],
)
def test_bores_that_differ_are_refused_where_they_stand(
    bores: tuple[str, str], train: str, said: str, tmp_path: Path
) -> None:
    file = tmp_path / "twin.toml"
    file.write_text(cylinders(*bores, train=train), encoding="utf-8")
    if not said:  # a cylinder's own sizes override those that all share
        assert sb.load(file).bore == Fraction("81.5")
        return
    with pytest.raises(sb.SymbalanceError) as caught:
        sb.load(file)
    assert said in str(caught.value)
    assert "twin.toml" in str(caught.value)
