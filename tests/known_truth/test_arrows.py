r"""Arrows between two relations: each has an entry of its own, judged by what it leads to.

Expected of each page is what `arrow_words` returns: the sign, the verdict, and the relation to the right.
"""

import pytest

import symbalance as sb
from symbalance.checking import check
from symbalance.notes.checking.reports.document_table import DocumentRow, DocumentTable
from symbalance.notes.checking.verdicts import BAD, DEFINITION, FAILING, PROVED_WORDS, STATED, Verdict

LETTERS = dict.fromkeys("abcmrF", "positive") | {"x": "variable", "y": "variable", "z": "variable"}


def arrows(page: str) -> list[Verdict]:
    return [verdict for verdict in check(page + "\n", LETTERS).verdicts if verdict.sign]


RIGHT = [
    r"$2x = 6 \Rightarrow x = 3$",
    r"$2x = 6 \implies x = 3$",
    r"$$2x = 6 \Longrightarrow x = 3$$",
    r"$2x = 6$ ⇒ $x = 3$",
    "2x = 6 => x = 3",
    "2x = 6 ==> x = 3",
    "2x = 6\n=> x = 3",
    "$$2x = 6$$\n\n$$\\Rightarrow x = 3$$",
    "\\begin{align}\n2x &= 6 \\\\\n\\Rightarrow\\quad x &= 3\n\\end{align}",
    "| $2x = 6$ | $\\Rightarrow x = 3$ |",
    r"$2x = 6 \iff x = 3$",
    "2x + 4 = 10 <=> x = 3",
    "2x + 4 = 10 ⇔ x = 3",
    r"$y = 3 \Rightarrow -y = -3$",
    "a + b = c ⇒ - a = b - c",
    r"$F = m b \Leftrightarrow b = \frac{F}{m}$",
    r"$(a + b) x = c \Leftrightarrow x = \frac{c}{a + b}$",
    r"$y > 3 \Leftrightarrow -y < -3$",
    r"$\sin^2 x = 1 - \cos^2 x \Rightarrow \sin^2 x + \cos^2 x = 1$",
    r"$\sin^2 x = 1 - \cos^2 x \Leftrightarrow \sin^2 x + \cos^2 x = 1$",
    "2x = 6 (equation 3) ⇒ x = 3",
    "2x = 6 => so x = 3",
    r"$$2x = 6 \Rightarrow\text{ hence } x = 3$$",
]


@pytest.mark.parametrize("page", RIGHT)
def test_an_arrow_holds_where_its_conclusion_follows(page):
    (arrow,) = arrows(page)
    assert arrow.verdict in PROVED_WORDS
    assert (arrow.sign == "⇔") == any(sign in page for sign in ("iff", "<=>", "⇔", "Leftright"))


WRONG = [
    r"$2x = 6 \Rightarrow x = 4$",
    r"$2x = 6 \iff x = 4$",
    "2x = 6 => x = 12",
    "a + b = c ⇒ - a = c - b",
    r"$y = 3 \Rightarrow -y = 3$",
    r"$F = m b \Rightarrow b = F m$",
    r"$F = m b \Leftrightarrow b = \frac{m}{F}$",
    r"$(a + b) x = c \Leftrightarrow x = \frac{c}{a - b}$",
    r"$y > 3 \Leftrightarrow -y > -3$",
    r"$\sin^2 x = 1 - \cos^2 x \Rightarrow \sin^2 x + \cos^2 x = 2$",
    r"$\sin^2 x = 2 - \cos^2 x \Rightarrow \sin^2 x + \cos^2 x = 3$",
    r"$x = 2 \Leftrightarrow x^2 = 4$",
    r"$|x| = 3 \Leftrightarrow x = 3$",
    r"$\sqrt{x^2} = 3 \Leftrightarrow x = 3$",
    r"$x y = x z \Leftrightarrow y = z$",
    r"$(x + 1) y = (x + 1) z \Leftrightarrow y = z$",
]


@pytest.mark.parametrize("page", WRONG)
def test_an_arrow_to_what_does_not_follow_never_holds(page):
    (arrow,) = arrows(page)
    assert arrow.verdict in BAD


def test_a_refuted_conclusion_refutes_its_arrow_with_the_same_witness():
    arrow, conclusion = check("$x = 2 \\Rightarrow x^2 = 5$\n", LETTERS).verdicts[1:]
    assert (arrow.verdict, arrow.sign, arrow.left, arrow.source) == ("refuted", "⇒", "x = 2", "x^2 = 5")
    assert arrow.witness == conclusion.witness
    assert "to its right, x^2 = 5, is wrong" in arrow.reason


def test_a_new_letter_behind_an_arrow_is_a_definition():
    (arrow,) = arrows("$F = m r \\Rightarrow q = \\frac{m}{4}$")
    assert arrow.verdict == DEFINITION
    assert arrow.reason == "its conclusion introduces q"


def test_what_rightly_follows_from_a_wrong_line_is_not_accused():
    page = "$r = 2 m$\n\n$r = 3 m \\Rightarrow \\frac{r}{3} = m$"
    (arrow,) = arrows(page)
    assert arrow.verdict in ("holds", "conditional")
    assert "which is refuted" in f"{arrow.reason} {arrow.assumption}"


@pytest.mark.parametrize(
    "page",
    [
        "The force vanishes ⇒ F = 0",
        "F = 0 ⇒ the engine is balanced",
        "For x → 0 it is y = 3",
        "F = 0. The engine is balanced, and the second order remains => y = 3",
        "x = 3 and use a => b as a mapping",
        "$f: x \\rightarrow y$ and $x = 3 \\to y = 4$",
    ],
)
def test_an_arrow_to_or_from_words_is_no_relation(page):
    assert arrows(page) == []


def test_arrows_stand_in_the_account_and_leave_the_numbers_of_relations():
    report = check("$2x = 6 \\Rightarrow x = 3 \\Rightarrow x + 1 = 4$\n", LETTERS)
    data = report.data()
    assert data["seen"] == sum(data["counts"].values()) == 5
    assert [(e["link"], e["sign"]) for e in data["links"]] == [
        (1, "="),
        (4, "⇒"),
        (2, "="),
        (5, "⇒"),
        (3, "="),
    ]
    assert data["links"][1]["left"] == "2x = 6"
    assert data["links"][1]["column"] == 9


def test_an_arrow_to_what_is_not_read_is_not_read():
    (arrow,) = arrows("$x = 3 \\Rightarrow y = \\foo$")
    assert arrow.verdict in FAILING


@pytest.mark.parametrize("medium", [sb.to_text, sb.to_html, sb.to_latex])
def test_every_medium_shows_an_arrow_with_both_its_relations(medium):
    shown = medium(check("$2x = 6 \\Rightarrow x = 4$\n", LETTERS))
    assert "2x = 6 ⇒ x = 4" in shown or "2x =\\allowbreak{} 6 $\\Rightarrow$ x =" in shown


def test_kinds_of_verdicts_pass_on():
    words = [arrows(f"$F = 1 \\Rightarrow {each}$")[0].verdict for each in ("x > 3", "q = 4", "x = 3")]
    assert set(words) <= set(STATED)


def test_an_error_is_listed_once_and_not_for_the_arrow_to_it_too(tmp_path):
    (tmp_path / "one.md").write_text("$2x = 6 \\Rightarrow x = 4$\n", encoding="utf-8")
    (tmp_path / "two.md").write_text("$x = 2$\n\n$x = 2 \\iff x + x^2 = 6$\n", encoding="utf-8")
    pages = [check(tmp_path / name, {"x": "variable"}) for name in ("one.md", "two.md")]
    rows = tuple(DocumentRow(p.derivation.name, p.data(), 1) for p in pages)
    shown = sb.to_text(DocumentTable(rows))
    assert shown.count("contradiction: x = 4") == 1
    assert "⇒" not in shown
    assert sb.to_html(pages[0]).count("line-1-3") == 1


def test_records_and_verdicts_alone_say_what_an_arrow_joins():
    report = check("$2x = 6 \\Rightarrow x = 4$\n", LETTERS)
    assert "2x = 6 ⇒ x = 4" in [row["source"] for row in report.records()]
    (arrow,) = [v for v in report.verdicts if v.sign]
    data = arrow.data()
    assert (data["left"], data["sign"], data["source"]) == ("2x = 6", "⇒", "x = 4")
