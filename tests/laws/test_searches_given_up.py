"""A search that took too long leaves a definition, and the verdict says that it was given up."""

import pytest

from symbalance.budgets import OverBudgetError
from symbalance.checking import check
from symbalance.notes.checking.meant import named_quantities
from symbalance.notes.checking.meant.pistons import crank_motions

PAGES = {
    "a standard formula": (
        named_quantities,
        "The torsional stress is $\\tau = \\frac{32T}{\\pi d^3}$.\n",
    ),
    "a motion": (
        crank_motions,
        "At bottom dead centre of the crank mechanism the piston acceleration is"
        " $b = r\\omega^2 (1 + \\lambda)$.\n",
    ),
}


def _gives_up(*_):
    raise OverBudgetError("2 s")


@pytest.mark.parametrize("what", PAGES)
def test_a_search_given_up_is_said(monkeypatch, what):
    module, page = PAGES[what]
    assert check(page).data()["links"][-1]["verdict"] == "refuted"
    monkeypatch.setattr(module, "run_within", _gives_up)
    last = check(page).data()["links"][-1]
    assert last["verdict"] == "definition"
    assert last["reason"] == f"whether its words name {what} was not decided within 2 s"
