"""A page that has the power of a four-stroke and of a two-stroke engine has each for its own engine."""

import pytest

import symbalance as sb

SYMBOLS = {"symbols": {"N": "rotational speed [rev/s]", "P": "power [W]", "p_m": "pressure [Pa]"}}
BOTH = {
    "en": (
        "A four-stroke engine has the power $P = p_m V N/2$, a two-stroke engine $P = p_m V N$.\n\n",
        "The mean torque of the four-stroke engine is ",
        "The mean torque of the two-stroke engine is ",
    ),
    "de": (
        "Ein Viertaktmotor hat die Leistung $P = p_m V N/2$, ein Zweitaktmotor $P = p_m V N$.\n\n",
        "Das mittlere Drehmoment des Viertaktmotors ist ",
        "Das mittlere Drehmoment des Zweitaktmotors ist ",
    ),
}


def _last(page):
    return sb.check(page, SYMBOLS).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("language", BOTH)
@pytest.mark.parametrize(
    ("engine", "torque", "verdict"),
    [(1, r"4\pi", "holds"), (1, r"2\pi", "refuted"), (2, r"2\pi", "holds"), (2, r"4\pi", "refuted")],
)
def test_the_torque_of_each_engine_goes_with_its_own_power(language, engine, torque, verdict):
    words = BOTH[language]
    formula = rf"$T_m = \frac{{P}}{{2\pi N}} = \frac{{p_m V}}{{{torque}}}$"
    assert _last(f"{words[0]}{words[engine]}{formula}.\n") == verdict


def test_words_that_name_both_engines_choose_none():
    words = "The mean torque of a two-stroke or a four-stroke engine is "
    formula = r"$T_m = \frac{P}{2\pi N} = \frac{p_m V}{4\pi}$"
    assert _last(f"{BOTH['en'][0]}{words}{formula}.\n") != "holds"
