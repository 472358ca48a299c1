"""Results on axes of matplotlib, for a figure of one's own: `forces(balance, ax=axes)` returns the axes.

Without `ax` a figure is made by pyplot. Nothing is ever shown: call `pyplot.show()`, or save the figure.
An engine may stand for its balance. Needs the extra `plot`.
"""

from __future__ import annotations

from importlib import import_module
from math import cos, hypot, pi, sin
from typing import TYPE_CHECKING, Any

from symbalance.errors import MissingPartError, SymbalanceError, brief
from symbalance.forces.free_forces import Balance, balance
from symbalance.forces.pictures import component_over_a_turn, unit_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from symbalance.engine.engine import Engine
    from symbalance.torque.inertia_balance import TorqueBalance

__all__ = ["ellipse", "forces", "orders", "path", "torque"]
KINDS = ("force", "couple")
STEPS = 180


def forces(result: Balance | Engine, ax: Axes | None = None, of: str = "force") -> Axes:
    """Draw the vertical and lateral free force over a turn, or `of` "couple"."""
    shown = _balance(result)
    _check_kind(of)
    axes = _axes(ax)
    for part, style in (("vertical", "-"), ("lateral", "--")):
        values = component_over_a_turn(shown, f"{of}.{part}")
        angles = [360 * k / (len(values) - 1) for k in range(len(values))]
        axes.plot(angles, values, style, label=f"{part} {of}")
    _turn(axes, f"{of}, {unit_words(shown, of)}")
    axes.legend()
    return axes


def path(result: Balance | Engine, ax: Axes | None = None, of: str = "force") -> Axes:
    """Draw the way the end of the free force goes over a turn, seen from the front, or the couple's."""
    shown = _balance(result)
    _check_kind(of)
    axes = _axes(ax)
    right = component_over_a_turn(shown, f"{of}.lateral")
    axes.plot(right, component_over_a_turn(shown, f"{of}.vertical"), label=of)
    return _from_the_front(axes, unit_words(shown, of))


def ellipse(result: Balance | Engine, order: int = 1, ax: Axes | None = None, of: str = "force") -> Axes:
    """Draw the ellipse of one order of the free force, and its parts with and against the crank."""
    shown = _balance(result)
    _check_kind(of)
    if not isinstance(order, int) or not 1 <= order <= shown.highest:
        rule = f"must be a whole number, 1 to {shown.highest}, the highest of the balance"
        raise SymbalanceError(f"order = {brief(str(order))}", rule, "as order=2")
    axes = _axes(ax)
    c, s = zip(*(_amplitudes(shown, of, order, part) for part in ("vertical", "lateral")), strict=True)
    angles = [2 * pi * k / STEPS for k in range(STEPS + 1)]

    def draw(cosines: tuple[float, ...], sines: tuple[float, ...], style: str, label: str) -> None:
        up, right = (
            [a * cos(t) + b * sin(t) for t in angles] for a, b in zip(cosines, sines, strict=True)
        )
        axes.plot(right, up, style, label=label)

    forward = (c[0] + s[1]) / 2, (s[0] - c[1]) / 2
    backward = (c[0] - s[1]) / 2, (s[0] + c[1]) / 2
    draw(c, s, "-", f"order {order}")
    draw((forward[0], -forward[1]), (forward[1], forward[0]), ":", "with the crank")
    draw((backward[0], backward[1]), (backward[1], -backward[0]), "--", "against the crank")
    axes.legend()
    return _from_the_front(axes, unit_words(shown, of))


def orders(result: Balance | Engine, ax: Axes | None = None) -> Axes:
    """Draw every order of force and couple as a bar, on a logarithmic scale; a proved zero has no bar."""
    shown = _balance(result)
    axes = _axes(ax)
    for of, place in zip(KINDS, (-0.2, 0.2), strict=True):
        present = getattr(shown, of).orders()
        sizes = [
            max(hypot(*_amplitudes(shown, of, n, part)) for part in ("vertical", "lateral"))
            for n in present
        ]
        axes.bar([n + place for n in present], sizes, 0.4, label=f"{of}, {unit_words(shown, of)}")
    axes.set_yscale("log")
    axes.set_xticks(range(1, shown.highest + 1))
    axes.set_xlabel("order")
    axes.legend()
    return axes


def torque(result: TorqueBalance | Engine, ax: Axes | None = None) -> Axes:
    """Draw the pistons' inertia torque on the crank over a turn, + with the rotation."""
    from symbalance.torque.inertia_balance import TorqueBalance, inertia_torque
    from symbalance.torque.pictures import torque_over_a_turn

    shown = result if isinstance(result, TorqueBalance) else inertia_torque(result)
    values, unit = torque_over_a_turn(shown)
    axes = _axes(ax)
    axes.plot([360 * k / (len(values) - 1) for k in range(len(values))], values)
    return _turn(axes, f"inertia torque, {unit}")


def _balance(result: Balance | Engine) -> Balance:
    return result if isinstance(result, Balance) else balance(result)


def _amplitudes(shown: Balance, of: str, order: int, part: str) -> tuple[float, float]:
    """Return the cosine and sine parts of an order, in the balance's unit."""
    unit = 1.0 if shown.operating_point is None else float(shown.unit_value(of))
    factor = float(shown.share(order)) * unit
    c, s = getattr(shown, of).component(order, part).decimal(20)
    return float(c) * factor, float(s) * factor


def _check_kind(of: str) -> None:
    if of not in KINDS:
        raise SymbalanceError(f"of = {brief(str(of))}", "must be force or couple", "take force")


def _axes(ax: Axes | None) -> Any:
    if ax is not None:
        return ax
    try:
        pyplot = import_module("matplotlib.pyplot")
    except ImportError:
        rule, remedy = "is not installed", "pip install 'symbalance[plot]'"
        raise MissingPartError("matplotlib", rule, remedy) from None
    return pyplot.subplots()[1]


def _turn(axes: Any, words: str) -> Any:
    axes.set_xlim(0, 360)
    axes.set_xticks([0, 90, 180, 270, 360])
    axes.set_xlabel("crank angle θ, degrees")
    axes.set_ylabel(words)
    return axes


def _from_the_front(axes: Any, unit: str) -> Any:
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel(f"lateral, {unit}")
    axes.set_ylabel(f"vertical, {unit}")
    return axes
