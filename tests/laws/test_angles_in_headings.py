"""Sections whose headings name different crank angles are of different engines: 180°, then 270°."""

import pytest

from symbalance.notes.checking import check

PAGE = """# {first}

Both pistons: $F_I = 2 F_0\\cos\\theta$ with $\\theta_2 = \\theta + 360°$.

# {second}

With $\\theta_2 = \\theta + 270°$ we have $\\cos(\\theta + 270°) = \\sin\\theta$, and then

$F_I = F_0(\\cos\\theta + \\sin\\theta)$
"""


def words(first: str, second: str) -> list[str]:
    return [v.verdict for v in check(PAGE.replace("{first}", first).replace("{second}", second)).verdicts]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("360°", "270°: the modern one"),
        ("The twin with a $360^\\circ$ crank", "The twin with a $270^\\circ$ crank"),
        ("360 degrees", "270 degrees"),
        ("360-Grad-Welle", "270-Grad-Welle"),
        ("360度クランク", "270度クランク"),
    ],
)
def test_a_section_of_another_crank_angle_has_formulas_of_its_own(first, second):
    assert not {"refuted", "contradiction", "undecided"} & {*words(first, second)}


@pytest.mark.parametrize(
    ("first", "second"), [("360°", "360° once more"), ("The force", "The sum"), ("The force", "At 270°")]
)
def test_a_section_of_no_other_angle_has_not(first, second):
    assert words(first, second)[-1] == "refuted"


@pytest.mark.parametrize(("first", "second"), [("The 360 (old British)", "The 180 (seventies Honda)")])
@pytest.mark.parametrize("head", ["F", "\\frac{F}{P}"])
def test_a_formula_over_a_letter_is_of_its_own_section(first, second, head):
    over = "" if head == "F" else "/P"
    page = (
        f"# {first}\n\n$F = 2P(\\cos\\theta + q\\cos 2\\theta)$\n\n# {second}\n\n"
        f"${head} = P{over}[\\cos\\theta + \\cos(\\theta + 180^\\circ)]"
        f" + q P{over}[\\cos 2\\theta + \\cos(2\\theta + 360^\\circ)]$"
    )
    assert check(page).verdicts[-1].verdict != "refuted"
