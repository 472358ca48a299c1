"""Letters in the formulas of gas cycles and of wheels between two speeds: the adiabat's exponent, ω_1.

They join those of `roles`, in the same form.
"""

from __future__ import annotations

from collections.abc import Mapping

from symbalance.document.formula import Name
from symbalance.notes.checking.meant.catalogue.roles import Role, letters, words

_FIRST = "1 a A i 0 u ein"
_VOLUME = r"volumes?|volumen|容積|体積"
_SPEED = r"(?:angular )?(?:speeds?|velocit(?:y|ies))|winkelgeschwindigkeit(?:en)?|角速度"
_RATE = r"speeds?|rpm|revolutions|drehzahl(?:en)?|回転(?:数|速度)"
_ENTRIES: tuple[tuple[str, ...], ...] = (
    ("adiabatic", "gamma kappa k chi n", r"(?:ratio of (?:the )?specific heats|(?:isentropic|adiabatic"
     r"|polytropic)[ -](?:exponent|index|coefficient)|heat (?:capacity )?ratio"
     r"|(?:isentropen|adiabaten|polytropen)-?exponent|比熱比|(?:断熱|ポリトロープ)指数"
     r"|(?:exposant|coefficient) (?:adiabatique|isentropique|de laplace)"
     r"|(?:rapport|ratio) (?:des|of) chaleurs \w+|ratio (?:tra|fra) i calori|(?:relación|ratio) (?:de|of)"
     r" calores)"),
    ("first_temperature", "T vartheta Theta", r"temperatures?|temperatur|温度|température", _FIRST),
    ("first_pressure", "p P", r"pressures?|druck|圧力?|pression", _FIRST),
    ("second_pressure", "p P", r"pressures?|druck|圧力?|pression", "2 b B e f"),
    ("first_volume", "V v", _VOLUME, _FIRST),
    ("second_volume", "V v", _VOLUME, "2 b B e f"),
    ("first_omega", "omega Omega w", _SPEED, f"{_FIRST} max"),
    ("second_omega", "omega Omega w", _SPEED, "2 b B e f min"),
    ("highest_rate", "n N", _RATE, "max 1 o"),
    ("lowest_rate", "n N", _RATE, "min 2 u"),
    ("gain", "Q V M", r"(?:quality|q)[ -]?factor|gütefaktor|güte|[QＱ]値"),
)  # fmt: skip
CYCLE_ROLES: Mapping[str, Role] = {
    name: Role(letters(usual), words(phrase), *map(letters, indices))
    for name, usual, phrase, *indices in _ENTRIES
}
(
    adiabatic, first_temperature, first_pressure, second_pressure, first_volume, second_volume,
    first_omega, second_omega, highest_rate, lowest_rate, gain,
) = map(Name, CYCLE_ROLES)  # fmt: skip
