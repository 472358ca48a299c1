"""Plots on matplotlib's axes hold the values of the fast functions, and nothing is ever shown."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import symbalance as sb
from symbalance.errors import SymbalanceError

pytestmark = pytest.mark.slow


@pytest.fixture
def axes(monkeypatch: pytest.MonkeyPatch) -> Any:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("a plot was shown")

    monkeypatch.setattr(pyplot, "show", refuse)
    figure, axes = pyplot.subplots()
    yield axes
    pyplot.close(figure)
    pyplot.close("all")


@pytest.mark.parametrize("name", ["vw-vr6", "v8-90"])
@pytest.mark.parametrize("of", ["force", "couple"])
def test_forces_and_path_are_the_functions_values(name: str, of: str, axes: Any) -> None:
    result = sb.balance(sb.load(name))
    outputs = (f"{of}.vertical", f"{of}.lateral")
    assert sb.plot.forces(result, axes, of=of) is axes
    vertical, lateral = axes.lines
    theta = np.radians(vertical.get_xdata())
    values = sb.to_function(result, outputs=outputs)(theta)
    assert vertical.get_ydata() == pytest.approx(values[outputs[0]], abs=1e-12)
    assert lateral.get_ydata() == pytest.approx(values[outputs[1]], abs=1e-12)
    axes.clear()
    (line,) = sb.plot.path(result, ax=axes, of=of).lines
    assert line.get_xdata() == pytest.approx(values[outputs[1]], abs=1e-12)
    assert line.get_ydata() == pytest.approx(values[outputs[0]], abs=1e-12)


@pytest.mark.parametrize("name", ["vw-vr6", "inline-5"])
def test_an_ellipse_is_its_two_turning_parts(name: str, axes: Any) -> None:
    result = sb.balance(sb.load(name))
    sb.plot.ellipse(result, 1, axes, of="couple")
    whole, forward, backward = (line.get_ydata() + 1j * line.get_xdata() for line in axes.lines)
    assert forward + backward == pytest.approx(whole, abs=1e-12)
    assert np.ptp(np.abs(forward)) < 1e-12
    assert np.ptp(np.abs(backward)) < 1e-12
    # Vertical and i times lateral: a vector that turns clockwise turns as e^(i theta).
    assert np.angle(forward[1] / forward[0]) > 0
    assert np.angle(backward[1] / backward[0]) < 0


def test_bars_are_the_orders_that_are_free(axes: Any) -> None:
    sb.plot.orders(sb.load("v12-60"), axes)
    (bar, last) = axes.patches
    assert bar.get_x() + bar.get_width() / 2 == pytest.approx(5.8)
    assert bar.get_height() == pytest.approx(6 * 3**0.5 * 7.4379032794195738811e-5)
    assert last.get_height() < 1e-6


def test_the_torque_is_the_function_s(axes: Any) -> None:
    result = sb.inertia_torque(sb.load("inline-3"))
    (line,) = sb.plot.torque(result, axes).lines
    values = sb.to_function(result)(np.radians(line.get_xdata()))
    assert line.get_ydata() == pytest.approx(values, abs=1e-9)


def test_without_axes_a_figure_is_made(axes: Any) -> None:
    assert sb.plot.forces(sb.load("inline-3"), of="couple") is not axes


def test_bad_input_is_refused(axes: Any) -> None:
    with pytest.raises(SymbalanceError, match="force or couple"):
        sb.plot.path(sb.load("inline-3"), axes, of="thrust")
    with pytest.raises(SymbalanceError, match="1 to 12"):
        sb.plot.ellipse(sb.load("inline-3"), 13, axes)


def test_at_a_speed_plots_are_in_newtons(axes: Any) -> None:
    result = sb.balance(sb.load("vq30de")).at(rpm=6000)
    sb.plot.forces(result, axes, of="couple")
    theta = np.radians(axes.lines[0].get_xdata())
    values = sb.to_function(result, outputs=("couple.vertical",))(theta)
    assert axes.lines[0].get_ydata() == pytest.approx(values, abs=1e-6)
    assert np.abs(values).max() > 1000  # newton metres, not a share
    assert axes.get_ylabel() == "couple, N m"
    axes.clear()
    sb.plot.path(result, axes)
    assert axes.get_xlabel() == "lateral, N"
    axes.clear()
    sb.plot.orders(result, axes)
    sizes = {round(bar.get_x() + bar.get_width() / 2, 1): bar.get_height() for bar in axes.patches}
    newtons = [abs(float(x)) for x in result.in_newtons(6, "force.vertical")]
    assert sizes[5.8] == pytest.approx(max(newtons), rel=1e-9)
    axes.clear()
    torque = sb.inertia_torque(sb.load("vq30de")).at(rpm=6000)
    sb.plot.torque(torque, axes)
    assert axes.get_ylabel() == "inertia torque, N m"


@pytest.mark.parametrize("plot", ["forces", "path", "ellipse", "orders", "torque"])
def test_every_plot_takes_axes_and_returns_them(plot: str, axes: Any) -> None:
    assert getattr(sb.plot, plot)(sb.load("inline-3"), ax=axes) is axes
