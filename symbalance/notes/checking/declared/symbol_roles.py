"""The roles a letter may be declared to have, such as crank radius, and how each may be spelled."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import SequenceMatcher
from functools import cache

from symbalance.text import lazy_patterns as re

BY_MINUTE = "engine speed rpm"
"""What a letter is declared as that counts revolutions by the minute."""
CRANK_ANGLE = "crank angle"
FROM_TOP = "displacement from top dead centre"
FROM_PIN = "piston position"
FROM_MIDDLE = "piston position from mid-stroke"

ALIASES = {
    "displacement from tdc": FROM_TOP,
    "piston displacement from top dead centre": FROM_TOP,
    "piston displacement from tdc": FROM_TOP,
    "displacement from top dead center": FROM_TOP,
    "connecting rod length": "rod length",
    "crank speed": "angular speed",
    "angular velocity": "angular speed",
    "rod ratio (l/r)": "rod ratio l/r",
    "rod ratio (l/s)": "rod ratio l/s",
    "rod ratio r/l": "crank ratio r/l",
    "rod ratio (r/l)": "crank ratio r/l",
    "ratio l/r": "rod ratio l/r",
    "ratio l/s": "rod ratio l/s",
    "ratio r/l": "crank ratio r/l",
    "crank ratio (r/l)": "crank ratio r/l",
    "r/l": "crank ratio r/l",  # as it stands, and no revolutions per litre
    "l/r": "rod ratio l/r",
    "l/s": "rod ratio l/s",
}

KNOWN = (
    "crank angle",
    "rod angle",
    "crank radius",
    "stroke",
    "rod length",
    "rod ratio l/r",
    "rod ratio l/s",
    "crank ratio r/l",
    "angular speed",
    "engine speed rpm",
    "time",
    "reciprocating mass",
    FROM_TOP,
    FROM_PIN,
    FROM_MIDDLE,
    "piston velocity",
    "piston acceleration",
    "inertia force",
    "cylinder pitch",
    "integer",
    "positive",
    "constant",
    "complex",
    "variable",
)

FORCE = "inertia force"
MOVING = (FROM_TOP, FROM_PIN, FROM_MIDDLE, "piston velocity", "piston acceleration", FORCE)
POSITIVE = {
    *("crank radius", "stroke", "rod length", "rod ratio l/r", "rod ratio l/s", "crank ratio r/l"),
    *("angular speed", "engine speed rpm", "reciprocating mass", "cylinder pitch", "positive"),
}
CONSTANT = (
    *("crank radius", "stroke", "rod length", "rod ratio l/r", "rod ratio l/s", "crank ratio r/l"),
    *("angular speed", "engine speed rpm", "reciprocating mass", "cylinder pitch", "constant"),
)
"""What changes with no angle and no time: it stands outside an integral."""
CONSTANT_WORD = re.compile(
    r"\b(?:constant|coefficient|amplitude|length|radius|ratio|mass|factor|width|distance|number|konstante)\b"
)
"""Words of a meaning that say the same."""
SMALL_WORD = re.compile(
    r"\b(?:small|little|tiny|perturbation|klein\w*|gering\w*)\b|微小|小さ", re.IGNORECASE
)
"""Words of a meaning that say that a letter is small beside 1."""
_CALLED_SMALL = re.compile(
    r"(?:(?<![A-Za-z])(?:small|klein(?:e[nsrm]?)?)\s+(?:angles?\s+|values\s+of\s+|Winkel\s+)?\$?\\?"
    r"([A-Za-z]+(?:_\{?\w+\}?)?)\$?(?:\s+(?:and|und|et)\s+\$\\?([A-Za-z]+(?:_\{?\w+\}?)?)\$)?"
    r"|(?<![A-Za-z])\\?([A-Za-z]++(?:_\{?\w{1,40}+\}?)?)\s*+(?:\\ll(?![a-z])|≪|<<)\s*1(?![\d.])"
    r"|(?<![A-Za-z])([A-Za-z]++)(?:\s*=\s*[^$.;,\n]{1,20})?\$?\s+(?:is|ist)\s+(?:very\s+|sehr\s+|much\s+)?(?:small|klein)"
    r"|(?<![A-Za-z])([A-Za-z]++)\$?\s*は\s*(?:十分に?|非常に)?小さ"
    r"|(?<![A-Za-z])([A-Za-z]++)\s*=\s*(?:\\[td]?frac\s*\{?\s*r\s*\}?\s*\{?\s*l(?![A-Za-z])|r\s*/\s*l(?![A-Za-z\w])))"
)
_LETTER = r"\$?\s?\\?([A-Za-z]++(?:_\{?\w{1,8}+\}?)?)"
_HIGHER = (
    r"(?:higher|höhere[rn]?)\s+(?:powers|orders|terms|Potenzen|Ordnung(?:en)?|Glieder[n]?|Terme[n]?)"
)
_FIRST = (
    r"(?:first|lowest|leading|second|third|fourth|ersten?r?|niedrigste[rn]?|zweiten?r?|dritte[rn]?"
    r"|vierte[rn]?)"
)
_EXPANDED_IN = re.compile(
    rf"(?:neglect|ignor|drop|omit|discard|vernachlässig)\w{{0,8}}\s+"
    rf"(?:of\s+|the\s+|all\s+|aller?\s+|die\s+|der\s+){{0,2}}{_HIGHER}\s+"
    rf"(?:than\s+\w+\s+)?(?:of|in|von|als\s+\w+\s+in)\s+{_LETTER}"
    rf"|{_HIGHER}\s+(?:of|in|von)\s+{_LETTER}\$?\s+(?:are|is|can\s+be|may\s+be|werden|wird|sind)\s+"
    r"(?:neglect|ignor|drop|omit|vernachlässig)"
    rf"|(?:to|up\s+to|in|bis\s+zur?|bis)\s+(?:the\s+)?{_FIRST}\s+(?:order|power|Ordnung|Potenz)\s+(?:in|of|von)\s+{_LETTER}"
    rf"|(?<![A-Za-z\\])\\?([A-Za-z]++)\$?\s*の\s*(?:\$?[0-9一二三四]\$?\s*次(?:より高次|以上)?|高次)\s*の?\s*"
    r"(?:項|べき|冪|まで|の近似)"
    rf"|(?<![A-Za-z\\])\\?([A-Za-z]++)\$?\s*[がは]\s*(?:\$?1\$?\s*(?:に比べ|より|と比べ)\w{{0,3}}?\s*)?(?:十分に?|非常に|充分に?)?\s*小さ"
    rf"|(?<![A-Za-z])(?:wenn|falls|da|weil)\s+{_LETTER}\$?\s+(?:sehr\s+|hinreichend\s+)?klein"
    rf"|(?<![A-Za-z\\])\\?([A-Za-z]++)\$?\s+(?:is|being|ist)\s+(?:much\s+smaller\s+than|small\s+compared\s+(?:with|to)"
    r"|(?:sehr\s+)?viel\s+kleiner\s+als|klein\s+gegen)\s+(?:\$?1|unity|one|eins)",
    re.IGNORECASE,
)
"""Words by which a formula is expanded in a letter: "neglecting higher powers of λ", "λ の高次の項"."""


def small_letters(text: str) -> frozenset[str]:
    """Return the letters that a text calls small: "for small x", "ε ≪ 1", or the ratio λ = r/l.

    Those whose higher powers it neglects are such too.

    >>> sorted(small_letters(r"for small $\\varphi$ and $x \\ll 1$, to first order in $\\mu$"))
    ['mu', 'varphi', 'x']
    """
    text = re.sub(r"[ερλφβδμκ]", lambda sign: GREEK_NAMES[sign.group()], text)
    return frozenset(
        n.replace("{", "").replace("}", "")
        for pattern in (_CALLED_SMALL, _EXPANDED_IN)
        for m in pattern.finditer(text)
        for n in m.groups()
        if n
    )


GREEK_NAMES = {
    "ε": "epsilon", "ρ": "rho", "λ": "lambda", "φ": "phi", "β": "beta", "δ": "delta",
    "μ": "mu", "κ": "kappa",
}  # fmt: skip
HARMONIC = re.compile(r"A_\d{1,3}$")
RANGES = {
    "crank angle": (10, 620),
    "rod ratio l/r": (300, 500),
    "rod ratio l/s": (150, 250),
    "crank ratio r/l": (15, 40),
    "rod length": (300, 500),
    "crank radius": (60, 100),
    "stroke": (120, 200),
}
"""Ranges of values at random points, in hundredths: such that a rod is longer than its crank."""
FEWEST_WORDS = 2
"""Words of a meaning that can be misspelt: one alone (strike, tine) is as likely meant as it stands."""
UNITS = (
    "m",
    "mm",
    "kg",
    "g",
    "s",
    "rpm",
    "rad/s",
    "N",
    "m/s",
    "m/s^2",
    "m/s²",
    "kg m",
    "N m",
    "bar",
    "Pa",
)


CONSTANTS = frozenset({"e", "i", "pi"})
"""Letters that are numbers unless they are declared."""


def conjugate_name(name: str) -> str:
    """Return the letter with the bar that is the conjugate of a complex letter."""
    return f"bar_{name}"


def readable_letters(symbols: Mapping[str, str]) -> frozenset[str]:
    """Return the letters that may be written: those declared, and the conjugates of complex ones."""
    not_real = {conjugate_name(n) for n, text in symbols.items() if role_of(text) == "complex"}
    return frozenset(symbols) | not_real


def settled_letters(symbols: Mapping[str, str]) -> frozenset[str]:
    """Return the letters whose declared meaning settles what they are: all but those that it explains.

    Words that are no known role, "second-order force of the engine", explain a letter without giving
    it a formula. What the page says of it counts as it does of a letter that nobody declared.

    >>> sorted(settled_letters({"r": "crank radius", "k": "letter", "F": "side thrust of the piston"}))
    ['k', 'r']
    """
    return frozenset(name for name, text in symbols.items() if not _explains(name, text))


def _explains(name: str, text: str) -> bool:
    role = role_of(text)
    is_known = role in KNOWN or HARMONIC.match(role) is not None
    return not is_known and name not in CONSTANTS and len(text.split()) >= FEWEST_WORDS


_THE = r"(?:the |an? |its )?"
_ROD = rf"{_THE}(?:connecting[- ]rod|conrod|rod)"
_AXIS = (
    rf"(?:{_THE}(?:cylinder|bore|piston|stroke)(?:'s)?[- ](?:axis|cent(?:re|er)[- ]?line|line)"
    rf"|{_THE}line of stroke|{_THE}axis of {_THE}cylinder|{_THE}vertical|{_THE}cylinder)"
)
_TO_AXIS = rf"(?: (?:to|with|against|from|and) {_AXIS})?"
_PLEUEL = r"(?:des pleuels|der pleuelstange|der schubstange)"
_CRANK = rf"{_THE}crank(?:[- ]?shaft)?"
_SHAFT = rf"(?:{_CRANK}|{_THE}engine(?:'s crankshaft)?)"
_OF_ONE = r"(?: (?:of|per|in) (?:one|each|a|the|single) ?(?:piston|cylinder)| per (?:cylinder|piston))?"
_RATIO_GERMAN = r"(?:schubstangen|pleuelstangen|pleuel)verh(?:ä|ae)ltnis"
_ROD_SIZE = rf"(?:{_ROD}(?: length)?|(?:the )?length of {_ROD})"
_CRANK_SIZE = rf"(?:{_CRANK}(?: radius)?|(?:the )?radius of {_CRANK})"
_OVER = r"(?:over|divided by|by|to|per|durch|zu|sur|divisé par|su|sobre|diviso|÷|/)"
_RADIUS_TERM = (
    rf"(?:{_THE}crank (?:radius|throw)|kurbelradius|rayon (?:de (?:la )?)?manivelle"
    r"|raggio (?:di |della )?manovella|radio (?:de (?:la )?)?(?:manivela|cigüeña))"
)
_ROD_TERM = (
    rf"(?:{_ROD} length|{_THE}length of {_ROD}|pleuel(?:stangen)?länge|(?:schub)?stangenlänge"
    r"|longueur (?:de (?:la )?)?bielle|lunghezza (?:di |della )?biella|longitud (?:de (?:la )?)?biela)"
)
_ALSO_NAMED = r"(?: \([^()]{1,40}\))?"
_TOP = (
    r"(?:tdc|t\.d\.c\.|(?:the |its )?(?:own )?(?:top|upper) dead[- ](?:cent(?:re|er)|point)"
    r"|(?:the )?top dead position)"
)
_OBEN = r"(?:(?:dem |vom )?(?:ot|o\.t\.|oberen totpunkt)|zünd-?ot)"
_OF_ITS_CYLINDER = (
    r"(?: (?:of|in) (?:the|its|each|that|one|a)(?: (?:respective|same|own))? cylinders?"
    r"| (?:des|seines|eines|je)(?: (?:jeweiligen|betreffenden|betrachteten|eigenen|einzelnen))?"
    r" zylinders?)?"
)
_COUNTED = r"(?:(?:measured|counted|reckoned|taken) )?"
_GEZAEHLT = r"(?:(?:gemessen|gezählt) )?"
_FROM_THE_TOP = re.compile(
    rf"(?P<angle>.{{1,60}}?),? \(?{_COUNTED}(?:from|after|past|relative to) {_TOP}{_OF_ITS_CYLINDER}\)?"
    rf"|(?P<winkel>.{{1,60}}?),? \(?{_GEZAEHLT}(?:ab|nach|von|vom) {_OBEN}{_OF_ITS_CYLINDER}(?: aus| an)?"
    rf"(?: (?:gemessen|gezählt))?\)?"
    r"|上死点(?:から|を基準と(?:した|する))(?:測った|測定した|計った|数えた|の)?(?P<kaku>.{1,30})"
    r"|(?P<kakudo>.{1,30}?)[(（]上死点(?:から|基準)(?:の角度|測定)?[)）]"
)
"""An angle with the place it is counted from, where that is the one from which every formula counts."""
_FROM_THE_AXIS = re.compile(
    rf"(?P<angle>.{{1,60}}?),? \(?{_COUNTED}(?:from|relative to) (?:the |its )?"
    r"(?:axis of (?:the|its|one|a|each|that) cylinder(?: (?:looked at|concerned|in question))?"
    r"|cylinder(?:'s)? axis)\)?"
    rf"|(?P<winkel>.{{1,60}}?),? \(?{_GEZAEHLT}(?:ab|von|gegen) (?:der |die )?"
    r"(?:achse (?:des|seines) zylinders|zylinderachse)(?: aus)?\)?"
)
"""The crank's angle with the axis of its cylinder, which has its top dead centre there."""
_SOME_ANGLE = re.compile(
    r"(?:the )?(?:rotation |turning )?angle(?: of rotation)?|(?:dreh)?winkel|回転角度?|角度"
)
"""What only the crank's angle can be where it is counted from the top dead centre."""
_WORDINGS = tuple(
    (role, re.compile(pattern))
    for role, pattern in (
        ("angular speed", rf"(?:(?:constant|steady|uniform) )?angular (?:speed|velocity) of {_SHAFT}"),
        ("angular speed", r"(?:crank|crankshaft) angular (?:speed|velocity)"),
        (
            "angular speed",
            r"winkelgeschwindigkeit(?: der kurbel(?:welle)?)?|(?:クランク(?:軸|シャフト)?の?)?角速度",
        ),
        ("crank angle", rf"(?:rotation )?angle of {_CRANK}|crankshaft angle|kurbelwinkel"),
        ("crank angle", r"クランク(?:軸|シャフト)?の?(?:回転)?角度?"),
        (
            "crank angle",
            r"crank angle of (?:the|one|a|each) (?:single )?cylinder"
            r"(?: (?:looked at|concerned|in question))?"
            r"|kurbelwinkel (?:des|eines|je) (?:betrachteten |einzelnen )?zylinders?",
        ),
        (
            "crank radius",
            rf"radius of {_THE}crank|crank throw|kurbelradius|kurbelhalbmesser|クランクの?半径",
        ),
        ("rod length", rf"length of {_ROD}|(?:connecting-rod|conrod) length"),
        (
            "rod length",
            r"pleuell(?:ä|ae)nge|l(?:ä|ae)nge de[rs] pleuel(?:stange|s)|schubstangenl(?:ä|ae)nge",
        ),
        ("rod length", r"(?:コンロッド|連接棒|連桿)の?長さ"),
        ("rod angle", rf"(?:angle|inclination|obliquity|swing) of {_ROD}{_TO_AXIS}"),
        ("rod angle", rf"(?:connecting[- ]rod|con-?rod|rod) (?:angle|inclination|obliquity){_TO_AXIS}"),
        ("rod angle", rf"angle between {_ROD} and {_AXIS}"),
        (
            "rod angle",
            rf"(?:angle|inclination) (?:between|of) {_ROD} (?:and|to|against|with) "
            rf"{_THE}(?:(?:cylinder|bore|piston)(?: (?:axis|line|cent(?:re|er)[- ]?line))?"
            rf"|(?:cent(?:re|er)[- ]?line|axis)(?: of {_THE}(?:cylinder|bore))?)",
        ),
        ("rod angle", r"pleuel(?:stangen)?winkel|schwenkwinkel(?: (?:des pleuels|der pleuelstange))?"),
        (
            "rod angle",
            rf"(?:neigung|auslenkung|neigungswinkel|winkel) {_PLEUEL}"
            r"(?: (?:gegen|zur)(?: die)? zylinderachse)?",
        ),
        (
            "rod angle",
            r"winkel zwischen (?:dem )?(?:pleuel|der (?:pleuel|schub)stange|pleuelstange|schubstange)"
            r" und (?:der )?(?:zylinder|bohrungs)(?:achse|mitte)",
        ),
        (
            "rod angle",
            r"(?:コンロッド|連接棒|連桿)と(?:シリンダー?|気筒)(?:の?(?:中心)?(?:軸|線)|軸線|中心線)?の?なす角度?",
        ),
        ("rod angle", r"(?:コンロッド|連接棒|連桿)の?(?:傾き|傾斜)?(?:角度?|傾き)"),
        ("stroke", rf"piston stroke|stroke of {_THE}piston|kolbenhub|(?:ピストン)?(?:ストローク|行程)"),
        ("piston velocity", rf"velocity of {_THE}piston|kolbengeschwindigkeit|ピストンの?速度"),
        ("piston acceleration", rf"acceleration of {_THE}piston|kolbenbeschleunigung|ピストンの?加速度"),
        (
            FROM_PIN,
            rf"(?:piston(?:[- ]pin)? (?:position|height)"
            rf"|(?:height|distance|position) of {_THE}(?:piston|(?:piston|gudgeon|wrist)[- ]pin))"
            rf" (?:above|from) {_THE}crank(?:shaft)?(?:'s)? (?:axis|cent(?:re|er)(?:[- ]?line)?)",
        ),
        (
            FROM_PIN,
            r"abstand (?:des kolben(?:s|bolzens)|kolbenbolzen)"
            r" (?:von|über) der kurbelwellen(?:achse|mitte)"
            r"|クランク(?:軸|中心)(?:の?中心)?から(?:の)?ピストン(?:ピン)?(?:まで)?の?(?:距離|高さ|位置)",
        ),
        (FROM_TOP, rf"displacement of {_THE}piston from (?:tdc|(?:the )?top dead cent(?:re|er))"),
        (FROM_TOP, r"kolbenweg ab (?:dem )?(?:ot|oberen totpunkt)|上死点からの(?:ピストンの?)?変位"),
        ("reciprocating mass", rf"(?:reciprocating|oscillating) mass{_OF_ONE}"),
        (
            "reciprocating mass",
            r"oszillierende masse(?: (?:je|pro|eines) (?:zylinders?|kolbens?))?|往復(?:部の?)?質量",
        ),
        (
            "rod ratio l/r",
            rf"(?:(?:rod )?ratio (?:[a-z] ?= ?)?\(?l/r\)?,? (?:of {_ROD_SIZE} (?:to|and) {_CRANK_SIZE})"
            rf"|ratio of {_ROD_SIZE} (?:to|and) {_CRANK_SIZE}(?: \(?l/r\)?)?"
            rf"|{_ROD} to crank ratio \(?l/r\)?)",
        ),
        (
            "crank ratio r/l",
            rf"(?:(?:rod |crank )?ratio (?:[a-zλρ] ?= ?)?\(?r/l\)?,?"
            rf" (?:of {_CRANK_SIZE} (?:to|and) {_ROD_SIZE})"
            rf"|ratio of {_CRANK_SIZE} (?:to|and) {_ROD_SIZE}(?: \(?r/l\)?)?"
            rf"|crank to {_ROD} ratio \(?r/l\)?)",
        ),
        ("crank ratio r/l", rf"{_RADIUS_TERM} {_OVER} {_ROD_TERM}{_ALSO_NAMED}"),
        ("rod ratio l/r", rf"{_ROD_TERM} {_OVER} {_RADIUS_TERM}{_ALSO_NAMED}"),
        ("crank ratio r/l", r"クランク半径[/÷]?(?:と|の)?(?:連接棒|連桿|コンロッド)の?長さの?比(?:r/l)?"),
        ("crank ratio r/l", rf"{_RATIO_GERMAN} \(?r/l\)?"),
        ("rod ratio l/r", rf"{_RATIO_GERMAN} \(?l/r\)?"),
    )
)
"""Fuller wordings of a known meaning. Only such as can mean nothing else: the angular velocity of the rod
is another, and so is the mass of the whole engine."""


def role_of(text: str) -> str:
    """Return the known meaning a declaration states, or its text.

    >>> role_of("Crank radius, half the stroke"), role_of("angular velocity of the crankshaft")
    ('crank radius', 'angular speed')
    >>> role_of("crank angle from top dead centre"), role_of("crank angle from bottom dead centre")
    ('crank angle', 'crank angle from bottom dead centre')
    >>> role_of("crank radius [mm]"), role_of("rod length in mm"), role_of("bore [mm]")
    ('crank radius', 'rod length', 'bore [mm]')
    """
    head = text.split(",", maxsplit=1)[0].strip()
    return _known_role(head) or _role_before_unit(head) or head


def _role_before_unit(head: str) -> str:
    """Return the known meaning before a unit in brackets, or behind "in"; "" for another.

    A speed in revolutions per minute is a letter of its own, for which ω = 2π n/60 has to stand.
    """
    match = _WITH_UNIT.fullmatch(head)
    if match is None:
        return ""
    unit = match["unit"] or match["bare"]
    return "" if "min" in unit or unit == "rpm" else _known_role(match["words"])


@cache
def _known_role(head: str) -> str:
    """Return the known meaning that a declaration's first words state, "" for another."""
    role = " ".join(head.lower().split()).replace(" / ", "/")
    role = ALIASES.get(role, role)
    if role in KNOWN:
        return role
    known = next((known for known, wording in _WORDINGS if wording.fullmatch(role)), "")
    return known or _counted_from_the_top(role)


def _counted_from_the_top(role: str) -> str:
    """Return "crank angle" for one that words count from top dead centre, "" for anything else.

    Counted from the bottom it is another angle, of which no formula here is true.
    """
    of_axis = _FROM_THE_AXIS.fullmatch(role)
    if of_axis is not None:
        is_crank = _known_role(of_axis["angle"] or of_axis["winkel"]) == CRANK_ANGLE
        return CRANK_ANGLE if is_crank else ""
    match = _FROM_THE_TOP.fullmatch(role)
    if match is None:
        return ""
    angle = next(part for part in match.groups() if part)
    is_of_the_crank = _SOME_ANGLE.fullmatch(angle) or _known_role(angle) == CRANK_ANGLE
    return CRANK_ANGLE if is_of_the_crank else ""


_WITH_UNIT = re.compile(
    r"(?P<words>[^\[\](){}]+?)\s*(?:[\[(]\s*(?:in\s+)?(?P<unit>[^\[\](){}\s][^\[\](){}]{0,15})[\])]"
    r"|\sin\s+(?P<bare>mm|cm|m|rad|degrees?|Grad|°|kg|g|s|rad/s|1/s|s\^-1|rpm|1/min|min\^-1|U/min))"
)
"""A meaning with its unit: crank radius [mm], crank angle (rad), rod length in mm."""
SIMILAR = 0.7
"""Of two words, by difflib: cranck and crank are 0.91, piston and position 0.71, rod and road 0.86."""


def misspelt_role(text: str) -> str | None:
    """Return the known meaning that a declaration misspells, None where it states one or another.

    Word for word like a known meaning, but not the same: "cranck angle". A slip would make the letter
    just a letter, and true lines refuted. "variable, cranck angle" is meant as it stands.

    >>> misspelt_role("cranck angle"), misspelt_role("crank angle"), misspelt_role("angle of the bank")
    ('crank angle', None, None)
    """
    role = role_of(text)
    if role in KNOWN or HARMONIC.match(role):
        return None
    with_unit = _WITH_UNIT.fullmatch(role)
    words = (with_unit["words"] if with_unit else role).lower().split()
    if with_unit and " ".join(words) in (*KNOWN, *ALIASES, "engine speed"):
        return None  # "engine speed [rpm]", a letter in its own unit
    near: list[tuple[float, str]] = []
    for known in (*KNOWN, *ALIASES):
        known_words = known.split()
        if len(words) != len(known_words) or len(words) < FEWEST_WORDS:
            continue
        scores = [SequenceMatcher(None, a, b).ratio() for a, b in zip(words, known_words, strict=True)]
        if min(scores) >= SIMILAR:
            near.append((sum(scores), ALIASES.get(known, known)))
    return max(near)[1] if near else None


def letters_by_role(symbols: Mapping[str, str]) -> dict[str, list[str]]:
    """Return the letters of each meaning."""
    letters: dict[str, list[str]] = {}
    for name, text in symbols.items():
        letters.setdefault(role_of(text), []).append(name)
    return letters
