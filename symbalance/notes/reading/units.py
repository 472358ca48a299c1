"""Units behind numbers, read as factors: 40 mm is 40·(1/1000), 6000 rpm is 6000·(π/30), 3 N is 3."""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from functools import lru_cache

from symbalance.document.wordlists import word_set, words
from symbalance.notes.reading.signs import VULGAR
from symbalance.text import lazy_patterns as re

Scale = tuple[Fraction, bool]
"""The factor to the unit without prefix, and whether π multiplies it."""

_PREFIXES = {
    "": Fraction(1), "k": Fraction(10**3), "M": Fraction(10**6), "G": Fraction(10**9),
    "c": Fraction(1, 100), "d": Fraction(1, 10), "m": Fraction(1, 10**3), "u": Fraction(1, 10**6),
    "n": Fraction(1, 10**9),
}  # fmt: skip
_PREFIXED = {"m", "s", "N", "J", "W", "Pa", "rad", "Hz", "Nm", "Ns"}
_OTHER: dict[str, Fraction] = {
    "min": Fraction(60), "h": Fraction(3600), "bar": Fraction(10**5), "K": Fraction(1),
    "cc": Fraction(1, 10**6), "ccm": Fraction(1, 10**6), "oz": Fraction(45359237, 16 * 10**8),
    "Nmm": Fraction(1, 1000), "kNmm": Fraction(1), "gmm": Fraction(1, 10**6), "kgmm": Fraction(1, 1000),
    "mbar": Fraction(100), "hPa": Fraction(100), "daN": Fraction(10), "Ncm": Fraction(1, 100),
    "Wh": Fraction(3600), "ml": Fraction(1, 10**6), "cl": Fraction(1, 10**5), "kWh": Fraction(36 * 10**5),
    "gcm": Fraction(1, 10**5), "kgcm": Fraction(1, 100), "mkg": Fraction(1), "cmkg": Fraction(1, 100),
    "sec": Fraction(1), "ft": Fraction(3048, 10**4), "lb": Fraction(45359237, 10**8),
    "lbs": Fraction(45359237, 10**8), "lbf": Fraction(44482216152605, 10**13),
    "inch": Fraction(254, 10**4), "ton": 2240 * Fraction(45359237, 10**8),
    "kp": Fraction(980665, 10**5), "kgf": Fraction(980665, 10**5), "PS": Fraction(73549875, 10**5),
    "psi": Fraction(44482216152605, 10**13) / Fraction(254, 10**4) ** 2, "mph": Fraction(44704, 10**5),
    "tf": Fraction(980665, 100),
    "mol": Fraction(1), "kmol": Fraction(1000),
    "mi": Fraction(1609344, 1000), "knot": Fraction(1852, 3600), "knots": Fraction(1852, 3600),
    }  # fmt: skip
"""A ton is the long one of 2240 lb; where a page converts one, the short and the metric ton count too."""
_OTHER |= dict.fromkeys(words("CV ch"), _OTHER["PS"])
_OTHER |= dict.fromkeys(words("slug slugs"), _OTHER["lbf"] / _OTHER["ft"])
_HORSEPOWER = 550 * _OTHER["ft"] * _OTHER["lbf"]
_OTHER |= dict.fromkeys(words("hp bhp HP"), _HORSEPOWER)
INCH = Fraction(254, 10**4)
_IN_COMPOUNDS = {"in": INCH}
"""Units whose name is a word of the language: read beside another unit only, in/s², lb·in."""
_UNITS = {p + unit: scale for unit in _PREFIXED for p, scale in _PREFIXES.items()} | _OTHER
_UNITS["G"] = Fraction(1)
GRAVITY = Fraction(980665, 10**5)
"""What a multiple of g, 888 g of an acceleration, multiplies its number by."""
_UNITS["gn"] = GRAVITY
_SPELLED = {
    "litre litres liter liters Liter Litern": Fraction(1, 1000),
    "newton newtons Newton": Fraction(1),
    "kilonewton kilonewtons Kilonewton": Fraction(1000),
    "millimetre millimetres millimeter millimeters Millimeter": Fraction(1, 1000),
    "centimetre centimetres centimeter centimeters Zentimeter": Fraction(1, 100),
    "metre metres meter meters Meter": Fraction(1),
    "kilogram kilograms kilogramme kilogrammes Kilogramm": Fraction(1),
    "gram grams gramme grammes Gramm": Fraction(1, 1000),
}  # fmt: skip
_UNITS |= {word: scale for spelled, scale in _SPELLED.items() for word in words(spelled)}
_UNITS |= {p + "g": scale / 1000 for p, scale in _PREFIXES.items()}
_ELECTRIC = {"V": "volt", "A": "ampere", "Ω": "ohm", "\u2126": "ohm"}
"""Signs that are letters of most formulas, and the names by which they are looked up as units."""
_UNITS |= {p + name: scale for name in _ELECTRIC.values() for p, scale in _PREFIXES.items()}
_ELECTRIC_PART = re.compile(r"(?<![^\W\d_])([kMGmunµμ]?)([VAΩ\u2126])(?![^\W\d_])")
USUAL_SCALES = tuple(
    sorted(
        {
            *(Fraction(10) ** k for k in (-9, -6, -4, -3, -2, 3, 6, 9)),
            *_OTHER.values(),
            _IN_COMPOUNDS["in"],
            *(size**power for size in (_OTHER["ft"], _IN_COMPOUNDS["in"]) for power in (2, 3)),
            _OTHER["lbf"] * _OTHER["ft"],
            _OTHER["lbf"] * _IN_COMPOUNDS["in"],
        }
        - {1}
    )
)
"""What the usual units multiply a number by that is typed without one."""
_TURNS = {**dict.fromkeys(words("rpm 1/min min^-1 r/min rev/min U/min tr/min Umin^-1"), Fraction(1, 30))}
_TURNS |= dict.fromkeys(words("Umdr/min Umd/min U/Min r.p.m. rpm. cpm"), Fraction(1, 30))
_PRESSURES = {
    f"{pound}/{length}^2": _OTHER["lbf"] / size**2
    for pound in ("lb", "lbs")
    for length, size in (("in", _IN_COMPOUNDS["in"]), ("inch", _OTHER["inch"]), ("ft", _OTHER["ft"]))
}
"""Pounds on an area are forces, though a pound is a mass elsewhere."""
_BY_THE_SECOND = word_set("rps r.p.s. rev/s U/s tr/s Umdr/s giri/s")
"""Revolutions per second, which are counted as hertz are: N = 50 rev/s, and ω = 2πN."""
_ANGLES = {"deg": Fraction(1, 180)}
_PLAIN_SURE = word_set(
    "mm cm km kg cc ccm oz rpm kW kHz Hz kN Nm rad lbs lb ft psi kgf mph bar mbar kPa MPa GPa"
)

_PREPOSITION = re.compile(r"in (?!lbs?\b|lbf\b|ozf?\b|kips?\b)")
"""What is in a unit, 30 in rad/s; inches stand before pounds and ounces alone."""
_MOST_PARTS, _LONGEST = 6, 100

_PART = re.compile(r"(1(?=/)|[A-Za-z]+)(?:\^(-?[0-9]))?")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−µμ", "0123456789--uu")
_RAISED_RUN = re.compile("[⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]")
_RAISED_PART = re.compile(r"(\^-?[0-9])(?=[A-Za-z])")
"""An exponent with the next unit right behind it, as in kg²m⁴."""
_INNER_FONT = re.compile(r"\\(?:mathrm|text|textrm|rm)(?![A-Za-z])")
_SEPARATOR = re.compile(r"\\[,;: ]|~|\\cdot(?![A-Za-z])|[·⋅・*.\s]")
_COMMAND = r"\\(?:mathrm|text|textrm|mbox|unit|si)\s*"
_ARGUMENT = (
    r"(?:\{(?P<word>(?:[^{}]|\{[^{}]{0,20}\}){1,60})\}|(?<=\s)[A-Za-z](?![A-Za-z]))"
    r"(?:\s*\^\s*(?:\{\s*[-−]?\s*[0-9]\s*\}|[0-9]))?"
)
_SET = re.compile(rf"{_COMMAND}{_ARGUMENT}")
_UNNAMED = _SET.pattern.replace("?P<word>", "?:")
_FRACTION = re.compile(rf"\\[dt]?frac\s*\{{\s*({_UNNAMED}|1)\s*\}}\s*\{{\s*({_UNNAMED})\s*\}}")
_PLAIN_FRACTION = re.compile(
    r"\\[dt]?frac\s*\{\s*((?:k?N|k?N\s*m|rad|[kmc]?m|k?g|kg\s*m|k?J|k?W|1|U|Umdr?\.?)"
    r"(?:\s*\^\s*(?:\{[23]\}|[23]))?)\s*\}"
    r"\s*\{\s*((?:m?s|min|m|[cm]m|kg|rad|h)(?:\s*\^\s*(?:\{[234]\}|[234]))?)\s*\}"
)
_MORE = re.compile(rf"(?:\\[,;: ]|~|\\cdot(?![A-Za-z])|[·/\s]){{0,6}}{_COMMAND}{_ARGUMENT}")
_BRACKETED = re.compile(rf"\[\s*(?:{_UNNAMED}|[A-Za-zµμ/^0-9·⁻¹² -]{{1,20}})\s*\]")
_RAISED_UNIT = r"(?:\^\{[-−]?[0-9]\}|\^[-−]?[0-9]|\^\([-−]?[0-9]\)|[⁻]?[¹²³⁴])"
_PART_OF_UNIT = rf"[A-Za-zµμ]+{_RAISED_UNIT}?"
_PLAIN_UNIT = re.compile(
    rf"(?P<space>[ \u2009\u202f\u205f]?)(?P<plain>(?:1/)?{_PART_OF_UNIT}"
    rf"(?:(?:/|[·⋅・*]|[ \u2009\u202f](?=(?:[cm]?m|s|g|kg|rad|ft)(?![A-Za-z]))){_PART_OF_UNIT}){{0,3}})"
    r"(?![A-Za-z0-9_('^′⁻¹²³⁴])"
)
_NUMBER_BEFORE = re.compile(
    rf"(?<![A-Za-z_^\w])(?P<digits>[0-9][0-9.,]*[{''.join(VULGAR)}]?|[{''.join(VULGAR)}])$"
)
_POWER_BEFORE = re.compile(r"[0-9)\]](?:\^\{?[0-9]\}?|[²³⁴])$|[)\]]$|(?<![A-Za-z])[0-9.,]*π$")
_SPACE_BEFORE = re.compile(r"(?:\\[,;: ]|~)+$")
_POWER_OF_TEN = re.compile(r"(?<![\w.])(?P<digits>10(?:\^\{?[-−]?[0-9]{1,2}\}?|⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]))$")
_HEAD = re.compile(r"(?:^|[^\w\\])([^\W\d_])[\w'′]*\s*(?:=|≈)\s*[-−]?[0-9.,]+$")
_UNIT_AROUND = re.compile(
    r"(?<=[0-9)])(?:\s|\\[,;: ]|~|\\mathrm\{|\\frac\{){0,2}(?:mm|cm|km|kg|rpm|k?W|k?Hz|k?N|k?Nm|k?J|rad"
    r"|m\}\{s|[kM]Pa|bar|m/s|U/min|1/s|1/min|(?:s|min)⁻¹|ms|min)"
    r"(?![A-Za-z0-9_(])"
)
_DIVIDED_ON = re.compile(r"(?:\s|~|\\[,;: ])*/\s*[0-9(]")
_UNIT_LETTERS = "NWJKTVCAmsgh"
_SIZES = (
    "speed|revolutions|torque|moment|force|mass|weight|work|volume|area|number|energy|temperature"
    "|pressure|height|Drehzahl|Drehmoment|Moment|Kraft|Masse|Gewicht|Arbeit|Volumen|Fläche|Anzahl|Energie"
    "|Temperatur|Höhe|Hub"
)
_EXPLAINED = re.compile(
    rf"(?<![\w\\])(?<![0-9.,][ ~])(?P<first>[{_UNIT_LETTERS}])\s+"
    r"(?:is|be|being|denotes|stands\s+for|ist|sei|bezeichnet|rev(?:olutions?|s)?\.?|r\.\s?p\.\s?m|cylinders?|cranks?|throws?|Umdrehungen|Zylinder)(?![A-Za-z])"
    rf"|(?:(?<![A-Za-z])(?:and|where|with|und|wo|mit)|,)\s+(?P<third>[{_UNIT_LETTERS}])\s+"
    r"(?:the|an?|der|die|das|eine?)(?=\s)"
    rf"|(?<![A-Za-z])(?:{_SIZES})\s+(?P<second>[{_UNIT_LETTERS}])(?![\w'(])",
)
"""Where words say what a letter is that is also the sign of a unit: N revolutions, a force W."""
_HEIGHT = re.compile(r"(?<![A-Za-z0-9\\_/{])h[ ]?\$?[ ]?=(?!=)")
_LITRE = re.compile(
    r"(?:[ ~\u2009\u202f]|\\[,;: ])?(?:\\mathrm\{[lL]\}|[lL])(?=[\s.,;)$=≈]|$)"
    r"(?![ ]?[A-Za-z(\\](?![A-Za-z]))"
)
_VOLUME = re.compile(
    r"(?<![A-Za-z])V(?:_\{?\w+\}?|[₀-₉]+)?['′]?\s*(?:&\s*)?(?:=|≈|\\approx)"
    r"|[0-9]\s?(?:\\[,;: ]|\\mathrm\{)*(?:[mcd]?m|inch|ft)(?:³|\^\{?3)|[0-9]\s?cc(?![a-z])"
)
_MASS = re.compile(
    r"(?<![A-Za-z])[mM](?:_\{?\w+\}?|[₀-₉]+)?['′]?\s*(?:&\s*)?(?:=|≈|\\approx)|[0-9]\s?(?:kg|lbs?|oz)(?![\w/·])"
)
_GRAVITY = re.compile(r"(?:[ ~]|\\[,;: ])?[gG](?=[\s.,;)$=≈]|$)(?![ ]?[A-Za-z(\\](?![A-Za-z]))")
_ACCELERATION = re.compile(
    r"m/s(?:²|\^\{?2\}?|\$\^2\$)[\s}$]*\(?\$?(?:=|≈|\\approx)\s*\$?[-−]?[0-9.,]+"
    r"(?:\s[0-9]{3})*(?:\\[,;: ]|[ ~])*$"
)
_OVER_GRAVITY = re.compile(
    r"(?:/|÷|\}\{)[ ]?9[.,]8[0-9]{0,3}[ ]?\}?[ $]*(?:=|≈|\\approx)[ $]*[0-9][0-9.,]*(?:\\[,;: ]|[ ~])*$"
)
"""What stands before the g of 45 139/9.81 ≈ 4600 g: how many times gravity it is."""
_TIMES_LENGTH = re.compile(r"[ ]?[·×*xX]?[ ]?(?:[0-9][0-9.,]*[ ]?)?[cm]m(?![\w/])")
_COMPUTED = re.compile(
    r"(?:\\(?:cdot|times|approx|left|right)(?![A-Za-z])|\\[,;: ]|(?<=[0-9])[ ]?g(?![A-Za-z])"
    r"|[0-9.,()+\-−·×*/=≈$ ])*[=≈][ $]*[0-9.,]+$"
)
_SUM_OF_GRAMS = re.compile(r"[0-9][ ~]?g[ ]?[+\-−][ ]*[0-9.,]+$")
_ADDED_GRAMS = re.compile(r"[ ]?[+\-−][ ]?[0-9.,]+[ ~]?g(?![A-Za-z])")
_BEHIND_GRAM = re.compile(r"\\[a-z]+|(?<=[0-9])[ ]?g(?![A-Za-z])")
_LETTERS = re.compile(r"[^\W\d_]")
_IN_OUNCES = re.compile(r"[ $]*(?:[=≈]|\\approx)[ $]*[0-9.,]+[ ]?(?:oz|ounces?|lbs?|k?g)(?![A-Za-z])")
_OF_GRAMS = re.compile(
    r"(?<![A-Za-z])(?:grams?|grammes?|Gramm)(?![A-Za-z])|[\[(]g[\])]"
    r"|[0-9][ ~]?g[ ·]?(?:[cm]m(?![A-Za-z])|/c)"
    r"|[0-9][ ~]?(?:lbs?|oz|kg)[ ]*[=≈][ ]*[0-9.,]+[ ]?g(?![A-Za-z])"
    r"|(?<![A-Za-z])[mM](?:_\{?\w+\}?|[₀-₉]+)?[ ]*[=≈][ ]*\$?[0-9.,]+\$?[ ~]?g(?![A-Za-z])"
    r"|(?:[Ww]eigh[a-z]*|[Mm]ass(?:es|en|e)?|Gewichte?|wieg(?:t|en)|p[eè]se(?:nt)?|pesan?o?)(?![A-Za-z])"
    r"[^\n=]{0,60}(?:=[ ]?\$?)?[0-9.,]*[0-9]\$?[ ~]?g(?![A-Za-z/])"
)
_OF_GRAVITY = re.compile(
    r"\b(?:[Aa]ccelerations?|[Bb]eschleunigung(?:en)?|[Vv]erzögerung|[Dd]eceleration)"
    r"[^\n]{0,60}[0-9][ ~]?\$?[ ]?g(?![A-Za-z/])"
    r"|(?<![A-Za-z\\_])g[ ]*(?:=|≈|\\approx)[ ]*\$?9[.,]8|(?:[*·/]|\((?!g\)))[ ]*g(?![A-Za-z])"
    r"|(?<![A-Za-z\\0-9])(?<![0-9][ ~])g[ ]*[·*(]"
    r"|m/s(?:²|\^\{?2\}?)[ $,]*(?:=|≈|,|\()[^\n=]{0,20}[0-9][ ]?g(?![A-Za-z/])"
)


_LETTER_SET = re.compile(r"(?<![\w\\{^./·*+\-−])(?<![\w\\{^./·*+\-−] )([A-Za-z])(?: ?&)? ?=(?!=)")
_SUM_BEFORE = re.compile(r"[(\[][^()\[\]\n=]*[+\-−] ?[0-9][0-9.,{}]*(?: |~|\\[,;: ])*$")
_CLOSED = re.compile(r"(?: |\\right)*[)\]]")


@lru_cache(maxsize=8)
def speaks_of_grams(text: str) -> bool:
    """Tell whether a text weighs in grams, and has no g for the acceleration of gravity.

    >>> speaks_of_grams("1 lb = 453.6 g; | piston (g) |"), speaks_of_grams("in grams, g = 9.81")
    (True, False)
    """
    return _OF_GRAMS.search(text) is not None and _OF_GRAVITY.search(text) is None


_FRACTION_BEFORE = (
    rf"(?:\\[dt]?frac\s?(?:\{{\s?[0-9]{{1,2}}\s?\}}\s?\{{\s?[0-9]{{1,2}}\s?\}}|[0-9]\s?[0-9])|[0-9]{{1,2}}/[0-9]{{1,2}}"
    rf"|[{''.join(VULGAR)}])"
)
_MULTIPLE_BEFORE = re.compile(
    rf"(?<![\w.,^_/])(?:(?P<fraction>{_FRACTION_BEFORE})|(?P<count>[0-9]{{1,2}})|(?P<decimal>[0-9]+[.,][0-9]+))"
    r"(?:\s|~|\\[,;: ]|\\!)*$"
)
_SUBSCRIPT = (
    r"(?:_(?:\{(?:[^{}]|\{[^{}]{0,20}\}){1,30}\}|\\[a-z]+\s?\{[^{}]{1,20}\}|\w{1,8})"
    r"|['′]|[₀-₉]|[0-9]{1,2})"
)
_TERM_BEFORE = re.compile(
    rf"(?<![A-Za-z\\])(?P<stem>[A-Za-z]){_SUBSCRIPT}(?:\s|~|\\[,;: ])*[+\-−](?:\s|~|\\[,;: ])*$"
)
_TERM_BEHIND = re.compile(rf"(?:\s|~|\\[,;: ])*[+\-−](?:\s|~|\\[,;: ])*(?P<stem>[A-Za-z]){_SUBSCRIPT}")
_ALONE_BEFORE = re.compile(
    rf"(?:^|[^\w\\}}])(?P<stem>[^\W\d_])(?P<below>{_SUBSCRIPT})?"
    r"(?:\s|&|~)*(?:=|≈|\\approx)(?:\s|&|~|\\[,;: ])*$"
)
_PRODUCT_BEFORE = re.compile(r"[A-Za-z}}](?:\s|~|\\[,;: ])*(?:[·⋅×*]|\\cdot|\\times)(?:\s|~|\\[,;: ])*$")
_TERM_OF_SUM = re.compile(r"[A-Za-z}](?:\s|~|\\[,;: ])*[+\-−](?:\s|~|\\[,;: ])*$")
_ENDS = re.compile(r"(?:\s|~|\\[,;: !]|\\right)*(?:[=≈.,;:)\]$+\-−]|\\(?:approx|q?quad|\\|\)|\])|$)")
_HEADS_IN = {
    "m": "lrsxyzabcdhDLRHBeuλfkpqtwδ", "s": "tTτ", "h": "tT", "N": "FNPRQSVGWTB", "g": "mMGab",
    "J": "JWEQAT", "W": "PWQ", "K": "TKϑθ", "A": "IA", "V": "UV", "C": "QCT", "t": "mM", "T": "BT",
}  # fmt: skip
"""Letters that may have a value in each unit: l = 2 m is a length, but M = 2 m twice the page's m."""


_LETTER_NAMED = re.compile(r"(?<=[^\W\d_]{3}[ ])([A-Za-z])(?: ?&)?[ ]?=(?!=)")
"""A letter behind the word that names it: the stroke s = 80 mm."""


_SIDE_BY_SIDE = re.compile(r"[ms](?:[ ·⋅*][gsm])+")
"""Letters in a row, 3 m g, of which nobody makes a unit; m s⁻² has an exponent."""


@lru_cache(maxsize=8)
def _letters_of_page(text: str) -> frozenset[str]:
    named = frozenset(match[1] for match in _LETTER_NAMED.finditer(text))
    return explained_letters(text) | letters_in_formulas(text) | _letters_with_values(text) | named


def is_multiple_of_letter(text: str, place: int, end: int) -> bool:
    r"""Tell whether the one letter at a place, behind a number, is no unit by the formula it ends.

    It is a letter in a sum with its own kind, m_r + 0.5 m, and in m_2 = 2 m. It is one as well where the
    page has it as a letter, and its number is a fraction or small: ½ m, A · 2 s, M = 4 m.

    >>> is_multiple_of_letter("x = m_1 + 0.5 m", 14, 15), is_multiple_of_letter("l = 0.5 m", 8, 9)
    (True, False)
    """
    letter = text[place : place + 1]
    if _fills_group(text, place):
        return True
    may_end = letter in _HEADS_IN and _ENDS.match(text, place + 1, max(end, place + 1)) is not None
    first = max(place - 120, text.rfind("\n", 0, place) + 1)
    number = _MULTIPLE_BEFORE.search(text, first, place) if may_end else None
    if number is None:
        return False
    before = text[first : number.start()]
    terms = _TERM_BEFORE.search(before), _TERM_BEHIND.match(text, place + 1, end)
    head = _ALONE_BEFORE.search(before)
    kin = [term["stem"] for term in terms if term] + ([head["stem"]] if head and head["below"] else [])
    if letter in kin and letter not in "NJWKVCT":  # N_2 = 3 N is a force
        return True
    if letter not in _letters_of_page(text):
        return False
    if head is not None:  # a force or an energy may have any capital letter
        is_sure = letter.islower() or head["stem"].islower() or bool(number["fraction"])
        return is_sure and head["stem"] not in _HEADS_IN[letter]
    is_product = any(p.search(before) for p in (_PRODUCT_BEFORE, _TERM_OF_SUM))
    return not number["decimal"] and (bool(number["fraction"]) or is_product)


def _fills_group(text: str, place: int) -> bool:
    r"""Tell whether 2s is all of a group, \frac{v^2}{2s} or v²/(2s), on a page with s = 90 mm.

    Two seconds there would have a number with its unit above: \frac{100 m}{2s} is a speed.
    """
    is_whole = text[place + 1 : place + 2] in ("}", ")") and text[place - 1 : place].isdecimal()
    if not is_whole or text[place] not in _letters_with_values(text):
        return False
    opened = _GROUP_OPENED.search(text, max(0, place - 60), place)
    return opened is not None and _UNIT_AROUND.search(opened["above"] or "") is None


_SECOND_VALUE = re.compile(r"\s*\(\s*[0-9][0-9.,]*\s*[A-Za-zµ/²³^0-9]{1,8}\.?\s*\)")
"""The same quantity once more behind a unit: 6217 N (6.2 kN)."""
_STOPS = "=≈≒≃<>≤≥≡+-−–·×*/÷)]},;.:!?|&、。，；：…"
"""Signs that may stand behind a unit; a letter there goes on with a product."""


def scale_of(unit: str) -> Scale | None:
    """Return what a unit multiplies its number by, None for no unit.

    >>> scale_of("mm"), scale_of("m/s^2"), scale_of("rpm"), scale_of("furlong")
    ((Fraction(1, 1000), False), (Fraction(1, 1), False), (Fraction(1, 30), True), None)
    """
    plain = _plain(unit)
    if len(plain) > _LONGEST or _PREPOSITION.match(plain):
        return None
    if plain in _TURNS or plain in _ANGLES:
        return _TURNS.get(plain) or _ANGLES[plain], True
    if plain in _PRESSURES or plain in _BY_THE_SECOND:
        return _PRESSURES.get(plain, Fraction(1)), False
    scale, place, power = Fraction(1), 0, 1
    while place < len(plain):
        match = _PART.match(plain, place)
        size = match and (Fraction(1) if match.group(1) == "1" else _size(match.group(1), plain))
        if not match or not size:
            return None
        scale *= size ** (power * int(match.group(2) or 1))
        place = match.end()
        sign = plain[place : place + 1]
        if sign and sign not in " /":
            return None
        power, place = (-1 if sign == "/" else 1), place + 1
    return (scale, False) if plain and plain[-1] not in " /" else None


def _size(word: str, unit: str) -> Fraction | None:
    """Return what one word of a unit multiplies by."""
    return _UNITS.get(word) or (_IN_COMPOUNDS.get(word) if word != unit else None)


_BELOW = re.compile(
    r"/(?:\s|~|\\[,;: ])*\((?P<parts>[^()/]{1,40})(?:/\s*(?P<above>[^()/\s]{1,8})\s*)?\)(?![\w^²³])"
)
_BETWEEN = re.compile(r"(?:\s|~|\\[,;: ]|[·⋅*.]|\\(?:cdot|times)(?![A-Za-z]))+")


def divisors_apart(unit: str) -> str:
    """Return a unit with a stroke before each part below its stroke, where brackets hold several.

    >>> divisors_apart("J/(kg K)"), divisors_apart("N/(m/s)"), divisors_apart("N/m")
    ('J/kg/K', 'N s/m', 'N/m')
    """

    def apart(match: re.Match[str]) -> str:
        parts = [part for part in _BETWEEN.split(match["parts"].strip()) if part]
        above = f" {match['above']}" if match["above"] else ""
        return above + "".join(f"/{part}" for part in parts)

    return _BELOW.sub(apart, unit) if "(" in unit else unit


def _plain(unit: str) -> str:
    """Return a unit without LaTeX: one space between the parts of a product."""
    text = re.sub(r"\\mu\s*", "u", _INNER_FONT.sub("", divisors_apart(unit)))
    text = _RAISED_RUN.sub(lambda match: "^" + match.group(), text)
    text = _SEPARATOR.sub(" ", text.translate(_RAISED))
    text = _RAISED_PART.sub(r"\1 ", text.replace("{", "").replace("}", ""))
    return re.sub(r"\s*([/^-])\s*", r"\1", re.sub(r"\s+", " ", text)).strip()


@lru_cache(maxsize=8)
def explained_letters(text: str) -> frozenset[str]:
    """Return the letters of units that a text explains as letters of its own.

    >>> sorted(explained_letters("at N revolutions per minute the weight W, a force of 3 N is small"))
    ['N', 'W']
    """
    return frozenset(m["first"] or m["second"] or m["third"] for m in _EXPLAINED.finditer(text))


_SET_ALONE = {"l": "dm^3", "L": "dm^3", "t": "Mg"}
"""Litres and tonnes, letters elsewhere: read where they are set upright behind a number."""


_TO = r"\\(?:to|rightarrow|geq?|leq?|in)(?![A-Za-z])"
_NUMERATOR = r"(?:[0-9]|\{[^{}]{0,30}[0-9][^{}]{0,30}\})"
_IN_FORMULAS = re.compile(
    rf"(?<![0-9][ ~])(?<![0-9])(?<!\bin )\$(?P<lone>[{_UNIT_LETTERS}])\$(?<![0-9]\$\s\$.\$)"
    rf"|(?<![\w\\])(?<![0-9][ ~])(?P<tending>[{_UNIT_LETTERS}])[ ]?{_TO}"
    rf"|\\[dt]?frac[ ]?{_NUMERATOR}[ ]?\{{?[ ]?(?P<below>[{_UNIT_LETTERS}])(?=[\s}}$+)=]|$)"
    rf"|\^(?:\{{[0-9]?)?(?P<bound>[{_UNIT_LETTERS}])(?=[\s}}+$)-])"
)
_GROUP_OPENED = re.compile(
    r"(?:\\[dt]?frac\s*(?:\{(?P<above>[^{}]*(?:\{[^{}]*\}[^{}]*)*)\})?\s*\{|\\sqrt\s*\{\s*\\[dt]?frac\s*\{|/\s*\(|\()\s*[0-9]$"
)
"""A group that nothing but a number has been typed in: \\frac{v^2}{2, v²/(2."""
_LONE_SIZE = re.compile(r"(?:=|≈|\\approx(?![A-Za-z]))[ ]?[-−]?[0-9.,]+$")


@lru_cache(maxsize=8)
def letters_in_formulas(text: str) -> frozenset[str]:
    r"""Return the letters of units that formulas use as letters: $N$, N \to \infty, 1/N, a sum to N.

    >>> sorted(letters_in_formulas(r"the $N$ cylinders, \frac{3}{K}, \mathrm{W}, 3 N, $5$ $m$"))
    ['K', 'N']
    """
    return frozenset(letter for m in _IN_FORMULAS.finditer(text) for letter in m.groups() if letter)


@lru_cache(maxsize=8)
def _letters_with_values(text: str) -> frozenset[str]:
    """Return the single letters that a text sets equal to something: m = 0.7 kg, but not F_m = 3 N."""
    return frozenset(match[1] for match in _LETTER_SET.finditer(text))


_SIZE_AWAY = re.compile(
    rf"[0-9](?:\s|~|\$|\\[,;: ]){{0,4}}(?P<unit>{_PART_OF_UNIT}(?:[/·⋅*]{_PART_OF_UNIT}"
    rf"| (?:[cm]?m|s|k?g){_RAISED_UNIT}?(?![A-Za-z])){{0,3}})"
    r"|\\(?:math\w+|text\w*|mbox|unit|si)\s*\{[^{}]{0,60}\}|\\[A-Za-z]+"
    rf"|\bin \$?{_PART_OF_UNIT}(?:[/·⋅*]{_PART_OF_UNIT}){{0,3}}|\[[A-Za-z/²³^0-9· ]{{1,12}}\]"
)
_ALONE = re.compile(r"(?<![A-Za-z_'’\\])(?<!_\{)([A-Za-z])(?![A-Za-z'’])")


@lru_cache(maxsize=8)
def letters_alone(text: str) -> frozenset[str]:
    r"""Return the letters that a text has singly, behind no number: those of its formulas, and of words.

    >>> sorted(letters_alone(r"$(k-m\omega^2)^2$, c = 2\,\mathrm{N}, r = 40 m/s, F_g in N"))
    ['F', 'c', 'k', 'm', 'r']
    """

    def beside(match: re.Match[str]) -> str:
        return match[0] if match["unit"] and not scale_of(match["unit"]) else " "

    return frozenset(_ALONE.findall(_SIZE_AWAY.sub(beside, text)))


def are_letters_behind_number(text: str, place: int, word: str) -> bool:
    """Tell whether a word like a unit, right behind a count, is made of letters that a text has alone."""
    is_counted = text[max(place - 1, 0) : place].isdecimal()
    is_like = is_counted and _TYPED_LIKE_LETTERS.fullmatch(word) is not None
    return is_like and set(word) <= letters_alone(text)


_HEADS_OF_UNITS = {"Nm": "MTWEQJ", "Ns": "pSILH", "l": "V", **_HEADS_IN}
_TYPED_LIKE_LETTERS = re.compile(r"[kcdmnMG][msNJWgl]|N[ms]|[JWNKVAh]")
_SIDE_BEFORE = re.compile(r"(?:=|≈|<|>|≤|≥|\\(?:approx|leq?|geq?)(?![A-Za-z]))(?=[^=≈<>≤≥\n$]*$)")


def unit_set_at(text: str, place: int, end: int) -> tuple[str, int] | None:
    """Return the unit in \\mathrm{ } and its kin at a place, and where it ends; None if none begins."""
    match = _SET.match(text, place, end)
    if not match:
        return None
    if match["word"] in _SET_ALONE and text[max(place - 8, 0) : place].rstrip("\\,;: ~")[-1:].isdecimal():
        return _SET_ALONE[match["word"]], match.end()
    stop = match.end()
    for _ in range(_MOST_PARTS):
        more = _MORE.match(text, stop, end)
        if not more or not scale_of(more.group("word") or "?"):
            break
        stop = more.end()
    unit = _bare(text[place:stop])
    return (with_electric_names(unit) if is_set_apart(text, place) else unit), stop


def with_electric_names(unit: str) -> str:
    r"""Return a unit with its volts, amperes and ohms by name: these are read in units set apart alone.

    >>> with_electric_names("kV"), with_electric_names(r"V/\Omega"), with_electric_names("mm")
    ('kvolt', 'volt/ohm', 'mm')
    """
    plain = re.sub(r"\\Omega(?![A-Za-z])", "Ω", unit)
    return _ELECTRIC_PART.sub(lambda m: m[1].translate(_RAISED) + _ELECTRIC[m[2]], plain)


def unit_fraction_at(
    text: str, place: int, end: int, names: Collection[str] = ()
) -> tuple[str, int] | None:
    """Return the unit \\frac{\\mathrm{m}}{\\mathrm{s}^2} at a place as m/s^2, and where it ends.

    In plain letters, \\frac{m}{s^2}, it is one where these are no letters of the document.
    """
    match = _FRACTION.match(text, place, end)
    if match is None and (plain := _PLAIN_FRACTION.match(text, place, end)):
        unit = f"{_plain(plain[1])}/{_plain(plain[2])}"
        number = _NUMBER_BEFORE.search(
            re.sub(r"(?:\s|~|\\[,;: ])+$", "", text[max(place - 40, 0) : place])
        )
        sort = _PlainUnit(text, place, plain.end(), unit, True, number, end)
        return (unit, plain.end()) if scale_of(unit) and sort.is_unit(names) else None
    unit = f"{_bare(match.group(1))}/{_bare(match.group(2))}" if match else ""
    return (unit, match.end()) if match and scale_of(unit) else None


def _bare(unit: str) -> str:
    return re.sub(_COMMAND, "", unit)


def bracketed_unit_at(text: str, place: int, end: int) -> tuple[str, int] | None:
    """Return the unit in [mm] at a place, and where the brackets end; None if it is no unit."""
    match = _BRACKETED.match(text, place, end)
    if not match:
        return None
    unit = _bare(match.group()[1:-1])
    return (unit, match.end()) if scale_of(unit) else None


def plain_unit_at(text: str, place: int, end: int, names: Collection[str]) -> tuple[str, int] | None:
    """Return the unit in `40 mm` or `40mm` behind the number, and where it ends; None for letters.

    Declared letters are letters, but not where they can be none: 565 s⁻¹ is nothing but a quantity.

    >>> plain_unit_at("0.04 m · 3 kg", 4, 13, {"r"}), plain_unit_at("2 m r", 1, 5, {"m", "r"})
    (('m', 6), None)
    """
    if litres := _litres_at(text, place, end):
        return litres
    gravity = _GRAVITY.match(text, place, end)
    if gravity and _ACCELERATION.search(text[max(place - 60, 0) : place]):
        return "gn", gravity.end()
    if gravity and _OVER_GRAVITY.search(text[max(place - 60, 0) : place]):
        return "G", gravity.end()
    match = _PLAIN_UNIT.match(text, place, end)
    if not match or not scale_of(match["plain"]):
        return None
    before = text[max(place - 30, 0) : place]
    bare = _SPACE_BEFORE.sub("", before)
    spaced = bool(match["space"]) or bare != before
    number = _NUMBER_BEFORE.search(bare) or _POWER_OF_TEN.search(bare)
    if number is None and not (spaced and _POWER_BEFORE.search(bare)):
        return None
    sort = _PlainUnit(text, place, match.end(), match["plain"], spaced, number, end)
    return (match["plain"], match.end()) if sort.is_unit(names) else None


def is_of_volume(text: str, place: int) -> bool:
    """Tell whether the line of a place gives a volume V a value before it: an l there is litres."""
    line = text[max(text.rfind("\n", 0, place) + 1, place - 200) : place]
    return _VOLUME.search(line) is not None


def _litres_at(text: str, place: int, end: int) -> tuple[str, int] | None:
    """Return the litres of V = 1.81 l as dm³, and where they end: l is a length elsewhere."""
    match = _LITRE.match(text, place, end)
    if match is None or not text[max(place - 1, 0) : place].isdecimal():
        return None
    return ("dm^3", match.end()) if is_of_volume(text, place) else None


@lru_cache(maxsize=4)
def height_named(text: str) -> frozenset[str]:
    """Return h where a page gives it a value: no hours stand in b = 1.5 h then."""
    return frozenset({"h"}) if _HEIGHT.search(text) else frozenset()


class _PlainUnit:
    """What may be a unit behind a number, with what speaks for it."""

    def __init__(
        self, text: str, place: int, stop: int, word: str, spaced: bool,
        number: re.Match[str] | None, end: int,
    ) -> None:  # fmt: skip
        self.text, self.place, self.stop, self.word, self.spaced = text, place, stop, word, spaced
        self.digits, self.end = number["digits"] if number else "", end
        self.parts = re.findall("[A-Za-zµμ]+", word)

    def is_unit(self, names: Collection[str]) -> bool:
        """Tell whether the word is a unit where these letters are declared."""
        long_parts = [part for part in self.parts if len(part) > 1]
        is_own = (
            self.parts[0] == "us"
            or _SIDE_BY_SIDE.fullmatch(self.word) is not None
            or (len(self.word) == 1 and is_multiple_of_letter(self.text, self.stop - 1, self.end))
            or self._is_own_letter_in_brackets()
            or self._is_letter_of_formulas()
            or self._is_product_of_letters()
            or (self.parts == ["h"] and "h" in height_named(self.text))
        )
        if is_own or any(part in names for part in long_parts):
            return False
        is_letters = self._is_declared(names)
        if len(self.word) == 1 and not is_letters and self.word in explained_letters(self.text):
            is_letters = True
        if self.word.startswith("1/") or re.search(r"\^\{?\(?[-−]|⁻", self.word):
            return (self.spaced and self.digits != "") or not is_letters
        if is_letters and not any(part in _PLAIN_SURE for part in long_parts):
            return self._is_clear_among_letters()
        if len(self.word) > 1:
            return (self.digits != "" or self.spaced) and not self._fills_braces()
        if self.word in "gG":
            return self._is_gram_or_multiple_of_g()
        is_big = self.word in "NJWK" and self.spaced
        return (is_big or self._is_measured()) and not self._goes_on()

    def _is_letter_of_formulas(self) -> bool:
        """Tell whether 2N is twice a letter of the page's formulas: no value that is all of a side."""
        if self.spaced or len(self.parts) > 1 or self.parts[0] not in letters_in_formulas(self.text):
            return False
        before = self.text[max(self.place - 20, 0) : self.place]
        is_last = re.match(
            r"[ ]?(?:[.,;]?[ \n]|[.,;]?$|\$|\\[,;]|\\\\)", self.text[self.stop : self.end + 1]
        )
        return _LONE_SIZE.search(before) is None or is_last is None

    def _is_product_of_letters(self) -> bool:
        """Tell whether 2km is a product of letters of the page, in k² − 2km ω² + m² ω⁴ and in c² = 4km.

        A size stays one: x = 2km has a length on its left, and nothing but numbers on its right.
        """
        part, is_count = self.parts[0], re.fullmatch("[0-9]{1,2}", self.digits) is not None
        if len(self.parts) > 1 or not _TYPED_LIKE_LETTERS.fullmatch(part) or len(set(part)) < len(part):
            return False
        if not is_count or (self.spaced and not self._goes_on()):
            return False
        if not set(part) <= letters_alone(self.text):
            return False
        first = max(self.place - 200, self.text.rfind("\n", 0, self.place) + 1)
        before = self.text[first : self.place]
        side = _SIDE_BEFORE.search(before)
        is_whole = re.fullmatch(r"[-−+0-9.,\s{(]*", before[side.end() :]) if side else None
        if side is None or is_whole is None:
            return self._is_in_formula_of_letters(before)
        rest = re.match(r"[^=≈<>≤≥\n$]*", self.text[self.stop : min(self.stop + 100, self.end)])
        if rest and _SIZE_AWAY.search(rest[0]):
            return False
        head = re.search(r"(?:^|[^\w\\])([^\W\d_])(?:_\{?\w+\}?)?[\s&]*$", before[: side.start()])
        unit = part if part in _HEADS_OF_UNITS else part[-1]
        return self._goes_on() or head is None or head[1] not in _HEADS_OF_UNITS.get(unit, "")

    def _is_in_formula_of_letters(self, before: str) -> bool:
        """Tell whether the formula is no conversion, 3km = 3000 m: it has letters, or no unit follows."""
        behind = re.match(
            r"(?:\\.|[^\n$,;:])*(?:\$ ?[A-Za-z/²³]{1,6})?", self.text[self.stop : self.stop + 200]
        )
        opened = re.search(r"(?:\\[,;:]|[^$,;:])*$", before)
        around = f"{opened[0] if opened else ''} {behind[0] if behind else ''}"
        is_equal = re.match(r"[\s})]*(?:=|≈)", behind[0] if behind else "") is not None
        return bool(letters_alone(around)) or (is_equal and not _SIZE_AWAY.search(around))

    def _is_own_letter_in_brackets(self) -> bool:
        """Tell whether a letter of the page ends a sum in brackets: (m_r + 0.5 m) where m = 0.7 kg.

        Of units, each term would have one, or the bracket one behind it.
        """
        if len(self.word) > 1 or self.word not in _letters_of_page(self.text):
            return False
        opened = _SUM_BEFORE.search(self.text[max(self.place - 80, 0) : self.place])
        closed = _CLOSED.match(self.text, self.stop, self.end)
        return opened is not None and closed is not None and not _UNIT_AROUND.search(opened[0])

    def _fills_braces(self) -> bool:
        """Tell whether a count and a letter are all of a group: the 4m^2 of \\frac{b^2}{4m^2}."""
        if len(self.parts) > 1 or len(self.parts[0]) > 1:
            return False
        before = self.text[max(self.place - 4, 0) : self.place]
        is_alone = re.search(r"\{[0-9]{1,2}$", before) is not None
        return is_alone and self.text[self.stop : self.stop + 1] == "}"

    def _is_gram_or_multiple_of_g(self) -> bool:
        """Tell whether m = 40 g is a mass, and 3513 G behind a division by 9.81 a multiple of g."""
        before = self.text[max(self.place - 60, 0) : self.place]
        if self.word == "g":
            head = _HEAD.search(before)
            is_mass = head is not None and head[1] in "mM"
            line = before.rpartition("\n")[2]
            if _TIMES_LENGTH.match(self.text, self.stop, self.end):
                return self.spaced
            if is_mass or not self.spaced or self._goes_on():
                return is_mass
            if speaks_of_grams(self.text) and _LONE_SIZE.search(line):
                return True  # weighs x = 320 g, whatever its letter
            return _MASS.search(line) is not None or self._is_sum_of_grams(line)
        line = before.rpartition("\n")[2]
        return self.spaced and re.search(r"(?:/|÷|\}\{)\s*9\.8[0-9]*(?![0-9])", line) is not None

    def _is_sum_of_grams(self, line: str) -> bool:
        """Tell whether nothing but numbers stand before a g, on a page of grams: 4 + 5 = 9 g."""
        if not speaks_of_grams(self.text) and _IN_OUNCES.match(self.text, self.stop, self.end) is None:
            return False
        if _SUM_OF_GRAMS.search(line) or _ADDED_GRAMS.match(self.text, self.stop, self.end):
            return True
        computed = _COMPUTED.search(line)
        return computed is not None and _LETTERS.search(_BEHIND_GRAM.sub("", computed[0])) is None

    def _is_declared(self, names: Collection[str]) -> bool:
        """Tell whether the word may be read in declared letters alone."""
        return all(part in names or all(letter in names for letter in part) for part in self.parts)

    def _is_measured(self) -> bool:
        """Tell whether the number looks measured, or other units stand in the line."""
        return "." in self.digits or len(self.digits) > 2 or self._has_units_around()

    def _has_units_around(self) -> bool:
        begin = max(self.text.rfind("\n", 0, self.place) + 1, self.place - 200)
        stop = self.text.find("\n", self.stop)
        stop = min(stop if stop >= 0 else len(self.text), self.stop + 200)
        return any(
            not self.place <= match.start() < self.stop and not self.place < match.end() <= self.stop
            for match in _UNIT_AROUND.finditer(self.text, begin, stop)
        )

    def _is_clear_among_letters(self) -> bool:
        """Tell whether a word in declared letters is a unit: other units around, or r = 0.04 m."""
        if not self.digits or self._goes_on():
            return False
        if not self.spaced and not ("." in self.digits and self._has_units_around()):
            return False
        if len(self.parts) > 1:
            return len(self.digits) > 1 or self._has_units_around()
        if self.word == "g":
            return False
        if self._has_units_around() or (self.word == "N" and len(self.digits) > 2):
            return not self._is_divided()
        head = _HEAD.search(self.text[max(self.place - 60, 0) : self.place])
        is_length = self.word == "m" and head is not None and head[1] not in "mMFJIW"
        is_time = self.word == "s" and head is not None and head[1] in "tT"
        return (is_length or is_time) and ("." in self.digits or len(self.digits) > 2)

    def _is_divided(self) -> bool:
        """Tell whether a product that holds the word is divided on: 2 π N/60, where a force never is."""
        return _DIVIDED_ON.match(self.text, self.stop, self.end) is not None

    def _goes_on(self) -> bool:
        """Tell whether a factor follows: 2 m r, 3 N sin x."""
        after = self.text[self.stop : min(self.stop + 12, self.end)]
        bare = after.lstrip(" ~")
        if _SECOND_VALUE.match(self.text, self.stop, self.end) or after.startswith(" ~ "):
            return False
        if re.match(r"[ ]\((?!sin|cos|tan|exp|sqr)[^\W\d_]{3,}[ )]", after):
            return False  # 11 bar (four stroke)
        if not bare or bare[0] in _STOPS or bare[0] == "\n" or ord(bare[0]) >= 0x2E80:
            return False
        if _FACTOR_BEHIND_SPACE.match(self.text, self.stop, self.end):
            return True
        if bare.startswith(
            ("\\cdot", "\\times", "\\approx", "\\le", "\\ge", "\\quad", "\\qquad", "\\\\", "\\,")
        ):
            return False
        word = re.match(r"[^\W\d_¹²³⁴⁵⁶]+", bare)
        return (
            word is None
            or len(word.group()) < 2
            or word.group()[:3] in ("sin", "cos", "tan", "exp", "sqr")
        )


_FACTOR_BEHIND_SPACE = re.compile(
    r"(?:[ ~]*\\[,;:!])+[ ]?(?:[A-Za-z](?<![msgNJWKVAhlLt])(?![A-Za-z])"
    r"|\\(?:[dt]?frac|sin|cos|tan|sqrt|left|d?dot|[oO]mega|lambda|(?:var)?(?:phi|theta|rho)|alpha|beta|psi)"
    r"(?![A-Za-z]))"
)
"""A thin space and the next factor: 2\\,s\\,n, but 3\\,N\\,m."""


def follows_number(text: str, start: int, place: int) -> bool:
    """Tell whether a number or bracket ends before a place, spaces apart."""
    before = re.sub(r"(?:\s|~|\\[,;: ])+$", "", text[max(start, place - 40) : place])
    before = re.sub(r"\\pi$", "1", before)
    return before[-1:].isdecimal() or before[-1:] in ("}", ")", "]")


def is_set_apart(text: str, place: int) -> bool:
    """Tell whether a space typed as such, \\, or ~, stands before a place."""
    return re.search(r"(?:~|\\[,;: ])\s*$", text[max(0, place - 20) : place]) is not None


_MEASURED = re.compile(r"\[\s*\\?[^\W\d]\w{0,12}(?:_\{\w+\})?\s*\]\s*=\s*(?P<unit>[^=]{1,60})")


def is_unit_of_letter(text: str, start: int, end: int) -> bool:
    """Tell whether [F] = N stands there, which says in what a letter is measured."""
    match = _MEASURED.fullmatch(text, start, end)
    if match is None:
        return False
    bare = re.sub(r"\\(?:mathrm|text|textrm|[,;: ])|[{}$.,;)]", " ", match["unit"])
    return scale_of(" ".join(bare.split())) is not None


def is_quantity(text: str) -> bool:
    """Tell whether a text is one number with a unit, as in "at 3000 rpm, ω = 2π · 3000/60"."""
    match = re.fullmatch(r"\s*[0-9][0-9.,]*\s*(?P<unit>\S.*?)\s*", text)
    return (
        match is not None
        and scale_of(re.sub(r"\\(?:mathrm|text|[,;: ])|[{}~]", " ", match["unit"])) is not None
    )
