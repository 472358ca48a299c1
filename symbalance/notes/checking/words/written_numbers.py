"""Numbers written as the author of a page writes them: digits, power of ten, decimal sign and unit.

What is wrong with `25.4 N` is said as `25.4 kN`, not as 25421.8 or a quotient: a value beside a printed
number has as many digits as that, in its unit.
"""

from __future__ import annotations

import html
import math
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import Constant, Decimal, Formula, Negative, Number, Product, Upright
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.reading.units import INCH, scale_of
from symbalance.text import lazy_patterns as re

LEAST_DIGITS = 2
"""Significant digits of a correction."""
SAME = 1e-9
"""Relative: a text is what was read if their values agree so far."""
LONGEST, MOST_POWER = 120, 99
"""Characters of a side that may be a number, and the powers of ten it may have."""
MOST_DIGITS = 6
"""That a correction may have."""

_SIUNITX = re.compile(
    r"\\(?:SI|qty)\s*(?:\[[^\]]*\])?\s*\{([^{}]*)\}\s*(?:\[[^\]]*\])?\{((?:[^{}]|\{[^{}]*\})*)\}"
)
_ONE_ARGUMENT = re.compile(r"\\(?:num|boxed|fbox|mathbf)\s*\{([^{}]*)\}")
_ANGLE = re.compile(r"\\ang\s*\{([^{}]*)\}")
_SPACE = re.compile(r"\\(?:[,;: !]|q?quad(?![A-Za-z]))|[~$`]|</?[A-Za-z]+>")
_NUMBER = re.compile(
    r"\(?(?P<sign>[+\-−–]?)\s*"
    r"(?P<digits>[0-9]+(?:[.,][0-9]+|·(?!10\^)[0-9]+|[ '][0-9]{3}(?![0-9]))*)\)?\s*"
    r"(?:(?:\\times|\\cdot|[×·⋅*x]|e)\s*(?:10\s*\^?\s*)?\{?(?P<power>[-−]?[0-9]+)\}?(?![0-9.,]))?\s*"
    r"(?P<unit>.*)"
)
_THOUSANDS = re.compile(r"[1-9][0-9]{0,2}(?:[ ',][0-9]{3})+(?:\.[0-9]+)?")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_TO_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_RAISED_TEN = re.compile("10([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)")
_DEGREES = re.compile(r"\^?\s*\{?\s*(?:\\circ|°|∘)\s*\}?|\\degree|degrees?|deg|Grad|度")
_PERCENT = re.compile(r"\\?%")
_UNIT_SHOWN = re.compile(r"\\(?:mathrm|text|textrm|mbox|unit|si|rm|operatorname)(?![A-Za-z])|[{}]")
_UNKNOWN_UNIT = re.compile(r"[^\W\d_][^\d+=×*(){}\\<>]*[⁰¹²³⁴⁵⁶⁷⁸⁹]*")
_PREFIXES = ("", "k", "M", "G", "m", "c")


@dataclass(frozen=True, slots=True)
class WrittenNumber:
    """A number as it was typed: its digits' value and last place, power of ten, decimal sign, unit."""

    mantissa: Fraction
    place: Fraction | None
    power: int | None
    point: str
    unit: str
    scale: Fraction
    of_pi: bool
    is_bare: bool = False
    """Whether its unit does not count."""

    @property
    def factor(self) -> float:
        """What one of its unit is in the units that are calculated with."""
        return float(self.scale) * (math.pi if self.of_pi else 1)

    @property
    def size(self) -> Fraction:
        """Its value, without its unit."""
        return self.mantissa * Fraction(10) ** (self.power or 0)

    def without_scale(self) -> WrittenNumber:
        """Return the number whose unit only stands behind it, as behind a result of bare numbers."""
        return replace(self, scale=Fraction(1), of_pi=False, is_bare=True)

    @property
    def digits(self) -> int:
        """The significant digits it is printed with; of a whole number all of them."""
        first = exponent_of(self.mantissa)
        if self.place is None:
            return max(first + 1, LEAST_DIGITS)
        return max(first - exponent_of(self.place) + 1, LEAST_DIGITS)

    @property
    def counted(self) -> int:
        """The significant digits without the closing zeros of a whole number."""
        if self.place is not None or self.mantissa.denominator > 1:
            return self.digits
        return max(len(str(abs(self.mantissa.numerator)).rstrip("0")), LEAST_DIGITS)

    @property
    def node(self) -> Formula:
        """The formula that it is."""
        value = Number(
            self._sized(abs(self.mantissa)), None if self.place is None else self._sized(self.place)
        )
        whole: Formula = value
        if self.of_pi:
            whole = Product((value, Product((rational_node(self.scale), Constant("pi")))))
        return Negative(whole) if self.mantissa < 0 else whole

    def _sized(self, value: Fraction) -> Fraction:
        value *= Fraction(10) ** (self.power or 0)
        return value if self.of_pi else value * self.scale

    @property
    def text(self) -> str:
        """The number with its unit, for a page."""
        number = _plain_digits(abs(self.mantissa), self.place).replace(".", self.point)
        if self.power is not None:
            raised = str(self.power).translate(_TO_RAISED)
            number += f" × 10{raised}"
        sign = "−" if self.mantissa < 0 else ""
        return f"{sign}{number}{'' if self.unit in ('', '°') else ' '}{self.unit}"

    @property
    def written(self) -> Formula:
        """The number with its unit as a formula that is shown as it was typed."""
        if self.point != "." or self.unit:
            return Upright(self.text)
        if self.power is None:
            return self.node
        number = Decimal(f"{_plain_digits(abs(self.mantissa), self.place)}e{self.power}")
        return Negative(number) if self.mantissa < 0 else number

    def at_its_place(self, value: Fraction) -> WrittenNumber | None:
        """Return a value that ends where the decimal typed does, in its unit: 0.2, not 0.20, for 0.3."""
        if self.place is None or self.of_pi or not value:
            return None
        own = value / self.scale / Fraction(10) ** (self.power or 0)
        places = own / self.place
        if places.denominator > 1 or self.power is not None or own == self.mantissa:
            return None
        return self._with(own, self.place, self.power)

    def with_value(self, value: Fraction, digits: int) -> WrittenNumber:
        """Return another value in the same unit, with so many significant digits."""
        own = value / self.scale / (Fraction(math.pi) if self.of_pi else 1)
        power = self.power
        if power is not None and own:
            # A mantissa between 1 and 10 stays one.
            is_normal = 1 <= abs(self.mantissa) < 10
            power = exponent_of(own) if is_normal else power
            own /= Fraction(10) ** power
        if own and abs(own - round(own)) < abs(own) * Fraction(1, 10**12):
            own = Fraction(round(own))  # of an angle, whose π is rounded here
        is_whole = own == round(own) and self.place is None
        place = Fraction(10) ** (exponent_of(own) + 1 - digits)
        if is_whole or place >= 1:
            exact = round(own) if is_whole or self.place is None else round(own / place) * place
            return self._with(Fraction(exact), None, power)
        return self._with(round(own / place) * place, place, power)

    def _with(self, mantissa: Fraction, place: Fraction | None, power: int | None) -> WrittenNumber:
        return replace(self, mantissa=mantissa, place=place, power=power)

    def in_unit(self, unit: str, scale: Fraction) -> WrittenNumber:
        """Return the same digits with another unit."""
        return replace(self, unit=unit, scale=scale)


def written_number(source: str, value: float) -> WrittenNumber | None:
    r"""Return a side that was read as a value as the number that was typed; None for anything else.

    >>> written_number(r"0{,}546\,\mathrm{kN}", 546).with_value(Fraction(54604, 10), 3).text
    '5,46 kN'
    """
    if len(source) > LONGEST or not math.isfinite(value):
        return None
    for candidate in _candidates(source):
        size = float(candidate.mantissa) * 10.0 ** (candidate.power or 0) * candidate.factor
        if abs(size - value) <= SAME * abs(value) and candidate.mantissa:
            return candidate
    return None


def _candidates(source: str) -> Iterator[WrittenNumber]:
    """Yield what a text may say: a comma is a decimal sign or stands between thousands."""
    text = _NUMBER.fullmatch(_bare(source))
    if not text:
        return
    unit = _UNIT_SHOWN.sub("", text["unit"]).strip(" .,;:") if text["unit"] else ""
    unit = re.sub(r"\s*\\cdot(?![A-Za-z])\s*", " ", unit)
    unit = re.sub(r"\s*\^(-?[0-9]+)", lambda match: match[1].translate(_TO_RAISED), unit)
    power = int(text["power"].replace("−", "-")) if text["power"] else None
    if abs(power or 0) > MOST_POWER or len(text["digits"]) > 30:
        return
    scales: list[tuple[str, Fraction, bool]] = []
    if _DEGREES.fullmatch(text["unit"].strip(" .,;")):
        scales.append(("°", Fraction(1, 180), True))
    elif _PERCENT.fullmatch(unit):
        scales.append(("%", Fraction(1, 100), False))
    elif unit and (scale := scale_of(text["unit"].strip(" .,;:")) or scale_of(unit)) is not None:
        scales += [(unit, *scale), (unit, Fraction(1), False)]
        if scale == (Fraction(1, 30), True):  # turns a minute, counted and not in radians
            scales.append((unit, Fraction(1, 60), False))
    elif unit == "in":  # a word of the language, so that alone it is no unit of the tables
        scales.append((unit, INCH, False))
    elif unit and not _UNKNOWN_UNIT.fullmatch(unit):
        return  # a product, a sum
    scales.append((unit, Fraction(1), False))
    sign = -1 if text["sign"] in tuple("-−–") else 1
    for name, factor, of_pi in scales:
        for point, digits in _readings(text["digits"]):
            whole, dot, rest = digits.partition(".")
            place = Fraction(1, 10 ** len(rest)) if dot else None
            mantissa = sign * Fraction(int(whole + rest), 10 ** len(rest))
            yield WrittenNumber(mantissa, place, power, point, name, factor, of_pi)


def _readings(digits: str) -> Iterator[tuple[str, str]]:
    """Yield the decimal sign that digits may have been typed with, and them with a point for it."""
    if _THOUSANDS.fullmatch(digits):
        yield ".", re.sub("[ ',]", "", digits)
    for point in ".,·":
        plain = re.sub("[ ']", "", digits).replace(point, ".", 1)
        if re.fullmatch(r"[0-9]+(?:\.[0-9]+)?", plain):
            yield point, plain


def _bare(source: str) -> str:
    """Return a text without what only sets it."""
    text = unicodedata.normalize("NFC", html.unescape(source)).replace("{,}", ",").replace("{.}", ".")
    text = "".join(unicodedata.normalize("NFKC", c) if "！" <= c <= "～" else c for c in text)
    text = text.replace("\N{NO-BREAK SPACE}", " ").replace("\N{NARROW NO-BREAK SPACE}", " ")
    text = _ANGLE.sub(r"\1°", _ONE_ARGUMENT.sub(r"\1", _SIUNITX.sub(r"\1 \2", text)))
    text = _RAISED_TEN.sub(lambda match: "10^" + match[1].translate(_RAISED), text)
    return re.sub(r"\s+", " ", _SPACE.sub(" ", text)).strip().rstrip(".,;:").strip()


def exponent_of(value: Fraction) -> int:
    """Return the power of ten of a number's first digit, 0 of zero."""
    if not value:
        return 0
    guess = math.floor(math.log10(abs(value)))
    return guess + 1 if abs(value) >= Fraction(10) ** (guess + 1) else guess


def _plain_digits(value: Fraction, place: Fraction | None) -> str:
    """Return a decimal's digits with a point, as many behind it as its last place has."""
    behind = 0 if place is None else max(0, -exponent_of(place))
    whole = str(round(value * 10**behind)).rjust(behind + 1, "0")
    return f"{whole[:-behind]}.{whole[-behind:]}" if behind else whole


_NO_LETTERS = re.compile(
    r"\\(?:cdot|times|[dt]?frac|pi|sqrt|left|right|div|begin|end|aligned?|quad)(?![A-Za-z])|&[a-z]+;|</?[a-z]+>"
)


def has_letters(source: str) -> bool:
    """Tell whether a text has letters, be it of units, beside the signs of what is calculated."""
    return any(each.isalpha() and each != "π" for each in _NO_LETTERS.sub(" ", source))


def nearer(first: Fraction, second: Fraction) -> bool:
    """Tell whether a ratio is nearer to 1 than another."""
    return first > 0 and (second <= 0 or abs(math.log(first)) < abs(math.log(second)))


# What is wrong with a number, in words


def corrected(claim: WrittenNumber, value: Fraction) -> Iterator[tuple[str, WrittenNumber]]:
    """Yield what a wrong number should be, with what is wrong in words: shorter numbers first.

    The same digits with another prefix of the unit; else as many digits as were typed, then one more.
    """
    own = Fraction(claim.factor) * claim.size
    ratio = float(value / own)
    for unit, scale in _other_prefixes(claim):
        other = claim.in_unit(unit, scale)
        if _agrees(ratio, float(scale / claim.scale), claim):
            yield f"unit: {unit}, not {claim.unit}", other
    words = _words_of_factor(ratio, claim)
    if (number := claim.at_its_place(value)) is not None:
        yield _words(ratio, claim, number), number
    for digits in range(claim.digits if not words else claim.counted, MOST_DIGITS + 1):
        number = claim.with_value(value, digits)
        if (number.mantissa, number.power) != (claim.mantissa, claim.power):
            yield _words(ratio, claim, number), number


def _other_prefixes(claim: WrittenNumber) -> Iterator[tuple[str, Fraction]]:
    """Yield the claim's unit with other prefixes, where a thousand or a million lies between."""
    if not claim.unit or claim.of_pi or claim.is_bare:
        return
    stems = [claim.unit]
    if claim.unit[0] in "kMGmc" and len(claim.unit) > 1 and scale_of(claim.unit[1:]) is not None:
        stems.append(claim.unit[1:])
    for stem in stems[::-1]:
        for prefix in _PREFIXES:
            scale = scale_of(prefix + stem)
            steps = (Fraction(1000), Fraction(1, 1000), Fraction(10**6), Fraction(1, 10**6))
            if scale is not None and not scale[1] and scale[0] / claim.scale in steps:
                yield prefix + stem, scale[0]


def _agrees(ratio: float, factor: float, claim: WrittenNumber) -> bool:
    """Tell whether a ratio is a factor as exactly as the digits of the claim say."""
    rounded = 1.5 * float(claim.place or 1) / abs(float(claim.mantissa))  # what it is of is rounded too
    return abs(ratio / factor - 1) <= min(rounded, 0.02)


_FACTORS = {
    "sign": -1.0,
    "ten times too small": 10.0,
    "ten times too large": 0.1,
    "a hundred times too small": 100.0,
    "a hundred times too large": 0.01,
    "a thousand times too small": 1000.0,
    "a thousand times too large": 0.001,
    "factor 2: half of what it is": 2.0,
    "factor 1/2: twice what it is": 0.5,
}


def _words_of_factor(ratio: float, claim: WrittenNumber) -> str:
    """Return which factor is wrong, "" for none; the closing zeros of 57750 for 5775.2 count as none."""
    bare = replace(claim, mantissa=claim.mantissa / 10 ** (claim.digits - claim.counted))
    for words, factor in _FACTORS.items():
        if _agrees(ratio, factor, bare if "times" in words and claim.place is None else claim):
            return words
    return ""


def _words(ratio: float, claim: WrittenNumber, number: WrittenNumber) -> str:
    """Return what is wrong: the sign, a power of ten, a factor 2, two digits; else "value"."""
    if words := _words_of_factor(ratio, claim):
        return words
    mine, right = (
        re.sub("[^0-9]", "", _plain_digits(abs(each.mantissa), each.place)).strip("0")
        for each in (claim, number)
    )
    is_swapped = len(mine) == len(right) and sorted(mine) == sorted(right) and mine != right
    if is_swapped and sum(a != b for a, b in zip(mine, right, strict=True)) == 2:
        return "digits exchanged"
    return "value"
