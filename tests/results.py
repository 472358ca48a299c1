"""One example of every result the library computes, for tests that hold for all of them."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import sympy
from sympy import Symbol

import symbalance as sb
from symbalance.checking import sidecar_draft
from symbalance.crankshaft.files import read_running_engine
from symbalance.crankshaft.reports import summarise_run
from symbalance.crankshaft.running import configure_run, run_speeds
from symbalance.document.result import Result
from symbalance.engine.crank_train import CrankTrain
from symbalance.notes.checking.reports.document_table import DocumentRow, DocumentTable
from tests.cranks import sheet, written


def _balance() -> Result:
    return sb.balance(sb.load("v10-72"), 6)


def _balance_unlike() -> Result:
    return sb.balance(sb.load("r-985"), 4)


def _balance_in_newtons() -> Result:
    return sb.balance(sb.load("vq30de"), 6).at(rpm=6000)


def _balance_over_speeds() -> Result:
    speeds = [Fraction(rpm) for rpm in (1000, 4000, 7000)]
    return sb.forces.over_speeds(sb.balance(sb.load("vq30de"), 4), speeds)


def _worst_cases() -> Result:
    tolerances = sb.design.Tolerances(mass="0.5%", throw="0.1", rotating="1%")
    return sb.worst_cases(sb.load("vq30de"), tolerances, 4, of=["largest", "vertical"], rpm=3000)


def _sensitivities() -> Result:
    return sb.sensitivities(sb.load("v8-90"), 4)


def _sweep() -> Result:
    vary = {"ratio": ["7/2", 4, 1.1], "bank": [60, 90], "offset": [0, 10]}
    engine = sb.vee(90, pins=[0], crank_train=CrankTrain(stroke=Fraction(80)))
    return sb.sweep(engine, vary, ["force.1", "force.2.lateral", "torque.2"])


def _sweep_at_speed() -> Result:
    vary = {"stroke": [80, 90], "reciprocating_mass": ["0.5"]}
    return sb.sweep(sb.load("vq30de"), vary, ["force.6", "couple.2.vertical", "torque.3"], rpm=6000)


def _assignment() -> Result:
    return sb.design.assign_parts(sb.load("v6-60"), ["0.453", "0.447", "0.451", "0.45", "0.455", "0.448"])


def _assignment_of_many() -> Result:
    masses = [Fraction(440 + (7 * n) % 19, 1000) for n in range(12)]
    return sb.design.assign_parts(sb.load("v12-60"), masses, orders=[1, 2], whole=True)


def _symbolic_order() -> Result:
    letters = {"masses": "m", "radii": "r", "rods": "l", "offsets": "e"}
    return sb.design.symbolic_order(sb.inline("1-3-2"), 2, through=3, **letters)


def _symbolic_order_of_a_vee() -> Result:
    engine = sb.vee(sympy.Symbol("alpha"), pins=[0], name="twin_of_any_angle")
    return sb.design.symbolic_order(engine, 1, masses="m", reference="1/2").at({"m_1": "1.002"})


def _derivation() -> Result:
    return sb.derive("force", 6)


def _crank_stars() -> Result:
    return sb.engine.crank_stars(5)


def _search() -> Result:
    shape = [1, "0.7", "0.4", "0.2"]
    asked = ["couple.1", "couple.2", "torsion.1.5"]
    return sb.search.search_cranks(4, minimize=asked, modes=[shape], limit=["couple.1<=3"])


def _search_of_a_vee() -> Result:
    return sb.search.search_cranks(8, banks=[-45, 45], minimize=["couple.1", "bending"], listed=2)


def _search_of_firing_orders() -> Result:
    asked = ["adjacent", "evenness", "bearing", "force.3"]
    return sb.search.search_cranks(6, minimize=asked, limit=["evenness<=90"], listed=1)


def _firing_orders() -> Result:
    return sb.engine.firing_orders(sb.load("vw-vr6"), within="1/2")


def _truncation_bounds() -> Result:
    return sb.kinematics.truncation_bounds("force", "7/2", 12)


def _harmonics() -> Result:
    return sb.kinematics.harmonics("displacement", 6)


def _comparison() -> Result:
    engines = ("v8-90", "v8-90-flat", "inline-5", "v2-90")
    return sb.design.compare([sb.load(name) for name in engines], 6, phases=True)


def _comparison_unlike() -> Result:
    """Unlike cylinders among like ones; no rod ratio, a symbol, no firing order."""
    nameless = sb.inline("1-3-4-2", name="no_ratio")
    twin = sb.vee(Symbol("alpha"), pins=[0], name="twin_of_any_angle", ratio=4)
    engines = [sb.load("vw-vr6"), sb.load("inline-4"), nameless, twin]
    return sb.design.compare(engines, 4, phases=True)


def _comparison_over_speeds() -> Result:
    engines = [sb.load("vq30de"), sb.load("inline-4").with_sizes(stroke=80, reciprocating_mass="0.5")]
    return sb.design.compare_over_speeds(sb.design.compare(engines, 4), [Fraction(2000), Fraction(5000)])


def _comparison_at_speed() -> Result:
    """In newtons: a file's own sizes, and sizes for those that have none; a symbol, and no couple."""
    twin = sb.vee(Symbol("alpha"), pins=[0], name="twin", ratio=4)
    engines = [sb.load("vq30de"), sb.load("inline-4"), twin]
    return sb.design.compare(engines, 4).at(rpm=6000, stroke=86, mass="0.5", pitch=100)


def _design() -> Result:
    return sb.design_balance(sb.load("inline-5"), [1, 2], shafts=2)


def _design_unlike() -> Result:
    return sb.design_balance(sb.load("vw-vr6"), [1], per_throw=True)


def _ellipse() -> Result:
    return sb.design.ellipse(sb.balance(sb.load("v10-72"), 1), 1, "couple")


def _rotating_balance() -> Result:
    pins = [("3/2", 0), ("1/2", 90), ("-1/2", 270), ("-3/2", 180)]
    weights = [sb.engine.Weight(station, angle, unbalance=60) for station, angle in pins]
    return sb.design.balanced_weights(weights, [2, -2])


def _running(name: str, order: int) -> Result:
    sizes = {"bore": 80, "stroke": 80, "reciprocating_mass": "0.5"}
    return sb.running_torque(
        sb.load(name), sb.torque.ideal_cycle(10, heat=20), rpm=3000, order=order, **sizes
    )


def _torque_running() -> Result:
    engine = sb.load(Path(__file__).parent / "record" / "engines" / "lanchester-four.toml")
    cycle = sb.torque.ideal_cycle("8.5", heat=18)
    running = sb.running_torque(engine, cycle, bore=90, rpm=3000, order=6)
    return sb.torque.torque_report(engine, 6, running=running)


PAGE = r"""
$$x \approx r(1-\cos\theta) + \frac{r}{2\lambda}(1-\cos 2\theta)$$

連桿比 $\lambda = 147.15/36.65 = 4.02$ and $|k| = |-k|$, so that $k \neq q$; $\ln(k^2) = 2 \ln k$

$$\frac{\mathrm{d}x}{\mathrm{d}\theta} 度 = r \sin\theta = r \cos\theta$$

$$u^2 = 4$$

where $u > 1$, and for $w = 3$ the same

$$u = 5$$

$$k \wr 3 = 3$$
"""
"""Every verdict, Japanese prose, and characters that each medium writes in its own way."""
LETTERS = {
    "theta": "crank angle",
    "r": "crank radius",
    "lambda": "rod ratio l/r",
    "x": "displacement from top dead centre",
    "k": "positive",
    "u": "variable",
    "w": "variable",
}


def _check() -> Result:
    return sb.check(PAGE, LETTERS)


def _document_table() -> Result:
    """A document with every verdict, and one that is not there."""
    read = DocumentRow("notes/page.md", _check().data(), 1)
    missing = DocumentRow("notes/lost.md", None, 2, "notes/lost.md: cannot be read; check the path")
    return DocumentTable((read, missing))


def _declaration_draft() -> Result:
    """A page whose words propose meanings, components of a force and what lines claim."""
    return sidecar_draft(
        "# V12, banks at 60°\n\ncrank radius r, λ = l/r, α is half the bank angle\n\n"
        "Lh is the horizontal component of L\n\n$$Lh = L \\sin α$$\n\n"
        "## Sixth order force\n\nIts part in cos 6θ.\n\n"
        "### Vertical, left bank\n\n$$3 \\sqrt 3 \\cos 6θ$$\n\n"
        "## Shares, the first order being taken as 100, of the vq30de\n\nSixth order force 0.02\n\n"
        "## Sixth order force, vertical\n\n$$6 \\sqrt 3 \\cos 6θ$$\n\n$$u = r \\sin θ$$\n"
    )


def _verdict() -> Result:
    x = sympy.Symbol("x")
    return sb.check_equal(sympy.sin(x) ** 2, (1 + sympy.cos(2 * x)) / 2)


def _rotor() -> Any:
    discs = {0.5: sb.crankshaft.Disc(32.6, 0.33, 0.18)}
    return sb.crankshaft.rotor.shaft([sb.crankshaft.rotor.Tube(1.5, 0.05)], discs, bearings=(0.0, 1.5))


UNEVEN = [sb.crankshaft.rotor.Support((1e6, 8e5), damping=100.0)] * 2
"""Supports softer sideways, N/m, with damping in N s/m."""


def _modes() -> Result:
    return sb.crankshaft.rotor.natural_modes(_rotor(), 5)


def _campbell() -> Result:
    rotor = _rotor()
    return sb.crankshaft.rotor.campbell(
        rotor, [0.0, 200.0, 400.0], sb.crankshaft.rotor.bearing_springs(rotor, 1e6, axial=1e8), count=8
    )


def _whirl() -> Result:
    return sb.crankshaft.rotor.whirl(_rotor(), UNEVEN, 400.0)


def _critical_speeds() -> Result:
    return sb.crankshaft.rotor.critical_speeds(_rotor(), UNEVEN, most=600.0)


def _unbalance_response() -> Result:
    return sb.crankshaft.rotor.unbalance_response(
        _rotor(), UNEVEN, {0.5: 1e-3, 0.0: 2e-4j}, [80.0, 400.0]
    )


def _torsional_chain() -> Result:
    return sb.crankshaft.rotor.torsional_chain(
        [3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05], [12e3, 12e3, 14e3, 10e3]
    )


def _crank_node() -> Result:
    return sb.crankshaft.node_equations("uvw")


def _crankshaft() -> Result:
    """A run of one cylinder at three speeds, of which the last is not to be relied on."""
    with TemporaryDirectory() as folder:
        engine = read_running_engine(written(Path(folder), sheet())).at_speeds((1000.0, 1500.0, 2000.0))
        made = configure_run(engine, webs="nominal", steps=120, about="centre")
        outcomes = [replace(one, seconds=0.25) for one in run_speeds(made)]
    lost = replace(outcomes[-1], reason="films do not settle at 120 steps a cycle")
    return summarise_run(made, [*outcomes[:-1], lost])


EXAMPLES: dict[str, Callable[[], Result]] = {
    "balance": _balance,
    "balance-unlike": _balance_unlike,
    "balance-in-newtons": _balance_in_newtons,
    "balance-over-speeds": _balance_over_speeds,
    "worst-cases": _worst_cases,
    "sensitivities": _sensitivities,
    "sensitivities-at-speed": lambda: sb.sensitivities(sb.load("vq30de"), 1, rpm=6000),
    "sweep": _sweep,
    "sweep-at-speed": _sweep_at_speed,
    "assignment": _assignment,
    "assignment-of-many": _assignment_of_many,
    "symbolic-order": _symbolic_order,
    "symbolic-order-of-a-vee": _symbolic_order_of_a_vee,
    "derivation": _derivation,
    "presets": sb.presets,
    "crank-stars": _crank_stars,
    "firing-orders": _firing_orders,
    "search": _search,
    "search-of-a-vee": _search_of_a_vee,
    "search-of-firing-orders": _search_of_firing_orders,
    "truncation-bounds": _truncation_bounds,
    "harmonics": _harmonics,
    "comparison": _comparison,
    "comparison-unlike": _comparison_unlike,
    "comparison-at-speed": _comparison_at_speed,
    "comparison-over-speeds": _comparison_over_speeds,
    "row-formulas": lambda: sb.forces.tabulate_row(6),
    "bank-angles": lambda: sb.engine.bank_angles([0, 120, 240], [60, 90]),
    "bank-angles-of-any-crank": lambda: sb.engine.bank_angles(6, [60]),
    "overbalance": lambda: sb.design.tabulate_overbalance(sb.load("inline-3")),
    "overbalance-at-speed": lambda: sb.design.tabulate_overbalance(sb.load("vq30de")).at(rpm=6000),
    "design": _design,
    "design-segments": lambda: sb.design_balance(sb.load("vq30de"), [1]).cut_from(60, 20, inner=20),
    "design-segments-too-big": lambda: sb.design_balance(sb.load("vq30de")).cut_from(60, 12, inner=20),
    "design-at-speed": lambda: sb.design_balance(sb.load("vq30de"), [1, 2]).at(rpm=6000),
    "design-unlike": _design_unlike,
    "ellipse": _ellipse,
    "rotating-balance": _rotating_balance,
    "torque": lambda: sb.torque.torque_report(sb.load("v10-72"), 10),
    "torque-in-newton-metres": lambda: sb.torque.torque_report(sb.load("vq30de"), 6).at(rpm=6000),
    "torque-orders-in-newton-metres": lambda: sb.inertia_torque(sb.load("vq30de"), 4).at(rpm=6000),
    "torque-unlike": lambda: sb.torque.torque_report(sb.load("vw-vr6"), 6),
    "torque-symbolic": lambda: sb.torque.torque_report(sb.vee(Symbol("alpha"), pins=[0]), 3),
    "torque-running": _torque_running,
    "torque-orders": lambda: sb.inertia_torque(sb.load("inline-5"), 10),
    "running-torque": lambda: _running("v2-45", 3),
    "gas-torque": lambda: sb.torque.gas_torque(sb.load("v6-90"), sb.torque.ideal_cycle(10, heat=20)),
    "firing-stars": lambda: sb.torque.firing_stars(sb.load("v6-90"), 4),
    "ideal-cycle": lambda: sb.torque.ideal_cycle(16, heat=20, peak_pressure=100),
    "pressure-trace": lambda: sb.torque.ideal_cycle(10, heat=20).trace(4, 720),
    "check": _check,
    "declaration-draft": _declaration_draft,
    "document-table": _document_table,
    "verdict": _verdict,
    "campbell": _campbell,
    "crank-node": _crank_node,
    "crankshaft": _crankshaft,
    "critical-speeds": _critical_speeds,
    "natural-modes": _modes,
    "torsional-chain": _torsional_chain,
    "unbalance-response": _unbalance_response,
    "whirl": _whirl,
}
"""By a name of its own for each; a class may have several."""


@cache
def example(name: str) -> Result:
    """Return an example, computed once."""
    return EXAMPLES[name]()


def result_classes() -> set[type[Result]]:
    """Return every class of result in the package, all of its modules imported."""
    from importlib import import_module
    from pkgutil import walk_packages

    import symbalance

    for module in walk_packages(symbalance.__path__, "symbalance."):
        if ".bench" not in module.name and not module.name.endswith("__main__"):
            import_module(module.name)
    # A class with slots is made twice; the first lives on among the subclasses.
    return {
        cls
        for cls in _below(Result)
        if cls.__module__.startswith("symbalance.")
        and cls.kind
        and getattr(sys.modules[cls.__module__], cls.__name__) is cls
    }


def _below(cls: type[Result]) -> set[type[Result]]:
    """Return a class and all that derive from it, those that only others derive from among them."""
    return {cls}.union(*map(_below, cls.__subclasses__()))
