"""A value at one place of the crank ends with its section; ≈ adds no terms that nothing gives."""

import pytest

import symbalance as sb

PLACES = [
    r"In the middle of the downstroke, $\theta = 90^\circ$, the crank is across.",
    r"In der Mitte, $\theta = 90^\circ$, steht die Kurbel quer.",
    r"The engine is stopped: $\theta = \pi/2$. Then $\sin\theta = 1$.",
]
PAGE = "## Crank\n\n$x = r\\sin\\theta$ and $y = r\\cos\\theta$\n\nPLACE\n\n## Velocity\n\n$$CLAIM$$\n"
MOTION = (
    "The crank turns through $\\theta$. $\\lambda = a/l$.\n\n$$ x = a\\cos\\theta . $$\n\n$$ CLAIM $$\n"
)


def _last(page, symbols=()):
    return sb.check(page, dict(symbols)).data()["links"][-1]


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("claim", [r"\sin 2\theta = 0", "x = r", r"\cos\theta = 0"])
def test_a_place_of_the_crank_ends_with_its_section(place, claim):
    page = PAGE.replace("PLACE", place).replace("CLAIM", claim)
    assert _last(page)["verdict"] not in ("holds", "holds_to_order", "conditional")
    here = page.replace("## Velocity\n\n", "")
    assert _last(here)["verdict"] == "conditional"
    assert "theta" in _last(here)["assumption"] or "θ" in _last(here)["assumption"]


@pytest.mark.parametrize(
    "term", ["", r"+\frac{\lambda}{4}\sin 2\theta", r"+\lambda", r"-\lambda^2\cos\theta"]
)
def test_roughly_adds_no_term_that_the_left_side_does_not_have(term):
    claim = rf"\dot x \approx -a\omega(\sin\theta{term})"
    is_proved = _last(MOTION.replace("CLAIM", claim))["verdict"] in (
        "holds_to_order",
        "conditional",
        "holds",
    )
    assert is_proved == (not term)


def test_the_angle_that_solves_an_equation_is_one_of_its_section():
    page = (
        "$\\lambda = r/l$ and $y = r\\sin\\theta$.\n\n## One place\n\nWe look at\n\n"
        "$$\\cos\\theta = \\frac{\\lambda - 1}{\\lambda + 1}$$\n\n## Force\n\n"
        "$$\\lambda\\cos\\theta + \\cos\\theta + 1 = \\lambda$$\n"
    )
    crank = {"θ": "crank angle"}
    assert _last(page, crank)["verdict"] not in ("holds", "conditional")
    assert _last(page.replace("## Force\n\n", ""), crank)["verdict"] == "conditional"
