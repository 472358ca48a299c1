r"""Springs by what they share, volumes swept and left, Beau de Rochas, horsepower, conversions."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_in, last_verdict, verdicts_in

_SERIES = (
    "Two rubber pads are stacked, so that the same force passes through them. The combined rate is $k = "
)
_NESTED = (
    "Zwei Federn stecken ineinander und haben den gleichen Federweg. Die Gesamtsteifigkeit ist $c = "
)
_PARALLELE = "Deux ressorts montés en parallèle ont la même flèche. La raideur totale est $k = "
_SERIE = "Due molle in serie portano la stessa forza. La rigidezza equivalente è $k = "
_HP = '[symbols]\n"T" = "torque [lb ft]"\n"N" = "engine speed [rpm]"\n"P" = "power [hp]"\n'
_TURNS = '[symbols]\n"N" = "speed [rpm]"\n"\\\\omega" = "angular speed [rad/s]"\n'
_VOLUMES = (
    '[symbols]\n"V_s" = "volume displaced by the piston [m^3]"\n"V_c" = "clearance volume [m^3]"\n'
    '"r" = "compression ratio [-]"\n'
)
_CYCLE = (
    '[symbols]\n"\\\\eta" = "rendement [-]"\n"\\\\varepsilon" = "rapport volumétrique [-]"\n'
    '"\\\\gamma" = "rapport des chaleurs massiques [-]"\n'
)
_DAMPED = (
    '[symbols]\n"\\\\omega_0" = "undamped natural frequency [rad/s]"\n"D" = "damping ratio [-]"\n'
    '"\\\\omega_d" = "damped frequency [rad/s]"\n'
)
_ROCHAS = r"Le moteur suit le cycle de Beau de Rochas. Le rendement thermique vaut $\eta = "
_RING = r"The damped spring swings freely. The damped frequency is $\omega_d = "
_SPEED = '[symbols]\n"S" = "行程 [m]"\n"N" = "回転速度 [rpm]"\n"U" = "平均ピストン速度 [m/s]"\n'
_CV = r"Un cavallo vapore corrisponde a $0{,}7355\,\mathrm{kW}$. Il motore eroga $90\,\mathrm{kW}$. "
_ZETA = r"Il sistema ha l'equazione $m s^2 + c s + k = 0$. Il fattore di smorzamento è $\zeta = "
_LETTERS = (
    '[symbols]\n"m" = "massa [kg]"\n"k" = "rigidezza [N/m]"\n"c" = "smorzamento viscoso [N s/m]"\n'
    '"\\\\zeta" = "fattore di smorzamento [-]"\n'
)
WRONG = [
    ("", _SERIES + "k_1 + k_2$."),
    ("", _SERIES + r"\frac{k_1 + k_2}{k_1 k_2}$."),
    ("", _NESTED + r"\frac{c_1 c_2}{c_1 + c_2}$."),
    ("", _NESTED + r"\sqrt{c_1 c_2}$."),
    ("", _PARALLELE + r"\frac{k_1 k_2}{k_1 + k_2}$."),
    ("", _SERIE + "k_1 + k_2$."),
    (_HP, r"The power is $P = \frac{T N}{9549}$."),
    (_HP, r"The power is $P = \frac{T N}{33000}$."),
    ("", r"With $P$ in horsepower, the torque $T$ in pound-feet and $N$ in rpm, $P = \frac{T N}{9549}$."),
    (_TURNS, r"The conversion is $\omega = 2\pi N$."),
    (_VOLUMES, r"The compression ratio is $r = \frac{V_s}{V_c}$."),
    (_VOLUMES, r"The compression ratio is $r = \frac{V_s + V_c}{V_s}$."),
    (_CYCLE, _ROCHAS + r"1 - \varepsilon^{\gamma - 1}$."),
    (_CYCLE, _ROCHAS + r"\varepsilon^{1 - \gamma}$."),
    (_DAMPED, _RING + r"\omega_0\sqrt{1 + D^2}$."),
    (_DAMPED, _RING + r"\frac{\omega_0}{\sqrt{1 - D^2}}$."),
    (_SPEED, r"平均ピストン速度は $U = \frac{S N}{60}$ である。"),
    (_LETTERS, _ZETA + r"\frac{c}{2 k m}$."),
]
RIGHT = [
    ("", _SERIES + r"\frac{k_1 k_2}{k_1 + k_2}$."),
    ("", _NESTED + "c_1 + c_2$."),
    ("", _PARALLELE + "k_1 + k_2$."),
    ("", _SERIE + r"\frac{k_1 k_2}{k_1 + k_2}$."),
    (
        "",
        "Two springs side by side feel the same force. Their combined rate is $k = k_1 + k_2$.",
    ),
    (_HP, r"The power is $P = \frac{T N}{5252}$."),
    (_HP, r"The power is $P = \frac{2\pi T N}{33000}$."),
    (_HP, r"The torque is $T = \frac{5252\cdot P}{N}$."),
    (_TURNS, r"The conversion is $\omega = \frac{\pi N}{30}$."),
    (_TURNS, r"The angular speed is $\omega = 2\pi N$."),
    (_VOLUMES, r"The compression ratio is $r = \frac{V_s + V_c}{V_c}$."),
    (_CYCLE, _ROCHAS + r"1 - \varepsilon^{1 - \gamma}$."),
    (_DAMPED, _RING + r"\omega_0\sqrt{1 - D^2}$."),
    (_SPEED, r"平均ピストン速度は $U = \frac{S N}{30}$ である。"),
    (_LETTERS, _ZETA + r"\frac{c}{2\sqrt{k m}}$."),
]


@pytest.mark.parametrize(("symbols", "page"), WRONG)
def test_a_slip_is_refuted(tmp_path, symbols, page):
    assert last_verdict(tmp_path, page, symbols) == "refuted"


@pytest.mark.parametrize(("symbols", "page"), RIGHT)
def test_the_right_formula_is_not_accused(tmp_path, symbols, page):
    assert last_verdict(tmp_path, page, symbols) not in ("refuted", "contradiction")


@pytest.mark.parametrize(
    "page",
    [
        _CV + r"La potenza in cavalli è $P = 90\cdot 0{,}7355 = 66{,}2\,\mathrm{CV}$.",
        r"Le moteur développe 90 kW. La puissance en chevaux est $P = 90\cdot 0{,}7355 = 66{,}2$ ch.",
        r"Der Motor leistet 90 kW. Die Leistung in PS ist $P = 90\cdot 0{,}7355 = 66{,}2\,\mathrm{PS}$.",
    ],
)
def test_what_an_engine_delivers_is_its_power(page):
    assert "refuted" in verdicts_in(page)


@pytest.mark.parametrize(
    "page",
    [
        _CV + r"La potenza in cavalli è $P = \frac{90}{0{,}7355} = 122{,}4\,\mathrm{CV}$.",
        r"The engine delivers 90 kW. The power of the pump in horsepower is $P = 88.8\,\mathrm{hp}$.",
        r"Der Motor leistet 90 kW. Die Leistung in PS ist $P = 90\cdot 1{,}36 = 122{,}4\,\mathrm{PS}$.",
    ],
)
def test_a_power_converted_rightly_or_of_another_thing_is_not_accused(page):
    assert last_in(page) not in ("refuted", "contradiction")
