"""Every relation sign of a page is accounted for: read, unreadable, or no mathematics.

The signs are counted by a plain scan that knows nothing of the reader: it strips what is a comment, an
address or program code, and the bounds of sums, and counts.
"""

import json
import re
import tomllib
from pathlib import Path

import pytest

from symbalance.checking import check
from tests import TESTS

HAND = TESTS / "hand"
CHECKED = TESTS.parent / "derivations" / "checked"
PAGES = [
    HAND / tomllib.loads(t.read_text(encoding="utf-8"))["page"] for t in sorted(HAND.glob("*.truth.toml"))
]
PAGES += sorted(CHECKED.glob("0*.txt"))
COMMANDS = (
    *("approx", "simeq", "fallingdotseq", "cong", "doteq", "doteqdot", "sim", "approxeq", "leq", "le"),
    *(
        "leqq",
        "leqslant",
        "geq",
        "ge",
        "geqq",
        "geqslant",
        "triangleq",
        "coloneqq",
        "colonequals",
        "eq",
        "defeq",
    ),
    *("lt", "gt", "equiv", "neq", "ne"),
)
SIGN = re.compile(
    r"==|:=|<=(?!>)|>=|!=|=(?!>)|<(?!-)|(?<![-=])>|[≈≒≃≅≐∼≑≤≥≦≧⩽⩾≡≜≔≠∝]|\\propto(?![A-Za-z])|(?<=\s)~(?=\s)|\\(?:"
    + "|".join(sorted(COMMANDS, key=len, reverse=True))
    + r")(?![A-Za-z])"
)


RUN = re.compile(r"=\s*(?:\\(?:SI|qty|num)(?:list|range)|[0-9][0-9,]*\s*(?:…|;\s*[0-9]))")
"""φ = 0…720° says two things: where φ begins and where it ends."""
ARROW = re.compile(r"(?:\\(?:Rightarrow|Longrightarrow|implies)(?![A-Za-z])|=>)(?=[^=\n]{1,40}=)")
"""F = 0 ⇒ x = 3 says that the one follows from the other; an arrow to words says nothing of the kind."""
SECOND_VALUE = re.compile(r"[0-9] ?[A-Za-z]+ \([0-9][0-9,.]* [A-Za-z]+\)")
"""5,39 kW (7,3 PS) says that the two are equal."""
CASES = re.compile(r"\\begin\{cases\}(.*?)\\end\{cases\}", re.DOTALL)


def branches(match: re.Match[str]) -> str:
    """Return what the branches of cases say, without conditions; signs that begin them count once."""
    values = [branch.split("&")[0].strip() for branch in match[1].split(r"\\")]
    if all(SIGN.match(value) for value in values):
        values[1:] = [SIGN.sub("", value, count=1) for value in values[1:]]
    return " ".join(values)


def counted(path: Path) -> int:
    """Return how many relation signs a page has, by a plain scan."""
    text = path.read_text(encoding="utf-8").translate({0xFF1D: "=", 0xFF1C: "<", 0xFF1E: ">"})
    if path.suffix == ".tex":
        text = re.sub(r"(?<!\\)%[^\n]*", "", text)
        body = re.search(r"\\begin\{document\}(.*)\\end\{document\}", text, re.DOTALL)
        text = body[1] if body else text
        text = re.sub(r"\[[a-z-]+=[^\]\n]*\]", "", text)  # options: \SI[per-mode=symbol]
        text = re.sub(r"(?<=[A-Za-z}])<[0-9]+-?[0-9]*>", "", text)  # slides: \alert<2>
        text = re.sub(r"\\begin\{verbatim\}.*?\\end\{verbatim\}", "", text, flags=re.DOTALL)
    elif path.suffix == ".md":
        text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
        text = re.sub(r"^```(?!math|\s*$).*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
        text = re.sub(r"^> ?|</?(?:math|br)>", "", text, flags=re.MULTILINE)
    elif text.startswith("#"):
        text = re.sub(r"\A(?:#[^\n]*\n)+", "", text)
    if path.suffix == ".txt":
        text = re.sub(r"^>[> ]*", "", text, flags=re.MULTILINE)  # quoted in an answer
    text = re.sub(r"^[ \t]*={2,}[ \t]*$", "", text, flags=re.MULTILINE)
    text = re.sub(r"https?://\S+", "", text)
    text = CASES.sub(branches, text)
    runs = len(ARROW.findall(text)) + len(RUN.findall(text)) + len(SECOND_VALUE.findall(text))
    return len(SIGN.findall(re.sub(r"[_^]\s*\{[^{}\n]{0,60}\}", "", text))) + runs


@pytest.mark.slow
@pytest.mark.parametrize(
    "page", [p for p in PAGES if p.suffix in (".tex", ".md", ".txt")], ids=lambda p: p.name
)
def test_a_plain_scan_counts_what_the_report_accounts_for(page):
    declared = page.with_suffix(".symbols.toml")  # a page as it was brought has none
    sidecar = tomllib.loads(declared.read_text(encoding="utf-8")) if declared.exists() else {}
    report = check(page, {key: sidecar[key] for key in ("symbols", "scope") if key in sidecar})
    assert report.relation_count == counted(page)
    data = report.data()
    assert data["seen"] == sum(data["counts"].values())


LETTERS = {"x": "a letter", "y": "a letter", "t": "angle"}


@pytest.mark.parametrize(
    ("text", "suffix"),
    [
        ("The value `x = 3` in code.\n", ".md"),
        ("| a | b |\n|---|---|\n| x = 3 | y = 4 |\n", ".md"),
        ("# Where x = 3\n", ".md"),
        ("Some $`x = 3`$ and ```y```.\n", ".md"),
        ("```\nx = 3\n```\n", ".md"),
        ("Text with x = 3 in it, $y = 4$.\n", ".tex"),
        ("\\begin{IEEEeqnarray}{rCl} x &=& 3 \\\\ y &=& 4 \\end{IEEEeqnarray}\n", ".tex"),
        ("\\begin{empheq}[box=\\fbox]{align} x &= 3 \\\\ y &= 4 \\end{empheq}\n", ".tex"),
        ("\\begin{dmath} x = 3 \\end{dmath} \\begin{multline} y = \\\\ 4 \\end{multline}\n", ".tex"),
        ("* <math>x = 3</math>\n{| style=\"a\"\n| x || <math>y = 4</math>\n|}\n", ".wiki"),
        ("<p>So <i>x</i> = 3</p><math><mi>y</mi><mo>=</mo><mn>4</mn></math>\n", ".html"),
        ("{|\n|+ Where <math>x = 3</math>\n| <math>y = 4</math>\n|}\n", ".wiki"),
        (
            '<p>\\(x = 3\\)</p><img class="mwe-math-fallback-image-inline"'
            ' alt="{\\displaystyle y=4}">\n',
            ".html",
        ),
        (".Where stem:[x = 3]\n|===\n|stem:[y = 4]\n|===\n", ".adoc"),
        ("It is stem:[x = 3].\n\n[stem]\n++++\ny = 4\n++++\n", ".adoc"),
        ("We know unknown = x, x = half the words, x ≈ \\foo and (x = q + 1).\n", ".txt"),
        ("$x = \\foo{3} = 4$ and $\\bar = \\bar$\n", ".tex"),
    ],
)  # fmt: skip
def test_nothing_vanishes_wherever_it_stands(text, suffix, tmp_path):
    page = tmp_path / f"page{suffix}"
    page.write_text(text, encoding="utf-8")
    signs = {".wiki": 2, ".html": 2}.get(suffix)
    if signs is None:
        signs = len(SIGN.findall(re.sub(r"\[box=[^\]]*\]|\|={3,}", "", text)))
    report = check(page, LETTERS)
    assert report.relation_count == signs
    assert len(report.verdicts) == signs  # none of them is passed over as no mathematics
    is_plain = not any(words in text for words in ("unknown", "\\foo"))
    assert not (is_plain and any(v.verdict == "unreadable" for v in report.verdicts))


def test_what_is_no_mathematics_is_counted_and_says_why(tmp_path):
    text = (
        "Kraft = Masse mal Weg. Use `--format=json` and <b>bold</b>; cost = 4.\n\n```python\nx = 3\n```\n"
    )
    page = tmp_path / "page.md"
    page.write_text(text, encoding="utf-8")
    data = check(page, LETTERS).data()
    assert [entry["why"] for entry in data["not_mathematics"]] == [
        "words on both sides",
        "in program code",
        "the value of a word that is no declared letter",
    ]
    assert data["counts"]["not_mathematics"] == data["seen"] == 3


SHOWN_CELL = {"cell_type": "code", "metadata": {}, "source": ["%%latex\n$2+2=5$"], "outputs": []}
FIRST_CELL = {"cell_type": "markdown", "metadata": {}, "source": ["$1=1$"]}
NOTEBOOK = {"cells": [FIRST_CELL, SHOWN_CELL], "metadata": {}, "nbformat": 4, "nbformat_minor": 4}


@pytest.mark.parametrize(
    ("text", "suffix"),
    [
        ("<math>1=1</math>\n\n{{NumBlk|:|<math>2+2=5</math>|1}}\n", ".wiki"),
        ("<math>1=1</math>\n\n{{Equation box 1|equation=<math>2+2=5</math>}}\n", ".wiki"),
        ("<math>1=1</math>\n\n{{quote|2+2=5}}\n", ".wiki"),
        ("\\title{$2+2=5$}\\begin{document}\\maketitle $1=1$\n\\end{document}\n", ".tex"),
        ("$1=1$\n#+CAPTION: $2+2=5$\n", ".org"),
        ("$1=1$\n#+TITLE: $2+2=5$\n", ".org"),
        ('<p>1=1</p><img src="a.png" class="tex" alt="2+2=5">\n', ".html"),
        ('<p>1=1</p><img alt="2+2=5" src="https://example.org/latex.php?x=1">\n', ".html"),
        (json.dumps(NOTEBOOK), ".ipynb"),
        ("$1=1$ and $$ 2+2 \\text{ equals } 5 $$\n", ".md"),
        ("1=1, and ∫₀¹ x dx = 1.\n", ".md"),
    ],
)
def test_a_relation_that_a_format_wraps_is_judged(text, suffix, tmp_path):
    page = tmp_path / f"page{suffix}"
    page.write_text(text, encoding="utf-8")
    report = check(page)
    assert sorted(v.verdict for v in report.verdicts) == ["holds", "refuted"]
    assert report.relation_count == 2


@pytest.mark.parametrize("sign", ["≙", "⪆", "≳", "≢", "\\gtrsim", "\\nleq", "\\asymp"])
def test_a_relation_sign_that_is_not_judged_is_reported(sign, tmp_path):
    page = tmp_path / "page.md"
    page.write_text(f"$1=1$ and $2 {sign} 7$.\n", encoding="utf-8")
    report = check(page)
    assert sorted(v.verdict for v in report.verdicts) == ["holds", "unreadable"]
    assert report.relation_count == 2


def test_a_letter_said_to_be_small_is_a_range(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("Here $x \\ll y$ and $1=1$.\n", encoding="utf-8")
    assert [verdict.verdict for verdict in check(page, LETTERS).verdicts] == ["range", "holds"]
