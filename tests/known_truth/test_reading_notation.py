"""How people write: spaces that end an angle, x(θ), units, arrows, notes under braces, orders."""

from __future__ import annotations

from fractions import Fraction

import pytest

from symbalance.document.formula import Apply, Name, Number, Product
from symbalance.document.text_writer import formula_text
from symbalance.notes.reading import ReadingError, canonical_name, read_document, read_expression
from symbalance.notes.reading.equations import ReadNotes
from symbalance.notes.reading.units import scale_of

LETTERS_TEXT = (
    "theta theta_1 lambda phi omega rho s l x y n N r F F_1 m M a b c v k f v_max x_min Lh beta"
)
LETTERS = LETTERS_TEXT.split()


def read(text: str, suffix: str = "") -> ReadNotes:
    return read_document(text, f"notes{suffix}", lambda line: LETTERS)


def said(document: ReadNotes) -> list[str]:
    chains: list[str] = []
    for chain in document.chains:
        text = formula_text(chain.sides[0].node, plain=True)
        for relation, side in zip(chain.relations, chain.sides[1:], strict=True):
            text += f" {relation.sign} {formula_text(side.node, plain=True)}"
        chains.append(text)
    return chains


TERMS_AND_EQUATIONS = [
    (
        r"\begin{align} x &= a \\ -\cos\theta &= \sin(\theta-90^\circ) \\ &+ b \\ +y &= 3\end{align}",
        ["x = a", "-cos θ = sin(θ - 90 (π/180)) + b", "y = 3"],
    ),
    (r"\begin{gather} x = a \\ -y = c \\ - b\end{gather}", ["x = a", "-y = c - b"]),
    ("\\[x = a\\]\n\\[-b\\]\n\\[-y = c\\]", ["x = a", "-b", "-y = c"]),
    (
        "\\begin{equation}x = a\\end{equation}\n\\begin{equation}+ y = c\\end{equation}",
        ["x = a", "y = c"],
    ),
    ("x = a\n-y = b\n-c", ["x = a", "-y = b - c"]),
    ("x = a\n+ b\n- c\n= y", ["x = a + b - c = y"]),
    ("x = (a\n- b) = c", ["x = a - b = c"]),
    ("x = (a\n- f(b = c)) + y", []),
]


@pytest.mark.parametrize(("text", "expected"), TERMS_AND_EQUATIONS)
def test_a_line_with_a_sign_first_is_a_term_only_without_a_relation(
    text: str, expected: list[str]
) -> None:
    assert said(read(text)) == expected


def test_an_unreadable_line_with_a_relation_leaves_the_one_above() -> None:
    document = read("x = a\n-\\foo{x} = b\n")
    assert said(document) == ["x = a"]
    assert [(one.line, one.what) for one in document.unreadable] == [(2, r"unknown command \foo")]
    rows = read(r"\begin{gather} x = \foo \\ -y = \bar{ab} \\ - \foo \end{gather}")
    assert len(rows.unreadable) == 2


ARGUMENTS = [
    (r"l\cos\phi\,\dot\phi", ["l cos(φ) (dφ/dt)"]),
    (r"l\cos\phi\dot\phi", ["l cos(φ) (dφ/dt)"]),
    (r"\cos\theta\, r", ["cos(θ) r"]),
    (r"\sin\theta\,\omega", ["sin(θ) ω"]),
    (r"\cos2\theta\,F_1", ["cos(2θ) F_1"]),
    (r"\cos\theta\quad r", ["cos(θ) r"]),
    (r"\cos\theta~r^2", ["cos(θ) r^2"]),
    (r"\sin\theta\,\frac{r}{l}", ["sin(θ) (r/l)"]),
    (r"\sin\frac{\pi}{3}\,r", ["sin(π/3) r"]),
    (r"\cos 45^\circ F", ["cos(45 (π/180)) F"]),
    ("cos45 [cos(t-45) + 1]", ["cos(45) (cos(t - 45) + 1)"]),
    ("sin 2(θ + φ)", ["sin(2 (θ + φ))"]),
    (r"\cos\theta r", ["cos(θ) r", "cos(θ r)"]),
    ("cos θ r", ["cos(θ) r"]),
    ("cosθr", ["cos(θ) r", "cos(θ r)"]),
    (r"\cos\omega t\,r", ["cos(ω t) r"]),
    (r"\sin \omega t", ["sin(ω t)"]),
    ("sin ω t", ["sin(ω t)"]),
    (r"\cos\omega\,t", ["cos(ω t)"]),
    (r"\cos 6\,\theta", ["cos 6θ"]),
    (r"\cos n\theta", ["cos(n θ)"]),
    (r"\cos\theta n", ["cos(θ n)"]),
    (r"\cos\theta_1", ["cos θ_1"]),
    (r"\cos(\theta)", ["cos θ"]),
]


@pytest.mark.parametrize(("source", "expected"), ARGUMENTS)
def test_where_an_angle_ends(source: str, expected: list[str]) -> None:
    assert [
        formula_text(node, plain=True) for node in read_expression(source, [*LETTERS, "t"])
    ] == expected


EXPONENTS = [
    (r"\sin^22\theta", "sin^2 2θ"),
    (r"\cos^23\theta", "cos^2 3θ"),
    (r"\lambda^22", "λ^2*2"),
    (r"\lambda^{22}", "λ^22"),
    (r"{\cos}^2\theta", "cos^2 θ"),
    ("x^10", "x^10"),
    ("10^12 a", "10^12 a"),
    ("sin^22θ", "sin^2 2θ"),
    ("sin^10θ", "sin^10 θ"),
    ("sin^22 θ", "sin^22 θ"),
    (r"e^{i2\pi/3}", "exp(i*2 π/3)"),
    (r"e^{2i\theta}", "exp(2 i θ)"),
    ("exp(i2θ)", "exp(i*2θ)"),
]


@pytest.mark.parametrize(("source", "expected"), EXPONENTS)
def test_exponents_and_multiples(source: str, expected: str) -> None:
    assert formula_text(read_expression(source, LETTERS)[0], plain=True) == expected


@pytest.mark.parametrize(
    ("text", "expected", "notes"),
    [
        (r"x(\theta) = a", "x = a", ("x(θ) read as x",)),
        (r"$g\left(t\right) = 3$", "g = 3", ("g(t) read as g",)),
        (r"\ddot x(\theta) = a", "d^2x/dt^2 = a", (r"\ddot x(θ) read as \ddot x",)),
        ("x(t) = a\n  = b", "x = a = b", ("x(t) read as x",)),
        (r"r(1-\cos\theta) = a", "r (1 - cos θ) = a", ()),
        ("k(a+b) = c", "k (a + b) = c", ()),
        ("y = s(1-x)", "y = s (1 - x)", ()),
        ("2x(θ) = y", "2x θ = y", ()),
    ],
)
def test_a_letter_written_as_a_function(text: str, expected: str, notes: tuple[str, ...]) -> None:
    document = read(text)
    assert said(document) == [expected]
    assert document.chains[0].notes == notes


def test_the_side_of_a_function_is_all_of_it() -> None:
    document = read(r"x(\theta) = a")
    assert document.source(document.chains[0].sides[0].span) == r"x(\theta)"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("x(0) = a", "x(0) = a"),
        (r"x(\pi) = 2r", "x(π) = 2r"),
        ("a(0) = x", "a(0) = x"),
        (r"F_1(\theta-120^\circ) = F", "F₁(θ − 120 π/180) = F"),
        ("x(0) = x(π) = 0", "x(0) = x(π) = 0"),
        (r"\dot{x}(0) = 0", "(dx/dt)(0) = 0"),
    ],
)
def test_a_value_of_a_function_is_one(text: str, shown: str) -> None:
    (chain,) = read(text).chains
    assert " = ".join(formula_text(side.node) for side in chain.sides) == shown
    assert all(isinstance(side.node, Apply) and side.node.function == "at" for side in chain.sides[:1])


@pytest.mark.parametrize(
    ("unit", "scale", "pi"),
    [
        *((unit, 1, False) for unit in ("m", "kg", "s", "N", "rad/s", "m/s", "m/s^2", "N m", "J", "W")),
        *((unit, 1, False) for unit in ("Pa", "rad", r"N\cdot m", "s^{-1}", r"kg\,m^2", "m s⁻²")),
        *(("mm", Fraction(1, 1000), False), ("cm", Fraction(1, 100), False), ("kN", 1000, False)),
        *(("g", Fraction(1, 1000), False), ("bar", 10**5, False), ("MPa", 10**6, False)),
        *(("ms", Fraction(1, 1000), False), ("µm", Fraction(1, 10**6), False), ("kW", 1000, False)),
        *((r"\mu m", Fraction(1, 10**6), False), ("kN/mm", 10**6, False), ("mm^2", 10**-6, False)),
        *((unit, Fraction(1, 30), True) for unit in ("rpm", "min^{-1}", "1/min", "min⁻¹")),
    ],
)
def test_units(unit: str, scale: Fraction, pi: bool) -> None:
    found = scale_of(unit)
    assert found is not None
    assert (float(found[0]), found[1]) == (float(scale), pi)


@pytest.mark.parametrize(
    "junk", ["", "furlong", "mm/", "1", "//", "m^", "^2", "mm mm mm x", r"\milli\metre"]
)
def test_no_units(junk: str) -> None:
    assert scale_of(junk) is None


WITH_UNITS = [
    (r"x = 40\,\mathrm{mm}", "x = 40 (1/1000)"),
    (r"\omega = 6000\,\mathrm{rpm}", "ω = 6000 (π/30)"),
    (r"F = 3\,\mathrm{kN} + 2\mathrm{N}", "F = 3*1000 + 2"),
    (r"v = 3.5\,\mathrm{m/s^2}", "v = 3.5"),
    (r"v=9.81\,\mathrm{m}/\mathrm{s}^2", "v = 9.81"),
    (r"v=9.81\,\mathrm{m}\,\mathrm{s}^{-2}", "v = 9.81"),
    (r"v=9.81\,\frac{\mathrm{m}}{\mathrm{s}^2}", "v = 9.81"),
    (r"\omega = 100\,\mathrm{s^{-1}}", "ω = 100"),
    (r"$$r = 40\,\text{mm} = 3\,\text{N} + b$$", "r = 40 (1/1000) = 3 + b"),
    (r"\displaystyle r = 40\,\text{mm}+\theta", "r = 40 (1/1000) + θ"),
    (r"v = 3 \unit{mm}", "v = 3 (1/1000)"),
    (r"v = 3\,\si{cm}", "v = 3 (1/100)"),
    (r"v = 3/4\,\mathrm{mm}", "v = 3/4 (1/1000)"),
    (r"v = (a+b)\,\mathrm{mm}", "v = (a + b) (1/1000)"),
    (r"v = 10^{3}\,\mathrm{mm}", "v = 10^3 (1/1000)"),
    (r"x = 2\pi\,\mathrm{rad}", "x = 2 π"),
    (r"F = m a\,\text{N}", "F = m a"),
    (r"F = m F_{1}\,\text{N}", "F = m F_1"),
    ("r = 40 mm", "r = 40 (1/1000)"),
    ("r = 40 [mm]", "r = 40 (1/1000)"),
    ("F = m a [N]", "F = m a"),
    ("the crank radius r = 40 mm holds", "r = 40 (1/1000)"),
    ("半径 r = 40 mm とする。", "r = 40 (1/1000)"),
    ("長さ[mm] x = 3", "x = 3"),
    # letters all the same
    (r"x=\frac{1}{2}\mathrm{m}v^2", "x = 1/2 m v^2"),
    (r"F=\lambda^2\mathrm{N}", "F = λ^2 N"),
    (r"v = 2\mathrm{Lh}+2\mathrm{e}^{x}", "v = 2 Lh + 2 exp(x)"),
    (r"x = r\,\mathrm{m}", "x = r m"),
    ("v = 3 m", "v = 3m"),
    ("v = 3 ma", "v = 3m a"),
    ("v = 2[a+b]", "v = 2 (a + b)"),
]


@pytest.mark.parametrize(("text", "expected"), WITH_UNITS)
def test_numbers_with_units(text: str, expected: str) -> None:
    document = read(text)
    assert document.unreadable == ()
    assert said(document) == [expected]


def test_a_number_with_a_unit_keeps_its_last_place() -> None:
    (tree,) = read_expression(r"25.40\,\mathrm{mm}", [])
    assert tree == Product((Number(Fraction(127, 5), Fraction(1, 100)), Number(Fraction(1, 1000))))


@pytest.mark.parametrize(
    ("source", "what"),
    [
        (r"9\,\mathrm{furlong}", "unit furlong is not read"),
        (r"3\,\si{\milli\metre}", r"unit \milli\metre is not read"),
        (r"5\,\mathrm{rav}", "unit rav is not read"),
        (r"m a\,\mathrm{kN}", "unit kN behind a letter"),
        ("m a [mm]", "unit mm behind a letter"),
    ],
)
def test_units_that_are_refused(source: str, what: str) -> None:
    with pytest.raises(ReadingError) as refusal:
        read_expression(source, LETTERS)
    assert refusal.value.what == what
    assert refusal.value.remedy == "leave it out of the formula"


INTRODUCED = [
    (r"$$\therefore\ x = a$$", ["x = a"]),
    ("∴ x = a", ["x = a"]),
    (r"\implies x = a", ["x = a"]),
    (r"$$a = b \Rightarrow x = y$$", ["a = b", "x = y"]),
    (r"$$a = b, \quad\therefore x = y$$", ["a = b", "x = y"]),
    (r"\begin{align} x &= a\\ \Rightarrow x &= b\\ \Rightarrow &= c\end{align}", ["x = a", "x = b = c"]),
]


@pytest.mark.parametrize(("text", "expected"), INTRODUCED)
def test_arrows_introduce_and_separate(text: str, expected: list[str]) -> None:
    document = read(text)
    assert document.unreadable == ()
    assert said(document) == expected


def test_an_arrow_to_no_equation_is_refused() -> None:
    (refusal,) = read(r"a = b \implies x").unreadable
    assert refusal.what == "arrows are not read"


def test_names_with_max_and_min() -> None:
    assert said(read(r"v_{\max} = x_{\min} a")) == ["v_max = x_min a"]
    assert said(read(r"$v_\max = 3$ and $x_{\text{min}} = 2$")) == ["v_max = 3", "x_min = 2"]
    assert canonical_name(r"v_{\max}") == "v_max"


@pytest.mark.parametrize(
    ("source", "side"),
    [
        (r"x = \left(a+b\right)c", r"\left(a+b\right)c"),
        (r"x = \bigl[a+b\bigr]", r"\bigl[a+b\bigr]"),
        (r"x = \theta + O(\rho^7)", r"\theta + O(\rho^7)"),
    ],
)
def test_a_side_begins_where_its_first_command_does(source: str, side: str) -> None:
    document = read(source)
    assert document.source(document.chains[0].sides[1].span) == side


OTHERS = [
    (r"\theta + O(\rho^7)", "θ + O(ρ^7)"),
    (r"\theta - \mathcal{O}(\lambda^{-5})", "θ + O(λ^(-5))"),
    (r"(1 + \theta + O\left(\rho^7\right)) a", "(1 + θ + O(ρ^7)) a"),
    (r"\vec F", "F"),
    (r"\underbrace{a+b}_{\text{first order}} + \overbrace{c}^{2}", "(a + b) + c"),
    (r"\displaystyle\frac{\displaystyle a}{b}", "a/b"),
]


@pytest.mark.parametrize(("source", "expected"), OTHERS)
def test_what_else_people_write(source: str, expected: str) -> None:
    assert formula_text(read_expression(source, LETTERS)[0], plain=True) == expected


def test_an_order_that_is_not_the_last_term_is_a_letter() -> None:
    with pytest.raises(ReadingError, match="letter O is not declared"):
        read_expression(r"O(\rho^2) + a", LETTERS)
    assert formula_text(read_expression("a + O(x)", [*LETTERS, "O"])[0], plain=True) == "a + O x"


def test_a_declared_vector_is_a_letter_of_its_own() -> None:
    assert read_expression(r"\vec F", [*LETTERS, "vec_F"])[0] == Name("vec_F")


QUOTED_AND_SHORT = [
    (">    x = a\n>      = b\n>\n> with y = c", ["x = a = b", "y = c"]),
    (">> x = a\n>>   = b", ["x = a = b"]),
    ("x = a*cos(th) + b*cos(2*th)", ["x = a cos θ + b cos 2θ"]),
    ("th2 = th + 240 deg for cos(th)", ["θ_2 = θ + 240 (π/180)"]),
    ("x = 110 : 2 = 55", ["x = 110/2 = 55"]),
    ("Fig. 3: x = 4", ["x = 4"]),
]


@pytest.mark.parametrize(("text", "expected"), QUOTED_AND_SHORT)
def test_quoted_lines_short_greek_names_and_dividing_colons_are_read(
    text: str, expected: list[str]
) -> None:
    assert said(read(text, ".txt")) == expected


def test_short_names_are_noted_once_and_declared_letters_go_before_them() -> None:
    assert read("x = a*cos(th) + b*sin(th)", ".txt").notes[0] == "th is read as θ"
    own = read_document("x = 2*th = th + th", "mail.txt", lambda line: ["x", "t", "h"])
    assert said(own) == ["x = 2t h = t h + t h"]
    words = read("Miller et al = 4, the 4th + 1 (th), it has to be (3) + a = x", ".txt")
    assert not any("is read as" in note for note in words.notes)


def test_a_sign_that_compares_at_the_start_of_a_line_stays_a_relation() -> None:
    assert said(read("x = a\n  > b", ".txt")) == ["x = a > b"]


def test_dotted_letters_have_names() -> None:
    names = [canonical_name(letter) for letter in (r"\ddot{x}", r"\dot x", r"\bar v", r"\hat{F}_2")]
    assert names == ["ddot_x", "dot_x", "bar_v", "hat_F_2"]
    own = read_document(r"$\ddot{x} = a$", "page.md", lambda line: ["ddot_x", "a"])
    assert own.chains[0].sides[0].node == Name("ddot_x")
