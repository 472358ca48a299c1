"""Units of rates by their letters: ω̇ is in 1/s² and φ̇ in 1/s, whatever a page says of ω and φ.

Nobody declares the dot above an angle, and ω̇_max = 11079/2527 = 4.38 rad/s is an angular speed where an
angular acceleration stands. An angular speed itself is in radians per second: ω = √(10000/4) is no
50 Hz.
"""

from __future__ import annotations

from math import pi

from symbalance.document.formula import Derivative, Formula, Name, Number, names
from symbalance.document.letters import TIME_DOTS
from symbalance.document.wordlists import word_set, words
from symbalance.notes.checking.units.dimensions import Dimension, unit_of, written_unit
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.notes.reading.formulas.result_units import value_of
from symbalance.notes.reading.spellings.numerals import sign_of_unit
from symbalance.text import lazy_patterns as re

_ANGLES = word_set("phi varphi theta vartheta psi")
_SPEEDS = word_set("omega Omega")
_PER_MINUTE = words("rpm min⁻¹ min^-1 min^{-1} 1/min U/min rev/min r/min")
_IN_RADIANS = {"Hz": 2 * pi, "rad/min": 1 / 60, **dict.fromkeys(_PER_MINUTE, pi / 30)}
_NUMBER = re.compile(r"[0-9]+(?:\.(?P<places>[0-9]+))?")
_RATES = ("1", "1/s", "1/s^2", "1/s^3", "1/s^4")


def rate_dimension(node: Formula) -> Dimension | None:
    """Return the dimension of the rate of an angle or of an angular speed, None for other formulas."""
    name, order = _base_and_order(node)
    times = order + 1 if name in _SPEEDS else order
    if not order or name not in _SPEEDS | _ANGLES or times >= len(_RATES):
        return None
    return unit_of(_RATES[times].replace("/", " / "))


def turns_for_radians(chain: Chain, k: int, document: ReadNotes) -> str:
    """Return what is wrong with ω = √(10000/4) = 50 Hz, where a number of radians is given in turns.

    It is "" for other relations, and where the arithmetic has the 2π that turns radians into turns.
    """
    head = chain.sides[0].node
    is_speed = isinstance(head, Name) and head.name.split("_")[0] in _SPEEDS
    left, source = chain.sides[k].node, document.source(chain.sides[k + 1].span)
    is_arithmetic = bool(k) and not names(left) and not isinstance(left, Number)
    value = value_of(left) if is_arithmetic else None
    number = _NUMBER.match(source.replace("{,}", ".").replace(",", "."))
    if not is_speed or value is None or number is None:
        return ""
    unit = sign_of_unit(written_unit(source)[1])
    radians = _IN_RADIANS.get(unit)
    half = 0.5 * 10.0 ** -len(number["places"] or "")
    if radians is None or abs(value - float(number[0])) > half:
        return ""
    in_radians = f"{float(number[0]) * radians:.4g}"
    return f"an angular speed is in rad/s, and {number[0]} {unit} is {in_radians} rad/s"


def _base_and_order(node: Formula) -> tuple[str, int]:
    """Return the letter below the dots, without its subscript, and how many dots there are."""
    if isinstance(node, Derivative) and isinstance(node.expression, Name) and node.variable.name == "t":
        return node.expression.name.split("_")[0], node.order
    if isinstance(node, Name):
        dots, _, rest = node.name.partition("_")
        return rest.split("_")[0], TIME_DOTS.get(dots, 0)
    return "", 0
