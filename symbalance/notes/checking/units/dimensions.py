"""Dimensions of formulas by the units their letters are declared with: F = m r in newtons cannot be.

A letter has a dimension by the unit in its declaration ("force, N", "kg mm"), by its meaning (a crank
radius is a length) or by the unit of the number it is. What has none is open, and so is everything it
stands in: nothing is accused on a guess. Numbers that are put in may carry units in silence: a decimal,
or a large number, is open too. A unit written at a number counts: 1 N is no joule, and 2 m + 3 s is
nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Name, Number, names, walk
from symbalance.document.letters import raised
from symbalance.document.text_writer import formula_text
from symbalance.document.wordlists import words
from symbalance.notes.checking.declared.symbol_roles import FROM_MIDDLE, FROM_PIN, FROM_TOP, role_of
from symbalance.notes.checking.units.own_units import is_per_minute_number
from symbalance.notes.checking.units.sizes_by_words import unit_by_words
from symbalance.notes.reading.markup import siunitx
from symbalance.notes.reading.spellings.joined_units import may_be_of_milliseconds, signs_apart
from symbalance.notes.reading.spellings.numerals import sign_of_unit
from symbalance.notes.reading.units import GRAVITY, divisors_apart
from symbalance.text import lazy_patterns as re

Dimension = tuple[Fraction, ...]
"""Exponents of kg, m, s, K and A."""
_BASE = ("kg", "m", "s", "K", "A")
NONE: Dimension = (Fraction(0),) * len(_BASE)
FEWEST_OF_AN_AMOUNT = 10
"""Before a sine: 1 - 2 cos θ is a number, 180 sin θ may be newton metres."""
LARGEST_COUNTED, LARGEST_PLAIN = 10, 64
"""A whole number up to the first is a factor of the formula, up to the second a product of 2 and 3 as in
π d⁴/64, or that of a turn by the minute; 40 may be in hertz, 1000 a change of unit."""
_OF_MINUTES = (30, 60, 120)


def _dimension(kg: int = 0, m: int = 0, s: int = 0, kelvin: int = 0, ampere: int = 0) -> Dimension:
    return tuple(Fraction(e) for e in (kg, m, s, kelvin, ampere))


_UNITS: dict[str, Dimension] = {
    "m": _dimension(m=1), "g": _dimension(kg=1), "s": _dimension(s=1), "K": _dimension(kelvin=1),
    "A": _dimension(ampere=1), "N": _dimension(1, 1, -2), "J": _dimension(1, 2, -2),
    "W": _dimension(1, 2, -3), "Pa": _dimension(1, -1, -2), "Hz": _dimension(s=-1),
    "rad": NONE, "Nm": _dimension(1, 2, -2), "Ns": _dimension(1, 1, -1), "V": _dimension(1, 2, -3, 0, -1),
}  # fmt: skip
_WHOLE_UNITS: dict[str, Dimension] = {
    "min": _dimension(s=1), "h": _dimension(s=1), "bar": _dimension(1, -1, -2), "rpm": _dimension(s=-1),
    "rps": _dimension(s=-1), "rev": NONE, "r": NONE, "U": NONE, "deg": NONE, "°": NONE, "1": NONE,
    "mol": NONE, "kmol": NONE,
    "%": NONE, "t": _dimension(kg=1), "l": _dimension(m=3), "L": _dimension(m=3),
    "Nmm": _dimension(1, 2, -2), "kNm": _dimension(1, 2, -2), "degrees": NONE, "radians": NONE,
    **dict.fromkeys(words("gmm kgmm gcm kgcm mkg cmkg"), _dimension(kg=1, m=1)),
    "cc": _dimension(m=3), "ccm": _dimension(m=3), "inch": _dimension(m=1), "ft": _dimension(m=1),
    "gn": _dimension(m=1, s=-2), "mi": _dimension(m=1), "slug": _dimension(kg=1),
    "slugs": _dimension(kg=1),
    "psi": _dimension(1, -1, -2), "Ω": _dimension(1, 2, -3, 0, -2),
    "mph": _dimension(m=1, s=-1), "knot": _dimension(m=1, s=-1), "knots": _dimension(m=1, s=-1),
    "mbar": _dimension(1, -1, -2), "hPa": _dimension(1, -1, -2), "daN": _dimension(1, 1, -2),
    "Ncm": _dimension(1, 2, -2), "Wh": _dimension(1, 2, -2), "kWh": _dimension(1, 2, -2),
    **dict.fromkeys(words("lbf kp kgf"), _dimension(1, 1, -2)),
    **dict.fromkeys(words("hp bhp HP PS CV ch"), _dimension(1, 2, -3)),
}  # fmt: skip
_PREFIXES = ("", "k", "M", "G", "c", "d", "m", "u", "n")
_PREFIXED = {p + unit: size for unit, size in _UNITS.items() for p in _PREFIXES}
_BY_NAME = _PREFIXED | _WHOLE_UNITS
_QUANTITIES = frozenset(
    (
        *_UNITS.values(),
        *(_dimension(m=power) for power in (-1, 2, 3, 4)),
        *(_dimension(m=1, s=-1), _dimension(m=1, s=-2), _dimension(s=-2), _dimension(s=2)),
        *(_dimension(kg=1, m=1), _dimension(kg=1, m=2), _dimension(1, -3), _dimension(1, 0, -2)),
        *(_dimension(1, 0, -1), _dimension(1, 2, -1), _dimension(-1, 0, 2)),
        *(_dimension(-1), _dimension(-1, 1)),
    )
)
"""What a number may be in that has its unit in silence: quantities that engineers put numbers in for."""
_LENGTH, _SPEED, _ACCELERATION = _dimension(m=1), _dimension(m=1, s=-1), _dimension(m=1, s=-2)
_ROLES: dict[str, Dimension] = {
    "crank angle": NONE,
    "rod angle": NONE,
    "crank radius": _LENGTH,
    "stroke": _LENGTH,
    "rod length": _LENGTH,
    "rod ratio l/r": NONE,
    "rod ratio l/s": NONE,
    "crank ratio r/l": NONE,
    "angular speed": _dimension(s=-1),
    "engine speed rpm": _dimension(s=-1),
    "time": _dimension(s=1),
    "reciprocating mass": _dimension(kg=1),
    FROM_TOP: _LENGTH,
    FROM_PIN: _LENGTH,
    FROM_MIDDLE: _LENGTH,
    "piston velocity": _SPEED,
    "piston acceleration": _ACCELERATION,
    "inertia force": _dimension(1, 1, -2),
    "cylinder pitch": _LENGTH,
    "integer": NONE,
}
_NO_SIZE = r"(?!ratio|relative|specific|reduced|dimensionless|number|half|mean|wave)"
_BY_WORDS = tuple(
    (size, re.compile(pattern, re.IGNORECASE))
    for size, pattern in (
        (_LENGTH, rf"(?:{_NO_SIZE}[a-z-]+ ){{0,2}}diameter|(?:shaft|spring|pendulum|total) length"),
        (_LENGTH, r"[a-zäöüß]*durchmesser(?: der welle)?|(?:wellen|feder)länge"),
        (_dimension(m=4), r"(?:polar )?(?:second moment of area|area moment of inertia)"),
        (_dimension(m=4), r"(?:polares )?flächenträgheitsmoment|断面二次(?:極)?モーメント"),
        (_dimension(m=3), r"(?:(?:polar|torsional|bending) )?section modulus|widerstandsmoment|断面係数"),
        (NONE, r"number of (?:cylinders|pistons|throws|cranks|teeth|blades|coils|springs|bolts|discs)"),
        (NONE, r"気筒数"),
        (NONE, r"zylinderzahl|anzahl der zylinder|nombre de cylindres"),
        (_dimension(1, -1, -2), r"(?:shear|young's|elastic) modulus|schubmodul|elastizitätsmodul"),
    )
)
"""Sizes by the words that declare them, where no unit stands behind."""
_SIGNS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−µμ·⋅*", "0123456789--uu   ")
_IN_BRACES = re.compile(r"\s*\{[^{}]*\}(?=.*[A-Za-z])", re.DOTALL)
_PART = re.compile(r"([A-Za-z°%]+|1(?![0-9]))(?:\^?\(?(-?[0-9])\)?)?$")
_WRITTEN_UNIT = re.compile(
    r"\\(?:mathrm|text|textrm|mbox|unit|si|SI|qty|rm)(?![a-z])|\[[^\[\]A-Za-z]*+[A-Za-z][^\[\]]*+\]"
    r"|[0-9](?:\s|~|\\[,;: ])*(?:mm|cm|km|kg|kN|MPa|GPa|rpm|kW|Hz|bar|rad|Nm)(?![A-Za-z_(^])"
)


_TYPED = re.compile(r"\\(?:SI|qty)\s*\{(?P<number>[^{}]*)\}\s*\{(?P<unit>[^{}]*)\}")
_EXPONENT = re.compile(r"\^\s*\{\s*([-−]?[0-9])\s*\}")
_BEFORE_EXPONENT = re.compile(r"(?<=[A-Za-z]) +\^")
"""The space that the brace around a unit leaves before its exponent, \\mathrm{s}^{-1}."""
_BRACKET_BEHIND = re.compile(r"(?:\\right\s?|\\[bB]igg?r\s?)?\)(?P<unit>[^()]{1,60})$")
"""The end of a sum in brackets, with its unit."""
_IN_FRACTION = r"\{((?:[^{}]|\{[^{}]{0,30}\}){1,60})\}"
_FRACTION = re.compile(rf"\\[dt]?frac\s?{_IN_FRACTION}\s?{_IN_FRACTION}")
_SETTING = re.compile(
    r"\\(?:mathrm|text|textrm|mbox|unit|si|rm|cdot|left|right|[bB]igg?[lr]?)(?![A-Za-z])"
    r"|\\[,;:! ]|[~${}()\[\]]"
)
_POWER_OF_TEN = re.compile(
    r"(?P<number>[0-9])(?:\s?(?:\\(?:cdot|times)|[·×⋅*]|\\?[,;:])\s?)+10(?:\^\s?(?:\{\s?[-−+]?[0-9]{1,2}\s?\}|[-−+]?[0-9]{1,2})"
    r"|[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,2})|(?<=[0-9])[eE][-+]?[0-9]{1,2}(?![0-9A-Za-z])"
)
"""The power of ten of a number between it and its unit: 1.8·10⁹ N."""
_QUANTITY = re.compile(
    r"\s*(?P<number>[-+−]?[0-9](?:[0-9.,]|\s[0-9]{3}(?![0-9]))*[½⅓⅔¼¾⅛⅜⅝⅞]?)?\s*(?P<unit>\S.*?)?[\s.,;]*$",
    re.DOTALL,
)


@dataclass(frozen=True, slots=True)
class Mismatch:
    """Two parts of a relation whose dimensions differ."""

    what: str
    left: Dimension
    right: Dimension

    @property
    def reason(self) -> str:
        """The mismatch in words."""
        return f"dimensions: {self.what} {unit_text(self.left)}, not {unit_text(self.right)}"


def unit_of(text: str) -> Dimension | None:
    """Return the dimension of a unit as it is declared, None for what is no unit.

    >>> unit_text(unit_of("kg mm")), unit_text(unit_of("N/mm^2")), unit_of("lever")
    ('kg m', 'kg m⁻¹ s⁻²', None)
    """
    if may_be_of_milliseconds(text):
        return None
    plain = re.sub(r"\s*/\s*", " / ", signs_apart(text).translate(_SIGNS).strip().strip("[]()"))
    total, sign = list(NONE), 1
    words = plain.split()
    if not words or len(words) > 12:
        return None
    for word in words:
        if word == "/":
            sign = -1
            continue
        match = _PART.fullmatch(word)
        size = match and _BY_NAME.get(match.group(1))
        if not match or size is None:
            return None
        power = sign * int(match.group(2) or 1)
        total = [a + power * b for a, b in zip(total, size, strict=True)]
        sign = 1
    return tuple(total)


def unit_text(dimension: Dimension) -> str:
    """Return a dimension as a product of base units, `1` for none."""
    parts = [
        unit + ("" if e == 1 else raised(str(e).replace("-", "−")))
        for unit, e in zip(_BASE, dimension, strict=True)
        if e
    ]
    return " ".join(parts) or "1"


def declared_dimension(meaning: str) -> Dimension | None:
    """Return the dimension a declaration states, by its unit or by its meaning; None if it is open.

    >>> unit_text(declared_dimension("force, N")), declared_dimension("offset")
    ('kg m s⁻²', None)
    """
    pieces = [piece.strip() for piece in meaning.split(",")]
    bracketed = re.findall(r"[\[(]([^\])]*)[\])]", meaning)
    role = _ROLES.get(role_of(meaning))
    if role is not None:
        return role
    for piece in (*pieces, *bracketed, *(p.split(" in ")[-1] for p in pieces if " in " in p)):
        dimension = unit_of(re.split(r"[:;]", piece)[0])
        if dimension is not None:
            return dimension
    size = next((size for size, words_of_it in _BY_WORDS if words_of_it.fullmatch(pieces[0])), None)
    return unit_of(unit_by_words(pieces[0])) if size is None else size


def written_unit(source: str) -> tuple[bool, str]:
    r"""Return whether a number stands in a source, and the unit written behind it, "" for none.

    >>> written_unit(r"5\,\mathrm{kg\,m/s^{2}}"), written_unit("$ mm")
    ((True, 'kg m/s^2'), (False, 'mm'))
    >>> written_unit(r"0{,}62\,\mathrm{kg}"), written_unit(r"22\,810")
    ((True, 'kg'), (True, ''))
    >>> written_unit(r"314\,\mathrm{s}^{-1}"), written_unit(r"5\,\text{kg m}^2")
    ((True, 's^-1'), (True, 'kg m^2'))
    >>> written_unit(r"1.8\cdot10^{9}\,\mathrm{N}"), written_unit("1.8·10⁹ N")
    ((True, 'N'), (True, 'N'))
    >>> written_unit("287 J/(kg K)"), written_unit(r"1\,\mathrm{kJ/(kg\,K)}")
    ((True, 'J/kg/K'), (True, 'kJ/kg/K'))
    >>> written_unit(r"2\,\mathrm{\frac{kg\,m}{s^{2}}}")
    (True, 'kg m/s^2')
    """
    source = source.replace("{,}", ",")  # no unit ", 62" behind 0
    if "frac" in source:
        source = _FRACTION.sub(_with_stroke, _EXPONENT.sub(r"^\1", source))
    typed = _TYPED.search(source)
    if typed is not None:
        source = f"{typed['number']} {siunitx.unit_text(typed['unit']) or '?'}"
    source = divisors_apart(_POWER_OF_TEN.sub(r"\g<number>", source))
    plain = _BEFORE_EXPONENT.sub("^", _SETTING.sub(" ", _EXPONENT.sub(r"^\1", source)))
    match = _QUANTITY.match(plain)
    if match is None:
        return False, ""
    return match["number"] is not None, " ".join((match["unit"] or "").split())


def _with_stroke(match: re.Match[str]) -> str:
    """Return a fraction of units with a stroke before each unit below: kg/m/s."""
    above, below = (_SETTING.sub(" ", part).split() for part in match.groups())
    if any(part[:1].isdecimal() for part in (*above, *below)):
        return match[0]  # a fraction of numbers
    return f" {' '.join(above)}" + "".join(f"/{part}" for part in below)


RADIANS = "rad/s"
_CYCLES = frozenset({"Hz", "kHz", "rpm", "rev/s", "rev/min", "U/min", "r/min", "1/min", "min^-1"})
"""Units in which turns are counted, and not radians."""
_PLAIN_PARTS = (Name, Number, formula.Product, formula.Quotient)


class _MismatchError(Exception):
    def __init__(self, mismatch: Mismatch) -> None:
        super().__init__(mismatch)  # all that a copy is made of
        self.mismatch = mismatch


@dataclass(frozen=True)
class Dimensions:
    """The dimensions of a document's letters at a line; `values` are those defined on the way."""

    symbols: Mapping[str, str]
    values: Mapping[str, Formula]
    text: str = ""
    """The page, in which units stand at the places of their numbers."""
    rounded: Mapping[str, Formula] = field(default_factory=dict)
    """The results that the page prints for letters: 314.2 rad/s for 2π·3000/60."""
    plain: frozenset[str] = frozenset()
    """The letters that are numbers without a unit by the page's sums: f by 1 - f."""

    def mismatch(self, left: Formula, right: Formula, sources: tuple[str, str]) -> Mismatch | None:
        """Return in which dimensions two sides differ, or a sum's terms; `sources` are their texts.

        A side of numbers alone is compared with nothing: its unit may go without saying.
        """
        try:
            first, second = (
                None if is_open(node, source) and not self.is_of_units(node) else self.of(node)
                for node, source in zip((left, right), sources, strict=True)
            )
        except _MismatchError as problem:
            return problem.mismatch
        if first is None and second is not None:
            return self._beside_bare_number(left, right, second)
        if first is None or second is None:
            return None
        if first == second:
            return self._turns(left, right)
        return Mismatch("the left side is in", first, second)

    def _beside_bare_number(self, left: Formula, right: Formula, result: Dimension) -> Mismatch | None:
        """Return that a bare number times a quantity is in a unit that no second quantity makes of it.

        0.25·5862 N may be an energy, where the 0.25 is in metres and says so nowhere, but no time.
        """
        if not isinstance(left, formula.Product) or not self.is_of_units(right):
            return None
        bare = [part for part in left.factors if isinstance(part, Number) and self.of(part) is None]
        others = tuple(part for part in left.factors if part not in bare)
        rest = self.of(formula.Product(others, span=left.span)) if len(bare) == 1 and others else None
        if rest is None or rest == NONE:
            return None
        silent = tuple(a - b for a, b in zip(result, rest, strict=True))
        return None if silent in _QUANTITIES else Mismatch("the left side is in", rest, result)

    def side(self, node: Formula, source: str) -> Dimension | None:
        """Return the dimension of a side by its letters; None where it is open, or its terms differ."""
        try:
            return None if is_open(node, source) else self.of(node)
        except _MismatchError:
            return None

    def of_numbers(self, node: Formula) -> Dimension | None:
        """Return the dimension of a side of numbers with units at them, None for any other."""
        try:
            return self.of(node) if self.is_of_units(node) else None
        except _MismatchError:
            return None

    def _turns(self, left: Formula, right: Formula) -> Mismatch | None:
        """Return that turns are set equal to radians: 50 Hz are no 50 rad/s.

        Nor is a letter of 632 rad/s above 632 Hz, or 60 times it in turns a minute: a 2π is missing.
        """
        units = [self.unit_at(left), self.unit_at(right)]
        if names(left) or names(right):  # numbers in two units are compared by what these are worth
            units = [self._turning_unit(left), self._turning_unit(right)]
        elif sorted(units) != ["Hz", RADIANS]:
            return None
        if RADIANS not in units or not _CYCLES & {*units}:
            return None
        what = "1 Hz is 2π rad/s" if "Hz" in units else "a turn is 2π radians"
        return Mismatch(f"{what}: the left side is in", self.of(left) or NONE, NONE)

    def _turning_unit(self, node: Formula) -> str:
        """Return the unit of turning in which a number, or a letter's, is typed; "" for none.

        A multiple of a letter is in its unit, unless a π in it converts.
        """
        parts = [part for part in walk(node) if isinstance(part, Name)]
        is_plain = all(isinstance(part, _PLAIN_PARTS) for part in walk(node))
        if not parts:
            return self._typed_turning(node)
        value = self.values.get(parts[0].name) if is_plain and len(parts) == 1 else None
        is_above = isinstance(node, formula.Quotient) and names(node.denominator)
        if value is None or names(value) or is_above:
            return ""
        return self._typed_turning(value)

    def _typed_turning(self, node: Formula) -> str:
        if not all(isinstance(part, _PLAIN_PARTS) for part in walk(node)):
            return ""
        typed = (self.unit_at(part) for part in walk(node))
        signs = {sign_of_unit(unit) or unit for unit in typed if unit}
        return signs.pop() if len(signs) == 1 else ""

    def of(self, node: Formula, depth: int = 0) -> Dimension | None:
        """Return a formula's dimension, None where it is open; a sum of unlike terms is refused."""
        if depth > 60:
            return None
        if isinstance(node, formula.Quotient) and (unit := self._unit_behind(node.denominator)):
            return None if names(node) else unit_of(unit)
        unit = self.unit_at(node)
        if unit:
            return unit_of(unit) or unit_of(sign_of_unit(unit) or unit)
        rule = _RULES.get(type(node))
        return None if rule is None else rule(self, node, depth + 1)

    def _unit_behind(self, denominator: Formula) -> str:
        r"""Return the unit behind a fraction, which is read with the number below: \frac{a}{50}\,kg."""
        source = self.text[denominator.span[0] : denominator.span[1]] if self.text else ""
        match = _IN_BRACES.match(source) if isinstance(denominator, Number) else None
        return written_unit(f"0 {source[match.end() :]}")[1] if match else ""

    def behind_bracket(self, node: Formula) -> Dimension | None:
        r"""Return the dimension of a sum of numbers by the unit behind its bracket: (0.9 + 0.3)\,kg."""
        source = self.text[node.span[0] : node.span[1]]
        match = _BRACKET_BEHIND.search(source)
        if match is None:
            return NONE if re.search("[-+−]", source) else None  # 3½ in: its unit is not the sum's
        _, unit = written_unit(f"0 {match['unit']}")
        return unit_of(unit) if unit else NONE

    def unit_at(self, node: Formula, *, alone: bool = False) -> str:
        """Return the unit that stands at a number, or is what a factor was read from; "" for none."""
        is_number = isinstance(node, Number) or _is_scientific(node)
        is_factor = is_number or isinstance(node, formula.Quotient | formula.Product)
        if not self.text or not is_factor or names(node):
            return ""
        has_number, unit = written_unit(self.text[node.span[0] : node.span[1]])
        if unit in ("g", "G") and isinstance(node, Number) and node.value == GRAVITY:
            unit = "gn"
        if has_number and (alone or not is_number):
            return ""
        if _is_scientific(node):
            return unit if unit[:1].isalpha() else ""
        is_unit = unit[:1].isalpha() if is_number else unit_of(unit) is not None
        return unit if is_unit or (has_number and unit) else ""

    def is_of_units(self, node: Formula) -> bool:
        """Tell whether a side is of numbers with units written at them, and nothing else.

        The degrees of a sine or cosine are no unit of its side.
        """
        return bool(self.text) and not names(node) and any(map(self.unit_at, _outside_calls(node)))

    def letter(self, name: str, depth: int) -> Dimension | None:
        """Return a letter's dimension: declared, or that of its value, a number's by the unit at it."""
        bare = name.rstrip("'")
        meaning = self.symbols.get(name) or self.symbols.get(bare)
        declared = None if meaning is None else declared_dimension(meaning)
        value = self.values.get(name)
        of_sums = NONE if name in self.plain else None
        if declared is not None or value is None:
            return of_sums if declared is None else declared
        if is_per_minute_number(value, self.text):
            return _WHOLE_UNITS["rpm"]
        result = self.rounded.get(name)
        nodes = [node for node in (value, result) if node is not None and self.is_of_units(node)]
        if not nodes and not (meaning is None and names(value) and not _is_wave_of_amounts(value)):
            return of_sums
        try:
            return self.of(nodes[0] if nodes else value, depth)
        except _MismatchError:
            return None  # said where it is defined


def _is_wave_of_amounts(value: Formula) -> bool:
    """Tell whether a value is a wave with amounts before it, 220 + 180 sin 2θ: its unit may go unsaid."""
    outside = list(_outside_calls(value))
    has_amount = any(isinstance(p, Number) and abs(p.value) >= FEWEST_OF_AN_AMOUNT for p in outside)
    return has_amount and not any(isinstance(part, formula.Name) for part in outside)


def _outside_calls(node: Formula) -> Iterator[Formula]:
    yield node
    parts = () if isinstance(node, formula.Call) else formula.children(node)
    for part in parts:
        yield from _outside_calls(part)


def is_open(node: Formula, source: str) -> bool:
    """Tell whether a side is only numbers, or writes units itself, which reading has made factors.

    Numbers before sines are such, 180 sin 2θ - 60 cos 2θ.
    """
    has_no_unit = not names(node) or _is_wave_of_amounts(node)
    return has_no_unit or _WRITTEN_UNIT.search(source) is not None


def _is_scientific(node: Formula) -> bool:
    """Tell whether a formula is a whole number with a power of ten, 2 · 10⁻⁵, or that power alone."""
    if isinstance(node, formula.Product) and len(node.factors) == 2:
        return isinstance(node.factors[0], Number) and _is_scientific(node.factors[1])
    if not isinstance(node, formula.Power) or node.base != Number(Fraction(10)) or names(node):
        return False
    return node.base.span[1] - node.base.span[0] <= len("10")  # and no (10 m)²


def _number(dimensions: Dimensions, node: Number, depth: int) -> Dimension | None:
    parts = abs(node.value.numerator), node.value.denominator
    return NONE if node.last_place is None and all(map(_is_factor_of_formulas, parts)) else None


def _is_factor_of_formulas(number: int) -> bool:
    rest = number
    for prime in (2, 3):
        while rest and rest % prime == 0:
            rest //= prime
    return number <= LARGEST_COUNTED or number in _OF_MINUTES or (rest == 1 and number <= LARGEST_PLAIN)


def _sum(dimensions: Dimensions, node: formula.Sum, depth: int) -> Dimension | None:
    first: tuple[Formula, Dimension] | None = None
    for term in node.terms:
        own = dimensions.of(term, depth)
        if own is None or not (names(term) or dimensions.is_of_units(term)):
            continue
        if first is not None and own != first[1]:
            texts = [formula_text(part, plain=True) for part in (first[0], term)]
            what = f"{texts[1]} is added to {texts[0]}, which is in"
            raise _MismatchError(Mismatch(what, first[1], own))
        first = first or (term, own)
    if first is None:
        return None if any(names(term) for term in node.terms) else dimensions.behind_bracket(node)
    return first[1]


def _product(dimensions: Dimensions, node: formula.Product, depth: int) -> Dimension | None:
    factors = list(node.factors)
    parts: list[tuple[Formula, int]] = []
    for factor, after in zip(factors, [*factors[1:], None], strict=True):
        # the letters of one macro have one span too, and each its own dimension
        is_second = bool(parts) and bool(dimensions.text) and factor.span == parts[-1][0].span != (0, 0)
        is_second = is_second and not names(factor) and not names(parts[-1][0])
        is_counted = after is not None and bool(dimensions.unit_at(after, alone=True))
        if not (is_second or (is_counted and isinstance(factor, Number))):
            parts.append((factor, 1))  # of 40 and mm the unit alone has a dimension
    return _combine(dimensions, parts, depth)


def _quotient(dimensions: Dimensions, node: formula.Quotient, depth: int) -> Dimension | None:
    return _combine(dimensions, [(node.numerator, 1), (node.denominator, -1)], depth)


def _combine(dimensions: Dimensions, parts: list[tuple[Formula, int]], depth: int) -> Dimension | None:
    total: Dimension | None = NONE
    for part, sign in parts:
        own = dimensions.of(part, depth)
        if own is None or total is None:
            total = None
        else:
            total = tuple(a + sign * b for a, b in zip(total, own, strict=True))
    return total


def _power(dimensions: Dimensions, node: formula.Power, depth: int) -> Dimension | None:
    base = dimensions.of(node.base, depth)
    behind = [unit for part in formula.walk(node.exponent) if (unit := dimensions.unit_at(part))]
    if behind:  # 10^5 Pa, (2 + 3)^2 m²: the unit is read with the exponent
        is_of_numbers = not names(node.base) and not any(map(dimensions.unit_at, formula.walk(node.base)))
        return unit_of(behind[0]) if isinstance(node.base, Number) or is_of_numbers else None
    exponent = dimensions.of(node.exponent, depth)
    if exponent is not None and exponent != NONE:
        text = formula_text(node.exponent, plain=True)
        raise _MismatchError(Mismatch(f"the exponent {text} is in", exponent, NONE))
    if _is_scientific(node):
        return None  # it may convert a unit: 60 · 10⁵ of bar
    value = _rational(node.exponent)
    if base is None or base == NONE or value is None:
        return base if base == NONE else None
    return tuple(e * value for e in base)


def _rational(node: Formula) -> Fraction | None:
    if isinstance(node, Number):
        return node.value
    if isinstance(node, formula.Negative):
        inner = _rational(node.operand)
        return None if inner is None else -inner
    if isinstance(node, formula.Quotient):
        above, below = _rational(node.numerator), _rational(node.denominator)
        return above / below if above is not None and below else None
    return None


def _call(dimensions: Dimensions, node: formula.Call, depth: int) -> Dimension | None:
    inner = dimensions.of(node.argument, depth)
    if node.function in ("abs", "conj", "re", "im"):
        return inner
    if node.function == "arg":
        return NONE  # the direction of a force phasor is an angle
    if node.function == "sqrt":
        return None if inner is None else tuple(e / 2 for e in inner)
    if inner is not None and inner != NONE:
        text = formula_text(node.argument, plain=True)
        raise _MismatchError(Mismatch(f"{node.function} is taken of {text}, which is in", inner, NONE))
    return NONE


def _derivative(dimensions: Dimensions, node: formula.Derivative, depth: int) -> Dimension | None:
    above, below = dimensions.of(node.expression, depth), dimensions.of(node.variable, depth)
    if above is None or below is None:
        return None
    return tuple(a - node.order * b for a, b in zip(above, below, strict=True))


def _summation(dimensions: Dimensions, node: formula.Summation, depth: int) -> Dimension | None:
    return dimensions.of(node.body, depth)


def _integral(dimensions: Dimensions, node: formula.Integral, depth: int) -> Dimension | None:
    return _combine(dimensions, [(node.body, 1), (node.variable, 1)], depth)


_RULES: dict[type, Callable[[Dimensions, Any, int], Dimension | None]] = {
    formula.Number: _number,
    formula.Name: lambda dimensions, node, depth: dimensions.letter(node.name, depth),
    formula.Constant: lambda dimensions, node, depth: NONE,
    formula.Sum: _sum,
    formula.Product: _product,
    formula.Quotient: _quotient,
    formula.Negative: lambda dimensions, node, depth: dimensions.of(node.operand, depth),
    formula.Power: _power,
    formula.Call: _call,
    formula.Derivative: _derivative,
    formula.Summation: _summation,
    formula.Integral: _integral,
    formula.PlusMinus: lambda dimensions, node, depth: dimensions.of(node.operand, depth),
    formula.Evaluation: lambda dimensions, node, depth: dimensions.of(node.expression, depth),
    formula.Limit: lambda dimensions, node, depth: dimensions.of(node.body, depth),
    formula.Extremum: lambda dimensions, node, depth: dimensions.of(node.body, depth),
}
