"""Pictures of a balance: its orders as bars, force and couple over a turn, and the path of their ends."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, hypot, pi, sin
from typing import TYPE_CHECKING

from symbalance.document.shapes import Drawing
from symbalance.drawing.charts import (
    BARS,
    Bar,
    Curve,
    draw_bars,
    draw_curves,
    draw_path,
    figure,
    stacked,
)
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.exact.spectrum import Spectrum
    from symbalance.forces.free_forces import Balance

POINTS = 180
"""Steps of a turn: what a line of some 500 pixels can show."""
LEAST = 1e-6
"""Of one piston's first order: where a logarithmic scale ends."""
NAMES = ("force", "couple")


def component_over_a_turn(balance: Balance, output: str) -> list[float]:
    """Return an output ("force.vertical") at even steps of a turn, in m r omega^2, or N and N m.

    It holds the orders of the balance, none above. A couple counts in m r omega^2 a, a the pitch.
    """
    of, _, name = output.partition(".")
    spectrum: Spectrum = getattr(balance, of)
    terms = []
    for order in spectrum.orders():
        factor = float(balance.share(order)) * _unit(balance, of)
        c, s = spectrum.component(order, name).decimal(20)
        terms.append((order, float(c) * factor, float(s) * factor))
    angles = [2 * pi * k / POINTS for k in range(POINTS + 1)]
    return [sum(c * cos(n * t) + s * sin(n * t) for n, c, s in terms) for t in angles]


def _unit(balance: Balance, of: str) -> float:
    return 1.0 if balance.operating_point is None else float(balance.unit_value(of))


def unit_words(balance: Balance, of: str) -> str:
    """Return the unit of a force or a couple, as charts name it."""
    if balance.operating_point is not None:
        return "N" if of == "force" else "N m"
    return "m r ω²" if of == "force" else "m r ω² a"


def _check(balance: Balance) -> None:
    engine = balance.engine
    if engine.has_symbols:
        raise SymbalanceError(engine.name, "has symbols for angles", "give them in numbers")
    highest = max(balance.force.orders() + balance.couple.orders(), default=0)
    if balance.kinematics is not None and balance.ratio is None and highest > 1:
        rule = "has no rod ratio, which orders above the first depend on"
        raise SymbalanceError(engine.name, rule, "give --ratio λ, or stroke and rod in [crank_train]")


def draw_orders(balance: Balance, room: float = BARS, most: int = 1000) -> Drawing:
    """Return every order of force and couple as a bar, on a logarithmic scale; zeros say "0, proved".

    A bar is the larger of the amplitudes of the vertical and the lateral part; the scale is `room`
    pixels long. Of more bars than `most` those without a length, or below the scale, share a line.
    """
    _check(balance)
    bars, words = [], []
    orders = sorted({1, 2, *balance.force.orders(), *balance.couple.orders()})
    for of, look in (("force", "solid"), ("couple", "shade")):
        spectrum: Spectrum = getattr(balance, of)
        present = set(spectrum.orders())
        for order in (n for n in orders if n <= balance.highest):
            value = None
            if order in present:
                factor = float(balance.share(order)) * _unit(balance, of)
                parts = [spectrum.component(order, name).decimal(20) for name in ("vertical", "lateral")]
                value = abs(factor) * max(hypot(float(c), float(s)) for c, s in parts)
            bars.append(Bar(f"{of} {order}", value, look))
            words.append(
                f"{of} {order} "
                + ("0, proved" if value is None else f"{figure(value)} {unit_words(balance, of)}")
            )
    least = LEAST * (_unit(balance, "force") if balance.operating_point else 1.0)
    notes = []
    if len(bars) > most:
        zeros = [bar.name for bar in bars if bar.value is None]
        small = [bar.name for bar in bars if bar.value is not None and bar.value < least]
        notes = [f"0, proved: {_joined(zeros)}"] if zeros else []
        notes += [f"below {figure(least)}: {_joined(small)}"] if small else []
        bars = [bar for bar in bars if bar.value is not None and bar.value >= least]
    unit = " and ".join(dict.fromkeys(unit_words(balance, of) for of in NAMES))
    return draw_bars(
        bars,
        f"amplitude, {unit}",
        least,
        f"Orders of {balance.engine.name}",
        "; ".join(words) + ".",
        room,
        notes,
    )


def _joined(names: list[str]) -> str:
    """Return names of orders, each kind said once.

    >>> _joined(["force 1", "force 2", "couple 1"])
    'force 1, 2, couple 1'
    """
    said, last = [], ""
    for name in names:
        kind, _, order = name.partition(" ")
        said.append(order if kind == last else name)
        last = kind
    return ", ".join(said)


def draw_forces(balance: Balance) -> Drawing:
    """Return the free force over a turn, vertical and lateral, and below it the couple, if any."""
    name = balance.engine.name
    drawings = [draw_one_of_forces(balance, of) for of in NAMES if getattr(balance, of).orders()]
    if not drawings:
        rule = f"has no free force and no couple, to order {balance.highest}"
        raise SymbalanceError(name, rule, "there is nothing to draw; take a higher --order")
    return stacked(drawings, f"Free force and couple of {name} over a turn")


def draw_one_of_forces(balance: Balance, of: str) -> Drawing:
    """Return the free "force", or "couple", over a turn: its vertical and its lateral part."""
    _check(balance)
    unit, curves, words = unit_words(balance, of), [], []
    for part, look in (("vertical", "force"), ("lateral", "couple")):
        values = component_over_a_turn(balance, f"{of}.{part}")
        largest = max(map(abs, values))
        if largest:
            curves.append(Curve(f"{part} {of}", tuple(values), look))
            words.append(f"{part} {of} within ±{figure(largest)} {unit}")
    title = f"Free {of} of {balance.engine.name} over a turn"
    said = "; ".join(words)
    return draw_curves(curves, 360, unit, title, f"{said[:1].upper()}{said[1:]}.")


def draw_force_path(balance: Balance, of: str = "force") -> Drawing:
    """Return the way the end of a free force or couple goes over a turn, from the front."""
    _check(balance)
    if of not in NAMES:
        raise SymbalanceError(f"of = {of}", "must be force or couple", "take force")
    if not getattr(balance, of).orders():
        rule = f"has no free {of}, to order {balance.highest}"
        other = "couple" if of == "force" else "force"
        raise SymbalanceError(balance.engine.name, rule, f"draw the {other}, or take a higher --order")
    up = component_over_a_turn(balance, f"{of}.vertical")[:-1]
    right = component_over_a_turn(balance, f"{of}.lateral")[:-1]
    points = list(zip(right, up, strict=True))
    largest = max(range(POINTS), key=lambda k: hypot(*points[k]))
    size = f"{figure(hypot(*points[largest]))} {unit_words(balance, of)}"
    words = f"Largest {size} near θ = {360 // POINTS * largest}°."
    marks = [(k * POINTS // 360, f"{k}°") for k in (0, 90, 180, 270)]
    return draw_path(
        points,
        of,
        unit_words(balance, of),
        f"Path of the free {of} of {balance.engine.name}",
        words,
        marks,
    )


DRAWN: dict[str, Callable[[Balance], Drawing]] = {
    "forces": draw_forces,
    "path": draw_force_path,
    "orders": draw_orders,
}
