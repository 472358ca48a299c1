"""Formulas between the numbers of units that words give their letters: T = P/(2πn), n in min⁻¹.

Where a page says that P is in W, T in N m and n in min⁻¹, its formula is one between these numbers, and
needs the 60 that a formula between quantities does without. With all units put in such a formula has a
pure factor, 1, 2, π or g. One that has it as it stands and not with its units is a formula between
quantities: wrong beside such words, and open where the units stand elsewhere on the page.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import isclose, log10, pi

from symbalance.document.formula import Formula, Name, Negative, Number, Power, Product, Quotient, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.units.dimensions import Dimension, unit_of
from symbalance.notes.checking.units.own_units import ANGULAR_LETTERS
from symbalance.notes.checking.units.worded_units import worded_unit
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.notes.reading.formulas.result_units import value_of
from symbalance.notes.reading.spellings.numerals import unit_in_words
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

LETTER_SIGN = (
    r"(?<![\w\\^{])\$?(?P<letter>\\?[^\W\d_]+(?:_(?:\{[A-Za-z0-9,]{1,8}\}|[A-Za-z0-9]))?"
    r""
    r"|[A-Za-z][₀-₉ₐ-ₜ]?)\$?"
)
_WORD = r"[A-Za-z1µ°][A-Za-zµ0-9/²³⁴⁻¹^·.°\\-]{0,20}"
UNIT_SIGNS = rf"(?P<unit>{_WORD}(?:\s{_WORD}){{0,3}})"
SAID = re.compile(
    rf"{LETTER_SIGN}(?:\s+(?:is|are|being|be|always|again|measured|given|taken|expressed|counted|ist|wird|gemessen|eingesetzt))*"
    rf",?\s*(?:(?:\(\s*)?\b(?:in|en)\s+|\[|\((?=[A-Za-z1]))(?:the\s+unit\s+)?\$?(?:\\(?:mathrm|text|unit|si)\s*\{{)?(?={UNIT_SIGNS})",
    re.IGNORECASE,
)
"""P is in W; torque T in N m; speed n [rpm]; ω (in rad/s)."""
_ROW = re.compile(
    r"^\s*\|\s*\$?(?P<letter>\\?[^\W\d_]+(?:_(?:\{[A-Za-z0-9,]{1,8}\}|[A-Za-z0-9]))?)\$?\s*\|(?P<cells>[^\n]*)\|\s*$",
    re.MULTILINE,
)
LISTED = re.compile(
    rf"(?:^|[.;]\s)\s*(?:[-*]\s)?\$?(?P<letter>\\?[^\W\d_]+(?:_[A-Za-z0-9])?)\$?\s?[:–]\s[^.;:\n=|]{{3,40}}?,\s{UNIT_SIGNS}(?=\s*[.;\n]|$)",
    re.MULTILINE,
)
_BEHIND = re.compile(rf"[\s$]{{0,3}}(?:\[|\(in\s|in\s){UNIT_SIGNS}")
"""Behind a formula, the unit of its letter: ω = 2πn [rad/s]."""
_SIMPLE, _PURE_PARTS = (1.0, 2.0, 4.0, 8.0, 0.5, 0.25, 0.125), (-1, 0, 1, 2)
_PURE = tuple(
    simple * pi**power * 9.80665**weight
    for simple, power, weight in product(_SIMPLE, _PURE_PARTS, (-1, 0, 1))
)
"""What a formula between quantities may have as its factor."""
_USUAL = (1.0, 2.0, 0.5, pi, 2 * pi, 1 / (2 * pi), 1 / pi, 4 * pi**2)
"""Factors that a wrong constant is measured by: 955 for 9550."""
_SLIPS = tuple(60.0**power * 10.0**shift for power in (-1, 0, 1) for shift in range(-6, 7))
_ROUGH = 0.002
_SECOND = Fraction(60)


@dataclass(frozen=True, slots=True)
class StatedUnit:
    """A unit that words give a letter: its text, what it multiplies by, and where it stands."""

    text: str
    dimension: Dimension
    scale: Fraction
    place: int


class StatedUnits:
    """The units that the words of one page give its letters."""

    def __init__(self, document: ReadNotes) -> None:
        self.document = document
        self._letters = {name for chain in document.chains for name in chain.letters}
        self._written = {w: n for n in self._letters for w in (n, plain_letter(n))}
        self._units: dict[str, list[StatedUnit]] | None = None

    @property
    def units(self) -> dict[str, list[StatedUnit]]:
        """The units of each letter."""
        if self._units is None:
            self._units = {}
            for letter, text, place in self._statements():
                name = self._written.get(letter.lstrip("\\").replace("{", "").replace("}", ""))
                unit = None if name is None else stated_unit(text, place)
                if name is not None and unit is not None:
                    self._units.setdefault(name, []).append(unit)
        return self._units

    def _statements(self) -> Iterator[tuple[str, str, int]]:
        text = self.document.text
        formulas = sorted(side.span for chain in self.document.chains for side in chain.sides[1:])
        firsts = [first for first, _ in formulas]
        for pattern in (SAID, LISTED):
            for match in pattern.finditer(text):
                place = bisect_right(firsts, match.start("letter")) - 1
                if place >= 0 and match.start("letter") < formulas[place][1]:
                    continue  # behind ω = 2πn it is the unit of ω
                yield match["letter"], match["unit"], match.start("letter")
        for row in _ROW.finditer(text):
            for cell in row["cells"].split("|")[1:]:
                yield row["letter"], cell.strip(" $[]()"), row.start()

    def decide(self, chain: Chain, k: int) -> Decision | None:
        """Return that a formula is none between the numbers of its letters' units; None for others."""
        head, right = chain.sides[0].node, chain.sides[1].node
        own = names(right)
        is_formula = not k and own and len(chain.relations) == 1
        powers = powers_of(right) if is_formula else None
        if powers is None or not isinstance(head, Name) or head.name in own:
            return None
        factor, letters = powers
        units = {name: self._unit_of(name, chain) for name in (head.name, *letters)}
        if behind := self._behind(chain):
            units[head.name] = behind
        given = [unit for unit in units.values() if unit is not None]
        if not given or self._puts_numbers_in(chain) or not factor:
            return None
        scale = scale_between(head.name, letters, units)
        if scale is None or isclose(scale, 1, rel_tol=1e-9) or _is_pure(factor / scale):
            return None
        first = self._start_of_paragraph(chain)
        is_whole = all(
            unit is not None or name.partition("_")[0] in ANGULAR_LETTERS for name, unit in units.items()
        )
        is_near = all(first <= unit.place <= chain.end + 200 for unit in given)
        shown = ", ".join(f"{plain_letter(n)} in {u.text}" for n, u in units.items() if u is not None)
        reason = f"no formula between these numbers: {shown}"
        if _is_pure(factor) and self._goes_over_to_numbers(chain, given):
            return None
        if _is_pure(factor):
            is_sure = is_whole and is_near
            return Decision(REFUTED if is_sure else UNDECIDED, f"{reason}; nothing converts them")
        ratio = factor / scale
        is_slip = any(s != 1 and are_near(ratio * s, each) for s in _SLIPS for each in _USUAL)
        is_wrong = is_whole and is_slip and _has_whole_constants(right)
        return Decision(REFUTED, f"{reason}; its constant does not convert them") if is_wrong else None

    def _unit_of(self, name: str, chain: Chain) -> StatedUnit | None:
        """Return the unit of a letter: of its own paragraph if that gives one, or the page's only one."""
        every = self.units.get(name, [])
        first = self._start_of_paragraph(chain)
        last = self._end_of_paragraph(chain)
        near = [unit for unit in every if first <= unit.place <= last]
        chosen = near or every
        scales = {unit.scale for unit in chosen}
        return chosen[0] if len(scales) == 1 else None

    def _behind(self, chain: Chain) -> StatedUnit | None:
        match = _BEHIND.match(self.document.text, chain.end)
        return None if match is None else stated_unit(match["unit"], match.start())

    def _goes_over_to_numbers(self, chain: Chain, given: list[StatedUnit]) -> bool:
        """Tell whether units are put in behind a law between quantities: from P = T ω, with P in kW, …"""
        behind = self.document.text[chain.end : self._end_of_paragraph(chain)]
        return all(unit.place > chain.end for unit in given) and _NUMERICAL.search(behind) is not None

    def _start_of_paragraph(self, chain: Chain) -> int:
        """Return where the paragraph of a formula begins, be it the one above its display."""
        text, start = self.document.text, chain.start
        place = text.rfind("\n\n", 0, start)
        if place >= 0 and not text[place:start].strip(" \n$\\[{}abegilnqtuo"):
            place = text.rfind("\n\n", 0, place)
        return max(place, 0)

    def _end_of_paragraph(self, chain: Chain) -> int:
        place = self.document.text.find("\n\n", chain.end)
        return len(self.document.text) if place < 0 else place

    def _puts_numbers_in(self, chain: Chain) -> bool:
        """Tell whether numbers are put into a letter's formula on the page, 2π·50: so in its units."""
        head = chain.sides[0].node
        for other in self.document.chains:
            nodes = [side.node for side in other.sides]
            numbers = [node for node in nodes if not names(node)]
            arithmetics = [n for n in numbers if isinstance(n, Product | Quotient | Power)]
            if nodes[0] == head and any(value_of(node) is not None for node in arithmetics):
                return True
        return False


def stated_unit(text: str, place: int) -> StatedUnit | None:
    """Return the longest unit that a text begins with; None for none."""
    words = _BRACED.sub(r"\1", text.replace("\\,", " ")).split()
    last = next((n for n, word in enumerate(words) if word.lower() in _NO_UNITS), len(words))
    for count in range(last, 0, -1):
        source = " ".join(words[:count]).strip(".,;:()[]}$")
        in_words = unit_in_words(source) if _WORDS.fullmatch(source) else ""
        for sign in (source, in_words):
            scale, dimension = (scale_of(sign), unit_of(sign)) if sign else (None, None)
            if scale is not None and dimension is not None:
                size = scale[0] / 2 if scale[1] else scale[0]
                return StatedUnit(source, dimension, size, place)
    return _spelled_unit(" ".join(words[:last]), place)


def _spelled_unit(text: str, place: int) -> StatedUnit | None:
    """Return the unit that a text begins with in words: megapascals, revolutions per second."""
    unit = worded_unit(text) if re.match(r"[A-Za-zÀ-ÿ]{4,}", text) else None
    if unit is None:
        return None
    turns = unit.scale / (2 * pi) if unit.is_rate else 0.0
    size = Fraction(turns).limit_denominator(60) if turns else Fraction(str(unit.scale))
    is_angular = unit.is_rate and isclose(unit.scale, 1)
    return StatedUnit(unit.text, unit.dimension, Fraction(1) if is_angular else size, place)


_NUMERICAL = re.compile(
    r"numerical\s+(?:relation|equation|formula|value)|(?<![^\W\d_])(?:insert|put|plug|substitut)\w*[^.]{0,60}\s+in\s"
    r"|Zahlenwertgleichung|zugeschnittene\w*\s+Größengleichung|(?:formule|équation)\s+(?:aux\s+valeurs\s+)?numérique|(?:formula|equazione)\s+numerica"
    r"|(?:fórmula|ecuación)\s+numérica|数値(?:式|方程式)",
    re.IGNORECASE,
)
"""Words by which a law between quantities becomes an equation between numbers."""
_BRACED = re.compile(r"\{\s*([-−]?\s*[0-9])\s*\}")
_WORDS = re.compile(r"[A-Za-z][a-z]{3,}(?:\s(?:per|a|[a-z]{3,}))*")
_NO_UNITS = frozenset(
    ["and", "the", "a", "an", "in", "at", "is", "of", "und", "et", "with", "mit", "so", "for", "we", "h"]
)


def scale_between(
    head: str, letters: dict[str, Fraction], units: dict[str, StatedUnit | None]
) -> float | None:
    """Return by how much a formula between quantities changes when its letters are numbers of units.

    Letters without a unit are taken in SI. None where the units stated do not make that of the head.
    """
    scale = 1.0
    dimensions = []
    for name, power in ((head, Fraction(-1)), *letters.items()):
        unit = units[name]
        if unit is None:
            continue
        scale *= float(unit.scale) ** float(power)
        dimensions.append(tuple(power * each for each in unit.dimension))
    total = [sum(parts) for parts in zip(*dimensions, strict=True)]
    is_whole = all(unit is not None for unit in units.values())
    return None if is_whole and any(total) else scale


def powers_of(node: Formula) -> tuple[float, dict[str, Fraction]] | None:
    """Return the factor of a product of powers of letters, and these; None for sums and functions."""
    factor, letters = 1.0, dict[str, Fraction]()
    parts: list[tuple[Formula, Fraction]] = [(node, Fraction(1))]
    while parts:
        part, power = parts.pop()
        match part:
            case Product(factors=factors):
                parts += [(each, power) for each in factors]
            case Quotient(numerator=above, denominator=below):
                parts += [(above, power), (below, -power)]
            case Negative(operand=operand):
                parts.append((operand, power))
            case Power(base=base, exponent=Number(value=exponent)) if names(base):
                parts.append((base, power * exponent))
            case Name(name=name):
                letters[name] = letters.get(name, Fraction(0)) + power
            case _:
                value = None if names(part) else value_of(part)
                if not value or value < 0:
                    return None
                factor *= value ** float(power)
    return factor, letters


def _has_whole_constants(node: Formula) -> bool:
    """Tell whether the numbers of a formula are whole, or powers of ten."""
    parts = [node]
    while parts:
        part = parts.pop()
        if isinstance(part, Number) and part.value.denominator != 1:
            return isclose(log10(part.value) % 1, 0, abs_tol=1e-9)
        if isinstance(part, Product):
            parts += part.factors
        elif isinstance(part, Quotient):
            parts += [part.numerator, part.denominator]
    return True


def _is_pure(factor: float) -> bool:
    return any(are_near(factor, one) for one in _PURE)


def are_near(value: float, one: float) -> bool:
    """Tell whether two constants are the same, as printed."""
    return abs(value / one - 1) < _ROUGH
