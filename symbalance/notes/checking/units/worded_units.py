"""Units as prose has them, in signs or in words: revolutions per minute, 600 cm³, bar, Newtonmeter.

A sentence gives a quantity without a letter ("its displacement is 600 cm³") or says in which unit a
letter counts ("the speed n in rpm"). Read here is the unit that a text begins with, whatever its markup.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from symbalance.notes.checking.units.dimensions import Dimension, unit_of
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_PER = r"[\s-]?(?:/|per|an?|each|every|pro|je|in\s+der|par|à\s+la|al|por)\s?"
_TURNS = (
    r"(?:revolutions?|revs?\.?|rotations?|turns|Umdrehungen|Umdr\.|U|tours?|tr|giri|rivoluzioni|vueltas"
    r"|revoluciones|r)"
)
_MINUTE = r"[Mm]in(?:uten?|utes?|ute|uto|\.)?"
_SECOND = r"(?:s(?:ec(?:onds?|\.)?|econdes?|econdo|egundos?)?|Sekunden?)"
RATE = unit_of("1/s")
"""The dimension of speeds of rotation and of frequencies."""
_CYCLES = r"(?:cycles|Schwingungen|cicli|ciclos|oscillations)"
_RADIANS = r"(?:rad(?:ian(?:s|t|ts|ti|es|i)?|ianti)?\.?|Radiant)"
_RATES = (
    (
        math.pi / 30,
        rf"rpm|r\.\s?p\.\s?m\.?|{_TURNS}{_PER}{_MINUTE}|min(?:\^-1|⁻¹)|1/min|/min|回転/分|回転毎分",
    ),
    (
        2 * math.pi,
        rf"(?:{_TURNS}|{_CYCLES}){_PER}{_SECOND}|[Hh]ertz|Hz",
    ),
    (2e3 * math.pi, r"kHz|[Kk]ilo[Hh]ertz"),
    (
        1.0,
        rf"rad/s|{_RADIANS}{_PER}{_SECOND}|rad\ss(?:\^-1|⁻¹)",
    ),
)
"""By what a number of a unit is multiplied for radians a second, and how the unit is written."""
_CUBED = r"(?:cubes?|cubi|cúbicos)"
_SQUARED = r"(?:carrés?|quadrati|cuadrados)"
_METRE = r"(?:metres?|meters?|[Mm]etern?|mètres?|metri|metro|metros)"
_SPELLED = (
    ("N mm", rf"[Nn]ewton[\s-]?milli{_METRE}"),
    ("N m", rf"[Nn]ewton[\s-]?{_METRE}"),
    ("kN m", rf"[Kk]ilonewton[\s-]?{_METRE}"),
    ("MW", r"[Mm]egawatts?"),
    (
        "kWh",
        r"[Kk]ilowatt[\s-]?hours?|Kilowattstunden?|kilowatt-?heures?|chilowattora|kilovatios?[\s-]hora",
    ),
    ("kW", r"[Kk]ilowatts?|chilowatt|kilovatios?"),
    ("W", r"[Ww]atts?|vatios?"),
    ("hp", r"(?:mechanical\s)?horse[\s-]?powers?|b?hp|BHP|HP"),
    (
        "PS",
        r"PS|Pferdestärken?|metric\shorse[\s-]?power|chevaux(?:[\s-]vapeur)?|ch|CV|cv|cavalli(?:\svapore)?|caballos",
    ),
    ("GPa", r"[Gg]igapascals?"),
    (
        "MPa",
        r"[Mm]egapascals?|newtons?\sper\ssquare\smilli(?:meter|metre)|Newton\s(?:pro|je)\sQuadratmillimeter",
    ),
    ("kPa", r"[Kk]ilopascals?"),
    ("Pa", r"[Pp]ascals?"),
    ("MJ", r"[Mm]egajoules?"),
    ("kJ", r"[Kk]ilojoules?"),
    ("J", r"[Jj]oules?"),
    ("mm^3", rf"cubic\smilli{_METRE}|Kubikmilli{_METRE}|milli{_METRE}\s?{_CUBED}"),
    ("cm^3", rf"cubic\scenti{_METRE}|Kubikzenti{_METRE}|centi{_METRE}\s?(?:cubes?|cubi|cúbicos)|cc|ccm"),
    ("m^3", rf"cubic\s{_METRE}|Kubik{_METRE}|{_METRE}\s?{_CUBED}"),
    ("dm^3", r"lit(?:er|re)s?|Litern?|litr[io]|litros?|l|L|ℓ"),
    (
        "mm^2",
        rf"square\smilli{_METRE}|Quadratmilli{_METRE}|milli{_METRE}\s?(?:carrés?|quadrati|cuadrados)",
    ),
    (
        "cm^2",
        rf"square\scenti{_METRE}|Quadratzenti{_METRE}|centi{_METRE}\s?(?:carrés?|quadrati|cuadrados)",
    ),
    ("m^2", rf"square\s{_METRE}|Quadrat{_METRE}|{_METRE}\s?{_SQUARED}"),
    ("kg m^2", rf"kilogram(?:me)?[\s-](?:square\s)?{_METRE}(?:\ssquared)?|Kilogramm\s?Quadrat{_METRE}"),
    (
        "km/h",
        r"kilomet(?:er|re)s?\s(?:per|an)\shour|Kilometern?\s(?:pro|je)\sStunde|kilomètres?\spar\sheure",
    ),
    ("m/s", rf"{_METRE}{_PER}{_SECOND}"),
    ("kN", r"[Kk]ilonewtons?"),
    ("N", r"[Nn]ewtons?"),
    ("mm", rf"[Mm]illi{_METRE}"),
    ("cm", rf"[Cc]enti{_METRE}|Zenti{_METRE}"),
    ("km", rf"[Kk]ilo{_METRE}|chilometri"),
    ("m", _METRE),
    ("kg", r"kilogram(?:me)?s?|Kilogramm|chilogramm[io]|kilogramos?"),
    ("g", r"gram(?:me)?s?|Gramm|gramm[io]|gramos?"),
    ("h", r"hours?|Stunden?|heures?|ore|horas?"),
    ("ms", r"milliseconds?|Millisekunden?|millisecondes?"),
    ("s", r"seconds?|Sekunden?|secondes?|secondi|segundos?"),
    ("min", r"minutes?|Minuten?|minuti|minutos?"),
)
"""Units of the SI and others, and how they are spelled; a longer one stands before its beginning."""
_END = r"(?![^\W\d_])(?!\s?\^)"
_BY_WORDS = tuple((sign, re.compile(rf"(?:{words}){_END}")) for sign, words in _SPELLED)
_BY_RATES = tuple((scale, re.compile(rf"(?:{words}){_END}")) for scale, words in _RATES)
_RAISED = r"(?:\s?\^\s?[-−]?[0-9]|[⁻]?[¹²³⁴])?"
_SIGN = re.compile(
    rf"[A-Za-zµ°]{{1,4}}{_RAISED}"
    rf"(?:[ ·*/](?=[A-Za-zµ]{{1,4}}(?![A-Za-z]))[A-Za-zµ]{{1,4}}{_RAISED}){{0,3}}"
)
"""A unit in signs, of up to four parts."""
_MARKUP = re.compile(
    r"\\(?:mathrm|text|textrm|mbox|unit|si|operatorname|rm)(?![A-Za-z])\s*|\\[,;: ]|\\cdot(?![A-Za-z])"
    r"|[~${}]|\\(?=%)"
)
_SPACES = re.compile(r"[\s\u00a0\u2009\u202f]+")
_REACH = 60


@dataclass(frozen=True, slots=True)
class WordedUnit:
    """A unit of prose: its sign, its dimension, and by what its numbers are multiplied in the SI.

    Speeds of rotation and frequencies are multiplied to radians a second, whatever they count.
    """

    text: str
    dimension: Dimension
    scale: float

    @property
    def is_rate(self) -> bool:
        """Tell whether it is one of a speed of rotation, or a frequency."""
        return self.dimension == RATE


@lru_cache(maxsize=4096)
def worded_unit(text: str) -> WordedUnit | None:
    r"""Return the unit that a text begins with, None for none.

    >>> worded_unit(r"\,\mathrm{cm^3}$. Since").text, worded_unit("Newtonmeter an").scale
    ('cm^3', 1.0)
    >>> round(worded_unit("$\\mathrm{min^{-1}}$ und").scale, 4), worded_unit("blocks") is None
    (0.1047, True)
    """
    plain = _MARKUP.sub(" ", text[: _REACH * 2]).replace("^ ", "^").replace("−", "-")
    plain = re.sub(r"\^\s*", "^", _SPACES.sub(" ", plain)).lstrip()[:_REACH]
    for scale, pattern in _BY_RATES:
        if (match := pattern.match(plain)) is not None and RATE is not None:
            return WordedUnit(match[0], RATE, scale)
    sign = _longest_sign(plain)
    if sign is not None:
        return sign
    for name, pattern in _BY_WORDS:
        if pattern.match(plain):
            return _of_sign(name)
    return None


def _longest_sign(text: str) -> WordedUnit | None:
    """Return the longest unit in signs that a text begins with: N mm, and not N alone."""
    match = _SIGN.match(text)
    if match is None:
        return None
    words = re.split(r"(?<=[^ ·*/])(?=[ ·*/])", match[0])
    for count in range(len(words), 0, -1):
        source = "".join(words[:count]).strip()
        behind = text[len(source) :]
        is_word = behind[:1].isalpha() or source in _NO_SIGNS
        unit = None if is_word else _of_sign(source)
        if unit is not None:
            return unit
    return None


_NO_SIGNS = frozenset(["a", "d", "in", "l", "L", "an", "to", "at", "as", "ha"])
"""Words, or letters, that are units elsewhere."""


def _of_sign(sign: str) -> WordedUnit | None:
    scale, dimension = scale_of(sign), unit_of(sign)
    if scale is None or dimension is None or not any(dimension):
        return None
    return WordedUnit(sign, dimension, float(scale[0]) * (math.pi if scale[1] else 1))
