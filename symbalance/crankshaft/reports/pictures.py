"""Pictures of a run: stress against the crank angle, orders, speeds, orbits, bearings, frequencies."""

from __future__ import annotations

import io
from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.bearings.series import equivalent_system as in_series
from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.loads import firing_crank_angles
from symbalance.crankshaft.reports.summary import MEGA, Summary
from symbalance.crankshaft.rotor.campbell_diagram import campbell
from symbalance.crankshaft.rotor.constraints import driven_node
from symbalance.crankshaft.rotor.modes import MOTIONS
from symbalance.crankshaft.running.outcome import SpeedOutcome
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import MissingPartError

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#555555", "#000000")
RESOLUTION = 110
HIGHEST_ORDER = 24
CAMPBELL_MODES = 12
MOST_TICKS = 12
JUMP = 1.6
"""A Campbell line that moves further than this times the step of speed turned its whirl: it is cut."""
HOLD = 1e8
"""N/m and N m/rad on the crank's axial place and its rotation in the Campbell diagram."""


def draw_pictures(run: Summary) -> dict[str, bytes]:
    """Return the pictures as PNG by file name: those of the highest speed, and those over all speeds.

    Speeds that are not to be relied on are left out; where no other is, the free crank's frequencies
    remain. Refused without matplotlib, with the command that installs it.
    """
    if not run.reliable:
        return {"frequencies.png": _png(_frequencies(run))}
    last = run.reliable[-1]
    figures = {
        "pin-bending.png": _angles(run, last, "bending"),
        "pin-torsion.png": _angles(run, last, "torsion"),
        "orders.png": _orders(run, last),
        "orbits.png": _orbits(last),
        "bearings.png": _bearings(last),
        "films.png": _films(run, last),
    }
    figures["frequencies.png"] = _frequencies(run)
    figures["campbell.png"] = _campbell(run)
    if len(run.reliable) > 2:
        figures["waterfall.png"] = _waterfall(run)
        figures["order-cuts.png"] = _order_cuts(run)
    return {name: _png(figure) for name, figure in figures.items()}


def check_drawing() -> Any:
    """Return matplotlib's figures, or refuse with the command that installs it."""
    try:
        return import_module("matplotlib.figure")
    except ImportError:
        rule, remedy = (
            "matplotlib is not installed",
            "pip install 'symbalance[crankshaft]', or --no-plots",
        )
        raise MissingPartError("plots", rule, remedy) from None


def _figure(rows: int, columns: int, width: float = 9.0, height: float = 2.2, **options: Any) -> Any:
    figure = check_drawing().Figure(figsize=(width, height * rows + 0.6), layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False, **options)


def _png(figure: Any) -> bytes:
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=RESOLUTION)
    return stream.getvalue()


def _angles(run: Summary, outcome: SpeedOutcome, kind: str) -> Any:
    """Draw a stress of every pin against the crank angle, with all firings; measured curves on top."""
    pins = [
        n for n in outcome.names if n.startswith("pin ") and n.endswith(f" {kind}") and "fillet" not in n
    ]
    figure, axes = _figure(len(pins), 1, sharex=True, sharey=True, height=1.5)
    firings = {n: np.degrees(a) for n, a in firing_crank_angles(run.configuration.engine.layout).items()}
    cycle = np.degrees(outcome.cycle)
    for axis, name, pin in zip(axes[:, 0], pins, run.configuration.engine.crank.pins, strict=True):
        axis.plot(outcome.degrees, outcome.channel(name) / MEGA, color=COLOURS[0], linewidth=1.2)
        for number, firing in firings.items():
            own = number in pin.cylinders
            axis.axvline(
                firing,
                color=COLOURS[1] if own else "0.6",
                linewidth=1.6 if own else 0.9,
                zorder=1,
                clip_on=False,
            )
            axis.text(
                firing, 0.98, f" {number}", transform=axis.get_xaxis_transform(), va="top", fontsize=8
            )
        for curve in run.comparisons:
            if curve.channel == name and curve.rpm == outcome.rpm:
                axis.plot(curve.degrees % cycle, curve.values, ".", color="black", markersize=3)
        axis.set_ylabel(f"{name.rsplit(' ', 1)[0]}, MPa")
        axis.grid(color="0.93", linewidth=0.5)
    _over_a_cycle(axes[-1, 0], outcome)
    figure.suptitle(
        f"{kind.capitalize()} stress of the pins at {speed_text(outcome.rpm)} rpm; "
        "lines: firings, own in colour"
    )
    return figure


def _over_a_cycle(axis: Any, outcome: SpeedOutcome) -> None:
    cycle = np.degrees(outcome.cycle)
    axis.set(xlabel="crank angle, degrees", xlim=(0, cycle))
    axis.set_xticks(np.arange(0, cycle + 1, 90))


def _orders(run: Summary, outcome: SpeedOutcome) -> Any:
    pins = [n for n in outcome.names if n.startswith("pin ") and n.endswith(" bending")]
    figure, axes = _figure(len(pins), 1, sharex=True, sharey=True, height=1.3)
    for axis, name in zip(axes[:, 0], pins, strict=True):
        orders, sizes = outcome.orders(name)
        inside = (orders > 0) & (orders <= HIGHEST_ORDER)
        axis.bar(orders[inside], sizes[inside] / MEGA, width=0.35, color=COLOURS[0])
        axis.set_ylabel(f"{name.rsplit(' ', 1)[0]}, MPa")
    axes[-1, 0].set(xlabel="order: per turn of the crank", xlim=(0, HIGHEST_ORDER + 0.5))
    axes[-1, 0].set_xticks(range(0, HIGHEST_ORDER + 1, 2))
    figure.suptitle(f"Order content of the pins' bending stress at {speed_text(outcome.rpm)} rpm")
    return figure


def _orbits(outcome: SpeedOutcome) -> Any:
    """Draw every journal's orbit in its clearance circle, up and right for a viewer in front."""
    count = len(outcome.clearance)
    columns = min(count, 4)
    figure, axes = _figure((count - 1) // columns + 1, columns, width=2.6 * columns, height=2.6)
    circle = np.linspace(0, 2 * np.pi, 181)
    for j, axis in enumerate(axes.flat):
        axis.set_visible(j < count)
        if j >= count:
            continue
        orbit = outcome.orbits[:, j] / outcome.clearance[j]
        axis.plot(np.cos(circle), np.sin(circle), color="0.5", linewidth=1)
        axis.plot(orbit[:, 1], orbit[:, 0], color=COLOURS[0], linewidth=1)
        axis.set(aspect="equal", title=f"bearing {j + 1}: {outcome.eccentricity[j]:.2f}")
        axis.tick_params(labelsize=7)
    figure.supxlabel("lateral displacement in the shell over the clearance", fontsize=9)
    figure.supylabel("vertical, over the clearance", fontsize=9)
    figure.suptitle(f"Journal orbits at {speed_text(outcome.rpm)} rpm, largest share of the clearance")
    return figure


def _bearings(outcome: SpeedOutcome) -> Any:
    figure, axes = _figure(1, 1, height=3.4)
    loads = np.hypot(outcome.bearings[..., 0], outcome.bearings[..., 1]) / 1000
    for j, load in enumerate(loads.T):
        axes[0, 0].plot(
            outcome.degrees, load, color=COLOURS[j % 8], linewidth=1, label=f"bearing {j + 1}"
        )
    _over_a_cycle(axes[0, 0], outcome)
    axes[0, 0].set(ylabel="load, kN", ylim=(0, None))
    axes[0, 0].legend(fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.suptitle(f"Main bearing loads at {speed_text(outcome.rpm)} rpm")
    return figure


def _films(run: Summary, outcome: SpeedOutcome) -> Any:
    """Draw the films' stiffness against the crank angle, alone and in series with the housing.

    The middle bearing; the paper's figure 5 in kind.
    """
    full = replace(run.configuration, steps=outcome.steps).system(outcome.rpm)
    series = in_series(full)
    j = len(outcome.clearance) // 2
    figure, axes = _figure(2, 1, sharex=True, sharey=True)
    for i, (axis, name) in enumerate(zip(axes[:, 0], ("vertical", "lateral"), strict=True)):
        alone = full.film.stiffness(outcome.theta)[:, j, i, i]
        both = series.film.stiffness(outcome.theta)[:, j, i, i]
        axis.plot(outcome.degrees, np.abs(alone), color="0.5", linewidth=0.8, label="film")
        if full.housing is not None:
            axis.axhline(full.housing.stiffness[j, i, i], color="0.5", linestyle="--", label="housing")
        axis.plot(outcome.degrees, np.abs(both), color=COLOURS[0], linewidth=1.6, label="in series")
        axis.set(yscale="log", ylabel=f"{name}, |K| in N/m")
    axes[0, 0].legend(fontsize=8, ncols=3, loc="lower right", bbox_to_anchor=(1, 1))
    _over_a_cycle(axes[-1, 0], outcome)
    figure.suptitle(f"Stiffness of main bearing {j + 1} at {speed_text(outcome.rpm)} rpm")
    return figure


def _frequencies(run: Summary) -> Any:
    """Draw the natural frequencies by mode, coloured by what moves; the paper's figure 3 in kind."""
    figure, axes = _figure(1, 1, width=7, height=3.2)
    for colour, kind in zip(COLOURS, MOTIONS, strict=False):
        rows = [(i, f) for i, (f, own) in enumerate(run.frequencies, 1) if own == kind]
        if rows:
            axes[0, 0].bar(*zip(*rows, strict=True), color=colour, label=kind)
    axes[0, 0].set(xlabel="mode", ylabel="Hz", title="Natural frequencies of the free crank")
    axes[0, 0].set_xticks(range(1, len(run.frequencies) + 1))
    axes[0, 0].legend(fontsize=8)
    return figure


def _campbell(run: Summary) -> Any:
    """Draw the modes on the bearings' mean stiffness over speed, turning and stationary lines, orders."""
    outcome = run.reliable[-1]
    configuration, last, theta = (
        replace(run.configuration, steps=outcome.steps),
        outcome.rpm,
        outcome.theta,
    )
    full = configuration.system(last)
    middle = np.abs(series_film(full, theta)).mean(axis=0).trace(axis1=1, axis2=2) / 2
    support = np.einsum("b,bin,bim->nm", middle, full.points, full.points)
    for unknown in (6 * driven_node(configuration.rotor) + 5, 6 * configuration.rotor.journals[-1] + 2):
        support[unknown, unknown] += HOLD
    speeds = np.linspace(0, 1.5 * last, 31)
    lines = campbell(configuration.rotor, list(speeds * np.pi / 30), support, CAMPBELL_MODES)
    figure, axes = _figure(1, 2, sharey=True, height=4.2)
    hertz = 2 * np.pi
    step = speeds[1] * np.pi / 30
    for axis, rows, title in (
        (axes[0, 0], np.abs(lines.rotating), "axes that turn with the crank"),
        (axes[0, 1], np.abs(lines.stationary), "stationary axes"),
    ):
        jumps = np.abs(np.diff(rows, axis=0, prepend=rows[:1])) > JUMP * step
        axis.plot(speeds, np.where(jumps, np.nan, rows) / hertz, color=COLOURS[0], linewidth=1)
        for order in range(2, HIGHEST_ORDER + 1, 2):
            axis.plot(speeds, order * speeds / 60, color="0.8", linewidth=0.6, zorder=0)
        axis.axvline(last, color=COLOURS[1], linewidth=0.8)
        axis.set(
            xlabel="rpm", title=title, ylim=(0, float(rows.max()) / hertz * 1.05), xlim=(0, speeds[-1])
        )
    axes[0, 0].set_ylabel("Hz")
    figure.suptitle(
        "Campbell diagram on the bearings' mean stiffness; grey: orders 2, 4, ... of the speed"
    )
    return figure


def series_film(full: PeriodicSystem, theta: Array) -> Array:
    """Return the stiffness of films and housings in series (s, b, 2, 2)."""
    return in_series(full).film.stiffness(theta)


def _worst_pin(run: Summary) -> str:
    pins = [e for e in run.extremes if e.name.startswith("pin ") and e.name.endswith(" bending")]
    return max(pins, key=lambda e: e.largest - e.least).name


def _spectra(run: Summary, name: str) -> tuple[Array, Array]:
    """Return the orders that all speeds have, whatever their steps, and (speed, order) sizes in MPa."""
    rows = [outcome.orders(name) for outcome in run.reliable]
    count = min(len(orders) for orders, _ in rows)
    return rows[0][0][:count], np.array([sizes[:count] for _, sizes in rows]) / MEGA


def _waterfall(run: Summary) -> Any:
    """Draw the order spectra of the worst pin's bending over the speed."""
    name = _worst_pin(run)
    figure, axes = _figure(1, 1, height=4.2)
    orders, sizes = _spectra(run, name)
    inside = (orders > 0) & (orders <= HIGHEST_ORDER)
    speeds = [o.rpm for o in run.reliable]
    shade = np.log10(np.maximum(sizes[:, inside], 1e-2))
    mesh = axes[0, 0].pcolormesh(orders[inside], speeds, shade, shading="nearest", cmap="viridis")
    figure.colorbar(mesh, label="lg of the amplitude in MPa")
    axes[0, 0].set(xlabel="order", ylabel="rpm", title=f"{name.capitalize()} stress, order by order")
    axes[0, 0].set_yticks(
        speeds if len(speeds) <= MOST_TICKS else speeds[:: len(speeds) // MOST_TICKS + 1]
    )
    return figure


def _order_cuts(run: Summary) -> Any:
    name = _worst_pin(run)
    figure, axes = _figure(1, 1, height=3.6)
    orders, sizes = _spectra(run, name)
    strongest = sorted(np.flatnonzero(orders > 0), key=lambda k: -sizes[:, k].max())[:8]
    for colour, k in zip(COLOURS, sorted(strongest), strict=False):
        rpm = [o.rpm for o in run.reliable]
        axes[0, 0].plot(rpm, sizes[:, k], "o-", markersize=3, color=colour, label=f"{orders[k]:g}")
    axes[0, 0].set(xlabel="rpm", ylabel="amplitude, MPa", title=f"Largest orders of {name} stress")
    axes[0, 0].legend(title="order", fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    return figure
