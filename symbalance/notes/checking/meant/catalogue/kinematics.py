"""The motion of a slider-crank: path, speed, acceleration and jerk of the piston, swing of the rod.

Letters in the formulas are r, the crank radius, `lam`, the crank radius over the rod length, w, the
angular speed, theta, the crank angle from the top dead centre, and e, by which the line of stroke misses
the crank. A motion has one formula at any angle and others at a place: at a dead centre, a quarter turn
behind the top, or where it is largest. `tests/independent/test_kinematics.py` compares each with the path
of a piston.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.formula import PI, Call, Formula, Name, Number, Sum, cos, sin, sqrt

r, lam, w, theta, e = map(Name, ("r", "lam", "w", "theta", "e"))
ROD = r / lam
_DOUBLE = 2 * theta
_INNER = 1 - lam**2 * sin(theta) ** 2
_ROOT = sqrt(_INNER)

PATH, SPEED, ACCELERATION, JERK = "displacement", "velocity", "acceleration", "jerk"
ROD_ANGLE, ROD_SPEED, ROD_ACCELERATION = (
    "rod angle", "angular velocity of the rod", "angular acceleration of the rod",
)  # fmt: skip
STROKE, FASTEST, HUMP = "stroke", "crank angle of the largest speed", "crank angle of the third extreme"
HALF = "crank angle at half the stroke"
SHORTENING = "shortening by the inclined rod"
TOP, BOTTOM, RIGHT, LARGEST, LEAST = "top", "bottom", "right", "largest", "least"
TURNED = frozenset({PATH, SPEED, ACCELERATION, JERK, ROD_ANGLE, ROD_SPEED, ROD_ACCELERATION})
"""Motions that are functions of the crank angle, whose direction anybody may choose."""


@dataclass(frozen=True, slots=True)
class Motion:
    """The formulas of one motion at one place: exact ones, and those that hold where the rod is long."""

    exact: tuple[Formula, ...]
    rough: tuple[Formula, ...] = ()


_CENTRED = r * cos(theta) + ROD * _ROOT
_TRAVEL = r * (1 - cos(theta)) + ROD * (1 - _ROOT)
_NO_LENGTH = Number(Fraction(0))
MOTIONS: Mapping[tuple[str, str], Motion] = {
    (PATH, ""): Motion(
        (
            _TRAVEL, _CENTRED, Sum((_CENTRED, -ROD)),
            r * (1 + cos(theta)) - ROD * (1 - _ROOT),
        )
    ),
    (PATH, TOP): Motion((_NO_LENGTH, ROD + r, 2 * r)),
    (PATH, BOTTOM): Motion((2 * r, ROD - r, _NO_LENGTH)),
    (PATH, RIGHT): Motion(
        (r + ROD * (1 - sqrt(1 - lam**2)), ROD * sqrt(1 - lam**2), ROD * (1 - sqrt(1 - lam**2)))
    ),
    (PATH, LARGEST): Motion((2 * r, ROD + r)),
    (PATH, LEAST): Motion((_NO_LENGTH, ROD - r)),
    (SHORTENING, RIGHT): Motion((ROD * (1 - sqrt(1 - lam**2)),)),
    (SHORTENING, ""): Motion((ROD * (1 - _ROOT),)),
    (SPEED, ""): Motion((r * w * (sin(theta) + lam * sin(theta) * cos(theta) / _ROOT),)),
    (SPEED, TOP): Motion((_NO_LENGTH,)),
    (SPEED, BOTTOM): Motion((_NO_LENGTH,)),
    (SPEED, RIGHT): Motion((r * w,)),
    (SPEED, LARGEST): Motion((), (r * w * sqrt(1 + lam**2), r * w * (1 + lam**2 / 2))),
    (ACCELERATION, ""): Motion(
        (
            r * w**2 * (
                cos(theta) + (lam * cos(_DOUBLE) + lam**3 * sin(theta) ** 4) / (_ROOT * _INNER)
            ),
        )
    ),
    (ACCELERATION, TOP): Motion((r * w**2 * (1 + lam),)),
    (ACCELERATION, BOTTOM): Motion((r * w**2 * (1 - lam),)),
    (ACCELERATION, RIGHT): Motion((lam * r * w**2 / sqrt(1 - lam**2),), (lam * r * w**2,)),
    (ACCELERATION, LARGEST): Motion((r * w**2 * (1 + lam),)),
    (ACCELERATION, LEAST): Motion(
        (r * w**2 * (1 - lam),), (r * w**2 * (lam + 1 / (8 * lam)),)
    ),
    (JERK, ""): Motion((), (r * w**3 * (sin(theta) + 2 * lam * sin(_DOUBLE)),)),
    (JERK, RIGHT): Motion((), (r * w**3,)),
    (JERK, TOP): Motion((_NO_LENGTH,)),
    (JERK, BOTTOM): Motion((_NO_LENGTH,)),
    (ROD_ANGLE, ""): Motion((Call("asin", lam * sin(theta)),)),
    (ROD_ANGLE, LARGEST): Motion((Call("asin", lam),)),
    (ROD_ANGLE, RIGHT): Motion((Call("asin", lam),)),
    (ROD_ANGLE, TOP): Motion((_NO_LENGTH,)),
    (ROD_ANGLE, BOTTOM): Motion((_NO_LENGTH,)),
    (ROD_SPEED, ""): Motion((lam * w * cos(theta) / _ROOT,)),
    (ROD_SPEED, LARGEST): Motion((lam * w,)),
    (ROD_SPEED, TOP): Motion((lam * w,)),
    (ROD_SPEED, BOTTOM): Motion((lam * w,)),
    (ROD_SPEED, RIGHT): Motion((_NO_LENGTH,)),
    (ROD_ACCELERATION, ""): Motion(
        (-lam * (1 - lam**2) * w**2 * sin(theta) / (_ROOT * _INNER),), (-lam * w**2 * sin(theta),)
    ),
    (ROD_ACCELERATION, LARGEST): Motion((lam * w**2 / sqrt(1 - lam**2),), (lam * w**2,)),
    (ROD_ACCELERATION, RIGHT): Motion((lam * w**2 / sqrt(1 - lam**2),), (lam * w**2,)),
    (ROD_ACCELERATION, TOP): Motion((_NO_LENGTH,)),
    (ROD_ACCELERATION, BOTTOM): Motion((_NO_LENGTH,)),
    (STROKE, ""): Motion((2 * r,)),
    (FASTEST, ""): Motion(
        (),
        (Call("acos", (sqrt(1 + 8 * lam**2) - 1) / (4 * lam)), Call("atan", 1 / lam), Call("acos", lam),
         PI / 2 - lam),
    ),
    (HALF, ""): Motion((Call("acos", lam / 2),), (PI / 2 - lam / 2,)),
    (HUMP, ""): Motion((), (Call("acos", -1 / (4 * lam)),)),
}  # fmt: skip
"""By motion and place. Formulas that a page may give the other sign are those of `TURNED`."""
_OFFSET_ANGLE = Call("asin", (r * sin(theta) - e) / ROD)
OFFSET: Mapping[tuple[str, str], Motion] = {
    (STROKE, ""): Motion((sqrt((ROD + r) ** 2 - e**2) - sqrt((ROD - r) ** 2 - e**2),)),
    (ROD_ANGLE, ""): Motion((_OFFSET_ANGLE, Call("asin", (r * sin(theta) + e) / ROD))),
    (ROD_ANGLE, LARGEST): Motion((Call("asin", (r + e) / ROD),)),
    (FASTEST, TOP): Motion((Call("asin", e / (ROD + r)),)),
    (FASTEST, BOTTOM): Motion((Call("asin", e / (ROD - r)),)),
    (PATH, ""): Motion(
        (
            r * cos(theta) + sqrt(ROD**2 - (r * sin(theta) - e) ** 2),
            r * cos(theta) + sqrt(ROD**2 - (r * sin(theta) + e) ** 2),
        )
    ),
    (PATH, TOP): Motion((sqrt((ROD + r) ** 2 - e**2),)),
    (PATH, BOTTOM): Motion((sqrt((ROD - r) ** 2 - e**2),)),
}  # fmt: skip
"""The same of a crank whose axis the line of stroke misses by e."""
AT_TOP_FROM_TOP = Motion((_NO_LENGTH, ROD + r))
"""The way at the top where the page counts it from there: the stroke 2 r is that at the bottom."""
