"""Strict reading of a TOML table by its description: every error names file, line and remedy.

A key that is unknown, a value of another type or out of range, a key that is missing and keys that
contradict each other are refused with file, line, value, rule and remedy.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from typing import Any, TypeVar

from symbalance.errors import SymbalanceError, brief
from symbalance.text.files import toml_table
from symbalance.text.key_tables import Key, TableKeys
from symbalance.text.numbers import checked_whole
from symbalance.text.toml_lines import KeyPath, lines_of

T = TypeVar("T")


@dataclass(frozen=True)
class SourceText:
    """The text of a file, `place` being what errors call it; no text where a table came from Python."""

    text: str
    place: str

    @cached_property
    def lines(self) -> dict[KeyPath, int]:
        """The line of each key; looked for when a refusal needs one."""
        return lines_of(self.text)

    def at(self, path: KeyPath) -> str:
        """Return the file and the line of a key, or of what it would stand in if it is not there."""
        if not self.text:
            return self.place
        while path and path not in self.lines:
            path = path[:-1]
        return f"{self.place}:{self.lines.get(path, 1)}"


@dataclass(frozen=True)
class Section:
    """One table, its keys checked to be known; `path` is where it stands in the file."""

    table: dict[str, Any]
    keys: TableKeys
    source: SourceText
    path: KeyPath = ()

    def __post_init__(self) -> None:
        if self.keys.others is not None:
            return
        for key in self.table:
            if key not in self.keys.by_name:
                known = tuple(self.keys.by_name)
                near = get_close_matches(str(key), known, 1)
                remedy = f"did you mean {near[0]}?" if near else f"known keys: {', '.join(known)}"
                what = brief(f"{self.keys.name}.{key}" if self.keys.name else key)
                raise SymbalanceError(what, "is an unknown key", remedy, self.place(key))

    def __contains__(self, key: str) -> bool:
        return key in self.table

    def place(self, key: str = "") -> str:
        """Return the file and the line of a key, or of the table's head."""
        return self.source.at((*self.path, key) if key else self.path)

    def refusal(self, key: str, rule: str, remedy: str) -> SymbalanceError:
        """Return the refusal of a key's value."""
        return SymbalanceError(f"{key} = {brief(self.table.get(key))}", rule, remedy, self.place(key))

    def refused(self, rule: str, remedy: str) -> SymbalanceError:
        """Return the refusal of the whole table."""
        if not self.keys.name:
            return SymbalanceError(self.source.place, rule, remedy)
        return SymbalanceError(self.head, rule, remedy, self.place())

    def missing(self, key: str, remedy: str) -> SymbalanceError:
        """Return the refusal of a table that lacks a key."""
        return self.refused(f"needs {key}", remedy)

    @property
    def head(self) -> str:
        """The table's head, as a refusal calls it."""
        listed = bool(self.path) and isinstance(self.path[-1], int)
        return f"[[{self.keys.name}]]" if listed else f"[{self.keys.name}]"

    def check(self) -> Section:
        """Return the section, or refuse it where a key is missing or its keys contradict each other."""
        for key in self.keys.keys:
            if key.required and key.name not in self.table:
                raise self.missing(key.name, key.needed)
        for rule in self.keys.rules:
            problem = rule.broken(self)
            if problem is not None:
                raise problem
        return self

    def values(self) -> dict[str, Any]:
        """Return the values of all keys that are given, those of tables within it left out."""
        return {
            key: self.value(key)
            for key in self.table
            if key not in self.keys.by_name or not isinstance(self.keys.by_name[key].kind, TableKeys)
        }

    def value(self, name: str) -> Any:
        """Return a key's value, its default where it is not given."""
        key = self.keys.by_name.get(name)
        if name not in self.table:
            assert key is not None
            if key.required:
                raise self.missing(name, key.needed)
            return key.default
        kind = self.keys.others if key is None else key.kind
        assert kind is not None
        assert not isinstance(kind, TableKeys)
        raw, remedy = self.table[name], "" if key is None else key.remedy
        try:
            return kind.read(raw, name, remedy)
        except SymbalanceError as problem:
            raise problem.within(self.place(name)) from None

    def section(self, name: str) -> Section:
        """Return a table within this one, empty where it is not given."""
        value, keys = self.table.get(name, {}), self._tables(name).kind
        assert isinstance(keys, TableKeys)
        if not isinstance(value, dict):
            raise self.refusal(name, "must be a table", f"write [{keys.name}] on a line of its own")
        return Section(value, keys, self.source, (*self.path, name)).check()

    def sections(self, name: str) -> list[Section]:
        """Return the tables of a list of tables within this one, none where it is not given."""
        rows, key = self.table.get(name, []), self._tables(name)
        assert isinstance(key.kind, TableKeys)
        if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
            rule, remedy = f"must be [[{key.kind.name}]] tables", "use double brackets"
            if key.inline:
                rule, remedy = "must be a list of tables", f"write {name} = {key.remedy}"
            raise self.refusal(name, rule, remedy)
        if name in self.table and len(rows) < key.least:
            raise self.refusal(name, "must not be empty", f"give {key.least} or more, or leave it out")
        path = (*self.path, name)
        return [Section(row, key.kind, self.source, (*path, i)).check() for i, row in enumerate(rows)]

    def _tables(self, name: str) -> Key:
        return self.keys.by_name[name]

    def number(self, name: str) -> float:
        """Return a number in SI units, its default where it is not given."""
        return float(self.value(name)) * self.keys.by_name[name].unit.factor

    def numbers(self, name: str, count: int) -> list[float]:
        """Return `count` numbers in SI units, of a key that is one for all, or a list from the front."""
        value, factor = self.value(name), self.keys.by_name[name].unit.factor
        if not isinstance(value, list):
            return [float(value) * factor] * count
        if len(value) != count:
            raise self.refusal(name, f"must be one number or {count}", "in order from the front")
        return [float(v) * factor for v in value]

    def places(self, name: str, highest: int) -> tuple[int, ...]:
        """Return places counted from 1 to `highest`, one or a list; none where the key is not given."""
        value = self.value(name)
        each = value if isinstance(value, list) else [] if value is None else [value]
        remedy = self.keys.by_name[name].remedy
        return tuple(
            self.guarded(lambda v=v: checked_whole(v, name, 1, highest, remedy), name) for v in each
        )

    def guarded(self, make: Callable[[], T], key: str = "", elsewhere: Sequence[Section] = ()) -> T:
        """Return what `make` returns, its refusal said of the line of `key`, or of the key it names.

        That key may stand in one of the tables `elsewhere` instead of this one.
        """
        try:
            return make()
        except SymbalanceError as problem:
            named = re.match(r"\w+", problem.what)
            word = key or (named[0] if named else "")
            at = next((table for table in (self, *elsewhere) if word in table), None)
            place = self.place(key) if at is None else at.place(word)
            raise problem.within(place) from None


def read_sections(text: str, place: str, keys: TableKeys, remedy: str = "correct the line") -> Section:
    """Return the tables of a TOML text, which errors call `place`; `remedy` is for what is no TOML."""
    return Section(toml_table(text, place, remedy), keys, SourceText(text, place)).check()
