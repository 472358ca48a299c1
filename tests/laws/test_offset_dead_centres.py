"""The dead centres of an offset crank: stretched it is l + r long, folded l - r."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, DEFINITION, PREMISE, REFUTED

PAGES = [
    "The cylinder is offset by $c$ (désaxé). The dead centres are where crank and rod lie on one line:",
    "Der Kurbeltrieb ist um $c$ geschränkt. In den Totpunkten sind Kurbel und Pleuel auf einer Geraden:",
    "La manivelle est désaxée de $c$. Aux points morts la bielle et la manivelle sont alignées :",
    "Il manovellismo è disassato di $c$. Nei punti morti biella e manovella sono allineate:",
    "オフセット $c$ のあるクランクの死点では",
]
FORMULAS = [
    (r"\theta_{T} = \arcsin\frac{c}{l+r}", r"\theta_{T} = \arcsin\frac{c}{l-r}"),
    (r"\varphi_{OT} = \arcsin\frac{c}{l+r}", r"\varphi_{OT} = \arcsin\frac{c}{l-r}"),
    (r"\theta_{B} = 180^\circ + \arcsin\frac{c}{l-r}", r"\theta_{B} = 180^\circ + \arcsin\frac{c}{l+r}"),
    (r"\alpha_{u} = \pi - \arcsin\frac{c}{L-R}", r"\alpha_{u} = \pi - \arcsin\frac{c}{L+R}"),
]


def last(page: str, symbols: dict[str, str] | None = None) -> str:
    checked = check(page + "\n", symbols or {})
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(("right", "wrong"), FORMULAS)
@pytest.mark.parametrize("page", PAGES)
def test_stretched_is_the_sum_and_folded_the_difference(page, right, wrong):
    assert last(f"{page}\n\n$${right}$$") == CONDITIONAL
    assert last(f"{page}\n\n$${wrong}$$") == REFUTED


def test_the_declaration_says_which_dead_centre_is_meant():
    symbols = {"theta_x": "crank angle of bottom dead centre"}
    formula = "$$\\theta_x = \\pi + \\arcsin\\frac{c}{l SIGN r}$$"
    page = f"{PAGES[0]}\n\n{formula}"
    assert last(page.replace("SIGN", "-"), symbols) == CONDITIONAL
    assert last(page.replace("SIGN", "+"), symbols) == REFUTED


@pytest.mark.parametrize("formula", [wrong for _, wrong in FORMULAS])
def test_on_other_pages_it_is_any_angle(formula):
    assert last(f"The two bars enclose an angle.\n\n$${formula}$$") in (DEFINITION, PREMISE)
