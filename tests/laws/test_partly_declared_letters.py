"""A symbols file that declares some letters of a piston's motion hides no error, and no right formula."""

import pytest

import symbalance as sb

ACCELERATION = "The piston acceleration is $a = r\\omega^2(\\cos\\theta + TERM\\cos 2\\theta)$\n"
PARTLY = [
    {"a": "piston acceleration"},
    {"a": "Kolbenbeschleunigung", "θ": "Kurbelwinkel"},
    {"a": "piston acceleration", "r": "crank radius", "ω": "angular speed"},
    {"a": "piston acceleration", "λ": "crank ratio"},
]


def _verdict(page, symbols):
    return sb.check(page, symbols).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("symbols", PARTLY)
def test_a_motion_is_judged_by_its_words_where_not_all_its_letters_are_declared(symbols):
    assert _verdict(ACCELERATION.replace("TERM", r"\lambda"), symbols) == "conditional"
    assert _verdict(ACCELERATION.replace("TERM", r"\frac{\lambda}{4}"), symbols) == "refuted"
