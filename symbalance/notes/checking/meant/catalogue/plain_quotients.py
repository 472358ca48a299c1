"""Quantities that are one letter over another, by the words that name them: the stress is F/A, no A/F."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    area,
    force,
    letters,
    mass,
    omega,
    power,
    radius,
    static_deflection,
    velocity,
    volume,
    words,
)

_OTHERWISE = (
    r"reciprocal|inverse|specific|compliance|flexibility|kehrwert|reziprok|spezifisch|nachgiebigkeit|逆数"
    r"|proportional|\bper\b|flow|current|strom"
)
_UNLESS = words(_OTHERWISE)

PLAIN_QUOTIENTS: tuple[Quantity, ...] = (
    Quantity(
        "stress of a force on an area", letters("sigma tau"),
        words(r"(?:tensile\s+|compressive\s+|normal\s+|axial\s+|shear\s+)?stress\b",
              r"(?:zug|druck|normal|schub|scher)?-?spannung\b", r"応力"),
        (force / area,), slips=(), mistakes=(area / force,), unless=_UNLESS, is_plain=True,
    ),
    Quantity(
        "pressure of a force on an area", letters("p"),
        words(r"pressure\b", r"(?:flächen)?pressung", r"druck\b", r"圧力"),
        (force / area,), slips=(), mistakes=(area / force,), unless=_UNLESS, is_plain=True,
    ),
    Quantity(
        "torque of a power", letters("M T"),
        words(r"torque\b", r"drehmoment\b", r"トルク"),
        (power / omega, force * radius), slips=(),
        mistakes=(power * omega, omega / power, force / radius, radius / force),
        unless=words(_OTHERWISE, r"lever|\barm\b|hebelarm|width|breite"), is_plain=True,
    ),
    Quantity(
        "stiffness by a force and its deflection", letters("c k C K"),
        words(r"\bstiffness", r"spring\s+(?:rate|constant)", r"feder(?:steifigkeit|konstante|rate)",
              r"steifigkeit\b", r"ばね定数"),
        (force / static_deflection,), slips=(), mistakes=(static_deflection / force,), unless=_UNLESS,
        is_plain=True,
    ),
    Quantity(
        "density", letters("rho varrho"),
        words(r"\bdensity", r"dichte\b", r"密度"),
        (mass / volume,), slips=(), mistakes=(volume / mass,), unless=_UNLESS, is_plain=True,
    ),
    Quantity(
        "duration of a turn or an oscillation", letters("T"),
        words(r"\bperiod(?:\s+of)?\b", r"(?:perioden|schwingungs|umlauf)dauer", r"周期"),
        (2 * PI / omega,), slips=(), mistakes=(omega / (2 * PI),), unless=_UNLESS, is_plain=True,
    ),
    Quantity(
        "angular speed of a point on a circle", letters("omega Omega"),
        words(r"angular\s+(?:speed|velocity)", r"winkelgeschwindigkeit", r"角速度"),
        (velocity / radius,), slips=(), mistakes=(radius / velocity,), unless=_UNLESS,
        is_plain=True,
    ),
)  # fmt: skip
