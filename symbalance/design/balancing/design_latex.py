r"""A design as pages of a report: layout, what is free, the proposal, its certificate, what remains."""

from __future__ import annotations

import sympy

from symbalance.design.balancing import Design
from symbalance.design.balancing.design_facts import (
    VERDICTS,
    PlacedWeight,
    by_order,
    left_ellipses,
    name,
    shape,
    summary,
    weights,
)
from symbalance.design.balancing.ellipses import Ellipse
from symbalance.document.expressions import latex
from symbalance.document.latex_parts import in_document, tabulars
from symbalance.document.latex_parts import number as number_latex
from symbalance.engine.balancer_facts import LATEX, direction, nearly, rounded, size
from symbalance.forces.balance_latex import heading_latex, resultants_latex
from symbalance.forces.resultants import balance
from symbalance.forces.wide_formulas import LONGEST_CELL
from symbalance.text.reals import pi

_KEPT = r"\begingroup\makeatletter\@beginparpenalty=10000\relax\makeatother"
"""Keeps the title of a table on its page."""


def design_latex(design: Design, *, standalone: bool = False) -> str:
    """Return a design as LaTeX, `standalone` as a document; a fragment needs amsmath and booktabs."""
    blocks = [
        r"{\large\textbf{Balancing}}",
        rf"\textbf{{Engine.}} {heading_latex(design.before)}",
        r"\textbf{Free in the layout as it is}, of the orders to remove." + _before(design),
        rf"\textbf{{Proposal.}} {summary(design)}",
        _proposed(design),
        _certificate(design),
        _left(design),
        rf"\textbf{{What remains}}, to order {design.remains.highest}."
        "\n\n" + resultants_latex(design.remains),
    ]
    body = f"{_KEPT}\n" + "\n\n\\medskip\n".join(block for block in blocks if block) + "\n\\endgroup"
    return in_document(body) if standalone else body + "\n"


def _before(design: Design) -> str:
    return "\n\n" + resultants_latex(balance(design.layout, design.remove[-1]))


def _proposed(design: Design) -> str:
    if not design.devices:
        return ""
    coefficient = "A_n" if design.layout.has_common_harmonics else ""
    lines = [
        rf"A share \(s\) at speed \(n\) is the unbalance \(U = s\,{coefficient}\, m r/n^2\)"
        r" (mass times radius); a speed below 0 turns against the crank;",
        r"directions are those at \(\theta = 0\), from straight up.",
    ]
    if any(d.on_crank and not d.weights for d in design.devices):
        lines.append("Every throw: a counterweight for its rotating and half its reciprocating mass.")
    elif any(c.overbalance is not None for c in design.balanced.balancers.counterweights):
        lines.append("Every throw besides has a counterweight for its rotating mass.")
    rows = [_row(weight) for weight in weights(design)]
    if rows:
        sizes = any(row[-1] for row in rows)
        head = r"speed & on the & station & share & \(\approx\) & direction"
        head += r" & \(U\), kg\,mm" if sizes else ""
        columns = "rlrccc" + ("r" if sizes else "")
        cells = [" & ".join(row if sizes else row[:-1]) for row in rows]
        lines.append(tabulars(columns, head, cells, gap=6 if any(r"\frac" in c for c in cells) else 2))
    return "\n".join(lines)


def _row(weight: PlacedWeight) -> list[str]:
    exact, near = size(weight.vector, LATEX), nearly(weight.vector, LATEX)
    unbalance = "" if weight.unbalance is None else rf"\({number_latex(rounded(weight.unbalance))}\)"
    return [
        rf"\({weight.device.speed:+d}\)",
        name(weight.device),
        rf"\({weight.station}\)",
        rf"\({exact}\)",
        rf"\({number_latex(near)}\)" if near else "",
        direction(weight.vector, LATEX),
        unbalance,
    ]


def _certificate(design: Design) -> str:
    head = "order & & with the crank & against it"
    rows = [
        " & ".join([str(n), kind, *(VERDICTS[c.verdict] for c in pair)])
        for n, kind, pair in by_order(design)
    ]
    text = r"\textbf{Certificate}: the engine with this built in, balanced anew, has"
    return f"{text}\n{tabulars('rlll', head, rows)}"


def _left(design: Design) -> str:
    found = left_ellipses(design)
    if not found:
        return ""
    head = "order & & long semi-axis & short & direction & drawn"
    rows = [" & ".join(_ellipse(kind, left)) for kind, left in found]
    return "\\textbf{Left of the orders to remove}:\n" + tabulars("rlcccl", head, rows)


def _ellipse(kind: str, left: Ellipse) -> list[str]:
    axes = [_axis(left, i) for i in range(2)]
    tilt = "" if left.shape == "circle" else _degrees(left)
    return [str(left.order), kind, *axes, tilt, shape(left)]


def _axis(left: Ellipse, which: int) -> str:
    axis = (left.major, left.minor)[which]
    formula = latex(axis)
    if len(formula) <= LONGEST_CELL or axis.free_symbols:
        return rf"\({formula}\)"
    return rf"\(\approx {number_latex(rounded(left.decimal_axes[which]))}\)"


def _degrees(left: Ellipse) -> str:
    turned = left.direction * 180 / sympy.pi
    if turned.is_Rational:
        return rf"\({latex(turned)}^\circ\)"
    if turned.free_symbols:
        return rf"\({latex(left.direction)}\)"
    return rf"\(\approx {float(left.decimal_direction * 180 / pi()):.5g}^\circ\)"
