"""`symbalance bench derive`: the time of exact derivations, beside the fastest other libraries have.

The alternatives: SymPy's `ring_series` and python-flint for the harmonics; SymPy's cyclotomic fields,
remainders modulo Phi_N with python-flint, and `equals(0)` on a sum of exponentials for the zeros of an
in-line engine; `sympy.latex`; `import sympy` in a process of its own. `derive_alternatives` says why
these forms; each delivers what symbalance does, or less. Where one is faster, its target is a limit on
how much.
"""

from __future__ import annotations

import platform
from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import partial

import sympy
from sympy.core.cache import clear_cache

from symbalance.bench.derive_alternatives import (
    cyclotomic_field,
    flint_harmonics,
    has_flint,
    is_zero_by_equals,
    is_zero_by_flint,
    is_zero_in_field,
    ring_expressions,
    ring_harmonics,
)
from symbalance.bench.ideal_engine import ideal_engine
from symbalance.bench.timing import Measurement, Report, at_least, at_most, best, processes, progress
from symbalance.engine.builders import inline
from symbalance.forces.force_sums import geometry
from symbalance.kinematics.series_printing import series_latex
from symbalance.kinematics.slider_crank import (
    Series,
    acceleration_integers,
    acceleration_series,
    harmonics,
)

INTEGER_LIMITS = {20: 20e-6, 200: 2e-3, 1000: 0.1}
"""Seconds for all A_n to an order: what a page that derives while one types can spend."""
RING, FLINT = "sympy ring_series", "python-flint"
ORDERS, QUICK_ORDERS = (20, 40, 80, 200), (20, 80)
COUNTS = (7, 11, 13, 24)
ALL_ORDERS = range(1, 25)
EXPONENTIALS = {7: (1, 2, 4), 11: (1, 2, 4, 7)}
"""In-line engines and orders that `equals(0)` is asked about: it takes seconds for each."""
RING_TIMES, FLINT_TIMES, EXPRESSION_TIMES = 20, 2.5, 2
FIELD_TIMES, REMAINDER_TIMES, EQUALS_TIMES = 5, 5, 5000
"""Targets: ring_series, the field and `equals` take at least so many times as long; symbalance takes at
most so many times as long as FLINT, and as the expressions built from `ring_series`."""
LATEX_TIMES = 50


def report(quick: bool = False) -> Report:
    """Return all measurements; `quick` takes fewer orders."""
    parts: list[tuple[str, list[Measurement]]] = [
        ("Harmonics of one slider-crank", [*integers(), *integers_beside(quick), as_expressions()]),
        ("Exact zeros: orders 1 to 24 of an evenly firing in-line N", zeros(quick)),
        ("LaTeX of a series", [series_in_latex()]),
        ("What an ideal engine pays for offsets, link rods and unlike cylinders", ideal_engine()),
        ("Whole processes (medians, in turn)", whole_processes(3 if quick else 7)),
    ]
    return Report(f"{_head()}; best of many unless stated otherwise", parts)


def _head() -> str:
    """Return the versions of the alternatives, and the machine."""
    if has_flint():
        from importlib.metadata import version

        flint = f"python-flint {version('python-flint')}"
    else:
        flint = "python-flint is not installed (pip install python-flint)"
    return f"Python {platform.python_version()}, SymPy {sympy.__version__}, {flint}, {platform.machine()}"


def integers() -> list[Measurement]:
    """Measure all A_n to an order as integers, against the clock."""
    progress("integers")
    rows = []
    for order, limit in INTEGER_LIMITS.items():
        seconds = best(partial(acceleration_integers, order))
        name = f"all A_n to order {order} as integers"
        rows.append(Measurement(name, seconds, target=f"under {limit:g} s", is_met=seconds < limit))
    return rows


def integers_beside(quick: bool) -> list[Measurement]:
    """Measure the same beside SymPy's `ring_series` and python-flint."""
    rows = []
    for order in QUICK_ORDERS if quick else ORDERS:
        progress(f"ring_series and python-flint to order {order}")
        name = f"all A_n to order {order} as integers"
        seconds = best(partial(acceleration_integers, order))
        rows.append(at_least(RING_TIMES, name, seconds, RING, best(partial(ring_harmonics, order))))
        if has_flint():
            rows.append(at_most(FLINT_TIMES, name, seconds, FLINT, best(partial(flint_harmonics, order))))
    return rows


def as_expressions() -> Measurement:
    """Measure the harmonics to order 40 as SymPy expressions, building included."""
    progress("SymPy expressions to order 40")

    def build() -> list[sympy.Expr]:
        return [series.in_lam() for series in harmonics("acceleration", 40).terms.values()]

    seconds = best(build, budget=1, before=empty_caches)
    other = best(lambda: ring_expressions(40), budget=1, before=empty_caches)
    name = "all A_n to order 40 as SymPy expressions"
    return at_most(EXPRESSION_TIMES, name, seconds, f"{RING}, as expressions", other)


def empty_caches() -> None:
    """Empty SymPy's cache and that of the series, so that every call does its work."""
    clear_cache()
    acceleration_series.cache_clear()


def zeros(quick: bool) -> list[Measurement]:
    """Measure all orders to 24 of in-line engines, beside other exact and symbolic proofs of zero."""
    rows = []
    for count in COUNTS:
        progress(f"zeros at N = {count}")
        zero_count = len(ALL_ORDERS) - len(surviving_orders(count, ALL_ORDERS))
        name = f"N = {count}: {zero_count} of {len(ALL_ORDERS)} orders proved zero"
        seconds = best(partial(surviving_orders, count, ALL_ORDERS))
        rows.append(Measurement(name, seconds, target="under 0.0003 s", is_met=seconds < 3e-4))
        cyclotomic_field(count)  # built untimed
        other = best(partial(_count_proofs, is_zero_in_field, count, ALL_ORDERS), before=empty_caches)
        alternative = "sympy, cyclotomic field"
        rows.append(at_least(FIELD_TIMES, name, seconds, alternative, other))
        if has_flint():
            other = best(partial(_count_proofs, is_zero_by_flint, count, ALL_ORDERS))
            alternative = f"{FLINT}, remainders modulo Φ_{count}"
            rows.append(at_most(REMAINDER_TIMES, name, seconds, alternative, other))
    return rows + [
        _beside_equals(n, orders[:2] if quick else orders) for n, orders in EXPONENTIALS.items()
    ]


def _count_proofs(is_zero: Callable[[int, int], bool], count: int, orders: Iterable[int]) -> int:
    """Return for how many orders a way proves that the sum vanishes."""
    return sum(is_zero(count, n) for n in orders)


def _beside_equals(count: int, orders: tuple[int, ...]) -> Measurement:
    progress(f"equals(0) at N = {count}")
    proofs: list[int] = []
    other = best(
        lambda: proofs.append(_count_proofs(is_zero_by_equals, count, orders)),
        budget=0,
        before=empty_caches,
    )
    seconds = best(partial(surviving_orders, count, orders))
    name = f"N = {count}, orders {list(orders)}: {len(orders)} of {len(orders)} zeros"
    alternative = f"sympy, exponentials, equals(0): {proofs[0]} of {len(orders)} zeros"
    return at_least(EQUALS_TIMES, name, seconds, alternative, other)


_LAYOUTS = {n: inline("-".join(map(str, range(1, n + 1)))) for n in COUNTS}


def surviving_orders(count: int, orders: Iterable[int]) -> list[int]:
    """Return which force orders survive in an in-line engine of `count` evenly firing cylinders."""
    return geometry(_LAYOUTS[count], list(orders), [Fraction(1)] * count).orders()


def series_in_latex() -> Measurement:
    """Measure the LaTeX of all A_n cos n theta to order 200, beside sympy.latex of the same sum."""
    progress("LaTeX of a series to order 200")
    rows = harmonics("acceleration", 200).terms
    theta = sympy.Symbol("theta")
    expression = sympy.Add(*(sympy.cos(n * theta) * series.in_lam() for n, series in rows.items()))
    seconds = best(lambda: [_harmonic_latex(n, series) for n, series in rows.items()])
    other = best(lambda: sympy.latex(expression), budget=1, before=empty_caches)
    return at_least(LATEX_TIMES, "sum of A_n cos nθ to order 200 as LaTeX", seconds, "sympy.latex", other)


def _harmonic_latex(n: int, series: Series) -> str:
    return rf"\left({series_latex(series)}\right) \cos {n} \theta"


def whole_processes(runs: int = 7) -> list[Measurement]:
    """Measure the command line from outside."""
    progress("whole processes")
    command = ["-m", "symbalance", "balance", "v12-60", "--order", "12"]
    balancing, importing, ratio = processes(command, ["-c", "import sympy"], runs)
    helping, nothing, _ = processes(["-m", "symbalance", "--help"], ["-c", "pass"], runs)
    limit = 0.15 * max(nothing / 0.01, 1)  # a slower machine or Python has longer
    return [
        Measurement(
            "symbalance balance v12-60 --order 12",
            balancing,
            'python -c "import sympy"',
            importing,
            f"at most twice as long (here {ratio:.2f} times)",
            ratio <= 2,
        ),
        Measurement(
            "symbalance --help",
            helping,
            "python -c pass",
            nothing,
            f"at most 0.15 s where pass takes 0.01 s: {limit:.3g} s here",
            helping <= limit,
        ),
    ]
