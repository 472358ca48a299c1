r"""Results as LaTeX: amsmath and booktabs only, the conventions stated, nothing that runs off a page."""

from __future__ import annotations

from functools import singledispatch
from typing import Any

import sympy

from symbalance.design.balancing import Design
from symbalance.design.balancing.design_latex import design_latex
from symbalance.design.variations import SymbolicOrder
from symbalance.design.variations.symbolic_latex import symbolic_latex
from symbalance.document.expressions import latex
from symbalance.errors import SymbalanceError
from symbalance.exact.spectrum import Component
from symbalance.forces.balance_latex import balance_latex
from symbalance.forces.resultants import Balance
from symbalance.kinematics.derivation import Derivation, derivation_latex
from symbalance.kinematics.series_printing import series_latex
from symbalance.kinematics.slider_crank import Series
from symbalance.torque import TorqueReport
from symbalance.torque.torque_latex import torque_latex


@singledispatch
def to_latex(result: Any, *, standalone: bool = False) -> str:
    r"""Return LaTeX of a balance, design, torque report, derivation, component, series or expression.

    `standalone` wraps a balance, a torque report or a derivation in a complete document; a fragment needs
    amsmath and booktabs. Components, series and expressions give a formula for math mode.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> print(to_latex(acceleration_series(6, 7)))
    \frac{9}{128 \lambda^{5}} + \frac{45}{512 \lambda^{7}} + \cdots
    """
    raise SymbalanceError(type(result).__name__, "has no LaTeX form", "give a balance or a derivation")


@to_latex.register
def _(result: Design, *, standalone: bool = False) -> str:
    return design_latex(result, standalone=standalone)


@to_latex.register
def _(result: SymbolicOrder, *, standalone: bool = False) -> str:
    return symbolic_latex(result, standalone=standalone)


@to_latex.register
def _(result: Series, *, standalone: bool = False) -> str:
    return series_latex(result, ellipsis=True)


@to_latex.register
def _(result: sympy.Expr, *, standalone: bool = False) -> str:
    return latex(result)


@to_latex.register
def _(result: Component, *, standalone: bool = False) -> str:
    return rf"{latex(result.cos)} \cos n\theta + {_bracketed(latex(result.sin))} \sin n\theta"


def _bracketed(formula: str) -> str:
    return rf"\left({formula}\right)" if formula.startswith("-") or " + " in formula else formula


@to_latex.register
def _(result: Derivation, *, standalone: bool = False) -> str:
    return derivation_latex(result, standalone=standalone)


@to_latex.register
def _(result: TorqueReport, *, standalone: bool = False) -> str:
    return torque_latex(result, standalone=standalone)


@to_latex.register
def _(result: Balance, *, standalone: bool = False) -> str:
    return balance_latex(result, standalone=standalone)
