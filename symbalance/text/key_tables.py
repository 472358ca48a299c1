"""Descriptions of TOML tables, key by key: kind, unit, range, default and meaning.

From one description come the reader (`sections`), the reference of keys in Markdown and the JSON Schema
for editors, so that the three cannot differ. Knows no engine: what the keys are is said where they are
used.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Protocol

from symbalance.errors import SymbalanceError
from symbalance.text.kinds import Kind, Schema


@dataclass(frozen=True)
class FileUnit:
    """A unit as files name it, and how much of the SI's unit it is."""

    name: str
    factor: float = 1.0


NO_UNIT = FileUnit("")


@dataclass(frozen=True)
class Key:
    """One key of a table.

    `default` is what the reader takes where the key is not given, in the file's unit; `otherwise` says in
    words what then holds. `remedy` ends the refusal of a value out of range, `add` that of a table that
    lacks the key and must not. Of a table within the table the kind is a `TableKeys`; `listed` is a list
    of such tables, `least` of them where it is given.
    """

    name: str
    kind: Kind | TableKeys
    meaning: str
    unit: FileUnit = NO_UNIT
    default: Any = None
    otherwise: str = ""
    required: bool = False
    remedy: str = ""
    add: str = ""
    listed: bool = False
    least: int = 0
    inline: bool = False
    """Whether its tables are usually written in braces, without a head of their own."""

    @property
    def needed(self) -> str:
        """What the refusal of a table without this key advises."""
        return self.add or f"add {self.name} = ..."

    def schema(self) -> Schema:
        """Return the JSON Schema of the key's value, with what an editor shows beside it."""
        schema = self.kind.schema()
        if self.listed:
            least = {"minItems": self.least} if self.least else {}
            schema = {"type": "array", "items": schema, **least}
        beside: Schema = {"description": self.description}
        if isinstance(self.default, int | float | str):
            beside["default"] = self.default
        return {**beside, **schema}

    @property
    def description(self) -> str:
        """The meaning, with the unit and what holds where the key is not given."""
        unit = f" ({self.unit.name})" if self.unit.name else ""
        needed = " Required." if self.required else f" Default: {self.fallback}." if self.fallback else ""
        return f"{self.meaning}{unit}.{needed}"

    @property
    def fallback(self) -> str:
        """What holds where the key is not given, in words; "" where nothing does."""
        return self.otherwise or ("" if self.default is None else str(self.default))


class CheckedTable(Protocol):
    """A table as a rule looks at it: which keys it has, and how a refusal is said of it."""

    def __contains__(self, key: str) -> bool: ...

    def refusal(self, key: str, rule: str, remedy: str) -> SymbalanceError:
        """Return the refusal of a key's value."""
        ...

    def refused(self, rule: str, remedy: str) -> SymbalanceError:
        """Return the refusal of the table."""
        ...

    def missing(self, key: str, remedy: str) -> SymbalanceError:
        """Return the refusal of a table that lacks a key."""
        ...


class Rule(Protocol):
    """What the keys of a table must be together."""

    @property
    def words(self) -> str:
        """The rule as the reference says it."""
        ...

    def broken(self, table: CheckedTable) -> SymbalanceError | None:
        """Return the refusal of a table that breaks the rule."""
        ...

    def schema(self) -> Schema:
        """Return the rule as a JSON Schema."""
        ...


def _any_of(keys: Sequence[str]) -> Schema:
    required: list[Schema] = [{"required": [key]} for key in keys]
    return required[0] if len(required) == 1 else {"anyOf": required}


def _coded(keys: Sequence[str], last: str = "or") -> str:
    *first, end = (f"`{key}`" for key in keys)
    return f"{', '.join(first)} {last} {end}" if first else end


@dataclass(frozen=True)
class OneOf:
    """Of several groups of keys exactly one is there; a key of a group stands for it."""

    groups: tuple[tuple[str, ...], ...]
    rule: str
    remedy: str

    @property
    def words(self) -> str:
        """The rule as the reference says it."""
        return f"Exactly one of {_coded([g[0] for g in self.groups], 'and')}."

    def broken(self, table: CheckedTable) -> SymbalanceError | None:
        """Return the refusal of a table with none or several of them."""
        there = [group for group in self.groups if any(key in table for key in group)]
        return None if len(there) == 1 else table.refused(self.rule, self.remedy)

    def schema(self) -> Schema:
        """Return the rule as a JSON Schema."""
        return {"oneOf": [_any_of(group) for group in self.groups]}


@dataclass(frozen=True)
class Some:
    """Of several keys at least one is there."""

    keys: tuple[str, ...]
    remedy: str

    @property
    def words(self) -> str:
        """The rule as the reference says it."""
        return f"At least one of {_coded(self.keys, 'and')}."

    def broken(self, table: CheckedTable) -> SymbalanceError | None:
        """Return the refusal of a table without any of them."""
        missing = not any(key in table for key in self.keys)
        return table.missing(self.keys[0], self.remedy) if missing else None

    def schema(self) -> Schema:
        """Return the rule as a JSON Schema."""
        return _any_of(self.keys)


@dataclass(frozen=True)
class Excludes:
    """A key may not stand beside any of the others."""

    key: str
    others: tuple[str, ...]
    rule: str
    remedy: str

    @property
    def words(self) -> str:
        """The rule as the reference says it."""
        return f"`{self.key}` without {_coded(self.others)}."

    def broken(self, table: CheckedTable) -> SymbalanceError | None:
        """Return the refusal of a table that has both."""
        if self.key in table and any(other in table for other in self.others):
            return table.refusal(self.key, self.rule, self.remedy)
        return None

    def schema(self) -> Schema:
        """Return the rule as a JSON Schema."""
        return {"not": {"allOf": [{"required": [self.key]}, _any_of(self.others)]}}


@dataclass(frozen=True)
class Needs:
    """A key is only there beside another one; without `rule` that other one is said to be missing."""

    key: str
    other: str
    remedy: str
    rule: str = ""

    @property
    def words(self) -> str:
        """The rule as the reference says it."""
        return f"`{self.key}` only with `{self.other}`."

    def broken(self, table: CheckedTable) -> SymbalanceError | None:
        """Return the refusal of a table that has the key alone."""
        if self.key not in table or self.other in table:
            return None
        if self.rule:
            return table.refusal(self.key, self.rule, self.remedy)
        return table.missing(self.other, self.remedy)

    def schema(self) -> Schema:
        """Return the rule as a JSON Schema."""
        return {"anyOf": [{"not": {"required": [self.key]}}, {"required": [self.other]}]}


@dataclass(frozen=True)
class Together:
    """Several keys are all there or none of them."""

    keys: tuple[str, ...]
    remedy: str

    @property
    def words(self) -> str:
        """The rule as the reference says it."""
        return f"{_coded(self.keys, 'and')} together."

    def broken(self, table: CheckedTable) -> SymbalanceError | None:
        """Return the refusal of a table with some of them, which names the first that is missing."""
        missing = [key for key in self.keys if key not in table]
        if len(missing) in (0, len(self.keys)):
            return None
        return table.missing(missing[0], f"add {missing[0]} = ..., {self.remedy}")

    def schema(self) -> Schema:
        """Return the rule as a JSON Schema."""
        return {"anyOf": [{"required": list(self.keys)}, {"not": _any_of(self.keys)}]}


@dataclass(frozen=True)
class TableKeys:
    """The keys a table may hold, and the rules they keep together.

    `name` is what its head says, "" for the file's top. `others` is the kind of all keys that are not
    listed, None where there may be none.
    """

    name: str
    keys: tuple[Key, ...]
    rules: tuple[Rule, ...] = ()
    meaning: str = ""
    others: Kind | None = None

    @cached_property
    def by_name(self) -> dict[str, Key]:
        """The keys by name."""
        return {key.name: key for key in self.keys}

    def with_kinds(self, kinds: Mapping[str, Kind | TableKeys]) -> TableKeys:
        """Return the same table, some of whose keys are of other kinds: described in another room."""
        keys = tuple(replace(key, kind=kinds.get(key.name, key.kind)) for key in self.keys)
        return replace(self, keys=keys)

    def schema(self) -> Schema:
        """Return the JSON Schema of the table."""
        schema: Schema = {
            "type": "object",
            "properties": {key.name: key.schema() for key in self.keys},
            "additionalProperties": self.others.schema() if self.others else False,
        }
        required = [key.name for key in self.keys if key.required]
        if required:
            schema["required"] = required
        if self.rules:
            schema["allOf"] = [rule.schema() for rule in self.rules]
        return schema

    def reference(self, listed: bool = False, inline: bool = False) -> list[str]:
        """Return the lines of Markdown that list the keys, then those of the tables within."""
        head = f"[[{self.name}]]" if listed else f"[{self.name}]"
        title = f"`{self.name.rsplit('.', 1)[-1]} = [{{ ... }}]`" if inline else f"`{head}`"
        lines = [f"### {title if self.name else 'The top of the file'}", ""]
        lines += [self.meaning, ""] if self.meaning else []
        lines += ["| key | value | unit | default | meaning |", "|---|---|---|---|---|"]
        lines += [_row(key) for key in self.keys]
        lines += ["", " ".join(rule.words for rule in self.rules)] if self.rules else []
        lines += [""]
        for key in self.keys:
            if isinstance(key.kind, TableKeys):
                lines += key.kind.reference(key.listed, key.inline)
        return lines


def json_schema(keys: TableKeys, name: str, title: str, description: str) -> Schema:
    """Return the JSON Schema of a file; `name` is its identifier, a URI."""
    head = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": name,
        "title": title,
        "description": description,
    }
    return {**head, **keys.schema()}


def _row(key: Key) -> str:
    default = "**required**" if key.required else key.fallback
    if isinstance(key.kind, TableKeys):
        value = "list of tables" if key.listed else "table"
    else:
        value = f"{key.kind.words} {key.kind.range}".strip()
    cells = (f"`{key.name}`", value, key.unit.name, default, key.meaning)
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"
