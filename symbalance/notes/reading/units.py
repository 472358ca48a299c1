"""Units behind numbers, read as factors: 40 mm is 40·(1/1000), 6000 rpm is 6000·(π/30), 3 N is 3."""

from __future__ import annotations

import re
from collections.abc import Collection
from fractions import Fraction

from symbalance.document.wordlists import word_set, words

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
    "cc": Fraction(1, 10**6), "Nmm": Fraction(1, 1000), "kNmm": Fraction(1),
}  # fmt: skip
_UNITS = {p + unit: scale for unit in _PREFIXED for p, scale in _PREFIXES.items()} | _OTHER
_UNITS |= {p + "g": scale / 1000 for p, scale in _PREFIXES.items()}
_TURNS = {**dict.fromkeys(words("rpm 1/min min^-1 r/min rev/min U/min tr/min Umin^-1"), Fraction(1, 30))}
_TURNS |= {"rps": Fraction(2), "rev/s": Fraction(2)}
_PLAIN_SURE = word_set("mm cm km kg rpm kW kHz Hz")

_MOST_PARTS, _LONGEST = 6, 100

_PART = re.compile(r"(1(?=/)|[A-Za-z]+)(?:\^(-?[0-9]))?")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−µμ", "0123456789--uu")
_RAISED_RUN = re.compile("[⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]")
_INNER_FONT = re.compile(r"\\(?:mathrm|text|textrm|rm)(?![A-Za-z])")
_SEPARATOR = re.compile(r"\\[,;: ]|~|\\cdot(?![A-Za-z])|[·⋅*.\s]")
_COMMAND = r"\\(?:mathrm|text|textrm|mbox|unit|si)\s*"
_ARGUMENT = r"\{(?P<word>(?:[^{}]|\{[^{}]{0,20}\}){1,60})\}(?:\s*\^\s*(?:\{\s*[-−]?\s*[0-9]\s*\}|[0-9]))?"
_SET = re.compile(rf"{_COMMAND}{_ARGUMENT}")
_UNNAMED = _SET.pattern.replace("?P<word>", "?:")
_FRACTION = re.compile(rf"\\[dt]?frac\s*\{{\s*({_UNNAMED}|1)\s*\}}\s*\{{\s*({_UNNAMED})\s*\}}")
_MORE = re.compile(rf"(?:\\[,;: ]|~|\\cdot(?![A-Za-z])|[·/\s]){{0,6}}{_COMMAND}{_ARGUMENT}")
_BRACKETED = re.compile(rf"\[\s*(?:{_UNNAMED}|[A-Za-zµμ/^0-9·⁻¹² -]{{1,20}})\s*\]")
_WORD = r"[A-Za-zµμ]+(?:(?:\^[-−]?[0-9]|[⁻]?[¹²³])?(?:/[A-Za-z]+(?:\^[0-9]|[²³])?)?)"
PLAIN = re.compile(rf"(?<=[0-9]) (?P<plain>{_WORD})(?![A-Za-z0-9_(^'])")


def scale_of(unit: str) -> Scale | None:
    """Return what a unit multiplies its number by, None for no unit.

    >>> scale_of("mm"), scale_of("m/s^2"), scale_of("rpm"), scale_of("furlong")
    ((Fraction(1, 1000), False), (Fraction(1, 1), False), (Fraction(1, 30), True), None)
    """
    plain = _plain(unit)
    if len(plain) > _LONGEST:
        return None
    if plain in _TURNS:
        return _TURNS[plain], True
    scale, place, power = Fraction(1), 0, 1
    while place < len(plain):
        match = _PART.match(plain, place)
        size = match and (Fraction(1) if match.group(1) == "1" else _UNITS.get(match.group(1)))
        if not match or not size:
            return None
        scale *= size ** (power * int(match.group(2) or 1))
        place = match.end()
        sign = plain[place : place + 1]
        if sign and sign not in " /":
            return None
        power, place = (-1 if sign == "/" else 1), place + 1
    return (scale, False) if plain and plain[-1] not in " /" else None


def _plain(unit: str) -> str:
    """Return a unit without LaTeX: one space between the parts of a product."""
    text = re.sub(r"\\mu\s*", "u", _INNER_FONT.sub("", unit))
    text = _RAISED_RUN.sub(lambda match: "^" + match.group(), text)
    text = _SEPARATOR.sub(" ", text.translate(_RAISED))
    text = text.replace("{", "").replace("}", "")
    return re.sub(r"\s*([/^-])\s*", r"\1", re.sub(r"\s+", " ", text)).strip()


def unit_set_at(text: str, place: int, end: int) -> tuple[str, int] | None:
    """Return the unit in \\mathrm{ } and its kin at a place, and where it ends; None if none begins."""
    match = _SET.match(text, place, end)
    if not match:
        return None
    stop = match.end()
    for _ in range(_MOST_PARTS):
        more = _MORE.match(text, stop, end)
        if not more or not scale_of(more.group("word")):
            break
        stop = more.end()
    return _bare(text[place:stop]), stop


def unit_fraction_at(text: str, place: int, end: int) -> tuple[str, int] | None:
    """Return the unit \\frac{\\mathrm{m}}{\\mathrm{s}^2} at a place as m/s^2, and where it ends."""
    match = _FRACTION.match(text, place, end)
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
    """Return the unit in `40 mm` whose space is at a place; letters declared one by one are letters."""
    match = PLAIN.match(text, place, end)
    if not match or not scale_of(match.group("plain")):
        return None
    word = match.group("plain")
    words = re.findall("[A-Za-z]+", word)
    if any(word_part in names for word_part in words) or len(word) == 1 or words[0] == "us":
        return None
    sure = words[0] in _PLAIN_SURE or not all(letter in names for letter in words[0])
    return (word, match.end()) if sure else None


def follows_number(text: str, start: int, place: int) -> bool:
    """Tell whether a number or bracket ends before a place, spaces apart."""
    before = re.sub(r"(?:\s|~|\\[,;: ])+$", "", text[max(start, place - 40) : place])
    before = re.sub(r"\\pi$", "1", before)
    return before[-1:].isdecimal() or before[-1:] in ("}", ")", "]")


def is_set_apart(text: str, place: int) -> bool:
    """Tell whether a space typed as such, \\, or ~, stands before a place."""
    return re.search(r"(?:~|\\[,;: ])\s*$", text[max(0, place - 20) : place]) is not None
