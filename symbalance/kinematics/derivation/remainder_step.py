"""The last step of a derivation: general term, exact form, and truncation error in numbers.

The coefficients printed lack terms of their own sign only, so that the printed formula differs from
the exact quantity by at most

    sum over the harmonics printed of (|exact| - |printed|), and the harmonics left out.

All harmonics add up at a quarter turn, where the exact quantity is known; of the rod angle:

Formulas:
    asin rho = R_1 - R_3 + R_5 - R_7 + R_9 - R_11 + R_13 - R_15 + ...
"""

from __future__ import annotations

import decimal
from fractions import Fraction

from symbalance.document.formula import (
    PI,
    Call,
    Decimal,
    Equation,
    Formula,
    Name,
    Product,
    Quotient,
    Subscript,
    Upright,
    absolute,
    alternating,
    binomial,
    cos,
    equal,
    hypergeometric,
    monomial,
    number,
    sin,
    sqrt,
    total,
)
from symbalance.document.nodes import Paragraph, inlines
from symbalance.kinematics.conventions import CONVENTIONS
from symbalance.kinematics.derivation.harmonic_steps import LETTER
from symbalance.kinematics.derivation.request import (
    HALF,
    INDEX_I,
    KAPPA,
    LAM,
    PHI,
    RHO,
    THETA,
    J,
    K,
    L,
    Q,
    R,
    Request,
    Step,
    X,
    harmonic,
    prose,
)
from symbalance.kinematics.slider_crank import (
    Harmonics,
    acceleration_value,
    integrated,
    rod_angle_value,
    root_mean,
)
from symbalance.kinematics.truncation import left_out
from symbalance.text.reals import Real, nstr

REST, MEAN = Subscript(Name("B"), number(0)), Subscript(Name("c"), number(0))
V, A, F = Name("v"), Name("a"), Name("F")
_LEFT = {"displacement": X, "velocity": V, "acceleration": A, "force": F}

Parts = tuple[Paragraph | Equation, ...]


def left_out_step(request: Request, outcome: Harmonics) -> Step:
    """Return what the truncation leaves out: in closed form, and as numbers at l/r = 4."""
    middle = _angle(request) if request.rod_angle else _piston(request)
    return Step("What is left out", (_missing(request), *middle, *error_bounds(request, outcome)))


def _missing(request: Request) -> Paragraph:
    last_power = request.last if request.rod_angle else request.last - 1
    letters, (letter, direction, _) = request.letters, CONVENTIONS[request.convention]
    powers = (
        (" beyond ", monomial(Fraction(1), Name(letter), direction * last_power))
        if last_power > 0
        else ()
    )
    variable = monomial(Fraction(1), Name(letter), direction)
    missing = (
        (
            "Two things are missing above: in each coefficient the powers of ",
            variable,
            *powers,
            ", and all",
        )
        if powers
        else ("Missing above are the powers of ", variable, ", and with them all")
    )
    return prose(
        *missing, f" harmonics above order {request.order}. Both are known in closed form. With ",
        *((equal(RHO, letters.rho),) if request.convention != "r/l" else (letters.ratio,)),
        ", for every order and without truncation:",
    )  # fmt: skip


def _piston(request: Request) -> Parts:
    """Return the exact harmonics of a piston quantity: in powers of rho, and by 2F1 of q^2."""
    letter, quantity = LETTER[request.quantity], request.quantity
    coefficient = Subscript(Name(letter), 2 * K)
    weight = {"displacement": number(2), "velocity": 4 * K}.get(quantity, 8 * K**2)
    lead = {"displacement": number(1), "velocity": 2 * K}.get(quantity, 4 * K**2)
    term = Quotient(
        Product((*_factors(weight), binomial(2 * J, J), binomial(2 * J, J - K))),
        (2 * J - 1) * number(16) ** J,
    )
    powers = alternating(K + 1) * total(J, K, None, term * RHO ** (2 * J - 1))
    hyper = hypergeometric(-HALF, K - HALF, K + 1, Q**2)
    exact = Quotient(lead, RHO) * (1 + KAPPA) * binomial(HALF, K) * Q**K * hyper
    roots = (
        equal(KAPPA, sqrt(1 - RHO**2)),
        equal(Q, (RHO / (1 + KAPPA)) ** 2, (1 - KAPPA) / (1 + KAPPA)),
    )
    return (
        _exact_piston(request, coefficient),
        Equation(coefficient, (("=", powers), ("=", exact))),
        *roots,
        *_rest_position(request),
        *_bound_piston(request, coefficient),
    )


def _factors(value: Formula) -> tuple[Formula, ...]:
    return value.factors if isinstance(value, Product) else (value,)


def _exact_piston(request: Request, coefficient: Subscript) -> Equation:
    if request.quantity == "displacement":
        inside = REST - cos(THETA) - total(K, number(1), None, coefficient * cos(2 * K * THETA))
    else:
        function = "sin" if request.quantity == "velocity" else "cos"
        rest = total(K, number(1), None, coefficient * Call(function, 2 * K * THETA))
        inside = harmonic(function, 1) + rest
    return equal(_LEFT[request.quantity], request.unit() * inside)


def _error(quantity: Name) -> Name:
    return Name(f"Delta {quantity.name}")


def _rest_position(request: Request) -> Parts:
    """Return B_0 = 1 + (1 - c_0)/rho with c_0, the mean of the root."""
    if request.quantity != "displacement":
        return ()
    mean = HALF * (1 + KAPPA) * hypergeometric(-HALF, -HALF, number(1), Q**2)
    return equal(REST, 1 + (1 - MEAN) / RHO), equal(MEAN, mean)


def _bound_piston(request: Request, coefficient: Subscript) -> Parts:
    """Return the bound in words and formulas: all harmonics add at a quarter turn."""
    tail = total(K, number(request.order // 2 + 1), None, absolute(coefficient))
    every = total(K, number(1), None, absolute(coefficient))
    error = Quotient(absolute(_error(_LEFT[request.quantity])), request.unit())
    if request.quantity == "velocity":
        words = prose(
            "All terms of one coefficient have the same sign, so the harmonics left out amount to at"
            " most the sum of their coefficients' sizes:"
        )  # fmt: skip
        return words, Equation(error, (("≤", tail),))
    adding_up = _adding_up(coefficient, K, cos(2 * K * THETA))
    whole = (MEAN - KAPPA) / RHO if request.quantity == "displacement" else RHO / sqrt(1 - RHO**2)
    if request.order == 1:
        return adding_up, equal(every, whole), Equation(error, (("≤", tail),))
    rest = (("=", whole - _sum_of_sizes(K, 1, request.order // 2, coefficient)),)
    return adding_up, equal(every, whole), Equation(error, (("≤", tail), *rest))


def _adding_up(coefficient: Subscript, index: Name, function: Formula) -> Paragraph:
    return prose(
        "All terms of one coefficient have the same sign, and the signs of ", coefficient,
        " alternate with ", index, ", as those of ", function, " do at ", equal(THETA, PI / number(2)),
        ": there all harmonics add up, and the error of leaving some out is greatest:",
    )  # fmt: skip


def _sum_of_sizes(index: Name, first: int, last: int, coefficient: Subscript) -> Formula:
    """Return the sum of the sizes of the coefficients that are kept."""
    if first == last:
        return absolute(Subscript(coefficient.base, number(2 if index == K else 1)))
    return total(index, number(first), number(last), absolute(coefficient))


def _angle(request: Request) -> Parts:
    """Return the exact harmonics of the rod's angle, in powers of rho and by 2F1 of rho^2."""
    odd, half = 2 * INDEX_I + 1, INDEX_I + HALF
    coefficient = Subscript(Name("R"), odd)
    term = Quotient(binomial(2 * J, J) * binomial(2 * J + 1, J - INDEX_I), (2 * J + 1) * number(16) ** J)
    powers = alternating(INDEX_I) * total(J, INDEX_I, None, term * RHO ** (2 * J + 1))
    lead = Quotient(binomial(2 * INDEX_I, INDEX_I), (2 * INDEX_I + 1) * number(16) ** INDEX_I)
    exact = (
        alternating(INDEX_I)
        * lead
        * RHO ** (2 * INDEX_I + 1)
        * hypergeometric(half, half, 2 * INDEX_I + 2, RHO**2)
    )
    every = total(INDEX_I, number(0), None, absolute(coefficient))
    first = (request.order + 1) // 2
    tail = total(INDEX_I, number(first), None, absolute(coefficient))
    included = _sum_of_sizes(INDEX_I, 0, first - 1, coefficient)
    adding_up = _adding_up(coefficient, INDEX_I, sin(odd * THETA))
    return (
        equal(PHI, total(INDEX_I, number(0), None, coefficient * sin(odd * THETA))),
        Equation(coefficient, (("=", powers), ("=", exact))),
        adding_up,
        equal(every, Call("asin", RHO)),
        Equation(absolute(_error(PHI)), (("≤", tail), ("=", Call("asin", RHO) - included))),
    )


# In figures -------------------------------------------------------------------------------------

RATIO = Fraction(4)
"""The rod ratio l/r at which bounds are given as numbers."""
_AT_RATIO = {
    "l/r": (equal(LAM, number(4)),),
    "r/l": (equal(RHO, Quotient(number(1), number(4))),),
    "l/s": (equal(LAM, number(2)), " (", equal(L / R, number(4)), ")"),
}


def error_bounds(request: Request, outcome: Harmonics) -> tuple[Paragraph, ...]:
    """Return what is left out at l/r = 4, in figures."""
    bound = _with_unit(request, left_out(request.order, RATIO, request.quantity))
    at = _AT_RATIO[request.convention]
    first = prose(
        "At ", *at, f" the harmonics above order {request.order} amount to at most ", bound,
        ", with every coefficient kept exact.",
    )  # fmt: skip
    if request.long:
        return (first,)
    printed = _with_unit(request, printed_error(request.order, outcome))
    if printed == bound:  # no coefficient is truncated
        return (first,)
    return (
        prose(
            *inlines(first.words),
            " With the coefficients as they are printed the error is at most ",
            printed,
            ".",
        ),
    )


def _with_unit(request: Request, value: Real) -> Formula:
    return rounded_up(value) * (Upright("rad") if request.rod_angle else request.unit())


def rounded_up(value: Real) -> Decimal:
    """Return a bound to three digits, rounded up so that it stays one.

    >>> rounded_up(Real("1.52541e-6")).text, rounded_up(Real("0.0123456")).text
    ('1.53e-6', '0.0124')
    """
    context = decimal.Context(prec=3, rounding=decimal.ROUND_CEILING)
    bound = context.create_decimal(decimal.Decimal(nstr(value, 15)))
    exponent = bound.adjusted()
    if exponent >= -2:
        return Decimal(str(bound))
    mantissa = bound.scaleb(-exponent).quantize(decimal.Decimal("0.01"))
    return Decimal(f"{mantissa}e{exponent}")


def printed_error(order: int, outcome: Harmonics, ratio: Fraction = RATIO) -> Real:
    """Return a bound on |exact - the truncated series in `outcome`| over all crank angles.

    >>> from symbalance.text.reals import nstr
    >>> from symbalance.kinematics.slider_crank import harmonics
    >>> nstr(printed_error(2, harmonics("force", 2)), 3)
    '0.0082'
    """
    total = left_out(order, ratio, outcome.quantity)
    for n, series in outcome.terms.items():
        total += _size(outcome.quantity, n, ratio) - abs(series.at(ratio))
    if outcome.quantity == "displacement":
        total += 1 + (1 - root_mean(ratio)) * ratio - outcome.constant.at(ratio)
    return total


def _size(quantity: str, n: int, ratio: Fraction) -> Real:
    if quantity == "rod-angle":
        return abs(rod_angle_value(n, ratio))
    return abs(acceleration_value(n, ratio)) * abs(integrated(quantity, n))
