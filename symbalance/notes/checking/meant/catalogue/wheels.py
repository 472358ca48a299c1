"""Flywheels and rims: thin rims, speeds that a rim stands, energy given off between two speeds."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.cycle_roles import (
    first_omega,
    highest_rate,
    lowest_rate,
    second_omega,
)
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    clearance,
    density,
    diameter,
    inertia,
    length,
    letters,
    mass,
    radius,
    root,
    rotation,
    stress,
    swept,
    wall_of_weight,
    words,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import static_strength
from symbalance.notes.checking.meant.catalogue.strength import both

_INERTIA = words(
    r"(?:mass\s+)?moment\s+of\s+inertia", r"\binertia", r"(?:massen)?trägheitsmoment", r"慣性モーメント"
)
_THIN_RIM = words(
    r"thin\s+(?:\w+\s+)?(?:rim|ring|hoop)", r"dünne\w*\s+(?:\w*kranz\w*|ring\w*|reifen\w*)",
    r"薄い(?:円環|リング|リム)", r"(?:jante|couronne|anneau)\s+(?:mince|thin)",
    r"(?:corona|anello)\s+sottile",
    r"(?:llanta|corona|anillo)\s+delgad[ao]",
    r"mass\s+(?:is\s+|sits\s+|lies\s+)?(?:\w+\s+)?(?:concentrated\s+)?(?:in|at)\s+(?:the|its|a)\s+rim",
)  # fmt: skip
_NO_RIM = (
    r"dis[ck]s?\b|scheibe|円板|about\s+(?:a|its|the)\s+diameter|durchmesserachse|直径(?:軸|まわり)"
    r"|thick|\bdick(?!e)"
    r"|hollow|hohl|\b(?:outer|inner)\s+(?:radius|diameter)|außen|innen|\barms?\b|\bhub\b|nabe|outermost"
)
_GIVEN_OFF = words(
    r"given\s+(?:off|out|up)", r"gives?\s+(?:off|out|up)", r"releas\w+", r"deliver\w*",
    r"taken\s+(?:out|from)",
    r"abgegeben\w*", r"gibt\b[^.]{0,60}\bab\b", r"freigesetzt\w*", r"cédée?|restituée?|libérée?",
    r"cedut\w+",
    r"cedid\w+|entregad\w+", r"放出\w*", r"失う", r"slow(?:s|ed|ing)?\s+(?:\w+\s+)?(?:down\s+)?from",
)  # fmt: skip
_TAKEN_UP = (
    r"speeds?\s+up|accelerat\w+|beschleunig\w*|stored|taken\s+up|absorb\w*|aufgenommen\w*|emmagasin\w*"
    r"|accélér\w*"
    r"|加速|蓄え"
)
_GAIN = inertia * (first_omega**2 - second_omega**2)

WHEELS: tuple[Quantity, ...] = (
    Quantity(
        "moment of inertia of a rim that is thin", letters("J I Theta"), _INERTIA,
        (mass * radius**2, mass * diameter**2 / 4), ("factor", "bare factor", "power"),
        mistakes=(mass * radius**2 / 2, mass * diameter**2 / 8, mass * diameter**2,
        mass * diameter**2 / 2),
        only=_THIN_RIM, unless=words(_NO_RIM), is_told_once=True, together=(("", "mass"),),
    ),
    Quantity(
        "moment of inertia about its axle of a disc by its density", letters("J I Theta"), _INERTIA,
        tuple(node for b in (wall_of_weight, length)
              for node in (PI * density * b * radius**4 / 2, PI * density * b * diameter**4 / 32)),
        ("factor", "power"),
        mistakes=tuple(node for b in (wall_of_weight, length)
              for node in (PI * density * b * radius**4 / 4, PI * density * b * diameter**4 / 64)),
        only=both(
            words(r"densit|dichte|密度|ρ|\\rho"),
            words(r"\bdis[ck]\b|scheibe\b|円板|円盤|disque|\bdisco\b|cylinder|zylinder|cylindre"),
            words(r"axis\s+of\s+(?:rotation|revolution|symmetry)|(?:its|the)\s+(?:own\s+)?(?:axle|axis)\b"
                  r"|drehachse|symmetrieachse|autour\s+de\s+son\s+axe|(?:中心|回転)軸"),
        ),
        unless=words(_NO_RIM.replace(r"dis[ck]s?\b|scheibe|円板|", ""), r"\brims?\b|kranz|transverse"
            r"|cone|kegel|half"
                     r"|halb|parallel|second\s+moment\s+of\s+area|flächenträgheit"),
    ),
    Quantity(
        "speed that a thin rim stands", letters("v u V"),
        words(r"(?:circumferential|peripheral|rim)\s+(?:speed|velocity)", r"umfangsgeschwindigkeit",
              r"周速度?", r"vitesse\s+(?:périphérique|circonférentielle)", r"velocità\s+periferica",
              r"velocidad\s+periférica"),
        (root(stress / density),), ("factor", "bare factor", "root", "power"),
        mistakes=(stress / density, root(density / stress), root(2 * stress / density),
        root(stress * density)),
        only=words(r"\brims?\b|kranz|\bring|リム|jante|corona|llanta"),
        unless=words(r"thick|\bdick(?!e)|solid\s+dis[ck]|vollscheibe|specific\s+weight"
            r"|spezifisches\s+gewicht"
                     r"|spokes?|speichen|poisson"),
        is_told_once=True,
    ),
    Quantity(
        "circumferential speed in metres per second", letters("v u V"),
        words(r"(?:circumferential|peripheral|rim|tip|piston|belt)\s+(?:speed"
            r"|velocity)(?:\s+in\s+(?:m/s|met\w+\s+per\s+second))?",
              r"umfangsgeschwindigkeit(?:\s+in\s+m/s)?", r"周速度?"),
        (PI * diameter * rotation / 60, PI * radius * rotation / 30), ("power",),
        mistakes=(60 * PI * diameter * rotation, 120 * PI * radius * rotation,
            30 * PI * radius * rotation,
                  PI * diameter * rotation, 2 * PI * radius * rotation, diameter * rotation / 60,
                  PI * radius * rotation / 60, PI * diameter * rotation / 30,
                  PI * diameter * rotation / 120),
        only=both(words(r"(?:revolutions|turns)\s+(?:per|a)\s+minute|\brpm\b|umdrehungen\s+(?:pro"
            r"|je)\s+minute"
                        r"|tours\s+(?:par|by|per)\s+minute|min\^\{?-1|min⁻¹|毎分"),
                  words(r"met(?:re|er)s\s+(?:per|a)\s+second|\bm/s\b|meter\s+(?:pro|je)\s+sekunde"
                        r"|mètres\s+(?:par|by|per)\s+seconde|毎秒")),
        unless=words(r"per\s+second\s+\$?[nN]|revolutions\s+per\s+second|umdrehungen\s+(?:pro"
            r"|je)\s+sekunde|tip"
                     r"|relative|rolling|gear|belt|planet|gleit|mean|mittlere|half|quarter"),
    ),
    Quantity(
        "energy that a flywheel gives off between two speeds", letters("Delta_E E W Delta_W A U Q"),
        words(r"(?:kinetic\s+)?energy", r"(?:kinetische\s+)?energie", r"\bwork", r"\barbeit",
            r"エネルギー?",
              r"énergie", r"energ[ií]a"),
        (_GAIN / 2,), ("factor", "bare factor", "edit"),
        mistakes=(inertia * (second_omega**2 - first_omega**2) / 2, _GAIN,
                  inertia * (first_omega - second_omega) ** 2 / 2,
                  inertia * (first_omega - second_omega) / 2,
                  inertia * (first_omega + second_omega) ** 2 / 2,
                  inertia * (first_omega - second_omega) ** 2),
        only=both(_GIVEN_OFF), unless=words(_TAKEN_UP, r"half|halb|moitié|半分|share|each|mean\s+power"
            r"|coupling|clutch"),
    ),
    Quantity(
        "coefficient of fluctuation by the revolutions", letters("delta C epsilon K k"),
        words(
            r"(?:degree|coefficient)\s+of\s+(?:irregularity|fluctuation|speed fluctuation"
            r"|cyclic\s+irregularity)",
            r"ungleichförmigkeits?(?:grad)?", r"(?:速度)?変動率", r"回転不整率",
              r"coefficient\s+d.irrégularité", r"(?:coeficiente|grado)\s+(?:de|di|of)\s+(?:fluctuación"
              r"|irregula\w+)"),
        ((highest_rate - lowest_rate) / rotation,
        2 * (highest_rate - lowest_rate) / (highest_rate + lowest_rate)),
        ("bare factor", "power", "minus", "part"),
        others=((highest_rate - lowest_rate) / (2 * rotation),),
        mistakes=((highest_rate + lowest_rate) / rotation, rotation / (highest_rate - lowest_rate),
                  (highest_rate - lowest_rate) / (highest_rate + lowest_rate),
                  (highest_rate + lowest_rate) / (highest_rate - lowest_rate), highest_rate / lowest_rate,
                  (highest_rate + lowest_rate) / (2 * (highest_rate - lowest_rate)),
                  2 * (highest_rate + lowest_rate) / (highest_rate + lowest_rate)),
        unless=words(r"±|plus or minus|amplitude|ausschlag|振幅|half|halb"),
    ),
    Quantity(
        "compression ratio by the swept and the clearance volume", letters("epsilon varepsilon r R "
        "kappa"),
        words(r"compression\s+ratio", r"verdichtungsverhältnis", r"圧縮比", r"rapport\s+volumétrique",
              r"(?:taux|rapport)\s+(?:de|of)\s+compression", r"rapporto\s+(?:di|of)\s+compressione",
              r"relación\s+(?:de|of)\s+compresión"),
        ((swept + clearance) / clearance, 1 + swept / clearance), ("edit",),
        mistakes=(swept / clearance, clearance / (swept + clearance), (swept + clearance) / swept,
                  (swept - clearance) / clearance, swept / (swept + clearance)),
        only=both(words(r"swept\s+volume|hubvolumen|hubraum|行程容積|cylindrée|cilindrata|cilindrada"),
                  words(r"clearance\s+volume|(?:kompressions|verdichtungs)(?:raum|volumen)|(?:すきま"
                      r"|隙間|燃焼室)容積"
                        r"|volume\s+(?:mort|morto)|volumen\s+muerto|espace\s+mort")),
        unless=words(r"effective\s+compression|pressure\s+ratio|druckverh|圧力比"),
    ),
    Quantity(
        "factor of safety against yielding", letters("n S nu N s k j F"),
        words(r"safety\s+factor", r"factor\s+of\s+safety", r"sicherheit(?:szahl|sfaktor)?", r"安全率",
              r"coefficient\s+(?:de|of)\s+sécurité", r"coefficiente\s+(?:di|of)\s+sicurezza",
              r"(?:factor|coeficiente)\s+(?:de|of)\s+seguridad"),
        (static_strength / stress,), ("factor", "bare factor"),
        mistakes=(stress / static_strength, static_strength - stress, static_strength * stress),
        only=words(r"yield|fließ|streckgrenze|降伏|limite\s+(?:d.)?élastique|snervamento|fluencia"
            r"|elastic\s+limit"),
        unless=words(r"fatigue|endurance|dauer|疲|margin|utili[sz]|ausnutz|auslastung|goodman|soderberg"
            r"|allowable"
                     r"|zulässig|許容|shear|schub|torsion|せん断"),
    ),
)  # fmt: skip
