"""Rates of engines: firings per second and per turn, main orders, frequencies of orders, shaft speeds."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    crank_angle,
    cylinders,
    letters,
    omega,
    period,
    rotation,
    stroke,
    turn_rate,
    turned_angle,
    words,
)

_FOUR = words(
    r"four[- ]stroke|4[- ]stroke|viertakt|4-takt|4ストローク|4サイクル|四サイクル|quatre temps"
    r"|cuatro tiempos"
    r"|quattro tempi"
)
_TWO = words(
    r"two[- ]stroke|2[- ]stroke|zweitakt|2-takt|2ストローク|2サイクル|二サイクル|deux temps|dos tiempos"
    r"|due tempi"
)
_FIRING_RATE = words(
    r"(?:firing|ignition|combustion|explosion)\s+(?:frequency|rate)",
    r"(?:ignitions|firings|explosions)\s+per\s+second",
    r"zündfrequenz", r"zündungen\s+(?:je|pro)\s+sekunde", r"(?:点火|爆発|着火)(?:周波数|頻度)",
    r"fréquence\s+d.allumage",
    r"frecuencia\s+de\s+(?:encendido|explosi[oó]n)", r"毎秒の(?:点火|爆発)回数",
)  # fmt: skip
_OF_ONE_CYLINDER = (
    r"per\s+cylinder|je\s+zylinder|(?:of|for|from)\s+(?:each|one|a\s+single)\s+cylinder|each\s+cylinder['’]s|\bbanks?\b"
    r"|(?:eines|jedes)\s+(?:einzelnen\s+)?zylinders|シリンダごと"
)
"""Words by which a rate is that of one cylinder's ignitions."""
_PER_TURN = words(
    r"(?:power|working|firing)\s+strokes\s+(?:per|in\s+one"
    r"|in\s+each)\s+(?:crank\s*shaft\s+)?(?:revolution|turn|turn_rate)",
    r"(?:ignitions|firings|explosions)\s+(?:per|in\s+one"
    r"|in\s+each)\s+(?:crank\s*shaft\s+)?(?:revolution|turn|turn_rate)",
    r"(?:zündungen|arbeitstakte|arbeitshübe)\s+(?:je|pro)\s+(?:kurbelwellen)?umdrehung",
    r"1\s?回転(?:あたり|当たり|ごと)の(?:仕事|膨張)(?:行程)?(?:回)?数",
    r"1\s?回転(?:あたり|当たり)の(?:点火|爆発|着火)(?:回)?数",
    r"main\s+(?:harmonic\s+)?order(?:\s+of\s+(?:the\s+)?(?:torque|excitation|firing))?",
    r"(?:principal|lowest\s+major|firing)\s+order(?!\s*(?:is\s+)?[:0-9])"
    r"(?=\s+of\s+(?:the\s+)?(?:torque|vibration|excitation|harmonic))",
    r"haupt(?:erreger)?ordnung", r"zündordnung", r"主次数",
)  # fmt: skip
_PER_TURN_LETTERS = letters("k n i a N Z s q nu kappa h j x e")
_FREQUENCY = (
    r"(?:frequency|frequenz|fréquence|frecuencia|frequenza|częstotliwość|frequentie|周波数|振動数)"
)
_SECOND_RATE = words(
    rf"{_FREQUENCY}\s+(?:of|der|des|dieser|de|della|di|van)\s+[^.;:$=]{{0,50}}?(?:second|secondary"
    rf"|zweite|II\.|2\.|2nd|deuxième"
    r"|segund|secondo|tweede)[^.;:$=]{0,30}",
    rf"(?:secondary|second[- ]order)\s+(?:vibration\s+|force\s+|shaking\s+)?{_FREQUENCY}",
    rf"[二2]次(?:の)?(?:慣性力の)?{_FREQUENCY}",
)
_THIS_RATE = words(
    rf"{_FREQUENCY}\s+(?:of|der|des|dieser|de|della|di|van)\s+(?:(?:this|that|the|such|dieser|esta"
    rf"|cette|questa|deze)\s+)?"
    r"(?:inertia\s+|shaking\s+|free\s+)?(?:force|vibration|kraft|massenkraft|schwingung|fuerza"
    r"|vibraci[oó]n|forza|vibrazione|kracht|trilling)",
    r"(?:vibrates|shakes)\s+(?:with|at)(?:\s+(?:a|the)\s+frequency(?:\s+of)?)?", r"この力の周波数",
)  # fmt: skip
_SECOND = words(
    r"second(?:ary|[- ]order)|second\s+order|zweiter?\s+ordnung|(?:II|2)\.\s?ordnung|segundo\s+orden"
    r"|second\s+ordre"
    r"|secondo\s+ordine|tweede\s+orde|[二2]次"
)
_OTHER_ORDER = words(
    r"first|primary|fourth|sixth|erste[rn]?\s|(?<!I)I\.\s?ordnung|1\.\s?ordnung|primer\s+orden|premier"
    r"|primo\s|eerste"
    r"|[一四六]次|firing|ignition|zünd|natural|eigen|固有|camshaft|period|half|doubl"
)
_SHAFTS = words(
    r"(?:balanc(?:e|er|ing)\s+|lanchester\s+)shafts?(?:\s+(?:speed|rotates?|turns?|runs?"
    r"|spins?)(?:\s+(?:at|with))?)?",
    r"(?:lanchester-?|ausgleichs)wellen?", r"バランス(?:シャフト|軸)|バランサ(?:ー)?(?:シャフト|軸)",
)  # fmt: skip
_FOURS = words(
    r"(?:four|4|vier)[- ]?(?:cylinder|zylinder|cyl)|(?:inline|in-line|straight|flat|reihen)[- ]?(?:four"
    r"|4|vier)"
    r"|\ba four\b|\bthe four\b|\bR4\b|\bI4\b|4気筒|四気筒|second|zweite"
)
_ANGLES, _RATES = (turned_angle, crank_angle), (turn_rate, rotation)
_ANGULAR_SPEED = words(
    r"angular\s+(?:speed|velocity)", r"winkelgeschwindigkeit", r"角速度",
    r"(?:circular|angular)\s+frequency", r"kreisfrequenz", r"角(?:振動|周波)数",
    r"(?:speed|velocity)\s+in\s+(?:radians?|rad)(?:\s+per\s+|\s?/\s?)s(?:econd)?",
)  # fmt: skip
_PERIOD = words(
    r"\bperiod\b", r"perioden(?:dauer|zeit)", r"\bperiode\b", r"um(?:lauf|drehungs)(?:zeit|dauer)",
    r"p[ée]riode\b", r"per[ií]odo\b", r"周期",
    r"time\s+(?:of|for)\s+(?:one|a|each)\s+(?:revolution|turn|oscillation)",
)  # fmt: skip
_ROTATIONAL_SPEED = words(
    r"rotational\s+(?:speed|frequency)", r"speed\s+of\s+rotation", r"(?:engine|shaft|crankshaft)\s+speed",
    r"revolutions\s+per\s+(?:minute|second)", r"number\s+of\s+revolutions", r"speed\s+in\s+(?:rpm|rev)",
    r"(?:motor|wellen)?drehzahl", r"(?:毎[分秒])?回転(?:速度|数)",
)  # fmt: skip
_OTHER_SPEED = words(
    r"cam\s?shaft|nockenwelle|カム|counter-?shaft|balanc|ausgleich|バランス|\bgear|getriebe|歯車|belt|riemen"
    r"|half|\bhalbe?[nrs]?\b|twice|double|doppelt|半分|2倍|order|ordnung|[一二三四0-9]次|harmonic|cycles?\b|arbeitsspiel"
    r"|サイクル|firing|ignition|zünd|natural|eigen|固有|slip|ratio|critical|kritisch|危険|relative|backward"
    r"|excit|erreg|torsion|planet"
)
"""Words by which a speed is another shaft's, a multiple, or one of cycles."""

ENGINE_RATES: tuple[Quantity, ...] = (
    Quantity(
        "firing frequency of a four-stroke engine", letters("f nu F"), _FIRING_RATE,
        (turn_rate * cylinders / 2, turn_rate * cylinders / 120, omega * cylinders / (4 * PI)),
        ("any", "factor", "part", "power"), only=_FOUR,
        unless=words(_TWO.pattern, _OF_ONE_CYLINDER, r"\bhalf|order|ordnung|次数"),
        is_told_once=True,
    ),
    Quantity(
        "firing frequency of a two-stroke engine", letters("f nu F"), _FIRING_RATE,
        (turn_rate * cylinders, turn_rate * cylinders / 60, omega * cylinders / (2 * PI)),
        ("any", "bare factor"), only=_TWO,
        unless=words(_FOUR.pattern, r"order|ordnung|次数|per\s+cylinder|je\s+zylinder"),
        is_told_once=True,
    ),
    Quantity(
        "firings per turn of a four-stroke engine", _PER_TURN_LETTERS, _PER_TURN, (cylinders / 2,),
        ("any", "factor"),
        only=_FOUR, unless=words(_TWO.pattern, r"per\s+two\s+(?:turns|revolutions)|(?:je"
        r"|pro)\s+zwei\s+umdrehungen|bank"),
        is_told_once=True,
    ),
    Quantity(
        "firings per turn of a two-stroke engine", _PER_TURN_LETTERS, _PER_TURN, (cylinders,),
        ("any", "bare factor"),
        only=_TWO, unless=words(_FOUR.pattern, r"per\s+two\s+(?:turns|revolutions)|(?:je"
        r"|pro)\s+zwei\s+umdrehungen|bank"),
        is_told_once=True,
    ),
    Quantity(
        "frequency of a force of the second order", letters("f nu"), _SECOND_RATE,
        (turn_rate / 30, 2 * turn_rate, omega / PI), ("factor", "part"),
        others=(2 * omega,), unless=words(r"half|natural|eigen|固有|firing|zünd"),
    ),
    Quantity(
        "frequency of that force of the second order", letters("f nu"), _THIS_RATE,
        (turn_rate / 30, 2 * turn_rate, omega / PI), ("factor", "part"), only=_SECOND,
        unless=_OTHER_ORDER,
        others=(2 * omega,),
    ),
    Quantity(
        "speed of the balance shafts of four cylinders in line", letters("n N omega Omega"), _SHAFTS,
        (2 * turn_rate, 2 * omega), ("factor", "part"), only=_FOURS,
        unless=words(r"single|one[- ]cylinder|einzyl|単気筒|two[- ]cyl|twin|three|triple|drei|3気筒|six"
        r"|V-?6|first|primary"
                     r"|erste|一次|five|fünf|V-?[0-9]|cam|nocken"),
    ),
    Quantity(
        "angular speed by the speed of rotation", letters("omega Omega"), _ANGULAR_SPEED,
        tuple(node for n in _RATES for node in (2 * PI * n, PI * n / 30)), (), mistakes=tuple(
            node
            for n in _RATES
            for node in (
                PI * n, 4 * PI * n, n / (2 * PI), PI * n / 60, PI * n / 15, 60 / (2 * PI * n),
                60 * n / (2 * PI), 30 * n / PI, n / 60, 2 * PI / n, 1 / (2 * PI * n), 120 * PI * n,
            )
        ),
        unless=_OTHER_SPEED, is_by_unit=True,
    ),
    Quantity(
        "speed of rotation by the angular speed", letters("n N f"), _ROTATIONAL_SPEED,
        (omega / (2 * PI), 30 * omega / PI), (), mistakes=(
            omega / PI, 2 * PI * omega, omega / (4 * PI), PI * omega / 30, 60 * omega / PI,
            15 * omega / PI, PI * omega / 60, 2 * PI / omega, 60 * omega, omega / 60,
            2 * PI / (60 * omega),
            60 * PI * omega, 30 * omega,
        ),
        unless=_OTHER_SPEED, is_by_unit=True,
    ),
    Quantity(
        "period by the angular frequency", letters("T tau"), _PERIOD, (2 * PI / omega,), (),
        mistakes=(1 / omega, omega / (2 * PI), 2 * PI * omega, 1 / (2 * PI * omega)),
        unless=words(r"half|halbe|firing|zünd|damp|gedämpf|減衰|beat|schwebung|order|ordnung|次"),
    ),
    Quantity(
        "angular frequency by the period", letters("omega Omega"), _ANGULAR_SPEED,
        (2 * PI / period,), (),
        mistakes=(1 / period, period / (2 * PI), 2 * PI * period, 1 / (2 * PI * period)),
        unless=words(r"half|halbe|damp|gedämpf|減衰|beat|schwebung|order|ordnung|次"),
    ),
    Quantity(
        "time of a turn of the crank", letters("t Delta_t T tau"),
        words(r"\b(?:time|duration|interval\s+of\s+time)\b", r"\bdauer\b", r"zeit(?:dauer|spanne)?\b",
              r"時間", r"durée", r"\btemps\b", r"\btiempo", r"\btempo\b", r"durata", r"duración"),
        tuple(
            node
            for a in _ANGLES
            for node in (a / omega, *(a / (k * n) for n in _RATES for k in (6, 360)))
        ),
        (), mistakes=tuple(
            node
            for a in _ANGLES
            for node in (
                a * omega, omega / a,
                *(each for n in _RATES for each in (
                    6 * a / n, a / (60 * n), a * n / 6, 6 * n / a, a / (12 * n), a / (3 * n),
                    a * n / 360, 360 * n / a,
                )),
            )
        ),
        only=words(r"crank|kurbel|クランク|manivelle|manovella|manivela|vilebrequin|cigüeñal|albero"),
        unless=words(r"camshaft|nockenwelle|period|schwing|oscillat|vibrat|カム|振動"), is_told_once=True,
    ),
    Quantity(
        "speed of the camshaft of a four-stroke engine", letters("n N f omega Omega w"),
        words(r"(?:cam\s?shaft|cam)(?:['’]s)?\s+(?:rotational\s+|angular\s+)?(?:speed|velocity)",
              r"(?:speed|velocity)\s+of\s+(?:the|its)\s+cam\s?shaft",
              r"cam\s?shaft\s+(?:therefore\s+|thus\s+|only\s+)?(?:turns|runs|rotates|spins)(?:\s+(?:only\s+)?(?:at|with))?",
              r"nockenwellen-?(?:drehzahl|geschwindigkeit)",
              r"(?:drehzahl|winkelgeschwindigkeit)\s+der\s+nockenwelle",
              r"nockenwelle\s+(?:dreht|läuft)(?:\s+sich)?(?:\s+(?:daher|also|somit|nur))?(?:\s+mit)?",
              r"(?:vitesse|régime|velocità|velocidad|speed|rotational\s+speed)\s+(?:of|de|dell['’])\s*(?:the\s+|l['’])?"
              r"(?:(?:shaft|arbre|albero|árbol)\s+)(?:at|à|a|of|de)\s+(?:cames?|camme|levas)",
              r"カム(?:軸|シャフト)の?回転(?:速度|数)"),
        (*(rate / 2 for rate in _RATES), omega / 2), ("factor", "bare factor", "power", "part"),
        mistakes=(*(2 * rate for rate in _RATES), 2 * omega),
        only=words(r"four[- ]?stroke|4[- ]?stroke|viertakt|quatre\s+temps|quattro\s+tempi"
                   r"|cuatro\s+tiempos|4\s?サイクル|四サイクル"
                   r"|[4四]\s?ストローク|every\s+two\s+(?:revolutions|turns)|every\s+second\s+(?:revolution|turn)"
                   r"|tous\s+les\s+deux\s+tours|ogni\s+due\s+giri|cada\s+dos\s+vueltas|alle\s+zwei\s+umdrehungen"
                   r"|jede\s+zweite\s+umdrehung"),
        unless=words(r"two[- ]?stroke|zweitakt|deux\s+temps|due\s+tempi|dos\s+tiempos|2\s?サイクル"
                     r"|\blobes?\b"
                     r"|radial|sternmotor|cam\s+(?:ring|plate|disc)|nocken\s+pro|mehrere\s+nocken"),
        is_told_once=True,
    ),
    Quantity(
        "crank radius by the stroke", letters("r R"),
        words(r"crank\s+(?:radius|throw)", r"kurbelradius", r"クランク半径",
        r"rayon\s+de\s+(?:la\s+)?manivelle",
              r"radio\s+de\s+(?:la\s+)?manivela", r"raggio\s+di\s+manovella"),
        (stroke / 2,), ("factor",),
        unless=words(r"offset|desax|geschränkt|throw\s+of\s+the\s+crank\s+is\s+the\s+stroke"),
    ),
)  # fmt: skip
