r"""Numbers that stand before the name of their size, two names before two numbers, a decay in periods."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_in

_ENGLISH = "The engine has four cylinders with 80 mm bore and 90 mm stroke. "
_GERMAN = "Ein Vierzylindermotor hat 80 mm Bohrung und 90 mm Hub. "
_FRENCH = "Un moteur à quatre cylindres a 80 mm d'alésage et 90 mm de course. "
_JAPANESE = "4気筒エンジンのボアは80 mm、ストロークは90 mmである。"
_PAIR = "Bore and stroke are 80 mm and 160 mm. "
_DECAY = r"In five periods the amplitude falls from 9 mm to 3 mm. The logarithmic decrement is $\delta = "
_ITALIAN = "Il pistone ha una corsa di 80 mm e il motore gira a 4500 giri/min. La sua velocità media è "
_WHEEL = (
    r"Le volant a un moment d'inertie de $0{,}3\,\mathrm{kg\,m^2}$ et tourne à $150\,\mathrm{rad/s}$. "
    r"L'énergie cinétique vaut "
)
WRONG = [
    _ENGLISH + r"The total displacement is $V = 4\cdot\pi\cdot 8^2\cdot 9 = 7238\,\mathrm{cm^3}$.",
    _ENGLISH + r"The total displacement is $V = \frac{\pi}{4}\cdot 8^2\cdot 9 = 452\,\mathrm{cm^3}$.",
    _GERMAN + r"Der Gesamthubraum ist $V = \frac{\pi}{4}\cdot 8^2\cdot 9 = 452\,\mathrm{cm^3}$.",
    _GERMAN + r"Der Hubraum eines Zylinders ist $V_h = \pi\cdot 8^2\cdot 9 = 1810\,\mathrm{cm^3}$.",
    _FRENCH + r"La cylindrée totale vaut $V = 4\cdot\pi\cdot 8^2\cdot 9 = 7238\,\mathrm{cm^3}$.",
    _JAPANESE + r"総排気量は $V = 4\cdot\pi\cdot 8^2\cdot 9 = 7238\,\mathrm{cm^3}$ である。",
    _PAIR + r"The swept volume is $V = \frac{\pi}{4}\cdot 8^2\cdot 8 = 402\,\mathrm{cm^3}$.",
    _ITALIAN + r"$v = \frac{0{,}08\cdot 4500}{60} = 6\,\mathrm{m/s}$.",
    r"行程80 mmのピストンが毎分4500回転で動く。平均速度は $v = \frac{0.08\cdot 4500}{60} = 6$ m/sだ。",
    _WHEEL + r"$E = 0{,}3\cdot 150^2 = 6750\,\mathrm{J}$.",
    r"A car of 1200 kg runs at 20 m/s. Its kinetic energy is $E = 1200\cdot 20^2 = 480000\,\mathrm{J}$.",
    _DECAY + r"5\ln 3 = 5.49$.",
    _DECAY + r"\frac{1}{5}\ln\frac{1}{3} = -0.22$.",
]
RIGHT = [
    _ENGLISH
    + r"The total displacement is $V = 4\cdot\frac{\pi}{4}\cdot 8^2\cdot 9 = 1810\,\mathrm{cm^3}$.",
    _ENGLISH
    + r"The swept volume of one cylinder is $V = \frac{\pi}{4}\cdot 8^2\cdot 9 = 452\,\mathrm{cm^3}$.",
    _GERMAN + r"Der Gesamthubraum ist $V = \pi\cdot 8^2\cdot 9 = 1810\,\mathrm{cm^3}$.",
    _GERMAN + r"Der Hubraum ist $V_h = \frac{\pi}{4}\cdot 8^2\cdot 9 = 452\,\mathrm{cm^3}$.",
    _GERMAN + r"Der Hubraum ist $V_H = \pi\cdot 8^2\cdot 9 = 1810\,\mathrm{cm^3}$.",
    _FRENCH
    + r"La cylindrée totale vaut $V = 4\cdot\frac{\pi}{4}\cdot 8^2\cdot 9 = 1810\,\mathrm{cm^3}$.",
    _JAPANESE + r"総排気量は $V = 4\cdot\frac{\pi}{4}\cdot 8^2\cdot 9 = 1810\,\mathrm{cm^3}$ である。",
    _PAIR + r"The swept volume is $V = \frac{\pi}{4}\cdot 8^2\cdot 16 = 804\,\mathrm{cm^3}$.",
    _PAIR + r"The crank radius is $r = \frac{16}{2} = 8\,\mathrm{cm}$.",
    _ITALIAN + r"$v = \frac{0{,}08\cdot 4500}{30} = 12\,\mathrm{m/s}$.",
    _WHEEL + r"$E = \frac{1}{2}\cdot 0{,}3\cdot 150^2 = 3375\,\mathrm{J}$.",
    r"A car of 1200 kg runs at 20 m/s. Its kinetic energy is $E = 600\cdot 20^2 = 240000\,\mathrm{J}$.",
    _DECAY + r"\frac{1}{5}\ln 3 = 0.22$.",
    _DECAY.replace("The", "Over these five periods the") + r"\ln 3 = 1.10$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_numbers_put_in_wrongly_are_refuted(page):
    assert "refuted" in verdicts_in(page)


@pytest.mark.parametrize("page", RIGHT)
def test_numbers_put_in_rightly_are_not_accused(page):
    assert not {"refuted", "contradiction"} & {*verdicts_in(page)}
