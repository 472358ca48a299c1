"""Where two engines are labelled, "A: V = 490 cc" and "628 rad/s for A" are of engine A's numbers."""

import pytest

import symbalance as sb

DATA = """Two motors are compared.

    motor A: bore D = 79 mm, stroke S = 100 mm, speed N = 6000 rpm
    motor B: bore D = 95 mm, stroke S = 70 mm, speed N = 9000 rpm

"""
PAGES = [
    ("V = pi/4*D^2*S. That gives\n\n    A: V = {}\n    B: V = {}\n", "490 cc", "496 cc"),
    (
        "The crank speed is w = 2*pi*N/60, that is w = {} for A and w = {} for B.\n",
        "628.3 rad/s",
        "942.5 rad/s",
    ),
    ("The crank radius is r = S/2, so A has r = {} and B has r = {}.\n", "50 mm", "35 mm"),
]
PROVED = ("holds", "holds_to_order", "conditional", "premise")


def _verdicts(page):
    return [link["verdict"] for link in sb.check(page, {}).data()["links"]][-2:]


@pytest.mark.parametrize(("page", "first", "second"), PAGES)
def test_each_label_has_its_own_numbers(page, first, second):
    assert set(_verdicts(DATA + page.format(first, second))) <= set(PROVED)


@pytest.mark.parametrize(("page", "first", "second"), PAGES[:2])
def test_the_numbers_of_one_are_not_those_of_the_other(page, first, second):
    assert not set(_verdicts(DATA + page.format(second, first))) & {
        "holds",
        "holds_to_order",
        "conditional",
    }
