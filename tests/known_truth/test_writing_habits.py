"""How formats and authors mark what is no formula: tables, templates, forum posts, AsciiMath."""

from __future__ import annotations

import pytest

from symbalance.checking import check

YES = "holds holds_to_order conditional"
GIVEN = "definition premise condition range"
NO = "refuted contradiction"
PAGES = [
    (
        "two columns of quantities",
        ".md",
        "| Größe | Wert |\n|:--|--:|\n| $r$ | 40 mm |\n| $m$ | 0,5 kg |\n| $\\omega$ | 600 1/s |\n"
        "| $m r\\omega^2$ | 7200 N |\n| $2 m r\\omega^2$ | 14 500 N |\n",
        [GIVEN, GIVEN, GIVEN, YES, NO],
    ),
    (
        "a formula in the second column",
        ".md",
        "| quantity | formula |\n|---|---|\n"
        "| F_1 | $\\cos\\theta$ |\n| $F_2$ | $F_1+2$ |\n| $F_2-F_1$ | 3 |\n",
        [GIVEN, GIVEN, NO],
    ),
    ("a column of units", ".md", "| symbol | unit |\n|---|---|\n| F | N |\n| v | m/s |\n", []),
    ("a column of words", ".md", "| symbol | meaning |\n|---|---|\n| r | crank radius |\n", []),
    ("labels of bodies", ".md", "| cylinder | angle |\n|---|---|\n| A | 120° |\n", []),
    (
        "a table of LaTeX",
        ".tex",
        "\\begin{tabular}{l|l}\nSymbol & Value \\\\ \\hline\n"
        "$u$ & $3v$ \\\\\n$u+v$ & $4v$ \\\\\n$u-v$ & $2v-v$ \\\\\n"
        "\\end{tabular}\n",
        [GIVEN, YES, NO],
    ),
    (
        "fractions and roots of templates",
        ".wiki",
        "''T'' = {{frac|3|2}} ''a'' = {{sfrac|6|4}} ''a'' = {{frac|4|2}} ''a''\n\n"
        "''b'' = {{math|''c''<sup>2</sup>}} + {{sqrt|4}} = {{math|''c''<sup>2</sup>}} + 2\n\n"
        "2{{pi}} {{=}} 6.283",
        [GIVEN, YES, NO, GIVEN, YES, YES],
    ),
    ("a template that is not known", ".wiki", "''y'' = {{convert|1|ft}} + 2", ["unreadable"]),
    (
        "marks of a forum",
        ".txt",
        "[code]cos(0) + cos(180°) = 0[/code]\n"
        "[b]F = 3[/b] and x[sub]1[/sub] = 2[sup]3[/sup] = 9\n[tex]\\frac12 = 0.5[/tex]",
        [YES, GIVEN, GIVEN, NO, YES],
    ),
    (
        "a quotation that is set in",
        ".txt",
        "  > I took 50% of it:  m_b = 0.5*m_rec , m_rec = 0.6 kg\n"
        "  > so  m_b = 0.3 kg\n  > so  m_b = 0.4 kg\n",
        [GIVEN, GIVEN, YES, NO],
    ),
    (
        "words of AsciiMath",
        ".adoc",
        ":stem: asciimath\n\n"
        "The energy stem:[E = 1/2 J omega^2] with stem:[J = 0.5] and stem:[omega = 100] is\n"
        "stem:[E = 2500], and stem:[2 xx 3 = 7].\n",
        [f"{GIVEN} conditional", GIVEN, GIVEN, YES, NO],
    ),
    (
        "a thin space within a unit",
        ".html",
        "<p>20 g · 50 mm = 1000 g&thinsp;mm</p>"
        "<p>20 g · 50 mm = 1100 g&thinsp;mm</p><p>20 g · 50 mm = 1000 g</p>",
        [YES, NO, NO],
    ),
    ("a mixed number", ".html", "<p>D = 3&frac12; in = 88.9 mm = 89.9 mm</p>", [GIVEN, YES, NO]),
    (
        "kerns, and i of a macro",
        ".tex",
        "\\newcommand{\\ii}{\\mathrm{i}\\mkern1mu}\n$(1+\\ii)^2 = 2\\ii$, $(1+\\ii)^2 = -2\\ii$",
        [YES, NO],
    ),
    (
        "thousands behind a dollar",
        ".md",
        "$F$ = 14 500 N, $p$ = 1 200 000 Pa = 12 bar = 13 bar",
        [GIVEN, GIVEN, YES, NO],
    ),
    ("an arrow between two numbers", ".txt", "x = 3 => 2", ["unreadable", GIVEN]),
]


@pytest.mark.parametrize(
    ("suffix", "text", "expected"), [p[1:] for p in PAGES], ids=[p[0] for p in PAGES]
)
def test_every_relation_of_the_page_is_judged_for_what_it_is(tmp_path, suffix, text, expected):
    page = tmp_path / f"page{suffix}"
    page.write_text(text, encoding="utf-8")
    checked = check(page, None)
    words = [v.verdict for v in checked.verdicts if v.verdict != "not_mathematics"]
    assert len(words) == len(expected), words
    assert all(word in allowed.split() for word, allowed in zip(words, expected, strict=True)), words


COLUMNS = """up at TDC    0.45 x 13578 = 6110 N    0.30 x 13578 = 4073 N

   P = m r w^2                ...once per rev

   a = b    + c
"""


def test_formulas_in_columns_of_a_line_are_apart(tmp_path):
    page = tmp_path / "page.txt"
    page.write_text(COLUMNS, encoding="utf-8")
    checked = check(page)
    assert [v.verdict for v in checked.verdicts[:2]] == ["holds_to_order", "holds_to_order"]
    assert not checked.derivation.unreadable
    assert len(checked.verdicts) == 4
