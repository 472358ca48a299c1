"""Counterweights: their moment m r, at the crank and on balance shafts, and what their shape gives."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Call, Number
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    arm_of_weight,
    crank_angle,
    cylinders,
    density,
    diameter,
    eccentricity,
    grade,
    half_sector,
    height,
    inner_radius,
    letters,
    mass,
    omega,
    outer_radius,
    pin,
    pitch,
    radius,
    ratio,
    reciprocating,
    rod,
    rotating,
    rotation,
    sector,
    share,
    slender,
    turn_rate,
    unbalance,
    wall_of_weight,
    words,
)
from symbalance.notes.checking.meant.catalogue.strength import both

_TWO_RODS = words(
    r"(?-i:V)-?\s?(?:2|4|6|8|10|12|16)(?![0-9.,])|(?-i:V)-?(?:twins?|engines?|motor\w*|paar\w*)"
    r"|two\s+(?:connecting\s+)?rods|zwei\s+pleuel|deux\s+bielles|due\s+bielle|dos\s+bielas|V型"
)
"""Engines with two rods on each pin: half of what swings with both is all that swings with one."""

_MOMENT = letters("· U D u")
"""Letters of a mass times its arm: the product of two, or one."""
_WEIGHT = words(
    r"(?:counter|balance)-?\s?(?:weights?|mass(?:es)?)", r"counterpoise", r"gegengewichte?s?",
        r"ausgleichsgewichte?s?",
    r"contrepoids", r"contrapesos?", r"(?:釣り?合い|つりあい)(?:おもり|錘)", r"カウンタ(?:ー)?ウェイト",
    r"unbalance\s+of\s+the\s+counterweight", r"おもり", r"contrappes[oi]", r"(?:crank\s+)?webs?",
    r"kurbelwangen?", r"ausgleich",
)  # fmt: skip
_HALF = words(
    r"\bhalf\s+(?:of\s+)?(?:the\s+)?(?:oscillating|reciprocating)", r"hälfte\s+der\s+(?:oszill|hin)",
    r"往復[^。\n]{0,8}(?:半分|1/2|½)", r"moitié\s+(?:de\s+la|des)\s+mass\w+\s+altern",
    r"metà\s+dell[ae]\s+mass\w+\s+altern", r"mitad\s+de\s+la\s+masa\s+altern",
)  # fmt: skip
"""Words for half of what goes to and fro."""
_NO_WHOLE_WEIGHT = (
    r"\bV\b|V-?twin|\btwo\b|\bzwei|\bboth\b|beide|balance shaft|ausgleichswelle|バランサ|lanchester"
    r"|each web|je wange|both webs|\bexceeds|\bexcess|\brest\b|\bremain|\bleft\b|\bmissing|\bfehl"
    r"|überschuss|残|\bwithout\b|\bohne\b"
)
"""Words for one of several weights, or for what a weight leaves or lacks."""
_SHAFT = words(
    r"(?:each|every)\s+(?:of\s+(?:the|these)\s+)?(?:two\s+)?(?:balance[r]?\s+)?shafts?\s+(?:\w+\s+){1,3}unbalance",
    r"jede\s+(?:der\s+\w+\s+)?(?:ausgleichs)?wellen?\s+(?:\w+\s+){1,3}unwucht",
    r"unwucht\s+(?:jeder|einer)\s+(?:der\s+)?(?:ausgleichs)?wellen?",
    r"(?:unbalance|moment)\s+(?:of|for|on)\s+(?:each|one|every|a|the)\s+(?:balance[r]?\s+)?shafts?",
        r"each\s+(?:balance[r]?\s+)?shaft",
    r"balance[r]?\s+shafts?", r"(?:unwucht\s+)?je\s+(?:ausgleichs)?welle", r"ausgleichswellen?",
    r"(?:chaque|ciascun\w*|cada)\s+(?:balance\s+)?(?:shaft|arbre|albero|eje|árbol)",
    r"jede\s+(?:ausgleichs)?welle",
    r"各(?:バランサ)?軸", r"バランサ(?:軸|シャフト)?", r"shaft\s+carries", r"per\s+shaft", r"equating",
    r"gleichheit",
    r"軸[一1]本当たり",
        r"不釣り?合い量",
    r"ejes?\s+contrarrotantes?", r"lanchester\w*", r"ejes?\s+(?:de\s+)?equilibra\w+",
    r"arbres?\s+(?:contrarotatifs?|contra-rotatifs?|d.équilibrage)", r"alberi\s+(?:controrotanti"
                                                                     r"|di\s+equilibra\w+)",
    r"contralberi|alberelli",
    r"(?:each|jede[rs]?|chacun\w*|ciascun\w*|cada\s+un[oa])[^.;=]{0,14}(?:carries|trägt|porte|porta|lleva)[^.;=]{0,30}",
    r"mass\w*[^.;=]{0,24}\b(?:of\s+each|each|de\s+chacun\w*|di\s+ciascun\w*)[^.;=]{0,50}",
)  # fmt: skip
_TWICE = words(
    r"twice|double|second[- ]order|secondary|2\s?ω|2\\omega|zweiter\s+ordnung|2\.\s+ordnung|二次|2次"
    r"|doppelt|lanchester"
)
_FOUR = words(
    r"\bfour\b|in-line[- ]four|\bvier|vierzylinder|(?:quattro|quatre|cuatro)\s+c[iy]l|4\s?気筒"
    r"|4-?zylinder|\b4[- ]cyl|\bI4\b|\bR4\b"
)
_OTHER_SHAFTS = (
    r"\bthree\b|drei|\btwo cylinder|parallel twin|\bsix\b|only one shaft|single shaft"
    r"|einzige welle|both (?:shafts )?together|(?:one|per|each|a) weight|two weights"
)
_OTHER_SHAFTS += r"|total reciprocating|whole engine|all (?:the |four )?pistons|gesamte oszill"
_SINGLE = words(
    r"\bsingle|one[- ]cylinder|einzylinder|単気筒|thumper|mono-?(?:cylindre|cylinder|cilíndrico"
    r"|cilindric)"
)
_ROTATING_ONLY = words(
    r"(?:balanced|counterweight\w*|balances)\s+(?:for\s+)?(?:only\s+)?(?:the\s+|its\s+)?rotating\s+(?:mass(?:es)?|parts)\s+only",
    r"(?:balanced|balances)\s+(?:for\s+)?only\s+(?:for\s+)?(?:the\s+|its\s+)?rotating",
    r"(?:nur|allein)\s+(?:für\s+)?die\s+rotierende", r"回転質量(?:だけ|のみ)",
    r"seulement\s+(?:les|la)\s+rotating",
)  # fmt: skip
"""Words by which a crank's counterweight takes up nothing of what goes to and fro."""
_SECOND = (mass * pin * ratio, mass * pin**2 / rod, mass * pin / slender)
_SIN_HALF, _SIN_OF_HALF = Call("sin", half_sector), Call("sin", sector / 2)
_RING = (outer_radius**3 - inner_radius**3) / (outer_radius**2 - inner_radius**2)
_DISC = density * wall_of_weight
_OTHER_WEIGHT = r"annular|\bring\b|hollow|kreisring|円環|truncated|less the"
_SECTOR = words(r"\bsectors?\b|kreissektor|kreisausschnitt|\bsektor|扇形|secteur")
_SEMI = words(
    r"half[- ]?dis[ck]|half[- ]rounds?|semi-?circ\w+|half[- ]circle|half a dis[ck]|halbkreis\w*|半円"
)
_CENTROID = words(
    r"cent(?:re|er)\s+of\s+(?:gravity|mass)", r"centroid\w*",
        r"distance\s+of\s+the\s+cent\w+\s+of\s+gravity", r"schwerpunkt\w*",
    r"重心", r"図心", r"centre\s+de\s+gravité",
)  # fmt: skip
_BLOCK = words(r"rectang\w+|\bblock\b|\bcuboid|quader|rechteck\w*|直方体")
_STATIC = words(
    r"static\s+moment",
    r"unbalance",
    r"unwucht",
    r"product\s+(?:of\s+)?(?:mass|m)",
    r"moment",
    r"不釣り?合い量?",
)


_TWO = r"\bboth\b|\btwo\b|\bpair\b|beide|\bzwei|両|2枚"
_SECTOR_MOMENTS = (
    2 * _DISC * radius**3 * _SIN_HALF / 3,
    2 * _DISC * (outer_radius**3 - inner_radius**3) * _SIN_HALF / 3,
)
_HALF_DISC_MOMENTS = (
    2 * _DISC * radius**3 / 3,
    2 * _DISC * (outer_radius**3 - inner_radius**3) / 3,
)


COUNTERWEIGHTS: tuple[Quantity, ...] = (
    Quantity(
        "moment of a counterweight", _MOMENT, _WEIGHT,
        ((rotating + share * reciprocating) * pin, (rotating + cylinders / 2 * reciprocating) * pin,
         share * mass * pin, cylinders / 2 * mass * pin),
        ("any", "edit"),
        mistakes=((share * rotating + reciprocating) * pin, (rotating - reciprocating / 2) * pin,
                  (rotating + (1 - share) * reciprocating) * pin,
                          share * (rotating + reciprocating) * pin,
                  (rotating + cylinders * reciprocating) * pin),
        unless=words(_NO_WHOLE_WEIGHT),
        stated=frozenset({"share", "cylinders"}),
    ),
    Quantity(
        "moment of a counterweight that takes up half of the reciprocating mass", _MOMENT, _WEIGHT,
        ((rotating + reciprocating / 2) * pin,), ("any", "edit"),
        mistakes=((rotating + reciprocating) * pin, (rotating / 2 + reciprocating) * pin,
                  (rotating + reciprocating) * pin / 2),
        only=_HALF,
        unless=words(r"\bV\b|V-?twin|\btwo\b|\bzwei|\bboth\b|beide|balance shaft|ausgleichswelle|バランサ"
                     r"|lanchester|each web|je wange|all\s+of\s+the\s+recip|instead"),
    ),
    Quantity(
        "moment of each of two shafts against the second order of four cylinders in line", _MOMENT,
        _SHAFT,
        tuple(size / 2 for size in _SECOND), ("factor", "power", "part"),
        others=(mass * pin,),
        mistakes=tuple(size * n for size in _SECOND for n in (1, 2, 4, Number(Fraction(1, 4)))),
        only=both(_FOUR, _TWICE), unless=words(_OTHER_SHAFTS, r"alternator|generator|lichtmaschine"
                                                              r"|dynamo"), is_told_once=True,
    ),
    Quantity(
        "moment of each of two shafts against the first order of a single cylinder", _MOMENT, _SHAFT,
        (mass * pin / 2,), ("power", "part"), others=(mass * pin / 4,), mistakes=(mass * pin,
        2 * mass * pin, mass * pin / 8),
        only=_SINGLE, unless=words(_OTHER_SHAFTS, _FOUR.pattern, _TWICE.pattern,
            _ROTATING_ONLY.pattern, r"crank (?:itself )?carries"),
        is_told_once=True,
    ),
    Quantity(
        "moment of each of two shafts beside a crank balanced for its rotating mass only", _MOMENT,
        _SHAFT,
        (mass * pin / 2,), ("any", "bare factor", "power", "part"),
        only=both(_SINGLE, _ROTATING_ONLY),
        unless=words(_OTHER_SHAFTS, _FOUR.pattern, _TWICE.pattern), is_told_once=True,
    ),
    Quantity(
        "moment of each of two shafts against the second order of a single cylinder", _MOMENT, _SHAFT,
        tuple(size / 8 for size in _SECOND), ("factor", "power", "part"),
        mistakes=(*(size / n for size in _SECOND for n in (1, 2, 4, 16)), mass * pin / 8),
        only=both(_SINGLE, _TWICE), unless=words(_OTHER_SHAFTS, _FOUR.pattern), is_told_once=True,
        never=_FOUR,
    ),
    Quantity(
        "force of two counter-rotating shafts at twice the crank's speed", letters("F P K"),
        words(r"(?:vertical\s+)?forces\s+add(?:\s+up)?(?:\s+to)?", r"together(?:\s+they\s+give)?",
            r"gemeinsame\s+kraft",
              r"force\s+of\s+(?:both|the\s+two|the\s+pair\s+of)\s+(?:balance[r]?\s+)?shafts?",
              r"合わせた力"),
        (8 * unbalance * omega**2 * Call("cos", Number(Fraction(2)) * crank_angle),
         8 * unbalance * omega**2),
        ("factor", "power", "part"),
        mistakes=tuple(n * unbalance * omega**2 * Call("cos", Number(Fraction(2)) * crank_angle)
                       for n in (1, 2, 4)),
        only=both(_TWICE, words(r"shafts|wellen|軸")), is_told_once=True,
    ),
    Quantity(
        "centrifugal force of one shaft at twice the crank's speed", letters("F P K Z"),
        words(r"centrifugal\s+force", r"fliehkraft", r"遠心力"),
        (4 * mass * arm_of_weight * omega**2, 4 * unbalance * omega**2), ("part",),
        others=(mass * arm_of_weight * omega**2, unbalance * omega**2),
        mistakes=(2 * mass * arm_of_weight * omega**2, 2 * unbalance * omega**2),
        only=both(_SHAFT, _TWICE), is_told_once=True,
    ),
    Quantity(
        "centrifugal force of a shaft at the crank's speed", letters("F P K Z"),
        words(r"(?:its|the)\s+(?:centrifugal\s+)?force\s+(?:has\s+the\s+size|is|of\s+the\s+shaft)"),
        (mass * arm_of_weight * omega**2, unbalance * omega**2), ("power", "part"),
        mistakes=(4 * mass * arm_of_weight * omega**2, 4 * unbalance * omega**2,
        2 * unbalance * omega**2),
        only=both(_SHAFT, words(r"geared 1\s?:\s?1|at (?:the )?(?:crank|engine)(?:shaft)? speed"
                                r"|mit kurbelwellendrehzahl|first[- ]order (?:balance|shaft)")),
        unless=_TWICE, is_told_once=True,
    ),
    Quantity(
        "distance of a half disc's centre of gravity from its straight edge", letters(
            "y e s r h x a z c"),
        _CENTROID, (4 * radius / (3 * PI), 2 * diameter / (3 * PI)), ("factor", "part"),
        mistakes=(3 * radius / (4 * PI), 2 * radius / (3 * PI), radius / 2, 3 * radius / 8),
        only=_SEMI, unless=words(_OTHER_WEIGHT,
        r"hemisphere|halbkugel|\brim\b|wire|\barcs?\b|bogen|弧"), is_told_once=True,
    ),
    Quantity(
        "distance of a sector's centre of gravity from its tip", letters("y e s r h x a z c R"),
        _CENTROID,
        (2 * radius * _SIN_HALF / (3 * half_sector), 4 * radius * _SIN_OF_HALF / (3 * sector)), (
            "factor", "edit", "part"),
        mistakes=(radius * _SIN_HALF / half_sector, 2 * radius * _SIN_OF_HALF / (3 * sector)),
        only=_SECTOR, unless=words(_OTHER_WEIGHT, r"\barcs?\b|bogen|segment|quarter"), is_told_once=True,
    ),
    Quantity(
        "distance of a ring sector's centre of gravity from its centre", letters("y e s r h x a z c R"),
        _CENTROID,
        (2 * _RING * _SIN_HALF / (3 * half_sector), 4 * _RING * _SIN_OF_HALF / (3 * sector)), ("factor",
            "edit", "part"),
        mistakes=(2 * (outer_radius**2 - inner_radius**2) * _SIN_HALF
                  / (3 * half_sector * (outer_radius - inner_radius)),
                  (outer_radius + inner_radius) * _SIN_HALF / (2 * half_sector)),
        only=words(r"annular sector|ring sector|kreisringsektor|ringsektor|sector of a ring|円環扇形"),
        is_told_once=True,
    ),
    Quantity(
        "radius of a block's centre of gravity", letters("r R e s y a rho"), _CENTROID,
        (inner_radius + height / 2, radius + height / 2), ("edit",), others=(radius - height / 2,),
        mistakes=(inner_radius + height, radius + height), only=_BLOCK,
        unless=words(r"outer (?:edge|radius)|middle|außen"), is_told_once=True,
    ),
    Quantity(
        "static moment of a sector", letters("U S Q · D M u"), _STATIC, _SECTOR_MOMENTS,
        ("factor", "edit"),
        mistakes=(_DISC * radius**3 * _SIN_HALF / 3, _DISC * radius**3 * _SIN_HALF),
        only=_SECTOR, unless=words(_OTHER_WEIGHT, _TWO, r"\barcs?\b|bogen|segment|quarter"),
        is_told_once=True,
    ),
    Quantity(
        "static moment of two sectors", letters("U S Q · D M u"), _STATIC,
        tuple(2 * each for each in _SECTOR_MOMENTS), (), only=both(_SECTOR, words(_TWO)),
    ),
    Quantity(
        "static moment of a half disc", letters("U S Q · D M u"), _STATIC, _HALF_DISC_MOMENTS,
        ("factor", "edit", "part"),
        mistakes=(_DISC * radius**3 / 3, _DISC * radius**3,
                  _DISC * (outer_radius**3 - inner_radius**3) / 3),
        only=_SEMI, unless=words(_OTHER_WEIGHT, _TWO, r"\barcs?\b|bogen|segment|quarter"),
        is_told_once=True,
    ),
    Quantity(
        "static moment of two half discs", letters("U S Q · D M u"), _STATIC,
        tuple(2 * each for each in _HALF_DISC_MOMENTS), (), only=both(_SEMI, words(_TWO)),
    ),
    Quantity(
        "mass of a sector", letters("m M G"), words(r"mass", r"masse", r"質量"),
        (_DISC * half_sector * radius**2, _DISC * sector * radius**2 / 2), ("power",),
        only=_SECTOR, unless=words(_OTHER_WEIGHT, _TWO),
    ),
    Quantity(
        "permissible eccentricity by the balance quality", letters("e"),
        words(r"permissible\s+(?:eccentricity|specific\s+unbalance)",
            r"zulässige\w*\s+(?:(?:schwerpunkt|masse?n)?-?\s?exzentrizität|(?:spezifische|bezogene)\s+(?:rest)?unwucht)",
              r"許容(?:偏心量?|比不釣り?合い)"),
        (grade / omega, grade / (2 * PI * rotation), grade / (2 * PI * turn_rate)),
        ("any", "bare factor", "turn", "power"), mistakes=(grade * omega,),
        unless=words(r"\bplanes?\b|ebenen?\b|\bplans?\b|\bpian[oi]\b|\bplanos?\b|面"),
    ),
    Quantity(
        "permissible unbalance", letters("U"),
        words(r"permissible\s+(?:residual\s+)?unbalance", r"zulässige\s+(?:rest)?unwucht",
            r"許容(?:残留)?不釣り?合い"),
        (mass * eccentricity, mass * grade / omega), ("power",), unless=words(
            r"plane|ebene|面|9549|specific"),
    ),
    Quantity(
        "couple of two unbalances opposite to each other", letters("C M K"),
        words(r"(?:unbalance\s+)?(?:couple|moment)(?:\s+unbalance)?", r"(?:unwucht)?moment", r"偶力"),
        (mass * eccentricity * pitch * omega**2, unbalance * pitch * omega**2), ("bare factor", "power",
            "part"),
        mistakes=(mass * eccentricity * pitch * omega**2 / 2, 2 * mass * eccentricity * pitch * omega**2),
        only=both(words(r"opposite|180\s?°|diametral|gegenüber"), words(
            r"unbalance|unwucht|rotor|masses m")),
        unless=words(r"piston|cylinder|kolben|zylinder|crank|shaft whip|middle|each side|from the cent"),
    ),
    Quantity(
        "bob weight", letters("m M W B"), words(r"bob\s?-?weights?", r"ersatzgewicht\w*",
            r"meistergewicht\w*"),
        (rotating + share * reciprocating, rotating + cylinders * share * reciprocating), ("edit",),
        mistakes=(share * rotating + reciprocating, rotating + reciprocating,
        rotating + cylinders * reciprocating),
        unless=words(r"100\s?\\?%\s+of\s+the\s+reciprocating|all\s+(?:of\s+)?the\s+reciprocating"),
        never=_TWO_RODS,
        stated=frozenset({"share", "cylinders"}),
    ),
    Quantity(  # half of what swings with two rods on a pin is that of one of them
        "bob weight of a pin with two rods", letters("m M W B"), words(r"bob\s?-?weights?",
            r"ersatzgewicht\w*", r"meistergewicht\w*"),
        (rotating + reciprocating, rotating + cylinders * share * reciprocating,
         rotating + share * reciprocating), ("edit",),
        mistakes=(share * rotating + reciprocating, rotating + cylinders * reciprocating),
        only=_TWO_RODS,
        is_told_once=True,
        stated=frozenset({"share", "cylinders"}),
    ),
)  # fmt: skip
