"""An equation in the crank angle that is solved right behind is a condition: where A sin θ = B cos θ."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, PROVED_WORDS, REFUTED

WHERE = [
    "The torque crosses its mean where",
    "Das Moment geht durch seinen Mittelwert, wo",
    "Le couple passe par sa moyenne où",
    "La coppia passa per la media dove",
    "El par pasa por su media donde",
    "It is so that",
]
ANGLE = {"symbols": {r"\theta": "crank angle"}}


def verdicts(words: str, formula: str):
    checked = sb.check(f"{words}\n\n\\[ {formula} \\]\n", ANGLE)
    assert not checked.faults
    return sorted(checked.verdicts, key=lambda v: (v.line, v.span))


@pytest.mark.parametrize("words", WHERE)
@pytest.mark.parametrize("arrow", [r"\Rightarrow", r"\;\Rightarrow\;", r"\quad\Rightarrow\quad"])
def test_two_waves_set_equal_have_a_ratio(words, arrow):
    found = verdicts(
        words, rf"210\sin 2\theta = 60\cos 2\theta {arrow} \tan 2\theta = \frac{{60}}{{210}}"
    )
    assert found[0].verdict == CONDITION
    assert found[-1].verdict in PROVED_WORDS


@pytest.mark.parametrize("words", WHERE)
def test_the_ratio_turned_over_is_wrong(words):
    found = verdicts(
        words, r"210\sin 2\theta = 60\cos 2\theta \;\Rightarrow\; \tan 2\theta = \frac{210}{60}"
    )
    assert found[-1].verdict in (CONTRADICTION, REFUTED)


@pytest.mark.parametrize("formula", [r"\sin 2\theta = 2\sin\theta", r"\cos 2\theta = 1 + 2\sin^2\theta"])
def test_an_identity_that_is_none_is_refuted(formula):
    assert verdicts("We have", formula)[0].verdict == REFUTED
