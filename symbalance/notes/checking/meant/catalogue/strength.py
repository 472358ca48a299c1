"""Strength of shafts and beams: sections, stresses, bending moments, stiffnesses, equivalent lengths."""

from __future__ import annotations

from symbalance.document.formula import number
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    area,
    bending,
    diameter,
    first_diameter,
    first_length,
    first_rate,
    force,
    height,
    inner,
    inner_radius,
    length,
    letters,
    line_load,
    modulus,
    outer,
    outer_radius,
    own_diameter,
    own_length,
    polar_section,
    pressure,
    radius,
    root,
    second_rate,
    second_section,
    section,
    shear,
    shearing,
    stiffness,
    stress,
    torque,
    wall,
    width,
    words,
    young,
)
from symbalance.text import lazy_patterns as re

HOLLOW = (
    r"hollow|\bbored\b|drilled|\bholes?\b|perforat|bohrung|gelocht|穴|\btubes?\b|tubular"
    r"|\bpipes?\b|annul|\brings?\b|thin[- ]walled|rectang|square (?:section"
    r"|bar|shaft)"
    r"|ellip|hexagon|\bI-beam|\bprofile|hohl|rohr|ringquerschnitt|dünnwandig|rechteck|vierkant"
    r"|quadratisch"
    r"|sechskant|profil|中空|円管|パイプ|矩形|長方形|角材|角形|楕円|薄肉"
)
_NOTCH = (
    r"notch|fillet|concentration|kerb|切り?欠|応力集中|plastic|plastisch|塑性|semicirc|halbkreis|quarter"
)
_SOLID = words(HOLLOW, _NOTCH)
_ANNULUS = outer**4 - inner**4

_SECTION_AXIAL = (
    PI * diameter**4 / 64, PI * radius**4 / 4, PI * (outer**4 - inner**4) / 64,
)  # fmt: skip
_SECTION_POLAR = (
    PI * diameter**4 / 32, PI * radius**4 / 2, PI * (outer**4 - inner**4) / 32,
)  # fmt: skip
_MODULUS_AXIAL = (
    PI * diameter**3 / 32, PI * radius**3 / 4, 2 * section / diameter, section / radius,
    PI * _ANNULUS / (32 * outer),
)  # fmt: skip
_MODULUS_POLAR = (
    PI * diameter**3 / 16, PI * radius**3 / 2, 2 * section / diameter, section / radius,
    PI * _ANNULUS / (16 * outer),
)  # fmt: skip
_BENDING_STRESS = words(
    r"bending\s+stress(?:es)?", r"flexural\s+stress", r"biegespannung", r"曲げ応力",
    r"stress(?:es)?(?:\s+(?:largest|maximum|maximale))?\s+(?:of|in|due\s+to|from|by|en|de)\s+(?:bending"
    r"|fle(?:x|ss)i[oó]ne?)",
)  # fmt: skip
_EQUIVALENT = words(
    r"(?:equivalent|reduced)\s+stress",
    r"von[- ]mises(?:\s+stress)?",
    r"vergleichsspannung",
    r"ミーゼス(?:の)?(?:相当)?応力",
    r"相当応力",
    r"gestaltänderung\w*",
    r"\bGEH\b",
    r"distortion energy",
)
_BY_DISTORTION = words(r"von[- ]mises|distortion|gestaltänderung|ミーゼス|せん断ひずみエネルギ|\bGEH\b")
_POLAR_MOMENT = words(
    r"polar\s+(?:second\s+)?moment(?:\s+of\s+(?:area|inertia|the\s+section))?",
    r"polares?n?\s+(?:flächen)?(?:trägheits)?moment",
    r"(?:polar\w* )?torsions(?:flächen)?trägheitsmoment",
    r"断面二次極モーメント",
    r"極断面二次モーメント",
    r"断面極二次モーメント",
)
_POLAR_AREA_MOMENT = words(
    r"polar\s+second\s+moment(?:\s+of\s+(?:area|the\s+section))?",
    r"polar\s+(?:area\s+moment(?:\s+of\s+inertia)?|moment\s+of\s+area)",
    r"polares?n?\s+flächen(?:trägheits)?moment",
    r"断面二次極モーメント",
    r"極断面二次モーメント",
    r"断面極二次モーメント",
)
"""Polar moments that are of an area by their name: no mass has one."""
_AREA_MOMENT = words(
    r"second\s+moment\s+of\s+area",
    r"area\s+moment(?:\s+of\s+inertia)?",
    r"flächenträgheitsmoment",
    r"flächenmoment 2",
    r"断面二次モーメント",
)
_POLAR_MODULUS = words(
    r"polar\s+section\s+modulus",
    r"section\s+modulus\s+(?:in|for|of)\s+torsion",
    r"(?:torsional|torsion)\s+(?:section\s+)?modulus",
    r"(?:polares?n?|torsions-?)\s*widerstandsmoment",
    r"widerstandsmoment gegen (?:torsion|verdreh\w*)",
    r"極断面係数",
    r"ねじり断面係数",
)
_BENDING_MODULUS = words(
    r"axial\s+section\s+modulus",
    r"section\s+modulus\s+(?:in|for|of)\s+bending",
    r"bending\s+(?:section\s+)?modulus",
    r"section\s+modulus\s+against\s+bending",
    r"(?:axiales?n?|biege-?)\s*widerstandsmoment",
    r"widerstandsmoment gegen biegung",
    r"曲げ(?:に対する|の)?断面係数",
)
_TORSIONAL_RATE = words(
    r"torsional\s+(?:stiffness|spring\s+(?:rate|constant))",
    r"\bstiffness",
    r"spring\s+(?:rate|constant)",
    r"(?:dreh|torsions)(?:feder)?(?:steifigkeit|konstante|rate)",
    r"drehfeder\w*",
    r"federkonstante",
    r"ねじり(?:剛性|こわさ|ばね定数)",
    r"ばね定数",
)
_BORED = words(
    r"hollow|\bbored\b|\bdrilled|tubular|\btubes?\b|hohl|rohr\b|ringquerschnitt|durchbohrt|aufgebohrt"
    r"|中空|円管|パイプ"
)
_JOINT_RATE = words(
    r"(?:combined|total|overall|resultant|resulting|equivalent|effective|common|joint)\s+(?:spring\s+)?"
    r"(?:rate|constant|stiffness)",
    r"(?:gesamt|ersatz)-?(?:feder)?(?:steifigkeit|konstante|rate)",
    r"(?:resultierende|gemeinsame|wirksame)\s+(?:feder)?(?:steifigkeit|konstante|rate)",
    r"(?:合成|等価|全体の|合計の?)(?:の)?(?:ばね定数|剛性)",
    r"(?:raideur|rigidité|stiffness)\s+(?:équivalente|totale|résultante)",
    r"(?:rigidezza|costante|stiffness)\s+(?:equivalente|totale|complessiva|risultante)",
    r"(?:rigidez|constante|stiffness)\s+(?:equivalente|total|resultante)",
)  # fmt: skip
"""The stiffness of several springs together."""
_SAME_FORCE = (
    r"(?:carry|carries|bear|transmit|take|feel|see)\s+the\s+same\s+(?:force|load)|same\s+(?:force|load)\s+(?:acts|passes|goes)"
    r"|deflections?\s+(?:add|are\s+added|sum)|(?:dieselbe|die\s+gleiche)\s+kraft|federwege?\s+addieren|durchsenkungen\s+addieren"
    r"|たわみが(?:加わる|足し合わさる|足される)|同じ力|même\s+(?:force|effort)|stessa\s+forza|misma\s+fuerza"
)
"""Words by which the same force goes through two springs, one behind the other."""
_SAME_WAY = (
    r"(?:compressed|deflected|stretched|moved?)\s+by\s+the\s+same\s+(?:amount|distance|length|travel|deflection)"
    r"|same\s+(?:deflection|travel|compression)|(?:forces|loads)\s+(?:add|are\s+added)|(?:denselben|den\s+gleichen)\s+(?:feder)?weg"
    r"|gleichen?\s+(?:feder)?wege?\s|federkräfte\s+addieren|kräfte\s+addieren|同じ(?:だけ(?:縮|たわ)|たわみ|変位)"
    r"|même\s+(?:course|flèche|déplacement|déformation|allongement)|stess[ao]\s+(?:spostamento|corsa|deformazione|freccia|stroke)"
    r"|mism[ao]\s+(?:desplazamiento|carrera|deformación|flecha|stroke)|(?:same|stessa|misma|même)\s+(?:deflection|displacement|stroke)"
)
"""Words by which two springs are shortened alike, one beside or within the other."""
_SERIES = words(
    _SAME_FORCE, r"(?:l'un|une|un)e?\s+derrière\s+l'autre", r"\ben\s+série\b",
    r"\bin\s+serie\b", r"\ben\s+serie\b",
    r"un[oa]\s+dietro\s+l'altr[oa]", r"un[oa]\s+(?:detrás\s+de|tras)\s+otr[oa]",
    r"(?:springs|connected|shafts|arranged|rates)\s+in\s+series",
    r"one\s+(?:behind|after)\s+the\s+other", r"end\s+to\s+end", r"series\s+(?:stiffness|connection)",
    r"reihenschaltung", r"in\s+reihe(?:\s+geschaltet\w*)?", r"hintereinander\w*",
    r"直列(?:ばね|接続|結合)?",
)  # fmt: skip
_PARALLEL = words(
    _SAME_WAY, r"ineinander\s?(?:gesteckt\w*|geschachtelt\w*"
               r"|liegen\w*)?", r"nested", r"concentric\w*\s+springs",
    r"one\s+(?:inside|within)\s+(?:of\s+)?the\s+other", r"konzentrische\w*\s+federn",
    r"入れ子", r"同心", r"二重(?:ばね|スプリング)",
    r"(?:l'un|une|un)e?\s+(?:dans"
    r"|à\s+côté\s+de)\s+l'autre", r"\ben\s+parallèle\b",
    r"\bin\s+parallelo\b", r"\ben\s+paralelo\b",
    r"un[oa]\s+(?:dentro|accanto)\s+(?:a\s+)?(?:l'|al)?altr[oa]", r"un[oa]\s+(?:dentro\s+de"
        r"|junto\s+a)\s+(?:la\s+)?otr[oa]",
    r"(?:springs|connected|shafts|arranged|rates)\s+in\s+parallel",
    r"parallel\s+(?:springs|stiffness|connection)",
    r"side\s+by\s+side", r"one\s+inside\s+the\s+other", r"nebeneinander\w*",
    r"parallelschaltung", r"parallel\s+geschaltet\w*", r"並列(?:ばね|接続|結合)?",
)  # fmt: skip
_NO_ANNULUS = words(
    r"rectang|square (?:section|bar|shaft)|ellip|hexagon|thin[- ]walled|dünnwandig|薄肉|rechteck|vierkant"
    r"|sechskant|profil|\bsolid|\bvoll|中実", _NOTCH,
)  # fmt: skip
_RECTANGLE = words(
    r"rectang|rechteck|長方形|矩形|角材|角形断面|flat bar|flachstab"
    r"|(?:width|breadth)\b[^.;]{0,60}\b(?:thickness|height|depth)|thickness\b[^.;]{0,60}\b(?:width"
    r"|breadth)"
    r"|\bwide\b[^.;]{0,40}\b(?:thick|high|deep)|\bbreit\b[^.;]{0,40}\b(?:dick|hoch)"
    r"|breite\b[^.;]{0,60}(?:höhe|dicke)|幅[^。]{0,30}(?:高さ|厚さ)"
)
_NOT_RECTANGLE = (
    r"hollow|hohl|中空|\bround|circular|kreis|\brund|円形|丸棒|torsion|polar|composite|profil"
)
_CANTILEVER = words(
    r"cantilever|kragarm|kragträger|freiträger|einseitig eingespannt|片持ち?|overhang|overhung|fliegend"
    r"|(?:built[- ]in|clamped|fixed) at (?:one|the other) end"
)
_SUPPORTED = words(
    r"simply[- ]supported|freely supported|on two (?:supports|bearings)|between two (?:supports|bearings)"
    r"|(?:hinged|pinned|jointed) at (?:both|its) ends|(?:beidseitig|beiderseits) (?:gelenkig"
    r"|frei drehbar) gelagert"
    r"|supported at both"
    r" ends|zwei (?:stützen|lagern?)|beidseitig gelagert|beiderseits gelagert|zweifach gelagert"
    r"|単純支持|両端支持|(?:sur|on|su|sobre) (?:deux|two|due|dos) (?:appuis|appoggi|apoyos)"
    r"|simplemente apoyad\w+"
    r"|appoggiat\w (?:agli|alle) estrem\w+"
)
_FIXED = words(
    r"fixed at both ends|built[- ]in at both|clamped at both|beidseitig eingespannt|両端固定"
    r"|(?:encastrée?|fixed) (?:aux|at) (?:deux|two) extrémités|incastrat\w (?:agli"
    r"|alle) estrem\w+|empotrad\w (?:en|por) (?:ambos|los dos)"
)
_MIDDLE = words(
    r"middle|mid-?span|midway|half[- ]?way|cent(?:re|er)|central(?:ly)?|mittig|\bmitte|中央"
    r"|\bmilieu|\bmezzo|\bcentro\b"
)
_END_LOAD = words(r"\bend\b|\btip\b|\bende\b|先端|自由端|free end|an der spitze")
_UNIFORM = words(r"uniform|evenly|gleichm|streckenlast|gleichstreckenlast|等分布|distributed|verteilt")
_OTHER_BEAM = words(
    r"fixed at both|built[- ]in at both|clamped at both|beidseitig eingespannt|両端固定"
    r"|encastr|incastrat|empotrad|one (?:end )?fixed|propped"
    r"|quarter|viertel|at a distance|im abstand|continuous|durchlauf|three bearings|drei lager"
)
_BENDING_MOMENT = words(
    r"(?:largest |greatest |maximum |max\. )?bending\s+moment", r"(?:größte[sn]? )?biegemoment",
    r"(?:最大)?曲げモーメント",
)  # fmt: skip
_DEFLECTION = words(r"deflection", r"durchbiegung", r"たわみ量?")
_BENDING_RATE = words(
    r"(?:bending |lateral |transverse )?stiffness", r"spring\s+(?:rate|constant)",
    r"biegefedersteifigkeit",
    r"biegesteifigkeit", r"feder(?:konstante|steifigkeit|rate)", r"(?:曲げ)?ばね定数",
)  # fmt: skip


def both(*patterns: re.Pattern[str]) -> re.Pattern[str]:
    """Return a pattern for texts in which each of some patterns is."""
    ahead = "".join(rf"(?=.*?(?:{each.pattern}))" for each in patterns)
    return re.compile(rf"\A{ahead}", re.IGNORECASE | re.DOTALL)


_ABOUT_DIAMETER = words(
    r"about\s+(?:a|its|the|any)\s+diameter", r"bezogen auf (?:einen"
                                             r"|den) durchmesser", r"\baxial", r"直径に関する",
    r"直径(?:軸)?まわり", r"\bbending", r"biegung", r"曲げ",
)  # fmt: skip


STRENGTH: tuple[Quantity, ...] = (
    Quantity(
        "torsional stress of a round shaft", letters("tau"),
        words(r"(?:(?:largest|greatest|maximum|max\.?)\s+)?(?:torsion|twist|shear)\w*\s+stress(?:es)?",
              r"(?:größte\s+|maximale\s+)?(?:torsions|schub|verdreh)spannung",
              r"(?:最大)?(?:ねじり|せん断|剪断)応力"),
        (16 * torque / (PI * diameter**3), 2 * torque / (PI * radius**3), torque / modulus,
         torque * diameter / (2 * section), torque * radius / section,
         16 * torque * outer / (PI * _ANNULUS)),
        mistakes=(PI * diameter**3 / (16 * torque),),
        context=words(r"torsion|twist|verdreh|drill"
        r"|ねじり"), unless=words(HOLLOW, _NOTCH, r"\bspring|feder|ばね"),
    ),
    Quantity(
        "bending stress of a round bar", letters("sigma"),
        _BENDING_STRESS,
        (32 * bending / (PI * diameter**3), 4 * bending / (PI * radius**3), bending / modulus,
         bending * diameter / (2 * section), bending * radius / section,
         32 * bending * outer / (PI * _ANNULUS)),
        context=words(r"\bbending", r"\bbiegung", r"auf biegung", r"曲げ"),
        unless=words(HOLLOW, _NOTCH, r"equivalent|vergleich|相当|combined|von mises|tresca"),
    ),
    Quantity(
        "equivalent stress by von Mises", letters("sigma"),
        _EQUIVALENT,
        (root(stress**2 + 3 * shearing**2),), slips=("root", "term"),
        others=(root(stress**2 + 4 * shearing**2),
                stress / 2 + root(stress**2 + 4 * shearing**2) / 2),
        unless=words(r"tresca|guest|maximum shear|schubspannungshypothese|最大せん断|rankine"
        r"|normalspannungs"
                      r"|トレスカ|\bSH\b|principal|haupt|主応力|saint.venant|bach|anstreng"),
    ),
    Quantity(
        "polar second moment of area of a round section", letters("J I"),
        _POLAR_MOMENT,
        _SECTION_POLAR, context=words(r"torsion|twist|verdreh|drehschwing|ねじり"),
        unless=words(HOLLOW, _NOTCH, r"\bmass\b|massenträg|flywheel"
        r"|schwungrad"), indices=letters("p t P T pol"),
    ),
    Quantity(
        "polar second moment of area of a round section", letters("J I"),
        _POLAR_AREA_MOMENT, _SECTION_POLAR, unless=words(HOLLOW, _NOTCH),
    ),
    Quantity(
        "axial second moment of area of a round section", letters("I J"),
        words(r"axial\s+(?:second\s+)?moment(?:\s+of\s+(?:area|inertia))?",
        r"(?:axiales?n?|äquatoriales?n?)\s+"
               r"(?:flächen)?(?:trägheits)?moment", r"second moment of area (?:for|in) bending",
               r"曲げの(?:中心軸に対する)?断面(?:二次|2次)モーメント",
               r"(?:second\s+)?moment of (?:area|inertia)\s+about (?:a|its|the) diameter"),
        _SECTION_AXIAL, context=words(r"bending|biegung|曲げ"),
        unless=words(HOLLOW, _NOTCH, r"polar|極|\bmass"
        r"|massenträg"), indices=letters("a b x y z ax eq"),
    ),
    Quantity(
        "second moment of area of a round section", letters("I J"),
        _AREA_MOMENT,
        _SECTION_AXIAL, others=_SECTION_POLAR,
        unless=words(HOLLOW, _NOTCH, r"polar|極|torsion|ねじり"),
    ),
    Quantity(
        "polar section modulus of a round section", letters("W Z"),
        _POLAR_MODULUS,
        _MODULUS_POLAR, unless=_SOLID, context=words(r"torsion|ねじり"),
        indices=letters("p t P T pol"),
    ),
    Quantity(
        "section modulus of a round section in bending", letters("W Z S"),
        _BENDING_MODULUS,
        _MODULUS_AXIAL, context=words(r"bending|biegung|曲げ"),
        unless=words(HOLLOW, _NOTCH, r"polar|torsion|極|ねじり"), indices=letters("a b x y z ax"),
    ),
    Quantity(
        "section modulus of a round section", letters("W Z S"),
        words(r"section\s+modulus", r"widerstandsmoment", r"断面係数"),
        _MODULUS_AXIAL, others=_MODULUS_POLAR, unless=words(HOLLOW, _NOTCH, r"polar|torsion|極"
        r"|ねじり"),
    ),
    Quantity(
        "torsional stiffness of a round shaft", letters("c k C K"),
        _TORSIONAL_RATE,
        (shear * section / length, PI * shear * diameter**4 / (32 * length),
         PI * shear * radius**4 / (2 * length)),
        mistakes=(young * polar_section / length,),
        context=words(r"torsion|drehschwing|ねじり"),
        unless=words(HOLLOW, r"\bhelical|coil|schraubenfeder|コイル|parallel|series|reihe"
        r"|hintereinander|並列|直列"
                      r"|bending|biegung|曲げ"),
    ),
    Quantity(
        "angle of twist of a round shaft", letters("phi varphi theta vartheta psi"),
        words(r"angle\s+of\s+twist", r"twist\s+angle", r"ends\s+(?:rotate"
            r"|turn)\s+against\s+each\s+other(?:\s+by)?", r"(?<!of )\btwists?\b(?:\s+(?:of|by)\b)?",
        r"verdreh(?:ungs)?winkel", r"drillwinkel", r"verdrehung", r"ねじれ角"),
        (torque * length / (shear * section), 32 * torque * length / (PI * shear * diameter**4),
         2 * torque * length / (PI * shear * radius**4), torque / stiffness),
        mistakes=(torque * length / (young * polar_section),),
        unless=words(HOLLOW, r"(?<!twist )(?<!angle )per\s+(?:unit\s+)?length(?! is)|je länge|比ねじれ"
            r"|単位長"),
    ),
    Quantity(
        "polar second moment of area of a hollow round section", letters("J I"), _POLAR_MOMENT,
        (PI * _ANNULUS / 32, PI * (outer_radius**4 - inner_radius**4) / 2), ("factor", "power", "edit"),
        context=words(r"torsion|verdreh|ねじり"), only=_BORED, unless=_NO_ANNULUS,
        indices=letters("p t P T pol"),
    ),
    Quantity(
        "second moment of area of a hollow round section", letters("I J"), _AREA_MOMENT,
        (PI * _ANNULUS / 64, PI * (outer_radius**4 - inner_radius**4) / 4), ("factor", "power", "edit"),
        others=(PI * _ANNULUS / 32, PI * (outer_radius**4 - inner_radius**4) / 2),
        only=_BORED, unless=words(_NO_ANNULUS.pattern, _ABOUT_DIAMETER.pattern, r"polar|極|torsion"
                                                                                r"|ねじり"),
    ),
    Quantity(
        "polar section modulus of a hollow round section", letters("W Z"), _POLAR_MODULUS,
        (PI * _ANNULUS / (16 * outer),), ("factor", "power", "edit"),
        mistakes=(PI * (outer**3 - inner**3) / 16, PI * _ANNULUS / (16 * inner)),
        only=_BORED, unless=_NO_ANNULUS, context=_BORED, indices=letters("p t P T pol"),
    ),
    Quantity(
        "section modulus of a hollow round section in bending", letters("W Z S"),
        words(_BENDING_MODULUS.pattern, r"section\s+modulus", r"widerstandsmoment", r"断面係数"),
        (PI * _ANNULUS / (32 * outer),), ("factor", "power", "edit"),
        others=(PI * _ANNULUS / (16 * outer),),
        mistakes=(PI * (outer**3 - inner**3) / 16, PI * (outer**3 - inner**3) / 32,
        PI * _ANNULUS / (32 * inner)),
        only=_BORED, unless=words(_NO_ANNULUS.pattern, r"polar|極|torsion|ねじり"),
        context=_BORED, indices=letters("b x y z ax"),
    ),
    Quantity(
        "second moment of area of a rectangle", letters("I J"), _AREA_MOMENT,
        (width * height**3 / 12,), ("factor", "power"),
        others=(height * width**3 / 12, width * height**3 / 3, height * width**3 / 3),
        only=_RECTANGLE, is_told_once=True, unless=words(_NOT_RECTANGLE, r"\bbase\b|grundlinie|底辺"),
    ),
    Quantity(
        "section modulus of a rectangle", letters("W Z S"),
        words(_BENDING_MODULUS.pattern, r"section\s+modulus", r"widerstandsmoment", r"断面係数"),
        (width * height**2 / 6,), ("factor", "power"), others=(height * width**2 / 6,),
        only=_RECTANGLE, is_told_once=True, unless=words(_NOT_RECTANGLE, r"plastic|plastisch|塑性"),
    ),
    Quantity(
        "bending stress of a rectangular bar", letters("sigma"), _BENDING_STRESS,
        (6 * bending / (width * height**2),), ("factor", "power"),
        others=(6 * bending / (height * width**2),),
        only=_RECTANGLE, is_told_once=True, unless=words(_NOT_RECTANGLE,
        r"equivalent|vergleich|相当|plasti"),
    ),
    Quantity(
        "equivalent stress by von Mises's hypothesis", letters("sigma"), _EQUIVALENT,
        (root(stress**2 + 3 * shearing**2),), ("root", "term"),
        mistakes=(*(root(stress**2 + n * shearing**2) for n in (4, 2, 1)),
                root(3 * stress**2 + shearing**2),
                  stress + root(number(3)) * shearing, stress + 3 * shearing),
        only=_BY_DISTORTION,
        unless=words(r"tresca|guest|maximum shear|schubspannungshypothese|最大せん断|rankine"
                     r"|normalspannungs|トレスカ|\bSH\b|saint.venant|\bbach"),
    ),
    Quantity(
        "equivalent stress by Tresca", letters("sigma"),
        words(_EQUIVALENT.pattern, r"tresca(?:\s+stress)?", r"トレスカ(?:の)?(?:相当)?応力"),
        (root(stress**2 + 4 * shearing**2),), ("root", "term"),
        mistakes=(root(stress**2 + 3 * shearing**2), root(stress**2 + 2 * shearing**2)),
        others=(root(stress**2 + 4 * shearing**2) / 2, root(stress**2 / 4 + shearing**2)),
        only=words(r"tresca|guest\b|maximum shear(?:ing)? stress|schubspannungshypothese"
        r"|最大せん断応力説|トレスカ"),
        unless=words(r"von mises|gestaltänderung|distortion|ミーゼス|rankine|normalspannungs"),
    ),
    Quantity(
        "equivalent twisting moment", letters("T M"),
        words(r"equivalent\s+(?:twisting|torsional)\s+moment", r"equivalent\s+torque",
              r"相当ねじりモーメント"),
        (root(bending**2 + torque**2),), ("root", "term"),
        mistakes=(bending + torque,), others=(root(bending**2 + 3 * torque**2 / 4),
                                              root(4 * bending**2 / 3 + torque**2)),
    ),
    Quantity(
        "equivalent bending moment", letters("M"),
        words(r"equivalent\s+bending\s+moment", r"ideelles?\s+biegemoment", r"相当曲げモーメント",
              r"(?:one|shaft|bar)\s+in\s+pure\s+bending\s+(?:with|by|under)\s+(?:the|a)\s+moment",
              r"moment\s+(?:fléchissant|of\s+flexion|de\s+flexion)\s+(?:équivalent|idéal)",
              r"momento\s+flettente\s+(?:ideale|equivalente)", r"momento\s+flector\s+equivalente"),
        ((bending + root(bending**2 + torque**2)) / 2,), ("factor", "edit"),
        mistakes=(root(bending**2 + torque**2) / 2, (torque + root(bending**2 + torque**2)) / 2,
                  (bending + root(bending**2 + 4 * torque**2)) / 2),
        others=(root(bending**2 + 3 * torque**2 / 4), root(bending**2 + torque**2),
                3 * bending / 8 + 5 * root(bending**2 + torque**2) / 8),
        unless=words(r"von mises|gestaltänderung|distortion|ミーゼス"),
    ),
    Quantity(
        "direct stress in a round bar", letters("sigma"),
        words(r"(?:tensile|compressive|direct|axial)\s+stress", r"(?:zug|druck)spannung",
              r"(?:引張り?|圧縮|引っ張り)応力"),
        (4 * force / (PI * diameter**2), force / area, force / (PI * radius**2)),
        unless=words(HOLLOW, _NOTCH, r"bending|biege|曲げ|thread|gewinde|ねじ|bolts|schrauben|thermal"),
    ),
    Quantity(
        "hoop stress of a thin cylinder", letters("sigma"),
        words(r"hoop\s+stress", r"circumferential\s+stress", r"(?:umfangs|tangential)spannung",
              r"(?:フープ|円周|周方向)応力"),
        (pressure * diameter / (2 * wall), pressure * radius / wall), ("power",),
        mistakes=(pressure * diameter / (4 * wall), pressure * diameter / wall,
                  2 * pressure * diameter / wall, pressure * wall / (2 * diameter),
                  pressure * radius / (2 * wall)),
        unless=words(r"spher|kugel|球|thick-walled|dickwandig|厚肉|rotating|joint|efficiency"
        r"|centrifugal"),
    ),
    Quantity(
        "hoop stress at the bore of a thick cylinder", letters("sigma"),
        words(r"hoop\s+stress", r"circumferential\s+stress", r"(?:umfangs|tangential)spannung",
              r"tensi[oó]n\s+(?:circunferencial|tangencial)", r"tensione\s+circonferenziale",
              r"contrainte\s+(?:circonférentielle|orthoradiale|tangentielle)",
              r"stress\s+(?:circonférentielle|orthoradiale|tangentielle|circonferenziale"
              r"|circunferencial)",
              r"(?:フープ|円周|周方向)応力"),
        (pressure * (outer_radius**2 + inner_radius**2) / (outer_radius**2 - inner_radius**2),
         pressure * (outer**2 + inner**2) / (outer**2 - inner**2)),
        ("edit",),
        mistakes=tuple(
            each
            for a, b in ((inner_radius, outer_radius), (inner, outer))
            for each in (
                pressure * (b**2 - a**2) / (b**2 + a**2), 2 * pressure * a**2 / (b**2 - a**2),
                pressure * (b + a) / (b - a), pressure * b**2 / (b**2 - a**2),
                -pressure * (b**2 + a**2) / (b**2 - a**2),
            )
        ),
        only=both(words(r"thick[- ](?:walled\s+)?(?:cylinder|tube|pipe|wall)|thick\s+cylinder|lamé"
                        r"|dickwandig|厚肉"
                        r"|pared gruesa|parete spessa|paroi épaisse|épais"),
                  words(r"\binner|\binside|\bbore\b|\binterior|intérieur|interna?\b|innen|内面|内壁")),
        unless=words(r"outer\s+(?:surface|fibre|wall)|at\s+the\s+outside|außen(?:seite|wand|rand)"
            r"|external\s+pressure"
                     r"|außendruck|shrink|schrump|外面|外圧|radial\s+stress|\bmean\b|average|mittlere"),
        is_told_once=True,
    ),
    Quantity(
        "bending stress of a plate bent across its thickness", letters("sigma"),
        words(_BENDING_STRESS.pattern, r"\bstress(?:es)?", r"spannung", r"応力", r"contrainte",
                r"tensione"),
        (6 * bending / (width * wall**2), bending * wall / 2 / (width * wall**3 / 12)), ("factor",
                "power"),
        mistakes=(6 * bending / (width**2 * wall), bending / (6 * width * wall**2)),
        only=both(_RECTANGLE, words(
            r"(?:direction|sense)\s+of\s+(?:its|the)\s+thickness|across\s+(?:its|the)\s+thickness"
            r"|parallel\s+to\s+the\s+"
            r"(?:side|width|breadth)|flat-?wise|in\s+dickenrichtung|über\s+die\s+dicke|厚さ方向")),
        is_told_once=True, unless=words(_NOT_RECTANGLE, r"equivalent|vergleich|相当|plasti"
                                                        r"|edge-?wise|hochkant"),
    ),
    Quantity(
        "axial second moment of area of a hollow round section", letters("I J"), _AREA_MOMENT,
        (PI * _ANNULUS / 64, PI * (outer_radius**4 - inner_radius**4) / 4), ("factor", "power", "edit"),
        mistakes=(PI * _ANNULUS / 32,),
        only=both(_BORED, _ABOUT_DIAMETER),
        unless=words(_NO_ANNULUS.pattern, r"polar|極|torsion|ねじり"),
    ),
    Quantity(
        "bending moment of a cantilever with a load at its end", letters("M"), _BENDING_MOMENT,
        (force * length,), ("bare factor", "power"), only=both(_CANTILEVER, _END_LOAD),
        unless=words(_OTHER_BEAM.pattern, r"uniform|gleichm|streckenlast|等分布|\bmid|\bhalf|\bhalb"
        r"|middle|mitte|中央"),
    ),
    Quantity(
        "bending moment of a cantilever with a uniform load", letters("M"), _BENDING_MOMENT,
        (line_load * length**2 / 2, force * length / 2), only=both(_CANTILEVER, _UNIFORM),
        unless=words(_OTHER_BEAM.pattern, r"triang|dreieck|三角"),
    ),
    Quantity(
        "bending moment of a simply supported beam loaded in the middle", letters("M"), _BENDING_MOMENT,
        (force * length / 4,), only=both(_SUPPORTED, _MIDDLE),
        unless=words(r"reaction|auflager|反力|\bhalf\b|\bhalb|半分|each bearing",
        _OTHER_BEAM.pattern, _UNIFORM.pattern, r"clamped|built[- ]in|\bfixed|eingespannt|固定"
        r"|cantilever|kragarm|einseitig|片持ち?"),
    ),
    Quantity(
        "bending moment of a simply supported beam with a uniform load", letters("M"), _BENDING_MOMENT,
        (line_load * length**2 / 8, force * length / 8), only=both(_SUPPORTED, _UNIFORM),
        unless=words(_OTHER_BEAM.pattern, r"clamped|built[- ]in|\bfixed|eingespannt|固定|cantilever"
        r"|kragarm|triang|dreieck|三角|片持ち?"),
    ),
    Quantity(
        "bending moment of a beam fixed at both ends and loaded in the middle", letters("M"),
        _BENDING_MOMENT, (force * length / 8,), only=both(_FIXED, _MIDDLE),
        unless=words(_UNIFORM.pattern, _SUPPORTED.pattern),
    ),
    Quantity(
        "deflection of a cantilever with a load at its end", letters("f w y delta v"), _DEFLECTION,
        (force * length**3 / (3 * young * section),), only=both(_CANTILEVER, _END_LOAD),
        unless=words(_OTHER_BEAM.pattern, _UNIFORM.pattern, r"\bmid|\bhalf|\bhalb|middle|mitte|中央"),
    ),
    Quantity(
        "deflection of a simply supported beam loaded in the middle", letters("f w y delta v"),
        _DEFLECTION, (force * length**3 / (48 * young * section),), only=both(_SUPPORTED, _MIDDLE),
        unless=words(_OTHER_BEAM.pattern, _UNIFORM.pattern, r"clamped|built[- ]in|\bfixed|eingespannt"
        r"|固定|cantilever|kragarm|片持ち?"),
    ),
    Quantity(
        "bending stiffness of a simply supported shaft in its middle", letters("c k C K"), _BENDING_RATE,
        (48 * young * section / length**3,), only=both(_SUPPORTED, _MIDDLE),
        unless=words(_OTHER_BEAM.pattern, _UNIFORM.pattern, r"clamped|built[- ]in|\bfixed|eingespannt"
        r"|固定|cantilever|kragarm|片持ち?"),
    ),
    Quantity(
        "bending stiffness of a cantilever at its end", letters("c k C K"), _BENDING_RATE,
        (3 * young * section / length**3,), only=_CANTILEVER,
        unless=words(_OTHER_BEAM.pattern, _UNIFORM.pattern, r"middle|mitte|中央|parallel|two"),
    ),
    Quantity(
        "bearing pressure", letters("p"),
        words(r"(?:(?:mean|average)\s+)?bearing\s+pressure",
        r"(?:(?:mean|average)\s+)?pressure\s+(?:in|on|of)\s+(?:the\s+|a\s+)?(?:\w+\s+)?bearing",
              r"specific\s+(?:bearing\s+)?load", r"(?:mittlere\s+)?flächenpressung",
              r"(?:mittlerer\s+)?lagerdruck",
              r"lagerpressung", r"(?:平均)?(?:軸受)?面圧", r"(?:平均)?軸受圧力"),
        (force / (diameter * width), force / (diameter * length), force / (2 * radius * width)),
        ("power",), mistakes=(force / (PI * diameter * width), force / (PI * diameter * length),
                              4 * force / (PI * diameter**2)),
        unless=words(r"hertz|ヘルツ|line contact|linienberührung|thrust|axial|spurlager|スラスト|collar"),
    ),
    Quantity(
        "torsional stiffness of a hollow shaft", letters("c k C K"), _TORSIONAL_RATE,
        (PI * shear * _ANNULUS / (32 * length),), ("factor", "power", "edit"),
        only=_BORED, unless=words(_NO_ANNULUS.pattern, r"bending|biegung|parallel|series|reihe"),
    ),
    Quantity(
        "stiffness of springs in series", letters("c k C K"),
        words(_TORSIONAL_RATE.pattern, _BENDING_RATE.pattern, _SERIES.pattern, _JOINT_RATE.pattern),
        (first_rate * second_rate / (first_rate + second_rate), 1 / (1 / first_rate + 1 / second_rate)),
        ("bare factor", "edit"),
        mistakes=(first_rate + second_rate, 1 / first_rate + 1 / second_rate,
                  (first_rate + second_rate) / (first_rate * second_rate)),
        only=_SERIES, unless=words(
            r"parall|並列|complian|nachgiebig|flexibil|side\s+by\s+side|nebeneinander|ineinander|nested|入れ子|three|drei",
            _SAME_WAY),
    ),
    Quantity(
        "stiffness of springs in parallel", letters("c k C K"),
        words(_TORSIONAL_RATE.pattern, _BENDING_RATE.pattern, _PARALLEL.pattern, _JOINT_RATE.pattern),
        (first_rate + second_rate,), ("bare factor",),
        mistakes=(first_rate * second_rate / (first_rate + second_rate), first_rate - second_rate,
                  1 / (1 / first_rate + 1 / second_rate), (first_rate + second_rate) / 2,
                  root(first_rate * second_rate), root(first_rate**2 + second_rate**2)),
        only=_PARALLEL, unless=words(
            r"series|\bserie\b|série|reihe|hintereinander|直列|complian|nachgiebig|flexibil|three"
            r"|drei|average|mean\b", _SAME_FORCE),
    ),
    Quantity(
        "equivalent length of a shaft", letters("l L ell"),
        words(r"(?:equivalent|reduced)\s+length", r"reduzierte\s+(?:wellen)?länge", r"ersatzlänge",
              r"(?:相当|換算|等価)(?:軸)?長さ?",
              r"twists?\s+as\s+(?:much|far)\s+as\s+(?:an?|the)\s[^.]{0,80}\blength",
              r"same\s+(?:angle\s+of\s+)?twist\s[^.]{0,80}\blength",
              r"verdreht\s+sich\s+(?:eben)?so\s+(?:stark|viel|weit)\s+wie\s[^.]{0,80}länge",
              r"ebenso\s+nachgiebig\w*\s[^.]{0,80}länge", r"(?:同じ|等しい)ねじれ[^。]{0,40}長さ"),
        (own_length * (diameter / own_diameter) ** 4, length * (diameter / own_diameter) ** 4,
         first_length + own_length * (first_diameter / own_diameter) ** 4,
         own_length * section / second_section, length * section / second_section),
        ("power", "edit", "exchange"),
        together=(("own_length", "own_diameter"), ("first_length", "first_diameter"), ("length",
        "own_diameter"),
                  ("length", "second_section"),
                  ("own_length", "second_section")),
        unless=words(r"pendul|pendel|振り子|buckling|knick|座屈|bending|biegung|曲げ"),
    ),
)  # fmt: skip
