"""Text about an engine in documents: title, banks, firing order, zero of the crank angle, letters."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise

from symbalance.document.decimals import short_decimal
from symbalance.document.formula import Decimal, Formula, Name, Product, Upright, cos, equal, sin
from symbalance.document.nodes import Block, Cell, Column, Paragraph, Table, Words
from symbalance.engine.balance_mass_facts import balancer_facts
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.dead_centres import (
    dead_centre_shift,
    dead_centre_shift_of,
    firing_dead_centres,
    has_shifted_dead_centres,
)
from symbalance.engine.engine import Engine, Group
from symbalance.exact.angles import Angle
from symbalance.kinematics.mechanisms import LinkRod, dead_centres
from symbalance.text.numbers import short_text
from symbalance.text.reals import Real

_M, _R, _L, _A, _N = Name("m"), Name("r"), Name("l"), Name("a"), Name("n")
_THETA, _LAM = Name("theta"), Name("lam")
_ANGLE = _N * _THETA
WAVE_OF_PHASE = cos(_ANGLE - Upright("phase"))
"""What an order's amplitude, or its value in N or N m, is multiplied by."""
WAVE = equal(
    Name("C") * cos(_ANGLE) + Name("S") * sin(_ANGLE),
    Upright("amplitude") * WAVE_OF_PHASE,
)
"""What an order's coefficients, amplitude and phase are."""
ORDER: tuple[Words, Words] = (("order ", _N), WAVE)
SIGNS: tuple[Words, Words] = (
    "signs",
    "+ is up or right seen from the front; a couple + pushes the front up or right",
)
"""What directions and couples count as positive."""


def engine_words(engine: Engine) -> str:
    """Return an engine in a line without its name: strokes, cylinders and banks.

    >>> from symbalance.engine.catalogue import load
    >>> engine_words(load("v8-90"))
    'four-stroke, 8 cylinders, banks at 45°, −45° from vertical'
    """
    count = len(engine.cylinders)
    return f"{strokes(engine)}, {count} cylinder{'s' if count > 1 else ''}, {banks(engine)}"


def engine_title(engine: Engine) -> str:
    """Return an engine in a line: its name, strokes, cylinders and banks."""
    return f"{engine.name}: {engine_words(engine)}"


def origin_facts(engine: Engine, *, intervals: bool = True) -> list[tuple[Words, Words]]:
    """Return the firing order, where it is known, and where the crank angle is counted from.

    Without `intervals` uneven ones are left to the table of what a drawing says.
    """
    fires = firing(engine) if intervals else _firing_numbers(engine)
    entries: list[tuple[Words, Words]] = [("fires", fires)] if fires else []
    entries.append(((_THETA, " = 0"), f"{origin(engine)}; θ runs clockwise seen from the front"))
    return entries


def _with_decimal(ratio: Fraction) -> str:
    """Return a number as tables print it, a fraction that few would recognise beside its decimal."""
    text = short_text(ratio)
    return f"{text} ≈ {float(ratio):.4g}" if "/" in text and 100 % ratio.denominator else text


def size_facts(
    engine: Engine, ratio: Fraction | None, *, alike: bool, pitch: bool = True, kinds: bool = True
) -> list[tuple[Words, Words]]:
    """Return what λ, m, r, with `pitch` a, and the letters of unlike cylinders' rods mean.

    `alike` says whether results are in the sizes that all cylinders share, else in cylinder 1's. Without
    `kinds` the letters of the table of unlike cylinders are left out.
    """
    entries: list[tuple[Words, Words]] = []
    letters: Words = (_M, ", ", _R, ", ", _A) if alike and pitch else (_M, ", ", _R)
    if alike:
        here = ", not given" if ratio is None else f", here {_with_decimal(ratio)}"
        entries.append((equal(_LAM, _L / _R), f"connecting rod over crank radius{here}"))
        also = ", cylinder pitch" if pitch else ""
        joined = ", crank radius" if pitch else " and crank radius"
        which = "one cylinder" if len(engine.groups) == 1 else f"cylinder {engine.first.number}"
        entries.append((letters, f"reciprocating mass of {which}{joined}{also}"))
        return entries
    entries.append((letters, f"reciprocating mass and crank radius of cylinder {engine.first.number}"))
    if pitch:
        entries.append((_A, "cylinder pitch"))
    return entries + (group_facts(engine) if kinds else [])


def balancer_entries(engine: Engine) -> list[tuple[Words, Words]]:
    """Return the counterweights and balance shafts of an engine, an entry each."""
    return [("balanced by", words) for words in balancer_facts(engine)]


MOST_FIRINGS = 60
"""Cylinders up to which the firing order and its intervals are listed whole."""
SHOWN_FIRINGS = 12
"""Of more, how many are listed."""
NEAR = 20
"""Degrees from a dead centre within which it is named."""


def strokes(engine: Engine) -> str:
    """Return "four-stroke" or "two-stroke"."""
    return {2: "two-stroke", 4: "four-stroke"}[engine.strokes]


def banks(engine: Engine) -> str:
    """Return where the banks stand, each angle once, in the order of the engine."""
    angles = list(dict.fromkeys(c.bank for c in engine.cylinders))
    if angles == [Angle(Fraction(0))]:
        return "one bank, upright"
    where = ", ".join(map(angle_text, angles))
    return f"{'banks' if len(angles) > 1 else 'one bank'} at {where} from vertical"


def firing(engine: Engine) -> str:
    """Return the firing order and, where they are uneven, the intervals; empty if it is not known.

    >>> from symbalance.engine.catalogue import load
    >>> firing(load("v2-45")), firing(load("v6-90"))
    ('1-2 at intervals of 405°, 315°', '1-6-5-4-3-2 at intervals of 150°, 90°, and so on')
    """
    numbers = _firing_numbers(engine)
    if not numbers:
        return ""
    steps = firing_intervals(engine)
    apart = ", dead centres apart by" if has_shifted_dead_centres(engine) else " at intervals of"
    if len(set(steps)) == 1:
        return numbers
    period = _period(steps)
    intervals = _shortened([f"{degrees_text(step)}°" for step in steps[:period]])
    intervals += ["and so on"] if period < len(steps) else []
    return f"{numbers}{apart} {', '.join(intervals)}"


def _firing_numbers(engine: Engine) -> str:
    """Return the cylinders' numbers as they fire; empty if that is not known."""
    order = engine.firing_order()
    if order is None or len(order) < 2:
        return ""
    return "-".join(_shortened([str(number) for number in order]))


def _shortened(names: list[str]) -> list[str]:
    """Return what is listed in firing order; of very many the first, and how many they are."""
    if len(names) <= MOST_FIRINGS:
        return names
    return [*names[:SHOWN_FIRINGS], f"… ({len(names)} in all, by cylinder in the JSON of a balance)"]


def repeated_intervals(engine: Engine) -> list[Fraction]:
    """Return the firing intervals until they repeat: one of an engine that fires evenly.

    >>> from symbalance.engine.catalogue import load
    >>> [[int(gap) for gap in repeated_intervals(load(name))] for name in ("v8-90", "v6-90")]
    [[90], [150, 90]]
    """
    steps = firing_intervals(engine)
    return steps[: _period(steps)]


def _period(steps: list[Fraction]) -> int:
    """Return after how many steps they repeat, by the longest proper prefix that is a suffix too.

    D. E. Knuth, J. H. Morris and V. R. Pratt, Fast pattern matching in strings, SIAM Journal on Computing
    6 (1977): it costs what there are steps, where comparing every period would cost the square.

    >>> _period([Fraction(n) for n in (1, 2, 1, 2, 1)]), _period([Fraction(1), Fraction(2)])
    (2, 2)
    """
    borders = [0]
    for step in steps[1:]:
        border = borders[-1]
        while border and steps[border] != step:
            border = borders[border - 1]
        borders.append(border + 1 if steps[border] == step else 0)
    return len(steps) - borders[-1]


def firing_intervals(engine: Engine) -> list[Fraction]:
    """Return the degrees after each firing of an engine whose firing angles are known.

    Dead centres that an offset or a link rod has moved count where they are, to 0.01 degrees.
    """
    cycle = 180 * engine.strokes
    if has_shifted_dead_centres(engine):
        starts = sorted(round(top, 2) for top in firing_dead_centres(engine).values())
    else:
        starts = sorted(c.fires % cycle for c in engine.cylinders if c.fires is not None)
    ends = [*starts[1:], starts[0] + cycle]
    return [end - start for start, end in zip(starts, ends, strict=True)]


def origin(engine: Engine) -> str:
    """Return what stands where at theta = 0.

    >>> from symbalance.engine.builders import inline
    >>> origin(inline("1-2")), origin(inline(throws=[30, 90]))
    ('cylinder 1 at firing top dead centre', 'the pin of cylinder 1 at 30° from straight up')
    """
    first = min(engine.cylinders, key=lambda c: c.number)
    dead_centre = f"{'firing ' if first.fires == 0 else ''}top dead centre"
    dead_centre_shift = Fraction(0) if first.delay.symbols else dead_centre_shift_of(first)
    if not dead_centre_shift and first.delay == Angle(Fraction(0)):
        return f"cylinder {first.number} at {dead_centre}"
    where = f"the pin of cylinder {first.number} at {angle_text(first.throw)} from straight up"
    past = Fraction(0) if first.delay.symbols else round(first.delay.in_degrees() - dead_centre_shift, 2)
    if not dead_centre_shift or abs(past) > NEAR:
        return where
    side = f"{degrees_text(abs(past))}° {'past' if past > 0 else 'before'} its " if past else "at its "
    return f"{where}, {side}{dead_centre}"


def angle_text(angle: Angle) -> str:
    """Return an angle in degrees, short decimals as decimals and others as fractions; symbols in radians.

    >>> angle_text(Angle(Fraction(-1, 12))), angle_text(Angle(Fraction(1, 7)))
    ('−30°', '360/7°')
    """
    if angle.symbols:
        from symbalance.document.expressions import formula_of
        from symbalance.document.text_writer import formula_text

        return formula_text(formula_of(angle.expression()))
    return f"{degrees_text(angle.in_degrees())}°".replace("-", "−")


def degrees_text(number: Fraction) -> str:
    """Return a number as a decimal where it is short, else as a fraction.

    >>> degrees_text(Fraction(45, 2)), degrees_text(Fraction(360, 7))
    ('22.5', '360/7')
    """
    return f"{float(number):.12g}" if 10_000 % number.denominator == 0 else str(number)


def mm_text(number: Fraction) -> str:
    """Return a length in mm as a decimal, to a thousandth where it has no short end.

    >>> mm_text(Fraction(1345, 12)), mm_text(Fraction("0.0625")), mm_text(Fraction(88))
    ('112.083', '0.0625', '88')
    """
    short = 10_000 % number.denominator == 0
    return f"{float(number if short else round(number, 3)):.12g}"


MOST_GROUPS = 100
"""Kinds of cylinders that are listed."""
MOST_NAMED = 8
"""Cylinders of one kind that are named one by one."""
_L, _R, _E, _LINK = Name("l"), Name("r"), Name("e"), Name("L")
_COLUMNS = (
    Column("cylinders"),
    Column("rod on"),
    Column(_L / _R),
    Column(_E / _R),
    Column(_LINK / _R),
    Column((Name("psi"), ", degrees")),
    Column((Product((Name("m"), _R)), " (first = 1)")),
)


def group_table(engine: Engine) -> Table:
    """Return what each kind of cylinder is: its rod, ratio, offset, link pin and m r.

    >>> from symbalance.engine.catalogue import load
    >>> [row[0] for row in group_table(load("vw-vr6")).rows]
    ['1, 3, 5', '2, 4, 6']
    """
    attached = any(c.link for c in engine.cylinders)
    rows = tuple(_cells(group, attached) for group in engine.groups[:MOST_GROUPS])
    more = len(engine.groups) > MOST_GROUPS
    which = f", the first {MOST_GROUPS} of {len(engine.groups)}: the engine file has all" if more else ""
    return Table(f"Cylinders by kind{which}", _COLUMNS, rows)


def group_facts(engine: Engine) -> list[tuple[Words, Words]]:
    """Return what the letters of the table's columns mean, those that occur."""
    mechanisms = [group.mechanism for group in engine.groups]
    entries: list[tuple[Words, Words]] = [(_L, "length of the rod")]
    if any(kind and kind.offset for kind in mechanisms):
        about = "offset of the axis, + towards the side the pin moves to after top dead centre"
        entries.append((_E, about))
    if any(isinstance(kind, LinkRod) for kind in mechanisms):
        about = "link pin's distance from the crank pin, and angle from the master rod"
        entries.append(((_LINK, ", ", Name("psi")), about))
    return entries


def _cells(group: Group, attached: bool) -> tuple[Cell, ...]:
    """Return a kind's cells; `attached` says that some rods of the engine run on others."""
    kind, cylinders = group.mechanism, group.cylinders
    numbers = [str(c.number) for c in cylinders]
    if len(numbers) > MOST_NAMED:
        numbers = [*numbers[: MOST_NAMED - 1], f"… ({len(numbers)})"]
    named = ", ".join(numbers)
    offset = _decimal(kind.offset) if kind and kind.offset else ""
    length = _decimal(kind.length) if kind else ""
    share = "" if group.size == 1 else _decimal(group.size)
    if not isinstance(kind, LinkRod):
        return named, "crank pin" if attached else "", length, offset, "", "", share
    masters = sorted({c.link.master for c in cylinders if c.link})
    on = "rod of " + (str(masters[0]) if len(masters) == 1 else "its master")
    radius, angle = _decimal(kind.link_radius), _decimal(kind.link_angle * 360)
    return named, on, length, offset, radius, angle, share


def _decimal(number: Fraction) -> Formula:
    return Decimal(short_decimal(Real(number)))


MOST_DRAWN = 16
"""Cylinders that have a row each in the table of a drawing; of more the first and a line."""


def drawing_blocks(engine: Engine) -> tuple[Block, ...]:
    """Return what a drawing of the engine says: axes, pins, stations, firings and dead centres.

    >>> from symbalance.engine.catalogue import load
    >>> [column.head for column in drawing_blocks(load("v8-90"))[0].columns]
    ['cylinder', 'axis at', 'pin at', 'station', 'fires at']
    """
    columns = _drawn_columns(engine)
    shown = engine.cylinders[: MOST_DRAWN if len(engine.cylinders) <= MOST_DRAWN else MOST_DRAWN // 2]
    rows = tuple(tuple(cell(c) for _, cell in columns) for c in shown)
    crank = "twice the crank radius" if has_shifted_dead_centres(engine) else "stroke"
    sizes = [
        f"{name} {_millimetres(next(iter(values)))}"
        for name, values in (
            (crank, {c.sizes.stroke for c in engine.cylinders if c.link is None}),
            ("rod", {c.sizes.rod for c in engine.cylinders if c.link is None}),
        )
        if len(values) == 1 and None not in values
    ]
    sizes += [_pitch_words(engine)] if _pitch_words(engine) else []
    steps = firing_intervals(engine) if engine.firing_order() and not engine.has_symbols else []
    sizes += [f"fires every {_drawn_degrees(steps[0])}"] if steps[1:] and len(set(steps)) == 1 else []
    title = ": ".join(["As drawn", ", ".join(sizes)] if sizes else ["As drawn"])
    table = Table(title, tuple(column for column, _ in columns), rows)
    left = len(engine.cylinders) - len(shown)
    return (table, Paragraph(f"and {left} cylinders more, listed in the JSON")) if left else (table,)


MOST_PITCHES = 12
"""Distances between neighbours that are listed; of more the table's stations say the same."""


def _pitch_words(engine: Engine) -> str:
    """Return the pitch, or the distances between neighbours of a bank where they are no whole pitches.

    Empty where nothing is known of it but the stations.

    >>> from symbalance.engine.builders import inline
    >>> _pitch_words(inline("1-2-3", pitch=[91, "95.5"], station_unit="mm"))
    'pitches 91, 95.5 mm, a = 91 mm'
    """
    banks = [
        sorted((c.station for c in of_bank), reverse=True)
        for of_bank in engine.grouped(lambda c: c.bank).values()
    ]
    steps = [tuple(before - after for before, after in pairwise(stations)) for stations in banks]
    pitch = engine.pitch
    if all(step.denominator == 1 for of_bank in steps for step in of_bank):
        return f"pitch {_millimetres(pitch)}" if pitch else ""
    if len(set(steps)) > 1 or len(steps[0]) > MOST_PITCHES:
        return f"a = {_millimetres(pitch)}" if pitch else ""
    text = degrees_text if pitch is None else mm_text
    listed = ", ".join(text(step * (pitch or 1)) for step in steps[0])
    return f"pitches {listed} mm, a = {_millimetres(pitch)}" if pitch else f"pitches {listed} a"


def _drawn_columns(engine: Engine) -> list[tuple[Column, Callable[[Cylinder], Cell]]]:
    """Return the columns of a drawing's table that say something, each with what a cylinder has in it."""
    columns: list[tuple[Column, Callable[[Cylinder], Cell]]] = [
        (Column("cylinder"), lambda c: str(c.number)),
        (Column("axis at", "axis"), lambda c: angle_text(c.bank)),
        (Column("pin at", "pin"), lambda c: angle_text(c.throw)),
        (Column("station" + (", mm" if engine.pitch else ""), "station"), lambda c: _station(engine, c)),
    ]
    if engine.has_symbols:
        return columns
    if engine.firing_order() is not None:
        tops = _firing_angles(engine)
        order = sorted(tops, key=tops.__getitem__)
        steps = dict(zip(order, firing_intervals(engine), strict=True))
        columns.append((Column("fires at", "fires"), lambda c: _drawn_degrees(tops[c.number])))
        if len(set(steps.values())) > 1:
            columns.append((Column("the next after", "next"), lambda c: _drawn_degrees(steps[c.number])))
    else:
        shifts = dead_centre_angles_of(engine)
        columns.append((Column("top at", "top"), lambda c: _drawn_degrees(shifts[c.number])))
    is_own = has_shifted_dead_centres(engine) or len({c.stroke for c in engine.cylinders}) > 1
    if is_own and (strokes_of := piston_strokes(engine)):
        columns.append((Column("stroke, mm", "stroke"), lambda c: _decimal_text(strokes_of[c.number])))
    return columns


def _station(engine: Engine, cylinder: Cylinder) -> Cell:
    place = cylinder.station * (engine.pitch or 1)
    return Decimal(mm_text(place)) if engine.pitch else number_cell(place)


def number_cell(value: Fraction) -> Cell:
    """Return a number as a decimal where it is short, else as a fraction."""
    return Decimal(degrees_text(value)) if 10_000 % value.denominator == 0 else str(value)


def _drawn_degrees(value: Fraction) -> str:
    return f"{degrees_text(value)}°"


def _decimal_text(value: Real) -> Cell:
    return Decimal(short_decimal(value, 6))


def _millimetres(value: Fraction | None) -> str:
    return "" if value is None else f"{float(value):.8g} mm"


def _firing_angles(engine: Engine) -> dict[int, Fraction]:
    """Return when each cylinder fires, degrees after the first; dead centres that move where they are."""
    cycle = 180 * engine.strokes
    if has_shifted_dead_centres(engine):
        return {n: round(top, 2) for n, top in firing_dead_centres(engine).items()}
    return {c.number: c.fires % cycle for c in engine.cylinders if c.fires is not None}


def dead_centre_angles_of(engine: Engine) -> dict[int, Fraction]:
    """Return the crank angle at a top dead centre of each cylinder, degrees in [0, 360)."""
    angles: dict[int, Fraction] = {}
    for mechanism, cylinders in engine.grouped(lambda c: c.mechanism).items():
        shift = dead_centre_shift(mechanism) if mechanism is not None else Fraction(0)
        for cylinder in cylinders:
            top = shift - cylinder.delay.in_degrees()
            angles[cylinder.number] = (round(top, 2) if shift else top) % 360
    return {c.number: angles[c.number] for c in engine.cylinders}


def piston_strokes(engine: Engine) -> dict[int, Real]:
    """Return every piston's stroke in mm, longer than twice the radius where the axis is offset.

    Empty where some crank radius is not known.

    >>> from symbalance.engine.catalogue import load
    >>> [str(stroke.rounded(6)) for stroke in list(piston_strokes(load("vw-vr6")).values())[:1]]
    ['90.2842']
    """
    strokes: dict[int, Real] = {}
    for mechanism, cylinders in engine.grouped(lambda c: c.mechanism).items():
        moved = mechanism is not None and any(c.offset or c.link for c in cylinders)
        over_radius = dead_centres(mechanism, 30).stroke if mechanism is not None and moved else Real(2)
        for cylinder in cylinders:
            if cylinder.radius is None:
                return {}
            strokes[cylinder.number] = over_radius * cylinder.radius
    return {c.number: strokes[c.number] for c in engine.cylinders}
