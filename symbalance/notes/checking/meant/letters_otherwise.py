"""Whether a page says of letters that they are something else than the roles of a formula.

Its words are those right behind a letter, P is the momentum, and the units of its values: F = 300 mm² is
no force.
"""

from __future__ import annotations

from collections.abc import Collection

from symbalance.document.letters import plain_letter
from symbalance.notes.checking.meant.catalogue import ROLES
from symbalance.notes.checking.meant.letter_roles import stem_of
from symbalance.notes.checking.units.dimensions import unit_of
from symbalance.text import lazy_patterns as re

_UNITS = {
    "area": "m^2", "force": "N", "power": "W", "omega": "rad/s", "radius": "m", "static_deflection": "m",
    "mass": "kg", "volume": "m^3", "velocity": "m/s",
}  # fmt: skip
_IS = r"\$?\s+(?:is|ist|be|being|denotes|means|bezeichnet|sei|est|es)\s+(?P<words>[^.,;:$=\n]{3,60})"
_VALUE = (
    r"\s*(?:=|≈|\\approx)\s*[-−]?[0-9][0-9.,]*(?:\{,\}[0-9]+)?(?:\\[,;: ]|[ ~$])*"
    r"(?:\\(?:mathrm|text|unit)\s*\{)?(?P<unit>[A-Za-zµΩ°][A-Za-z0-9µ/²³^·⁻¹]{0,12})"
)


def are_otherwise(page: str, claim: Collection[str], roles: Collection[str]) -> bool:
    """Tell whether a page says of one of a claim's letters what none of the roles it may have is.

    >>> are_otherwise("the torque M = Pω, where P is the momentum", {"P", "omega"}, {"power", "omega"})
    True
    >>> are_otherwise("where P is the power, P = 3 kW", {"P", "omega"}, {"power", "omega"})
    False
    >>> are_otherwise("$F = 300$ mm² and $A = 12$ kN", {"A", "F"}, {"area", "force"})
    True
    """
    return any(_is_otherwise(page, name, roles) for name in claim)


def _is_otherwise(page: str, name: str, roles: Collection[str]) -> bool:
    own = [role for role in roles if stem_of(name) in ROLES[role].letters]
    signs = "|".join(map(re.escape, {name, plain_letter(name), "\\" + name}))
    letter = rf"(?<![A-Za-z\\])(?:{signs})(?![A-Za-z_])"
    for said in re.finditer(letter + _IS, page):
        if not any(ROLES[role].words.search(said["words"]) for role in own):
            return True
    for value in re.finditer(letter + _VALUE, page):
        unit = unit_of(value["unit"])
        if unit is not None and unit not in [unit_of(_UNITS[role]) for role in own if role in _UNITS]:
            return True
    return False
