"""Angular speeds by the engine speed that a page names: at 8000 rpm, ω = 2π · 8000/60 is right.

The speed may stand in words alone, or be what a letter n of ω = 2πn/60 has. Nobody is accused here: an
angular speed that is 2π times no speed of the page is its definition, as before.
"""

from __future__ import annotations

from math import pi

from symbalance.document.formula import Formula, Name
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.meant.given_numbers import number_in_example
from symbalance.notes.checking.units.own_units import BETWEEN, PER_MINUTE, is_angular_speed
from symbalance.text import lazy_patterns as re

_SPEED = re.compile(
    rf"(?<![0-9.,])(?P<speed>[1-9][0-9]{{0,2}}(?:(?:[,.' ]|\\,|\{{,\}})?[0-9]{{3}})?|[1-9][0-9]{{3,4}})"
    rf"{BETWEEN}(?:{PER_MINUTE}|(?:/|(?:per|pro|je|par)\s)\s?[Mm]in(?:ute)?(?![A-Za-z]))"
    r"|毎分\s*(?P<behind>[1-9][0-9]{1,4})"
)
SAME = 1e-12


def speeds_of(text: str) -> frozenset[int]:
    """Return the numbers of revolutions per minute that a page names.

    >>> sorted(speeds_of(r"6500 1/min, 8000 rpm, $n = 3600\\,\\text{min}^{-1}$, 毎分600回転, 3000/min"))
    [600, 3000, 3600, 6500, 8000]
    """
    speeds = (m["speed"] or m["behind"] for m in _SPEED.finditer(text))
    return frozenset(int(re.sub("[^0-9]", "", digits)) for digits in speeds)


def decide_speed(
    name: str, value: Formula, speeds: frozenset[int], knowledge: Knowledge
) -> Decision | None:
    """Return the proof of an angular speed that is 2π times one of a page's speeds; None for others."""
    if isinstance(value, Name) or not is_angular_speed(name, knowledge.meanings):
        return None
    number = number_in_example(value, knowledge)
    for speed in sorted(speeds):
        if number is not None and abs(float(number) / (pi * speed / 30) - 1) < SAME:
            return Decision(PROVED, f"2π times the {speed} revolutions per minute of the page")
    return None
