"""A formula that is repeated for another thing is not proved by its first time."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
ACCUSED = ("refuted", "contradiction")


def last_word(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    "page",
    [
        r"In a parallel twin with a 360° crank the primary force is $F_1 = 2mr\omega^2\cos\theta$."
        "\n"
        r"In one with a 180° crank the primary force is $F_1 = 2mr\omega^2\cos\theta$.",
        "For springs in parallel the stiffness is $k = k_1+k_2$.\n"
        "For springs in series the stiffness is $k = k_1+k_2$.",
        "Bei Parallelschaltung der Federn gilt $c = c_1+c_2$.\n"
        "Bei Reihenschaltung der Federn gilt $c = c_1+c_2$.",
        r"360°クランクの並列2気筒では一次慣性力は $F_1 = 2mr\omega^2\cos\theta$。"
        "\n"
        r"180°クランクの並列2気筒では一次慣性力は $F_1 = 2mr\omega^2\cos\theta$。",
        "## Inline four\nThe secondary force: $F_2 = 4\\lambda mr\\omega^2\\cos2\\theta$\n"
        "## Boxer four\nThe secondary force: $F_2 = 4\\lambda mr\\omega^2\\cos2\\theta$",
        "| engine | primary force |\n|---|---|\n| single | $F_1 = m r\\omega^2$ |\n"
        "| inline four | $F_1 = 0$ |\n"
        "| boxer four | $F_1 = 0$ |\n| inline six | $F_1 = 6mr\\omega^2$ |",
        "# Solid disc\n\nThe moment of inertia is $J = \\frac12mR^2$.\n\n# Thin ring\n\n"
        "The moment of inertia is $J = \\frac12mR^2$.",
    ],
)
def test_a_formula_of_another_thing_is_judged_by_that_thing(page):
    assert last_word(page) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"A rod about its centre has $J = \frac1{12}ml^2$, about its end it has $J = \frac{1}{12}ml^2$.",
        r"Ein Stab um seinen Schwerpunkt hat $J = \frac{ml^2}{12}$, um sein Ende hat er"
        r" $J = \frac{ml^2}{12}$.",
        r"La tige autour de son centre a $J = ml^2/12$, autour de son extrémité il vaut $J = ml^2/12$.",
        r"The primary force along the cylinder is $F = mr\omega^2\cos\theta$, across it"
        r" $F = mr\omega^2\cos\theta$.",
        "For a cantilever with a load at its end the deflection is $f = \\frac{Fl^3}{3EI}$.\n"
        "For a beam on two supports the deflection is $f = \\frac{Fl^3}{3EI}$.",
        "In a 90° V-twin with both rods on one pin the secondary force has the amplitude"
        " $F_2 = \\sqrt2\\lambda mr\\omega^2$.\nIn a 60° V-twin with both rods on one pin the"
        " secondary force has the amplitude $F_2 = \\sqrt2\\lambda mr\\omega^2$.",
        "Over half a turn the mean is $s = 2/\\pi$, over a whole turn it is $s = 2/\\pi$.",
    ],
)
def test_where_nothing_is_known_of_the_other_thing_it_is_no_more_than_stated(page):
    assert last_word(page) in ("definition", "premise")


@pytest.mark.parametrize(
    "page",
    [
        "The primary force is $F_1 = m r\\omega^2\\cos\\theta$ for one cylinder.\n"
        "Inserting this, we get again $F_1 = m r\\omega^2\\cos\\theta$.",
        "The rod ratio is $\\lambda = r/l$. In the following $\\lambda = r/l$ is used.",
        "# Twin with a 360° crank\n\nThe primary force is $F_1 = 2mr\\omega^2\\cos\\theta$.\n\n"
        "## Summary\n\n"
        "The primary force is $F_1 = 2mr\\omega^2\\cos\\theta$.",
        "For $m=2$ kg and $a=3$ m/s²: $F = ma = 6$ N. For $m=4$ kg: $F = ma = 12$ N.",
    ],
)
def test_a_formula_of_the_same_thing_holds_by_its_first_time(page):
    assert last_word(page) in PROVED


@pytest.mark.parametrize(
    "page",
    [
        "In the inline four the secondary force is $F_2 = 4\\lambda mr\\omega^2\\cos2\\theta$.\n"
        "In the flat-plane V8 each bank has the secondary force"
        " $F_2 = 4\\lambda mr\\omega^2\\cos2\\theta$.",
        "In a parallel twin with a 180° crank the secondary force is"
        " $F_2 = 2mr\\omega^2\\lambda\\cos2\\theta$,\n"
        "in one with a 360° crank it is $F_2 = 2mr\\omega^2\\lambda\\cos2\\theta$.",
    ],
)
def test_what_is_right_of_both_is_not_accused(page):
    assert last_word(page) not in ACCUSED
