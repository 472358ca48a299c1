"""Worst cases within tolerances as text, LaTeX or JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import pi
from typing import Any

from symbalance.design.variations import UNITS, Tolerances, WorstCase
from symbalance.document.plain_tables import figure, table_latex, table_text
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, shown
from symbalance.text.numbers import exact

MET = 1e-6
"""A bound within this part of what is attained is the worst itself."""
FASTEST = 100_000
Scale = tuple[float, float, str, str]
_HEAD = ["order", "", "of", "as drawn", "worst", "at most", "RSS"]


def tolerances_text(
    layout: Engine, tolerances: Tolerances, found: Sequence[WorstCase], rpm: object = None
) -> str:
    """Return the table for a terminal, in N and N m where a speed is given."""
    scale = _scale(layout, rpm)
    return table_text(_about(layout, tolerances, scale, rpm), _HEAD, _rows(found, scale))


def tolerances_latex(
    layout: Engine, tolerances: Tolerances, found: Sequence[WorstCase], rpm: object = None
) -> str:
    """Return the table as a complete LaTeX document."""
    scale = _scale(layout, rpm)
    return table_latex(_about(layout, tolerances, scale, rpm), _HEAD, _rows(found, scale))


def _about(layout: Engine, tolerances: Tolerances, scale: Scale, rpm: object) -> list[str]:
    given = [f"{name} ±{_size(name, getattr(tolerances, name))}" for name in UNITS]
    listed = ", ".join(text for name, text in zip(UNITS, given, strict=True) if getattr(tolerances, name))
    speed = "" if rpm is None else f", at {rpm} rpm"
    made = "counterweights, shafts and rotating masses count as they are made, without errors"
    return [
        f"{layout.name}: the worst within tolerances{speed}",
        f"every cylinder: {listed or 'none'}",
        f"force in {scale[2]}, couple in {scale[3]}; each row has a worst engine of its own",
        "worst: reached by an engine within the tolerances; at most: proved for all of them",
        "RSS: root of the sum of squares of the single effects to first order, an estimate",
        *([made] if layout.balancers else []),
    ]


def _size(name: str, value: object) -> str:
    text = value if isinstance(value, str) else figure(float(value))  # type: ignore[arg-type]
    return text if text.endswith("%") else f"{text} {UNITS[name]}"


def _scale(layout: Engine, rpm: object) -> Scale:
    """Return the units of force and couple: m r omega^2 (a), or N and N m at a speed."""
    if rpm is None:
        return 1.0, 1.0, "m r ω²", "m r ω² a"
    speed = exact(rpm, "rpm")
    if not 0 < speed <= FASTEST:
        raise SymbalanceError(f"rpm = {shown(rpm)}", f"must lie in (0, {FASTEST}]", "turns a minute")
    mass, radius, pitch = layout.first.reciprocating_mass, layout.first.radius, layout.pitch
    if not mass or radius is None:
        key = "stroke" if radius is None else "reciprocating_mass"
        raise SymbalanceError("rpm", f"needs the engine's {key}", f"give {key} in [crank_train]")
    force = float(mass * radius) / 1000 * (float(speed) * pi / 30) ** 2
    if pitch is None:
        return force, force, "N", "N a (the engine gives no pitch)"
    return force, force * float(pitch) / 1000, "N", "N m"


def _rows(found: Sequence[WorstCase], scale: Scale) -> list[list[str]]:
    rows = []
    for worst in found:
        by = scale[1] if worst.quantity.endswith("couple") else scale[0]
        bound = worst.bound if worst.bound > worst.attained * (1 + MET) + 1e-15 else worst.attained
        values = (worst.nominal, worst.attained, bound, worst.statistical)
        if any(values):
            rows.append([str(worst.order), worst.quantity, worst.of, *(figure(v * by) for v in values)])
    return rows


def tolerances_json(
    layout: Engine, tolerances: Tolerances, found: Sequence[WorstCase], rpm: object = None
) -> str:
    """Return the same as JSON, with the errors of the engine that reaches each worst."""
    scale = _scale(layout, rpm)
    document = {
        "engine": layout.name,
        "ratio": None if layout.ratio is None else str(layout.ratio),
        "tolerances": {n: str(getattr(tolerances, n)) for n in UNITS if getattr(tolerances, n)},
        "tolerance_units": {n: UNITS[n] for n in UNITS if getattr(tolerances, n)},
        "units": {"force": scale[2], "couple": scale[3]},
        "rpm": None if rpm is None else str(rpm),
        "worst_cases": [_one(worst, scale) for worst in found],
    }
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"


def _one(worst: WorstCase, scale: Scale) -> dict[str, Any]:
    by = scale[1] if worst.quantity.endswith("couple") else scale[0]
    return {
        "order": str(worst.order),
        "quantity": worst.quantity,
        "of": worst.of,
        "nominal": worst.nominal * by,
        "attained": worst.attained * by,
        "bound": worst.bound * by,
        "statistical": worst.statistical * by,
        "errors": {
            str(number): {"weight": w, "station": s, "throw": t, "bank": b}
            for number, (w, s, t, b) in worst.errors.items()
        },
    }
