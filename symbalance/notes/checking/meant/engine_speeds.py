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
_RESTATED = re.compile(
    r"(?:[\s$,(:;⇒→~}\]]|[-−]1|<?/?sup>|\^|\{|\\(?:[,;: ]|quad|qquad|Rightarrow|to|implies)"
    r"|(?<![^\W\d_])(?:so|thus|hence|i\.?\s?e\.?|that|is|or|which|this|therefore|means?|giving|gives?|the|an?"
    r"|and(?=\s+(?:the|its)\s+angular)|und(?=\s+die\s+(?:winkel|kreis))|et(?=\s+la\s+(?:pulsation|vitesse\s+ang))"
    r"|corresponding|corresponds|equivalent|to|of|angular|speed|velocity|crank|crankshaft"
    r"|also|d\.?\s?h\.?|das|sind|ist|somit|mithin|entspricht|entsprechend|oder|die|der|einer|einem|eine"
    r"|winkelgeschwindigkeit|kreisfrequenz|donc|soit|c'est-à-dire|une?|vitesse|angulaire|de|rotation|pulsation"
    r"|cioè|quindi|ossia|ovvero|velocità|angolare|vale|una?|es|decir|sea|velocidad|luego|la|le)(?![^\W\d_])"
    r"|回転|すなわち|つまり|よって|したがって|ゆえに|角速度|は|で|、){1,24}",
    re.IGNORECASE,
)
"""Between an engine speed and the angular speed that it is in other words: 3000 rpm, that is ω = 314."""
SAME = 1e-12


def speeds_of(text: str) -> frozenset[int]:
    """Return the numbers of revolutions per minute that a page names.

    >>> sorted(speeds_of(r"6500 1/min, 8000 rpm, $n = 3600\\,\\text{min}^{-1}$, 毎分600回転, 3000/min"))
    [600, 3000, 3600, 6500, 8000]
    """
    speeds = (m["speed"] or m["behind"] for m in _SPEED.finditer(text))
    return frozenset(int(re.sub("[^0-9]", "", digits)) for digits in speeds)


def speed_restated(words: str) -> int | None:
    """Return the revolutions per minute that a text is about to say in radians; None for none.

    >>> speed_restated("It turns at $n = 3000$ rpm, so $"), speed_restated("3000 rpm. At resonance $")
    (3000, None)
    """
    last = [*_SPEED.finditer(words)][-1:]
    between = words[last[0].end() :] if last else ""
    if (
        re.search(r"[^\W\d_]{2}|\(|i\.\s?e|d\.\s?h", between) is None
        or _RESTATED.fullmatch(between) is None
    ):
        return None
    return int(re.sub("[^0-9]", "", last[0]["speed"] or last[0]["behind"]))


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
