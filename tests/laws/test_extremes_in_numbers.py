"""A number said to be the largest, smallest or mean value of a formula above is computed from it."""

import pytest

from symbalance.checking import check

TORQUE = r"$M = 100 + 50\sin 2\theta$. "
BOTH = r"Mit $A = 3$ und $B = 4$ ist $y = A\sin\theta + B\cos\theta$. "
ENDS = r"$\omega_{max} = 105$ rad/s, $\omega_{min} = 95$ rad/s. "


def last(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    ("said", "right", "wrong"),
    [
        (TORQUE + "The maximum is $M_{max} = NUMBER$.", "150", "125"),
        (TORQUE + "Its smallest value is $M_{min} = NUMBER$.", "50", "100"),
        (TORQUE + "The mean torque is $M_m = NUMBER$.", "100", "125"),
        (TORQUE + "Le couple moyen vaut $M_m = NUMBER$.", "100", "50"),
        (BOTH + "Der größte Wert ist $y_{max} = NUMBER$.", "5", "7"),
        (ENDS + r"The mean speed is $\omega_m = NUMBER$ rad/s.", "100", "105"),
        (ENDS + r"平均は $\omega_m = NUMBER$ rad/s.", "100", "95"),
    ],
)
def test_an_extreme_or_a_mean_in_numbers(said, right, wrong):
    assert last(said.replace("NUMBER", right)) == "holds_to_order"
    assert last(said.replace("NUMBER", wrong)) == "refuted"


@pytest.mark.parametrize(
    "said",
    [
        TORQUE + "The maximum permissible torque is $M_{max} = 125$.",
        TORQUE + "Between 0 and 10° the largest is $M_{max} = 117$.",
        TORQUE + "With that, $K_{max} = 125$.",
    ],
)
def test_an_extreme_of_something_else_is_a_datum(said):
    assert last(said) in ("definition", "premise")


def test_a_subscript_names_an_extreme_without_words():
    assert last(TORQUE + "With that, $M_{max} = 150$.") in ("holds", "holds_to_order", "conditional")
    assert last(TORQUE + "With that, $M_{max} = 125$.") == "refuted"
