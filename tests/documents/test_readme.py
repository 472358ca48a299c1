"""The README and the site's pages say what is: tables, commands, engine files, the tour, links."""

import argparse
import doctest
import re
from pathlib import Path

import pytest

from symbalance.cli import run
from tests import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")
CHECKING = (ROOT / "docs" / "checking.md").read_text(encoding="utf-8")


def is_room(path: Path) -> bool:
    """Tell a module or a package from what else is in the folder, as the marker py.typed."""
    return path.suffix == ".py" or (path.is_dir() and path.name != "__pycache__")


def block(language: str) -> str:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)[0]


def test_the_table_is_what_the_command_prints(capsys):
    assert "symbalance balance v12-60" in block("sh")
    assert run(["balance", "v12-60"]) == 0
    assert capsys.readouterr().out == block("text")


def test_the_picture_is_what_its_command_writes(tmp_path, request):
    command = re.search(r"`symbalance (draw \S+ --what overview -o (\S+))`", README)
    assert command
    assert f"]({command[2]})" in README
    assert f" {block('sh').split()[-1]} " in command[1]  # it is of the engine whose table stands below
    words = command[1].split()
    assert run([*words[:-1], str(tmp_path / "made.svg")]) == 0
    made, kept = (tmp_path / "made.svg").read_bytes(), ROOT / command[2]
    if request.config.getoption("--update"):
        kept.write_bytes(made)
    assert kept.read_bytes() == made


def test_the_table_and_the_picture_stand_on_one_screen():
    start = README.index("symbalance balance v12-60")
    picture, table = README.index("![", start), README.index("```text", start)
    assert picture < table
    assert README[picture:table].count("\n") < 4


def test_every_room_is_in_the_tour_and_every_room_of_the_tour_exists():
    tour = next(b for b in re.findall(r"```text\n(.*?)```", README, re.DOTALL) if "rooms from" in b)
    named = set()
    for line in tour.splitlines():
        if line.startswith("  "):
            rooms = line[2:].split("  ")[0]
            named |= {room.strip().rstrip("/") for room in rooms.split(",")}
    package = ROOT / "symbalance"
    there = {p.stem for p in package.iterdir() if is_room(p) and not p.name.startswith("_")}
    assert named == there


def test_the_layers_of_the_contract_are_the_rooms():
    import tomllib

    table = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = table["tool"]["importlinter"]["contracts"][0]["layers"]
    named = {room.strip() for layer in layers for room in layer.split("|")}
    there = {p.stem for p in (ROOT / "symbalance").iterdir() if is_room(p) and p.stem != "__init__"}
    assert named == there


def test_the_picture_and_the_engine_file_are_real(tmp_path, capsys):
    for picture in re.findall(r"!\[.*?\]\((.*?)\)", README):
        assert (ROOT / picture).stat().st_size > 1000
    path = tmp_path / "example.toml"
    path.write_text(KEYS[0], encoding="utf-8")
    assert run(["balance", str(path)]) == 0
    assert re.search("fires +1-3-4-2", capsys.readouterr().out)


@pytest.mark.slow
def test_the_checked_lines_are_what_the_command_prints(capsys):
    command = re.search(r"`symbalance (check derivations/\S+)` says", CHECKING)
    assert command
    where = command[1].split()
    assert run(["check", str(ROOT / where[1])]) == 1
    assert re.findall(r"```text\n(.*?)```", CHECKING, re.DOTALL)[0] in capsys.readouterr().out


KEYS = re.findall(
    r"```toml\n(.*?)```", (ROOT / "docs/engine-files.md").read_text(encoding="utf-8"), re.DOTALL
)
WHOLE = [text for text in KEYS if "[layout]" in text or "[[cylinder]]" in text]
PARTS = [text for text in KEYS if "[[counterweight]]" in text and "[crankshaft]" not in text]


@pytest.mark.parametrize("text", [*WHOLE, *(WHOLE[0] + part for part in PARTS)])
def test_every_engine_file_shown_is_one(text, tmp_path, capsys):
    path = tmp_path / "shown.toml"
    path.write_text(text, encoding="utf-8")
    assert run(["balance", str(path)]) == 0, capsys.readouterr().err


def test_every_block_of_keys_is_read_by_some_test():
    cranks = [text for text in KEYS if "[crankshaft]" in text]
    assert len(WHOLE) + len(PARTS) + len(cranks) == len(KEYS) > 5


PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_every_link_within_the_repository_leads_to_a_file(page):
    targets = re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    generated = ("api/", "commands/", "derivations/")  # folders of the site that its build writes
    links = [t for t in targets if not (page.parent.name == "docs" and t.startswith(generated))]
    assert [link for link in links if not (page.parent / link).exists()] == []


@pytest.mark.parametrize("page", sorted((ROOT / "docs").glob("*.md")), ids=lambda path: path.name)
def test_the_examples_of_the_pages_hold(page):
    assert doctest.testfile(str(page), module_relative=False, encoding="utf-8").failed == 0


@pytest.mark.parametrize("name", ["README.md", "CONTRIBUTING.md"])
def test_every_file_and_folder_named_is_there(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    paths = re.findall(r"`((?:symbalance|tests|docs|derivations|\.ci|\.github)/[\w./-]*)`", text)
    paths = [path for path in paths if "NAME" not in path and "_build" not in path]
    assert len(paths) > 2 or name == "README.md"
    assert [path for path in paths if not (ROOT / path).exists()] == []


def test_the_steps_shown_to_a_newcomer_are_sound(tmp_path, capsys):
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    preset, *_ = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)
    path = tmp_path / "v2-120.toml"
    path.write_text(preset, encoding="utf-8")
    assert run(["balance", str(path), "--order", "2"]) == 0
    assert "1/2" in capsys.readouterr().out
    source = re.findall(r"```python\n(.*?)```", text, re.DOTALL)[0]
    module: dict[str, object] = {}
    exec(compile(source, "bounds.py", "exec"), module)
    parser = argparse.ArgumentParser()
    module["add"](parser.add_subparsers())
    options = parser.parse_args(["bounds", "--order", "2"])
    assert options.run(options) == 0
    assert "0.00417385" in capsys.readouterr().out
