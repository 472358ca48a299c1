r"""Numbers that do not stand behind the name of a size: an 86 mm bore, from 8 to 2 mm in five periods.

The name of a size may stand behind its number, the names of two sizes before both numbers, and the
amplitude of an oscillation falls from one number to another in a number of periods.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from symbalance.text import lazy_patterns as re

_UNITS = {"mm": 1e-3, "cm": 1e-2, "dm": 0.1, "m": 1.0}
_DIGITS = r"(?<![0-9.,])[0-9]{1,5}(?:[.,][0-9]{1,4})?(?![0-9])"
_SPACE = r"(?:\s|\$|\\[,;: ]|~|\\(?:mathrm|text|rm)(?![A-Za-z])|[{}])*"
_BORE = (
    r"(?:bores?|bohrung|zylinderbohrung|alésage|alesaggio)(?![^\W\d_])|(?:シリンダ(?:ー)?)?(?:ボア|内径)"
)
_STROKE = (
    r"(?:(?:piston\s+)?strokes?|kolbenhub|hub|course|corsa|carrera)(?![^\W\d_])|ストローク|行程(?!容積)"
)
_LINK = r"(?:(?:of|de|di|in|d['’]|の)\s*)?(?:(?:cylinder|piston)\s+)?"
_BEHIND = re.compile(
    rf"(?P<number>{_DIGITS}){_SPACE}(?P<unit>mm|cm|dm|m)(?![A-Za-z0-9²³^/]){_SPACE}{_LINK}"
    rf"(?:(?P<bore>{_BORE})|(?P<stroke>{_STROKE}))(?!\s*[=:]?\s*{_SPACE}[0-9])",
    re.IGNORECASE,
)
"""A number with the name of its size behind it, which has no other number behind it: 86 mm bore."""
_PAIR = re.compile(
    rf"(?:{_BORE})[\s,]{{0,2}}(?:and|und|et|e|y|x|by|×|と|・|/)?\s?(?:the\s+)?(?:{_STROKE})[^.;\n0-9]{{0,25}}?"
    rf"(?P<first>{_DIGITS}){_SPACE}(?P<unit>mm|cm)?{_SPACE}(?:and|und|et|e|y|x|×|\\times|by|と|,|/){_SPACE}"
    rf"(?P<second>{_DIGITS}){_SPACE}(?P<last>mm|cm)(?![A-Za-z0-9²³^/])",
    re.IGNORECASE,
)
"""Both names and then both numbers: bore and stroke are 80 mm and 90 mm."""
_LENGTH = rf"{_SPACE}(?:mm|cm|m|µm|\\mu\s?m|°|\\circ|degrees|grad)?{_SPACE}"
_FALL = re.compile(
    rf"(?<![^\W\d_])(?:from|von|de|da|desde){_SPACE}(?P<first>{_DIGITS}){_LENGTH}(?:down\s+)?(?:to|auf|à|a|hasta){_SPACE}(?P<second>{_DIGITS})",
    re.IGNORECASE,
)
_FALL_BEFORE = re.compile(
    rf"(?P<first>{_DIGITS}){_LENGTH}から{_SPACE}(?P<second>{_DIGITS}){_LENGTH}(?:に|へ|まで)"
)
"""An amplitude falls from the first number to the second."""
_AMPLITUDE = re.compile(
    r"amplitude|ampiezza|amplitud|ausschl[aä]g|peak|displacement|deflection|振幅|変位", re.IGNORECASE
)
_WORDS = {
    2: "two zwei deux due dos", 3: "three drei trois tre tres", 4: "four vier quatre quattro cuatro",
    5: "five fünf cinq cinque cinco", 6: "six sechs sei seis", 7: "seven sieben sept sette siete",
    8: "eight acht huit otto ocho", 9: "nine neun neuf nove nueve", 10: "ten zehn dix dieci diez",
    12: "twelve zwölf douze dodici doce", 20: "twenty zwanzig vingt venti veinte",
}  # fmt: skip
_COUNTS = {word: count for count, words in _WORDS.items() for word in words.split()}
_CYCLES = re.compile(
    rf"(?<![\w.,])(?P<count>[1-9][0-9]?|{'|'.join(_COUNTS)})\$?[\s-]?(?:(?:full|complete|whole|ganzen?|vollen?)\s+)?"
    r"(?:cycles|periods|oscillations|vibrations|perioden|schwingungen|périodes|periodi|oscillazioni|períodos"
    r"|periodos|oscilaciones|ciclos|cicli|周期|サイクル|回の振動)",
    re.IGNORECASE,
)
"""Over how many periods it does so."""


@dataclass(frozen=True, slots=True)
class Lengths:
    """The sizes of bore and stroke that words give in these ways, and the places of their numbers."""

    diameter: tuple[float, ...]
    stroke: tuple[float, ...]
    places: frozenset[int]
    """Where each of the numbers begins, which is of no other name then."""

    def of(self, role: str) -> tuple[float, ...]:
        """Return the sizes of a role."""
        return {"diameter": self.diameter, "stroke": self.stroke}.get(role, ())


def lengths_beside(text: str) -> Lengths:
    """Return what a text gives bore and stroke with the number before the name, or behind both.

    >>> lengths_beside("an 86 mm bore and a 92 mm stroke").stroke
    (0.092,)
    >>> found = lengths_beside("Bore and stroke are 80 mm and 90 mm.")
    >>> found.diameter, found.stroke
    ((0.08,), (0.09,))
    """
    sizes: dict[str, list[float]] = {"diameter": [], "stroke": []}
    places: set[int] = set()
    for match in _PAIR.finditer(text):
        units = match["unit"] or match["last"], match["last"]
        for role, group, unit in zip(sizes, ("first", "second"), units, strict=True):
            sizes[role].append(_number(match[group]) * _UNITS[unit.lower()])
            places.add(match.start(group))
    for match in _BEHIND.finditer(text):
        if match.start("number") not in places:
            role = "diameter" if match["bore"] else "stroke"
            sizes[role].append(_number(match["number"]) * _UNITS[match["unit"].lower()])
            places.add(match.start("number"))
    return Lengths(tuple(sizes["diameter"]), tuple(sizes["stroke"]), frozenset(places))


def decays_beside(text: str) -> Iterator[tuple[str, float]]:
    """Yield the first and last amplitude of an oscillation that decays, and its number of periods.

    >>> dict(decays_beside("In five periods the amplitude falls from 8 mm to 2 mm."))
    {'first_peak': 8.0, 'later_peak': 2.0, 'cycles': 5.0}
    """
    if not _AMPLITUDE.search(text):
        return
    falls = [match for each in (_FALL, _FALL_BEFORE) for match in each.finditer(text)]
    cycles = [_CYCLES.search(text)]
    for fall, count in product(falls, cycles):
        if count is None or _number(fall["second"]) >= _number(fall["first"]):
            return
        yield "first_peak", _number(fall["first"])
        yield "later_peak", _number(fall["second"])
        yield "cycles", float(_COUNTS.get(count["count"].casefold()) or int(count["count"]))


def speaks_of_cycles(text: str) -> bool:
    """Tell whether a text counts periods: over the five periods it is ln 4."""
    return _CYCLES.search(text) is not None


def _number(text: str) -> float:
    return float(text.replace(",", "."))
