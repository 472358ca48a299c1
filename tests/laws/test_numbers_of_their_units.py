"""Formulas between the numbers of units that words give their letters."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

_IN = "Put in the power $P$ in kilowatts, the torque $T$ in newton metres and the speed $n$ in rpm. "
_POWER = "From $P = T\\omega$ one gets a numerical equation. " + _IN
_ZAHLEN = (
    r"Aus $P = M\omega$ folgt die Zahlenwertgleichung mit $P$ in kW, $n$ in $\mathrm{min^{-1}}$ "
    r"und $M$ in Nm: "
)
WRONG = [
    r"The speed $n$ is given in rpm. In radians per second it is $\omega = \frac{30 n}{\pi}$.",
    r"Der Motor dreht mit $n$ Umdrehungen pro Minute. Die Drehfrequenz $f$ in Hertz ist $f = 60 n$.",
    r"Le moteur tourne à $n$ tours par minute. La fréquence de rotation $f$ en hertz vaut $f = 60 n$.",
    r"Il motore fa $n$ giri al minuto. La frequenza di rotazione $f$ in hertz è $f = 60 n$.",
    r"The frequency $f$ in hertz belongs to the speed $N$ in rpm. Here $N = \frac{f}{60}$.",
    _POWER + r"It is $P = \frac{T n}{95.49}$.",
    _POWER + r"It is $T = 9549\,\frac{n}{P}$.",
    _ZAHLEN + r"$M = 955\,\frac{P}{n}$.",
]
RIGHT = [
    r"The speed $n$ is given in rpm. In radians per second it is $\omega = \frac{\pi n}{30}$.",
    (
        r"Der Motor dreht mit $n$ Umdrehungen pro Minute. "
        r"Die Drehfrequenz $f$ in Hertz ist $f = \frac{n}{60}$."
    ),
    (
        r"Le moteur tourne à $n$ tours par minute. "
        r"La fréquence de rotation $f$ en hertz vaut $f = \frac{n}{60}$."
    ),
    r"Il motore fa $n$ giri al minuto. La frequenza di rotazione $f$ in hertz è $f = \frac{n}{60}$.",
    r"The frequency $f$ in hertz belongs to the speed $N$ in rpm. Here $N = 60 f$.",
    r"The camshaft of the speed $n$ in rpm turns at half of it, in hertz $f = \frac{n}{120}$.",
    r"With $n$ in rpm the ignition frequency in hertz is $f = \frac{n}{30}$.",
    _POWER + r"It is $P = \frac{T n}{9549}$.",
    _POWER + r"It is $T = 9549\,\frac{P}{n}$.",
    _ZAHLEN + r"$M = 9550\,\frac{P}{n}$.",
]
STROKES = """[symbols]
"v" = "mean piston speed [m/s]"
"s" = "stroke [m]"
"N" = "engine speed [rev/min]"
"""
PER_SECOND = """[symbols]
"P" = "power [W]"
"p" = "mean effective pressure [Pa]"
"V" = "swept volume [m^3]"
"N" = "engine speed [rev/s]"
"""


@pytest.mark.parametrize("page", WRONG)
def test_a_constant_that_turns_the_units_wrongly_is_refuted(tmp_path, page):
    assert "refuted" in verdicts_of(tmp_path, page)


@pytest.mark.parametrize("page", RIGHT)
def test_right_constants_and_other_shafts_are_not(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


@pytest.mark.parametrize(("formula", "is_right"), [("2 s N", False), (r"\frac{2 s N}{60}", True)])
def test_a_letter_of_revolutions_a_minute_is_divided_by_60(tmp_path, formula, is_right):
    page = f"The crankshaft makes $N$ revolutions per minute. The mean piston speed is $v = {formula}$."
    assert ("refuted" not in verdicts_of(tmp_path, page, STROKES)) is is_right


@pytest.mark.parametrize(
    ("formula", "is_right"), [(r"\frac{p V N}{120}", False), (r"\frac{p V N}{2}", True)]
)
def test_a_letter_of_revolutions_a_second_is_not(tmp_path, formula, is_right):
    page = (
        f"A four-stroke engine makes $N$ revolutions per second. Its indicated power is $P = {formula}$."
    )
    assert ("refuted" not in verdicts_of(tmp_path, page, PER_SECOND)) is is_right
