"""What stands below "Punkt φ = 90°" is of that angle; numbers of the case before end with its section."""

from __future__ import annotations

import pytest

from symbalance.checking import check

SYMBOLS = """[symbols]
r = "Kurbelradius"
l = "Pleuellänge"
"\\\\varphi" = "Kurbelwinkel ab OT"
"\\\\beta" = "Pleuelwinkel"
F = "Stangenkraft"
"""
CASES = r"""Der Pleuelwinkel folgt aus $r\sin\varphi = l\sin\beta$.

## {first}

Die Kraft ist $F\sin(\varphi+\beta) = 19726\cdot 0.63$ N.

## {second}

Hier ist $\sin(\varphi+\beta) = \{wave}\beta$.
"""
HEADINGS = [
    ("Punkt φ = 30°", "Punkt φ = 90°"),
    ("Point φ = 30°", "Point φ = 90°"),
    ("Case 1: $\\varphi = 30°$", "Case 2: $\\varphi = 90°$"),
    ("Stellung A (φ = 30°)", "Stellung B (φ = 90°)"),
    ("Anfang, φ = 30°", "Mitte, φ = 90°"),
    ("位置 φ = 30°", "位置 φ = 90°"),
]
IN_WORDS = [
    r"Bei 90° ist $\sin(\varphi+\beta) = \{wave}\beta$.",
    r"At a crank angle of 90° we get $\sin(\varphi+\beta) = \{wave}\beta$.",
    r"À 90°, on a $\sin(\varphi+\beta) = \{wave}\beta$.",
    "## At 90°\n\nHere " + r"$\sin(\varphi+\beta) = \{wave}\beta$.",
    r"90°のとき $\sin(\varphi+\beta) = \{wave}\beta$ である。",
]


@pytest.mark.parametrize(("first", "second"), HEADINGS)
def test_a_heading_with_an_angle_opens_a_case(tmp_path, first, second):
    right = CASES.replace("{first}", first).replace("{second}", second)
    assert _words(tmp_path, right.replace("{wave}", "cos"))[-1] == "conditional"
    assert not {"refuted", "contradiction"} & {*_words(tmp_path, right.replace("{wave}", "cos"))}
    assert _words(tmp_path, right.replace("{wave}", "sin"))[-1] == "refuted"
    another = right.replace("90°", "60°").replace("{wave}", "cos")
    assert _words(tmp_path, another)[-1] == "refuted"


@pytest.mark.parametrize("line", IN_WORDS)
def test_an_angle_in_words_is_the_cranks(tmp_path, line):
    before = r"Der Pleuelwinkel folgt aus $r\sin\varphi = l\sin\beta$." + "\n\n"
    assert _words(tmp_path, before + line.replace("{wave}", "cos"))[-1] == "conditional"
    assert _words(tmp_path, before + line.replace("{wave}", "sin"))[-1] == "refuted"
    assert _words(tmp_path, before + line.replace("90", "60").replace("{wave}", "cos"))[-1] == "refuted"


def _words(folder, text):
    (folder / "page.symbols.toml").write_text(SYMBOLS, encoding="utf-8")
    path = folder / "page.md"
    path.write_text(text, encoding="utf-8")
    return [v.verdict for v in check(path, fixes=False).verdicts]


@pytest.mark.parametrize(("number", "is_wrong"), [("50.0", False), ("86.6", True)])
def test_a_number_printed_at_one_angle_is_none_at_the_next(number, is_wrong):
    page = (
        "$r = 50.0$ mm.\n\n## φ = 30°\n\n$h = r\\cos\\varphi = 43.3$ mm\n\n"
        f"## φ = 60°\n\n$2h = {number}$ mm\n"
    )
    last = check(page, {}).data()["links"][-1]
    assert (last["verdict"] == "refuted") is is_wrong
