r"""One order with symbols for masses, stations, radii, rods or offsets, as LaTeX."""

from __future__ import annotations

import sympy

from symbalance.design.variations import SymbolicOrder
from symbalance.document.latex_parts import in_document
from symbalance.forces.wide_formulas import broken
from symbalance.kinematics.series_printing import series_latex


def symbolic_latex(order: SymbolicOrder, *, standalone: bool = False) -> str:
    """Return the vertical and lateral parts of force and couple, long sums broken between their terms."""
    n = order.order
    unit = r"\omega^2" if order.coefficient is None else rf"A_{{{n}}}\,\omega^2"
    harmonic = rf"{unit}\left(C \cos {_times(n)}\theta + S \sin {_times(n)}\theta\right)"
    blocks = [rf"Order \({n}\): each component is \({harmonic}\), \(\theta\) the crank angle;"]
    blocks[0] += (
        " a couple counts stations as they are given, in pitches of the cylinders if they are not."
    )
    if order.coefficient is not None:
        blocks.append(rf"\(A_{{{n}}} = {series_latex(order.coefficient, ellipsis=True)}\).")
    if order.through is not None:
        blocks.append(rf"Kept to the total power {order.through} of \(r/l\) and \(e/l\).")
    for name, resultant in (("Free force", order.force), ("Free couple", order.couple)):
        lines = [
            broken(rf"&\text{{{part}}}\ {letter}", sympy.latex(sympy.expand(value)))
            for part, component in (("vertical", resultant.vertical), ("lateral", resultant.lateral))
            for letter, value in (("C", component.cos), ("S", component.sin))
            if value != 0
        ]
        found = ["\\begin{align*}", " \\\\\n".join(lines), "\\end{align*}"] if lines else []
        blocks.append("\n".join([rf"\textbf{{{name}}}" + (":" if lines else ": none."), *found]))
    body = "\n\n".join(blocks)
    return in_document(body) if standalone else body + "\n"


def _times(n: int) -> str:
    return "" if n == 1 else str(n)
