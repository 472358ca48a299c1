"""The author's page between its relations: one text in six markups comes out as the same blocks."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from symbalance.checking import check
from symbalance.document.html_document import document_html
from symbalance.notes.checking.reports.marked_page import marked_page
from symbalance.notes.checking.reports.page_prose import DISPLAY, END, INLINE, Prose

MARK = f"{INLINE}0{END}"
SHOWN = f"{DISPLAY}1{END}"
PAGES = {
    ".md": f"# Work\n\nIt is **good** that ${MARK}$ and $r$ stay.\n\n$${SHOWN}$$\n\n- one\n- two\n\n"
    "| a | b |\n|---|---|\n| 1 | $q$ |\n",
    ".tex": "\\documentclass{article}\\title{Not here}\n\\begin{document}\n\\section{Work} % a remark\n"
    f"It is \\textbf{{good}} that ${MARK}$ and \\(r\\) stay.\n"
    f"\\begin{{equation}}\n  {SHOWN}\\label{{x}}\n"
    "\\end{equation}\n\\begin{itemize}\\item one \\item two\\end{itemize}\n"
    "\\begin{tabular}{ll}\n\\toprule a & b \\\\ \\midrule 1 & $q$ \\\\ \\bottomrule\n\\end{tabular}\n"
    "\\end{document}\nnothing",
    ".wiki": f"== Work ==\nIt is '''good''' that <math>{MARK}</math> and <math>r</math> stay.\n"
    f": <math>{SHOWN}</math>\n* one\n* two\n\n"
    '{| class="wikitable"\n! a !! b\n|-\n| 1 || <math>q</math>\n|}\n',
    ".html": f"<html><head><title>x</title></head><body><h2>Work</h2><p>It is <b>good</b> that {MARK} "
    f"and <math><mi>r</mi></math> stay.</p>{SHOWN}<ul><li>one</li><li>two</li></ul>"
    "<table><tr><th>a</th><th>b</th></tr><tr><td>1</td><td>\\(q\\)</td></tr></table></body></html>",
    ".adoc": f"== Work\n\nIt is *good* that stem:[{MARK}] and stem:[r] stay.\n\n[stem]\n++++\n{SHOWN}\n"
    "++++\n\n* one\n* two\n\n|===\n|a |b\n\n|1 |stem:[q]\n|===\n",
}


def blocks(suffix: str, text: str) -> list[object]:
    prose = Prose(text, suffix)

    def said(text: str) -> str:
        return "".join(f"<{k} {c}>" if k != "text" else c for k, c in prose.inline(text)).strip()

    return [
        (each.kind, [[said(cell) for cell in row] for row in each.rows], each.has_head)
        if each.rows
        else (each.kind, said(each.text))
        for each in prose.stretches()
        if each.rows or said(each.text)
    ]


@pytest.mark.parametrize("suffix", PAGES)
def test_every_markup_says_the_same(suffix: str) -> None:
    table = [["a", "b"], ["1", "<formula q>"]]
    assert [b for b in blocks(suffix, PAGES[suffix]) if b != ("paragraph", "Not here")] == [
        *([("heading", "Not here")] if suffix == ".tex" else []),
        ("heading", "Work"),
        ("paragraph", "It is <strong good> that <relation 0> and <formula r> stay."),
        ("relation", "1"),
        ("item", "• one"),
        ("item", "• two"),
        ("table", table, True),
    ]


def test_a_plain_text_keeps_its_lines_and_its_signs() -> None:
    text = f"Work\n====\nwe take *all* of it, 5 $\n{SHOWN}\nso r_1 stays"
    assert blocks(".txt", text) == [
        ("paragraph", "Work"),
        ("paragraph", "we take *all* of it, 5 $"),
        ("relation", "1"),
        ("paragraph", "so r_1 stays"),
    ]


def test_macros_and_units_of_a_latex_page_are_typeset_in_its_prose(tmp_path: Path) -> None:
    path = tmp_path / "page.tex"
    path.write_text(
        "\\newcommand{\\kw}{\\varphi}\n\\begin{document}\nUm \\ang{90} versetzt ist $\\kw$, gro\\ss{} "
        'und \\"ahnlich; $r = \\SI{40}{mm}$.\n\\end{document}\n',
        encoding="utf-8",
    )
    page = check(path, {"phi": "crank angle", "r": "crank radius"})
    assert page.verdicts
    html = document_html(marked_page(page))
    for raw in ("\\ang", "\\kw", "\\SI{40}", "1000"):
        assert raw not in html.replace("<code>\\SI{40}{mm}</code>", "")
    assert "groß und ähnlich" in html
    assert re.search(r"<mn>40</mn>(<mspace[^>]*></mspace>)?<mtext>mm</mtext>", html)


HOSTILE = [
    "$" * 3000,
    "\\textbf{" * 3000,
    "{|\n" * 2000,
    "<math>" * 3000,
    "|===\n" * 3000,
    "**" * 5000,
    "[" * 5000 + "](",
    "\\begin{tabular}" * 2000,
    "<table>" * 3000,
    "`" * 5001,
]


@pytest.mark.parametrize("suffix", [".md", ".tex", ".wiki", ".html", ".adoc", ".txt"])
@pytest.mark.slow
def test_what_is_never_closed_costs_no_more_than_it_is_long(suffix: str) -> None:
    """A page of one unclosed sign, ten thousand times, is read through; each is under a second here."""
    for text in HOSTILE:
        prose = Prose(text, suffix)
        for stretch in prose.stretches():
            for each in (stretch.text, *(cell for row in stretch.rows for cell in row)):
                assert all(kind for kind, _ in prose.inline(each))


@pytest.mark.parametrize(
    ("between", "words"),
    [
        (r", \qquad", []),
        (r"\quad\therefore\quad", [("paragraph", "∴")]),
        (r", \qquad\text{or in numbers } ", [("paragraph", ",   or in numbers")]),
        (r" \Leftrightarrow ", [("paragraph", "⇔")]),
    ],
)
@pytest.mark.parametrize("signs", [("$$", "$$"), (r"\[", r"\]")])
def test_what_stands_between_the_relations_of_a_display_is_words(
    between: str, words: list[object], signs: tuple[str, str]
) -> None:
    text = f"First\n\n{signs[0]} {SHOWN}{between}{DISPLAY}2{END} {signs[1]}\n\nlast"
    shown = [(kind, " ".join(str(said).split())) for kind, said in blocks(".md", text)]  # type: ignore[misc]
    expected = [(kind, " ".join(said.split())) for kind, said in words]  # type: ignore[misc]
    assert shown == [
        ("paragraph", "First"), ("relation", "1"), *expected, ("relation", "2"), ("paragraph", "last"),
    ]  # fmt: skip


def test_formulas_between_tags_stand_in_markdown_too(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "The ratio <math>\\lambda</math>, with <math>s = 73 \\text{ mm}</math>, is <math>r</math>.\n"
    )
    document = document_html(marked_page(check(page)))
    assert "&lt;" not in re.sub(r"<code>.*?</code>", "", document)
    assert "<mi>λ</mi>" in document
