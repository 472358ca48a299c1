"""The crank drive: piston, side and rod forces, crank-pin forces and torque, speeds and volumes."""

from __future__ import annotations

from symbalance.document.formula import Call
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    any_force,
    area,
    back_pressure,
    clearance,
    compression,
    crank,
    crank_angle,
    cylinders,
    diameter,
    letters,
    mass,
    net_force,
    omega,
    pin,
    piston_force,
    power,
    pressure,
    radius,
    ratio,
    rod,
    rod_angle,
    rod_force,
    root,
    rotation,
    slenderness,
    stroke,
    swept,
    torque,
    total_volume,
    words,
)

TAN_ROD, SIN_ROD, COS_ROD = (Call(name, rod_angle) for name in ("tan", "sin", "cos"))
SIN_CRANK, COS_CRANK = Call("sin", crank_angle), Call("cos", crank_angle)
SIN_BOTH, COS_BOTH = (Call(name, crank_angle + rod_angle) for name in ("sin", "cos"))
DOUBLE = Call("sin", 2 * crank_angle)
_BELOW = root(1 - ratio**2 * SIN_CRANK**2)
_EXACT_SHAPES = (
    SIN_CRANK + ratio * SIN_CRANK * COS_CRANK / _BELOW,
    SIN_CRANK + ratio * DOUBLE / (2 * _BELOW),
    SIN_CRANK + DOUBLE / (2 * root(slenderness**2 - SIN_CRANK**2)),
)
"""The torque of a piston force over F r, by the crank angle alone."""
_OFFSET = r"offset|desax|geschränkt|オフセット"
_FRICTION = (
    r"(?<!ohne )(?<!without )(?<!\bno )(?<!neglecting )(?<!ignoring )(?<!neglect )(?<!ignore )"
    r"(?<!neglecting the )(?<!vernachlässigung der )(?<!vernachlässigt man die )(?<!disregarding )"
    r"(?:\bfriction(?!less|\s+(?:is |be |being |are )?(?:neglected|ignored|disregarded|left out))"
    r"|\breibung(?!s?frei|slos|\s+(?:wird |sei |werde |ist )?vernachlässigt))"
    r"|摩擦(?!力?[はを]?(?:無視|考え|考慮し|除|ない|な[いし]|抜き))"
)
"""Words for a friction that acts: it changes what a force gives at an angle."""
_ENGINE = words(
    r"crank|piston|\brod\b|cylinder|engine|gas force|kurbel|kolben|pleuel|stange|gaskraft|motor"
    r"|ピストン|クランク|連接棒|コンロッド|機関|bielle|manivelle|biella|biela|manivela|motore?\b|moteur"
)
_GAS_FORCE = words(
    r"(?:gas|combustion)\s+(?:force|load|thrust)",
    r"force\s+(?:of|from|by)\s+the\s+gas(?:es)?",
    r"gaskraft",
    r"kolbenkraft",
    r"ガス力",
    r"ガス圧力?(?:による)?力",
    r"force\s+des\s+gaz",
    r"fuerza\s+de(?:l|\s+los)\s+gas(?:es)?",
)
_FACES = (PI * diameter**2 / 4, area)
_GAS = (pressure * area, pressure * PI * diameter**2 / 4, piston_force, any_force)
_MASS_FORCE = mass * pin * omega**2
COS_DOUBLE = Call("cos", 2 * crank_angle)
_WAVES = (COS_CRANK + ratio * COS_DOUBLE, COS_CRANK + COS_DOUBLE / slenderness)
_SLENDER_ROOT = root(slenderness**2 - SIN_CRANK**2)
_HEIGHT = pin * COS_CRANK + rod * COS_ROD
_TILTS = (
    TAN_ROD * _HEIGHT, pin * SIN_BOTH / COS_ROD, pin * (SIN_CRANK + COS_CRANK * TAN_ROD),
    *(pin * shape for shape in _EXACT_SHAPES),
)  # fmt: skip
_RADIAL = words(
    r"radial\s+(?:crank\s+)?(?:force|component|thrust)(?:\s+(?:at"
    r"|on)\s+the\s+crank[- ]?pin)?",
    r"(?:radial|kurbelarm)kraft",
    r"(?:component|part)\s+along\s+the\s+crank(?:\s+(?:arm|web|throw))?(?![- ]?(?:pin"
    r"|shaft|case))",
    r"(?:komponente|anteil|kraft)\s+(?:längs|entlang|in\s+richtung)\s+de[rs]\s+"
    r"kurbel(?:arms?|wange|kröpfung|radius)?(?![a-zäöü])",
    r"(?:半径|法線)(?:方向の?)?(?:力|分力|成分)",
)
_RADIAL_PARTS = (
    piston_force * COS_BOTH / COS_ROD, any_force * COS_BOTH / COS_ROD, rod_force * COS_BOTH,
    any_force * (COS_CRANK - SIN_CRANK * TAN_ROD), piston_force * (COS_CRANK - SIN_CRANK * TAN_ROD),
)  # fmt: skip
_INWARDS = (
    r"positive?\s+(?:when\s+|if\s+)?(?:directed\s+|counted\s+|pointing\s+)?(?:inwards?|(?:towards?|to)\s+the\s+"
    r"(?:crank\s?shaft|crank|shaft|main\s+bearing)(?:['’]s)?(?:\s+(?:centre|center|axis))?)"
    r"|positiv\w*\s+(?:zur|nach)\s+(?:kurbelwelle\w*|wellenmitte|innen)"
    r"|(?:zur\s+\w*(?:welle|mitte|achse)\w*|nach\s+innen)(?:\s+hin)?\s+positiv"
    r"|(?:クランク軸|軸)(?:中心)?(?:に|へ)?(?:向か(?:う|って)|向き)[^。、]{0,8}正"
)
"""Words by which a force is counted positive towards the crankshaft."""


_STROKES_IN_A_TIME = (
    r"(?:strokes?|hübe)\s?(?:per|each|every|an?|in\s+(?:one|a|der)|je|pro|/)\s?(?:minute|sekunde|second|min\b|s\b)"
    r"|(?:number|anzahl|zahl)\s+(?:of|der)\s+(?:strokes|hübe)|hubzahl|hubfrequenz"
)
"""Words by which n counts strokes; that the piston makes two of them a turn says nothing of n."""

CRANK_DRIVE: tuple[Quantity, ...] = (
    Quantity(
        "mean piston speed", letters("v c V u C S U w"),
        words(r"mean\s+(?:piston\s+)?speed(?:\s+of\s+the\s+piston)?",
        r"mean\s+(?:piston\s+)?velocity(?:\s+of\s+the\s+piston)?",
               r"average\s+piston\s+(?:speed|velocity)", r"mittlere\s+kolbengeschwindigkeit",
               r"平均ピストン(?:速度|スピード)", r"ピストン(?:の)?平均速度",
               r"(?:its|whose|the\s+piston['’]s)\s+(?:mean|average)\s+(?:speed|velocity)",
               r"(?:speed|velocity|vitesse|velocit[àa]|velocidad)\s+(?:mean|moyenne|media)(?:\s+(?:of|du|del)\s+"
               r"(?:the\s+)?piston\w*)?",
               r"(?:seine|deren|dessen|die)\s+mittlere\s+geschwindigkeit(?:\s+des\s+kolbens)?",
               r"(?:その)?平均(?:の)?速度"),
        (2 * stroke * rotation, stroke * rotation / 30, 4 * crank * rotation, crank * rotation / 15,
         stroke * omega / PI, 2 * crank * omega / PI),
        never=words(_STROKES_IN_A_TIME),
        unless=words(r"doppelh|mean square|quadrat|crank ?pin|rim|umfang|circumf"
        r"|周速|\bgas|luft"
                      r"|half[- ]stroke|vehicle|fahrzeug|\bcar\b|véhicule|車両|\bvalve|ventil"
                      r"|soupape|valvola|válvula|バルブ"
                      r"|\boil\b|\böl|\bhuile|\bolio\b|aceite"),
        only=words(r"piston|kolben|ピストン"),
    ),
    Quantity(
        "swept volume", letters("V Q"),
        words(r"swept\s+volume", r"(?:piston|engine|cylinder)\s+displacement",
        r"displacement\s+volume",
               r"(?:total|whole"
               r"|entire)\s+(?:\w+\s+)?displacement",
               r"displacement\s+of\s+(?:the\s+)?(?:whole\s+)?engine",
               r"gesamt-?(?:hubraum"
               r"|hubvolumen)", r"cubic\s+capacity", r"displacement\s+of\s+(?:one|a|each)\s+cylinder",
        r"hubraum", r"hubvolumen", r"行程容積", r"総?排気量"),
        (PI * diameter**2 * stroke / 4, PI * diameter**2 * stroke * cylinders / 4,
         PI * diameter**2 * crank / 2, PI * diameter**2 * crank * cylinders / 2, area * stroke,
         area * stroke * cylinders, 2 * area * crank),
        others=(PI * radius**2 * stroke, PI * radius**2 * stroke * cylinders),
        unless=words(r"clearance|compression volume|kompressionsraum|隙間容積|opposed"
        r"|gegenkolben|対向"),
    ),
    Quantity(
        "piston area", letters("A S F"),
        words(r"piston\s+area", r"area\s+of\s+the\s+piston", r"bore\s+area",
        r"kolben(?:fläche|querschnitt)",
               r"ピストン(?:の)?(?:断?面積|受圧面積)", r"受圧面積"),
        (PI * diameter**2 / 4, PI * radius**2), unless=words(r"ring|piston rod|kolbenstange"
        r"|ピストンロッド"
        r"|rod side"),
    ),
    Quantity(
        "gas force", letters("F P K"), _GAS_FORCE,
        (PI * diameter**2 * pressure / 4, PI * radius**2 * pressure, area * pressure),
        unless=words(r"side|seiten|inertia|massenkraft|difference|differenz|under ?side|crankcase"),
        context=words(r"\bgas(?:es)?\b", r"gasdruck", r"\bgaz\b", "ガス"), indices=letters("g G gas Gas"),
    ),
    Quantity(
        "gas force against the pressure below the piston", letters("F P K"), _GAS_FORCE,
        tuple(face * (pressure - back_pressure) for face in _FACES),
        ("edit", "factor", "power", "part"),
        mistakes=(
            *(face * (back_pressure - pressure) for face in _FACES),
            *(face * (pressure + back_pressure) for face in _FACES),
            PI * diameter * (pressure - back_pressure) / 4,
        ),
        unless=words(r"inertia|massenkraft|\brings?\b|under ?side|piston rod|kolbenstange|tandem"),
    ),
    Quantity(
        "force of gas and mass on the piston", letters("F P R K Q"),
        words(r"(?:resultant|resulting|total|net|effective)\s+(?:piston\s+)?(?:force|effort|load|thrust)"
              r"(?:\s+on\s+the\s+piston)?", r"force\s+(?:resultant|total)e?",
              r"piston\s+effort", r"(?:resultierende|gesamte?"
              r"|wirksame)[nrs]?\s*(?:kolben)?kraft", r"合力"),
        (), ("edit",), approximate=tuple(gas - _MASS_FORCE * wave for gas in _GAS for wave in _WAVES),
        mistakes=(
            *(gas + _MASS_FORCE * wave for gas in _GAS for wave in _WAVES),
            *(gas - _MASS_FORCE * (SIN_CRANK + ratio * DOUBLE) for gas in _GAS),
            *(gas - _MASS_FORCE * (SIN_CRANK + DOUBLE / slenderness) for gas in _GAS),
            pressure / area - _MASS_FORCE * _WAVES[0],
        ),
        unless=words(_OFFSET, r"crank[- ]end|double[- ]acting|under ?side|below the piston|suction"
        r"|vacuum|doppeltwirk|複動|opposed|gegenkolben|\bweight\b|gewicht|scotch|outwards?\s+positive"
        r"|positive\s+outwards?|away from the crank"),
        turns=True, only=_ENGINE, is_told_once=True,
    ),
    Quantity(
        "volume of a cylinder at a crank angle", letters("V"),
        words(r"volume\s+of\s+the\s+(?:cylinder|(?:combustion|working)\s+(?:chamber|space))",
              r"(?:instantaneous|momentary)\s+(?:cylinder\s+)?volume", r"cylinder\s+volume",
              r"volume\s+(?:above|over)\s+the\s+piston", r"zylinder(?:raum)?volumen",
              r"(?:momentane|augenblickliche)[sn]?\s+\w*volumen", r"(?:arbeits|brenn)raumvolumen",
              r"(?:シリンダ(?:ー)?内?|筒内)(?:の)?容積", r"volume\s+instantan(?:é|eo)"),
        (
            clearance * (1 + (compression - 1) / 2 * (slenderness + 1 - COS_CRANK - _SLENDER_ROOT)),
            clearance * (1 + (compression - 1) / 2 * (1 - COS_CRANK + (1 - _BELOW) / ratio)),
            *(clearance + face * (pin + rod - pin * COS_CRANK - root(rod**2 - pin**2 * SIN_CRANK**2))
              for face in _FACES),
        ),
        ("edit",),
        approximate=(
            clearance * (1 + (compression - 1) / 2 * (1 - COS_CRANK + ratio * SIN_CRANK**2 / 2)),
        ),
        mistakes=(
            clearance * (1 + compression / 2 * (slenderness + 1 - COS_CRANK - _SLENDER_ROOT)),
            clearance * (1 + (compression - 1) / 2 * (slenderness - 1 + COS_CRANK - _SLENDER_ROOT)),
            (compression - 1) / 2 * clearance * (slenderness + 1 - COS_CRANK - _SLENDER_ROOT),
        ),
        unless=words(_OFFSET, r"opposed|gegenkolben|wankel|rotary"), turns=True, only=_ENGINE,
        is_told_once=True,
    ),
    Quantity(
        "couple of the side force on the frame", letters("M T K C Q"),
        words(r"couple\s+(?:that|which)\s+tends\s+to\s+(?:roll|tilt|overturn|rock|turn|twist)",
              r"(?:rolling|tilting|overturning|reaction|roll)\s+(?:couple|moment|torque)",
              r"kippmoment", r"rückdrehmoment", r"reaktionsmoment",
              r"(?:転倒|転覆|横揺れ|ローリング)モーメント|反作用(?:トルク|モーメント)"),
        tuple(force * node for force in (any_force, piston_force) for node in _TILTS), ("edit",),
        mistakes=tuple(
            force * node
            for force in (any_force, piston_force)
            for node in (
                TAN_ROD * (pin * SIN_CRANK + rod * SIN_ROD), SIN_ROD * _HEIGHT,
                TAN_ROD * (rod * COS_ROD - pin * COS_CRANK), pin * COS_BOTH / COS_ROD,
                rod * SIN_BOTH / COS_ROD, pin * SIN_BOTH, COS_ROD * _HEIGHT,
            )
        ),
        unless=words(_OFFSET, r"gyro|kreisel|unbalanced couple|rocking"), turns=True, only=_ENGINE,
        is_told_once=True,
    ),
    Quantity(
        "circumferential speed", letters("v u V"),
        words(r"(?:circumferential|peripheral|rim|tip)\s+(?:speed|velocity)",
        r"umfangsgeschwindigkeit", r"周速度?",
               r"crank-?pin\s+(?:speed|velocity)"),
        (radius * omega, diameter * omega / 2, PI * diameter * rotation, 2 * PI * radius * rotation,
         PI * diameter * rotation / 60, PI * radius * rotation / 30),
        unless=words(r"relative|rolling|gear|belt|planet|gleit"),
    ),
    Quantity(
        "firing interval of a four-stroke engine",
        letters("alpha delta phi varphi theta psi Delta_phi Delta_varphi beta Delta_theta"),
        words(r"firing\s+(?:interval|spacing)",
        r"(?:intervallo|intervalo|intervalle)\s+(?:angol|angul)\w+[^.;=]{0,50}(?:accension|scopp|encendid|explosion|allumage)\w*(?:\s+successiv[ei])?",
        r"between\s+(?:(?:two|successive"
            r"|consecutive)\s+)?(?:ignitions|firings)",
        r"zündabstand", r"zündfolgeabstand",
        r"(?:点火|爆発|着火)間隔"),
        (4 * PI / cylinders,), others=(), mistakes=(4 * PI / (cylinders - 1), 4 * PI * cylinders),
        unless=words(r"two[- ]stroke|2[- ]stroke|zweitakt|2-takt|2ストローク|2サイクル|uneven|ungleich"
        r"|irregular|不等"
                      r"|odd|per\s+bank|in\s+one\s+bank|je bank|crank\s?pins?|throws?|kröpf"
                      r"|hubzapfen|ピン"),
        only=words(r"four[- ]stroke|4[- ]stroke|viertakt|4-takt|4ストローク|4サイクル|四サイクル"),
        slips=("any", "factor"),
    ),
    Quantity(
        "firing interval of a two-stroke engine",
        letters("alpha delta phi varphi theta psi Delta_phi Delta_varphi beta Delta_theta"),
        words(r"firing\s+(?:interval|spacing)",
        r"(?:intervallo|intervalo|intervalle)\s+(?:angol|angul)\w+[^.;=]{0,50}(?:accension|scopp|encendid|explosion|allumage)\w*(?:\s+successiv[ei])?",
        r"between\s+(?:(?:two|successive"
            r"|consecutive)\s+)?(?:ignitions|firings)",
        r"zündabstand", r"zündfolgeabstand",
        r"(?:点火|爆発|着火)間隔"),
        (2 * PI / cylinders,), mistakes=(2 * PI / (cylinders - 1), 2 * PI * cylinders),
        unless=words(r"four[- ]stroke|4[- ]stroke|viertakt|4-takt|4ストローク|4サイクル"
        r"|四サイクル|uneven|ungleich"
                      r"|irregular|不等|odd|per\s+bank|je bank|double[- ]acting|doppeltwirk|複動"),
        only=words(r"two[- ]stroke|2[- ]stroke|zweitakt|2-takt|2ストローク|2サイクル|二サイクル"),
        slips=("any", "factor"),
    ),
    Quantity(
        "side force on the cylinder wall", letters("N F S Q R G H L"),
        words(r"(?:side|lateral|normal|wall|piston\s+side|guide|slide[- ]?bar|skirt|slipper)\s+(?:force"
            r"|thrust|pressure|load|loading|reaction)", r"side[- ]thrust",
              r"thrust\s+(?:on|against)\s+the\s+(?:cylinder\s+)?(?:wall|liner|bore)",
              r"(?:force|pressure|thrust)\s+(?:up)?(?:on|against)\s+the\s+(?:cylinder\s+)?"
              r"(?:wall|guides?|slide[- ]?bars?)",
              r"(?:kolben)?(?:seiten|normal|führungs|gleitbahn)(?:druck)?kraft",
              r"(?:側圧|側方力|サイドスラスト|スラスト力)", r"(?:effort|force|poussée)\s+latérale?",
              r"fuerza\s+(?:lateral|normal)"),
        (piston_force * TAN_ROD, any_force * TAN_ROD, rod_force * SIN_ROD,
        piston_force * SIN_ROD / COS_ROD,
         any_force * SIN_ROD / COS_ROD, piston_force * ratio * SIN_CRANK / COS_ROD,
         any_force * ratio * SIN_CRANK / root(1 - ratio**2 * SIN_CRANK**2),
         piston_force * ratio * SIN_CRANK / root(1 - ratio**2 * SIN_CRANK**2)),
        ("any", "edit", "bare factor", "power"),
        mistakes=(piston_force / TAN_ROD, piston_force * COS_ROD, piston_force * SIN_ROD,
        net_force * SIN_ROD, net_force * COS_ROD, net_force / TAN_ROD, rod_force * TAN_ROD,
                  rod_force * COS_ROD, piston_force * ratio * COS_CRANK),
        others=(any_force * SIN_ROD,),
        approximate=(piston_force * ratio * SIN_CRANK, any_force * ratio * SIN_CRANK),
        unless=words(_OFFSET, r"crosshead guide angle|bearing|reibungsbeiwert", _FRICTION),
        turns=True, only=_ENGINE, is_told_once=True,
    ),
    Quantity(
        "force in the connecting rod", letters("F S Q P R"),
        words(r"(?:connecting[- ]?)?rod\s+(?:force|thrust|load)",
              r"(?:force|thrust)\s+(?:in|of|along|on)\s+the\s+(?:connecting[- ])?rod",
              r"(?:force|thrust|load)\s+(?:(?:which|that)\s+(?:is|the\s+rod)\s+)?"
              r"(?:transmit(?:s|ted)|carrie[sd]|borne|transmise?|transmitid[oa]|trasmess[oa])\s+"
              r"(?:by|through|along|by\s+means\s+of)\s+the\s+(?:connecting[- ])?rod",
              r"(?:pleuel|stangen|pleuelstangen|schubstangen)-?(?:stangen)?kraft",
              r"(?:effort|force)\s+(?:dans|de)\s+la\s+bielle", r"fuerza\s+(?:en|de)\s+la\s+biela",
              r"(?:連接棒|コンロッド)(?:の|に(?:働|作用)く)?(?:軸)?力"),
        (piston_force / COS_ROD, any_force / COS_ROD,
         any_force / root(1 - ratio**2 * SIN_CRANK**2), piston_force / root(1 - ratio**2 * SIN_CRANK**2),
         any_force / root(1 - ratio**2), piston_force / root(1 - ratio**2)),
        ("any", "edit", "bare factor", "power"),
        mistakes=(piston_force * root(1 - ratio**2), net_force * COS_ROD, net_force / SIN_ROD,
                  net_force / TAN_ROD,
                  piston_force * COS_ROD, piston_force / SIN_ROD, piston_force * TAN_ROD,
        piston_force * SIN_ROD),
        others=(any_force / SIN_ROD, any_force * COS_ROD, any_force / TAN_ROD),
        unless=words(r"component|komponente|分力|成分|projection|inertia force of the rod|offset"
        r"|geschränkt"),
        turns=True, only=_ENGINE, is_told_once=True,
    ),
    Quantity(
        "tangential force at the crank pin", letters("F T P Q E K"),
        words(r"(?:tangential|turning|crank)\s+(?:force|effort)(?:\s+(?:at|on)\s+the\s+crank[- ]?pin)?",
              r"tangential(?:ly)?\s+(?:at|on)\s+the\s+(?:crank[- ]?)?pin",
              r"(?:component|part)\s+(?:(?:at\s+right\s+angles|perpendicular|normal|square)\s+to"
              r"|across)\s+the\s+crank(?:\s+(?:arm|web|throw))?(?![- ]?(?:pin|shaft|case))",
              r"(?:komponente|anteil|kraft)\s+(?:senkrecht|rechtwinklig|quer)\s+zu[rm]?\s+"
              r"kurbel(?:arm|wange|kröpfung|radius)?(?![a-zäöü])",
              r"(?:接線|円周|回転)方向の?(?:分力|成分|力)", r"クランク(?:腕|アーム)?に(?:垂直"
              r"|直角)な?(?:方向の?)?(?:分力|成分|力)",
              r"(?:tangential|dreh|umfangs)kraft", r"(?:接線|回転)力"),
        (piston_force * SIN_BOTH / COS_ROD, any_force * SIN_BOTH / COS_ROD, rod_force * SIN_BOTH,
         any_force * (SIN_CRANK + COS_CRANK * TAN_ROD),
         piston_force * (SIN_CRANK + COS_CRANK * TAN_ROD), torque / pin,
         *(force * shape for force in (any_force, piston_force) for shape in _EXACT_SHAPES)),
        ("any", "edit", "bare factor", "power"),
        approximate=tuple(
            force * (SIN_CRANK + second)
            for force in (any_force, piston_force)
            for second in (ratio * DOUBLE / 2, DOUBLE / (2 * slenderness))
        ),
        mistakes=(piston_force * COS_BOTH / COS_ROD, piston_force * SIN_BOTH, net_force * SIN_BOTH,
                  piston_force * (COS_CRANK + SIN_CRANK * TAN_ROD),
                  any_force * (COS_CRANK + SIN_CRANK * TAN_ROD)),
        others=(any_force * SIN_BOTH, any_force * COS_BOTH),
        unless=words(_OFFSET, r"\bgears?\b|\bbelt|inertia of"), turns=True, only=_ENGINE,
        is_told_once=True,
    ),
    Quantity(
        "radial force at the crank pin", letters("F R P Z Q"),
        _RADIAL,
        (piston_force * COS_BOTH / COS_ROD, any_force * COS_BOTH / COS_ROD, rod_force * COS_BOTH,
         any_force * (COS_CRANK - SIN_CRANK * TAN_ROD),
         piston_force * (COS_CRANK - SIN_CRANK * TAN_ROD), -piston_force * COS_BOTH / COS_ROD,
         -any_force * COS_BOTH / COS_ROD),
        ("any", "edit", "bare factor", "power"),
        mistakes=(piston_force * SIN_BOTH / COS_ROD, piston_force * COS_BOTH, net_force * COS_BOTH),
        others=(any_force * SIN_BOTH,),
        unless=words(_OFFSET, r"bearing clearance|magnet|gear", _INWARDS), turns=True, only=_ENGINE,
        is_told_once=True,
    ),
    Quantity(
        "radial force at the crank pin, positive inwards", letters("F R P Z Q"), _RADIAL,
        _RADIAL_PARTS, ("any", "edit", "bare factor", "power"),
        mistakes=(*(-each for each in _RADIAL_PARTS), piston_force * SIN_BOTH / COS_ROD,
                  piston_force * COS_BOTH, net_force * COS_BOTH),
        others=(any_force * SIN_BOTH,),
        only=words(_INWARDS), unless=words(_OFFSET, r"bearing clearance|magnet|gear"), turns=True,
    ),
    Quantity(
        "torque of a crank", letters("M T Q"),
        words(r"(?:turning|crank(?:ing|shaft)?|engine|driving)\s+(?:moment|torque)", r"\btorque",
        r"(?:kurbel|motor|gas)?dreh-?moment",
              r"(?:回転|クランク)(?:モーメント|トルク)", r"トルク", r"crank\s+effort",
              r"couple\s+(?:moteur|instantané)",
              r"momento\s+(?:motore|motor|torcente)", r"par\s+motor"),
        (piston_force * pin * SIN_BOTH / COS_ROD, any_force * pin * SIN_BOTH / COS_ROD,
         any_force * pin * (SIN_CRANK + COS_CRANK * TAN_ROD),
         piston_force * pin * (SIN_CRANK + COS_CRANK * TAN_ROD),
         *(force * pin * shape for force in (any_force, piston_force) for shape in _EXACT_SHAPES),
         rod_force * pin * SIN_BOTH, power / omega, power / (2 * PI * rotation),
         60 * power / (2 * PI * rotation)),
        ("any", "edit", "bare factor", "power"),
        mistakes=(piston_force * pin * COS_BOTH / COS_ROD, any_force * pin * COS_BOTH / COS_ROD,
        power * omega,
                  power / rotation, 2 * PI * power / rotation, 2 * PI * power * rotation,
                  any_force * pin * (SIN_CRANK + ratio * DOUBLE)),
        approximate=(any_force * pin * (SIN_CRANK + ratio * DOUBLE / 2),
                     piston_force * pin * (SIN_CRANK + ratio * DOUBLE / 2),
                     any_force * pin * (SIN_CRANK + DOUBLE / (2 * slenderness))),
        others=(any_force * pin * SIN_BOTH, any_force * pin * COS_BOTH, any_force * pin * SIN_ROD,
                any_force * pin * SIN_CRANK, any_force * pin * COS_CRANK),
        unless=words(_OFFSET, r"gear|getriebe|歯車|inertia torque|massendrehmoment|damp(?!f)|dämpf"
        r"|friction"
                     r"|reibung|synchron|gravity|schwerkraft"),
        turns=True, only=_ENGINE, is_told_once=True,
    ),
    Quantity(
        "ratio of the crank to the rod", letters("lambda"),
        words(r"(?:ratio\s+of\s+(?:the\s+)?)?crank\s+(?:radius\s+)?to\s+(?:the\s+)?(?:connecting\s+)?rod(?:\s+(?:ratio|length))?",
              r"(?:schub|pleuel)?stangenverhältnis", r"連桿比"),
        (pin / rod, stroke / (2 * rod)), (), mistakes=(stroke / rod, 2 * stroke / rod),
        others=(rod / pin,),
    ),
    Quantity(
        "stroke of a crank", letters("s S H L h"),
        words(r"(?:piston\s+)?stroke", r"(?:kolben)?hub(?![a-zäöü])", r"行程", r"ストローク"),
        (2 * pin,), ("bare factor", "power"), only=words(r"crank|kurbel|クランク"),
        unless=words(_OFFSET, r"eccentric|exzenter|half|\bhalb|volume|volumen|strokes|opposed|ratio"),
    ),
    Quantity(
        "compression ratio", letters("epsilon varepsilon r R kappa"),
        words(r"compression\s+ratio", r"verdichtungsverhältnis", r"圧縮比"),
        ((swept + clearance) / clearance, 1 + swept / clearance), ("edit",),
        mistakes=(swept / clearance, clearance / (swept + clearance), (swept + clearance) / swept,
                  (swept - clearance) / clearance, swept / (swept + clearance)),
        others=(total_volume / clearance,), unless=words(r"effective|total volume|pressure|druckverh"
        r"|圧力比|whole volume|gesamtvolumen|V_max"
                      r"|largest volume|volume at bottom|bottom dead|BDC"),
    ),
    Quantity(
        "clearance volume", letters("V"),
        words(r"clearance\s+volume", r"(?:kompressions|verdichtungs)(?:raum|volumen)",
        r"(?:すきま|隙間|燃焼室)容積"),
        (swept / (compression - 1),), ("edit",),
        mistakes=(swept / compression, swept / (compression + 1), swept * (compression - 1),
                  swept * compression, (compression - 1) / swept, swept / (1 - compression)),
        others=(total_volume / compression,), unless=words(r"total|gesamt|全容積|whole|bottom"),
    ),
    Quantity(
        "largest piston speed", letters("v dot_x V c u"),
        words(r"(?:largest|greatest|maximum|peak|highest|max\.)\s+(?:piston\s+)?(?:speed"
        r"|velocity)(?:\s+of\s+the\s+piston)?",
              r"(?:größte|maximale|höchste)\s+kolbengeschwindigkeit",
              r"(?:最大ピストン速度|ピストンの?最大速度)"),
        (), ("edit",), mistakes=(pin * omega * (1 + ratio),),
        approximate=(pin * omega * (1 + ratio**2 / 2), pin * omega * root(1 + ratio**2), pin * omega,
                     pin * omega * (1 + pin**2 / (2 * rod**2)),
                     pin * omega * (1 + 1 / (2 * slenderness**2)),
                     pin * omega * root(1 + pin**2 / rod**2)), only=words(r"piston|kolben|ピストン"),
        unless=words(_OFFSET, r"l\s*/\s*r|mean|mittlere|平均"),
    ),
    Quantity(
        "largest piston acceleration", letters("a ddot_x b"),
        words(r"(?:largest|greatest|maximum|peak|highest"
        r"|max\.)\s+(?:piston\s+)?acceleration(?:\s+of\s+the\s+piston)?",
              r"(?:größte|maximale|höchste)\s+(?:kolben)?beschleunigung", r"最大(?:ピストン)?加速度",
              r"(?:piston\s+)?acceleration\s+(?:at|in)\s+(?:the\s+)?(?:top|inner"
              r"|upper)\s+dead\s+cent(?:re|er)",
              r"(?:kolben)?beschleunigung\s+im\s+(?:OT|oberen\s+totpunkt)",
              r"上死点(?:で|に)の(?:ピストンの?)?加速度"),
        (pin * omega**2 * (1 + ratio), pin * omega**2 * (1 + 1 / slenderness),
        pin * omega**2 * (1 + pin / rod),
         -pin * omega**2 * (1 + ratio), -pin * omega**2 * (1 + pin / rod)),
        ("edit",), mistakes=(pin * omega**2 * (1 - ratio), pin * omega * (1 + ratio)),
        unless=words(_OFFSET, r"inner|crank end|away from|bottom|lower|outer|unteren|\bUT\b|下死点"
        r"|smallest|kleinste|first order"
                     r"|erste[rn]? ordnung|l\s*/\s*r|simple harmonic"),
        context=words(
            r"accelerat|beschleunig|加速|accélérat|accelerazion|aceleraci|piston|kolben|inertia|ピストン"
        ),
        indices=letters("max"),
    ),
    Quantity(
        "piston acceleration at the bottom dead centre", letters("a ddot_x b"),
        words(r"(?:piston\s+)?acceleration\s+(?:at|in)\s+(?:the\s+)?(?:bottom|outer"
        r"|lower)\s+dead\s+cent(?:re|er)",
              r"(?:kolben)?beschleunigung\s+im\s+(?:UT|unteren\s+totpunkt)",
              r"下死点(?:で|に)の(?:ピストンの?)?加速度"),
        (pin * omega**2 * (1 - ratio), -pin * omega**2 * (1 - ratio), pin * omega**2 * (1 - pin / rod),
         -pin * omega**2 * (1 - pin / rod), pin * omega**2 * (ratio - 1),
         pin * omega**2 * (1 - 1 / slenderness)),
        ("edit",), mistakes=(pin * omega**2 * (1 + ratio), -pin * omega**2 * (1 + ratio)),
        unless=words(_OFFSET, r"top|inner|outer|crank end|upper|oberen|\bOT\b|上死点"),
    ),
    Quantity(
        "angular velocity of the rod", letters("omega Omega dot_phi dot_varphi dot_beta dot_psi"),
        words(r"angular\s+(?:velocity|speed)\s+of\s+the\s+(?:connecting[- ])?rod",
              r"(?:rod|connecting[- ]rod)(?:'s)?\s+angular\s+(?:velocity|speed)",
              r"winkelgeschwindigkeit\s+(?:des\s+pleuels|der\s+(?:pleuel)?stange|der\s+pleuelstange)",
              r"(?:連接棒|コンロッド)の(?:揺動)?角速度"),
        (ratio * omega * COS_CRANK / COS_ROD,
         ratio * omega * COS_CRANK / root(1 - ratio**2 * SIN_CRANK**2),
         -ratio * omega * COS_CRANK / COS_ROD,
         omega * COS_CRANK / _SLENDER_ROOT, -omega * COS_CRANK / _SLENDER_ROOT,
         omega * COS_CRANK / (slenderness * COS_ROD), -omega * COS_CRANK / (slenderness * COS_ROD),
         pin * omega * COS_CRANK / root(rod**2 - pin**2 * SIN_CRANK**2),
         pin * omega * COS_CRANK / (rod * COS_ROD), -pin * omega * COS_CRANK / (rod * COS_ROD)),
        ("any", "edit", "bare factor", "power"),
        approximate=(
            omega * COS_CRANK / slenderness,
            ratio * omega * COS_CRANK,
            -ratio * omega * COS_CRANK,
        ),
        turns=True,
        only=_ENGINE, is_told_once=True,
        unless=words(_OFFSET, r"articulated|neben"),
    ),
    Quantity(
        "angular acceleration of the rod",
        letters("alpha epsilon ddot_phi ddot_varphi ddot_beta ddot_psi"),
        words(r"angular\s+acceleration\s+of\s+the\s+(?:connecting[- ])?rod",
              r"(?:rod|connecting[- ]rod)(?:'s)?\s+angular\s+acceleration",
              r"winkelbeschleunigung\s+(?:des\s+pleuels|der\s+(?:pleuel)?stange|der\s+pleuelstange)",
              r"(?:連接棒|コンロッド)の角加速度"),
        (-(omega**2) * SIN_CRANK * (slenderness**2 - 1) / _SLENDER_ROOT**3,
         omega**2 * SIN_CRANK * (slenderness**2 - 1) / _SLENDER_ROOT**3,
         -ratio * omega**2 * SIN_CRANK * (1 - ratio**2) / root(1 - ratio**2 * SIN_CRANK**2) ** 3,
         ratio * omega**2 * SIN_CRANK * (1 - ratio**2) / root(1 - ratio**2 * SIN_CRANK**2) ** 3,
         -ratio * omega**2 * SIN_CRANK * (1 - ratio**2) / COS_ROD**3,
         ratio * omega**2 * SIN_CRANK * (1 - ratio**2) / COS_ROD**3),
        ("any", "edit", "bare factor", "power"),
        approximate=(
            omega**2 * SIN_CRANK / slenderness,
            -(omega**2) * SIN_CRANK / slenderness,
            -ratio * omega**2 * SIN_CRANK,
            ratio * omega**2 * SIN_CRANK,
        ),
        turns=True, unless=words(_OFFSET, r"articulated|neben"),
    ),
)  # fmt: skip
