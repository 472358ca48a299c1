"""Builders of engines from what a designer knows: a firing order and bank angles, or crank pins.

Built from a firing order, theta = 0 is cylinder 1 at its firing top dead centre, and a cylinder that
fires delta later has throw = bank - delta: exact pins for any firing order, bank angles and intervals.
Built from crank pins, theta is what it is in the pins' list. Stations: in each bank the i-th cylinder
sits i - 1 pitches behind the bank's first, or where a drawing's lists say (`station_lists`); all are
shifted so that their mean is 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import accumulate
from typing import Any

from symbalance.engine.crank_train import CrankTrain, checked_sizes
from symbalance.engine.cylinders import MOST_CYLINDERS, Cylinder, checked_bank, unchecked_copy
from symbalance.engine.dead_centres import bank_shifts
from symbalance.engine.engine import Engine, checked_cylinders, checked_engine, checked_strokes
from symbalance.engine.station_lists import (
    PITCHES,
    check_firing_intervals,
    firing_angles_on_pins,
    pitch_of_stations,
    read_pins,
    read_stations,
)
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import Angle, angle, degrees
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.numbers import as_list, checked_whole, exact


def from_cylinders(
    cylinders: Iterable[Cylinder],
    *,
    crank_train: CrankTrain | None = None,
    ratio: object = None,
    **about: Any,
) -> Engine:
    """Return the engine of cylinders given one by one, with sizes that all of them share.

    Each cylinder gets those of `crank_train` that it has none of its own of; `ratio` is the rod ratio
    lambda = l/r of those whose stroke and rod are not their own. `about`: name, strokes, balancers of
    the `Engine`.

    >>> train = CrankTrain(stroke=Fraction(80), rod=Fraction(150))
    >>> twin = from_cylinders([Cylinder(1), Cylinder(2, 180, rod=140)], crank_train=train)
    >>> [str(c.ratio) for c in twin.cylinders]
    ['15/4', '7/2']
    """
    shared = _checked_train(crank_train)
    if ratio is not None:
        shared = replace(shared, given_ratio=checked_ratio(ratio))
    of_each = replace(shared, pitch=None, bore=None)
    complete = [c.with_shared(of_each) for c in checked_cylinders(cylinders)]
    return Engine(complete, pitch=shared.pitch, bore=shared.bore, **about)


def _checked_train(train: object) -> CrankTrain:
    if train is not None and not isinstance(train, CrankTrain):
        rule = "must be a CrankTrain"
        raise SymbalanceError(f"crank_train = {brief(train)}", rule, "make it with CrankTrain(...)")
    return train or CrankTrain()


def from_firing_order(
    firing_order: FiringOrder,
    *,
    banks: Sequence[object] = (0,),
    cylinders: Sequence[Sequence[int]] | None = None,
    firing_intervals: Sequence[object] | None = None,
    stagger: Sequence[object] | None = None,
    stations: Sequence[Any] | None = None,
    pitch: Sequence[object] | None = None,
    station_unit: str = PITCHES,
    offset: Sequence[object] | None = None,
    firing_at: str = "pins",
    pin_step: object = "1/100",
    strokes: int = 4,
    **about: Any,
) -> Engine:
    """Return the engine whose cylinders fire in that order.

    `banks` are angles from vertical, `cylinders` the numbers in each bank from front to rear (may be
    left out with one bank), `firing_intervals` the degrees after each firing (default: even), summing
    to 720 (360 for two strokes), `stagger` each bank's shift towards the front in pitches, `offset` how
    far each bank's axes pass the crank, mm. `pitch` lists unequal distances from cylinder to cylinder of
    a bank, `stations` every place along the crank, one list for all banks or one a bank; both, and
    `stagger`, are in mm with `station_unit` "mm". Offset moves the dead centres: with `firing_at` "pins"
    the intervals are those at which the pins pass the axes; with "dead centres" the pins are turned on by
    what the dead centres have moved, to `pin_step` of a degree, bank by bank. `about`: name, ratio,
    crank_train, as in `from_cylinders`.

    >>> [str(c.throw.in_degrees()) for c in from_firing_order("1-3-4-2").cylinders]
    ['0', '180', '180', '0']
    """
    checked_strokes(strokes)
    order = read_firing_order(firing_order)
    axes = _read_banks(banks)
    numbers = read_cylinders(cylinders, order, len(axes))
    fires = firing_angles(order, firing_intervals, 180 * strokes)
    drawing = {"stations": stations, "pitch": pitch, "stagger": stagger, "station_unit": station_unit}
    places, about = _stations_of(numbers, about, drawing)
    offsets = read_offset(offset, len(axes))

    def build(shifts: Sequence[Fraction]) -> Engine:
        return from_cylinders(
            (
                Cylinder(
                    n, axis + Angle((shift - fires[n]) / 360), axis, places[n], fires[n], offset=aside
                )
                for axis, bank, aside, shift in zip(axes, numbers, offsets, shifts, strict=True)
                for n in bank
            ),
            strokes=strokes,
            **about,
        )

    engine = build([Fraction(0)] * len(axes))
    return build(bank_shifts(engine, numbers, pin_step)) if read_firing_at(firing_at) else engine


def from_pins(
    pins: Sequence[Any],
    *,
    banks: Sequence[object] = (0,),
    cylinders: Sequence[Sequence[int]] | None = None,
    splay: Sequence[object] | None = None,
    firing_order: FiringOrder | None = None,
    firing_intervals: Sequence[object] | None = None,
    stagger: Sequence[object] | None = None,
    stations: Sequence[Any] | None = None,
    pitch: Sequence[object] | None = None,
    station_unit: str = PITCHES,
    offset: Sequence[object] | None = None,
    strokes: int = 4,
    **about: Any,
) -> Engine:
    """Return the engine whose crank has pins at these angles at theta = 0, front to rear, in degrees.

    `pins` is one list, of pins that the cylinders of all banks share, those of each bank turned on by its
    `splay`; or a list for each bank, where each cylinder has a pin of its own. With a `firing_order` each
    cylinder fires when its pin has brought it to the top, in that order, evenly where the pins allow it;
    where they leave open in which turn, `firing_intervals` say it. Without one, firings are left open.
    The rest is as in `from_firing_order`.

    >>> six = from_pins([0, 240, 120], banks=[-45, 45], cylinders=[[1, 3, 5], [2, 4, 6]], splay=[0, 30])
    >>> [c.throw.as_text() for c in six.cylinders]
    ['0', '-120', '120', '30', '-90', '150']
    """
    checked_strokes(strokes)
    axes = _read_banks(banks)
    if not as_list(pins, "pins"):
        raise SymbalanceError("pins = []", "a crank has at least one pin", "give the throw of each")
    order = None if firing_order is None else read_firing_order(firing_order)
    if order is None and firing_intervals is not None:
        what = f"firing_intervals = {brief(firing_intervals)}"
        raise SymbalanceError(what, "follow a firing order", "add firing_order = [1, ...]")
    if cylinders is None and order is None and len(axes) == 1:
        cylinders = [list(range(1, 1 + len(as_list(pins, "pins"))))]
    numbers = read_cylinders(cylinders, order, len(axes))
    throws = read_pins(pins, splay, numbers)
    drawing = {"stations": stations, "pitch": pitch, "stagger": stagger, "station_unit": station_unit}
    places, about = _stations_of(numbers, about, drawing)
    offsets = read_offset(offset, len(axes))
    fires: dict[int, Fraction] = {}
    if order is not None:
        delays = {n: axis - throws[n] for axis, bank in zip(axes, numbers, strict=True) for n in bank}
        if any(delay.symbols for delay in delays.values()):
            rule = "cannot be timed where angles hold symbols"
            raise SymbalanceError(f"firing_order = {brief(order)}", rule, "leave it out")
        tops = {n: delay.in_degrees() for n, delay in delays.items()}
        if firing_intervals is None:
            fires = firing_angles_on_pins(order, tops, 180 * strokes)
        else:
            fires = firing_angles(order, firing_intervals, 180 * strokes)
            train = about.get("crank_train")
            if not any(offsets) and not (train and train.offset):  # which moves the dead centres
                check_firing_intervals(fires, tops)
    return from_cylinders(
        (
            Cylinder(n, throws[n], axis, places[n], fires.get(n), offset=aside)
            for axis, bank, aside in zip(axes, numbers, offsets, strict=True)
            for n in bank
        ),
        strokes=strokes,
        **about,
    )


def _read_banks(banks: Sequence[object]) -> list[Angle]:
    axes = [checked_bank(bank, f"banks[{i}]") for i, bank in enumerate(as_list(banks, "banks"), 1)]
    if not axes:
        raise SymbalanceError("banks = []", "an engine has at least one bank", "[0] stands upright")
    return axes


def _stations_of(
    numbers: list[list[int]], about: dict[str, Any], drawing: dict[str, Any]
) -> tuple[dict[int, Fraction], dict[str, Any]]:
    """Return each cylinder's station, and `about` with the pitch a that a list in mm begins with."""
    train = _checked_train(about.get("crank_train"))
    pitch_mm = pitch_of_stations(train.pitch, drawing["pitch"], drawing["station_unit"])
    places = read_stations(numbers, pitch_mm, **drawing)
    if pitch_mm == train.pitch:
        return places, about
    return places, {**about, "crank_train": replace(train, pitch=pitch_mm)}


def inline(
    firing_order: FiringOrder | None = None, *, throws: Sequence[object] | None = None, **rest: Any
) -> Engine:
    """Return an in-line engine, from its firing order, from its `throws`, front to rear, or from both.

    `throws` are in degrees. `rest` goes to `from_firing_order` (firing_intervals, pitch, strokes) or,
    with throws, to `from_pins`; or it names the engine (name, ratio).

    >>> [str(c.station) for c in inline(throws=[0, 120, 240]).cylinders]
    ['1', '0', '-1']
    """
    if firing_order is None and throws is None:
        raise SymbalanceError(
            "inline(...)", "takes a firing order or throws", "give one of them, or both"
        )
    if throws is not None:
        return from_pins(throws, firing_order=firing_order, **rest)
    assert firing_order is not None
    return from_firing_order(firing_order, **rest)


def vee(
    bank_angle: object,
    firing_order: FiringOrder | None = None,
    *,
    pins: Sequence[object] | None = None,
    splay: object = 0,
    cylinders: Sequence[Sequence[int]] | None = None,
    stagger: Sequence[object] | None = None,
    **rest: Any,
) -> Engine:
    """Return a vee, from its firing order or from the throws of its `pins`, front to rear, or from both.

    The banks stand at -bank_angle/2 (left, odd numbers unless `cylinders` says otherwise) and
    +bank_angle/2. With `pins` each is shared by two cylinders, the right one's turned on by `splay`;
    two lists are the pins of each bank. `rest` is as in `from_firing_order` and `from_pins`.
    The bank angle may be a SymPy symbol: the angle itself, in radians.

    >>> [c.throw.as_text() for c in vee(60, "1-2-3-4-5-6").cylinders]
    ['-30', '90', '-150', '-90', '30', '150']
    >>> [c.throw.as_text() for c in vee(90, pins=[0, 90], splay=30).cylinders]
    ['0', '90', '30', '120']
    """
    full = angle(bank_angle, "bank_angle")
    axes = [full.scaled(Fraction(-1, 2)), full.scaled(Fraction(1, 2))]
    if not full.symbols and not 0 <= full.turns <= Fraction(1, 2):
        remedy = "degrees between the banks; banks that hang: from_firing_order(banks=[-150, 150])"
        raise SymbalanceError(f"bank_angle = {brief(bank_angle)}", "must lie in [0, 180]", remedy)
    if firing_order is None and pins is None:
        raise SymbalanceError("vee(...)", "takes a firing order or pins", "give one of them, or both")
    count = len(read_firing_order(firing_order)) if firing_order is not None else 0
    nested = False
    if pins is not None:
        throws = as_list(pins, "pins")
        nested = any(isinstance(own, list | tuple) for own in throws)
        counts = (len(own) if isinstance(own, list | tuple) else 1 for own in throws)
        count = count or (sum(counts) if nested else 2 * len(throws))
    banks = cylinders or [list(range(1, count + 1, 2)), list(range(2, count + 1, 2))]
    rest = {"banks": axes, "cylinders": banks, "stagger": stagger, **rest}
    if pins is None:
        assert firing_order is not None
        return from_firing_order(firing_order, **rest)
    turned = {} if nested and not splay else {"splay": [0, splay]}
    return from_pins(pins, firing_order=firing_order, **turned, **rest)


def vr(
    bank_angle: object,
    firing_order: FiringOrder,
    *,
    offset: object,
    stroke: object,
    rod: object,
    cylinders: Sequence[Sequence[int]] | None = None,
    stagger: Sequence[object] | None = ("1/4", "-1/4"),
    firing_at: str = "dead centres",
    **rest: Any,
) -> Engine:
    """Return a narrow vee: two banks so close that their axes pass the crank, `offset` mm to each side.

    The left bank's axes (odd numbers unless `cylinders` says otherwise) pass the crank on its left. Half
    a pitch lies between neighbouring cylinders; the crank's pins are split so that dead centres
    follow one another at the firing intervals (`pin_step`, `firing_at` as in `from_firing_order`).

    >>> six = vr(15, "1-5-3-6-2-4", offset=12.5, stroke=90.3, rod=164, pin_step="1/2")
    >>> [c.throw.as_text() for c in six.cylinders]
    ['-11', '109', '-131', '-109', '131', '11']
    """
    aside = exact(offset, "offset")
    sizes = checked_sizes({"stroke": stroke, "rod": rod})
    return vee(
        bank_angle,
        firing_order,
        cylinders=cylinders,
        stagger=stagger,
        offset=[-aside, aside],
        crank_train=sizes,
        firing_at=firing_at,
        **rest,
    )


def boxer(
    firing_order: FiringOrder, *, stagger: Sequence[object] | None = ("1/4", "-1/4"), **rest: Any
) -> Engine:
    """Return a horizontally opposed engine with a pin for each cylinder.

    The left bank (odd numbers) stands at -90 degrees. `stagger` shifts the banks along the crank; the
    default sets neighbouring cylinders half a pitch apart. Without a stagger a boxer has no couple.
    """
    return vee(180, firing_order, stagger=stagger, **rest)


def w(
    banks: Sequence[object],
    firing_order: FiringOrder,
    *,
    cylinders: Sequence[Sequence[int]],
    **rest: Any,
) -> Engine:
    """Return a W or broad-arrow engine: three or more `banks`, the cylinders' numbers in each.

    >>> arrow = w([-60, 0, 60], "1-2-3", cylinders=[[1], [2], [3]])
    >>> [c.throw.as_text() for c in arrow.cylinders]
    ['-60', '120', '-60']
    """
    return from_firing_order(firing_order, banks=banks, cylinders=cylinders, **rest)


def radial(count: int, *, strokes: int = 4, **about: Any) -> Engine:
    """Return a single-row radial of `count` cylinders, evenly spread, all rods on one pin.

    Each rod is taken as centred (no link rods). A four-stroke with an odd count fires every other
    cylinder (1-3-5-2-4), a two-stroke each in turn; for a four-stroke with an even count the firing
    angles are left open.

    >>> radial(5).firing_order()
    [1, 3, 5, 2, 4]
    """
    count = checked_whole(count, "count", 1, MOST_CYLINDERS, "cylinders of one row")
    checked_strokes(strokes)
    cylinders = []
    for i in range(count):
        direction = Fraction(360 * i, count)
        fires = direction + (360 if strokes == 4 and i % 2 else 0)
        known = strokes == 2 or count % 2 == 1
        cylinders.append(
            Cylinder(i + 1, 0, Angle(direction / 360).normalized(), 0, fires if known else None)
        )
    return from_cylinders(cylinders, strokes=strokes, **about)


def with_bank_angle(engine: Engine, bank_angle: object) -> Engine:
    """Return a vee with another angle between its banks, a number or a SymPy symbol; its crank stays.

    The bisector of the banks stays too. Firing angles, which depend on the bank angle, are left out, and
    theta counts from where the pin of cylinder 1 lies on the bisector, which keeps formulas short (with
    counterweights or shafts, whose angles are those at theta = 0, it stays). Refused for an engine that
    has not two banks, and for one whose banks hold symbols.

    >>> import sympy
    >>> from symbalance.engine.catalogue import load
    >>> [c.bank.as_text() for c in with_bank_angle(load("v2-90"), sympy.Symbol("alpha")).cylinders]
    ['-alpha/2', 'alpha/2']
    """
    banks = sorted({c.bank for c in checked_engine(engine).cylinders}, key=lambda bank: bank.turns)
    if len(banks) != 2 or any(bank.symbols for bank in banks):
        rule = f"has {len(banks)} bank{'s' if len(banks) > 1 else ''}, and a bank angle lies between two"
        raise SymbalanceError(f"engine {engine.name!r}", rule, "take a vee")
    half = angle(bank_angle, "bank_angle").scaled(Fraction(1, 2))
    between = banks[1].turns - banks[0].turns
    middle = (banks[0].turns + banks[1].turns) / 2
    if between > Fraction(1, 2):  # the banks hang: the smaller angle is the other one
        middle, banks = (middle + Fraction(1, 2)) % 1, banks[::-1]
    axes = {banks[0]: Angle(middle) - half, banks[1]: Angle(middle) + half}
    turned = Angle(Fraction(0)) if engine.balancers else Angle(middle) - engine.first.throw
    cylinders = [
        unchecked_copy(c, bank=axes[c.bank], throw=(c.throw + turned).normalized(), fires=None)
        for c in engine.cylinders
    ]
    about = {"strokes": engine.strokes, "name": engine.name, "pitch": engine.pitch}
    return Engine(cylinders, balancers=engine.balancers, **about)


FiringOrder = str | Sequence[int]
FIRING_AT = ("pins", "dead centres")


def read_firing_order(firing_order: FiringOrder) -> list[int]:
    """Return a firing order, given as text or as a list, as cylinder numbers."""
    numbers: Iterable[object]
    if isinstance(firing_order, str):
        parts = [part.strip() for part in firing_order[:10_000].split("-")]
        numbers = [int(p) if p.isascii() and p.isdigit() and len(p) < 6 else p for p in parts]
    else:
        numbers = as_list(firing_order, "firing_order")
    order = []
    for number in numbers:
        if isinstance(number, bool) or not isinstance(number, int) or number < 1:
            raise SymbalanceError(
                f"firing_order = {brief(firing_order)}",
                f"holds {brief(number)}, which is no cylinder number",
                "write it like [1, 3, 4, 2]",
            )
        order.append(number)
    if not order:
        raise SymbalanceError("firing_order = []", "names no cylinder", "write it like [1, 3, 4, 2]")
    if len(order) > MOST_CYLINDERS:
        raise SymbalanceError(
            f"firing_order of {len(order)} numbers",
            f"an engine has 1 to {MOST_CYLINDERS} cylinders",
            "shorten it",
        )
    repeated = sorted({n for n in order if order.count(n) > 1})
    if repeated:
        raise SymbalanceError(
            f"firing_order = {brief(firing_order)}",
            f"must name each cylinder once, but repeats {repeated[0]}",
            "correct the order",
        )
    return order


def read_cylinders(
    cylinders: Sequence[Sequence[int]] | None, order: list[int] | None, banks: int
) -> list[list[int]]:
    """Return the numbers in each bank, checked against the firing order where there is one."""
    if cylinders is None:
        if banks > 1:
            raise SymbalanceError(
                f"banks of {banks} angles",
                "need cylinders, the numbers in each",
                "as in [[1, 3, 5], [2, 4, 6]]",
            )
        assert order is not None
        cylinders = [sorted(order)]
    cylinders = [as_list(bank, "cylinders") for bank in as_list(cylinders, "cylinders")]
    if len(cylinders) != banks:
        raise SymbalanceError(
            f"cylinders = {brief(cylinders)}",
            f"has {len(cylinders)} lists for {banks} bank(s)",
            "give one list of numbers a bank",
        )
    if not all(cylinders):
        raise SymbalanceError(
            f"cylinders = {brief(cylinders)}",
            "holds an empty bank",
            "leave the bank out, or name its cylinders",
        )
    numbers = [n for bank in cylinders for n in bank]
    if order is None:
        return [list(bank) for bank in cylinders]  # repeated numbers are refused with the cylinders
    if 1 not in numbers:
        raise SymbalanceError(
            f"cylinders = {brief(cylinders)}", "lacks cylinder 1", "theta = 0 is its firing"
        )
    for number in order:
        if number not in numbers:
            raise SymbalanceError(
                f"firing_order = {brief(order)}",
                f"names cylinder {number}, which no bank holds",
                "make order and cylinders agree",
            )
    for number in numbers:
        if number not in order or numbers.count(number) > 1:
            what = "repeats" if numbers.count(number) > 1 else "holds, but the firing order misses,"
            raise SymbalanceError(
                f"cylinders = {brief(cylinders)}",
                f"{what} cylinder {brief(number)}",
                "name each cylinder once in both",
            )
    return [list(bank) for bank in cylinders]


def firing_angles(
    order: list[int], intervals: Sequence[object] | None, cycle: int
) -> dict[int, Fraction]:
    """Return each cylinder's firing angle after cylinder 1, in degrees."""
    if intervals is None:
        steps = [Fraction(cycle, len(order))] * len(order)
    else:
        values = as_list(intervals, "firing_intervals")
        steps = [degrees(step, f"firing_intervals[{i}]").in_degrees() for i, step in enumerate(values, 1)]
        _check_intervals(steps, len(order), cycle)
    starts = [Fraction(0), *accumulate(steps)]
    first = starts[order.index(1)]
    return {number: (start - first) % cycle for number, start in zip(order, starts, strict=False)}


def _check_intervals(steps: list[Fraction], count: int, cycle: int) -> None:
    if len(steps) != count:
        raise SymbalanceError(
            f"firing_intervals of {len(steps)} values",
            f"must hold {count}, one after each firing",
            "the last leads back to the first",
        )
    if min(steps) < 0:
        raise SymbalanceError(
            f"firing_intervals that hold {brief(min(steps))}",
            "must not be negative",
            "use degrees after each firing",
        )
    if sum(steps) != cycle:
        raise SymbalanceError(
            f"firing_intervals that sum to {brief(sum(steps))}",
            f"must sum to {cycle}",
            "720 degrees in a four-stroke, 360 in a two-stroke",
        )


def read_offset(offset: Sequence[object] | None, banks: int) -> list[Fraction | None]:
    """Return each bank's own offset in mm, None where it has none of its own."""
    if offset is None:
        return [None] * banks
    values = as_list(offset, "offset")
    if len(values) != banks:
        rule = f"has {len(values)} values for {banks} bank(s)"
        raise SymbalanceError(f"offset = {brief(values)}", rule, "give one value a bank, in mm")
    return [exact(value, f"offset[{i}]") for i, value in enumerate(values, 1)]


def read_firing_at(firing_at: object) -> bool:
    """Tell whether intervals count between dead centres, not between the pins' passing the axes."""
    if firing_at not in FIRING_AT:
        what, rule = f"firing_at = {brief(firing_at)}", f"must be one of {', '.join(FIRING_AT)}"
        raise SymbalanceError(what, rule, "they differ where cylinders are offset")
    return firing_at == "dead centres"
