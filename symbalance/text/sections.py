"""Tables of an engine file with typed keys: each number read exactly, each refusal with its line."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, TypeVar

from symbalance.errors import SymbalanceError, shown
from symbalance.text.measurements import measured
from symbalance.text.numbers import checked_whole

T = TypeVar("T")
MILLI = 1e-3


@dataclass(frozen=True)
class Source:
    """The text of an engine file, `place` being what errors call it."""

    lines: tuple[str, ...]
    place: str

    def line_of(self, section: str, index: int, key: str = "") -> int:
        """Return the line of a key in the index-th table of a section, or of the table's head."""
        head = re.compile(rf"\s*\[\[?\s*{re.escape(section)}\s*\]")
        key_line = re.compile(rf"""\s*["']?{re.escape(key)}["']?\s*=""")
        seen, start, inside = -1, 1, False
        for number, line in enumerate(self.lines, 1):
            if re.match(r"\s*\[", line) and "=" not in line:
                inside = bool(head.match(line))
                seen += inside
                start = number if inside and seen == index else start
            elif inside and key and seen == index and key_line.match(line):
                return number
        return start


@dataclass(frozen=True)
class Section:
    """One table: `known` are the keys it may hold; numbers come back as floats in SI."""

    table: dict[str, Any]
    source: Source
    name: str
    known: tuple[str, ...]
    index: int = 0

    def __post_init__(self) -> None:
        for key in self.table:
            if key not in self.known:
                near = get_close_matches(key, self.known, 1)
                remedy = f"did you mean {near[0]}?" if near else f"known keys: {', '.join(self.known)}"
                what = shown(f"{self.name}.{key}")
                raise SymbalanceError(what, "is an unknown key", remedy, self.place(key))

    def __contains__(self, key: str) -> bool:
        return key in self.table

    def place(self, key: str = "") -> str:
        """Return the file and the line of a key, or of the table's head."""
        return f"{self.source.place}:{self.source.line_of(self.name, self.index, key)}"

    def refusal(self, key: str, rule: str, remedy: str) -> SymbalanceError:
        """Return the refusal of a key's value."""
        return SymbalanceError(f"{key} = {shown(self.table.get(key))}", rule, remedy, self.place(key))

    def missing(self, key: str, remedy: str) -> SymbalanceError:
        """Return the refusal of a table that lacks a key."""
        return SymbalanceError(f"[{self.name}]", f"needs {key}", remedy, self.place())

    def subsection(self, key: str, known: Sequence[str]) -> Section:
        """Return a table within this one, empty where it is not given."""
        value = self.table.get(key, {})
        if not isinstance(value, dict):
            raise self.refusal(key, "must be a table", f"write [{self.name}.{key}] on a line of its own")
        return Section(value, self.source, f"{self.name}.{key}", tuple(known))

    def subsections(self, key: str, known: Sequence[str]) -> list[Section]:
        """Return the tables of a list of tables within this one."""
        rows = self.table.get(key, [])
        if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
            raise self.refusal(key, f"must be [[{self.name}.{key}]] tables", "use double brackets")
        name = f"{self.name}.{key}"
        return [Section(row, self.source, name, tuple(known), i) for i, row in enumerate(rows)]

    def number(
        self,
        key: str,
        default: float | None,
        unit: float = 1.0,
        *,
        zero: bool = False,
        any_sign: bool = False,
    ) -> float:
        """Return a number times its unit; positive, or with `zero` not negative, or of any sign.

        `default` is in the file's unit; None: the key is required.
        """
        if key not in self.table:
            if default is None:
                raise self.missing(key, f"add {key} = ...")
            return default * unit
        return self._checked(key, self.table[key], zero, any_sign) * unit

    def numbers(
        self, key: str, count: int, default: float | None, unit: float = 1.0, *, zero: bool = False
    ) -> list[float]:
        """Return `count` numbers times their unit: one for all, or a list of as many."""
        value = self.table.get(key)
        if not isinstance(value, list):
            return [self.number(key, default, unit, zero=zero)] * count
        if len(value) != count:
            raise self.refusal(key, f"must be one number or {count}", "in order from the front")
        return [self._checked(key, v, zero, False) * unit for v in value]

    def several(self, key: str, default: Sequence[float]) -> list[float]:
        """Return one positive number or a list of them as a list."""
        value = self.table.get(key, list(default))
        values = value if isinstance(value, list) else [value]
        return [self._checked(key, v, False, False) for v in values]

    def places(self, key: str, highest: int) -> tuple[int, ...]:
        """Return a list of places counted from 1 at the front; empty where it is not given."""
        value = self.table.get(key, [])
        if not isinstance(value, list):
            raise self.refusal(key, "must be a list of places", "counted from 1 at the front: [1, 3]")
        return tuple(self.whole(key, 1, highest, v) for v in value)

    def whole(self, key: str, lowest: int, highest: int, value: object = None) -> int:
        """Return a whole number of a range."""
        value = self.table[key] if value is None else value
        return self.guarded(
            key, lambda: checked_whole(value, key, lowest, highest, "count from the front")
        )

    def text(self, key: str) -> str | None:
        """Return a text, None where it is not given."""
        value = self.table.get(key)
        if value is not None and not (isinstance(value, str) and value.strip() and value.isprintable()):
            raise self.refusal(key, "must be text", "write it in quotes")
        return value

    def guarded(self, key: str, make: Callable[[], T]) -> T:
        """Return what `make` returns, its refusal said of this key's line."""
        try:
            return make()
        except SymbalanceError as problem:
            raise problem.within(self.place(key)) from None

    def _checked(self, key: str, value: object, zero: bool, any_sign: bool) -> float:
        number = self.guarded(key, lambda: measured(value, key))
        if not any_sign and (number < 0 or (number == 0 and not zero)):
            rule = "must not be negative" if zero else "must be positive"
            raise SymbalanceError(f"{key} = {shown(value)}", rule, "check the value", self.place(key))
        return float(number)
