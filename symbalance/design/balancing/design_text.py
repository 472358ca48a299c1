"""A design for a terminal of 80 columns: what is proposed, the certificate, what remains."""

from __future__ import annotations

from textwrap import wrap

import sympy

from symbalance.design.balancing import Design
from symbalance.design.balancing.design_facts import (
    VERDICTS,
    PlacedWeight,
    by_order,
    left_ellipses,
    name,
    shape,
    summary,
    weights,
)
from symbalance.design.balancing.ellipses import Ellipse
from symbalance.document.expressions import text
from symbalance.document.grid import WIDTH, grid
from symbalance.engine.balancer_facts import TEXT, direction, nearly, rounded, size
from symbalance.forces.balance_text import heading_text, resultants_text
from symbalance.text.reals import pi

LONGEST_AXIS = 16


def design_text(design: Design) -> str:
    """Return a design as text."""
    blocks = [
        heading_text(design.before),
        "\n".join(wrap(summary(design), WIDTH)),
        _proposed(design),
        _certificate(design),
        *_left(design),
        f"What remains, to order {design.remains.highest}\n\n{resultants_text(design.remains)}",
    ]
    return "\n\n".join(block for block in blocks if block).rstrip() + "\n"


def _proposed(design: Design) -> str:
    if not design.devices:
        return ""
    lines = ["Proposed: mass times radius U = share · Aₙ m r/n² (order 1: share · m r)"]
    if not design.layout.has_common_harmonics:
        lines = ["Proposed: mass times radius U = share · m r/n²"]
    if any(not d.weights for d in design.devices):
        lines.append("  every throw: a counterweight for its rotating mass and 1/2 of its reciprocating")
    rows = [_row(w) for w in weights(design)]
    if rows:
        with_sizes = any(row[-1] for row in rows)
        head = ["speed", "on the", "station", "share", "≈", "at θ = 0"] + (
            ["U, kg mm"] if with_sizes else []
        )
        lines += grid([head, *(row[: len(head)] for row in rows)])
    if any(d.on_crank and d.weights for d in design.devices) and _counts_rotating(design):
        lines.append("  and on every throw a counterweight for its rotating mass")
    return "\n".join(lines).replace("-", "−")


def _counts_rotating(design: Design) -> bool:
    return any(c.overbalance is not None for c in design.balanced.balancers.counterweights)


def _row(weight: PlacedWeight) -> list[str]:
    exact = size(weight.vector, TEXT)
    unbalance = "" if weight.unbalance is None else rounded(weight.unbalance)
    speed = f"{weight.device.speed:+d}"
    turns = direction(weight.vector)
    return [speed, name(weight.device), weight.station, exact, nearly(weight.vector), turns, unbalance]


def _certificate(design: Design) -> str:
    rows = [[str(n), kind, *(VERDICTS[c.verdict] for c in pair)] for n, kind, pair in by_order(design)]
    title = "Certificate: the engine with this built in, balanced anew"
    return "\n".join([title, *grid([["order", "", "with the crank", "against it"], *rows])])


def _left(design: Design) -> list[str]:
    found = left_ellipses(design)
    if not found:
        return []
    rows = []
    for kind, left in found:
        axes = [_axis(left, i) for i in range(2)]
        tilt = "" if left.shape == "circle" else _degrees(left)
        rows.append([str(left.order), kind, *axes, tilt, shape(left)])
    head = ["order", "", "long semi-axis", "short", "direction", "drawn"]
    return ["\n".join(["Left of the orders to remove", *grid([head, *rows])])]


def _axis(left: Ellipse, which: int) -> str:
    axis = (left.major, left.minor)[which]
    exact = text(axis)
    if len(exact) <= LONGEST_AXIS or axis.free_symbols:
        return exact
    return f"≈ {rounded(left.decimal_axes[which])}"


def _degrees(left: Ellipse) -> str:
    turned = left.direction * 180 / sympy.pi
    if turned.is_Rational:
        return f"{text(turned)}°"
    if turned.free_symbols:
        return text(left.direction)
    return f"≈ {float(left.decimal_direction * 180 / pi()):.5g}°"
