"""Whole documents: where equations are found, what continues what, tags, and refusals' places."""

from __future__ import annotations

import time

import pytest

from symbalance.document.text_writer import formula_text
from symbalance.notes.reading import read_document
from symbalance.notes.reading.equations import Chain, ReadNotes

LETTERS_TEXT = "theta lambda s l x n N h L R Lh omega r rho F a M m alpha k t b c y v"
LETTERS = LETTERS_TEXT.split()


def read(text: str, suffix: str = "") -> ReadNotes:
    return read_document(text, f"notes{suffix}", lambda line: LETTERS)


def said(chain: Chain) -> str:
    text = formula_text(chain.sides[0].node, plain=True)
    for relation, side in zip(chain.relations, chain.sides[1:], strict=True):
        text += f" {relation.sign} {formula_text(side.node, plain=True)}"
    return text


def all_said(text: str, suffix: str = "") -> list[str]:
    document = read(text, suffix)
    assert not document.unreadable
    return [said(chain) for chain in document.chains]


TEX = r"""
\documentclass{article} $x=0$
\begin{document} % $x=1$
Prose x = 2. We have $x = 3$ and \(y = 4\), 50\% of $\theta$.
\begin{align}
 x &= r(1-\cos\theta) \label{eq:a}\\
   &\quad + l \nonumber\\
   &= a + b, \tag{7}
\end{align}
\[ F = m a. \]
\begin{align*} x &= 5 & y &= 6 \\ a &= 7 & b &= 8 \end{align*}
\begin{eqnarray} x & = & 9 \\ y & = & 10 \end{eqnarray}
\begin{equation}\begin{aligned} x &= a \\ &= b \end{aligned}\end{equation}
\begin{verbatim} $x=11$ \end{verbatim}
\begin{gather} x = 12 \\[2pt] y = 13 \end{gather}
$$m = 14\,\text{kg} \quad\text{and}\quad k = 15$$
\end{document} $x=16$
"""

MARKDOWN = """# Title x = 0

```python
x = 1
```

```math
x = 2
```

Inline `x = 3` and $F = m a$.

- x = 4
- $y = 5$

**M = F L**

| x = 6 | y |

> v = 7

See https://x.org/?a=b and a@b.org, where a = r ω^2 is the acceleration.

$$
F = m a \\\\
  = m r
$$
"""


def test_a_tex_file_gives_its_delimited_mathematics() -> None:
    assert all_said(TEX, ".tex") == [
        "x = 2",
        "x = 3",
        "y = 4",
        "x = r (1 - cos θ) + l = a + b",
        "F = m a",
        "x = 5",
        "y = 6",
        "a = 7",
        "b = 8",
        "x = 9",
        "y = 10",
        "x = a = b",
        "x = 12",
        "y = 13",
        "m = 14",
        "k = 15",
    ]


def test_a_markdown_file_is_read_outside_code() -> None:
    expected = [
        "x = 0",
        "x = 2",
        "x = 3",
        "F = m a",
        "x = 4",
        "y = 5",
        "M = F L",
        "x = 6",
        "v = 7",
        "a = r ω^2",
        "F = m a = m r",
    ]
    assert all_said(MARKDOWN, ".md") == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x = a +\n  b\n  + c", ["x = a + b + c"]),
        ("x = sin(\n θ )\ny = 2", ["x = sin θ", "y = 2"]),
        ("x = (a\n+b)\n= c", ["x = a + b = c"]),
        ("x=a\n\n\n+b c", ["x = a", "b c"]),
        ("x = 3\n\nところで次のようになる。\n\n= 4", ["x = 3 = 4"]),
        ("6 \\cos 6 \\theta\n= 3", ["6 cos 6θ = 3"]),
        ("x = a\r\n  = b\r\n\r\ny = c\r\n", ["x = a = b", "y = c"]),
        ("x = a\n\ny = b\n= c", ["x = a", "y = b = c"]),
        ("- x = a\n- y = b", ["x = a", "y = b"]),
        ("(1) x = a\n2. y = b\n3) v = c", ["x = a", "y = b", "v = c"]),
        ("x=1, y=2; M=3", ["x = 1", "y = 2", "M = 3"]),
        (r"$$x = a \quad\text{ただし}\quad y = b$$", ["x = a", "y = b"]),
        (r"$$x = a, \qquad y = b$$", ["x = a", "y = b"]),
        (r"$$x = a \quad - \quad b$$", ["x = a - b"]),
        ("$x = 3$, $y=4$", ["x = 3", "y = 4"]),
        ("costs $5 and x = $6, then", []),
        ("a < b ≤ c\nx ≠ 3\nx := 4\nx ≃ y\nx == y", ["a < b ≤ c", "x ≠ 3", "x = 4", "x ≈ y", "x = y"]),
        (r"x \leqq y" "\n" r"x \fallingdotseq y \equiv b", ["x ≤ y", "x ≈ y ≡ b"]),
        ("m (= a/2)", ["m = a/2"]),
        ("Let k = 5 be a number; then F = m a, M = F L hold.", ["k = 5", "F = m a", "M = F L"]),
        ("The mass m = 3 is known.", ["m = 3"]),
        ("F = m a! So v = r ω? Also \"x = 3\".", ["F = m a", "v = r ω", "x = 3"]),
        ("θ=30°、α=π/6 とする", ["θ = 30 (π/180)", "α = π/6"]),
        ("\ufeffx = 3", ["x = 3"]),
        ("x\u200b = \x003", ["x = 3"]),
    ],
)  # fmt: skip
def test_what_is_found(text: str, expected: list[str]) -> None:
    assert all_said(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "Dear Sir, 2024-01-02, 10:30, see http://a.b/?x=1&y=2 or a=b@c.org",
        "version=1.2.3\nname = value\nprint(foo(x) == bar)\n--flag=on",
        "A --> B => C -> D",
        "2 1 2 4 6\n#1#2#3\n3 + 4\nx",
        "エンジン: x, y, θ。角度θ=",
        "cost = 4 and speed = 5",
        "$m$ and $\\theta$",
        "See `x`, cos θ and 3/4 of it.",
        "",
        "\n \r\n\t",
    ],
)
def test_prose_is_left_alone(text: str) -> None:
    document = read(text)
    assert document.chains == ()
    assert document.unreadable == ()


@pytest.mark.parametrize(
    ("source", "tag", "formula"),
    [
        (r"$$x = a \quad - (1)$$", "1", "x = a"),
        (r"$$x = a \tag{2b}$$", "2b", "x = a"),
        (r"\displaystyle x = a \qquad (5.1)", "5.1", "x = a"),
        (r"x = a \cdots(3)", "3", "x = a"),
        ("x = a …(4)", "4", "x = a"),
        ("x = r    (6)", "6", "x = r"),
        (r"x = a + \cdots \quad (7)", "7", "x = a + …"),
        (r"x = a + \cdots (8)", "8", "x = a + …"),
        ("x = r (1)", "", "x = r*1"),
        (r"x = a(b)", "", "x = a b"),
    ],
)
def test_tags(source: str, tag: str, formula: str) -> None:
    (chain,) = read(source).chains
    assert (chain.tag, said(chain)) == (tag, formula)


REFUSED = [
    ("$x = a = q(b)$\n", [], ["x = a = q(b)"]),
    ("$x = \\dot q a = b$", [], ["x = dq/dt a = b"]),
    ("$\\sum_{k=1}^3 F_k = b$", [], ["Σ_{k=1}^{3} F_k = b"]),
    ("$\\sum_{k=1}^3 F_{k,max} = b$", [], ["Σ_{k=1}^{3} F_{k,max} = b"]),
    ("x = (a + b\ny = c\n", [(1, 5, "bracket ( is never closed")], ["y = c"]),
    ("x = a) + b\n", [(1, 6, "bracket ) was never opened")], []),
    ("= 3\n", [(1, 1, "nothing stands left of =")], []),
    ("x = 3 =\n", [(1, 7, "nothing stands right of =")], ["x = 3"]),
    ("a\n\n\\displaystyle x = \\foo{a}", [(3, 19, "unknown command \\foo")], []),
    ("x = a\n = \\foo\n = b", [(2, 4, "unknown command \\foo")], ["x = a = b"]),
    ("x = a\n + \\foo\n = b", [(2, 4, "unknown command \\foo")], ["x = b"]),
    (
        "x = a\ny = \\foo b\n  = c\n  = b\n",
        [(2, 5, "unknown command \\foo"), (3, 3, "the side before it is not read")],
        ["x = a", "c = b"],
    ),
    ("x = 5%\n$n!! = 6$", [(2, 4, "a double factorial is not read")], ["x = 5 (1/100)"]),
    ("$$x = 3", [(1, 1, "$$ without $$")], ["x = 3"]),
    (
        r"$$x = \begin{cases} 1 \\ 2 \end{cases}$$",
        [(1, 7, "cases without conditions")],
        [],
    ),
    (
        "$$(x+a$$\n$$(x+a)) = 2$$",
        [(1, 3, "bracket ( is never closed"), (2, 8, "bracket ) was never opened")],
        [],
    ),
    ("質量は x = m Q である", [], ["x = m Q"]),
    ("質量は Z = K Q である", [], ["Z = K Q"]),
    ("値は x = f(2) Q である", [], ["x = f(2) Q"]),
    ("ここで $Z = K Q$ である", [], ["Z = K Q"]),
]


@pytest.mark.parametrize(("text", "refusals", "expected"), REFUSED)
def test_refusals_and_what_is_read_beside_them(
    text: str, refusals: list[tuple[int, int, str]], expected: list[str]
) -> None:
    document = read(text)
    assert [(one.line, one.column, one.what) for one in document.unreadable] == refusals
    assert [said(chain) for chain in document.chains] == expected
    assert all(one.remedy for one in document.unreadable)


def test_a_letter_alone_on_the_left_declares_itself() -> None:
    text = "w = f(h)\nZ_1 = h + 2\n w = Z_1\n V2 = 3\n g' = 1\n u = g' V2"
    document = read(text)
    assert [said(chain) for chain in document.chains] == [
        "w = f(h)", "Z_1 = h + 2", "w = Z_1", "V2 = 3", "g' = 1", "u = g' V2",
    ]  # fmt: skip
    assert document.free_letters == ("f",)


def test_letters_that_nobody_declares_are_letters_of_their_own_and_said_to_be() -> None:
    document = read("$$F\\cos\\alpha = Q_1$$\n$$x = d^4$$\n$$x = F(a + b)$$")
    assert [said(chain) for chain in document.chains] == ["F cos α = Q_1", "x = d^4", "x = F (a + b)"]
    assert document.free_letters == ("Q_1", "d")
    assert document.notes == ("not declared: Q_1, d",)


def test_declarations_differ_by_line() -> None:
    document = read_document("x = Lh\nx = Lh", "", lambda line: ["x", "Lh"] if line == 2 else ["x"])
    assert [chain.lines for chain in document.chains] == [(2,)]
    assert [one.line for one in document.unreadable] == [1]


def test_a_stray_bracket_at_the_end_of_a_line_is_dropped_with_a_note() -> None:
    (chain,) = read("x = 9 \\cos (6 \\theta -\\frac{1}{6} \\pi))").chains
    assert said(chain) == "x = 9 cos(6θ - 1/6 π)"
    assert chain.notes == ("stray ) dropped",)


def test_spans_lines_and_inline() -> None:
    document = read("prose $x = 3$\nx = a\n  + b\n  = c")
    inline, display = document.chains
    assert inline.inline
    assert not display.inline
    assert display.lines == (2, 3, 4)
    assert [relation.line for relation in display.relations] == [2, 4]
    assert [document.source(side.span) for side in display.sides] == ["x", "a\n  + b", "c"]
    assert document.line_of(display.sides[2].span[0]) == 4
    assert document.column_of(display.sides[2].span[0]) == 5


HOSTILE_TEXT = "( ) { } [ $ = () $$ \\ \\[ \\( | ^ _ ` % <!-- = $_ =_"
HOSTILE = HOSTILE_TEXT.split()


@pytest.mark.slow
@pytest.mark.parametrize("unit", HOSTILE)
def test_a_megabyte_on_one_line_ends_soon(unit: str) -> None:
    text = unit.replace("_", " ") * (999_999 // len(unit))
    begin = time.process_time()
    read(text, ".tex" if unit == "\\[" else ".md")
    assert time.process_time() - begin < 20  # twice what it takes; what grows with the square takes hours


def test_a_document_that_is_too_long_is_refused() -> None:
    (refusal,) = read("x" * 1_000_001).unreadable
    assert (refusal.line, refusal.column, refusal.remedy) == (1, 1, "split it")


@pytest.mark.spread(3)
@pytest.mark.parametrize(
    "unit",
    [r"\frac", r"\sqrt", r"\sqrt[", r"\sin", "e^", "x^", "|", "(=", "-", "a/", "{",
     r"\frac{d}{dt}", r"\sum", r"\left|"],
)  # fmt: skip
def test_deep_nesting_is_refused_not_a_recursion_error(unit: str) -> None:
    document = read("$$x = " + unit * (9_000 // len(unit)) + " x$$")
    assert len(document.unreadable) == 1 + unit.count("=") * (9_000 // len(unit))  # each is said


FORMULAS = [
    "sin 2θ = 2 sin θ cos θ",
    "x = r(1 - cos θ)",
    "a = r ω² (cos θ + cos 2θ/λ)",
    "v = dx/dt",
    "(r + l)² = r² + 2 r l + l²",
    "rcos θ = r cos θ",
    "-sin θ = sin(-θ)",
    "λ = l/r ≈ 4",
]
PROSE = [
    *("- {}", "* {}", "+ {}", "• {}", "-  {} ,", "    {}", "1. {}", "1) {}", "(2) {}", "& {} &"),
    *("{}.", "{},", "{};", "{})", "“{}”", "{}  (2.1)", "(see above) {}", "{} (see above)"),
    *("Thus {}", "hence: {}", "where {}, and", "the velocity {}", "so that {} holds", "If {}, then"),
    *("The displacement is {}.", "{} holds because of the above", "with {} we get", "Es gilt {}."),
]


@pytest.mark.parametrize("prose", PROSE)
def test_prose_around_a_formula_changes_nothing(prose: str) -> None:
    for formula in FORMULAS:
        document = read(prose.format(formula), ".txt")
        assert not document.unreadable
        (chain,) = document.chains
        assert said(chain) == all_said(formula, ".txt")[0]
        start, end = prose.index("{}"), prose.index("{}") + len(formula)
        begin, stop = chain.sides[0].span[0], chain.sides[-1].span[1]
        assert begin >= start or prose == "+ {}"  # a sign is no bullet for sure: its place is noted
        assert begin < stop <= end


def test_the_number_of_an_equation_may_stand_behind_the_end_of_its_rows() -> None:
    document = read("$$\n\\begin{aligned}\nx &= a,\\\\\ny &= b\n\\end{aligned}\n\\tag{5.4}\n$$\n")
    assert [(said(chain), chain.tag) for chain in document.chains] == [("x = a", ""), ("y = b", "5.4")]
    assert document.unreadable == ()


def test_macros_side_by_side_are_two_letters() -> None:
    macros = "\\newcommand{\\rr}{\\lambda}\n\\newcommand{\\mo}{m}\n"
    document = read_document(f"{macros}$x = \\rr\\mo a$", "n.tex", lambda line: ["x", "a", "lambda", "m"])
    assert [said(chain) for chain in document.chains] == ["x = λ m a"]


def test_a_unit_of_siunitx_may_be_a_whole_kilogram_or_of_its_own_name() -> None:
    units = "\\DeclareSIUnit{\\rpm}{rpm}\n$x = \\SI{0.62}{\\kilogram}$, $y = \\SI{30}{\\rpm}$"
    assert [said(chain) for chain in read(units).chains] == ["x = 0.62", "y = 30 (π/30)"]


def test_a_decimal_comma_may_stand_behind_an_operator_and_a_unit_without_braces() -> None:
    formula = "$x = 0,45\\cdot0,033\\cdot942^2\\,\\mathrm N = 13180\\,\\mathrm N$"
    document = read(f"Mit der Masse und dem Radius ist {formula}")
    assert [said(chain) for chain in document.chains] == ["x = 0.45*0.033*942^2 = 13180"]
    assert document.unreadable == ()


def test_less_than_a_negative_number_is_no_arrow() -> None:
    document = read("Let $x<-2$ and $y<-a$.")
    assert [said(chain) for chain in document.chains] == ["x < -2", "y < -a"]
