r"""Frequencies with a decimal comma in braces, 221{,}4 Hz; directions below letters, M_∥ and M_⊥."""

import pytest

import symbalance as sb

PAGE = (
    "## Kritische Drehzahlen\n\nMit $f_{\\mathrm e} = 221{,}4\\,\\mathrm{Hz}$ trifft die Ordnung $i$ bei"
    " $n_i = 60 f_{\\mathrm e}/i$ (in min⁻¹): $n_2 \\approx {speed}\\,\\mathrm{min^{-1}}$\n"
)


@pytest.mark.parametrize(("speed", "is_wrong"), [("6642", False), ("6264", True), ("4428", True)])
def test_the_speed_of_an_order(speed, is_wrong):
    last = sb.check(PAGE.replace("{speed}", speed), {}).data()["links"][-1]
    assert (last["verdict"] == "refuted") is is_wrong


@pytest.mark.parametrize(
    "pair", [(r"M_\parallel", r"M_\perp"), ("M_∥", "M_⊥"), (r"M_{\parallel}", r"M_{\perp}")]
)
def test_directions_below_a_letter_tell_two_letters_apart(pair):
    along, across = pair
    page = f"${along} = m b$ and ${across} = 2 m b$, so ${along}^2 + {across}^2 = FACTOR m^2 b^2$.\n"
    for factor, verdict in (("5", "holds"), ("4", "refuted")):
        symbols = {"m": "mass", "b": "length of an arm"}
        links = sb.check(page.replace("FACTOR", factor), symbols).data()["links"]
        assert links[-1]["verdict"] == verdict
