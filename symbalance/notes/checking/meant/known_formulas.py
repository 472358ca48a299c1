"""Standard formulas of engines and shafts, by the words that name them: the bending stress is M/W.

What is here is elementary and can be derived; `tests/independent/test_known_formulas.py` does so for each
formula by a route of its own (integrals over the section, eigenvalues, the path of a piston). Letters in
the formulas are the names of roles; `ROLES` tells which letters stand for a role on most pages, and which
words name it.

    phrases     name the quantity in the sentence of the formula
    context     words of the sentence or its heading, with which the usual letter is enough
    others      formulas that the same words may mean: never refuted
    unless      words of the paragraph with which another formula may be right
    slips       what one may get wrong: "factor" (of a formula with a number), "bare factor", "power",
                "root", "turn" (2π), "minus", "term"
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from symbalance.document.formula import Call, Constant, Formula, Name


@dataclass(frozen=True, slots=True)
class Role:
    """What a letter in a known formula stands for: its usual letters, and the words that name it."""

    letters: frozenset[str]
    words: re.Pattern[str]


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity with its standard formulas, in roles."""

    name: str
    letters: frozenset[str]
    """The usual letters of the quantity itself."""
    phrases: re.Pattern[str]
    formulas: tuple[Formula, ...]
    slips: tuple[str, ...] = ("factor", "power")
    context: re.Pattern[str] | None = None
    others: tuple[Formula, ...] = ()
    unless: re.Pattern[str] | None = None
    indices: frozenset[str] = field(default_factory=frozenset)
    """Subscripts of which one has to stand at the letter where only the context names the quantity."""
    only: re.Pattern[str] | None = None
    """Words without which the formula is compared but never refuted."""


def _words(*patterns: str) -> re.Pattern[str]:
    return re.compile("|".join(patterns), re.IGNORECASE)


def _letters(text: str) -> frozenset[str]:
    return frozenset(text.split())


def _sqrt(node: Formula) -> Formula:
    return Call("sqrt", node)


PI = Constant("pi")
_ROLE_ENTRIES = (
    ("diameter", "d D", r"diameters?|durchmessers?|(?<!半)径|\bbore|bohrung|ボア"),
    ("outer", "d D", r"outer|outside|external|außen(?:durchmesser)?|aussendurchmesser|外径"),
    ("inner", "d D", r"inner|inside|internal|innen(?:durchmesser)?|内径|\bbore"),
    ("radius", "r R", r"radi(?:us|i)|halbmesser|半径|crank throw"),
    ("crank", "r R", r"radi(?:us|i)|halbmesser|半径|crank throw|crank length"),
    ("bending", "M", r"(?<!trägheits)(?<!widerstands)(?<!flächen)moments?(?! of)|曲げモーメント"),
    ("torque", "T M", r"(?<!trägheits)(?<!widerstands)(?<!flächen)moments?(?! of)|torques?|トルク"
     r"|ねじりモーメント"),
    ("force", "F P", r"forces?|kraft|力"),
    ("pressure", "p P", r"pressure|druck|圧力?"),
    ("area", "A S F", r"area|fläche|面積"),
    ("modulus", "W Z S", r"section modulus|widerstandsmoment|断面係数"),
    ("section", "I J", r"second moment|moment of (?:inertia|area)|polar moment|trägheitsmoment"
     r"|断面二次|inertia"),
    ("shear", "G C N", r"shear modulus|modulus of rigidity|rigidity|schubmodul|gleitmodul"
     r"|横弾性係数|せん断弾性係数|剛性率"),
    ("length", "l L ell", r"length|lang|länge|長さ?"),
    ("stress", "sigma", r"stress|spannung|応力"),
    ("shearing", "tau", r"stress|spannung|応力"),
    ("stiffness", "c k C K", r"stiffness|spring (?:rate|constant)|rate|constant|steifigkeit"
     r"|federkonstante|federrate|feder|spring|ばね定数?|剛性|こわさ"),
    ("mass", "m M", r"mass(?:es)?|masse|質量|weight|gewicht"),
    ("inertia", "J I Theta", r"inertia|trägheitsmoment|massenträgheit|drehmasse|schwungmasse"
     r"|慣性モーメント|flywheel|schwungrad|rotor|円板|dis[ck]s?|scheiben?"),
    ("first_inertia", "J I Theta", r"inertia|trägheitsmomenten?|massen|dis[ck]s?|scheiben?"
    r"|慣性モーメント"),
    ("second_inertia", "J I Theta", r"inertia|trägheitsmomenten?|massen|dis[ck]s?|scheiben?"
    r"|慣性モーメント"),
    ("omega", "omega Omega w", r"angular (?:speed|velocity|frequency)|speed|winkelgeschwindigkeit"
     r"|kreisfrequenz|角速度|角振動数"),
    ("omega_high", "omega Omega", r"speed|velocity|winkelgeschwindigkeit|角速度"),
    ("omega_low", "omega Omega", r"speed|velocity|winkelgeschwindigkeit|角速度"),
    ("rotation", "n N f", r"speed|rpm|revolutions|drehzahl|回転数|回転速度|frequency"),
    ("frequency", "f nu", r"frequency|frequenz|振動数|周波数"),
    ("stroke", "s S H L", r"stroke|hub|行程|ストローク"),
    ("cylinders", "z Z i N n k", r"cylinders|zylinder(?:zahl)?|気筒数?|シリンダ数?"),
    ("velocity", "v u V", r"speed|velocity|geschwindigkeit|速度"),
    ("fluctuation", "delta", r"irregularity|fluctuation|ungleichförmigkeit(?:sgrad)?|変動率|steadiness"),
    ("swing", "Delta_E E W Delta_W A", r"energy|arbeit|energie|エネルギ|swing|fluctuation"),
    ("power", "P N L", r"power|leistung|動力|出力"),
    ("shift", "a e d s", r"distance|abstand|eccentricity|距離|offset"),
    ("central", "J I Theta", r"inertia|trägheitsmoment|慣性モーメント"),
    ("gravity", "g", r"gravity|erdbeschleunigung|重力加速度"),
    ("weight", "W G w", r"weight|gewicht|重量"),
)  # fmt: skip
ROLES: Mapping[str, Role] = {
    name: Role(_letters(letters), _words(words)) for name, letters, words in _ROLE_ENTRIES
}
OTHER_LENGTHS = _words(
    r"distance|abstand|spacing|\bpitch|\barm|hebelarm|width|breite|thickness|dicke|height|höhe|depth"
    r"|距離|間隔|幅|厚さ|高さ|eccentricity|strokes? per"
)
"""Words for lengths that play no part here, whatever their letter."""
(
    diameter, outer, inner, radius, crank, bending, torque, force, pressure, area, modulus,
    section, shear, length, stress, shearing, stiffness, mass, inertia, first_inertia,
    second_inertia, omega, omega_high, omega_low, rotation, frequency, stroke, cylinders,
    velocity, fluctuation, swing, power, shift, central, gravity, weight,
) = map(Name, ROLES)  # fmt: skip

_HOLLOW = (
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
_SOLID = _words(_HOLLOW, _NOTCH)
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
_NATURAL = (
    _sqrt(stiffness / inertia), _sqrt(stiffness / mass),
    _sqrt(stiffness * (first_inertia + second_inertia) / (first_inertia * second_inertia)),
    2 * PI * frequency,
)  # fmt: skip
_VIBRATION = r"vibrat|oscillat|resonan|schwing|eigen|振動|固有|natural"

QUANTITIES: tuple[Quantity, ...] = (
    Quantity(
        "torsional stress of a round shaft", _letters("tau"),
        _words(r"(?:torsion|twist|shear)\w*\s+stress(?:es)?", r"(?:torsions|schub|verdreh)spannung",
               r"(?:ねじり|せん断|剪断)応力"),
        (16 * torque / (PI * diameter**3), 2 * torque / (PI * radius**3), torque / modulus,
         torque * diameter / (2 * section), torque * radius / section,
         16 * torque * outer / (PI * _ANNULUS)),
        context=_words(r"torsion|twist|verdreh|drill"
        r"|ねじり"), unless=_words(_HOLLOW, _NOTCH, r"\bspring|feder|ばね"),
    ),
    Quantity(
        "bending stress of a round bar", _letters("sigma"),
        _words(r"bending\s+stress(?:es)?", r"flexural\s+stress", r"biegespannung", r"曲げ応力"),
        (32 * bending / (PI * diameter**3), 4 * bending / (PI * radius**3), bending / modulus,
         bending * diameter / (2 * section), bending * radius / section,
         32 * bending * outer / (PI * _ANNULUS)),
        context=_words(r"\bbending", r"\bbiegung", r"auf biegung", r"曲げ"),
        unless=_words(_HOLLOW, _NOTCH, r"equivalent|vergleich|相当|combined|von mises|tresca"),
    ),
    Quantity(
        "equivalent stress by von Mises", _letters("sigma"),
        _words(r"(?:equivalent|reduced)\s+stress", r"von[- ]mises(?:\s+stress)?", r"vergleichsspannung",
               r"ミーゼス(?:の)?(?:相当)?応力", r"相当応力", r"gestaltänderung\w*",
               r"distortion energy"),
        (_sqrt(stress**2 + 3 * shearing**2),), slips=("root", "term"),
        others=(_sqrt(stress**2 + 4 * shearing**2),
                stress / 2 + _sqrt(stress**2 + 4 * shearing**2) / 2),
        unless=_words(r"tresca|guest|maximum shear|schubspannungshypothese|最大せん断|rankine"
        r"|normalspannungs"
                      r"|トレスカ|\bSH\b|principal|haupt|主応力|saint.venant|bach|anstreng"),
    ),
    Quantity(
        "polar second moment of area of a round section", _letters("J I"),
        _words(r"polar\s+(?:second\s+)?moment(?:\s+of\s+(?:area|inertia|the\s+section))?",
               r"polares?n?\s+(?:flächen)?(?:trägheits)?moment",
               r"(?:polar\w* )?torsions(?:flächen)?trägheitsmoment",
               r"断面二次極モーメント", r"極断面二次モーメント", r"断面極二次モーメント"),
        _SECTION_POLAR, context=_words(r"torsion|twist|verdreh|drehschwing|ねじり"),
        unless=_words(_HOLLOW, _NOTCH, r"\bmass\b|massenträg|flywheel"
        r"|schwungrad"), indices=_letters("p t P T pol"),
    ),
    Quantity(
        "axial second moment of area of a round section", _letters("I J"),
        _words(r"axial\s+(?:second\s+)?moment(?:\s+of\s+(?:area|inertia))?",
        r"(?:axiales?n?|äquatoriales?n?)\s+"
               r"(?:flächen)?(?:trägheits)?moment", r"second moment of area (?:for|in) bending",
               r"(?:second\s+)?moment of (?:area|inertia)\s+about (?:a|its|the) diameter"),
        _SECTION_AXIAL, context=_words(r"bending|biegung|曲げ"),
        unless=_words(_HOLLOW, _NOTCH, r"polar|極|\bmass"
        r"|massenträg"), indices=_letters("a b x y z ax eq"),
    ),
    Quantity(
        "second moment of area of a round section", _letters("I J"),
        _words(r"second\s+moment\s+of\s+area", r"area\s+moment(?:\s+of\s+inertia)?",
        r"flächenträgheitsmoment",
               r"flächenmoment 2", r"断面二次モーメント"),
        _SECTION_AXIAL, others=_SECTION_POLAR,
        unless=_words(_HOLLOW, _NOTCH, r"polar|極|torsion|ねじり"),
    ),
    Quantity(
        "polar section modulus of a round section", _letters("W Z"),
        _words(r"polar\s+section\s+modulus", r"section\s+modulus\s+(?:in|for|of)\s+torsion",
               r"torsional\s+section\s+modulus", r"(?:polares?n?|torsions-?)\s*widerstandsmoment",
               r"widerstandsmoment gegen (?:torsion|verdreh\w*)", r"極断面係数", r"ねじり断面係数"),
        _MODULUS_POLAR, unless=_SOLID, context=_words(r"torsion|ねじり"),
        indices=_letters("p t P T pol"),
    ),
    Quantity(
        "section modulus of a round section in bending", _letters("W Z S"),
        _words(r"axial\s+section\s+modulus", r"section\s+modulus\s+(?:in|for|of)\s+bending",
               r"(?:axiales?n?|biege-?)\s*widerstandsmoment", r"widerstandsmoment gegen biegung",
               r"曲げ断面係数"),
        _MODULUS_AXIAL, context=_words(r"bending|biegung|曲げ"),
        unless=_words(_HOLLOW, _NOTCH, r"polar|torsion|極|ねじり"), indices=_letters("a b x y z ax"),
    ),
    Quantity(
        "section modulus of a round section", _letters("W Z S"),
        _words(r"section\s+modulus", r"widerstandsmoment", r"断面係数"),
        _MODULUS_AXIAL, others=_MODULUS_POLAR, unless=_words(_HOLLOW, _NOTCH, r"polar|torsion|極"
        r"|ねじり"),
    ),
    Quantity(
        "torsional stiffness of a round shaft", _letters("c k C K"),
        _words(r"torsional\s+(?:stiffness|spring\s+(?:rate|constant))", r"\bstiffness",
        r"spring\s+(?:rate|constant)",
               r"(?:dreh|torsions)(?:feder)?(?:steifigkeit|konstante|rate)", r"drehfeder\w*",
               r"federkonstante",
               r"ねじり(?:剛性|こわさ|ばね定数)", r"ばね定数"),
        (shear * section / length, PI * shear * diameter**4 / (32 * length),
         PI * shear * radius**4 / (2 * length)),
        context=_words(r"torsion|drehschwing|ねじり"),
        unless=_words(_HOLLOW, r"\bhelical|coil|schraubenfeder|コイル|parallel|series|reihe"
        r"|hintereinander|並列|直列"
                      r"|bending|biegung|曲げ"),
    ),
    Quantity(
        "angle of twist of a round shaft", _letters("phi varphi theta vartheta psi"),
        _words(r"angle\s+of\s+twist", r"twist\s+angle", r"verdreh(?:ungs)?winkel", r"drillwinkel",
        r"ねじれ角"),
        (torque * length / (shear * section), 32 * torque * length / (PI * shear * diameter**4),
         2 * torque * length / (PI * shear * radius**4), torque / stiffness),
        unless=_words(_HOLLOW, r"per\s+(?:unit\s+)?length|je länge|比ねじれ|単位長"),
    ),
    Quantity(
        "natural angular frequency", _letters("omega Omega w p"),
        _words(r"natural\s+(?:angular\s+|circular\s+|radian\s+)?frequenc(?:y|ies)",
        r"angular\s+natural\s+frequency",
               r"eigen(?:angular\s+)?frequency", r"eigen(?:kreis)?frequenz", r"固有(?:角|円)?振動数",
               r"固有角周波数", r"frequency of (?:the )?(?:free )?(?:torsional )?(?:vibration"
               r"|oscillation)s?"),
        _NATURAL, slips=("power", "root", "turn"), context=_words(_VIBRATION),
        indices=_letters("0 1 e n d eig E nat k"),
        unless=_words(r"damp|gedämpf|減衰|pendul|pendel|振り子|rotating vector"),
    ),
    Quantity(
        "natural frequency in cycles", _letters("f nu"),
        _words(r"natural\s+frequenc(?:y|ies)", r"eigenfrequenz", r"eigenfrequency",
        r"固有(?:振動数|周波数)",
               r"frequency of (?:the )?(?:free )?(?:torsional )?(?:vibration|oscillation)s?"),
        (*(node / (2 * PI) for node in _NATURAL[:3]), omega / (2 * PI)),
        slips=("root", "turn"), context=_words(_VIBRATION), indices=_letters("0 1 e n d eig E nat k"),
        unless=_words(r"damp|gedämpf|減衰|pendul|pendel|振り子"),
    ),
    Quantity(
        "period of the free oscillation", _letters("T tau"),
        _words(r"natural\s+period", r"period\s+of\s+(?:the\s+)?(?:free\s+)?(?:vibration|oscillation)s?",
               r"schwingungsdauer", r"eigenperiode", r"periodendauer", r"固有周期"),
        (2 * PI * _sqrt(mass / stiffness), 2 * PI * _sqrt(inertia / stiffness), 2 * PI / omega,
         1 / frequency),
        slips=("power", "root", "turn"), unless=_words(r"damp|gedämpf|減衰|pendul|pendel|振り子"),
    ),
    Quantity(
        "moment of inertia of a disc about its axis", _letters("J I Theta"),
        _words(r"\b(?:solid\s+)?dis[ck]\b", r"solid\s+cylinder",
        r"(?:voll|kreis|schwung)?scheibe\b", r"vollzylinder",
               r"円板", r"円盤"),
        (mass * radius**2 / 2, mass * diameter**2 / 8),
        others=(mass * radius**2 / 4, mass * diameter**2 / 16, 3 * mass * radius**2 / 2,
                3 * mass * diameter**2 / 8),
        unless=_words(_HOLLOW, r"pulley|riemenscheibe|プーリ",
        r"\brims?\b|hoop|kranz|リング|円環|リム|two dis[ck]|dis[ck]s|scheiben\b"
        r"|about (?:a|its) "
                      r"diameter|durchmesserachse|直径軸|直径まわり|直径を軸|tapered|kegel"
                      r"|\bpins?\b|zapfen"
                      r"|gyration"
                      r"|trägheitsradius|回転半径|edge|point on"),
    ),
    Quantity(
        "moment of inertia of a thin ring about its axis", _letters("J I Theta"),
        _words(r"thin\s+(?:ring|rim|hoop)", r"\bhoop\b", r"dünner?n?\s+(?:ring|kranz|reifen)",
        r"薄い(?:円環|リング)",
               r"細い(?:円環|リング)"),
        (mass * radius**2, mass * diameter**2 / 4),
        others=(mass * radius**2 / 2, mass * diameter**2 / 8, 2 * mass * radius**2),
        unless=_words(r"dis[ck]|scheibe|円板|diameter of|about (?:a|its) diameter|thick|dick(?!e)"
        r"|hollow|hohl"),
    ),
    Quantity(
        "moment of inertia of a thin rod about its centre", _letters("J I Theta"),
        _words(r"(?:thin|slender|uniform)\s+(?:rod|bar)\s+about\s+(?:its|the)\s+(?:cent(?:re|er)"
        r"|middle|centroid)",
               r"(?:dünner|schlanker)\s+stab(?:es)?\s+um\s+(?:seine\s+mitte|den\s+schwerpunkt)",
               r"細い棒の(?:重心|中心)まわりの慣性モーメント"),
        (mass * length**2 / 12,), others=(mass * length**2 / 3,), unless=_words(r"\bend\b|\bende\b|端"
        r"|half|halb"),
    ),
    Quantity(
        "moment of inertia of a thin rod about its end", _letters("J I Theta"),
        _words(r"(?:thin|slender|uniform)\s+(?:rod|bar)\s+about\s+(?:its|the|one)\s+end",
               r"(?:dünner|schlanker)\s+stab(?:es)?\s+um\s+(?:sein|ein|das)\s+ende",
               r"細い棒の(?:一)?端まわりの慣性モーメント"),
        (mass * length**2 / 3,), others=(mass * length**2 / 12,),
        unless=_words(r"cent(?:re|er)|middle|mitte|schwerpunkt|重心|中心|half|halb"),
    ),
    Quantity(
        "moment of inertia about a parallel axis", _letters("J I Theta"),
        _words(r"parallel[- ]axis", r"steiner(?:scher?)?(?:\s+satz)?", r"平行軸(?:の定理)?"),
        (central + mass * shift**2,), slips=("power of a term",), others=(central - mass * shift**2,),
    ),
    Quantity(
        "mean piston speed", _letters("v c V u C S"),
        _words(r"mean\s+(?:piston\s+)?speed(?:\s+of\s+the\s+piston)?",
        r"mean\s+(?:piston\s+)?velocity(?:\s+of\s+the\s+piston)?",
               r"average\s+piston\s+(?:speed|velocity)", r"mittlere\s+kolbengeschwindigkeit",
               r"平均ピストン(?:速度|スピード)", r"ピストン(?:の)?平均速度"),
        (2 * stroke * rotation, stroke * rotation / 30, 4 * crank * rotation, crank * rotation / 15,
         stroke * omega / PI, 2 * crank * omega / PI),
        unless=_words(r"strokes? per|hübe|doppelh|mean square|quadrat|crank ?pin|rim|umfang|circumf"
        r"|周速|\bgas|luft"
                      r"|half[- ]stroke"),
        only=_words(r"piston|kolben|ピストン"),
    ),
    Quantity(
        "swept volume", _letters("V Q"),
        _words(r"swept\s+volume", r"(?:piston|engine|cylinder)\s+displacement",
        r"displacement\s+volume",
               r"cubic\s+capacity", r"hubraum", r"hubvolumen", r"行程容積", r"総?排気量"),
        (PI * diameter**2 * stroke / 4, PI * diameter**2 * stroke * cylinders / 4,
         PI * diameter**2 * crank / 2, PI * diameter**2 * crank * cylinders / 2, area * stroke,
         area * stroke * cylinders, 2 * area * crank),
        others=(PI * radius**2 * stroke,),
        unless=_words(r"clearance|compression volume|kompressionsraum|隙間容積|opposed"
        r"|gegenkolben|対向"),
    ),
    Quantity(
        "piston area", _letters("A S F"),
        _words(r"piston\s+area", r"area\s+of\s+the\s+piston", r"bore\s+area",
        r"kolben(?:fläche|querschnitt)",
               r"ピストン(?:の)?(?:断?面積|受圧面積)", r"受圧面積"),
        (PI * diameter**2 / 4, PI * radius**2), unless=_words(r"ring|piston rod|kolbenstange"
        r"|ピストンロッド"
        r"|rod side"),
    ),
    Quantity(
        "gas force", _letters("F P K"),
        _words(r"gas\s+(?:force|load)", r"force\s+of\s+the\s+gas", r"gaskraft", r"kolbenkraft",
        r"ガス力",
               r"ガス圧力?(?:による)?力"),
        (PI * diameter**2 * pressure / 4, PI * radius**2 * pressure, area * pressure),
        unless=_words(r"side|seiten|inertia|massenkraft|difference|differenz|under ?side|crankcase"),
    ),
    Quantity(
        "power", _letters("P N"),
        _words(r"(?<!horse)\bpower\b(?!\s+(?:stroke|series|of\s+[a-z]\b|cycle|law))",
        r"\bleistung", r"動力", r"出力"),
        (torque * omega, 2 * PI * rotation * torque, PI * rotation * torque / 30, force * velocity,
         swing * rotation, swing * rotation / 60),
        slips=("power", "turn"), unless=_words(r"indicated|indiziert|図示|loss|verlust|損失|specific"),
    ),
    Quantity(
        "kinetic energy", _letters("E T K W U"),
        _words(r"kinetic\s+energy", r"rotational\s+energy",
        r"(?:kinetische|rotations|bewegungs)-?\s*energie",
               r"運動エネルギー?"),
        (mass * velocity**2 / 2, inertia * omega**2 / 2, mass * radius**2 * omega**2 / 2),
        unless=_words(r"change|fluctuation|swing|schwankung|änderung|変動|rolling|rollen|dis[ck]\b"
        r"|scheibe|円板|rod|stab|棒"),
    ),
    Quantity(
        "fluctuation of energy", _letters("Delta_E E W Delta_W A"),
        _words(r"(?:maximum\s+)?fluctuation\s+of\s+energy", r"energy\s+(?:fluctuation|swing|variation)",
               r"swing\s+of\s+energy", r"energieschwankung", r"arbeitsüberschuss", r"überschussarbeit",
               r"エネルギー?(?:の)?変動(?:量)?", r"変動エネルギー?"),
        (inertia * omega**2 * fluctuation, mass * radius**2 * omega**2 * fluctuation),
        slips=("bare factor", "power"), unless=_words(r"±|plus or minus|amplitude|ausschlag|振幅"),
    ),
    Quantity(
        "moment of inertia of the flywheel", _letters("J I Theta"),
        _words(r"fly-?wheel", r"schwungrad\w*", r"はずみ車", r"フライホイール"),
        (swing / (omega**2 * fluctuation),), slips=("bare factor", "power"),
        unless=_words(r"±|plus or minus|amplitude|ausschlag|振幅"),
    ),
    Quantity(
        "degree of irregularity", _letters("delta C epsilon"),
        _words(r"(?:degree|coefficient)\s+of\s+(?:irregularity|fluctuation|speed fluctuation"
        r"|cyclic\s+irregularity)",
               r"cyclic\s+irregularity", r"ungleichförmigkeits?(?:grad)?", r"(?:速度)?変動率",
               r"回転不整率"),
        ((omega_high - omega_low) / omega, swing / (inertia * omega**2)),
        slips=("bare factor", "power", "minus"), others=((omega_high - omega_low) / (2 * omega),),
        unless=_words(r"±|plus or minus|amplitude|ausschlag|振幅|half|halb"),
    ),
    Quantity(
        "centrifugal force", _letters("F Z C P K"),
        _words(r"centrifugal\s+forces?", r"centripetal\s+force", r"flieh-?kraft", r"zentrifugalkraft",
               r"zentripetalkraft", r"遠心力", r"向心力"),
        (mass * radius * omega**2, mass * velocity**2 / radius, weight * radius * omega**2 / gravity),
        slips=("power",),
    ),
    Quantity(
        "circumferential speed", _letters("v u V"),
        _words(r"(?:circumferential|peripheral|rim|tip)\s+(?:speed|velocity)",
        r"umfangsgeschwindigkeit", r"周速度?",
               r"crank-?pin\s+(?:speed|velocity)"),
        (radius * omega, diameter * omega / 2, PI * diameter * rotation, 2 * PI * radius * rotation,
         PI * diameter * rotation / 60, PI * radius * rotation / 30),
        unless=_words(r"relative|rolling|gear|belt|planet|gleit"),
    ),
    Quantity(
        "firing interval of a four-stroke engine",
        _letters("alpha phi varphi theta psi Delta_phi Delta_varphi beta Delta_theta"),
        _words(r"firing\s+(?:interval|spacing)", r"zündabstand", r"zündfolgeabstand",
        r"(?:点火|爆発|着火)間隔"),
        (4 * PI / cylinders,), others=(),
        unless=_words(r"two[- ]stroke|2[- ]stroke|zweitakt|2-takt|2ストローク|2サイクル|uneven|ungleich"
        r"|irregular|不等"
                      r"|odd|per\s+bank|in\s+one\s+bank|je bank|crank\s?pins?|throws?|kröpf"
                      r"|hubzapfen|ピン"),
        only=_words(r"four[- ]stroke|4[- ]stroke|viertakt|4-takt|4ストローク|4サイクル|四サイクル"),
        slips=("factor",),
    ),
    Quantity(
        "firing interval of a two-stroke engine",
        _letters("alpha phi varphi theta psi Delta_phi Delta_varphi beta Delta_theta"),
        _words(r"firing\s+(?:interval|spacing)", r"zündabstand", r"zündfolgeabstand",
        r"(?:点火|爆発|着火)間隔"),
        (2 * PI / cylinders,),
        unless=_words(r"four[- ]stroke|4[- ]stroke|viertakt|4-takt|4ストローク|4サイクル"
        r"|四サイクル|uneven|ungleich"
                      r"|irregular|不等|odd|per\s+bank|je bank|double[- ]acting|doppeltwirk|複動"),
        only=_words(r"two[- ]stroke|2[- ]stroke|zweitakt|2-takt|2ストローク|2サイクル|二サイクル"),
        slips=("factor",),
    ),
)  # fmt: skip
