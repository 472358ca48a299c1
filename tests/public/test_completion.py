"""Completion scripts, run by the shells they are for."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.cli.output import MEDIA
from tests.record.cases import COMMANDS

DRIVER = """
try() {
    COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _symbalance
    for word in "${COMPREPLY[@]}"; do printf '%s\\n' "$word"; done
}
"""
CASES = {
    "ba": ["balance"],
    "-": ["--help", "--version"],
    "balance v12": ["v12-60"],
    "balance --for": ["--format"],
    "balance v12-60 --format c": ["csv"],
    "balance v12-60 --order ''": [],
    "derive --quantity f": ["force"],
    "design v8-90 --spread e": ["ends", "even"],
    "completion ''": ["bash", "zsh", "fish"],
    "engines --show inline-6": ["inline-6"],
    "check my": ["my notes.md"],
    "balance -o my": ["my notes.md"],
    "tolerances inline-6": ["inline-6", "inline-6.toml"],
    "crankshaft inline-6": ["inline-6.toml"],
}


@pytest.fixture
def script(capsys: pytest.CaptureFixture[str]):
    def printed(shell: str) -> str:
        assert run(["completion", shell]) == 0
        return capsys.readouterr().out

    return printed


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("my notes.md", "inline-6.toml"):
        (tmp_path / name).write_text("", encoding="utf-8")
    return tmp_path


def shell(name: str) -> str:
    program = shutil.which(name)
    if program is None:
        pytest.skip(f"{name} is not installed")
    return program


def lines(program: str, source: str, folder: Path) -> list[str]:
    done = subprocess.run(
        [program, "-c", source], cwd=folder, capture_output=True, encoding="utf-8", check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout.splitlines()


def test_bash_finishes_what_is_typed(script, folder):
    tried = "".join(f"echo '# {typed.replace(chr(39), '')}'; try symbalance {typed}\n" for typed in CASES)
    printed = lines(shell("bash"), script("bash") + DRIVER + tried, folder)
    answers: dict[str, list[str]] = {}
    for line in printed:
        if line.startswith("# "):
            answers[line[2:]] = []
        else:
            answers[next(reversed(answers))].append(line)
    assert answers == {typed.replace("'", ""): words for typed, words in CASES.items()}


@pytest.mark.slow
def test_fish_finishes_what_is_typed(script, folder):
    tried = "".join(f'echo "# {typed}"; complete -C "symbalance {typed}"\n' for typed in FISH)
    printed = lines(shell("fish"), script("fish") + tried, folder)
    answers = "\n".join(line.partition("\t")[0] for line in printed)
    assert answers == "\n".join("\n".join([f"# {typed}", *words]) for typed, words in FISH.items())


FISH = {
    typed: words
    for typed, words in CASES.items()
    if words and typed[-1] not in "'-" and "my" not in typed
}


@pytest.mark.slow
def test_zsh_reads_its_script(script, folder):
    stubs = "compdef() { print $2 }; _files() { print FILES }\n"
    stubs += "compadd() { shift; (( $# )) && print -l -- $@; return 0 }\n"
    typed = "words=(symbalance balance --format j); CURRENT=4; _symbalance\n"
    typed += "words=(symbalance check x); CURRENT=3; _symbalance\n"
    printed = lines(shell("zsh"), stubs + script("zsh") + typed, folder)
    assert printed == ["symbalance", *MEDIA, "FILES"]


@pytest.mark.parametrize("name", ["bash", "zsh", "fish"])
def test_every_command_option_and_preset_is_known(name, script):
    text = script(name)
    words = set(re.findall(r"[\w-]+", text))
    assert words >= {*COMMANDS, *(preset.name for preset in sb.presets())}
    assert words >= {"standalone", "format", "budget"} or words >= {
        "--standalone",
        "--format",
        "--budget",
    }
    assert text.count("'") % 2 == 0 or name == "fish"


def test_words_of_the_script_hold_no_sign_of_a_shell(script):
    for assigned in re.findall(r"(?:values|options)='([^']*)'", script("bash")):
        assert re.fullmatch(r"[\w ./-]*", assigned), assigned


def test_an_unknown_shell_is_refused(capsys):
    assert run(["completion", "tcsh"]) == 2
    assert capsys.readouterr().err.count("\n") == 1
