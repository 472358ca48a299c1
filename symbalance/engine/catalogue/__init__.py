"""The preset engines: one engine file each, with its source; add an engine by adding a file."""

from __future__ import annotations

import re
from difflib import get_close_matches
from functools import cache
from pathlib import Path

from symbalance.engine.catalogue.preset_list import Preset as Preset
from symbalance.engine.catalogue.preset_list import Presets as Presets
from symbalance.engine.catalogue.preset_list import preset_from
from symbalance.engine.engine import Engine
from symbalance.engine.engine_file import parse_engine, read_engine_file
from symbalance.errors import SymbalanceError, brief
from symbalance.text.files import STANDARD_INPUT, toml_table

_FOLDER = Path(__file__).parent


def _natural(name: str) -> list[int | str]:
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


@cache
def preset_names() -> tuple[str, ...]:
    """Return the names of all presets, in natural order."""
    return tuple(sorted((path.stem for path in _FOLDER.glob("*.toml")), key=_natural))


def presets() -> Presets:
    """Return every preset: what it is, its sizes, where its figures come from.

    >>> presets()[0].name
    'audi-ea855'
    """
    tables = ((name, toml_table(preset_text(name), name)) for name in preset_names())
    return Presets(tuple(preset_from(name, table) for name, table in tables))


def preset_text(name: str) -> str:
    """Return a preset's engine file."""
    if name not in preset_names():
        raise _unknown(name)
    return (_FOLDER / f"{name}.toml").read_text(encoding="utf-8")


def _unknown(name: str) -> SymbalanceError:
    near = get_close_matches(name, preset_names(), 3, 0.4)
    hint = f"did you mean {', '.join(near)}?" if near else "list them with: symbalance engines"
    return SymbalanceError(f"engine {brief(name)!r}", "is no preset and no .toml file", hint)


def load(engine: str | Path) -> Engine:
    """Return the engine of a file (a name ending in .toml or with a path separator), or a preset.

    `-` reads an engine file from standard input.

    >>> load("v12-60").firing_order()
    [1, 2, 9, 10, 5, 6, 11, 12, 3, 4, 7, 8]
    """
    name = str(engine)
    if isinstance(engine, Path) or name == STANDARD_INPUT or is_engine_file(name):
        return read_engine_file(engine)
    return parse_engine(preset_text(name), f"{name}.toml")


def is_engine_file(name: str) -> bool:
    """Tell whether a name is that of an engine file, not of a preset.

    >>> is_engine_file("v6.toml"), is_engine_file("my/v6"), is_engine_file("v6-60")
    (True, True, False)
    """
    return name.endswith(".toml") or "/" in name or "\\" in name
