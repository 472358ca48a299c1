"""Shafts in detail: hollow ones under stress, keys, struts, sliding speeds, diameters, more beams."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import number
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    area,
    bending,
    density,
    diameter,
    first_rate,
    force,
    inner,
    length,
    letters,
    line_load,
    mass,
    omega,
    outer,
    pin,
    radius,
    root,
    rotation,
    second_rate,
    section,
    shearing,
    stress,
    torque,
    words,
    young,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import shear_stress_allowed, third_rate
from symbalance.notes.checking.meant.catalogue.strength import both

_ANNULUS = outer**4 - inner**4
_BORED = words(r"hollow|\bbored\b|tubular|\btubes?\b|hohl|rohr\b|ringquerschnitt|中空|円管|パイプ")
_NO_RING = words(r"rectang|square|thin[- ]walled|dünnwandig|薄肉|rechteck|notch|fillet|kerb|切欠")
_THREE_SOFT = 1 / first_rate + 1 / second_rate + 1 / third_rate
_IN_SERIES = words(
    r"in\s+series", r"series\s+connection", r"reihenschaltung", r"in\s+reihe", r"hintereinander\w*",
    r"one\s+(?:behind|after)\s+the\s+other", r"end\s+to\s+end", r"直列",
)  # fmt: skip
_RATE_WORDS = words(
    r"stiffness", r"spring\s+(?:rate|constant)", r"\brate\b", r"feder(?:konstante|steifigkeit|rate)",
    r"steifigkeit", r"ばね定数",
)  # fmt: skip
_STRUT = PI**2 * young * section / length**2
_BENT = words(r"bending stress|biegespannung|曲げ応力|stress in bending|auf biegung")
_CUBE = Fraction(1, 3)
_FIXED = words(
    r"fixed at both|built[- ]in at both|clamped at both|both ends (?:are )?(?:clamped|fixed|built)"
    r"|beidseitig eingespannt|両端固定"
)
_DEFLECTION = words(r"deflection", r"durchbiegung", r"たわみ量?")

_BY_SHEAR = both(
    words(r"maximum[- ]shear(?:ing)?(?:[- ]stress)?|\btresca|\bguest\b|schubspannungshypothese"
          r"|最大せん断応力説|cisaillement maximal"
          r"|tensión cortante máxima|tensione tangenziale massima|massima tensione tangenziale"),
    words(r"\bbending|biege|biegung|曲げ|fléchissant|flettente|flector"),
)  # fmt: skip
_NO_BY_SHEAR = words(
    r"hollow|hohl|中空|\bbored|von mises|distortion|gestaltänderung|rankine|normalspannung"
    r"|fatigue factor|shock|k_m|k_t|key"
)
PARTS: tuple[Quantity, ...] = (
    Quantity(
        "torsional stress of a hollow shaft", letters("tau"),
        words(r"(?:torsion|twist|shear)\w*\s+stress(?:es)?", r"(?:torsions|schub|verdreh)spannung",
              r"(?:ねじり|せん断|剪断)応力"),
        (16 * torque * outer / (PI * _ANNULUS),), ("factor", "power", "edit"),
        mistakes=(16 * torque * inner / (PI * _ANNULUS), 16 * torque / (PI * (outer**3 - inner**3)),
                  32 * torque * outer / (PI * _ANNULUS), 16 * torque / (PI * _ANNULUS)),
        only=_BORED, unless=words(_NO_RING.pattern,
        r"inner (?:surface|fibre)|at the bore|innenfaser|内面"),
    ),
    Quantity(
        "bending stress of a hollow shaft", letters("sigma"),
        words(r"bending\s+stress(?:es)?", r"flexural\s+stress", r"biegespannung", r"曲げ応力"),
        (32 * bending * outer / (PI * _ANNULUS),), ("factor", "power", "edit"),
        mistakes=(32 * bending * inner / (PI * _ANNULUS), 32 * bending / (PI * (outer**3 - inner**3)),
                  16 * bending * outer / (PI * _ANNULUS), 32 * bending / (PI * _ANNULUS)),
        only=_BORED, unless=words(_NO_RING.pattern,
        r"inner (?:surface|fibre)|at the bore|innenfaser|内面"),
    ),
    Quantity(
        "largest principal stress of bending and torsion", letters("sigma"),
        words(r"(?:largest|greatest|maximum|first|major)\s+(?:principal|normal)\s+stress",
        r"principal\s+stress",
              r"(?:größte\s+)?hauptspannung", r"hauptnormalspannung", r"(?:最大)?主応力"),
        (stress / 2 + root(stress**2 / 4 + shearing**2), stress / 2 + root(stress**2 + 4
        * shearing**2) / 2,
         (stress + root(stress**2 + 4 * shearing**2)) / 2), ("edit",),
        mistakes=(stress / 2 + root(stress**2 + shearing**2), stress + root(stress**2 / 4 + shearing**2),
                  stress / 2 + root(stress**2 + 4 * shearing**2)),
        others=(stress / 2 - root(stress**2 / 4 + shearing**2),
                stress / 2 - root(stress**2 + 4 * shearing**2) / 2,
                (stress - root(stress**2 + 4 * shearing**2)) / 2),
        unless=words(r"smallest|minimum|second|least|kleinste|最小"),
    ),
    Quantity(
        "largest shear stress of bending and torsion", letters("tau"),
        words(r"(?:largest|greatest|maximum|max\.?)\s+(?:shear(?:ing)?\s+)stress",
              r"(?:größte|maximale|haupt)\s*schubspannung", r"最大せん断応力"),
        (root(stress**2 / 4 + shearing**2), root(stress**2 + 4 * shearing**2) / 2,
         root((stress / 2) ** 2 + shearing**2)), ("edit", "root"),
        mistakes=(root(stress**2 + shearing**2), root(stress**2 + 4 * shearing**2),
                  root(stress**2 + 3 * shearing**2) / 2),
        unless=words(r"equivalent|vergleich|相当"),
    ),
    Quantity(
        "section modulus of a round section by which bending is reckoned", letters("W Z S"),
        words(r"section\s+modulus", r"widerstandsmoment", r"断面係数"),
        (PI * diameter**3 / 32, PI * radius**3 / 4), ("factor", "power"), only=_BENT, is_told_once=True,
        unless=words(r"torsion|polar|twist|verdreh|ねじり|極|hollow|hohl|中空|rectang|rechteck|矩形|長方形|\bbored"),
    ),
    Quantity(
        "stiffness of three springs in series", letters("c k C K"),
        words(_RATE_WORDS.pattern, _IN_SERIES.pattern), (1 / _THREE_SOFT,), ("edit",),
        mistakes=(_THREE_SOFT, first_rate + second_rate + third_rate), only=_IN_SERIES,
        unless=words(r"parallel|nebeneinander|並列|complian|nachgiebig|flexibil"),
    ),
    Quantity(
        "stiffness of three springs in parallel", letters("c k C K"),
        words(_RATE_WORDS.pattern, r"parallel\w*", r"nebeneinander", r"side\s+by\s+side", r"並列"),
        (first_rate + second_rate + third_rate,), (), mistakes=(_THREE_SOFT, 1 / _THREE_SOFT),
        only=words(r"parallel|nebeneinander|side\s+by\s+side|並列"),
        unless=words(_IN_SERIES.pattern, r"complian|nachgiebig|flexibil"),
    ),
    Quantity(
        "force at the surface of a shaft", letters("F P Q U S K"),
        words(r"tangential\s+force", r"circumferential\s+force", r"peripheral\s+force",
              r"force\s+(?:at|on)\s+the\s+(?:surface|key|rim)", r"umfangskraft", r"(?:接線|周方向の)力"),
        (2 * torque / diameter, torque / radius), ("bare factor", "power"),
        mistakes=(torque / diameter, torque / (2 * diameter), 2 * torque / radius, torque * diameter / 2,
                  torque * radius),
        only=words(r"\bkey\b|keyway|surface|circumference|\brim\b|passfeder|umfang|pulley|gear|zahnrad|キー|周"),
        unless=words(r"both|each of|two keys|zwei passfedern|gas force|crank angle|kurbelwinkel"),
    ),
    Quantity(
        "buckling load of a strut with pinned ends", letters("F P N"),
        words(r"buckling\s+(?:load|force)", r"critical\s+(?:load|force)",
        r"euler(?:'s)?\s+(?:load|force)",
              r"knick(?:last|kraft)", r"座屈荷重"),
        (_STRUT,), ("power", "factor", "edit"),
        mistakes=(_STRUT / 4, 4 * _STRUT, PI * young * section / length**2, PI**2 * young * section
        / length),
        unless=words(r"clamped|built[- ]in|fixed|free end|eingespannt|固定|freies|自由|effective"
        r"|knicklänge|safety"
                     r"|cantilever|rankine|johnson|tetmajer"),
    ),
    Quantity(
        "sliding speed of a journal", letters("v u V U"),
        words(r"(?:sliding|rubbing|surface)\s+(?:speed|velocity)",
              r"(?:gleit|zapfen)geschwindigkeit", r"すべり速度"),
        (PI * diameter * rotation, PI * diameter * rotation / 60, omega * diameter / 2, omega * radius,
         2 * PI * radius * rotation, PI * radius * rotation / 30), ("power",),
        mistakes=(PI * diameter * rotation / 30, 2 * PI * diameter * rotation / 60,
                  2 * PI * diameter * rotation, omega * diameter, diameter * rotation / 60,
                  PI * diameter**2 * rotation / 60, PI * radius * rotation / 60),
        unless=words(r"rolling|roller|wälz|relative|rod|pleuel|mm\b.{0,40}1000"),
    ),
    Quantity(
        "diameter of a shaft for a torque", letters("d D"),
        words(r"diameters?", r"durchmesser", r"直?径"),
        ((16 * torque / (PI * shear_stress_allowed)) ** _CUBE,), ("factor",),
        mistakes=((32 * torque / (PI * shear_stress_allowed)) ** _CUBE,
                  root(16 * torque / (PI * shear_stress_allowed)),
                  (16 * torque / shear_stress_allowed) ** _CUBE,
                  (16 * torque * shear_stress_allowed / PI) ** _CUBE,
                  (8 * torque / (PI * shear_stress_allowed)) ** _CUBE),
        only=words(r"torque|torsion|twist|drehmoment|verdreh|ねじり|トルク|shear"),
        unless=words(r"hollow|hohl|中空|bored|bending|biegung|曲げ|combined|key"),
    ),
    Quantity(
        "diameter of a shaft for an equivalent torque", letters("d D"),
        words(r"diameters?", r"durchmesser", r"直?径", r"diam[eè]tr[eo]", r"diámetro", r"\bshaft\b"),
        ((16 * torque / (PI * shear_stress_allowed)) ** _CUBE,), ("factor",),
        mistakes=((32 * torque / (PI * shear_stress_allowed)) ** _CUBE,
                  root(16 * torque / (PI * shear_stress_allowed)),
                  (16 * torque / shear_stress_allowed) ** _CUBE,
                  (64 * torque / (PI * shear_stress_allowed)) ** _CUBE,
                  (8 * torque / (PI * shear_stress_allowed)) ** _CUBE),
        only=words(r"equivalent\s+(?:torque|twisting\s+moment)", r"couple\s+(?:équivalent|idéal)",
                   r"moment\s+de\s+torsion\s+(?:équivalent|idéal)",
                   r"moment[oe]\s+torcente\s+(?:equivalente|ideale)",
                   r"(?:momento\s+torsor|par)\s+equivalente",
                   r"(?:gleichwertige|äquivalente)[sn]?\s+(?:dreh|torsions)moment",
                   r"相当ねじりモーメント"),
        unless=words(r"hollow|hohl|中空|bored|creux|cav[oa]|hueco"),
    ),
    Quantity(
        "diameter of a shaft in bending and torsion by the largest shear stress", letters("d D"),
        words(r"diameters?", r"durchmesser", r"直?径", r"diam[eè]tr[eo]", r"diámetro"),
        ((16 * root(bending**2 + torque**2) / (PI * shear_stress_allowed)) ** _CUBE,), ("factor", "edit"),
        mistakes=((32 * root(bending**2 + torque**2) / (PI * shear_stress_allowed)) ** _CUBE,
                  (16 * (bending + torque) / (PI * shear_stress_allowed)) ** _CUBE,
                  (16 * root(bending**2 + 4 * torque**2) / (PI * shear_stress_allowed)) ** _CUBE,
                  root(16 * root(bending**2 + torque**2) / (PI * shear_stress_allowed)),
                  (16 * root(bending**2 - torque**2) / (PI * shear_stress_allowed)) ** _CUBE),
        only=_BY_SHEAR, is_told_once=True, unless=_NO_BY_SHEAR,
    ),
    Quantity(
        "largest shear stress of a shaft in bending and torsion", letters("tau"),
        words(r"(?:allowable|permissible|(?:largest|greatest|maximum)\s+)?(?:shear(?:ing)?\s+)stress",
              r"(?:größte|maximale|zulässige)?\s*schubspannung", r"(?:最大"
                r"|許容)?せん断応力", r"diameters?", r"durchmesser"),
        (16 * root(bending**2 + torque**2) / (PI * diameter**3),), ("factor", "edit", "power"),
        mistakes=(32 * root(bending**2 + torque**2) / (PI * diameter**3),
                  16 * (bending + torque) / (PI * diameter**3)),
        only=_BY_SHEAR, is_told_once=True, unless=_NO_BY_SHEAR,
    ),
    Quantity(
        "largest bending moment of a rod by its own inertia", letters("M"),
        words(r"(?:whipping|bending)\s+moment", r"(?:biege|peitschen)moment", r"曲げモーメント",
              r"moment\s+(?:fléchissant|de\s+flexion|de\s+fouettement)"),
        (density * area * omega**2 * pin * length**2 / (9 * root(number(3))),
         mass * omega**2 * pin * length / (9 * root(number(3)))), ("factor", "power"),
        mistakes=(density * area * omega**2 * pin * length**2 / 8,
                  2 * density * area * omega**2 * pin * length**2 / (9 * root(number(3))),
                  density * area * omega**2 * pin * length / (9 * root(number(3))),
                  density * area * omega * pin * length**2 / (9 * root(number(3)))),
        only=both(words(r"connecting[- ]rod|\brod\b|pleuel|bielle|biela|biella|連接棒|コンロッド"),
                  words(r"\bwhip|linearly|triang|linear\w*\s+(?:von|ansteig|zunehm)|dreieck|三角|linéairement"),
                  words(r"uniform|constant\s+section|gleichförmig|konstant\w*\s+querschnitt|prismatic|一様|uniforme")),
        is_told_once=True, unless=words(r"fixed|clamped|eingespannt|固定|tapered|\bpoint"
                                        r"|at\s+the\s+(?:middle|centre|center)"),
    ),
    Quantity(
        "deflection of a beam fixed at both ends and loaded in the middle", letters("f w y delta v"),
        _DEFLECTION, (force * length**3 / (192 * young * section),), ("factor", "power"), only=_FIXED,
        unless=words(r"uniform|gleichm|streckenlast|等分布|simply|gelenkig|単純|quarter|viertel"),
    ),
    Quantity(
        "deflection of a simply supported beam with a uniform load", letters("f w y delta v"),
        _DEFLECTION, (5 * line_load * length**4 / (384 * young * section),), ("factor", "power"),
        mistakes=(line_load * length**4 / (384 * young * section),),
        only=words(r"(?=.*(?:uniform|gleichm|streckenlast|等分布|distributed|own weight))"
                   r"(?=.*(?:simply[- ]supported|two (?:supports|bearings)|zwei (?:stützen|lagern)"
                   r"|単純支持))"
                   r".*"),
        unless=words(r"clamped|built[- ]in|\bfixed|eingespannt|固定|cantilever|kragarm|片持"),
    ),
    Quantity(
        "slope at the end of a cantilever", letters("theta varphi phi alpha vartheta i"),
        words(r"\bslope", r"inclination", r"neigung(?:swinkel)?", r"tangent", r"たわみ角"),
        (force * length**2 / (2 * young * section),), ("factor", "power"),
        only=words(r"cantilever|kragarm|kragträger|einseitig eingespannt|overhung|built[- ]in|片持"),
        unless=words(r"uniform|gleichm|streckenlast|等分布|both|beid|両端"),
    ),
)  # fmt: skip
