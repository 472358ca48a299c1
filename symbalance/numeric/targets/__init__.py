"""Plans as source text, one module a target language."""

from __future__ import annotations

from symbalance.numeric.plans import Plan
from symbalance.numeric.targets.c import c_sources
from symbalance.numeric.targets.python import numba_source, numpy_source

IN_MEMORY = ("numpy", "numba")
FILES = {"numpy": ".py", "numba": ".py", "c": ".c"}
"""Targets, and how the file that `emit` is told to write must end."""


def files(planned: Plan, target: str, engine: str, name: str, grid: bool = True) -> dict[str, str]:
    """Return a target's source files by their endings; `name` is what its functions are called.

    `grid` adds the function for evenly spaced angles.
    """
    if target == "c":
        return c_sources(planned, engine, name, grid)
    return {".py": {"numpy": numpy_source, "numba": numba_source}[target](planned, engine, grid)}
