"""Work and torque: mean torques and pressures, power, energy of a flywheel and its fluctuation."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    area,
    cycle_work,
    cylinders,
    efficiency,
    fluctuation,
    force,
    inertia,
    kinetic,
    letters,
    mass,
    omega,
    omega_high,
    omega_low,
    order,
    power,
    pressure,
    radius,
    rotation,
    stroke,
    swing,
    torque,
    velocity,
    volume,
    words,
)

FOUR = words(
    r"quatre\s+temps|cuatro\s+tiempos|quattro\s+tempi|four[- ]stroke|4[- ]stroke|viertakt"
    r"|4-takt|4ストローク|4サイクル|四サイクル"
)
TWO = words(
    r"deux\s+temps|dos\s+tiempos|due\s+tempi|two[- ]stroke|2[- ]stroke|zweitakt|2-takt"
    r"|2ストローク|2サイクル|二サイクル"
)
_CYCLES = (
    r"working strokes|power strokes|(?<!/2\$ )(?<!/2 )cycles per|arbeitsspiele? (?:je|pro)|explosions"
    r"|firings|camshaft"
    r"|nockenwelle"
    r"|仕事回数"
)
_PER_TURN = (
    r"per (?:turn|revolution)|(?<!no )\bwork\b[^.;=]{0,24}?\s(?:in|of|during|over) (?:one|a|each|every)"
    r" (?:single )?(?:turn|revolution)"
    r"|(?:je|pro|in einer|jeder) umdrehung|par tour|por vuelta|per giro|[1一]回転"
)
_MEAN_TORQUE = words(
    r"(?:mean|average)\s+(?:(?:engine|brake|indicated|effective|useful|shaft)\s+)*torque", r"\btorque",
    r"torque\s+(?:mean|average|medi[oa]|moyen)", r"mittleres?\s+(?:(?:effektives"
    r"|indiziertes)\s+)?(?:dreh)?moment",
    r"dreh-?moment",
    r"平均(?:軸|正味|図示)?トルク", r"トルク", r"couple\s+moyen", r"par\s+medio",
)  # fmt: skip
_MEAN_PRESSURE = words(
    r"(?:brake\s+|indicated\s+)?mean\s+(?:effective\s+)?pressure", r"\b[bi]?mep\b",
    r"mittlerer?\s+(?:effektiver?\s+|indizierter?\s+)?(?:arbeits|kolben|nutz|innen)?druck",
    r"(?:effektive[rnms]?\s+|indizierte[rnms]?\s+)?mitteldruck", r"(?:正味|図示)?平均有効圧力?",
)  # fmt: skip
_POWER = words(
    r"(?:indicated\s+|brake\s+|effective\s+)(?<!horse)\bpower\b",
    r"(?<!horse)\bpower\b(?!\s+(?:stroke|cycle))",
    r"(?:innen|nutz|motor)?leistung", r"(?:正味|図示)?(?:出力|動力)",
)  # fmt: skip
_IRREGULARITY = words(
    r"(?:degree|coefficient)\s+of\s+(?:irregularity|fluctuation|speed fluctuation"
    r"|cyclic\s+irregularity)",
    r"cyclic\s+irregularity",
    r"ungleichförmigkeits?(?:grad)?",
    r"(?:速度)?変動率",
    r"(?:coeficiente|grado)\s+de\s+(?:fluctuación|irregularidad)",
    r"coefficient\s+d'irrégularité",
    r"回転不整率",
)
_TORQUE_MISTAKES = (
    4 * PI * pressure * volume, 2 * PI * pressure * volume, 4 * PI * pressure / volume,
    2 * PI * pressure / volume, pressure / (4 * PI * volume), pressure / (2 * PI * volume),
)  # fmt: skip
_PRESSURE_MISTAKES = (
    4 * PI * volume / torque, 2 * PI * volume / torque, torque / (4 * PI * volume),
    torque / (2 * PI * volume), 4 * PI * torque * volume, 2 * PI * torque * volume,
)  # fmt: skip


WORK: tuple[Quantity, ...] = (
    Quantity(
        "power", letters("P N"),
        words(r"(?<!horse)\bpower\b(?!\s+(?:stroke|series|of\s+[a-z]\b|cycle|law))",
        r"\bleistung", r"動力", r"出力"),
        (torque * omega, 2 * PI * rotation * torque, PI * rotation * torque / 30, force * velocity,
         swing * rotation, swing * rotation / 60),
        slips=("bare factor", "power", "turn"), unless=words(FOUR.pattern, r"indicated|indiziert|図示"
            r"|loss"
            r"|verlust|損失|specific|\bstall|no-load|leerlauf|ramp|linear|triang|dreieck|per\s+wheel"
            r"|complex|phasor"),
    ),
    Quantity(
        "kinetic energy", letters("E T K W U"),
        words(r"kinetic\s+energy", r"rotational\s+energy",
        r"(?:it|flywheel|wheel|disc|rotor)\s+(?:stores|holds|contains)", r"speichert(?:\s+(?:es|sie"
        r"|er))?", r"(?:stored|gespeicherte)\s+energ(?:y|ie)",
        r"energy\s+(?:that\s+is\s+)?stored", r"énergie\s+emmagasinée", r"energía\s+almacenada",
        r"energia\s+immagazzinata", r"蓄え(?:られる|られた|る|た)エネルギー?",
        r"(?:kinetische|rotations|bewegungs)-?\s*energie",
               r"運動エネルギー?"),
        (mass * velocity**2 / 2, inertia * omega**2 / 2, mass * radius**2 * omega**2 / 2),
        context=words(r"\benerg(?:y|ies?|í?a)\b|énergie|エネルギー?"),
        unless=words(r"change|fluctuation|swing|schwankung|änderung|変動|rolling|rollen|dis[ck]\b"
        r"|scheibe|円板|rod|stab|棒"),
    ),
    Quantity(
        "fluctuation of energy", letters("Delta_E E W Delta_W A"),
        words(r"(?:maximum\s+)?fluctuation\s+of\s+energy", r"energy\s+(?:fluctuation|swing|variation)",
               r"swing\s+of\s+energy", r"energieschwankung", r"arbeitsüberschuss", r"überschussarbeit",
               r"arbeitsschwankung", r"(?:greatest\s+|maximum\s+)?excess\s+(?:energy|work)",
               r"エネルギー?(?:の)?変動(?:量)?", r"変動エネルギー?", r"余剰(?:エネルギー?|仕事)"),
        (inertia * omega**2 * fluctuation, mass * radius**2 * omega**2 * fluctuation,
         mass * velocity**2 * fluctuation),
        context=words(r"fly-?wheel", r"\brim\b", r"schwungrad", r"radkranz", r"fluctuation", r"はずみ車",
            r"フライホイール"),
        slips=("bare factor", "power"), unless=words(r"±|plus or minus|amplitude|ausschlag|振幅"),
    ),
    Quantity(
        "moment of inertia of the flywheel", letters("J I Theta"),
        words(r"fly-?wheel", r"schwungrad\w*", r"はずみ車", r"フライホイール",
        r"\bvolant", r"volano", r"(?:required|necessary|needed)\s+(?:mass\s+)?moment\s+of\s+inertia",
        r"moment\s+of\s+inertia\s+(?:that\s+is\s+)?(?:required|needed)",
        r"(?:erforderliche|nötige|notwendige)[sn]?\s+(?:massen)?trägheitsmoment",
        r"必要な?慣性モーメント"),
        (swing / (omega**2 * fluctuation), swing / (4 * PI**2 * rotation**2 * fluctuation),
         900 * swing / (PI**2 * rotation**2 * fluctuation)), slips=("bare factor", "power", "turn"),
        unless=words(r"±|plus or minus|amplitude|ausschlag|振幅"),
    ),
    Quantity(
        "degree of irregularity", letters("delta C epsilon"),
        _IRREGULARITY,
        ((omega_high - omega_low) / omega, swing / (inertia * omega**2),
         2 * (omega_high - omega_low) / (omega_high + omega_low)),
        slips=("bare factor", "power", "minus", "part"), others=((omega_high - omega_low) / (2 * omega),),
        mistakes=((omega_high - omega_low) / (2 * (omega_high + omega_low)),
                  (omega_high + omega_low) / (omega_high - omega_low),
                  2 * (omega_high + omega_low) / (omega_high - omega_low),
                  2 * (omega_high**2 - omega_low**2) / (omega_high + omega_low),
                  (omega_high + omega_low) / (2 * omega),
                  (omega_high - omega_low) / (omega_high + omega_low)),
        unless=words(r"±|plus or minus|amplitude|ausschlag|振幅|half|halb"),
    ),
    Quantity(
        "mean torque of a four-stroke engine", letters("T M"), _MEAN_TORQUE,
        (pressure * volume / (4 * PI), pressure * volume * cylinders / (4 * PI),
         pressure * volume * efficiency / (4 * PI), pressure * volume * cylinders * efficiency / (4 * PI),
         cycle_work / (4 * PI), cycle_work * cylinders / (4 * PI),
         power / omega, power / (2 * PI * rotation)),
        ("factor", "turn", "power"), only=FOUR, unless=words(TWO.pattern, _PER_TURN), is_told_once=True,
        mistakes=_TORQUE_MISTAKES,
    ),
    Quantity(
        "mean torque of a two-stroke engine", letters("T M"), _MEAN_TORQUE,
        (pressure * volume / (2 * PI), pressure * volume * cylinders / (2 * PI),
         pressure * volume * efficiency / (2 * PI), pressure * volume * cylinders * efficiency / (2 * PI),
         cycle_work / (2 * PI), cycle_work * cylinders / (2 * PI),
         power / omega, power / (2 * PI * rotation)),
        ("factor", "turn", "power"), only=TWO, unless=words(FOUR.pattern, _PER_TURN), is_told_once=True,
        mistakes=_TORQUE_MISTAKES,
    ),
    Quantity(
        "mean effective pressure of a four-stroke engine", letters("p P"), _MEAN_PRESSURE,
        (4 * PI * torque / volume, 4 * PI * torque / (volume * cylinders),
        2 * power / (volume * rotation),
         2 * power / (volume * rotation * cylinders), 120 * power / (volume * rotation),
         4 * power / (area * velocity)),
        ("factor", "turn", "power"), only=FOUR, unless=words(TWO.pattern, _PER_TURN), is_told_once=True,
        mistakes=_PRESSURE_MISTAKES,
    ),
    Quantity(
        "mean effective pressure of a two-stroke engine", letters("p P"), _MEAN_PRESSURE,
        (2 * PI * torque / volume, 2 * PI * torque / (volume * cylinders), power / (volume * rotation),
         power / (volume * rotation * cylinders), 60 * power / (volume * rotation),
         2 * power / (area * velocity)),
        ("bare factor", "turn", "power"), only=TWO, unless=words(FOUR.pattern, _PER_TURN),
        is_told_once=True, mistakes=_PRESSURE_MISTAKES,
    ),
    Quantity(
        "mean effective pressure by the work of a cycle", letters("p P"), _MEAN_PRESSURE,
        (swing / volume,), ("bare factor", "power"),
        unless=words(r"per (?:turn|revolution)|je umdrehung"),
    ),
    Quantity(
        "power of a four-stroke engine", letters("P N"), _POWER,
        (pressure * volume * rotation / 2, pressure * volume * rotation * cylinders / 2,
         pressure * volume * rotation / 120, pressure * volume * rotation * cylinders / 120,
         pressure * volume * rotation * efficiency / 2,
         pressure * volume * rotation * cylinders * efficiency / 2,
         pressure * volume * omega / (4 * PI),
         pressure * area * stroke * rotation / 2, pressure * area * stroke * rotation * cylinders / 2,
         pressure * area * stroke * rotation / 120, pressure * area * stroke * rotation * cylinders / 120,
         pressure * area * velocity / 4, pressure * area * velocity * cylinders / 4,
         pressure * area * velocity * efficiency / 4,
         swing * rotation / 2, swing * rotation / 120, torque * omega, 2 * PI * rotation * torque,
         PI * rotation * torque / 30),
        ("factor", "turn", "power"), only=FOUR,
        context=words(r"pression[ei]?\s+(?:media|moyenne)|presi[oó]n\s+media", _MEAN_PRESSURE.pattern),
        unless=words(TWO.pattern, _CYCLES), is_told_once=True,
    ),
    Quantity(
        "power of a two-stroke engine", letters("P N"), _POWER,
        (pressure * volume * rotation, pressure * volume * rotation * cylinders,
         pressure * volume * rotation / 60, pressure * volume * rotation * cylinders / 60,
         pressure * volume * rotation * efficiency, pressure * volume * rotation * cylinders * efficiency,
         pressure * volume * omega / (2 * PI),
         pressure * area * stroke * rotation, pressure * area * stroke * rotation * cylinders,
         pressure * area * stroke * rotation / 60, pressure * area * stroke * rotation * cylinders / 60,
         pressure * area * velocity / 2, pressure * area * velocity * cylinders / 2,
         pressure * area * velocity * efficiency / 2,
         swing * rotation, swing * rotation / 60),
        ("bare factor", "turn", "power"), only=TWO,
        unless=words(FOUR.pattern, _CYCLES, r"double[- ]acting|doppeltwirk|複動"), is_told_once=True,
    ),
    Quantity(
        "fluctuation of energy of one harmonic", letters("Delta_E E W Delta_W A"),
        words(r"(?:maximum\s+)?fluctuation\s+of\s+energy", r"energy\s+(?:fluctuation|swing|variation)",
              r"energieschwankung", r"arbeitsüberschuss", r"überschussarbeit",
              r"エネルギー?(?:の)?変動(?:量)?", r"変動エネルギー?"),
        (2 * torque / order,), ("power",), mistakes=(2 * torque * order, torque * order),
        others=(torque / order,), unless=words(r"mean torque|mittlere|平均|two harmonics"),
    ),
    Quantity(
        "coefficient of fluctuation by the energy", letters("delta C epsilon"), _IRREGULARITY,
        (swing / (2 * kinetic), 2 * torque / (order * inertia * omega**2)), ("power",),
        mistakes=(2 * swing / kinetic,), others=(torque / (order * inertia * omega**2), swing / kinetic),
        unless=words(r"±|plus or minus|amplitude|ausschlag|振幅|half|halb"),
    ),
    Quantity(
        "work of a turn", letters("W A E"),
        words(r"work\s+(?:of|in|per|during)\s+(?:one|a|each)\s+(?:turn|revolution)",
              r"arbeit\s+(?:je|pro|einer)\s+umdrehung", r"1回転(?:あたり|当たり)?の仕事"),
        (2 * PI * torque,), ("turn", "factor"), unless=words(r"cycle|arbeitsspiel|サイクル|friction"
        r"|reibung"), mistakes=(PI * torque, 4 * PI * torque),
    ),
)  # fmt: skip
