"""The API, a page for each room: its docstring and every public name, with signature and docstring.

A room is a package of the library, with the rooms within it, such as `crankshaft.rotor`. Its public names
are those of its `__all__` and those that the top of the package takes from it. A name is documented
once, under the shortest name it has, in the room that defines it, or else in the first that exports it.
"""

from __future__ import annotations

import inspect
import tomllib
from collections import Counter
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from extensions.docstrings import all_entries, first_sentence, rest, role_text
from extensions.formulas import mathml

PACKAGE = "symbalance"


class Entry(NamedTuple):
    """A public name: where it is documented as what, and what it is."""

    name: str
    kind: str
    value: Any

    @property
    def short(self) -> str:
        """The name without its package."""
        return self.name.split(".")[-1]


def pages(root: Path) -> dict[str, bytes]:
    """Return a page for each room and the page that lists them."""
    entries = {room: _entries(room) for room in _rooms(root)}
    entries = {room: names for room, names in entries.items() if names}
    _check_that_all_are_there({entry.name for names in entries.values() for entry in names})
    contents = {f"{room}.rst": _room_page(room, names) for room, names in entries.items()}
    contents |= {"index.rst": _index(entries), "formulas.rst": _formulas_page()}
    return {name: text.encode() for name, text in contents.items()}


def _check_that_all_are_there(names: set[str]) -> None:
    """Fail the build if a name of the package's top has no place on any page."""
    shorts = {name.rsplit(".", 1)[-1] for name in names}
    public = {name for module in _public_modules() for name in module.__all__} - {"__version__"}
    missing = sorted(public - shorts)
    if missing:
        raise RuntimeError(f"public names without a page: {', '.join(missing)}")


def _public_modules() -> list[ModuleType]:
    """Return the package and every package within it that lists its names in a stub."""
    root = Path(import_module(PACKAGE).__file__ or "").parent
    stubs = sorted(root.rglob("__init__.pyi"), key=lambda stub: (len(stub.parts), stub))
    folders = (stub.parent.relative_to(root.parent) for stub in stubs)
    return [import_module(".".join(folder.parts)) for folder in folders]


def _rooms(root: Path) -> list[str]:
    """Return the library's packages and modules from the ground up, as the contract's layers have it."""
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))
    layers = project["tool"]["importlinter"]["contracts"][0]["layers"]
    rooms = [room.strip() for layer in reversed(layers) for room in layer.split("|")]
    return [room for room in rooms if room != "__main__"]


def _entries(room: str) -> list[Entry]:
    """Return the public names that a room defines: functions and classes first, each group by name."""
    home = f"{PACKAGE}.{room}"
    top, module = import_module(PACKAGE), import_module(home)
    values = {name: getattr(module, name) for name in getattr(module, "__all__", [])}
    deeper = {m.__name__: m for m in _public_modules() if m.__name__.startswith(home + ".")}
    on_top = {name: getattr(top, name) for name in top.__all__}
    names: dict[int, Entry] = {}
    for name, value in {**values, **on_top}.items():
        owner = value.__module__ if callable(value) else home if name in values else ""
        if isinstance(value, ModuleType) or not (owner + ".").startswith(home + "."):
            continue
        full = f"{PACKAGE}.{name}" if on_top.get(name) is value else f"{home}.{name}"
        names[id(value)] = Entry(full, _kind(value), value)
    for inner in deeper.values():
        for name in inner.__all__:
            value = getattr(inner, name)
            if name not in {entry.short for entry in names.values()}:
                names[id(value)] = Entry(f"{inner.__name__}.{name}", _kind(value), value)
    return sorted(names.values(), key=lambda entry: (entry.kind != "function", entry.short.lower()))


def _kind(value: Any) -> str:
    if inspect.isclass(value):
        return "exception" if issubclass(value, BaseException) else "class"
    return "function" if callable(value) else "data"


def _title(text: str, line: str) -> str:
    return f"{text}\n{line * len(text)}\n\n"


def _room_page(room: str, entries: list[Entry]) -> str:
    module = import_module(f"{PACKAGE}.{room}")
    page = f".. _room-{room}:\n\n" + _title(room, "=") + rest(module.__doc__ or "", module.__name__)
    page += f".. currentmodule:: {PACKAGE}.{room}\n\n" + _table(entries)
    for entry in entries:
        page += _title(entry.short, "-") + f".. auto{entry.kind}:: {entry.name}\n"
        if entry.kind in ("class", "exception"):
            page += "   :members:\n"
        page += "\n"
    return page + _theory(room, entries)


def _theory(room: str, entries: list[Entry]) -> str:
    """Return the docstrings of the modules that define a room's names, packages before their modules."""
    home = f"{PACKAGE}.{room}."
    owners = {getattr(entry.value, "__module__", "") for entry in entries}
    paths = {
        ".".join(owner.split(".")[:depth])
        for owner in owners
        if owner.startswith(home)
        for depth in range(3, owner.count(".") + 2)
    }
    sections = ""
    for path in sorted(paths):
        sections += _title(path.removeprefix(home), "~") + rest(import_module(path).__doc__ or "", path)
    return _title("How it is computed", "-") + sections if sections else ""


def _table(entries: list[Entry]) -> str:
    rows = "".join(
        f"   * - {_role(entry)}\n     - {first_sentence(_words(entry))}\n" for entry in entries
    )
    return f".. list-table::\n   :widths: 30 70\n   :class: names\n\n{rows}\n"


def _words(entry: Entry) -> str:
    return "" if entry.kind == "data" else inspect.getdoc(entry.value) or ""


def _role(entry: Entry) -> str:
    role = {"function": "func", "class": "class", "exception": "exc"}.get(entry.kind, "data")
    return f":py:{role}:`~{entry.name}`"


def _formulas_page() -> str:
    """Return the page of all formulas of docstrings that are read, with what is proved of each."""
    survey = all_entries()
    counts = Counter(entry.status for entry in survey)
    ordered = sorted(counts.items(), key=lambda item: (item[0] == "unread", -item[1]))
    page = _title("Formulas and proofs", "=")
    page += "Equations of the docstrings, each judged by this library's own checker: "
    page += ", ".join(f"{count} {status}" for status, count in ordered) + ".\n\n"
    readable = [entry for entry in survey if entry.latex and mathml(entry.latex)]
    cells = (
        (
            f"``{entry.name.removeprefix(PACKAGE + '.')}``",
            f":math:`{role_text(entry.latex)}`",
            entry.status,
        )
        for entry in readable
    )
    rows = "".join(
        f"   * - {name}\n     - {formula}\n     - {status}\n" for name, formula, status in cells
    )
    return f"{page}.. list-table::\n   :class: formulas\n\n{rows}"


def _index(entries: dict[str, list[Entry]]) -> str:
    page = _title("API", "=")
    page += "What ``import symbalance as sb`` offers, and the rooms that hold it, from the top down.\n\n"
    for room, names in reversed(entries.items()):
        module = import_module(f"{PACKAGE}.{room}")
        page += f":doc:`{room}`\n   {first_sentence(module.__doc__ or '')}\n\n"
        on_top = [entry for entry in names if entry.name.count(".") == 1]
        for name in sorted(on_top, key=lambda entry: entry.name.lower()):
            page += f"   {_role(name)}\n"
        page += "\n" if on_top else ""
    toctree = "\n".join(f"   {name}" for name in [*reversed(entries), "formulas"])
    return page + f".. toctree::\n   :hidden:\n\n{toctree}\n"
