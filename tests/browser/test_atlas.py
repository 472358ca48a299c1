"""The atlas opened from disk: it sorts by what shakes, asks for nothing, and is plain to everybody."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from symbalance.cli import run

pytestmark = pytest.mark.rare
NAMES = ["v8-90", "inline-3", "boxer-4", "v12-60", "vq30de", "honda-nt650"]


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    playwright = pytest.importorskip("playwright.sync_api")
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        pytest.skip("no chromium on this machine")
    with playwright.sync_playwright() as driver:
        started = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield started
        started.close()


@pytest.fixture(scope="module")
def atlas(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("atlas")
    assert run(["atlas", *NAMES, "-o", str(folder)]) == 0
    return folder


def opened(chromium: Any, atlas: Path, **options: Any) -> tuple[Any, list[str]]:
    page = chromium.new_page(**({"viewport": {"width": 390, "height": 800}} | options))
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda request: said.append(request.url))
    page.goto((atlas / "index.html").as_uri())
    assert said.pop(0).startswith("file:")
    return page, said


KEYS = """(rows, column) => rows.map((row) => {
    const cell = row.children[column];
    return cell.dataset.key === undefined ? cell.textContent : Number(cell.dataset.key); })"""


def column(page: Any, table: int, place: int) -> list[Any]:
    return page.locator("table").nth(table).locator("tbody tr").evaluate_all(KEYS, place)


def test_every_column_of_numbers_sorts_both_ways(chromium: Any, atlas: Path) -> None:
    page, said = opened(chromium, atlas)
    for table, places in ((0, (1, 2, 3, 4, 5, 6)), (1, (3, 4))):
        other = column(page, 1 - table, 0)
        for place in places:
            button = page.locator("table").nth(table).locator("thead th").nth(place).locator("button")
            button.click()
            rising = column(page, table, place)
            assert rising == sorted(rising)
            assert len(set(rising)) > 1
            button.click()
            assert column(page, table, place) == sorted(rising, reverse=True)
        assert column(page, 1 - table, 0) == other  # the other table stays as it was
    assert said == []
    page.close()


def test_a_name_opens_the_engine_and_a_misprint_its_row(chromium: Any, atlas: Path) -> None:
    page, _ = opened(chromium, atlas)
    assert "12.46" in page.inner_text("#published ~ section")
    assert page.locator("table").nth(0).locator("text=misprints").count() == 3
    page.locator("table").nth(0).locator("text=boxer-4").click()
    assert page.title() == "boxer-4"
    page.close()


def test_it_sorts_by_keyboard(chromium: Any, atlas: Path) -> None:
    page, _ = opened(chromium, atlas)
    page.locator("thead button").nth(3).focus()
    page.keyboard.press("Enter")
    assert page.locator("thead th").nth(3).get_attribute("aria-sort") == "ascending"
    page.close()


@pytest.mark.parametrize("width", [390, 768, 1280])
def test_nothing_scrolls_sideways_and_without_scripts_all_is_there(
    width: int, chromium: Any, atlas: Path
) -> None:
    context = chromium.new_context(java_script_enabled=False, viewport={"width": width, "height": 900})
    page = context.new_page()
    page.goto((atlas / "index.html").as_uri())
    for name in NAMES:
        assert name in page.inner_text("table >> nth=0")
    context.close()
    page, _ = opened(chromium, atlas, viewport={"width": width, "height": 900})
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    page.close()


@pytest.fixture(scope="module")
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("no npm on this machine")
    folder = tmp_path_factory.mktemp("npm")
    command = [npm, "install", "--silent", "--prefix", str(folder), "axe-core@4"]
    if subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip("axe-core cannot be fetched here")
    return (folder / "node_modules/axe-core/axe.min.js").read_text(encoding="utf-8")


@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize("look", ["light", "dark", "print"])
def test_axe_finds_nothing(look: str, width: int, chromium: Any, atlas: Path, axe: str) -> None:
    scheme = "dark" if look == "dark" else "light"
    size = {"width": width, "height": 900}
    context = chromium.new_context(color_scheme=scheme, bypass_csp=True, viewport=size)
    page = context.new_page()
    page.goto((atlas / "index.html").as_uri())
    if look == "print":
        page.emulate_media(media="print")
    page.add_script_tag(content=axe)
    wrong = page.evaluate("async () => (await axe.run()).violations.map(v => [v.id, v.nodes[0].html])")
    assert wrong == []
    context.close()
