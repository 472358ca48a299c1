"""Which motion of a slider-crank words name, and at which place: "at the bottom it slows by".

A motion and its place may stand apart, the motion in a heading or the head of a column, the place in the
label of a line or the row of a table.
"""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.kinematics import (
    ACCELERATION,
    BOTTOM,
    JERK,
    LARGEST,
    LEAST,
    PATH,
    RIGHT,
    ROD_ACCELERATION,
    ROD_ANGLE,
    ROD_SPEED,
    SHORTENING,
    SPEED,
    STROKE,
    TOP,
)
from symbalance.notes.checking.words.accuracies import without_orders_of_series
from symbalance.text import lazy_patterns as re

_ROD = re.compile(
    r"\brods?\b|con-?rod|obliquity|pleuel|\w*stange\b|コンロッド|連接棒|連桿|\bbielle\b|\bbiela\b"
    r"|\bbiella\b|\bswings?\b",
    re.IGNORECASE,
)
_ANGULAR = (
    r"rate of (?:turning|swing|lean)|angular|angulaire|angolare|swing(?:s|ing)?|sway|winkel|schwenk"
    r"|角|揺動"
    r"|rotational"
)
_TURNS = re.compile(_ANGULAR, re.IGNORECASE)
_KINDS = re.compile(
    r"(?P<jerk>\bjerk|\bruck\b|躍度|加加速度)"
    r"|(?P<acceleration>accelerat|beschleunig|加速度|accélération|aceleración|accelerazione|decelerat"
    r"|verzöger|slows?\b)"
    r"|(?P<velocity>velocit|\bspeeds?\b|geschwindigkeit|速度|vitesse|velocidad|\bswing rate"
    r"|\brate of (?:lean|turning|swing)"
    r"|\b(?:moves|runs|travels|slides) (?:at|with)\b"
    r"|swing at the rate)"
    r"|(?P<shortening>shorten|lowers? the piston|leaning rod lower)"
    r"|(?P<stroke>\bstroke\b(?! *(?:line|over|to|/))|\bhub\b|kolbenhub|行程|ストローク|\bcourse\b"
    r"|\bcarrera\b"
    r"|\bcorsa\b)"
    r"|(?P<angle>inclin|pendelwinkel|obliquity|\blean|\btilt|\bslant|schräg|schwenk|neigung|ausschlag|傾|揺動角"
    r"|(?<!crank )(?<!crank-)\bangle\b(?![^.;=,]{0,30}\bcrank\b(?! ?(?:shaft"
    r"|pin)))[^.;=,]{0,40}\b(?:con-?)?rod\b"
    r"(?![^.;=,]{0,16}\bcrank\b)"
    r"|\brod\b(?: (?!and\b|to\b)[^\W\d_]+){0,6} (?:makes|forms|includes"
    r"|is inclined)\b[^.;=]{0,40}\bangle\b"
    r"|(?<!kurbel)winkel\b[^.;=,]{0,30}(?:pleuel|(?:schub|pleuel)stange)|(?:pleuel|stange)\w*[^.;=,]{0,40}"
    r"\bden winkel\b|(?:連接棒|コンロッド)[^、。]{0,14}な[すし]た?角"
    r"|(?:rod|pleuel|stangen)[- ]?(?:angle|winkel)|angle of the (?:connecting[- ])?rod|oblicuidad"
    r"|\bswings?\b)"
    r"|(?P<displacement>displacement|\btravel|piston(?:'s)? (?:path|position|height)"
    r"|(?:piston|slider|ram|pin)(?:'s)? distance|distance of the (?:piston|slider)|\blage (?:des|der)\b"
    r"|(?:piston|slider|crosshead)\b(?: (?:has|have|is|will have|then|thus|already))* (?:moved"
    r"|travell?ed|descended"
    r"|sunk|gone down|been displaced|moves (?:down|inward)|descends)\b(?! (?:at|with))"
    r"|kolben\b[^.;=,]{0,30}\b(?:zurückgelegt|abwärts bewegt|nach unten bewegt|herabgegangen)"
    r"|ピストンの?(?:移動|下降|降下)(?:量|距離)|ピストンは?[^。]{0,16}(?:だけ)?(?:移動|下降|降下)(?:する|した)"
    r"|position (?:of|from|count)|wrist pin sits|sits at|(?:kolben|\b)weg\b|kolbenstellung|kolbenlage"
    r"|kolbenverschiebung|変位|ピストンの?位置|déplacement|desplazamiento|spostamento"
    r"|piston (?:is|has) gone"
    r"|gone when|counting from the crank|\bposition\b)",
    re.IGNORECASE,
)
_OF_KINDS = {
    "jerk": JERK, "acceleration": ACCELERATION, "velocity": SPEED, "shortening": SHORTENING,
    "stroke": STROKE, "angle": ROD_ANGLE, "displacement": PATH,
}  # fmt: skip
_OF_ROD = {ACCELERATION: ROD_ACCELERATION, SPEED: ROD_SPEED}
_OTHERS = re.compile(
    r"crank-?\s?pins?|big[- ]end|kurbelzapfen|hubzapfen|クランクピン|counterweight|gegengewicht"
    r"|centre of (?:gravity|mass)|center of (?:gravity|mass)|centroid|schwerpunkt|重心|relativ|\bmean\b"
    r"|average|mittlere|durchschnitt|平均|moyenne|\bmedia\b|scotch|\byoke|\bcams?\b|nocken|カム"
    r"|simple harmonic|\bS\.?H\.?M\b|infinite|unendlich|無限|(?<!to )(?<!to the )\bfirst[- ]order"
    r"|(?<!to )(?<!to the )(?<!at the )(?<!through )\bsecond[- ]order|primary"
    r"|secondary|(?<!bis zu )(?<!bis zur )(?<!bis )\b(?:erste|zweite)[rn]? ordnung|[一二三四12346]次"
    r"|component|komponente|成分|amplitude"
    r"|振幅|articulated|slave|nebenpleuel|\bper unit|\bsquared\b|\bsquares? of|quadrat|normal acc"
    r"|tangential"
    r"|centripetal|zentripetal|fliehkraft|求心|coriolis|\bvalve|ventil|弁|\bgas\b|flow|\belliptic"
    r"|\brod'?s (?:cent(?:re|er)|middle)"
    r"|\bpoint (?:of|on)\b|mid-?point|(?:in|of) its middle|middle of the (?:connecting )?rod|\bbanks?\b"
    r"|vehicle|flywheel|schwungrad|fahrzeug|\bdesired|\bharmonics?\b|\bfourth|\bsixth|\bfourier"
    r"|\bwaves?\b|ratio of(?! (?:the )?(?:crank|radius|(?:connecting[- ])?rod|lengths?|throw)\b)"
    r"|quotient|\bperiod|difference|unterschied|error|fehler|誤差|neglect"
    r"|dimensionless|dimensionslos|reduced|normali[sz]ed|\bbezogen",
    re.IGNORECASE,
)
"""Words for another body's motion, or for a part or a mean of one."""
HAS_OFFSET = re.compile(
    r"(?<!\bno )(?<!not )(?<!without )(?<!without an )(?<!zero )(?<!non-)offset"
    r"|(?<!nicht )(?<!nicht de)(?<!sans )(?<!non )(?<!no )(?:des|dés)ax|(?<!non )déax"
    r"|(?<!nicht )(?<!un)geschränkt"
    r"|(?<!ohne )schränkung|オフセット(?!な[いし]|がな|のな|は?無)|eccentric cylinder|misses the crank",
    re.IGNORECASE,
)
OF_ENGINE = re.compile(
    r"crank|pist[oó]n|émbolo|stantuffo|connecting|kurbel|kolben|pleuel|ピストン|クランク|連桿|bielle|manivelle|biela|manivela"
    r"|biella|manovella|\brods?\b|obliquity|dead cent|totpunkt|死点|slider|schubkurbel|gleitstein"
    r"|crosshead|kreuzkopf"
    r"|gudgeon|wrist pin",
    re.IGNORECASE,
)
_QUARTER = (
    r"quarter[- ](?:of a )?turn|(?<!\d)90\s?(?:°|deg|度|\^?\\?circ)|right angles?|square to|\bπ/2"
    r"|ninety degrees|viertel(?:um)?drehung|quart de tour|cuarto de vuelta"
)
_PLACES = re.compile(
    rf"(?P<right>{_QUARTER})"
    r"|(?P<top>(?<![\d.,])0\s?(?:°|deg)|\btop\b(?! (?:speed|piston))|\bupper\b|\bTDC\b|\bOT\b"
    r"|\boberen?m?\b|上死点|point mort haut"
    r"|\bPMH\b|superior|\bPMS\b)"
    r"|(?P<bottom>(?<!\d)180\s?(?:°|deg)|\bbottom\b|\blower\b(?! (?:the|by|than))|\bBDC\b|\bUT\b"
    r"|\bunteren?m?\b|下死点|point mort bas|\bPMB\b"
    r"|\binferior|\bPMI\b)"
    r"|(?P<inner>\binner\b|\bIDC\b|head[- ]end|cover[- ]end|\bin-?stroke|\binnere)"
    r"|(?P<outer>\bouter\b|\bODC\b|crank[- ]end|\bout-?stroke|\bäußere|other end)"
    r"|(?P<either>\bends? of (?:the|each) stroke|dead (?:cent(?:re|er)s|points)|totpunkten|死点)"
    r"|(?P<least>smallest|\bleast\b|minim|negative peak|\bhump|third extreme|kleinste|最小|deepest"
    r"|lowest(?! order))"
    r"|(?P<largest>greatest|largest|\bmaxim|\bpeak\b|highest|\bextreme\b|größte[rns]?|höchste|最大"
    r"|top (?:piston )?speed|steepest|fastest|\bmax\b)",
    re.IGNORECASE,
)
_ANGLE_AT = re.compile(
    r"(?:θ|ϑ|φ|ϕ|α|ψ|\\(?:var)?(?:theta|phi)|\\alpha|\\psi|theta|phi|(?<![A-Za-z])t)\}?\s*=\s*\$?"
    r"(?:(?P<top>0(?![.,]?\d))|(?P<bottom>180|π(?!/)|\\pi(?!/))|(?P<right>90|π/2|\\pi/2|\\frac\{\\pi\}\{2\}))"
)
_BY_INDEX = {
    "ot": TOP, "tdc": TOP, "top": TOP, "t": TOP, "o": TOP, "u": TOP, "pmh": TOP, "h": TOP,
    "ut": BOTTOM, "bdc": BOTTOM, "bot": BOTTOM, "bottom": BOTTOM, "b": BOTTOM, "pmb": BOTTOM,
    "90": RIGHT, "0": TOP, "180": BOTTOM, "max": LARGEST, "min": LEAST, "m": LARGEST,
}  # fmt: skip
_SURE = frozenset({"ot", "tdc", "ut", "bdc", "bot", "bottom", "90", "180", "max", "min", "pmh", "pmb"})


def motions_named(words: str, around: str = "") -> list[str]:
    """Return the motions that words name, first to last; words around may name the rod.

    >>> motions_named("The angular acceleration of the connecting rod, from its inclination")
    ['angular acceleration of the rod', 'rod angle']
    """
    is_of_rod, motions = _ROD.search(f"{words} {around}") is not None, list[str]()
    for match in _KINDS.finditer(words):
        kind = _OF_KINDS[match.lastgroup or ""]
        near = words[max(0, match.start() - 24) : match.end() + 14]
        if kind == ROD_ANGLE and not is_of_rod and "obliq" not in match[0].casefold():
            continue
        if kind in _OF_ROD and (_TURNS.search(near) or re.search("swing|lean", match[0], re.I)):
            if not is_of_rod:
                continue
            kind = _OF_ROD[kind]
        if kind == ROD_ANGLE and "wing" in match[0] and any(each in _OF_ROD.values() for each in motions):
            continue
        motions.append(kind)
    return motions


def names_another(words: str) -> bool:
    """Tell whether words name another body's motion, a part or a mean, not just how far a series goes.

    >>> names_another("the second-order acceleration"), names_another("to second order the acceleration")
    (True, False)
    """
    return _OTHERS.search(without_orders_of_series(words)) is not None


def places_named(words: str, sentence: str = "") -> list[str]:
    """Return the places of the crank that words name; "" for one that may be either dead centre.

    Inner and outer are said as seen from the crank or from the cylinder: "~top" is the usual one.

    >>> places_named("at the top"), places_named("", "for θ = π the"), places_named("inner dead centre")
    (['top'], ['bottom'], ['~top'])
    """
    named = {
        "either": "",
        "inner": "~top",
        "outer": "~bottom",
        "right": RIGHT,
        "top": TOP,
        "bottom": BOTTOM,
        "largest": LARGEST,
        "least": LEAST,
    }
    places = [named[match.lastgroup or ""] for match in _PLACES.finditer(words)]
    if not places:
        places = [match.lastgroup or "" for match in _ANGLE_AT.finditer(sentence)]
    return list(dict.fromkeys(places))


def place_of_index(index: str) -> tuple[str, bool]:
    """Return the place that a subscript names, and whether it can name nothing else.

    >>> place_of_index("UT"), place_of_index("b"), place_of_index("3")
    (('bottom', True), ('bottom', False), ('', False))
    """
    low = index.casefold()
    return _BY_INDEX.get(low, ""), low in _SURE
