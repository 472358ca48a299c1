"""A force or couple of an engine with the right size is confirmed only with the phase of its cranks."""

import pytest

from symbalance.checking import check


def last(page: str) -> str:
    return check(page + "\n").data()["links"][-1]["verdict"]


THREE = "The triple's cranks stand at 0°, 120° and 240°; the cylinders are $a$ apart. "


@pytest.mark.parametrize(
    ("wave", "is_shown"),
    [
        (r"\cos(\theta + 30^\circ)", True),
        (r"\cos(\theta - \frac{\pi}{6})", True),
        (r"\sin(\theta + 60^\circ)", True),
        (r"\sin(\omega t - 60^\circ)", True),
        (r"\sin(\theta + 30^\circ)", False),
        (r"\cos(\theta + 60^\circ)", False),
        (r"\cos(\theta - 45^\circ)", False),
    ],
)
def test_a_couple_runs_before_or_behind_a_crank_of_its_engine(wave: str, is_shown: bool) -> None:
    formula = rf"Its primary couple is $C = \sqrt{{3}}\,m r\omega^2 a{wave}$."
    assert last(THREE + formula) == ("conditional" if is_shown else "definition")


@pytest.mark.parametrize(
    "phases",
    [
        r"The pistons have the phases $\theta$, $\theta+120^\circ$ and $\theta+240^\circ$. ",
        r"Die Kolben haben die Phasen $\theta$, $\theta + \frac{2\pi}{3}$, $\theta + \frac{4\pi}{3}$. ",
        r"Les phases sont $\theta$, $\theta+2\pi/3$ et $\theta+4\pi/3$. ",
        r"Le fasi sono $\theta$, $\theta+120^\circ$ e $\theta+240^\circ$. ",
        r"位相は $\theta$、$\theta+120^\circ$、$\theta+240^\circ$ である。 ",
        r"The forces cancel, $\cos\theta+\cos(\theta+120^\circ)+\cos(\theta+240^\circ) = 0$. ",
    ],
)
def test_phases_that_the_page_lists_leave_one(phases: str) -> None:
    formula = r"Its primary couple is $C = \sqrt{{3}}\,m r\omega^2 a{}$."
    assert last(THREE + phases + formula.format(r"\cos(\theta + 30^\circ)")) == "conditional"
    assert last(THREE + phases + formula.format(r"\cos(\theta - 30^\circ)")) == "definition"
    assert last(THREE + phases + formula.format(r"\cos\theta")) == "definition"


def test_a_wrong_phase_is_refuted_against_the_moment_above() -> None:
    page = (
        f"{THREE}The phases are $\\theta$, $\\theta+120^\\circ$ and $\\theta+240^\\circ$. "
        r"The outer ones leave $C = m r\omega^2 a[\cos\theta - \cos(\theta+240^\circ)]$. "
        r"In one wave, the primary couple is $C = \sqrt{{3}}\,m r\omega^2 a\cos(\theta {} 30^\circ)$."
    )
    assert last(page.format("+")) == "holds"
    assert last(page.format("-")) == "refuted"


@pytest.mark.parametrize(("degrees", "verdict"), [(45, "conditional"), (30, "premise")])
def test_the_force_of_two_cranks_runs_midway(degrees: int, verdict: str) -> None:
    page = "In a twin with cranks at 90° the primary force is $F_1 = \\sqrt{2} m r \\omega^2"
    assert last(f"{page} \\cos(\\theta + {degrees}^\\circ)$.") == verdict
