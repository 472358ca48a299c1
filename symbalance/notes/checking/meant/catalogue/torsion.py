"""Trains of discs that swing in torsion: three discs, gears by the speeds, a shaft's own mass."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    Quantity,
    first_rate,
    inertia,
    letters,
    mass,
    omega,
    other_inertia,
    own_inertia,
    root,
    second_rate,
    stiffness,
    words,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import amplitude_before, gear_ratio
from symbalance.notes.checking.meant.catalogue.strength import both
from symbalance.notes.checking.meant.catalogue.trains import FREQUENCY_WORDS, GEARED
from symbalance.notes.checking.meant.catalogue.vibration_roles import (
    first_torque,
    middle_inertia,
    other_speed,
    other_teeth,
    outer_inertia,
    own_speed,
    own_teeth,
    second_torque,
    shaft_inertia,
)

_THREE = words(
    r"\bthree[- ](?:\w+\s+)?(?:dis[ck]|rotor|mass|inertia|flywheel)",
    r"\bdrei[- ]?(?:\w+\s+)?(?:scheiben|massen|drehmassen)",
    r"(?:3|三|３)(?:つの|個の|枚の)?(?:円板|慣性|質点)", r"(?:outer|end)\s+dis[ck]s",
)  # fmt: skip
_IN_PHASE = words(
    r"two[- ]nodes?\b(?:\s+mode)?", r"two\s+nodes", r"second\s+(?:mode|natural)", r"in\s+phase",
    r"(?:zwei|2)\s+knoten", r"zweiknotig\w*", r"gleichphasig|in phase", r"(?:2|二|２)節", r"同位相",
)  # fmt: skip
_TWO_ENDS = 2 * outer_inertia + middle_inertia
_ACROSS = outer_inertia * middle_inertia
_OWN_MASS = words(
    r"rayleigh", r"own\s+(?:\w+\s+){0,4}(?:inertia|mass)", r"mass\s+of\s+the\s+(?:spring|shaft)",
    r"inertia\s+of\s+the\s+(?:spring|shaft)", r"(?:feder|wellen)masse", r"eigene\w*\s+(?:trägheit|masse)",
    r"レイリー", r"軸(?:自身)?の慣性", r"ばね(?:自身)?の質量",
)  # fmt: skip
_REDUCED = words(
    r"reduced", r"reduziert\w*", r"referred", r"bezogen\w*", r"equivalent", r"換算",
    r"as\s+seen\s+(?:at|from|by)",
    r"inertia", r"trägheitsmoment", r"drehmasse", r"慣性モーメント",
)  # fmt: skip
_SERIES = tuple(
    first_rate * other / (first_rate + other)
    for other in (gear_ratio**2 * second_rate, second_rate / gear_ratio**2)
)
_NOT_SERIES = (
    first_rate * second_rate / (first_rate + second_rate),
    first_rate * gear_ratio * second_rate / (first_rate + gear_ratio * second_rate),
    first_rate * second_rate / (gear_ratio * first_rate + second_rate),
    first_rate + gear_ratio**2 * second_rate, first_rate + second_rate / gear_ratio**2,
    (gear_ratio**2 * second_rate - first_rate) / (first_rate * gear_ratio**2 * second_rate),
    (gear_ratio**2 * second_rate + first_rate) / (first_rate * gear_ratio**2 * second_rate),
)  # fmt: skip
_STIFFNESS = words(
    r"(?:equivalent\s+|torsional\s+|total\s+)*stiffness", r"equivalent\s+shaft",
    r"(?:(?:feder|dreh|torsions|ersatz|gesamt)+)?steifigkeit", r"ばね定数", r"剛性",
)  # fmt: skip
_FASTER = both(
    words(r"(?:shaft|rotor|welle)\W{0,4}(?:2|two|B|II)\W[^.]{0,30}\btimes\s+(?:as\s+fast|faster)"
          r"|second\s+(?:shaft|one)\s[^.]{0,30}\btimes\s+(?:as\s+fast|faster)"
          r"|welle\W{0,4}2\W[^.]{0,30}mal\s+so\s+schnell|軸\W{0,3}2\W[^。]{0,30}倍"),
    words(r"(?:refer|reduc|as\s+seen|bezogen|reduzier|bezieh)\w*[^.]{0,40}(?:shaft|welle)\W{0,4}(?:1|one|A)\b"
          r"|(?:refer|reduc)\w*[^.]{0,30}first\s+shaft|軸\W{0,3}1\W{0,3}に換算"),
)  # fmt: skip

TORSION: tuple[Quantity, ...] = (
    Quantity(
        "natural angular frequency of the two-node mode of three discs alike at the ends",
        letters("omega Omega w p"), words(FREQUENCY_WORDS.pattern, _IN_PHASE.pattern),
        (root(stiffness * _TWO_ENDS / _ACROSS),), ("root", "turn"),
        mistakes=(
            root(stiffness / outer_inertia), root(2 * stiffness / outer_inertia),
            root(stiffness * (outer_inertia + middle_inertia) / _ACROSS),
            root(stiffness * (outer_inertia + 2 * middle_inertia) / _ACROSS),
            root(stiffness * _TWO_ENDS / (2 * _ACROSS)), root(2 * stiffness * _TWO_ENDS / _ACROSS),
            root(stiffness / outer_inertia * (1 - 2 * outer_inertia / middle_inertia)),
            root(stiffness / _TWO_ENDS),
        ),
        only=both(_THREE, _IN_PHASE),
        unless=words(r"three\s+(?:equal|identical)|drei\s+gleiche|fixed|clamped|eingespannt|固定|damp|gedämpft|減衰|gear|getriebe"),
    ),
    Quantity(
        "natural angular frequency with the inertia of the shaft itself", letters("omega Omega w p"),
        words(FREQUENCY_WORDS.pattern, _OWN_MASS.pattern),
        (root(stiffness / (inertia + shaft_inertia / 3)), root(stiffness / (mass + shaft_inertia / 3))),
        ("root", "turn"),
        mistakes=tuple(
            root(stiffness / (body + part))
            for body in (inertia, mass)
            for part in (shaft_inertia / 2, shaft_inertia, -shaft_inertia / 3, 3 * shaft_inertia,
                         shaft_inertia / 4, 2 * shaft_inertia / 3)
        ),
        only=_OWN_MASS, subscripts=(("shaft_inertia", "s sh w W S f F sp"),),
        unless=words(r"cantilever|kragarm|片持|bending|biege|曲げ|lateral|two\s+dis[ck]s|zwei\s+scheiben"
                     r"|both\s+ends|middle|mitte"),
    ),
    Quantity(
        "moment of inertia reduced over a gear by the speeds", letters("J I Theta"), _REDUCED,
        (own_inertia * (own_speed / other_speed) ** 2, own_inertia * (other_teeth / own_teeth) ** 2,
         other_inertia + own_inertia * (own_speed / other_speed) ** 2,
         other_inertia + own_inertia * (other_teeth / own_teeth) ** 2), ("power",),
        mistakes=(own_inertia * (other_speed / own_speed) ** 2, own_inertia * other_speed / own_speed,
                  own_inertia * own_speed / other_speed, own_inertia * root(other_speed / own_speed),
                  own_inertia * (own_speed / other_speed) ** 2 / 2,
                  own_inertia * (own_teeth / other_teeth) ** 2, own_inertia * other_teeth / own_teeth,
                  other_inertia + own_inertia * (other_speed / own_speed) ** 2,
                  other_inertia + own_inertia * own_speed / other_speed),
        only=GEARED, unless=words(r"three|drei|efficien|wirkungsgrad|belt|riemen"),
        together=(("own_inertia", "own_speed"), ("own_inertia", "own_teeth")),
    ),
    Quantity(
        "stiffness of two shafts over a gear", letters("c k C K"), _STIFFNESS, _SERIES, ("minus",),
        mistakes=_NOT_SERIES, only=GEARED,
        unless=words(r"three|drei|mesh|zahnsteif|parallel", _FASTER.pattern),
    ),
    Quantity(
        "stiffness of a shaft and a faster one over a gear", letters("c k C K"), _STIFFNESS, _SERIES[:1],
        ("minus",), mistakes=(*_NOT_SERIES, _SERIES[1]), only=both(GEARED, _FASTER),
        unless=words(r"three|drei|mesh|zahnsteif|parallel"),
    ),
    Quantity(
        "torque behind a junction of two branches", letters("M T Q"),
        words(r"(?:shaft\s+)?torque", r"(?:dreh|torsions)?moment", r"トルク"),
        (first_torque + second_torque + inertia * omega**2 * amplitude_before,), ("edit", "power"),
        mistakes=(first_torque - second_torque + inertia * omega**2 * amplitude_before,
                  (first_torque + second_torque + inertia * omega**2 * amplitude_before) / 2,
                  first_torque + second_torque + inertia * omega**2,
                  first_torque + second_torque + inertia * amplitude_before),
        only=both(words(r"junction|branch|verzweig|分岐"),
        words(r"holzer|free\s+ends?|freien?\s+enden?|自由端")),
        unless=words(r"gear|getriebe|歯車|opposite\s+sign|entgegengesetzt"),
    ),
)  # fmt: skip
