"""The words that open a line say of which case it is: what it is judged by is what that case gives."""

import pytest

from symbalance.checking import check

ACCUSED = ("refuted", "contradiction")
SIMPLE, CLAMPED = r"$f = \frac{Fl^3}{48EI}$", r"$f = \frac{Fl^3}{3EI}$"
SERIES, PARALLEL = r"$c = \frac{c_1c_2}{c_1+c_2}$", "$c = c_1+c_2$"


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page, fixes=False).data()["links"]]


@pytest.mark.parametrize(
    "page",
    [
        f"For a simply supported beam {SIMPLE}.\n\nFor a cantilever {CLAMPED}.",
        f"In series: {SERIES}.\n\nIn parallel: {PARALLEL}.",
        f"In series:\n\n{SERIES}\n\nIn parallel:\n\n{PARALLEL}",
        "Upstroke: $F = pA+mg$.\n\nDownstroke: $F = pA-mg$.",
        "At low speed $T = k$.\n\nAt high speed $T = 2k$.",
        "Beim Ansaugen gilt $F = pA+mg$, beim Verdichten gilt $F = pA-mg$.",
        f"単純支持の場合 {SIMPLE}。\n\n片持ちの場合 {CLAMPED}。",
        f"Pour une poutre sur deux appuis {SIMPLE}.\n\nPour une console {CLAMPED}.",
        "On the way up $T = m(g+a)$, on the way down $T = m(g-a)$.",
        "It is $s = a+b$ after von Mises and $s = a+2b$ after Tresca.",
        "It is $s = a+b$ (von Mises) or $s = a+2b$ (Tresca).",
        "For $x = y^2$ we have $dx/dy = 2y$.\nFor $x = y^3$ we have $dx/dy = 3y^2$.",
        "Für $M = a\\sin^2 u$ ist $M/a = \\sin^2 u$, für $M = a\\cos^2 u$ ist $M/a = \\cos^2 u$.",
    ],
)
def test_openings_that_name_two_things_open_two_cases(page):
    assert not {"undecided", *ACCUSED} & set(words_of(page + "\n"))


@pytest.mark.parametrize(
    "page",
    [
        f"For a cantilever {CLAMPED}.\n\nFor a cantilever $f = \\frac{{Fl^3}}{{8EI}}$.",
        f"For a simply supported beam {SIMPLE}.\n\nSo for a cantilever {CLAMPED}.",
        "Step 1: $F = m(a+b)$\n\nStep 2: $F = ma+2mb$",
        "Kinematics: $F = m(a+b)$\n\nSimplified: $F = ma+2mb$",
        "In general: $F = m(a+b)$\n\nFor our engine: $F = ma+2mb$",
        "The force is $F = m(a+b)$.\n\nWith the brackets opened, $F = ma+2mb$.",
        "The force is $F = m(a+b)$.\n\nIn other words, $F = ma+2mb$.",
        "The force is $F = m(a+b)$.\n\nFor this we write $F = ma+2mb$.",
    ],
)
def test_openings_of_the_same_thing_open_none(page):
    assert words_of(page + "\n")[-1] == "refuted"


@pytest.mark.parametrize(
    ("page", "word"),
    [
        (f"The deflection is {SIMPLE}; for the cantilever it is {CLAMPED}.", "undecided"),
        (f"Die Durchsenkung ist {SIMPLE}, für den Kragbalken ist sie {CLAMPED}.", "undecided"),
        (f"The cantilever has {SIMPLE}; for the cantilever it is {CLAMPED}.", "refuted"),
        ("The force is $F = m(a+b)$; for the engine it is $F = ma+2mb$.", "refuted"),
    ],
)
def test_a_formula_for_a_thing_of_its_own_is_no_claim_of_the_other(page, word):
    assert words_of(page + "\n")[-1] == word


SPEEDS = "At $n = 1000$ rpm: $F = 10$ N. At $n = 2000$ rpm: $F = 40$ N.\n\n"
ENGINES = "Engine A: $r = 40$ mm. Engine B: $r = 60$ mm.\n\n"


@pytest.mark.parametrize(
    "again", ["Engine A: ", "Back to engine A: ", "For engine A ", "The stroke of engine A is "]
)
def test_a_case_named_again_has_its_own_values(again):
    page = f"{ENGINES}{again}$2r = {{}}$ mm.\n\nEngine B: $2r = 120$ mm.\n"
    assert words_of(page.format(80))[-2:] == ["holds", "holds"]
    assert words_of(page.format(120))[-2:] == ["refuted", "holds"]


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (SPEEDS + "At $n = 1000$ rpm: $2F = {}$ N.", 20, 80),
        ("|Engine A|$r = 40$ mm|\n|---|---|\n|Engine B|$r = 60$ mm|\n|Engine A|$2r = {}$ mm|", 80, 120),
        ("Motor 1: $r = 40$ mm\n\nMotor 2: $r = 60$ mm\n\nFür Motor 1 ist $2r = {}$ mm.", 80, 120),
        ("In series: $c = ab$\n\nIn parallel: $c = a+b$\n\nIn series: $c^2 = {}$", "a^2b^2", "(a+b)^2"),
    ],
)  # fmt: skip
def test_a_case_of_another_kind_named_again_has_its_own_values(page, right, wrong):
    assert words_of(page.format(right) + "\n")[-1] == "holds"
    assert words_of(page.format(wrong) + "\n")[-1] == "refuted"


@pytest.mark.parametrize(
    "line",
    [
        "Compared with engine A, the stroke is $2r = 120$ mm.",
        "From here on $r = 50$ mm.\n\nEngine A: $2r = 100$ mm.",
        "Engine A: $r = 45$ mm.\n\nEngine A: $2r = 90$ mm.",
    ],
)
def test_what_is_said_of_another_case_or_of_all_is_not_judged_by_the_first(line):
    assert words_of(f"{ENGINES}{line}\n")[-1] == "holds"


@pytest.mark.parametrize("lead", ["So ", "Hence ", "This gives ", "Daraus folgt "])
@pytest.mark.parametrize("formula", ["\\cosθ", "\\cosθ+3", "x+1"])
def test_a_number_that_words_lead_to_is_no_new_case_of_a_formula(lead, formula):
    assert words_of(f"$u = {formula}$\n\n{lead}$u = 2$.\n") == ["definition", "undecided"]


@pytest.mark.parametrize(
    "page",
    [
        "$u = x+1$\n\nAt rest $u = 2$.\n",
        "$u = x+1$\n\nLet $u = 2$.\n",
        "$u = x+1$ with $x = 1$. So $u = 2$.\n",
        "For equal masses $u = x+1$. So $u = 2$.\n",
    ],
)
def test_a_number_without_such_words_may_be_a_case(page):
    assert not {"undecided", *ACCUSED} & set(words_of(page))
