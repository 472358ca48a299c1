"""Stations and crank pins of an engine from the lists on its drawing, front to rear, bank by bank.

A flat list holds for every bank: its first value for the first cylinder of each, and so on. A list of
lists has one for each bank. Stations are in cylinder pitches of a = `pitch` of [crank_train], or, with
`station_unit` "mm", in millimetres; either way they are counted from their own mean.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import accumulate, pairwise
from typing import Any, TypeVar

from symbalance.engine.cylinders import LONGEST_STATION
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import Angle, angle
from symbalance.text.numbers import as_list, exact

PITCHES, MILLIMETRES = STATION_UNITS = ("pitches", "mm")
MOST_PITCHES = 10
"""Between neighbours of a bank: more than that are millimetres whose unit was forgotten."""
LEAST_MM = 5
"""Between neighbours of a bank: less than that are pitches, as the smallest bores are of this size."""
_IN_MM = 'if they are mm, add station_unit = "mm"'
_IN_PITCHES = "if they are pitches, leave out station_unit"
T = TypeVar("T")
Banks = Sequence[Sequence[int]]
"""The cylinders' numbers in each bank, front to rear."""


def read_stagger(stagger: Sequence[object] | None, banks: int) -> list[Fraction]:
    """Return each bank's shift towards the front, in the unit of the stations."""
    return _for_each_bank(stagger, "stagger", banks, "in pitches", exact) or [Fraction(0)] * banks


def read_splay(splay: Sequence[object] | None, banks: int) -> list[Angle]:
    """Return how far each bank's pins are turned on from those listed."""
    return _for_each_bank(splay, "splay", banks, "in degrees", angle) or [Angle(Fraction(0))] * banks


def _for_each_bank(
    values: Sequence[object] | None, name: str, banks: int, unit: str, read: Callable[[object, str], T]
) -> list[T] | None:
    if values is None:
        return None
    listed = as_list(values, name)
    if len(listed) != banks:
        rule = f"has {len(listed)} values for {banks} bank(s)"
        raise SymbalanceError(f"{name} = {brief(listed)}", rule, f"give one value a bank, {unit}")
    return [read(value, f"{name}[{i}]") for i, value in enumerate(listed, 1)]


def pitch_of_stations(
    pitch_mm: Fraction | None, pitch: Sequence[object] | None, station_unit: str
) -> Fraction | None:
    """Return a in mm: that of the engine, or the first of the distances that are listed in mm."""
    if not _is_in_mm(station_unit) or pitch_mm is not None or pitch is None:
        return pitch_mm
    listed = as_list(pitch, "pitch", "[108, 120, 108]")
    return exact(listed[0], "pitch[1]") if listed else None


def read_stations(
    banks: Banks,
    pitch_mm: Fraction | None = None,
    *,
    stations: Sequence[Any] | None = None,
    pitch: Sequence[object] | None = None,
    stagger: Sequence[object] | None = None,
    station_unit: str = PITCHES,
) -> dict[int, Fraction]:
    """Return each cylinder's station in pitches, their mean at 0.

    Without `stations` the cylinders of a bank stand one pitch apart, or as far as `pitch` says, all banks
    in line at the front; `stagger` is each bank's shift towards the front. `pitch_mm` is a, which
    stations in mm are divided by.

    >>> {n: str(s) for n, s in read_stations([[1, 2, 3]], pitch=[1, "5/4"]).items()}
    {1: '13/12', 2: '1/12', 3: '-7/6'}
    >>> places = read_stations([[1, 3], [2]], Fraction(90), stations=[[0, -90], [-45]], station_unit="mm")
    >>> {n: str(s) for n, s in places.items()}
    {1: '1/2', 3: '-1/2', 2: '0'}
    >>> places = read_stations([[1, 3], [2, 4]], Fraction(100), stagger=[10, -10], station_unit="mm")
    >>> {n: str(s) for n, s in places.items()}
    {1: '3/5', 3: '-2/5', 2: '2/5', 4: '-3/5'}
    """
    in_mm = _is_in_mm(station_unit)
    if stations is not None and pitch is not None:
        what, rule = f"pitch = {brief(pitch)}", "says with stations where the cylinders stand twice"
        raise SymbalanceError(what, rule, "leave one of them out")
    places = _places(banks, stations, pitch)
    shifts = read_stagger(stagger, len(banks))
    if stagger is not None and stations is not None and _is_nested(stations):
        what, rule = f"stagger = {brief(stagger)}", "shifts banks whose stations are listed one by one"
        raise SymbalanceError(what, rule, "put it into stations, or give one list for all banks")
    name = "stations" if stations is not None else "pitch" if pitch is not None else ""
    if name:
        _check_distances(places, name, in_mm)
    scale = Fraction(1)
    if in_mm and (name or stagger is not None):
        if pitch_mm is None:
            what, rule = 'station_unit = "mm"', "needs the pitch a, in which couples count"
            raise SymbalanceError(what, rule, "give pitch = ..., mm, of the crank train")
        scale = pitch_mm
    # Places that nobody listed count in pitches, whatever the unit of what is listed.
    of_places = scale if name else Fraction(1)
    raw = {
        number: shift / scale + place / of_places
        for bank, in_bank, shift in zip(banks, places, shifts, strict=True)
        for number, place in zip(bank, in_bank, strict=True)
    }
    mean = sum(raw.values(), Fraction(0)) / len(raw)
    placed = {number: station - mean for number, station in raw.items()}
    if name:
        _check_reach(placed, name)
    return placed


def _is_in_mm(station_unit: object) -> bool:
    if station_unit not in STATION_UNITS:
        what, rule = f"station_unit = {brief(station_unit)}", f"must be one of {', '.join(STATION_UNITS)}"
        raise SymbalanceError(what, rule, "it is that of stations, pitch and stagger")
    return station_unit == MILLIMETRES


def _places(
    banks: Banks, stations: Sequence[Any] | None, pitch: Sequence[object] | None
) -> list[list[Fraction]]:
    """Return the place of every cylinder of each bank before it is staggered, front to rear."""
    if stations is not None:
        return list_for_banks(stations, "stations", banks, exact, "[[0, -108], [-30, -138]]")
    most = max(map(len, banks))
    steps = [Fraction(1)] * (most - 1)
    if pitch is not None:
        example = "[108, 120, 108]; one number, in mm, is the crank train's"
        listed = as_list(pitch, "pitch", example)
        if len(listed) != most - 1:
            rule = f"has {len(listed)} distances for {most} cylinders of a bank"
            remedy = f"give {most - 1}, from each to the next, front to rear"
            raise SymbalanceError(f"pitch = {brief(listed)}", rule, remedy)
        steps = [exact(value, f"pitch[{i}]") for i, value in enumerate(listed, 1)]
    from_front = list(accumulate((-step for step in steps), initial=Fraction(0)))
    return [from_front[: len(bank)] for bank in banks]


def read_pins(pins: Sequence[Any], splay: Sequence[object] | None, banks: Banks) -> dict[int, Angle]:
    """Return each cylinder's crank pin angle at theta = 0, those of a bank turned on by its `splay`.

    >>> pins = read_pins([0, 120], [0, 30], [[1, 3], [2, 4]])
    >>> {n: pin.as_text() for n, pin in pins.items()}
    {1: '0', 3: '120', 2: '30', 4: '150'}
    """
    throws = list_for_banks(pins, "pins", banks, angle, "[[0, 120, 240], [30, 150, 270]]")
    if splay is not None and _is_nested(pins):
        what, rule = f"splay = {brief(splay)}", "turns banks whose pins are listed one by one"
        raise SymbalanceError(what, rule, "put it into pins, or give one list for all banks")
    turned = zip(banks, throws, read_splay(splay, len(banks)), strict=True)
    return {n: throw + by for bank, of_bank, by in turned for n, throw in zip(bank, of_bank, strict=True)}


def list_for_banks(
    values: Sequence[Any],
    name: str,
    banks: Banks,
    read: Callable[[object, str], T],
    example: str,
) -> list[list[T]]:
    """Return the values of every cylinder of each bank, from one list for all banks or one a bank."""
    listed = as_list(values, name)
    if not _is_nested(listed):
        most = max(map(len, banks))
        if len(listed) != most:
            rule = f"must hold {most}, front to rear"
            remedy = "name one a cylinder"
            if len(banks) > 1:
                rule, remedy = f"{rule}, or a list for each bank", f"as in {example}"
            raise SymbalanceError(f"{name} of {len(listed)} values", rule, remedy)
        of_all = [read(value, f"{name}[{i}]") for i, value in enumerate(listed, 1)]
        return [of_all[: len(bank)] for bank in banks]
    if len(listed) != len(banks):
        rule = f"must hold {len(banks)}, one a bank"
        raise SymbalanceError(f"{name} of {len(listed)} lists", rule, f"as in {example}")
    of_banks = []
    for i, (own, bank) in enumerate(zip(listed, banks, strict=True), 1):
        of_bank = as_list(own, f"{name}[{i}]")
        if len(of_bank) != len(bank):
            rule = f"must hold {len(bank)}, as the bank has cylinders"
            raise SymbalanceError(f"{name}[{i}] of {len(of_bank)} values", rule, f"as in {example}")
        of_banks.append([read(value, f"{name}[{i}][{j}]") for j, value in enumerate(of_bank, 1)])
    return of_banks


def _is_nested(values: object) -> bool:
    return isinstance(values, list | tuple) and any(isinstance(v, list | tuple) for v in values)


def _check_distances(places: Sequence[Sequence[Fraction]], name: str, in_mm: bool) -> None:
    """Refuse stations that do not fall from front to rear, and those that are in the other unit."""
    for before, after in (pair for bank in places for pair in pairwise(bank)):
        apart = before - after
        if apart <= 0:
            what = f"{name} that lead from {brief(before)} to {brief(after)}"
            rule, remedy = "must fall from front to rear", "+ is towards the front"
            if name == "pitch":
                what, rule, remedy = (
                    f"pitch that holds {brief(apart)}",
                    "must be positive",
                    "front to rear",
                )
            raise SymbalanceError(what, rule, remedy)
        if in_mm and apart < LEAST_MM:
            what = f"{name} of neighbours {float(apart):.6g} mm apart"
            raise SymbalanceError(what, f"must be {LEAST_MM} mm apart or more", _IN_PITCHES)
        if not in_mm and apart > MOST_PITCHES:
            what = f"{name} of neighbours {float(apart):.6g} pitches apart"
            raise SymbalanceError(what, f"must be {MOST_PITCHES} pitches apart or less", _IN_MM)


def _check_reach(stations: dict[int, Fraction], name: str) -> None:
    far = max(stations.values(), key=abs)
    if abs(far) > LONGEST_STATION:
        rule = f"must lie within {-LONGEST_STATION} and {LONGEST_STATION} pitches"
        raise SymbalanceError(f"{name} that reach {brief(far)} pitches", rule, "check the pitch a")


def firing_angles_on_pins(
    order: Sequence[int], tops: dict[int, Fraction], cycle: int
) -> dict[int, Fraction]:
    """Return each cylinder's firing angle after cylinder 1, at which its pin has brought it to the top.

    `tops` are the crank angles at which they stand there, degrees modulo 360. Even intervals where the
    pins allow them. Else each cylinder fires as soon as it is at the top after the one before it in the
    order. Refused where that takes more turns than a cycle has, and where it takes fewer: in some
    interval the crank then turns once more, and which it is only `firing_intervals` can say.

    >>> firing_angles_on_pins([1, 3, 4, 2], dict(zip([1, 2, 3, 4], [0, 90, 270, 180])), 720)
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: firing_order = [1, 3, 4, 2]: takes 3 turns of a crank ...
    """
    first = order.index(1)
    turned = [*order[first:], *order[:first]]
    even = {number: Fraction(cycle * i, len(order)) for i, number in enumerate(turned)}
    if all((angle_of_firing - tops[n] + tops[1]) % 360 == 0 for n, angle_of_firing in even.items()):
        return even
    steps = [(tops[b] - tops[a]) % 360 for a, b in pairwise([*turned, turned[0]])]
    total = sum(steps, Fraction(0))
    if total != cycle:
        what = f"firing_order = {brief(list(order))}"
        taken, turns = (f"{n / 360} turn{'' if n == 360 else 's'}" for n in (total, Fraction(cycle)))
        rule = f"takes {taken} of a crank with these pins, and a cycle has {turns}"
        remedy = "correct the order, or the pins"
        if total < cycle:
            remedy = "add firing_intervals, degrees from each firing to the next"
        raise SymbalanceError(what, rule, remedy)
    return dict(zip(turned, accumulate(steps, initial=Fraction(0)), strict=False))


def check_firing_intervals(fires: dict[int, Fraction], tops: dict[int, Fraction]) -> None:
    """Refuse firing angles at which the pins have not brought the cylinders to the top."""
    for number, angle_of_firing in fires.items():
        at_top = (tops[number] - tops[1]) % 360
        if angle_of_firing % 360 != at_top:
            what = f"firing_intervals by which cylinder {number} fires {brief(angle_of_firing)} after 1"
            rule = f"contradict the pins, which bring it to the top at {brief(at_top)}, modulo 360"
            raise SymbalanceError(what, rule, "correct one of them, or leave out firing_intervals")
