"""LaTeX of every preset and command compiles by two engines, no line over the margin."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.document.result import to_latex
from tests.different_presets import different_presets
from tests.results import EXAMPLES, example

pytestmark = pytest.mark.rare

ENGINES = ("pdflatex", "lualatex")
COMMANDS = (
    "balance {}",
    "torque {} --ratio 4",
    "design {} --ratio 4",
    "sensitivities {} --order 2 --ratio 4",
    "tolerances {} --order 2 --mass 1% --throw 0.1 --ratio 4",
)
_FAULT = re.compile(r"^(?:! .*|Overfull \\[hv]box.*|LaTeX Font Warning: .*undefined.*)$", re.MULTILINE)


def compiled(source: str, engine: str, folder: Path) -> list[str]:
    """Return what an engine finds wrong with a document."""
    program = shutil.which(engine)
    assert program, f"these tests need {engine}"
    (folder / "document.tex").write_text(source, encoding="utf-8")
    command = [program, "-interaction=nonstopmode", "-halt-on-error", "document.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=300, check=False)
    log = (folder / "document.log").read_text(encoding="utf-8", errors="replace")
    return [*_FAULT.findall(log), *([] if done.returncode == 0 else [log[-1500:]])]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("name", EXAMPLES)
def test_every_result_compiles(name: str, engine: str, tmp_path: Path) -> None:
    assert compiled(to_latex(example(name), standalone=True), engine, tmp_path) == []


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("preset", different_presets())
def test_every_command_on_every_preset_compiles(
    preset: str, engine: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bodies = []
    for command in COMMANDS:
        arguments = command.format(preset).split()
        if run([*arguments, "--format", "latex", "--standalone"]) == 2:
            capsys.readouterr()
            arguments = [a for a in arguments if a not in ("--ratio", "4")]  # the engine has its own
            assert run([*arguments, "--format", "latex", "--standalone"]) == 0, command
        preamble, _, body = capsys.readouterr().out.partition("\\begin{document}\n")
        bodies.append(body.removesuffix("\\end{document}\n"))
    source = preamble + "\\begin{document}\n" + "\\clearpage\n".join(bodies) + "\\end{document}\n"
    assert compiled(source, engine, tmp_path) == []


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(
    "options", ["letterpaper", "a4paper,10pt", "a4paper,12pt"], ids=["letter", "10 pt", "12 pt"]
)
def test_fragments_stand_in_any_article(options: str, engine: str, tmp_path: Path) -> None:
    fragments = [
        to_latex(sb.balance(sb.load(name), 8)) for name in ("v10-72", "v12-60", "r-985", "vw-vr6")
    ]
    head = rf"\documentclass[{options}]{{article}}" + "\n\\usepackage{amsmath,booktabs}\n"
    body = "Before.\n\n" + "\n\nBetween.\n\n".join(fragments) + "\n\nAfter."
    source = f"{head}\\begin{{document}}\n{body}\n\\end{{document}}\n"
    assert compiled(source, engine, tmp_path) == []


def test_east_asian_signs_are_set_by_lualatex_and_told_by_pdflatex(tmp_path: Path) -> None:
    result = sb.balance(sb.inline(throws=[0, 180], name="二気筒エンジン"), 2)
    source = to_latex(result, standalone=True)
    assert compiled(source, "lualatex", tmp_path) == []
    assert "二気筒エンジン" in _words(tmp_path)
    assert compiled(source, "pdflatex", tmp_path) == []
    assert "their codes" in (tmp_path / "document.log").read_text(encoding="latin-1")
    printed = _words(tmp_path)
    assert "U+4E8C" in printed
    assert "compile with lualatex" in printed


def _words(folder: Path) -> str:
    command = ["pdftotext", "-layout", "document.pdf", "-"]
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=60, check=True)
    return done.stdout.decode("utf-8")


@pytest.mark.parametrize("preset", different_presets())
def test_every_preset_s_balance_is_one_page(preset: str, tmp_path: Path) -> None:
    source = to_latex(sb.balance(sb.load(preset)), standalone=True)
    assert compiled(source, "pdflatex", tmp_path) == []
    log = (tmp_path / "document.log").read_text(encoding="latin-1").replace("\n", "")
    assert "Output written on document.pdf (1 page," in log
