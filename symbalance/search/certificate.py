"""The certificate of a search with conditions: every branch with the reason for which it ends.

It holds the question as plain numbers (what each pin on each ray adds to each sum, which moments it
takes, the symmetries) and, node by node in the order of the walk, one letter:

    x   all rays that are free for the next pin follow
    c   cut: some limit is passed whatever the rest;  f  a complete star that fails one
    i   an image under a symmetry comes before it;  s   a complete star that meets every condition

`certificate_check.py` verifies it, by itself and with nothing of this library: see there.
"""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np

from symbalance.errors import SymbalanceError
from symbalance.search.cranks_search import search_spec
from symbalance.search.firing_variants import FiringVariants
from symbalance.search.front import Judge
from symbalance.search.subtrees import SearchSpec
from symbalance.search.tables import Tables

MOST_NODES = 2_000_000
"""Letters of a certificate: some minutes of checking."""


def search_certificate(cylinders: object, **question: Any) -> str:
    """Return the certificate of a search with conditions, as JSON; arguments as for `search_cranks`.

    >>> len(json.loads(search_certificate(5, require=["couple.1=0"]))["walks"][0]["letters"])
    6
    """
    spec = search_spec(cylinders, **question)
    named = {c.name for c in spec.conditions}
    if not spec.conditions or any(o.by_firing for o in spec.objectives if o.name in named):
        rule = "is for conditions on the crank"
        raise SymbalanceError("a certificate", rule, "add --require or --limit, as couple.1=0")
    tables = spec.tables()
    takes = tables.takes.copy()
    takes[tables.order[0], 1:] = -1  # cylinder 1 stands on ray 0
    tables = replace(tables, takes=takes)
    data = {
        "certificate": "symbalance search 1",
        "question": spec.problem.words(),
        "rays": tables.rays,
        "order": tables.order.tolist(),
        "takes": tables.takes.tolist(),
        "symmetries": [[list(one.source), one.sign, list(one.shift)] for one in spec.symmetries],
        "conditions": [_condition(spec, c.name) for c in spec.conditions],
        "walks": [
            {"capacity": list(pattern.capacity), **_Walk(spec, tables, place).letters()}
            for place, pattern in enumerate(spec.problem.patterns)
        ],
    }
    return json.dumps(data, separators=(",", ":")) + "\n"


def _condition(spec: SearchSpec, name: str) -> dict[str, Any]:
    """Return a condition in plain numbers: terms [weight, turns] by form, pin and ray."""
    condition = next(c for c in spec.conditions if c.name == name)
    objective = next(o for o in spec.objectives if o.name == name)
    throws = [spec.problem.throws([s] * spec.problem.pin_count) for s in range(spec.problem.rays)]
    return {
        "name": name,
        "exactly": condition.exactly,
        "limit": str(condition.limit),
        "groups": [
            [
                [
                    [
                        [
                            [str(w), str((fixed + turn * by_ray[n]) % 1)]
                            for n, (w, fixed, turn) in form.weights.items()
                            if n in {seat.number for seat in pin}
                        ]
                        for by_ray in throws
                    ]
                    for pin in spec.problem.seats
                ]
                for form in group
            ]
            for group in objective.groups
        ],
    }


class _Walk:
    """A plain walk over the stars of one pattern that notes why each branch ends."""

    def __init__(self, spec: SearchSpec, tables: Tables, pattern: int) -> None:
        self.tables, self.capacity = tables, list(spec.problem.patterns[pattern].capacity)
        variants = FiringVariants(spec.problem, spec.problem.patterns[pattern])
        nothing = np.zeros((0, 0))
        self.judge = Judge(spec.objectives, spec.conditions, (), tables, variants, 1, nothing)
        self.found: list[list[int]] = []
        self.notes: list[str] = []

    def letters(self) -> dict[str, Any]:
        """Return the letters of the walk, and the stars that meet every condition."""
        self._node([], np.zeros(self.tables.forms, np.complex128))
        return {"letters": "".join(self.notes), "found": self.found}

    def _node(self, star: list[int], sums: Any) -> None:
        if len(self.notes) >= MOST_NODES:
            remedy = "ask for less, or for tighter limits"
            raise SymbalanceError(
                "a certificate", f"of more than {MOST_NODES} letters is not written", remedy
            )
        tables, depth = self.tables, len(star)
        if depth and self._is_cut(sums, depth):
            self.notes.append("f" if depth == tables.pins else "c")
        elif depth and self._has_image(star):
            self.notes.append("i")
        elif depth == tables.pins:
            rays = [0] * tables.pins
            for pin, ray in zip(tables.order.tolist(), star, strict=True):
                rays[pin] = ray
            before = self.judge.found.classes
            self.judge.offer(np.array([rays]), np.array([[1, 1, 1]]))
            met = self.judge.found.classes > before
            self.notes.append("s" if met else "f")
            if met:
                self.found.append(rays)
        else:
            self.notes.append("x")
            pin = int(tables.order[depth])
            for ray in range(tables.rays):
                ticks = tables.takes[pin, ray].tolist()
                if ticks[0] < 0 or any(self.capacity[t] < ticks.count(t) for t in ticks):
                    continue
                for tick in ticks:
                    self.capacity[tick] -= 1
                self._node([*star, ray], sums + tables.floats[:, pin, ray])
                for tick in ticks:
                    self.capacity[tick] += 1

    def _is_cut(self, sums: Any, depth: int) -> bool:
        tables = self.tables
        for group, owner in zip(tables.groups, tables.owners, strict=True):
            forms = group[group >= 0]
            least = np.maximum(0.0, abs(sums[forms]) - tables.rest[forms, depth]).sum()
            if tables.asked[owner] and least > tables.limits[owner] + tables.slack[forms].sum():
                return True
        return False

    def _has_image(self, star: list[int]) -> bool:
        tables = self.tables
        placed = dict(zip(tables.order.tolist(), star, strict=False))
        for source, sign, shift in zip(tables.sources, tables.signs, tables.shifts, strict=True):
            for pin, ray in placed.items():
                if source[0] not in placed or source[pin] not in placed:
                    break
                turned = sign * (placed[int(source[pin])] - placed[int(source[0])])
                image = (turned + shift[pin]) % tables.rays
                if image < ray:
                    return True
                if image > ray:
                    break
        return False
