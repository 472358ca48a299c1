"""Rates of engines: firings per second and per turn, main orders, frequencies of orders, shaft speeds."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    cylinders,
    letters,
    omega,
    stroke,
    turn_rate,
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
_PER_TURN = words(
    r"(?:power|working|firing)\s+strokes\s+(?:per|in\s+one"
    r"|in\s+each)\s+(?:crank\s*shaft\s+)?(?:revolution|turn|turn_rate)",
    r"(?:ignitions|firings|explosions)\s+(?:per|in\s+one"
    r"|in\s+each)\s+(?:crank\s*shaft\s+)?(?:revolution|turn|turn_rate)",
    r"(?:zündungen|arbeitstakte|arbeitshübe)\s+(?:je|pro)\s+(?:kurbelwellen)?umdrehung",
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

ENGINE_RATES: tuple[Quantity, ...] = (
    Quantity(
        "firing frequency of a four-stroke engine", letters("f nu F"), _FIRING_RATE,
        (turn_rate * cylinders / 2, turn_rate * cylinders / 120, omega * cylinders / (4 * PI)),
        ("factor", "part"), only=_FOUR,
        unless=words(_TWO.pattern, r"half|each|order|ordnung|次数|per\s+cylinder|je\s+zylinder"),
        is_told_once=True,
    ),
    Quantity(
        "firing frequency of a two-stroke engine", letters("f nu F"), _FIRING_RATE,
        (turn_rate * cylinders, turn_rate * cylinders / 60, omega * cylinders / (2 * PI)),
        ("bare factor",), only=_TWO,
        unless=words(_FOUR.pattern, r"order|ordnung|次数|per\s+cylinder|je\s+zylinder"),
        is_told_once=True,
    ),
    Quantity(
        "firings per turn of a four-stroke engine", _PER_TURN_LETTERS, _PER_TURN, (cylinders / 2,),
        ("factor",),
        only=_FOUR, unless=words(_TWO.pattern, r"two\s+(?:turns|revolutions)|zwei\s+umdrehungen|bank"),
        is_told_once=True,
    ),
    Quantity(
        "firings per turn of a two-stroke engine", _PER_TURN_LETTERS, _PER_TURN, (cylinders,),
        ("bare factor",),
        only=_TWO, unless=words(_FOUR.pattern, r"two\s+(?:turns|revolutions)|zwei\s+umdrehungen|bank"),
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
        "crank radius by the stroke", letters("r R"),
        words(r"crank\s+(?:radius|throw)", r"kurbelradius", r"クランク半径",
        r"rayon\s+de\s+(?:la\s+)?manivelle",
              r"radio\s+de\s+(?:la\s+)?manivela", r"raggio\s+di\s+manovella"),
        (stroke / 2,), ("factor",),
        unless=words(r"offset|desax|geschränkt|throw\s+of\s+the\s+crank\s+is\s+the\s+stroke"),
    ),
)  # fmt: skip
