"""The sidecar of a document: what its letters mean, where, and what its lines claim to be.

    [symbols]                        letter -> meaning or unit
    [[scope]]                        lines = [a, b] with symbols and given equalities of their own
    [[bind]]                         line, quantity, engine, order, ...: what a line claims to be

Unknown keys are errors; every refusal names the file and the line.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from symbalance.errors import SymbalanceError, shown
from symbalance.notes.reading import ReadingError, canonical_name
from symbalance.text.files import read_text, toml_table

_TOP = ("symbols", "scope", "bind")
_SCOPE = ("lines", "symbols", "given")
_BIND_TEXT = ("quantity", "engine", "convention", "text", "scale", "unit")
_BIND_WHOLE = ("line", "order", "column", "cylinder", "bank", "through", "power")
CONVENTIONS = ("l/r", "r/l", "l/s")


@dataclass(frozen=True, slots=True)
class Scope:
    """Lines with letters and assumptions of their own; both ends included."""

    first: int
    last: int
    symbols: Mapping[str, str] = field(default_factory=dict)
    given: tuple[str, ...] = ()

    def holds(self, line: int) -> bool:
        """Tell whether a line lies in the scope."""
        return self.first <= line <= self.last


@dataclass(frozen=True, slots=True)
class Bind:
    """What a line, or a piece `text` of it, claims to be."""

    line: int
    quantity: str
    engine: str = ""
    convention: str = ""
    text: str = ""
    scale: str = ""
    unit: str = ""
    order: int | None = None
    column: int | None = None
    cylinder: int | None = None
    bank: int | None = None
    through: int | None = None
    power: int | None = None
    place: str = ""

    @property
    def title(self) -> str:
        """Return what the line claims to be, in words."""
        if self.quantity == "value":
            return self.scale
        parts = [self.quantity]
        parts += [f"order {self.order}"] if self.order is not None else []
        parts += [f"cylinder {self.cylinder}"] if self.cylinder is not None else []
        parts += [f"bank {self.bank}"] if self.bank is not None else []
        parts += [f"of {Path(self.engine).stem}"] if self.engine else []
        return ", ".join(parts[:-1]) + (" " if self.engine else ", " if parts[:-1] else "") + parts[-1]


@dataclass(frozen=True, slots=True)
class Declarations:
    """All that is declared about a document."""

    symbols: Mapping[str, str] = field(default_factory=dict)
    scopes: tuple[Scope, ...] = ()
    binds: tuple[Bind, ...] = ()
    place: str = "symbols"

    def symbols_at(self, line: int) -> dict[str, str]:
        """Return the letters declared for a line; later scopes override earlier ones."""
        found = dict(self.symbols)
        for scope in self.scopes:
            if scope.holds(line):
                found |= scope.symbols
        return found

    def given_at(self, line: int) -> tuple[str, ...]:
        """Return the assumptions that stand at a line."""
        return tuple(given for scope in self.scopes if scope.holds(line) for given in scope.given)

    def owner(self, letter: str, line: int) -> int:
        """Return the number of the last scope that declares a letter at a line, -1 for [symbols]."""
        return max((k for k in self.scope_at(line) if letter in self.scopes[k].symbols), default=-1)

    def scope_at(self, line: int) -> tuple[int, ...]:
        """Return the numbers of the scopes a line lies in: what tells two places' letters apart."""
        return tuple(k for k, scope in enumerate(self.scopes) if scope.holds(line))


def read_sidecar(path: str | Path) -> Declarations:
    """Return the declarations of a sidecar file."""
    return parse_sidecar(read_text(path, what="a symbols file"), str(path))


def parse_sidecar(text: str, place: str) -> Declarations:
    """Return the declarations in the text of a sidecar; `place` is what errors call it."""
    remedy = 'correct the line; a letter such as θ stands in quotes: "θ" = "crank angle"'
    table = toml_table(text, place, remedy)
    return _Reader(text.split("\n"), place).declarations(table)


def declared(symbols: Mapping[str, Any]) -> Declarations:
    """Return the declarations in a Python mapping: letters to meanings, or a sidecar's whole table."""
    if any(isinstance(value, str) for value in symbols.values()) or not set(symbols) <= set(_TOP):
        return _Reader([], "symbols").declarations({"symbols": dict(symbols)})
    return _Reader([], "symbols").declarations(dict(symbols))


class _Reader:
    """Turns a parsed table into declarations, saying of every refusal where it stands."""

    def __init__(self, lines: list[str], place: str) -> None:
        self.lines, self.place = lines, place

    def declarations(self, table: dict[str, Any]) -> Declarations:
        self.check_keys(table, _TOP, 0, "")
        scopes = [self.scope(t, k) for k, t in enumerate(self.tables(table, "scope"))]
        binds = [self.bind(t, k) for k, t in enumerate(self.tables(table, "bind"))]
        symbols = self.symbols(table.get("symbols", {}), self.header("symbols", 0))
        return Declarations(symbols, tuple(scopes), tuple(binds), self.place)

    def tables(self, table: dict[str, Any], key: str) -> list[dict[str, Any]]:
        value = table.get(key, [])
        if not isinstance(value, list) or not all(isinstance(t, dict) for t in value):
            raise self.refusal(key, value, f"must be [[{key}]] tables", f"write [[{key}]]", 0)
        return value

    def symbols(self, table: Any, start: int) -> dict[str, str]:
        if not isinstance(table, dict):
            raise self.refusal("symbols", table, "must be a table", "write letter = meaning", start)
        found: dict[str, str] = {}
        for letter, meaning in table.items():
            if not isinstance(meaning, str):
                raise self.refusal(letter, meaning, "must be text", "write the meaning in quotes", start)
            try:
                name = canonical_name(letter)
            except ReadingError as problem:
                raise self.refusal(letter, meaning, problem.what, "write one letter", start) from None
            if name in found:
                raise self.refusal(letter, meaning, "is declared twice", "keep one line of it", start)
            found[name] = meaning.strip()
        return found

    def scope(self, table: dict[str, Any], k: int) -> Scope:
        start = self.header("scope", k)
        self.check_keys(table, _SCOPE, start, "scope ")
        lines = table.get("lines")
        if not (isinstance(lines, list) and len(lines) == 2 and all(_whole(n) for n in lines)):
            raise self.refusal(
                "lines", lines, "must be two line numbers", "write lines = [10, 20]", start
            )
        if not 1 <= lines[0] <= lines[1]:
            raise self.refusal("lines", lines, "must go upwards from 1", "write lines = [10, 20]", start)
        given = table.get("given", [])
        if not (isinstance(given, list) and all(isinstance(g, str) for g in given)):
            raise self.refusal("given", given, "must be a list of equalities", 'write ["α = π/6"]', start)
        symbols = self.symbols(table.get("symbols", {}), start)
        return Scope(lines[0], lines[1], symbols, tuple(given))

    def bind(self, table: dict[str, Any], k: int) -> Bind:
        start = self.header("bind", k)
        self.check_keys(table, (*_BIND_TEXT, *_BIND_WHOLE), start, "bind ")
        for key in ("line", "quantity"):
            if key not in table:
                raise self.refusal(f"bind {k + 1}", "", f"has no {key}", f"add {key} = …", start)
        for key in _BIND_WHOLE:
            if key in table and not (
                _whole(table[key]) and (table[key] >= 1 or key in ("bank", "power"))
            ):
                raise self.refusal(key, table[key], "must be a whole number", f"write {key} = 2", start)
        for key in _BIND_TEXT:
            if key in table and not isinstance(table[key], str):
                raise self.refusal(key, table[key], "must be text", "write it in quotes", start)
        if table.get("convention", "l/r") not in CONVENTIONS:
            remedy = "write one of " + ", ".join(CONVENTIONS)
            raise self.refusal("convention", table["convention"], "is not known", remedy, start)
        return Bind(**table, place=f"{self.place}:{start}" if start else self.place)

    def check_keys(self, table: dict[str, Any], known: tuple[str, ...], start: int, of: str) -> None:
        for key in table:
            if key not in known:
                rule = "is not a key of the sidecar"
                raise self.refusal(f"{of}{key}", "", rule, "known are " + ", ".join(known), start)

    def header(self, name: str, k: int) -> int:
        """Return the line, from 1, of the k-th [[name]] or of [name]; 0 if there is no text."""
        pattern = re.compile(rf"\s*\[\[?\s*{name}\s*\]\]?")
        found = [n for n, line in enumerate(self.lines, 1) if pattern.match(line)]
        return found[k] if k < len(found) else 0

    def refusal(self, key: str, value: Any, rule: str, remedy: str, start: int) -> SymbalanceError:
        bare = key.rsplit(" ", maxsplit=1)[-1]
        lines = [
            n
            for n, line in enumerate(self.lines, 1)
            if n > start - 1 and re.match(rf"\s*[\"']?{re.escape(bare)}[\"']?\s*=", line)
        ]
        line = lines[0] if lines else start
        what = f"{key} = {shown(value)}" if value != "" else key
        return SymbalanceError(what, rule, remedy, f"{self.place}:{line}" if line else self.place)


def _whole(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)
