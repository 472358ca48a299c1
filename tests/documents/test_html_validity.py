"""Pages of every result, judged by html-validate and axe-core, which come from npm."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from symbalance.document.result import to_html
from tests.results import EXAMPLES, example

pytestmark = pytest.mark.rare

AXE = """
const fs = require("fs"), { JSDOM } = require("jsdom"), axe = require("axe-core");
(async () => {
  const found = {};
  for (const name of process.argv.slice(2)) {
    const dom = new JSDOM(fs.readFileSync(name, "utf8"), { runScripts: "outside-only" });
    dom.window.eval(axe.source);
    const rules = { "color-contrast": { enabled: false } };  // needs a browser that draws
    const { violations } = await dom.window.axe.run(dom.window.document, { rules });
    found[name] = violations.map(v => `${v.id}: ${v.nodes.map(n => n.html).slice(0, 3).join(" | ")}`);
  }
  console.log(JSON.stringify(found));
})();
"""


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a page of every result, and both judges installed in it."""
    if shutil.which("npm") is None:
        pytest.fail("npm is not installed: these tests need Node.js")
    folder = tmp_path_factory.mktemp("pages")
    packages = ["html-validate@10", "axe-core@4", "jsdom@26"]
    command = ["npm", "install", "--no-fund", "--no-audit", "--no-package-lock", *packages]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stderr
    for name in EXAMPLES:
        (folder / f"{name}.html").write_text(to_html(example(name), standalone=True), encoding="utf-8")
    return folder


def test_html_is_valid(pages: Path) -> None:
    (pages / ".htmlvalidate.json").write_text('{"extends": ["html-validate:recommended"]}')
    names = [f"{name}.html" for name in EXAMPLES]
    command = ["npx", "html-validate", "--formatter", "json", *names]
    done = subprocess.run(command, cwd=pages, capture_output=True, text=True, timeout=600, check=False)
    found = [
        f"{Path(page['filePath']).name}:{m['line']} {m['ruleId']} {m['message']}"
        for page in json.loads(done.stdout)
        for m in page["messages"]
    ]
    assert found == []


def test_pages_are_accessible(pages: Path) -> None:
    (pages / "axe.js").write_text(AXE)
    names = [f"{name}.html" for name in EXAMPLES]
    done = subprocess.run(
        ["node", "axe.js", *names], cwd=pages, capture_output=True, text=True, timeout=600, check=False
    )
    assert done.returncode == 0, done.stderr
    assert {name: v for name, v in json.loads(done.stdout).items() if v} == {}
