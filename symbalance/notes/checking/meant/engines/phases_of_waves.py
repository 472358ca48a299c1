"""Whether the wave of an engine's force or couple has the phase of the cranks: √3 m r ω² a cos(θ + 30°).

Three cranks at 0°, 120° and 240° give a couple that runs 30° before or behind the first crank, by the
direction of turning; 60° is no phase of theirs, whichever crank θ is counted from. Where the page gives
the phases of the pistons themselves, θ, θ + 120° and θ + 240°, they leave one phase.
"""

from __future__ import annotations

from cmath import phase, rect
from fractions import Fraction
from math import isclose, pi

from symbalance.document.formula import Call, Sum, names
from symbalance.notes.checking.meant.letter_roles import sign_of
from symbalance.notes.checking.meant.products import NoProductError, product_of
from symbalance.notes.checking.words.engines_in_words import CrankStar
from symbalance.text import lazy_patterns as re

_NOTHING = 1e-9
_NEAR = 2e-3
"""How far a rounded phase, 0.52 for π/6, may be from that of the cranks, in half turns."""
_NUMBER = r"[0-9]+(?:\.[0-9]+)?"
_SHIFT = (
    r"(?P<sign{k}>[-+−–])\s*(?:"
    rf"(?P<degrees{{k}}>{_NUMBER})\s*(?:°|º|\^\s*\{{{{?\s*\\circ\s*\}}}}?|\\degree|\\,?\\mathrm\{{{{deg\}}}})"
    rf"|\\[dt]?frac\s*\{{{{\s*(?P<above{{k}}>[0-9]*)\s*(?:\\pi|π)\s*\}}}}\s*\{{{{\s*(?P<below{{k}}>[0-9]+)\s*\}}}}"
    rf"|(?P<times{{k}}>[0-9]*)\s*(?:\\pi|π)(?![A-Za-z])(?:\s*/\s*(?P<over{{k}}>[0-9]+))?"
    r")"
)
"""What an angle is shifted by: + 120°, - 2π/3."""
_BETWEEN = (
    r"(?:\s|[$,;、と+()]|\\[,;: ()]|\\?cos|\\(?:left|right|bigl|bigr)|および"
    r"|(?<![^\W\d_])(?:and|und|et|[ey]|bzw\.)(?![^\W\d_]))*"
)
"""What stands between the phases of a list, or between the cosines of a sum."""


def fits_the_cranks(
    star: CrankStar, wave: Call, order: int, *, is_couple: bool, text: str, letter: str
) -> bool:
    """Tell whether a wave has the phase of the cranks, of those that the text lists if it lists any.

    A wave without a phase of its own is left to other words where no list says the phases.
    """
    own = _phase_of(wave)
    listed = _listed(text, letter, len(star.degrees)) if letter else None
    if own is None or star.is_radial or star.banks:
        return not isinstance(wave.argument, Sum)
    if listed is not None and not star.signs:
        whole = star.whole(order, is_couple=is_couple, degrees=listed)
        return abs(whole) < _NOTHING or _same(own, phase(whole))
    if not isinstance(wave.argument, Sum):
        return True
    whole = star.whole(order, is_couple=is_couple)
    turned = (whole * rect(1, -order * pi * float(crank) / 180) for crank in star.degrees)
    return any(_same(own, way * phase(each)) for each in turned for way in (1, -1))


def _phase_of(wave: Call) -> float | None:
    """Return p where a wave is cos(nθ + p) or its negative; None where it is no such wave."""
    terms = wave.argument.terms if isinstance(wave.argument, Sum) else (wave.argument,)
    turning = [term for term in terms if names(term)]
    try:
        shift = sum(product_of(term).number for term in terms if not names(term))
        way = 1 if len(turning) == 1 and product_of(turning[0]).number > 0 else -1
    except NoProductError:
        return None
    if wave.function not in ("cos", "sin"):
        return None
    return way * (shift - (pi / 2 if wave.function == "sin" else 0.0))


def _same(one: float, other: float) -> bool:
    """Tell whether two phases are the same but for half turns."""
    turns = (one - other) / pi
    return isclose(turns, round(turns), abs_tol=_NEAR)


def _listed(text: str, letter: str, count: int) -> tuple[Fraction, ...] | None:
    """Return the phases that a text gives last for all pistons: θ, θ + 120° and θ + 240°.

    >>> [int(d) for d in _listed("the phases are θ, θ-120° and θ-240°", "theta", 3)]
    [0, -120, -240]
    """
    sign = r"(?:(?<![A-Za-z_])|(?=\\))" + r"\s*".join(sign_of(part) for part in letter.split())
    items = [rf"{sign}\s*(?:{_SHIFT.format(k=k)})?" for k in range(count)]
    lists = [*re.compile(_BETWEEN.join(items)).finditer(text)]
    if not lists:
        return None
    shifts = tuple(_degrees(lists[-1].groupdict(), k) for k in range(count))
    return shifts if len(set(shifts)) > 1 else None


def _degrees(groups: dict[str, str | None], k: int) -> Fraction:
    """Return by how many degrees one item of a list is shifted."""
    way = -1 if groups[f"sign{k}"] in ("-", "−", "–") else 1
    if groups[f"degrees{k}"]:
        return way * Fraction(groups[f"degrees{k}"] or 0)
    if groups[f"sign{k}"] is None:
        return Fraction(0)
    times = groups[f"above{k}"] or groups[f"times{k}"] or 1
    return way * Fraction(180 * int(times), int(groups[f"below{k}"] or groups[f"over{k}"] or 1))
