"""The document of a torque: orders on crank and frame, then the meaning of its letters."""

from __future__ import annotations

from symbalance.document.decimals import decimal, short_decimal
from symbalance.document.formula import Decimal, Equation, Formula, Name, Subscript, equal
from symbalance.document.nodes import (
    Block,
    Cell,
    Column,
    Document,
    Facts,
    Heading,
    Paragraph,
    Table,
    Words,
    blocks,
)
from symbalance.engine.engine import Engine
from symbalance.engine.engine_document import (
    ORDER,
    balancer_entries,
    engine_words,
    group_table,
    origin_facts,
    size_facts,
)
from symbalance.forces.balance_document import (
    SHOWN,
    Measured,
    coefficient_table,
    component_table,
    operating_facts,
    value_fact,
)
from symbalance.forces.rows import Row
from symbalance.kinematics.coefficients import INERTIA, OF_RODS
from symbalance.text.reals import hypot
from symbalance.torque.body_groups import has_common_torque
from symbalance.torque.inertia_balance import MILLI, TorqueBalance, first_excess
from symbalance.torque.roll import TorqueReport, excesses
from symbalance.torque.running_document import running_blocks, running_facts, running_title

_N, _T, _J = Name("n"), Name("T"), Name("J_x")
_OMEGA_2 = Name("omega") ** 2
_UNITS = {INERTIA.unit: Name("m") * Name("r") ** 2 * _OMEGA_2, OF_RODS: _J * _OMEGA_2}
LEGEND = "How to read it"
SIGNS: tuple[Words, Words] = (
    "signs",
    "a torque is + on the crank in the sense of rotation, and so is a moment on the frame",
)


def torque_document(report: TorqueReport) -> Document:
    """Return a report as a document: the torque on crank and frame, the running engine's, the legend."""
    engine, running = report.engine, report.running
    title, lead = f"{engine.name}: torque on crank and frame", engine_words(engine)
    inertia = _report_blocks(report)
    if running is None:
        gas: tuple[Words, Words] = (
            "gas torque",
            "comes on top: it needs a pressure trace or an ideal cycle",
        )
        return Document(title, inertia + _legend(report.inertia, LEGEND, gas), lead)
    return Document(
        title,
        blocks(
            Heading("Inertia, order by order"),
            inertia,
            Heading(running_title(running)),
            running_blocks(running),
            Heading(LEGEND),
            _legend(report.inertia, "", *running_facts(running)),
        ),
        lead,
    )


def orders_document(balance: TorqueBalance) -> Document:
    """Return one torque or moment as a document: its orders, one cylinder's coefficients, the legend."""
    title = f"{balance.engine.name}: {balance.quantity}"
    body = blocks(
        _orders(balance),
        _coefficients(balance),
        _operating(balance),
        _legend(balance, LEGEND),
    )
    return Document(title, body, engine_words(balance.engine))


def _report_blocks(report: TorqueReport) -> tuple[Block, ...]:
    first, *others = report.parts()
    coefficients = [block for part in report.parts() for block in _coefficients(part)]
    return blocks(
        _orders(first),
        Paragraph(_frame_words(report)),
        tuple(map(_orders, others)),
        tuple(coefficients),
        _operating(report.inertia),
    )


def _frame_words(report: TorqueReport) -> str:
    if report.is_opposite:
        return "The frame gets the opposite."
    if report.frame is None:
        return "The frame gets the opposite, and moments of its own, whose sum needs more sizes."
    return "The frame gets the opposite, and the moments below; of gas torque it gets the opposite alone."


def _orders(balance: TorqueBalance) -> Table:
    title = balance.quantity[0].upper() + balance.quantity[1:]
    rows = [Row(n, "", component) for n, component in balance.components.items()]
    empty = f"none, to order {balance.highest}"
    topic = balance.quantity.partition(" ")[0]
    title_words = (f"{title}, unit ", _unit(balance))
    return component_table(title_words, rows, empty, _in_newton_metres(balance), topic)


def _in_newton_metres(balance: TorqueBalance) -> Measured | None:
    """Return the column of values in N m, with the sign of t_n; None without an operating point."""
    if balance.operating_point is None or balance.engine.has_symbols:
        return None

    def cells(row: Row) -> tuple[Cell, ...]:
        order = int(row.order)
        value = hypot(*balance.in_newton_metres(order))
        below_zero = balance.kinematics is not None and balance.values[order] < 0
        return (Decimal(short_decimal(-value if below_zero else value, SHOWN)),)

    return Measured((Column("N m"),), cells)


def _operating(balance: TorqueBalance) -> Facts | None:
    point = balance.operating_point
    return None if point is None else operating_facts(point, "torque")


def _unit(balance: TorqueBalance) -> Formula | Equation:
    unit = _UNITS[balance.unit]
    if balance.kinematics is None:
        return unit
    unit = Subscript(Name(balance.kinematics.letter), _N) * unit
    return equal(Subscript(_T, _N), unit) if balance.kinematics == INERTIA else unit


def _coefficients(balance: TorqueBalance) -> tuple[Block, ...]:
    if not balance.components or balance.kinematics is None:
        return ()
    return (coefficient_table(balance.kinematics, balance.orders, balance.values, balance.ratio),)


def _legend(balance: TorqueBalance, title: str, *more: tuple[Words, Words]) -> tuple[Block, ...]:
    """Return what letters, signs and angles mean; `more` stands before the signs."""
    engine = balance.engine
    alike = has_common_torque(engine)
    signed = _in_newton_metres(balance) is not None and balance.kinematics is not None
    entries = [
        *origin_facts(engine),
        *size_facts(engine, engine.ratio, alike=alike, pitch=False),
        *_rods(engine),
        *balancer_entries(engine),
        *more,
        SIGNS,
        ORDER,
        *(value_fact("N m", "the unit") if signed else ()),
    ]
    return blocks(None if alike else group_table(engine), Facts(tuple(entries), title))


def _rods(engine: Engine) -> list[tuple[Words, Words]]:
    excess = first_excess(engine)
    if not excess:
        return []
    whose = "a rod" if len({*excesses(engine)}) == 1 else "the first rod that has one"
    size = decimal(excess / MILLI**2)
    return [(_J, (f"moment of inertia of {whose} beyond that of its two end masses: ", size, " kg m²"))]
