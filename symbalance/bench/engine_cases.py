"""Errors of forces, couples and accelerations of whole engines: near and far angles, float32, a grid."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from symbalance.bench.bounded_cases import (
    OF_AMPLITUDE,
    ULP,
    BoundedCase,
    Part,
    attempt,
    worst,
    worst_point,
)
from symbalance.bench.hard_angles import hard, random_angles
from symbalance.bench.output_requests import AIM, OutputRequest, on_target, targets
from symbalance.bench.timing import progress
from symbalance.bench.true_values import Points, U, mp
from symbalance.codegen import OUTPUTS
from symbalance.engine.builders import from_firing_order, inline, vee
from symbalance.engine.catalogue import load, presets
from symbalance.engine.engine import Engine

FLOAT32 = 4.0
U32 = 2.0**-24
"""Half an ulp of 1 in float32."""
REAL = Fraction(7, 2)
FAR = (1e7, 1e9, 1e12, 1e15)
QUICK = ("inline-4", "inline-5", "radial-7", "v6-90", "v12-60", "boxer-4")
KINDS = ("force", "couple")
NEAR_INTRODUCTION = """\
Every force and couple that does not vanish, and the piston's acceleration, in u of the amplitude of the
output itself; the row is the one nearest to what its function states (`rounding`). 4 u are aimed at.
naive: the harmonics as cos(nθ), nθ rounded; the sum over the cylinders."""
FAR_INTRODUCTION = """\
Beyond 2^20 rad every value rests on the library's cos θ and sin θ, raised to the step s of the output's
orders: the bound is 4 + s times what is stated for near angles, as in the self-tests of the generated
sources."""
SMALL_INTRODUCTION = """\
Many cylinders leave only high orders, many powers of 1/λ down: u is of the amplitude that remains,
named with each. The bound is what the function itself states (`rounding`)."""
FLOAT_INTRODUCTION = """\
float32 angles (taken as exact) give float32 values: in units of 2^-24 of the amplitude, the
displacement in float32 ulp of itself. naive: the same sums in float32."""


def requests_of(
    engine: Engine, order: int = 12, tolerance: float | None = None
) -> Iterator[OutputRequest]:
    """Yield an engine's forces and couples that do not vanish, and a piston's acceleration."""
    ratio = engine.ratio or REAL
    for name in OUTPUTS:
        if name.partition(".")[0] in KINDS or name == "piston.acceleration":
            request = OutputRequest(engine, name, ratio, order, tolerance)
            if request.amplitude:
                yield request


def near_part(quick: bool) -> Part:
    """Return the cases of the catalogue's engines for |theta| <= 1e6."""
    points = Points(hard(300 if quick else 10_000))
    cases = []
    for engine in QUICK if quick else with_like_cylinders():
        progress(f"{engine}, near angles")
        for tolerance, words in ((None, "orders to 12"), (0.0, "all orders")):
            cases.append(engine_case(f"{engine}, {words}", load(engine), points, tolerance=tolerance))
    cases += [on_others(points, target, quick) for target in targets() if target != "numpy"]
    return Part("Forces, couples, accelerations, |θ| ≤ 1e6 rad", NEAR_INTRODUCTION, [*cases, on_grid()])


def with_like_cylinders() -> list[str]:
    """Return the catalogue's engines with one kind of cylinder: `true_values` knows no other."""
    return [preset.name for preset in presets() if load(preset.name).has_common_harmonics]


def engine_case(name: str, engine: Engine, points: Points, **orders: Any) -> BoundedCase:
    """Return the worst output of an engine."""
    return attempt(
        name, AIM, OF_AMPLITUDE, lambda: worst(list(output_cases(engine, points, **orders)), name)
    )


def output_cases(engine: Engine, points: Points, **orders: Any) -> Iterator[BoundedCase]:
    """Yield a case for every output."""
    for request in requests_of(engine, **orders):
        yield request.case(request.name, points, request.stated_bound, f"{request.name}: ")


def on_others(points: Points, target: str, quick: bool) -> BoundedCase:
    """Return the worst of some outputs on another target."""
    progress(f"engines on {target}")
    name = f"some outputs, orders to 12, {target}"

    def make() -> BoundedCase:
        cases = []
        for engine, output in SOME[:1] if quick else SOME:
            request = request_of(engine, output)
            function = on_target(request, target)
            cases.append(request.case(name, points, AIM, f"{engine}: ", function))
        return worst(cases, name)

    return attempt(name, AIM, OF_AMPLITUDE, make)


def request_of(preset: str, output: str) -> OutputRequest:
    """Return an output of a preset at its own rod ratio, or at a real engine's, orders to 12."""
    engine = load(preset)
    return OutputRequest(engine, output, engine.ratio or REAL)


def on_grid(points: int = 1441) -> BoundedCase:
    """Return how far off values on a grid are, whose angles 2 pi j/points are exact."""
    request, name = (
        request_of("v6-90", "couple.vertical"),
        f"v6-90, couple.vertical on a grid of {points}",
    )
    with mp.workdps(40):
        turns = [2 * mp.pi * j / points for j in range(points)]
        values = [
            mp.fsum(t.cos * mp.cos(t.order * a) + t.sin * mp.sin(t.order * a) for t in request.terms)
            for a in turns
        ]
        theta = np.array([float(a) for a in turns])

    def make() -> BoundedCase:
        pairs = zip(values, request.evaluator.on_grid(points), strict=True)
        off = np.array([abs(float(true - float(value))) for true, value in pairs])
        return worst_point(name, theta, off / (U * request.amplitude), AIM)

    return attempt(name, AIM, OF_AMPLITUDE, make)


def far_part(quick: bool) -> Part:
    """Return the cases of angles beyond what is reduced exactly."""
    cases = []
    for size in FAR:
        progress(f"angles of {size:g} rad")
        points = Points(random_angles(100 if quick else 2000, 11)[: 50 if quick else 1000] * (size / 1e6))
        cases += [far_case(engine, name, points, size) for engine, name in FAR_OUTPUTS]
    return Part("Far angles, 1e7 to 1e15 rad", FAR_INTRODUCTION, cases)


SOME = (("v6-90", "couple.vertical"), ("inline-4", "force.vertical"), ("radial-7", "force.lateral"))
FAR_OUTPUTS = (("inline-4", "force.vertical"), ("v6-90", "couple.vertical"), ("v12-60", "force.vertical"))


def far_case(engine: str, name: str, points: Points, size: float) -> BoundedCase:
    """Return how far off an output is at far angles, beside its bound there."""
    request = request_of(engine, name)
    title = f"{engine}, {name}, to {size:g} rad"

    def make() -> BoundedCase:
        return request.case(title, points, (4 + request.step) * request.stated_bound)

    return attempt(title, AIM, OF_AMPLITUDE, make)


def high_order_part(quick: bool) -> Part:
    """Return the cases of order 1000 and of 24 cylinders, held to the bound each function states."""
    points = Points(hard(60 if quick else 1500))
    requests = [
        OutputRequest(engine, name, REAL, 48, tolerance)
        for engine, name in twenty_four()
        for tolerance in (None, 0.0)
    ]
    requests += [
        OutputRequest(load(engine), "force.vertical", REAL, 1000)
        for engine in ("inline-4", "inline-1", "v12-60")
    ]
    cases = [case for request in requests for case in request.stated_cases(points)]
    return Part("Order 1000, and 24 cylinders, λ = 3.5", SMALL_INTRODUCTION, cases)


def twenty_four() -> list[tuple[Engine, str]]:
    """Return engines of 24 cylinders, evenly firing or with odd angles, each with outputs."""
    numbers = list(range(1, 25))
    row = inline(numbers, name="24 in line")
    three = [numbers[i::3] for i in range(3)]
    arrow = from_firing_order(numbers, banks=[-60, 0, 60], cylinders=three, name="W24")
    even = vee(60, numbers, name="V24")
    odd = vee("37.5", pins=[f"{360 * i}/7" for i in range(12)], splay="11.25", name="V24, odd angles")
    return [
        (row, "force.vertical"),
        (row, "couple.vertical"),
        (arrow, "force.vertical"),
        (arrow, "couple.lateral"),
        (even, "force.vertical"),
        (even, "couple.vertical"),
        (odd, "force.vertical"),
        (odd, "couple.lateral"),
    ]


def float32_part(quick: bool) -> Part:
    """Return the cases of float32 angles."""
    narrow = hard(200 if quick else 4000).astype(np.float32)
    points = Points(narrow.astype(np.float64))
    rows = SOME[:1] if quick else SOME
    cases = [
        float32_case(engine, name, narrow, points, t)
        for t in targets()
        if t != "c"
        for engine, name in rows
    ]
    return Part(
        "float32 angles to 1e6", FLOAT_INTRODUCTION, [*cases, float32_displacement(narrow, points)]
    )


def float32_case(engine: str, name: str, narrow: Any, points: Points, target: str) -> BoundedCase:
    """Return how far float32 values are off, in 2^-24 of the amplitude."""
    request, title = request_of(engine, name), f"{engine}, {name}, {target}"

    def make() -> BoundedCase:
        truth, size = request.true_values(points), U32 * request.amplitude
        values = request.on(target)(narrow)
        if values.dtype != np.float32:
            raise TypeError(f"gives {values.dtype}")
        naive = {"cos n theta": truth.off(request.naive(narrow)["cos n theta"]) / size}
        return worst_point(title, points.theta, truth.off(values) / size, FLOAT32, "u32", naive)

    return attempt(title, FLOAT32, "u32", make)


def float32_displacement(narrow: Any, points: Points) -> BoundedCase:
    """Return how far float32 displacements are off, in float32 ulp of themselves."""
    request = OutputRequest(inline(throws=[0]), "piston.displacement", REAL, 1)

    def make() -> BoundedCase:
        truth, one = request.true_values(points), np.float32(1)
        ulp = np.spacing(np.abs(truth.high).astype(np.float32)).astype(np.float64)
        lam = np.float32(3.5)
        naive = one - np.cos(narrow) + lam * (one - np.sqrt(one - (np.sin(narrow) / lam) ** 2))
        others = {"1 - cos ...": truth.off(naive) / ulp}
        off = truth.off(request.evaluator(narrow)) / ulp
        return worst_point("displacement", points.theta, off, FLOAT32, "ulp32", others)

    return attempt("displacement", FLOAT32, ULP, make)
