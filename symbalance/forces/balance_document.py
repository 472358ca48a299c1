"""The document of a balance: free force and couple by order, then the meaning of its letters."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi
from typing import TYPE_CHECKING, Protocol

from symbalance.document.decimals import decimal, short_decimal
from symbalance.document.formula import (
    Decimal,
    Dots,
    Equation,
    Formula,
    Name,
    Subscript,
    cos,
    equal,
    number,
    sin,
)
from symbalance.document.nodes import (
    Block,
    Cell,
    Column,
    Details,
    Document,
    Exact,
    Facts,
    Figure,
    Paragraph,
    Table,
    TooLong,
    Words,
    blocks,
)
from symbalance.document.text_document import document_text
from symbalance.document.text_writer import formula_text
from symbalance.engine.engine import Engine
from symbalance.engine.engine_document import (
    ORDER,
    SIGNS,
    WAVE_OF_PHASE,
    balancer_entries,
    drawing_blocks,
    engine_title,
    group_facts,
    group_table,
    origin_facts,
    size_facts,
)
from symbalance.forces.free_forces import NEGLIGIBLE, Balance, listed_orders, slight_orders
from symbalance.forces.operating_point import UNITS, OperatingPoint
from symbalance.forces.rows import IN_ONE_PLANE, Row, plane, roll_rows, rotating, rows
from symbalance.kinematics.coefficients import Kinematics
from symbalance.kinematics.series_printing import series_formula
from symbalance.kinematics.slider_crank import Series
from symbalance.text.numbers import short_text
from symbalance.text.reals import Real, hypot

if TYPE_CHECKING:
    from symbalance.document.shapes import Drawing

LONGEST_PHASE = 8
"""A phase that takes more characters, an atan2 or a fine fraction of pi, is written rounded."""
LONGEST_NUMERATOR = 30
"""Digits of a coefficient's leading numerator beyond which its series is written rounded."""
SHORT = 14
"""An exact amplitude of a rotating part that takes more characters is written rounded."""
_M, _R, _A, _N = Name("m"), Name("r"), Name("a"), Name("n")
_OMEGA, _LAM = Name("omega"), Name("lam")
_ANGLE = _N * Name("theta")
_A_N, _F_N = Subscript(Name("A"), _N), Subscript(Name("F"), _N)
_F_1 = Subscript(Name("F"), number(1))
_MR = _M * _R * _OMEGA**2


PAGE = 60
"""Lines of a page, of 80 columns; a balance that has more leaves out what matters least."""
FEW_ROWS = 20
"""Rows of tables that a page has room for, whatever else is said."""
LITTLE = 1e-4
"""Of one piston's first order, a hundredth of a per cent: a page that is too long names such orders."""


@dataclass(frozen=True)
class _Brevity:
    """What a page leaves to the whole document; each step takes in the one before."""

    kinds: bool = False
    """The table of cylinders by kind, and its letters; and intervals that another column has."""
    least: float = NEGLIGIBLE
    """Orders below that part of one piston's first order."""


def balance_document(balance: Balance) -> Document:
    """Return a balance as a document: the components that are free, the coefficients, the conventions.

    What matters first has one page: cylinders by kind, then orders of little size, are left to the whole
    document where it would be longer. At a speed every order above a millionth stays, in newtons.
    """
    steps = [_Brevity(), _Brevity(kinds=True)]
    steps += [] if balance.operating_point else [_Brevity(kinds=True, least=LITTLE)]
    document = _document(balance, steps[0])
    for step in steps[1:]:
        if _is_short(document):
            break
        document = _document(balance, step)
    return document


def _is_short(document: Document) -> bool:
    """Tell whether a document's text is one page: few rows are, without being set."""
    rows = sum(len(block.rows) for block in document.blocks if isinstance(block, Table))
    return rows < FEW_ROWS or document_text(document.unfolded(full=False)).count("\n") <= PAGE


def _document(balance: Balance, brevity: _Brevity) -> Document:
    return Document(
        engine_title(balance.engine),
        blocks(
            turn_blocks(balance),  # how much it is, before what it is made of
            resultant_blocks(balance, brevity.least),
            drawing_blocks(balance.engine),
            conventions(balance, kinds_in_short=not brevity.kinds),
            _pictures(balance),
        ),
    )


MOST_DRAWN, MOST_AXES = 64, 4
"""Cylinders of an engine, and directions of their axes, that its pictures have room for."""
PICTURES = "crank star and firing diagram"


def _pictures(balance: Balance) -> Details | None:
    """Return the crank star of the lowest order that is free, and the firing diagram."""
    engine = balance.engine
    if engine.has_symbols or len(engine.cylinders) > MOST_DRAWN:
        return None
    order = min([*balance.force.orders(), *balance.couple.orders()], default=1)

    # A text or JSON draws nothing, and loads nothing that draws.
    def star() -> Drawing:
        from symbalance.drawing.crank_star import draw_star

        return draw_star(engine, order)

    def firing() -> Drawing:
        from symbalance.drawing.firing_diagram import draw_firing

        return draw_firing(engine)

    figures: list[Block] = []
    if len({c.bank for c in engine.cylinders}) <= MOST_AXES:
        figures.append(Figure("star.svg", star, f"Crank star of order {order}"))
    if all(c.fires is not None for c in engine.cylinders):
        figures.append(Figure("firing.svg", firing, "Firing order and strokes"))
    return Details(PICTURES, tuple(figures), optional=True, named=False) if figures else None


def resultant_blocks(balance: Balance, least: float = NEGLIGIBLE) -> tuple[Block, ...]:
    """Return the free force, the free couple, the shafts' roll moment and the coefficients.

    Orders below `least` of one piston's first order are named in a line.
    """
    return blocks(
        _resultant(balance, "force", ("Free force, unit ", unit(balance, "force")), least),
        _resultant(
            balance,
            "couple",
            (f"Free couple about {plane(balance.reference)}, unit ", unit(balance, "couple")),
            least,
        ),
        _roll(balance),
        _coefficients(balance, least),
    )


def unit(balance: Balance, name: str) -> Formula | Equation:
    """Return the unit of a balance's "force" or "couple" of order n."""
    if balance.kinematics is None:
        return _MR if name == "force" else _MR * _A
    return equal(_F_N, _A_N * _MR) if name == "force" else _F_N * _A


def conventions(
    balance: Balance, own: Sequence[tuple[Words, Words]] = (), *, kinds_in_short: bool = True
) -> tuple[Block, ...]:
    """Return what an engine's letters, signs and angles mean, and what it is balanced by.

    `own` are what a result's own tables mean; they stand before the rest. Without `kinds_in_short` the
    table of cylinders by kind is left to the whole document, and firing intervals to the table above.
    """
    engine, alike = balance.engine, balance.kinematics is not None
    has_kinds = not alike or len(engine.groups) > 1
    entries = (
        *own,
        *origin_facts(engine, intervals=kinds_in_short),
        *size_facts(engine, balance.ratio, alike=alike, kinds=kinds_in_short),
        *_letter_facts(balance),
        *balancer_entries(engine),
        SIGNS,
        ORDER,
        *_value_facts(balance),
    )
    facts = Facts(entries, "How to read it")
    if not has_kinds:
        return (facts,)
    if kinds_in_short:
        return (group_table(engine), facts)
    kinds: tuple[Block, ...] = (group_table(engine), Facts(tuple(group_facts(engine))))
    return (facts, Details("cylinders by kind", kinds, optional=True))


def _letter_facts(balance: Balance) -> tuple[tuple[Words, Words], ...]:
    """Return what holds of amplitudes with letters in them: they keep one phase, whatever their sign."""
    if not balance.engine.has_symbols:
        return ()
    return (("amplitude", "with a letter: above 0 at small angles, elsewhere of either sign"),)


def _value_facts(balance: Balance) -> tuple[tuple[Words, Words], ...]:
    """Return what the columns of values at an operating point hold; empty without such columns."""
    if balance.kinematics is None or in_newtons(balance, "force") is None:
        return ()
    couple = in_newtons(balance, "couple") is not None
    name = ", ".join(UNITS.values()) if couple else UNITS["force"]
    return value_fact(name, _A_N * _MR, *((", for couples × ", _A) if couple else ()))


def value_fact(name: str, *unit: str | Formula) -> tuple[tuple[Words, Words], ...]:
    """Return what a column of values in N or N m holds, where the coefficients are apart."""
    return ((name, ("amplitude × ", *unit, ", sign included: the factor of ", WAVE_OF_PHASE)),)


def _resultant(balance: Balance, name: str, title: Words, least: float) -> tuple[Block, ...]:
    surviving, slight = _by_weight(balance, rows(balance, name), least)
    measured = in_newtons(balance, name)
    table = component_table(title, surviving, f"none, to order {balance.highest}", measured, name)
    parts = _rotating(balance, name, {row.order for row in surviving}) if surviving else ()
    tabled = _by_weight(balance, rows(balance, name), NEGLIGIBLE)[0]
    little = [row for row in tabled if row.order in slight]
    details: tuple[Block, ...] = ()
    if little:
        numbers = listed_orders(sorted({row.order for row in little}))
        what = f"{name} of order{'s' if ',' in numbers else ''} {numbers}"
        small = (f"{what}, unit ", unit(balance, name))
        below = component_table(small, little, measured=measured, topic=f"{name}-small")
        details = (Details(what, (below,), optional=True),)
    return (table, *parts, *_slight(balance, name, slight, least), *details)


def _slight(
    balance: Balance, name: str, slight: list[int | Fraction], least: float
) -> tuple[Paragraph, ...]:
    """Return a line of the orders that are not tabled; of a page cut short one for force and couple."""
    if least == NEGLIGIBLE:
        return (Paragraph(slight_orders(slight)),) if slight else ()
    if name == "force":
        return ()
    of_force = _by_weight(balance, rows(balance, "force"), least)[1]
    lines = [(of, n) for of, n in (("force", of_force), ("couple", slight)) if n]
    if not lines:
        return ()
    which = "; ".join(f"{of} {listed_orders(orders)}" for of, orders in lines)
    return (Paragraph(f"{which}: {slight_orders([], least).partition(': ')[2]}"),)


def _by_weight(
    balance: Balance, surviving: list[Row], least: float
) -> tuple[list[Row], list[int | Fraction]]:
    """Return the rows that matter, and the orders that do not: those below `least` of one piston's first.

    Without a rod ratio nobody knows how much an order is; with symbolic angles neither.
    """
    if balance.kinematics is not None and balance.ratio is None:
        return surviving, []
    largest: dict[int | Fraction, float] = {}
    for row in surviving:
        if row.has_symbols:
            return surviving, []
        size = abs(float(balance.share(int(row.order)))) * float(hypot(*row.component.decimal()))
        largest[row.order] = max(largest.get(row.order, 0.0), size)
    slight = [n for n, size in largest.items() if size < least]
    return [row for row in surviving if row.order not in slight], slight


def _roll(balance: Balance) -> tuple[Block, ...]:
    surviving = roll_rows(balance)
    moment = _F_N * _R if balance.kinematics else _M * _R**2 * _OMEGA**2
    title = ("Roll moment of the shafts on the frame, + in the sense of rotation, unit ", moment)
    return (component_table(title, surviving, topic="roll"),) if surviving else ()


_HEAD = (
    Column("order"),
    Column("component"),
    Column(cos(_ANGLE), "cos"),
    Column(sin(_ANGLE), "sin"),
    Column("amplitude"),
    Column("phase"),
)


def component_table(
    title: Words,
    surviving: Sequence[Row],
    empty: str = "none",
    measured: Measured | None = None,
    topic: str = "",
) -> Table:
    """Return a table of components, exact where there is room, in decimals where there is not.

    Rows without a name leave the column of components out; `measured` adds columns of values in N or N m.
    Where an angle is a letter nothing has a decimal, and formulas are long: `_lettered_table`.
    """
    if any(row.has_symbols for row in surviving):
        return _lettered_table(title, surviving, topic)
    if measured is None:
        return Table(title, _HEAD, tuple(map(_cells, surviving)), keys=2, empty=empty, topic=topic)
    cells = tuple((*_cells(row), *measured.cells(row)) for row in surviving)
    return Table(title, (*_HEAD, *measured.columns), cells, keys=2, empty=empty, topic=topic)


def _lettered_table(title: Words, surviving: Sequence[Row], topic: str) -> Table:
    """Return a table of components with letters in them, one formula a row.

    Where every phase is a multiple of π/2, the amplitude says it all: it is the factor of cosine or sine.
    Else each component is a row of cos nθ and one of sin nθ: a root of squares says less than they do.
    """
    orders = [(order_cell(row.order), row.name) for row in surviving]
    if all(row.component.phase_in_turns is not None for row in surviving):
        columns = (*_HEAD[:2], *_HEAD[4:])
        cells = [(*of, *map(Exact, row.exact()[2:])) for of, row in zip(orders, surviving, strict=True)]
        return Table(title, columns, tuple(cells), keys=2, topic=topic)
    columns = (*_HEAD[:2], Column("wave"), Column("factor"))
    cells = [
        (*of, wave, Exact(form.as_formula()))
        for of, row in zip(orders, surviving, strict=True)
        for wave, name in ((cos(_ANGLE), "cos"), (sin(_ANGLE), "sin"))
        if not (form := row.component.form(name)).is_zero()
    ]
    return Table(title, columns, tuple(cells), keys=3, topic=topic)


@dataclass(frozen=True)
class Measured:
    """Columns of an operating point: the value in N or N m, and in per cent of the unit.

    The phase beside it is that of the factor of A_n (t_n), and many of these are negative: a value has
    that sign, so that value cos(n theta - phase) is the force, the couple or the torque.
    """

    columns: tuple[Column, ...]
    cells: Callable[[Row], tuple[Cell, ...]]


def in_newtons(balance: Balance, of: str) -> Measured | None:
    """Return the columns of a balance's force or couple in N or N m; None without an operating point."""
    if balance.operating_point is None or balance.engine.has_symbols:
        return None
    if of == "couple" and balance.operating_point.couple is None:
        return None
    unit = balance.unit_value(of)
    per_cent = ("% of ", _F_1 if of == "force" else _F_1 * _A)

    def cells(row: Row) -> tuple[Cell, ...]:
        share = hypot(*row.component.decimal(SHOWN + 10)) * balance.share(int(row.order))
        return Decimal(short_decimal(share * unit, SHOWN)), Decimal(short_decimal(share * 100, SHOWN))

    return Measured((Column(UNITS[of]), Column(per_cent)), cells)


SHOWN = 5
"""Digits of a value in N: its masses and lengths have no more."""
CLOSE = 8
"""Digits of a largest value beside its bound: with fewer it could be printed above it."""


def turn_blocks(balance: Balance) -> tuple[Block, ...]:
    """Return the largest force and couple over a turn, and the operating point they are for."""
    point = balance.operating_point
    if point is None:
        return ()
    at = operating_facts(point, engine=balance.engine)
    if balance.engine.has_symbols:
        return (at,)
    rows = []
    for output, top in balance.turn_maxima.items():
        of, _, name = output.partition(".")
        if top.value > NEGLIGIBLE * float(balance.unit_value(of)):
            where = Decimal(f"{top.angle:.1f}")
            cells = (f"{of}, {name or 'in any direction'}", UNITS[of], decimal(top.value, CLOSE))
            rows.append((*cells, decimal(_upwards(top.bound), CLOSE), where))
    columns = (
        Column(""),
        Column("unit"),
        Column("largest"),
        Column("proved to be at most"),
        Column(("at ", Name("theta"), ", degrees")),
    )
    title, nothing = "All orders together, over a turn", "below 10⁻⁶ of one piston's first order"
    return (at, Table(title, columns, tuple(rows), empty=nothing))


def operating_facts(point: OperatingPoint, of: str = "force", *, engine: Engine | None = None) -> Facts:
    """Return the speed and the sizes that values are for, and what the unit of a "torque" is there."""
    pitch = point.pitch if of == "force" else None
    letters: Words = (_M, ", ", _R, *(() if pitch is None else (", ", _A)))
    unit: tuple[Words, Words] = (
        equal(_F_1, _MR),
        (Decimal(short_decimal(point.force, SHOWN)), " N, one piston's first order"),
    )
    if of == "torque":
        unit = (_M * _R**2 * _OMEGA**2, (Decimal(short_decimal(point.torque, SHOWN)), " N m"))
    speed: tuple[Words, Words] = ("speed", f"{float(point.rpm):.8g} rpm")
    swept = () if engine is None else _swept(engine)
    return Facts((speed, (letters, _sizes_of(point, pitch)), *swept, unit), "Operating point")


def _swept(engine: Engine) -> tuple[tuple[Words, Words], ...]:
    """Return bore and stroke, and the volume that the pistons sweep; empty where no bore is known."""
    stroke = engine.first.stroke
    alike = all(c.link is None and not c.offset and c.stroke == stroke for c in engine.cylinders)
    if engine.bore is None or stroke is None or not alike:  # an offset piston's way is not the stroke
        return ()
    litres = float(engine.bore**2 * stroke * len(engine.cylinders)) * pi / 4e6
    size = f"{float(engine.bore):.8g} by {float(stroke):.8g} mm, {litres:.4g} litres"
    return (("bore and stroke", size),)


def _upwards(bound: float) -> float:
    """Return a bound that is still one when its eight digits are rounded."""
    return bound * (1 + 5e-8)


def _sizes_of(point: OperatingPoint, pitch: Fraction | None) -> str:
    lengths = [point.radius] if pitch is None else [point.radius, pitch]
    in_mm = ", ".join(f"{float(length * 1000):.8g} mm" for length in lengths)
    return f"{float(point.mass):.8g} kg, {in_mm}"


def order_cell(order: int | Fraction) -> Formula:
    """Return an order as a cell; half orders as decimals, whose points stand in line."""
    whole = order == int(order)
    return number(int(order)) if whole else Decimal(str(float(order)))


def _cells(row: Row) -> tuple[Cell, ...]:
    decimals = row.decimals()
    head = (order_cell(row.order), row.name)
    if row.is_decimal and decimals is not None:
        cosine, sine, amplitude = (Decimal(d) for d in decimals[:3])
        return (*head, cosine, sine, amplitude, _phase(row, decimals[3]))
    if row.component.is_long and decimals is not None:
        return (*head, *(TooLong(Decimal(d)) for d in decimals[:3]), _rounded_phase(row, decimals[3]))
    values = row.exact()
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


def _short_phase(value: Formula, decimal: str) -> Words:
    return value if len(formula_text(value)) <= LONGEST_PHASE else ("≈ ", Decimal(decimal))


def _rounded_phase(row: Row, decimal: str) -> Words:
    """Return the phase of a component that is not written exactly: a fraction of pi, or rounded."""
    if row.component.phase_in_turns is None:
        return ("≈ ", Decimal(decimal))
    return _short_phase(row.component.form("phase").as_formula(), decimal)


def _phase(row: Row, decimal: str) -> Formula:
    return row.phase_in_decimals() or Decimal(decimal)


def _rotating(balance: Balance, name: str, orders: Collection[int | Fraction]) -> tuple[Block, ...]:
    """Return the parts that turn with and against the crank, a row for each of `orders`."""
    pairs = [pair for pair in rotating(balance, name) if pair[0].order in orders]
    if not pairs:
        return (Paragraph(IN_ONE_PLANE),)
    what = f"{name} as rotating parts"
    columns = (
        Column("order"),
        Column("forward (with the crank)"),
        Column("phase"),
        Column("backward (against it)"),
        Column("phase"),
    )
    cells = tuple((number(f.order), *_turning(f), *_turning(b)) for f, b in pairs)
    return (
        Details(
            what, (Table("as rotating parts", columns, cells, topic=f"{name}-rotating"),), optional=True
        ),
    )


def _turning(row: Row) -> tuple[Cell, Cell]:
    if row.component.is_zero():
        return number(0), ""
    decimals = row.decimals()
    if row.is_decimal and decimals is not None:
        return Decimal(decimals[2]), _phase(row, decimals[3])
    if row.component.is_long and decimals is not None:
        return TooLong(Decimal(decimals[2])), _rounded_phase(row, decimals[3])
    amplitude, phase = row.exact()[2:]
    if decimals is None:
        return Exact(amplitude), Exact(phase)
    near = Decimal(decimals[2])
    if len(formula_text(amplitude)) > SHORT:
        return near, _short_phase(phase, decimals[3])
    beside = decimals[2] != formula_text(amplitude)
    return Exact(amplitude, near, beside), _short_phase(phase, decimals[3])


def _series(series: Series) -> Words:
    """Return a coefficient's series; one whose numbers fill a line by its leading term, rounded."""
    power, lead = min(series.terms.items())
    if len(str(abs(lead.numerator))) <= LONGEST_NUMERATOR:
        return series_formula(series, ellipsis=True)
    return ("≈ ", Decimal(short_decimal(Real(lead))) * _LAM ** number(-power) + Dots())


def _coefficients(balance: Balance, least: float) -> tuple[Block, ...]:
    if not balance.orders or balance.kinematics is None:
        return ()
    tabled = {
        row.order
        for of in ("force", "couple")
        for row in _by_weight(balance, rows(balance, of), least)[0]
    }
    orders = [order for order in balance.orders if order.order in tabled]
    return (
        (coefficient_table(balance.kinematics, orders, balance.values, balance.ratio),) if orders else ()
    )


class _Ordered(Protocol):
    """An order of a result, with the coefficient of one cylinder."""

    @property
    def order(self) -> int: ...
    @property
    def coefficient(self) -> Series | None: ...


def coefficient_table(
    kinematics: Kinematics, orders: Sequence[_Ordered], values: Mapping[int, Real], ratio: Fraction | None
) -> Table:
    """Return a table of one cylinder's coefficients: as series in 1/λ, and in decimals at the ratio."""
    letter = Subscript(Name(kinematics.letter), _N)
    at: Words = "" if ratio is None else (letter, " at ", equal(_LAM, Decimal(short_text(ratio))))
    cells = []
    for order in orders:
        assert order.coefficient is not None
        value = values.get(order.order)
        value_cell = "" if value is None else Decimal(short_decimal(value))
        cells.append((number(order.order), _series(order.coefficient), value_cell))
    columns = (Column("order"), Column((letter, " in powers of ", 1 / _LAM)), Column(at))
    return Table(
        "Coefficients of one cylinder (the value is exact in λ, rounded)",
        columns,
        tuple(cells),
        topic="coefficients",
    )
