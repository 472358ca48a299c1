r"""Results as LaTeX: amsmath and booktabs only, the conventions stated, nothing that runs off a page."""

from __future__ import annotations

import re

from symbalance.document.decimals import shown
from symbalance.document.expressions import latex, ratio_latex
from symbalance.document.latex_parts import escaped as _escaped
from symbalance.document.latex_parts import in_document
from symbalance.document.latex_parts import number as _number
from symbalance.document.latex_parts import tabulars as _tabulars
from symbalance.engine.balancer_facts import LATEX, balancer_lines
from symbalance.engine.facts import banks, degrees_text, firing, origin, strokes
from symbalance.engine.kinds import kind_columns, kind_legend
from symbalance.exact.angles import Angle
from symbalance.forces.resultants import Balance, Order
from symbalance.forces.roll_rows import roll_rows
from symbalance.forces.rows import IN_ONE_PLANE, Row, plane, rotating, rows
from symbalance.forces.wide_formulas import LONGEST_CELL, broken, exact_forms
from symbalance.kinematics.series_printing import series_latex
from symbalance.text.reals import Real

LONGEST_SERIES = 160
LONGEST_NUMERATOR = 30


def balance_latex(result: Balance, *, standalone: bool = False) -> str:
    """Return the engine, its free force, its free couple and the coefficients A_n."""
    body = f"{heading_latex(result)}\n\n\\medskip\n{resultants_latex(result)}"
    return in_document(body) if standalone else body + "\n"


def resultants_latex(result: Balance) -> str:
    """Return the free force, the free couple and the coefficients, without the engine's heading."""
    units = (r"\(F_n = A_n\, m r \omega^2\)", r"\(F_n a\)")
    if result.kinematics is None:
        units = (r"\(m r \omega^2\)", r"\(m r \omega^2 a\)")
    force = _resultant(result, "force", rf"\textbf{{Free force}}, unit {units[0]}")
    couple = _resultant(
        result, "couple", rf"\textbf{{Free couple}} about {plane(result)}, unit {units[1]}"
    )
    blocks = [*_kinds(result), force, couple, _roll(result), _coefficients(result)]
    return "\n\n\\medskip\n".join(block for block in blocks if block)


def _roll(result: Balance) -> str:
    found = roll_rows(result)
    unit = r"\(F_n r\)" if result.kinematics else r"\(m r^2 \omega^2\)"
    text = r"\textbf{Roll moment of the shafts} on the frame, positive in the sense of rotation"
    return "\n".join([f"{text}, unit {unit}:", _components(found)]) if found else ""


def heading_latex(balance: Balance) -> str:
    """Return what is said of an engine before its numbers."""
    layout, ratio = balance.layout, ""
    count, fires = len(layout.cylinders), firing(layout)
    noun = "cylinders" if count > 1 else "cylinder"
    sizes = [r"\(m\) is the reciprocating mass of one cylinder, \(r\) the crank radius,"]
    if balance.kinematics is None:
        first = layout.first.number
        sizes = [
            rf"\(m\) and \(r\) are the reciprocating mass and the crank radius of cylinder {first};",
            *(rf"{_mathematical(line)};" for line in kind_legend(layout)),
        ]
    elif balance.ratio is not None:
        ratio = rf", here \(\lambda = {_ratio(balance)}\)"
    return "\n".join(
        [
            rf"\textbf{{{_escaped(layout.name)}}}: {strokes(layout)}, {count} {noun},",
            rf"{banks(layout, _angle)}{f', firing {_escaped(fires)}' if fires else ''}.\\",
            rf"Convention: \(\lambda = l/r\), connecting rod length over crank radius{ratio};",
            r"\(\theta\) is the crank angle, angles positive in the sense of rotation from straight up,",
            rf"clockwise seen from the front; \(\theta = 0\) has {origin(layout, _angle)};",
            *sizes,
            r"\(a\) the pitch of the cylinders; forces are positive upwards and to the right,",
            r"seen from the front; couples are positive with the front pushed up or right.",
            *(f"{line[0].upper()}{line[1:]}." for line in balancer_lines(layout, LATEX)),
            r"Order \(n\) reads",
            r"\(C \cos n\theta + S \sin n\theta = \text{amplitude} \cdot \cos(n\theta - \text{phase})\).",
        ]
    )


def _mathematical(line: str) -> str:
    """Return a line of the legend, its letters in math mode."""
    letters, _, meaning = line.partition(": ")
    names = [rf"\({letter.replace('ψ', chr(92) + 'psi')}\)" for letter in letters.split(", ")]
    return rf"{' and '.join(names)}: {meaning.replace('+', r'positive')}"


def _kinds(balance: Balance) -> list[str]:
    """Return the table of cylinders by kind, if there are several."""
    if balance.kinematics:
        return []
    columns = kind_columns(balance.layout)
    rows = zip(*(column.cells for column in columns), strict=True)
    lines = [" & ".join(_kind_cell(cell) for cell in row) for row in rows]
    head = " & ".join(column.latex for column in columns)
    return ["\\textbf{Cylinders by kind}:\n" + _tabulars("l" * len(columns), head, lines)]


def _kind_cell(cell: str) -> str:
    number = cell.rstrip("°")
    if not re.fullmatch(r"-?[0-9.]+(e[+-]?[0-9]+)?", number):
        return cell.replace("...", r"\dots")
    return rf"\({_number(number)}{r'^' + chr(92) + 'circ' if cell != number else ''}\)"


def _angle(bank: Angle) -> str:
    return rf"\({latex(bank.expression())}\)" if bank.symbols else rf"\({degrees_text(bank)}^\circ\)"


def _resultant(balance: Balance, name: str, title: str) -> str:
    found = rows(balance, name)
    if not found:
        return rf"{title}: none, to order {balance.highest}."
    return "\n".join([rf"{title}:", _components(found), _rotating(balance, name)])


def _components(found: list[Row]) -> str:
    columns, head = "rlccccc", r"\(n\) & component & \(C\) & \(S\) & amplitude & \(\approx\) & phase"
    if any(row.is_decimal for row in found):
        columns, head = "rlllll", r"\(n\) & component & \(C\) & \(S\) & amplitude & phase"
    table = _tabulars(columns, head, [_row(row) for row in found])
    return "\n".join([table, *exact_forms([row for row in found if not row.is_decimal])])


def _row(row: Row) -> str:
    exact, decimals = [latex(e) for e in row.exact()], row.decimals()
    if row.is_decimal and decimals is not None:
        cos, sin, amplitude = (rf"\({_number(d)}\)" for d in decimals[:3])
        return " & ".join([str(row.order), row.name, cos, sin, amplitude, _phase(row, decimals[3])])
    cells, nearly = [], r"\approx "
    for i, formula in enumerate(exact):
        if decimals is None:
            cells.append(rf"\({formula}\)" if len(formula) <= LONGEST_CELL else "below")
        elif i == 2 and len(formula) > LONGEST_CELL:
            cells.append("")
        elif len(formula) > LONGEST_CELL or r"\operatorname{atan2}" in formula:
            cells.append(rf"\({nearly if i == 3 else ''}{_number(decimals[i])}\)")
        else:
            cells.append(rf"\({formula}\)")
    near = "" if decimals is None else rf"\({_number(decimals[2])}\)"
    return " & ".join([str(row.order), row.name, *cells[:3], near, cells[3]])


def _rotating(balance: Balance, name: str) -> str:
    """Return the parts that turn with and against the crank, one line an order."""
    pairs = rotating(balance, name)
    if not pairs:
        return f"{IN_ONE_PLANE[0].upper()}{IN_ONE_PLANE[1:]}."
    head = r"\(n\) & forward (with the crank) & phase & backward (against it) & phase"
    lines = [" & ".join([str(f.order), *_turning(f), *_turning(b)]) for f, b in pairs]
    return "As rotating parts:\n" + _tabulars("rcccc", head, lines)


def _phase(row: Row, decimal: str) -> str:
    plain = row.phase_in_turns()
    return rf"\({_number(decimal) if plain is None else latex(plain)}\)"


def _turning(row: Row) -> list[str]:
    if row.component.is_zero():
        return [r"\(0\)", ""]
    exact, decimals = [latex(e) for e in row.exact()], row.decimals()
    if decimals is None:
        return [rf"\({e}\)" if len(e) <= LONGEST_CELL else "long" for e in exact[2:]]
    if row.is_decimal:
        return [rf"\({_number(decimals[2])}\)", _phase(row, decimals[3])]
    amplitude, phase = (_number(d) for d in decimals[2:])
    if len(exact[2]) <= LONGEST_CELL and exact[2] != amplitude:
        amplitude = rf"{exact[2]} \approx {amplitude}"
    phase = rf"\approx {phase}" if "atan2" in exact[3] else exact[3]
    return [rf"\({amplitude}\)", rf"\({phase}\)"]


def _coefficients(balance: Balance) -> str:
    if balance.kinematics is None:
        return "Components hold the kinematics of their cylinders."
    if not balance.orders:
        return "No order survives, so no coefficient is needed."
    series = [_series(order) for order in balance.orders]
    title = r"\textbf{Coefficients of one cylinder}:"
    if max(map(len, series)) > LONGEST_SERIES:
        rows = [broken(rf"&A_{{{o.order}}}", s) for o, s in zip(balance.orders, series, strict=True)]
        return "\n".join([title, r"\begin{align*}", " \\\\\n".join(rows), r"\end{align*}"])
    values = [rf"\({_number(shown(v))}\)" for v in balance.values.values()]
    columns, head = "rl", r"\(n\) & \(A_n\) in powers of \(1/\lambda\)"
    if values:
        columns, head = "rll", rf"{head} & exact in \(\lambda\), at \(\lambda = {_ratio(balance)}\)"
    lines = [rf"{o.order} & \(\displaystyle {s}\)" for o, s in zip(balance.orders, series, strict=True)]
    lines = [" & ".join(pair) for pair in zip(lines, values, strict=True)] if values else lines
    return f"{title}\n{_tabulars(columns, head, lines, gap=12)}"


def _series(order: Order) -> str:
    """Return a coefficient's series; one whose numbers fill a line by its leading term, rounded."""
    assert order.coefficient is not None
    power, lead = min(order.coefficient.terms.items())
    if len(str(abs(lead.numerator))) <= LONGEST_NUMERATOR:
        return series_latex(order.coefficient, ellipsis=True)
    rounded = _number(shown(Real(lead)))
    return rf"{rounded}\ldots\,\lambda^{{-{power}}} + \cdots"


def _ratio(balance: Balance) -> str:
    ratio = balance.ratio
    return "" if ratio is None else ratio_latex(ratio)
