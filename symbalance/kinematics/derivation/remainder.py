r"""The last step of a derivation: the general term, the exact form, and what is left out."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    PI,
    Call,
    Equation,
    Formula,
    Name,
    Product,
    Quotient,
    Subscript,
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
from symbalance.document.nodes import Paragraph
from symbalance.kinematics.conventions import CONVENTIONS
from symbalance.kinematics.derivation.bounds import numbers
from symbalance.kinematics.derivation.collection import LETTER
from symbalance.kinematics.derivation.setting import (
    HALF,
    INDEX_I,
    KAPPA,
    PHI,
    RHO,
    THETA,
    J,
    K,
    Q,
    Setting,
    Step,
    X,
    harmonic,
    prose,
)
from symbalance.kinematics.slider_crank import Harmonics

REST, MEAN = Subscript(Name("B"), number(0)), Subscript(Name("c"), number(0))
V, A, F = Name("v"), Name("a"), Name("F")
_LEFT = {"displacement": X, "velocity": V, "acceleration": A, "force": F}

Parts = tuple[Paragraph | Equation, ...]


def left_out_step(setting: Setting, found: Harmonics) -> Step:
    """Return what the truncation leaves out: in closed form, and as numbers at l/r = 4."""
    middle = _angle(setting) if setting.rod_angle else _piston(setting)
    return Step("What is left out", (_missing(setting), *middle, *numbers(setting, found)))


def _missing(setting: Setting) -> Paragraph:
    kept = setting.last if setting.rod_angle else setting.last - 1
    letters, (letter, direction, _) = setting.letters, CONVENTIONS[setting.convention]
    powers = (" beyond ", monomial(Fraction(1), Name(letter), direction * kept)) if kept > 0 else ()
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
        *missing, f" harmonics above order {setting.order}. Both are known in closed form. With ",
        *((equal(RHO, letters.rho),) if setting.convention != "r/l" else (letters.ratio,)),
        ", for every order and without truncation:",
    )  # fmt: skip


def _piston(setting: Setting) -> Parts:
    """Return the exact harmonics of a piston quantity: in powers of rho, and by 2F1 of q^2."""
    letter, quantity = LETTER[setting.quantity], setting.quantity
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
        _exact_piston(setting, coefficient),
        Equation(coefficient, (("=", powers), ("=", exact))),
        *roots,
        *_rest_position(setting),
        *_bound_piston(setting, coefficient),
    )


def _factors(value: Formula) -> tuple[Formula, ...]:
    return value.factors if isinstance(value, Product) else (value,)


def _exact_piston(setting: Setting, coefficient: Subscript) -> Equation:
    if setting.quantity == "displacement":
        inside = REST - cos(THETA) - total(K, number(1), None, coefficient * cos(2 * K * THETA))
    else:
        function = "sin" if setting.quantity == "velocity" else "cos"
        rest = total(K, number(1), None, coefficient * Call(function, 2 * K * THETA))
        inside = harmonic(function, 1) + rest
    return equal(_LEFT[setting.quantity], setting.unit() * inside)


def _error(quantity: Name) -> Name:
    return Name(f"Delta {quantity.name}")


def _rest_position(setting: Setting) -> Parts:
    """Return B_0 = 1 + (1 - c_0)/rho with c_0, the mean of the root."""
    if setting.quantity != "displacement":
        return ()
    mean = HALF * (1 + KAPPA) * hypergeometric(-HALF, -HALF, number(1), Q**2)
    return equal(REST, 1 + (1 - MEAN) / RHO), equal(MEAN, mean)


def _bound_piston(setting: Setting, coefficient: Subscript) -> Parts:
    """Return the bound in words and formulas: all harmonics add at a quarter turn."""
    tail = total(K, number(setting.order // 2 + 1), None, absolute(coefficient))
    every = total(K, number(1), None, absolute(coefficient))
    error = Quotient(absolute(_error(_LEFT[setting.quantity])), setting.unit())
    if setting.quantity == "velocity":
        words = prose(
            "All terms of one coefficient have the same sign, so the harmonics left out amount to at"
            " most the sum of their coefficients' sizes:"
        )  # fmt: skip
        return words, Equation(error, (("≤", tail),))
    there = _adding_up(coefficient, K, cos(2 * K * THETA))
    whole = (MEAN - KAPPA) / RHO if setting.quantity == "displacement" else RHO / sqrt(1 - RHO**2)
    rest = (("=", whole - _kept(K, 1, setting.order // 2, coefficient)),) if setting.order > 1 else ()
    return there, equal(every, whole), Equation(error, (("≤", tail), *rest))


def _adding_up(coefficient: Subscript, index: Name, function: Formula) -> Paragraph:
    return prose(
        "All terms of one coefficient have the same sign, and the signs of ", coefficient,
        " alternate with ", index, ", as those of ", function, " do at ", equal(THETA, PI / number(2)),
        ": there all harmonics add up, and the error of leaving some out is greatest:",
    )  # fmt: skip


def _kept(index: Name, first: int, last: int, coefficient: Subscript) -> Formula:
    """Return the sum of the sizes of the coefficients that are kept."""
    if first == last:
        return absolute(Subscript(coefficient.base, number(2 if index == K else 1)))
    return total(index, number(first), number(last), absolute(coefficient))


def _angle(setting: Setting) -> Parts:
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
    first = (setting.order + 1) // 2
    tail = total(INDEX_I, number(first), None, absolute(coefficient))
    kept = _kept(INDEX_I, 0, first - 1, coefficient)
    there = _adding_up(coefficient, INDEX_I, sin(odd * THETA))
    return (
        equal(PHI, total(INDEX_I, number(0), None, coefficient * sin(odd * THETA))),
        Equation(coefficient, (("=", powers), ("=", exact))),
        there,
        equal(every, Call("asin", RHO)),
        Equation(absolute(_error(PHI)), (("≤", tail), ("=", Call("asin", RHO) - kept))),
    )
