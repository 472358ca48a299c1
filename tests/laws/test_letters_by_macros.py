r"""Letters written by a document's own macros, \th for θ, where values stand behind a relation."""

import pytest

from symbalance.checking import check

HEAD = "\\newcommand{\\th}{\\theta} \\newcommand{\\lam}{\\lambda}\n\n"


def words(page: str) -> list[str]:
    return [link["verdict"] for link in check(HEAD + page).data()["links"]]


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("$\\cos 4\\th = 1$ at $\\th = 0, 90^\\circ$.", "holds"),
        ("$\\cos 2\\th = 1$ at $\\th = 0, 90^\\circ$.", "refuted"),
    ],
)
def test_a_relation_is_judged_at_each_listed_value_of_a_letter_by_a_macro(claim, verdict):
    assert words(f"The sum is {claim}")[0] == verdict


@pytest.mark.parametrize("letter", ["\\th", "\\lam", "\\unknown"])
def test_a_letter_behind_a_relation_is_no_fault(letter):
    links = check(HEAD + f"It is zero where $\\cos\\th = 0$; for ${letter} = 0.3$ it is not.").data()[
        "links"
    ]
    assert not any("fault" in (link["reason"] or "") for link in links)
