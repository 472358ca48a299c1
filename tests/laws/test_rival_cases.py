"""Cases of which only one can be true do not contradict one another, and what is supposed ends."""

import pytest

import symbalance as sb

RIVALS = [
    "There are three cases:\n\n- x < y\n- x = y\n- x > y\n",
    "Either $x<y$ or $y<x$.\n",
    "Entweder $x<y$ oder $y<x$.\n",
    "Soit $x<y$, soit $y<x$.\n",
    "O $x<y$ o $y<x$.\n",
    "We distinguish $x<y$, $x=y$ and $x>y$.\n",
    "三つの場合 $x<y$, $x=y$, $x>y$ がある。\n",
    "Either $x = y$ or $x = 2y$.\n",
    "One of $x<y$, $x=y$, $y<x$ holds.\n",
    "* $\\Omega<\\omega$: below\n* $\\Omega=\\omega$: at it\n* $\\Omega>\\omega$: above\n",
    "- $a<b$: then $b - a > 0$.\n- $a=b$: then $b - a = 0$.\n- $a>b$: then $b - a < 0$.\n",
    "| case | condition |\n|---|---|\n| 1 | $x<y$ |\n| 2 | $x=y$ |\n| 3 | $x>y$ |\n",
]
SUPPOSED = [
    "The stiffness is k = 5. If k were equal to 3, i.e. k = 3, then it would fall.\n",
    "k = 5. If k were 3, i.e. k = 3, then 2k = 6. But k = 5, so 2k = 10.\n",
    "Es sei k = 5. Wäre k gleich 3, also k = 3, so wäre die Frequenz kleiner.\n",
]
AT_ODDS = [
    "We have x < y. Also y < x.\n",
    "$x<y$ and $y<x$.\n",
    "- $x<y$ holds.\n- We also have $x>y$.\n",
    "- $a<b$: then $b - a > 0$.\n- $a=b$: then $b - a = 0$.\n- $a>b$: then $b - a > 0$.\n",
    "k = 5. If k were 3, i.e. k = 3, then 2k = 6. But k = 5, so 2k = 6.\n",
    "Since $x<y$ and $y<z$, $z<x$.\n",
]


def test_an_or_between_two_ways_to_write_one_law_leaves_both():
    page = r"$\lambda = r/l$. We have $l\sin\beta = r\sin\theta$, or $\sin\beta = \lambda\sin\theta$."
    assert [link["verdict"] for link in sb.check(page, {}).data()["links"]][-1] == "holds"


def _is_accused(page):
    links = sb.check(page, {}).data()["links"]
    return bool({"refuted", "contradiction"} & {link["verdict"] for link in links})


@pytest.mark.parametrize("page", [*RIVALS, *SUPPOSED])
def test_cases_and_suppositions_contradict_nothing(page):
    assert not _is_accused(page)


@pytest.mark.parametrize("page", AT_ODDS)
def test_what_is_said_to_be_so_together_does(page):
    assert _is_accused(page)
