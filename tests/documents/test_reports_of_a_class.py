"""Reports of a class: every error is reached, evidence is the letter's own, pages print whole."""

from __future__ import annotations

import json
import re

import pytest

import symbalance as sb
from symbalance.checking import check
from symbalance.document.result import to_html
from symbalance.notes import verify_certificates
from symbalance.notes.checking.reports import document_table
from symbalance.notes.checking.reports.document_table import DocumentRow, DocumentTable

LETTERS = {"theta": "crank angle", "r": "crank radius", "l": "rod length", "m": "mass, kg"}


def table(*pages: str, letters: dict[str, str] | None = LETTERS) -> DocumentTable:
    rows = (
        DocumentRow(f"{k}.md", check(page, letters).data(), 1, file=f"{k}.md.html")
        for k, page in enumerate(pages)
    )
    return DocumentTable(tuple(rows))


def test_every_error_of_every_document_is_reached(monkeypatch):
    monkeypatch.setattr(document_table, "MOST_ERRORS", 2)
    monkeypatch.setattr(document_table, "MOST_PLACES", 1)
    pages = [f"$\\sin {k}\\theta = \\cos {k}\\theta$\n\n$m = m r$\n" for k in range(1, 7)]
    several = table(*pages)
    html = to_html(several)
    assert all(f'"{k}.md.html#line-{line}"' in html for k in range(6) for line in (1, 3))
    errors = several.data()["errors"]
    assert len(errors) == 7
    assert [each["document"] for each in errors[0]["documents"]] == [f"{k}.md" for k in range(6)]
    assert {place for each in errors[0]["documents"] for place in each["places"]} == {"3"}


def test_what_is_wrong_is_told_from_what_was_not_read():
    several = table("$r = 2r$\n\n$x = \\wr$\n", "$x = \\wr$\n")
    text = sb.to_text(several)
    wrong, unread = (
        text.index(f"{title}, the commonest first") for title in ("What is wrong", "Not read")
    )
    assert wrong < text.index("r = 2r") < unread < text.index("unknown command")


def test_one_error_in_two_notations_is_one():
    pages = ["$\\sin\\left(2\\theta\\right) = \\sin \\theta$\n", "$\\sin(2\\theta) = \\sin\\theta$\n"]
    (error,) = table(*pages).data()["errors"]
    assert [each["places"] for each in error["documents"]] == [["1"], ["1"]]
    assert error["error"].startswith("sin 2θ = sin θ")


def test_a_documents_own_macros_are_typeset_in_the_index():
    page = "\\newcommand{\\w}{\\omega}\n\n$\\w + \\w = \\w$\n"
    (error,) = table(page, letters=None).data()["errors"]
    assert error["error"].startswith("ω + ω = ω")


def test_what_is_to_be_declared_stands_behind_the_page_and_what_its_words_say_is_said():
    page = "Let $\\theta$ be the crank angle, $r$ the crank radius and $l$ the rod length.\n\n"
    page += "The displacement from top dead centre is $x = r(1-\\cos\\theta) + l(1-\\cos\\beta)$.\n\n"
    page += "$\\theta + k = \\theta$\n"
    html = to_html(check(page))
    assert html.index("Not decided") < html.index("The page") < html.index("--declare")
    (unsaid,) = re.findall("Nobody has said what these letters mean: ([^.]*)", html)
    assert "θ" not in unsaid.split(", ")
    assert "k" in unsaid.split(", ")


@pytest.mark.parametrize(
    ("intro", "letter", "evidence"),
    [
        (
            "Notation: $\\theta$ crank angle, $r$ crank radius, $l$ rod length, $\\rho = r/l$.",
            "ρ",
            "\\rho = r/l",
        ),
        ("$\\theta$: crank angle; $r$: crank radius; $l$: rod length; $\\rho = r/l$", "ρ", "\\rho = r/l"),
    ],
)
def test_evidence_is_of_its_own_letter(intro, letter, evidence):
    page = f"{intro}\n\nThe rod leans by $\\beta$, where $\\sin\\beta = \\rho\\sin\\theta$.\n"
    words = ", ".join(verdict.assumption for verdict in check(page).verdicts)
    assert f"{letter} is the crank ratio r/l, by “{evidence}”" in words


@pytest.mark.parametrize(
    ("typed", "shown"),
    [
        ("Speed $n = 6000$ rpm.", "<mn>6000</mn>.{0,60}<mtext>rpm</mtext>"),
        ("Drehzahl $n = 6000$ min$^{-1}$.", "<mn>6000</mn>.{0,60}<mtext>min⁻¹</mtext>"),
        ("$$F = \\sqrt2\\cdot 0.25$$", "</msqrt><mo>·</mo><mn>0.25"),
        ("$$F = \\sin(1)\\cdot 3$$", "<mo>·</mo><mn>3"),
        ("$$F = (0.45 + 0.60)\\cdot 33$$", "<mo>\\)</mo></mrow><mo>·</mo><mn>33"),
        ("$$\\varphi = 2$$", "<mi>φ</mi>"),
        ("$$\\phi = 2$$", "<mi>ϕ</mi>"),
        ("φ = 2", "<mi>φ</mi>"),
        ("$$F_x^{(2)} = 2$$", "<msubsup><mi>F</mi><mi>x</mi><mi>\\(2\\)</mi></msubsup>"),
        ("$$F^{(1)} = 2$$", "<msup><mi>F</mi><mi>\\(1\\)</mi></msup>"),
    ],
)
def test_a_line_is_set_as_it_was_typed(typed, shown):
    page = f"{typed}\n\n$\\omega = 2\\pi n/60 = 628.3$ rad/s\n"
    assert re.search(shown, to_html(check(page)))


def test_code_stands_as_it_was_typed(tmp_path):
    path = tmp_path / "page.md"
    path.write_text("```python\nfor k in range(3):\n    print(k)\n```\n\n$1 + 1 = 2$\n", encoding="utf-8")
    html = to_html(check(path))
    assert "<pre><code>for k in range(3):\n    print(k)</code></pre>" in html


def test_no_point_is_left_behind_a_formula_on_its_own_line():
    html = to_html(check("Betrag:\n\n$$F = 2$$\n. Massenkraft zweiter Ordnung\n", {"F": "N"}))
    assert "<p>Massenkraft zweiter Ordnung</p>" in html


def test_print_opens_what_is_wrong():
    assert re.search(
        r"@media print\{\s*\.symbalance \.wrong::details-content", to_html(check("$1 = 2$\n"))
    )


def test_a_notebooks_reasons_name_cells(tmp_path):
    sources = ["$x > 2$ and $m = 3$", "Second line.\n\n$m + x = 5$", "$m = 4$"]
    cells = [{"cell_type": "markdown", "source": [source]} for source in sources]
    path = tmp_path / "n.ipynb"
    path.write_text(json.dumps({"nbformat": 4, "metadata": {}, "cells": cells}), encoding="utf-8")
    reasons = " ".join(verdict.reason for verdict in check(path, {"x": "1", "m": "1"}).verdicts)
    assert re.search(r"\blines? 1:1\b", reasons)
    assert not re.search(r"\blines? [0-9]+(?![0-9:])", reasons)


@pytest.mark.parametrize(
    "relation",
    [
        "(l - r)^2 = l^2 - r^2", "(R + L)^2 = R^2 + L^2", "(m_o + R)^2 = m_o^2 - R^2",
        "l r + \\sin x = l r - \\sin x", "(a + b)(a - b) = a^2 + b^2",
        "\\frac{m_1}{r} + m_1 r = \\frac{r}{m_1} + r",
    ],
)  # fmt: skip
def test_a_witness_has_sizes_of_a_machine(relation):
    (verdict,) = check(f"$${relation}$$").verdicts
    point = {n: float(text) for n, text in verdict.witness.items() if n not in ("left", "right")}
    assert verdict.verdict == "refuted"
    assert min(point.values()) > 0
    assert point.get("l", 2e9) > point.get("r", 1e9)
    assert point.get("L", 2e9) > point.get("R", 1e9)
    shown = re.search("witness: (.*)", sb.to_text(check(f"$${relation}$$")))
    assert shown is None or not re.search("[1-9][0-9]{6}", shown[1].replace(".", ""))


def test_sides_that_differ_only_below_zero_are_refuted_there():
    (verdict,) = check("$$\\sqrt{x^2} + 1 = x + 1$$", {"x": "real"}).verdicts
    assert verdict.verdict in ("refuted", "conditional", "undecided")
    assert verdict.witness.get("left", "0") != verdict.witness.get("right", "1")


def test_what_has_no_proof_is_not_counted_as_verified(tmp_path, capsys):
    certificates = [{"proof": "nothing", "line": 1, "why": "an arrow"}]
    path = tmp_path / "c.json"
    path.write_text(json.dumps({"certificates": certificates}), encoding="utf-8")
    assert verify_certificates.main([str(path)]) == 0
    assert capsys.readouterr().out == "0 verified, 0 rejected; 1 have no proof to retrace\n"


@pytest.mark.parametrize("unit", ["m/s", "kg", "kN"])
def test_the_index_shows_the_unit_that_is_wrong(unit):
    page = f"$F = 2\\,\\mathrm{{N}}$ is so small that $2 F = 4\\,\\mathrm{{{unit}}}$\n"
    errors = table(page, letters={"F": "N"}).data()["errors"]
    assert errors
    assert all(f"4{unit}" in each["error"].replace(" ", "") for each in errors)
