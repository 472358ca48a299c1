"""What is written of a balance: the free force and couple by order, then what its letters mean."""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.document.decimals import shown
from symbalance.document.expressions import formula_of
from symbalance.document.formula import Decimal, Formula, Name, Subscript, Words, cos, equal, number, sin
from symbalance.document.nodes import (
    Block,
    Cell,
    Column,
    Document,
    Exact,
    Facts,
    Paragraph,
    Table,
    blocks,
)
from symbalance.document.nodes import Words as Said
from symbalance.document.text_writer import formula_text
from symbalance.engine.balancer_facts import balancer_facts
from symbalance.engine.engine import Engine
from symbalance.engine.facts import banks, firing, origin, strokes
from symbalance.engine.kinds import kind_facts, kind_table
from symbalance.forces.resultants import Balance
from symbalance.forces.roll_rows import roll_rows
from symbalance.forces.rows import IN_ONE_PLANE, Row, plane, rotating, rows
from symbalance.kinematics.series_printing import series_formula
from symbalance.text.numbers import short_text

LONGEST_PHASE = 8
"""A phase that takes more characters, an atan2 or a fine fraction of pi, is written rounded."""
SHORT = 14
"""An exact amplitude of a rotating part that takes more characters is written rounded."""
_M, _R, _L, _A, _N = Name("m"), Name("r"), Name("l"), Name("a"), Name("n")
_OMEGA, _THETA, _LAM = Name("omega"), Name("theta"), Name("lam")
_A_N, _F_N = Subscript(Name("A"), _N), Subscript(Name("F"), _N)
_MR = _M * _R * _OMEGA**2


def balance_document(balance: Balance) -> Document:
    """Return a balance as a document: the components that are free, the coefficients, the conventions."""
    return Document(engine_title(balance.layout), resultant_blocks(balance) + conventions(balance))


def engine_title(layout: Engine) -> str:
    """Return an engine in a line: its name, strokes, cylinders and banks."""
    count = len(layout.cylinders)
    return (
        f"{layout.name}: {strokes(layout)}, {count} cylinder{'s' if count > 1 else ''}, {banks(layout)}"
    )


def resultant_blocks(balance: Balance) -> tuple[Block, ...]:
    """Return the free force, the free couple, the shafts' roll moment and the coefficients."""
    alike = balance.kinematics is not None
    force = equal(_F_N, _A_N * _MR) if alike else _MR
    couple = _F_N * _A if alike else _MR * _A
    return blocks(
        _resultant(balance, "force", ("Free force, unit ", force)),
        _resultant(balance, "couple", (f"Free couple about {plane(balance)}, unit ", couple)),
        _roll(balance),
        _coefficients(balance),
    )


def conventions(balance: Balance) -> tuple[Block, ...]:
    """Return what an engine's letters, signs and angles mean, and what it is balanced by."""
    layout = balance.layout
    fires = firing(layout)
    entries: list[tuple[Said, Said]] = [("fires", fires)] if fires else []
    entries.append(((_THETA, " = 0"), f"{origin(layout)}; θ runs clockwise seen from the front"))
    if balance.kinematics:
        ratio = "" if balance.ratio is None else f", here {short_text(balance.ratio)}"
        entries += [
            (equal(_LAM, _L / _R), f"connecting rod over crank radius{ratio or ', not given'}"),
            (
                (_M, ", ", _R, ", ", _A),
                "reciprocating mass of one cylinder, crank radius, cylinder pitch",
            ),
        ]
    else:
        first = layout.first.number
        entries.append(((_M, ", ", _R), f"reciprocating mass and crank radius of cylinder {first}"))
        entries.append((_A, "cylinder pitch"))
        entries += kind_facts(layout)
    entries += [("balanced by", said) for said in balancer_facts(layout)]
    entries += [
        SIGNS,
        ("order n", WAVE),
    ]
    facts = Facts(tuple(entries), "How to read it")
    return (facts,) if balance.kinematics else (kind_table(layout), facts)


SIGNS = ("signs", "+ is up or right seen from the front; a couple + pushes the front up or right")
"""What directions and couples count as positive."""
_ANGLE = _N * _THETA
WAVE = equal(
    Name("C") * cos(_ANGLE) + Name("S") * sin(_ANGLE), Words("amplitude") * cos(_ANGLE - Words("phase"))
)
"""What an order's coefficients, amplitude and phase are."""


def _resultant(balance: Balance, name: str, title: Said) -> tuple[Block, ...]:
    kept = rows(balance, name)
    table = component_table(title, kept, empty=f"none, to order {balance.highest}")
    return (table, *_rotating(balance, name)) if kept else (table,)


def _roll(balance: Balance) -> tuple[Block, ...]:
    kept = roll_rows(balance)
    unit = _F_N * _R if balance.kinematics else _M * _R**2 * _OMEGA**2
    title = ("Roll moment of the shafts on the frame, + in the sense of rotation, unit ", unit)
    return (component_table(title, kept),) if kept else ()


_HEAD = (
    Column("order"),
    Column("component"),
    Column(cos(_ANGLE), "cos"),
    Column(sin(_ANGLE), "sin"),
    Column("amplitude"),
    Column("phase"),
)


def component_table(title: Said, kept: Sequence[Row], empty: str = "none") -> Table:
    """Return a table of components, exact where there is room, in decimals where there is not."""
    return Table(title, _HEAD, tuple(map(_cells, kept)), keys=2, empty=empty)


def _cells(row: Row) -> tuple[Cell, ...]:
    decimals = row.decimals()
    head = (number(row.order), row.name)
    if row.is_decimal and decimals is not None:
        cosine, sine, amplitude = (Decimal(d) for d in decimals[:3])
        return (*head, cosine, sine, amplitude, _phase(row, decimals[3]))
    values = [formula_of(part) for part in row.exact()]
    if decimals is None:
        return (*head, *map(Exact, values))
    near = [Decimal(d) for d in decimals]
    amplitude = Exact(values[2], near[2], beside=decimals[2] != formula_text(values[2]))
    return (
        *head,
        Exact(values[0], near[0]),
        Exact(values[1], near[1]),
        amplitude,
        _short_phase(values[3], decimals[3]),
    )


def _short_phase(value: Formula, decimal: str) -> Said:
    return value if len(formula_text(value)) <= LONGEST_PHASE else ("≈ ", Decimal(decimal))


def _phase(row: Row, decimal: str) -> Formula:
    plain = row.phase_in_turns()
    return Decimal(decimal) if plain is None else formula_of(plain)


def _rotating(balance: Balance, name: str) -> tuple[Block, ...]:
    """Return the parts that turn with and against the crank, a row for each order."""
    pairs = rotating(balance, name)
    if not pairs:
        return (Paragraph(IN_ONE_PLANE),)
    columns = (
        Column("order"),
        Column("forward (with the crank)"),
        Column("phase"),
        Column("backward (against it)"),
        Column("phase"),
    )
    cells = tuple((number(f.order), *_turning(f), *_turning(b)) for f, b in pairs)
    return (Table("as rotating parts", columns, cells),)


def _turning(row: Row) -> tuple[Cell, Cell]:
    if row.component.is_zero():
        return number(0), ""
    decimals = row.decimals()
    if row.is_decimal and decimals is not None:
        return Decimal(decimals[2]), _phase(row, decimals[3])
    amplitude, phase = (formula_of(part) for part in row.exact()[2:])
    if decimals is None:
        return Exact(amplitude), Exact(phase)
    near = Decimal(decimals[2])
    if len(formula_text(amplitude)) > SHORT:
        return near, _short_phase(phase, decimals[3])
    beside = decimals[2] != formula_text(amplitude)
    return Exact(amplitude, near, beside), _short_phase(phase, decimals[3])


def _coefficients(balance: Balance) -> tuple[Block, ...]:
    if not balance.orders or balance.kinematics is None:
        return ()
    at: Said = (
        "" if balance.ratio is None else (_A_N, " at ", equal(_LAM, Decimal(short_text(balance.ratio))))
    )
    cells = []
    for order in balance.orders:
        assert order.coefficient is not None
        value = balance.values.get(order.order)
        written = "" if value is None else Decimal(shown(value))
        cells.append((number(order.order), series_formula(order.coefficient, ellipsis=True), written))
    columns = (Column("order"), Column((_A_N, " in powers of ", 1 / _LAM)), Column(at))
    return (
        Table("Coefficients of one cylinder (the value is exact in λ, rounded)", columns, tuple(cells)),
    )
