"""Solved web flexibilities as data: what one machine has meshed, every other reads.

A store is a JSON file {"webs": {key: {"web": what it is of, "flexibility": 144 numbers, "body": 3
numbers}}}. The key is that of the geometry in own axes (sizes to the nanometre) and Poisson's ratio; the
flexibility is E S, which does not depend on Young's modulus. The package's own store holds the worked
cranks'.
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.crankshaft.crank import Crank
from symbalance.crankshaft.rotor import DOF, Array
from symbalance.crankshaft.webs.arm import Arm, Elastic, arms
from symbalance.errors import SymbalanceError, shown


@dataclass
class Store:
    """Web flexibilities by geometry; `path` is where new ones are kept, if anywhere."""

    webs: dict[str, dict[str, Any]] = field(default_factory=dict)
    path: Path | None = None

    def found(self, arm: Arm) -> Elastic | None:
        """Return the web's flexibility in its own axes, or None where nobody has solved it."""
        entry = self.webs.get(key(arm))
        if entry is None:
            return None
        flexible, body = _numbers(entry)
        return Elastic(flexible / arm.material.young, body)

    def kept(self, arm: Arm, elastic: Elastic) -> None:
        """Keep a solved flexibility, on disk too where the store has a path; whole or not at all."""
        if elastic.body is None:
            raise SymbalanceError("a web without a body", "is not a solved one", "solve it as a solid")
        scaled = (elastic.flexibility * arm.material.young).ravel().tolist()
        entry = {"web": described(arm), "flexibility": scaled, "body": elastic.body.tolist()}
        self.webs[key(arm)] = entry
        if self.path is not None:
            part = self.path.with_name(f"{self.path.name}.{os.getpid()}.part")
            part.write_text(json.dumps({"webs": self.webs}, indent=1) + "\n", encoding="utf-8")
            part.replace(self.path)


def open_store(path: Path | None = None) -> Store:
    """Return the package's own solved webs, and those kept at `path`.

    >>> open_store().path is None
    True
    """
    own = files("symbalance.crankshaft.solid") / "solved.json"
    webs = _read(own.read_text(encoding="utf-8"), "solved.json")
    if path is not None and path.exists():
        webs |= _read(path.read_text(encoding="utf-8"), str(path))
    return Store(webs, path)


def _read(text: str, place: str) -> dict[str, dict[str, Any]]:
    rule, remedy = "must hold solved webs", "delete it: it is written anew"
    try:
        webs = json.loads(text)["webs"]
        for name, entry in webs.items():
            matrix, _ = _numbers(entry)
            if not (np.allclose(matrix, matrix.T) and np.linalg.eigvalsh(matrix)[0] > 0):
                what = f"flexibility of {shown(name)}"
                raise SymbalanceError(what, "must be symmetric and positive", remedy, place)
    except (ValueError, KeyError, TypeError, AttributeError) as err:
        if isinstance(err, SymbalanceError):
            raise
        raise SymbalanceError("the file", rule, remedy, place) from err
    return webs


def _numbers(entry: dict[str, Any]) -> tuple[Array, Array]:
    flexible = np.array(entry["flexibility"], dtype=float).reshape(2 * DOF, 2 * DOF)
    return flexible, np.array(entry["body"], dtype=float).reshape(3)


def described(arm: Arm) -> str:
    """Return the sizes, in mm, that decide a web's flexibility."""
    own = arm.canonical()
    parts = [_round(p) for p in (own.near, own.far)]
    sizes = (own.web.thickness, own.web.width, own.near_margin, own.far_margin, own.reach)
    slab = " ".join(_mm(x) for x in sizes)
    weight = own.web.counterweight
    sector = ""
    if weight and weight.outer > 0:
        turn = np.round(np.degrees([weight.angle, weight.half_angle]), 6) % 360
        place = " ".join(_mm(-x + 0.0) for x in own.axis)
        sector = f" sector {_mm(weight.outer)} {turn[0]:.6f} {turn[1]:.6f} {place}"
    return f"{parts[0]} web {slab} {parts[1]}{sector} nu {own.material.poisson:.6f}"


def _round(part: object) -> str:
    return " ".join(_mm(getattr(part, name)) for name in ("diameter", "length", "bore", "fillet"))


def _mm(length: float) -> str:
    return f"{length * 1e3 + 0.0:.6f}"


def key(arm: Arm) -> str:
    """Return the name under which a web's flexibility is kept."""
    return sha256(described(arm).encode()).hexdigest()[:16]


def solve_missing(crank: Crank, store: Store, size: float = 0.0) -> int:
    """Mesh and solve the crank's webs that the store lacks; return how many there were."""
    from symbalance.crankshaft.solid.half_throw import solved_web

    solved = 0
    for _, arm in arms(crank):
        if store.found(arm) is None:
            store.kept(arm, solved_web(arm, size))
            solved += 1
    return solved


def solid_web(arm: Arm, store: Store) -> Elastic:
    """Return a web's flexibility from the store, or meshed and solved now."""
    from symbalance.crankshaft.solid.half_throw import solved_web

    elastic = store.found(arm)
    if elastic is None:
        elastic = solved_web(arm)
        store.kept(arm, elastic)
    return elastic
