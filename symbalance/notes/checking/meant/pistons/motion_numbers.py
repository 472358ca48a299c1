"""Numbers of a slider-crank's motions by the sizes that the page names: 60 mm, 240 mm and 1500 rpm.

A first number for a letter is its definition. Where words name the motion, and the page has one crank
radius or stroke, one rod, one speed, it can be computed:

    the number agrees to its digits         holds, by the sizes of the page
    it is off by a usual factor or term     refuted: half the stroke, turns a minute, λ/2 for λ
    anything else                           None: it may be of another engine

Nothing is said where a page has two values of a size.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import cos, isclose, isfinite, pi, radians, sin

from symbalance.document.formula import Call, Formula, Name, names, walk
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.meant.catalogue.kinematics import (
    ACCELERATION,
    BOTTOM,
    MOTIONS,
    PATH,
    ROD_ANGLE,
    SPEED,
    TOP,
    TURNED,
)
from symbalance.notes.checking.meant.engine_speeds import speeds_of
from symbalance.notes.checking.meant.formula_slips import value_at
from symbalance.notes.checking.meant.pistons.motion_slips import SAME
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_NUMBER = r"(?P<number>[0-9]+(?:[.,][0-9]+)?(?:\s?/\s?[0-9]+)?)"
_TO_NUMBER = (
    r"(?:\s|\$|\\[,;]|,|:|=|\(|\bof\b|\bis\b|\bvon\b|\bist\b|\blength\b|\bradius\b|\bthrow\b"
    r"|\b[a-zA-Z]\b)*"
)
_UNIT = r"(?:\s|\\[,;~]|~|\\,|\\(?:text|mathrm)\{\s*)*(?P<unit>mm|cm|m|in)\b(?!\s*/)"
_SCALES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254}
_LENGTHS: Mapping[str, re.Pattern[str]] = {
    "r": re.compile(
        r"(?:crank(?:[- ](?:radius|throw|length))?|half[- ]stroke|\bthrow|kurbelradius|クランク半径"
        rf"|rayon de manivelle){_TO_NUMBER}{_NUMBER}{_UNIT}",
        re.IGNORECASE,
    ),
    "s": re.compile(
        rf"(?:(?<!half )(?<!half-)\bstroke|\bhub|kolbenhub|行程|ストローク|\bcourse"
        rf"|carrera){_TO_NUMBER}{_NUMBER}{_UNIT}",
        re.IGNORECASE,
    ),
    "l": re.compile(
        r"(?:\b(?:connecting[- ])?rod(?:[- ]length)?|pleuel(?:stange|länge|stangenlänge)?|schubstange"
        rf"|連接棒(?:の長さ|長さ?)?|コンロッド(?:の長さ|長さ?)?|\bbielle|\bbiela){_TO_NUMBER}{_NUMBER}{_UNIT}",
        re.IGNORECASE,
    ),
}
_RATIO = re.compile(
    r"(?:ratio|verhältnis|連桿比|rod to crank|crank to rod)\s*(?:of|is|=|von|ist|は|\$|\\lambda|λ|:|,"
    r"|\s)*"
    rf"{_NUMBER}(?!\s*[:.]?\s*\d)",
    re.IGNORECASE,
)
_MEAN_SPEED = re.compile(
    r"mean (?:piston )?speed(?: of the piston)?\s*(?:of|is|=|,|\$|[a-z]_?m?|\s)*"
    rf"{_NUMBER}\s*m\s?/\s?s(?!\^?\{{?[²2])",
    re.IGNORECASE,
)
_LETTERS = {"r": "r", "R": "r", "l": "l", "L": "l", "S": "s", "lambda": "ratio"}
_IS_MEAN = re.compile(
    r"(?:mean|average) (?:piston )?(?:speed|velocity)|on average|mittlere (?:kolben)?geschwindigkeit"
    r"|平均ピストン速度|vitesse moyenne|velocidad media",
    re.IGNORECASE,
)
_IS_TURNING = re.compile(
    r"angular (?:speed|velocity)|winkelgeschwindigkeit|(?<!コンロッドの)角速度", re.IGNORECASE
)
_IS_PIN = re.compile(
    r"crank-?\s?pin\s+(?:speed|velocity)|(?:speed|velocity) of the crank-?\s?pin", re.IGNORECASE
)
_IS_RATE = re.compile(
    r"(?:permitted|allowed|allowable|highest|maximum|required|engine|rotational) speed|drehzahl|回転数"
    r"|revolutions per minute",
    re.IGNORECASE,
)
_ANGLE = re.compile(r"(?<![\d.])(?P<angle>[1-9][0-9]{0,2})\s?(?:°|\^?\{?\\circ|deg|度)")
CLOSE, FAR = 1e-3, 2e-2
_FACTORS = (2, 1 / 2, 4, 1 / 4, pi, 1 / pi, 2 * pi, 1 / (2 * pi), pi / 2, 2 / pi, 60, 1 / 60, 30, 1 / 30)
"""By which a number is off where a stroke, a turn or a minute is forgotten."""


@dataclass(frozen=True, slots=True)
class Expected:
    """The values that a named quantity may have, what it is, and wrong ones that are slips of it."""

    what: str
    values: tuple[float, ...]
    slips: tuple[float, ...] = ()
    factors: tuple[float, ...] = _FACTORS


@dataclass
class MotionNumbers:
    """The sizes that one page names, and the numbers that follow from them."""

    document: ReadNotes

    @cached_property
    def sizes(self) -> dict[str, float]:
        """Return the sizes of which the page has one value: r, lam (r/l), w in rad/s, mean."""
        known: dict[str, set[float]] = {"r": set(), "l": set(), "s": set(), "ratio": set(), "mean": set()}
        text = glossary_of(self.document.text).english(self.document.text)
        for role, pattern in _LENGTHS.items():
            known[role] |= {_number(m["number"]) * _SCALES[m["unit"]] for m in pattern.finditer(text)}
        known["ratio"] |= {_number(m["number"]) for m in _RATIO.finditer(text)}
        known["mean"] |= {_number(m["number"]) for m in _MEAN_SPEED.finditer(text)}
        for chain in self.document.chains:
            head = chain.sides[0].node
            role = _LETTERS.get(head.name.partition("_")[0]) if isinstance(head, Name) else None
            values = [value_at(side.node, {}) for side in chain.sides[1:] if not names(side.node)]
            if role and values and isfinite(values[-1]):
                known[role].add(values[-1])
        known["r"] |= {s / 2 for s in known["s"]}
        known["ratio"] = {1 / n if n > 1 else n for n in known["ratio"] if n}
        sizes = {
            role: values.pop() for role, each in known.items() if len(values := _distinct(each)) == 1
        }
        if {"r", "l"} <= {*sizes} and "ratio" not in sizes and not known["ratio"]:
            sizes["ratio"] = sizes["r"] / sizes["l"]
        speeds = speeds_of(text)
        if len(speeds) == 1:
            sizes["w"] = pi * next(iter(speeds)) / 30
        return sizes

    def judge(
        self, chain: Chain, words: str, kind: str, places: tuple[str, ...], name: str
    ) -> Decision | None:
        """Return the decision on a first number by the sizes of the page; None where they give none."""
        claim = chain.sides[1].node
        value = value_at(claim, {})
        if names(claim) or not isfinite(value) or not value:
            return None
        for expected in self._expected(f"{words} {_degrees(claim)}", kind, places, name):
            decision = _compared(value, claim, chain, expected)
            if decision is not None:
                return decision
        return None

    def _expected(self, words: str, kind: str, places: tuple[str, ...], name: str) -> Iterator[Expected]:
        sizes, stem = self.sizes, name.partition("_")[0]
        w, r, lam = sizes.get("w"), sizes.get("r"), sizes.get("ratio")
        if _IS_MEAN.search(words):
            if w and r:
                yield Expected("the mean piston speed, two strokes a turn", (2 * r * w / pi,))
            return
        if _IS_PIN.search(words):
            if w and r:
                yield Expected("the speed of the crank pin, r ω", (r * w,))
            return
        if stem in ("omega", "Omega") and not kind:
            if w and "_" not in name:
                yield Expected(
                    "the angular speed, 2π times the turns",
                    (w,),
                    factors=(2, 1 / 2, 60, 1 / 60, pi, 1 / pi),
                )
            return
        if stem in ("n", "N") and _IS_RATE.search(words) and "mean" in sizes and r and not w:
            turns = sizes["mean"] / (4 * r)
            yield Expected(
                "the turns of the crank, a stroke twice a turn",
                (60 * turns, turns, 2 * pi * turns),
                factors=(2, 1 / 2, 4, 1 / 4),
            )
            return
        if not kind or not r or lam is None or not 0 < lam < 0.6:
            return
        yield from _of_motion(kind, places, words, r, lam, w)


def _of_motion(
    kind: str, places: tuple[str, ...], words: str, r: float, lam: float, w: float | None
) -> Iterator[Expected]:
    """Yield what a motion is at its places, or at the one angle that the words name."""
    angles = {int(match["angle"]) for match in _ANGLE.finditer(words)}
    spots: list[tuple[str, float]] = [(place, 0.0) for place in places if place]
    if kind in TURNED and len(angles) == 1 and (angle := angles.pop()) not in (90, 180, 360):
        spots = [("", radians(angle))]
    for place, angle in spots:
        motion = MOTIONS.get((kind, place))
        if motion is None or (w is None and kind not in (PATH, ROD_ANGLE)):
            continue
        point = {
            "r": Fraction(r), "lam": Fraction(lam), "w": Fraction(w or 1), "theta": Fraction(angle),
            "e": Fraction(0),
        }  # fmt: skip
        nodes = motion.exact[:1] if kind == PATH and not place else (*motion.exact, *motion.rough)
        values = [value_at(node, point) for node in nodes]
        values += _two_terms(kind, place, r, lam, w or 1, angle, 1.0)
        values = [each for each in values if isfinite(each) and each]
        factors = (-1.0, 0.0, 0.5, 2.0, 0.25) if not place or place in (TOP, BOTTOM) else ()
        slips = [each for f in factors for each in _two_terms(kind, place, r, lam, w or 1, angle, f)]
        if values:
            at = {TOP: "top dead centre", BOTTOM: "bottom dead centre", "right": "90°"}.get(place, place)
            where = f" at {at}" if at else f" at {round(angle * 180 / pi)}°"
            yield Expected(
                f"the {kind}{where}", tuple(values), tuple(slips), (2, 1 / 2, 4, 1 / 4, 60, 1 / 60)
            )


def _two_terms(
    kind: str, place: str, r: float, lam: float, w: float, angle: float, factor: float
) -> list[float]:
    """Return a motion by its first two harmonics, the second one multiplied."""
    angle = {TOP: 0.0, BOTTOM: pi, "right": pi / 2}.get(place, angle)
    second = factor * lam
    if kind == ACCELERATION:
        return [r * w**2 * (cos(angle) + second * cos(2 * angle))]
    if kind == SPEED:
        return [r * w * (sin(angle) + second / 2 * sin(2 * angle))]
    if kind == PATH and place not in (TOP, BOTTOM):
        return [r * (1 - cos(angle) + second / 4 * (1 - cos(2 * angle)))]
    return []


def _degrees(claim: Formula) -> str:
    """Return the least angle of which a formula of numbers has a wave: 30° of cos 30° + cos 60°/4."""
    waves = [p for p in walk(claim) if isinstance(p, Call) and p.function in ("sin", "cos")]
    angles = [value_at(wave.argument, {}) * 180 / pi for wave in waves]
    least = min(angles, default=0.0)
    return (
        f"{round(least)}°"
        if least > 0 and all(abs(a / least - round(a / least)) < SAME for a in angles)
        else ""
    )


def _number(text: str) -> float:
    above, _, below = text.replace(",", ".").partition("/")
    return float(above) / (float(below) if below else 1.0)


def _distinct(values: set[float]) -> list[float]:
    """Return values that differ by more than their rounding."""
    rest: list[float] = []
    for value in sorted(values):
        if not rest or not isclose(value, rest[-1], rel_tol=5e-3):
            rest.append(value)
    return rest


def _compared(value: float, claim: Formula, chain: Chain, expected: Expected) -> Decision | None:
    """Return whether a number is what it should be: to its digits, or off by a slip."""
    size = abs(value)
    printed = decimals(claim)
    scale = 10.0**-2 if not printed else 0.0
    for exact in expected.values:
        gap = abs(size / abs(exact) - 1)
        if gap < CLOSE or (gap < 5e-3 and size >= 1 and abs(size - abs(exact)) <= max(scale * 50, 0.6)):
            text = f"it is {expected.what}, by the sizes that the page names"
            return Decision(PROVED, order="the digits printed", assumptions=(text,))
    if any(abs(size / abs(exact) - 1) < FAR for exact in expected.values):
        return None
    is_slip = any(isclose(size, abs(slip), rel_tol=2 * CLOSE) for slip in expected.slips if slip)
    is_slip |= any(
        isclose(size, abs(exact) * factor, rel_tol=2 * CLOSE)
        for exact in expected.values
        for factor in expected.factors
    )
    if not is_slip:
        return None
    exact = expected.values[0]
    reason = f"it is not {expected.what}, by the sizes that the page names: {exact:.5g}"
    return Decision(REFUTED, reason, witness={"left": f"{exact:.6g}", "right": f"{value:.6g}"})
