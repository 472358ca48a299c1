"""The atlas: a page of each engine, a table of the library's sizes, finished work not done twice."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.pages.atlas import atlas_entry, atlas_index

pytestmark = pytest.mark.slow
NAMES = ["inline-3", "v8-90", "honda-nt650"]


def test_a_row_holds_what_the_fast_functions_give() -> None:
    import numpy as np

    theta = np.linspace(0, 2 * np.pi, 64, endpoint=False)
    for name in ("vw-vr6", "v8-90"):
        engine = sb.load(name)
        row = atlas_entry(engine).row
        for of in ("force", "couple"):
            sizes = {}
            outputs = (f"{of}.vertical", f"{of}.lateral")
            values = sb.to_function(sb.balance(engine), outputs=outputs)(theta)
            for part in outputs:
                for n in range(1, 13):
                    size = 2 * abs(np.mean(values[part] * np.exp(-1j * n * theta)))
                    sizes[n] = max(size, sizes.get(n, 0.0))
            assert row[of][1] == pytest.approx(max(sizes.values()), rel=1e-9)
            key = "lowestForce" if of == "force" else "lowestCouple"
            assert row[key][1] == min(n for n, size in sizes.items() if size >= 1e-6)


def test_the_command_writes_a_site_that_fetches_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["atlas", *NAMES, "-o", str(tmp_path)]) == 0
    index = (tmp_path / "index.html").read_text(encoding="utf-8")
    links = dict.fromkeys(re.findall(r'href="([^"]+)"', index))
    assert [link for link in links if link != "#published"] == [f"{name}.html" for name in NAMES]
    assert "http" not in index.replace("http-equiv", "")
    assert all((tmp_path / f"{name}.html").is_file() for name in NAMES)
    before = (tmp_path / "v8-90.html").read_bytes()
    capsys.readouterr()
    assert run(["atlas", *NAMES, "-o", str(tmp_path)]) == 0
    assert "3 from before" in capsys.readouterr().err
    assert (tmp_path / "v8-90.html").read_bytes() == before


def test_an_engine_refused_stops_no_other_and_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["atlas", "inline-3", "no-such", "-o", str(tmp_path)]) == 2
    assert "no-such" in capsys.readouterr().err
    index = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "inline-3.html" in index
    assert "<h2>Not shown</h2>" in index
    assert "no-such" in index


@pytest.mark.parametrize("engines", [["-"], ["a/x.toml", "b/x.toml"], ["index.toml"]])
def test_pages_of_one_name_are_refused(engines: list[str], tmp_path: Path) -> None:
    assert run(["atlas", *engines, "-o", str(tmp_path / "site")]) == 2
    assert not (tmp_path / "site").exists()


def test_a_hostile_name_is_text_in_the_table() -> None:
    row = atlas_entry(sb.inline("1-3-2", ratio=4, name="<script>&\"'")).row
    index = atlas_index([('"><script>.html', row)], ["<b>"], 12)
    assert index.count("<script") == 1
    assert "<b>" not in index
