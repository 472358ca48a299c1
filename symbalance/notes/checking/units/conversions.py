"""Quantities in two units, 120 ft-lb = 163 N·m: the second number is the first, converted and rounded.

A weight in lb or tons is a mass or a force, whichever the other unit is, alone and in ft.-lb. Where the
first quantity is a datum, s = 3.5 in = 89.8 mm, the second has to agree with it to its own digits: 3.5 in
is no rounding of 89.8 mm.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, Power, Product
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.units.dimensions import Dimension, unit_of, written_unit
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.signs import VULGAR
from symbalance.notes.reading.spellings.numerals import sign_of_unit
from symbalance.notes.reading.units import GRAVITY, scale_of
from symbalance.text import lazy_patterns as re

POUND, POUND_FORCE = Fraction(45359237, 10**8), Fraction(44482216152605, 10**13)
FEWEST_WHOLE = 10
"""A whole number of two digits before a power of ten is rounded to its last one."""
FEWEST_DIGITS = 2
"""That a whole number shows at least which a quantity is converted to: 8000 lb = 36 kN."""
ROUGHLY = Fraction(1, 50)
"""What a whole number of one digit may be off by, 1 in for 25 mm."""
FEWEST_SHOWN = 20
"""Halves of its last place that a number behind = has at least, two digits: 32 kN for 31 955 N."""
LARGEST_EXPONENT = 30
"""Of a power of ten in a typed number."""
SLACK = Fraction(3, 1000)
"""What a datum and its conversion may differ by: by a factor of three digits, 0.454 or 1.36."""
_SPACED = re.compile(r"(?<=[0-9])(?:[ ~\u00a0\u2009\u202f]|\\,)(?=[0-9]{3}(?![0-9]))")
ABOUT_GRAVITY = Fraction(4, 10**4)
"""What 9.81 and 9.80665 differ by."""
_OF_WEIGHT = {"kp", "kgf", "gn", "kgf/cm²", "kgf/cm^2", "kp/cm²", "kgf·m", "kgf m", "kp m", "kpm"}
_WEIGHT = re.compile(r"(?<![A-Za-z/])(?:lbs?|lbf|ton|oz)(?![A-Za-z^²³⁻])")
TONS = (2240 * POUND, 2000 * POUND, Fraction(1000))
"""What a ton is, in kg: the long, the short and the metric one. A conversion says which."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number as typed, half a unit of its last place, and its unit with what that is worth."""

    value: Fraction
    half: Fraction
    unit: str
    scale: Fraction


def quantity_of(side: Side, document: ReadNotes) -> Quantity | None:
    """Return the number and unit that a side consists of, None for other sides."""
    has_number, words = written_unit(_SPACED.sub("", document.source(side.span)))
    sign = sign_of_unit(words) if has_number and words else ""
    if sign in ("g", "G") and isinstance(side.node, Product) and side.node.factors[-1] == Number(GRAVITY):
        sign = "gn"
    scale = scale_of(sign) if sign else None
    number = _lone(side.node)
    if scale is None or scale[1] or number is None:
        return None
    is_scaled = isinstance(side.node, Number | Negative)
    factor = scale[0] if is_scaled else Fraction(1)
    value = number.value / factor
    if number.last_place is not None:
        return Quantity(value, number.last_place / factor / 2, sign, scale[0])
    if value.denominator != 1:
        is_mixed = any(part in document.source(side.span) for part in VULGAR)
        return Quantity(value, Fraction(0), sign, scale[0]) if is_mixed else None
    digits = str(abs(value.numerator))
    zeros = min(len(digits) - len(digits.rstrip("0")), max(len(digits) - FEWEST_DIGITS, 0))
    half = Fraction(10**zeros, 2) if len(digits) >= FEWEST_DIGITS else ROUGHLY * abs(value)
    return Quantity(value, half, sign, scale[0])


def _lone(node: Formula) -> Number | None:
    """Return the number of a side that is nothing else but a number and its unit."""
    if isinstance(node, Negative):
        inner = _lone(node.operand)
        return None if inner is None else Number(-inner.value, inner.last_place)
    if isinstance(node, Product):
        number, *rest = node.factors
        tens = _power_of_ten(rest[0]) if rest else None
        if tens is not None and isinstance(number, Number):  # 2.979·10⁻³ is one number
            is_whole = number.last_place is None and tens < 1 and abs(number.value) >= FEWEST_WHOLE
            place = (
                tens if is_whole else number.last_place and number.last_place * tens
            )  # 43·10⁻² is 0.43
            number, rest = Number(number.value * tens, place), rest[1:]
        if not rest or (len(rest) == 1 and isinstance(rest[0], Number)):
            return number if isinstance(number, Number) else None
        return None
    return node if isinstance(node, Number) else None


def _power_of_ten(node: Formula) -> Fraction | None:
    """Return the value of a typed power of ten, 10⁻³, None for other formulas."""
    if not isinstance(node, Power) or node.base != Number(Fraction(10)):
        return None
    exponent = _lone(node.exponent)
    is_whole = exponent is not None and exponent.value.denominator == 1
    is_printable = is_whole and exponent is not None and abs(exponent.value) <= LARGEST_EXPONENT
    return Fraction(10) ** int(exponent.value) if is_printable and exponent else None


def decide_conversion(chain: Chain, k: int, document: ReadNotes) -> Decision | None:
    """Return the decision on a quantity that is written in another unit; None for other relations.

    Of units that differ by a power of ten the second number is the first one with fewer digits, or
    nothing is said: 0.65 kg may be 654 g.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    first, second = quantity_of(left, document), quantity_of(right, document)
    if chain.relations[k].sign in "=≈" and _is_same_turning(left, right, document):
        return Decision(PROVED, order="the digits printed")
    if chain.relations[k].sign not in "=≈" or not (first and second and first.value and second.value):
        return None
    decisions = [_decide(chain, k, *pair) for pair in _in_every_reading(first, second)]
    proved = (d for d in decisions if d is not None and d.is_proved)
    return next(proved, None if None in decisions or not decisions else decisions[0])


_TYPED_NUMBER = re.compile(r"[\s$(]*(?P<digits>[0-9]+(?:\.[0-9]+)?)(?![0-9.,]*[0-9])")


def _is_same_turning(left: Side, right: Side, document: ReadNotes) -> bool:
    """Tell whether a speed in turns is written in another unit: 1500 rpm = 25 rev/s = 157 rad/s.

    5.84 Hz = 350 rpm counts cycles; 5.84 Hz = 36.7 rad/s leaves out a 2π, or means ω: it is not for here.
    """
    speeds = [_turning_speed(side, document) for side in (left, right)]
    first, second = speeds
    if first is None or second is None or first[2] == "rad/s" or {first[2], second[2]} == {"Hz", "rad/s"}:
        return False
    exact, shown, half = first[0], second[0], second[1]
    return abs(exact - shown) <= half * (1 + 1e-9) and half < abs(shown) / FEWEST_DIGITS


def _turning_speed(side: Side, document: ReadNotes) -> tuple[float, float, str] | None:
    """Return a typed speed in rad/s with half a unit of its last digit, and its unit."""
    source = document.source(side.span)
    number, (has_number, words) = _TYPED_NUMBER.match(_SPACED.sub("", source)), written_unit(source)
    sign = sign_of_unit(words) if has_number and words else ""
    scale = scale_of(sign) if sign else None
    is_turning = scale is not None and (scale[1] or sign in ("rad/s", "Hz")) and sign != "deg"
    if number is None or scale is None or not is_turning:
        return None
    size = float(scale[0]) * (math.pi if scale[1] else math.tau if sign == "Hz" else 1)
    decimals = len(number["digits"].partition(".")[2])
    return float(number["digits"]) * size, 0.5 * 10.0**-decimals * size, sign


def _in_every_reading(first: Quantity, second: Quantity) -> list[tuple[Quantity, Quantity]]:
    """Return two quantities as each two of a kind that they may be: a weight is a mass or a force."""
    return [
        (one, other)
        for kind, one in _readings(first)
        for other_kind, other in _readings(second)
        if kind == other_kind
    ]


def _readings(quantity: Quantity) -> list[tuple[Dimension, Quantity]]:
    """Return what a quantity may be: 5 tons are one of three masses, or the weight of one of them.

    What is lbf alone is a force; the reader has turned lb.-in. into lbf·inch.
    """
    unit = quantity.unit
    weight = _WEIGHT.search(unit)
    if weight is None:
        dimension = unit_of(unit)
        return [] if dimension is None else [(dimension, quantity)]
    sizes = TONS if weight[0] == "ton" else (POUND / 16,) if weight[0] == "oz" else (POUND,)
    readings: list[tuple[Dimension, Quantity]] = []
    for sign, by_weight in (("kg", Fraction(1)), ("N", POUND_FORCE / POUND)):
        metric = unit[: weight.start()] + sign + unit[weight.end() :]
        dimension, scale = unit_of(metric), scale_of(metric)
        if dimension is not None and scale is not None:
            scaled = (replace(quantity, scale=scale[0] * size * by_weight) for size in sizes)
            readings += [(dimension, each) for each in scaled]
    return readings[len(sizes) :] if unit == "lbf" else readings


def _decide(chain: Chain, k: int, first: Quantity, second: Quantity) -> Decision | None:
    """Return the decision on a quantity in two units of known size."""
    if first.unit == second.unit:
        return None
    ratio = first.scale / second.scale
    exact = first.value * ratio
    by_weight = ABOUT_GRAVITY * abs(exact) if {first.unit, second.unit} & _OF_WEIGHT else Fraction(0)
    off = max(abs(exact - second.value) - by_weight, Fraction(0))
    is_datum = k == 0 or (k == 1 and isinstance(chain.sides[0].node, Name))
    # what is computed goes on with digits that are not shown
    spread = Fraction(0) if is_datum or is_power_of_ten(ratio) else first.half * ratio
    if off <= (second.half + spread) * (1 + Fraction(1, 10**9)):
        is_short = is_power_of_ten(ratio) and abs(second.value) < FEWEST_SHOWN * second.half
        is_short = is_short and chain.relations[k].sign == "="
        return None if is_short else Decision(PROVED, order="the digits printed")
    is_wrong = off > max(2 * second.half, SLACK * abs(exact)) + spread
    if is_power_of_ten(ratio) or not is_wrong:
        return None
    reason = f"{float(first.value):g} {first.unit} is {float(exact):.6g} {second.unit}"
    return Decision(
        REFUTED, reason, witness={"left": f"{float(exact):.6g}", "right": f"{float(second.value):g}"}
    )


def is_power_of_ten(ratio: Fraction) -> bool:
    """Tell whether units differ by their prefixes only."""
    power = round(math.log10(float(ratio)))
    return ratio == Fraction(10) ** power
