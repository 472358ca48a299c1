"""Shafts with discs, mounts in numbers, gears, critical speeds of bending, helical springs."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    area,
    central,
    crank,
    diameter,
    first_inertia,
    force,
    gravity,
    inertia,
    letters,
    mass,
    omega,
    reciprocating,
    root,
    rotating,
    second_inertia,
    shear,
    shearing,
    static_deflection,
    stiffness,
    torque,
    words,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import (
    amplitude_before,
    coil,
    first_speed,
    gear_ratio,
    second_speed,
    shear_force,
    third_speed,
    windings,
    wire,
)
from symbalance.notes.checking.meant.catalogue.strength import both
from symbalance.notes.checking.meant.catalogue.vibration import NATURAL_WORDS

_BOTH = first_inertia * second_inertia
_TOGETHER = first_inertia + second_inertia
_FREE = root(stiffness * _TOGETHER / _BOTH)
_NOT_FREE = (root(2 * stiffness * _TOGETHER / _BOTH), *(
    root(node)
    for node in (
        stiffness / _TOGETHER, stiffness * _BOTH / _TOGETHER, stiffness * _TOGETHER, stiffness / _BOTH,
        _TOGETHER / (stiffness * _BOTH), _BOTH / (stiffness * _TOGETHER),
    )
))  # fmt: skip
_TWO_DISCS = words(
    r"\b(?:two|both)\s+(?:\w+\s+){0,2}(?:dis[ck]s|rotors?|inertias|flywheels|wheels|masses)",
    r"two[- ](?:mass|rotor|dis[ck]|inertia)", r"free[- ]free",
    r"\b(?:zwei|beiden?)\s+(?:\w+\s+){0,1}(?:scheiben|drehmassen|massen|schwungmassen|rotoren)",
    r"zweimassen", r"dual[- ]mass", r"\bboth\s+(?:halves|ends|sides)\s+(?:are\s+|being\s+)?free",
    r"\bbeide\s+(?:hälften|enden|seiten)\s+(?:sind\s+)?frei", r"両端自由", r"二慣性系",
    r"\bdeux\s+(?:disques|volants|inerties|masses)", r"\bdue\s+(?:dischi|volani|inerzie|masse)",
    r"\bdos\s+(?:discos|volantes|inercias|masas)",
    r"(?:2|二|２)つの(?:円板|ロータ|慣性)|二円板|2円板|两个?(?:圆盘|转子)|двух(?:массов"
    r"|диск)",
)  # fmt: skip
_HELD = words(
    r"clamped|eingespannt|\bfixed\b|rigid(?![- ]body)|starr(?!körper)|固定|\bthree|\bdrei|\b3 "
    r"|(?<!un)damped|(?<!un)gedämpf"
    r"|減衰|pendul|in phase"
    r"|(?<!neutral )gear(?!box(?:\s+side|\s+end|\s+half)?)|getriebe(?!seit|eingang|ende)"
    r"|spring of the mount|translat|same (?:side|end)"
)
FREQUENCY_WORDS = words(
    NATURAL_WORDS.pattern, r"\bfrequenc(?:y|ies)", r"\bfrequenz", r"振動数", r"固有频率", r"固有角频率",
    r"частот\w+", r"fréquence propre", r"frecuencia natural", r"frequenza propria", r"pulsation propre",
)  # fmt: skip
_NUMBERS = {2: r"two|zwei|2", 3: r"three|drei|3", 4: r"four|vier|4", 6: r"six|sechs|6"}
_MOUNTS = (
    r"(?:mounts?|springs|feet|isolators|rubbers|buffers|legs|elements|federn|lagern?|gummi\w+|füßen?"
    r"|motorlager\w*|マウント|ばね)"
)
_WHIRLING = words(
    r"whirl|biegekritisch|lateral|transverse|static(?:al)? deflection|bending|biege|durchbiegung"
    r"|durchhang"
    r"|\bsag|たわみ|ふれまわ|振れ回|曲げ|deflects"
)
_DUNKERLEY = words(r"dunkerley|ダンカレー|ダンカリー")
CRITICAL_WORDS = words(
    r"critical\s+(?:whirling\s+|angular\s+|shaft\s+)?(?:speeds?|frequency)", r"whirling\s+speed",
    r"(?:biege)?kritischen?\s+(?:winkelgeschwindigkeit|drehzahl|kreisfrequenz|frequenz)",
    r"危険(?:角)?速度",
    r"危険回転数", r"whirls?\b", r"lowest\s+(?:natural\s+)?frequency",
)  # fmt: skip
_PER_MINUTE = 30 / PI
_NO_BENDING = words(r"torsional|drehschwing|ねじり|damp|order|ordnung|次")
_BY_MINUTE = words(
    r"r(?:ev|ounds)?/min|\brpm|per\s+min(?:ute)?\b|by\s+minute|1/min|min\^?\{?-1|min⁻¹|pro\s+minute|je\s+minute|毎分"
)
_BY_SECOND = words(r"r(?:ev)?/s\b|per\s+second|by\s+second|\bhertz\b|\bhz\b|1/s\b|pro\s+sekunde|毎秒")
_NOT_TURNS = (
    2 * _PER_MINUTE * root(stiffness / mass), 60 * root(stiffness / mass), root(stiffness * mass),
    2 * _PER_MINUTE * root(gravity / static_deflection), root(gravity * static_deflection),
    _PER_MINUTE / 30 * root(stiffness / mass), root(gravity / static_deflection) / _PER_MINUTE,
    root(stiffness / mass) / _PER_MINUTE, _PER_MINUTE * root(static_deflection / gravity),
)  # fmt: skip
_CHAIN2 = 1 / first_speed**2 + 1 / second_speed**2
_CHAIN3 = _CHAIN2 + 1 / third_speed**2
_ADDED2 = 1 / first_speed + 1 / second_speed
_ADDED3 = _ADDED2 + 1 / third_speed
_COILED = words(
    r"helical|coil|\bwire|\bturns\b|schraubenfeder|druckfeder|ventilfeder|windung|valve spring|コイル|巻"
)
GEARED = words(r"gear|getriebe|übersetz|歯車|減速|変速|speed ratio|ratio of (?:the )?speeds")


def _on_mounts(number: int) -> tuple[Quantity, ...]:
    """Return what is known of a mass on some equal springs side by side, each of one stiffness."""
    only = words(rf"\b(?:{_NUMBERS[number]})(?:つの|個の|\s+(?:[\w-]+\s+){{0,3}}){_MOUNTS}")
    unless = words(
        r"between|zwischen|total|gesamt|together|series|reihe|combined|sum of|zusammen|合計|(?<!un)damp"
        r"|(?<!un)gedämpf|減衰|pitch|roll"
        r"|nick|yaw"
    )
    every = root(number * stiffness / mass)
    wrong = root(stiffness / (number * mass)), number * root(stiffness / mass)
    return (
        Quantity(
            f"natural angular frequency on {number} equal springs", letters("omega Omega w p"),
            FREQUENCY_WORDS, (every,), ("turn", "root"), mistakes=wrong, others=(root(stiffness / mass),),
            only=only, unless=unless,
        ),
        Quantity(
            f"natural frequency in cycles on {number} equal springs", letters("f nu"),
            FREQUENCY_WORDS, (every / (2 * PI),), ("turn", "root"),
            mistakes=tuple(node / (2 * PI) for node in wrong), others=(root(stiffness / mass) / (2
            * PI),),
            only=only, unless=unless,
        ),
        Quantity(
            f"static deflection on {number} equal springs", letters("delta f y x s w Delta_x"),
            words(r"deflection|\bsag|settle\w*|compression|einfederung|einsenkung|durchsenkung|たわみ|沈下"),
            (mass * gravity / (number * stiffness),), ("bare factor", "part"),
            others=(mass * gravity / stiffness,), only=only, unless=unless,
        ),
    )  # fmt: skip


TRAINS: tuple[Quantity, ...] = (
    Quantity(
        "natural angular frequency of two discs on a shaft", letters("omega Omega w p"), FREQUENCY_WORDS,
        (_FREE,), ("root", "turn", "minus"), mistakes=_NOT_FREE, only=_TWO_DISCS, unless=_HELD,
        is_told_once=True,
        context=words(r"torsion|two[- ](?:mass|dis[ck])|zweimassen|drehschwing|stiffness|steif"
                      r"|ねじり|node|knoten"),
        indices=letters("0 e n 1 2"),
    ),
    Quantity(
        "natural frequency in cycles of two discs on a shaft", letters("f nu n F"), FREQUENCY_WORDS,
        (_FREE / (2 * PI),), ("root", "turn"), mistakes=tuple(node / (2 * PI) for node in _NOT_FREE),
        only=_TWO_DISCS, unless=_HELD,
    ),
    *(quantity for number in _NUMBERS for quantity in _on_mounts(number)),
    Quantity(
        "natural frequency in cycles by the static deflection", letters("f nu"), FREQUENCY_WORDS,
        (root(gravity / static_deflection) / (2 * PI),), ("turn", "root"),
        mistakes=(root(static_deflection / gravity) / (2 * PI),),
        only=words(r"static(?:al)? deflection|deflection under (?:its own|the) weight|\bsags?\b"
        r"|sinks? by|settles?"
                   r"|senkt sich|durch sein (?:eigen)?gewicht|unter seinem (?:eigen)?gewicht|einfederung"
                   r"|statischen?\s+(?:durchbiegung|einsenkung|durchsenkung|einfederung)|静たわみ"),
        unless=words(r"pendul|pendel|振り子|(?<!un)damp|(?<!un)gedämpf|減衰"),
    ),
    Quantity(
        "critical speed of bending of a shaft", letters("omega Omega w"), CRITICAL_WORDS,
        (root(stiffness / mass), root(gravity / static_deflection)), ("root", "turn"),
        mistakes=(_PER_MINUTE * root(gravity / static_deflection), root(gravity * static_deflection),
                  root(stiffness * mass), _PER_MINUTE / 30 * root(stiffness / mass),
                  root(gravity / static_deflection) / _PER_MINUTE, root(stiffness / mass) / _PER_MINUTE),
        only=_WHIRLING, unless=_NO_BENDING,
    ),
    Quantity(
        "critical speed of bending of a shaft in turns", letters("n N f"), CRITICAL_WORDS,
        (_PER_MINUTE * root(stiffness / mass), root(stiffness / mass) / (2 * PI),
         _PER_MINUTE * root(gravity / static_deflection), root(gravity / static_deflection) / (2 * PI)),
        ("root", "turn"), mistakes=_NOT_TURNS, only=_WHIRLING,
        unless=words(_NO_BENDING.pattern, _BY_MINUTE.pattern, _BY_SECOND.pattern),
    ),
    Quantity(
        "critical speed of bending of a shaft in turns per minute", letters("n N f"), CRITICAL_WORDS,
        (_PER_MINUTE * root(stiffness / mass), _PER_MINUTE * root(gravity / static_deflection)),
        ("root", "turn"),
        mistakes=(*_NOT_TURNS, root(stiffness / mass) / (2 * PI),
        root(gravity / static_deflection) / (2 * PI)),
        only=both(_WHIRLING, _BY_MINUTE), unless=words(_NO_BENDING.pattern, _BY_SECOND.pattern),
    ),
    Quantity(
        "critical speed of bending of a shaft in turns per second", letters("n N f"), CRITICAL_WORDS,
        (root(stiffness / mass) / (2 * PI), root(gravity / static_deflection) / (2 * PI)), ("root",
        "turn"),
        mistakes=(*_NOT_TURNS, _PER_MINUTE * root(stiffness / mass),
                  _PER_MINUTE * root(gravity / static_deflection)),
        only=both(_WHIRLING, _BY_SECOND), unless=words(_NO_BENDING.pattern, _BY_MINUTE.pattern),
    ),
    Quantity(
        "critical speed of two discs by Dunkerley", letters("n N omega Omega f"),
        words(CRITICAL_WORDS.pattern, FREQUENCY_WORDS.pattern, _DUNKERLEY.pattern),
        (1 / root(_CHAIN2), first_speed * second_speed / root(first_speed**2 + second_speed**2)),
        ("edit",),
        mistakes=(1 / _ADDED2, root(_CHAIN2), _CHAIN2, _ADDED2, root(first_speed**2 + second_speed**2),
                  1 / root(_ADDED2), first_speed + second_speed),
        only=_DUNKERLEY,
    ),
    Quantity(
        "critical speed of three discs by Dunkerley", letters("n N omega Omega f"),
        words(CRITICAL_WORDS.pattern, FREQUENCY_WORDS.pattern, _DUNKERLEY.pattern),
        (1 / root(_CHAIN3),), ("edit",),
        mistakes=(1 / _ADDED3, root(_CHAIN3), _CHAIN3, _ADDED3,
                  root(first_speed**2 + second_speed**2 + third_speed**2), 1 / root(_ADDED3)),
        only=_DUNKERLEY,
    ),
    Quantity(
        "moment of inertia reduced over a gear", letters("J I Theta"),
        words(r"(?:(?:reduced\s+|mass\s+){0,2}moment\s+of\s+)?inertia", r"(?:massen)?trägheitsmoment",
              r"drehmasse", r"慣性モーメント"),
        (gear_ratio**2 * inertia, inertia / gear_ratio**2), (),
        mistakes=(gear_ratio * inertia, inertia / gear_ratio, root(gear_ratio) * inertia,
                  gear_ratio**4 * inertia),
        only=GEARED, unless=words(r"three|drei|efficien|wirkungsgrad|torque|drehmoment(?!e?n?trägheit)"),
    ),
    Quantity(
        "torsional stiffness reduced over a gear", letters("c k C K"),
        words(r"(?:torsional\s+)?stiffness", r"(?:(?:feder|dreh|torsions)+)?steifigkeit", r"ばね定数",
        r"剛性"),
        (gear_ratio**2 * stiffness, stiffness / gear_ratio**2), (),
        mistakes=(gear_ratio * stiffness, stiffness / gear_ratio, root(gear_ratio) * stiffness,
                  gear_ratio**4 * stiffness),
        only=GEARED, unless=words(r"three|drei|mesh|zahnsteif"),
    ),
    Quantity(
        "next amplitude of a Holzer table",
        letters("theta Theta vartheta alpha a A phi varphi beta"),
        words(r"amplitudes?", r"(?:second|third|fourth|next|following)\s+(?:mass|dis[ck]|station|rotor)",
              r"\bmass\s+(?:two|three|2|3)", r"ausschlag",
              r"(?:zweite|dritte|nächste)\w*\s+(?:masse|scheibe)",
              r"振幅", r"swings? (?:with|by)"),
        (amplitude_before - torque / stiffness, 1 - inertia * omega**2 / stiffness,
         amplitude_before - inertia * omega**2 * amplitude_before / stiffness),
        (), mistakes=(amplitude_before + torque / stiffness, 1 + inertia * omega**2 / stiffness,
                      amplitude_before - torque * stiffness, 1 - inertia * omega / stiffness,
                      1 - stiffness / (inertia * omega**2), 1 - inertia * omega**2 * stiffness,
                      amplitude_before + inertia * omega**2 * amplitude_before / stiffness),
        only=words(r"holzer|ホルツァー|(?:three|multi|two|four)[- ](?:mass|dis[ck]|rotor|node)|(?:drei"
        r"|mehr)massen"), unless=words(r"from the right|backward|von rechts|reverse"),
    ),
    Quantity(
        "stiffness of a helical spring", letters("c k C K R"),
        words(r"spring\s+(?:rate|constant)", r"\brate\b", r"stiffness",
        r"feder(?:rate|konstante|steifigkeit)",
              r"ばね定数"),
        (shear * wire**4 / (8 * windings * coil**3),), ("power", "factor"),
        mistakes=(shear * wire**4 / (8 * windings**2 * coil**3),
        shear * wire**3 / (8 * windings * coil**4)),
        only=_COILED, unless=words(r"parallel|series|reihe|two springs|nested|radius|torsion spring"
        r"|drehfeder"),
    ),
    Quantity(
        "stress in the wire of a helical spring", letters("tau"),
        words(r"(?:shear|torsion)\w*\s+stress", r"\bstress", r"(?:schub|torsions)spannung", r"せん断応力",
              r"ねじり応力"),
        (8 * force * coil / (PI * wire**3),), ("power", "factor"),
        mistakes=(16 * force * coil / (PI * wire**3), 8 * force * coil / (PI * wire**2)),
        only=_COILED, unless=words(r"wahl|curvature factor|correct(?:ed|ion by)|radius|beiwert"),
    ),
    Quantity(
        "mean inertia of a crank with its running gear", letters("J I Theta"),
        words(r"(?:equivalent|mean|average|constant)\s+(?:mean\s+)?(?:moment\s+of\s+)?inertia",
              r"inertia\s+of\s+(?:the\s+|a\s+)?(?:crank|throw|running gear)",
              r"(?:ersatz|mittleres|reduziertes)\s*(?:massen)?trägheitsmoment",
              r"(?:等価|平均)慣性モーメント"),
        (central + rotating * crank**2 + reciprocating * crank**2 / 2,
         central + (rotating + reciprocating / 2) * crank**2,
         rotating * crank**2 + reciprocating * crank**2 / 2), ("edit",),
        mistakes=(central + rotating * crank**2 + reciprocating * crank**2,
                  rotating * crank**2 + reciprocating * crank**2, central + (rotating + reciprocating)
                  * crank**2 / 2, central + rotating * crank**2 / 2 + reciprocating * crank**2),
        unless=words(r"dead cent|totpunkt|at 90|bei 90|quarter|instantaneous|largest|greatest"),
    ),
    Quantity(
        "greatest shear stress of a shear force in a round section", letters("tau"),
        words(r"(?:maximum|greatest|largest|peak|max\.?)\s+(?:shear(?:ing)?\s+)?stress",
              r"(?:maximale|größte)\s+schubspannung", r"最大せん断応力", r"greatest\s+(?:one|value)"),
        (4 * shear_force / (3 * area), 16 * shear_force / (3 * PI * diameter**2), 4 * shearing / 3),
        ("bare factor",), mistakes=(3 * shear_force / (2 * area), 3 * shearing / 2),
        only=words(r"shear(?:ing)? force|transverse force|querkraft|せん断力"),
        unless=words(r"rectang|rechteck|長方形|hollow|hohl|中空|torsion|twist|ねじり"),
    ),
)  # fmt: skip
