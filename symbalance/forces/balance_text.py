"""A balance as a table for a terminal of 80 columns."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap

from symbalance.document.decimals import shown
from symbalance.document.expressions import text
from symbalance.document.grid import WIDTH, grid
from symbalance.engine.balancer_facts import balancer_lines
from symbalance.engine.engine import Engine
from symbalance.engine.facts import banks, degrees_text, firing, origin, strokes
from symbalance.engine.kinds import kind_columns, kind_legend
from symbalance.exact.angles import Angle
from symbalance.forces.resultants import Balance, checked_balance
from symbalance.forces.roll_rows import roll_rows
from symbalance.forces.rows import IN_ONE_PLANE, Row, plane, rotating, rows
from symbalance.kinematics.series_printing import series_text
from symbalance.text.numbers import short_text

SHORT = 14
"""An exact form up to this long stays in the table, whatever becomes of its column."""
LONGEST_PHASE = 8
"""A phase that takes more, an atan2 or a fine fraction of pi, is printed rounded, in radians."""
_HEAD = ("order", "component", "cos nθ", "sin nθ", "amplitude", "≈", "phase")
_EXACT = (2, 3, 4)
_LEGEND = (
    "+ is up or right seen from the front; a couple + pushes the front up or right",
    "C cos nθ + S sin nθ = amplitude · cos(nθ − phase)",
)


def balance_text(balance: Balance) -> str:
    """Return the engine, its free force, its free couple, the coefficients A_n."""
    checked_balance(balance)
    return f"{heading_text(balance)}\n\n{resultants_text(balance)}"


def resultants_text(balance: Balance) -> str:
    """Return the free force, the free couple and the coefficients, without the engine's heading."""
    force, couple = ("Fₙ = Aₙ m r ω²", "Fₙ a") if balance.kinematics else ("m r ω²", "m r ω² a")
    blocks = [
        _kinds(balance),
        _resultant(balance, "force", f"Free force, unit {force}"),
        _resultant(balance, "couple", f"Free couple about {plane(balance)}, unit {couple}"),
        _roll(balance),
        _coefficients(balance),
    ]
    return "\n\n".join(block for block in blocks if block) + "\n"


def heading_text(balance: Balance) -> str:
    """Return what is said of an engine before its numbers."""
    layout = balance.layout
    count, fires = len(layout.cylinders), firing(layout)
    lines = [
        f"{layout.name}: {strokes(layout)}, {count} cylinder{'s' if count > 1 else ''}, "
        f"{banks(layout, _angle)}",
        *([f"fires {fires}"] if fires else []),
        f"θ (clockwise seen from the front) = 0: {origin(layout, _angle)}",
        *(_like(balance) if balance.kinematics else _unlike(layout)),
        *(line.replace("-", "−") for line in balancer_lines(layout)),
        *_LEGEND,
    ]
    return "\n".join(part for line in lines for part in _wrapped(line, "  "))


def _like(balance: Balance) -> list[str]:
    ratio = "not given" if balance.ratio is None else short_text(balance.ratio)
    return [
        f"λ = l/r (rod over crank radius): {ratio}",
        "m: reciprocating mass of one cylinder, r: crank radius, a: cylinder pitch",
    ]


def _unlike(layout: Engine) -> list[str]:
    first = layout.first.number
    return [
        f"m, r: reciprocating mass and crank radius of cylinder {first}; a: cylinder pitch",
        *kind_legend(layout),
    ]


def _kinds(balance: Balance) -> str:
    """Return the table of cylinders by kind."""
    if balance.kinematics:
        return ""
    columns = kind_columns(balance.layout)
    table = [[column.text for column in columns]]
    table += [list(row) for row in zip(*(column.cells for column in columns), strict=True)]
    lines = grid([[cell.replace("-", "−").replace("...", "…") for cell in row] for row in table])
    return "\n".join(["Cylinders by kind", *lines])


def _angle(bank: Angle) -> str:
    return text(bank.expression()) if bank.symbols else degrees_text(bank).replace("-", "−") + "°"


def _wrapped(line: str, indent: str) -> list[str]:
    return wrap(line, WIDTH, subsequent_indent=indent, break_on_hyphens=True) or [line]


def _resultant(balance: Balance, name: str, title: str) -> str:
    found = rows(balance, name)
    if not found:
        return f"{title}\n  none, to order {balance.highest}"
    return "\n".join([title, *_components(found), *_rotating(balance, name)])


def _roll(balance: Balance) -> str:
    found = roll_rows(balance)
    unit = "Fₙ r" if balance.kinematics else "m r² ω²"
    title = f"Roll moment of the shafts on the frame, + in the sense of rotation, unit {unit}"
    return "\n".join([title, *_components(found)]) if found else ""


def _components(found: Sequence[Row]) -> list[str]:
    """Return the table of components; columns too wide for a line go to decimals, and below it."""
    table = [[*_HEAD], *(_cells(row) for row in found)]
    below: list[int] = []
    while _width(table) > WIDTH and len(below) < len(_EXACT):
        column = max((c for c in _EXACT if c not in below), key=lambda c: max(len(r[c]) for r in table))
        below.append(column)
        table = [[*_HEAD], *(_cells(row, below) for row in found)]
    if _width(table) <= WIDTH:
        return grid(table) + _exact_lines(found, below)
    table = [[*_HEAD], *(_cells(row, below, short=0) for row in found)]
    return grid(table) + _exact_lines(found, below, short=0)


def _width(table: Sequence[Sequence[str]]) -> int:
    return max(map(len, grid(table)))


def _cells(row: Row, below: Sequence[int] = (), short: int = SHORT) -> list[str]:
    decimals = row.decimals()
    if row.is_decimal and decimals is not None:
        cos, sin, amplitude, _ = (d.replace("-", "−") for d in decimals)
        return [str(row.order), row.name, cos, sin, amplitude, "", _phase(row, decimals[3])]
    exact = [text(e) for e in row.exact()]
    cells = [str(row.order), row.name, *exact[:3], "", exact[3]]
    if decimals is None:
        return ["see below" if i in below and len(c) > short else c for i, c in enumerate(cells)]
    cos, sin, amplitude, phase = (d.replace("-", "−") for d in decimals)
    if amplitude != exact[2]:
        cells[5] = amplitude
    if len(exact[3]) > LONGEST_PHASE:
        cells[6] = f"≈ {phase}"
    nearly = {2: cos, 3: sin, 4: ""}
    return [nearly[i] if i in below and len(c) > short else c for i, c in enumerate(cells)]


def _exact_lines(found: Sequence[Row], below: Sequence[int], short: int = SHORT) -> list[str]:
    """Return the exact forms left out of a table, each once, with all the places it belongs to."""
    places: dict[tuple[str, str], list[str]] = {}
    for row in found:
        for column in () if row.is_decimal else sorted(below):
            formula = text(row.exact()[column - 2])
            if len(formula) > max(short, 3):
                what = f"{row.name} {_HEAD[column].split()[0]}"
                places.setdefault((formula, what), []).append(str(row.order))
    lines = [
        part
        for (formula, what), orders in places.items()
        for part in _wrapped(f"  {_named(orders)} {what} = {formula}", "      ")
    ]
    return ["  exactly:", *lines] if lines else []


def _named(orders: Sequence[str]) -> str:
    return f"order{'s' if len(orders) > 1 else ''} {', '.join(orders)}"


def _rotating(balance: Balance, name: str) -> list[str]:
    """Return the parts that turn with and against the crank, one line an order."""
    pairs = rotating(balance, name)
    if not pairs:
        return [f"  {IN_ONE_PLANE}"]
    head = ["order", "forward (with the crank)", "phase", "backward (against it)", "phase"]
    table = [head, *([str(f.order), *_turning(f), *_turning(b)] for f, b in pairs)]
    if _width(table) > WIDTH:
        short = ["order", "forward (with crank)", "phase", "backward (against)", "phase"]
        table = [short, *([str(f.order), *_turning(f, 0), *_turning(b, 0)] for f, b in pairs)]
    return ["", "  as rotating parts", *grid(table)]


def _phase(row: Row, decimal: str) -> str:
    plain = row.phase_in_turns()
    return decimal.replace("-", "−") if plain is None else text(plain)


def _turning(row: Row, longest: int = SHORT) -> list[str]:
    if row.component.is_zero():
        return ["0", ""]
    exact, decimals = [text(e) for e in row.exact()], row.decimals()
    if decimals is None:
        return [exact[2], exact[3]]
    if row.is_decimal:
        return [decimals[2], _phase(row, decimals[3])]
    amplitude, phase = (d.replace("-", "−") for d in decimals[2:])
    if len(exact[2]) <= longest and exact[2] != amplitude:
        amplitude = f"{exact[2]} ≈ {amplitude}"
    return [amplitude, f"≈ {phase}" if len(exact[3]) > LONGEST_PHASE else exact[3]]


def _coefficients(balance: Balance) -> str:
    if not balance.orders or balance.kinematics is None:
        return ""
    at = "" if balance.ratio is None else f"at λ = {short_text(balance.ratio)}"
    table = []
    for order in balance.orders:
        assert order.coefficient is not None
        series = series_text(order.coefficient, ellipsis=True)
        value = balance.values.get(order.order)
        table.append([str(order.order), series, "" if value is None else shown(value).replace("-", "−")])
    lines = grid([["order", "Aₙ in powers of 1/λ", f"Aₙ {at}"], *table])
    if max(map(len, lines)) > WIDTH:
        lines = [line for n, series, value in table for line in _listed(n, series, value, at)]
    return "\n".join(["Coefficients of one cylinder (the value is exact in λ, rounded)", *lines])


def _listed(order: str, series: str, value: str, at: str) -> list[str]:
    """Return one coefficient as wrapped lines, for series too long for a row."""
    lines = _wrapped(f"  A_{order} = {series}", "      ")
    return [*lines, f"      = {value} {at}"] if value else lines
