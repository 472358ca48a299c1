"""A relation is judged whole or not at all, and in one reading throughout a document."""

import pytest

from symbalance.checking import check

LETTERS = {"t": "angle", "x": "a letter", "y": "a letter", "z": "a letter", "q": "a letter"}
RIGHT = ("cos 2t = 1 − 2 sin²t", "sin 2t = 2 sin t cos t", "(x + 1)² = x² + 2x + 1", "sin²t + cos²t = 1")
IN_LATEX = (r"\cos 2t = 1 - 2\sin^2 t", r"\sin 2t = 2\sin t\cos t", r"(x+1)^2 = x^2 + 2x + 1")
TAILS = (
    *(
        " plus 3",
        " minus 1",
        " times 3",
        " over 2",
        " divided by 2",
        " mal 3",
        " geteilt durch 2",
        " — 1",
    ),
    *(" and so + 3", " percent", " thousand", " plus the rest", " + O(3)", ", + 3", "·0,038", " squared"),
)
JUDGED_RIGHT = {"holds", "holds_to_order", "conditional", "definition", "premise", "condition", "range"}


@pytest.mark.parametrize("tail", TAILS)
@pytest.mark.parametrize("sentence", ["{}", "We know that {} here.", "Then {}"])
def test_what_goes_on_is_not_cut_off(sentence, tail):
    for right in RIGHT[:2]:
        report = check(sentence.format(right + tail) + "\n\n", LETTERS)
        verdicts = [v.verdict for v in report.verdicts]
        assert verdicts, tail
        assert not set(verdicts) & JUDGED_RIGHT, (right + tail, verdicts)
        assert report.fails()


WORDS_IN_DISPLAY = (
    r"\text{ and so } + 3",
    r"\text{ times } 3",
    r" \text{ plus } x",
    " — 1",
    r"\text{ minus } 1",
)


@pytest.mark.parametrize("tail", WORDS_IN_DISPLAY)
@pytest.mark.parametrize("right", IN_LATEX)
def test_a_display_is_not_cut_at_its_words(right, tail):
    for page in (f"$${right}{tail}$$", f"\\begin{{align}}\n{right}{tail} \\\\\n\\end{{align}}"):
        verdicts = [v.verdict for v in check(page + "\n", LETTERS).verdicts]
        assert verdicts
        assert not set(verdicts) & JUDGED_RIGHT, (page, verdicts)


@pytest.mark.parametrize(
    "tail", [" plus 3", " times 2", " + $x$", " − 3", " of it, divided by 2", " percent"]
)
def test_a_formula_in_dollars_is_not_cut_at_the_dollar(tail):
    tail = tail.replace(" of it,", "")
    (verdict,) = check(f"We have ${IN_LATEX[0]}${tail} there.\n", LETTERS).verdicts
    assert verdict.verdict == "unreadable"


@pytest.mark.parametrize("head", ["Masse + ", "Kraft · ", "7 times 3 + ", "twice ", "half of "])
def test_what_stands_before_is_not_cut_off(head):
    verdicts = [v.verdict for v in check(f"Nun ist {head}x + y = x + y\n", LETTERS).verdicts]
    assert verdicts == ["unreadable"]


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [
        ("7 times x = 6x + x", "holds"),
        ("7 times x = 6x + y", "refuted"),
        ("7 times q = 8·q + 1 − q", "refuted"),
        ("3 % of x = 0.03 x", "holds"),
        ("twice x = x + x", "holds"),
    ],
)
def test_a_multiple_in_words_is_a_part_of_its_relation(relation, verdict):
    assert [v.verdict for v in check(f"Nun ist {relation}\n", LETTERS).verdicts] == [verdict]


@pytest.mark.parametrize(
    "sentence",
    [
        "{} — the double angle.",
        "{}, as we know.",
        "({})",
        "{} for all angles",
        "{} and then the rest follows",
        "So {}; the rest is clear.",
        "{} - a known identity",
        "{} (see page 3).",
    ],
)
def test_prose_around_a_right_relation_does_not_hide_it(sentence):
    for right in RIGHT:
        verdicts = [v.verdict for v in check(sentence.format(right) + "\n\n", LETTERS).verdicts]
        assert verdicts == ["holds"], sentence.format(right)


def test_a_slash_and_a_number_are_read_alike_throughout():
    page = "x/2 + x/2 = 1/2x + 1/2x\n1/2x + 3/2x = 2x\n1/2x = 1/(2x)\n"
    report = check(page, LETTERS)
    assert [v.verdict for v in report.verdicts] == ["holds", "holds", "refuted"]
    assert "1/2x is read as (1/2)x" in report.derivation.notes
    assert [v.notes for v in report.verdicts] == [
        ("1/2x read as 1/(2x), it would be: refuted",),
        ("1/2x read as 1/(2x), it would be: refuted",),
        ("1/2x read as 1/(2x), it would be: holds",),
    ]


def test_the_usual_reading_is_taken_where_both_do_and_fractions_with_a_bar_are_never_in_doubt():
    usual = check("y = 1/2x\n2 x y = 1\n", LETTERS)
    assert "1/2x is read as 1/(2x)" in usual.derivation.notes
    assert [v.verdict for v in usual.verdicts] == ["definition", "holds"]
    assert check(r"$$\frac12x + \frac12x = x$$" + "\n", LETTERS).derivation.notes == ()


REFUSALS = [
    (r"$x = \int_0^1 q\,\foo$", "foo"),
    (r"\newcommand{\a}{\a} $x = \a$", "macro \\a"),
    (r"\def\p(#1){x} $x = \p(3)$", "macro \\p"),
    (r"$x = \SI{3 +- 1}{mm}$", "quantity"),
    (r"$x = \SI{3}{\furlong}$", "quantity"),
    (r"$\overset{n}{x} = 3$", "above or below"),
    (r"$x = \underset{a}{y}$", "above or below"),
]


@pytest.mark.parametrize(("page", "name"), REFUSALS)
def test_a_refusal_names_the_construct_and_what_would_be_needed(page, name):
    verdicts = check(page + "\n", LETTERS).verdicts
    assert {v.verdict for v in verdicts} == {"unreadable"}
    assert name in verdicts[0].reason or "integrals" in verdicts[0].reason
    assert ";" in verdicts[0].reason  # what, then the remedy


MACROS = [
    (r"\newcommand{\h}{\frac12}", r"\h x + \h x = x"),
    (r"\newcommand{\h}[1]{\frac{#1}{2}}", r"\h{x} + \h{x} = x"),
    (r"\newcommand{\h}[2][2]{\frac{#2}{#1}}", r"\h{x} + \h[4]{2x} = x"),
    (r"\def\h#1#2{#2^{#1}}", r"\h2x = x x"),
    (r"\def\s{x}\renewcommand{\s}{y}", r"\s = y"),
    (r"\DeclareMathOperator{\si}{sin}", r"\si^2 t + \cos^2 t = 1"),
    (r"\DeclarePairedDelimiter{\br}{(}{)}", r"\br{x+1}^2 = x^2+2x+1"),
    (r"\NewDocumentCommand{\h}{O{2} m}{\frac{#2}{#1}}", r"\h{x} + \h[4]{2x} = x"),
    (r"\let\Si\sin", r"\Si^2 t + \cos^2 t = 1"),
    (r"\newcommand{\a}{\b}\newcommand{\b}{x}", r"\a = x"),
    (r"\newcommand{\sq}[1]{#1^2}", r"\sq{x} = x x"),
    (r"\newcommand{\w}{\omega}", r"x\w x = x^2\w{}"),
    ("", r"x + \textcolor{red}{y} = {\color{blue} x} + y"),
    ("", r"\frac{\cancel{x} y}{\cancel{x}} = y"),
    ("", r"x - \cancel{y} + \bcancel{y} = x"),
    ("", r"\dv{t}(x^2 y) = 0"),
]


@pytest.mark.parametrize(("definition", "formula"), MACROS)
@pytest.mark.parametrize("suffix", [".tex", ".md"])
def test_macros_are_what_tex_makes_of_them(definition, formula, suffix, tmp_path):
    """A macro is text: its body takes its place, arguments and all, and only after it is defined."""
    page = tmp_path / f"page{suffix}"
    page.write_text(f"{definition}\nWe have ${formula}$.\n", encoding="utf-8")
    (verdict,) = check(page, {**LETTERS, "omega": "a letter"}).verdicts
    assert verdict.verdict == "holds", verdict.reason
    start, end = verdict.span
    assert formula.rpartition("=")[2].strip() == page.read_text(encoding="utf-8")[start:end]
