r"""A layout's torque as LaTeX: the tables of `torque_table`, with amsmath and booktabs alone."""

from __future__ import annotations

from symbalance.document.decimals import shown
from symbalance.document.expressions import latex, ratio_latex
from symbalance.document.latex_parts import escaped, in_document, number, tabulars
from symbalance.engine.facts import strokes
from symbalance.engine.kinds import kind_lines
from symbalance.forces.rows import Row
from symbalance.forces.wide_formulas import LONGEST_CELL
from symbalance.kinematics.series_printing import series_latex
from symbalance.torque import CrankTorque, TorqueBalance, TorqueReport
from symbalance.torque.torque_text import frame_parts, running_facts, running_head

UNITS = {"m r^2 omega^2": r"m r^2 \omega^2", "J_x omega^2": r"J_x\, \omega^2"}


def torque_latex(
    report: TorqueReport,
    running: CrankTorque | None = None,
    delta: float = 0.02,
    order: int = 12,
    *,
    standalone: bool = False,
) -> str:
    """Return a report of torque, and what a running engine makes of it, as LaTeX.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.torque import torque_report
    >>> print(torque_latex(torque_report(load("inline-6"), 3)).splitlines()[0])
    \\textbf{inline-6}: four-stroke, 6 cylinders.\\\\
    """
    title = rf"\textbf{{Inertia torque on the crank}}, unit \({_unit(report.inertia)}\):"
    parts = [_heading(report), f"{title}\n{_tables(report.inertia)}"]
    for name, part in frame_parts(report):
        parts.append(rf"\textbf{{{escaped(name)}}}, unit \({_unit(part)}\):" + "\n" + _tables(part))
    if running is not None:
        parts.append(_running(running, delta, order))
    body = "\n\n\\medskip\n".join(parts)
    return in_document(body) if standalone else body + "\n"


def _heading(report: TorqueReport) -> str:
    layout, count = report.layout, len(report.layout.cylinders)
    noun = "cylinders" if count > 1 else "cylinder"
    alike = report.inertia.kinematics is not None
    sizes = [r"\(m\) is the reciprocating mass of one cylinder, \(r\) the crank radius."]
    if not alike:
        sizes = [escaped("; ".join(kind_lines(layout))) + "."]
    ratio = "" if layout.ratio is None or not alike else rf", here \(\lambda = {_ratio(report)}\)"
    frame = "The frame gets the opposite."
    if not report.is_opposite:
        frame = "The frame gets the opposite; what it gets besides stands below."
    return "\n".join(
        [
            rf"\textbf{{{escaped(layout.name)}}}: {strokes(layout)}, {count} {noun}.\\",
            rf"Convention: \(\lambda = l/r\), connecting rod length over crank radius{ratio};",
            r"\(\theta\) is the crank angle; a torque is positive on the crank in the sense of rotation.",
            *sizes,
            frame,
            r"Order \(n\) reads",
            r"\(C \cos n\theta + S \sin n\theta = \text{amplitude} \cdot \cos(n\theta - \text{phase})\).",
        ]
    )


def _ratio(report: TorqueReport) -> str:
    """Return the rod ratio in math mode."""
    ratio = report.layout.ratio
    assert ratio is not None
    return ratio_latex(ratio)


def _unit(balance: TorqueBalance) -> str:
    unit = UNITS[balance.unit]
    if balance.kinematics is None:
        return unit
    letter = balance.kinematics.letter
    return rf"T_n = t_n\, {unit}" if letter == "t" else rf"{letter}_n\, {unit}"


def _tables(balance: TorqueBalance) -> str:
    if not balance.components:
        return f"none, to order {balance.highest}."
    rows = [_row(Row(n, "torque", c)) for n, c in balance.components.items()]
    head = r"\(n\) & \(C\) & \(S\) & amplitude & \(\approx\) & phase"
    table = tabulars("rccccc", head, rows)
    if balance.kinematics is None:
        return table
    letter, columns = balance.kinematics.letter, "rl"
    head = rf"\(n\) & \({letter}_n\) in powers of \(1/\lambda\)"
    values = [rf" & \({number(shown(v))}\)" for v in balance.values.values()]
    if values:
        columns, head = "rll", head + r" & exact in \(\lambda\)"
    lines = []
    for order, value in zip(balance.orders, values or [""] * len(balance.orders), strict=True):
        assert order.coefficient is not None
        series = series_latex(order.coefficient, ellipsis=True)
        lines.append(rf"{order.order} & \(\displaystyle {series}\){value}")
    return f"{table}\n\\textbf{{Coefficients of one cylinder}}:\n{tabulars(columns, head, lines, gap=12)}"


def _row(row: Row) -> str:
    decimals = row.decimals()
    if row.is_decimal and decimals is not None:
        cos, sin, amplitude, phase = (rf"\({number(d)}\)" for d in decimals)
        return " & ".join([str(row.order), cos, sin, amplitude, "", phase])
    cells = []
    for i, expression in enumerate(row.exact()):
        formula = latex(expression)
        if len(formula) > LONGEST_CELL and decimals is not None:
            formula = rf"\approx {number(decimals[i])}"
        cells.append(rf"\({formula}\)")
    near = "" if decimals is None else rf"\({number(decimals[2])}\)"
    return " & ".join([str(row.order), *cells[:3], near, cells[3]])


def _running(torque: CrankTorque, delta: float, order: int) -> str:
    facts = [rf"{name} & {escaped(value)} \\" for name, value in running_facts(torque, delta)]
    rows = []
    for n, cos, sin in torque.terms(order):
        size = (float(cos) ** 2 + float(sin) ** 2) ** 0.5
        rows.append(
            " & ".join([str(n), *(rf"\({number(f'{float(x):.6g}')}\)" for x in (cos, sin, size))])
        )
    table = tabulars("rccc", r"\(n\) & \(C\) & \(S\) & amplitude", rows) if rows else "none."
    title = rf"\textbf{{{escaped(running_head(torque))}}}:"
    words = "\n".join(
        [r"\begin{center}\begin{tabular}{@{}lp{120mm}@{}}", *facts, r"\end{tabular}\end{center}"]
    )
    return f"{title}\n{words}\nOrders of the whole torque, N\\,m:\n{table}"
