"""symbalance: exact free forces and couples of piston engines, as formulas, tables and functions.

    >>> import symbalance as sb
    >>> v12 = sb.balance(sb.load("v12-60"))
    >>> [(o.order, o.force.vertical.amplitude) for o in v12.orders]
    [(6, 6*sqrt(3)), (12, 6*sqrt(3))]

Every public name is loaded when it is first used, so that importing the package costs nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

_HOMES = {
    "Angle": "exact.angles",
    "degrees": "exact.angles",
    "Cylinder": "engine.cylinders",
    "Layout": "engine.layout",
    "CrankTrain": "engine.trains",
    "from_firing_order": "engine.builders",
    "inline": "engine.builders",
    "vee": "engine.builders",
    "vr": "engine.builders",
    "boxer": "engine.builders",
    "w": "engine.builders",
    "radial": "engine.builders",
    "Link": "engine.trains",
    "Counterweight": "engine.balancers",
    "BalanceShaft": "engine.balancers",
    "Weight": "engine.balancers",
    "Balancers": "engine.balancers",
    "load": "engine.catalogue",
    "presets": "engine.catalogue",
    "balance": "forces.resultants",
    "Balance": "forces.resultants",
    "harmonics": "kinematics.slider_crank",
    "exact_coefficient": "kinematics.slider_crank",
    "left_out": "kinematics.truncation",
    "inline_sum": "forces.summation",
    "inline_couple": "forces.summation",
    "derive": "kinematics.derivation",
    "check": "checking",
    "check_equal": "notes.checking",
    "report_text": "notes.checking",
    "report_latex": "notes.checking",
    "report_json": "notes.checking",
    "to_text": "document.printing",
    "to_latex": "document.printing",
    "to_json": "document.printing",
    "to_function": "codegen",
    "firing_orders": "engine.stars",
    "natural_bank_angles": "engine.stars",
    "pin_offsets": "engine.stars",
    "crank_stars": "engine.stars",
    "engine_text": "engine.engine_writing",
    "Design": "design.balancing",
    "Ellipse": "design.balancing",
    "balanced_weights": "design.balancing",
    "best_forward": "design.balancing",
    "best_overbalance": "design.balancing",
    "design_balance": "design.balancing",
    "ellipse": "design.balancing",
    "overbalanced": "design.balancing",
    "rotating_unbalance": "design.balancing",
    "rotating_weights": "design.balancing",
    "throw_unbalance": "design.balancing",
    "design_text": "design.balancing.design_text",
    "design_latex": "design.balancing.design_latex",
    "design_json": "design.balancing.design_json",
    "inertia_torque": "torque",
    "torque_report": "torque",
    "roll_moment": "torque",
    "shaft_moment": "forces.shafts",
    "crank_torque": "torque",
    "gas_torque": "torque",
    "firing_stars": "torque",
    "read_pressure": "torque",
    "pressure_trace": "torque",
    "ideal_cycle": "torque",
    "SliderCrank": "kinematics.mechanisms",
    "LinkRod": "kinematics.mechanisms",
    "RodSplit": "kinematics.mechanisms",
    "dead_centres": "kinematics.mechanisms",
    "force_harmonics": "kinematics.mechanisms",
    "node_equations": "crankshaft.equations",
    "Material": "crankshaft.crank",
    "Disc": "crankshaft.crank",
    "Journal": "crankshaft.crank",
    "Pin": "crankshaft.crank",
    "Web": "crankshaft.crank",
    "WebCounterweight": "crankshaft.crank",
    "Crank": "crankshaft.crank",
    "assemble": "crankshaft.assembly",
    "Tube": "crankshaft.shafts",
    "shaft": "crankshaft.shafts",
    "held_at": "crankshaft.shafts",
    "natural_modes": "crankshaft.modes",
    "campbell": "crankshaft.campbell",
    "torsional_chain": "crankshaft.torsion",
    "twists_of": "crankshaft.torsion",
    "Support": "crankshaft.stationary",
    "whirl": "crankshaft.whirling",
    "critical_speeds": "crankshaft.whirling",
    "unbalance_response": "crankshaft.unbalance",
    "supported": "crankshaft.unbalance",
    "Film": "crankshaft.system",
    "Housing": "crankshaft.system",
    "PeriodicSystem": "crankshaft.system",
    "steady_state": "crankshaft.steady",
    "integrate": "crankshaft.transient",
    "reduced": "crankshaft.reduction",
    "Bearing": "crankshaft.bearings.short_film",
    "film_state": "crankshaft.bearings.short_film",
    "equilibrium": "crankshaft.bearings.short_film",
    "journal_orbit": "crankshaft.bearings.orbits",
    "film_from_tables": "crankshaft.bearings.periodic",
    "symbolic_order": "design.variations",
    "sensitivities": "design.variations",
    "Tolerances": "design.variations",
    "worst_cases": "design.variations",
    "assign_parts": "design.variations",
    "read_parts": "design.variations",
    "SymbalanceError": "errors",
    "symbol": "document.symbols",
}

__all__ = [*_HOMES, "__version__"]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'symbalance' has no attribute {name!r}")
    value = getattr(import_module(f"symbalance.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})


if TYPE_CHECKING:
    from symbalance.checking import check as check
    from symbalance.codegen import to_function as to_function
    from symbalance.crankshaft.assembly import assemble as assemble
    from symbalance.crankshaft.bearings.orbits import journal_orbit as journal_orbit
    from symbalance.crankshaft.bearings.periodic import film_from_tables as film_from_tables
    from symbalance.crankshaft.bearings.short_film import Bearing as Bearing
    from symbalance.crankshaft.bearings.short_film import equilibrium as equilibrium
    from symbalance.crankshaft.bearings.short_film import film_state as film_state
    from symbalance.crankshaft.campbell import campbell as campbell
    from symbalance.crankshaft.crank import Crank as Crank
    from symbalance.crankshaft.crank import Disc as Disc
    from symbalance.crankshaft.crank import Journal as Journal
    from symbalance.crankshaft.crank import Material as Material
    from symbalance.crankshaft.crank import Pin as Pin
    from symbalance.crankshaft.crank import Web as Web
    from symbalance.crankshaft.crank import WebCounterweight as WebCounterweight
    from symbalance.crankshaft.equations import node_equations as node_equations
    from symbalance.crankshaft.modes import natural_modes as natural_modes
    from symbalance.crankshaft.reduction import reduced as reduced
    from symbalance.crankshaft.shafts import Tube as Tube
    from symbalance.crankshaft.shafts import held_at as held_at
    from symbalance.crankshaft.shafts import shaft as shaft
    from symbalance.crankshaft.stationary import Support as Support
    from symbalance.crankshaft.steady import steady_state as steady_state
    from symbalance.crankshaft.system import Film as Film
    from symbalance.crankshaft.system import Housing as Housing
    from symbalance.crankshaft.system import PeriodicSystem as PeriodicSystem
    from symbalance.crankshaft.torsion import torsional_chain as torsional_chain
    from symbalance.crankshaft.torsion import twists_of as twists_of
    from symbalance.crankshaft.transient import integrate as integrate
    from symbalance.crankshaft.unbalance import supported as supported
    from symbalance.crankshaft.unbalance import unbalance_response as unbalance_response
    from symbalance.crankshaft.whirling import critical_speeds as critical_speeds
    from symbalance.crankshaft.whirling import whirl as whirl
    from symbalance.design.balancing import Design as Design
    from symbalance.design.balancing import Ellipse as Ellipse
    from symbalance.design.balancing import balanced_weights as balanced_weights
    from symbalance.design.balancing import best_forward as best_forward
    from symbalance.design.balancing import best_overbalance as best_overbalance
    from symbalance.design.balancing import design_balance as design_balance
    from symbalance.design.balancing import ellipse as ellipse
    from symbalance.design.balancing import overbalanced as overbalanced
    from symbalance.design.balancing import rotating_unbalance as rotating_unbalance
    from symbalance.design.balancing import rotating_weights as rotating_weights
    from symbalance.design.balancing import throw_unbalance as throw_unbalance
    from symbalance.design.variations import Tolerances as Tolerances
    from symbalance.design.variations import assign_parts as assign_parts
    from symbalance.design.variations import read_parts as read_parts
    from symbalance.design.variations import sensitivities as sensitivities
    from symbalance.design.variations import symbolic_order as symbolic_order
    from symbalance.design.variations import worst_cases as worst_cases
    from symbalance.document.printing import to_json as to_json
    from symbalance.document.printing import to_latex as to_latex
    from symbalance.document.printing import to_text as to_text
    from symbalance.document.symbols import symbol as symbol
    from symbalance.engine.balancers import Balancers as Balancers
    from symbalance.engine.balancers import BalanceShaft as BalanceShaft
    from symbalance.engine.balancers import Counterweight as Counterweight
    from symbalance.engine.balancers import Weight as Weight
    from symbalance.engine.builders import boxer as boxer
    from symbalance.engine.builders import from_firing_order as from_firing_order
    from symbalance.engine.builders import inline as inline
    from symbalance.engine.builders import radial as radial
    from symbalance.engine.builders import vee as vee
    from symbalance.engine.builders import vr as vr
    from symbalance.engine.builders import w as w
    from symbalance.engine.catalogue import load as load
    from symbalance.engine.catalogue import presets as presets
    from symbalance.engine.cylinders import Cylinder as Cylinder
    from symbalance.engine.engine_writing import engine_text as engine_text
    from symbalance.engine.layout import Layout as Layout
    from symbalance.engine.stars import crank_stars as crank_stars
    from symbalance.engine.stars import firing_orders as firing_orders
    from symbalance.engine.stars import natural_bank_angles as natural_bank_angles
    from symbalance.engine.stars import pin_offsets as pin_offsets
    from symbalance.engine.trains import CrankTrain as CrankTrain
    from symbalance.engine.trains import Link as Link
    from symbalance.errors import SymbalanceError as SymbalanceError
    from symbalance.exact.angles import Angle as Angle
    from symbalance.exact.angles import degrees as degrees
    from symbalance.forces.resultants import Balance as Balance
    from symbalance.forces.resultants import balance as balance
    from symbalance.forces.shafts import shaft_moment as shaft_moment
    from symbalance.forces.summation import inline_couple as inline_couple
    from symbalance.forces.summation import inline_sum as inline_sum
    from symbalance.kinematics.derivation import derive as derive
    from symbalance.kinematics.mechanisms import LinkRod as LinkRod
    from symbalance.kinematics.mechanisms import RodSplit as RodSplit
    from symbalance.kinematics.mechanisms import SliderCrank as SliderCrank
    from symbalance.kinematics.mechanisms import dead_centres as dead_centres
    from symbalance.kinematics.mechanisms import force_harmonics as force_harmonics
    from symbalance.kinematics.slider_crank import exact_coefficient as exact_coefficient
    from symbalance.kinematics.slider_crank import harmonics as harmonics
    from symbalance.kinematics.truncation import left_out as left_out
    from symbalance.notes.checking import check_equal as check_equal
    from symbalance.notes.checking import report_json as report_json
    from symbalance.notes.checking import report_latex as report_latex
    from symbalance.notes.checking import report_text as report_text
    from symbalance.torque import crank_torque as crank_torque
    from symbalance.torque import firing_stars as firing_stars
    from symbalance.torque import gas_torque as gas_torque
    from symbalance.torque import ideal_cycle as ideal_cycle
    from symbalance.torque import inertia_torque as inertia_torque
    from symbalance.torque import pressure_trace as pressure_trace
    from symbalance.torque import read_pressure as read_pressure
    from symbalance.torque import roll_moment as roll_moment
    from symbalance.torque import torque_report as torque_report
