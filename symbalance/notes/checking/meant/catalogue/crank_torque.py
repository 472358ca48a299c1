"""The torque of a crank drive: its cycle, mass forces, energy and flywheel, and what the pins bear."""

from __future__ import annotations

from symbalance.document.formula import Call, Formula
from symbalance.notes.checking.meant.catalogue.crank_drive import (
    COS_CRANK,
    COS_ROD,
    DOUBLE,
    SIN_CRANK,
)
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    arm_of_weight,
    balance_mass,
    central,
    centrifugal,
    crank_angle,
    crank_mass,
    cycle_work,
    cylinders,
    diameter,
    effective_power,
    effective_pressure,
    efficiency,
    excess,
    far,
    fluctuation,
    gyration,
    indicated_power,
    indicated_pressure,
    inertia,
    letters,
    lost_power,
    lost_pressure,
    mass,
    near,
    omega,
    omega_high,
    omega_low,
    pin,
    piston_mass,
    pressure,
    radial_part,
    radius,
    ratio,
    rod,
    rod_acceleration,
    rod_mass,
    root,
    rotation,
    shift,
    tangential,
    to_big,
    to_small,
    torque,
    velocity,
    volume,
    words,
)
from symbalance.notes.checking.meant.catalogue.work import FOUR, TWO

_OFFSET = r"offset|desax|geschränkt|オフセット"
_ENGINE = words(
    r"crank|piston|\brod\b|cylinder|engine|gas force|kurbel|kolben|pleuel|stange|gaskraft|motor"
    r"|ピストン|クランク|連接棒|連桿|コンロッド|機関|エンジン|manivelle|bielle|manivela|biela"
)
_BELOW = root(1 - ratio**2 * SIN_CRANK**2)
_STROKE = mass * pin**2 * omega**2
_PULL = mass * pin * omega**2
_TRIPLE, _FOURFOLD = Call("sin", 3 * crank_angle), Call("sin", 4 * crank_angle)


def _waves(count: int) -> Formula:
    """Return the inertia torque over m r² ω², its first terms."""
    terms = (
        ratio * SIN_CRANK / 4, -DOUBLE / 2, -3 * ratio * _TRIPLE / 4, -(ratio**2) * _FOURFOLD / 4,
    )  # fmt: skip
    total: Formula = terms[0]
    for term in terms[1:count]:
        total = total + term
    return total


_INERTIA_TORQUE = (
    _STROKE * _waves(4), _STROKE * _waves(3), -_STROKE * DOUBLE / 2,
    -_STROKE * (COS_CRANK + ratio * Call("cos", 2 * crank_angle)) * (SIN_CRANK + ratio * DOUBLE / 2),
)  # fmt: skip


def _wrong_shares(own: Formula, other: Formula) -> tuple[Formula, ...]:
    """Return what is mistaken for the part of a rod's mass that goes with one of two distances."""
    return (
        mass * rod / own, mass * own**2 / rod**2, mass * (rod - other) / other,
        mass * rod / (rod - other),
        mass * (rod - other) ** 2 / rod**2, mass * other / (rod - other), mass * own / (rod - own),
    )  # fmt: skip


_ROD_PART = r"(?:connecting[- ])?rod|pleuel|連接棒|コンロッド"
_AT_SMALL = (
    r"(?:mass|part|share|portion)\s+(?:[^.;,$=]{0,24}\s)?(?:at|in|on|to)\s+the\s+(?:small[- ]end"
    r"|piston(?:[- ]pin)?|gudgeon[- ]pin"
    r"|wrist[- ]pin)"
    r"|(?:massen?|anteil)\s+(?:am|im)\s+(?:kleinen\s+\w*(?:auge|kopf)|kolben(?:bolzen)?)"
)
_AT_BIG = (
    r"(?:mass|part|share|portion)\s+(?:[^.;,$=]{0,24}\s)?(?:at|in|on|to)\s+the\s+(?:(?:big"
    r"|large)[- ]end|crank[- ]?pin)"
    r"|(?:massen?|anteil)\s+(?:am|im)\s+(?:großen\s+\w*(?:auge|kopf)|(?:kurbel|hub)zapfen)"
)
"""Words for what of a rod's mass is put at one of its ends."""
_SHARES = r"share|part|portion|mass|anteil|masse|質量|分"

CRANK_TORQUE: tuple[Quantity, ...] = (
    Quantity(
        "load on the crank pin", letters("Q F R S Z B P K"),
        words(r"(?:resultant\s+)?(?:load|force|pressure)\s+(?:on|at)\s+the\s+crank[- ]?pin",
              r"(?:resultant|total|bearing|pin|crank[- ]?pin)\s+(?:load|force)",
              r"(?:hub|kurbel)?zapfen(?:kraft|belastung|last)", r"クランクピン(?:に働く)?(?:力|荷重)"),
        (root(tangential**2 + (radial_part - centrifugal) ** 2), root(tangential**2 + radial_part**2),
         root(tangential**2 + (centrifugal - radial_part) ** 2),
         root(tangential**2 + (radial_part - _PULL) ** 2),
         root(tangential**2 + (_PULL - radial_part) ** 2)),
        ("edit", "root", "part"),
        mistakes=(root(tangential**2 + (radial_part + centrifugal) ** 2),
                  root(radial_part**2 + (tangential - centrifugal) ** 2),
                  root(tangential**2 + (radial_part + _PULL) ** 2),
                  root(radial_part**2 + (tangential - _PULL) ** 2), tangential + radial_part - _PULL),
        only=words(r"inwards?|(?:towards?|to) the (?:shaft|cent(?:re|er)|axis|crank ?shaft)"
                   r"|zur? (?:wellen|kurbel)?(?:mitte|achse)|zum (?:wellen)?mittelpunkt|中心(?:に|へ)向"),
        unless=words(r"outwards? (?:is )?positive|positive outwards?|nach außen positiv"),
    ),
    Quantity(
        "mechanical efficiency", letters("eta"),
        words(r"mechanical\s+efficiency", r"mechanische[rn]?\s+wirkungsgrad", r"機械効率"),
        (effective_pressure / indicated_pressure, effective_power / indicated_power,
         1 - lost_pressure / indicated_pressure, 1 - lost_power / indicated_power,
         effective_power / (effective_power + lost_power),
         (indicated_power - lost_power) / indicated_power),
        ("edit", "power", "minus"),
        mistakes=(indicated_pressure / effective_pressure, indicated_power / effective_power,
                  lost_power / indicated_power, lost_pressure / indicated_pressure,
                  effective_power / lost_power, lost_power / effective_power,
                  lost_pressure / effective_pressure),
        unless=words(r"share|fraction|minus|verlustgrad|anteil|\bpart\b|taux|quota|割合"),
    ),
    Quantity(
        "effective pressure by the losses", letters("p P"),
        words(r"(?:brake|effective)\s+mean\s+(?:effective\s+)?pressure",
            r"(?:mean\s+)?effective\s+pressure",
              r"effektive[rn]?\s+mitteldruck", r"正味平均有効圧力?", r"\bbmep\b"),
        (indicated_pressure * efficiency, indicated_pressure - lost_pressure), ("power", "minus"),
        mistakes=(indicated_pressure / efficiency, indicated_pressure + lost_pressure),
    ),
    Quantity(
        "friction mean effective pressure", letters("p P"),
        words(r"friction\s+(?:mean\s+)?(?:effective\s+)?pressure", r"reib(?:ungs)?mitteldruck",
              r"摩擦平均有効圧力?", r"\bfmep\b"),
        (indicated_pressure - effective_pressure, indicated_pressure * (1 - efficiency)), ("minus",
            "edit"),
        mistakes=(effective_pressure - indicated_pressure,),
    ),
    Quantity(
        "work of a cycle of a four-stroke engine", letters("W A E"),
        words(r"work(?:\s+done)?\s+(?:of|in|per|during)\s+(?:(?:one|a|each|the)\s+)?cycle",
              r"arbeit\s+(?:je|pro|eines)\s+(?:arbeitsspiels?|zyklus)",
              r"arbeit\s+(?:in\s+)?einem\s+arbeitsspiel",
              r"1サイクル(?:あたり|当たり)?の仕事"),
        (4 * PI * torque, pressure * volume), ("turn", "factor", "part"),
        mistakes=(2 * PI * torque, PI * torque, 720 * torque, 360 * torque),
        only=FOUR, unless=TWO, is_told_once=True,
    ),
    Quantity(
        "inertia torque of one cylinder", letters("M T Q"),
        words(r"(?:inertia|mass)\s+torque", r"torque\s+(?:of|from|by|due\s+to)\s+the\s+(?:inertia"
            r"|mass)\s*forces?",
              r"torque\s+(?:that|which)\s+the\s+(?:inertia|mass)\s+forces?\s+exerts?",
              r"massen(?:dreh)?moment",
              r"慣性(?:力による|力の)?トルク",
              r"(?:turning\s+)?moment", r"torque", r"(?:dreh)?moment", r"couple", r"トルク"),
        (), ("edit", "factor", "power"), approximate=_INERTIA_TORQUE,
        unless=words(_OFFSET, r"cylinders\b|all (?:four|three|six)|zylindern\b|aller zylinder"
            r"|気筒(?:全体|分)|whole engine"
                     r"|\bbanks?\b|V-?(?:engine|motor|twin|\d)|sum of|verdoppel|doubl|b[oó]xer|twin"),
        turns=True, only=_ENGINE, is_told_once=True, is_of_one=True,
    ),
    Quantity(
        "distance of the piston pin from the crank's axis", letters("h y x H s a b"),
        words(r"(?:distance|height)\s+(?:of|from)\s+(?:the\s+)?(?:piston|gudgeon"
            r"|wrist)[- ]?pin\s+(?:from|above|to)\s+"
              r"(?:the\s+)?(?:crank\s?)?(?:shaft|centre|center|axis)(?:'s\s+axis|\s+(?:axis|centre"
              r"|center))?",
              r"(?:piston|gudgeon|wrist)[- ]?pin,?\s+(?:at|above|height)",
              r"abstand\s+(?:des\s+kolbenbolzens|vom\s+kolbenbolzen)\s+(?:von|zu)\s*(?:der"
              r"|m)?\s*(?:wellen|kurbel)\w*",
              r"ピストンピンとクランク(?:軸)?(?:中心)?の距離"),
        (pin * COS_CRANK + rod * COS_ROD, pin * COS_CRANK + rod * _BELOW),
        ("edit", "part"), unless=words(_OFFSET), turns=True, only=_ENGINE, is_told_once=True,
    ),
    Quantity(
        "distance of the piston from its top dead centre at a right angle of the crank",
        letters("x s y z h S"),
        words(r"distance\s+from\s+(?:TDC|(?:the\s+)?top\s+dead\s+cent(?:re|er))",
              r"(?:piston\s+)?displacement(?:\s+of\s+the\s+piston)?(?:\s+from\s+(?:TDC|(?:the\s+)?top\s+dead\s+cent(?:re|er)))?",
              r"kolbenweg", r"abstand\s+(?:vom?|zum)\s+(?:OT|oberen\s+totpunkt)",
              r"上死点から(?:の)?(?:ピストン(?:の)?)?(?:距離|変位)", r"ピストン変位"),
        (pin + rod - root(rod**2 - pin**2), pin * (1 + (1 - root(1 - ratio**2)) / ratio)),
        ("any", "edit", "part"), mistakes=(rod - root(rod**2 - pin**2),),
        approximate=(pin * (1 + ratio / 2), pin + pin**2 / (2 * rod)),
        only=words(r"(?<![0-9.,])90\s?(?:°|\^|degrees?|grad)|right\s+angle\s+(?:to|with|between)"
                   r"|quarter\s+(?:of\s+a\s+)?(?:turn|revolution)|viertel(?:drehung|umdrehung)"
                   r"|(?<![0-9.,])90\s?度|直角"),
        unless=words(_OFFSET, r"\bV\b|V-?(?:twin|engine|motor)|270|\bafter\s+BDC|bottom"),
    ),
    Quantity(
        "moment of inertia of the two masses that replace a rod", letters("J I Theta"),
        words(r"(?:two[- ]mass(?:\s+(?:model|system|substitute|equivalent))?"
        r"|(?:the\s+)?two\s+masses)[^.;=]{0,20}?"
              r"\s(?:has|have|with)\s+(?:the|a)\s+moment\s+of\s+inertia",
              r"moment\s+of\s+inertia\s+of\s+the\s+(?:two\s+(?:point\s+)?masses|two[- ]mass\s+\w+)",
              r"zweimassen\w*[^.;=]{0,20}?\s(?:hat|mit)[^.;=]{0,20}?trägheitsmoment",
              r"trägheitsmoment\s+(?:de[rs]\s+)?(?:beiden\s+(?:ersatz|punkt)?massen|zweimassen\w*)",
              r"[二2]質点(?:系|モデル)?の慣性モーメント"),
        (mass * near * far, mass * to_big * to_small), ("any", "edit", "power", "bare factor", "part"),
        only=words(_ROD_PART, r"\brod\b|stange|bielle|biella|biela"),
        unless=words(r"about\s+the\s+(?:big|small|crank|piston)|um\s+den\s+(?:kurbel|kolben)"),
    ),
    Quantity(
        "mass of a rod at its small end", letters("m M W W1 W2 m1 m2 G"),
        words(rf"(?:reciprocating|oscillating|small[- ]end|upper)\s+(?:{_SHARES})(?:\s+of\s+(?:the"
            rf"|its)\s+"
              r"(?:connecting[- ])?rod)?", r"(?:share|portion"
              r"|part)\s+(?:counted\s+as\s+)?(?:reciprocating|oscillating)",
              r"oszillierende[rsn]?\s+(?:pleuel)?(?:stangen)?(?:massen)?(?:anteil|masse"
              r"|teil)(?:\s+(?:des|der)\s+\w+)?",
              r"(?:往復(?:質量|部分)?|小端)[^、。]{0,12}(?:質量|分)", _AT_SMALL,
              r"masse\s+(?:\w+\s+)?(?:im|am)\s+(?:kolbenbolzen|kleinen\s+\w*(?:auge|kopf))"),
        (mass * to_big / rod, mass * (rod - to_small) / rod, mass * to_big / (to_big + to_small)),
        ("any", "edit", "power", "part"),
        mistakes=(mass * to_small / rod, mass * (rod - to_big) / rod,
                  mass * to_small / (to_big + to_small),
                  mass * to_big / to_small, mass * to_small / to_big,
                  *_wrong_shares(to_big, to_small)),
        context=words(_ROD_PART),
            indices=letters("small osc osz rec recip o hin kl klein se S Kolben pist"),
    ),
    Quantity(
        "mass of a rod at its big end", letters("m M W W1 W2 m1 m2 G"),
        words(rf"(?:rotating|revolving|big[- ]end|lower)\s+(?:{_SHARES})(?:\s+of\s+(?:the|its)\s+"
              r"(?:connecting[- ])?rod)?", r"(?:share|portion|part)\s+(?:counted\s+as\s+)?(?:rotating"
              r"|revolving)",
              r"rotierende[rsn]?\s+(?:pleuel)?(?:stangen)?(?:massen)?(?:anteil|masse|teil)(?:\s+(?:des"
              r"|der)\s+\w+)?",
              r"(?:回転(?:質量|部分)?|大端)[^、。]{0,12}(?:質量|分)", _AT_BIG,
              r"masse\s+(?:\w+\s+)?(?:im|am)\s+(?:(?:kurbel|hub)zapfen|großen\s+\w*(?:auge|kopf))"),
        (mass * to_small / rod, mass * (rod - to_big) / rod, mass * to_small / (to_big + to_small)),
        ("any", "edit", "power", "part"),
        mistakes=(mass * to_big / rod, mass * (rod - to_small) / rod,
                  mass * to_big / (to_big + to_small),
                  mass * to_big / to_small, mass * to_small / to_big,
                  *_wrong_shares(to_small, to_big)),
        context=words(_ROD_PART), indices=letters("big rot r gr gross groß be crank Kurbel"),
    ),
    Quantity(
        "reciprocating mass with a third of the rod", letters("m M"),
        words(r"(?:reciprocating|oscillating)\s+mass", r"oszillierende\s+masse",
            r"hin-\s*und\s+hergehende\s+masse",
              r"往復(?:部分の)?質量"),
        (piston_mass + rod_mass / 3,), ("edit", "part"), mistakes=(piston_mass + 2 * rod_mass / 3,),
    ),
    Quantity(
        "reciprocating mass of a piston and the share of its rod", letters("m M"),
        words(r"(?:reciprocating|oscillating)\s+mass", r"oszillierende[n]?\s+masse",
              r"hin-\s*und\s+hergehende[n]?\s+masse", r"往復(?:部分の)?質量"),
        (piston_mass + rod_mass * to_big / rod, piston_mass + rod_mass * (1 - to_small / rod)),
        ("any", "edit", "part"),
        mistakes=(piston_mass + rod_mass * to_small / rod, piston_mass + rod_mass * (1 - to_big / rod)),
    ),
    Quantity(
        "rotating mass of a crank and the share of its rod", letters("m M"),
        words(r"(?:rotating|revolving)\s+mass", r"rotierende[n]?\s+masse", r"umlaufende[n]?\s+masse",
              r"回転(?:部分の)?質量"),
        (crank_mass + rod_mass * to_small / rod, crank_mass + rod_mass * (1 - to_big / rod)),
        ("any", "edit", "part"),
        mistakes=(crank_mass + rod_mass * to_big / rod, crank_mass + rod_mass * (1 - to_small / rod)),
    ),
    Quantity(
        "rotating mass with two thirds of the rod", letters("m M"),
        words(r"(?:rotating|revolving)\s+mass", r"rotierende(?:n)?(?:\s+masse)?", r"回転(?:部分の)?質量"),
        (crank_mass + 2 * rod_mass / 3,), ("part",), mistakes=(crank_mass + rod_mass / 3,),
    ),
    Quantity(
        "couple that corrects a rod of two masses", letters("T M C K"),
        words(r"correct(?:ion|ing|ive)\s+(?:couple|torque|moment)", r"korrektur(?:moment|drehmoment)",
              r"zusatz(?:dreh)?moment", r"補正(?:偶力|モーメント|トルク)"),
        (
            *(
                mass * part * rod_acceleration
                for part in (gyration**2 - near * far, near * far - gyration**2,
                             gyration**2 - to_big * to_small, to_big * to_small - gyration**2)
            ),
            (central - mass * near * far) * rod_acceleration,
            (mass * near * far - central) * rod_acceleration,
        ),
        ("edit", "minus", "part"),
    ),
    Quantity(
        "correction of the moment of inertia of a rod of two masses",
        letters("Delta_J J I Delta_I Theta"),
        words(r"correct(?:ion|ing)\s+(?:inertia|term)(?:\s+of\s+inertia)?",
              r"(?:difference|error|defect)\s+(?:of|in)\s+(?:the\s+)?moments?\s+of\s+inertia",
              r"korrekturträgheitsmoment", r"zusatzträgheitsmoment", r"(?:慣性モーメントの)?補正(?:量"
              r"|項)"),
        (mass * (gyration**2 - to_big * to_small), mass * (to_big * to_small - gyration**2),
         central - mass * to_big * to_small, mass * to_big * to_small - central),
        ("edit", "minus", "part"),
    ),
    Quantity(
        "excess of inertia of a rod of two masses", letters("Delta_J J I Delta_I Theta"),
        words(r"moments?\s+of\s+inertia[^.;=]{0,50}?\s(?:too\s+(?:large|great|big|high)"
              r"|trop\s+grande?|troppo\s+grande|demasiado\s+grande)\s+(?:by|of|de|di|en)?",
              r"(?:massen)?trägheitsmoment[^.;=]{0,50}?\szu\s+groß",
              r"excess\s+(?:of\s+)?(?:moment\s+of\s+)?inertia",
              r"慣性モーメント[^。]{0,20}(?:過大|大きすぎ|大きく見積)"),
        (mass * (near * far - gyration**2), mass * (to_big * to_small - gyration**2),
         mass * near * far - central, mass * to_big * to_small - central),
        ("edit", "factor"),
        mistakes=(mass * (gyration**2 - near * far), mass * (gyration**2 - to_big * to_small),
                  central - mass * near * far, central - mass * to_big * to_small,
                  mass * (near**2 + far**2 - gyration**2), mass * (near + far - gyration)),
        only=words(_ROD_PART, r"bielle|biella|biela"), is_told_once=True,
    ),
    Quantity(
        "rotating mass of a throw and its rod", letters("m M"),
        words(r"(?:rotating|revolving)\s+mass", r"rotierende(?:n)?\s+masse", r"umlaufende(?:n)?\s+masse",
              r"回転(?:部分の)?質量"),
        (balance_mass * arm_of_weight / pin + mass * (1 - to_big / rod),
         balance_mass * arm_of_weight / pin + mass * to_small / rod),
        ("edit", "part"),
        mistakes=(balance_mass * pin / arm_of_weight + mass * (1 - to_big / rod),
                  balance_mass * arm_of_weight / pin + mass * to_big / rod,
                  balance_mass * arm_of_weight**2 / pin**2 + mass * (1 - to_big / rod),
                  balance_mass * arm_of_weight + mass * (1 - to_big / rod)),
        together=(("balance_mass", "arm_of_weight"), ("mass", "rod")),
    ),
    Quantity(
        "kinetic energy of a crank and its piston", letters("E T K W U"),
        words(r"(?:total\s+)?kinetic\s+energy", r"(?:gesamte\s+)?(?:kinetische|bewegungs)-?\s*energie",
              r"運動エネルギー?"),
        (inertia * omega**2 / 2 + mass * velocity**2 / 2, (inertia * omega**2 + mass * velocity**2) / 2),
        ("edit", "part"), unless=words(r"rolling|rollen|change|änderung"),
    ),
    Quantity(
        "energy between two speeds of a flywheel", letters("E W Delta_E Delta_W A"),
        words(r"energy\s+(?:released|given\s+up|stored|delivered|taken\s+up)",
            r"fluctuation\s+of\s+(?:kinetic\s+)?energy",
              r"(?:surplus|excess)\s+(?:work|energy)", r"change\s+of\s+(?:the\s+)?kinetic\s+energy",
              r"überschussarbeit", r"arbeitsüberschuss", r"energieschwankung", r"abgegebene\s+energie",
              r"余剰(?:仕事|エネルギー?)", r"エネルギー?(?:の)?変動(?:量)?"),
        (inertia * (omega_high**2 - omega_low**2) / 2,), ("edit", "factor", "minus"),
        mistakes=(inertia * (omega_high - omega_low) ** 2 / 2,),
        others=(inertia * (omega_low**2 - omega_high**2) / 2,),
    ),
    Quantity(
        "moment of inertia with the piston's mean share", letters("J I Theta bar_J bar_I"),
        words(r"(?:mean|average)(?:\s+reduced|\s+equivalent)?\s+(?:moment\s+of\s+)?inertia",
              r"mittlere[sn]?\s+(?:reduzierte[sn]?\s+)?(?:massen)?trägheitsmoment"),
        (inertia + mass * pin**2 / 2,), ("factor", "edit", "part"), mistakes=(inertia + mass * pin**2,),
    ),
    Quantity(
        "moment of inertia of the drive reduced to the crank", letters("J I Theta"),
        words(r"reduced\s+(?:moment\s+of\s+)?inertia", r"(?:variable|equivalent)\s+moment\s+of\s+inertia",
              r"reduzierte[sn]?\s+(?:massen)?trägheitsmoment", r"(?:等価|換算)慣性モーメント"),
        tuple(
            rest + mass * pin**2 * shape**2 if rest is not None else mass * pin**2 * shape**2
            for rest in (inertia, None)
            for shape in (SIN_CRANK, SIN_CRANK + ratio * DOUBLE / 2)
        ),
        ("edit", "part"), unless=words(_OFFSET, r"mean|average|mittlere|\bgears?\b|getriebe|歯車"),
        turns=True,
    ),
    Quantity(
        "moment of inertia about the centre of gravity", letters("J I Theta"), words(r"(?!)"),
        (inertia - mass * shift**2, central - mass * shift**2), ("edit", "part"),
        mistakes=(inertia + mass * shift**2, central + mass * shift**2, inertia - mass * shift),
        context=words(r"(?:about|through)\s+(?:the|its)\s+(?:cent(?:re|er)\s+of\s+(?:gravity|mass)"
            r"|centroid|c\.?g)",
                      r"um\s+(?:den|ihren|seinen)\s+schwerpunkt", r"重心(?:まわり|回り|周り)"),
        indices=letters("G S g s cg CG C SP"), unless=words(r"transfer|parallel axis to the|umgekehrt"),
    ),
    Quantity(
        "largest speed of rotation", letters("omega Omega n N"),
        words(r"(?:largest|greatest|highest|maximum|max\.)\s+(?:angular\s+)?(?:speed"
            r"|velocity)(?:\s+of\s+rotation)?",
              r"(?:größte|höchste|maximale)\s+(?:winkelgeschwindigkeit|drehzahl)", r"最(?:大"
              r"|高)(?:角速度|回転(?:速度|数))"),
        (omega * (1 + fluctuation / 2), rotation * (1 + fluctuation / 2)), ("edit", "part"),
        mistakes=(omega * (1 + fluctuation), rotation * (1 + fluctuation)),
        only=words(r"irregularity|fluctuation|ungleichförm|変動率|fly-?wheel|schwung"),
        unless=words(r"±|\\pm\b|plus or minus|amplitude|ausschlag|振幅|half|halb|piston|kolben"),
        context=words(r"irregularity|fluctuation|ungleichförm|変動率|irregolarit|irrégularité"),
        indices=letters("max"),
    ),
    Quantity(
        "smallest speed of rotation", letters("omega Omega n N"),
        words(r"(?:smallest|least|lowest|minimum|min\.)\s+(?:angular\s+)?(?:speed"
            r"|velocity)(?:\s+of\s+rotation)?",
              r"(?:kleinste|niedrigste|minimale)\s+(?:winkelgeschwindigkeit|drehzahl)", r"最(?:小"
              r"|低)(?:角速度|回転(?:速度|数))"),
        (omega * (1 - fluctuation / 2), rotation * (1 - fluctuation / 2)), ("edit", "part"),
        mistakes=(omega * (1 - fluctuation), rotation * (1 - fluctuation)),
        only=words(r"irregularity|fluctuation|ungleichförm|変動率|fly-?wheel|schwung"),
        unless=words(r"±|\\pm\b|plus or minus|amplitude|ausschlag|振幅|half|halb|piston|kolben"),
        context=words(r"irregularity|fluctuation|ungleichförm|変動率|irregolarit|irrégularité"),
        indices=letters("min"),
    ),
    Quantity(
        "coefficient of fluctuation of energy", letters("C K k c e E beta zeta xi"),
        words(r"coefficient\s+of\s+(?:the\s+)?fluctuation\s+of\s+(?:the\s+)?energy",
            r"energy\s+fluctuation\s+coefficient",
              r"arbeitsüberschusszahl", r"エネルギー変動(?:率|係数)"),
        (excess / cycle_work,), ("power", "bare factor"), mistakes=(cycle_work / excess,),
    ),
    Quantity(
        "moment of inertia of a rim", letters("J I Theta"),
        words(r"\brim(?:\s+of\s+(?:the|a)\s+fly-?wheel)?\b", r"(?:schwung)?radkranz(?:es)?", r"リム"),
        (mass * radius**2, mass * diameter**2 / 4), ("factor", "power"),
        others=(2 * mass * radius**2, mass * radius**2 / 4),
        mistakes=(mass * radius**2 / 2, mass * diameter**2 / 8, mass * radius),
        unless=words(r"dis[ck]|scheibe|円板|about (?:a|its) diameter|arms?\b(?! and)|speichen|thick rim"
            r"|hollow|hohl|outer|inner"
                     r"|weight"),
    ),
    Quantity(
        "mass of a rim", letters("m M"),
        words(r"mass\s+of\s+the\s+rim", r"rim(?:'s)?\s+mass", r"\brim\b(?!\s+speed)", r"radkranz",
            r"masse\s+des\s+(?:rad|schwungrad)?kranzes", r"リムの質量"),
        (inertia / radius**2, 4 * inertia / diameter**2), ("factor", "power"),
        mistakes=(inertia / radius, 2 * inertia / radius**2), unless=words(r"dis[ck]|scheibe|円板"
            r"|density|dichte"),
    ),
    Quantity(
        "mean tangential pressure of a four-stroke engine", letters("t p"),
        words(r"mean\s+tangential\s+pressure", r"mittlere[rn]?\s+(?:tangential|dreh)(?:kraft)?druck",
            r"平均接線圧力?"),
        (pressure / (2 * PI),), ("factor", "turn", "part"), mistakes=(pressure / PI, pressure / (4 * PI)),
        only=FOUR, unless=TWO, is_told_once=True,
    ),
    Quantity(
        "mean tangential pressure of a two-stroke engine", letters("t p"),
        words(r"mean\s+tangential\s+pressure", r"mittlere[rn]?\s+(?:tangential|dreh)(?:kraft)?druck",
            r"平均接線圧力?"),
        (pressure / PI,), ("factor", "turn", "part"), mistakes=(pressure / (2 * PI), pressure / (4 * PI)),
        only=TWO, unless=FOUR, is_told_once=True,
    ),
    Quantity(
        "order of the lowest main harmonic of a four-stroke engine", letters("k i n nu x q j"),
        words(r"(?:lowest|first|smallest)\s+(?:main|major|principal)\s+(?:harmonic|order)",
              r"(?:erste|niedrigste)\s+haupt(?:ordnung|harmonische)", r"主(?:調和|要)?次数"),
        (cylinders / 2,), ("factor", "part"), mistakes=(2 * cylinders, cylinders), only=FOUR, unless=TWO,
        is_told_once=True,
    ),
    Quantity(
        "order of the lowest main harmonic of a two-stroke engine", letters("k i n nu x q j"),
        words(r"(?:lowest|first|smallest)\s+(?:main|major|principal)\s+(?:harmonic|order)",
              r"(?:erste|niedrigste)\s+haupt(?:ordnung|harmonische)", r"主(?:調和|要)?次数"),
        (cylinders,), ("bare factor", "part"), mistakes=(cylinders / 2,), only=TWO, unless=FOUR,
        is_told_once=True,
    ),
)  # fmt: skip
