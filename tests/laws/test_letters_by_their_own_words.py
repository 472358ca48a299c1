"""What stands elsewhere on a page makes no letter another one than its own words say."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import FAILING, PREMISE, PROVED_WORDS, REFUTED

CRANK = {
    "r": "Kurbelradius",
    "l": "Pleuellänge",
    "n": "Drehzahl der Kurbelwelle",
    "varphi": "Kurbelwinkel ab dem oberen Totpunkt",
    "omega": "Winkelgeschwindigkeit der Kurbelwelle",
}


def last(page: str, symbols: dict[str, str]) -> str:
    return max(check(page + "\n", symbols).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(
    "meaning",
    [
        "mittlere Kolbengeschwindigkeit",
        "mean piston speed",
        "平均ピストン速度",
        "vitesse moyenne du piston",
    ],
)
@pytest.mark.parametrize("name", ["v_m", "c_m", "u"])
def test_a_mean_piston_speed_does_not_turn_with_the_crank(meaning, name):
    page = f"Mit $r = 45$ mm und $n = 100$ Hz ist ${name} = 4 r n = VALUE$ m/s."
    assert last(page.replace("VALUE", "18"), {**CRANK, name: meaning}) in PROVED_WORDS
    assert last(page.replace("VALUE", "16"), {**CRANK, name: meaning}) == REFUTED


ONE_CYLINDERS = [
    ("F", "primary force amplitude of one cylinder", "is the primary amplitude of one cylinder"),
    ("P", "primary force of a single cylinder", "is what each cylinder gives"),
    ("F", "Amplitude der Massenkraft erster Ordnung eines Zylinders", "ist die eines Zylinders"),
]


@pytest.mark.parametrize(("name", "meaning", "behind"), ONE_CYLINDERS)
def test_one_cylinders_force_is_no_radial_engines(name, meaning, behind):
    symbols = {"m": "reciprocating mass of one cylinder", "r": "crank radius", "omega": "angular speed"}
    page = (
        f"Balance of V, boxer and radial engines (Sternmotor).\n\nHere ${name} = m r \\omega^2$ {behind}."
    )
    assert last(page, {**symbols, name: meaning}) not in FAILING


@pytest.mark.parametrize(
    "words", ["With the reciprocating mass $m$ per cylinder", "Here $m$ is one piston's mass;"]
)
def test_a_radial_engines_resultant_still_is_half_of_all(words):
    page = (
        f"# Single-row radial engine\n\n{words} the resultant primary force is $S = N m r \\omega^2HALF$."
    )
    symbols = {"m": "reciprocating mass", "r": "crank radius", "N": "number of cylinders"}
    assert last(page.replace("HALF", "/2"), symbols) in PROVED_WORDS
    assert last(page.replace("HALF", ""), symbols) == REFUTED


@pytest.mark.parametrize("speed", [r"\omega", r"\Omega"])
def test_a_crank_that_turns_at_a_speed_has_no_angle_by_it(speed):
    page = f"The crank turns at ${speed}$ and the force of one cylinder is $F = m r {speed}^POWER$."
    symbols = {"m": "reciprocating mass of one cylinder", "r": "crank radius"}
    assert last(page.replace("POWER", "2"), symbols) not in FAILING


@pytest.mark.parametrize("sign", ["=", r"\approx"])
@pytest.mark.parametrize("ratio", ["0.3071", "0.25", "0.2857"])
def test_a_ratios_number_needs_no_lengths_above(sign, ratio):
    symbols = {"r": "crank radius", "l": "rod length", "lambda": "crank radius over rod length"}
    page = f"The rod ratio is $\\lambda = r/l {sign} {ratio}$."
    assert last(page, symbols) == PREMISE
    given = f"Here $r = 43$ mm and $l = 140$ mm.\n\n$$\\lambda = r/l {sign} VALUE$$"
    assert last(given.replace("VALUE", "0.307"), symbols) in PROVED_WORDS
    assert last(given.replace("VALUE", "0.370"), symbols) == REFUTED
