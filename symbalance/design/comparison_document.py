"""The document of a comparison: one table, a line an engine, and every order as a cosine if asked for."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from symbalance.design.comparison import (
    BALANCED_ORDERS,
    DIRECTIONS,
    KINDS,
    ComparedEngine,
    EngineComparison,
    Place,
)
from symbalance.document.decimals import short_decimal
from symbalance.document.expressions import formula_of
from symbalance.document.formula import Decimal, Formula, Name, Negative, Subscript, cos, equal, number
from symbalance.document.nodes import (
    UNKNOWN,
    Block,
    Cell,
    Column,
    Details,
    Document,
    Exact,
    Facts,
    Heading,
    Table,
    TooLong,
    Words,
    blocks,
    inlines,
)
from symbalance.document.text_writer import formula_text
from symbalance.engine.engine_document import SIGNS, degrees_text, repeated_intervals
from symbalance.exact.spectrum import Component
from symbalance.forces.operating_point import UNITS
from symbalance.forces.rows import Row
from symbalance.text.numbers import short_text
from symbalance.text.reals import Real

MOST_ORDERS = 6
"""Columns of orders that a page has room for beside the others."""
MOST_INTERVALS = 2
"""Uneven firing intervals that are listed; of more, the shortest and the longest."""
SHOWN = 4
"""Digits of a decimal: what a handbook's table has, and a line of many orders has room for."""
SHOWN_NEWTONS = 5
"""Digits of a value in N, whose masses and lengths have no more."""
LEAST = Fraction(1, 10_000)
"""Per cent of one piston's first order below which nobody feels an order, a millionth of it."""
LONGEST = 8
"""An exact amplitude of a cosine that takes more characters gives way to its decimal."""
_MARKS = {"vertical": "", "lateral": " h", "forward": " f", "backward": " b", "ellipse": " e"}
_M, _R, _A, _N = Name("m"), Name("r"), Name("a"), Name("n")
_MR = _M * _R * Name("omega") ** 2
_F_N, _A_N = Subscript(Name("F"), _N), Subscript(Name("A"), _N)


def comparison_document(comparison: EngineComparison) -> Document:
    """Return a comparison as a document: the table, the cosines where they are wanted, how to read it."""
    waves = blocks(*(_waves(comparison, k, d) for k in KINDS for d in DIRECTIONS if comparison.phases))
    cosines = (Heading("Every order as a cosine"), *waves) if waves else ()
    title = f"{len(comparison)} engines compared, to order {comparison.order}"
    in_newtons = _newton_tables(comparison) if comparison.rpm is not None else ()
    in_units: tuple[Block, ...] = _tables(comparison)
    # A page has room for two tables of many orders, and at a speed these are the ones in newtons.
    apart = len(in_newtons) > 1
    if apart:
        reading = Facts(_reading_units(comparison))
        what = "in per cent" if comparison.percent else "in each order's own unit"
        in_units = (Details(f"forces and couples {what}", (*in_units, reading), optional=True),)
    return Document(
        title if len(comparison) > 1 else comparison.summary(),
        blocks(in_newtons, in_units, cosines, Facts(_reading(comparison, apart), "How to read it")),
    )


def _tables(comparison: EngineComparison) -> tuple[Table, ...]:
    """Return the table; of many orders two, forces apart from couples, which a page has room for."""
    places = _shown(comparison)
    if len(places) <= MOST_ORDERS:
        return (_table(comparison, places, "Free force and couple", _units(comparison, KINDS)),)
    forces = [place for place in places if place[0] == "force"]
    couples = [place for place in places if place[0] == "couple"]
    return (
        _table(comparison, forces, "Free force", _units(comparison, ["force"]), ends=False),
        _table(comparison, couples, "Free couple", _units(comparison, ["couple"]), begins=False),
    )


def _table(
    comparison: EngineComparison,
    places: Sequence[Place],
    title: str,
    unit: Words,
    *,
    begins: bool = True,
    ends: bool = True,
) -> Table:
    """Return a table, a line an engine; `begins` with the firing intervals, `ends` with the balance."""
    columns = (
        Column("engine"),
        *([Column("fires", "firing interval")] if begins else []),
        *(_column(comparison, place) for place in places),
        *([Column("balanced by")] if ends else []),
    )
    rows = tuple(
        (
            line.engine.name,
            *([_intervals(line)] if begins else []),
            *(_cell(comparison, line, place) for place in places),
            *([balanced_by(line)] if ends else []),
        )
        for line in comparison
    )
    return Table((f"{title}, ", *inlines(unit)), columns, rows)


def _newton_tables(comparison: EngineComparison) -> tuple[Table, ...]:
    """Return the table in N and N m, all orders together beside each; of many orders two."""
    places = _shown(comparison)
    kinds = [kind for kind in KINDS if any(place[0] == kind for place in places)]
    if len(places) + len(kinds) <= MOST_ORDERS:
        return (_newton_table(comparison, kinds or ["force"]),)
    first, *others = kinds
    return (
        _newton_table(comparison, [first], ends=not others),
        *(_newton_table(comparison, [kind], begins=False) for kind in others),
    )


def _newton_table(
    comparison: EngineComparison, kinds: Sequence[str], *, begins: bool = True, ends: bool = True
) -> Table:
    """Return a table in N and N m; `begins` with the firing intervals, `ends` with the balance."""
    places = [place for place in _shown(comparison) if place[0] in kinds]
    ordered = [p for kind in kinds for p in (*(p for p in places if p[0] == kind), (kind, 0))]
    columns = (
        Column("engine"),
        *([Column("fires", "firing interval")] if begins else []),
        *(Column(*_newton_head(*place)) for place in ordered),
        *([Column("balanced by")] if ends else []),
    )
    rows = tuple(
        (
            line.engine.name,
            *([_intervals(line)] if begins else []),
            *(_newton_cell(line, place) for place in ordered),
            *([balanced_by(line)] if ends else []),
        )
        for line in comparison
    )
    units = ", couples in N m" if len(kinds) > 1 else ""
    of = " and ".join(kinds)
    title = f"Free {of} at {_speed(comparison)} rpm, in {UNITS[kinds[0]]}{units}"
    return Table(title, columns, rows, topic="newtons" if begins else "newton-metres")


def _newton_head(kind: str, order: int) -> tuple[str, str]:
    """Return the head of a column in N or N m, and its name; order 0 is all of them together."""
    if not order:
        return f"{kind}, all", f"all orders of the {kind}"
    return f"{kind} {order}", f"{kind} of order {order}, {UNITS[kind]}"


def _newton_cell(line: ComparedEngine, place: Place) -> Cell:
    """Return an order's largest value over a turn; of order 0 that of all orders together."""
    kind, order = place
    if not order:
        top = line.all_orders(kind)
        return UNKNOWN if top is None else _newtons(Real(top.value))
    value = line.newtons(place)
    return UNKNOWN if value is None else _newtons(value)


def _newtons(value: Real) -> Formula:
    return Decimal(short_decimal(value, SHOWN_NEWTONS)) if value else number(0)


def _speed(comparison: EngineComparison) -> str:
    return short_text(comparison.rpm) if comparison.rpm is not None else ""


def _units(comparison: EngineComparison, kinds: Sequence[str]) -> Words:
    """Return the unit of forces, couples or both."""
    if comparison.percent:
        units = [_MR if kind == "force" else _MR * _A for kind in kinds]
        of = (units[0], *((" (couples ", units[1], ")") if len(units) > 1 else ()))
        return ("per cent of one piston's first order ", *of)
    force: Words = ("unit ", equal(_F_N, _A_N * _MR))
    if kinds == ["couple"]:
        return ("unit ", _F_N * _A)
    return (*force, " (couples ", _F_N * _A, ")") if len(kinds) > 1 else force


def _shown(comparison: EngineComparison) -> list[Place]:
    """Return the orders that have a column: not those known to be too small to matter in every engine."""
    return [
        place
        for place in comparison.places
        if any((p := line.percent(place)) is None or p > LEAST for line in comparison)
    ]


def _column(comparison: EngineComparison, place: Place) -> Column:
    """Return a column's head: the unit of the order, or in per cent what it is."""
    kind, order = place
    name, unit = f"{kind} of order {order}", Subscript(Name("F"), number(order))
    if comparison.percent:
        return Column(f"{kind} {order}", name)
    return Column(unit if kind == "force" else unit * _A, name)


def _cell(comparison: EngineComparison, line: ComparedEngine, place: Place) -> Cell:
    parts = line.largest(place)
    if not parts:
        return number(0)
    mark = _MARKS[line.motion(place)]
    if comparison.percent:
        percent = line.percent(place)
        return UNKNOWN if percent is None else _marked(_decimal(percent), mark)
    size = line.size(place)
    if size is None:
        return _marked(formula_of(_amplitude(parts)), mark)
    near = _decimal(size)
    if any(part.number.is_decimal or part.is_long for part in parts):
        return _marked(near, mark)
    value = formula_of(_amplitude(parts))
    return _marked(value if len(formula_text(value)) <= LONGEST else near, mark)


def _amplitude(parts: Sequence[Component]) -> Any:
    """Return the sum of amplitudes as an expression."""
    return sum(part.amplitude for part in parts)


def _marked(value: Formula, mark: str) -> Words:
    return (value, mark) if mark else value


def _decimal(value: Real) -> Formula:
    return Decimal(short_decimal(value, SHOWN))


def balanced_by(line: ComparedEngine) -> str:
    """Return what balances the first two orders of an engine: the crank, shafts by their speed.

    >>> from symbalance.design.comparison import compare
    >>> from symbalance.engine.catalogue import load
    >>> [balanced_by(line) for line in compare([load("inline-1"), load("v6-60"), load("v12-60")], 2)]
    ['crank, −1, ±2', 'crank, −2', 'nothing']
    """
    parts = ["crank"] if line.counterweights else []
    for n in BALANCED_ORDERS:
        signs = [sign for sign, speed in (("+", n), ("−", -n)) if speed in line.shafts]
        if signs:
            parts.append(f"{'±' if len(signs) == 2 else signs[0]}{n}")
    return ", ".join(parts) or "nothing"


def _intervals(line: ComparedEngine) -> str:
    """Return the degrees between firings: one if they are even, else those that repeat."""
    if line.firing_intervals is None:
        return UNKNOWN
    period = repeated_intervals(line.engine)
    if len(period) > MOST_INTERVALS:
        return f"{degrees_text(min(period))} to {degrees_text(max(period))}"
    return "-".join(map(degrees_text, period))


# Every order as a cosine ----------------------------------------------------------------------------


def _waves(comparison: EngineComparison, kind: str, direction: str) -> Table | None:
    """Return a table of cosines, a column an order; None where every engine is free of them."""
    places = [
        place
        for place in _shown(comparison)
        if place[0] == kind
        and any(not line.resultant(place).component(direction).is_zero() for line in comparison)
    ]
    if not places:
        return None
    columns = (Column("engine"), *(_wave_column(comparison, place) for place in places))
    rows = tuple(
        (line.engine.name, *(_wave(comparison, line, place, direction) for place in places))
        for line in comparison
    )
    return Table(f"{kind.capitalize()}, {direction}", columns, rows)


def _wave_column(comparison: EngineComparison, place: Place) -> Column:
    kind, order = place
    if comparison.percent:
        return Column(f"order {order}, %", f"order {order}")
    unit = Subscript(Name("F"), number(order))
    return Column(unit if kind == "force" else unit * _A, f"order {order}")


def _wave(comparison: EngineComparison, line: ComparedEngine, place: Place, direction: str) -> Cell:
    component = line.resultant(place).component(direction)
    if component.is_zero():
        return number(0)
    row = Row(place[1], direction, component)
    return _percent_wave(row, line.factor(place[1])) if comparison.percent else _own_wave(row)


def _percent_wave(row: Row, factor: Real | None) -> Cell:
    """Return a cosine in per cent; the sign is that of A_n."""
    decimals = row.decimals()
    if decimals is None or factor is None:
        return UNKNOWN
    signed = 100 * factor * row.component.number.size()
    wave = _cosine(_decimal(abs(signed)), row.order, *_phase(row, decimals[3]))
    return -wave if signed < 0 else wave


def _own_wave(row: Row) -> Cell:
    """Return a cosine in the unit of its order: exact where it is short, its factor rounded where not."""
    component, decimals = row.component, row.decimals()
    if decimals is None:
        return Exact(_cosine(formula_of(component.amplitude), row.order, formula_of(component.phase)))
    phase = _phase(row, decimals[3])
    near = _cosine(_decimal(component.number.size()), row.order, *phase)
    if row.is_decimal:
        return near
    if component.is_long:
        return TooLong(near)
    value = formula_of(component.amplitude)
    whole = _cosine(value, row.order, *phase)
    if len(formula_text(value)) <= LONGEST:
        return whole
    return Exact(whole, near) if component.phase_in_turns is not None else near


def _phase(row: Row, decimal: str) -> tuple[Formula, bool]:
    """Return the size of a phase, a fraction of π where it is a plain one, and whether it is later."""
    later = not decimal.startswith(("-", "−"))
    turns = row.component.phase_in_turns
    if turns is not None:
        import sympy

        return formula_of(2 * abs(sympy.Rational(turns.numerator, turns.denominator)) * sympy.pi), later
    plain = row.phase_in_decimals() if row.is_decimal else None
    if plain is None:
        return Decimal(decimal.lstrip("-−")), later
    return (plain.operand if isinstance(plain, Negative) else plain), later


def _cosine(amplitude: Formula, order: Any, phase: Formula, later: bool = True) -> Formula:
    """Return amplitude cos(nθ − phase), or + where the wave is not `later` but ahead."""
    angle = Name("theta") if order == 1 else number(order) * Name("theta")
    shifted = angle - phase if later else angle + phase
    wave = cos(angle) if formula_text(phase) == "0" else cos(shifted)
    return wave if formula_text(amplitude) == "1" else amplitude * wave


# How to read it -------------------------------------------------------------------------------------


def _marks(comparison: EngineComparison) -> list[str]:
    """Return what the letters beside values mean."""
    motions = {line.motion(place) for line in comparison for place in _shown(comparison)}
    marks = [f"{mark} {words}" for name, (mark, words) in _MARKED.items() if name in motions]
    upright = ["upright without a letter"] if marks and "vertical" in motions else []
    return [*upright, *marks]


def _reading_units(comparison: EngineComparison) -> tuple[tuple[Words, Words], ...]:
    """Return what tables in per cent, or in each order's own unit, mean where they stand apart."""
    marks = _marks(comparison)
    return ((("letters", "; ".join(marks)),) if marks else ()) + (_unit_fact(comparison),)


def _unit_fact(comparison: EngineComparison) -> tuple[Words, Words]:
    if comparison.percent:
        unknown = f"; {UNKNOWN} where no rod ratio is known or an angle is a symbol"
        return ("per cent", f"each engine of its own piston, of cylinder 1{unknown}")
    return (_A_N, "coefficient of one cylinder, a function of its rod ratio, with a sign of its own")


def _reading(comparison: EngineComparison, apart: bool) -> tuple[tuple[Words, Words], ...]:
    marks = [] if apart else _marks(comparison)
    largest = "largest over a turn; orders that cancel in every engine are left out"
    entries: list[tuple[Words, Words]] = [("cells", "; ".join([largest, *marks]))]
    if comparison.rpm is not None:
        words = "all orders together, not their sum: they are not largest at once"
        entries.append(("all", f"the largest over a turn of {words}"))
    small = [place for place in comparison.places if place not in _shown(comparison)]
    if small:
        numbers = {kind: [str(order) for of, order in small if of == kind] for kind in KINDS}
        words = "; ".join(f"{kind} {', '.join(orders)}" for kind, orders in numbers.items() if orders)
        entries.append(("left out", f"{words}: below a millionth of one piston's first order"))
    letters = "reciprocating mass, crank radius, cylinder pitch"
    if not apart:
        entries.append(_unit_fact(comparison))
    if comparison.rpm is not None:
        letters = f"{letters}: {'; '.join(map(_sizes, comparison))}"
    entries += [
        ((_M, ", ", _R, ", ", _A), letters),
        (equal(Name("lam"), Name("l") / _R), f"rod over crank radius, {_ratios(comparison)}"),
        ("fires", "degrees of the crank between firings; uneven ones until they repeat"),
        ("balanced by", _BALANCED),
    ]
    if comparison.phases:
        entries += [((Name("theta"), " = 0"), "each engine's own, as its balance says"), SIGNS]
    return tuple(entries)


_MARKED = {
    "lateral": ("h", "sideways"),
    "forward": ("f", "turns with the crank"),
    "backward": ("b", "turns against it"),
    "ellipse": ("e", "runs round an ellipse"),
}
_BALANCED = (
    "orders 1 and 2: crank, by counterweights on it; ±2, by balance shafts at twice its speed, "
    "− against it"
)


def _sizes(line: ComparedEngine) -> str:
    """Return an engine's mass, crank radius and pitch at its operating point."""
    point = line.operating_point
    if point is None:
        return f"{line.engine.name} {UNKNOWN}"
    lengths = [point.radius, *(() if point.pitch is None else (point.pitch,))]
    in_mm = ", ".join(f"{float(length * 1000):.6g} mm" for length in lengths)
    return f"{line.engine.name} {float(point.mass):.6g} kg, {in_mm}"


def _ratios(comparison: EngineComparison) -> str:
    """Return the rod ratios, one if they agree."""
    ratios = [line.balance.ratio for line in comparison]
    words = [UNKNOWN if ratio is None else short_text(ratio) for ratio in ratios]
    if len(set(words)) > 1:
        return f"line by line {', '.join(words)}"
    return "not known" if ratios[0] is None else f"here {words[0]}"
