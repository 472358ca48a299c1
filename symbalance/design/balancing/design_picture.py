"""A picture of a design: the ellipses of force and couple before and after, drawn with matplotlib."""

from __future__ import annotations

import io
from fractions import Fraction
from pathlib import Path
from typing import Any

from symbalance.design.balancing.designs import Design
from symbalance.design.balancing.ellipses import Ellipse, ellipse
from symbalance.engine.rotating_masses import unit_of_share
from symbalance.errors import MissingPartError, SymbalanceError
from symbalance.forces.free_forces import Balance
from symbalance.text.reals import expjpi

ENDINGS = (".png", ".pdf", ".svg")
POINTS = 361
"""Of a drawn ellipse: one a degree, and the first again to close it."""


def design_picture(design: Design, path: str) -> bytes:
    """Return a picture in the format that the file's name ends in: one row an order, force and couple.

    Grey is the layout unchanged, blue what is left with the design built in; in m r omega^2 (couples
    m r omega^2 a), seen from the front, so an engine with symbols in it has none.
    """
    ending = Path(path).suffix
    if ending not in ENDINGS:
        rule = f"must end in {', '.join(ENDINGS)}"
        raise SymbalanceError(f"--picture {path}", rule, "for instance --picture balance.png")
    if design.layout.has_symbols:
        raise SymbalanceError("a layout with symbols", "has no picture", "build the layout with numbers")
    figure = _figure(design)
    stream = io.BytesIO()
    about = {".pdf": {"CreationDate": None}, ".svg": {"Date": None}, ".png": {}}[ending]
    figure.savefig(stream, format=ending[1:], dpi=150, metadata=about)
    return stream.getvalue()


def _figure(design: Design) -> Any:
    try:
        from matplotlib.figure import Figure
    except ImportError:
        rule, remedy = "is not installed", "pip install 'symbalance[plot]'"
        raise MissingPartError("matplotlib", rule, remedy) from None
    rows = len(design.remove)
    figure = Figure(figsize=(7, 3.2 * rows), layout="constrained")
    axes = figure.subplots(rows, 2, squeeze=False)
    figure.suptitle(design.layout.name)
    for row, order in zip(axes, design.remove, strict=True):
        for axis, kind in zip(row, ("force", "couple"), strict=True):
            _draw(axis, design, order, kind)
    return figure


def _draw(axis: Any, design: Design, order: int, kind: str) -> None:
    for result, colour, label in (
        (design.before, "0.6", "unchanged"),
        (design.remains, "tab:blue", "with the design"),
    ):
        curve = ellipse(result, order, kind)
        if curve.shape == "nothing":
            axis.plot([0], [0], ".", color=colour, label=f"{label}: none")
        else:
            axis.plot(*_points(result, curve), color=colour, label=label)
    unit = r"$m r \omega^2$" if kind == "force" else r"$m r \omega^2 a$"
    axis.set_title(f"order {order}, {kind}", fontsize=10)
    axis.set_xlabel(f"lateral, {unit}", fontsize=8)
    axis.set_ylabel(f"vertical, {unit}", fontsize=8)
    axis.set_aspect("equal", adjustable="datalim")
    axis.tick_params(labelsize=8)
    axis.grid(alpha=0.3)
    axis.margins(0.35)
    axis.legend(fontsize=7, loc="upper right")


def _points(result: Balance, curve: Ellipse) -> tuple[list[float], list[float]]:
    """Return the points an order's vector goes through in a turn of it, lateral and vertical."""
    unit = unit_of_share(result.layout, curve.order) if result.kinematics else 1
    forward, backward = (complex(n.evaluated(20) * unit) for n in (curve.forward, curve.backward))
    turns = [complex(expjpi(Fraction(2 * i, POINTS - 1), 20)) for i in range(POINTS)]
    places = [forward * z + backward * z.conjugate() for z in turns]
    return [p.imag for p in places], [p.real for p in places]
