"""Weighed parts in their cylinders as text, LaTeX or JSON."""

from __future__ import annotations

import json
from typing import Any

from symbalance.design.variations import Assignment, Shaking
from symbalance.document.grid import grid
from symbalance.document.plain_tables import figure, table_latex, table_text

_LEFT = ["order", "force", "couple", "force as listed", "couple as listed"]


def assignment_text(found: Assignment) -> str:
    """Return the arrangement and what it leaves, for a terminal."""
    kinds, rows = _places(found)
    text = table_text(_about(found), ["cylinder", *kinds], rows)
    left = grid([_LEFT, *_left(found)]) if found.left else ["  none: these orders leave nothing"]
    title = f"Left, largest over a turn, force in {found.units[0]}, couple in {found.units[1]}"
    return "\n".join([text, title, *left]) + "\n"


def assignment_latex(found: Assignment) -> str:
    """Return the arrangement as a complete LaTeX document."""
    kinds, rows = _places(found)
    return table_latex(_about(found), ["cylinder", *kinds], rows)


def _about(found: Assignment) -> list[str]:
    beyond = "what they differ from the mean of their set by" if found.beyond else "their whole masses"
    if found.proved:
        proof = "no arrangement leaves less: all were compared"
    else:
        proof = f"the best found; no arrangement leaves less than {figure(found.bound)} (proved)"
    return [
        f"{found.layout.name}: weighed parts to cylinders",
        f"criterion, in {found.units[0]}: {figure(found.criterion)}; as listed {figure(found.listed)}, "
        f"at random {figure(found.random)}",
        proof,
        f"the root mean square over a turn of the force, and of the couple at a lever of "
        f"{figure(found.lever)} pitches, from {beyond}",
    ]


def _places(found: Assignment) -> tuple[list[str], list[list[str]]]:
    kinds = list(next(iter(found.places.values())))
    return kinds, [[str(n), *(names[k] for k in kinds)] for n, names in found.places.items()]


def _left(found: Assignment) -> list[list[str]]:
    pairs = zip(found.left, found.left_listed, strict=True)
    return [
        [str(best.order), *(figure(x) for x in (best.force, best.couple, first.force, first.couple))]
        for best, first in pairs
    ]


def assignment_json(found: Assignment) -> str:
    """Return the same as JSON."""
    document = {
        "engine": found.layout.name,
        "units": {"force": found.units[0], "couple": found.units[1]},
        "places": {str(number): names for number, names in found.places.items()},
        "criterion": found.criterion,
        "as_listed": found.listed,
        "at_random": found.random,
        "bound": found.bound,
        "proved": found.proved,
        "lever": found.lever,
        "counted": "differences from the mean" if found.beyond else "whole masses",
        "left": [_shaking(one) for one in found.left],
        "left_as_listed": [_shaking(one) for one in found.left_listed],
    }
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"


def _shaking(one: Shaking) -> dict[str, Any]:
    return {
        "order": str(one.order),
        "force": one.force,
        "couple": one.couple,
        "rms_force": one.mean_force,
        "rms_couple": one.mean_couple,
    }
