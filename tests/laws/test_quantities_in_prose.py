"""A value that is a quantity of the sentences before it in another unit has that quantity's size."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

WRONG = [
    (
        r"The cylinder displaces $250\,\mathrm{cm^3}$. "
        r"In cubic metres this is $V = 2.5\cdot 10^{-6}\,\mathrm{m^3}$."
    ),
    (
        r"The pump is driven by 40 hp. "
        r"Its power in SI units is $P = \frac{40}{0.7457}\,\mathrm{kW} = 53.6\,\mathrm{kW}$."
    ),
    r"Die Kurbelwelle dreht mit $3000\,\mathrm{min^{-1}}$. Das sind $n = 500\,\mathrm{s^{-1}}$.",
    r"Der Motor leistet 90 PS. Das sind $P = 90 \cdot 7{,}355\,\mathrm{kW} = 662\,\mathrm{kW}$.",
    (
        r"La batterie contient $2\,\mathrm{kWh}$. "
        r"Cela correspond à $E = 2 \cdot 3{,}6\,\mathrm{kJ} = 7{,}2\,\mathrm{kJ}$."
    ),
    r"La pressione massima è di $55\,\mathrm{bar}$. In unità SI è $p = 55\cdot 10^{4}\,\mathrm{Pa}$.",
    (
        r"La inercia es de $800\,\mathrm{g\,mm^2}$. "
        r"En unidades SI es $J = 8\cdot 10^{-4}\,\mathrm{kg\,m^2}$."
    ),
    (
        r"The shaft turns at $\omega = 157\,\mathrm{rad/s}$. "
        r"This corresponds to $n = \frac{157}{2\pi} = 25\,\mathrm{rpm}$."
    ),
    r"We found $\omega_e = 50\,\mathrm{rad/s}$. The natural frequency is thus $f_e = 314\,\mathrm{Hz}$.",
]
RIGHT = [
    (
        r"The cylinder displaces $250\,\mathrm{cm^3}$. "
        r"In cubic metres this is $V = 2.5\cdot 10^{-4}\,\mathrm{m^3}$."
    ),
    (
        r"The pump is driven by 40 hp. "
        r"Its power in SI units is $P = 40 \cdot 0.7457\,\mathrm{kW} = 29.8\,\mathrm{kW}$."
    ),
    r"Die Kurbelwelle dreht mit $3000\,\mathrm{min^{-1}}$. Das sind $n = 50\,\mathrm{s^{-1}}$.",
    r"Der Motor leistet 90 PS. Das sind $P = 90 \cdot 0{,}7355\,\mathrm{kW} = 66{,}2\,\mathrm{kW}$.",
    (
        r"La batterie contient $2\,\mathrm{kWh}$. "
        r"Cela correspond à $E = 2 \cdot 3{,}6\,\mathrm{MJ} = 7{,}2\,\mathrm{MJ}$."
    ),
    r"La pressione massima è di $55\,\mathrm{bar}$. In unità SI è $p = 55\cdot 10^{5}\,\mathrm{Pa}$.",
    (
        r"La inercia es de $800\,\mathrm{g\,mm^2}$. "
        r"En unidades SI es $J = 8\cdot 10^{-7}\,\mathrm{kg\,m^2}$."
    ),
    (
        r"The shaft turns at $\omega = 157\,\mathrm{rad/s}$. "
        r"This corresponds to $n = \frac{60\cdot 157}{2\pi} = 1500\,\mathrm{rpm}$."
    ),
    r"We found $\omega_e = 50\,\mathrm{rad/s}$. The natural frequency is thus $f_e = 7.96\,\mathrm{Hz}$.",
    r"The engine runs at 3000 rpm. Its natural frequency is $f_1 = 100\,\mathrm{Hz}$.",
    (
        r"The engine displaces $2000\,\mathrm{cm^3}$. "
        r"That is $V = 0.2\,\mathrm{l}$ for each of ten cylinders."
    ),
    r"The displacement is $2000\,\mathrm{cm^3}$. Each cylinder has $V = 200\,\mathrm{cm^3}$.",
    r"The engine gives 40 kW. In a larger one this is $P = 400\,\mathrm{kW}$, another engine.",
    r"One horsepower is $745.7\,\mathrm{W}$. Conversely, one kilowatt is $1/0.7457 = 1.34$ hp.",
    r"Ein PS ist $735{,}5\,\mathrm{W}$. Umgekehrt ist ein Kilowatt $1/0{,}7355 = 1{,}36$ PS.",
]


@pytest.mark.parametrize("page", WRONG)
def test_a_wrong_conversion_is_refuted(tmp_path, page):
    assert "refuted" in verdicts_of(tmp_path, page)


@pytest.mark.parametrize("page", RIGHT)
def test_right_ones_and_other_quantities_are_not(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}
