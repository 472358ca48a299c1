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
