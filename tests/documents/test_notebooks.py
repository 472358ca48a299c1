"""A notebook that shows every result, run by Jupyter and converted: nothing of a result may get lost."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from symbalance.document.result import to_html, to_latex, to_markdown
from tests import ROOT
from tests.results import EXAMPLES, example

pytestmark = pytest.mark.rare


@pytest.fixture(scope="module")
def notebook() -> object:
    """Return the notebook after a run."""
    nbformat = pytest.importorskip("nbformat", reason="in the test group")
    from nbconvert.preprocessors import ExecutePreprocessor

    imports = "from tests.results import example"
    cells = [nbformat.v4.new_code_cell(imports)]
    cells += [nbformat.v4.new_code_cell(f"example({name!r})") for name in EXAMPLES]
    made = nbformat.v4.new_notebook(cells=cells)
    ExecutePreprocessor(timeout=900, kernel_name="python3").preprocess(
        made, {"metadata": {"path": str(ROOT)}}
    )
    return made


def _digits(text: str) -> set[str]:
    return set(re.findall(r"\d+\.\d{2,}", text))


def test_html_export_keeps_every_result(notebook: object) -> None:
    from bs4 import BeautifulSoup
    from nbconvert import HTMLExporter

    page, _ = HTMLExporter().from_notebook_node(notebook)
    shown = [str(each) for each in BeautifulSoup(page, "html.parser").find_all("article")]
    for name in EXAMPLES:
        assert str(BeautifulSoup(to_html(example(name)), "html.parser").article) in shown, name


def test_markdown_export_keeps_every_number(notebook: object) -> None:
    from nbconvert import MarkdownExporter

    page, _ = MarkdownExporter().from_notebook_node(notebook)
    for name in EXAMPLES:
        assert _digits(to_markdown(example(name))) <= _digits(page), name


def test_latex_export_keeps_every_result_and_compiles(notebook: object, tmp_path: Path) -> None:
    from nbconvert import LatexExporter

    page, _ = LatexExporter().from_notebook_node(notebook)
    for name in EXAMPLES:
        assert to_latex(example(name)).strip() in page, name
    assert shutil.which("lualatex"), "these tests need a TeX installation"
    (tmp_path / "all.tex").write_text(page, encoding="utf-8")
    done = subprocess.run(
        ["lualatex", "-interaction=nonstopmode", "-halt-on-error", "all.tex"],
        cwd=tmp_path, capture_output=True, text=True, timeout=600, errors="replace", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:]
