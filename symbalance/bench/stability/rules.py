"""Inputs that are no ordinary angles: not finite, subnormal, other shapes and types; keywords 0 and huge.

Every rule counts the values that break it, and every warning as one more.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from symbalance.bench.stability.angles import random_angles
from symbalance.bench.stability.asked import PARTS, targets
from symbalance.bench.stability.case import WRONG, Case, Part, tried
from symbalance.bench.timing import progress
from symbalance.codegen import to_function
from symbalance.engine.catalogue import load
from symbalance.forces.free_forces import balance

Array = Any
Function = Callable[..., Any]
Rule = Callable[[Function], int]
OUTPUTS = ("force.vertical", "force.lateral", "couple.vertical", "piston.displacement", "piston.velocity")
HUGE = 1e200
NOT_FINITE = (np.inf, -np.inf, np.nan)
COUNT = 20_000
ARRAYS_ONLY = "array-api"
"""The target that takes float64 and float32 arrays of a library, and has no `out`."""
SAYS = """\
NaN stands exactly where θ is not finite, and nowhere else: values beside it are, to the last bit, those
without it. Signed zeros and subnormal angles are ordinary angles. A keyword 0 gives zeros, one whose
product overflows no finite number. A view in any layout, a list, integers and numbers give what the
same float64 array gives, in the shape of θ. What is no real number is refused. No rule may cost a
warning; the array-api target has arrays and no `out`."""


def part(quick: bool) -> Part:
    """Return the cases of every target in memory."""
    count, outputs = (COUNT // 10, OUTPUTS[2:4]) if quick else (COUNT, OUTPUTS)
    rules = [
        (target, name, rule)
        for target in targets()
        if target != "c"
        for name, rule in rules_of(target, count)
    ]
    return Part(
        "Not finite, subnormal, other shapes and types", SAYS, [rule_case(*row, outputs) for row in rules]
    )


def rule_case(target: str, name: str, rule: Rule, outputs: Sequence[str] = OUTPUTS) -> Case:
    """Return how many values break a rule on a target, over some outputs."""
    what = f"{name}, {target}"
    progress(what)

    def make() -> Case:
        broken = {output: wrong(rule, function_of(output, target)) for output in outputs}
        where = ", ".join(output for output, count in broken.items() if count)
        return Case(what, where[:36], float(sum(broken.values())), 0.0, WRONG)

    return tried(what, 0.0, WRONG, make)


@lru_cache
def function_of(output: str, target: str) -> Function:
    """Return ours, compiled where that is done at the first call."""
    function = to_function(balance(load("v6-90"), order=12), 3.5, output, target)
    if target in PARTS:
        for kind in (np.float32, np.float64):
            function(np.zeros(2, kind))
    return function


def wrong(rule: Rule, function: Function) -> int:
    """Return how often a rule is broken, a warning counting as once."""
    with warnings.catch_warnings(record=True) as raised:
        warnings.simplefilter("always")
        return rule(function) + len(raised)


def rules_of(target: str, count: int = COUNT) -> Iterator[tuple[str, Rule]]:
    """Yield what a target has to keep to."""
    theta = random_angles(count, 21)
    for kind in (np.float64, np.float32):
        name = np.dtype(kind).name
        yield (
            f"NaN where θ is not finite alone, {name}",
            lambda f, k=kind: nan_elsewhere(f, theta.astype(k)),
        )
        yield f"the same values beside it, {name}", lambda f, k=kind: changed_beside(f, theta.astype(k))
        yield f"±0, ±5e-324, ±2e-308 as 0, {name}", lambda f, k=kind: far_from_zero(f, k)
        yield f"only what is not finite, {name}", lambda f, k=kind: all_lost(f, k)
        yield f"empty arrays keep their shape, {name}", lambda f, k=kind: empty_changed(f, k)
    yield "views in any layout", lambda f: layouts_changed(f, theta[:360])
    yield "θ itself is left as it is", lambda f: changed_input(f, theta[:99].copy())
    yield "keywords 0 give zeros", lambda f: not_zero(f, theta[:99])
    yield "keywords whose product overflows give no number", lambda f: still_finite(f, theta[:99])
    yield "complex, text and objects are refused", accepted
    if target != ARRAYS_ONLY:
        yield "integers, lists and numbers", other_types_changed
        yield "out= is filled and given back", lambda f: out_wrong(f, theta[:99])


def _marked(theta: Array) -> tuple[Array, Array]:
    """Return angles with some of them lost, and where those are: alone, in a run, and at both ends."""
    lost = np.zeros(theta.size, bool)
    lost[[0, -1, *range(5, theta.size, 997)]] = True
    lost[100:140] = True
    marked = theta.copy()
    marked[lost] = np.resize(np.array(NOT_FINITE, theta.dtype), int(lost.sum()))
    return marked, lost


def nan_elsewhere(function: Function, theta: Array) -> int:
    """Count values that are NaN at a finite angle, or not at another."""
    marked, lost = _marked(theta)
    values = np.asarray(function(marked))
    return int(np.sum(np.isnan(values) != lost)) + (values.dtype != theta.dtype)


def changed_beside(function: Function, theta: Array) -> int:
    """Count values at finite angles that differ in any bit from those of the same angles alone."""
    marked, lost = _marked(theta)
    return differing(np.asarray(function(marked))[~lost], np.asarray(function(theta))[~lost])


def differing(left: Array, right: Array) -> int:
    """Count values that are not the same bits; another shape counts as all."""
    left, right = np.asarray(left), np.asarray(right)
    if left.shape != right.shape or left.dtype != right.dtype:
        return max(left.size, right.size, 1)
    return int(np.sum((left != right) & ~(np.isnan(left) & np.isnan(right))))


def far_from_zero(function: Function, kind: Any) -> int:
    """Count values at tiny angles that are not the value at 0, within 4 units in the last place of 1."""
    tiny = np.finfo(kind).smallest_subnormal
    small = np.finfo(kind).smallest_normal
    values = np.asarray(function(np.array([0.0, -0.0, tiny, -tiny, small, -small], kind)), np.float64)
    size = max(abs(values[0]), 1.0) * float(np.finfo(kind).eps)
    return int(np.sum(~(np.abs(values - values[0]) <= 4 * size)))


def all_lost(function: Function, kind: Any) -> int:
    """Count values that are not NaN where no angle is finite: an array, and single ones."""
    values = [function(np.array(NOT_FINITE, kind)), *(function(np.array([x], kind)) for x in NOT_FINITE)]
    return sum(int(np.sum(~np.isnan(np.asarray(v)))) for v in values)


def empty_changed(function: Function, kind: Any) -> int:
    """Count empty arrays that come back in another shape or type."""
    found = [(shape, np.asarray(function(np.empty(shape, kind)))) for shape in ((0,), (3, 0), (0, 2))]
    return sum(values.shape != shape or values.dtype != kind for shape, values in found)


def layouts_changed(function: Function, theta: Array) -> int:
    """Count values of a view that differ from those of a plain copy."""
    square = theta.reshape(12, 30)
    views = [
        theta[::3],
        theta[::-1],
        np.asfortranarray(square),
        square.T,
        square[2:9, 1::4],
        theta[5],
        square[:, :1],
    ]
    views += [np.broadcast_to(theta[:7], (5, 7)), theta[:8].reshape(2, 2, 2), np.array(theta[9])]
    views += [np.frombuffer(theta.tobytes(), np.float64)]
    copies = [np.array(view, np.float64, order="C") for view in views]
    return sum(
        differing(function(np.asarray(view)), np.asarray(function(copy.reshape(-1))).reshape(copy.shape))
        for view, copy in zip(views, copies, strict=True)
    )


def changed_input(function: Function, theta: Array) -> int:
    """Count angles that a call changes."""
    kept = theta.copy()
    function(theta)
    return differing(theta, kept)


def not_zero(function: Function, theta: Array) -> int:
    """Count values that are not 0 where the mass and the radius are 0."""
    return sum(
        int(np.sum(np.asarray(function(theta, mass=0.0, radius=zero)) != 0)) for zero in (0, 0.0, -0.0)
    )


def still_finite(function: Function, theta: Array) -> int:
    """Count values that look like numbers, and are wrong, where the keywords' product overflows.

    A displacement has a product of one keyword: it stays finite, and right.
    """
    plain = np.asarray(function(theta))
    huge = np.asarray(function(theta, mass=HUGE, radius=HUGE, omega=HUGE, pitch=HUGE))
    right = ~np.isfinite(huge) | (np.abs(huge - plain * HUGE) <= 1e-15 * HUGE)
    return int(np.sum(~(right | (plain == 0))))


def accepted(function: Function) -> int:
    """Count arrays of no real numbers that are not refused with a TypeError."""
    count = 0
    for bad in (np.array([1j]), np.array(["1.0"]), np.array([None])):
        try:
            function(bad)
        except TypeError:
            continue
        count += 1
    return count


def other_types_changed(function: Function) -> int:
    """Count values of integers, truth values, lists and numbers that differ from those of float64."""
    whole = np.arange(-3, 9)
    pairs = [
        (whole, whole.astype(np.float64)),
        (np.arange(7, dtype=np.uint8), np.arange(7.0)),
        (np.array([True, False]), np.array([1.0, 0.0])),
        ([0.5, 1.5], np.array([0.5, 1.5])),
        ([[1, 2], [3, 4]], np.array([[1.0, 2.0], [3.0, 4.0]])),
    ]
    count = sum(differing(function(one), function(other)) for one, other in pairs)
    alone = np.asarray(function(np.array([0.7])))[0]
    return count + sum(float(function(x)) != float(alone) for x in (0.7, np.float64(0.7), np.array(0.7)))


def out_wrong(function: Function, theta: Array) -> int:
    """Count values of `out` that are wrong, results that are not `out`, and wrong `out` not refused."""
    count, plain = 0, function(theta)
    for kind in (np.float64, np.float32):
        out = np.full(theta.shape, 7.0, kind)
        given = function(theta.astype(kind), out=out)
        count += (given is not out) + differing(out, function(theta.astype(kind)))
    for out in (np.empty(3), np.empty(theta.shape, np.float32), np.empty(2 * theta.size)[::2]):
        try:
            function(theta, out=out)
        except ValueError:
            continue
        count += 1
    same = theta.copy()
    return count + differing(function(same, out=same), plain)
