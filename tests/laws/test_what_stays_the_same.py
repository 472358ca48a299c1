"""A proportion is decided by an equation above where words say which of its letters stay the same."""

import pytest

from tests.checked_pages import last_in


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (
            "$E = J\\omega^2\\delta$. For given $E$ and $\\delta$ the least is $J_{{min}} \\propto {}$.",
            "1/\\omega^2",
            "1/\\omega",
        ),
        ("$E = I w^2 d$. With the same $E$ and $I$ it falls as $d \\propto {}$.", "1/w^2", "1/w"),
        (
            "On a $E = J\\omega^2\\delta$. Pour $E$ et $\\delta$ donnés $J_{{min}} \\propto {}$.",
            "1/\\omega^2",
            "1/\\omega",
        ),
    ],
)
def test_what_grows_as_what(page, right, wrong):
    assert last_in(page.format(right)) == "holds"
    assert last_in(page.format(wrong)) == "refuted"


def test_a_letter_that_may_change_leaves_it_open():
    page = "$E = I w^2 d$. With the same $I$ it falls as $d \\propto 1/w$."
    assert last_in(page) == "premise"
