"""A number that only words suppose is what their sentence's conclusion is judged by."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

SENTENCES = [
    "We have $x = 4$. If $x$ were $3$, then $x^2 = {}$.",
    "We have $x = 4$. If x were 3, then $x^2 = {}$.",
    "Es ist $x = 4$. Wäre $x$ gleich $3$, so wäre $x^2 = {}$.",
    "Es ist $x = 4$. Wenn $x$ gleich 3 wäre, so wäre $x^2 = {}$.",
    "On a $x = 4$. Si $x$ était égal à 3, on aurait $x^2 = {}$.",
    "Abbiamo $x = 4$. Se $x$ fosse 3, sarebbe $x^2 = {}$.",
    "Tenemos $x = 4$. Si $x$ fuera igual a 3, sería $x^2 = {}$.",
    "$x = 4$ である。もし $x$ が 3 なら、$x^2 = {}$ である。",
]


@pytest.mark.parametrize("sentence", SENTENCES)
def test_it_is_judged_by_what_is_supposed(tmp_path, sentence):
    assert last_verdict(tmp_path, sentence.format(9)) == "conditional"
    assert last_verdict(tmp_path, sentence.format(16)) == "refuted"
    assert last_verdict(tmp_path, sentence.format(10)) == "refuted"


def test_what_is_so_again_is_judged_by_that(tmp_path):
    page = "We have $x = 4$. If x were 3, then $x^2 = 9$, but it is 4 and $x^2 = {}$."
    assert last_verdict(tmp_path, page.format(16)) == "holds"
    assert last_verdict(tmp_path, page.format(9)) != "holds"


def test_a_letter_computed_from_it_follows(tmp_path):
    page = "We have $x = 4$ and $y = 2x = 8$. If $x$ were 3, we would have $y = {}$."
    assert last_verdict(tmp_path, page.format(6)) == "conditional"
    assert last_verdict(tmp_path, page.format(8)) not in ("holds", "conditional", "holds_to_order")
