"""A range that another one is said to give follows from it, with its sign turned by a negative factor."""

import pytest

import symbalance as sb

PAGES = [
    ("From $-2x < 6$ it follows that $x SIGN -3$.\n", "<", ">"),
    ("$3 - 2x < 7$ gives $x SIGN -2$.\n", "<", ">"),
    ("Aus $-4y \\ge 8$ folgt $y SIGN -2$.\n", "\\ge", "\\le"),
    ("$5 - x > 2$ donne $x SIGN 3$.\n", ">", "<"),
    ("$-x \\ge 4$, so $x SIGN -4$.\n", "\\ge", "\\le"),
]


def _verdict(page):
    return sb.check(page, {}).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(("page", "wrong", "right"), PAGES)
def test_a_negative_factor_turns_the_sign(page, wrong, right):
    assert _verdict(page.replace("SIGN", wrong)) == "refuted"
    assert _verdict(page.replace("SIGN", right)) in ("range", "holds")


def test_a_wider_range_follows_and_a_narrower_does_not():
    assert _verdict("$x^2 < 4$ gives $x < 2$.\n") != "refuted"
    assert _verdict("$x^2 < 4$ gives $x < 1$.\n") == "refuted"
