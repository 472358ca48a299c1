"""Proposals for a symbols file, against files that were written by hand for the same pages."""

from __future__ import annotations

from pathlib import Path

import pytest

from symbalance.checking import check, sidecar_draft
from symbalance.cli import run
from symbalance.document.letters import plain_letter
from symbalance.errors import SymbalanceError
from symbalance.notes.checking.declared.sidecar import parse_sidecar, read_sidecar
from symbalance.notes.checking.declared.symbol_roles import KNOWN, role_of
from symbalance.notes.checking.documents import SUFFIXES
from tests import TESTS

HAND = TESTS / "hand"
WRONG = {
    ("oldtex", "λ"), ("single_cylinder", "M"), ("single_cylinder", "F"), ("slider_crank_notes", "v"),
    ("torque", "F"), ("guest_scan", "ω"), ("guest_web", "λ"), ("data_on_the_page", "a"),
    ("roles", "t"),
}  # fmt: skip
"""What is proposed wrongly: letters that change their meaning, a ratio no word explains, any variable."""
PAGES = {
    "en.md": (
        "Let $r$ be the crank radius, $l$ the rod length and $\\theta$ the crank angle.\n\n"
        "The displacement of the piston is\n\n"
        "$$x = r(1-\\cos\\theta) + \\frac{r^2}{2l}\\sin^2\\theta$$\n",
        {"r": "crank radius", "θ": "crank angle", "x": "displacement from top dead centre"},
    ),
    "de.txt": (
        "Kurbelradius r, Pleuellänge l, Kurbelwinkel φ, λ = r/l (Schubstangenverhältnis)\n\n"
        "Massenkraft F, oszillierende Masse m:\n\nF ≈ m r ω² (cos φ + λ cos 2φ)\n",
        {
            "r": "crank radius", "φ": "crank angle", "λ": "crank ratio r/l", "m": "reciprocating mass",
            "F": "inertia force", "ω": "angular speed",
        },
    ),
    "ja.txt": (
        "s:ストローク\nクランク角をθとする。往復質量 M、連桿比 λ = l/s\n\n"
        "\\displaystyle F=M \\frac{s}{2} \\omega^2 (\\cos \\theta + \\frac{1}{2 \\lambda} "
        "\\cos 2 \\theta)\n",
        {"s": "stroke", "θ": "crank angle", "λ": "rod ratio l/s", "M": "reciprocating mass"},
    ),
}  # fmt: skip


def proposed(page: str | Path) -> dict[str, str]:
    """The meaning proposed for each letter of a page, declared by nobody."""
    meanings = sidecar_draft(page, {}).proposals.meanings
    return {plain_letter(letter): proposal.meaning for letter, proposal in meanings.items()}


@pytest.mark.slow
def test_proposals_are_those_of_the_files_written_by_hand():
    right, wrong = 0, set()
    for sidecar in sorted(HAND.glob("*.symbols.toml")):
        stem = sidecar.name.split(".")[0]
        page = next(p for p in HAND.glob(f"{stem}.*") if p.suffix in SUFFIXES)
        meanings = proposed(page)
        for letter, text in read_sidecar(sidecar).symbols.items():
            name, role = plain_letter(letter), role_of(text)
            if name in meanings and role in KNOWN:
                right += meanings[name] == role
                wrong |= {(stem, name)} if meanings[name] != role else set()
    assert wrong <= WRONG
    assert right >= 150


@pytest.mark.parametrize("name", PAGES)
def test_three_languages_name_their_letters(name, tmp_path):
    text, expected = PAGES[name]
    page = tmp_path / name
    page.write_text(text, encoding="utf-8")
    assert expected.items() <= proposed(page).items()


@pytest.mark.parametrize("name", PAGES)
def test_a_drafted_file_is_read_and_proposes_the_same(name, tmp_path):
    page = tmp_path / name
    page.write_text(PAGES[name][0], encoding="utf-8")
    draft = sidecar_draft(page)
    declared = parse_sidecar(draft.toml(), "draft")
    assert declared.symbols.keys() == draft.proposals.letters.keys()
    assert declared.proposal_count == len(draft.proposals.meanings)
    assert not any(role_of(text) in KNOWN for text in declared.symbols.values())
    assert {role_of(t) for t in declared.accepted().symbols.values()} >= set(PAGES[name][1].values())


WRONG_BY_ITS_WORDS = "crank radius r, rod length l, crank ratio λ\n\n$$2 λ = r/l$$\n"


def test_nothing_proposed_is_believed(tmp_path):
    page, sidecar = tmp_path / "notes.md", tmp_path / "notes.symbols.toml"
    page.write_text(WRONG_BY_ITS_WORDS, encoding="utf-8")
    sidecar.write_text(sidecar_draft(page).toml(), encoding="utf-8")
    unconfirmed = check(page)
    assert unconfirmed.verdicts[0].verdict != "refuted"
    assert "3 proposals wait" in unconfirmed.data()["remarks"][0]
    accepted = check(page, accept_proposals=True)
    assert accepted.verdicts[0].verdict == "refuted"
    assert accepted.data()["remarks"] == [
        "Not confirmed: 3 proposed declarations taken as they are, by --accept-proposals."
    ]
    sidecar.write_text(sidecar.read_text(encoding="utf-8").replace('"? ', '"'), encoding="utf-8")
    confirmed = check(page)
    assert confirmed.verdicts[0].verdict == "refuted"
    assert "remarks" not in confirmed.data()


def test_a_proposed_claim_waits_for_its_confirmation(tmp_path):
    page, sidecar = tmp_path / "v12.md", tmp_path / "v12.symbols.toml"
    text = "# V12, banks at 60°\n\n## 6th order force, vertical\n\n$$9 \\cos 6\\theta$$\n"
    page.write_text(text, encoding="utf-8")
    sidecar.write_text(sidecar_draft(page).toml(), encoding="utf-8")
    assert "proposed = true" in sidecar.read_text(encoding="utf-8")
    assert not any(v.bind for v in check(page).verdicts)
    (claim,) = [v for v in check(page, accept_proposals=True).verdicts if v.bind]
    assert (claim.verdict, claim.bind) == ("refuted", "force.vertical, order 6 of v12-60")


def test_a_page_without_a_file_says_what_it_needs(tmp_path, capsys):
    page = tmp_path / "notes.md"
    page.write_text("$$u + w = f(k)$$\n", encoding="utf-8")
    assert run(["check", str(page)]) == 1
    said = capsys.readouterr().out
    beside = page.with_suffix(".symbols.toml")
    assert f"symbalance check {page} --declare -o {beside}".split() == _command_in(said)


def _command_in(said: str) -> list[str]:
    words = said.split()
    return words[words.index("symbalance") :][:6]


def test_a_word_is_a_letter_where_a_page_says_so(tmp_path):
    page = tmp_path / "notes.txt"
    page.write_text("LhはLの水平方向の成分、αはバンク角の半分の角度\n\nLh = L cos α\n", encoding="utf-8")
    draft = sidecar_draft(page)
    assert set(draft.proposals.letters) == {"Lh", "L", "alpha"}
    assert [scope.given for scope in draft.proposals.scopes] == [("Lh = L sin α",)]
    accepted = check(page, accept_proposals=True)
    assert [v.verdict for v in accepted.verdicts if v.line == 3] == ["refuted"]


# One file for a course, and standard sets of letters


def test_a_folder_s_file_declares_letters_for_every_page(tmp_path):
    (tmp_path / "symbols.toml").write_text('letters = "crank"\n[symbols]\nk = "1"\n', encoding="utf-8")
    for name, own in (("a.md", ""), ("b.md", '[symbols]\nr = "stroke"\n')):
        (tmp_path / name).write_text("$$l = λ r$$\n", encoding="utf-8")
        if own:
            (tmp_path / "b.symbols.toml").write_text(own, encoding="utf-8")
    assert check(tmp_path / "a.md").verdicts[0].verdict == "holds"
    assert check(tmp_path / "b.md").verdicts[0].verdict == "refuted"


def test_a_folder_s_file_says_nothing_of_lines(tmp_path):
    (tmp_path / "symbols.toml").write_text("[[scope]]\nlines = [1, 2]\n", encoding="utf-8")
    (tmp_path / "a.md").write_text("$$1 = 1$$\n", encoding="utf-8")
    with pytest.raises(SymbalanceError, match="for every document of its folder"):
        check(tmp_path / "a.md")


def test_an_unknown_set_of_letters_is_refused_with_the_known():
    with pytest.raises(SymbalanceError, match="crank"):
        parse_sidecar('letters = "kran"\n', "a.symbols.toml")


WORDS_OF_A_BOOK = """Let R be the radius of the crank, L the length of the connecting rod between centres,
and n = L / R the ratio of the two. When the crank has turned through the angle a from the inner dead
centre, the piston has travelled some way.

The velocity of the piston, {speed}, follows as

    v = {velocity}
"""

SPEED = "w being the angular velocity"
VELOCITIES = [
    (SPEED, "w R (sin a + sin 2a / (2n))", "conditional"),
    (SPEED, "w R (sin a + sin 2a / n)", "refuted"),
    (SPEED, "w R (sin a - sin 2a / (2n))", "refuted"),
    (SPEED, "w R (sin a + sin a / (2n))", "refuted"),
    (SPEED, "w² R (sin a + sin 2a / (2n))", "refuted"),
    (SPEED, "w R (cos a + sin 2a / (2n))", "refuted"),
    ("w being the angular velocity of the rod", "w R (sin a + sin 2a / n)", "definition"),
    ("w being a number", "w R (sin a + sin 2a / n)", "definition"),
]


@pytest.mark.parametrize(("speed", "velocity", "word"), VELOCITIES)
def test_the_letters_of_a_velocity_are_told_in_clauses_around_it(speed, velocity, word):
    page = WORDS_OF_A_BOOK.format(speed=speed, velocity=velocity)
    assert max(check(page, {}).verdicts, key=lambda v: v.span).verdict == word
