"""`symbalance bench derive`: what deriving costs, beside SymPy doing the same in the same run.

The alternatives, by name: the harmonics by `series`, `rewrite(exp)` and `expand`; the zeros of an
in-line engine's sums by `trigsimp` and `equals(0)`; a series' LaTeX by `sympy.latex`; a whole process
beside `import sympy`. Each is asked for what ours delivers, or for less.
"""

from __future__ import annotations

import platform
from fractions import Fraction

import sympy
from sympy.core.cache import clear_cache

from symbalance.bench.timing import Measurement, Report, best, processes, progress
from symbalance.bench.unused import ideal_engine
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


def report(quick: bool = False) -> Report:
    """Return all measurements; `quick` leaves out alternatives that take over ten seconds."""
    progress("integers")
    parts: list[tuple[str, list[Measurement]]] = [
        (
            "Harmonics of one slider-crank",
            [*integers(), *integers_against_sympy(quick), as_expressions()],
        ),
        ("Exact zeros: orders 1 to 24 of an evenly firing in-line N", zeros(quick)),
        ("LaTeX of a series", [series_in_latex()]),
        ("What an ideal engine pays for offsets, link rods and unlike cylinders", ideal_engine()),
        ("Whole processes (medians, in turn)", whole_processes()),
    ]
    head = f"Python {platform.python_version()}, SymPy {sympy.__version__}, {platform.machine()}"
    return Report(f"{head}; best of many unless said otherwise", parts)


def integers() -> list[Measurement]:
    """Measure all A_n to an order as integers, against the clock."""
    found = []
    for order, limit in INTEGER_LIMITS.items():
        taken = best(lambda order=order: acceleration_integers(order))
        name = f"all A_n to order {order} as integers"
        found.append(Measurement(name, taken, wanted=f"under {limit:g} s", met=taken < limit))
    return found


def integers_against_sympy(quick: bool) -> list[Measurement]:
    """Measure the same beside SymPy's series, rewrite(exp) and expand."""
    found = []
    for order in (20, 40) if quick else (20, 80):
        progress(f"SymPy's expansion to order {order}")
        ours = best(lambda order=order: acceleration_integers(order))
        theirs = best(lambda order=order: expanded_by_sympy(order), budget=2, before=forget)
        found.append(
            _at_least(
                5000,
                f"all A_n to order {order} as integers",
                ours,
                "sympy series, rewrite(exp), expand",
                theirs,
            )
        )
    return found


def as_expressions() -> Measurement:
    """Measure the harmonics to order 40 as SymPy expressions, building included."""
    progress("SymPy expressions to order 40")

    def build() -> list[sympy.Expr]:
        return [series.in_lam() for series in harmonics("acceleration", 40).terms.values()]

    theirs = best(lambda: expanded_by_sympy(40), budget=2, before=forget)
    return _at_least(
        20,
        "all A_n to order 40 as SymPy expressions",
        best(build, before=forget),
        "sympy series, rewrite(exp), expand",
        theirs,
    )


def forget() -> None:
    """Empty SymPy's cache and ours, so that every call does its work."""
    clear_cache()
    acceleration_series.cache_clear()


def expanded_by_sympy(order: int) -> sympy.Expr:
    """Return sqrt(1 - rho^2 sin^2 theta)/rho in exponentials, as one would ask SymPy for it."""
    rho, theta, x = sympy.symbols("rho theta x")
    root = sympy.series(sympy.sqrt(1 - x), x, 0, order // 2 + 1).removeO()
    return sympy.expand((root.subs(x, rho**2 * sympy.sin(theta) ** 2) / rho).rewrite(sympy.exp))


def zeros(quick: bool) -> list[Measurement]:
    """Measure all orders to 24 of in-line engines, and single orders beside trigsimp and equals(0)."""
    found = []
    for count in (7, 11, 13, 24):
        taken = best(lambda count=count: surviving_orders(count, range(1, 25)))
        kept = len(surviving_orders(count, range(1, 25)))
        name = f"N = {count}: {24 - kept} of 24 orders proved zero"
        found.append(Measurement(name, taken, wanted="under 0.0003 s", met=taken < 3e-4))
    orders = (1, 2) if quick else (1, 2, 4, 7)
    for count in (7, 11):
        for name, proves in (("trigsimp", trigsimp_proves), ("equals(0)", equals_proves)):
            found.append(_zeros_against(count, orders, name, proves))
    return found


def _zeros_against(count: int, orders: tuple[int, ...], name: str, proves) -> Measurement:
    progress(f"{name} at N = {count}")
    cancelling = [n for n in orders if 2 * n % count]
    proofs: list[bool] = []
    theirs = best(lambda: proofs.extend(proves(count, n) for n in cancelling), budget=0)
    ours = best(lambda: surviving_orders(count, cancelling))
    what = f"N = {count}, orders {cancelling}: {len(cancelling)} of {len(cancelling)} zeros"
    return _at_least(
        10_000, what, ours, f"sympy {name}: {sum(proofs)} of {len(cancelling)} zeros", theirs
    )


_LAYOUTS = {n: inline("-".join(map(str, range(1, n + 1)))) for n in (7, 11, 13, 24)}


def surviving_orders(count: int, orders) -> list[int]:
    """Return which force orders survive in an in-line engine of `count` evenly firing cylinders."""
    return geometry(_LAYOUTS[count], orders, [Fraction(1)] * count).orders()


def cosine_sum(count: int, order: int) -> sympy.Expr:
    """Return the sum of cos n(theta + 4 pi j/N) as a user writes it in SymPy."""
    theta = sympy.Symbol("theta", real=True)
    return sympy.Add(
        *(sympy.cos(order * (theta + 4 * sympy.pi * j / sympy.Integer(count))) for j in range(count))
    )


def trigsimp_proves(count: int, order: int) -> bool:
    """Tell whether trigsimp reduces that sum to zero."""
    return sympy.trigsimp(cosine_sum(count, order)) == 0


def equals_proves(count: int, order: int) -> bool:
    """Tell whether equals(0) calls that sum zero."""
    return cosine_sum(count, order).equals(0) is True


def series_in_latex() -> Measurement:
    """Measure the LaTeX of all A_n cos n theta to order 200, beside sympy.latex of the same sum."""
    progress("LaTeX of a series to order 200")
    rows = harmonics("acceleration", 200).terms
    theta = sympy.Symbol("theta")
    terms = [sympy.cos(n * theta) * series.in_lam() for n, series in rows.items()]
    expression = sympy.Add(*terms)
    ours = best(lambda: [_harmonic_latex(n, series) for n, series in rows.items()])
    theirs = best(lambda: sympy.latex(expression), budget=1, before=forget)
    return _at_least(50, "sum of A_n cos nθ to order 200 as LaTeX", ours, "sympy.latex", theirs)


def _harmonic_latex(n: int, series: Series) -> str:
    return rf"\left({series_latex(series)}\right) \cos {n} \theta"


def whole_processes() -> list[Measurement]:
    """Measure the command line from outside."""
    progress("whole processes")
    balance = ["-m", "symbalance", "balance", "v12-60", "--order", "12"]
    ours, theirs, ratio = processes(balance, ["-c", "import sympy"])
    shown, nothing, _ = processes(["-m", "symbalance", "--help"], ["-c", "pass"])
    limit = 0.15 * max(nothing / 0.01, 1)
    return [
        Measurement(
            "symbalance balance v12-60 --order 12",
            ours,
            'python -c "import sympy"',
            theirs,
            f"at most twice as long (here {ratio:.2f} times)",
            ratio <= 2,
        ),
        Measurement(
            "symbalance --help",
            shown,
            "python -c pass",
            nothing,
            f"at most 0.15 s where pass takes 0.01 s: {limit:.3g} s here",
            shown <= limit,
        ),
    ]


def _at_least(times: int, what: str, ours: float, against: str, theirs: float) -> Measurement:
    return Measurement(what, ours, against, theirs, f"at least {times:,} times", theirs / ours >= times)
