"""The presets with unlike cylinders against pistons placed by circles and lines: `unlike.toml`."""

from __future__ import annotations

import tomllib
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import symbalance as sb
from symbalance.engine.catalogue import preset_names
from symbalance.engine.dead_centres import firing_dead_centres
from tests import placed

ROWS: list[dict[str, Any]] = tomllib.loads(
    (Path(__file__).parent / "unlike.toml").read_text(encoding="utf-8")
)["row"]
every_row = pytest.mark.parametrize("row", ROWS, ids=[row["engine"] for row in ROWS])
HIGHEST = 12
NOTHING = 1e-12
NAMES = ("vertical", "lateral")


def test_every_unlike_preset_has_a_row_and_every_row_a_preset():
    unlike = [name for name in preset_names() if not sb.load(name).has_common_harmonics]
    assert sorted(row["engine"] for row in ROWS) == sorted(unlike)


@pytest.mark.spread(6)
@every_row
@pytest.mark.parametrize("kind", ["force", "couple"])
def test_amplitudes(row, kind):
    """The row, the program and the pistons agree, order by order, and on what is not there."""
    layout = sb.load(row["engine"])
    spectrum = getattr(sb.balance(layout, HIGHEST), kind)
    series = placed.planar_series(layout, kind == "couple")
    for n in range(1, HIGHEST + 1):
        stated = row[kind].get(str(n), [0, 0])
        for name, figure in zip(NAMES, stated, strict=True):
            cos, sin = (float(x) for x in spectrum.component(n, name).decimal(20))
            by_pistons = placed.component(series, n, name)
            assert np.allclose((cos, sin), by_pistons, rtol=0, atol=NOTHING), (n, name)
            amplitude = np.hypot(*by_pistons)
            assert (amplitude < NOTHING) == (cos == sin == 0), (n, name)
            if n <= 6:
                assert amplitude == pytest.approx(figure, rel=6e-5, abs=NOTHING)


@pytest.mark.spread(5)
@every_row
def test_strokes_and_dead_centres(row):
    layout = sb.load(row["engine"])
    found = {c.number: placed.stroke_and_top(layout, c) for c in layout.cylinders}
    strokes = [found[n][0] for n in sorted(found)]
    stated = row["strokes"] * (len(found) // len(row["strokes"]))
    assert strokes == pytest.approx(stated, abs=1e-4)
    tops = firing_dead_centres(layout)
    for number, at in tops.items():
        by_pistons = found[number][1] - found[1][1]
        assert abs((float(at) - by_pistons + 180) % 360 - 180) < 5e-6
    order = sorted(tops, key=tops.__getitem__)
    assert order == row["firing_order"]
    ends = [*(tops[n] for n in order[1:]), Fraction(180 * layout.strokes)]
    gaps = [float(end - tops[n]) for n, end in zip(order, ends, strict=True)]
    assert gaps == pytest.approx(row["intervals"], abs=6e-4)


def test_a_wrong_offset_would_show():
    """The pistons see a sign that the rows' amplitudes alone might forgive."""
    right, wrong = (
        sb.vr(15, "1-5-3-6-2-4", offset=e, stroke=90, rod=164, pin_step="1/2") for e in (12.5, -12.5)
    )
    force = sb.balance(right, 6).couple.component(1, "vertical").decimal(20)
    other = placed.component(placed.planar_series(wrong, True), 1, "vertical")
    assert abs(float(force[0]) - other[0]) > 0.01
