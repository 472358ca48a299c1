"""The README says what is: its table, its commands, its tour of the tree."""

import re
from pathlib import Path

import pytest

from symbalance.cli import run
from tests import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")


def is_room(path: Path) -> bool:
    """Tell a module or a package from what else is in the folder, as the marker py.typed."""
    return path.suffix == ".py" or (path.is_dir() and path.name != "__pycache__")


def block(language: str, number: int = 0) -> str:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)[number]


def test_the_table_is_what_the_command_prints(capsys):
    assert "symbalance balance v12-60" in block("sh")
    assert run(["balance", "v12-60"]) == 0
    assert capsys.readouterr().out == block("text")


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
    path.write_text(block("toml"), encoding="utf-8")
    assert run(["balance", str(path)]) == 0
    assert re.search("fires +1-3-4-2", capsys.readouterr().out)


@pytest.mark.slow
def test_the_checked_lines_are_what_the_command_prints(capsys):
    command = re.search(r"`symbalance (check derivations/\S+)` says", README)
    assert command
    where = command[1].split()
    assert run(["check", str(ROOT / where[1])]) == 1
    assert block("text", 1) in capsys.readouterr().out


KEYS = re.findall(r"```toml\n(.*?)```", (ROOT / "ENGINE_FILES.md").read_text(encoding="utf-8"), re.DOTALL)
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
