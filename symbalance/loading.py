"""Lazy imports: a package's public names are imported when they are first used.

A package lists its names once, in the stub `__init__.pyi` beside its `__init__.py`, a line each:

    from symbalance.engine.builders import inline as inline

Type checkers read the stub; `attach` reads the same lines when the package is imported.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

_LINE = re.compile(r"^from ([\w.]+) import (\w+) as (\w+)$", re.MULTILINE)


def attach(package: str, file: str) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """Return `__getattr__`, `__dir__` and `__all__` of a package, from the stub beside its `file`.

    A line that imports from the package itself names a room of it, which is loaded too but is not in
    `__all__`: `from symbalance import *` brings names, not rooms.
    """
    stub = Path(file).with_suffix(".pyi").read_text(encoding="utf-8")
    homes = {name: home for home, name, again in _LINE.findall(stub) if name == again}

    def get(name: str) -> Any:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        if homes[name] == package:
            return import_module(f"{package}.{name}")
        value = getattr(import_module(homes[name]), name)
        vars(import_module(package))[name] = value
        return value

    def names() -> list[str]:
        # Not what the package's own lines import: Tab shows what one can do, and nothing else.
        return sorted({*homes, *(name for name in vars(import_module(package)) if name.startswith("__"))})

    return get, names, sorted(name for name, home in homes.items() if home != package)
