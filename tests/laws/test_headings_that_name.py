"""A heading names what a sentence below it gives that names nothing itself."""

import pytest

import symbalance as sb


def _verdict(page):
    return sb.check(page, {}).data()["links"][-1]["verdict"]


def test_a_heading_names_what_a_sentence_without_a_noun_gives():
    page = (
        "# Mean torque\n\nSpread over the strokes of a four-stroke engine "
        "it gives $M_m = \\frac{W}{FACTOR\\pi}$.\n"
    )
    assert _verdict(page.replace("FACTOR", "4")) == "conditional"
    assert _verdict(page.replace("FACTOR", "2")) == "refuted"


@pytest.mark.parametrize(
    "sentence",
    [
        "The greatest value in a cycle of the four-stroke engine is then",
        "Half of it in the four-stroke engine is",
        "The amplitude in the four-stroke engine is",
    ],
)
def test_another_size_of_it_is_not_what_the_heading_names(sentence):
    assert _verdict(f"# Mean torque\n\n{sentence} $M = \\frac{{W}}{{4\\pi}}$.\n") == "definition"


ASKED = [
    "The mean piston speed is wanted. With the stroke $s$ and the revolutions per second $n$ we get",
    "We now calculate the mean piston speed. It follows that",
    "Gesucht ist die mittlere Kolbengeschwindigkeit. Mit dem Hub $s$ und der Drehzahl $n$ in 1/s folgt",
    "On cherche la vitesse moyenne du piston. On obtient",
    "Si vuole calcolare la velocità media del pistone. Si ottiene",
    "平均ピストン速度を求める。ストローク $s$ と毎秒回転数 $n$ より",
]


@pytest.mark.parametrize("words", ASKED)
@pytest.mark.parametrize(("claim", "verdict"), [("2 s n", "conditional"), ("s n", "refuted")])
def test_a_sentence_that_asks_names_what_the_next_one_gives(words, claim, verdict):
    assert _verdict(f"{words}\n\n$$v = {claim}$$\n") == verdict


@pytest.mark.parametrize(
    "page",
    [
        "The mean piston speed is small. The crank pin moves at $v = r \\omega$.",
        "Determine the mean piston speed. The crank pin moves at $v = r \\omega$.",
        "Determine the mean piston speed and half of it. Half of it is $v = s n$.",
    ],
)
def test_another_sentence_does_not(page):
    assert _verdict(page) != "refuted"
