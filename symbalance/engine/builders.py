"""Layouts from what a designer knows: a firing order and bank angles, or a crank's pins.

Built from a firing order, theta = 0 is cylinder 1 at its firing top dead centre, and a cylinder that
fires delta later has throw = bank - delta: exact pins for any firing order, bank angles and intervals.
Stations: in each bank the i-th cylinder sits i - 1 pitches behind the bank's first; all are shifted so
that their mean is 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.engine.cylinders import MOST_CYLINDERS, Cylinder, checked_bank
from symbalance.engine.engine import Engine, checked_cylinders, checked_strokes
from symbalance.engine.firing import (
    FiringOrder,
    firing_angles,
    read_cylinders,
    read_firing_at,
    read_firing_order,
    read_offset,
    read_stagger,
    stations,
)
from symbalance.engine.tops import bank_leads
from symbalance.engine.trains import CrankTrain, own_train
from symbalance.errors import SymbalanceError, shown
from symbalance.exact.angles import Angle, angle
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.numbers import checked_whole, exact, listed


def from_cylinders(
    cylinders: Iterable[Cylinder],
    *,
    crank_train: CrankTrain | None = None,
    ratio: object = None,
    **about: Any,
) -> Engine:
    """Return the engine of cylinders told one by one, with sizes that all of them share.

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
    of_each = replace(shared, pitch=None)
    complete = [c.with_shared(of_each) for c in checked_cylinders(cylinders)]
    return Engine(complete, pitch=shared.pitch, **about)


def _checked_train(train: object) -> CrankTrain:
    if train is not None and not isinstance(train, CrankTrain):
        rule = "must be a CrankTrain"
        raise SymbalanceError(f"crank_train = {shown(train)}", rule, "make it with CrankTrain(...)")
    return train or CrankTrain()


def from_firing_order(
    firing_order: FiringOrder,
    *,
    banks: Sequence[object] = (0,),
    cylinders: Sequence[Sequence[int]] | None = None,
    firing_intervals: Sequence[object] | None = None,
    stagger: Sequence[object] | None = None,
    offset: Sequence[object] | None = None,
    firing_at: str = "pins",
    pin_step: object = "1/100",
    strokes: int = 4,
    **about: Any,
) -> Engine:
    """Return the layout whose cylinders fire in that order.

    `banks` are angles from vertical, `cylinders` the numbers in each bank from front to rear (may be
    left out with one bank), `firing_intervals` the degrees after each firing (default: even), summing
    to 720 (360 for two strokes), `stagger` each bank's shift towards the front in pitches, `offset` how
    far each bank's axes pass the crank, mm. Offset moves the dead centres: with `firing_at` "pins" the
    intervals are those at which the pins pass the axes; with "dead centres" the pins are turned on by
    what the dead centres have moved, to `pin_step` of a degree, bank by bank. `about`: name, ratio,
    crank_train, as in `from_cylinders`.

    >>> [str(c.throw.in_degrees()) for c in from_firing_order("1-3-4-2").cylinders]
    ['0', '180', '180', '0']
    """
    checked_strokes(strokes)
    order = read_firing_order(firing_order)
    axes = [checked_bank(bank, f"banks[{i}]") for i, bank in enumerate(listed(banks, "banks"), 1)]
    if not axes:
        raise SymbalanceError("banks = []", "an engine has at least one bank", "[0] stands upright")
    numbers = read_cylinders(cylinders, order, len(axes))
    fires = firing_angles(order, firing_intervals, 180 * strokes)
    places = stations(numbers, read_stagger(stagger, len(axes)))
    offsets = read_offset(offset, len(axes))

    def made(leads: Sequence[Fraction]) -> Engine:
        return from_cylinders(
            (
                Cylinder(
                    n, axis + Angle((turn - fires[n]) / 360), axis, places[n], fires[n], offset=aside
                )
                for axis, bank, aside, turn in zip(axes, numbers, offsets, leads, strict=True)
                for n in bank
            ),
            strokes=strokes,
            **about,
        )

    layout = made([Fraction(0)] * len(axes))
    return made(bank_leads(layout, numbers, pin_step)) if read_firing_at(firing_at) else layout


def inline(
    firing_order: FiringOrder | None = None, *, throws: Sequence[object] | None = None, **rest: Any
) -> Engine:
    """Return an in-line engine, from its firing order or from its `throws`, front to rear, in degrees.

    `rest` goes to `from_firing_order` (firing_intervals, strokes) or names the engine (name, ratio).

    >>> [str(c.station) for c in inline(throws=[0, 120, 240]).cylinders]
    ['1', '0', '-1']
    """
    if (firing_order is None) == (throws is None):
        raise SymbalanceError("inline(...)", "takes either a firing order or throws", "give one of them")
    if firing_order is not None:
        return from_firing_order(firing_order, **rest)
    assert throws is not None
    return _on_pins(throws, [Angle(Fraction(0))], [Angle(Fraction(0))], (0,), rest)


def vee(
    bank_angle: object,
    firing_order: FiringOrder | None = None,
    *,
    pins: Sequence[object] | None = None,
    splay: object = 0,
    cylinders: Sequence[Sequence[int]] | None = None,
    stagger: Sequence[object] = (0, 0),
    **rest: Any,
) -> Engine:
    """Return a vee, from its firing order or from the throws of its `pins`, front to rear.

    The banks stand at -bank_angle/2 (left, odd numbers unless `cylinders` says otherwise) and
    +bank_angle/2. With `pins` each is shared by two cylinders, the right one's turned on by `splay`.
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
        raise SymbalanceError(f"bank_angle = {shown(bank_angle)}", "must lie in [0, 180]", remedy)
    if (firing_order is None) == (pins is None):
        raise SymbalanceError("vee(...)", "takes either a firing order or pins", "give one of them")
    if firing_order is None:
        assert pins is not None
        return _on_pins(pins, axes, [Angle(Fraction(0)), angle(splay, "splay")], stagger, rest)
    count = len(read_firing_order(firing_order))
    banks = cylinders or [list(range(1, count + 1, 2)), list(range(2, count + 1, 2))]
    return from_firing_order(firing_order, banks=axes, cylinders=banks, stagger=stagger, **rest)


def vr(
    bank_angle: object,
    firing_order: FiringOrder,
    *,
    offset: object,
    stroke: object,
    rod: object,
    cylinders: Sequence[Sequence[int]] | None = None,
    stagger: Sequence[object] = ("1/4", "-1/4"),
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
    sizes = own_train({"stroke": stroke, "rod": rod})
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
    firing_order: FiringOrder, *, stagger: Sequence[object] = ("1/4", "-1/4"), **rest: Any
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
        spread = Fraction(360 * i, count)
        fires = spread + (360 if strokes == 4 and i % 2 else 0)
        known = strokes == 2 or count % 2 == 1
        cylinders.append(
            Cylinder(i + 1, 0, Angle(spread / 360).normalized(), 0, fires if known else None)
        )
    return from_cylinders(cylinders, strokes=strokes, **about)


def _on_pins(
    pins: Sequence[object],
    axes: list[Angle],
    splays: list[Angle],
    stagger: Sequence[object],
    about: dict[str, Any],
) -> Engine:
    """Return one cylinder of every bank on each pin, numbered pin by pin."""
    throws = [angle(pin, f"pins[{i}]") for i, pin in enumerate(listed(pins, "pins"), 1)]
    if not throws:
        raise SymbalanceError("pins = []", "a crank has at least one pin", "give the throw of each")
    numbers = [list(range(1 + b, 1 + len(axes) * len(throws), len(axes))) for b in range(len(axes))]
    places = stations(numbers, read_stagger(stagger, len(axes)))
    return from_cylinders(
        (
            Cylinder(n, throw + splay, axis, places[n])
            for axis, splay, bank in zip(axes, splays, numbers, strict=True)
            for n, throw in zip(bank, throws, strict=True)
        ),
        **about,
    )
