"""Tables as TOML text, one key a line, with the line that each key was written on."""

from __future__ import annotations

import json
from datetime import date
from typing import Any

Path = tuple[str | int, ...]


def written(table: dict[str, Any]) -> tuple[str, dict[Path, int]]:
    """Return the text of a table and the line of each key and of each table with a head."""
    lines: list[str] = []
    places: dict[Path, int] = {}
    _write(table, (), "", lines, places)
    return "\n".join(lines) + "\n", places


def _write(
    table: dict[str, Any], path: Path, name: str, lines: list[str], places: dict[Path, int]
) -> None:
    plain = {k: v for k, v in table.items() if not _is_headed(v)}
    for key, value in plain.items():
        lines.append(f"{_key(key)} = {text_of(value)}")
        places[(*path, key)] = len(lines)
    for key, value in table.items():
        if key in plain:
            continue
        head = f"{name}.{_key(key)}" if name else _key(key)
        rows = value if isinstance(value, list) else [value]
        for i, row in enumerate(rows):
            lines.append(f"[[{head}]]" if isinstance(value, list) else f"[{head}]")
            places.setdefault((*path, key), len(lines))
            inside = (*path, key, i) if isinstance(value, list) else (*path, key)
            places[inside] = len(lines)
            _write(row, inside, head, lines, places)


def _is_headed(value: Any) -> bool:
    rows = value if isinstance(value, list) else [value]
    return bool(rows) and all(isinstance(row, dict) and not row.get("inline") for row in rows)


def _key(key: str) -> str:
    return key if key.isascii() and key.replace("_", "").replace("-", "").isalnum() else json.dumps(key)


def text_of(value: Any) -> str:
    """Return a value as TOML."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, list):
        return f"[{', '.join(map(text_of, value))}]"
    if isinstance(value, dict):
        rows = (f"{_key(k)} = {text_of(v)}" for k, v in value.items() if k != "inline")
        return f"{{ {', '.join(rows)} }}"
    return value.isoformat() if isinstance(value, date) else str(value)
