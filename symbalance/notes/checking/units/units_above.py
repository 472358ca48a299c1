"""Units of bare numbers by the lines above: 1.590 x 33 is no 52.5 kg m where 33 was 33 mm.

An arithmetic may leave its units out, and its result name one. Where numbers of it stand above with their
units, the result has to be in these: its number may be right and its unit a thousand times too large, or
its speed revolutions per minute where the unit needs radians per second.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import isclose, log10, pi
from typing import NamedTuple

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
)
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.units.conversions import Quantity, quantity_of, scale_of, sign_of_unit
from symbalance.notes.checking.units.dimensions import NONE, Dimension, unit_of, unit_text
from symbalance.notes.checking.units.printed_units import IN_THEIR_UNITS
from symbalance.notes.checking.units.units_of_arithmetic import (
    Unit,
    UnitReading,
    numbers_of,
    unit_readings,
)
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.notes.reading.formulas.result_units import value_of, without_unit_of_result
from symbalance.text import lazy_patterns as re

NEAR = 700
"""Characters above in which a number's unit is looked for."""
MOST_COUNTED = 20
"""A whole number up to this may count something or come from a formula."""
_OF_FORMULAS = {24, 32, 48, 64, 96, 192, 384}
"""Larger whole numbers that formulas have: F l³/48 E I, 32 M/π d³."""
_CONVERTERS = {Fraction(n) for n in (12, 30, 36, 60, 75, 3600)} | {Fraction(18, 5)}
"""Numbers of time, feet and horse-power: s n/30."""
_TURNS = (pi / 30, 30 / pi, pi / 180, 180 / pi)
"""Numbers that convert turns a minute or degrees, printed in digits: 0.10472, 9.55."""
MOST_FACTORS = 4
"""Factors of conversion of one arithmetic, each of which may count something instead."""
_UNITS = 3
"""Words that a unit has at most: kg m s⁻¹."""
_MARKUP = re.compile(r"\\(?:mathrm|text|textrm|mbox|,|;|:|!|quad|ensuremath)|[~${}]|</?[a-z]+>")
_EXPONENT = re.compile(r"\}?\$?\^\{?([-−]?[0-9])\}?\$?")
"""The exponent of a unit, which may stand between dollars of its own: s$^{-1}$."""
_NUMERAL = re.compile(r"(?<![\w.,^_])[0-9]+(?:[.,][0-9]+)?(?![0-9])")
_THOUSANDS = re.compile(r"(?<=[0-9])(?:[ ~\u00a0\u2009\u202f]|\\,)(?=[0-9]{3}(?![0-9]))")
_BARE = re.compile(
    r"(?:=|≈|\\approx)[\s$]*(?P<number>[0-9]+(?:[.,][0-9]+)?)(?=[\s$]*(?:[,.;:)]|and |und |$))"
)
"""The number of a letter that has no unit: λ = 0.28."""
_SIGNS = re.compile(
    r"\\(?:cdot|times|sqrt|[dt]?frac|left|right|quad|pi|circ|cos|sin|tan|ln|log|exp|arctan|arcsin|arccos"
    r"|degree)(?![a-z])|\\[,;:!]|(?<![A-Za-z])(?:x|sqrt|pi|cos|sin|tan|ln|exp)(?![A-Za-z])|[π°⁰¹²³⁴⁵⁶⁷⁸⁹½¼¾]"
)
_LETTER = re.compile(r"[^\W\d_]")
_CLOSE = 1e-9
_SAME = 1e-6
_THOUSAND = 3
_OF_RECIPROCAL = 2
"""Numbers that 1/0.7457 has."""
_AROUND_ONE = 100
"""A number from a hundredth to this is no conversion by a power of ten."""
_PER_SECOND = unit_of("1/s") or NONE
_FEWEST_TURNS = 21
"""A smaller number is as likely a count: 10 of 600 rpm."""
_WEIGHTS = re.compile(r"(?<![A-Za-z])(?:lbs?|lbf|kgf|kp|tf|oz|pounds?|ounces?)(?![A-Za-z])")
"""Units that are weights in one place and masses in another."""
_OF_LENGTHS = tuple(unit_of(unit) for unit in ("m^2", "m^3"))
_Above = dict[Fraction, set[tuple[Dimension, float]]]


def refuted_by_units_above(
    chain: Chain,
    k: int,
    document: ReadNotes,
    knowledge: Knowledge,
    wrong: Collection[int] = (),
    *,
    is_behind_wrong: bool = False,
) -> Decision | None:
    """Return that a result is in another unit than its numbers make; None where that is open.

    Numbers whose unit is refuted above, at the places `wrong`, say nothing of what goes on with them; nor
    does an arithmetic that is wrong itself (`is_behind_wrong`), if it was put into a formula.
    """
    # Numbers put into a formula of the same chain are judged by that, if its letters have values.
    formulas = (side.node for side in chain.sides[:k] if not isinstance(side.node, Name))
    valued = knowledge.definitions.keys()
    is_put_in = any(names(node) and (is_behind_wrong or names(node) <= valued) for node in formulas)
    known = None if is_put_in else _numbers_with_units(chain, k, document)
    if known is None or {number.value for number in known.numbers} & _values_at(document, wrong):
        return None
    arithmetic, numbers, above, result, unit, text = known
    readings = unit_readings(arithmetic, known.options())
    if readings is None:
        return None
    in_unit = [reading for reading in readings if reading.dimension == unit]
    if not in_unit:
        words = text + document.text[chain.start : chain.end]
        return _of_another_kind(readings, numbers, above, unit, words)
    if (size := _misconverted(known, in_unit)) is not None:
        return Decision(REFUTED, f"by the units above it is {size:.4g} {result.unit}")
    scale = _scale_of_arithmetic(arithmetic, result)
    if scale is None or not all(_is_wrong(reading, reading.scale / scale) for reading in in_unit):
        return None
    plain = [reading for reading in in_unit if not reading.is_shifted]
    return (
        None if not plain else Decision(REFUTED, _reason(plain[0], plain[0].scale / scale, result.unit))
    )


def proved_by_units_above(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the proof of a volume or an area by the lengths above: π/4·45²·39 = 62.0 cm³ of mm.

    Other units in silence, g for kg or turns a minute for radians, are the slips that are looked for.
    """
    known = _numbers_with_units(chain, k, document)
    known = known if known is not None and known.unit in _OF_LENGTHS else None
    value = None if known is None else value_of(known.arithmetic)
    readings = (
        None if known is None or value is None else unit_readings(known.arithmetic, known.options())
    )
    if known is None or value is None or readings is None:
        return None
    printed, half = (float(part * known.result.scale) for part in (known.result.value, known.result.half))
    sure = [
        reading
        for reading in readings
        if reading.dimension == known.unit
        and not reading.is_shifted
        and not reading.open_numbers
        and len({unit.scale for _, unit in reading.numbers if unit.dimension != NONE}) == 1
    ]
    is_so = any(abs(value * each.scale - printed) <= half * (1 + _SAME) for each in sure)
    return Decision(PROVED, assumptions=(IN_THEIR_UNITS,)) if is_so and printed else None


class _KnownNumbers(NamedTuple):
    """An arithmetic of bare numbers, some with units above, and the quantity that it comes to."""

    arithmetic: Formula
    numbers: list[Number]
    above: _Above
    result: Quantity
    unit: Dimension
    text: str

    def options(self) -> list[tuple[Unit, ...]]:
        """Return what each number may be."""
        bare = _bare_numbers(self.text)
        return [_options(number, self.numbers, self.above, bare) for number in self.numbers]


def _numbers_with_units(chain: Chain, k: int, document: ReadNotes) -> _KnownNumbers | None:
    """Return the numbers of an arithmetic before a result with the units that they have above."""
    left, right = chain.sides[k], chain.sides[k + 1]
    result = quantity_of(right, document)
    unit = None if result is None else unit_of(result.unit)
    is_arithmetic = result is not None and not names(left.node) and not isinstance(left.node, Number)
    arithmetic = left.node if result is None else without_unit_of_result(left)
    numbers = numbers_of(arithmetic) if is_arithmetic else None
    if not numbers or result is None or unit is None or unit == NONE:
        return None
    text = document.text[max(0, chain.start - NEAR) : chain.start]
    above = _numbers_above(text)
    above |= _lone_data_above(
        document, chain, [n.value for n in numbers if not _units_at(n.value, above)]
    )
    has_own = _LETTER.search(_SIGNS.sub(" ", document.source(left.span))) is not None
    if has_own or not any(_units_at(number.value, above) for number in numbers):
        return None
    return _KnownNumbers(arithmetic, numbers, above, result, unit, text)


def _misconverted(known: _KnownNumbers, readings: list[UnitReading]) -> float | None:
    """Return what an arithmetic with factors of conversion is in the unit of its result; None if right.

    60 · 10⁵ · 50 of bar and cm² is 30 kN: whatever converts what, it is no 300 MN. Each factor may
    convert or count; the result is wrong if none of these gives it and one misses it by a power of ten.
    """
    printed = float(known.result.value * known.result.scale)
    factors = {value for reading in readings for value in reading.open_numbers}
    if not printed or not factors or len(factors) > MOST_FACTORS or not all(map(_converts, factors)):
        return None
    off: float | None = None
    for converting in product((True, False), repeat=len(factors)):
        ones = {value for value, converts in zip(sorted(factors), converting, strict=True) if converts}
        value = value_of(_without(known.arithmetic, ones))
        for reading in readings if value is not None else ():
            exact = (value or 0.0) * reading.scale
            ratio = abs(exact / printed)
            power = round(log10(ratio)) if ratio else 0
            if not ratio or isclose(ratio, 1, rel_tol=0.02):
                return None
            if isclose(ratio, 10.0**power, rel_tol=0.01) and all(converting):
                off = exact / float(known.result.scale)
    return off


def _converts(value: Fraction) -> bool:
    """Tell whether a number is one that converts units: 10⁵, 60, 9550, 3.6."""
    if _is_power_of_ten(value):
        return True
    power = Fraction(10) ** round(log10(value))
    scaled = [value / power * Fraction(10) ** n for n in range(-1, 5)]
    return any(
        number in _CONVERTERS or any(isclose(number, turn, rel_tol=0.001) for turn in _TURNS)
        for number in scaled
    )


def _without(node: Formula, ones: Collection[Fraction]) -> Formula:
    """Return an arithmetic with 1 for some of its numbers."""
    with_ones: Formula = node
    match node:
        case Number(value=value):
            with_ones = Number(Fraction(1)) if value in ones else node
        case Negative(operand=operand):
            with_ones = replace(node, operand=_without(operand, ones))
        case Power(base=base):
            with_ones = replace(node, base=_without(base, ones))
        case Product(factors=parts):
            with_ones = replace(node, factors=tuple(_without(part, ones) for part in parts))
        case Quotient(numerator=above, denominator=below):
            with_ones = Quotient(_without(above, ones), _without(below, ones))
        case Sum(terms=parts):
            with_ones = replace(node, terms=tuple(_without(part, ones) for part in parts))
        case Call(argument=argument):
            with_ones = replace(node, argument=_without(argument, ones))
        case _:
            pass
    return with_ones


def _values_at(document: ReadNotes, places: Collection[int]) -> set[Fraction]:
    """Return the numbers that sides which begin at some places are, with their unit left out."""
    sides = [side for chain in document.chains for side in chain.sides[1:] if side.span[0] in places]
    quantities = [quantity for side in sides if (quantity := quantity_of(side, document)) is not None]
    return {quantity.value for quantity in quantities}


def _scale_of_arithmetic(node: Formula, result: Quantity) -> float | None:
    """Return what the result of an arithmetic is counted in: the unit printed, or metres and newtons."""
    total = value_of(node)
    for scale in (float(result.scale), 1.0) if total is not None else ():
        if isclose(total or 0.0, float(result.value * result.scale) / scale, rel_tol=0.01):
            return scale
    return None


def _is_wrong(reading: UnitReading, ratio: float) -> bool:
    """Tell whether an arithmetic is surely in another unit than its result, `ratio` times as large."""
    if isclose(ratio, 1, rel_tol=_SAME):
        return False
    powers = log10(ratio)
    is_prefix = abs(powers) >= 1 and abs(powers - round(powers)) < _CLOSE
    return all(is_prefix and _is_no_prefix(value) for value in reading.open_numbers)


def _is_no_prefix(value: Fraction) -> bool:
    """Tell whether a number is not what units a thousand times larger are converted by."""
    return not _is_power_of_ten(value) and Fraction(1, _AROUND_ONE) < value < _AROUND_ONE


def _reason(reading: UnitReading, ratio: float, unit: str) -> str:
    speeds = [value for value, unit_there in reading.numbers if _is_per_minute(unit_there)]
    powers = log10(ratio)
    if speeds:
        return f"{speeds[0]} is the speed per minute by the units above, and nothing converts it"
    if abs(powers - round(powers)) < _CLOSE:
        return f"the numbers' units above make it {_times(ratio)} than {unit}"
    return f"the numbers' units above make it {ratio:.4g} times as large as {unit}"


def _is_per_minute(unit: Unit) -> bool:
    return unit.dimension == _PER_SECOND and any(
        isclose(unit.scale, scale, rel_tol=_SAME) for scale in (1 / 60, pi / 30)
    )


def _options(
    number: Number, numbers: list[Number], above: _Above, bare: frozenset[Fraction]
) -> tuple[Unit, ...]:
    """Return what a number may be: a quantity as above, one that formulas have, or something open."""
    value = number.value
    units = {Unit(*unit) for unit in above.get(value, ())}
    if not units and (turning := _turning(number, above)):
        return turning
    if not _is_power_of_ten(value) or value == 1:
        units |= set(_shifted(value, above))
    elif not units or [n.value for n in numbers].count(value) > 1:
        units.add(Unit(is_open=True))
    if value in bare or (_is_of_formulas(value) and not _is_power_of_ten(value)) or value == 1:
        units.add(Unit())
    if value in _CONVERTERS or any(isclose(value, turn, rel_tol=0.003) for turn in _TURNS) or not units:
        units.add(Unit(is_open=True))
    return tuple(sorted(units, key=repr))


def _turning(number: Number, above: _Above) -> tuple[Unit, ...]:
    """Return the unit of radians or turns a second: of 314 where 3000 rpm stands above."""
    half = (number.last_place or Fraction(1)) / 2
    speeds = [v for v, rows in above.items() if any(_is_per_minute(Unit(*row)) for row in rows)]
    rates = [float(v) * factor for v in speeds for factor in (pi / 30, 1 / 60)]
    is_rate = number.value >= _FEWEST_TURNS and any(abs(r - float(number.value)) <= half for r in rates)
    return (Unit(_PER_SECOND),) if is_rate else ()


def _is_of_formulas(value: Fraction) -> bool:
    """Tell whether a number is one that formulas have: a count, a half, a quarter, 48."""
    return value in _OF_FORMULAS or (value <= MOST_COUNTED and value.denominator in (1, 2, 4))


def _shifted(value: Fraction, above: _Above) -> list[Unit]:
    """Return the units of a number with its decimal point elsewhere: 0.04 where 40 mm stands above.

    Who converts means metres and kilograms, also where the unit above is a slip: 35.3 cm, then 0.0353.
    """
    units = []
    for known, rows in above.items():
        ratio = value / known
        if ratio == 1 or ratio <= 0 or not _is_power_of_ten(ratio):
            continue
        is_kilo = abs(round(log10(ratio))) == _THOUSAND
        if is_kilo or len(str(value.numerator * value.denominator).strip("0")) > 1:
            units += [Unit(size, scale / float(ratio), is_shifted=not is_kilo) for size, scale in rows]
            units += [Unit(size, is_shifted=True) for size, _ in rows]
    return units


def _units_at(value: Fraction, above: _Above) -> bool:
    return bool(above.get(value)) or any(not unit.is_shifted for unit in _shifted(value, above))


def _lone_data_above(document: ReadNotes, chain: Chain, values: list[Fraction]) -> _Above:
    """Return numbers with the units that they have anywhere above, where no letter has them without.

    The spacing 35.0 mm of a table of data is 0.035 in an arithmetic pages below; where λ = 0.035 stands
    somewhere it may be that.
    """
    values = [value for value in values if value.denominator > 1]
    bare = _bare_numbers(document.text) if values else frozenset()
    alone = [value for value in values if value not in bare]
    far = _numbers_above(document.text[: chain.start]) if alone else {}
    return {
        known: rows
        for known, rows in far.items()
        if any(_is_power_of_ten(value / known) for value in alone)
    }


def _of_another_kind(
    readings: list[UnitReading],
    numbers: list[Number],
    above: _Above,
    unit: Dimension,
    words: str,
) -> Decision | None:
    """Return that N times m is no N; None where a number's unit is not sure.

    All of them have to have their units above; the 4 of 4 m r² ω² is in no metres.
    """
    values = [number.value for number in numbers]
    turning = {number.value for number in numbers if _turning(number, above)}
    others = [value for value in values if value not in turning]
    is_sure = all(value == 1 or _units_at(value, above) for value in others)
    is_sure = is_sure and not any(_is_power_of_ten(value) and value != 1 for value in others)
    of_units = [r for r in readings if not r.is_shifted and not r.open_numbers and r.dimension != NONE]
    if not is_sure or not of_units or _WEIGHTS.search(words) is not None:
        return None
    most = max(of_units, key=lambda reading: sum(u.dimension != NONE for _, u in reading.numbers))
    inverse = tuple(-power for power in unit)
    if most.dimension == inverse and len(values) == _OF_RECIPROCAL and 1 in values:
        return None  # behind 1 hp = 745.7 W the other way round: 1 kW is 1/0.7457 = 1.34 hp
    witness = {"left": unit_text(most.dimension), "right": unit_text(unit)}
    return Decision(REFUTED, "the numbers' units above make another unit", witness=witness)


def _times(ratio: float) -> str:
    words = {3: "a thousand times", 6: "a million times"}
    power = round(abs(log10(ratio)))
    return f"{words.get(power, f'{10**power} times')} {'larger' if ratio > 1 else 'smaller'}"


def _is_power_of_ten(value: Fraction) -> bool:
    if value <= 0:
        return False
    powers = log10(value)
    return value != 1 and isclose(powers, round(powers), abs_tol=_CLOSE)


def _plain(text: str) -> str:
    return _THOUSANDS.sub("", text.replace("{,}", "."))


@lru_cache(maxsize=4)
def _bare_numbers(text: str) -> frozenset[Fraction]:
    """Return the numbers that letters have without a unit: λ = 0.28."""
    return frozenset(
        Fraction(match["number"].replace(",", ".")) for match in _BARE.finditer(_plain(text))
    )


def _numbers_above(text: str) -> _Above:
    """Return the numbers of a text with the units behind them."""
    text = _plain(text)
    units_of: _Above = {}
    for match in _NUMERAL.finditer(text):
        value = Fraction(match[0].replace(",", "."))
        units = _units_behind(text[match.end() : match.end() + 40])
        if not units or not value:
            continue
        units_of.setdefault(value, set()).update(units)
        whole, comma, rest = match[0].partition(",")
        if comma and len(rest) == _THOUSAND:  # 12,500 mm may be either
            units_of.setdefault(Fraction(whole + rest), set()).update(units)
    return units_of


def _units_behind(text: str) -> list[tuple[Dimension, float]]:
    """Return the dimension and the scale of the longest unit that a text begins with.

    Revolutions per minute are a rate and an angular speed.
    """
    text = _EXPONENT.sub(r"^\1", text.split("\n\n", maxsplit=1)[0])
    words = _MARKUP.sub(" ", text).split()
    for count in range(min(_UNITS, len(words)), 0, -1):
        source = " ".join(words[:count]).rstrip(".,;:)")
        is_unit = source[:1].isalpha() or source.startswith("1/")
        dimension = unit_of(source) or unit_of(sign_of_unit(source) or source) if is_unit else None
        scale = scale_of(sign_of_unit(source)) if dimension not in (None, NONE) else None
        if dimension is None or scale is None:
            continue
        size = float(scale[0])
        return [(dimension, size / 2), (dimension, size * pi)] if scale[1] else [(dimension, size)]
    return []
