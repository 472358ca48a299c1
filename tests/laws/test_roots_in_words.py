"""Roots are what their words call them: the only one, the smaller, positive, in the third quadrant."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def last(tmp_path, page):
    path = tmp_path / "page.md"
    path.write_text(page)
    return check(path, fixes=False).verdicts[-1].verdict


@pytest.mark.parametrize(
    "page",
    [
        "From x² = 4 we get x = 2, the only solution.",
        "From y² = 4 we get y = 2 only.",
        "The only solution of x² = 9 is x = 3.",
        "x² − 5x + 6 = 0 has exactly one root, x = 3.",
        "x² − 5x + 6 = 0 has only the solution x = 3.",
        "There is exactly one x with x² = 4, x = 2.",
        "x² = 4 hat nur die Lösung x = 2.",
        "Die einzige Lösung von z² = 4 ist z = 2.",
        "x² = 4 a pour unique solution x = 2.",
        "x² = 4 の解は x = 2 だけである。",
        "|x − 2| = 3 gives x = 5 and no other value.",
        "sin θ = ½ has in 0 ≤ θ ≤ 180° the only solution θ = 30°.",
        "With cos θ = 0, θ = 90° is the only angle between 0 and 360°.",
        "x³ = x has two roots, x = 0 and x = 1.",
        "x² − 5x + 6 = 0 has the double root x = 3.",
    ],
)
def test_there_is_another_root(tmp_path, page):
    assert last(tmp_path, page) == "refuted"


def test_a_letter_before_its_equation_is_not_the_only_root(tmp_path):
    path = tmp_path / "page.md"
    path.write_text("x = 2 is the unique solution of x² = 4.")
    assert check(path, fixes=False).verdicts[0].verdict == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "x² − 2x + 1 = 0 has the only root x = 1.",
        "x² − 4x + 4 = 0 has exactly one root, x = 2.",
        "x² − 6x + 9 = 0 has the double root x = 3.",
        "(x − 1)(x − 2)² = 0 has the double root x = 2.",
        "sin θ = ½ has in 0 ≤ θ ≤ 90° the only solution θ = 30°.",
        "x² = 4 with x > 0 has the only solution x = 2.",
        "x² = 4 hat genau zwei Lösungen, x = 2 und x = −2.",
        "x³ = 8 hat nur die Lösung x = 2.",
    ],
)
def test_there_is_none(tmp_path, page):
    assert last(tmp_path, page) in PROVED


@pytest.mark.parametrize(
    "page",
    [
        "x² − 5x + 6 = 0 has the roots x_1 = 2 and x_2 = 3. The smaller one is x_2 = 3.",
        "x² − 5x + 6 = 0. The smaller root is x = 3.",
        "x² − 5x + 6 = 0 hat die Lösungen x_1 = 2 und x_2 = 3. Die größere Lösung ist x_1 = 2.",
        "x² − x − 6 = 0 has the roots x = 3 and x = −2. We need the positive root, x = −2.",
        "x² = 4 a deux solutions, x = 2 et x = −2. La solution positive est x = −2.",
        "Since x is negative, x² = 9 gives x = 3.",
        "x² + 2x − 8 = 0 has a positive and a negative solution: x_1 = −4 and x_2 = 2, respectively.",
        "sin x = 0.5. The acute solution is x = 30°, the obtuse one x = 30°.",
        "sin x = 0.5. The obtuse solution is x = 30°.",
        "cos θ = −½, in the third quadrant, so θ = 120°.",
        "tan θ = 1 has in the third quadrant the solution θ = 45°.",
        "sin θ = ½ and θ is obtuse, hence θ = 30°.",
        "sin θ = 0.5. Im zweiten Quadranten ist θ = 30°.",
        "sin θ = 3/5 with θ in the second quadrant gives cos θ = 4/5.",
        "θ is obtuse with sin θ = 0.6, so cos θ = 0.8.",
        "θ is obtuse with sin θ = 0.6, so cos θ = −0.7.",
    ],
)
def test_a_root_of_another_kind_is_refuted(tmp_path, page):
    assert last(tmp_path, page) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "x² − 5x + 6 = 0 has the roots x_1 = 2 and x_2 = 3. The smaller one is x_1 = 2.",
        "x² − 5x + 6 = 0. The smaller root is x = 2.",
        "x² − 5x + 6 = 0. Rejecting the smaller root, x = 3.",
        "x² − x − 6 = 0. Since m is positive, x = −2 is left out.",
        "x² − x − 6 = 0. The positive root is x = 3, the negative one x = −2.",
        "λ² − 5λ + 4 = 0. The larger eigenvalue is λ = 4 and the smaller one is λ = 1.",
        "Since x is negative, x² = 9 gives x = −3.",
        "x² + 2x − 8 = 0 has a positive and a negative solution: x_1 = 2 and x_2 = −4, respectively.",
        "sin x = 0.5. The acute solution is x = 30°, the obtuse one x = 150°.",
        "cos θ = −½, in the third quadrant, so θ = 240°.",
        "sin θ = ½ and θ is obtuse, hence θ = 150°.",
        "sin θ = 0.5. Im zweiten Quadranten ist θ = 150°.",
        "sin θ = 3/5 with θ in the second quadrant gives cos θ = −4/5.",
        "θ is obtuse with sin θ = 0.6, so cos θ = −0.8.",
        "sin θ = 0.6 and θ is obtuse, so tan θ = −0.75.",
    ],
)
def test_a_root_of_its_kind_holds(tmp_path, page):
    assert last(tmp_path, page) in PROVED


@pytest.mark.parametrize(
    "page",
    [
        "cos θ = sin θ for θ = 30°.",
        "sin 2x = 2 sin x holds for x = 30°.",
        "x² = 2x for x = 3.",
        "y² + 1 = 2y gilt für y = 2.",
    ],
)
def test_an_equation_is_refuted_by_the_value_behind_it(tmp_path, page):
    path = tmp_path / "page.md"
    path.write_text(page)
    assert check(path, fixes=False).verdicts[0].verdict == "refuted"


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("x² = 2x for x = 0 and x = 2.", "holds"),
        ("x² = 2x for x = 0 and x = 3.", "refuted"),
        ("x² = 2x has the solutions x = 0 and x = 3.", "refuted"),
        ("cos x = sin x at x = 45° and x = 225°.", "holds"),
        ("cos x = sin x at x = 45° and x = 135°.", "refuted"),
        ("sin 2x = sin x at x = 0 and at x = 30°.", "refuted"),
        ("z² = −4 has the complex solutions z = 2i and z = −2i.", "holds"),
        ("z² = −4 has the complex solutions z = 2i and z = 3i.", "refuted"),
        ("z² + 2z + 5 = 0 hat die Lösungen z = −1 + 2i und z = −1 − 2i.", "holds"),
        ("z² + 4 = 0 has z = ±2i.", "holds"),
    ],
)
def test_further_values_satisfy_the_equation_or_are_refuted(tmp_path, page, expected):
    assert last(tmp_path, page) == expected


def test_an_equation_with_complex_roots_is_not_refuted(tmp_path):
    path = tmp_path / "page.md"
    path.write_text("z² = −4 has the complex solutions z = 2i and z = −2i.")
    assert check(path, fixes=False).verdicts[0].verdict == "condition"
    path.write_text("x² = −4 has the real solutions x = 2 and x = −2.")
    assert check(path, fixes=False).verdicts[0].verdict == "refuted"


SYSTEM = "{}\n\n$$y = 2x$$\n\n$$y = x + 3$$\n\n{}\n"


@pytest.mark.parametrize(
    ("before", "behind"),
    [
        ("We solve", "and get x = {}, y = {}."),
        ("Aus den beiden Gleichungen", "folgt x = {} und y = {}."),
        ("Les deux équations", "donnent x = {} et y = {}."),
        ("The two lines", "meet at x = {}, y = {}."),
    ],
)
def test_two_displayed_equations_are_a_system(tmp_path, before, behind):
    path = tmp_path / "page.md"
    path.write_text(SYSTEM.format(before, behind.format(3, 6)))
    found = [v.verdict for v in check(path, fixes=False).verdicts]
    assert found == ["definition", "condition", "conditional", "conditional"]
    path.write_text(SYSTEM.format(before, behind.format(2, 4)))
    assert "contradiction" in [v.verdict for v in check(path, fixes=False).verdicts]


def test_a_second_formula_without_such_words_is_refuted(tmp_path):
    assert last(tmp_path, SYSTEM.format("The force is", "and so on.")) == "refuted"
