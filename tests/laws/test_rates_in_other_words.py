"""A frequency said again as a period or an angular frequency is computed from the first."""

import pytest

from symbalance.checking import check


def last(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    ("said", "right", "wrong"),
    [
        ("f = 50 Hz. The angular frequency is ω = {}.", "314 rad/s", "50 rad/s"),
        ("$f = 50$ Hz and the period $T = {}$.", r"20\,\mathrm{ms}", r"50\,\mathrm{ms}"),
        ("ω = 314 rad/s. The frequency is f = {}.", "50 Hz", "314 Hz"),
        ("The period is T = 20 ms and the angular frequency ω = {}.", "314 rad/s", "50 rad/s"),
        ("n = 1500 rpm. The period is T = {}.", "40 ms", "25 ms"),
        ("f = 50 Hz. Die Kreisfrequenz ist ω = {}.", "314 rad/s", "50 rad/s"),
        ("La fréquence est f = 50 Hz et la période T = {}.", "20 ms", "2 ms"),
        ("周波数は f = 50 Hz、角周波数は ω = {}。", "314 rad/s", "50 rad/s"),
        ("n = 3000 rpm, i.e. ω = {}.", "314 rad/s", "3000 rad/s"),
        ("n = 3000 rpm and the angular speed ω = {}.", "314 rad/s", "300 rad/s"),
    ],
)
def test_a_rate_said_again_holds_or_is_refuted(said, right, wrong):
    assert last(said.format(right)) in ("holds", "holds_to_order", "definition")
    assert last(said.format(wrong)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "f = 50 Hz. The natural angular frequency is ω = 200 rad/s.",
        "The engine runs at f = 50 Hz. The pump has a period of its own. Its period is T = 3 s.",
    ],
)
def test_a_rate_of_something_else_is_a_datum(page):
    assert last(page) == "definition"


@pytest.mark.parametrize(
    ("said", "right", "wrong"),
    [
        ("One turn takes T = 20 ms. Two turns take 2T = {} ms.", "40", "50"),
        ("Each piston has m = 0.4 kg. For four pistons it is 4m = {} kg.", "1.6", "1.8"),
        ("At 3000 rpm the force is F = 100 N. At 6000 rpm it is 4F = {} N.", "400", "500"),
        ("Jeder Kolben wiegt m = 0,4 kg. Bei vier Kolben sind das 4m = {} kg.", "1,6", "1,8"),
    ],
)
def test_a_multiple_of_what_has_a_value_is_no_case(said, right, wrong):
    assert last(said.format(right)) in ("holds", "conditional")
    assert last(said.format(wrong)) == "refuted"


def test_a_multiple_right_behind_for_is_a_case():
    page = "For 2α = 90° it vanishes. For a bank angle of 2α = 60° it does not."
    assert last(page) == "premise"
