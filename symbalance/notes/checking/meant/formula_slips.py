"""By which one slip a formula differs from the standard one: a factor, an exponent, a sine for a cosine.

Two formulas are compared by their values at a few points; what differs by more than one slip has none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from math import isclose, isfinite, log2, pi

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.letter_roles import renamed

POINTS = ((3, 7, 11, 13, 17, 26, 9), (5, 2, 19, 23, 29, 14, 33), (31, 37, 41, 43, 47, 8, 21))
"""Values of a formula's letters at which two formulas are compared, in tenths."""
SMALL = ((31, 17, 7, 11, 23, 37, 5), (13, 29, 41, 3, 19, 9, 27), (8, 5, 21, 37, 33, 12, 17))
"""The same in hundredths, for formulas that have no value elsewhere: √(1 - D²)."""
FALLING = ((43, 37, 29, 5, 2, 9, 6), (31, 23, 19, 7, 3, 8, 5), (17, 13, 11, 4, 1, 6, 9))
"""Values in tenths for formulas that need the first letters to be large: √(n² - sin² θ)."""
_EXACT, _FAR = 1e-9, 1e-3
_FACTORS = frozenset({1, 2, 3, 4, 6, 8, 9, 16, 32, 64})
"""Numerators and denominators of a factor that is a slip: 5, 12, 60, 1000 may be a change of units."""
_TURNING = ("sin", "cos", "tan")
_EXPONENTS = (1, 2, 3, 4)


def agrees(target: Formula, claim: Formula) -> bool:
    """Tell whether two formulas have the same values."""
    if _ratio_of(target, claim) == (1.0,) * len(POINTS):
        return True
    if _ratio_of(target, claim, SMALL, 100) == (1.0,) * len(SMALL):
        return True
    return _ratio_of(target, claim, FALLING) == (1.0,) * len(FALLING)


def differs(target: Formula, claim: Formula) -> bool:
    """Tell whether two formulas have different values where both have any."""
    ratios = (*_ratio_of(target, claim), *_ratio_of(target, claim, SMALL, 100))
    finite = [ratio for ratio in ratios if isfinite(ratio)]
    return bool(finite) and all(not isclose(ratio, 1, rel_tol=_FAR) for ratio in finite)


def value_at(node: Formula, point: Mapping[str, Fraction]) -> float:
    """Return a formula's value at a point; NaN where it has none."""
    try:
        value = TreeValues(SymbolValue(), dict(point)).value(node)
    except NO_VALUE:
        return float("nan")
    return float(value.real) if abs(value.imag) <= _EXACT * abs(value) else float("nan")


def _points(
    letters: list[str], rows: tuple[tuple[int, ...], ...], unit: int
) -> list[dict[str, Fraction]]:
    return [{n: Fraction(row[k], unit) for k, n in enumerate(letters)} for row in rows]


def _ratio_of(
    target: Formula, claim: Formula, rows: tuple[tuple[int, ...], ...] = POINTS, unit: int = 10
) -> tuple[float, ...]:
    """Return the claim over the target at each point, 1.0 where they agree to the last digits."""
    letters = sorted(names(target) | names(claim))
    ratios = []
    for point in _points(letters, rows, unit):
        below = value_at(target, point)
        ratio = value_at(claim, point) / below if below else float("nan")
        ratios.append(1.0 if isclose(ratio, 1, rel_tol=_EXACT) else ratio)
    return tuple(ratios)


def slip_of(target: Formula, claim: Formula, slips: tuple[str, ...], may_be_part: bool) -> str:
    """Return the kind of the one slip by which a claim differs from a formula; "" for none."""
    ratios = _ratio_of(target, claim)
    if not _is_finite(ratios):
        ratios = _ratio_of(target, claim, SMALL, 100)
    if not _is_finite(ratios):
        ratios = _ratio_of(target, claim, FALLING)
    is_finite = _is_finite(ratios)
    if is_finite and all(isclose(ratio, ratios[0], rel_tol=_EXACT) for ratio in ratios):
        return _slip_by_factor(target, ratios[0], slips, may_be_part)
    changes = {
        "one change": ("edit", lambda: any(agrees(each, claim) for each in single_edits(target))),
        "factor of a term": ("term", lambda: any(agrees(e, claim) for e in _without_a_number(target))),
        "exchange": ("exchange", lambda: _is_any_exchange(target, claim)),
    }
    if any(agrees(each, claim) for each in with_one_part_changed(target, _powers_otherwise)):
        return "powers of a sum"
    if changed := next((k for k, (allowed, test) in changes.items() if allowed in slips and test()), ""):
        return changed
    if not is_finite:
        return "term" if "term" in slips else ""  # σ² - 3 τ² below a root
    letters = sorted(names(claim))
    tests = {
        "root missing": ("root", lambda: agrees(_with_roots(target, lambda node: node), claim)),
        "fraction inverted": ("root", lambda: agrees(_with_roots(target, _inverse_root), claim)),
        "exponent": ("power", lambda: _is_other_power(target, claim, letters)),
        "sign": ("minus", lambda: _is_sum_for_difference(target, claim)),
    }
    for kind, (allowed, test) in tests.items():
        if allowed in slips and test():
            return kind
    is_another = "any" in slips and is_finite and not agrees(Negative(target), claim)
    loose = ("another formula",) if is_another else ("term", "power of a term")
    return next((kind for kind in loose if is_another or kind in slips), "")


def _is_finite(ratios: tuple[float, ...]) -> bool:
    return all(isfinite(ratio) and ratio for ratio in ratios)


def _slip_by_factor(target: Formula, ratio: float, slips: tuple[str, ...], may_be_part: bool) -> str:
    """Return the kind of a slip that is a factor; "" where that may be right."""
    if ratio <= 0 or ratio == 1:
        return ""
    if "turn" in slips and any(isclose(ratio, (2 * pi) ** n, rel_tol=_EXACT) for n in (1, -1, 2, -2)):
        return "factor 2π"
    is_told = "bare factor" in slips or ("factor" in slips and _has_number(target))
    is_slip = _is_slip_factor(ratio) or ("any" in slips and _is_slip_factor(ratio**2))
    return "factor" if is_told and not may_be_part and is_slip else ""


def _inverse_root(radicand: Formula) -> Formula:
    return Call("sqrt", 1 / radicand)


def _with_roots(node: Formula, change: Callable[[Formula], Formula]) -> Formula:
    """Return a formula with each of its roots made another formula of what is below it."""
    if isinstance(node, Call) and node.function == "sqrt":
        return change(node.argument)
    parts = children(node)
    return with_children(node, tuple(_with_roots(part, change) for part in parts)) if parts else node


def _has_number(node: Formula) -> bool:
    """Tell whether a formula has a factor of its own: 32/π of 32 M/(π d³), none of M/W."""
    values = {name: Number(Fraction(1)) for name in names(node)}
    for name, value in values.items():
        node = substitute(node, name, value)
    return not isclose(value_at(node, {}), 1)


def _is_slip_factor(ratio: float) -> bool:
    """Tell whether a factor is one that is forgotten or taken from a neighbouring formula: ½, 4, π."""
    for factor in (1.0, pi, 1 / pi):
        value = ratio / factor
        near = Fraction(value).limit_denominator(64)
        if near and isclose(float(near), value, rel_tol=_EXACT):
            return {near.numerator, near.denominator} <= _FACTORS
    return False


def _is_other_power(target: Formula, claim: Formula, letters: list[str]) -> bool:
    """Tell whether a claim has another exponent at one letter, or two letters exchanged."""
    quotient = claim / target
    exponents: dict[str, float] = {}
    for letter in letters:
        doubled = substitute(quotient, letter, 2 * Name(letter))
        steps = [ratio for ratio in _ratio_of(quotient, doubled) if isfinite(ratio) and ratio > 0]
        if len(steps) != len(POINTS) or not all(isclose(s, steps[0], rel_tol=_EXACT) for s in steps):
            return False
        exponent = log2(steps[0])
        if abs(exponent) > _EXACT:
            exponents[letter] = exponent
    halves = {letter: round(2 * exponent) for letter, exponent in exponents.items()}
    if not halves or any(abs(e) > 4 for e in halves.values()):
        return False
    rest = quotient
    for letter, half in halves.items():
        rest = rest / Name(letter) ** Fraction(half, 2)
    if not agrees(Number(Fraction(1)), rest):
        return False
    is_exchange = len(halves) == 2 and not sum(halves.values())
    return len(halves) == 1 or (is_exchange and _is_exchanged(target, claim, [*halves]))


def _is_exchanged(target: Formula, claim: Formula, pair: list[str]) -> bool:
    return agrees(renamed(target, {pair[0]: pair[1], pair[1]: pair[0]}), claim)


def _is_sum_for_difference(target: Formula, claim: Formula) -> bool:
    """Tell whether a claim has the other sign at one of its letters: (ω₁ + ω₂)/ω."""
    return any(agrees(target, substitute(claim, n, -Name(n))) for n in sorted(names(claim)))


def _is_any_exchange(target: Formula, claim: Formula) -> bool:
    letters = sorted(names(target))
    pairs = [(a, b) for k, a in enumerate(letters) for b in letters[k + 1 :]]
    return any(_is_exchanged(target, claim, [*pair]) for pair in pairs)


def factor_of(target: Formula, claim: Formula) -> Fraction | None:
    """Return the number by which a formula differs from another one; None where none does."""
    letters = sorted(names(target) | names(claim))
    values = [
        (value_at(target, point), value_at(claim, point))
        for rows, unit in ((POINTS, 10), (SMALL, 100), (FALLING, 10))
        for point in _points(letters, rows, unit)
    ]
    ratios = [claimed / own for own, claimed in values if own and isfinite(own) and isfinite(claimed)]
    if not ratios or not all(isclose(each, ratios[0], rel_tol=_EXACT) for each in ratios):
        return None
    factor = Fraction(ratios[0]).limit_denominator(10**9)
    factor = factor if factor else 1 / Fraction(1 / ratios[0]).limit_denominator(10**9)
    return factor if isclose(float(factor), ratios[0], rel_tol=_EXACT) else None


def is_multiple(target: Formula, claim: Formula) -> bool:
    """Tell whether a formula is another one with a factor."""
    ratios = _ratio_of(target, claim)
    return isfinite(ratios[0]) and all(isclose(each, ratios[0], rel_tol=_EXACT) for each in ratios)


def with_one_part_changed(
    node: Formula, changes: Callable[[Formula], Iterable[Formula]]
) -> Iterator[Formula]:
    """Yield a formula with one of its parts, or itself, changed into each of what `changes` gives."""
    yield from changes(node)
    parts = children(node)
    for k, part in enumerate(parts):
        for changed in with_one_part_changed(part, changes):
            yield with_children(node, (*parts[:k], changed, *parts[k + 1 :]))


def _without_a_number(node: Formula) -> Iterator[Formula]:
    """Yield a formula with one of its numbers left out: σ² + τ² for σ² + 3 τ²."""
    return with_one_part_changed(node, _product_without_a_number)


def _powers_otherwise(node: Formula) -> Iterator[Formula]:
    """Yield a sum of equal powers with another one, or taken before: (D - d)⁴ and D³ - d³ for D⁴ - d⁴."""
    terms = node.terms if isinstance(node, Sum) else ()
    powers = [term.operand if isinstance(term, Negative) else term for term in terms]
    exponents = {part.exponent for part in powers if isinstance(part, Power)}
    if len(exponents) != 1 or not all(isinstance(part, Power) for part in powers):
        return
    (exponent,) = exponents
    bases = [part.base for part in powers if isinstance(part, Power)]

    def with_signs(parts: list[Formula]) -> Formula:
        pairs = zip(terms, parts, strict=True)
        return Sum(tuple(Negative(p) if isinstance(term, Negative) else p for term, p in pairs))

    yield with_signs(bases) ** exponent
    for other in _EXPONENTS:
        if Number(Fraction(other)) != exponent:
            yield with_signs([base ** Fraction(other) for base in bases])


def _product_without_a_number(node: Formula) -> Iterator[Formula]:
    factors = node.factors if isinstance(node, Product) else ()
    for number in (factor for factor in factors if isinstance(factor, Number)):
        yield Product(tuple(factor for factor in factors if factor is not number))


def single_edits(node: Formula) -> Iterator[Formula]:
    """Yield a formula with one thing in it changed: a function, an exponent, a sign or a number."""
    return with_one_part_changed(node, _edits_here)


def _edits_here(node: Formula) -> Iterator[Formula]:
    match node:
        case Call(function=function, argument=argument) if function in _TURNING:
            yield from (Call(other, argument) for other in _TURNING if other != function)
        case Quotient(numerator=above, denominator=below) if any(
            isinstance(part, Call) and part.function in _TURNING for part in walk(below)
        ):
            yield above * below
        case Product(factors=factors) if any(isinstance(part, Call) for part in factors):
            waves = [part for part in factors if isinstance(part, Call)]
            for wave in waves:
                rest = Product(tuple(f for f in factors if f is not wave))
                yield from (rest, rest / wave) if wave.function in _TURNING else (rest,)
        case Power(base=base, exponent=Number(value=value)) if value in _EXPONENTS:
            yield from (base ** Fraction(other) for other in _EXPONENTS if other != value)
        case Sum(terms=terms):
            for k in range(1, len(terms)):
                yield Sum((*terms[:k], Negative(terms[k]), *terms[k + 1 :]))
        case Number(value=value) if value not in (0, 1):
            yield from (Number(value * 2), Number(value / 2))
