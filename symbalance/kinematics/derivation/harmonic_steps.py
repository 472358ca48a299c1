"""The steps of a derivation that collect the harmonics, differentiate them and state the result."""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.document.formula import (
    Derivative,
    Dots,
    Equation,
    Formula,
    Name,
    Subscript,
    Sum,
    binomial,
    equal,
    number,
    signed,
)
from symbalance.document.nodes import Paragraph
from symbalance.kinematics.derivation.request import (
    LONGEST_IN_FULL,
    OMEGA,
    PHI,
    THETA,
    M,
    Request,
    Step,
    X,
    general_term,
    harmonic,
    prose,
)
from symbalance.kinematics.series_printing import monomials
from symbalance.kinematics.slider_crank import Harmonics, Series, harmonics

V, A, F, T = map(Name, "vaFt")
LETTER = {"displacement": "B", "velocity": "V", "acceleration": "A", "force": "A", "rod-angle": "R"}
"""What a quantity's coefficients are called."""
_TITLES = {
    "velocity": "Differentiated once",
    "acceleration": "Differentiated twice",
    "force": "Differentiated twice, times the mass",
}
_OPENING = {"displacement": 4, "velocity": 3, "acceleration": 3, "force": 3, "rod-angle": 3}
"""How many terms a long sum shows before its dots."""

Parts = tuple[Paragraph | Equation, ...]


def collection_steps(request: Request, outcome: Harmonics) -> tuple[Step, ...]:
    """Return the step that collects the harmonics and, where asked for, their derivatives."""
    if request.quantity not in _TITLES:
        subject = PHI if request.rod_angle else X
        parts = _result(request, outcome, subject, ())
        return (Step("Collected harmonics", (*_beyond(request), *parts)),)
    before = Step("Collected harmonics", (*_beyond(request), *_stage("displacement", request, X, (), 3)))
    return before, Step(_TITLES[request.quantity], _derivatives(request, outcome))


def _derivatives(request: Request, outcome: Harmonics) -> Parts:
    """Return v = omega dx/d theta, a = omega dv/d theta and F = m a, as far as asked for."""
    words = prose("The crank turns at the constant speed ", equal(OMEGA, Derivative(THETA, T)), ":")
    to_v = (Derivative(X, T), OMEGA * Derivative(X, THETA))
    to_a = (Derivative(V, T), OMEGA * Derivative(V, THETA))
    if request.quantity == "velocity":
        return words, *_result(request, outcome, V, to_v)
    velocity = _stage("velocity", request, V, to_v, 0)
    if request.quantity == "acceleration":
        return words, *velocity, *_result(request, outcome, A, to_a)
    mass = prose(
        "The reciprocating mass ", M, " answers with the inertia force ", F, " on the engine,"
        " positive away from the crank:"
    )  # fmt: skip
    acceleration = _stage("acceleration", request, A, to_a, 0)
    return words, *velocity, *acceleration, mass, *_result(request, outcome, F, (M * A,))


def _beyond(request: Request) -> Parts:
    """Return what becomes of harmonics above the order asked for, where powers bring some."""
    if request.last <= request.order:
        return ()
    return (prose(f"The harmonics above order {request.order} are left out from here on."),)


def _stage(
    quantity: str, request: Request, subject: Formula, via: tuple[Formula, ...], count: int
) -> Parts:
    """Return an intermediate quantity: in full, or of a long derivation with `listed` coefficients."""
    stage = Request(quantity, request.order, request.power, request.convention)
    if not request.long:
        return (_equation(stage, harmonics(quantity, stage.order, stage.power), subject, via),)
    equation = _long_equation(stage, subject, via)
    if not count:
        return (equation,)
    few = harmonics(quantity, min(stage.order, 2 * count), min(stage.power, 2 * count + 1))
    rows = {n: Series(dict(sorted(s.terms.items())[:2]), s.through) for n, s in few.terms.items()}
    words = prose("with coefficients whose first terms are")
    after = prose("and so on; the last step has their general term.")
    return (equation, words, *_coefficients(stage, Harmonics(quantity, "cos", few.constant, rows)), after)


def _result(request: Request, outcome: Harmonics, subject: Formula, via: tuple[Formula, ...]) -> Parts:
    """Return the quantity asked for: in full, or of a long derivation as a list of coefficients."""
    if not request.long:
        return (_equation(request, outcome, subject, via),)
    words = "with, to two terms of each (the dots stand for higher powers, of the same sign),"
    parts: Parts = (_long_equation(request, subject, via), prose(words))
    if request.last_order > LONGEST_IN_FULL:
        more = f"Above order {LONGEST_IN_FULL} the fractions are left as the general term gives them."
        return (*parts, *_coefficients(request, outcome), prose(more))
    return (*parts, *_coefficients(request, outcome))


# In full ----------------------------------------------------------------------------------------


def _equation(
    request: Request, outcome: Harmonics, subject: Formula, via: tuple[Formula, ...]
) -> Equation:
    terms = [signed(sign, term) for sign, term in monomials(outcome.constant, request.convention)]
    terms += [
        _term(request, harmonic(outcome.function, n), series) for n, series in outcome.terms.items()
    ]
    return Equation(subject, (*(("=", each) for each in via), ("≈", _in_units(request, terms))))


def _term(request: Request, angle: Formula, series: Series) -> Formula:
    """Return coefficient times harmonic, with the sign that all terms of the coefficient share."""
    rows = list(monomials(series, request.convention))
    sign, first = rows[0]
    if len(rows) > 1:
        return signed(sign, Sum(tuple(term for _, term in rows)) * angle)
    return signed(sign, angle if first == number(1) else first * angle)


def _in_units(request: Request, terms: list[Formula]) -> Formula:
    inside = terms[0] if len(terms) == 1 else Sum(tuple(terms))
    return inside if request.rod_angle else request.unit() * inside


# Shortened --------------------------------------------------------------------------------------


def _long_equation(request: Request, subject: Formula, via: tuple[Formula, ...]) -> Equation:
    """Return quantity = unit (first terms + ... + last term) with lettered coefficients."""
    letter, sign = LETTER[request.quantity], -1 if request.quantity == "displacement" else 1
    function = "sin" if request.quantity in ("velocity", "rod-angle") else "cos"
    rows: list[Formula] = []
    for n in request.orders():
        wave: Formula = harmonic(function, n)
        rows.append(signed(sign, _letter(letter, n) * wave if n > 1 or request.rod_angle else wave))
    if request.quantity == "displacement":
        rows.insert(0, _letter("B", 0))
    opening = _OPENING[request.quantity]
    if len(rows) > opening + 2:
        rows = [*rows[:opening], signed(sign, Dots()), rows[-1]]
    return Equation(subject, (*(("=", each) for each in via), ("≈", _in_units(request, rows))))


def _letter(letter: str, n: int) -> Subscript:
    return Subscript(Name(letter), number(n))


def _coefficients(request: Request, outcome: Harmonics) -> list[Equation]:
    """Return one line per coefficient."""
    rows: list[Equation] = []
    if request.quantity == "displacement":
        constant = list(monomials(outcome.constant, request.convention))[:2]
        rows.append(_coefficient(_letter("B", 0), constant))
    sense = -1 if request.quantity == "displacement" else 1
    for n, series in outcome.terms.items():
        if n > 1 or request.rod_angle:
            long = n > LONGEST_IN_FULL
            terms = _closed(request, n, series) if long else monomials(series, request.convention)
            pairs = [(sense * sign, term) for sign, term in terms]
            rows.append(_coefficient(_letter(LETTER[request.quantity], n), pairs))
    return rows


def _coefficient(subject: Formula, terms: Sequence[tuple[int, Formula]]) -> Equation:
    """Return the terms with their signs, and dots after them that have the sign of the last."""
    return equal(subject, Sum(tuple(signed(*term) for term in [*terms, (terms[-1][0], Dots())])))


def _closed(request: Request, n: int, series: Series) -> list[tuple[int, Formula]]:
    """Return the terms of a coefficient by their general term, its numbers put in."""
    write = _closed_angle_term if request.rod_angle else _closed_piston_term
    return [(1 if c > 0 else -1, write(request, n, power)) for power, c in sorted(series.terms.items())]


def _closed_piston_term(request: Request, n: int, power: int) -> Formula:
    """Return 8 k^2 C(2j, j) C(2j, j-k) rho^(2j-1)/((2j - 1) 16^j), n = 2k, integrated."""
    k, j = n // 2, (power + 1) // 2
    weight = {"displacement": 2, "velocity": 4 * k}.get(request.quantity, 8 * k * k)
    over = [number(weight), binomial(2 * j, j), *([binomial(2 * j, j - k)] if j > k else [])]
    return general_term(request, over, [number(2 * j - 1), number(16) ** j], power)


def _closed_angle_term(request: Request, n: int, power: int) -> Formula:
    """Return C(2j, j) C(2j+1, j-i) rho^(2j+1)/((2j + 1) 16^j), n = 2i+1."""
    i, j = n // 2, power // 2
    over = [binomial(2 * j, j), *([binomial(power, j - i)] if j > i else [])]
    return general_term(request, over, [number(power), number(16) ** j], power)
