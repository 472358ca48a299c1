"""Forces, couples and accelerations of whole engines: near angles, far angles, float32, a grid."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from symbalance.bench.judge import mp
from symbalance.bench.stability.angles import hard, random_angles
from symbalance.bench.stability.asked import Asked, on_target, targets
from symbalance.bench.stability.case import OF_AMPLITUDE, ULP, Case, Part, largest, measured, tried
from symbalance.bench.stability.truth import Points
from symbalance.bench.timing import progress
from symbalance.codegen import OUTPUTS
from symbalance.engine.builders import from_firing_order, inline, vee
from symbalance.engine.catalogue import load, presets
from symbalance.engine.engine import Engine

NEAR = 4.0
"""What is aimed at for |theta| <= 1e6, in u of the amplitude; NumPy's functions state a little more."""
FLOAT32 = 4.0
U32 = 2.0**-24
REAL = Fraction(7, 2)
FAR = (1e7, 1e9, 1e12, 1e15)
QUICK = ("inline-4", "inline-5", "radial-7", "v6-90", "v12-60", "boxer-4")
KINDS = ("force", "couple")
NEAR_SAYS = """\
Every force and couple that does not vanish, and the piston's acceleration, in u of the amplitude of the
output itself; the one nearest to what its function states (`rounding`) is shown. 4 u are aimed at.
naive: the harmonics as cos(nθ), nθ rounded; the sum over the cylinders."""
FAR_SAYS = """\
Beyond 2^20 rad every value rests on the library's cos θ and sin θ, raised to the step s of the output's
orders: the bound is 4 + s times what is stated for near angles, as in the self-tests of the generated
sources."""
SMALL_SAYS = """\
Many cylinders leave only high orders, many powers of 1/λ down: u is of the amplitude that is left,
named with each. The bound is what the function itself states (`rounding`)."""
FLOAT_SAYS = """\
float32 angles (taken as exact) give float32 values: in units of 2^-24 of the amplitude, the
displacement in float32 ulp of itself. naive: the same sums in float32."""


def asked_of(layout: Engine, order: int = 12, tolerance: float | None = None) -> Iterator[Asked]:
    """Yield what an engine has: its forces and couples that do not vanish, a piston's acceleration."""
    ratio = layout.ratio or REAL
    for name in OUTPUTS:
        if name.partition(".")[0] in KINDS or name == "piston.acceleration":
            asked = Asked(layout, name, ratio, order, tolerance)
            if asked.amplitude:
                yield asked


def near(quick: bool) -> Part:
    """Return the cases of the catalogue's engines for |theta| <= 1e6."""
    points = Points(hard(300 if quick else 10_000))
    cases = []
    for engine in QUICK if quick else alike():
        progress(f"{engine}, near angles")
        for tolerance, words in ((None, "orders to 12"), (0.0, "all orders")):
            cases.append(engine_case(f"{engine}, {words}", load(engine), points, tolerance=tolerance))
    cases += [on_others(points, target, quick) for target in targets() if target != "numpy"]
    return Part("Forces, couples, accelerations, |θ| ≤ 1e6 rad", NEAR_SAYS, [*cases, on_grid()])


def alike() -> list[str]:
    """Return the catalogue's engines with one kind of cylinder, which is what `truth` knows of."""
    return [preset.name for preset in presets() if load(preset.name).has_common_harmonics]


def engine_case(what: str, layout: Engine, points: Points, **orders: Any) -> Case:
    """Return the worst output of an engine."""
    return tried(
        what, NEAR, OF_AMPLITUDE, lambda: largest(list(output_cases(layout, points, **orders)), what)
    )


def output_cases(layout: Engine, points: Points, **orders: Any) -> Iterator[Case]:
    """Yield a case for every output."""
    for asked in asked_of(layout, **orders):
        yield asked.case(asked.name, points, asked.stated, f"{asked.name}: ")


def on_others(points: Points, target: str, quick: bool) -> Case:
    """Return the worst of some outputs on another target."""
    progress(f"engines on {target}")
    chosen = CHOSEN[:1] if quick else CHOSEN
    what = f"some outputs, orders to 12, {target}"
    rows = [(Asked(load(engine), name, load(engine).ratio or REAL), engine) for engine, name in chosen]
    return tried(
        what,
        NEAR,
        OF_AMPLITUDE,
        lambda: largest(
            [a.case(what, points, NEAR, f"{e}: ", on_target(a, target)) for a, e in rows], what
        ),
    )


def on_grid(points: int = 1441) -> Case:
    """Return how far off values on a grid are, whose angles 2 pi j/points are exact."""
    asked = Asked(load("v6-90"), "couple.vertical", load("v6-90").ratio or REAL)
    with mp.workdps(40):
        turns = [2 * mp.pi * j / points for j in range(points)]
        values = [
            mp.fsum(t.cos * mp.cos(t.order * a) + t.sin * mp.sin(t.order * a) for t in asked.terms)
            for a in turns
        ]
        theta = np.array([float(a) for a in turns])

    def make() -> Case:
        off = [
            abs(float(v - float(o))) for v, o in zip(values, asked.evaluator.on_grid(points), strict=True)
        ]
        size = 2.0**-53 * asked.amplitude
        return measured("v6-90, couple.vertical on a grid of 1441", theta, np.array(off) / size, NEAR)

    return tried("v6-90, couple.vertical on a grid of 1441", NEAR, OF_AMPLITUDE, make)


def far(quick: bool) -> Part:
    """Return the cases of angles beyond what is reduced exactly."""
    cases = []
    for size in FAR:
        progress(f"angles of {size:g} rad")
        points = Points(random_angles(100 if quick else 2000, 11)[: 50 if quick else 1000] * (size / 1e6))
        cases += [far_case(engine, name, points, size) for engine, name in FAR_ASKED]
    return Part("Far angles, 1e7 to 1e15 rad", FAR_SAYS, cases)


CHOSEN = (("v6-90", "couple.vertical"), ("inline-4", "force.vertical"), ("radial-7", "force.lateral"))
FAR_ASKED = (("inline-4", "force.vertical"), ("v6-90", "couple.vertical"), ("v12-60", "force.vertical"))


def far_case(engine: str, name: str, points: Points, size: float) -> Case:
    """Return how far off an output is at far angles, beside its bound there."""
    layout = load(engine)
    asked = Asked(layout, name, layout.ratio or REAL)
    what = f"{engine}, {name}, to {size:g} rad"
    return tried(
        what, NEAR, OF_AMPLITUDE, lambda: asked.case(what, points, (4 + asked.step) * asked.stated)
    )


def many(quick: bool) -> Part:
    """Return the cases of order 1000 and of 24 cylinders, held to what the function states itself."""
    points = Points(hard(60 if quick else 1500))
    rows = [
        Asked(layout, name, REAL, 48, tolerance)
        for layout, name in twenty_four()
        for tolerance in (None, 0.0)
    ]
    rows += [
        Asked(load(engine), "force.vertical", REAL, 1000) for engine in ("inline-4", "inline-1", "v12-60")
    ]
    cases = [case for asked in rows for case in stated_case(asked, points)]
    return Part("Order 1000, and 24 cylinders, λ = 3.5", SMALL_SAYS, cases)


def stated_case(asked: Asked, points: Points, note: str = "") -> list[Case]:
    """Return an output's case held to its own stated rounding; none where the output vanishes."""
    orders = f"orders to {asked.order}" if asked.tolerance is None else "all orders"
    what = f"{asked.layout.name}, {asked.name}, {orders}"
    progress(what)
    try:
        if not asked.amplitude:
            return []
    except Exception as error:
        return [Case(what, f"raised {type(error).__name__}: {error}"[:36], float("inf"), NEAR)]
    note = note or f"amplitude {asked.amplitude:.3g}: "
    return [tried(what, NEAR, OF_AMPLITUDE, lambda: asked.case(what, points, asked.stated, note))]


def twenty_four() -> list[tuple[Engine, str]]:
    """Return engines of 24 cylinders, evenly firing or with odd angles, and what is left of them."""
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


def float32(quick: bool) -> Part:
    """Return the cases of float32 angles."""
    narrow = hard(200 if quick else 4000).astype(np.float32)
    points = Points(narrow.astype(np.float64))
    rows = CHOSEN[:1] if quick else CHOSEN
    cases = [
        float32_case(engine, name, narrow, points, t)
        for t in targets()
        if t != "c"
        for engine, name in rows
    ]
    return Part("float32 angles to 1e6", FLOAT_SAYS, [*cases, float32_displacement(narrow, points)])


def float32_case(engine: str, name: str, narrow: Any, points: Points, target: str) -> Case:
    """Return how far float32 values are off, in 2^-24 of the amplitude."""
    asked = Asked(load(engine), name, load(engine).ratio or REAL)
    what = f"{engine}, {name}, {target}"

    def make() -> Case:
        truth, size = asked.truth(points), U32 * asked.amplitude
        values = asked.on(target)(narrow)
        if values.dtype != np.float32:
            raise TypeError(f"gives {values.dtype}")
        naive = {"cos n theta": truth.off(asked.naive(narrow)["cos n theta"]) / size}
        return measured(what, points.theta, truth.off(values) / size, FLOAT32, "u32", naive)

    return tried(what, FLOAT32, "u32", make)


def float32_displacement(narrow: Any, points: Points) -> Case:
    """Return how far float32 displacements are off, in float32 ulp of themselves."""
    asked = Asked(inline(throws=[0]), "piston.displacement", REAL, 1)

    def make() -> Case:
        truth, one = asked.truth(points), np.float32(1)
        ulp = np.spacing(np.abs(truth.high).astype(np.float32)).astype(np.float64)
        lam = np.float32(3.5)
        naive = one - np.cos(narrow) + lam * (one - np.sqrt(one - (np.sin(narrow) / lam) ** 2))
        others = {"1 - cos ...": truth.off(naive) / ulp}
        off = truth.off(asked.evaluator(narrow)) / ulp
        return measured("displacement", points.theta, off, FLOAT32, "ulp32", others)

    return tried("displacement", FLOAT32, ULP, make)
