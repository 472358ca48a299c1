"""The steps of a derivation that expand the geometry in powers of sin theta, then in multiple angles.

Formulas:
    x = r (1 - cos theta) + l (1 - cos phi)
    cos phi = sqrt(1 - rho^2 sin^2 theta)
    sqrt(1 - X) = 1 - X/2 - X^2/8 - X^3/16 - ...
    sin^4 theta = (3 - 4 cos 2 theta + cos 4 theta)/8
    sin^5 theta = (10 sin theta - 5 sin 3 theta + sin 5 theta)/16
    with X a number
"""

from __future__ import annotations

from fractions import Fraction
from math import comb

from symbalance.document.formula import (
    Call,
    Dots,
    Equation,
    Formula,
    Name,
    Negative,
    Power,
    Quotient,
    Sum,
    alternating,
    binomial,
    cos,
    equal,
    monomial,
    number,
    signed,
    sin,
    sqrt,
    total,
)
from symbalance.document.nodes import Paragraph
from symbalance.kinematics.derivation.request import (
    INDEX_I,
    PHI,
    THETA,
    J,
    K,
    L,
    R,
    Request,
    S,
    Step,
    X,
    general_term,
    harmonic,
    prose,
)

ROOT_TERMS = 5
"""How many terms of the binomial series a derivation shows at least."""
BIG_X = Name("X")


def geometry(request: Request) -> Step:
    """Return step 1: the crank, the rod, and where everything is measured from."""
    letters = request.letters
    about = [
        "The crank pin turns at ", *_crank(request), " about the crankshaft; ", THETA,
        " is the crank angle, ", equal(THETA, number(0)), " at top dead centre. The rod, of length ", L,
        " between centres, joins the pin to a piston whose axis passes through the crankshaft, and makes"
        " the angle ", PHI, " with that axis",
    ]  # fmt: skip
    pin = equal(L * sin(PHI), letters.radius * sin(THETA))
    ratio = prose("With ", letters.ratio, " (", letters.meaning, ")")
    slope = equal(sin(PHI), letters.sine)
    if request.rod_angle:
        side = " (positive towards the side of the pin after top dead centre)."
        return Step("Geometry", (Paragraph((*about, side)), pin, ratio, slope))
    measured = prose(
        "The piston's displacement ", X, " is measured from top dead centre towards the crank;"
        " velocity and acceleration are positive in the same direction."
    )  # fmt: skip
    radius = letters.radius
    whole = radius + L - (radius * cos(THETA) + L * cos(PHI))
    position = equal(X, whole, radius * (1 - cos(THETA)) + L * (1 - cos(PHI)))
    return Step("Geometry", (Paragraph((*about, ".")), measured, pin, position, ratio, slope))


def _crank(request: Request) -> tuple[str | Formula | Equation, ...]:
    if request.convention == "l/s":
        return ("the radius ", S / number(2), ", half the stroke ", S, ",")
    return ("the radius ", R)


def root(request: Request) -> Step:
    """Return step 2: cos phi as a root, positive since the rod is longer than the crank."""
    letters = request.letters
    value = sqrt(1 - _square(request))
    piston = letters.radius * (1 - cos(THETA)) + letters.rod * (1 - value)
    words = prose(
        "The rod is longer than the crank, so ", PHI, " stays within a right angle and ", cos(PHI),
        " is the positive root:",
    )  # fmt: skip
    return Step("The root", (words, equal(cos(PHI), sqrt(1 - sin(PHI, 2)), value), equal(X, piston)))


def _square(request: Request) -> Formula:
    """Return sin^2 phi in the crank angle."""
    return request.rho_power(2, of=sin(THETA, 2))


def root_series(request: Request) -> Step:
    """Return step 3: sqrt(1 - X) = 1 - sum of C(2m, m)/(2m - 1) (X/4)^m, and what is kept of it."""
    count = ROOT_TERMS if request.long else max(ROOT_TERMS, request.last // 2)
    terms = [Negative(_power_of_x(_root_term(m), m)) for m in range(1, count + 1)]
    general = binomial(2 * J, J) / (2 * J - 1) * Power(BIG_X / number(4), J)
    series = Equation(
        sqrt(1 - BIG_X),
        (
            ("=", Sum((number(1), *terms, Negative(Dots())))),
            ("=", 1 - total(J, number(1), None, general)),
        ),
    )
    words = prose(
        "The binomial series, which converges as ", equal(BIG_X, _square(request)), " stays below 1:"
    )
    rod = request.letters.rod * (1 - sqrt(1 - BIG_X))
    if request.last == 0:
        truncated = prose("Order 1 keeps none of its powers: the root is replaced by 1, so that ",
                     Equation(rod, (("≈", number(0)),)), ".")  # fmt: skip
        return Step("The root as a series", (words, series, truncated))
    rows = [request.rho_power(p - 1, _root_term(p // 2), sin(THETA, p)) for p in request.sine_powers()]
    m = request.last // 2
    end = general_term(
        request, [_central(m), sin(THETA, 2 * m)], [number(2 * m - 1), number(4) ** m], 2 * m - 1
    )
    truncated = Equation(rod, (("≈", request.letters.radius * _elided(request, rows, end)),))
    return Step("The root as a series", (words, series, _kept_to(request), truncated))


def _root_term(m: int) -> Fraction:
    """Return the coefficient of X^m in 1 - sqrt(1 - X)."""
    return Fraction(comb(2 * m, m), (2 * m - 1) * 4**m)


def _power_of_x(coefficient: Fraction, exponent: int) -> Formula:
    return monomial(coefficient, BIG_X, exponent)


def _kept_to(request: Request) -> Paragraph:
    also = ""
    if request.long:
        also = " (the derivation being long, only the first and the last are written out)"
    return prose("Kept to ", sin(THETA, request.last), also, ":")


def _elided(request: Request, rows: list[Formula], end: Formula) -> Sum:
    """Return the rows as a sum: of a long derivation the first three, dots and the last as `end`."""
    return Sum((*rows[:3], Dots(), end) if request.long and len(rows) > 4 else tuple(rows))


def _central(j: int) -> Formula:
    return binomial(2 * j, j)


def inverse_sine(request: Request) -> Step:
    """Return step 2 of the rod's angle."""
    words = prose("The rod is longer than the crank, so ", PHI, " stays within a right angle:")
    return Step("The inverse sine", (words, equal(PHI, Call("asin", request.letters.sine))))


def inverse_sine_series(request: Request) -> Step:
    """Return step 3 of the rod's angle: asin X = sum of C(2j, j) X^(2j+1)/(4^j (2j + 1))."""
    count = ROOT_TERMS if request.long else max(ROOT_TERMS, request.last // 2 + 1)
    terms = [_power_of_x(_inverse_sine_term(j), 2 * j + 1) for j in range(count)]
    general = Quotient(binomial(2 * J, J), Power(number(4), J) * (2 * J + 1)) * Power(BIG_X, 2 * J + 1)
    arcsine = Call("asin", BIG_X)
    series = equal(arcsine, Sum((*terms, Dots())), total(J, number(0), None, general))
    words = prose(
        "The series, which converges as ", equal(BIG_X, request.letters.sine), " stays below 1:"
    )
    rows = [
        request.rho_power(p, _inverse_sine_term(p // 2), sin(THETA, p)) for p in request.sine_powers()
    ]
    p, j = request.last, request.last // 2
    end = general_term(request, [_central(j), sin(THETA, p)], [number(p), number(4) ** j], p)
    truncated = Equation(PHI, (("≈", _elided(request, rows, end)),))
    return Step("The inverse sine as a series", (words, series, _kept_to(request), truncated))


def _inverse_sine_term(j: int) -> Fraction:
    return Fraction(comb(2 * j, j), (2 * j + 1) * 4**j)


def even_powers(request: Request) -> Step:
    """Return step 4: sin^2m theta = (C(2m, m)/2 + sum of (-1)^k C(2m, m-k) cos 2k theta) / 2^(2m-1)."""
    if request.last == 0:
        return Step(
            "Multiple angles", (prose("At order 1 no power of ", sin(THETA), " is left to resolve."),)
        )
    lines = [_even_power(power // 2) for power in _powers_written(request)]
    body = alternating(K) * binomial(2 * J, J - K) * cos(2 * K * THETA)
    general = equal(
        sin(THETA, 2 * J),
        1 / Power(number(4), J) * (binomial(2 * J, J) + 2 * total(K, number(1), J, body)),
    )
    return _multiple_angles(request, lines, general)


def _even_power(m: int) -> Equation:
    terms: list[Formula] = [number(comb(2 * m, m) // 2)]
    for k in range(1, m + 1):
        terms.append(signed((-1) ** k, _times(comb(2 * m, m - k), harmonic("cos", 2 * k))))
    return equal(sin(THETA, 2 * m), _shared(Sum(tuple(terms)), 2 ** (2 * m - 1)))


def odd_powers(request: Request) -> Step:
    """Return step 4 of the rod's angle.

    sin^(2j+1) theta = sum of (-1)^i C(2j+1, j-i) sin (2i+1) theta / 4^j.
    """
    lines = [_odd_power(power // 2) for power in _powers_written(request) if power > 1]
    body = alternating(INDEX_I) * binomial(2 * J + 1, J - INDEX_I) * sin((2 * INDEX_I + 1) * THETA)
    general = equal(sin(THETA, 2 * J + 1), 1 / Power(number(4), J) * total(INDEX_I, number(0), J, body))
    if not lines:
        return Step(
            "Multiple angles", (prose("The first power of ", sin(THETA), " is a harmonic already."),)
        )
    return _multiple_angles(request, lines, general)


def _odd_power(j: int) -> Equation:
    terms = [
        signed((-1) ** i, _times(comb(2 * j + 1, j - i), harmonic("sin", 2 * i + 1)))
        for i in range(j + 1)
    ]
    return equal(sin(THETA, 2 * j + 1), _shared(Sum(tuple(terms)), 4**j))


def _times(number: int, value: Formula) -> Formula:
    return value if number == 1 else number * value


def _shared(terms: Sum, under: int) -> Formula:
    """Return terms over a common denominator: as a fraction, or where that grows long times one."""
    return terms / number(under) if len(terms.terms) < 5 else 1 / number(under) * terms


def _powers_written(request: Request) -> list[int]:
    powers = list(request.sine_powers())
    return powers[:4] if request.long else powers


def _multiple_angles(request: Request, lines: list[Equation], general: Equation) -> Step:
    goes_on = (prose("and so on: in general"),) if request.long else (prose("These are cases of"),)
    return Step("Multiple angles", (*lines, *goes_on, general))
