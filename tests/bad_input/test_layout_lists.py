"""Lists of stations, pins and distances that cannot be meant: one line with key, value, rule, remedy."""

from __future__ import annotations

import pytest

from symbalance.engine.engine_file import parse_engine
from symbalance.errors import SymbalanceError

ORDER = "firing_order = [1, 3, 2]\n"
VEE = "banks = [-45, 45]\ncylinders = [[1, 3], [2, 4]]\n"
MM = 'station_unit = "mm"\n'
REFUSED = {
    ORDER + "pitch = [91, 95]": (3, "pitch of neighbours 91 pitches apart", 'add station_unit = "mm"'),
    ORDER + MM + "pitch = [1, 1.2]": (4, "pitch of neighbours 1 mm apart", "leave out station_unit"),
    ORDER + "pitch = [1, 1, 1]": (3, "pitch = [1, 1, 1]: has 3 distances for 3 cylinders", "give 2"),
    ORDER + "stations = [0, 1, 2]": (3, "must fall from front to rear", "+ is towards the front"),
    ORDER + "stations = [0, -1, -1]": (3, "stations that lead from -1 to -1", "must fall"),
    ORDER + "stations = [0, -1]": (3, "stations of 2 values: must hold 3", "front to rear"),
    ORDER + MM + "stations = [0, -90, -180]": (3, "needs the pitch a", "give pitch = ..., mm"),
    ORDER + MM + "stagger = [10]": (3, "needs the pitch a", "give pitch = ..., mm"),
    ORDER + "stations = [0, -1, -2]\npitch = [1, 1]": (4, "twice", "leave one of them out"),
    "firing_order = [1, 2, 3]\npins = [0, 240, 120]": (
        2,
        "takes 1 turn of a crank",
        "add firing_intervals",
    ),
    "firing_order = [1, 2, 3, 4]\npins = [0, 90, 180, 270]": (2, "takes 3 turns", "correct the order"),
    "strokes = 2\nfiring_order = [1, 2, 3]\npins = [0, 120, 240]": (
        3,
        "takes 2 turns",
        "correct the order",
    ),
    "firing_order = [1, 2]\npins = [0, 180]\nfiring_intervals = [360, 360]": (
        4,
        "cylinder 2 fires 360 after 1: contradict the pins, which bring it to the top at 180",
        "correct one of them",
    ),
    "pins = [0, 120]\nfiring_intervals = [360, 360]": (3, "follow a firing order", "add firing_order"),
    VEE + "pins = [0, 90, 30, 120]": (
        4,
        "must hold 2, front to rear, or a list for each bank",
        "as in [[",
    ),
    VEE + "pins = [[0, 90]]": (4, "pins of 1 lists: must hold 2", "as in"),
    VEE + "pins = [[0, 90], [30]]": (4, "pins[2] of 1 values: must hold 2", "as in"),
    VEE + "pins = [[0, 90], [30, 120]]\nsplay = [0, 30]": (5, "listed one by one", "put it into pins"),
    VEE + "pins = [0, 90]\nsplay = [30]": (5, "has 1 values for 2 bank(s)", "in degrees"),
    VEE + "pins = [0, 90]\nstations = [[0, -1], [0, -1]]\nstagger = [0, -0.5]": (
        6,
        "stagger = [0, -1/2]: shifts banks whose stations are listed one by one",
        "put it into stations",
    ),
    VEE + "pins = [0, [90]]": (4, "pins[1] = 0: must be a list", "write it like"),
    "pins = [0, 90]\nbanks = [-45, 45]": (3, "need cylinders", "as in"),
    "banks = [0]": (1, "needs firing_order", "list the crank's pins"),
    ORDER + "splay = [30]": (3, "turns the pins that are listed", "list them with pins"),
    'pins = [0, 180]\nfiring_at = "pins"': (3, "turns the pins, which are listed", "leave one"),
}


@pytest.mark.parametrize("lines", REFUSED, ids=lambda lines: lines.replace("\n", "; ")[:60])
def test_a_list_that_cannot_be_meant(lines: str) -> None:
    line, said, remedy = REFUSED[lines]
    with pytest.raises(SymbalanceError) as caught:
        parse_engine(f"[layout]\n{lines}\n", "e.toml")
    message = str(caught.value)
    assert message.startswith(f"e.toml:{line}: ")
    assert said in message
    assert remedy in message
    assert "\n" not in message


def test_a_list_where_the_crank_train_has_one_pitch() -> None:
    with pytest.raises(SymbalanceError) as caught:
        parse_engine(f"[crank_train]\npitch = [91, 95]\n[layout]\n{ORDER}", "e.toml")
    assert str(caught.value).startswith(
        "e.toml:2: pitch of 2 values: must be one number; list distances in"
    )
