"""Sensitivities as text, LaTeX or JSON: the worst steps first, cylinders that are alike in one row."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from symbalance.design.variations import STEPS, Sensitivity
from symbalance.document.plain_tables import figure, numbered, table_latex, table_text
from symbalance.engine.engine import Engine
from symbalance.exact.spectrum import COMPONENTS
from symbalance.forces.resultants import Resultant
from symbalance.text.numbers import decimal_text

DIGITS = 20
UNITS = {
    "mass": "m of cylinder {first}",
    "rotating": "m of cylinder {first}",
    "throw": "radian",
    "bank": "radian",
    "station": "pitch",
    "stroke": "r of cylinder {first}, of the crank radius",
    "rod": "r of cylinder {first}",
    "offset": "r of cylinder {first}",
}
_HEAD = ["order", "size", "step", "cylinders", "force", "couple"]
_ABOUT = (
    "what one step in one size of one cylinder adds, its largest modulus over a turn",
    "force in m r ω², couple in m r ω² a, of cylinder {first}; orders that cancel otherwise too",
)
_TURNING = "counterweights, shafts and rotating masses stay where they are; a size moves pistons and rods"


def sensitivities_text(layout: Engine, found: Sequence[Sensitivity], order: int) -> str:
    """Return the table for a terminal."""
    head = _heading(layout, order)
    return table_text(head, _HEAD, _rows(found))


def sensitivities_latex(layout: Engine, found: Sequence[Sensitivity], order: int) -> str:
    """Return the table as a complete LaTeX document."""
    head = _heading(layout, order)
    return table_latex(head, _HEAD, _rows(found))


def _heading(layout: Engine, order: int) -> list[str]:
    about = [line.format(first=layout.first.number) for line in _ABOUT]
    if layout.balancers or any(c.rotating_mass for c in layout.cylinders):
        about.append(_TURNING)
    return [f"{layout.name}: sensitivities to order {order}", *about]


def _rows(found: Sequence[Sensitivity]) -> list[list[str]]:
    groups: dict[tuple[str, int, str, str], list[int]] = {}
    for one in found:
        force, couple = one.step()
        key = (one.parameter, one.order, figure(force), figure(couple))
        groups.setdefault(key, []).append(one.cylinder)
    return [
        [str(order), parameter, STEPS[parameter][1], numbered(cylinders), force, couple]
        for (parameter, order, force, couple), cylinders in groups.items()
    ]


def sensitivities_json(layout: Engine, found: Sequence[Sensitivity], order: int) -> str:
    """Return every derivative as JSON: geometry exact, the factor to 20 digits, per what."""
    document = {
        "engine": layout.name,
        "ratio": None if layout.ratio is None else str(layout.ratio),
        "highest": str(order),
        "units": {"force": "m r omega^2", "couple": "m r omega^2 a"},
        "sensitivities": [_one(s, layout) for s in found],
    }
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"


def _one(one: Sensitivity, layout: Engine) -> dict[str, Any]:
    force, couple = one.largest
    return {
        "order": str(one.order),
        "parameter": one.parameter,
        "per": UNITS[one.parameter].format(first=layout.first.number),
        "cylinder": one.cylinder,
        "factor": decimal_text(one.factor, DIGITS),
        "force": _components(one.force),
        "couple": _components(one.couple),
        "largest": {"force": force, "couple": couple},
    }


def _components(resultant: Resultant) -> dict[str, dict[str, str]]:
    parts = ((name, resultant.component(name)) for name in COMPONENTS)
    return {name: {"cos": str(part.cos), "sin": str(part.sin)} for name, part in parts}
