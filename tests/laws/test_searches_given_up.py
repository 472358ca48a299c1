"""A search that took too long leaves a definition, and the verdict says that it was given up."""

from symbalance.budgets import OverBudgetError
from symbalance.checking import check
from symbalance.notes.checking.meant import named_quantities

PAGE = "The torsional stress is $\\tau = \\frac{32T}{\\pi d^3}$.\n"


def _gives_up(*_):
    raise OverBudgetError("2 s")


def test_a_search_given_up_is_said(monkeypatch):
    assert check(PAGE).data()["links"][-1]["verdict"] == "refuted"
    monkeypatch.setattr(named_quantities, "run_within", _gives_up)
    last = check(PAGE).data()["links"][-1]
    assert last["verdict"] == "definition"
    assert last["reason"] == "whether its words name a standard formula was not decided within 2 s"
