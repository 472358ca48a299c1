"""Evidence: sources. Nothing is cited unseen, presets say where each figure is from, the page has all."""

from __future__ import annotations

import re
from math import atan, degrees, pi, sqrt
from pathlib import Path

import numpy as np
import pytest

import symbalance as sb

ROOT = Path(sb.__file__).parents[1]
PAGE = (ROOT / "docs/sources.md").read_text(encoding="utf-8")
REMEMBERED = re.compile(r"from\s+mem" r"ory|is\s+remem" r"bered", re.IGNORECASE)
ADMISSION = re.compile(r"\b(assumed|estimates?|idealised|follows?)\b")
CITATION = re.compile(r"\bSources?(?: of the idea)?: [A-Za-z]")
"""A docstring that names its source."""
TEXTS = (".py", ".pyi", ".md", ".toml")


def texts_in(*folders):
    """Return every text that people read, of these folders."""
    return [
        path for folder in folders for path in sorted((ROOT / folder).rglob("*")) if path.suffix in TEXTS
    ]


def first_column(heading):
    """Return the first column of the table under a heading of the page."""
    table = PAGE.split(heading)[1].split("\n## ")[0]
    lines = [line for line in table.splitlines() if line.startswith("| ")][2:]
    return [line.strip("| ").split(" | ")[0] for line in lines]


SOURCES = first_column("## Figures of the preset engines")


def sources_in(clause):
    return [name for name in SOURCES if name in clause]


def test_nothing_is_cited_unseen():
    texts = texts_in("symbalance", "derivations", "docs", "tests")
    assert len(texts) > 300
    remembered = {path.name for path in texts if REMEMBERED.search(path.read_text(encoding="utf-8"))}
    assert not remembered


@pytest.mark.parametrize("preset", sb.presets(), ids=lambda preset: preset.name)
def test_each_clause_of_a_source_names_it_or_admits_that_there_is_none(preset):
    for clause in preset.source.split("; "):
        assert sources_in(clause) or ADMISSION.search(clause), clause


def test_the_page_names_no_source_that_no_preset_has():
    everything = " ".join(preset.source for preset in sb.presets())
    assert [name for name in SOURCES if name not in everything] == []


def test_the_page_has_every_module_that_names_a_source():
    citing = {
        ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
        for path in texts_in("symbalance")
        if path.suffix == ".py" and CITATION.search(path.read_text(encoding="utf-8"))
    }
    assert len(citing) > 10
    assert sorted(name for name in citing if f"`{name}`" not in PAGE) == []


def test_every_module_on_the_page_exists():
    places = {
        name: ROOT.joinpath(*name.split(".")) for name in re.findall(r"`(symbalance\.[a-z_.]+)`", PAGE)
    }
    assert len(places) > 20
    assert [n for n, p in places.items() if not (p.with_suffix(".py").exists() or p.is_dir())] == []


# Figures and formulas as they are published ----------------------------------------------------------


def test_strokes_follow_from_what_is_published():
    feet, inch = 0.3048, 25.4
    assert 88.3 * feet * 60 / (2 * 8700) * 1000 == pytest.approx(
        2 * float(sb.load("audi-v10").first.radius), abs=0.05
    )
    area = pi / 4 * (3.5 * inch) ** 2
    assert 1337e3 / 2 / area == pytest.approx(2 * float(sb.load("harley-1340").first.radius), rel=3e-3)


@pytest.mark.parametrize("eccentricity", [0.1, 0.5, 0.8, 0.95])
def test_a_short_bearing_carries_the_published_load_at_the_published_attitude(eccentricity):
    """W = mu omega R (L^3/c^2) e sqrt(16 e^2 + pi^2 (1 - e^2))/(4 (1 - e^2)^2)."""
    pytest.importorskip("scipy")
    from symbalance.crankshaft.bearings.short_film import Bearing, equilibrium

    bearing, omega, rest = Bearing(0.1, 0.03, 1e-4, 0.1), 100.0, 1 - eccentricity**2
    number = eccentricity * sqrt(16 * eccentricity**2 + pi**2 * rest) / (4 * rest**2)
    load_carried = number * 0.1 * omega * 0.05 * 0.03**3 / 1e-4**2
    place = equilibrium(bearing, [-load_carried, 0.0], omega)
    assert np.linalg.norm(place) / 1e-4 == pytest.approx(eccentricity, rel=1e-9)
    attitude = degrees(atan(pi * sqrt(rest) / (4 * eccentricity)))
    assert abs(degrees(np.arctan2(place[1], -place[0]))) == pytest.approx(attitude, rel=1e-9)
