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
from symbalance.kinematics.derivation.setting import (
    LONGEST_IN_FULL,
    OMEGA,
    PHI,
    THETA,
    M,
    Setting,
    Step,
    X,
    closed,
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


def collection_steps(setting: Setting, found: Harmonics) -> tuple[Step, ...]:
    """Return the step that collects the harmonics and, where asked for, their derivatives."""
    if setting.quantity not in _TITLES:
        left = PHI if setting.rod_angle else X
        parts = _result(setting, found, left, ())
        return (Step("Collected harmonics", (*_beyond(setting), *parts)),)
    before = Step("Collected harmonics", (*_beyond(setting), *_stage("displacement", setting, X, (), 3)))
    return before, Step(_TITLES[setting.quantity], _derivatives(setting, found))


def _derivatives(setting: Setting, found: Harmonics) -> Parts:
    """Return v = omega dx/d theta, a = omega dv/d theta and F = m a, as far as asked for."""
    words = prose("The crank turns at the constant speed ", equal(OMEGA, Derivative(THETA, T)), ":")
    to_v = (Derivative(X, T), OMEGA * Derivative(X, THETA))
    to_a = (Derivative(V, T), OMEGA * Derivative(V, THETA))
    if setting.quantity == "velocity":
        return words, *_result(setting, found, V, to_v)
    velocity = _stage("velocity", setting, V, to_v, 0)
    if setting.quantity == "acceleration":
        return words, *velocity, *_result(setting, found, A, to_a)
    mass = prose(
        "The reciprocating mass ", M, " answers with the inertia force ", F, " on the engine,"
        " positive away from the crank:"
    )  # fmt: skip
    acceleration = _stage("acceleration", setting, A, to_a, 0)
    return words, *velocity, *acceleration, mass, *_result(setting, found, F, (M * A,))


def _beyond(setting: Setting) -> Parts:
    """Return what becomes of harmonics above the order asked for, where powers bring some."""
    if setting.last <= setting.order:
        return ()
    return (prose(f"The harmonics above order {setting.order} are left out from here on."),)


def _stage(
    quantity: str, setting: Setting, left: Formula, via: tuple[Formula, ...], listed: int
) -> Parts:
    """Return an intermediate quantity: in full, or of a long derivation with `listed` coefficients."""
    stage = Setting(quantity, setting.order, setting.power, setting.convention)
    if not setting.long:
        return (_equation(stage, harmonics(quantity, stage.order, stage.power), left, via),)
    equation = _long_equation(stage, left, via)
    if not listed:
        return (equation,)
    few = harmonics(quantity, min(stage.order, 2 * listed), min(stage.power, 2 * listed + 1))
    rows = {n: Series(dict(sorted(s.terms.items())[:2]), s.through) for n, s in few.terms.items()}
    words = prose("with coefficients whose first terms are")
    after = prose("and so on; the last step has their general term.")
    return (equation, words, *_coefficients(stage, Harmonics(quantity, "cos", few.constant, rows)), after)


def _result(setting: Setting, found: Harmonics, left: Formula, via: tuple[Formula, ...]) -> Parts:
    """Return the quantity asked for: in full, or of a long derivation as a list of coefficients."""
    if not setting.long:
        return (_equation(setting, found, left, via),)
    words = "with, to two terms of each (the dots stand for higher powers, of the same sign),"
    parts: Parts = (_long_equation(setting, left, via), prose(words))
    if setting.last_order > LONGEST_IN_FULL:
        more = f"Above order {LONGEST_IN_FULL} the fractions are left as the general term gives them."
        return (*parts, *_coefficients(setting, found), prose(more))
    return (*parts, *_coefficients(setting, found))


# In full ----------------------------------------------------------------------------------------


def _equation(setting: Setting, found: Harmonics, left: Formula, via: tuple[Formula, ...]) -> Equation:
    terms = [signed(sign, term) for sign, term in monomials(found.constant, setting.convention)]
    terms += [_term(setting, harmonic(found.function, n), series) for n, series in found.terms.items()]
    return Equation(left, (*(("=", each) for each in via), ("≈", _in_units(setting, terms))))


def _term(setting: Setting, angle: Formula, series: Series) -> Formula:
    """Return coefficient times harmonic, with the sign that all terms of the coefficient share."""
    rows = list(monomials(series, setting.convention))
    sign, first = rows[0]
    if len(rows) > 1:
        return signed(sign, Sum(tuple(term for _, term in rows)) * angle)
    return signed(sign, angle if first == number(1) else first * angle)


def _in_units(setting: Setting, terms: list[Formula]) -> Formula:
    inside = terms[0] if len(terms) == 1 else Sum(tuple(terms))
    return inside if setting.rod_angle else setting.unit() * inside


# Shortened --------------------------------------------------------------------------------------


def _long_equation(setting: Setting, left: Formula, via: tuple[Formula, ...]) -> Equation:
    """Return quantity = unit (first terms + ... + last term) with lettered coefficients."""
    letter, sign = LETTER[setting.quantity], -1 if setting.quantity == "displacement" else 1
    function = "sin" if setting.quantity in ("velocity", "rod-angle") else "cos"
    rows: list[Formula] = []
    for n in setting.orders():
        wave: Formula = harmonic(function, n)
        rows.append(signed(sign, _letter(letter, n) * wave if n > 1 or setting.rod_angle else wave))
    if setting.quantity == "displacement":
        rows.insert(0, _letter("B", 0))
    opening = _OPENING[setting.quantity]
    if len(rows) > opening + 2:
        rows = [*rows[:opening], signed(sign, Dots()), rows[-1]]
    return Equation(left, (*(("=", each) for each in via), ("≈", _in_units(setting, rows))))


def _letter(letter: str, n: int) -> Subscript:
    return Subscript(Name(letter), number(n))


def _coefficients(setting: Setting, found: Harmonics) -> list[Equation]:
    """Return one line per coefficient."""
    rows: list[Equation] = []
    if setting.quantity == "displacement":
        constant = list(monomials(found.constant, setting.convention))[:2]
        rows.append(_coefficient(_letter("B", 0), constant))
    turned = -1 if setting.quantity == "displacement" else 1
    for n, series in found.terms.items():
        if n > 1 or setting.rod_angle:
            long = n > LONGEST_IN_FULL
            terms = _closed(setting, n, series) if long else monomials(series, setting.convention)
            pairs = [(turned * sign, term) for sign, term in terms]
            rows.append(_coefficient(_letter(LETTER[setting.quantity], n), pairs))
    return rows


def _coefficient(left: Formula, terms: Sequence[tuple[int, Formula]]) -> Equation:
    """Return the terms with their signs, and dots after them that have the sign of the last."""
    return equal(left, Sum(tuple(signed(*term) for term in [*terms, (terms[-1][0], Dots())])))


def _closed(setting: Setting, n: int, series: Series) -> list[tuple[int, Formula]]:
    """Return the terms of a coefficient by their general term, its numbers put in."""
    write = _closed_angle_term if setting.rod_angle else _closed_piston_term
    return [(1 if c > 0 else -1, write(setting, n, power)) for power, c in sorted(series.terms.items())]


def _closed_piston_term(setting: Setting, n: int, power: int) -> Formula:
    """Return 8 k^2 C(2j, j) C(2j, j-k) rho^(2j-1)/((2j - 1) 16^j), n = 2k, integrated."""
    k, j = n // 2, (power + 1) // 2
    weight = {"displacement": 2, "velocity": 4 * k}.get(setting.quantity, 8 * k * k)
    over = [number(weight), binomial(2 * j, j), *([binomial(2 * j, j - k)] if j > k else [])]
    return closed(setting, over, [number(2 * j - 1), number(16) ** j], power)


def _closed_angle_term(setting: Setting, n: int, power: int) -> Formula:
    """Return C(2j, j) C(2j+1, j-i) rho^(2j+1)/((2j + 1) 16^j), n = 2i+1."""
    i, j = n // 2, power // 2
    over = [binomial(2 * j, j), *([binomial(power, j - i)] if j > i else [])]
    return closed(setting, over, [number(power), number(16) ** j], power)
