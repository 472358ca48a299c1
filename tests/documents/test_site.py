"""Evidence: the site builds without a warning and without a network, and opening it fetches nothing."""

from __future__ import annotations

import argparse
import doctest
import os
import re
import subprocess
import sys
from html import unescape
from pathlib import Path
from urllib.parse import unquote

import pytest

import symbalance
from symbalance.cli.parser import build_parser
from tests import ROOT

pytestmark = pytest.mark.slow

DOCS = ROOT / "docs"

OFFLINE = """
import socket, sys

def refuse(*_):
    raise OSError("this build may not use a network")

socket.socket.connect = refuse
socket.getaddrinfo = refuse
from sphinx.cmd.build import main
sys.exit(main(sys.argv[1:]))
"""
FETCHED = re.compile(
    r"<(?:script|img|iframe|source|video|audio|embed|object|input)\b[^>]*?\b(?:src|srcset|data)=[\"']([^\"']*)"
    r"|<link\b[^>]*?\bhref=[\"']([^\"']*)"
)
IN_STYLES = re.compile(r"(?:url\(\s*|@import\s+)[\"']?([^\"')\s;]+)")
TAGS = re.compile(r"<(?:a|link|script|img)\b[^>]*?\b(?:href|src)=\"([^\"]*)\"")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """Return the folder of a freshly built site and what the build printed."""
    folder = tmp_path_factory.mktemp("site")
    arguments = ["-W", "--keep-going", "-E", "-b", "html", "-d", str(folder / "trees")]
    command = [sys.executable, "-c", OFFLINE, *arguments, str(DOCS), str(folder / "html")]
    run = subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=900,
        check=False,
        env={**os.environ, "LC_ALL": "C.UTF-8"},
    )
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-4000:]
    return folder / "html", run.stdout


def pages(site: tuple[Path, str]) -> dict[Path, str]:
    return {path: path.read_text(encoding="utf-8") for path in sorted(site[0].rglob("*.html"))}


def is_elsewhere(address: str) -> bool:
    return bool(re.match(r"(?:[a-z][a-z0-9+.-]*:)?//|https?:", address.strip()))


def test_nothing_is_fetched_from_elsewhere(site: tuple[Path, str]) -> None:
    texts = pages(site)
    assert len(texts) > 40
    fetched = [a or b for text in texts.values() for a, b in FETCHED.findall(text)]
    styles = [style.read_text(encoding="utf-8") for style in site[0].rglob("*.css")]
    styles += [
        block for text in texts.values() for block in re.findall(r"<style.*?</style>", text, re.DOTALL)
    ]
    fetched += [address for style in styles for address in IN_STYLES.findall(style)]
    assert len(fetched) > 100
    assert [address for address in fetched if is_elsewhere(address)] == []


def test_every_link_within_the_site_leads_somewhere(site: tuple[Path, str]) -> None:
    texts = pages(site)
    names = {path: set(re.findall(r"\bid=\"([^\"]*)\"", text)) for path, text in texts.items()}
    broken = []
    for path, text in texts.items():
        for link in {unescape(link) for link in TAGS.findall(text)}:
            if is_elsewhere(link) or link.startswith(("mailto:", "data:")):
                continue
            file, _, anchor = unquote(link.split("?")[0]).partition("#")
            target = (path.parent / file).resolve() if file else path
            if not target.exists() or (anchor and target in names and anchor not in names[target]):
                broken.append((path.name, link))
    assert broken == []


def test_formulas_are_mathml(site: tuple[Path, str]) -> None:
    counts = re.search(r"formulas: (\d+) as MathML, (\d+) as they were typed", site[1])
    assert counts
    read, unread = map(int, counts.groups())
    assert read > 1000
    assert unread < 0.05 * read
    texts = pages(site)
    assert sum(text.count("<math") for text in texts.values()) >= read
    assert [
        path.name for path, text in texts.items() if re.search(r"<script[^>]*mathjax", text, re.I)
    ] == []


def test_every_public_name_has_a_place(site: tuple[Path, str]) -> None:
    text = "".join(text for path, text in pages(site).items() if path.parent.name == "api")
    names = set(symbalance.__all__) - {"__version__"}
    assert {name for name in names if f'id="symbalance.{name}"' not in text} == set()


def test_every_command_has_a_page_with_every_option(site: tuple[Path, str]) -> None:
    commands = next(a for a in build_parser()._actions if isinstance(a, argparse._SubParsersAction))
    for name, parser in commands.choices.items():
        text = (site[0] / "commands" / f"{name}.html").read_text(encoding="utf-8")
        bare = unescape(re.sub(r"<[^>]*>", "", text))
        actions = [a for a in parser._actions if not isinstance(a, argparse._HelpAction)]
        options = [option for action in actions for option in action.option_strings]
        assert [option for option in options if option not in bare] == [], name


def test_every_derivation_is_there_with_its_pictures(site: tuple[Path, str]) -> None:
    for source in (ROOT / "derivations").rglob("*.md"):
        name = source.relative_to(ROOT).with_suffix(".html").as_posix().replace("README", "index")
        text = (site[0] / name).read_text(encoding="utf-8")
        assert text.count("<img") >= source.read_text(encoding="utf-8").count("![")


def test_the_examples_of_the_extensions_hold(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(DOCS))
    from extensions import docstrings, formulas

    for module in (docstrings, formulas):
        outcome = doctest.testmod(module)
        assert outcome.attempted
        assert outcome.failed == 0
