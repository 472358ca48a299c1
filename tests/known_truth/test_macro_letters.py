"""Letters that a document sets by macros of its own may be declared by these."""

import pytest

from symbalance.errors import SymbalanceError
from symbalance.notes.checking import check

PAGE = r"""\newcommand{\crank}{\varphi}
\newcommand{\lrat}{\lambda}
\newcommand{\bad}{a+b}
$\lrat = r/l$ and $\sin\beta = \lrat\sin\crank$, so
$x = r(1-\cos\crank) + l(1-\cos\beta) \approx r(1-\cos\crank + \frac{\lrat}{4}(1-\cos 2\crank))$.
"""
MEANINGS = {"r": "crank radius", "l": "length of the connecting rod", r"\beta": "connecting rod angle"}


def _verdicts(crank: str, ratio: str, page: str = PAGE) -> list[str]:
    checked = check(page, {**MEANINGS, crank: "crank angle", ratio: "crank ratio r/l"})
    return [verdict.verdict for verdict in checked.verdicts]


def test_a_macro_declares_the_letter_it_stands_for():
    by_macro = _verdicts(r"\crank", r"\lrat")
    assert by_macro == _verdicts(r"\varphi", "λ")
    assert "refuted" not in by_macro
    wrong = _verdicts(r"\crank", r"\lrat", PAGE.replace(r"\frac{\lrat}{4}", r"\frac{\lrat}{2}"))
    assert "refuted" in wrong


def test_a_macro_beside_its_letter_with_the_same_meaning_is_one_declaration():
    assert check(PAGE, {**MEANINGS, r"\lrat": "crank ratio r/l", "λ": "crank ratio r/l"}).verdicts


def test_a_macro_and_its_letter_with_two_meanings_are_refused():
    with pytest.raises(SymbalanceError, match="is declared twice"):
        check(PAGE, {r"\lrat": "crank ratio r/l", "λ": "crank radius"})


@pytest.mark.parametrize("name", [r"\bad", r"\unknown"])
def test_a_macro_of_no_letter_declares_nothing(name):
    checked = check(PAGE, {name: "crank radius"})
    assert checked.unread_letters == 1
    assert "is not a letter" in checked.data()["remarks"][0]


PICTURE = r"""\newcommand{\star}[1]{% seen from the front
  \begin{tikzpicture}
    \draw (0,0) -- (#1);

  \end{tikzpicture}}
\star{3} \star{4}

$2+2=5$
"""


def test_what_stands_behind_a_macro_of_many_lines_keeps_its_line(tmp_path):
    page = tmp_path / "page.tex"
    page.write_text(PICTURE, encoding="utf-8")
    (verdict,) = check(page).verdicts
    assert (verdict.line, verdict.verdict) == (8, "refuted")
