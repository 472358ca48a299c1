"""Numbers of integrals, extrema, products and special functions straight from their trees.

They are witnesses where a construct has no form: an integral by quadrature to 25 digits, the largest
value over a turn by a grid and a golden section. What they cannot vouch for has no number.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from symbalance.document import formula
from symbalance.notes.algebra.domain import NoFormError

if TYPE_CHECKING:
    from symbalance.notes.algebra.tree_values import TreeValues

MOST_FACTORS = 2000
COST_OF_QUADRATURE = 500
"""Terms that an integral counts as: two side by side are computed, one within another is not."""
GRID = 192
"""Points over a turn: harmonics to the 40th have several of them between two extrema."""
SECTIONS = 100
MOST_AREAS = 500
"""Integrals that are kept, of each thread."""


class _Areas(threading.local):
    """Integrals at the points tried last: these are the same for every relation of a page.

    Each thread has its own, as its numbers belong to its own mpmath context.
    """

    def __init__(self) -> None:
        self.values: dict[Any, Any] = {}


AREAS = _Areas()


def _integral(at: TreeValues, node: formula.Integral) -> Any:
    if node.lower is None or node.upper is None:
        raise NoFormError("an integral without bounds")
    at.terms += COST_OF_QUADRATURE
    nested = any(isinstance(part, formula.Integral) for part in formula.walk(node.body))
    if nested or at.terms > 4 * COST_OF_QUADRATURE:
        raise NoFormError("integrals within integrals")
    _refuse_moving(at, node.body, node.variable.name)
    lower, upper = at.value(node.lower), at.value(node.upper)
    if lower.imag or upper.imag:
        raise NoFormError("an integral between bounds that are not real")

    others = sorted(formula.names(node.body) - {node.variable.name} - at.bound)
    key = (node, at.mp.prec, lower, upper, tuple((name, at.letter(name)) for name in others))
    areas = AREAS.values
    if not at.bound and key in areas:
        return areas[key]

    def integrand(x: Any) -> Any:
        return at.with_letter(node.variable.name, x).value(node.body)

    pieces = max(1, min(8, int(abs(upper.real - lower.real) / 2)))
    step = (upper.real - lower.real) / pieces
    corners = [lower.real + k * step for k in range(pieces)] + [upper.real]
    total, error = at.mp.quad(integrand, corners, error=True)
    if error > at.mp.mpf(10) ** -28 * (1 + abs(total)):
        raise NoFormError("an integral that does not settle")
    if len(areas) >= MOST_AREAS:
        areas.clear()
    if not at.bound:
        areas[key] = total
    return total


def _refuse_moving(at: TreeValues, body: formula.Formula, variable: str) -> None:
    """Refuse letters of which it is not known that they do not change with the one bound."""
    meaning = at.meaning
    times = {time for time, rates in meaning.rates.items() if variable in rates}
    angles = {angle for rates in meaning.rates.values() for angle in rates}
    waiting, met = sorted(formula.names(body) - {variable}), {variable}
    while waiting:
        name = waiting.pop()
        if name in met or name in at.bound:
            continue
        met.add(name)
        moves = name in times or variable in formula.names(meaning.known.get(name, formula.number(0)))
        if moves and name not in meaning.values:
            raise NoFormError(f"{name} changes with {variable}")
        if name in meaning.known:
            waiting.extend(sorted(formula.names(meaning.known[name])))
        elif name not in meaning.constant | meaning.integer | angles and name not in meaning.values:
            raise NoFormError(f"{name} may change with {variable}, and nothing says how")


def _evaluation(at: TreeValues, node: formula.Evaluation) -> Any:
    if not node.variable.name:
        raise NoFormError("a bar that does not say in which letter it is taken")
    held = (formula.Derivative, formula.Integral)
    if any(isinstance(part, held) for part in formula.walk(node.expression)):
        raise NoFormError("a derivative at a place")
    _refuse_moving(at, node.expression, node.variable.name)
    upper = at.with_letter(node.variable.name, at.value(node.upper)).value(node.expression)
    if node.lower is None:
        return upper
    return upper - at.with_letter(node.variable.name, at.value(node.lower)).value(node.expression)


def _limit(at: TreeValues, node: formula.Limit) -> Any:
    raise NoFormError("a limit that its series does not give")


def _extremum(at: TreeValues, node: formula.Extremum) -> Any:
    """Return the largest value over a turn; of a function with another period it has no number."""
    name = node.variable.name
    if not name:
        raise NoFormError("an extremum that does not say in which letter it is taken")
    at.terms += COST_OF_QUADRATURE
    if at.terms > 4 * COST_OF_QUADRATURE:
        raise NoFormError("extrema within extrema")
    _refuse_moving(at, node.body, name)
    sign = 1 if node.function == "max" else -1

    def height(x: Any) -> Any:
        size = at.with_letter(name, x).value(node.body)
        if abs(size.imag) > at.mp.mpf(10) ** -20 * (1 + abs(size)):
            raise NoFormError("an extremum of what is not real")
        return sign * size.real

    turn = 2 * at.mp.pi
    if abs(height(at.mp.mpf("0.3")) - height(at.mp.mpf("0.3") + turn)) > at.mp.mpf(10) ** -25:
        raise NoFormError("an extremum of what does not repeat after a turn")
    grid = [turn * k / GRID for k in range(GRID)]
    heights = [height(x) for x in grid]
    best = max(range(GRID), key=lambda k: heights[k])
    return sign * _golden_section(height, grid[best] - turn / GRID, grid[best] + turn / GRID, at.mp)


def _golden_section(height: Callable[[Any], Any], left: Any, right: Any, mp: Any) -> Any:
    ratio = (mp.sqrt(5) - 1) / 2
    inner, outer = right - ratio * (right - left), left + ratio * (right - left)
    low, high = height(inner), height(outer)
    for _ in range(SECTIONS):
        if low > high:
            right, outer, high = outer, inner, low
            inner = right - ratio * (right - left)
            low = height(inner)
        else:
            left, inner, low = inner, outer, high
            outer = left + ratio * (right - left)
            high = height(outer)
    return max(low, high)


def _indexed_product(at: TreeValues, node: formula.IndexedProduct) -> Any:
    lower, upper = (int(at.value(bound).real) for bound in (node.lower, node.upper))
    at.terms += max(upper - lower, 0)
    if at.terms > MOST_FACTORS:
        raise NoFormError("a long product")
    total = at.mp.mpc(1)
    for k in range(lower, upper + 1):
        total *= at.with_letter(node.index.name, at.mp.mpf(k)).value(node.body)
    return total


def _plus_minus(at: TreeValues, node: formula.PlusMinus) -> Any:
    raise NoFormError("both signs at once")


def _cases(at: TreeValues, node: formula.Cases) -> Any:
    for value, condition in zip(node.values, node.conditions, strict=True):
        if condition is None:
            return at.value(value)
        left, sign, right = at.value(condition[0]), condition[1], at.value(condition[2])
        gap = (left - right).real
        same = abs(left - right) < at.mp.mpf(10) ** -25
        if {"=": same, "≠": not same, "<": gap < 0, ">": gap > 0, "≤": gap <= 0, "≥": gap >= 0}.get(sign):
            return at.value(value)
    raise NoFormError("cases of which none holds")


def _apply(at: TreeValues, node: formula.Apply) -> Any:
    if node.function not in _APPLIED:
        raise NoFormError(f"the function {node.function}")
    return _APPLIED[node.function](at.mp, *map(at.value, node.arguments))


def _whole(number: Any) -> Any:
    return int(number.real) if number.real == int(number.real) and not number.imag else number


def _largest(sign: int) -> Callable[..., Any]:
    def function(mp: Any, *numbers: Any) -> Any:
        if any(number.imag for number in numbers):
            raise NoFormError("the largest of what is not real")
        return sign * max(sign * number.real for number in numbers)

    return function


_APPLIED: dict[str, Callable[..., Any]] = {
    "factorial": lambda mp, n: mp.factorial(n),
    "binomial": lambda mp, n, k: mp.binomial(_whole(n), _whole(k)),
    "kronecker": lambda mp, m, n: mp.mpf(1 if m == n else 0),
    "besselj": lambda mp, n, z: mp.besselj(_whole(n), z),
    "max": _largest(1),
    "min": _largest(-1),
}

CONSTRUCTS: dict[type, Callable[[Any, Any], Any]] = {
    formula.Integral: _integral,
    formula.Evaluation: _evaluation,
    formula.Limit: _limit,
    formula.Extremum: _extremum,
    formula.IndexedProduct: _indexed_product,
    formula.PlusMinus: _plus_minus,
    formula.Cases: _cases,
    formula.Apply: _apply,
}
"""A function for each construct, of the values at a point and the construct's node."""
