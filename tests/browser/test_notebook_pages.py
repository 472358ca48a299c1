"""A notebook run by Jupyter, written by nbconvert and opened without a network: all of it is there."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest

from tests import ROOT

pytestmark = pytest.mark.rare
CELLS = (
    "import symbalance as sb; engine = sb.load('v8-90')",
    "sb.balance(engine, 4)",
    "sb.draw.section(engine, 30)",
    "sb.page(sb.balance(engine, 4))",
    "sb.sheet(engine)",
)


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    nbformat = pytest.importorskip("nbformat", reason="in the slow group")
    from nbconvert import HTMLExporter
    from nbconvert.preprocessors import ExecutePreprocessor

    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in CELLS])
    runner = ExecutePreprocessor(timeout=300, kernel_name="python3")
    runner.preprocess(notebook, {"metadata": {"path": str(ROOT)}})
    for cell in notebook.cells[1:]:  # a terminal gets one line of each
        (output,) = cell.outputs
        assert output["data"]["text/plain"].count("\n") == 0
    page, _ = HTMLExporter().from_notebook_node(notebook)
    file = tmp_path_factory.mktemp("notebook") / "notebook.html"
    file.write_text(page, encoding="utf-8")
    return file


def test_table_drawing_and_moving_page_stand_without_a_network(exported: Path) -> None:
    playwright = pytest.importorskip("playwright.sync_api")
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        pytest.skip("no chromium on this machine")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_context(offline=True, reduced_motion="reduce").new_page()
        said: list[str] = []
        page.on("pageerror", lambda error: said.append(str(error)))
        page.goto(exported.as_uri(), wait_until="domcontentloaded")
        assert page.locator("article table math msqrt").count() > 0  # formulas are MathML, not pictures
        assert page.locator("svg[role=img] [data-part=crank]").count() > 1
        frame = page.frame_locator("iframe[srcdoc]")
        frame.locator("#check").wait_for()
        assert "agree" in frame.locator("#check").inner_text()
        assert _turns(page), "the page in the notebook does not move"
        # What nbconvert's own template fetches, and may miss, is not ours.
        assert [line for line in said if "require" not in line and "MathJax" not in line] == []
        browser.close()


def _turns(page: Any) -> bool:
    """Tell whether the page within turns its crank when it is asked to show another angle."""
    (frame,) = [f for f in page.frames if f.url == "about:srcdoc"]
    frame.wait_for_function("() => globalThis.symbalance !== undefined", timeout=20000)
    read = "document.querySelector('#section [data-part=crank]').getAttribute('transform')"
    before = frame.evaluate(read)
    frame.evaluate("symbalance.show({ theta: 77 })")
    return frame.evaluate(read) != before
