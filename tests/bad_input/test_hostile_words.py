"""Words of a stranger's file reach no terminal and no page as anything but words.

By every command that quotes them, in every medium, to the terminal and to a file, over all the characters
that a terminal obeys, that turn the direction of writing or that nobody sees.
"""

from __future__ import annotations

import json
import random
import re
import sys
import unicodedata
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.design import assign_parts
from symbalance.design.variations import Part, PartSet
from symbalance.document.formula import Name
from symbalance.document.nodes import Document, Figure, Paragraph, Source, SourceLine, Table
from symbalance.errors import SymbalanceError, printable, visible

CONTROLS = [chr(i) for i in (*range(9), *range(11, 32), *range(127, 160)) if chr(i) != "\r"]
MARKS = [chr(i) for i in (0x61C, 0x200E, 0x200F, *range(0x202A, 0x202F), *range(0x2066, 0x206A))]
UNSEEN = [chr(i) for i in (0xAD, 0x34F, 0x200B, 0x200C, 0x200D, 0x2060, 0x3164, 0xFEFF, 0xFFF9, 0xE0041)]
LINES = ["\u2028", "\u2029", "\x85", "\x0b", "\x0c"]
HOSTILE = [*CONTROLS, *MARKS, *UNSEEN, *LINES]
WORDS = ["Größe", "café", "cafe\u0301", "直列四気筒", "エンジン", "двигатель", "μ = 0.3", "q\u0307"]
MEDIA = ("text", "latex", "html", "markdown")


def unseen(text: str, invisible_operators: str = "") -> list[str]:
    """Return the characters of an output that nobody sees, by the character database alone."""
    plain = "\n\t\u00a0\u2009\u202f\u3000" + invisible_operators
    return [
        c
        for c in text
        if unicodedata.category(c) in ("Cc", "Cf", "Cs", "Co", "Zl", "Zp") and c not in plain
    ]


def operators_of(form: str) -> str:
    return "\u2061\u2062" if form == "html" else ""  # those of MathML, between its tags


@pytest.mark.parametrize("character", [*HOSTILE, "\r"])
def test_what_nobody_sees_is_shown_by_its_code(character):
    shown = visible(f"a{character}b")
    assert shown == f"a{ascii(character)[1:-1]}b"
    assert not unseen(printable(f"a{character}b"))


@pytest.mark.parametrize("words", WORDS)
def test_words_of_every_script_stay(words):
    assert visible(words) == printable(words) == words
    assert visible(f"{words}\n\t\u3000{words}\u00a0") == f"{words}\n\t\u3000{words}\u00a0"


NOTHING = {
    *map(chr, (0x034F, 0x115F, 0x1160, 0x17B4, 0x17B5, 0x2800, 0x3164, 0xFFA0)),
    *map(chr, (0x180B, 0x180C, 0x180D, 0x180F)),
    *map(chr, range(0xFE00, 0xFE10)),
}
"""Letters, marks and signs that show nothing; the selectors of kanji's variants do, and stay."""


@pytest.mark.slow
def test_every_character_shows_or_is_written_by_its_code():
    """Over all of Unicode, by the database's categories: nothing is missed and no letter is."""
    for number in range(sys.maxunicode + 1):
        character = chr(number)
        kind = unicodedata.category(character)
        if kind in ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp") and character not in "\n\t":
            assert not unseen(visible(character)), hex(number)
        elif kind[0] in "LMNPS" and character not in NOTHING:
            assert visible(character) == character, hex(number)


# Parts, notes and files -------------------------------------------------------------------------------


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def printed(capsys: pytest.CaptureFixture[str], folder: Path, command: list[str]) -> dict[str, str]:
    """Return what a command prints in each medium, on the terminal and into a file, and its JSON."""
    texts, file = {}, folder / "out.file"
    for form in (*MEDIA, "json"):
        code = run([*command, "--format", form])
        out, err = capsys.readouterr()
        assert not unseen(out, operators_of(form)), (form, code)
        assert not unseen(err)
        texts[form] = out
        assert run([*command, "--format", form, "-o", str(file)]) == code
        assert not unseen(capsys.readouterr().err)
        assert file.exists() == (code != 2)
        assert code == 2 or not unseen(file.read_text(encoding="utf-8"), operators_of(form))
    return texts


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(12))
def test_names_of_parts(seed, folder, capsys):
    chance = random.Random(seed)
    words = ["café", *chance.sample(WORDS, 3)]
    names = [f"{w}{''.join(chance.sample(HOSTILE, 9))}{i}" for i, w in enumerate(words)]
    names = [
        re.sub(r"[\n\x85\u2028\u2029\x0b\x0c\x1c-\x1e]", "", name) for name in names
    ]  # ends of a line
    rows = "".join(f'"{name}",0.4{i}\n' for i, name in enumerate(names))
    (folder / "p.csv").write_text(f"name,piston\n{rows}", encoding="utf-8", newline="")
    texts = printed(capsys, folder, ["assign", "inline-4", "--parts", "p.csv"])
    # A piston's word in Latin letters is in every medium, and in JSON all that the file has.
    assert all("caf" in texts[form] for form in MEDIA)
    pistons = [place["piston"] for place in json.loads(texts["json"])["places"].values()]
    assert sorted(pistons) == sorted(re.sub(r"\s+", " ", name).strip() for name in names)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(12))
def test_lines_of_notes_and_what_their_sidecar_says(seed, folder, capsys):
    chance = random.Random(seed)

    def some() -> str:
        return "".join(chance.sample(HOSTILE, 5))

    notes = f"Words {some()} before\n\n$$x{some()} = 2 x{some()}$$\n\n"
    notes += f"$$y = \\text{{a{some()}}} + q{some()}$$\n"
    (folder / "n.md").write_text(notes, encoding="utf-8", newline="")
    (folder / "n.symbols.toml").write_text(
        f"[symbols]\nx = {json.dumps('length' + some())}\ny = {json.dumps('m' + some())}\n"
        f'[[bind]]\nline = 3\nquantity = "value"\nscale = {json.dumps("2 x" + some())}\n',
        encoding="utf-8",
    )
    printed(capsys, folder, ["check", "n.md"])
    run(["check", "n.md", "--declare"])
    out, err = capsys.readouterr()
    assert not unseen(out)
    assert not unseen(err)


HEADS = {
    "an engine's name": ("e.toml", "name = {}\n[layout]\nfiring_order = [1, 2]\n", "balance e.toml"),
    "a key": ("e.toml", "[layout]\nfiring_order = [1, 2]\n{} = 1\n", "balance e.toml"),
    "a value": ("e.toml", "[layout]\nfiring_order = {}\n", "balance e.toml"),
    "a column": ("p.csv", "piston,{}\n1,2\n", "assign inline-4 --parts p.csv"),
    "a cell": ("p.csv", "piston\n{}\n", "assign inline-4 --parts p.csv"),
    "an angle": ("t.csv", "0,{}\n", "torque inline-4 --bore 80 --rpm 900 --pressure t.csv"),
    "an engine in a sidecar": (
        "n.symbols.toml",
        '[[bind]]\nline = 1\nquantity = "x"\nengine = {}\n',
        "check n.md",
    ),
}


@pytest.mark.parametrize("place", HEADS)
@pytest.mark.parametrize(
    "character", ["\x1b[2J", "\x07", "\x9b31m", "\u202e", "\u2066", "\u200b", "\u2028"]
)
def test_a_refusal_quotes_what_nobody_sees_by_its_code(place, character, folder, capsys):
    name, text, command = HEADS[place]
    (folder / "n.md").write_text("$$x = x$$\n", encoding="utf-8")
    toml = name.endswith(".toml")
    (folder / name).write_text(
        text.format(json.dumps(f"V{character}8") if toml else f"V{character}8"), "utf-8"
    )
    run(command.split())
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert not unseen(err)


@pytest.mark.parametrize("character", ["\x1b[2J", "\u202e", "\x9b1m"])
def test_names_of_files(character, folder, capsys):
    name = f"V{character}8.toml"
    run(["balance", name])
    assert not unseen(capsys.readouterr().err)
    (folder / name).write_text("[layout]\nfiring_order = [1, 2]\n", encoding="utf-8")
    run(["balance", name])
    out, err = capsys.readouterr()
    assert not unseen(out + err)


# The one place ----------------------------------------------------------------------------------------


def test_a_document_holds_nothing_unseen_whatever_it_is_made_of():
    bad = "a\x1b\u202e"
    line = SourceLine(bad, bad, bad, notes=((bad, bad),), formulas=((bad, Name("x")),))
    picture = Figure(bad, "<svg>\x1b</svg>", bad, bad)
    document = Document(
        bad, (Paragraph((bad,)), Table(bad, (), ((bad,),), empty=bad), Source((line,)), picture), bad
    )
    text = repr(document)
    assert "\\x1b\\u202e" not in text.replace("\\\\x1b\\\\u202e", "").replace("<svg>\\x1b", "")
    assert document.blocks[3].picture == "<svg>\x1b</svg>"  # type: ignore[union-attr]
    clean = (Paragraph(("a", "b")), Table("t", (), (("a",),)))
    assert all(a is b for a, b in zip(Document("a", clean).blocks, clean, strict=True))


def test_in_python_too():
    parts = PartSet("piston", tuple(Part(f"\x1b{i}\u202e", "0.4") for i in range(2)))
    result = assign_parts(sb.inline("1-2", ratio=4), [parts])
    for shown in (
        repr(result),
        sb.to_text(result),
        sb.to_latex(result),
        sb.to_html(result),
        sb.to_markdown(result),
    ):
        assert not unseen(shown, "\u2061\u2062")
    data = sb.to_json(result)
    assert not unseen(data)
    assert "\x1b0\u202e" in json.dumps(json.loads(data), ensure_ascii=False).replace("\\u001b", "\x1b")
    with pytest.raises(SymbalanceError) as refusal:
        assign_parts(sb.inline("1-2", ratio=4), [PartSet("\x1b", parts.parts[:1])])
    assert not unseen(str(refusal.value))
