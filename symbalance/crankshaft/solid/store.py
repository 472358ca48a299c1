"""Store of web flexibilities solved by finite elements: what one machine has meshed, every other reads.

A store is a JSON file {"format": 3, "mesher": digest, "checksum": digest of the webs, "webs": {key:
{"web": what it is of, "flexibility": 144 numbers, "body": 3 numbers}}}. The key is that of the geometry
in own axes (sizes to the nanometre), Poisson's ratio and, where it is not the usual one, the elements'
size; the flexibility is E S, which does not depend on Young's modulus. The package's own store holds the
worked cranks'.

`mesher` is a digest of the sources that draw, mesh and solve a web: what other sources have solved is not
believed but solved anew, and a line to `say` tells the user; so it does of a file that is damaged, which
its checksum shows.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.crank import Crank
from symbalance.crankshaft.webs.arm import Arm, WebCompliance, arms
from symbalance.errors import SymbalanceError, brief
from symbalance.jobs.digests import digest
from symbalance.text.files import read_bytes
from symbalance.text.writing import write_file

FORMAT = 3
SOURCES = (
    "solid",
    "webs",
    "crank.py",
    "rotor/parts.py",
    "rotor/matrices.py",
    "rotor/beams.py",
    "rotor/rigid_bodies.py",
)
"""The files and rooms of `symbalance.crankshaft` on which a solved flexibility depends."""
LARGEST_FILE = 50_000_000
"""Bytes: some ten thousand webs."""
Say = Callable[[str], None]


@dataclass
class WebStore:
    """Web flexibilities by geometry; `path` is the file of the `new_webs`, if there is one."""

    webs: dict[str, dict[str, Any]] = field(default_factory=dict)
    path: Path | None = None
    new_webs: dict[str, dict[str, Any]] = field(default_factory=dict)
    """Those of `webs` that were solved here, not shipped with the package."""

    def lookup(self, arm: Arm, size: float = 0.0) -> WebCompliance | None:
        """Return the web's flexibility in its own axes, or None where it is not solved yet."""
        entry = self.webs.get(web_key(arm, size))
        if entry is None:
            return None
        flexible, body = _numbers(entry)
        return WebCompliance(flexible / arm.material.young, body)

    def keep(self, arm: Arm, elastic: WebCompliance, size: float = 0.0) -> None:
        """Keep a solved flexibility, on disk too where the store has a path; whole or not at all.

        What another run has put there since stays.
        """
        if elastic.body is None:
            raise SymbalanceError("a web without a body", "is not a solved one", "solve it as a solid")
        numbers = (elastic.flexibility * arm.material.young).ravel().tolist()
        entry = {"web": web_description(arm, size), "flexibility": numbers, "body": elastic.body.tolist()}
        self.webs[web_key(arm, size)] = self.new_webs[web_key(arm, size)] = entry
        if self.path is not None:
            self.new_webs = _webs_at(self.path, lambda line: None) | self.new_webs
            document = {"format": FORMAT, "mesher": mesher_digest()}
            document |= {"checksum": _checksum(self.new_webs), "webs": self.new_webs}
            text = json.dumps(document, indent=1) + "\n"
            write_file(self.path, text, what="", remedy="name a folder you may write to")


def open_store(path: Path | None = None, say: Say = lambda line: None) -> WebStore:
    """Return the package's own solved webs, and those of the file `path`; `say` hears what is not valid.

    >>> open_store().path is None
    True
    """
    own = files("symbalance.crankshaft.solid") / "solved.json"
    webs = _check_webs(_document(own.read_bytes())["webs"])
    new_webs = {} if path is None else _webs_at(path, say)
    return WebStore(new_webs | webs, path, new_webs)


@cache
def mesher_digest() -> str:
    """Return a digest of the sources on which a solved flexibility depends."""
    room = files("symbalance.crankshaft")
    sources = []
    for name in SOURCES:
        entry = room / name
        inside = [entry] if entry.is_file() else [f for f in entry.iterdir() if f.name.endswith(".py")]
        sources += [(name, f.name, f.read_bytes().hex()) for f in inside]
    return digest(sorted(sources))


def _webs_at(path: Path, say: Say) -> dict[str, dict[str, Any]]:
    """Return the webs of a file of this mesher; none of one that is not there, damaged or of another."""
    if not path.exists():
        return {}
    try:
        if path.is_file() and path.stat().st_size > LARGEST_FILE:
            raise _DamagedError(f"it is larger than {LARGEST_FILE} bytes")
        document = _document(read_bytes(path, LARGEST_FILE, "a file for solved webs", pipes=False))
        webs = document["webs"]
        if (document.get("format"), document.get("mesher")) != (FORMAT, mesher_digest()):
            if webs:
                say(f"{path}: holds webs that another version solved: those needed are solved anew")
            return {}
        if document.get("checksum") != _checksum(webs):
            raise _DamagedError("its checksum is another")
        return _check_webs(webs)
    except _DamagedError as problem:
        say(f"{path}: is damaged ({problem}): the webs needed are solved anew")
        return {}


class _DamagedError(Exception):
    """A store is not what was written; the text says in what."""


def _checksum(webs: dict[str, Any]) -> str:
    """Return a digest of a store's webs: of what they say, whatever the spaces between it."""
    return sha256(json.dumps(webs, sort_keys=True).encode()).hexdigest()


def _document(content: bytes) -> dict[str, Any]:
    try:
        document = json.loads(content.decode("utf-8"))
    except (ValueError, RecursionError):
        raise _DamagedError("it is no JSON") from None
    if not isinstance(document, dict) or not isinstance(document.get("webs"), dict):
        raise _DamagedError("it holds no webs")
    return document


def _check_webs(webs: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return webs, each of which can be one; what is not, or stands under another's key, is damage."""
    for name, entry in webs.items():
        try:
            matrix, body = _numbers(entry)
            finite = np.isfinite(matrix).all() and np.isfinite(body).all()
            sound = finite and np.allclose(matrix, matrix.T) and np.linalg.eigvalsh(matrix)[0] > 0
            described_so = _hash_of(entry["web"]) == name
        except (ValueError, KeyError, TypeError, AttributeError, ArithmeticError):
            raise _DamagedError(f"web {brief(name)} lacks its numbers") from None
        if not sound:
            raise _DamagedError(f"the flexibility of {brief(name)} is not symmetric and positive")
        if not described_so:
            raise _DamagedError(f"web {brief(name)} is not the web it describes")
    return webs


def _numbers(entry: dict[str, Any]) -> tuple[Array, Array]:
    flexible = np.array(entry["flexibility"], dtype=float).reshape(2 * DOF, 2 * DOF)
    return flexible, np.array(entry["body"], dtype=float).reshape(3)


def web_description(arm: Arm, size: float = 0.0) -> str:
    """Return the sizes, in mm, that decide a web's flexibility; and its elements', if not the usual."""
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
    mesh = f" elements {_mm(size)}" if size else ""
    return f"{parts[0]} web {slab} {parts[1]}{sector} nu {own.material.poisson:.6f}{mesh}"


def _round(part: object) -> str:
    return " ".join(_mm(getattr(part, name)) for name in ("diameter", "length", "bore", "fillet"))


def _mm(length: float) -> str:
    return f"{length * 1e3 + 0.0:.6f}"


def web_key(arm: Arm, size: float = 0.0) -> str:
    """Return the name of a web in the store."""
    return _hash_of(web_description(arm, size))


def _hash_of(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:16]


def solve_missing(crank: Crank, store: WebStore, size: float = 0.0) -> int:
    """Mesh and solve the crank's webs that the store lacks; return how many there were.

    `size` of the elements in m, 0 for the usual one.
    """
    from symbalance.crankshaft.solid.half_throw import solve_web

    count = 0
    for _, arm in arms(crank):
        if store.lookup(arm, size) is None:
            store.keep(arm, solve_web(arm, size), size)
            count += 1
    return count


def solid_web(arm: Arm, store: WebStore) -> WebCompliance:
    """Return a web's flexibility from the store, or meshed and solved now."""
    from symbalance.crankshaft.solid.half_throw import solve_web

    elastic = store.lookup(arm)
    if elastic is None:
        elastic = solve_web(arm)
        store.keep(arm, elastic)
        # As read back: E S / E differs from S by rounding, and a saved key depends on every digit.
        elastic = store.lookup(arm) or elastic
    return elastic
