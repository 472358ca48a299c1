"""Balance: centrifugal forces, counterweights and what they leave, unbalance, resultants of engines."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Number, number
from symbalance.notes.checking.meant.catalogue.crank_drive import COS_CRANK, SIN_CRANK
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    arm_of_weight,
    balance_mass,
    centrifugal,
    cylinders,
    eccentricity,
    force,
    gravity,
    letters,
    mass,
    omega,
    pin,
    radius,
    ratio,
    reciprocating,
    rod,
    root,
    rotating,
    rotation,
    share,
    unbalance,
    unbalanced,
    velocity,
    weight,
    words,
)
from symbalance.notes.checking.meant.catalogue.strength import both

_BALANCER = words(
    r"(?:counter-?rotating|contra-?rotating|opposite(?:ly)?\s+rotating"
    r"|balance[rs]?)\s+(?:balance\s+)?(?:weights?|mass(?:es)?|shafts?)",
    r"gegenläufige[nr]?\s+(?:ausgleichs)?(?:massen|gewichte)", r"ausgleichswellen?",
    r"(?:逆回転|反対回転)(?:する)?(?:おもり|錘|質量)", r"バランサ(?:軸|質量)?",
    r"arbres?\s+(?:contra-?rotatifs?|d.équilibrage)", r"alberi\s+(?:controrotanti|di\s+equilibra\w+)",
    r"ejes?\s+(?:contrarrotantes?|de\s+equilibra\w+)",
)  # fmt: skip
_BALANCER_MASS = words(
    _BALANCER.pattern,
    r"(?:each|jede[rs]?|chacun\w*|ciascun\w*|cada\s+un[oa])[^.;=]{0,14}(?:carries|trägt|porte|porta|lleva)[^.;=]{0,30}",
    r"mass\w*[^.;=]{0,24}\b(?:of\s+each|each|de\s+chacun\w*|di\s+ciascun\w*)[^.;=]{0,50}",
)  # fmt: skip
_FORCE_OF_ONE = (
    r"(?:forces?|amplitude\w*|\w*kr[aä]fte?|forza|fuerza|efforts?|力|振幅)[^.;=\n]{0,24}"
    r"(?:\b(?:of|per|for|from|eines|je|pro|d.un|de\s+un|par|di\s+un|per|por)\s?(?:(?:one|an?|each|every|a\s+single|single|einzelnen|seul"
    r"|solo|singolo)\s+)?(?:cylind(?:er|re)(?![a-z])|zylinders?(?![a-z])|cilindro(?![a-z])|piston(?![a-z])))"
    r"|(?:1|一|各|単)\s?(?:気筒|シリンダ)(?:あたり|当たり|分)?の[^、。\n]{0,12}(?:力|振幅)"
)
"""Words of what one cylinder does, and no whole engine."""
_EACH = words(r"\beach|jede|1つ|それぞれ|各|chacun|ciascun|cada\s+un")
_OF_SINGLE = words(
    r"single[- ]cylinder|one[- ]cylinder|einzylinder|単気筒|mono-?(?:cylindre|cylinder|cilin)"
)
_IN_POUNDS = (
    r"\bpounds?\b|\blbs?\b|\\[dt]?frac\s?\{?\s?[WG](?:_\w)?\s?\}?\s?\{?\s?g\b|\b[WG](?:_\w)?\s?/\s?g\b"
)
"""Words and quotients by which a page reckons with weights, and divides by g."""

_ALONG_CYLINDER = (
    r"(?:(?:along|in\s+line\s+with|in\s+the\s+(?:direction|line)\s+of)\s+(?:the\s+)?(?:line\s+of\s+)?(?:cylinder|stroke|bore)"
    r"(?:\s+axis)?|in\s+(?:zylinder|hub)(?:achs)?richtung|in\s+richtung\s+der\s+zylinderachse|längs\s+des\s+zylinders"
    r"|(?:suivant|selon|dans|in|(?:le|the)\s+long\s+(?:de|of)|lungo|secondo|según|a\s+lo\s+largo\s+(?:de|of))\s+"
    r"(?:the\s+|l['’]|il\s+|el\s+)?(?:(?:axe|asse|shaft|axis|eje|direction|direzione|dirección)\s+(?:of|du|del)\s+)?(?:the\s+)?"
    r"(?:cylinder|cylindre|cilindro)"
    r"|(?:シリンダ(?:ー)?軸?|行程)方向)"
)
_REMAINS = (
    r"(?:remain\w*|(?:is|are)\s+left|bleibt|verbleibt|übrig|reste|subsiste|rimane|resta|queda"
    r"|残る|残留する)"
)
_REMAINS_ALONG = words(
    rf"{_REMAINS}(?:\s+(?:unbalanced|only|noch|nur|encore|ancora|todavía))?\s*{_ALONG_CYLINDER}",
    rf"{_ALONG_CYLINDER}(?:に)?は?\s*(?:(?:there|still|noch|nur|il)\s+)?{_REMAINS}(?:\s*(?:力|成分|慣性力)|\s+noch)?",
)
"""What remains along the cylinder, where a weight has taken its share."""
_HALF_TAKEN = both(
    words(
        r"(?:counter-?weight|counterpoise|gegengewicht|ausgleichsgewicht|contrepoids|contrappes|contrapes|釣り?合いおもり|つりあいおもり"
        r"|カウンタ)"
    ),
    words(r"\bhalf\b|50\s?\\?%|hälfte|\bmoitié|\bmetà|\bmitad|半分"),
)
"""Words for a counterweight that takes up half of what goes to and fro."""
_WRONG_ACROSS = (
    (1 - share) * mass * pin * omega**2 * SIN_CRANK,
    -(1 - share) * mass * pin * omega**2 * SIN_CRANK,
    share * mass * pin * omega**2 * COS_CRANK,
)
"""Across the cylinder acts the weight alone: with its whole share, and as the sine."""

BALANCE: tuple[Quantity, ...] = (
    Quantity(
        "centrifugal force", letters("F Z C P K"),
        words(r"centrifugal\s+forces?", r"centripetal\s+force", r"flieh-?kraft", r"zentrifugalkraft",
               r"zentripetalkraft", r"遠心力", r"向心力"),
        (mass * radius * omega**2, mass * velocity**2 / radius, weight * radius * omega**2 / gravity,
         4 * PI**2 * rotation**2 * mass * radius, PI**2 * rotation**2 * mass * radius / 900),
        slips=("power", "turn"),
        mistakes=(PI**2 * rotation**2 * mass * radius,
                  2 * PI * rotation * mass * radius, PI * rotation * mass * radius / 30,
                  PI**2 * rotation**2 * mass * radius / 3600, PI**2 * rotation**2 * mass * radius / 1800,
                  PI**2 * rotation**2 * mass * radius / 225, 2 * PI**2 * rotation**2 * mass * radius),
        unless=words(_IN_POUNDS),
    ),
    Quantity(
        "whole centrifugal force of a rotor on its bearings", letters("F Z C P K"),
        words(r"(?:total|whole|entire)\s+centrifugal\s+forces?", r"(?:gesamte|ganze)\w*\s+fliehkraft",
              r"遠心力の合計", r"centrifugal\s+forces?\s+total\w*"),
        (unbalanced * eccentricity * omega**2, unbalance * omega**2), ("bare factor", "power", "part"),
        unless=words(r"\beach|\bper\b|\bje\b|jede|\btwo\b|\bzwei|各|二つ|2つ|半分|half"),
    ),
    Quantity(
        "centrifugal force of a weight", letters("F Z C P K"),
        words(r"centrifugal\s+forces?", r"flieh-?kraft", r"zentrifugalkraft", r"遠心力"),
        (weight * radius * omega**2 / gravity, weight * velocity**2 / (gravity * radius)), ("power",),
        others=(mass * radius * omega**2,), mistakes=(weight * radius * omega**2,),
        only=words(_IN_POUNDS),
        unless=words(r"\bslugs?\b|mass(?:es)?\s+(?:in|of)\b|(?:weights?"
                     r"|gewichte?)\W{0,4}[mM]\b"), is_told_once=True,
    ),
    Quantity(
        "hammer blow", letters("F Q B P H V"),
        words(r"hammer[\s-]?blow", r"hammerschlag", r"ハンマーブロー", r"(?:槌打|つち打ち)(?:力)?"),
        (share * mass * pin * omega**2 * SIN_CRANK, share * mass * pin * omega**2, mass * pin * omega**2,
         mass * pin * omega**2 * SIN_CRANK,
         balance_mass * arm_of_weight * omega**2, balance_mass * arm_of_weight * omega**2 * SIN_CRANK),
        ("edit", "power"), others=((1 - share) * mass * pin * omega**2,),
        mistakes=(balance_mass * arm_of_weight * omega**2 * COS_CRANK,
                  share * mass * pin * omega**2 * COS_CRANK, mass * pin * omega**2 * COS_CRANK,
                  (1 - share) * mass * pin * omega**2 * SIN_CRANK),
        unless=words(r"tractive|zug(?:kraft|schwank)|けん引|牽引|swaying|schlinger"), turns=True,
    ),
    Quantity(
        "residual force along the line of stroke", letters("F R P X"),
        words(r"(?:residual|remaining|unbalanced|resultant|rest)\s+(?:primary\s+"
        r"|inertia\s+)?force\s+(?:along|in)"
              r"\s+(?:the\s+)?(?:line|direction)\s+of\s+(?:the\s+)?stroke",
              r"(?:residual|remaining|unbalanced)\s+(?:primary\s+"
              r"|inertia\s+)?force\s+along\s+the\s+(?:cylinder(?:\s+axis)?|stroke|bore)",
              r"(?:residual|remaining|unbalanced|resultant|rest)\s+(?:primary\s+|inertia\s+)?force\s+"
              r"(?:in\s+line\s+with|parallel\s+to|in"
              r"|along)\s+(?:the\s+)?(?:direction\s+of\s+(?:the\s+)?)?"
              r"(?:cylinder|piston|stroke|bore)(?:\s+(?:axis|direction))?",
              r"restkraft\s+in\s+(?:zylinder|hub)(?:achs)?richtung",
              r"force\s+résiduelle\s+(?:suivant|selon|dans)\s+(?:l'axe"
              r"|la\s+direction)(?:\s+du\s+cylindre)?",
              r"fuerza\s+residual\s+(?:en|según)\s+(?:la\s+dirección|el\s+eje)(?:\s+del\s+cilindro)?",
              r"(?:in|along)\s+(?:the\s+)?(?:dirección|direction|direzione|richtung)\s+of\s+(?:the\s+)?(?:shaft|axis|axe|asse|eje)"
              r"\s+of\s+(?:the\s+)?cylinder[^.;=]{0,30}?(?:sin\s+equilibrar|non\s+équilibré\w*|non\s+equilibrat\w*|unbalanced|unausgeglichen)"
              r"[^.;=]{0,12}(?:force|fuerza|forza)(?:\s+of\s+(?:the\s+)?first\s+order)?",
              r"(?:行程|シリンダ軸)方向の(?:残留力|不釣合い力|不つりあい力)"),
        ((1 - share) * mass * pin * omega**2 * COS_CRANK,), ("edit",),
        mistakes=(share * mass * pin * omega**2 * COS_CRANK, share * mass * pin * omega**2 * SIN_CRANK,
                  (1 + share) * mass * pin * omega**2 * COS_CRANK,
                  (1 - share) ** 2 * mass * pin * omega**2 * COS_CRANK),
        unless=words(r"\boverbalance|unbalanced (?:fraction|share|part|portion)"
        r"|fraction (?:that is )?(?:left|unbalanced)|restanteil|second|zweite|2次|share left"
        r"|remains unbalanced is"), turns=True, stated=frozenset({"share"}),
    ),
    Quantity(
        "force that half a balance leaves", letters("F R P K Q Z S"),
        words(r"radius", r"magnitude", r"\bsize\b", r"\blength", r"\bbetrag", r"módulo",
                r"\bmodulo", r"大きさ|半径"),
        (mass * pin * omega**2 / 2,), ("bare factor", "part", "power"),
        mistakes=(mass * pin * omega**2, mass * pin * omega**2 / 4,
                mass * pin * omega**2 / root(number(2))),
        only=both(
            words(r"(?:counter-?weight|counterpoise|balanc|gegengewicht|ausgleich|equilibr|équilibr|contrepoids|釣り?合)"),
            words(r"\bhalf\b|50\s?\\?%|hälfte|\bmoitié|\bmetà|\bmitad|半分"),
            words(r"\bcircle|\bcircular|\bkreis\w*|\bcercle|circonferenza|circunferencia|\bconstant\b|konstant|円"),
            words(r"residual|\bleft\b|remain|restkraft|resid\w+|résiduel\w*|bleib|残"),
        ),
        unless=words(r"\bV\b|V-?twin|\btwo\b|zwei|second|zweite|2次|radial|secondaire"
                     r"|secondo ordine"), is_told_once=True,
    ),
    Quantity(
        "force that half a balance leaves along the cylinder", letters("F R P X K"),
        _REMAINS_ALONG, (mass * pin * omega**2 * COS_CRANK / 2, mass * pin * omega**2 / 2),
        ("edit", "part", "power", "bare factor"),
        mistakes=(mass * pin * omega**2 * COS_CRANK, mass * pin * omega**2 * SIN_CRANK / 2,
                  mass * pin * omega**2 * SIN_CRANK, mass * pin * omega**2 * COS_CRANK / 4),
        only=_HALF_TAKEN,
        unless=words(r"\bV\b|V-?twin|\btwo\b|\bzwei|\bdeux\b|\bdue\b|radial|second|zweite|2次|unbalanced\s+mass"
                     r"|balance shaft|ausgleichswelle|バランサ|multi|each"),
    ),
    Quantity(
        "residual force across the line of stroke", letters("F R P Y Q"),
        words(r"(?:residual|remaining|unbalanced|resultant)\s+(?:primary\s+"
        r"|inertia\s+)?force\s+(?:perpendicular|at\s+right\s+angles"
              r"|normal|transverse)\s+to\s+(?:it|(?:the\s+)?(?:line|direction)\s+of\s+(?:the\s+)?stroke)",
              r"(?:residual|remaining|unbalanced)\s+(?:primary\s+"
              r"|inertia\s+)?force\s+across(?:\s+(?:it|the\s+(?:cylinder|stroke|bore)))?",
              r"(?:residual|remaining|unbalanced|resultant|rest)\s+(?:primary\s+|inertia\s+)?force\s+"
              r"(?:transverse|perpendicular|normal|at\s+right\s+angles)\s+to\s+(?:the\s+)?"
              r"(?:cylinder|piston|stroke|bore)(?:\s+(?:axis|direction))?",
              r"restkraft\s+quer(?:\s+zur\s+(?:zylinder|hub)(?:achse|richtung))?",
              r"(?:行程|シリンダ軸)に(?:垂直|直角)な(?:方向の)?(?:残留力|不釣合い力|不つりあい力)"),
        (share * mass * pin * omega**2 * SIN_CRANK, -share * mass * pin * omega**2 * SIN_CRANK),
        ("edit",),
        mistakes=_WRONG_ACROSS,
        unless=words(r"\boverbalance|unbalanced (?:fraction|share|part|portion)"
        r"|fraction (?:that is )?(?:left|unbalanced)|restanteil|second|zweite|2次|share left"
        r"|remains unbalanced is"), turns=True, stated=frozenset({"share"}),
    ),
    Quantity(
        "force that a counterweight leaves across the cylinder", letters("Y F R Q"),
        words(r"across(?:\s+(?:it|the\s+(?:cylinder|stroke|bore)(?:\s+axis)?))?",
              r"(?:at\s+right\s+angles|perpendicular|transverse)(?:\s+to\s+(?:it|the\s+(?:cylinder|stroke)(?:\s+axis)?))?",
              r"quer(?:\s+(?:dazu|zur?\s+\w*(?:zylinder|achse|richtung)\w*))?",
              r"transversal\w*", r"trasversal\w*", r"perpendicula\w+(?:\s+(?:à|al|alla|a)\s+\w+)?",
              r"(?:これに|シリンダ(?:軸)?に)?(?:垂直|直角)(?:な)?(?:方向)?"),
        (share * mass * pin * omega**2 * SIN_CRANK, -share * mass * pin * omega**2 * SIN_CRANK),
        ("edit",), mistakes=_WRONG_ACROSS,
        only=both(
            words(r"counter-?weight|counterpoise|balance\s+weight|gegengewicht|contrepoids|contrappes|contrapes|釣り?合いおもり"
                  r"|カウンタ"),
            words(r"\bleft\b|remain|residual|unbalanced|übrig|verbleib|\brest\b|restkraft|\breste\b|rimane|\bresta\b|queda|残"),
        ),
        unless=words(r"\boverbalance|unbalanced (?:fraction|share|part|portion)"
                     r"|fraction (?:that is )?(?:left|unbalanced)|restanteil|second|zweite|2次|share left"
                     r"|remains unbalanced is|\bV\b|V-?twin|radial|balance shaft"
                     r"|ausgleichswelle|バランサ"), turns=True, stated=frozenset({"share"}),
    ),
    Quantity(
        "amplitude of the force that a counterweight leaves across the cylinder", letters("Y F R Q P"),
        words(r"amplitude", r"(?:largest|greatest|maximum|peak)\s+(?:value|size|force)", r"\bsize\b",
              r"magnitude", r"größtwert", r"höchstwert", r"scheitelwert", r"\bbetrag", r"最大値", r"振幅",
              r"大きさ", r"ampiezza", r"amplitud"),
        (share * mass * pin * omega**2,), ("any", "edit", "power", "part"),
        mistakes=((1 - share) * mass * pin * omega**2, mass * pin * omega**2 / share),
        only=both(
            words(r"counter-?weight|counterpoise|balance\s+weight|gegengewicht|contrepoids|contrappes|contrapes"
                  r"|おもり|カウンタ"),
            words(r"\bacross\b|at\s+right\s+angles|perpendicular|transverse|\bquer\b|senkrecht|perpendicula"
                  r"|transversal|trasversal|垂直|直角"),
        ),
        unless=words(r"\boverbalance|unbalanced (?:fraction|share|part|portion)|\balong\b|in line with"
                     r"|in (?:hub|zylinder)richtung|fraction (?:that is )?(?:left|unbalanced)|restanteil"
                     r"|second|zweite|2次|share left|remains unbalanced is|\bV\b|V-?twin|radial"
                     r"|balance shaft"
                     r"|ausgleichswelle|バランサ|行程方向|resultant|parallel"),
        stated=frozenset({"share"}),
    ),
    Quantity(
        "counterweight", letters("m M B G"),
        words(r"(?:mass\s+of\s+the\s+)?(?:counter-?weight|counterbalance|balance\s+(?:weight"
        r"|mass))(?:\s+mass)?",
              r"(?:masse\s+des\s+)?gegengewichts?(?:masse)?", r"ausgleichsmasse",
              r"(?:釣り?合い?|つりあい)(?:おもり|錘|質量)(?:の質量)?",
              r"カウンタ(?:ー)?ウェイト(?:の質量)?"),
        ((rotating + share * reciprocating) * pin / arm_of_weight, share * mass * pin / arm_of_weight,
         mass * pin / arm_of_weight, (rotating + reciprocating / 2) * pin / arm_of_weight),
        ("edit", "power"),
        others=((rotating + share * reciprocating) * pin / (2 * arm_of_weight),
        mass * pin / (2 * arm_of_weight),
                share * mass * pin / (2 * arm_of_weight),
                (rotating + reciprocating) * pin / arm_of_weight),
        mistakes=((share * rotating + reciprocating) * pin / arm_of_weight,),
        unless=words(r"balance shaft|ausgleichswelle|バランサ|counter-?rotat|lanchester"
        r"|\bmoments? (?:about|balanc)|momenten"
        r"|\bplanes?\b|\bebenen?\b|\bcouple|twice|doppelt"),
        together=(("", "arm_of_weight"),),
    ),
    Quantity(
        "mass of each of two counter-rotating weights at twice the crank's speed", letters("m M"),
        _BALANCER_MASS,
        (mass * pin * ratio / (8 * arm_of_weight), mass * pin**2 / (8 * rod * arm_of_weight)),
        ("edit", "part"),
        mistakes=(mass * pin * ratio / (2 * arm_of_weight), mass * pin * ratio / (4 * arm_of_weight),
                  mass * pin * ratio / (16 * arm_of_weight), mass * pin * ratio / arm_of_weight),
        only=both(_BALANCER, _OF_SINGLE, _EACH, words(r"twice|double|doppelt|2倍|2\s?ω|2\\omega")),
        unless=words(r"four|vier|4気筒|both|zusammen|together|合計"),
    ),
    Quantity(
        "mass of each of two counter-rotating weights at the crank's speed", letters("m M"),
                _BALANCER_MASS,
        (mass * pin / (2 * arm_of_weight),), ("power", "part"),
        others=(mass * pin / (4 * arm_of_weight),),
        mistakes=(mass * pin / arm_of_weight,),
        only=both(_BALANCER, _OF_SINGLE, _EACH),
        unless=words(r"twice|double|doppelt|2倍|2\s?ω|2\\omega|four|vier|both|together|zusammen"
        r"|crank (?:itself )?carries|half"),
    ),
    Quantity(
        "unbalance", letters("U"),
        words(r"(?<!permissible )(?<!specific )(?<!residual )(?:static\s+)?(?:unbalance|imbalance)",
        r"(?<!rest)unwucht(?!kraft|güte)",
              r"不釣り?合い量?(?!力)"),
        (unbalanced * eccentricity,), ("power", "bare factor"),
        unless=words(r"couple|force|kraft|dynamic|moment|力|\bplanes?\b|ebenen?\b|面|per\b|\bje\b"),
    ),
    Quantity(
        "unbalance by its force", letters("U u D S"),
        words(r"(?:static\s+)?(?:unbalance|imbalance|mass\s+moment)", r"static\s+moment",
              r"unwucht(?!kraft|güte)",
              r"statisches?\s+moment", r"不釣り?合い量?(?!力)"),
        (force / omega**2, centrifugal / omega**2), ("power",),
        others=(force / (4 * omega**2), force / (2 * omega) ** 2),
        only=words(r"force|kraft|力|\bN\b|load"),
    ),
    Quantity(
        "centrifugal force of an unbalance", letters("F Z"),
        words(r"unbalance\s+force", r"(?:centrifugal\s+)?force\s+of\s+(?:the|an)\s+unbalance",
        r"unwuchtkraft", r"不釣り?合い力"),
        (unbalance * omega**2, unbalanced * eccentricity * omega**2), ("power",),
        unless=words(r"transmi|residual"),
    ),
    Quantity(
        "resultant first-order force of a radial engine", letters("F P R Z S"),
        words(r"(?:resultant|primary|first[- ]order)\s+(?:of\s+the\s+)?(?:primary\s+|first[- ]order\s+"
        r"|inertia\s+)?forces?",
              r"resultierende\s+(?:massenkraft|kraft)?(?:\s*(?:1\.|erster)\s+ordnung)?",
              r"sum(?:ming|\s+of)\s+(?:all\s+)?(?:the\s+)?direct\s+(?:primary\s+)?cranks",
              r"massenkraft\s+(?:1\.|erster)\s+ordnung",
              r"(?:一|1)次(?:の)?(?:慣性力の)?(?:合力|慣性力)"),
        (cylinders * mass * pin * omega**2 / 2,), ("factor", "power", "part"),
        mistakes=(cylinders * mass * pin * omega**2, cylinders * mass * pin * omega**2 / root(number(2)),
                  (cylinders - 1) * mass * pin * omega**2 / 2, 2 * mass * pin * omega**2 / cylinders),
        only=words(r"radial(?:\s+engine)?|\bstar\b|sternmotor|星形"),
        unless=words(r"in phase|in step|would be|together"
                     r"|(?:articulated|slave|nebenpleuel|副連接棒)(?![^.;]{0,40}(?:neglect|ignor|vernachlässig|無視))"
                     r"|counterweight|gegengewicht|second|zweite"
        r"|2次|rotating mass|\bbanks?\b|(?:two|double|twin)[- ]row|two rows|\bhalf\b|per\s+pair"
        r"|\bfirst\s+\w+\s+cylinders", _FORCE_OF_ONE), stated=frozenset({"cylinders"}),
    ),
    Quantity(
        "resultant first-order force of a V-twin at 90°", letters("F P R Z"),
        words(r"(?:resultant|primary|first[- ]order)\s+(?:of\s+the\s+)?(?:primary\s+|first[- ]order\s+"
        r"|inertia\s+)?forces?",
              r"resultierende\s+(?:massenkraft|kraft)?(?:\s*(?:1\.|erster)\s+ordnung)?",
              r"massenkraft\s+(?:1\.|erster)\s+ordnung",
              r"(?:一|1)次(?:の)?(?:慣性力の)?(?:合力|慣性力)"),
        (mass * pin * omega**2,), ("bare factor", "power", "part"),
        mistakes=(root(Number(Fraction(2))) * mass * pin * omega**2,),
        only=both(words(r"90\s*(?:°|\\?deg|\^|\\\\circ|-degree| degree|\s*grad|度)"),
        words(r"[VL]-?twin|\bvee\b|Gabelmotor|\bV\b|V2|V-2|V-engine|V-motor|V形"
              r"|V型")),
        unless=words(r"both(?!\s+(?:connecting\s+)?rods)|together|beide(?!\s+pleuel)|zusammen|合計"
        r"|two pistons|zwei kolben|second|zweite|2次"
        r"|four|vier|six|eight|cylinder(?:s)? (?:is|alone)|each|per cylinder|one cylinder|一つの"),
    ),
)  # fmt: skip
