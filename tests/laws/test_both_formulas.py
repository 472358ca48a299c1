"""Both stresses that are put in make nothing twice as large; both pistons do."""

from tests.checked_pages import last_in


def test_both_formulas_put_in_are_no_factor():
    page = (
        "With $\\sigma = \\frac{32 M}{\\pi d^3}$ and $\\tau = \\frac{16 T}{\\pi d^3}$ the "
        "greatest shear stress is $\\tau_{\\max} = \\sqrt{(\\sigma/2)^2 + \\tau^2}$. Putting "
        "both stresses in gives $\\tau_{\\max} = \\frac{N}{\\pi d^3}\\sqrt{M^2 + T^2}$."
    )
    assert last_in(page.replace("N", "16")) != "refuted"
    assert last_in(page.replace("N", "32")) == "refuted"


def test_a_letter_that_one_side_loses_is_no_open_one():
    page = (
        "The first piston gives $F_A = m r\\omega^2\\cos\\theta$ and the second "
        "$F_B = m r\\omega^2\\sin\\theta$. Then $\\sqrt{F_A^2 + F_B^2} = {}$."
    )
    assert last_in(page.replace("{}", "m r\\omega^2")) == "holds"
    assert last_in(page.replace("{}", "2 m r\\omega^2")) == "refuted"
