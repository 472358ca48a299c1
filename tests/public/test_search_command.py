"""`symbalance search`: files of the named stars, refusals before the search, long work said first."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path
from urllib.parse import unquote

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.search import cranks_search

FIVE = ["search", "--cylinders", "5", "--minimize", "couple.1"]


@pytest.mark.slow
def test_points_of_the_front_open_as_engines_and_as_pages(tmp_path, capsys) -> None:
    engines, pages = tmp_path / "engines", tmp_path / "pages"
    assert run([*FIVE, "--engines", str(engines), "--pages", str(pages)]) == 0
    (file,), (sheet,) = engines.iterdir(), pages.iterdir()
    assert (file.name, sheet.name) == ("search-1-2-4-5-3.toml", "search-1-2-4-5-3.html")
    couple = sb.balance(sb.load(file), 1).couple.terms[1]
    assert f"{2 * float(couple.size(20)):.3f}" == "0.449"
    text = sheet.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "<script" in text
    assert "1-2-4-5-3" in text


@pytest.mark.slow
def test_points_of_the_picture_lead_to_their_files(tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "report").mkdir()
    line = ["search", "--cylinders", "5", "--minimize", "couple.1,couple.2", "-o", "report/front.html"]
    assert run([*line, "--engines", "stars & more/"]) == 0
    html = (tmp_path / "report" / "front.html").read_text(encoding="utf-8")
    links = re.findall(r'<a href="([^"]*)" aria-label="point (\d+)"><circle class="force"', html)
    assert [int(place) for _, place in links] == list(range(1, 9))
    for link, _ in links:
        assert (tmp_path / "report" / unquote(unescape(link))).is_file()
    assert len({link for link, _ in links}) == 8
    assert run([*line[:-1], "report/plain.html"]) == 0
    assert "<a href" not in (tmp_path / "report" / "plain.html").read_text(encoding="utf-8")
    assert run([*line[:-1], "pages.html", "--pages", "pages/", "--engines", "stars/"]) == 0
    html = (tmp_path / "pages.html").read_text(encoding="utf-8")
    assert '<a href="pages/search-1-2-4-5-3.html" aria-label="point 1">' in html


@pytest.mark.parametrize("option", ["--engines", "--pages"])
def test_a_folder_that_cannot_be_made_is_refused_before_the_search(
    option, tmp_path: Path, capsys, monkeypatch
) -> None:
    monkeypatch.setattr(cranks_search, "search_cranks", lambda *_, **__: pytest.fail("it searched"))
    (tmp_path / "file").write_text("", encoding="utf-8")
    assert run([*FIVE, option, str(tmp_path / "file" / "folder")]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert f"{option} " in error
    assert "cannot be made" in error


@pytest.mark.parametrize("ratio", ["x", "0", "-3", "1/2"])
def test_a_rod_ratio_is_refused_before_the_search(ratio, tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.setattr(cranks_search, "search_cranks", lambda *_, **__: pytest.fail("it searched"))
    assert run([*FIVE, "--pages", str(tmp_path / "pages"), f"--ratio={ratio}"]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert "ratio" in error


@pytest.mark.parametrize("option", ["--minimize", "--require", "--limit"])
def test_an_option_that_names_nothing_is_refused(option, capsys) -> None:
    assert run(["search", "--cylinders", "5", option, ","]) == 2
    assert capsys.readouterr().err == (
        f"symbalance: {option} ',': names nothing; as couple.1, or leave it out\n"
    )


def test_long_work_is_said_before_it_begins(capsys, monkeypatch) -> None:
    monkeypatch.setattr(cranks_search, "MANY_CRANKS", 20)
    assert run(FIVE) == 0
    assert "24 cranks to be walked" in capsys.readouterr().err
    monkeypatch.setattr(cranks_search, "MANY_CRANKS", 24)
    assert run(FIVE) == 0
    assert not capsys.readouterr().err


def test_a_grid_on_which_nothing_fires_so_is_an_answer(capsys) -> None:
    assert run(["search", "--cylinders", "5", "--grid", "10"]) == 0
    assert "No crank fires so at all: none of 0 stars" in " ".join(capsys.readouterr().out.split())
