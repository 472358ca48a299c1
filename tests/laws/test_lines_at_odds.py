"""A letter that two sections give different formulas: wrong by a slip, or another engine's."""

import pytest

from symbalance.checking import check

OTHER = """The single has $F = m r ω² \\cos θ$ at any crank angle θ.

# Another rig

The rig of the second chapter has $F = {right}$ in its bearing.
"""


def verdicts(right: str, **options: bool) -> list[tuple[str, str | None]]:
    links = check(OTHER.replace("{right}", right), **options).data()["links"]
    return [(link["verdict"], link["reason"]) for link in links]


@pytest.mark.parametrize(
    "right", ["m r ω² \\cos 2θ", "-m r ω² \\cos θ", "2 m r ω² \\cos θ", "m r ω \\cos θ", "m r ω² \\sin θ"]
)
@pytest.mark.parametrize("fixes", [True, False])
def test_a_slip_from_the_formula_above_is_refuted(right: str, fixes: bool) -> None:
    assert [verdict for verdict, _ in verdicts(right, fixes=fixes)] == ["conditional", "refuted"]


@pytest.mark.parametrize(
    "right", ["m r ω² (\\cos θ + 4 \\cos (3θ - 1))", "m r ω² (7 \\sin (5θ + 1) + \\tan θ)"]
)
@pytest.mark.parametrize("fixes", [True, False])
def test_what_no_slip_explains_may_be_another_engines(right: str, fixes: bool) -> None:
    (first, _), (second, reason) = verdicts(right, fixes=fixes)
    assert (first, second) == ("conditional", "undecided")
    assert reason == (
        "does not follow from line 1, and no single slip lies between:"
        " another case is meant, or it is wrong"
    )


ONCE_MORE = (
    "# One\n\nIt has $r = 40$ mm and $\\lambda = 0.25$, so $F = {first}$.\n\n# Two\n\n${second}$\n"
)


@pytest.mark.parametrize(
    ("second", "word"),
    [
        ("r = 60\\text{ mm}", "premise"),  # the next example's
        ("4\\lambda r = 60\\text{ mm}", "refuted"),  # 40: of its size
        ("4\\lambda r = 400\\text{ mm}", "refuted"),  # ten times too large
        ("4\\lambda r = 2900\\text{ mm}", "undecided"),  # no result of these numbers
        ("4\\lambda r = 0.25\\cdot 40\\cdot 377", "refuted"),  # with these numbers put in
    ],
)
@pytest.mark.parametrize("fixes", [True, False])
def test_a_number_is_wrong_if_it_is_a_result_of_the_numbers_above(second, word, fixes):
    page = ONCE_MORE.replace("{first}", "4 r").replace("{second}", second)
    assert check(page, fixes=fixes).data()["links"][-1]["verdict"] == word


def test_what_no_line_above_says_is_wrong_whatever_the_slip():
    page = "# One\n\n$a = 3$, $b = 4$\n\n# Two\n\n$\\cos(x + y) = \\cos x + 7\\sin^3 y$\n"
    assert check(page).data()["links"][-1]["verdict"] == "refuted"


STATED = "The counterweight has ${0} = (2M+m) r$.{1}${2}$."
SOLVED_SUMS = [
    ("B b", "B = (@M+m) r/b"),
    ("m_g r_g", "m_g = (@M+m)\\frac{r}{r_g}"),
]


@pytest.mark.parametrize(("product", "solved"), SOLVED_SUMS)
@pytest.mark.parametrize("between", [" Then ", "\n\n", "\n\nSo it is "])
def test_of_an_unproved_equation_and_another_formula_either_may_be_wrong(product, solved, between):
    for factor in ("", "3", "4"):
        verdict = check(STATED.format(product, between, solved.replace("@", factor))).verdicts[-1]
        assert (verdict.verdict, verdict.fix) == ("undecided", None)
        assert "of line 1, which nothing proves: one of the two is wrong" in verdict.reason
    right = check(STATED.format(product, between, solved.replace("@", "2"))).verdicts[-1]
    assert right.verdict in ("holds", "conditional")


def test_what_an_arrow_says_to_come_from_an_equation_is_wrong_where_it_does_not():
    page = r"$B b = (2M+m) r \Rightarrow B = (M+m) r/b$"
    assert "refuted" in [v.verdict for v in check(page).verdicts]
    assert check("$B b = 2 M r$. So $B = M r/b$").verdicts[-1].verdict == "refuted"


TORQUE = """Kurbelradius r, λ = r/l.

## Motor

- r = 45 mm
- λ = 0,3

## Massendrehmoment

$$ M = -m r^2 ω^2 (\\cos φ + λ\\cos 2φ)(\\sin φ + λ/2 \\sin 2φ) $$

{words}

$$ M = m r^2 ω^2 (λ/4 \\sin φ - 1/2 \\sin 2φ - {third} \\sin 3φ - λ^2/4 \\sin 4φ) $$

Beim Vierzylinder addieren sich die Momente der vier Zylinder.
"""


@pytest.mark.parametrize(
    ("words", "third", "verdict"),
    [
        ("Ausmultipliziert:", "3λ/4", "holds"),
        ("Ausmultipliziert:", "λ/4", "refuted"),
        ("Expanding the product gives", "λ/4", "refuted"),
        ("Ein anderer Motor:", "λ/4", "refuted"),  # by the pattern of any slider-crank's torque
    ],
)
def test_what_is_multiplied_out_is_the_same_formula(words, third, verdict):
    page = TORQUE.replace("{words}", words).replace("{third}", third)
    assert check(page).data()["links"][-1]["verdict"] == verdict


RULE = """The centrifugal force is $P = m r \\omega^2$, and $\\omega = 2\\pi N/60$.

{words} $P = {formula}$.
"""


@pytest.mark.parametrize(
    "words", ["Putting this in we obtain the rule", "Einsetzen ergibt", "これを代入すると"]
)
@pytest.mark.parametrize(("formula", "is_wrong"), [("0.01097 m r N^2", False), ("0.01097 m r N", True)])
def test_what_is_put_in_keeps_the_power_of_its_letter(words, formula, is_wrong):
    page = RULE.replace("{words}", words).replace("{formula}", formula)
    assert (check(page).data()["links"][-1]["verdict"] == "refuted") is is_wrong


WEIGHT = """We take $g = 32.2$ feet per second per second. The centrifugal force is

$$P = (W/g) \\omega^2 r$$

If it makes N revolutions per minute, $\\omega = 2\\pi N/60 = 0.1047 N$, and putting this in we obtain

$$P = FORMULA$$
"""


@pytest.mark.parametrize(
    ("formula", "is_wrong"),
    [("0.000341 W r N^2", False), ("0.000341 W r N", True), ("0.000341 W r^2 N^2", True)],
)
def test_a_rule_in_other_units_keeps_the_powers_of_its_letters(formula, is_wrong):
    verdict = check(WEIGHT.replace("FORMULA", formula)).data()["links"][-1]["verdict"]
    assert (verdict == "refuted") is is_wrong
