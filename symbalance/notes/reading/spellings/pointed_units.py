"""Compound units in words, and in the points of English prints, are put in signs: lb.-in.-sec.² too.

Their words are abbreviated with points and joined by hyphens, or written out: newton metres per radian,
Meter pro Sekunde, feet per second squared. A pound beside the square of a time, or times a length, is a
force; on an area it is one by its own sign, and else a mass.
"""

from __future__ import annotations

from symbalance.document.wordlists import words as listed
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_SIGNS = {
    "lb": "lb", "lbs": "lb", "lbf": "lbf", "in": "inch", "inch": "inch", "inches": "inch", "ft": "ft",
    "feet": "ft", "foot": "ft", "sec": "s", "secs": "s", "s": "s", "min": "min", "hr": "h", "hrs": "h",
    "h": "h", "rad": "rad", "rev": "rev", "revs": "rev", "oz": "oz", "ton": "ton", "tons": "ton",
    "slug": "slug", "slugs": "slug", "gm": "g", "gms": "g", "kg": "kg", "cm": "cm", "mm": "mm", "m": "m",
    "N": "N", "kN": "kN", "deg": "deg",
}  # fmt: skip
"""The words of compound units, and what each is written as."""
_PREFIXED = {
    "m": "metre metres meter meters metern mètre mètres metro metros metri",
    "g": "gram grams gramme grammes gramm grammi gramos",
    "N": "newton newtons", "J": "joule joules", "W": "watt watts", "Pa": "pascal pascals",
    "rad": "rads radian radians radiant radianti radiante radianes",
}  # fmt: skip
_TIMES = {
    "s": "second seconds seconde secondes sekunde sekunden segundo segundos secondo secondi",
    "min": "minute minutes minuten minuto minutos minuti",
    "h": "hour hours stunde stunden heure heures hora horas ora",
}  # fmt: skip
_PREFIXES = {"": "", "kilo": "k", "mega": "M", "centi": "c", "zenti": "c", "milli": "m"}
_WRITTEN_OUT = {
    before + word: sign + unit
    for before, sign in _PREFIXES.items()
    for unit, spelled in _PREFIXED.items()
    for word in listed(spelled)
} | {word: unit for unit, spelled in _TIMES.items() for word in listed(spelled)}
_WRITTEN_OUT |= {"pound": "lb", "pounds": "lb", "revolution": "1", "revolutions": "1"}  # as in rpm
_WRITTEN_OUT |= {"mile": "mi", "miles": "mi"}
_WRITTEN_OUT |= {word.capitalize(): sign for word, sign in _WRITTEN_OUT.items()}
_SIGNS |= _WRITTEN_OUT
_WORD = "|".join(sorted(_SIGNS, key=len, reverse=True))
_SQUARED = "squared|zum Quadrat|au carré|al cuadrado|al quadrato"
_POWER = rf"(?:\^\{{?[-−]?[1-4]\}}?|⁻?[¹²³⁴]|[ ](?:{_SQUARED}|cubed)(?![a-z]))"
_WORDS_OF_POWERS = {"²": f"square|sq|{_SQUARED}", "³": "cubic|cubed|cu"}
_RAISED: dict[str, str] = {
    word: sign for sign, spelled in _WORDS_OF_POWERS.items() for word in spelled.split("|")
}
_BEFORE = r"(?:(?:square|cubic)[ ](?=[a-z]{4})|(?:sq|cu)(?:\.[ ]?|[ ])(?=(?:in|ft)(?![A-Za-z])))?"
_PART = rf"{_BEFORE}(?:{_WORD})(?![A-Za-z])(?:\.?{_POWER}\.?|\.)?"
_TIME = r"(?:s(?:ec(?:ond[a-z]*|s?\.)?)?|min(?:ut[a-z]*|\.)?|h(?:ours?|rs?\.?)?)(?![A-Za-z])"
_PER = rf"[ ](?:per|pro|par|por|je|al|alla|an?(?=[ ]{_TIME}))[ ]"
_JOINT = rf"(?:(?<=[A-Za-z.²³⁴}}])[-‐‑](?=[A-Za-z])|[ ]?[·⋅/][ ]?|[ ]?\\cdot[ ]|{_PER}"
_JOINT += r"|(?<=\.)[ ]?(?=(?:in|ft|lbs?|secs?)(?:\.|\^|[²³⁴]))"
_JOINT += rf"|(?<=[a-z]{{4}})[ ](?=(?:{'|'.join(_WRITTEN_OUT)}|square|cubic)(?![a-z])))"
_NUMBER_END = r"(?<=[0-9⁰¹²³⁴⁵⁶⁷⁸⁹}½¼¾])(?<!_[0-9])"
_GAP = r"(?:\$|\\\))?(?:[ ~\u2009\u202f]|\\[,;: ])?(?:\\(?:text|mathrm|mbox|textrm)\s?\{\s?)?"
_COMPOUND = re.compile(
    rf"{_NUMBER_END}{_GAP}(?P<unit>{_PART}(?:{_JOINT}{_PART}){{1,3}}+)(?![A-Za-z0-9(])"
)
_ONE_PART = re.compile(
    rf"(?P<joint>{_JOINT})?(?:(?P<before>square|cubic|sq|cu)(?:\.[ ]?|[ ]))?"
    rf"(?P<word>{_WORD})(?![A-Za-z])\.?(?P<power>{_POWER})?\.?"
)
_ABBREVIATED = re.compile(
    rf"{_NUMBER_END}{_GAP}(?:{_WORD}|hp)(?P<point>\.)(?=[ ]?(?:[=≈≤≥+×·*)]|<[^/]|{_POWER}|\$|\\approx))"
)
"""A unit with a point behind which its formula goes on: 0.5 deg. = 0.0087, 3.5 in.⁴."""
_GOES_ON = re.compile(r"[ ]?(?:[=≈<>≤≥+×·*/,;)$]|\\approx)|[ ][a-z]{2,}(?![ ]?[=(])")
_LENGTHS = frozenset(("inch", "ft", "cm", "mm", "m"))


def with_compound_units(text: str) -> Rewritten | None:
    """Return a text with such units in plain signs, None where there are none.

    >>> with_compound_units("J = 12.5 lb.-in.-sec.² here").text, with_compound_units("6 in-line engines")
    ('J = 12.5 lbf·inch·s² here', None)
    >>> with_compound_units("0.5 deg. = 0.00873 rad").text
    '0.5 deg = 0.00873 rad'
    """
    changes: dict[int, tuple[int, str]] = {}
    for match in _COMPOUND.finditer(text):
        start, end = match.span("unit")
        sign = compound_unit(match["unit"])
        is_unit = scale_of(sign) is not None or not _IS_WRITTEN_OUT.search(match["unit"])
        if sign and is_unit and sign != match["unit"].rstrip("."):
            is_end = text[end - 1] == "." and _GOES_ON.match(text, end) is None
            changes[start] = end - is_end, sign
    for match in _ABBREVIATED.finditer(text):
        if not any(start <= match.start("point") < end for start, (end, _) in changes.items()):
            changes[match.start("point")] = match.end("point"), ""
    if not changes:
        return None
    rewriter = Rewriter(text)
    for start, (end, written) in sorted(changes.items()):
        rewriter.replace(start, end, written)
    return rewriter.finish()


def compound_unit(words: str) -> str:
    """Return a compound unit in plain signs, "" for what is none.

    >>> compound_unit("lb.-in./rad"), compound_unit("ft./sec.²"), compound_unit("lb·s²/in")
    ('lbf·inch/rad', 'ft/s²', 'lbf·s²/inch')
    >>> compound_unit("lb per sq. in."), compound_unit("lb./cu.in.")
    ('lb/inch²', 'lb/inch³')
    >>> compound_unit("radians per sec."), compound_unit("newton metres per second squared")
    ('rad/s', 'N·m/s²')
    """
    parts: list[tuple[str, str, str]] = []
    place = 0
    while match := _ONE_PART.match(words, place):
        joint = (match["joint"] or "").strip()
        is_bare = match["joint"] is None
        if is_bare == bool(parts) or (joint in _HYPHENS and _may_subtract(parts[-1][1])):
            return ""
        sign = "/" if joint == "/" or joint.isalpha() else "·" if parts else ""
        power = match["power"] or ""
        power = _RAISED[match["before"] or power.strip()] if match["before"] or " " in power else power
        part = sign, _SIGNS[match["word"]], power
        if part == ("/", "s", "") and parts[-1] == part:  # per second per second
            parts[-1] = "/", "s", "²"
        else:
            parts.append(part)
        place = match.end()
    if place < len(words) or len(parts) < _FEWEST:
        return ""
    is_force = _is_of_force(parts)
    return "".join(f"{j}{'lbf' if w == 'lb' and is_force else w}{p}" for j, w, p in parts)


_SETTING = re.compile(r"\\(?:mathrm|text|textrm|mbox)(?![A-Za-z])\s?|\\left|\\right")
_DOT = re.compile(r"\s*(?:\\cdot(?![A-Za-z])|[·⋅])\s*")
_SPACE = re.compile(r"(?:\\[,;: !]|[~ ])+")
_SPACED_DOT = re.compile(r"·*([·/^])·*")
_OF_INCHES = re.compile(r"(?<![A-Za-z])(?:in|lbs?)(?![A-Za-z])")


def unit_with_inches(words: str) -> str:
    r"""Return a unit that has inches or pounds in signs, "" for others; its setting may be LaTeX's.

    >>> unit_with_inches("lb in"), unit_with_inches(r"\mathrm{in}^{2}"), unit_with_inches("kg m")
    ('lbf·inch', 'inch^2', '')
    >>> unit_with_inches(r"\mathrm{lb}\cdot\mathrm{s^2/in}"), unit_with_inches("in the case")
    ('lbf·s^2/inch', '')
    """
    if not _OF_INCHES.search(words):
        return ""
    plain = _SETTING.sub("", words).replace("{\\cdot}", "·").replace("{/}", "/")
    plain = _DOT.sub("·", plain).replace("{", "").replace("}", "").strip(" ~")
    plain = _SPACED_DOT.sub(r"\1", _SPACE.sub("·", plain)).strip("·")
    alone = re.fullmatch(rf"in\.?(?P<power>{_POWER})?", plain)
    sign = f"inch{alone['power'] or ''}" if alone else compound_unit(plain)
    return sign if sign and scale_of(sign) is not None else ""


_IS_WRITTEN_OUT = re.compile("[a-z]{4}")
_HYPHENS = frozenset("-‐‑")
_FEWEST = 2


def _may_subtract(word: str) -> bool:
    """Tell whether a hyphen behind a word may be a minus sign: 2 m-s, but not 10 N-m."""
    return len(word) == 1 and word != "N"


def _is_of_force(parts: list[tuple[str, str, str]]) -> bool:
    """Tell whether the pound of a unit is a force: lb·in, lb·s²/in; lb·ft² and lb/ft³ weigh."""
    above = {(word, power.strip("^{}")) for joint, word, power in parts if joint != "/"}
    below = {word for joint, word, _ in parts if joint == "/"}
    times_square = ("s", "²") in above or ("s", "2") in above
    is_moment = any((length, "") in above for length in _LENGTHS) and not below & {"s", "min"}
    return times_square or is_moment
